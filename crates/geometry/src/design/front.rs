//! The trade between two objectives: designs of which none is better in both.

use super::optimum::{DESIGN_VERSION, Design, Search, realised, within};
use super::problem::{Kind, Problem};
use super::refute::ROUNDING;
use super::task::DesignTask;
use crate::clearance::RadialEnvelope;
use lanchester_shape::GeometryError;
use lanchester_task::Objective;
use rayon::prelude::*;
use serde::Serialize;

/// The front between two objectives, from the least of the first to the least of the second.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Front {
    /// [`DESIGN_VERSION`].
    pub version: u32,
    /// The two objectives.
    pub objectives: [Objective; 2],
    /// The designs; empty where no shape meets all limits.
    pub designs: Vec<Design>,
    /// Whether for every design it is proved that the first objective cannot be less by more than
    /// the gap of the settings, where the second is no larger.
    pub proved: bool,
    /// Boxes of all searches.
    pub boxes: usize,
}

/// What an objective may be larger than its least where the other is made small, as a share of the gap that is proved of it. Without
/// room the shapes that are left are too few to tell them from none.
const SLACK: f64 = 0.1;

/// The numbers of a shape.
type Shape = [f64; super::problem::SHAPE];

/// Levels that are searched one after another, each from the design of the one before; runs are searched beside one another. It does not
/// depend on the machine, so that neither does the front.
const RUN: usize = 10;

/// What a run of levels finds.
struct LevelRun {
    /// Each with the level that it keeps.
    designs: Vec<(f64, Shape)>,
    boxes: usize,
    proved: bool,
}

/// Up to `count` designs of the front between two objectives, evenly spread over the second.
///
/// Each is the least of the first objective where the second is at most a level, so that a front that is not convex is
/// found whole; levels that give the same design give it once.
///
/// # Errors
/// A number of the task that has no meaning, one objective twice, or fewer than two designs.
pub fn front(task: &DesignTask, objectives: [Objective; 2], count: usize) -> Result<Front, GeometryError> {
    front_within(task, objectives, count, None)
}

/// As [`front`], among the shapes that stay within an envelope.
///
/// # Errors
/// As [`front`].
pub fn front_within(
    task: &DesignTask,
    objectives: [Objective; 2],
    count: usize,
    envelope: Option<&RadialEnvelope>,
) -> Result<Front, GeometryError> {
    task.check()?;
    if count < 2 {
        return Err(GeometryError::Number {
            quantity: "number of designs of a front",
            needed: "two or more",
            got: count as f64,
            hint: "one design is an optimum",
        });
    }
    if objectives[0] == objectives[1] {
        return Err(GeometryError::SameObjective);
    }
    let [first, second] = objectives.map(Kind::from);
    let problem = Problem::new(task);
    let problems = problem.clone().within(envelope);
    let limited = |kind, level| -> Vec<Problem> {
        problems.iter().map(|problem| problem.clone().limited(kind, level)).collect()
    };
    let (mut search, settings) = (Search::default(), &task.settings);
    let mut front =
        Front { version: DESIGN_VERSION, objectives, designs: Vec::new(), proved: true, boxes: 0 };
    // The least of one, then of the other at that level.
    let mut ends = [None; 2];
    for (end, (kind, other)) in ends.iter_mut().zip([(first, second), (second, first)]) {
        let found = search.best(&problems, kind, None, settings);
        front.boxes += found.boxes;
        front.proved &= found.proved;
        let Some(best) = found.best.filter(|best| within(&problem, kind, best)) else { return Ok(front) };
        let own = problem.levels.of(kind).unwrap_or(f64::INFINITY).max(best.level * (1.0 + ROUNDING));
        let limited = limited(kind, own.min(best.level * (1.0 + SLACK * settings.gap)));
        let found = search.best(&limited, other, Some(best.x), settings);
        front.boxes += found.boxes;
        front.proved &= found.proved;
        *end = found.best.or(Some(best));
    }
    let [Some(start), Some(end)] = ends else { return Ok(front) };
    let level = |x: &Shape| problem.attained(&problem.quantities(x), second);
    let (most, least) = (level(&start.x), level(&end.x));
    let limits: Vec<f64> =
        (1..count - 1).map(|at| most + (least - most) * at as f64 / (count - 1) as f64).collect();
    let runs = limits.par_chunks(RUN).map(|limits| {
        let mut run = LevelRun { designs: Vec::new(), boxes: 0, proved: true };
        let (mut search, mut last) = (Search::default(), start.x);
        for &limit in limits {
            // The design before may be as good here: where the front jumps.
            if level(&last) <= limit {
                continue;
            }
            let found = search.best(&limited(second, limit), first, Some(last), settings);
            run.boxes += found.boxes;
            run.proved &= found.proved;
            if let Some(best) = found.best.filter(|best| within(&problem, first, best)) {
                last = best.x;
                run.designs.push((limit, last));
            }
        }
        run
    });
    let mut last = start.x;
    front.designs.push(realised(task, &problem, &last));
    for run in runs.collect::<Vec<_>>() {
        front.boxes += run.boxes;
        front.proved &= run.proved;
        for (limit, x) in run.designs {
            if level(&last) > limit {
                last = x;
                front.designs.push(realised(task, &problem, &last));
            }
        }
    }
    if most > least * (1.0 + 1e-9) {
        front.designs.push(realised(task, &problem, &end.x));
    }
    Ok(front)
}
