//! The best weights and shafts with their proof, and which arrangement.

use crate::answer::{Data, Shown};
use crate::failure::Failure;
use crate::guard::Watch;
use crate::options::Options;
use crate::prepared::Prepared;
use crate::question::{How, Question, Run};
use lanchester::balance::{
    Answer, ArrangementRequest, Arrangements, BalanceSettings, Consequences, DriveRule, Durable, Judged,
    MountPlaces, Next, Outcome, RobustAnswer, RobustMeasure, StopCause, Target, arrangements, fitted,
    searched_engine,
};
use lanchester::mechanism::{LoadRequest, loads};
use lanchester::model::Engine;
use lanchester::report::{
    Figure, Table, arrangement_figure, arrangements_text, balance_text, cancellation_proof_table,
    cancelled_orders_table, consequence_figures, consequences_table, durability_table, durability_text,
    durable_weights_table, effects_table, found_inertias_table, found_shafts_table, found_weights_table,
    front_table, limits_table, optimum_figures, robust_tables, robust_text, stages_table, web_bounds_table,
};
use lanchester::task::{BalanceTask, CrankWeightPlaces, TaskOptions, default_task, option};
use lanchester::{
    DurableOptions, RobustOptions, WeightAsPart, consequences, durable_balance, optimise_on_webs,
    robust_balance_while, weights_as_parts,
};
use schemars::JsonSchema;
use serde::Serialize;
use std::sync::Arc;
use std::time::Instant;

pub(super) const QUESTIONS: [Question; 3] = [
    Question::of::<Balance>("balance", How::Long, read_balance),
    Question::of::<RobustAnswer>("robust_balance", How::Long, read_robust),
    Question::of::<Arrangements>("arrangements", How::Long, read_arrangements),
];

/// The best weights with their proof, as parts, and what they do to the engine.
#[derive(Debug, Serialize, JsonSchema)]
struct Balance {
    #[serde(flatten)]
    answer: Answer,
    /// What the weights are as parts, where the file says among which shapes they are searched.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    as_parts: Vec<WeightAsPart>,
    /// What the weights do to block, bearings and bending, before and after.
    #[serde(skip_serializing_if = "Option::is_none")]
    consequences: Option<Consequences>,
    /// Oil films and safeties before, at the optimum and after the search for them, where some are wanted.
    #[serde(skip_serializing_if = "Option::is_none")]
    durability: Option<Durable>,
    /// What the user should know.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<String>,
}

impl Balance {
    fn is_found(&self) -> bool {
        !matches!(self.answer.outcome, Outcome::Infeasible { .. })
    }

    fn after(&self, engine: &Engine) -> Engine {
        match &self.durability {
            Some(durable) if durable.is_moved() => durable.engine(engine, &self.answer),
            _ => fitted(engine, &self.answer),
        }
    }
}

fn task_options(options: &Options<'_>) -> Result<TaskOptions, Failure> {
    let places = [
        ("none", CrankWeightPlaces::None),
        ("file", CrankWeightPlaces::File),
        ("throws", CrankWeightPlaces::Throws),
        ("webs", CrankWeightPlaces::Webs),
    ];
    Ok(TaskOptions {
        prefix: "",
        counterweights: options.word("counterweights", &places)?,
        shafts: options.texts("shaft")?,
        minimise: options.texts("minimise")?,
        give_up: options.texts("give_up")?,
        limits: options.texts("limit")?,
        budget: options.text("budget")?,
        cancel: options.texts("cancel")?,
        least: options.text("min_unbalance")?,
        most: options.text("max_unbalance")?,
        step: options.text("weight_step")?,
        equal_parts: options.flag("equal_parts")?.unwrap_or(false),
        optional: options.flag("optional")?.unwrap_or(false),
        most_optional: options.whole("max_optional", 0, 1000)?.map(|most| most as usize),
        speeds: options.texts("speed")?,
        at_least: options.texts("at_least")?,
        maximise: options.texts("maximise")?,
    })
}

/// The task of the file, changed by the options; what is odd about them is a warning.
fn task_of(own: &Prepared, options: &TaskOptions) -> Result<(BalanceTask, Vec<String>), Failure> {
    let of_file = own.file.tasks.balance.clone();
    let task = of_file.unwrap_or_else(|| default_task(own.engine()));
    let changed = options.change(own.engine(), task)?;
    let warnings = changed.warnings.into_iter().map(|fault| format!("{}; {}", fault.message, fault.hint));
    Ok((changed.task, warnings.collect()))
}

fn settings(options: &Options<'_>) -> Result<BalanceSettings, Failure> {
    let usual = BalanceSettings::default();
    let settings = BalanceSettings {
        gap: options.share("gap")?.unwrap_or(usual.gap),
        max_nodes: options.whole("max_nodes", 1, 1 << 40)?.map_or(usual.max_nodes, |nodes| nodes as usize),
        time_limit: options.time("time_limit")?,
    };
    settings.check().map_err(Failure::refused)?;
    Ok(settings)
}

fn read_balance(options: &Options<'_>) -> Result<Run, Failure> {
    let (asked, settings) = (task_options(options)?, settings(options)?);
    Ok(Box::new(move |engines, watch| {
        let own = &engines[0];
        let engine = own.engine();
        let (task, mut warnings) = task_of(own, &asked)?;
        let wants_films = !task.durability.is_empty();
        let traces = if task.counts_gas() || wants_films { own.traces()? } else { &[] };
        let began = Instant::now();
        let next = |watch: &Watch| match watch.goes_on() {
            true => settings.next(began.elapsed().as_secs_f64()),
            false => Next::Stop(StopCause::Cancelled),
        };
        let shapes = own.file.tasks.shape_task.as_ref();
        let answer = optimise_on_webs(engine, Ok(traces), &task, shapes, &settings, &|_| next(watch));
        let answer = answer.map_err(Failure::refused)?;
        let mut found = Balance {
            answer,
            as_parts: Vec::new(),
            consequences: None,
            durability: None,
            warnings: Vec::new(),
        };
        if found.is_found() && wants_films && !found.answer.weights.is_empty() {
            let options = DurableOptions { balance: settings, ..DurableOptions::default() };
            let durable = durable_balance(&own.file, Ok(traces), &found.answer, &options, &|_| next(watch));
            found.durability = Some(durable.map_err(Failure::refused)?);
        }
        if found.is_found() {
            let after = found.after(engine);
            if !found.answer.weights.is_empty() {
                let effect = consequences(engine, &after, Some(&found.answer.task));
                found.consequences = Some(effect.map_err(Failure::refused)?);
            }
            let shown = found
                .durability
                .as_ref()
                .map_or_else(|| found.answer.clone(), |own| own.answer(&found.answer));
            match weights_as_parts(&shown, &after, &own.file.tasks) {
                Ok(parts) => found.as_parts = parts,
                Err(error) => {
                    let message = error.to_string().replace("\nhint:", ";");
                    warnings.push(format!("the mass of the weights as parts is left out: {message}"));
                }
            }
        }
        found.warnings = warnings;
        let shown = Shown { text, tables, figures, adopted: Some(adopted), ..Shown::default() };
        Ok(Data::new(found, own, shown))
    }))
}

fn text(found: &Balance, engine: &Engine) -> String {
    let summary = loads(&found.after(engine), &LoadRequest::default()).map(|loads| loads.diagnosis.summary);
    let left = summary.unwrap_or_default();
    let durable = found.durability.as_ref();
    let text = balance_text(engine, &found.answer, durable, found.consequences.as_ref(), &left);
    match &found.durability {
        Some(durable) => format!("{text}\n{}", durability_text(engine, durable)),
        None => text,
    }
}

fn tables(found: &Balance, engine: &Engine) -> Vec<Table> {
    let durable = found.durability.as_ref();
    let answer = &durable.map_or_else(|| found.answer.clone(), |own| own.answer(&found.answer));
    let mut tables = vec![found_weights_table(answer)];
    tables.extend(found_shafts_table(answer));
    tables.extend(found_inertias_table(answer));
    tables.push(stages_table(engine, answer));
    tables.push(effects_table(engine, answer));
    tables.extend(limits_table(engine, answer));
    tables.extend(web_bounds_table(answer));
    if let Some(cancellation) = &answer.cancellation {
        tables.push(cancelled_orders_table(engine, cancellation));
        tables.extend(cancellation_proof_table(engine, cancellation));
    }
    tables.extend(found.consequences.as_ref().map(consequences_table));
    if let Some(durable) = &found.durability {
        tables.push(durability_table(durable));
        tables.extend(durable_weights_table(engine, durable));
    }
    tables
}

fn figures(found: &Balance, engine: &Engine) -> Vec<Figure> {
    if !found.is_found() {
        return Vec::new();
    }
    let after = found.after(engine);
    let loads_of = |engine: &Engine| loads(engine, &LoadRequest::default());
    let (Ok(before), Ok(loads_after)) = (loads_of(engine), loads_of(&after)) else { return Vec::new() };
    let mut figures = optimum_figures(engine, &found.answer, &before, &after, &loads_after);
    figures.extend(found.consequences.iter().flat_map(|effect| consequence_figures(&after, effect)));
    figures
}

fn adopted(found: &Balance, own: &Prepared, _: usize) -> Result<Arc<Prepared>, Failure> {
    match &found.answer.outcome {
        Outcome::Infeasible { reason, .. } => Err(Failure::option(
            format_args!("there are no weights to put into the engine: {reason}"),
            "relax a limit, or free more devices",
        )),
        _ => own.fitted(&found.after(own.engine())),
    }
}

fn read_robust(options: &Options<'_>) -> Result<Run, Failure> {
    let asked = task_options(options)?;
    let share = options.share("worst_share")?;
    if let Some(share) = share.filter(|share| !(*share > 0.0 && *share <= 1.0)) {
        return Err(Failure::option(
            format_args!("`worst_share` needs a share above 0 and up to 1, got {share}"),
            "write it like 0.01 or \"1 %\"",
        ));
    }
    let robust = RobustOptions {
        engines: options.whole("engines", 1, 1 << 32)?.unwrap_or(1000),
        seed: options.whole("seed", 0, u64::MAX)?.unwrap_or(1),
        measure: share.map_or(RobustMeasure::Worst, RobustMeasure::MeanOfWorst),
    };
    Ok(Box::new(move |engines, watch| {
        let own = &engines[0];
        let (task, _) = task_of(own, &asked)?;
        let waits = || watch.goes_on();
        let found = robust_balance_while(own.engine(), &own.file.tasks.tolerances, &task, &robust, &waits);
        Ok(Data::new(
            found.map_err(Failure::refused)?,
            own,
            Shown {
                text: |found, engine| robust_text(engine, found),
                tables: |found, engine| robust_tables(engine, found),
                adopted: Some(|found, own, _| own.fitted(&fitted(own.engine(), &found.answer))),
                ..Shown::default()
            },
        ))
    }))
}

/// What is searched, with limits as texts.
#[derive(Clone)]
struct Search {
    request: ArrangementRequest,
    limits: Vec<String>,
}

impl Search {
    /// The request for an engine: a limit on what is minimised is what is good enough.
    fn request(&self, engine: &Engine) -> Result<ArrangementRequest, Failure> {
        let mut request = self.request.clone();
        let engine = &searched_engine(engine, &request, 1.0).map_err(Failure::refused)?;
        if request.criterion == Judged::MountForce && engine.mounts.is_empty() {
            return Err(Failure::option(
                "`mount force` needs the places of the mounts, and the engine file has none",
                "give `mount_spacing`, or add tables [[mount]] to the engine file",
            ));
        }
        for text in &self.limits {
            let limit = option::limit(text, engine, "limit")?;
            if limit.criterion != request.criterion.criterion() {
                request.limits.push(limit);
            } else if limit.most > 0.0 {
                request.target = Target::Limit { most: limit.most };
            } else {
                return Err(Failure::option(
                    format_args!("what is good enough must be above 0, got `{text}`"),
                    "leave it out to see which arrangement leaves least",
                ));
            }
        }
        Ok(request)
    }
}

fn read_arrangements(options: &Options<'_>) -> Result<Run, Failure> {
    let mut request = ArrangementRequest::default();
    let spacing = options.length("mount_spacing")?;
    if let Some(spacing) = spacing {
        if spacing <= 0.0 {
            return Err(Failure::option(
                format_args!("`mount_spacing` needs a length above 0, got {spacing} m"),
                "for example 0.08 or \"80 mm\"",
            ));
        }
        request.mounts = MountPlaces::Spacing(spacing);
    }
    let words = [("force", Judged::Force), ("couple", Judged::Couple), ("mount force", Judged::MountForce)];
    let usual = if spacing.is_some() { Judged::MountForce } else { request.criterion };
    request.criterion = options.word("minimise", &words)?.unwrap_or(usual);
    if let Some(most) = options.whole("max_shafts", 0, 4)? {
        request.most_shafts = most as usize;
    }
    let drives = [("gears", false), ("chain", true)];
    if options.word("drive", &drives)? == Some(true) {
        request.drive = DriveRule::ChainOrBelt;
    }
    let search = Search { request, limits: options.texts("limit")? };
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let request = search.request(own.engine())?;
        let found = arrangements(own.engine(), &request).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| arrangements_text(found, true),
                tables: |found, _| found.spacings.iter().map(|own| front_table(found, own, true)).collect(),
                figures: |found, _| vec![arrangement_figure(found)],
                ..Shown::default()
            },
        ))
    }))
}
