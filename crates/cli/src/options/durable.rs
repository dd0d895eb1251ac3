//! Options of `balance` for the life of crankshaft and bearings.

use clap::Args;
use lanchester::DurableOptions;
use lanchester::balance::{BalanceSettings, DurableSettings};

/// Films and safeties, after the proved optimum.
#[derive(Debug, Clone, Args)]
pub struct DurableArguments {
    /// Oil film or safety that must not fall below a value: `main-bearing film = 2 um`, `least film = 1.5 um`, `crankpin film 2 = 1 um`,
    /// `rule safety = 1.3` (UR M53, with the torsional vibration of the chain that the file gives). May be given several times. Where the proved optimum does not hold it, a local search moves its weights on the
    /// crankshaft, first those moves that leave the loads on the block as they are; it claims no global optimum. A film costs milliseconds an
    /// engine with a viscosity at work, the search some seconds.
    #[arg(long, value_name = "LIMIT", conflicts_with_all = ["robust", "search", "method"])]
    pub at_least: Vec<String>,
    /// Oil film or safety that the local search makes as large as it can, without raising a stage beyond its `--give-up`; may be given several times, in
    /// order of priority.
    #[arg(long, alias = "maximize", value_name = "CRITERION", conflicts_with_all = ["robust", "search", "method"])]
    pub maximise: Vec<String>,
    /// Most engines whose films are computed for the local search.
    #[arg(long = "max-evaluations", alias = "most-evaluations", value_name = "N", default_value_t = 400, value_parser = clap::value_parser!(u32).range(1..))]
    pub most_evaluations: u32,
}

impl DurableArguments {
    /// How far the search goes.
    pub fn options(&self, balance: BalanceSettings) -> DurableOptions {
        DurableOptions {
            search: DurableSettings { most_evaluations: self.most_evaluations as usize },
            balance,
        }
    }
}
