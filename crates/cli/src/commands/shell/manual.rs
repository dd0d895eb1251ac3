//! `lanchester manual`: pages for `man`.

use crate::arguments::{Arguments, ManualArguments};
use crate::failure::{DONE, Failure};
use crate::files::print;
use clap::{Command, CommandFactory};
use std::fmt::Write;

pub fn run(arguments: &ManualArguments) -> Result<u8, Failure> {
    // Built: subcommands have the options of the program and their full names.
    let mut program = Arguments::command();
    program.build();
    if arguments.list {
        let mut names = String::new();
        list(&program, &mut names);
        print(&names)?;
        return Ok(DONE);
    }
    let command = arguments.command.iter().try_fold(&program, |above, name| {
        above.find_subcommand(name).ok_or_else(|| {
            Failure::input(
                format_args!("`{}` has no command `{name}`", full_name(above)),
                "`lanchester manual --list` lists all that have a page",
            )
        })
    })?;
    print(&page(command)?)?;
    Ok(DONE)
}

/// The page of a command as `man` reads it.
fn page(command: &Command) -> Result<String, Failure> {
    let name = full_name(command).replace(' ', "-");
    let mut page = Vec::new();
    let written = clap_mangen::Man::new(command.clone().display_name(name.clone()))
        .title(name.to_uppercase())
        .section("1")
        // The middle of the foot, where most pages have a date; the same program writes the same page.
        .date(env!("CARGO_PKG_VERSION"))
        .source("Lanchester")
        .manual("Lanchester")
        .render(&mut page);
    written.map_err(|error| Failure::own(format_args!("the page of `{name}` cannot be written: {error}")))?;
    // What stands at the end of a help text: examples and exit status.
    Ok(String::from_utf8_lossy(&page).replace("\n.SH EXTRA\n", "\n.SH NOTES\n"))
}

/// All commands that have a page, a line each: those that do something and those above them.
fn list(command: &Command, names: &mut String) {
    let _ = writeln!(names, "{}", full_name(command));
    let below = command.get_subcommands().filter(|below| below.get_name() != "help" && !below.is_hide_set());
    below.for_each(|below| list(below, names));
}

fn full_name(command: &Command) -> String {
    command.get_bin_name().unwrap_or(command.get_name()).to_owned()
}
