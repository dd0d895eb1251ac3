//! Samples drawn and judged, eight at a time.

use crate::scatter::error::ScatterError;
use crate::scatter::model::Model;
use crate::scatter::peak::PeakGrid;
use crate::scatter::request::{Output, ScatterRequest};
use crate::scatter::spectrum::Spectrum;
use crate::scatter::stream::{Shape, Stream};
use crate::scatter::tolerance::{Variable, variables};
use lanchester_numerics::Lanes;

/// Draws, prepared.
pub(crate) struct Sampler {
    pub model: Model,
    pub variables: Vec<Variable>,
    pub draws: Vec<(Shape, Stream, f64)>,
    peaks: bool,
    outputs: Vec<Output>,
}

/// Buffers of one thread.
pub(crate) struct Buffers {
    /// Deviations of the samples that were drawn last.
    pub deviations: Vec<Lanes>,
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
            deviations: vec![Lanes::ZERO; self.variables.len()],
            spectrum: Spectrum::default(),
            grid: self.peaks.then(|| PeakGrid::new(&self.model.orders)),
        }
    }

    /// Outputs of the samples `first` to `first + 7`.
    pub fn samples(&self, first: u64, buffers: &mut Buffers, values: &mut [Lanes]) {
        for (deviation, (shape, stream, half)) in buffers.deviations.iter_mut().zip(&self.draws) {
            let draw = shape.draw(*stream, first);
            *deviation = Lanes::each(|i| draw[i] * half);
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
                Lanes::each(|i| (c.re[i] * c.re[i] + c.im[i] * c.im[i]).sqrt())
            };
            // Orders 1 and 2 are always the first two.
            *value = match *output {
                Output::Force { order } | Output::Couple { order } => {
                    let place = order as usize - 1;
                    let (forward, backward) = (size(place, 0), size(place, 1));
                    Lanes::each(|i| forward[i] + backward[i])
                }
                Output::ForceSense { order, sense } | Output::CoupleSense { order, sense } => {
                    size(order as usize - 1, sense as usize)
                }
                Output::PeakForce | Output::PeakCouple => {
                    grid.as_mut().map_or(Lanes::ZERO, |grid| grid.peaks(quantity))
                }
            };
        }
    }

    /// Outputs of the nominal engine.
    pub fn nominal(&self) -> Vec<f64> {
        let mut values = vec![Lanes::ZERO; self.outputs.len()];
        let zero = vec![Lanes::ZERO; self.variables.len()];
        self.outputs_of(&zero, &mut self.buffers(), &mut values);
        values.iter().map(|lanes| lanes[0]).collect()
    }

    /// What values of an output are about, at most.
    pub fn scale(&self, output: Output) -> f64 {
        let [force, couple] = self.model.scale();
        if output.is_couple() { couple } else { force }
    }
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
