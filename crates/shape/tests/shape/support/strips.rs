//! Area and first moment of the union of two outlines without cutting a single edge: strips across both, whose widths are
//! read off where they enter and leave.

use lanchester_shape::{Edge, Outline, Point};
use std::f64::consts::PI;

/// Gauss points of the positive half and their weights (Abramowitz and Stegun, table 25.4).
const GAUSS: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_73),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
];

/// Bulge below which the centre of an arc is too far away to be used.
const FLAT: f64 = 1e-2;

/// Where a function changes between two places.
fn halving(f: impl Fn(f64) -> bool, mut a: f64, mut b: f64) -> f64 {
    let start = f(a);
    for _ in 0..54 {
        let middle = (a + b) / 2.0;
        if f(middle) == start { a = middle } else { b = middle }
    }
    (a + b) / 2.0
}

/// The part of a flat arc where its height is largest or smallest; its end where it only rises or falls.
fn extreme(edge: &Edge) -> f64 {
    let rises = |part: f64| edge.at(part).1.y > 0.0;
    if rises(0.0) == rises(1.0) { 1.0 } else { halving(rises, 0.0, 1.0) }
}

/// Where the line at height `y` crosses an edge.
fn crossings(edge: &Edge, y: f64, into: &mut Vec<f64>) {
    if edge.bulge.abs() > 0.4 {
        edge.halves().iter().for_each(|half| crossings(half, y, into));
        return;
    }
    if edge.bulge == 0.0 {
        let (a, b) = (edge.from, edge.to);
        if (a.y > y) != (b.y > y) {
            into.push(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
        return;
    }
    if edge.bulge.abs() < FLAT {
        let extreme = extreme(edge);
        for (a, b) in [(0.0, extreme), (extreme, 1.0)] {
            let above = |part: f64| edge.at(part).0.y > y;
            if above(a) != above(b) {
                into.push(edge.at(halving(above, a, b)).0.x);
            }
        }
        return;
    }
    let (centre, radius) = (edge.centre(), edge.radius());
    let half = (radius - (y - centre.y)) * (radius + (y - centre.y));
    if half < 0.0 {
        return;
    }
    let chord = edge.to - edge.from;
    for x in [centre.x - half.sqrt(), centre.x + half.sqrt()] {
        let along = (Point::new(x, y) - edge.from).dot(chord) / chord.dot(chord);
        let right = (Point::new(x, y) - edge.from).dot(chord.right()) * edge.bulge;
        if (0.0..1.0).contains(&along) && right > 0.0 {
            into.push(x);
        }
    }
}

/// Widths of the union at the height `y`: integrals of 1 and of x.
fn widths(outlines: [&Outline; 2], y: f64) -> [f64; 2] {
    let mut ends = Vec::new();
    for outline in outlines {
        outline.contours().flat_map(|contour| contour.edges()).for_each(|edge| crossings(edge, y, &mut ends));
    }
    ends.sort_by(f64::total_cmp);
    let mut sums = [0.0; 2];
    for pair in ends.windows(2) {
        let middle = Point::new((pair[0] + pair[1]) / 2.0, y);
        if outlines.iter().any(|outline| outline.contains(middle)) {
            sums[0] += pair[1] - pair[0];
            sums[1] += (pair[1] - pair[0]) * (pair[0] + pair[1]) / 2.0;
        }
    }
    sums
}

fn heights(edge: &Edge, into: &mut Vec<f64>) {
    into.extend([edge.from.y, edge.to.y]);
    if edge.bulge == 0.0 {
        return;
    }
    let extreme = if edge.bulge.abs() < FLAT { extreme(edge) } else { 1.0 };
    if extreme < 1.0 {
        into.push(edge.at(extreme).0.y);
    } else {
        let (centre, radius) = (edge.centre(), edge.radius());
        into.extend([centre.y - radius, centre.y + radius]);
    }
}

/// Heights upside down, with more of them wherever a strip is far higher than the one before it. A root that ends just beyond a
/// high strip bends the widths only where none of its Gauss points lies: halving it seems to change nothing.
fn graded(heights: Vec<f64>) -> Vec<f64> {
    let mut graded: Vec<f64> = Vec::with_capacity(heights.len());
    for height in heights {
        while let [.., before, last] = graded[..]
            && height - last > 8.0 * (last - before)
        {
            graded.push(last + 4.0 * (last - before));
        }
        graded.push(height);
    }
    graded.iter().rev().map(|height| -height).collect()
}

/// Area and first moments of the union. The strips begin and end at the heights of corners and arcs, and at those of
/// `corners`: with a wrong set of them the integral only gets less accurate.
pub fn strips(outlines: [&Outline; 2], corners: &Outline) -> (f64, Point) {
    let mut bounds = Vec::new();
    for outline in outlines.into_iter().chain([corners]) {
        outline.contours().flat_map(|c| c.edges()).for_each(|edge| heights(edge, &mut bounds));
    }
    let [low, high] = [0, 1].map(|k| {
        let ends = outlines.map(|outline| outline.bounds()[k].y);
        if k == 0 { ends[0].min(ends[1]) } else { ends[0].max(ends[1]) }
    });
    let clean = |mut bounds: Vec<f64>, low: f64, high: f64| {
        bounds.retain(|y| *y >= low && *y <= high);
        bounds.extend([low, high]);
        bounds.sort_by(f64::total_cmp);
        bounds.dedup_by(|a, b| (*a - *b).abs() < 1e-15);
        bounds
    };
    // Roots that end beyond both outlines bend the widths too.
    let bounds = graded(graded(clean(bounds, 2.0 * low - high, 2.0 * high - low)));
    let bounds = clean(bounds, low, high);
    let scale = (high - low) * (high - low);
    let mut sums = [0.0; 3];
    for pair in bounds.windows(2) {
        // y = middle - half cos(s): the roots at the ends of arcs become smooth.
        let (middle, half) = ((pair[0] + pair[1]) / 2.0, (pair[1] - pair[0]) / 2.0);
        let integrand = |s: f64| {
            let (y, dy) = (middle - half * s.cos(), half * s.sin());
            let [one, x] = widths(outlines, y);
            [one * dy, x * dy, one * y * dy]
        };
        let whole = gauss(&integrand, 0.0, PI);
        sums = add(sums, refined(&integrand, 0.0, PI, whole, scale, 9));
    }
    (sums[0], Point::new(sums[1], sums[2]))
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] + b[k])
}

fn gauss(f: &dyn Fn(f64) -> [f64; 3], from: f64, to: f64) -> [f64; 3] {
    let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
    let points = GAUSS.iter().flat_map(|(x, w)| [(*x, *w), (-x, *w)]);
    points.fold([0.0; 3], |sum, (x, w)| add(sum, f(middle + half * x).map(|value| value * w * half)))
}

/// Halved until that changes nothing.
fn refined(
    f: &dyn Fn(f64) -> [f64; 3],
    from: f64,
    to: f64,
    whole: [f64; 3],
    scale: f64,
    depth: u32,
) -> [f64; 3] {
    let middle = (from + to) / 2.0;
    let (left, right) = (gauss(f, from, middle), gauss(f, middle, to));
    let both = add(left, right);
    if depth == 0 || (both[0] - whole[0]).abs() < 4e-15 * scale {
        return both;
    }
    add(refined(f, from, middle, left, scale, depth - 1), refined(f, middle, to, right, scale, depth - 1))
}
