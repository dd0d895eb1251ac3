//! What the two-sided spectrum means, in words.
//!
//! A load matters above 0.1 % of a scale: forces are measured against the largest order of one cylinder's force,
//! couples against that force at the length of the crank, roll moments against it at the crank radius.

use crate::inertia::result::{CylinderLoads, Diagnosis, Finding, Quantity, Remedy, Sense};
use crate::wording::{adjective, amount, layout, ordinal, rpm, shaft_speed};
use lanchester_model::{BalanceShaft, Engine};
use lanchester_results::{LoadSet, OrderLoads};
use num_complex::Complex64;

/// Share of the scale below which a load is not worth a word.
const THRESHOLD: f64 = 1e-3;

/// Orders of the roll moment that its line names.
const MOST_ROLL_ORDERS: usize = 3;

/// What forces [N], couples [N m] and roll moments [N m] are measured against.
struct Scales {
    force: f64,
    couple: f64,
    roll: f64,
}

impl Scales {
    fn of(engine: &Engine, total: &LoadSet, cylinders: &[CylinderLoads]) -> Scales {
        let strongest = |set: &LoadSet| set.orders.iter().map(OrderLoads::force_peak).fold(0.0, f64::max);
        let single = cylinders.iter().map(|c| strongest(&c.loads)).fold(0.0, f64::max);
        let force = if single > 0.0 { single } else { strongest(total) };
        let radius = engine.throws.iter().map(|t| t.radius).fold(0.0, f64::max);
        Scales { force, couple: force * crank_length(engine).unwrap_or(2.0 * radius), roll: force * radius }
    }

    fn of_quantity(&self, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::Force => self.force,
            Quantity::Couple => self.couple,
            Quantity::RollMoment => self.roll,
        }
    }
}

/// Distance [m] between the foremost and the rearmost of the planes in which masses move; `None` if there is one.
fn crank_length(engine: &Engine) -> Option<f64> {
    let planes = engine.throws.iter().map(|t| t.z).chain(engine.cylinders.iter().map(|c| c.z));
    let (low, high) = planes.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)));
    (high > low).then_some(high - low)
}

/// What the loads of `engine` at `speed` [rad/s] mean.
pub(crate) fn diagnose(
    engine: &Engine,
    speed: f64,
    total: &LoadSet,
    cylinders: &[CylinderLoads],
) -> Diagnosis {
    let scales = Scales::of(engine, total, cylinders);
    let mut findings: Vec<Finding> = total
        .orders
        .iter()
        .filter(|o| o.order > 0.0)
        .flat_map(|o| findings(engine, speed, o, roll_of_cylinders(cylinders, o.order)))
        .collect();
    let share = |f: &Finding| f.amplitude / scales.of_quantity(f.quantity);
    findings.retain(|f| share(f) > THRESHOLD);
    let pairs = pairs(&findings, &scales);
    // The list follows the sentence: pair by pair, forward before backward, the roll moment last.
    let place = |f: &Finding| pairs.iter().position(|pair| pair.is_of(f)).unwrap_or(pairs.len());
    findings.sort_by(|a, b| {
        let alone = |f: &Finding| if f.quantity == Quantity::RollMoment { -f.amplitude } else { 0.0 };
        place(a).cmp(&place(b)).then(alone(a).total_cmp(&alone(b)))
    });
    let of_cylinders = |order| roll_of_cylinders(cylinders, order);
    let (summary, roll) = (summary(engine, speed, &pairs), roll(engine, &findings, &of_cylinders));
    Diagnosis { findings, summary, roll }
}

/// Amplitude of the roll moment of all cylinders together at an order [N m].
fn roll_of_cylinders(cylinders: &[CylinderLoads], order: f64) -> f64 {
    let of_order =
        |own: &CylinderLoads| own.loads.orders.iter().find(|o| o.order == order).map(|o| o.roll_moment);
    cylinders.iter().filter_map(of_order).sum::<Complex64>().norm()
}

/// Whether a balance shaft with a lever about the crank axis turns at this order.
fn has_shafts_off_the_axis(engine: &Engine, order: f64) -> bool {
    let is_off = |shaft: &BalanceShaft| shaft.x != 0.0 || shaft.y != 0.0;
    engine.shafts.iter().any(|shaft| is_off(shaft) && (shaft.ratio.value().abs() - order).abs() < 1e-12)
}

/// All loads of one order.
fn findings(engine: &Engine, speed: f64, loads: &OrderLoads, of_cylinders: f64) -> [Finding; 5] {
    let find = |quantity, sense, amplitude: f64| {
        let remedy = remedy(engine, quantity, loads.order, sense);
        let text = match remedy {
            Remedy::RollDevice if has_shafts_off_the_axis(engine, loads.order) => format!(
                "{} of {} roll moment at {} reacts on the block; the cylinders alone make {}, balance shafts off the crank axis the rest: their \
                 places decide.",
                amount(amplitude, quantity),
                adjective(loads.order),
                rpm(speed),
                amount(of_cylinders, quantity)
            ),
            _ => sentence(engine, speed, quantity, loads.order, sense, amplitude, remedy),
        };
        Finding { quantity, order: loads.order, sense, amplitude, remedy, text }
    };
    [
        find(Quantity::Force, Sense::Forward, loads.force_forward.norm()),
        find(Quantity::Force, Sense::Backward, loads.force_backward.norm()),
        find(Quantity::Couple, Sense::Forward, loads.couple_forward.norm()),
        find(Quantity::Couple, Sense::Backward, loads.couple_backward.norm()),
        find(Quantity::RollMoment, Sense::None, loads.roll_moment.norm()),
    ]
}

/// Index of the crankshaft that turns at this order and sense.
fn crankshaft_at(engine: &Engine, order: f64, sense: Sense) -> Option<usize> {
    let signed = if sense == Sense::Backward { -order } else { order };
    engine.crankshafts.iter().position(|c| (c.ratio.value() - signed).abs() < 1e-12)
}

/// What can remove a load of this order and sense.
fn remedy(engine: &Engine, quantity: Quantity, order: f64, sense: Sense) -> Remedy {
    if quantity == Quantity::RollMoment {
        Remedy::RollDevice
    } else if crankshaft_at(engine, order, sense).is_some() {
        Remedy::CrankWeights
    } else if order <= 2.0 {
        Remedy::BalanceShaft
    } else {
        Remedy::NoneOfLowOrder
    }
}

/// "with the crank", "against the crank".
fn turning(sense: Sense) -> &'static str {
    match sense {
        Sense::Forward => "with the crank",
        Sense::Backward => "against the crank",
        Sense::None => "about the crank axis",
    }
}

/// "force", "couple", "roll moment".
fn noun(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Force => "force",
        Quantity::Couple => "couple",
        Quantity::RollMoment => "roll moment",
    }
}

/// "weights on the crankshaft", with its number where there are several.
fn crank_weights(engine: &Engine, order: f64, sense: Sense) -> String {
    match crankshaft_at(engine, order, sense) {
        Some(index) if engine.crankshafts.len() > 1 => format!("weights on crankshaft {}", index + 1),
        _ => "weights on the crankshaft".to_string(),
    }
}

/// A finding as a sentence.
fn sentence(
    engine: &Engine,
    speed: f64,
    quantity: Quantity,
    order: f64,
    sense: Sense,
    amplitude: f64,
    remedy: Remedy,
) -> String {
    let size = amount(amplitude, quantity);
    let noun = noun(quantity);
    let at = format!("{size} of {} {noun} at {}", adjective(order), rpm(speed));
    let planes = if quantity == Quantity::Couple { " in two planes" } else { "" };
    match remedy {
        Remedy::CrankWeights => {
            let weights = crank_weights(engine, order, sense);
            format!("{at} turns {}: {weights}{planes} can remove it.", turning(sense))
        }
        Remedy::BalanceShaft => {
            let weights = if quantity == Quantity::Couple { ", weighted in two planes," } else { "" };
            let shaft = shaft_speed(order);
            format!(
                "{at} turns {0}: a balance shaft {shaft}, turning {0}{weights} can remove it.",
                turning(sense)
            )
        }
        Remedy::NoneOfLowOrder => {
            let shaft = shaft_speed(order);
            format!(
                "{at} turns {}: no first- or second-order device removes it, only a shaft {shaft} could.",
                { turning(sense) }
            )
        }
        Remedy::RollDevice => format!(
            "{at} reacts on the block: crank weights and centred shafts leave it; a pair of shafts {} at unequal \
             heights, or a counter-rotating inertia, can reduce it.",
            shaft_speed(order)
        ),
    }
}

/// Both senses of one order of force or couple.
struct Pair {
    quantity: Quantity,
    order: f64,
    forward: f64,
    backward: f64,
}

impl Pair {
    fn is_of(&self, finding: &Finding) -> bool {
        self.quantity == finding.quantity && self.order == finding.order
    }

    fn size(&self) -> f64 {
        self.forward + self.backward
    }

    /// What there is and what removes it.
    fn clause(&self, engine: &Engine) -> String {
        let kind = if self.quantity == Quantity::Couple { " couple" } else { "" };
        let order = if kind.is_empty() { ordinal(self.order) } else { adjective(self.order) };
        let head = format!("{} of {order}{kind}", amount(self.size(), self.quantity));
        let planes = if self.quantity == Quantity::Couple { ", in two planes," } else { "" };
        let by = |sense| match remedy(engine, self.quantity, self.order, sense) {
            Remedy::CrankWeights => crank_weights(engine, self.order, sense),
            _ => format!("a shaft {} turning {}", shaft_speed(self.order), turning(sense)),
        };
        if self.order > 2.0 {
            return format!("{head}, which no first- or second-order device removes");
        }
        if self.backward == 0.0 {
            let with = by(Sense::Forward);
            return format!("{head}, turning with the crank: {with}{planes} can remove it");
        }
        if self.forward == 0.0 {
            let with = by(Sense::Backward);
            return format!("{head}, turning against the crank: {with}{planes} can remove it");
        }
        let halves = if (self.forward - self.backward).abs() <= 0.005 * self.size() {
            format!("{head}, half turning with the crank, half against")
        } else {
            let (with, against) = (amount(self.forward, self.quantity), amount(self.backward, self.quantity));
            format!("{head}, {with} turning with the crank, {against} against")
        };
        let (with, against) = (by(Sense::Forward), by(Sense::Backward));
        if with.starts_with("a shaft") && against.starts_with("a shaft") {
            let planes = planes.trim_end_matches(',');
            format!("{halves}: two shafts {}, one each way{planes}, remove it", shaft_speed(self.order))
        } else {
            format!("{halves}: {with} and {against}{planes} together remove it")
        }
    }
}

/// Forces and couples by order: those that a device of first or second order can remove first, the largest share of its scale
/// first.
fn pairs(findings: &[Finding], scales: &Scales) -> Vec<Pair> {
    let mut pairs: Vec<Pair> = Vec::new();
    for finding in findings.iter().filter(|f| f.quantity != Quantity::RollMoment) {
        let place = pairs.iter().position(|pair| pair.is_of(finding)).unwrap_or_else(|| {
            let (quantity, order) = (finding.quantity, finding.order);
            pairs.push(Pair { quantity, order, forward: 0.0, backward: 0.0 });
            pairs.len() - 1
        });
        match finding.sense {
            Sense::Backward => pairs[place].backward = finding.amplitude,
            _ => pairs[place].forward = finding.amplitude,
        }
    }
    let share = |p: &Pair| p.size() / scales.of_quantity(p.quantity);
    pairs.sort_by(|a, b| (a.order > 2.0).cmp(&(b.order > 2.0)).then(share(b).total_cmp(&share(a))));
    pairs
}

/// The orders of the roll moment, the largest first; empty where none is worth a word.
fn roll(engine: &Engine, findings: &[Finding], of_cylinders: &dyn Fn(f64) -> f64) -> String {
    let largest: Vec<&Finding> =
        findings.iter().filter(|f| f.quantity == Quantity::RollMoment).take(MOST_ROLL_ORDERS).collect();
    if largest.is_empty() {
        return String::new();
    }
    let list = |size: &dyn Fn(&Finding) -> f64, of: &[&Finding]| {
        let one = |f: &&Finding| format!("{} of {}", amount(size(f), f.quantity), ordinal(f.order));
        of.iter().map(one).collect::<Vec<_>>().join(", ")
    };
    let orders = list(&|f| f.amplitude, &largest);
    // Shafts with a lever about the crank axis make a roll moment of their own.
    let off: Vec<&Finding> =
        largest.iter().copied().filter(|f| has_shafts_off_the_axis(engine, f.order)).collect();
    if off.is_empty() {
        return format!("Roll moment of the inertia: {orders}; crank weights and centred shafts leave it.");
    }
    let alone = list(&|f| of_cylinders(f.order), &off);
    format!(
        "Roll moment of the inertia: {orders}. Balance shafts off the crank axis make a part of it; the cylinders alone: {alone}."
    )
}

/// The whole in one or two sentences.
fn summary(engine: &Engine, speed: f64, pairs: &[Pair]) -> String {
    let name = layout(engine);
    let (low, high): (Vec<&Pair>, Vec<&Pair>) = pairs.iter().partition(|p| p.order <= 2.0);
    let mut clauses: Vec<String> = low.iter().map(|p| p.clause(engine)).collect();
    if let Some(largest) = high.first()
        && clauses.is_empty()
    {
        clauses.push(format!("the largest load left is {}", largest.clause(engine)));
    }
    if clauses.is_empty() {
        clauses.push("no force and no couple is left that is worth a word".to_string());
    }
    let balanced = balanced(engine, &low);
    let end = if balanced.is_empty() { String::new() } else { format!("; {balanced}") };
    format!("{name} at {}: {}{end}.", rpm(speed), clauses.join("; "))
}

/// Which forces and couples of first and second order vanish.
fn balanced(engine: &Engine, left: &[&Pair]) -> String {
    let orders = |quantity: Quantity| -> Vec<&'static str> {
        [1.0, 2.0]
            .into_iter()
            .filter(|&order| !left.iter().any(|p| p.quantity == quantity && p.order == order))
            .map(|order| if order == 1.0 { "first" } else { "second" })
            .collect()
    };
    let forces = orders(Quantity::Force);
    let couples = if crank_length(engine).is_some() { orders(Quantity::Couple) } else { Vec::new() };
    let list = |noun: &str, orders: &[&str]| match orders {
        [] => None,
        [one] => Some(format!("the {one}-order {noun}")),
        more => Some(format!("{noun}s of {} order", more.join(" and "))),
    };
    let parts: Vec<String> = if forces == couples && !forces.is_empty() {
        vec![format!("forces and couples of {} order", forces.join(" and "))]
    } else {
        [list("force", &forces), list("couple", &couples)].into_iter().flatten().collect()
    };
    match parts.as_slice() {
        [] => String::new(),
        [one] if one.starts_with("the ") => format!("{one} is balanced"),
        [one] => format!("{one} are balanced"),
        more => format!("{} are balanced", more.join(" and ")),
    }
}
