//! Connecting rods: lengths and masses.

use crate::document::{Field, Section, Span};
use crate::read::Reader;
use crate::read::layers::Layers;
use lanchester_diagnostic::Mistake;
use lanchester_model::{Rod, RodJoint, RodMassRule};
use lanchester_units::Dimension;

/// Largest difference between the mass of a rod and the sum of its weighed ends, over the mass.
const WEIGHING: f64 = 0.005;

/// A rod and what gives its length.
#[derive(Debug, Clone)]
pub(in crate::read) struct DraftRod {
    pub(in crate::read) rod: Rod,
    pub(in crate::read) length_span: Span,
}

const MASS_KEYS: [&str; 4] = ["mass", "big_end_mass", "small_end_mass", "centre_of_gravity"];

impl<'a> Reader<'a> {
    /// The rod from its own keys over those that hold for all.
    pub(in crate::read) fn rod(&mut self, layers: &Layers<'a>, joint: RodJoint) -> Option<DraftRod> {
        let length = match layers.number("length") {
            Field::Given(spot) => Some(spot),
            Field::Bad => None,
            Field::Absent => {
                self.missing_in(layers, "the rod length", "length = \"144 mm\"");
                None
            }
        };
        let axial_inertia = layers.number("axial_inertia").or(0.0);
        let masses = self.rod_masses(layers, length.as_ref().map(|spot| spot.value));
        let length = length?;
        let (big_end_mass, small_end_mass, mass_rule, inertia) = masses?;
        let rod = Rod {
            length: length.value,
            big_end_mass,
            small_end_mass,
            inertia,
            axial_inertia: axial_inertia?,
            mass_rule,
            joint,
        };
        Some(DraftRod { rod, length_span: length.span })
    }

    fn rod_masses(
        &mut self,
        layers: &Layers<'a>,
        length: Option<f64>,
    ) -> Option<(f64, f64, RodMassRule, Option<f64>)> {
        let Some(section) = layers.with_any(&MASS_KEYS) else {
            self.missing_in(layers, "the mass of the rod", "mass = \"0.63 kg\"");
            return None;
        };
        let masses = self.masses_of(section, length);
        // An inertia further away than the masses belongs to other masses.
        let inertia_section = layers
            .sections
            .iter()
            .copied()
            .take_while(|nearer| !std::ptr::eq(*nearer, section))
            .chain([section])
            .find(|section| section.has("inertia"));
        let inertia = inertia_section.map_or(Field::Absent, |section| section.number("inertia"));
        let (big, small, rule) = masses?;
        let inertia = match inertia {
            Field::Absent => None,
            Field::Bad => return None,
            Field::Given(spot) => {
                if rule == RodMassRule::Thirds {
                    self.mistakes.push(
                        Mistake::error(
                            "E0403",
                            spot.span,
                            "an inertia needs the rod's weighed ends or its centre of gravity",
                        )
                        .related(section.key_span("mass"), "says nothing about where the mass lies")
                        .hint("add big_end_mass and small_end_mass, or centre_of_gravity"),
                    );
                    return None;
                }
                self.check_inertia(spot.value, spot.span, (big, small), length?);
                Some(spot.value)
            }
        };
        Some((big, small, rule, inertia))
    }

    /// Big-end and small-end mass and how they are given.
    fn masses_of(&mut self, section: &'a Section, length: Option<f64>) -> Option<(f64, f64, RodMassRule)> {
        let [mass, big, small, centre] = MASS_KEYS.map(|key| section.number(key));
        if section.has("big_end_mass") || section.has("small_end_mass") {
            if let Some(end) = ["big_end_mass", "small_end_mass"].into_iter().find(|key| section.has(key))
                && section.has("centre_of_gravity")
            {
                self.two_sources(section, end, "centre_of_gravity", "where the mass of the rod lies");
                return None;
            }
            let big = self.required(section, "big_end_mass", big);
            let small = self.required(section, "small_end_mass", small);
            let (big, small) = (big?, small?);
            if let Field::Given(mass) = &mass
                && (mass.value - (big + small)).abs() > WEIGHING * mass.value
            {
                let [got, sum, big, small] = [mass.value, big + small, big, small]
                    .map(|value| lanchester_units::readable(value, Dimension::Mass));
                self.mistakes.push(
                    Mistake::error(
                        "E0401",
                        mass.span.clone(),
                        format!("the end masses {big} and {small} add up to {sum}, but the rod has {got}"),
                    )
                    .related(section.value_span("big_end_mass"), "big end")
                    .related(section.value_span("small_end_mass"), "small end")
                    .hint("weigh again, or leave mass out: the sum may differ from it by 0.5 %"),
                );
                return None;
            }
            if mass.is_bad() {
                return None;
            }
            return Some((big, small, RodMassRule::WeighedEnds));
        }
        let mass = self.required(section, "mass", mass);
        match centre {
            Field::Absent => mass.map(|mass| (mass * 2.0 / 3.0, mass / 3.0, RodMassRule::Thirds)),
            Field::Bad => None,
            Field::Given(centre) => {
                let (mass, length) = (mass?, length?);
                if centre.value > length {
                    let [at, length] = [centre.value, length]
                        .map(|value| lanchester_units::readable(value, Dimension::Length));
                    self.mistakes.push(
                        Mistake::error(
                            "E0402",
                            centre.span,
                            format!("the centre of gravity lies {at} from the big-end eye, outside the rod of {length}"),
                        )
                        .label("outside the rod")
                        .hint("measure from the centre of the big-end eye towards the small end"),
                    );
                    return None;
                }
                let small = mass * (centre.value / length);
                Some((mass - small, small, RodMassRule::CentreOfGravity))
            }
        }
    }

    /// A rod whose mass lies between its eyes has less inertia than its two end masses; far more is a slip.
    fn check_inertia(&mut self, inertia: f64, span: Span, (big, small): (f64, f64), length: f64) {
        let mass = big + small;
        let two_mass = if mass > 0.0 { big * small / mass * length * length } else { 0.0 };
        if inertia > 2.0 * two_mass {
            let [got, two_mass] =
                [inertia, two_mass].map(|value| lanchester_units::readable(value, Dimension::Inertia));
            self.mistakes.push(
                Mistake::warning(
                    "W0404",
                    span,
                    format!("an inertia of {got} is more than twice the {two_mass} of the two end masses"),
                )
                .label("too large for this rod")
                .hint("give it about the rod's centre of gravity, and check its unit"),
            );
        }
    }
}
