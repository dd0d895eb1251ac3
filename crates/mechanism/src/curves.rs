//! What is read off functions of the crank angle: extremes, peaks, means, envelopes.

pub(crate) mod envelope;
pub(crate) mod extremes;
pub(crate) mod true_mean;
pub(crate) mod true_peak;
