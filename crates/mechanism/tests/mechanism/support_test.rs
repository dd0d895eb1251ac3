//! The comparison that all other tests rely on must itself be able to fail.
use crate::support;
use crate::support::assert_close;

#[test]
fn equal_values_pass() {
    assert_close("one", 1.0, 1.0, 0.0, 0.0, "identical");
    assert_close("one", 1.0 + 0.9e-12, 1.0, 0.0, 1e-12, "just inside");
}

#[test]
#[should_panic(expected = "force: got")]
fn a_perturbed_value_fails() {
    assert_close("force", 1.0 + 1.1e-12, 1.0, 0.0, 1e-12, "just outside");
}

#[test]
#[should_panic(expected = "force: got NaN")]
fn what_is_no_number_fails() {
    assert_close("force", f64::NAN, 1.0, 1e9, 1e9, "never close");
}

#[test]
fn a_perturbed_mass_is_seen_by_the_momentum_balance() {
    let engine = support::radial(5, 0.05);
    let request = lanchester_mechanism::LoadRequest::default();
    let mut other = engine.clone();
    other = other
        .with(|other| {
            other.cylinders[2].rod.big_end_mass *= 1.0 + 1e-4;
        })
        .unwrap();
    let got = lanchester_mechanism::Mechanism::new(&other, &request).unwrap().components(0.7);
    let wanted = support::brute::loads(&engine, [0.0; 3], 0.7, 300.0);
    let scale = got.force_x.hypot(got.force_y);
    assert!((got.force_x - wanted[0]).abs() > 1e-6 * scale, "a mass that is off by 1e-4 must show");
    assert!((got.roll_moment - wanted[4]).abs() > 1e-9 * scale, "a mass that is off by 1e-4 must show");
}
