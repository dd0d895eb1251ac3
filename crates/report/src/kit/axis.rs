//! Ranges and ticks of axes.

/// An axis: its range and evenly spaced round ticks.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Ticks, rising, within the range.
    pub ticks: Vec<f64>,
    /// Decimals that all tick labels need.
    pub decimals: usize,
}

impl Axis {
    /// The axis for values from `low` to `high` with about `count` round ticks; both ends are ticks. Zero, tiny,
    /// constant and non-finite data are fine.
    pub fn of(low: f64, high: f64, count: usize) -> Axis {
        let (mut low, mut high) = (low.min(high), high.max(low));
        if !(low.is_finite() && high.is_finite()) {
            (low, high) = (-1.0, 1.0);
        }
        let largest = low.abs().max(high.abs());
        if high - low <= 1e-9 * largest || high - low < 1e-300 {
            let half = if largest < 1e-300 { 1.0 } else { 0.5 * largest };
            (low, high) = (low - half, high + half);
        }
        let step = round_step((high - low) / count.max(1) as f64);
        let first = (low / step + 1e-6).floor();
        let last = (high / step - 1e-6).ceil();
        let ticks: Vec<f64> = (0..=(last - first) as usize).map(|k| (first + k as f64) * step).collect();
        Axis { low: first * step, high: last * step, ticks, decimals: step_decimals(step) }
    }

    /// Ticks at whole multiples of `step` from `low` to `high`, which stay as they are.
    pub fn stepped(low: f64, high: f64, step: f64) -> Axis {
        let first = (low / step - 1e-9).ceil() as i64;
        let last = (high / step + 1e-9).floor() as i64;
        let ticks = (first..=last).map(|k| k as f64 * step).collect();
        Axis { low, high, ticks, decimals: step_decimals(step) }
    }

    /// Where `value` lies between `from` (at the low end) and `to` (at the high end).
    pub fn place(&self, value: f64, from: f64, to: f64) -> f64 {
        from + (value - self.low) / (self.high - self.low) * (to - from)
    }

    /// Step between ticks.
    pub fn step(&self) -> f64 {
        self.ticks.windows(2).map(|w| w[1] - w[0]).next().unwrap_or(self.high - self.low)
    }
}

/// The round number 1, 2, 2.5, 5 times a power of ten that is nearest above `raw`.
fn round_step(raw: f64) -> f64 {
    let power = 10f64.powf(raw.log10().floor());
    let mantissa = raw / power;
    let round = if mantissa <= 1.0 + 1e-9 {
        1.0
    } else if mantissa <= 2.0 + 1e-9 {
        2.0
    } else if mantissa <= 2.5 + 1e-9 {
        2.5
    } else if mantissa <= 5.0 + 1e-9 {
        5.0
    } else {
        10.0
    };
    round * power
}

fn step_decimals(step: f64) -> usize {
    (0..=6).find(|&d| (step * 10f64.powi(d) - (step * 10f64.powi(d)).round()).abs() < 1e-6).unwrap_or(6)
        as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_ticks_hold_the_data() {
        let axis = Axis::of(-5077.5, 9535.5, 6);
        assert_eq!((axis.low, axis.high, axis.step()), (-7500.0, 10000.0, 2500.0));
        assert!(axis.ticks.contains(&0.0));
        assert_eq!(axis.decimals, 0);
        let axis = Axis::of(0.0, 0.9, 4);
        assert_eq!((axis.low, axis.high, axis.decimals), (0.0, 1.0, 2));
    }

    #[test]
    fn degenerate_data_give_an_axis_all_the_same() {
        for (low, high) in [
            (0.0, 0.0),
            (5.0, 5.0),
            (-3.0, -3.0),
            (1e-300, 1e-300),
            (f64::NAN, 1.0),
            (0.0, f64::INFINITY),
            (1e-12, 2e-12),
        ] {
            let axis = Axis::of(low, high, 5);
            assert!(
                axis.high > axis.low && axis.ticks.len() >= 2 && axis.ticks.len() < 20,
                "{low} {high}: {axis:?}"
            );
            assert!(axis.ticks.iter().all(|t| t.is_finite()), "{axis:?}");
            if low.is_finite() && high.is_finite() {
                assert!(axis.low <= low && high <= axis.high, "{axis:?}");
            }
        }
    }

    #[test]
    fn degrees_have_ticks_at_quarters() {
        let axis = Axis::stepped(0.0, 720.0, 90.0);
        assert_eq!(axis.ticks.len(), 9);
        assert_eq!(axis.place(360.0, 10.0, 110.0), 60.0);
    }
}
