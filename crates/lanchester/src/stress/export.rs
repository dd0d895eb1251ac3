//! A solved case or modes for other programs: decks of CalculiX, VTU of ParaView, glTF and STL.

use crate::stress::request::StressError;
use lanchester_flex::case::StaticCase;
use lanchester_flex::crank_case::{BearingSurfaces, CrankSupport, crank_cases, crank_support};
use lanchester_flex::crank_rings::{RingsOf, rings_deck};
use lanchester_flex::deck::{Analysis, write_deck};
use lanchester_flex::modes::Mode;
use lanchester_flex::picture::{Morph, colour, glb, shown_factor, stl};
use lanchester_flex::statics::as_node_forces;
use lanchester_flex::vtu::{NodeField, write_collection, write_vtu};
use lanchester_report::{CrankModes, StaticStress, StressCase};

/// A case as a deck that CalculiX runs unchanged (N, mm, tonne, s, MPa): centrifugal field and inertia relief as forces on nodes,
/// rings as contact pairs.
///
/// # Errors
/// [`StressError::Flex`] where the mesh lacks a set.
pub fn case_deck(
    stress: &StaticStress,
    case: &StressCase,
    support: &CrankSupport,
) -> Result<String, StressError> {
    let crank = &stress.sheet.crank;
    if let CrankSupport::Rings { thickness, modulus } = *support {
        let name = format!("{}: {}", stress.sheet.engine, case.name);
        return Ok(rings_deck(crank, RingsOf { thickness, modulus }, &case.loading, &name)?);
    }
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

/// All cases over the crank angle [deg] for ParaView: the collection, and for each case the name of its file and what stands in it
/// ([`case_vtu`]). Cases without an angle, and those of several speeds, which have each angle several times, are numbered from 1 in place of it.
pub fn cases_pvd<'a>(
    stress: &'a StaticStress,
    stem: &'a str,
) -> (String, impl Iterator<Item = (String, Vec<u8>)> + 'a) {
    let name = move |k: usize| format!("{stem}-{:03}.vtu", k + 1);
    let mut angles: Vec<f64> =
        stress.cases.iter().filter_map(|case| case.theta.map(f64::to_degrees)).collect();
    let speed = stress.cases.first().map(|case| case.speed);
    if angles.len() < stress.cases.len() || stress.cases.iter().any(|case| Some(case.speed) != speed) {
        angles = (1..=stress.cases.len()).map(|number| number as f64).collect();
    }
    // Without what conversion to degrees leaves behind the ninth place.
    let time = |angle: f64| (1e9 * angle).round() / 1e9;
    let files: Vec<(f64, String)> =
        angles.into_iter().enumerate().map(|(k, angle)| (time(angle), name(k))).collect();
    let cases = stress.cases.iter().enumerate().map(move |(k, case)| (name(k), case_vtu(stress, case)));
    (write_collection(&files), cases)
}

/// The mesh with its support as a deck for so many natural modes, rigid motions included.
///
/// # Errors
/// [`StressError::Flex`] where the mesh lacks a set.
pub fn modes_deck(found: &CrankModes, support: &CrankSupport, count: usize) -> Result<String, StressError> {
    let crank = &found.sheet.crank;
    let mut case = match support {
        CrankSupport::Free => StaticCase::default(),
        support => crank_support(crank, &BearingSurfaces::new(crank), support, 0.0)?,
    };
    let rigid = if *support == CrankSupport::Free { 6 } else { 0 };
    case.name.clone_from(&found.sheet.engine);
    Ok(write_deck(&crank.mesh, &case, Analysis::Frequency(count + rigid))?)
}

/// Shapes of modes, each of modal mass 1 kg.
pub fn modes_vtu(found: &CrankModes) -> Vec<u8> {
    let shape = |(k, mode): (usize, &Mode)| {
        let name = format!("mode {} {:.1} Hz", k + 1, mode.frequency);
        field(&name, 3, mode.shape.iter().flatten().copied().collect())
    };
    let fields: Vec<NodeField> = found.modes.modes.iter().enumerate().map(shape).collect();
    write_vtu(&found.sheet.crank.mesh, &fields)
}

/// Share of the length of the crankshaft by which the largest displacement is shown.
const SHOWN: f64 = 0.05;

/// The surface under a case as binary glTF: colours from no stress (blue) to the largest in a fillet (red), the deformation as a morph target
/// with an animation. `factor`: by which displacements are shown; a round one unless given.
///
/// # Errors
/// [`StressError::Flex`] for a surface larger than the format can hold.
pub fn case_glb(
    stress: &StaticStress,
    case: &StressCase,
    factor: Option<f64>,
) -> Result<Vec<u8>, StressError> {
    let (crank, result) = (&stress.sheet.crank, &case.result);
    let largest = case.worst().and_then(|peak| peak.stress).map_or(1.0, |peak| peak.von_mises);
    let colours: Vec<[f64; 3]> =
        result.stresses.iter().map(|own| colour(own.stress.von_mises() / largest)).collect();
    let displacements = &result.solution.displacements;
    let factor = factor.unwrap_or_else(|| shown_factor(&crank.mesh, displacements, SHOWN));
    let name = format!("deformation x {factor}");
    let morph = Morph { name: &name, displacements, factor, swings: false };
    let name = format!("{}, von Mises stress, red is {:.0} MPa", stress.sheet.engine, 1e-6 * largest);
    Ok(glb(&crank.mesh, &name, &colours, &[morph])?)
}

/// The surface under a case as binary STL [mm], displacements `factor` times.
///
/// # Errors
/// As [`case_glb`].
pub fn case_stl(stress: &StaticStress, case: &StressCase, factor: f64) -> Result<Vec<u8>, StressError> {
    Ok(stl(&stress.sheet.crank.mesh, &case.result.solution.displacements, factor)?)
}

/// The surface with each mode as a morph target that swings in an animation of its own, as binary glTF; colours by the size of the motion in the
/// first mode.
///
/// # Errors
/// As [`case_glb`].
pub fn modes_glb(found: &CrankModes, factor: Option<f64>) -> Result<Vec<u8>, StressError> {
    let (crank, modes) = (&found.sheet.crank, &found.modes.modes);
    let length = |u: &[f64; 3]| u.iter().map(|x| x * x).sum::<f64>().sqrt();
    let name = |(k, mode): (usize, &Mode)| format!("mode {} {:.1} Hz", k + 1, mode.frequency);
    let names: Vec<String> = modes.iter().enumerate().map(name).collect();
    let morph = |(mode, name)| -> Morph<'_> {
        let (mode, name): (&Mode, &String) = (mode, name);
        let factor = factor.unwrap_or_else(|| shown_factor(&crank.mesh, &mode.shape, SHOWN));
        Morph { name, displacements: &mode.shape, factor, swings: true }
    };
    let morphs: Vec<Morph> = modes.iter().zip(&names).map(morph).collect();
    let first = modes.first().map_or(&[][..], |mode| mode.shape.as_slice());
    let largest = first.iter().map(length).fold(0.0, f64::max);
    let colours: Vec<[f64; 3]> = first.iter().map(|u| colour(length(u) / largest)).collect();
    Ok(glb(&crank.mesh, &format!("{}, natural modes", found.sheet.engine), &colours, &morphs)?)
}

fn field(name: &str, components: usize, values: Vec<f64>) -> NodeField {
    NodeField { name: name.to_owned(), components, values }
}
