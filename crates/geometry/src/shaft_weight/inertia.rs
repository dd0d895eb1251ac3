//! The weight of least inertia: `J/S` made small, with `J` the polar moment of area (book, eqs. 22.68 to 22.70).
//!
//! `J` grows with `R` and falls with `c`. Nearer to the axis than half a disc (`c >= 0`) `J/S` grows with `R`, so that the least radius that
//! has enough is best for every chord, and one unknown is left. Its range is cut into pieces, each bounded from below by the ends; what
//! cannot hold a better weight is dropped, until nothing is left.

use super::FirstMoment;
use lanchester_numerics::last_holding;
use lanchester_task::Range;

/// No weight has less inertia than the one found by more than this part of it.
const GAP: f64 = 1e-6;
/// Pieces after which the search ends: many times what any task needs.
const MOST_PIECES: usize = 1_000_000;

/// Radius and chord of the weight of least inertia whose first moment lies between two values.
pub(super) fn least_inertia(first: &FirstMoment<'_>, [fewest, most]: [f64; 2]) -> (f64, f64) {
    let Range { least: low, most: high } = first.task.chord;
    let radii = first.task.radius;
    let polar = |radius, chord| first.shape(radius, chord).moments().polar();
    let ratio = |(radius, chord): (f64, f64)| polar(radius, chord) / first.of(radius, chord);
    let few = |chord: f64| first.of(radii.least, chord) <= most;
    if high >= 0.0 && few(high) {
        // Beside the axis, towards the weight: the least radius with enough.
        let radius = |chord: f64| first.radius(fewest, chord).clamp(radii.least, radii.most);
        let enough = |chord: f64| first.of(radii.most, chord) >= fewest;
        let from = low.max(0.0);
        let from = if few(from) { from } else { last_holding(few, high, from) };
        let to = if enough(high) { high } else { last_holding(enough, from, high) };
        let bound = |from: f64, to: f64| polar(radius(from), to) / first.of(radius(from), from);
        let chord = smallest(|chord| ratio((radius(chord), chord)), bound, [from, to]);
        return (radius(chord), chord);
    }
    let top = -high.abs();
    if !few(top) {
        // Too much even with the least radius: over to the far side, where metal is taken back.
        return (radii.least, last_holding(few, low, top));
    }
    let from = first.radius(fewest, top).clamp(radii.least, radii.most);
    let to = first.radius(most, top).clamp(from, radii.most);
    let bound = |from: f64, to: f64| polar(from, top) / first.of(to, top);
    (smallest(|radius| ratio((radius, top)), bound, [from, to]), top)
}

/// Where a function is smallest between two places, within [`GAP`]; `bound` is what it does not get below between two.
fn smallest(value: impl Fn(f64) -> f64, bound: impl Fn(f64, f64) -> f64, [from, to]: [f64; 2]) -> f64 {
    let (mut best, mut at) = (value(from), from);
    let mut look = |place: f64, best: &mut f64| {
        let here = value(place);
        if here < *best {
            (*best, at) = (here, place);
        }
    };
    look(to, &mut best);
    let mut pieces = vec![[from, to]];
    let mut looked = 0;
    while !pieces.is_empty() && looked < MOST_PIECES {
        looked += pieces.len();
        for [from, to] in &pieces {
            look((from + to) / 2.0, &mut best);
        }
        let halves = pieces.iter().flat_map(|[from, to]| {
            let middle = (from + to) / 2.0;
            [[*from, middle], [middle, *to]]
        });
        let is_open = |[from, to]: &[f64; 2]| to > from && bound(*from, *to) < best * (1.0 - GAP);
        pieces = halves.filter(is_open).collect();
    }
    at
}
