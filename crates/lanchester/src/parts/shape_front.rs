//! The front between two objectives for counterweights of one duty, within everything that moves past their webs.

use crate::parts::best_shape::{
    MOST_ROUNDS, asked, designed, envelope, missed, on_web, room, shared, thin_enough,
};
use crate::parts::error::CounterweightError;
use lanchester_geometry::clearance::{RadialEnvelope, SweptRoom};
use lanchester_geometry::{Design, DesignOutcome, Front, Objective, ShapeTask, front_within};
use lanchester_model::Engine;
use serde::Serialize;

/// Part of the duty that a design may miss or have too much before it is searched anew with what it shares itself.
const MISSED: f64 = 1e-7;

/// The trade between two objectives for weights of one duty.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CounterweightFront {
    /// Indices of the weights in [`Engine::counterweights`].
    pub weights: Vec<usize>,
    /// The smallest swept radius that keeps the wanted clearance of one of them whatever the shape; none where there is nothing to stay clear of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub room: Option<SweptRoom>,
    /// With a room: how far all of them may reach in each direction.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub envelope: Option<RadialEnvelope>,
    /// The designs, each as what it adds to the crankshaft beyond the web as it is.
    pub front: Front,
}

/// The front for weights (by index) of one duty [kg m].
pub(crate) fn best_front(
    engine: &Engine,
    weights: &[usize],
    duty: f64,
    task: &ShapeTask,
    against: Objective,
    count: usize,
) -> Result<CounterweightFront, CounterweightError> {
    let pair = [task.minimise, against];
    let none =
        |front: Front| CounterweightFront { weights: weights.to_vec(), room: None, envelope: None, front };
    let (free, _) = designed(engine, weights[0], duty, task, None)?;
    let DesignOutcome::Found(free) = free else {
        return Ok(none(front_within(&asked(duty, task, &Default::default()), pair, count, None)?));
    };
    let mut task = *task;
    let (mut around, mut nearest): (Option<RadialEnvelope>, _) = (None, None);
    if engine.envelope.is_some() {
        for index in weights {
            task = thin_enough(engine, *index, &task)?;
        }
        for index in weights {
            let own = envelope(engine, *index, &free.design, &task)?;
            around = Some(match around {
                Some(all) => own.intersection(&all),
                None => own,
            });
            let own = room(engine, *index, task.thickness.most)?;
            nearest = [nearest, own].into_iter().flatten().min_by(|a, b| a.radius.total_cmp(&b.radius));
        }
    }
    let mut now = around.clone();
    let mut front = within(engine, weights[0], duty, &task, pair, count, now.as_ref())?;
    for at in 0..=MOST_ROUNDS {
        let mut miss: f64 = 0.0;
        let mut kept = Vec::new();
        for design in &front.designs {
            let mut of_all = 0.0f64;
            for index in weights {
                of_all = of_all.max(missed(engine, *index, design, task.density)?.unwrap_or(0.0));
            }
            kept.push(of_all == 0.0);
            miss = miss.max(of_all);
        }
        let Some(envelope) = now.as_ref().filter(|_| miss > 0.0) else { break };
        if at == MOST_ROUNDS {
            // What does not keep the clearance is none of the front.
            let mut kept = kept.into_iter();
            front.designs.retain(|_| kept.next().unwrap_or(false));
            front.proved = false;
            break;
        }
        now = Some(envelope.shrunk(1.05 * miss + 1e-7));
        front = within(engine, weights[0], duty, &task, pair, count, now.as_ref())?;
    }
    Ok(CounterweightFront { weights: weights.to_vec(), room: nearest, envelope: around, front })
}

/// The front within an envelope, of what the shapes add to the web of a weight.
fn within(
    engine: &Engine,
    index: usize,
    duty: f64,
    task: &ShapeTask,
    pair: [Objective; 2],
    count: usize,
    envelope: Option<&RadialEnvelope>,
) -> Result<Front, CounterweightError> {
    let (best, share) = designed(engine, index, duty, task, envelope)?;
    let mut front = front_within(&asked(duty, task, &share), pair, count, envelope)?;
    if matches!(best, DesignOutcome::Infeasible(_)) {
        front.designs.clear();
    }
    for design in &mut front.designs {
        let own = on_web(design, &shared(engine, index, design, task.density)?, duty);
        let over = own.balance / task.least_balance - 1.0;
        // One as thin as may be has what it has.
        let is_thinnest = design.thickness <= task.thickness.least * (1.0 + MISSED);
        let is_met = over >= -MISSED && (over <= MISSED || is_thinnest);
        *design = if is_met { own } else { again(engine, index, duty, task, pair, &own, envelope)? };
    }
    Ok(front)
}

/// The design of a front that shares less with its web than the first one: the best with no more of the second objective.
fn again(
    engine: &Engine,
    index: usize,
    duty: f64,
    task: &ShapeTask,
    [first, second]: [Objective; 2],
    design: &Design,
    envelope: Option<&RadialEnvelope>,
) -> Result<Design, CounterweightError> {
    let mut limited = ShapeTask { minimise: first, ..*task };
    match second {
        Objective::Mass => limited.limits.mass = Some(design.mass),
        Objective::SweptRadius => limited.limits.swept_radius = Some(design.swept_radius),
        Objective::Inertia => limited.limits.inertia = Some(design.inertia),
        Objective::Thickness => limited.thickness.most = design.thickness,
    }
    for task in [limited, ShapeTask { minimise: second, ..*task }] {
        if let (DesignOutcome::Found(best), _) = designed(engine, index, duty, &task, envelope)? {
            return Ok(best.design);
        }
    }
    Ok(*design)
}
