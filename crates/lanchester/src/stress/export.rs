//! A solved case or modes for other programs: decks of CalculiX, VTU of ParaView.

use crate::stress::request::StressError;
use lanchester_flex::case::StaticCase;
use lanchester_flex::crank_case::{BearingSurfaces, CrankSupport, crank_cases, crank_support};
use lanchester_flex::deck::{Analysis, write_deck};
use lanchester_flex::statics::as_node_forces;
use lanchester_flex::vtu::{NodeField, write_vtu};
use lanchester_report::{CrankModes, StaticStress, StressCase};

/// A case as a deck that CalculiX runs unchanged (N, mm, tonne, s, MPa): centrifugal field and inertia relief as forces on nodes.
///
/// # Errors
/// [`StressError::Flex`] where the mesh lacks a set.
pub fn case_deck(
    stress: &StaticStress,
    case: &StressCase,
    support: CrankSupport,
) -> Result<String, StressError> {
    let crank = &stress.sheet.crank;
    let cases = crank_cases(crank, support, std::slice::from_ref(&case.loading))?;
    let mut plain = StaticCase::default();
    if let Some(own) = cases.first() {
        plain = as_node_forces(&crank.mesh, own)?;
    }
    plain.name = format!("{}: {}", stress.sheet.engine, case.name);
    Ok(write_deck(&crank.mesh, &plain, Analysis::Static)?)
}

/// Displacement [m], stress tensor and von Mises stress [Pa] of a case.
pub fn case_vtu(stress: &StaticStress, case: &StressCase) -> Vec<u8> {
    let result = &case.result;
    let tensor = result.stresses.iter().flat_map(|own| own.stress.0).collect();
    let von_mises = result.stresses.iter().map(|own| own.stress.von_mises()).collect();
    let jump = result.stresses.iter().map(|own| own.jump).collect();
    let fields = [
        ("displacement", 3, result.solution.displacements.iter().flatten().copied().collect()),
        ("stress xx yy zz xy yz zx", 6, tensor),
        ("von Mises", 1, von_mises),
        ("jump", 1, jump),
    ];
    let fields = fields.map(|(name, components, values)| field(name, components, values));
    write_vtu(&stress.sheet.crank.mesh, &fields)
}

/// The mesh with its support as a deck for so many natural modes, rigid motions included.
///
/// # Errors
/// [`StressError::Flex`] where the mesh lacks a set.
pub fn modes_deck(found: &CrankModes, support: CrankSupport, count: usize) -> Result<String, StressError> {
    let crank = &found.sheet.crank;
    let mut case = match support {
        CrankSupport::Free => StaticCase::default(),
        support => crank_support(crank, &BearingSurfaces::new(crank), support)?,
    };
    let rigid = if support == CrankSupport::Free { 6 } else { 0 };
    case.name.clone_from(&found.sheet.engine);
    Ok(write_deck(&crank.mesh, &case, Analysis::Frequency(count + rigid))?)
}

/// Shapes of modes, each of modal mass 1 kg.
pub fn modes_vtu(found: &CrankModes) -> Vec<u8> {
    let shape = |(k, mode): (usize, &lanchester_flex::modes::Mode)| {
        let name = format!("mode {} {:.1} Hz", k + 1, mode.frequency);
        field(&name, 3, mode.shape.iter().flatten().copied().collect())
    };
    let fields: Vec<NodeField> = found.modes.modes.iter().enumerate().map(shape).collect();
    write_vtu(&found.sheet.crank.mesh, &fields)
}

fn field(name: &str, components: usize, values: Vec<f64>) -> NodeField {
    NodeField { name: name.to_owned(), components, values }
}
