//! The atlas as a page of the book.

use crate::atlas::{Atlas, AtlasFigure, AtlasNumber, AtlasSource, FigureVerdict};
use std::fmt::Write;

/// The page of the book, with its figures in `images/atlas`.
pub fn atlas_markdown(atlas: &Atlas) -> String {
    let mut out = String::from(
        "# Atlas of the sources' figures\n\n\
         <!-- written by `lanchester validate --figures FOLDER --markdown`; a test holds it against the program -->\n\n\
         Every figure of the four sources that shows something computable, drawn from our numbers under its own number. No curve is traced\n\
         from a picture: each comes from the engine file of its source, by the same computation as the numbers of [Validation](validation.md).\n\
         Numbers that a source prints of a figure stand below it. What the source does not say and was chosen is said.\n\n\
         ```sh\nlanchester validate --figures atlas\n```\n\n\
         writes these pictures, the values of their curves as CSV, and a page `index.html`; `lanchester validate 'Figure 18' --figures atlas` writes one of them.\n\n",
    );
    let _ = writeln!(out, "{} figures:\n\n| figures | here |\n|---:|---|", atlas.figures().count());
    for verdict in FigureVerdict::ALL {
        let count = atlas.count(verdict);
        if count > 0 {
            let _ = writeln!(out, "| {count} | {} |", verdict.name());
        }
    }
    for source in &atlas.sources {
        section(&mut out, source);
    }
    out
}

fn section(out: &mut String, source: &AtlasSource) {
    let _ = writeln!(out, "\n## {}\n\n{}\n", source.title, source.citation);
    out.push_str("| not drawn here | shows | why |\n|---|---|---|\n");
    for figure in source.figures.iter().filter(|figure| figure.svg.is_none()) {
        let mut why = figure.verdict.name().to_string();
        if let Some(remark) = &figure.remark {
            why += &format!(". {remark}");
        }
        if let Some(command) = &figure.command {
            why += &format!(": `{command}`");
        }
        let _ = writeln!(out, "| {} | {} | {why} |", figure.number, figure.title);
    }
    source.figures.iter().filter(|figure| figure.svg.is_some()).for_each(|own| drawn(out, own));
}

fn drawn(out: &mut String, figure: &AtlasFigure) {
    let title = format!("Figure {}: {}", figure.number, figure.title);
    let _ = writeln!(out, "\n### {title}\n");
    match &figure.svg {
        Some(Err(why)) => {
            let _ = writeln!(out, "Cannot be drawn: {why}");
        }
        _ => {
            let _ = writeln!(out, "![{title}](images/atlas/{})", figure.file());
        }
    }
    let lines = [
        (!figure.engines.is_empty()).then(|| format!("Engine: {}.", figure.engines.join("; "))),
        figure.chosen.as_ref().map(|chosen| format!("Chosen: {chosen}")),
        figure.remark.clone(),
    ];
    for line in lines.into_iter().flatten() {
        let _ = writeln!(out, "\n{line}");
    }
    if !figure.printed.is_empty() {
        out.push_str("\n| printed in | quantity | printed | ours | verdict |\n|---|---|---:|---:|---|\n");
        figure.printed.iter().for_each(|number| numbers(out, number));
    }
}

fn numbers(out: &mut String, AtlasNumber { table, row, .. }: &AtlasNumber) {
    let verdict = match &row.reason {
        Some(reason) => format!("{}: {reason}", row.verdict),
        None => row.verdict.to_string(),
    };
    let quantity = match &row.column {
        Some(column) => format!("{}, {column}", row.quantity),
        None => row.quantity.clone(),
    };
    let with_unit = |text: &str| format!("{text} {}", row.unit).trim().to_string();
    let cells = [table.clone(), quantity, with_unit(&row.printed), with_unit(&row.ours), verdict];
    let _ = writeln!(out, "| {} |", cells.map(|cell| cell.replace('|', "\\|")).join(" | "));
}
