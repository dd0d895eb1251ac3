//! Loads over time, as columns.

use crate::exchange::force_table::rpm;
use crate::pressure::measured::TraceFile;
use crate::torque_report::{TorqueReportError, bearing_report};
use lanchester_mechanism::{BearingPart, BearingRequest, LoadRequest, TorqueError, loads};
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
}

/// Time, crank angle, what shakes the block, and the force of every journal on its main bearing, over one period at constant speed from crank angle 0;
/// `speed` [rad/s], the highest of the engine where it is not given. What shakes the block is of inertia; bearings have the gas too where the
/// file gives it.
///
/// # Errors
/// [`TorqueReportError`] where the loads cannot be computed.
pub fn load_history(
    engine: &Engine,
    traces: &[TraceFile],
    speed: Option<f64>,
    samples: usize,
) -> Result<LoadHistory, TorqueReportError> {
    let speed = speed.unwrap_or(engine.speed.highest);
    let part = if engine.gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
    let request = BearingRequest { speed: Some(speed), part, counterweights: true, samples };
    let bearings = bearing_report(engine, traces, &request)?;
    let request = LoadRequest { speed: Some(speed), samples, ..LoadRequest::default() };
    let found = loads(engine, &request).map_err(TorqueError::from)?;
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
    Ok(LoadHistory { columns, rows: Rows::of(values.into_iter().map(Values::Real).collect()), title })
}
