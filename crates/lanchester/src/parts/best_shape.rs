//! The best shape of one counterweight on its web, within everything that moves past it.

use crate::parts::clearance::{clearance_model, largest_swept_radius};
use crate::parts::duty::{duty_of, tilt, web_of};
use crate::parts::error::CounterweightError;
use lanchester_geometry::clearance::{RadialEnvelope, SweptRoom};
use lanchester_geometry::{
    Design, DesignOutcome, DesignTask, Evolution, Limit, NearestLimit, Objective, Optimum, Outline, Part,
    ShapeTask, counterweight_properties, design_within, evolve, largest_balance,
};
use lanchester_model::{
    Counterweight, CounterweightForm, CounterweightPart, Engine, EngineParts, PartFault, PartWeight,
};
use lanchester_numerics::about_zero;
use lanchester_report::obstacle_name;
use serde::Serialize;
use std::cell::{Cell, RefCell};
use std::f64::consts::TAU;

/// Steps after which what is shared is known to rounding, or never.
const MOST_STEPS: usize = 24;
/// Directions closer than this are the same [rad].
const SAME_DIRECTION: f64 = 1e-11;
/// Share of the duty within which what is shared is known.
const SAME: f64 = 1e-10;
/// Envelopes that differ by less are the same [m].
const SAME_RADIUS: f64 = 3e-7;
/// How often an envelope is drawn nearer where a shape within it misses the clearance between two of its directions.
pub(crate) const MOST_ROUNDS: usize = 6;
/// Part of the largest unbalance that a shape can have which is not promised: without it too few shapes are left to find one.
const MARGIN: f64 = 3e-5;

/// An evolutionary search, as the tool paper has it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EvolutionRequest {
    /// Where its random numbers begin.
    pub seed: u64,
    /// How many designs it looks at.
    pub evaluations: usize,
}

/// What a shape shares with its plain web beyond the web's disc: it is the web's.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct SharedWithWeb {
    /// Mass [kg].
    pub mass: f64,
    /// Unbalance [kg m].
    pub unbalance: f64,
    /// Polar inertia about the crank axis [kg m^2].
    pub inertia: f64,
}

/// How often a limit is eased anew until it leaves a shape, and how far beyond its nearest value.
const MOST_EASED: usize = 8;
const EASED: f64 = 1e-6;

/// Share of its value by which a limit goes farther that still leaves no shape.
const FARTHER: f64 = 1e-4;

/// The best shape for one weight.
#[derive(Debug, Clone)]
pub(crate) struct BestShape {
    pub duty: f64,
    pub task: ShapeTask,
    pub shared: SharedWithWeb,
    pub room: Option<SweptRoom>,
    pub envelope: Option<RadialEnvelope>,
    pub without_room: Option<f64>,
    pub outcome: DesignOutcome,
    /// The envelope that the search began with.
    first: Option<RadialEnvelope>,
    /// The best shape where nothing is in the way.
    free: Option<Design>,
}

impl BestShape {
    /// The best shape that keeps the wanted clearance: the best of all, if that one does; else the best within the envelope. Where there is
    /// none, every limit that is told does leave one at the value that is told.
    pub fn find(
        engine: &Engine,
        index: usize,
        duty: f64,
        task: &ShapeTask,
    ) -> Result<BestShape, CounterweightError> {
        let mut best = BestShape::find_as_asked(engine, index, duty, task)?;
        let DesignOutcome::Infeasible(infeasible) = &mut best.outcome else { return Ok(best) };
        let mut nearest = Vec::new();
        for limit in &infeasible.nearest {
            nearest.extend(attainable(engine, index, duty, task, limit)?);
        }
        infeasible.nearest = nearest;
        Ok(best)
    }

    /// As [`BestShape::find`]; where there is none, limits are told as far as the last envelope knows them, which takes no further search.
    pub fn find_as_asked(
        engine: &Engine,
        index: usize,
        duty: f64,
        task: &ShapeTask,
    ) -> Result<BestShape, CounterweightError> {
        let (outcome, shared) = designed(engine, index, duty, task, None)?;
        let best = BestShape {
            duty,
            task: *task,
            shared,
            room: None,
            envelope: None,
            first: None,
            without_room: None,
            outcome,
            free: None,
        };
        let DesignOutcome::Found(found) = &best.outcome else { return Ok(best) };
        if missed(engine, index, &found.design, task.density)?.is_none() {
            return Ok(best);
        }
        let (free, without_room) = (found.design, Some(found.value));
        let task = thin_enough(engine, index, task)?;
        let room = room(engine, index, task.thickness.most)?;
        let mut envelope = envelope(engine, index, &free, &task)?;
        if room.is_some() {
            envelope = beyond_disc(envelope, &task, room.as_ref());
        }
        let last = RefCell::new(envelope.clone());
        let first = Some(envelope.clone());
        let (outcome, shared) = clear_of(engine, index, &task, envelope.clone(), |envelope| {
            last.replace(envelope.clone());
            let (outcome, shared) = designed(engine, index, duty, &task, Some(envelope))?;
            let design = match &outcome {
                DesignOutcome::Found(best) => Some(best.design),
                DesignOutcome::Infeasible(_) => None,
            };
            Ok((design, (outcome, shared)))
        })?;
        // What is told is what bounds the shape: in the end it may be the circle.
        let last = last.into_inner();
        let envelope = Some(if last.is_round() { last } else { envelope });
        Ok(BestShape { room, envelope, first, without_room, free: Some(free), outcome, shared, ..best })
    }

    /// Whether it is the best for another weight that has its duty and stands on its web as this one does.
    pub fn is_best_for(&self, engine: &Engine, index: usize) -> Result<bool, CounterweightError> {
        match (&self.outcome, &self.first, &self.free) {
            (DesignOutcome::Found(best), None, _) => {
                Ok(missed(engine, index, &best.design, self.task.density)?.is_none())
            }
            (_, Some(known), Some(free)) => {
                let task = thin_enough(engine, index, &self.task)?;
                let own = envelope(engine, index, free, &task)?;
                let mut radii = own.radii.iter().zip(&known.radii);
                Ok(radii.all(|(own, known)| (own - known).abs() < SAME_RADIUS))
            }
            _ => Ok(true),
        }
    }

    /// An evolutionary search for the same weight, within the swept radius that keeps clear whatever the shape.
    pub fn evolve(
        &self,
        engine: &Engine,
        index: usize,
        search: EvolutionRequest,
    ) -> Result<Evolution, CounterweightError> {
        let mut task = self.task;
        if let Some(room) = &self.room {
            // A radius of nothing is no limit that a task can have: no shape is that small.
            let radius = room.radius.max(1e-9);
            task.limits.swept_radius =
                Some(task.limits.swept_radius.map_or(radius, |limit| limit.min(radius)));
        }
        let asked = asked(self.duty, &task, &self.shared);
        let mut found = evolve(&asked, task.minimise, search.seed, search.evaluations)?;
        if let Some(best) = &mut found.best {
            let shared = shared(engine, index, &best.design, task.density)?;
            best.design = on_web(&best.design, &shared, self.duty);
            best.value = best.design.value(task.minimise);
        }
        Ok(found)
    }

    /// The shape, where there is one.
    pub fn design(&self) -> Option<Design> {
        match &self.outcome {
            DesignOutcome::Found(best) => Some(best.design),
            DesignOutcome::Infeasible(_) => None,
        }
    }

    /// Mass of the part as it is exported [kg].
    pub fn part_mass(&self, engine: &Engine, index: usize) -> Result<Option<f64>, CounterweightError> {
        let DesignOutcome::Found(best) = &self.outcome else { return Ok(None) };
        let (part, _) = fitted_part(engine, index, &best.design, self.task.density)?;
        Ok(Some(part.part.moments().mass))
    }
}

/// A limit at a value that leaves a shape: the envelope and what is shared with the web follow the shape, so that a value which would do within
/// one of them may not do in the end. `None` where no value of this limit alone was found to.
fn attainable(
    engine: &Engine,
    index: usize,
    duty: f64,
    task: &ShapeTask,
    limit: &NearestLimit,
) -> Result<Option<NearestLimit>, CounterweightError> {
    let leaves_one = |value: f64| -> Result<Option<f64>, CounterweightError> {
        let at = NearestLimit { nearest: value, ..*limit };
        Ok(match BestShape::find_as_asked(engine, index, duty, &eased(task, &at))?.outcome {
            DesignOutcome::Found(_) => None,
            DesignOutcome::Infeasible(still) => {
                let next = still.nearest.iter().find(|one| one.limit == limit.limit);
                Some(next.map_or(value, |next| next.nearest))
            }
        })
    };
    let sign = if limit.limit == Limit::Balance { -1.0 } else { 1.0 };
    let (mut now, mut farther) = (limit.nearest, 0.0);
    for _ in 0..MOST_EASED {
        let Some(next) = leaves_one(now)? else {
            // Half the last step back, where that is enough.
            let back = now - 0.5 * sign * farther;
            let near = if farther > 0.0 && leaves_one(back)?.is_none() { back } else { now };
            return Ok(Some(NearestLimit { nearest: near, ..*limit }));
        };
        // What lies at the edge of the clearance may be missed by rounding, again and again.
        farther = f64::max(4.0 * farther, FARTHER * limit.nearest.abs());
        now = next + sign * farther;
    }
    Ok(None)
}

/// The task with a limit at its nearest value, and a millionth beyond.
fn eased(task: &ShapeTask, limit: &NearestLimit) -> ShapeTask {
    let mut task = *task;
    let most = limit.nearest * (1.0 + EASED);
    match limit.limit {
        Limit::Mass => task.limits.mass = Some(most),
        Limit::SweptRadius => task.limits.swept_radius = Some(most),
        Limit::Inertia => task.limits.inertia = Some(most),
        Limit::HalfWidth => task.limits.half_width = Some(most),
        Limit::Thickness => task.thickness.most = most,
        Limit::Balance => task.least_balance = limit.nearest * (1.0 - EASED),
    }
    task
}

/// The largest unbalances that weights can have on their webs, each searched once.
#[derive(Default)]
pub(crate) struct LargestShapes {
    /// How far a weight stands from the opposite of its crankpin, and its largest shape where nothing is in the way, beyond the disc and beyond the web.
    free: Vec<(f64, Option<[Design; 2]>)>,
    /// Beside that, the envelope, what fits in it [kg m], and whether it was the circle that bounded it.
    within: Vec<(f64, RadialEnvelope, f64, bool)>,
}

impl LargestShapes {
    /// The largest unbalance that a weight can have on its web in its direction, of all shapes that keep the wanted clearance [kg m], with what
    /// bounds it, in words; zero where no shape does.
    pub fn largest(
        &mut self,
        engine: &Engine,
        index: usize,
        task: &ShapeTask,
    ) -> Result<(f64, String), CounterweightError> {
        let by_shapes = || "the shapes of [counterweight_design]".to_owned();
        let promised = |design: &Design| (design.unbalance * (1.0 - MARGIN)).max(0.0);
        let tilt = tilt(engine, &engine.counterweights[index]);
        let is_known = |known: f64| (known - tilt).abs() < 1e-6;
        let free = match self.free.iter().find(|known| is_known(known.0)) {
            Some((_, free)) => *free,
            None => {
                let free = largest_shape(engine, index, task, None)?;
                self.free.push((tilt, free));
                free
            }
        };
        let Some([free, on_web]) = free else { return Ok((0.0, by_shapes())) };
        if missed(engine, index, &free, task.density)?.is_none() {
            return Ok((promised(&on_web), by_shapes()));
        }
        let task = thin_enough(engine, index, task)?;
        let around = envelope(engine, index, &free, &task)?;
        let by = |is_round: bool| -> Result<String, CounterweightError> {
            let circle = if is_round { room(engine, index, task.thickness.most)? } else { None };
            let limit = circle.map_or(around.limit, |circle| Some(circle.limit));
            Ok(limit.map_or_else(by_shapes, |limit| format!("clearance from {}", obstacle_name(limit))))
        };
        let known = self.within.iter().find(|(tilt, known, ..)| {
            let mut radii = known.radii.iter().zip(&around.radii);
            is_known(*tilt) && radii.all(|(known, own)| (known - own).abs() < SAME_RADIUS)
        });
        if let Some((.., bound, is_round)) = known {
            return Ok((*bound, by(*is_round)?));
        }
        let is_round = Cell::new(false);
        let found = clear_of(engine, index, &task, around.clone(), |envelope| {
            is_round.set(envelope.is_round());
            let found = largest_shape(engine, index, &task, Some(envelope))?;
            Ok((found.map(|[design, _]| design), found.map(|[_, on_web]| on_web)))
        })?;
        let bound = found.as_ref().map_or(0.0, promised);
        let by = by(is_round.get())?;
        self.within.push((tilt, around, bound, is_round.get()));
        Ok((bound, by))
    }
}

/// The shape with the largest unbalance within an envelope, beyond the disc and beyond the web.
fn largest_shape(
    engine: &Engine,
    index: usize,
    task: &ShapeTask,
    envelope: Option<&RadialEnvelope>,
) -> Result<Option<[Design; 2]>, CounterweightError> {
    // The duty is a scale alone.
    let scale = task.density * task.thickness.most * task.arc_radius.most.powi(3);
    let mut share = SharedWithWeb::default();
    let mut found = None;
    for _ in 0..MOST_STEPS {
        let asked = DesignTask { least_balance: 1.0, most_balance: None, ..asked(scale, task, &share) };
        let Some(design) = largest_balance(&asked, envelope)? else { return Ok(None) };
        let now = shared(engine, index, &design, task.density)?;
        found = Some([design, on_web(&design, &now, scale)]);
        // Only limits of mass and inertia depend on what is shared.
        let is_known = (now.mass - share.mass).abs() <= SAME * design.mass;
        if is_known || (task.limits.mass.is_none() && task.limits.inertia.is_none()) {
            break;
        }
        share = now;
    }
    Ok(found)
}

/// The envelope, or the radius that keeps clear whatever the shape where something comes nearer than the disc of the web: it does so without
/// any counterweight, and no shape can mend it.
fn beyond_disc(envelope: RadialEnvelope, task: &ShapeTask, room: Option<&SweptRoom>) -> RadialEnvelope {
    if envelope.smallest() < task.web_radius.least { envelope.rounded(room) } else { envelope }
}

/// What is found within an envelope and keeps clear between its directions too: until then the envelope is drawn nearer by what is missed, in the
/// end to the swept radius that keeps clear whatever the shape.
pub(crate) fn clear_of<T>(
    engine: &Engine,
    index: usize,
    task: &ShapeTask,
    envelope: RadialEnvelope,
    find: impl Fn(&RadialEnvelope) -> Result<(Option<Design>, T), CounterweightError>,
) -> Result<T, CounterweightError> {
    let room = room(engine, index, task.thickness.most)?;
    let last = envelope.rounded(room.as_ref());
    let mut now = beyond_disc(envelope, task, room.as_ref());
    for at in 0..=MOST_ROUNDS {
        let (design, found) = find(&now)?;
        let Some(design) = design else { return Ok(found) };
        // What is missed within the last one no shape can mend, as a gap beside the web that is too narrow.
        if at == MOST_ROUNDS {
            return Ok(found);
        }
        let Some(miss) = missed(engine, index, &design, task.density)? else { return Ok(found) };
        // Another shape may be turned on its web another way.
        now = if at == 0 {
            beyond_disc(self::envelope(engine, index, &design, task)?, task, room.as_ref())
        } else if at + 1 < MOST_ROUNDS {
            now.shrunk(1.05 * miss + 1e-7)
        } else {
            last.clone()
        };
    }
    unreachable!("invariant: the last round returns")
}

/// The best shape whose weight on its web is the duty, and what of it the plain web has already.
pub(crate) fn designed(
    engine: &Engine,
    index: usize,
    duty: f64,
    task: &ShapeTask,
    envelope: Option<&RadialEnvelope>,
) -> Result<(DesignOutcome, SharedWithWeb), CounterweightError> {
    let mut share = SharedWithWeb::default();
    // What is shared changes little with the shape: each step leaves a small part of the step before.
    for step in 0..=MOST_STEPS {
        let outcome = design_within(&asked(duty, task, &share), task.minimise, envelope)?;
        let best = match outcome {
            DesignOutcome::Found(best) => best,
            DesignOutcome::Infeasible(mut infeasible) => {
                for limit in &mut infeasible.nearest {
                    let less = match limit.limit {
                        Limit::Mass => share.mass,
                        Limit::Inertia => share.inertia,
                        _ => 0.0,
                    };
                    limit.asked -= less;
                    limit.nearest -= less;
                }
                return Ok((DesignOutcome::Infeasible(infeasible), share));
            }
        };
        let now = shared(engine, index, &best.design, task.density)?;
        if (now.unbalance - share.unbalance).abs() <= SAME * duty || step == MOST_STEPS {
            let best = optimum_on_web(&best, &now, duty);
            return Ok((DesignOutcome::Found(Box::new(best)), now));
        }
        share = now;
    }
    unreachable!("invariant: the last step returns")
}

/// The duty [kg m] of a shape within a task, with what it shares with its web on top.
pub(crate) fn asked(duty: f64, task: &ShapeTask, shared: &SharedWithWeb) -> DesignTask {
    let mut task = *task;
    task.limits.mass = task.limits.mass.map(|mass| mass + shared.mass);
    task.limits.inertia = task.limits.inertia.map(|inertia| inertia + shared.inertia);
    DesignTask::new(duty + shared.unbalance / task.least_balance, &task)
}

/// What a shape on the web of a weight shares with it.
pub(crate) fn shared(
    engine: &Engine,
    index: usize,
    design: &Design,
    density: f64,
) -> Result<SharedWithWeb, CounterweightError> {
    let (part, weight) = fitted_part(engine, index, design, density)?;
    let beyond = counterweight_properties(engine, &part)?;
    let moments = design.shape.moments();
    let whole = density * design.thickness;
    Ok(SharedWithWeb {
        mass: whole * moments.area - beyond.mass,
        unbalance: whole * moments.first.x - weight.unbalance,
        inertia: whole * moments.polar() - beyond.polar_inertia(),
    })
}

/// A design as what it adds to the crankshaft beyond its web.
pub(crate) fn on_web(design: &Design, shared: &SharedWithWeb, duty: f64) -> Design {
    let (mass, unbalance) = (design.mass - shared.mass, design.unbalance - shared.unbalance);
    Design {
        mass,
        unbalance,
        balance: unbalance / duty,
        centre: unbalance / mass,
        inertia: design.inertia - shared.inertia,
        ..*design
    }
}

fn optimum_on_web(best: &Optimum, shared: &SharedWithWeb, duty: f64) -> Optimum {
    let less = match best.objective {
        Objective::Mass => shared.mass,
        Objective::Inertia => shared.inertia,
        Objective::SweptRadius | Objective::Thickness => 0.0,
    };
    let bound = if best.proved { best.bound - less } else { 0.0 };
    let design = on_web(&best.design, shared, duty);
    Optimum { design, value: best.value - less, bound, ..best.clone() }
}

/// By how much a weight with this design misses the wanted clearance [m]; none where it keeps it, proved.
pub(crate) fn missed(
    engine: &Engine,
    index: usize,
    design: &Design,
    density: f64,
) -> Result<Option<f64>, CounterweightError> {
    if engine.envelope.is_none() {
        return Ok(None);
    }
    let (part, weight) = fitted_part(engine, index, design, density)?;
    let fitted = engine.with(|parts| fit(parts, index, part, weight)).map_err(CounterweightError::engine)?;
    // Counterweights with a shape come first, in their order.
    let body = fitted.counterweights[..index].iter().filter(|weight| weight.part.is_some()).count();
    Ok(clearance_model(&fitted)?.missed(body).map_err(crate::EngineClearanceError::from)?)
}

/// How far a weight may reach in each direction, turned on its web as a design of it is.
pub(crate) fn envelope(
    engine: &Engine,
    index: usize,
    design: &Design,
    task: &ShapeTask,
) -> Result<RadialEnvelope, CounterweightError> {
    let weight = &engine.counterweights[index];
    let (part, _) = fitted_part(engine, index, design, task.density)?;
    let faces = [plane(weight) - task.thickness.most / 2.0, plane(weight) + task.thickness.most / 2.0];
    let reach = 4.0 * (task.arc_radius.most + task.rectangle_height.most);
    let most = task.limits.swept_radius.map_or(reach, |limit| limit.min(reach));
    let throw = web_of(engine, weight).map(|web| web / 2);
    let model = clearance_model(engine)?;
    let found = model.radial_envelope(weight.crankshaft, throw, faces, part.angle, most);
    Ok(found.map_err(crate::EngineClearanceError::from)?)
}

/// The task with no more thickness than rods leave beside the web.
pub(crate) fn thin_enough(
    engine: &Engine,
    index: usize,
    task: &ShapeTask,
) -> Result<ShapeTask, CounterweightError> {
    let mut task = *task;
    if engine.envelope.is_some() {
        let weight = &engine.counterweights[index];
        let throw = web_of(engine, weight).map(|web| web / 2);
        let range = [task.thickness.least, task.thickness.most];
        let model = clearance_model(engine)?;
        task.thickness.most = model.thickness_between_rods(weight.crankshaft, throw, plane(weight), range);
    }
    Ok(task)
}

/// The swept radius that keeps the wanted clearance around a weight of this largest thickness [m], if there is anything to stay clear of.
pub(crate) fn room(
    engine: &Engine,
    index: usize,
    thickness: f64,
) -> Result<Option<SweptRoom>, CounterweightError> {
    if engine.envelope.is_none() {
        return Ok(None);
    }
    let weight = &engine.counterweights[index];
    let z = plane(weight);
    Ok(largest_swept_radius(engine, weight.crankshaft, [z - thickness / 2.0, z + thickness / 2.0])?)
}

/// Puts a part in the place of a weight: plane, unbalance and direction become those of the part.
pub(crate) fn fit(fitted: &mut EngineParts, index: usize, part: CounterweightPart, weight: PartWeight) {
    let old = &mut fitted.counterweights[index];
    (old.z, old.unbalance, old.angle) = (weight.z, weight.unbalance, weight.angle);
    old.part = Some(Box::new(part));
}

/// A design as the part in the place of a weight, turned such that its unbalance points where that of the weight does: what it shares
/// with the flank of its web may lie to one side.
pub(crate) fn fitted_part(
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
        let off = about_zero(old.angle - weight.angle, TAU);
        if off.abs() <= SAME_DIRECTION {
            return Ok((part, weight));
        }
        part.angle += off;
    }
    let weight = engine.part_weight(&part).map_err(|fault| refused(engine, index, &fault))?;
    Ok((part, weight))
}

/// Plane in which the middle of a part stands that takes the place of a weight [m].
pub(crate) fn plane(old: &Counterweight) -> f64 {
    old.part.as_ref().map_or(old.z, |part| part.z)
}

pub(crate) fn refused(engine: &Engine, index: usize, fault: &PartFault) -> CounterweightError {
    CounterweightError::Fault { name: engine.counterweights[index].name.clone(), fault: fault.to_string() }
}
