//! Loads of an engine for other programs.

pub(crate) mod case_table;
pub(crate) mod force_table;
pub(crate) mod history;
pub(crate) mod loads_model;
pub(crate) mod loads_unit;
pub(crate) mod rigid_train;

pub use case_table::{CaseCell, CaseFault, CaseRow, CaseTable, case_loads};
pub use force_table::{ForceTableError, ForceTableRequest, LoadedPoints, force_table};
pub use history::{LoadHistory, load_history};
pub use loads_model::{LoadsModel, LoadsModelError};
pub use loads_unit::{LoadsUnitError, UNIT_ENGINE, UnitBinary, loads_unit, unit_token, unit_trace};
pub use rigid_train::{RigidTrainError, rigid_train};
