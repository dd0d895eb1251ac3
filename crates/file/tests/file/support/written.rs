//! Files, weights and comparisons for what is written back.

use lanchester_file::{EngineFile, difference, expanded, read, render, templates, write_back};
use lanchester_model::{
    BalanceShaft, Counterweight, CounterweightForm, CounterweightPart, Engine, ShaftWeight, ShaftWeightPart,
};
use lanchester_shape::{Contour, Corner, CounterweightShape, Insert, Outline, Part, Point};
use std::f64::consts::{PI, TAU};

pub fn engine(text: &str) -> Engine {
    file(text).engine
}

pub fn file(text: &str) -> EngineFile {
    let reading = read(text);
    reading.file.unwrap_or_else(|| panic!("{}\n{text}", render(&reading.diagnostics, "e.toml", text, false)))
}

pub fn template(name: &str) -> &'static str {
    templates().iter().find(|template| template.name == name).unwrap_or_else(|| panic!("no {name}")).text
}

pub fn near(a: f64, b: f64, absolute: f64) -> bool {
    (a - b).abs() <= (1e-11 * b.abs()).max(absolute)
}

pub fn same_direction(a: f64, b: f64, amount: f64) -> bool {
    amount == 0.0 || ((a - b + PI).rem_euclid(TAU) - PI).abs() < 2e-11
}

/// A file with a crankshaft as a body, and with parts.
pub const PARTS: &str = include_str!("../../files/crank-as-body.toml");

/// Good engine files.
pub fn good_files() -> Vec<(&'static str, &'static str)> {
    templates().iter().map(|template| (template.name, template.text)).chain([("parts", PARTS)]).collect()
}

/// The same but for what the digits of a shape lose: 1e-9 of the unbalance.
pub fn same_part(a: &Counterweight, b: &Counterweight) -> bool {
    let (Some(one), Some(two)) = (&a.part, &b.part) else { return false };
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
    let same_wanted = match (one.wanted, two.wanted) {
        (one, Some(two)) => one.is_some_and(|one| near(one, two, 0.0)),
        (_, None) => true,
    };
    (&a.name, a.crankshaft, one.web) == (&b.name, b.crankshaft, two.web)
        && std::mem::discriminant(&one.form) == std::mem::discriminant(&two.form)
        && one.part.outline().outer().edges().len() == two.part.outline().outer().edges().len()
        && (one.part.inserts().len(), one.part.chamfers().len())
            == (two.part.inserts().len(), two.part.chamfers().len())
        && close(one.part.thickness(), two.part.thickness())
        && close(a.unbalance, b.unbalance)
        && (a.z - b.z).abs() <= 1e-9 * two.part.thickness()
        && (b.unbalance == 0.0 || ((a.angle - b.angle + PI).rem_euclid(TAU) - PI).abs() < 1e-9)
        && near(one.z, two.z, 2e-13)
        && same_direction(one.angle, two.angle, 1.0)
        && same_wanted
}

pub fn same_weight(a: &Counterweight, b: &Counterweight) -> bool {
    if a.part.is_some() || b.part.is_some() {
        return same_part(a, b);
    }
    a.name == b.name
        && a.crankshaft == b.crankshaft
        && near(a.z, b.z, 2e-13)
        && near(a.unbalance, b.unbalance, 0.0)
        && same_direction(a.angle, b.angle, b.unbalance)
}

/// The same but for what the digits of a shape lose: 1e-9 of the unbalance.
fn same_shaft_part(a: &ShaftWeightPart, b: &ShaftWeightPart) -> bool {
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
    let same_wanted = match (a.wanted, b.wanted) {
        (one, Some(two)) => one.is_some_and(|one| near(one, two, 0.0)),
        (_, None) => true,
    };
    close(a.unbalance(), b.unbalance())
        && near(a.shape.shaft_radius, b.shape.shaft_radius, 2e-13)
        && near(a.shape.radius, b.shape.radius, 2e-13)
        && near(a.shape.chord, b.shape.chord, 2e-13)
        && near(a.length, b.length, 2e-13)
        && near(a.density, b.density, 0.0)
        && same_wanted
}

pub fn same_shaft(a: &BalanceShaft, b: &BalanceShaft) -> bool {
    let same_weight = |(a, b): (&ShaftWeight, &ShaftWeight)| {
        let same_amount = match (&a.part, &b.part) {
            (Some(one), Some(two)) => same_shaft_part(one, two),
            (_, None) => near(a.unbalance, b.unbalance, 0.0),
            (None, Some(_)) => false,
        };
        near(a.z, b.z, 2e-13) && same_amount && same_direction(a.phase, b.phase, b.unbalance)
    };
    (&a.name, a.ratio) == (&b.name, b.ratio)
        && near(a.x, b.x, 2e-13)
        && near(a.y, b.y, 2e-13)
        && a.weights.len() == b.weights.len()
        && a.weights.iter().zip(&b.weights).all(same_weight)
}

/// Whether every part of one list has its like in the other.
pub fn same_parts<T>(a: &[T], b: &[T], same: impl Fn(&T, &T) -> bool) -> bool {
    let mut left: Vec<&T> = b.iter().collect();
    a.len() == b.len()
        && a.iter().all(|part| match left.iter().position(|other| same(part, other)) {
            Some(place) => {
                left.remove(place);
                true
            }
            None => false,
        })
}

/// The new text reads as the fitted engine, comments are all there, and the rest of the file is what it was.
pub fn check(text: &str, fitted: &Engine) -> Result<String, String> {
    let new = write_back(text, fitted).map_err(|error| format!("{error}: {error:?}"))?;
    let read = engine(&new);
    let shown = || difference(text, &new, "e.toml");
    if !same_parts(&read.counterweights, &fitted.counterweights, same_weight) {
        return Err(format!("{}\n{:#?}\n{:#?}", shown(), read.counterweights, fitted.counterweights));
    }
    if !same_parts(&read.shafts, &fitted.shafts, same_shaft) {
        return Err(format!("{}\n{:#?}\n{:#?}", shown(), read.shafts, fitted.shafts));
    }
    let rest = |engine: Engine| engine.without_counterweights().without_shafts();
    if rest(read) != rest(engine(text)) {
        return Err(format!("the rest of the engine changed: {}", shown()));
    }
    if comments(text) != comments(&new) {
        return Err(format!("comments: {}", shown()));
    }
    if other_lines(text) != other_lines(&new) {
        return Err(format!("other lines: {}", shown()));
    }
    let lone = |text: &str| text.matches('\n').count() - text.matches("\r\n").count();
    if text.contains("\r\n") && lone(&new) > lone(text) {
        return Err(format!("line ends: {new:?}"));
    }
    // Writing once more changes nothing.
    match write_back(&new, &engine(&new)) {
        Ok(again) if again == new => Ok(new),
        other => Err(format!("not at rest: {other:?}")),
    }
}

/// What stands behind a `#` that no text holds: the texts here hold none.
pub fn comments(text: &str) -> Vec<&str> {
    let mut found: Vec<&str> =
        text.lines().filter_map(|line| line.split_once('#')).map(|(_, comment)| comment.trim()).collect();
    found.sort_unstable();
    found
}

/// Lines outside the tables of weights and shafts, without empty ones and comments.
pub fn other_lines(text: &str) -> Vec<&str> {
    let mut is_ours = false;
    let mut lines = Vec::new();
    for line in text.lines() {
        let bare = line.trim_start_matches('\u{feff}').trim_start();
        if bare.starts_with('[') && !bare.starts_with("[ {") {
            is_ours = [
                "[counterweights]",
                "[[counterweight]]",
                "[counterweight.",
                "[[counterweight.",
                "[[shaft",
                "[shaft.",
            ]
            .iter()
            .any(|ours| bare.starts_with(ours));
        }
        // Without headers of their own; the exact texts of these are in the tests.
        let is_value = ["counterweight", "shaft", "{ web"].iter().any(|ours| bare.starts_with(ours));
        if !is_ours && !is_value && !bare.is_empty() && !bare.starts_with('#') {
            lines.push(line.trim_end());
        }
    }
    lines
}

/// The text in other clothes: the same engine.
pub fn dressed(text: &str, dress: usize) -> String {
    match dress {
        0 => text.to_string(),
        1 => text.replace('\n', "\r\n"),
        2 => text.trim_end().to_string(),
        3 => format!("\u{feff}{text}"),
        4 => text
            .lines()
            .enumerate()
            .map(|(number, line)| format!("# above {number}\n{line}  # behind {number}\n"))
            .collect(),
        5 => expanded(&file(text)),
        6 => format!("{}# the end", expanded(&file(text)).replace('\n', "\r\n")),
        _ => format!("{text}\n[balance]\nminimise = [\"force\"]  # last\n"),
    }
}
pub const DRESSES: usize = 8;

/// The family's shape as a part in place of a weight.
pub fn family(shape: CounterweightShape, thickness: f64, density: f64) -> (CounterweightForm, Part) {
    let outline = Outline::from(shape.checked().expect("a shape").outline());
    (CounterweightForm::Family(shape), Part::new(outline, thickness, density).expect("a plate"))
}

/// A plate with an arc and a slug beside the axis.
pub fn plate(width: f64, bulge: f64, thickness: f64) -> (CounterweightForm, Part) {
    let corners = [(0.02, -width, 0.0), (0.05, -width, bulge), (0.05, 1.1 * width, 0.0), (0.02, width, 0.0)];
    let corners = corners.map(|(x, y, bulge)| Corner { at: Point::new(x, y), bulge });
    let outline = Outline::from(Contour::new(&corners).expect("an outline"));
    let slug = Insert {
        centre: Point::new(0.035, 0.3 * width),
        radius: 0.3 * width,
        from: 0.0,
        to: thickness,
        density: 17_300.0,
    };
    let part = Part::new(outline, thickness, 7850.0).and_then(|part| part.with_insert(slug)).expect("a part");
    (CounterweightForm::Counterweight, part)
}

/// The weight as that part; `None` if the part cannot sit there.
pub fn as_part(
    engine: &Engine,
    weight: &Counterweight,
    (form, part): (CounterweightForm, Part),
    wanted: Option<f64>,
) -> Option<Counterweight> {
    let mut webs = engine.throws.iter().enumerate().flat_map(|(index, throw)| {
        let planes = throw.webs.into_iter().flatten().enumerate();
        planes.map(move |(side, z)| (2 * index + side, throw.crankshaft, z))
    });
    let web = webs.find(|(_, on, z)| *on == weight.crankshaft && *z == weight.z).map(|(web, ..)| web);
    let part = CounterweightPart { form, part, web, z: weight.z, angle: weight.angle, wanted };
    let own = engine.part_weight(&part).ok()?;
    Some(Counterweight {
        z: own.z,
        unbalance: own.unbalance,
        angle: own.angle,
        part: Some(Box::new(part)),
        ..weight.clone()
    })
}

pub const SHAPE: CounterweightShape = CounterweightShape {
    web_radius: 0.025,
    rectangle_height: 0.012,
    shoulder_height: 0.008,
    arc_radius: 0.05,
    arc_angle: 2.0,
};
