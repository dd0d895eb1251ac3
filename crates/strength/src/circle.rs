//! The smallest circle about points in a plane.

/// Growth of the radius below this share counts as rounding.
const ROUNDING: f64 = 1e-13;

/// A circle.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Circle {
    /// Its middle.
    pub centre: [f64; 2],
    /// Its radius.
    pub radius: f64,
}

/// The smallest circle about all points, which lie within 1e150 and, where not in one place, farther apart than 1e-150; of none the point at the origin.
///
/// From the two or three points that hold it, the farthest point outside joins them and the smallest circle about these holds on. Its radius grows with
/// every step, so it ends; most often after fewer than ten.
pub fn smallest_circle(points: &[[f64; 2]]) -> Circle {
    let Some(first) = points.first() else { return Circle::default() };
    let mut holding = vec![*first];
    let mut circle = Circle { centre: *first, radius: 0.0 };
    loop {
        // By squares: a root for every point would take most of the time of a fatigue analysis.
        let farthest = points.iter().map(|point| (square(circle.centre, *point), *point));
        let (reach, point) = farthest.fold((0.0, *first), |a, b| if b.0 > a.0 { b } else { a });
        let reach = reach.sqrt();
        if reach <= circle.radius * (1.0 + ROUNDING) {
            return circle;
        }
        holding.push(point);
        let (next, on) = about_few(&holding);
        if next.radius <= circle.radius {
            // Rounding alone: what is outside is so by the last digits.
            return Circle { radius: reach, ..circle };
        }
        (circle, holding) = (next, on);
    }
}

/// Square of the distance: points whose squares are numbers of normal size.
fn square(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (a[0] - b[0], a[1] - b[1]);
    x * x + y * y
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The smallest circle about up to four points, by trial of all pairs and triples, with the points that hold it.
fn about_few(points: &[[f64; 2]]) -> (Circle, Vec<[f64; 2]>) {
    let mut best: Option<(Circle, Vec<[f64; 2]>)> = None;
    let mut consider = |circle: Circle, own: &[[f64; 2]]| {
        let holds = |point: &[f64; 2]| distance(circle.centre, *point) <= circle.radius * (1.0 + 1e-12);
        if points.iter().all(holds) && best.as_ref().is_none_or(|(best, _)| circle.radius < best.radius) {
            best = Some((circle, own.to_vec()));
        }
    };
    for i in 0..points.len() {
        for j in 0..i {
            let (a, b) = (points[i], points[j]);
            let centre = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
            consider(Circle { centre, radius: 0.5 * distance(a, b) }, &[a, b]);
            for c in &points[..j] {
                if let Some(circle) = through(a, b, *c) {
                    consider(circle, &[a, b, *c]);
                }
            }
        }
    }
    best.unwrap_or_else(|| {
        let centre = points.first().copied().unwrap_or_default();
        let radius = points.iter().map(|point| distance(centre, *point)).fold(0.0, f64::max);
        (Circle { centre, radius }, points.to_vec())
    })
}

/// The circle through three points; `None` where they lie in line.
fn through(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<Circle> {
    let (p, q) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let twice = 2.0 * (p[0] * q[1] - p[1] * q[0]);
    if twice == 0.0 {
        return None;
    }
    let (pp, qq) = (p[0] * p[0] + p[1] * p[1], q[0] * q[0] + q[1] * q[1]);
    let x = (q[1] * pp - p[1] * qq) / twice;
    let y = (p[0] * qq - q[0] * pp) / twice;
    let circle = Circle { centre: [a[0] + x, a[1] + y], radius: x.hypot(y) };
    circle.radius.is_finite().then_some(circle)
}
