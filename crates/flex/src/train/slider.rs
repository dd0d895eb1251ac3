//! Rod and piston, rigid, in the two coordinates of the big end's centre.
//!
//! Along the cylinder `x`, across it `y`, both from the crankshaft's axis; the piston pin stays on the line `y = e`:
//!
//! ```text
//! sin f = (e - y)/l    s = x + l cos f    t = tan f    t' = dt/dy = -1/(l cos^3 f)    t'' = 3 sin f/(l^2 cos^5 f)
//! M = [m, n t; n t, a t^2 + b]    m = m_P + m_R    n = m_P + m_B    a = m_P + m_R (g/l)^2 + I/l^2    b = m_R (1 - g/l)^2 + I/l^2
//! M (x'', y'') + (n t' y'^2, a t t' y'^2) = -(F, F t) - f                                                       (book, eq. 51.6)
//! ```
//! with the gas force `F` on the piston towards the crank, `f` of the big end on the pin, `g` from the big end to the rod's centre of gravity, `m_B` the rod's mass at
//! the small end. From Lagrange's equations of T = m_P s'^2/2 + m_R |g'|^2/2 + I f'^2/2.

use super::plane::{Plane, Square, times, turn, turned};
use serde::{Deserialize, Serialize};

/// A rod with its piston.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Slider {
    /// Direction of the cylinder's axis from the crankshaft [rad].
    pub angle: f64,
    /// Offset of the piston pin's line from the crankshaft's axis, a quarter turn on from that direction [m].
    pub offset: f64,
    /// Length of the rod [m].
    pub length: f64,
    /// Mass of the piston [kg].
    pub piston: f64,
    /// Mass of the rod [kg].
    pub rod: f64,
    /// Distance of the rod's centre of gravity from the big end [m].
    pub centre: f64,
    /// Inertia of the rod about it [kg m^2].
    pub inertia: f64,
}

/// A big end at one instant: what the equation of motion needs, in the block's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SliderState {
    /// M.
    pub mass: Square,
    /// Velocity-dependent forces and the gas, on the left side [N].
    pub rest: Plane,
    /// Derivative of `rest` by velocity.
    pub rest_by_velocity: Square,
    /// Derivative of `M a + rest` by place, for the acceleration that was given.
    pub by_place: Square,
    /// Rate of the rod's direction [rad/s].
    pub swing: f64,
    /// Velocity of the piston away from the crank [m/s].
    pub piston_velocity: f64,
    /// Kinetic energy [J].
    pub energy: f64,
}

impl Slider {
    /// `sin f`, where the rod reaches its line.
    fn sine(&self, across: f64) -> Option<f64> {
        let sine = (self.offset - across) / self.length;
        (sine.abs() < 0.999_999).then_some(sine)
    }

    /// Direction of the rod from big end to piston pin in the block's frame [rad].
    pub fn direction(&self, big_end: Plane) -> f64 {
        let local = times(&turn(-self.angle), big_end);
        self.angle + ((self.offset - local[1]) / self.length).clamp(-1.0, 1.0).asin()
    }

    /// Travel of the piston pin along the cylinder from the crankshaft's axis [m].
    pub fn travel(&self, big_end: Plane) -> f64 {
        let local = times(&turn(-self.angle), big_end);
        let across = self.offset - local[1];
        local[0] + (self.length * self.length - across * across).max(0.0).sqrt()
    }

    /// State of the big end at `place` [m], `velocity` [m/s], with `acceleration` [m/s^2] and gas force [N]; none where the rod does not reach.
    pub(crate) fn state(
        &self,
        place: Plane,
        velocity: Plane,
        acceleration: Plane,
        gas: f64,
    ) -> Option<SliderState> {
        let frame = turn(self.angle);
        let into = turn(-self.angle);
        let [at, v, a] = [place, velocity, acceleration].map(|vector| times(&into, vector));
        let sin = self.sine(at[1])?;
        let cos = (1.0 - sin * sin).sqrt();
        let l = self.length;
        let t = sin / cos;
        let t1 = -1.0 / (l * cos.powi(3));
        let t2 = 3.0 * sin / (l * l * cos.powi(5));
        let share = self.centre / l;
        let whole = self.piston + self.rod;
        let n = self.piston + self.rod * share;
        let square = self.piston + self.rod * share * share + self.inertia / (l * l);
        let rest_mass = self.rod * (1.0 - share).powi(2) + self.inertia / (l * l);
        let mass = [[whole, n * t], [n * t, square * t * t + rest_mass]];
        let rest = [n * t1 * v[1] * v[1] + gas, square * t * t1 * v[1] * v[1] + gas * t];
        let by_velocity = [[0.0, 2.0 * n * t1 * v[1]], [0.0, 2.0 * square * t * t1 * v[1]]];
        let by_place = [
            [0.0, n * t1 * a[1] + n * t2 * v[1] * v[1]],
            [
                0.0,
                n * t1 * a[0]
                    + 2.0 * square * t * t1 * a[1]
                    + square * (t1 * t1 + t * t2) * v[1] * v[1]
                    + gas * t1,
            ],
        ];
        let product = times(&mass, v);
        Some(SliderState {
            mass: turned(&frame, &mass),
            rest: times(&frame, rest),
            rest_by_velocity: turned(&frame, &by_velocity),
            by_place: turned(&frame, &by_place),
            swing: -v[1] / (l * cos),
            piston_velocity: v[0] + t * v[1],
            energy: 0.5 * (v[0] * product[0] + v[1] * product[1]),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slider() -> Slider {
        Slider {
            angle: 0.3,
            offset: 0.004,
            length: 0.14,
            piston: 0.45,
            rod: 0.6,
            centre: 0.04,
            inertia: 2.1e-3,
        }
    }

    /// Kinetic energy from the places of piston, centre of gravity and direction by differences: nothing of the formulas above.
    fn energy(slider: &Slider, place: Plane, velocity: Plane) -> f64 {
        let h = 1e-6;
        let at = |s: f64| [place[0] + s * velocity[0], place[1] + s * velocity[1]];
        let centre = |s: f64| {
            let (sin, cos) = slider.direction(at(s)).sin_cos();
            [at(s)[0] + slider.centre * cos, at(s)[1] + slider.centre * sin]
        };
        let rate = |f: &dyn Fn(f64) -> f64| (f(h) - f(-h)) / (2.0 * h);
        let piston = rate(&|s| slider.travel(at(s)));
        let [x, y] = [0, 1].map(|k| rate(&|s| centre(s)[k]));
        let swing = rate(&|s| slider.direction(at(s)));
        0.5 * (slider.piston * piston * piston
            + slider.rod * (x * x + y * y)
            + slider.inertia * swing * swing)
    }

    #[test]
    fn mass_is_that_of_piston_and_rod() {
        let slider = slider();
        for (place, velocity) in [([0.03, 0.02], [3.0, -5.0]), ([-0.02, -0.035], [7.0, 11.0])] {
            let own = slider.state(place, velocity, [0.0; 2], 0.0).unwrap();
            let wanted = energy(&slider, place, velocity);
            // Central differences over 1e-6 s.
            assert!((own.energy / wanted - 1.0).abs() < 1e-8, "{} {wanted}", own.energy);
        }
    }

    #[test]
    fn forces_follow_from_the_energy_and_derivatives_from_differences() {
        let slider = slider();
        let (place, velocity, acceleration, gas) = ([0.02, 0.031], [4.0, 6.0], [-900.0, 1500.0], 9e3);
        let own = slider.state(place, velocity, acceleration, gas).unwrap();
        let left = |place: Plane, velocity: Plane| {
            let own = slider.state(place, velocity, acceleration, gas).unwrap();
            let inertia = times(&own.mass, acceleration);
            [inertia[0] + own.rest[0], inertia[1] + own.rest[1]]
        };
        // d/dt dT/dv - dT/dx from differences of the energy's mass matrix along the motion.
        let h = 1e-6;
        let moved = |s: f64| {
            let at = [0, 1].map(|k| place[k] + s * velocity[k] + 0.5 * s * s * acceleration[k]);
            let v = [0, 1].map(|k| velocity[k] + s * acceleration[k]);
            (at, v)
        };
        let momentum = |s: f64| {
            let (at, v) = moved(s);
            times(&slider.state(at, v, [0.0; 2], 0.0).unwrap().mass, v)
        };
        let (before, after) = (momentum(-h), momentum(h));
        for k in 0..2 {
            let mut step = [0.0; 2];
            step[k] = h;
            let shifted = |sign: f64| [place[0] + sign * step[0], place[1] + sign * step[1]];
            let by_place = |f: &dyn Fn(Plane) -> f64| (f(shifted(1.0)) - f(shifted(-1.0))) / (2.0 * h);
            let of_energy = by_place(&|place| slider.state(place, velocity, [0.0; 2], 0.0).unwrap().energy);
            let of_gas = -gas * by_place(&|place| slider.travel(place));
            let wanted = (after[k] - before[k]) / (2.0 * h) - of_energy - of_gas;
            let got = left(place, velocity)[k];
            assert!((got - wanted).abs() < 1e-5 * 9e3, "{k}: {got} {wanted}");
            for row in 0..2 {
                let wanted = by_place(&|place| left(place, velocity)[row]);
                assert!((own.by_place[row][k] - wanted).abs() < 1e-4 * 1e5, "{row} {k}");
                let shifted = |sign: f64| {
                    let mut v = velocity;
                    v[k] += sign * h;
                    left(place, v)[row]
                };
                let wanted = (shifted(1.0) - shifted(-1.0)) / (2.0 * h);
                assert!((own.rest_by_velocity[row][k] - wanted).abs() < 1e-3, "{row} {k}");
            }
        }
    }

    #[test]
    fn a_rod_that_does_not_reach_has_no_state() {
        assert!(slider().state([0.0, 0.2], [0.0; 2], [0.0; 2], 0.0).is_none());
    }
}
