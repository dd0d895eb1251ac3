//! A slider-crank in the frame of its cylinder: u along the axis, v across it.

use crate::generate::pen::{Pen, Plane};

/// Sizes and angle, in any unit of length.
#[derive(Clone, Copy)]
pub struct Linkage {
    /// Crank radius.
    pub r: f64,
    /// Length of the rod.
    pub l: f64,
    /// Net offset.
    pub e: f64,
    /// Angle of the throw from the cylinder axis [rad].
    pub phi: f64,
}

impl Linkage {
    /// Crankpin.
    pub fn crankpin(&self) -> (f64, f64) {
        (self.r * self.phi.cos(), self.r * self.phi.sin())
    }

    /// What the rod spans across the cylinder, q.
    pub fn across(&self) -> f64 {
        self.r * self.phi.sin() - self.e
    }

    /// What it spans along the cylinder, W.
    pub fn along(&self) -> f64 {
        (self.l * self.l - self.across() * self.across()).sqrt()
    }

    /// Piston pin.
    pub fn piston_pin(&self) -> (f64, f64) {
        (self.crankpin().0 + self.along(), self.e)
    }

    /// Angle of the rod, β.
    pub fn rod_angle(&self) -> f64 {
        (self.across() / self.l).asin()
    }
}

/// Crank, rod and their pins; the pins last, so that they cover what ends there.
pub fn draw_linkage(pen: &mut Pen, plane: &Plane, linkage: &Linkage) {
    let (axis, pin, piston) =
        (plane.at((0.0, 0.0)), plane.at(linkage.crankpin()), plane.at(linkage.piston_pin()));
    pen.line("rod", pin, piston);
    pen.line("crank", axis, pin);
    for place in [axis, pin, piston] {
        pen.circle("pin", place, 5.0);
    }
}

/// A piston about its pin: half its width across, and how far its crown and skirt are from the pin.
pub fn draw_piston(
    pen: &mut Pen,
    plane: &Plane,
    pin: (f64, f64),
    centre: f64,
    [half, crown, skirt]: [f64; 3],
) {
    let corner = |a: f64, b: f64| plane.at((pin.0 + a, centre + b));
    pen.area(
        "metal",
        &[corner(crown, -half), corner(crown, half), corner(-skirt, half), corner(-skirt, -half)],
    );
}
