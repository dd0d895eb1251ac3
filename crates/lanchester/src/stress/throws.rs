//! Torsional stiffness of throws by finite elements.

use crate::stress::mesh::StressMesh;
use crate::stress::request::{StressError, StressStage};
use crate::stress::run::{check_crankshaft, sheet};
use lanchester_flex::FlexError;
use lanchester_flex::crank_twist::{ThrowTwist, TwistEnd, TwistSpan, throw_twists};
use lanchester_flex::statics::SolveOptions;
use lanchester_geometry::crankshaft::CrankshaftError;
use lanchester_model::{CrankElementForm, Engine};

/// Stiffness between the mid-planes of the journals beside each throw, of throws that have one on either side; `watch` sees how far it is.
///
/// # Errors
/// As [`crate::static_stress`].
pub fn throw_stiffnesses(
    engine: &Engine,
    mesh: &StressMesh,
    options: SolveOptions,
    watch: &dyn Fn(StressStage),
) -> Result<Vec<ThrowTwist>, StressError> {
    check_crankshaft(engine, mesh)?;
    let elements = engine
        .crank_elements(mesh.crankshaft)
        .map_err(|fault| FlexError::from(CrankshaftError::from(fault)))?;
    // Journals and throws along the axis.
    let mut before: Option<TwistEnd> = None;
    let mut throws: Vec<usize> = Vec::new();
    let mut spans = Vec::new();
    for element in &elements {
        match &element.form {
            CrankElementForm::Pin { throw, .. } => throws.push(*throw),
            CrankElementForm::Journal { journal, bar } => {
                let end = TwistEnd {
                    set: format!("MAIN_{}", journal + 1),
                    z: 0.5 * (element.faces[0] + element.faces[1]),
                    diameters: [bar.diameter, bar.bore],
                };
                if let (Some(front), [throw]) = (before.take(), throws.as_slice()) {
                    spans.push(TwistSpan { throw: *throw, ends: [front, end.clone()] });
                }
                throws.clear();
                before = Some(end);
            }
            _ => {}
        }
    }
    if spans.is_empty() {
        return Err(StressError::Train {
            crankshaft: mesh.crankshaft + 1,
            needed: "a throw with a journal on either side",
            got: 0,
            hint: "stiffnesses of several throws between two journals are not taken apart: give them in [torsion]",
        });
    }
    let sheet = sheet(engine, mesh, watch)?;
    let estimate = |estimate: &_| watch(StressStage::Factoring(*estimate));
    Ok(throw_twists(&sheet.crank, &spans, options, &estimate)?)
}
