//! Sizes of an engine that typical values are scaled from.

use super::kind::{EngineKind, Ratios};
use lanchester_model::{Engine, RodJoint, SharedWeb, Strokes, TOUCH};
use std::f64::consts::PI;

/// Share of the free length along the crank that a web takes: of the web distance, and of what is left between two throws.
const WEB_SHARE: f64 = 0.42;

/// What follows from the file.
#[derive(Debug, Clone)]
pub(super) struct Sizes<'a> {
    pub(super) engine: &'a Engine,
    pub(super) ratios: Ratios,
    /// Largest crank radius [m].
    pub(super) radius: f64,
    /// Largest bore [m], or the typical one.
    pub(super) bore: f64,
    /// Web distance [m], the smallest, or the typical one.
    pub(super) web_distance: f64,
    /// Distance between facing webs of throws that share none [m], the smallest.
    pub(super) gap: Option<f64>,
    /// Crankpin and main journal [m].
    pub(super) pin: f64,
    pub(super) journal: f64,
    /// Thickness of a web [m].
    pub(super) web: f64,
    /// Swept volume of all cylinders [m3].
    pub(super) swept: f64,
    /// Firings in a working cycle.
    pub(super) firings: f64,
    /// A working cycle over the longest pause between two firings: the firings of an evenly firing engine with that pause.
    pub(super) evenness: f64,
    /// Rods side by side on one pin, the most.
    pub(super) rods: f64,
    /// Length of the rods from crankpin to piston pin [m], the smallest.
    pub(super) rod: f64,
}

impl<'a> Sizes<'a> {
    pub(super) fn of(engine: &'a Engine, kind: EngineKind) -> Sizes<'a> {
        let ratios = kind.ratios();
        let radius = engine.throws.iter().fold(0.0_f64, |most, throw| most.max(throw.radius));
        let given = engine.cylinders.iter().filter_map(|cylinder| cylinder.bore).fold(0.0_f64, f64::max);
        let bay = neighbours(engine).map(|[a, b]| b - a).min_by(f64::total_cmp);
        let bore = match given > 0.0 {
            true => given,
            false => {
                let usual = ratios.bore_over_stroke * 2.0 * radius;
                nearest_axes(engine).map_or(usual, |distance| usual.min(0.88 * distance))
            }
        };
        let rods = rods_side_by_side(engine);
        let web_distance = engine
            .throws
            .iter()
            .filter_map(|throw| throw.webs.map(|[front, rear]| rear - front))
            .min_by(f64::total_cmp)
            .unwrap_or_else(|| typical_web_distance(engine, bore, bay, ratios.pin_over_bore * bore, rods));
        let gap = gap(engine, web_distance);
        let room = gap.map_or(web_distance, |gap| gap.min(web_distance));
        // A pin of more than its stroke would be thicker than the crank needs: short strokes have thinner ones.
        let pin = super::words::as_written((ratios.pin_over_bore * bore).min(1.6 * radius));
        let journal = super::words::as_written((ratios.journal_over_bore * bore).min(1.8 * radius).max(pin));
        // Pins of a pair with nothing between them touch: the web is as thick as their webs reach over one another.
        let shared = SharedWeb::all(&engine.throws);
        let over = shared.iter().filter_map(|shared| {
            let ([_, end], [start, _]) =
                (engine.throws[shared.front].webs?, engine.throws[shared.rear].webs?);
            Some(end - start)
        });
        let least = over.fold(0.0_f64, f64::max);
        let web = super::words::as_written((0.22 * bore).min(WEB_SHARE * room).max(least));
        let chambers = engine.cylinders.iter().filter(|cylinder| cylinder.chamber.is_none()).count() as f64;
        let area = |bore: f64| PI / 4.0 * bore * bore;
        let swept = engine
            .cylinders
            .iter()
            .map(|cylinder| {
                let stroke = engine.throws.get(cylinder.throw).map_or(radius, |throw| throw.radius) * 2.0;
                area(cylinder.bore.unwrap_or(bore)) * stroke
            })
            .sum();
        let rod = engine
            .cylinders
            .iter()
            .map(|cylinder| match cylinder.rod.joint {
                RodJoint::Articulated { knuckle_radius, .. } => cylinder.rod.length + knuckle_radius,
                _ => cylinder.rod.length,
            })
            .fold(f64::INFINITY, f64::min);
        Sizes {
            engine,
            ratios,
            radius,
            bore,
            web_distance,
            gap,
            pin,
            journal,
            web,
            swept,
            firings: chambers,
            evenness: evenness(engine),
            rods,
            rod,
        }
    }

    /// Fuel of one cycle over the swept volume [J/m3]: a two-stroke engine holds less fresh gas.
    pub(super) fn energy(&self) -> f64 {
        let share = if self.engine.strokes == Strokes::Two { 0.6 } else { 1.0 };
        self.ratios.energy * share
    }

    /// Length of the pins [m].
    pub(super) fn pin_length(&self) -> f64 {
        self.web_distance - self.web
    }

    /// Width of a rod's big end [m].
    pub(super) fn rod_width(&self) -> f64 {
        (0.96 * self.pin_length() / self.rods).min(0.5 * self.bore)
    }

    /// Width of a main bearing [m]: nearly the journal between the webs.
    pub(super) fn main_width(&self) -> f64 {
        let usual = 0.36 * self.journal;
        self.gap.map_or(usual, |gap| usual.min(0.92 * (gap - self.web)))
    }

    /// Largest unbalance of a counterweight on one web [kg m]; a weight in the plane of a throw is two of them.
    pub(super) fn unbalance_of_web(&self) -> f64 {
        let engine = self.engine;
        let is_on_web = |z: f64| {
            engine.throws.iter().filter_map(|throw| throw.webs).flatten().any(|web| (web - z).abs() < 1e-6)
        };
        let of = |weight: &lanchester_model::Counterweight| match is_on_web(weight.z) {
            true => weight.unbalance,
            false => weight.unbalance / 2.0,
        };
        engine.counterweights.iter().map(of).fold(0.0, f64::max)
    }
}

/// A working cycle over the longest pause between two firings; 1 where the file gives no firing.
fn evenness(engine: &Engine) -> f64 {
    let cycle = 2.0 * PI * f64::from(engine.strokes.revolutions());
    let mut angles: Vec<f64> =
        engine.cylinders.iter().filter_map(|c| c.firing_angle).map(|angle| angle.rem_euclid(cycle)).collect();
    angles.sort_by(f64::total_cmp);
    let Some(first) = angles.first().copied() else { return 1.0 };
    angles.push(first + cycle);
    let longest = angles.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0_f64, f64::max);
    cycle / longest
}

/// Planes of neighbouring throws on one crankshaft [m], front then rear.
fn neighbours(engine: &Engine) -> impl Iterator<Item = [f64; 2]> {
    let mut planes: Vec<(usize, f64)> = engine.throws.iter().map(|t| (t.crankshaft, t.z)).collect();
    planes.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    planes
        .windows(2)
        .filter(|pair| pair[0].0 == pair[1].0 && pair[1].1 - pair[0].1 > TOUCH)
        .map(|pair| [pair[0].1, pair[1].1])
        .collect::<Vec<_>>()
        .into_iter()
}

/// Smallest distance along the crank of two cylinders with one direction [m].
fn nearest_axes(engine: &Engine) -> Option<f64> {
    let mut least: Option<f64> = None;
    for (index, one) in engine.cylinders.iter().enumerate() {
        for other in &engine.cylinders[..index] {
            let turn = (one.angle - other.angle).rem_euclid(2.0 * PI);
            let distance = (one.z - other.z).abs();
            if turn.min(2.0 * PI - turn) < 0.05 && distance > TOUCH {
                least = Some(least.map_or(distance, |least| least.min(distance)));
            }
        }
    }
    least
}

/// Rods beside one another on a pin, the most: a fork holds its blade, articulated rods sit on their master.
fn rods_side_by_side(engine: &Engine) -> f64 {
    let of = |throw: usize| {
        let beside = engine.cylinders.iter().filter(|cylinder| {
            cylinder.throw == throw
                && !matches!(cylinder.rod.joint, RodJoint::Articulated { .. } | RodJoint::Blade)
        });
        beside.count()
    };
    (0..engine.throws.len()).map(of).max().unwrap_or(1).max(1) as f64
}

/// Distance between the facing webs of neighbouring throws that share none [m], the smallest.
fn gap(engine: &Engine, web_distance: f64) -> Option<f64> {
    let has_webs = engine.throws.iter().all(|throw| throw.webs.is_some());
    let shared = SharedWeb::all(&engine.throws);
    if !has_webs {
        return neighbours(engine)
            .map(|[a, b]| b - a - web_distance)
            .filter(|gap| *gap > TOUCH)
            .min_by(f64::total_cmp);
    }
    let mut webs: Vec<(usize, [f64; 2], usize)> = engine
        .throws
        .iter()
        .enumerate()
        .filter_map(|(index, throw)| Some((throw.crankshaft, throw.webs?, index)))
        .collect();
    webs.sort_by(|a, b| a.0.cmp(&b.0).then(a.1[0].total_cmp(&b.1[0])));
    webs.windows(2)
        .filter(|pair| pair[0].0 == pair[1].0)
        .filter(|pair| !shared.iter().any(|s| s.front == pair[0].2 && s.rear == pair[1].2))
        .map(|pair| pair[1].1[0] - pair[0].1[1])
        .filter(|gap| *gap > TOUCH)
        .min_by(f64::total_cmp)
}

/// A web distance that leaves room for the rods, and for a main bearing or one web to the next throw.
fn typical_web_distance(engine: &Engine, bore: f64, bay: Option<f64>, pin: f64, rods: f64) -> f64 {
    let rod = 0.26 * bore;
    let usual = rods * rod + 0.22 * bore;
    let distance = match bay {
        None => usual,
        // Pins of a pair, close to each other: they touch where they overlap across, else one web is between them.
        Some(bay) if bay < 0.5 * bore => {
            let mut pins: Vec<&lanchester_model::Throw> = engine.throws.iter().collect();
            pins.sort_by(|a, b| a.z.total_cmp(&b.z));
            let apart =
                pins.windows(2).find(|pair| pair[1].z - pair[0].z < bay + TOUCH).map_or(0.0, |pair| {
                    2.0 * pair[0].radius * ((pair[1].angle - pair[0].angle) / 2.0).sin().abs()
                });
            if apart < 0.7 * pin { bay + 0.2 * bore } else { bay }
        }
        Some(bay) => usual.min(0.54 * bay),
    };
    super::words::as_written(distance)
}
