//! The binary `lanchester`: reads the command line and engine files, calls the facade, writes what it returns.
//!
//! Data go to standard output, everything else to standard error. Exit status: see [`failure`].
#![forbid(unsafe_code)]

mod arguments;
mod commands;
mod failure;
mod figures;
mod files;
mod format;
mod options;
mod program;
mod put_back;
mod remedies;
mod requests;
mod run;
mod simulation_watch;
mod still_computing;
mod trace_files;
mod watch;

use arguments::{Arguments, Colour, Command};
use clap::{Arg, CommandFactory, FromArgMatches};
use std::io::IsTerminal;
use std::process::ExitCode;

/// The name of a command that computes and tells no progress of its own.
fn without_progress(command: &Command) -> Option<&'static str> {
    Some(match command {
        Command::Loads(_) => "loads",
        Command::Torque(_) => "torque",
        Command::Bearings(_) => "bearings",
        Command::Torsion(_) => "torsion",
        Command::Mounts(_) => "mounts",
        Command::Simulate(_) => "simulate",
        Command::Export(_) => "export",
        Command::Stress(_) => "stress",
        Command::Crosscheck(_) => "crosscheck",
        Command::Balance(arguments) if arguments.search.search => "balance --search",
        Command::Counterweight(_) => "counterweight",
        Command::Compare(_) => "compare",
        Command::Sensitivity(_) => "sensitivity",
        Command::Report(_) => "report",
        Command::Validate(_) => "validate",
        Command::Bondgraph(_) => "bondgraph",
        Command::Workshop(_) => "workshop",
        _ => return None,
    })
}

/// The command line with options whose value may begin with a sign: what a negative value means there is for its command to say.
fn with_negative_values(command: clap::Command) -> clap::Command {
    let with_sign = |option: Arg| {
        let takes_one =
            !option.is_positional() && option.get_action().takes_values() && option.get_num_args().is_none();
        if takes_one { option.allow_hyphen_values(true) } else { option }
    };
    command.mut_args(with_sign).mut_subcommands(with_negative_values)
}

fn main() -> ExitCode {
    let matches = with_negative_values(Arguments::command()).get_matches();
    let arguments = Arguments::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    let colour = match arguments.colour {
        Colour::Always => true,
        Colour::Never => false,
        Colour::Auto => std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none(),
    };
    if let Some(command) = without_progress(&arguments.command) {
        still_computing::still_computing(command);
    }
    let outcome = match arguments.command {
        Command::Check(arguments) => commands::check::run(&arguments, colour),
        Command::Show(arguments) => commands::show::run(&arguments, colour),
        Command::New(arguments) => commands::new::run(&arguments, colour),
        Command::Complete(arguments) => commands::complete::run(&arguments, colour),
        Command::Loads(arguments) => commands::loads::run(&arguments, colour),
        Command::Torque(arguments) => commands::torque::run(&arguments, colour),
        Command::Bearings(arguments) => commands::bearings::run(&arguments, colour),
        Command::Torsion(arguments) => commands::torsion::run(&arguments, colour),
        Command::Mounts(arguments) => commands::mounts::run(&arguments, colour),
        Command::Simulate(arguments) => commands::simulate::run(&arguments, colour),
        Command::Export(arguments) => commands::export::run(&arguments, colour),
        Command::Stress(arguments) => commands::stress::run(&arguments, colour),
        Command::Crosscheck(arguments) => commands::crosscheck::run(&arguments, colour),
        Command::Balance(arguments) => commands::balance::run(&arguments, colour),
        Command::Counterweight(arguments) => commands::counterweight::run(&arguments, colour),
        Command::Compare(arguments) => commands::compare::run(&arguments, colour),
        Command::Explore(arguments) => commands::explore::run(&arguments, colour),
        Command::Merge(arguments) => commands::merge::run(&arguments),
        Command::Sensitivity(arguments) => commands::sensitivity::run(&arguments, colour),
        Command::Scatter(arguments) => commands::scatter::run(&arguments, colour),
        Command::Report(arguments) => commands::report::run(&arguments, colour),
        Command::Studio(arguments) => commands::studio::run(&arguments),
        Command::Validate(arguments) => commands::validate::run(&arguments),
        Command::Schema(arguments) => commands::schema::run(&arguments),
        Command::Licences => commands::licences::run(),
        Command::Completions(arguments) => commands::shell::completions::run(&arguments),
        Command::Manual(arguments) => commands::shell::manual::run(&arguments),
        Command::Bondgraph(arguments) => commands::bondgraph::run(&arguments, colour),
        Command::Workshop(arguments) => commands::workshop::run(&arguments, colour),
    };
    match outcome {
        Ok(status) => ExitCode::from(status),
        Err(failure) => {
            if !failure.message.is_empty() {
                files::tell(&failure.message);
            }
            failure.exit_code()
        }
    }
}
