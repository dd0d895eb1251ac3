//! What may be asked of a load calculation, and why it may be refused.

use lanchester_model::Engine;

/// What to compute: speed, reference point, motion, orders, angles, peaks.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadRequest {
    /// Speed of crankshaft 1 [rad/s]; `None`: the highest speed of the engine.
    pub speed: Option<f64>,
    /// Point that couples and roll moment are about [m]: x, y, z in the frame.
    pub reference: [f64; 3],
    /// Motion of the pistons.
    pub kinematics: Kinematics,
    /// Highest order listed, in cycles per revolution of crankshaft 1.
    pub max_order: u32,
    /// Angles of a trace in one revolution of crankshaft 1.
    pub samples: usize,
    /// How extremes are found.
    pub peaks: PeakMode,
}

impl Default for LoadRequest {
    /// Exact motion at the highest speed about the origin, orders to 8, every half degree, true extremes.
    fn default() -> Self {
        LoadRequest {
            speed: None,
            reference: [0.0; 3],
            kinematics: Kinematics::Exact,
            max_order: 8,
            samples: 720,
            peaks: PeakMode::Continuous,
        }
    }
}

/// Motion of the pistons and rods: exact, or what the literature truncates it to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kinematics {
    /// The exact motion, all orders.
    Exact,
    /// Exact order coefficients of piston travel and rod angle up to this order of their own crankshaft, nothing
    /// above. Torque and roll moment are the products of the truncated motion, so that energy stays balanced.
    Orders(u32),
    /// The literature's series: orders up to `max_order`, each coefficient truncated after the power `max_power` of
    /// the rod ratio r/l. Only for centred plain rods.
    PowerSeries {
        /// Highest order kept.
        max_order: u32,
        /// Highest power of the rod ratio kept.
        max_power: u32,
    },
}

impl Kinematics {
    /// Name for tables.
    pub fn name(self) -> String {
        match self {
            Kinematics::Exact => "exact".to_string(),
            Kinematics::Orders(max) => format!("exact coefficients of orders 1 to {max}"),
            Kinematics::PowerSeries { max_order, max_power } => {
                format!("series to order {max_order} and power {max_power} of the rod ratio")
            }
        }
    }
}

/// How extremes are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PeakMode {
    /// True extremes over the continuous angle.
    Continuous,
    /// Extremes among so many equally spaced angles a revolution, from `theta = 0`: what printed tables often hold.
    Grid(usize),
}

/// Why loads cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LoadError {
    /// A number of the request lies outside what is possible.
    #[error("{quantity} must be {needed}, got {got}")]
    Request {
        /// Which number.
        quantity: &'static str,
        /// What is possible.
        needed: &'static str,
        /// What was asked for.
        got: f64,
    },
    /// A crank radius or rod length beyond what is computed with.
    #[error(
        "crank radius and rod length of cylinder {cylinder} must lie between 1e-9 m and 1e6 m, got {got} m"
    )]
    Length {
        /// Cylinder number, from 1.
        cylinder: usize,
        /// The length [m].
        got: f64,
    },
    /// A plain rod cannot pass its dead centres.
    #[error(
        "rod of cylinder {cylinder} must be longer than crank radius plus offset {needed} m, got {length} m\nhint: \
         rod length is measured between eye centres"
    )]
    RodTooShort {
        /// Cylinder number, from 1.
        cylinder: usize,
        /// Crank radius plus the offset's amount [m].
        needed: f64,
        /// Rod length [m].
        length: f64,
    },
    /// An articulated rod cannot follow its knuckle pin.
    #[error(
        "articulated rod of cylinder {cylinder} must reach {needed} m beside the cylinder axis, got {length} m\nhint: \
         lengthen the rod, or turn the knuckle pin towards the cylinder"
    )]
    KnuckleOutOfReach {
        /// Cylinder number, from 1.
        cylinder: usize,
        /// Largest distance of the knuckle pin from the piston pin's line [m].
        needed: f64,
        /// Rod length [m].
        length: f64,
    },
    /// The master of an articulated rod is itself articulated, or runs on another throw.
    #[error("master of cylinder {cylinder} must be a plain rod on the same throw, got cylinder {master}")]
    MasterNotPlain {
        /// Cylinder number, from 1.
        cylinder: usize,
        /// Number of the master's cylinder, from 1.
        master: usize,
    },
    /// The power series of the literature knows neither offsets nor articulated rods.
    #[error(
        "the power series needs a centred plain rod, got {found} in cylinder {cylinder}\nhint: ask for exact \
         coefficients of the orders instead"
    )]
    SeriesNotCentred {
        /// Cylinder number, from 1.
        cylinder: usize,
        /// What it has instead.
        found: &'static str,
    },
    /// The speed ratios have no common period that is short enough.
    #[error(
        "the speed ratios must repeat within {limit} revolutions of crankshaft 1, but have no common period so \
         short\nhint: use fractions with smaller denominators"
    )]
    PeriodTooLong {
        /// Longest period allowed [revolutions].
        limit: u32,
    },
    /// The engine is not valid, or its numbers are too large.
    #[error("{quantity} must be finite, got {got}")]
    NotFinite {
        /// Which quantity.
        quantity: &'static str,
        /// Its value.
        got: f64,
    },
}

/// Most angles in one period.
pub(crate) const MAX_ANGLES: usize = 1 << 20;

/// Longest common period of all shafts [revolutions of crankshaft 1].
pub(crate) const MAX_REVOLUTIONS: u32 = 120;

impl LoadRequest {
    /// Speed of crankshaft 1 [rad/s] for this engine.
    pub(crate) fn speed_of(&self, engine: &Engine) -> f64 {
        self.speed.unwrap_or(engine.speed.highest)
    }

    /// Refuses what cannot be computed.
    pub(crate) fn check(&self, engine: &Engine) -> Result<(), LoadError> {
        let refuse = |quantity, needed, got| Err(LoadError::Request { quantity, needed, got });
        let speed = self.speed_of(engine);
        if !(speed > 0.0 && speed <= 1e60) {
            return refuse("speed [rad/s]", "positive and at most 1e60", speed);
        }
        if let Some(&bad) = self.reference.iter().find(|p| !p.is_finite()) {
            return refuse("reference point [m]", "finite", bad);
        }
        if !(1..=1000).contains(&self.max_order) {
            return refuse("highest order", "from 1 to 1000", f64::from(self.max_order));
        }
        if !(1..=100_000).contains(&self.samples) {
            return refuse("samples in a revolution", "from 1 to 100000", self.samples as f64);
        }
        if let PeakMode::Grid(count) = self.peaks
            && !(1..=100_000).contains(&count)
        {
            return refuse("angles of the peak grid", "from 1 to 100000", count as f64);
        }
        self.check_kinematics()
    }

    /// Refuses more angles in a period than are computed with.
    pub(crate) fn check_angles(&self, revolutions: u32) -> Result<(), LoadError> {
        let peaks = match self.peaks {
            PeakMode::Continuous => 0,
            PeakMode::Grid(count) => count,
        };
        let angles = self.samples.max(peaks) * revolutions as usize;
        if angles > MAX_ANGLES {
            let got = angles as f64;
            return Err(LoadError::Request { quantity: "angles in one period", needed: "at most 2^20", got });
        }
        Ok(())
    }

    fn check_kinematics(&self) -> Result<(), LoadError> {
        let refuse = |quantity, needed, got| Err(LoadError::Request { quantity, needed, got });
        let cap = match self.kinematics {
            Kinematics::Exact => return Ok(()),
            Kinematics::Orders(cap) => cap,
            Kinematics::PowerSeries { max_order, max_power } => {
                if !(1..=1000).contains(&max_power) {
                    return refuse("highest power of the rod ratio", "from 1 to 1000", f64::from(max_power));
                }
                max_order
            }
        };
        if !(1..=1000).contains(&cap) {
            return refuse("highest order of the motion", "from 1 to 1000", f64::from(cap));
        }
        Ok(())
    }
}
