//! Numbers, orders, speeds and layouts as a mechanical engineer would write them.

use crate::inertia::result::Quantity;
use lanchester_model::Engine;
use std::f64::consts::{PI, TAU};

/// Three significant digits with the unit, in kilo from a thousand up.
pub(crate) fn amount(value: f64, quantity: Quantity) -> String {
    let unit = if quantity == Quantity::Force { "N" } else { "N m" };
    // 999.5 already prints as 1000.
    if value >= 999.5 {
        format!("{} k{unit}", digits(value / 1000.0))
    } else {
        format!("{} {unit}", digits(value))
    }
}

/// Three significant digits without an exponent, as long as that is readable.
fn digits(value: f64) -> String {
    if value == 0.0 {
        return "0".to_string();
    }
    let exponent = format!("{value:.2e}");
    let exponent: i32 = exponent.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    match exponent {
        2..=5 => format!("{value:.0}"),
        -3..=1 => format!("{value:.*}", (2 - exponent) as usize),
        _ => format!("{value:.2e}"),
    }
}

/// "first order", "second order", "order 1.5".
pub(crate) fn ordinal(order: f64) -> String {
    const NAMES: [&str; 12] = [
        "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth",
        "eleventh", "twelfth",
    ];
    let whole = order.round();
    if whole == order && (1.0..=12.0).contains(&whole) {
        format!("{} order", NAMES[whole as usize - 1])
    } else {
        format!("order {}", trimmed(order))
    }
}

/// "first-order", "second-order", "order-1.5".
pub(crate) fn adjective(order: f64) -> String {
    ordinal(order).replace(' ', "-")
}

/// A number without needless digits.
fn trimmed(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

/// "at crank speed", "at twice crank speed", "at 1.5 times crank speed".
pub(crate) fn shaft_speed(order: f64) -> String {
    if order == 1.0 {
        "at crank speed".to_string()
    } else if order == 2.0 {
        "at twice crank speed".to_string()
    } else if order == 0.5 {
        "at half crank speed".to_string()
    } else {
        format!("at {} times crank speed", trimmed(order))
    }
}

/// A speed [rad/s] in revolutions a minute.
pub(crate) fn rpm(speed: f64) -> String {
    format!("{} rpm", trimmed((speed * 30.0 / PI * 10.0).round() / 10.0))
}

/// "In-line four", "90-degree V8", "Flat six", "Radial nine", "Engine with 18 cylinders".
pub(crate) fn layout(engine: &Engine) -> String {
    let count = engine.cylinders.len();
    let mut axes: Vec<f64> = Vec::new();
    for cylinder in &engine.cylinders {
        let angle = cylinder.angle;
        if !axes.iter().any(|other| apart(*other, angle) < 1e-6) {
            axes.push(angle);
        }
    }
    let plain = engine.crankshafts.len() == 1;
    match axes.as_slice() {
        [_] if count == 1 => "Single cylinder".to_string(),
        [_] if plain => format!("In-line {}", number(count)),
        [a, b] if plain && PI - apart(*a, *b) < 1e-6 => format!("Flat {}", number(count)),
        [a, b] if plain => format!("{}-degree V{count}", trimmed(apart(*a, *b).to_degrees())),
        more if plain && more.len() >= 3 && evenly_spread(more) => {
            let rows = count / more.len();
            let kind = if rows > 1 { format!("{}-row radial", number(rows)) } else { "radial".to_string() };
            capitalised(&format!("{kind} {}", number(count)))
        }
        _ => format!("Engine with {} cylinder{}", number(count), if count == 1 { "" } else { "s" }),
    }
}

/// Angle between two axes [rad], 0 to pi.
fn apart(a: f64, b: f64) -> f64 {
    let turn = (a - b).rem_euclid(TAU);
    turn.min(TAU - turn)
}

/// Whether the axes stand around the whole circle at equal angles.
fn evenly_spread(axes: &[f64]) -> bool {
    let step = TAU / axes.len() as f64;
    axes.iter().all(|a| {
        let turns = apart(*a, axes[0]) / step;
        (turns - turns.round()).abs() < 1e-6
    })
}

/// A count in words up to twelve.
fn number(count: usize) -> String {
    const NAMES: [&str; 13] = [
        "no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven",
        "twelve",
    ];
    NAMES.get(count).map_or_else(|| count.to_string(), |name| (*name).to_string())
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
