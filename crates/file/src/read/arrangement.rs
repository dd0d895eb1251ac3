//! `[layout]` as the layout's own terms, and its problems as mistakes in the file.

use super::reader::Reader;
use crate::document::{Field, Section, Spot};
use crate::layout::{Arrangement, Bank, LayoutKind, LayoutSpec, Numbering, Pins, Rods, arrange};
use crate::problem::Problem;
use lanchester_diagnostic::Mistake;
use lanchester_model::Strokes;

impl<'a> Reader<'a> {
    /// Throws and cylinders of the layout; `None` if something in it is wrong, which is reported.
    pub(super) fn arrangement(
        &mut self,
        layout: &'a Section,
        strokes: Strokes,
        firing: Option<&'a Section>,
        radius: Option<f64>,
    ) -> Option<Arrangement> {
        let spec = self.layout_spec(layout, strokes, firing, radius)?;
        match arrange(&spec) {
            Ok(arrangement) => Some(arrangement),
            Err(problems) => {
                for problem in problems {
                    self.problem(problem);
                }
                None
            }
        }
    }

    fn layout_spec(
        &mut self,
        layout: &'a Section,
        strokes: Strokes,
        firing: Option<&'a Section>,
        radius: Option<f64>,
    ) -> Option<LayoutSpec> {
        let kind = self.required(layout, "type", layout.word("type"));
        let cylinders = self.required(layout, "cylinders", layout.whole("cylinders"));
        let spec = Keys { section: layout };
        let (number, count) = (|key| spec.number(key), |key: &str| spec.count(key));
        let order = match firing {
            Some(firing) => Keys { section: firing }.counts("order"),
            None => Some(None),
        };
        let length = self
            .section("rod")
            .0
            .and_then(|rod| if rod.has("length") { rod.number("length").given() } else { None });
        let (articulated, broken) = self.section("articulated_rod");
        let of_rod = |key: &str| match articulated {
            Some(section) if section.has(key) => Keys { section }.number(key),
            _ => Some(None),
        };
        let banks = self.banks(layout);
        let numbering = spec.word("numbering");
        let pins = spec.word("pins");
        let rods = spec.word("rods");
        // Everything is asked for before the first `?`, so that nothing counts as never asked for.
        let (spacing, positions) = (number("spacing"), spec.numbers("positions"));
        let (crank_angles, crank_phase) = (spec.numbers("crank_angles"), number("crank_phase"));
        let (bank_stagger, bank_angle) = (number("bank_stagger"), number("bank_angle"));
        let (split_angle, bank_offset) = (number("split_angle"), number("bank_offset"));
        let (rows, row_spacing, row_angles) =
            (count("rows"), number("row_spacing"), spec.numbers("row_angles"));
        let (master, knuckle_radius) = (count("master"), number("knuckle_radius"));
        let knuckle_angles = spec.numbers("knuckle_angles");
        let (rod_knuckle_radius, rod_knuckle_angle) = (of_rod("knuckle_radius"), of_rod("knuckle_angle"));
        if broken {
            return None;
        }
        let kind = match kind? {
            "in-line" => LayoutKind::InLine,
            "v" => LayoutKind::V,
            "boxer" => LayoutKind::Boxer,
            "flat" => LayoutKind::Flat,
            "vr" => LayoutKind::Vr,
            "w" => LayoutKind::W,
            _ => LayoutKind::Radial,
        };
        Some(LayoutSpec {
            order: order?,
            reach: radius.zip(length).map(|(radius, length)| radius + length),
            spacing: spacing?,
            positions: positions?,
            crank_angles: crank_angles?,
            crank_phase: crank_phase?,
            numbering: numbering?.map(|word| match word {
                "alternating" => Numbering::Alternating,
                _ => Numbering::ByBank,
            }),
            bank_stagger: bank_stagger?,
            bank_angle: bank_angle?,
            pins: pins?.map(|word| match word {
                "split" => Pins::Split,
                "separate" => Pins::Separate,
                _ => Pins::Shared,
            }),
            split_angle: split_angle?,
            rods: rods?.map(|word| match word {
                "fork-and-blade" => Rods::ForkAndBlade,
                "articulated" => Rods::Articulated,
                _ => Rods::SideBySide,
            }),
            bank_offset: bank_offset?,
            banks: banks?,
            rows: rows?,
            row_spacing: row_spacing?,
            row_angles: row_angles?,
            master: master?,
            knuckle_radius: knuckle_radius?,
            knuckle_angles: knuckle_angles?,
            rod_knuckle_radius: rod_knuckle_radius?,
            rod_knuckle_angle: rod_knuckle_angle?,
            ..LayoutSpec::new(kind, usize::try_from(cylinders?).ok()?, strokes)
        })
    }

    fn banks(&mut self, layout: &'a Section) -> Option<Option<Vec<Bank>>> {
        let sections = match layout.tables("banks") {
            Field::Absent => return Some(None),
            Field::Bad => return None,
            Field::Given(spot) => spot.value,
        };
        let banks: Vec<Option<Bank>> = sections
            .iter()
            .map(|section| {
                let angle = self.required(section, "angle", section.number("angle"));
                let offset = Keys { section }.number("offset");
                Some(Bank { angle: angle?, offset: offset? })
            })
            .collect();
        Some(Some(banks.into_iter().collect::<Option<Vec<Bank>>>()?))
    }

    /// A problem of the layout or the firing order as a mistake at its key.
    pub(super) fn problem(&mut self, problem: Problem) {
        let (table, key) = problem.key.split_once('.').unwrap_or(("", problem.key));
        let section = match self.root.table(table) {
            Field::Given(spot) => Some(spot.value),
            _ => None,
        };
        let is_there = section.is_some_and(|section| section.has(key));
        let span = match section {
            Some(section) => section.value_span(key),
            None => self.root.table("layout").given().map_or(0..0, |layout| layout.span.clone()),
        };
        if !is_there && !self.whole {
            return;
        }
        let code = match (is_there, table) {
            (false, _) => "E0202",
            (true, "firing") => "E0601",
            (true, _) => "E0701",
        };
        let mut mistake = Mistake::error(code, span, problem.message);
        if let Some(hint) = problem.hint {
            mistake = mistake.hint(hint);
        }
        self.mistakes.push(mistake);
    }
}

/// Keys of a table as they stand: the outer `None` says bad, the inner one absent.
struct Keys<'a> {
    section: &'a Section,
}

impl Keys<'_> {
    fn number(&self, key: &str) -> Option<Option<f64>> {
        optional(self.section.number(key))
    }

    fn numbers(&self, key: &str) -> Option<Option<Vec<f64>>> {
        optional(self.section.numbers(key))
            .map(|list| list.map(|list| list.into_iter().map(|s| s.value).collect()))
    }

    fn word(&self, key: &str) -> Option<Option<&'static str>> {
        optional(self.section.word(key))
    }

    fn count(&self, key: &str) -> Option<Option<usize>> {
        optional(self.section.whole(key)).map(|number| number.and_then(|number| usize::try_from(number).ok()))
    }

    fn counts(&self, key: &str) -> Option<Option<Vec<usize>>> {
        let count = |spot: Spot<i64>| usize::try_from(spot.value).ok();
        optional(self.section.wholes(key))
            .map(|list| list.map(|list| list.into_iter().filter_map(count).collect()))
    }
}

fn optional<T>(field: Field<T>) -> Option<Option<T>> {
    match field {
        Field::Absent => Some(None),
        Field::Bad => None,
        Field::Given(spot) => Some(Some(spot.value)),
    }
}
