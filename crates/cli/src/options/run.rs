//! Options of long runs: where the table goes, which part, how many threads.

use crate::run::PartOf;
use clap::Args;
use std::path::PathBuf;

/// Of `explore` and `scatter`.
#[derive(Debug, Args)]
pub struct RunArguments {
    /// Write every case, what was chosen or drawn for it and what came of it, into this table: Parquet (`.parquet`, readable in
    /// pandas and DuckDB) or CSV (`.csv`). A run that is stopped or killed goes on with the same command; until it is done, what
    /// there is lies in a folder `FILE.run`.
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,
    /// Only part k of n of the cases, `2/3`, for computers that share a run; `lanchester merge` joins the tables.
    #[arg(long, value_name = "K/N", requires = "save")]
    pub part: Option<PartOf>,
    /// Threads; default: one for each core.
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
}

impl RunArguments {
    /// As many threads as wanted, for all that is computed from now on.
    pub fn set_threads(&self) {
        if let Some(threads) = self.threads {
            // Set once, before anything is computed; a second time cannot be.
            let _ = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
        }
    }
}
