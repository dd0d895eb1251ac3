//! Pictures of what events do: the time about them, and the orders of a period before and of one after.

use crate::kit::figure::{Figure, Panel};
use crate::kit::xy_plot::XyCurve;
use crate::simulated::figure::{curve, figure, fitted, orbit};
use crate::simulated::period::period_before;
use crate::simulated::result::SimulationResult;
use lanchester_multibody::Occasion;
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// Shares of a run's time that are shown before and after an event.
const BEFORE: f64 = 0.01;
const AFTER: f64 = 0.05;

/// Periods of a run below which its course is seen without windows, and most windows and changes that are drawn.
const LONG: f64 = 40.0;
const MOST: usize = 5;

/// Highest order of the pictures of changes.
const HIGHEST: f64 = 6.0;

/// Number, time and words of every event, from 1.
pub(super) fn numbered(result: &SimulationResult) -> Vec<(usize, f64, String)> {
    let events = result.run.events.iter().filter(|event| event.time.is_finite()).enumerate();
    events.map(|(k, event)| (k + 1, event.time, result.happened(event.what))).collect()
}

/// The events in one sentence, with their numbers; empty without any.
pub(super) fn sentence(events: &[(usize, f64, String)]) -> String {
    match events.is_empty() {
        true => String::new(),
        false => {
            let named = events.iter().map(|(number, _, what)| format!("{number} {what}"));
            format!(" Events: {}.", named.collect::<Vec<_>>().join(", "))
        }
    }
}

/// The time about the events of a long run: speed, and roll of the block where it moves.
pub(super) fn about_events(result: &SimulationResult) -> Option<Figure> {
    let samples = &result.run.samples;
    let (start, end) = (*samples.time.first()?, *samples.time.last()?);
    let span = end - start;
    let turned = samples.theta.last()? - samples.theta.first()?;
    let all = numbered(result);
    if all.is_empty() || turned < LONG * TAU * f64::from(result.revolutions) {
        return None;
    }
    let mut windows: Vec<[f64; 2]> = Vec::new();
    for (_, time, _) in &all {
        match windows.last_mut() {
            Some(window) if time - window[1] <= 0.0 => window[1] = time + AFTER * span,
            _ => windows.push([time - BEFORE * span, time + AFTER * span]),
        }
    }
    windows.truncate(MOST);
    let mut panels = Vec::new();
    let mut shown = Vec::new();
    for [from, to] in windows {
        let inside =
            samples.time.partition_point(|at| *at < from)..samples.time.partition_point(|at| *at <= to);
        if inside.len() < 3 {
            continue;
        }
        let times = &samples.time[inside.clone()];
        let marks: Vec<(f64, usize)> = all
            .iter()
            .filter(|(_, time, _)| (from..=to).contains(time))
            .map(|(number, time, _)| (*time, *number))
            .collect();
        shown.extend(all.iter().filter(|(number, ..)| marks.iter().any(|(_, own)| own == number)).cloned());
        let rpm = samples.speed[inside.clone()].iter().map(|speed| speed * 30.0 / PI);
        let speed = curve("speed", 0, times.iter().copied().zip(rpm).collect());
        panels.push(fitted(["time", "speed"], ["s", "rpm"], &marks, vec![speed]));
        if let Some(turns) = samples.orientation.get(inside).filter(|turns| !turns.is_empty()) {
            let roll = turns.iter().map(|q| 2.0 * q[3].atan2(q[0]));
            let roll = curve("roll", 0, times.iter().copied().zip(roll).collect());
            panels.push(fitted(["time", "roll of the block"], ["s", "rad"], &marks, vec![roll]));
        }
    }
    shown.dedup();
    let what = if samples.orientation.is_empty() { "Speed" } else { "Speed and roll of the block" };
    let caption = format!("{what} about the events of the run.{}", sentence(&shown));
    (!panels.is_empty()).then(|| figure("simulated-events", "About the events", &caption, panels))
}

/// Parts of one order of the roll moment, and of the path of the block's origin.
struct Around {
    range: Range<usize>,
    /// Order and amplitude of the roll moment [N m].
    roll: Vec<(f64, f64)>,
}

fn around(result: &SimulationResult, range: Range<usize>) -> Around {
    let samples = &result.run.samples;
    let turns = f64::from(result.revolutions);
    let count = range.len() - 1;
    let loads = samples.block_loads(range.start..range.start + count);
    let highest = (HIGHEST * turns).min(count as f64 / 4.0) as u32;
    let roll = (1..=highest).map(|cycles| {
        let order = f64::from(cycles) / turns;
        (order, loads.order(order, TAU * turns).roll_moment.norm())
    });
    Around { range, roll: roll.collect() }
}

/// What an event of the list changes in a run that turns on: orders of the roll moment and path of the block in the last whole period before it, and in the last one before the next event.
pub(super) fn changes(result: &SimulationResult) -> Vec<Figure> {
    let samples = &result.run.samples;
    let events = &result.run.events;
    if samples.reactions.is_empty() {
        return Vec::new();
    }
    let of_list = events.iter().enumerate().filter(|(_, event)| matches!(event.what, Occasion::Event { .. }));
    let mut figures = Vec::new();
    for (place, event) in of_list {
        let last = |theta: f64| period_before(samples, result.revolutions, theta);
        let previous = place.checked_sub(1).map_or(f64::NEG_INFINITY, |k| events[k].time);
        let next = events.get(place + 1);
        let ends = next.map_or(f64::INFINITY, |next| next.theta);
        let (Some(before), Some(after)) = (last(event.theta), last(ends)) else { continue };
        // Neither period may have an event in it.
        let is_clear = samples.time[before.start] >= previous && samples.time[after.start] >= event.time;
        if !is_clear || figures.len() == MOST {
            continue;
        }
        let what = result.happened(event.what);
        let both = [before, after].map(|range| around(result, range));
        let comb = |own: &Around| -> Vec<(f64, f64)> {
            // A comb: up and down at every order.
            own.roll.iter().flat_map(|&(order, size)| [(order, 0.0), (order, size), (order, 0.0)]).collect()
        };
        let shifted =
            |points: Vec<(f64, f64)>, by: f64| points.into_iter().map(move |(x, y)| (x + by, y)).collect();
        let curves: Vec<XyCurve> = vec![
            curve("before", 0, shifted(comb(&both[0]), -0.04)),
            curve("after", 2, shifted(comb(&both[1]), 0.04)),
        ];
        let mut panels: Vec<Panel> =
            vec![crate::simulated::figure::panel(["order", "roll moment"], ["1", "N m"], None, curves)];
        let mut drawn = String::new();
        if !samples.position.is_empty() {
            let path = |own: &Around| -> Vec<(f64, f64)> {
                let places = &samples.position[own.range.clone()];
                let count = places.len() as f64;
                let mean = [0, 1].map(|k| places.iter().map(|p| p[k]).sum::<f64>() / count);
                places.iter().map(|p| (p[1] - mean[1], p[0] - mean[0])).collect()
            };
            let curves = vec![curve("before", 0, path(&both[0])), curve("after", 2, path(&both[1]))];
            let (panel, words) = orbit(["y", "x"], curves);
            panels.push(panel);
            drawn = format!(" The path of the block's origin about its mean place is {words}.");
        }
        let caption = format!(
            "The last whole period before the event, and the last one before {}: amplitude of the roll moment on the block by order.{drawn}",
            if next.is_some() { "the next event" } else { "the end of the run" }
        );
        let title = format!("Before and after: {what}");
        figures.push(figure(&format!("simulated-change-{}", place + 1), &title, &caption, panels));
    }
    figures
}
