//! Numerical methods without physics: initial value problems, located events, dense linear algebra and symmetric eigenvalues, roots and peaks of one variable.
//!
//! * [`Esdirk`], implicit, order 4, L-stable, for large stiff systems that solve their own stages, one step at a time.
//!
//! Two integrators share one [`System`], one [`Settings`] and one [`Outcome`]:
//! * [`Dop853`], explicit, order 8 with an interpolant of order 7, for smooth problems that are not stiff;
//! * [`Radau5`], implicit, order 5, stiffly accurate, for stiff problems and systems `M y' = f(t, y)` with singular `M` (index 1).
//!
//! Work is bounded, a state that is no number is an outcome, and nothing here panics on what a system returns.
//!
//! ```
//! use lanchester_numerics::{Dop853, Function, Outcome, Settings};
//! use std::ops::ControlFlow;
//! let mut system = Function::new(2, |_t, y: &[f64], dy: &mut [f64]| {
//!     dy[0] = y[1];
//!     dy[1] = -y[0];
//! });
//! let (mut t, mut y) = (0.0, vec![1.0, 0.0]);
//! let outcome = Dop853::new(Settings::uniform(2, 1e-10)).run(&mut system, &mut t, &mut y, 10.0, |_| ControlFlow::Continue(()));
//! assert_eq!(outcome, Outcome::Reached);
//! assert!((y[0] - 10f64.cos()).abs() < 1e-8);
//! ```

mod angle;
mod control;
mod dense;
mod dop853;
mod dop853_table;
mod esdirk;
mod event;
mod field;
mod golden;
mod interval;
mod jet;
mod kernel;
mod lanes;
mod outcome;
mod quadrature;
mod radau;
mod radau_table;
mod root;
mod settings;
mod simplex;
mod stages;
mod step;
mod symmetric;
mod system;

pub use angle::{about_zero, within_period};
pub use dense::{ComplexLu, Lu};
pub use dop853::Dop853;
pub use esdirk::{Esdirk, StageSystem};
pub use field::Field;
pub use golden::golden_section;
pub use interval::Interval;
pub use jet::{Jet, Ring};
pub use kernel::{Kernel, Vectors, dispatch};
pub use lanes::{ComplexLanes, LANES, Lanes};
pub use outcome::{Outcome, Statistics};
pub use quadrature::{GAUSS_4, GAUSS_8, GAUSS_16, GaussPair, gauss, unit_points};
pub use radau::Radau5;
pub use root::{Root, bisect, illinois, last_holding};
pub use settings::{SampleGrid, Settings};
pub use simplex::{Simplex, SimplexEnd, SimplexRow};
pub use step::Step;
pub use symmetric::SymmetricEigen;
pub use system::{Function, System};
