//! What the page needs to know at its start.

use crate::api::Api;
use crate::asker::Asker;
use crate::folder::FileState;
use crate::problem::Problem;
use lanchester::file::{KeyTable, key_tables, templates};
use schemars::JsonSchema;
use serde::Serialize;
use std::sync::PoisonError;

/// The start of a session.
#[derive(Debug, Serialize, JsonSchema)]
struct Session {
    /// Name, version and commit of the program.
    program: String,
    /// The file that was opened or saved last.
    file: Option<FileState>,
    /// The folder of the files.
    folder: String,
    /// Engine files in it.
    files: Vec<String>,
    /// The gallery.
    templates: Vec<TemplateInfo>,
    /// Every table and key of the engine file.
    tables: Vec<KeyTable>,
}

/// An engine of the gallery.
#[derive(Debug, Serialize, JsonSchema)]
struct TemplateInfo {
    name: &'static str,
    /// What it is.
    title: &'static str,
    /// The engine file.
    text: &'static str,
}

pub(crate) fn questions(api: Api) -> Api {
    api.get("/api/session", "What the page needs to know at its start.", session)
}

fn session(asker: &Asker) -> Result<Session, Problem> {
    let open = asker.studio.open.lock().unwrap_or_else(PoisonError::into_inner).clone();
    let info = |template: &lanchester::file::Template| TemplateInfo {
        name: template.name,
        title: template.title,
        text: template.text,
    };
    Ok(Session {
        program: asker.studio.program.clone(),
        file: open.and_then(|name| asker.studio.folder.open(&name).ok()),
        folder: asker.studio.folder.name(),
        files: asker.studio.folder.names(),
        templates: templates().iter().map(info).collect(),
        tables: key_tables(),
    })
}
