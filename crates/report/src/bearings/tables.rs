//! Loads of pistons, pins and bearings in numbers and as polar diagrams.

use crate::kit::figure::Figure;
use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::polar::polar_panel;
use crate::kit::table::{Cell, Column, Table, csv_number, numbers, push_csv_line, words};
use lanchester_mechanism::{BearingLoads, BearingSize, CylinderBearings, MainBearing, PinLoad};
use num_complex::Complex64;

/// Sizes of the bearings, where they are known.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BearingSizes {
    /// Piston pin in the rod's small end.
    pub piston_pin: Option<BearingSize>,
    /// Crankpin.
    pub crankpin: Option<BearingSize>,
    /// Main journals.
    pub main: Option<BearingSize>,
}

fn load_columns<'a>(
    loads: impl Iterator<Item = &'a PinLoad> + Clone + 'a,
    size: Option<BearingSize>,
) -> Vec<(Column, Vec<Cell>)> {
    let mut columns = vec![
        numbers("peak", "N", loads.clone().map(|l| l.peak.value), 5),
        numbers("at", "deg", loads.clone().map(|l| l.peak.theta.to_degrees()), 4),
        numbers("mean", "N", loads.clone().map(|l| l.mean), 5),
    ];
    if let Some(size) = size {
        columns.push(numbers("peak", "MPa", loads.clone().map(|l| l.pressure(size).peak / 1e6), 4));
        columns.push(numbers("mean", "MPa", loads.map(|l| l.pressure(size).mean / 1e6), 4));
    }
    columns
}

/// Side thrust, piston pin and lower pin of every cylinder.
pub fn rod_bearings_tables(loads: &BearingLoads, sizes: BearingSizes) -> Vec<Table> {
    let cylinders = &loads.cylinders;
    let names = || words("cylinder", cylinders.iter().map(|c| c.cylinder.to_string()));
    let thrust = Table::of_columns(
        "side-thrust",
        "Side thrust",
        "Piston on wall, positive along v of the cylinder.",
        vec![
            names(),
            numbers("largest", "N", cylinders.iter().map(|c| c.largest_thrust.value), 5),
            numbers("at", "deg", cylinders.iter().map(|c| c.largest_thrust.theta.to_degrees()), 4),
        ],
    );
    let table = |id, title: &str, note: &str, columns: Vec<(Column, Vec<Cell>)>| {
        Table::of_columns(id, title, note, std::iter::once(names()).chain(columns).collect())
    };
    vec![
        thrust,
        table(
            "piston-pin",
            "Piston pin",
            "Rod on pin.",
            load_columns(cylinders.iter().map(|c| &c.piston_pin), sizes.piston_pin),
        ),
        table(
            "crankpin",
            "Crankpin",
            "Rod on crankpin; an articulated rod on its knuckle pin, a master with all that its articulated rods bring.",
            load_columns(cylinders.iter().map(|c| &c.lower_pin), sizes.crankpin),
        ),
    ]
}

/// Main bearings, and what they carry without counterweights where that was computed too.
pub fn main_bearings_table(loads: &BearingLoads, bare: Option<&BearingLoads>, sizes: BearingSizes) -> Table {
    let mut columns = vec![
        words("main", loads.mains.iter().map(|m| m.main.to_string())),
        numbers("z", "mm", loads.mains.iter().map(|m| 1e3 * m.z), 4),
    ];
    if loads.mains.iter().any(|m| m.crankshaft > 1) {
        columns.insert(0, words("crankshaft", loads.mains.iter().map(|m| m.crankshaft.to_string())));
    }
    columns.extend(load_columns(loads.mains.iter().map(|m| &m.load), sizes.main));
    if let Some(bare) = bare {
        columns.push(numbers("peak, bare", "N", bare.mains.iter().map(|m| m.load.peak.value), 5));
        columns.push(numbers("mean, bare", "N", bare.mains.iter().map(|m| m.load.mean), 5));
    }
    Table::of_columns(
        "main-bearing-loads",
        "Main bearings",
        "Journal on bearing, throw by throw; bare: without counterweights.",
        columns,
    )
}

/// Largest loads of each of `parts`: gas, inertia, both.
pub fn bearing_parts_table(parts: &[BearingLoads]) -> Table {
    let several = parts.iter().flat_map(|loads| &loads.mains).any(|main| main.crankshaft > 1);
    let named = |main: &MainBearing| match several {
        true => format!("crankshaft {}, main {}", main.crankshaft, main.main),
        false => format!("main {}", main.main),
    };
    let mains = parts.first().map_or(&[] as &[MainBearing], |loads| &loads.mains);
    let of_rods = ["side thrust", "piston pin", "crankpin"].map(str::to_owned);
    let mut columns = vec![words("largest load", of_rods.into_iter().chain(mains.iter().map(named)))];
    for loads in parts {
        let largest = |of: fn(&CylinderBearings) -> f64| loads.cylinders.iter().map(of).fold(0.0, f64::max);
        let of_rods = [
            largest(|cylinder| cylinder.largest_thrust.value.abs()),
            largest(|cylinder| cylinder.piston_pin.peak.value),
            largest(|cylinder| cylinder.lower_pin.peak.value),
        ];
        let of_mains = loads.mains.iter().map(|main| main.load.peak.value);
        columns.push(numbers(loads.part.name(), "N", of_rods.into_iter().chain(of_mains), 5));
    }
    Table::of_columns(
        "bearing-parts",
        "Largest loads of gas, inertia and both",
        "Each at its own angle; of rods and pistons the largest of all cylinders.",
        columns,
    )
}

/// All of it as plain text. `parts`: those of `loads`, where they are to be told apart.
pub fn bearings_text(
    loads: &BearingLoads,
    parts: &[BearingLoads],
    bare: Option<&BearingLoads>,
    sizes: BearingSizes,
) -> String {
    let rpm = number::terminal(number::rpm(loads.speed), 0);
    let mut out = format!("{} at {rpm} rpm: {}\n", loads.engine, loads.part.name());
    for table in bearings_tables(loads, parts, bare, sizes) {
        out.push('\n');
        out.push_str(&table.text());
    }
    if let Some(words) = without_mains_words(loads) {
        out.push('\n');
        push_wrapped(&mut out, "", &words);
    }
    out
}

/// All tables of bearings: `parts` with more than one load apart, `bare` without counterweights.
pub(crate) fn bearings_tables(
    loads: &BearingLoads,
    parts: &[BearingLoads],
    bare: Option<&BearingLoads>,
    sizes: BearingSizes,
) -> Vec<Table> {
    let mut tables = rod_bearings_tables(loads, sizes);
    tables.extend(mains_tables(loads, bare, sizes));
    if parts.len() > 1 {
        tables.push(bearing_parts_table(parts));
    }
    tables
}

/// Crankshafts of which no bearing is told, and why.
pub(crate) fn without_mains_words(loads: &BearingLoads) -> Option<String> {
    let numbers: Vec<String> = loads.without_mains.iter().map(usize::to_string).collect();
    match numbers.as_slice() {
        [] => None,
        [only] => Some(format!(
            "Crankshaft {only} has no throw: where its main bearings stand is not known, and no load of them is told."
        )),
        [others @ .., last] => Some(format!(
            "Crankshafts {} and {last} have no throws: where their main bearings stand is not known, and no load of them is told.",
            others.join(", ")
        )),
    }
}

/// The table of main bearings; none for crankshafts that have none.
pub(crate) fn mains_tables(
    loads: &BearingLoads,
    bare: Option<&BearingLoads>,
    sizes: BearingSizes,
) -> Option<Table> {
    (!loads.mains.is_empty()).then(|| main_bearings_table(loads, bare, sizes))
}

/// Every load over the crank angle.
pub fn bearings_csv(loads: &BearingLoads) -> String {
    let mut head = vec!["theta [deg]".to_owned()];
    for cylinder in &loads.cylinders {
        let number = cylinder.cylinder;
        head.extend(
            [
                "side thrust",
                "piston pin u",
                "piston pin v",
                "lower pin x",
                "lower pin y",
                "radial",
                "tangential",
            ]
            .map(|name| format!("cylinder {number} {name} [N]")),
        );
    }
    for main in &loads.mains {
        let name = format!("crankshaft {} main {}", main.crankshaft, main.main);
        head.extend(["x", "y"].map(|axis| format!("{name} {axis} [N]")));
    }
    let mut out = String::with_capacity(18 * head.len() * (loads.theta.len() + 1));
    push_csv_line(&mut out, head);
    for (j, theta) in loads.theta.iter().enumerate() {
        let mut row = vec![csv_number(theta.to_degrees())];
        let word = |values: &[f64]| values.get(j).copied().map_or(String::new(), csv_number);
        for cylinder in &loads.cylinders {
            let (pin, lower) = (cylinder.piston_pin.load[j], cylinder.lower_pin.load[j]);
            row.push(word(&cylinder.side_thrust));
            row.extend([pin.re, pin.im, lower.re, lower.im].map(csv_number));
            row.extend([word(&cylinder.radial), word(&cylinder.tangential)]);
        }
        row.extend(loads.mains.iter().flat_map(|m| [m.load.load[j].re, m.load.load[j].im].map(csv_number)));
        push_csv_line(&mut out, row);
    }
    out
}

/// Polar diagrams: the crankpin of every cylinder as the pin and as the rod feel it, every main bearing and its journal.
/// `parts`: the loads of all, of gas and of inertia, as far as they are to be drawn.
pub fn bearing_figures(parts: &[BearingLoads]) -> Vec<Figure> {
    let Some(first) = parts.first() else { return Vec::new() };
    let panel =
        |axes: [&str; 2], of: &dyn Fn(&BearingLoads) -> Vec<Complex64>| polar_panel(parts, axes, 0.0, of);
    let mut figures = Vec::new();
    for (k, cylinder) in first.cylinders.iter().enumerate() {
        let number = cylinder.cylinder;
        let mut panels = Vec::new();
        if !cylinder.radial.is_empty() {
            panels.push(panel(["On the pin, outward", "on the pin, in the sense of rotation"], &|loads| {
                let own = &loads.cylinders[k];
                own.radial.iter().zip(&own.tangential).map(|(r, t)| Complex64::new(*r, *t)).collect()
            }));
        }
        panels.push(panel(["On the rod, towards the piston", "on the rod, across"], &|loads| {
            loads.cylinders[k].rod_frame.clone()
        }));
        figures.push(Figure {
            id: format!("crankpin-{number}"),
            title: format!("Crankpin of cylinder {number}"),
            caption: "Load over the cycle in the frame that turns with the pin, and with opposite sign in that of the rod.".to_owned(),
            panels,
            columns: 2,
        });
    }
    for (k, main) in first.mains.iter().enumerate() {
        let name = format!("main bearing {}", main.main);
        let (id, title) = if first.mains.iter().any(|m| m.crankshaft > 1) {
            (
                format!("main-{}-{}", main.crankshaft, main.main),
                format!("Crankshaft {}, {name}", main.crankshaft),
            )
        } else {
            (format!("main-{}", main.main), format!("Main bearing {}", main.main))
        };
        figures.push(Figure {
            id,
            title,
            caption:
                "Journal on bearing in the block's frame, bearing on journal in the frame that turns with it."
                    .to_owned(),
            panels: vec![
                panel(["On the bearing, x", "on the bearing, y"], &|loads| loads.mains[k].load.load.clone()),
                panel(["On the journal, along throw 1", "on the journal, a quarter turn on"], &|loads| {
                    loads.mains[k].journal_frame.clone()
                }),
            ],
            columns: 2,
        });
    }
    figures
}
