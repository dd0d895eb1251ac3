//! Forced vibration at one speed, by order, and what follows from it.

use crate::chain::Chain;
use crate::error::TorsionError;
use crate::excitation::Excitation;
use crate::impedance::Impedance;
use crate::synthesis::Synthesis;
use num_complex::Complex64;

/// Chain and torques, ready to be solved at any speed. Angles and twists are by order and position in the order of elimination.
#[derive(Debug, Clone)]
pub(crate) struct Forced<'a> {
    pub chain: &'a Chain,
    pub excitation: &'a Excitation,
    pub impedance: Impedance,
    pub synthesis: Synthesis,
    /// Ratio of the station at each position.
    ratio: Vec<f64>,
    pub angle: Vec<Complex64>,
    pub twist: Vec<Complex64>,
    torque: Vec<Complex64>,
    applied: Vec<Complex64>,
    /// Complex stiffness of the shaft to the parent, by order and position.
    pub stiffness: Vec<Complex64>,
    pub speed: f64,
    /// Power that the torques put in [W], of all orders.
    pub input: f64,
    /// Power that dampers take [W].
    pub loss: f64,
    /// Power lost in the shaft to the parent of each position [W].
    pub shaft_loss: Vec<f64>,
}

impl<'a> Forced<'a> {
    pub fn new(chain: &'a Chain, excitation: &'a Excitation) -> Result<Forced<'a>, TorsionError> {
        excitation.check(chain)?;
        let impedance = Impedance::new(chain);
        let (n, count) = (impedance.size(), excitation.count);
        let ratio = impedance.station.iter().map(|station| chain.stations()[*station].ratio).collect();
        Ok(Forced {
            chain,
            excitation,
            impedance,
            synthesis: Synthesis::new(count),
            ratio,
            angle: vec![Complex64::default(); n * count],
            twist: vec![Complex64::default(); n * count],
            torque: vec![Complex64::default(); n],
            applied: vec![Complex64::default(); n],
            stiffness: vec![Complex64::default(); n * count],
            speed: 0.0,
            input: 0.0,
            loss: 0.0,
            shaft_loss: vec![0.0; n],
        })
    }

    /// Solves all orders at a speed of the reference [rad/s].
    pub fn solve(&mut self, speed: f64) {
        let n = self.impedance.size();
        self.speed = speed;
        (self.input, self.loss) = (0.0, 0.0);
        self.shaft_loss.fill(0.0);
        for k in 0..self.excitation.count {
            let w = self.excitation.step * (k + 1) as f64 * speed;
            self.applied.fill(Complex64::default());
            for source in &self.excitation.sources {
                let at = self.impedance.position[source.station];
                self.applied[at] += source.order(k, speed) * self.ratio[at];
            }
            self.torque.copy_from_slice(&self.applied);
            let row = k * n..(k + 1) * n;
            let (angle, twist) = (&mut self.angle[row.clone()], &mut self.twist[row.clone()]);
            self.impedance.solve(w, speed, &mut self.torque, angle, twist);
            for i in 0..n {
                let phi = angle[i];
                // Power is half the real part of torque times the conjugate of i w phi.
                let put_in = 0.5 * w * (self.applied[i].im * phi.re - self.applied[i].re * phi.im);
                self.input += put_in;
                self.loss += 0.5 * w * w * self.impedance.ground_damping(i) * phi.norm_sqr();
                if i > 0 {
                    let stiffness = self.impedance.stiffness(i);
                    self.stiffness[k * n + i] = stiffness;
                    let lost = 0.5 * w * stiffness.im * twist[i].norm_sqr();
                    self.shaft_loss[i] += lost;
                    self.loss += lost;
                }
            }
        }
    }

    /// Angle of a station at its own speed [rad], by order.
    pub fn angle_of(&self, station: usize) -> impl Iterator<Item = Complex64> + '_ {
        let (n, at) = (self.impedance.size(), self.impedance.position[station]);
        (0..self.excitation.count).map(move |k| self.angle[k * n + at] * self.ratio[at])
    }

    /// Twist of the shaft to the parent of a position, front less rear end, at its own speed [rad], by order.
    pub fn own_twist(&self, at: usize) -> impl Iterator<Item = Complex64> + '_ {
        let n = self.impedance.size();
        let sign = if self.impedance.is_forward[at] { 1.0 } else { -1.0 };
        let ratio = sign * self.chain.shafts()[self.impedance.shaft[at]].ratio;
        (0..self.excitation.count).map(move |k| self.twist[k * n + at] * ratio)
    }

    /// Torque in the same shaft [N m], positive where its front end is turned ahead, by order.
    pub fn own_torque(&self, at: usize) -> impl Iterator<Item = Complex64> + '_ {
        let n = self.impedance.size();
        let sign = if self.impedance.is_forward[at] { 1.0 } else { -1.0 };
        let ratio = sign / self.chain.shafts()[self.impedance.shaft[at]].ratio;
        (0..self.excitation.count).map(move |k| self.twist[k * n + at] * self.stiffness[k * n + at] * ratio)
    }

    /// Referred angle of a station less that of another [rad], by order: without the cancellation of a difference of angles.
    pub fn between(&self, front: usize, rear: usize) -> impl Iterator<Item = Complex64> + '_ {
        let n = self.impedance.size();
        let path = self.path(front, rear);
        (0..self.excitation.count)
            .map(move |k| path.iter().map(|(at, sign)| self.twist[k * n + at] * *sign).sum())
    }

    /// Positions whose twists, with their signs, lead from one station to another.
    fn path(&self, front: usize, rear: usize) -> Vec<(usize, f64)> {
        let up = |station: usize| {
            let mut at = self.impedance.position[station];
            let mut list = Vec::new();
            while at != 0 {
                list.push(at);
                at = self.impedance.position[self.chain.parent(self.impedance.station[at]).0];
            }
            list
        };
        let (ahead, back) = (up(front), up(rear));
        let own = |list: &[usize], other: &[usize], sign: f64| -> Vec<(usize, f64)> {
            list.iter().filter(|at| !other.contains(at)).map(|at| (*at, sign)).collect()
        };
        let mut path = own(&ahead, &back, 1.0);
        path.extend(own(&back, &ahead, -1.0));
        path
    }

    /// Mean torque in the shaft to the parent of each position, at its own speed, with the whole mean torque taken at `load`.
    pub fn mean_torques(&self, load: usize) -> Vec<f64> {
        let n = self.impedance.size();
        let mut carried = vec![0.0; n];
        let mut sum = 0.0;
        for source in &self.excitation.sources {
            let at = self.impedance.position[source.station];
            let mean = source.mean(self.speed) * self.ratio[at];
            carried[at] += mean;
            sum += mean;
        }
        carried[self.impedance.position[load]] -= sum;
        let mut torques = vec![0.0; n];
        for at in (1..n).rev() {
            let parent = self.impedance.position[self.chain.parent(self.impedance.station[at]).0];
            carried[parent] += carried[at];
            let sign = if self.impedance.is_forward[at] { 1.0 } else { -1.0 };
            torques[at] = sign * carried[at] / self.chain.shafts()[self.impedance.shaft[at]].ratio;
        }
        torques
    }
}
