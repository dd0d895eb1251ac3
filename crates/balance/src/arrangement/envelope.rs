//! What a balance shaft must clear in the plane across the crank: crank sweep, rods and cylinders.
//!
//! Everything is projected along the crank axis: a shaft and its weights pass the whole engine. A rod at a crank
//! angle is a disc about its big end and a strip from there to the piston pin; a cylinder is the half strip of its
//! bore with the wall, from the lower edge of the piston at bottom dead centre outwards.

use crate::arrangement::request::PartSizes;
use lanchester_model::{Engine, RodJoint};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Crank angles of a turn at which the rods are looked at. Between two of them a big end moves by `pi r/180`, less
/// than a millimetre of lateral error on a common crank.
const ANGLES: usize = 120;

/// A rod at one crank angle.
#[derive(Debug, Clone, Copy, PartialEq)]
struct RodPose {
    big_end: Complex64,
    pin: Complex64,
    cylinder: usize,
    theta: f64,
}

/// A cylinder's bore.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bore {
    /// Middle of the lower edge of the piston at its lowest.
    foot: Complex64,
    axis: Complex64,
    half_width: f64,
    cylinder: usize,
}

/// Everything that moves or stands in the way of shafts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Envelope {
    /// Axis and swept radius of every crankshaft.
    pub cranks: Vec<(Complex64, f64)>,
    /// Radius of the bare crankshaft beyond its throws [m].
    pub journal_radius: f64,
    big_end_radius: f64,
    rod_half_width: f64,
    rods: Vec<RodPose>,
    bores: Vec<Bore>,
}

/// The nearest part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Nearest {
    /// Distance from the point to the part's surface [m].
    pub distance: f64,
    /// Which part.
    pub part: Obstacle,
}

/// A part of the engine that a shaft may come near to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Obstacle {
    /// Sweep of a crankshaft, by index.
    CrankSweep(usize),
    /// Rod of a cylinder, by index, at a crank angle.
    Rod(usize, f64),
    /// Bore of a cylinder, by index.
    Cylinder(usize),
}

impl Obstacle {
    /// In words.
    pub fn name(self) -> String {
        match self {
            Obstacle::CrankSweep(0) => "the crank sweep".to_owned(),
            Obstacle::CrankSweep(index) => format!("the sweep of crankshaft {}", index + 1),
            Obstacle::Rod(cylinder, theta) => {
                format!("the rod of cylinder {} at {:.0} deg", cylinder + 1, theta.to_degrees())
            }
            Obstacle::Cylinder(cylinder) => format!("the wall of cylinder {}", cylinder + 1),
        }
    }
}

/// Ratio of a piston's height below its pin to the bore, for the lower edge of the bore.
const SKIRT: f64 = 0.35;

impl Envelope {
    pub fn of(engine: &Engine, parts: &PartSizes) -> Envelope {
        let crank_radius = engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius));
        let big_end_radius = parts.big_end_radius.unwrap_or(0.75 * crank_radius);
        let mut rods = Vec::with_capacity(ANGLES * engine.cylinders.len());
        let mut bores: Vec<Bore> = Vec::new();
        for (index, cylinder) in engine.cylinders.iter().enumerate() {
            let ratio = engine.crankshafts[engine.throws[cylinder.throw].crankshaft].ratio.value().abs();
            let turn = TAU / ratio;
            let axis = Complex64::cis(cylinder.angle);
            let mut lowest = f64::INFINITY;
            let mut foot = Complex64::ZERO;
            for step in 0..ANGLES {
                let theta = turn * step as f64 / ANGLES as f64;
                let [big_end, pin] = rod_at(engine, index, theta);
                rods.push(RodPose { big_end, pin, cylinder: index, theta });
                let height = (pin / axis).re;
                if height < lowest {
                    (lowest, foot) = (height, pin);
                }
            }
            if let Some(bore) = cylinder.bore {
                let foot = foot - axis * Complex64::new(SKIRT * bore, cylinder.pin_offset);
                let half_width = 0.5 * bore + parts.cylinder_wall;
                let twin = |b: &Bore| (b.foot - foot).norm() < 1e-6 * bore && (b.axis - axis).norm() < 1e-9;
                if !bores.iter().any(twin) {
                    bores.push(Bore { foot, axis, half_width, cylinder: index });
                }
            }
        }
        let sweep = |crankshaft: usize| {
            let radius = engine.throws.iter().filter(|t| t.crankshaft == crankshaft);
            let radius = radius.fold(0.0f64, |m, t| m.max(t.radius));
            parts.crank_sweep.unwrap_or(radius + big_end_radius)
        };
        Envelope {
            cranks: (engine.crankshafts.iter().enumerate())
                .map(|(index, c)| (Complex64::new(c.x, c.y), sweep(index)))
                .collect(),
            journal_radius: parts.crank_journal_radius.unwrap_or(0.5 * crank_radius),
            big_end_radius,
            rod_half_width: 0.5 * parts.rod_width.unwrap_or(0.5 * crank_radius),
            rods: without_doubles(rods),
            bores,
        }
    }

    /// The part nearest to `point`; negative distances lie inside.
    pub fn nearest(&self, point: Complex64) -> Nearest {
        let mut nearest = Nearest { distance: f64::INFINITY, part: Obstacle::CrankSweep(0) };
        let mut take = |distance: f64, part: Obstacle| {
            if distance < nearest.distance {
                nearest = Nearest { distance, part };
            }
        };
        for (index, (axis, radius)) in self.cranks.iter().enumerate() {
            take((point - axis).norm() - radius, Obstacle::CrankSweep(index));
        }
        for rod in &self.rods {
            let shank = distance_to_segment(point, rod.big_end, rod.pin) - self.rod_half_width;
            let eye = (point - rod.big_end).norm() - self.big_end_radius;
            take(shank.min(eye), Obstacle::Rod(rod.cylinder, rod.theta));
        }
        for bore in &self.bores {
            let local = (point - bore.foot) / bore.axis;
            let (below, beside) = (-local.re, local.im.abs() - bore.half_width);
            let distance = if below > 0.0 && beside > 0.0 { below.hypot(beside) } else { below.max(beside) };
            take(distance, Obstacle::Cylinder(bore.cylinder));
        }
        nearest
    }
}

/// Rods that coincide in the projection at the same angle once.
fn without_doubles(rods: Vec<RodPose>) -> Vec<RodPose> {
    let mut kept: Vec<RodPose> = Vec::with_capacity(rods.len());
    let mut seen = std::collections::HashSet::new();
    for rod in rods {
        // A micrometre tells positions apart well enough for a clearance.
        let key = [rod.big_end.re, rod.big_end.im, rod.pin.re, rod.pin.im].map(|v| (v * 1e6).round() as i64);
        if seen.insert(key) {
            kept.push(rod);
        }
    }
    kept
}

/// Big end and piston pin of cylinder `index` at crank angle `theta` [rad].
fn rod_at(engine: &Engine, index: usize, theta: f64) -> [Complex64; 2] {
    let cylinder = &engine.cylinders[index];
    let throw = &engine.throws[cylinder.throw];
    let shaft = &engine.crankshafts[throw.crankshaft];
    let centre = Complex64::new(shaft.x, shaft.y);
    let crankpin = centre + Complex64::from_polar(throw.radius, engine.pin_angle(cylinder.throw, theta));
    let big_end = match cylinder.rod.joint {
        RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
            let line = piston_pin(engine, master, centre, crankpin) - crankpin;
            crankpin + Complex64::from_polar(knuckle_radius, line.arg() + knuckle_angle)
        }
        RodJoint::Crankpin | RodJoint::Fork | RodJoint::Blade => crankpin,
    };
    [big_end, piston_pin(engine, index, centre, big_end)]
}

/// The piston pin of cylinder `index`: on its line, one rod length from the big end.
fn piston_pin(engine: &Engine, index: usize, centre: Complex64, big_end: Complex64) -> Complex64 {
    let cylinder = &engine.cylinders[index];
    let axis = Complex64::cis(cylinder.angle);
    let local = (big_end - centre) / axis;
    let offset = cylinder.net_offset();
    let reach = (cylinder.rod.length.powi(2) - (local.im - offset).powi(2)).max(0.0).sqrt();
    centre + axis * Complex64::new(local.re + reach, offset)
}

/// Distance [m] from a point to a straight line between two others.
fn distance_to_segment(point: Complex64, from: Complex64, to: Complex64) -> f64 {
    let along = to - from;
    let length = along.norm_sqr();
    if length == 0.0 {
        return (point - from).norm();
    }
    let at = (((point - from) * along.conj()).re / length).clamp(0.0, 1.0);
    (point - from - along * at).norm()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arrangement::sample::twin;

    #[test]
    fn below_the_crank_its_sweep_is_nearest_and_beside_the_bore_a_rod() {
        let engine = twin();
        let parts = PartSizes { crank_sweep: Some(0.09), ..PartSizes::default() };
        let envelope = Envelope::of(&engine, &parts);
        let below = envelope.nearest(Complex64::new(-0.15, 0.0));
        assert_eq!(below.part, Obstacle::CrankSweep(0));
        assert!((below.distance - 0.06).abs() < 1e-12);
        // A light crank leaves the big end as the nearest part beside the bore.
        let light = PartSizes { crank_sweep: Some(0.05), ..parts };
        let beside = Envelope::of(&engine, &light).nearest(Complex64::new(0.05, 0.09));
        assert!(matches!(beside.part, Obstacle::Rod(..)), "{beside:?}");
        let inside = envelope.nearest(Complex64::new(0.25, 0.0));
        assert!(inside.distance < 0.0 && matches!(inside.part, Obstacle::Cylinder(_)), "{inside:?}");
    }

    #[test]
    fn a_rod_envelope_is_the_union_over_all_angles() {
        let engine = twin();
        let parts = PartSizes { crank_sweep: Some(1e-6), ..PartSizes::default() };
        let mut engine = engine;
        engine = engine
            .with(|engine| {
                engine.cylinders.iter_mut().for_each(|c| c.bore = None);
            })
            .expect("an engine");
        let envelope = Envelope::of(&engine, &parts);
        let radius = engine.throws[0].radius;
        // Straight below, the big end at bottom dead centre is the farthest part.
        let below = envelope.nearest(Complex64::new(-0.2, 0.0));
        assert!((below.distance - (0.2 - 1.75 * radius)).abs() < 1e-12, "{below:?}");
        // A scan 40 times finer is nowhere closer by more than the step's sagitta.
        let point = Complex64::new(0.07, 0.10);
        let fine = (0..40 * ANGLES)
            .map(|k| {
                let [big_end, pin] = rod_at(&engine, 0, TAU * k as f64 / (40 * ANGLES) as f64);
                let shank = distance_to_segment(point, big_end, pin) - envelope.rod_half_width;
                shank.min((point - big_end).norm() - envelope.big_end_radius)
            })
            .fold(f64::INFINITY, f64::min);
        let coarse = envelope.nearest(point).distance;
        assert!(coarse >= fine && coarse - fine < 1e-4, "{coarse} {fine}");
    }
}
