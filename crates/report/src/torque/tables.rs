//! Torque, work, energy and firing in numbers.

use crate::kit::number;
use crate::kit::rounding::below;
use crate::kit::table::{Cell, Column, Table, column_cells, csv_number, numbers, push_csv_line, words};
use lanchester_mechanism::{
    Brake, FiringChart, FlywheelNeed, PowerCurve, RippleOutcome, SpeedRipple, Torque, TorqueAtSpeed,
};
use std::fmt::Write;

/// A table of named values with their units.
fn named(id: &'static str, title: &str, note: &str, rows: Vec<(&str, f64, &str, i32)>) -> Table {
    let columns = vec![Column::words("quantity"), Column::numbers("value", ""), Column::words("unit")];
    let rows = rows
        .into_iter()
        .map(|(name, value, unit, digits)| {
            vec![Cell::text(name), Cell::number(value, digits), Cell::text(unit)]
        })
        .collect();
    Table { id, title: title.to_owned(), note: note.to_owned(), remark: String::new(), columns, rows }
}

/// What the engine gives: net indicated, and at the brake where friction is known.
pub fn torque_table(torque: &Torque, brake: Option<&Brake>) -> Table {
    let indicated = &torque.indicated;
    let note = format!("At {} rpm, {}.", number::terminal(number::rpm(torque.speed), 0), torque.lever.name());
    if !torque.with_gas {
        let rows = vec![
            ("mean torque", torque.energy.mean, "N m", 5),
            ("mean piston speed", indicated.mean_piston_speed, "m/s", 4),
        ];
        return named("torque-table", "Torque without gas", &note, rows);
    }
    let mut rows = vec![
        ("indicated torque, net", indicated.torque, "N m", 5),
        ("indicated power, net", indicated.power / 1e3, "kW", 4),
        ("mean effective pressure (IMEP), net", indicated.imep / 1e5, "bar", 4),
        ("mean effective pressure of the crankcase", indicated.crankcase_mep / 1e5, "bar", 4),
        ("highest cylinder pressure", indicated.peak_pressure / 1e5, "bar", 4),
        ("swept volume", indicated.displacement * 1e6, "cm^3", 5),
        ("mean piston speed", indicated.mean_piston_speed, "m/s", 4),
    ];
    if let Some(brake) = brake {
        rows.extend([
            ("friction mean effective pressure", brake.fmep / 1e5, "bar", 4),
            ("brake mean effective pressure", brake.bmep / 1e5, "bar", 4),
            ("brake torque", brake.torque, "N m", 5),
            ("brake power", brake.power / 1e3, "kW", 4),
            ("mechanical efficiency", 100.0 * brake.efficiency, "%", 4),
        ]);
    }
    named("torque-table", "Torque and power", &note, rows)
}

/// Extremes and energy of gas, inertia and both.
pub fn torque_extremes_table(torque: &Torque) -> Table {
    let parts = match torque.with_gas {
        true => vec![
            ("gas", torque.gas_extremes, Some(torque.gas_energy)),
            ("inertia", torque.inertia_extremes, None),
            ("gas and inertia", torque.total_extremes, Some(torque.energy)),
        ],
        false => vec![("inertia", torque.inertia_extremes, Some(torque.energy))],
    };
    let of = |f: &dyn Fn(usize) -> f64| (0..parts.len()).map(f).collect::<Vec<_>>();
    let energy = |f: fn(&lanchester_mechanism::EnergyVariation) -> f64| {
        parts.iter().map(|p| p.2.as_ref().map_or(Cell::Empty, |e| Cell::number(f(e), 5))).collect::<Vec<_>>()
    };
    Table::of_columns(
        "torque-extremes",
        "Torque over the cycle",
        "Energy fluctuation: largest minus smallest accumulated energy of the torque less its mean, what a flywheel must hold. Absolute integral: of \
         the torque's distance from its mean over its repeat period, the twin thesis's \u{201c}variation of energy\u{201d}.",
        vec![
            words("part", parts.iter().map(|p| p.0.to_owned())),
            numbers("highest", "N m", of(&|k| parts[k].1.max.value).into_iter(), 5),
            numbers("at", "deg", of(&|k| parts[k].1.max.theta.to_degrees()).into_iter(), 4),
            numbers("lowest", "N m", of(&|k| parts[k].1.min.value).into_iter(), 5),
            numbers("at", "deg", of(&|k| parts[k].1.min.theta.to_degrees()).into_iter(), 4),
            (Column::numbers("energy fluctuation", "J"), energy(|e| e.excess)),
            (Column::numbers("absolute integral", "J"), energy(|e| e.absolute)),
            (Column::numbers("repeat period", "deg"), energy(|e| e.own_period.to_degrees())),
        ],
    )
}

/// Torque by order, halves included.
pub fn torque_orders_table(torque: &Torque) -> Table {
    let noise = below(torque.total_extremes.max_abs());
    let rows: Vec<_> = torque.harmonics.iter().collect();
    let column = |f: fn(&lanchester_mechanism::TorqueHarmonic) -> f64| {
        column_cells(rows.iter().map(|h| f(h)), 5, noise)
    };
    let phase = (
        Column::numbers("phase", "deg"),
        rows.iter()
            .map(|h| match h.total().norm() > noise && h.order > 0.0 {
                true => Cell::number(number::phase_degrees(h.total().arg()), 4),
                false => Cell::Empty,
            })
            .collect(),
    );
    let mut columns = vec![words("order", rows.iter().map(|h| number::order(h.order)))];
    if torque.with_gas {
        columns.push((Column::numbers("gas", "N m"), column(|h| h.gas.norm())));
    }
    columns.push((Column::numbers("inertia", "N m"), column(|h| h.inertia.norm())));
    if torque.with_gas {
        columns.push((Column::numbers("both", "N m"), column(|h| h.total().norm())));
    }
    columns.push(phase);
    Table::of_columns(
        "torque-orders-table",
        "Torque by order",
        "Amplitudes; order 0 is the mean. The roll moment on the block answers the torque.",
        columns,
    )
}

/// What `torque` has to tell in tables: those of gas only where there is some, those of firing where the file gives one.
pub(crate) fn torque_tables(torque: &Torque, brake: Option<&Brake>) -> Vec<Table> {
    let mut tables =
        vec![torque_table(torque, brake), torque_extremes_table(torque), torque_orders_table(torque)];
    if torque.with_gas {
        tables.push(cylinder_work_table(torque));
    }
    if !torque.firing.firings.is_empty() {
        tables.extend([firing_table(&torque.firing), stroke_table(&torque.firing)]);
    }
    tables
}

/// Work and pressures of every cylinder.
pub fn cylinder_work_table(torque: &Torque) -> Table {
    let rows = &torque.cylinders;
    let column = |head: &str, unit, f: fn(&lanchester_mechanism::CylinderTorque) -> f64, digits| {
        numbers(head, unit, rows.iter().map(f).collect::<Vec<_>>().into_iter(), digits)
    };
    Table::of_columns(
        "cylinder-work",
        "Work of the cylinders in a working cycle",
        "By torque over the angle, by pressures over the volume, by the forces in the rods: three quadratures of one work (the first with the lever \
         asked for).",
        vec![
            words("cylinder", rows.iter().map(|c| c.cylinder.to_string())),
            column("fires", "deg", |c| c.firing_angle.to_degrees(), 4),
            column("by torque", "J", |c| c.work.by_torque, 6),
            column("by volume", "J", |c| c.work.by_volume, 6),
            column("by rods", "J", |c| c.work.by_rods, 6),
            column("IMEP", "bar", |c| c.work.imep() / 1e5, 4),
            column("gross", "bar", |c| c.work.gross_imep() / 1e5, 4),
            column("pumping", "bar", |c| c.work.pumping_mep() / 1e5, 3),
            column("peak", "bar", |c| c.peak_pressure.value / 1e5, 4),
            column("at", "deg", |c| c.peak_pressure.theta.to_degrees(), 3),
        ],
    )
}

/// Sequence and intervals of firing.
pub fn firing_table(firing: &FiringChart) -> Table {
    let mut table = Table::of_columns(
        "firing",
        "Firing",
        "",
        vec![
            words("cylinder", firing.firings.iter().map(|f| f.cylinder.to_string())),
            numbers("fires at", "deg", firing.firings.iter().map(|f| f.theta.to_degrees()), 4),
            numbers("interval", "deg", firing.firings.iter().map(|f| f.interval.to_degrees()), 4),
        ],
    );
    let even = number::trimmed(firing.even_interval.to_degrees(), 4);
    table.remark = if firing.unevenness == 0.0 {
        format!("Even: every {even} deg.")
    } else {
        let most = number::trimmed(100.0 * firing.unevenness, 3);
        format!("Uneven: an interval departs by {most} % from the even {even} deg.")
    };
    table
}

/// Which stroke every cylinder is in, from dead centre to dead centre: Table 4.1 of the 3-/4-cylinder thesis for any engine.
pub fn stroke_table(firing: &FiringChart) -> Table {
    let changes = firing.changes();
    let order = firing.order();
    let mut columns = vec![
        numbers("from", "deg", changes.iter().map(|c| c.to_degrees()), 4),
        numbers(
            "to",
            "deg",
            (0..changes.len())
                .map(|k| changes.get(k + 1).map_or(firing.period + changes[0], |c| *c).to_degrees()),
            4,
        ),
    ];
    for cylinder in order {
        let letter = |k: usize| {
            let to = changes.get(k + 1).copied().unwrap_or(firing.period + changes[0]);
            let stroke = firing.cylinders[cylinder - 1].at(0.5 * (changes[k] + to), firing.period);
            stroke.map_or(String::new(), |stroke| stroke.letter().to_string())
        };
        columns.push(words(&cylinder.to_string(), (0..changes.len()).map(letter)));
    }
    Table::of_columns(
        "strokes-table",
        "Strokes of the cylinders, in firing order",
        "P power, E exhaust, I intake, C compression.",
        columns,
    )
}

/// Cyclic speed fluctuation at several speeds; where the speed is not known or the engine stops, the outcome says so.
pub fn ripple_table(ripples: &[RippleOutcome]) -> Table {
    let column = |head: &str, unit, f: fn(&SpeedRipple) -> f64, digits| {
        let cell =
            |ripple: &RippleOutcome| ripple.periodic().map_or(Cell::Empty, |r| Cell::number(f(r), digits));
        (Column::numbers(head, unit), ripples.iter().map(cell).collect::<Vec<_>>())
    };
    let outcome = |ripple: &RippleOutcome| match ripple {
        RippleOutcome::Periodic(_) => "periodic",
        RippleOutcome::IncompleteInertia(_) => "inertia not known",
        RippleOutcome::Stops(_) => "stops",
    };
    let mut table = Table::of_columns(
        "speed-ripple-table",
        "Cyclic speed fluctuation",
        "Periodic speed with the inertia of the train over the angle, under a load that takes the mean torque. C_s: highest minus lowest over mean speed; \
         by formula: largest excess energy over inertia times speed squared.",
        vec![
            numbers("speed", "rpm", ripples.iter().map(|r| number::rpm(r.mean_speed())), 5),
            words("outcome", ripples.iter().map(|ripple| outcome(ripple).to_owned())),
            column("highest", "rpm", |r| number::rpm(r.extremes.max.value), 6),
            column("lowest", "rpm", |r| number::rpm(r.extremes.min.value), 6),
            column("C_s", "%", |r| 100.0 * r.fluctuation, 4),
            column("by formula", "%", |r| 100.0 * r.simple_fluctuation, 4),
            column("energy fluctuation", "J", |r| r.excess, 5),
            column("inertia", "g m^2", |r| 1e3 * r.inertia.mean, 5),
            column("of it flywheel", "g m^2", |r| 1e3 * r.inertia.given.flywheel, 5),
            column("acceleration", "rad/s^2", |r| r.acceleration, 4),
        ],
    );
    table.remark = ripple_words(ripples);
    table
}

/// Why there is no periodic speed, and what fixes it: a sentence for each reason; empty where there is one at every speed.
pub fn ripple_words(ripples: &[RippleOutcome]) -> String {
    let mut said: Vec<(String, Vec<String>)> = Vec::new();
    for ripple in ripples {
        let Some([reason, fix]) = ripple.trouble() else { continue };
        let words = format!("no cyclic speed fluctuation, because {reason}; {fix}.");
        let speed = number::terminal(number::rpm(ripple.mean_speed()), 0);
        match said.iter_mut().find(|(known, _)| *known == words) {
            Some((_, speeds)) => speeds.push(speed),
            None => said.push((words, vec![speed])),
        }
    }
    let sentences: Vec<String> =
        said.into_iter().map(|(words, speeds)| format!("At {} rpm {words}", speeds.join(" and "))).collect();
    sentences.join(" ")
}

/// The flywheel that a fluctuation needs.
pub fn flywheel_table(need: &FlywheelNeed) -> Table {
    let [by_formula, by_ripple] = match need.crankshaft_known {
        true => ["flywheel by formula", "flywheel by the true ripple"],
        false => ["flywheel and crankshaft by formula", "flywheel and crankshaft by the true ripple"],
    };
    let mut rows = vec![
        ("wanted fluctuation C_s", 100.0 * need.fluctuation, "%", 3),
        ("inertia needed by formula", 1e3 * need.by_formula, "g m^2", 5),
        ("the crank train has, in the mean", 1e3 * need.train, "g m^2", 5),
        (by_formula, 1e3 * need.flywheel_by_formula, "g m^2", 5),
    ];
    if let Some(flywheel) = need.flywheel {
        rows.push((by_ripple, 1e3 * flywheel, "g m^2", 5));
    }
    let note = format!("At {} rpm.", number::terminal(number::rpm(need.speed), 0));
    let mut table = named("flywheel", "Flywheel", &note, rows);
    if !need.crankshaft_known {
        table.remark = "The inertia of the crankshaft is not known.".to_owned();
    }
    if need.flywheel.is_none() {
        table.remark = "No flywheel keeps it.".to_owned();
    }
    table
}

/// Torque, power and energy at several speeds.
pub fn torque_speeds_table(speeds: &[TorqueAtSpeed]) -> Table {
    let column = |head: &str, unit, f: fn(&TorqueAtSpeed) -> f64, digits| {
        numbers(head, unit, speeds.iter().map(f).collect::<Vec<_>>().into_iter(), digits)
    };
    Table::of_columns(
        "torque-speeds",
        "Torque and energy over speed",
        "Net indicated. Energy fluctuation: what a flywheel must hold. Absolute integral: of the torque's distance from its mean over its repeat period, the twin thesis's \
         \u{201c}variation of energy\u{201d}.",
        vec![
            column("speed", "rpm", |t| number::rpm(t.speed), 5),
            column("torque", "N m", |t| t.indicated.torque, 4),
            column("power", "kW", |t| t.indicated.power / 1e3, 4),
            column("IMEP", "bar", |t| t.indicated.imep / 1e5, 4),
            column("peak", "bar", |t| t.indicated.peak_pressure / 1e5, 4),
            column("highest", "N m", |t| t.extremes.max.value, 4),
            column("lowest", "N m", |t| t.extremes.min.value, 4),
            column("energy fluctuation", "J", |t| t.energy.excess, 5),
            column("absolute integral", "J", |t| t.energy.absolute, 5),
            column("repeat period", "deg", |t| t.energy.own_period.to_degrees(), 4),
        ],
    )
}

/// Power over speed: points, and the cubic through the origin.
pub fn power_table(curve: &PowerCurve) -> Table {
    let mut table = Table::of_columns(
        "power-table",
        "Power over speed",
        "Points and the cubic through the origin that fits them with the least squares, as in the twin thesis.",
        vec![
            numbers("speed", "rpm", curve.points.iter().map(|p| number::rpm(p.0)), 5),
            numbers("power", "kW", curve.points.iter().map(|p| p.1 / 1e3), 4),
            numbers("cubic", "kW", curve.points.iter().map(|p| curve.power(p.0) / 1e3), 4),
            numbers("torque", "N m", curve.points.iter().map(|p| p.1 / p.0), 4),
            numbers("cubic", "N m", curve.points.iter().map(|p| curve.torque(p.0)), 4),
        ],
    );
    table.remark = format!(
        "Largest by the cubic: {} kW at {} rpm.",
        number::short(curve.peak.1 / 1e3, 4),
        number::terminal(number::rpm(curve.peak.0), 0)
    );
    table
}

/// All of it as plain text.
pub fn torque_text(torque: &Torque, brake: Option<&Brake>) -> String {
    let mut out = format!("{} at {} rpm\n", torque.engine, number::terminal(number::rpm(torque.speed), 0));
    let _ = match torque.with_gas {
        true => {
            writeln!(
                out,
                "Gas and inertia with the {}; net indicated, without friction.",
                torque.lever.name()
            )
        }
        false => writeln!(
            out,
            "Inertia alone with the {}, without friction; for gas add [gas] to the engine file.",
            torque.lever.name()
        ),
    };
    for table in torque_tables(torque, brake) {
        out.push('\n');
        out.push_str(&table.text());
    }
    out
}

/// Torque over the crank angle, whole and by cylinder, with pressures and volumes.
pub fn torque_csv(torque: &Torque) -> String {
    let mut out = String::with_capacity(16 * torque.theta.len() * (4 + 4 * torque.cylinders.len()));
    let mut head: Vec<String> =
        ["theta [deg]", "gas [N m]", "inertia [N m]", "total [N m]"].map(str::to_owned).into();
    for cylinder in &torque.cylinders {
        let number = cylinder.cylinder;
        let own = ["gas [N m]", "inertia [N m]", "pressure [Pa]", "volume from TDC [m^3]"];
        let own = if torque.with_gas { &own[..] } else { &own[..2] };
        head.extend(own.iter().map(|name| format!("cylinder {number} {name}")));
    }
    push_csv_line(&mut out, head);
    for (j, theta) in torque.theta.iter().enumerate() {
        let whole = [theta.to_degrees(), torque.gas[j], torque.inertia[j], torque.gas[j] + torque.inertia[j]];
        let own = torque.cylinders.iter().flat_map(|c| {
            let gas = c.pressure.get(j).into_iter().chain(c.volume.get(j));
            [c.gas[j], c.inertia[j]].into_iter().chain(gas.copied())
        });
        push_csv_line(&mut out, whole.into_iter().chain(own).map(csv_number));
    }
    out
}
