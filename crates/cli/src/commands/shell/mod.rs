//! What a shell and `man` know of the command line, from its one definition.

pub mod completions;
pub mod manual;
