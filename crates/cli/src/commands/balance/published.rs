//! `lanchester balance --method`: a published method, what it leaves, and the true optimum beside it.

use crate::arguments::{BalanceArguments, BalanceMethod, BalanceTable};
use crate::commands::balance::found::WithConsequences;
use crate::commands::{Opened, json};
use crate::failure::{DONE, Failure};
use crate::files::{print, write_result};
use crate::format::Format;
use crate::options::published::MatrixShafts;
use lanchester::balance::Consequences;
use lanchester::literature::{
    Alpha, AngleRule, BalanceFactor, BalancerPhase, MatrixMethod, MethodAnswer, PublishedMethod,
    SHAFT_DISTANCE, ShaftPair, largest_radius, outer_throws,
};
use lanchester::mechanism::{LoadRequest, loads};
use lanchester::model::Engine;
use lanchester::report::{
    consequence_figures, consequences_table, crank_view, method_effects_table, method_orders_table,
    method_text, method_weights_table, share_plots, stages_table,
};
use lanchester::task::option;

/// Whether a published method is asked for, and not the optimum. Options of the one do not go with the other.
pub fn asked_for(arguments: &BalanceArguments) -> Result<bool, Failure> {
    let options = &arguments.published;
    let of_methods = [
        ("--webs", options.webs.is_some()),
        ("--alpha", options.alpha.is_some()),
        ("--counterweight-radius", options.counterweight_radius.is_some()),
        ("--shafts", options.shafts.is_some()),
        ("--first-on-crank", options.first_on_crank),
        ("--shaft-radius", options.shaft_radius.is_some()),
        ("--shaft-length", options.shaft_length.is_some()),
        ("--shaft-distance", options.shaft_distance.is_some()),
        ("--balance-factor", options.balance_factor.is_some()),
        ("--as-printed", options.as_printed),
    ];
    let of_the_optimum = [
        ("--limit", !arguments.limit.is_empty()),
        ("--cancel", !arguments.cancel.is_empty()),
        ("--counterweights", arguments.counterweights.is_some()),
        ("--max-unbalance", arguments.most.is_some()),
        ("--shaft", !arguments.shaft.is_empty()),
    ];
    let first = |given: &[(&'static str, bool)]| given.iter().find(|(_, on)| *on).map(|(name, _)| *name);
    let wrong = match arguments.method {
        BalanceMethod::Matrix => options.balance_factor.is_some().then_some("--balance-factor"),
        BalanceMethod::Half => first(&of_methods[..6]),
        _ => {
            return match first(&of_methods) {
                Some(name) => Err(Failure::input(
                    format!("{name} is a choice of a published method, and none that has it is asked for"),
                    "add --method matrix or --method half",
                )),
                None => Ok(false),
            };
        }
    };
    if let Some(name) = wrong {
        return Err(Failure::input(
            format!("{name} is no choice of this method"),
            "`lanchester balance --help` tells which method has it",
        ));
    }
    match first(&of_the_optimum) {
        Some(name) => Err(Failure::input(
            format!("{name} belongs to the optimum; a published method has its own devices"),
            "leave it or --method out",
        )),
        None => Ok(true),
    }
}

/// Fits the method that the options choose.
pub fn fit(engine: &Engine, arguments: &BalanceArguments) -> Result<MethodAnswer, Failure> {
    let method = method(engine, arguments)?;
    let stage = |text: &String| option::stage(text, engine, "--minimise").map_err(Failure::from);
    let stages = arguments.minimise.iter().map(stage).collect::<Result<Vec<_>, Failure>>()?;
    method.fit(engine, &stages).map_err(Failure::refused)
}

/// Writes the figures, if asked for, and prints the answer.
pub fn tell(
    opened: &Opened,
    arguments: &BalanceArguments,
    answer: &MethodAnswer,
    effect: &Consequences,
) -> Result<u8, Failure> {
    let engine = &opened.file.engine;
    if let Some(folder) = &arguments.figures {
        let of_method = loads(&answer.fitted, &LoadRequest::default()).map_err(crate::commands::refused)?;
        let figures = crank_view(&answer.fitted).into_iter().chain(share_plots(&answer.fitted, &of_method));
        let figures = figures.chain(consequence_figures(&answer.fitted, effect));
        for figure in figures {
            write_result(&folder.join(format!("{}.svg", figure.id)), &arguments.file, &figure.svg())?;
        }
    }
    print(&match (arguments.format, arguments.table) {
        (Format::Text, _) => arguments.printed.led(method_text(engine, answer, effect)),
        (Format::Json, _) => json(&WithConsequences { answer, consequences: Some(effect) })?,
        (Format::Csv, table) => arguments.printed.csv(match table.unwrap_or(BalanceTable::Weights) {
            BalanceTable::Weights => method_weights_table(answer).csv(),
            BalanceTable::Effects => method_effects_table(engine, answer).csv(),
            BalanceTable::Consequences => consequences_table(effect).csv(),
            BalanceTable::Orders => method_orders_table(answer).csv(),
            BalanceTable::Stages => stages_table(engine, &answer.optimum).csv(),
            BalanceTable::Limits | BalanceTable::Durability | BalanceTable::Proof => {
                return Err(Failure::input(
                    "a published method has no such table",
                    "take --table weights, effects, consequences, orders or stages",
                ));
            }
        }),
    })?;
    Ok(DONE)
}

fn method(engine: &Engine, arguments: &BalanceArguments) -> Result<PublishedMethod, Failure> {
    let options = &arguments.published;
    let length = |text: &Option<String>, option: &str, default: f64| match text {
        Some(text) => option::length(text, option).map_err(Failure::from),
        None => Ok(default),
    };
    let shaft_length = length(&options.shaft_length, "--shaft-length", outer_throws(engine))?;
    let distance = length(&options.shaft_distance, "--shaft-distance", SHAFT_DISTANCE)?;
    if arguments.method == BalanceMethod::Matrix {
        let radius = length(&options.counterweight_radius, "--counterweight-radius", largest_radius(engine))?;
        let shaft_radius = length(&options.shaft_radius, "--shaft-radius", radius)?;
        let pair = |y: f64| {
            Some(ShaftPair { radius: shaft_radius, length: shaft_length, forward_y: y, backward_y: -y })
        };
        let shafts = options.shafts.unwrap_or(MatrixShafts::Both);
        let alpha = match &options.alpha {
            Some(text) => Alpha::Given(option::angle(text, "--alpha").map_err(Failure::from)?),
            None => Alpha::Fitted,
        };
        let matrix = MatrixMethod {
            web_pattern: web_pattern(options.webs.as_deref().unwrap_or(""))?,
            alpha,
            counterweight_radius: radius,
            first: matches!(shafts, MatrixShafts::Both | MatrixShafts::First)
                .then(|| pair(distance))
                .flatten(),
            second: matches!(shafts, MatrixShafts::Both | MatrixShafts::Second)
                .then(|| pair(2.0 * distance))
                .flatten(),
            first_on_crank: options.first_on_crank,
        };
        return Ok(match options.as_printed {
            true => PublishedMethod::MatrixAsPrinted(matrix, AngleRule::WholeRadians),
            false => PublishedMethod::Matrix(matrix),
        });
    }
    if let Some(share) = &options.balance_factor {
        let share = option::share(share, "--balance-factor").map_err(Failure::from)?;
        return Ok(PublishedMethod::Factor(BalanceFactor(share)));
    }
    let phase = match options.as_printed {
        true => BalancerPhase::OppositeFirstThrow,
        false => BalancerPhase::CouplePeak,
    };
    let found = PublishedMethod::half_rule(engine, shaft_length, distance, phase);
    if options.as_printed && !matches!(found, PublishedMethod::ThreeCylinder(_)) {
        return Err(Failure::input(
            "--as-printed is for the balancer of an in-line three, and this engine has another rule",
            "leave it out",
        ));
    }
    Ok(found)
}

fn web_pattern(text: &str) -> Result<Vec<bool>, Failure> {
    let web = |c: char| match c {
        '0' => Ok(false),
        '1' => Ok(true),
        _ => Err(Failure::input(
            format!("--webs needs 1 or 0 for every web, got `{text}`"),
            "write it like --webs 110011: two webs a throw, from the free end",
        )),
    };
    text.chars().map(web).collect()
}
