//! Random parts: a star with holes through it, inserts, cavities and stepped bores, in random places.

use super::random_outline::any_star;
use lanchester_geometry::{AreaMoments, Contour, Edge, Insert, Outline, Part, Point};
use proptest::prelude::*;

/// What to put into the material: where, how large, which kind, and two heights.
type Wish = (Point, f64, u8, [f64; 2]);

/// A part with up to six holes and inserts, where they find room.
pub fn any_part() -> impl Strategy<Value = Part> {
    let wish = (-0.08..0.08f64, -0.08..0.08f64, 0.05..0.9f64, 0u8..5, 0.0..0.5f64, 0.5..1.0f64)
        .prop_map(|(x, y, size, kind, from, to)| (Point::new(x, y), size, kind, [from, to]));
    (any_star(), 0.005..0.05f64, prop::collection::vec(wish, 0..14)).prop_map(|(star, thickness, wishes)| {
        let mut outline = Outline::from(Contour::new(&star).unwrap());
        let mut inserts: Vec<Insert> = Vec::new();
        for wish in wishes {
            let (centre, radius) = (wish.0, room(&outline, &inserts, wish.0) * wish.1);
            if radius < 1e-4 {
                continue;
            }
            if wish.2 == 0 {
                let mut holes = outline.holes().to_vec();
                holes.push(hole(centre, radius));
                outline = Outline::new(outline.outer().clone(), holes).unwrap();
            } else {
                inserts.extend(bore(wish, radius, thickness));
            }
        }
        let part = Part::new(outline, thickness, 7850.0).unwrap().at(0.02);
        inserts.into_iter().fold(part, |part, insert| part.with_insert(insert).unwrap())
    })
}

/// Distance from a point in the material to the next edge or insert; zero outside.
fn room(outline: &Outline, inserts: &[Insert], at: Point) -> f64 {
    if !outline.contains(at) {
        return 0.0;
    }
    let others = inserts.iter().map(|insert| (insert.centre - at).norm() - insert.radius);
    others.fold(outline.nearest(at).0, f64::min)
}

/// A hole in the shape of a drop: half a circle and two lines.
fn hole(centre: Point, radius: f64) -> Contour {
    let arc = Edge::arc(centre, radius, 0.0, std::f64::consts::PI);
    let tip = centre - Point::new(0.0, 0.9 * radius);
    Contour::from_edges(&[arc, Edge::line(arc.to, tip), Edge::line(tip, arc.from)], 1e-12).unwrap()
}

/// Through, blind in front, a cavity within, or a hole with a slug behind it, narrower or of the same radius.
fn bore((centre, size, kind, [from, to]): Wish, radius: f64, thickness: f64) -> Vec<Insert> {
    let insert = |radius, from: f64, to: f64, density| Insert {
        centre,
        radius,
        from: from * thickness,
        to: to * thickness,
        density,
    };
    match kind {
        1 => vec![insert(radius, 0.0, 1.0, 18_000.0)],
        2 => vec![insert(radius, 0.0, to, 0.0)],
        3 => vec![insert(radius, 0.05 + 0.8 * from, to.min(0.95), 17_000.0)],
        _ => {
            let second = if size < 0.4 { radius } else { radius * 0.6 };
            vec![insert(radius, 0.0, to, 0.0), insert(second, to, 1.0, 17_000.0)]
        }
    }
}

/// Volume [m^3] and centroid [m] of the solids that a part is made of: itself without its bores, then its inserts.
pub fn volumes(part: &Part) -> Vec<(f64, [f64; 3])> {
    let [front, rear] = part.faces();
    let column = |area: AreaMoments, from: f64, to: f64| {
        let volume = area.area * (to - from);
        [volume, area.first.x * (to - from), area.first.y * (to - from), volume * (from + to) / 2.0]
    };
    let mut body = column(part.outline().moments(), front, rear);
    let mut all = Vec::new();
    for insert in part.inserts() {
        let disc = AreaMoments::disc(insert.centre, insert.radius);
        let bore = column(disc, front + insert.from, front + insert.to);
        body = [0, 1, 2, 3].map(|i| body[i] - bore[i]);
        if insert.density > 0.0 {
            all.push(bore);
        }
    }
    all.insert(0, body);
    all.into_iter().map(|sums| (sums[0], [1, 2, 3].map(|i| sums[i] / sums[0]))).collect()
}
