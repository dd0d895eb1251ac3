//! What stages gave up for later ones, and what that gained, in words.

use crate::kit::number::short;
use crate::optimum::tables::stage_name;
use lanchester_balance::{Answer, FoundStage};
use lanchester_model::Engine;

/// A gain below this share of the value is none.
const NO_GAIN: f64 = 1e-7;

/// What each stage gave up and what the later ones gained; empty where nothing is given up.
pub(crate) fn give_up_words(engine: &Engine, answer: &Answer) -> String {
    let unit = |stage: &FoundStage| match stage.is_weighted_sum() {
        true => String::new(),
        false => format!(" {}", stage.unit),
    };
    let given = answer.stages.iter().filter_map(|stage| stage.give_up.map(|given| (stage, given)));
    let mut sentences: Vec<String> = given
        .map(|(stage, given)| {
            let (name, unit) = (stage_name(engine, stage), unit(stage));
            let [least, most, value] = [given.least, given.most, stage.value].map(|v| short(v, 6));
            format!("{name} could be {least}{unit} and may be up to {most}{unit} for later stages: it is {value}{unit}")
        })
        .collect();
    if sentences.is_empty() {
        return String::new();
    }
    let gains: Vec<String> = answer
        .stages
        .iter()
        .chain(&answer.among_equals)
        .filter_map(|stage| {
            let (before, unit) = (stage.without_give_up?, unit(stage));
            let gained = before - stage.value > NO_GAIN * before.abs();
            let name = stage_name(engine, stage);
            gained.then(|| format!("{name} from {} to {}{unit}", short(before, 6), short(stage.value, 6)))
        })
        .collect();
    sentences.push(match gains.is_empty() {
        true => "no later stage gains by it".into(),
        false => format!("that lowers {}", gains.join(", ")),
    });
    format!("Give-up: {}.", sentences.join("; "))
}
