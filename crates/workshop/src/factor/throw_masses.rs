//! The masses of one throw as balancing by factors sees them.
//!
//! ```text
//! first order of a throw at angle psi, over w^2:   F = (R + p_+ + W) e^{i psi} + p_- e^{-i psi}
//! R = U + r SUM m_A,   P = r SUM m_osc,   plain centred rods: p_+ = P / 2,  p_- = 1/2 SUM r m_osc e^{2ib}
//! ```
//! | symbol   | name                                                        | unit |
//! |----------|-------------------------------------------------------------|------|
//! | R, P     | rotating and reciprocating unbalance                        | kg m |
//! | U        | unbalance of the crank itself along the throw               | kg m |
//! | m_A      | big-end masses;  m_osc: pistons and small ends              | kg   |
//! | W        | counterweight in the frame of the throw (real: along it)    | kg m |
//! | p_+, p_- | first order of the pistons, with and against the crank      | kg m |
//! | b        | direction of the cylinder's axis                            | rad  |
//!
//! Offsets and articulated rods enter `p_+` and `p_-` exactly.

use lanchester_mechanism::{LoadError, LoadRequest, Mechanism, Selection};
use lanchester_model::Engine;
use num_complex::Complex64;
use serde::Serialize;

/// First order of the pistons of one cylinder, over the square of its crankshaft's speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FirstOrder {
    /// Index of the cylinder.
    pub cylinder: usize,
    /// Part that turns with the crank, in the frame of the throw [kg m].
    #[schemars(with = "[f64; 2]")]
    pub forward: Complex64,
    /// Part that turns against it [kg m]: the force is `backward e^{-i psi}`, psi the angle of the throw.
    #[schemars(with = "[f64; 2]")]
    pub backward: Complex64,
    /// Plane of the cylinder [m].
    pub z: f64,
}

/// The masses of one throw.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ThrowMasses {
    /// Index of the throw.
    pub throw: usize,
    /// Crank radius [m].
    pub radius: f64,
    /// Unbalance of the crank itself along the throw [kg m].
    pub crank: f64,
    /// Big ends on the pin [kg].
    pub big_ends: f64,
    /// Reciprocating masses: pistons and small ends [kg].
    pub reciprocating: f64,
    /// First order of every piston on the throw.
    pub pistons: Vec<FirstOrder>,
    /// Counterweights in the throw's own plane and in the planes of its webs, in the frame of the throw [kg m].
    #[schemars(with = "[f64; 2]")]
    pub counterweight: Complex64,
    /// Direction of the cylinders [rad]: of their sum, or of the first where they cancel; 0 without cylinders.
    pub axis: f64,
}

impl ThrowMasses {
    /// `R`: rotating unbalance [kg m], without counterweights.
    pub fn rotating_unbalance(&self) -> f64 {
        self.crank + self.big_ends * self.radius
    }

    /// `P`: reciprocating unbalance [kg m].
    pub fn reciprocating_unbalance(&self) -> f64 {
        self.reciprocating * self.radius
    }

    /// `p_+` [kg m].
    pub fn forward(&self) -> Complex64 {
        self.pistons.iter().map(|p| p.forward).sum()
    }

    /// `p_-` [kg m].
    pub fn backward(&self) -> Complex64 {
        self.pistons.iter().map(|p| p.backward).sum()
    }
}

/// The masses of every throw, in the order of the engine. A counterweight belongs to the throw of its crankshaft in
/// whose plane or web planes it stands (the nearest where several fit); others, on flywheels and pulleys, to none.
///
/// # Errors
/// [`LoadError`] where the loads of the engine cannot be computed.
pub fn throw_masses(engine: &Engine) -> Result<Vec<ThrowMasses>, LoadError> {
    let owners: Vec<Option<usize>> =
        engine.counterweights.iter().map(|w| owner(engine, w.crankshaft, w.z)).collect();
    (0..engine.throws.len())
        .map(|index| {
            let throw = &engine.throws[index];
            let riders: Vec<usize> =
                (0..engine.cylinders.len()).filter(|&c| engine.cylinders[c].throw == index).collect();
            let pistons = riders
                .iter()
                .map(|&c| first_order(engine, c, riders.len()))
                .collect::<Result<Vec<_>, LoadError>>()?;
            let counterweight = engine
                .counterweights
                .iter()
                .zip(&owners)
                .filter(|(_, owner)| **owner == Some(index))
                .map(|(w, _)| Complex64::from_polar(w.unbalance, w.angle - throw.angle))
                .sum();
            Ok(ThrowMasses {
                throw: index,
                radius: throw.radius,
                crank: throw.unbalance,
                big_ends: riders.iter().map(|&c| engine.cylinders[c].rod.big_end_mass).sum(),
                reciprocating: riders.iter().map(|&c| engine.cylinders[c].reciprocating_mass()).sum(),
                pistons,
                counterweight,
                axis: axis(engine, &riders),
            })
        })
        .collect()
}

/// Names of the counterweights that belong to no throw.
pub(crate) fn ownerless(engine: &Engine) -> Vec<String> {
    let none =
        |weight: &&lanchester_model::Counterweight| owner(engine, weight.crankshaft, weight.z).is_none();
    engine.counterweights.iter().filter(none).map(|weight| weight.name.clone()).collect()
}

/// Planes closer than this [m] are one: a tenth of a micrometre.
const SAME_PLANE: f64 = 1e-7;

/// The throw that a weight at `z` belongs to.
fn owner(engine: &Engine, crankshaft: usize, z: f64) -> Option<usize> {
    let fits = |index: &usize| {
        let throw = &engine.throws[*index];
        let planes = [throw.z].into_iter().chain(throw.webs.into_iter().flatten());
        throw.crankshaft == crankshaft && planes.into_iter().any(|plane| (plane - z).abs() < SAME_PLANE)
    };
    let distance = |index: usize| (engine.throws[index].z - z).abs();
    (0..engine.throws.len()).filter(fits).min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
}

fn axis(engine: &Engine, riders: &[usize]) -> f64 {
    let sum: Complex64 = riders.iter().map(|&c| Complex64::cis(engine.cylinders[c].angle)).sum();
    match riders.first() {
        Some(_) if sum.norm() > 1e-9 => sum.arg(),
        Some(&first) => engine.cylinders[first].angle,
        None => 0.0,
    }
}

/// First order of a piston, exact: of all that belongs to the cylinder, less what turns.
fn first_order(engine: &Engine, cylinder: usize, riders: usize) -> Result<FirstOrder, LoadError> {
    let part = &engine.cylinders[cylinder];
    let throw = &engine.throws[part.throw];
    let ratio = engine.crankshafts[throw.crankshaft].ratio.value();
    let order = ratio.abs();
    let request = LoadRequest {
        speed: Some(1.0),
        max_order: order.ceil() as u32,
        samples: 1,
        ..LoadRequest::default()
    };
    let orders = Mechanism::of(engine, &request, Selection::Cylinder(cylinder))?.orders();
    let loads = orders
        .iter()
        .min_by(|a, b| (a.order - order).abs().total_cmp(&(b.order - order).abs()))
        .expect("invariant: the crankshaft's own order is listed");
    let (with, against) = match ratio > 0.0 {
        true => (loads.force_forward, loads.force_backward),
        false => (loads.force_backward, loads.force_forward),
    };
    let turn = Complex64::cis(engine.pin_angle(part.throw, 0.0));
    let square = ratio * ratio;
    let rotating = throw.unbalance / riders as f64 + part.rod.big_end_mass * throw.radius;
    Ok(FirstOrder {
        cylinder,
        forward: with / turn / square - rotating,
        backward: against * turn / square,
        z: part.z,
    })
}
