//! `[shaft.weights.shape]` and `[shaft_weight_design]`: weights of balance shafts as parts.

use crate::document::{Field, Section};
use crate::read::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::ShaftWeight;
use lanchester_model::ShaftWeightPart;
use lanchester_model::{LARGEST_UNBALANCE, PartFault};
use lanchester_shape::{GeometryError, ShaftWeightShape};
use lanchester_task::Range;
use lanchester_task::{ShaftWeightAim, ShaftWeightTask, fault_of};
use lanchester_units::Dimension;
use std::f64::consts::PI;

impl<'a> Reader<'a> {
    /// A weight of a shaft: a number, or a part.
    pub(in crate::read) fn shaft_weight(&mut self, section: &'a Section) -> Option<ShaftWeight> {
        let z = self.required(section, "z", section.number("z"));
        let phase = section.number("phase").or(0.0);
        let (unbalance, part) = match section.table("shape") {
            Field::Given(shape) => {
                let part = self.shaft_part(section, shape.value)?;
                (Some(part.unbalance()), Some(part))
            }
            Field::Absent => (self.weight_unbalance(section), None),
            Field::Bad => (None, None),
        };
        Some(ShaftWeight { z: z?, unbalance: unbalance?, phase: phase?, part })
    }

    /// The part of a weight; `weight` is the table of the weight.
    fn shaft_part(&mut self, weight: &'a Section, shape: &'a Section) -> Option<ShaftWeightPart> {
        let wanted = self.wanted_unbalance(weight);
        let [diameter, radius, length] =
            ["shaft_diameter", "radius", "length"].map(|key| self.required(shape, key, shape.number(key)));
        let density = match self.density(shape) {
            Some(None) => self.required(shape, "density", shape.number("density")),
            density => density.flatten(),
        };
        let chord = self.chord(shape, radius);
        let (wanted, density) = (wanted?, density?);
        let shape_of = ShaftWeightShape { shaft_radius: diameter? / 2.0, radius: radius?, chord: chord? };
        if let Err(fault) = fault_of(shape_of) {
            match fault.key {
                "chord" if shape.has("half_angle") => self.no_hold(shape, &shape_of),
                key => self.impossible_number(shape, key, &fault.error),
            }
            return None;
        }
        let part = ShaftWeightPart { shape: shape_of, length: length?, density, wanted };
        let unbalance = part.unbalance();
        if unbalance.is_nan() || unbalance > LARGEST_UNBALANCE {
            self.part_fault(shape.span.clone(), PartFault::TooLarge);
            return None;
        }
        if let Err(error) = part.part() {
            self.impossible_shape(shape.span.clone(), &error);
            return None;
        }
        if let Some(wanted) = wanted {
            self.check_wanted(weight.value_span("unbalance"), wanted, unbalance);
        }
        Some(part)
    }

    /// A half angle so small that the chord leaves the weight without a hold on its shaft.
    fn no_hold(&mut self, shape: &Section, given: &ShaftWeightShape) {
        let [least, got] = [given.shaft_radius, given.chord].map(|chord| {
            let angle = (chord / given.radius).clamp(-1.0, 1.0).acos();
            lanchester_units::readable(angle, Dimension::Angle)
        });
        let message = format!("`half_angle` must be more than {least} for this shaft and radius, got {got}");
        self.mistakes.push(
            Mistake::error("E0108", shape.value_span("half_angle"), message)
                .label("out of range")
                .hint("with less the weight has no hold on the shaft"),
        );
    }

    /// Distance of the chord from the axis.
    fn chord(&mut self, shape: &'a Section, radius: Option<f64>) -> Option<f64> {
        let (chord, angle) = (shape.number("chord"), shape.number("half_angle"));
        if shape.has("chord") && shape.has("half_angle") {
            self.two_sources(shape, "chord", "half_angle", "the chord");
            return None;
        }
        if !shape.has("half_angle") {
            return chord.or(0.0);
        }
        let angle = angle.given()?;
        if angle >= PI {
            let error = GeometryError::Number {
                quantity: "half the angle of the arc [rad]",
                needed: "less than 180 deg",
                got: angle,
                hint: "a whole disc is no weight",
            };
            self.impossible_number(shape, "half_angle", &error);
            return None;
        }
        Some(radius? * angle.cos())
    }

    /// The outer `None` says bad, the inner one absent.
    pub(in crate::read) fn shaft_weight_task(&mut self) -> Option<Option<ShaftWeightTask>> {
        let (section, broken) = self.section("shaft_weight_design");
        let Some(section) = section else { return (!broken).then_some(None) };
        let minimise = section.word("minimise").or("mass").map(|word| match word {
            "length" => ShaftWeightAim::Length,
            "radius" => ShaftWeightAim::Radius,
            "inertia" => ShaftWeightAim::Inertia,
            _ => ShaftWeightAim::Mass,
        });
        let density = match self.density(section) {
            Some(None) => self.required(section, "density", section.number("density")),
            density => density.flatten(),
        };
        let diameter = self.required(section, "shaft_diameter", section.number("shaft_diameter"));
        let [radius, length] = ["radius", "length"].map(|key| self.required_range(section, key));
        let chord = self.design_range(section, "chord").map(|range| range.unwrap_or(Range::fixed(0.0)));
        let task = ShaftWeightTask {
            minimise: minimise?,
            density: density?,
            shaft_radius: diameter? / 2.0,
            radius: radius?,
            chord: chord?,
            length: length?,
        };
        let faults = task.faults();
        for fault in &faults {
            self.impossible_number(section, fault.key, &fault.error);
        }
        self.check_shafts_have_weights(section);
        faults.is_empty().then_some(Some(task))
    }

    /// Shapes for weights of shafts are for nothing where there is no shaft, and none may come.
    fn check_shafts_have_weights(&mut self, section: &Section) {
        let may_come = self.root.has("balance");
        if !self.root.has("shaft") && !may_come && self.whole {
            let message = "[shaft_weight_design] is for the weights of balance shafts, and there is no shaft";
            self.mistakes.push(
                Mistake::warning("W0204", section.span.clone(), message)
                    .hint("add a [[shaft]], or a free one: [[balance.shaft]]"),
            );
        }
    }
}
