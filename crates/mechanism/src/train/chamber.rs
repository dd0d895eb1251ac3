//! Pistons that share a combustion chamber: its volume over the angle, and its dead centres.
//!
//! ```text
//! V(theta) = V_c + SUM A_i (s_top,i - s_i(theta)) - v_0        v_0: the least of the sum                  (24.11)
//! ```
//! The chamber's top dead centre is where its volume is least, its bottom dead centre where it is largest; its gas counts from the first of them. A piston
//! whose crankshaft leads is past its own dead centre there.

use crate::curves::extremes::extremes_over_turn;
use crate::inertia::request::LoadError;
use crate::inertia::result::{ChamberMotion, CylinderMotion};
use crate::train::drive::Linkage;
use crate::train::mechanism::{linkage, master_of};
use lanchester_model::Engine;
use std::f64::consts::{PI, TAU};

/// Angles of a turn that are scanned before extremes are refined.
const SCAN: usize = 1440;

/// One piston of a chamber.
struct ChamberPiston {
    linkage: Linkage,
    area: f64,
    ratio: f64,
    phase: f64,
}

/// The chamber of the pistons `cylinders` (indices, two or more) of `engine`; `motion` holds all.
pub(crate) fn chamber_motion(
    engine: &Engine,
    cylinders: &[usize],
    motion: &[CylinderMotion],
) -> Result<ChamberMotion, LoadError> {
    let pistons = cylinders
        .iter()
        .map(|&index| {
            let cylinder = &engine.cylinders[index];
            let axis = engine.cylinders[master_of(cylinder).unwrap_or(index)].angle;
            let ratio = engine.crankshafts[engine.throws[cylinder.throw].crankshaft].ratio.value();
            let area = cylinder.bore.map_or(1.0, |bore| 0.25 * PI * bore * bore);
            let phase = engine.pin_angle(cylinder.throw, 0.0) - axis;
            Ok(ChamberPiston { linkage: linkage(engine, index)?, area, ratio, phase })
        })
        .collect::<Result<Vec<_>, LoadError>>()?;
    let rate = pistons.iter().map(|piston| piston.ratio.abs()).fold(0.0, f64::max);
    // What fills the chamber, over the turn of its crankshafts, with its slope.
    let filled = |own: f64| {
        let theta = own / rate;
        pistons.iter().fold((0.0, 0.0), |(sum, slope), piston| {
            let [travel, by_phi, ..] = piston.linkage.travel(piston.ratio * theta + piston.phase);
            (sum + piston.area * travel, slope + piston.area * by_phi * piston.ratio / rate)
        })
    };
    let extremes = extremes_over_turn(SCAN, filled);
    let tops: f64 =
        pistons.iter().zip(cylinders).map(|(piston, &index)| piston.area * motion[index].top).sum();
    let turned = |own: f64| own.rem_euclid(TAU) / rate;
    Ok(ChamberMotion {
        cylinders: cylinders.iter().map(|index| index + 1).collect(),
        top_dead_centre: turned(extremes.max.theta),
        bottom_dead_centre: turned(extremes.min.theta),
        swept: extremes.max.value - extremes.min.value,
        least: (tops - extremes.max.value).max(0.0),
    })
}
