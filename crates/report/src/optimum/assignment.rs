//! Which weighed piston and rod belongs into which cylinder.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, numbers};
use lanchester_study::scatter::{Assignment, AssignmentRequest};

/// The parts of every cylinder.
pub fn assignment_table(request: &AssignmentRequest, found: &Assignment) -> Table {
    let counted = |header: &str, values: &[usize]| {
        let cells = values.iter().map(|&number| Cell::Number { value: number as f64, decimals: 0 });
        (Column::numbers(header, ""), cells.collect())
    };
    let cylinders: Vec<usize> = (1..=found.pistons.len()).collect();
    let piston = |k: &usize| 1e3 * request.pistons[*k - 1];
    let (big, small) = (
        |k: &usize| 1e3 * request.rods[*k - 1].big_end_mass,
        |k: &usize| 1e3 * request.rods[*k - 1].small_end_mass,
    );
    let columns = vec![
        counted("cylinder", &cylinders),
        counted("piston", &found.pistons),
        numbers("its mass", "g", found.pistons.iter().map(piston), 5),
        counted("rod", &found.rods),
        numbers("big end", "g", found.rods.iter().map(big), 5),
        numbers("small end", "g", found.rods.iter().map(small), 5),
    ];
    let speed = request.speed.unwrap_or(request.engine.speed.highest);
    let note = format!(
        "Parts are numbered as they were given. At {} rpm; a couple counts over a lever of {} mm.",
        number::terminal(number::rpm(speed), 0),
        number::trimmed(1e3 * request.lever, 4)
    );
    Table::of_columns("assignment", "Which part into which cylinder", note, columns)
}

/// The assignment for a terminal.
pub fn assignment_text(request: &AssignmentRequest, found: &Assignment) -> String {
    let newtons = |value: f64| number::terminal(value, number::decimals(value, 4));
    let proof = match found.proved {
        true => "no other assignment leaves less".to_owned(),
        false => format!("found by exchanges; none leaves less than {} N", newtons(found.bound)),
    };
    format!(
        "{}\n\n{}\nFirst order left: force {} N, couple {} N m; together {} N ({proof}).\nWith the parts as they were numbered: {} N.\n\
         Together: the root of the squares of force and couple over the lever, forward and backward parts each; this is minimised.\n",
        request.engine.name,
        assignment_table(request, found).text(),
        newtons(found.force),
        newtons(found.couple),
        newtons(found.residual),
        newtons(found.as_numbered),
    )
}
