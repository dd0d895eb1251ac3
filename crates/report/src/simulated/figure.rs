//! Figures of a simulated run in short: curves in panels.

use crate::kit::figure::{Figure, Panel};
use crate::kit::xy_plot::{XyCurve, XyPlot};

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
