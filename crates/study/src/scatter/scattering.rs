//! A scatter in stretches of samples: drawn in any order and on any computer, joined to the same whole.

use crate::scatter::deviated::deviated;
use crate::scatter::error::ScatterError;
use crate::scatter::request::{Output, ScatterRequest};
use crate::scatter::result::{Capability, Deviation, OutputScatter, Percentile, SCATTER_VERSION, Scatter};
use crate::scatter::sampler::Sampler;
use crate::scatter::share::{SHARED, shares};
use crate::scatter::statistics::{MOST_KEPT, Statistics, at_share};
use lanchester_model::{Engine, Fault};
use lanchester_numerics::{LANES, Lanes};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Samples that one thread takes in one go.
const STRETCH: u64 = 1 << 14;

/// A scatter, prepared.
///
/// ```
/// use lanchester_task::{Distribution, Extent, Tolerance, Varied};
/// use lanchester_study::scatter::{Output, ScatterRequest, Scattering, scatter};
///
/// let template = lanchester_file::template("in-line-4").expect("it is in the gallery");
/// let tolerance = Tolerance {
///     quantity: Varied::PistonMass,
///     half_width: 0.002,
///     distribution: Distribution::Uniform,
///     extent: Extent::PerPart,
/// };
/// let request = ScatterRequest {
///     engine: lanchester_file::read(template.text).engine().expect("the gallery has no mistakes"),
///     speed: None,
///     tolerances: vec![tolerance],
///     outputs: vec![Output::Force { order: 1 }],
///     limits: Vec::new(),
///     percentiles: vec![0.95],
///     samples: 3000,
///     seed: 1,
/// };
/// let scattering = Scattering::new(request.clone())?;
/// // Two stretches, the second of them drawn first.
/// let second = scattering.draw(1600..3000, None);
/// let whole = scattering.join(scattering.draw(0..1600, None), second)?;
/// assert_eq!(scattering.scatter(&whole), Some(scatter(&request)?));
/// # Ok::<(), lanchester_study::scatter::ScatterError>(())
/// ```
pub struct Scattering {
    request: ScatterRequest,
    sampler: Sampler,
    /// Limits: place of the output, value.
    limits: Vec<(usize, f64)>,
}

/// What is kept of a stretch of samples: sums and counts, whose size does not grow with it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Tally {
    /// First sample, and the one behind the last.
    from: u64,
    to: u64,
    statistics: Vec<Statistics>,
    /// Samples beyond each limit.
    beyond: Vec<u64>,
}

/// Samples with all that was drawn and judged, in SI units.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawn {
    /// Number of the first sample; the others follow it.
    pub first: u64,
    /// By deviation, in the order of [`Scattering::deviations`], then by sample.
    pub deviations: Vec<Vec<f64>>,
    /// By output, in the order of the request, then by sample.
    pub outputs: Vec<Vec<f64>>,
}

impl Scattering {
    /// Prepares a scatter.
    ///
    /// # Errors
    /// As [`crate::scatter::scatter`].
    pub fn new(request: ScatterRequest) -> Result<Scattering, ScatterError> {
        let sampler = Sampler::new(&request)?;
        let place = |output: Output| request.outputs.iter().position(|own| *own == output);
        let limits = request
            .limits
            .iter()
            .filter_map(|limit| place(limit.output).map(|place| (place, limit.value)))
            .collect();
        Ok(Scattering { request, sampler, limits })
    }

    /// What is asked for.
    pub fn request(&self) -> &ScatterRequest {
        &self.request
    }

    /// What is drawn for each sample.
    pub fn deviations(&self) -> Vec<Deviation> {
        let variables = self.sampler.variables.iter();
        variables.map(|own| Deviation { tolerance: own.tolerance, part: own.part }).collect()
    }

    /// The samples of a stretch as engines, each with its deviations.
    ///
    /// # Errors
    /// [`ScatterError::Sample`] where a tolerance is so wide that no engine has what is drawn.
    pub fn engines(&self, samples: Range<u64>) -> Result<Vec<Engine>, ScatterError> {
        let mut drawn = Drawn::default();
        let count = (samples.end.max(samples.start) - samples.start) as usize;
        self.draw(samples, Some(&mut drawn));
        let one = |sample: usize| {
            let deviations: Vec<f64> = drawn.deviations.iter().map(|of_all| of_all[sample]).collect();
            deviated(&self.request.engine, &self.request.tolerances, &self.sampler.variables, &deviations)
                .map_err(|faults| ScatterError::Sample(Fault::first_of(faults)))
        };
        (0..count).map(one).collect()
    }

    /// What is kept of no sample.
    pub fn start(&self) -> Tally {
        let statistics = |output: &Output| Statistics::new(self.sampler.scale(*output));
        Tally {
            from: 0,
            to: 0,
            statistics: self.request.outputs.iter().map(statistics).collect(),
            beyond: vec![0; self.limits.len()],
        }
    }

    /// Draws the samples of a stretch; each of them goes into `drawn` too, if there is one.
    pub fn draw(&self, samples: Range<u64>, mut drawn: Option<&mut Drawn>) -> Tally {
        let mut found = Tally { from: samples.start, to: samples.end.max(samples.start), ..self.start() };
        if let Some(drawn) = drawn.as_deref_mut() {
            *drawn = Drawn {
                first: samples.start,
                deviations: vec![Vec::new(); self.sampler.variables.len()],
                outputs: vec![Vec::new(); self.request.outputs.len()],
            };
        }
        let mut buffers = self.sampler.buffers();
        let mut values = vec![Lanes::ZERO; self.request.outputs.len()];
        let mut first = samples.start;
        while first < samples.end {
            self.sampler.samples(first, &mut buffers, &mut values);
            let count = (samples.end - first).min(LANES as u64) as usize;
            for lane in 0..count {
                for (own, lanes) in found.statistics.iter_mut().zip(&values) {
                    own.add(first + lane as u64, lanes[lane]);
                }
                for (beyond, &(place, limit)) in found.beyond.iter_mut().zip(&self.limits) {
                    *beyond += u64::from(values[place][lane] > limit);
                }
            }
            if let Some(drawn) = drawn.as_deref_mut() {
                let own = drawn.deviations.iter_mut().zip(&buffers.deviations);
                for (column, lanes) in own.chain(drawn.outputs.iter_mut().zip(&values)) {
                    column.extend_from_slice(&lanes.0[..count]);
                }
            }
            first += count as u64;
        }
        found
    }

    /// Draws samples on all threads of the current pool.
    ///
    /// # Errors
    /// None that samples of one scatter could cause.
    pub fn draw_all(&self, samples: Range<u64>) -> Result<Tally, ScatterError> {
        stretches(&samples)
            .map(|own| self.draw(own, None))
            .map(Ok)
            .reduce(|| Ok(self.start()), |one, next| self.join(one?, next?))
    }

    /// Joins what is kept of a stretch and of the next one; in any cutting the whole is the same.
    ///
    /// # Errors
    /// [`ScatterError::NotJoined`] where one is not of this scatter, or does not follow the other.
    pub fn join(&self, mut one: Tally, next: Tally) -> Result<Tally, ScatterError> {
        if next.from == next.to {
            return Ok(one);
        }
        if one.from == one.to {
            return Ok(next);
        }
        let alike = |own: &Tally| {
            own.statistics.len() == self.request.outputs.len() && own.beyond.len() == self.limits.len()
        };
        if one.to != next.from || !alike(&one) || !alike(&next) {
            return Err(ScatterError::NotJoined { to: one.to, from: next.from });
        }
        one.to = next.to;
        for (own, other) in one.statistics.iter_mut().zip(&next.statistics) {
            own.merge(other);
        }
        for (own, other) in one.beyond.iter_mut().zip(&next.beyond) {
            *own += other;
        }
        Ok(one)
    }

    /// Outputs of samples: by output, then by sample.
    pub(crate) fn values(&self, samples: Range<u64>) -> Vec<Vec<f64>> {
        let of_stretch = |own: Range<u64>| {
            let mut drawn = Drawn::default();
            self.draw(own, Some(&mut drawn));
            drawn.outputs
        };
        let all: Vec<Vec<Vec<f64>>> = stretches(&samples).map(of_stretch).collect();
        let one = |place: usize| all.iter().flat_map(|stretch| stretch[place].iter().copied()).collect();
        (0..self.request.outputs.len()).map(one).collect()
    }

    /// The scatter of the samples of which `tally` is kept; `None` of no sample.
    ///
    /// Few samples are drawn once more, for their percentiles and for the shares: what is kept of them is as small as of many.
    pub fn scatter(&self, tally: &Tally) -> Option<Scatter> {
        let Tally { from, to, .. } = *tally;
        let count = to - from;
        if count == 0 || tally.statistics.len() != self.request.outputs.len() {
            return None;
        }
        let are_few = count <= MOST_KEPT;
        let again = if are_few { count } else { SHARED };
        let mut values = self.values(from..from + again);
        let shared: Vec<Vec<f64>> =
            values.iter().map(|own| own[..own.len().min(SHARED as usize)].to_vec()).collect();
        let shares = shares(&self.request, &self.sampler, from, &shared);
        values.iter_mut().for_each(|own| own.sort_by(f64::total_cmp));
        let nominal = self.sampler.nominal();
        let outputs = self.request.outputs.iter().enumerate().map(|(place, &output)| {
            let own = &tally.statistics[place];
            let percentile =
                |share: f64| if are_few { at_share(&values[place], share) } else { own.percentile(share) };
            let percentiles = self.request.percentiles.iter();
            OutputScatter {
                output,
                nominal: nominal[place],
                mean: own.mean(),
                deviation: own.deviation(),
                least: own.least(),
                most: own.most(),
                most_sample: own.most_at(),
                percentiles: percentiles
                    .map(|&share| Percentile { share, value: percentile(share) })
                    .collect(),
                percentile_error: if are_few { 0.0 } else { 0.5f64.powi(10) },
                capabilities: self.capabilities(tally, place, &percentile),
                contributions: shares[place].clone(),
            }
        });
        Some(Scatter {
            version: SCATTER_VERSION,
            samples: count,
            seed: self.request.seed,
            variables: self.sampler.variables.len(),
            outputs: outputs.collect(),
        })
    }

    /// How the output at `place` stands to its limits.
    fn capabilities(&self, tally: &Tally, place: usize, percentile: &impl Fn(f64) -> f64) -> Vec<Capability> {
        let own = &tally.statistics[place];
        let limits = self.limits.iter().zip(&tally.beyond).filter(|((output, _), _)| *output == place);
        limits
            .map(|(&(_, limit), &beyond)| {
                let (median, far) = (percentile(0.5), percentile(0.99865));
                Capability {
                    limit,
                    cpk: (limit - own.mean()) / (3.0 * own.deviation()),
                    cpk_by_percentiles: (limit - median) / (far - median),
                    beyond,
                }
            })
            .collect()
    }
}

/// The samples in stretches, one for a thread at a time.
fn stretches(samples: &Range<u64>) -> impl IndexedParallelIterator<Item = Range<u64>> + use<> {
    let Range { start, end } = *samples;
    let count = end.saturating_sub(start).div_ceil(STRETCH) as usize;
    (0..count).into_par_iter().map(move |k| {
        let from = start + k as u64 * STRETCH;
        from..end.min(from + STRETCH)
    })
}

/// Scatter of the outputs over samples of the engine.
///
/// Sample `k` depends on seed and `k` alone, and sums do not depend on their order: the result is the same for any number
/// of threads. [`Scattering`] draws the same samples stretch by stretch.
///
/// # Errors
/// [`ScatterError`] where the request is impossible or the engine is of a kind that is not computed.
pub fn scatter(request: &ScatterRequest) -> Result<Scatter, ScatterError> {
    let scattering = Scattering::new(request.clone())?;
    let tally = scattering.draw_all(0..request.samples)?;
    scattering.scatter(&tally).ok_or(ScatterError::NoSample)
}
