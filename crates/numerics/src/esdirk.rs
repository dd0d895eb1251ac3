//! Six stages of one diagonal, the first explicit: implicit, order 4, L-stable, stiffly accurate, for large stiff systems that solve their own stages.
//!
//! ```text
//! k_i = f(t + c_i h, y + h SUM_(j <= i) a_ij k_j)      a_ii = 1/4      y_1 = y + h SUM b_i k_i,  b = last row of a      error = h SUM (b_i - d_i) k_i
//! ```
//! Source: Kennedy, Carpenter, *Additive Runge-Kutta schemes for convection-diffusion-reaction equations*, Appl. Numer. Math. 44 (2003) 139,
//! ARK4(3)6L\[2\]SA, implicit part. All stages have one matrix `1 - h/4 df/dy`, and whoever has the equations knows best how to solve with it: the crank train
//! condenses it to its bearings.

/// Stages.
const STAGES: usize = 6;
/// Share of the step in each implicit stage's own slope.
const DIAGONAL: f64 = 0.25;
/// Places of the stages.
const PLACES: [f64; STAGES] = [0.0, 0.5, 0.332, 0.62, 0.85, 1.0];
/// Shares of the slopes before, by stage.
const BEFORE: [[f64; STAGES - 1]; STAGES] = [
    [0.0; 5],
    [0.25, 0.0, 0.0, 0.0, 0.0],
    [8611.0 / 62500.0, -1743.0 / 31250.0, 0.0, 0.0, 0.0],
    [5_012_029.0 / 34_652_500.0, -654_441.0 / 2_922_500.0, 174_375.0 / 388_108.0, 0.0, 0.0],
    [
        15_267_082_809.0 / 155_376_265_600.0,
        -71_443_401.0 / 120_774_400.0,
        730_878_875.0 / 902_184_768.0,
        2_285_395.0 / 8_070_912.0,
        0.0,
    ],
    [82889.0 / 524_892.0, 0.0, 15625.0 / 83664.0, 69875.0 / 102_672.0, -2260.0 / 8211.0],
];
/// Weights of the comparison of order 3.
const COMPARED: [f64; STAGES] = [
    4_586_570_599.0 / 29_645_900_160.0,
    0.0,
    178_811_875.0 / 945_068_544.0,
    814_220_225.0 / 1_159_782_912.0,
    -3_700_637.0 / 11_593_932.0,
    61727.0 / 225_920.0,
];

/// A system that solves its own stages.
pub trait StageSystem {
    /// Number of components.
    fn dimension(&self) -> usize;

    /// `f(t, y)`; false where it has no value.
    fn slope(&mut self, t: f64, y: &[f64], slope: &mut [f64]) -> bool;

    /// Solves `y = base + share f(t, y)` and writes `f(t, y)`; `slope` holds a first guess. The number of iterations, or none where they do not converge.
    fn stage(&mut self, t: f64, base: &[f64], share: f64, slope: &mut [f64]) -> Option<u32>;
}

/// The integrator, one step at a time: who calls it chooses the steps.
#[derive(Debug, Clone)]
pub struct Esdirk {
    slopes: [Vec<f64>; STAGES],
    base: Vec<f64>,
    next: Vec<f64>,
    error: Vec<f64>,
    started: bool,
}

impl Esdirk {
    /// For systems of this dimension.
    pub fn new(dimension: usize) -> Esdirk {
        let empty = || vec![0.0; dimension];
        Esdirk {
            slopes: std::array::from_fn(|_| empty()),
            base: empty(),
            next: empty(),
            error: empty(),
            started: false,
        }
    }

    /// Share of a step in its stages' own slopes.
    pub const fn diagonal() -> f64 {
        DIAGONAL
    }

    /// Forgets the slope at the end of the last step: for a state that was set from outside.
    pub fn restart(&mut self) {
        self.started = false;
    }

    /// A step of length `h` from `y` at `t`: the iterations of its stages, or none where a stage has no solution. Nothing moves before [`Esdirk::accept`].
    ///
    /// # Panics
    /// If `y` has not the dimension of the integrator.
    pub fn attempt(&mut self, system: &mut impl StageSystem, t: f64, h: f64, y: &[f64]) -> Option<u32> {
        let n = y.len();
        assert_eq!(n, self.base.len(), "a state of the integrator's dimension");
        if !self.started {
            if !system.slope(t, y, &mut self.slopes[0]) {
                return None;
            }
            self.started = true;
        }
        let mut iterations = 0;
        for stage in 1..STAGES {
            self.base.copy_from_slice(y);
            for (before, share) in BEFORE[stage].iter().enumerate().take(stage) {
                for (base, slope) in self.base.iter_mut().zip(&self.slopes[before]) {
                    *base += h * share * slope;
                }
            }
            let (done, rest) = self.slopes.split_at_mut(stage);
            rest[0].copy_from_slice(&done[stage - 1]);
            iterations += system.stage(t + PLACES[stage] * h, &self.base, DIAGONAL * h, &mut rest[0])?;
        }
        for i in 0..n {
            self.next[i] = self.base[i] + DIAGONAL * h * self.slopes[STAGES - 1][i];
            let weight =
                |stage: usize| if stage + 1 == STAGES { DIAGONAL } else { BEFORE[STAGES - 1][stage] };
            self.error[i] =
                h * (0..STAGES).map(|s| (weight(s) - COMPARED[s]) * self.slopes[s][i]).sum::<f64>();
        }
        self.next.iter().all(|value| value.is_finite()).then_some(iterations)
    }

    /// Estimated error of the last attempt, by component.
    pub fn error(&self) -> &[f64] {
        &self.error
    }

    /// State at the end of the last attempt.
    pub fn next(&self) -> &[f64] {
        &self.next
    }

    /// Slope at the end of the last attempt.
    pub fn end_slope(&self) -> &[f64] {
        &self.slopes[STAGES - 1]
    }

    /// Takes the last attempt: `y` becomes its end.
    pub fn accept(&mut self, y: &mut [f64]) {
        y.copy_from_slice(&self.next);
        self.slopes.swap(0, STAGES - 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// y' = l (y - cos t) - sin t, exact y = cos t, stiff for large -l, and a quadrature of y.
    struct Prothero(f64);

    impl StageSystem for Prothero {
        fn dimension(&self) -> usize {
            2
        }

        fn slope(&mut self, t: f64, y: &[f64], slope: &mut [f64]) -> bool {
            slope.copy_from_slice(&[self.0 * (y[0] - t.cos()) - t.sin(), y[0]]);
            true
        }

        fn stage(&mut self, t: f64, base: &[f64], share: f64, slope: &mut [f64]) -> Option<u32> {
            let y = (base[0] - share * (self.0 * t.cos() + t.sin())) / (1.0 - share * self.0);
            slope.copy_from_slice(&[self.0 * (y - t.cos()) - t.sin(), y]);
            Some(1)
        }
    }

    fn run(rate: f64, steps: usize) -> ([f64; 2], f64) {
        let (mut system, mut integrator) = (Prothero(rate), Esdirk::new(2));
        let mut y = [1.0, 0.0];
        let h = 2.0 / steps as f64;
        let mut estimate = 0.0f64;
        for step in 0..steps {
            integrator.attempt(&mut system, step as f64 * h, h, &y).unwrap();
            estimate = estimate.max(integrator.error()[1].abs());
            integrator.accept(&mut y);
        }
        ([(y[0] - 2f64.cos()).abs(), (y[1] - 2f64.sin()).abs()], estimate)
    }

    #[test]
    fn the_error_falls_with_the_fourth_power_and_is_estimated() {
        let ([coarse, coarse_sum], estimate) = run(-1.0, 20);
        let ([fine, fine_sum], _) = run(-1.0, 40);
        for (name, ratio) in [("state", coarse / fine), ("sum", coarse_sum / fine_sum)] {
            assert!((13.0..20.0).contains(&ratio), "{name}: {ratio} instead of 2^4");
        }
        assert!(estimate > coarse_sum / 20.0, "{estimate} {coarse_sum}");
    }

    #[test]
    fn the_rows_add_up_to_their_places() {
        for (stage, row) in BEFORE.iter().enumerate().skip(1) {
            let sum: f64 = row.iter().sum::<f64>() + DIAGONAL;
            assert!((sum - PLACES[stage]).abs() < 1e-15, "{stage}: {sum}");
        }
        // Order 3 of the comparison: 1, 1/2, 1/3, 1/6 to rounding.
        let a = |i: usize, j: usize| {
            if i == j {
                DIAGONAL
            } else if j < i {
                BEFORE[i][j]
            } else {
                0.0
            }
        };
        let c = |i: usize| PLACES[i];
        let sum = |of: &dyn Fn(usize) -> f64| (0..STAGES).map(|i| COMPARED[i] * of(i)).sum::<f64>();
        let inner = |i: usize| (1..STAGES).map(|j| a(i, j) * c(j)).sum::<f64>();
        for (got, wanted) in [
            (sum(&|_| 1.0), 1.0),
            (sum(&c), 0.5),
            (sum(&|i| c(i) * c(i)), 1.0 / 3.0),
            (sum(&|i| if i == 0 { 0.0 } else { inner(i) }), 1.0 / 6.0),
        ] {
            assert!((got - wanted).abs() < 1e-14, "{got} {wanted}");
        }
    }

    #[test]
    fn a_stiff_component_follows_at_once() {
        let ([error, _], _) = run(-1e8, 20);
        assert!(error < 1e-9, "{error}");
        // A disturbance is gone after one step.
        let (mut system, mut integrator) = (Prothero(-1e10), Esdirk::new(2));
        let mut y = [2.0, 0.0];
        integrator.attempt(&mut system, 0.0, 0.1, &y).unwrap();
        integrator.accept(&mut y);
        assert!((y[0] - 0.1f64.cos()).abs() < 1e-7, "{}", y[0]);
    }
}
