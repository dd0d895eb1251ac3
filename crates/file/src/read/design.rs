//! `[counterweight_design]`: shapes among which counterweights are to be found.

use super::crank::details::MaybeBody;
use super::reader::Reader;
use crate::document::{Field, Section};
use lanchester_task::{DesignLimits, DesignSettings, Objective, Range, ShapeTask, Shoulder};

impl<'a> Reader<'a> {
    /// The outer `None` says bad, the inner one absent.
    pub(super) fn shape_task(&mut self, body: &MaybeBody) -> Option<Option<ShapeTask>> {
        let (section, broken) = self.section("counterweight_design");
        let Some(section) = section else { return (!broken).then_some(None) };
        let own_body = body.as_ref().and_then(Option::as_ref);
        let minimise = section.word("minimise").or("mass").map(|word| match word {
            "swept radius" => Objective::SweptRadius,
            "inertia" => Objective::Inertia,
            "thickness" => Objective::Thickness,
            _ => Objective::Mass,
        });
        let is_pair = section.numbers("balance").given().is_some_and(|balance| balance.len() > 1);
        let balance = self.range_of(section, "balance");
        let mut density = self.density(section);
        let mut web_radius = self.design_range(section, "web_radius");
        if body.is_some() {
            let hint = |key| format!("{}, or in [crank.body]", section.example(key));
            density =
                self.or_of_body(section, "density", density, own_body.map(|b| b.density), hint("density"));
            let fixed = own_body.map(|body| Range::fixed(body.web_radius));
            web_radius = self.or_of_body(section, "web_radius", web_radius, fixed, hint("web_radius"));
        }
        let [rectangle_height, arc_radius, arc_angle, thickness] =
            ["rectangle_height", "arc_radius", "arc_angle", "thickness"]
                .map(|key| self.required_range(section, key));
        let shoulder = self.design_shoulder(section);
        let limits = self.design_limits(section);
        let [least, most] = balance?.unwrap_or([1.0; 2]);
        let task = ShapeTask {
            minimise: minimise?,
            least_balance: least,
            most_balance: is_pair.then_some(most),
            density: density??,
            web_radius: web_radius??,
            rectangle_height: rectangle_height?,
            shoulder: shoulder?,
            arc_radius: arc_radius?,
            arc_angle: arc_angle?,
            thickness: thickness?,
            limits: limits?,
            settings: DesignSettings::default(),
        };
        let faults = task.faults();
        for fault in &faults {
            let below = fault.key.strip_prefix("limits.");
            match (below, section.table("limits")) {
                (Some(key), Field::Given(limits)) => self.impossible_number(limits.value, key, &fault.error),
                _ => self.impossible_number(section, fault.key, &fault.error),
            }
        }
        faults.is_empty().then_some(Some(task))
    }

    /// The value of the key, or that of `[crank.body]`.
    fn or_of_body<T>(
        &mut self,
        section: &Section,
        key: &str,
        own: Option<Option<T>>,
        of_body: Option<T>,
        hint: String,
    ) -> Option<Option<T>> {
        match (own, of_body) {
            (Some(None), None) => {
                let header = section.title();
                self.missing(section.span.clone(), format!("`{key}` is missing in {header}"), hint);
                None
            }
            (Some(None), of_body) => Some(of_body),
            (own, _) => own,
        }
    }

    /// A range that must be there.
    pub(super) fn required_range(&mut self, section: &Section, key: &str) -> Option<Range> {
        let range = self.design_range(section, key);
        if range == Some(None) {
            let header = section.title();
            let message = format!("`{key}` is missing in {header}");
            self.missing(section.span.clone(), message, section.example(key));
        }
        range.flatten()
    }

    pub(super) fn design_range(&mut self, section: &Section, key: &str) -> Option<Option<Range>> {
        Some(self.range_of(section, key)?.map(|[least, most]| Range::new(least, most)))
    }

    fn design_shoulder(&mut self, section: &'a Section) -> Option<Shoulder> {
        let height = self.design_range(section, "shoulder_height");
        let angle = self.design_range(section, "shoulder_angle");
        match (height?, angle?) {
            (Some(_), Some(_)) => {
                self.two_sources(section, "shoulder_height", "shoulder_angle", "the flank");
                None
            }
            (Some(height), None) => Some(Shoulder::Height(height)),
            (None, Some(angle)) => Some(Shoulder::Angle(angle)),
            (None, None) => {
                self.missing(
                    section.span.clone(),
                    "the flank is missing in [counterweight_design]".into(),
                    "add shoulder_height = [\"0 mm\", \"30 mm\"], or shoulder_angle".into(),
                );
                None
            }
        }
    }

    fn design_limits(&mut self, section: &'a Section) -> Option<DesignLimits> {
        let limits = match section.table("limits") {
            Field::Given(spot) => spot.value,
            Field::Absent => return Some(DesignLimits::default()),
            Field::Bad => return None,
        };
        let largest = |key| match limits.number(key) {
            Field::Given(spot) => Some(Some(spot.value)),
            Field::Absent => Some(None),
            Field::Bad => None,
        };
        let [mass, swept_radius, inertia, half_width] =
            ["mass", "swept_radius", "inertia", "half_width"].map(largest);
        let shoulder_angle = self.design_range(limits, "shoulder_angle");
        let shoulder_height = self.design_range(limits, "shoulder_height");
        Some(DesignLimits {
            mass: mass?,
            swept_radius: swept_radius?,
            inertia: inertia?,
            half_width: half_width?,
            shoulder_angle: shoulder_angle?,
            shoulder_height: shoulder_height?,
        })
    }
}
