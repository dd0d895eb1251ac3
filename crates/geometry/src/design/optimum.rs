//! The best counterweight for a task, with the proof that none is better.

use super::descent::{Descent, Reached, sense};
use super::problem::{Kind, Problem, SHAPE};
use super::refute::{Refutation, Refuter};
use super::task::DesignTask;
use crate::clearance::RadialEnvelope;
use lanchester_shape::CounterweightShape;
use lanchester_shape::GeometryError;
use lanchester_task::{DesignSettings, Objective};
use serde::Serialize;

/// Version of the results of counterweight design; raised when a field changes its meaning or goes.
pub const DESIGN_VERSION: u32 = 1;

/// A limit counts as met within this part of it.
const MET: f64 = 1e-9;
/// Shapes from which the search starts, spread evenly over the ranges.
const STARTS: usize = 6;

/// A complete counterweight, beyond the disc of its web; on an engine's web beyond the web as it is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Design {
    /// Its shape.
    pub shape: CounterweightShape,
    /// Its thickness [m].
    pub thickness: f64,
    /// Its mass, without the web [kg].
    pub mass: f64,
    /// Its unbalance [kg m].
    pub unbalance: f64,
    /// Unbalance over full balance.
    pub balance: f64,
    /// Distance of its centre of mass from the crank axis [m].
    pub centre: f64,
    /// Farthest point of web and counterweight from the crank axis [m].
    pub swept_radius: f64,
    /// Polar inertia about the crank axis, without the web [kg m^2].
    pub inertia: f64,
    /// Half of its largest width [m].
    pub half_width: f64,
    /// What each shoulder stands out, `l_c` [m].
    pub shoulder: f64,
    /// Angle of the flank against the chord, `delta` [rad].
    pub shoulder_angle: f64,
}

/// The best design and its proof.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Optimum {
    /// [`DESIGN_VERSION`].
    pub version: u32,
    /// What was made small.
    pub objective: Objective,
    /// The design.
    pub design: Design,
    /// Its value of the objective [SI].
    pub value: f64,
    /// What no design can get below, rounding apart [SI]; zero where the proof was stopped before its end.
    pub bound: f64,
    /// Whether every box of the search was refuted.
    pub proved: bool,
    /// Boxes of the search.
    pub boxes: usize,
}

/// How the search ended.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DesignOutcome {
    /// A design that meets everything.
    Found(Box<Optimum>),
    /// No shape of the ranges meets all limits.
    Infeasible(Infeasible),
}

/// Why there is no design.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Infeasible {
    /// Whether every box was refuted; otherwise a design may have been overlooked.
    pub proved: bool,
    /// For each limit the nearest value that can be met while all others hold; none is listed that cannot help alone.
    pub nearest: Vec<NearestLimit>,
}

/// A limit that would have to give way, with the value at which a design exists.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct NearestLimit {
    /// Which limit.
    pub limit: Limit,
    /// Its value in the task [SI].
    pub asked: f64,
    /// The nearest that can be met [SI].
    pub nearest: f64,
}

/// A limit of a task.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "DesignLimit")]
#[serde(rename_all = "kebab-case")]
pub enum Limit {
    /// Largest mass [kg].
    Mass,
    /// Largest swept radius [m].
    SweptRadius,
    /// Largest polar inertia [kg m^2].
    Inertia,
    /// Largest thickness [m].
    Thickness,
    /// Largest half width [m].
    HalfWidth,
    /// Least balance, as a part of full balance.
    Balance,
}

const LIMITS: [(Limit, Kind); 6] = [
    (Limit::Mass, Kind::Mass),
    (Limit::SweptRadius, Kind::SweptRadius),
    (Limit::Inertia, Kind::Inertia),
    (Limit::Thickness, Kind::Thickness),
    (Limit::HalfWidth, Kind::HalfWidth),
    (Limit::Balance, Kind::Balance),
];

/// The design with the least `objective`.
///
/// # Errors
/// A number of the task that has no meaning. Limits that no shape meets are an outcome.
pub fn design(task: &DesignTask, objective: Objective) -> Result<DesignOutcome, GeometryError> {
    design_within(task, objective, None)
}

/// The design with the least `objective` among the shapes that stay within an envelope: the arc in its own directions, and the corner of its
/// chord within the least radius of its own direction and of those behind it.
///
/// # Errors
/// As [`design`].
pub fn design_within(
    task: &DesignTask,
    objective: Objective,
    envelope: Option<&RadialEnvelope>,
) -> Result<DesignOutcome, GeometryError> {
    task.check()?;
    let problem = Problem::new(task);
    let problems = problem.clone().within(envelope);
    let mut search = Search::default();
    let found = search.best(&problems, objective.into(), None, &task.settings);
    Ok(match found.best.filter(|best| within(&problem, objective.into(), best)) {
        Some(best) => DesignOutcome::Found(Box::new(optimum(task, &problem, objective, &best, &found))),
        None => DesignOutcome::Infeasible(search.infeasible(task, &problems, found.proved)),
    })
}

/// The design with the largest unbalance among the shapes within limits and envelope, whatever the task asks for; none if there is no
/// shape at all.
///
/// # Errors
/// As [`design`].
pub fn largest_balance(
    task: &DesignTask,
    envelope: Option<&RadialEnvelope>,
) -> Result<Option<Design>, GeometryError> {
    task.check()?;
    let problem = Problem::new(task);
    let found =
        Search::default().best(&problem.clone().within(envelope), Kind::Balance, None, &task.settings);
    let Some(best) = found.best.filter(|best| best.level > 0.0) else { return Ok(None) };
    let shape = problem.shape(&best.x);
    let thickness = best.level * problem.unit(Kind::Thickness) / problem.quantities(&best.x).first;
    Ok(Some(Design::of(task, shape, thickness.min(task.thickness.most))))
}

/// Whether a level keeps the limit that the task has for what is made small itself.
pub(super) fn within(problem: &Problem, kind: Kind, best: &Reached) -> bool {
    let limit = problem.levels.of(kind);
    limit.is_none_or(|limit| sense(kind) * best.level <= sense(kind) * limit + MET * limit)
}

pub(super) fn optimum(
    task: &DesignTask,
    problem: &Problem,
    objective: Objective,
    best: &Reached,
    found: &Refutation,
) -> Optimum {
    let design = realised(task, problem, &best.x);
    let value = design.value(objective);
    Optimum {
        version: DESIGN_VERSION,
        objective,
        design,
        value,
        bound: if found.proved { value * (1.0 - task.settings.gap) } else { 0.0 },
        proved: found.proved,
        boxes: found.boxes,
    }
}

/// The design of a shape: as thin as its unbalance and the range allow, integrated along its outline.
pub(super) fn realised(task: &DesignTask, problem: &Problem, x: &[f64; SHAPE]) -> Design {
    let shape = problem.shape(x);
    let first = shape.moments().first.x;
    let needed = task.unbalance * task.least_balance / (task.density * first);
    Design::of(task, shape, needed.max(task.thickness.least))
}

impl Design {
    /// The properties of a shape with a thickness [m], integrated along its outline, against the task's duty and density.
    pub fn of(task: &DesignTask, shape: CounterweightShape, thickness: f64) -> Design {
        let moments = shape.moments();
        let unbalance = task.density * thickness * moments.first.x;
        let mass = task.density * thickness * moments.area;
        let widest = shape.arc_radius * (shape.arc_angle / 2.0).min(std::f64::consts::FRAC_PI_2).sin();
        Design {
            shape,
            thickness,
            mass,
            unbalance,
            balance: unbalance / task.unbalance,
            centre: unbalance / mass,
            swept_radius: shape.swept_radius(),
            inertia: task.density * thickness * moments.polar(),
            half_width: widest.max(shape.web_radius),
            shoulder: shape.shoulder(),
            shoulder_angle: shape.shoulder_angle(),
        }
    }

    /// Its value of an objective [SI].
    pub fn value(&self, objective: Objective) -> f64 {
        match objective {
            Objective::Mass => self.mass,
            Objective::SweptRadius => self.swept_radius,
            Objective::Inertia => self.inertia,
            Objective::Thickness => self.thickness,
        }
    }
}

/// Working memory of a search.
#[derive(Default)]
pub(super) struct Search {
    descent: Descent,
    refuter: Refuter,
}

impl Search {
    /// The best shape of all problems, which differ in the place of the corner alone, from evenly spread starts and `hint`, and its proof.
    pub fn best(
        &mut self,
        problems: &[Problem],
        kind: Kind,
        hint: Option<[f64; SHAPE]>,
        settings: &DesignSettings,
    ) -> Refutation {
        let problems = || problems.iter().filter(|problem| !problem.is_empty());
        let mut best: Option<Reached> = None;
        let mut take = |found: Reached| {
            let is_better = |old: Reached| sense(kind) * found.level < sense(kind) * old.level;
            if found.is_feasible() && best.is_none_or(is_better) {
                best = Some(found);
            }
            best
        };
        let mut known = None;
        for problem in problems() {
            if let Some(x) = hint {
                // Elsewhere the proof looks for a better one itself.
                if problem.sector.as_ref().is_some_and(|sector| !sector.holds(x[1] + x[2], x[3])) {
                    continue;
                }
                take(self.descent.reached(problem, kind, x));
                known = take(self.descent.run(problem, kind, x, None));
            }
            // From a hint the proof goes on by itself.
            let starts = match (hint.and(known), &problem.sector) {
                (Some(_), _) => 0,
                (None, None) => STARTS,
                (None, Some(_)) => 1,
            };
            for at in 0..starts {
                known = take(self.descent.run(problem, kind, spread(problem, at), known));
            }
        }
        let mut all = Refutation { best, proved: true, boxes: 0 };
        for problem in problems() {
            let most = settings.max_boxes.saturating_sub(all.boxes);
            let found = self.refuter.run(problem, kind, all.best, (settings.gap, most), &mut self.descent);
            let (proved, boxes) = (all.proved && found.proved, all.boxes + found.boxes);
            all = Refutation { best: found.best, proved, boxes };
        }
        all
    }

    fn infeasible(&mut self, task: &DesignTask, problems: &[Problem], proved: bool) -> Infeasible {
        let mut nearest = Vec::new();
        for (limit, kind) in LIMITS {
            let Some(problem) = problems.first() else { break };
            let Some(asked) = problem.levels.of(kind) else { continue };
            let Some(best) = self.best(problems, kind, None, &task.settings).best else { continue };
            let unit = if kind == Kind::Balance { task.least_balance } else { problem.unit(kind) };
            nearest.push(NearestLimit { limit, asked: asked * unit, nearest: best.level * unit });
        }
        Infeasible { proved, nearest }
    }
}

/// The point number `at` of a sequence that fills the ranges evenly: multiples of powers of the root of x^6 = x + 1.
fn spread(problem: &Problem, at: usize) -> [f64; SHAPE] {
    const ROOT: f64 = 1.134_724_138_401_519_5;
    std::array::from_fn(|k| {
        let part = (0.5 + at as f64 * ROOT.powi(-(k as i32 + 1))).fract();
        problem.low[k] + part * (problem.high[k] - problem.low[k])
    })
}
