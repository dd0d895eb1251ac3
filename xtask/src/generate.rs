//! Pages and pictures that the program writes.

use crate::command::quiet;
use crate::workspace::{program, root, scratch};
use anyhow::{Context, Result, bail};
use std::path::Path;
use std::process::Command;

/// Pages and pictures of the book, and the picture of the README.
const WRITTEN: [Written; 6] = [
    Written {
        file: "docs/src/engine-file.md",
        head: "# The engine file\n\nEvery table and key, as the reader knows them. `lanchester schema` gives the same to an editor.\n\n",
        arguments: &["schema", "--markdown"],
        figure: None,
    },
    Written {
        file: "docs/src/workshop-sheet.md",
        head: "# The workshop sheet\n\nEvery table and key. `lanchester schema --sheet` gives the same to an editor; the guide shows one [step by \
               step](guide/workshop.md).\n\n",
        arguments: &["schema", "--sheet", "--markdown"],
        figure: None,
    },
    Written {
        file: "docs/src/validation.md",
        head: "",
        arguments: &["validate", "--markdown"],
        figure: None,
    },
    Written {
        file: "docs/images/twin-spectrum.svg",
        head: "",
        arguments: &["report", "examples/twin-in-line-in-phase.toml", "--output", "-"],
        figure: Some("force-spectrum.svg"),
    },
    Written {
        file: "docs/src/images/arrangements.svg",
        head: "",
        arguments: &TWIN_SEARCH,
        figure: Some("arrangements.svg"),
    },
    Written {
        file: "docs/src/images/arrangement-drives.svg",
        head: "",
        arguments: &TWIN_SEARCH,
        figure: Some("drives.svg"),
    },
];

/// The guide's choice among the arrangements of an in-line twin.
const TWIN_SEARCH: [&str; 11] = [
    "balance",
    "examples/twin-in-line-in-phase.toml",
    "--search",
    "--mount-spacing",
    "176 mm",
    "--reference",
    "examples/in-line-4-long-stroke.toml",
    "--share",
    "1/2",
    "--choose",
    "+1 -1",
];

/// A file that the program writes.
struct Written {
    file: &'static str,
    /// What stands above it.
    head: &'static str,
    /// What makes the program print it.
    arguments: &'static [&'static str],
    /// The figure of the report that it is, where it is one.
    figure: Option<&'static str>,
}

impl Written {
    fn text(&self, program: &Path) -> Result<String> {
        let mut command = Command::new(program);
        command.args(self.arguments).current_dir(root());
        let body = match self.figure {
            None => quiet(&mut command)?,
            Some(figure) => {
                let folder = scratch("figures")?;
                quiet(command.arg("--figures").arg(&folder))?;
                std::fs::read_to_string(folder.join(figure)).with_context(|| format!("no figure {figure}"))?
            }
        };
        Ok(format!("{}{body}", self.head))
    }
}

/// Writes every file.
pub fn write() -> Result<()> {
    let program = program()?;
    for written in &WRITTEN {
        std::fs::write(root().join(written.file), written.text(&program)?)?;
        println!("{}", written.file);
    }
    Ok(())
}

/// Fails where a file is not what the program writes now.
pub fn check(program: &Path) -> Result<String> {
    let mut stale = Vec::new();
    for written in &WRITTEN {
        let kept = std::fs::read_to_string(root().join(written.file));
        if kept.with_context(|| format!("cannot read {}", written.file))? != written.text(program)? {
            stale.push(written.file);
        }
    }
    if !stale.is_empty() {
        bail!("stale: {}; run `cargo xtask generate`", stale.join(", "));
    }
    Ok(format!("{} files", WRITTEN.len()))
}
