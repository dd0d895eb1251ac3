//! Questions about many engines: side by side, what matters most, what production makes of them.

use crate::answer::{Data, Shown};
use crate::blocks::{Blocks, Tabled};
use crate::failure::Failure;
use crate::guard::Watch;
use crate::options::Options;
use crate::prepared::Prepared;
use crate::question::{How, Question, Run};
use lanchester::literature::TwinArrangement;
use lanchester::mechanism::OuterTorque;
use lanchester::report::{
    comparison_figure, comparison_table, comparison_text, relative_table, scatter_figure,
    scatter_limit_table, scatter_table, scatter_text, sensitivity_tables, sensitivity_text, tolerance_table,
    tornado_figure,
};
use lanchester::run::{Head, Study, stretch};
use lanchester::study::compare::{Comparison, Equal, Held};
use lanchester::study::scatter::{ScatterOptions, ScatterStudy, Scattering, Tally, scatter_study_of};
use lanchester::study::sensitivity::{Output, Sensitivity, SensitivityRequest, Weights, sensitivity_watched};
use lanchester::task::option;
use lanchester::{
    CompareEntry, CompareRequest, ComparedWith, SampleStudy, SavedScatter, compare, operating_point,
    sensitivity_amount,
};
use std::sync::Arc;

pub(super) const QUESTIONS: [Question; 3] = [
    Question::of::<Comparison>("compare", How::Long, read_compare),
    Question::of::<Sensitivity>("sensitivity", How::Long, read_sensitivity),
    Question::of::<ScatterStudy>("scatter", How::Long, read_scatter),
];

/// Blocks of a study for each thread between two looks whether somebody waits.
const BLOCKS_PER_THREAD: u64 = 4;

/// What is kept of a whole study, unless nobody waits any more.
pub(super) fn run_study<S: Study>(study: &S, watch: &Watch) -> Result<S::Kept, Failure> {
    let blocks = study.blocks();
    let batch = BLOCKS_PER_THREAD * rayon::current_num_threads() as u64;
    let mut kept = study.nothing();
    let mut next = 0;
    while next < blocks && watch.goes_on() {
        let end = blocks.min(next + batch);
        let (more, _) = stretch(study, next..end).map_err(Failure::refused)?;
        kept = study.join(kept, more).map_err(Failure::refused)?;
        next = end;
    }
    Ok(kept)
}

fn read_compare(options: &Options<'_>) -> Result<Run, Failure> {
    let equal = [("displacement", Equal::Displacement), ("power", Equal::Power)];
    let held = [("speed", Held::Speed), ("piston-speed", Held::PistonSpeed)];
    let request = CompareRequest {
        equal: options.word("equal", &equal)?.unwrap_or(Equal::AsTheyAre),
        held: options.word("hold", &held)?.unwrap_or(Held::Speed),
        speed: options.speed("speed")?,
        reference: options.whole("reference", 0, 10_000)?.unwrap_or(0) as usize,
        share: options.share("share")?.unwrap_or(1.0),
        mount_spacing: options.length("mount_spacing")?,
        fluctuation: options.share("fluctuation")?,
        finite_elements: options.flag("finite_elements")?.unwrap_or(false),
    };
    let numbers = options.wholes("arrangements", 1, 9)?;
    let arrangements = numbers.into_iter().filter_map(|number| TwinArrangement::from_number(number as usize));
    let mut with: Vec<ComparedWith> = arrangements.map(ComparedWith::Arrangement).collect();
    if with.is_empty() {
        with.push(ComparedWith::OwnDevices);
    }
    if options.flag("optimum")?.unwrap_or(false) {
        with.push(ComparedWith::Optimum);
    }
    Ok(Box::new(move |engines, _| {
        let count = engines.len() * with.len();
        if request.reference >= count && count > 1 {
            return Err(Failure::option(
                format_args!("`reference` needs an index from 0 to {}, got {}", count - 1, request.reference),
                "indices count from 0",
            ));
        }
        let mut entries = Vec::with_capacity(count);
        for own in engines {
            let traces = own.traces()?;
            entries.extend(with.iter().map(|&with| CompareEntry {
                file: own.file.clone(),
                traces: traces.to_vec(),
                with,
            }));
        }
        let first = engines
            .first()
            .ok_or_else(|| Failure::option("no engine is given", "write lanchester.compare([one, other])"))?;
        let found = compare(&entries, &request).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            first,
            Shown {
                text: |found, _| comparison_text(found),
                tables: |found, _| {
                    [Some(comparison_table(found)), relative_table(found)].into_iter().flatten().collect()
                },
                figures: |found, _| vec![comparison_figure(found)],
                ..Shown::default()
            },
        ))
    }))
}

fn read_sensitivity(options: &Options<'_>) -> Result<Run, Failure> {
    let speed = options.speed("speed")?;
    let names = options.texts("output")?;
    let amounts = options.texts("vary")?;
    let amounts =
        amounts.iter().map(|text| sensitivity_amount(text, "vary")).collect::<Result<Vec<_>, _>>()?;
    let each = options.flag("each")?.unwrap_or(false);
    let only = options.flag("only")?.unwrap_or(false);
    let seed = options.whole("seed", 0, u64::MAX)?.unwrap_or(1);
    let sobol = options.whole("sobol", 2, 1 << 32)?.map(|draws| [draws, seed]);
    let weights = [("fixed", Weights::Fixed), ("follow", Weights::Follow)];
    let weights = options.word("weights", &weights)?.unwrap_or(Weights::Fixed);
    Ok(Box::new(move |engines, watch| {
        let own = &engines[0];
        let engine = own.engine();
        let named = |text: &String| Output::named(text, engine).map_err(Failure::refused);
        let outputs = names.iter().map(named).collect::<Result<Vec<Output>, Failure>>()?;
        let outputs = if outputs.is_empty() { Output::peaks() } else { outputs };
        let needs = Output::needs_of(&outputs);
        let traces = if needs.gas { own.traces()? } else { &[] };
        let speed = speed.unwrap_or(engine.speed.highest);
        let (mut point, _) = operating_point(engine, traces, speed, needs).map_err(Failure::refused)?;
        point.outer = OuterTorque::of(own.file.tasks.simulation.as_deref()).map_err(Failure::refused)?;
        point.weights = weights;
        let request = SensitivityRequest { outputs, each, amounts: amounts.clone(), only, sobol };
        let found = sensitivity_watched(&point, &request, &|| watch.goes_on()).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| sensitivity_text(found),
                tables: |found, _| sensitivity_tables(found),
                figures: |found, _| vec![tornado_figure(found)],
                ..Shown::default()
            },
        ))
    }))
}

/// The request behind the arguments of a scatter.
fn scatter_request(options: &Options<'_>) -> Result<SavedScatter, Failure> {
    let usual = ScatterOptions::default();
    Ok(SavedScatter {
        speed: options.speed("speed")?,
        samples: options.whole("samples", 1, 1 << 40)?.unwrap_or(usual.samples),
        seed: options.whole("seed", 0, u64::MAX)?.unwrap_or(usual.seed),
        orders_only: options.flag("orders_only")?.unwrap_or(false),
        limits: options.texts("limit")?,
        capability: options.number("capability")?.unwrap_or(usual.capability),
    })
}

fn sample_study(saved: &SavedScatter, own: &Prepared, keeps_samples: bool) -> Result<SampleStudy, Failure> {
    let limit = |text: &String| option::limit(text, own.engine(), "limit");
    let asked = saved.options(saved.limits.iter().map(limit).collect::<Result<_, _>>()?);
    let request = asked.request(own.engine(), &own.file.tasks.tolerances).map_err(Failure::refused)?;
    let scattering = Scattering::new(request).map_err(Failure::refused)?;
    Ok(SampleStudy { scattering, keeps_samples })
}

fn read_scatter(options: &Options<'_>) -> Result<Run, Failure> {
    let saved = scatter_request(options)?;
    Ok(Box::new(move |engines, watch| {
        let own = &engines[0];
        let study = sample_study(&saved, own, false)?;
        let tally = run_study(&study, watch)?;
        let found = scattered(own, &saved, &study, &tally)?;
        found.ok_or_else(|| Failure::Internal("no sample was drawn".into()))
    }))
}

/// The same scatter with its samples as rows, in blocks.
pub fn scatter_blocks(options: &Options<'_>, own: &Arc<Prepared>) -> Result<Box<dyn Blocks>, Failure> {
    let saved = scatter_request(options)?;
    let study = sample_study(&saved, own, true)?;
    let head = Head::new("scatter", &saved, &own.text)?;
    let own = own.clone();
    Ok(Box::new(Tabled {
        study,
        head,
        fail: Failure::refused,
        answer: Box::new(move |study, tally| scattered(&own, &saved, study, tally)),
    }))
}

/// What is told of the samples that were drawn; `None` of no sample.
fn scattered(
    own: &Arc<Prepared>,
    saved: &SavedScatter,
    study: &SampleStudy,
    tally: &Tally,
) -> Result<Option<Data>, Failure> {
    let found = scatter_study_of(&study.scattering, tally, saved.capability).map_err(Failure::refused)?;
    Ok(found.map(|found| {
        let shown = Shown {
            text: |found, _| scatter_text(found),
            tables: |found, _| {
                let limits = scatter_limit_table(found);
                [Some(scatter_table(found)), limits, Some(tolerance_table(found))]
                    .into_iter()
                    .flatten()
                    .collect()
            },
            figures: |found, _| vec![scatter_figure(found)],
            ..Shown::default()
        };
        Data::new(found, own, shown)
    }))
}
