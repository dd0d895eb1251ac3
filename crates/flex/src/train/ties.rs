//! Ties between the crankshaft and its bearings: motion, force, and how the force follows the crankshaft's acceleration within a stage.
//!
//! A pin `p` off the axis turns about it with the shaft, by the rotation `chi` of its surface: to second order it stays on its circle.
//!
//! ```text
//! u = C q - chi^2 p/2    chi = Z q    w = E (C, Z) q'    E = (1, -chi p)                                               (book, eq. 51.15)
//! ```

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
    /// `R E`.
    pub lever: Lever,
}

/// From changes of displacement and rotation of a surface, in the crankshaft's frame, to that of its middle in the block's frame.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Lever(pub [[f64; 3]; 2]);

impl Lever {
    /// Change of the middle.
    pub fn times(&self, [x, y, turn]: [f64; 3]) -> Plane {
        self.0.map(|[a, b, c]| a * x + b * y + c * turn)
    }

    /// Forces on displacement and rotation of a force at the middle.
    pub fn back(&self, [x, y]: Plane) -> [f64; 3] {
        let [a, b] = self.0;
        std::array::from_fn(|k| a[k] * x + b[k] * y)
    }
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
    let turns = [q, v, k].map(|vector| dot(&body.turns[tie.surface], vector));
    let [u, rate, second] = on_its_circle(tie.centre, [u, rate, second], turns);
    let at = plus(tie.centre, 1.0, u);
    let turned = times(&QUARTER, at);
    let velocity = plus(rate, turn.speed, turned);
    let acceleration = plus(
        plus(plus(second, 2.0 * turn.speed, times(&QUARTER, rate)), turn.acceleration, turned),
        -turn.speed * turn.speed,
        at,
    );
    let inwards = times(frame, tie.centre).map(|p| -turns[0] * p);
    Moving {
        place: times(frame, at),
        velocity: times(frame, velocity),
        acceleration: times(frame, acceleration),
        lever: Lever([0, 1].map(|k| [frame[k][0], frame[k][1], inwards[k]])),
    }
}

/// Displacement, rate and second derivative of a pin at `p` that turns about the axis, from straight ones and from its rotation.
fn on_its_circle(
    p: Plane,
    [u, rate, second]: [Plane; 3],
    [turn, turn_rate, turn_second]: [f64; 3],
) -> [Plane; 3] {
    [
        plus(u, -0.5 * turn * turn, p),
        plus(rate, -turn * turn_rate, p),
        plus(second, -(turn * turn_second + turn_rate * turn_rate), p),
    ]
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::train::plane::{length, turn};

    #[test]
    fn a_pin_that_turns_about_the_axis_keeps_its_distance() {
        let p = [0.03, -0.04];
        for angle in [1e-3, 1e-2] {
            let along = times(&QUARTER, p).map(|part| angle * part);
            let [u, ..] = on_its_circle(p, [along, [0.0; 2], [0.0; 2]], [angle, 0.0, 0.0]);
            let left = plus(plus(p, 1.0, u), -1.0, times(&turn(angle), p));
            // Third order is left: angle^3/6 across, angle^4/24 along.
            assert!(length(left) < 0.2 * angle.powi(3) * 0.05, "{angle}: {left:?}");
        }
    }

    #[test]
    fn rates_on_the_circle_are_those_of_differences() {
        let p = [0.02, 0.05];
        // Displacement and rotation over time, of any shape, with two derivatives.
        let [straight, turns]: [&dyn Fn(f64) -> [[f64; 3]; 3]; 2] = [
            &|t| {
                let (sin, cos) = (3.0 * t).sin_cos();
                [
                    [1e-3 * sin, 8e-4 * cos, 0.0],
                    [3e-3 * cos, -2.4e-3 * sin, 0.0],
                    [-9e-3 * sin, -7.2e-3 * cos, 0.0],
                ]
            },
            &|t| {
                let (sin, cos) = (2.0 * t).sin_cos();
                [[0.01 * sin, 0.0, 0.0], [0.02 * cos, 0.0, 0.0], [-0.04 * sin, 0.0, 0.0]]
            },
        ];
        let at =
            |t: f64| on_its_circle(p, straight(t).map(|[x, y, _]| [x, y]), turns(t).map(|[turn, ..]| turn));
        let (t, h) = (0.37, 1e-4);
        let ([_, v, k], [before, v_before, _], [after, v_after, _]) = (at(t), at(t - h), at(t + h));
        let central = |a: Plane, b: Plane| [0, 1].map(|i| (b[i] - a[i]) / (2.0 * h));
        assert!(length(plus(v, -1.0, central(before, after))) < 1e-7 * length(v));
        assert!(length(plus(k, -1.0, central(v_before, v_after))) < 1e-7 * length(k));
    }
}
