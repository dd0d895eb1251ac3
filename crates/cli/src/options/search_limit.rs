//! Options that end a search over choices.

use crate::failure::Failure;
use clap::Args;
use lanchester::balance::{BalanceSettings, StopCause};
use lanchester::task::option;

/// How far a search over choices goes: places to be found, given and least amounts, devices that may be left out.
#[derive(Debug, Clone, Args)]
pub struct SearchLimitArguments {
    /// A search over choices (places, given and least amounts, optional devices) ends at this gap between the best value and its
    /// bound: a share of the value from `1e-8` to `50 %`. Later stages may use up what it leaves. Default: 1e-8.
    #[arg(long, value_name = "SHARE")]
    pub gap: Option<String>,
    /// Most branch-and-bound nodes for one stage; then the best so far is printed with its bound. Default: 2000.
    #[arg(long, value_name = "N")]
    pub max_nodes: Option<usize>,
    /// Longest time of the search, such as `30 s` or `5 min`; then the best so far is printed with its bound, as after Ctrl-C.
    #[arg(long, value_name = "TIME")]
    pub time_limit: Option<String>,
}

impl SearchLimitArguments {
    /// Refuses them where nothing is searched over: `what` is asked for.
    pub fn refuse_with(&self, what: &str) -> Result<(), Failure> {
        if self.gap.is_none() && self.max_nodes.is_none() && self.time_limit.is_none() {
            return Ok(());
        }
        Err(Failure::input(
            format_args!(
                "--gap, --max-nodes and --time-limit end a search over choices, and {what} has none"
            ),
            "leave them out",
        ))
    }

    /// The settings behind the options.
    pub fn settings(&self) -> Result<BalanceSettings, Failure> {
        let usual = BalanceSettings::default();
        let gap = self.gap.as_ref().map(|text| option::share(text, "--gap")).transpose()?;
        let time_limit =
            self.time_limit.as_ref().map(|text| option::time(text, "--time-limit")).transpose()?;
        let settings = BalanceSettings {
            gap: gap.unwrap_or(usual.gap),
            max_nodes: self.max_nodes.unwrap_or(usual.max_nodes),
            time_limit,
        };
        settings.check().map_err(Failure::refused)?;
        Ok(settings)
    }
}

/// What lets a search that ended for this reason go on; empty where nothing does.
pub fn hint(cause: StopCause, settings: &BalanceSettings) -> String {
    match cause {
        StopCause::MaxNodes => format!(
            "hint: --max-nodes {} examines more, a wider --gap ends the search earlier",
            settings.max_nodes.saturating_mul(10)
        ),
        StopCause::TimeLimit => {
            "hint: a longer --time-limit goes on, a wider --gap ends the search earlier".to_owned()
        }
        StopCause::Cancelled | StopCause::Rounding => String::new(),
    }
}
