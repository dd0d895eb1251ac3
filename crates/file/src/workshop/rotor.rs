//! Rotor, correction planes and sensors of a sheet.

use crate::document::{Field, Section, Spot};
use crate::read::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::angle;
use lanchester_task::DRILL_POINT;
use lanchester_task::workshop::{
    Action, Allowed, Detector, Drill, DrillDirection, PhaseConvention, Plane, Rotor, Sense, Sensor, Surface,
    Vibration, VibrationQuantity,
};
use lanchester_units::Dimension;
use std::f64::consts::{PI, TAU};

const MOST_HOLES: i64 = 3;
/// Step of tried angles where a whole range may be drilled [deg].
const ANGLE_STEP: f64 = 5.0;

impl<'a> Reader<'a> {
    pub(super) fn rotor(&mut self) -> Option<Rotor> {
        let (section, broken) = self.section("rotor");
        let Some(section) = section else { return (!broken).then(Rotor::default) };
        let [mass, centre, speed] = ["mass", "centre", "speed"].map(|key| section.number(key));
        let [transverse_inertia, polar_inertia] =
            ["transverse_inertia", "polar_inertia"].map(|key| section.number(key));
        let supports = self.supports(section);
        let grade = self.grade(section);
        let [marks, rotation] = ["marks", "rotation"].map(|key| section.word(key));
        let phase = section.word("phase");
        let keyphasor = section.number("keyphasor").or(0.0);
        let bad =
            [&mass, &centre, &speed, &transverse_inertia, &polar_inertia].iter().any(|field| field.is_bad())
                || [&marks, &rotation, &phase].iter().any(|field| field.is_bad());
        let sense = |field: Field<&'static str>| {
            field
                .given()
                .map(|word| if word == "clockwise" { Sense::Clockwise } else { Sense::Anticlockwise })
        };
        let (supports, grade, keyphasor) = (supports?, grade?, keyphasor?);
        (!bad).then(|| Rotor {
            mass: mass.given(),
            centre: centre.given(),
            transverse_inertia: transverse_inertia.given(),
            polar_inertia: polar_inertia.given(),
            supports,
            speed: speed.given(),
            grade,
            marks: sense(marks),
            rotation: sense(rotation),
            phase: phase
                .given()
                .map(|word| if word == "lag" { PhaseConvention::Lag } else { PhaseConvention::Lead }),
            keyphasor,
        })
    }

    /// `None` if they are bad.
    fn supports(&mut self, section: &'a Section) -> Option<Option<[f64; 2]>> {
        let places = match section.numbers("supports") {
            Field::Absent => return Some(None),
            Field::Bad => return None,
            Field::Given(spot) => spot.value,
        };
        let span = section.value_span("supports");
        match places.as_slice() {
            [first, second] if first.value < second.value => Some(Some([first.value, second.value])),
            [first, second] => {
                let [one, two] =
                    [first, second].map(|at| lanchester_units::readable(at.value, Dimension::Length));
                let message = format!("the supports stand at {one} and {two}");
                let hint = "write the one with the lower z first; they must not stand in one place";
                self.mistakes.push(Mistake::error("E1102", span, message).hint(hint));
                None
            }
            other => {
                let message = format!("`supports` needs two places, got {}", other.len());
                self.mistakes.push(Mistake::error("E0206", span, message).hint(section.example("supports")));
                None
            }
        }
    }

    /// Millimetres a second to SI; `None` if it is bad.
    fn grade(&mut self, section: &'a Section) -> Option<Option<f64>> {
        let text = match section.text("grade") {
            Field::Absent => return Some(None),
            Field::Bad => return None,
            Field::Given(spot) => spot,
        };
        let number = text.value.trim().trim_start_matches(['G', 'g']).trim().parse::<f64>();
        match number {
            Ok(grade) if grade.is_finite() && (1e-3..=1e6).contains(&grade) => Some(Some(grade * 1e-3)),
            _ => {
                let message = format!("`grade` needs a balance quality grade, got \"{}\"", text.value);
                let hint = "write G and a number with a decimal point, such as \"G 6.3\" or \"G 2.5\"";
                self.mistakes.push(Mistake::error("E0108", text.span, message).hint(hint));
                None
            }
        }
    }

    pub(super) fn planes(&mut self) -> Option<Vec<Plane>> {
        let sections = self.root.tables("plane").or(&[])?;
        let planes: Vec<Option<Plane>> = sections.iter().map(|section| self.plane(section)).collect();
        let names: Vec<Option<String>> =
            sections.iter().map(|section| section.text("name").given()).collect();
        self.check_names(sections, &names, "plane");
        planes.into_iter().collect()
    }

    fn plane(&mut self, section: &'a Section) -> Option<Plane> {
        let name = self.required(section, "name", section.text("name"));
        let [z, radius] = ["z", "radius"].map(|key| section.number(key));
        let allowed = self.allowed(section);
        let drill = match section.table("drill") {
            Field::Absent => Some(None),
            Field::Bad => None,
            Field::Given(drill) => self.drill(drill.value).map(Some),
        };
        let default = if section.has("drill") { "remove" } else { "add" };
        let action = section.word("action").or(default);
        if action == Some("add") && section.has("drill") {
            self.without_effect(
                section,
                "drill",
                "weight is added in this plane",
                "drilling removes: write action = \"remove\", or leave `drill` out",
            );
        }
        if z.is_bad() || radius.is_bad() {
            return None;
        }
        if section.has("drill") && !section.has("radius") {
            self.missing(
                section.span.clone(),
                "a plane that is drilled needs the radius of its surface or of its circle of holes".into(),
                section.example("radius"),
            );
        }
        Some(Plane {
            name: name?,
            z: z.given(),
            radius: radius.given(),
            allowed: allowed?,
            action: if action? == "remove" { Action::Remove } else { Action::Add },
            drill: drill?,
        })
    }

    fn allowed(&mut self, section: &'a Section) -> Option<Allowed> {
        let angles = section.numbers("angles");
        let positions = section.whole("positions");
        let sectors = section.tables("sectors");
        if section.has("angles") && section.has("positions") {
            self.two_sources(section, "angles", "positions", "the angles that may be used");
            return None;
        }
        if angles.is_bad() || positions.is_bad() || sectors.is_bad() {
            return None;
        }
        if !["angles", "positions", "sectors"].iter().any(|key| section.has(key)) {
            return Some(Allowed::Any);
        }
        let mut singles: Vec<f64> =
            angles.given().unwrap_or_default().iter().map(|spot| angle::direction(spot.value)).collect();
        if let Some(count) = positions.given() {
            singles.extend((0..count).map(|k| angle::direction(TAU * k as f64 / count as f64)));
        }
        singles.sort_by(f64::total_cmp);
        singles.dedup();
        let mut ranges = Vec::new();
        for sector in sectors.given().unwrap_or_default() {
            let [from, to] = ["from", "to"].map(|key| self.required(sector, key, sector.number(key)));
            ranges.push([from?, to?].map(angle::direction));
        }
        if singles.is_empty() && ranges.is_empty() {
            let message = "no angle of the plane may be used";
            self.mistakes.push(
                Mistake::error("E0206", section.span.clone(), message)
                    .hint("name at least one angle or sector, or leave them out if every angle may be used"),
            );
            return None;
        }
        Some(Allowed::Some { angles: singles, sectors: ranges })
    }

    fn drill(&mut self, section: &'a Section) -> Option<Drill> {
        let direction = self.required(section, "direction", section.word("direction"));
        let surface = section.word("surface").or("round");
        let diameters = self.required(section, "diameters", section.numbers("diameters"));
        let max_depth = self.required(section, "max_depth", section.number("max_depth"));
        let density = self.required(section, "density", section.number("density"));
        let depth_step = section.number("depth_step");
        let point = section.number("point").or(DRILL_POINT.to_radians());
        let land = section.number("land").or(0.0);
        let spacing = section.number("spacing").or(0.0);
        let width = section.number("width");
        let most_holes = section.whole("most_holes").or(MOST_HOLES);
        let angle_step = section.number("angle_step").or(ANGLE_STEP.to_radians());
        if direction == Some("axial") && section.has("surface") {
            self.without_effect(section, "surface", "an axial hole begins on a flat face", "leave it out");
        }
        if let Some(point) = point.filter(|point| *point > PI * (1.0 + 1e-12)) {
            let got = lanchester_units::readable(point, Dimension::Angle);
            let message = format!("the angle of a drill point is at most 180 deg, got {got}");
            self.mistakes.push(Mistake::error("E0108", section.value_span("point"), message).hint(
                "it is the full angle of the cone: 118 deg for a common drill, 180 deg for a flat bottom",
            ));
        }
        if depth_step.is_bad() || width.is_bad() {
            return None;
        }
        let (diameters, max_depth, point, land) = (diameters?, max_depth?, point?, land?);
        if diameters.is_empty() {
            let message = "`diameters` is empty";
            let span = section.value_span("diameters");
            self.mistakes.push(Mistake::error("E0206", span, message).hint(section.example("diameters")));
            return None;
        }
        for diameter in &diameters {
            let tip = diameter.value / 2.0 / (point / 2.0).tan();
            if tip > max_depth {
                let [size, tip, most] = [diameter.value, tip, max_depth]
                    .map(|length| lanchester_units::readable(length, Dimension::Length));
                let message = format!(
                    "the point of the {size} drill alone is {tip} long, and its tip may reach {most}"
                );
                self.mistakes.push(
                    Mistake::error("E1103", diameter.span.clone(), message)
                        .hint("leave this drill out, or give it a flatter point or more depth"),
                );
            }
        }
        if let Some(width) = width.given() {
            self.check_edges(&diameters, land, width);
        }
        Some(Drill {
            direction: if direction? == "radial" { DrillDirection::Radial } else { DrillDirection::Axial },
            surface: if surface? == "round" { Surface::Round } else { Surface::Flat },
            diameters: diameters.iter().map(|spot| spot.value).collect(),
            max_depth,
            depth_step: depth_step.given(),
            point: point.min(PI),
            density: density?,
            land,
            spacing: spacing?,
            most_holes: usize::try_from(most_holes?).unwrap_or(1),
            angle_step: angle_step?,
        })
    }

    /// Every drill must leave its land at both edges of a surface of this width [m].
    fn check_edges(&mut self, diameters: &[Spot<f64>], land: f64, width: f64) {
        for diameter in diameters.iter().filter(|diameter| diameter.value + 2.0 * land > width * (1.0 + 1e-9))
        {
            let [size, land, width] = [diameter.value, land, width]
                .map(|length| lanchester_units::readable(length, Dimension::Length));
            let message = format!(
                "the {size} drill leaves less than the land of {land} at the edges of a surface {width} wide"
            );
            self.mistakes.push(
                Mistake::error("E1107", diameter.span.clone(), message)
                    .hint("leave this drill out, or state a smaller land"),
            );
        }
    }

    pub(super) fn sensors(&mut self) -> Option<Vec<Sensor>> {
        let sections = self.root.tables("sensor").or(&[])?;
        let sensors: Vec<Option<Sensor>> = sections.iter().map(|section| self.sensor(section)).collect();
        let names: Vec<Option<String>> =
            sections.iter().map(|section| section.text("name").given()).collect();
        self.check_names(sections, &names, "sensor");
        sensors.into_iter().collect()
    }

    fn sensor(&mut self, section: &'a Section) -> Option<Sensor> {
        let name = self.required(section, "name", section.text("name"));
        let angle = section.number("angle").or(0.0);
        let detector = self.required(section, "detector", section.word("detector"));
        let limit = match section.table("limit") {
            Field::Absent => Some(None),
            Field::Bad => None,
            Field::Given(limit) => self.vibration(limit.value).map(Some),
        };
        Some(Sensor {
            name: name?,
            angle: angle?,
            detector: match detector? {
                "peak" => Detector::Peak,
                "peak-to-peak" => Detector::PeakToPeak,
                _ => Detector::Rms,
            },
            limit: limit?,
        })
    }

    /// Exactly one of displacement, velocity and acceleration.
    pub(super) fn vibration(&mut self, section: &'a Section) -> Option<Vibration> {
        const KEYS: [(&str, VibrationQuantity); 3] = [
            ("displacement", VibrationQuantity::Displacement),
            ("velocity", VibrationQuantity::Velocity),
            ("acceleration", VibrationQuantity::Acceleration),
        ];
        let given: Vec<&str> = KEYS.iter().map(|(key, _)| *key).filter(|key| section.has(key)).collect();
        if let [first, second, ..] = given.as_slice() {
            self.two_sources(section, first, second, "the amplitude");
            return None;
        }
        if given.is_empty() {
            self.missing(
                section.span.clone(),
                "the amplitude is missing".into(),
                "add displacement = \"12 um\", velocity = \"4.2 mm/s\" or acceleration = \"1.5 m/s2\"".into(),
            );
            return None;
        }
        KEYS.into_iter().find_map(|(key, quantity)| {
            section.number(key).given().map(|amplitude| Vibration { quantity, amplitude })
        })
    }
}
