//! `lanchester export fmu`: the loads, or the crank train at free speed, as a functional mock-up unit.

use crate::commands::open;
use crate::failure::Failure;
use crate::files::{tell, write_new};
use crate::options::export::{UnitArguments, UnitModel};
use crate::trace_files::trace_files;
use lanchester::exchange_formats::FmiVersion;
use lanchester::{CrankTrainModel, LoadsModel, UnitBinary, UnitParts, crank_train_unit, loads_unit};
use lanchester_files::shown;
use std::env::consts::{ARCH, DLL_PREFIX, DLL_SUFFIX, OS};
use std::path::PathBuf;

pub fn run(arguments: &UnitArguments, colour: bool) -> Result<(), Failure> {
    if arguments.output.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("fmu")) {
        return Err(Failure::input(
            format_args!("a unit is written as .fmu, got {}", shown(&arguments.output)),
            "give --output this ending: importers go by it",
        ));
    }
    let opened = open(&arguments.file, colour)?;
    let traces = trace_files(&opened.file.engine, &arguments.file)?;
    let version = if arguments.fmi == 2 { FmiVersion::Two } else { FmiVersion::Three };
    let parts = || -> Result<UnitParts<'_>, Failure> {
        Ok(UnitParts { engine_file: &opened.source.text, traces: &traces, binary: binary()?, version })
    };
    let unit = match arguments.model {
        UnitModel::Loads => {
            let engine = opened.file.engine.clone();
            let model = LoadsModel::new(engine, traces.clone()).map_err(Failure::refused)?;
            loads_unit(&model, parts()?)
        }
        UnitModel::CrankTrain => {
            let model = CrankTrainModel::new(&opened.file, &traces).map_err(Failure::refused)?;
            for note in model.notes() {
                tell(format_args!("note: {note}"));
            }
            crank_train_unit(&model, parts()?)
        }
    };
    let unit = unit.map_err(Failure::refused)?;
    write_new(&arguments.output, unit)
}

/// The binary that units hold: beside the program, or where packages put libraries.
fn binary() -> Result<UnitBinary, Failure> {
    let name = format!("{DLL_PREFIX}lanchester_fmu{DLL_SUFFIX}");
    let program = std::env::current_exe().map_err(Failure::own)?;
    let folder = program.parent().map(PathBuf::from).unwrap_or_default();
    let places = [folder.join(&name), folder.join("../lib/lanchester").join(&name)];
    match places.iter().find(|place| place.is_file()) {
        Some(place) => {
            let bytes = std::fs::read(place).map_err(Failure::own)?;
            Ok(UnitBinary { bytes, os: OS, arch: ARCH, suffix: DLL_SUFFIX })
        }
        None => Err(Failure::input(
            format_args!(
                "the binary for units is missing: neither {} nor {} is there",
                shown(&places[0]),
                shown(&places[1])
            ),
            "build it with `cargo build --release --package lanchester-cli --package lanchester-fmu` in a clone of Lanchester, and put it beside the program",
        )),
    }
}
