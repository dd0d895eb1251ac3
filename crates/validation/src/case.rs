//! One engine of a table: its file's text with the table's changes, read and computed.

use crate::files::Source;
use crate::fitting::Fitting;
use crate::gas_run::GasRun;
use crate::inputs::inputs;
use crate::shape::ShapeFit;
use crate::source::{Change, Edit, KinematicsName, NewValue};
use crate::stress::{StressFit, StressRun};
use crate::value::Ours;
use lanchester::file::workshop::read_sheet;
use lanchester::file::{EngineFile, read};
use lanchester::mechanism::{Kinematics, LoadRequest, Loads, Part, PeakMode, loads};
use lanchester::model::Engine;
use lanchester::report::CrankCycle;
use lanchester::task::workshop::Sheet;
use std::collections::HashMap;
use std::sync::{Arc, OnceLock};

/// An engine and its loads.
pub(crate) struct Run {
    pub engine: Engine,
    /// The engine with what its file asks of it.
    pub file: EngineFile,
    pub loads: Loads,
    pub shape: ShapeFit,
    pub stress_fit: StressFit,
    /// Static stress, once it was asked for.
    pub stress: OnceLock<Result<StressRun, String>>,
    /// The flexible crankshaft over the cycle, once it was asked for.
    pub cycle: OnceLock<Result<CrankCycle, String>>,
    pub kinematics: Kinematics,
    /// Every quantity that went in, in SI units.
    pub inputs: Vec<f64>,
    /// Step of the speeds among which the largest power is looked for [rpm]; none: all speeds.
    pub power_step: Option<f64>,
    /// What the gas does, once it was asked for.
    pub gas: OnceLock<Result<GasRun, String>>,
}

impl Run {
    /// What its gas does.
    pub fn with_gas(&self) -> Result<&GasRun, String> {
        let found = self.gas.get_or_init(|| GasRun::of(&self.engine, self.kinematics));
        found.as_ref().map_err(Clone::clone)
    }

    /// The twin thesis's `M_z`: balance shafts and weights, without side thrust and torque reaction.
    pub fn roll_of_shafts(&self) -> Vec<f64> {
        let weights = [Part::Counterweights, Part::Shafts];
        let traces: Vec<_> = self
            .loads
            .parts
            .iter()
            .filter(|p| weights.contains(&p.part))
            .map(|p| &p.loads.trace.roll_moment)
            .collect();
        (0..self.loads.total.trace.theta.len()).map(|i| traces.iter().map(|t| t[i]).sum()).collect()
    }
}

/// Keeps what was computed, for a table asks for the same engine many times.
#[derive(Default)]
pub(crate) struct Bench {
    runs: HashMap<String, Arc<Run>>,
    /// Values of cells by all that they depend on.
    pub values: HashMap<String, Result<Ours, String>>,
}

impl Bench {
    /// Reads and computes the engine that the first edit names, after the others.
    pub fn run(
        &mut self,
        source: &Source,
        edits: &[Edit],
        kinematics: KinematicsName,
        about: Option<&str>,
    ) -> Result<Arc<Run>, String> {
        let (text, fitting) = engine_text(source, edits)?;
        let changes: Vec<&Change> = edits.iter().filter_map(|edit| change_of(source, edit).ok()).collect();
        let mut request = LoadRequest { kinematics: kinematics.kinematics(), ..LoadRequest::default() };
        if let Some(grid) = source.grid {
            request.peaks = PeakMode::Grid(grid);
            request.samples = grid;
        }
        let id = format!("{text}\n{fitting:?} {request:?} {about:?}");
        if let Some(run) = self.runs.get(&id) {
            return Ok(run.clone());
        }
        let reading = read(&text);
        let Some(EngineFile { engine, tasks }) = reading.file else {
            let messages: Vec<_> = reading.diagnostics.iter().map(|d| d.message.clone()).collect();
            return Err(messages.join("; "));
        };
        let engine = fitting.fitted(engine, &request)?;
        if let Some(about) = about {
            request.reference = reference_point(&engine, about)?;
        }
        let loads = loads(&engine, &request).map_err(|error| error.to_string())?;
        let run = Arc::new(Run {
            file: EngineFile { engine: engine.clone(), tasks },
            engine,
            loads,
            inputs: inputs(&text, &changes),
            power_step: fitting.power_step,
            shape: fitting.shape,
            stress_fit: fitting.stress,
            stress: OnceLock::new(),
            cycle: OnceLock::new(),
            kinematics: request.kinematics,
            gas: OnceLock::new(),
        });
        self.runs.insert(id, run.clone());
        Ok(run)
    }
}

/// Reads the workshop sheet that the first edit names, after the others; with every quantity that it holds.
pub(crate) fn sheet(source: &Source, edits: &[Edit]) -> Result<(Sheet, Vec<f64>), String> {
    let (text, _) = engine_text(source, edits)?;
    let reading = read_sheet(&text);
    let messages = || reading.diagnostics.iter().map(|d| d.message.clone()).collect::<Vec<_>>().join("; ");
    let sheet = reading.sheet.clone().ok_or_else(messages)?;
    Ok((sheet, inputs(&text, &[])))
}

fn reference_point(engine: &Engine, about: &str) -> Result<[f64; 3], String> {
    let weights = engine.shafts.first().map(|s| s.weights.as_slice());
    match (about, weights) {
        ("front shaft weight", Some([front, ..])) => Ok([0.0, 0.0, front.z]),
        ("middle of the shaft", Some([front, .., rear])) => Ok([0.0, 0.0, 0.5 * (front.z + rear.z)]),
        _ => Err(format!("no point is called {about:?} in this engine")),
    }
}

/// Text of the engine file after all edits, and what is fitted to the engine.
fn engine_text(source: &Source, edits: &[Edit]) -> Result<(String, Fitting), String> {
    let mut fitting = Fitting::default();
    let mut edits = edits.iter();
    let Some(Edit::Named(file)) = edits.next() else {
        return Err("the first edit must name an engine file".to_string());
    };
    let engine = source.engines.get(file).ok_or_else(|| format!("no engine file is called {file:?}"))?;
    let mut lines: Vec<String> = engine.lines().map(str::to_string).collect();
    for edit in edits {
        apply(&mut lines, &mut fitting, change_of(source, edit)?)?;
    }
    Ok((lines.join("\n") + "\n", fitting))
}

fn change_of<'a>(source: &'a Source, edit: &'a Edit) -> Result<&'a Change, String> {
    match edit {
        Edit::Named(name) => source.changes.get(name).ok_or_else(|| format!("no change is called {name:?}")),
        Edit::Written(change) => Ok(change),
    }
}

fn apply(lines: &mut Vec<String>, fitting: &mut Fitting, change: &Change) -> Result<(), String> {
    for (place, value) in change {
        if fitting.take(place, value)? {
            continue;
        }
        match (place.as_str(), value) {
            ("append", NewValue::Lines(more)) => lines.extend(more.iter().cloned()),
            (_, NewValue::Text(value)) => set(lines, place, &format!("\"{value}\""))?,
            (_, NewValue::Gone(())) => remove(lines, place)?,
            _ => return Err(format!("{place:?} cannot take lines")),
        }
    }
    Ok(())
}

/// Name of the section that a line opens.
fn section(line: &str) -> Option<&str> {
    let header = line.split('#').next()?.trim();
    Some(header.strip_prefix('[')?.trim_start_matches('[').trim_end_matches(']'))
}

/// Lines of the first section of this name without its header; the name "" is the head of the file.
fn section_lines(lines: &[String], name: &str) -> Option<std::ops::Range<usize>> {
    let start = if name.is_empty() { 0 } else { lines.iter().position(|l| section(l) == Some(name))? + 1 };
    let length = lines[start..].iter().position(|l| section(l).is_some()).unwrap_or(lines.len() - start);
    Some(start..start + length)
}

fn find(lines: &[String], place: &str) -> Result<(std::ops::Range<usize>, Option<usize>, String), String> {
    let (name, key) = place.rsplit_once('.').unwrap_or(("", place));
    let range =
        section_lines(lines, name).ok_or_else(|| format!("the engine file has no section {name:?}"))?;
    let is_key = |line: &String| line.split_once('=').is_some_and(|(k, _)| k.trim() == key);
    let at = lines[range.clone()].iter().position(is_key).map(|i| range.start + i);
    Ok((range, at, key.to_string()))
}

fn set(lines: &mut Vec<String>, place: &str, value: &str) -> Result<(), String> {
    let (range, at, key) = find(lines, place)?;
    let line = format!("{key} = {value}");
    match at {
        Some(at) => lines[at] = line,
        None => lines.insert(range.start, line),
    }
    Ok(())
}

/// Takes out a key, or a whole section.
fn remove(lines: &mut Vec<String>, place: &str) -> Result<(), String> {
    if !place.contains('.')
        && let Some(range) = section_lines(lines, place)
    {
        lines.drain(range.start - 1..range.end);
        return Ok(());
    }
    let (_, at, _) = find(lines, place)?;
    let at = at.ok_or_else(|| format!("the engine file has no {place:?}"))?;
    lines.remove(at);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn changed(place: &str, value: NewValue) -> Result<String, String> {
        let text = "speed = '1 rpm'\n[rod] # long\nmass = '1 kg'\nlength = '2 m'\n[a]\nmass = '3 kg'";
        let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
        apply(&mut lines, &mut Fitting::default(), &Change::from([(place.to_string(), value)]))?;
        Ok(lines.join("|"))
    }

    #[test]
    fn changes_replace_add_and_remove_lines() {
        let text = |t: &str| NewValue::Text(t.to_string());
        assert_eq!(
            changed("rod.mass", text("5 kg")).unwrap(),
            "speed = '1 rpm'|[rod] # long|mass = \"5 kg\"|length = '2 m'|[a]|mass = '3 kg'"
        );
        assert_eq!(
            changed("speed", text("2 rpm")).unwrap(),
            "speed = \"2 rpm\"|[rod] # long|mass = '1 kg'|length = '2 m'|[a]|mass = '3 kg'"
        );
        assert!(changed("a.radius", text("1 m")).unwrap().ends_with("[a]|radius = \"1 m\"|mass = '3 kg'"));
        assert_eq!(changed("rod", NewValue::Gone(())).unwrap(), "speed = '1 rpm'|[a]|mass = '3 kg'");
        assert!(
            changed("rod.length", NewValue::Gone(())).unwrap().contains("[rod] # long|mass = '1 kg'|[a]")
        );
    }

    #[test]
    fn a_change_that_finds_nothing_is_refused() {
        assert!(changed("crank.radius", NewValue::Text("1 m".into())).is_err());
        assert!(changed("rod.inertia", NewValue::Gone(())).is_err());
        assert!(changed("rod.mass", NewValue::Lines(vec![])).is_err());
    }
}
