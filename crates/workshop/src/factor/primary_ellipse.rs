//! The primary ellipse: the path of the tip of the first-order force.
//!
//! ```text
//! F / w^2 = f_+ e^{i psi} + f_- e^{-i psi}
//! half axes |f_+| + |f_-|,  | |f_+| - |f_-| |;   tilt of the longer one (arg f_+ + arg f_-) / 2
//! along a direction e^{ia}: amplitude |f_+ e^{-ia} + conj(f_- e^{-ia})|
//! ```
//! It turns with the crank where `|f_+| > |f_-|`, against it where less, and swings in a line where they are equal.

use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::{FRAC_PI_2, PI};

/// Share of the larger part below which a difference counts as none.
const NOTHING: f64 = 1e-9;

/// Which way a first-order force turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// With the crank.
    With,
    /// Against the crank.
    Against,
    /// Neither: it swings in a line.
    Line,
    /// There is none.
    None,
}

impl Sense {
    /// Words for tables.
    pub fn name(self) -> &'static str {
        match self {
            Sense::With => "with the crank",
            Sense::Against => "against the crank",
            Sense::Line => "in a line",
            Sense::None => "none",
        }
    }
}

/// A first-order force over the square of the speed, as an ellipse.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PrimaryEllipse {
    /// Part that turns with the crank [kg m], in the frame of the throw.
    #[schemars(with = "[f64; 2]")]
    pub forward: Complex64,
    /// Part that turns against the crank [kg m].
    #[schemars(with = "[f64; 2]")]
    pub backward: Complex64,
    /// Semi-major axis [kg m]: times `w^2` the peak of the force [N].
    pub major: f64,
    /// Shorter half axis [kg m].
    pub minor: f64,
    /// Direction of the longer axis in the engine's frame [rad], in (-pi/2, pi/2]; 0 for a circle.
    pub tilt: f64,
    /// Which way it is run through.
    pub sense: Sense,
}

impl PrimaryEllipse {
    /// The ellipse of two turning parts; `size` [kg m] tells what counts as nothing.
    pub fn of(forward: Complex64, backward: Complex64, size: f64) -> PrimaryEllipse {
        let small = NOTHING * size.max(forward.norm()).max(backward.norm());
        let clean = |part: Complex64| if part.norm() <= small { Complex64::ZERO } else { part };
        let (forward, backward) = (clean(forward), clean(backward));
        let (with, against) = (forward.norm(), backward.norm());
        let sense = match () {
            () if with + against <= small => Sense::None,
            () if (with - against).abs() <= small => Sense::Line,
            () if with > against => Sense::With,
            () => Sense::Against,
        };
        let tilt = if with > 0.0 && against > 0.0 {
            let half = 0.5 * (forward.arg() + backward.arg());
            let folded = half.rem_euclid(PI);
            // A hair below the whole turn is 0, a hair above a quarter is a quarter.
            match folded {
                t if t > PI - 1e-9 => 0.0,
                t if t > FRAC_PI_2 + 1e-9 => t - PI,
                t => t,
            }
        } else {
            0.0
        };
        let minor = if sense == Sense::Line { 0.0 } else { (with - against).abs() };
        PrimaryEllipse { forward, backward, major: with + against, minor, tilt, sense }
    }

    /// Amplitude along a direction of the engine's frame [kg m].
    pub fn along(&self, direction: f64) -> f64 {
        let back = Complex64::cis(-direction);
        (self.forward * back + (self.backward * back).conj()).norm()
    }

    /// The force over `w^2` where the throw stands at `psi` [rad].
    pub fn at(&self, psi: f64) -> Complex64 {
        let turn = Complex64::cis(psi);
        self.forward * turn + self.backward * turn.conj()
    }
}
