//! An atlas of the sources' figures: each that shows something computable, drawn from our numbers under its own number.
//!
//! `validation/<source>/figures.json` lists all figures of a source, those too that show nothing to compute. Numbers
//! that the source prints of a figure stand below it, with the verdict of [`crate::validate`].

mod book;
mod curve;
mod drawing;
mod graph;
mod list;
mod page;
#[cfg(test)]
mod tests;

pub use book::atlas_markdown;
pub use list::FigureVerdict;
pub use page::atlas_page;

use crate::case::Bench;
use crate::files::{Source, sources};
use crate::keeps;
use crate::result::RowResult;
use drawing::{Drawing, row_of, table_of};
use lanchester::report::{Figure, PublishedBars, PublishedCurves};
use list::{FigureEntry, FigureList, PrintedEntry};
use std::fmt::Write;

/// Figures of all sources.
#[derive(Debug, Clone, PartialEq)]
pub struct Atlas {
    /// By source, in the order of the validation page.
    pub sources: Vec<AtlasSource>,
}

/// Figures of one source.
#[derive(Debug, Clone, PartialEq)]
pub struct AtlasSource {
    /// Its folder in `validation/`.
    pub key: String,
    /// What it is called here.
    pub title: String,
    /// Author, title, place, year.
    pub citation: String,
    /// Its figures, in its order.
    pub figures: Vec<AtlasFigure>,
}

/// One figure of a source.
#[derive(Debug, Clone, PartialEq)]
pub struct AtlasFigure {
    /// Name for files and links.
    pub id: String,
    /// Its number, as printed.
    pub number: String,
    /// What it shows.
    pub title: String,
    /// Whether ours is drawn.
    pub verdict: FigureVerdict,
    /// Engines with their changes.
    pub engines: Vec<String>,
    /// What was chosen where the source does not say.
    pub chosen: Option<String>,
    /// Why it is not drawn, or what differs.
    pub remark: Option<String>,
    /// The command that draws it instead.
    pub command: Option<String>,
    /// Numbers that the source prints of it.
    pub printed: Vec<AtlasNumber>,
    /// Ours, as an SVG document; why not, where it should be drawn and cannot.
    pub svg: Option<Result<String, String>>,
    /// Curves with their values, in SI.
    pub curves: Vec<PublishedCurves>,
    /// Bars with their values, in SI.
    pub bars: Vec<PublishedBars>,
}

/// A number that a source prints of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct AtlasNumber {
    /// Where it is printed.
    pub table: String,
    /// It, and ours.
    pub row: RowResult,
    /// The extreme of the curve that it belongs to, in SI.
    pub drawn: Option<f64>,
}

impl AtlasFigure {
    /// The name of its file.
    pub fn file(&self) -> String {
        format!("{}.svg", self.id)
    }

    /// The values of its curves and bars: a line each.
    pub fn csv(&self) -> Option<String> {
        if self.curves.is_empty() && self.bars.is_empty() {
            return None;
        }
        let mut out = "quantity,unit,curve,abscissa,value\n".to_string();
        let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        for own in &self.curves {
            for curve in &own.curves {
                for (at, value) in &curve.points {
                    let names = [&own.quantity, &own.unit, &curve.name].map(|name| quoted(name)).join(",");
                    let _ = writeln!(out, "{names},{at},{value}");
                }
            }
        }
        for own in &self.bars {
            for (at, value) in &own.cases {
                let _ = writeln!(out, "{},{},\"\",{at},{value}", quoted(&own.quantity), quoted(&own.unit));
            }
        }
        Some(out)
    }
}

impl Atlas {
    /// All figures.
    pub fn figures(&self) -> impl Iterator<Item = &AtlasFigure> {
        self.sources.iter().flat_map(|source| &source.figures)
    }

    /// How many figures have this verdict.
    pub fn count(&self, verdict: FigureVerdict) -> usize {
        self.figures().filter(|figure| figure.verdict == verdict).count()
    }

    /// Whether every figure that should be drawn is, and every number below a figure is as expected.
    pub fn passed(&self) -> bool {
        self.figures().all(|figure| {
            !matches!(figure.svg, Some(Err(_))) && figure.printed.iter().all(|number| number.row.ok)
        })
    }
}

/// Draws the figures of all sources, or those whose "source Figure 18" holds the filter, as in [`crate::validate`].
///
/// ```
/// let atlas = lanchester_validation::atlas(Some("twin-cylinder-thesis Figure 18"));
/// assert!(atlas.passed() && atlas.figures().count() == 1);
/// ```
pub fn atlas(filter: Option<&str>) -> Atlas {
    let mut bench = Bench::default();
    let all = sources();
    let of_source = |source: &Source| {
        let list = FigureList::of(source)?;
        let kept = |entry: &&FigureEntry| {
            filter.is_none_or(|filter| keeps(filter, &format!("{} Figure {}", source.key, entry.figure)))
        };
        let figures: Vec<AtlasFigure> = list
            .figures
            .iter()
            .filter(kept)
            .map(|entry| {
                let from = all.iter().find(|own| entry.from.as_ref().is_some_and(|key| own.key == *key));
                let id = format!("{}-figure-{}", list.short, entry.figure.replace('.', "-"));
                figure(&mut bench, from.unwrap_or(source), (&source.title, id), entry)
            })
            .collect();
        let Source { key, title, citation, .. } = source;
        let [key, title, citation] = [key, title, citation].map(Clone::clone);
        (!figures.is_empty()).then_some(AtlasSource { key, title, citation, figures })
    };
    Atlas { sources: all.iter().filter_map(of_source).collect() }
}

/// A figure, with the engines and tables of a source: the one that prints it, whose title is given with the figure's name, or another.
fn figure(
    bench: &mut Bench,
    source: &Source,
    (title, id): (&str, String),
    entry: &FigureEntry,
) -> AtlasFigure {
    let drawn = match entry.verdict {
        FigureVerdict::Drawn => Some(Drawing::of(bench, source, &entry.draw)),
        _ => None,
    };
    let (drawing, failed) = match drawn {
        Some(Ok(drawing)) => (drawing, None),
        Some(Err(why)) => (Drawing::default(), Some(why)),
        None => (Drawing::default(), None),
    };
    let mut printed = Vec::new();
    let mut missing = None;
    for number in &entry.printed {
        match numbers(bench, source, number, &drawing) {
            Ok(found) => printed.extend(found),
            Err(why) => missing = Some(why),
        }
    }
    let svg = match (entry.verdict, failed.or(missing)) {
        (_, Some(why)) => Some(Err(why)),
        (FigureVerdict::Drawn, None) => Some(Ok(document(&id, title, entry, &drawing))),
        (_, None) => None,
    };
    AtlasFigure {
        id,
        number: entry.figure.clone(),
        title: entry.title.clone(),
        verdict: entry.verdict,
        engines: drawing.engines,
        chosen: entry.chosen.clone(),
        remark: entry.remark.clone(),
        command: entry.command.clone(),
        printed,
        svg,
        curves: drawing.curves,
        bars: drawing.bars,
    }
}

/// Numbers of a table that belong to a figure.
fn numbers(
    bench: &mut Bench,
    source: &Source,
    entry: &PrintedEntry,
    drawing: &Drawing,
) -> Result<Vec<AtlasNumber>, String> {
    let columns: Vec<String> = entry.column.iter().cloned().collect();
    let asked = (entry.section.as_deref(), entry.quantity.as_str());
    let rows = row_of(bench, source, table_of(source, &entry.table)?, asked, &columns)?;
    let drawn = match &entry.curve {
        None => None,
        Some(curve) => {
            let found = drawing.extreme(curve, entry.extreme);
            Some(found.ok_or_else(|| format!("the figure has no curve {curve:?}"))?)
        }
    };
    Ok(rows.into_iter().map(|row| AtlasNumber { table: entry.table.clone(), row, drawn }).collect())
}

fn document(id: &str, source: &str, entry: &FigureEntry, drawing: &Drawing) -> String {
    if let Some(document) = &drawing.document {
        return document.clone();
    }
    let mut caption = format!("{}. From our numbers.", capital(&entry.title));
    if let Some(chosen) = &entry.chosen {
        caption += &format!(" Chosen: {chosen}");
    }
    if let Some(remark) = &entry.remark {
        caption += &format!(" {remark}");
    }
    Figure {
        id: id.to_string(),
        title: format!("{source}, Figure {}", entry.figure),
        caption,
        panels: drawing.panels.clone(),
        columns: 2,
    }
    .svg()
}

/// With a capital at its beginning.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
