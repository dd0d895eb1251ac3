//! The block at rest on its mounts under weight and the mean torque of the load.

use crate::run::runner::Runner;
use nalgebra::{Matrix6, UnitQuaternion, Vector3, Vector6};

/// Newton's iterations: mounts are linear, only the turn of the block is not.
const ITERATIONS: usize = 20;

/// Step of the differences [m] and [rad].
const STEP: f64 = 1e-7;

/// Places the block where its mounts carry the weight, with the pistons as they are, and the reaction to the load; as drawn where nothing holds it.
pub(crate) fn place(runner: &mut Runner<'_>) {
    if !runner.powered.on_mounts() {
        return;
    }
    let mut turned = Vector6::zeros();
    for _ in 0..ITERATIONS {
        let here = unbalanced(runner, &turned);
        let mut slope = Matrix6::zeros();
        for k in 0..6 {
            let mut beside = turned;
            beside[k] += STEP;
            slope.set_column(k, &((unbalanced(runner, &beside) - here) / STEP));
        }
        let Some(step) = slope.lu().solve(&-here) else { break };
        if !step.iter().all(|value| value.is_finite()) {
            break;
        }
        turned += step;
        if step.amax() < 1e-14 {
            break;
        }
    }
    let at = runner.powered.layout.pose();
    let (position, orientation) = pose(&turned);
    runner.state[at..at + 3].copy_from_slice(position.as_slice());
    runner.state[at + 3..at + 7].copy_from_slice(&orientation);
    let mut motion = crate::motion::Motion::fixed(runner.state[0], 0.0);
    (motion.position, motion.orientation) = (position, orientation);
    let places: Vec<Vector3<f64>> = runner.powered.mounts(&motion).map(|now| now.displacement).collect();
    let mut at = runner.powered.layout.relaxing();
    for (mount, displacement) in runner.powered.train.mounts.iter().zip(places) {
        let count = mount.branches();
        mount.settle(displacement, &mut runner.state[at..at + count]);
        at += count;
    }
}

fn pose(turned: &Vector6<f64>) -> (Vector3<f64>, [f64; 4]) {
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(turned[3], turned[4], turned[5]));
    (Vector3::new(turned[0], turned[1], turned[2]), [turn.w, turn.i, turn.j, turn.k])
}

/// Force and moment about the origin on the block at rest, axes of the frame.
fn unbalanced(runner: &mut Runner<'_>, turned: &Vector6<f64>) -> Vector6<f64> {
    let powered = &mut runner.powered;
    let theta = runner.state[0];
    let mut places = std::mem::take(&mut powered.places);
    powered.train.places_into(theta, &mut places);
    let (position, orientation) = pose(turned);
    let mut motion = crate::motion::Motion::fixed(theta, 0.0);
    (motion.position, motion.orientation) = (position, orientation);
    let equations = powered.train.equations(&motion, &places);
    powered.places = places;
    let rotation = motion.rotation();
    let first = Vector3::new(equations.mass[1][5], equations.mass[2][3], equations.mass[0][4]);
    let gravity = powered.gravity();
    let mut force = equations.mass[0][0] * gravity;
    let mut moment = (rotation * first).cross(&gravity);
    for mount in powered.mounts(&motion) {
        force += mount.force;
        moment += mount.arm.cross(&mount.force);
    }
    // The driveline takes the load's torque off the block: the block feels its reaction about the crank axis.
    if powered.simulation.load.reacts_on == crate::simulation::ReactsOn::Ground {
        let ratio: f64 = powered.simulation.driveline.iter().map(|link| link.ratio).product();
        let speed = ratio * powered.simulation.start_speed;
        let torque = crate::simulation::load_torque(&powered.simulation.load.law, speed, ratio * theta)
            + powered.conditions.demand;
        moment -= rotation * Vector3::z() * torque;
    }
    Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
}
