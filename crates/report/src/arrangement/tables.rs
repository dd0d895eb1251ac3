//! Tables of arrangements.

use super::at_spacing;
use crate::number;
use crate::table::{Cell, Column, Table, column_cells};
use lanchester_balance::{Arrangement, Arrangements, GearSeat, ShaftLayout, SpacingArrangements};

/// Below this share of the largest number of a column a number is 0.
const NOISE: f64 = 1e-7;

/// A column of numbers with common decimals.
fn numbers(name: &str, unit: &'static str, values: Vec<f64>, digits: i32) -> (Column, Vec<Cell>) {
    let noise = NOISE * values.iter().filter(|v| v.is_finite()).fold(0.0f64, |m, v| m.max(v.abs()));
    (Column::numbers(name, unit), column_cells(values, digits, noise))
}

/// The front at one spacing, by falling residual; `all`: what is beaten and what has no place as well.
pub fn front_table(found: &Arrangements, spacing: &SpacingArrangements, all: bool) -> Table {
    let mut rows: Vec<usize> = spacing.front.clone();
    if all {
        rows.extend((0..spacing.arrangements.len()).filter(|k| !spacing.arrangements[*k].on_front));
    }
    let chosen: Vec<(usize, &Arrangement)> = rows.iter().map(|&k| (k, &spacing.arrangements[k])).collect();
    let column = |get: &dyn Fn(&Arrangement) -> f64| chosen.iter().map(|(_, a)| get(a)).collect::<Vec<_>>();
    let counts = |name: &str, get: &dyn Fn(&Arrangement) -> usize| {
        let cells = chosen.iter().map(|(_, a)| Cell::Number { value: get(a) as f64, decimals: 0 });
        (Column::numbers(name, ""), cells.collect::<Vec<_>>())
    };
    let (criterion, unit) = (found.criterion.name(), found.criterion.unit());
    let mut columns = vec![
        (
            Column::numbers("no.", ""),
            chosen.iter().map(|(k, _)| Cell::Number { value: (k + 1) as f64, decimals: 0 }).collect(),
        ),
        (
            Column::words("arrangement"),
            chosen.iter().map(|(k, a)| Cell::text(named(a, spacing.simplest == Some(*k)))).collect(),
        ),
        numbers(criterion, unit, column(&|a| a.residual), 4),
    ];
    if let Some(limit) = found.limit {
        columns.push(numbers("of limit", "%", column(&|a| 100.0 * a.residual / limit), 4));
    }
    columns.extend([
        numbers("roll moment", "N m", column(&|a| a.roll_moment), 4),
        counts("shafts", &|a| a.price.shafts),
        counts("meshes", &|a| a.price.meshes),
    ]);
    if chosen.iter().any(|(_, a)| a.price.chains > 0) {
        columns.push(counts("chains", &|a| a.price.chains));
    }
    columns.extend([
        numbers("added mass", "kg", column(&|a| a.price.mass()), 4),
        numbers("added inertia", "kg cm²", column(&|a| 1e4 * a.price.inertia), 4),
        numbers("bearing load", "N", column(&|a| a.price.bearing_load), 4),
        numbers("drive power", "W", column(&|a| a.price.drive_power), 3),
        numbers(
            "clearance",
            "mm",
            column(&|a| a.clearance.as_ref().map_or(f64::NAN, |c| 1e3 * c.distance)),
            3,
        ),
    ]);
    let what = if all { "All arrangements" } else { "Arrangements that nothing beats" };
    let title = format!("{what}{}", at_spacing(spacing, found.spacings.len() == 1));
    let note = "Peaks over the cycle; inertia at the crank. Nothing else is as good in every column at once.";
    Table::of_columns("arrangements", title, if all { "" } else { note }, columns)
}

/// Name with what is to be said about it.
fn named(arrangement: &Arrangement, simplest: bool) -> String {
    let mut name = arrangement.name.clone();
    if simplest {
        name += " (simplest that is good enough)";
    }
    if !arrangement.possible {
        name += match &arrangement.clearance {
            Some(clearance) if arrangement.drive.is_none() && clearance.distance < f64::INFINITY => {
                " (no place)"
            }
            _ => " (limits do not hold)",
        };
    }
    name
}

/// Shafts, gears and idlers of one arrangement.
pub fn drive_table(arrangement: &Arrangement) -> Table {
    let Some(drive) = &arrangement.drive else {
        return Table::of_columns("drive", format!("Drive: {}", arrangement.name), "", Vec::new());
    };
    let seats: Vec<String> = drive
        .gears
        .iter()
        .map(|g| match g.seat {
            GearSeat::Crank => "crank".to_owned(),
            GearSeat::Shaft(k) => arrangement.shafts.get(k).map_or_else(String::new, |s| s.name.clone()),
            GearSeat::Idler => "idler".to_owned(),
        })
        .collect();
    let gears =
        |get: &dyn Fn(&lanchester_balance::Gear) -> f64| drive.gears.iter().map(get).collect::<Vec<_>>();
    let driver: Vec<Cell> = (0..drive.gears.len())
        .map(|k| {
            let link = drive.links.iter().find(|l| l.driven == k);
            link.map_or(Cell::Empty, |l| {
                let how = if l.chain { "chain from gear" } else { "gear" };
                Cell::text(format!("{how} {}", l.driver + 1))
            })
        })
        .collect();
    let columns = vec![
        (
            Column::numbers("gear", ""),
            (0..drive.gears.len()).map(|k| Cell::Number { value: (k + 1) as f64, decimals: 0 }).collect(),
        ),
        (Column::words("on"), seats.into_iter().map(Cell::Text).collect()),
        (Column::words("driven by"), driver),
        numbers("speed ratio", "", gears(&|g| g.ratio), 4),
        numbers("pitch diameter", "mm", gears(&|g| 1e3 * g.pitch_diameter), 4),
        numbers("x", "mm", gears(&|g| 1e3 * g.x), 4),
        numbers("y", "mm", gears(&|g| 1e3 * g.y), 4),
        numbers("gear plane", "", gears(&|g| g.plane as f64), 1),
    ];
    Table::of_columns(
        "drive",
        format!("Drive: {}", arrangement.name),
        "Planes count outwards from the end of the crank.",
        columns,
    )
}

/// Weights, places and bearings of the shafts of one arrangement.
fn shafts_table(arrangement: &Arrangement) -> Table {
    let shafts = &arrangement.shafts;
    let column =
        |get: &dyn Fn(&lanchester_balance::ArrangedShaft) -> f64| shafts.iter().map(get).collect::<Vec<_>>();
    let planes = |layout: &ShaftLayout| match layout {
        ShaftLayout::Single { z } => number::trimmed(1e3 * z, 4),
        ShaftLayout::Double { z } | ShaftLayout::TwoPlanes { z } => {
            format!("{} and {}", number::trimmed(1e3 * z[0], 4), number::trimmed(1e3 * z[1], 4))
        }
    };
    let largest = |index: usize| {
        let on_shaft = arrangement.answer.task.weights.iter().zip(&arrangement.answer.weights);
        let on_shaft = on_shaft.filter(|(free, _)| free.seat == lanchester_model::Seat::Shaft(index));
        on_shaft.map(|(_, found)| found.unbalance.norm()).fold(0.0, f64::max)
    };
    let columns = vec![
        (Column::words("shaft"), shafts.iter().map(|s| Cell::text(&s.name)).collect()),
        numbers("speed ratio", "", column(&|s| f64::from(s.ratio)), 1),
        numbers("x", "mm", column(&|s| 1e3 * s.x), 4),
        numbers("y", "mm", column(&|s| 1e3 * s.y), 4),
        (Column::words("weights at z [mm]"), shafts.iter().map(|s| Cell::text(planes(&s.layout))).collect()),
        numbers("each up to", "kg mm", (0..shafts.len()).map(|k| 1e3 * largest(k)).collect(), 4),
        numbers("radius", "mm", column(&|s| 1e3 * s.weight_sweep), 3),
        numbers("length", "mm", column(&|s| 1e3 * s.weight_length), 3),
        numbers("mass", "kg", column(&|s| s.weight_mass + s.shaft_mass), 3),
        numbers("front bearing", "N", column(&|s| s.bearing_loads[0]), 4),
        numbers("rear bearing", "N", column(&|s| s.bearing_loads[1]), 4),
    ];
    Table::of_columns(
        "shafts",
        format!("Shafts: {}", arrangement.name),
        "Weights are half discs; the bearings carry a constant load that turns with the shaft.",
        columns,
    )
}

/// All tables of a search: the front at every spacing, then shafts and drive of the simplest arrangement that is good
/// enough (without a limit: of the one on the front that leaves least).
pub fn arrangement_tables(found: &Arrangements, all: bool) -> Vec<Table> {
    let mut tables = Vec::new();
    for spacing in &found.spacings {
        tables.push(front_table(found, spacing, all));
        let chosen = spacing.simplest.or_else(|| spacing.front.last().copied());
        if let Some(arrangement) = chosen.map(|k| &spacing.arrangements[k])
            && !arrangement.shafts.is_empty()
        {
            tables.extend([shafts_table(arrangement), drive_table(arrangement)]);
        }
    }
    tables
}

/// The search as plain text for a terminal.
pub fn arrangements_text(found: &Arrangements, all: bool) -> String {
    let mut out = format!("{}: arrangements by {}\n", found.engine, found.criterion.name());
    if let (Some(limit), Some(source)) = (found.limit, &found.limit_source) {
        let value = number::terminal(limit, number::decimals(limit, 5));
        out += &format!("  good enough: {value} {} ({source})\n", found.criterion.unit());
    }
    if let Some(nearest) = &found.nearest {
        out += &format!("  {}\n", nearest.reason);
    }
    for table in arrangement_tables(found, all) {
        out += "\n";
        out += &table.text();
    }
    for spacing in &found.spacings {
        let narrow = spacing.simplest.and_then(|k| spacing.arrangements[k].clearance.as_ref());
        if let Some(clearance) = narrow {
            let millimetres = number::terminal(1e3 * clearance.distance, 1);
            let at = at_spacing(spacing, found.spacings.len() == 1);
            out += &format!("\nnarrowest place{at}: {millimetres} mm, {}\n", clearance.between);
        }
        if all && !spacing.left_out.is_empty() {
            out += "\nnot examined:\n";
            for line in &spacing.left_out {
                out += &format!("  {line}\n");
            }
        }
    }
    out += "\nassumed:\n";
    for line in &found.assumptions {
        out += &format!("  {line}\n");
    }
    out
}
