//! Tables of the block on its mounts.

use crate::kit::number;
use crate::kit::rounding::among;
use crate::kit::table::{Cell, Column, Table, column_cells, numbers, words};
use lanchester_mechanism::RotorEffects;
use lanchester_mechanism::{
    COORDINATES, DampedMode, MountMode, MountStudy, OrderResponse, SpeedResponse, vector_amplitude,
};
use num_complex::Complex64;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// Most rows of a table against speed.
const ROWS: usize = 13;

/// Mass, centre and inertia of what moves, in a sentence.
pub fn mounted_body_words(study: &MountStudy) -> String {
    let body = &study.body;
    let [x, y, z] = body.centre.map(|c| number::short(1e3 * c, 4));
    let inertia = |i: usize, j: usize| number::short(body.inertia[i][j], 4);
    let added = match body.added_mass > 0.0 {
        true => format!(" ({} kg of pistons and rods added)", number::short(body.added_mass, 4)),
        false => String::new(),
    };
    let acts = match study.rotor_effects {
        RotorEffects { couple: true, roll: true } => {
            "the gyroscopic couple is counted, and that roll does not turn it"
        }
        RotorEffects { couple: true, roll: false } => {
            "the gyroscopic couple is counted; as if it were held fast in the block, roll turns it"
        }
        RotorEffects { couple: false, roll: true } => {
            "that roll does not turn it is counted, the gyroscopic couple left out"
        }
        RotorEffects { couple: false, roll: false } => {
            "it is taken as held fast in the block, without gyroscopic couple"
        }
    };
    let rotors = match study.rotors == 0.0 {
        true => String::new(),
        false => {
            let inertia = number::short(study.rotors, 4);
            format!(" What turns in it has {inertia} kg m² for its spin: {acts}.")
        }
    };
    format!(
        "The block: {} kg{added}, centre at x = {x}, y = {y}, z = {z} mm, moments of inertia {}, {} and {} kg m² about x, y and z.{rotors}",
        number::short(body.mass, 4),
        inertia(0, 0),
        inertia(1, 1),
        inertia(2, 2)
    )
}

/// Torque-roll axis and centre of stiffness, in a sentence each.
pub fn mount_axes_words(study: &MountStudy) -> String {
    let modes = &study.modes;
    let [a, b, c] = modes.torque_roll_axis.direction.map(|d| number::fixed(d, 3));
    let lean = modes.torque_roll_axis.direction[2].clamp(-1.0, 1.0).acos().to_degrees();
    let centre = &modes.stiffness_centre;
    let [x, y, z] = centre.point.map(|p| number::short(1e3 * p, 4));
    let stiffness: Vec<String> = centre.stiffness.iter().map(|k| number::short(1e-3 * k, 4)).collect();
    let coupling = number::short(100.0 * centre.coupling, 2);
    format!(
        "Torque-roll axis: through the centre along ({a}, {b}, {c}), {} deg from the crank. Centre of stiffness at \
         x = {x}, y = {y}, z = {z} mm: {} N/mm along its principal directions, residual coupling {coupling} %.",
        number::fixed(lean, 1),
        stiffness.join(", ")
    )
}

/// Deflections and forces at rest.
pub fn mounts_at_rest_table(study: &MountStudy) -> Table {
    let mounts = &study.at_rest.mounts;
    let mut columns = vec![words("mount", mounts.iter().map(|m| m.name.clone()))];
    for (j, name) in ["x", "y", "z"].into_iter().enumerate() {
        columns.push(numbers(
            &format!("deflection {name}"),
            "mm",
            mounts.iter().map(|m| 1e3 * m.deflection[j]),
            4,
        ));
    }
    for (j, name) in ["F_x", "F_y", "F_z"].into_iter().enumerate() {
        columns.push(numbers(name, "N", mounts.iter().map(|m| m.force[j]), 5));
    }
    let size = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    columns.push(numbers("due to weight", "N", mounts.iter().map(|m| size(m.gravity)), 5));
    columns.push(numbers("due to torque", "N", mounts.iter().map(|m| size(m.torque)), 5));
    Table::of_columns(
        "mounts-at-rest",
        "Mounts at rest",
        "Under gravity, the mean torque of the driveline and preload: the deflection of each mount, the force of the block on \
         it, and the size of its shares due to weight and torque.",
        columns,
    )
}

/// Frequencies, energy shares and coupling of the six modes.
pub fn mount_modes_table(study: &MountStudy) -> Table {
    let modes = &study.modes.modes;
    let mut columns = vec![
        words("mode", (1..=modes.len()).map(|k| k.to_string())),
        numbers("frequency", "Hz", modes.iter().map(|m| m.angular_frequency / TAU), 4),
    ];
    let share = |c: usize| modes.iter().map(|m: &MountMode| 100.0 * m.energy[c]).map(one_decimal).collect();
    for (c, name) in ["x", "y", "z", "about x", "about y", "about z"].into_iter().enumerate() {
        columns.push((Column::numbers(name, "%"), share(c)));
    }
    columns.push((
        Column::numbers("coupling", "%"),
        modes.iter().map(|m| one_decimal(100.0 * m.coupling)).collect(),
    ));
    columns.push(words("mostly", modes.iter().map(|m| COORDINATES[m.main].to_owned())));
    Table::of_columns(
        "mount-modes-table",
        "Modes of the block on its mounts",
        "Undamped natural frequencies and the shares of their kinetic energy at the centre of mass; coupling is what is not in \
         the largest share.",
        columns,
    )
}

fn one_decimal(value: f64) -> Cell {
    Cell::Number { value, decimals: 1 }
}

/// Frequencies and damping ratios of the damped modes.
pub fn damped_modes_table(study: &MountStudy) -> Table {
    let modes = &study.modes.damped;
    Table::of_columns(
        "mount-damping",
        "Damped modes",
        "Frequency of the decaying motion and its damping ratio; 0 Hz where it does not oscillate.",
        vec![
            words("mode", (1..=modes.len()).map(|k| k.to_string())),
            numbers("frequency", "Hz", modes.iter().map(|m: &DampedMode| m.root.im.max(0.0) / TAU), 4),
            numbers("damping ratio", "%", modes.iter().map(|m| 100.0 * m.damping_ratio), 3),
        ],
    )
}

/// Forces at the mounts by order, at the lowest speed and at the highest.
pub fn mount_orders_tables(study: &MountStudy) -> Vec<Table> {
    let speeds = || study.response.speeds.iter().enumerate();
    let by_speed = |a: &(usize, &SpeedResponse), b: &(usize, &SpeedResponse)| a.1.speed.total_cmp(&b.1.speed);
    let (Some(slow), Some(fast)) = (speeds().min_by(by_speed), speeds().max_by(by_speed)) else {
        return Vec::new();
    };
    let mut tables = Vec::new();
    if slow.1.speed < fast.1.speed {
        tables.push(orders_table(study, "mount-orders-slow", slow));
    }
    tables.push(orders_table(study, "mount-orders", fast));
    tables.push(stiff_orders_table(study, fast.1));
    tables
}

fn orders_table(study: &MountStudy, id: &'static str, (place, at): (usize, &SpeedResponse)) -> Table {
    let (gone, mut columns) = order_columns(study, at, |order| &order.forces);
    for (number, motion) in study.points.iter().enumerate() {
        let values = motion.displacement[place].iter().map(|d| 1e3 * vector_amplitude(d));
        columns.push(numbers(&format!("point {}", number + 1), "mm", values, 4));
    }
    let ratio = |value: Option<f64>| value.map_or(Cell::Empty, |v| Cell::number(v, 3));
    let cells = at.orders.iter().map(|o| ratio(o.force_transmissibility())).collect();
    columns.push((Column::numbers("force transmissibility", ""), cells));
    let cells = at.orders.iter().map(|o| ratio(o.moment_transmissibility())).collect();
    columns.push((Column::numbers("moment transmissibility", ""), cells));
    let title = format!("Forces at the mounts by order at {} rpm", rpm(at));
    let note = "Amplitude of the force at each mount (major half axis of its ellipse); what all mounts together pass on over \
                what excites the block. More than all of a force is passed on also where a moment is what excites.";
    let remark = vanishing(at, &gone);
    Table::of_columns(id, title, note, columns).without(&gone, remark)
}

fn stiff_orders_table(study: &MountStudy, at: &SpeedResponse) -> Table {
    let (gone, columns) = order_columns(study, at, |order| &order.stiff_forces);
    let title = format!("Stiff mounts: forces by order at {} rpm", rpm(at));
    let note = "What the same mounts would carry if they were stiff, in the proportions of their static stiffness: the loads \
                shared as at rest.";
    let remark = vanishing(at, &gone);
    Table::of_columns("mount-stiff-orders", title, note, columns).without(&gone, remark)
}

/// Order, frequency and the amplitude at each mount, with the places of the orders that vanish at all of them.
fn order_columns(
    study: &MountStudy,
    at: &SpeedResponse,
    forces: impl Fn(&OrderResponse) -> &Vec<[Complex64; 3]>,
) -> (Vec<usize>, Vec<(Column, Vec<Cell>)>) {
    let sizes: Vec<Vec<f64>> =
        at.orders.iter().map(|o| forces(o).iter().map(vector_amplitude).collect()).collect();
    let noise = among(sizes.iter().flatten().copied());
    let gone = (0..sizes.len()).filter(|&k| sizes[k].iter().all(|f| *f <= noise)).collect();
    let mut columns = vec![
        words("order", at.orders.iter().map(|o| number::order(o.order))),
        numbers("frequency", "Hz", at.orders.iter().map(|o| o.order * at.speed / TAU), 4),
    ];
    for (mount, name) in study.response.mounts.iter().enumerate() {
        let cells = column_cells(sizes.iter().map(|f| f[mount]), 5, noise);
        columns.push((Column::numbers(name.clone(), "N"), cells));
    }
    (gone, columns)
}

fn rpm(at: &SpeedResponse) -> String {
    number::fixed(number::rpm(at.speed), 0)
}

/// Which orders vanish, in a sentence.
fn vanishing(at: &SpeedResponse, gone: &[usize]) -> String {
    let names: Vec<String> = gone.iter().map(|&k| number::order(at.orders[k].order)).collect();
    match names.len() {
        0 => String::new(),
        1 => format!("Order {} vanishes.", names[0]),
        _ => format!("Orders {} vanish.", names.join(", ")),
    }
}

/// Largest force at each mount over the cycle against speed: speeds that are equally far apart, and those at which a mount has its largest force of all.
pub fn mount_speeds_table(study: &MountStudy) -> Table {
    let all = &study.response.speeds;
    let last = all.len().saturating_sub(1);
    let rows = all.len().min(ROWS);
    let mut places: BTreeSet<usize> = (0..rows).map(|k| k * last / rows.saturating_sub(1).max(1)).collect();
    for mount in 0..study.response.mounts.len() {
        let peak = |k: &usize| all[*k].peaks[mount].value;
        places.extend((0..all.len()).max_by(|a, b| peak(a).total_cmp(&peak(b))));
    }
    let chosen: Vec<&SpeedResponse> = places.into_iter().map(|k| &all[k]).collect();
    let mut columns = vec![numbers("speed", "rpm", chosen.iter().map(|s| number::rpm(s.speed)), 4)];
    for (mount, name) in study.response.mounts.iter().enumerate() {
        columns.push(numbers(name, "N", chosen.iter().map(|s| s.peaks[mount].value), 5));
    }
    Table::of_columns(
        "mount-speeds",
        "Largest forces at the mounts against speed",
        "All orders together, over the continuous cycle; the largest of each mount over all speeds among them.",
        columns,
    )
}

/// All tables in their order.
pub fn mount_tables(study: &MountStudy) -> Vec<Table> {
    let mut tables = vec![mounts_at_rest_table(study), mount_modes_table(study), damped_modes_table(study)];
    tables.push(mount_speeds_table(study));
    tables.extend(mount_orders_tables(study));
    tables
}
