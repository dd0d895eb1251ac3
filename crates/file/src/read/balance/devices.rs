//! Free devices that are one, share a name, or stand in the way of the crank.

use super::Reader;
use crate::document::Span;
use lanchester_diagnostic::Mistake;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, FreeWeight, Phase, Place, Seat};
use lanchester_task::{RoomFaultKind, SAME_PLACE, TaskDevice, room_faults};
use std::f64::consts::PI;

/// Directions closer than this [rad] are one.
const SAME_ANGLE: f64 = 1e-9;

impl<'a> Reader<'a> {
    /// Weights of which one could take over what the other does.
    pub(super) fn check_told_apart(&mut self, task: &BalanceTask, spans: &[Span]) {
        for (index, weight) in task.weights.iter().enumerate() {
            let twin = (0..index).find(|&before| {
                are_one(task, &task.weights[before], weight) && leader(task, before) != leader(task, index)
            });
            let Some(twin) = twin else { continue };
            let other = &task.weights[twin];
            let (what, hint) = if weight.name == other.name {
                ("two free weights".to_string(), "leave one out, or give it another plane".to_string())
            } else {
                (
                    format!("\"{}\" and \"{}\"", other.name, weight.name),
                    format!(
                        "leave one out, give it another plane, or tie them: equal_to = \"{}\"",
                        other.name
                    ),
                )
            };
            let message = format!("{what} cannot be told apart: both sit in one plane of one shaft");
            self.mistakes.push(
                Mistake::error("E0510", spans[index].clone(), message)
                    .label("the same as the other")
                    .related(spans[twin].clone(), "the other")
                    .hint(hint),
            );
        }
    }

    pub(super) fn check_device_names(&mut self, task: &BalanceTask, spans: &[Span], shaft_spans: &[Span]) {
        for (index, weight) in task.weights.iter().enumerate() {
            let Some(twin) = task.weights[..index].iter().position(|other| other.name == weight.name) else {
                continue;
            };
            // Two in one plane are called what they are already.
            if !are_one(task, &task.weights[twin], weight) {
                self.one_name("free weights", &weight.name, [&spans[twin], &spans[index]]);
            }
        }
        for (index, shaft) in task.shafts.iter().enumerate() {
            if let Some(twin) = task.shafts[..index].iter().position(|other| other.name == shaft.name) {
                self.one_name("free shafts", &shaft.name, [&shaft_spans[twin], &shaft_spans[index]]);
            }
        }
    }

    pub(super) fn check_room(
        &mut self,
        task: &BalanceTask,
        engine: &Engine,
        spans: &[Span],
        shaft_spans: &[Span],
    ) {
        for fault in room_faults(engine, task) {
            let span = match fault.device {
                TaskDevice::Weight(index) => spans[index].clone(),
                TaskDevice::Shaft(index) => shaft_spans[index].clone(),
            };
            self.mistakes.push(match fault.kind {
                RoomFaultKind::Beyond => Mistake::warning("W0513", span, fault.message).hint(fault.hint),
                RoomFaultKind::Near => Mistake::warning("W0512", span, fault.message).hint(fault.hint),
                RoomFaultKind::Through => Mistake::error("E0512", span, fault.message)
                    .label("in the way of the crank")
                    .hint(fault.hint),
            });
        }
    }
}

/// The weight that says how large this one is: itself, if it follows none.
fn leader(task: &BalanceTask, weight: usize) -> usize {
    task.ties.iter().find(|tie| tie.second == weight).map_or(weight, |tie| tie.first)
}

/// Whether both sit in one plane of one shaft and may take any amount in a common direction.
fn are_one(task: &BalanceTask, one: &FreeWeight, other: &FreeWeight) -> bool {
    let is_given = |weight: &FreeWeight| weight.most == Some(weight.least);
    let is_fixed = |weight: &FreeWeight| is_given(weight) && matches!(weight.phase, Phase::Direction(_));
    let same_seat = one.seat == other.seat
        || match (one.seat, other.seat) {
            (Seat::Shaft(a), Seat::Shaft(b)) => {
                let (a, b) = (&task.shafts[a], &task.shafts[b]);
                a.ratio == b.ratio && same_place(a.x, b.x) && same_place(a.y, b.y)
            }
            _ => false,
        };
    let same_line = match (one.phase, other.phase) {
        (Phase::Free, _) | (_, Phase::Free) => true,
        (Phase::Line(a) | Phase::Direction(a), Phase::Line(b) | Phase::Direction(b)) => {
            let apart = (a - b).rem_euclid(PI);
            apart.min(PI - apart) < SAME_ANGLE
        }
    };
    let both_given = is_given(one) && is_given(other);
    let one_fixed = is_fixed(one) || is_fixed(other);
    same_seat && same_place(one.z, other.z) && same_line && !both_given && !one_fixed
}

fn same_place(a: Place, b: Place) -> bool {
    match (a, b) {
        (Place::At(a), Place::At(b)) => (a - b).abs() < SAME_PLACE,
        _ => false,
    }
}
