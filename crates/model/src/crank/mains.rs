//! Where the main bearings of a crankshaft stand.

use crate::engine_parts::{EngineParts, Throw};

/// Without webs in the file: throws closer than this many crank radii leave no room for two webs and a main bearing
/// between them.
const CLOSEST: f64 = 1.25;

/// Where the file gives webs: facing webs of two throws closer than this share of the web distance are one web, or
/// leave no room for a main bearing, which is about as long as a pin.
const NARROWEST: f64 = 0.5;

impl EngineParts {
    /// Planes of the main bearings of crankshaft `crankshaft` [m], rising, at least two; empty for a crankshaft without
    /// throws.
    ///
    /// Those that the file gives, or else the usual ones: one midway between neighbouring throws, and one at each end,
    /// as far beyond the last throw as the next main is before it. Throws with no room for a main between them (pins
    /// of a split pair, of a boxer with one web between two pins) count as one: their facing webs are closer than half a
    /// web distance or, where the file gives no webs, the throws are closer than 1.25 crank radii. The mains beside a lone throw stand one web distance
    /// from it, or 1.25 crank radii where the file gives no webs.
    pub fn main_planes(&self, crankshaft: usize) -> Vec<f64> {
        if let Some(mains) = self.crankshafts.get(crankshaft).and_then(|c| c.mains.as_ref()) {
            return mains.clone();
        }
        let mut throws: Vec<&Throw> = self.throws.iter().filter(|t| t.crankshaft == crankshaft).collect();
        throws.sort_by(|a, b| a.z.total_cmp(&b.z));
        let (Some(first), Some(last)) = (throws.first(), throws.last()) else { return Vec::new() };
        let gaps: Vec<[&Throw; 2]> =
            throws.windows(2).map(|pair| [pair[0], pair[1]]).filter(|[a, b]| has_room(a, b)).collect();
        let inner: Vec<f64> = gaps.iter().map(|[a, b]| 0.5 * (a.z + b.z)).collect();
        let [front, rear] = match (gaps.first(), gaps.last()) {
            (Some([front, _]), Some([_, rear])) => {
                // The end throws stand in the middle between their mains.
                [first.z + front.z - inner[0], rear.z + last.z - inner[inner.len() - 1]]
            }
            _ => [first.z - reach(first), last.z + reach(last)],
        };
        std::iter::once(front).chain(inner).chain([rear]).collect()
    }

    /// Crankshaft (from 0) and plane [m] of every main bearing: those of crankshaft 1 first, each from the free end on.
    pub fn main_bearings(&self) -> Vec<(usize, f64)> {
        let of = |crankshaft: usize| self.main_planes(crankshaft).into_iter().map(move |z| (crankshaft, z));
        (0..self.crankshafts.len()).flat_map(of).collect()
    }
}

/// Distance of the mains from a throw that has no neighbours [m].
fn reach(throw: &Throw) -> f64 {
    throw.webs.map_or(CLOSEST * throw.radius, |[front, rear]| rear - front)
}

/// Whether a main bearing may stand between two neighbouring throws.
fn has_room(front: &Throw, rear: &Throw) -> bool {
    match (front.webs, rear.webs) {
        (Some([start, end]), Some([next, next_end])) => {
            next - end >= NARROWEST * (end - start).max(next_end - next)
        }
        _ => rear.z - front.z > CLOSEST * front.radius.max(rear.radius),
    }
}
