//! The atlas as a page for a browser.

use crate::atlas::{Atlas, AtlasFigure, AtlasNumber, AtlasSource};
use lanchester::report::escape;
use std::fmt::Write;

const STYLE: &str = "body{font-family:system-ui,sans-serif;line-height:1.45;max-width:66rem;margin:2rem auto;padding:0 1rem;\
color:#1c2126;background:#fff}img{max-width:100%;height:auto}figure{margin:0 0 2.5rem}h2{margin-top:3rem}\
table{border-collapse:collapse;font-size:.9rem}td,th{border-bottom:1px solid #d9dee3;padding:.2rem .6rem;text-align:left;\
vertical-align:top}.index td:first-child{white-space:nowrap}a{color:#0a5fa8}code{font-size:.9em}\
@media(prefers-color-scheme:dark){body{color:#e6e9ec;background:#14181c}td,th{border-color:#323a42}a{color:#6cb4f5}}";

/// The atlas as one page beside its figures: all figures by source, then those that are drawn.
pub fn atlas_page(atlas: &Atlas) -> String {
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>Atlas of the sources' figures</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n<h1>Atlas of the sources' figures</h1>\n\
         <p>Every published figure that shows something computable, drawn from our numbers under its own number. No curve \
         is traced from a picture. Numbers that a source prints of a figure stand below it.</p>\n"
    );
    for source in &atlas.sources {
        index(&mut out, source);
    }
    for source in &atlas.sources {
        let _ = writeln!(out, "<h2>{}: figures</h2>", escape(&source.title));
        source.figures.iter().filter(|figure| figure.svg.is_some()).for_each(|own| drawn(&mut out, own));
    }
    out.push_str("</body>\n</html>\n");
    out
}

fn index(out: &mut String, source: &AtlasSource) {
    let _ = write!(
        out,
        "<h2>{}</h2>\n<p>{}</p>\n<table class=\"index\">\n<tr><th>figure</th><th>shows</th><th>here</th></tr>\n",
        escape(&source.title),
        escape(&source.citation)
    );
    for figure in &source.figures {
        let number = escape(&figure.number);
        let link = match figure.svg {
            Some(_) => format!("<a href=\"#{}\">{number}</a>", figure.id),
            None => number,
        };
        let mut here = escape(figure.verdict.name());
        if figure.svg.is_none() {
            if let Some(remark) = &figure.remark {
                here += &format!(". {}", escape(remark));
            }
            if let Some(command) = &figure.command {
                here += &format!(": <code>{}</code>", escape(command));
            }
        }
        let _ = writeln!(out, "<tr><td>{link}</td><td>{}</td><td>{here}</td></tr>", escape(&figure.title));
    }
    out.push_str("</table>\n");
}

fn drawn(out: &mut String, figure: &AtlasFigure) {
    let title = format!("Figure {}: {}", figure.number, figure.title);
    let _ = writeln!(out, "<figure id=\"{}\">\n<h3>{}</h3>", figure.id, escape(&title));
    match &figure.svg {
        Some(Err(why)) => {
            let _ = writeln!(out, "<p>Cannot be drawn: {}</p>", escape(why));
        }
        _ => {
            let _ = writeln!(out, "<img src=\"{}\" alt=\"{}\">", figure.file(), escape(&title));
        }
    }
    out.push_str("<figcaption>\n");
    let mut line = |name: &str, text: &str| {
        let _ = writeln!(out, "<p>{name}{}</p>", escape(text));
    };
    if !figure.engines.is_empty() {
        line("Engine: ", &figure.engines.join("; "));
    }
    if let Some(chosen) = &figure.chosen {
        line("Chosen: ", chosen);
    }
    if let Some(remark) = &figure.remark {
        line("", remark);
    }
    if !figure.printed.is_empty() {
        numbers(out, &figure.printed);
    }
    out.push_str("</figcaption>\n</figure>\n");
}

fn numbers(out: &mut String, numbers: &[AtlasNumber]) {
    out.push_str("<table>\n<tr><th>printed in</th><th>quantity</th><th>printed</th><th>ours</th><th>verdict</th></tr>\n");
    for AtlasNumber { table, row, .. } in numbers {
        let verdict = match &row.reason {
            Some(reason) => format!("{}: {reason}", row.verdict),
            None => row.verdict.to_string(),
        };
        let quantity = match &row.column {
            Some(column) => format!("{}, {column}", row.quantity),
            None => row.quantity.clone(),
        };
        let unit = |text: &str| format!("{text} {}", row.unit);
        let cells = [table, &quantity, &unit(&row.printed), &unit(&row.ours), &verdict];
        let cells: String = cells.iter().map(|cell| format!("<td>{}</td>", escape(cell.trim()))).collect();
        let _ = writeln!(out, "<tr>{cells}</tr>");
    }
    out.push_str("</table>\n");
}
