//! DOP853: order, dense output, stops, events, limits.

use lanchester_numerics::{Dop853, Function, Outcome, Settings, Step, System};
use std::f64::consts::PI;
use std::ops::ControlFlow;

const GO: ControlFlow<()> = ControlFlow::Continue(());

fn kepler(_t: f64, y: &[f64], dy: &mut [f64]) {
    let cube = (y[0] * y[0] + y[1] * y[1]).powf(1.5);
    dy.copy_from_slice(&[y[2], y[3], -y[0] / cube, -y[1] / cube]);
}

/// Kepler's ellipse of eccentricity e at mean anomaly t.
fn ellipse(e: f64, t: f64) -> [f64; 4] {
    let mut anomaly = t;
    for _ in 0..60 {
        anomaly -= (anomaly - e * anomaly.sin() - t) / (1.0 - e * anomaly.cos());
    }
    let (s, c) = anomaly.sin_cos();
    let b = (1.0 - e * e).sqrt();
    let rate = 1.0 / (1.0 - e * c);
    [c - e, b * s, -s * rate, b * c * rate]
}

fn fixed_steps(count: u32) -> (f64, f64) {
    let h = 1.0 / f64::from(count);
    let mut settings = Settings::uniform(4, 1e3);
    settings.first_step = Some(h);
    settings.longest_step = h;
    let (mut t, mut y) = (0.0, ellipse(0.3, 0.0).to_vec());
    let mut between = 0.0f64;
    let outcome = Dop853::new(settings).run(&mut Function::new(4, kepler), &mut t, &mut y, 1.0, |step| {
        for share in [0.15, 0.35, 0.55, 0.85] {
            let t = step.from + share * (step.to - step.from);
            let exact = ellipse(0.3, t);
            for i in 0..4 {
                between = between.max((step.component(i, t) - exact[i]).abs());
            }
        }
        GO
    });
    assert_eq!(outcome, Outcome::Reached);
    let exact = ellipse(0.3, 1.0);
    let end = (0..4).map(|i| (y[i] - exact[i]).abs()).fold(0.0, f64::max);
    (end, between)
}

#[test]
fn conv_steps_have_order_eight_and_the_interpolant_order_seven() {
    let (coarse, fine) = (fixed_steps(4), fixed_steps(8));
    let order = (coarse.0 / fine.0).log2();
    let between = (coarse.1 / fine.1).log2();
    assert!(order > 7.6, "order {order}: {coarse:?} {fine:?}");
    assert!(between > 6.7, "order between the ends {between}: {coarse:?} {fine:?}");
}

#[test]
fn tolerance_is_the_error_at_every_sample() {
    for exponent in 7..=13 {
        let tolerance = 10f64.powi(-exponent);
        let (mut t, mut y) = (0.0, ellipse(0.3, 0.0).to_vec());
        let (mut worst, mut ends) = (0.0f64, 0.0f64);
        let mut solver = Dop853::new(Settings::uniform(4, tolerance));
        let outcome = solver.run(&mut Function::new(4, kepler), &mut t, &mut y, 2.0 * PI, |step| {
            let exact = ellipse(0.3, step.to);
            ends = (0..4).map(|i| (step.end[i] - exact[i]).abs()).fold(ends, f64::max);
            for k in 1..20 {
                let t = step.from + f64::from(k) / 20.0 * (step.to - step.from);
                let exact = ellipse(0.3, t);
                worst = (0..4).map(|i| (step.component(i, t) - exact[i]).abs()).fold(worst, f64::max);
            }
            GO
        });
        assert_eq!(outcome, Outcome::Reached);
        // Each step adds an error of up to the tolerance, and an error of the energy alone grows by 3 pi a revolution.
        let steps = f64::from(u32::try_from(solver.statistics().steps).unwrap());
        assert!(worst < 3.0 * steps * tolerance, "{worst:e} at tolerance {tolerance:e}");
        assert!(worst < 10.0 * ends, "between the ends {worst:e}, at them {ends:e}");
    }
}

#[test]
fn backwards_comes_to_the_start_again() {
    let (mut t, mut y) = (0.0, ellipse(0.3, 0.0).to_vec());
    let mut solver = Dop853::new(Settings::uniform(4, 1e-12));
    assert_eq!(solver.run(&mut Function::new(4, kepler), &mut t, &mut y, 3.0, |_| GO), Outcome::Reached);
    assert_eq!(solver.run(&mut Function::new(4, kepler), &mut t, &mut y, 0.0, |_| GO), Outcome::Reached);
    let start = ellipse(0.3, 0.0);
    let off = (0..4).map(|i| (y[i] - start[i]).abs()).fold(0.0, f64::max);
    assert!(off < 1e-10 && t == 0.0, "{off:e} off");
}

/// y' = slope that jumps at 1 and 2.
struct Pieces {
    slope: f64,
}

impl System for Pieces {
    fn dimension(&self) -> usize {
        1
    }
    fn enter(&mut self, from: f64, to: f64) {
        self.slope = if 0.5 * (from + to) < 1.0 {
            3.0
        } else if 0.5 * (from + to) < 2.0 {
            -1.0
        } else {
            10.0
        };
    }
    fn derivative(&mut self, t: f64, _y: &[f64], dy: &mut [f64]) {
        dy[0] = self.slope * t;
    }
}

#[test]
fn steps_end_at_stops_and_jumps_there_cost_nothing() {
    let mut settings = Settings::uniform(1, 1e-12);
    settings.stops = vec![2.0, 1.0, 7.0];
    let (mut t, mut y) = (0.0, vec![0.0]);
    let mut ends = Vec::new();
    let mut solver = Dop853::new(settings);
    let outcome = solver.run(&mut Pieces { slope: 0.0 }, &mut t, &mut y, 3.0, |step| {
        ends.push(step.to);
        GO
    });
    assert_eq!(outcome, Outcome::Reached);
    assert!(ends.contains(&1.0) && ends.contains(&2.0) && t == 3.0, "{ends:?}");
    assert!((y[0] - (1.5 - 1.5 + 25.0)).abs() < 1e-13, "{}", y[0]);
    assert_eq!(solver.statistics().rejected, 0);
}

/// A ball under gravity that bounces without loss.
struct Ball;

impl System for Ball {
    fn dimension(&self) -> usize {
        2
    }
    fn derivative(&mut self, _t: f64, y: &[f64], dy: &mut [f64]) {
        dy.copy_from_slice(&[y[1], -10.0]);
    }
    fn events(&self) -> usize {
        1
    }
    fn event_functions(&mut self, _t: f64, y: &[f64], values: &mut [f64]) {
        values[0] = y[0];
    }
}

#[test]
fn bounces_are_located_to_a_trillionth() {
    let (mut t, mut y) = (0.0, vec![5.0, 0.0]);
    let mut solver = Dop853::new(Settings::uniform(2, 1e-13));
    for bounce in 0..20 {
        let outcome = solver.run(&mut Ball, &mut t, &mut y, 100.0, |step: &Step| {
            assert!(step.end[0] > -1e-9, "no state behind the wall is shown");
            GO
        });
        assert_eq!(outcome, Outcome::Event { index: 0, rising: false });
        let exact = 1.0 + 2.0 * f64::from(bounce);
        // Each bounce is found up to 1e-12 s late, which lets the ball gain that much speed for every later flight.
        assert!((t - exact).abs() < 1e-12 * f64::from(bounce + 1).powi(2), "bounce {bounce} at {t}");
        y[1] = -y[1];
        y[0] = 0.0;
        solver.restart();
    }
    assert_eq!(solver.statistics().events, 20);
}

#[test]
fn every_end_of_a_run_is_an_outcome_and_none_hangs() {
    let run = |f: fn(f64, &[f64], &mut [f64]), start: f64, settings: Settings| {
        let (mut t, mut y) = (0.0, vec![start]);
        let outcome = Dop853::new(settings).run(&mut Function::new(1, f), &mut t, &mut y, 10.0, |_| GO);
        (outcome, t, y[0])
    };
    let (outcome, t, y) = run(|_, y, dy| dy[0] = y[0] * y[0], 1.0, Settings::uniform(1, 1e-9));
    assert!(matches!(outcome, Outcome::StepTooSmall { .. } | Outcome::NotFinite { .. }), "{outcome:?}");
    assert!((t - 1.0).abs() < 1e-6 && y.is_finite(), "blows up at 1: {t} {y}");
    let (outcome, t, _) = run(|t, _, dy| dy[0] = (2.0 - t).sqrt(), 1.0, Settings::uniform(1, 1e-9));
    assert_eq!(outcome, Outcome::NotFinite { component: 0 });
    assert!((t - 2.0).abs() < 1e-6, "{t}");
    let mut little = Settings::uniform(1, 1e-9);
    little.most_evaluations = 200;
    let (outcome, ..) = run(|t, _, dy| dy[0] = (1000.0 * t).sin(), 1.0, little);
    assert_eq!(outcome, Outcome::TooManyEvaluations { limit: 200 });
    let mut stiff = Settings::uniform(1, 1e-6);
    stiff.stiffness_test = true;
    let (outcome, ..) = run(|t, y, dy| dy[0] = -1e5 * (y[0] - t.cos()), 1.0, stiff);
    assert!(matches!(outcome, Outcome::Stiff { .. }), "{outcome:?}");
    let (outcome, ..) = run(|_, _, dy| dy[0] = f64::NAN, 1.0, Settings::uniform(1, 1e-9));
    assert_eq!(outcome, Outcome::NotFinite { component: 0 });
}

/// A run that is cut into short ones goes on with the step that the last one proposes: an integrator that is told it needs no more evaluations than one that keeps it itself.
#[test]
fn a_run_goes_on_with_the_proposed_step() {
    let settings = Settings::uniform(4, 1e-10);
    let mut kept = Dop853::new(settings.clone());
    let (mut t, mut y) = (0.0, ellipse(0.3, 0.0).to_vec());
    let (mut told_t, mut told_y) = (t, y.clone());
    let (mut step, mut evaluations) = (None, 0);
    assert_eq!(kept.proposed_step(), None);
    for piece in 1..=40 {
        let end = 0.05 * f64::from(piece);
        assert_eq!(kept.run(&mut Function::new(4, kepler), &mut t, &mut y, end, |_| GO), Outcome::Reached);
        let mut told = Dop853::new(Settings { first_step: step, ..settings.clone() });
        let outcome = told.run(&mut Function::new(4, kepler), &mut told_t, &mut told_y, end, |_| GO);
        assert_eq!(outcome, Outcome::Reached);
        step = told.proposed_step();
        evaluations += told.statistics().evaluations;
        assert_eq!((t, &y, kept.proposed_step()), (told_t, &told_y, step));
    }
    assert_eq!(kept.statistics().evaluations, evaluations);
    assert!(step.is_some_and(|step| step > 0.05), "a short piece does not shorten it: {step:?}");
}
