//! Effective areas of valves and ports over the angle.

use crate::volume::CylinderVolume;
use lanchester_model::{Opening, OpeningShape, SingleZone};
use lanchester_numerics::golden_section;
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Angles of a cycle at which valve and piston are compared.
const STEPS: u32 = 2880;

/// Effective area over the angle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Area<'a> {
    volume: &'a CylinderVolume,
    opening: Opening,
    opens: f64,
    closes: f64,
    /// Depth of the piston where ports open, and how far it goes beyond [m].
    port: [f64; 2],
    /// Whether of several pistons of the chamber the last one uncovers the ports, not the first.
    last: bool,
}

impl<'a> Area<'a> {
    /// `is_intake`: where pistons share the chamber the last one uncovers intake ports, the first one exhaust ports.
    pub(crate) fn new(opening: Opening, volume: &'a CylinderVolume, is_intake: bool) -> Area<'a> {
        let opens = opening.opens;
        let last = is_intake;
        let (closes, port) = match opening.shape {
            OpeningShape::Valve { closes, .. } | OpeningShape::Area { closes, .. } => (closes, [0.0; 2]),
            OpeningShape::Port { .. } => {
                let (at_opening, stroke) = volume.depth_of(opens, last);
                let edge = at_opening[0];
                // The way up reaches the edge between bottom and next top dead centre: of the piston itself.
                let up = if volume.pistons() == 1 { TAU } else { opens + TAU };
                let (mut low, mut high) = (lowest(volume, last), up);
                for _ in 0..80 {
                    let middle = low + (high - low) / 2.0;
                    if volume.depth_of(middle, last).0[0] > edge { low = middle } else { high = middle }
                }
                (high, [edge, stroke - edge])
            }
        };
        Area { volume, opening, opens, closes, port, last }
    }

    /// Angle at which it closes [rad], less than a cycle beyond that at which it opens.
    pub(crate) fn closes(&self) -> f64 {
        self.closes
    }

    /// Angles at which the area begins, ends or has a kink.
    pub(crate) fn kinks(&self) -> Vec<f64> {
        let mut kinks = vec![self.opens, self.closes];
        if let OpeningShape::Valve { lift, diameter, .. } = self.opening.shape
            && lift > diameter / 4.0
        {
            let at = (diameter / 4.0 / lift).sqrt().asin() / PI * (self.closes - self.opens);
            kinks.extend([self.opens + at, self.closes - at]);
        }
        kinks
    }

    /// Angle since it opened [rad], if it is open.
    fn since(&self, psi: f64) -> Option<f64> {
        let since = (psi - self.opens).rem_euclid(self.volume.cycle());
        (since < self.closes - self.opens).then_some(since)
    }

    pub(crate) fn is_open(&self, psi: f64) -> bool {
        self.since(psi).is_some()
    }

    /// Effective area [m^2].
    pub(crate) fn at(&self, psi: f64) -> f64 {
        let Some(since) = self.since(psi) else { return 0.0 };
        let share = || (PI * since / (self.closes - self.opens)).sin().powi(2);
        let geometric = match self.opening.shape {
            OpeningShape::Valve { lift, diameter, number, .. } => {
                f64::from(number) * PI * diameter * (lift * share()).min(diameter / 4.0)
            }
            OpeningShape::Area { area, .. } => area * share(),
            OpeningShape::Port { area } => {
                let depth = self.volume.depth_of(psi, self.last).0[0];
                area * ((depth - self.port[0]) / self.port[1]).max(0.0)
            }
        };
        geometric * self.opening.discharge_coefficient
    }
}

/// Angle after firing [rad] at which the first or last piston of a chamber is at its own bottom dead centre.
fn lowest(volume: &CylinderVolume, last: bool) -> f64 {
    if volume.pistons() == 1 {
        return volume.bottom_angle();
    }
    // The root of its rate about the bottom dead centre of the chamber, a quarter of a turn on either side.
    let bottom = volume.bottom_angle();
    let (mut low, mut high) = (bottom - TAU / 4.0, bottom + TAU / 4.0);
    for _ in 0..80 {
        let middle = low + (high - low) / 2.0;
        if volume.depth_of(middle, last).0[1] > 0.0 { low = middle } else { high = middle }
    }
    high
}

/// Least distance of open valves from the piston.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PistonGap {
    /// The intake valves or the exhaust valves.
    pub is_intake: bool,
    /// Along the cylinder axis [m]; negative where they meet.
    pub gap: f64,
    /// Where [rad], from 0 to the length of the cycle.
    pub angle: f64,
}

/// Least distance of the valves from the piston while they are open, for those whose distance at top dead centre is given.
///
/// ```text
/// gap(psi) = clearance + (s_top - s(psi)) - lift(psi)                                    (28.12)
/// ```
pub fn piston_gap(zone: &SingleZone, volume: &CylinderVolume) -> Vec<PistonGap> {
    [(true, zone.intake), (false, zone.exhaust)]
        .into_iter()
        .filter_map(|(is_intake, opening)| {
            let OpeningShape::Valve { closes, lift, piston_clearance: Some(clearance), .. } = opening.shape
            else {
                return None;
            };
            let open = closes - opening.opens;
            let gap = |psi: f64| {
                let lifted = lift * (PI * (psi - opening.opens) / open).sin().powi(2);
                clearance + volume.depth(psi)[0] - lifted
            };
            let step = open / f64::from(STEPS);
            let nearest = (0..=STEPS)
                .map(|k| opening.opens + step * f64::from(k))
                .min_by(|a, b| gap(*a).total_cmp(&gap(*b)))?;
            // Between the neighbours.
            let closer = |psi: f64| Ok::<f64, std::convert::Infallible>(-gap(psi));
            let Ok((angle, _)) = golden_section(nearest - step, nearest + step, 40, closer);
            Some(PistonGap { is_intake, gap: gap(angle), angle: angle.rem_euclid(volume.cycle()) })
        })
        .collect()
}
