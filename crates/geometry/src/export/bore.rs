//! Bores of a part: what inserts and holes take out of it, as cavities.

use super::{ExportError, RESOLUTION};
use lanchester_shape::Point;
use lanchester_shape::{Insert, Part};

/// A piece of a bore with one radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step {
    /// Its radius [m].
    pub radius: f64,
    /// Where it begins, from the front face [m].
    pub from: f64,
    /// Where it ends, from the front face [m].
    pub to: f64,
}

/// A cavity: steps on one axis that follow each other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Bore {
    /// Its axis [m].
    pub centre: Point,
    /// Its steps along z, each beginning where the one before ends, no two neighbours of one radius.
    pub steps: Vec<Step>,
    /// Whether it opens at the front face.
    pub opens_in_front: bool,
    /// Whether it opens at the rear face.
    pub opens_behind: bool,
}

impl Bore {
    /// With a further step behind the last.
    fn extend(&mut self, radius: f64, to: f64, opens_behind: bool) {
        self.opens_behind = opens_behind;
        let last = self.steps.len() - 1;
        let end = self.steps[last].to;
        if (self.steps[last].radius - radius).abs() <= RESOLUTION {
            self.steps[last].to = to;
        } else {
            self.steps.push(Step { radius, from: end, to });
        }
    }
}

/// The cavities of a part.
///
/// # Errors
/// Where a wall beside an insert is too thin, or inserts touch that are not on one axis.
pub(super) fn bores(name: &str, part: &Part) -> Result<Vec<Bore>, ExportError> {
    let thickness = part.thickness();
    let mut inserts: Vec<_> = part.inserts().iter().collect();
    inserts.sort_by(|a, b| a.from.total_cmp(&b.from));
    let mut bores: Vec<Bore> = Vec::new();
    for insert in inserts {
        let wall = part.outline().nearest(insert.centre).0 - insert.radius;
        if wall < RESOLUTION {
            return Err(ExportError::NoWall { part: name.to_string(), at: insert.centre, wall });
        }
        let (opens_in_front, opens_behind) = open_ends(insert, thickness);
        let from = if opens_in_front { 0.0 } else { insert.from };
        let to = if opens_behind { thickness } else { insert.to };
        let mut follows = None;
        for (number, bore) in bores.iter().enumerate() {
            let distance = (bore.centre - insert.centre).norm();
            for (at, step) in bore.steps.iter().enumerate() {
                let apart =
                    distance >= step.radius + insert.radius + RESOLUTION || step.to < from - RESOLUTION;
                if apart {
                    continue;
                }
                let behind = at + 1 == bore.steps.len() && step.to <= from + RESOLUTION;
                if distance > RESOLUTION || !behind || follows.is_some() {
                    let (first, second) = (bore.centre, insert.centre);
                    return Err(ExportError::InsertsTouch { part: name.to_string(), first, second });
                }
                follows = Some(number);
            }
        }
        match follows {
            Some(number) => bores[number].extend(insert.radius, to, opens_behind),
            None => bores.push(Bore {
                centre: insert.centre,
                steps: vec![Step { radius: insert.radius, from, to }],
                opens_in_front,
                opens_behind,
            }),
        }
    }
    Ok(bores)
}

/// Whether an insert begins at the front face and ends at the rear face of a part of this thickness.
pub(super) fn open_ends(insert: &Insert, thickness: f64) -> (bool, bool) {
    (insert.from < RESOLUTION, insert.to > thickness - RESOLUTION)
}
