//! Random numbers by place: draw `variable` of sample `k` is a function of seed, variable and `k` alone.
//!
//! The number is the output function of SplitMix64 (Steele, Lea, Flood 2014) at counter `k` from a start that seed and
//! variable give. So sample `k` is the same on any thread, in any part of a run, and whatever else is drawn. The normal
//! distribution comes by its inverse (Wichura 1988, algorithm AS 241, relative error about 1e-16).

use lanchester_numerics::{LANES, Lanes};
use lanchester_task::Distribution;

/// Step of the counter: the golden ratio as an odd number.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// Output function of SplitMix64.
#[inline(always)]
pub(crate) fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The draws of one variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Stream {
    start: u64,
}

impl Stream {
    pub fn new(seed: u64, variable: usize) -> Stream {
        Stream {
            start: mixed(mixed(seed.wrapping_add(STEP)).wrapping_add((variable as u64).wrapping_mul(STEP))),
        }
    }

    /// Uniform in (0, 1), the middle of one of 2^52 equal cells.
    #[inline(always)]
    pub fn uniform(self, sample: u64) -> f64 {
        let bits = mixed(self.start.wrapping_add(sample.wrapping_mul(STEP)));
        ((bits >> 12) as f64 + 0.5) * (1.0 / (1u64 << 52) as f64)
    }
}

/// A distribution on [-1, 1], prepared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Shape {
    Uniform,
    /// Normal cut off at so many standard deviations; the probability below that.
    Normal {
        sigmas: f64,
        tail: f64,
    },
}

impl Shape {
    pub fn of(distribution: Distribution) -> Shape {
        match distribution {
            Distribution::Uniform => Shape::Uniform,
            Distribution::Normal { sigmas } => Shape::Normal { sigmas, tail: lower_tail(sigmas) },
        }
    }

    /// Draws of eight samples from `first` on.
    #[inline]
    pub fn draw(self, stream: Stream, first: u64) -> Lanes {
        let uniform = Lanes::each(|i| stream.uniform(first + i as u64));
        match self {
            Shape::Uniform => Lanes::each(|i| 2.0 * uniform[i] - 1.0),
            Shape::Normal { sigmas, tail } => {
                let inside = 1.0 - 2.0 * tail;
                // Symmetric about the middle to the last digit.
                let q = Lanes::each(|i| (uniform[i] - 0.5) * inside);
                let mut x = central(&q);
                for i in 0..LANES {
                    if q[i].abs() > 0.425 {
                        x[i] = outer(q[i]);
                    }
                }
                Lanes::each(|i| (x[i] / sigmas).clamp(-1.0, 1.0))
            }
        }
    }
}

/// Probability of a normal deviate below `-sigmas`: the root of the inverse.
fn lower_tail(sigmas: f64) -> f64 {
    let (mut low, mut high) = (-0.5, 0.0);
    for _ in 0..200 {
        let middle: f64 = 0.5 * (low + high);
        if quantile(middle) < -sigmas { low = middle } else { high = middle }
    }
    0.5 + 0.5 * (low + high)
}

/// Quantile of the normal distribution at probability `0.5 + q`.
fn quantile(q: f64) -> f64 {
    if q.abs() <= 0.425 {
        let mut lanes = Lanes::ZERO;
        lanes[0] = q;
        central(&lanes)[0]
    } else {
        outer(q)
    }
}

/// AS 241 for `|q| <= 0.425`, in the printed digits.
#[allow(clippy::excessive_precision)]
#[inline(always)]
fn central(q: &Lanes) -> Lanes {
    Lanes::each(|i| {
        let r = 0.180625 - q[i] * q[i];
        let above = ((((((2509.0809287301226727 * r + 33430.575583588128105) * r + 67265.770927008700853)
            * r
            + 45921.953931549871457)
            * r
            + 13731.693765509461125)
            * r
            + 1971.5909503065514427)
            * r
            + 133.14166789178437745)
            * r
            + 3.387132872796366608;
        let below = ((((((5226.495278852545925 * r + 28729.085735721942674) * r + 39307.89580009271061)
            * r
            + 21213.794301586595867)
            * r
            + 5394.1960214247511077)
            * r
            + 687.1870074920579083)
            * r
            + 42.313330701600911252)
            * r
            + 1.0;
        q[i] * above / below
    })
}

/// AS 241 for `|q| > 0.425`, in the printed digits.
#[allow(clippy::excessive_precision)]
fn outer(q: f64) -> f64 {
    let r = (-(0.5 - q.abs()).max(f64::MIN_POSITIVE).ln()).sqrt();
    let value = if r <= 5.0 {
        let r = r - 1.6;
        let above = ((((((7.7454501427834140764e-4 * r + 0.0227238449892691845833) * r
            + 0.24178072517745061177)
            * r
            + 1.27045825245236838258)
            * r
            + 3.64784832476320460504)
            * r
            + 5.7694972214606914055)
            * r
            + 4.6303378461565452959)
            * r
            + 1.42343711074968357734;
        let below = ((((((1.05075007164441684324e-9 * r + 5.475938084995344946e-4) * r
            + 0.0151986665636164571966)
            * r
            + 0.14810397642748007459)
            * r
            + 0.68976733498510000455)
            * r
            + 1.6763848301838038494)
            * r
            + 2.05319162663775882187)
            * r
            + 1.0;
        above / below
    } else {
        let r = r - 5.0;
        let above = ((((((2.01033439929228813265e-7 * r + 2.71155556874348757815e-5) * r
            + 0.0012426609473880784386)
            * r
            + 0.026532189526576123093)
            * r
            + 0.29656057182850489123)
            * r
            + 1.7848265399172913358)
            * r
            + 5.4637849111641143699)
            * r
            + 6.6579046435011037772;
        let below = ((((((2.04426310338993978564e-15 * r + 1.4215117583164458887e-7) * r
            + 1.8463183175100546818e-5)
            * r
            + 7.868691311456132591e-4)
            * r
            + 0.0148753612908506148525)
            * r
            + 0.13692988092273580531)
            * r
            + 0.59983220655588793769)
            * r
            + 1.0;
        above / below
    };
    value.copysign(q)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Variance of a distribution on [-1, 1].
    fn variance(shape: Shape) -> f64 {
        match shape {
            Shape::Uniform => 1.0 / 3.0,
            Shape::Normal { sigmas, tail } => {
                // 1 - 2 T phi(T) / (1 - 2 tail), in standard deviations.
                let density = (-0.5 * sigmas * sigmas).exp() / std::f64::consts::TAU.sqrt();
                (1.0 - 2.0 * sigmas * density / (1.0 - 2.0 * tail)) / (sigmas * sigmas)
            }
        }
    }

    #[test]
    fn quantiles_are_those_of_the_tables() {
        // Probabilities of one, two and three standard deviations, to 15 digits.
        for (below, x) in [(0.158655253931457, -1.0), (0.022750131948179, -2.0), (0.001349898031630, -3.0)] {
            assert!((quantile(below - 0.5) - x).abs() < 1e-12, "{below}");
            assert!((quantile(0.5 - below) + x).abs() < 1e-12, "{below}");
        }
        assert!((lower_tail(3.0) - 0.001349898031630095).abs() < 1e-15);
        assert!((lower_tail(6.0) - 9.865_876_450_377e-10).abs() < 1e-15);
    }

    #[test]
    fn draws_have_the_moments_of_their_distribution() {
        for distribution in [
            Distribution::Uniform,
            Distribution::Normal { sigmas: 3.0 },
            Distribution::Normal { sigmas: 1.5 },
        ] {
            let shape = Shape::of(distribution);
            let stream = Stream::new(7, 3);
            let draws: Vec<f64> = (0..20_000).flat_map(|k| shape.draw(stream, 8 * k).0).collect();
            let count = draws.len() as f64;
            let mean = draws.iter().sum::<f64>() / count;
            let found = draws.iter().map(|x| x * x).sum::<f64>() / count;
            // Five standard errors.
            assert!(mean.abs() < 5.0 * (variance(shape) / count).sqrt(), "{distribution:?}: mean {mean}");
            let error = 5.0 * variance(shape) * (2.0 / count).sqrt();
            assert!((found - variance(shape)).abs() < error, "{distribution:?}: variance {found}");
            assert!(draws.iter().all(|x| x.abs() <= 1.0));
        }
    }

    #[test]
    fn streams_are_apart() {
        let correlation = |a: Stream, b: Stream, shift: u64| {
            (0..100_000).map(|k| (a.uniform(k) - 0.5) * (b.uniform(k + shift) - 0.5)).sum::<f64>()
                / (1e5 / 12.0)
        };
        for variable in 1..20 {
            for shift in [0, 1] {
                let found = correlation(Stream::new(1, 0), Stream::new(1, variable), shift);
                assert!(found.abs() < 5.0 / 1e5f64.sqrt(), "{variable}: {found}");
            }
        }
        assert_ne!(Stream::new(1, 0).uniform(0), Stream::new(2, 0).uniform(0));
    }
}
