//! Orders and traces as CSV, unrounded, in SI units and degrees.

use crate::kit::number::phase_degrees;
use crate::kit::table::{csv_number, push_csv_line};
use crate::loads::component::Component;
use lanchester_mechanism::Loads;
use lanchester_results::LoadSet;
use num_complex::Complex64;

/// The whole, the parts and the cylinders under the names they have in CSV.
fn sets(loads: &Loads) -> Vec<(String, &LoadSet)> {
    let mut sets = vec![("total".to_owned(), &loads.total)];
    sets.extend(loads.parts.iter().map(|p| (p.part.name().to_owned(), &p.loads)));
    sets.extend(loads.cylinders.iter().map(|c| (format!("cylinder {}", c.cylinder), &c.loads)));
    sets
}

/// Every order of the whole, of every part and of every cylinder: amplitudes and phases.
pub fn orders_csv(loads: &Loads) -> String {
    let sets = sets(loads);
    let mut out = String::with_capacity(200 * (1 + sets.iter().map(|s| s.1.orders.len()).sum::<usize>()));
    let mut head = vec!["of".to_owned(), "order".to_owned()];
    for (name, unit) in [
        ("force_forward", "N"),
        ("force_backward", "N"),
        ("couple_forward", "N m"),
        ("couple_backward", "N m"),
        ("roll_moment", "N m"),
        ("shaft_torque", "N m"),
    ] {
        head.push(format!("{name} [{unit}]"));
        head.push(format!("{name}_phase [deg]"));
    }
    push_csv_line(&mut out, head);
    for (name, set) in sets {
        for order in &set.orders {
            let mut line = vec![name.clone(), csv_number(order.order)];
            let values: [Complex64; 6] = [
                order.force_forward,
                order.force_backward,
                order.couple_forward,
                order.couple_backward,
                order.roll_moment,
                order.shaft_torque,
            ];
            for value in values {
                line.push(csv_number(value.norm()));
                line.push(csv_number(phase_degrees(value.arg())));
            }
            push_csv_line(&mut out, line);
        }
    }
    out
}

/// Position, velocity and acceleration of every piston and the angle of its rod over the crank angle.
pub fn motion_csv(loads: &Loads) -> String {
    let Some(first) = loads.motion.first() else { return String::new() };
    let mut out = String::with_capacity(20 * (first.trace.theta.len() + 1) * (1 + 4 * loads.motion.len()));
    let mut head = vec!["theta [deg]".to_owned()];
    for motion in &loads.motion {
        for column in ["position [m]", "velocity [m/s]", "acceleration [m/s2]", "rod_angle [deg]"] {
            head.push(format!("cylinder {} {column}", motion.cylinder));
        }
    }
    push_csv_line(&mut out, head);
    for (k, theta) in first.trace.theta.iter().enumerate() {
        let values = loads.motion.iter().flat_map(|motion| {
            let trace = &motion.trace;
            [trace.position[k], trace.velocity[k], trace.acceleration[k], trace.rod_angle[k].to_degrees()]
        });
        push_csv_line(&mut out, std::iter::once(theta.to_degrees()).chain(values).map(csv_number));
    }
    out
}

/// Every component of the whole, of every part and of every cylinder over the crank angle.
pub fn trace_csv(loads: &Loads) -> String {
    let sets = sets(loads);
    let theta = &loads.total.trace.theta;
    let mut out = String::with_capacity(20 * (theta.len() + 1) * (1 + 6 * sets.len()));
    let mut head = vec!["theta [deg]".to_owned()];
    for (name, _) in &sets {
        for component in Component::ALL {
            let column = component.id().replace('-', "_");
            head.push(format!("{name} {column} [{}]", component.unit()));
        }
    }
    push_csv_line(&mut out, head);
    for (k, theta) in theta.iter().enumerate() {
        let values = sets.iter().flat_map(|(_, set)| {
            Component::ALL
                .into_iter()
                .map(move |c| c.trace(&set.trace).get(k).copied().map_or(String::new(), csv_number))
        });
        push_csv_line(&mut out, std::iter::once(csv_number(theta.to_degrees())).chain(values));
    }
    out
}
