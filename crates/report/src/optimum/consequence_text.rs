//! What other weights do to the engine, in sentences.

use crate::kit::number;
use crate::optimum::consequence_tables::part_name;
use lanchester_balance::{Affected, Change, Consequence, Consequences};

/// Loads, in the order in which a sentence has them.
const LOADS: [Affected; 6] = [
    Affected::MainLoadPeak,
    Affected::BendingMoment,
    Affected::Force,
    Affected::Couple,
    Affected::RollMoment,
    Affected::MountForce,
];

/// Digits of a number in a sentence.
const DIGITS: i32 = 3;

/// What gets worse, and what became of the bearings where counterweights are dropped; empty where nothing is to be said.
pub fn consequence_words(consequences: &Consequences) -> String {
    let rises = rises(consequences);
    let words: Vec<&str> = rises.iter().map(|rise| rise.words.as_str()).collect();
    let worse = match words.is_empty() {
        true => String::new(),
        false => format!("Worse than before: {}.", words.join(", ")),
    };
    let dropped = dropped_words(consequences, &rises);
    [worse, dropped].into_iter().filter(|words| !words.is_empty()).collect::<Vec<_>>().join(" ")
}

/// A load that got worse.
struct Rise {
    quantity: Affected,
    /// Before and after, with their unit.
    amounts: [String; 2],
    words: String,
}

/// "the peak load on main 3 rises from 5.31 kN to 26.6 kN", "the bending moment from 703 N m to 2.34 kN m"
fn rises(consequences: &Consequences) -> Vec<Rise> {
    let mut rises: Vec<Rise> = Vec::new();
    for quantity in LOADS {
        let worse = consequences.of(quantity).filter(|row| row.change == Change::Worse);
        // Of several the one that rises most.
        let Some(most) = worse.max_by(|a, b| (a.after - a.before).total_cmp(&(b.after - b.before))) else {
            continue;
        };
        let [before, after] = amounts([most.before, most.after], quantity.unit());
        if before == after {
            continue;
        }
        let verb = if rises.is_empty() { "rises " } else { "" };
        let words = format!("the {} {verb}from {before} to {after}", name(consequences, most));
        rises.push(Rise { quantity, amounts: [before, after], words });
    }
    rises
}

fn name(consequences: &Consequences, row: &Consequence) -> String {
    let several = consequences.bending.len() > 1;
    match row.quantity {
        Affected::MainLoadPeak => format!("peak load on {}", part_name(&row.part, several)),
        Affected::BendingMoment if several => format!("bending moment of {}", part_name(&row.part, several)),
        quantity => quantity.name().to_owned(),
    }
}

/// "Counterweights dropped: web 1 to 4; the largest main-bearing load goes from 26.6 kN to 5.31 kN"; without the loads whose rise
/// was said already.
fn dropped_words(consequences: &Consequences, said: &[Rise]) -> String {
    if consequences.dropped.is_empty() {
        return String::new();
    }
    let largest =
        [(Affected::MainLoadPeak, "main-bearing load"), (Affected::BendingMoment, "bending moment")];
    let loads: Vec<String> = largest
        .into_iter()
        .filter_map(|(quantity, name)| {
            let [before, after] = amounts(consequences.largest(quantity)?, quantity.unit());
            if said
                .iter()
                .any(|rise| rise.quantity == quantity && rise.amounts == [before.clone(), after.clone()])
            {
                return None;
            }
            Some(match before == after {
                true => format!("the largest {name} stays {after}"),
                false => format!("the largest {name} goes from {before} to {after}"),
            })
        })
        .collect();
    let count = consequences.dropped.len();
    let [before, _] = consequences.counterweights;
    let names = listed(&consequences.dropped);
    let what = match (count, before) {
        (1, _) => "Counterweight dropped",
        (count, before) if count == before && consequences.added.is_empty() => "All counterweights dropped",
        _ => "Counterweights dropped",
    };
    let loads = if loads.is_empty() { String::new() } else { format!("; {}", loads.join(", ")) };
    let added = match consequences.added.is_empty() {
        true => String::new(),
        false => format!("; added: {}", listed(&consequences.added)),
    };
    format!("{what}: {names}{added}{loads}.")
}

/// Names with runs of numbers joined: "web 1 to 4, web 7".
fn listed(names: &[String]) -> String {
    let numbered = |name: &String| -> Option<(String, usize)> {
        let (kind, number) = name.rsplit_once(' ')?;
        Some((kind.to_owned(), number.parse().ok()?))
    };
    let mut parts: Vec<String> = Vec::new();
    let mut start = 0;
    while start < names.len() {
        let mut end = start;
        if let Some((kind, first)) = numbered(&names[start]) {
            let goes_on = |place: usize| {
                names.get(place).and_then(numbered) == Some((kind.clone(), first + place - start))
            };
            while goes_on(end + 1) {
                end += 1;
            }
        }
        // Two are a pair, more are a run.
        match (end - start, numbered(&names[end])) {
            (2.., Some((_, last))) => parts.push(format!("{} to {last}", names[start])),
            _ => parts.extend(names[start..=end].iter().cloned()),
        }
        start = end + 1;
    }
    parts.join(", ")
}

/// Both with their unit, in kilo where the larger one is.
fn amounts(values: [f64; 2], unit: &str) -> [String; 2] {
    values.map(|value| match value >= 999.5 {
        true => format!("{} k{unit}", number::trimmed(value / 1e3, DIGITS)),
        false => format!("{} {unit}", number::trimmed(value, DIGITS)),
    })
}

#[cfg(test)]
mod tests {
    use super::listed;

    #[test]
    fn runs_of_names_are_joined() {
        let names = |text: &str| -> Vec<String> { text.split(", ").map(str::to_owned).collect() };
        assert_eq!(listed(&names("web 1, web 2, web 3, web 4, web 7")), "web 1 to 4, web 7");
        assert_eq!(listed(&names("web 1, web 2")), "web 1, web 2");
        assert_eq!(
            listed(&names("flywheel, web 1, throw 2, throw 3, throw 4")),
            "flywheel, web 1, throw 2 to 4"
        );
    }
}
