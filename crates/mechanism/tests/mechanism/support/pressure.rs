//! Pressures for tests: smooth and with jumps, of no cycle in particular, and one like a real one.

use lanchester_mechanism::CylinderGas;
use lanchester_model::Engine;
use lanchester_results::{End, PeriodicCurve};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Angle of the working cycle [rad].
pub fn cycle(engine: &Engine) -> f64 {
    TAU * f64::from(engine.strokes.revolutions())
}

/// Polytropic compression and expansion about a burnt mass that rises over 60 deg from firing; gas exchange near 1 bar.
pub fn diesel_like(engine: &Engine, peak: f64) -> CylinderGas {
    let period = cycle(engine);
    let ratio = 16.0f64;
    let volume = |t: f64| 1.0 + 0.5 * (ratio - 1.0) * (1.0 - t.cos());
    let pressure = |own: f64| {
        // From -half to half a cycle about firing.
        let t = (own + 0.5 * period).rem_euclid(period) - 0.5 * period;
        let burnt = 1.0 - (-5.0 * (t.max(0.0) / 1.0).powi(2)).exp();
        let closed = 0.5 * (1.0 - (4.0 * (t.abs() - 2.5)).tanh());
        let motored = 1e5 * (ratio / volume(t)).powf(1.32);
        1e5 + closed * (motored * (1.0 + (peak - 1.0) * burnt) - 1e5)
    };
    let count = 360 * engine.strokes.revolutions();
    let knots: Vec<f64> = (0..count).map(|j| period * f64::from(j) / f64::from(count)).collect();
    let values: Vec<f64> = knots.iter().map(|t| pressure(*t)).collect();
    CylinderGas {
        cylinder: PeriodicCurve::through(period, knots, &values).expect("knots rise"),
        crankcase: PeriodicCurve::constant(period, 1e5).expect("it is finite"),
    }
}

/// `height` [Pa] over the first `length` [rad] after firing, nothing else.
pub fn block(engine: &Engine, height: f64, length: f64) -> CylinderGas {
    let period = cycle(engine);
    let flat = |value| [End { value, slope: 0.0 }; 2];
    CylinderGas {
        cylinder: PeriodicCurve::from_ends(period, vec![0.0, length], &[flat(height), flat(0.0)])
            .expect("knots rise"),
        crankcase: PeriodicCurve::constant(period, 0.0).expect("it is finite"),
    }
}

/// A curve of cubic pieces that jump, at uneven knots, up to 100 bar.
pub fn any_curve(period: f64) -> impl Strategy<Value = PeriodicCurve> {
    let ends = prop::collection::vec((0.02..1.0f64, 0.0..1e7f64, 0.0..1e7f64, -1e7..1e7f64), 1..12);
    (ends, 0.0..1.0f64).prop_map(move |(pieces, start)| {
        let length: f64 = pieces.iter().map(|p| p.0).sum();
        let mut at = period * (start - 0.5);
        let mut knots = Vec::new();
        let mut ends = Vec::new();
        for (share, from, to, slope) in pieces {
            knots.push(at);
            at += period * share / length;
            ends.push([End { value: from, slope }, End { value: to, slope: -0.3 * slope }]);
        }
        PeriodicCurve::from_ends(period, knots, &ends).expect("knots rise")
    })
}

prop_compose! {
    /// Pressures for one cylinder.
    pub fn any_gas(period: f64)(cylinder in any_curve(period), crankcase in any_curve(period)) -> CylinderGas {
        CylinderGas { cylinder, crankcase }
    }
}

/// Bores and firings, near the dead centres that the reader would find.
pub fn fired(engine: Engine, bore: f64, strokes: lanchester_model::Strokes) -> Engine {
    let mut engine = engine.into_parts();
    engine.strokes = strokes;
    for (index, cylinder) in engine.cylinders.iter_mut().enumerate() {
        cylinder.bore = Some(bore + 0.002 * index as f64);
        cylinder.firing_angle = Some(1.7 * index as f64);
    }
    Engine::new(engine).unwrap()
}
