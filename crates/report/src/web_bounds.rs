//! What fits on the webs of free weights, as a table.

use crate::table::{Table, numbers, words};

/// The bound of a free weight by what its web holds.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundedWeight<'a> {
    /// Its name.
    pub name: &'a str,
    /// The largest unbalance that fits [kg m].
    pub most: f64,
    /// What was found [kg m].
    pub found: f64,
    /// Direction in which it fits, at angle zero [rad].
    pub direction: f64,
    /// What keeps a shape from more: "clearance to piston 1, thickness".
    pub limits: String,
}

/// The bounds of free weights by what their webs hold; `by_default` where no bound was asked for.
pub fn web_bounds_table(weights: &[BoundedWeight<'_>], by_default: bool) -> Table {
    let degrees = |weight: &BoundedWeight| weight.direction.to_degrees().rem_euclid(360.0);
    let note = match by_default {
        true => "The file has [crank.body] and [counterweight_design], so that no web gets more than fits.",
        false => "The largest unbalance of the shapes of [counterweight_design] on each web.",
    };
    Table::of_columns(
        "web-bounds",
        "What fits on the webs",
        note,
        vec![
            words("weight", weights.iter().map(|weight| weight.name.to_owned())),
            numbers("found", "kg mm", weights.iter().map(|weight| 1e3 * weight.found), 5),
            numbers("fits", "kg mm", weights.iter().map(|weight| 1e3 * weight.most), 5),
            numbers("direction", "deg", weights.iter().map(degrees), 5),
            words("limited by", weights.iter().map(|weight| weight.limits.clone())),
        ],
    )
}
