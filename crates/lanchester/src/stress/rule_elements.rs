//! Stress concentration factors by finite elements beside those of the formulas.

use crate::stress::mesh::{MOST_NODES, StressMesh};
use crate::stress::request::{StressError, StressStage};
use crate::stress::run::check_crankshaft;
use crate::stress::throw_shape::ThrowShape;
use lanchester_flex::FlexError;
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh_of_bay};
use lanchester_flex::statics::SolveOptions;
use lanchester_flex::throw_stress::{FilletStress, ThrowStress, ThrowSupports, throw_stress};
use lanchester_geometry::crankshaft::crankshaft;
use lanchester_model::Engine;
use lanchester_report::{CrankRule, MeshOrigin, ThrowMesh};
use lanchester_strength::{FactorValues, FilletStresses, RuleMaterial, RuleThrow, rule_throws};

/// Words of what lies outside every throw.
const BEYOND: &str = "(beyond the bay)";

/// Fewest elements across a fillet that the rule's appendix accepts.
const FEWEST: usize = 6;

/// The sheet with the factors of every throw by finite elements, each throw that is none of those before, moved or mirrored, meshed and
/// solved alone; `watch` sees how far it is.
///
/// # Errors
/// As [`crate::static_stress`]; [`StressError::CoarseFactors`] for less than six elements across a fillet.
pub fn with_element_factors(
    engine: &Engine,
    mut rule: CrankRule,
    mesh: &StressMesh,
    solve: SolveOptions,
    watch: &dyn Fn(StressStage),
) -> Result<CrankRule, StressError> {
    check_crankshaft(engine, mesh)?;
    let mut mesh = mesh.clone();
    let got = mesh.options.fillet_elements;
    if got < FEWEST {
        // What the file says is meant for the whole crankshaft.
        if mesh.origins.fillet_elements != MeshOrigin::File {
            return Err(StressError::CoarseFactors { needed: FEWEST, got });
        }
        mesh.options.fillet_elements = FEWEST;
    }
    let mesh = &mesh;
    let material =
        RuleMaterial { tensile_strength: rule.tensile_strength.value, forging: rule.forging.value };
    let body = crankshaft(engine, mesh.crankshaft).map_err(FlexError::from)?;
    let mut solved: Vec<Solved> = Vec::new();
    let (mut left_out, mut bored): (Vec<String>, Vec<String>) = (Vec::new(), Vec::new());
    for throw in rule_throws(engine, mesh.crankshaft)? {
        let (bay, options) = meshed(engine, mesh, throw.throw + 1)?;
        let supports = ThrowSupports { pin: throw.throw + 1, mains: throw.mains };
        for words in bay.left_out.iter().filter(|words| !words.contains(BEYOND)) {
            if !left_out.contains(words) {
                left_out.push(words.clone());
            }
        }
        if throw.sections.iter().any(|section| section.pin_bore > 0.0) {
            bored.push((throw.throw + 1).to_string());
        }
        let shape = ThrowShape::new(&body, &bay, &throw)?;
        let known = solved.iter().find_map(|own| {
            let [front, rear] = own.factors;
            let is_same = shape.is_near(&own.shape);
            let factors = match is_same {
                true => [front, rear],
                false if shape.mirrored().is_near(&own.shape) => [rear, front],
                false => return None,
            };
            Some((factors, ThrowMesh { throw: throw.throw + 1, ..own.mesh.clone() }))
        });
        let (factors, mesh) = match known {
            Some(known) => known,
            None => {
                watch(StressStage::Meshed(bay.mesh.nodes.len(), bay.mesh.elements.len()));
                let estimate = |estimate: &_| watch(StressStage::Factoring(*estimate));
                let found = throw_stress(&bay, supports, solve, &estimate)?;
                let own = (throw_factors(&throw, &found)?, throw_mesh(&bay, options, &throw, &found));
                solved.push(Solved { shape, factors: own.0, mesh: own.1.clone() });
                own
            }
        };
        for own in rule.speeds.iter_mut().flat_map(|sheet| &mut sheet.throws) {
            if own.throw == throw.throw + 1 {
                *own = own.clone().with_elements(factors, material);
            }
        }
        rule.by_elements.push(mesh);
    }
    if !left_out.is_empty() {
        let all = left_out.join(", ");
        rule.notes.push(format!(
            "Not meshed for factors by finite elements: {all}. They do not judge fillets with a recess."
        ));
    }
    if !bored.is_empty() {
        rule.notes.push(format!(
            "The bore of pin {} ends at its webs, in [crank.body] and in the mesh; that of the formulas, d_H, goes through them.",
            bored.join(", ")
        ));
    }
    if mesh.own.is_some() {
        rule.notes.push(
            "The mesh of the file is not used for factors by finite elements: throws are cut from the crankshaft of [crank.body]."
                .to_owned(),
        );
    }
    Ok(rule)
}

/// A throw whose factors are known: those that are the same, moved or mirrored, have them too.
struct Solved {
    shape: ThrowShape,
    factors: [FactorValues; 2],
    mesh: ThrowMesh,
}

fn throw_mesh(
    bay: &CrankMesh,
    options: CrankMeshOptions,
    throw: &RuleThrow,
    found: &ThrowStress,
) -> ThrowMesh {
    ThrowMesh {
        throw: throw.throw + 1,
        size: options.size,
        fillet_elements: options.fillet_elements,
        nodes: bay.mesh.nodes.len(),
        least_jacobian: bay.quality.least_jacobian,
        residual: found.report.residual,
        jump: found.fillets.iter().map(|own| own.jump).fold(0.0, f64::max),
    }
}

/// The bay of a throw with as many elements across its fillets as wanted; with more where nobody says how many and so many make misshapen ones.
fn meshed(
    engine: &Engine,
    mesh: &StressMesh,
    pin: usize,
) -> Result<(CrankMesh, CrankMeshOptions), StressError> {
    let mut options = mesh.options;
    loop {
        let found = crank_mesh_of_bay(engine, mesh.crankshaft, options, pin);
        let nobody_says = mesh.origins.fillet_elements == MeshOrigin::Usual;
        match found {
            Err(FlexError::Crowded { .. }) if nobody_says && options.fillet_elements < FEWEST + 4 => {
                options.fillet_elements += 2;
            }
            Ok(bay) if bay.mesh.nodes.len() > MOST_NODES && mesh.origins.size == MeshOrigin::Usual => {
                // Larger elements away from fillets.
                if options.size > 4.0 * mesh.options.size {
                    return Ok((bay, options));
                }
                options.size *= 1.5;
            }
            other => return Ok((other?, options)),
        }
    }
}

/// Stress concentration factors of both webs of a throw, from the stresses of its fillets.
///
/// # Errors
/// [`FlexError::Missing`] where a corner of the throw is sharp.
pub fn throw_factors(throw: &RuleThrow, found: &ThrowStress) -> Result<[FactorValues; 2], StressError> {
    let fillet = |name: String| -> Result<&FilletStress, StressError> {
        found.fillets.iter().find(|own| own.name == name).ok_or(StressError::Flex(FlexError::Missing {
            what: "fillet",
            name,
            hint: "its corner needs a radius in [crank.body]",
        }))
    };
    let of = |side: usize| -> Result<FactorValues, StressError> {
        let (web, journal) = (throw.web_numbers[side], throw.journals[side]);
        let pin = fillet(format!("pin {} at web {web}", throw.throw + 1))?;
        let journal = fillet(format!("journal {journal} at web {web}"))?;
        let stresses = FilletStresses {
            pin_bending: pin.bending,
            journal_bending: journal.bending,
            journal_force: journal.force,
            pin_torsion: pin.torsion,
            journal_torsion: journal.torsion,
        };
        Ok(stresses.factors(throw, side))
    };
    Ok([of(0)?, of(1)?])
}
