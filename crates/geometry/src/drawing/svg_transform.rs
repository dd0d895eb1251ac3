//! Transforms of SVG.

use super::svg_scanner::Scanner;
use lanchester_shape::Edge;
use lanchester_shape::Point;

/// How far a transform may be from one that keeps circles, relative to its scale: files state six digits.
const ROUND: f64 = 1e-5;

/// `x' = a x + c y + e, y' = b x + d y + f`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Transform {
    pub a: f64,
    pub b: f64,
    pub c: f64,
    pub d: f64,
    pub e: f64,
    pub f: f64,
}

impl Transform {
    pub const IDENTITY: Transform = Transform { a: 1.0, b: 0.0, c: 0.0, d: 1.0, e: 0.0, f: 0.0 };

    pub fn scale(x: f64, y: f64) -> Transform {
        Transform { a: x, d: y, ..Transform::IDENTITY }
    }

    fn translate(e: f64, f: f64) -> Transform {
        Transform { e, f, ..Transform::IDENTITY }
    }

    fn rotate(degrees: f64) -> Transform {
        let (b, a) = degrees.to_radians().sin_cos();
        Transform { a, b, c: -b, d: a, ..Transform::IDENTITY }
    }

    /// This one after `first`.
    pub fn after(self, first: Transform) -> Transform {
        let Transform { a, b, c, d, e, f } = self;
        Transform {
            a: a * first.a + c * first.b,
            b: b * first.a + d * first.b,
            c: a * first.c + c * first.d,
            d: b * first.c + d * first.d,
            e: a * first.e + c * first.f + e,
            f: b * first.e + d * first.f + f,
        }
    }

    fn point(self, at: Point) -> Point {
        Point::new(self.a * at.x + self.c * at.y + self.e, self.b * at.x + self.d * at.y + self.f)
    }

    fn determinant(self) -> f64 {
        self.a * self.d - self.b * self.c
    }

    /// Its mean scale.
    pub fn size(self) -> f64 {
        self.determinant().abs().sqrt()
    }

    /// Whether circles stay circles.
    fn keeps_circles(self) -> bool {
        let sign = self.determinant().signum();
        let off = (self.a - sign * self.d).hypot(self.b + sign * self.c);
        off <= ROUND * self.size()
    }

    /// The edge in the outer frame; none for an arc that would not stay one.
    pub fn edge(self, edge: &Edge) -> Option<Edge> {
        if edge.bulge != 0.0 && !self.keeps_circles() {
            return None;
        }
        let bulge = if self.determinant() < 0.0 { -edge.bulge } else { edge.bulge };
        Some(Edge { from: self.point(edge.from), to: self.point(edge.to), bulge })
    }

    /// From the value of the attribute `transform`; what could not be read where it is wrong.
    pub fn parse(text: &str) -> Result<Transform, String> {
        let mut scanner = Scanner::new(text);
        let mut whole = Transform::IDENTITY;
        scanner.separator();
        while !scanner.is_done() {
            let start = scanner;
            let name = scanner.word();
            scanner.blanks();
            let opened = scanner.take(b'(');
            scanner.blanks();
            let numbers: Vec<f64> = std::iter::from_fn(|| scanner.coordinate()).collect();
            let next = match (name, &numbers[..]) {
                ("matrix", &[a, b, c, d, e, f]) => Some(Transform { a, b, c, d, e, f }),
                ("translate", &[x]) => Some(Transform::translate(x, 0.0)),
                ("translate", &[x, y]) => Some(Transform::translate(x, y)),
                ("scale", &[both]) => Some(Transform::scale(both, both)),
                ("scale", &[x, y]) => Some(Transform::scale(x, y)),
                ("rotate", &[angle]) => Some(Transform::rotate(angle)),
                ("rotate", &[angle, x, y]) => Some(
                    Transform::translate(x, y)
                        .after(Transform::rotate(angle))
                        .after(Transform::translate(-x, -y)),
                ),
                ("skewX", &[angle]) => Some(Transform { c: angle.to_radians().tan(), ..Transform::IDENTITY }),
                ("skewY", &[angle]) => Some(Transform { b: angle.to_radians().tan(), ..Transform::IDENTITY }),
                _ => None,
            };
            match next {
                Some(next) if opened && scanner.take(b')') => whole = whole.after(next),
                _ => return Err(start.here()),
            }
            scanner.separator();
        }
        Ok(whole)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_of_a_list_is_done_first() {
        let of = |text| Transform::parse(text).unwrap().point(Point::new(1.0, 2.0));
        assert_eq!(of("translate(10) scale(2,3)"), Point::new(12.0, 6.0));
        assert_eq!(of("scale(2 3),translate(10,0)"), Point::new(22.0, 6.0));
        assert!((of("rotate(90)") - Point::new(-2.0, 1.0)).norm() < 1e-15);
        assert!((of("rotate(90 1 2)") - Point::new(1.0, 2.0)).norm() < 1e-15);
        assert!((of("skewX(45)") - Point::new(3.0, 2.0)).norm() < 1e-15);
        for wrong in ["scale()", "scale(1", "turn(3)", "rotate(1,2)", "matrix(1 0 0 1 0)", "3"] {
            assert!(Transform::parse(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn arcs_need_a_transform_that_keeps_circles() {
        let arc = Edge { from: Point::ORIGIN, to: Point::new(1.0, 0.0), bulge: 0.5 };
        let of = |text| Transform::parse(text).unwrap().edge(&arc);
        assert_eq!(of("scale(1,-1)").unwrap().bulge, -0.5);
        assert_eq!(of("rotate(33) scale(3)").unwrap().bulge, 0.5);
        assert!(
            of("scale(1,2)").is_none()
                && of("skewX(1)").is_none()
                && of("scale(0)").is_some_and(|e| e.from == e.to)
        );
    }
}
