//! Our solver against CalculiX on the same decks, and decks that cannot be read.

use lanchester_flex::case::StaticCase;
use lanchester_flex::deck::{Analysis, Deck, DeckStep, read_deck, write_deck};
use lanchester_flex::element::ElementKind;
use lanchester_flex::element::{stiffness_rule, stress_at};
use lanchester_flex::mesh::mapped_block;
use lanchester_flex::modes::modes;
use lanchester_flex::statics::{SolveOptions, solve_static};
use lanchester_flex::{FlexError, Material};
use serde_json::Value;

const NAMES: [&str; 3] = ["tetrahedra", "wedges", "hexahedra"];

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/external/calculix");

fn text(name: &str) -> String {
    std::fs::read_to_string(format!("{FOLDER}/{name}")).unwrap()
}

/// A quarter of a bent, thick-walled pipe that widens: curved edges, no two elements alike.
fn exported(kind: ElementKind, name: &str, analysis: Analysis) -> String {
    let mesh = mapped_block(kind, [2, 4, 5], Material::steel(), |x| {
        let radius = 0.02 + 0.012 * x[0] + 0.004 * x[2];
        let (sin, cos) = (1.5 * x[1] + 0.2 * x[2]).sin_cos();
        [radius * cos + 0.02 * x[2] * x[2], radius * sin, 0.09 * x[2]]
    });
    let base = mesh.pick(|x| x[2] < 1e-9);
    let tip = mesh.pick(|x| x[2] > 0.09 - 1e-9);
    let each = 1.0 / tip.len() as f64;
    let tip: Vec<(u32, f64)> = tip.into_iter().map(|node| (node, each)).collect();
    let case = StaticCase { name: name.to_owned(), ..StaticCase::default() };
    write_deck(&mesh, &case.clamp(&base).push(&tip, [900.0, -400.0, 650.0]), analysis).unwrap()
}

#[test]
fn snap_decks_are_those_that_were_run() {
    let kinds = [ElementKind::Tetrahedron, ElementKind::Wedge, ElementKind::Hexahedron];
    for (kind, name) in kinds.into_iter().zip(NAMES) {
        for (analysis, word) in [(Analysis::Static, "static"), (Analysis::Frequency(6), "modes")] {
            let name = format!("{name}-{word}");
            let deck = exported(kind, &name, analysis);
            if std::env::var_os("LANCHESTER_WRITE_DECKS").is_some() {
                std::fs::write(format!("{FOLDER}/{name}.inp"), &deck).unwrap();
            }
            // sin and cos differ by a rounding from machine to machine: the numbers are compared.
            let (ours, run) = (read_deck(&deck).unwrap(), read_deck(&text(&format!("{name}.inp"))).unwrap());
            assert_eq!(ours.mesh.elements, run.mesh.elements, "{name}");
            for (a, b) in ours.mesh.nodes.iter().flatten().zip(run.mesh.nodes.iter().flatten()) {
                assert!((a - b).abs() < 1e-13, "{name}: {a} {b}");
            }
            assert_eq!(deck.lines().count(), text(&format!("{name}.inp")).lines().count(), "{name}");
        }
    }
}

fn deck(name: &str) -> Deck {
    read_deck(&text(&format!("{name}.inp"))).unwrap()
}

fn results(name: &str) -> Value {
    let all: Value = serde_json::from_str(&text("results.json")).unwrap();
    all["cases"][name].clone()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()
}

#[test]
fn ext_calculix_static() {
    for name in NAMES {
        let name = format!("{name}-static");
        let (deck, wanted) = (deck(&name), results(&name));
        let DeckStep::Static(case) = &deck.steps[0] else { panic!("a static step") };
        let solution = solve_static(&deck.mesh, case, SolveOptions::default()).unwrap();
        let energy = wanted["energy_mJ"].as_f64().unwrap();
        assert!(
            (1e3 * solution.energy / energy - 1.0).abs() < 1e-6,
            "{name}: {} {energy}",
            1e3 * solution.energy
        );
        let theirs: Vec<Vec<f64>> =
            wanted["displacements_mm"].as_array().unwrap().iter().map(numbers).collect();
        assert_eq!(theirs.len(), deck.mesh.nodes.len());
        let largest = theirs.iter().flatten().fold(0.0f64, |most, u| most.max(u.abs()));
        for (ours, theirs) in solution.displacements.iter().zip(&theirs) {
            for axis in 0..3 {
                assert!(
                    (1e3 * ours[axis] - theirs[axis]).abs() < 1e-6 * largest,
                    "{name}: {ours:?} {theirs:?}"
                );
            }
        }
        for (ours, load) in solution.reaction.iter().zip(solution.load) {
            assert!((ours + load).abs() < 1e-6, "balance: {ours} {load}");
        }
        // Stresses at the integration points, in the order xx, yy, zz, xy, xz, yz.
        let element = &deck.mesh.elements[0];
        let places = deck.mesh.places(element);
        let moved: Vec<[f64; 3]> =
            element.nodes.iter().map(|node| solution.displacements[*node as usize]).collect();
        let stresses = wanted["stresses_MPa_first_element"].as_array().unwrap();
        let rule = stiffness_rule(element.kind);
        assert_eq!(stresses.len(), rule.len());
        for (point, theirs) in rule.iter().zip(stresses) {
            let [xx, yy, zz, xy, yz, zx] =
                stress_at(element.kind, &places, &moved, &deck.mesh.materials[0], point.at).0;
            for (ours, theirs) in [xx, yy, zz, xy, zx, yz].iter().zip(numbers(theirs)) {
                assert!((1e-6 * ours - theirs).abs() < 1e-4, "{name}: {ours} {theirs}");
            }
        }
    }
}

/// A crankshaft of one throw with fillets under the force of its pin and its centrifugal field, clamped at its ends, as `stress export` wrote it.
#[test]
fn ext_calculix_crankshaft() {
    let (deck, wanted) = (deck("crank-static"), results("crank-static"));
    let DeckStep::Static(case) = &deck.steps[0] else { panic!("a static step") };
    let solution = solve_static(&deck.mesh, case, SolveOptions::default()).unwrap();
    let energy = wanted["energy_mJ"].as_f64().unwrap();
    assert!((1e3 * solution.energy / energy - 1.0).abs() < 1e-6, "{} {energy}", 1e3 * solution.energy);
    let largest = wanted["largest_displacement_mm"].as_f64().unwrap();
    let length = |u: &[f64; 3]| u.iter().map(|u| u * u).sum::<f64>().sqrt();
    let ours = solution.displacements.iter().map(length).fold(0.0, f64::max);
    assert!((1e3 * ours / largest - 1.0).abs() < 1e-6, "{} {largest}", 1e3 * ours);
    let some = wanted["some_displacements_mm"].as_array().unwrap();
    assert!(some.len() > 200);
    for row in some.iter().map(numbers) {
        let ours = solution.displacements[row[0] as usize - 1];
        for (ours, theirs) in ours.iter().zip(&row[1..]) {
            assert!((1e3 * ours - theirs).abs() < 1e-6 * largest, "node {}: {ours} {theirs}", row[0]);
        }
    }
}

#[test]
fn ext_calculix_modes() {
    for name in NAMES {
        let name = format!("{name}-modes");
        let (deck, wanted) = (deck(&name), numbers(&results(&name)["frequencies_Hz"]));
        let DeckStep::Frequency(count, case) = &deck.steps[0] else { panic!("a step of frequencies") };
        assert_eq!(*count, wanted.len());
        // With CalculiX's rule for the mass the same to its printed digits; with the exact rule, the lowest two within 2e-4, and the
        // higher ones of so coarse a mesh within 6e-4: they are what the rule leaves out of 5 elements over a wave.
        for (coarse_mass, tolerances) in [(true, [1e-6, 1e-6]), (false, [2e-4, 6e-4])] {
            let options = SolveOptions { coarse_mass, ..SolveOptions::default() };
            let found = modes(&deck.mesh, case, *count, options).unwrap();
            for (k, (mode, wanted)) in found.modes.iter().zip(&wanted).enumerate() {
                let off = (mode.frequency / wanted - 1.0).abs();
                assert!(
                    off < tolerances[usize::from(k > 1)],
                    "{name} {coarse_mass}: {} {wanted}",
                    mode.frequency
                );
                assert!(mode.residual < 1e-8);
            }
        }
    }
}

#[test]
fn a_deck_that_is_read_and_written_is_the_same_deck() {
    for name in NAMES {
        let name = format!("{name}-static");
        let deck = deck(&name);
        let DeckStep::Static(case) = &deck.steps[0] else { panic!("a static step") };
        let mut mesh = deck.mesh.clone();
        mesh.sets.clear();
        let again = read_deck(&write_deck(&mesh, case, Analysis::Static).unwrap()).unwrap();
        let DeckStep::Static(other) = &again.steps[0] else { panic!("a static step") };
        assert_eq!(again.mesh.elements, mesh.elements);
        assert_eq!((&other.fixed, other.forces.len()), (&case.fixed, case.forces.len()));
        for (a, b) in again.mesh.nodes.iter().flatten().zip(mesh.nodes.iter().flatten()) {
            assert!((a - b).abs() < 1e-14);
        }
    }
}

#[test]
fn bad_decks_are_refused_with_their_line() {
    let good = text("wedges-static.inp");
    let change = |from: &str, to: &str| {
        assert!(good.contains(from), "{from}");
        good.replacen(from, to, 1)
    };
    let of_line = |text: String, line: usize, word: &str| match read_deck(&text) {
        Err(FlexError::Deck { line: got, message }) => {
            assert!(got == line && message.contains(word), "line {got}: {message}, wanted {line}: {word}");
        }
        other => panic!("{word}: {other:?}"),
    };
    let line_of = |what: &str| good.lines().position(|line| line.starts_with(what)).unwrap() + 1;
    of_line(change("*STATIC", "*DYNAMIC"), line_of("*STATIC"), "unknown card *DYNAMIC");
    of_line(change("TYPE=C3D15", "TYPE=C3D8"), line_of("*ELEMENT"), "unknown element type");
    of_line(change("*ELASTIC\n2", "*ELASTIC\nx2"), line_of("*ELASTIC") + 1, "Young's modulus");
    of_line(change("*NODE, NSET=NALL\n1,", "*NODE, NSET=NALL\n2,"), line_of("*NODE") + 2, "twice");
    of_line(change("MATERIAL=M1", "MATERIAL=M9"), line_of("*SOLID SECTION"), "M9");
    of_line(change("*BOUNDARY\n", "*BOUNDARY\nNOWHERE, 1\n"), line_of("*BOUNDARY") + 1, "missing or empty");
    of_line(change("*CLOAD\n", "*CLOAD\n1, 4, 3\n"), line_of("*CLOAD") + 1, "degrees of freedom");
    // A parameter that changes the answer is not passed over.
    for (card, parameter) in [
        ("*NODE", "SYSTEM=C"),
        ("*SOLID SECTION", "ORIENTATION=O1"),
        ("*BOUNDARY", "SUBMODEL"),
        ("*CLOAD", "AMPLITUDE=A1"),
        ("*STEP", "NLGEOM"),
        ("*STEP", "PERTURBATION"),
    ] {
        let line = line_of(card);
        let own = good.lines().nth(line - 1).unwrap();
        let with = change(&format!("{own}\n"), &format!("{own}, {parameter}\n"));
        of_line(with, line, parameter.split('=').next().unwrap());
    }
    of_line(change("*END STEP", "**"), line_of("*STEP"), "no *END STEP");
    of_line(
        change("*STEP\n", "*NSET, NSET=X, GENERATE\n5, 3\n*STEP\n"),
        line_of("*STEP") + 1,
        "below the first",
    );
    let first = good.lines().nth(line_of("*ELEMENT")).unwrap();
    let fields: Vec<&str> = first.split(',').collect();
    let swapped =
        first.replacen(&format!("{},{},", fields[1], fields[2]), &format!("{},{},", fields[2], fields[1]), 1);
    assert!(matches!(read_deck(&change(first, &swapped)), Err(FlexError::Inverted { element: 1, .. })));
    let unused = change("*NODE, NSET=NALL\n", "*NODE, NSET=NALL\n99999, 1, 2, 3\n");
    // By its number in the deck.
    assert!(matches!(read_deck(&unused), Err(FlexError::FreeNode { node: 99999 })));
    let bare = change("*SOLID SECTION, ELSET=E1_C3D15, MATERIAL=M1\n", "");
    assert!(matches!(read_deck(&bare), Err(FlexError::Missing { .. })));
    assert!(read_deck("1, 2, 3").is_err() && read_deck("").is_err());
    // Whatever is cut off: an answer, no panic.
    for end in (0..good.len()).step_by(977) {
        let _ = read_deck(&good[..end]);
    }
}
