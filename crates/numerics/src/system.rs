//! What an integrator needs to know of a system.

/// A system `M y' = f(t, y)` with event functions `g(t, y)`; without mass matrix `M` is the identity.
pub trait System {
    /// Number of components of `y`.
    fn dimension(&self) -> usize;

    /// `f(t, y)`. A value that is no number makes the integrator shorten its step, and is an outcome if that does not help.
    fn derivative(&mut self, t: f64, y: &[f64], derivative: &mut [f64]);

    /// Told before the first step of each interval between two neighbouring forced stops, so that a law in pieces can
    /// take the piece that lies within: at a stop itself the side would be unknown.
    fn enter(&mut self, _from: f64, _to: f64) {}

    /// Number of event functions.
    fn events(&self) -> usize {
        0
    }

    /// Values of the event functions: an event is a change of sign.
    fn event_functions(&mut self, _t: f64, _y: &[f64], _values: &mut [f64]) {}

    /// Whether no event function can change its sign within a step from `start` at `from` to `to`, while no component departs from `start` by more than
    /// `reach`: such a step needs no interpolant for its events.
    fn is_quiet(&self, _from: f64, _to: f64, _start: &[f64], _reach: &[f64]) -> bool {
        false
    }

    /// Matrix of df/dy, row by row. Returns false where it is unknown: it is then taken by differences.
    fn jacobian(&mut self, _t: f64, _y: &[f64], _jacobian: &mut [f64]) -> bool {
        false
    }

    /// Constant mass matrix, row by row, where it is not the identity; it may be singular if the system has index 1.
    /// For [`crate::Radau5`] alone.
    fn mass(&self) -> Option<Vec<f64>> {
        None
    }
}

/// A system without events from a function of `(t, y, derivative)`.
pub struct Function<F> {
    dimension: usize,
    function: F,
}

impl<F: FnMut(f64, &[f64], &mut [f64])> Function<F> {
    /// A system of that many components.
    pub fn new(dimension: usize, function: F) -> Function<F> {
        Function { dimension, function }
    }
}

impl<F: FnMut(f64, &[f64], &mut [f64])> System for Function<F> {
    fn dimension(&self) -> usize {
        self.dimension
    }

    fn derivative(&mut self, t: f64, y: &[f64], derivative: &mut [f64]) {
        (self.function)(t, y, derivative);
    }
}
