//! What takes the power of an engine: `[load]`.

use serde::Serialize;

/// Where the reaction to a torque goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ReactsOn {
    /// The ground: the block does not feel it.
    Ground,
    /// The block, as of a machine that is bolted to it.
    Block,
}

/// What takes the power, at the end of the driveline.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RunLoad {
    /// Its torque, against the rotation.
    pub law: LoadLaw,
    /// Where its reaction goes.
    pub reacts_on: ReactsOn,
}

/// Torque of a load over the speed w [rad/s], or the angle, of the shaft that it sits on.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LoadLaw {
    /// None.
    None,
    /// The same at every speed [N m]; like dry friction it holds at standstill.
    Constant(f64),
    /// `torque w / at`.
    Viscous {
        /// Torque [N m] at the speed `at`.
        torque: f64,
        /// Speed [rad/s].
        at: f64,
    },
    /// `torque (w / at)^2`.
    Quadratic {
        /// Torque [N m] at the speed `at`.
        torque: f64,
        /// Speed [rad/s].
        at: f64,
    },
    /// A constant power [W]; below `least_speed` [rad/s] the torque stays what it is there.
    Power {
        /// Power [W].
        power: f64,
        /// Speed below which the torque is constant [rad/s].
        least_speed: f64,
    },
    /// Torque [N m] at speeds [rad/s] that rise, straight between, constant beyond.
    Table(Vec<[f64; 2]>),
    /// Torque [N m] at angles [rad] that rise from 0 or more, straight between and from the last to the first a period later; it acts
    /// against positive rotation at any speed.
    Angle {
        /// Angle after which it repeats [rad].
        period: f64,
        /// Angles and torques.
        points: Vec<[f64; 2]>,
    },
    /// Torque over angle and speed: curves over the angle as in `Angle`, straight between their speeds, constant beyond.
    Map {
        /// Angle after which they repeat [rad].
        period: f64,
        /// The curves, at speeds that rise.
        curves: Vec<LoadCurve>,
    },
}

/// Torque of a load over the angle at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct LoadCurve {
    /// Speed of the shaft that it sits on [rad/s].
    pub speed: f64,
    /// Angles [rad] that rise from 0 or more, and torques [N m].
    pub points: Vec<[f64; 2]>,
}

impl LoadLaw {
    /// Whether it depends on the angle.
    pub fn is_over_angle(&self) -> bool {
        matches!(self, LoadLaw::Angle { .. } | LoadLaw::Map { .. })
    }

    /// Torque at an angle [rad] and a speed [rad/s] by the points of a law that depends on the angle [N m]: straight between them; `None` of any other.
    pub fn at_angle(&self, angle: f64, speed: f64) -> Option<f64> {
        match self {
            LoadLaw::Angle { period, points } => Some(periodic_value(points, *period, angle)),
            LoadLaw::Map { period, curves } => {
                let of = |curve: &LoadCurve| periodic_value(&curve.points, *period, angle);
                Some(match around(curves, speed) {
                    [Some(low), Some(high)] => {
                        let share = (speed.abs() - low.speed) / (high.speed - low.speed);
                        (1.0 - share) * of(low) + share * of(high)
                    }
                    [Some(only), None] | [None, Some(only)] => of(only),
                    [None, None] => 0.0,
                })
            }
            _ => None,
        }
    }

    /// What it takes over the angle at a speed [rad/s]: period [rad], angles [rad] and torques [N m]; `None` where the angle has no part in it.
    pub fn over_angle(&self, speed: f64) -> Option<(f64, Vec<[f64; 2]>)> {
        let (period, mut angles): (f64, Vec<f64>) = match self {
            LoadLaw::Angle { period, points } => (*period, points.iter().map(|point| point[0]).collect()),
            LoadLaw::Map { period, curves } => {
                let own = around(curves, speed).into_iter().flatten();
                (*period, own.flat_map(|curve| &curve.points).map(|point| point[0]).collect())
            }
            _ => return None,
        };
        angles.sort_by(f64::total_cmp);
        angles.dedup();
        let points = angles.into_iter().map(|angle| Some([angle, self.at_angle(angle, speed)?]));
        Some((period, points.collect::<Option<_>>()?))
    }
}

/// The curves next below and next above a speed [rad/s].
fn around(curves: &[LoadCurve], speed: f64) -> [Option<&LoadCurve>; 2] {
    let above = curves.partition_point(|curve| curve.speed <= speed.abs());
    [above.checked_sub(1).and_then(|below| curves.get(below)), curves.get(above)]
}

/// Value at `x` on straight lines through points within one period, from the last to the first of the next; 0 without points.
pub fn periodic_value(points: &[[f64; 2]], period: f64, x: f64) -> f64 {
    let count = points.len();
    if count == 0 {
        return 0.0;
    }
    let own = x.rem_euclid(period);
    let after = points.partition_point(|point| point[0] <= own);
    let [from, low] = points[(after + count - 1) % count];
    let [to, high] = points[after % count];
    let length = (to - from).rem_euclid(period);
    if length > 0.0 { low + (high - low) * (own - from).rem_euclid(period) / length } else { low }
}
