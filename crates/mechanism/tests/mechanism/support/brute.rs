//! The same loads a second way: bodies placed by plane geometry, momentum and energy differentiated numerically.
//!
//! Nothing of the crate under test is used. A rod with a given inertia is a rigid body at its centre of gravity, not
//! two masses and a correction.

use lanchester_model::*;
use std::f64::consts::TAU;

type Vector = [f64; 2];

/// A rigid body: mass, place of its centre at an angle of crankshaft 1, plane, inertia and its angle.
struct Body {
    mass: f64,
    z: f64,
    inertia: f64,
    place: Vector,
    angle: f64,
}

fn polar(size: f64, angle: f64) -> Vector {
    [size * angle.cos(), size * angle.sin()]
}

fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1]]
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

fn times(factor: f64, a: Vector) -> Vector {
    [factor * a[0], factor * a[1]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Where the circle of radius `length` about `big_end` cuts the line through `on` along `u`, on the far side.
fn piston_pin(big_end: Vector, length: f64, on: Vector, u: Vector) -> Vector {
    let from = minus(on, big_end);
    let half = dot(from, u);
    let along = -half + (half * half - dot(from, from) + length * length).sqrt();
    plus(on, times(along, u))
}

/// Big end, small end, and centre of the piston of cylinder `index`.
pub fn joints(engine: &Engine, index: usize, theta: f64) -> [Vector; 3] {
    let cylinder = &engine.cylinders[index];
    let throw = &engine.throws[cylinder.throw];
    let crankshaft = &engine.crankshafts[throw.crankshaft];
    let axis = [crankshaft.x, crankshaft.y];
    let turned = crankshaft.ratio.value() * theta + crankshaft.phase + throw.angle;
    let crankpin = plus(axis, polar(throw.radius, turned));
    let big_end = match cylinder.rod.joint {
        RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
            let [_, pin, _] = joints(engine, master, theta);
            let line = minus(pin, crankpin);
            plus(crankpin, polar(knuckle_radius, line[1].atan2(line[0]) + knuckle_angle))
        }
        _ => crankpin,
    };
    let u = polar(1.0, cylinder.angle);
    let v = [-u[1], u[0]];
    let on = plus(axis, times(cylinder.offset + cylinder.pin_offset, v));
    let small_end = piston_pin(big_end, cylinder.rod.length, on, u);
    let centre = minus(small_end, times(cylinder.pin_offset, v));
    [big_end, small_end, centre]
}

/// All moving bodies at `theta`.
fn bodies(engine: &Engine, theta: f64) -> Vec<Body> {
    let mut bodies = Vec::new();
    let point = |mass, z, place| Body { mass, z, inertia: 0.0, place, angle: 0.0 };
    // An unbalance is a mass at a metre with as much opposite on the axis: only its momentum counts.
    let mut turning = |axis: Vector, z: f64, unbalance: f64, angle: f64| {
        bodies.push(point(unbalance, z, plus(axis, polar(1.0, angle))));
        bodies.push(point(-unbalance, z, axis));
    };
    for throw in &engine.throws {
        let crankshaft = &engine.crankshafts[throw.crankshaft];
        let angle = crankshaft.ratio.value() * theta + crankshaft.phase + throw.angle;
        turning([crankshaft.x, crankshaft.y], throw.z, throw.unbalance, angle);
    }
    for weight in &engine.counterweights {
        let crankshaft = &engine.crankshafts[weight.crankshaft];
        let angle = crankshaft.ratio.value() * theta + crankshaft.phase + weight.angle;
        turning([crankshaft.x, crankshaft.y], weight.z, weight.unbalance, angle);
    }
    for shaft in &engine.shafts {
        for weight in &shaft.weights {
            turning(
                [shaft.x, shaft.y],
                weight.z,
                weight.unbalance,
                shaft.ratio.value() * theta + weight.phase,
            );
        }
    }
    for (index, cylinder) in engine.cylinders.iter().enumerate() {
        let [big_end, small_end, piston] = joints(engine, index, theta);
        let (rod, z) = (&cylinder.rod, cylinder.z);
        bodies.push(point(cylinder.piston_mass, z, piston));
        match rod.inertia {
            None => {
                bodies.push(point(rod.big_end_mass, z, big_end));
                bodies.push(point(rod.small_end_mass, z, small_end));
            }
            Some(inertia) => {
                let share = rod.small_end_mass / (rod.big_end_mass + rod.small_end_mass);
                let line = minus(small_end, big_end);
                bodies.push(Body {
                    mass: rod.big_end_mass + rod.small_end_mass,
                    z,
                    inertia,
                    place: plus(big_end, times(share, line)),
                    // The rod never turns right over, so its angle from the cylinder axis has no jump.
                    angle: {
                        let u = polar(1.0, cylinder.angle);
                        (u[0] * line[1] - u[1] * line[0]).atan2(dot(u, line))
                    },
                });
            }
        }
    }
    bodies
}

/// Central difference of eighth order.
fn derivative<const N: usize>(step: f64, f: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut sum = [0.0; N];
    for (k, weight) in weights.iter().enumerate() {
        let at = (k + 1) as f64 * step;
        let (after, before) = (f(at), f(-at));
        for n in 0..N {
            sum[n] += weight * (after[n] - before[n]) / step;
        }
    }
    sum
}

/// Step of the differences [rad]: their error and the rounding are both below 1e-10 of the loads for l >= 1.5 (r + e).
const STEP: f64 = 6e-3;

/// Momentum `P_x, P_y`, its moments `z P_x, z P_y`, spin about the reference axis, and energy, at `theta`.
fn momentum(engine: &Engine, reference: [f64; 3], theta: f64, speed: f64) -> [f64; 6] {
    let count = bodies(engine, theta).len();
    let now = bodies(engine, theta);
    let mut sum = [0.0; 6];
    // All bodies move at once: one difference for the whole list.
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut rates = vec![[0.0; 3]; count];
    for (k, weight) in weights.iter().enumerate() {
        let at = (k + 1) as f64 * STEP;
        let (after, before) = (bodies(engine, theta + at), bodies(engine, theta - at));
        for (rate, (a, b)) in rates.iter_mut().zip(after.iter().zip(&before)) {
            rate[0] += speed * weight * (a.place[0] - b.place[0]) / STEP;
            rate[1] += speed * weight * (a.place[1] - b.place[1]) / STEP;
            rate[2] += speed * weight * (a.angle - b.angle) / STEP;
        }
    }
    for (body, [vx, vy, spin]) in now.iter().zip(rates) {
        let (x, y) = (body.place[0] - reference[0], body.place[1] - reference[1]);
        let z = body.z - reference[2];
        sum[0] += body.mass * vx;
        sum[1] += body.mass * vy;
        sum[2] += body.mass * z * vx;
        sum[3] += body.mass * z * vy;
        sum[4] += body.mass * (x * vy - y * vx) + body.inertia * spin;
        sum[5] += 0.5 * (body.mass * (vx * vx + vy * vy) + body.inertia * spin * spin);
    }
    sum
}

/// Kinetic energy of all moving bodies [J] at `theta`.
pub fn energy(engine: &Engine, theta: f64, speed: f64) -> f64 {
    momentum(engine, [0.0; 3], theta, speed)[5]
}

/// Loads on the block and torque at crankshaft 1, in the order of `Components`.
pub fn loads(engine: &Engine, reference: [f64; 3], theta: f64, speed: f64) -> [f64; 6] {
    let rate = derivative(STEP, |at| momentum(engine, reference, (theta + at) % (1e6 * TAU), speed));
    let [px, py, zx, zy, spin, energy] = rate.map(|r| r * speed);
    let torque = -energy / speed;
    // The block feels minus the change of momentum; M = r x F has M_x = -z F_y and M_y = z F_x.
    [-px, -py, zy, -zx, -torque - spin, torque]
}
