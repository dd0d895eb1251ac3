//! One solution of the chain at one frequency, by elimination along the tree.
//!
//! With g the dynamic stiffness of a station with all that hangs on it, and k that of the shaft to its parent,
//!
//! ```text
//! g = -w^2 J + i w c + SUM over children k g_c / (k + g_c)                                                                     (50.3)
//! phi_root = T_root / g_root,   phi - phi_parent = (T - g phi_parent) / (k + g),   T_parent += T k / (k + g)
//! ```
//! Springs in series: nothing is subtracted that is nearly equal, however stiff the shafts are. Written in s = i w it serves damped modes too.

use crate::chain::Chain;
use num_complex::Complex64;

/// The chain at the reference, in the order of elimination: every station stands after its parent.
#[derive(Debug, Clone)]
pub(crate) struct Impedance {
    /// Position of the parent in this order; that of the root is 0.
    parent: Vec<usize>,
    inertia: Vec<f64>,
    damping: Vec<f64>,
    stiffness: Vec<f64>,
    spin: Vec<f64>,
    loss: Vec<f64>,
    relative: Vec<f64>,
    /// Station at each position, and position of each station.
    pub station: Vec<usize>,
    pub position: Vec<usize>,
    /// Shaft to the parent of each position, and whether it runs from there to the parent.
    pub shaft: Vec<usize>,
    pub is_forward: Vec<bool>,
    // Work.
    g: Vec<Complex64>,
    k: Vec<Complex64>,
}

impl Impedance {
    pub fn new(chain: &Chain) -> Impedance {
        let order = chain.order();
        let n = order.len();
        let mut position = vec![0; n];
        for (place, station) in order.iter().enumerate() {
            position[*station] = place;
        }
        let mut own = Impedance {
            parent: vec![0; n],
            inertia: vec![0.0; n],
            damping: vec![0.0; n],
            stiffness: vec![0.0; n],
            spin: vec![0.0; n],
            loss: vec![0.0; n],
            relative: vec![0.0; n],
            station: order.to_vec(),
            position,
            shaft: vec![usize::MAX; n],
            is_forward: vec![true; n],
            g: vec![Complex64::default(); n],
            k: vec![Complex64::default(); n],
        };
        for (place, &index) in order.iter().enumerate() {
            let station = &chain.stations()[index];
            own.inertia[place] = chain.referred_inertia(index);
            own.damping[place] = station.damping * station.ratio * station.ratio;
            if place == 0 {
                continue;
            }
            let (parent, shaft) = chain.parent(index);
            let link = &chain.shafts()[shaft];
            let square = link.ratio * link.ratio;
            own.parent[place] = own.position[parent];
            own.stiffness[place] = link.stiffness * square;
            own.spin[place] = link.spin_stiffness * square;
            own.loss[place] = link.loss_factor;
            own.relative[place] = link.damping * square;
            own.shaft[place] = shaft;
            own.is_forward[place] = link.from == index;
        }
        own
    }

    /// Number of stations.
    pub fn size(&self) -> usize {
        self.parent.len()
    }

    /// Referred angles under referred torques, both by position, at the angular frequency `w` while the reference turns at `speed`; `twists` get
    /// the angle of each position less that of its parent.
    pub fn solve(
        &mut self,
        w: f64,
        speed: f64,
        torque: &mut [Complex64],
        angle: &mut [Complex64],
        twist: &mut [Complex64],
    ) {
        let n = self.size();
        let square = speed * speed;
        for i in 0..n {
            self.g[i] = Complex64::new(-w * w * self.inertia[i], w * self.damping[i]);
        }
        for i in (1..n).rev() {
            let real = self.stiffness[i] + self.spin[i] * square;
            let k = Complex64::new(real, real * self.loss[i] + w * self.relative[i]);
            let share = k / (k + self.g[i]);
            let parent = self.parent[i];
            let (g, t) = (self.g[i] * share, torque[i] * share);
            self.k[i] = k;
            self.g[parent] += g;
            torque[parent] += t;
        }
        angle[0] = torque[0] / self.g[0];
        twist[0] = Complex64::default();
        for i in 1..n {
            let above = angle[self.parent[i]];
            twist[i] = (torque[i] - self.g[i] * above) / (self.k[i] + self.g[i]);
            angle[i] = above + twist[i];
        }
    }

    /// Complex stiffness of the shaft to the parent of a position in the last solution, at the reference.
    pub fn stiffness(&self, position: usize) -> Complex64 {
        self.k[position]
    }

    /// Damping of a position against the ground, at the reference.
    pub fn ground_damping(&self, position: usize) -> f64 {
        self.damping[position]
    }

    /// d log det / ds of s^2 J + s C + K (1 + i loss).
    pub fn log_derivative(&mut self, s: Complex64, speed: f64) -> Complex64 {
        let n = self.size();
        let square = speed * speed;
        let mut slope = vec![Complex64::default(); n];
        for i in 0..n {
            self.g[i] = s * (s * self.inertia[i] + self.damping[i]);
            slope[i] = 2.0 * s * self.inertia[i] + self.damping[i];
        }
        let mut sum = Complex64::default();
        for i in (1..n).rev() {
            let real = self.stiffness[i] + self.spin[i] * square;
            let k = Complex64::new(real, real * self.loss[i]) + s * self.relative[i];
            let pivot = k + self.g[i];
            sum += (self.relative[i] + slope[i]) / pivot;
            let (g, parent) = (self.g[i], self.parent[i]);
            let own = (g / pivot, k / pivot);
            slope[parent] = slope[parent] + own.0 * own.0 * self.relative[i] + own.1 * own.1 * slope[i];
            self.g[parent] += g * own.1;
        }
        sum + slope[0] / self.g[0]
    }

    /// The matrix s^2 J + s C + K (1 + i loss), by position, row by row.
    pub fn matrix(&self, s: Complex64, speed: f64) -> Vec<Complex64> {
        let n = self.size();
        let mut matrix = vec![Complex64::default(); n * n];
        for i in 0..n {
            matrix[i * n + i] += s * (s * self.inertia[i] + self.damping[i]);
            if i > 0 {
                let real = self.stiffness[i] + self.spin[i] * speed * speed;
                let k = Complex64::new(real, real * self.loss[i]) + s * self.relative[i];
                let p = self.parent[i];
                matrix[i * n + i] += k;
                matrix[p * n + p] += k;
                matrix[i * n + p] -= k;
                matrix[p * n + i] -= k;
            }
        }
        matrix
    }

    /// Multiplicity of the root 0 of the determinant: 2 for rigid turning without damping against the ground, else 1; one more for each body that no
    /// spring holds.
    pub fn rigid_roots(&self, speed: f64) -> usize {
        let loose =
            (1..self.size()).filter(|i| self.stiffness[*i] + self.spin[*i] * speed * speed == 0.0).count();
        let is_free = self.damping.iter().all(|c| *c == 0.0);
        1 + loose + usize::from(is_free)
    }

    /// A rate that real roots are of the order of.
    pub fn decay_guess(&self) -> f64 {
        let guess = |i: usize| (self.relative[i] + self.damping[i]) / self.inertia[i];
        (0..self.size()).map(guess).fold(0.0, f64::max).max(1e-3)
    }
}
