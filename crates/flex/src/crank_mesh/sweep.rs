//! From the elements of a crankshaft to its mesh.

use super::circles::{Chords, Polygon, Rings, chords, outline_chords};
use super::fillet::{Side, Torus};
use super::levels::levels;
use super::net::{Net, net};
use crate::element::ElementKind;
use crate::mesh::{Element, Mesh, MeshQuality, NodeSet, quality};
use crate::{FlexError, LEAST_JACOBIAN, Material};
use lanchester_geometry::crankshaft::{CrankshaftBody, crankshaft};
use lanchester_model::{CrankElement, CrankElementForm, Engine};
use lanchester_shape::{Outline, Point};
use serde::Serialize;
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

/// Points closer than this are at one place [m].
const TINY: f64 = 1e-7;

/// How fine a crankshaft is meshed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankMeshOptions {
    /// Edge of the elements away from fillets [m].
    pub size: f64,
    /// Elements across the 90 degrees of a fillet: an even number, at least 2.
    pub fillet_elements: usize,
    /// Whether fillets are meshed; without them their corners are sharp, which is enough for stiffness.
    pub fillets: bool,
}

impl Default for CrankMeshOptions {
    fn default() -> CrankMeshOptions {
        CrankMeshOptions { size: 8e-3, fillet_elements: 6, fillets: true }
    }
}

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

/// The mesh of a crankshaft. Sets: `MAIN_1` .. and `PIN_1` .. (the bearing surfaces between the fillets), `FREE_END`, `FLYWHEEL` (the end
/// faces).
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankMesh {
    /// The mesh.
    #[serde(skip)]
    pub mesh: Mesh,
    /// Its quality.
    pub quality: MeshQuality,
    /// Its corners, along z.
    pub corners: Vec<FilletPlace>,
    /// What of the crankshaft is not meshed.
    pub left_out: Vec<String>,
}

struct Bar {
    name: String,
    set: String,
    centre: Point,
    radius: f64,
    bore: f64,
    faces: [f64; 2],
    fillets: [f64; 2],
    has_web: [bool; 2],
}

/// Webs between two bars, or at an end of the crankshaft.
struct Stack {
    name: String,
    faces: [f64; 2],
    bars: [Option<usize>; 2],
}

enum Segment {
    Bar(usize),
    Stack(Stack),
}

fn refuse(place: &str, message: impl Into<String>, hint: &'static str) -> FlexError {
    FlexError::Mesh { place: place.to_owned(), message: message.into(), hint }
}

/// Meshes crankshaft `index` of an engine.
///
/// # Errors
/// [`FlexError::Crankshaft`] where the file does not say enough; [`FlexError::Mesh`] where fillets do not fit or the shape is not covered
/// (parts of several materials, counterweights that reach over a journal or pin along the crank); [`FlexError::Inverted`] for a mesh
/// below [`LEAST_JACOBIAN`].
pub fn crank_mesh(engine: &Engine, index: usize, options: CrankMeshOptions) -> Result<CrankMesh, FlexError> {
    check_options(options)?;
    let body = crankshaft(engine, index)?;
    let elements = engine
        .crank_elements(index)
        .map_err(|fault| refuse("crankshaft", fault.to_string(), "complete [crank.body] and [crank]"))?;
    let mut left_out = Vec::new();
    let (bars, segments) = segments(&elements, options, &mut left_out)?;
    check_fillets(&bars, &segments)?;
    let layers = options.fillet_elements / 2;
    let rings = rings(&bars, layers, options.size);
    let core_chords = chords(&rings);
    let core = net(&core_chords, options.size).map_err(|at| {
        let place = format!("({:.2}, {:.2}) mm across the crank", 1e3 * at.x, 1e3 * at.y);
        refuse(
            &place,
            "circles of journals, pins and fillets nearly touch",
            "change a fillet radius slightly",
        )
    })?;
    let mut sweep = Sweep {
        middles: middles(&core_chords),
        points: core.points.clone(),
        nodes: HashMap::new(),
        mesh: Mesh { materials: vec![material(engine, &body, &elements)?], ..Mesh::default() },
        levels: Vec::new(),
    };
    for segment in &segments {
        match segment {
            Segment::Bar(bar) => {
                let bar = &bars[*bar];
                check_alone(&body, bar)?;
                let [outer, bore] =
                    [bar.radius, bar.bore].map(|radius| core_chords.circle(bar.centre, radius));
                let own = |at: Point| outer.contains(at) && !bore.contains(at);
                let triangles = sweep.pick(&core, own);
                let along = levels(bar.faces[1] - bar.faces[0], bar.fillets, layers, options.size);
                sweep.extrude(bar.faces[0], &along, |_| triangles.clone());
            }
            Segment::Stack(stack) => {
                stack_mesh(&mut sweep, stack, &bars, &core, &core_chords, &body, options)?
            }
        }
    }
    let mut mesh = std::mem::take(&mut sweep.mesh);
    let corners = finish(&mut mesh, &bars, &segments);
    let quality = quality(&mesh)?;
    if quality.least_jacobian < LEAST_JACOBIAN {
        return Err(FlexError::Inverted {
            element: quality.worst_element,
            at: quality.worst_place,
            jacobian: quality.least_jacobian,
            needed: LEAST_JACOBIAN,
        });
    }
    Ok(CrankMesh { mesh, quality, corners, left_out })
}

fn check_options(options: CrankMeshOptions) -> Result<(), FlexError> {
    let refuse = |quantity: &str, needed: &str, got| {
        let hint = "8 mm and 6 elements are usual";
        Err(FlexError::Number { quantity: quantity.to_owned(), needed: needed.to_owned(), got, hint })
    };
    if !(1e-4..=1.0).contains(&options.size) {
        return refuse("size of the elements [m]", "between 0.0001 and 1", options.size);
    }
    let count = options.fillet_elements;
    if !(2..=40).contains(&count) || count % 2 == 1 {
        return refuse("elements across a fillet", "an even number from 2 to 40", count as f64);
    }
    Ok(())
}

/// One material: Young's modulus and Poisson's ratio of the file, or those of steel.
fn material(
    engine: &Engine,
    body: &CrankshaftBody,
    elements: &[CrankElement],
) -> Result<Material, FlexError> {
    let density = elements[0].density;
    if let Some(part) =
        body.parts.iter().find(|part| part.part.density() != density || !part.part.inserts().is_empty())
    {
        return Err(refuse(&part.name, "has a material of its own", "leave inserts and other densities out"));
    }
    if let Some(part) = body.parts.iter().find(|part| !part.part.chamfers().is_empty()) {
        return Err(refuse(&part.name, "has chamfers, which are not meshed", "leave the chamfers out"));
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

fn segments(
    elements: &[CrankElement],
    options: CrankMeshOptions,
    left_out: &mut Vec<String>,
) -> Result<(Vec<Bar>, Vec<Segment>), FlexError> {
    let (mut bars, mut segments): (Vec<Bar>, Vec<Segment>) = (Vec::new(), Vec::new());
    for element in elements {
        let set = match element.form {
            CrankElementForm::Journal { journal, .. } => format!("MAIN_{}", journal + 1),
            CrankElementForm::Pin { throw, .. } => format!("PIN_{}", throw + 1),
            CrankElementForm::Nose { .. } | CrankElementForm::Flange { .. } => {
                left_out.push(format!("{} (beyond the end journals)", element.name()));
                continue;
            }
            CrankElementForm::Web { .. } => {
                let before = bars.len().checked_sub(1);
                match segments.last_mut() {
                    Some(Segment::Stack(stack)) => stack.faces[1] = element.faces[1],
                    _ => segments.push(Segment::Stack(Stack {
                        name: element.name(),
                        faces: element.faces,
                        bars: [before, None],
                    })),
                }
                continue;
            }
        };
        let Some(bar) = element.bar() else { continue };
        if let Some(Segment::Stack(stack)) = segments.last_mut() {
            stack.bars[1] = Some(bars.len());
        }
        let radius = |fillet: Option<lanchester_model::Fillet>| {
            if options.fillets { fillet.and_then(|fillet| fillet.radius).unwrap_or(0.0) } else { 0.0 }
        };
        if bar.fillets.iter().flatten().any(|fillet| fillet.recess > 0.0) {
            left_out.push(format!("recess of the fillets of {}", element.name()));
        }
        if let CrankElementForm::Pin { oil_hole: Some(_), .. } = element.form {
            left_out.push(format!("oil hole of {}", element.name()));
        }
        segments.push(Segment::Bar(bars.len()));
        bars.push(Bar {
            name: element.name(),
            set,
            centre: bar.centre,
            radius: bar.diameter / 2.0,
            bore: bar.bore / 2.0,
            faces: element.faces,
            fillets: bar.fillets.map(radius),
            has_web: bar.fillets.map(|fillet| fillet.is_some()),
        });
    }
    Ok((bars, segments))
}

fn check_fillets(bars: &[Bar], segments: &[Segment]) -> Result<(), FlexError> {
    for bar in bars {
        let length = bar.faces[1] - bar.faces[0];
        if bar.fillets[0] + bar.fillets[1] > length * 0.98 {
            let message = format!(
                "fillets of {:.2} and {:.2} mm leave nothing of its {:.2} mm",
                1e3 * bar.fillets[0],
                1e3 * bar.fillets[1],
                1e3 * length
            );
            return Err(refuse(&bar.name, message, "smaller fillets, or a longer bar"));
        }
        if bar.fillets.iter().any(|fillet| *fillet > 0.9 * (bar.radius - bar.bore)) {
            return Err(refuse(&bar.name, "its fillet is larger than its wall", "a smaller fillet"));
        }
    }
    for segment in segments {
        let Segment::Stack(stack) = segment else { continue };
        let radius = |end: usize| stack.bars[end].map_or(0.0, |bar| bars[bar].fillets[1 - end]);
        let thickness = stack.faces[1] - stack.faces[0];
        if radius(0) + radius(1) > 0.9 * thickness {
            let message = format!("its {:.2} mm are too thin for the fillets at its faces", 1e3 * thickness);
            return Err(refuse(&stack.name, message, "smaller fillets, or a thicker web"));
        }
    }
    Ok(())
}

/// Circles about each centre once.
fn rings(bars: &[Bar], layers: usize, size: f64) -> Vec<Rings> {
    let mut rings: Vec<Rings> = Vec::new();
    for bar in bars {
        let mut add = |radii: Vec<f64>, chord: f64, is_bore: bool| {
            let own =
                |rings: &&mut Rings| rings.is_bore == is_bore && (rings.centre - bar.centre).norm() < TINY;
            match rings.iter_mut().find(own) {
                Some(rings) => {
                    rings.chord = rings.chord.min(chord);
                    for radius in &radii {
                        if rings.radii.iter().all(|own| (own - radius).abs() > TINY) {
                            rings.radii.push(*radius);
                        }
                    }
                    rings.radii.sort_by(f64::total_cmp);
                }
                None => rings.push(Rings { centre: bar.centre, radii, chord, is_bore }),
            }
        };
        let mut fillets: Vec<f64> = bar.fillets.into_iter().filter(|fillet| *fillet > 0.0).collect();
        fillets.sort_by(f64::total_cmp);
        let mut radii = vec![bar.radius];
        if let Some(fillet) = fillets.first() {
            radii.extend((1..=layers).map(|k| bar.radius + fillet * k as f64 / layers as f64));
        }
        let chord = fillets.first().map_or(size, |fillet| (1.6 * fillet).min(size));
        radii.extend(fillets.iter().skip(1).map(|fillet| bar.radius + fillet));
        radii.dedup_by(|a, b| (*a - *b).abs() < TINY);
        add(radii, chord, false);
        if bar.bore > 0.0 {
            add(vec![bar.bore], size, true);
        }
    }
    rings
}

fn middles(chords: &Chords) -> HashMap<[usize; 2], Point> {
    chords.chords.iter().map(|([a, b], middle)| ([*a.min(b), *a.max(b)], *middle)).collect()
}

/// A bar's slab must hold nothing else.
fn check_alone(body: &CrankshaftBody, bar: &Bar) -> Result<(), FlexError> {
    let middle = |[from, to]: [f64; 2]| (from.max(bar.faces[0]), to.min(bar.faces[1]));
    for (name, outline, faces) in body.outlines() {
        let (from, to) = middle(faces);
        if to - from > TINY && outline.farthest_point_from(bar.centre) > bar.radius + TINY {
            let message = format!("{name} reaches over it along the crank");
            return Err(refuse(&bar.name, message, "make the counterweight no thicker than its web"));
        }
    }
    Ok(())
}

trait Farthest {
    fn farthest_point_from(&self, from: Point) -> f64;
}

impl Farthest for Outline {
    fn farthest_point_from(&self, from: Point) -> f64 {
        self.outer().farthest(from).0
    }
}

#[allow(clippy::too_many_arguments, reason = "the parts of one mesh, each of another kind")]
fn stack_mesh(
    sweep: &mut Sweep,
    stack: &Stack,
    bars: &[Bar],
    core: &Net,
    core_chords: &Chords,
    body: &CrankshaftBody,
    options: CrankMeshOptions,
) -> Result<(), FlexError> {
    // Slabs of the stack, each with its outlines.
    let solids: Vec<(Outline, [f64; 2])> = body
        .outlines()
        .filter(|(_, _, faces)| faces[0].max(stack.faces[0]) + TINY < faces[1].min(stack.faces[1]))
        .map(|(_, outline, faces)| (outline, faces))
        .collect();
    let mut planes: Vec<f64> = solids.iter().flat_map(|(_, faces)| *faces).chain(stack.faces).collect();
    planes.retain(|plane| *plane > stack.faces[0] - TINY && *plane < stack.faces[1] + TINY);
    planes.sort_by(f64::total_cmp);
    planes.dedup_by(|a, b| (*a - *b).abs() < TINY);
    // What the core gives: the discs of both bars out to their outermost ring.
    let discs: Vec<(Point, f64)> = stack
        .bars
        .iter()
        .flatten()
        .map(|bar| {
            // Bars of one axis and radius share their circles.
            let own = &bars[*bar];
            let same = |other: &&Bar| {
                (other.centre - own.centre).norm() < TINY && (other.radius - own.radius).abs() < TINY
            };
            let fillets = bars.iter().filter(same).flat_map(|bar| bar.fillets);
            let outer = own.radius + fillets.fold(0.0, f64::max);
            (bars[*bar].centre, outer)
        })
        .collect();
    for (outline, _) in &solids {
        for (centre, radius) in &discs {
            let room = outline.outer().nearest(*centre).0;
            if !outline.contains(*centre) && outline.holes().is_empty() || room < radius + 0.2e-3 {
                let message = format!(
                    "its outline is {:.2} mm from the middle of a journal or pin, whose fillet reaches {:.2} mm",
                    1e3 * room,
                    1e3 * radius
                );
                return Err(refuse(&stack.name, message, "a smaller fillet or a larger web"));
            }
        }
    }
    let polygons: Vec<Polygon> =
        discs.iter().map(|(centre, radius)| core_chords.circle(*centre, *radius)).collect();
    let is_core = |at: Point| polygons.iter().any(|polygon| polygon.contains(at));
    let boundary = |middle: Point| {
        let place = |(centre, radius): &(Point, f64)| (middle - *centre).norm() - radius;
        discs.iter().any(|disc| place(disc).abs() < TINY) && discs.iter().all(|disc| place(disc) > -TINY)
    };
    let mut outer = Chords::default();
    let mut names: Vec<usize> = Vec::new();
    for ([a, b], middle) in core_chords.chords.iter().filter(|(_, middle)| boundary(*middle)) {
        let ends = [*a, *b].map(|point| {
            names.iter().position(|name| *name == point).unwrap_or_else(|| {
                names.push(point);
                outer.points.push(core_chords.points[point]);
                names.len() - 1
            })
        });
        outer.chords.push((ends, *middle));
    }
    let mut seen: Vec<&Outline> = Vec::new();
    let mut filled: Vec<Polygon> = Vec::new();
    for (outline, _) in &solids {
        let own = outline_chords(outline, options.size);
        // Holes are bores, circles of the core, with its chords.
        let mut polygon = outline_chords(
            &Outline::new(outline.outer().clone(), Vec::new())
                .map_err(|source| refuse(&stack.name, source.to_string(), "a simpler outline"))?,
            options.size,
        )
        .polygon();
        for hole in outline.holes() {
            let bore = stack
                .bars
                .iter()
                .flatten()
                .map(|bar| &bars[*bar])
                .find(|bar| hole.contains(bar.centre) && bar.bore > 0.0);
            let Some(bore) = bore else {
                return Err(refuse(
                    &stack.name,
                    "has a hole that is no bore of its journal or pin",
                    "leave the hole out",
                ));
            };
            polygon.0.extend(core_chords.circle(bore.centre, bore.bore).0);
        }
        filled.push(polygon);
        if seen.contains(&outline) {
            continue;
        }
        seen.push(outline);
        // Holes of bores are circles of the core already.
        for ([a, b], middle) in own.chords.iter().filter(|(_, middle)| !is_core(*middle)) {
            let ends = [*a, *b].map(|point| {
                let at = own.points[point];
                let found = outer.points.iter().position(|point| (*point - at).norm() < TINY);
                found.unwrap_or_else(|| {
                    outer.points.push(at);
                    outer.points.len() - 1
                })
            });
            let is_there = |(other, _): &([usize; 2], Point)| *other == ends || *other == [ends[1], ends[0]];
            if !outer.chords.iter().any(is_there) {
                outer.chords.push((ends, *middle));
            }
        }
    }
    let outside = net(&outer, options.size).map_err(|at| {
        let message = format!("outlines of its slabs cross at ({:.2}, {:.2}) mm", 1e3 * at.x, 1e3 * at.y);
        refuse(&stack.name, message, "one outline through the whole thickness of a web")
    })?;
    // Points of the outer net in the numbers of the sweep.
    let first = sweep.points.len();
    let number = |point: usize| if point < names.len() { names[point] } else { first + point - names.len() };
    sweep.points.extend_from_slice(&outside.points[names.len()..]);
    for ([a, b], middle) in &outer.chords {
        let (a, b) = (number(*a), number(*b));
        sweep.middles.insert([a.min(b), a.max(b)], *middle);
    }
    let mut all = sweep.pick(core, is_core);
    all.extend(
        outside
            .triangles
            .iter()
            .map(|triangle| triangle.map(number))
            .filter(|triangle| !is_core(sweep.centre(triangle))),
    );
    let radius = |end: usize| stack.bars[end].map_or(0.0, |bar| bars[bar].fillets[1 - end]);
    let mut along = levels(
        stack.faces[1] - stack.faces[0],
        [radius(0), radius(1)],
        options.fillet_elements / 2,
        options.size,
    );
    for plane in &planes {
        let at = plane - stack.faces[0];
        // A slab's face takes the place of a level that is near.
        let count = along.len();
        match along[1..count - 1].iter().position(|level| (level - at).abs() < 0.4e-3) {
            Some(near) => along[near + 1] = at,
            None if along.iter().all(|level| (level - at).abs() > TINY) => along.push(at),
            None => {}
        }
    }
    along.sort_by(f64::total_cmp);
    let centres: Vec<Point> = all.iter().map(|triangle| sweep.centre(triangle)).collect();
    sweep.extrude(stack.faces[0], &along, |z| {
        let there: Vec<&Polygon> = solids
            .iter()
            .zip(&filled)
            .filter(|((_, faces), _)| faces[0] < z && z < faces[1])
            .map(|(_, polygon)| polygon)
            .collect();
        let is_filled = |at: &Point| there.iter().any(|polygon| polygon.contains(*at));
        all.iter().zip(&centres).filter(|(_, at)| is_filled(at)).map(|(triangle, _)| *triangle).collect()
    });
    Ok(())
}

struct Sweep {
    points: Vec<Point>,
    /// Middles of arcs by the ends of their chords.
    middles: HashMap<[usize; 2], Point>,
    /// Node of a point (both numbers the same) or edge at a level, in half levels.
    nodes: HashMap<([usize; 2], usize), u32>,
    mesh: Mesh,
    /// Levels so far [m].
    levels: Vec<f64>,
}

impl Sweep {
    fn centre(&self, triangle: &[usize; 3]) -> Point {
        (self.points[triangle[0]] + self.points[triangle[1]] + self.points[triangle[2]]) * (1.0 / 3.0)
    }

    fn pick(&self, net: &Net, is_in: impl Fn(Point) -> bool) -> Vec<[usize; 3]> {
        net.triangles.iter().filter(|triangle| is_in(self.centre(triangle))).copied().collect()
    }

    /// Adds a layer of wedges between each two levels [m] above `from`; the first one is the last one so far.
    fn extrude(&mut self, from: f64, along: &[f64], triangles: impl Fn(f64) -> Vec<[usize; 3]>) {
        if self.levels.is_empty() {
            self.levels.push(from + along[0]);
        }
        for pair in along.windows(2) {
            let low = self.levels.len() - 1;
            self.levels.push(from + pair[1]);
            for corners in triangles(from + (pair[0] + pair[1]) / 2.0) {
                let edges = [[0, 1], [1, 2], [2, 0]].map(|[a, b]: [usize; 2]| {
                    let (a, b) = (corners[a], corners[b]);
                    [a.min(b), a.max(b)]
                });
                let points = corners.map(|corner| [corner, corner]);
                let mut nodes = Vec::with_capacity(15);
                for (keys, level) in [
                    (points, 2 * low),
                    (points, 2 * low + 2),
                    (edges, 2 * low),
                    (edges, 2 * low + 2),
                    (points, 2 * low + 1),
                ] {
                    nodes.extend(keys.map(|key| self.node(key, level)));
                }
                self.mesh.elements.push(Element { kind: ElementKind::Wedge, nodes, material: 0 });
            }
        }
    }

    fn node(&mut self, key: [usize; 2], level: usize) -> u32 {
        if let Some(node) = self.nodes.get(&(key, level)) {
            return *node;
        }
        let chord = (self.points[key[0]] + self.points[key[1]]) * 0.5;
        let at = self.middles.get(&key).copied().unwrap_or(chord);
        let z = (self.levels[level / 2] + self.levels[level.div_ceil(2)]) / 2.0;
        let node = self.mesh.nodes.len() as u32;
        self.mesh.nodes.push([at.x, at.y, z]);
        self.nodes.insert((key, level), node);
        node
    }
}

/// Pulls corners onto their fillets and names the sets.
fn finish(mesh: &mut Mesh, bars: &[Bar], segments: &[Segment]) -> Vec<FilletPlace> {
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
    sets.push(set(mesh, "FREE_END".to_owned(), &|at| at[2] < ends[0] + TINY));
    sets.push(set(mesh, "FLYWHEEL".to_owned(), &|at| at[2] > ends[1] - TINY));
    mesh.sets = sets;
    let mut corners = Vec::new();
    let mut moved = mesh.nodes.clone();
    for segment in segments {
        let Segment::Stack(stack) = segment else { continue };
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
