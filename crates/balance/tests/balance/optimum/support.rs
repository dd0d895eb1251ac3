//! Engines of the gallery and tasks for them.

use lanchester_balance::{Answer, Outcome};
use lanchester_mechanism::{LoadRequest, Mechanism};
use lanchester_model::*;
use lanchester_task::*;

pub use lanchester_testkit::gallery::gallery as engine;

/// The engine without counterweights and shafts.
pub fn stripped(name: &str) -> Engine {
    engine(name).without_counterweights().without_shafts()
}

pub fn on_crank(name: &str, z: f64) -> FreeWeight {
    weight(name, Seat::Crankshaft(0), z)
}

pub fn weight(name: &str, seat: Seat, z: f64) -> FreeWeight {
    FreeWeight::new(name, seat, Place::At(z))
}

pub fn shaft(name: &str, ratio: i32, x: f64, y: f64) -> FreeShaft {
    FreeShaft {
        name: name.into(),
        ratio: Ratio::whole(ratio).expect("not 0"),
        x: Place::At(x),
        y: Place::At(y),
        optional: false,
    }
}

pub fn stage(load: Load) -> Stage {
    Stage { terms: vec![(1.0, Criterion::Peak(load))] }
}

/// Peak of the resultant force (0), couple (1) or roll moment (2) over `count` angles of the loads' own exact kernel.
pub fn grid_peak(engine: &Engine, which: usize, count: usize) -> f64 {
    let mechanism = Mechanism::new(engine, &LoadRequest::default()).expect("a valid engine");
    (0..count)
        .map(|j| {
            let c = mechanism.components(mechanism.period() * j as f64 / count as f64);
            [c.force_x.hypot(c.force_y), c.couple_x.hypot(c.couple_y), c.roll_moment.abs()][which]
        })
        .fold(0.0, f64::max)
}

/// What all moving masses would do if none cancelled another [N]: rounding is measured against it.
pub fn all_masses(engine: &Engine) -> f64 {
    let one = |c: &Cylinder| (c.piston_mass + c.rod.mass()) * engine.throws[c.throw].radius;
    let moving: f64 = engine.cylinders.iter().map(one).sum();
    let turning = engine.throws.iter().map(|throw| throw.unbalance);
    let turning: f64 = turning.chain(engine.counterweights.iter().map(|weight| weight.unbalance)).sum();
    (moving + turning) * engine.speed.highest.powi(2)
}

/// Refuses an answer that is not proved to the promised gap, or to rounding where everything cancels.
pub fn assert_proved(engine: &Engine, answer: &Answer) {
    assert_eq!(answer.outcome, Outcome::Optimal, "{answer:#?}");
    for stage in &answer.stages {
        let unbalanced: f64 = stage
            .terms
            .iter()
            .map(|(criterion, _)| {
                answer.effects.iter().find(|e| e.criterion == *criterion).map_or(0.0, |e| e.without)
            })
            .sum();
        let allowed = (1e-8 * stage.value.max(1e-6 * unbalanced)).max(1e-13 * all_masses(engine));
        assert!(stage.gap <= allowed, "gap {:.3e} of {:.6}, allowed {allowed:.3e}", stage.gap, stage.value);
    }
}

/// A random search is proved, or says why the last digits are open: too many boxes, where a whole range of choices is
/// equally good, or rounding.
#[allow(dead_code, reason = "for searches of axes alone")]
pub fn proved_or_told(engine: &Engine, answer: &Answer) -> Result<(), String> {
    match &answer.outcome {
        Outcome::Stopped { reason, .. } => {
            let gap = answer.stages[0].gap / answer.stages[0].value;
            let told = reason.contains("largest number of nodes") || reason.contains("rounding");
            if told && gap < 1e-5 { Ok(()) } else { Err(format!("{gap:e}: {reason}")) }
        }
        Outcome::Optimal => {
            assert_proved(engine, answer);
            Ok(())
        }
        other => Err(format!("{other:?}")),
    }
}
