//! A balance shaft as solids: its weights with the shaft within them, and the shaft between them.

use crate::export::PlacedPart;
use lanchester_model::BalanceShaft;
use lanchester_shape::{Contour, GeometryError, Outline, Part, Point};

/// A shorter bar between two weights is none [m].
const TOUCH: f64 = 1e-9;

/// The solids of a balance shaft as it stands at `theta = 0`, in the frame of the engine: each weight that has a shape with the piece of
/// the shaft within it, and between one weight and the next the shaft, as thick as the thinner end. Weights without a shape are left out.
///
/// # Errors
/// Where a shape is not possible.
pub fn shaft_solids(shaft: &BalanceShaft) -> Result<Vec<PlacedPart>, GeometryError> {
    let axis = Point::new(shaft.x, shaft.y);
    let mut shaped: Vec<_> = shaft
        .weights
        .iter()
        .enumerate()
        .filter_map(|(index, weight)| Some((index, weight, weight.part.as_ref()?)))
        .collect();
    let mut solids = Vec::new();
    for (index, weight, part) in &shaped {
        let outline = part.shape.outline()?.turned(weight.phase).moved(axis);
        let solid = Part::new(outline, part.length, part.density)?;
        solids.push(PlacedPart::new(shaft.weight_name(*index), solid).moved(weight.z));
    }
    shaped.sort_by(|a, b| a.1.z.total_cmp(&b.1.z));
    for pair in shaped.windows(2) {
        let [(_, one, front), (_, other, rear)] = pair else { continue };
        let (from, to) = (one.z + front.length / 2.0, other.z - rear.length / 2.0);
        if to - from <= TOUCH {
            continue;
        }
        let radius = front.shape.shaft_radius.min(rear.shape.shaft_radius);
        let outline = Outline::from(Contour::circle(axis, radius)?);
        let bar = Part::new(outline, to - from, front.density)?;
        solids.push(PlacedPart::new(format!("{} bar", shaft.name), bar).moved((from + to) / 2.0));
    }
    Ok(solids)
}
