//! Decks of CalculiX: written so that `ccx` runs them unchanged, and the same subset read back.
//!
//! Units of a deck: N, mm, tonne, s, MPa. Cards: `*HEADING`, `*NODE`, `*ELEMENT` (C3D10, C3D15, C3D20), `*NSET` and `*ELSET` with
//! `GENERATE`, `*MATERIAL`, `*ELASTIC`, `*DENSITY`, `*SOLID SECTION`, `*BOUNDARY`, `*EQUATION` with `SPRING1` and `*SPRING` on a reference node, `*CLOAD`, `*STEP` with `*STATIC` or `*FREQUENCY`,
//! and outputs, which are passed over. Any other card is an error with its line.

mod contact;
mod read;
mod springs;
mod write;

pub(crate) use contact::with_contact;
pub use read::{Deck, DeckStep, read_deck, read_mesh};
pub use write::{Analysis, write_deck};
