//! `lanchester workshop factor`: balance factors by every definition.

use super::given_factor::{bad, given_factor};
use crate::commands::{json, open};
use crate::failure::{DONE, Failure};
use crate::files::{print, write_result};
use crate::format::Format;
use crate::options::workshop::FactorArguments;
use lanchester::report::Table;
use lanchester::report::workshop::{factor_tables, factor_text, primary_ellipse_figure};
use lanchester::task::option;
use lanchester::workshop::{FactorRequest, factor_answer};

pub fn run(arguments: &FactorArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let request = FactorRequest {
        given: given_factor(&arguments.given)?,
        oil: match &arguments.oil {
            Some(text) => option::mass(text, "--oil").map_err(bad)?,
            None => 0.0,
        },
        angle: match &arguments.angle {
            Some(text) => Some(option::angle(text, "--angle").map_err(bad)?),
            None => None,
        },
    };
    let opened = open(&arguments.engine, colour)?;
    let answer = factor_answer(&opened.file.engine, &request).map_err(Failure::refused)?;
    if let Some(path) = &arguments.figure {
        let Some(figure) = primary_ellipse_figure(&answer) else {
            return Err(Failure::input(
                "there is no primary ellipse to draw: nothing reciprocates, or the counterweights stand beside their throws",
                "leave --figure out",
            ));
        };
        write_result(path, &arguments.engine, &figure.svg())?;
    }
    let said = match arguments.format {
        Format::Text => factor_text(&answer),
        Format::Json => json(&answer)?,
        Format::Csv => factor_tables(&answer).iter().map(Table::csv).collect::<Vec<_>>().join("\r\n"),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(DONE)
}
