//! Free forces and couples as textbooks print them or as derived by hand.

use super::{engine, evidence};
use lanchester_mechanism::{Kinematics, LoadRequest, Part, loads};
use lanchester_model::{Engine, RodJoint};
use lanchester_results::LoadSet;
use num_complex::Complex64;
use serde::Deserialize;

#[derive(Debug, Clone, Deserialize)]
struct Table {
    rows: Vec<Row>,
}

/// One printed value: the largest resultant of an order of the reciprocating masses' force or couple.
#[derive(Debug, Clone, Deserialize)]
struct Row {
    template: String,
    layout: String,
    source: String,
    load: Load,
    order: u32,
    /// What a couple is counted in: the distance between neighbouring throws, or between the banks.
    lever: Option<Lever>,
    /// As printed, with F1 = m_osc r w^2 and F2 = F1 r/l.
    printed: String,
    /// The printed expression as a number.
    value: f64,
    /// Half a unit of the last printed digit where a rounded number is printed.
    half_digit: Option<f64>,
    shape: Option<Shape>,
    /// The row is about this part of the order's ellipse alone.
    part: Option<Sense>,
}

#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Sense {
    Forward,
    Backward,
}

#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Load {
    Force,
    Couple,
}

#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Lever {
    Spacing,
    Stagger,
}

/// Which way the load points or turns.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Shape {
    /// Of one size, turning with the crank: crank weights can remove it.
    Forward,
    /// Of one size, turning against it.
    Backward,
    /// Along x only.
    AlongX,
    /// Along y only.
    AlongY,
}

fn table() -> Vec<Row> {
    let text = std::fs::read_to_string(evidence::folder().join("textbook.json")).expect("the table is there");
    serde_json::from_str::<Table>(&text).expect("the table has its form").rows
}

/// The textbooks' engine: every rod is the first one's, sits on the crankpin and runs in the plane of its throw; no
/// offsets.
fn idealised(engine: &Engine) -> Engine {
    let mut engine = engine.clone();
    let rod = engine.cylinders[0].rod.clone();
    engine = engine
        .with(|engine| {
            for cylinder in &mut engine.cylinders {
                cylinder.z = engine.throws[cylinder.throw].z;
                cylinder.rod = rod.clone();
                cylinder.rod.joint = RodJoint::Crankpin;
                cylinder.offset = 0.0;
                cylinder.pin_offset = 0.0;
            }
        })
        .expect("an engine");
    engine
}

/// Where a row and what is computed differ.
fn difference(row: &Row, engine: &Engine) -> Option<String> {
    let engine = idealised(engine);
    // Coefficients cut after the first power of the rod ratio: order 1 is 1, order 2 is r/l.
    let kinematics = Kinematics::PowerSeries { max_order: 2, max_power: 1 };
    let request = LoadRequest { kinematics, max_order: 2, ..LoadRequest::default() };
    let loads = loads(&engine, &request).expect("a valid engine has loads");
    let part = loads.parts.iter().find(|p| p.part == Part::Reciprocating).expect("an engine has pistons");

    let evidence = evidence::read(&row.template).unwrap_or_else(|missing| panic!("{missing}"));
    let (cylinder, radius) = (&engine.cylinders[0], engine.throws[0].radius);
    let mut unit = cylinder.reciprocating_mass() * radius * loads.speed * loads.speed;
    if row.order == 2 {
        unit *= radius / cylinder.rod.length;
    }
    match row.lever {
        None => {}
        Some(Lever::Spacing) => unit *= evidence.spacing,
        Some(Lever::Stagger) => unit *= evidence.stagger,
    }
    let (forward, backward) = parts(&part.loads, row);
    let value = match row.part {
        None => forward.norm() + backward.norm(),
        Some(Sense::Forward) => forward.norm(),
        Some(Sense::Backward) => backward.norm(),
    } / unit;
    // Exact expressions agree to rounding; a vanishing one leaves the rounding of a dozen cancelling terms.
    let tolerance = row.half_digit.unwrap_or(1e-11 * row.value.max(1.0));
    let shape = match row.shape {
        None => 0.0,
        Some(Shape::Forward) => backward.norm(),
        Some(Shape::Backward) => forward.norm(),
        Some(Shape::AlongX) => (forward - backward.conj()).norm(),
        Some(Shape::AlongY) => (forward + backward.conj()).norm(),
    } / unit;
    let agrees = (value - row.value).abs() <= tolerance && shape <= 1e-11 * row.value.max(1.0);
    (!agrees).then(|| {
        format!(
            "{} ({}): {:?} of order {}: printed {} = {}, computed {value}, {shape} off {:?} [{}]",
            row.template, row.layout, row.load, row.order, row.printed, row.value, row.shape, row.source
        )
    })
}

fn parts(loads: &LoadSet, row: &Row) -> (Complex64, Complex64) {
    let order =
        loads.orders.iter().find(|o| (o.order - f64::from(row.order)).abs() < 1e-9).expect("orders to 2");
    match row.load {
        Load::Force => (order.force_forward, order.force_backward),
        Load::Couple => (order.couple_forward, order.couple_backward),
    }
}

#[test]
fn lit_textbook_free_forces_and_couples() {
    let rows = table();
    assert!(rows.len() >= 130, "{} rows", rows.len());
    let found: Vec<String> = rows.iter().filter_map(|row| difference(row, &engine(&row.template))).collect();
    assert!(found.is_empty(), "{} of {} rows differ:\n{}", found.len(), rows.len(), found.join("\n"));
}

#[test]
fn textbook_comparison_fails_where_a_value_or_a_sense_is_wrong() {
    for row in table() {
        let engine = engine(&row.template);
        let mut wrong = row.clone();
        wrong.value += row.half_digit.map_or(1e-6, |half| 3.0 * half);
        assert!(difference(&wrong, &engine).is_some(), "{row:?} accepts a wrong value");
        if row.value == 0.0 {
            continue;
        }
        let mut wrong = row.clone();
        wrong.shape = match row.shape {
            Some(Shape::Forward) => Some(Shape::Backward),
            Some(Shape::Backward) => Some(Shape::Forward),
            Some(Shape::AlongX) => Some(Shape::AlongY),
            Some(Shape::AlongY) => Some(Shape::AlongX),
            None => continue,
        };
        assert!(difference(&wrong, &engine).is_some(), "{row:?} accepts a wrong sense");
    }
}
