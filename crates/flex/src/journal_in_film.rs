//! How a journal rests in its oil film.

use crate::train::Plane;
use serde::Serialize;

/// A journal in its oil film, at rest.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct JournalInFilm {
    /// Its bearing: "main bearing 2".
    pub bearing: String,
    /// Force of the film on the journal, in the frame of the crankshaft [N].
    pub force: Plane,
    /// Journal's centre from that of its shell, in the same frame [m].
    pub eccentricity: Plane,
    /// Its length over the radial clearance.
    pub eccentricity_ratio: f64,
    /// Least film at the middle of the bearing [m].
    pub least_film: f64,
    /// Least film at an end of the bearing by the slope of the journal there [m]: below 0 it touches. The film itself is that of parallel axes.
    pub least_edge_film: f64,
    /// Largest pressure of the film [Pa].
    pub largest_pressure: f64,
    /// Shell's centre from its place without load, by the stiffness of the housing [m].
    pub shell: Plane,
    /// Share of the force that touching roughness carries.
    pub contact_share: f64,
}
