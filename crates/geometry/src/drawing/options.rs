//! What the caller says about a drawing, and what is read from it.

use super::{Bore, DrawingError, Place};
use lanchester_shape::Outline;

/// What a reader needs to know beside the file.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawingOptions {
    /// Length of one unit of the drawing [m], 1e-3 for millimetres. It stands above what the file says. Without it the file must say its unit.
    pub unit: Option<f64>,
    /// Ends of loose lines and arcs that lie at most this far apart are joined in their middle [m].
    pub gap: f64,
    /// Layers whose entities are left out. In SVG: groups or elements of this `id` or Inkscape label.
    pub leave_out: Vec<String>,
}

impl Default for DrawingOptions {
    /// The unit of the file, gaps up to a thousandth of a millimetre, all layers.
    fn default() -> DrawingOptions {
        DrawingOptions { unit: None, gap: 1e-6, leave_out: Vec::new() }
    }
}

impl DrawingOptions {
    /// Whether unit and gap are possible.
    pub(super) fn checked(&self) -> Result<(), DrawingError> {
        if let Some(unit) = self.unit
            && !(1e-12..=1e6).contains(&unit)
        {
            return Err(DrawingError::Unit { got: unit });
        }
        if !(0.0..=1.0).contains(&self.gap) {
            return Err(DrawingError::Gap { got: self.gap });
        }
        Ok(())
    }
}

/// Something of the file that is not in the outline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ignored {
    /// What it is and where.
    pub entity: Place,
    /// Why it is not needed.
    pub why: &'static str,
}

/// What a file holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// The outline, its origin that of the drawing.
    pub outline: Outline,
    /// Length of one unit of the drawing [m].
    pub unit: f64,
    /// Bores that are no holes of the outline (slugs, blind bores), of a drawing that was written here.
    pub bores: Vec<Bore>,
    /// What was left out, in the order of the file.
    pub ignored: Vec<Ignored>,
}
