//! Unbalance of a crank with its bobweights, weights outside and slugs inside, as tables.

use super::mass::{grams, on_rotor, rotor_degrees};
use crate::kit::number;
use crate::kit::rounding::below;
use crate::kit::table::{Cell, Column, Table};
use lanchester_workshop::{BodyState, CrankUnbalance, ExternalBalance, InternalBalance, PlaneUnbalance};
use num_complex::Complex64;

/// Which circle the angles of an engine's crank stand on.
const OF_THE_CRANK: &str = "Angles count on the crankshaft, from +x at theta = 0 in the sense of rotation.";
/// The same for a sheet alone.
const OF_THE_SHEET: &str = "Angles count as in the sheet.";

fn of_planes(
    id: &'static str,
    title: &str,
    head: &str,
    planes: &[PlaneUnbalance],
    (noise, note): (f64, &str),
) -> Table {
    let rows = planes
        .iter()
        .map(|plane| {
            let mut row = vec![Cell::text(&plane.name), millimetres(plane.z)];
            row.extend(on_rotor(plane.unbalance, noise));
            row
        })
        .collect();
    Table {
        id,
        title: title.to_owned(),
        note: note.to_owned(),
        remark: String::new(),
        columns: vec![
            Column::words(head),
            Column::numbers("z", "mm"),
            Column::numbers("unbalance", "g mm"),
            Column::numbers("at", "deg"),
        ],
        rows,
    }
}

fn millimetres(z: f64) -> Cell {
    Cell::Number { value: 1e3 * z, decimals: 1 }
}

/// What is rounding beside all the parts together.
pub(super) fn noise(answer: &CrankUnbalance) -> f64 {
    below(parts(answer).iter().map(|part| part.unbalance.norm()).sum())
}

fn parts(answer: &CrankUnbalance) -> Vec<PlaneUnbalance> {
    [answer.throws.as_slice(), &answer.counterweights].concat()
}

/// Parts, and the dynamic unbalance in two planes.
pub fn crank_tables(answer: &CrankUnbalance) -> Vec<Table> {
    let noise = noise(answer);
    vec![
        of_planes("crank-parts", "What the crank carries", "part", &parts(answer), (noise, OF_THE_CRANK)),
        of_planes(
            "crank-planes",
            "Dynamic unbalance: as two",
            "plane",
            &answer.planes,
            (noise, OF_THE_CRANK),
        ),
    ]
}

/// Static, couple and dynamic unbalance for a terminal.
pub fn crank_text(answer: &CrankUnbalance) -> String {
    let length = parts(answer).iter().fold(0.0f64, |m, p| m.max(p.z.abs()));
    let noise = noise(answer);
    let mut out = format!("{}: unbalance of {} with bobweights\n", answer.engine, answer.crankshaft);
    for table in crank_tables(answer) {
        out += "\n";
        out += &table.text();
    }
    out += "\n";
    out += &line("static unbalance", answer.static_unbalance, 1e6, "g mm", noise);
    out += &line("couple unbalance about z = 0", answer.couple_unbalance, 1e6, "kg mm2", noise * length);
    if answer.couple_unbalance.norm() > noise * length {
        out += "  (the sum of z times unbalance: it points where its half at the larger z does)\n";
    }
    if let Some(body) = &answer.body {
        out += &body_text(body, noise);
    }
    out
}

fn body_text(state: &BodyState, noise: f64) -> String {
    let mut out = line("couple unbalance about the mass centre", state.couple, 1e6, "kg mm2", 0.0);
    out += &line("offset of the mass centre", state.offset, 1e6, "um", noise / state.body.mass);
    let tilt = Complex64::from_polar(state.tilt, state.tilt_direction);
    out += &line("tilt of the principal axis", tilt, 1e3, "mrad", 0.0);
    if let Some(quasi) = state.quasi_static {
        out += &format!("{:<40}z = {} mm\n", "nearest single unbalance", number::terminal(1e3 * quasi.z, 1));
    }
    out + &format!("{:<40}{}\n", "kind", state.kind.name())
}

fn line(what: &str, value: Complex64, factor: f64, unit: &str, noise: f64) -> String {
    if value.norm() <= noise {
        return format!("{what:<40}0 {unit}\n");
    }
    let amount = factor * value.norm();
    format!(
        "{what:<40}{} {unit} at {} deg\n",
        number::terminal(amount, number::decimals(amount, 4)),
        number::plain(rotor_degrees(value.arg(), 1), 1)
    )
}

/// Weights that flywheel and damper must carry.
pub fn external_tables(answer: &ExternalBalance) -> Vec<Table> {
    let mut table =
        of_planes("external-weights", "Weights outside", "plane", &answer.weights, (0.0, OF_THE_CRANK));
    if answer.masses.iter().any(Option::is_some) {
        table.columns.extend([Column::numbers("radius", "mm"), Column::numbers("mass", "g")]);
        for (row, weight) in table.rows.iter_mut().zip(&answer.masses) {
            row.extend(weight.map_or([Cell::Empty, Cell::Empty], |w| [millimetres(w.radius), grams(w.mass)]));
        }
    }
    vec![table]
}

/// Internal to external balance for a terminal.
pub fn external_text(answer: &ExternalBalance) -> String {
    let mut out = format!(
        "{}: weights outside for {}, with {} % of its counterweights kept\n\n",
        answer.engine,
        answer.crankshaft,
        number::plain(100.0 * answer.kept_share, 1)
    );
    let size: f64 = answer.weights.iter().map(|w| w.unbalance.norm()).sum();
    out += &line("static unbalance to be balanced", answer.static_unbalance, 1e6, "g mm", below(size));
    out += &line("couple unbalance about z = 0", answer.couple_unbalance, 1e6, "kg mm2", below(size));
    for table in external_tables(answer) {
        out += "\n";
        out += &table.text();
    }
    out
}

/// What comes off, and the slugs that go in.
pub fn internal_tables(answer: &InternalBalance) -> Vec<Table> {
    let rows = answer
        .planes
        .iter()
        .map(|plane| {
            let plan = &plane.plan;
            let directions: Vec<String> =
                plan.directions.iter().map(|d| number::plain(rotor_degrees(*d, 1), 1)).collect();
            let mut row = vec![Cell::text(&plane.name), millimetres(plane.z)];
            row.extend(on_rotor(plan.wanted, 0.0));
            row.extend([
                Cell::Number { value: plan.directions.len() as f64, decimals: 0 },
                Cell::Number { value: 1e3 * plan.length, decimals: 2 },
                Cell::text(directions.join(", ")),
                Cell::number(1e6 * plan.gained.norm(), 4),
                Cell::Number { value: 1e3 * plan.added_mass, decimals: 1 },
                Cell::text(match (plan.reached, plan.directions.is_empty()) {
                    (true, _) => "all of it",
                    (false, true) => "no room at this angle",
                    (false, false) => "not enough room",
                }),
            ]);
            row
        })
        .collect();
    let columns = vec![
        Column::words("counterweight"),
        Column::numbers("z", "mm"),
        Column::numbers("wanted", "g mm"),
        Column::numbers("at", "deg"),
        Column::numbers("slugs", ""),
        Column::numbers("length", "mm"),
        Column::words("at angles (deg)"),
        Column::numbers("gained", "g mm"),
        Column::numbers("added mass", "g"),
        Column::words("gains"),
    ];
    let note = "All slugs of a counterweight have one length; their axes stand on the radius of the plane."
        .to_owned();
    let slugs = Table {
        id: "internal-slugs",
        title: "Slugs inside".to_owned(),
        note,
        remark: String::new(),
        columns,
        rows,
    };
    vec![
        of_planes(
            "internal-externals",
            "Weights that come off",
            "weight",
            &answer.externals,
            (0.0, OF_THE_SHEET),
        ),
        slugs,
    ]
}

/// External to internal balance for a terminal.
pub fn internal_text(answer: &InternalBalance) -> String {
    let slug = &answer.planes[0].plan.slug;
    let mut out = format!(
        "{}: slugs of {} mm, at most {} mm long, {} kg/m3 in {} kg/m3\n",
        answer.name,
        number::plain(1e3 * slug.diameter, 2),
        number::plain(1e3 * slug.longest, 2),
        number::plain(slug.density, 0),
        number::plain(slug.crank_density, 0),
    );
    for table in internal_tables(answer) {
        out += "\n";
        out += &table.text();
    }
    out += "\n";
    for plane in &answer.planes {
        out += &format!(
            "a slug of full length gains {} g mm in {}\n",
            number::terminal(1e6 * plane.plan.gain_of_one, 1),
            plane.name
        );
    }
    if !answer.reached {
        out += "the counterweights have not enough room: larger, denser or more slugs, or some weight stays outside\n";
        out += &line("static unbalance left", answer.static_left, 1e6, "g mm", 0.0);
        out += &line("couple unbalance left about z = 0", answer.couple_left, 1e6, "kg mm2", 0.0);
    }
    out
}
