//! Criteria of main-bearing loads in words: `main-bearing load 3 rms`.
//!
//! Main bearings are told by number, crankshaft 1 first, each from the free end on. A number alone asks for the peak over the
//! cycle, `rms` behind it for the root mean square, `mean` for the mean of the load's amount; without a number these are of all
//! main bearings together, and `largest` before the name asks for the bearing with the largest. `with gas` at the end adds
//! the gas, over the range of speeds.

use crate::balance_task::{Criterion, Load, Mains, Statistic};
use lanchester_model::Engine;
use lanchester_results::{Output, Place, Size};
use lanchester_units::Refusal;

/// Largest peak of any main bearing, and what every other name begins with.
pub const NAME: &str = "main-bearing load";

/// What stands before the name where the bearing with the largest counts.
const LARGEST: &str = "largest ";

/// What stands behind the name where a statistic over the cycle counts, not the peak.
const STATISTICS: [(&str, Statistic); 2] = [("rms", Statistic::Rms), ("mean", Statistic::Mean)];

/// What stands at the end where the gas counts too.
const WITH_GAS: &str = "with gas";

/// Names to propose where somebody writes something near to them.
pub const PROPOSED: [&str; 5] = [
    "main-bearing load rms",
    "largest main-bearing load rms",
    "main-bearing load mean",
    "main-bearing load with gas",
    "main-bearing load rms with gas",
];

/// The criterion of a name with single spaces; `None` where it is about something else.
pub fn named(text: &str) -> Option<Result<Criterion, Refusal>> {
    let (largest, rest) = match text.strip_prefix(LARGEST) {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let rest = rest.strip_prefix(NAME)?;
    if !(rest.is_empty() || rest.starts_with(' ')) {
        return None;
    }
    let (rest, gas) = match rest.strip_suffix(WITH_GAS) {
        Some(rest) if rest.ends_with(' ') => (rest, true),
        _ => (rest, false),
    };
    let mut words: Vec<&str> = rest.split_whitespace().collect();
    let statistic = STATISTICS.iter().find(|(word, _)| words.pop_if(|last| last == word).is_some());
    let statistic = statistic.map_or(Statistic::Peak, |(_, statistic)| *statistic);
    let mains = match (words.as_slice(), largest) {
        ([], true) => Mains::Largest,
        ([], false) if statistic == Statistic::Peak => Mains::Largest,
        ([], false) => Mains::All,
        ([number], false) => match index(number) {
            Some(index) => Mains::One(index),
            None => return Some(Err(no_number(text, number))),
        },
        (words, _) => return Some(Err(no_number(text, &words.join(" ")))),
    };
    Some(of_statistic(statistic, mains, gas).ok_or_else(|| no_largest_mean(text)))
}

/// The criterion that an output of the common vocabulary is.
pub fn of_output(output: &Output, with_gas: bool) -> Option<Criterion> {
    let statistic = match output.size {
        Size::Peak => Statistic::Peak,
        Size::Mean => Statistic::Mean,
        Size::Rms => Statistic::Rms,
        Size::Order(order) if !with_gas => {
            return match output.place {
                Place::Any | Place::Largest => Some(Criterion::Order(Load::LargestMainLoad, order)),
                Place::Number(number) => Some(Criterion::Order(Load::MainLoad(number - 1), order)),
                Place::Named(_) => None,
            };
        }
        Size::Order(_) => return None,
    };
    let mains = match output.place {
        Place::Any if statistic == Statistic::Peak => Mains::Largest,
        Place::Any => Mains::All,
        Place::Largest => Mains::Largest,
        Place::Number(number) => Mains::One(number - 1),
        Place::Named(_) => return None,
    };
    of_statistic(statistic, mains, with_gas)
}

/// The criterion of a statistic; `None` for the largest of several means, which nobody asks for.
fn of_statistic(statistic: Statistic, mains: Mains, with_gas: bool) -> Option<Criterion> {
    Some(match (statistic, mains) {
        (Statistic::Mean, Mains::Largest) => return None,
        (statistic, mains) if with_gas => Criterion::MainsWithGas(statistic, mains),
        (Statistic::Rms, mains) => Criterion::MainRms(mains),
        (Statistic::Mean, mains) => Criterion::MainMean(mains),
        (Statistic::Peak, Mains::One(index)) => Criterion::Peak(Load::MainLoad(index)),
        (Statistic::Peak, _) => Criterion::Peak(Load::LargestMainLoad),
    })
}

/// Index of a number from 1 on.
fn index(text: &str) -> Option<usize> {
    let plain = text.bytes().all(|byte| byte.is_ascii_digit());
    text.parse::<usize>().ok().filter(|_| plain)?.checked_sub(1)
}

/// The name of the load of main bearing `index`.
pub fn load_name(index: usize) -> String {
    format!("{NAME} {}", index + 1)
}

/// The name of a statistic of main-bearing loads, and of what counts with gas; `None` for another criterion.
pub fn statistic_name(criterion: &Criterion) -> Option<String> {
    let (statistic, mains, gas) = match criterion {
        Criterion::MainRms(mains) => (Statistic::Rms, mains, false),
        Criterion::MainMean(mains) => (Statistic::Mean, mains, false),
        Criterion::MainsWithGas(statistic, mains) => (*statistic, mains, true),
        _ => return None,
    };
    let word = STATISTICS.iter().find(|(_, known)| *known == statistic).map(|(word, _)| *word);
    let load = match mains {
        Mains::Largest if word.is_some() => format!("{LARGEST}{NAME}"),
        Mains::All | Mains::Largest => NAME.to_string(),
        Mains::One(index) => load_name(*index),
    };
    let parts = [Some(load.as_str()), word, gas.then_some(WITH_GAS)];
    Some(parts.into_iter().flatten().collect::<Vec<_>>().join(" "))
}

/// Index of the main bearing that a criterion is about, if it is about one.
fn main_of(criterion: &Criterion) -> Option<usize> {
    match criterion {
        Criterion::Peak(Load::MainLoad(index)) | Criterion::Order(Load::MainLoad(index), _) => Some(*index),
        Criterion::MainRms(Mains::One(index))
        | Criterion::MainMean(Mains::One(index))
        | Criterion::MainsWithGas(_, Mains::One(index)) => Some(*index),
        _ => None,
    }
}

/// Whether a criterion is about main bearings.
pub fn is_about_mains(criterion: &Criterion) -> bool {
    matches!(
        criterion,
        Criterion::MainRms(_)
            | Criterion::MainMean(_)
            | Criterion::MainsWithGas(..)
            | Criterion::Peak(Load::MainLoad(_) | Load::LargestMainLoad)
            | Criterion::Order(Load::MainLoad(_) | Load::LargestMainLoad, _)
    )
}

/// Refuses main bearings that the engine does not have.
pub fn check(criterion: &Criterion, engine: &Engine) -> Result<(), Refusal> {
    if !is_about_mains(criterion) {
        return Ok(());
    }
    let count = engine.main_bearings().len();
    let refusal = |message: String, hint: String| {
        Err(Refusal { code: "E0205", message, label: "no such main bearing".into(), hint })
    };
    if count == 0 {
        let hint = "judge something else: no crankshaft has a throw";
        return refusal(format!("\"{NAME}\" needs main bearings, and there are none"), hint.into());
    }
    match main_of(criterion) {
        Some(index) if index >= count => {
            let first = if engine.crankshafts.len() > 1 { ", those of crankshaft 1 first" } else { "" };
            refusal(
                format!("there is no main bearing {}", index + 1),
                format!("there are main bearings 1 to {count}{first}"),
            )
        }
        _ => Ok(()),
    }
}

fn no_largest_mean(text: &str) -> Refusal {
    Refusal {
        code: "E0109",
        message: format!(
            "a mean is that of all main bearings together or of one, got \"{}\"",
            text.chars().take(60).collect::<String>()
        ),
        label: "no mean of the largest".into(),
        hint: format!("write \"{NAME} mean\" or \"{NAME} 3 mean\""),
    }
}

fn no_number(text: &str, got: &str) -> Refusal {
    let short = |text: &str| text.chars().take(60).collect::<String>();
    Refusal {
        code: "E0109",
        message: format!(
            "the main bearing in \"{}\" needs a number from 1 on, got \"{}\"",
            short(text),
            short(got)
        ),
        label: "no number".into(),
        hint: format!(
            "write \"{NAME} 3\" for its peak, \"{NAME} 3 rms\" for its root mean square, \"{NAME} 3 mean\" for its mean; \
             without a number for all"
        ),
    }
}
