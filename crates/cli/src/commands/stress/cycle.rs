//! `lanchester stress cycle`: the flexible crankshaft in its bearings.

use super::safety::{endures, is_safe, wanted_safety};
use super::said::say;
use crate::commands::bearings::wanted_film;
use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::figures::write_figures;
use crate::files::{print, tell};
use crate::format::Format;
use crate::options::stress::CycleArguments;
use crate::requests::stress::cycle_request;
use crate::run::table_file;
use crate::simulation_watch::Interruptible;
use crate::trace_files::trace_files;
use crate::watch::is_due;
use lanchester::report::{
    CrankCycle, CrankKind, CycleLaw, crank_cycle_figures, cycle_brief, cycle_csv, cycle_text,
};
use lanchester::{CycleStage, crank_cycle};
use std::cell::RefCell;
use std::time::Instant;

pub fn cycle(arguments: &CycleArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let own = &arguments.mesh;
    let safety = wanted_safety(arguments.safety)?;
    let least_film = match &arguments.least_film {
        Some(text) => Some(wanted_film(text)?),
        None => None,
    };
    let form = arguments.save.as_deref().map(table_file::form).transpose()?;
    let opened = open(&own.file, colour)?;
    let request = cycle_request(arguments, &opened.file)?;
    let engine = &opened.file.engine;
    let traces = if request.gas { trace_files(engine, &own.file)? } else { Vec::new() };
    let run = Interruptible::listening();
    let progress = Progress::default();
    let watch = |stage| {
        progress.hear(stage);
        run.goes_on()
    };
    let found = crank_cycle(engine, &traces, &request, &watch).map_err(Failure::refused)?;
    progress.end();
    if let (Some(path), Some(form)) = (&arguments.save, form) {
        table_file::save(path, form, found.traces())?;
        tell(format_args!("{} written", lanchester_files::shown(path)));
    }
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &own.file, &crank_cycle_figures(&found))?;
    }
    print(&match arguments.format {
        Format::Text => arguments.printed.text(|| cycle_text(&found), || cycle_brief(&found)),
        Format::Json => json(&found)?,
        Format::Csv => arguments.printed.csv(cycle_csv(&found)),
    })?;
    Ok(verdict(&found, safety, arguments.fatigue_safety, least_film))
}

/// Says which limit fails.
fn verdict(found: &CrankCycle, safety: Option<f64>, fatigue: Option<f64>, least_film: Option<f64>) -> u8 {
    let mut status = DONE;
    if !found.is_sound() {
        tell("a run has no sound end: see how the cycles ended");
        status = NOT_AS_EXPECTED;
    }
    if !is_safe(found.static_safety(), safety) {
        status = NOT_AS_EXPECTED;
    }
    if let Some(wanted) = fatigue {
        match found.weakest() {
            Some((run, fillet)) if endures(fillet, &format!("bearings: {}", run.name()), wanted) => {}
            Some(_) => status = NOT_AS_EXPECTED,
            None => {
                tell(
                    "no safety against fatigue is known: give tensile_strength in [crank.material], and fillets in [crank.body]",
                );
                status = NOT_AS_EXPECTED;
            }
        }
    }
    if let Some(wanted) = least_film {
        let touching = found.touching_ends().filter(|(_, film)| !film.is_tilted);
        if let Some((name, _)) = &touching {
            tell(format_args!(
                "the least film is not known: at the ends of {name} the journal leans through its film, which feels the tilt with --tilt"
            ));
            status = NOT_AS_EXPECTED;
        }
        match found.least_film() {
            _ if touching.is_some() => {}
            Some(film) if film >= wanted => {}
            Some(film) => {
                tell(format_args!(
                    "the least film is {:.3} um, wanted are {:.3} um",
                    1e6 * film,
                    1e6 * wanted
                ));
                status = NOT_AS_EXPECTED;
            }
            None => {
                tell("no bearing has an oil film: add film to --bearings");
                status = NOT_AS_EXPECTED;
            }
        }
    }
    status
}

/// What is said on standard error while it runs.
#[derive(Default)]
struct Progress(RefCell<Heard>);

#[derive(Default)]
struct Heard {
    run: Option<(CycleLaw, CrankKind, Instant)>,
    cycles: usize,
    said: Option<f64>,
}

impl Progress {
    fn hear(&self, stage: CycleStage) {
        let CycleStage::Running { law, crank, state } = stage else {
            match stage {
                CycleStage::Mesh(stage) => say(stage),
                CycleStage::Reduced(coordinates, nodes) => tell(format_args!(
                    "reduced: {coordinates} coordinates, stress at {nodes} nodes of fillets"
                )),
                CycleStage::Running { .. } => {}
            }
            return;
        };
        let mut heard = self.0.borrow_mut();
        if heard.run.is_none_or(|(own, kind, _)| (own, kind) != (law, crank)) {
            heard.finish();
            *heard = Heard { run: Some((law, crank, Instant::now())), ..Heard::default() };
        }
        heard.cycles = state.cycles;
        let Some((.., began)) = heard.run else { return };
        let elapsed = began.elapsed().as_secs_f64();
        if is_due(elapsed, heard.said, false) {
            heard.said = Some(elapsed);
            let change = |value: f64| {
                if value.is_finite() { format!("{value:.1e}") } else { "not known yet".to_owned() }
            };
            let of_speed = state
                .speed_change
                .map_or_else(String::new, |value| format!(", of the free speed {}", change(value)));
            eprintln!(
                "{}: cycle {}, {:.0} %; change of orbits {}, of loads {}{of_speed}",
                heard.name(),
                state.cycles + 1,
                100.0 * state.part,
                change(state.orbit_change),
                change(state.stress_change)
            );
        }
    }

    fn end(&self) {
        self.0.borrow().finish();
    }
}

impl Heard {
    fn name(&self) -> String {
        let Some((law, crank, _)) = self.run else { return String::new() };
        let crank = if crank == CrankKind::Rigid { ", rigid crankshaft" } else { "" };
        format!("{} bearings{crank}", law.name())
    }

    fn finish(&self) {
        if let Some((.., began)) = self.run {
            tell(format_args!(
                "{}: {} cycles in {:.1} s",
                self.name(),
                self.cycles + 1,
                began.elapsed().as_secs_f64()
            ));
        }
    }
}
