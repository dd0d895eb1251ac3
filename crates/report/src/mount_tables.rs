//! Tables of the block on its mounts.

use crate::number;
use crate::table::{Cell, Column, Table, column_cells, numbers, words};
use lanchester_mechanism::{COORDINATES, DampedMode, MountMode, MountStudy, SpeedResponse, vector_amplitude};
use std::f64::consts::TAU;

/// Most rows of a table against speed.
const ROWS: usize = 13;

/// What is below this share of the largest force is left out.
const VANISHING: f64 = 1e-9;

/// Mass, centre and inertia of what moves, in a sentence.
pub fn mounted_body_words(study: &MountStudy) -> String {
    let body = &study.body;
    let [x, y, z] = body.centre.map(|c| number::short(1e3 * c, 4));
    let inertia = |i: usize, j: usize| number::short(body.inertia[i][j], 4);
    let added = match body.added_mass > 0.0 {
        true => format!(" ({} kg of pistons and rods added)", number::short(body.added_mass, 4)),
        false => String::new(),
    };
    format!(
        "The block: {} kg{added}, centre at x = {x}, y = {y}, z = {z} mm, moments of inertia {}, {} and {} kg m² about x, y and z.",
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
         x = {x}, y = {y}, z = {z} mm: {} N/mm along its principal directions, coupling left {coupling} %.",
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
            &format!("yields {name}"),
            "mm",
            mounts.iter().map(|m| 1e3 * m.deflection[j]),
            4,
        ));
    }
    for (j, name) in ["F_x", "F_y", "F_z"].into_iter().enumerate() {
        columns.push(numbers(name, "N", mounts.iter().map(|m| m.force[j]), 5));
    }
    let size = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    columns.push(numbers("of weight", "N", mounts.iter().map(|m| size(m.gravity)), 5));
    columns.push(numbers("of torque", "N", mounts.iter().map(|m| size(m.torque)), 5));
    Table::of_columns(
        "mounts-at-rest",
        "Mounts at rest",
        "Under gravity, the mean torque of the driveline and preload: how far each mount yields, the force of the block on \
         it, and the size of its shares of weight and torque.",
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
        "mount-modes",
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

/// The response at the highest speed.
pub(crate) fn fastest(study: &MountStudy) -> Option<(usize, &SpeedResponse)> {
    let speeds = study.response.speeds.iter().enumerate();
    speeds.max_by(|a, b| a.1.speed.total_cmp(&b.1.speed))
}

/// Forces at the mounts by order, at the highest speed.
pub fn mount_orders_table(study: &MountStudy) -> Option<Table> {
    let (place, at) = fastest(study)?;
    let largest = at.peaks.iter().map(|p| p.value).fold(0.0, f64::max);
    let sizes: Vec<Vec<f64>> =
        at.orders.iter().map(|o| o.forces.iter().map(vector_amplitude).collect()).collect();
    let gone: Vec<usize> =
        (0..sizes.len()).filter(|&k| sizes[k].iter().all(|f| *f <= VANISHING * largest)).collect();
    let mut columns = vec![
        words("order", at.orders.iter().map(|o| number::order(o.order))),
        numbers("frequency", "Hz", at.orders.iter().map(|o| o.order * at.speed / TAU), 4),
    ];
    for (mount, name) in study.response.mounts.iter().enumerate() {
        let noise = VANISHING * largest;
        let cells = column_cells(sizes.iter().map(|f| f[mount]), 5, noise);
        columns.push((Column::numbers(name.clone(), "N"), cells));
    }
    for (number, motion) in study.points.iter().enumerate() {
        let values = motion.displacement[place].iter().map(|d| 1e3 * vector_amplitude(d));
        columns.push(numbers(&format!("point {}", number + 1), "mm", values, 4));
    }
    let ratio = |value: Option<f64>| value.map_or(Cell::Empty, |v| Cell::number(v, 3));
    let cells = at.orders.iter().map(|o| ratio(o.force_transmissibility())).collect();
    columns.push((Column::numbers("passes force", ""), cells));
    let cells = at.orders.iter().map(|o| ratio(o.moment_transmissibility())).collect();
    columns.push((Column::numbers("passes moment", ""), cells));
    let names: Vec<String> = gone.iter().map(|&k| number::order(at.orders[k].order)).collect();
    let remark = match names.len() {
        0 => String::new(),
        1 => format!("Order {} vanishes.", names[0]),
        _ => format!("Orders {} vanish.", names.join(", ")),
    };
    let rpm = number::fixed(at.speed * 60.0 / TAU, 0);
    let title = format!("Forces at the mounts by order at {rpm} rpm");
    let note = "Amplitude of the force at each mount (major half axis of its ellipse); what all mounts together pass on over \
                what excites the block.";
    Some(Table::of_columns("mount-orders", title, note, columns).without(&gone, remark))
}

/// Largest force at each mount over the cycle against speed.
pub fn mount_speeds_table(study: &MountStudy) -> Table {
    let all = &study.response.speeds;
    let last = all.len().saturating_sub(1);
    let rows = all.len().min(ROWS);
    let chosen: Vec<&SpeedResponse> =
        (0..rows).map(|k| &all[k * last / rows.saturating_sub(1).max(1)]).collect();
    let mut columns = vec![numbers("speed", "rpm", chosen.iter().map(|s| s.speed * 60.0 / TAU), 4)];
    for (mount, name) in study.response.mounts.iter().enumerate() {
        columns.push(numbers(name, "N", chosen.iter().map(|s| s.peaks[mount].value), 5));
    }
    Table::of_columns(
        "mount-speeds",
        "Largest forces at the mounts against speed",
        "All orders together, over the continuous cycle.",
        columns,
    )
}

/// All tables in their order.
pub fn mount_tables(study: &MountStudy) -> Vec<Table> {
    let mut tables = vec![mounts_at_rest_table(study), mount_modes_table(study), damped_modes_table(study)];
    tables.push(mount_speeds_table(study));
    tables.extend(mount_orders_table(study));
    tables
}
