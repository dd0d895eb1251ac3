//! The trade between two objectives: designs of which none is better in both.

use super::optimum::{DESIGN_VERSION, Design, PROVED_GAP, Search, realised, within};
use super::problem::{Kind, Problem, SHAPE};
use super::refute::ROUNDING;
use super::seat::{Seat, Unseated};
use super::task::DesignTask;
use lanchester_model::Objective;
use lanchester_shape::GeometryError;
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
    /// [`super::PROVED_GAP`] of it, where the second is no larger.
    pub proved: bool,
    /// Boxes of all searches.
    pub boxes: usize,
}

/// What an objective may be larger than its least where the other is made small: a tenth of what is proved of it. Without
/// room the shapes that are left are too few to tell them from none.
const SLACK: f64 = 0.1 * PROVED_GAP;

/// Up to `count` designs of the front between two objectives, evenly spread over the second.
///
/// Each is the least of the first objective where the second is at most a level, so that a front that is not convex is
/// found whole; levels that give the same design give it once.
///
/// # Errors
/// A number of the task that has no meaning, one objective twice, or fewer than two designs.
pub fn front(task: &DesignTask, objectives: [Objective; 2], count: usize) -> Result<Front, GeometryError> {
    front_on(task, objectives, count, &mut Unseated)
}

/// The same on a `seat`: every design within its reach, and with as much more unbalance as the web has of it already.
///
/// # Errors
/// As [`front`].
pub fn front_on(
    task: &DesignTask,
    objectives: [Objective; 2],
    count: usize,
    seat: &mut dyn Seat,
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
    // With what the web has of the last shape, and the planes of the reach that were met.
    let mut problem = Problem::new(task);
    let mut search = Search::default();
    let mut front =
        Front { version: DESIGN_VERSION, objectives, designs: Vec::new(), proved: true, boxes: 0 };
    // The least of one, then of the other at that level.
    let mut ends = [None, None];
    for (end, (kind, other)) in ends.iter_mut().zip([(first, second), (second, first)]) {
        let found = search.settle(task, &mut problem, seat, kind, None);
        front.boxes += found.boxes;
        front.proved &= found.proved;
        let Some(best) = found.best.filter(|best| within(&problem, kind, best)) else { return Ok(front) };
        let mut limited = problem.clone();
        let own = problem.levels.of(kind).unwrap_or(f64::INFINITY).max(best.level * (1.0 + ROUNDING));
        limited.levels = problem.levels.with(kind, own.min(best.level * (1.0 + SLACK)));
        let found = search.settle(task, &mut limited, seat, other, Some(best.x));
        front.boxes += found.boxes;
        front.proved &= found.proved;
        *end = Some(match found.best {
            Some(best) => (best.x, limited),
            None => (best.x, problem.clone()),
        });
    }
    let [Some((start, of_start)), Some((end, of_end))] = ends else { return Ok(front) };
    let level = |problem: &Problem, x: &[f64; SHAPE]| problem.attained(&problem.quantities(x), second);
    let (most, least) = (level(&of_start, &start), level(&of_end, &end));
    problem = of_start.carried(problem);
    let mut last = start;
    front.designs.push(realised(task, &of_start, &start));
    for at in 1..count - 1 {
        let limit = most + (least - most) * at as f64 / (count - 1) as f64;
        // The design before may be as good here: where the front jumps.
        if level(&problem, &last) <= limit {
            continue;
        }
        let mut limited = problem.clone();
        limited.levels = problem.levels.with(second, limit);
        let found = search.settle(task, &mut limited, seat, first, Some(last));
        front.boxes += found.boxes;
        front.proved &= found.proved;
        if let Some(best) = found.best.filter(|best| within(&problem, first, best)) {
            last = best.x;
            front.designs.push(realised(task, &limited, &last));
            // The next shape is near: what the web has of it too, and the planes that it meets.
            problem = limited.carried(problem);
            problem.planes.retain(|plane| plane.is_near(&last));
        }
    }
    if most > least * (1.0 + 1e-9) {
        front.designs.push(realised(task, &of_end, &end));
    }
    Ok(front)
}
