//! The studio's answers as a WebAssembly module, for a worker of a browser.
//!
//! The door is a few functions of the C kind ([`door`]): the page writes a question into the module's memory, calls, and reads the answer
//! there. [`Module`] is what stands behind it, in plain Rust. Each module answers one question at a time and keeps nothing that matters: a
//! page that has waited long enough throws it away, with what it was computing, and makes another.

pub mod door;
mod module;
mod shelf;

pub use module::Module;
pub use shelf::Shelf;
