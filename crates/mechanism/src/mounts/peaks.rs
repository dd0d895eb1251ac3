//! The largest resultant force at each mount over the cycle.
//!
//! ```text
//! f(t) = SUM over harmonics n of Re( F_n e^{i n t} )       t = theta / revolutions of the cycle
//! ```
//! At t, -t, pi - t and pi + t the sums are those of even and odd harmonics, of cosines and sines, with other signs: a
//! quarter of the cycle gives all of it. Newton's method on the slope of `f.f` takes each hill that can matter to its top.

use crate::inertia::request::MAX_REVOLUTIONS;
use crate::mounts::error::MountError;
use crate::mounts::result::OrderResponse;
use lanchester_numerics::illinois;
use lanchester_results::Extreme;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Angles in one turn of the highest harmonic, six for that of the square of the force.
const ANGLES: usize = 12;

/// Two orders closer than this are one.
const SAME_ORDER: f64 = 1e-6;

/// Steps of Newton's method: a few suffice, and a step that leaves the hill ends it.
const STEPS: usize = 20;

/// Hills whose tops differ by less than this share are one height: the first angle counts.
const TIE: f64 = 1e-13;

/// The cycle of a list of orders, kept from one speed to the next.
#[derive(Debug, Default)]
pub(crate) struct Cycle {
    orders: Vec<f64>,
    /// The orders as harmonics of the cycle.
    harmonics: Vec<usize>,
    revolutions: u32,
    /// Cosines and sines of each harmonic at the angles of the first quarter, by harmonic.
    waves: Vec<[Vec<f64>; 2]>,
    /// Angles in the whole cycle, a multiple of four.
    angles: usize,
    /// Sums of cosines over even and odd harmonics, then of sines, for each component.
    sums: [[Vec<f64>; 3]; 4],
    /// Squares of the force at all angles.
    squares: Vec<f64>,
}

impl Cycle {
    /// Largest resultant at each of so many mounts.
    pub fn peaks(&mut self, orders: &[OrderResponse], mounts: usize) -> Result<Vec<Extreme>, MountError> {
        if orders.is_empty() {
            return Ok(vec![Extreme::default(); mounts]);
        }
        if !orders.iter().map(|o| o.order).eq(self.orders.iter().copied()) {
            self.prepare(orders)?;
        }
        Ok((0..mounts).map(|mount| self.peak(orders, mount)).collect())
    }

    fn prepare(&mut self, orders: &[OrderResponse]) -> Result<(), MountError> {
        let off = |revolutions: u32, order: f64| {
            let cycles = order * f64::from(revolutions);
            (cycles - cycles.round()).abs() > SAME_ORDER
        };
        let misfit = |revolutions: u32| orders.iter().map(|o| o.order).find(|&o| off(revolutions, o));
        let fits = |revolutions: &u32| misfit(*revolutions).is_none();
        let revolutions = (1..=MAX_REVOLUTIONS).find(fits);
        let order = misfit(1).unwrap_or_default();
        self.revolutions = revolutions.ok_or(MountError::Period { limit: MAX_REVOLUTIONS, order })?;
        self.orders = orders.iter().map(|o| o.order).collect();
        let harmonic = |order: &f64| (order * f64::from(self.revolutions)).round() as usize;
        self.harmonics = self.orders.iter().map(harmonic).collect();
        self.angles = ANGLES * self.harmonics.iter().copied().max().unwrap_or(1);
        let turn = |k: usize| (TAU * (k % self.angles) as f64 / self.angles as f64).sin_cos();
        let quarter = 0..=self.angles / 4;
        let wave = |&n: &usize| {
            let (sines, cosines) = quarter.clone().map(|j| turn(n * j)).unzip();
            [cosines, sines]
        };
        self.waves = self.harmonics.iter().map(wave).collect();
        Ok(())
    }

    fn peak(&mut self, orders: &[OrderResponse], mount: usize) -> Extreme {
        self.fill(orders, mount);
        let count = self.angles;
        let best = self.squares.iter().copied().fold(0.0, f64::max);
        let step = TAU / count as f64;
        let mut found: Option<(f64, f64)> = None;
        for j in 0..count {
            let here = self.squares[j];
            let (before, after) = (self.squares[(j + count - 1) % count], self.squares[(j + 1) % count]);
            if here < before || here < after {
                continue;
            }
            let curvature = 2.0 * here - before - after;
            let aside = if curvature > 0.0 { 0.5 * (after - before) / curvature } else { 0.0 };
            // The top of the parabola, and ample room for what it misses of a wave of the highest harmonic.
            if here + 0.25 * (after - before) * aside + 0.1 * curvature < best {
                continue;
            }
            let (square, t) = self.top(orders, mount, step * (j as f64 + aside), step * j as f64, step);
            let top = if square > here { (square, t) } else { (here, step * j as f64) };
            if found.is_none_or(|f| top.0 > f.0 * (1.0 + TIE)) {
                found = Some(top);
            }
        }
        let (square, t) = found.unwrap_or((best, 0.0));
        Extreme { value: square.sqrt(), theta: t.rem_euclid(TAU) * f64::from(self.revolutions) }
    }

    /// Squares of the force at all angles.
    fn fill(&mut self, orders: &[OrderResponse], mount: usize) {
        let quarter = self.angles / 4;
        for sum in self.sums.iter_mut().flatten() {
            sum.clear();
            sum.resize(quarter + 1, 0.0);
        }
        for ((order, harmonic), waves) in orders.iter().zip(&self.harmonics).zip(&self.waves) {
            let odd = harmonic % 2;
            let force = order.forces[mount];
            for i in 0..3 {
                for (part, wave, size) in [(odd, &waves[0], force[i].re), (2 + odd, &waves[1], force[i].im)] {
                    self.sums[part][i].iter_mut().zip(wave).for_each(|(sum, wave)| *sum += size * wave);
                }
            }
        }
        self.squares.clear();
        self.squares.resize(self.angles, 0.0);
        let (count, half) = (self.angles, self.angles / 2);
        for j in 0..=quarter {
            let mut squares = [0.0; 4];
            for i in 0..3 {
                let [even_cos, odd_cos, even_sin, odd_sin] = [0, 1, 2, 3].map(|part| self.sums[part][i][j]);
                let (cos, sin) = (even_cos + odd_cos, even_sin + odd_sin);
                let (far_cos, far_sin) = (even_cos - odd_cos, even_sin - odd_sin);
                let forces = [cos - sin, cos + sin, far_cos + far_sin, far_cos - far_sin];
                squares.iter_mut().zip(forces).for_each(|(square, force)| *square += force * force);
            }
            for (place, square) in
                [j, (count - j) % count, half - j, (half + j) % count].into_iter().zip(squares)
            {
                self.squares[place] = square;
            }
        }
    }

    /// Top of the hill about `middle`, by Newton's method from `from`, by halving where that leaves the hill: the square of
    /// the force and the angle.
    fn top(&self, orders: &[OrderResponse], mount: usize, from: f64, middle: f64, step: f64) -> (f64, f64) {
        let square = |t: f64| {
            let [force, ..] = self.at(orders, mount, t);
            dot(&force, &force)
        };
        let mut t = from;
        for _ in 0..STEPS {
            let [force, slope, bend] = self.at(orders, mount, t);
            let move_by = -dot(&force, &slope) / (dot(&slope, &slope) + dot(&force, &bend));
            let within = (t + move_by - middle).abs() <= step;
            if !within {
                break;
            }
            t += move_by;
            // The next step would be the square of this one.
            if move_by.abs() < 1e-6 * step {
                return (square(t), t);
            }
        }
        let slope = |t: f64| {
            let [force, slope, _] = self.at(orders, mount, t);
            dot(&force, &slope)
        };
        let (low, high) = (middle - step, middle + step);
        let (rising, falling) = (slope(low), slope(high));
        if rising > 0.0 && falling < 0.0 {
            t = illinois(low, rising, high, falling, 0.0, slope);
            return (square(t), t);
        }
        (square(middle), middle)
    }

    /// Force with its first two derivatives by t.
    fn at(&self, orders: &[OrderResponse], mount: usize, t: f64) -> [[f64; 3]; 3] {
        let base = Complex64::cis(t);
        let mut sum = [[0.0; 3]; 3];
        let (mut turn, mut reached) = (Complex64::ONE, 0);
        for (order, &harmonic) in orders.iter().zip(&self.harmonics) {
            if harmonic < reached || harmonic - reached > 4 {
                turn = Complex64::cis(harmonic as f64 * t);
            } else {
                (reached..harmonic).for_each(|_| turn *= base);
            }
            reached = harmonic;
            let n = harmonic as f64;
            for i in 0..3 {
                let force = order.forces[mount][i] * turn;
                sum[0][i] += force.re;
                sum[1][i] -= n * force.im;
                sum[2][i] -= n * n * force.re;
            }
        }
        sum
    }
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
