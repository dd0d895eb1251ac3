//! What a crankshaft is made of: journals, pins, webs and counterweights, each a plate in the frame of the crankshaft.

use super::CrankshaftError;
use lanchester_model::{CounterweightForm, CounterweightPart, CrankElementForm, Engine};
use lanchester_shape::{GeometryError, Insert, MassMoments, Outline, Part};
use serde::Serialize;

/// What a piece of a crankshaft is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SectionKind {
    /// A main journal, or a step of the nose or the flange.
    Journal,
    /// A crankpin.
    Pin,
    /// A web: a plain one, or one whose outline the file gives as a whole.
    Web,
    /// A counterweight, as far as it is not within journals, pins and webs.
    Counterweight,
}

/// A plate of a crankshaft, as if it stood alone.
#[derive(Debug, Clone)]
pub(super) struct Element {
    pub name: String,
    pub kind: SectionKind,
    /// Index of the throw that it belongs to.
    pub throw: Option<usize>,
    /// Its faces along the crank [m], from the origin of the engine.
    pub faces: [f64; 2],
    /// Its outline in the directions of the crankshaft at angle zero.
    pub outline: Outline,
    pub density: f64,
    /// The part with its inserts and chamfers, where it is one, and its turn [rad].
    pub part: Option<(Part, f64)>,
}

impl Element {
    /// What inserts add and chamfers take away, in the frame of the crankshaft.
    pub fn inserts_and_chamfers(&self) -> MassMoments {
        let Some((part, turn)) = &self.part else { return MassMoments::default() };
        let plate = MassMoments::prism(&part.outline().moments(), part.faces()) * part.density();
        let middle = (self.faces[0] + self.faces[1]) / 2.0 - (part.faces()[0] + part.faces()[1]) / 2.0;
        (part.moments() - plate).turned(*turn).moved([0.0, 0.0, middle])
    }

    /// Its inserts in the frame of the crankshaft: their ends are planes along it, from the origin of the engine.
    pub fn inserts(&self) -> impl Iterator<Item = Insert> {
        self.part.iter().flat_map(|(part, turn)| {
            part.inserts().iter().map(|insert| Insert {
                centre: insert.centre.turned(*turn),
                from: self.faces[0] + insert.from,
                to: self.faces[0] + insert.to,
                ..*insert
            })
        })
    }

    /// Whether chamfers make it something else than a prism.
    pub fn has_chamfers(&self) -> bool {
        self.part.as_ref().is_some_and(|(part, _)| !part.chamfers().is_empty())
    }
}

/// The elements of crankshaft `index`: nose, journals, pins and flange, webs, counterweights.
pub(super) fn elements(engine: &Engine, index: usize) -> Result<Vec<Element>, CrankshaftError> {
    let all = engine.crank_elements(index)?;
    let mut elements = Vec::new();
    for own in all.iter().filter(|own| own.bar().is_some()) {
        let name = own.name();
        let kind = if own.throw().is_some() { SectionKind::Pin } else { SectionKind::Journal };
        let outline = own.outline().map_err(|source| shape(&name, source))?;
        let (throw, faces, density) = (own.throw(), own.faces, own.density);
        elements.push(Element { name, kind, throw, faces, outline, density, part: None });
    }
    let parts: Vec<(&str, &CounterweightPart)> = engine
        .counterweights
        .iter()
        .filter(|weight| weight.crankshaft == index)
        .filter_map(|weight| Some((weight.name.as_str(), weight.part.as_deref()?)))
        .collect();
    for own in &all {
        let CrankElementForm::Web { web, .. } = own.form else { continue };
        let is_given =
            |part: &CounterweightPart| part.web == Some(web) && part.form == CounterweightForm::Web;
        if parts.iter().any(|(_, part)| is_given(part)) {
            continue;
        }
        let name = own.name();
        // Turned from the frame of its throw: exact where the throw stands along an axis.
        let plain = engine.plain_web(web).map_err(|source| shape(&name, source))?;
        let Some(plain) = plain else { continue };
        elements.push(Element {
            kind: SectionKind::Web,
            throw: own.throw(),
            faces: own.faces,
            outline: plain.outline,
            density: own.density,
            part: None,
            name,
        });
    }
    for (name, part) in parts {
        let is_web = part.form == CounterweightForm::Web;
        let [front, rear] = part.part.faces();
        elements.push(Element {
            name: name.to_owned(),
            kind: if is_web { SectionKind::Web } else { SectionKind::Counterweight },
            throw: part.web.map(|web| web / 2),
            faces: [part.z + front, part.z + rear],
            outline: part.part.outline().turned(part.angle),
            density: part.part.density(),
            part: Some((part.part.clone(), part.angle)),
        });
    }
    Ok(elements)
}

pub(super) fn shape(what: &str, source: GeometryError) -> CrankshaftError {
    CrankshaftError::Shape { what: what.to_owned(), source }
}
