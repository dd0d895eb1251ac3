//! What moves a piston: its exact linkage, or a truncated series of orders.

use crate::inertia::request::{Kinematics, LoadError};
use crate::train::linkage::{Articulated, Jet, KnuckleMotion, Slider, Stroke};
use crate::train::sampling::sampled_orders;
use crate::train::series::{MotionOrders, series_orders, slider_orders};
use num_complex::Complex64;

/// Linkage of a cylinder, checked: it turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Linkage {
    /// A rod on the crankpin.
    Plain(Slider),
    /// A rod on a master's knuckle pin.
    Articulated(Articulated),
}

impl Linkage {
    /// Travel of the piston pin [m] with its derivatives by the crank angle `phi` from the (master's) axis.
    pub fn travel(&self, phi: f64) -> Jet {
        match self {
            Linkage::Plain(slider) => slider.stroke(phi).travel,
            Linkage::Articulated(articulated) => articulated.stroke(phi).travel,
        }
    }

    /// Distance [rad] of the nearest singularity of the motion from the real crank angle: how close it comes to
    /// locking. A grid much finer than this resolves the motion.
    pub fn analytic_margin(&self) -> f64 {
        let margin = |slider: &Slider| ((slider.length - slider.offset.abs()) / slider.radius).acosh();
        match self {
            Linkage::Plain(slider) => margin(slider),
            Linkage::Articulated(articulated) => {
                let own = articulated.largest_sine().recip().acosh();
                own.min(margin(&articulated.master))
            }
        }
    }
}

/// What moves a piston.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Drive {
    /// The exact motion.
    Exact(Linkage),
    /// Truncated motion, as orders of travel and rod rate; phases counted from the (master's) axis.
    Series {
        /// Its own motion.
        own: MotionOrders,
        /// Its master's linkage and truncated travel, for an articulated rod.
        master: Option<(Articulated, Vec<Complex64>)>,
    },
}

/// Motion of a piston and, on an articulated rod, of its knuckle pin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DriveMotion {
    /// Piston and rod.
    pub stroke: Stroke,
    /// Knuckle pin.
    pub knuckle: Option<KnuckleMotion>,
}

impl Drive {
    /// The motion of `linkage` in the kinematics asked for; `cylinder` counts from 1.
    pub fn of(linkage: Linkage, kinematics: Kinematics, cylinder: usize) -> Result<Drive, LoadError> {
        match (kinematics, linkage) {
            (Kinematics::Exact, _) => Ok(Drive::Exact(linkage)),
            (Kinematics::Orders(cap), Linkage::Plain(slider)) => {
                Ok(Drive::Series { own: slider_orders(&slider, cap as usize), master: None })
            }
            (Kinematics::Orders(cap), Linkage::Articulated(articulated)) => {
                let travel = slider_orders(&articulated.master, cap as usize).travel;
                let own = articulated_orders(&articulated, cap as usize);
                Ok(Drive::Series { own, master: Some((articulated, travel)) })
            }
            (Kinematics::PowerSeries { max_order, max_power }, Linkage::Plain(slider))
                if slider.offset == 0.0 =>
            {
                Ok(Drive::Series { own: series_orders(&slider, max_order, max_power), master: None })
            }
            (Kinematics::PowerSeries { .. }, Linkage::Plain(_)) => {
                Err(LoadError::SeriesNotCentred { cylinder, found: "an offset" })
            }
            (Kinematics::PowerSeries { .. }, Linkage::Articulated(_)) => {
                Err(LoadError::SeriesNotCentred { cylinder, found: "an articulated rod" })
            }
        }
    }

    /// Linkage of an articulated rod.
    pub fn articulated(&self) -> Option<&Articulated> {
        match self {
            Drive::Exact(Linkage::Articulated(linkage)) => Some(linkage),
            Drive::Series { master: Some((linkage, _)), .. } => Some(linkage),
            Drive::Exact(Linkage::Plain(_)) | Drive::Series { master: None, .. } => None,
        }
    }

    /// Motion at crank angle `phi` from the (master's) axis.
    pub fn motion(&self, phi: f64) -> DriveMotion {
        self.motion_at(Complex64::cis(phi))
    }

    /// Motion where the crank points along `crank`, of length 1, from the (master's) axis.
    // In line, so that derivatives which nobody asks for are not computed.
    #[inline(always)]
    pub fn motion_at(&self, crank: Complex64) -> DriveMotion {
        match self {
            Drive::Exact(Linkage::Plain(slider)) => {
                DriveMotion { stroke: slider.stroke_at(crank), knuckle: None }
            }
            Drive::Exact(Linkage::Articulated(articulated)) => {
                let knuckle = articulated.knuckle(crank);
                DriveMotion { stroke: articulated.stroke_with(&knuckle), knuckle: Some(knuckle) }
            }
            Drive::Series { own, master } => {
                let phi = crank.arg();
                let rate = jet(&own.swing_rate, phi);
                let knuckle =
                    master.as_ref().map(|(linkage, travel)| linkage.knuckle_with(crank, jet(travel, phi)));
                // The angle itself moves no load.
                let (tilt, swing) = (Complex64::ONE, [rate[0], rate[1], rate[2]]);
                DriveMotion { stroke: Stroke { travel: jet(&own.travel, phi), tilt, swing }, knuckle }
            }
        }
    }
}

/// Value and derivatives of `f_0 + 2 Re SUM f_n e^{i n phi}`.
fn jet(orders: &[Complex64], phi: f64) -> Jet {
    let turn = Complex64::cis(phi);
    let mut sum = [orders.first().map_or(0.0, |mean| mean.re), 0.0, 0.0, 0.0];
    let mut phase = Complex64::ONE;
    for (n, order) in orders.iter().enumerate().skip(1) {
        // Every so often the phase starts afresh, so that rounding does not pile up.
        phase = if n % 16 == 0 { Complex64::cis(n as f64 * phi) } else { phase * turn };
        let term = 2.0 * order * phase;
        let n = n as f64;
        sum[0] += term.re;
        sum[1] -= n * term.im;
        sum[2] -= n * n * term.re;
        sum[3] += n * n * n * term.im;
    }
    sum
}

/// Orders of an articulated rod's exact travel and rod rate, by quadrature.
fn articulated_orders(articulated: &Articulated, highest: usize) -> MotionOrders {
    let sampled = sampled_orders(highest, 0, |phi| {
        let stroke = articulated.stroke(phi);
        [stroke.travel[0], stroke.swing[0]]
    });
    MotionOrders {
        travel: sampled.iter().map(|c| c[0]).collect(),
        swing_rate: sampled.iter().map(|c| c[1]).collect(),
        ..MotionOrders::default()
    }
}
