//! What the page needs to know at its start.

use crate::api::Api;
use crate::asker::Asker;
use crate::files::FileState;
use crate::problem::Problem;
use lanchester::file::{KeyTable, key_tables, templates};
use schemars::JsonSchema;
use serde::Serialize;

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
    let info = |template: &lanchester::file::Template| TemplateInfo {
        name: template.name,
        title: template.title,
        text: template.text,
    };
    Ok(Session {
        program: asker.studio.program.clone(),
        file: asker.studio.open_file(),
        folder: asker.studio.files.place(),
        files: asker.studio.files.names(),
        templates: templates().iter().map(info).collect(),
        tables: key_tables(),
    })
}
