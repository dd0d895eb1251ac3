//! Sums and percentiles that do not depend on the order in which samples come.
//!
//! Sums are kept in whole steps of 2^-40 of the scale, as integers: integer addition is associative, so that any
//! cutting of a run gives the same digits. Percentiles come from the samples themselves while they are few, else
//! from counts in cells whose width is 2^-9 of the value: the middle of a cell errs by at most 0.1 %.

/// Bits of the fraction of a cell.
const CELL_BITS: u32 = 9;

/// Octaves below the scale that are told apart.
const OCTAVES: u64 = 40;

/// Samples that are kept themselves.
pub(crate) const MOST_KEPT: u64 = 100_000;

/// What is known of one output.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Statistics {
    step: f64,
    count: u64,
    sum: i128,
    squares: i128,
    pub least: f64,
    pub most: f64,
    /// Sample that has the largest value; the first of them.
    pub most_at: u64,
    /// Values, where they are few; else counts by cell.
    kept: Vec<f64>,
    cells: Vec<u64>,
    lowest_cell: u64,
}

fn cell(value: f64) -> u64 {
    value.to_bits() >> (52 - CELL_BITS)
}

impl Statistics {
    /// For values from 0 to about `scale`; `samples` of them in the whole run.
    pub fn new(scale: f64, samples: u64) -> Statistics {
        let scale = if scale > 0.0 { scale } else { 1.0 };
        let lowest_cell = cell(scale * 0.5f64.powi(OCTAVES as i32));
        let cells = if samples > MOST_KEPT { ((OCTAVES + 4) << CELL_BITS) as usize } else { 0 };
        Statistics {
            step: scale * 0.5f64.powi(40),
            count: 0,
            sum: 0,
            squares: 0,
            least: f64::INFINITY,
            most: f64::NEG_INFINITY,
            most_at: 0,
            kept: Vec::new(),
            cells: vec![0; cells],
            lowest_cell,
        }
    }

    /// Takes the value of a sample.
    #[inline]
    pub fn add(&mut self, sample: u64, value: f64) {
        self.count += 1;
        let steps = (value / self.step) as i64;
        self.sum += i128::from(steps);
        self.squares += i128::from(steps) * i128::from(steps);
        self.least = self.least.min(value);
        if value > self.most {
            (self.most, self.most_at) = (value, sample);
        }
        if self.cells.is_empty() {
            self.kept.push(value);
        } else {
            let place = cell(value).saturating_sub(self.lowest_cell) as usize;
            let last = self.cells.len() - 1;
            self.cells[place.min(last)] += 1;
        }
    }

    /// Joins what is known of later samples.
    pub fn merge(&mut self, other: &Statistics) {
        self.count += other.count;
        self.sum += other.sum;
        self.squares += other.squares;
        self.least = self.least.min(other.least);
        if other.most > self.most {
            (self.most, self.most_at) = (other.most, other.most_at);
        }
        self.kept.extend(&other.kept);
        for (own, other) in self.cells.iter_mut().zip(&other.cells) {
            *own += other;
        }
    }

    pub fn mean(&self) -> f64 {
        self.sum as f64 / self.count as f64 * self.step
    }

    /// Standard deviation of the population.
    pub fn deviation(&self) -> f64 {
        // About a whole number near the mean, in integers: nothing cancels.
        let count = i128::from(self.count);
        let near = self.sum / count;
        let centred = self.squares - 2 * near * self.sum + count * near * near;
        let rest = (self.sum - near * count) as f64 / self.count as f64;
        let variance = centred as f64 / self.count as f64 - rest * rest;
        variance.max(0.0).sqrt() * self.step
    }

    /// Sorts what is kept, for [`Statistics::percentile`].
    pub fn finish(&mut self) {
        self.kept.sort_by(f64::total_cmp);
    }

    /// Value that a share of the samples does not exceed.
    pub fn percentile(&self, share: f64) -> f64 {
        let rank = ((share * self.count as f64).ceil() as u64).clamp(1, self.count);
        if self.cells.is_empty() {
            return self.kept[rank as usize - 1];
        }
        let mut below = 0;
        for (place, count) in self.cells.iter().enumerate() {
            below += count;
            if below >= rank {
                let bits = |cell: u64| f64::from_bits(cell << (52 - CELL_BITS));
                let at = self.lowest_cell + place as u64;
                let value = if place == 0 { 0.0 } else { 0.5 * (bits(at) + bits(at + 1)) };
                return value.clamp(self.least, self.most);
            }
        }
        self.most
    }
}
