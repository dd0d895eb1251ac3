//! Meshes of a crankshaft that come from elsewhere.

use crate::crank::one_throw;
use lanchester_flex::case::StaticCase;
use lanchester_flex::crank_case::{CrankCase, CrankLoad, CrankSupport, PinLoad};
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_flex::crank_solve::solve_crank;
use lanchester_flex::deck::{Analysis, write_deck};
use lanchester_flex::element::ElementKind;
use lanchester_flex::mesh::{Element, Mesh};
use lanchester_flex::own_mesh::{OwnMeshPlan, own_mesh};
use lanchester_flex::statics::{SolveOptions, solve_static};
use lanchester_flex::{FlexError, Material};
use std::collections::BTreeMap;

/// Radius of the throw [m].
const RADIUS: f64 = 0.5 * 0.0955;

fn throw() -> CrankMesh {
    let options = CrankMeshOptions { size: 24e-3, fillet_elements: 2, fillets: true };
    let engine = one_throw("pin_fillet = \"6 mm\"\njournal_fillet = \"6 mm\"");
    crank_mesh(&engine, 0, options).unwrap()
}

fn plan(crank: &CrankMesh) -> OwnMeshPlan {
    let middle = 0.5 * (48.0 + 20.0 + 25.0) * 1e-3;
    OwnMeshPlan {
        material: Material { density: 7850.0, ..Material::steel() },
        pins: vec![(1, [RADIUS, 0.0])],
        journals: vec![-middle, middle],
        mass: Some(crank.body_mass),
    }
}

fn deck(mesh: &Mesh) -> String {
    write_deck(mesh, &StaticCase::default(), Analysis::Frequency(1)).unwrap()
}

/// Nodes, elements and sets without material, section and step.
fn bare(mesh: &Mesh) -> String {
    let text = deck(mesh);
    text[..text.find("*MATERIAL").unwrap()].to_owned()
}

fn solve(crank: &CrankMesh, support: &CrankSupport) -> CrankCase {
    let pins = vec![PinLoad { pin: 1, force: [-65e3, 10.66e3] }];
    let load = CrankLoad { pins, speed: 300.0, ..CrankLoad::default() };
    solve_crank(crank, support, &[load], SolveOptions::default()).unwrap().remove(0)
}

/// Every wedge as three tetrahedra. The diagonal of a quadrilateral begins at its lowest node, so that neighbours agree.
fn tetrahedra(mesh: &Mesh) -> Mesh {
    let mut found = Mesh { elements: Vec::new(), ..mesh.clone() };
    let mut middles: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    let key = |a: u32, b: u32| [a.min(b), a.max(b)];
    for element in &mesh.elements {
        assert_eq!(element.kind, ElementKind::Wedge);
        for (place, [a, b]) in element.kind.edges().iter().enumerate() {
            middles.insert(
                key(element.nodes[*a], element.nodes[*b]),
                element.nodes[element.kind.corners() + place],
            );
        }
    }
    for element in &mesh.elements {
        // Turned so that the lowest corner comes first; upside down keeps the volume positive with the triangle the other way round.
        let lowest = (0..6).min_by_key(|k| element.nodes[*k]).unwrap();
        let (k, up) = (lowest % 3, lowest / 3);
        let ring = |shift: usize| if up == 0 { (k + shift) % 3 } else { (k + 3 - shift) % 3 };
        let corner = |shift: usize, level: usize| {
            element.nodes[ring(shift) + 3 * (if up == 0 { level } else { 1 - level })]
        };
        let [a, b, c] = [0, 1, 2].map(|shift| corner(shift, 0));
        let [d, e, f] = [0, 1, 2].map(|shift| corner(shift, 1));
        let split = if b.min(f) < c.min(e) {
            [[a, b, c, f], [a, b, f, e], [a, e, f, d]]
        } else {
            [[a, b, c, e], [a, e, c, f], [a, e, f, d]]
        };
        // Middles of diagonals lie in the middle of the curved quadrilateral.
        for [p, q, r, s] in [[a, b, e, d], [b, c, f, e], [a, c, f, d]] {
            let diagonal = if p.min(r) < q.min(s) { key(p, r) } else { key(q, s) };
            if middles.contains_key(&diagonal) {
                continue;
            }
            let edges = [[p, q], [q, r], [r, s], [s, p]].map(|[a, b]| middles[&key(a, b)]);
            let at = std::array::from_fn(|k| {
                let of = |node: u32| found.nodes[node as usize][k];
                0.5 * edges.iter().map(|node| of(*node)).sum::<f64>()
                    - 0.25 * [p, q, r, s].map(of).iter().sum::<f64>()
            });
            let own = found.nodes.len() as u32;
            middles.insert(diagonal, own);
            found.nodes.push(at);
            // A diagonal of a face that a set holds belongs to it.
            for set in &mut found.sets {
                if [p, q, r, s].iter().chain(&edges).all(|node| set.nodes.binary_search(node).is_ok()) {
                    set.nodes.push(own);
                }
            }
        }
        for corners in split {
            let edges = ElementKind::Tetrahedron.edges();
            let rest = edges.iter().map(|[a, b]| middles[&key(corners[*a], corners[*b])]);
            let nodes = corners.into_iter().chain(rest).collect();
            found.elements.push(Element {
                kind: ElementKind::Tetrahedron,
                nodes,
                material: element.material,
            });
        }
    }
    found
}

#[test]
fn a_mesh_written_and_read_gives_the_same_case() {
    let crank = throw();
    let own = own_mesh(&deck(&crank.mesh), &plan(&crank)).unwrap();
    assert_eq!(own.mesh.elements.len(), crank.mesh.elements.len());
    for support in [CrankSupport::Journals, CrankSupport::ClampedEnds] {
        let [one, two] = [&crank, &own].map(|crank| solve(crank, &support));
        let ratio = two.solution.energy / one.solution.energy;
        // Coordinates of the deck have 13 digits.
        assert!((ratio - 1.0).abs() < 1e-8, "{ratio}");
        // The surface outside of the sets has the fillets.
        let largest = |case: &CrankCase| {
            case.peaks
                .iter()
                .filter_map(|peak| peak.stress)
                .map(|stress| stress.von_mises)
                .fold(0.0, f64::max)
        };
        assert_eq!(two.peaks.len(), 1);
        assert!(largest(&two) > (1.0 - 1e-6) * largest(&one), "{} {}", largest(&two), largest(&one));
    }
    // Elements without a section have the material of the engine.
    let own = own_mesh(&bare(&crank.mesh), &plan(&crank)).unwrap();
    assert!((own.quality.mass / crank.quality.mass - 1.0).abs() < 1e-9);
}

#[test]
fn tetrahedra_agree_with_wedges() {
    let crank = throw();
    let mut mesh = tetrahedra(&crank.mesh);
    // Fillets as sets of their own.
    for corner in &crank.corners {
        let name = format!("FILLET_{}", corner.name.to_uppercase().replace(' ', "_"));
        mesh.sets.push(lanchester_flex::mesh::NodeSet { name, nodes: corner.nodes.clone() });
    }
    let own = own_mesh(&bare(&mesh), &plan(&crank)).unwrap();
    println!("{:?}", own.quality);
    assert_eq!(own.quality.elements[0], 3 * crank.quality.elements[1]);
    assert!(
        (own.quality.mass / crank.quality.mass - 1.0).abs() < 1e-4,
        "{} {}",
        own.quality.mass,
        crank.quality.mass
    );
    let names: Vec<&str> = own.corners.iter().map(|corner| corner.name.as_str()).collect();
    assert!(names.contains(&"fillet pin 1 at web 2"), "{names:?}");
    // The flywheel's end turned against the free end: no load on a surface, so that the meshes alone differ.
    let twisted = |mesh: &Mesh| {
        let mut case = StaticCase::default().clamp(&mesh.set("FREE_END").unwrap().nodes);
        for node in &mesh.set("FLYWHEEL").unwrap().nodes {
            let [x, y, _] = mesh.nodes[*node as usize];
            case = case.hold(&[*node], 0, -1e-3 * y).hold(&[*node], 1, 1e-3 * x).hold(&[*node], 2, 0.0);
        }
        solve_static(mesh, &case, SolveOptions::default()).unwrap().energy
    };
    let ratio = twisted(&own.mesh) / twisted(&crank.mesh);
    println!("{ratio}");
    // Both are stiffer than the body, by some tenths of a per cent.
    assert!((ratio - 1.0).abs() < 0.005, "{ratio}");
    for support in [CrankSupport::Journals, CrankSupport::even_springs(5e8), CrankSupport::Free] {
        let [one, two] = [&crank, &own].map(|crank| solve(crank, &support));
        let ratio = two.solution.energy / one.solution.energy;
        println!("{support:?}: {ratio} {} {}", one.solution.energy, two.solution.energy);
        // Triangles and quadrilaterals carry one pressure by other shape functions.
        assert!((ratio - 1.0).abs() < 0.01, "{support:?}: {ratio}");
        assert!(two.peaks.iter().all(|peak| peak.stress.is_some()));
        for axis in 0..2 {
            let rest = two.solution.reaction[axis] + two.solution.load[axis];
            assert!(support == CrankSupport::Free || rest.abs() < 1e-8 * 65e3, "axis {axis}: {rest}");
        }
    }
}

/// What is wrong with a mesh, all at once.
fn refused(text: &str, crank: &CrankMesh) -> String {
    own_mesh(text, &plan(crank)).unwrap_err().to_string()
}

#[test]
fn sets_that_are_missing_empty_or_in_another_place_are_told_at_once() {
    let crank = throw();
    let mut mesh = crank.mesh.clone();
    mesh.sets.retain(|set| set.name != "FLYWHEEL");
    for set in &mut mesh.sets {
        match set.name.as_str() {
            "PIN_1" => set.nodes.clear(),
            // Corners of elements alone, as some programs choose them.
            "MAIN_2" => set.nodes.truncate(3),
            _ => {}
        }
    }
    let words = refused(&deck(&mesh), &crank);
    for part in [
        "the set PIN_1 is empty",
        "the set MAIN_2 holds no whole face",
        "the set FLYWHEEL is missing",
        "hint:",
    ] {
        assert!(words.contains(part), "{part}: {words}");
    }
    // A crankshaft that stands across: the pin is not where the engine has it.
    let mut mesh = crank.mesh.clone();
    mesh.nodes.iter_mut().for_each(|[x, y, _]| (*x, *y) = (-*y, *x));
    let words = refused(&deck(&mesh), &crank);
    // The stroke is 95.5 mm; how 47.75 is rounded does not matter.
    assert!(
        words.contains("the middle of PIN_1 is at (") && words.contains("by the engine file at (47."),
        "{words}"
    );
    // One that counts z from another plane, and one that runs the other way.
    let mut mesh = crank.mesh.clone();
    mesh.nodes.iter_mut().for_each(|[_, _, z]| *z += 0.1);
    let words = refused(&deck(&mesh), &crank);
    assert!(words.contains("the middle of MAIN_1 is at z = ") && words.contains("MAIN_2"), "{words}");
}

#[test]
fn wrong_units_show_in_the_mass() {
    let crank = throw();
    for (factor, wanted) in
        [(1e-3, "lengths are in m"), (1.0 / 25.4, "lengths are in inches"), (0.1, "lengths are in cm")]
    {
        let mut mesh = crank.mesh.clone();
        mesh.nodes.iter_mut().for_each(|place| *place = place.map(|x| factor * x));
        let words = refused(&bare(&mesh), &crank);
        assert!(words.contains(wanted) && words.contains("the mesh weighs"), "{words}");
        // One sentence for all places that are wrong with them.
        assert!(!words.contains("the middle of"), "{words}");
    }
    let mut mesh = crank.mesh.clone();
    mesh.materials[0].density *= 1e12;
    let words = refused(&deck(&mesh), &crank);
    assert!(words.contains("density is not in tonne/mm3"), "{words}");
}

#[test]
fn elements_and_nodes_are_named_as_in_the_deck() {
    let crank = throw();
    // Numbers of the deck begin at 1001.
    let renumbered = |mesh: &Mesh| -> String {
        let mut is_element = false;
        let line = |line: &str| {
            if line.starts_with('*') {
                is_element = line.starts_with("*ELEMENT");
            }
            match line.split_once(',') {
                Some((number, rest))
                    if is_element && !line.starts_with('*') && line.split(',').count() > 10 =>
                {
                    format!("{},{rest}\n", number.parse::<u32>().unwrap() + 1000)
                }
                _ => format!("{line}\n"),
            }
        };
        bare(mesh).lines().map(line).collect()
    };
    let mut mesh = crank.mesh.clone();
    mesh.elements[4].nodes.swap(0, 1);
    let error = own_mesh(&renumbered(&mesh), &plan(&crank)).unwrap_err();
    assert!(matches!(error, FlexError::Inverted { element: 1005, .. }), "{error}");
    let mut mesh = crank.mesh.clone();
    mesh.nodes.push([0.0; 3]);
    let words = refused(&bare(&mesh), &crank);
    assert!(words.contains(&format!("node {} belongs to no element", mesh.nodes.len())), "{words}");
    let text = bare(&crank.mesh).replace("*ELSET, ELSET=EALL", "*SURFACE, NAME=S1\n*ELSET, ELSET=EALL");
    let words = refused(&text, &crank);
    assert!(words.starts_with("line ") && words.contains("unknown card *SURFACE"), "{words}");
    let text = bare(&crank.mesh).replace("TYPE=C3D15", "TYPE=CPS6");
    assert!(refused(&text, &crank).contains("leave out elements of lines and surfaces"));
}
