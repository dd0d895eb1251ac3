//! Plausible sizes of what an engine file does not say, in shares of bore and crank radius as engines have them.

use lanchester_model::{CrankBody, Engine, Throw};

/// Same plane, line or direction: closer than this [m or rad].
const SAME: f64 = 1e-6;

/// Sizes that are drawn, from the file where it says them.
#[derive(Debug, Clone)]
pub(super) struct Proportions {
    /// Bore of each cylinder [m].
    pub bores: Vec<f64>,
    /// Half of the width along the crank of each rod's big end [m].
    pub rod_half_widths: Vec<f64>,
    /// Radius of the crankpins [m].
    pub pin_radius: f64,
    /// Radius of the main journals [m].
    pub journal_radius: f64,
}

/// How far chords may be from their arcs [m]: about thirty facets for a pin.
pub(super) fn facet_error(engine: &Engine) -> f64 {
    0.003 * engine.throws.iter().fold(0.0f64, |most, throw| most.max(throw.radius))
}

impl Proportions {
    pub fn of(engine: &Engine) -> Proportions {
        let bores: Vec<f64> = (0..engine.cylinders.len()).map(|index| bore(engine, index)).collect();
        let least_bore = bores.iter().copied().fold(f64::INFINITY, f64::min);
        let least_radius = engine.throws.iter().fold(f64::INFINITY, |least, throw| least.min(throw.radius));
        let given = |bearing: Option<lanchester_model::PlainBearing>| {
            bearing.and_then(|bearing| bearing.diameter).map(|diameter| diameter / 2.0)
        };
        let bearings = engine.bearings.unwrap_or_default();
        let (pin_radius, journal_radius) = match &engine.crank_body {
            Some(body) => (body.pin_diameter / 2.0, body.journal_diameter / 2.0),
            None => (
                given(bearings.crankpin).unwrap_or((0.29 * least_bore).min(0.62 * least_radius)),
                given(bearings.main).unwrap_or((0.33 * least_bore).min(0.75 * least_radius)),
            ),
        };
        let rod_half_widths =
            (0..bores.len()).map(|index| rod_half_width(engine, index, bores[index])).collect();
        Proportions { bores, rod_half_widths, pin_radius, journal_radius }
    }

    /// Half of the length of a pin that holds its rods [m].
    pub fn half_pin(&self, engine: &Engine, throw: usize) -> f64 {
        let z = engine.throws[throw].z;
        let riders = engine.cylinders.iter().zip(&self.rod_half_widths).filter(|(own, _)| own.throw == throw);
        let reach = riders.map(|(cylinder, half)| (cylinder.z - z).abs() + half).fold(0.0, f64::max);
        1.05 * reach.max(0.3 * self.pin_radius)
    }

    /// Crankshaft `index` of an engine whose file gives no body for it: with a body, and with planes of webs where the
    /// file gives none.
    pub fn with_body(&self, engine: &Engine, index: usize) -> Engine {
        let mut drawn = engine.clone().into_parts();
        let mains = engine.main_planes(index);
        let own: Vec<usize> =
            (0..engine.throws.len()).filter(|&throw| engine.throws[throw].crankshaft == index).collect();
        let bore = self.bores.iter().copied().fold(f64::INFINITY, f64::min);
        // Half of the pin and what is left for a web, throw by throw.
        let halves: Vec<f64> =
            own.iter().map(|&throw| self.half_pin_between(engine, throw, &mains)).collect();
        let room = own.iter().zip(&halves).map(|(&throw, half)| match engine.throws[throw].webs {
            Some([front, rear]) => {
                (rear - front - 2.0 * half).clamp(0.25 * (rear - front), 0.45 * (rear - front))
            }
            None => 0.7 * (distance_to_mains(&engine.throws[throw], &mains) - half),
        });
        let thickness = room.fold(0.21 * bore, f64::min).max(0.02 * bore);
        for (&throw, half) in own.iter().zip(&halves) {
            let throw = &mut drawn.throws[throw];
            let reach = half + thickness / 2.0;
            throw.webs.get_or_insert([throw.z - reach, throw.z + reach]);
        }
        let webs = own.iter().filter_map(|&throw| drawn.throws[throw].webs);
        let (front, rear) = webs.fold((f64::INFINITY, f64::NEG_INFINITY), |(front, rear), webs| {
            (front.min(webs[0] - thickness / 2.0), rear.max(webs[1] + thickness / 2.0))
        });
        // The outermost mains stand in the middle of the end journals.
        let least = 0.3 * self.journal_radius;
        let ends = match (mains.first(), mains.last()) {
            (Some(first), Some(last)) => [2.0 * (front - first), 2.0 * (last - rear)],
            _ => [least; 2],
        };
        drawn.crank_body = Some(CrankBody {
            density: 7850.0,
            journal_diameter: 2.0 * self.journal_radius,
            journal_bore: 0.0,
            pin_diameter: 2.0 * self.pin_radius,
            pin_bore: 0.0,
            web_thickness: thickness,
            web_radius: 1.14 * self.journal_radius,
            pin_end_radius: 1.26 * self.pin_radius,
            end_journals: ends.map(|length| length.max(least)),
        });
        Engine::new(drawn).expect("invariant: the proportions of an engine that turns are positive")
    }

    /// Half of a pin, no longer than its neighbours and mains leave it.
    fn half_pin_between(&self, engine: &Engine, index: usize, mains: &[f64]) -> f64 {
        let throw = &engine.throws[index];
        let beside =
            |other: &&Throw| other.crankshaft == throw.crankshaft && (other.z - throw.z).abs() > SAME;
        let gaps = engine.throws.iter().filter(beside).map(|other| (other.z - throw.z).abs());
        let most = gaps.fold(f64::INFINITY, f64::min) * 0.44;
        self.half_pin(engine, index).min(most).min(0.55 * distance_to_mains(throw, mains))
    }
}

/// From the plane of a throw to the nearest main [m].
fn distance_to_mains(throw: &Throw, mains: &[f64]) -> f64 {
    let distance = mains.iter().map(|z| (z - throw.z).abs()).filter(|distance| *distance > SAME);
    distance.fold(1.25 * throw.radius, f64::min)
}

fn bore(engine: &Engine, index: usize) -> f64 {
    let own = &engine.cylinders[index];
    let beside = |other: &&lanchester_model::Cylinder| {
        engine.throws[other.throw].crankshaft == engine.throws[own.throw].crankshaft
            && (other.angle - own.angle).abs() < SAME
            && (other.z - own.z).hypot(other.offset - own.offset) > SAME
    };
    let gaps = engine.cylinders.iter().filter(beside);
    let gap =
        gaps.map(|other| (other.z - own.z).hypot(other.offset - own.offset)).fold(f64::INFINITY, f64::min);
    own.bore.unwrap_or((1.8 * engine.throws[own.throw].radius).min(0.92 * gap))
}

/// Rods beside each other on one pin share it; those in one plane are forks and blades, or joined to a master.
fn rod_half_width(engine: &Engine, index: usize, bore: f64) -> f64 {
    let own = &engine.cylinders[index];
    let beside = engine.cylinders.iter().filter(|other| other.throw == own.throw);
    let gaps = beside.map(|other| (other.z - own.z).abs()).filter(|gap| *gap > 0.02 * bore);
    let width = engine.envelope.and_then(|envelope| envelope.rod).map(|rod| rod.big_end_width);
    width.map_or(0.13 * bore, |width| width / 2.0).min(gaps.fold(f64::INFINITY, f64::min) * 0.47)
}
