//! Devices that are one, and devices that stand in the way of the crank.

use super::Reader;
use crate::diagnostic::Mistake;
use crate::document::Span;
use crate::engine::Engine;
use crate::quantity::{Dimension, readable};
use crate::task::{BalanceTask, FreeWeight, Phase, Place, Seat};
use std::f64::consts::PI;

/// Places closer than this [m] are one.
const SAME_PLACE: f64 = 1e-9;
/// Directions closer than this [rad] are one.
const SAME_ANGLE: f64 = 1e-9;

/// The room that a crankshaft takes.
struct Crank {
    x: f64,
    y: f64,
    /// Largest crank radius.
    radius: f64,
    /// Its ends: half a throw spacing beyond the outer throws.
    ends: (f64, f64),
}

impl Crank {
    /// `None` for a crankshaft without throws.
    fn of(engine: &Engine, index: usize) -> Option<Crank> {
        let throws: Vec<_> = engine.throws.iter().filter(|throw| throw.crankshaft == index).collect();
        let mut planes: Vec<f64> = throws.iter().map(|throw| throw.z).collect();
        planes.sort_by(f64::total_cmp);
        planes.dedup_by(|a, b| (*a - *b).abs() < SAME_PLACE);
        let (first, last) = (*planes.first()?, *planes.last()?);
        let radius = throws.iter().map(|throw| throw.radius).fold(0.0, f64::max);
        let half_spacing = match planes.len() - 1 {
            // A throw alone has no neighbour: as far as its webs reach, or as its stroke.
            0 => throws
                .iter()
                .filter_map(|throw| throw.webs)
                .map(|[front, rear]| rear - front)
                .fold(None, |widest: Option<f64>, width| Some(widest.unwrap_or(0.0).max(width)))
                .unwrap_or(2.0 * radius),
            gaps => (last - first) / gaps as f64 / 2.0,
        };
        let crankshaft = &engine.crankshafts[index];
        let ends = (first - half_spacing, last + half_spacing);
        Some(Crank { x: crankshaft.x, y: crankshaft.y, radius, ends })
    }
}

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
        let cranks: Vec<Option<Crank>> =
            (0..engine.crankshafts.len()).map(|index| Crank::of(engine, index)).collect();
        for (weight, span) in task.weights.iter().zip(spans) {
            if let Seat::Crankshaft(index) = weight.seat
                && let Some(crank) = &cranks[index]
            {
                self.check_beyond(weight, crank, span);
            }
        }
        for (index, span) in shaft_spans.iter().enumerate() {
            for crank in cranks.iter().flatten() {
                self.check_sweep(task, index, crank, span);
            }
        }
    }

    fn check_beyond(&mut self, weight: &FreeWeight, crank: &Crank, span: &Span) {
        let (first, last) = range(weight.z);
        let (front, rear) = crank.ends;
        let beyond = if first < front - SAME_PLACE {
            first
        } else if last > rear + SAME_PLACE {
            last
        } else {
            return;
        };
        let [z, front, rear] = [beyond, front, rear].map(|z| readable(z, Dimension::Length));
        let message = format!(
            "\"{}\" stands beyond the crank: z = {z}, the crank runs from {front} to {rear}",
            weight.name
        );
        self.mistakes.push(
            Mistake::warning("W0513", span.clone(), message)
                .hint("right for a flywheel or a pulley; z here counts from the reference plane"),
        );
    }

    /// A shaft must stay clear of the circle of the crankpins wherever it passes them.
    fn check_sweep(&mut self, task: &BalanceTask, index: usize, crank: &Crank, span: &Span) {
        let shaft = &task.shafts[index];
        let own: Vec<&FreeWeight> =
            task.weights.iter().filter(|weight| weight.seat == Seat::Shaft(index)).collect();
        let [(x_near, x_far), (y_near, y_far)] = [distances(shaft.x, crank.x), distances(shaft.y, crank.y)];
        let (near, far) = (x_near.hypot(y_near), x_far.hypot(y_far));
        let (front, rear) = crank.ends;
        let within = |weight: &&FreeWeight| {
            let (first, last) = range(weight.z);
            first > front - SAME_PLACE && last < rear + SAME_PLACE
        };
        let before = own.iter().any(|weight| range(weight.z).1 <= front);
        let behind = own.iter().any(|weight| range(weight.z).0 >= rear);
        // On the crank's own axis the weights at its two ends are two shafts.
        let passes = own.iter().any(within) || (before && behind && far > SAME_PLACE);
        if !passes {
            return;
        }
        let reach =
            own.iter().filter(|weight| within(weight)).filter_map(|weight| weight.radius).fold(0.0, f64::max);
        let [distance, radius] = [far, crank.radius].map(|length| readable(length, Dimension::Length));
        if far < crank.radius {
            let message = format!(
                "the shaft \"{}\" runs through the crank: its axis is {distance} from the crank's, the crankpins turn \
                 at {radius}",
                shaft.name
            );
            self.mistakes.push(
                Mistake::error("E0512", span.clone(), message)
                    .label("in the way of the crank")
                    .hint("give x and y further out, or weights beyond the crank's ends"),
            );
        } else if near < crank.radius + reach {
            let needed = readable(crank.radius + reach, Dimension::Length);
            let message = format!(
                "the shaft \"{}\" may strike the crank: its axis comes as near as {}, crankpins and weights reach {needed}",
                shaft.name,
                readable(near, Dimension::Length)
            );
            self.mistakes.push(
                Mistake::warning("W0512", span.clone(), message)
                    .hint("big ends, webs and counterweights need more room still: check the places"),
            );
        }
    }
}

fn range(place: Place) -> (f64, f64) {
    match place {
        Place::At(at) => (at, at),
        Place::Between(first, last) => (first, last),
    }
}

/// Smallest and largest distance of a place from a point.
fn distances(place: Place, point: f64) -> (f64, f64) {
    let (first, last) = range(place);
    let near =
        if first <= point && point <= last { 0.0 } else { (first - point).abs().min((last - point).abs()) };
    (near, (first - point).abs().max((last - point).abs()))
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
