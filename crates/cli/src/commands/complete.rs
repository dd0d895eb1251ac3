//! `lanchester complete`: typical values for what an engine file leaves out.

use crate::commands::open;
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::{print, rewrite, tell, write_new};
use crate::options::complete::CompleteArguments;
use lanchester::file::{CompleteError, Completed, EngineKind, TypicalSection, complete, difference, render};
use lanchester_files::shown;
use std::path::Path;

pub fn run(arguments: &CompleteArguments, colour: bool) -> Result<u8, Failure> {
    let path = &arguments.file;
    if arguments.write && path == Path::new("-") {
        return Err(Failure::input(
            "--write needs a file, got standard input",
            "give the path of the engine file",
        ));
    }
    let opened = open(path, colour)?;
    let (name, before) = (&opened.source.name, &opened.source.text);
    let sections: Vec<TypicalSection> =
        arguments.section.iter().filter_map(|word| TypicalSection::of_word(word)).collect();
    let kind = arguments.kind.as_deref().and_then(EngineKind::of_word);
    let completed = completed(before, &sections, kind, colour)?;
    tell_of(&completed, name);
    if arguments.dry_run {
        print(&difference(before, &completed.text, name))?;
    } else if arguments.write {
        if completed.text != *before {
            rewrite(path, before, &completed.text)?;
            tell(format_args!("written into {name}"));
        }
    } else if let Some(output) = &arguments.output {
        write_new(output, &completed.text)?;
        print(&format!("{}\n", shown(output)))?;
    } else {
        print(&completed.text)?;
    }
    let is_missed = completed.left_out.iter().any(|left| sections.contains(&left.section));
    Ok(if is_missed { NOT_AS_EXPECTED } else { DONE })
}

/// Tells what was added to the file of this name, and what was left out.
pub fn tell_of(completed: &Completed, name: &str) {
    let added: Vec<&str> = completed.added.iter().map(|section| section.word()).collect();
    match added.as_slice() {
        [] => tell(format_args!("{name} needs no typical values here")),
        added => tell(format_args!("typical values of kind {} for {}", completed.kind, added.join(", "))),
    }
    for left in &completed.left_out {
        tell(format_args!("{} is left out: {}", left.section, left.why));
    }
}

/// The text with typical values.
pub fn completed(
    text: &str,
    sections: &[TypicalSection],
    kind: Option<EngineKind>,
    colour: bool,
) -> Result<Completed, Failure> {
    complete(text, sections, kind).map_err(|error| {
        let (text, diagnostics) = match &error {
            CompleteError::File(diagnostics) => (text, diagnostics),
            CompleteError::Unfit { text, diagnostics, .. } => (text.as_str(), diagnostics),
            _ => return Failure::own(error),
        };
        eprint!("{}", render(diagnostics, "the completed file", text, colour));
        Failure::input(&error, "--section completes single sections, --kind another kind of engine")
    })
}
