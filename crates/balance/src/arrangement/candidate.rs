//! Which arrangements are worth examining: enumeration, pruned by what the engine leaves.

use crate::BalanceError;
use crate::arrangement::request::{ArrangementRequest, CrankWeights, Judged};
use crate::arrangement::result::ShaftLayout;
use crate::arrangement::spacing::extent;
use lanchester_mechanism::{LoadRequest, Mechanism};
use lanchester_model::{Engine, Ratio};
use lanchester_task::{BalanceTask, Criterion, FreeShaft, FreeWeight, Load, Place, Seat, Stage, Tie};
use num_complex::Complex64;

/// Below this share of all moving masses at their largest acceleration an order is not there.
const ABSENT: f64 = 1e-6;

/// Planes closer than this are one [m].
const SAME_PLANE: f64 = 1e-9;

/// What turns at one order in one sense.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Component {
    /// Speed over that of crankshaft 1: the order with the sign of its sense.
    pub ratio: i32,
    /// Force [N] at `theta = 0`; 0 where there is none to speak of.
    pub force: Complex64,
    /// Couple [N m] at `theta = 0`; 0 where there is none to speak of.
    pub couple: Complex64,
}

/// Force [N] of all moving masses at their crank's acceleration, and its couple [N m] at the engine's largest lever.
pub(crate) fn load_scale(engine: &Engine) -> [f64; 2] {
    let unbalance: f64 = (engine.cylinders.iter())
        .map(|c| (c.reciprocating_mass() + c.rod.big_end_mass) * engine.throws[c.throw].radius)
        .sum();
    let force = unbalance * engine.speed.highest * engine.speed.highest;
    let reach = engine.cylinders.iter().map(|c| c.z.abs() + engine.throws[c.throw].radius);
    [force, force * reach.fold(0.0, f64::max)]
}

/// The components of the orders asked for, absent ones as 0.
pub(crate) fn components(engine: &Engine, orders: &[u32]) -> Result<Vec<Component>, BalanceError> {
    let request = LoadRequest { max_order: 2, ..LoadRequest::default() };
    let by_order = Mechanism::new(engine, &request)?.orders();
    let [force_scale, couple_scale] = load_scale(engine);
    let present = |value: Complex64, scale: f64| {
        if value.norm() > ABSENT * scale { value } else { Complex64::ZERO }
    };
    let mut out = Vec::with_capacity(2 * orders.len());
    for &order in orders {
        let Some(loads) = by_order.iter().find(|o| o.order == f64::from(order)) else { continue };
        for (ratio, force, couple) in [
            (order as i32, loads.force_forward, loads.couple_forward),
            (-(order as i32), loads.force_backward, loads.couple_backward),
        ] {
            let (force, couple) = (present(force, force_scale), present(couple, couple_scale));
            out.push(Component { ratio, force, couple });
        }
    }
    Ok(out)
}

/// A balance shaft that an arrangement may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlannedShaft {
    /// Speed over that of crankshaft 1, signed.
    pub ratio: i32,
    /// Its weights.
    pub layout: ShaftLayout,
}

/// Crank weights or none, with some shafts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Candidate {
    /// Whether the crank gets weights.
    pub crank: bool,
    /// Its shafts, by rising order, with the crank first.
    pub shafts: Vec<PlannedShaft>,
}

impl Candidate {
    /// Whether it has all that `other` has. Crank weights do what a first-order shaft with the crank does.
    pub fn contains(&self, other: &Candidate) -> bool {
        let covers = |ratio: i32| self.shafts.iter().any(|s| s.ratio == ratio) || (ratio == 1 && self.crank);
        (self.crank || !other.crank) && other.shafts.iter().all(|s| covers(s.ratio))
    }

    /// In words.
    pub fn name(&self) -> String {
        let mut parts = Vec::new();
        if self.crank {
            parts.push("crank weights".to_owned());
        }
        for (order, word) in [(1, "first"), (2, "second")] {
            let of_order: Vec<&PlannedShaft> =
                self.shafts.iter().filter(|s| s.ratio.abs() == order).collect();
            let double = |s: &PlannedShaft| match s.layout {
                ShaftLayout::Single { .. } => "",
                ShaftLayout::Double { .. } => "double ",
                ShaftLayout::TwoPlanes { .. } => "two-plane ",
            };
            match of_order[..] {
                [a, b] if double(a) == double(b) => {
                    parts.push(format!("two {word}-order {}shafts, with and against", double(a)));
                }
                _ => parts.extend(of_order.iter().map(|s| {
                    let sense = if s.ratio > 0 { "with" } else { "against" };
                    format!("one {word}-order {}shaft {sense}", double(s))
                })),
            }
        }
        if parts.is_empty() { "nothing added".to_owned() } else { parts.join(", ") }
    }

    /// In short: "crank -1 +2".
    pub fn label(&self) -> String {
        let crank = self.crank.then(|| "crank".to_owned());
        let parts: Vec<String> =
            crank.into_iter().chain(self.shafts.iter().map(|s| format!("{:+}", s.ratio))).collect();
        if parts.is_empty() { "nothing".to_owned() } else { parts.join(" ") }
    }

    /// Name of shaft `index`: "shaft +1".
    pub fn shaft_name(&self, index: usize) -> String {
        format!("shaft {:+}", self.shafts[index].ratio)
    }
}

/// All arrangements worth examining, by rising number of shafts, and what was left out.
pub(crate) fn candidates(
    engine: &Engine,
    request: &ArrangementRequest,
    components: &[Component],
) -> (Vec<Candidate>, Vec<String>) {
    let mut left_out = Vec::new();
    let judged = |c: &Component| match request.criterion {
        Judged::Force => c.force != Complex64::ZERO,
        Judged::Couple => c.couple != Complex64::ZERO,
        Judged::MountForce => c.force != Complex64::ZERO || c.couple != Complex64::ZERO,
    };
    let mut shafts = Vec::new();
    for component in components {
        let (order, sense) = (component.ratio.abs(), if component.ratio > 0 { "with" } else { "against" });
        if !judged(component) {
            left_out.push(format!(
                "shafts of order {order} {sense} the crank: nothing of that order turns {sense} the crank"
            ));
            continue;
        }
        shafts.push(PlannedShaft { ratio: component.ratio, layout: layout(engine, request, component) });
    }
    let crank_allowed = !crank_planes(engine, request).is_empty();
    let forward = components.iter().find(|c| c.ratio == 1).copied();
    let crank_useful = match forward {
        Some(component) => judged(&component),
        // First-order shafts are not asked for, but crank weights may be.
        None => true,
    };
    if crank_allowed && !crank_useful {
        left_out.push("crank weights: nothing of first order turns with the crank".to_owned());
    }
    let mut out = Vec::new();
    for crank in [false, true] {
        if crank && !(crank_allowed && crank_useful) {
            continue;
        }
        let free: Vec<PlannedShaft> = shafts.iter().copied().filter(|s| !(crank && s.ratio == 1)).collect();
        for choice in 0u32..1 << free.len() {
            let shafts: Vec<PlannedShaft> =
                (0..free.len()).filter(|k| choice >> k & 1 == 1).map(|k| free[k]).collect();
            if shafts.len() <= request.most_shafts {
                out.push(Candidate { crank, shafts });
            }
        }
    }
    out.sort_by_key(|c| (c.shafts.len(), c.crank));
    (out, left_out)
}

/// Weights that answer a component.
fn layout(engine: &Engine, request: &ArrangementRequest, component: &Component) -> ShaftLayout {
    let planes = || request.shaft_planes.unwrap_or_else(|| shaft_planes(engine));
    let couple_only = component.force == Complex64::ZERO || request.criterion == Judged::Couple;
    if couple_only {
        return ShaftLayout::Double { z: planes() };
    }
    if component.couple == Complex64::ZERO {
        return ShaftLayout::Single { z: 0.0 };
    }
    // couple = i z force: one weight does for both where the quotient is real.
    let centre = component.couple / (Complex64::I * component.force);
    if request.criterion == Judged::Force || centre.im.abs() < 1e-6 * centre.norm() {
        ShaftLayout::Single { z: centre.re }
    } else {
        ShaftLayout::TwoPlanes { z: planes() }
    }
}

/// The outermost cylinder planes; where all cylinders stand in one plane, half the crank radius to both sides.
fn shaft_planes(engine: &Engine) -> [f64; 2] {
    let [front, rear] = extent(engine.cylinders.iter().map(|c| c.z));
    let radius = engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius));
    if rear - front > 1e-6 * radius { [front, rear] } else { [front - 0.5 * radius, rear + 0.5 * radius] }
}

/// Planes of the crank weights [m].
fn crank_planes(engine: &Engine, request: &ArrangementRequest) -> Vec<f64> {
    let throws = engine.throws.iter().filter(|t| t.crankshaft == 0).map(|t| t.z);
    match &request.crank {
        CrankWeights::None => Vec::new(),
        CrankWeights::Planes(planes) => planes.clone(),
        CrankWeights::OuterThrows => {
            let [front, rear] = extent(throws);
            if rear - front > SAME_PLANE { vec![front, rear] } else { vec![front] }
        }
        CrankWeights::Throws => {
            let mut planes: Vec<f64> = throws.collect();
            planes.sort_by(f64::total_cmp);
            planes.dedup_by(|a, b| (*a - *b).abs() < SAME_PLANE);
            planes
        }
    }
}

/// Crank weights of an arrangement are called this and a number.
const CRANK_WEIGHT: &str = "crank weight ";

/// Whether a counterweight has the name of one that a search adds: then a search put it into the file.
pub(crate) fn is_searched(name: &str) -> bool {
    name.strip_prefix(CRANK_WEIGHT)
        .is_some_and(|number| !number.is_empty() && number.chars().all(|c| c.is_ascii_digit()))
}

/// The task of balancing `engine` with the devices of `candidate`; shafts at `places` (on the crank axis where they
/// have no place yet).
pub(crate) fn task(
    engine: &Engine,
    request: &ArrangementRequest,
    candidate: &Candidate,
    places: &[Complex64],
) -> BalanceTask {
    let mut task = BalanceTask { limits: request.limits.clone(), ..BalanceTask::default() };
    let weight = |name: String, seat: Seat, z: f64| FreeWeight::new(name, seat, Place::At(z));
    if candidate.crank {
        for (index, z) in crank_planes(engine, request).into_iter().enumerate() {
            task.weights.push(weight(format!("{CRANK_WEIGHT}{}", index + 1), Seat::Crankshaft(0), z));
        }
    }
    for (index, shaft) in candidate.shafts.iter().enumerate() {
        let place = places.get(index).copied().unwrap_or_default();
        let name = candidate.shaft_name(index);
        task.shafts.push(FreeShaft {
            name: name.clone(),
            ratio: Ratio::whole(shaft.ratio).expect("invariant: a shaft turns at order 1 or 2"),
            x: Place::At(place.re),
            y: Place::At(place.im),
            optional: false,
        });
        match shaft.layout {
            ShaftLayout::Single { z } => task.weights.push(weight(name, Seat::Shaft(index), z)),
            ShaftLayout::Double { z } | ShaftLayout::TwoPlanes { z } => {
                let first = task.weights.len();
                for (end, z) in ["front", "rear"].into_iter().zip(z) {
                    task.weights.push(weight(format!("{name} {end}"), Seat::Shaft(index), z));
                }
                if matches!(shaft.layout, ShaftLayout::Double { .. }) {
                    task.ties.push(Tie { first, second: first + 1, factor: -1.0, mirrored: false });
                }
            }
        }
    }
    let stage = |criterion| Stage { terms: vec![(1.0, criterion)] };
    task.stages.push(stage(request.criterion.criterion()));
    if task.weights.len() > 1 || !request.limits.is_empty() {
        // What the criterion does not see must not grow for nothing.
        match request.criterion {
            Judged::Force => task.stages.push(stage(Criterion::Peak(Load::Couple))),
            Judged::Couple => task.stages.push(stage(Criterion::Peak(Load::Force))),
            Judged::MountForce => {}
        }
    }
    if !task.weights.is_empty() {
        task.stages.push(stage(Criterion::AddedUnbalance));
    }
    task
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arrangement::sample::{in_line, twin};

    fn found(engine: &Engine, request: &ArrangementRequest) -> Vec<Candidate> {
        let components = components(engine, &request.shaft_orders).unwrap();
        candidates(engine, request, &components).0
    }

    #[test]
    fn a_twin_in_step_has_four_orders_and_senses() {
        // 2^4 sets of shafts without crank weights, 2^3 with them.
        let found = found(&twin(), &ArrangementRequest::default());
        assert_eq!(found.len(), 24);
        assert!(found.windows(2).all(|w| w[0].shafts.len() <= w[1].shafts.len()));
        assert_eq!(found[0].name(), "nothing added");
        assert_eq!((found[0].label().as_str(), found[23].label().as_str()), ("nothing", "+1 -1 +2 -2"));
        assert!(found.iter().any(|c| c.label() == "crank -1"));
    }

    #[test]
    fn orders_that_the_engine_lacks_get_no_shaft() {
        // An in-line four in its usual order: second-order force alone, no couple.
        let four = in_line(&[0.0, 180.0, 180.0, 0.0]);
        let found_force = found(&four, &ArrangementRequest::default());
        assert_eq!(found_force.len(), 4, "{found_force:?}");
        assert!(found_force.iter().all(|c| !c.crank && c.shafts.iter().all(|s| s.ratio.abs() == 2)));
        let couple = ArrangementRequest { criterion: Judged::Couple, ..ArrangementRequest::default() };
        assert_eq!(found(&four, &couple).len(), 1);
    }

    #[test]
    fn a_couple_gets_double_shafts_and_a_force_single_ones() {
        let request = ArrangementRequest { criterion: Judged::MountForce, ..ArrangementRequest::default() };
        let found = found(&in_line(&[0.0, 180.0]), &request);
        for shaft in found.iter().flat_map(|c| &c.shafts) {
            match shaft.ratio.abs() {
                1 => assert!(matches!(shaft.layout, ShaftLayout::Double { .. })),
                _ => assert_eq!(shaft.layout, ShaftLayout::Single { z: 0.0 }),
            }
        }
        let four = found.iter().find(|c| c.shafts.len() == 4).unwrap();
        assert_eq!(
            four.name(),
            "two first-order double shafts, with and against, two second-order shafts, with and against"
        );
    }

    #[test]
    fn crank_weights_stand_at_the_outer_throws_or_at_all() {
        let four = in_line(&[0.0, 180.0, 180.0, 0.0]);
        let planes = |crank| crank_planes(&four, &ArrangementRequest { crank, ..Default::default() });
        let (outer, all) = (planes(CrankWeights::OuterThrows), planes(CrankWeights::Throws));
        assert_eq!((outer.len(), all.len()), (2, 4));
        assert_eq!((outer[0], outer[1]), (all[0], all[3]));
        assert!(all.windows(2).all(|w| w[0] < w[1]) && planes(CrankWeights::None).is_empty());
    }

    #[test]
    fn fewest_shafts_are_kept_to() {
        let request = ArrangementRequest { most_shafts: 1, ..ArrangementRequest::default() };
        assert!(found(&twin(), &request).iter().all(|c| c.shafts.len() <= 1));
    }
}
