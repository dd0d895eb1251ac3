//! The scatter of residual loads: samples drawn, judged and counted.

use crate::explore::Sense;
use crate::scatter::error::ScatterError;
use crate::scatter::lanes::{Lanes, WIDTH, ZERO, map};
use crate::scatter::model::{Model, Spectrum};
use crate::scatter::peak::PeakGrid;
use crate::scatter::statistics::{MOST_KEPT, Statistics};
use crate::scatter::stream::{Shape, Stream};
use crate::scatter::tolerance::{Variable, variables};
use lanchester_model::{Engine, Tolerance};
use rayon::prelude::*;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const SCATTER_VERSION: u32 = 1;

/// Samples that one thread takes in one go.
const STRETCH: u64 = 1 << 14;

/// Most samples from which shares of the variance are estimated.
const SHARED: u64 = 1 << 16;

/// Cells of each variable for these shares, of so many samples each: what varies within a cell is lost, with 128 cells
/// less than half a percent of a share.
const MOST_CELLS: usize = 128;
const PER_CELL: usize = 64;

/// A residual load whose scatter is asked for: a size, 0 being best.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Output {
    /// Largest resultant of the force of order 1 or 2 [N].
    Force {
        /// Order.
        order: u32,
    },
    /// Largest resultant of the couple of order 1 or 2 about the origin [N m].
    Couple {
        /// Order.
        order: u32,
    },
    /// Part of the force of order 1 or 2 that turns in one sense [N].
    ForceSense {
        /// Order.
        order: u32,
        /// Sense.
        sense: Sense,
    },
    /// Part of the couple of order 1 or 2 that turns in one sense [N m].
    CoupleSense {
        /// Order.
        order: u32,
        /// Sense.
        sense: Sense,
    },
    /// Largest resultant force of all orders, over the continuous crank angle [N].
    PeakForce,
    /// Largest resultant couple of all orders, over the continuous crank angle [N m].
    PeakCouple,
}

impl Output {
    /// Name for tables.
    pub fn name(self) -> String {
        match self {
            Output::Force { order } => format!("force of order {order}"),
            Output::Couple { order } => format!("couple of order {order}"),
            Output::ForceSense { order, sense } => format!("{} force of order {order}", sense.name()),
            Output::CoupleSense { order, sense } => format!("{} couple of order {order}", sense.name()),
            Output::PeakForce => "peak force".to_string(),
            Output::PeakCouple => "peak couple".to_string(),
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        if self.is_couple() { "N m" } else { "N" }
    }

    pub(crate) fn is_couple(self) -> bool {
        matches!(self, Output::Couple { .. } | Output::CoupleSense { .. } | Output::PeakCouple)
    }

    pub(crate) fn is_peak(self) -> bool {
        matches!(self, Output::PeakForce | Output::PeakCouple)
    }

    pub(crate) fn order(self) -> Option<u32> {
        match self {
            Output::Force { order }
            | Output::Couple { order }
            | Output::ForceSense { order, .. }
            | Output::CoupleSense { order, .. } => Some(order),
            Output::PeakForce | Output::PeakCouple => None,
        }
    }
}

/// A limit that an output should keep.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Limit {
    /// Which output.
    pub output: Output,
    /// Largest value that is good, in its unit.
    pub value: f64,
}

/// What to draw and what to tell.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ScatterRequest {
    /// The nominal engine: one crankshaft, plain rods.
    pub engine: Engine,
    /// Speed of the crankshaft [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// What varies.
    pub tolerances: Vec<Tolerance>,
    /// What is asked for.
    pub outputs: Vec<Output>,
    /// Limits on outputs that are asked for.
    pub limits: Vec<Limit>,
    /// Shares of the samples, from 0 to 1, whose largest values are told.
    pub percentiles: Vec<f64>,
    /// Number of samples.
    pub samples: u64,
    /// Seed of the draws: the same seed draws the same samples, the first of them the same whatever their number.
    pub seed: u64,
}

/// Scatter of all outputs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Scatter {
    /// [`SCATTER_VERSION`].
    pub version: u32,
    /// Samples drawn.
    pub samples: u64,
    /// Seed.
    pub seed: u64,
    /// Deviations drawn for each sample.
    pub variables: usize,
    /// By output, in the order of the request.
    pub outputs: Vec<OutputScatter>,
}

/// Scatter of one output.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OutputScatter {
    /// Which.
    pub output: Output,
    /// Of the nominal engine.
    pub nominal: f64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Smallest of the samples.
    pub least: f64,
    /// Largest of the samples.
    pub most: f64,
    /// Number of the sample that has it, from 0.
    pub most_sample: u64,
    /// Percentiles in the order of the request.
    pub percentiles: Vec<Percentile>,
    /// Largest relative error of the percentiles: 0 where all samples were kept.
    pub percentile_error: f64,
    /// Against its limits, in the order of the request.
    pub capabilities: Vec<Capability>,
    /// Which tolerance the scatter comes from, in the order of the request.
    pub contributions: Vec<Contribution>,
}

/// A percentile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Percentile {
    /// Share of the samples, from 0 to 1.
    pub share: f64,
    /// What this share does not exceed.
    pub value: f64,
}

/// How an output stands to a limit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Capability {
    /// The limit.
    pub limit: f64,
    /// `(limit - mean) / (3 standard deviations)`: for a normal distribution.
    pub cpk: f64,
    /// `(limit - median) / (99.865 % percentile - median)`: for any distribution (ISO 22514-2).
    pub cpk_by_percentiles: f64,
    /// Samples beyond the limit.
    pub beyond: u64,
}

/// What one tolerance adds to the scatter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Contribution {
    /// Place of the tolerance in the request, from 0.
    pub tolerance: usize,
    /// First-order index: share of the output's variance that would vanish if the deviations of this tolerance, one at a
    /// time, were known. Shares sum to 1 less what only several together do.
    pub share: f64,
    /// Its standard error: what other samples of the same number would change, about.
    pub error: f64,
}

/// Draws, prepared.
pub(crate) struct Sampler {
    pub model: Model,
    pub variables: Vec<Variable>,
    draws: Vec<(Shape, Stream, f64)>,
    peaks: bool,
    outputs: Vec<Output>,
}

/// Buffers of one thread.
pub(crate) struct Buffers {
    deviations: Vec<Lanes>,
    spectrum: Spectrum,
    grid: Option<PeakGrid>,
}

impl Sampler {
    pub fn new(request: &ScatterRequest) -> Result<Sampler, ScatterError> {
        check(request)?;
        let variables = variables(&request.engine, &request.tolerances)?;
        let peaks = request.outputs.iter().any(|output| output.is_peak());
        let model = Model::new(&request.engine, request.speed, &request.tolerances, &variables, peaks)?;
        let draws = variables
            .iter()
            .enumerate()
            .map(|(place, v)| (Shape::of(v.distribution), Stream::new(request.seed, place), v.half_width))
            .collect();
        Ok(Sampler { model, variables, draws, peaks, outputs: request.outputs.clone() })
    }

    pub fn buffers(&self) -> Buffers {
        Buffers {
            deviations: vec![ZERO; self.variables.len()],
            spectrum: Spectrum::default(),
            grid: self.peaks.then(|| PeakGrid::new(&self.model.orders)),
        }
    }

    /// Outputs of the samples `first` to `first + 7`.
    fn samples(&self, first: u64, buffers: &mut Buffers, values: &mut [Lanes]) {
        for (deviation, (shape, stream, half)) in buffers.deviations.iter_mut().zip(&self.draws) {
            let draw = shape.draw(*stream, first);
            *deviation = map(|i| draw[i] * half);
        }
        let deviations = std::mem::take(&mut buffers.deviations);
        self.outputs_of(&deviations, buffers, values);
        buffers.deviations = deviations;
    }

    /// Outputs of eight engines with these deviations.
    pub fn outputs_of(&self, deviations: &[Lanes], buffers: &mut Buffers, values: &mut [Lanes]) {
        let Buffers { spectrum, grid, .. } = buffers;
        self.model.spectrum(deviations, spectrum);
        for (value, output) in values.iter_mut().zip(&self.outputs) {
            let quantity = if output.is_couple() { &spectrum.couple } else { &spectrum.force };
            let size = |place: usize, sense: usize| {
                let c = &quantity[place][sense];
                map(|i| (c.re[i] * c.re[i] + c.im[i] * c.im[i]).sqrt())
            };
            // Orders 1 and 2 are always the first two.
            *value = match *output {
                Output::Force { order } | Output::Couple { order } => {
                    let place = order as usize - 1;
                    let (forward, backward) = (size(place, 0), size(place, 1));
                    map(|i| forward[i] + backward[i])
                }
                Output::ForceSense { order, sense } | Output::CoupleSense { order, sense } => {
                    size(order as usize - 1, sense as usize)
                }
                Output::PeakForce | Output::PeakCouple => {
                    grid.as_mut().map_or(ZERO, |grid| grid.peaks(quantity))
                }
            };
        }
    }

    /// Outputs of the nominal engine.
    pub fn nominal(&self) -> Vec<f64> {
        let mut values = vec![ZERO; self.outputs.len()];
        let zero = vec![ZERO; self.variables.len()];
        self.outputs_of(&zero, &mut self.buffers(), &mut values);
        values.iter().map(|lanes| lanes[0]).collect()
    }

    fn scale(&self, output: Output) -> f64 {
        let [force, couple] = self.model.scale();
        if output.is_couple() { couple } else { force }
    }
}

/// What one stretch of samples gives.
struct Stretch {
    statistics: Vec<Statistics>,
    /// Samples beyond each limit.
    beyond: Vec<u64>,
    /// Outputs of the samples from which shares are estimated, output by output.
    values: Vec<Vec<f64>>,
}

/// Scatter of the outputs over samples of the engine.
///
/// Sample `k` depends on seed and `k` alone, and sums do not depend on their order: the result is the same for any number
/// of threads.
///
/// # Errors
/// [`ScatterError`] where the request is impossible or the engine is of a kind that is not computed.
pub fn scatter(request: &ScatterRequest) -> Result<Scatter, ScatterError> {
    let sampler = Sampler::new(request)?;
    let stretches: Vec<Stretch> = (0..request.samples.div_ceil(STRETCH))
        .into_par_iter()
        .map(|k| stretch(request, &sampler, k * STRETCH, request.samples.min((k + 1) * STRETCH)))
        .collect();
    let mut whole = empty(request, &sampler);
    for stretch in &stretches {
        for (own, other) in whole.statistics.iter_mut().zip(&stretch.statistics) {
            own.merge(other);
        }
        for (own, other) in whole.beyond.iter_mut().zip(&stretch.beyond) {
            *own += other;
        }
        for (own, other) in whole.values.iter_mut().zip(&stretch.values) {
            own.extend(other);
        }
    }
    whole.statistics.iter_mut().for_each(Statistics::finish);
    let shares = shares(request, &sampler, &whole.values);
    let nominal = sampler.nominal();
    let error = if request.samples > MOST_KEPT { 0.5f64.powi(10) } else { 0.0 };
    let outputs = request.outputs.iter().enumerate().map(|(place, &output)| {
        let own = &whole.statistics[place];
        OutputScatter {
            output,
            nominal: nominal[place],
            mean: own.mean(),
            deviation: own.deviation(),
            least: own.least,
            most: own.most,
            most_sample: own.most_at,
            percentiles: request
                .percentiles
                .iter()
                .map(|&share| Percentile { share, value: own.percentile(share) })
                .collect(),
            percentile_error: error,
            capabilities: capabilities(request, output, own, &whole.beyond),
            contributions: shares[place].clone(),
        }
    });
    Ok(Scatter {
        version: SCATTER_VERSION,
        samples: request.samples,
        seed: request.seed,
        variables: sampler.variables.len(),
        outputs: outputs.collect(),
    })
}

fn empty(request: &ScatterRequest, sampler: &Sampler) -> Stretch {
    let statistics = |output: &Output| Statistics::new(sampler.scale(*output), request.samples);
    Stretch {
        statistics: request.outputs.iter().map(statistics).collect(),
        beyond: vec![0; request.limits.len()],
        values: vec![Vec::new(); request.outputs.len()],
    }
}

fn stretch(request: &ScatterRequest, sampler: &Sampler, from: u64, to: u64) -> Stretch {
    let mut found = empty(request, sampler);
    let mut buffers = sampler.buffers();
    let mut values = vec![ZERO; request.outputs.len()];
    let limits: Vec<(usize, f64)> = request
        .limits
        .iter()
        .map(|limit| (request.outputs.iter().position(|o| *o == limit.output).unwrap_or(0), limit.value))
        .collect();
    let mut first = from;
    while first < to {
        sampler.samples(first, &mut buffers, &mut values);
        let count = (to - first).min(WIDTH as u64);
        for lane in 0..count {
            let sample = first + lane;
            for (place, lanes) in values.iter().enumerate() {
                let value = lanes[lane as usize];
                found.statistics[place].add(sample, value);
                if sample < SHARED {
                    found.values[place].push(value);
                }
            }
            for (beyond, &(place, limit)) in found.beyond.iter_mut().zip(&limits) {
                *beyond += u64::from(values[place][lane as usize] > limit);
            }
        }
        first += count;
    }
    found
}

/// Cells of each variable with so many samples.
fn cells(samples: usize) -> usize {
    (samples / PER_CELL).clamp(2, MOST_CELLS)
}

/// First-order shares of the variance, by output, then tolerance.
///
/// The samples fall into cells of equal probability by each variable; the variance of the cells' means, less what chance
/// alone would give, is the variable's (correlation ratio).
fn shares(request: &ScatterRequest, sampler: &Sampler, values: &[Vec<f64>]) -> Vec<Vec<Contribution>> {
    let count = values.first().map_or(0, Vec::len);
    let cell_count = cells(count);
    let means: Vec<f64> = values.iter().map(|v| v.iter().sum::<f64>() / count as f64).collect();
    let totals: Vec<f64> =
        values.iter().zip(&means).map(|(v, mean)| v.iter().map(|x| (x - mean).powi(2)).sum()).collect();
    let by_variable: Vec<Vec<f64>> = sampler
        .draws
        .par_iter()
        .map(|(_, stream, _)| {
            let mut sums = vec![vec![0.0; cell_count]; values.len()];
            let mut counts = vec![0u32; cell_count];
            for sample in 0..count {
                let cell = (stream.uniform(sample as u64) * cell_count as f64) as usize;
                counts[cell] += 1;
                for (sum, value) in sums.iter_mut().zip(values) {
                    sum[cell] += value[sample];
                }
            }
            let share = |place: usize| {
                if totals[place] <= 0.0 || count <= cell_count {
                    return 0.0;
                }
                let cells = sums[place].iter().zip(&counts).filter(|(_, n)| **n > 0);
                let between: f64 =
                    cells.map(|(sum, n)| (sum / f64::from(*n) - means[place]).powi(2) * f64::from(*n)).sum();
                let within = (totals[place] - between) / (count - cell_count) as f64;
                (between - (cell_count - 1) as f64 * within) / totals[place]
            };
            (0..values.len()).map(share).collect()
        })
        .collect();
    (0..values.len())
        .map(|place| {
            let blank = |tolerance| Contribution { tolerance, share: 0.0, error: 0.0 };
            let mut shares: Vec<Contribution> = (0..request.tolerances.len()).map(blank).collect();
            for (variable, own) in sampler.variables.iter().zip(&by_variable) {
                let (share, samples) = (own[place], count as f64);
                let sum = &mut shares[variable.tolerance];
                sum.share += share;
                // Of a squared correlation, and of what chance gives to cells.
                sum.error += 4.0 * share.max(0.0) * (1.0 - share).powi(2) / samples
                    + 2.0 * (cell_count - 1) as f64 / (samples * samples);
            }
            shares.iter_mut().for_each(|share| share.error = share.error.sqrt());
            shares
        })
        .collect()
}

fn capabilities(
    request: &ScatterRequest,
    output: Output,
    statistics: &Statistics,
    beyond: &[u64],
) -> Vec<Capability> {
    let limits = request.limits.iter().zip(beyond).filter(|(limit, _)| limit.output == output);
    limits
        .map(|(limit, &beyond)| {
            let (median, far) = (statistics.percentile(0.5), statistics.percentile(0.99865));
            Capability {
                limit: limit.value,
                cpk: (limit.value - statistics.mean()) / (3.0 * statistics.deviation()),
                cpk_by_percentiles: (limit.value - median) / (far - median),
                beyond,
            }
        })
        .collect()
}

fn check(request: &ScatterRequest) -> Result<(), ScatterError> {
    let number = |quantity, needed, got| Err(ScatterError::Number { quantity, needed, got });
    if request.outputs.is_empty() {
        return Err(ScatterError::NoOutput);
    }
    if !(1..=1_000_000_000).contains(&request.samples) {
        return number("number of samples", "from 1 to 1e9", request.samples as f64);
    }
    if let Some(&got) = request.percentiles.iter().find(|share| !(0.0..=1.0).contains(*share)) {
        return number("share of a percentile", "from 0 to 1", got);
    }
    if let Some(order) = request.outputs.iter().filter_map(|o| o.order()).find(|n| !(1..=2).contains(n)) {
        return number("order of an output", "1 or 2", f64::from(order));
    }
    for (place, limit) in request.limits.iter().enumerate() {
        if !request.outputs.contains(&limit.output) {
            let output = limit.output.name();
            return Err(ScatterError::LimitWithoutOutput { place: place + 1, output });
        }
        if !(limit.value >= 0.0 && limit.value.is_finite()) {
            return number("limit", "finite and not negative", limit.value);
        }
    }
    Ok(())
}
