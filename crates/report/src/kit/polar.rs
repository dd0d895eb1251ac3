//! Polar diagrams of bearing loads: gas, inertia and both in one drawing.

use crate::kit::figure::Panel;
use crate::kit::xy_plot::{XyCurve, XyPlot};
use crate::torque::figures::closed;
use lanchester_mechanism::BearingLoads;
use num_complex::Complex64;

/// The load that `of` takes from each of `parts`, its real part upwards; `axes` name the real and the imaginary part. Both axes reach at
/// least to `reach` [N].
pub(crate) fn polar_panel(
    parts: &[BearingLoads],
    axes: [&str; 2],
    reach: f64,
    of: impl Fn(&BearingLoads) -> Vec<Complex64>,
) -> Panel {
    let curves = parts.iter().enumerate().map(|(style, loads)| XyCurve {
        name: loads.part.name().to_owned(),
        style,
        points: closed(of(loads).iter().map(|force| (force.im, force.re))),
        dots: false,
    });
    let plot = XyPlot {
        abscissa: axes[1],
        ordinate: axes[0],
        units: ["N", "N"],
        polar: Some(reach),
        curves: curves.collect(),
    };
    plot.panel()
}
