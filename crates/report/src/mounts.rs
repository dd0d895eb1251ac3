//! The block on its mounts.

pub(crate) mod figures;
pub(crate) mod section;
pub(crate) mod shapes;
pub(crate) mod tables;
pub(crate) mod text;

pub use figures::mount_figures;
pub use section::mounts_section;
pub use tables::{
    damped_modes_table, mount_axes_words, mount_modes_table, mount_orders_tables, mount_speeds_table,
    mount_tables, mounted_body_words, mounts_at_rest_table,
};
pub use text::{mount_forces_csv, mount_modes_csv, mount_motion_csv, mount_remarks, mounts_text};
