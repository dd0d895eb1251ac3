//! Motion of every cylinder: dead centres, strokes, speeds, rod angles.

use crate::curves::extremes::extremes_over_turn;
use crate::inertia::request::{LoadError, LoadRequest};
use crate::inertia::result::{Articulation, CylinderMotion, MotionTrace};
use crate::train::chamber::chamber_motion;
use crate::train::drive::{Drive, Linkage};
use crate::train::mechanism::{linkage, master_of, period};
use lanchester_model::Engine;
use lanchester_numerics::within_period;
use lanchester_results::Extremes;
use std::f64::consts::{PI, TAU};

/// Share of a period that counts as none.
const SAME: f64 = 1e-14;

/// Angles of a turn that are scanned before extremes are refined, at least and at most.
const SCAN: [usize; 2] = [720, 1 << 16];

/// Dead centres of a linkage, as crank angles from its (master's) axis, and the travel there.
struct DeadCentres {
    top_angle: f64,
    bottom_angle: f64,
    top: f64,
    stroke: f64,
}

impl DeadCentres {
    fn of(linkage: &Linkage, scan: usize) -> DeadCentres {
        let (top_angle, bottom_angle, top, bottom) = match linkage {
            Linkage::Plain(slider) => {
                let [longest, shortest] = [slider.length + slider.radius, slider.length - slider.radius];
                let along = |reach: f64| ((reach - slider.offset) * (reach + slider.offset)).sqrt();
                (slider.top_dead_centre(), slider.bottom_dead_centre(), along(longest), along(shortest))
            }
            Linkage::Articulated(articulated) => {
                let travel = |phi: f64| {
                    let travel = articulated.stroke(phi).travel;
                    (travel[0], travel[1])
                };
                let Extremes { max, min } = extremes_over_turn(scan, travel);
                (max.theta, min.theta, max.value, min.value)
            }
        };
        DeadCentres { top_angle, bottom_angle, top, stroke: top - bottom }
    }
}

/// `angle` moved by whole turns into (-pi, pi].
fn wrapped(angle: f64) -> f64 {
    PI - (PI - angle).rem_euclid(TAU)
}

/// Motion of every cylinder.
///
/// Dead centres, stroke, rod angle and articulation are those of the exact linkage; speeds and accelerations follow
/// the kinematics of the request.
///
/// # Errors
/// [`LoadError`] where a linkage does not turn or the request is impossible.
pub fn motion(engine: &Engine, request: &LoadRequest) -> Result<Vec<CylinderMotion>, LoadError> {
    request.check(engine)?;
    let revolutions = period(engine)?;
    request.check_angles(revolutions)?;
    let count = request.samples * revolutions as usize;
    let step = TAU * f64::from(revolutions) / count as f64;
    let theta: Vec<f64> = (0..count).map(|j| step * j as f64).collect();
    let mut motion = (0..engine.cylinders.len())
        .map(|index| cylinder_motion(engine, request, index, &theta))
        .collect::<Result<Vec<_>, LoadError>>()?;
    for first in 0..motion.len() {
        let pistons = engine.chamber_pistons(first);
        if pistons.len() < 2 || pistons[0] != first {
            continue;
        }
        let chamber = chamber_motion(engine, &pistons, &motion)?;
        // All pistons of a chamber fire at its dead centre, that next to the firing of the first.
        let fires = firing_angle(engine, first, chamber.top_dead_centre);
        for &index in &pistons {
            motion[index].firing_angle = fires;
            motion[index].chamber = Some(chamber.clone());
        }
    }
    Ok(motion)
}

/// The firing angle next to that of the file, where the chamber of a cylinder is at a top dead centre [rad].
fn firing_angle(engine: &Engine, index: usize, top_dead_centre: f64) -> Option<f64> {
    let nominal = engine.cylinders[index].firing_angle?;
    let crankshaft = engine.throws[engine.cylinders[index].throw].crankshaft;
    let turn = TAU / engine.crankshafts[crankshaft].ratio.value().abs();
    let turns = ((nominal - top_dead_centre) / turn).round();
    let cycle = engine.working_cycle(index);
    Some(within_period(top_dead_centre + turns * turn, cycle, SAME * cycle))
}

fn cylinder_motion(
    engine: &Engine,
    request: &LoadRequest,
    index: usize,
    angles: &[f64],
) -> Result<CylinderMotion, LoadError> {
    let cylinder = &engine.cylinders[index];
    let own_linkage = linkage(engine, index)?;
    let drive = Drive::of(own_linkage, request.kinematics, index + 1)?;
    let scan = ((8.0 * TAU / own_linkage.analytic_margin()) as usize).clamp(SCAN[0], SCAN[1]);
    let centres = DeadCentres::of(&own_linkage, scan);

    let master = master_of(cylinder);
    let axis = engine.cylinders[master.unwrap_or(index)].angle;
    let ratio = engine.crankshafts[engine.throws[cylinder.throw].crankshaft].ratio.value();
    let turn = TAU / ratio.abs();
    let phase = engine.pin_angle(cylinder.throw, 0.0) - axis;
    let theta = |phi: f64| within_period((phi - phase) / ratio, turn, SAME * turn);
    let top_dead_centre = theta(centres.top_angle);

    let rate = ratio.abs() * request.speed_of(engine);
    let signed = ratio * request.speed_of(engine);
    let exact = Drive::Exact(own_linkage);
    let mut trace = MotionTrace { theta: angles.to_vec(), ..MotionTrace::default() };
    for theta in angles {
        let phi = ratio * theta + phase;
        let stroke = exact.motion(phi).stroke;
        let [position, ..] = stroke.travel;
        let [_, velocity, acceleration, _] = drive.motion(phi).stroke.travel;
        trace.position.push(position);
        trace.velocity.push(signed * velocity);
        trace.acceleration.push(signed * signed * acceleration);
        trace.rod_angle.push(stroke.rod_angle());
    }
    let over_turn = |derivative: usize| {
        extremes_over_turn(scan, |phi| {
            let travel = drive.motion(phi).stroke.travel;
            (travel[derivative], travel[derivative + 1])
        })
    };
    let (speed, acceleration) = (over_turn(1), over_turn(2));
    let articulation = match (&own_linkage, master) {
        (Linkage::Articulated(articulated), Some(master)) => {
            let reach = extremes_over_turn(scan, |phi| articulated.reach(phi));
            let plain = DeadCentres::of(&Linkage::Plain(articulated.master), scan);
            Some(Articulation {
                master: master + 1,
                max_reach: reach.max.value,
                min_reach: reach.min.value,
                stroke_difference: centres.stroke - plain.stroke,
                top_dead_centre_shift: wrapped(centres.top_angle + axis - cylinder.angle),
            })
        }
        _ => None,
    };
    Ok(CylinderMotion {
        cylinder: index + 1,
        top_dead_centre,
        bottom_dead_centre: theta(centres.bottom_angle),
        stroke: centres.stroke,
        top: centres.top,
        max_speed: rate * speed.max_abs(),
        max_acceleration: rate * rate * acceleration.max.value,
        max_deceleration: -rate * rate * acceleration.min.value,
        max_rod_angle: largest_rod_angle(&own_linkage),
        firing_angle: firing_angle(engine, index, top_dead_centre),
        chamber: None,
        residual_inertia: cylinder.rod.residual_inertia(),
        articulation,
        trace,
    })
}

/// Largest angle of the rod from the cylinder axis [rad].
fn largest_rod_angle(linkage: &Linkage) -> f64 {
    match linkage {
        Linkage::Plain(slider) => ((slider.radius + slider.offset.abs()) / slider.length).asin(),
        Linkage::Articulated(articulated) => articulated.largest_sine().asin(),
    }
}
