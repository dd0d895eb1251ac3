//! Whether a crank can turn.

use crate::engine_parts::{Cylinder, RodJoint, Throw};
use std::f64::consts::TAU;

/// Crank angles at which an articulated rod is checked.
const GRID: usize = 1440;

/// Share of the limit by which a rod must be longer: below it a linkage turns on paper, but not in doubles.
pub const CLEARANCE: f64 = 1e-9;

/// Share of its length by which an articulated rod must clear its limit on the grid: between two grid angles the
/// reach grows by less than `(tau / GRID)^2 / 8` of it, about 2e-6.
pub const MARGIN: f64 = 1e-5;

/// Largest distance of the knuckle pin from the line of the piston pin over a revolution [m]; `None` if the master's
/// own linkage does not turn.
///
/// In the master's frame the crankpin stands at `r e^{i p}`, its rod points along
/// `(sqrt(l^2 - (r sin p - e)^2) + i (e - r sin p)) / l`; the knuckle pin stands off the crankpin in that direction,
/// turned by the knuckle angle. Only its part across the slave's axis counts.
pub fn largest_reach(throw: &Throw, master: &Cylinder, slave: &Cylinder) -> Option<f64> {
    let RodJoint::Articulated { knuckle_radius, knuckle_angle, .. } = slave.rod.joint else { return None };
    let (r, l, e) = (throw.radius, master.rod.length, master.net_offset());
    let mut largest = 0.0_f64;
    for step in 0..GRID {
        let pin = TAU * step as f64 / GRID as f64;
        let across = e - r * pin.sin();
        let along = l * l - across * across;
        if along <= 0.0 {
            return None;
        }
        let rod_angle = across.atan2(along.sqrt());
        let turn = master.angle - slave.angle;
        let knuckle = r * (pin + turn).sin() + knuckle_radius * (rod_angle + knuckle_angle + turn).sin();
        largest = largest.max((knuckle - slave.net_offset()).abs());
    }
    Some(largest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine_parts::{Rod, RodMassRule};

    fn cylinder(angle: f64, length: f64, offset: f64, joint: RodJoint) -> Cylinder {
        let mass_rule = RodMassRule::Thirds;
        let rod = Rod {
            length,
            big_end_mass: 0.4,
            small_end_mass: 0.2,
            inertia: None,
            axial_inertia: 0.0,
            mass_rule,
            joint,
        };
        Cylinder {
            throw: 0,
            angle,
            z: 0.0,
            offset,
            pin_offset: 0.0,
            bore: None,
            piston_mass: 0.5,
            rod,
            firing_angle: None,
            chamber: None,
        }
    }

    #[track_caller]
    fn assert_reach(master_length: f64, knuckle_radius: f64, expected: f64) {
        let throw = Throw {
            crankshaft: 0,
            angle: 0.0,
            z: 0.0,
            radius: 0.07,
            unbalance: 0.0,
            unbalance_offset: 0.0,
            webs: None,
        };
        let master = cylinder(0.3, master_length, 0.0, RodJoint::Crankpin);
        let joint = RodJoint::Articulated { master: 0, knuckle_radius, knuckle_angle: 1.1 };
        let slave = cylinder(0.9, 0.2, -0.01, joint);
        let reach = largest_reach(&throw, &master, &slave).unwrap();
        // The grid misses the extreme by less than (tau / GRID)^2 / 8 of the radius.
        assert!((reach - expected).abs() < 3e-6 * 0.07, "{reach} {expected}");
    }

    #[test]
    fn on_the_crankpin_itself_the_reach_is_radius_plus_offset() {
        assert_reach(0.25, 1e-12, 0.07 + 0.01);
    }

    /// The rod of an endless master keeps its direction: the knuckle pin moves on a circle about a fixed point off the
    /// crank axis.
    #[test]
    fn on_an_endless_master_the_knuckle_pin_moves_on_a_circle() {
        let shift = 0.05 * (1.1_f64 + 0.3 - 0.9).sin() + 0.01;
        assert_reach(1e6, 0.05, 0.07 + shift);
    }

    #[test]
    fn a_master_that_does_not_turn_has_no_reach() {
        let throw = Throw {
            crankshaft: 0,
            angle: 0.0,
            z: 0.0,
            radius: 0.07,
            unbalance: 0.0,
            unbalance_offset: 0.0,
            webs: None,
        };
        let master = cylinder(0.0, 0.06, 0.0, RodJoint::Crankpin);
        let joint = RodJoint::Articulated { master: 0, knuckle_radius: 0.03, knuckle_angle: 1.0 };
        assert_eq!(largest_reach(&throw, &master, &cylinder(1.0, 0.2, 0.0, joint)), None);
    }
}
