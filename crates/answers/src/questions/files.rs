//! Opening and saving engine files.

use crate::api::Api;
use crate::asker::Asker;
use crate::files::FileState;
use crate::problem::Problem;
use schemars::JsonSchema;
use serde::Deserialize;

/// Which file is opened.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct OpenFile {
    /// Its name in the folder.
    name: String,
}

/// What is saved.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
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
        "Saves an engine file, whole or not at all; status 409 where it was changed or removed meanwhile, or exists.",
        save,
    )
}

fn open(asker: &Asker, question: OpenFile) -> Result<FileState, Problem> {
    let file = asker.studio.files.open(&question.name)?;
    asker.studio.opened(&file.name);
    Ok(file)
}

fn save(asker: &Asker, question: SaveFile) -> Result<FileState, Problem> {
    let file = asker.studio.files.save(&question.name, &question.text, question.revision.as_deref())?;
    asker.studio.opened(&file.name);
    Ok(file)
}
