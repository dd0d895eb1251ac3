//! Production scatter: loads, limits, and what to tighten first.

use crate::kit::number;
use crate::kit::rounding::{below, clean};
use crate::kit::table::{Cell, Column, Table, column_cells, numbers, words};
use crate::study::sensitivity_tables::measure_unit;
use lanchester_study::scatter::{OutputScatter, ScatterStudy, TOLD_SHARES};
use lanchester_study::sensitivity::Quantity;
use lanchester_task::{Distribution, Extent, Tolerance};

/// Gains below this are not worth a word.
const SMALL: f64 = 0.01;

/// Value of a share of the samples.
fn percentile(own: &OutputScatter, share: f64) -> f64 {
    own.percentiles.iter().find(|p| p.share == share).map_or(f64::NAN, |p| p.value)
}

/// Numbers of rows of two units, each with enough digits for itself.
fn mixed(
    header: impl Into<String>,
    values: impl IntoIterator<Item = f64>,
    digits: i32,
) -> (Column, Vec<Cell>) {
    (Column::numbers(header, ""), values.into_iter().map(|value| Cell::number(value, digits)).collect())
}

/// Distribution and worst case of each load.
pub fn scatter_table(study: &ScatterStudy) -> Table {
    let outputs = || study.scatter.outputs.iter();
    let mut columns = vec![
        words("load", outputs().map(|own| number::capital(&own.output.name()))),
        words("unit", outputs().map(|own| own.output.unit().to_owned())),
        mixed(
            "nominal",
            outputs().zip(&study.worst_cases).map(|(own, worst)| clean(own.nominal, below(worst.bound))),
            4,
        ),
        mixed("mean", outputs().map(|own| own.mean), 4),
        mixed("deviation", outputs().map(|own| own.deviation), 3),
    ];
    for share in TOLD_SHARES {
        let header = format!("{} %", number::trimmed(100.0 * share, 4));
        columns.push(mixed(header, outputs().map(|own| percentile(own, share)), 4));
    }
    columns.push(mixed("largest", outputs().map(|own| own.most), 4));
    columns.push(mixed("worst found", study.worst_cases.iter().map(|worst| worst.attained), 4));
    columns.push(mixed("upper bound (loose)", study.worst_cases.iter().map(|worst| worst.bound), 4));
    let note = format!(
        "{} engines at {} rpm, seed {}. Shares of them do not exceed the values of their column; the worst combination of deviations lies between the last two: the bound adds up what every part may be off, as if all pushed one way.",
        number::terminal(study.scatter.samples as f64, 0),
        number::terminal(number::rpm(study.speed), 0),
        study.scatter.seed
    );
    Table::of_columns("scatter", "Production scatter of the loads", note, columns)
}

/// The limits; `None` without any.
pub fn scatter_limit_table(study: &ScatterStudy) -> Option<Table> {
    if study.limits.is_empty() {
        return None;
    }
    let limits = || study.limits.iter();
    let samples = study.scatter.samples as f64;
    let columns = vec![
        words("load", limits().map(|limit| number::capital(&limit.output.name()))),
        words("unit", limits().map(|limit| limit.output.unit().to_owned())),
        mixed("limit", limits().map(|limit| limit.capability.limit), 4),
        mixed("Cpk", limits().map(|limit| limit.capability.cpk), 3),
        mixed("capability", limits().map(|limit| limit.capability.cpk_by_percentiles), 3),
        numbers("beyond", "%", limits().map(|limit| 100.0 * limit.capability.beyond as f64 / samples), 3),
        words("met", limits().map(|limit| if limit.is_met { "yes" } else { "no" }.to_owned())),
    ];
    let note = format!(
        "A limit is met with a capability of {} by percentiles; Cpk is right for normal distributions, which residuals of balanced engines are not.",
        number::trimmed(study.capability, 3)
    );
    Some(Table::of_columns("scatter-limits", "Limits", note, columns))
}

/// Name of a tolerance: what it is on.
pub fn tolerance_name(tolerance: &Tolerance) -> String {
    match tolerance.extent {
        Extent::PerPart => tolerance.quantity.name().to_owned(),
        Extent::Common => format!("{} of all", tolerance.quantity.name()),
    }
}

/// Its half width in a unit of its size.
fn half_width(tolerance: &Tolerance) -> String {
    let (factor, unit) = measure_unit(Quantity::Part(tolerance.quantity).measure());
    format!("{} {unit}", number::trimmed(factor * tolerance.half_width, 4))
}

/// Each tolerance, and what halving it would take off each load.
pub fn tolerance_table(study: &ScatterStudy) -> Table {
    let tolerances = || study.tolerances.iter();
    let mut columns = vec![
        words("tolerance", tolerances().map(tolerance_name)),
        words("plus or minus", tolerances().map(half_width)),
        words(
            "distribution",
            tolerances().map(|t| match t.distribution {
                Distribution::Uniform => "uniform".to_owned(),
                Distribution::Normal { sigmas } => format!("normal, {} sigma", number::trimmed(sigmas, 3)),
            }),
        ),
    ];
    for (place, own) in study.scatter.outputs.iter().enumerate() {
        let gains = study.tightened.iter().map(|tightened| 100.0 * tightened.gains[place]);
        columns.push((Column::numbers(own.output.name(), "%"), column_cells(gains, 3, 0.05)));
    }
    let note =
        "What halving one tolerance alone takes off the value that 99.73 % of the engines do not exceed.";
    Table::of_columns("tolerances", "What to tighten", note, columns)
}

/// What to tighten first, load by load.
pub fn tighten_words(study: &ScatterStudy) -> Vec<String> {
    let of = |(place, own): (usize, &OutputScatter)| {
        let mut ranked: Vec<_> = study.tightened.iter().filter(|t| t.gains[place] >= SMALL).collect();
        ranked.sort_by(|a, b| b.gains[place].total_cmp(&a.gains[place]));
        let named: Vec<String> = ranked
            .iter()
            .take(3)
            .map(|t| {
                let name = tolerance_name(&study.tolerances[t.tolerance]);
                format!("{name} (half of it: {} % less)", number::trimmed(100.0 * t.gains[place], 2))
            })
            .collect();
        let load = number::capital(&own.output.name());
        match named.len() {
            0 => format!("{load}: no single tolerance matters."),
            _ => format!("{load}: {}.", named.join(", then ")),
        }
    };
    study.scatter.outputs.iter().enumerate().map(of).collect()
}

/// The study for a terminal.
pub fn scatter_text(study: &ScatterStudy) -> String {
    let mut out = format!("{}\n\n{}", study.engine, scatter_table(study).noted_text());
    if let Some(limits) = scatter_limit_table(study) {
        out += &format!("\n{}", limits.noted_text());
    }
    out += &format!("\n{}\nTighten first\n", tolerance_table(study).noted_text());
    for line in tighten_words(study) {
        out += &format!("  {line}\n");
    }
    out
}
