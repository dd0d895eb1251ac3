//! Deviations: what is drawn for each tolerance of the request.

use crate::scatter::error::ScatterError;
use lanchester_model::Engine;
use lanchester_task::{Distribution, Extent, Tolerance};

/// One deviation that is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Variable {
    /// Place of its tolerance in the list.
    pub tolerance: usize,
    /// The part; `None`: all of them.
    pub part: Option<usize>,
    pub half_width: f64,
    pub distribution: Distribution,
}

/// The deviations of all tolerances, in the order of the list, part by part.
pub(crate) fn variables(engine: &Engine, tolerances: &[Tolerance]) -> Result<Vec<Variable>, ScatterError> {
    if tolerances.is_empty() {
        return Err(ScatterError::NoTolerance);
    }
    let mut variables = Vec::new();
    for (place, tolerance) in tolerances.iter().enumerate() {
        let (half_width, distribution) = (tolerance.half_width, tolerance.distribution);
        if !(half_width >= 0.0 && half_width.is_finite()) {
            let (needed, got) = ("finite and not negative", half_width);
            return Err(ScatterError::Number { quantity: "half width of a tolerance", needed, got });
        }
        if let Distribution::Normal { sigmas } = distribution
            && !(0.1..=8.0).contains(&sigmas)
        {
            let quantity = "standard deviations in a half width";
            return Err(ScatterError::Number { quantity, needed: "from 0.1 to 8", got: sigmas });
        }
        let parts = tolerance.quantity.parts(engine);
        if parts == 0 {
            return Err(ScatterError::NoSuchPart { place: place + 1, quantity: tolerance.quantity.name() });
        }
        let variable = |part| Variable { tolerance: place, part, half_width, distribution };
        match tolerance.extent {
            Extent::Common => variables.push(variable(None)),
            Extent::PerPart => variables.extend((0..parts).map(|part| variable(Some(part)))),
        }
    }
    Ok(variables)
}
