//! A weight of a balance shaft as a dimensioned drawing: across the shaft, and along it.

use crate::kit::dimension::{horizontal, leader, millimetres, vertical};
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::sheet::{SECTION, Sheet, WIDTH, identifier};
use crate::kit::svg::{Anchor, Svg};
use lanchester_geometry::{Outline, Point};
use lanchester_model::{Engine, ShaftWeightPart};

/// How far the shaft is drawn beyond the weight on either side [px].
const STUB: f64 = 22.0;

/// The drawings of the weights of an engine's balance shafts that are parts; those of one shape once.
pub fn shaft_weight_drawings(engine: &Engine) -> Vec<Figure> {
    let mut groups: Vec<(Vec<String>, &ShaftWeightPart)> = Vec::new();
    for shaft in &engine.shafts {
        for (index, weight) in shaft.weights.iter().enumerate() {
            let Some(part) = &weight.part else { continue };
            let name = shaft.weight_name(index);
            let alike = |known: &ShaftWeightPart| {
                (known.shape, known.length, known.density) == (part.shape, part.length, part.density)
            };
            match groups.iter_mut().find(|(_, known)| alike(known)) {
                Some((names, _)) => names.push(name),
                None => groups.push((vec![name], part)),
            }
        }
    }
    groups.iter().filter_map(|(names, part)| shaft_weight_drawing(names, part)).collect()
}

/// The dimensioned drawing of weights of one shape; none where its dimensions are not possible, or no weight has it.
fn shaft_weight_drawing(names: &[String], part: &ShaftWeightPart) -> Option<Figure> {
    let (name, others) = names.split_first()?;
    let shape = part.shape;
    let outline = shape.outline().ok()?;
    let (mass, unbalance) = (part.mass(), part.unbalance());
    let centre = unbalance / mass;
    let caption = format!(
        "Weight around its shaft, {} mm long, {} kg/m³. Mass {} g, unbalance {} kg mm, centre of mass {} mm from the axis, polar inertia \
         about it {} kg mm², all without the shaft. All dimensions in mm; up is the direction of the unbalance.{}",
        millimetres(part.length),
        number::trimmed(part.density, 5),
        number::trimmed(1e3 * mass, 4),
        number::trimmed(1e3 * unbalance, 5),
        millimetres(centre),
        number::trimmed(1e6 * part.polar_inertia(), 4),
        if others.is_empty() { String::new() } else { format!(" Likewise: {}.", others.join(", ")) },
    );
    let sheet = Sheet::new(outline.bounds(), shape.radius);
    let mut svg = Svg::new(WIDTH + SECTION, sheet.height);
    across(&mut svg, part, &outline, &sheet);
    sheet.centre_of_mass(&mut svg, Point::new(centre, 0.0));
    along(&mut svg, part, &sheet);
    let description = format!(
        "Radius {} mm, shaft {} mm in diameter, chord {} mm from the axis, {} mm long.",
        millimetres(shape.radius),
        millimetres(2.0 * shape.shaft_radius),
        millimetres(shape.chord),
        millimetres(part.length)
    );
    Some(Figure {
        id: format!("shaft-weight-{}", identifier(name)),
        title: format!("Weight of a balance shaft: {name}"),
        caption,
        panels: vec![Panel::new(svg, description)],
        columns: 1,
    })
}

/// The view across the shaft.
fn across(svg: &mut Svg, part: &ShaftWeightPart, outline: &Outline, sheet: &Sheet) {
    let shape = &part.shape;
    let (r, radius, chord) = (shape.shaft_radius, shape.radius, shape.chord);
    svg.path("metal", &sheet.path(outline.outer()));
    svg.circle("thin dashed", sheet.centre, r * sheet.scale);
    sheet.axes(svg);
    let half_width = ((radius - chord) * (radius + chord)).sqrt();
    let widest = if chord > 0.0 { half_width } else { radius };
    let left = sheet.at(Point::new(0.0, -widest)).0;
    let axis = sheet.centre.0;
    if chord.abs() * sheet.scale > 0.5 {
        let edge = sheet.at(Point::new(chord, -half_width)).0;
        let ends = if chord > 0.0 { [0.0, chord] } else { [chord, 0.0] };
        let from = if chord > 0.0 { [axis, edge] } else { [edge, axis] };
        vertical(svg, left - 34.0, ends.map(|x| sheet.x(x)), from, &format!("c {}", millimetres(chord)));
    }
    vertical(svg, left - 76.0, [sheet.x(0.0), sheet.x(radius)], [axis; 2], &millimetres(radius));
    let below = sheet.x(sheet.low.x) + 30.0;
    let places = [-half_width, half_width].map(|y| sheet.at(Point::new(chord, y)).0);
    horizontal(svg, below, places, [sheet.x(chord); 2], &millimetres(2.0 * half_width));
    let place = |radius: f64, angle: f64| sheet.at(Point::new(radius * angle.cos(), radius * angle.sin()));
    let tip = place(radius, 0.5);
    leader(svg, tip, (tip.0 + 26.0, tip.1 - 24.0), &format!("R {}", millimetres(radius)));
    let tip = place(r, 2.4);
    leader(svg, tip, (tip.0 + 30.0, tip.1 + 18.0), &format!("Ø {}", millimetres(2.0 * r)));
}

/// The view along the shaft: the weight's length.
fn along(svg: &mut Svg, part: &ShaftWeightPart, sheet: &Sheet) {
    let shape = &part.shape;
    // A long weight is drawn shorter, for its length stands on it.
    let length = (part.length * sheet.scale).min(SECTION - 2.0 * STUB - 30.0);
    let left = WIDTH + (SECTION - length) / 2.0 - 30.0;
    let half = shape.shaft_radius * sheet.scale;
    svg.rect("metal", left - STUB, sheet.centre.1 - half, length + 2.0 * STUB, 2.0 * half);
    let [top, bottom] = [shape.radius, shape.chord].map(|x| sheet.x(x));
    svg.rect("metal", left, top, length, bottom - top);
    svg.line(
        "axis-line",
        (left - STUB - 10.0, sheet.centre.1),
        (left + length + STUB + 10.0, sheet.centre.1),
    );
    horizontal(svg, top - 28.0, [left, left + length], [top; 2], &millimetres(part.length));
    let words =
        if length < part.length * sheet.scale { "axis of the shaft, shortened" } else { "axis of the shaft" };
    let place = (left + length / 2.0, sheet.x(sheet.low.x) + 34.0);
    svg.text("muted small", place, Anchor::Middle, words);
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_geometry::ShaftWeightShape;

    fn part(chord: f64) -> ShaftWeightPart {
        let shape = ShaftWeightShape { shaft_radius: 0.012, radius: 0.036, chord };
        ShaftWeightPart { shape, length: 0.04, density: 7850.0, wanted: None }
    }

    #[test]
    fn every_dimension_stands_on_the_drawing() {
        for (chord, label) in [(0.0065, "c 6.5"), (-0.0085, "c −8.5"), (-0.02, "c −20")] {
            let svg = shaft_weight_drawing(&["left".to_owned()], &part(chord)).expect("a weight").svg();
            let width = format!(">{}<", millimetres(2.0 * (0.036f64.powi(2) - chord * chord).sqrt()));
            for words in [label, "R 36", "Ø 24", ">40<", ">36<", &width] {
                assert!(svg.contains(words), "{words} is missing at {chord}");
            }
            assert!(!svg.contains("NaN"));
        }
        // A chord through the axis needs no dimension.
        assert!(
            !shaft_weight_drawing(&["left".to_owned()], &part(0.0)).expect("a weight").svg().contains(">c ")
        );
    }

    #[test]
    fn what_is_no_weight_has_no_drawing() {
        assert!(shaft_weight_drawing(&["left".to_owned()], &part(0.012)).is_none());
    }
}
