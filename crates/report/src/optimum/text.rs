//! The answer of a balancing question as plain text.

use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::rounding::clean;
use crate::optimum::before_after::before_and_after_table;
use crate::optimum::cancellation::{cancellation_headline, cancellation_proof_table, cancelled_orders_table};
use crate::optimum::consequence_text::consequence_words;
use crate::optimum::durable::moved_words;
use crate::optimum::effect_noise::effect_noise;
use crate::optimum::give_up::give_up_words;
use crate::optimum::tables::{
    closest_table, found_inertias_table, found_shafts_table, found_weights_table, limits_table, stage_name,
    stages_table, web_bounds_table,
};
use lanchester_balance::{
    Answer, BalanceSettings, Consequences, Durable, FoundStage, JudgedSpeeds, Method, Outcome, SearchState,
};
use lanchester_model::Engine;
use lanchester_task::{Criterion, criterion_name, criterion_unit};
use std::fmt::Write;

/// What was found, its proof, its price and its effect, as aligned plain text without colour; `left` is the diagnosis
/// of the engine with the answer fitted, `consequences` what the answer does to it. Where `durable` moved the weights, they and what they do are told, and
/// the sentence and the proof of the optimum that they were moved from.
pub fn balance_text(
    engine: &Engine,
    answer: &Answer,
    durable: Option<&Durable>,
    consequences: Option<&Consequences>,
    left: &str,
) -> String {
    let mut out = String::with_capacity(4096);
    let rpm = number::terminal(number::rpm(answer.speed), 0);
    let others = [&answer.mount_speeds, &answer.mount_gas_speeds, &answer.gas_speeds];
    let others = others.iter().any(|judged| judged.is_some());
    let of = if others { "inertia loads" } else { "the loads of the range" };
    let _ = writeln!(out, "{} at {rpm} rpm, where {of} are largest", answer.engine);
    let _ = writeln!(out, "{}\n", method_words(answer));
    push_wrapped(&mut out, "", &headline(engine, answer));
    let moved = durable.filter(|found| found.is_moved()).map(|found| found.answer(answer));
    durable
        .map(moved_words)
        .filter(|words| !words.is_empty())
        .into_iter()
        .for_each(|words| push_wrapped(&mut out, "", words));
    let equals = equals_words(engine, answer);
    let effects = consequences.map_or_else(String::new, consequence_words);
    for words in [give_up_words(engine, answer), equals, effects].iter().filter(|words| !words.is_empty()) {
        push_wrapped(&mut out, "", words);
    }
    if let Outcome::Infeasible { closest, .. } = &answer.outcome {
        if !closest.is_empty() {
            let _ = write!(out, "\n{}", closest_table(engine, answer, closest).text());
        }
        return out;
    }
    let mut tables = Vec::new();
    let shown = moved.as_ref().unwrap_or(answer);
    if !shown.weights.is_empty() {
        tables.push(found_weights_table(shown));
        tables.extend(web_bounds_table(shown));
    }
    tables.extend(found_shafts_table(answer));
    tables.extend(found_inertias_table(answer));
    if let Some(cancellation) = &answer.cancellation {
        tables.push(cancelled_orders_table(engine, cancellation));
    }
    tables.extend(before_and_after_table(engine, shown, consequences));
    match &answer.cancellation {
        Some(cancellation) => tables.extend(cancellation_proof_table(engine, cancellation)),
        None if !answer.stages.is_empty() => tables.push(stages_table(engine, answer)),
        None => {}
    }
    tables.extend(limits_table(engine, answer));
    for table in tables {
        out.push('\n');
        out.push_str(&table.text());
    }
    if !left.is_empty() {
        out.push_str("\nWhat is left\n");
        push_wrapped(&mut out, "  ", left);
    }
    out
}

/// The answer in a sentence or two.
pub fn headline(engine: &Engine, answer: &Answer) -> String {
    let reached = || {
        let stages = answer.stages.iter().map(|stage| reached_words(engine, answer, stage));
        stages.collect::<Vec<_>>().join(", then ")
    };
    if let Some(cancellation) = &answer.cancellation {
        return cancellation_headline(engine, answer, cancellation);
    }
    match &answer.outcome {
        Outcome::CannotVanish { reason } => format!("{reason}."),
        Outcome::Optimal if answer.stages.first().is_some_and(FoundStage::is_weighted_sum) => {
            let speeds = speeds_words(engine, answer);
            format!("{}.{speeds}{}", number::capital(&reached()), gap_words(answer))
        }
        Outcome::Optimal => {
            let given = answer.stages.iter().any(|stage| stage.give_up.is_some());
            let with = if given { " with what earlier stages give up" } else { "" };
            let (speeds, gap) = (speeds_words(engine, answer), gap_words(answer));
            format!("The minimum achievable with these devices{with}: {}.{speeds}{gap}", reached())
        }
        Outcome::Infeasible { relaxation, closest, .. } => no_answer(engine, answer, *relaxation, closest),
        Outcome::Stopped { reason, .. } if answer.stages.is_empty() => {
            format!("No answer was found: {reason}.")
        }
        Outcome::Stopped { reason, .. } => {
            let speeds = speeds_words(engine, answer);
            format!("The search stopped early ({reason}); the best so far: {}.{speeds}", reached())
        }
    }
}

/// At which speeds loads were judged that a higher speed need not raise, and where the largest stands.
fn speeds_words(engine: &Engine, answer: &Answer) -> String {
    let words = |(name, judged): (&str, &JudgedSpeeds)| {
        let rpm = |speed: f64| number::terminal(number::rpm(speed), 0);
        let (Some(&first), Some(&last)) = (judged.judged.first(), judged.judged.last()) else {
            return String::new();
        };
        let where_to = match (judged.range, judged.judged.len()) {
            (true, _) => "over the whole range of speeds".into(),
            _ if !judged.weights.is_empty() => {
                let times = |(speed, weight): (&f64, &f64)| format!("{} rpm times {weight}", rpm(*speed));
                let all: Vec<String> = judged.judged.iter().zip(&judged.weights).map(times).collect();
                format!("at weighted speeds: {}", all.join(", "))
            }
            (false, 1) => format!("at {} rpm", rpm(first)),
            (false, count) => format!("at {count} speeds from {} to {} rpm", rpm(first), rpm(last)),
        };
        let left = match judged.excess > 1.01e-6 {
            true => format!(" (a speed between passes the value by {})", number::terminal(judged.excess, 6)),
            false => String::new(),
        };
        let worst = match judged.range || judged.judged.len() > 1 {
            true => format!("; the largest is at {} rpm", rpm(judged.worst)),
            false => String::new(),
        };
        format!(" {name} count {where_to}{worst}{left}.")
    };
    let of_inertia = match engine.gas {
        Some(_) => "Forces of inertia at the mounts, without the gas,",
        None => "Forces at the mounts",
    };
    let all = [
        (of_inertia, &answer.mount_speeds),
        ("Forces at the mounts with gas", &answer.mount_gas_speeds),
        ("Main-bearing loads with gas", &answer.gas_speeds),
    ];
    if !answer.task.speeds.is_empty() && all.iter().all(|(_, judged)| judged.is_none()) {
        return " The given speeds decide nothing here: neither a mount force on springs nor a load with gas is minimised or \
                limited, and all other loads are largest at the highest speed."
            .into();
    }
    all.into_iter().filter_map(|(name, judged)| Some(words((name, judged.as_ref()?)))).collect()
}

/// How far the search went, where a wider gap than usual was asked for; empty elsewhere.
fn gap_words(answer: &Answer) -> String {
    let gap = answer.settings.gap;
    match answer.method {
        Method::BranchAndBound { .. } if gap > BalanceSettings::default().gap => {
            format!(" The search ended within the gap of {} % that was asked for.", 100.0 * gap)
        }
        _ => String::new(),
    }
}

/// What a stage reached: `force 120 N (340 N as the file stands)`, or the least weighted sum and what it leaves of each term.
fn reached_words(engine: &Engine, answer: &Answer, stage: &FoundStage) -> String {
    let term = |(criterion, value): &(Criterion, f64)| {
        let before = answer.effects.iter().find(|e| e.criterion == *criterion).map(|e| e.before);
        let noise = effect_noise(engine, &answer.effects, criterion);
        let (value, before) = (clean(*value, noise), before.map(|value| clean(value, noise)));
        let unit = criterion_unit(criterion);
        let name = criterion_name(criterion, engine);
        match before {
            Some(before) => format!(
                "{name} {} {unit} ({} {unit} as given)",
                number::short(value, 5),
                number::short(before, 5)
            ),
            None => format!("{name} {} {unit}", number::short(value, 5)),
        }
    };
    let terms: Vec<String> = stage.terms.iter().map(term).collect();
    if !stage.is_weighted_sum() {
        return terms.join(", ");
    }
    format!(
        "least weighted sum {} ({}); it leaves {}",
        number::short(stage.value, 5),
        stage_name(engine, stage),
        terms.join(" and ")
    )
}

/// Where a search stands: its stage, best value, bound, gap and nodes.
pub fn search_state_words(engine: &Engine, state: &SearchState) -> String {
    let nodes = format!("{} node{}", state.nodes, if state.nodes == 1 { "" } else { "s" });
    let Some(stage) = state.stage else {
        return format!("how far the limits must be relaxed: {nodes}");
    };
    let (name, unit) = match stage.terms[..] {
        [(1.0, criterion)] => {
            (criterion_name(&criterion, engine), format!(" {}", criterion_unit(&criterion)))
        }
        _ => ("weighted sum".to_owned(), String::new()),
    };
    let bound = number::terminal(state.bound, number::decimals(state.bound, 6));
    let reached = match state.value {
        Some(value) => {
            let gap = 100.0 * (value - state.bound) / value.abs().max(f64::MIN_POSITIVE);
            let value = number::terminal(value, number::decimals(value, 6));
            format!("best {value}{unit}, bound {bound}{unit}, gap {gap:.2e} %")
        }
        None => format!("no feasible point yet, bound {bound}{unit}"),
    };
    format!("stage {} of {} ({name}): {reached}, {nodes}", state.index + 1, state.stages)
}

/// What decided among answers that are equally good; empty where nothing but the weights did.
pub fn equals_words(engine: &Engine, answer: &Answer) -> String {
    let terms = answer.among_equals.iter().flat_map(|stage| &stage.terms).map(|(criterion, value)| {
        let value = clean(*value, effect_noise(engine, &answer.effects, criterion));
        let unit = criterion_unit(criterion);
        format!("the least {} ({} {unit})", criterion_name(criterion, engine), number::short(value, 5))
    });
    let terms: Vec<String> = terms.collect();
    match terms.is_empty() {
        true => String::new(),
        false => format!("Of all answers as good as that: {}, then the lightest.", terms.join(", then ")),
    }
}

/// Why limits cannot hold, and what would let them.
fn no_answer(engine: &Engine, answer: &Answer, relaxation: f64, closest: &[f64]) -> String {
    let limits = &answer.task.limits;
    if let (true, Outcome::Infeasible { reason, .. }) = (closest.is_empty(), &answer.outcome) {
        return match limits.is_empty() {
            true => format!("What is asked for contradicts itself: {reason}."),
            false => format!("{}.", number::capital(reason)),
        };
    }
    let mut out: String = limits
        .iter()
        .zip(closest)
        .filter(|(limit, closest)| **closest > limit.most)
        .map(|(limit, closest)| {
            let unit = criterion_unit(&limit.criterion);
            format!(
                "With these devices {} cannot go below {} {unit}; at most {} {unit} is asked. ",
                criterion_name(&limit.criterion, engine),
                number::short(*closest, 5),
                number::short(limit.most, 5)
            )
        })
        .collect();
    if limits.len() > 1 {
        out += match out.is_empty() {
            true => "Each limit can be held alone, but not all together. ",
            false => "",
        };
        if relaxation.is_finite() {
            let factor = number::short(relaxation, 4);
            out += &format!("All of them together need limits {factor} times as wide. ");
        }
    }
    out += "Widen the limit or allow more: another shaft, other planes, larger weights.";
    out
}

/// How the answer was found, in a sentence or two.
pub(crate) fn method_words(answer: &Answer) -> String {
    match answer.method {
        Method::Convex { solves: 0 } => "Solved as linear equations.".to_owned(),
        Method::Convex { solves: 1 } => "Solved as one convex programme.".to_owned(),
        Method::Convex { solves } => {
            format!("Solved as a convex programme, its angles refined {solves} times.")
        }
        Method::BranchAndBound { nodes, solves } => {
            let plural = |count: usize| if count == 1 { "" } else { "s" };
            let mut words = format!(
                "Solved by branch and bound, {nodes} node{}, {solves} convex programme{}.",
                plural(nodes),
                plural(solves)
            );
            let bounds = answer.stages.iter().map(|stage| {
                let bound = number::short(stage.lower_bound, 6);
                match stage.is_weighted_sum() {
                    true => format!("{bound} (weighted sum)"),
                    false => format!("{bound} {}", stage.unit),
                }
            });
            let bounds: Vec<String> = bounds.collect();
            if !bounds.is_empty() {
                let _ = write!(words, " No choice goes below {}.", bounds.join(", then "));
            }
            words
        }
    }
}
