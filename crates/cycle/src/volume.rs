//! Volume of a cylinder over the angle, from the exact motion of its own linkage.

use crate::error::CycleError;
use lanchester_mechanism::{CylinderMotion, LoadRequest, RodLinkage, motion};
use lanchester_model::Engine;
use std::f64::consts::{PI, TAU};

/// Volume of the chamber of one cylinder over the angle [rad] since its firing top dead centre; where pistons share a chamber, of all of them.
///
/// ```text
/// V(psi) = V_c + SUM A_i (s_top,i - s_i(psi)) - v_0       V_c = V_swept/(ratio - 1)       (28.1)
/// ```
/// `v_0` is the least of the sum, 0 for one piston; the angle counts from where the volume is least.
#[derive(Debug, Clone, PartialEq)]
pub struct CylinderVolume {
    /// By number.
    pistons: Vec<PistonVolume>,
    /// `theta` at which the angle is 0: the true top dead centre [rad].
    top_angle: f64,
    /// Turns of its crankshaft for one of crankshaft 1, not signed.
    ratio: f64,
    bottom_angle: f64,
    clearance: f64,
    least: f64,
    swept: f64,
    cycle: f64,
    /// Whether its pistons face each other: then there is no head.
    opposed: bool,
}

/// One piston of a chamber.
#[derive(Debug, Clone, PartialEq)]
struct PistonVolume {
    /// Index of its cylinder.
    cylinder: usize,
    linkage: RodLinkage,
    area: f64,
    bore: f64,
    top: f64,
    stroke: f64,
}

impl PistonVolume {
    fn of(engine: &Engine, index: usize, motion: &CylinderMotion) -> Result<PistonVolume, CycleError> {
        let bore = engine.cylinders[index].bore.ok_or(CycleError::NoBore { cylinder: index + 1 })?;
        let linkage = RodLinkage::new(engine, index)?;
        let area = PI / 4.0 * bore * bore;
        Ok(PistonVolume { cylinder: index, linkage, area, bore, top: motion.top, stroke: motion.stroke })
    }

    /// Distance of the piston from its own top dead centre [m] where crankshaft 1 stands at `theta`, and its rate [m/rad].
    fn depth(&self, theta: f64) -> [f64; 2] {
        let [travel, rate] = self.linkage.at(theta).travel;
        [self.top - travel, -rate]
    }
}

impl CylinderVolume {
    /// Those of all cylinders. Without a compression ratio volumes count from that at top dead centre.
    ///
    /// # Errors
    /// A cylinder without a bore, a compression ratio of 1 or less, or a linkage that does not turn.
    pub fn of_engine(
        engine: &Engine,
        compression_ratio: Option<f64>,
    ) -> Result<Vec<CylinderVolume>, CycleError> {
        if let Some(ratio) = compression_ratio.filter(|ratio| !(*ratio > 1.0 && ratio.is_finite())) {
            return Err(CycleError::Number {
                quantity: "compression ratio",
                needed: "more than 1".into(),
                got: ratio,
                hint: "it is the largest volume of a cylinder over the smallest",
            });
        }
        let motions = motion(engine, &LoadRequest { samples: SAMPLES, ..LoadRequest::default() })?;
        let cycle = TAU * f64::from(engine.strokes.revolutions());
        (engine.cylinders.iter().zip(&motions).enumerate())
            .map(|(index, (cylinder, own))| {
                let of = |index: usize| PistonVolume::of(engine, index, &motions[index]);
                let pistons = engine
                    .chamber_pistons(index)
                    .into_iter()
                    .map(of)
                    .collect::<Result<Vec<_>, CycleError>>()?;
                let crankshaft = engine.throws[cylinder.throw].crankshaft;
                let ratio = engine.crankshafts[crankshaft].ratio.value().abs();
                let [top, bottom, swept, least] = match &own.chamber {
                    Some(chamber) => {
                        [chamber.top_dead_centre, chamber.bottom_dead_centre, chamber.swept, chamber.least]
                    }
                    None => [own.top_dead_centre, own.bottom_dead_centre, pistons[0].area * own.stroke, 0.0],
                };
                let axis = |piston: &PistonVolume| engine.cylinders[piston.cylinder].angle;
                let opposed = pistons.iter().any(|piston| (axis(piston) - axis(&pistons[0])).cos() < 0.0);
                Ok(CylinderVolume {
                    top_angle: own.firing_angle.unwrap_or(top),
                    ratio,
                    bottom_angle: ((bottom - top) * ratio).rem_euclid(TAU),
                    clearance: compression_ratio.map_or(0.0, |ratio| swept / (ratio - 1.0)),
                    least,
                    swept,
                    cycle,
                    opposed,
                    pistons,
                })
            })
            .collect()
    }

    /// Angle of crankshaft 1 at the cylinder's firing top dead centre [rad]: the true one, next to the file's firing angle. Without a
    /// firing in the file its first top dead centre.
    pub fn firing_angle(&self) -> f64 {
        self.top_angle
    }

    /// Angle [rad] through which its crankshaft has turned since its firing top dead centre when crankshaft 1 stands at `theta`.
    pub fn own_angle(&self, theta: f64) -> f64 {
        (theta - self.top_angle) * self.ratio
    }

    /// Speed of its crankshaft over that of crankshaft 1, not signed.
    pub fn speed_ratio(&self) -> f64 {
        self.ratio
    }

    /// Length of the working cycle [rad] of the cylinder's own crankshaft: 2 pi or 4 pi.
    pub fn cycle(&self) -> f64 {
        self.cycle
    }

    /// Angle of the first bottom dead centre after the firing top dead centre [rad]: pi but for offsets and articulated rods.
    pub fn bottom_angle(&self) -> f64 {
        self.bottom_angle
    }

    /// Area of the bore [m^2]; of all pistons that share the chamber.
    pub fn area(&self) -> f64 {
        self.pistons.iter().map(|piston| piston.area).sum()
    }

    /// Area of the bores that a head closes [m^2]: 0 where pistons face each other.
    pub fn head_area(&self) -> f64 {
        if self.opposed { 0.0 } else { self.area() }
    }

    /// Area of the liner that the pistons leave free below their top dead centres [m^2].
    pub fn liner_area(&self, psi: f64) -> f64 {
        let theta = self.theta(psi);
        self.pistons.iter().map(|piston| PI * piston.bore * piston.depth(theta)[0].max(0.0)).sum()
    }

    /// Bore [m]; of several pistons that of the first.
    pub fn bore(&self) -> f64 {
        self.pistons[0].bore
    }

    /// Stroke [m]: true travel of the piston, of several that of the first.
    pub fn stroke(&self) -> f64 {
        self.pistons[0].stroke
    }

    /// Displaced volume [m^3]: the largest less the smallest.
    pub fn displaced(&self) -> f64 {
        self.swept
    }

    /// Smallest volume [m^3]; 0 where the compression ratio is not known.
    pub fn clearance(&self) -> f64 {
        self.clearance
    }

    /// Index of the first cylinder of its chamber: the cylinder itself but where pistons share one.
    pub fn chamber(&self) -> usize {
        self.pistons[0].cylinder
    }

    /// Pistons of the chamber.
    pub fn pistons(&self) -> usize {
        self.pistons.len()
    }

    fn theta(&self, psi: f64) -> f64 {
        self.top_angle + psi / self.ratio
    }

    /// Distance of the piston from its top dead centre [m], and its rate [m/rad]; of several that of the first.
    pub fn depth(&self, psi: f64) -> [f64; 2] {
        self.depth_of(psi, false).0
    }

    /// The same of the first or the last piston of the chamber, and its stroke [m].
    pub(crate) fn depth_of(&self, psi: f64, last: bool) -> ([f64; 2], f64) {
        let piston = &self.pistons[if last { self.pistons.len() - 1 } else { 0 }];
        let [depth, rate] = piston.depth(self.theta(psi));
        ([depth, rate / self.ratio], piston.stroke)
    }

    /// Volume [m^3] and its rate [m^3/rad].
    pub fn at(&self, psi: f64) -> [f64; 2] {
        let theta = self.theta(psi);
        let mut sum = [self.clearance - self.least, 0.0];
        for piston in &self.pistons {
            let [depth, rate] = piston.depth(theta);
            sum[0] += piston.area * depth;
            sum[1] += piston.area * rate / self.ratio;
        }
        sum
    }

    /// Whether another cylinder has the same volumes at the same angles of its own, to rounding.
    pub fn moves_as(&self, other: &CylinderVolume) -> bool {
        let near = |one: f64, two: f64| (one - two).abs() <= 1e-12 * one.abs().max(two.abs());
        let same = |one: f64, two: f64, size: f64| (one - two).abs() <= 1e-12 * size;
        near(self.area(), other.area())
            && near(self.bore(), other.bore())
            && near(self.clearance, other.clearance)
            && near(self.cycle, other.cycle)
            && near(self.ratio, other.ratio)
            && self.pistons.len() == other.pistons.len()
            && self.opposed == other.opposed
            && (0..ALIKE).all(|k| {
                let psi = TAU * f64::from(k) / f64::from(ALIKE);
                let [first, last] = [false, true].map(|last| {
                    let (one, stroke) = self.depth_of(psi, last);
                    same(one[0], other.depth_of(psi, last).0[0], stroke)
                });
                first && last && same(self.at(psi)[0], other.at(psi)[0], self.swept)
            })
    }
}

/// Angles of a turn at which motions are compared.
const ALIKE: u32 = 24;
/// Angles of a turn in the trace of a motion, of which only the dead centres are used.
const SAMPLES: usize = 16;
