//! The drawings of a figure, from computed values.

use crate::atlas::curve::{CurveKey, Samples, halves};
use crate::atlas::graph;
use crate::atlas::list::{
    AngleEntry, BarsEntry, CurveEntry, DrawEntry, ExtremeName, TableEntry, VectorsEntry,
};
use crate::case::{Bench, Run};
use crate::files::Source;
use crate::gas::PowerCubic;
use crate::result::RowResult;
use crate::source::{Edit, Row, Table};
use crate::validate_rows;
use lanchester::literature::{SweepOptions, swept};
use lanchester::report::{
    Abscissa, Figure, Panel, PointsAs, PublishedBars, PublishedCurve, PublishedCurves, PublishedVectors,
    crank_curve, front_view, side_view,
};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// What a figure is made of.
#[derive(Default)]
pub(crate) struct Drawing {
    pub panels: Vec<Panel>,
    /// Curves with their values, in SI.
    pub curves: Vec<PublishedCurves>,
    /// Bars with their values, in SI.
    pub bars: Vec<PublishedBars>,
    /// Sums of vectors by their quantity, in SI.
    pub sums: Vec<(String, f64)>,
    /// A document of its own in place of panels.
    pub document: Option<String>,
    /// Engines with their changes.
    pub engines: Vec<String>,
}

impl Drawing {
    /// All drawings of a figure.
    pub fn of(bench: &mut Bench, source: &Source, entries: &[DrawEntry]) -> Result<Drawing, String> {
        let mut drawing = Drawing::default();
        for entry in entries {
            drawing.add(bench, source, entry)?;
        }
        Ok(drawing)
    }

    fn add(&mut self, bench: &mut Bench, source: &Source, entry: &DrawEntry) -> Result<(), String> {
        match entry {
            DrawEntry::Angle(entry) => {
                self.name_engine(&entry.engine);
                self.add_curves(angle(bench, source, entry)?);
            }
            DrawEntry::Table(entry) => {
                for curves in over_table(bench, source, entry)? {
                    self.add_curves(curves);
                }
                self.name_engine(&table_of(source, &entry.table)?.engine);
            }
            DrawEntry::Bars(entry) => {
                let bars = bars(bench, source, entry)?;
                self.name_engine(&table_of(source, &entry.table)?.engine);
                self.panels.push(bars.panel());
                self.bars.push(bars);
            }
            DrawEntry::Vectors(entry) => {
                self.name_engine(&entry.engine);
                let vectors = vectors(bench, source, entry)?;
                self.panels.push(vectors.panel());
                self.sums.push((vectors.quantity.clone(), vectors.sum().norm()));
            }
            DrawEntry::Sweep { engine } => {
                self.name_engine(engine);
                self.panels.extend(sweep(bench, source, engine)?.panels);
            }
            DrawEntry::Power { engine } => {
                self.name_engine(engine);
                for curves in power(bench, source, engine)? {
                    self.add_curves(curves);
                }
            }
            DrawEntry::Engine { engine } => {
                self.name_engine(engine);
                let run = bench.run(source, engine, source.kinematics, None)?;
                self.panels.extend(side_view(&run.engine).panels);
                self.panels.extend(front_view(&run.engine).panels);
            }
            DrawEntry::Run(entry) => {
                self.engines.push(entry.engine.clone());
                self.panels.extend(graph::run(source, entry)?.panels);
            }
            DrawEntry::Graph(entry) => {
                self.engines.extend(entry.engine.iter().chain(&entry.graph).cloned());
                self.document = Some(graph::drawn(source, entry)?);
            }
        }
        Ok(())
    }

    fn add_curves(&mut self, curves: PublishedCurves) {
        self.panels.push(curves.panel());
        self.curves.push(curves);
    }

    fn name_engine(&mut self, edits: &[Edit]) {
        let name = edits.iter().map(Edit::to_string).collect::<Vec<_>>().join(", ");
        if !self.engines.contains(&name) {
            self.engines.push(name);
        }
    }

    /// An extreme of a curve, or the sum of vectors of this name, in SI.
    pub fn extreme(&self, name: &str, extreme: ExtremeName) -> Option<f64> {
        if let Some((_, sum)) = self.sums.iter().find(|(own, _)| own == name) {
            return Some(*sum);
        }
        let curve = self.curves.iter().flat_map(|own| &own.curves).find(|curve| curve.name == name)?;
        let values = || curve.points.iter().map(|point| point.1);
        let (highest, lowest) =
            (values().fold(f64::NEG_INFINITY, f64::max), values().fold(f64::INFINITY, f64::min));
        Some(match extreme {
            ExtremeName::Largest => highest.max(-lowest),
            ExtremeName::Lowest => -lowest,
            ExtremeName::Range => highest - lowest,
            ExtremeName::First => values().next()?,
        })
    }
}

fn angle(bench: &mut Bench, source: &Source, entry: &AngleEntry) -> Result<PublishedCurves, String> {
    let kinematics = entry.kinematics.unwrap_or(source.kinematics);
    let mut found = Vec::new();
    for CurveEntry { name, key, with } in &entry.curves {
        let edits = [entry.engine.as_slice(), with].concat();
        let run = bench.run(source, &edits, kinematics, None)?;
        found.push((name, CurveKey::parse(key)?.of(&run)?));
    }
    let samples = || found.iter().map(|(_, samples)| samples);
    let revolutions = samples().map(|own| own.revolutions).max().ok_or("a drawing needs a curve")?;
    let each = |own: &Samples| own.values.len() / own.revolutions;
    let each = samples().map(each).min().unwrap_or(0);
    let period = TAU * revolutions as f64;
    let shift = entry.shift as usize * each / 360;
    let mut curves = Vec::new();
    for (name, samples) in &found {
        let mut values = samples.over(revolutions, each)?;
        values.rotate_right(shift);
        let theta = |index: usize| period * index as f64 / values.len() as f64;
        let factor = entry.factor.unwrap_or(1.0);
        let points = values.iter().enumerate().map(|(index, value)| (theta(index), factor * value)).collect();
        curves.push(PublishedCurve { name: (*name).clone(), points, points_as: PointsAs::Line });
    }
    let (quantity, unit) = (entry.quantity.clone(), entry.unit.clone());
    Ok(PublishedCurves { quantity, unit, abscissa: Abscissa::Angle(period), curves })
}

/// The table of this name.
pub(crate) fn table_of<'a>(source: &'a Source, name: &str) -> Result<&'a Table, String> {
    let table = source.tables.iter().find(|table| table.table == name);
    table.ok_or_else(|| format!("{} has no {name}", source.key))
}

/// Our values of a row of a table, with the names of its columns.
pub(crate) fn row_of(
    bench: &mut Bench,
    source: &Source,
    table: &Table,
    (section, quantity): (Option<&str>, &str),
    columns: &[String],
) -> Result<Vec<RowResult>, String> {
    let of = |row: &Row| row.quantity == quantity && (section.is_none() || row.section.as_deref() == section);
    if table.rows.iter().filter(|row| of(row)).count() > 1 {
        return Err(format!("{} has more than one row {quantity:?}", table.table));
    }
    let rows = validate_rows(bench, source, table, |row, column| {
        of(row) && (columns.is_empty() || column.is_some_and(|column| columns.contains(&column.name)))
    });
    if rows.is_empty() { Err(format!("{} has no row {quantity:?}", table.table)) } else { Ok(rows) }
}

/// Values of rows; what is less than a millionth of their last printed digit is rounding.
fn numbers(rows: &[RowResult]) -> Result<Vec<f64>, String> {
    let of = |row: &RowResult| {
        let value = row.value.ok_or_else(|| row.ours.clone())?;
        Ok(if value.abs() < 1e-6 * row.tolerance.unwrap_or(0.0) { 0.0 } else { value })
    };
    rows.iter().map(of).collect()
}

fn over_table(
    bench: &mut Bench,
    source: &Source,
    entry: &TableEntry,
) -> Result<Vec<PublishedCurves>, String> {
    let table = table_of(source, &entry.table)?;
    let over = row_of(bench, source, table, (None, &entry.abscissa), &[])?;
    let unit = over.first().map_or_else(String::new, |row| row.unit.clone());
    let over = numbers(&over)?;
    let mut found = Vec::new();
    for name in &entry.ordinates {
        let rows = row_of(bench, source, table, (None, name), &[])?;
        let points = over.iter().copied().zip(numbers(&rows)?).collect();
        found.push(PublishedCurves {
            quantity: name.clone(),
            unit: rows.first().map_or_else(String::new, |row| row.unit.clone()),
            abscissa: Abscissa::Quantity(entry.abscissa.clone(), unit.clone()),
            curves: vec![PublishedCurve { name: name.clone(), points, points_as: PointsAs::MarkedLine }],
        });
    }
    Ok(found)
}

fn bars(bench: &mut Bench, source: &Source, entry: &BarsEntry) -> Result<PublishedBars, String> {
    let table = table_of(source, &entry.table)?;
    let rows = row_of(bench, source, table, (None, &entry.quantity), &entry.columns)?;
    let mut cases = Vec::new();
    for (row, value) in rows.iter().zip(numbers(&rows)?) {
        let number = row.column.as_deref().and_then(|name| name.parse().ok());
        cases.push((number.ok_or("bars need columns with numbers")?, value));
    }
    let level = match &entry.level {
        None => None,
        Some(level) => {
            let of = table_of(source, &level.table)?;
            let value = numbers(&row_of(bench, source, of, (None, &level.quantity), &[])?)?;
            Some((level.name.clone(), value[0]))
        }
    };
    let quantity = match &entry.name {
        Some(name) => format!("{}: {name}", entry.quantity),
        None => entry.quantity.clone(),
    };
    let unit = rows.first().map_or_else(String::new, |row| row.unit.clone());
    Ok(PublishedBars { quantity, unit, cases, level })
}

fn vectors(bench: &mut Bench, source: &Source, entry: &VectorsEntry) -> Result<PublishedVectors, String> {
    let run = bench.run(source, &entry.engine, source.kinematics, None)?;
    let arrows = run.loads.cylinders.iter().map(|cylinder| {
        let (forward, backward) = halves(&cylinder.loads, entry.order, entry.couple);
        // Cylinders along x: what turns against the crank comes of the reciprocating masses alone, and as much turns with it. Their couple is about
        // y, a quarter turn from the force.
        let (along, quarter) = if entry.couple {
            (-backward.conj(), Complex64::new(0.0, -1.0))
        } else {
            (backward.conj(), Complex64::new(1.0, 0.0))
        };
        let arrow = quarter * if entry.rotating { forward - along } else { 2.0 * along };
        (format!("cyl. {}", cylinder.cylinder), arrow)
    });
    let (quantity, unit) = (entry.quantity.clone(), entry.unit.clone());
    Ok(PublishedVectors { quantity, unit, arrows: arrows.collect() })
}

fn sweep(bench: &mut Bench, source: &Source, engine: &[Edit]) -> Result<Figure, String> {
    let run = bench.run(source, engine, source.kinematics, None)?;
    let mut options = SweepOptions::default();
    if let Some(grid) = source.grid {
        options.angles = grid;
    }
    let found = swept(&run.engine, None, run.kinematics, &options).map_err(|error| error.to_string())?;
    Ok(crank_curve(&found.sweep, found.optimal()))
}

/// Speeds of the thesis's torques [rpm].
const SPEEDS_RPM: [f64; 4] = [1000.0, 2000.0, 3000.0, 4000.0];
/// Points of the cubic.
const POINTS: usize = 80;

fn power(bench: &mut Bench, source: &Source, engine: &[Edit]) -> Result<Vec<PublishedCurves>, String> {
    let mut torques = [0.0; 4];
    for (torque, rpm) in torques.iter_mut().zip(SPEEDS_RPM) {
        let speed = [("speed".to_string(), crate::source::NewValue::Text(format!("{rpm} rpm")))];
        let edits = [engine, &[Edit::Written(speed.into())]].concat();
        let run: Arc<Run> = bench.run(source, &edits, source.kinematics, None)?;
        *torque = run.with_gas()?.torque.indicated.torque;
    }
    let cubic = PowerCubic::through(torques);
    let rad = |rpm: f64| rpm * PI / 30.0;
    let grid = || (0..=POINTS).map(|k| SPEEDS_RPM[3] * k as f64 / POINTS as f64);
    let lowest = 0.125 * SPEEDS_RPM[3];
    let curves = |quantity: &str, unit: &str, cubic: Vec<(f64, f64)>, points: Vec<(f64, f64)>| {
        let curve =
            |name: &str, points, points_as| PublishedCurve { name: name.to_string(), points, points_as };
        PublishedCurves {
            quantity: quantity.to_string(),
            unit: unit.to_string(),
            abscissa: Abscissa::Quantity("speed".to_string(), "rpm".to_string()),
            curves: vec![curve("cubic", cubic, PointsAs::Line), curve("computed", points, PointsAs::Dots)],
        }
    };
    let points = SPEEDS_RPM.into_iter().zip(torques);
    Ok(vec![
        curves(
            "Power",
            "W",
            grid().map(|rpm| (rpm, cubic.power(rpm))).collect(),
            points.clone().map(|(rpm, torque)| (rpm, rad(rpm) * torque)).collect(),
        ),
        // A free constant over the speed has no end at rest.
        curves(
            "Torque",
            "N m",
            grid().filter(|rpm| *rpm >= lowest).map(|rpm| (rpm, cubic.power(rpm) / rad(rpm))).collect(),
            points.collect(),
        ),
    ])
}
