//! The same on three meshes: what it tends to, with a band.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, words};
use lanchester_flex::richardson::Extrapolated;
use serde::Serialize;

/// A mesh of a convergence study.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ConvergenceMesh {
    /// Edge of the elements away from fillets [m].
    pub size: f64,
    /// Elements across the 90 degrees of a fillet.
    pub fillet_elements: usize,
    /// Nodes.
    pub nodes: usize,
    /// Unknowns.
    pub unknowns: usize,
}

/// A number on three meshes.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ConvergedNumber {
    /// What it is.
    pub name: String,
    /// Its unit in the tables.
    pub unit: String,
    /// SI units in one of the tables.
    pub scale: f64,
    /// Values in SI units, extrapolated.
    pub found: Extrapolated,
}

/// A convergence study.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Convergence {
    /// The meshes, the coarse one first.
    pub meshes: [ConvergenceMesh; 3],
    /// The numbers.
    pub numbers: Vec<ConvergedNumber>,
    /// Why the meshes are as fine as they are, where nobody says it.
    pub note: Option<String>,
}

impl Convergence {
    /// Its table.
    pub(crate) fn table(&self) -> Table {
        let numbers = &self.numbers;
        let value = |own: &ConvergedNumber, value: f64| number::short(value / own.scale, 4);
        let on = |k: usize| numbers.iter().map(move |own| value(own, own.found.values[k]));
        let band = numbers.iter().map(|own| {
            let (middle, band) = (own.found.value / own.scale, own.found.band / own.scale);
            let percent = 100.0 * (band / middle).abs();
            format!(
                "{} ± {} ({} %)",
                number::short(middle, 4),
                number::short(band, 2),
                number::short(percent, 2)
            )
        });
        let order = numbers.iter().map(|own| match own.found.order {
            Some(order) => Cell::Number { value: order, decimals: 1 },
            None => Cell::text("none"),
        });
        let meshes = self.meshes.iter().map(|mesh| {
            format!(
                "{} mm with {} across a fillet, {} nodes",
                number::short(1e3 * mesh.size, 3),
                mesh.fillet_elements,
                number::whole(mesh.nodes as u128)
            )
        });
        let note = format!(
            "Elements of {}. Value: Richardson's extrapolation to elements of size zero by the order that the three meshes show, from 0.5 to 6; band: 1.25 times \
             its distance from the fine mesh. Where they show no order: the value of the fine mesh, band three times the largest difference.{}",
            meshes.collect::<Vec<_>>().join("; of "),
            self.note.as_ref().map_or(String::new(), |note| format!(" {note}"))
        );
        Table::of_columns(
            "stress-convergence",
            "Convergence",
            note,
            vec![
                words("number", numbers.iter().map(|own| own.name.clone())),
                words("unit", numbers.iter().map(|own| own.unit.clone())),
                words("coarse", on(0)),
                words("middle", on(1)),
                words("fine", on(2)),
                (Column::numbers("order", ""), order.collect()),
                words("value ± band", band),
            ],
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_flex::richardson::richardson;

    #[test]
    fn a_number_has_its_three_meshes_and_its_band() {
        let mesh = |size: f64| ConvergenceMesh { size, fillet_elements: 4, nodes: 12_000, unknowns: 36_000 };
        let sizes = [0.009, 0.006, 0.004];
        let number = ConvergedNumber {
            name: "case 1: energy".to_owned(),
            unit: "J".to_owned(),
            scale: 1.0,
            // An error of second order.
            found: richardson(sizes, sizes.map(|size| 2.0 - 1e4 * size * size)),
        };
        let found = Convergence { meshes: sizes.map(mesh), numbers: vec![number], note: None };
        let text = found.table().text();
        for words in ["Convergence", "case 1: energy", "1.19", "1.64", "1.84", "2.0", "2.000 ± 0.20 (10.0 %)"]
        {
            assert!(text.contains(words), "{words}: {text}");
        }
    }
}
