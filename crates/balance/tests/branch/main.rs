//! Branch and bound against brute force: grids of planes and phases, all subsets, random choices.
#[path = "../optimum/support.rs"]
#[allow(dead_code, reason = "shared with the convex tests")]
mod support;

mod amounts;
mod axes;
mod catalogues;
mod choices;
mod example;
mod give_up;
mod limits;
mod places;
mod prices;
mod properties;
mod stops;
