//! Counterweights that were designed: properties, dimensions, fronts, and what stands in the way, as tables.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, numbers, words};
use lanchester_geometry::{Design, Front, Infeasible, Limit, Objective};

/// Designs of one shape, and the weights that have it.
#[derive(Debug, Clone, Copy)]
pub struct DesignedShape<'a> {
    /// Names of the weights: "web 1, web 2".
    pub names: &'a str,
    /// The unbalance that is full balance [kg m].
    pub duty: f64,
    /// The design.
    pub design: &'a Design,
}

/// What an objective is called.
pub fn objective_name(objective: Objective) -> &'static str {
    match objective {
        Objective::Mass => "mass",
        Objective::SweptRadius => "swept radius",
        Objective::Inertia => "inertia",
        Objective::Thickness => "thickness",
    }
}

/// Unit in which an objective is printed, and what its SI value is multiplied with.
fn objective_unit(objective: Objective) -> (&'static str, f64) {
    match objective {
        Objective::Mass => ("g", 1e3),
        Objective::SweptRadius | Objective::Thickness => ("mm", 1e3),
        Objective::Inertia => ("kg mm²", 1e6),
    }
}

/// A value of an objective in words: "812.4 g".
pub fn objective_words(objective: Objective, value: f64) -> String {
    let (unit, factor) = objective_unit(objective);
    format!("{} {unit}", number::short(value * factor, 5))
}

/// Mass, balance and room of designed counterweights.
pub fn designed_properties_table(shapes: &[DesignedShape<'_>]) -> Table {
    let of = |value: fn(&Design) -> f64| shapes.iter().map(move |shape| value(shape.design));
    let balance = shapes.iter().map(|shape| 100.0 * shape.design.unbalance / shape.duty);
    Table::of_columns(
        "counterweights",
        "The counterweights",
        "What the counterweight adds to the crankshaft beyond the web as it is: mass, unbalance, polar inertia about the crank axis.",
        vec![
            words("weight", shapes.iter().map(|shape| shape.names.to_owned())),
            numbers("mass", "g", of(|d| 1e3 * d.mass), 5),
            numbers("unbalance", "kg mm", of(|d| 1e3 * d.unbalance), 5),
            numbers("wanted", "kg mm", shapes.iter().map(|shape| 1e3 * shape.duty), 5),
            numbers("balance", "%", balance, 5),
            numbers("swept radius", "mm", of(|d| 1e3 * d.swept_radius), 4),
            numbers("inertia", "kg mm²", of(|d| 1e6 * d.inertia), 4),
            numbers("centre", "mm", of(|d| 1e3 * d.centre), 4),
        ],
    )
}

/// Dimensions of designed counterweights.
pub fn designed_dimensions_table(shapes: &[DesignedShape<'_>]) -> Table {
    let of = |value: fn(&Design) -> f64| shapes.iter().map(move |shape| value(shape.design));
    let length = |header: &str, value: fn(&Design) -> f64| {
        numbers(header, "mm", of(value).map(|length| 1e3 * length), 4)
    };
    Table::of_columns(
        "counterweight-dimensions",
        "Their dimensions",
        "As the drawing has them: web radius r, rectangle height h, shoulder height H, arc radius R, arc angle, half width w, shoulder angle.",
        vec![
            words("weight", shapes.iter().map(|shape| shape.names.to_owned())),
            length("thickness", |d| d.thickness),
            length("r", |d| d.shape.web_radius),
            length("h", |d| d.shape.rectangle_height),
            length("H", |d| d.shape.shoulder_height),
            length("R", |d| d.shape.arc_radius),
            numbers("arc", "deg", of(|d| d.shape.arc_angle.to_degrees()), 5),
            length("w", |d| d.shape.half_width()),
            numbers("shoulder", "deg", of(|d| d.shoulder_angle.to_degrees()), 4),
        ],
    )
}

/// The designs of a front, numbered from 1.
pub fn front_designs_table(front: &Front) -> Table {
    let of = |value: fn(&Design) -> f64| front.designs.iter().map(value);
    let [first, second] = front.objectives.map(objective_name);
    Table::of_columns(
        "counterweight-front",
        format!("From the least {first} to the least {second}"),
        format!("No shape has less {first} without more {second}."),
        vec![
            words("no.", (1..=front.designs.len()).map(|k| k.to_string())),
            numbers("mass", "g", of(|d| 1e3 * d.mass), 5),
            numbers("swept radius", "mm", of(|d| 1e3 * d.swept_radius), 5),
            numbers("inertia", "kg mm²", of(|d| 1e6 * d.inertia), 5),
            numbers("thickness", "mm", of(|d| 1e3 * d.thickness), 4),
            numbers("r", "mm", of(|d| 1e3 * d.shape.web_radius), 4),
            numbers("h", "mm", of(|d| 1e3 * d.shape.rectangle_height), 4),
            numbers("H", "mm", of(|d| 1e3 * d.shape.shoulder_height), 4),
            numbers("R", "mm", of(|d| 1e3 * d.shape.arc_radius), 4),
            numbers("arc", "deg", of(|d| d.shape.arc_angle.to_degrees()), 5),
        ],
    )
}

/// The nearest value of each limit at which a design exists; `names` are the weights.
pub fn nearest_limits_table(names: &str, infeasible: &Infeasible) -> Table {
    let rows = infeasible.nearest.iter().map(|near| {
        let (name, unit, factor) = match near.limit {
            Limit::Mass => ("mass, at most", "g", 1e3),
            Limit::SweptRadius => ("swept radius, at most", "mm", 1e3),
            Limit::Inertia => ("inertia, at most", "kg mm²", 1e6),
            Limit::Thickness => ("thickness, at most", "mm", 1e3),
            Limit::HalfWidth => ("half width, at most", "mm", 1e3),
            Limit::Balance => ("balance, at least", "%", 100.0),
        };
        let value = |value: f64| Cell::text(format!("{} {unit}", number::terminal(value * factor, 3)));
        vec![Cell::text(name), value(near.asked), value(near.nearest)]
    });
    Table {
        id: "nearest-limits",
        title: format!("No shape meets all limits: {names}"),
        note: "For each limit alone: the nearest value at which there is a shape, all others as they are."
            .to_owned(),
        remark: match infeasible.nearest.is_empty() {
            true => "No single limit is in the way: widen ranges of dimensions.".to_owned(),
            false => String::new(),
        },
        columns: ["limit", "asked for", "nearest"].map(Column::words).into(),
        rows: rows.collect(),
    }
}
