//! The best weights and shafts, and which arrangement: the answers of `balance`.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::{NewText, engine, engine_file};
use crate::state::superseded;
use lanchester::balance::{
    Answer, ArrangementRequest, Arrangements, BalanceError, BalanceSettings, Consequences, DriveRule, Judged,
    Next, Outcome, RobustMeasure, SearchState, Target, arrangements, fitted, searched_engine,
};
use lanchester::file::{EngineFile, write_back};
use lanchester::mechanism::{LoadRequest, Loads, loads};
use lanchester::model::Engine;
use lanchester::report::{consequence_words, durability_text, headline, moved_words, robust_text};
use lanchester::task::{
    BalanceTask, ChangedTask, CrankWeightPlaces, FreeShaft, FreeWeight, Place, RoomFault, Seat, TaskOptions,
    crank_weights, default_task, option,
};
use lanchester::{
    DurableOptions, RobustError, RobustOptions, WebBoundError, durable_balance, optimise_on_webs,
    robust_balance_while,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What may be changed, and what is wanted.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct BalanceQuestion {
    /// The engine file.
    text: String,
    /// Which weights are free.
    #[serde(default)]
    free: Free,
    /// Names of counterweights and shafts that stay as they are, with `free = "devices"`.
    #[serde(default)]
    locked: Vec<String>,
    /// Criteria in their order, as `--minimise` takes them; none: force, then couple.
    #[serde(default)]
    minimise: Vec<String>,
    /// What stages give up for those after them, as `--give-up` takes it.
    #[serde(default)]
    give_up: Vec<String>,
    /// Limits as `--limit` takes them.
    #[serde(default)]
    limits: Vec<String>,
    /// Oil films and safeties that must not fall below a value, as `--at-least` takes them.
    #[serde(default)]
    at_least: Vec<String>,
    /// Oil films and safeties that are to be large, as `--maximise` takes them.
    #[serde(default)]
    maximise: Vec<String>,
    /// Orders that must vanish, as `--cancel` takes them.
    #[serde(default)]
    cancel: Vec<String>,
    /// Shafts that are added, as `--shaft` takes them: `-1 @ 0 mm, 100 mm @ -30 mm, 30 mm` is ratio @ x, y of the axis @ planes.
    #[serde(default)]
    shafts: Vec<String>,
    /// Least unbalance of every free weight on a crankshaft that is used, as `--min-unbalance` takes it.
    #[serde(default)]
    least: Option<String>,
    /// Largest unbalance of every free weight on a crankshaft, as `--max-unbalance` takes it.
    #[serde(default)]
    most: Option<String>,
    /// Step in which every free weight on a crankshaft is made, as `--weight-step` takes it.
    #[serde(default)]
    step: Option<String>,
    /// Whether all free weights on crankshafts have the same amount of their steps or lists, as `--equal-parts`.
    #[serde(default)]
    equal_parts: bool,
    /// Largest cost of all that is used, as `--budget` takes it.
    #[serde(default)]
    budget: Option<String>,
    /// Speeds at which forces at mounts with springs and loads with gas count, as `--speed` takes them; none: the range of the file.
    #[serde(default)]
    speeds: Vec<String>,
    /// Engines drawn within the tolerances of the file, the worst of which is minimised, as `--robust` takes it.
    #[serde(default)]
    robust: Option<u64>,
    /// With `robust`: minimise the mean of this share of the engines, the worst ones, as `--worst-share` takes it.
    #[serde(default)]
    worst_share: Option<String>,
    /// With `robust`: seed of the draws; none: 1.
    #[serde(default)]
    robust_seed: Option<u64>,
    /// Gap at which a search over choices ends, as `--gap` takes it; none: 1e-8.
    #[serde(default)]
    gap: Option<String>,
    /// Most branch-and-bound nodes for one stage, as `--max-nodes` takes it; none: 2000.
    #[serde(default)]
    max_nodes: Option<usize>,
    /// Longest time of the search, as `--time-limit` takes it; none: no limit.
    #[serde(default)]
    time_limit: Option<String>,
}

/// Which weights are free.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Free {
    /// Every counterweight and every weight of every shaft, in its own plane.
    #[default]
    Devices,
    /// What the section `[balance]` says; without it as `lanchester balance` does.
    Balance,
    /// The counterweights of the file.
    File,
    /// One in the plane of every throw.
    Throws,
    /// One on every web.
    Webs,
    /// None on the crankshafts.
    None,
}

/// What was found.
#[derive(Debug, Serialize, JsonSchema)]
struct BalanceAnswer {
    /// As `lanchester balance --format json` prints it.
    answer: Answer,
    /// The outcome in words.
    headline: String,
    /// The engine file with what was found; none where nothing was.
    text: Option<String>,
    /// Loads with it.
    after: Option<Loads>,
    /// What it does to the engine.
    effect: Option<WeightEffect>,
    /// What drawn engines have of it, in words; none without `robust`.
    robust: Option<String>,
    /// Oil films and safeties before, at the optimum and after the search for them, in words; none where none is wanted.
    durability: Option<String>,
    /// Added shafts that may strike the crank or stand far out.
    warnings: Vec<Warning>,
}

/// What other weights do to an engine.
#[derive(Debug, Serialize, JsonSchema)]
struct WeightEffect {
    /// Loads, bending, counterweights and balance rates, before and after.
    consequences: Consequences,
    /// What gets worse and which counterweights are dropped, in words; may be empty.
    words: String,
}

impl WeightEffect {
    fn of(before: &Engine, after: &Engine, task: Option<&BalanceTask>) -> Result<WeightEffect, Problem> {
        let consequences = lanchester::consequences(before, after, task).map_err(Problem::refused)?;
        Ok(WeightEffect { words: consequence_words(&consequences), consequences })
    }
}

/// One engine with two sets of weights.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct TwoTexts {
    /// The engine file as it was.
    before: String,
    /// The engine file now.
    text: String,
}

/// What is odd, though it can be computed.
#[derive(Debug, Serialize, JsonSchema)]
struct Warning {
    message: String,
    /// What to do.
    hint: String,
}

/// Which arrangements are searched.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ArrangementQuestion {
    /// The engine file.
    text: String,
    /// `force`, `couple` or `mount force`.
    #[serde(default)]
    minimise: Option<String>,
    /// Limits as `--limit` takes them; one on what is minimised is what is good enough.
    #[serde(default)]
    limits: Vec<String>,
    /// Most shafts, up to 4.
    #[serde(default)]
    most_shafts: Option<usize>,
    /// `gears` or `chain`.
    #[serde(default)]
    drive: Option<Drive>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Drive {
    Gears,
    Chain,
}

/// One of the arrangements of a search.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ChosenArrangement {
    /// What was searched.
    search: ArrangementQuestion,
    /// Its number among all that were examined, from 1.
    choice: usize,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post("/api/balance", "The best weights with their proof: `lanchester balance`.", balanced)
        .post("/api/consequences", "What other weights do to bearings and bending, before and after.", effect)
        .post(
            "/api/arrangements",
            "Which arrangement of weights and shafts: `lanchester balance --search`.",
            searched,
        )
        .post("/api/arrangements/adopt", "The engine file with one of them.", adopted)
}

fn effect(_: &Asker, question: TwoTexts) -> Result<WeightEffect, Problem> {
    WeightEffect::of(&engine(&question.before)?, &engine(&question.text)?, None)
}

fn balanced(asker: &Asker, question: BalanceQuestion) -> Result<BalanceAnswer, Problem> {
    let file = engine_file(&question.text)?;
    let EngineFile { engine, tasks } = file.clone();
    let ChangedTask { task, warnings } = task(&engine, tasks.balance, &question)?;
    if wants_robust_films(&task, &question) {
        return Err(Problem::refused(
            "films and safeties do not go with drawn engines, for which one load is minimised\nhint: leave one of the two out",
        ));
    }
    let warning = |fault: RoomFault| Warning { message: fault.message, hint: fault.hint.into() };
    let warnings = warnings.into_iter().map(warning).collect();
    let settings = settings(&question)?;
    let began = (asker.studio.clock)();
    let watch = |_: &SearchState| match asker.waits() {
        true => settings.next((asker.studio.clock)().saturating_sub(began).as_secs_f64()),
        false => Next::Abandon,
    };
    let wants_films = !task.durability.is_empty();
    let traces = match task.counts_gas() || wants_films {
        true => asker.studio.traces(&engine)?,
        false => Vec::new(),
    };
    let (answer, robust) = match robust(&question)? {
        Some(options) => {
            let waits = || asker.waits();
            let found = robust_balance_while(&engine, &tasks.tolerances, &task, &options, &waits);
            let found = found.map_err(|error| match error {
                RobustError::Balance(BalanceError::BrokenOff) => superseded(),
                error => Problem::refused(error),
            })?;
            let words = robust_text(&engine, &found);
            (found.answer, Some(words))
        }
        None => {
            let shapes = tasks.shape_task.as_ref();
            let found = optimise_on_webs(&engine, Ok(&traces), &task, shapes, &settings, &watch);
            let answer = found.map_err(|error| match error {
                WebBoundError::Balance(BalanceError::BrokenOff) => superseded(),
                error => Problem::refused(error),
            })?;
            (answer, None)
        }
    };
    let headline = headline(&engine, &answer);
    if matches!(answer.outcome, Outcome::Infeasible { .. }) {
        return Ok(BalanceAnswer {
            answer,
            headline,
            text: None,
            after: None,
            effect: None,
            robust,
            durability: None,
            warnings,
        });
    }
    let durable = match wants_films && !answer.weights.is_empty() {
        true => {
            let options = DurableOptions { balance: settings, ..DurableOptions::default() };
            let watch = |_: usize| match asker.waits() {
                true => settings.next((asker.studio.clock)().saturating_sub(began).as_secs_f64()),
                false => Next::Abandon,
            };
            let found = durable_balance(&file, Ok(&traces), &answer, &options, &watch);
            Some(found.map_err(|error| match error {
                BalanceError::BrokenOff => superseded(),
                error => Problem::refused(error),
            })?)
        }
        false => None,
    };
    let best = match &durable {
        Some(durable) if durable.is_moved() => durable.engine(&engine, &answer),
        _ => fitted(&engine, &answer),
    };
    let (headline, answer) = match &durable {
        Some(found) if found.is_moved() => {
            (format!("{headline} {}", moved_words(found)), found.answer(&answer))
        }
        _ => (headline, answer),
    };
    let durability = durable.map(|found| durability_text(&engine, &found));
    let after = loads(&best, &LoadRequest::default()).map_err(Problem::refused)?;
    let text = write_back(&question.text, &best).map_err(Problem::refused)?;
    let effect = match answer.weights.is_empty() {
        true => None,
        false => Some(WeightEffect::of(&engine, &best, Some(&answer.task))?),
    };
    let (text, after) = (Some(text), Some(after));
    Ok(BalanceAnswer { answer, headline, text, after, effect, robust, durability, warnings })
}

/// Whether films are wanted of engines that are drawn.
fn wants_robust_films(task: &BalanceTask, question: &BalanceQuestion) -> bool {
    question.robust.is_some() && !task.durability.is_empty()
}

/// How far a search over choices goes.
fn settings(question: &BalanceQuestion) -> Result<BalanceSettings, Problem> {
    let usual = BalanceSettings::default();
    let gap = question.gap.as_ref().map(|text| option::share(text, "gap")).transpose();
    let time_limit = question.time_limit.as_ref().map(|text| option::time(text, "time_limit")).transpose();
    let settings = BalanceSettings {
        gap: gap.map_err(Problem::quantity)?.unwrap_or(usual.gap),
        max_nodes: question.max_nodes.unwrap_or(usual.max_nodes),
        time_limit: time_limit.map_err(Problem::quantity)?,
    };
    settings.check().map_err(Problem::refused)?;
    Ok(settings)
}

/// Engines to be drawn, if that is asked.
fn robust(question: &BalanceQuestion) -> Result<Option<RobustOptions>, Problem> {
    let Some(engines) = question.robust else {
        if question.worst_share.is_some() || question.robust_seed.is_some() {
            return Err(Problem::refused(
                "`worst_share` and `robust_seed` are about drawn engines\nhint: say how many with `robust`, or leave them out",
            ));
        }
        return Ok(None);
    };
    let others = [("budget", question.budget.is_some()), ("cancel", !question.cancel.is_empty())];
    if let Some((name, _)) = others.into_iter().find(|(_, given)| *given) {
        return Err(Problem::refused(format!(
            "`{name}` does not go with drawn engines, for which one load is minimised\nhint: leave one of the two out"
        )));
    }
    let share = question.worst_share.as_ref().map(|text| option::share(text, "worst_share")).transpose();
    let share = share.map_err(Problem::quantity)?;
    if let Some(share) = share.filter(|share| !(*share > 0.0 && *share <= 1.0)) {
        return Err(Problem::refused(format!(
            "`worst_share` needs a share above 0 and up to 100 %, got {}\nhint: write it like 1 %",
            100.0 * share
        )));
    }
    let measure = share.map_or(RobustMeasure::Worst, RobustMeasure::MeanOfWorst);
    Ok(Some(RobustOptions { engines, seed: question.robust_seed.unwrap_or(1), measure }))
}

/// The free devices, changed by what is wanted.
fn task(
    engine: &Engine,
    of_file: Option<BalanceTask>,
    question: &BalanceQuestion,
) -> Result<ChangedTask, Problem> {
    if !question.locked.is_empty() && question.free != Free::Devices {
        return Err(Problem::refused(
            "`locked` names devices of the file that stay, and others are free\nhint: leave it out, or ask with free = \"devices\"",
        ));
    }
    let places = match question.free {
        Free::Devices | Free::Balance => None,
        Free::File => Some(CrankWeightPlaces::File),
        Free::Throws => Some(CrankWeightPlaces::Throws),
        Free::Webs => Some(CrankWeightPlaces::Webs),
        Free::None => Some(CrankWeightPlaces::None),
    };
    let free = match question.free {
        Free::Devices => device_task(engine, &question.locked)?,
        Free::Balance => of_file.unwrap_or_else(|| default_task(engine)),
        _ => BalanceTask::default(),
    };
    let options = TaskOptions {
        counterweights: places,
        shafts: question.shafts.clone(),
        minimise: question.minimise.clone(),
        limits: question.limits.clone(),
        at_least: question.at_least.clone(),
        maximise: question.maximise.clone(),
        give_up: question.give_up.clone(),
        cancel: question.cancel.clone(),
        least: question.least.clone(),
        most: question.most.clone(),
        step: question.step.clone(),
        equal_parts: question.equal_parts,
        budget: question.budget.clone(),
        speeds: question.speeds.clone(),
        ..TaskOptions::default()
    };
    options.change(engine, free).map_err(Problem::quantity)
}

/// Every device of the engine but the locked ones, in its own plane and on its own axis.
fn device_task(engine: &Engine, locked: &[String]) -> Result<BalanceTask, Problem> {
    let counterweights = engine.counterweights.iter().map(|weight| &weight.name);
    let devices: Vec<&String> = counterweights.chain(engine.shafts.iter().map(|shaft| &shaft.name)).collect();
    if let Some(unknown) = locked.iter().find(|name| !devices.contains(name)) {
        let known: Vec<&str> = devices.iter().map(|name| name.as_str()).collect();
        return Err(Problem::refused(format!(
            "`locked` needs names of counterweights and shafts, got `{unknown}`\nhint: the engine has {}",
            if known.is_empty() { "neither".to_string() } else { known.join(", ") }
        )));
    }
    // Weights in one plane are one: those that are free, under a name of theirs.
    let free = engine
        .with(|parts| parts.counterweights.retain(|weight| !locked.contains(&weight.name)))
        .expect("invariant: an engine with fewer weights is one");
    let weights = crank_weights(&free, CrankWeightPlaces::File);
    let mut task = BalanceTask { weights, ..BalanceTask::default() };
    for shaft in engine.shafts.iter().filter(|shaft| !locked.contains(&shaft.name)) {
        let seat = Seat::Shaft(task.shafts.len());
        let weights = shaft.weights.iter().enumerate();
        task.weights.extend(
            weights.map(|(number, weight)| {
                FreeWeight::new(shaft.weight_name(number), seat, Place::At(weight.z))
            }),
        );
        task.shafts.push(FreeShaft {
            name: shaft.name.clone(),
            ratio: shaft.ratio,
            x: Place::At(shaft.x),
            y: Place::At(shaft.y),
            optional: false,
        });
    }
    Ok(task)
}

fn searched(_: &Asker, question: ArrangementQuestion) -> Result<Arrangements, Problem> {
    let engine = engine(&question.text)?;
    arrangements(&engine, &request(&engine, &question)?).map_err(Problem::refused)
}

fn adopted(_: &Asker, question: ChosenArrangement) -> Result<NewText, Problem> {
    let text = &question.search.text;
    let engine = engine(text)?;
    let request = request(&engine, &question.search)?;
    let found = arrangements(&engine, &request).map_err(Problem::refused)?;
    let spacing = &found.spacings[0];
    let count = spacing.arrangements.len();
    let chosen =
        question.choice.checked_sub(1).and_then(|index| spacing.arrangements.get(index)).ok_or_else(
            || {
                Problem::refused(format!(
                    "an arrangement needs its number, 1 to {count}, got {}\nhint: search again",
                    question.choice
                ))
            },
        )?;
    if !chosen.possible {
        return Err(Problem::refused(format!(
            "`{}` cannot be fitted: it has no place or breaks a limit\nhint: choose another one",
            chosen.label
        )));
    }
    let bare = searched_engine(&engine, &request, spacing.scale).map_err(Problem::refused)?;
    let text = write_back(text, &fitted(&bare, &chosen.answer)).map_err(Problem::refused)?;
    Ok(NewText { text })
}

fn request(engine: &Engine, question: &ArrangementQuestion) -> Result<ArrangementRequest, Problem> {
    let mut request = ArrangementRequest::default();
    if let Some(name) = &question.minimise {
        let all = [Judged::Force, Judged::Couple, Judged::MountForce];
        request.criterion = all.into_iter().find(|judged| judged.name() == name.replace('-', " ")).ok_or_else(|| {
            Problem::refused(format!("arrangements are judged by force, couple or mount force, got `{name}`\nhint: anything else can be a limit"))
        })?;
    }
    if request.criterion == Judged::MountForce && engine.mounts.is_empty() {
        return Err(Problem::refused(
            "`mount force` needs the places of the mounts, and the engine file has none\nhint: add tables [[mount]]",
        ));
    }
    for text in &question.limits {
        let limit = option::limit(text, engine, "limit").map_err(Problem::quantity)?;
        if limit.criterion == request.criterion.criterion() {
            if limit.most <= 0.0 {
                return Err(Problem::refused(format!(
                    "what is good enough must be above 0, got `{text}`\nhint: leave it out to see which leaves least"
                )));
            }
            request.target = Target::Limit { most: limit.most };
        } else {
            request.limits.push(limit);
        }
    }
    if let Some(most) = question.most_shafts {
        if most > 4 {
            return Err(Problem::refused(format!(
                "an arrangement has up to 4 shafts, got {most}\nhint: more act as one of them"
            )));
        }
        request.most_shafts = most;
    }
    if question.drive == Some(Drive::Chain) {
        request.drive = DriveRule::ChainOrBelt;
    }
    Ok(request)
}
