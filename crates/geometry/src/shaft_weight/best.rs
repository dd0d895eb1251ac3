//! The lightest, the shortest, the one of least radius.
//!
//! Of the shapes of [`ShaftWeightShape`] with the density `rho` and the length `L`, `U = rho L S(R, c)` and `m = rho L A(R, c) = U A/S`. What follows is
//! derived in the book, eqs. (22.55) to (22.59): `S` grows with `R` and falls with `|c|`; `A/S` falls with `R` and with `c`, also along
//! a line of equal `S`. Each optimum is therefore at the end of a range, or where a range of another dimension ends, and found by
//! halving a monotonous function: no search, nothing to prove beyond.

use super::FirstMoment;
use super::design::{ShaftWeightDesign, ShaftWeightOutcome};
use super::inertia::least_inertia;
use super::nearest::{for_less, for_more};
use lanchester_numerics::last_holding;
use lanchester_shape::GeometryError;
use lanchester_task::{Range, ShaftWeightAim, ShaftWeightTask};

/// The best weight of `task` with this unbalance [kg m].
///
/// # Errors
/// Where a number has no meaning.
pub fn best_shaft_weight(
    unbalance: f64,
    task: &ShaftWeightTask,
) -> Result<ShaftWeightOutcome, GeometryError> {
    if !(unbalance > 0.0 && unbalance.is_finite()) {
        return Err(GeometryError::Number {
            quantity: "unbalance [kg m]",
            needed: "positive",
            got: unbalance,
            hint: "give the unbalance of the shaft's weight",
        });
    }
    if let Some(fault) = task.faults().into_iter().next() {
        return Err(fault.error);
    }
    let first = FirstMoment { task };
    let nearest = first.nearest_chord();
    let line = unbalance / task.density;
    // First moments that go with the ends of the range of length; rounding must not refuse what is just possible.
    let room = 1.0 + 1e-12;
    let (fewest, most) = (line / task.length.most / room, line / task.length.least * room);
    let widest = first.of(task.radius.most, nearest);
    let narrowest = first.of(task.radius.least, first.farthest_chord());
    if widest < fewest || narrowest > most {
        return Ok(ShaftWeightOutcome::Infeasible {
            least: task.density * task.length.least * narrowest,
            most: task.density * task.length.most * widest,
            nearest: if widest < fewest { for_more(unbalance, task) } else { for_less(unbalance, task) },
        });
    }
    let (radius, chord) = match task.minimise {
        ShaftWeightAim::Mass => lightest(&first, task.radius, [fewest, most]),
        ShaftWeightAim::Length => {
            let largest = widest.clamp(fewest, most);
            lightest(&first, task.radius, [largest, largest])
        }
        ShaftWeightAim::Radius => {
            let enough = |radius: f64| first.of(radius, nearest) >= fewest;
            let Range { least, most: largest } = task.radius;
            let radius =
                if enough(least) { least } else { last_holding(|radius| !enough(radius), least, largest) };
            lightest(&first, Range::fixed(radius), [fewest, most])
        }
        ShaftWeightAim::Inertia => least_inertia(&first, [fewest, most]),
    };
    let shape = first.shape(radius, chord);
    let length = (line / shape.moments().first.x).clamp(task.length.least, task.length.most);
    Ok(ShaftWeightOutcome::Best(ShaftWeightDesign::new(shape, length, task.density)))
}

/// Radius and chord of the lightest weight whose first moment lies between two values: the largest chord for which there is a
/// radius, and then the largest radius.
fn lightest(first: &FirstMoment<'_>, radii: Range, [fewest, most]: [f64; 2]) -> (f64, f64) {
    let Range { least: low, most: high } = first.task.chord;
    let enough = |chord: f64| first.of(radii.most, chord) >= fewest;
    let few = |chord: f64| first.of(radii.least, chord) <= most;
    let chord = if !enough(high) {
        // Too little that far out: nearer to the axis.
        last_holding(enough, first.nearest_chord(), high)
    } else if few(high) {
        high
    } else {
        // Too much even with the least radius: over to the far side, where metal is taken back.
        last_holding(|chord| !few(chord), (-high.abs()).max(low), low)
    };
    let fits = |radius: f64| first.of(radius, chord) <= most;
    let radius = if fits(radii.most) { radii.most } else { last_holding(fits, radii.least, radii.most) };
    (radius, chord)
}
