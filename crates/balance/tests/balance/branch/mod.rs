//! Branch and bound against brute force: grids of planes and phases, all subsets, random choices.

mod amounts;
mod axes;
mod budgets;
mod catalogues;
mod choices;
mod example;
mod give_up;
mod limits;
mod places;
mod prices;
mod properties;
mod stops;
