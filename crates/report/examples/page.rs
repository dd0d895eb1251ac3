//! Renders the report of an engine file, and on request every figure as a file of its own:
//!
//! ```text
//! cargo run -p lanchester-report --example page -- engine.toml report.html [figures/]
//! ```

use lanchester_mechanism::{InternalRequest, LoadRequest, internal_cases, loads};
use lanchester_report::{
    Provenance, ReportHead, bending_section, engine_section, figures, loads_sections, motion_section,
    peaks_in_short, report,
};
use std::error::Error;
use std::{env, fs, path::Path};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let (input, output) = match arguments.as_slice() {
        [input, output, ..] => (input, output),
        _ => return Err("needs an engine file and the name of the page to write".into()),
    };
    let text = fs::read_to_string(input)?;
    let reading = lanchester_file::read(&text);
    let Some(engine) = reading.engine() else {
        return Err(lanchester_file::render(&reading.diagnostics, input, &text, false).into());
    };
    let warnings: Vec<String> = reading.diagnostics.iter().map(|d| d.message.clone()).collect();
    let request = LoadRequest::default();
    let loads = loads(&engine, &request)?;
    let internal = internal_cases(&engine, &InternalRequest::default())?;
    let provenance = Provenance {
        program: concat!("lanchester ", env!("CARGO_PKG_VERSION")).to_owned(),
        input: Path::new(input).file_name().unwrap_or_default().to_string_lossy().into_owned(),
        input_hash: String::new(),
        settings: vec![
            ("motion".to_owned(), loads.kinematics.clone()),
            ("highest order".to_owned(), request.max_order.to_string()),
            ("angles per revolution".to_owned(), request.samples.to_string()),
        ],
    };
    let mut sections = loads_sections(&engine, &loads);
    sections.extend(bending_section(&engine, &internal));
    sections.extend([motion_section(&loads), engine_section(&engine)]);
    let key_numbers = peaks_in_short(&loads);
    let head = ReportHead {
        engine: &engine,
        speed: loads.speed,
        provenance: &provenance,
        warnings: &warnings,
        key_numbers: &key_numbers,
    };
    fs::write(output, report(&head, &sections))?;
    if let Some(folder) = arguments.get(2) {
        fs::create_dir_all(folder)?;
        for figure in figures(&engine, &sections) {
            fs::write(Path::new(folder).join(format!("{}.svg", figure.id)), figure.svg())?;
        }
    }
    Ok(())
}
