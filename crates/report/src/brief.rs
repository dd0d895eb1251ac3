//! The answer alone, in a few lines for a terminal: what the first sentence of a report would say.

use crate::bearings::bearing_parts_table;
use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::table::{Cell, Table};
use crate::layouts::{layout_front_table, layout_search_text};
use crate::loads::peaks_table;
use crate::mounts::{mount_modes_table, mount_speeds_table};
use crate::optimum::{found_weights_table, headline, moved_words};
use crate::parts::front_designs_table;
use crate::simulated::{
    CrossCheck, CrossVerdict, SimulationResult, periodic_words, simulation_tables, simulation_words,
};
use crate::strength::CrankRule;
use crate::stress::{CrankCycle, CrankFatigue, CrankModes, ReducedCrank, StaticStress};
use crate::study::{equal_words, ranking_words, scatter_table, sensitivity_tables};
use crate::torque::{flywheel_table, torque_extremes_table, torque_table};
use crate::torsion::TorsionResult;
use lanchester_balance::{Answer, Durable};
use lanchester_geometry::Front;
use lanchester_mechanism::{BearingLoads, Brake, FlywheelNeed, Loads, MountStudy, Torque};
use lanchester_model::Engine;
use lanchester_study::compare::Comparison;
use lanchester_study::explore::ExploreAnswer;
use lanchester_study::scatter::ScatterStudy;
use lanchester_study::sensitivity::Sensitivity;

/// Engine and speed [rad/s].
fn head(engine: &str, speed: f64) -> String {
    format!("{engine} at {} rpm", number::terminal(number::rpm(speed), 0))
}

/// A cell as a terminal shows it, with the unit of its column; nothing where it is empty.
fn quantity(table: &Table, row: usize, column: usize) -> String {
    let unit = table.columns[column].unit;
    match &table.rows[row][column] {
        Cell::Number { value, decimals } => {
            format!("{} {unit}", number::terminal(*value, *decimals)).trim_end().to_owned()
        }
        Cell::Text(text) => text.clone(),
        Cell::Formula { text, .. } => text.clone(),
        Cell::Empty => String::new(),
    }
}

/// With a small letter at its beginning.
fn uncapital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

/// Lines of names and quantities, the quantities one below the other.
fn aligned(lines: &[(String, String)]) -> String {
    let width = lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    lines.iter().map(|(name, quantity)| format!("  {name:<width$}  {quantity}\n")).collect()
}

/// What shakes the engine: the diagnosis and the peaks.
pub fn loads_brief(loads: &Loads) -> String {
    let mut out = head(&loads.engine, loads.speed) + "\n";
    push_wrapped(&mut out, "", &loads.diagnosis.summary);
    push_wrapped(&mut out, "", &loads.diagnosis.roll);
    let table = peaks_table(loads);
    let wanted = ["Resultant force", "Resultant couple", "Roll moment"];
    let lines: Vec<(String, String)> = (0..table.rows.len())
        .filter(|&row| wanted.iter().any(|name| quantity(&table, row, 0).starts_with(name)))
        .map(|row| {
            let (name, unit) = match quantity(&table, row, 0) {
                named if named.ends_with(']') => named
                    .trim_end_matches(']')
                    .rsplit_once(" [")
                    .map_or((named.clone(), String::new()), |(n, u)| (n.to_owned(), u.to_owned())),
                named => (named, String::new()),
            };
            (format!("largest {}", uncapital(&name)), format!("{} {unit}", quantity(&table, row, 1)))
        })
        .collect();
    out + &aligned(&lines)
}

/// Torque and power, the energy that a flywheel must hold, the flywheel.
///
/// `driven`: largest excess energy with torques over the angle that the file gives besides [J].
pub fn torque_brief(
    torque: &Torque,
    brake: Option<&Brake>,
    flywheel: Option<&FlywheelNeed>,
    driven: Option<f64>,
) -> String {
    let table = torque_table(torque, brake);
    let wanted = ["indicated torque", "indicated power", "brake torque", "brake power"];
    let mut lines: Vec<(String, String)> = (0..table.rows.len())
        .filter(|&row| wanted.iter().any(|name| quantity(&table, row, 0).starts_with(name)))
        .map(|row| {
            (quantity(&table, row, 0), format!("{} {}", quantity(&table, row, 1), quantity(&table, row, 2)))
        })
        .collect();
    let extremes = torque_extremes_table(torque);
    if let (Some(row), Some(column)) = (
        extremes.rows.len().checked_sub(1),
        extremes.columns.iter().position(|c| c.header == "energy fluctuation"),
    ) {
        lines.push((
            format!("torque, {}", quantity(&extremes, row, 0)),
            format!("{} to {}", quantity(&extremes, row, 3), quantity(&extremes, row, 1)),
        ));
        let excess = quantity(&extremes, row, column);
        if let Some(driven) = driven {
            lines.push((
                "energy fluctuation, with the given torque".to_owned(),
                format!("{} J", number::terminal(driven, 1)),
            ));
        } else if !excess.is_empty() {
            lines.push(("energy fluctuation".to_owned(), excess));
        }
    }
    if let Some(need) = flywheel {
        let table = flywheel_table(need);
        let last = table.rows.len() - 1;
        lines.push((
            quantity(&table, last, 0),
            format!("{} {}", quantity(&table, last, 1), quantity(&table, last, 2)),
        ));
    }
    head(&torque.engine, torque.speed) + "\n" + &aligned(&lines)
}

/// The largest load of each kind of bearing.
pub fn bearings_brief(loads: &BearingLoads) -> String {
    let table = bearing_parts_table(std::slice::from_ref(loads));
    let lines: Vec<(String, String)> =
        (0..table.rows.len()).map(|row| (quantity(&table, row, 0), quantity(&table, row, 1))).collect();
    format!("{}: largest loads of {}\n", head(&loads.engine, loads.speed), loads.part.name())
        + &aligned(&lines)
}

/// The largest force at a mount, with its speed, and the natural frequencies.
pub fn mounts_brief(study: &MountStudy) -> String {
    let speeds = mount_speeds_table(study);
    let largest = (0..speeds.rows.len())
        .flat_map(|row| (1..speeds.columns.len()).map(move |column| (row, column)))
        .filter_map(|(row, column)| match speeds.rows[row][column] {
            Cell::Number { value, .. } if value.is_finite() => Some((value, row, column)),
            _ => None,
        })
        .max_by(|a, b| a.0.total_cmp(&b.0));
    let mut lines = Vec::new();
    if let Some((_, row, column)) = largest {
        let at = format!("{}, at {}", speeds.columns[column].header, quantity(&speeds, row, 0));
        lines.push((
            "largest force at a mount".to_owned(),
            format!("{} ({at})", quantity(&speeds, row, column)),
        ));
    }
    let modes = mount_modes_table(study);
    let frequencies: Vec<String> = (0..modes.rows.len()).map(|row| quantity(&modes, row, 1)).collect();
    lines.push(("rigid-body modes".to_owned(), frequencies.join(", ")));
    format!("{} on its mounts, shaken by {}\n", study.engine, study.excitation) + &aligned(&lines)
}

/// Each output with the inputs that change it most.
pub fn sensitivity_brief(found: &Sensitivity) -> String {
    let lines: Vec<(String, String)> = (sensitivity_tables(found).iter())
        .map(|table| {
            let last = table.columns.len().saturating_sub(1);
            let most = (0..table.rows.len().min(3))
                .map(|row| format!("{} {}", quantity(table, row, 0), quantity(table, row, last)));
            (table.title.clone(), most.collect::<Vec<_>>().join(", "))
        })
        .collect();
    found.engine.clone() + "\n" + &aligned(&lines)
}

/// Each load of the production: the nominal engine, and what 99.73 % of the engines do not exceed.
pub fn scatter_brief(study: &ScatterStudy) -> String {
    let table = scatter_table(study);
    let place = |header: &str| table.columns.iter().position(|column| column.header == header);
    let lines: Vec<(String, String)> = (0..table.rows.len())
        .map(|row| {
            let cell =
                |header: &str| place(header).map_or_else(String::new, |column| quantity(&table, row, column));
            let unit = cell("unit");
            let words =
                format!("nominal {} {unit}, 99.73 % up to {} {unit}", cell("nominal"), cell("99.73 %"));
            (quantity(&table, row, 0), words)
        })
        .collect();
    study.engine.clone() + "\n" + &aligned(&lines)
}

/// Each condition with how many numbers agree.
pub fn crosscheck_brief(check: &CrossCheck) -> String {
    let lines: Vec<(String, String)> = (check.conditions.iter())
        .map(|own| {
            let count = |verdict: CrossVerdict| own.rows.iter().filter(|row| row.verdict == verdict).count();
            let of = |verdict: CrossVerdict, words: &str| match count(verdict) {
                0 => None,
                count => Some(format!("{count} {words}")),
            };
            let words = match &own.not_applicable {
                Some(reason) => format!("not applicable, {reason}"),
                None => {
                    let all = [
                        of(CrossVerdict::Agrees, "agree"),
                        of(CrossVerdict::DiffersAsItMust, "differ as they must"),
                        of(CrossVerdict::Disagrees, "disagree"),
                    ];
                    all.into_iter().flatten().collect::<Vec<_>>().join(", ")
                }
            };
            (format!("{}: {}", own.condition.letter(), own.condition.name()), words)
        })
        .collect();
    head(&check.engine, check.speed) + "\n" + &aligned(&lines)
}

/// How many layouts are Pareto-optimal, and the least of each objective among them.
pub fn layout_search_brief(answer: &ExploreAnswer) -> String {
    let table = layout_front_table(answer);
    if table.rows.is_empty() {
        return layout_search_text(answer, 0, false);
    }
    let is_layout = |header: &str| header == "throws" || header == "firing order";
    let first = table.columns.iter().rposition(|column| is_layout(&column.header)).map_or(0, |last| last + 1);
    let lines: Vec<(String, String)> = (first..first + answer.objectives.len())
        .map(|column| {
            let value = |row: usize| match table.rows[row][column] {
                Cell::Number { value, .. } => value,
                _ => f64::INFINITY,
            };
            let best = (0..table.rows.len()).min_by(|a, b| value(*a).total_cmp(&value(*b))).unwrap_or(0);
            let words = format!("{} (no. {})", quantity(&table, best, column), quantity(&table, best, 0));
            (format!("least {}", table.columns[column].header), words)
        })
        .collect();
    format!("{}\n{}\n{}", head(&answer.engine, answer.speed), table.title, aligned(&lines))
}

/// How many designs a front has, and both of its ends.
pub fn front_brief(front: &Front) -> String {
    let table = front_designs_table(front);
    let end = |row: usize| format!("{}, {}", quantity(&table, row, 1), quantity(&table, row, 2));
    let lines: Vec<(String, String)> = match table.rows.len() {
        0 => Vec::new(),
        count => [0, count - 1].map(|row| (format!("no. {}", quantity(&table, row, 0)), end(row))).into(),
    };
    format!("{}\n{}", table.title, aligned(&lines))
}

/// Who is best in what.
pub fn comparison_brief(comparison: &Comparison) -> String {
    let mut out = equal_words(comparison) + "\n";
    for ranking in ranking_words(comparison) {
        // Why an engine has what it has is left to the whole text.
        let places = ranking.lines.iter().map(|line| match (line.split_once(": "), line.rsplit_once(" (")) {
            (Some((value, _)), Some((_, engines))) => format!("{value} ({engines}"),
            _ => line.clone(),
        });
        out += &format!("  {}: {}\n", ranking.title, places.collect::<Vec<_>>().join("; "));
    }
    out
}

/// What was found, and the weights; those of `durable` where it moved them.
pub fn balance_brief(engine: &Engine, answer: &Answer, durable: Option<&Durable>) -> String {
    let mut out = head(&answer.engine, answer.speed) + "\n";
    push_wrapped(&mut out, "", &headline(engine, answer));
    let moved = durable.filter(|found| found.is_moved()).map(|found| found.answer(answer));
    durable
        .map(moved_words)
        .filter(|words| !words.is_empty())
        .into_iter()
        .for_each(|words| push_wrapped(&mut out, "", words));
    let table = found_weights_table(moved.as_ref().unwrap_or(answer));
    let column = |name: &str| table.columns.iter().position(|column| column.header == name);
    if let (Some(unbalance), Some(direction)) = (column("unbalance"), column("direction")) {
        let line = |row: usize| match quantity(&table, row, direction) {
            none if none.is_empty() => (quantity(&table, row, 0), quantity(&table, row, unbalance)),
            at => (quantity(&table, row, 0), format!("{} at {at}", quantity(&table, row, unbalance))),
        };
        out += &aligned(&(0..table.rows.len()).map(line).collect::<Vec<_>>());
    }
    out
}

/// How the run ended, its speed, its largest forces at mounts.
pub fn simulation_brief(result: &SimulationResult) -> String {
    let mut out = format!("{}, simulated as rigid bodies\n", result.engine);
    // How it ended; of a periodic motion also whether there is one.
    let ended = simulation_words(result).into_iter().take(1);
    for words in ended.chain(result.periodic.as_ref().map(periodic_words)) {
        push_wrapped(&mut out, "", &words);
    }
    let mut lines = Vec::new();
    for table in simulation_tables(result) {
        match table.id {
            "simulated-speed" => {
                let columns: Vec<usize> = (0..table.columns.len()).collect();
                let words = columns
                    .iter()
                    .map(|&k| format!("{} {}", table.columns[k].header, quantity(&table, 0, k)));
                lines.push((table.title.to_lowercase(), words.collect::<Vec<_>>().join(", ")));
            }
            "simulated-mounts" => {
                lines.extend((0..table.rows.len()).map(|row| {
                    // That of the whole run, where it is more than its last period.
                    let column = 2.min(table.columns.len() - 1);
                    (format!("largest force, {}", quantity(&table, row, 0)), quantity(&table, row, column))
                }));
            }
            _ => {}
        }
    }
    out + &aligned(&lines)
}

/// A title and its leading sentence.
fn leading(title: String, lead: &str) -> String {
    let mut out = title + "\n";
    push_wrapped(&mut out, "", lead);
    out
}

/// Natural frequency, largest twist and stress.
pub fn torsion_brief(result: &TorsionResult) -> String {
    let words: Vec<String> = [result.lead()].into_iter().chain(result.tuned_words()).collect();
    leading(format!("{}, torsional vibration", result.engine), &words.join(" "))
}

/// Largest stress of a static case.
pub fn static_stress_brief(stress: &StaticStress) -> String {
    leading(
        format!("{}, static stress of crankshaft {}", stress.sheet.engine, stress.sheet.crankshaft),
        &stress.lead(),
    )
}

/// Natural frequencies of a crankshaft.
pub fn modes_brief(found: &CrankModes) -> String {
    let table = found.table();
    let place = table.columns.iter().position(|column| column.unit == "Hz").unwrap_or(0);
    let frequencies: Vec<String> = (0..table.rows.len()).map(|row| quantity(&table, row, place)).collect();
    leading(
        format!("{}, natural modes of crankshaft {}", found.sheet.engine, found.sheet.crankshaft),
        &format!("Natural frequencies: {}.", frequencies.join(", ")),
    )
}

/// Size of a reduced model.
pub fn reduced_brief(found: &ReducedCrank) -> String {
    let lead = found.words().into_iter().next().unwrap_or_default();
    leading(format!("{}, reduced model of crankshaft {}", found.sheet.engine, found.sheet.crankshaft), &lead)
}

/// Least safety against fatigue.
pub fn fatigue_brief(found: &CrankFatigue) -> String {
    leading(
        format!("{}, fatigue of crankshaft {}", found.sheet.engine, found.sheet.crankshaft),
        &found.lead(),
    )
}

/// What the crankshaft does in its bearings.
pub fn cycle_brief(found: &CrankCycle) -> String {
    leading(
        format!("{}, crankshaft {} in its bearings", found.sheet.engine, found.sheet.crankshaft),
        &found.lead(),
    )
}

/// Least safety by the formulas.
pub fn rule_brief(rule: &CrankRule) -> String {
    leading(format!("{}, strength of crankshaft {}", rule.engine, rule.crankshaft), &rule.lead())
}

/// What a text says before its first table: the answer of those searches that say it first.
pub fn words_before_tables(text: &str) -> String {
    let is_dashes = |line: &str| line.starts_with("  -") && line.bytes().all(|b| matches!(b, b'-' | b' '));
    let paragraphs = text.split("\n\n").take_while(|paragraph| !paragraph.lines().any(is_dashes));
    let words: Vec<&str> =
        paragraphs.map(|paragraph| paragraph.trim_matches('\n')).filter(|words| !words.is_empty()).collect();
    words.join("\n") + "\n"
}
