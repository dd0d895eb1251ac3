//! Free devices that stand in the way of the crank, or beyond it.

use crate::balance_task::{BalanceTask, FreeWeight, Place, Seat};
use lanchester_model::Engine;
use lanchester_units::{Dimension, readable};

/// Places closer than this [m] are one.
pub const SAME_PLACE: f64 = 1e-9;

/// A device of a task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TaskDevice {
    /// Of [`BalanceTask::weights`], by index.
    Weight(usize),
    /// Of [`BalanceTask::shafts`], by index.
    Shaft(usize),
}

/// How a device stands to the crank.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoomFaultKind {
    /// Beyond its ends: right for a flywheel or a pulley.
    Beyond,
    /// So near that it may strike crankpins or weights, at some place of those allowed.
    Near,
    /// In the circle of the crankpins at every place allowed: it cannot be built.
    Through,
}

/// A free device that stands in the way of the crank, or beyond it.
#[derive(Debug, Clone, PartialEq)]
pub struct RoomFault {
    /// Which one.
    pub device: TaskDevice,
    /// How it stands.
    pub kind: RoomFaultKind,
    /// In words, with its place and the room of the crank.
    pub message: String,
    /// What to do.
    pub hint: &'static str,
}

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

/// What stands in the way of a crank of `engine`, or beyond it: weights on crankshafts against the ends of theirs (half a
/// throw spacing beyond the outer throws), weights on shafts a crank's length beyond them, shafts against the circles
/// of the crankpins that they pass.
pub fn room_faults(engine: &Engine, task: &BalanceTask) -> Vec<RoomFault> {
    let cranks: Vec<Option<Crank>> =
        (0..engine.crankshafts.len()).map(|index| Crank::of(engine, index)).collect();
    let of_weight = |(index, weight): (usize, &FreeWeight)| match weight.seat {
        Seat::Crankshaft(crank) => beyond(index, weight, cranks[crank].as_ref()?),
        Seat::Shaft(_) => far_beyond(index, weight, &cranks),
    };
    let weights = task.weights.iter().enumerate().filter_map(of_weight);
    let of_shaft =
        |index: usize| cranks.iter().flatten().filter_map(move |crank| in_the_way(task, index, crank));
    weights.chain((0..task.shafts.len()).flat_map(of_shaft)).collect()
}

fn beyond(index: usize, weight: &FreeWeight, crank: &Crank) -> Option<RoomFault> {
    let (first, last) = range(weight.z);
    let (front, rear) = crank.ends;
    let beyond = if first < front - SAME_PLACE {
        first
    } else if last > rear + SAME_PLACE {
        last
    } else {
        return None;
    };
    let [z, front, rear] = [beyond, front, rear].map(|z| readable(z, Dimension::Length));
    Some(RoomFault {
        device: TaskDevice::Weight(index),
        kind: RoomFaultKind::Beyond,
        message: format!(
            "\"{}\" stands beyond the crank: z = {z}, the crank runs from {front} to {rear}",
            weight.name
        ),
        hint: "right for a flywheel or a pulley; z here counts from the reference plane",
    })
}

/// A weight on a shaft may stand beyond the crank, but hardly as far as the cranks are long.
fn far_beyond(index: usize, weight: &FreeWeight, cranks: &[Option<Crank>]) -> Option<RoomFault> {
    let ends = cranks.iter().flatten().map(|crank| crank.ends);
    let (front, rear) = ends.reduce(|all, one| (all.0.min(one.0), all.1.max(one.1)))?;
    let (first, last) = range(weight.z);
    let length = rear - front;
    let z = [first, last].into_iter().find(|z| *z < front - length || *z > rear + length)?;
    let [z, front, rear] = [z, front, rear].map(|z| readable(z, Dimension::Length));
    Some(RoomFault {
        device: TaskDevice::Weight(index),
        kind: RoomFaultKind::Beyond,
        message: format!(
            "\"{}\" stands far beyond the crank: z = {z}, the crank runs from {front} to {rear}",
            weight.name
        ),
        hint: "check its plane; z here counts from the reference plane",
    })
}

/// A shaft must stay clear of the circle of the crankpins wherever it passes them.
fn in_the_way(task: &BalanceTask, index: usize, crank: &Crank) -> Option<RoomFault> {
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
        return None;
    }
    let reach =
        own.iter().filter(|weight| within(weight)).filter_map(|weight| weight.radius).fold(0.0, f64::max);
    let length = |value: f64| readable(value, Dimension::Length);
    let device = TaskDevice::Shaft(index);
    if far < crank.radius {
        let message = format!(
            "the shaft \"{}\" runs through the crank: its axis is {} from the crank's, the crankpins turn at {}",
            shaft.name,
            length(far),
            length(crank.radius)
        );
        let hint = "give x and y further out, or weights beyond the crank's ends";
        return Some(RoomFault { device, kind: RoomFaultKind::Through, message, hint });
    }
    if near < crank.radius + reach {
        let message = format!(
            "the shaft \"{}\" may strike the crank: its axis comes as near as {}, crankpins and weights reach {}",
            shaft.name,
            length(near),
            length(crank.radius + reach)
        );
        let hint = "big ends, webs and counterweights need more room still: check the places";
        return Some(RoomFault { device, kind: RoomFaultKind::Near, message, hint });
    }
    None
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
