//! Sums and percentiles that do not depend on the order in which samples come.
//!
//! Sums are kept in whole steps of 2^-40 of the scale, as integers: integer addition is associative, so that any
//! cutting of a run gives the same digits. Percentiles come from the samples themselves while they are few, else
//! from counts in cells whose width is 2^-9 of the value: the middle of a cell errs by at most 0.1 %.

use serde::{Deserialize, Serialize};

/// Bits of the fraction of a cell.
const CELL_BITS: u32 = 9;

/// Octaves below the scale that are told apart, and above it.
const OCTAVES: [u64; 2] = [40, 4];

/// Samples up to which percentiles come from the samples themselves.
pub(crate) const MOST_KEPT: u64 = 100_000;

/// Counts by cell, as far as the highest that has one; written as pairs of a cell and its count.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(into = "Vec<(u64, u64)>", from = "Vec<(u64, u64)>")]
struct Cells(Vec<u64>);

impl Cells {
    /// Cells that there are.
    const MOST: u64 = (OCTAVES[0] + OCTAVES[1]) << CELL_BITS;

    #[inline]
    fn add(&mut self, cell: u64, count: u64) {
        let cell = cell.min(Cells::MOST - 1) as usize;
        if cell >= self.0.len() {
            self.0.resize(cell + 1, 0);
        }
        self.0[cell] += count;
    }
}

impl From<Cells> for Vec<(u64, u64)> {
    fn from(cells: Cells) -> Vec<(u64, u64)> {
        (0..).zip(cells.0).filter(|(_, count)| *count > 0).collect()
    }
}

impl From<Vec<(u64, u64)>> for Cells {
    fn from(pairs: Vec<(u64, u64)>) -> Cells {
        let mut cells = Cells::default();
        pairs.into_iter().for_each(|(cell, count)| cells.add(cell, count));
        cells
    }
}

/// Smallest and largest value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
struct Ends {
    least: f64,
    most: f64,
    /// Sample that has the largest value; the first of them.
    most_at: u64,
}

/// What is known of one output.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub(crate) struct Statistics {
    step: f64,
    lowest_cell: u64,
    count: u64,
    sum: i128,
    squares: i128,
    ends: Option<Ends>,
    cells: Cells,
}

fn cell(value: f64) -> u64 {
    value.to_bits() >> (52 - CELL_BITS)
}

impl Statistics {
    /// For values from 0 to about `scale`.
    pub fn new(scale: f64) -> Statistics {
        let scale = if scale > 0.0 { scale } else { 1.0 };
        Statistics {
            step: scale * 0.5f64.powi(40),
            lowest_cell: cell(scale * 0.5f64.powi(OCTAVES[0] as i32)),
            count: 0,
            sum: 0,
            squares: 0,
            ends: None,
            cells: Cells::default(),
        }
    }

    /// Takes the value of a sample.
    #[inline]
    pub fn add(&mut self, sample: u64, value: f64) {
        self.count += 1;
        let steps = (value / self.step) as i64;
        self.sum += i128::from(steps);
        self.squares += i128::from(steps) * i128::from(steps);
        self.reach(Ends { least: value, most: value, most_at: sample });
        self.cells.add(cell(value).saturating_sub(self.lowest_cell), 1);
    }

    /// Takes the ends of later samples.
    #[inline]
    fn reach(&mut self, other: Ends) {
        let Some(own) = &mut self.ends else {
            self.ends = Some(other);
            return;
        };
        own.least = own.least.min(other.least);
        if other.most > own.most {
            (own.most, own.most_at) = (other.most, other.most_at);
        }
    }

    /// Joins what is known of later samples.
    pub fn merge(&mut self, other: &Statistics) {
        self.count += other.count;
        self.sum += other.sum;
        self.squares += other.squares;
        if let Some(ends) = other.ends {
            self.reach(ends);
        }
        for (cell, count) in other.cells.0.iter().enumerate().filter(|(_, count)| **count > 0) {
            self.cells.add(cell as u64, *count);
        }
    }

    pub fn least(&self) -> f64 {
        self.ends.map_or(f64::NAN, |ends| ends.least)
    }

    pub fn most(&self) -> f64 {
        self.ends.map_or(f64::NAN, |ends| ends.most)
    }

    /// Sample that has the largest value; the first of them.
    pub fn most_at(&self) -> u64 {
        self.ends.map_or(0, |ends| ends.most_at)
    }

    pub fn mean(&self) -> f64 {
        self.sum as f64 / self.count as f64 * self.step
    }

    /// Standard deviation of the population.
    pub fn deviation(&self) -> f64 {
        // About a whole number near the mean, in integers: nothing cancels.
        let count = i128::from(self.count.max(1));
        let near = self.sum / count;
        let centred = self.squares - 2 * near * self.sum + count * near * near;
        let rest = (self.sum - near * count) as f64 / self.count as f64;
        let variance = centred as f64 / self.count as f64 - rest * rest;
        variance.max(0.0).sqrt() * self.step
    }

    /// Value that a share of the samples does not exceed, from the cells.
    pub fn percentile(&self, share: f64) -> f64 {
        let rank = rank(share, self.count);
        let mut below = 0;
        for (place, count) in self.cells.0.iter().enumerate() {
            below += count;
            if below >= rank {
                let bits = |cell: u64| f64::from_bits(cell << (52 - CELL_BITS));
                let at = self.lowest_cell + place as u64;
                let value = if place == 0 { 0.0 } else { 0.5 * (bits(at) + bits(at + 1)) };
                return value.clamp(self.least(), self.most());
            }
        }
        self.most()
    }
}

/// Place, from 1, of the sample that a share of `count` rising samples does not exceed.
fn rank(share: f64, count: u64) -> u64 {
    ((share * count as f64).ceil() as u64).clamp(1, count.max(1))
}

/// Value that a share of rising values does not exceed.
pub(crate) fn at_share(rising: &[f64], share: f64) -> f64 {
    rising[rank(share, rising.len() as u64) as usize - 1]
}
