//! What a report tells of the running engine: torque with gas, bearings, the block on its mounts.

use crate::bearing_films::{BearingFilms, FilmMethod, bearing_films};
use crate::crosscheck::{CrossCheckRequest, crosscheck};
use crate::graph_report::{bond_graph_report, has_graph};
use crate::mounted::{MountSpeeds, mounts};
use crate::pressure::measured::TraceFile;
use crate::simulation::plan::SimulateRequest;
use crate::simulation::{simulate, simulation_beside};
use crate::stress::rule::{RuleRequest, has_rule};
use crate::stress::rule_torsion::crank_rule_of_file;
use crate::torque_report::{
    BearingStudy, TorqueReport, TorqueReportRequest, bearing_study, power_speeds, torque_report,
};
use crate::torsion_study::{TorsionRequest, has_torsion, torsion};
use lanchester_file::EngineFile;
use lanchester_mechanism::{MountStudy, TorqueRequest};
use lanchester_model::Engine;
use lanchester_report::{
    BondGraphResult, ClosedFormBeside, CrankRule, CrossCheck, Section, SimulationResult, TorsionResult,
    bond_graph_section, crosscheck_section, mounts_section, rule_section, simulation_section,
    torsion_section,
};

/// Speeds and highest order of the section on mounts.
const MOUNT_SPEEDS: usize = 31;
const MOUNT_ORDERS: u32 = 8;

/// Speeds of the power curve, where a cycle is computed.
const POWER_SPEEDS: usize = 7;

/// The running engine, as far as its file tells.
#[derive(Debug, Clone, Default)]
pub struct Running {
    /// Torque with gas, where the file says something of it; with a flywheel alone that of inertia.
    pub torque: Option<TorqueReport>,
    /// Loads of the bearings.
    pub bearings: Option<BearingStudy>,
    /// Oil films, where the file says something of clearances or oil.
    pub films: Option<BearingFilms>,
    /// Strength of the crankshafts whose fillets and material the file gives.
    pub strength: Vec<CrankRule>,
    /// Torsional vibration, where the file says something of it.
    pub torsion: Option<TorsionResult>,
    /// The block on its mounts.
    pub mounts: Option<MountStudy>,
    /// The run in time that the file describes.
    pub simulation: Option<SimulationResult>,
    /// The closed form beside that run.
    pub beside: Option<ClosedFormBeside>,
    /// How far closed form and bond graph agree with the simulation, where the file describes a run.
    pub crosscheck: Option<CrossCheck>,
    /// The engine as a bond graph.
    pub graph: Option<BondGraphResult>,
    /// What was left out and why, and what the results warn of.
    pub warnings: Vec<String>,
}

/// Whether [`running`] has something to tell of an engine: only then its pressures are needed.
pub fn is_running(file: &EngineFile) -> bool {
    let EngineFile { engine, tasks } = file;
    let turns = engine.gas.is_some() || engine.flywheel.is_some() || has_rule(engine) || has_torsion(engine);
    turns
        || engine.bearings.is_some()
        || engine.bearing_design.is_some()
        || engine.is_on_springs()
        || tasks.simulation.is_some()
}

/// Everything that the file has enough for, torque and bearings at `speed` [rad/s]; `traces`: the pressures, or why they cannot be
/// read. What is left out is a warning.
pub fn running(file: &EngineFile, traces: Result<&[TraceFile], String>, speed: f64) -> Running {
    let EngineFile { engine, tasks } = file;
    let has_bearings = engine.gas.is_some() || engine.bearings.is_some() || engine.bearing_design.is_some();
    let mut warnings = Vec::new();
    let has_torque = engine.gas.is_some() || engine.flywheel.is_some();
    let torque = section(has_torque, torque_name(engine.gas.is_some()), &traces, &mut warnings, |traces| {
        let request = TorqueReportRequest {
            torque: TorqueRequest { speed: Some(speed), ..TorqueRequest::default() },
            speeds: power_speeds(engine, POWER_SPEEDS),
            simulation: tasks.simulation.clone(),
            ..TorqueReportRequest::default()
        };
        torque_report(engine, traces, &request).map_err(|error| error.to_string())
    });
    let bearings = section(has_bearings, "loads of the bearings are", &traces, &mut warnings, |traces| {
        bearing_study(engine, traces, speed).map_err(|error| error.to_string())
    });
    let loads = bearings.as_ref().and_then(|study| study.parts.first());
    let wanted = loads.filter(|_| engine.bearing_design.is_some());
    let films = section(wanted.is_some(), "the oil films are", &traces, &mut warnings, |_| {
        let loads = wanted.ok_or("no loads of the bearings are known")?;
        bearing_films(engine, loads, &[], FilmMethod::Tables).map_err(|error| error.to_string())
    });
    let strength =
        section(has_rule(engine), "the strength of the crankshaft is", &traces, &mut warnings, |traces| {
            let of = |crankshaft| {
                let request = RuleRequest { crankshaft, ..RuleRequest::default() };
                crank_rule_of_file(file, traces, &request).map_err(|error| error.to_string())
            };
            (0..engine.crankshafts.len()).map(of).collect::<Result<Vec<_>, _>>()
        });
    let torsion = section(has_torsion(engine), "torsional vibration is", &traces, &mut warnings, |traces| {
        torsion(file, traces, &TorsionRequest::default()).map_err(|error| error.to_string())
    });
    let mounts =
        section(engine.is_on_springs(), "the block on its mounts is", &traces, &mut warnings, |traces| {
            mounts(engine, &MountSpeeds::Range(MOUNT_SPEEDS), MOUNT_ORDERS, Some(traces), &[])
                .map_err(|error| error.to_string())
        });
    let simulation =
        section(tasks.simulation.is_some(), "the simulated run is", &traces, &mut warnings, |traces| {
            simulate(file, traces, &SimulateRequest::default()).map_err(|error| error.to_string())
        });
    let beside = match (&simulation, &traces) {
        (Some(result), Ok(traces)) => simulation_beside(file, traces, result),
        _ => None,
    };
    let crosscheck =
        section(tasks.simulation.is_some(), "the second opinion is", &traces, &mut warnings, |traces| {
            let request = CrossCheckRequest {
                speed: Some(speed),
                simulation: tasks.simulation.clone(),
                ..CrossCheckRequest::default()
            };
            crosscheck(engine, traces, &request).map_err(|error| error.to_string())
        });
    let input = tasks.simulation.as_deref();
    let graph = section(has_graph(engine, input), "the bond graph is", &traces, &mut warnings, |traces| {
        bond_graph_report(engine, traces, input, speed)
    });
    let strength = strength.unwrap_or_default();
    Running {
        torque,
        bearings,
        films,
        strength,
        torsion,
        mounts,
        simulation,
        beside,
        crosscheck,
        graph,
        warnings,
    }
}

/// What the section on torque is called where it is left out.
fn torque_name(with_gas: bool) -> &'static str {
    if with_gas { "torque with gas is" } else { "torque is" }
}

impl Running {
    /// What was left out, then what the results warn of, each once.
    pub fn all_warnings(&self) -> Vec<String> {
        let of_torque = self.torque.iter().flat_map(|report| &report.warnings);
        let of_mounts = self.mounts.iter().flat_map(|study| &study.warnings);
        let mut all: Vec<String> = Vec::new();
        for warning in self.warnings.iter().chain(of_torque).chain(of_mounts) {
            if !all.contains(warning) {
                all.push(warning.clone());
            }
        }
        all
    }

    /// What is told, topic by topic.
    pub fn sections(&self, engine: &Engine) -> Vec<Section> {
        let torque = self.torque.as_ref().map(TorqueReport::section);
        let bearings = self.bearings.as_ref().and_then(|study| study.section(engine));
        let films = self.films.as_ref().and_then(BearingFilms::section);
        let mounts = self.mounts.as_ref().map(|study| mounts_section(engine, study));
        let simulated = self.simulation.as_ref().map(|run| simulation_section(run, self.beside.as_ref()));
        let crosscheck = self.crosscheck.as_ref().map(crosscheck_section);
        let graph = self.graph.as_ref().map(bond_graph_section);
        let strength = rule_section(&self.strength);
        let torsion = self.torsion.as_ref().map(torsion_section);
        let found = [torque, bearings, films, torsion, strength, mounts, simulated, crosscheck, graph];
        found.into_iter().flatten().collect()
    }
}

/// One section, where it is `wanted`; why it is left out goes to `warnings`.
fn section<T>(
    wanted: bool,
    name: &str,
    traces: &Result<&[TraceFile], String>,
    warnings: &mut Vec<String>,
    of: impl FnOnce(&[TraceFile]) -> Result<T, String>,
) -> Option<T> {
    if !wanted {
        return None;
    }
    let found = match traces {
        Ok(traces) => of(traces),
        Err(error) => Err(error.clone()),
    };
    let because = |error: String| {
        let error = error.strip_prefix("error: ").unwrap_or(&error);
        warnings.push(format!("{name} left out: {error}").replace("\nhint:", ";"));
    };
    found.map_err(because).ok()
}
