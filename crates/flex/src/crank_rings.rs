//! A crankshaft whose journals lie in rings, and whose pins take their loads through rings.

use crate::case::StaticCase;
use crate::contact::{ContactFace, ContactSystem, Ring, RingShape, add_ring};
use crate::crank_case::{
    BearingSurfaces, CrankCase, CrankLoad, PinLoad, PinPressure, evaluate, hold_flywheel, press,
};
use crate::crank_mesh::CrankMesh;
use crate::deck::{Analysis, with_contact, write_deck};
use crate::mesh::{Mesh, signed_areas, surface};
use crate::sparse::SolveEstimate;
use crate::statics::{SolveOptions, as_node_forces};
use crate::{FlexError, Material};

/// Elements through a ring: quadratic ones.
const LAYERS: usize = 1;

/// Stiffness of the layer that stands for contact, in moduli of the crankshaft over the thickness of the ring. Stiffer layers let the pressure go to and
/// fro between the integration points of a face, so that the pattern settles late; under this one the faces go some tenths of a micrometre into each other.
const STIFF: f64 = 20.0;

/// What the rings are made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingsOf {
    /// Outer less inner radius [m].
    pub thickness: f64,
    /// Young's modulus [Pa].
    pub modulus: f64,
}

/// A crankshaft with its rings as one mesh.
struct Ringed {
    mesh: Mesh,
    journals: Vec<Ring>,
    pins: Vec<(usize, Ring)>,
}

/// Solves each load with rings around the journals and around the pins that it loads.
///
/// # Errors
/// [`FlexError::Number`] for a ring or force that is none, [`FlexError::Missing`] for a pin that is not there; as for other supports, and
/// [`FlexError::NoConvergence`].
pub(crate) fn solve_on_rings(
    crank: &CrankMesh,
    rings: RingsOf,
    loads: &[CrankLoad],
    options: SolveOptions,
    watch: &dyn Fn(&SolveEstimate),
) -> Result<Vec<CrankCase>, FlexError> {
    check(rings)?;
    loads.iter().try_for_each(check_pressure)?;
    let surfaces = BearingSurfaces::new(crank);
    for pin in loads.iter().flat_map(|load| &load.pins) {
        check_force(pin)?;
    }
    let mut found: Vec<Option<CrankCase>> = loads.iter().map(|_| None).collect();
    // Loads on the same pins have one mesh and one order of elimination.
    while let Some(first) = found.iter().position(Option::is_none) {
        let pins = pins_of(&loads[first]);
        let ringed = ringed(crank, rings, &pins)?;
        let own: Vec<usize> = (0..loads.len()).filter(|k| pins_of(&loads[*k]) == pins).collect();
        let cases: Vec<StaticCase> = own
            .iter()
            .map(|k| ringed.case(crank, &surfaces, &loads[*k]))
            .collect::<Result<_, FlexError>>()?;
        let turning = cases.iter().max_by_key(|case| case.turns());
        let Some(base) = turning else { break };
        let faces = ringed.rings().flat_map(|ring| ring.contact.iter().cloned()).collect();
        let stiffness = stiffness(crank, rings);
        let mut system = ContactSystem::new(&ringed.mesh, base, faces, stiffness, options, watch)?;
        for (place, case) in own.into_iter().zip(&cases) {
            let (mut solution, report) = system.solve(case)?;
            let count = crank.mesh.nodes.len();
            solution.displacements.truncate(count);
            solution.reactions.truncate(count);
            found[place] = Some(CrankCase { contact: Some(report), ..evaluate(crank, solution) });
        }
    }
    Ok(found.into_iter().flatten().collect())
}

/// The case of one load as a deck of CalculiX with contact between surfaces (N, mm, tonne, s, MPa).
///
/// # Errors
/// As [`crate::crank_solve::solve_crank`] for rings.
pub fn rings_deck(
    crank: &CrankMesh,
    rings: RingsOf,
    load: &CrankLoad,
    name: &str,
) -> Result<String, FlexError> {
    check(rings)?;
    check_pressure(load)?;
    let ringed = ringed(crank, rings, &pins_of(load))?;
    let case = ringed.case(crank, &BearingSurfaces::new(crank), load)?;
    let case = StaticCase { name: name.to_owned(), ..as_node_forces(&ringed.mesh, &case)? };
    let deck = write_deck(&ringed.mesh, &case, Analysis::Static)?;
    let faces: Vec<&[ContactFace]> = ringed.rings().map(|ring| ring.contact.as_slice()).collect();
    with_contact(&deck, &ringed.mesh, &faces, stiffness(crank, rings))
}

/// Pins that a load acts on, rising.
fn pins_of(load: &CrankLoad) -> Vec<usize> {
    let acting = load.pins.iter().filter(|pin| pin.force != [0.0; 2]);
    let mut pins: Vec<usize> = acting.map(|pin| pin.pin).collect();
    pins.sort_unstable();
    pins.dedup();
    pins
}

/// Of the layer that stands for contact [N/m^3].
fn stiffness(crank: &CrankMesh, rings: RingsOf) -> f64 {
    let modulus = crank.mesh.materials.first().map_or(rings.modulus, |own| own.youngs_modulus);
    STIFF * modulus.max(rings.modulus) / rings.thickness
}

fn check(rings: RingsOf) -> Result<(), FlexError> {
    for (quantity, got) in [
        ("thickness of the rings [m]", rings.thickness),
        ("Young's modulus of the rings [Pa]", rings.modulus),
    ] {
        if !(got > 0.0 && got.is_finite()) {
            return Err(FlexError::Number {
                quantity: quantity.to_owned(),
                needed: "above zero".to_owned(),
                got,
                hint: "5 mm and 210 GPa are a bearing shell with its bore",
            });
        }
    }
    Ok(())
}

/// Refuses films on the outside of rings.
fn check_pressure(load: &CrankLoad) -> Result<(), FlexError> {
    if load.pressure != PinPressure::Film {
        return Ok(());
    }
    Err(FlexError::Missing {
        what: "oil film",
        name: "on the outside of a ring".to_owned(),
        hint: "rings take their load there: spread it with the cosine or evenly, or choose another support",
    })
}

fn check_force(load: &PinLoad) -> Result<(), FlexError> {
    let got = load.force[0].hypot(load.force[1]);
    if got.is_finite() {
        return Ok(());
    }
    let quantity = format!("the force on pin {} [N]", load.pin);
    Err(FlexError::Number { quantity, needed: "finite".to_owned(), got, hint: "give a number" })
}

fn ringed(crank: &CrankMesh, rings: RingsOf, pins: &[usize]) -> Result<Ringed, FlexError> {
    let mut mesh = crank.mesh.clone();
    let (faces, _) = surface(&crank.mesh);
    // Without mass: a centrifugal field does not load them.
    mesh.materials.push(Material {
        name: "ring".to_owned(),
        youngs_modulus: rings.modulus,
        poisson_ratio: 0.3,
        density: 0.0,
    });
    let material = mesh.materials.len() as u32 - 1;
    let shape = RingShape { thickness: rings.thickness, layers: LAYERS, material };
    let mut journals = Vec::new();
    for number in 1.. {
        let name = format!("MAIN_{number}");
        if crank.mesh.set(&name).is_err() {
            break;
        }
        journals.push(add_ring(&mut mesh, &faces, &name, shape)?);
    }
    if journals.is_empty() {
        let (what, name) = ("node set", "MAIN_1".to_owned());
        let hint = "a crankshaft on rings has at least two journals";
        return Err(FlexError::Missing { what, name, hint });
    }
    let mut own = Vec::new();
    for pin in pins {
        own.push((*pin, add_ring(&mut mesh, &faces, &format!("PIN_{pin}"), shape)?));
    }
    Ok(Ringed { mesh, journals, pins: own })
}

impl Ringed {
    fn rings(&self) -> impl Iterator<Item = &Ring> {
        self.journals.iter().chain(self.pins.iter().map(|(_, ring)| ring))
    }

    /// Supports and loads: outsides of the journals' rings fixed, of the pins' rings pressed; a pin's ring is kept from turning and from sliding
    /// along the pin by one node, which carries nothing.
    fn case(
        &self,
        crank: &CrankMesh,
        surfaces: &BearingSurfaces,
        load: &CrankLoad,
    ) -> Result<StaticCase, FlexError> {
        let mut case = StaticCase { name: "rings with contact".to_owned(), ..load.turning() };
        for ring in &self.journals {
            case = case.clamp(&ring.outer_nodes());
        }
        hold_flywheel(crank, &mut case, surfaces)?;
        for (pin, ring) in &self.pins {
            let areas = signed_areas(&self.mesh, &ring.outer);
            for own in load.pins.iter().filter(|own| own.pin == *pin) {
                case = press(&areas, case, own.force, load.pressure);
            }
            // The node farthest along x: y there is across the ring's radius.
            let nodes = ring.outer_nodes();
            let place = |node: &u32| self.mesh.nodes[*node as usize][0];
            if let Some(node) = nodes.iter().max_by(|a, b| place(a).total_cmp(&place(b))) {
                case = case.hold(&[*node], 1, 0.0).hold(&[*node], 2, 0.0);
            }
        }
        Ok(case)
    }
}
