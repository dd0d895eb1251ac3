//! The sheet on which a part is drawn: its view across the axis, with room for dimensions, and beside it the view along it.

use crate::kit::svg::{Path, Svg};
use lanchester_geometry::{Contour, Point};

/// Width of the view across [px].
pub(crate) const WIDTH: f64 = 560.0;
/// Room for dimensions on each side [px].
const SIDE: f64 = 120.0;
const ABOVE: f64 = 62.0;
const BELOW: f64 = 64.0;
/// Largest extent of the outline on the drawing [px].
const LARGEST: f64 = 330.0;
/// Room for the view along the axis, beside it [px].
pub(crate) const SECTION: f64 = 190.0;

/// Lower case, digits and hyphens.
pub(crate) fn identifier(name: &str) -> String {
    let mapped: String =
        name.to_lowercase().chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    mapped.split('-').filter(|word| !word.is_empty()).collect::<Vec<_>>().join("-")
}

/// Places on the sheet: `x` of the part points up, `y` to the right.
pub(crate) struct Sheet {
    pub scale: f64,
    pub centre: (f64, f64),
    /// Corners of the box around what is drawn [m].
    pub low: Point,
    pub high: Point,
    /// Top of the circle that the part sweeps [m].
    pub swept: f64,
    pub height: f64,
}

impl Sheet {
    /// For what lies within a box and sweeps a circle [m].
    pub fn new([low, high]: [Point; 2], swept: f64) -> Sheet {
        let scale = (LARGEST / (swept - low.x)).min((WIDTH - 2.0 * SIDE) / (high.y - low.y));
        let height = (swept - low.x) * scale + ABOVE + BELOW;
        let centre = (WIDTH / 2.0 - (low.y + high.y) / 2.0 * scale, ABOVE + swept * scale);
        Sheet { scale, centre, low, high, swept, height }
    }

    pub fn at(&self, point: Point) -> (f64, f64) {
        (self.centre.0 + point.y * self.scale, self.centre.1 - point.x * self.scale)
    }

    pub fn x(&self, x: f64) -> f64 {
        self.centre.1 - x * self.scale
    }

    pub fn path(&self, contour: &Contour) -> Path {
        contour
            .edges()
            .iter()
            .fold(Path::new(), |path, edge| {
                let path = if edge.from == contour.edges()[0].from {
                    path.move_to(self.at(edge.from))
                } else {
                    path
                };
                if edge.bulge == 0.0 {
                    path.line_to(self.at(edge.to))
                } else {
                    // Anticlockwise from x to y is clockwise on the sheet, where x points up and y to the right.
                    path.arc_to(
                        edge.radius() * self.scale,
                        edge.bulge.abs() > 1.0,
                        edge.bulge > 0.0,
                        self.at(edge.to),
                    )
                }
            })
            .close()
    }

    /// The axis and the directions of the part, as axis lines.
    pub fn axes(&self, svg: &mut Svg) {
        let axis = self.centre;
        let overhang = 14.0;
        svg.line(
            "axis-line",
            (axis.0, self.x(self.swept) - overhang),
            (axis.0, self.x(self.low.x) + overhang),
        );
        let [left, right] = [self.low.y, self.high.y].map(|y| self.at(Point::new(0.0, y)).0);
        svg.line("axis-line", (left - overhang, axis.1), (right + overhang, axis.1));
        svg.circle("dot", axis, 2.6);
    }

    /// The centre of mass: a circle with two filled quarters.
    pub fn centre_of_mass(&self, svg: &mut Svg, centre: Point) {
        let at = self.at(centre);
        svg.circle("pin", at, 5.5);
        for sign in [-1.0, 1.0] {
            let path = Path::new()
                .move_to(at)
                .line_to((at.0 + sign * 5.5, at.1))
                .arc_to(5.5, false, true, (at.0, at.1 + sign * 5.5))
                .close();
            svg.path("dot", &path);
        }
    }
}
