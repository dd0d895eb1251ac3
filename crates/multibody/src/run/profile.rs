//! What a profile of imposed speed does until a run is over, before it is run.
//!
//! Between two points the speed runs straight, before the first and behind the last it is theirs. Angles are those that the profile gives: against the
//! ground a block that rolls takes its own part of them, for which there must be room.

use crate::error::MultibodyError;
use crate::simulation::{Duration, FAST, straight};
use std::f64::consts::TAU;

/// A share of the angle until standstill: the last of it takes ever longer.
const NEARLY: f64 = 1e-9;

/// What a profile does until a run is over.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub(super) struct Course {
    /// Angle that is turned, forwards and backwards [rad].
    pub turned: f64,
    /// Angle that would be turned at the sampling speed of every piece [rad]: samples are as many as steps fit in it.
    pub sampled: f64,
}

/// Course of a profile; a run of revolutions needs it to reach `beyond` [rad] farther.
///
/// # Errors
/// [`MultibodyError::StandsStill`] where a run of revolutions never ends.
pub(super) fn course(
    profile: &[[f64; 2]],
    duration: Duration,
    beyond: f64,
) -> Result<Course, MultibodyError> {
    let target = match duration {
        Duration::Revolutions(wanted) => TAU * wanted + beyond,
        Duration::Time(_) => f64::INFINITY,
    };
    let (mut course, mut angle) = (Course::default(), 0.0);
    let (mut furthest, mut at) = (0.0, 0.0);
    for [[from, begins], [to, ends]] in pieces(profile) {
        let rate = if to.is_finite() { (ends - begins) / (to - from) } else { 0.0 };
        // A speed that changes its sign is 0 in between.
        if begins > 0.0 && ends <= 0.0 && to.is_finite() {
            let until = begins / -rate;
            let there = angle + 0.5 * until * begins;
            if there > furthest {
                (furthest, at) = (there, from + until);
            }
        }
        let until = match duration {
            Duration::Time(end) => end - from,
            Duration::Revolutions(_) => time_to(target * (1.0 + NEARLY) - angle, begins, rate),
        };
        let length = until.min(to - from);
        if length == f64::INFINITY {
            let Duration::Revolutions(wanted) = duration else { break };
            return Err(MultibodyError::StandsStill { at, turned: furthest / TAU, wanted });
        }
        if length <= 0.0 {
            break;
        }
        let then = begins + rate * length;
        course.turned += match begins * then < 0.0 {
            true => (begins * begins + then * then) / (2.0 * rate.abs()),
            false => 0.5 * (begins + then).abs() * length,
        };
        course.sampled += sampling_speed([begins, ends]) * length;
        angle += 0.5 * (begins + then) * length;
        if until <= to - from {
            break;
        }
    }
    Ok(course)
}

/// Speed at which a step of angle takes the time between two samples, of a piece with these speeds at its ends [rad/s].
pub(super) fn sampling_speed(ends: [f64; 2]) -> f64 {
    ends.into_iter().map(f64::abs).fold(FAST[0], f64::max)
}

/// Pieces of a profile from time 0 on: time and speed at both ends of each; the last one never ends.
fn pieces(profile: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let start = [0.0, straight(profile, 0.0)];
    let knots = profile.iter().copied().filter(|point| point[0] > 0.0);
    let last = profile.last().map(|point| [f64::INFINITY, point[1]]);
    std::iter::once(start).chain(knots.clone()).zip(knots.chain(last)).map(|(from, to)| [from, to])
}

/// Time until an angle ahead is turned, from a speed that changes at a rate; infinite where it never is.
fn time_to(angle: f64, speed: f64, rate: f64) -> f64 {
    let square = speed * speed + 2.0 * rate * angle;
    let sum = speed + square.sqrt();
    // Without a real root the sum is no number.
    if sum > 0.0 { 2.0 * angle / sum } else { f64::INFINITY }
}
