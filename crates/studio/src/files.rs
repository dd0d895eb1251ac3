//! Opening and saving engine files.

use crate::api::Api;
use crate::folder::FileState;
use crate::problem::Problem;
use crate::server::Studio;
use schemars::JsonSchema;
use serde::Deserialize;
use std::sync::PoisonError;

/// Which file is opened.
#[derive(Debug, Deserialize, JsonSchema)]
struct OpenFile {
    /// Its name in the folder.
    name: String,
}

/// What is saved.
#[derive(Debug, Deserialize, JsonSchema)]
struct SaveFile {
    /// The name in the folder.
    name: String,
    /// The whole text.
    text: String,
    /// The revision that may be written over; `null` for a new file.
    revision: Option<String>,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post(
        "/api/file/open",
        "Opens an engine file of the folder; its changes on the disk are told from now on.",
        open,
    )
    .put(
        "/api/file",
        "Saves an engine file, whole or not at all; status 409 where it changed meanwhile.",
        save,
    )
}

fn open(studio: &Studio, question: OpenFile) -> Result<FileState, Problem> {
    let file = studio.folder.open(&question.name)?;
    *studio.open.lock().unwrap_or_else(PoisonError::into_inner) = Some(file.name.clone());
    Ok(file)
}

fn save(studio: &Studio, question: SaveFile) -> Result<FileState, Problem> {
    let file = studio.folder.save(&question.name, &question.text, question.revision.as_deref())?;
    *studio.open.lock().unwrap_or_else(PoisonError::into_inner) = Some(file.name.clone());
    Ok(file)
}
