//! The counterweights of an engine as parts: which of them, their duties, the best shapes.

use crate::clearance::{clearance_model, clearances};
use crate::counterweight_error::CounterweightError;
use crate::counterweight_fit::{OnWeb, WebSeat, fitted_part, on_web, plane, with_counterweights};
use lanchester_geometry::clearance::{ClearanceEnvelope, SweptRoom};
use lanchester_geometry::{
    Design, DesignOutcome, DesignTask, Evolution, Front, Objective, Reach, ShapeTask, Shoulder, design_on,
    evolve_within, front_on,
};
use lanchester_model::{Counterweight, CounterweightForm, Engine};
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Version of [`CounterweightDesigns`]; raised when a field changes its meaning or goes.
pub const COUNTERWEIGHT_DESIGNS_VERSION: u32 = 2;

/// What counterweights are asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct CounterweightRequest {
    /// Names of the weights; without any, every weight on a web that has no outline of the user's own.
    pub weights: Vec<String>,
    /// Their unbalance [kg m], where it is not that of each weight.
    pub unbalance: Option<f64>,
    /// Shapes among which they are to be found, and what is made small.
    pub task: ShapeTask,
    /// An evolutionary search beside the proved optimum, for comparison.
    pub evolution: Option<EvolutionRequest>,
}

/// An evolutionary search, as the tool paper has it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EvolutionRequest {
    /// Where its random numbers begin.
    pub seed: u64,
    /// How many designs it looks at.
    pub evaluations: usize,
}

/// A weight and the shape that was found for it.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DesignedCounterweight {
    /// Its name.
    pub name: String,
    /// Its index in [`Engine::counterweights`].
    pub index: usize,
    /// The unbalance that is full balance [kg m].
    pub duty: f64,
    /// What of its shape the plain web has already, beyond the disc [kg m]: the shape is designed for that much more.
    pub shared: f64,
    /// The masses of what was found; none where no shape was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub on_web: Option<OnWeb>,
    /// Where the clearance envelope is nearest to the crank axis, where it limits the shape; none where the best shape of all keeps the
    /// clearance, or there is nothing to stay clear of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub room: Option<SweptRoom>,
    /// With a room: whether every shape that leaves the envelope comes too near to something, so that the optimum is that of all
    /// shapes that keep the clearance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub room_is_exact: Option<bool>,
    /// With a room: what is made small, of the best shape without it [SI], as the crankshaft gains it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub without_room: Option<f64>,
    /// What was found.
    pub outcome: DesignOutcome,
    /// What the evolutionary search found, if it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub evolution: Option<Evolution>,
}

/// The shapes found for counterweights of an engine.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CounterweightDesigns {
    /// [`COUNTERWEIGHT_DESIGNS_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Shapes among which they were found.
    pub task: ShapeTask,
    /// The weights, in the order of the engine.
    pub weights: Vec<DesignedCounterweight>,
}

/// The trade between two objectives for weights of one duty.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CounterweightFront {
    /// Indices of the weights in [`Engine::counterweights`].
    pub weights: Vec<usize>,
    /// Where the clearance envelope, to which all shapes are limited, is nearest to the crank axis; none where there is nothing to stay clear of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub room: Option<SweptRoom>,
    /// The designs.
    pub front: Front,
    /// Their masses on the first of the webs, in the same order.
    pub on_web: Vec<OnWeb>,
}

/// The best shape for each weight that is asked for, with its proof.
///
/// Where the engine says what the crankshaft must stay clear of, the shapes are those within the clearance envelope. What a shape shares with
/// its plain web beyond the disc is the web's, so that the shape gets that much more.
///
/// # Errors
/// Where a weight is not there or has no duty, or a number of the task has no meaning. Limits that no shape meets are an
/// outcome.
pub fn design_counterweights(
    engine: &Engine,
    request: &CounterweightRequest,
) -> Result<CounterweightDesigns, CounterweightError> {
    let mut weights: Vec<DesignedCounterweight> = Vec::new();
    let mut done: Vec<(f64, f64, Surroundings, usize)> = Vec::new();
    for (index, duty) in duties(engine, request)? {
        let weight = &engine.counterweights[index];
        let name = weight.name.clone();
        let around = Surroundings::of(engine, index, &request.task)?;
        // Weights of one duty that stand alike on their webs have one shape.
        let tilt = tilt(engine, weight);
        let alike = |known: &&(f64, f64, Surroundings, usize)| {
            known.0 == duty && (known.1 - tilt).abs() < 1e-9 && known.2.is_like(&around)
        };
        if let Some((.., first)) = done.iter().find(alike) {
            weights.push(DesignedCounterweight { name, index, ..weights[*first].clone() });
            continue;
        }
        let designed = cleared(engine, index, duty, &around)?;
        let reach = around.reach.as_ref().filter(|_| designed.room.is_some());
        let shapes = within(&around.task, around.envelope.as_ref().filter(|_| designed.room.is_some()));
        let asked = DesignTask::new(duty + designed.shared / shapes.least_balance, &shapes);
        let search = |search: EvolutionRequest| {
            evolve_within(&asked, around.task.minimise, search.seed, search.evaluations, reach)
        };
        let evolution = request.evolution.map(search).transpose()?;
        done.push((duty, tilt, around, weights.len()));
        weights.push(DesignedCounterweight { name, evolution, ..designed });
    }
    Ok(CounterweightDesigns {
        version: COUNTERWEIGHT_DESIGNS_VERSION,
        engine: engine.name.clone(),
        task: request.task,
        weights,
    })
}

/// What is around a weight.
#[derive(Debug, Clone)]
pub(crate) struct Surroundings {
    /// The shapes, no thicker than the rods beside the web leave it.
    pub task: ShapeTask,
    /// Whether rods limit the thickness.
    pub is_thinner: bool,
    /// What crankcase, pistons and liners leave.
    pub envelope: Option<ClearanceEnvelope>,
    /// The envelope as the weight stands now.
    pub reach: Option<Reach>,
}

impl Surroundings {
    /// Of the weight of this index, among the shapes of a task.
    ///
    /// # Errors
    /// Where what it must stay clear of is not told completely.
    pub fn of(engine: &Engine, index: usize, task: &ShapeTask) -> Result<Surroundings, CounterweightError> {
        let mut around = Surroundings { task: *task, is_thinner: false, envelope: None, reach: None };
        if engine.envelope.is_none() || !task.faults().is_empty() {
            return Ok(around);
        }
        let weight = &engine.counterweights[index];
        let model = clearance_model(engine)?;
        let z = plane(weight);
        let throw = web_of(engine, weight).map(|web| web / 2);
        if let Some(most) = model.largest_thickness(weight.crankshaft, throw, z)
            && most < task.thickness.most
        {
            around.task.thickness.most = most.max(task.thickness.least);
            around.is_thinner = true;
        }
        let half = around.task.thickness.most / 2.0;
        let height = match task.shoulder {
            Shoulder::Height(range) => range.most,
            Shoulder::Angle(range) => task.arc_radius.most * range.most.tan(),
        };
        let farthest = task.rectangle_height.most + height + 2.0 * task.arc_radius.most;
        let farthest = task.limits.swept_radius.map_or(farthest, |limit| limit.min(farthest));
        around.envelope = model
            .envelope(weight.crankshaft, [z - half, z + half], farthest)
            .map_err(crate::clearance::EngineClearanceError::from)?;
        let angle = weight.part.as_ref().map_or(weight.angle, |part| part.angle);
        around.reach = around.envelope.as_ref().map(|envelope| envelope.around(angle));
        Ok(around)
    }

    /// Whether both leave the same, but for rounding.
    fn is_like(&self, other: &Surroundings) -> bool {
        let reaches = match (&self.reach, &other.reach) {
            (None, None) => true,
            (Some(one), Some(other)) => one.is_like(other),
            _ => false,
        };
        let circle = |around: &Surroundings| around.envelope.as_ref().map(|envelope| envelope.circle);
        let circles = match (circle(self), circle(other)) {
            (Some(one), Some(other)) => one == other || (one - other).abs() <= 1e-9,
            (one, other) => one == other,
        };
        self.task == other.task && reaches && circles
    }

    /// Whether all that leaves the envelope comes too near to something, for a design of this thickness [m]: the envelope is that of the
    /// largest thickness.
    fn is_exact(&self, thickness: f64) -> bool {
        let is_thickest = thickness >= self.task.thickness.most * (1.0 - 1e-9);
        is_thickest && self.envelope.as_ref().is_some_and(|envelope| envelope.is_exact)
    }
}

/// The best shape that keeps the wanted clearance: the best of all, if that one does; else the best within the clearance envelope.
fn cleared(
    engine: &Engine,
    index: usize,
    duty: f64,
    around: &Surroundings,
) -> Result<DesignedCounterweight, CounterweightError> {
    let free = designed(engine, index, duty, &around.task, None)?;
    let (Some(envelope), DesignOutcome::Found(best)) = (&around.envelope, &free.outcome) else {
        return Ok(free);
    };
    let (part, _) = fitted_part(engine, index, &best.design, around.task.density)?;
    let is_within = best.design.swept_radius <= envelope.circle
        && envelope.around(part.angle).excess(&best.design.shape) <= 0.0;
    if is_within || (!envelope.is_exact && keeps_clear(engine, index, &best.design, around.task.density)?) {
        return Ok(free);
    }
    let without_room = free.on_web.map(|masses| masses.value(best.objective, best.value));
    let limited = designed(engine, index, duty, &around.task, Some(envelope))?;
    let thickness = match &limited.outcome {
        DesignOutcome::Found(best) => best.design.thickness,
        DesignOutcome::Infeasible(_) => around.task.thickness.most,
    };
    let room_is_exact = Some(around.is_exact(thickness));
    Ok(DesignedCounterweight { room: Some(envelope.nearest.clone()), room_is_exact, without_room, ..limited })
}

/// The task with the swept radius within the circle of an envelope.
pub(crate) fn within(task: &ShapeTask, envelope: Option<&ClearanceEnvelope>) -> ShapeTask {
    let mut task = *task;
    if let Some(circle) = envelope.map(|envelope| envelope.circle).filter(|circle| circle.is_finite()) {
        // A radius of nothing is no limit that a task can have: no shape is that small.
        let circle = circle.max(1e-9);
        task.limits.swept_radius = Some(task.limits.swept_radius.map_or(circle, |limit| limit.min(circle)));
    }
    task
}

/// Whether a weight with this design keeps the wanted clearance to everything, proved.
fn keeps_clear(
    engine: &Engine,
    index: usize,
    design: &Design,
    density: f64,
) -> Result<bool, CounterweightError> {
    let fitted = with_counterweights(engine, &[(index, *design)], density)?;
    let name = &engine.counterweights[index].name;
    let clearances = clearances(&fitted)?;
    let own = clearances.bodies.iter().filter(|body| body.name == *name);
    let mut all = own.flat_map(|body| &body.clearances);
    Ok(all.all(|one| one.is_kept))
}

/// The best shape within an envelope whose weight on its web is the duty.
fn designed(
    engine: &Engine,
    index: usize,
    duty: f64,
    task: &ShapeTask,
    envelope: Option<&ClearanceEnvelope>,
) -> Result<DesignedCounterweight, CounterweightError> {
    let mut seat = WebSeat::new(engine, task.density, [(index, envelope.cloned())]);
    let asked = DesignTask::new(duty, &within(task, envelope));
    let outcome = design_on(&asked, task.minimise, &mut seat)?;
    if let Some(fault) = seat.fault {
        return Err(fault);
    }
    let name = engine.counterweights[index].name.clone();
    let none = DesignedCounterweight {
        name,
        index,
        duty,
        shared: 0.0,
        on_web: None,
        room: None,
        room_is_exact: None,
        without_room: None,
        outcome,
        evolution: None,
    };
    let DesignOutcome::Found(best) = &none.outcome else { return Ok(none) };
    let (part, weight) = fitted_part(engine, index, &best.design, task.density)?;
    let shared = best.design.unbalance - weight.unbalance;
    Ok(DesignedCounterweight { shared, on_web: Some(on_web(engine, &part)?), ..none })
}

/// How far a weight stands from the opposite of its crankpin, without its sign [rad].
fn tilt(engine: &Engine, weight: &Counterweight) -> f64 {
    let Some(web) = web_of(engine, weight) else { return 0.0 };
    let off = weight.angle - engine.throws[web / 2].angle - PI;
    ((off + PI).rem_euclid(TAU) - PI).abs()
}

/// The front between what the task makes small and `against`, for weights of one duty: every design within the clearance envelope, and with
/// what the shape shares with the flank of its web made up for.
///
/// # Errors
/// As [`design_counterweights`], and where the weights have different duties or there are not two objectives.
pub fn counterweight_front(
    engine: &Engine,
    request: &CounterweightRequest,
    against: Objective,
    count: usize,
) -> Result<CounterweightFront, CounterweightError> {
    let duties = duties(engine, request)?;
    let duty = duties[0].1;
    if duties.iter().any(|(_, other)| *other != duty) {
        let words =
            |(index, duty): &(usize, f64)| format!("{} {:.6} kg m", engine.counterweights[*index].name, duty);
        return Err(CounterweightError::Duties { duties: duties.iter().map(words).collect() });
    }
    // Of weights that stand alike one tells for all.
    let mut places: Vec<(usize, f64, Surroundings)> = Vec::new();
    for (index, _) in &duties {
        let around = Surroundings::of(engine, *index, &request.task)?;
        let tilt = tilt(engine, &engine.counterweights[*index]);
        if !places.iter().any(|known| (known.1 - tilt).abs() < 1e-9 && known.2.is_like(&around)) {
            places.push((*index, tilt, around));
        }
    }
    let mut task = request.task;
    for (.., around) in &places {
        task.thickness.most = task.thickness.most.min(around.task.thickness.most);
        task = within(&task, around.envelope.as_ref());
    }
    let nearest = places.iter().filter_map(|(.., around)| around.envelope.as_ref());
    let room = nearest.map(|envelope| envelope.nearest.clone());
    let room = room.min_by(|a, b| a.radius.total_cmp(&b.radius));
    let seats = places.iter().map(|(index, _, around)| (*index, around.envelope.clone()));
    let mut seat = WebSeat::new(engine, task.density, seats);
    let front = front_on(&DesignTask::new(duty, &task), [task.minimise, against], count, &mut seat)?;
    if let Some(fault) = seat.fault {
        return Err(fault);
    }
    let masses = front.designs.iter().map(|design| {
        let (part, _) = fitted_part(engine, duties[0].0, design, task.density)?;
        on_web(engine, &part)
    });
    let on_web = masses.collect::<Result<Vec<OnWeb>, CounterweightError>>()?;
    let weights = duties.into_iter().map(|(index, _)| index).collect();
    Ok(CounterweightFront { weights, room, front, on_web })
}

/// A design of a front for all of its weights, each with what it shares with the flank of its own web made up for: the best shape with no
/// more of the second objective, or, at that end of the front, the one with the least of it.
///
/// # Errors
/// As [`design_counterweights`].
pub fn adopted(
    engine: &Engine,
    request: &CounterweightRequest,
    front: &CounterweightFront,
    design: &Design,
) -> Result<Vec<(usize, Design)>, CounterweightError> {
    let [first, second] = front.front.objectives;
    let adopt = |index: &usize| {
        let around = Surroundings::of(engine, *index, &request.task)?;
        let end = ShapeTask { minimise: first, ..around.task };
        let mut task = end;
        // A little more than the design has, so that there is more than one shape left.
        let room = |value: f64| value * (1.0 + ROOM);
        match second {
            Objective::Mass => task.limits.mass = Some(room(design.mass)),
            Objective::SweptRadius => task.limits.swept_radius = Some(room(design.swept_radius)),
            Objective::Inertia => task.limits.inertia = Some(room(design.inertia)),
            Objective::Thickness => task.thickness.most = room(design.thickness).min(end.thickness.most),
        }
        let duty = request.unbalance.unwrap_or_else(|| duty_of(&engine.counterweights[*index]));
        for task in [task, ShapeTask { minimise: second, ..end }] {
            let found = designed(engine, *index, duty, &task, around.envelope.as_ref())?;
            if let DesignOutcome::Found(best) = found.outcome {
                return Ok((*index, best.design));
            }
        }
        Ok((*index, *design))
    };
    front.weights.iter().map(adopt).collect()
}

/// Part of the second objective by which an adopted design may pass that of the front.
const ROOM: f64 = 1e-7;

/// The unbalance that a weight should have [kg m].
pub(crate) fn duty_of(weight: &Counterweight) -> f64 {
    weight.part.as_ref().and_then(|part| part.wanted).unwrap_or(weight.unbalance)
}

/// The indices of the weights that are asked for, each with its duty [kg m].
fn duties(engine: &Engine, request: &CounterweightRequest) -> Result<Vec<(usize, f64)>, CounterweightError> {
    let mut found = Vec::new();
    for index in chosen(engine, &request.weights)? {
        let weight = &engine.counterweights[index];
        let duty = request.unbalance.unwrap_or_else(|| duty_of(weight));
        if duty > 0.0 {
            found.push((index, duty));
        } else if !request.weights.is_empty() {
            return Err(CounterweightError::NoDuty { name: weight.name.clone() });
        }
    }
    if found.is_empty() {
        return Err(CounterweightError::NoneOnAWeb { has_weights: !engine.counterweights.is_empty() });
    }
    Ok(found)
}

/// The indices of the weights of these names; without names of those on webs, but for outlines of the user's own.
pub(crate) fn chosen(engine: &Engine, names: &[String]) -> Result<Vec<usize>, CounterweightError> {
    let weights = &engine.counterweights;
    if names.is_empty() {
        let own = |weight: &Counterweight| {
            weight.part.as_ref().is_some_and(|part| !matches!(part.form, CounterweightForm::Family(_)))
        };
        let on_web = |index: &usize| !own(&weights[*index]) && web_of(engine, &weights[*index]).is_some();
        return Ok((0..weights.len()).filter(on_web).collect());
    }
    let mut found = Vec::new();
    for name in names {
        let of_name: Vec<usize> = (0..weights.len()).filter(|k| weights[*k].name == *name).collect();
        if of_name.is_empty() {
            let mut known: Vec<String> =
                weights.iter().map(|weight| format!("\"{}\"", weight.name)).collect();
            known.dedup();
            return Err(CounterweightError::Unknown { name: name.clone(), known: known.join(", ") });
        }
        found.extend(of_name);
    }
    found.sort_unstable();
    found.dedup();
    Ok(found)
}

/// The web in whose plane a weight stands, counted through all throws.
pub(crate) fn web_of(engine: &Engine, weight: &Counterweight) -> Option<usize> {
    if let Some(part) = &weight.part {
        return part.web;
    }
    let webs = engine.throws.iter().enumerate().flat_map(|(index, throw)| {
        let planes = throw.webs.filter(|_| throw.crankshaft == weight.crankshaft);
        planes.into_iter().flatten().enumerate().map(move |(side, z)| (2 * index + side, z))
    });
    let mut near = webs.filter(|(_, z)| (z - weight.z).abs() < 1e-9);
    // The web between two pins is no place for a shape.
    let shared: Vec<usize> = engine.shared_webs().into_iter().flat_map(|shared| shared.webs()).collect();
    near.next().map(|(web, _)| web).filter(|web| engine.crank_body.is_none() || !shared.contains(web))
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_geometry::{DesignLimits, Range};

    const SINGLE: &str = r#"
name = "single"
speed = "3000 rpm"
[layout]
type = "in-line"
cylinders = 1
[crank]
stroke = "90 mm"
web_distance = "50 mm"
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"
[[counterweight]]
web = 1
unbalance = "30 kg mm"
[[counterweight]]
web = 2
unbalance = "30 kg mm"
[[counterweight]]
name = "flywheel"
z = "100 mm"
unbalance = "1 kg mm"
"#;

    fn engine() -> Engine {
        lanchester_model::read(SINGLE).engine.expect("the file has no mistakes")
    }

    fn task() -> ShapeTask {
        ShapeTask {
            minimise: Objective::Mass,
            least_balance: 1.0,
            most_balance: None,
            density: 7850.0,
            web_radius: Range::fixed(0.045),
            rectangle_height: Range::new(0.0, 0.03),
            shoulder: Shoulder::Height(Range::new(0.0, 0.03)),
            arc_radius: Range::new(0.05, 0.1),
            arc_angle: Range::new(1.0, 3.1),
            thickness: Range::new(0.01, 0.025),
            limits: DesignLimits::default(),
        }
    }

    fn request(weights: &[&str]) -> CounterweightRequest {
        let weights = weights.iter().map(|name| (*name).to_owned()).collect();
        CounterweightRequest { weights, unbalance: None, task: task(), evolution: None }
    }

    #[test]
    fn weights_on_webs_are_designed_and_fitted() {
        let engine = engine();
        let designs = design_counterweights(&engine, &request(&[])).unwrap();
        let names: Vec<&str> = designs.weights.iter().map(|weight| weight.name.as_str()).collect();
        assert_eq!(names, ["web 1", "web 2"]);
        assert_eq!(designs.weights[0].outcome, designs.weights[1].outcome);
        assert!(designs.weights[0].evolution.is_none());
        let DesignOutcome::Found(best) = &designs.weights[0].outcome else { panic!("it can be met") };
        assert!(best.proved);
        let fitted = with_counterweights(&engine, &[(0, best.design)], 7850.0).unwrap();
        let weight = &fitted.counterweights[0];
        assert!((weight.unbalance - 0.03).abs() < 1e-10);
        assert_eq!(weight.angle, engine.counterweights[0].angle);
        let part = weight.part.as_ref().unwrap();
        assert_eq!((part.web, part.wanted), (Some(0), Some(0.03)));
        assert!(fitted.counterweights[1].part.is_none());
    }

    #[test]
    fn evolution_stands_beside_the_optimum() {
        let search = EvolutionRequest { seed: 7, evaluations: 2000 };
        let request = CounterweightRequest { evolution: Some(search), ..request(&[]) };
        let designs = design_counterweights(&engine(), &request).unwrap();
        let DesignOutcome::Found(best) = &designs.weights[1].outcome else { panic!("it can be met") };
        let evolved = designs.weights[1].evolution.as_ref().unwrap().best.unwrap();
        assert!(evolved.value >= best.bound);
    }

    #[test]
    fn what_cannot_be_designed_is_told() {
        let engine = engine();
        let error = design_counterweights(&engine, &request(&["web 3"])).unwrap_err().to_string();
        assert!(
            error.contains("\"web 3\"") && error.contains("\"web 1\", \"web 2\", \"flywheel\""),
            "{error}"
        );
        let bare = Engine { counterweights: Vec::new(), ..engine.clone() };
        let error = design_counterweights(&bare, &request(&[])).unwrap_err().to_string();
        assert!(error.contains("--counterweights webs"), "{error}");
        let both = request(&["web 1", "flywheel"]);
        let error = counterweight_front(&engine, &both, Objective::SweptRadius, 5).unwrap_err().to_string();
        assert!(error.contains("web 1 0.030000 kg m, flywheel 0.001000 kg m"), "{error}");
    }

    #[test]
    fn the_front_goes_from_one_end_to_the_other() {
        let found = counterweight_front(&engine(), &request(&[]), Objective::SweptRadius, 5).unwrap();
        assert_eq!((found.weights, found.room), (vec![0, 1], None));
        let front = found.front;
        assert!(front.proved && front.designs.len() >= 4);
        let ends = [&front.designs[0], front.designs.last().unwrap()];
        assert!(ends[0].mass < ends[1].mass && ends[0].swept_radius > ends[1].swept_radius);
    }
}
