//! `lanchester counterweight front`: the trade between two objectives, and the adoption of one of its designs.

use super::drawings::draw;
use super::words::{list, room_words};
use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::{print, write_result};
use crate::format::Format;
use crate::options::counterweight::FrontArguments;
use crate::put_back::PutBack;
use crate::requests::shape::shape_request;
use lanchester::geometry::Front;
use lanchester::report::{front_brief, front_designs_table, front_plot, objective_name};
use lanchester::{
    CounterweightFront, adopted, counterweight_front, design_counterweights, with_counterweights,
};

pub fn run(arguments: &FrontArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let opened = open(&arguments.shape.file, colour)?;
    let engine = &opened.file.engine;
    let file = &arguments.shape.file;
    let request = shape_request(&opened.file, &arguments.shape)?;
    let found = counterweight_front(engine, &request, arguments.against.into(), arguments.designs)
        .map_err(Failure::refused)?;
    let CounterweightFront { front, weights, room, envelope } = &found;
    if front.designs.is_empty() {
        // The optimum alone says what is in the way.
        let designs = design_counterweights(engine, &request).map_err(Failure::refused)?;
        print(&super::designed_counterweights::infeasible_text(&designs))?;
        return Ok(NOT_AS_EXPECTED);
    }
    if let Some(folder) = &arguments.figures {
        write_result(&folder.join("counterweight-front.svg"), file, &front_plot(front).svg())?;
    }
    if let Some(number) = arguments.adopt {
        let design = number.checked_sub(1).and_then(|index| front.designs.get(index)).ok_or_else(|| {
            Failure::input(
                format_args!(
                    "--adopt needs the number of a design, 1 to {}, got {number}",
                    front.designs.len()
                ),
                "leave --adopt out to see the front",
            )
        })?;
        let adopted = adopted(engine, &request, &found, design).map_err(Failure::refused)?;
        let after = with_counterweights(engine, &adopted, request.task.density).map_err(Failure::refused)?;
        let put_back =
            PutBack { path: file, write: arguments.write, dry_run: arguments.dry_run, what: "shapes" };
        if put_back.run(&opened, &after, colour)? {
            return Ok(DONE);
        }
        if let Some(folder) = &arguments.figures {
            draw(&after, folder, file)?;
        }
    }
    let names = list(weights.iter().map(|index| engine.counterweights[*index].name.as_str()));
    let said = match arguments.format {
        Format::Text if arguments.printed.brief => format!("{names}\n{}", front_brief(front)),
        Format::Text => text(&names, room_words(room.as_ref(), envelope.as_ref()), front),
        Format::Json => json(&found)?,
        Format::Csv => front_designs_table(front).csv(),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(DONE)
}

fn text(names: &str, room: Option<String>, front: &Front) -> String {
    let [first, second] = front.objectives.map(objective_name);
    let proof = match front.proved {
        true => {
            format!("For every design it is proved that no shape has less {first} with as little {second}.")
        }
        false => "Not every design is proved to be the best: a search was stopped before its end.".to_owned(),
    };
    let room = room.map(|room| room + "\n").unwrap_or_default();
    format!("{names}\n{room}{proof}\n\n{}", front_designs_table(front).text())
}
