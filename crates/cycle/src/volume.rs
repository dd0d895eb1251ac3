//! Volume of a cylinder over the angle, from the exact motion of its own linkage.

use crate::error::CycleError;
use lanchester_mechanism::{LoadRequest, RodLinkage, motion};
use lanchester_model::Engine;
use std::f64::consts::{PI, TAU};

/// Volume of one cylinder over the angle [rad] since its firing top dead centre.
///
/// ```text
/// V(psi) = V_c + A (s_top - s(psi))          V_c = A stroke/(ratio - 1)                  (28.1)
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CylinderVolume {
    linkage: RodLinkage,
    /// `theta` at which the angle is 0: the true top dead centre [rad].
    top_angle: f64,
    /// Turns of its crankshaft for one of crankshaft 1, not signed.
    ratio: f64,
    area: f64,
    bore: f64,
    top: f64,
    stroke: f64,
    bottom_angle: f64,
    clearance: f64,
    cycle: f64,
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
        (engine.cylinders.iter().zip(motions).enumerate())
            .map(|(index, (cylinder, motion))| {
                let bore = cylinder.bore.ok_or(CycleError::NoBore { cylinder: index + 1 })?;
                let crankshaft = engine.throws[cylinder.throw].crankshaft;
                let ratio = engine.crankshafts[crankshaft].ratio.value().abs();
                let area = PI / 4.0 * bore * bore;
                let stroke = motion.stroke;
                Ok(CylinderVolume {
                    linkage: RodLinkage::new(engine, index)?,
                    top_angle: motion.firing_angle.unwrap_or(motion.top_dead_centre),
                    ratio,
                    area,
                    bore,
                    top: motion.top,
                    stroke,
                    bottom_angle: ((motion.bottom_dead_centre - motion.top_dead_centre) * ratio)
                        .rem_euclid(TAU),
                    clearance: compression_ratio.map_or(0.0, |ratio| area * stroke / (ratio - 1.0)),
                    cycle,
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

    /// Area of the bore [m^2].
    pub fn area(&self) -> f64 {
        self.area
    }

    /// Bore [m].
    pub fn bore(&self) -> f64 {
        self.bore
    }

    /// Stroke [m]: true travel of the piston.
    pub fn stroke(&self) -> f64 {
        self.stroke
    }

    /// Displaced volume [m^3].
    pub fn displaced(&self) -> f64 {
        self.area * self.stroke
    }

    /// Smallest volume [m^3]; 0 where the compression ratio is not known.
    pub fn clearance(&self) -> f64 {
        self.clearance
    }

    /// Distance of the piston from its top dead centre [m], and its rate [m/rad].
    pub fn depth(&self, psi: f64) -> [f64; 2] {
        let [travel, rate] = self.linkage.at(self.top_angle + psi / self.ratio).travel;
        [self.top - travel, -rate / self.ratio]
    }

    /// Volume [m^3] and its rate [m^3/rad].
    pub fn at(&self, psi: f64) -> [f64; 2] {
        let [depth, rate] = self.depth(psi);
        [self.clearance + self.area * depth, self.area * rate]
    }

    /// Whether another cylinder has the same volumes at the same angles of its own, to rounding.
    pub fn moves_as(&self, other: &CylinderVolume) -> bool {
        let near = |one: f64, two: f64| (one - two).abs() <= 1e-12 * one.abs().max(two.abs());
        near(self.area, other.area)
            && near(self.clearance, other.clearance)
            && near(self.cycle, other.cycle)
            && near(self.ratio, other.ratio)
            && (0..ALIKE).all(|k| {
                let psi = TAU * f64::from(k) / f64::from(ALIKE);
                (self.depth(psi)[0] - other.depth(psi)[0]).abs() <= 1e-12 * self.stroke
            })
    }
}

/// Angles of a turn at which motions are compared.
const ALIKE: u32 = 24;
/// Angles of a turn in the trace of a motion, of which only the dead centres are used.
const SAMPLES: usize = 16;
