//! Loads over time, as columns.

use crate::exchange::force_table::rpm;
use crate::exchange::loads_model::{LoadsModel, LoadsModelError};
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::error::GasError;
use crate::pressure::measured::TraceFile;
use crate::torque_report::{TorqueReportError, bearing_report};
use lanchester_mechanism::{BearingPart, BearingRequest, LoadRequest, loads};
use lanchester_model::Engine;
use lanchester_table::{Column, Rows, Values};

/// One period of the loads at one speed.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadHistory {
    /// Heads, each with its unit at the end.
    pub columns: Vec<Column>,
    /// A row an angle.
    pub rows: Rows,
    /// What it is, one line.
    pub title: String,
    /// What is left out, and why.
    pub notes: Vec<String>,
}

/// Why there is no history.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LoadHistoryError {
    /// Of the main bearings.
    #[error(transparent)]
    Bearings(#[from] TorqueReportError),
    /// Of torque and mounts.
    #[error(transparent)]
    Loads(#[from] LoadsModelError),
    /// Of the pressures.
    #[error(transparent)]
    Gas(#[from] GasError),
}

/// Time, crank angle, what shakes the block, torque and pressures, the force of the block on every mount and of every journal on its main bearing, over one
/// period at constant speed from crank angle 0; `speed` [rad/s], the highest of the engine where it is not given. What shakes the block is of inertia; torque,
/// mounts and bearings have the gas too where the file gives it. Forces on mounts are those of the settled block, without weight and mean torque.
///
/// # Errors
/// [`LoadHistoryError`] where the loads cannot be computed. Mounts without a settled motion are left out with a note.
pub fn load_history(
    engine: &Engine,
    traces: &[TraceFile],
    speed: Option<f64>,
    samples: usize,
) -> Result<LoadHistory, LoadHistoryError> {
    let speed = speed.unwrap_or(engine.speed.highest);
    let part = if engine.gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
    let request = BearingRequest { speed: Some(speed), part, counterweights: true, samples };
    let bearings = bearing_report(engine, traces, &request)?;
    let request = LoadRequest { speed: Some(speed), samples, ..LoadRequest::default() };
    let found = loads(engine, &request).map_err(LoadsModelError::from)?;
    let trace = &found.total.trace;
    let mut columns = vec![Column::real("time_s"), Column::real("crank_angle_deg")];
    let mut values = vec![
        bearings.theta.iter().map(|theta| theta / speed).collect(),
        bearings.theta.iter().map(|theta| theta.to_degrees()).collect::<Vec<f64>>(),
    ];
    // The loads repeat within the longer period of the bearings.
    let count = trace.theta.len();
    let over = |own: &[f64]| (0..bearings.theta.len()).map(|k| own[k % count]).collect::<Vec<f64>>();
    let shaking = [
        ("shaking_force_x_N", &trace.force_x),
        ("shaking_force_y_N", &trace.force_y),
        ("couple_x_Nm", &trace.couple_x),
        ("couple_y_Nm", &trace.couple_y),
        ("roll_moment_Nm", &trace.roll_moment),
    ];
    for (name, own) in shaking {
        columns.push(Column::real(name));
        values.push(over(own));
    }
    let mut notes = Vec::new();
    let settled = of_model(engine, traces, speed, &bearings.theta, &mut notes)?;
    columns.push(Column::real("torque_Nm"));
    values.push(settled.iter().map(|loads| loads[TORQUE]).collect());
    if engine.gas.is_some() {
        let gas = cylinder_gas(engine, traces, speed)?;
        for (place, (own, firing)) in gas.cylinders.iter().zip(&gas.firing_angles).enumerate() {
            columns.push(Column::real(format!("cylinder_{}_pressure_Pa", place + 1)));
            values.push(bearings.theta.iter().map(|theta| own.cylinder.at(theta - firing)).collect());
        }
    }
    let components = settled.first().map_or(0, Vec::len) - (TORQUE + 1);
    for place in 0..components {
        let axis = ["x", "y", "z"][place % 3];
        columns.push(Column::real(format!("mount_{}_{axis}_N", place / 3 + 1)));
        values.push(settled.iter().map(|loads| loads[TORQUE + 1 + place]).collect());
    }
    for main in &bearings.mains {
        let crank =
            if main.crankshaft > 1 { format!("_crankshaft_{}", main.crankshaft) } else { String::new() };
        for (axis, part) in [("x", 0), ("y", 1)] {
            columns.push(Column::real(format!("main_bearing_{}{crank}_{axis}_N", main.main)));
            let number = |force: &num_complex::Complex64| if part == 0 { force.re } else { force.im };
            values.push(main.load.load.iter().map(number).collect());
        }
    }
    let title = format!("{}: loads over one period at {:.1} rpm", engine.name, rpm(speed));
    Ok(LoadHistory { columns, rows: Rows::of(values.into_iter().map(Values::Real).collect()), title, notes })
}

/// Place of the torque among the loads of a [`LoadsModel`]; the forces on the mounts follow it.
const TORQUE: usize = 5;

/// The loads of the model at every angle.
fn of_model(
    engine: &Engine,
    traces: &[TraceFile],
    speed: f64,
    theta: &[f64],
    notes: &mut Vec<String>,
) -> Result<Vec<Vec<f64>>, LoadHistoryError> {
    let model = |with_mounts| LoadsModel::at_speed(engine.clone(), traces.to_vec(), speed, with_mounts);
    let mut model = match model(true) {
        Err(LoadsModelError::Mounts(error)) => {
            notes.push(format!("mounts are left out: {error}"));
            model(false)?
        }
        found => found?,
    };
    let has_gas = model.has_gas();
    Ok(theta.iter().map(|theta| model.at(speed, *theta, has_gas)).collect::<Result<_, _>>()?)
}
