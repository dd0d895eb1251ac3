//! The counterweights of an engine as parts: which of them, their duties, the best shapes.

use crate::parts::best_shape::{
    BestShape, EvolutionRequest, SharedWithWeb, fit, fitted_part, plane, refused,
};
use crate::parts::duty::{duty_of, tilt, web_of};
use crate::parts::error::CounterweightError;
use crate::parts::shape_front::{CounterweightFront, best_front};
use lanchester_geometry::CounterweightShape;
use lanchester_geometry::clearance::{RadialEnvelope, SweptRoom};
use lanchester_geometry::{Design, DesignOutcome, Evolution, Objective, Part, ShapeTask};
use lanchester_model::{Counterweight, CounterweightForm, CounterweightPart, Engine};
use serde::Serialize;

/// Version of [`CounterweightDesigns`]; raised when a field changes its meaning or goes.
pub const COUNTERWEIGHT_DESIGNS_VERSION: u32 = 2;

/// Dimensions that differ by no more than this share of the size are the same: what is written has twelve digits.
const SAME_SHAPE: f64 = 1e-9;

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

/// A weight and the shape that was found for it.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DesignedCounterweight {
    /// Its name.
    pub name: String,
    /// Its index in [`Engine::counterweights`].
    pub index: usize,
    /// The unbalance that is full balance [kg m].
    pub duty: f64,
    /// What of its outline beyond the web's disc lies within the web as it is and counts as the web's: a design's mass, unbalance and inertia
    /// are without it.
    pub shared: SharedWithWeb,
    /// The swept radius that keeps the wanted clearance whatever the shape; none where the best shape of all keeps the clearance, or there is
    /// nothing to stay clear of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub room: Option<SweptRoom>,
    /// With a room: how far the shape may reach in each direction, by everything that moves past its web over the cycle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub envelope: Option<RadialEnvelope>,
    /// With a room: what is made small, of the best shape without it [SI]. No shape that keeps the clearance has less.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub without_room: Option<f64>,
    /// What was found: mass, unbalance and inertia are what the counterweight adds to the crankshaft beyond the web as it is. The proof is about
    /// all shapes that share as much with the flank of the web.
    pub outcome: DesignOutcome,
    /// Mass of the part as it is exported, the disc of its web included [kg]; none where no shape was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part_mass: Option<f64>,
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

/// The best shape for each weight that is asked for, with its proof.
///
/// Where the engine says what the crankshaft must stay clear of, and the best shape does not, it is the best of the shapes within the envelope of all
/// that moves past the web over the cycle. What a shape shares with its plain web beyond the disc is the web's, so that the shape gets that much more.
///
/// # Errors
/// Where a weight is not there or has no duty, or a number of the task has no meaning. Limits that no shape meets are an
/// outcome.
pub fn design_counterweights(
    engine: &Engine,
    request: &CounterweightRequest,
) -> Result<CounterweightDesigns, CounterweightError> {
    let mut weights: Vec<DesignedCounterweight> = Vec::new();
    let mut done = Alike::default();
    for (index, duty) in duties(engine, request)? {
        let known = done.find(engine, index, duty)?.cloned();
        let is_new = known.is_none();
        let best = match known {
            Some(known) => known,
            None => BestShape::find(engine, index, duty, &request.task)?,
        };
        let evolution = request.evolution.map(|search| best.evolve(engine, index, search)).transpose()?;
        weights.push(DesignedCounterweight {
            name: engine.counterweights[index].name.clone(),
            index,
            duty,
            shared: best.shared,
            room: best.room.clone(),
            envelope: best.envelope.clone(),
            without_room: best.without_room,
            outcome: best.outcome.clone(),
            part_mass: best.part_mass(engine, index)?,
            evolution,
        });
        if is_new {
            done.add(engine, index, best);
        }
    }
    Ok(CounterweightDesigns {
        version: COUNTERWEIGHT_DESIGNS_VERSION,
        engine: engine.name.clone(),
        task: request.task,
        weights,
    })
}

/// The front between what the task makes small and `against`, for weights of one duty.
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
    let weights: Vec<usize> = duties.into_iter().map(|(index, _)| index).collect();
    best_front(engine, &weights, duty, &request.task, against, count)
}

/// A design of a front for all of its weights: the best shape of each with no more of the second objective, or, at that end of the front, the
/// one with the least of it.
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
    // The envelope of one weight may be a micrometre nearer than that of all, or farther.
    let limited = |slack: f64| {
        let mut task = ShapeTask { minimise: first, ..request.task };
        let level = design.value(second) * (1.0 + slack);
        match second {
            Objective::Mass => task.limits.mass = Some(level),
            Objective::SweptRadius => task.limits.swept_radius = Some(level),
            Objective::Inertia => task.limits.inertia = Some(level),
            Objective::Thickness => task.thickness.most = level.min(task.thickness.most),
        }
        task
    };
    let find = |index: usize, duty: f64| -> Result<Option<BestShape>, CounterweightError> {
        for task in [limited(0.0), limited(1e-5), ShapeTask { minimise: second, ..request.task }] {
            let found = BestShape::find_as_asked(engine, index, duty, &task)?;
            if found.design().is_some() {
                return Ok(Some(found));
            }
        }
        Ok(None)
    };
    let mut done = Alike::default();
    let mut designs: Vec<(usize, Design)> = Vec::new();
    for &index in &front.weights {
        let duty = request.unbalance.unwrap_or_else(|| duty_of(&engine.counterweights[index]));
        let own = match done.find(engine, index, duty)? {
            Some(known) => known.design(),
            None => {
                let found = find(index, duty)?;
                let own = found.as_ref().and_then(BestShape::design);
                found.into_iter().for_each(|found| done.add(engine, index, found));
                own
            }
        };
        let own = own.unwrap_or(*design);
        // Webs that are alike have one design, not two that differ by rounding.
        let alike = designs.iter().map(|one| one.1).find(|known| are_same(known, &own));
        designs.push((index, alike.unwrap_or(own)));
    }
    Ok(designs)
}

/// Shapes that are known, each with how far its weight stands from the opposite of its crankpin: weights of one duty that stand alike on their
/// webs have one shape.
#[derive(Default)]
struct Alike {
    known: Vec<(f64, BestShape)>,
}

impl Alike {
    fn find(
        &self,
        engine: &Engine,
        index: usize,
        duty: f64,
    ) -> Result<Option<&BestShape>, CounterweightError> {
        let tilt = tilt(engine, &engine.counterweights[index]);
        for (known_tilt, known) in &self.known {
            if known.duty == duty && (known_tilt - tilt).abs() < 1e-9 && known.is_best_for(engine, index)? {
                return Ok(Some(known));
            }
        }
        Ok(None)
    }

    fn add(&mut self, engine: &Engine, index: usize, shape: BestShape) {
        self.known.push((tilt(engine, &engine.counterweights[index]), shape));
    }
}

/// Whether two designs differ by rounding alone.
fn are_same(a: &Design, b: &Design) -> bool {
    same(a.thickness, b.thickness) && same_shape(&a.shape, &b.shape)
}

fn same_shape(a: &CounterweightShape, b: &CounterweightShape) -> bool {
    let size = |shape: &CounterweightShape| shape.web_radius.max(shape.arc_radius);
    let near = |x: f64, y: f64| (x - y).abs() <= SAME_SHAPE * size(a);
    near(a.web_radius, b.web_radius)
        && near(a.rectangle_height, b.rectangle_height)
        && near(a.shoulder_height, b.shoulder_height)
        && near(a.arc_radius, b.arc_radius)
        && same(a.arc_angle, b.arc_angle)
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME_SHAPE * a.abs()
}

/// Whether a weight is already the part of this design.
fn is_fitted(weight: &Counterweight, design: &Design, density: f64) -> bool {
    weight.part.as_ref().is_some_and(|part| match part.form {
        CounterweightForm::Family(shape) => {
            same_shape(&shape, &design.shape)
                && same(part.part.thickness(), design.thickness)
                && same(part.part.density(), density)
        }
        _ => false,
    })
}

/// The engine with `design`s, of this density [kg/m^3], in the place of the weights of these indices. What differs from the part that is
/// there by rounding alone leaves it as it is.
///
/// # Errors
/// Where a design is no part: a density or a thickness that no part can have, or one that does not fit its web.
pub fn with_counterweights(
    engine: &Engine,
    designs: &[(usize, Design)],
    density: f64,
) -> Result<Engine, CounterweightError> {
    let mut fitted = engine.clone().into_parts();
    for (index, design) in designs {
        if is_fitted(&engine.counterweights[*index], design, density) {
            continue;
        }
        let (part, weight) = fitted_part(engine, *index, design, density)?;
        fit(&mut fitted, *index, part, weight);
    }
    Engine::new(fitted).map_err(CounterweightError::engine)
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
    engine.with(|parts| fit(parts, index, part, weight)).map_err(CounterweightError::engine)
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

#[cfg(test)]
mod tests;
