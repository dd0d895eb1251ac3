//! A drawing from computed coordinates, in the style of the report's figures.

use std::f64::consts::PI;
use std::fmt::Write;

/// A place on the drawing [px], y down.
pub type Point = (f64, f64);

/// Length of an arrow head [px].
const HEAD: f64 = 9.0;
/// Sharpest turn between two pieces of a curve [rad].
const STEP: f64 = PI / 60.0;

/// The side of its point on which a text stands.
#[derive(Clone, Copy)]
pub enum Anchor {
    /// Begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// Ends there.
    End,
}

/// How coordinates of the theory lie on the drawing.
#[derive(Clone, Copy)]
pub struct Plane {
    /// Where their origin is [px].
    pub origin: Point,
    /// Pixels for one of their units.
    pub scale: f64,
    /// The first one points up and the second to the right, as seen from the free end of an engine; else right and up.
    pub upright: bool,
}

impl Plane {
    /// First coordinate up, second to the right.
    pub fn upright(origin: Point, scale: f64) -> Plane {
        Plane { origin, scale, upright: true }
    }

    /// First coordinate to the right, second up.
    pub fn level(origin: Point, scale: f64) -> Plane {
        Plane { origin, scale, upright: false }
    }

    /// The place of a point.
    pub fn at(&self, (a, b): (f64, f64)) -> Point {
        let (right, up) = if self.upright { (b, a) } else { (a, b) };
        (self.origin.0 + self.scale * right, self.origin.1 - self.scale * up)
    }

    /// An arc about a centre, the angles counted from the first coordinate towards the second.
    pub fn arc(&self, centre: (f64, f64), radius: f64, from: f64, to: f64) -> Vec<Point> {
        let pieces = ((to - from).abs() / STEP).ceil().max(2.0);
        (0..=pieces as usize)
            .map(|k| self.at(beyond(centre, radius, from + (to - from) * k as f64 / pieces)))
            .collect()
    }
}

/// The point at a distance from another, in the direction of an angle.
pub fn beyond((a, b): (f64, f64), distance: f64, angle: f64) -> (f64, f64) {
    (a + distance * angle.cos(), b + distance * angle.sin())
}

/// The point between two others, at a share of the way.
pub fn between(from: (f64, f64), to: (f64, f64), share: f64) -> (f64, f64) {
    (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1))
}

/// A drawing under way.
pub struct Pen {
    body: String,
}

impl Pen {
    /// An empty drawing.
    pub fn new() -> Pen {
        Pen { body: String::new() }
    }

    /// The elements drawn.
    pub fn into_body(self) -> String {
        self.body
    }

    /// A straight line.
    pub fn line(&mut self, class: &str, from: Point, to: Point) {
        self.chain(class, &[from, to]);
    }

    /// A line through points.
    pub fn chain(&mut self, class: &str, points: &[Point]) {
        self.path(class, points, "");
    }

    /// What a closed line bounds.
    pub fn area(&mut self, class: &str, points: &[Point]) {
        self.path(class, points, "Z");
    }

    fn path(&mut self, class: &str, points: &[Point], end: &str) {
        let _ = write!(self.body, "<path class=\"{class}\" d=\"");
        for (index, (x, y)) in points.iter().enumerate() {
            let _ = write!(self.body, "{}{x:.1} {y:.1}", if index == 0 { 'M' } else { 'L' });
        }
        let _ = writeln!(self.body, "{end}\"/>");
    }

    /// A circle.
    pub fn circle(&mut self, class: &str, (x, y): Point, radius: f64) {
        let _ =
            writeln!(self.body, "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius:.1}\"/>");
    }

    /// A straight arrow; `class` is its colour: `a0` to `a3`, `turn`, `measure`.
    pub fn arrow(&mut self, class: &str, from: Point, to: Point) {
        self.turn(class, &[from, to]);
    }

    /// An arrow along a line through points.
    pub fn turn(&mut self, class: &str, points: &[Point]) {
        let [.., before, tip] = *points else { return };
        let length = (tip.0 - before.0).hypot(tip.1 - before.1).max(1e-9);
        let (ux, uy) = ((tip.0 - before.0) / length, (tip.1 - before.1) / length);
        let neck = (tip.0 - HEAD * ux, tip.1 - HEAD * uy);
        let half = 0.42 * HEAD;
        let _ = writeln!(self.body, "<g class=\"arrow {class}\">");
        // The line ends within the head, so that its end does not stick out of the tip.
        let shaft = without_end(points, 0.7 * HEAD);
        self.chain("shaft", &shaft);
        let sides = [(neck.0 - half * uy, neck.1 + half * ux), (neck.0 + half * uy, neck.1 - half * ux)];
        self.area("head", &[tip, sides[0], sides[1]]);
        self.body.push_str("</g>\n");
    }

    /// A symbol of the page: `m_A` has an index, which ends at a space or a sign; `A′` has a prime.
    pub fn symbol(&mut self, at: Point, anchor: Anchor, text: &str) {
        self.text("symbol halo", at, anchor, text);
    }

    /// Words.
    pub fn words(&mut self, at: Point, anchor: Anchor, text: &str) {
        self.text("halo", at, anchor, text);
    }

    /// Words of less weight.
    pub fn remark(&mut self, at: Point, anchor: Anchor, text: &str) {
        self.text("muted remark halo", at, anchor, text);
    }

    fn text(&mut self, class: &str, (x, y): Point, anchor: Anchor, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let _ = writeln!(
            self.body,
            "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{}</text>",
            with_indices(text)
        );
    }

    /// A length between two points, its line `away` from them [px], to the left of the way from the first to the second.
    pub fn measure(&mut self, from: Point, to: Point, away: f64, label: &str) {
        let length = (to.0 - from.0).hypot(to.1 - from.1).max(1e-9);
        let (ux, uy) = ((to.0 - from.0) / length, (to.1 - from.1) / length);
        let left = |p: Point, d: f64| (p.0 + d * uy, p.1 - d * ux);
        let sign = if away == 0.0 { 0.0 } else { away.signum() };
        for end in [from, to] {
            if away.abs() > 8.0 {
                self.line("dimension", left(end, 4.0 * sign), left(end, away + 4.0 * sign));
            }
        }
        let (a, b) = (left(from, away), left(to, away));
        let middle = between(a, b, 0.5);
        self.arrow("measure", middle, a);
        self.arrow("measure", middle, b);
        self.symbol((middle.0, middle.1 + 5.5), Anchor::Middle, label);
    }

    /// An angle about a centre, counted in the plane, with its symbol beyond the middle of the arc.
    pub fn angle(
        &mut self,
        plane: &Plane,
        centre: (f64, f64),
        radius: f64,
        [from, to]: [f64; 2],
        label: &str,
    ) {
        self.turn("turn", &plane.arc(centre, radius, from, to));
        let (x, y) = plane.at(beyond(centre, radius + 13.0 / plane.scale, (from + to) / 2.0));
        self.symbol((x, y + 5.5), Anchor::Middle, label);
    }

    /// A zigzag spring between two points.
    pub fn spring(&mut self, from: Point, to: Point) {
        let length = (to.0 - from.0).hypot(to.1 - from.1).max(1e-9);
        let (ux, uy) = ((to.0 - from.0) / length, (to.1 - from.1) / length);
        let mut points = vec![from];
        const TEETH: usize = 8;
        for k in 0..=TEETH {
            let along = length * (0.2 + 0.6 * k as f64 / TEETH as f64);
            let aside = if k == 0 || k == TEETH {
                0.0
            } else if k % 2 == 0 {
                6.0
            } else {
                -6.0
            };
            points.push((from.0 + along * ux - aside * uy, from.1 + along * uy + aside * ux));
        }
        points.push(to);
        self.chain("outline", &points);
    }

    /// A dashpot between two points.
    pub fn dashpot(&mut self, from: Point, to: Point) {
        let length = (to.0 - from.0).hypot(to.1 - from.1).max(1e-9);
        let (ux, uy) = ((to.0 - from.0) / length, (to.1 - from.1) / length);
        let at = |along: f64, aside: f64| {
            (from.0 + along * length * ux - aside * uy, from.1 + along * length * uy + aside * ux)
        };
        self.line("outline", at(0.0, 0.0), at(0.5, 0.0));
        self.line("outline", at(0.5, -6.0), at(0.5, 6.0));
        self.chain("outline", &[at(0.38, -9.0), at(0.66, -9.0), at(0.66, 9.0), at(0.38, 9.0)]);
        self.line("outline", at(0.66, 0.0), at(1.0, 0.0));
    }

    /// The ground along a line, hatched on its right.
    pub fn ground(&mut self, from: Point, to: Point) {
        let length = (to.0 - from.0).hypot(to.1 - from.1).max(1e-9);
        let (ux, uy) = ((to.0 - from.0) / length, (to.1 - from.1) / length);
        self.line("outline", from, to);
        for k in 0..(length / 9.0) as usize {
            let start = 9.0 * (k as f64 + 0.8);
            let on = (from.0 + start * ux, from.1 + start * uy);
            self.line("thin", on, (on.0 - 8.0 * ux - 8.0 * uy, on.1 - 8.0 * uy + 8.0 * ux));
        }
    }
}

/// The line without its last pixels.
fn without_end(points: &[Point], pixels: f64) -> Vec<Point> {
    let mut kept = points.to_vec();
    let mut left = pixels;
    while let [.., before, last] = *kept {
        let length = (last.0 - before.0).hypot(last.1 - before.1);
        if length > left {
            let end = kept.len() - 1;
            kept[end] = between(last, before, left / length);
            break;
        }
        left -= length;
        kept.pop();
    }
    kept
}

/// Markup of a text with its indices lowered.
fn with_indices(text: &str) -> String {
    let mut out = String::new();
    for (number, part) in text.split('_').enumerate() {
        let length = if number == 0 { 0 } else { index_length(part) };
        let (index, rest) = part.split_at(length);
        let rest = escape(rest);
        if number > 0 {
            let _ = write!(out, "<tspan class=\"index\" dy=\"4\">{}</tspan>", escape(index));
            if !rest.is_empty() {
                // The way back up hangs on what follows.
                let _ = write!(out, "<tspan dy=\"-4\">{rest}</tspan>");
            }
        } else {
            out.push_str(&rest);
        }
    }
    out
}

fn index_length(text: &str) -> usize {
    text.find(|c: char| !(c.is_alphanumeric() || c == '−' && text.starts_with('−'))).unwrap_or(text.len())
}

/// Text with the characters of markup escaped.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_coordinate_of_an_upright_plane_points_up() {
        let plane = Plane::upright((100.0, 100.0), 10.0);
        assert_eq!(plane.at((1.0, 0.0)), (100.0, 90.0));
        assert_eq!(plane.at((0.0, 1.0)), (110.0, 100.0));
        let quarter = plane.arc((0.0, 0.0), 1.0, 0.0, PI / 2.0);
        let last = quarter[quarter.len() - 1];
        assert!((last.0 - 110.0).hypot(last.1 - 100.0) < 1e-9, "{last:?}");
    }

    #[test]
    fn indices_end_at_signs() {
        assert_eq!(with_indices("a"), "a");
        assert_eq!(
            with_indices("m_A r"),
            "m<tspan class=\"index\" dy=\"4\">A</tspan><tspan dy=\"-4\"> r</tspan>"
        );
        assert_eq!(with_indices("f_−n"), "f<tspan class=\"index\" dy=\"4\">−n</tspan>");
    }

    #[test]
    fn an_arrow_keeps_its_way_to_the_head() {
        let shaft = without_end(&[(0.0, 0.0), (10.0, 0.0), (12.0, 0.0)], 6.0);
        assert_eq!(shaft, [(0.0, 0.0), (6.0, 0.0)]);
    }
}
