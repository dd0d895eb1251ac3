//! Every figure of the sources is listed, those to be drawn are drawn, and curves have the peaks of their tables.

use super::*;
use crate::files::sources;
use lanchester::report::PublishedCurve;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// All figures, drawn once for all tests.
fn whole() -> &'static Atlas {
    static WHOLE: OnceLock<Atlas> = OnceLock::new();
    WHOLE.get_or_init(|| atlas(None))
}

/// How many figures each source has, by its own count.
const COUNTS: [(&str, usize); 4] = [
    ("twin-cylinder-thesis", 99),
    ("three-four-cylinder-thesis", 72),
    ("flexible-paper", 14),
    ("balancing-tool-paper", 16),
];

#[test]
fn every_figure_of_the_four_sources_is_listed_once_with_what_its_verdict_needs() {
    let lists: Vec<(String, FigureList)> =
        sources().iter().filter_map(|source| Some((source.key.clone(), FigureList::of(source)?))).collect();
    let counts: Vec<(&str, usize)> =
        lists.iter().map(|(key, list)| (key.as_str(), list.figures.len())).collect();
    assert_eq!(counts, COUNTS);
    for (key, list) in &lists {
        let mut numbers: Vec<Vec<u32>> = Vec::new();
        for entry in &list.figures {
            numbers.push(entry.figure.split('.').map(|part| part.parse().unwrap()).collect());
            let place = format!("{key} {}", entry.figure);
            let is_drawn = entry.verdict == FigureVerdict::Drawn;
            assert_eq!(is_drawn, !entry.draw.is_empty(), "{place}");
            assert!(is_drawn || entry.printed.is_empty(), "{place}: numbers stand below drawn figures");
            assert_eq!(entry.command.is_some(), entry.verdict == FigureVerdict::OtherCommand, "{place}");
            assert!(
                entry.from.as_ref().is_none_or(|from| lists.iter().any(|(key, _)| key == from)),
                "{place}"
            );
        }
        assert!(numbers.is_sorted() && numbers.windows(2).all(|pair| pair[0] != pair[1]), "{key}");
    }
}

#[test]
fn every_figure_to_be_drawn_is_drawn_and_shows_something() {
    for figure in whole().figures().filter(|figure| figure.verdict == FigureVerdict::Drawn) {
        let svg = figure.svg.as_ref().unwrap().as_ref().unwrap_or_else(|why| panic!("{}: {why}", figure.id));
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{}", figure.id);
        let marks =
            ["<path", "<rect class=\"bar", "<line class=\"shaft"].map(|mark| svg.matches(mark).count());
        assert!(marks.iter().sum::<usize>() > 0, "{} is empty", figure.id);
        assert!(!svg.contains("NaN"), "{}", figure.id);
        let curves = || figure.curves.iter().flat_map(|own| &own.curves);
        let is_finite = |curve: &PublishedCurve| {
            curve.points.iter().all(|(at, value)| at.is_finite() && value.is_finite())
        };
        assert!(curves().all(|curve| curve.points.len() > 1 && is_finite(curve)), "{}", figure.id);
        assert!(!figure.engines.is_empty(), "{}", figure.id);
    }
    assert!(whole().passed());
}

/// Whether the peak of a curve is the number of its table.
fn is_peak(number: &AtlasNumber, factor: f64) -> bool {
    let (Some(drawn), Some(value)) = (number.drawn, number.row.value) else { return false };
    // Both come from the same run; a couple of 0.001 N m is nothing beside those of 100 N m.
    (factor * drawn - value).abs() <= 1e-9 * value.abs() + 1e-6
}

#[test]
fn peaks_of_curves_are_the_numbers_of_their_tables() {
    let numbers = || whole().figures().flat_map(|own| &own.printed).filter(|own| own.drawn.is_some());
    assert!(numbers().count() >= 45, "{}", numbers().count());
    for number in numbers() {
        let row = &number.row;
        assert!(
            is_peak(number, 1.0),
            "{} {}: {:?} {:?}",
            number.table,
            row.quantity,
            number.drawn,
            row.value
        );
        assert!(!is_peak(number, 1.001) || row.value == Some(0.0) || row.value.unwrap().abs() < 1e-3);
    }
}

#[test]
fn bars_are_the_rows_of_their_tables() {
    let found = atlas(Some("twin-cylinder-thesis Figure 99"));
    let figure = found.figures().next().unwrap();
    let numbers: Vec<f64> = figure.bars.iter().map(|own| own.cases.len() as f64).collect();
    assert_eq!(numbers, [9.0, 9.0]);
    let table = crate::validate(Some("twin-cylinder-thesis Table 26"));
    let of = |quantity: &str| -> Vec<f64> {
        let rows = table.sources[0].tables[0].rows.iter().filter(|row| row.quantity == quantity);
        rows.map(|row| row.value.unwrap()).collect()
    };
    for (bars, quantity) in figure.bars.iter().zip(["Fres,max", "Mres,max"]) {
        for ((case, value), row) in bars.cases.iter().zip(of(quantity)) {
            // Rounding is drawn as nothing.
            assert!((value - row).abs() < 1e-9, "{quantity} {case}: {value} {row}");
        }
    }
    let level = figure.bars[0].level.as_ref().unwrap().1;
    assert!((level - 5793.89).abs() < 0.005, "{level}");
}

#[test]
fn a_figure_that_cannot_be_drawn_says_why_and_fails_the_atlas() {
    let source = sources().remove(0);
    let text = r#"{"figure": "1", "title": "t", "verdict": "drawn",
        "draw": [{"panel": "sweep", "engine": ["no such engine"]}]}"#;
    let entry: FigureEntry = serde_json::from_str(text).unwrap();
    let figure = figure(&mut Bench::default(), &source, ("Source", "source-figure-1".to_string()), &entry);
    assert!(figure.svg.as_ref().unwrap().as_ref().unwrap_err().contains("no such engine"));
    let AtlasSource { key, title, citation, .. } = whole().sources[0].clone();
    let atlas = Atlas { sources: vec![AtlasSource { key, title, citation, figures: vec![figure] }] };
    assert!(!atlas.passed());
    assert!(atlas_page(&atlas).contains("Cannot be drawn"));
}

#[test]
fn filters_keep_whole_figure_numbers() {
    let numbers = |filter| -> Vec<String> {
        atlas(Some(filter)).figures().map(|figure| figure.number.clone()).collect()
    };
    assert_eq!(numbers("twin-cylinder-thesis figure 2"), ["2"]);
    assert!(numbers("figure 1000").is_empty());
}

#[test]
fn the_page_names_every_figure_and_links_what_is_drawn() {
    let page = atlas_page(whole());
    for figure in whole().figures() {
        assert!(page.contains(&lanchester::report::escape(&figure.title)), "{}", figure.id);
        let shown = page.contains(&format!("<img src=\"{}\"", figure.file()));
        assert_eq!(shown, figure.verdict == FigureVerdict::Drawn, "{}", figure.id);
    }
}

#[test]
fn values_stand_in_lines() {
    let found = atlas(Some("twin-cylinder-thesis Figure 18"));
    let csv = found.figures().next().unwrap().csv().unwrap();
    assert_eq!(csv.lines().count(), 1 + 6 * 360);
    assert!(csv.contains("\"Force F_x\",\"N\",\"total F_x\",0,9535."), "{}", &csv[..200]);
}

#[test]
fn the_page_of_the_book_and_its_pictures_are_fresh() {
    let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src");
    let stale = "write it with `cargo xtask generate`";
    let page = std::fs::read_to_string(book.join("atlas.md")).unwrap();
    assert!(page == atlas_markdown(whole()), "docs/src/atlas.md is stale: {stale}");
    let mut kept: Vec<PathBuf> =
        std::fs::read_dir(book.join("images/atlas")).unwrap().map(|entry| entry.unwrap().path()).collect();
    kept.sort();
    let drawn = || whole().figures().filter_map(|own| Some((own, own.svg.as_ref()?.as_ref().ok()?)));
    let mut names: Vec<PathBuf> =
        drawn().map(|(own, _)| book.join("images/atlas").join(own.file())).collect();
    names.sort();
    assert_eq!(kept, names);
    for (figure, svg) in drawn() {
        let text = std::fs::read_to_string(book.join("images/atlas").join(figure.file())).unwrap();
        assert!(text == *svg, "{} is stale: {stale}", figure.file());
    }
}
