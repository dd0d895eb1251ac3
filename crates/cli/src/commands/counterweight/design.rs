//! `lanchester counterweight design`: the best shape for every counterweight and every weight of a balance shaft.

use super::drawings::draw;
use super::{designed_counterweights, designed_shaft_weights};
use crate::commands::balance::found::consequences;
use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::print;
use crate::format::Format;
use crate::options::counterweight::{DesignArguments, DesignMethod};
use crate::put_back::PutBack;
use crate::requests::shape::shape_request;
use lanchester::balance::Consequences;
use lanchester::file::EngineFile;
use lanchester::geometry::{Design, DesignOutcome, ShaftWeightDesign, ShaftWeightOutcome};
use lanchester::model::Engine;
use lanchester::report::{consequence_words, consequences_table};
use lanchester::{
    CounterweightDesigns, CounterweightError, CounterweightRequest, EvolutionRequest, ShaftWeightDesigns,
    ShaftWeightPlace, design_counterweights, design_shaft_weights, named_shaft_weights,
    shaft_weights_to_design, with_counterweights, with_shaft_weights,
};
use serde::Serialize;

/// What was found.
#[derive(Debug, Serialize)]
struct Found {
    #[serde(flatten)]
    counterweights: Option<CounterweightDesigns>,
    #[serde(skip_serializing_if = "Option::is_none")]
    shaft_weights: Option<ShaftWeightDesigns>,
    /// What the shapes do to the engine.
    #[serde(skip_serializing_if = "Option::is_none")]
    consequences: Option<Consequences>,
}

pub fn run(arguments: &DesignArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let opened = open(&arguments.shape.file, colour)?;
    let engine = &opened.file.engine;
    let mut found = find(&opened.file, arguments)?;
    let put_back = PutBack {
        path: &arguments.shape.file,
        write: arguments.write,
        dry_run: arguments.dry_run,
        what: "shapes",
    };
    let status = if found.is_complete() { DONE } else { NOT_AS_EXPECTED };
    if let Some(after) = found.fitted(engine)? {
        found.consequences = Some(consequences(engine, &after, None)?);
        if put_back.run(&opened, &after, colour)? {
            return Ok(status);
        }
        if let Some(folder) = &arguments.figures {
            draw(&after, folder, &arguments.shape.file)?;
        }
    }
    let said = match arguments.format {
        Format::Text => found.text(engine),
        Format::Json => json(&found)?,
        Format::Csv => found.csv(engine),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(status)
}

fn find(file: &EngineFile, arguments: &DesignArguments) -> Result<Found, Failure> {
    let EngineFile { engine, tasks } = file;
    let evolution = evolution(arguments)?;
    let names = &arguments.shape.weight;
    let (named, others) = named_shaft_weights(engine, names);
    let is_free = names.is_empty();
    let places = match (is_free, tasks.shaft_weight_task) {
        (true, None) => Vec::new(),
        (true, Some(_)) => shaft_weights_to_design(engine),
        (false, _) => named,
    };
    let has_options = arguments.shape.has_options() || evolution.is_some();
    let only_shafts = tasks.shape_task.is_none() && !has_options && tasks.shaft_weight_task.is_some();
    let wants_counterweights = if is_free { !only_shafts } else { !others.is_empty() };
    if !wants_counterweights && has_options {
        return Err(Failure::input(
            "options of shapes are for counterweights, and the weights named are those of balance shafts",
            "change the section [shaft_weight_design] of the file instead",
        ));
    }
    if places.is_empty() && !wants_counterweights {
        return Err(Failure::input(
            "no weight of a balance shaft is to be designed",
            "give a weight of a [[shaft]] an unbalance; a shape without `unbalance` beside it is fixed",
        ));
    }
    let shaft_weights = match places.is_empty() {
        true => None,
        false => Some(shafts(file, &places)?),
    };
    let counterweights = match wants_counterweights {
        false => None,
        true => {
            let weights = others.into_iter().cloned().collect();
            let request =
                CounterweightRequest { evolution, weights, ..shape_request(file, &arguments.shape)? };
            match design_counterweights(engine, &request) {
                // The file is about its shafts.
                Err(CounterweightError::NoneOnAWeb { .. }) if is_free && shaft_weights.is_some() => None,
                designs => Some(designs.map_err(Failure::refused)?),
            }
        }
    };
    Ok(Found { counterweights, shaft_weights, consequences: None })
}

fn shafts(file: &EngineFile, places: &[ShaftWeightPlace]) -> Result<ShaftWeightDesigns, Failure> {
    let Some(task) = &file.tasks.shaft_weight_task else {
        return Err(Failure::input(
            "the shapes to search for weights of balance shafts are not given",
            "add a section like\n\n  [shaft_weight_design]\n  density = \"7850 kg/m3\"\n  shaft_diameter = \"24 mm\"\n  \
             radius = [\"20 mm\", \"36 mm\"]\n  length = [\"10 mm\", \"60 mm\"]\n\nto the engine file",
        ));
    };
    design_shaft_weights(&file.engine, task, places).map_err(Failure::refused)
}

impl Found {
    /// Whether there is a shape for every weight.
    fn is_complete(&self) -> bool {
        let mut counterweights = self.counterweights.iter().flat_map(|designs| &designs.weights);
        let mut shafts = self.shaft_weights.iter().flat_map(|designs| &designs.weights);
        counterweights.all(|weight| matches!(weight.outcome, DesignOutcome::Found(_)))
            && shafts.all(|weight| matches!(weight.outcome, ShaftWeightOutcome::Best(_)))
    }

    /// The engine with the shapes; none if none was found.
    fn fitted(&self, engine: &Engine) -> Result<Option<Engine>, Failure> {
        let mut after = None;
        if let Some(designs) = &self.counterweights {
            let found = designs.weights.iter().filter_map(|weight| match &weight.outcome {
                DesignOutcome::Found(best) => Some((weight.index, best.design)),
                DesignOutcome::Infeasible(_) => None,
            });
            let found: Vec<(usize, Design)> = found.collect();
            if !found.is_empty() {
                after = Some(
                    with_counterweights(engine, &found, designs.task.density).map_err(Failure::refused)?,
                );
            }
        }
        let shafts = self.shaft_weights.iter().flat_map(|designs| &designs.weights);
        let found = shafts.filter_map(|weight| match weight.outcome {
            ShaftWeightOutcome::Best(design) => Some((weight.place, design)),
            ShaftWeightOutcome::Infeasible { .. } => None,
        });
        let found: Vec<(ShaftWeightPlace, ShaftWeightDesign)> = found.collect();
        if !found.is_empty() {
            after = Some(with_shaft_weights(after.as_ref().unwrap_or(engine), &found));
        }
        Ok(after)
    }

    fn text(&self, engine: &Engine) -> String {
        let parts = [
            self.counterweights.as_ref().map(designed_counterweights::text),
            self.shaft_weights.as_ref().map(|designs| designed_shaft_weights::text(designs, engine)),
        ];
        let effect = self.consequences.as_ref().map(|effect| {
            let words = consequence_words(effect);
            let words = if words.is_empty() { words } else { format!("{words}\n\n") };
            words + &consequences_table(effect).text()
        });
        let parts = parts.into_iter().flatten().chain(effect);
        parts.fold(format!("{}\n", engine.name), |out, part| format!("{out}\n{part}"))
    }

    fn csv(&self, engine: &Engine) -> String {
        let tables = [
            self.counterweights.as_ref().map(designed_counterweights::csv),
            self.shaft_weights.as_ref().map(|designs| designed_shaft_weights::csv(designs, engine)),
        ];
        tables.into_iter().flatten().collect::<Vec<_>>().join("\n")
    }
}

/// The evolutionary search that is asked for.
fn evolution(arguments: &DesignArguments) -> Result<Option<EvolutionRequest>, Failure> {
    match arguments.method {
        DesignMethod::Proof if arguments.seed.is_some() || arguments.evaluations.is_some() => {
            Err(Failure::input(
                "--seed and --evaluations are of the evolutionary search, which is not asked for",
                "add --method evolution, or leave them out",
            ))
        }
        DesignMethod::Proof => Ok(None),
        DesignMethod::Evolution => Ok(Some(EvolutionRequest {
            seed: arguments.seed.unwrap_or(1),
            evaluations: arguments.evaluations.unwrap_or(20_000),
        })),
    }
}
