//! Torsional vibration: result, tables, figures, words.

mod figures;
mod result;
mod section;
mod tables;

pub use figures::torsion_figures;
pub use result::*;
pub use section::{torsion_csv, torsion_section, torsion_text};
pub use tables::{
    chain_table, critical_table, damped_mode_table, damper_table, holzer_table, meshed_throws_table,
    mode_table, shaft_order_table, shaft_table, star_table, time_energy_table, time_table,
    torsion_inertia_table, torsion_speed_table, tuning_table, twist_order_table,
};
