//! Static cases of a crankshaft: supports by name, loads on pins.
//!
//! ```text
//! p(a) = p_0 cos(a - a_F)  over 180 degrees about the load's direction,  scaled so that the resultant is F          (book, eq. 43.10)
//! ```

use crate::FlexError;
use crate::case::{Spring, StaticCase};
use crate::contact::ContactReport;
use crate::crank_mesh::CrankMesh;
use crate::journal_in_film::JournalInFilm;
use crate::mesh::{Mesh, NodeSet, SignedArea, SurfaceFace, signed_areas, surface, surface_areas};
use crate::oil_pressure::{OilPressure, summing_to};
use crate::statics::{NodeStress, StaticSolution, node_stresses};
use crate::train::{BearingPlace, TrainLaw};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet, HashSet};

/// What holds a crankshaft.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum CrankSupport {
    /// Both end faces.
    ClampedEnds,
    /// The mean of each journal's surface in x and y by rigid springs in effect, axial motion at the flywheel, turning there.
    Journals,
    /// As `Journals`, with springs.
    Springs {
        /// Stiffness of each journal along x and y of the block, from the free end on [N/m]; one entry alone holds for all journals. A direction
        /// of stiffness 0 is not held.
        stiffness: Vec<[f64; 2]>,
    },
    /// A ring around each journal and each loaded pin, which touches it without friction and lets go where it would have to pull. Those of the
    /// journals are fixed at their outside; those of the pins take the load there. Turning and axial motion as with `Journals`.
    Rings {
        /// Outer less inner radius [m].
        thickness: f64,
        /// Young's modulus [Pa]; Poisson's ratio is 0.3.
        modulus: f64,
    },
    /// Where journals, loads and the oil films of the main bearings rest in equilibrium: [`CrankLoad::films`]. Turning and axial motion as with `Journals`.
    Films,
    /// None: loads are balanced by inertia.
    Free,
}

impl CrankSupport {
    /// Springs of one stiffness [N/m] at all journals in both directions.
    pub fn even_springs(stiffness: f64) -> CrankSupport {
        CrankSupport::Springs { stiffness: vec![[stiffness; 2]] }
    }

    /// Whether it holds the same way whatever the load, so that solutions at one crank angle can be added up.
    pub fn is_linear(&self) -> bool {
        !matches!(self, CrankSupport::Rings { .. } | CrankSupport::Films)
    }

    /// Whether it holds a turning crankshaft differently at every crank angle: springs whose two directions differ.
    pub fn depends_on_angle(&self) -> bool {
        matches!(self, CrankSupport::Springs { stiffness } if stiffness.iter().any(|[x, y]| x != y))
    }
}

/// How the force on a crankpin is spread over its surface (eq. 43.10).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PinPressure {
    /// With the cosine of the angle from the load, over the 180 degrees that face it: largest in its direction, 0 at both ends.
    #[default]
    Cosine,
    /// The same pressure everywhere on these 180 degrees.
    Uniform,
    /// As the pressure of the oil films of its big ends: [`CrankLoad::oil`].
    Film,
}

impl PinPressure {
    /// Pressure [1] where the outward normal has the part `facing` against the force.
    fn at(self, facing: f64) -> f64 {
        match self {
            _ if facing <= 0.0 => 0.0,
            PinPressure::Cosine | PinPressure::Film => facing,
            PinPressure::Uniform => 1.0,
        }
    }
}

/// A force on a crankpin, in the frame of the crankshaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PinLoad {
    /// Number of the pin, from 1.
    pub pin: usize,
    /// Force on the pin [N].
    pub force: [f64; 2],
}

/// The largest stress of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PeakStress {
    /// Largest von Mises stress [Pa].
    pub von_mises: f64,
    /// Principal stress of the largest size there [Pa], tension positive.
    pub principal: f64,
    /// Largest jump of the stress between elements over the stress, at the nodes of the same surface of all elements that meet there: a sign of
    /// the error.
    pub jump: f64,
    /// Place [m].
    pub at: [f64; 3],
    /// Angle about the bar's middle, from the x axis of the crankshaft's frame [rad].
    pub angle: f64,
}

/// The largest stress of a fillet, or of the surface of a pin or journal between its fillets.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SurfacePeak {
    /// "pin 1 at web 2"; "PIN_1".
    pub name: String,
    /// Its stress; none of a sharp corner, where it would grow with every refinement.
    pub stress: Option<PeakStress>,
}

/// A solved case of a crankshaft.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankCase {
    /// Displacement, energy, reactions.
    #[serde(skip)]
    pub solution: StaticSolution,
    /// Stress at each node.
    #[serde(skip)]
    pub stresses: Vec<NodeStress>,
    /// Largest displacement [m].
    pub largest_displacement: f64,
    /// Where it is [m].
    pub displaced_at: [f64; 3],
    /// Peaks of all fillets, along z.
    pub peaks: Vec<SurfacePeak>,
    /// Peaks of the surfaces of pins and journals, loaded ones too; away from sharp corners.
    pub surfaces: Vec<SurfacePeak>,
    /// Peaks of webs: within each the largest stress away from fillets and sharp corners.
    pub webs: Vec<SurfacePeak>,
    /// With rings: how they touch.
    pub contact: Option<ContactReport>,
    /// In oil films: how each main bearing's journal rests.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub films: Vec<JournalInFilm>,
}

/// How far from a sharp corner, over the radius of its pin or journal, a stress counts: nearer it grows with every refinement.
const AWAY: f64 = 0.2;

/// Stiffness that counts as rigid beside a crankshaft [N/m]: a thousand times that of a journal in its webs. Rounding of the mean displacement
/// times it is the least residual that a solution can have.
const RIGID: f64 = 1e12;

/// The supports of a crankshaft as a case without loads. `turn`: angle by which the crankshaft has turned against the block [rad], as in [`CrankLoad`].
///
/// ```text
/// e_x = (cos turn, -sin turn),  e_y = (sin turn, cos turn)      directions of the block in the frame of the crankshaft          (book, eq. 43.17)
/// ```
///
/// # Errors
/// [`FlexError::Missing`] where the mesh lacks a set; [`FlexError::Number`] for a stiffness that is none, or as many as there are not journals;
/// [`FlexError::Nonlinear`] for rings and films.
pub fn crank_support(
    crank: &CrankMesh,
    surfaces: &BearingSurfaces,
    support: &CrankSupport,
    turn: f64,
) -> Result<StaticCase, FlexError> {
    let mesh = &crank.mesh;
    let case = StaticCase::default();
    let is_there = |name: &String| surfaces.areas(name).is_ok();
    let journals: Vec<String> = (1..).map(|number| format!("MAIN_{number}")).take_while(is_there).collect();
    let (name, stiffness) = match support {
        CrankSupport::ClampedEnds => {
            let ends = [mesh.set("FREE_END")?, mesh.set("FLYWHEEL")?].map(|set| set.nodes.clone()).concat();
            return Ok(StaticCase { name: "clamped ends".to_owned(), ..case }.clamp(&ends));
        }
        CrankSupport::Free => {
            return Ok(StaticCase { name: "free".to_owned(), inertia_relief: true, ..case });
        }
        CrankSupport::Rings { .. } | CrankSupport::Films => return Err(FlexError::Nonlinear),
        CrankSupport::Journals => ("journals", vec![[RIGID; 2]; journals.len()]),
        CrankSupport::Springs { stiffness } => ("springs", stiffness_of_each(stiffness, journals.len())?),
    };
    let mut case = StaticCase { name: name.to_owned(), ..case };
    if journals.is_empty() {
        let (what, name, hint) =
            ("node set", "MAIN_1".to_owned(), "a crankshaft on journals has at least two of them");
        return Err(FlexError::Missing { what, name, hint });
    }
    // Even springs hold the same way along all directions: the frame of the crankshaft spares them a rounding.
    let turn = if support.depends_on_angle() { turn } else { 0.0 };
    let (sin, cos) = turn.sin_cos();
    let directions = [("x", [cos, -sin, 0.0]), ("y", [sin, cos, 0.0])];
    for (name, stiffness) in journals.into_iter().zip(stiffness) {
        let weights = weights(surfaces.signed(&name)?);
        for ((letter, direction), stiffness) in directions.into_iter().zip(stiffness) {
            // A stiffness below zero or without a number is refused with the case.
            if stiffness != 0.0 {
                let name = format!("{name} {letter}");
                case.springs.push(Spring::on_mean(&name, stiffness, direction, &weights));
            }
        }
    }
    hold_flywheel(crank, &mut case, surfaces)?;
    Ok(case)
}

/// One stiffness for each journal.
fn stiffness_of_each(given: &[[f64; 2]], journals: usize) -> Result<Vec<[f64; 2]>, FlexError> {
    match given {
        [all] => Ok(vec![*all; journals]),
        each if each.len() == journals => Ok(each.to_vec()),
        other => Err(FlexError::Number {
            quantity: "the number of stiffnesses of the springs".to_owned(),
            needed: format!("1 for all journals, or {journals}, one for each of them from the free end on"),
            got: other.len() as f64,
            hint: "a journal of stiffness 0 is not held",
        }),
    }
}

/// Holds the flywheel's end face: no mean motion along z, no mean rotation about z.
pub(crate) fn hold_flywheel(
    crank: &CrankMesh,
    case: &mut StaticCase,
    surfaces: &BearingSurfaces,
) -> Result<(), FlexError> {
    let mesh = &crank.mesh;
    let areas = surfaces.areas("FLYWHEEL")?;
    let all: f64 = areas.values().map(|area| area[2]).sum();
    let even: Vec<(u32, f64)> = areas
        .iter()
        .map(|(node, area)| (*node, area[2] / all))
        .filter(|(_, weight)| weight.abs() > 1e-9)
        .collect();
    case.springs.push(Spring::on_mean("FLYWHEEL z", RIGID, [0.0, 0.0, 1.0], &even));
    let centre: [f64; 2] =
        std::array::from_fn(|k| even.iter().map(|(node, w)| w * mesh.nodes[*node as usize][k]).sum());
    let arm = |node: u32| {
        let at = mesh.nodes[node as usize];
        [at[0] - centre[0], at[1] - centre[1]]
    };
    let polar: f64 = even.iter().map(|(node, w)| w * arm(*node).iter().map(|x| x * x).sum::<f64>()).sum();
    // Mean rotation, SUM w r x u / SUM w r^2, times the radius of gyration.
    let turning = even.iter().map(|(node, w)| {
        let [x, y] = arm(*node);
        (*node, [-w * y / polar.sqrt(), w * x / polar.sqrt(), 0.0])
    });
    let turning = Spring { name: "FLYWHEEL turning".to_owned(), stiffness: RIGID, nodes: turning.collect() };
    case.springs.push(turning);
    Ok(())
}

/// Areas that the nodes of bearing surfaces and of the flywheel's face carry, as vectors along the outward normal [m^2]: computed once
/// for all supports and loads of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingSurfaces(BTreeMap<String, BearingSurface>);

/// A surface by its nodes.
#[derive(Debug, Clone, PartialEq)]
struct BearingSurface {
    faces: Vec<SurfaceFace>,
    areas: BTreeMap<u32, [f64; 3]>,
    signed: BTreeMap<u32, SignedArea>,
}

impl BearingSurfaces {
    /// Of all sets of a mesh.
    pub fn new(crank: &CrankMesh) -> BearingSurfaces {
        let (faces, _) = surface(&crank.mesh);
        let of = |set: &NodeSet| {
            let own: HashSet<u32> = set.nodes.iter().copied().collect();
            let is_own = |face: &&SurfaceFace| face.nodes.iter().all(|node| own.contains(node));
            let faces: Vec<SurfaceFace> = faces.iter().filter(is_own).cloned().collect();
            let areas = surface_areas(&crank.mesh, &faces);
            let signed = signed_areas(&crank.mesh, &faces);
            (set.name.clone(), BearingSurface { faces, areas, signed })
        };
        BearingSurfaces(crank.mesh.sets.iter().map(of).collect())
    }

    /// Those of one set.
    ///
    /// # Errors
    /// [`FlexError::Missing`] where the mesh has no such surface.
    pub fn areas(&self, name: &str) -> Result<&BTreeMap<u32, [f64; 3]>, FlexError> {
        self.surface(name).map(|own| &own.areas)
    }

    /// Those of one set with their sign and the outward direction.
    ///
    /// # Errors
    /// As [`BearingSurfaces::areas`].
    pub fn signed(&self, name: &str) -> Result<&BTreeMap<u32, SignedArea>, FlexError> {
        self.surface(name).map(|own| &own.signed)
    }

    fn surface(&self, name: &str) -> Result<&BearingSurface, FlexError> {
        self.0.get(name).filter(|own| !own.areas.is_empty()).ok_or_else(|| FlexError::Missing {
            what: "bearing surface",
            name: name.to_owned(),
            hint: "a node set of that name must hold all nodes of at least one face",
        })
    }
}

/// Weights of the mean over a surface around the crank's axis: the share of its area that each node carries.
fn weights(areas: &BTreeMap<u32, SignedArea>) -> Vec<(u32, f64)> {
    let all: f64 = areas.values().map(|area| area.size).sum();
    let sized = areas.iter().map(|(node, area)| (*node, area.size / all));
    sized.filter(|(_, weight)| weight.abs() > 1e-9).collect()
}

/// Adds a force on a pin as a pressure over 180 degrees of its surface (eq. 43.10).
///
/// # Errors
/// [`FlexError::Missing`] where there is no such pin, and for the pressure of films, which this knows nothing of; [`FlexError::Number`] for a force that is none.
pub fn load_pin(
    surfaces: &BearingSurfaces,
    case: StaticCase,
    load: PinLoad,
    pressure: PinPressure,
) -> Result<StaticCase, FlexError> {
    let size = load.force[0].hypot(load.force[1]);
    if !size.is_finite() {
        let quantity = format!("the force on pin {} [N]", load.pin);
        return Err(FlexError::Number {
            quantity,
            needed: "finite".to_owned(),
            got: size,
            hint: "give a number",
        });
    }
    let areas = surfaces.signed(&format!("PIN_{}", load.pin))?;
    if pressure == PinPressure::Film {
        return Err(no_film("on a loaded pin"));
    }
    if size == 0.0 {
        return Ok(case);
    }
    Ok(press(areas, case, load.force, pressure))
}

/// Adds a force [N] as a pressure over 180 degrees of a surface, by the areas that its nodes carry.
pub(crate) fn press(
    areas: &BTreeMap<u32, SignedArea>,
    case: StaticCase,
    force: [f64; 2],
    pressure: PinPressure,
) -> StaticCase {
    let size = force[0].hypot(force[1]);
    let along = force.map(|force| force / size);
    // The pressure acts where the surface faces against the force, and pushes inwards.
    let mut forces: Vec<(u32, [f64; 2])> = Vec::new();
    let mut sum = [0.0; 2];
    for (node, SignedArea { size, outward: [x, y, _] }) in areas {
        let pressure = pressure.at(-(x * along[0] + y * along[1]));
        if pressure > 0.0 {
            let force = [-pressure * size * x, -pressure * size * y];
            sum = [sum[0] + force[0], sum[1] + force[1]];
            forces.push((*node, force));
        }
    }
    // Scaled and, by a little shear of the same pattern, turned so that the discrete resultant is the force exactly.
    let parallel = sum[0] * along[0] + sum[1] * along[1];
    let across = sum[1] * along[0] - sum[0] * along[1];
    let (scale, slip) = (size / parallel, across / parallel);
    let mut case = case;
    for (node, [x, y]) in forces {
        let (p, q) = (x * along[0] + y * along[1], y * along[0] - x * along[1]);
        let (p, q) = (scale * p, scale * (q - slip * p));
        case = case.push(&[(node, 1.0)], [p * along[0] - q * along[1], p * along[1] + q * along[0], 0.0]);
    }
    case
}

/// Adds the forces of a load on all pins, spread as it says.
///
/// # Errors
/// As [`load_pin`]; [`FlexError::Missing`] where the pressure of films is wanted and a loaded pin has none.
pub(crate) fn load_pins(
    mesh: &Mesh,
    surfaces: &BearingSurfaces,
    case: StaticCase,
    load: &CrankLoad,
) -> Result<StaticCase, FlexError> {
    load.pins.iter().try_fold(case, |case, pin| {
        if load.pressure != PinPressure::Film {
            return load_pin(surfaces, case, *pin, load.pressure);
        }
        if pin.force == [0.0; 2] {
            return Ok(case);
        }
        let name = format!("PIN_{}", pin.pin);
        let films: Vec<&OilPressure> = load.oil.iter().filter(|own| own.place.set == name).collect();
        press_films(mesh, surfaces, case, &films, pin.force)
    })
}

/// Adds a force on a bearing surface [N] with the pattern of the films upon it.
///
/// # Errors
/// [`FlexError::Missing`] where there is no film or no such surface.
pub(crate) fn press_films(
    mesh: &Mesh,
    surfaces: &BearingSurfaces,
    case: StaticCase,
    films: &[&OilPressure],
    force: [f64; 2],
) -> Result<StaticCase, FlexError> {
    let Some(first) = films.first() else { return Err(no_film("on a loaded pin")) };
    let surface = surfaces.surface(&first.place.set)?;
    let all: f64 = surface.areas.values().map(|[x, y, _]| x.hypot(*y)).sum();
    let middle = [0, 1].map(|k| {
        let part = |(node, [x, y, _]): (&u32, &[f64; 3])| x.hypot(*y) * mesh.nodes[*node as usize][k];
        surface.areas.iter().map(part).sum::<f64>() / all
    });
    let (mut sum, mut touching) = (BTreeMap::<u32, [f64; 2]>::new(), [0.0; 2]);
    for film in films {
        for (node, own) in film.forces(mesh, &surface.faces, middle) {
            let sum = sum.entry(node).or_default();
            (0..2).for_each(|k| sum[k] += own[k]);
        }
        (0..2).for_each(|k| touching[k] += film.contact[k]);
    }
    let mut case = case;
    // Roughness that touches carries its share where journal and shell are nearest.
    if touching != [0.0; 2] {
        case = press(&surface.signed, case, touching, PinPressure::Cosine);
    }
    let wanted = [0, 1].map(|k| force[k] - touching[k]);
    let forces = summing_to(&sum, wanted).ok_or_else(|| no_film(&first.place.set))?;
    for (node, [x, y]) in forces {
        case = case.push(&[(node, 1.0)], [x, y, 0.0]);
    }
    Ok(case)
}

fn no_film(name: &str) -> FlexError {
    FlexError::Missing {
        what: "pressure of an oil film",
        name: name.to_owned(),
        hint: "the films of all big ends are needed at the instant of the load, or spread it with the cosine",
    }
}

/// The law of a main bearing, where a crankshaft rests in films.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmBearing {
    /// Which one.
    pub place: BearingPlace,
    /// Its law.
    pub law: TrainLaw,
    /// Stiffness of its housing, which gives way to the film [N/m]; `None`: rigid.
    pub housing: Option<f64>,
}

/// What loads a crankshaft.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct CrankLoad {
    /// Forces on its pins.
    pub pins: Vec<PinLoad>,
    /// How they are spread.
    pub pressure: PinPressure,
    /// Where they are spread as oil films press: the films of the big ends at the instant of the load.
    #[serde(skip)]
    pub oil: Vec<OilPressure>,
    /// Where the crankshaft rests in films: those of all main bearings, along it.
    #[serde(skip)]
    pub films: Vec<FilmBearing>,
    /// Speed about its axis [rad/s], whose centrifugal field loads the body.
    pub speed: f64,
    /// Rate of that speed [rad/s^2], whose field of tangential inertia loads the body.
    pub acceleration: f64,
    /// Angle from the block's x axis to that of the frame of the crankshaft, positive from x to y [rad]: springs that differ across directions keep
    /// to the block.
    pub turn: f64,
}

impl CrankLoad {
    /// A case of its turning alone.
    pub fn turning(&self) -> StaticCase {
        StaticCase { speed: self.speed, acceleration: self.acceleration, ..StaticCase::default() }
    }
}

/// The static case of each load.
///
/// # Errors
/// As [`crank_support`] and [`load_pin`].
pub fn crank_cases(
    crank: &CrankMesh,
    support: &CrankSupport,
    loads: &[CrankLoad],
) -> Result<Vec<StaticCase>, FlexError> {
    let surfaces = BearingSurfaces::new(crank);
    let base = crank_support(crank, &surfaces, support, 0.0)?;
    let case = |load: &CrankLoad| {
        let own = match support.depends_on_angle() {
            true => crank_support(crank, &surfaces, support, load.turn)?,
            false => base.clone(),
        };
        let base = StaticCase { speed: load.speed, acceleration: load.acceleration, ..own };
        load_pins(&crank.mesh, &surfaces, base, load)
    };
    loads.iter().map(case).collect()
}

/// The largest stress of each surface: its name, its nodes and the middle of its bar.
fn surface_peaks(
    mesh: &Mesh,
    stresses: &[NodeStress],
    surfaces: &[(&str, &[u32], [f64; 2])],
) -> Vec<SurfacePeak> {
    let value = |node: &u32| stresses[*node as usize].stress.von_mises();
    let largest = |nodes: &[u32]| nodes.iter().copied().max_by(|a, b| value(a).total_cmp(&value(b)));
    let nodes: Vec<Option<u32>> = surfaces.iter().map(|(_, nodes, _)| largest(nodes)).collect();
    // Nodes of the elements that meet at each largest one.
    let mut around: BTreeMap<u32, BTreeSet<u32>> =
        nodes.iter().flatten().map(|node| (*node, BTreeSet::new())).collect();
    let mut is_largest = vec![false; mesh.nodes.len()];
    around.keys().for_each(|node| is_largest[*node as usize] = true);
    for element in &mesh.elements {
        for node in element.nodes.iter().filter(|node| is_largest[**node as usize]) {
            around.entry(*node).or_default().extend(&element.nodes);
        }
    }
    let peak = |node: u32, own: &[u32], centre: [f64; 2]| {
        let near = &around[&node];
        let jumps = own.iter().filter(|node| near.contains(node)).map(|node| stresses[*node as usize].jump);
        let (at, von_mises) = (mesh.nodes[node as usize], value(&node));
        PeakStress {
            von_mises,
            principal: stresses[node as usize].stress.dominant(),
            jump: jumps.fold(0.0, f64::max) / von_mises.max(f64::MIN_POSITIVE),
            at,
            angle: (at[1] - centre[1]).atan2(at[0] - centre[0]),
        }
    };
    let found = surfaces.iter().zip(nodes);
    found
        .map(|((name, own, centre), node)| SurfacePeak {
            name: (*name).to_owned(),
            stress: node.map(|node| peak(node, own, *centre)),
        })
        .collect()
}

/// Nodes of a bearing surface away from its ends, where one of its corners is sharp.
fn away_from_ends(crank: &CrankMesh, set: &NodeSet) -> Vec<u32> {
    let name = set.name.replace("PIN_", "pin ").replace("MAIN_", "journal ");
    let name = format!("{name} at ");
    let sharp = crank.corners.iter().filter(|corner| corner.is_sharp() && corner.name.starts_with(&name));
    let Some(bar) = sharp.map(|corner| corner.bar).reduce(f64::max) else { return set.nodes.clone() };
    let height = |node: &u32| crank.mesh.nodes[*node as usize][2];
    let (low, high) = set
        .nodes
        .iter()
        .map(height)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
    let [low, high] = [low + AWAY * bar, high - AWAY * bar];
    set.nodes.iter().copied().filter(|node| (low..=high).contains(&height(node))).collect()
}

/// Nodes of a web away from the pins and journals that end on it with a sharp corner.
fn away_from_bars(crank: &CrankMesh, web: &str, nodes: &[u32]) -> Vec<u32> {
    let end = format!(" at {web}");
    let sharp = crank.corners.iter().filter(|corner| corner.is_sharp() && corner.name.ends_with(&end));
    let bars: Vec<_> = sharp.collect();
    let is_away = |node: &&u32| {
        let [x, y, _] = crank.mesh.nodes[**node as usize];
        bars.iter().all(|own| ((x - own.centre.x).hypot(y - own.centre.y) - own.bar).abs() >= AWAY * own.bar)
    };
    nodes.iter().filter(is_away).copied().collect()
}

/// Largest displacement and peaks of a solution.
pub fn evaluate(crank: &CrankMesh, solution: StaticSolution) -> CrankCase {
    let mesh = &crank.mesh;
    let stresses = node_stresses(mesh, &solution.displacements);
    let length = |u: &[f64; 3]| (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]).sqrt();
    let mut largest = (0, 0.0);
    for (node, u) in solution.displacements.iter().enumerate() {
        if length(u) > largest.1 {
            largest = (node, length(u));
        }
    }
    let mut surfaces: Vec<(&str, &[u32], [f64; 2])> = Vec::new();
    let corners = crank.corners.iter();
    surfaces.extend(corners.map(|own| (own.name.as_str(), &own.nodes[..], [own.centre.x, own.centre.y])));
    let is_bearing = |name: &str| name.starts_with("PIN_") || name.starts_with("MAIN_");
    let bearings = mesh.sets.iter().filter(|set| is_bearing(&set.name));
    let bearings: Vec<(&str, Vec<u32>, [f64; 2])> = bearings
        .map(|set| {
            let mean = |k: usize| {
                let sum: f64 = set.nodes.iter().map(|node| mesh.nodes[*node as usize][k]).sum();
                sum / set.nodes.len().max(1) as f64
            };
            (set.name.as_str(), away_from_ends(crank, set), [mean(0), mean(1)])
        })
        .collect();
    surfaces.extend(bearings.iter().map(|(name, nodes, centre)| (*name, &nodes[..], *centre)));
    let bearings = surfaces.len();
    let webs = crank.webs.iter().map(|web| (web.name.as_str(), away_from_bars(crank, &web.name, &web.nodes)));
    let webs: Vec<(&str, Vec<u32>)> = webs.collect();
    surfaces.extend(webs.iter().map(|(name, nodes)| (*name, &nodes[..], [0.0; 2])));
    let mut peaks = surface_peaks(mesh, &stresses, &surfaces);
    let webs = peaks.split_off(bearings);
    let surfaces = peaks.split_off(crank.corners.len());
    CrankCase {
        largest_displacement: largest.1,
        displaced_at: mesh.nodes[largest.0],
        peaks,
        surfaces,
        webs,
        contact: None,
        films: Vec::new(),
        solution,
        stresses,
    }
}
