//! All tests of the crate.

mod support {
    pub mod random_outline;
    pub mod strips;
}
mod counterweight_shape;
mod outline;
mod part;
mod shaft_weight_shape;
mod union;
