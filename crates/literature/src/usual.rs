//! What the published methods take where their user says nothing.

use crate::comparison::PublishedMethod;
use crate::half_rules::{BalanceFactor, BalancerPhase, FourCylinderRule, ThreeCylinderRule};
use crate::matrix_method::{Alpha, MatrixMethod};
use crate::shaft_pair::ShaftPair;
use lanchester_balance::BalanceError;
use lanchester_model::Engine;

/// Distance of first-order shafts from the crank axis [m], Table 1 of the tool paper.
pub const SHAFT_DISTANCE: f64 = 0.1;

/// Distance of the outermost throws [m], the length of the methods' shafts; of a single throw its diameter.
pub fn outer_throws(engine: &Engine) -> f64 {
    let z = engine.throws.iter().map(|t| t.z);
    let (low, high) = z.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
    let radius = largest_radius(engine);
    if high - low > radius { high - low } else { 2.0 * radius }
}

/// Largest crank radius [m].
pub fn largest_radius(engine: &Engine) -> f64 {
    engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius))
}

impl MatrixMethod {
    /// Counterweights on every web at the crank radius and both pairs of shafts, at `distance` and twice that from the crank [m].
    pub fn usual(engine: &Engine, distance: f64) -> MatrixMethod {
        let (radius, length) = (largest_radius(engine), outer_throws(engine));
        let pair = |y: f64| Some(ShaftPair { radius, length, forward_y: y, backward_y: -y });
        MatrixMethod {
            web_pattern: Vec::new(),
            alpha: Alpha::Fitted,
            counterweight_radius: radius,
            first: pair(distance),
            second: pair(2.0 * distance),
            first_on_crank: false,
        }
    }
}

impl PublishedMethod {
    /// The rule of the thesis for `engine`: that of an in-line three or four, of any other engine the share of 50 % alone.
    pub fn half_rule(
        engine: &Engine,
        shaft_length: f64,
        distance: f64,
        phase: BalancerPhase,
    ) -> PublishedMethod {
        let three = ThreeCylinderRule { shaft_length, shaft_at: [0.0, distance], phase };
        let four = FourCylinderRule { forward_at: [0.0, distance], backward_at: [0.0, -distance] };
        // The rules know one engine each; any other has the share alone.
        match engine.cylinders.len() {
            3 if !matches!(three.fit(engine), Err(BalanceError::Unsuited { .. })) => {
                PublishedMethod::ThreeCylinder(three)
            }
            4 if !matches!(four.fit(engine), Err(BalanceError::Unsuited { .. })) => {
                PublishedMethod::FourCylinder(four)
            }
            _ => PublishedMethod::Factor(BalanceFactor::BEST),
        }
    }
}
