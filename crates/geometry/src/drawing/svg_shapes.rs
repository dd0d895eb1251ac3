//! Lines and arcs of the shapes of SVG, in units of the shape.

use super::strand::Strand;
use super::svg_path::{PathError, PathErrorKind, Subpath, subpaths};
use super::svg_scanner::Scanner;
use super::{DrawingError, Place};
use lanchester_shape::Edge;
use lanchester_shape::Point;
use roxmltree::Node;

/// The lines of a text, to tell in which one a byte is.
pub(super) struct Lines(Vec<usize>);

impl Lines {
    pub fn of(text: &str) -> Lines {
        Lines(text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n').map(|(at, _)| at).collect())
    }

    /// Counted from 1.
    pub fn at(&self, byte: usize) -> usize {
        self.0.partition_point(|end| *end < byte) + 1
    }
}

/// An element of a drawing.
#[derive(Clone, Copy)]
pub(super) struct Element<'a> {
    pub node: Node<'a, 'a>,
    pub lines: &'a Lines,
}

impl<'a> Element<'a> {
    pub fn name(&self) -> &'a str {
        self.node.tag_name().name()
    }

    pub fn place(&self) -> Place {
        Place::new(self.name(), self.lines.at(self.node.range().start))
    }

    pub fn unsupported(&self, why: &'static str, hint: &'static str) -> DrawingError {
        DrawingError::Unsupported { entity: self.place(), why, hint }
    }

    /// Line of a byte of the value of an attribute.
    fn line_in(&self, attribute: &str, at: usize) -> usize {
        let start =
            self.node.attribute_node(attribute).map_or(self.node.range().start, |a| a.range_value().start);
        self.lines.at(start + at)
    }

    pub fn wrong(&self, attribute: &str, at: usize, needed: &'static str, got: String) -> DrawingError {
        DrawingError::Syntax { line: self.line_in(attribute, at), needed, got: Place::new(&got, 0).entity }
    }

    /// A length without unit, which may be absent.
    fn length(&self, attribute: &str) -> Result<Option<f64>, DrawingError> {
        let Some(text) = self.node.attribute(attribute) else { return Ok(None) };
        let text = text.trim();
        let mut scanner = Scanner::new(text.strip_suffix("px").unwrap_or(text));
        let number = scanner.number().filter(|_| scanner.is_done());
        number
            .map(Some)
            .ok_or_else(|| self.wrong(attribute, 0, "a finite number without a unit", text.to_string()))
    }

    fn length_or_zero(&self, attribute: &str) -> Result<f64, DrawingError> {
        Ok(self.length(attribute)?.unwrap_or_default())
    }

    /// A length that must be positive.
    fn size(&self, attribute: &str) -> Result<f64, DrawingError> {
        let size = self.length_or_zero(attribute)?;
        if size > 0.0 { Ok(size) } else { Err(self.unsupported("has no size", "delete it or give its size")) }
    }

    /// All numbers of an attribute.
    pub fn numbers(&self, attribute: &str) -> Result<Vec<f64>, DrawingError> {
        let mut scanner = Scanner::new(self.node.attribute(attribute).unwrap_or_default());
        scanner.blanks();
        let numbers = std::iter::from_fn(|| scanner.coordinate()).collect();
        if scanner.is_done() {
            return Ok(numbers);
        }
        Err(self.wrong(attribute, scanner.at(), "a number", scanner.here()))
    }

    /// Its edges, each with the place that they come from; none where it is no shape. Radii that differ by no more than `slack` are equal.
    pub fn strands(&self, slack: f64) -> Result<Option<Vec<(Subpath, Place)>>, DrawingError> {
        let (edges, closed) = match self.name() {
            "path" => return self.path(slack).map(Some),
            "circle" => {
                let centre = Point::new(self.length_or_zero("cx")?, self.length_or_zero("cy")?);
                (Strand::circle(centre, self.size("r")?), true)
            }
            "ellipse" => {
                let centre = Point::new(self.length_or_zero("cx")?, self.length_or_zero("cy")?);
                let (rx, ry) = (self.size("rx")?, self.size("ry")?);
                if (rx - ry).abs() > slack {
                    return Err(self.ellipse());
                }
                (Strand::circle(centre, 0.5 * (rx + ry)), true)
            }
            "rect" => (self.rectangle(slack)?, true),
            "polygon" => (self.corners()?, true),
            "polyline" => (self.corners()?, false),
            "line" => {
                let from = Point::new(self.length_or_zero("x1")?, self.length_or_zero("y1")?);
                let to = Point::new(self.length_or_zero("x2")?, self.length_or_zero("y2")?);
                (vec![Edge::line(from, to)], false)
            }
            _ => return Ok(None),
        };
        Ok(Some(vec![(Subpath { edges, closed, at: 0 }, self.place())]))
    }

    fn ellipse(&self) -> DrawingError {
        self.unsupported("is an ellipse", "replace the ellipse by arcs of circles, or export arcs")
    }

    fn path(&self, slack: f64) -> Result<Vec<(Subpath, Place)>, DrawingError> {
        let text = self.node.attribute("d").unwrap_or_default();
        let place = |at| Place::new("path", self.line_in("d", at));
        let unsupported = |at, why, hint| DrawingError::Unsupported { entity: place(at), why, hint };
        let parts = subpaths(text, slack).map_err(|PathError { at, kind }| match kind {
            PathErrorKind::Syntax { needed, got } => self.wrong("d", at, needed, got),
            PathErrorKind::Bezier => {
                unsupported(at, "has a Bezier curve", "export lines and arcs, from the CAD program itself")
            }
            PathErrorKind::Ellipse => {
                unsupported(at, "has an arc of an ellipse", "replace it by arcs of circles")
            }
        })?;
        Ok(parts
            .into_iter()
            .map(|part| {
                let place = place(part.at);
                (part, place)
            })
            .collect())
    }

    fn corners(&self) -> Result<Vec<Edge>, DrawingError> {
        let numbers = self.numbers("points")?;
        if numbers.len() % 2 != 0 {
            return Err(self.wrong("points", 0, "an even number of coordinates", numbers.len().to_string()));
        }
        let corners: Vec<(Point, f64)> =
            numbers.chunks_exact(2).map(|pair| (Point::new(pair[0], pair[1]), 0.0)).collect();
        Ok(Strand::of_corners(&corners, self.name() == "polygon"))
    }

    /// From its corner with the least coordinates on, in the sense from x to y.
    fn rectangle(&self, slack: f64) -> Result<Vec<Edge>, DrawingError> {
        let (x, y) = (self.length_or_zero("x")?, self.length_or_zero("y")?);
        let (width, height) = (self.size("width")?, self.size("height")?);
        let radii = [self.length("rx")?, self.length("ry")?];
        let rx = radii[0].or(radii[1]).unwrap_or_default().clamp(0.0, width / 2.0);
        let ry = radii[1].or(radii[0]).unwrap_or_default().clamp(0.0, height / 2.0);
        let (far_x, far_y) = (x + width, y + height);
        let at = Point::new;
        let line = |from, to| (from, to, 0.0);
        if rx == 0.0 || ry == 0.0 {
            let corners = [at(x, y), at(far_x, y), at(far_x, far_y), at(x, far_y)];
            return Ok(Strand::of_corners(&corners.map(|corner| (corner, 0.0)), true));
        }
        if (rx - ry).abs() > slack {
            return Err(self.ellipse());
        }
        let r = 0.5 * (rx + ry);
        let quarter = (std::f64::consts::PI / 8.0).tan();
        // Between the corners; none where the radius is half the side.
        let across =
            |from: f64, to: f64, half: f64| if r < half { [from, to] } else { [0.5 * (from + to); 2] };
        let [left, right] = across(x + r, far_x - r, width / 2.0);
        let [low, high] = across(y + r, far_y - r, height / 2.0);
        let sides = [
            line(at(left, y), at(right, y)),
            (at(right, y), at(far_x, low), quarter),
            line(at(far_x, low), at(far_x, high)),
            (at(far_x, high), at(right, far_y), quarter),
            line(at(right, far_y), at(left, far_y)),
            (at(left, far_y), at(x, high), quarter),
            line(at(x, high), at(x, low)),
            (at(x, low), at(left, y), quarter),
        ];
        Ok(sides.map(|(from, to, bulge)| Edge { from, to, bulge }).to_vec())
    }
}
