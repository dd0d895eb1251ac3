//! `lanchester stress`: static stress, natural modes and exports of a crankshaft.

mod cycle;
mod safety;
mod said;

use self::safety::{endures, is_safe, wanted_safety};
pub(crate) use self::said::say;
use crate::commands::{Opened, json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::figures::write_figures;
use crate::files::{print, read_bytes_or_input, tell, write_result};
use crate::format::Format;
use crate::options::stress::{
    ExportArguments, FatigueArguments, MeshArguments, ModesArguments, ReduceArguments, RuleArguments,
    SolveArguments, StaticArguments, StressArguments, StressCommand,
};
use crate::requests::stress::{
    fatigue_request, memory, mesh, rule_mesh, rule_request, solve_options, static_request, support,
};
use crate::trace_files::trace_files;
use lanchester::flex::crank_case::CrankSupport;
use lanchester::flex::reduction::ReductionOptions;
use lanchester::flex::sparse::Precision;
use lanchester::flex::statics::SolveOptions;
use lanchester::report::{
    CrankModes, StaticStress, deck_csv, deck_text, fatigue_brief, fatigue_csv, fatigue_text, modes_brief,
    modes_csv, modes_text, reduced_brief, reduced_csv, reduced_text, rule_brief, rule_csv, rule_text,
    static_stress_brief, static_stress_csv, static_stress_text,
};
use lanchester::{
    ModesRequest, StaticRequest, SubmodelRequest, case_deck, case_glb, case_stl, case_vtu, cases_pvd,
    converged_modes, converged_stress, crank_fatigue, crank_modes, crank_rule, crank_rule_of_file,
    crank_rule_with_torsion, modes_deck, modes_glb, modes_vtu, reduced_crank, solve_deck, static_stress,
    with_element_factors,
};
use std::path::Path;

pub fn run(arguments: &StressArguments, colour: bool) -> Result<u8, Failure> {
    match &arguments.command {
        StressCommand::Static(arguments) => statics(arguments, colour),
        StressCommand::Modes(arguments) => modes(arguments, colour),
        StressCommand::Export(arguments) => export(arguments, colour),
        StressCommand::Reduce(arguments) => reduce(arguments, colour),
        StressCommand::Fatigue(arguments) => fatigue(arguments, colour),
        StressCommand::Cycle(arguments) => cycle::cycle(arguments, colour),
        StressCommand::Rule(arguments) => rule(arguments, colour),
        StressCommand::Solve(arguments) => solve(arguments),
    }
}

fn solved(
    opened: &Opened,
    own: &MeshArguments,
    request: &StaticRequest,
    converge: bool,
) -> Result<StaticStress, Failure> {
    let engine = &opened.file.engine;
    let traces = if request.gas { trace_files(engine, &own.file)? } else { Vec::new() };
    let found = match converge {
        true => converged_stress(engine, &traces, request, &say),
        false => static_stress(engine, &traces, request, &say),
    };
    found.map_err(Failure::refused)
}

fn statics(arguments: &StaticArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let own = &arguments.mesh;
    let safety = wanted_safety(arguments.safety)?;
    let opened = open(&own.file, colour)?;
    let submodel = arguments.submodel.map(|throw| SubmodelRequest {
        throw: throw as usize,
        fillet_elements: arguments.submodel_elements.map(|count| count as usize),
    });
    let plain = static_request(&opened.file, own, &arguments.load, &arguments.support)?;
    let request = StaticRequest { submodel, ..plain };
    let found = solved(&opened, own, &request, arguments.converge)?;
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &own.file, &found.figures())?;
    }
    print(&match arguments.format {
        Format::Text => arguments.printed.text(|| static_stress_text(&found), || static_stress_brief(&found)),
        Format::Json => json(&found)?,
        Format::Csv => arguments.printed.csv(static_stress_csv(&found)),
    })?;
    Ok(if is_safe(found.least_safety(), safety) { DONE } else { NOT_AS_EXPECTED })
}

fn found_modes(
    opened: &Opened,
    own: &MeshArguments,
    held: CrankSupport,
    count: u32,
    [converge, count_modes]: [bool; 2],
) -> Result<CrankModes, Failure> {
    let request = ModesRequest {
        mesh: mesh(own, &opened.file, 2)?,
        support: held,
        count: count as usize,
        solve: SolveOptions { count_modes, ..solve_options(own)? },
    };
    let engine = &opened.file.engine;
    let found = match converge {
        true => converged_modes(engine, &request, &say),
        false => crank_modes(engine, &request, &say),
    };
    found.map_err(Failure::refused)
}

fn modes(arguments: &ModesArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let held = support(&arguments.support, CrankSupport::Free)?;
    let opened = open(&arguments.mesh.file, colour)?;
    let studied = [arguments.converge, arguments.count];
    let found = found_modes(&opened, &arguments.mesh, held, arguments.number, studied)?;
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &arguments.mesh.file, &found.figures())?;
    }
    print(&match arguments.format {
        Format::Text => arguments.printed.text(|| modes_text(&found), || modes_brief(&found)),
        Format::Json => json(&found)?,
        Format::Csv => arguments.printed.csv(modes_csv(&found)),
    })?;
    let is_complete = found.modes.count.is_none_or(|count| count.missing() == Some(0));
    Ok(if is_complete { DONE } else { NOT_AS_EXPECTED })
}

fn export(arguments: &ExportArguments, colour: bool) -> Result<u8, Failure> {
    let (own, path) = (&arguments.mesh, arguments.output.as_path());
    let form = Form::of(path)?;
    if let Some(factor) = arguments.deformation {
        if !factor.is_finite() {
            return Err(Failure::input(
                format_args!("--deformation needs a number, got {factor}"),
                "for example --deformation 100",
            ));
        }
        if matches!(form, Form::Deck | Form::Vtu | Form::Pvd) {
            return Err(Failure::input(
                "--deformation is that of .glb and .stl",
                "leave it out: other programs scale by themselves",
            ));
        }
    }
    let opened = open(&own.file, colour)?;
    let written = match arguments.modes {
        Some(count) => {
            let held = support(&arguments.support, CrankSupport::Free)?;
            let found = found_modes(&opened, own, held.clone(), count, [false; 2])?;
            match form {
                Form::Deck => {
                    modes_deck(&found, &held, count as usize).map_err(Failure::refused)?.into_bytes()
                }
                Form::Vtu => modes_vtu(&found),
                Form::Glb => modes_glb(&found, arguments.deformation).map_err(Failure::refused)?,
                Form::Stl | Form::Pvd => {
                    return Err(Failure::input(
                        "an STL file holds one shape, a .pvd file load cases",
                        "write modes into a .glb or .vtu file",
                    ));
                }
            }
        }
        None => {
            let request = static_request(&opened.file, own, &arguments.load, &arguments.support)?;
            let found = solved(&opened, own, &request, false)?;
            let case = found.worst().ok_or_else(|| Failure::own("a solution has a case"))?;
            if !matches!(form, Form::Pvd) {
                tell(format_args!("writing the case: {}", case.name));
            }
            match form {
                Form::Deck => {
                    case_deck(&found, case, &request.support).map_err(Failure::refused)?.into_bytes()
                }
                Form::Vtu => case_vtu(&found, case),
                Form::Pvd => return write_cases(&found, path, &own.file),
                Form::Glb => case_glb(&found, case, arguments.deformation).map_err(Failure::refused)?,
                Form::Stl => {
                    case_stl(&found, case, arguments.deformation.unwrap_or(0.0)).map_err(Failure::refused)?
                }
            }
        }
    };
    write_result(path, &own.file, &written)?;
    tell(format_args!("{} written", lanchester_files::shown(path)));
    Ok(DONE)
}

/// Writes all load cases beside the file that lists them.
fn write_cases(found: &StaticStress, path: &Path, engine_file: &Path) -> Result<u8, Failure> {
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let (collection, cases) = cases_pvd(found, &stem);
    for (name, content) in cases {
        write_result(&path.with_file_name(name), engine_file, &content)?;
    }
    write_result(path, engine_file, &collection)?;
    tell(format_args!(
        "{} written, with {} load cases beside it",
        lanchester_files::shown(path),
        found.cases.len()
    ));
    Ok(DONE)
}

fn reduce(arguments: &ReduceArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let own = &arguments.mesh;
    if let Some(path) = arguments.output.as_deref() {
        ends_in(path, "npz")?;
    }
    let options = ReductionOptions { modes: arguments.modes as usize, memory: memory(&own.memory)? };
    let opened = open(&own.file, colour)?;
    let found = reduced_crank(&opened.file.engine, &mesh(own, &opened.file, 2)?, options, &say)
        .map_err(Failure::refused)?;
    if let Some(path) = &arguments.output {
        write_result(path, &own.file, &found.model.to_npz())?;
        tell(format_args!("{} written", lanchester_files::shown(path)));
    }
    print(&match arguments.format {
        Format::Text => arguments.printed.text(|| reduced_text(&found), || reduced_brief(&found)),
        Format::Json => json(&found)?,
        Format::Csv => arguments.printed.csv(reduced_csv(&found)),
    })?;
    Ok(DONE)
}

fn fatigue(arguments: &FatigueArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let own = &arguments.mesh;
    let opened = open(&own.file, colour)?;
    let request = fatigue_request(arguments, &opened.file)?;
    let engine = &opened.file.engine;
    let traces = if request.gas { trace_files(engine, &own.file)? } else { Vec::new() };
    let found = crank_fatigue(engine, &traces, &request, &say).map_err(Failure::refused)?;
    print(&match arguments.format {
        Format::Text => arguments.printed.text(|| fatigue_text(&found), || fatigue_brief(&found)),
        Format::Json => json(&found)?,
        Format::Csv => arguments.printed.csv(fatigue_csv(&found)),
    })?;
    let Some((speed, fillet)) = found.weakest() else { return Ok(DONE) };
    let under = format!("{:.0} rpm", speed * 60.0 / std::f64::consts::TAU);
    Ok(if endures(fillet, &under, arguments.safety) { DONE } else { NOT_AS_EXPECTED })
}

fn rule(arguments: &RuleArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let request = rule_request(arguments)?;
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.file.engine;
    let traces = if request.gas { trace_files(engine, &arguments.file)? } else { Vec::new() };
    let found = match (arguments.with_torsion, arguments.without_torsion) {
        (true, _) => crank_rule_with_torsion(&opened.file, &traces, &request).map_err(Failure::refused)?,
        (_, true) => crank_rule(engine, &traces, &request).map_err(Failure::refused)?,
        _ => crank_rule_of_file(&opened.file, &traces, &request).map_err(Failure::refused)?,
    };
    let found = match arguments.finite_elements {
        true => {
            let mesh = rule_mesh(arguments, &opened.file)?;
            let memory = arguments.memory.as_deref().map(memory).transpose()?;
            let usual = SolveOptions::default();
            let solve = SolveOptions { memory: memory.unwrap_or(usual.memory), ..usual };
            with_element_factors(engine, found, &mesh, solve, &say).map_err(Failure::refused)?
        }
        false => found,
    };
    print(&match arguments.format {
        Format::Text => arguments.printed.text(|| rule_text(&found), || rule_brief(&found)),
        Format::Json => json(&found)?,
        Format::Csv => arguments.printed.csv(rule_csv(&found)),
    })?;
    Ok(if found.is_accepted() { DONE } else { NOT_AS_EXPECTED })
}

fn solve(arguments: &SolveArguments) -> Result<u8, Failure> {
    if let Some(path) = arguments.output.as_deref() {
        ends_in(path, "vtu")?;
    }
    let precision = if arguments.double { Precision::Double } else { Precision::Single };
    let memory = memory(&arguments.memory)?;
    let options =
        SolveOptions { precision, memory, coarse_mass: arguments.calculix_mass, ..SolveOptions::default() };
    let bytes =
        read_bytes_or_input(&arguments.file, "give the path of a CalculiX deck, or - for standard input")?;
    let text = String::from_utf8(bytes)
        .map_err(|_| Failure::input("a deck is text in ASCII or UTF-8", "is this the right file?"))?;
    let (found, pictures) = solve_deck(&text, options, &say).map_err(Failure::refused)?;
    if let Some(path) = &arguments.output {
        write_result(path, &arguments.file, &pictures)?;
        tell(format_args!("{} written", lanchester_files::shown(path)));
    }
    print(&match arguments.format {
        Format::Text => deck_text(&found),
        Format::Json => json(&found)?,
        Format::Csv => deck_csv(&found),
    })?;
    Ok(DONE)
}

fn ends_in(path: &Path, ending: &str) -> Result<(), Failure> {
    let own = path.extension().map(|own| own.to_string_lossy().to_lowercase());
    if own.as_deref() == Some(ending) {
        return Ok(());
    }
    Err(Failure::input(
        format_args!("--output needs a name that ends in .{ending}, got {}", lanchester_files::shown(path)),
        format_args!("for example --output crank.{ending}"),
    ))
}

/// Forms of an export, by the ending of its name.
enum Form {
    Deck,
    Vtu,
    Pvd,
    Glb,
    Stl,
}

impl Form {
    fn of(path: &Path) -> Result<Form, Failure> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("inp") => Ok(Form::Deck),
            Some("vtu") => Ok(Form::Vtu),
            Some("pvd") => Ok(Form::Pvd),
            Some("glb") => Ok(Form::Glb),
            Some("stl") => Ok(Form::Stl),
            _ => Err(Failure::input(
                format_args!(
                    "--output needs a name that ends in .inp, .vtu, .pvd, .glb or .stl, got {}",
                    lanchester_files::shown(path)
                ),
                "for example --output case.vtu",
            )),
        }
    }
}
