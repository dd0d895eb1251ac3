//! The best weights and shafts, and which arrangement: the answers of `balance`.

use crate::api::Api;
use crate::problem::Problem;
use crate::reading::{NewText, engine};
use crate::server::Studio;
use lanchester::balance::{
    Answer, ArrangementRequest, Arrangements, DriveRule, Judged, Outcome, Target, arrangements, fitted,
    optimise, searched_engine,
};
use lanchester::mechanism::{LoadRequest, Loads, loads};
use lanchester::model::{
    BalanceTask, CrankWeightPlaces, Engine, FreeShaft, FreeWeight, Place, Ratio, Seat, crank_weights,
    default_task, option, write_back,
};
use lanchester::report::headline;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What may be changed, and what is wanted.
#[derive(Debug, Deserialize, JsonSchema)]
struct BalanceQuestion {
    /// The engine file.
    text: String,
    /// Which weights are free.
    #[serde(default)]
    free: Free,
    /// Names of counterweights and shafts that stay as they are.
    #[serde(default)]
    locked: Vec<String>,
    /// Criteria in their order, as `--minimise` takes them; none: force, then couple.
    #[serde(default)]
    minimise: Vec<String>,
    /// Limits as `--limit` takes them; `most = ..` and `least = ..` hold for every free weight on a crankshaft.
    #[serde(default)]
    limits: Vec<String>,
    /// Orders that must vanish, as `--cancel` takes them.
    #[serde(default)]
    cancel: Vec<String>,
    /// Shafts that are added, as `--shaft` takes them: `-1 @ 0 mm, 100 mm @ -30 mm, 30 mm` is ratio @ x, y of the axis @ planes.
    #[serde(default)]
    shafts: Vec<String>,
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
}

/// Which arrangements are searched.
#[derive(Debug, Deserialize, JsonSchema)]
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
struct ChosenArrangement {
    #[serde(flatten)]
    search: ArrangementQuestion,
    /// Its number among all that were examined, from 1.
    choice: usize,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post("/api/balance", "The best weights with their proof: `lanchester balance`.", balanced)
        .post(
            "/api/arrangements",
            "Which arrangement of weights and shafts: `lanchester balance --search`.",
            searched,
        )
        .post("/api/arrangements/adopt", "The engine file with one of them.", adopted)
}

fn balanced(_: &Studio, question: BalanceQuestion) -> Result<BalanceAnswer, Problem> {
    let engine = engine(&question.text)?;
    let task = task(&engine, &question)?;
    let answer = optimise(&engine, &task).map_err(Problem::refused)?;
    let headline = headline(&engine, &answer);
    if matches!(answer.outcome, Outcome::Infeasible { .. }) {
        return Ok(BalanceAnswer { answer, headline, text: None, after: None });
    }
    let best = fitted(&engine, &answer);
    let after = loads(&best, &LoadRequest::default()).map_err(Problem::refused)?;
    let text = write_back(&question.text, &best).map_err(Problem::refused)?;
    Ok(BalanceAnswer { answer, headline, text: Some(text), after: Some(after) })
}

fn task(engine: &Engine, question: &BalanceQuestion) -> Result<BalanceTask, Problem> {
    let mut task = match question.free {
        Free::Balance => engine.balance.clone().unwrap_or_else(|| default_task(engine)),
        Free::Devices => devices(engine, &question.locked),
        Free::File => of_crank(engine, CrankWeightPlaces::File),
        Free::Throws => of_crank(engine, CrankWeightPlaces::Throws),
        Free::Webs => of_crank(engine, CrankWeightPlaces::Webs),
        Free::None => BalanceTask::default(),
    };
    if task.ties.is_empty() {
        // A weight that leaves the task leaves the engine as it is.
        task.weights.retain(|weight| !question.locked.contains(&weight.name));
    }
    for shaft in &question.shafts {
        add_shaft(&mut task, shaft)?;
    }
    let mounts = &engine.mounts;
    if !question.minimise.is_empty() {
        let stage = |text: &String| option::stage(text, mounts, "minimise").map_err(Problem::quantity);
        task.stages = question.minimise.iter().map(stage).collect::<Result<_, _>>()?;
        task.cancel.clear();
    }
    if !question.cancel.is_empty() {
        let orders = |text: &String| option::cancel(text, mounts, "cancel").map_err(Problem::quantity);
        let lists: Vec<_> = question.cancel.iter().map(orders).collect::<Result<_, _>>()?;
        (task.cancel, task.stages, task.limits) = (lists.concat(), Vec::new(), Vec::new());
    }
    for text in &question.limits {
        if let Some((name @ ("most" | "least"), amount)) =
            text.split_once('=').map(|(name, value)| (name.trim(), value))
        {
            let amount = option::unbalance(amount.trim(), name).map_err(Problem::quantity)?;
            for weight in task.weights.iter_mut().filter(|weight| matches!(weight.seat, Seat::Crankshaft(_)))
            {
                if name == "most" { weight.most = Some(amount) } else { weight.least = amount }
            }
            continue;
        }
        let limit = option::limit(text, mounts, "limit").map_err(Problem::quantity)?;
        task.limits.retain(|known| known.criterion != limit.criterion);
        task.limits.push(limit);
    }
    if task.weights.is_empty() && task.inertias.is_empty() {
        return Err(Problem::refused(
            "nothing is free: there is no weight whose unbalance could be found\nhint: unlock a weight, or add a counterweight or a shaft",
        ));
    }
    Ok(task)
}

fn of_crank(engine: &Engine, places: CrankWeightPlaces) -> BalanceTask {
    BalanceTask { weights: crank_weights(engine, places), ..BalanceTask::default() }
}

/// Every device of the engine but the locked ones.
fn devices(engine: &Engine, locked: &[String]) -> BalanceTask {
    let mut task = of_crank(engine, CrankWeightPlaces::File);
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
    task
}

fn add_shaft(task: &mut BalanceTask, text: &str) -> Result<(), Problem> {
    let wrong = |what: String| {
        Problem::refused(format!("{what}\nhint: write it like -1 @ 0 mm, 100 mm @ -30 mm, 30 mm"))
    };
    let parts: Vec<&str> = text.split('@').map(str::trim).collect();
    let [ratio, axis, planes] = parts[..] else {
        return Err(wrong(format!("a shaft needs ratio @ x, y @ planes, got `{text}`")));
    };
    let (numerator, denominator) = ratio.split_once('/').unwrap_or((ratio, "1"));
    let (numerator, denominator) = (numerator.trim().parse().ok(), denominator.trim().parse().ok());
    let ratio =
        numerator.zip(denominator).and_then(|(numerator, denominator)| Ratio::new(numerator, denominator));
    let ratio =
        ratio.ok_or_else(|| wrong(format!("a shaft needs a ratio such as -1 or 1/2, got `{text}`")))?;
    let length = |text: &str| option::length(text.trim(), "shafts").map(Place::At).map_err(Problem::quantity);
    let axis = axis.split(',').map(length).collect::<Result<Vec<_>, Problem>>()?;
    let [x, y] = axis[..] else {
        return Err(wrong(format!("a shaft needs the two coordinates x, y of its axis, got `{text}`")));
    };
    let taken = |name: &str| task.shafts.iter().any(|shaft| shaft.name == name);
    let name = (1..).map(|number| format!("shaft {number}")).find(|name| !taken(name));
    let name = name.expect("invariant: numbers do not end");
    let seat = Seat::Shaft(task.shafts.len());
    for (number, plane) in planes.split(',').enumerate() {
        task.weights.push(FreeWeight::new(format!("{name} {}", number + 1), seat, length(plane)?));
    }
    task.shafts.push(FreeShaft { name, ratio, x, y, optional: false });
    Ok(())
}

fn searched(_: &Studio, question: ArrangementQuestion) -> Result<Arrangements, Problem> {
    let engine = engine(&question.text)?;
    arrangements(&engine, &request(&engine, &question)?).map_err(Problem::refused)
}

fn adopted(_: &Studio, question: ChosenArrangement) -> Result<NewText, Problem> {
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
    let bare = searched_engine(&engine, &request, spacing.scale);
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
        let limit = option::limit(text, &engine.mounts, "limit").map_err(Problem::quantity)?;
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
