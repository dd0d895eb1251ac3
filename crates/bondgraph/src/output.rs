//! A graph and its results as texts, drawings and files.

pub(crate) mod draw;
pub(crate) mod export;
mod greek;
mod label;
pub(crate) mod latex;
mod layout;
pub(crate) mod mathml;
pub(crate) mod parts;
pub(crate) mod shown;
pub(crate) mod text;
mod tiles;
pub(crate) mod write;
