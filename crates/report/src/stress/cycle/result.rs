//! What is told of a crankshaft that turns in its bearings.

use crate::stress::body::CrankSheet;
use crate::stress::fatigue::{FatigueMeasure, FilletFatigue};
use lanchester_film::BearingKind;
use lanchester_flex::train::{CycleOptions, CycleOutcome, EnergyBalance, FilletCycle, FreeSpeed};
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const CRANK_CYCLE_VERSION: u32 = 2;

/// Largest missing energy over the turnover of a run that counts as balanced.
const BALANCED: f64 = 1e-4;

/// Change of a free speed from cycle to cycle over its swing that counts as none.
pub const SPEED_SETTLED: f64 = 1e-3;

/// What ties journals and pins to their bearings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CycleLaw {
    /// No clearance and no yield.
    Rigid,
    /// Clearance, then a spring with a damper.
    Contact,
    /// Springs with dampers about the middle.
    Bushing,
    /// An oil film.
    Film,
    /// Each bearing as the file says.
    File,
}

impl CycleLaw {
    /// The four laws for all bearings, in the order of tables.
    pub const FOUR: [CycleLaw; 4] = [CycleLaw::Rigid, CycleLaw::Contact, CycleLaw::Bushing, CycleLaw::Film];

    /// Name for tables and legends.
    pub fn name(self) -> &'static str {
        match self {
            CycleLaw::Rigid => "rigid",
            CycleLaw::Contact => "contact",
            CycleLaw::Bushing => "bushing",
            CycleLaw::Film => "film",
            CycleLaw::File => "as the file says",
        }
    }
}

/// Whether the crankshaft yields.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CrankKind {
    /// It does.
    Flexible,
    /// Its rigid motions alone: no stress.
    Rigid,
}

/// How the flywheel turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CycleSpeed {
    /// At constant speed.
    Constant,
    /// As gas, inertia and a constant load turn it: its speed swings.
    Free,
}

/// A crankshaft over the cycle by several laws of its bearings, side by side.
///
/// The crankshaft linear, elastic, in natural modes and static shapes; rods and pistons rigid; block at rest; all motion in planes across the crank.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankCycle {
    /// [`CRANK_CYCLE_VERSION`].
    pub version: u32,
    /// What was meshed.
    pub sheet: CrankSheet,
    /// Mean speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Period of crankshaft 1 [rad].
    pub period: f64,
    /// How the flywheel turns.
    pub motion: CycleSpeed,
    /// Where the pressures come from, in words; `None`: no gas acts.
    pub gas: Option<String>,
    /// Free natural frequencies of the modes that were kept [Hz].
    pub frequencies: Vec<f64>,
    /// Coordinates of the crankshaft.
    pub coordinates: usize,
    /// Nodes of fillets at which stress is known.
    pub stress_nodes: usize,
    /// How the runs were made.
    pub options: CycleOptions,
    /// Main bearings of a rigid crankshaft by three rules; `None`: not comparable, a note says why.
    pub rules: Option<MainRules>,
    /// One a law and kind of crankshaft.
    pub runs: Vec<CycleRun>,
    /// What keeps the largest values from being those of an engine, where something does.
    pub ringing: Option<String>,
    /// What judges fatigue; `None` where the file gives no strength.
    pub fatigue: Option<FatigueMeasure>,
    /// What was assumed and left out.
    pub notes: Vec<String>,
}

/// Loads of the main bearings of the same crankshaft, rigid, at constant speed, by the rules of the simulation.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MainRules {
    /// Names of the rules.
    pub names: [String; 3],
    /// Crank angles [rad].
    pub theta: Vec<f64>,
    /// By main bearing, then by rule: load of the journal on the bearing, `x` and `y` of the block [N], at every angle.
    pub loads: Vec<[Vec<[f64; 2]>; 3]>,
}

impl MainRules {
    /// Largest load of a main by a rule [N].
    pub fn peak(&self, main: usize, rule: usize) -> f64 {
        largest(&self.loads[main][rule])
    }
}

/// One law over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CycleRun {
    /// The law.
    pub law: CycleLaw,
    /// Whether the crankshaft yields.
    pub crank: CrankKind,
    /// How the cycles ended.
    pub outcome: CycleOutcome,
    /// Cycles that were run.
    pub cycles: usize,
    /// Change of the orbits in the last cycle over the clearance; `None` before two cycles.
    pub orbit_change: Option<f64>,
    /// Change of loads and deformation in the last cycle over their largest.
    pub stress_change: Option<f64>,
    /// Cycles behind the peaks and envelopes below: one where they repeat, five where they do not.
    pub recorded: usize,
    /// Energies of the recorded cycle; of several the one with the largest error.
    pub energy: EnergyBalance,
    /// Missing energy over the turnover.
    pub energy_error: f64,
    /// Steps of all cycles.
    pub steps: u64,
    /// Steps that were tried again shorter.
    pub rejected: u64,
    /// Newton iterations.
    pub iterations: u64,
    /// For a free speed: the load, and the change of the speed over the last cycle; `None` before there is one.
    pub free_speed: Option<FreeSpeed>,
    /// Crank angle of crankshaft 1 at every instant of the last recorded cycle [rad].
    pub theta: Vec<f64>,
    /// Speed of crankshaft 1 there [rad/s].
    pub speed: Vec<f64>,
    /// Torque of the flywheel on the crankshaft there [N m], of its own sense.
    pub torque: Vec<f64>,
    /// Main bearings, then big ends.
    pub bearings: Vec<BearingCycle>,
    /// Fillets along z; of several recorded cycles peaks and curves are those of the envelope. Empty: a rigid crankshaft, or only sharp corners.
    pub fillets: Vec<FilletCycle>,
    /// Safety of the same fillets against fatigue over the recorded cycles. Empty where no strength is known.
    pub fatigue: Vec<FilletFatigue>,
}

/// A bearing over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BearingCycle {
    /// Main or big end.
    pub kind: BearingKind,
    /// Number of the main bearing on its crankshaft, or of the cylinder.
    pub number: usize,
    /// Its plane [m].
    pub z: f64,
    /// Its law, with its numbers, in words.
    pub law: String,
    /// Radial clearance [m], where it has one.
    pub clearance: Option<f64>,
    /// Load at every instant of the last cycle: journal or pin on the bearing, `x` and `y` of the block [N].
    pub load: Vec<[f64; 2]>,
    /// Largest load over the recorded cycles [N].
    pub largest_load: f64,
    /// Crank angle there [rad].
    pub largest_load_angle: f64,
    /// Mean size of the load [N].
    pub mean_load: f64,
    /// Centre of journal or pin from that of the bearing at every instant of the recorded cycles [m], in the block's frame; of a big end in that of its rod, `x`
    /// towards the piston.
    pub orbit: Vec<[f64; 2]>,
    /// Largest distance of the centres [m].
    pub largest_eccentricity: f64,
    /// The film where it is thinnest; of oil films alone.
    pub film: Option<LeastFilm>,
}

/// An oil film where it is thinnest over the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct LeastFilm {
    /// Thickness in the middle of the bearing; of a law that knows of tilt at its ends [m].
    pub thickness: f64,
    /// Crank angle there [rad].
    pub theta: f64,
    /// Whether the law knows of tilt.
    pub is_tilted: bool,
    /// Least thickness at the ends of the bearing, with the slope of the journal [m]; below 0 the slope is more than a law allows that knows of no tilt, and one that knows of it lets the
    /// surfaces touch.
    pub at_ends: f64,
    /// Share of the cycle in which the film is below three times the roughness [1].
    pub below_roughness: f64,
    /// Largest pressure [Pa] and its crank angle [rad].
    pub largest_pressure: Option<[f64; 2]>,
    /// Least film of the rigid crankshaft, throw by throw, quasi-static [m].
    pub quasi_static: Option<f64>,
    /// Viscosity [Pa s].
    pub viscosity: f64,
}

/// Largest size.
pub(crate) fn largest(loads: &[[f64; 2]]) -> f64 {
    loads.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max)
}

impl BearingCycle {
    /// "main 2", "big end 1".
    pub fn name(&self) -> String {
        match self.kind {
            BearingKind::Main => format!("main {}", self.number),
            BearingKind::Crankpin => format!("big end {}", self.number),
        }
    }
}

impl CycleRun {
    /// Name for legends.
    pub fn name(&self) -> String {
        match self.crank {
            CrankKind::Flexible => self.law.name().to_owned(),
            CrankKind::Rigid => format!("{}, rigid crankshaft", self.law.name()),
        }
    }

    /// Whether it has an outcome to go by, a free speed that is that of its flywheel, and balanced energies.
    pub fn is_sound(&self) -> bool {
        matches!(self.outcome, CycleOutcome::Periodic | CycleOutcome::NotPeriodic)
            && self.unsettled_speed().is_none()
            && self.energy_error <= BALANCED
    }

    /// Change of a free speed over its swing in the last cycle, where it had not settled.
    pub fn unsettled_speed(&self) -> Option<f64> {
        self.free_speed.map(|own| own.change).filter(|change| change.is_nan() || *change > SPEED_SETTLED)
    }

    /// The fillet with the largest stress.
    pub fn worst(&self) -> Option<&FilletCycle> {
        self.fillets.iter().max_by(|a, b| a.peak.total_cmp(&b.peak))
    }

    /// The fillet with the least safety against fatigue when all stress is scaled.
    pub fn most_fatigued(&self) -> Option<&FilletFatigue> {
        self.fatigue.iter().max_by(|a, b| a.point.plane.value.total_cmp(&b.point.plane.value))
    }

    /// Crank angle of a fillet's peak [rad].
    pub fn critical_angle(&self, fillet: &FilletCycle) -> f64 {
        self.theta.get(fillet.instant % self.theta.len().max(1)).copied().unwrap_or(f64::NAN)
    }

    /// The thinnest film of the main bearings, or of the big ends.
    pub fn least_film(&self, kind: BearingKind) -> Option<(&BearingCycle, &LeastFilm)> {
        let own = self.bearings.iter().filter(|own| own.kind == kind);
        own.filter_map(|own| Some((own, own.film.as_ref()?)))
            .min_by(|a, b| a.1.thickness.total_cmp(&b.1.thickness))
    }

    /// The bearing of a kind with the largest load.
    pub fn most_loaded(&self, kind: BearingKind) -> Option<&BearingCycle> {
        let own = self.bearings.iter().filter(|own| own.kind == kind);
        own.max_by(|a, b| a.largest_load.total_cmp(&b.largest_load))
    }

    /// What the last cycle changed, and what to do about it.
    fn last_change(&self) -> String {
        let percent = |change: Option<f64>| change.map(|change| format!("{:.2} %", 100.0 * change));
        let parts = [
            percent(self.orbit_change).map(|change| format!("orbits by {change} of the clearance")),
            percent(self.stress_change).map(|change| format!("loads by {change} of their largest")),
            percent(self.free_speed.map(|own| own.change))
                .map(|change| format!("the free speed by {change} of its swing")),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        match parts.is_empty() {
            true => "one cycle alone: allow more".to_owned(),
            false => format!("the last changed {}: allow more cycles", parts.join(", ")),
        }
    }

    /// How the cycles ended, in words.
    pub fn outcome_words(&self) -> String {
        match self.outcome {
            CycleOutcome::Periodic => "repeats".to_owned(),
            CycleOutcome::NotPeriodic => format!(
                "does not repeat in {} cycles: envelope of {}; {}",
                self.cycles,
                self.recorded,
                self.last_change()
            ),
            CycleOutcome::Broken { theta } => {
                let told = if self.recorded == 0 { "" } else { "; the last whole cycle is told" };
                format!(
                    "broke off at {:.0} deg: a film has no thickness left (roughness would carry), or a rod does not reach{told}",
                    theta.to_degrees()
                )
            }
            CycleOutcome::Stopped if self.recorded == 0 => "stopped before a whole cycle".to_owned(),
            CycleOutcome::Stopped => "stopped: the last whole cycle".to_owned(),
        }
    }
}

impl CrankCycle {
    /// Runs to go by: those of a sound end, of the flexible crankshaft where there are any.
    pub(super) fn counted(&self) -> Vec<&CycleRun> {
        let sound: Vec<&CycleRun> = self.runs.iter().filter(|run| run.is_sound()).collect();
        let is_flexible = |run: &&CycleRun| run.crank == CrankKind::Flexible;
        match self.runs.iter().any(|run| is_flexible(&run)) {
            true => sound.into_iter().filter(is_flexible).collect(),
            false => sound,
        }
    }

    /// Yield strength over the largest stress of all runs to go by; `None` where either is not known.
    pub fn static_safety(&self) -> Option<f64> {
        let strength = self.sheet.material.yield_strength?.value;
        let peaks = self.counted().into_iter().filter_map(CycleRun::worst).map(|own| own.peak);
        let peak = peaks.fold(0.0, f64::max);
        (peak > 0.0).then(|| strength / peak)
    }

    /// Run and fillet of the least safety against fatigue, of all runs to go by.
    pub fn most_fatigued(&self) -> Option<(&CycleRun, &FilletFatigue)> {
        let worst = self.counted().into_iter().filter_map(|run| Some((run, run.most_fatigued()?)));
        worst.max_by(|a, b| a.1.point.plane.value.total_cmp(&b.1.point.plane.value))
    }

    /// Run and fillet of the least safety against fatigue, of all stress or of its amplitude, of all runs to go by; `None` where none is known.
    pub fn weakest(&self) -> Option<(&CycleRun, &FilletFatigue)> {
        let fillets =
            self.counted().into_iter().flat_map(|run| run.fatigue.iter().map(move |own| (run, own)));
        fillets.min_by(|a, b| a.1.least_safety().total_cmp(&b.1.least_safety()))
    }

    /// Thinnest film of all runs to go by [m].
    pub fn least_film(&self) -> Option<f64> {
        let films =
            self.counted().into_iter().flat_map(|run| &run.bearings).filter_map(|own| own.film.as_ref());
        films.map(|film| film.thickness).min_by(f64::total_cmp)
    }

    /// The bearing through whose shell a journal leans furthest, with its film; `None` where none does.
    pub fn touching_ends(&self) -> Option<(String, &LeastFilm)> {
        let bearings = self.counted().into_iter().flat_map(|run| &run.bearings);
        let ends = bearings.filter_map(|own| Some((own.name(), own.film.as_ref()?)));
        ends.filter(|(_, film)| film.at_ends < 0.0).min_by(|a, b| a.1.at_ends.total_cmp(&b.1.at_ends))
    }

    /// Whether every run has an outcome to go by and balanced energies.
    pub fn is_sound(&self) -> bool {
        self.runs.iter().all(CycleRun::is_sound)
    }
}
