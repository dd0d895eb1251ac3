//! Torsional vibration in numbers.

use super::result::{MeshedThrow, TorsionResult};
use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, numbers, words};
use lanchester_torsion::{ChainEnergy, HolzerTable, TuneAim, TuneFree, peak};

const DEGREES: f64 = 180.0 / std::f64::consts::PI;
/// Critical speeds listed.
const LISTED: usize = 16;

fn station(result: &TorsionResult, index: usize) -> String {
    result.crank.chain.stations()[index].name.clone()
}

fn shaft(result: &TorsionResult, index: usize) -> String {
    result.crank.chain.shafts()[index].name.clone()
}

fn known(value: Option<f64>, significant: i32) -> Cell {
    value.map_or(Cell::Empty, |value| Cell::number(value, significant))
}

/// Stations and shafts of the chain.
pub fn chain_table(result: &TorsionResult) -> Table {
    let chain = &result.crank.chain;
    let row = |index: usize| {
        let own = &chain.shafts()[index];
        let stiffness = if own.spin_stiffness > 0.0 { None } else { Some(1e-3 * own.stiffness) };
        vec![
            Cell::text(own.name.clone()),
            known(stiffness, 4),
            known(result.crank.ker_wilson[index].map(|k| 1e-3 * k), 4),
            Cell::number(own.damping, 3),
            Cell::number(own.loss_factor, 3),
            Cell::number(own.ratio, 4),
            known(own.section.map(|section| 1e3 * section.diameter), 4),
            known(own.section.map(|section| 1e3 * section.bore), 3),
        ]
    };
    Table {
        id: "torsion-shafts",
        title: "Shafts of the torsional chain".into(),
        note: "Stiffness between the stations at the shaft's own speed, beside it that of Ker Wilson's lengths; the section in which stress is told is the weakest journal or pin."
            .into(),
        remark: String::new(),
        columns: vec![
            Column::words("shaft"),
            Column::numbers("stiffness", "kN m/rad"),
            Column::numbers("Ker Wilson", "kN m/rad"),
            Column::numbers("damping", "N m s/rad"),
            Column::numbers("loss factor", ""),
            Column::numbers("ratio", ""),
            Column::numbers("diameter", "mm"),
            Column::numbers("bore", "mm"),
        ],
        rows: (0..chain.shafts().len()).map(row).collect(),
    }
}

/// Both stiffnesses of every throw by finite elements.
pub fn meshed_throws_table(result: &TorsionResult) -> Table {
    let throws = &result.meshed;
    let stiffness = |head: &str, of: fn(&MeshedThrow) -> f64| {
        numbers(head, "kN m/rad", throws.iter().map(|own| 1e-3 * of(own)), 4)
    };
    let taken = |own: &MeshedThrow| if own.is_held { "held" } else { "free" }.to_owned();
    Table::of_columns(
        "torsion-throws",
        "Throws by finite elements",
        "Between the middles of the journals of each throw, which may move aside (free) or stay on the axis (held); the chain has the one that is taken, joined with halves of neighbouring throws.",
        vec![
            words("throw", throws.iter().map(|own| own.throw.to_string())),
            stiffness("free", |own| own.free),
            stiffness("held", |own| own.held),
            words("taken", throws.iter().map(taken)),
        ],
    )
}

/// Inertia of every station with its parts.
pub fn torsion_inertia_table(result: &TorsionResult) -> Table {
    let chain = &result.crank.chain;
    let row = |(index, own): (usize, &lanchester_torsion::Station)| {
        let parts = result.crank.throws.iter().position(|at| *at == index);
        let parts = parts.and_then(|throw| result.crank.parts.iter().find(|parts| parts.throw == throw));
        vec![
            Cell::text(own.name.clone()),
            Cell::number(1e6 * own.inertia, 5),
            known(parts.map(|parts| 1e6 * parts.crank), 4),
            known(parts.map(|parts| 1e6 * parts.train), 4),
            known(parts.map(|parts| 1e6 * parts.fluctuation), 3),
            Cell::number(own.ratio, 4),
            Cell::number(1e6 * chain.referred_inertia(index), 5),
        ]
    };
    Table {
        id: "torsion-inertias",
        title: "Inertias of the torsional chain".into(),
        note: "About their own axes; of throws the part of the crankshaft and the mean of rods and pistons over the cycle, with its fluctuation.".into(),
        remark: String::new(),
        columns: vec![
            Column::words("station"),
            Column::numbers("inertia", "kg mm2"),
            Column::numbers("crankshaft", "kg mm2"),
            Column::numbers("rods and pistons", "kg mm2"),
            Column::numbers("fluctuation", "kg mm2"),
            Column::numbers("ratio", ""),
            Column::numbers("at crankshaft 1", "kg mm2"),
        ],
        rows: chain.stations().iter().enumerate().map(row).collect(),
    }
}

/// Natural frequencies and shapes.
pub fn mode_table(result: &TorsionResult) -> Table {
    let modes = &result.modes;
    let mut columns = vec![
        words("mode", (1..=modes.len()).map(|mode| mode.to_string())),
        numbers("frequency", "Hz", modes.iter().map(|mode| mode.hertz()), 5),
        numbers("cycles a minute", "1/min", modes.iter().map(|mode| 60.0 * mode.hertz()), 6),
        words("nodes", modes.iter().map(|mode| mode.nodes.to_string())),
    ];
    for (index, own) in result.crank.chain.stations().iter().enumerate() {
        columns.push(numbers(&own.name, "", modes.iter().map(|mode| mode.shape[index]), 4));
    }
    Table::of_columns(
        "torsion-modes",
        "Natural frequencies without damping",
        "Angles of the stations at their own speeds, the largest 1; a ring without a spring stands still.",
        columns,
    )
}

/// Frequencies and damping of the damped modes.
pub fn damped_mode_table(result: &TorsionResult) -> Table {
    let modes = &result.damped;
    let swings = |mode: &lanchester_torsion::DampedMode| mode.frequency / std::f64::consts::TAU;
    Table::of_columns(
        "torsion-damped-modes",
        "Natural frequencies with damping",
        "A frequency of 0 is motion that creeps back.",
        vec![
            words("mode", (1..=modes.len()).map(|mode| mode.to_string())),
            numbers("frequency", "Hz", modes.iter().map(swings), 5),
            numbers("damping ratio", "%", modes.iter().map(|mode| 100.0 * mode.damping_ratio), 3),
            numbers("decay", "1/s", modes.iter().map(|mode| mode.decay), 4),
        ],
    )
}

/// Holzer's table at one frequency.
pub fn holzer_table(result: &TorsionResult, table: &HolzerTable) -> Table {
    let rows = &table.rows;
    let column = |header, unit, of: &dyn Fn(&lanchester_torsion::HolzerRow) -> f64| {
        numbers(header, unit, rows.iter().map(of), 5)
    };
    let mut out = Table::of_columns(
        "torsion-holzer",
        format!("Holzer's table at {} Hz", number::short(table.frequency / std::f64::consts::TAU, 6)),
        "As seen at crankshaft 1, the first station with 1 rad.",
        vec![
            words("station", rows.iter().map(|row| station(result, row.station))),
            column("J", "kg m2", &|row| row.inertia),
            column("J w2", "kN m/rad", &|row| 1e-3 * row.inertia_torque_rate),
            column("angle", "rad", &|row| row.angle),
            column("J w2 angle", "kN m", &|row| 1e-3 * row.inertia_torque),
            column("shaft torque", "kN m", &|row| 1e-3 * row.shaft_torque),
            column("stiffness", "kN m/rad", &|row| 1e-3 * row.stiffness.unwrap_or(0.0)),
            column("twist", "rad", &|row| row.twist),
        ],
    );
    out.remark = format!("Residual torque: {:.1e} of the sum of all.", table.relative_residual);
    out
}

/// Speeds at which orders meet natural frequencies.
pub fn critical_table(result: &TorsionResult) -> Table {
    let all = &result.campbell.criticals;
    let listed = || all.iter().take(LISTED);
    let mut table = Table::of_columns(
        "torsion-criticals",
        "Critical speeds",
        "Where an order meets a natural frequency, by the torque of the order in the mode, in true phase.",
        vec![
            numbers("speed", "rpm", listed().map(|own| number::rpm(own.speed)), 5),
            words("order", listed().map(|own| number::order(own.order))),
            words("mode", listed().map(|own| own.mode.to_string())),
            numbers("frequency", "Hz", listed().map(|own| own.frequency / std::f64::consts::TAU), 5),
            numbers("modal torque", "N m", listed().map(|own| own.modal_torque), 4),
        ],
    );
    if all.len() > LISTED {
        table.remark = format!("{} weaker ones are left out.", all.len() - LISTED);
    }
    table
}

/// Largest torque and stress of every shaft over speed.
pub fn shaft_table(result: &TorsionResult) -> Table {
    let shafts = &result.sweep.shafts;
    let speeds = &result.sweep.speeds;
    let row = |own: &lanchester_torsion::ShaftSweep| {
        let (at, largest) = own.peak();
        let strongest = own
            .by_order
            .iter()
            .map(|row| row[at])
            .enumerate()
            .fold((0, 0.0), |best, (k, x)| if x > best.1 { (k, x) } else { best });
        let (_, most) = peak(&own.largest);
        let stress = |torque: f64| known(own.stress_rate.map(|rate| 1e-6 * torque * rate), 4);
        vec![
            Cell::text(shaft(result, own.shaft)),
            Cell::number(largest, 4),
            Cell::number(number::rpm(speeds[at]), 4),
            Cell::text(number::order(result.sweep.orders[strongest.0])),
            Cell::number(peak(&own.sum).1, 4),
            Cell::number(peak(&own.mean.iter().map(|mean| mean.abs()).collect::<Vec<_>>()).1, 4),
            Cell::number(most, 4),
            stress(largest),
            stress(most),
            Cell::number(peak(&own.loss).1, 3),
        ]
    };
    Table {
        id: "torsion-torques",
        title: "Torque of every shaft over the speed range".into(),
        note: "Amplitude in true phase with its speed and strongest order; the sum of the amplitudes of all orders, whatever their phases, beside it. Stress is nominal, at the surface."
            .into(),
        remark: String::new(),
        columns: vec![
            Column::words("shaft"),
            Column::numbers("amplitude", "N m"),
            Column::numbers("at", "rpm"),
            Column::words("order"),
            Column::numbers("sum of amplitudes", "N m"),
            Column::numbers("mean", "N m"),
            Column::numbers("largest", "N m"),
            Column::numbers("stress amplitude", "MPa"),
            Column::numbers("largest stress", "MPa"),
            Column::numbers("loss", "W"),
        ],
        rows: shafts.iter().map(row).collect(),
    }
}

/// Twist, nose, torques, stress over speed.
pub fn torsion_speed_table(result: &TorsionResult) -> Table {
    let sweep = &result.sweep;
    let mut columns = vec![
        numbers("speed", "rpm", sweep.speeds.iter().map(|speed| number::rpm(*speed)), 5),
        numbers("twist", "deg", sweep.twist.total.iter().map(|twist| DEGREES * twist), 4),
        numbers("sum of amplitudes", "deg", sweep.twist.sum.iter().map(|twist| DEGREES * twist), 4),
        numbers("nose", "deg", sweep.nose.total.iter().map(|angle| DEGREES * angle), 4),
        numbers("stress", "MPa", result.stresses().into_iter().map(|stress| 1e-6 * stress), 4),
    ];
    if let Some(damper) = &sweep.damper {
        columns.push(numbers("damper", "W", damper.power.iter().copied(), 4));
        columns.push(numbers("ring against hub", "deg", damper.ring.iter().map(|angle| DEGREES * angle), 4));
    }
    for pendulum in &sweep.pendulums {
        columns.push(numbers(
            &shaft(result, pendulum.shaft),
            "deg",
            pendulum.swing.iter().map(|angle| DEGREES * angle),
            4,
        ));
    }
    for own in &sweep.shafts {
        columns.push(numbers(&shaft(result, own.shaft), "N m", own.total.iter().copied(), 4));
    }
    Table::of_columns(
        "torsion-speeds",
        "Torsional vibration over speed",
        "Amplitudes in true phase: twist between nose and flywheel, the nose, the largest nominal shear stress, torque of every shaft.",
        columns,
    )
}

/// Twist between nose and flywheel by order over speed.
pub fn twist_order_table(result: &TorsionResult) -> Table {
    let sweep = &result.sweep;
    let mut columns = vec![numbers("speed", "rpm", sweep.speeds.iter().map(|speed| number::rpm(*speed)), 5)];
    for (order, row) in sweep.orders.iter().zip(&sweep.twist.by_order) {
        columns.push(numbers(
            &format!("order {}", number::order(*order)),
            "mdeg",
            row.iter().map(|twist| 1e3 * DEGREES * twist),
            4,
        ));
    }
    Table::of_columns(
        "torsion-twist-orders",
        "Twist between nose and flywheel by order",
        "Amplitude of each order.",
        columns,
    )
}

/// Amplitude of every order in every shaft at the speed of its peak.
pub fn shaft_order_table(result: &TorsionResult) -> Table {
    let sweep = &result.sweep;
    let mut columns = vec![words("order", sweep.orders.iter().map(|order| number::order(*order)))];
    for own in &sweep.shafts {
        let at = own.peak().0;
        let header = format!(
            "{} at {} rpm",
            shaft(result, own.shaft),
            number::terminal(number::rpm(sweep.speeds[at]), 0)
        );
        columns.push(numbers(&header, "N m", own.by_order.iter().map(|row| row[at]), 4));
    }
    Table::of_columns(
        "torsion-shaft-orders",
        "Torque by order at the peak of every shaft",
        "Amplitude of each order.",
        columns,
    )
}

/// Vector sums of the star of each order.
pub fn star_table(result: &TorsionResult) -> Table {
    let stars = &result.stars;
    let mut columns = vec![
        words("order", stars.iter().map(|star| number::order(star.order))),
        numbers("rigid", "", stars.iter().map(|star| star.rigid_sum), 4),
    ];
    for mode in 0..result.modes.len().min(3) {
        columns.push(numbers(&format!("mode {}", mode + 1), "", stars.iter().map(|star| star.sums[mode]), 4));
    }
    Table::of_columns(
        "torsion-stars",
        "Vector sums of the orders",
        "Equal vectors of all cylinders in the phases of their firings: their sum for a rigid crankshaft, and with the amplitudes of each mode at the throws, the largest throw's 1.",
        columns,
    )
}

/// What the damper does over speed, in short.
pub fn damper_table(result: &TorsionResult) -> Option<Table> {
    let damper = result.sweep.damper.as_ref()?;
    let (power, ring) = (peak(&damper.power), peak(&damper.ring));
    let rpm = |index: usize| number::rpm(result.sweep.speeds[index]);
    let rows = vec![
        vec![Cell::text("heat [W]"), Cell::number(power.1, 4), Cell::number(rpm(power.0), 4)],
        vec![
            Cell::text("ring against hub, amplitude [deg]"),
            Cell::number(DEGREES * ring.1, 4),
            Cell::number(rpm(ring.0), 4),
        ],
    ];
    Some(Table {
        id: "torsion-damper",
        title: "The damper".into(),
        note: "Largest over the speed range.".into(),
        remark: String::new(),
        columns: vec![
            Column::words("quantity"),
            Column::numbers("largest", ""),
            Column::numbers("at", "rpm"),
        ],
        rows,
    })
}

/// The curve of the tuning.
pub fn tuning_table(result: &TorsionResult) -> Option<Table> {
    let tuned = result.tuned.as_ref()?;
    let (scale, unit) = aim_unit(tuned.aim);
    let (header, own) = match tuned.free {
        TuneFree::Stiffness => ("stiffness", "N m/rad"),
        TuneFree::Damping | TuneFree::Both => ("damping", "N m s/rad"),
    };
    Some(Table::of_columns(
        "torsion-tuning",
        "Peak over the speed range against the setting of the damper",
        "In true phase; the best setting lies at the least of the curve.",
        vec![
            numbers(header, own, tuned.curve.iter().map(|point| point.value), 5),
            numbers("peak", unit, tuned.curve.iter().map(|point| scale * point.peak), 5),
        ],
    ))
}

/// Factor and unit in which an aim is printed.
pub(super) fn aim_unit(aim: TuneAim) -> (f64, &'static str) {
    match aim {
        TuneAim::Twist => (DEGREES, "deg"),
        TuneAim::Torque(_) => (1.0, "N m"),
        TuneAim::Stress => (1e-6, "MPa"),
    }
}

/// Work and energy of both motions in time.
pub fn time_energy_table(result: &TorsionResult) -> Option<Table> {
    let check = result.time.as_ref()?;
    let runs: Vec<_> = [("linear in time", &check.linear), ("varying inertia", &check.varying)]
        .into_iter()
        .filter_map(|(name, own)| Some((name, own.energy?)))
        .collect();
    let energy = |header: &str, of: fn(&ChainEnergy) -> f64| {
        let cells = runs.iter().map(|(_, own)| Cell::number(of(own), 5));
        (Column::numbers(header, "J"), cells.collect())
    };
    Some(Table::of_columns(
        "torsion-time-energy",
        "Energy over a period in the time domain",
        "Work of gas and load, losses in the dampers. Masses: work of the torque that stands for varying inertia, which is kinetic energy where inertia varies. Energy missing: work of gas and \
         masses less load, damping and change of kinetic and elastic energy, over the sum of the sizes of all powers.",
        vec![
            words("motion", runs.iter().map(|(name, _)| (*name).to_owned())),
            energy("gas", |own| own.gas),
            energy("masses", |own| own.masses),
            energy("load", |own| own.load),
            energy("damping", |own| own.damping),
            energy("change", |own| own.change),
            words("energy missing", runs.iter().map(|(_, own)| format!("{:.1e}", own.error()))),
        ],
    ))
}

/// Orders, time domain, and varying inertia side by side.
pub fn time_table(result: &TorsionResult) -> Option<Table> {
    let check = result.time.as_ref()?;
    let all = [&check.orders, &check.linear, &check.varying];
    let row = |index: usize| {
        let mut row = vec![Cell::text(shaft(result, index))];
        row.extend(all.iter().map(|own| Cell::number(own.torques[index], 5)));
        row
    };
    let mut rows: Vec<Vec<Cell>> = (0..result.crank.chain.shafts().len()).map(row).collect();
    let mut twist = vec![Cell::text("twist nose to flywheel [mdeg]")];
    twist.extend(all.iter().map(|own| Cell::number(1e3 * DEGREES * own.twist, 5)));
    rows.push(twist);
    Some(Table {
        id: "torsion-time",
        title: format!("Time domain at {} rpm", number::terminal(number::rpm(check.speed), 0)),
        note: "Amplitudes by the sum of orders, of the same linear equations in time, and with inertia that varies over the angle.".into(),
        remark: String::new(),
        columns: vec![
            Column::words("torque [N m] of"),
            Column::numbers("orders", ""),
            Column::numbers("linear in time", ""),
            Column::numbers("varying inertia", ""),
        ],
        rows,
    })
}
