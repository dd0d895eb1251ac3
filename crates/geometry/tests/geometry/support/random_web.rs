//! Random outlines with holes, and comparison of outlines.

use lanchester_geometry::{Contour, Corner, Outline, Point};
use proptest::prelude::*;

/// Whether no corner is so sharp that rounding decides if its two edges touch beside it.
fn is_blunt(contour: &Contour) -> bool {
    let edges = contour.edges();
    (0..edges.len()).all(|k| {
        let back = -edges[k].tangents()[1];
        let ahead = edges[(k + 1) % edges.len()].tangents()[0];
        back.cross(ahead).atan2(back.dot(ahead)).abs() > 0.01
    })
}

/// An outline of a star ([`super::random_outline`]) with up to three small copies of stars as holes, where they fit.
pub fn any_web(
    star: impl Strategy<Value = Vec<Corner>>,
    holes: impl Strategy<Value = Vec<Vec<Corner>>>,
) -> impl Strategy<Value = Outline> {
    let blunt = |corners: &Vec<Corner>| is_blunt(&Contour::new(corners).unwrap());
    let star = star.prop_filter("it has a cusp", blunt);
    let holes = holes.prop_filter("it has a cusp", move |holes: &Vec<Vec<Corner>>| holes.iter().all(blunt));
    (star, holes).prop_map(|(star, holes)| {
        let outer = Contour::new(&star).unwrap();
        let middle =
            star.iter().fold(Point::ORIGIN, |sum, corner| sum + corner.at) * (1.0 / star.len() as f64);
        let mut web = Outline::from(outer);
        for (number, hole) in holes.iter().enumerate() {
            let to = middle + Point::polar(0.008, 2.1 * number as f64);
            let corners: Vec<Corner> =
                hole.iter().map(|corner| Corner { at: corner.at * 0.05 + to, ..*corner }).collect();
            let mut all = web.holes().to_vec();
            // Rounding may spoil a contour that hardly did not touch itself, and it may lie outside.
            let Ok(hole) = Contour::new(&corners) else { continue };
            all.push(hole);
            if let Ok(more) = Outline::new(web.outer().clone(), all) {
                web = more;
            }
        }
        web
    })
}

/// Area within 1e-12 of it, centroid and first moments within 1e-12 of the size, second moments likewise.
pub fn assert_same(read: &Outline, written: &Outline) {
    let (found, exact) = (read.moments(), written.moments());
    let size = written.swept_radius();
    // Where contours enclose little more than nothing, digits are lost in the areas of their parts.
    let whole = written.contours().map(|contour| contour.length().powi(2)).sum::<f64>() / 12.0;
    let scale = whole.max(exact.area);
    assert!((found.area - exact.area).abs() <= 1e-12 * scale, "{} {}", found.area, exact.area);
    assert!((found.first - exact.first).norm() <= 1e-12 * scale * size);
    assert!((found.centroid() - exact.centroid()).norm() <= 1e-12 * size * scale / exact.area);
    for (found, exact) in [(found.xx, exact.xx), (found.yy, exact.yy), (found.xy, exact.xy)] {
        assert!((found - exact).abs() <= 1e-12 * scale * size * size);
    }
    assert_eq!(read.holes().len(), written.holes().len());
}
