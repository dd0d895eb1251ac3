//! What a stage gives up for the stages after it: a share of its least value, or an amount in its unit.

use crate::balance_task::{Criterion, GiveUp, Stage};
use crate::criterion::dimension;
use lanchester_units::{Bound, Dimension, Refusal, parse, within};

/// The stage that a criterion belongs to.
pub fn stage_of(criterion: &Criterion, stages: &[Stage]) -> Option<usize> {
    stages.iter().position(|stage| stage.terms.iter().any(|term| term.1 == *criterion))
}

/// Why a criterion gives up nothing: no stage minimises it.
pub fn no_stage(name: &str, stages: &[String]) -> Refusal {
    Refusal {
        code: "E0205",
        message: format!("no stage minimises `{name}`, so it has nothing to give up"),
        label: "no stage".into(),
        hint: format!("name one of the stages: {}", stages.join(", ")),
    }
}

/// What a text such as "1 %" or "5 N" says that a stage gives up; `name` is what it goes by.
pub fn amount(text: &str, stage: &Stage, name: &str) -> Result<GiveUp, Refusal> {
    let trimmed = text.trim();
    let refuse = |code, message: String, label: &str, hint: String| {
        Err(Refusal { code, message, label: label.into(), hint })
    };
    let own = match stage.terms.as_slice() {
        [(_, criterion)] if *criterion != Criterion::Cost => Some(dimension(criterion)),
        _ => None,
    };
    let example = "\"1 %\" of its least value".to_string();
    let either =
        own.map_or(example.clone(), |own| format!("{example}, or {} with its unit", own.with_article()));
    if trimmed.is_empty() {
        return refuse(
            "E0108",
            format!("`{name}` gives up nothing"),
            "empty",
            format!("write {either}; or leave it out"),
        );
    }
    if let Ok(bare) = trimmed.parse::<f64>() {
        let message = format!("what `{name}` gives up needs its unit, got {bare}");
        return refuse("E0101", message, "no unit", format!("write {either}"));
    }
    if trimmed.ends_with('%') {
        let share = parse(trimmed, Dimension::Share, name)?;
        return within(share, Dimension::Share, Bound::NotNegative, name, trimmed, None)
            .map(GiveUp::Share)
            .map_err(|refusal| Refusal { hint: format!("write {either}"), ..refusal });
    }
    let Some(own) = own else {
        let message =
            format!("`{name}` belongs to a weighted sum, which gives up a share, got \"{trimmed}\"");
        return refuse("E0103", message, "no share", format!("write {either}"));
    };
    let amount = parse(trimmed, own, name)
        .map_err(|refusal| Refusal { hint: format!("write {either}"), ..refusal })?;
    within(amount, own, Bound::NotNegative, name, trimmed, None)
        .map(GiveUp::Amount)
        .map_err(|refusal| Refusal { hint: format!("write {either}"), ..refusal })
}

/// Puts what a stage gives up at its place.
pub fn put(list: &mut Vec<GiveUp>, stage: usize, give_up: GiveUp) {
    if list.len() <= stage {
        list.resize(stage + 1, GiveUp::Nothing);
    }
    list[stage] = give_up;
}
