//! Optima, methods and arrangements.

mod balance;
mod consequences;
mod durable;
mod methods;
mod search;
mod search_limits;
mod shaft_weights;
mod speeds;
mod sweep;
