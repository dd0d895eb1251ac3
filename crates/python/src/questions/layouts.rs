//! All layouts that the parts of an engine can make.

use super::studies::run_study;
use crate::answer::{Data, Shown};
use crate::blocks::{Blocks, Tabled};
use crate::failure::Failure;
use crate::options::Options;
use crate::prepared::Prepared;
use crate::question::{How, Question, Run};
use lanchester::file::expanded;
use lanchester::report::{layout_front_figure, layout_front_table, layout_ranking_table, layout_search_text};
use lanchester::results;
use lanchester::run::Head;
use lanchester::study::explore::{
    self, Constraint, CounterweightPattern, ExploreAnswer, ExploreRequest, Explorer, Objective, even_angles,
};
use lanchester::task::option;
use lanchester::{
    LayoutChoices, LayoutRows, LayoutSpace, LayoutStudy, SavedSearch, adopted_layout, given_engine,
    layout_space, own_pattern,
};
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::TAU;
use std::sync::Arc;

pub(super) const QUESTIONS: [Question; 1] = [Question::of::<Exploration>("explore", How::Long, read_explore)];

/// Pareto-optimal layouts, and what became of all others.
#[derive(Serialize, JsonSchema)]
struct Exploration {
    #[serde(flatten)]
    answer: ExploreAnswer,
    #[serde(skip)]
    #[schemars(skip)]
    explorer: Explorer,
}

/// The names of all objectives.
const NAMES: &str = "force order 1, couple order 2, forward force order 1, backward couple order 1, roll moment order 2, inertia \
                     torque order 1, bending moment, main-bearing load, uneven firing, firing order 1.5, neighbours, length, \
                     height, counterweights, shafts";

fn objective(text: &str, name: &str) -> Result<Objective, Failure> {
    let hint = || format!("objectives are {NAMES}; loads have orders 1 and 2");
    let output: results::Output =
        text.parse().map_err(|error| Failure::option(format_args!("`{name}`: {error}"), hint()))?;
    Objective::of(&output).ok_or_else(|| {
        Failure::option(format_args!("layouts are not judged by `{output}` (`{name}`)"), hint())
    })
}

/// `length = 500 mm`.
fn limit(text: &str) -> Result<Constraint, Failure> {
    let wrong = |message: String| {
        Failure::option(
            message,
            "write it like limit=\"length = 500 mm\" or limit=\"couple order 1 = 20 N m\"",
        )
    };
    let Some((name, value)) = text.split_once('=') else {
        return Err(wrong(format!("`limit` needs an objective and its largest value, got \"{text}\"")));
    };
    let objective = objective(name, "limit")?;
    let value = value.trim();
    let limit = match objective.unit() {
        "m" => option::length(value, "limit")?,
        "rad" => option::angle(value, "limit")?,
        "kg m" => option::unbalance(value, "limit")?,
        "N m" => option::torque(value, "limit")?,
        "N" => option::of_dimension(
            value,
            lanchester::units::Dimension::Force,
            lanchester::units::Bound::NotNegative,
            "limit",
        )?,
        _ => value
            .parse()
            .map_err(|_| wrong(format!("the limit of {} is a plain number, got `{value}`", name.trim())))?,
    };
    Ok(Constraint::AtMost { objective, limit })
}

/// Weights on the webs: `none`, `full`, `own`, or shares of the rotating and reciprocating mass, `100 % + 50 %`; behind ` on ` a 0 or a 1 for each web.
#[derive(Clone)]
enum Pattern {
    Own(String),
    Plain(CounterweightPattern),
}

fn pattern(text: &str) -> Result<Pattern, Failure> {
    let (shares, webs) = match text.split_once(" on ") {
        Some((shares, webs)) => (shares.trim(), Some(webs.trim())),
        None => (text.trim(), None),
    };
    let share = |text: &str| option::share(text.trim(), "counterweights").map_err(Failure::from);
    let webs = match webs {
        None => None,
        Some(webs) if !webs.is_empty() && webs.chars().all(|digit| matches!(digit, '0' | '1')) => {
            Some(webs.chars().map(|digit| digit == '1').collect())
        }
        Some(webs) => {
            return Err(Failure::option(
                format_args!(
                    "`counterweights` needs a 0 or a 1 for each web, from the free end, got `{webs}`"
                ),
                "write it like \"full on 100001\": two webs a throw, or pair",
            ));
        }
    };
    let plain = |rotating, reciprocating| {
        let webs = webs.clone();
        Pattern::Plain(CounterweightPattern { name: text.trim().to_owned(), rotating, reciprocating, webs })
    };
    Ok(match (shares, shares.split_once('+')) {
        ("none", _) => plain(0.0, 0.0),
        ("full", _) => plain(1.0, 0.0),
        ("own", _) if webs.is_none() => Pattern::Own(text.trim().to_owned()),
        ("own", _) => {
            return Err(Failure::option(
                "`counterweights` has the webs of `own` from the engine, got others",
                "leave \" on \" out, or write shares such as \"100 % + 50 % on 1001\"",
            ));
        }
        (_, Some((rotating, reciprocating))) => plain(share(rotating)?, share(reciprocating)?),
        (only, None) => plain(share(only)?, 0.0),
    })
}

/// A list of angles, or `every 30 deg`.
fn throw_angles(options: &Options<'_>) -> Result<Option<Vec<f64>>, Failure> {
    let texts = options.texts("throw_angles").unwrap_or_default();
    let [every] = texts.as_slice() else { return given(options.angles("throw_angles")?) };
    let Some(step) = every.trim().strip_prefix("every ") else {
        return given(options.angles("throw_angles")?);
    };
    let angle = option::angle(step, "throw_angles")?;
    let parts = TAU / angle;
    if !(angle > 0.0 && parts <= 4096.5 && (parts - parts.round()).abs() < 1e-6) {
        return Err(Failure::option(
            format_args!(
                "`throw_angles` needs a step that divides the turn, into at most 4096 parts, got \"{step}\""
            ),
            "write \"every 30 deg\", \"every 22.5 deg\", or a list of angles",
        ));
    }
    Ok(Some(even_angles(parts.round() as u32)))
}

fn given<T>(list: Vec<T>) -> Result<Option<Vec<T>>, Failure> {
    Ok((!list.is_empty()).then_some(list))
}

/// What becomes a search once the engine is known.
type Prepare =
    Box<dyn Fn(&Arc<Prepared>, LayoutRows) -> Result<(LayoutStudy, Vec<String>), Failure> + Send + Sync>;

/// The search behind the arguments, with what the user should know of it.
fn search(options: &Options<'_>) -> Result<Prepare, Failure> {
    let mut constraints = Vec::new();
    if let Some(tolerance) = options.angle("even_firing")? {
        constraints.push(Constraint::EvenFiring { tolerance });
    }
    if let Some(least) = options.length("bearing_room")? {
        constraints.push(Constraint::BearingRoom { least });
    }
    if let Some(least) = options.length("pin_overlap")? {
        constraints.push(Constraint::PinOverlap { least });
    }
    let even = !constraints.is_empty() && matches!(constraints[0], Constraint::EvenFiring { .. });
    for text in options.texts("limit")? {
        constraints.push(limit(&text)?);
    }
    let without_firing = options.flag("without_firing")?.unwrap_or(false);
    let minimise = options.texts("minimise")?;
    let mut objectives =
        minimise.iter().map(|text| objective(text, "minimise")).collect::<Result<Vec<_>, _>>()?;
    if let Some(twice) = (1..objectives.len()).find(|k| objectives[..*k].contains(&objectives[*k])) {
        return Err(Failure::option(
            format_args!("`minimise` names {} twice", objectives[twice].name()),
            "name it once",
        ));
    }
    if objectives.is_empty() {
        let loads = |order| [Objective::Force { order }, Objective::Couple { order }];
        objectives = [1, 2].into_iter().flat_map(loads).collect();
        if !even && !without_firing {
            objectives.push(Objective::FiringUnevenness);
        }
    }
    let patterns =
        options.texts("counterweights")?.iter().map(|text| pattern(text)).collect::<Result<Vec<_>, _>>()?;
    let choices = LayoutChoices {
        speed: options.speed("speed")?,
        cylinders: options.whole("cylinders", 1, 24)?.map(|count| count as usize),
        in_line: options.flag("in_line")?.unwrap_or(false),
        bank_angles: given(options.angles("bank_angle")?)?,
        split_angles: given(options.angles("split_angle")?)?,
        staggers: given(options.lengths("stagger")?)?,
        spacings: given(options.lengths("spacing")?)?,
        rod_ratios: given(options.numbers("rod_ratio")?)?,
        throw_angles: throw_angles(options)?,
        counterweights: None,
        shafts: None,
        without_firing,
        web_distance: options.length("web_distance")?,
        web_thickness: options.length("web_thickness")?,
        pin_diameter: options.length("pin_diameter")?,
        end_length: options.length("ends")?,
    };
    let most_cases = options.whole("max_cases", 1, u64::MAX)?;
    let most_on_front = options.whole("max_on_front", 1, 1 << 20)?;
    Ok(Box::new(move |own, rows| {
        let engine = own.engine();
        let mut choices = choices.clone();
        choices.counterweights = given(
            patterns
                .iter()
                .map(|pattern| match pattern {
                    Pattern::Own(name) => CounterweightPattern { name: name.clone(), ..own_pattern(engine) },
                    Pattern::Plain(pattern) => pattern.clone(),
                })
                .collect(),
        )?;
        let LayoutSpace { space, notes } =
            layout_space(engine, &choices, &constraints).map_err(Failure::refused)?;
        let mut request = ExploreRequest::new(space, objectives.clone(), constraints.clone());
        if let Some(most) = most_cases {
            request.most_cases = most.into();
        }
        if let Some(most) = most_on_front {
            request.most_on_front = most as usize;
        }
        let explorer = Explorer::new(request).map_err(Failure::refused)?;
        Ok((LayoutStudy { explorer, rows }, notes))
    }))
}

fn read_explore(options: &Options<'_>) -> Result<Run, Failure> {
    let prepare = search(options)?;
    Ok(Box::new(move |engines, watch| {
        let own = &engines[0];
        let (study, notes) = prepare(own, LayoutRows::Nothing)?;
        let found = run_study(&study, watch)?;
        answer(own, &study.explorer, &found, &notes)
    }))
}

/// The same search with its cases as rows, in blocks.
pub fn explore_blocks(options: &Options<'_>, own: &Arc<Prepared>) -> Result<Box<dyn Blocks>, Failure> {
    let words = [("judged", LayoutRows::Judged), ("front", LayoutRows::Front)];
    let rows = options.word("rows", &words)?.unwrap_or(LayoutRows::Judged);
    let (study, notes) = search(options)?(own, rows)?;
    let request = study.explorer.request().clone();
    let head = Head::new("explore", &SavedSearch { request, rows, notes: notes.clone() }, &own.text)?;
    let own = own.clone();
    Ok(Box::new(Tabled {
        study,
        head,
        fail: Failure::refused,
        answer: Box::new(move |study, found| answer(&own, &study.explorer, found, &notes).map(Some)),
    }))
}

fn answer(
    own: &Arc<Prepared>,
    explorer: &Explorer,
    found: &explore::Exploration,
    notes: &[String],
) -> Result<Data, Failure> {
    let engine = own.engine();
    let mut answer = explorer.answer(found, &engine.name, notes.to_vec()).map_err(Failure::refused)?;
    answer.given = Some(given_engine(engine, explorer, &answer).map_err(Failure::refused)?);
    Ok(Data::new(
        Exploration { answer, explorer: explorer.clone() },
        own,
        Shown {
            text: |found, _| layout_search_text(&found.answer, 20, false),
            tables: |found, _| vec![layout_front_table(&found.answer), layout_ranking_table(&found.answer)],
            figures: |found, _| match found.answer.front.is_empty() {
                true => Vec::new(),
                false => vec![layout_front_figure(&found.answer)],
            },
            adopted: Some(adopted),
            choices: |found| found.answer.front.len(),
            ..Shown::default()
        },
    ))
}

/// A layout of the front by its index, from 0.
fn adopted(found: &Exploration, own: &Prepared, number: usize) -> Result<Arc<Prepared>, Failure> {
    let front = &found.answer.front;
    let Some(layout) = front.get(number) else {
        return Err(Failure::option(
            format_args!("there is no layout {number} on a front of {}", front.len()),
            "they are counted from 0, as in `front`",
        ));
    };
    let engine =
        adopted_layout(own.engine(), &found.explorer, layout.layout.case).map_err(Failure::refused)?;
    own.with_text(expanded(&engine.into()))
}
