//! The crankshaft as a body: its counterweights as parts, its pieces, its clearances, as tables.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, numbers, words};
use lanchester_geometry::clearance::{Clearance, Clearances, DepthAlong, Obstacle};
use lanchester_geometry::counterweight_properties;
use lanchester_geometry::crankshaft::{CrankshaftBody, SectionKind};
use lanchester_model::{CounterweightPart, Engine};

/// Counterweights that are parts, in the order of the engine.
fn parts(engine: &Engine) -> Vec<(&str, f64, &CounterweightPart)> {
    let weights = engine.counterweights.iter();
    weights
        .filter_map(|weight| Some((weight.name.as_str(), weight.unbalance, weight.part.as_deref()?)))
        .collect()
}

/// Counterweights that are parts; none where there is none.
pub fn counterweight_parts_table(engine: &Engine) -> Option<Table> {
    let parts = parts(engine);
    if parts.is_empty() {
        return None;
    }
    let properties: Vec<_> =
        parts.iter().map(|(.., part)| counterweight_properties(engine, part).ok()).collect();
    let of = |value: fn(&lanchester_geometry::MassProperties) -> f64| {
        properties.iter().map(move |own| own.as_ref().map_or(f64::NAN, value))
    };
    let wanted = parts.iter().map(|(.., part)| match part.wanted {
        Some(wanted) => Cell::Number { value: 1e3 * wanted, decimals: 2 },
        None => Cell::Empty,
    });
    Some(Table::of_columns(
        "counterweight-parts",
        "Counterweights as parts",
        "Mass and polar inertia about the crank axis are what the part has beyond its plain web.",
        vec![
            words("weight", parts.iter().map(|(name, ..)| (*name).to_owned())),
            numbers("unbalance", "kg mm", parts.iter().map(|part| 1e3 * part.1), 5),
            (Column::numbers("wanted", "kg mm"), wanted.collect()),
            numbers("mass", "g", of(|own| 1e3 * own.mass), 5),
            numbers("inertia", "kg mm²", of(|own| 1e6 * own.polar_inertia()), 4),
            numbers(
                "swept radius",
                "mm",
                parts.iter().map(|(.., p)| 1e3 * p.part.outline().swept_radius()),
                4,
            ),
            numbers("thickness", "mm", parts.iter().map(|(.., p)| 1e3 * p.part.thickness()), 4),
        ],
    ))
}

/// The pieces of a crankshaft along z.
pub fn crank_sections_table(body: &CrankshaftBody) -> Table {
    let kind = |kind: SectionKind| match kind {
        SectionKind::Journal => "journal",
        SectionKind::Pin => "crankpin",
        SectionKind::Web => "web",
        SectionKind::Counterweight => "counterweight",
    };
    let of = |value: fn(&lanchester_geometry::crankshaft::CrankshaftSection) -> f64| {
        body.sections.iter().map(value)
    };
    Table::of_columns(
        "crank-sections",
        format!("Pieces of {}", body.name),
        "Metal that pieces share is counted once, with the piece that comes first: journal, pin, web, counterweight.",
        vec![
            words("piece", body.sections.iter().map(|s| s.name.clone())),
            words("kind", body.sections.iter().map(|s| kind(s.kind).to_owned())),
            numbers("from", "mm", of(|s| 1e3 * s.from), 5),
            numbers("to", "mm", of(|s| 1e3 * s.to), 5),
            numbers("mass", "g", of(|s| 1e3 * s.mass), 5),
            numbers("polar inertia", "kg mm²", of(|s| 1e6 * s.polar_inertia), 5),
            numbers("unbalance", "kg mm", of(|s| 1e3 * s.unbalance.unbalance.norm()), 5),
        ],
    )
}

/// Mass, centre, inertia and unbalance of a crankshaft in words.
pub fn crank_body_words(body: &CrankshaftBody) -> String {
    let [x, y, z] = body.mass.centre.map(|place| number::fixed(1e3 * place, 3));
    let inertia = body.mass.inertia_about_centre;
    let square = |value: f64| number::fixed(1e6 * value, 1);
    let unbalance = body.unbalance.unbalance.norm();
    let couple = body.unbalance.couple.norm();
    format!(
        "{} has a mass of {} kg, its centre at x {x}, y {y}, z {z} mm, and a polar inertia of {} kg mm². About its centre the tensor \
         is I_xx {}, I_yy {}, I_zz {}, I_xy {}, I_yz {}, I_zx {} kg mm². It is out of balance by {} kg mm, and by {} kg mm² as a couple about the origin.",
        number::capital(&body.name),
        number::fixed(body.mass.mass, 3),
        square(body.polar_inertia),
        square(inertia[0][0]),
        square(inertia[1][1]),
        square(inertia[2][2]),
        square(inertia[0][1]),
        square(inertia[1][2]),
        square(inertia[0][2]),
        number::fixed(1e3 * unbalance, 3),
        number::fixed(1e6 * couple, 1),
    )
}

/// What an obstacle is called.
pub fn obstacle_name(obstacle: Obstacle) -> String {
    match obstacle {
        Obstacle::Crankcase => "crankcase".to_owned(),
        Obstacle::Piston { cylinder } => format!("piston {cylinder}"),
        Obstacle::Liner { cylinder } => format!("liner {cylinder}"),
        Obstacle::Rod { cylinder } => format!("rod {cylinder}"),
        Obstacle::BigEndSide { cylinder } => format!("side of big end {cylinder}"),
    }
}

/// Every counterweight and web against every obstacle; with `nearest` the smallest clearance of each body alone.
pub fn clearances_table(clearances: &Clearances, nearest: bool) -> Table {
    let mut rows: Vec<(String, Clearance)> = Vec::new();
    for body in &clearances.bodies {
        let own = body.clearances.iter().filter(|one| {
            !nearest || one.overlap.is_some() || !matches!(one.obstacle, Obstacle::BigEndSide { .. })
        });
        let mut own: Vec<&Clearance> = own.collect();
        if nearest {
            own.sort_by(|a, b| a.signed().total_cmp(&b.signed()));
            own.truncate(1);
        }
        rows.extend(own.into_iter().map(|one| (body.name.clone(), one.clone())));
    }
    if !nearest {
        let big_ends = clearances.big_ends.iter();
        rows.extend(big_ends.map(|one| (format!("big end {}", one.cylinder), one.clearance.clone())));
    }
    let angle = |one: &Clearance| match one.theta {
        Some(theta) => Cell::Number { value: theta.to_degrees(), decimals: 1 },
        None => Cell::text("any"),
    };
    let remark = |one: &Clearance| match &one.overlap {
        Some(overlap) => {
            let along = match overlap.along {
                DepthAlong::Cylinder => "along the cylinder",
                DepthAlong::Crank => "along the crank",
                DepthAlong::Radius => "in radius",
            };
            format!("overlaps by {} mm {along}", number::terminal(1e3 * overlap.depth, 2))
        }
        None if one.is_kept => String::new(),
        None => "less than wanted".to_owned(),
    };
    let place = |one: &Clearance, k: usize| 1e3 * one.on_body[k];
    let remarks: Vec<String> = rows.iter().map(|row| remark(&row.1)).collect();
    let mut table = Table::of_columns(
        if nearest { "nearest-clearances" } else { "clearances" },
        if nearest { "Nearest of all to each" } else { "Clearances" },
        "Smallest distance in space over the whole cycle, where on the part and at which angle of crankshaft 1; proved.",
        vec![
            words("part", rows.iter().map(|row| row.0.clone())),
            words("against", rows.iter().map(|row| obstacle_name(row.1.obstacle))),
            numbers("distance", "mm", rows.iter().map(|row| 1e3 * row.1.distance), 4),
            (Column::numbers("at", "deg"), rows.iter().map(|row| angle(&row.1)).collect()),
            numbers("x", "mm", rows.iter().map(|row| place(&row.1, 0)), 4),
            numbers("y", "mm", rows.iter().map(|row| place(&row.1, 1)), 4),
            numbers("z", "mm", rows.iter().map(|row| place(&row.1, 2)), 4),
        ],
    );
    if remarks.iter().any(|remark| !remark.is_empty()) {
        table.columns.push(Column::words("remark"));
        for (row, remark) in table.rows.iter_mut().zip(remarks) {
            row.push(Cell::Text(remark));
        }
    }
    table
}

/// The smallest clearance in a sentence, and whether it is what the file wants.
pub fn clearance_words(clearances: &Clearances) -> String {
    let Some(smallest) = &clearances.smallest else {
        return "No pairs of parts are within range.".to_owned();
    };
    let one = &smallest.clearance;
    let at = one
        .theta
        .map_or(String::new(), |theta| format!(" at {} deg", number::terminal(theta.to_degrees(), 1)));
    let wanted = match clearances.least {
        Some(least) => format!(
            "; {} mm are wanted, which {}",
            number::terminal(1e3 * least, 2),
            if clearances.is_kept { "is kept everywhere" } else { "is not kept" }
        ),
        None => String::new(),
    };
    let name = obstacle_name(one.obstacle);
    match &one.overlap {
        Some(overlap) => format!(
            "{} and {name} overlap{at}, {} mm deep{wanted}.",
            smallest.body,
            number::terminal(1e3 * overlap.depth, 2)
        ),
        None => format!(
            "The smallest clearance is {} mm, of {} from {name}{at}{wanted}.",
            number::terminal(1e3 * one.distance, 3),
            smallest.body
        ),
    }
}
