//! Internal moments: shear force and bending moment along each crankshaft over the cycle.
//!
//! What balances the engine as a whole may still bend its crankshaft: the throws of an in-line four or six hold one
//! another in balance *through* the shaft. Two named models, [`BeamModel`], say how much; both are statically
//! determinate and linear in the loads, which are
//!
//! ```text
//! throw:           U W^2 e^{i (angle + ratio theta)}      own unbalance at its plane, big ends at the planes of their rods
//! counterweight:   U W^2 e^{i (angle + ratio theta)}      at its plane
//! reciprocating:   share times the rod's force on the pin ([`crate::rod_force`]), at the plane of its cylinder; what an articulated rod
//!                  gives to its master's piston, at the plane of the master
//! ```
//! Signs of `Q` and `M`: [`crate::beam`]. No gas, no weight of the parts, no stiffness: main bearings in line and rigid
//! enough that the shaft's own bending does not shift loads between them.

use crate::bearings::beam::{Beam, BeamModel, walk};
use crate::bearings::rod_force::RodForce;
use crate::curves::envelope::largest;
use crate::inertia::request::{Kinematics, LoadError, LoadRequest};
use crate::train::mechanism::{Mechanism, linkage, master_of};
use lanchester_model::Engine;
use lanchester_results::Extreme;
use num_complex::Complex64;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const INTERNAL_VERSION: u32 = 1;

/// Angles of a revolution from which extremes are found, at least.
const FINEST: usize = 720;

/// Planes closer than this [m] are one.
const SAME_PLANE: f64 = 1e-9;

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct InternalRequest {
    /// Speed of crankshaft 1 [rad/s]; `None`: the highest speed of the engine.
    pub speed: Option<f64>,
    /// Motion of the pistons.
    pub kinematics: Kinematics,
    /// Share of the reciprocating forces that counts, from 0 to 1.
    pub reciprocating_share: f64,
    /// Whether the weights on the crankshafts count.
    pub counterweights: bool,
    /// Angles of the traces in one revolution of crankshaft 1; extremes are found from at least 720.
    pub samples: usize,
}

impl Default for InternalRequest {
    /// Rotating parts and counterweights at the highest speed, every half degree.
    fn default() -> Self {
        InternalRequest {
            speed: None,
            kinematics: Kinematics::Exact,
            reciprocating_share: 0.0,
            counterweights: true,
            samples: 720,
        }
    }
}

/// Shear forces and bending moments of all crankshafts at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct InternalMoments {
    /// [`INTERNAL_VERSION`].
    pub version: u32,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Share of the reciprocating forces that counts.
    pub reciprocating_share: f64,
    /// Whether the weights on the crankshafts count.
    pub counterweights: bool,
    /// Period [rad] of crankshaft 1.
    pub period: f64,
    /// Crank angle of crankshaft 1 [rad] of every trace, from 0, one period, end point excluded.
    pub theta: Vec<f64>,
    /// By crankshaft; one without throws is left out.
    pub crankshafts: Vec<CrankshaftMoments>,
}

/// One crankshaft in both models.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankshaftMoments {
    /// Its number, from 1.
    pub crankshaft: usize,
    /// As a free beam: what its loads do not hold in balance is carried by the end mains.
    pub free_beam: BeamLoads,
    /// Every throw held by its own two mains.
    pub throw_by_throw: BeamLoads,
}

impl CrankshaftMoments {
    /// Its loads in `model`.
    pub fn of(&self, model: BeamModel) -> &BeamLoads {
        match model {
            BeamModel::FreeBeam => &self.free_beam,
            BeamModel::ThrowByThrow => &self.throw_by_throw,
        }
    }
}

/// A crankshaft in one model.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BeamLoads {
    /// Every plane with a load or a main bearing, rising from the free end to the flywheel. Between two of them the shear
    /// force is constant and the bending moment runs straight, so that extremes along the shaft lie here.
    pub stations: Vec<Station>,
    /// Load on every main bearing, rising; 0 where the model lets it carry nothing.
    pub mains: Vec<MainLoad>,
    /// Largest shear force along the shaft and over the cycle.
    pub peak_shear: Peak,
    /// Largest bending moment along the shaft and over the cycle.
    pub peak_moment: Peak,
    /// Largest load on any main bearing; its plane.
    pub peak_main: Peak,
}

/// A plane along the shaft.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Station {
    /// Its place [m], from the origin.
    pub z: f64,
    /// Largest `|Q|` just behind the plane over the cycle [N].
    pub largest_shear: Extreme,
    /// Largest `|M|` at the plane over the cycle [N m].
    pub largest_moment: Extreme,
    /// Shear force `Q_x + i Q_y` just behind the plane [N], that of what lies before on what lies behind; just before the
    /// plane it is that of the station before, and 0 before the first.
    #[schemars(with = "Vec<[f64; 2]>")]
    pub shear: Vec<Complex64>,
    /// Bending moment `M_x + i M_y` [N m] of what lies before the plane on what lies behind it.
    #[schemars(with = "Vec<[f64; 2]>")]
    pub moment: Vec<Complex64>,
}

/// A main bearing.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MainLoad {
    /// Its number from the free end, from 1.
    pub main: usize,
    /// Its plane [m], from the origin.
    pub z: f64,
    /// Largest load over the cycle [N].
    pub largest: Extreme,
    /// Load of the shaft on the bearing `N_x + i N_y` [N] over the cycle.
    #[schemars(with = "Vec<[f64; 2]>")]
    pub load: Vec<Complex64>,
}

/// An extreme along the shaft and over the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Peak {
    /// Value [N] or [N m].
    pub value: f64,
    /// Its plane [m], from the origin; a shear force acts just behind it. The first that attains it.
    pub z: f64,
    /// Crank angle [rad] in one period; 0 where it is the same at every angle.
    pub theta: f64,
}

/// The loads of one crankshaft: what turns with it, and its rods.
struct ShaftLoads {
    ratio: f64,
    /// Planes with a load or a main, rising [m].
    planes: Vec<f64>,
    /// Force at every plane at `theta = 0` that turns with the shaft [N].
    turning: Vec<Complex64>,
    /// Plane and force of every rod.
    /// Plane of the rod, of its master (else its own), and the rod.
    rods: Vec<([usize; 2], RodForce)>,
}

/// Shear force, bending moment and main-bearing loads of every crankshaft, in both models.
///
/// ```text
/// Q(z) = SUM over z_k < z of F_k         M(z) = i SUM over z_k < z of (z_k - z) F_k
/// ```
/// Everything is linear in the loads: cases with part of the parts add up.
///
/// # Errors
/// [`LoadError`] where the request is impossible or the engine is not valid.
pub fn internal_moments(engine: &Engine, request: &InternalRequest) -> Result<InternalMoments, LoadError> {
    let share = request.reciprocating_share;
    if !(0.0..=1.0).contains(&share) {
        let quantity = "share of the reciprocating forces";
        return Err(LoadError::Request { quantity, needed: "from 0 to 1", got: share });
    }
    let load_request = LoadRequest {
        speed: request.speed,
        kinematics: request.kinematics,
        samples: request.samples,
        ..LoadRequest::default()
    };
    let mechanism = Mechanism::new(engine, &load_request)?;
    // Traces keep every `stride`-th of the angles that extremes are found from.
    let needed = if share > 0.0 { mechanism.resolution().max(FINEST) } else { request.samples };
    let stride = needed.div_ceil(request.samples).max(1);
    let angles = request.samples * stride * mechanism.revolutions as usize;
    let period = mechanism.period();
    let theta: Vec<f64> = (0..angles).map(|j| period * j as f64 / angles as f64).collect();
    let mut crankshafts = Vec::new();
    for index in 0..engine.crankshafts.len() {
        let mains = engine.main_planes(index);
        let loads = ShaftLoads::of(engine, request, &mechanism, index, &mains)?;
        let forces: Vec<Vec<Complex64>> = theta.iter().map(|&theta| loads.at(theta, share)).collect();
        let model = |model| {
            Beam::new(&mains, model).map(|beam| beam_loads(&beam, &loads.planes, &forces, period, stride))
        };
        if let (Some(free_beam), Some(throw_by_throw)) =
            (model(BeamModel::FreeBeam), model(BeamModel::ThrowByThrow))
        {
            crankshafts.push(CrankshaftMoments { crankshaft: index + 1, free_beam, throw_by_throw });
        }
    }
    Ok(InternalMoments {
        version: INTERNAL_VERSION,
        speed: mechanism.speed,
        reciprocating_share: share,
        counterweights: request.counterweights,
        period,
        theta: theta.into_iter().step_by(stride).collect(),
        crankshafts,
    })
}

/// The case asked for, then what it is to be compared with: without counterweights where the engine has some, and both
/// once more with all of the reciprocating forces.
///
/// # Errors
/// As [`internal_moments`].
pub fn internal_cases(engine: &Engine, request: &InternalRequest) -> Result<Vec<InternalMoments>, LoadError> {
    let mut requests = vec![request.clone()];
    if request.counterweights && engine.counterweights.iter().any(|w| w.unbalance > 0.0) {
        requests.push(InternalRequest { counterweights: false, ..request.clone() });
    }
    if request.reciprocating_share < 1.0 {
        let whole = |r: &InternalRequest| InternalRequest { reciprocating_share: 1.0, ..r.clone() };
        requests.extend(requests.iter().map(whole).collect::<Vec<_>>());
    }
    requests.iter().map(|request| internal_moments(engine, request)).collect()
}

/// Everything that turns with crankshaft `index` (from 0), with crankshaft 1 at `speed` [rad/s]: the plane [m] of each of
/// its throws, rods' big ends and counterweights, and its force `U W^2 e^{i angle}` at `theta = 0` [N].
pub fn turning_loads(engine: &Engine, index: usize, speed: f64) -> Vec<(f64, Complex64)> {
    let Some(crankshaft) = engine.crankshafts.get(index) else { return Vec::new() };
    let square = (crankshaft.ratio.value() * speed).powi(2);
    let force = |unbalance: f64, angle: f64| {
        Complex64::from_polar(1.0, crankshaft.phase + angle) * (unbalance * square)
    };
    let throws = engine.throws.iter().filter(|t| t.crankshaft == index);
    let weights = engine.counterweights.iter().filter(|w| w.crankshaft == index);
    let rods = engine.cylinders.iter().filter_map(|cylinder| {
        let throw = engine.throws.get(cylinder.throw).filter(|t| t.crankshaft == index)?;
        Some((cylinder.z, force(cylinder.rod.big_end_mass * throw.radius, throw.angle)))
    });
    throws
        .map(|t| (t.unbalance_plane(), force(t.unbalance, t.angle)))
        .chain(rods)
        .chain(weights.map(|w| (w.z, force(w.unbalance, w.angle))))
        .collect()
}

impl ShaftLoads {
    fn of(
        engine: &Engine,
        request: &InternalRequest,
        mechanism: &Mechanism,
        index: usize,
        mains: &[f64],
    ) -> Result<ShaftLoads, LoadError> {
        let ratio = engine.crankshafts[index].ratio.value();
        let bare;
        let turned = match request.counterweights {
            true => engine,
            false => {
                bare = engine.without_counterweights();
                &bare
            }
        };
        let turning = turning_loads(turned, index, mechanism.speed);
        let mut planes: Vec<f64> = turning.iter().map(|t| t.0).chain(mains.iter().copied()).collect();
        planes.sort_by(f64::total_cmp);
        planes.dedup_by(|later, kept| *later - *kept < SAME_PLANE);
        let mut loads =
            ShaftLoads { ratio, turning: vec![Complex64::ZERO; planes.len()], planes, rods: Vec::new() };
        for (z, force) in turning {
            let plane = loads.plane(z);
            loads.turning[plane] += force;
        }
        if request.reciprocating_share > 0.0 {
            for (number, cylinder) in engine.cylinders.iter().enumerate() {
                if engine.throws[cylinder.throw].crankshaft == index {
                    let master = &engine.cylinders[master_of(cylinder).unwrap_or(number)];
                    let piston = mechanism.pistons[number].clone();
                    let force = RodForce::new(piston, linkage(engine, number)?, master.angle);
                    loads.rods.push(([cylinder.z, master.z].map(|z| loads.plane(z)), force));
                }
            }
        }
        Ok(loads)
    }

    /// Index of the plane at `z`.
    fn plane(&self, z: f64) -> usize {
        nearest(&self.planes, z)
    }

    /// Force at every plane [N] at crank angle `theta` of crankshaft 1 [rad].
    fn at(&self, theta: f64, share: f64) -> Vec<Complex64> {
        let turn = Complex64::cis(self.ratio * theta);
        let mut forces: Vec<Complex64> = self.turning.iter().map(|f| f * turn).collect();
        for (planes, rod) in &self.rods {
            for (plane, force) in planes.iter().zip(rod.by_plane(theta)) {
                forces[*plane] += share * force;
            }
        }
        forces
    }
}

/// Index of the plane nearest to `z`.
fn nearest(planes: &[f64], z: f64) -> usize {
    let behind = planes.partition_point(|plane| *plane < z).min(planes.len() - 1);
    if behind > 0 && z - planes[behind - 1] < planes[behind] - z { behind - 1 } else { behind }
}

/// One model of one shaft under `forces` at `planes`, by crank angle.
fn beam_loads(
    beam: &Beam,
    planes: &[f64],
    forces: &[Vec<Complex64>],
    period: f64,
    stride: usize,
) -> BeamLoads {
    let (angles, mains) = (forces.len(), beam.mains());
    let at_main: Vec<usize> = mains.iter().map(|&z| nearest(planes, z)).collect();
    let shares: Vec<[(usize, f64); 2]> = planes.iter().map(|&z| beam.shares(z)).collect();
    let zeros = |rows: usize| vec![vec![Complex64::ZERO; angles]; rows];
    let (mut shear, mut moment, mut carried) = (zeros(planes.len()), zeros(planes.len()), zeros(mains.len()));
    let mut loads = vec![Complex64::ZERO; planes.len()];
    let (mut q, mut m) = (loads.clone(), loads.clone());
    // Below rounding of this, nothing is left.
    let mut scale = 0.0f64;
    for (j, force) in forces.iter().enumerate() {
        loads.copy_from_slice(force);
        for (force, shares) in force.iter().zip(&shares) {
            for &(main, share) in shares {
                carried[main][j] += share * force;
            }
        }
        for (main, &plane) in at_main.iter().enumerate() {
            loads[plane] -= carried[main][j];
        }
        walk(planes, &loads, &mut q, &mut m);
        for k in 0..planes.len() {
            (shear[k][j], moment[k][j]) = (q[k], m[k]);
        }
        scale = scale.max(force.iter().map(|f| f.norm()).sum());
    }
    let length = planes[planes.len() - 1] - planes[0];
    let thinned = |trace: Vec<Complex64>| trace.into_iter().step_by(stride).collect::<Vec<_>>();
    let stations: Vec<Station> = planes
        .iter()
        .zip(shear.into_iter().zip(moment))
        .map(|(&z, (shear, moment))| Station {
            z,
            largest_shear: largest(&shear, period, scale),
            largest_moment: largest(&moment, period, scale * length),
            shear: thinned(shear),
            moment: thinned(moment),
        })
        .collect();
    let mains: Vec<MainLoad> = mains
        .iter()
        .zip(carried)
        .enumerate()
        .map(|(index, (&z, load))| MainLoad {
            main: index + 1,
            z,
            largest: largest(&load, period, scale),
            load: thinned(load),
        })
        .collect();
    BeamLoads {
        peak_shear: peak(stations.iter().map(|s| (s.z, s.largest_shear))),
        peak_moment: peak(stations.iter().map(|s| (s.z, s.largest_moment))),
        peak_main: peak(mains.iter().map(|m| (m.z, m.largest))),
        stations,
        mains,
    }
}

/// The largest of extremes at planes; of those that tie to rounding the first.
fn peak(extremes: impl Iterator<Item = (f64, Extreme)>) -> Peak {
    let mut peak = Peak::default();
    for (index, (z, extreme)) in extremes.enumerate() {
        if index == 0 || extreme.value > peak.value * (1.0 + 1e-12) {
            peak = Peak { value: extreme.value, z, theta: extreme.theta };
        }
    }
    peak
}
