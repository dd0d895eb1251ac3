//! What the tool paper did with its V engine, kept to show where its printed masses come from.
//!
//! It adds the piston forces of both banks as if all cylinders stood in one line, and takes a maximum over the angle. The
//! digits of its Table 5 follow if that maximum is taken among the angles 0, 1, .., 6 **radians** (an inference: a range
//! "0 to 2 pi" in whole steps). For what is right, [`MatrixMethod::fit`] treats each sense for itself.

use crate::matrix_method::MatrixMethod;
use crate::resultant::{EngineResidual, Motion, reciprocating};
use crate::shaft_pair::shaft_name;
use lanchester_balance::BalanceError;
use lanchester_model::{BalanceShaft, Engine, EngineParts, Ratio, ShaftWeight};
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::{FRAC_PI_2, PI};

/// Where the maximum over the crank angle is sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum AngleRule {
    /// Over the continuous angle.
    Continuous,
    /// Among 0, 1, .., 6 rad, the largest with its sign.
    WholeRadians,
}

/// The shafts of the tool paper for a V engine, equal in both senses.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PrintedV {
    /// `m_c1`: mass of each of the two weights of each first-order shaft, against the unprojected moment [kg].
    pub first_mass: f64,
    /// `m_c2`: mass of the one weight of each second-order shaft, against the force across [kg].
    pub second_mass: f64,
    /// The engine with the counterweights of the method and these shafts alone.
    #[serde(skip)]
    pub engine: Engine,
    /// What that engine leaves over.
    pub residual: EngineResidual,
    /// The moment along the cylinders (vertical plane) that the first-order shafts make over the engine's own: 1 would
    /// cancel it.
    pub vertical_share: f64,
    /// The engine's own first-order moment across, which these shafts leave [kg m^2].
    pub horizontal_left: f64,
}

impl MatrixMethod {
    /// The shafts as the tool paper sizes them for a V engine.
    ///
    /// ```text
    /// first    A = SUM m r z e^{i (a - b)},              m_c1 = max Re(A e^{i theta}) / (2 r_c1 l_sh1)
    /// second   B = SUM m Lambda r sin b e^{2 i (a - b)}, m_c2 = max Re(B e^{2 i theta}) / (2 . 4 r_c2)
    /// ```
    ///
    /// # Errors
    /// As [`MatrixMethod::fit`]; [`BalanceError::Unsuited`] where no shafts are asked for.
    pub fn printed_v(&self, engine: &Engine, rule: AngleRule) -> Result<PrintedV, BalanceError> {
        let without_shafts =
            MatrixMethod { first: None, second: None, first_on_crank: false, ..self.clone() };
        let (Some(first), Some(second)) = (self.first, self.second) else {
            return Err(BalanceError::Unsuited {
                method: "the printed variant of the matrix method",
                needed: "shafts of first and second order",
                got: "none".to_owned(),
                hint: "give both pairs",
            });
        };
        let mut fitted = without_shafts.fit(engine)?.engine.into_parts();
        // Checks radii and lengths of the shafts too.
        self.fit(engine)?;
        let (mut moment, mut force) = (Complex64::ZERO, Complex64::ZERO);
        for cylinder in &engine.cylinders {
            let radius = engine.throws[cylinder.throw].radius;
            let phase = engine.pin_angle(cylinder.throw, 0.0) - cylinder.angle;
            let size = cylinder.reciprocating_mass() * radius;
            moment += size * cylinder.z * Complex64::cis(phase);
            let second = size * radius / cylinder.rod.length;
            force += second * cylinder.angle.sin() * Complex64::cis(2.0 * phase);
        }
        let pistons = reciprocating(engine, 1, Motion::Published)?;
        let first_unbalance = rule.largest(moment, 1) / (2.0 * first.length);
        let second_unbalance = rule.largest(force, 2) / (2.0 * 4.0);
        let half = 0.5 * first.length;
        let opposed = (-moment).arg();
        let weights = [(-half, opposed + PI), (half, opposed)];
        add_pair(&mut fitted, 1, [first.forward_y, first.backward_y], |sense| {
            weights.map(|(z, phase)| (z, first_unbalance, f64::from(sense) * phase)).to_vec()
        });
        let opposed = (-force).arg();
        add_pair(&mut fitted, 2, [second.forward_y, second.backward_y], |sense| {
            vec![(0.0, second_unbalance, FRAC_PI_2 + f64::from(sense) * opposed)]
        });
        // Along the cylinders' bisector, x: Re(Q_f e^{i theta} + Q_b e^{-i theta}).
        let vertical = pistons.forward.moment + pistons.backward.moment.conj();
        let horizontal = pistons.forward.moment - pistons.backward.moment.conj();
        let fitted = Engine::new(fitted).map_err(BalanceError::engine)?;
        Ok(PrintedV {
            first_mass: first_unbalance / first.radius,
            second_mass: second_unbalance / second.radius,
            residual: EngineResidual::of(&fitted)?,
            engine: fitted,
            vertical_share: 2.0 * first_unbalance * first.length / vertical.norm(),
            horizontal_left: horizontal.norm(),
        })
    }
}

impl AngleRule {
    /// Largest value of `Re(amplitude e^{i n theta})`.
    fn largest(self, amplitude: Complex64, n: u32) -> f64 {
        match self {
            AngleRule::Continuous => amplitude.norm(),
            AngleRule::WholeRadians => (0..=6u32)
                .map(|theta| (amplitude * Complex64::cis(f64::from(n * theta))).re)
                .fold(f64::NEG_INFINITY, f64::max),
        }
    }
}

/// Adds one shaft for each sense, with weights (z, unbalance, phase).
fn add_pair(
    engine: &mut EngineParts,
    order: i32,
    y: [f64; 2],
    weights: impl Fn(i32) -> Vec<(f64, f64, f64)>,
) {
    for (sense, y) in [1, -1].into_iter().zip(y) {
        engine.shafts.push(BalanceShaft {
            name: shaft_name(order, sense),
            ratio: Ratio::whole(sense * order).expect("invariant: an order is not 0"),
            x: 0.0,
            y,
            weights: weights(sense)
                .into_iter()
                .map(|(z, unbalance, phase)| ShaftWeight::new(z, unbalance, phase))
                .collect(),
            inertia: None,
        });
    }
}
