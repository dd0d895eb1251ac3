//! Search over layouts: throw angles, firing order, bank angle, offset pins, rod ratio, counterweights, shafts.
//!
//! A [`Space`] is a product of lists. Its cases are numbered, and number and case determine each other, so that a run may
//! be cut anywhere and memory does not grow with the number of cases. Layouts that are equivalent by symmetry are one
//! (symmetry). [`Explorer`] judges cases; [`Exploration`] is what is known so far. Engines that are not one bank, or two alike, are
//! searched with their cylinders where they are ([`Arrangement`]).

mod answer;
mod as_given;
mod candidate;
mod choice;
mod constraint;
mod counterweight_pattern;
mod counts;
mod durability;
mod error;
mod explorer;
mod firing;
mod front;
mod kernel;
mod layout;
mod layout_engine;
mod layout_meter;
mod layout_orders;
mod objective;
mod parts;
mod sample;
mod search;
mod shaft_set;
mod space;
mod symmetry;
mod walk;

pub use answer::{ExploreAnswer, FoundLayout, GivenEngine, JudgedBy};
pub use as_given::{Arrangement, ArrangementError};
pub use candidate::Candidate;
pub use choice::Choice;
pub use constraint::Constraint;
pub use counterweight_pattern::CounterweightPattern;
pub use counts::{Broken, Counts, Invalid, InvalidCount};
pub use error::ExploreError;
pub use explorer::{EXPLORATION_VERSION, Exploration, ExploreRequest, Explorer, Run};
pub use layout::{BankPair, Layout};
pub use layout_meter::LayoutMeter;
pub use layout_orders::LayoutOrders;
pub use objective::{Objective, Sense};
pub use parts::Parts;
pub use sample::JudgedCase;
pub use shaft_set::{Removes, ShaftDesign, ShaftSet};
pub use space::{Banks, ChoiceCount, Space, even_angles};
