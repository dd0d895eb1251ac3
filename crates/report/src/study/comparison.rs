//! Engines side by side: tables, bars against the reference, and their order in words.

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number::{self, Scale};
use crate::kit::svg::{Anchor, Svg, text_width, wrap};
use crate::kit::table::{Cell, Column, Table, numbers, own_cells, words};
use lanchester_study::compare::{Compared, Comparison, Criterion, Equal, Held, Leading, Place, Ranking};
use lanchester_task::Measured;

/// What an engine is called beside the others: its name, what it got, or both.
fn label(comparison: &Comparison, index: usize) -> String {
    let Compared { engine, with, .. } = &comparison.engines[index];
    let is_one_engine = comparison.engines.iter().all(|other| other.engine == *engine);
    match with {
        None => engine.clone(),
        Some(with) if is_one_engine => with.clone(),
        Some(with) => format!("{engine}, {with}"),
    }
}

/// Numbers and names of the engines.
fn numbered(comparison: &Comparison) -> Vec<(Column, Vec<Cell>)> {
    let all = 0..comparison.engines.len();
    let number = |k: usize| Cell::Number { value: (k + 1) as f64, decimals: 0 };
    vec![
        (Column::numbers("no.", ""), all.clone().map(number).collect()),
        words("engine", all.map(|k| label(comparison, k))),
    ]
}

/// The engines, their sizes and what they do, to the block and inside the crankshaft.
pub fn comparison_table(comparison: &Comparison) -> Table {
    let columns = outer_columns(comparison).into_iter().chain(crank_columns(comparison));
    Table::of_columns("comparison", "Side by side", "", columns.collect())
}

/// The engines, their sizes and what they do to the block and the flywheel.
fn outer_table(comparison: &Comparison) -> Table {
    let note = "Force, couple and roll moment: the largest of the moving masses over the crank angle. Mount \
                force: the largest at any mount. Uneven firing: the largest departure of \
                an interval from the even one. Uneven torque: excess energy over the work of its period.";
    Table::of_columns("comparison", "Side by side", note, outer_columns(comparison))
}

/// What force and couple do not see; `None` for crankshafts without throws.
fn crank_table(comparison: &Comparison) -> Option<Table> {
    let of_crank = crank_columns(comparison);
    if of_crank.is_empty() {
        return None;
    }
    let note = "Main load: the largest of inertia on any main bearing, throw by throw. Bending: of the crankshaft as a free beam \
                under what turns with it. Balance rate: share of the rotating unbalance between two main bearings that the \
                counterweights there answer. Films: the smallest of any main or big-end bearing over the cycle, at the lowest speed and at \
                that of the comparison, quasi-static; safety UR M53: the smallest of any fillet or oil bore by the formulas after the rule, \
                with the torsional vibration of the engine's chain where its file gives one.";
    let columns = numbered(comparison).into_iter().chain(of_crank).collect();
    Some(Table::of_columns("crank", "Inside the crankshaft", note, columns))
}

fn crank_columns(comparison: &Comparison) -> Vec<(Column, Vec<Cell>)> {
    let engines = &comparison.engines;
    let mut columns: Vec<(Column, Vec<Cell>)> = Vec::new();
    columns.extend(optional(engines, &|e| e.main_load, "main load", "N", 4));
    columns.extend(optional(engines, &|e| e.bending_moment, "bending", "N m", 4));
    let film = |measured: &Measured| measured.value().map(|film| 1e6 * film);
    columns.extend(optional(engines, &|e| film(&e.main_film), "main film", "um", 4));
    columns.extend(optional(engines, &|e| film(&e.crankpin_film), "crankpin film", "um", 4));
    columns.extend(optional(engines, &|e| e.rule_safety.value(), "safety UR M53", "", 4));
    let fillet = |engine: &Compared| engine.fillet_safety.as_ref().and_then(Measured::value);
    columns.extend(optional(engines, &fillet, "safety FE", "", 4));
    if engines.iter().any(|engine| engine.balance_rate.is_some()) {
        let rate = |engine: &Compared| engine.balance_rate.map_or_else(String::new, rate_words);
        columns.push(words("balance rate [%]", engines.iter().map(rate)));
    }
    columns
}

/// Why films and safeties of some engines are not known, and what would give them; what others leave out. Empty where all are known whole.
pub fn unmeasured_words(comparison: &Comparison) -> Vec<String> {
    let mut lines: Vec<Line> = Vec::new();
    for (index, engine) in comparison.engines.iter().enumerate() {
        let all = [
            ("main-bearing film", Some(&engine.main_film)),
            ("crankpin film", Some(&engine.crankpin_film)),
            ("safety after UR M53", Some(&engine.rule_safety)),
            ("fillet safety", engine.fillet_safety.as_ref()),
        ];
        for (name, measured) in all {
            let (is_known, words) = match measured {
                Some(Measured::Unknown(why)) => (false, format!("{}; {}", why.reason, why.remedy)),
                Some(Measured::Known { left_out, .. }) if !left_out.is_empty() => (true, left_out.clone()),
                _ => continue,
            };
            let place = lines.iter().position(|line| line.is_known == is_known && line.words == words);
            let place = place.unwrap_or_else(|| {
                lines.push(Line { is_known, words, names: Vec::new(), engines: Vec::new() });
                lines.len() - 1
            });
            let line = &mut lines[place];
            if !line.names.contains(&name) {
                line.names.push(name);
            }
            if !line.engines.contains(&(index + 1)) {
                line.engines.push(index + 1);
            }
        }
    }
    lines.iter().map(Line::text).collect()
}

/// What is to be said of some criteria of some engines.
struct Line {
    is_known: bool,
    words: String,
    names: Vec<&'static str>,
    engines: Vec<usize>,
}

impl Line {
    fn text(&self) -> String {
        let (names, engines) = (self.names.join(", "), number::list(&self.engines));
        match self.is_known {
            true => format!("The {names} of no. {engines} leaves out {}", self.words),
            false => format!("No {names} of no. {engines}: {}", self.words),
        }
    }
}

/// A column that not every engine has; `None` where none has it.
fn optional(
    engines: &[Compared],
    value: &dyn Fn(&Compared) -> Option<f64>,
    header: &str,
    unit: &'static str,
    digits: i32,
) -> Option<(Column, Vec<Cell>)> {
    let values: Vec<Option<f64>> = engines.iter().map(value).collect();
    if values.iter().all(Option::is_none) {
        return None;
    }
    let mut known = own_cells(values.iter().flatten().copied(), digits).into_iter();
    let cells = values.iter().map(|value| value.and_then(|_| known.next()).unwrap_or(Cell::Empty));
    Some((Column::numbers(header, unit), cells.collect()))
}

fn outer_columns(comparison: &Comparison) -> Vec<(Column, Vec<Cell>)> {
    let engines = &comparison.engines;
    let of = |value: fn(&Compared) -> f64| engines.iter().map(value).collect::<Vec<_>>().into_iter();
    let mut columns = numbered(comparison);
    if comparison.equal != Equal::AsTheyAre {
        columns.push(numbers("size", "%", of(|engine| 100.0 * engine.similar.length), 4));
    }
    columns.push(numbers("speed", "rpm", engines.iter().map(|engine| number::rpm(engine.speed)), 4));
    let optional = |value: &dyn Fn(&Compared) -> Option<f64>,
                    header: &str,
                    unit: &'static str,
                    digits: i32| { optional(engines, value, header, unit, digits) };
    columns.extend(optional(&|e| e.displacement.map(|v| v * 1e6), "displacement", "cm3", 4));
    columns.push(numbers("force", "N", of(|engine| engine.force), 4));
    columns.push(numbers("couple", "N m", of(|engine| engine.couple), 4));
    columns.push(numbers("roll moment", "N m", of(|engine| engine.roll_moment), 4));
    columns.extend(optional(&|e| e.mount_force, "mount force", "N", 4));
    columns.extend(optional(&|e| e.firing_unevenness.map(|v| 100.0 * v), "uneven firing", "%", 3));
    columns.extend(optional(&|e| e.torque.map(|t| t.power / 1e3), "power", "kW", 4));
    columns.extend(optional(&|e| e.torque.map(|t| 100.0 * t.excess_share), "uneven torque", "%", 3));
    columns.extend(optional(&|e| e.torque.and_then(|t| t.flywheel), "flywheel", "kg m2", 3));
    columns.push(numbers("counterweights", "kg mm", of(|engine| engine.counterweights * 1e3), 4));
    let shafts = engines.iter().map(|engine| Cell::Number { value: engine.shafts as f64, decimals: 0 });
    columns.push((Column::numbers("shafts", ""), shafts.collect()));
    columns.push(numbers("shaft weights", "kg mm", of(|engine| engine.shaft_weights * 1e3), 4));
    columns.extend(optional(&|e| e.added_mass.filter(|mass| *mass > 0.0), "added mass", "kg", 3));
    columns
}

/// "56.6", or "0 to 80" where bays differ.
fn rate_words([least, most]: [f64; 2]) -> String {
    let [low, high] = [least, most].map(|rate| number::trimmed(100.0 * rate, 3));
    if low == high { low } else { format!("{low} to {high}") }
}

/// The engines in percent of the reference, for the criteria of which it has something.
pub fn relative_table(comparison: &Comparison) -> Option<Table> {
    let reference = &comparison.engines[comparison.reference];
    let engines = &comparison.engines;
    let mut columns = numbered(comparison);
    for ranking in &comparison.rankings {
        let criterion = ranking.criterion;
        let Some(whole) = criterion.value(reference).filter(|whole| *whole > 0.0) else { continue };
        let whole = whole * share_of(comparison, criterion);
        if criterion == Criterion::Shafts {
            continue;
        }
        let shares = engines.iter().map(|e| 100.0 * criterion.value(e).unwrap_or(f64::NAN) / whole);
        let cells = shares.map(|share| Cell::Number { value: share, decimals: 1 }).collect();
        columns.push((Column::numbers(criterion.name(), "%"), cells));
    }
    let title = format!(
        "In percent of {}no. {}, {}",
        share_words(comparison),
        comparison.reference + 1,
        label(comparison, comparison.reference)
    );
    (columns.len() > 1).then(|| Table::of_columns("relative", title, "", columns))
}

/// Share of the reference that the others are compared with.
fn share_of(comparison: &Comparison, criterion: Criterion) -> f64 {
    if criterion.is_of_size() { comparison.share } else { 1.0 }
}

/// The share in words, before the reference.
fn share_words(comparison: &Comparison) -> String {
    match comparison.share {
        1.0 => String::new(),
        0.5 => "half of ".to_owned(),
        share => format!("{} of ", number::trimmed(share, 4)),
    }
}

/// What was made equal, in a sentence.
pub fn equal_words(comparison: &Comparison) -> String {
    let reference = label(comparison, comparison.reference);
    let what = match comparison.equal {
        Equal::AsTheyAre => return "The engines as they are.".to_owned(),
        Equal::Displacement => "displacement",
        Equal::Power => "power",
    };
    let held = match comparison.held {
        Held::Speed => "speed",
        Held::PistonSpeed => "mean piston speed",
    };
    format!(
        "Similar engines, made larger or smaller until they have the {what} of {reference}, each at its own {held}."
    )
}

/// The order of the engines by a criterion, in words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RankingWords {
    /// What they are compared by.
    pub title: String,
    /// One line a rank, best first: the numbers of the engines, what they have, and why.
    pub lines: Vec<String>,
}

/// The order of the engines by every criterion in which they differ, with the reason.
pub fn ranking_words(comparison: &Comparison) -> Vec<RankingWords> {
    let differ = |ranking: &&Ranking| ranking.places.iter().any(|place| place.rank > 1);
    let told = comparison.rankings.iter().filter(|ranking| ranking.criterion != Criterion::Shafts);
    told.filter(differ)
        .map(|ranking| RankingWords {
            title: number::capital(ranking.criterion.name()),
            lines: ranking
                .places
                .chunk_by(|a, b| a.rank == b.rank)
                .map(|level| level_words(comparison, ranking.criterion, level))
                .collect(),
        })
        .collect()
}

/// Engines of one rank.
fn level_words(comparison: &Comparison, criterion: Criterion, level: &[Place]) -> String {
    let first = &level[0];
    let value = match criterion {
        _ if first.value == 0.0 => "none".to_owned(),
        Criterion::FiringUnevenness | Criterion::TorqueUnevenness => {
            format!("{} %", terminal(100.0 * first.value, 3))
        }
        Criterion::AddedUnbalance => format!("{} kg mm", terminal(1e3 * first.value, 4)),
        Criterion::MainFilm | Criterion::CrankpinFilm => format!("{} um", terminal(1e6 * first.value, 4)),
        Criterion::RuleSafety | Criterion::FilletSafety => terminal(first.value, 4),
        _ => format!("{} {}", terminal(first.value, 4), criterion.unit()),
    };
    let reason = |place: &Place| {
        let engine = &comparison.engines[place.engine];
        let leading = match criterion {
            Criterion::Force => engine.force_leading.map(|leading| leading_words(&leading, engine.force)),
            Criterion::Couple => engine.couple_leading.map(|leading| leading_words(&leading, engine.couple)),
            _ => None,
        };
        leading.unwrap_or_default()
    };
    let mut engines: Vec<usize> = level.iter().map(|place| place.engine).collect();
    engines.sort_unstable();
    let who = match engines.as_slice() {
        [one] => format!("no. {}, {}", one + 1, label(comparison, *one)),
        several => format!("no. {}", number::list(&several.iter().map(|k| k + 1).collect::<Vec<_>>())),
    };
    let why = reason(first);
    let why = if why.is_empty() { why } else { format!(": {why}") };
    format!("{}. {value}{why} ({who})", first.rank)
}

/// "mostly order 1, against the crank".
fn leading_words(leading: &Leading, whole: f64) -> String {
    let how_much = if leading.size > 0.9 * whole { "mostly" } else { "above all" };
    let sense = match leading.forward {
        share if share > 0.95 => "with the crank",
        share if share < 0.05 => "against the crank",
        share if (share - 0.5).abs() < 0.05 => "the same with and against the crank",
        share if share > 0.5 => "more with the crank",
        _ => "more against the crank",
    };
    format!("{how_much} order {}, {sense}", number::order(leading.order))
}

fn terminal(value: f64, digits: i32) -> String {
    number::terminal(value, number::decimals(value, digits))
}

/// The comparison for a terminal.
pub fn comparison_text(comparison: &Comparison) -> String {
    let mut out = equal_words(comparison) + "\n\n";
    out += &outer_table(comparison).text();
    for table in crank_table(comparison).into_iter().chain(relative_table(comparison)) {
        out.push('\n');
        out += &table.text();
    }
    let unmeasured = unmeasured_words(comparison);
    if !unmeasured.is_empty() {
        out += &format!("\n{}\n", unmeasured.join("\n"));
    }
    let ranking = ranking_words(comparison);
    if !ranking.is_empty() {
        out += "\nThe order, best first\n";
        for RankingWords { title, lines } in ranking {
            out += &format!("  {title}\n");
            for line in lines {
                out += &format!("    {line}\n");
            }
        }
    }
    out
}

/// Width of the names beside the bars, of the bars, and of the values behind them [px].
const NAMES: f64 = 190.0;
const BARS: f64 = 300.0;
const VALUES: f64 = 80.0;
const HEAD: f64 = 42.0;
const ROW: f64 = 34.0;

/// Bars of every criterion that the engines differ in, with a line at the reference.
pub fn comparison_figure(comparison: &Comparison) -> Figure {
    let panels = comparison
        .rankings
        .iter()
        .filter(|ranking| ranking.places.iter().any(|place| place.value > 0.0))
        .map(|ranking| bars(comparison, ranking.criterion))
        .collect();
    Figure {
        id: "comparison".to_owned(),
        title: "Engines side by side".to_owned(),
        caption: format!(
            "{} Shorter is better, but of films and safeties; the dashed line is {}{}.",
            equal_words(comparison),
            share_words(comparison),
            label(comparison, comparison.reference)
        ),
        panels,
        columns: 2,
    }
}

fn bars(comparison: &Comparison, criterion: Criterion) -> Panel {
    let values: Vec<f64> =
        comparison.engines.iter().map(|engine| criterion.value(engine).unwrap_or(0.0)).collect();
    let largest = values.iter().copied().fold(0.0f64, f64::max);
    let is_share = matches!(criterion, Criterion::FiringUnevenness | Criterion::TorqueUnevenness);
    let scale = match criterion {
        _ if is_share => Scale { divisor: 0.01, unit: "%".to_owned() },
        Criterion::AddedUnbalance => Scale { divisor: 1e-3, unit: "kg mm".to_owned() },
        Criterion::MainFilm | Criterion::CrankpinFilm => Scale { divisor: 1e-6, unit: "um".to_owned() },
        Criterion::Flywheel | Criterion::Shafts | Criterion::RuleSafety | Criterion::FilletSafety => {
            Scale { divisor: 1.0, unit: criterion.unit().to_owned() }
        }
        _ => Scale::of(largest, criterion.unit()),
    };
    let axis = Axis::of(0.0, largest / scale.divisor, 4);
    let bottom = HEAD + ROW * values.len() as f64;
    let mut svg = Svg::new(NAMES + BARS + VALUES, bottom + 26.0);
    let unit = if scale.unit.is_empty() { String::new() } else { format!(" [{}]", scale.unit) };
    svg.text("strong", (4.0, 15.0), Anchor::Start, &format!("{}{unit}", number::capital(criterion.name())));
    let at = |value: f64| axis.place(value / scale.divisor, NAMES, NAMES + BARS);
    for &tick in &axis.ticks {
        let x = axis.place(tick, NAMES, NAMES + BARS);
        svg.line(if tick == 0.0 { "zero" } else { "grid" }, (x, HEAD - 8.0), (x, bottom));
        svg.text("muted small", (x, bottom + 17.0), Anchor::Middle, &number::fixed(tick, axis.decimals));
    }
    let mut said = Vec::with_capacity(values.len());
    for (k, &value) in values.iter().enumerate() {
        let name = label(comparison, k);
        let middle = HEAD + ROW * (k as f64 + 0.5) - 4.0;
        let lines = shortened(&name);
        for (row, line) in lines.iter().enumerate() {
            let y = middle + 4.0 + 13.0 * (row as f64 - 0.5 * (lines.len() as f64 - 1.0));
            svg.name("small", (NAMES - 8.0, y), Anchor::End, line);
        }
        let class = if k == comparison.reference { "bar3" } else { "bar1" };
        svg.rect(class, NAMES, middle - 8.0, at(value) - NAMES, 16.0);
        let shown = number::short(value / scale.divisor, 3);
        svg.text("small halo", (at(value) + 5.0, middle + 4.0), Anchor::Start, &shown);
        said.push(format!("{name} {shown}"));
    }
    let reference = at(share_of(comparison, criterion) * values[comparison.reference]);
    svg.line("limit", (reference, HEAD - 8.0), (reference, bottom));
    Panel::new(svg, format!("{}{unit}: {}.", number::capital(criterion.name()), said.join("; ")))
}

/// A name in at most two lines beside the bars.
fn shortened(name: &str) -> Vec<String> {
    const SIZE: f64 = 11.5;
    let mut lines = wrap(name, SIZE, NAMES - 14.0);
    let is_cut = lines.len() > 2;
    lines.truncate(2);
    for (k, line) in lines.iter_mut().enumerate() {
        let is_long = text_width(line, SIZE) > NAMES - 14.0;
        while text_width(line, SIZE) > NAMES - 24.0 && (is_long || (is_cut && k == 1)) {
            line.pop();
        }
        if is_long || (is_cut && k == 1) {
            line.push('\u{2026}');
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_study::compare::{COMPARISON_VERSION, Similar};
    use lanchester_task::Unmeasured;
    use std::f64::consts::PI;

    fn unknown() -> Measured {
        Measured::Unknown(Unmeasured {
            reason: "the oil is not given".into(),
            remedy: "give viscosity".into(),
        })
    }

    fn engine(name: &str, force: f64, shafts: usize) -> Compared {
        Compared {
            engine: name.to_owned(),
            with: None,
            similar: Similar { length: 1.1, speed: 1.0 },
            speed: 200.0 * PI,
            displacement: None,
            force,
            force_leading: (force > 0.0).then_some(Leading { order: 2.0, size: force, forward: 0.5 }),
            couple: 0.0,
            couple_leading: None,
            roll_moment: 3.0,
            mount_force: None,
            main_load: None,
            main_film: unknown(),
            crankpin_film: unknown(),
            rule_safety: unknown(),
            fillet_safety: None,
            bending_moment: None,
            balance_rate: None,
            firing_unevenness: (shafts > 0).then_some(0.5),
            torque: None,
            counterweights: 0.01,
            shafts,
            shaft_weights: 0.001 * shafts as f64,
            added_mass: None,
        }
    }

    fn comparison() -> Comparison {
        let long =
            "an engine whose name is much too long to stand beside its bars, with all that it is balanced by";
        let engines = vec![
            engine("four", 5000.0, 0),
            engine(long, 0.0, 2),
            engine("Wwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwww", 2500.0, 1),
        ];
        Comparison {
            version: COMPARISON_VERSION,
            equal: Equal::Displacement,
            held: Held::Speed,
            reference: 0,
            share: 1.0,
            fluctuation: 0.02,
            rankings: Criterion::ALL.iter().filter_map(|c| Ranking::of(*c, &engines)).collect(),
            engines,
            warnings: Vec::new(),
        }
    }

    #[test]
    fn words_tell_the_order_and_the_reason() {
        let words = ranking_words(&comparison());
        assert_eq!(words[0].title, "Force");
        assert!(words[0].lines[0].starts_with("1. none (no. 2, an engine"), "{words:?}");
        assert_eq!(
            words[0].lines[2],
            "3. 5000 N: mostly order 2, the same with and against the crank (no. 1, four)"
        );
        // Nobody has a couple, all have one roll moment, and one does not say how it fires.
        assert_eq!(words.len(), 2, "{words:?}");
    }

    #[test]
    fn what_is_not_known_is_told_once_with_what_gives_it() {
        let mut comparison = comparison();
        comparison.engines[1].rule_safety = Measured::Known {
            value: 1.4,
            place: "pin 1 at web 1".into(),
            speed: 600.0,
            left_out: "torsional vibration: no flywheel".into(),
        };
        let lines = unmeasured_words(&comparison);
        assert_eq!(
            lines,
            [
                "No main-bearing film, crankpin film, safety after UR M53 of no. 1–3: the oil is not given; give viscosity",
                "The safety after UR M53 of no. 2 leaves out torsional vibration: no flywheel",
            ]
        );
        let text = comparison_text(&comparison);
        assert!(text.contains("safety UR M53") && !text.contains("main film"), "{text}");
    }

    #[test]
    fn percents_are_of_the_reference() {
        let table = relative_table(&comparison()).unwrap();
        assert!(table.text().contains("50.0"), "{}", table.text());
        assert!(!table.text().contains("couple"), "nothing is a share of nothing");
        // Of half the reference twice as much; how unevenly it fires has no half.
        let half = Comparison { share: 0.5, ..comparison() };
        let table = relative_table(&half).unwrap();
        assert!(table.title.starts_with("In percent of half of no. 1"), "{}", table.title);
        assert!(table.text().contains("100.0") && table.text().contains("200.0"), "{}", table.text());
    }

    #[test]
    fn bars_and_names_stay_in_their_room() {
        let figure = comparison_figure(&comparison());
        assert_eq!(figure.panels.len(), 4);
        let svg = figure.svg();
        assert!(!svg.contains("NaN") && svg.contains('\u{2026}'));
        for name in comparison().engines.iter().map(|engine| &engine.engine) {
            for line in shortened(name) {
                assert!(text_width(&line, 11.5) <= NAMES, "{line}");
            }
        }
    }
}
