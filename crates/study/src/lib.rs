//! Kernels of studies: questions about many engines at once.
//!
//! [`compare`] sets engines side by side; [`explore`] searches all layouts of a given number of cylinders; [`scatter`] tells what tolerances of parts do to the
//! residual loads. Requests and results are plain data in SI units and radians; no file, no clock, and no result depends
//! on the number of threads or on how a run was cut into parts.
#![forbid(unsafe_code)]

pub mod compare;
pub mod explore;
pub mod scatter;
pub mod sensitivity;
