//! `[counterweight.shape]`: a counterweight as a part.

use super::Reader;
use super::crank::body::MaybeBody;
use crate::document::{Field, Section, Span};
use lanchester_diagnostic::Mistake;
use lanchester_model::{CounterweightForm, CrankBody};
use lanchester_shape::{
    Chamfer, Contour, Corner, CounterweightShape, Cut, Face, GeometryError, Insert, Outline, Part, Point,
};
use lanchester_task::STEEPEST;
use lanchester_units::Dimension;

const FAMILY: [&str; 6] =
    ["web_radius", "rectangle_height", "shoulder_height", "shoulder_angle", "arc_radius", "arc_angle"];

/// Corners of all outlines of a file, those of parts with chamfers once more for each chamfer: above this reading takes too long.
const MOST_CORNERS: usize = 10_000;

/// A turned chamfer that begins nearer to the crank axis than this share of the swept radius is no chamfer of the edge.
const NEAREST_CHAMFER: f64 = 0.02;

/// The part before its place is known.
#[derive(Debug)]
pub(super) struct DraftPart {
    pub(super) form: CounterweightForm,
    pub(super) part: Part,
    /// The unbalance that it should have.
    pub(super) wanted: Option<f64>,
    /// Its table.
    pub(super) span: Span,
    /// Where the wanted unbalance stands.
    pub(super) wanted_span: Span,
}

impl<'a> Reader<'a> {
    /// Whether all outlines of the file together have no more corners than can be checked.
    pub(super) fn has_few_corners(&mut self, weights: &'a [Section]) -> bool {
        let count = |section: &Section, key: &str| section.tables(key).given().map_or(0, <[Section]>::len);
        let mut sum = 0;
        for shape in weights.iter().filter_map(|weight| weight.table("shape").given()) {
            let openings = shape.tables("openings").given().unwrap_or_default();
            let corners: usize =
                count(shape, "outline") + openings.iter().map(|o| count(o, "corners")).sum::<usize>();
            sum += corners * (1 + count(shape, "chamfers"));
            if sum > MOST_CORNERS {
                let message =
                    format!("the outlines of the file have more than {MOST_CORNERS} corners to work on");
                self.mistakes.push(Mistake::error("E0004", shape.span.clone(), message).hint(
                    "arcs need fewer corners than short lines; every chamfer counts the corners once more",
                ));
                return false;
            }
        }
        true
    }

    /// The part of a weight; `weight` is the table of the weight.
    pub(super) fn part_draft(
        &mut self,
        weight: &'a Section,
        shape: &'a Section,
        body: &MaybeBody,
    ) -> Option<DraftPart> {
        let wanted = self.wanted_unbalance(weight);
        let known_body = body.as_ref().and_then(Option::as_ref);
        let thickness = self.required(shape, "thickness", shape.number("thickness"));
        let density = match self.density(shape) {
            Some(None) if known_body.is_some() => Some(known_body.map_or(0.0, |body| body.density)),
            Some(None) if body.is_some() => {
                self.missing(
                    shape.span.clone(),
                    "the density of the part is missing".into(),
                    format!("{}, or in [crank.body]", shape.example("density")),
                );
                None
            }
            density => density.flatten(),
        };
        let outline = if shape.has("outline") {
            self.own_outline(weight, shape, body)
        } else {
            self.family(shape, body)
        };
        let inserts = self.inserts(shape, thickness);
        let chamfers = self.chamfers(shape);
        let (form, outline) = outline?;
        let (thickness, density) = (thickness?, density?);
        let mut part = match Part::new(outline, thickness, density) {
            Ok(part) => part,
            Err(error) => {
                self.impossible_shape(shape.value_span("thickness"), &error);
                return None;
            }
        };
        let mut is_good = true;
        for (chamfer, section) in chamfers? {
            if let Cut::Turned { radius } = chamfer.cut
                && radius < NEAREST_CHAMFER * part.outline().swept_radius()
            {
                let message = "a turned chamfer begins next to the crank axis, far within the part";
                self.mistakes.push(
                    Mistake::error("E0901", section.value_span("radius"), message)
                        .hint("radius is where it leaves the face, close to the edge of the part"),
                );
                is_good = false;
                continue;
            }
            match part.clone().with_chamfer(chamfer) {
                Ok(cut) => part = cut,
                Err(error) => {
                    // The bounds of the keys leave one number that may be impossible.
                    match error {
                        GeometryError::Number { .. } => self.impossible_number(section, "angle", &error),
                        _ => self.impossible_shape(section.span.clone(), &error),
                    }
                    is_good = false;
                }
            }
        }
        for (insert, span) in inserts? {
            match part.clone().with_insert(insert) {
                Ok(bored) => part = bored,
                Err(error) => {
                    self.impossible_shape(span, &error);
                    is_good = false;
                }
            }
        }
        if let (CounterweightForm::Family(family), Some(body)) = (form, known_body)
            && weight.has("web")
        {
            is_good &= self.check_web_material(shape, &part, family.web_radius, body);
        }
        let wanted_span = weight.value_span("unbalance");
        is_good.then_some(DraftPart { form, part, wanted: wanted?, span: shape.span.clone(), wanted_span })
    }

    /// The unbalance that a weight with a shape should have; the outer `None` says bad, the inner one absent.
    pub(super) fn wanted_unbalance(&mut self, weight: &Section) -> Option<Option<f64>> {
        for key in ["mass", "radius"].into_iter().filter(|key| weight.has(key)) {
            self.two_sources(weight, "shape", key, "the unbalance of the weight");
        }
        match weight.number("unbalance") {
            Field::Given(spot) => Some(Some(spot.value)),
            Field::Absent => Some(None),
            Field::Bad => None,
        }
    }

    /// The web's disc is of the web's density: nothing of the part may cut into it if its own is another.
    fn check_web_material(&mut self, shape: &Section, part: &Part, disc: f64, body: &CrankBody) -> bool {
        if part.density() == body.density {
            return true;
        }
        let insert = part.inserts().iter().any(|insert| insert.centre.norm() - insert.radius < disc);
        let chamfer = part.chamfers().iter().any(|chamfer| match chamfer.cut {
            Cut::Turned { radius } => radius < disc,
            Cut::Milled { distance, .. } => distance < disc,
        });
        for (key, _) in [("inserts", insert), ("chamfers", chamfer)].into_iter().filter(|(_, reach)| *reach) {
            let message =
                format!("`{key}` reach into the web's disc, which is of another density than the part");
            self.mistakes.push(
                Mistake::error("E0901", shape.key_span(key), message)
                    .hint("keep them outside the disc, or give the outline of the whole web"),
            );
        }
        !insert && !chamfer
    }

    /// A shape of the family.
    fn family(&mut self, shape: &'a Section, body: &MaybeBody) -> Option<(CounterweightForm, Outline)> {
        for key in ["encloses", "openings"] {
            if shape.has(key) && self.whole {
                let why = "it goes with an outline of its own";
                self.without_effect(shape, key, why, "leave it out, or give `outline`");
            }
        }
        if !FAMILY.iter().any(|key| shape.has(key)) {
            self.missing(
                shape.span.clone(),
                "the outline of the part is missing".into(),
                "add rectangle_height, shoulder_height, arc_radius and arc_angle, or an outline of its own"
                    .into(),
            );
            return None;
        }
        let web_radius = match shape.number("web_radius") {
            Field::Given(spot) => Some(spot.value),
            Field::Bad => None,
            Field::Absent => match body {
                Some(Some(body)) => Some(body.web_radius),
                Some(None) => {
                    self.missing(
                        shape.span.clone(),
                        "the radius of the web's disc is missing".into(),
                        format!("{}, or in [crank.body]", shape.example("web_radius")),
                    );
                    None
                }
                None => None,
            },
        };
        let [rectangle_height, arc_radius, arc_angle] = ["rectangle_height", "arc_radius", "arc_angle"]
            .map(|key| self.required(shape, key, shape.number(key)));
        let (height, angle) = (shape.number("shoulder_height"), shape.number("shoulder_angle"));
        let flank = match (height, angle) {
            (Field::Absent, Field::Absent) => {
                self.missing(
                    shape.span.clone(),
                    "the flank of the part is missing".into(),
                    "add shoulder_height = \"12 mm\", or shoulder_angle".into(),
                );
                None
            }
            (Field::Given(height), Field::Absent) => Some((height.value, false)),
            (Field::Absent, Field::Given(angle)) => Some((angle.value, true)),
            (Field::Absent, _) | (_, Field::Absent) => None,
            _ => {
                self.two_sources(shape, "shoulder_height", "shoulder_angle", "the flank of the part");
                None
            }
        };
        let (flank, is_angle) = flank?;
        let mut family = CounterweightShape {
            web_radius: web_radius?,
            rectangle_height: rectangle_height?,
            shoulder_height: if is_angle { 0.0 } else { flank },
            arc_radius: arc_radius?,
            arc_angle: arc_angle?,
        };
        // Of the other dimensions the reader has checked all that is asked here.
        if let Err(error) = family.checked() {
            self.impossible_number(shape, "arc_angle", &error);
            return None;
        }
        if is_angle {
            family.shoulder_height = self.height_of(shape, &family, flank)?;
        }
        let outline = family.outline();
        if !outline.edges().iter().all(|edge| edge.from.is_finite() && edge.bulge.is_finite()) {
            let message = "the outline of the part cannot be worked out: its dimensions differ too much";
            self.mistakes.push(Mistake::error("E0901", shape.span.clone(), message).hint("check the units"));
            return None;
        }
        Some((CounterweightForm::Family(family), outline.into()))
    }

    /// Height of the trapezoid whose flank stands at `angle` against the chord.
    fn height_of(&mut self, shape: &'a Section, family: &CounterweightShape, angle: f64) -> Option<f64> {
        let span = shape.value_span("shoulder_angle");
        if angle > STEEPEST {
            let got = lanchester_units::readable(angle, Dimension::Angle);
            self.mistakes.push(
                Mistake::error("E0108", span, format!("`shoulder_angle` must be at most 89 deg, got {got}"))
                    .label("out of range")
                    .hint("for steeper shoulders give their height instead"),
            );
            return None;
        }
        if family.shoulder() < 0.0 {
            let [chord, disc] = [family.half_width(), family.web_radius]
                .map(|value| lanchester_units::readable(2.0 * value, Dimension::Length));
            let message = format!(
                "the chord of the arc, {chord}, is shorter than the rectangle is wide, {disc}: no flank stands out"
            );
            self.mistakes.push(
                Mistake::error("E0901", span, message)
                    .hint("give shoulder_height instead, or a larger arc_radius or arc_angle"),
            );
            return None;
        }
        Some(family.shoulder() * angle.tan())
    }

    /// An outline of its own.
    fn own_outline(
        &mut self,
        weight: &'a Section,
        shape: &'a Section,
        body: &MaybeBody,
    ) -> Option<(CounterweightForm, Outline)> {
        for key in FAMILY.into_iter().filter(|key| shape.has(key)) {
            self.two_sources(shape, "outline", key, "the outline of the part");
        }
        let form = match shape.word("encloses").or("counterweight") {
            Some("web") => {
                let place = shape.value_span("encloses");
                if !weight.has("web") {
                    self.missing(
                        place.clone(),
                        "an outline of the whole web needs the number of the web".into(),
                        "add web = 1 to the [[counterweight]], instead of throw or z".into(),
                    );
                }
                if *body == Some(None) {
                    self.missing(
                        place,
                        "an outline of the whole web needs [crank.body]".into(),
                        "add [crank.body], so that the throws and the other webs are known".into(),
                    );
                }
                Some(CounterweightForm::Web)
            }
            Some(_) => Some(CounterweightForm::Counterweight),
            None => None,
        };
        let outer = match shape.tables("outline") {
            Field::Given(corners) => self.contour(corners.value, &corners.span),
            _ => None,
        };
        let openings = shape.tables("openings").or(&[])?;
        let mut holes = Vec::new();
        for opening in openings {
            let corners = self.required(opening, "corners", opening.tables("corners"));
            let span = opening.value_span("corners");
            holes.push(corners.and_then(|corners| self.contour(corners, &span)));
        }
        let holes: Option<Vec<Contour>> = holes.into_iter().collect();
        let (outer, holes, form) = (outer?, holes?, form?);
        match Outline::new(outer, holes) {
            Ok(outline) => Some((form, outline)),
            Err(error) => {
                use lanchester_shape::ContourPlace::Hole;
                let hole = match &error {
                    GeometryError::ContoursCross { second: Hole(number), .. } => Some(*number),
                    GeometryError::HoleOutside { hole, .. } => Some(*hole),
                    _ => None,
                };
                let place = hole.and_then(|number| openings.get(number - 1));
                let span = place.map_or(shape.key_span("openings"), |opening| opening.span.clone());
                self.impossible_shape(span, &error);
                None
            }
        }
    }

    /// A contour; what is wrong with an edge is told at the corner that it leaves.
    fn contour(&mut self, corners: &'a [Section], span: &Span) -> Option<Contour> {
        let read: Vec<Option<Corner>> = corners
            .iter()
            .map(|corner| {
                let at = self.point(corner);
                let bulge = corner.number("bulge").or(0.0);
                Some(Corner { at: at?, bulge: bulge? })
            })
            .collect();
        let read: Vec<Corner> = read.into_iter().collect::<Option<_>>()?;
        if read.is_empty() {
            self.impossible_shape(span.clone(), &GeometryError::TooFewEdges { edges: 0 });
            return None;
        }
        let error = match Contour::new(&read) {
            Ok(contour) => return Some(contour),
            Err(error) => error,
        };
        let (edge, other) = match error {
            GeometryError::Crossing { first, second, .. } => (Some(second), Some(first)),
            GeometryError::ZeroLength { edge, .. } | GeometryError::NotFinite { edge } => (Some(edge), None),
            _ => (None, None),
        };
        let corner = |edge: Option<usize>| edge.and_then(|edge| corners.get(edge - 1));
        let Some(place) = corner(edge) else {
            self.impossible_shape(span.clone(), &error);
            return None;
        };
        let text = error.to_string();
        let (message, hint) = text.split_once("\nhint: ").unwrap_or((&text, ""));
        let mut mistake = Mistake::error("E0901", place.span.clone(), message)
            .label(format!("edge {} leaves this corner", edge.unwrap_or(0)))
            .hint(hint);
        if let (Some(number), Some(place)) = (other, corner(other)) {
            mistake = mistake.related(place.span.clone(), format!("edge {number} leaves this corner"));
        }
        self.mistakes.push(mistake);
        None
    }

    fn point(&mut self, section: &'a Section) -> Option<Point> {
        let [x, y] = ["x", "y"].map(|key| self.required(section, key, section.number(key)));
        Some(Point::new(x?, y?))
    }

    fn face(&mut self, section: &'a Section) -> Option<Face> {
        let word = self.required(section, "face", section.word("face"))?;
        Some(if word == "rear" { Face::Rear } else { Face::Front })
    }

    fn inserts(&mut self, shape: &'a Section, thickness: Option<f64>) -> Option<Vec<(Insert, Span)>> {
        let sections = shape.tables("inserts").or(&[])?;
        let inserts: Vec<Option<(Insert, Span)>> = sections
            .iter()
            .map(|section| {
                let centre = self.point(section);
                let radius = self.required(section, "radius", section.number("radius"));
                let density = self.density(section);
                let depth = section.number("depth");
                let ends = match depth {
                    Field::Absent => {
                        if section.has("face") && self.whole {
                            let hint = section.example("depth");
                            self.without_effect(
                                section,
                                "face",
                                "without `depth` the bore goes through",
                                &hint,
                            );
                        }
                        thickness.map(|thickness| (0.0, thickness))
                    }
                    Field::Bad => None,
                    Field::Given(depth) => {
                        self.face(section).zip(thickness).map(|(face, thickness)| match face {
                            Face::Front => (0.0, depth.value),
                            Face::Rear => (thickness - depth.value, thickness),
                        })
                    }
                };
                let (from, to) = ends?;
                let density = density?.unwrap_or(0.0);
                Some((Insert { centre: centre?, radius: radius?, from, to, density }, section.span.clone()))
            })
            .collect();
        inserts.into_iter().collect()
    }

    fn chamfers(&mut self, shape: &'a Section) -> Option<Vec<(Chamfer, &'a Section)>> {
        let sections = shape.tables("chamfers").or(&[])?;
        let chamfers: Vec<Option<(Chamfer, &'a Section)>> = sections
            .iter()
            .map(|section| {
                let face = self.face(section);
                let angle = self.required(section, "angle", section.number("angle"));
                let [radius, distance, direction] =
                    ["radius", "distance", "direction"].map(|key| section.number(key));
                let cut = if section.has("radius") {
                    if let Some(other) = ["distance", "direction"].into_iter().find(|key| section.has(key)) {
                        self.two_sources(section, "radius", other, "where the chamfer begins");
                        None
                    } else {
                        radius.given().map(|radius| Cut::Turned { radius })
                    }
                } else if !section.has("distance") && !section.has("direction") {
                    self.missing(
                        section.span.clone(),
                        "where the chamfer begins is missing".into(),
                        "add radius = \"70 mm\" (turned), or distance and direction (milled)".into(),
                    );
                    None
                } else {
                    let distance = self.required(section, "distance", distance);
                    let direction = self.required(section, "direction", direction);
                    distance.zip(direction).map(|(distance, direction)| Cut::Milled { direction, distance })
                };
                Some((Chamfer { cut: cut?, angle: angle?, face: face? }, section))
            })
            .collect();
        chamfers.into_iter().collect()
    }
}
