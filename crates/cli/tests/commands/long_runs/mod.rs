//! Long runs: the same table whatever happens on the way.

mod damaged;
mod runs;
mod scatter;
