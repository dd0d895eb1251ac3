//! Options of `balance --search`: which arrangement of crank weights and balance shafts.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `balance --search`
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "Which arrangement?")]
pub struct SearchArguments {
    /// Search all arrangements of crank weights and balance shafts instead: --minimise names the one criterion (`force`,
    /// `couple` or `mount force`), a --limit on it what is good enough. The section [balance] does not count.
    #[arg(long)]
    pub search: bool,
    /// Good enough is what this engine does as it stands.
    #[arg(long, value_name = "FILE", requires = "search")]
    pub reference: Option<PathBuf>,
    /// Share of the reference that counts, e.g. `1/2` compares a twin with half a four; default: all.
    #[arg(long, value_name = "SHARE", requires = "reference")]
    pub share: Option<String>,
    /// Cylinder spacings to try, `88 mm, 60 mm`; default: that of the engine file.
    #[arg(long, value_name = "LENGTHS", requires = "search")]
    pub spacing: Option<String>,
    /// Two mounts on the crank axis, this far apart, instead of those of the file.
    #[arg(long, value_name = "LENGTH", requires = "search")]
    pub mount_spacing: Option<String>,
    /// Most balance shafts, 0 to 4; default: 4.
    #[arg(long = "max-shafts", alias = "most-shafts", value_name = "N", requires = "search")]
    pub most_shafts: Option<usize>,
    /// Orders that balance shafts may have, `1`, `2` or `1, 2`; default: both.
    #[arg(long, value_name = "ORDERS", requires = "search")]
    pub shaft_orders: Option<String>,
    /// Where shafts may stand: a point `x, y` (may be given several times), or a box with ranges, `-200 mm .. -90 mm,
    /// -150 mm .. 150 mm`; default: all around the crank, as near as crank and rods let them.
    #[arg(long, value_name = "PLACE", requires = "search")]
    pub place: Vec<String>,
    /// Distance between the points of a box; default: 10 mm.
    #[arg(long, value_name = "LENGTH", requires = "place")]
    pub place_step: Option<String>,
    /// Planes of shafts with two weights, `z1, z2`; default: the outermost cylinders.
    #[arg(long, value_name = "PLANES", requires = "search")]
    pub shaft_planes: Option<String>,
    /// What drives shafts that turn as their driver does; default: gears.
    #[arg(long, value_enum, requires = "search")]
    pub drive: Option<Drive>,
    /// Size of a part, `crank sweep = 80 mm`; also `big end`, `rod width`, `cylinder wall`, `weight sweep`, `crank
    /// weight radius`, `shaft radius`, `journal radius`, `clearance`, `module`, `gear width`. May be given several times.
    #[arg(long, value_name = "SIZE", requires = "search")]
    pub size: Vec<String>,
    /// List what is beaten or has no place too.
    #[arg(long, requires = "search")]
    pub all: bool,
    /// One arrangement in full, by its number or its name such as `crank -1`; --write puts it into the engine file.
    #[arg(long, value_name = "ARRANGEMENT", requires = "search")]
    pub choose: Option<String>,
}

/// What drives shafts that turn as their driver does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Drive {
    /// Gears alone, with an idler.
    Gears,
    /// A chain or belt.
    Chain,
}
