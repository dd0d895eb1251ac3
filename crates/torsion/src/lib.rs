//! Torsional vibration of crankshafts and what they drive.
//!
//! ```
//! use lanchester_torsion::{Chain, modes};
//! // Two equal discs on a shaft swing against each other: w^2 = k (1/J + 1/J).
//! let chain = Chain::plain(&[2.0, 2.0], &[100.0])?;
//! assert!((modes(&chain, 0.0)?[0].frequency - 10.0).abs() < 1e-12);
//! # Ok::<(), lanchester_torsion::TorsionError>(())
//! ```
#![forbid(unsafe_code)]

mod campbell;
mod chain;
mod crank_chain;
mod crank_train;
mod damped;
mod den_hartog;
mod energy;
mod error;
mod excitation;
mod forced;
mod holzer;
mod impedance;
mod ker_wilson;
mod modes;
mod pendulum;
mod sweep;
mod synthesis;
mod time;
mod tune;

pub use campbell::{Campbell, Critical, OrderStar, campbell, order_stars};
pub use chain::{Chain, Shaft, ShaftKind, ShaftSection, Station, StationKind};
pub use crank_chain::{CrankChain, CrankChainInput, ThrowParts, crank_chain, throw_stiffness};
pub use crank_train::{SAMPLES, inertia_orders, torque_orders, train_inertia};
pub use damped::{DampedMode, damped_modes};
pub use den_hartog::{BestDamper, best_tuned, best_untuned, fixed_points};
pub use energy::{BALANCED, ChainEnergy};
pub use error::{ChainFault, TorsionError};
pub use excitation::{Excitation, Source, TorqueAt, orders_of};
pub use holzer::{HolzerRow, HolzerTable, holzer};
pub use ker_wilson::{ElementFlexibility, flexibilities, stiffness as ker_wilson_stiffness, weakest};
pub use modes::{Mode, modes};
pub use pendulum::Pendulum;
pub use sweep::{
    Curve, DamperSweep, PendulumSweep, Response, ShaftSweep, StationSweep, Sweep, peak, response, sweep,
};
pub use time::{PeriodicMotion, as_viscous, periodic_motion};
pub use tune::{TuneAim, TuneFree, TunePoint, TuneRequest, TunedDamper, peak_over_speed, tune};
