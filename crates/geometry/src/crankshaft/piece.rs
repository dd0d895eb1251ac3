//! The pieces of a crankshaft before they are joined, each as a solid of its own.

use super::CrankshaftError;
use super::element::{Element, SectionKind, elements, shape};
use crate::export::PlacedPart;
use lanchester_model::Engine;
use lanchester_shape::Part;

/// A journal, a pin, a web or a counterweight of a crankshaft as if it stood alone, for pictures that tell them apart.
#[derive(Debug, Clone, PartialEq)]
pub struct CrankshaftPiece {
    /// What it is.
    pub kind: SectionKind,
    /// Index of the throw that it belongs to; none for journals and weights beside the webs.
    pub throw: Option<usize>,
    /// Index of the engine's counterweight that it is.
    pub weight: Option<usize>,
    /// The solid. Frame: [`crate::crankshaft`]. It overlaps others where the file has them overlap.
    pub placed: PlacedPart,
}

/// The pieces of crankshaft `index`: journals and pins along z, then plain webs, then counterweights in the order of the engine.
///
/// # Errors
/// As [`super::crankshaft`], but for outlines that cannot be joined.
pub fn crankshaft_pieces(engine: &Engine, index: usize) -> Result<Vec<CrankshaftPiece>, CrankshaftError> {
    let is_own = |weight: &usize| {
        engine.counterweights[*weight].crankshaft == index && engine.counterweights[*weight].part.is_some()
    };
    let mut weights = (0..engine.counterweights.len()).filter(is_own);
    let piece = |element: Element| {
        let Element { name, kind, throw, faces: [from, to], outline, density, part } = element;
        let (placed, weight) = match part {
            Some((part, turn)) => {
                let z = from - part.faces()[0];
                (PlacedPart::new(name, part).turned(turn).moved(z), weights.next())
            }
            None => {
                let plate = Part::new(outline, to - from, density).map_err(|source| shape(&name, source))?;
                (PlacedPart::new(name, plate).moved((from + to) / 2.0), None)
            }
        };
        Ok(CrankshaftPiece { kind, throw, weight, placed })
    };
    elements(engine, index)?.into_iter().map(piece).collect()
}
