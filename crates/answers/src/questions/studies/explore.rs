//! Layouts that the parts of an engine can make, and the Pareto-optimal ones.

use super::turn::{SoFar, Turn, estimate, turn};
use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::{NewText, engine};
use lanchester::file::expanded;
use lanchester::model::Engine;
use lanchester::report::layout_search_words;
use lanchester::results::Output;
use lanchester::study::explore::{
    Constraint, CounterweightPattern, Exploration, ExploreAnswer, ExploreRequest, Explorer, FoundLayout,
    Objective, even_angles,
};
use lanchester::{
    LayoutChoices, LayoutRows, LayoutSpace, LayoutStudy, adopted_layout, given_engine, layout_name,
    layout_space, own_pattern,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Layouts of the front that are sent.
const MOST_ROWS: usize = 2000;
/// Most parts of a turn that throws stand at.
const MOST_PARTS: u32 = 4096;

/// Which layouts, and what they are judged by. What is left out is as in the file.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct LayoutQuestion {
    /// The engine file.
    text: String,
    /// Speed of the crankshaft [rad/s]; the highest of the engine where it is left out.
    #[serde(default)]
    speed: Option<f64>,
    /// Number of cylinders.
    #[serde(default)]
    cylinders: Option<usize>,
    /// One bank, whatever the engine has.
    #[serde(default)]
    in_line: bool,
    /// Angles between two banks [rad].
    #[serde(default)]
    bank_angles: Option<Vec<f64>>,
    /// How far the pin of bank 2 stands ahead of that of bank 1 [rad].
    #[serde(default)]
    split_angles: Option<Vec<f64>>,
    /// Equal parts of a turn at which throws may stand; usually 12, or as many as even firing needs.
    #[serde(default)]
    throw_parts: Option<u32>,
    /// Weights on the webs; those of the file where there are none.
    #[serde(default)]
    counterweights: Vec<WebWeights>,
    /// Leave the firing orders out.
    #[serde(default)]
    without_firing: bool,
    /// Only layouts that fire evenly.
    #[serde(default)]
    even_firing: bool,
    /// Objectives by their names, as `--minimise` takes them; the usual ones where there are none.
    #[serde(default)]
    minimise: Vec<String>,
    /// Largest values of objectives.
    #[serde(default)]
    limits: Vec<LayoutLimit>,
}

/// Weights on the webs of a layout.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum WebWeights {
    /// As much as the file has, on all webs alike.
    Own,
    /// None.
    None,
    /// All of what turns.
    Full,
    /// All of what turns and half of the reciprocating masses.
    Half,
}

/// The largest value of an objective.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct LayoutLimit {
    /// Its name, as `--minimise` takes it.
    objective: String,
    /// The largest value, in SI units.
    most: f64,
}

/// A search, and how far it has come.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct LayoutTurn {
    /// What is searched.
    search: LayoutQuestion,
    /// Where the turn before ended; nothing for the first one.
    #[serde(default)]
    so_far: Option<SoFar>,
}

/// One layout of a search.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ChosenLayout {
    /// What was searched.
    search: LayoutQuestion,
    /// Number of its case.
    case: u64,
}

/// How large a search is.
#[derive(Debug, Serialize, JsonSchema)]
struct SearchSize {
    /// Cases.
    cases: u64,
    /// What varies, and in how many values.
    choices: Vec<VariedChoice>,
    /// How long the search takes [s], from a small part of it.
    seconds: f64,
    /// What it is judged by, by name.
    minimise: Vec<String>,
    /// What was assumed.
    notes: Vec<String>,
}

/// A choice of a search with more than one value.
#[derive(Debug, Serialize, JsonSchema)]
struct VariedChoice {
    /// Its name.
    name: String,
    /// Number of its values.
    values: u64,
}

/// A turn of a search, with the answer where it was the last one.
#[derive(Debug, Serialize, JsonSchema)]
struct SearchTurn {
    #[serde(flatten)]
    turn: Turn,
    /// What was found in the whole space.
    found: Option<FoundLayouts>,
}

/// Layouts of a space that no other one beats in all objectives.
#[derive(Debug, Serialize, JsonSchema)]
struct FoundLayouts {
    /// What the layouts are judged by.
    objectives: Vec<LayoutObjective>,
    /// Space, what became of its cases, and notes, in words.
    words: String,
    /// Layouts on the front.
    on_front: usize,
    /// The front by its first objective, up to 2000 of them.
    front: Vec<LayoutRow>,
    /// Objectives of some of the judged layouts, evenly from all of them, in SI units.
    sample: Vec<Vec<f64>>,
    /// Objectives of the engine of the file; `null` where it does not tell.
    own: Vec<Option<f64>>,
    /// Layouts of the front that are better than the engine in some objective, and in none worse.
    beaten_by: Vec<usize>,
    /// Layout of the front with the objectives of the engine.
    equals: Option<usize>,
    /// Why nothing is on the front.
    empty: Option<String>,
}

/// An objective of a search.
#[derive(Debug, Serialize, JsonSchema)]
struct LayoutObjective {
    /// Its name.
    name: String,
    /// Its SI unit, empty for a plain number.
    unit: &'static str,
}

/// A layout of the front.
#[derive(Debug, Serialize, JsonSchema)]
struct LayoutRow {
    /// Its number on the front, from 1.
    number: usize,
    /// Number of its case.
    case: u64,
    /// Cylinders and banks in words.
    name: String,
    /// Angle of each throw from the first [rad].
    throws: Vec<f64>,
    /// Cylinders as they fire; `null` where firing is left out.
    firing_order: Option<Vec<usize>>,
    /// Weights on the webs.
    counterweights: String,
    /// Objectives in SI units; what is rounding of the masses' loads is 0.
    values: Vec<f64>,
    /// Cases with equal objectives, this one included.
    alike: u64,
}

pub(super) fn questions(api: Api) -> Api {
    api.post("/api/explore/size", "How large a search over layouts is, before it starts.", size)
        .post("/api/explore", "A turn of a search over layouts: `lanchester explore`.", explored)
        .post("/api/explore/adopt", "A layout as an engine file: `lanchester explore --adopt`.", adopted)
}

fn size(asker: &Asker, question: LayoutQuestion) -> Result<SearchSize, Problem> {
    let (explorer, notes) = search(&engine(&question.text)?, &question)?;
    let request = explorer.request();
    let choices = request.space.choices().into_iter();
    let choices = choices
        .map(|count| VariedChoice { name: count.choice.name().to_string(), values: whole(count.values) });
    let (choices, minimise) =
        (choices.collect(), request.objectives.iter().map(|objective| objective.name()).collect());
    let cases = whole(explorer.size());
    let seconds = estimate(asker, &LayoutStudy { explorer, rows: LayoutRows::Nothing })?;
    Ok(SearchSize { cases, choices, seconds, minimise, notes })
}

fn explored(asker: &Asker, question: LayoutTurn) -> Result<SearchTurn, Problem> {
    let LayoutTurn { search: asked, so_far } = question;
    let engine = engine(&asked.text)?;
    let (explorer, notes) = search(&engine, &asked)?;
    let study = LayoutStudy { explorer, rows: LayoutRows::Nothing };
    let (turn, whole) = turn(asker, &study, so_far)?;
    let found = whole.map(|whole| found(&engine, &study.explorer, &whole, notes)).transpose()?;
    Ok(SearchTurn { turn, found })
}

fn found(
    engine: &Engine,
    explorer: &Explorer,
    whole: &Exploration,
    notes: Vec<String>,
) -> Result<FoundLayouts, Problem> {
    let answer = explorer.answer(whole, &engine.name, notes).map_err(Problem::refused)?;
    let given = given_engine(engine, explorer, &answer).map_err(Problem::refused)?;
    let own = match given.values.iter().copied().collect::<Option<Vec<f64>>>() {
        Some(known) => shown(explorer, &known).into_iter().map(Some).collect(),
        None => given.values,
    };
    let objectives = answer.objectives.iter();
    Ok(FoundLayouts {
        objectives: objectives
            .map(|judged| LayoutObjective { name: judged.name.clone(), unit: judged.unit })
            .collect(),
        words: layout_search_words(&answer),
        on_front: answer.front.len(),
        front: answer.front.iter().take(MOST_ROWS).map(|layout| row(explorer, layout)).collect(),
        sample: answer.sample.iter().map(|judged| shown(explorer, &judged.values)).collect(),
        own,
        beaten_by: given.beaten_by,
        equals: given.equals,
        empty: emptied(&answer),
    })
}

fn emptied(answer: &ExploreAnswer) -> Option<String> {
    let why = || answer.counts.emptied_by().unwrap_or_else(|| "no layout was judged".to_string());
    answer.front.is_empty().then(why)
}

fn row(explorer: &Explorer, found: &FoundLayout) -> LayoutRow {
    LayoutRow {
        number: found.number,
        case: whole(found.layout.case),
        name: layout_name(&found.layout),
        throws: found.layout.throw_angles.clone(),
        firing_order: found.firing_order.clone(),
        counterweights: found.layout.counterweights.name.clone(),
        values: shown(explorer, &found.values),
        alike: whole(found.alike),
    }
}

/// Values of which what is below the resolution of the search is 0.
fn shown(explorer: &Explorer, values: &[f64]) -> Vec<f64> {
    let steps = explorer.steps(values);
    values.iter().zip(steps).map(|(value, step)| if step == 0 { 0.0 } else { *value }).collect()
}

/// A count; searches are refused long before it is too large.
fn whole(count: u128) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}

fn adopted(_: &Asker, question: ChosenLayout) -> Result<NewText, Problem> {
    let engine = engine(&question.search.text)?;
    let (explorer, _) = search(&engine, &question.search)?;
    let adopted = adopted_layout(&engine, &explorer, question.case.into()).map_err(Problem::refused)?;
    Ok(NewText { text: expanded(&adopted.into()) })
}

fn search(engine: &Engine, question: &LayoutQuestion) -> Result<(Explorer, Vec<String>), Problem> {
    let mut constraints = Vec::new();
    if question.even_firing {
        constraints.push(Constraint::EvenFiring { tolerance: 0.0 });
    }
    for LayoutLimit { objective: name, most } in &question.limits {
        constraints.push(Constraint::AtMost { objective: objective(name)?, limit: *most });
    }
    let LayoutSpace { space, notes } =
        layout_space(engine, &choices(engine, question)?, &constraints).map_err(Problem::refused)?;
    let objectives = match question.minimise[..] {
        [] => usual(question),
        _ => question.minimise.iter().map(|name| objective(name)).collect::<Result<_, _>>()?,
    };
    let request = ExploreRequest::new(space, objectives, constraints);
    Ok((Explorer::new(request).map_err(Problem::refused)?, notes))
}

/// What layouts are judged by where nothing else is said.
fn usual(question: &LayoutQuestion) -> Vec<Objective> {
    let loads = |order| [Objective::Force { order }, Objective::Couple { order }];
    let firing = !question.even_firing && !question.without_firing;
    let firing = firing.then_some(Objective::FiringUnevenness);
    [1, 2].into_iter().flat_map(loads).chain(firing).collect()
}

fn objective(name: &str) -> Result<Objective, Problem> {
    let refused = |what: String| {
        Problem::refused(format!(
            "{what}\nhint: name force, couple, roll moment or inertia torque with order 1 or 2, bending moment, main-bearing load, uneven firing, neighbours, length, height, counterweights"
        ))
    };
    let output: Output = name.parse().map_err(|error| refused(format!("{error}")))?;
    Objective::of(&output).ok_or_else(|| refused(format!("layouts are not judged by `{output}`")))
}

fn choices(engine: &Engine, question: &LayoutQuestion) -> Result<LayoutChoices, Problem> {
    let throw_angles = match question.throw_parts {
        Some(parts) if (1..=MOST_PARTS).contains(&parts) => Some(even_angles(parts)),
        Some(parts) => {
            return Err(Problem::refused(format!(
                "throws stand at 1 to {MOST_PARTS} equal parts of a turn, got {parts}\nhint: 12 parts are every 30 degrees"
            )));
        }
        None => None,
    };
    let patterns: Vec<CounterweightPattern> =
        question.counterweights.iter().map(|own| pattern(engine, *own)).collect();
    Ok(LayoutChoices {
        speed: question.speed,
        cylinders: question.cylinders,
        in_line: question.in_line,
        bank_angles: question.bank_angles.clone(),
        split_angles: question.split_angles.clone(),
        throw_angles,
        counterweights: (!patterns.is_empty()).then_some(patterns),
        without_firing: question.without_firing,
        ..LayoutChoices::default()
    })
}

fn pattern(engine: &Engine, weights: WebWeights) -> CounterweightPattern {
    let named = |name: &str, rotating, reciprocating| CounterweightPattern {
        name: name.to_string(),
        rotating,
        reciprocating,
        webs: None,
    };
    match weights {
        WebWeights::Own => CounterweightPattern { name: "own".to_string(), ..own_pattern(engine) },
        WebWeights::None => named("none", 0.0, 0.0),
        WebWeights::Full => named("full", 1.0, 0.0),
        WebWeights::Half => named("100 % + 50 %", 1.0, 0.5),
    }
}
