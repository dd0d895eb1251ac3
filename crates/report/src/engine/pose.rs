//! Where the links stand at a crank angle, for drawings.

use lanchester_model::{Engine, RodJoint};
use num_complex::Complex64;

/// The links of one cylinder at one crank angle, in the plane across the crank [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pose {
    /// Axis of its crankshaft.
    pub centre: Complex64,
    /// Crankpin.
    pub crankpin: Complex64,
    /// Big end of its rod: the crankpin, or the knuckle pin.
    pub big_end: Complex64,
    /// Piston pin.
    pub piston_pin: Complex64,
    /// Middle of the piston: at the height of its pin on the cylinder axis.
    pub piston: Complex64,
    /// Direction of the cylinder axis, of modulus 1.
    pub axis: Complex64,
}

/// The links of cylinder `index` (from 0) at crank angle `theta` [rad].
pub(crate) fn pose(engine: &Engine, index: usize, theta: f64) -> Pose {
    let cylinder = &engine.cylinders[index];
    let throw = &engine.throws[cylinder.throw];
    let shaft = &engine.crankshafts[throw.crankshaft];
    let centre = Complex64::new(shaft.x, shaft.y);
    let crankpin = centre + Complex64::from_polar(throw.radius, engine.pin_angle(cylinder.throw, theta));
    let big_end = match cylinder.rod.joint {
        RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
            let line = slide(engine, master, centre, crankpin) - crankpin;
            crankpin + Complex64::from_polar(knuckle_radius, line.arg() + knuckle_angle)
        }
        RodJoint::Crankpin | RodJoint::Fork | RodJoint::Blade => crankpin,
    };
    let piston_pin = slide(engine, index, centre, big_end);
    let axis = Complex64::from_polar(1.0, cylinder.angle);
    let piston = piston_pin - Complex64::new(0.0, cylinder.pin_offset) * axis;
    Pose { centre, crankpin, big_end, piston_pin, piston, axis }
}

/// The piston pin on its line, one rod length from the big end.
fn slide(engine: &Engine, index: usize, centre: Complex64, big_end: Complex64) -> Complex64 {
    let cylinder = &engine.cylinders[index];
    let axis = Complex64::from_polar(1.0, cylinder.angle);
    let local = (big_end - centre) / axis;
    let offset = cylinder.net_offset();
    let reach = (cylinder.rod.length.powi(2) - (local.im - offset).powi(2)).max(0.0).sqrt();
    centre + axis * Complex64::new(local.re + reach, offset)
}

/// Width of a piston in a drawing [m]: its bore, or a likely one.
pub(crate) fn bore(engine: &Engine, index: usize) -> f64 {
    let cylinder = &engine.cylinders[index];
    cylinder.bore.unwrap_or(1.8 * engine.throws[cylinder.throw].radius)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn links_keep_their_lengths_and_the_piston_its_line() {
        let mut engine = sample::engine(&[(30.0, -30.0), (30.0, 30.0)]);
        engine = engine
            .with(|engine| {
                engine.cylinders[0].offset = 0.01;

                engine.cylinders[0].pin_offset = 0.002;

                engine.cylinders[1].throw = 0;

                engine.cylinders[1].rod.length = 0.11;

                engine.cylinders[1].rod.joint = RodJoint::Articulated {
                    master: 0,
                    knuckle_radius: 0.03,
                    knuckle_angle: 60f64.to_radians(),
                };
            })
            .expect("an engine");
        for theta in [0.0, 1.0, 2.5, 4.0] {
            let (master, slave) = (pose(&engine, 0, theta), pose(&engine, 1, theta));
            assert!(((master.piston_pin - master.crankpin).norm() - 0.144).abs() < 1e-12);
            assert!(((slave.piston_pin - slave.big_end).norm() - 0.11).abs() < 1e-12);
            assert!(((slave.big_end - slave.crankpin).norm() - 0.03).abs() < 1e-12);
            assert!(((master.piston_pin / master.axis).im - 0.012).abs() < 1e-12);
            assert!(((master.piston / master.axis).im - 0.010).abs() < 1e-12);
        }
    }
}
