//! A scatter as a study in blocks, with the samples as rows.

use crate::run::Study;
use lanchester_report::measure_unit;
use lanchester_study::scatter::{Deviation, Drawn, Output, ScatterError, ScatterOptions, Scattering, Tally};
use lanchester_study::sensitivity::Quantity;
use lanchester_table::{Column, Rows, Values};
use lanchester_task::{Limit, Tolerance};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Samples of a block.
const BLOCK: u64 = 1 << 14;

/// The request of a scatter as its table keeps it: the options of the run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SavedScatter {
    /// Speed of the crankshaft [rad/s]; the highest of the engine where it is not given.
    pub speed: Option<f64>,
    /// Engines that are drawn.
    pub samples: u64,
    /// Seed of the draws.
    pub seed: u64,
    /// Whether orders 1 and 2 alone are drawn, without the peaks over all orders.
    pub orders_only: bool,
    /// Limits as they were written.
    pub limits: Vec<String>,
    /// Capability with which a limit is met.
    pub capability: f64,
}

impl SavedScatter {
    /// The options of the run with its limits as they were read.
    pub fn options(&self, limits: Vec<Limit>) -> ScatterOptions {
        ScatterOptions {
            speed: self.speed,
            samples: self.samples,
            seed: self.seed,
            peaks: !self.orders_only,
            limits,
            capability: self.capability,
        }
    }
}

/// A scatter, cut into blocks of samples.
pub struct SampleStudy {
    /// The scatter.
    pub scattering: Scattering,
    /// Whether every sample is a row, with its deviations and its loads.
    pub keeps_samples: bool,
}

impl SampleStudy {
    fn samples(&self, blocks: Range<u64>) -> Range<u64> {
        let at = |block: u64| block.saturating_mul(BLOCK).min(self.scattering.request().samples);
        at(blocks.start)..at(blocks.end)
    }

    /// The tolerance of a deviation.
    fn tolerance(&self, deviation: &Deviation) -> &Tolerance {
        &self.scattering.request().tolerances[deviation.tolerance]
    }
}

impl Study for SampleStudy {
    type Kept = Tally;
    type Error = ScatterError;

    fn blocks(&self) -> u64 {
        self.scattering.request().samples.div_ceil(BLOCK)
    }

    fn cases(&self, blocks: Range<u64>) -> u128 {
        let samples = self.samples(blocks);
        u128::from(samples.end - samples.start)
    }

    fn columns(&self) -> Vec<Column> {
        let deviation = |own: &Deviation| {
            let quantity = self.tolerance(own).quantity;
            let part = own.part.map_or_else(|| "all".to_owned(), |part| (part + 1).to_string());
            let (_, unit) = measure_unit(Quantity::Part(quantity).measure());
            Column::real(column_name(&[quantity.name(), &part], unit))
        };
        let output =
            |own: &Output| Column::real(column_name(&[&own.name().replace(" of ", " ")], own.unit()));
        let deviations = self.scattering.deviations();
        let outputs = &self.scattering.request().outputs;
        std::iter::once(Column::whole("sample"))
            .chain(deviations.iter().map(deviation))
            .chain(outputs.iter().map(output))
            .collect()
    }

    fn nothing(&self) -> Tally {
        self.scattering.start()
    }

    fn block(&self, number: u64) -> Result<(Tally, Rows), ScatterError> {
        let samples = self.samples(number..number + 1);
        if !self.keeps_samples {
            return Ok((self.scattering.draw(samples, None), Rows::empty(&self.columns())));
        }
        let mut drawn = Drawn::default();
        let tally = self.scattering.draw(samples.clone(), Some(&mut drawn));
        let mut columns = vec![Values::Whole(samples.map(|sample| sample as i64).collect())];
        for (own, mut values) in self.scattering.deviations().iter().zip(drawn.deviations) {
            let (factor, _) = measure_unit(Quantity::Part(self.tolerance(own).quantity).measure());
            values.iter_mut().for_each(|value| *value *= factor);
            columns.push(Values::Real(values));
        }
        columns.extend(drawn.outputs.into_iter().map(Values::Real));
        Ok((tally, Rows::of(columns)))
    }

    fn join(&self, one: Tally, next: Tally) -> Result<Tally, ScatterError> {
        self.scattering.join(one, next)
    }

    fn last_rows(&self, _: &Tally) -> Result<Option<Rows>, ScatterError> {
        Ok(None)
    }
}

/// Name of a column: letters, digits and underscores, its unit at the end.
fn column_name(words: &[&str], unit: &str) -> String {
    format!("{}_{}", words.join("_").replace([' ', '-'], "_"), unit.replace(' ', ""))
}
