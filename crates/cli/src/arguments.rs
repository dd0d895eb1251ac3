//! The command line as clap sees it: the one definition behind parsing and help.

use crate::commands::merge::MergeArguments;
use crate::failure::exit_statuses;
use crate::format::Format;
use crate::options::bondgraph::BondgraphArguments;
use crate::options::compare::CompareArguments;
use crate::options::complete::CompleteArguments;
use crate::options::counterweight::CounterweightArguments;
use crate::options::durable::DurableArguments;
use crate::options::explore::ExploreArguments;
use crate::options::export::ExportArguments;
use crate::options::mounts::MountsArguments;
use crate::options::printed::PrintedArguments;
use crate::options::published::PublishedArguments;
use crate::options::robust::RobustArguments;
use crate::options::scatter::ScatterArguments;
use crate::options::search::SearchArguments;
use crate::options::search_limit::SearchLimitArguments;
use crate::options::sensitivity::SensitivityArguments;
use crate::options::simulation::{CrosscheckArguments, SimulateArguments};
use crate::options::stress::StressArguments;
use crate::options::studio::StudioArguments;
use crate::options::torque::{BearingsArguments, TorqueArguments};
use crate::options::torsion::TorsionArguments;
use crate::options::workshop::WorkshopArguments;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// Shaking forces and moments of piston engines, from one engine file.
#[derive(Debug, Parser)]
#[command(
    name = "lanchester",
    version,
    after_help = format!(
        "Start with:  lanchester new --list\n             lanchester new in-line-4 > four.toml\n             \
         lanchester report four.toml\n\n{}",
        exit_statuses()
    )
)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Colour in messages.
    #[arg(long, alias = "color", global = true, value_enum, default_value_t = Colour::Auto)]
    pub colour: Colour,
}

/// When messages are coloured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Colour {
    /// On a terminal, unless NO_COLOR is set.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Read engine files and report every mistake, with its place and a suggested fix.
    #[command(
        after_help = "Examples:\n  lanchester check twin.toml\n  lanchester check engines/*.toml --format json"
    )]
    Check(CheckArguments),
    /// Print the expanded form of an engine file and where every cylinder has its dead centres; draw the engine.
    #[command(
        after_help = "Examples:\n  lanchester show twin.toml\n  lanchester show twin.toml --drawing twin.svg\n  \
                            lanchester show twin.toml > general-form.toml"
    )]
    Show(ShowArguments),
    /// Write a new engine file from the gallery.
    #[command(
        after_help = "Examples:\n  lanchester new --list\n  lanchester new v8-crossplane > v8.toml\n  \
                            lanchester new in-line-3 --output three.toml\n  \
                            lanchester new single --complete > single.toml"
    )]
    New(NewArguments),
    /// Add typical values for what an engine file leaves out, scaled to the engine: gas, flywheel, bearings, mounts, crankshaft, tolerances.
    #[command(
        after_help = "Examples:\n  lanchester complete twin.toml --write\n  lanchester complete twin.toml --dry-run\n  \
                            lanchester complete twin.toml > complete.toml\n  \
                            lanchester complete twin.toml --section gas --section flywheel --kind motorcycle-petrol\n\n\
                            Exit status 1: a section of --section cannot be had for this engine, and the message says why."
    )]
    Complete(CompleteArguments),
    /// Shaking forces, couples, roll moment and torque: by order and sense of rotation, and their peaks.
    #[command(
        after_help = "Examples:\n  lanchester loads twin.toml\n  lanchester loads twin.toml --speed '6000 rpm' \
                            --orders 12\n  lanchester loads twin.toml --about '0 mm, 0 mm, 120 mm'\n  \
                            lanchester loads twin.toml --series power:4:5 --grid 360\n  \
                            lanchester loads twin.toml --format csv --table trace > trace.csv\n  \
                            lanchester loads v8.toml --bending-share '50 %' --format csv --table internal\n  \
                            lanchester loads twin.toml --cases cases.csv\n  \
                            lanchester loads twin.toml --cases cases.xlsx --output loads.xlsx"
    )]
    Loads(LoadsArguments),
    /// Torque of gas and inertia, work, orders with halves, firing, cyclic speed fluctuation and flywheel, power.
    #[command(
        after_help = "Examples:\n  lanchester torque twin.toml\n  lanchester torque twin.toml --speed '2000 rpm' --lever sine\n  \
                            lanchester torque twin.toml --speeds '1000 rpm, 2000 rpm, 3000 rpm, 4000 rpm' --fmep '1.2 bar'\n  \
                            lanchester torque twin.toml --flywheel '0.1 kg m^2' --fluctuation '2 %'\n  \
                            lanchester torque twin.toml --figures figures --format csv > torque.csv"
    )]
    Torque(TorqueArguments),
    /// Loads of piston, pins and bearings over the cycle: side thrust, piston pin, crankpin, main bearings; polar diagrams.
    #[command(
        after_help = "Examples:\n  lanchester bearings twin.toml\n  lanchester bearings twin.toml --speed '2000 rpm' --part gas\n  \
                            lanchester bearings twin.toml --figures figures\n  \
                            lanchester bearings twin.toml --film gumbel,reynolds\n  lanchester bearings twin.toml --film --dynamic\n  lanchester bearings twin.toml --film --least-film '1 um'\n  \
                            lanchester bearings twin.toml --format csv > bearings.csv"
    )]
    Bearings(BearingsArguments),
    /// Torsional vibration: natural frequencies, every order in true phase over speed, torque and stress of every shaft, damper.
    #[command(
        after_help = "Examples:\n  lanchester torsion six.toml\n  lanchester torsion six.toml --speeds '600 rpm .. 3000 rpm by 25 rpm' --format csv > torsion.csv\n  \
                            lanchester torsion six.toml --tune damper --figures figures\n  \
                            lanchester torsion six.toml --table holzer\n  lanchester torsion six.toml --check '2000 rpm'"
    )]
    Torsion(TorsionArguments),
    /// The block on its mounts: at rest, its six modes, forces at the mounts by order and speed.
    #[command(
        after_help = "Examples:\n  lanchester mounts four.toml\n  lanchester mounts four.toml --speed '3000 rpm' --orders 12 \
                            --point '300 mm, 0 mm, 100 mm'\n  lanchester mounts four.toml --steps 200 --figures figures\n  \
                            lanchester mounts four.toml --format csv > forces.csv\n  \
                            lanchester mounts four.toml --format csv --table modes"
    )]
    Mounts(MountsArguments),
    /// Simulate the rigid crank train on its mounts: free or imposed speed, load, misfire, every reaction, energy.
    #[command(
        after_help = "Examples:\n  lanchester simulate four.toml\n  lanchester simulate four.toml --for '2 s' --speed '800 rpm' --load '20 N m'\n  \
                            lanchester simulate four.toml --until periodic --speed '1500 rpm' --block mounts\n  \
                            lanchester simulate four.toml --speed '1200 rpm' --misfire 2 --figures figures\n  \
                            lanchester simulate four.toml --start '90 deg, 800 rpm' --event '3 revolutions: load none' --point '350 mm, 0 mm, 0 mm'\n  \
                            lanchester simulate four.toml --imposed --format csv --table reactions > reactions.csv\n  \
                            lanchester simulate four.toml --format parquet > run.parquet\n\n\
                            Exit status 1: the run was not completed; what it came to is printed."
    )]
    Simulate(SimulateArguments),
    /// Loads for other programs: forces by order and speed for solvers of finite elements, histories, a script of Exudyn.
    #[command(subcommand_required = true, arg_required_else_help = true)]
    Export(ExportArguments),
    /// The flexible crankshaft: stress of its fillets, natural modes, decks and pictures for other programs.
    Stress(StressArguments),
    /// Hold the closed form against an independent multibody simulation of the same engine, component by component and order by order.
    #[command(
        after_help = "Examples:\n  lanchester crosscheck four.toml\n  lanchester crosscheck v6.toml --condition a --order 8\n  \
                            lanchester crosscheck four.toml --speed '3000 rpm' --format csv > agreement.csv\n\n\
                            Exit status 1: a quantity disagrees."
    )]
    Crosscheck(CrosscheckArguments),
    /// Find the best counterweights and balance shafts, prove that nothing better exists, write them into the file.
    #[command(
        after_help = "Examples:\n  lanchester balance twin.toml\n  lanchester balance twin.toml --minimise couple --minimise force\n  \
                            lanchester balance twin.toml --limit 'couple = 40 N m' --max-unbalance '0.03 kg m'\n  \
                            lanchester balance twin.toml --shaft '-1 @ 0 mm, 100 mm @ 0 mm'\n  \
                            lanchester balance twin.toml --max-optional 1 --shaft '-1 @ 0 mm, 100 mm @ 0 mm @ optional, most 0.02 kg m' \
                            --shaft '1 @ 0 mm, -100 mm @ 0 mm @ optional, most 0.02 kg m'\n  \
                            lanchester balance twin.toml --cancel 'force order 1' --shaft '-1 @ 0 mm, 100 mm @ 0 mm'\n  \
                            lanchester balance four.toml --maximise 'main-bearing film' --max-evaluations 60\n  \
                            lanchester balance four.toml --at-least 'main-bearing film = 0.5 um'\n  \
                            lanchester balance twin.toml --dry-run\n  lanchester balance twin.toml --write\n  \
                            lanchester balance twin.toml --search --limit 'force = 5 kN' --figures figures\n  \
                            lanchester balance twin.toml --search --mount-spacing '176 mm' --reference four.toml --share 1/2\n  \
                            lanchester balance twin.toml --search --choose 'crank -1' --write\n  \
                            lanchester balance four.toml --method matrix --webs 11000011 --shafts second\n  \
                            lanchester balance three.toml --method half --figures figures\n  \
                            lanchester balance twin.toml --method sweep --figures figures\n\n\
                            Exit status 1: a limit cannot be reached, a film or safety falls below its value, an order cannot vanish, or the search stopped early."
    )]
    Balance(Box<BalanceArguments>),
    /// Counterweights as real parts: the best shape with its proof, clearance, drawing, CAD.
    Counterweight(CounterweightArguments),
    /// Engines and arrangements side by side, as they are or made equal in displacement or power.
    #[command(
        after_help = "Examples:\n  lanchester compare twin.toml four.toml\n  lanchester compare twin.toml four.toml --equal displacement\n  \
                            lanchester compare twin.toml boxer.toml --equal power --hold piston-speed --reference 2\n  \
                            lanchester compare twin.toml --arrangements 1,2,4 --optimum --figures figures\n  \
                            lanchester compare twin.toml boxer.toml --reference four.toml --share 1/2 --mount-spacing '176 mm' --arrangements all\n  \
                            lanchester compare twin.toml boxer.toml --format csv > comparison.csv"
    )]
    Compare(CompareArguments),
    /// All layouts that the parts of an engine can make, and the Pareto-optimal ones: throw angles, firing order, banks, pins, weights.
    #[command(
        after_help = "Examples:\n  lanchester explore four.toml\n  lanchester explore four.toml --even-firing --figures figures\n  \
                            lanchester explore v6.toml --bank-angle '60 deg .. 120 deg by 15 deg' --split-angle '-60 deg .. 60 deg by 15 deg' \
                            --even-firing\n  \
                            lanchester explore three.toml --shafts none --shafts '-1 @ 0 mm, 100 mm @ couple -80 mm, 80 mm' --minimise shafts \
                            --minimise 'couple order 1'\n  \
                            lanchester explore four.toml --cylinders 6 --limit 'length = 650 mm' --minimise 'bending moment' --minimise 'force order 2'\n  \
                            lanchester explore v6.toml --even-firing --adopt 1 --output best.toml\n  \
                            lanchester explore v6.toml --format csv > front.csv\n  \
                            lanchester explore v6.toml --save cases.parquet\n  \
                            lanchester explore v6.toml --bank-angle '60 deg .. 120 deg by 1 deg' --save part-2.parquet --part 2/3\n\n\
                            A run with --save that was stopped goes on with the same command.\n\
                            Exit status 1: nothing was judged, and the answer says why; or the run was stopped."
    )]
    Explore(Box<ExploreArguments>),
    /// Join the parts of a long run into the table that the run would have written, to the last byte.
    #[command(
        after_help = "Examples:\n  lanchester explore v6.toml --bank-angle '60 deg .. 120 deg by 1 deg' --save part-1.parquet --part 1/2\n  \
                            lanchester explore v6.toml --bank-angle '60 deg .. 120 deg by 1 deg' --save part-2.parquet --part 2/2\n  lanchester merge part-1.parquet part-2.parquet --output cases.parquet"
    )]
    Merge(MergeArguments),
    /// What matters most for loads, torque, bearings and mounts: exact derivatives by every number of the engine, one at a time over ranges, and
    /// shares of the variance.
    #[command(
        after_help = "Examples:\n  lanchester sensitivity four.toml\n  lanchester sensitivity four.toml --output 'force order 2' --vary 'rod length = 10 %' --figures figures\n  \
                            lanchester sensitivity twin.toml --vary 'piston mass = 25 %' --vary 'crank radius = 5 mm' --only\n  \
                            lanchester sensitivity four.toml --each --sobol 64 --format csv > sensitivity.csv"
    )]
    Sensitivity(SensitivityArguments),
    /// What tolerances of the parts do to residual forces and couples in production: distribution, worst case, capability, and
    /// which tolerance to tighten first.
    #[command(
        after_help = "Examples:\n  lanchester scatter four.toml\n  lanchester scatter four.toml --samples 100000 --seed 7 --figures figures\n  \
                            lanchester scatter four.toml --limit 'force order 1 = 800 N' --limit 'couple order 1 = 80 N m'\n  \
                            lanchester scatter four.toml --orders-only --format json > scatter.json\n  \
                            lanchester scatter four.toml --samples 100000 --save engines.parquet\n\n\
                            Exit status 1: the production does not keep a limit."
    )]
    Scatter(ScatterArguments),
    /// One self-contained HTML page: diagnosis, drawing, spectra, curves, hodographs, star diagrams, story.
    #[command(
        after_help = "Examples:\n  lanchester report twin.toml\n  lanchester report twin.toml --output out/twin.html\n  \
                            lanchester report twin.toml --figures figures/\n  \
                            lanchester report twin.toml --all-arrangements"
    )]
    Report(ReportArguments),
    /// Open the studio in a browser, answered by this machine alone: engine, loads, balancing, counterweights, report.
    #[command(after_help = "Examples:\n  lanchester studio\n  lanchester studio twin.toml\n  \
                            lanchester studio engines --port 7000 --no-open\n  \
                            lanchester studio --describe openapi > openapi.json")]
    Studio(StudioArguments),
    /// Recompute every published number: printed against computed, with verdict and reason.
    #[command(after_help = "Examples:\n  lanchester validate\n  lanchester validate twin --verbose\n  \
                            lanchester validate --format csv > verdicts.csv\n  \
                            lanchester validate --figures atlas\n  \
                            lanchester validate 'twin-cylinder-thesis Figure 18' --figures atlas\n  \
                            lanchester validate --suite suite.json")]
    Validate(ValidateArguments),
    /// Print the JSON Schema of the engine file or of the workshop sheet, for completion in an editor, or of the reference suite.
    #[command(after_help = "Examples:\n  lanchester schema > engine.schema.json\n  \
                            lanchester schema --sheet > sheet.schema.json\n  \
                            lanchester schema --markdown > engine-file.md\n  \
                            lanchester schema --suite > suite.schema.json")]
    Schema(SchemaArguments),
    /// Print the licences and notices of everything by others that the program and its page contain.
    #[command(after_help = "Examples:\n  lanchester licences > third-party.txt")]
    Licences,
    /// Print the script by which a shell completes commands, options and their values.
    #[command(after_help = "Examples:\n  lanchester completions bash > lanchester.bash\n  \
                            lanchester completions zsh > _lanchester\n  \
                            lanchester completions fish > lanchester.fish\n  \
                            lanchester completions powershell > lanchester.ps1")]
    Completions(CompletionsArguments),
    /// Print the manual page of the program or of a command, for `man`.
    #[command(after_help = "Examples:\n  lanchester manual > lanchester.1\n  \
                            lanchester manual loads > lanchester-loads.1\n  \
                            lanchester manual counterweight design > lanchester-counterweight-design.1\n  \
                            lanchester manual --list")]
    Manual(ManualArguments),
    /// A bond graph: its causality, equations, poles, simulation, energy audit, drawing, and text for other programs.
    #[command(
        after_help = "Examples:\n  lanchester bondgraph slider-crank.toml\n  lanchester bondgraph equations slider-crank.toml --notation latex\n  \
                            lanchester bondgraph linear dc-motor.toml\n  lanchester bondgraph simulate dc-motor.toml --for '2 s' --format csv > motor.csv\n  \
                            lanchester bondgraph simulate three-cylinder.toml --gas-states --figures figures\n  \
                            lanchester bondgraph simulate three-cylinder.toml --until periodic --block fixed\n  \
                            lanchester bondgraph audit slider-crank.toml\n  lanchester bondgraph draw dc-motor.toml > motor.svg\n  \
                            lanchester bondgraph export dc-motor.toml --to modelica > motor.mo\n\n\
                            Exit status 1: a simulation ended before its duration."
    )]
    Bondgraph(BondgraphArguments),
    /// Balance a real crank or engine from measurements, described by a workshop sheet.
    Workshop(WorkshopArguments),
}

/// `check`
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// Engine files; `-` reads standard input.
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// `show`
#[derive(Debug, Args)]
pub struct ShowArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Draw front and side view into this SVG file.
    #[arg(long, value_name = "SVG")]
    pub drawing: Option<PathBuf>,
    /// Form of the output: the general form as TOML, the engine as JSON, or its cylinders as CSV.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// `new`
#[derive(Debug, Args)]
pub struct NewArguments {
    /// Name of a layout in the gallery.
    #[arg(value_name = "LAYOUT", required_unless_present = "list")]
    pub name: Option<String>,
    /// List the gallery.
    #[arg(long, conflicts_with = "name")]
    pub list: bool,
    /// Add typical values for what the file leaves out, as `complete` does.
    #[arg(long, conflicts_with = "list")]
    pub complete: bool,
    /// Write to this file instead of standard output; never overwrites. Its first line names lanchester.schema.json, which is put beside it:
    /// editors complete and check keys by it.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Write neither that line nor the schema.
    #[arg(long, requires = "output")]
    pub no_schema: bool,
    /// Form of the list.
    #[arg(long, value_enum, default_value_t = Format::Text, conflicts_with = "name")]
    pub format: Format,
}

/// What the loads are computed with; shared by `loads` and `report`.
#[derive(Debug, Clone, Args)]
pub struct RequestArguments {
    /// Speed of crankshaft 1, with its unit; default: the highest speed of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// Point that couples and roll moment are about, `x, y, z` with units; default: the origin of the frame.
    #[arg(long, value_name = "POINT")]
    pub about: Option<String>,
    /// Motion of the pistons: `exact`; `orders:N`, exact coefficients up to order N; `power:N:P`, the literature's
    /// series up to order N with powers of the rod ratio up to P.
    #[arg(long, value_name = "SERIES", default_value = "exact")]
    pub series: String,
    /// Highest order listed.
    #[arg(long, value_name = "N", default_value_t = 8)]
    pub orders: u32,
    /// Look for peaks only at this many equally spaced angles a revolution, as published tables do; default: the
    /// true extremes over the continuous angle.
    #[arg(long, value_name = "ANGLES")]
    pub grid: Option<u32>,
    /// Share of the reciprocating forces that counts in shear and bending of the crankshaft, `0 %` to `100 %`; all of
    /// them are tabulated beside it.
    #[arg(long, value_name = "SHARE", default_value = "0 %")]
    pub bending_share: String,
}

/// `loads`
#[derive(Debug, Args)]
pub struct LoadsArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What to compute with.
    #[command(flatten)]
    pub request: RequestArguments,
    /// Angles a revolution of the traces in JSON and CSV.
    #[arg(long, value_name = "ANGLES", default_value_t = 720, value_parser = clap::value_parser!(u32).range(4..=100_000))]
    pub samples: u32,
    /// Table written with `--format csv`; default: orders.
    #[arg(long, value_enum, requires = "format")]
    pub table: Option<LoadsTable>,
    /// The loads of every row of a table of cases instead: CSV or a workbook (`.xlsx`), a row a case, a column a key of the engine file, its unit in
    /// the head: `rod.length [mm]`. An empty cell leaves the key as it is.
    #[arg(long, value_name = "TABLE", conflicts_with = "table")]
    pub cases: Option<PathBuf>,
    /// With --cases: write their loads into this file, `.csv` or `.xlsx`; default: standard output. Never overwrites.
    #[arg(long, short, value_name = "FILE", requires = "cases")]
    pub output: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// Tables of `loads --format csv`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum LoadsTable {
    /// By order: forward and backward parts of force and couple, roll moment, torque.
    Orders,
    /// All components over one period.
    Trace,
    /// Position, velocity, acceleration of every piston and the angle of its rod over one period.
    Motion,
    /// Largest shear force and bending moment at every plane along the crankshaft, and main-bearing loads.
    Internal,
}

/// `report`
#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What to compute with.
    #[command(flatten)]
    pub request: RequestArguments,
    /// Compare the nine arrangements of counterweights and balance shafts of the twin-cylinder thesis instead, one
    /// printed sheet each, in the place of the file's own; shafts stand at y = +-100 mm.
    #[arg(long, conflicts_with = "figures")]
    pub all_arrangements: bool,
    /// Also solve the crankshaft as an elastic body, which takes a while, and add chapters on its stress and its natural modes, with pictures.
    #[arg(long, conflicts_with = "all_arrangements")]
    pub stress: bool,
    /// With --stress: size of the elements away from fillets, with its unit; default that of [crank.mesh], else 14 mm.
    #[arg(long, value_name = "LENGTH", requires = "stress")]
    pub stress_size: Option<String>,
    /// With --stress: elements across the 90 deg of a fillet, an even number; default that of [crank.mesh], else 4.
    #[arg(long, value_name = "N", requires = "stress")]
    pub stress_fillet_elements: Option<usize>,
    /// The page to write, `-` for standard output; default: the engine file's name with `.html` (or
    /// `-arrangements.html`), in this folder. A name that ends in `.txt` gets the same words and tables as plain text, one
    /// that ends in `.csv` all tables, each under a line with its name.
    #[arg(long, short, value_name = "PAGE")]
    pub output: Option<PathBuf>,
    /// Also write every figure as an SVG file of its own into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of what is said on standard output about the files written.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// `balance`
#[derive(Debug, Args)]
pub struct BalanceArguments {
    /// Engine file; `-` reads standard input. Its section [balance] says what may be done; without one every
    /// counterweight of the file is free, and where it has none, a weight on every web or throw.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// How the weights are found. A published method is fitted in place of the counterweights and shafts of the file, and
    /// the true optimum of the same devices stands beside it.
    #[arg(long, value_enum, default_value_t = BalanceMethod::Optimum, conflicts_with = "search")]
    pub method: BalanceMethod,
    /// Objective: a criterion such as `force`, `couple`, `roll moment`, `mount force`, `mount force with gas`, `force order 2`, or a sum
    /// that counts shares of given values, `force = 200 N, couple = 10 N m`. May be given several times, in order
    /// of priority: each next one without degrading the previous ones. Default: `force`, then `couple`.
    #[arg(long, alias = "minimize", value_name = "CRITERION")]
    pub minimise: Vec<String>,
    /// The life of crankshaft and bearings.
    #[command(flatten)]
    pub durable: DurableArguments,
    /// A production of engines.
    #[command(flatten)]
    pub robust: RobustArguments,
    /// Largest cost of the weights and shafts that are used, in the unit of `fixed_cost` and `cost_per_kg` of [balance].
    #[arg(long, value_name = "NUMBER")]
    pub budget: Option<String>,
    /// What a stage may lose for those after it: `force = 1 %` of its least value, or `force = 5 N`; without a name, in the order
    /// of the stages. May be given several times.
    #[arg(long, value_name = "STAGE = SHARE")]
    pub give_up: Vec<String>,
    /// Speed at which forces at mounts with springs and loads with gas are judged, such as `2000 rpm`; may be given several times, the largest
    /// counts, each times its weight where it has one: `2000 rpm * 2`. Default: the whole range of the engine, resonances included. All
    /// other loads are largest at the highest speed.
    #[arg(long, value_name = "SPEED")]
    pub speed: Vec<String>,
    /// Orders that must vanish exactly: `force order 1, couple order 1`; of all weights that do it those that the bearings need. If they cannot, the
    /// proof is printed, and the weights that leave the least. May be given several times; in place of what [balance]
    /// wants.
    #[arg(long, value_name = "ORDERS", conflicts_with_all = ["minimise", "limit"])]
    pub cancel: Vec<String>,
    /// What must hold: `couple = 40 N m`. May be given several times; replaces limits on the same in the file.
    #[arg(long, value_name = "LIMIT")]
    pub limit: Vec<String>,
    /// Which weights on the crankshaft are free; default: those of [balance].
    #[arg(long, value_enum)]
    pub counterweights: Option<CrankWeights>,
    /// Largest unbalance of every free weight on the crankshaft, or `what fits`: what shapes and clearance allow on its web.
    #[arg(long = "max-unbalance", alias = "most", value_name = "UNBALANCE")]
    pub most: Option<String>,
    /// Step in which every free weight on a crankshaft is made: an unbalance such as `200 g mm`, or a mass such as `5 g` at the radius
    /// that [balance] gives.
    #[arg(long, value_name = "AMOUNT")]
    pub weight_step: Option<String>,
    /// All free weights on the crankshafts are the same part: one amount of their steps or lists, each in its own direction.
    #[arg(long)]
    pub equal_parts: bool,
    /// Least unbalance of every free weight on the crankshaft that is used.
    #[arg(long = "min-unbalance", alias = "least", value_name = "UNBALANCE")]
    pub least: Option<String>,
    /// Every free weight on the crankshaft may be left out; needs `--max-unbalance`, or `most` in the file.
    #[arg(long)]
    pub optional: bool,
    /// Most of the optional weights, shafts and inertias that may be used at once.
    #[arg(long = "max-optional", alias = "most-optional", value_name = "N")]
    pub most_optional: Option<usize>,
    /// One more free balance shaft: `RATIO @ x, y @ z` or `RATIO @ x, y @ z1, z2`; a ratio below 0 turns against the
    /// crank. A coordinate may be a range to be optimised over, `50 mm .. 100 mm`; behind one more `@` may stand `optional`,
    /// `least 0.01 kg m`, `most 0.02 kg m` with commas between. May be given several times.
    #[arg(long, value_name = "SHAFT")]
    pub shaft: Vec<String>,
    /// How far a search over choices goes.
    #[command(flatten)]
    pub limits: SearchLimitArguments,
    /// Write the found weights into the engine file; comments and order stay.
    #[arg(long, conflicts_with = "dry_run")]
    pub write: bool,
    /// Show what --write would change.
    #[arg(long)]
    pub dry_run: bool,
    /// Write the figures as SVG files into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Table written with `--format csv`; default: weights.
    #[arg(long, value_enum)]
    pub table: Option<BalanceTable>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
    /// Which arrangement?
    #[command(flatten)]
    pub search: SearchArguments,
    /// Choices of a published method.
    #[command(flatten)]
    pub published: PublishedArguments,
}

/// How weights are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum BalanceMethod {
    /// The true optimum over the continuous cycle, with its proof.
    Optimum,
    /// Matrices of the crankshaft balancing tool (Applied Sciences 2021, 11, 8997), its equations corrected.
    Matrix,
    /// 50 % rules of the 3-/4-cylinder thesis (Singh 2017): an in-line three with its balancer shaft, an in-line four with
    /// two second-order shafts; for other engines, or with --balance-factor, counterweights for the rotating masses and a share
    /// of the reciprocating ones.
    Half,
    /// Sweep of the crank of the twin-cylinder thesis (Louvigny 2008): one amount opposite every throw, in steps, on a grid of
    /// angles; shafts of the file stay.
    Sweep,
}

/// Free weights on the crankshaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CrankWeights {
    /// None: only shafts.
    None,
    /// Those that the file has now.
    File,
    /// One in the plane of every throw.
    Throws,
    /// One on every web.
    Webs,
}

/// Tables of `balance --format csv`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum BalanceTable {
    /// The free weights.
    Weights,
    /// Criteria without them, as the file stands, with them.
    Effects,
    /// Loads, bending, counterweights and balance rates before and after, with what got worse.
    Consequences,
    /// What was reached and the bound that proves it.
    Stages,
    /// Limits and their prices.
    Limits,
    /// Oil films and safeties before, at the optimum and after a search for them.
    Durability,
    /// With --cancel: what had to vanish; with --method: what is left, order by order.
    Orders,
    /// With --cancel: the combinations of orders that prove the verdict.
    Proof,
}

/// `validate`
#[derive(Debug, Args)]
pub struct ValidateArguments {
    /// Only rows whose source or table contains this text.
    #[arg(value_name = "FILTER")]
    pub filter: Option<String>,
    /// Print every row, not only those that need a reason; the other forms always have every row.
    #[arg(long, conflicts_with = "format")]
    pub verbose: bool,
    /// Write the validation page of the book instead; with `--figures` the page of the atlas.
    #[arg(long, conflicts_with_all = ["verbose", "filter", "format"])]
    pub markdown: bool,
    /// Draw the published figures from our numbers into this folder instead, with a page `index.html`; the filter keeps
    /// sources and figures.
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["verbose", "format"])]
    pub figures: Option<PathBuf>,
    /// Write the numbers into this file instead, as a reference suite that another program can run: inputs in SI, expected
    /// values with their uncertainty, sources (JSON).
    #[arg(long, value_name = "FILE", conflicts_with_all = ["verbose", "format", "markdown", "figures"])]
    pub suite: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// `schema`
#[derive(Debug, Args)]
pub struct SchemaArguments {
    /// Print the reference page of the engine file instead.
    #[arg(long)]
    pub markdown: bool,
    /// The workshop sheet instead of the engine file.
    #[arg(long)]
    pub sheet: bool,
    /// The reference suite that `validate --suite` writes.
    #[arg(long, conflicts_with_all = ["sheet", "markdown"])]
    pub suite: bool,
}

/// `completions`
#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// Shell that completes.
    #[arg(value_name = "SHELL", value_enum)]
    pub shell: clap_complete::Shell,
}

/// `manual`
#[derive(Debug, Args)]
pub struct ManualArguments {
    /// The command, in one word or two; default: the program.
    #[arg(value_name = "COMMAND")]
    pub command: Vec<String>,
    /// List all that have a page instead, a line each.
    #[arg(long, conflicts_with = "command")]
    pub list: bool,
}
