//! From an engine to the crank train of `flex`: bearings, rods, pistons, gas.

use super::housed_law::HousedLaw;
use crate::pressure::cylinders::GasReport;
use crate::stress::request::StressError;
use crate::torque_report::bearing_sizes;
use lanchester_film::BearingKind;
use lanchester_flex::FlexError;
use lanchester_flex::train::{
    BearingPlace, CrankBody, CrankTrain, ImposedMotion, PeriodicForce, Slider, TrainCylinder, TrainLaw,
    TrainMain,
};
use lanchester_geometry::crankshaft::CrankshaftError;
use lanchester_model::{BearingData, CrankElement, CrankElementForm, Engine, RodJoint};
use std::f64::consts::FRAC_PI_4;

/// Samples of the gas force over a degree of crankshaft 1.
const GAS_SAMPLES: f64 = 8.0;

/// A bearing of the crankshaft.
#[derive(Debug, Clone)]
pub(crate) struct Bearing {
    pub kind: BearingKind,
    /// Number of its crankshaft, from 1.
    pub crankshaft: usize,
    /// Number of the main on its crankshaft, or of the cylinder.
    pub number: usize,
    pub surface: BearingPlace,
    /// Diameter of journal or pin [m].
    pub diameter: f64,
    pub data: BearingData,
}

impl Bearing {
    pub fn is_main(&self) -> bool {
        self.kind == BearingKind::Main
    }

    /// "main bearing 2", "big end of cylinder 1".
    pub fn name(&self) -> String {
        match self.kind {
            BearingKind::Main => format!("main bearing {}", self.number),
            BearingKind::Crankpin => format!("big end of cylinder {}", self.number),
        }
    }
}

/// All bearings of a crankshaft: mains along it, then big ends by cylinder.
pub(crate) fn bearing_places(engine: &Engine, crankshaft: usize) -> Result<Vec<Bearing>, StressError> {
    let mut places = main_places(engine, crankshaft)?;
    places.extend(big_end_places(engine, crankshaft)?);
    Ok(places)
}

/// Elements of a crankshaft.
fn elements(engine: &Engine, crankshaft: usize) -> Result<Vec<CrankElement>, StressError> {
    let found = engine.crank_elements(crankshaft);
    Ok(found.map_err(|fault| FlexError::from(CrankshaftError::from(fault)))?)
}

/// Main bearings along a crankshaft.
pub(crate) fn main_places(engine: &Engine, crankshaft: usize) -> Result<Vec<Bearing>, StressError> {
    let sizes = bearing_sizes(engine);
    let given = engine.bearings.unwrap_or_default();
    let elements = elements(engine, crankshaft)?;
    let journals: Vec<(usize, f64, [f64; 2])> = elements
        .iter()
        .filter_map(|element| match &element.form {
            CrankElementForm::Journal { journal, bar } => Some((*journal, bar.diameter, element.faces)),
            _ => None,
        })
        .collect();
    let mut places = Vec::new();
    let all = engine.main_bearings();
    let first = all.iter().filter(|(own, _)| *own < crankshaft).count();
    let planes = engine.main_planes(crankshaft);
    if planes.len() < 2 {
        return Err(StressError::Train {
            crankshaft: crankshaft + 1,
            needed: "two main bearings or more",
            got: planes.len(),
            hint: "give the planes of its mains",
        });
    }
    for (index, z) in planes.into_iter().enumerate() {
        let data = engine.main_bearing_data(first + index);
        let within = |(_, _, [front, rear]): &&(usize, f64, [f64; 2])| (*front..=*rear).contains(&z);
        let (journal, diameter, [front, rear]) =
            journals.iter().find(within).copied().ok_or_else(|| FlexError::Missing {
                what: "journal at the plane of main bearing",
                name: format!("{} (z = {:.1} mm)", index + 1, 1e3 * z),
                hint: "make the end journals as long as their bearings, or give the planes of the mains",
            })?;
        let length = rear - front;
        let width = data.width.or(sizes.main.map(|size| size.width)).unwrap_or(length).min(length);
        places.push(Bearing {
            kind: BearingKind::Main,
            crankshaft: crankshaft + 1,
            number: index + 1,
            surface: BearingPlace {
                name: format!("main bearing {}", index + 1),
                set: format!("MAIN_{}", journal + 1),
                z,
                width,
            },
            diameter: given.main.and_then(|own| own.diameter).unwrap_or(diameter),
            data,
        });
    }
    Ok(places)
}

/// Big ends on a crankshaft, by cylinder.
fn big_end_places(engine: &Engine, crankshaft: usize) -> Result<Vec<Bearing>, StressError> {
    let sizes = bearing_sizes(engine);
    let given = engine.bearings.unwrap_or_default();
    let elements = elements(engine, crankshaft)?;
    let pins: Vec<(usize, f64, f64)> = elements
        .iter()
        .filter_map(|element| match &element.form {
            CrankElementForm::Pin { throw, bar, .. } => Some((*throw, bar.diameter, element.length())),
            _ => None,
        })
        .collect();
    let mut places = Vec::new();
    for (index, cylinder) in engine.cylinders.iter().enumerate() {
        if engine.throws[cylinder.throw].crankshaft != crankshaft {
            continue;
        }
        if matches!(cylinder.rod.joint, RodJoint::Articulated { .. }) {
            return Err(StressError::Articulated { cylinder: index + 1 });
        }
        let Some((throw, diameter, length)) = pins.iter().find(|(throw, ..)| *throw == cylinder.throw) else {
            continue;
        };
        let data = engine.crankpin_bearing_data(index);
        let width = data.width.or(sizes.crankpin.map(|size| size.width)).unwrap_or(*length).min(*length);
        places.push(Bearing {
            kind: BearingKind::Crankpin,
            crankshaft: crankshaft + 1,
            number: index + 1,
            surface: BearingPlace {
                name: format!("big end of cylinder {}", index + 1),
                set: format!("PIN_{}", throw + 1),
                z: cylinder.z,
                width,
            },
            diameter: given.crankpin.and_then(|own| own.diameter).unwrap_or(*diameter),
            data,
        });
    }
    if places.is_empty() {
        return Err(StressError::Train {
            crankshaft: crankshaft + 1,
            needed: "a cylinder or more",
            got: 0,
            hint: "ask for the crankshaft that has cylinders",
        });
    }
    Ok(places)
}

/// Everything of a train but its body and laws.
pub(crate) struct Composed {
    mains: Vec<(usize, usize)>,
    cylinders: Vec<TrainCylinder>,
    motion: ImposedMotion,
    ratio: f64,
    phase: f64,
}

impl Composed {
    pub fn new(engine: &Engine, gas: &GasForce<'_>, speed: f64, period: f64, places: &[Bearing]) -> Composed {
        let (mut mains, mut cylinders) = (Vec::new(), Vec::new());
        let mut shaft = 0;
        for (surface, place) in places.iter().enumerate() {
            if place.is_main() {
                mains.push((place.number, surface));
                continue;
            }
            let index = place.number - 1;
            let cylinder = &engine.cylinders[index];
            let throw = &engine.throws[cylinder.throw];
            shaft = throw.crankshaft;
            let rod = &cylinder.rod;
            let (small, centre) = (rod.small_end_mass, rod.centre_of_gravity());
            // Without an inertia of its own the rod is its two end masses.
            let points = rod.big_end_mass * centre.powi(2) + small * (rod.length - centre).powi(2);
            let (sin, cos) = throw.angle.sin_cos();
            cylinders.push(TrainCylinder {
                number: place.number,
                surface,
                pin: [throw.radius * cos, throw.radius * sin],
                slider: Slider {
                    angle: cylinder.angle,
                    offset: cylinder.net_offset(),
                    length: rod.length,
                    piston: cylinder.piston_mass,
                    rod: rod.mass(),
                    centre,
                    inertia: rod.inertia.unwrap_or(points),
                },
                law: TrainLaw::Rigid,
                housing: None,
                gas: sampled(gas, index, period),
            });
        }
        let own = &engine.crankshafts[shaft];
        Composed {
            mains,
            cylinders,
            motion: ImposedMotion::constant(speed, period),
            ratio: own.ratio.value(),
            phase: own.phase,
        }
    }

    /// The train with this body and these laws, one a bearing.
    pub fn train(&self, body: CrankBody, laws: &[HousedLaw]) -> CrankTrain {
        let main = |(number, surface): &(usize, usize)| {
            let HousedLaw { law, housing } = laws[*surface].clone();
            TrainMain { number: *number, surface: *surface, law, housing }
        };
        let cylinder = |own: &TrainCylinder| {
            let HousedLaw { law, housing } = laws[own.surface].clone();
            TrainCylinder { law, housing, ..own.clone() }
        };
        CrankTrain {
            body,
            mains: self.mains.iter().map(main).collect(),
            cylinders: self.cylinders.iter().map(cylinder).collect(),
            motion: self.motion.clone(),
            ratio: self.ratio,
            phase: self.phase,
        }
    }
}

/// Gas force [N] on the piston of a cylinder towards the crank at an angle of crankshaft 1.
pub(crate) type GasForce<'a> = dyn Fn(usize, f64) -> f64 + 'a;

/// Of the pressures of an engine.
pub(crate) fn gas_force(engine: &Engine, gas: Option<&GasReport>, index: usize, theta: f64) -> f64 {
    let (Some(gas), Some(bore)) = (gas, engine.cylinders[index].bore) else { return 0.0 };
    let ratio = engine.crankshafts[engine.throws[engine.cylinders[index].throw].crankshaft].ratio.value();
    let own = &gas.cylinders[index];
    let turned = ratio.abs() * (theta - gas.firing_angles[index]);
    FRAC_PI_4 * bore * bore * (own.cylinder.at(turned) - own.crankcase.at(turned))
}

fn sampled(gas: &GasForce<'_>, index: usize, period: f64) -> PeriodicForce {
    let count = (period.to_degrees() * GAS_SAMPLES).round() as usize;
    let at = |k: usize| gas(index, period * k as f64 / count as f64);
    PeriodicForce { period, samples: (0..count).map(at).collect() }
}
