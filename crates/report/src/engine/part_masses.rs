//! What found weights weigh as parts, as a table.

use crate::kit::table::{Cell, Column, Table, numbers, words};

/// A found weight.
#[derive(Debug, Clone, Copy)]
pub struct PartMass<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its unbalance [kg m].
    pub unbalance: f64,
    /// Its mass with its centre at a given radius [kg].
    pub at_radius: Option<f64>,
    /// The mass of its best shape [kg]; none where no shape has the unbalance.
    pub mass: Option<f64>,
}

/// Found weights as parts, with their sum.
pub fn part_masses_table(weights: &[PartMass<'_>]) -> Table {
    let grams =
        |mass: Option<f64>| mass.map_or(Cell::Empty, |mass| Cell::Number { value: 1e3 * mass, decimals: 1 });
    let sum = |of: fn(&PartMass<'_>) -> Option<f64>| weights.iter().map(of).sum::<Option<f64>>();
    let column = |of: fn(&PartMass<'_>) -> Option<f64>| {
        weights.iter().map(move |weight| grams(of(weight))).chain([grams(sum(of))]).collect()
    };
    // Mass times this is the unbalance.
    let centre = |weight: &PartMass<'_>| weight.mass.map(|mass| 1e3 * weight.unbalance / mass);
    let centres = weights
        .iter()
        .map(|weight| centre(weight).map_or(Cell::Empty, |value| Cell::Number { value, decimals: 2 }));
    let is_missing = weights.iter().any(|weight| weight.mass.is_none());
    let mut columns = vec![
        words("weight", weights.iter().map(|weight| weight.name.to_owned()).chain(["all".to_owned()])),
        numbers(
            "unbalance",
            "kg mm",
            weights
                .iter()
                .map(|weight| 1e3 * weight.unbalance)
                .chain([1e3 * weights.iter().map(|w| w.unbalance).sum::<f64>()]),
            5,
        ),
        (Column::numbers("mass", "g"), column(|weight| weight.mass)),
        (Column::numbers("centre", "mm"), centres.chain([Cell::Empty]).collect()),
    ];
    if weights.iter().any(|weight| weight.at_radius.is_some()) {
        columns.push((Column::numbers("at its radius", "g"), column(|weight| weight.at_radius)));
    }
    let mut table = Table::of_columns(
        "part-masses",
        "The weights as parts",
        "Mass of the best shapes that the file allows, a counterweight beyond the disc of its web. The optimum counts unbalance over radius, where `added mass` is asked for.",
        columns,
    );
    if is_missing {
        table.remark = "Where there is no mass, no shape of the ranges has the unbalance: the design of the counterweight tells the nearest limits.".to_owned();
    }
    table
}
