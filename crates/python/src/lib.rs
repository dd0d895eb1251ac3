//! The module `lanchester._native`: the facade for Python.
//!
//! A front end alone: it reads what Python gives, calls the facade without the interpreter's lock, and hands back results of which Python
//! converts what it looks at. Units end here; no physics begins.
//!
//! Where to start: `questions` has a file for every kind of question, `to_python.rs` turns any serialisable result
//! into Python values. The classes that users see are in `python/lanchester`.
#![forbid(unsafe_code)]

mod answer;
mod asking;
mod blocks;
mod cases;
mod decimals;
mod failure;
mod from_python;
mod guard;
mod map;
mod native_engine;
mod native_sheet;
mod native_study;
mod options;
mod prepared;
mod question;
mod questions;
mod select;
mod solids;
mod to_python;

use pyo3::prelude::*;

/// The functions and classes behind the package `lanchester`.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::answer::Answer;
    #[pymodule_export]
    use super::answer::path_steps;
    #[pymodule_export]
    use super::asking::ask_all;
    #[pymodule_export]
    use super::asking::ask_sheet;
    #[pymodule_export]
    use super::asking::kernel_time;
    #[pymodule_export]
    use super::asking::panics;
    #[pymodule_export]
    use super::asking::schemas;
    #[pymodule_export]
    use super::decimals::decimal_points;
    #[pymodule_export]
    use super::map::map;
    #[pymodule_export]
    use super::native_engine::NativeEngine;
    #[pymodule_export]
    use super::native_sheet::NativeSheet;
    #[pymodule_export]
    use super::native_study::NativeStudy;
    #[pymodule_export]
    use super::native_study::held;
    #[pymodule_export]
    use super::native_study::study;

    #[pymodule_init]
    fn init(_module: &pyo3::Bound<'_, pyo3::types::PyModule>) -> pyo3::PyResult<()> {
        super::guard::imported();
        Ok(())
    }

    /// The version of the package.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}
