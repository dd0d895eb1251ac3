//! A search over layouts in words and tables: the space, what became of its cases, the front, the engine of the file.

use crate::kit::number;
use crate::kit::rounding::{below, clean, largest_moment};
use crate::kit::table::{Cell, Column, Table, column_cells, own_cells, words};
use lanchester_study::explore::{
    Choice, ExploreAnswer, FoundLayout, GivenEngine, JudgedBy, Objective, Removes, Sense,
};
use lanchester_task::Measured;
use std::f64::consts::TAU;

/// Below this what `objective` says is rounding [its SI unit]: beside the largest of its kind of any layout that the search
/// tells of, and of the engine of the file.
fn noise(answer: &ExploreAnswer, objective: Objective) -> f64 {
    let unit = |objective| printed(objective).1;
    let largest = |wanted: &'static str| {
        let places: Vec<usize> = (0..answer.objectives.len())
            .filter(|&k| unit(answer.objectives[k].objective) == wanted)
            .collect();
        let layouts = answer.front.iter().chain(&answer.ranking);
        let judged = layouts.clone().map(|l| &l.values).chain(answer.sample.iter().map(|case| &case.values));
        let values = judged.flat_map(|values| places.iter().map(|&k| values[k]));
        let given = answer.given.iter().flat_map(|given| places.iter().filter_map(|&k| given.values[k]));
        let free =
            layouts.flat_map(|l| [1, 2].map(|order| free_loads(l, order))).map(
                |[force, couple]| match wanted {
                    "N" => force,
                    "N m" => couple,
                    _ => 0.0,
                },
            );
        values.chain(given).chain(free).filter(|v| v.is_finite()).fold(0.0, |most: f64, v| most.max(v.abs()))
    };
    below(match unit(objective) {
        "N m" => largest_moment(largest("N m"), largest("N")),
        // Angles beside the turn that they are part of, shares and counts beside one.
        "deg" => TAU,
        "" => 1.0,
        other => largest(other),
    })
}

/// An objective as a head of a column: its name in short, its unit in print, and what SI is multiplied by.
pub(crate) fn printed(objective: Objective) -> (String, &'static str, f64) {
    let degrees = 360.0 / TAU;
    match objective {
        Objective::Force { order } => (format!("force {order}"), "N", 1.0),
        Objective::Couple { order } => (format!("couple {order}"), "N m", 1.0),
        Objective::ForceSense { order, sense } => (format!("force {}", signed(order, sense)), "N", 1.0),
        Objective::CoupleSense { order, sense } => (format!("couple {}", signed(order, sense)), "N m", 1.0),
        Objective::RollMoment { order } => (format!("roll {order}"), "N m", 1.0),
        Objective::InertiaTorque { order } => (format!("torque {order}"), "N m", 1.0),
        Objective::BendingMoment => ("bending".to_owned(), "N m", 1.0),
        Objective::MainLoad => ("main load".to_owned(), "N", 1.0),
        Objective::FiringUnevenness => ("uneven firing".to_owned(), "deg", degrees),
        Objective::FiringHarmonic { half_orders } => {
            (format!("firing {}", 0.5 * f64::from(half_orders)), "", 1.0)
        }
        Objective::NeighbourFirings => ("neighbours".to_owned(), "", 1.0),
        Objective::Length => ("length".to_owned(), "mm", 1e3),
        Objective::Height => ("height".to_owned(), "mm", 1e3),
        Objective::CounterweightUnbalance => ("weights".to_owned(), "kg mm", 1e3),
        Objective::Shafts => ("shafts".to_owned(), "", 1.0),
    }
}

/// "+1", "-2": an order with the sense in which it turns.
fn signed(order: u32, sense: Sense) -> String {
    format!("{}{order}", if sense == Sense::Forward { "+" } else { "-" })
}

/// Degrees to a millionth, so that what was asked for in degrees is printed as it was.
fn degrees(angle: f64) -> f64 {
    (1e6 * angle.to_degrees()).round() / 1e6 + 0.0
}

fn list(numbers: impl Iterator<Item = f64>) -> String {
    numbers.map(|number| number.to_string()).collect::<Vec<_>>().join(" ")
}

/// A column of what layouts have.
fn sizes(
    header: &str,
    unit: &'static str,
    layouts: &[FoundLayout],
    size: impl Fn(&FoundLayout) -> Option<f64>,
) -> (Column, Vec<Cell>) {
    let cell = |layout| size(layout).map_or(Cell::Empty, |value| Cell::text(value.to_string()));
    (Column::numbers(header, unit), layouts.iter().map(cell).collect())
}

/// The front, best first by the first objective.
pub fn layout_front_table(answer: &ExploreAnswer) -> Table {
    let title = match answer.front.len() {
        1 => "The front: one layout that is no worse than any other in every objective".to_owned(),
        count => {
            format!("The front: {} Pareto-optimal layouts in all objectives", number::whole(count as u128))
        }
    };
    table("front", title, answer, &answer.front)
}

/// The first kinds of layout, the first objective counting most.
pub fn layout_ranking_table(answer: &ExploreAnswer) -> Table {
    table("ranking", "The ranking, the first objective counting most".to_owned(), answer, &answer.ranking)
}

fn table(id: &'static str, title: String, answer: &ExploreAnswer, layouts: &[FoundLayout]) -> Table {
    let number = |value: f64| Cell::Number { value, decimals: 0 };
    let mut columns: Vec<(Column, Vec<Cell>)> =
        vec![(Column::numbers("no.", ""), layouts.iter().map(|l| number(l.number as f64)).collect())];
    let pair = |layout: &FoundLayout| layout.layout.banks;
    let millimetres = |length: f64| (1e9 * length).round() / 1e6 + 0.0;
    // What was searched is told, even where all of the front have the same.
    for choice in answer.choices.iter().map(|count| count.choice) {
        columns.extend(match choice {
            Choice::BankAngle => {
                Some(sizes("bank", "deg", layouts, |l| pair(l).map(|pair| degrees(pair.bank_angle))))
            }
            Choice::SplitAngle => {
                Some(sizes("split", "deg", layouts, |l| pair(l).map(|pair| degrees(pair.split_angle))))
            }
            Choice::Stagger => {
                Some(sizes("stagger", "mm", layouts, |l| pair(l).map(|pair| millimetres(pair.stagger))))
            }
            Choice::Spacing => Some(sizes("spacing", "mm", layouts, |l| Some(millimetres(l.layout.spacing)))),
            Choice::RodRatio => {
                Some(sizes("r/l", "", layouts, |l| Some((1e6 * l.layout.rod_ratio).round() / 1e6)))
            }
            Choice::Counterweights => {
                Some(words("counterweights", layouts.iter().map(|l| l.layout.counterweights.name.clone())))
            }
            Choice::Shafts => {
                Some(words("balance shafts", layouts.iter().map(|l| l.layout.shafts.name.clone())))
            }
            Choice::ThrowAngles | Choice::Firing => None,
        });
    }
    columns.push((
        Column { unit: "deg", ..Column::words("throws") },
        layouts.iter().map(|l| Cell::Text(list(l.layout.throw_angles.iter().map(|a| degrees(*a))))).collect(),
    ));
    if layouts.iter().any(|layout| layout.firing_order.is_some()) {
        let order = |layout: &FoundLayout| {
            let order: Vec<String> =
                layout.firing_order.iter().flatten().map(|cylinder| cylinder.to_string()).collect();
            order.join("-")
        };
        columns.push(words("firing order", layouts.iter().map(order)));
    }
    for (place, judged) in answer.objectives.iter().enumerate() {
        let (header, unit, factor) = printed(judged.objective);
        let values = layouts.iter().map(|layout| layout.values[place] * factor);
        let noise = factor * noise(answer, judged.objective);
        columns.push((Column::numbers(header, unit), column_cells(values, 4, noise)));
    }
    let judged = |objective| answer.objectives.iter().any(|judged| judged.objective == objective);
    for order in [1, 2] {
        for objective in [Objective::Force { order }, Objective::Couple { order }] {
            if !judged(objective) {
                let (header, unit, _) = printed(objective);
                let values = layouts.iter().map(|layout| free_load(layout, objective));
                columns
                    .push((Column::numbers(header, unit), column_cells(values, 4, noise(answer, objective))));
            }
        }
    }
    if !judged(Objective::FiringUnevenness) && layouts.iter().any(|layout| layout.unevenness.is_some()) {
        let (header, unit, factor) = printed(Objective::FiringUnevenness);
        let values = layouts.iter().map(|layout| factor * layout.unevenness.unwrap_or(f64::NAN));
        let noise = factor * noise(answer, Objective::FiringUnevenness);
        columns.push((Column::numbers(header, unit), column_cells(values, 4, noise)));
    }
    for (place, criterion) in answer.durability.iter().enumerate() {
        let (factor, unit) = if criterion.is_film() { (1e6, "um") } else { (1.0, "") };
        let value = |layout: &FoundLayout| layout.durability.get(place).and_then(Measured::value);
        let mut known =
            own_cells(layouts.iter().filter_map(value).map(|value| factor * value), 4).into_iter();
        let cells =
            layouts.iter().map(|layout| value(layout).and_then(|_| known.next()).unwrap_or(Cell::Empty));
        columns.push((Column::numbers(criterion.title(), unit), cells.collect()));
    }
    let alike = layouts.iter().map(|layout| number(layout.alike as f64)).collect();
    columns.push((Column::numbers("equivalent", ""), alike));
    Table::of_columns(id, title, "", columns)
}

/// Free force [N] and couple [N m] of a layout in an order, in both senses together.
fn free_loads(layout: &FoundLayout, order: u32) -> [f64; 2] {
    [free_load(layout, Objective::Force { order }), free_load(layout, Objective::Couple { order })]
}

/// A free force or couple of a layout.
fn free_load(layout: &FoundLayout, objective: Objective) -> f64 {
    let size = |order: u32, of: &dyn Fn(Sense) -> f64| {
        if (1..=2).contains(&order) { of(Sense::Forward) + of(Sense::Backward) } else { f64::NAN }
    };
    match objective {
        Objective::Force { order } => size(order, &|sense| layout.orders.force_of(order, sense).norm()),
        Objective::Couple { order } => size(order, &|sense| layout.orders.couple_of(order, sense).norm()),
        _ => f64::NAN,
    }
}

/// The space, what became of its cases, and notes, for a terminal.
pub fn layout_search_words(answer: &ExploreAnswer) -> String {
    let rpm = number::terminal(answer.speed * 60.0 / TAU, 0);
    let mut out = format!(
        "Layouts of {} cylinders made of the parts of {}, at {rpm} rpm\n\n",
        answer.cylinders, answer.engine
    );
    let factors: Vec<String> = answer
        .choices
        .iter()
        .map(|choice| format!("{} from {}", number::whole(choice.values), choice.choice.name()))
        .collect();
    let product = match factors.len() {
        0 => String::new(),
        _ => format!(": {}", factors.join(", times ")),
    };
    out += &format!("The space has {}{product}.\n", cases(answer.size));
    let counts = &answer.counts;
    if counts.cases != answer.size {
        let share = 100.0 * counts.cases as f64 / answer.size as f64;
        out += &format!(
            "{} were looked at, {} % of them.\n",
            number::whole(counts.cases),
            number::terminal(share, number::decimals(share, 3))
        );
    }
    let mut lines: Vec<(u128, String)> = counts
        .invalid
        .iter()
        .map(|invalid| (invalid.cases, format!("have an invalid geometry: {}", invalid.reason.text())))
        .collect();
    lines.push((counts.duplicates, "are equivalent to another case by symmetry".to_owned()));
    lines.extend(counts.broken.iter().map(|broken| (broken.cases, format!("break: {}", broken.constraint))));
    lines.push((counts.judged, "were judged".to_owned()));
    let width = lines.iter().map(|(cases, _)| number::whole(*cases).len()).max().unwrap_or(0);
    for (cases, words) in lines {
        out += &format!("  {:>width$}  {words}\n", number::whole(cases));
    }
    for shafts in shaft_sets(answer) {
        out += &format!("{shafts}\n");
    }
    for note in &answer.notes {
        out += &format!("Note: {note}.\n");
    }
    for limit in &answer.at_least {
        out += &format!("Layouts of front and ranking hold: {limit}.\n");
    }
    if !answer.at_least.is_empty() && answer.front.is_empty() && answer.counts.judged > 0 {
        out += "No layout that was judged holds that: the front is empty.\n";
    }
    out + &unmeasured_words(answer)
}

/// Why films and safeties of the first layout that lacks one are not known, and what those that are known leave out.
fn unmeasured_words(answer: &ExploreAnswer) -> String {
    let mut out = String::new();
    for (place, criterion) in answer.durability.iter().enumerate() {
        let unknown = answer.front.iter().find_map(|found| match found.durability.get(place) {
            Some(Measured::Unknown(why)) => Some((found.number, why)),
            _ => None,
        });
        if let Some((number, why)) = unknown {
            out += &format!("No {} of layout {number}: {}; {}.\n", criterion.title(), why.reason, why.remedy);
        }
        let left_out = answer.front.iter().find_map(|found| match found.durability.get(place) {
            Some(Measured::Known { left_out, .. }) if !left_out.is_empty() => Some(left_out),
            _ => None,
        });
        if let Some(left_out) = left_out {
            out += &format!("The {} of layouts leaves out {left_out}.\n", criterion.title());
        }
    }
    out
}

fn cases(count: u128) -> String {
    format!("{} case{}", number::whole(count), if count == 1 { "" } else { "s" })
}

/// What the shafts of the sets on the front are.
fn shaft_sets(answer: &ExploreAnswer) -> Vec<String> {
    let mut told: Vec<&str> = Vec::new();
    let mut lines = Vec::new();
    for set in answer.front.iter().map(|found| &found.layout.shafts) {
        if set.shafts.is_empty() || told.contains(&set.name.as_str()) {
            continue;
        }
        told.push(&set.name);
        let mm = |length: f64| (1e9 * length).round() / 1e6 + 0.0;
        let shafts: Vec<String> = set
            .shafts
            .iter()
            .map(|shaft| {
                let (what, planes) = match shaft.removes {
                    Removes::Force { z } => ("force", vec![z]),
                    Removes::Couple { z } => ("couple", z.to_vec()),
                    Removes::Both { z } => ("force and couple", z.to_vec()),
                };
                format!(
                    "{} at x {} mm, y {} mm removes the {what} in z {} mm",
                    signed(shaft.order, shaft.sense),
                    mm(shaft.x),
                    mm(shaft.y),
                    list(planes.into_iter().map(mm))
                )
            })
            .collect();
        lines.push(format!("Shafts `{}`: {}.", set.name, shafts.join("; ")));
    }
    lines
}

/// Where the engine of the file stands, in sentences.
fn given_words(answer: &ExploreAnswer, given: &GivenEngine) -> String {
    let values: Vec<String> = answer
        .objectives
        .iter()
        .zip(&given.values)
        .map(|(JudgedBy { objective, .. }, value)| {
            let (name, unit, factor) = printed(*objective);
            let value = value.map_or("not known".to_owned(), |value| {
                let value = factor * clean(value, noise(answer, *objective));
                format!("{} {unit}", number::terminal(value, number::decimals(value.abs(), 4)))
            });
            format!("{name} {}", value.trim_end())
        })
        .collect();
    let mut out =
        format!("The engine of the file, with its own weights and shafts: {}.\n", values.join(", "));
    let front = if answer.counts.cases == answer.size { "" } else { " of what was looked at" };
    if !given.broken.is_empty() {
        out += &format!("  It breaks: {}.\n", given.broken.join("; "));
    }
    if given.values.iter().any(Option::is_none) {
        out += "  It cannot be set beside the front: not every objective is known of it.\n";
    } else if let Some(number) = given.equals {
        out += &format!("  It is as good as no. {number}{front}.\n");
    } else if given.beaten_by.is_empty() {
        out += &format!("  Nothing on the front{front} beats it.\n");
    } else {
        let few = if given.beaten_by.len() > 12 {
            format!("{} layouts, no. {} the first", given.beaten_by.len(), given.beaten_by[0])
        } else {
            format!("no. {}", number::list(&given.beaten_by).replace('\u{2013}', "-"))
        };
        out += &format!("  It is beaten in all objectives, or equalled in some, by {few}.\n");
    }
    match (&given.case, &given.outside) {
        (Some(case), _) => {
            out += &format!("  Its layout is case {} of the space.\n", number::whole(*case));
        }
        (None, Some(reason)) => out += &format!("  Its layout is not in the space: {reason}.\n"),
        (None, None) => {}
    }
    out
}

/// The search for a terminal, with so many rows of the front, or of the ranking.
pub fn layout_search_text(answer: &ExploreAnswer, rows: usize, ranking: bool) -> String {
    let mut out = layout_search_words(answer);
    let mut table = if ranking { layout_ranking_table(answer) } else { layout_front_table(answer) };
    if table.rows.is_empty() {
        let why = answer.counts.emptied_by().unwrap_or_else(|| "nothing was looked at".to_owned());
        return out + &format!("\nNothing was judged: {why}.\n");
    }
    if table.rows.len() > rows {
        table.remark = format!("... and {} more", number::whole((table.rows.len() - rows) as u128));
        table.rows.truncate(rows);
    }
    out.push('\n');
    out += &table.text();
    if let Some(given) = &answer.given {
        out.push('\n');
        out += &given_words(answer, given);
    }
    out
}
