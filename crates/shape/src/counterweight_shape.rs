//! The tool paper's family of counterweights: rectangle, trapezoid and circular segment around the web's disc.
//!
//! ```text
//!                 ____
//!              .-'    '-.      circular segment, radius R, included angle alpha
//!             /__________\     y_s = h + H        half width w = R sin(alpha/2) = r + l_c
//!              \        /      trapezoid, height H
//!               |      |       h                  half width r
//!               |  ..  |       rectangle, height h
//!               | (  ) |       crank axis in the middle of the web's disc, radius r
//!                '-..-'
//! ```
//! Source: [ApplSci2021] section 4, figure 5, eqs. 24 to 30; corrected in the book, eqs. (22.20) to (22.26). The paper's `h_R`
//! is `h`, its `r_cw` is `r`, `R_cw` is `R`, and its `delta` is the shoulder angle, `tan delta = H/l_c`. Its `y`
//! is our `x`.

use crate::area_moments::AreaMoments;
use crate::circular_segment::{UnitSegment, excess};
use crate::contour::Contour;
use crate::edge::Edge;
use crate::error::GeometryError;
use crate::point::Point;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A counterweight of the family around the disc of its web.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct CounterweightShape {
    /// Radius `r` of the web's disc, and half width of the rectangle [m].
    pub web_radius: f64,
    /// Height `h` of the rectangle, from the crank axis [m].
    pub rectangle_height: f64,
    /// Height `H` of the trapezoid [m].
    pub shoulder_height: f64,
    /// Radius `R` of the arc [m].
    pub arc_radius: f64,
    /// Included angle `alpha` of the arc [rad], less than a full turn.
    pub arc_angle: f64,
}

impl CounterweightShape {
    /// The same shape, if its dimensions are possible.
    ///
    /// # Errors
    /// Where a length is negative or not finite, a radius is not positive, or the angle is not within a full turn.
    pub fn checked(self) -> Result<CounterweightShape, GeometryError> {
        let number = |quantity, needed, got| {
            Err(GeometryError::Number {
                quantity,
                needed,
                got,
                hint: "see the sketch of the shape's dimensions",
            })
        };
        for (quantity, got) in [("web radius r [m]", self.web_radius), ("arc radius R [m]", self.arc_radius)]
        {
            if !(got > 0.0 && got.is_finite()) {
                return number(quantity, "positive", got);
            }
        }
        for (quantity, got) in [
            ("rectangle height h [m]", self.rectangle_height),
            ("shoulder height H [m]", self.shoulder_height),
        ] {
            if !(got >= 0.0 && got.is_finite()) {
                return number(quantity, "zero or more", got);
            }
        }
        if !(self.arc_angle > 0.0 && self.arc_angle < TAU) {
            return number("arc angle alpha [rad]", "more than 0 and less than a full turn", self.arc_angle);
        }
        Ok(self)
    }

    /// Half width of the arc's chord, `w = R sin(alpha/2)` [m].
    pub fn half_width(&self) -> f64 {
        self.arc_radius * (self.arc_angle / 2.0).sin()
    }

    /// What each shoulder stands out, `l_c = w - r` [m]; negative where the trapezoid tapers inwards.
    pub fn shoulder(&self) -> f64 {
        self.half_width() - self.web_radius
    }

    /// Angle `delta` of the flank against the chord [rad]: 0 is a flat step outwards, a quarter turn a straight side, more
    /// an inward taper.
    pub fn shoulder_angle(&self) -> f64 {
        self.shoulder_height.atan2(self.shoulder())
    }

    /// Distance of the arc's chord from the crank axis, `y_s = h + H` [m].
    pub fn chord_distance(&self) -> f64 {
        self.rectangle_height + self.shoulder_height
    }

    /// Distance of the arc's centre from the crank axis, `y_c = y_s - R cos(alpha/2)`, negative on the crankpin's side [m].
    pub fn centre_distance(&self) -> f64 {
        self.chord_distance() - self.arc_radius * (self.arc_angle / 2.0).cos()
    }

    /// Distance of the middle of the arc from the crank axis [m].
    pub fn crown(&self) -> f64 {
        self.chord_distance() + 2.0 * self.arc_radius * (self.arc_angle / 4.0).sin().powi(2)
    }

    /// Farthest point of web and counterweight from the crank axis [m].
    pub fn swept_radius(&self) -> f64 {
        self.outline().farthest(Point::ORIGIN).0
    }

    /// Integrals over the counterweight alone, the outline without the web's disc, about the crank axis.
    ///
    /// The disc is balanced: the first moment is that of the whole web.
    pub fn moments(&self) -> AreaMoments {
        self.outline().moments() - AreaMoments::disc(Point::ORIGIN, self.web_radius)
    }

    /// The same in closed form, where it holds: shoulders that do not taper inwards and a crown outside the web's disc.
    ///
    /// # Source
    /// [ApplSci2021] eqs. 24 to 30, corrected (book, eqs. 22.21 to 22.24).
    pub fn closed_form(&self) -> Option<AreaMoments> {
        let (r, h, big_h) = (self.web_radius, self.rectangle_height, self.shoulder_height);
        let (w, l, y_s) = (self.half_width(), self.shoulder(), self.chord_distance());
        if l < 0.0 || self.crown() < r {
            return None;
        }
        let rectangle = AreaMoments {
            area: 2.0 * r * h,
            first: Point::new(r * h * h, 0.0),
            xx: 2.0 / 3.0 * r * h.powi(3),
            yy: 2.0 / 3.0 * r.powi(3) * h,
            xy: 0.0,
        };
        let trapezoid = AreaMoments {
            area: (r + w) * big_h,
            first: Point::new(big_h * (h * (r + w) + big_h * (r + 2.0 * w) / 3.0), 0.0),
            xx: 2.0 * r * big_h * (h * h + h * big_h + big_h * big_h / 3.0)
                + 2.0 * l * big_h * (h * h / 2.0 + 2.0 / 3.0 * h * big_h + big_h * big_h / 4.0),
            yy: big_h / 6.0 * (w.powi(3) + w * w * r + w * r * r + r.powi(3)),
            xy: 0.0,
        };
        let half_disc = AreaMoments {
            area: PI / 2.0 * r * r,
            first: Point::new(2.0 / 3.0 * r.powi(3), 0.0),
            xx: PI / 8.0 * r.powi(4),
            yy: PI / 8.0 * r.powi(4),
            xy: 0.0,
        };
        Some(rectangle + trapezoid + self.segment().moved(Point::new(y_s, 0.0)) - half_disc)
    }

    /// The circular segment from the middle of its chord.
    fn segment(&self) -> AreaMoments {
        let a = self.arc_angle / 2.0;
        let (w, radius) = (self.half_width(), self.arc_radius);
        if a <= FRAC_PI_2 {
            let unit = UnitSegment::of(a);
            return AreaMoments {
                area: unit.area * w * w,
                first: Point::new(unit.n * w.powi(3), 0.0),
                xx: unit.nn * w.powi(4),
                yy: unit.tt * w.powi(4),
                xy: 0.0,
            };
        }
        // More than half a disc: nothing cancels about the centre.
        let (s, c) = a.sin_cos();
        let fourth = radius.powi(4);
        AreaMoments {
            area: radius * radius * excess(a),
            first: Point::new(2.0 / 3.0 * w.powi(3), 0.0),
            xx: fourth * ((a + s * c) / 4.0 - s * c.powi(3) / 2.0),
            yy: fourth * ((a - s * c) / 4.0 - s.powi(3) * c / 6.0),
            xy: 0.0,
        }
        .moved(Point::new(-radius * c, 0.0))
    }

    /// Outline of the web with the counterweight: of the union of rectangle, trapezoid, segment and disc.
    ///
    /// At each distance `x` from the crank axis the union is as wide as the wider of the profile and the disc, so that it is
    /// found by cutting the three edges of the profile with the disc's circle, one after the other.
    pub fn outline(&self) -> Contour {
        let r = self.web_radius;
        let (h, w, y_s) = (self.rectangle_height, self.half_width(), self.chord_distance());
        let mut upper = Profile { edges: Vec::new(), end: Point::new(0.0, r), within_disc: false };
        upper.line(Point::new(h, r));
        // Flank: distance^2 - r^2 at the part s of its length is h^2 + 2 b s + d^2 s^2.
        let flank = Point::new(self.shoulder_height, self.shoulder());
        let b = h * flank.x + r * flank.y;
        let square = flank.dot(flank);
        let under_root = b * b - h * h * square;
        if b < 0.0 && under_root > 0.0 {
            let root = under_root.sqrt() - b;
            let at = |s: f64| Point::new(h, r) + flank * s;
            if h * h < root {
                upper.line(at(h * h / root));
                upper.within_disc = true;
                if root < square {
                    upper.disc(at(root / square));
                    upper.within_disc = false;
                }
            }
        }
        if !upper.within_disc {
            upper.line(Point::new(y_s, w));
        }
        // Arc: along it the distance from the axis has no extreme but at the crown.
        let (centre, radius, crown) = (self.centre_distance(), self.arc_radius, self.crown());
        let closing = match (upper.within_disc, crown > r) {
            (false, true) => self.arc_angle / 4.0,
            (true, false) => upper.end.y.atan2(upper.end.x) / 2.0,
            (within, _) => {
                let x = (r * r - radius * radius + centre * centre) / (2.0 * centre);
                let meeting = Point::new(x, ((r - x) * (r + x)).max(0.0).sqrt());
                let (on_arc, on_disc) = (meeting.y.atan2(meeting.x - centre), meeting.y.atan2(meeting.x));
                if within {
                    upper.disc(meeting);
                    on_arc / 2.0
                } else {
                    let turn = self.arc_angle / 2.0 - on_arc;
                    upper.edge(meeting, -(turn / 4.0).tan());
                    on_disc / 2.0
                }
            }
        };
        let mirrored = |p: Point| Point::new(p.x, -p.y);
        let lower =
            upper.edges.iter().map(|e| Edge { from: mirrored(e.from), to: mirrored(e.to), bulge: -e.bulge });
        let mut edges: Vec<Edge> = lower.collect();
        edges.push(Edge { from: mirrored(upper.end), to: upper.end, bulge: closing.tan() });
        edges.extend(upper.edges.iter().rev().map(Edge::reversed));
        edges.push(Edge { from: Point::new(0.0, r), to: Point::new(0.0, -r), bulge: 1.0 });
        Contour::of_simple_edges(edges)
    }
}

/// Half of the outline, from the side of the disc outwards.
struct Profile {
    edges: Vec<Edge>,
    end: Point,
    within_disc: bool,
}

impl Profile {
    fn edge(&mut self, to: Point, bulge: f64) {
        // A step of rounding is none.
        if (to - self.end).norm() > 1e-15 * to.norm() {
            self.edges.push(Edge { from: self.end, to, bulge });
            self.end = to;
        }
    }

    fn line(&mut self, to: Point) {
        self.edge(to, 0.0);
    }

    /// Along the disc, clockwise.
    fn disc(&mut self, to: Point) {
        let turn = self.end.y.atan2(self.end.x) - to.y.atan2(to.x);
        self.edge(to, -(turn / 4.0).tan());
    }
}
