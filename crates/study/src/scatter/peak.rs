//! True peaks of force and couple over the continuous crank angle, eight samples at a time.
//!
//! A grid gives the candidates: every angle whose neighbours are lower and which, by its second difference, could still
//! beat the best. Newton's method on the derivative of the square finds each to the last digits. Angles half a turn apart
//! share the work: their even orders are the same, their odd ones opposite.

use lanchester_numerics::{ComplexLanes, LANES, Lanes};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Angles of the grid for every order that is there, at least.
const PER_ORDER: usize = 8;

/// Least angles of the grid.
const LEAST: usize = 64;

/// A grid of angles for a set of orders.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PeakGrid {
    orders: Vec<u32>,
    /// Half the number of angles: the others are half a turn on.
    half: usize,
    /// `cos` and `sin` of `n theta`, by angle, then order.
    turns: Vec<(f64, f64)>,
    /// Squares at all angles.
    squares: Vec<Lanes>,
}

impl PeakGrid {
    pub fn new(orders: &[u32]) -> PeakGrid {
        let highest = orders.iter().copied().max().unwrap_or(1) as usize;
        let half = LEAST.max(PER_ORDER * highest).div_ceil(2);
        let turns = (0..half)
            .flat_map(|j| {
                orders.iter().map(move |&n| {
                    let (sin, cos) = (TAU * (j * n as usize) as f64 / (2 * half) as f64).sin_cos();
                    (cos, sin)
                })
            })
            .collect();
        PeakGrid { orders: orders.to_vec(), half, turns, squares: vec![Lanes::ZERO; 2 * half] }
    }

    /// Largest size over the continuous angle of `SUM forward e^{i n theta} + backward e^{-i n theta}`, by lane.
    pub fn peaks(&mut self, spectrum: &[[ComplexLanes; 2]]) -> Lanes {
        let count = self.orders.len();
        // Sum and difference of the senses: f e^{ix} + b e^{-ix} = (f + b) cos x + i (f - b) sin x.
        let senses: Vec<[ComplexLanes; 2]> = spectrum
            .iter()
            .map(|[f, b]| {
                [
                    ComplexLanes {
                        re: Lanes::each(|i| f.re[i] + b.re[i]),
                        im: Lanes::each(|i| f.im[i] + b.im[i]),
                    },
                    ComplexLanes {
                        re: Lanes::each(|i| f.re[i] - b.re[i]),
                        im: Lanes::each(|i| f.im[i] - b.im[i]),
                    },
                ]
            })
            .collect();
        for j in 0..self.half {
            let mut parts = [ComplexLanes::ZERO; 2];
            for k in 0..count {
                let (cos, sin) = self.turns[j * count + k];
                let [sum, difference] = &senses[k];
                let part = &mut parts[self.orders[k] as usize % 2];
                part.re = Lanes::each(|i| part.re[i] + (sum.re[i] * cos - difference.im[i] * sin));
                part.im = Lanes::each(|i| part.im[i] + (sum.im[i] * cos + difference.re[i] * sin));
            }
            let [even, odd] = &parts;
            self.squares[j] =
                Lanes::each(|i| (even.re[i] + odd.re[i]).powi(2) + (even.im[i] + odd.im[i]).powi(2));
            self.squares[j + self.half] =
                Lanes::each(|i| (even.re[i] - odd.re[i]).powi(2) + (even.im[i] - odd.im[i]).powi(2));
        }
        Lanes::each(|lane| self.lane(spectrum, lane).sqrt())
    }

    /// Largest square of one lane.
    fn lane(&self, spectrum: &[[ComplexLanes; 2]], lane: usize) -> f64 {
        let count = self.squares.len();
        let at = |j: usize| self.squares[j % count][lane];
        let mut best = 0.0f64;
        for j in 0..count {
            best = best.max(at(j));
        }
        // Nothing at all angles: no angle is worth a closer look.
        if best == 0.0 {
            return 0.0;
        }
        let mut found = best;
        for j in 0..count {
            let here = at(j);
            let (before, after) = (at(j + count - 1), at(j + 1));
            let bend = 2.0 * here - before - after;
            if here < before || here < after || here + 0.5 * bend.abs() < best {
                continue;
            }
            // Vertex of the parabola through the three, in steps of the grid.
            let shift = if bend > 0.0 { (0.5 * (after - before) / bend).clamp(-0.5, 0.5) } else { 0.0 };
            let step = TAU / count as f64;
            found = found.max(self.refined(spectrum, lane, step * (j as f64 + shift), step));
        }
        found
    }

    /// Largest square near `theta`, from Newton's method on its derivative.
    fn refined(&self, spectrum: &[[ComplexLanes; 2]], lane: usize, mut theta: f64, step: f64) -> f64 {
        let (low, high) = (theta - step, theta + step);
        let mut best = 0.0f64;
        for _ in 0..12 {
            let [value, slope, bend] = self.vector(spectrum, lane, theta);
            let square = value.norm_sqr();
            best = best.max(square);
            let first = (value.conj() * slope).re;
            let second = slope.norm_sqr() + (value.conj() * bend).re;
            if second >= 0.0 {
                break;
            }
            let next = (theta - first / second).clamp(low, high);
            // Once the angle moves by less than the root of a rounding, the value moves no more.
            if (next - theta).abs() < 1e-9 {
                break;
            }
            theta = next;
        }
        best
    }

    /// The vector and its first two derivatives by the angle.
    fn vector(&self, spectrum: &[[ComplexLanes; 2]], lane: usize, theta: f64) -> [Complex64; 3] {
        let turn = Complex64::cis(theta);
        let (mut power, mut at) = (turn, 1);
        let mut sums = [Complex64::ZERO; 3];
        for (&order, senses) in self.orders.iter().zip(spectrum) {
            while at < order {
                power *= turn;
                at += 1;
            }
            let [forward, backward] =
                senses.each_ref().map(|sense| Complex64::new(sense.re[lane], sense.im[lane]));
            let (forward, backward) = (forward * power, backward * power.conj());
            let n = f64::from(order);
            sums[0] += forward + backward;
            sums[1] += Complex64::new(0.0, n) * (forward - backward);
            sums[2] -= n * n * (forward + backward);
        }
        sums
    }
}

const _: () = assert!(LANES == 8);
