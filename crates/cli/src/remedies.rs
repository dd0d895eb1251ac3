//! Which option or command mends an error: what only the command line can say. The errors themselves name neither.

use lanchester::multibody::MultibodyError;
use lanchester::{CounterweightError, CrossCheckError, LayoutSize, LayoutSpaceError};
use std::any::Any;

/// What to write on the command line so that `error` goes, where an option or a command does it.
pub fn remedy(error: &dyn Any) -> Option<String> {
    let space = error.downcast_ref().and_then(of_space);
    let counterweight = || error.downcast_ref().and_then(of_counterweight);
    let run = || error.downcast_ref().and_then(of_run);
    space.or_else(counterweight).or_else(run).map(str::to_owned)
}

fn of_run(error: &CrossCheckError) -> Option<&'static str> {
    Some(match error {
        CrossCheckError::Multibody(MultibodyError::TooLong { samples, most_samples, .. }) => {
            match samples > most_samples {
                true => {
                    "--for makes it shorter, --step takes a larger sample step, --long lets it take as long as it takes"
                }
                false => "--for makes it shorter, --long lets it take as long as it takes",
            }
        }
        _ => return None,
    })
}

fn of_space(error: &LayoutSpaceError) -> Option<&'static str> {
    Some(match error {
        LayoutSpaceError::OneThrow { .. } => {
            "give several --counterweights or --shafts to choose from; to search the layouts that its pistons and rods could make instead, give --in-line or --bank-angle, and --spacing"
        }
        LayoutSpaceError::Kept { .. } => {
            "leave that option out; to search the layouts that its pistons and rods could make instead, give --in-line or --bank-angle, and --spacing"
        }
        LayoutSpaceError::Banks { .. } => {
            "to search the layouts that its pistons and rods could make instead, give --in-line or --bank-angle, and --spacing"
        }
        LayoutSpaceError::Missing { size, .. } => match size {
            LayoutSize::Spacing => "give --spacing",
            LayoutSize::WebDistance => "give --web-distance",
            LayoutSize::WebThickness => "give --web-thickness",
            LayoutSize::PinDiameter => "give --pin-diameter",
        },
        LayoutSpaceError::InLineWithBanks => {
            "leave --in-line out, or --bank-angle, --split-angle and --stagger"
        }
        LayoutSpaceError::OneBank => "add --bank-angle, such as --bank-angle '90 deg'",
        _ => return None,
    })
}

fn of_counterweight(error: &CounterweightError) -> Option<&'static str> {
    Some(match error {
        CounterweightError::NoneOnAWeb { has_weights: true } => "name one with --weight",
        CounterweightError::NoneOnAWeb { has_weights: false } => {
            "`lanchester balance FILE --counterweights webs --write` finds them"
        }
        CounterweightError::BareShaft { .. } => "`lanchester counterweight design FILE --write` finds shapes",
        CounterweightError::NoPart => {
            "`lanchester counterweight design FILE --write` finds shapes, `counterweight import` takes them from a drawing"
        }
        _ => return None,
    })
}
