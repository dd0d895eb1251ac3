//! Sizes that are possible, but more likely a slip of a unit.

use super::drafts::Drafts;
use super::reader::Reader;
use crate::document::{Field, Span};
use lanchester_diagnostic::Mistake;
use lanchester_model::EngineParts;
use lanchester_units::Dimension;

/// The longest rods and strokes built are about 4 m (two-stroke ship engines), the shortest some millimetres.
const LENGTHS: [f64; 2] = [2e-3, 10.0];
const STROKES: [f64; 2] = [1e-3, 5.0];
const LARGEST_PISTON_MASS: f64 = 1000.0;
const LARGEST_ROD_MASS: f64 = 5000.0;
/// 60 000 rpm: beyond the smallest model engines.
const FASTEST: f64 = 60_000.0 * std::f64::consts::PI / 30.0;
/// Strokes of built engines are a third of the bore to four times it.
const BORE_OVER_STROKE: [f64; 2] = [0.2, 5.0];
/// Longest rod over crank radius of built engines is about 8.
const LARGEST_ROD_OVER_RADIUS: f64 = 25.0;
/// Diametral clearance over the diameter of plain bearings is about 1e-3; far beyond this a film is refused.
const CLEARANCE_OVER_DIAMETER: [f64; 2] = [2e-4, 5e-3];
/// From hot oil thinned by fuel to the thickest with which an engine is cranked in the cold [Pa s].
const VISCOSITIES: [f64; 2] = [5e-4, 9.5];

/// Shares of critical damping above which no crankshaft is.
const DAMPING: [(&str, f64); 2] = [("loss_factor", 0.3), ("damping_ratio", 0.15)];

/// The most that an oil supply and journals have, and what is usual.
const OIL: [(&str, f64, Dimension, &str); 3] = [
    ("temperature", 473.15, Dimension::Temperature, "hot engine oil has 80 to 150 degC"),
    ("supply_pressure", 30e5, Dimension::Pressure, "oil is supplied at 2 to 6 bar"),
    ("roughness", 10e-6, Dimension::Length, "journal and shell together have 0.2 to 2 um"),
];

impl<'a> Reader<'a> {
    pub(super) fn check_sizes(&mut self, drafts: &Drafts<'a>) {
        for throw in drafts.throws.iter().flatten() {
            let stroke = 2.0 * throw.throw.radius;
            if !(STROKES[0]..=STROKES[1]).contains(&stroke) {
                self.doubt(throw.radius_span.clone(), "a stroke", stroke, Dimension::Length, "mm");
            }
        }
        for draft in drafts.cylinders.iter().flatten() {
            let cylinder = &draft.cylinder;
            let length = cylinder.rod.length;
            let stroke = drafts.throws[cylinder.throw].as_ref().map(|throw| 2.0 * throw.throw.radius);
            if !(LENGTHS[0]..=LENGTHS[1]).contains(&length) {
                self.doubt(draft.length_span.clone(), "a rod length", length, Dimension::Length, "mm");
            } else if let Some(stroke) = stroke
                && length > LARGEST_ROD_OVER_RADIUS * stroke / 2.0
                && (STROKES[0]..=STROKES[1]).contains(&stroke)
            {
                let ratio = (2.0 * length / stroke).round();
                let message = format!("the rod is {ratio} times as long as the crank radius");
                self.mistakes.push(
                    Mistake::warning("W0801", draft.length_span.clone(), message)
                        .label("suspicious size")
                        .hint("check the units of the rod length and of the stroke"),
                );
            }
            if cylinder.piston_mass > LARGEST_PISTON_MASS {
                let span = draft.piston_mass_span.clone();
                self.doubt(span, "a piston mass", cylinder.piston_mass, Dimension::Mass, "g");
            }
            if cylinder.rod.mass() > LARGEST_ROD_MASS {
                self.doubt(
                    draft.length_span.clone(),
                    "a rod mass",
                    cylinder.rod.mass(),
                    Dimension::Mass,
                    "g",
                );
            }
            if let (Some(bore), Some(stroke), Some(span)) = (cylinder.bore, stroke, &draft.bore_span)
                && !(BORE_OVER_STROKE[0]..=BORE_OVER_STROKE[1]).contains(&(bore / stroke))
            {
                let [bore, stroke] =
                    [bore, stroke].map(|value| lanchester_units::readable(value, Dimension::Length));
                let message = format!("a bore of {bore} goes ill with a stroke of {stroke}");
                self.mistakes.push(
                    Mistake::warning("W0801", span.clone(), message)
                        .label("suspicious size")
                        .hint("check the units of both: bores and strokes are mostly given in mm"),
                );
            }
        }
        if let Field::Given(speeds) = self.root.numbers("speed") {
            for speed in speeds.value.iter().filter(|speed| speed.value > FASTEST) {
                self.doubt(speed.span.clone(), "a speed", speed.value, Dimension::Speed, "rpm");
            }
        }
    }

    /// Damping of the crankshaft's material.
    pub(super) fn check_damping(&mut self) {
        let (Some(crank), _) = self.section("crank") else { return };
        let Field::Given(material) = crank.table("material") else { return };
        for (key, most) in DAMPING {
            let Field::Given(own) = material.value.number(key) else { continue };
            if own.value > most {
                let message = format!("no crankshaft has a {} of {}", key.replace('_', " "), own.value);
                self.mistakes
                    .push(Mistake::warning("W0801", own.span, message).label("suspicious number").hint(
                    "crankshafts of steel have a damping ratio of 0.005 to 0.02, twice that as loss factor",
                ));
            }
        }
    }

    /// Clearances and oil of the bearings.
    pub(super) fn check_films(&mut self, parts: &EngineParts) {
        let (Some(section), Some(design)) = (self.section("bearings").0, &parts.bearing_design) else {
            return;
        };
        if let (Field::Given(film), Some(viscosity)) = (section.table("film"), design.oil.viscosity)
            && !(VISCOSITIES[0]..=VISCOSITIES[1]).contains(&viscosity)
        {
            let given = if film.value.has("viscosity") { "viscosity" } else { "kinematic_viscosity" };
            let shown = lanchester_units::readable(viscosity, Dimension::Viscosity);
            let message = format!("no oil of a bearing has a viscosity of {shown}");
            self.mistakes.push(
                Mistake::warning("W1301", film.value.value_span(given), message)
                    .label("suspicious viscosity")
                    .hint("hot engine oil has 3 to 50 mPa s: check the number and its unit"),
            );
        }
        for (key, most, dimension, usual) in OIL {
            let Field::Given(film) = section.table("film") else { break };
            let Field::Given(own) = film.value.number(key) else { continue };
            if own.value > most {
                let shown = match dimension {
                    Dimension::Temperature => format!("{:.0} degC", own.value - 273.15),
                    dimension => lanchester_units::readable(own.value, dimension),
                };
                let name = key.replace('_', " ");
                self.mistakes.push(
                    Mistake::warning(
                        "W1301",
                        own.span,
                        format!("no bearing of an engine has a {name} of {shown}"),
                    )
                    .label("suspicious number")
                    .hint(format!("{usual}: check the number and its unit")),
                );
            }
        }
        let sizes = parts.bearings.as_ref();
        let body = parts.crank_body.as_ref();
        for (key, given, by_body) in [
            ("main", sizes.and_then(|all| all.main), body.map(|body| body.journal_diameter)),
            ("crankpin", sizes.and_then(|all| all.crankpin), body.map(|body| body.pin_diameter)),
        ] {
            let (Some(diameter), Field::Given(table)) =
                (by_body.or(given.and_then(|bearing| bearing.diameter)), section.table(key))
            else {
                continue;
            };
            let each = table.value.tables("each").given().unwrap_or(&[]);
            let rooms = if key == "main" { rooms_of_mains(parts) } else { rooms_of_pins(parts) };
            let room = rooms.iter().copied().reduce(f64::max);
            for own in std::iter::once(table.value).chain(each) {
                // The first and the last main bearing stand beside one web alone.
                let is_at_end = key == "main"
                    && matches!(own.whole("number"), Field::Given(number) if number.value <= 1 || number.value as usize >= rooms.len() + 2);
                if let (Field::Given(width), Some(room)) = (own.number("width"), room)
                    && width.value > room * (1.0 + 1e-9)
                    && !is_at_end
                {
                    let [width_text, room] =
                        [width.value, room].map(|value| lanchester_units::readable(value, Dimension::Length));
                    let message = format!("a width of {width_text} is more than the {room} between webs");
                    self.mistakes.push(
                        Mistake::warning("W1301", width.span, message)
                            .label("suspicious size")
                            .hint("a bearing ends before the fillets of the webs beside it: check the number and its unit"),
                    );
                }
                let Field::Given(clearance) = own.number("diametral_clearance") else { continue };
                let ratio = clearance.value / diameter;
                if (CLEARANCE_OVER_DIAMETER[0]..=CLEARANCE_OVER_DIAMETER[1]).contains(&ratio) {
                    continue;
                }
                let [clearance_text, diameter] = [clearance.value, diameter]
                    .map(|value| lanchester_units::readable(value, Dimension::Length));
                let message = format!(
                    "a diametral clearance of {clearance_text} goes ill with a diameter of {diameter}"
                );
                self.mistakes.push(
                    Mistake::warning("W1301", clearance.span, message)
                        .label("suspicious size")
                        .hint("it is the difference of the diameters of shell and journal, about a thousandth of them: check the number and its unit"),
                );
            }
        }
    }

    fn doubt(&mut self, span: Span, what: &str, value: f64, dimension: Dimension, unit: &str) {
        let shown = lanchester_units::readable(value, dimension);
        self.mistakes.push(
            Mistake::warning("W0801", span, format!("{what} of {shown} is hard to believe"))
                .label("suspicious size")
                .hint(format!("check the number and its unit: is it meant in {unit}?")),
        );
    }
}

/// Rooms between the webs beside the inner main bearings [m]; none where the webs are not known.
fn rooms_of_mains(parts: &EngineParts) -> Vec<f64> {
    let mut webs: Vec<(usize, [f64; 2])> =
        parts.throws.iter().filter_map(|throw| Some((throw.crankshaft, throw.webs?))).collect();
    webs.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    let pairs = webs.windows(2).filter(|pair| pair[0].0 == pair[1].0);
    rooms(parts, pairs.map(|pair| pair[1].1[0] - pair[0].1[1]))
}

/// Rooms between the webs of the throws [m]; none where they are not known.
fn rooms_of_pins(parts: &EngineParts) -> Vec<f64> {
    rooms(parts, parts.throws.iter().filter_map(|throw| throw.webs.map(|[front, rear]| rear - front)))
}

/// What distances of the middles of two webs leave between these [m], were both as thin as the thinnest; two throws that share a web have no room.
fn rooms(parts: &EngineParts, distances: impl Iterator<Item = f64>) -> Vec<f64> {
    let Some(body) = &parts.crank_body else { return Vec::new() };
    let own = parts.crank_details.iter().flat_map(|details| &details.webs).filter_map(|web| web.thickness);
    let thinnest = own.fold(body.web_thickness, f64::min);
    distances.map(|distance| distance - thinnest).filter(|room| *room > 0.0).collect()
}
