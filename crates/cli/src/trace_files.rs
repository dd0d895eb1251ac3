//! The files of pressure, of torque and of a mesh that an engine file names: read from its folder.

use crate::failure::Failure;
use crate::files::read_bytes;
use lanchester::file::EngineFile;
use lanchester::model::Engine;
use lanchester::{MeshFile, StressMesh, TraceFile, give_torques, torque_file_names, trace_names};
use std::path::Path;

/// The files of pressure that the engine asks for, from the folder of its own file (standard input: from the working folder).
pub fn trace_files(engine: &Engine, engine_file: &Path) -> Result<Vec<TraceFile>, Failure> {
    let hint = "[gas] names it: give its place from the folder of the engine file";
    read_beside(trace_names(engine), engine_file, hint)
}

/// Gives an engine file the torques of the files that it names, from its own folder.
pub fn read_torques(file: &mut EngineFile, engine_file: &Path) -> Result<(), Failure> {
    let hint = "[simulation] names it: give its place from the folder of the engine file";
    let files = read_beside(torque_file_names(file), engine_file, hint)?;
    give_torques(file, &files).map_err(Failure::refused)
}

/// Reads the mesh of a crankshaft that the engine file names, from its own folder.
pub fn read_mesh(mesh: StressMesh, engine_file: &Path) -> Result<StressMesh, Failure> {
    let Some(own) = &mesh.own else { return Ok(mesh) };
    let hint = "[crank.mesh] names it: give its place from the folder of the engine file";
    let text =
        read_beside(vec![&own.name], engine_file, hint)?.into_iter().next().map(|file| file.text.into());
    Ok(StressMesh { own: Some(MeshFile { name: own.name.clone(), text }), ..mesh })
}

fn read_beside(names: Vec<&str>, engine_file: &Path, hint: &str) -> Result<Vec<TraceFile>, Failure> {
    let folder = engine_file.parent().unwrap_or(Path::new(""));
    names
        .into_iter()
        .map(|name| {
            let bytes = read_bytes(&folder.join(name), hint)?;
            let text = String::from_utf8(bytes).map_err(|error| {
                Failure::input(
                    format_args!("{name} is not UTF-8 text (byte {})", error.utf8_error().valid_up_to()),
                    "save it as text in UTF-8",
                )
            })?;
            Ok(TraceFile { name: name.to_string(), text })
        })
        .collect()
}
