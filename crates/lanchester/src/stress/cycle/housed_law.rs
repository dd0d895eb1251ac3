//! What ties a journal to the block: its law, and what is behind the shell.

use lanchester_flex::train::TrainLaw;

/// A law, and the stiffness of the housing behind it [N/m]; `None`: rigid, or part of the law.
#[derive(Debug, Clone)]
pub(crate) struct HousedLaw {
    pub law: TrainLaw,
    pub housing: Option<f64>,
}
