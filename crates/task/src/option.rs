//! What is asked, in a line of text: the options of a command line.

use crate::balance_task::{Criterion, GiveUp, Limit, Load, Stage};
use crate::criterion::{self, criterion};
use crate::give_up;
use lanchester_model::Engine;
pub use lanchester_units::option::*;
use lanchester_units::{Bound, Dimension, parse};

/// A density with its unit, such as "7850 kg/m3" [kg/m^3]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of density, or if no material of a crankshaft has it.
pub fn density(text: &str, option: &str) -> Result<f64, BadQuantity> {
    let density = of_dimension(text, Dimension::Density, Bound::Positive, option)?;
    match lanchester_shape::plausible_density(density) {
        Ok(()) => Ok(density),
        Err(error) => {
            let error = error.to_string();
            let (message, hint) = error.split_once("\nhint: ").unwrap_or((&error, ""));
            Err(BadQuantity { message: format!("`{option}`: {message}"), hint: hint.into() })
        }
    }
}

/// A largest cost such as "40", in the unit that the file counts in; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if it is no bare number of 0 or more.
pub fn budget(text: &str, option: &str) -> Result<Limit, BadQuantity> {
    let most = text.trim().parse::<f64>().ok().filter(|most| most.is_finite() && *most >= 0.0);
    most.map(|most| Limit { criterion: Criterion::Cost, most }).ok_or_else(|| BadQuantity {
        message: format!("`{option}` needs a bare number of 0 or more, got \"{text}\""),
        hint: format!("write it like {option} 40, in the unit of fixed_cost and cost_per_kg"),
    })
}

/// A limit such as "couple = 5 N m" or "force order 1=200 N"; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if it is not a criterion, an equals sign and a quantity of 0 or more in a unit of the criterion.
pub fn limit(text: &str, engine: &Engine, option: &str) -> Result<Limit, BadQuantity> {
    let Some((name, value)) = text.rsplit_once('=') else {
        return Err(BadQuantity {
            message: format!("`{option}` needs a criterion and its largest value, got \"{text}\""),
            hint: format!("for example {option} \"couple = 5 N m\""),
        });
    };
    let criterion = criterion(name, engine)?;
    let most = amount(value, &criterion, name.trim())?;
    if most < 0.0 {
        return Err(BadQuantity {
            message: format!("the limit of `{}` must not be negative, got {}", name.trim(), value.trim()),
            hint: "give the largest amount that it may have".into(),
        });
    }
    Ok(Limit { criterion, most })
}

/// What is minimised at once: a criterion such as "force", or several with the value of each that counts as much as
/// those of the others, such as "force = 200 N, couple = 10 N m"; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if it is neither.
pub fn stage(text: &str, engine: &Engine, option: &str) -> Result<Stage, BadQuantity> {
    if !text.contains('=') {
        return Ok(Stage { terms: vec![(1.0, criterion(text, engine)?)] });
    }
    let term = |part: &str| {
        let limit = limit(part, engine, option)?;
        let weight = 1.0 / limit.most;
        if weight.is_finite() {
            Ok((weight, limit.criterion))
        } else {
            Err(BadQuantity {
                message: format!("the value of {} must be more than 0", part.trim()),
                hint: "a criterion counts by its share of the value given for it".into(),
            })
        }
    };
    Ok(Stage::of(text.split(',').map(term).collect::<Result<_, _>>()?))
}

/// What a stage gives up for those after it: "force = 1 %", "force 1 %", "force = 5 N", or "1 %" for the stage at `place` of
/// `stages`; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if it names no stage, or no share or amount of 0 or more.
pub fn give_up(
    text: &str,
    place: usize,
    stages: &[Stage],
    engine: &Engine,
    option: &str,
) -> Result<(usize, GiveUp), BadQuantity> {
    let of_stage = |name: &str, value: &str| {
        let found = criterion(name, engine)?;
        let stage = give_up::stage_of(&found, stages).ok_or_else(|| {
            let names = stages.iter().flat_map(|stage| &stage.terms);
            let names: Vec<String> = names.map(|term| criterion::criterion_name(&term.1, engine)).collect();
            BadQuantity::from(give_up::no_stage(name.trim(), &names))
        })?;
        give_up::amount(value, &stages[stage], name.trim())
            .map(|given| (stage, given))
            .map_err(BadQuantity::from)
    };
    if let Some((name, value)) = text.rsplit_once('=') {
        return of_stage(name, value);
    }
    // The longest beginning that is a criterion: names of orders end in a number too.
    let text = text.trim();
    let ends = text.char_indices().filter(|(_, c)| c.is_whitespace()).map(|(place, _)| place);
    let names: Vec<usize> = ends.filter(|&end| criterion(&text[..end], engine).is_ok()).collect();
    if let Some(&end) = names.last() {
        return of_stage(&text[..end], &text[end..]);
    }
    if !text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) {
        return Err(BadQuantity {
            message: format!("`{option}` needs a stage and what it gives up, got \"{text}\""),
            hint: format!("for example {option} 'force = 1 %', or {option} '1 %' for the first stage"),
        });
    }
    let Some(stage) = stages.get(place) else {
        return Err(BadQuantity {
            message: format!(
                "`{option} '{text}'` is for stage {}, and there are {}",
                place + 1,
                stages.len()
            ),
            hint: "give one for each stage at most, or name the stage".into(),
        });
    };
    let name = stage.terms.first().map_or(String::new(), |term| criterion::criterion_name(&term.1, engine));
    give_up::amount(text, stage, &name).map(|given| (place, given)).map_err(BadQuantity::from)
}

/// Orders that must vanish: one, such as "force order 1", or several with commas between them; `option` names what asks
/// for them in the message.
///
/// # Errors
/// [`BadQuantity`] if one of them is not one order of a load on the engine's block.
pub fn cancel(text: &str, engine: &Engine, option: &str) -> Result<Vec<(Load, f64)>, BadQuantity> {
    let one = |part: &str| {
        let found = criterion(part, engine)?;
        criterion::cancelled(&found).ok_or_else(|| BadQuantity {
            message: format!("`{option}` {}, got \"{}\"", criterion::CANCEL_NEEDS, part.trim()),
            hint: criterion::cancel_hint(part.trim()),
        })
    };
    text.split(',').map(one).collect()
}

fn amount(text: &str, criterion: &Criterion, name: &str) -> Result<f64, BadQuantity> {
    if *criterion == Criterion::Cost {
        return Err(criterion::cost_has_no_value(name).into());
    }
    parse(text, criterion::dimension(criterion), name).map_err(BadQuantity::from)
}
