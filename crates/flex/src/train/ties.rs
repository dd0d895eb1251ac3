//! Ties between the crankshaft and its bearings: motion, force, and how the force follows the crankshaft's acceleration within a stage.
//!
//! A pin `p` off the axis turns about it with the shaft, by the rotation `chi` of its surface: to second order it stays on its circle. Where a law knows of tilt, the end of the
//! journal counts beside its middle: `u_t = L/2 T q` with the slope `T q` of the surface (book, eq. 51.16).
//!
//! ```text
//! u = C q - chi^2 p/2    chi = Z q    w = E (C, Z) q'    E = (1, -chi p)                                               (book, eq. 51.15)
//! F + k s = 0            e = journal - shell, the shell being s off its place, on the stiffness k of its housing          (book, eq. 51.17)
//! ```

use super::body::CrankBody;
use super::law::SpotForce;
use super::motion::Turn;
use super::parts::CrankTrain;
use super::plane::{ONE, Plane, QUARTER, Square, inverse, plus, product, sum, times};
use super::spot::{Four, Spot, add, apply, flat, left, middle, mixed, through_blocks};
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

/// A shell on the spring of its housing: what the state knows of it is how far it is off its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shell {
    /// The first of its two components of the state.
    pub at: usize,
    /// Stiffness of the housing [N/m].
    pub stiffness: f64,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Tie {
    pub kind: Kind,
    pub surface: usize,
    pub centre: Plane,
    /// Half the length of a bearing in which tilt counts [m], else 0.
    pub half: f64,
    pub shell: Option<Shell>,
    /// Its first row among those of all ties, and its first component among theirs.
    pub row: usize,
    pub part: usize,
}

impl Tie {
    /// Rows of the body that move it: displacement, rotation, slope where tilt counts.
    pub fn rows(&self) -> usize {
        if self.half > 0.0 { 5 } else { 3 }
    }

    /// Components of its motion.
    pub fn parts(&self) -> usize {
        if self.half > 0.0 { 4 } else { 2 }
    }

    /// Journal from shell, of places or of their rates.
    pub fn within(&self, journal: &Spot, big_end: Plane, state: &[f64]) -> Spot {
        let shell = self.shell.map_or([0.0; 2], |own| [state[own.at], state[own.at + 1]]);
        add(journal, -1.0, &[big_end[0] + shell[0], big_end[1] + shell[1], 0.0, 0.0])
    }
}

/// Where a tie is: place, velocity, acceleration of the crankshaft's side in the block's frame.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Moving {
    pub place: Spot,
    pub velocity: Spot,
    /// Of the middle.
    pub acceleration: Plane,
    /// `R E`.
    pub lever: Lever,
}

/// From changes of displacement, rotation and slope of a surface, in the crankshaft's frame, to that of its middle and of its end in the block's frame.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Lever(pub [[f64; 5]; 4]);

impl Lever {
    /// Change of middle and end by that of so many rows.
    pub fn times(&self, rows: &[f64]) -> Spot {
        self.0.map(|own| own.iter().zip(rows).map(|(a, b)| a * b).sum())
    }

    /// Forces on displacement, rotation and slope of forces at middle and end.
    pub fn back(&self, force: &Spot) -> [f64; 5] {
        std::array::from_fn(|k| (0..4).map(|i| self.0[i][k] * force[i]).sum())
    }
}

/// A tie within an iteration.
#[derive(Debug, Clone, Copy)]
pub(super) struct Linear {
    pub force: Spot,
    pub slope: Four,
    pub constant: Spot,
    /// What follows the crankshaft's side by its own equation: big end, shell.
    pub big_end: Follower,
    pub shell: Follower,
}

/// Correction of an unknown that is eliminated: a constant and a part that follows the acceleration of the crankshaft's side.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Follower {
    constant: Plane,
    by: [[f64; 4]; 2],
}

impl Follower {
    pub fn at(&self, w: &Spot) -> Plane {
        let by = apply(&self.by, w);
        plus(self.constant, 1.0, by)
    }
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
    let mut own = Moving {
        place: beside(times(frame, at), [0.0; 2]),
        velocity: beside(times(frame, velocity), [0.0; 2]),
        acceleration: times(frame, acceleration),
        lever: Lever::default(),
    };
    for k in 0..2 {
        own.lever.0[k] = [frame[k][0], frame[k][1], inwards[k], 0.0, 0.0];
    }
    if tie.half > 0.0 {
        let [tilt, rate] = [q, v].map(|vector| body.slope(tie.surface, vector).map(|own| tie.half * own));
        let place = times(frame, tilt);
        let velocity = times(frame, plus(rate, turn.speed, times(&QUARTER, tilt)));
        own.place[2..].copy_from_slice(&place);
        own.velocity[2..].copy_from_slice(&velocity);
        for k in 0..2 {
            own.lever.0[2 + k] = [0.0, 0.0, 0.0, tie.half * frame[k][0], tie.half * frame[k][1]];
        }
    }
    own
}

fn beside(middle: Plane, end: Plane) -> Spot {
    [middle[0], middle[1], end[0], end[1]]
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
    let by_velocity = sum(g, &ONE, g * g * turn.speed, &QUARTER);
    let through = |slope_place: &Four, slope_velocity: &Four| {
        mixed(g * g, slope_place, 1.0, &through_blocks(slope_velocity, &by_velocity))
    };
    let still = Follower::default();
    match tie.kind {
        Kind::Main(index) => {
            let law = &train.mains[index].law;
            let e = tie.within(&at.place, [0.0; 2], y);
            let rate = tie.within(&at.velocity, [0.0; 2], k);
            let own = law.spot_force(&e, &rate, 0.5 * turn.speed)?;
            let pin = through(&own.by_place, &own.by_velocity);
            let yielding = Yielding::new(tie, g, &own, y);
            let slope = yielding.behind(&pin);
            let (constant, shell) = (yielding.force(), yielding.follower(&pin, None));
            Some(Linear { force: own.force, slope, constant, big_end: still, shell })
        }
        Kind::Joined(index) => {
            let own = &train.cylinders[index];
            let state = own.slider.state(
                middle(&at.place),
                middle(&at.velocity),
                at.acceleration,
                own.gas.at(theta),
            )?;
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
                &sum(g * g, &state.by_place, 1.0, &product(&state.rest_by_velocity, &by_velocity)),
            );
            Some(Linear {
                force: beside([0, 1].map(|i| -inertia[i] - state.rest[i]), [0.0; 2]),
                slope: flat(&slope),
                constant: [0.0; 4],
                big_end: still,
                shell: still,
            })
        }
        Kind::Free(index, start) => {
            let own = &train.cylinders[index];
            let [place, velocity] = [[y[start], y[start + 1]], [y[start + 2], y[start + 3]]];
            let acceleration = [k[start + 2], k[start + 3]];
            let state = own.slider.state(place, velocity, acceleration, own.gas.at(theta))?;
            let e = tie.within(&at.place, place, y);
            let rate = tie.within(&at.velocity, velocity, k);
            let law = own.law.spot_force(&e, &rate, 0.5 * (turn.speed + state.swing))?;
            let inertia = times(&state.mass, acceleration);
            let (pin, end) =
                (through(&law.by_place, &law.by_velocity), mixed(g * g, &law.by_place, g, &law.by_velocity));
            let yielding = Yielding::new(tie, g, &law, y);
            let [behind_pin, behind_end] = [&pin, &end].map(|own| yielding.behind(own));
            let more = yielding.force();
            let rest = [0, 1].map(|i| inertia[i] + state.rest[i] + law.force[i] + more[i]);
            let own_slope =
                sum(1.0, &sum(1.0, &state.mass, g, &state.rest_by_velocity), g * g, &state.by_place);
            let from_end = left(&behind_end);
            let solved = inverse(&sum(1.0, &own_slope, -1.0, &[from_end[0], from_end[1]]));
            let constant = times(&solved, rest).map(|v| -v);
            // Rows of the pin's slope that push the big end.
            let by: [[f64; 4]; 2] = [0, 1].map(|i| {
                std::array::from_fn(|j| -solved[i][0] * behind_pin[0][j] - solved[i][1] * behind_pin[1][j])
            });
            let big_end = Follower { constant, by };
            // df = J_p w - J_b dk_b with dk_b = constant + by w.
            let slope: Four = std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    behind_pin[i][j] - from_end[i][0] * by[0][j] - from_end[i][1] * by[1][j]
                })
            });
            let constant = std::array::from_fn(|i| {
                more[i] - from_end[i][0] * constant[0] - from_end[i][1] * constant[1]
            });
            let shell = yielding.follower(&pin, Some((&end, &big_end)));
            Some(Linear { force: law.force, slope, constant, big_end, shell })
        }
    }
}

/// A shell's own equation `F + k s = 0` within an iteration: what its correction `ds' = -B^-1 (F + k s + dF)` does to the force, `dF` being what all else changes.
struct Yielding {
    /// `F + k s`.
    rest: Plane,
    /// B^-1, of `B = g k - E`.
    inverse: Square,
    /// `E = g J_e + J_v`, columns of the middle.
    by_shell: [Plane; 4],
}

impl Yielding {
    fn new(tie: &Tie, g: f64, law: &SpotForce, y: &[f64]) -> Yielding {
        let rigid = Yielding { rest: [0.0; 2], inverse: [[0.0; 2]; 2], by_shell: [[0.0; 2]; 4] };
        let Some(shell) = tie.shell else { return rigid };
        let by_shell = left(&mixed(g, &law.by_place, 1.0, &law.by_velocity));
        let own = sum(g * shell.stiffness, &ONE, -1.0, &[by_shell[0], by_shell[1]]);
        let inverse = inverse(&own);
        // A film that nothing moves knows no velocity: for that instant the shell stands still.
        if !inverse.iter().flatten().all(|value| value.is_finite()) {
            return rigid;
        }
        let rest = [0, 1].map(|i| law.force[i] + shell.stiffness * y[shell.at + i]);
        Yielding { rest, inverse, by_shell }
    }

    /// `E B^-1 x`.
    fn pushed(&self, x: Plane) -> Spot {
        let moved = times(&self.inverse, x);
        self.by_shell.map(|[a, b]| a * moved[0] + b * moved[1])
    }

    /// What the shell's own correction adds to the force.
    fn force(&self) -> Spot {
        self.pushed(self.rest)
    }

    /// Derivatives of the force with the shell following.
    fn behind(&self, own: &Four) -> Four {
        let columns: [Spot; 4] = std::array::from_fn(|j| self.pushed([own[0][j], own[1][j]]));
        std::array::from_fn(|i| std::array::from_fn(|j| own[i][j] + columns[j][i]))
    }

    /// The correction of the shell's rate, with the derivatives of the force by the crankshaft's side and by a big end.
    fn follower(&self, pin: &Four, big_end: Option<(&Four, &Follower)>) -> Follower {
        let mut by = [[0.0; 4]; 2];
        let mut rest = self.rest;
        by.copy_from_slice(&pin[..2]);
        if let Some((end, follows)) = big_end {
            for i in 0..2 {
                for k in 0..2 {
                    rest[i] -= end[i][k] * follows.constant[k];
                    for (j, by) in by[i].iter_mut().enumerate() {
                        *by -= end[i][k] * follows.by[k][j];
                    }
                }
            }
        }
        let constant = times(&self.inverse, rest).map(|v| -v);
        let by = [0, 1]
            .map(|i| std::array::from_fn(|j| -self.inverse[i][0] * by[0][j] - self.inverse[i][1] * by[1][j]));
        Follower { constant, by }
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
