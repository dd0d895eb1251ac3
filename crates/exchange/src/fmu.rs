//! Functional mock-up units (FMI 2.0 and 3.0, <https://fmi-standard.org>): the description of a model and the archive around it.
//!
//! ```
//! use lanchester_exchange::{FmiVersion, FmuDescription, FmuKind, FmuRole, FmuVariable, model_description};
//! let speed = FmuVariable {
//!     name: "speed".to_owned(),
//!     reference: 1,
//!     description: "Speed of crankshaft 1".to_owned(),
//!     role: FmuRole::Input,
//!     kind: FmuKind::Real { unit: "rad/s", start: Some(100.0), range: [Some(0.0), None] },
//! };
//! let description = FmuDescription {
//!     name: "one".to_owned(),
//!     identifier: "lanchester_loads".to_owned(),
//!     description: String::new(),
//!     program: "lanchester 0.1.0".to_owned(),
//!     token: "fnv1a-0".to_owned(),
//!     variables: vec![speed],
//!     stop: 0.1,
//!     step: 1e-4,
//! };
//! assert!(model_description(&description, FmiVersion::Two).contains("<Real unit=\"rad/s\" min=\"0\" start=\"100\"/>"));
//! ```

use std::fmt::Write as _;
use std::io::{self, Cursor, Write as _};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// Which standard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FmiVersion {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}

/// What a variable is to its model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FmuRole {
    /// Time: the independent variable.
    Time,
    /// Given from outside, at any time.
    Input,
    /// Given from outside before a run begins.
    Parameter,
    /// Computed.
    Output,
}

/// Type of a variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FmuKind {
    /// A number with its unit, and where it starts unless it is computed.
    Real {
        /// One of those that [`model_description`] knows: `1`, `s`, `m`, `m/s`, `rad`, `rad/s`, `rad/s2`, `N`, `N.m`.
        unit: &'static str,
        /// [unit]
        start: Option<f64>,
        /// Smallest and largest value that is accepted [unit].
        range: [Option<f64>; 2],
    },
    /// Yes or no, with its start.
    Boolean {
        /// At the start.
        start: bool,
    },
}

/// A variable of a model.
#[derive(Debug, Clone, PartialEq)]
pub struct FmuVariable {
    /// Its name.
    pub name: String,
    /// Its value reference, of its own.
    pub reference: u32,
    /// One sentence.
    pub description: String,
    /// What it is to the model.
    pub role: FmuRole,
    /// Its type.
    pub kind: FmuKind,
}

/// What `modelDescription.xml` says.
#[derive(Debug, Clone, PartialEq)]
pub struct FmuDescription {
    /// Name of the model.
    pub name: String,
    /// Name of the binary without its ending.
    pub identifier: String,
    /// One line.
    pub description: String,
    /// Program with its version.
    pub program: String,
    /// What the binary is handed to tell whether the archive is the one that it was made for.
    pub token: String,
    /// All variables.
    pub variables: Vec<FmuVariable>,
    /// End of an experiment to begin with [s].
    pub stop: f64,
    /// Its step [s].
    pub step: f64,
}

/// Units with the powers of kg, m, s and rad that they stand for.
const UNITS: [(&str, [i32; 4]); 9] = [
    ("1", [0, 0, 0, 0]),
    ("s", [0, 0, 1, 0]),
    ("m", [0, 1, 0, 0]),
    ("m/s", [0, 1, -1, 0]),
    ("rad", [0, 0, 0, 1]),
    ("rad/s", [0, 0, -1, 1]),
    ("rad/s2", [0, 0, -2, 1]),
    ("N", [1, 1, -2, 0]),
    ("N.m", [1, 2, -2, 0]),
];

/// Text of `modelDescription.xml` of a model for co-simulation.
pub fn model_description(model: &FmuDescription, version: FmiVersion) -> String {
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription\n");
    let mut head = |name: &str, value: &str| {
        let _ = writeln!(out, "  {name}=\"{}\"", escaped(value));
    };
    let (number, token, state) = match version {
        FmiVersion::Two => ("2.0", "guid", "canGetAndSetFMUstate"),
        FmiVersion::Three => ("3.0", "instantiationToken", "canGetAndSetFMUState"),
    };
    head("fmiVersion", number);
    head("modelName", &model.name);
    head(token, &model.token);
    if !model.description.is_empty() {
        head("description", &model.description);
    }
    head("generationTool", &model.program);
    head("variableNamingConvention", "flat");
    if version == FmiVersion::Two {
        head("numberOfEventIndicators", "0");
    }
    out.truncate(out.len() - 1);
    out += ">\n";
    let _ = writeln!(
        out,
        "  <CoSimulation modelIdentifier=\"{}\" canHandleVariableCommunicationStepSize=\"true\" {state}=\"true\"/>",
        escaped(&model.identifier)
    );
    out += "  <UnitDefinitions>\n";
    for (name, powers) in UNITS {
        let names = ["kg", "m", "s", "rad"];
        let powers = names.iter().zip(powers).filter(|(_, power)| *power != 0);
        let powers: String = powers.map(|(name, power)| format!(" {name}=\"{power}\"")).collect();
        let _ = writeln!(out, "    <Unit name=\"{name}\"><BaseUnit{powers}/></Unit>");
    }
    out += "  </UnitDefinitions>\n";
    let _ = writeln!(
        out,
        "  <DefaultExperiment startTime=\"0\" stopTime=\"{}\" stepSize=\"{}\"/>",
        model.stop, model.step
    );
    out += "  <ModelVariables>\n";
    // FMI 2.0 needs no variable for the time, and one library that many programs read it with (FMI Library) misses its start, which the standard forbids.
    let variables: Vec<&FmuVariable> = model
        .variables
        .iter()
        .filter(|own| version == FmiVersion::Three || own.role != FmuRole::Time)
        .collect();
    for variable in variables.iter().copied() {
        match version {
            FmiVersion::Two => push_two(&mut out, variable),
            FmiVersion::Three => push_three(&mut out, variable),
        }
    }
    out += "  </ModelVariables>\n  <ModelStructure>\n";
    let outputs: Vec<(usize, &FmuVariable)> =
        variables.iter().copied().enumerate().filter(|(_, own)| own.role == FmuRole::Output).collect();
    match version {
        FmiVersion::Two => {
            for list in ["Outputs", "InitialUnknowns"] {
                let _ = writeln!(out, "    <{list}>");
                for (place, _) in &outputs {
                    let _ = writeln!(out, "      <Unknown index=\"{}\"/>", place + 1);
                }
                let _ = writeln!(out, "    </{list}>");
            }
        }
        FmiVersion::Three => {
            for name in ["Output", "InitialUnknown"] {
                for (_, own) in &outputs {
                    let _ = writeln!(out, "    <{name} valueReference=\"{}\"/>", own.reference);
                }
            }
        }
    }
    out += "  </ModelStructure>\n</fmiModelDescription>\n";
    out
}

/// Causality and variability.
fn words(variable: &FmuVariable) -> [&'static str; 2] {
    let continuous = match variable.kind {
        FmuKind::Real { .. } => "continuous",
        FmuKind::Boolean { .. } => "discrete",
    };
    match variable.role {
        FmuRole::Time => ["independent", "continuous"],
        FmuRole::Input => ["input", continuous],
        FmuRole::Parameter => ["parameter", "fixed"],
        FmuRole::Output => ["output", continuous],
    }
}

/// Attributes of the type: unit, range and start.
fn typed(kind: FmuKind) -> (&'static str, String) {
    match kind {
        FmuKind::Real { unit, start, range: [min, max] } => {
            let attribute = |name: &str, value: Option<f64>| {
                value.map_or(String::new(), |value| format!(" {name}=\"{value}\""))
            };
            let all = [("min", min), ("max", max), ("start", start)];
            let attributes: String = all.into_iter().map(|(name, value)| attribute(name, value)).collect();
            ("Real", format!(" unit=\"{unit}\"{attributes}"))
        }
        FmuKind::Boolean { start } => ("Boolean", format!(" start=\"{start}\"")),
    }
}

fn push_two(out: &mut String, variable: &FmuVariable) {
    let [causality, variability] = words(variable);
    let (name, more) = typed(variable.kind);
    let _ = writeln!(
        out,
        "    <ScalarVariable name=\"{}\" valueReference=\"{}\" description=\"{}\" causality=\"{causality}\" \
         variability=\"{variability}\">\n      <{name}{more}/>\n    </ScalarVariable>",
        escaped(&variable.name),
        variable.reference,
        escaped(&variable.description),
    );
}

fn push_three(out: &mut String, variable: &FmuVariable) {
    let [causality, variability] = words(variable);
    let (name, more) = typed(variable.kind);
    let name = if name == "Real" { "Float64" } else { name };
    let _ = writeln!(
        out,
        "    <{name} name=\"{}\" valueReference=\"{}\" description=\"{}\" causality=\"{causality}\" \
         variability=\"{variability}\"{more}/>",
        escaped(&variable.name),
        variable.reference,
        escaped(&variable.description),
    );
}

/// As the value of an attribute; what XML cannot hold becomes a space.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            _ if letter.is_control() || matches!(letter, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            _ => out.push(letter),
        }
    }
    out
}

/// Folder of the binaries of a platform by `std::env::consts`; `None` for one that the standard does not name.
pub fn binaries_folder(version: FmiVersion, os: &str, arch: &str) -> Option<String> {
    let system = match os {
        "linux" => ["linux", "linux"],
        "macos" => ["darwin", "darwin"],
        "windows" => ["win", "windows"],
        _ => return None,
    };
    match (version, arch) {
        (FmiVersion::Two, "x86_64") => Some(format!("binaries/{}64", system[0])),
        (FmiVersion::Three, "x86_64" | "aarch64") => Some(format!("binaries/{arch}-{}", system[1])),
        _ => None,
    }
}

/// The archive of these files, by name and content: equal files give equal bytes.
///
/// # Errors
/// Where a file cannot be packed.
pub fn fmu_archive(files: &[(String, Vec<u8>)]) -> io::Result<Vec<u8>> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default())
        .unix_permissions(0o755);
    for (name, bytes) in files {
        archive.start_file(name.as_str(), options)?;
        archive.write_all(bytes)?;
    }
    Ok(archive.finish()?.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_users_stay_within_their_attributes() {
        assert_eq!(escaped("a \"b\" <c> & d\u{1}e"), "a &quot;b&quot; &lt;c&gt; &amp; d e");
    }

    #[test]
    fn platforms_have_the_folders_of_each_standard() {
        let folder = |version, os, arch| binaries_folder(version, os, arch);
        assert_eq!(folder(FmiVersion::Two, "linux", "x86_64").as_deref(), Some("binaries/linux64"));
        assert_eq!(folder(FmiVersion::Three, "macos", "aarch64").as_deref(), Some("binaries/aarch64-darwin"));
        assert_eq!(folder(FmiVersion::Two, "macos", "aarch64"), None);
        assert_eq!(folder(FmiVersion::Three, "freebsd", "x86_64"), None);
    }

    #[test]
    fn an_archive_depends_on_its_files_alone() {
        let files = [("modelDescription.xml".to_owned(), b"<a/>".to_vec())];
        let archive = fmu_archive(&files).unwrap();
        assert_eq!(archive, fmu_archive(&files).unwrap());
        assert!(archive.starts_with(b"PK"));
    }
}
