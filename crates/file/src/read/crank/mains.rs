//! Places of the main bearings.

use crate::document::{Field, Section, Span};
use crate::read::layers::Layers;
use crate::read::{Drafts, Reader};
use lanchester_diagnostic::Mistake;
use lanchester_model::{Crankshaft, Throw};
use lanchester_units::Dimension;

/// Planes closer than this [m] are one.
const SAME_PLANE: f64 = 1e-9;

const KEY: &str = "main_positions";

impl<'a> Reader<'a> {
    /// Main bearings of a crankshaft in the z of the file, from its own table over `[crank]`; the outer `None` says
    /// bad.
    pub(in crate::read) fn main_positions(&self, own: Option<&'a Section>) -> Option<Option<Vec<f64>>> {
        let field = match self.layers_of_mains(own).with_any(&[KEY]) {
            Some(section) => section.numbers(KEY),
            None => Field::Absent,
        };
        match field {
            Field::Absent => Some(None),
            Field::Bad => None,
            Field::Given(spot) => Some(Some(spot.value.into_iter().map(|spot| spot.value).collect())),
        }
    }

    fn layers_of_mains(&self, own: Option<&'a Section>) -> Layers<'a> {
        self.layers(&[own], "crank")
    }

    /// Main bearings must rise, be two or more, and leave the throws room.
    pub(in crate::read) fn check_mains(&mut self, drafts: &Drafts<'a>, crankshafts: Option<&[Crankshaft]>) {
        let Some(crankshafts) = crankshafts else { return };
        let sections = self.root.tables("crankshaft").given().unwrap_or_default();
        let mut checked: Vec<(Span, bool)> = Vec::new();
        for (index, crankshaft) in crankshafts.iter().enumerate() {
            let Some(mains) = &crankshaft.mains else { continue };
            let Some(section) = self.layers_of_mains(sections.get(index)).with_any(&[KEY]) else { continue };
            let span = section.value_span(KEY);
            // Crankshafts that share the list of `[crank]` share its mistakes.
            let is_row = match checked.iter().find(|(seen, _)| *seen == span) {
                Some((_, is_row)) => *is_row,
                None => {
                    checked.push((span.clone(), self.check_row(mains, &span)));
                    checked[checked.len() - 1].1
                }
            };
            if !is_row {
                continue;
            }
            for (number, draft) in drafts.throws.iter().enumerate() {
                let Some(draft) = draft.as_ref().filter(|draft| draft.throw.crankshaft == index) else {
                    continue;
                };
                self.check_throw_between(mains, &span, number + 1, &draft.throw, &draft.span);
            }
        }
    }

    /// Whether it is two or more places that rise.
    fn check_row(&mut self, mains: &[f64], span: &Span) -> bool {
        if mains.len() < 2 {
            let got = mains.len();
            self.mistakes.push(
                Mistake::error("E0206", span.clone(), format!("`{KEY}` needs two or more places, got {got}"))
                    .hint("a crankshaft needs a main bearing at each end"),
            );
            return false;
        }
        if let Some(at) = mains.windows(2).position(|pair| pair[1] <= pair[0] + SAME_PLANE) {
            let [one, two] =
                [mains[at], mains[at + 1]].map(|z| lanchester_units::readable(z, Dimension::Length));
            self.mistakes.push(
                Mistake::error(
                    "E0702",
                    span.clone(),
                    format!(
                        "main bearings must rise from the free end to the flywheel, got {one} before {two}"
                    ),
                )
                .label("not rising")
                .hint("sort the places, each of them once"),
            );
            return false;
        }
        true
    }

    fn check_throw_between(
        &mut self,
        mains: &[f64],
        span: &Span,
        number: usize,
        throw: &Throw,
        throw_span: &Span,
    ) {
        let half = throw.webs.map_or(SAME_PLANE, |[front, rear]| 0.5 * (rear - front));
        if let Some(main) = mains.iter().position(|main| (main - throw.z).abs() <= half) {
            let [at, plane] =
                [mains[main], throw.z].map(|z| lanchester_units::readable(z, Dimension::Length));
            let main = main + 1;
            self.mistakes.push(
                Mistake::error(
                    "E0702",
                    span.clone(),
                    format!("main bearing {main} at {at} stands within throw {number} at {plane}"),
                )
                .related(throw_span.clone(), "the throw")
                .hint("a main bearing stands beside the webs of a throw"),
            );
            return;
        }
        let (Some(first), Some(last)) = (mains.first(), mains.last()) else { return };
        if throw.z < *first || throw.z > *last {
            let [first, last, plane] =
                [*first, *last, throw.z].map(|z| lanchester_units::readable(z, Dimension::Length));
            self.mistakes.push(
                Mistake::warning(
                    "W0702",
                    span.clone(),
                    format!(
                        "throw {number} at {plane} stands outside the main bearings, from {first} to {last}"
                    ),
                )
                .related(throw_span.clone(), "the throw")
                .hint("right for an overhung crank; else give the places in the z of this file"),
            );
        }
    }
}
