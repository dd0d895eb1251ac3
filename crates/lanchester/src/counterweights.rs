//! The counterweights of an engine as parts: which of them, their duties, the best shapes.

use crate::clearance::{EngineClearanceError, clearances, largest_swept_radius};
use lanchester_geometry::clearance::SweptRoom;
use lanchester_geometry::crankshaft::CrankshaftError;
use lanchester_geometry::{
    Design, DesignOutcome, DesignTask, Evolution, Front, GeometryError, Objective, Outline, Part, ShapeTask,
    design, evolve, front,
};
use lanchester_model::{Counterweight, CounterweightForm, CounterweightPart, Engine, PartFault, PartWeight};
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Version of [`CounterweightDesigns`]; raised when a field changes its meaning or goes.
pub const COUNTERWEIGHT_DESIGNS_VERSION: u32 = 1;

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
    /// The room that the wanted clearance leaves, where it limits the swept radius; none where the best shape of all keeps the clearance,
    /// or there is nothing to stay clear of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub room: Option<SweptRoom>,
    /// With a room: what is made small, of the best shape without it [SI]. No shape that keeps the clearance has less.
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
    /// The room that the wanted clearance leaves, to which all swept radii are limited; none where there is nothing to stay clear of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub room: Option<SweptRoom>,
    /// The designs.
    pub front: Front,
}

/// Why no counterweight can be designed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CounterweightError {
    /// No weight on any web.
    #[error(
        "no counterweight stands on a web\nhint: {}", match .has_weights {
            true => "name one with --weight, or give the weights a web: `web = 1` in [[counterweight]], `at = \"webs\"` in [counterweights]",
            false => "`lanchester balance FILE --counterweights webs --write` finds them"
        }
    )]
    NoneOnAWeb {
        /// Whether there are weights elsewhere.
        has_weights: bool,
    },
    /// A name that no weight has.
    #[error("no counterweight is called \"{name}\"\nhint: the names are {known}")]
    Unknown {
        /// The name.
        name: String,
        /// The names that there are.
        known: String,
    },
    /// A weight without any unbalance.
    #[error(
        "counterweight \"{name}\" has no unbalance to be designed for\nhint: give one, or leave the weight out"
    )]
    NoDuty {
        /// Its name.
        name: String,
    },
    /// Weights of different duties where one is due.
    #[error(
        "the weights have different duties: {}\nhint: name one of them, or give one unbalance for all", .duties.join(", ")
    )]
    Duties {
        /// Each weight with its duty, in words.
        duties: Vec<String>,
    },
    /// A name that several weights have.
    #[error("{count} counterweights are called \"{name}\"\nhint: give each its own name")]
    Several {
        /// The name.
        name: String,
        /// How many have it.
        count: usize,
    },
    /// A whole web where the engine has no plain one to take the place of.
    #[error(
        "the outline of a whole web needs a weight on a web, and [crank.body] for the plain web that it replaces; \"{name}\" has not both\nhint: draw the counterweight alone, or add them to the engine file"
    )]
    NoPlainWeb {
        /// Name of the weight.
        name: String,
    },
    /// A part that is no single weight, or does not fit its web.
    #[error("counterweight \"{name}\": {fault}\nhint: change its outline or its inserts")]
    Fault {
        /// Name of the weight.
        name: String,
        /// What is wrong.
        fault: String,
    },
    /// Something that the crankshaft must stay clear of and that is not told completely.
    #[error(transparent)]
    Clearance(#[from] EngineClearanceError),
    /// A crankshaft that is no body.
    #[error(transparent)]
    Crankshaft(#[from] CrankshaftError),
    /// A name that no balance shaft has.
    #[error("no balance shaft is called \"{name}\"\nhint: {}", match .known.as_str() {
        "" => "the file has no [[shaft]]".to_owned(),
        known => format!("the names are {known}"),
    })]
    UnknownShaft {
        /// The name.
        name: String,
        /// The names that there are.
        known: String,
    },
    /// A balance shaft none of whose weights is a part.
    #[error(
        "no weight of the shaft \"{name}\" has a shape yet\nhint: `lanchester counterweight design FILE --write` finds shapes where the file has a section [shaft_weight_design]"
    )]
    BareShaft {
        /// Name of the shaft.
        name: String,
    },
    /// No weight that is a part.
    #[error(
        "no counterweight and no weight of a balance shaft has a shape yet\nhint: `lanchester counterweight design FILE --write` finds shapes, `counterweight import` takes them from a drawing"
    )]
    NoPart,
    /// Numbers of the task that have no meaning.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
}

/// The best shape for each weight that is asked for, with its proof.
///
/// Where the engine says what the crankshaft must stay clear of, and the best shape does not, the swept radius is limited to what keeps
/// the wanted clearance whatever the shape: sufficient, not necessary. What a shape shares with its plain web beyond the disc is the
/// web's, so that the shape gets that much more.
///
/// # Errors
/// Where a weight is not there or has no duty, or a number of the task has no meaning. Limits that no shape meets are an
/// outcome.
pub fn design_counterweights(
    engine: &Engine,
    request: &CounterweightRequest,
) -> Result<CounterweightDesigns, CounterweightError> {
    let mut weights: Vec<DesignedCounterweight> = Vec::new();
    let mut done: Vec<(f64, f64, Option<SweptRoom>, usize)> = Vec::new();
    for (index, duty) in duties(engine, request)? {
        let weight = &engine.counterweights[index];
        let name = weight.name.clone();
        let room = room(engine, weight, request.task.thickness.most)?;
        // Weights of one duty that stand alike on their webs have one shape.
        let tilt = tilt(engine, weight);
        let alike = |known: &&(f64, f64, Option<SweptRoom>, usize)| {
            known.0 == duty
                && (known.1 - tilt).abs() < 1e-9
                && known.2.as_ref().map(|room| room.radius) == room.as_ref().map(|room| room.radius)
        };
        if let Some((.., first)) = done.iter().find(alike) {
            weights.push(DesignedCounterweight { name, index, ..weights[*first].clone() });
            continue;
        }
        done.push((duty, tilt, room.clone(), weights.len()));
        let designed = cleared(engine, index, duty, &request.task, room)?;
        let task = within(&request.task, designed.room.as_ref());
        let asked = DesignTask::new(duty + designed.shared / task.least_balance, &task);
        let search =
            |search: EvolutionRequest| evolve(&asked, task.minimise, search.seed, search.evaluations);
        let evolution = request.evolution.map(search).transpose()?;
        weights.push(DesignedCounterweight { name, evolution, ..designed });
    }
    Ok(CounterweightDesigns {
        version: COUNTERWEIGHT_DESIGNS_VERSION,
        engine: engine.name.clone(),
        task: request.task,
        weights,
    })
}

/// The best shape that keeps the wanted clearance: the best of all, if that one does; else the best within a swept radius that keeps it
/// whatever the shape.
fn cleared(
    engine: &Engine,
    index: usize,
    duty: f64,
    task: &ShapeTask,
    room: Option<SweptRoom>,
) -> Result<DesignedCounterweight, CounterweightError> {
    let name = engine.counterweights[index].name.clone();
    let (outcome, shared) = designed(engine, index, duty, task)?;
    let free = DesignedCounterweight {
        name,
        index,
        duty,
        shared,
        room: None,
        without_room: None,
        outcome,
        evolution: None,
    };
    let (Some(room), DesignOutcome::Found(best)) = (room, &free.outcome) else { return Ok(free) };
    if best.design.swept_radius <= room.radius || keeps_clear(engine, index, &best.design, task.density)? {
        return Ok(free);
    }
    let without_room = Some(best.value);
    let (outcome, shared) = designed(engine, index, duty, &within(task, Some(&room)))?;
    Ok(DesignedCounterweight { shared, room: Some(room), without_room, outcome, ..free })
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

/// The best shape whose weight on its web is the duty, and what of it the plain web has already [kg m].
fn designed(
    engine: &Engine,
    index: usize,
    duty: f64,
    task: &ShapeTask,
) -> Result<(DesignOutcome, f64), CounterweightError> {
    let mut shared = 0.0;
    // What is shared changes little with the shape: each step leaves a small part of the step before.
    for _ in 0..MOST_STEPS {
        let outcome = design(&DesignTask::new(duty + shared / task.least_balance, task), task.minimise)?;
        let DesignOutcome::Found(best) = &outcome else { return Ok((outcome, shared)) };
        let (_, weight) = fitted_part(engine, index, &best.design, task.density)?;
        let now = best.design.unbalance - weight.unbalance;
        if (now - shared).abs() <= SAME * duty {
            return Ok((outcome, now));
        }
        shared = now;
    }
    let outcome = design(&DesignTask::new(duty + shared / task.least_balance, task), task.minimise)?;
    Ok((outcome, shared))
}

/// Steps after which what is shared is known to rounding, or never.
const MOST_STEPS: usize = 8;
/// Directions closer than this are the same [rad].
const SAME_DIRECTION: f64 = 1e-11;
/// Share of the duty within which what is shared is known.
const SAME: f64 = 1e-10;

/// The room that the wanted clearance leaves around a weight of this largest thickness [m], if there is anything to stay clear of.
fn room(
    engine: &Engine,
    weight: &Counterweight,
    thickness: f64,
) -> Result<Option<SweptRoom>, CounterweightError> {
    if engine.envelope.is_none() {
        return Ok(None);
    }
    let z = weight.part.as_ref().map_or(weight.z, |part| part.z);
    let faces = [z - thickness / 2.0, z + thickness / 2.0];
    Ok(largest_swept_radius(engine, weight.crankshaft, faces)?)
}

/// The task with the swept radius within a room.
fn within(task: &ShapeTask, room: Option<&SweptRoom>) -> ShapeTask {
    let mut task = *task;
    if let Some(room) = room {
        // A radius of nothing is no limit that a task can have: no shape is that small.
        let radius = room.radius.max(1e-9);
        task.limits.swept_radius = Some(task.limits.swept_radius.map_or(radius, |limit| limit.min(radius)));
    }
    task
}

/// How far a weight stands from the opposite of its crankpin, without its sign [rad].
fn tilt(engine: &Engine, weight: &Counterweight) -> f64 {
    let Some(web) = web_of(engine, weight) else { return 0.0 };
    let off = weight.angle - engine.throws[web / 2].angle - PI;
    ((off + PI).rem_euclid(TAU) - PI).abs()
}

/// The front between what the task makes small and `against`, for weights of one duty. What a shape shares with the flank of its
/// web is not made up for here: [`adopted`] does that for the design that is taken.
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
    let rooms: Vec<SweptRoom> = duties
        .iter()
        .filter_map(|(index, _)| {
            room(engine, &engine.counterweights[*index], request.task.thickness.most).transpose()
        })
        .collect::<Result<_, _>>()?;
    let room = rooms.into_iter().min_by(|a, b| a.radius.total_cmp(&b.radius));
    let task = within(&request.task, room.as_ref());
    let front = front(&DesignTask::new(duty, &task), [task.minimise, against], count)?;
    let weights = duties.into_iter().map(|(index, _)| index).collect();
    Ok(CounterweightFront { weights, room, front })
}

/// A design of a front for all of its weights, each with what the shape shares with the flank of its web made up for: the best shape with no
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
    let end = within(&request.task, front.room.as_ref());
    let [first, second] = front.front.objectives;
    let mut task = ShapeTask { minimise: first, ..end };
    match second {
        Objective::Mass => task.limits.mass = Some(design.mass),
        Objective::SweptRadius => task.limits.swept_radius = Some(design.swept_radius),
        Objective::Inertia => task.limits.inertia = Some(design.inertia),
        Objective::Thickness => task.thickness.most = design.thickness,
    }
    let adopt = |index: &usize| {
        let duty = request.unbalance.unwrap_or_else(|| duty_of(&engine.counterweights[*index]));
        for task in [task, ShapeTask { minimise: second, ..end }] {
            if let (DesignOutcome::Found(best), _) = designed(engine, *index, duty, &task)? {
                return Ok((*index, best.design));
            }
        }
        Ok((*index, *design))
    };
    front.weights.iter().map(adopt).collect()
}

/// The engine with `design`s, of this density [kg/m^3], in the place of the weights of these indices.
///
/// # Errors
/// Where a design is no part: a density or a thickness that no part can have, or one that does not fit its web.
pub fn with_counterweights(
    engine: &Engine,
    designs: &[(usize, Design)],
    density: f64,
) -> Result<Engine, CounterweightError> {
    let mut fitted = engine.clone();
    for (index, design) in designs {
        let (part, weight) = fitted_part(engine, *index, design, density)?;
        fit(&mut fitted, *index, part, weight);
    }
    Ok(fitted)
}

/// The engine with an outline of the user's own in the place of the weight of this name.
///
/// # Errors
/// Where there is no such weight or there are several, where a whole web stands on no web or the engine says nothing of plain
/// webs, or where the part is no single weight.
pub fn with_outline(
    engine: &Engine,
    name: &str,
    form: CounterweightForm,
    part: Part,
) -> Result<Engine, CounterweightError> {
    let indices = chosen(engine, &[name.to_owned()])?;
    let [index] = indices[..] else {
        return Err(CounterweightError::Several { name: name.to_owned(), count: indices.len() });
    };
    let old = &engine.counterweights[index];
    let web = web_of(engine, old);
    if form == CounterweightForm::Web && (web.is_none() || engine.crank_body.is_none()) {
        return Err(CounterweightError::NoPlainWeb { name: name.to_owned() });
    }
    let angle = old.part.as_ref().map_or(old.angle, |part| part.angle);
    let part = CounterweightPart { form, part, web, z: plane(old), angle, wanted: Some(duty_of(old)) };
    let weight = engine.part_weight(&part).map_err(|fault| refused(engine, index, &fault))?;
    let mut fitted = engine.clone();
    fit(&mut fitted, index, part, weight);
    Ok(fitted)
}

/// Puts a part in the place of a weight: plane, unbalance and direction become those of the part.
fn fit(fitted: &mut Engine, index: usize, part: CounterweightPart, weight: PartWeight) {
    let old = &mut fitted.counterweights[index];
    (old.z, old.unbalance, old.angle) = (weight.z, weight.unbalance, weight.angle);
    old.part = Some(Box::new(part));
}

/// A design as the part in the place of a weight, turned such that its unbalance points where that of the weight does: what it shares
/// with the flank of its web may lie to one side.
fn fitted_part(
    engine: &Engine,
    index: usize,
    design: &Design,
    density: f64,
) -> Result<(CounterweightPart, PartWeight), CounterweightError> {
    let old = &engine.counterweights[index];
    let part = Part::new(Outline::from(design.shape.outline()), design.thickness, density)?;
    let mut part = CounterweightPart {
        form: CounterweightForm::Family(design.shape),
        part,
        web: web_of(engine, old),
        z: plane(old),
        angle: old.angle,
        wanted: Some(duty_of(old)),
    };
    for _ in 0..MOST_STEPS {
        let weight = engine.part_weight(&part).map_err(|fault| refused(engine, index, &fault))?;
        let off = (old.angle - weight.angle + PI).rem_euclid(TAU) - PI;
        if off.abs() <= SAME_DIRECTION {
            return Ok((part, weight));
        }
        part.angle += off;
    }
    let weight = engine.part_weight(&part).map_err(|fault| refused(engine, index, &fault))?;
    Ok((part, weight))
}

/// Plane in which the middle of a part stands that takes the place of a weight [m].
fn plane(old: &Counterweight) -> f64 {
    old.part.as_ref().map_or(old.z, |part| part.z)
}

fn refused(engine: &Engine, index: usize, fault: &PartFault) -> CounterweightError {
    CounterweightError::Fault { name: engine.counterweights[index].name.clone(), fault: fault.to_string() }
}

/// The unbalance that a weight should have [kg m].
fn duty_of(weight: &Counterweight) -> f64 {
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

/// Whether a weight stands in the plane of a web.
pub(crate) fn stands_on_a_web(engine: &Engine, weight: &Counterweight) -> bool {
    web_of(engine, weight).is_some()
}

/// The web in whose plane a weight stands, counted through all throws.
fn web_of(engine: &Engine, weight: &Counterweight) -> Option<usize> {
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
    use lanchester_geometry::{DesignLimits, Range, Shoulder};

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
