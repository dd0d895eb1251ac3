//! Engines and arrangements side by side.

use crate::consequences::consequences;
use crate::durability::similar_durability;
use crate::inertias::{known_inertia, rotating_bodies};
use crate::parts::web_bounds::{WebBoundError, optimise_on_webs};
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::error::GasError;
use crate::pressure::measured::TraceFile;
use crate::pressure::over_speed::SpeedGas;
use crate::torque_report::UNKNOWN_CRANKSHAFT;
use crate::torsion_study::driveline;
use lanchester_balance::{
    Affected, BalanceError, BalanceSettings, Consequences, GasOverSpeed, Next, Outcome, as_it_stands, fitted,
};
use lanchester_file::EngineFile;
use lanchester_literature::{ArrangementOptions, TwinArrangement, arranged};
use lanchester_mechanism::{
    CylinderGas, GasTrain, Lever, LoadError, LoadRequest, MountError, MountSystem, OuterTorque,
    SpeedResponse, Torque, TorqueError, TorqueRequest, firing_chart, flywheel_need, inertia_excitations,
    merged_orders, motion, rotor_inertia_about_z, torque, total_loads,
};
use lanchester_model::{DrivelineInertia, Engine, EngineParts, Fault, Mount, SpeedRange};
use lanchester_results::OrderLoads;
use lanchester_study::compare::{
    COMPARISON_VERSION, Compared, ComparedTorque, Comparison, Criterion, Equal, Held, Leading, Ranking,
    Similar, SimilarError,
};
use lanchester_task::Criterion::Peak;
use lanchester_task::{Load, Tasks, default_task};
use std::f64::consts::{PI, TAU};

/// What the engines of a comparison get before they are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ComparedWith {
    /// What their files give them.
    #[default]
    OwnDevices,
    /// The best counterweights and shafts for the task of their files, or for the default task.
    Optimum,
    /// An arrangement of the twin-cylinder thesis, in place of their own counterweights and shafts.
    Arrangement(TwinArrangement),
}

/// One engine to compare.
#[derive(Debug, Clone, PartialEq)]
pub struct CompareEntry {
    /// An engine, and what its file asks.
    pub file: EngineFile,
    /// The files of pressures that its file names.
    pub traces: Vec<TraceFile>,
    /// What it gets.
    pub with: ComparedWith,
}

/// How engines are compared.
#[derive(Debug, Clone, PartialEq)]
pub struct CompareRequest {
    /// In what they are made equal: similar engines of the displacement or power of the reference.
    pub equal: Equal,
    /// What a similar engine keeps.
    pub held: Held,
    /// Speed of crankshaft 1 [rad/s] before the size changes; `None`: the highest of each engine.
    pub speed: Option<f64>,
    /// Place of the engine with which the others are compared.
    pub reference: usize,
    /// Share of it that they are compared with [1]: 0.5 for twins beside half a four.
    pub share: f64,
    /// Distance along the crank of two stiff mounts that every engine is put on [m], to either side of the origin; `None`: the mounts of
    /// its file.
    pub mount_spacing: Option<f64>,
    /// Fluctuation of the speed that the flywheels keep at the lowest speed [1]; `None`: 2 %.
    pub fluctuation: Option<f64>,
    /// Whether the safety of fillets by finite elements is compared too: seconds to minutes an engine.
    pub finite_elements: bool,
}

/// Fluctuation of the speed that flywheels are compared at, where nobody says [1].
const FLUCTUATION: f64 = 0.02;

impl Default for CompareRequest {
    /// As they are, at their highest speeds, with the first one, flywheels for a fluctuation of 2 %.
    fn default() -> CompareRequest {
        CompareRequest {
            equal: Equal::AsTheyAre,
            held: Held::Speed,
            speed: None,
            reference: 0,
            share: 1.0,
            mount_spacing: None,
            fluctuation: None,
            finite_elements: false,
        }
    }
}

/// Why engines cannot be compared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CompareError {
    /// As it is compared it is no engine.
    #[error("{engine}: {fault}")]
    Engine {
        /// Its name.
        engine: String,
        /// What is wrong with it.
        fault: Box<Fault>,
    },
    /// Nothing to compare.
    #[error("a comparison needs two or more engines or arrangements, got {got}")]
    TooFew {
        /// Engines given.
        got: usize,
    },
    /// A number of the request that is not above 0.
    #[error("{quantity} must be finite and above 0, got {got}")]
    Number {
        /// Which number.
        quantity: &'static str,
        /// What was asked for.
        got: f64,
    },
    /// A reference that there is not.
    #[error("the reference is number {got} of {count} engines\nhint: count from 1")]
    Reference {
        /// Its number, from 1.
        got: usize,
        /// Engines given.
        count: usize,
    },
    /// Displacement without a bore.
    #[error("{engine}: equal {measure} needs the bore of every cylinder\nhint: add bore to [piston]")]
    Bore {
        /// Name of the engine.
        engine: String,
        /// What is to be equal.
        measure: &'static str,
    },
    /// Its loads cannot be computed.
    #[error("{engine}: {error}")]
    Load {
        /// Name of the engine.
        engine: String,
        /// Why.
        error: Box<LoadError>,
    },
    /// It cannot be balanced as asked.
    #[error("{engine}: {error}")]
    Balance {
        /// Name of the engine.
        engine: String,
        /// Why.
        error: Box<BalanceError>,
    },
    /// It cannot be balanced on its webs as asked.
    #[error("{engine}: {error}")]
    Optimum {
        /// Name of the engine.
        engine: String,
        /// Why.
        error: Box<WebBoundError>,
    },
    /// The optimum that was asked for is none.
    #[error(
        "{engine}: its balance has no optimum: {reason}\nhint: balance this engine by itself: the answer says by how much each limit is missed"
    )]
    NoOptimum {
        /// Name of the engine.
        engine: String,
        /// Why.
        reason: String,
    },
    /// Its gas cannot be computed.
    #[error("{engine}: {error}")]
    Gas {
        /// Name of the engine.
        engine: String,
        /// Why.
        error: Box<GasError>,
    },
    /// A fluctuation for flywheels that no engine needs.
    #[error(
        "a fluctuation of the speed needs an engine with gas, got none\nhint: add [gas] to an engine file, or leave the fluctuation out"
    )]
    NoGas,
    /// Its torque cannot be computed.
    #[error("{engine}: {error}")]
    Torque {
        /// Name of the engine.
        engine: String,
        /// Why.
        error: Box<TorqueError>,
    },
    /// Its mounts do not hold it.
    #[error("{engine}: {error}")]
    Mounts {
        /// Name of the engine.
        engine: String,
        /// Why.
        error: Box<MountError>,
    },
    /// It cannot be made equal to the reference.
    #[error(transparent)]
    Similar(#[from] SimilarError),
}

/// The engines side by side, each in the size that the request asks for.
///
/// A similar engine is computed as the original at the speed of equal piston speed, times the factors of similarity (book, eqs.
/// 31.1 to 31.3); its pressures over the crank angle are those of the original at its own speed. Where not all files have gas,
/// powers are made equal at equal mean effective pressure, which is said.
///
/// # Errors
/// [`CompareError`] names the engine and what stands in the way.
///
/// # Example
/// ```
/// use lanchester::{CompareEntry, CompareRequest, ComparedWith, compare};
/// let entry = |name| CompareEntry {
///     file: lanchester::file::read(lanchester::file::template(name).expect("it is in the gallery").text)
///         .file
///         .expect("the gallery has no mistakes"),
///     traces: Vec::new(),
///     with: ComparedWith::OwnDevices,
/// };
/// let both = compare(&[entry("in-line-4"), entry("in-line-6")], &CompareRequest::default())?;
/// // An in-line six has no force but that of the sixth order.
/// assert!(both.engines[1].force < 0.01 * both.engines[0].force);
/// # Ok::<(), lanchester::CompareError>(())
/// ```
pub fn compare(entries: &[CompareEntry], request: &CompareRequest) -> Result<Comparison, CompareError> {
    if entries.len() < 2 {
        return Err(CompareError::TooFew { got: entries.len() });
    }
    for (quantity, got) in
        [("share of the reference", Some(request.share)), ("mount spacing", request.mount_spacing)]
    {
        if let Some(got) = got.filter(|got| !(*got > 0.0 && got.is_finite())) {
            return Err(CompareError::Number { quantity, got });
        }
    }
    if request.reference >= entries.len() {
        return Err(CompareError::Reference { got: request.reference + 1, count: entries.len() });
    }
    let mut warnings = Vec::new();
    let candidates = entries
        .iter()
        .map(|entry| Candidate::new(entry, request, &mut warnings))
        .collect::<Result<Vec<_>, _>>()?;
    if request.fluctuation.is_some() && candidates.iter().all(|candidate| candidate.gas.is_none()) {
        return Err(CompareError::NoGas);
    }
    let fluctuation = request.fluctuation.unwrap_or(FLUCTUATION);
    let measures = measures(&candidates, request.equal, &mut warnings)?;
    let wanted = measures[request.reference];
    let engines = candidates
        .iter()
        .zip(&measures)
        .map(|(candidate, &own)| {
            let similar = Similar::of(request.equal, request.held, own, wanted)?;
            candidate.compared(similar, request, fluctuation)
        })
        .collect::<Result<Vec<_>, _>>()?;
    let rankings = Criterion::ALL.iter().filter_map(|criterion| Ranking::of(*criterion, &engines)).collect();
    Ok(Comparison {
        version: COMPARISON_VERSION,
        equal: request.equal,
        held: request.held,
        reference: request.reference,
        share: request.share,
        fluctuation,
        engines,
        rankings,
        warnings,
    })
}

/// What is made equal, engine by engine; ones where nothing is.
fn measures(
    candidates: &[Candidate],
    equal: Equal,
    warnings: &mut Vec<String>,
) -> Result<Vec<f64>, CompareError> {
    let displacement = |candidate: &Candidate, measure| {
        candidate.displacement.ok_or(CompareError::Bore { engine: candidate.engine.name.clone(), measure })
    };
    match equal {
        Equal::AsTheyAre => Ok(vec![1.0; candidates.len()]),
        Equal::Displacement => candidates.iter().map(|c| displacement(c, "displacement")).collect(),
        Equal::Power => {
            let powers = candidates.iter().map(Candidate::power).collect::<Result<Option<Vec<f64>>, _>>()?;
            if let Some(powers) = powers {
                return Ok(powers);
            }
            warnings.push(
                "not every file says what the gas does: powers are made equal at equal mean effective pressure"
                    .to_owned(),
            );
            let relative = |c: &Candidate| {
                let revolutions = f64::from(c.engine.strokes.revolutions());
                displacement(c, "power").map(|volume| volume * c.speed / (TAU * revolutions))
            };
            candidates.iter().map(relative).collect()
        }
    }
}

/// An engine with its devices and speed, in the size of its file.
struct Candidate {
    engine: Engine,
    with: Option<String>,
    speed: f64,
    displacement: Option<f64>,
    gas: Option<Gas>,
    /// Torques over the angle that its file gives, in the size of the file.
    outer: OuterTorque,
    traces: Vec<TraceFile>,
    /// What the crankshaft drives.
    driveline: Vec<DrivelineInertia>,
}

/// Pressures on all pistons of an engine.
struct Gas {
    /// At the speed of the comparison.
    own: Vec<CylinderGas>,
    /// At the lowest speed.
    lowest: Vec<CylinderGas>,
}

impl Candidate {
    fn new(
        entry: &CompareEntry,
        request: &CompareRequest,
        warnings: &mut Vec<String>,
    ) -> Result<Candidate, CompareError> {
        let speed = request.speed.unwrap_or(entry.file.engine.speed.highest);
        let range = SpeedRange { lowest: entry.file.engine.speed.lowest.min(speed), highest: speed };
        let own = changed(&entry.file.engine, |parts| parts.speed = range)?;
        let own_name = own.name.clone();
        let balance = |error| CompareError::Balance { engine: own_name.clone(), error: Box::new(error) };
        let (engine, with) = match entry.with {
            ComparedWith::OwnDevices => (own, None),
            ComparedWith::Arrangement(arrangement) => {
                let options = ArrangementOptions::default();
                let with = arranged(&own, arrangement, &options).map_err(balance)?;
                (with, Some(arrangement.name().to_owned()))
            }
            ComparedWith::Optimum => {
                (optimal(&own, &entry.file.tasks, &entry.traces, warnings)?, Some("optimum".to_owned()))
            }
        };
        let refused = |error| CompareError::Load { engine: own_name.clone(), error: Box::new(error) };
        let strokes =
            motion(&engine, &LoadRequest { samples: 1, ..LoadRequest::default() }).map_err(refused)?;
        let swept = engine
            .cylinders
            .iter()
            .zip(&strokes)
            .map(|(cylinder, motion)| Some(PI / 4.0 * cylinder.bore?.powi(2) * motion.stroke));
        let displacement = swept.sum();
        let gas = Gas::of(&engine, &entry.traces, speed, warnings)?;
        let outer = OuterTorque::of(entry.file.tasks.simulation.as_deref())
            .map_err(|error| CompareError::Load { engine: engine.name.clone(), error: Box::new(error) })?;
        let (traces, driveline) = (entry.traces.clone(), driveline(&entry.file).to_vec());
        Ok(Candidate { displacement, gas, outer, with, speed, engine, traces, driveline })
    }

    /// Net indicated power in the size of the file [W]; `None` without gas.
    fn power(&self) -> Result<Option<f64>, CompareError> {
        let Some(gas) = &self.gas else { return Ok(None) };
        Ok(Some(self.torque_at(self.speed, gas)?.indicated.power))
    }

    /// Torque under the pressures of the comparison with the inertia of another speed [rad/s].
    fn torque_at(&self, speed: f64, gas: &Gas) -> Result<Torque, CompareError> {
        let request =
            TorqueRequest { speed: Some(speed), samples: 1, max_order: 1, ..TorqueRequest::default() };
        torque(&self.engine, &gas.own, &request).map_err(|error| self.no_torque(error))
    }

    fn no_torque(&self, error: TorqueError) -> CompareError {
        CompareError::Torque { engine: self.engine.name.clone(), error: error.into() }
    }

    /// The engine in the size and at the speed of `similar`.
    fn compared(
        &self,
        similar: Similar,
        asked: &CompareRequest,
        fluctuation: f64,
    ) -> Result<Compared, CompareError> {
        let (engine, mount_spacing) = (&self.engine, asked.mount_spacing);
        let request = LoadRequest {
            speed: Some(self.speed * similar.speed_of_original()),
            samples: 1,
            ..LoadRequest::default()
        };
        let loads = total_loads(engine, &request)
            .map_err(|error| CompareError::Load { engine: self.engine.name.clone(), error: error.into() })?;
        let natural = natural_loads(engine, self.speed * similar.speed_of_original());
        let left = |value: f64, natural: f64| if value <= ROUNDING * natural { 0.0 } else { value };
        let peaks = &loads.peaks;
        let roll = peaks.roll_moment.max.value.max(-peaks.roll_moment.min.value);
        let force = similar.force() * left(peaks.force.max.value, natural[0]);
        let couple = similar.moment() * left(peaks.couple.max.value, natural[1]);
        let crank = self.inside_the_crank(similar)?;
        let speeds = [engine.speed.lowest, self.speed];
        let [main_film, crankpin_film, rule_safety, fillet_safety] =
            similar_durability(engine, &self.traces, similar, speeds, &self.driveline, asked.finite_elements);
        let counterweights: f64 = engine.counterweights.iter().map(|weight| weight.unbalance).sum();
        let shaft_weights: f64 =
            engine.shafts.iter().flat_map(|shaft| &shaft.weights).map(|weight| weight.unbalance).sum();
        Ok(Compared {
            engine: engine.name.clone(),
            with: self.with.clone(),
            similar,
            speed: self.speed * similar.speed,
            displacement: self.displacement.map(|volume| volume * similar.mass()),
            force,
            force_leading: leading(&loads.orders, similar.force(), force, |order| {
                [order.force_forward.norm(), order.force_backward.norm()]
            }),
            couple,
            couple_leading: leading(&loads.orders, similar.moment(), couple, |order| {
                [order.couple_forward.norm(), order.couple_backward.norm()]
            }),
            roll_moment: similar.moment() * left(roll, natural[1]),
            mount_force: match mount_spacing {
                Some(spacing) => {
                    Some(self.stiff_mount_force(similar, mounts_apart(spacing / similar.length))?)
                }
                None if self.engine.is_on_springs() => Some(self.sprung_mount_force(similar)?),
                None if self.engine.mounts.is_empty() => None,
                None => Some(self.stiff_mount_force(similar, self.engine.mounts.clone())?),
            },
            main_load: crank.largest(Affected::MainLoadPeak).map(|[load, _]| similar.force() * load),
            main_film,
            crankpin_film,
            rule_safety,
            fillet_safety: asked.finite_elements.then_some(fillet_safety),
            bending_moment: crank
                .largest(Affected::BendingMoment)
                .map(|[moment, _]| similar.moment() * moment),
            balance_rate: crank
                .of(Affected::BalanceRate)
                .map(|bay| [bay.before; 2])
                .reduce(|[least, most], [rate, _]| [least.min(rate), most.max(rate)]),
            firing_unevenness: firing_chart(engine).ok().map(|chart| chart.unevenness),
            torque: self.torque(similar, fluctuation)?,
            counterweights: similar.unbalance() * counterweights,
            shafts: engine.shafts.len(),
            shaft_weights: similar.unbalance() * shaft_weights,
            added_mass: added_mass(engine).map(|mass| mass * similar.mass()),
        })
    }

    /// Loads of main bearings, bending and balance rates, in the size of the file.
    fn inside_the_crank(&self, similar: Similar) -> Result<Consequences, CompareError> {
        let highest = self.speed * similar.speed_of_original();
        let speed = SpeedRange { lowest: highest.min(self.engine.speed.lowest), highest };
        // The mounts are compared by themselves.
        let engine = changed(&self.engine, |parts| (parts.speed, parts.mounts) = (speed, Vec::new()))?;
        consequences(&engine, &engine, None)
            .map_err(|error| CompareError::Balance { engine: engine.name.clone(), error: Box::new(error) })
    }

    /// Largest force of the moving masses at any of `mounts`, which are in the size of the file and stiff.
    fn stiff_mount_force(&self, similar: Similar, mounts: Vec<Mount>) -> Result<f64, CompareError> {
        let highest = self.speed * similar.speed_of_original();
        let speed = SpeedRange { lowest: highest.min(self.engine.speed.lowest), highest };
        let engine = changed(&self.engine, |parts| (parts.speed, parts.mounts) = (speed, mounts))?;
        let most = Peak(Load::LargestMountForce);
        let value = as_it_stands(&engine, most)
            .map_err(|error| CompareError::Balance { engine: engine.name.clone(), error: Box::new(error) })?;
        let [natural, _] = natural_loads(&engine, highest);
        Ok(if value <= ROUNDING * natural { 0.0 } else { similar.force() * value })
    }

    /// Largest force at any mount over the range of speeds, with mounts that are similar too.
    fn sprung_mount_force(&self, similar: Similar) -> Result<f64, CompareError> {
        let factor = similar.speed_of_original();
        let (lowest, highest) = (self.engine.speed.lowest * factor, self.engine.speed.highest * factor);
        let steps = if lowest < highest { SPEED_STEPS } else { 0 };
        let speed = |k: f64| lowest + (highest - lowest) * k / steps.max(1) as f64;
        let speeds: Vec<f64> = (0..=steps).map(|k| speed(k as f64)).collect();
        let forces = self.forces_at_mounts(&speeds)?;
        let place = (0..forces.len()).max_by(|a, b| forces[*a].total_cmp(&forces[*b])).unwrap_or(0);
        // Between its neighbours, finely enough for any resonance that a step shows.
        let fine: Vec<f64> = (-8..=8)
            .map(|k| (place as f64 + f64::from(k) / 8.0).clamp(0.0, steps as f64))
            .map(speed)
            .collect();
        let fine = self.forces_at_mounts(&fine)?;
        Ok(similar.force() * forces.into_iter().chain(fine).fold(0.0, f64::max))
    }

    /// Largest force at any mount at each of `speeds` [rad/s].
    fn forces_at_mounts(&self, speeds: &[f64]) -> Result<Vec<f64>, CompareError> {
        let refused =
            |error| CompareError::Mounts { engine: self.engine.name.clone(), error: Box::new(error) };
        let mut excitations = inertia_excitations(&self.engine, speeds, MOUNT_ORDERS).map_err(refused)?;
        if self.gas.is_some() {
            let gas = SpeedGas::new(&self.engine, Ok(&self.traces));
            for excitation in &mut excitations {
                let pressures = gas.at(excitation.speed).map_err(|reason| self.no_pressures(reason))?;
                let train = GasTrain::new(&self.engine, &pressures, Lever::Exact)
                    .map_err(|error| self.no_torque(error))?;
                excitation.orders = merged_orders(&excitation.orders, &train.orders(MOUNT_ORDERS));
            }
        }
        let rotors = rotor_inertia_about_z(&rotating_bodies(&self.engine));
        let response = MountSystem::new(&self.engine)
            .and_then(|system| system.with_rotors(rotors).response(&excitations))
            .map_err(refused)?;
        let largest = |at: &SpeedResponse| at.peaks.iter().map(|peak| peak.value).fold(0.0, f64::max);
        Ok(response.speeds.iter().map(largest).collect())
    }

    fn no_pressures(&self, reason: String) -> CompareError {
        let error = BalanceError::Gas { reason };
        CompareError::Balance { engine: self.engine.name.clone(), error: Box::new(error) }
    }

    fn torque(&self, similar: Similar, fluctuation: f64) -> Result<Option<ComparedTorque>, CompareError> {
        let (engine, Some(gas)) = (&self.engine, &self.gas) else { return Ok(None) };
        // The pressures are those of the engine at its own speed, the inertia that of equal piston speed.
        let found = self.torque_at(self.speed * similar.speed_of_original(), gas)?;
        let lowest = engine.speed.lowest * similar.speed_of_original();
        let need =
            flywheel_need(engine, Some(&gas.lowest), lowest, &self.outer, known_inertia(engine), fluctuation)
                .map_err(|error| self.no_torque(error))?;
        let moment = similar.moment();
        let work = found.indicated.torque * found.energy.own_period;
        Ok(Some(ComparedTorque {
            power: moment * found.indicated.torque * self.speed * similar.speed,
            mean: moment * found.indicated.torque,
            most: moment * found.total_extremes.max.value,
            least: moment * found.total_extremes.min.value,
            excess: moment * found.energy.excess,
            excess_share: found.energy.excess / work.abs().max(f64::MIN_POSITIVE),
            inertia: similar.inertia() * need.by_formula,
            flywheel: need.flywheel.map(|flywheel| similar.inertia() * flywheel),
        }))
    }
}

impl Gas {
    /// That of an engine at `speed` [rad/s] and at its lowest speed; `None` where its file does not say.
    fn of(
        engine: &Engine,
        traces: &[TraceFile],
        speed: f64,
        warnings: &mut Vec<String>,
    ) -> Result<Option<Gas>, CompareError> {
        if engine.gas.is_none() {
            return Ok(None);
        }
        let mut told = |text: &str| {
            let warning = format!("{}: {text}", engine.name);
            if !warnings.contains(&warning) {
                warnings.push(warning);
            }
        };
        let mut at = |speed: f64| -> Result<Vec<CylinderGas>, CompareError> {
            let report = cylinder_gas(engine, traces, speed)
                .map_err(|error| CompareError::Gas { engine: engine.name.clone(), error: error.into() })?;
            report.warnings.iter().for_each(|warning| told(warning));
            Ok(report.cylinders)
        };
        let gas = Gas { own: at(speed)?, lowest: at(engine.speed.lowest)? };
        if known_inertia(engine).crankshaft.is_none() {
            told(UNKNOWN_CRANKSHAFT);
        }
        Ok(Some(gas))
    }
}

/// An engine with a change.
fn changed(engine: &Engine, change: impl FnOnce(&mut EngineParts)) -> Result<Engine, CompareError> {
    engine.with(change).map_err(|faults| CompareError::Engine {
        engine: engine.name.clone(),
        fault: Box::new(Fault::first_of(faults)),
    })
}

/// Two stiff mounts so far apart [m] on the axis of the crank.
fn mounts_apart(spacing: f64) -> Vec<Mount> {
    let mount = |(name, side): (&str, f64)| Mount {
        name: name.to_owned(),
        x: 0.0,
        y: 0.0,
        z: side * spacing,
        spring: None,
    };
    [("front", -0.5), ("rear", 0.5)].map(mount).to_vec()
}

/// The engine with the best devices for the task of its file.
fn optimal(
    engine: &Engine,
    tasks: &Tasks,
    traces: &[TraceFile],
    warnings: &mut Vec<String>,
) -> Result<Engine, CompareError> {
    let task = tasks.balance.clone().unwrap_or_else(|| default_task(engine));
    let answer = optimise_on_webs(
        engine,
        Ok(traces),
        &task,
        tasks.shape_task.as_ref(),
        &BalanceSettings::default(),
        &|_| Next::Continue,
    )
    .map_err(|error| CompareError::Optimum { engine: engine.name.clone(), error: Box::new(error) })?;
    match &answer.outcome {
        Outcome::Optimal => {}
        Outcome::Stopped { reason, .. } if !answer.weights.is_empty() => {
            warnings.push(format!("{}: the best that was found is not proved: {reason}", engine.name));
        }
        Outcome::Stopped { reason, .. }
        | Outcome::Infeasible { reason, .. }
        | Outcome::CannotVanish { reason, .. } => {
            return Err(CompareError::NoOptimum { engine: engine.name.clone(), reason: reason.clone() });
        }
    }
    Ok(fitted(engine, &answer))
}

/// Equal steps of speed at which forces at mounts with springs are looked at.
const SPEED_STEPS: usize = 120;

/// Highest order of the forces at the mounts.
const MOUNT_ORDERS: u32 = 12;

/// Share of what the masses of single cylinders do below which a load is rounding.
const ROUNDING: f64 = 1e-11;

/// Force [N] and moment [N m] that all cylinders would have together if nothing cancelled.
fn natural_loads(engine: &Engine, speed: f64) -> [f64; 2] {
    let mut natural = [0.0; 2];
    for cylinder in &engine.cylinders {
        let throw = &engine.throws[cylinder.throw];
        let crank_speed = engine.crankshafts[throw.crankshaft].ratio.value() * speed;
        let mass = cylinder.piston_mass + cylinder.rod.mass();
        let force = mass * throw.radius * crank_speed.powi(2);
        natural[0] += force;
        natural[1] += force * cylinder.z.abs().max(throw.radius);
    }
    natural
}

/// The order of the largest resultant; `None` where nothing is left.
fn leading(
    orders: &[OrderLoads],
    factor: f64,
    peak: f64,
    sizes: impl Fn(&OrderLoads) -> [f64; 2],
) -> Option<Leading> {
    let of = |order: &OrderLoads| {
        let [forward, backward] = sizes(order);
        let size = forward + backward;
        Leading {
            order: order.order,
            size: factor * size,
            forward: if size > 0.0 { forward / size } else { 0.0 },
        }
    };
    let most = orders.iter().map(of).max_by(|a, b| a.size.total_cmp(&b.size))?;
    (peak > 0.0).then_some(most)
}

/// Mass of all weights [kg], where all of them are parts.
fn added_mass(engine: &Engine) -> Option<f64> {
    let crank =
        engine.counterweights.iter().map(|weight| weight.part.as_ref().map(|part| part.part.moments().mass));
    let shafts = engine
        .shafts
        .iter()
        .flat_map(|shaft| &shaft.weights)
        .map(|weight| weight.part.as_ref().map(|part| part.mass()));
    crank.chain(shafts).sum()
}
