//! The tool paper's way for comparison: an evolutionary search over the same task. It proves nothing.
//!
//! Differential evolution (Storn and Price 1997, by the crate `fcmaes-core`, used here alone) over `r`, `h`, the flank, `R` and `alpha`.
//! The thickness follows from the shape as in [`super::design`] (book, eq. 22.27). Of two designs that meet all limits the one with the
//! smaller objective is better, any of them is better than one that does not, and of two that do not the one that misses less.

use super::optimum::{DESIGN_VERSION, Design};
use super::task::DesignTask;
use fcmaes_core::{De, DeParams, Fitness};
use lanchester_shape::{CounterweightShape, GeometryError};
use lanchester_task::{Objective, Range, Shoulder};
use serde::Serialize;

/// A limit is met within this part of it: rounding.
const MET: f64 = 1e-12;
/// Designs of a generation.
const POPULATION: usize = 31;
/// Dimensions of a shape.
const DIMENSIONS: usize = 5;

/// What an evolutionary search came to.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Evolution {
    /// [`DESIGN_VERSION`].
    pub version: u32,
    /// What was made small.
    pub objective: Objective,
    /// The best design that it met within all limits; none if it met none, which does not show that there is none.
    pub best: Option<Evolved>,
    /// Whether it is proved that no design is better: never, since such a search knows no bound.
    pub proved: bool,
    /// Seed of its random numbers: the same seed gives the same design.
    pub seed: u64,
    /// Designs that it looked at.
    pub evaluations: usize,
    /// How many of them met all limits.
    pub feasible: usize,
}

/// The best design of an evolutionary search.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Evolved {
    /// The design.
    pub design: Design,
    /// Its value of the objective [SI].
    pub value: f64,
    /// After how many designs it was found.
    pub found_after: usize,
}

/// An evolutionary search for the design with the least `objective`, for comparison with [`super::design`]: `evaluations` designs from
/// random numbers that `seed` begins.
///
/// # Errors
/// A number of the task that has no meaning, or no evaluations.
pub fn evolve(
    task: &DesignTask,
    objective: Objective,
    seed: u64,
    evaluations: usize,
) -> Result<Evolution, GeometryError> {
    task.check()?;
    if evaluations == 0 {
        return Err(GeometryError::Number {
            quantity: "evaluations of an evolutionary search",
            needed: "one or more",
            got: 0.0,
            hint: "some ten thousand are usual",
        });
    }
    let flank = match task.shoulder {
        Shoulder::Angle(range) | Shoulder::Height(range) => range,
    };
    let ranges = [task.web_radius, task.rectangle_height, flank, task.arc_radius, task.arc_angle];
    let mut search = Evolution {
        version: DESIGN_VERSION,
        objective,
        best: None,
        proved: false,
        seed,
        evaluations: 0,
        feasible: 0,
    };
    let within = Fitness::bounded(DIMENSIONS, 1, &[0.0; DIMENSIONS], &[1.0; DIMENSIONS]);
    let parameters = DeParams {
        popsize: POPULATION as i32,
        max_evaluations: evaluations as u64,
        seed,
        ..DeParams::default()
    };
    let mut population = De::new(within, &[], &[], None, &parameters);
    let at = |range: Range, part: f64| {
        (range.least + part * (range.most - range.least)).clamp(range.least, range.most)
    };
    while search.evaluations < evaluations {
        let left = evaluations - search.evaluations;
        let ranks: Vec<f64> = (population.ask().iter().take(left))
            .map(|parts| search.take(task, std::array::from_fn(|k| at(ranges[k], parts[k]))))
            .collect();
        population.tell(&ranks);
    }
    Ok(search)
}

impl Evolution {
    /// Looks at the design with these dimensions and says how good it is: below one where it meets all limits, above where it does not.
    fn take(
        &mut self,
        task: &DesignTask,
        [web_radius, height, flank, arc_radius, arc_angle]: [f64; 5],
    ) -> f64 {
        self.evaluations += 1;
        let mut shape = CounterweightShape {
            web_radius,
            rectangle_height: height,
            shoulder_height: flank,
            arc_radius,
            arc_angle,
        };
        if let Shoulder::Angle(_) = task.shoulder {
            shape.shoulder_height = shape.shoulder().max(0.0) * flank.tan();
        }
        // Other shapes are none of the family, and have no outline that all formulas hold for.
        let outside = (-shape.shoulder() / web_radius).max((web_radius - shape.crown()) / web_radius);
        if outside > 0.0 {
            return 1e6 * (1.0 + outside);
        }
        let needed = task.unbalance * task.least_balance / (task.density * shape.moments().first.x);
        if !(needed > 0.0 && needed.is_finite()) {
            return 1e6;
        }
        let design = Design::of(task, shape, needed.max(task.thickness.least));
        let missed = design.missed(task);
        if missed > MET {
            return 1.0 + missed;
        }
        self.feasible += 1;
        let value = design.value(self.objective);
        if self.best.is_none_or(|best| value < best.value) {
            self.best = Some(Evolved { design, value, found_after: self.evaluations });
        }
        value / (1.0 + value)
    }
}

impl Design {
    /// By how much the design misses the limits of the task that its shape and thickness do not keep by themselves: the sum of the
    /// parts of each limit, zero where all are met.
    fn missed(&self, task: &DesignTask) -> f64 {
        let limits = &task.limits;
        let mut missed = 0.0;
        let mut at_most = |value: f64, limit: Option<f64>| {
            missed += limit.map_or(0.0, |limit| ((value - limit) / limit).max(0.0));
        };
        at_most(self.balance, task.most_balance);
        at_most(task.least_balance / self.balance, Some(1.0));
        at_most(self.thickness, Some(task.thickness.most));
        at_most(self.mass, limits.mass);
        at_most(self.swept_radius, limits.swept_radius);
        at_most(self.inertia, limits.inertia);
        at_most(self.half_width, limits.half_width);
        let mut range = |value: f64, range: Option<Range>, scale: f64| {
            missed += range.map_or(0.0, |r| ((value - r.most).max(r.least - value) / scale).max(0.0));
        };
        range(self.shape.shoulder_height, limits.shoulder_height, self.shape.web_radius);
        // A flank of no length has no angle.
        if self.shape.shoulder_height.hypot(self.shoulder) > 0.0 {
            range(self.shoulder_angle, limits.shoulder_angle, 1.0);
        }
        missed
    }
}
