//! Ties between the crankshaft and its bearings: motion, force, and how the force follows the crankshaft's acceleration within a stage.

use super::body::CrankBody;
use super::motion::Turn;
use super::parts::CrankTrain;
use super::plane::{ONE, Plane, QUARTER, Square, inverse, plus, product, sum, times};
use crate::sparse::dot;

/// What a tie joins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// A journal and its housing.
    Main(usize),
    /// A pin and a big end with coordinates of its own, from this component of the state on.
    Free(usize, usize),
    /// A pin and a big end in one point.
    Joined(usize),
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Tie {
    pub kind: Kind,
    pub surface: usize,
    pub centre: Plane,
}

/// Where a tie is: place, velocity, acceleration of the crankshaft's side in the block's frame.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Moving {
    pub place: Plane,
    pub velocity: Plane,
    pub acceleration: Plane,
}

/// A tie within an iteration.
#[derive(Debug, Clone, Copy)]
pub(super) struct Linear {
    pub force: Plane,
    pub slope: Square,
    pub constant: Plane,
    /// Of a free big end: -(B - J_b)^-1 (r_b, J_p).
    pub big_end: (Plane, Square),
}

/// Motion of the crankshaft's side of a tie.
pub(super) fn moving(
    body: &CrankBody,
    tie: &Tie,
    turn: &Turn,
    frame: &Square,
    [q, v, k]: [&[f64]; 3],
) -> Moving {
    let rows = &body.rows[tie.surface];
    let [u, rate, second] = [q, v, k].map(|vector| [dot(&rows[0], vector), dot(&rows[1], vector)]);
    let at = plus(tie.centre, 1.0, u);
    let turned = times(&QUARTER, at);
    let velocity = plus(rate, turn.speed, turned);
    let acceleration = plus(
        plus(plus(second, 2.0 * turn.speed, times(&QUARTER, rate)), turn.acceleration, turned),
        -turn.speed * turn.speed,
        at,
    );
    Moving {
        place: times(frame, at),
        velocity: times(frame, velocity),
        acceleration: times(frame, acceleration),
    }
}

/// Force of a tie and its linear part for changes of the crankshaft's acceleration in the block's frame.
pub(super) fn linear(
    train: &CrankTrain,
    tie: &Tie,
    turn: &Turn,
    theta: f64,
    g: f64,
    at: &Moving,
    [y, k]: [&[f64]; 2],
) -> Option<Linear> {
    // Change of place, velocity and acceleration of the crankshaft's side by that of its acceleration in the turning frame.
    let by_place = g * g;
    let by_velocity = sum(g, &ONE, g * g * turn.speed, &QUARTER);
    let through = |slope_place: &Square, slope_velocity: &Square| {
        sum(by_place, slope_place, 1.0, &product(slope_velocity, &by_velocity))
    };
    match tie.kind {
        Kind::Main(index) => {
            let law = &train.mains[index].law;
            let own = law.force(at.place, at.velocity, 0.5 * turn.speed)?;
            Some(Linear {
                force: own.force,
                slope: through(&own.by_place, &own.by_velocity),
                constant: [0.0; 2],
                big_end: ([0.0; 2], [[0.0; 2]; 2]),
            })
        }
        Kind::Joined(index) => {
            let own = &train.cylinders[index];
            let state = own.slider.state(at.place, at.velocity, at.acceleration, own.gas.at(theta))?;
            let inertia = times(&state.mass, at.acceleration);
            let by_acceleration = sum(
                1.0,
                &sum(1.0 - g * g * turn.speed * turn.speed, &ONE, 2.0 * g * turn.speed, &QUARTER),
                g * g * turn.acceleration,
                &QUARTER,
            );
            let slope = sum(
                -1.0,
                &product(&state.mass, &by_acceleration),
                -1.0,
                &through(&state.by_place, &state.rest_by_velocity),
            );
            Some(Linear {
                force: [-inertia[0] - state.rest[0], -inertia[1] - state.rest[1]],
                slope,
                constant: [0.0; 2],
                big_end: ([0.0; 2], [[0.0; 2]; 2]),
            })
        }
        Kind::Free(index, start) => {
            let own = &train.cylinders[index];
            let [place, velocity] = [[y[start], y[start + 1]], [y[start + 2], y[start + 3]]];
            let acceleration = [k[start + 2], k[start + 3]];
            let state = own.slider.state(place, velocity, acceleration, own.gas.at(theta))?;
            let e = plus(at.place, -1.0, place);
            let rate = plus(at.velocity, -1.0, velocity);
            let law = own.law.force(e, rate, 0.5 * (turn.speed + state.swing))?;
            let inertia = times(&state.mass, acceleration);
            let rest = [0, 1].map(|i| inertia[i] + state.rest[i] + law.force[i]);
            let pin = through(&law.by_place, &law.by_velocity);
            let end = sum(g * g, &law.by_place, g, &law.by_velocity);
            let own_slope =
                sum(1.0, &sum(1.0, &state.mass, g, &state.rest_by_velocity), g * g, &state.by_place);
            let solved = inverse(&sum(1.0, &own_slope, -1.0, &end));
            let shift = times(&solved, rest).map(|v| -v);
            let follow = sum(-1.0, &product(&solved, &pin), 0.0, &ONE);
            // df = J_p w - J_b dk_b with dk_b = shift + follow w.
            let slope = sum(1.0, &pin, -1.0, &product(&end, &follow));
            let constant = times(&end, shift).map(|v| -v);
            Some(Linear { force: law.force, slope, constant, big_end: (shift, follow) })
        }
    }
}
