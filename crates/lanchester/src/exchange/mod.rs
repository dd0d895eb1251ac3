//! Loads of an engine for other programs.

pub(crate) mod case_table;
pub(crate) mod crank_train_model;
pub(crate) mod crank_train_unit;
pub(crate) mod force_table;
pub(crate) mod history;
pub(crate) mod loads_model;
pub(crate) mod loads_unit;
pub(crate) mod rigid_train;
pub(crate) mod unit;

pub use case_table::{CaseCell, CaseFault, CaseRow, CaseTable, case_loads};
pub use crank_train_model::{CrankTrainFault, CrankTrainModel, CrankTrainState, CrankTrainStep};
pub use crank_train_unit::crank_train_unit;
pub use force_table::{ForceTableError, ForceTableRequest, LoadedPoints, force_table};
pub use history::{LoadHistory, LoadHistoryError, load_history};
pub use loads_model::{LoadsModel, LoadsModelError};
pub use loads_unit::loads_unit;
pub use rigid_train::{RigidTrainError, rigid_train};
pub use unit::{UNIT_ENGINE, UnitBinary, UnitError, UnitKind, UnitParts, unit_token, unit_trace};
