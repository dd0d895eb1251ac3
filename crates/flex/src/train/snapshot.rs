//! What a state of the train is worth: its energy, and everything about its bearings.

use super::assembly::Assembly;
use super::plane::{Plane, dot as along, times};
use super::slider::SliderState;
use super::spot::{end, middle, moment};
use super::ties::{Kind, linear, moving};
use crate::sparse::dot;

/// One instant of a cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleInstant {
    /// Angle of crankshaft 1 [rad].
    pub theta: f64,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Acceleration of crankshaft 1 [rad/s^2].
    pub acceleration: f64,
    /// Angle of this crankshaft [rad].
    pub own_angle: f64,
    /// Coordinates of the body.
    pub coordinates: Vec<f64>,
    /// Force of each main bearing on the journal, in the block's frame [N].
    pub main_forces: Vec<Plane>,
    /// Journal centre from bearing centre [m].
    pub main_places: Vec<Plane>,
    /// Force of each big end on the pin [N].
    pub pin_forces: Vec<Plane>,
    /// Pin centre from the big end's centre [m].
    pub pin_places: Vec<Plane>,
    /// Direction of each rod [rad].
    pub rods: Vec<f64>,
    /// Mean angular speed of pin and big end [rad/s].
    pub entrainment: Vec<f64>,
    /// Rate of each eccentricity, mains then pins [m/s].
    pub rates: Vec<Plane>,
    /// How much further the end of each journal lies than its middle [m], and the rate of that [m/s], mains then pins: zero where the law does not know of tilt.
    pub tilts: Vec<[Plane; 2]>,
    /// Torque of the flywheel on the crankshaft [N m].
    pub torque: f64,
}

impl Assembly<'_> {
    /// Kinetic and elastic energy [J].
    pub fn energy(&self, t: f64, y: &[f64]) -> f64 {
        let n = self.size;
        let turn = self.own(&self.first(t, y, &[]));
        let frame = super::plane::turn(turn.angle);
        let (q, v) = y[..2 * n].split_at(n);
        let body = &self.body;
        let line = |matrix: &[f64], i: usize, x: &[f64]| dot(&matrix[i * n..(i + 1) * n], x);
        let mut energy = 0.5 * turn.speed * turn.speed * body.polar;
        for i in 0..n {
            energy += 0.5 * v[i] * v[i]
                + 0.5 * body.stiffness[i] * q[i] * q[i]
                + turn.speed * v[i] * (body.euler_load[i] + line(&body.gyroscopic, i, q))
                + 0.5
                    * turn.speed
                    * turn.speed
                    * q[i]
                    * (2.0 * body.centrifugal_load[i] + line(&body.centrifugal, i, q));
        }
        let still = vec![0.0; n];
        for tie in &self.ties {
            let at = moving(&self.body, tie, &turn, &frame, [q, v, &still]);
            if let Some(shell) = tie.shell {
                let place = [y[shell.at], y[shell.at + 1]];
                energy += 0.5 * shell.stiffness * along(place, place);
            }
            let (index, place, velocity) = match tie.kind {
                Kind::Main(_) => continue,
                Kind::Joined(index) => (index, middle(&at.place), middle(&at.velocity)),
                Kind::Free(index, start) => (index, [y[start], y[start + 1]], [y[start + 2], y[start + 3]]),
            };
            let state = self.train.cylinders[index].slider.state(place, velocity, [0.0; 2], 0.0);
            energy += state.map_or(0.0, |state: SliderState| state.energy);
        }
        energy
    }

    /// Everything about the bearings at a state with its slope.
    pub fn snapshot(&self, t: f64, y: &[f64], slope: &[f64]) -> Option<CycleInstant> {
        let n = self.size;
        let first = self.first(t, y, slope);
        let (theta, turn) = (first.angle, self.own(&first));
        let frame = super::plane::turn(turn.angle);
        let (q, v) = y[..2 * n].split_at(n);
        let k = &slope[n..2 * n];
        let whole = &self.train.body;
        let [coordinates, rates, seconds] = [q, v, k].map(|own| self.held.whole(own));
        let size = whole.size();
        let mut found = CycleInstant {
            theta,
            speed: first.speed,
            acceleration: first.acceleration,
            own_angle: turn.angle,
            coordinates: Vec::new(),
            main_forces: vec![[0.0; 2]; self.train.mains.len()],
            main_places: vec![[0.0; 2]; self.train.mains.len()],
            pin_forces: Vec::new(),
            pin_places: Vec::new(),
            rods: Vec::new(),
            entrainment: Vec::new(),
            rates: vec![[0.0; 2]; self.train.mains.len()],
            tilts: vec![[[0.0; 2]; 2]; self.train.mains.len()],
            torque: 0.0,
        };
        // What the equations of the whole body leave is what holds it.
        let line = |matrix: &[f64], i: usize, x: &[f64]| dot(&matrix[i * size..(i + 1) * size], x);
        let w = turn.speed;
        let mut rest: Vec<f64> = (0..size)
            .map(|i| {
                seconds[i]
                    + self.damping * line(&whole.damping, i, &rates)
                    + whole.stiffness[i] * coordinates[i]
                    + 2.0 * w * line(&whole.gyroscopic, i, &rates)
                    - w * w * line(&whole.centrifugal, i, &coordinates)
                    + turn.acceleration * line(&whole.gyroscopic, i, &coordinates)
                    - w * w * whole.centrifugal_load[i]
                    + turn.acceleration * whole.euler_load[i]
            })
            .collect();
        let mut moments = 0.0;
        for tie in &self.ties {
            let at = moving(&self.body, tie, &turn, &frame, [q, v, k]);
            let part = linear(self.train, tie, &turn, theta, 0.0, &at, [y, slope])?;
            moments += moment(&at.place, &part.force);
            let push = at.lever.back(&part.force);
            let [rows, slopes] = [&whole.rows, &whole.slopes].map(|own| &own[tie.surface]);
            let rows = [&rows[0], &rows[1], &whole.turns[tie.surface], &slopes[0], &slopes[1]];
            for (row, push) in rows.into_iter().zip(push).filter(|(_, push)| *push != 0.0) {
                rest.iter_mut().zip(row).for_each(|(rest, row)| *rest -= row * push);
            }
            match tie.kind {
                Kind::Main(index) => {
                    let (e, rate) =
                        (tie.within(&at.place, [0.0; 2], y), tie.within(&at.velocity, [0.0; 2], slope));
                    found.main_forces[index] = middle(&part.force);
                    found.main_places[index] = middle(&e);
                    found.rates[index] = middle(&rate);
                    found.tilts[index] = [end(&e), end(&rate)];
                }
                Kind::Joined(index) | Kind::Free(index, _) => {
                    let own = &self.train.cylinders[index];
                    let (place, velocity) = match tie.kind {
                        Kind::Free(_, start) => ([y[start], y[start + 1]], [y[start + 2], y[start + 3]]),
                        _ => (middle(&at.place), middle(&at.velocity)),
                    };
                    let state = own.slider.state(place, velocity, [0.0; 2], 0.0)?;
                    let (e, rate) =
                        (tie.within(&at.place, place, y), tie.within(&at.velocity, velocity, slope));
                    found.pin_forces.push(middle(&part.force));
                    found.pin_places.push(middle(&e));
                    found.rates.push(middle(&rate));
                    found.tilts.push([end(&e), end(&rate)]);
                    found.rods.push(own.slider.direction(place));
                    found.entrainment.push(0.5 * (turn.speed + state.swing));
                }
            }
        }
        let holding = self.held.forces(&rest);
        found.torque = self.torque(&turn, y, k, moments);
        let rigid = self.train.mains.iter().enumerate().filter(|(_, main)| main.law.is_rigid());
        for (place, (index, _)) in rigid.enumerate() {
            let own = [0, 1].map(|axis| holding.get(1 + 2 * place + axis).copied().unwrap_or(f64::NAN));
            found.main_forces[index] = times(&frame, own);
        }
        found.coordinates = coordinates;
        Some(found)
    }
}
