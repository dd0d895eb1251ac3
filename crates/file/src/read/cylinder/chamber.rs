//! Pistons that share a combustion chamber: opposed pistons, and pistons side by side under one head.

use crate::document::{Field, Span};
use crate::read::drafts::Drafts;
use crate::read::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::{Crankshaft, Engine};
use lanchester_numerics::about_zero;
use std::f64::consts::TAU;

/// Largest angle [rad] of their own crankshafts between the top dead centres at which pistons of one chamber fire.
const FARTHEST_APART: f64 = TAU / 4.0;

/// The chamber that the file gives a piston: index of the first piston of the chamber, and where it says so.
pub(in crate::read) type GivenChamber = Option<(usize, Span)>;

impl<'a> Reader<'a> {
    /// For every cylinder whose chamber it shares; the outer `None` says bad.
    pub(in crate::read) fn chambers(
        &mut self,
        drafts: &Drafts<'a>,
        crankshafts: Option<&[Crankshaft]>,
    ) -> Option<Vec<GivenChamber>> {
        let count = drafts.cylinders.len();
        let section = |index: usize| drafts.cylinders[index].as_ref().and_then(|draft| draft.section);
        let mut chambers = Vec::with_capacity(count);
        let mut is_good = true;
        for index in 0..count {
            let field = section(index).map_or(Field::Absent, |section| section.whole("chamber"));
            let spot = match field {
                Field::Absent => {
                    chambers.push(None);
                    continue;
                }
                Field::Bad => return None,
                Field::Given(spot) => spot,
            };
            let Some(first) = self.existing(spot.value, Some(count), "cylinder", spot.span.clone()) else {
                is_good = false;
                continue;
            };
            let number = index + 1;
            let ratio = |index: usize| {
                let throw = drafts.cylinders[index].as_ref()?.cylinder.throw;
                let crankshaft = drafts.throws[throw].as_ref()?.throw.crankshaft;
                Some(crankshafts?.get(crankshaft)?.ratio.value().abs())
            };
            let fault = if first >= index {
                Some((
                    format!(
                        "cylinder {number} must share the chamber of a cylinder with a lower number, got {}",
                        first + 1
                    ),
                    "give the number of the first piston of the chamber".to_owned(),
                ))
            } else if section(first).is_some_and(|section| section.has("chamber")) {
                Some((
                    format!(
                        "cylinder {}, whose chamber cylinder {number} shares, has none of its own",
                        first + 1
                    ),
                    "give the number of the first piston of the chamber to all others".to_owned(),
                ))
            } else {
                let (own, other) = (ratio(index), ratio(first));
                own.zip(other).filter(|(own, other)| own != other).map(|(own, other)| {
                    (
                        format!(
                            "pistons of one chamber need crankshafts of one speed, got ratios {other} (cylinder {}) and {own}",
                            first + 1
                        ),
                        "give their crankshafts the same `ratio`, up to its sign".to_owned(),
                    )
                })
            };
            if let Some((message, hint)) = fault {
                self.mistakes.push(Mistake::error("E0604", spot.span, message).hint(hint));
                is_good = false;
                continue;
            }
            chambers.push(Some((first, spot.span)));
        }
        is_good.then_some(chambers)
    }

    /// Gives the cylinders their chambers; whether the pistons of each fire together.
    pub(in crate::read) fn check_chambers(
        &mut self,
        engine: &Engine,
        chambers: &[GivenChamber],
    ) -> Option<()> {
        let mut is_good = true;
        for (index, chamber) in chambers.iter().enumerate() {
            let Some((first, span)) = chamber else { continue };
            let first = *first;
            let [own, other] = [index, first].map(|index| engine.cylinders[index].firing_angle);
            let Some((own, other)) = own.zip(other) else { continue };
            let cycle = engine.working_cycle(index);
            let apart = about_zero(own - other, cycle);
            let turned = apart.abs() / cycle * TAU * f64::from(engine.strokes.revolutions());
            if turned > FARTHEST_APART {
                let message = format!(
                    "cylinders {} and {} share a chamber, but fire {:.4} deg of their crankshafts apart",
                    first + 1,
                    index + 1,
                    turned.to_degrees()
                );
                let hint =
                    "give them the same firing angle, and `phase` of the crankshaft the lead of one of them";
                self.mistakes.push(Mistake::error("E0604", span.clone(), message).hint(hint));
                is_good = false;
            }
        }
        is_good.then_some(())
    }
}
