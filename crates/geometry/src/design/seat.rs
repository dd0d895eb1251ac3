//! Where a counterweight sits: what its web has of it already, and how far it may reach.

use super::optimum::Design;
use super::reach::Reach;

/// What of a counterweight depends on its place on the crankshaft.
pub trait Seat {
    /// What the web has already of a design's unbalance [kg m]: the design must have that much more. The design becomes the one that
    /// [`Seat::reach`] is about.
    fn lost(&mut self, design: &Design) -> f64;

    /// How far the design that [`Seat::lost`] was asked about last may reach; none where nothing is in its way.
    fn reach(&self) -> Option<&Reach>;

    /// How often the reach has changed.
    fn changes(&self) -> usize {
        0
    }
}

/// No web and nothing in the way.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unseated;

impl Seat for Unseated {
    fn lost(&mut self, _: &Design) -> f64 {
        0.0
    }

    fn reach(&self) -> Option<&Reach> {
        None
    }
}
