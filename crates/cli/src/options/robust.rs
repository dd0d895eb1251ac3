//! Options of `balance` for a production of engines.

use crate::failure::Failure;
use clap::Args;
use lanchester::RobustOptions;
use lanchester::balance::RobustMeasure;
use lanchester::task::option;

/// Engines drawn within the tolerances of the file.
#[derive(Debug, Clone, Args)]
pub struct RobustArguments {
    /// Optimise for so many engines, drawn within [tolerances] of the file: the worst of them is minimised, or with --worst-share the
    /// mean of the worst. The first --minimise is that of the engines, such as `force`; limits and later stages are those of the engine as it is
    /// meant.
    #[arg(long, value_name = "ENGINES", conflicts_with_all = ["search", "method", "cancel", "table", "figures"])]
    pub robust: Option<u64>,
    /// With --robust: minimise the mean of this share of the engines, the worst ones, such as `1 %`.
    #[arg(long, value_name = "SHARE", requires = "robust")]
    pub worst_share: Option<String>,
    /// With --robust: seed of the draws; the same seed draws the same engines.
    #[arg(long, value_name = "SEED", default_value_t = 1, requires = "robust")]
    pub robust_seed: u64,
}

impl RobustArguments {
    /// What they ask for, if they do.
    pub fn options(&self) -> Result<Option<RobustOptions>, Failure> {
        let Some(engines) = self.robust else { return Ok(None) };
        let share = self.worst_share.as_ref().map(|text| option::share(text, "--worst-share")).transpose()?;
        if let Some(share) = share
            && !(share > 0.0 && share <= 1.0)
        {
            return Err(Failure::input(
                format_args!("--worst-share needs a share above 0 and up to 100 %, got {}", 100.0 * share),
                "write it like --worst-share '1 %'",
            ));
        }
        let measure = share.map_or(RobustMeasure::Worst, RobustMeasure::MeanOfWorst);
        Ok(Some(RobustOptions { engines, seed: self.robust_seed, measure }))
    }
}
