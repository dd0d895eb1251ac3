//! Throws and cylinders as far as they could be read.

use super::crank::DraftThrow;
use crate::document::{Section, Span};
use lanchester_model::Cylinder;

/// Throws and cylinders as far as they could be read.
pub(super) struct Drafts<'a> {
    pub(super) throws: Vec<Option<DraftThrow>>,
    pub(super) cylinders: Vec<Option<DraftCylinder<'a>>>,
    /// Whether they come from `[layout]`.
    pub(super) from_layout: bool,
}

impl<'a> Drafts<'a> {
    /// Midway between the first and the last throw plane; `None` if not all are known.
    pub(super) fn middle(&self) -> Option<f64> {
        let planes: Option<Vec<f64>> =
            self.throws.iter().map(|throw| throw.as_ref().map(|throw| throw.throw.z)).collect();
        let planes = planes?;
        let first = planes.iter().copied().fold(f64::INFINITY, f64::min);
        let last = planes.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        (!planes.is_empty()).then(|| first + (last - first) / 2.0)
    }

    pub(super) fn into_parts(self) -> (Option<Vec<DraftThrow>>, Option<Vec<DraftCylinder<'a>>>) {
        (self.throws.into_iter().collect(), self.cylinders.into_iter().collect())
    }
}

/// A cylinder and where the file speaks of it.
#[derive(Debug, Clone)]
pub(super) struct DraftCylinder<'a> {
    pub(super) cylinder: Cylinder,
    /// Its own table, if it has one.
    pub(super) section: Option<&'a Section>,
    /// Its header, or the layout's.
    pub(super) span: Span,
    pub(super) length_span: Span,
    pub(super) piston_mass_span: Span,
    pub(super) bore_span: Option<Span>,
    /// Whether its rod says that it has its pin for itself.
    pub(super) own_pin: bool,
}
