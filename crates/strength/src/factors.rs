//! Stress concentration factors of fillets and oil bores.
//!
//! ```text
//! alpha_B = 2.6914 f1(s,w) f(w) f(b) f(r) f(d_G) f(d_H) f_recess          bending, pin fillet             (book, eq. 49.1)
//! beta_B  = 2.7146 f2(s,w) f(w) f(b) f(r) f(d_G) f(d_H) f_recess          bending, journal fillet         (49.2)
//! beta_Q  = 3.0128 f(s) f(w) f(b) f(r) f(d_H) f_recess                    radial force, journal fillet    (49.3)
//! alpha_T, beta_T = 0.8 f(r,s) f(b) f(w)                                  torsion, both fillets           (49.4)
//! ```

use crate::ratios::SectionRatios;
use serde::Serialize;

/// Least overlap that enters f(s,w) and f(r,s).
const LEAST_OVERLAP: f64 = -0.5;

/// A stress concentration factor with what it is the product of.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Factor {
    /// The factor [1].
    pub value: f64,
    /// Its parts; their product is the factor.
    pub parts: Vec<FactorPart>,
}

/// A part of a factor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FactorPart {
    /// "f(s,w)"; "constant".
    pub name: &'static str,
    /// Its value [1].
    pub value: f64,
}

impl Factor {
    fn product(parts: &[(&'static str, f64)]) -> Factor {
        Factor {
            value: parts.iter().map(|part| part.1).product(),
            parts: parts.iter().map(|&(name, value)| FactorPart { name, value }).collect(),
        }
    }
}

/// Factors of the two fillets of a web [1].
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RuleFactors {
    /// Pin fillet, bending.
    pub alpha_b: Factor,
    /// Pin fillet, torsion.
    pub alpha_t: Factor,
    /// Journal fillet, bending.
    pub beta_b: Factor,
    /// Journal fillet, radial force.
    pub beta_q: Factor,
    /// Journal fillet, torsion.
    pub beta_t: Factor,
}

/// Values of the factors of the two fillets of a web [1].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FactorValues {
    /// Pin fillet, bending.
    pub alpha_b: f64,
    /// Pin fillet, torsion.
    pub alpha_t: f64,
    /// Journal fillet, bending.
    pub beta_b: f64,
    /// Journal fillet, radial force.
    pub beta_q: f64,
    /// Journal fillet, torsion.
    pub beta_t: f64,
}

/// Factors of an oil bore [1].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct OilFactors {
    /// Bending.
    pub gamma_b: f64,
    /// Torsion.
    pub gamma_t: f64,
}

/// c_0 + c_1 x + c_2 x^2 + ...
fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

impl RuleFactors {
    /// The formulas (49.1) to (49.4), inside or outside the range in which they hold ([`SectionRatios::breaches`]).
    pub fn new(ratios: &SectionRatios) -> RuleFactors {
        let SectionRatios { w, b, d_journal, d_pin, .. } = *ratios;
        let s = ratios.s.max(LEAST_OVERLAP);
        let recess = (1.0 + (ratios.t_pin + ratios.t_journal) * (1.8 + 3.2 * ratios.s)).max(1.0);
        let in_overlap = |by_w: [&[f64]; 3]| {
            let by_w = by_w.map(|coefficients| polynomial(coefficients, w));
            polynomial(&by_w, 1.0 - s)
        };
        let pin_overlap = in_overlap([
            &[-4.1883, 29.2004, -77.5925, 91.9454, -40.0416],
            &[9.5440, -58.3480, 159.3415, -192.5846, 85.2916],
            &[-3.8399, 25.0444, -70.5571, 87.0328, -39.1832],
        ]);
        let journal_overlap = in_overlap([
            &[-1.7625, 2.9821, -1.5276],
            &[5.1169, -5.8089, 3.1391],
            &[-2.1567, 2.3297, -1.2952],
        ]);
        let torsion = |r: f64| {
            Factor::product(&[
                ("constant", 0.8),
                ("f(r,s)", r.powf(-0.322 + 0.1015 * (1.0 - s))),
                ("f(b)", polynomial(&[7.8955, -10.654, 5.3482, -0.857], b)),
                ("f(w)", w.powf(-0.145)),
            ])
        };
        RuleFactors {
            alpha_b: Factor::product(&[
                ("constant", 2.6914),
                ("f(s,w)", pin_overlap),
                ("f(w)", 2.1790 * w.powf(0.7171)),
                ("f(b)", polynomial(&[0.6840, -0.0077, 0.1473], b)),
                ("f(r)", 0.2081 * ratios.r_pin.powf(-0.5231)),
                ("f(d_G)", polynomial(&[0.9993, 0.27, -1.0211, 0.5306], d_journal)),
                ("f(d_H)", polynomial(&[0.9978, 0.3145, -1.5241, 2.4147], d_pin)),
                ("f(recess)", recess),
            ]),
            alpha_t: torsion(ratios.r_pin),
            beta_b: Factor::product(&[
                ("constant", 2.7146),
                ("f(s,w)", journal_overlap),
                ("f(w)", 2.2422 * w.powf(0.7548)),
                ("f(b)", polynomial(&[0.5616, 0.1197, 0.1176], b)),
                ("f(r)", 0.1908 * ratios.r_journal.powf(-0.5568)),
                ("f(d_G)", polynomial(&[1.0012, -0.6441, 1.2265], d_journal)),
                ("f(d_H)", polynomial(&[1.0022, -0.1903, 0.0073], d_pin)),
                ("f(recess)", recess),
            ]),
            beta_q: Factor::product(&[
                ("constant", 3.0128),
                ("f(s)", polynomial(&[0.4368, 2.1630, -1.5212], 1.0 - ratios.s)),
                ("f(w)", w / (0.0637 + 0.9369 * w)),
                ("f(b)", b - 0.5),
                ("f(r)", 0.5331 * ratios.r_journal.powf(-0.2038)),
                ("f(d_H)", polynomial(&[0.9937, -1.1949, 1.7373], d_pin)),
                ("f(recess)", recess),
            ]),
            beta_t: torsion(ratios.r_journal),
        }
    }
}

impl RuleFactors {
    /// The factors without their parts.
    pub fn values(&self) -> FactorValues {
        FactorValues {
            alpha_b: self.alpha_b.value,
            alpha_t: self.alpha_t.value,
            beta_b: self.beta_b.value,
            beta_q: self.beta_q.value,
            beta_t: self.beta_t.value,
        }
    }
}

impl OilFactors {
    /// Of an oil bore of `d_oil` pin diameters [1].
    ///
    /// ```text
    /// gamma_B = 3 - 5.88 d_O + 34.6 d_O^2      gamma_T = 4 - 6 d_O + 30 d_O^2                                     (49.5)
    /// ```
    pub fn new(d_oil: f64) -> OilFactors {
        OilFactors {
            gamma_b: polynomial(&[3.0, -5.88, 34.6], d_oil),
            gamma_t: polynomial(&[4.0, -6.0, 30.0], d_oil),
        }
    }
}
