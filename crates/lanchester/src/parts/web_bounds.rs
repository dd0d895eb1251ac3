//! What fits: the largest unbalance that web, shapes and clearance allow, as the bound of each free weight on a web.

use crate::parts::best_shape::LargestShapes;
use crate::parts::duty::web_of;
use crate::parts::error::CounterweightError;
use crate::pressure::measured::TraceFile;
use crate::pressure::over_speed::optimised;
use lanchester_balance::{Answer, BalanceError, BalanceSettings, Next, SearchState, WebBound};
use lanchester_model::{Counterweight, Engine};
use lanchester_task::{BalanceTask, FreeWeight, Phase, Place, Seat, ShapeTask};
use std::f64::consts::{PI, TAU};

/// How often the optimum is found anew with bounds of the directions in which its weights stand.
const MOST_ROUNDS: usize = 6;
/// A bound that is passed by less than this part of it is kept.
const KEPT: f64 = 1e-6;
/// Directions all around, of which the last resort takes the least bound.
const DIRECTIONS: usize = 12;

/// Why what fits cannot bound the weights.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WebBoundError {
    /// The task has no meaning, or was cancelled.
    #[error(transparent)]
    Balance(#[from] BalanceError),
    /// A shape or a clearance has none.
    #[error(transparent)]
    Counterweight(#[from] CounterweightError),
    /// A weight that is no shape on a web, or an engine that does not say what its shapes may be.
    #[error(
        "free weight \"{name}\": what fits needs {needed}\nhint: give it, or give the largest amount as an unbalance such as \"0.1 kg m\""
    )]
    NotKnown {
        /// Name of the weight.
        name: String,
        /// What is missing.
        needed: &'static str,
    },
    /// A least amount beyond what fits.
    #[error(
        "free weight \"{name}\" needs at least {least:.6} kg m, and what fits on web {web} is {bound:.6} kg m, by {by}\nhint: lower its least amount, or widen the ranges of [counterweight_design]"
    )]
    TooLittle {
        /// Name of the weight.
        name: String,
        /// Its least amount [kg m].
        least: f64,
        /// The web.
        web: usize,
        /// What fits [kg m].
        bound: f64,
        /// What bounds it.
        by: String,
    },
}

/// As [`optimised`], with every weight on a web bounded by what fits on it: those that ask for it, and those without a largest amount where
/// the engine has the body of a crank and `shapes` are given. [`Answer::web_bounds`] says which, and by what.
///
/// What fits depends on the direction of the weight. It is the largest unbalance of the shapes in the direction that the task gives, or else opposite to
/// the crankpin; where the optimum stands elsewhere and asks for more than fits there, that becomes the bound and the optimum is found anew.
///
/// # Errors
/// As [`optimised`], and where what fits is not known, or is less than the least amount of a weight.
pub fn optimise_on_webs(
    engine: &Engine,
    traces: Result<&[TraceFile], String>,
    task: &BalanceTask,
    shapes: Option<&ShapeTask>,
    settings: &BalanceSettings,
    watch: &dyn Fn(&SearchState<'_>) -> Next,
) -> Result<Answer, WebBoundError> {
    let Some(mut webs) = Webs::of(engine, task, shapes)? else {
        return Ok(optimised(engine, traces, task, settings, watch)?);
    };
    let mut bounded = webs.bounded(task)?;
    let mut round = 0;
    loop {
        let mut answer = optimised(engine, traces.clone(), &bounded, settings, watch)?;
        if round < MOST_ROUNDS && webs.lower(&bounded, &answer, round + 2 > MOST_ROUNDS)? {
            bounded = webs.bounded(task)?;
            round += 1;
            continue;
        }
        answer.web_bounds = webs.bounds.into_iter().map(|bound| bound.told).collect();
        return Ok(answer);
    }
}

/// Free weights on webs, with their bounds.
struct Webs<'a> {
    engine: &'a Engine,
    shapes: ShapeTask,
    bounds: Vec<Bounded>,
    known: LargestShapes,
}

/// A weight with its bound.
struct Bounded {
    /// Index in [`BalanceTask::weights`].
    index: usize,
    /// The engine with this weight alone.
    probe: Engine,
    told: WebBound,
}

impl<'a> Webs<'a> {
    /// Those of a task; none where no weight is bounded by what fits.
    fn of(
        engine: &'a Engine,
        task: &BalanceTask,
        shapes: Option<&ShapeTask>,
    ) -> Result<Option<Webs<'a>>, WebBoundError> {
        let mut bounds = Vec::new();
        let followers: Vec<usize> = task.ties.iter().map(|tie| tie.second).collect();
        for (index, weight) in task.weights.iter().enumerate() {
            let probe = probe(engine, weight);
            let web = probe.as_ref().and_then(|probe| web_of(probe, &probe.counterweights[0]));
            let missing = match (&web, engine.crank_body, shapes) {
                (None, ..) => Some("its place on a web that stands free"),
                (_, None, _) => Some("the section [crank.body]"),
                (.., None) => Some("the section [counterweight_design]"),
                _ => None,
            };
            // A follower has what its leader allows it, and a web all the same.
            let is_open = weight.most.is_none() || followers.contains(&index);
            match (weight.fits, missing, is_open) {
                (true, Some(needed), _) => {
                    return Err(WebBoundError::NotKnown { name: weight.name.clone(), needed });
                }
                (true, None, _) | (false, None, true) => {}
                (false, ..) => continue,
            }
            if let (Some(probe), Some(web)) = (probe, web) {
                let told = WebBound {
                    name: weight.name.clone(),
                    web: web + 1,
                    bound: f64::INFINITY,
                    by: String::new(),
                };
                bounds.push(Bounded { index, probe, told });
            }
        }
        let Some(shapes) = shapes.copied().filter(|_| !bounds.is_empty()) else { return Ok(None) };
        let mut webs = Webs { engine, shapes, bounds, known: LargestShapes::default() };
        for at in 0..webs.bounds.len() {
            let (bound, by) = webs.fits(at, None)?;
            (webs.bounds[at].told.bound, webs.bounds[at].told.by) = (bound, by);
        }
        Ok(Some(webs))
    }

    /// What fits on a web in a direction on the crankshaft [rad] and by what; without one in that of the probe.
    fn fits(&mut self, at: usize, angle: Option<f64>) -> Result<(f64, String), WebBoundError> {
        let probe = &mut self.bounds[at].probe;
        if let Some(angle) = angle {
            *probe = probe
                .with(|parts| parts.counterweights[0].angle = angle)
                .expect("invariant: a direction is finite");
        }
        Ok(self.known.largest(probe, 0, &self.shapes)?)
    }

    /// The task with the bounds.
    fn bounded(&self, task: &BalanceTask) -> Result<BalanceTask, WebBoundError> {
        let mut bounded = task.clone();
        for Bounded { index, told, .. } in &self.bounds {
            let weight = &mut bounded.weights[*index];
            if weight.least > told.bound {
                let WebBound { name, web, bound, by } = told.clone();
                return Err(WebBoundError::TooLittle { name, least: weight.least, web, bound, by });
            }
            weight.most = Some(weight.most.map_or(told.bound, |most| most.min(told.bound)));
        }
        Ok(bounded)
    }

    /// Lowers the bound of every weight that does not fit where the answer has it, with `is_last` to what fits in every direction; whether
    /// there was one.
    fn lower(&mut self, task: &BalanceTask, answer: &Answer, is_last: bool) -> Result<bool, WebBoundError> {
        let mut is_lowered = false;
        for at in 0..self.bounds.len() {
            let index = self.bounds[at].index;
            let Some(found) = answer.weights.get(index).filter(|found| found.used) else { continue };
            let amount = found.unbalance.norm();
            let Seat::Crankshaft(crankshaft) = task.weights[index].seat else { continue };
            if amount <= KEPT * self.bounds[at].told.bound {
                continue;
            }
            let angle = found.unbalance.arg() - self.engine.crankshafts[crankshaft].phase;
            let (mut bound, mut by) = self.fits(at, Some(angle))?;
            if amount <= bound * (1.0 + KEPT) {
                continue;
            }
            if is_last {
                for direction in 0..DIRECTIONS {
                    let angle = angle + TAU * direction as f64 / DIRECTIONS as f64;
                    let (here, first) = self.fits(at, Some(angle))?;
                    if here < bound {
                        (bound, by) = (here, first);
                    }
                }
            }
            (self.bounds[at].told.bound, self.bounds[at].told.by) = (bound, by);
            is_lowered = true;
        }
        Ok(is_lowered)
    }
}

/// The engine with one weight where a free one may stand: in the direction that the task gives, or opposite to the crankpin.
fn probe(engine: &Engine, weight: &FreeWeight) -> Option<Engine> {
    let (Seat::Crankshaft(crankshaft), Place::At(z)) = (weight.seat, weight.z) else { return None };
    let mut alone =
        Counterweight { name: weight.name.clone(), crankshaft, z, unbalance: 1.0, angle: 0.0, part: None };
    let web = web_of(engine, &alone)?;
    alone.angle = match weight.phase {
        Phase::Direction(angle) | Phase::Line(angle) => angle - engine.crankshafts[crankshaft].phase,
        Phase::Free => engine.throws[web / 2].angle + PI,
    };
    engine.with(|parts| parts.counterweights = vec![alone]).ok()
}
