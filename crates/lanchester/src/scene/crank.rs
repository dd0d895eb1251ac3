//! Crankshafts: journals, pins, webs and counterweights.

use super::mesh::SceneMesh;
use super::mesh::rounded;
use super::{Builder, SceneKind, SceneMotion, ScenePart, part, symbolic};
use lanchester_geometry::crankshaft::{CrankshaftPiece, SectionKind, crankshaft_pieces};
use lanchester_geometry::export::PlacedPart;
use lanchester_geometry::{Part, Point};
use lanchester_model::{Counterweight, CrankBody, Engine};

impl Builder<'_> {
    /// The pieces of crankshaft `index`.
    pub(super) fn crankshaft(&mut self, index: usize) {
        let given =
            self.engine.crank_body.is_some().then(|| crankshaft_pieces(self.engine, index).ok()).flatten();
        let plausible = |builder: &Self| {
            let drawn = builder.proportions.with_body(builder.engine, index);
            let pieces = crankshaft_pieces(&drawn, index).unwrap_or_default();
            (drawn, pieces)
        };
        let has_body = given.is_some();
        let (drawn, pieces) = match given {
            Some(pieces) => (self.engine.clone(), pieces),
            None => plausible(self),
        };
        for piece in pieces {
            self.piece(index, piece, has_body);
        }
        if let Some(body) = drawn.crank_body {
            self.point_weights(index, &drawn, &body);
        }
    }

    fn piece(&mut self, index: usize, piece: CrankshaftPiece, has_body: bool) {
        let CrankshaftPiece { kind, throw, weight, placed } = piece;
        let (kind, path) = match (kind, has_body) {
            (SectionKind::Journal, true) => (SceneKind::Journal, "crank.body.journal_diameter"),
            (SectionKind::Journal, false) => (SceneKind::Journal, "layout.spacing"),
            (SectionKind::Pin, true) => (SceneKind::Crankpin, "crank.body.pin_diameter"),
            (SectionKind::Pin, false) => (SceneKind::Crankpin, "crank.stroke"),
            (SectionKind::Web, true) if weight.is_none() => (SceneKind::Web, "crank.body.web_thickness"),
            (SectionKind::Web, false) if weight.is_none() => (SceneKind::Web, "crank.web_mass"),
            (SectionKind::Web | SectionKind::Counterweight, _) => (SceneKind::Counterweight, "counterweight"),
        };
        // In the directions of its throw equal pieces have one shape.
        let own = throw.filter(|_| weight.is_none()).map_or(0.0, |throw| self.engine.throws[throw].angle);
        let Some((solid, turn)) = unturned(&placed, own) else { return };
        let z = placed.z + middle(&placed.part);
        let mesh = SceneMesh::of(&[solid], self.meshes.facet_error);
        let name = if weight.is_some() { weight_name(&placed.name) } else { placed.name.clone() };
        let motion = self.on_crankshaft(index, turn, z);
        self.add(mesh, ScenePart { weight, ..part(self.named(index, name), kind, path, motion) });
    }

    /// A frame on the axis of crankshaft `index` at the plane `z` [m], turned by `angle` on it [rad].
    pub(super) fn on_crankshaft(&self, index: usize, angle: f64, z: f64) -> SceneMotion {
        let crankshaft = &self.engine.crankshafts[index];
        SceneMotion::Turn {
            x: rounded(crankshaft.x),
            y: rounded(crankshaft.y),
            z: rounded(z),
            angle: rounded(crankshaft.phase + angle),
            ratio: crankshaft.ratio.value(),
        }
    }

    /// A name that says the crankshaft where there are several.
    pub(super) fn named(&self, index: usize, name: String) -> String {
        if self.engine.crankshafts.len() == 1 {
            name
        } else {
            format!("{name}, {}", self.engine.crankshafts[index].name)
        }
    }

    /// Weights that the file gives by number alone.
    fn point_weights(&mut self, index: usize, drawn: &Engine, body: &CrankBody) {
        let is_point = |weight: &Counterweight| {
            weight.crankshaft == index && weight.part.is_none() && weight.unbalance > 0.0
        };
        let thickness = body.web_thickness;
        let shares: Vec<(usize, f64, Vec<f64>)> = (0..self.engine.counterweights.len())
            .filter(|number| is_point(&self.engine.counterweights[*number]))
            .map(|number| {
                let weight = &self.engine.counterweights[number];
                let planes = symbolic::planes(drawn, index, weight.z, thickness);
                (number, weight.unbalance / planes.len() as f64, planes)
            })
            .collect();
        let largest = shares.iter().fold(0.0f64, |most, (_, share, _)| most.max(*share));
        let sectors = symbolic::Sectors::new(body, self.room_below(index), largest);
        for (number, share, planes) in shares {
            let weight = &self.engine.counterweights[number];
            let outline = sectors.outline(share);
            let mesh = outline
                .and_then(|outline| SceneMesh::plate(&outline, thickness, 0.0, self.meshes.facet_error));
            let name = self.named(index, format!("{} (symbolic)", weight_name(&weight.name)));
            for z in planes {
                let motion = self.on_crankshaft(index, weight.angle, z);
                let new = part(name.clone(), SceneKind::Counterweight, "counterweight", motion);
                self.add(mesh.clone(), ScenePart { weight: Some(number), ..new });
            }
        }
    }
}

/// The name of a weight that says what it is.
fn weight_name(name: &str) -> String {
    if name.contains("weight") { name.to_owned() } else { format!("counterweight {name}") }
}

/// A solid with its middle in the plane z = 0 and turned back by its own turn and by `turn` [rad], and both together.
fn unturned(placed: &PlacedPart, turn: f64) -> Option<(PlacedPart, f64)> {
    let part = &placed.part;
    let whole = placed.turn + turn;
    if turn == 0.0 {
        let solid = PlacedPart::new(placed.name.clone(), part.clone()).moved(-middle(part));
        return Some((solid, whole));
    }
    let outline = part.outline().turned(-turn);
    let mut own = Part::new(outline, part.thickness(), part.density()).ok()?;
    for insert in part.inserts() {
        let centre: Point = insert.centre.turned(-turn);
        own = own.with_insert(lanchester_geometry::Insert { centre, ..*insert }).ok()?;
    }
    Some((PlacedPart::new(placed.name.clone(), own), whole))
}

/// The plane in the middle of a part [m].
fn middle(part: &Part) -> f64 {
    (part.faces()[0] + part.faces()[1]) / 2.0
}
