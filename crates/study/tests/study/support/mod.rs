//! Spaces of small engines.
#![allow(dead_code)]

use lanchester_model::Strokes;
use lanchester_study::explore::*;

/// Parts of a usual car engine at 400 rad/s.
pub fn parts() -> Parts {
    Parts {
        strokes: Strokes::Four,
        speed: 400.0,
        crank_radius: 0.045,
        piston_mass: 0.5,
        rod_big_end_mass: 0.4,
        rod_small_end_mass: 0.2,
        rod_inertia: Some(0.002),
        throw_unbalance: 0.01,
        web_distance: 0.045,
        web_thickness: 0.02,
        pin_diameter: 0.05,
        bore: 0.085,
        end_length: 0.2,
    }
}

/// No weights on the webs.
pub fn bare() -> CounterweightPattern {
    CounterweightPattern { name: "none".into(), rotating: 0.0, reciprocating: 0.0, webs: None }
}

/// Every throw balanced in itself.
pub fn full() -> CounterweightPattern {
    CounterweightPattern { name: "full".into(), rotating: 1.0, reciprocating: 0.0, webs: None }
}

/// One size of everything; throws in `steps` parts of a turn.
pub fn space(cylinders: usize, steps: u32, banks: Banks, firing: bool) -> Space {
    Space {
        parts: parts(),
        cylinders,
        banks,
        throw_angles: even_angles(steps),
        spacings: vec![0.1],
        rod_ratios: vec![0.3],
        counterweights: vec![bare()],
        shafts: vec![ShaftSet::default()],
        firing,
    }
}

/// Two banks with these angles [deg] and stagger [m].
pub fn two(bank_angles: &[f64], split_angles: &[f64], staggers: &[f64]) -> Banks {
    let radians = |list: &[f64]| list.iter().map(|angle| angle.to_radians()).collect();
    Banks::Two {
        bank_angles: radians(bank_angles),
        split_angles: radians(split_angles),
        staggers: staggers.to_vec(),
    }
}

pub fn explorer(space: Space, objectives: &[Objective], constraints: &[Constraint]) -> Explorer {
    Explorer::new(ExploreRequest::new(space, objectives.to_vec(), constraints.to_vec())).expect("a search")
}

/// Throw angles in whole degrees.
pub fn degrees(angles: &[f64]) -> Vec<i64> {
    angles.iter().map(|angle| angle.to_degrees().round() as i64).collect()
}
