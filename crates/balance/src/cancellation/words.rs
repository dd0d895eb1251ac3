//! Why orders cannot vanish, in words.

use super::answer::{CancelledOrder, OrderSense};
use super::equations::{Equations, Part};
use super::functional::Weighed;
use crate::operator::ratio_of;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Load, criterion_name, criterion_unit};
use num_complex::Complex64;

/// Terms below this share of the largest say nothing.
const NOISE: f64 = 1e-9;

/// An order that did not come out as nothing.
pub(super) fn not_vanished(engine: &Engine, order: &CancelledOrder) -> String {
    let name = criterion_name(&order.criterion, engine);
    format!("rounding leaves {:.3e} {} of {name}", order.left, criterion_unit(&order.criterion))
}

/// What an obstruction says.
pub(super) fn reason(engine: &Engine, task: &BalanceTask, equations: &Equations, proof: &Weighed) -> String {
    let factor = |k: usize| Complex64::new(proof.multipliers[2 * k], proof.multipliers[2 * k + 1]);
    let largest = (0..equations.parts.len()).map(|k| factor(k).norm()).fold(0.0, f64::max);
    let named: Vec<(&Part, f64)> = (0..equations.parts.len())
        .filter(|&k| factor(k).norm() > NOISE * largest)
        .map(|k| (&equations.parts[k], equations.parts[k].scale / factor(k).norm()))
        .collect();
    let untouched =
        named.iter().all(|(part, _)| part.columns.iter().all(|c| c.1.norm() <= NOISE * part.scale));
    match &named[..] {
        [(part, _)] if untouched => nothing_acts(engine, task, equations, part),
        [(part, left)] => {
            let what = part_name(engine, part);
            let amount = amount(*left, part);
            format!("{} leave at least {amount} of {what}", limited_by(task, equations, proof))
        }
        several => {
            let each: Vec<String> = several
                .iter()
                .map(|(part, left)| {
                    format!(
                        "at least {} of {} where the rest vanishes",
                        amount(*left, part),
                        part_name(engine, part)
                    )
                })
                .collect();
            format!(
                "{} cannot bring all to nothing at once: they leave {}",
                limited_by(task, equations, proof),
                each.join(", or ")
            )
        }
    }
}

/// No device acts on a part at all.
fn nothing_acts(engine: &Engine, task: &BalanceTask, equations: &Equations, part: &Part) -> String {
    let Criterion::Order(load, order) = part.criterion else { return String::new() };
    let stays =
        format!("{} of {} stay as they are", amount(part.amount.norm(), part), part_name(engine, part));
    let turning = |sense: f64| {
        let ratio = |w: &lanchester_task::FreeWeight| ratio_of(engine, task, w.seat).value();
        task.weights.iter().any(|w| (ratio(w) - sense * order).abs() < 1e-9)
    };
    let why = match part.sense {
        OrderSense::Forward | OrderSense::Backward => {
            let (own, own_words, other_words) = match part.sense {
                OrderSense::Forward => (1.0, "with the crank", "against it"),
                _ => (-1.0, "against the crank", "with it"),
            };
            let speed = speed_words(order);
            match (turning(own), turning(-own)) {
                (true, _) => format!("no weight that turns {own_words} at {speed} acts on it in its plane"),
                (false, true) => format!("the weights at {speed} turn {other_words}, none {own_words}"),
                (false, false) => {
                    // Both senses alike: the whole order is said once.
                    let whole: f64 = equations
                        .parts
                        .iter()
                        .filter(|p| p.criterion == part.criterion)
                        .map(|p| p.amount.norm())
                        .sum();
                    let name = criterion_name(&part.criterion, engine);
                    return format!(
                        "{} of {name} stay as they are: no weight given turns at {speed}",
                        amount(whole, part)
                    );
                }
            }
        }
        OrderSense::Alternating if load == Load::RollMoment => {
            if turning(1.0) || turning(-1.0) {
                "no weight given at that speed has its axis away from the origin".to_owned()
            } else {
                "no weight given acts on it".to_owned()
            }
        }
        OrderSense::Alternating => "no weight given acts on it".to_owned(),
    };
    format!("{stays}: {why}")
}

/// The devices behind a proof, by what keeps them from more.
fn limited_by(task: &BalanceTask, equations: &Equations, proof: &Weighed) -> String {
    let at_most: Vec<String> = proof
        .charges
        .iter()
        .map(|&(device, _)| match equations.devices[device].weight {
            Some(weight) => format!("`{}`", task.weights[weight].name),
            None => task.inertias.first().map_or(String::new(), |i| format!("`{}`", i.name)),
        })
        .collect();
    if at_most.is_empty() {
        "the devices given, of whatever amount,".to_owned()
    } else {
        format!("the devices given, with {} no larger than allowed,", at_most.join(", "))
    }
}

fn speed_words(order: f64) -> String {
    if order == 1.0 { "crank speed".to_owned() } else { format!("{order} times crank speed") }
}

fn part_name(engine: &Engine, part: &Part) -> String {
    let name = criterion_name(&part.criterion, engine);
    match part.sense {
        OrderSense::Forward => format!("{name} turning with the crank"),
        OrderSense::Backward => format!("{name} turning against the crank"),
        OrderSense::Alternating => name,
    }
}

/// Four significant digits.
fn amount(value: f64, part: &Part) -> String {
    let digits = if value > 0.0 { (3 - value.log10().floor() as i64).clamp(0, 9) as usize } else { 0 };
    format!("{value:.digits$} {}", criterion_unit(&part.criterion))
}
