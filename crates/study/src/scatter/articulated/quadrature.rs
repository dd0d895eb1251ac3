//! Orders of the reach of articulated rods, eight samples at a time.
//!
//! ```text
//! U_n = (1/N) SUM over j of U(phi_j) e^{-i n phi_j}        phi_j = 2 pi (j + 1/2) / N,  N a multiple of 4
//! ```
//! The sum is exact but for the orders N - n, N + n, 2 N - n, .. that it takes for n. U is analytic, so that its orders fall by a constant
//! factor from each to the next: enough angles make these less than a rounding of U itself. Angles half a turn apart, and those on either
//! side of the cylinder, share the exponentials: each order costs N/4 products of its cosine and of its sine.

use lanchester_numerics::{ComplexLanes, Lanes};
use std::f64::consts::TAU;

/// Lengths and angle of the motion, of eight samples; see [`crate::scatter::articulated::motion`].
pub(crate) struct LaneDimensions {
    pub radius: Lanes,
    pub master_length: Lanes,
    pub master_offset: Lanes,
    /// `e^{i tau}`.
    pub turn: ComplexLanes,
    /// `(g / l_m) e^{i (psi + tau)}`.
    pub arm: ComplexLanes,
    pub length: Lanes,
    pub offset: Lanes,
}

/// Equally spaced angles with the exponentials of some harmonics.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Quadrature {
    /// Number of angles.
    pub count: usize,
    numbers: Vec<u32>,
    /// Cosine and sine of the angles of the first quarter.
    angles: Vec<[f64; 2]>,
    /// `2 n^2 / N` times cosine and sine of `n phi_j`, by harmonic, then angle.
    turns: Vec<[f64; 2]>,
}

/// Roots `W` of a master at `phi_j` and at `-phi_j`.
pub(crate) type MasterRoots = Vec<[Lanes; 2]>;

impl Quadrature {
    /// `count` angles, a multiple of 4, for the harmonics `numbers`.
    pub fn new(count: usize, numbers: &[u32]) -> Quadrature {
        let quarter = count / 4;
        // Angles in halves of a step, reduced exactly.
        let turn = |number: usize, j: usize| {
            let (sin, cos) =
                (TAU * (number * (2 * j + 1) % (2 * count)) as f64 / (2 * count) as f64).sin_cos();
            [cos, sin]
        };
        let weighted = |&number: &u32| {
            let weight = 2.0 * f64::from(number).powi(2) / count as f64;
            (0..quarter).map(move |j| turn(number as usize, j).map(|part| weight * part))
        };
        Quadrature {
            count,
            numbers: numbers.to_vec(),
            angles: (0..quarter).map(|j| turn(1, j)).collect(),
            turns: numbers.iter().flat_map(weighted).collect(),
        }
    }

    /// Roots of a master.
    pub fn master_roots(&self, radius: &Lanes, length: &Lanes, offset: &Lanes, out: &mut MasterRoots) {
        out.clear();
        out.extend(self.angles.iter().map(|&[_, sin]| {
            let root = |q: &Lanes| Lanes::each(|i| ((length[i] - q[i]) * (length[i] + q[i])).sqrt());
            [
                root(&Lanes::each(|i| radius[i] * sin - offset[i])),
                root(&Lanes::each(|i| -radius[i] * sin - offset[i])),
            ]
        }));
    }

    /// `2 n^2 U_n` [m] of a rod on the master with these roots, by harmonic.
    pub fn orders(&self, rod: &LaneDimensions, roots: &MasterRoots, out: &mut Vec<ComplexLanes>) {
        let LaneDimensions { radius, master_offset, turn, arm, length, offset, .. } = rod;
        // Q = fixed + across C + beside S + arm.im W.
        let fixed = Lanes::each(|i| arm.re[i] * master_offset[i] - offset[i]);
        let across = Lanes::each(|i| turn.im[i] * radius[i]);
        let beside = Lanes::each(|i| (turn.re[i] - arm.re[i]) * radius[i]);
        let sums: Vec<[Lanes; 4]> = self
            .angles
            .iter()
            .zip(roots)
            .map(|(&[cos, sin], [front, back])| {
                // Less the length: smaller numbers to sum, and the same orders but the mean.
                let reach =
                    |q: &Lanes| Lanes::each(|i| ((length[i] - q[i]) * (length[i] + q[i])).sqrt() - length[i]);
                let front = Lanes::each(|i| fixed[i] + arm.im[i] * front[i] + beside[i] * sin);
                let back = Lanes::each(|i| fixed[i] + arm.im[i] * back[i] - beside[i] * sin);
                let along = Lanes::each(|i| across[i] * cos);
                // At phi, pi - phi, pi + phi and -phi.
                let (a, b) = (reach(&(front + along)), reach(&(front - along)));
                let (c, d) = (reach(&(back - along)), reach(&(back + along)));
                let (ab, cd) = ([a + b, a - b], [c + d, c - d]);
                [ab[0] + cd[0], ab[1] + cd[1], ab[1] - cd[1], ab[0] - cd[0]]
            })
            .collect();
        out.clear();
        let quarter = self.angles.len();
        for (place, number) in self.numbers.iter().enumerate() {
            let turns = &self.turns[place * quarter..][..quarter];
            let first = if number % 2 == 0 { 0 } else { 2 };
            let (mut re, mut im) = (Lanes::ZERO, Lanes::ZERO);
            for (&[cos, sin], sums) in turns.iter().zip(&sums) {
                let (even, odd) = (&sums[first], &sums[first + 1]);
                re = Lanes::each(|i| re[i] + even[i] * cos);
                im = Lanes::each(|i| im[i] - odd[i] * sin);
            }
            out.push(ComplexLanes { re, im });
        }
    }
}
