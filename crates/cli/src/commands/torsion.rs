//! `lanchester torsion`: torsional vibration of the crankshaft with what it drives.

use crate::commands::stress::say;
use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::figures::write_figures;
use crate::files::{print, tell};
use crate::format::Format;
use crate::options::torsion::{AimOption, StiffnessOption, TorsionArguments, TorsionTable, TuneOption};
use crate::requests::stress::memory;
use crate::trace_files::trace_files;
use lanchester::flex::crank_mesh::CrankMeshOptions;
use lanchester::flex::statics::SolveOptions;
use lanchester::model::Engine;
use lanchester::report::{
    MeshedThrow, Table, TorsionResult, chain_table, critical_table, damped_mode_table, damper_table,
    holzer_table, meshed_throws_table, mode_table, shaft_order_table, shaft_table, star_table,
    time_energy_table, time_table, torsion_brief, torsion_csv, torsion_figures, torsion_inertia_table,
    torsion_speed_table, torsion_text, tuning_table, twist_order_table,
};
use lanchester::task::option;
use lanchester::torsion::{BALANCED, TuneAim, TuneFree};
use lanchester::value_list;
use lanchester::{TorsionRequest, meshed_throws, torsion};

pub fn run(arguments: &TorsionArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let mut request = request(arguments)?;
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.file.engine;
    let has_gas = engine.gas.is_some() && !arguments.inertia_only;
    let traces = if has_gas { trace_files(engine, &arguments.file)? } else { Vec::new() };
    request.meshed = by_elements(arguments, engine)?;
    let found = torsion(&opened.file, &traces, &request).map_err(Failure::refused)?;
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &arguments.file, &torsion_figures(&found))?;
    }
    let text = match (arguments.table, arguments.format) {
        (_, Format::Json) => json(&found)?,
        (Some(table), form) => {
            let tables = tables(&found, table)?;
            let of = |table: &Table| match form {
                Format::Csv => arguments.printed.csv(table.csv()),
                _ => arguments.printed.words(table.text()),
            };
            tables.iter().map(of).collect::<Vec<_>>().join("\n")
        }
        (None, Format::Csv) => arguments.printed.csv(torsion_csv(&found)),
        (None, Format::Text) => arguments.printed.text(|| torsion_text(&found), || torsion_brief(&found)),
    };
    print(&text)?;
    let mut status = DONE;
    if let Some(check) = found.time.as_ref().filter(|check| !check.is_balanced()) {
        tell(format_args!(
            "energies of the check in time do not balance: {:.1e} of the turnover is missing, allowed is {BALANCED:.0e}",
            check.energy_error()
        ));
        status = NOT_AS_EXPECTED;
    }
    if !found.is_within() {
        tell("a limit of [torsion] is not kept, or not known to be");
        status = NOT_AS_EXPECTED;
    }
    Ok(status)
}

/// Size of the elements of throws where nobody says [m].
const THROW_MESH: f64 = 0.01;

/// Stiffnesses of throws from a mesh, where they are asked for.
fn by_elements(arguments: &TorsionArguments, engine: &Engine) -> Result<Vec<MeshedThrow>, Failure> {
    if arguments.throws == StiffnessOption::KerWilson {
        return match arguments.size {
            Some(_) => {
                Err(Failure::input("--size is that of a mesh", "add --throws free or held, or leave it out"))
            }
            None => Ok(Vec::new()),
        };
    }
    let size = arguments.size.as_deref().map_or(Ok(THROW_MESH), |text| option::length(text, "--size"))?;
    let options = CrankMeshOptions { size, fillet_elements: 2, ..CrankMeshOptions::default() };
    let solve = SolveOptions { memory: memory(&arguments.memory)?, ..SolveOptions::default() };
    let held = arguments.throws == StiffnessOption::Held;
    meshed_throws(engine, options, solve, held, &say).map_err(Failure::refused)
}

fn request(arguments: &TorsionArguments) -> Result<TorsionRequest, Failure> {
    let speed = |text: &str, name| option::speed(text, name).map_err(Failure::from);
    let speeds = match &arguments.speeds {
        Some(list) => value_list(list, "--speeds", |one| speed(one, "--speeds"))?,
        None => Vec::new(),
    };
    Ok(TorsionRequest {
        speeds,
        highest_order: arguments.highest_order,
        without_gas: arguments.inertia_only,
        tune: arguments.tune.map(|free| match free {
            TuneOption::Damper => None,
            TuneOption::Damping => Some(TuneFree::Damping),
            TuneOption::Stiffness => Some(TuneFree::Stiffness),
            TuneOption::Both => Some(TuneFree::Both),
        }),
        aim: Some(match arguments.aim {
            AimOption::Twist => TuneAim::Twist,
            AimOption::Stress => TuneAim::Stress,
        }),
        time: arguments.check.as_deref().map(|text| speed(text, "--check")).transpose()?,
        meshed: Vec::new(),
    })
}

fn tables(found: &TorsionResult, table: TorsionTable) -> Result<Vec<Table>, Failure> {
    let some = |table: Option<Table>, message: &str, hint: &str| {
        table.map(|table| vec![table]).ok_or_else(|| Failure::input(message, hint))
    };
    Ok(match table {
        TorsionTable::Inertias => vec![torsion_inertia_table(found)],
        TorsionTable::Shafts => vec![chain_table(found)],
        TorsionTable::Throws if found.meshed.is_empty() => {
            return Err(Failure::input("no throw was meshed", "add `--throws free` or `--throws held`"));
        }
        TorsionTable::Throws => vec![meshed_throws_table(found)],
        TorsionTable::Modes => vec![mode_table(found)],
        TorsionTable::DampedModes => vec![damped_mode_table(found)],
        TorsionTable::Holzer => found.holzer.iter().map(|own| holzer_table(found, own)).collect(),
        TorsionTable::Criticals => vec![critical_table(found)],
        TorsionTable::Stars => vec![star_table(found)],
        TorsionTable::Torques => vec![shaft_table(found)],
        TorsionTable::Orders => vec![shaft_order_table(found)],
        TorsionTable::Speeds => vec![torsion_speed_table(found)],
        TorsionTable::TwistOrders => vec![twist_order_table(found)],
        TorsionTable::Damper => some(damper_table(found), "the engine has no damper", "give [damper]")?,
        TorsionTable::Tuning => some(tuning_table(found), "no damper was tuned", "add `--tune damper`")?,
        TorsionTable::Time => {
            let times = [time_table(found), time_energy_table(found)];
            let found: Vec<Table> = times.into_iter().flatten().collect();
            let is_asked = !found.is_empty();
            is_asked
                .then_some(found)
                .ok_or_else(|| Failure::input("no check in time was asked for", "add `--check '2000 rpm'`"))?
        }
    })
}
