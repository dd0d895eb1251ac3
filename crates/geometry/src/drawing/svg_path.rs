//! The path data of SVG: lines and arcs of circles.

use super::svg_scanner::Scanner;
use lanchester_shape::Edge;
use lanchester_shape::Point;

/// A part of a path that hangs together.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Subpath {
    /// Its edges, in units of the path, whose y points down or up.
    pub edges: Vec<Edge>,
    /// Whether it was closed by `Z`.
    pub closed: bool,
    /// Byte of the text where it begins.
    pub at: usize,
}

/// What is wrong with a path, and at which byte.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PathError {
    pub at: usize,
    pub kind: PathErrorKind,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum PathErrorKind {
    /// Something else was needed.
    Syntax { needed: &'static str, got: String },
    /// A Bezier curve.
    Bezier,
    /// An arc of an ellipse.
    Ellipse,
}

/// The parts of a path. Radii that differ by no more than `slack` are equal.
pub(super) fn subpaths(text: &str, slack: f64) -> Result<Vec<Subpath>, PathError> {
    let mut path = Path {
        scanner: Scanner::new(text),
        slack,
        done: Vec::new(),
        edges: Vec::new(),
        here: Point::ORIGIN,
        start: Point::ORIGIN,
        begun: 0,
    };
    path.scanner.blanks();
    let mut last = None;
    while !path.scanner.is_done() {
        let at = path.scanner.at();
        let command = match (path.scanner.letter(), last) {
            (Some(letter), _) => letter,
            // Pairs after a move are lines.
            (None, Some(b'M')) => b'L',
            (None, Some(b'm')) => b'l',
            (None, Some(letter)) if !matches!(letter, b'Z' | b'z') => letter,
            _ => return Err(path.wrong("a command")),
        };
        if last.is_none() && !matches!(command, b'M' | b'm') {
            path.scanner = Scanner::new(text);
            return Err(path.wrong("a path that begins with M"));
        }
        path.scanner.blanks();
        path.command(command, at)?;
        last = Some(command);
    }
    path.end(false);
    Ok(path.done)
}

struct Path<'a> {
    scanner: Scanner<'a>,
    slack: f64,
    done: Vec<Subpath>,
    edges: Vec<Edge>,
    here: Point,
    start: Point,
    begun: usize,
}

impl Path<'_> {
    fn wrong(&self, needed: &'static str) -> PathError {
        let kind = PathErrorKind::Syntax { needed, got: self.scanner.here() };
        PathError { at: self.scanner.at(), kind }
    }

    fn number(&mut self) -> Result<f64, PathError> {
        self.scanner.coordinate().ok_or_else(|| self.wrong("a number"))
    }

    fn flag(&mut self) -> Result<bool, PathError> {
        self.scanner.flag().ok_or_else(|| self.wrong("a flag, 0 or 1"))
    }

    fn point(&mut self, origin: Point) -> Result<Point, PathError> {
        Ok(origin + Point::new(self.number()?, self.number()?))
    }

    fn end(&mut self, closed: bool) {
        let edges = std::mem::take(&mut self.edges);
        if !edges.is_empty() {
            self.done.push(Subpath { edges, closed, at: self.begun });
        }
    }

    fn edge(&mut self, to: Point, bulge: f64, at: usize) {
        if self.edges.is_empty() {
            self.begun = at;
        }
        self.edges.push(Edge { from: self.here, to, bulge });
        self.here = to;
    }

    fn command(&mut self, command: u8, at: usize) -> Result<(), PathError> {
        let origin = if command.is_ascii_lowercase() { self.here } else { Point::ORIGIN };
        match command.to_ascii_uppercase() {
            b'M' => {
                self.end(false);
                self.here = self.point(origin)?;
                self.start = self.here;
            }
            b'L' => {
                let to = self.point(origin)?;
                self.edge(to, 0.0, at);
            }
            b'H' => {
                let to = Point::new(origin.x + self.number()?, self.here.y);
                self.edge(to, 0.0, at);
            }
            b'V' => {
                let to = Point::new(self.here.x, origin.y + self.number()?);
                self.edge(to, 0.0, at);
            }
            b'A' => {
                let radii = [self.number()?.abs(), self.number()?.abs()];
                self.number()?;
                let (large, increasing) = (self.flag()?, self.flag()?);
                let to = self.point(origin)?;
                let bulge = self.bulge(radii, to, large);
                let bulge = bulge.ok_or(PathError { at, kind: PathErrorKind::Ellipse })?;
                self.edge(to, if increasing { bulge } else { -bulge }, at);
            }
            b'Z' => {
                if self.here != self.start {
                    self.edge(self.start, 0.0, at);
                }
                self.end(true);
                self.scanner.separator();
            }
            b'C' | b'S' | b'Q' | b'T' => return Err(PathError { at, kind: PathErrorKind::Bezier }),
            _ => {
                let got = char::from(command).to_string();
                let needed = "one of M L H V A Z";
                return Err(PathError { at, kind: PathErrorKind::Syntax { needed, got } });
            }
        }
        Ok(())
    }

    /// Bulge of the arc from here, not negative: a radius too small for the chord is that of a half circle, one of zero a line's.
    fn bulge(&self, [rx, ry]: [f64; 2], to: Point, large: bool) -> Option<f64> {
        if rx == 0.0 || ry == 0.0 {
            return Some(0.0);
        }
        if (rx - ry).abs() > self.slack {
            return None;
        }
        let radius = 0.5 * (rx + ry);
        let sine = ((to - self.here).norm() / 2.0 / radius).min(1.0);
        let bulge = sine / (1.0 + ((1.0 - sine) * (1.0 + sine)).sqrt());
        Some(if large && bulge > 0.0 { 1.0 / bulge } else { bulge })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(text: &str) -> Subpath {
        let mut all = subpaths(text, 1e-9).unwrap();
        assert_eq!(all.len(), 1, "{text}");
        all.remove(0)
    }

    #[test]
    fn absolute_and_relative_commands_give_the_same_edges() {
        let absolute = one("M1,1 L5 1 H6 V4 A 2 2 0 0 1 4 6 L 1 6 Z");
        let relative = one("m1 1 4 0h1v3a2,2 0 01-2,2l-3 0z");
        assert_eq!(absolute.edges, relative.edges);
        assert!(absolute.closed && absolute.edges.len() == 6);
        // A quarter turn, the sense of growing angles.
        assert!((absolute.edges[3].bulge - (std::f64::consts::PI / 8.0).tan()).abs() < 1e-15);
    }

    #[test]
    fn arcs_of_half_a_turn_and_more() {
        assert_eq!(one("M0 0A1 1 0 0 0 2 0").edges[0].bulge, -1.0);
        // Too small a radius grows to half the chord.
        assert_eq!(one("M0 0A.1 .1 0 0 1 2 0").edges[0].bulge, 1.0);
        let major = one("M0 0A1 1 0 1 1 1 1").edges[0];
        assert!((major.bulge - (3.0 * std::f64::consts::PI / 8.0).tan()).abs() < 1e-14);
        assert_eq!(one("M0 0A0 1 0 1 1 1 1").edges[0].bulge, 0.0);
    }

    #[test]
    fn a_path_goes_on_where_it_was_closed() {
        let parts = subpaths("M0 0 L1 0 L1 1 Z L 2 2", 0.0).unwrap();
        assert_eq!(parts.len(), 2);
        assert_eq!(parts[1].edges, [Edge::line(Point::ORIGIN, Point::new(2.0, 2.0))]);
        assert!(!parts[1].closed);
    }

    #[test]
    fn what_is_wrong_is_said_with_its_place() {
        let error = |text| subpaths(text, 1e-9).unwrap_err();
        assert_eq!(error("M0 0 C1 1 2 2 3 3"), PathError { at: 5, kind: PathErrorKind::Bezier });
        assert_eq!(error("M0 0 A1 2 0 0 0 3 3"), PathError { at: 5, kind: PathErrorKind::Ellipse });
        for (text, at) in
            [("L0 0", 0), ("M0", 2), ("M0 0 1", 6), ("M0 0 A1 1 0 2 0 3 3", 12), ("M0 0z3", 5), ("M0 0 X", 5)]
        {
            let PathError { at: found, kind: PathErrorKind::Syntax { .. } } = error(text) else {
                panic!("{text}")
            };
            assert_eq!(found, at, "{text}");
        }
        assert_eq!(subpaths("", 0.0), Ok(vec![]));
    }
}
