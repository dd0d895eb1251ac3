//! Radau IIA: order, the stiff problems of the literature, index 1, limits.

use lanchester_numerics::{Function, Outcome, Radau5, Settings, System};
use std::ops::ControlFlow;

const GO: ControlFlow<()> = ControlFlow::Continue(());

/// Van der Pol's oscillator with mu = 1000 in its own time.
struct VanDerPol {
    exact_jacobian: bool,
}

impl System for VanDerPol {
    fn dimension(&self) -> usize {
        2
    }
    fn derivative(&mut self, _t: f64, y: &[f64], dy: &mut [f64]) {
        dy.copy_from_slice(&[y[1], 1000.0 * (1.0 - y[0] * y[0]) * y[1] - y[0]]);
    }
    fn jacobian(&mut self, _t: f64, y: &[f64], j: &mut [f64]) -> bool {
        j.copy_from_slice(&[0.0, 1.0, -2000.0 * y[0] * y[1] - 1.0, 1000.0 * (1.0 - y[0] * y[0])]);
        self.exact_jacobian
    }
}

#[test]
fn lit_testset_van_der_pol_error_follows_the_tolerance() {
    for (exponent, bar) in [(6, 1e-4), (8, 2e-6), (10, 5e-8), (11, 1e-8)] {
        for exact_jacobian in [true, false] {
            let (mut t, mut y) = (0.0, vec![2.0, 0.0]);
            let mut solver = Radau5::new(Settings::uniform(2, 10f64.powi(-exponent)));
            let outcome = solver.run(&mut VanDerPol { exact_jacobian }, &mut t, &mut y, 2000.0, |_| GO);
            assert_eq!(outcome, Outcome::Reached);
            let off = (y[0] - 1.706167732170).abs();
            println!("1e-{exponent} {exact_jacobian}: {off:e} {:?}", solver.statistics());
            assert!(off < bar, "tolerance 1e-{exponent}, exact Jacobian {exact_jacobian}: {off:e} off");
        }
    }
}

#[test]
fn lit_testset_robertson_to_1e11() {
    let f = |_t: f64, y: &[f64], dy: &mut [f64]| {
        let (slow, fast, square) = (0.04 * y[0], 1e4 * y[1] * y[2], 3e7 * y[1] * y[1]);
        dy.copy_from_slice(&[fast - slow, slow - fast - square, square]);
    };
    let mut settings = Settings::uniform(3, 1e-10);
    settings.absolute = vec![1e-17, 1e-22, 1e-14];
    let (mut t, mut y) = (0.0, vec![1.0, 0.0, 0.0]);
    let mut solver = Radau5::new(settings);
    assert_eq!(solver.run(&mut Function::new(3, f), &mut t, &mut y, 1e11, |_| GO), Outcome::Reached);
    println!("{y:?} {:?}", solver.statistics());
    for (got, want) in y.iter().zip([0.2083340149701255e-7, 0.8333360770334713e-13, 0.999999979166505]) {
        assert!((got / want - 1.0).abs() < 1e-8, "{got:e} instead of {want:e}");
    }
}

/// Chemical Akzo Nobel problem: five reactions with one equilibrium, index 1.
struct Akzo;

impl System for Akzo {
    fn dimension(&self) -> usize {
        6
    }
    fn derivative(&mut self, _t: f64, y: &[f64], dy: &mut [f64]) {
        let root = y[1].max(0.0).sqrt();
        let r1 = 18.7 * y[0].powi(4) * root;
        let r2 = 0.58 * y[2] * y[3];
        let r3 = 0.58 / 34.4 * y[0] * y[4];
        let r4 = 0.09 * y[0] * y[3] * y[3];
        let r5 = 0.42 * y[5] * y[5] * root;
        let inflow = 3.3 * (0.9 / 737.0 - y[1]);
        dy.copy_from_slice(&[
            -2.0 * r1 + r2 - r3 - r4,
            -0.5 * r1 - r4 - 0.5 * r5 + inflow,
            r1 - r2 + r3,
            -r2 + r3 - 2.0 * r4,
            r2 - r3 + r5,
            115.83 * y[0] * y[3] - y[5],
        ]);
    }
    fn mass(&self) -> Option<Vec<f64>> {
        Some((0..36).map(|k| f64::from(u8::from(k % 7 == 0 && k < 35))).collect())
    }
}

#[test]
fn lit_testset_chemical_akzo_nobel() {
    let (mut t, mut y) = (0.0, vec![0.444, 0.00123, 0.0, 0.007, 0.0, 115.83 * 0.444 * 0.007]);
    let mut settings = Settings::uniform(6, 1e-11);
    settings.absolute = vec![1e-15; 6];
    let mut solver = Radau5::new(settings);
    assert_eq!(solver.run(&mut Akzo, &mut t, &mut y, 180.0, |_| GO), Outcome::Reached);
    println!("{y:?} {:?}", solver.statistics());
    let reference = [
        0.1150794920661702,
        0.1203831471567715e-2,
        0.1611562887407974,
        0.3656156421249283e-3,
        0.1708010885264404e-1,
        0.4873531310307455e-2,
    ];
    for (got, want) in y.iter().zip(reference) {
        assert!((got / want - 1.0).abs() < 1e-9, "{got:e} instead of {want:e}");
    }
}

/// y' = -2 y + sin 3 t: linear, so that Newton's iteration is exact however large the tolerance.
struct Driven;

impl System for Driven {
    fn dimension(&self) -> usize {
        1
    }
    fn derivative(&mut self, t: f64, y: &[f64], dy: &mut [f64]) {
        dy[0] = -2.0 * y[0] + (3.0 * t).sin();
    }
    fn jacobian(&mut self, _t: f64, _y: &[f64], j: &mut [f64]) -> bool {
        j[0] = -2.0;
        true
    }
}

#[test]
fn conv_order_five() {
    let error = |count: u32| {
        let h = 1.0 / f64::from(count);
        let mut settings = Settings::uniform(1, 1e3);
        settings.first_step = Some(h);
        settings.longest_step = h;
        let (mut t, mut y) = (0.0, vec![1.0]);
        assert_eq!(Radau5::new(settings).run(&mut Driven, &mut t, &mut y, 1.0, |_| GO), Outcome::Reached);
        let forced = |t: f64| (2.0 * (3.0 * t).sin() - 3.0 * (3.0 * t).cos()) / 13.0;
        (y[0] - forced(1.0) - (1.0 - forced(0.0)) * (-2f64).exp()).abs()
    };
    let (coarse, fine) = (error(8), error(16));
    let order = (coarse / fine).log2();
    assert!(order > 4.8 && order < 5.3, "order {order}: {coarse:e} {fine:e}");
}

/// Two algebraic unknowns of which the equations see the sum alone.
struct Index0Lost;

impl System for Index0Lost {
    fn dimension(&self) -> usize {
        2
    }
    fn derivative(&mut self, _t: f64, y: &[f64], dy: &mut [f64]) {
        dy.copy_from_slice(&[y[0] + y[1], 2.0 * (y[0] + y[1])]);
    }
    fn mass(&self) -> Option<Vec<f64>> {
        Some(vec![0.0; 4])
    }
}

#[test]
fn every_end_of_a_run_is_an_outcome_and_none_hangs() {
    let (mut t, mut y) = (0.0, vec![0.0, 0.0]);
    let outcome = Radau5::new(Settings::uniform(2, 1e-8)).run(&mut Index0Lost, &mut t, &mut y, 1.0, |_| GO);
    assert_eq!(outcome, Outcome::Singular);
    let run = |f: fn(f64, &[f64], &mut [f64]), most: u64| {
        let (mut t, mut y) = (0.0, vec![1.0]);
        let mut settings = Settings::uniform(1, 1e-9);
        settings.most_evaluations = most;
        let outcome = Radau5::new(settings).run(&mut Function::new(1, f), &mut t, &mut y, 10.0, |_| GO);
        (outcome, t)
    };
    let (outcome, t) = run(|_, y, dy| dy[0] = y[0] * y[0], 1_000_000);
    assert!(!matches!(outcome, Outcome::Reached), "{outcome:?}");
    assert!(t < 1.0 + 1e-6, "{t}");
    assert!(matches!(run(|_, _, dy| dy[0] = f64::NAN, 1000).0, Outcome::NotFinite { component: 0 }));
    assert!(matches!(
        run(|t, _, dy| dy[0] = (1e5 * t).sin() * 1e5, 500).0,
        Outcome::TooManyEvaluations { .. }
    ));
}
