//! What a crankshaft is made of: journals, pins, webs and counterweights, each a plate in the frame of the crankshaft.

use super::CrankshaftError;
use lanchester_model::{CounterweightForm, CounterweightPart, CrankBody, Engine, Throw};
use lanchester_shape::{Contour, GeometryError, Insert, MassMoments, Outline, Part, Point};
use serde::Serialize;

/// What a piece of a crankshaft is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SectionKind {
    /// A main journal.
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

/// The elements of crankshaft `index`: journals and pins, webs, counterweights.
pub(super) fn elements(engine: &Engine, index: usize) -> Result<Vec<Element>, CrankshaftError> {
    let count = engine.crankshafts.len();
    if index >= count {
        return Err(CrankshaftError::NoCrankshaft { index, count });
    }
    let body = engine.crank_body.as_ref().ok_or(CrankshaftError::NoBody)?;
    let mut throws = Vec::new();
    for (number, throw) in engine.throws.iter().enumerate().filter(|(_, throw)| throw.crankshaft == index) {
        let planes = throw.webs.ok_or(CrankshaftError::NoWebs { throw: number })?;
        throws.push((number, throw, planes));
    }
    throws.sort_by(|a, b| (a.2[0] + a.2[1]).total_cmp(&(b.2[0] + b.2[1])));
    if throws.is_empty() {
        return Err(CrankshaftError::NoThrow { index });
    }
    let mut elements = shafts(body, &throws)?;
    let parts: Vec<(&str, &CounterweightPart)> = engine
        .counterweights
        .iter()
        .filter(|weight| weight.crankshaft == index)
        .filter_map(|weight| Some((weight.name.as_str(), weight.part.as_deref()?)))
        .collect();
    for (number, _, _) in &throws {
        for web in [2 * number, 2 * number + 1] {
            let is_given =
                |part: &CounterweightPart| part.web == Some(web) && part.form == CounterweightForm::Web;
            if parts.iter().any(|(_, part)| is_given(part)) {
                continue;
            }
            let name = format!("web {}", web + 1);
            let Some(plain) = engine.plain_web(web).map_err(|source| shape(&name, source))? else { continue };
            elements.push(Element {
                kind: SectionKind::Web,
                throw: Some(*number),
                faces: plain.faces,
                outline: plain.outline,
                density: body.density,
                part: None,
                name,
            });
        }
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

/// Journals and pins: what is between the webs, and the two ends.
fn shafts(body: &CrankBody, throws: &[(usize, &Throw, [f64; 2])]) -> Result<Vec<Element>, CrankshaftError> {
    let half = body.web_thickness / 2.0;
    let mut elements = Vec::new();
    let mut front = throws[0].2[0] - half - body.end_journals[0];
    let mut journals = 0;
    let mut journal = |from: f64, to: f64| -> Result<Option<Element>, CrankshaftError> {
        // Webs that touch have no journal between them; neither has a crank without a journal at its end.
        if to - from <= 1e-9 {
            return Ok(None);
        }
        journals += 1;
        let name = format!("journal {journals}");
        let outline = tube(Point::ORIGIN, body.journal_diameter, body.journal_bore)
            .map_err(|source| shape(&name, source))?;
        let (kind, density) = (SectionKind::Journal, body.density);
        Ok(Some(Element { name, kind, throw: None, faces: [from, to], outline, density, part: None }))
    };
    for (number, throw, planes) in throws {
        elements.extend(journal(front, planes[0] - half)?);
        front = planes[1] + half;
        let faces = [planes[0] + half, planes[1] - half];
        let length = faces[1] - faces[0];
        if length.is_nan() || length <= 0.0 {
            return Err(CrankshaftError::NoPin { throw: *number, length });
        }
        let name = format!("pin {}", number + 1);
        let outline = tube(Point::polar(throw.radius, throw.angle), body.pin_diameter, body.pin_bore)
            .map_err(|source| shape(&name, source))?;
        let (kind, throw, density) = (SectionKind::Pin, Some(*number), body.density);
        elements.push(Element { name, kind, throw, faces, outline, density, part: None });
    }
    elements.extend(journal(front, front + body.end_journals[1])?);
    Ok(elements)
}

/// A round bar with a bore along its middle.
fn tube(centre: Point, diameter: f64, bore: f64) -> Result<Outline, GeometryError> {
    let hole = if bore > 0.0 { vec![Contour::circle(centre, bore / 2.0)?] } else { Vec::new() };
    Outline::new(Contour::circle(centre, diameter / 2.0)?, hole)
}

pub(super) fn shape(what: &str, source: GeometryError) -> CrankshaftError {
    CrankshaftError::Shape { what: what.to_owned(), source }
}
