//! The scatter of an engine by the tolerances of its file: distribution, worst cases, limits, and what to tighten first.

use crate::scatter::error::ScatterError;
use crate::scatter::request::{Limit, Output, ScatterRequest};
use crate::scatter::result::{Capability, Deviation, Scatter};
use crate::scatter::scattering::{Scattering, Tally};
use crate::scatter::statistics::at_share;
use crate::scatter::worst::{WorstCase, worst_cases};
use lanchester_model::Engine;
use lanchester_task::{Criterion, Load, Tolerance, criterion_name};
use serde::Serialize;

/// Version of [`ScatterStudy`]; raised when a field changes its meaning or goes.
pub const SCATTER_STUDY_VERSION: u32 = 1;

/// Shares of the samples whose largest values stand in tables.
pub const TOLD_SHARES: [f64; 3] = [0.5, 0.95, 0.9973];

/// Share of the samples whose largest value tightening is judged by, and most samples for it.
const RARE: f64 = 0.9973;
const MOST_TIGHTENED: u64 = 1 << 16;

/// Steps of the distribution.
const STEPS: u32 = 200;

/// What to draw.
#[derive(Debug, Clone, PartialEq)]
pub struct ScatterOptions {
    /// Speed of the crankshaft [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// Number of samples.
    pub samples: u64,
    /// Seed of the draws.
    pub seed: u64,
    /// Whether the peaks of all orders count, or orders 1 and 2 alone, which are drawn several times faster.
    pub peaks: bool,
    /// Limits: on `force` and `couple`, of all orders, or of order 1 or 2.
    pub limits: Vec<lanchester_task::Limit>,
    /// Capability by percentiles that a limit is met with.
    pub capability: f64,
}

impl Default for ScatterOptions {
    /// 100 000 samples at the highest speed with the peaks of all orders, limits met with a capability of 1.33.
    fn default() -> ScatterOptions {
        ScatterOptions {
            speed: None,
            samples: 100_000,
            seed: 1,
            peaks: true,
            limits: Vec::new(),
            capability: 1.33,
        }
    }
}

/// What halving one tolerance would do.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Tightened {
    /// Place of the tolerance in the list, from 0.
    pub tolerance: usize,
    /// Share by which the value that 99.73 % of the engines do not exceed becomes smaller, by output.
    pub gains: Vec<f64>,
}

/// A limit, and whether the production keeps it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct LimitVerdict {
    /// On what.
    pub output: Output,
    /// How the production stands to it.
    #[serde(flatten)]
    pub capability: Capability,
    /// Whether the capability by percentiles is the wanted one; without any scatter whether the engine keeps the limit.
    pub is_met: bool,
}

/// Scatter of an engine by the tolerances of its file.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ScatterStudy {
    /// [`SCATTER_STUDY_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Speed of the crankshaft [rad/s].
    pub speed: f64,
    /// Its tolerances.
    pub tolerances: Vec<Tolerance>,
    /// Deviations drawn for each sample, in the order of those of the worst cases.
    pub deviations: Vec<Deviation>,
    /// The samples: percentiles of 0 to 100 % in steps of half a percent, then those of [`TOLD_SHARES`].
    pub scatter: Scatter,
    /// The worst case of each output.
    pub worst_cases: Vec<WorstCase>,
    /// What halving each tolerance alone would do, with the same draws.
    pub tightened: Vec<Tightened>,
    /// Capability that is wanted.
    pub capability: f64,
    /// The limits.
    pub limits: Vec<LimitVerdict>,
}

/// The scatter of `engine` by its tolerances.
///
/// # Errors
/// [`ScatterError`] where the engine has no tolerances or is of a kind whose scatter is not computed, or an option is impossible.
///
/// # Example
/// ```
/// use lanchester_study::scatter::{ScatterOptions, scatter_study};
///
/// let template = lanchester_file::template("in-line-4").expect("it is in the gallery");
/// let text = format!("{}\n[tolerances]\npiston_mass = {{ plus_minus = \"2 g\" }}\n", template.text);
/// let file = lanchester_file::read(&text).file.expect("the gallery has no mistakes");
/// let study = scatter_study(&file.engine, &file.tasks.tolerances, &ScatterOptions { samples: 1000, ..ScatterOptions::default() })?;
/// let first = &study.scatter.outputs[0];
/// // A four in line is free of first order, its production is not.
/// assert!(first.nominal < 1e-9 * first.mean && first.most <= study.worst_cases[0].bound);
/// # Ok::<(), lanchester_study::scatter::ScatterError>(())
/// ```
pub fn scatter_study(
    engine: &Engine,
    tolerances: &[Tolerance],
    options: &ScatterOptions,
) -> Result<ScatterStudy, ScatterError> {
    let scattering = Scattering::new(options.request(engine, tolerances)?)?;
    let tally = scattering.draw_all(0..options.samples)?;
    scatter_study_of(&scattering, &tally, options.capability)?.ok_or(ScatterError::NoSample)
}

impl ScatterOptions {
    /// What is drawn for `engine` with these tolerances.
    ///
    /// # Errors
    /// [`ScatterError`] where a limit is on something that is not reported, or the capability is none.
    pub fn request(&self, engine: &Engine, tolerances: &[Tolerance]) -> Result<ScatterRequest, ScatterError> {
        let outputs = [Output::Force { order: 1 }, Output::Couple { order: 1 }, Output::Force { order: 2 }]
            .into_iter()
            .chain([Output::Couple { order: 2 }]);
        let peaks = [Output::PeakForce, Output::PeakCouple].into_iter().filter(|_| self.peaks);
        let limits = self.limits.iter().map(|limit| {
            let output = output_of(limit.criterion, engine)?;
            match output.is_peak() && !self.peaks {
                true => Err(ScatterError::Criterion {
                    got: criterion_name(&limit.criterion, engine),
                    needed: ORDERS,
                }),
                false => Ok(Limit { output, value: limit.most }),
            }
        });
        let request = ScatterRequest {
            engine: engine.clone(),
            speed: self.speed,
            tolerances: tolerances.to_vec(),
            outputs: outputs.chain(peaks).collect(),
            limits: limits.collect::<Result<_, _>>()?,
            percentiles: (0..=STEPS).map(|k| f64::from(k) / f64::from(STEPS)).chain(TOLD_SHARES).collect(),
            samples: self.samples,
            seed: self.seed,
        };
        if !(self.capability > 0.0 && self.capability.is_finite()) {
            let (quantity, needed) = ("wanted capability", "finite and above 0");
            return Err(ScatterError::Number { quantity, needed, got: self.capability });
        }
        Ok(request)
    }
}

/// The same from the samples of which `tally` is kept, a limit being met with `capability`; `None` of no sample.
///
/// # Errors
/// As [`scatter_study`].
pub fn scatter_study_of(
    scattering: &Scattering,
    tally: &Tally,
    capability: f64,
) -> Result<Option<ScatterStudy>, ScatterError> {
    let Some(found) = scattering.scatter(tally) else { return Ok(None) };
    let request = scattering.request();
    let engine = &request.engine;
    let limits = found.outputs.iter().flat_map(|own| {
        own.capabilities.iter().map(|&reached| {
            let met = reached.cpk_by_percentiles >= capability;
            let is_met = if own.deviation > 0.0 { met } else { own.most <= reached.limit };
            LimitVerdict { output: own.output, capability: reached, is_met }
        })
    });
    Ok(Some(ScatterStudy {
        version: SCATTER_STUDY_VERSION,
        engine: engine.name.clone(),
        speed: request.speed.unwrap_or(engine.speed.highest),
        tolerances: request.tolerances.clone(),
        deviations: scattering.deviations(),
        worst_cases: worst_cases(request)?,
        tightened: tightened(request)?,
        capability,
        limits: limits.collect(),
        scatter: found,
    }))
}

/// Gains of halving each tolerance: the same draws, so that what differs is the tolerance.
fn tightened(request: &ScatterRequest) -> Result<Vec<Tightened>, ScatterError> {
    let rare = |request: ScatterRequest| -> Result<Vec<f64>, ScatterError> {
        let scattering = Scattering::new(request)?;
        let mut values = scattering.values(0..scattering.request().samples.min(MOST_TIGHTENED));
        values.iter_mut().for_each(|own| own.sort_by(f64::total_cmp));
        Ok(values.iter().map(|own| at_share(own, RARE)).collect())
    };
    let now = rare(request.clone())?;
    let halved = |tolerance: usize| {
        let mut request = request.clone();
        request.tolerances[tolerance].half_width /= 2.0;
        let then = rare(request)?;
        let gains = now.iter().zip(then).map(|(now, then)| if *now > 0.0 { 1.0 - then / now } else { 0.0 });
        Ok(Tightened { tolerance, gains: gains.collect() })
    };
    (0..request.tolerances.len()).map(halved).collect()
}

/// What a limit may be on.
const ALL: &str = "`force` and `couple`, or these with `order 1` or `order 2`";
/// What it may be on without peaks.
const ORDERS: &str =
    "`force order 1`, `force order 2`, `couple order 1` and `couple order 2`: peaks are left out";

fn output_of(criterion: Criterion, engine: &Engine) -> Result<Output, ScatterError> {
    match criterion {
        Criterion::Peak(Load::Force) => Ok(Output::PeakForce),
        Criterion::Peak(Load::Couple) => Ok(Output::PeakCouple),
        Criterion::Order(Load::Force, order) if order == 1.0 || order == 2.0 => {
            Ok(Output::Force { order: order as u32 })
        }
        Criterion::Order(Load::Couple, order) if order == 1.0 || order == 2.0 => {
            Ok(Output::Couple { order: order as u32 })
        }
        _ => Err(ScatterError::Criterion { got: criterion_name(&criterion, engine), needed: ALL }),
    }
}
