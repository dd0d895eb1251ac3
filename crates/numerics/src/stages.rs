//! Derivatives at the stages of a step, four components side by side: sums over stages are taken for all four at once.

/// Components that one operation takes together.
pub(crate) const LANES: usize = 4;

/// One row of all components a stage; rows are filled up with zeros to whole lanes.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stages {
    components: usize,
    /// Lanes of a row.
    width: usize,
    lanes: Vec<[f64; LANES]>,
}

impl Stages {
    /// Room for `count` stages of `components` each; what was there stays only where the size does.
    pub fn resize(&mut self, count: usize, components: usize) {
        let width = components.div_ceil(LANES);
        if (self.components, self.lanes.len()) != (components, count * width) {
            (self.components, self.width) = (components, width);
            self.lanes = vec![[0.0; LANES]; count * width];
        }
    }

    /// One stage.
    pub fn row(&self, stage: usize) -> &[f64] {
        &self.lanes[stage * self.width..(stage + 1) * self.width].as_flattened()[..self.components]
    }

    /// The same to be written.
    pub fn row_mut(&mut self, stage: usize) -> &mut [f64] {
        let row = &mut self.lanes[stage * self.width..(stage + 1) * self.width];
        &mut row.as_flattened_mut()[..self.components]
    }

    /// Makes one stage another.
    pub fn copy(&mut self, from: usize, to: usize) {
        self.lanes.copy_within(from * self.width..(from + 1) * self.width, to * self.width);
    }

    /// `SUM weight_j k_j` for the components of one lane.
    #[inline]
    pub fn sum(&self, weights: &[(usize, f64)], lane: usize) -> [f64; LANES] {
        let mut sum = [0.0; LANES];
        for &(stage, weight) in weights {
            let k = &self.lanes[stage * self.width + lane];
            for (sum, k) in sum.iter_mut().zip(k) {
                *sum += weight * k;
            }
        }
        sum
    }

    /// `y + h SUM weight_j k_j` into `state`.
    pub fn advance(&self, state: &mut [f64], y: &[f64], h: f64, weights: &[(usize, f64)]) {
        for (lane, (state, y)) in state.chunks_mut(LANES).zip(y.chunks(LANES)).enumerate() {
            let sum = self.sum(weights, lane);
            for ((value, y), sum) in state.iter_mut().zip(y).zip(sum) {
                *value = y + h * sum;
            }
        }
    }

    /// `h SUM weight_j k_j` into `values`.
    pub fn combine(&self, values: &mut [f64], h: f64, weights: &[(usize, f64)]) {
        for (lane, values) in values.chunks_mut(LANES).enumerate() {
            for (value, sum) in values.iter_mut().zip(self.sum(weights, lane)) {
                *value = h * sum;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_every_component() {
        for components in 1..10 {
            let mut stages = Stages::default();
            stages.resize(3, components);
            for stage in 0..3 {
                let values = (0..components).map(|i| (stage * 10 + i) as f64 + 0.5);
                stages.row_mut(stage).iter_mut().zip(values).for_each(|(own, value)| *own = value);
            }
            let weights = [(0, 2.0), (2, -3.0)];
            let y: Vec<f64> = (0..components).map(|i| i as f64).collect();
            let (mut state, mut rise) = (vec![0.0; components], vec![0.0; components]);
            stages.advance(&mut state, &y, 0.5, &weights);
            stages.combine(&mut rise, 0.5, &weights);
            for i in 0..components {
                let sum = 2.0 * (i as f64 + 0.5) - 3.0 * (20.5 + i as f64);
                assert_eq!((state[i], rise[i]), (i as f64 + 0.5 * sum, 0.5 * sum));
            }
            stages.copy(2, 0);
            assert_eq!(stages.row(0), stages.row(2));
        }
    }
}
