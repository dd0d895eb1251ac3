//! A simulated run as columns, and as CSV: what a spreadsheet or a table file takes.

use crate::kit::table::{csv_number, push_csv_line};
use crate::simulated::energy::energy_rows;
use crate::simulated::extremes::{ExtremeRow, extreme_rows};
use crate::simulated::orders::order_series;
use crate::simulated::result::{SimulationResult, occasion_words};
use lanchester_multibody::{CylinderReactions, MainRule, RunOutcome, Wrench};

/// A column of numbers with its head, the unit in brackets.
pub type NamedSeries = (String, Vec<f64>);

/// A table of a simulated run: a column of words where its rows have names, then columns of numbers, which may end earlier than others where a run has fewer of them.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulationColumns {
    /// Names of the rows with the head of their column.
    pub names: Option<(String, Vec<String>)>,
    /// Columns of numbers.
    pub numbers: Vec<NamedSeries>,
}

impl SimulationColumns {
    /// Number of whole rows.
    pub fn rows(&self) -> usize {
        let names = self.names.iter().map(|(_, names)| names.len());
        names.chain(self.numbers.iter().map(|(_, values)| values.len())).min().unwrap_or(0)
    }

    /// As CSV.
    pub fn csv(&self) -> String {
        let mut out = String::new();
        let heads = self.names.iter().map(|(head, _)| head.clone());
        push_csv_line(&mut out, heads.chain(self.numbers.iter().map(|(head, _)| head.clone())));
        for k in 0..self.rows() {
            let names = self.names.iter().map(|(_, names)| names[k].clone());
            push_csv_line(
                &mut out,
                names.chain(self.numbers.iter().map(|(_, values)| csv_number(values[k]))),
            );
        }
        out
    }
}

/// Angle, speed, torques, block and mounts at every sample.
pub fn simulation_trace_columns(result: &SimulationResult) -> SimulationColumns {
    SimulationColumns { names: None, numbers: simulation_trace(result) }
}

/// Forces and moments of walls and pins, gears, main bearings by the three rules and shaft torque at every sample; a column `incomplete` of a run that did not come to its end.
pub fn simulation_reactions_columns(result: &SimulationResult) -> SimulationColumns {
    SimulationColumns { names: None, numbers: simulation_reactions(result) }
}

/// Loads, torque, speed and motion of the block by order, real and imaginary parts.
pub fn simulation_orders_columns(result: &SimulationResult) -> SimulationColumns {
    SimulationColumns { names: None, numbers: order_series(result) }
}

/// Largest and smallest values over the whole run with time and angle, and over the last period, in SI units.
pub fn simulation_extremes_columns(result: &SimulationResult) -> SimulationColumns {
    let rows = extreme_rows(result);
    let of = |pick: &dyn Fn(&ExtremeRow) -> f64| rows.iter().map(pick).collect::<Vec<f64>>();
    let names = rows.iter().map(|row| format!("{} [{}]", row.quantity, row.unit)).collect();
    SimulationColumns {
        names: Some(("quantity".into(), names)),
        numbers: vec![
            ("whole run".into(), of(&|row| row.whole.value)),
            ("time [s]".into(), of(&|row| row.whole.time)),
            ("crank angle [deg]".into(), of(&|row| row.whole.theta.to_degrees())),
            ("last period".into(), of(&|row| row.last_period.value)),
        ],
    }
}

/// Works and changes of what is stored, over the run and over its last period; the heat of its cycles; NaN where there is none.
pub fn simulation_energy_columns(result: &SimulationResult) -> SimulationColumns {
    let rows = energy_rows(result);
    let names = rows.iter().map(|row| row.0.to_owned()).collect();
    let numbers = vec![
        ("energy [J]".into(), rows.iter().map(|row| row.1).collect()),
        ("last period [J]".into(), rows.iter().map(|row| row.2).collect()),
    ];
    SimulationColumns { names: Some(("part".into(), names)), numbers }
}

/// Events.
pub fn simulation_events_columns(result: &SimulationResult) -> SimulationColumns {
    let events = &result.run.events;
    let names = events.iter().map(|event| occasion_words(event.what, &result.actions)).collect();
    SimulationColumns {
        names: Some(("event".into(), names)),
        numbers: vec![
            ("time [s]".into(), events.iter().map(|event| event.time).collect()),
            ("crank angle [deg]".into(), events.iter().map(|event| event.theta.to_degrees()).collect()),
            (
                "speed [rpm]".into(),
                events.iter().map(|event| event.speed * 30.0 / std::f64::consts::PI).collect(),
            ),
        ],
    }
}

/// Angle, speed, torques, pose of the block and mount forces at every sample.
fn simulation_trace(result: &SimulationResult) -> Vec<NamedSeries> {
    let result = &*result.written();
    let samples = &result.run.samples;
    let mut columns: Vec<NamedSeries> = vec![
        ("time [s]".into(), samples.time.clone()),
        ("theta [deg]".into(), samples.theta.iter().map(|theta| theta.to_degrees()).collect()),
        ("speed [rad/s]".into(), samples.speed.clone()),
        ("acceleration [rad/s2]".into(), samples.acceleration.clone()),
        ("gas_torque [N m]".into(), samples.gas_torque.clone()),
        ("load_torque [N m]".into(), samples.load_torque.clone()),
        ("starter_torque [N m]".into(), samples.starter_torque.clone()),
        ("friction_torque [N m]".into(), samples.friction_torque.clone()),
        ("outside_torque [N m]".into(), samples.outside_torque.clone()),
        ("piston_friction_torque [N m]".into(), samples.piston_friction_torque.clone()),
    ];
    let links = samples.driveline.first().map_or(0, Vec::len);
    if links > 0 {
        columns.push(("driveline_torque [N m]".into(), samples.driveline_torque.clone()));
    }
    for link in 0..links {
        let spring = |k: usize| samples.driveline_springs.iter().map(|all| all[link][k]).collect();
        let name = format!("driveline {}", link + 1);
        columns.push((format!("{name} twist [rad]"), spring(0)));
        columns.push((format!("{name} torque [N m]"), spring(1)));
        let speed = samples.driveline.iter().map(|all| all[link][1]).collect();
        columns.push((format!("{name} speed [rad/s]"), speed));
    }
    for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
        if !samples.position.is_empty() {
            columns.push((format!("position_{axis} [m]"), samples.position.iter().map(|p| p[k]).collect()));
        }
    }
    for (k, part) in ["w", "x", "y", "z"].into_iter().enumerate() {
        if !samples.orientation.is_empty() {
            columns.push((format!("quaternion_{part}"), samples.orientation.iter().map(|q| q[k]).collect()));
        }
    }
    if !samples.governor.is_empty() {
        columns.push(("governor".into(), samples.governor.clone()));
    }
    for point in &result.points {
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            if !point.displacement.is_empty() {
                let values = point.displacement.iter().map(|at| at[k]).collect();
                columns.push((format!("{} displacement_{axis} [m]", point.name), values));
            }
        }
    }
    for (mount, name) in result.mounts.iter().enumerate() {
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let forces = samples.mounts.iter().filter_map(|at| at.get(mount)).map(|force| force[k]).collect();
            columns.push((format!("{name} force_{axis} [N]"), forces));
        }
    }
    columns.extend(incomplete(result, samples.time.len()));
    columns
}

/// A joint of a cylinder and what acts in it.
type Joint = (&'static str, fn(&CylinderReactions) -> &Wrench);

/// Joints of a cylinder, from the wall inwards.
const JOINTS: [Joint; 3] =
    [("wall", |own| &own.wall), ("piston_pin", |own| &own.piston_pin), ("lower_pin", |own| &own.lower_pin)];

/// The column that marks a run which did not come to its end: a table of it looks like that of another.
fn incomplete(result: &SimulationResult, rows: usize) -> Option<NamedSeries> {
    let ended =
        matches!(result.run.outcome, RunOutcome::Complete | RunOutcome::Stopped | RunOutcome::AtRest { .. });
    (!ended).then(|| ("incomplete".into(), vec![1.0; rows]))
}

/// Walls, pins, mains by the three rules and shaft torque at every sample.
fn simulation_reactions(result: &SimulationResult) -> Vec<NamedSeries> {
    let result = &*result.written();
    let samples = &result.run.samples;
    let degrees = samples.theta.iter().map(|theta| theta.to_degrees()).collect();
    let mut columns: Vec<NamedSeries> = vec![("theta [deg]".into(), degrees)];
    let reactions = &samples.reactions;
    let cylinders = reactions.first().map_or(0, |first| first.cylinders.len());
    for index in 0..cylinders {
        let of = |pick: &dyn Fn(&CylinderReactions) -> f64| -> Vec<f64> {
            reactions.iter().map(|r| pick(&r.cylinders[index])).collect()
        };
        let name = format!("cylinder {}", index + 1);
        columns.push((format!("{name} side_thrust [N]"), of(&|c| c.side_thrust)));
        for (joint, wrench) in JOINTS {
            for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
                columns.push((format!("{name} {joint}_{axis} [N]"), of(&|c| wrench(c).force[k])));
            }
            for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
                columns.push((format!("{name} {joint}_moment_{axis} [N m]"), of(&|c| wrench(c).moment[k])));
            }
        }
        for (k, unit) in ["position [m]", "speed [m/s]", "acceleration [m/s2]"].into_iter().enumerate() {
            columns.push((format!("{name} piston_{unit}"), of(&|c| c.travel[k])));
        }
        columns.push((format!("{name} radial [N]"), of(&|c| c.throw_frame[0])));
        columns.push((format!("{name} tangential [N]"), of(&|c| c.throw_frame[1])));
    }
    for (shaft, planes) in result.mains.iter().enumerate() {
        for main in 0..planes.len() {
            for (rule, name) in MainRule::ALL.into_iter().enumerate().map(|(k, rule)| (k, rule.name())) {
                for (k, axis) in ["x", "y"].into_iter().enumerate() {
                    let loads = reactions
                        .iter()
                        .map(|r| r.rotors[shaft].mains[rule].get(main).map_or(f64::NAN, |f| f[k]));
                    columns.push((
                        format!("main {}.{} {name}_{axis} [N]", shaft + 1, main + 1),
                        loads.collect(),
                    ));
                }
            }
        }
    }
    for (index, name) in result.gears.iter().enumerate() {
        let of = |pick: &dyn Fn(&lanchester_multibody::RotorReactions) -> f64| -> Vec<f64> {
            reactions.iter().map(|r| r.rotors.get(index + 1).map_or(f64::NAN, pick)).collect()
        };
        columns.push((format!("{name} gear_torque [N m]"), of(&|rotor| rotor.gear_torque)));
        for (k, axis) in ["x", "y"].into_iter().enumerate() {
            columns.push((format!("{name} gear_force_{axis} [N]"), of(&|rotor| rotor.gear_force[k])));
            columns.push((format!("{name} bearings_{axis} [N]"), of(&|rotor| rotor.bearings.force[k])));
        }
    }
    columns.push(("shaft_torque [N m]".into(), reactions.iter().map(|r| r.shaft_torque).collect()));
    columns.extend(incomplete(result, reactions.len()));
    columns
}
