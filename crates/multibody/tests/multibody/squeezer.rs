//! Andrews' squeezer, problem `andrews` of the Test Set for IVP Solvers, on the referee: seven bodies, hinges, three loops.

use lanchester_multibody::referee::squeezer::{squeezer, squeezer_angles};

#[test]
fn lit_andrews_squeezer() {
    let (assembly, poses) = squeezer();
    // Start values are printed to thirty digits: the loops close.
    assert!(assembly.largest_gap(&poses) < 1e-15);
    let got = squeezer_angles(0.03).expect("it runs");
    let published =
        [15.81077119629904, -15.75637105984298, 0.04082224013073101, -0.5347301163226948, 0.5244099658805304];
    for (got, wanted) in got.into_iter().zip(published) {
        assert!((got - wanted).abs() < 1e-9 * wanted.abs().max(1.0), "{got} {wanted}: {:e}", got - wanted);
    }
}
