//! What can be asked, question by question.

pub(crate) mod balancing;
pub(crate) mod bond_graph;
pub(crate) mod counterweights;
pub(crate) mod design_choice;
pub(crate) mod figures;
pub(crate) mod files;
pub(crate) mod fillet_bands;
pub(crate) mod reading;
pub(crate) mod results;
pub(crate) mod sensitivity;
pub(crate) mod session;
pub(crate) mod shape_preview;
pub(crate) mod simulation;
pub(crate) mod stress;
pub(crate) mod studies;
pub(crate) mod summary;
pub(crate) mod torsion;

use crate::api::Api;

/// The one list of questions, but for their own description, which [`crate::openapi`] adds.
pub(crate) fn all() -> Api {
    let lists = [
        session::questions,
        files::questions,
        reading::questions,
        results::questions,
        torsion::questions,
        stress::questions,
        fillet_bands::questions,
        sensitivity::questions,
        simulation::questions,
        studies::questions,
        figures::questions,
        balancing::questions,
        counterweights::questions,
        bond_graph::questions,
        shape_preview::questions,
    ];
    lists.into_iter().fold(Api::new(), |api, questions| questions(api))
}
