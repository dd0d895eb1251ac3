//! Bobweight sheets, ready to be printed.

use super::mass::{grams, percent};
use crate::kit::number;
use crate::kit::rounding::{below, largest_moment};
use crate::kit::table::{Cell, Column, Table, column_cells, own_cells};
use lanchester_workshop::BobweightAnswer;

/// Weighed parts, bobweights, shares and the comparison with the optimum.
pub fn bobweight_tables(answer: &BobweightAnswer) -> Vec<Table> {
    let mut tables = vec![parts(answer), bobweights(answer)];
    tables.extend(choices(answer));
    tables.extend(comparison(answer));
    tables
}

/// A bobweight sheet for a terminal or a printer.
pub fn bobweight_text(answer: &BobweightAnswer) -> String {
    let share = |share: f64| format!("{} %", number::trimmed(100.0 * share, 3));
    let source = match (answer.share_given, answer.judged_by) {
        (true, _) => "given in the sheet",
        (false, Some(_)) => "derived: the smallest first order",
        (false, None) => "taken: half of what reciprocates turns with the crank",
    };
    let mut out = format!(
        "{}: bobweights\n\nbobweight = {} x (big ends + bearings + oil) + {} x (small ends + pistons + pins + rings + locks)\n\
         share of the reciprocating masses {source}\n",
        answer.name,
        share(answer.rotating_share),
        share(answer.reciprocating_share),
    );
    if let Some(engine) = &answer.engine {
        out += &format!("engine: {engine}\n");
    }
    for table in bobweight_tables(answer) {
        out += "\n";
        out += &table.text();
    }
    if let Some(comparison) = &answer.comparison {
        out += &format!(
            "  proved: no two weights there have a smaller peak force than {} N, and none with that force a smaller peak couple than {} N m\n",
            number::terminal(comparison.force_bound, number::decimals(comparison.force_bound, 5)),
            number::terminal(comparison.couple_bound, number::decimals(comparison.couple_bound, 5))
        );
    }
    out
}

/// Weighed parts; pins with the same parts stand together.
fn parts(answer: &BobweightAnswer) -> Table {
    let mut groups: Vec<(Vec<String>, usize)> = Vec::new();
    for (index, pin) in answer.pins.iter().enumerate() {
        let alike = |(_, first): &&mut (Vec<String>, usize)| answer.pins[*first].cylinders == pin.cylinders;
        match groups.iter_mut().find(alike) {
            Some((names, _)) => names.push(pin.name.clone()),
            None => groups.push((vec![pin.name.clone()], index)),
        }
    }
    let mut rows = Vec::new();
    for (names, index) in &groups {
        let cylinders = &answer.pins[*index].cylinders;
        let same = cylinders.iter().all(|parts| *parts == cylinders[0]);
        let shown = if same { &cylinders[..cylinders.len().min(1)] } else { &cylinders[..] };
        for (rod, parts) in shown.iter().enumerate() {
            let who = match same {
                true => format!("each of {}", cylinders.len()),
                false => (rod + 1).to_string(),
            };
            let mut row = vec![Cell::text(names.join(", ")), Cell::text(who)];
            row.extend(parts.list().map(|(_, mass)| grams(mass)));
            row.extend([grams(parts.rotating()), grams(parts.reciprocating())]);
            rows.push(row);
        }
    }
    let mut columns = vec![Column::words("pins"), Column::words("rod")];
    columns.extend(
        ["big end", "bearing", "small end", "piston", "pin", "rings", "locks", "rotating", "reciprocating"]
            .map(|head| Column::numbers(head, "g")),
    );
    Table {
        id: "bobweight-parts",
        title: "Weighed parts".to_owned(),
        note: String::new(),
        remark: String::new(),
        columns,
        rows,
    }
}

fn bobweights(answer: &BobweightAnswer) -> Table {
    let bobs = &answer.bobweights;
    let masses = |of: &dyn Fn(&lanchester_workshop::Bobweight) -> f64| {
        bobs.iter().map(|bob| grams(of(bob))).collect::<Vec<_>>()
    };
    let mut columns = vec![(Column::words("pin"), bobs.iter().map(|b| Cell::text(&b.pin)).collect())];
    if bobs.iter().any(|b| b.throw.is_some()) {
        let throw = |throw: Option<usize>| throw.map_or(Cell::Empty, |t| Cell::text(t.to_string()));
        columns.push((Column::words("throw"), bobs.iter().map(|b| throw(b.throw)).collect()));
    }
    columns.extend([
        (Column::words("rods"), bobs.iter().map(|b| Cell::text(b.rods.to_string())).collect()),
        (Column::numbers("rotating", "g"), masses(&|b| b.rotating)),
        (Column::numbers("oil", "g"), masses(&|b| b.oil)),
        (Column::numbers("reciprocating", "g"), masses(&|b| b.reciprocating)),
        (Column::numbers("of which", "g"), masses(&|b| answer.reciprocating_share * b.reciprocating)),
        (Column::numbers("bobweight", "g"), masses(&|b| b.mass)),
    ]);
    Table::of_columns("bobweights", "Bobweight of each pin", "", columns)
}

fn choices(answer: &BobweightAnswer) -> Option<Table> {
    let judged = answer.judged_by?;
    let rows = answer
        .choices
        .iter()
        .map(|choice| {
            vec![
                Cell::text(&choice.why),
                percent(Some(choice.share)),
                percent(Some(choice.forward)),
                percent(Some(choice.backward)),
                percent(Some(choice.forward + choice.backward)),
            ]
        })
        .collect();
    Some(Table {
        id: "bobweight-choices",
        title: format!("What a share leaves of the {judged}"),
        note: "Over that which all reciprocating masses would have on the pins.".to_owned(),
        remark: String::new(),
        columns: vec![
            Column::words("share"),
            Column::numbers("", "%"),
            Column::numbers("turning with the crank", "%"),
            Column::numbers("against it", "%"),
            Column::numbers("peak", "%"),
        ],
        rows,
    })
}

fn comparison(answer: &BobweightAnswer) -> Option<Table> {
    let comparison = answer.comparison.as_ref()?;
    let ways = &comparison.ways;
    let largest = |of: &dyn Fn(usize) -> f64| (0..ways.len()).map(of).fold(0.0f64, f64::max);
    let (force, couple) = (largest(&|k| ways[k].force), largest(&|k| ways[k].couple));
    let columns = vec![
        (Column::words("crank"), ways.iter().map(|w| Cell::text(&w.how)).collect()),
        (Column::numbers("peak force", "N"), own_cells(ways.iter().map(|w| w.force), 5)),
        (
            Column::numbers("peak couple", "N m"),
            column_cells(ways.iter().map(|w| w.couple), 5, below(largest_moment(couple, force))),
        ),
    ];
    let rpm = number::terminal(number::rpm(comparison.speed), 0);
    let title = format!("The engine with these parts at {rpm} rpm");
    Some(Table::of_columns("bobweight-comparison", title, "All orders, exact motion.", columns))
}
