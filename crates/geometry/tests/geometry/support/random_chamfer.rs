//! Random chamfers of random parts.

use super::random_outline::any_star;
use lanchester_geometry::{Chamfer, Contour, Cut, Face, Insert, Outline, Part, Point};
use proptest::prelude::*;

/// Where it begins as a part of how far the outline reaches, its direction, whether it is turned, its depth as a part of the
/// thickness, and its face.
type Wish = (f64, f64, bool, f64, bool);

/// A part with up to four chamfers, a hole through it and a blind bore, where they find room.
pub fn any_chamfered_part() -> impl Strategy<Value = Part> {
    let wish = (0.3..0.999f64, 0.0..std::f64::consts::TAU, any::<bool>(), 0.05..0.48f64, any::<bool>());
    let centred = (3usize..9, 0.03..0.09f64).prop_map(|(count, radius)| {
        // Lines between arcs about the crank axis, which turned chamfers leave as circles.
        let half = std::f64::consts::PI / count as f64;
        let arcs =
            (0..count).map(|k| (2.0 * half * k as f64, if k % 2 == 0 { (half / 2.0).tan() } else { 0.0 }));
        let corner = |(angle, bulge)| lanchester_geometry::Corner { at: Point::polar(radius, angle), bulge };
        arcs.map(corner).collect::<Vec<_>>()
    });
    let outline = prop_oneof![3 => any_star().boxed(), 1 => centred.boxed()];
    (outline, 0.005..0.05f64, prop::collection::vec(wish, 1..5), 0.05..0.9f64)
        .prop_map(|(corners, thickness, wishes, size)| part(&corners, thickness, &wishes, size))
        .prop_filter("no chamfer found room", |part| !part.chamfers().is_empty())
}

fn part(corners: &[lanchester_geometry::Corner], thickness: f64, wishes: &[Wish], size: f64) -> Part {
    let mut outline = Outline::from(Contour::new(corners).unwrap());
    let middle = outline.moments().centroid();
    let room = if outline.contains(middle) { outline.nearest(middle).0 } else { 0.0 };
    let hole = Contour::circle(middle, size * room)
        .and_then(|hole| Outline::new(outline.outer().clone(), vec![hole]));
    if let Ok(holed) = hole {
        outline = holed;
    }
    let mut part = Part::new(outline, thickness, 7850.0).unwrap().at(0.02);
    for (start, direction, turned, depth, front) in wishes {
        let (reach, cut): (f64, fn(f64, f64) -> Cut) = if *turned {
            (part.outline().swept_radius(), |radius, _| Cut::Turned { radius })
        } else {
            let reach = part.outline().reach(Point::polar(1.0, *direction));
            (reach, |distance, direction| Cut::Milled { direction, distance })
        };
        let cut = cut(start * reach, *direction);
        let angle = (depth * thickness / ((1.0 - start) * reach).abs()).atan();
        let face = if *front { Face::Front } else { Face::Rear };
        // What meets another chamfer or goes too deep is left out.
        if let Ok(more) = part.clone().with_chamfer(Chamfer { cut, angle, face }) {
            part = more;
        }
    }
    let at = middle + Point::new(0.0, (1.0 + size) / 2.0 * room);
    let bore = Insert {
        centre: at,
        radius: 0.2 * (1.0 - size) * room,
        from: 0.0,
        to: 0.5 * thickness,
        density: 0.0,
    };
    part.clone().with_insert(bore).unwrap_or(part)
}

/// Volume [m^3] and centroid [m] by the part's own mass properties, which follow another way: its bores are empty.
pub fn volume(part: &Part) -> (f64, [f64; 3]) {
    let properties = part.mass_properties();
    (properties.mass / part.density(), properties.centre)
}
