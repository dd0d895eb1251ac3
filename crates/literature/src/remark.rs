//! What to know about a result of the matrix method.

use serde::Serialize;
use std::fmt;

/// What to know about a result of the method.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Remark {
    /// The half-crank rule was used.
    HalfCrank,
    /// The rotating masses with their counterweights leave a force.
    StaticallyUnbalanced {
        /// [kg m]
        unbalance: f64,
    },
    /// The rotating masses with their counterweights leave a couple.
    CoupleLeft {
        /// [kg m^2]
        moment: f64,
    },
    /// The first order of the pistons turns with the crank alone.
    FirstOrderForwardOnly,
    /// The shafts of this order cancel its force; its couple stays.
    ShaftsLeaveCouple {
        /// Order.
        order: i32,
        /// Largest over the cycle [kg m^2].
        moment: f64,
    },
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Remark::HalfCrank => f.write_str(
                "the rotating masses of the whole crank balance one another: the counterweights are sized for its front \
                 half alone",
            ),
            Remark::StaticallyUnbalanced { unbalance } => write!(
                f,
                "the crank with these counterweights is statically unbalanced by {:.3} kg mm: choose other webs or \
                 another alpha",
                1e3 * unbalance
            ),
            Remark::CoupleLeft { moment } => write!(
                f,
                "the crank with these counterweights keeps a couple of {:.3} kg mm m: choose other webs or another alpha",
                1e3 * moment
            ),
            Remark::FirstOrderForwardOnly => f.write_str(
                "the first order of the pistons turns with the crank alone: heavier counterweights remove it, and no \
                 balance shaft is needed",
            ),
            Remark::ShaftsLeaveCouple { order, moment } => write!(
                f,
                "one weight a shaft cancels the force of order {order}; its couple of {:.3} kg mm m stays",
                1e3 * moment
            ),
        }
    }
}
