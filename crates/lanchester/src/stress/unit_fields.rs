//! Displacement and stress of the surface of a crankshaft under unit loads: every instant of the cycle is a sum of them.
//!
//! A force on a pin is a pressure over the half of its surface that faces it, so its pattern turns with the force. At every node displacement
//! and stress under a unit force in the direction `a` are a Fourier series, whose coefficients come from unit forces in twelve directions:
//!
//! ```text
//! s(a) = c_0 + SUM (c_n cos n a + d_n sin n a)         n = 1, 2, 4
//! ```
//! A pressure cos(a) over 180 degrees has no other odd term, and the next even one is 2 % of the largest pressure.

use crate::stress::request::StressError;
use lanchester_flex::case::StaticCase;
use lanchester_flex::crank_case::{BearingSurfaces, PinLoad, PinPressure, load_pin};
use lanchester_flex::mesh::Mesh;
use lanchester_flex::sparse::SolveReport;
use lanchester_flex::statics::{StaticSolution, StaticSystem, node_stresses};
use lanchester_mechanism::ThrowForce;
use std::f64::consts::TAU;

/// Directions of unit forces on each pin.
pub(crate) const DIRECTIONS: usize = 12;

/// Harmonics of the direction that count, besides the mean.
const HARMONICS: [usize; 3] = [1, 2, 4];

/// Fields of a pin: the mean, then cosine and sine of each harmonic.
const PER_PIN: usize = 1 + 2 * HARMONICS.len();

/// Cases that are solved at once: before each such block it is heard whether somebody still waits.
const BLOCK: usize = DIRECTIONS;

/// Size of a unit force [N].
const UNIT: f64 = 1000.0;

/// Displacement (x, y, z) [m] and stress (xx, yy, zz, xy, yz, zx) [Pa] of a node, under a load of one newton, or a speed of one radian a second.
pub type NodeField = [f32; 9];

/// Coefficients of the fields of a pin at a direction `angle` of a force of `size`.
fn coefficients(size: f64, angle: f64) -> [f64; PER_PIN] {
    std::array::from_fn(|k| match k.checked_sub(1) {
        None => size,
        Some(k) => {
            let (sin, cos) = (HARMONICS[k / 2] as f64 * angle).sin_cos();
            size * if k % 2 == 0 { cos } else { sin }
        }
    })
}

/// What is solved for unit loads.
pub(crate) struct UnitFields {
    /// Indices of the throws, pin by pin.
    throws: Vec<usize>,
    /// Those of each pin, then that of the centrifugal field; each with one entry for each node of the surface.
    pub fields: Vec<Vec<NodeField>>,
    /// Of the last block.
    pub report: SolveReport,
}

/// What unit loads are solved on.
pub(crate) struct Solved<'a, 'b> {
    pub mesh: &'a Mesh,
    pub surfaces: &'a BearingSurfaces,
    /// Supports without loads.
    pub base: &'a StaticCase,
    pub system: &'a mut StaticSystem<'b>,
    /// Nodes of the surface.
    pub nodes: &'a [u32],
    /// Whether somebody waits for the answer.
    pub waits: &'a dyn Fn() -> bool,
}

impl Solved<'_, '_> {
    /// Solves cases, block by block.
    pub(crate) fn each(
        &mut self,
        cases: &[StaticCase],
        see: &mut dyn FnMut(usize, StaticSolution),
    ) -> Result<(), StressError> {
        for (block, own) in cases.chunks(BLOCK).enumerate() {
            if !(self.waits)() {
                return Err(StressError::Cancelled);
            }
            let solutions = self.system.solve(&own.iter().collect::<Vec<_>>())?;
            for (k, solution) in solutions.into_iter().enumerate() {
                see(block * BLOCK + k, solution);
            }
        }
        Ok(())
    }

    /// Adds a solution to fields, each with its weight.
    fn add(&self, fields: &mut [Vec<[f64; 9]>], solution: &StaticSolution, weights: &[f64]) {
        let stresses = node_stresses(self.mesh, &solution.displacements);
        for (place, node) in self.nodes.iter().enumerate() {
            let [x, y, z] = solution.displacements[*node as usize];
            let [a, b, c, d, e, f] = stresses[*node as usize].stress.0;
            let values = [x, y, z, a, b, c, d, e, f];
            for (field, weight) in fields.iter_mut().zip(weights) {
                for (sum, value) in field[place].iter_mut().zip(values) {
                    *sum += weight * value;
                }
            }
        }
    }
}

impl UnitFields {
    /// Solves the unit loads of the pins of these throws, and the centrifugal field at a speed [rad/s].
    pub(crate) fn new(
        throws: Vec<usize>,
        speed: f64,
        solved: &mut Solved,
    ) -> Result<UnitFields, StressError> {
        let (mut fields, mut report) = (Vec::new(), None);
        for throw in &throws {
            let angle = |k: usize| TAU * k as f64 / DIRECTIONS as f64;
            let case = |k: usize| {
                let (sin, cos) = angle(k).sin_cos();
                let load = PinLoad { pin: throw + 1, force: [UNIT * cos, UNIT * sin] };
                load_pin(solved.surfaces, solved.base.clone(), load, PinPressure::Cosine)
            };
            let cases = (0..DIRECTIONS).map(case).collect::<Result<Vec<_>, _>>()?;
            let mut solutions: Vec<StaticSolution> = Vec::with_capacity(DIRECTIONS);
            solved.each(&cases, &mut |_, solution| solutions.push(solution))?;
            let mut own = vec![vec![[0.0; 9]; solved.nodes.len()]; PER_PIN];
            for (k, solution) in solutions.iter().enumerate() {
                // Of the mean 1/N, of the harmonics 2/N.
                let mut weights = coefficients(2.0 / (DIRECTIONS as f64 * UNIT), angle(k));
                weights[0] *= 0.5;
                solved.add(&mut own, solution, &weights);
            }
            fields.extend(own.iter().map(|field| narrow(field)));
        }
        let turning = StaticCase { speed, ..solved.base.clone() };
        let mut own = [vec![[0.0; 9]; solved.nodes.len()]];
        let mut turned = None;
        solved.each(&[turning], &mut |_, solution| turned = Some(solution))?;
        if let Some(solution) = turned {
            solved.add(&mut own, &solution, &[1.0 / (speed * speed)]);
            report = Some(solution.report);
        }
        fields.extend(own.iter().map(|field| narrow(field)));
        let there = "none".to_owned();
        let report = report.ok_or(StressError::Missing { what: "load case", number: 1, there })?;
        Ok(UnitFields { throws, fields, report })
    }

    /// By how much each field counts under forces on the pins at a speed of the crankshaft itself [rad/s].
    pub(crate) fn weights(&self, forces: &[ThrowForce], speed: f64) -> Vec<f64> {
        let of = |throw: &usize| {
            let force = forces.iter().find(|force| force.throw == *throw).map(|own| own.force);
            force.map_or([0.0; PER_PIN], |force| coefficients(force.norm(), force.arg()))
        };
        self.throws.iter().flat_map(of).chain([speed * speed]).collect()
    }
}

fn narrow(field: &[[f64; 9]]) -> Vec<NodeField> {
    field.iter().map(|values| values.map(|value| value as f32)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn twelve_directions_give_the_series_of_a_pressure_over_half_a_circle() {
        // The pressure at one place of a pin by the direction of a force.
        let pressure = |angle: f64| (angle - 0.3).cos().max(0.0);
        let mut series = [0.0; PER_PIN];
        for k in 0..DIRECTIONS {
            let angle = TAU * k as f64 / DIRECTIONS as f64;
            let mut own = coefficients(2.0 / DIRECTIONS as f64, angle);
            own[0] *= 0.5;
            series.iter_mut().zip(own).for_each(|(sum, own)| *sum += own * pressure(angle));
        }
        // What is left out, SUM 2/(pi (n^2 - 1)) for n = 6, 8, .., is 1/(5 pi); twelve samples fold no more than that into what is kept.
        let most = 2.0 / (5.0 * PI);
        for k in 0..360 {
            let angle = TAU * f64::from(k) / 360.0;
            let sum: f64 = coefficients(1.0, angle).iter().zip(series).map(|(a, b)| a * b).sum();
            assert!((sum - pressure(angle)).abs() < most, "{k}: {sum} {}", pressure(angle));
        }
    }
}
