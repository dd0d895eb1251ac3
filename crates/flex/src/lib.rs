//! The flexible crankshaft: finite elements, sparse solver, static cases, modes, exchange with CalculiX and ParaView.
//!
//! SI units; frame of the engine: z along the crank. Reads nothing and writes nothing: decks and pictures are text.
#![forbid(unsafe_code)]

pub mod case;
pub mod contact;
pub mod crank_case;
mod crank_films;
pub mod crank_mesh;
pub mod crank_rings;
pub mod crank_solve;
pub mod crank_twist;
pub mod deck;
mod eigen;
pub mod element;
mod error;
mod film_equilibrium;
pub mod journal_in_film;
pub mod known_bodies;
mod material;
pub mod mesh;
pub mod modes;
pub mod oil_pressure;
pub mod own_mesh;
pub mod picture;
pub mod reduction;
pub mod richardson;
pub mod sparse;
pub mod statics;
pub mod submodel;
pub mod throw_stress;
pub mod train;
pub mod vtu;

pub use error::{FlexError, bytes_words};
pub use material::Material;
pub use mesh::LEAST_JACOBIAN;
