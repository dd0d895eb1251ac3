//! Where the block stands at rest: its mounts carry the weight, with pistons and rods as they are at the start, and the reaction to the load.
//!
//! ```text
//! SUM F_mount + SUM m g = 0        SUM R a x F_mount + SUM R c x m g - T R z = 0        F_mount = SUM u (P - k u.d)        d = r + R a - a
//! ```
//! | symbol | name                                                              | unit |
//! |--------|-------------------------------------------------------------------|------|
//! | r, R   | displacement of the block's origin, its turn                      | m, 1 |
//! | a, u   | place of a mount in the block, one of its directions in the ground | m, 1 |
//! | k, P   | stiffness and preload along it                                    | N/m, N |
//! | c, m   | place and mass of block, piston or rod; of an unbalance their product | m, kg |
//! | T      | torque of the load at the start speed, where it acts from the ground | N m |
//!
//! Solved by Newton's iteration with differences: mounts are linear, the turn of the block is not.

use super::Builder;
use super::numbers::{apply, cross, linkage, rotation};
use super::request::{EngineBlock, EngineStart, load_at};
use lanchester_numerics::Lu;
use num_complex::Complex64;

/// Newton's iterations.
const ITERATIONS: usize = 20;

/// Step of the differences [m] and [rad].
const STEP: f64 = 1e-7;

/// A matrix with a smaller ratio of its pivots leaves the block a motion that nothing resists.
const FREE: f64 = 1e-12;

/// Displacement of the origin and turn as a rotation vector.
type Turned = [f64; 6];

impl Builder<'_> {
    /// The start at rest; as drawn where nothing holds the block.
    pub(crate) fn at_rest(&self) -> EngineStart {
        if !self.has_mounts() {
            return EngineStart::default();
        }
        // In the plane: x, y and roll.
        let free: &[usize] =
            if self.request.block == EngineBlock::Plane { &[0, 1, 5] } else { &[0, 1, 2, 3, 4, 5] };
        let first = self.weighed();
        let mut turned: Turned = [0.0; 6];
        for _ in 0..ITERATIONS {
            let here = self.unbalanced(&turned, &first);
            let size = free.len();
            let mut slope = vec![0.0; size * size];
            for (column, own) in free.iter().enumerate() {
                let mut beside = turned;
                beside[*own] += STEP;
                let there = self.unbalanced(&beside, &first);
                for (row, of) in free.iter().enumerate() {
                    slope[row * size + column] = (there[*of] - here[*of]) / STEP;
                }
            }
            let mut step: Vec<f64> = free.iter().map(|own| -here[*own]).collect();
            let Some(factors) = Lu::new(size, slope).ok().filter(|factors| factors.pivot_ratio() > FREE)
            else {
                return EngineStart::default();
            };
            factors.solve(&mut step);
            for (own, step) in free.iter().zip(&step) {
                turned[*own] += step;
            }
            if step.iter().all(|step| step.abs() < 1e-15) {
                break;
            }
        }
        if turned.iter().any(|value| !value.is_finite()) {
            return EngineStart::default();
        }
        EngineStart {
            position: [turned[0], turned[1], turned[2]],
            orientation: quaternion([turned[3], turned[4], turned[5]]),
            ..EngineStart::default()
        }
    }

    /// Mass of everything that weighs, and its first moment about the origin in the axes of the block.
    fn weighed(&self) -> (f64, [f64; 3]) {
        let (engine, theta) = (self.engine, self.request.start_angle);
        let mut mass = self.numbers.block_mass;
        let mut first = self.numbers.block_centre.map(|centre| mass * centre);
        let mut add = |own: f64, at: [f64; 3]| {
            mass += own;
            for k in 0..3 {
                first[k] += own * at[k];
            }
        };
        for (index, cylinder) in engine.cylinders.iter().enumerate() {
            let shaft = &engine.crankshafts[engine.throws[cylinder.throw].crankshaft];
            let linkage = linkage(engine, index, theta);
            let (sin, cos) = cylinder.angle.sin_cos();
            add(
                cylinder.piston_mass,
                [
                    shaft.x + linkage.travel * cos - cylinder.offset * sin,
                    shaft.y + linkage.travel * sin + cylinder.offset * cos,
                    cylinder.z,
                ],
            );
            let share = self.numbers.cylinders[index].rod_centre;
            let [x, y] =
                [0, 1].map(|k| linkage.lower_pin[k] + share * (linkage.piston_pin[k] - linkage.lower_pin[k]));
            add(cylinder.rod.mass(), [shaft.x + x, shaft.y + y, cylinder.z]);
        }
        // Rotors weigh within the block; their unbalances shift its centre.
        let mut unbalance = Complex64::ZERO;
        for (index, throw) in engine.throws.iter().enumerate() {
            unbalance += throw.unbalance * Complex64::from_polar(1.0, engine.pin_angle(index, theta));
        }
        for weight in &engine.counterweights {
            let shaft = &engine.crankshafts[weight.crankshaft];
            let turned = shaft.phase + shaft.ratio.value() * theta;
            unbalance += Complex64::from_polar(weight.unbalance, turned + weight.angle);
        }
        for shaft in engine.geared_shafts() {
            for weight in &shaft.weights {
                unbalance +=
                    Complex64::from_polar(weight.unbalance, weight.phase + shaft.ratio.value() * theta);
            }
        }
        (mass, [first[0] + unbalance.re, first[1] + unbalance.im, first[2]])
    }
}

impl Builder<'_> {
    /// Force and moment about the displaced origin on the block at rest, axes of the ground.
    fn unbalanced(&self, turned: &Turned, (mass, first): &(f64, [f64; 3])) -> Turned {
        let position = [turned[0], turned[1], turned[2]];
        let turn = rotation(quaternion([turned[3], turned[4], turned[5]]));
        let gravity = self.numbers.gravity.map(|part| self.request.gravity * part);
        let mut force = gravity.map(|part| mass * part);
        let mut moment = cross(apply(turn, *first), gravity);
        for mount in &self.engine.mounts {
            let Some(spring) = &mount.spring else { continue };
            let at = [mount.x, mount.y, mount.z];
            let arm = apply(turn, at);
            let moved = [0, 1, 2].map(|k| position[k] + arm[k] - at[k]);
            for (way, axis) in spring.axes.iter().enumerate() {
                let preload = if way == 0 { spring.preload } else { 0.0 };
                let along: f64 = (0..3).map(|k| axis[k] * moved[k]).sum();
                let own = axis.map(|part| part * (preload - spring.stiffness[way] * along));
                let about = cross(arm, own);
                for k in 0..3 {
                    force[k] += own[k];
                    moment[k] += about[k];
                }
            }
        }
        if !self.request.load.reacts_on_block {
            let ratio: f64 = self.request.driveline.iter().map(|link| link.ratio).product();
            let torque = load_at(
                &self.request.load.torque,
                ratio * self.request.speed,
                ratio * self.request.start_angle,
            );
            for k in 0..3 {
                moment[k] -= turn[k][2] * torque;
            }
        }
        [force[0], force[1], force[2], moment[0], moment[1], moment[2]]
    }
}

/// The unit quaternion of a rotation vector, real part first.
fn quaternion(vector: [f64; 3]) -> [f64; 4] {
    let angle = vector.iter().map(|part| part * part).sum::<f64>().sqrt();
    let (sin, cos) = (0.5 * angle).sin_cos();
    let share = if angle > 0.0 { sin / angle } else { 0.5 };
    [cos, share * vector[0], share * vector[1], share * vector[2]]
}
