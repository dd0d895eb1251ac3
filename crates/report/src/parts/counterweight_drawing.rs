//! A counterweight as a dimensioned drawing: across the crank, and its section along it.

use crate::kit::dimension::{horizontal, leader, millimetres, vertical};
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::sheet::{SECTION, Sheet, WIDTH, identifier};
use crate::kit::svg::{Anchor, Path, Svg, text_width};
use lanchester_geometry::{
    Chamfer, CounterweightShape, Cut, Face, Insert, MassProperties, Outline, Part, Point,
};
use lanchester_model::{CounterweightForm, CounterweightPart};

/// What a counterweight's drawing shows.
#[derive(Debug, Clone, Copy)]
pub struct DrawnCounterweight<'a> {
    /// Its name in the title.
    pub name: &'a str,
    /// The part.
    pub part: &'a CounterweightPart,
    /// Its mass properties: of a shape of the family without the disc of the web.
    pub properties: &'a MassProperties,
    /// Outline of the plain web that it sits on, in the frame of the part, if the engine has one.
    pub web: Option<&'a Outline>,
    /// Inner radius of the crankcase about the crank axis [m], if the engine has one.
    pub crankcase: Option<f64>,
}

/// The dimensioned drawing of a counterweight.
pub fn counterweight_drawing(drawn: &DrawnCounterweight<'_>) -> Figure {
    let part = &drawn.part.part;
    let weight = drawn.properties;
    let grams = |kilograms: f64| format!("{} g", number::trimmed(1e3 * kilograms, 4));
    let unbalance = weight.unbalance.norm();
    let caption = format!(
        "{}, {} thick, {} kg/m³. Mass {}, unbalance {} kg mm, centre of mass {} mm from the crank axis, polar inertia \
         about it {} kg mm²{}. All dimensions in mm, seen from the free end of a crank that turns clockwise{}.",
        match drawn.part.form {
            CounterweightForm::Family(_) => "Counterweight around the disc of its web",
            CounterweightForm::Counterweight => "Counterweight",
            CounterweightForm::Web => "Web with its counterweight",
        },
        format_args!("{} mm", millimetres(part.thickness())),
        number::trimmed(part.density(), 5),
        grams(weight.mass),
        number::trimmed(1e3 * unbalance, 5),
        millimetres(unbalance / weight.mass),
        number::trimmed(1e6 * weight.polar_inertia(), 4),
        match drawn.part.form {
            CounterweightForm::Family(_) if drawn.web.is_none() => ", all without the disc",
            CounterweightForm::Family(_) | CounterweightForm::Web => ", all beyond the plain web",
            CounterweightForm::Counterweight => "",
        },
        if drawn.crankcase.is_some() { "; dashed: the crankcase, where it is near" } else { "" },
    );
    let [mut low, mut high] = part.outline().bounds();
    if let Some(web) = drawn.web {
        let [l, h] = web.bounds();
        (low, high) =
            (Point::new(low.x.min(l.x), low.y.min(l.y)), Point::new(high.x.max(h.x), high.y.max(h.y)));
    }
    let sheet = Sheet::new([low, high], part.outline().swept_radius());
    let mut svg = Svg::new(WIDTH + SECTION, sheet.height);
    across(&mut svg, drawn, &sheet);
    along(&mut svg, part, &sheet);
    let [low, high] = part.outline().bounds();
    let description = format!(
        "{} mm high, {} mm wide, {} mm thick, swept radius {} mm.",
        millimetres(high.x - low.x),
        millimetres(high.y - low.y),
        millimetres(part.thickness()),
        millimetres(part.outline().swept_radius())
    );
    Figure {
        id: format!("counterweight-{}", identifier(drawn.name)),
        title: format!("Counterweight of {}", drawn.name),
        caption,
        panels: vec![Panel::new(svg, description)],
        columns: 1,
    }
}

/// The view across the crank.
fn across(svg: &mut Svg, drawn: &DrawnCounterweight<'_>, sheet: &Sheet) {
    let part = &drawn.part.part;
    if let Some(web) = drawn.web {
        for contour in web.contours() {
            svg.path("metal", &sheet.path(contour));
        }
    }
    svg.path("metal", &sheet.path(part.outline().outer()));
    for opening in part.outline().contours().skip(1) {
        svg.path("pin", &sheet.path(opening));
    }
    for insert in part.inserts() {
        bore(svg, sheet, insert, part.thickness());
    }
    for chamfer in part.chamfers() {
        chamfer_line(svg, sheet, chamfer);
    }
    sheet.axes(svg);
    swept_circle(svg, sheet, part.outline(), drawn.crankcase);
    match &drawn.part.form {
        CounterweightForm::Family(shape) => family_dimensions(svg, sheet, shape),
        _ => overall_dimensions(svg, sheet, part),
    }
    let [x, y, _] = drawn.properties.centre;
    sheet.centre_of_mass(svg, Point::new(x, y));
}

/// A bore with its centre lines, its diameter and its depth.
fn bore(svg: &mut Svg, sheet: &Sheet, insert: &Insert, thickness: f64) {
    let (centre, radius) = (sheet.at(insert.centre), insert.radius * sheet.scale);
    svg.circle(if insert.density > 0.0 { "slug" } else { "pin" }, centre, radius);
    let reach = radius + 5.0;
    svg.line("axis-line", (centre.0 - reach, centre.1), (centre.0 + reach, centre.1));
    svg.line("axis-line", (centre.0, centre.1 - reach), (centre.0, centre.1 + reach));
    let slack = 1e-9 * thickness;
    let depth = match (insert.from <= slack, insert.to >= thickness - slack) {
        (true, true) => "through".to_owned(),
        (true, false) => format!("{} deep from the free end", millimetres(insert.to)),
        (false, true) => format!("{} deep from the flywheel end", millimetres(thickness - insert.from)),
        (false, false) => {
            format!("{} to {} from the free end", millimetres(insert.from), millimetres(insert.to))
        }
    };
    let material = match insert.density > 0.0 {
        true => format!(", {} kg/m³", number::trimmed(insert.density, 5)),
        false => String::new(),
    };
    let label = format!("⌀ {}, {depth}{material}", millimetres(2.0 * insert.radius));
    let side = if insert.centre.y < 0.0 { -1.0 } else { 1.0 };
    let tip = (centre.0 + side * 0.707 * radius, centre.1 + 0.707 * radius);
    leader(svg, tip, (tip.0 + side * 26.0, tip.1 + 30.0), &label);
}

/// The circle that the part sweeps, as far as its outline comes near it, and the crankcase.
fn swept_circle(svg: &mut Svg, sheet: &Sheet, outline: &Outline, crankcase: Option<f64>) {
    let farthest = outline.farthest_point();
    let half = (farthest.y.abs().atan2(farthest.x) + 0.16).clamp(0.6, 1.6);
    let mut arc = |class: &str, radius: f64| {
        let reach = |angle: f64| Point::new(radius * angle.cos(), radius * angle.sin());
        let path = Path::new().move_to(sheet.at(reach(-half))).arc_to(
            radius * sheet.scale,
            false,
            true,
            sheet.at(reach(half)),
        );
        svg.path(class, &path);
    };
    arc("axis-line", sheet.swept);
    if let Some(crankcase) = crankcase
        && crankcase > sheet.swept
        && (crankcase - sheet.swept) * sheet.scale < 16.0
    {
        arc("limit", crankcase);
    }
    let angle = 0.72 * half;
    let tip = sheet.at(Point::new(sheet.swept * angle.cos(), sheet.swept * angle.sin()));
    leader(svg, tip, (tip.0 + 24.0, tip.1 - 16.0), &format!("sweeps {}", millimetres(sheet.swept)));
}

/// Dimensions of the tool paper's family.
fn family_dimensions(svg: &mut Svg, sheet: &Sheet, shape: &CounterweightShape) {
    let (h, chord, crown) = (shape.rectangle_height, shape.chord_distance(), shape.crown());
    let (r, w) = (shape.web_radius, shape.half_width());
    let left = sheet.at(Point::new(0.0, sheet.low.y)).0;
    let edge_of = |x: f64, y: f64| sheet.at(Point::new(x, -y)).0;
    let mut column = left - 34.0;
    if shape.shoulder_height * sheet.scale > 0.5 {
        vertical(
            svg,
            column,
            [sheet.x(h), sheet.x(chord)],
            [edge_of(h, r), edge_of(chord, w)],
            &format!("H {}", millimetres(shape.shoulder_height)),
        );
    }
    if h * sheet.scale > 0.5 {
        vertical(
            svg,
            column,
            [sheet.x(0.0), sheet.x(h)],
            [edge_of(0.0, r), edge_of(h, r)],
            &format!("h {}", millimetres(h)),
        );
    }
    column -= 42.0;
    vertical(
        svg,
        column,
        [sheet.x(0.0), sheet.x(crown)],
        [edge_of(0.0, r), sheet.centre.0],
        &millimetres(crown),
    );
    let top = sheet.x(sheet.swept) - 34.0;
    let places = [-w, w].map(|y| sheet.at(Point::new(chord, y)).0);
    horizontal(svg, top, places, [sheet.x(chord); 2], &format!("2w {}", millimetres(2.0 * w)));
    // Arc: its centre, the radii to the ends of the chord, radius and angle.
    let centre = Point::new(shape.centre_distance(), 0.0);
    let at = sheet.at(centre);
    let on_sheet = at.1 < sheet.height - 8.0 && at.1 > 8.0;
    if on_sheet {
        for side in [-1.0, 1.0] {
            svg.line("dimension", at, sheet.at(Point::new(chord, side * w)));
        }
        let half = shape.arc_angle / 2.0;
        let radius = (0.22 * shape.arc_radius * sheet.scale).max(24.0);
        let up = -std::f64::consts::FRAC_PI_2;
        let place = |angle: f64| (at.0 + radius * angle.cos(), at.1 + radius * angle.sin());
        let path = Path::new().move_to(place(up - half)).arc_to(
            radius,
            shape.arc_angle > std::f64::consts::PI,
            true,
            place(up + half),
        );
        svg.path("dimension", &path);
        let label = format!("α {}°", number::trimmed(shape.arc_angle.to_degrees(), 4));
        svg.text("halo", (at.0, at.1 + 17.0), Anchor::Middle, &label);
    }
    let lean = -0.42 * (shape.arc_angle / 2.0).min(1.2);
    let tip = sheet.at(centre + Point::new(lean.cos(), lean.sin()) * shape.arc_radius);
    leader(svg, tip, (tip.0 - 30.0, tip.1 - 26.0), &format!("R {}", millimetres(shape.arc_radius)));
    let tip = sheet.at(Point::new(-r * 0.6, r * 0.8));
    leader(svg, tip, (tip.0 + 28.0, tip.1 + 20.0), &format!("r {}", millimetres(r)));
}

/// Overall dimensions of an outline of the user's own.
fn overall_dimensions(svg: &mut Svg, sheet: &Sheet, part: &Part) {
    let [low, high] = part.outline().bounds();
    let left = sheet.at(Point::new(0.0, sheet.low.y)).0;
    let column = left - 34.0;
    let axis = sheet.centre.0;
    if high.x > 0.0 {
        vertical(svg, column, [sheet.x(0.0), sheet.x(high.x)], [left - 10.0, axis], &millimetres(high.x));
    }
    if low.x < 0.0 {
        vertical(svg, column, [sheet.x(low.x), sheet.x(0.0)], [axis, left - 10.0], &millimetres(-low.x));
    }
    let places = [low.y, high.y].map(|y| sheet.at(Point::new(0.0, y)).0);
    let below = sheet.x(sheet.low.x) + 30.0;
    horizontal(svg, below, places, [sheet.x(sheet.low.x); 2], &millimetres(high.y - low.y));
}

/// Where a chamfer leaves the face; dashed on the rear face.
fn chamfer_line(svg: &mut Svg, sheet: &Sheet, chamfer: &Chamfer) {
    let class = if chamfer.face == Face::Front { "thin" } else { "thin dashed" };
    match chamfer.cut {
        Cut::Turned { radius } => svg.circle(class, sheet.centre, radius * sheet.scale),
        Cut::Milled { distance, direction } => {
            let (along, across) =
                (Point::new(direction.cos(), direction.sin()), Point::new(-direction.sin(), direction.cos()));
            let reach = 0.5 * (sheet.high.y - sheet.low.y);
            let ends = [-1.0, 1.0].map(|side| sheet.at(along * distance + across * (side * reach)));
            svg.line(class, ends[0], ends[1]);
        }
    }
}

/// The view along `y`: its thickness.
fn along(svg: &mut Svg, part: &Part, sheet: &Sheet) {
    let thickness = part.thickness() * sheet.scale;
    let [low, high] = part.outline().bounds();
    let left = WIDTH + (SECTION - thickness) / 2.0 - 30.0;
    let [top, bottom] = [high.x, low.x].map(|x| sheet.x(x));
    svg.rect("metal", left, top, thickness, bottom - top);
    for insert in part.inserts() {
        let class = if insert.density > 0.0 { "slug" } else { "pin" };
        let upper = sheet.x(insert.centre.x + insert.radius);
        let (from, length) = (left + insert.from * sheet.scale, (insert.to - insert.from) * sheet.scale);
        svg.rect(class, from, upper, length, 2.0 * insert.radius * sheet.scale);
    }
    svg.line("axis-line", (left - 30.0, sheet.centre.1), (left + thickness + 30.0, sheet.centre.1));
    let label = "crank axis";
    svg.text("muted small", (left + thickness + 10.0, sheet.centre.1 - 6.0), Anchor::Start, label);
    horizontal(svg, top - 28.0, [left, left + thickness], [top; 2], &millimetres(part.thickness()));
    let words = "free end";
    let place = (left - 12.0 - text_width(words, 11.5), bottom + 22.0);
    svg.text("muted small", place, Anchor::Start, words);
    svg.text("muted small", (left + thickness + 12.0, bottom + 22.0), Anchor::Start, "flywheel");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn family() -> CounterweightPart {
        let shape = CounterweightShape {
            web_radius: 0.045,
            rectangle_height: 0.012,
            shoulder_height: 0.008,
            arc_radius: 0.078,
            arc_angle: 1.9,
        };
        let outline = Outline::from(shape.outline());
        CounterweightPart {
            form: CounterweightForm::Family(shape),
            part: Part::new(outline, 0.018, 7850.0).expect("a plate of steel"),
            web: Some(0),
            z: 0.0,
            angle: 0.0,
            wanted: None,
        }
    }

    fn drawn(part: &CounterweightPart) -> String {
        let properties = part.part.mass_properties();
        let drawn = DrawnCounterweight {
            name: "web 1",
            part,
            properties: &properties,
            web: None,
            crankcase: Some(0.095),
        };
        counterweight_drawing(&drawn).svg()
    }

    #[test]
    fn every_dimension_of_the_family_stands_on_the_drawing() {
        let svg = drawn(&family());
        for label in ["R 78", "r 45", "h 12", "H 8", "α 108.9°", ">18<", "sweeps "] {
            assert!(svg.contains(label), "{label} is missing");
        }
        assert!(!svg.contains("NaN"));
    }

    #[test]
    fn slugs_and_own_outlines_are_drawn() {
        let mut part = family();
        part.form = CounterweightForm::Counterweight;
        let slug =
            Insert { centre: Point::new(0.03, 0.025), radius: 0.008, from: 0.0, to: 0.01, density: 18_000.0 };
        part.part = part.part.with_insert(slug).expect("it is within the material");
        let hole = Insert { centre: Point::new(0.03, -0.02), from: 0.0, to: 0.018, density: 0.0, ..slug };
        part.part = part.part.with_insert(hole).expect("it is beside the slug");
        let svg = drawn(&part);
        assert!(svg.contains("class=\"slug\""));
        let material = format!("⌀ 16, 10 deep from the free end, {} kg/m³", number::trimmed(18_000.0, 5));
        for label in [material.as_str(), "⌀ 16, through"] {
            assert!(svg.contains(label), "{label} is missing");
        }
    }
}
