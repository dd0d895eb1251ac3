//! Nothing to do, more equations than needed, weights that are tied, bounded or on lines.

use crate::support::*;
use lanchester_balance::*;
use lanchester_model::*;

#[test]
fn nothing_is_needed_where_nothing_is_there() {
    let engine = stripped("in-line-6");
    let planes: Vec<f64> = engine.throws.iter().map(|t| t.z).collect();
    let answer =
        optimise(&engine, &task(on_crank(&planes), &[(Load::Force, 1.0), (Load::Couple, 1.0)])).unwrap();
    assert_eq!(assert_vanishes(&engine, &answer), 0.0);
    assert!(answer.weights.iter().all(|w| !w.used), "{:?}", answer.weights);
    // An order that no part of the engine has.
    let answer = optimise(&engine, &task(on_crank(&planes), &[(Load::Force, 3.7)])).unwrap();
    assert_eq!(assert_vanishes(&engine, &answer), 0.0);
}
