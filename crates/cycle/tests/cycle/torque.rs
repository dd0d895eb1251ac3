//! A torque over the crank angle from CSV.

use lanchester_cycle::read_torque;
use std::f64::consts::TAU;

/// A file of a torque at angles [deg].
fn file(header: &str, angles: impl Iterator<Item = f64>, torque: impl Fn(f64) -> f64) -> String {
    let lines = angles.map(|angle| format!("{angle},{}\n", torque(angle.to_radians())));
    format!("{header}\n{}", lines.collect::<String>())
}

fn steps(to: i32) -> impl Iterator<Item = f64> {
    (0..=to / 5).map(|k| 5.0 * f64::from(k))
}

const HEADER: &str = "theta [deg],torque [N m]";

/// A sum of three orders comes back as these orders, whatever the unit; what the spline between the samples adds is of the fourth power of their distance.
#[test]
fn the_orders_of_a_curve_come_back() {
    let torque = |theta: f64| 20.0 + 30.0 * (1.5 * theta).sin() - 12.0 * theta.cos();
    let read = |header: &str, factor: f64| {
        let text = file(header, steps(720), |theta| factor * torque(theta));
        read_torque(&text, "torque.csv", None).expect("a good file")
    };
    let found = read(HEADER, 1.0);
    let order = |n: f64| found.orders.iter().find(|one| (one.order - n).abs() < 1e-12).copied();
    let [mean, first, half] = [0.0, 1.0, 1.5].map(|n| order(n).expect("it is there"));
    for (name, got, wanted) in [
        ("mean", mean.cos, 20.0),
        ("first", first.cos, -12.0),
        ("1.5th", half.sin, 30.0),
        ("no sine", first.sin, 0.0),
    ] {
        // (h n)^4 / 720 of a spline at 5 deg, of 30 N m: 2e-5.
        assert!((got - wanted).abs() < 1e-4, "{name}: {got} {wanted}");
    }
    assert!(found.departure < 1e-5, "{}", found.departure);
    let kilo = read("crank (deg);torque (kN m)".replace(';', ",").as_str(), 1e-3);
    for (a, b) in kilo.orders.iter().zip(&found.orders) {
        assert!((a.cos - b.cos).abs() < 1e-9 && (a.sin - b.sin).abs() < 1e-9);
    }
}

/// The period is as many whole revolutions as the angles span, or what is said.
#[test]
fn the_period_is_that_of_the_angles_or_said() {
    let wave = |theta: f64| (2.0 * theta).cos();
    let lowest = |text: &str, period: Option<f64>| {
        let found = read_torque(text, "torque.csv", period).expect("a good file");
        found.orders.iter().map(|one| one.order).filter(|order| *order > 0.0).fold(f64::INFINITY, f64::min)
    };
    let with_end = file(HEADER, steps(360), wave);
    let without_end = file(HEADER, steps(355), wave);
    assert!((lowest(&with_end, None) - 2.0).abs() < 1e-12);
    assert!((lowest(&without_end, None) - 2.0).abs() < 1e-12);
    let half = file(HEADER, steps(180), wave);
    assert!((lowest(&half, Some(TAU / 2.0)) - 2.0).abs() < 1e-12);
    // Half a revolution is no whole one.
    assert_eq!(read_torque(&half, "torque.csv", None).expect_err("a gap").fault.code(), "E1612");
}

/// A jump has more orders than are kept: how far their sum stays off is said.
#[test]
fn a_jump_says_how_far_its_orders_are_off() {
    let text = file(HEADER, (0..720).map(f64::from), |theta| if theta < TAU / 2.0 { 50.0 } else { -50.0 });
    let text = format!("{text}720,50\n");
    let found = read_torque(&text, "torque.csv", None).expect("a good file");
    assert!(found.orders.len() <= 65 && found.departure > 0.05, "{}", found.departure);
}

#[test]
fn every_mistake_is_named() {
    let good = |theta: f64| 10.0 + theta.cos();
    for (code, text) in [
        ("E1621", "theta [deg],torque [bar]"),
        ("E1621", "theta [deg],torque"),
        ("E1622", "theta [deg],a [N m],b [N m]"),
        ("E1622", "theta [deg]"),
        ("E1603", "a [N m],b [N m]"),
    ] {
        let error = read_torque(&file(text, steps(360), good), "torque.csv", None).expect_err(code);
        assert_eq!(error.fault.code(), code, "{text}: {error}");
        assert!(error.to_string().contains("hint:"), "{error}");
    }
    let open = file(HEADER, steps(360), |theta| theta);
    assert_eq!(read_torque(&open, "torque.csv", None).expect_err("it is open").fault.code(), "E1623");
    let few = file(HEADER, [0.0, 90.0, 180.0].into_iter(), good);
    assert_eq!(read_torque(&few, "torque.csv", None).expect_err("too few").fault.code(), "E1608");
    let text = file(HEADER, steps(360), good).replacen("5,", "5,x", 1);
    let error = read_torque(&text, "torque.csv", None).expect_err("no number");
    assert_eq!((error.fault.code(), error.line), ("E1607", Some(3)));
}
