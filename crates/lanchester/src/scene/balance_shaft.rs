//! Balance shafts: their weights as parts where the file gives shapes, else as half discs, and the bar through them.

use super::mesh::SceneMesh;
use super::mesh::rounded;
use super::{Builder, SceneKind, SceneMotion, part};
use lanchester_geometry::{Contour, Corner, Outline, Point};
use lanchester_model::{BalanceShaft, ShaftWeight};

/// Density for which half discs are as large as they are [kg/m^3]: steel.
const STEEL: f64 = 7850.0;
/// Length of a half disc, in radii.
const LENGTH: f64 = 1.2;

impl Builder<'_> {
    /// The weights of shaft `index` and its bar.
    pub(super) fn balance_shaft(&mut self, index: usize) {
        let shaft = &self.engine.shafts[index];
        let crank = self.engine.throws.iter().fold(0.0f64, |most, throw| most.max(throw.radius));
        let turn = |z: f64, angle: f64| SceneMotion::Turn {
            x: rounded(shaft.x),
            y: rounded(shaft.y),
            z: rounded(z),
            angle: rounded(angle),
            ratio: shaft.ratio.value(),
        };
        let given = shaft.weights.iter().filter_map(|weight| weight.part);
        let radius = given.map(|part| part.shape.shaft_radius).reduce(f64::min).unwrap_or(0.2 * crank);
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        for (number, weight) in shaft.weights.iter().enumerate() {
            let (outline, length) = match &weight.part {
                Some(part) => (part.shape.outline().ok(), part.length),
                None => half_disc(weight, room(shaft, number), crank),
            };
            ends = [ends[0].min(weight.z - length / 2.0), ends[1].max(weight.z + length / 2.0)];
            if weight.unbalance <= 0.0 {
                continue;
            }
            let mesh =
                outline.and_then(|outline| SceneMesh::plate(&outline, length, 0.0, self.meshes.facet_error));
            let name = match weight.part {
                Some(_) => shaft.weight_name(number),
                None => format!("{} (symbolic)", shaft.weight_name(number)),
            };
            let path = format!("shaft[{index}].weights[{number}].unbalance");
            self.add(mesh, part(name, SceneKind::ShaftWeight, path, turn(weight.z, weight.phase)));
        }
        let [from, to] = if shaft.weights.is_empty() { [-crank, crank] } else { ends };
        let (from, to) = (from - 0.3 * crank, to + 0.3 * crank);
        let bar = Contour::circle(Point::ORIGIN, radius).ok();
        let mesh = bar.and_then(|bar| SceneMesh::plate(&bar.into(), to - from, 0.0, self.meshes.facet_error));
        let path = format!("shaft[{index}].ratio");
        self.add(mesh, part(shaft.name.clone(), SceneKind::Shaft, path, turn((from + to) / 2.0, 0.0)));
    }
}

/// How long a weight may be without touching its neighbours [m].
fn room(shaft: &BalanceShaft, index: usize) -> f64 {
    let z = shaft.weights[index].z;
    let gaps = shaft.weights.iter().map(|other| (other.z - z).abs()).filter(|gap| *gap > 1e-6);
    0.9 * gaps.fold(f64::INFINITY, f64::min)
}

/// A half disc of steel with the unbalance of the weight, and its length [m], of a size that can be drawn.
///
/// ```text
/// U = (2/3) rho L R^3
/// ```
fn half_disc(weight: &ShaftWeight, room: f64, crank: f64) -> (Option<Outline>, f64) {
    let usual = (1.5 * weight.unbalance / (STEEL * LENGTH)).powf(0.25);
    let length = (LENGTH * usual).clamp(0.2 * crank, 1.6 * crank).min(room);
    let radius = (1.5 * weight.unbalance / (STEEL * length)).cbrt().clamp(0.25 * crank, 1.3 * crank);
    let corners = [
        Corner { at: Point::new(0.0, -radius), bulge: 1.0 },
        Corner { at: Point::new(0.0, radius), bulge: 0.0 },
    ];
    let outline = Contour::new(&corners).and_then(|contour| Outline::new(contour, Vec::new()));
    (outline.ok(), length)
}
