//! Circles that the bars of a crankshaft need about each centre.

use super::levels::GROWTH;
use super::segment::{Bar, TINY};
use lanchester_shape::Point;

/// Layers are no thicker than this share of the radius: what two circles have in common is narrow.
const LENS: f64 = 0.12;
/// Chords are no longer than this share of the radius.
const ROUND: f64 = 0.25;
/// Lines nearer to each other than this share of a layer are one line of the net; where each is a surface, it stands at its own place.
const NEAR: f64 = 0.5;

/// What a circle is to a bar; those that come first choose the place of a line that several share.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    Bore,
    /// The surface of a journal or pin.
    Surface,
    /// Where its fillet ends on the web.
    Edge,
    /// Between them.
    Layer,
}

/// A circle of the net.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ring {
    /// Radius in the net [m].
    pub radius: f64,
    pub rank: Rank,
    /// Radii that it stands for: its own, and those of other bars of this centre that are as good as equal [m].
    pub radii: Vec<f64>,
}

/// Circles about one centre: bars with the layers of their fillets, or their bores.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Rings {
    pub centre: Point,
    /// Rising.
    pub rings: Vec<Ring>,
    /// Length of the chords away from other circles [m].
    pub chord: f64,
    /// Thickness of the layers, and length of the chords by other circles [m].
    pub layer: f64,
    pub is_bore: bool,
}

impl Rings {
    /// Lines nearer than this are one [m].
    pub fn near(&self) -> f64 {
        NEAR * self.layer
    }

    /// Adds a radius, or gives it to a ring nearby.
    fn add(&mut self, radius: f64, rank: Rank) {
        let near = self.near();
        let off = |ring: &Ring| (ring.radius - radius).abs();
        match self.rings.iter_mut().min_by(|a, b| off(a).total_cmp(&off(b))) {
            Some(ring) if off(ring) < near => {
                if ring.radii.iter().all(|own| (own - radius).abs() > TINY) {
                    ring.radii.push(radius);
                }
            }
            _ => self.rings.push(Ring { radius, rank, radii: vec![radius] }),
        }
    }
}

/// Radii at which the layers of a fillet end.
pub(super) fn layer_radii(bar: f64, fillet: f64, layers: usize) -> impl Iterator<Item = f64> {
    let count = if fillet > 0.0 { layers } else { 0 };
    (1..=count).map(move |k| bar + fillet * k as f64 / layers as f64)
}

/// Radii within a bar at which layers below its surface end: as thick as those of its smallest fillet at the surface, growing after, to less than
/// the depth of the fillet's radius, where most of what it concentrates has faded.
fn inner_radii(bar: &Bar, fillet: f64, layers: usize) -> Vec<f64> {
    let (mut step, mut depth) = (fillet / layers as f64, 0.0);
    let mut radii = Vec::new();
    while depth + step < fillet - TINY && bar.radius - depth - step > bar.bore + step {
        depth += step;
        step *= GROWTH;
        radii.push(bar.radius - depth);
    }
    radii
}

/// Circles about each centre, but for steps of nose and flange, which have no lines of their own.
pub(super) fn rings(bars: &[Bar], layers: usize, size: f64) -> Vec<Rings> {
    let mut all: Vec<Rings> = Vec::new();
    let mut radii: Vec<Vec<(Rank, f64)>> = Vec::new();
    for bar in bars.iter().filter(|bar| !bar.is_end) {
        let mut add = |is_bore: bool, own: Vec<(Rank, f64)>, chord: f64, layer: f64| {
            let is_own =
                |rings: &Rings| rings.is_bore == is_bore && (rings.centre - bar.centre).norm() < TINY;
            let place = all.iter().position(is_own).unwrap_or_else(|| {
                all.push(Rings { centre: bar.centre, rings: Vec::new(), chord, layer, is_bore });
                radii.push(Vec::new());
                all.len() - 1
            });
            all[place].chord = all[place].chord.min(chord);
            all[place].layer = all[place].layer.min(layer);
            radii[place].extend(own);
        };
        let fillets = bar.fillets.iter().copied().filter(|fillet| *fillet > 0.0);
        let fillet = fillets.reduce(f64::min);
        let chord = fillet.map_or(size, |fillet| (1.6 * fillet).min(size)).min(ROUND * bar.radius);
        let layer = fillet.map_or(chord, |fillet| fillet / layers as f64).min(chord).min(LENS * bar.radius);
        let mut own = vec![(Rank::Surface, bar.radius)];
        for fillet in bar.fillets {
            let ends = layer_radii(bar.radius, fillet, layers).enumerate();
            own.extend(
                ends.map(|(k, radius)| (if k + 1 == layers { Rank::Edge } else { Rank::Layer }, radius)),
            );
        }
        if let Some(fillet) = fillet {
            own.extend(inner_radii(bar, fillet, layers).into_iter().map(|radius| (Rank::Layer, radius)));
        }
        add(false, own, chord, layer);
        if bar.bore > 0.0 {
            let chord = size.min(ROUND * bar.bore);
            add(true, vec![(Rank::Bore, bar.bore)], chord, chord.min(LENS * bar.bore));
        }
    }
    for (rings, mut radii) in all.iter_mut().zip(radii) {
        radii.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        for (rank, radius) in radii {
            rings.add(radius, rank);
        }
        rings.rings.sort_by(|a, b| a.radius.total_cmp(&b.radius));
    }
    all
}
