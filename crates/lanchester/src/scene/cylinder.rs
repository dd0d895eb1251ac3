//! Pistons, rods and liners with their motion.

use super::mesh::rounded;
use super::{Builder, STEPS, SceneKind, SceneMotion, ScenePart, part};
use lanchester_mechanism::{RodLinkage, RodPlace};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// The motion of a cylinder's rod and piston, step by step over one revolution of its crankshaft.
pub(super) struct Poses {
    /// Angle of crankshaft 1 after which they repeat [rad].
    pub period: f64,
    /// At even steps.
    pub places: Vec<RodPlace>,
}

impl Poses {
    fn travel(&self) -> impl Iterator<Item = f64> {
        self.places.iter().map(|place| place.travel[0])
    }

    /// Travel at bottom and top dead centre, to within a step [m].
    pub fn ends(&self) -> [f64; 2] {
        let most = self.travel().fold(f64::NEG_INFINITY, f64::max);
        [self.travel().fold(f64::INFINITY, f64::min), most]
    }
}

impl Builder<'_> {
    /// Poses of a cylinder; none of a linkage that does not turn.
    pub(super) fn poses(&self, index: usize) -> Option<Poses> {
        let linkage = RodLinkage::new(self.engine, index).ok()?;
        let throw = &self.engine.throws[self.engine.cylinders[index].throw];
        let period = TAU / self.engine.crankshafts[throw.crankshaft].ratio.value().abs();
        let places = (0..STEPS).map(|step| linkage.at(period * step as f64 / STEPS as f64)).collect();
        Some(Poses { period, places })
    }

    /// Rod, piston and liner of a cylinder.
    pub(super) fn cylinder(&mut self, index: usize) {
        let Some(poses) = self.poses(index) else { return };
        let cylinder = &self.engine.cylinders[index];
        let crankshaft = &self.engine.crankshafts[self.engine.throws[cylinder.throw].crankshaft];
        let centre = Complex64::new(crankshaft.x, crankshaft.y);
        let foot = centre + Complex64::from_polar(cylinder.offset, cylinder.angle) * Complex64::I;
        let (z, angle, period) = (rounded(cylinder.z), rounded(cylinder.angle), poses.period);
        let number = index + 1;
        let of = |name: &str, kind, path: &str, motion| ScenePart {
            cylinder: Some(number),
            ..part(format!("{name} {number}"), kind, path, motion)
        };

        let place = |step: &RodPlace| centre + step.lower_pin[0];
        let swing = SceneMotion::Swing {
            x: poses.places.iter().map(|step| rounded(place(step).re)).collect(),
            y: poses.places.iter().map(|step| rounded(place(step).im)).collect(),
            z,
            angle: poses.places.iter().map(|step| rounded(step.direction[0])).collect(),
            period,
        };
        let slide = SceneMotion::Slide {
            x: rounded(foot.re),
            y: rounded(foot.im),
            z,
            angle,
            period,
            travel: poses.travel().map(rounded).collect(),
        };
        let fixed = SceneMotion::Fixed { x: rounded(foot.re), y: rounded(foot.im), z, angle };
        let (rod, piston, liner) = (self.rod(index), self.piston(index, &poses), self.liner(index, &poses));
        self.add(rod, of("rod", SceneKind::Rod, "rod.length", swing));
        self.add(piston, of("piston", SceneKind::Piston, "piston.mass", slide));
        self.add(liner, of("bore", SceneKind::Bore, "piston.bore", fixed));
    }

    /// Distance from the axis of crankshaft `index` that pistons leave free [m].
    pub(super) fn room_below(&self, index: usize) -> f64 {
        let own =
            |cylinder: &usize| self.engine.throws[self.engine.cylinders[*cylinder].throw].crankshaft == index;
        let below = |cylinder: usize| Some(self.poses(cylinder)?.ends()[0] - self.skirt(cylinder));
        0.97 * (0..self.engine.cylinders.len()).filter(own).filter_map(below).fold(f64::INFINITY, f64::min)
    }
}
