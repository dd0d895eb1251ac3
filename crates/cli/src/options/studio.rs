//! Options of `studio`.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `studio`
#[derive(Debug, Args)]
pub struct StudioArguments {
    /// Engine file to open, or a folder of engine files; without it the current folder. The studio reads and writes that folder alone.
    #[arg(value_name = "FILE", default_value = ".")]
    pub path: PathBuf,
    /// Port to listen at, on this machine alone; without it a free one.
    #[arg(long, value_name = "PORT", value_parser = clap::value_parser!(u16).range(1..))]
    pub port: Option<u16>,
    /// Listen at all network interfaces, so that the port of a container can be published or forwarded under its own number; whoever asks still
    /// needs the printed address, which goes over the network unencrypted.
    #[arg(long)]
    pub all_interfaces: bool,
    /// Only print the address, open no browser.
    #[arg(long)]
    pub no_open: bool,
    /// Print the description of the studio's questions and answers instead.
    #[arg(long, value_enum, value_name = "FORM")]
    pub describe: Option<Description>,
}

/// Forms of the description.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Description {
    /// OpenAPI 3.1.
    Openapi,
    /// Types of the page.
    Typescript,
}
