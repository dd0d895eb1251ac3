//! Tables of arrangements.

use super::at_spacing;
use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, own_cells};
use lanchester_balance::{Arrangement, Arrangements, GearSeat, ShaftLayout, SpacingArrangements};

/// A column of numbers with common decimals.
fn numbers(name: &str, unit: &'static str, values: Vec<f64>, digits: i32) -> (Column, Vec<Cell>) {
    (Column::numbers(name, unit), own_cells(values, digits))
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
        numbers("main load", "N", column(&|a| a.main_load), 4),
        numbers("bending", "N m", column(&|a| a.bending_moment), 4),
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
    ]);
    if all {
        let clearance = column(&|a| {
            let clearance = a.clearance.as_ref().map(|c| c.distance).filter(|d| d.is_finite());
            clearance.map_or(f64::NAN, |distance| 1e3 * distance)
        });
        columns.push(numbers("clearance", "mm", clearance, 3));
    }
    let what = if all { "All arrangements" } else { "Pareto-optimal arrangements" };
    let title = format!("{what}{}", at_spacing(spacing, found.spacings.len() == 1));
    let beaten = if all { "" } else { " Nothing else is as good in every column at once." };
    let note = format!(
        "{}Peaks over the cycle; main load: the largest of inertia on any main bearing; bending of the crankshaft under what \
         turns with it; inertia at the crank.{beaten}",
        key(spacing)
    );
    Table::of_columns("arrangements", title, note, columns)
}

/// What the numbers in the labels of the arrangements at this spacing stand for.
fn key(spacing: &SpacingArrangements) -> String {
    let mut kinds: Vec<(i32, &str)> = Vec::new();
    for shaft in spacing.arrangements.iter().flat_map(|a| &a.shafts) {
        if kinds.iter().all(|(ratio, _)| *ratio != shaft.ratio) {
            kinds.push((
                shaft.ratio,
                match shaft.layout {
                    ShaftLayout::Single { .. } => "one weight",
                    ShaftLayout::Double { .. } => "two opposed weights",
                    ShaftLayout::TwoPlanes { .. } => "a weight in each of two planes",
                },
            ));
        }
    }
    if kinds.is_empty() {
        return String::new();
    }
    kinds.sort_by_key(|(ratio, _)| (ratio.abs(), -ratio));
    let listed: Vec<String> =
        kinds.iter().map(|(ratio, weights)| format!("{ratio:+} has {weights}")).collect();
    format!("A number is a balance shaft by its speed over the crank's: {}. ", listed.join(", "))
}

/// Label with what is to be said about it.
fn named(arrangement: &Arrangement, simplest: bool) -> String {
    let mut name = arrangement.label.clone();
    if simplest {
        name += " (simplest)";
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
fn drive_table(arrangement: &Arrangement) -> Table {
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
        let on_shaft = on_shaft.filter(|(free, _)| free.seat == lanchester_task::Seat::Shaft(index));
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

/// Shafts, drive and gears of one arrangement; none without shafts.
pub fn arrangement_parts(arrangement: &Arrangement) -> Vec<Table> {
    let mut tables = Vec::new();
    if !arrangement.shafts.is_empty() {
        tables.push(shafts_table(arrangement));
    }
    if arrangement.drive.is_some() {
        tables.push(drive_table(arrangement));
    }
    tables
}

/// The narrowest place of an arrangement in words; `None` without shafts.
pub fn narrowest_place(arrangement: &Arrangement) -> Option<String> {
    let clearance = arrangement.clearance.as_ref()?;
    if !clearance.distance.is_finite() {
        return Some(format!("no place: {}", clearance.between));
    }
    let millimetres = number::terminal(1e3 * clearance.distance, 1);
    Some(format!("narrowest place: {millimetres} mm, {}", clearance.between))
}

/// The search as plain text for a terminal: what is good enough, the simplest that is, the front at every spacing (`all`:
/// what is beaten too); at a single spacing also shafts and drive of the simplest, or without a limit of the one that
/// leaves least.
pub fn arrangements_text(found: &Arrangements, all: bool) -> String {
    let mut out = format!("{}: arrangements by {}\n", found.engine, found.criterion.name());
    let value = |value: f64| {
        format!("{} {}", number::terminal(value, number::decimals(value, 5)), found.criterion.unit())
    };
    if let (Some(limit), Some(source)) = (found.limit, &found.limit_source) {
        out += &format!("  good enough: {} ({source})\n", value(limit));
    }
    if let Some(nearest) = &found.nearest {
        out += &format!("  {}\n", nearest.reason);
    }
    let alone = found.spacings.len() == 1;
    for spacing in &found.spacings {
        if let Some(index) = spacing.simplest {
            let simplest = &spacing.arrangements[index];
            let at = at_spacing(spacing, alone);
            let (name, left) = (&simplest.name, value(simplest.residual));
            out += &format!("  simplest{at}: no. {}, {name}: {left}\n", index + 1);
        }
    }
    for spacing in &found.spacings {
        let front = front_table(found, spacing, all);
        out += &format!("\n{}", front.noted_text());
        if all && !spacing.left_out.is_empty() {
            out += "\nnot examined:\n";
            for line in &spacing.left_out {
                out += &format!("  {line}\n");
            }
        }
        let shown = spacing.simplest.or_else(|| spacing.front.last().copied());
        if let Some(arrangement) = shown.map(|k| &spacing.arrangements[k]).filter(|_| alone) {
            for table in arrangement_parts(arrangement) {
                out += &format!("\n{}", table.text());
            }
            out += &narrowest_place(arrangement).map_or_else(String::new, |place| format!("\n{place}\n"));
        }
    }
    out += "\nassumed:\n";
    for line in &found.assumptions {
        out += &format!("  {line}\n");
    }
    out
}
