//! Where the gas of every cylinder counts from: the dead centre of its chamber next to the firing of the file.

use crate::place::Place;
use crate::train::Train;
use lanchester_model::Engine;
use std::f64::consts::TAU;

/// Angles of a turn that are scanned before the dead centre is refined.
const SCAN: u32 = 720;

/// Halvings of one step of the scan: below rounding.
const HALVINGS: u32 = 60;

impl Train {
    /// Sets the firing angle of every cylinder to the dead centre next to it, where the volume of its chamber is least; a lone cylinder needs no
    /// firing in the file.
    pub(crate) fn find_firings(&mut self, engine: &Engine) {
        for first in 0..self.cylinders.len() {
            let pistons = engine.chamber_pistons(first);
            if pistons.first() != Some(&first) {
                continue;
            }
            let lone = (self.cylinders.len() == pistons.len()).then_some(0.0);
            let Some(nominal) = engine.cylinders[first].firing_angle.or(lone) else { continue };
            let turn = TAU / self.ratio(first).abs();
            let top = self.top_dead_centre(&pistons, turn);
            let firing = top + turn * ((nominal - top) / turn).round();
            for index in pistons {
                self.cylinders[index].firing_angle = Some(firing);
            }
        }
    }

    /// `theta` [rad] from 0 to `turn` where the pistons together fill most of their chamber.
    fn top_dead_centre(&self, pistons: &[usize], turn: f64) -> f64 {
        let mut places: Vec<Place> = Vec::new();
        let mut filled = |theta: f64| {
            self.places_into(theta, &mut places);
            let sum = |k: usize| {
                pistons
                    .iter()
                    .map(|&p| self.cylinders[p].area.unwrap_or(1.0) * places[p].travel[k])
                    .sum::<f64>()
            };
            [sum(0), sum(1)]
        };
        let step = turn / f64::from(SCAN);
        let mut best = (0.0, f64::NEG_INFINITY);
        for k in 0..SCAN {
            let theta = step * f64::from(k);
            let [volume, _] = filled(theta);
            if volume > best.1 {
                best = (theta, volume);
            }
        }
        let (mut low, mut high) = (best.0 - step, best.0 + step);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if filled(middle)[1] > 0.0 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}
