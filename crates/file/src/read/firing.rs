//! When the cylinders fire.

use super::drafts::Drafts;
use super::reader::Reader;
use crate::document::{Field, Section, Spot};
use crate::firing;
use lanchester_diagnostic::Mistake;
use lanchester_model::Ratio;
use lanchester_model::angle;
use lanchester_model::{Crankshaft, RodJoint, Strokes};
use lanchester_numerics::about_zero;
use lanchester_units::Dimension;
use std::f64::consts::TAU;

/// Largest angle [rad] of its own crankshaft between a firing angle and the cylinder's own top dead centre.
const FARTHEST_FROM_TOP: f64 = TAU / 8.0;

/// Nominal top dead centre of a cylinder.
#[derive(Debug, Clone, Copy)]
pub(super) struct Top {
    /// The first one [rad], from 0.
    theta: f64,
    /// From one to the next [rad].
    period: f64,
    /// Speed of its crankshaft over that of crankshaft 1.
    ratio: Ratio,
}

impl Top {
    /// Angle of crankshaft 1 in which the cylinder fires once [rad]: a working cycle of its own crankshaft.
    fn cycle(self, strokes: Strokes) -> f64 {
        lanchester_model::working_cycle(strokes, self.ratio)
    }
}

/// `theta` at which a cylinder fires that fires `after` cylinder 1, which fires at `start` [rad]; `cycle`: its own, in which it fires
/// once.
pub(crate) fn fired_after(start: f64, after: f64, cycle: f64) -> f64 {
    angle::snapped(firing::turn(start + after, cycle))
}

impl<'a> Reader<'a> {
    /// `[firing]`, if it says something.
    pub(super) fn firing_section(&mut self) -> Option<&'a Section> {
        let (section, _) = self.section("firing");
        let section = section?;
        match (section.has("order"), section.has("angles")) {
            (true, true) => {
                self.two_sources(section, "order", "angles", "when the cylinders fire");
                None
            }
            (false, false) => {
                self.missing(
                    section.span.clone(),
                    "[firing] says neither `order` nor `angles`".into(),
                    section.example("order"),
                );
                None
            }
            _ => Some(section),
        }
    }

    /// Nominal top dead centres of all cylinders; `None` if not all of them could be read.
    pub(super) fn tops(&self, drafts: &Drafts<'a>, crankshafts: Option<&[Crankshaft]>) -> Option<Vec<Top>> {
        let crankshafts = crankshafts?;
        drafts
            .cylinders
            .iter()
            .map(|draft| {
                let cylinder = &draft.as_ref()?.cylinder;
                let throw = &drafts.throws[cylinder.throw].as_ref()?.throw;
                let crankshaft = crankshafts.get(throw.crankshaft)?;
                let ratio = crankshaft.ratio.value();
                let (offset, reach) = match cylinder.rod.joint {
                    RodJoint::Articulated { .. } => (0.0, None),
                    _ => (cylinder.net_offset(), Some(throw.radius + cylinder.rod.length)),
                };
                let pin = crankshaft.phase + throw.angle;
                let theta = angle::snapped(firing::nominal_top(ratio, pin, cylinder.angle, offset, reach));
                Some(Top { theta, period: TAU / ratio.abs(), ratio: crankshaft.ratio })
            })
            .collect()
    }

    /// `theta` at which each cylinder fires, `None` for all where the file does not say.
    pub(super) fn firing_angles(
        &mut self,
        firing: Option<&'a Section>,
        strokes: Option<Strokes>,
        tops: Option<Vec<Top>>,
        cylinders: usize,
    ) -> Option<Vec<Option<f64>>> {
        let Some(section) = firing else { return Some(vec![None; cylinders]) };
        let angles = match (section.wholes("order"), section.numbers("angles")) {
            (Field::Given(order), _) => self.fired_in_order(order, strokes?, tops, cylinders),
            (_, Field::Given(angles)) => self.fired_at(angles, strokes?, tops, cylinders),
            _ => None,
        }?;
        Some(angles.into_iter().map(Some).collect())
    }

    /// Whether the order names each cylinder of the layout once, where the layout itself is not known.
    pub(super) fn check_order(&mut self, firing: Option<&'a Section>) {
        let Some(Field::Given(order)) = firing.map(|firing| firing.wholes("order")) else { return };
        let Some(layout) = self.root.table("layout").given() else { return };
        let Some(cylinders) = layout.whole("cylinders").given() else { return };
        let numbers: Vec<usize> =
            order.value.iter().filter_map(|spot| usize::try_from(spot.value).ok()).collect();
        if let (Ok(count), false) = (usize::try_from(cylinders), layout.has("rows"))
            && let Err(problem) = firing::check_permutation(&numbers, count)
        {
            self.problem(problem);
        }
    }

    fn fired_in_order(
        &mut self,
        order: Spot<Vec<Spot<i64>>>,
        strokes: Strokes,
        tops: Option<Vec<Top>>,
        cylinders: usize,
    ) -> Option<Vec<f64>> {
        let mut numbers: Vec<usize> =
            order.value.iter().filter_map(|spot| usize::try_from(spot.value).ok()).collect();
        if let Err(problem) = firing::check_permutation(&numbers, cylinders) {
            if self.whole {
                self.problem(problem);
            }
            return None;
        }
        let tops = tops?;
        if tops.iter().any(|top| top.period != TAU) {
            self.mistakes.push(
                Mistake::error(
                    "E0601",
                    order.span,
                    "a firing order needs crankshafts that turn as fast as crankshaft 1",
                )
                .hint("give the angles instead: angles = [\"0 deg\", ..]"),
            );
            return None;
        }
        // The order is a circle: it may start anywhere, the angles start with cylinder 1.
        let first = numbers.iter().position(|number| *number == 1).unwrap_or(0);
        numbers.rotate_left(first);
        let tops: Vec<f64> = tops.iter().map(|top| top.theta).collect();
        match firing::assign(strokes, &tops, &numbers) {
            Ok(angles) => Some(angles.into_iter().map(angle::snapped).collect()),
            Err(problem) => {
                self.problem(problem);
                None
            }
        }
    }

    fn fired_at(
        &mut self,
        angles: Spot<Vec<Spot<f64>>>,
        strokes: Strokes,
        tops: Option<Vec<Top>>,
        cylinders: usize,
    ) -> Option<Vec<f64>> {
        let got = angles.value.len();
        if got != cylinders {
            if self.whole {
                self.mistakes.push(
                    Mistake::error(
                        "E0602",
                        angles.span,
                        format!("`angles` needs {cylinders} angles, one a cylinder, got {got}"),
                    )
                    .hint("write them in the order of the cylinder numbers"),
                );
            }
            return None;
        }
        // Every cylinder fires once in a working cycle of its own crankshaft; any of its firings may be given.
        let own = tops.iter().flatten().map(|top| top.ratio);
        let period = firing::common_cycle(strokes, own.chain([Ratio::ONE]));
        let mut is_good = true;
        for (index, angle) in angles.value.iter().enumerate() {
            let shown = lanchester_units::readable(angle.value, Dimension::Angle);
            let wrong = match index {
                0 if angle.value != 0.0 => Some((
                    format!("cylinder 1 must fire at 0 deg, got {shown}"),
                    format!("the angles count from the firing of cylinder 1: take {shown} off all of them"),
                )),
                _ if !(0.0..period).contains(&angle.value) => Some((
                    format!("a firing angle of {shown} lies outside the cycle"),
                    format!(
                        "write an angle from 0 deg to below {}",
                        lanchester_units::readable(period, Dimension::Angle)
                    ),
                )),
                _ => None,
            };
            if let Some((message, hint)) = wrong {
                self.mistakes.push(Mistake::error("E0602", angle.span.clone(), message).hint(hint));
                is_good = false;
            }
        }
        let tops = tops?;
        if !is_good {
            return None;
        }
        let start = tops.first()?.theta;
        let mut fired = Vec::new();
        for (index, (angle, top)) in angles.value.iter().zip(&tops).enumerate() {
            let theta = fired_after(start, angle.value, top.cycle(strokes));
            let off = about_zero(theta - top.theta, top.period);
            if off.abs() * TAU / top.period > FARTHEST_FROM_TOP {
                let number = index + 1;
                let nearest = firing::turn(angle.value - off, period);
                let [off, nearest] =
                    [off.abs(), nearest].map(|angle| lanchester_units::readable(angle, Dimension::Angle));
                self.mistakes.push(
                    Mistake::error(
                        "E0603",
                        angle.span.clone(),
                        format!("cylinder {number} would fire {off} from its top dead centre"),
                    )
                    .hint(format!("the nearest angle of its top dead centre is {nearest}")),
                );
                is_good = false;
            }
            fired.push(theta);
        }
        is_good.then_some(fired)
    }
}
