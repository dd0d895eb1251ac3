//! Bending moment of a crankshaft under all that turns with it, with the derivative by one input (book, eq. 32.12).
//!
//! ```text
//! M(z) = i SUM over loads of g(z, z_k) F_k        g(z, z_k) = arm(z_k) - share_a arm(z_a) - share_b arm(z_b)        arm(x) = min(x - z, 0)
//! ```
//! a, b: the end mains, which carry what the loads do not hold in balance. It turns with the shaft and runs straight between loads, so that
//! it is largest in the plane of a load or of a main bearing. Each plane is a candidate by itself, though others lie in it: when one moves
//! they part, and an arm bends where two planes meet, so that derivatives differ on both sides.

use super::mains::planes;
use super::over_time::known;
use super::slope::Grown;
use super::train::{Train, Vector};
use super::wave::SAME_HEIGHT;
use lanchester_task::Varied;
use num_dual::{Dual64, DualNum};

/// Planes closer than this are one [m].
const SAME_PLANE: f64 = 1e-9;

/// A plane of a crankshaft, by its place in the list of its loads and mains.
pub(super) type BendingSpot = (usize, usize);

/// Where the moments of these crankshafts are largest, and how large.
pub(super) fn bending_spots(train: &Train<'_>, crankshafts: &[usize]) -> (f64, Vec<BendingSpot>) {
    let all: Vec<(f64, BendingSpot)> = crankshafts
        .iter()
        .flat_map(|&crankshaft| {
            let moments = moments(train, crankshaft).into_iter().enumerate();
            moments.map(move |(plane, [x, y])| (x.re.hypot(y.re), (crankshaft, plane)))
        })
        .collect();
    let best = all.iter().map(|(size, _)| *size).fold(0.0, f64::max);
    let largest = all.into_iter().filter(|(size, _)| *size >= best * (1.0 - SAME_HEIGHT));
    (best, largest.map(|(_, spot)| spot).collect())
}

/// Slope of the largest moment, which stands at these places.
pub(super) fn bending_slope(train: &Train<'_>, spots: &[BendingSpot], nothing: f64) -> Grown {
    Grown::of_largest(spots.iter().map(|&(crankshaft, plane)| {
        let moment = moments(train, crankshaft)[plane];
        Grown::of_size(&moment, nothing)
    }))
}

/// Loads that turn with a crankshaft, at `theta = 0`: plane and force.
fn loads(train: &Train<'_>, crankshaft: usize) -> Vec<(Dual64, Vector)> {
    let engine = train.engine;
    let turning = train.turning_on_cranks(known(0.0), |_, _| true).into_iter();
    let own = turning.filter(|turning| turning.crankshaft == crankshaft);
    let turning =
        own.map(|turning| (turning.z, turning.direction.map(|along| -turning.unbalance * along.v2)));
    let rods = engine.cylinders.iter().enumerate().filter_map(|(index, cylinder)| {
        let throw = &engine.throws[cylinder.throw];
        let crank = engine.crankshafts.get(crankshaft).filter(|_| throw.crankshaft == crankshaft)?;
        let [big, ..] = train.rod_masses(index);
        let radius = train.part(Varied::CrankRadius, cylinder.throw, throw.radius);
        let angle = train.part(Varied::ThrowAngle, cylinder.throw, throw.angle) + train.phase(crankshaft);
        let speed = train.speed * crank.ratio.value();
        let force = big * radius * speed * speed;
        let z = train.plane(train.part(Varied::CylinderPlane, index, cylinder.z), cylinder.z);
        Some((z, [force * angle.cos(), force * angle.sin()]))
    });
    turning.chain(rods).collect()
}

/// Moments in the planes of all loads, then of all mains; none without mains.
fn moments(train: &Train<'_>, crankshaft: usize) -> Vec<Vector> {
    let mains = planes(train, crankshaft);
    let (Some(&front), Some(&rear)) = (mains.first(), mains.last()) else { return Vec::new() };
    let loads = loads(train, crankshaft);
    let sections: Vec<Dual64> = loads.iter().map(|(z, _)| *z).chain(mains).collect();
    let sign = train.side.sign();
    let moment = |section: Dual64| {
        let arm = |z: Dual64| {
            let apart = z - section;
            let is_before = if apart.re.abs() > SAME_PLANE { apart.re < 0.0 } else { sign * apart.eps < 0.0 };
            if is_before { apart } else { known(0.0) }
        };
        let zero = [known(0.0); 2];
        loads.iter().fold(zero, |sum, (z, [x, y])| {
            let share = (*z - front) / (rear - front);
            let influence = arm(*z) - arm(front) * (known(1.0) - share) - arm(rear) * share;
            [sum[0] - influence * y, sum[1] + influence * x]
        })
    };
    sections.into_iter().map(moment).collect()
}
