//! A file that the program writes, and the way to ask for it.

use super::panels;
use crate::command::quiet;
use crate::documents::file_of;
use crate::workspace::{root, scratch};
use anyhow::{Context, Result};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A file that the program writes.
#[derive(Clone, Copy)]
pub struct Written {
    /// Where it stands in the repository.
    pub file: &'static str,
    /// What stands above it.
    pub head: &'static str,
    /// The page and the file on it that the program reads on standard input.
    pub input: Option<(&'static str, &'static str)>,
    /// What makes the program print it.
    pub arguments: &'static [&'static str],
    /// The figure of the report that it is, where it is one.
    pub figure: Option<&'static str>,
    /// The drawings of the figure that are shown, one below the other; none: the figure as it is.
    pub panels: &'static [usize],
    /// The program writes one figure and wants the name of its file, not of a folder.
    pub one_figure: bool,
}

/// Folders of figures by what the program was asked for: several pictures come of one run.
pub type Figures = BTreeMap<(Option<(&'static str, &'static str)>, &'static [&'static str]), PathBuf>;

impl Written {
    /// What the program prints.
    pub const fn page(file: &'static str, head: &'static str, arguments: &'static [&'static str]) -> Written {
        Written { file, head, input: None, arguments, figure: None, panels: &[], one_figure: false }
    }

    /// A figure that the program writes.
    pub const fn figure(
        file: &'static str,
        arguments: &'static [&'static str],
        figure: &'static str,
    ) -> Written {
        Written {
            file,
            head: "",
            input: None,
            arguments,
            figure: Some(figure),
            panels: &[],
            one_figure: false,
        }
    }

    /// Its text.
    pub fn text(&self, program: &Path, figures: &mut Figures) -> Result<String> {
        let Some(figure) = self.figure else {
            return Ok(format!("{}{}", self.head, quiet(&mut self.command(program)?)?));
        };
        let asked = (self.input, self.arguments);
        let folder = match figures.get(&asked) {
            Some(folder) => folder.clone(),
            None => {
                let folder = scratch(&format!("figures-{}", figures.len()))?;
                let mut command = self.command(program)?;
                match self.one_figure {
                    true => command.arg("--figure").arg(folder.join(figure)),
                    false => command.arg("--figures").arg(&folder),
                };
                quiet(&mut command)?;
                figures.insert(asked, folder.clone());
                folder
            }
        };
        let body =
            std::fs::read_to_string(folder.join(figure)).with_context(|| format!("no figure {figure}"))?;
        let shown = if self.panels.is_empty() { body } else { panels::arranged(&body, self.panels)? };
        Ok(format!("{}{shown}", self.head))
    }

    fn command(&self, program: &Path) -> Result<Command> {
        let mut command = Command::new(program);
        command.args(self.arguments).current_dir(root());
        if let Some((page, name)) = self.input {
            let input = scratch("input")?.join(name);
            std::fs::write(&input, file_of(page, name)?)?;
            command.stdin(std::fs::File::open(&input)?);
        }
        Ok(command)
    }
}
