//! `lanchester torque`: what gas and inertia do to the crank.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure};
use crate::figures::write_figures;
use crate::files::{print, tell};
use crate::format::Format;
use crate::options::torque::{LeverOption, TorqueArguments, TorqueTable};
use crate::trace_files::trace_files;
use lanchester::mechanism::{Lever, TorqueRequest};
use lanchester::model::Friction;
use lanchester::report::{
    Figure, Table, cycle_angle_table, cycle_figures, cycle_table, flywheel_table, power_figure, power_table,
    ripple_figure, ripple_table, torque_brief, torque_csv, torque_figures, torque_speeds_table, torque_text,
};
use lanchester::task::option;
use lanchester::{TorqueReport, TorqueReportRequest, torque_report};

pub fn run(arguments: &TorqueArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let mut request = request(arguments)?;
    let opened = open(&arguments.file, colour)?;
    request.simulation.clone_from(&opened.file.tasks.simulation);
    let traces = trace_files(&opened.file.engine, &arguments.file)?;
    let report = torque_report(&opened.file.engine, &traces, &request).map_err(Failure::refused)?;
    for warning in &report.warnings {
        tell(format_args!("warning: {warning}"));
    }
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &arguments.file, &figures(&report))?;
    }
    if let Some(table) = arguments.table {
        let table = one_table(&report, table)?;
        match arguments.format {
            Format::Text => print(&arguments.printed.words(table.text()))?,
            Format::Csv => print(&arguments.printed.csv(table.csv()))?,
            Format::Json => print(&json(&report)?)?,
        }
        return Ok(DONE);
    }
    print(&match arguments.format {
        Format::Text => arguments.printed.text(
            || text(&report),
            || {
                // At the speed of the headline; the file's flywheel may name others.
                let at = |speed: f64| (speed - report.torque.speed).abs() <= 1e-9 * report.torque.speed;
                let mut ripples = report.ripples.iter().filter_map(|ripple| ripple.periodic());
                let own = ripples.find(|ripple| report.is_driven_besides && at(ripple.mean_speed));
                let driven = own.map(|ripple| ripple.excess);
                torque_brief(&report.torque, report.brake.as_ref(), report.flywheel.as_ref(), driven)
            },
        ),
        Format::Json => json(&report)?,
        Format::Csv => arguments.printed.csv(torque_csv(&report.torque)),
    })?;
    Ok(DONE)
}

fn request(arguments: &TorqueArguments) -> Result<TorqueReportRequest, Failure> {
    let speed = |text: &str, name| option::speed(text, name).map_err(Failure::from);
    let inertia = |text: &Option<String>, name| {
        text.as_deref().map(|text| option::inertia(text, name).map_err(Failure::from)).transpose()
    };
    let speeds = arguments.speeds.as_deref().map_or(Ok(Vec::new()), |list| {
        list.split(',').map(|one| speed(one.trim(), "--speeds")).collect::<Result<Vec<f64>, Failure>>()
    })?;
    let fmep = arguments.fmep.as_deref().map(|text| option::pressure(text, "--fmep").map_err(Failure::from));
    let fluctuation = arguments
        .fluctuation
        .as_deref()
        .map(|text| option::share(text, "--fluctuation").map_err(Failure::from));
    Ok(TorqueReportRequest {
        simulation: None,
        torque: TorqueRequest {
            speed: arguments.speed.as_deref().map(|text| speed(text, "--speed")).transpose()?,
            lever: match arguments.lever {
                LeverOption::Exact => Lever::Exact,
                LeverOption::Sine => Lever::Sine,
            },
            max_order: arguments.orders,
            samples: arguments.samples as usize,
            ..TorqueRequest::default()
        },
        speeds,
        friction: fmep.transpose()?.map(|fmep| Friction::Given { fmep }),
        flywheel: inertia(&arguments.flywheel, "--flywheel")?,
        crankshaft: inertia(&arguments.crankshaft_inertia, "--crankshaft-inertia")?,
        fluctuation: fluctuation.transpose()?,
    })
}

fn one_table(report: &TorqueReport, table: TorqueTable) -> Result<Table, Failure> {
    let none = |message: &str| Err(Failure::refused(message.to_owned()));
    match table {
        TorqueTable::Cycle | TorqueTable::CycleAngle if !report.torque.with_gas => none(
            "the engine file says nothing of the gas: there is no cycle\nhint: add [gas] with [gas.cycle]",
        ),
        TorqueTable::Cycle | TorqueTable::CycleAngle if report.cycles.is_empty() => none(
            "the pressures are measured: there is no computed cycle\nhint: give [gas.cycle] in place of [[gas.trace]]",
        ),
        TorqueTable::Cycle => Ok(cycle_table(&report.cycles)),
        TorqueTable::CycleAngle => Ok(cycle_angle_table(&report.cycles)),
        TorqueTable::SpeedRipple => Ok(ripple_table(&report.ripples)),
        TorqueTable::Speeds if report.speeds.is_empty() => {
            none("no speeds are asked for\nhint: add --speeds '1000 rpm, 2000 rpm, 3000 rpm'")
        }
        TorqueTable::Speeds => Ok(torque_speeds_table(&report.speeds)),
    }
}

fn text(report: &TorqueReport) -> String {
    let mut out = torque_text(&report.torque, report.brake.as_ref());
    let tables = [
        (!report.cycles.is_empty()).then(|| cycle_table(&report.cycles)),
        Some(ripple_table(&report.ripples)),
        report.flywheel.as_ref().map(flywheel_table),
        (!report.speeds.is_empty()).then(|| torque_speeds_table(&report.speeds)),
        report.power.as_ref().map(power_table),
    ];
    for table in tables.into_iter().flatten() {
        out.push('\n');
        out.push_str(&table.text());
    }
    if report.torque.with_gas { out + &format!("\nPressures: {}.\n", report.source) } else { out }
}

fn figures(report: &TorqueReport) -> Vec<Figure> {
    let mut figures = torque_figures(&report.torque);
    if !report.cycles.is_empty() {
        figures.extend(cycle_figures(&report.cycles));
    }
    figures.extend(ripple_figure(&report.ripples));
    figures.extend(report.power.as_ref().map(power_figure));
    figures
}
