//! Everything that one engine file tells, for the report and its figures.

use crate::consequences::consequences;
use crate::parts::check::{CounterweightCheck, check_counterweights};
use crate::parts::web_bounds::optimise_on_webs;
use crate::pressure::measured::TraceFile;
use crate::running::{Running, running};
use lanchester_balance::{Answer, BalanceSettings, Consequences, Next, fitted};
use lanchester_file::{Diagnostic, EngineFile};
use lanchester_mechanism::{
    InternalMoments, InternalRequest, LoadError, LoadRequest, Loads, PeakMode, internal_cases, loads,
};
use lanchester_model::Engine;
use lanchester_report::{
    Figure, OptimumInput, Provenance, ReportHead, Section, Table, before_and_after_in_short, bending_section,
    engine_section, figures, loads_sections, motion_section, optimum_section, peaks_in_short, report,
};
use lanchester_task::Tasks;

/// The sections of a report, computed.
#[derive(Debug, Clone)]
pub struct EngineReport<'a> {
    engine: &'a Engine,
    /// What shakes the engine.
    pub loads: Loads,
    /// Shear and bending inside the crankshafts.
    pub internal: Vec<InternalMoments>,
    optimum: Option<FoundOptimum>,
    crankshaft: Option<CounterweightCheck>,
    running: Running,
    more: Vec<Section>,
    /// Warnings of the file, then what was left out and why, each in one line.
    pub warnings: Vec<String>,
    /// How many of them the reader of the file has told of already.
    pub told: usize,
}

/// What balancing found, with the loads before and after.
#[derive(Debug, Clone)]
struct FoundOptimum {
    answer: Answer,
    before: Loads,
    fitted: Engine,
    after: Loads,
    consequences: Option<Consequences>,
}

impl<'a> EngineReport<'a> {
    /// Computes all sections that the file has enough for; a section that is left out is one more warning.
    ///
    /// `traces`: the pressures that the file names, or why they cannot be read; `warnings`: those of the reader.
    ///
    /// # Errors
    /// [`LoadError`] where the engine has no loads at all.
    pub fn new(
        file: &'a EngineFile,
        request: &LoadRequest,
        internal: &InternalRequest,
        traces: Result<&[TraceFile], String>,
        warnings: &[Diagnostic],
    ) -> Result<EngineReport<'a>, LoadError> {
        let EngineFile { engine, tasks } = file;
        let loads = loads(engine, request)?;
        let internal = internal_cases(engine, internal)?;
        let mut warnings: Vec<String> = warnings.iter().map(in_one_line).collect();
        let told = warnings.len();
        let optimum = optimum(engine, tasks, traces.clone(), &mut warnings)?;
        let crankshaft = crankshaft(engine, &mut warnings);
        let running = running(file, traces, loads.speed);
        for warning in running.all_warnings() {
            if !warnings.contains(&warning) {
                warnings.push(warning);
            }
        }
        Ok(EngineReport {
            engine,
            loads,
            internal,
            optimum,
            crankshaft,
            running,
            more: Vec::new(),
            warnings,
            told,
        })
    }

    /// Adds what takes too long to be part of every report.
    pub fn add(&mut self, sections: Vec<Section>) {
        self.more.extend(sections);
    }

    /// All that it tells, topic by topic, in the order of reading. A new topic is one more line here.
    pub fn sections(&self) -> Vec<Section> {
        let EngineReport { engine, loads, running, .. } = self;
        let mut sections = loads_sections(engine, loads);
        sections.extend(self.optimum.as_ref().map(|found| optimum_section(engine, &found.input())));
        sections.extend(bending_section(engine, &self.internal));
        sections.extend(self.crankshaft.as_ref().map(|checked| checked.section(engine)));
        sections.extend(running.sections(engine));
        sections.extend(self.more.iter().cloned());
        sections.extend([motion_section(loads), engine_section(engine)]);
        sections
    }

    /// The page.
    pub fn page(&self, provenance: &Provenance) -> String {
        let EngineReport { engine, loads, warnings, .. } = self;
        let key_numbers = self.key_numbers();
        let head = ReportHead { engine, speed: loads.speed, provenance, warnings, key_numbers: &key_numbers };
        report(&head, &self.sections())
    }

    /// The numbers of the first page: before and after where something was balanced, else the peaks as the file stands.
    fn key_numbers(&self) -> Table {
        let found = self.optimum.as_ref();
        let in_short = found.and_then(|found| {
            before_and_after_in_short(self.engine, &found.answer, found.consequences.as_ref())
        });
        in_short.unwrap_or_else(|| peaks_in_short(&self.loads))
    }

    /// The words and tables of the page as plain text, under the titles of their sections.
    pub fn text(&self) -> String {
        let titled = |section: Section| {
            let line = "=".repeat(section.title.chars().count());
            format!("{}\n{line}\n\n{}", section.title, section.text())
        };
        let told = self.sections().into_iter().filter(Section::has_text).map(titled);
        format!("{}\n\n{}", self.engine.name, told.collect::<Vec<_>>().join("\n"))
    }

    /// All tables of the page as CSV, each under a line with its name.
    pub fn csv(&self) -> String {
        let tables =
            self.sections().iter().map(Section::csv).filter(|csv| !csv.is_empty()).collect::<Vec<_>>();
        tables.join("\n")
    }

    /// All figures of the page.
    pub fn figures(&self) -> Vec<Figure> {
        figures(self.engine, &self.sections())
    }
}

impl FoundOptimum {
    fn input(&self) -> OptimumInput<'_> {
        OptimumInput {
            answer: &self.answer,
            before: &self.before,
            fitted: &self.fitted,
            after: &self.after,
            consequences: self.consequences.as_ref(),
        }
    }
}

/// What the section `[balance]` of the file asks, answered; a question without meaning is one more warning.
fn optimum(
    engine: &Engine,
    tasks: &Tasks,
    traces: Result<&[TraceFile], String>,
    warnings: &mut Vec<String>,
) -> Result<Option<FoundOptimum>, LoadError> {
    let Some(task) = &tasks.balance else { return Ok(None) };
    let answer = match optimise_on_webs(
        engine,
        traces,
        task,
        tasks.shape_task.as_ref(),
        &BalanceSettings::default(),
        &|_| Next::Continue,
    ) {
        Ok(answer) => answer,
        Err(error) => {
            warnings.push(format!("the section [balance] has no answer: {error}"));
            return Ok(None);
        }
    };
    let fitted = fitted(engine, &answer);
    let (before, after) = (loads(engine, &LoadRequest::default())?, loads(&fitted, &LoadRequest::default())?);
    let consequences = match answer.weights.is_empty() {
        true => None,
        false => match consequences(engine, &fitted, Some(task)) {
            Ok(consequences) => Some(consequences),
            Err(error) => {
                warnings.push(format!("what the optimum does to the bearings is left out: {error}"));
                None
            }
        },
    };
    Ok(Some(FoundOptimum { answer, before, fitted, after, consequences }))
}

/// The crankshaft as parts, where the file says something of it; what it leaves out is one more warning.
fn crankshaft(engine: &Engine, warnings: &mut Vec<String>) -> Option<CounterweightCheck> {
    let has_parts = engine.counterweights.iter().any(|weight| weight.part.is_some())
        || engine.shafts.iter().flat_map(|shaft| &shaft.weights).any(|weight| weight.part.is_some());
    if engine.crank_body.is_none() && !has_parts {
        return None;
    }
    match check_counterweights(engine) {
        Ok(checked) => Some(checked),
        Err(error) => {
            warnings.push(format!("the crankshaft as parts is left out: {error}").replace("\nhint:", ";"));
            None
        }
    }
}

/// A warning of the engine file in one line.
pub fn in_one_line(warning: &Diagnostic) -> String {
    let hint = warning.hint.as_ref().map_or(String::new(), |hint| format!(" ({hint})"));
    format!("line {}: {}{hint}", warning.line, warning.message)
}

/// What a report says about its own making: `program` (name, version, commit), the input, the settings behind `loads`.
pub fn provenance(
    program: &str,
    input: &str,
    text: &str,
    loads: &Loads,
    request: &LoadRequest,
) -> Provenance {
    let peaks = match request.peaks {
        PeakMode::Continuous => "true extremes over the continuous angle, to 1e-12 of their size".to_string(),
        PeakMode::Grid(angles) => format!("largest of {angles} angles a revolution"),
    };
    Provenance {
        program: program.to_string(),
        input: input.to_string(),
        input_hash: format!("FNV-1a {:016x}", fnv1a(text.as_bytes())),
        settings: vec![
            ("motion".to_string(), loads.kinematics.clone()),
            ("orders listed".to_string(), format!("0 to {}", request.max_order)),
            ("angles of the curves".to_string(), format!("{} a revolution", request.samples)),
            ("peaks".to_string(), peaks),
        ],
    }
}

/// 64-bit FNV-1a: tells whether a result belongs to a text, no protection against intent.
pub fn fnv1a(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_published_test_vectors_of_fnv1a() {
        assert_eq!(super::fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(super::fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
    }
}
