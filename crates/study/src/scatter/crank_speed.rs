//! How fast a crankshaft or a shaft turns, and which orders it has.

use crate::scatter::error::ScatterError;
use lanchester_model::Ratio;

/// Speed of a crankshaft or shaft, at a whole multiple of that of crankshaft 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CrankSpeed {
    /// The multiple without its sign.
    pub multiple: u32,
    /// Sense of what turns with it: 0 forward, 1 backward.
    pub sense: usize,
    /// Square of its speed [1/s^2].
    pub square: f64,
}

/// A harmonic of a crankshaft that is among the orders of the engine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Harmonic {
    /// Its number on the crankshaft itself, from 1.
    pub number: u32,
    /// Place of its order among those of the engine.
    pub place: usize,
}

impl CrankSpeed {
    /// From its ratio to crankshaft 1, which turns at `speed` [rad/s]; `name`: what turns, for the message.
    ///
    /// # Errors
    /// [`ScatterError::Engine`] where the ratio is not whole.
    pub fn of(ratio: Ratio, speed: f64, name: impl Fn() -> String) -> Result<CrankSpeed, ScatterError> {
        if ratio.denominator() != 1 {
            let got = format!("{} at {ratio} of it", name());
            let needed = "crankshafts and shafts at whole multiples of the speed of crankshaft 1";
            return Err(ScatterError::Engine { needed, got });
        }
        let turns = f64::from(ratio.numerator());
        Ok(CrankSpeed {
            multiple: ratio.numerator().unsigned_abs(),
            sense: usize::from(turns < 0.0),
            square: (turns * speed).powi(2),
        })
    }

    /// Its harmonics among `orders`, rising.
    pub fn harmonics(&self, orders: &[u32]) -> Vec<Harmonic> {
        let of = |(place, order): (usize, &u32)| {
            (order % self.multiple == 0).then(|| Harmonic { number: order / self.multiple, place })
        };
        orders.iter().enumerate().filter_map(of).collect()
    }

    /// Place of its own order among `orders`.
    pub fn place(&self, orders: &[u32]) -> Option<usize> {
        orders.iter().position(|&order| order == self.multiple)
    }
}
