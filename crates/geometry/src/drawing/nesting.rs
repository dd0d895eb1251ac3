//! Closed chains as an outline: the largest is the outer contour, the others are its holes.

use super::strand::{Chain, Strand, chains};
use super::{Drawing, DrawingError, Ignored, Place, SMALLEST};
use lanchester_shape::Contour;
use lanchester_shape::Edge;
use lanchester_shape::Outline;
use lanchester_shape::{ContourPlace, GeometryError};

/// The drawing of these strands, whose loose ends are joined within `gap` [m]; `unit` [m] is that of the file.
pub(super) fn drawing(
    strands: Vec<Strand>,
    gap: f64,
    unit: f64,
    ignored: Vec<Ignored>,
) -> Result<Drawing, DrawingError> {
    let chains = chains(strands, gap)?;
    let mut contours =
        chains.iter().map(|chain| contour(chain, gap)).collect::<Result<Vec<(Contour, Place)>, _>>()?;
    let areas = contours.iter().map(|(contour, _)| contour.moments().area);
    let largest = areas.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
    let Some((largest, _)) = largest else {
        return Err(DrawingError::NoContour { left_out: ignored.len() });
    };
    let (outer, outer_place) = contours.remove(largest);
    let (holes, hole_places): (Vec<Contour>, Vec<Place>) = contours.into_iter().unzip();
    let place = |which: ContourPlace| match which {
        ContourPlace::Outer => outer_place.clone(),
        ContourPlace::Hole(number) => hole_places[number - 1].clone(),
    };
    let outline = Outline::new(outer, holes).map_err(|error| match error {
        GeometryError::HoleOutside { hole, within: ContourPlace::Outer, .. } => {
            DrawingError::SeveralOuter { first: outer_place.clone(), second: place(ContourPlace::Hole(hole)) }
        }
        GeometryError::HoleOutside { hole, within, .. } => {
            DrawingError::Island { inner: place(ContourPlace::Hole(hole)), hole: place(within) }
        }
        GeometryError::ContoursCross { first, second, .. } => {
            let mut entities = vec![place(first), place(second)];
            entities.dedup();
            DrawingError::Outline { entities, error }
        }
        error => DrawingError::Outline { entities: vec![outer_place.clone()], error },
    })?;
    Ok(Drawing { outline, unit, bores: Vec::new(), ignored })
}

/// The contour of a chain, turned to run anticlockwise, and the entity that the chain begins with.
fn contour(chain: &Chain, gap: f64) -> Result<(Contour, Place), DrawingError> {
    let edges: Vec<Edge> = chain.iter().map(|(edge, _)| *edge).collect();
    let contour = match Contour::from_edges(&edges, gap) {
        Err(GeometryError::InsideOut { .. }) => {
            let reversed: Vec<Edge> = edges.iter().rev().map(Edge::reversed).collect();
            Contour::from_edges(&reversed, gap)
        }
        other => other,
    };
    let begin = chain[0].1.clone();
    if contour.as_ref().is_ok_and(|contour| contour.size() < SMALLEST) {
        return Err(DrawingError::TooSmall { entity: begin });
    }
    contour.map(|contour| (contour, begin.clone())).map_err(|error| {
        let numbers = match error {
            GeometryError::Crossing { first, second, .. } => vec![first, second],
            GeometryError::Open { edge, next, .. } => vec![edge, next],
            GeometryError::ZeroLength { edge, .. } | GeometryError::NotFinite { edge } => vec![edge],
            _ => vec![1],
        };
        let mut entities: Vec<Place> = numbers.iter().map(|number| chain[number - 1].1.clone()).collect();
        entities.dedup();
        DrawingError::Contour { entities, error }
    })
}
