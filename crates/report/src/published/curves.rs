//! Curves of a published figure, from values that were computed for it.

use crate::kit::figure::Panel;
use crate::kit::plot::{AnglePlot, Series};
use crate::kit::xy_plot::{XyCurve, XyPlot};

/// What the curves go over.
#[derive(Debug, Clone, PartialEq)]
pub enum Abscissa {
    /// The crank angle, from 0 to this [rad]; points are evenly spaced from 0, the end excluded.
    Angle(f64),
    /// Another quantity, with its SI unit, or one that needs no prefix.
    Quantity(String, String),
}

/// One curve.
#[derive(Debug, Clone, PartialEq)]
pub struct PublishedCurve {
    /// Name in the legend.
    pub name: String,
    /// In SI.
    pub points: Vec<(f64, f64)>,
    /// How its points are drawn.
    pub points_as: PointsAs,
}

/// How the points of a curve are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PointsAs {
    /// A line through all of them.
    Line,
    /// The same with a dot at each: few values.
    MarkedLine,
    /// Dots alone.
    Dots,
}

/// Curves in one drawing: the first is the thick one.
#[derive(Debug, Clone, PartialEq)]
pub struct PublishedCurves {
    /// What the ordinate is.
    pub quantity: String,
    /// Its SI unit.
    pub unit: String,
    /// What they go over.
    pub abscissa: Abscissa,
    /// The curves.
    pub curves: Vec<PublishedCurve>,
}

impl PublishedCurves {
    /// Draws them.
    pub fn panel(&self) -> Panel {
        match &self.abscissa {
            Abscissa::Angle(period) => self.over_angle(*period),
            Abscissa::Quantity(name, unit) => self.over(name, unit),
        }
    }

    fn over_angle(&self, period: f64) -> Panel {
        let column = |curve: &PublishedCurve| curve.points.iter().map(|p| p.1).collect::<Vec<f64>>();
        let columns: Vec<Vec<f64>> = self.curves.iter().map(column).collect();
        let theta: Vec<f64> =
            self.curves.first().map_or_else(Vec::new, |curve| curve.points.iter().map(|p| p.0).collect());
        let named = self.curves.iter().zip(&columns).enumerate();
        let series = named.map(|(style, (curve, values))| Series { name: curve.name.clone(), style, values });
        let (quantity, unit) = (self.quantity.as_str(), self.unit.as_str());
        AnglePlot { quantity, unit, theta: &theta, period, series: series.collect() }.panel()
    }

    fn over(&self, abscissa: &str, abscissa_unit: &str) -> Panel {
        let drawn = |(style, curve): (usize, &PublishedCurve)| {
            let of = |dots| XyCurve { name: curve.name.clone(), style, points: curve.points.clone(), dots };
            let line = (curve.points_as != PointsAs::Dots).then(|| of(false));
            let dots = (curve.points_as != PointsAs::Line).then(|| of(true));
            line.into_iter().chain(dots)
        };
        XyPlot {
            abscissa,
            ordinate: &self.quantity,
            units: [abscissa_unit, &self.unit],
            polar: None,
            curves: self.curves.iter().enumerate().flat_map(drawn).collect(),
        }
        .panel()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curves(abscissa: Abscissa) -> PublishedCurves {
        let points = (0..4).map(|k| (f64::from(k), f64::from(k * k))).collect();
        let curve = PublishedCurve { name: "square".to_owned(), points, points_as: PointsAs::MarkedLine };
        PublishedCurves { quantity: "y".to_owned(), unit: "N".to_owned(), abscissa, curves: vec![curve] }
    }

    #[test]
    fn curves_are_drawn_over_the_angle_and_over_a_quantity() {
        let angle = curves(Abscissa::Angle(std::f64::consts::TAU)).panel();
        assert!(angle.description.contains("square; from 0 to 9.000 N"), "{}", angle.description);
        let over = curves(Abscissa::Quantity("x".to_owned(), "m".to_owned())).panel();
        assert!(over.description.contains("y over x"), "{}", over.description);
    }
}
