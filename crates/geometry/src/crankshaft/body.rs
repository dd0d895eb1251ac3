//! The crankshaft: sections, totals, and parts to export.

use super::CrankshaftError;
use super::element::{Element, SectionKind, elements, shape};
use super::slab::{Group, Slab, slabs};
use crate::export::PlacedPart;
use lanchester_model::Engine;
use lanchester_shape::{GeometryError, Insert, MassMoments, MassProperties, Outline, Part, Point};
use serde::Serialize;
use std::ops::Add;

/// Inserts that share no more than this along the crank [m] touch: it is rounding.
const TOUCHING: f64 = 1e-12;

/// Unbalance of something that turns with the crankshaft, as a force and as a couple.
///
/// ```text
/// U = INTEGRAL (x, y) dm      V = INTEGRAL z (x, y) dm        (book, eq. 22.50)
/// [kg m]                      [kg m^2], about the origin of the engine
/// ```
/// At the angular speed `w` it pulls with `w^2 U`, and with the couple `w^2 V` of the forces at their places along z.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct CrankUnbalance {
    /// Static unbalance `U` [kg m].
    pub unbalance: Point,
    /// Its moment `V` along the crank [kg m^2].
    pub couple: Point,
}

impl CrankUnbalance {
    fn of(moments: &MassMoments) -> CrankUnbalance {
        CrankUnbalance { unbalance: moments.unbalance(), couple: moments.couple() }
    }
}

impl Add for CrankUnbalance {
    type Output = CrankUnbalance;
    fn add(self, other: CrankUnbalance) -> CrankUnbalance {
        CrankUnbalance { unbalance: self.unbalance + other.unbalance, couple: self.couple + other.couple }
    }
}

/// A piece of the crankshaft: a journal, a pin, a web or a counterweight.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankshaftSection {
    /// "journal 1", "pin 1", "web 1", or the name of the counterweight.
    pub name: String,
    /// What it is.
    pub kind: SectionKind,
    /// Index of the throw that it belongs to; none for journals and weights beside the webs.
    pub throw: Option<usize>,
    /// Where it begins [m].
    pub from: f64,
    /// Where it ends [m].
    pub to: f64,
    /// Its mass [kg]: of a counterweight what it has beside journals, pins, webs and the counterweights before it.
    pub mass: f64,
    /// Moment of inertia about the crank axis [kg m^2].
    pub polar_inertia: f64,
    /// Its unbalance.
    #[serde(flatten)]
    pub unbalance: CrankUnbalance,
}

/// What belongs to one throw, or to none: journals, and weights beside the webs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ThrowShare {
    /// Index of the throw.
    pub throw: Option<usize>,
    /// Mass of pin, webs and counterweights on them [kg].
    pub mass: f64,
    /// Moment of inertia about the crank axis [kg m^2].
    pub polar_inertia: f64,
    /// Unbalance.
    #[serde(flatten)]
    pub unbalance: CrankUnbalance,
}

/// A weight of the crankshaft that the file gives by its unbalance alone, such as one of the flywheel. It has no mass here.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PointWeight {
    /// Its name.
    pub name: String,
    /// Its plane [m].
    pub z: f64,
    /// Its unbalance.
    #[serde(flatten)]
    pub unbalance: CrankUnbalance,
}

/// A crankshaft as a body. Frame: [`crate::crankshaft`].
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankshaftBody {
    /// Name of the crankshaft.
    pub name: String,
    /// Its pieces along z.
    pub sections: Vec<CrankshaftSection>,
    /// The same by throw, in the order of the file, and last what belongs to none.
    pub throws: Vec<ThrowShare>,
    /// Mass, centre and inertia of all pieces, without point weights: about the origin of the engine on the crank axis
    /// and about the centre of mass, products of inertia with their minus sign.
    pub mass: MassProperties,
    /// Moment of inertia about the crank axis [kg m^2], without point weights.
    pub polar_inertia: f64,
    /// Weights given by number only.
    pub point_weights: Vec<PointWeight>,
    /// Unbalance of all pieces and point weights.
    pub unbalance: CrankUnbalance,
    /// What pieces have in common, which a sum over pieces that stand alone would count twice (eq. 22.52). Of an engine that was read
    /// from a file the part that a counterweight of the family shares with its own web is out of its weight already.
    pub counted_twice: CrankUnbalance,
    /// Its solids for STEP, STL and glTF: one for each web with what is joined to it, where that is of one material. A part with
    /// chamfers stays by itself, and pieces of different materials overlap as they do in the file.
    #[serde(skip)]
    pub parts: Vec<PlacedPart>,
}

impl CrankshaftBody {
    /// Names and outlines of its solids, in the directions of the crankshaft, with their faces along z [m].
    pub fn outlines(&self) -> impl Iterator<Item = (&str, Outline, [f64; 2])> {
        self.parts.iter().map(|placed| {
            let faces = placed.part.faces().map(|face| face + placed.z);
            (placed.name.as_str(), placed.part.outline().turned(placed.turn), faces)
        })
    }
}

/// Crankshaft `index` of an engine as a body.
///
/// # Errors
/// Where the file does not say enough ([`CrankshaftError::NoBody`], [`CrankshaftError::NoWebs`]), or a shape cannot be.
pub fn crankshaft(engine: &Engine, index: usize) -> Result<CrankshaftBody, CrankshaftError> {
    let elements = elements(engine, index)?;
    check_inserts(&elements)?;
    let slabs = slabs(&elements)?;
    let mut moments: Vec<MassMoments> = elements.iter().map(Element::inserts_and_chamfers).collect();
    let mut twice = MassMoments::default();
    for slab in &slabs {
        for (member, [added, common]) in &slab.members {
            let density = elements[*member].density;
            moments[*member] = moments[*member] + MassMoments::prism(added, slab.faces) * density;
            twice = twice + MassMoments::prism(common, slab.faces) * density;
        }
    }
    let total = moments.iter().fold(MassMoments::default(), |sum, moments| sum + *moments);
    let point_weights: Vec<PointWeight> = engine
        .counterweights
        .iter()
        .filter(|weight| weight.crankshaft == index && weight.part.is_none())
        .map(|weight| {
            let unbalance = Point::polar(weight.unbalance, weight.angle);
            let unbalance = CrankUnbalance { unbalance, couple: unbalance * weight.z };
            PointWeight { name: weight.name.clone(), z: weight.z, unbalance }
        })
        .collect();
    let points = point_weights.iter().map(|weight| weight.unbalance);
    Ok(CrankshaftBody {
        name: engine.crankshafts[index].name.clone(),
        sections: sections(&elements, &moments),
        throws: throws(engine, index, &elements, &moments),
        mass: total.properties(),
        polar_inertia: total.second[0] + total.second[1],
        unbalance: points.fold(CrankUnbalance::of(&total), CrankUnbalance::add),
        point_weights,
        counted_twice: CrankUnbalance::of(&twice),
        parts: parts(&elements, &slabs)?,
    })
}

/// Refuses inserts of two pieces in one place: a slug of metal is there once, of whatever material the pieces around it are.
fn check_inserts(elements: &[Element]) -> Result<(), CrankshaftError> {
    let meet = |one: &Insert, other: &Insert| {
        (one.centre - other.centre).norm() < one.radius + other.radius
            && one.from.max(other.from) + TOUCHING < one.to.min(other.to)
    };
    for (place, element) in elements.iter().enumerate() {
        for insert in element.inserts() {
            if elements[..place].iter().flat_map(Element::inserts).any(|other| meet(&insert, &other)) {
                let (at, radius) = (insert.centre, insert.radius);
                let source = GeometryError::InsertOutside { at, radius, what: "overlaps another insert" };
                return Err(shape(&element.name, source));
            }
        }
    }
    Ok(())
}

fn sections(elements: &[Element], moments: &[MassMoments]) -> Vec<CrankshaftSection> {
    let section = |(element, moments): (&Element, &MassMoments)| CrankshaftSection {
        name: element.name.clone(),
        kind: element.kind,
        throw: element.throw,
        from: element.faces[0],
        to: element.faces[1],
        mass: moments.mass,
        polar_inertia: moments.second[0] + moments.second[1],
        unbalance: CrankUnbalance::of(moments),
    };
    let mut sections: Vec<CrankshaftSection> = elements.iter().zip(moments).map(section).collect();
    sections.sort_by(|a, b| (a.from + a.to).total_cmp(&(b.from + b.to)));
    sections
}

fn throws(engine: &Engine, index: usize, elements: &[Element], moments: &[MassMoments]) -> Vec<ThrowShare> {
    let own = (0..engine.throws.len()).filter(|throw| engine.throws[*throw].crankshaft == index);
    let share = |throw: Option<usize>| {
        let its = elements.iter().zip(moments).filter(|(element, _)| element.throw == throw);
        let sum = its.fold(MassMoments::default(), |sum, (_, moments)| sum + *moments);
        let (polar_inertia, unbalance) = (sum.second[0] + sum.second[1], CrankUnbalance::of(&sum));
        ThrowShare { throw, mass: sum.mass, polar_inertia, unbalance }
    };
    own.map(Some).chain([None]).map(share).collect()
}

/// The solids: groups that go on from slab to slab unchanged are one.
fn parts(elements: &[Element], slabs: &[Slab]) -> Result<Vec<PlacedPart>, CrankshaftError> {
    let mut solids: Vec<(Group, [f64; 2])> = Vec::new();
    for slab in slabs {
        for group in &slab.groups {
            let goes_on = solids
                .iter_mut()
                .find(|(before, faces)| before.members == group.members && faces[1] == slab.faces[0]);
            match goes_on {
                Some((_, faces)) => faces[1] = slab.faces[1],
                None => solids.push((group.clone(), slab.faces)),
            }
        }
    }
    let mut parts: Vec<PlacedPart> = Vec::new();
    for (group, faces) in solids {
        let names: Vec<&str> = group.members.iter().map(|member| elements[*member].name.as_str()).collect();
        let mut name = joined(&names);
        let same = parts
            .iter()
            .filter(|part| part.name == name || part.name.starts_with(&format!("{name}, ")))
            .count();
        if same > 0 {
            name = format!("{name}, {}", same + 1);
        }
        let part = solid(elements, &group, faces).map_err(|source| shape(&name, source))?;
        parts.push(PlacedPart::new(name, part));
    }
    for element in elements.iter().filter(|element| element.has_chamfers()) {
        if let Some((part, turn)) = &element.part {
            let z = element.faces[0] - part.faces()[0];
            parts.push(PlacedPart::new(element.name.clone(), part.clone()).turned(*turn).moved(z));
        }
    }
    Ok(parts)
}

/// Names of what is joined; a counterweight that is called as its web is said to be one.
fn joined(names: &[&str]) -> String {
    let mut name = names[0].to_owned();
    for (index, next) in names.iter().enumerate().skip(1) {
        name += " with ";
        name += if names[..index].contains(next) { "counterweight" } else { next };
    }
    name
}

/// A group between two planes, with the inserts of its members as far as they lie there.
fn solid(elements: &[Element], group: &Group, [from, to]: [f64; 2]) -> Result<Part, GeometryError> {
    let density = elements[group.members[0]].density;
    let mut part = Part::new(group.outline.clone(), to - from, density)?.at((from + to) / 2.0);
    for element in group.members.iter().map(|member| &elements[*member]) {
        for insert in element.inserts() {
            let ends = [insert.from, insert.to].map(|end| end.clamp(from, to) - from);
            if ends[1] - ends[0] > TOUCHING {
                part = part.with_insert(Insert { from: ends[0], to: ends[1], ..insert })?;
            }
        }
    }
    Ok(part)
}
