//! `lanchester workshop`: balancing a real crank or engine from measurements.

mod assign;
mod bobweight;
mod correct;
mod crank;
mod crank_input;
mod drill;
mod external;
mod factor;
mod given_factor;
mod grade;
mod internal;
mod sheet;

use crate::failure::Failure;
use crate::options::workshop::{WorkshopArguments, WorkshopCommand};

pub fn run(arguments: &WorkshopArguments, colour: bool) -> Result<u8, Failure> {
    match &arguments.command {
        WorkshopCommand::Factor(arguments) => factor::run(arguments, colour),
        WorkshopCommand::Bobweight(arguments) => bobweight::run(arguments, colour),
        WorkshopCommand::Crank(arguments) => crank::run(arguments, colour),
        WorkshopCommand::External(arguments) => external::run(arguments, colour),
        WorkshopCommand::Internal(arguments) => internal::run(arguments, colour),
        WorkshopCommand::Correct(arguments) => correct::run(arguments, colour),
        WorkshopCommand::Drill(arguments) => drill::run(arguments, colour),
        WorkshopCommand::Assign(arguments) => assign::run(arguments, colour),
        WorkshopCommand::Grade(arguments) => grade::run(arguments, colour),
    }
}
