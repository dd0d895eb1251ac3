//! Weights of balance shafts as parts: found shapes, parts of the engine, what stands in the way, as tables.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, numbers, words};
use lanchester_geometry::clearance::SweptOverlap;
use lanchester_geometry::{NearestShaftWeight, ShaftWeightAim, ShaftWeightDesign, ShaftWeightLimit};
use lanchester_model::{Engine, ShaftWeight, ShaftWeightPart};

/// The design of weights of one duty.
#[derive(Debug, Clone, Copy)]
pub struct DesignedShaftShape<'a> {
    /// Names of the weights.
    pub names: &'a str,
    /// The unbalance that they must have [kg m].
    pub duty: f64,
    /// The design.
    pub design: &'a ShaftWeightDesign,
}

/// What is made small of a shaft's weight, in words with the value of a design: "mass of all .. is 812.4 g".
pub fn shaft_aim_words(aim: ShaftWeightAim, design: &ShaftWeightDesign) -> (&'static str, String) {
    let (name, value, unit) = match aim {
        ShaftWeightAim::Mass => ("mass", 1e3 * design.mass, "g"),
        ShaftWeightAim::Length => ("length", 1e3 * design.length, "mm"),
        ShaftWeightAim::Radius => ("radius", 1e3 * design.shape.radius, "mm"),
        ShaftWeightAim::Inertia => ("inertia", 1e6 * design.polar_inertia, "kg mm²"),
    };
    (name, format!("{} {unit}", number::short(value, 5)))
}

/// Dimensions and properties of designed weights of balance shafts.
pub fn designed_shaft_weights_table(shapes: &[DesignedShaftShape<'_>]) -> Table {
    let of = |value: fn(&ShaftWeightDesign) -> f64| shapes.iter().map(move |shape| value(shape.design));
    Table::of_columns(
        "shaft-weights",
        "Weights of balance shafts",
        "Mass, inertia about the axis of the shaft and centre without the shaft. The chord is straight, at its distance from the axis.",
        vec![
            words("weight", shapes.iter().map(|shape| shape.names.to_owned())),
            numbers("mass", "g", of(|d| 1e3 * d.mass), 5),
            numbers("unbalance", "kg mm", of(|d| 1e3 * d.unbalance), 5),
            numbers("wanted", "kg mm", shapes.iter().map(|shape| 1e3 * shape.duty), 5),
            numbers("inertia", "kg mm²", of(|d| 1e6 * d.polar_inertia), 4),
            numbers("centre", "mm", of(|d| 1e3 * d.centre), 4),
            numbers("radius", "mm", of(|d| 1e3 * d.shape.radius), 4),
            numbers("chord", "mm", of(|d| 1e3 * d.shape.chord), 4),
            numbers("length", "mm", of(|d| 1e3 * d.length), 4),
            numbers("shaft", "mm", of(|d| 2e3 * d.shape.shaft_radius), 4),
        ],
    )
}

/// Weights of balance shafts that are parts; none where there is none.
pub fn shaft_weight_parts_table(engine: &Engine) -> Option<Table> {
    let shafts = engine.shafts.iter();
    let parts: Vec<(String, &ShaftWeight, &ShaftWeightPart)> = shafts
        .flat_map(|shaft| {
            let weights = shaft.weights.iter().enumerate();
            weights
                .filter_map(|(index, weight)| Some((shaft.weight_name(index), weight, weight.part.as_ref()?)))
        })
        .collect();
    if parts.is_empty() {
        return None;
    }
    let of = |value: fn(&ShaftWeightPart) -> f64| parts.iter().map(move |(.., part)| value(part));
    let wanted = parts.iter().map(|(.., part)| match part.wanted {
        Some(wanted) => Cell::Number { value: 1e3 * wanted, decimals: 2 },
        None => Cell::Empty,
    });
    let face =
        |side: f64| parts.iter().map(move |(_, weight, part)| 1e3 * (weight.z + side * part.length / 2.0));
    Some(Table::of_columns(
        "shaft-weight-parts",
        "Weights of balance shafts as parts",
        "Mass and inertia about the axis of the shaft are those of the weight alone; its radius is what it sweeps.",
        vec![
            words("weight", parts.iter().map(|(name, ..)| name.clone())),
            numbers("unbalance", "kg mm", parts.iter().map(|(_, weight, _)| 1e3 * weight.unbalance), 5),
            (Column::numbers("wanted", "kg mm"), wanted.collect()),
            numbers("mass", "g", of(|part| 1e3 * part.mass()), 5),
            numbers("inertia", "kg mm²", of(|part| 1e6 * part.polar_inertia()), 4),
            numbers("radius", "mm", of(|part| 1e3 * part.shape.radius), 4),
            numbers("chord", "mm", of(|part| 1e3 * part.shape.chord), 4),
            numbers("shaft", "mm", of(|part| 2e3 * part.shape.shaft_radius), 4),
            numbers("from", "mm", face(-1.0), 5),
            numbers("to", "mm", face(1.0), 5),
        ],
    ))
}

/// Swept circles that overlap, a line each; empty where none do.
pub fn swept_overlap_words(overlaps: &[SweptOverlap]) -> String {
    let line = |one: &SweptOverlap| {
        let [depth, from, to] = [one.depth, one.from, one.to].map(|length| number::terminal(1e3 * length, 2));
        format!(
            "Warning: the swept circles of {} and {} overlap by {depth} mm between z {from} and {to} mm: they meet unless their phases keep them apart.\n",
            one.weight, one.other
        )
    };
    overlaps.iter().map(line).collect()
}

/// The nearest value of each limit at which there is a weight with the unbalance `duty` [kg m]; `names` are the weights, `least` and `most` [kg m] what
/// the ranges hold.
pub fn nearest_shaft_limits_table(
    names: &str,
    duty: f64,
    [least, most]: [f64; 2],
    nearest: &[NearestShaftWeight],
) -> Table {
    let rows = nearest.iter().map(|near| {
        let (name, unit, factor) = match near.limit {
            ShaftWeightLimit::LargestRadius => ("radius, at most", "mm", 1e3),
            ShaftWeightLimit::LeastRadius => ("radius, at least", "mm", 1e3),
            ShaftWeightLimit::LargestLength => ("length, at most", "mm", 1e3),
            ShaftWeightLimit::LeastLength => ("length, at least", "mm", 1e3),
            ShaftWeightLimit::LargestChord => ("chord, at most", "mm", 1e3),
            ShaftWeightLimit::LeastChord => ("chord, at least", "mm", 1e3),
            ShaftWeightLimit::ShaftDiameter => ("shaft diameter", "mm", 1e3),
            ShaftWeightLimit::Density => ("density", "kg/m³", 1.0),
        };
        let value = |value: f64| Cell::text(format!("{} {unit}", number::terminal(value * factor, 3)));
        vec![Cell::text(name), value(near.asked), value(near.nearest)]
    });
    let [duty, least, most] = [duty, least, most].map(|unbalance| number::short(1e3 * unbalance, 5));
    Table {
        id: "nearest-shaft-limits",
        title: format!("No weight has the unbalance: {names}"),
        note: format!(
            "Wanted are {duty} kg mm; the ranges hold {least} to {most} kg mm. For each limit alone the nearest value at which there is a weight, all others as they are."
        ),
        remark: String::new(),
        columns: ["limit", "asked for", "nearest"].map(Column::words).into(),
        rows: rows.collect(),
    }
}
