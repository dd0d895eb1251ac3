//! One bay of a crankshaft solved again on a finer mesh: its table.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, numbers, words};
use lanchester_flex::crank_case::PeakStress;
use lanchester_flex::mesh::MeshQuality;
use lanchester_flex::sparse::SolveReport;
use serde::Serialize;

/// A fillet of a submodel.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SubmodelFillet {
    /// "pin 2 at web 3".
    pub name: String,
    /// Radius [m].
    pub radius: f64,
    /// Largest stress on the mesh of the whole crankshaft, over all cases.
    pub whole: PeakStress,
    /// Largest stress on the finer mesh, over all cases.
    pub stress: PeakStress,
    /// Place of the case in which it is, from 0.
    pub case: usize,
}

/// What lies between the middles of two main journals, meshed again with more elements across its fillets and solved with the displacements of the
/// whole crankshaft on its cuts.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StressSubmodel {
    /// Number of the throw whose bay it is, from 1.
    pub throw: usize,
    /// Where both cuts lie along z [m].
    pub cuts: [f64; 2],
    /// Edge of the elements away from fillets [m].
    pub size: f64,
    /// Elements across the 90 degrees of a fillet.
    pub fillet_elements: usize,
    /// The quality of its mesh.
    pub quality: MeshQuality,
    /// How its equations were solved.
    pub solve: SolveReport,
    /// Largest difference of the von Mises stress between both meshes on the cuts, over the largest stress of a fillet of the bay, of all cases.
    pub cut_difference: f64,
    /// Its fillets, along z.
    pub fillets: Vec<SubmodelFillet>,
}

impl StressSubmodel {
    /// The fillet with the largest stress.
    pub fn worst(&self) -> Option<&SubmodelFillet> {
        self.fillets.iter().max_by(|a, b| a.stress.von_mises.total_cmp(&b.stress.von_mises))
    }

    /// The sentence that matters most. `safety`: the words that go behind a stress [Pa].
    pub(crate) fn lead(&self, safety: impl Fn(f64) -> String) -> Option<String> {
        let worst = self.worst()?;
        Some(format!(
            "The bay of throw {} again with {} elements across its fillets: {} MPa at {}{}; {} MPa there on the mesh of the whole.",
            self.throw,
            self.fillet_elements,
            number::short(1e-6 * worst.stress.von_mises, 4),
            worst.name,
            safety(worst.stress.von_mises),
            number::short(1e-6 * worst.whole.von_mises, 4)
        ))
    }

    /// Its table.
    pub(crate) fn table(&self) -> Table {
        let note = format!(
            "Between z {:.1} and {:.1} mm, the middles of the main journals beside it: {} nodes, smallest scaled Jacobian {:.2}; {} unknowns, residual {:.1e}. \
             On its cuts it has the displacements of the whole crankshaft; there the stress of both meshes differs by up to {:.1} % of the largest one of its \
             fillets. Largest von Mises stress of each fillet over all cases, on the mesh of the whole and on its own.",
            1e3 * self.cuts[0],
            1e3 * self.cuts[1],
            number::whole(self.quality.nodes as u128),
            self.quality.least_jacobian,
            number::whole(self.solve.unknowns as u128),
            self.solve.residual,
            100.0 * self.cut_difference
        );
        let own = &self.fillets;
        let with =
            |column: Column, of: &dyn Fn(&SubmodelFillet) -> Cell| (column, own.iter().map(of).collect());
        Table::of_columns(
            "stress-submodel",
            "Submodel",
            note,
            vec![
                words("fillet", own.iter().map(|fillet| fillet.name.clone())),
                numbers("radius", "mm", own.iter().map(|fillet| 1e3 * fillet.radius), 3),
                numbers("whole", "MPa", own.iter().map(|fillet| 1e-6 * fillet.whole.von_mises), 4),
                numbers("submodel", "MPa", own.iter().map(|fillet| 1e-6 * fillet.stress.von_mises), 4),
                with(Column::numbers("jump", "%"), &|fillet| Cell::Number {
                    value: 100.0 * fillet.stress.jump,
                    decimals: 1,
                }),
                with(Column::numbers("angle", "deg"), &|fillet| Cell::Number {
                    value: fillet.stress.angle.to_degrees(),
                    decimals: 0,
                }),
                with(Column::numbers("case", ""), &|fillet| Cell::Number {
                    value: (fillet.case + 1) as f64,
                    decimals: 0,
                }),
            ],
        )
    }
}
