//! `lanchester report`: the page, and its figures as files.

use crate::arguments::ReportArguments;
use crate::commands::stress::say;
use crate::commands::{json, open, refused};
use crate::failure::{DONE, Failure};
use crate::figures::write_figures;
use crate::files::{Source, print, tell, write_result};
use crate::format::Format;
use crate::program::PROGRAM;
use crate::requests::loads::{internal_request, load_request};
use crate::trace_files::{read_mesh, trace_files};
use lanchester::file::EngineFile;
use lanchester::flex::crank_mesh::CrankMeshOptions;
use lanchester::mechanism::{LoadRequest, Loads, internal_cases, loads};
use lanchester::report::{
    ArrangementsInput, MeshOrigin, MeshOrigins, Provenance, Section, arrangements_report, bending_section,
    figures, loads_sections, motion_section,
};
use lanchester::task::option;
use lanchester::{
    EngineReport, ModesRequest, StaticRequest, StressMesh, arrangements, crank_modes, is_running,
    static_stress,
};
use lanchester_files::shown;
use std::path::{Path, PathBuf};

pub fn run(arguments: &ReportArguments, colour: bool) -> Result<u8, Failure> {
    let request = load_request(&arguments.request)?;
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.file.engine;
    let internal = internal_request(&arguments.request, request.samples)?;
    let (page, figures) = if arguments.all_arrangements {
        let loads = loads(engine, &request).map_err(refused)?;
        let internal = internal_cases(engine, &internal).map_err(refused)?;
        let warnings: Vec<String> = opened.warnings.iter().map(lanchester::in_one_line).collect();
        if let Some(output) = arguments.output.as_deref().filter(|output| form(output) != Form::Page) {
            return Err(Failure::input(
                format!("--all-arrangements writes a page, and {} is none", shown(output)),
                "name a file that ends in .html, or leave --all-arrangements out",
            ));
        }
        let page = arrangements_report(&ArrangementsInput {
            engine,
            arrangements: &arrangements(engine, &request).map_err(Failure::refused)?,
            provenance: &provenance(&opened.source, &loads, &request),
            warnings: &warnings,
        });
        let mut sections = loads_sections(engine, &loads);
        sections.extend(bending_section(engine, &internal));
        sections.push(motion_section(&loads));
        (page, figures(engine, &sections))
    } else {
        let traces =
            if is_running(&opened.file) { trace_files(engine, &arguments.file) } else { Ok(Vec::new()) };
        let traces = traces.as_deref().map_err(|failure| failure.message.clone());
        let mut report = EngineReport::new(&opened.file, &request, &internal, traces, &opened.warnings)
            .map_err(refused)?;
        if arguments.stress {
            report.add(stress_sections(arguments, &opened.file)?);
        }
        for warning in &report.warnings[report.told..] {
            tell(format_args!("warning: {warning}"));
        }
        let page = match arguments.output.as_deref().map_or(Form::Page, form) {
            Form::Page => report.page(&provenance(&opened.source, &report.loads, &request)),
            Form::Text => report.text(),
            Form::Csv => report.csv(),
        };
        (page, report.figures())
    };
    let ending = if arguments.all_arrangements { "-arrangements.html" } else { ".html" };
    let output = arguments.output.clone().unwrap_or_else(|| default_output(&arguments.file, ending));
    if output == Path::new("-") {
        if let Some(folder) = &arguments.figures {
            write_figures(folder, &arguments.file, &figures)?;
        }
        print(&page)?;
        return Ok(DONE);
    }
    write_result(&output, &arguments.file, &page)?;
    let mut written = vec![output];
    if let Some(folder) = &arguments.figures {
        written.extend(write_figures(folder, &arguments.file, &figures)?);
    }
    print(&match arguments.format {
        Format::Text => listed("", &written),
        Format::Json => json(&serde_json::json!({ "written": written }))?,
        Format::Csv => listed("written\n", &written),
    })?;
    Ok(DONE)
}

/// Chapters on the crankshaft as an elastic body.
fn stress_sections(arguments: &ReportArguments, file: &EngineFile) -> Result<Vec<Section>, Failure> {
    let usual = CrankMeshOptions { size: 14e-3, fillet_elements: 4, ..CrankMeshOptions::default() };
    let size =
        arguments.stress_size.as_deref().map(|text| option::length(text, "--stress-size")).transpose()?;
    let task = file.tasks.stress.as_ref();
    let mesh = StressMesh::of(task, 0, size, arguments.stress_fillet_elements, usual);
    let mesh = read_mesh(mesh, &arguments.file)?;
    let engine = &file.engine;
    let traces = trace_files(engine, &arguments.file)?;
    let request = StaticRequest { mesh: mesh.clone(), ..StaticRequest::default() };
    let stress = static_stress(engine, &traces, &request, &say).map_err(Failure::refused)?;
    // Frequencies do not need the fillets of stresses.
    let options = CrankMeshOptions { fillet_elements: 2, ..mesh.options };
    let origins = MeshOrigins { fillet_elements: MeshOrigin::Usual, ..mesh.origins };
    let mesh = StressMesh { options, origins, ..mesh };
    let request = ModesRequest { mesh, ..ModesRequest::default() };
    let modes = crank_modes(engine, &request, &say).map_err(Failure::refused)?;
    Ok(vec![stress.section(), modes.section()])
}

fn provenance(source: &Source, loads: &Loads, request: &LoadRequest) -> Provenance {
    lanchester::provenance(PROGRAM, &source.name, &source.text, loads, request)
}

fn listed(head: &str, written: &[PathBuf]) -> String {
    written.iter().fold(head.to_string(), |list, path| list + &shown(path) + "\n")
}

/// In which form a report is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Page,
    Text,
    Csv,
}

/// The form that the name of a file asks for.
fn form(output: &Path) -> Form {
    match output.extension().and_then(|ending| ending.to_str()) {
        Some("txt") => Form::Text,
        Some("csv") => Form::Csv,
        _ => Form::Page,
    }
}

/// `engines/twin.toml` -> `twin.html` in the current folder; standard input -> `engine.html`.
fn default_output(file: &Path, ending: &str) -> PathBuf {
    let stem = file.file_stem().filter(|_| file != Path::new("-")).unwrap_or("engine".as_ref());
    let mut name = stem.to_os_string();
    name.push(ending);
    PathBuf::from(name)
}
