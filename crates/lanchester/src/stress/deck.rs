//! A CalculiX deck, solved.

use crate::stress::request::{StressError, StressStage};
use lanchester_flex::FlexError;
use lanchester_flex::deck::{DeckStep, read_deck};
use lanchester_flex::mesh::quality;
use lanchester_flex::modes::modes_watched;
use lanchester_flex::statics::{SolveOptions, StaticSystem, node_stresses};
use lanchester_flex::vtu::{NodeField, write_vtu};
use lanchester_report::{DECK_VERSION, SolvedDeck, SolvedStep, StaticStep};

/// Solves all steps of a deck (N, mm, tonne, s, MPa); with the results as a VTU file in SI units. `watch` sees how far it is.
///
/// # Errors
/// [`StressError::Flex`] with the line of the first card that is not read, or where a step has no solution.
pub fn solve_deck(
    text: &str,
    options: SolveOptions,
    watch: &dyn Fn(StressStage),
) -> Result<(SolvedDeck, Vec<u8>), StressError> {
    let deck = read_deck(text)?;
    let mesh = &deck.mesh;
    watch(StressStage::Meshed(mesh.nodes.len(), mesh.elements.len()));
    if deck.steps.is_empty() {
        return Err(FlexError::Missing {
            what: "step",
            name: "1".to_owned(),
            hint: "a deck needs a *STEP with *STATIC or *FREQUENCY",
        }
        .into());
    }
    let estimate = |estimate: &_| watch(StressStage::Factoring(*estimate));
    let number = |node: usize| deck.node_numbers.get(node).copied().unwrap_or_default();
    let (mut steps, mut fields) = (Vec::new(), Vec::new());
    for (index, step) in deck.steps.iter().enumerate() {
        match step {
            DeckStep::Static(case) => {
                let mut system = StaticSystem::new_watched(mesh, case, options, &estimate)?;
                let solution = system.solve(&[case])?.remove(0);
                let stresses = node_stresses(mesh, &solution.displacements);
                let length = |u: &[f64; 3]| u.iter().map(|x| x * x).sum::<f64>().sqrt();
                let largest = |values: &dyn Fn(usize) -> f64| {
                    let best = (0..mesh.nodes.len()).max_by(|a, b| values(*a).total_cmp(&values(*b)));
                    best.map_or((0.0, 0), |node| (values(node), node))
                };
                let (moved, moved_at) = largest(&|node| length(&solution.displacements[node]));
                let (stress, stress_at) = largest(&|node| stresses[node].stress.von_mises());
                let jump =
                    stresses.get(stress_at).map_or(0.0, |own| own.jump / stress.max(f64::MIN_POSITIVE));
                fields.push(field(
                    index,
                    "displacement",
                    3,
                    solution.displacements.iter().flatten().copied().collect(),
                ));
                fields.push(field(
                    index,
                    "stress xx yy zz xy yz zx",
                    6,
                    stresses.iter().flat_map(|own| own.stress.0).collect(),
                ));
                fields.push(field(
                    index,
                    "von Mises",
                    1,
                    stresses.iter().map(|own| own.stress.von_mises()).collect(),
                ));
                steps.push(SolvedStep::Static(StaticStep {
                    energy: solution.energy,
                    largest_displacement: (moved, number(moved_at)),
                    largest_stress: (stress, number(stress_at), jump),
                    load: solution.load,
                    reaction: solution.reaction,
                    solve: solution.report,
                }));
            }
            DeckStep::Frequency(count, case) => {
                let found = modes_watched(mesh, case, *count, options, &estimate)?;
                for (k, mode) in found.modes.iter().enumerate() {
                    let name = format!("mode {} {:.1} Hz", k + 1, mode.frequency);
                    fields.push(field(index, &name, 3, mode.shape.iter().flatten().copied().collect()));
                }
                steps.push(SolvedStep::Frequency(found));
            }
        }
    }
    let solved = SolvedDeck { version: DECK_VERSION, quality: quality(mesh)?, steps };
    Ok((solved, write_vtu(mesh, &fields)))
}

fn field(step: usize, name: &str, components: usize, values: Vec<f64>) -> NodeField {
    NodeField { name: format!("step {} {name}", step + 1), components, values }
}
