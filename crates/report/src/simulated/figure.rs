//! Figures of a simulated run in short: curves in panels.

use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::xy_plot::{Extras, XyCurve, XyPlot};

pub(crate) fn figure(id: &str, title: &str, caption: &str, panels: Vec<Panel>) -> Figure {
    let columns = panels.len().min(2);
    Figure { id: id.into(), title: title.into(), caption: caption.into(), panels, columns }
}

pub(crate) fn curve(name: &str, style: usize, points: Vec<(f64, f64)>) -> XyCurve {
    XyCurve { name: name.into(), style, points, dots: false }
}

pub(crate) fn panel(
    [abscissa, ordinate]: [&str; 2],
    units: [&str; 2],
    polar: Option<f64>,
    curves: Vec<XyCurve>,
) -> Panel {
    XyPlot { abscissa, ordinate, units, polar, curves }.panel()
}

/// A panel whose axes follow the values, with the numbers of events at their abscissae.
pub(crate) fn fitted(
    [abscissa, ordinate]: [&str; 2],
    units: [&str; 2],
    events: &[(f64, usize)],
    curves: Vec<XyCurve>,
) -> Panel {
    let extras = Extras { fits: true, events, ..Extras::default() };
    XyPlot { abscissa, ordinate, units, polar: None, curves }.panel_with(&extras)
}

/// Paths with equal axes, and how many times as large as they are they are drawn, in words.
pub(crate) fn orbit([abscissa, ordinate]: [&str; 2], curves: Vec<XyCurve>) -> (Panel, String) {
    let plot = XyPlot { abscissa, ordinate, units: ["m", "m"], polar: Some(0.0), curves };
    let times = plot.magnification();
    let rounded = 10f64.powf(times.log10().floor() - 1.0);
    let words = number::fixed((times / rounded).round() * rounded, if times < 10.0 { 1 } else { 0 });
    (plot.panel(), format!("drawn about {words} times as large as it is"))
}
