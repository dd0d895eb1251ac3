//! Torque of gas and inertia over the cycle, firing, friction and power.

pub(crate) mod cycle;
pub(crate) mod firing_chart;
pub(crate) mod gas;
pub(crate) mod gas_train;
pub(crate) mod outer_torque;
pub(crate) mod power_curve;
pub(crate) mod request;
pub(crate) mod result;
pub(crate) mod without_gas;

pub use cycle::torque;
pub use firing_chart::*;
pub use gas::CylinderGas;
pub use gas_train::{GasTrain, merged_orders};
pub use outer_torque::OuterTorque;
pub use power_curve::{Brake, PowerCurve};
pub use request::{Lever, TorqueError, TorqueRequest};
pub use result::*;
pub use without_gas::torque_without_gas;
