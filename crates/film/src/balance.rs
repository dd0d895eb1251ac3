//! Work and energy of a shaft over a period of its run, summed up beside the integration.
//!
//! ```text
//! E = 1/2 (m |x'|^2 + I |(a', b')|^2)        missing = loads + turning - films - contact - (E_end - E_start)                  (45.8)
//! loads   INT (F . x' + M . (a', b')) dt     turning  SUM_j INT w_m f_j . (z x e_j) dt
//! films   SUM_j INT -f_j . v_j dt            contact  SUM_j INT -k_j . e_j' dt          f, k: film and contact on journal j
//! ```
//! Powers are taken at Gauss points of the solution between the places at which the integrator holds the equations of motion, so that nothing makes the
//! sums balance but the solution itself. Gyroscopic moments have no power and no term.

use lanchester_numerics::Step;
use serde::{Deserialize, Serialize};

/// Missing energy over the turnover up to which a run is balanced.
pub const BALANCED: f64 = 1e-4;

/// Work and energy of a shaft over the last period [J].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct FilmEnergy {
    /// Work of the loads on the shaft.
    pub loads: f64,
    /// Work that turning journals and shells do on the films' pressure.
    pub turning: f64,
    /// Lost in the films by the flow that their pressure drives.
    pub films: f64,
    /// Taken by contact of the roughness, which is elastic.
    pub contact: f64,
    /// Change of kinetic energy.
    pub change: f64,
    /// What is missing: loads + turning - films - contact - change.
    pub missing: f64,
    /// Sum of the sizes of all powers over time, by which `missing` is judged.
    pub turnover: f64,
}

impl FilmEnergy {
    /// Missing energy over the turnover.
    pub fn error(&self) -> f64 {
        if self.turnover > 0.0 { self.missing.abs() / self.turnover } else { self.missing.abs() }
    }
}

/// Powers of a shaft at an instant [W].
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Powers {
    pub loads: f64,
    pub turning: f64,
    pub films: f64,
    pub contact: f64,
}

/// The sums of a period that is being run.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sums {
    energy: FilmEnergy,
    from: f64,
}

impl Sums {
    /// Adds a step of a run in which a period has the length 1 and lasts `duration` [s], in pieces no longer than the distance of two of `samples` loads.
    /// `powers` at a place of a state; `kinetic`: energy of a state [J]. The first step of a period begins anew.
    pub(crate) fn add(
        &mut self,
        step: &Step,
        duration: f64,
        samples: usize,
        powers: impl Fn(f64, &[f64]) -> Option<Powers>,
        kinetic: impl Fn(&[f64]) -> f64,
    ) {
        if step.from == step.from.round() {
            *self = Sums { energy: FilmEnergy::default(), from: kinetic(step.start) };
        }
        let own = &mut self.energy;
        step.gauss_points(1.0 / samples as f64, |at, weight, state| {
            // Without a film there the sum, and so the balance, is none.
            let Some(found) = powers(at, state) else {
                own.turnover = f64::NAN;
                return;
            };
            let weight = weight * duration;
            own.loads += weight * found.loads;
            own.turning += weight * found.turning;
            own.films += weight * found.films;
            own.contact += weight * found.contact;
            own.turnover +=
                weight * (found.loads.abs() + found.turning.abs() + found.films.abs() + found.contact.abs());
        });
        own.change = kinetic(step.end) - self.from;
    }

    /// The balance of the last period; `None` where a film was none.
    pub(crate) fn balance(&self) -> Option<FilmEnergy> {
        let FilmEnergy { loads, turning, films, contact, change, turnover, .. } = self.energy;
        let missing = loads + turning - films - contact - change;
        (turnover.is_finite() && missing.is_finite()).then_some(FilmEnergy { missing, ..self.energy })
    }
}
