//! Quantities at the door: text with a unit to SI and back, for engine files, options and messages.
//!
//! Inside Lanchester all numbers are SI and radians. This crate is where a text such as `"79.5 mm"` becomes one, and where one becomes
//! text again; it knows which values of a quantity make sense, and what to say of those that make none.
//!
//! ```
//! use lanchester_units::{Dimension, exact_text, option, parse};
//!
//! assert_eq!(parse("79.5 mm", Dimension::Length, "stroke").unwrap(), 0.0795);
//! assert_eq!(exact_text(0.0795, Dimension::Length), "79.5 mm");
//! let refused = option::speed("60 mm", "--speed").unwrap_err();
//! assert_eq!(refused.to_string(), "`--speed` needs a speed, got a length");
//! ```
#![forbid(unsafe_code)]

mod nearest;
pub mod option;
mod quantity;

pub use nearest::nearest;
pub use option::BadQuantity;
pub use quantity::*;
