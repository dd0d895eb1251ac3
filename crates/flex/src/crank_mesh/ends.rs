//! Steps of nose and flange, beyond the end journals.

use lanchester_model::{CrankElement, CrankElementForm, Engine};
use std::f64::consts::FRAC_PI_4;

/// Which steps beyond the end journals are meshed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ends {
    All,
    Flange,
    None,
}

impl Ends {
    /// Whether a step is meshed.
    pub fn has(self, element: &CrankElement) -> bool {
        match element.form {
            CrankElementForm::Flange { .. } => self != Ends::None,
            _ => self == Ends::All,
        }
    }
}

/// Whether a crankshaft has steps beyond its end journals.
pub(super) fn has_ends(engine: &Engine, index: usize) -> bool {
    engine.crank_elements(index).is_ok_and(|elements| elements.iter().any(is_end))
}

/// A step of nose or flange.
pub(super) fn is_end(element: &CrankElement) -> bool {
    matches!(element.form, CrankElementForm::Nose { .. } | CrankElementForm::Flange { .. })
}

/// Mass by which the steps of nose and flange that are meshed, their bores filled, and those that are not differ from the body [kg].
pub(super) fn end_mass(elements: &[CrankElement], ends: Ends) -> f64 {
    let of = |element: &CrankElement| {
        let bar = element.bar()?;
        let mass = |area: f64| element.density * FRAC_PI_4 * area * element.length();
        Some(match ends.has(element) {
            true => mass(bar.bore.powi(2)),
            false => -mass(bar.diameter.powi(2) - bar.bore.powi(2)),
        })
    };
    elements.iter().filter(|element| is_end(element)).filter_map(of).sum()
}
