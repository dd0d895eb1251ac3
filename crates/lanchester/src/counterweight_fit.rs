//! Counterweights as parts in the place of weights: what a design is on its web.

use crate::counterweight_error::CounterweightError;
use crate::counterweights::{chosen, duty_of, web_of};
use lanchester_geometry::clearance::ClearanceEnvelope;
use lanchester_geometry::{Design, Objective, Outline, Part, Reach, Seat, counterweight_properties};
use lanchester_model::{Counterweight, CounterweightForm, CounterweightPart, Engine, PartFault, PartWeight};
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Steps after which a part points where its weight does, or never.
const MOST_STEPS: usize = 8;
/// Directions closer than this are the same [rad].
const SAME_DIRECTION: f64 = 1e-11;
/// A part that turns by less than this keeps its envelope [rad].
const SAME_ENVELOPE: f64 = 1e-9;

/// Masses of a counterweight on its web. What a shape has beyond the disc of the web is what the crankshaft gains, and what lies within the flank
/// of the plain web, which is there already; with the disc it is the part that a CAD file holds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct OnWeb {
    /// What the crankshaft gains: beyond the plain web [kg].
    pub mass: f64,
    /// Polar inertia about the crank axis that the crankshaft gains [kg m^2].
    pub polar_inertia: f64,
    /// Of the shape beyond the disc of the web, what lies within the flank of the plain web [kg].
    pub within_web: f64,
    /// The whole part as a CAD file holds it, with the disc of the web [kg].
    pub whole_part: f64,
}

impl OnWeb {
    /// A value of an objective as the crankshaft gains it [SI], from what the shape has beyond the disc of its web.
    pub fn value(&self, objective: Objective, beyond_disc: f64) -> f64 {
        match objective {
            Objective::Mass => self.mass,
            Objective::Inertia => self.polar_inertia,
            Objective::SweptRadius | Objective::Thickness => beyond_disc,
        }
    }
}

/// What a part weighs on its web.
///
/// # Errors
/// Where the plain web cannot be, or has no common outline with the part.
pub(crate) fn on_web(engine: &Engine, part: &CounterweightPart) -> Result<OnWeb, CounterweightError> {
    let added = counterweight_properties(engine, part)?;
    let whole_part = part.part.mass_properties().mass;
    let disc = match part.form {
        CounterweightForm::Family(shape) => {
            let area = PI * shape.web_radius * shape.web_radius;
            part.part.density() * part.part.thickness() * area
        }
        CounterweightForm::Counterweight => 0.0,
        // Nothing of a whole web is told apart.
        CounterweightForm::Web => whole_part - added.mass,
    };
    let within_web = whole_part - disc - added.mass;
    // Differences of masses this small are rounding.
    let within_web = if within_web.abs() < 1e-12 * whole_part { 0.0 } else { within_web };
    Ok(OnWeb { mass: added.mass, polar_inertia: added.polar_inertia(), within_web, whole_part })
}

/// The place of a design in the place of a weight.
#[derive(Debug, Clone)]
struct SeatedWeight {
    index: usize,
    envelope: Option<ClearanceEnvelope>,
    /// Where its part stands on the crankshaft [rad].
    angle: f64,
}

/// The places of one shape on its webs: what they have of it already, and what their envelopes leave in common.
pub(crate) struct WebSeat<'a> {
    engine: &'a Engine,
    density: f64,
    weights: Vec<SeatedWeight>,
    reach: Option<Reach>,
    changes: usize,
    /// Why a design is no part, if one was none.
    pub fault: Option<CounterweightError>,
}

impl<'a> WebSeat<'a> {
    /// The places of the weights of these indices, each with what it must stay within.
    pub fn new(
        engine: &'a Engine,
        density: f64,
        weights: impl IntoIterator<Item = (usize, Option<ClearanceEnvelope>)>,
    ) -> WebSeat<'a> {
        let seated = |(index, envelope): (usize, Option<ClearanceEnvelope>)| {
            let weight = &engine.counterweights[index];
            let angle = weight.part.as_ref().map_or(weight.angle, |part| part.angle);
            SeatedWeight { index, envelope, angle }
        };
        let weights = weights.into_iter().map(seated).collect();
        let mut seat = WebSeat { engine, density, weights, reach: None, changes: 0, fault: None };
        seat.reach = seat.common();
        seat
    }

    /// What all envelopes leave.
    fn common(&self) -> Option<Reach> {
        let own = self.weights.iter();
        own.filter_map(|weight| Some(weight.envelope.as_ref()?.around(weight.angle))).reduce(Reach::common)
    }
}

impl Seat for WebSeat<'_> {
    fn lost(&mut self, design: &Design) -> f64 {
        let (mut lost, mut has_turned) = (0.0f64, false);
        for weight in &mut self.weights {
            match fitted_part(self.engine, weight.index, design, self.density) {
                Ok((part, fitted)) => {
                    lost = lost.max(design.unbalance - fitted.unbalance);
                    if weight.envelope.is_some() && (part.angle - weight.angle).abs() > SAME_ENVELOPE {
                        (weight.angle, has_turned) = (part.angle, true);
                    }
                }
                Err(fault) => self.fault = Some(fault),
            }
        }
        if has_turned {
            self.reach = self.common();
            self.changes += 1;
        }
        lost
    }

    fn reach(&self) -> Option<&Reach> {
        self.reach.as_ref()
    }

    fn changes(&self) -> usize {
        self.changes
    }
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
pub(crate) fn plane(old: &Counterweight) -> f64 {
    old.part.as_ref().map_or(old.z, |part| part.z)
}

fn refused(engine: &Engine, index: usize, fault: &PartFault) -> CounterweightError {
    CounterweightError::Fault { name: engine.counterweights[index].name.clone(), fault: fault.to_string() }
}
