//! From the elements of a crankshaft to its mesh.

use super::bay::bay;
use super::carried::carried_weights;
use super::chords::Chords;
use super::circles::arrangement;
use super::ends::{Ends, end_mass, has_ends};
use super::extrude::Sweep;
use super::fillet::{Side, Torus};
use super::levels::{levels, with_planes};
use super::net::net;
use super::options::{CrankMeshOptions, check_options};
use super::places::{Beside, Places};
use super::plain::plain_body;
use super::rim::Rim;
use super::rings::rings;
use super::segment::{Bar, Segment, Stack, TINY, check_fillets, refuse, segments};
use super::slugs::slugs;
use super::stack::{Core, StackNet, reaches_over, solids, stack_net};
use crate::mesh::{CarriedWeight, Mesh, MeshQuality, NodeSet, quality};
use crate::{FlexError, LEAST_JACOBIAN, Material};
use lanchester_geometry::crankshaft::CrankshaftBody;
use lanchester_model::{CrankElement, Engine};
use lanchester_shape::{Outline, Point};
use serde::Serialize;
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

/// Most elements that are meshed, by volume alone: ten times what a common computer solves.
const MOST_CELLS: f64 = 3e6;

/// Sets of the end faces of a bay.
pub const CUTS: [&str; 2] = ["CUT_1", "CUT_2"];

/// A corner between a bar and a web.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FilletPlace {
    /// "pin 1 at web 2".
    pub name: String,
    /// Radius [m]; 0 of a sharp corner, whose stress is no number.
    pub radius: f64,
    /// Middle of the bar, in the frame of the crankshaft [m].
    pub centre: Point,
    /// Radius of the bar [m].
    pub bar: f64,
    /// Nodes on the surface of the fillet; none of a sharp corner.
    pub nodes: Vec<u32>,
}

impl FilletPlace {
    /// Whether it has no fillet: its stress grows with every refinement.
    pub fn is_sharp(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Volume that the fillet adds to a sharp corner [m^3]: the corner's square less a quarter disc, turned about the axis of the bar
    /// (Pappus).
    pub fn volume(&self) -> f64 {
        if self.nodes.is_empty() {
            return 0.0;
        }
        let r = self.radius;
        let area = r * r * (1.0 - FRAC_PI_4);
        let moment = r.powi(3) / 2.0 - FRAC_PI_4 * r * r * (r - 4.0 * r / (3.0 * PI));
        TAU * (area * self.bar + moment)
    }
}

/// A web, away from its fillets.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct WebPlace {
    /// "web 2".
    pub name: String,
    /// Nodes farther from each face than the radius of the fillet there, on the surface and within; none of a web that is all fillets.
    #[serde(skip)]
    pub nodes: Vec<u32>,
}

/// The mesh of a crankshaft. Sets: `MAIN_1` .. and `PIN_1` .. (the bearing surfaces between the fillets), `NOSE_1` .. and `FLANGE_1` .. (the round surfaces of
/// their steps), `FREE_END`, `FLYWHEEL` (the end faces).
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankMesh {
    /// The mesh.
    #[serde(skip)]
    pub mesh: Mesh,
    /// Its quality.
    pub quality: MeshQuality,
    /// Its corners, along z.
    pub corners: Vec<FilletPlace>,
    /// Its webs, along z.
    pub webs: Vec<WebPlace>,
    /// Counterweights without a shape: their centrifugal forces load the mesh, their masses are not in it.
    pub weights: Vec<CarriedWeight>,
    /// Mass of the body that is meshed, without fillets; of a bay that of the whole crankshaft [kg].
    pub body_mass: f64,
    /// What of the crankshaft is not meshed, or not as it is.
    pub left_out: Vec<String>,
}

impl CrankMesh {
    /// Planes of the end faces of a bay [m].
    ///
    /// # Errors
    /// [`FlexError::Missing`] for a whole crankshaft, which has none.
    pub fn cut_planes(&self) -> Result<[f64; 2], FlexError> {
        let plane = |cut: &str| -> Result<f64, FlexError> {
            let nodes = &self.mesh.set(cut)?.nodes;
            Ok(nodes.first().map_or(f64::NAN, |node| self.mesh.nodes[*node as usize][2]))
        };
        Ok([plane(CUTS[0])?, plane(CUTS[1])?])
    }
}

/// Meshes crankshaft `index` of an engine.
///
/// # Errors
/// [`FlexError::Crankshaft`] where the file does not say enough; [`FlexError::Mesh`] where fillets do not fit or the shape is not covered
/// (counterweights of another density, and those that reach over a journal or pin along the crank and touch it); [`FlexError::Crowded`] for a
/// mesh below [`LEAST_JACOBIAN`], for which another number of elements across the fillets is worth a try.
pub fn crank_mesh(engine: &Engine, index: usize, options: CrankMeshOptions) -> Result<CrankMesh, FlexError> {
    // Circles of nose and flange may come too near to others for elements between them: the rest is meshed without them.
    let all = mesh_of(engine, index, options, None, Ends::All);
    if !has_ends(engine, index) {
        return all;
    }
    let is_room = |found: &Result<CrankMesh, FlexError>| {
        !matches!(found, Err(FlexError::Crowded { .. } | FlexError::Mesh { .. }))
    };
    if is_room(&all) {
        return all;
    }
    match mesh_of(engine, index, options, None, Ends::Flange) {
        found if is_room(&found) => found,
        _ => mesh_of(engine, index, options, None, Ends::None),
    }
}

/// Meshes the bay of a pin of crankshaft `index`: what lies between the middles of the two main journals beside it, at the place where it is in
/// the whole crankshaft. Its end faces are the sets [`CUTS`].
///
/// # Errors
/// As [`crank_mesh`]; [`FlexError::Missing`] where there is no such pin.
pub fn crank_mesh_of_bay(
    engine: &Engine,
    index: usize,
    options: CrankMeshOptions,
    pin: usize,
) -> Result<CrankMesh, FlexError> {
    mesh_of(engine, index, options, Some(pin), Ends::None)
}

fn mesh_of(
    engine: &Engine,
    index: usize,
    options: CrankMeshOptions,
    pin: Option<usize>,
    ends: Ends,
) -> Result<CrankMesh, FlexError> {
    check_options(options)?;
    let (body, mut left_out) = plain_body(engine, index)?;
    let elements = engine
        .crank_elements(index)
        .map_err(|fault| refuse("crankshaft", fault.to_string(), "complete [crank.body] and [crank]"))?;
    check_size(&body, options)?;
    let why = if pin.is_some() { "beyond the bay" } else { "no room for its elements" };
    let (bars, segments) = segments(&elements, options, ends, why, &mut left_out)?;
    let (bars, segments, faces) = match pin {
        None => (bars, segments, ["FREE_END", "FLYWHEEL"]),
        Some(pin) => {
            let (bars, segments) = bay(&bars, &segments, pin)?;
            (bars, segments, CUTS)
        }
    };
    check_fillets(&bars, &segments)?;
    let layers = options.fillet_elements / 2;
    let rings = rings(&bars, layers, options.size);
    let clash = |at: Point| crowded(&bars, at, "lines of its net cross".to_owned());
    let circles = arrangement(&rings).map_err(clash)?;
    let core_net = net(&circles.chords, options.size, |at, to| circles.is_smooth(at, to)).map_err(clash)?;
    let mut materials = vec![material(engine, &body, &elements)?];
    let slugs = slugs(&body, &mut materials)?;
    if materials.len() > 1 {
        left_out.push(
            "elastic constants of inserts (those of the crankshaft, with the density of the insert)"
                .to_owned(),
        );
    }
    let mut sweep = Sweep {
        middles: middles(&circles.chords),
        points: core_net.points.clone(),
        nodes: HashMap::new(),
        mesh: Mesh { materials, ..Mesh::default() },
        levels: Vec::new(),
    };
    let core = Core { bars: &bars, net: &core_net, circles: &circles, slugs: &slugs, options };
    let mut nets: Vec<Option<StackNet>> = Vec::with_capacity(segments.len());
    let mut known: Vec<String> = Vec::new();
    for segment in &segments {
        nets.push(match segment {
            Segment::Bar(_) => None,
            Segment::Stack(stack) => {
                let mut solids = solids(&body, stack, &bars);
                if !stack.is_web {
                    // Bores of the ends are filled.
                    for solid in &mut solids {
                        let outer = solid.outline.outer().clone();
                        solid.outline = Outline::new(outer, Vec::new())
                            .map_err(|error| refuse(&stack.name, error.to_string(), "another diameter"))?;
                    }
                }
                known.extend(solids.iter().map(|solid| solid.name.clone()));
                Some(stack_net(&mut sweep, stack, &solids, &core)?)
            }
        });
    }
    let beside = beside(&bars, &segments, &nets);
    let rims = rims(&sweep, &core)?;
    let places = Places::new(&bars, layers, &circles, &sweep.points, &beside, &rims)?;
    for (place, segment) in segments.iter().enumerate() {
        match segment {
            Segment::Bar(index) => {
                let bar = &bars[*index];
                check_beside(&body, bar, &known)?;
                let [outer, bore] = [bar.radius, bar.bore].map(|radius| circles.circle(bar.centre, radius));
                let own = |at: Point| outer.contains(at) && !bore.contains(at);
                let disc = match &rims[*index] {
                    Some(rim) => rim.triangles.clone(),
                    None => sweep.pick(&core_net, own),
                };
                let disc: Vec<([usize; 3], u32)> = disc.into_iter().map(|triangle| (triangle, 0)).collect();
                let beside: Vec<&StackNet> = [place.checked_sub(1), Some(place + 1)]
                    .into_iter()
                    .filter_map(|side| nets.get(side?)?.as_ref())
                    .collect();
                let length = bar.faces[1] - bar.faces[0];
                let planes = beside.iter().flat_map(|net| net.planes()).map(|plane| plane - bar.faces[0]);
                let along = with_planes(
                    levels(length, bar.fillets, layers, options.size),
                    planes.collect(),
                    bar.fillets,
                );
                sweep.extrude(bar.faces[0], &along, &places, |z| {
                    let more = beside.iter().flat_map(|net| net.filled(z, true));
                    disc.iter().copied().chain(more).collect()
                });
            }
            Segment::Stack(stack) => {
                let Some(net) = &nets[place] else { continue };
                let radius = |end: usize| stack.bars[end].map_or(0.0, |bar| bars[bar].fillets[1 - end]);
                let radii = [radius(0), radius(1)];
                let planes = net.planes().map(|plane| plane - stack.faces[0]).collect();
                let thickness = stack.faces[1] - stack.faces[0];
                let along = with_planes(levels(thickness, radii, layers, options.size), planes, radii);
                sweep.extrude(stack.faces[0], &along, &places, |z| net.filled(z, false));
            }
        }
    }
    let mut mesh = std::mem::take(&mut sweep.mesh);
    let webs = webs(&mesh, &bars, &segments);
    let corners = finish(&mut mesh, &bars, &segments, faces);
    let quality = quality(&mesh).map_err(|error| match error {
        FlexError::Inverted { element, at, jacobian, needed } => {
            misshapen(&bars, element, at, jacobian, needed)
        }
        other => other,
    })?;
    if quality.least_jacobian < LEAST_JACOBIAN {
        let (element, at) = (quality.worst_element, quality.worst_place);
        return Err(misshapen(&bars, element, at, quality.least_jacobian, LEAST_JACOBIAN));
    }
    mesh.weights = carried_weights(&mesh, engine, index, &elements);
    let weights = mesh.weights.clone();
    let body_mass = match pin {
        None => body.mass.mass + end_mass(&elements, ends),
        Some(_) => body.mass.mass,
    };
    Ok(CrankMesh { mesh, quality, corners, webs, weights, body_mass, left_out })
}

/// The rims of steps of nose and flange that are thinner than the journal beside them.
///
/// # Errors
/// [`FlexError::Crowded`] where the triangles of the journal leave no room for one.
fn rims(sweep: &Sweep, core: &Core<'_>) -> Result<Vec<Option<Rim>>, FlexError> {
    let mut rims: Vec<Option<Rim>> = vec![None; core.bars.len()];
    for (index, bar) in core.bars.iter().enumerate() {
        if !bar.is_end || core.circles.find(bar.centre, bar.radius).is_some() {
            continue;
        }
        // From the steps of the nose to the first journal, from those of the flange back to the last.
        let mut journals = core.bars.iter().filter(|bar| bar.set.starts_with("MAIN_"));
        let journal = if bar.set.starts_with("NOSE_") { journals.next() } else { journals.next_back() };
        // A solid step has no triangles in the bore of its journal.
        let rim = journal.filter(|journal| journal.bore == 0.0).and_then(|journal| {
            let outer = core.circles.circle(journal.centre, journal.radius);
            // Steps at one end of the crankshaft share a plane.
            let end = |bar: &Bar| bar.set.starts_with("NOSE_");
            let own = core.bars.iter().zip(&rims).filter(|(other, _)| end(other) == end(bar));
            let own = own.filter_map(|(_, rim)| rim.as_ref());
            let taken = own.flat_map(|rim| &rim.edges).flatten().copied().collect();
            Rim::of(bar, core.net, &sweep.pick(core.net, |at| outer.contains(at)), &taken)
        });
        let crowded = || crowded(core.bars, bar.centre, format!("no room for the circle of {}", bar.name));
        rims[index] = Some(rim.ok_or_else(crowded)?);
    }
    Ok(rims)
}

/// Refuses elements of which the body would have too many, before any is made.
fn check_size(body: &CrankshaftBody, options: CrankMeshOptions) -> Result<(), FlexError> {
    let volume: f64 =
        body.outlines().map(|(_, outline, [front, rear])| outline.moments().area * (rear - front)).sum();
    let least = (volume / MOST_CELLS).cbrt();
    if options.size >= least {
        return Ok(());
    }
    Err(FlexError::Number {
        quantity: "size of the elements [m]".to_owned(),
        needed: format!("at least {least:.1e}, for {MOST_CELLS:.0e} elements in this crankshaft"),
        got: options.size,
        hint: "8 mm is usual; elements across a fillet are finer by themselves",
    })
}

/// What is beside the front and the rear face of each bar.
fn beside<'a>(bars: &[Bar], segments: &[Segment], nets: &'a [Option<StackNet>]) -> Vec<Option<Beside<'a>>> {
    let mut found: Vec<Option<Beside<'_>>> = vec![None; 2 * bars.len()];
    for (segment, net) in segments.iter().zip(nets) {
        let (Segment::Stack(stack), Some(net)) = (segment, net) else { continue };
        for (end, bar) in stack.bars.iter().enumerate() {
            if let Some(bar) = bar {
                let own = Beside { triangles: &net.triangles, fixed: &net.outlines, bores: &net.bores };
                found[2 * bar + 1 - end] = Some(own);
            }
        }
    }
    found
}

/// An element that is folded, with what lies near it.
fn misshapen(bars: &[Bar], element: usize, at: [f64; 3], jacobian: f64, needed: f64) -> FlexError {
    let message = format!(
        "element {element} at z {:.2} mm has a smallest scaled Jacobian of {jacobian:.3}, needed above {needed}",
        1e3 * at[2]
    );
    crowded(bars, Point::new(at[0], at[1]), message)
}

/// What has no room at a point, and which circles nearly touch there.
fn crowded(bars: &[Bar], at: Point, what: String) -> FlexError {
    let message = near_circles(bars, at).map_or(what.clone(), |circles| format!("{what}; {circles}"));
    FlexError::Crowded { at: [at.x, at.y], message }
}

/// Says which circles of two bars, fillets included, nearly touch in projection near a point.
fn near_circles(bars: &[Bar], at: Point) -> Option<String> {
    let circles = |bar: &Bar| {
        let name = bar.name.clone();
        let fillets = bar.fillets.into_iter().filter(|fillet| *fillet > 0.0);
        let fillets = fillets.map(|fillet| (format!("the fillet of {name}"), bar.radius + fillet));
        let own: Vec<(String, f64)> =
            std::iter::once((bar.name.clone(), bar.radius)).chain(fillets).collect();
        own
    };
    let mut best: Option<(f64, String)> = None;
    for (k, one) in bars.iter().enumerate() {
        for two in &bars[..k] {
            let apart = (one.centre - two.centre).norm();
            if apart < TINY {
                continue;
            }
            for (first, a) in circles(two) {
                for (second, b) in circles(one) {
                    // Beside each other, or one within the other.
                    for gap in [apart - a - b, (a - b).abs() - apart] {
                        let near = [(two.centre, a), (one.centre, b)]
                            .iter()
                            .map(|(centre, radius)| ((at - *centre).norm() - radius).abs())
                            .fold(0.0, f64::max);
                        let most = 0.06 * a.min(b);
                        let is_near = gap.abs() < most && near < 0.5 * a.min(b);
                        if is_near && best.as_ref().is_none_or(|(least, _)| gap.abs() < *least) {
                            let message = format!(
                                "the circles of {first} ({:.2} mm diameter) and {second} ({:.2} mm), {:.2} mm apart at their middles, {} by {:.2} mm",
                                2e3 * a,
                                2e3 * b,
                                1e3 * apart,
                                if gap > 0.0 { "miss each other" } else { "overlap" },
                                1e3 * gap.abs()
                            );
                            best = Some((gap.abs(), message));
                        }
                    }
                }
            }
        }
    }
    best.map(|(_, message)| message)
}

/// One material: Young's modulus and Poisson's ratio of the file, or those of steel.
fn material(
    engine: &Engine,
    body: &CrankshaftBody,
    elements: &[CrankElement],
) -> Result<Material, FlexError> {
    let density = elements[0].density;
    if let Some(part) = body.parts.iter().find(|part| part.part.density() != density) {
        let message = format!(
            "has a density of its own ({:.0} kg/m3, the crankshaft {density:.0} kg/m3), and overlaps what it sits on",
            part.part.density()
        );
        return Err(refuse(
            &part.name,
            message,
            "give heavy metal as round inserts of a counterweight, or one density for all",
        ));
    }
    let given = engine.crank_material.as_ref();
    let steel = Material::steel();
    let material = Material {
        name: "crankshaft".to_owned(),
        youngs_modulus: given
            .and_then(|own| own.youngs_modulus())
            .map_or(steel.youngs_modulus, |own| own.value),
        poisson_ratio: given.and_then(|own| own.poisson_ratio()).map_or(steel.poisson_ratio, |own| own.value),
        density,
    };
    material.check()?;
    Ok(material)
}

fn middles(chords: &Chords) -> HashMap<[usize; 2], Point> {
    chords.chords.iter().map(|([a, b], middle)| ([*a.min(b), *a.max(b)], *middle)).collect()
}

/// What stands beside a bar must belong to a web next to it.
fn check_beside(body: &CrankshaftBody, bar: &Bar, known: &[String]) -> Result<(), FlexError> {
    for (name, outline, faces) in body.outlines() {
        let (from, to) = (faces[0].max(bar.faces[0]), faces[1].min(bar.faces[1]));
        if to - from < TINY || !reaches_over(&outline, bar) {
            continue;
        }
        let (message, hint) = match known.iter().filter(|own| *own == name).count() {
            0 => (
                format!("{name} stands over it along the crank and touches no web at either side"),
                "let the counterweight begin at the face of a web",
            ),
            1 => continue,
            _ => (
                format!("{name} reaches over its whole length, from web to web"),
                "let the counterweight of each web end before the other",
            ),
        };
        return Err(refuse(&bar.name, message, hint));
    }
    Ok(())
}

/// Nodes of each web between the depths of its fillets.
fn webs(mesh: &Mesh, bars: &[Bar], segments: &[Segment]) -> Vec<WebPlace> {
    let stacks = segments.iter().filter_map(|segment| match segment {
        Segment::Stack(stack) if stack.is_web => Some(stack),
        _ => None,
    });
    let place = |stack: &Stack| {
        let depth = |end: usize| stack.bars[end].map_or(0.0, |bar| bars[bar].fillets[1 - end]);
        let (from, to) = (stack.faces[0] + depth(0), stack.faces[1] - depth(1));
        let nodes = mesh.pick(|at| at[2] > from + TINY && at[2] < to - TINY);
        WebPlace { name: stack.name.clone(), nodes }
    };
    stacks.map(place).collect()
}

/// Pulls corners onto their fillets and names the sets.
fn finish(mesh: &mut Mesh, bars: &[Bar], segments: &[Segment], names: [&str; 2]) -> Vec<FilletPlace> {
    let set = |mesh: &Mesh, name: String, is_in: &dyn Fn(&[f64; 3]) -> bool| NodeSet {
        name,
        nodes: mesh.pick(is_in),
    };
    let ends = mesh
        .nodes
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], node| [a.min(node[2]), b.max(node[2])]);
    let mut sets = Vec::new();
    for bar in bars {
        sets.push(set(mesh, bar.set.clone(), &|at| {
            let distance = (Point::new(at[0], at[1]) - bar.centre).norm();
            (distance - bar.radius).abs() < TINY
                && at[2] > bar.faces[0] + bar.fillets[0] - TINY
                && at[2] < bar.faces[1] - bar.fillets[1] + TINY
        }));
    }
    sets.push(set(mesh, names[0].to_owned(), &|at| at[2] < ends[0] + TINY));
    sets.push(set(mesh, names[1].to_owned(), &|at| at[2] > ends[1] - TINY));
    mesh.sets = sets;
    let mut corners = Vec::new();
    let mut moved = mesh.nodes.clone();
    for segment in segments {
        let Segment::Stack(stack) = segment else { continue };
        if !stack.is_web {
            continue;
        }
        for (end, bar) in stack.bars.iter().enumerate().filter_map(|(end, bar)| Some((end, &bars[(*bar)?]))) {
            let radius = bar.fillets[1 - end];
            let name = format!("{} at {}", bar.name, stack.name);
            let mut nodes = Vec::new();
            if radius > 0.0 && bar.has_web[1 - end] {
                let thickness = stack.faces[1] - stack.faces[0];
                let torus = Torus {
                    centre: bar.centre,
                    bar: bar.radius,
                    radius,
                    face: stack.faces[end],
                    into: if end == 0 { -1.0 } else { 1.0 },
                    fade: [
                        (3.0 * radius).min(0.95 * (bar.radius - bar.bore)),
                        (3.0 * radius).min(0.6 * thickness),
                    ],
                };
                for (node, (at, to)) in mesh.nodes.iter().zip(&mut moved).enumerate() {
                    let (u, side) = torus.displacement(*at);
                    for k in 0..3 {
                        to[k] += u[k];
                    }
                    if side == Side::Surface {
                        nodes.push(node as u32);
                    }
                }
            }
            corners.push(FilletPlace { name, radius, centre: bar.centre, bar: bar.radius, nodes });
        }
    }
    mesh.nodes = moved;
    corners
}
