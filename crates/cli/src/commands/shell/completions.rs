//! `lanchester completions`: the script by which a shell completes commands and options.

use crate::arguments::{Arguments, CompletionsArguments};
use crate::failure::{DONE, Failure};
use crate::files::print;
use clap::CommandFactory;

pub fn run(arguments: &CompletionsArguments) -> Result<u8, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "lanchester", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(DONE)
}
