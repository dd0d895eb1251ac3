//! `lanchester workshop assign`: which weighed piston and rod belongs into which cylinder.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::format::Format;
use crate::options::workshop::AssignArguments;
use lanchester::report::{assignment_table, assignment_text};
use lanchester::study::scatter::{AssignmentRequest, WeighedRod, assign, standard_lever};
use lanchester::task::option;

pub fn run(arguments: &AssignArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let pistons = masses(arguments.pistons.as_deref(), "--pistons")?;
    let big_ends = masses(arguments.big_ends.as_deref(), "--big-ends")?;
    let small_ends = masses(arguments.small_ends.as_deref(), "--small-ends")?;
    let given = arguments.lever.as_deref().map(|text| option::length(text, "--lever")).transpose()?;
    let speed = arguments.speed.as_deref().map(|text| option::speed(text, "--speed")).transpose()?;
    if [&pistons, &big_ends, &small_ends].into_iter().all(Option::is_none) {
        return Err(Failure::input(
            "nothing is weighed",
            "give --pistons '401.2 g, 400.1 g', --big-ends or --small-ends, one mass for each cylinder in the order of the parts",
        ));
    }
    let engine = open(&arguments.file, colour)?.file.engine;
    let own = |weighed: Option<Vec<f64>>, option: &str, mass: fn(&lanchester::model::Cylinder) -> f64| {
        let Some(weighed) = weighed else { return Ok(engine.cylinders.iter().map(mass).collect()) };
        let (got, needed) = (weighed.len(), engine.cylinders.len());
        if got == needed {
            return Ok(weighed);
        }
        Err(Failure::input(
            format!("`{option}` needs {needed} masses, one for each cylinder, got {got}"),
            "weigh every part, and separate the masses by commas",
        ))
    };
    let pistons: Vec<f64> = own(pistons, "--pistons", |cylinder| cylinder.piston_mass)?;
    let big_ends: Vec<f64> = own(big_ends, "--big-ends", |cylinder| cylinder.rod.big_end_mass)?;
    let small_ends: Vec<f64> = own(small_ends, "--small-ends", |cylinder| cylinder.rod.small_end_mass)?;
    let rods = big_ends.into_iter().zip(small_ends);
    let rods = rods.map(|(big_end_mass, small_end_mass)| WeighedRod { big_end_mass, small_end_mass });
    let lever = given.unwrap_or_else(|| standard_lever(&engine));
    let request = AssignmentRequest { speed, pistons, rods: rods.collect(), lever, engine };
    let found = assign(&request).map_err(Failure::refused)?;
    let said = match arguments.format {
        Format::Text => assignment_text(&request, &found),
        Format::Json => json(&found)?,
        Format::Csv => assignment_table(&request, &found).csv(),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(DONE)
}

/// Masses separated by commas.
fn masses(list: Option<&str>, option: &str) -> Result<Option<Vec<f64>>, Failure> {
    let one = |text: &str| {
        let mass = option::mass(text.trim(), option)?;
        match mass > 0.0 {
            true => Ok(mass),
            false => Err(Failure::input(
                format!("`{option}` needs masses above 0, got {}", text.trim()),
                "give what the scales show",
            )),
        }
    };
    list.map(|list| list.split(',').map(one).collect()).transpose()
}
