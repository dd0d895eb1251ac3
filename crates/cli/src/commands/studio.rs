//! `lanchester studio`: the tool in a browser.

use crate::commands::json;
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::program::PROGRAM;
use crate::studio_arguments::{Description, StudioArguments};
use lanchester_studio::{Options, openapi, serve, typescript};
use std::process::{Command, Stdio};

/// Holds the token of the address where it shall not be a random one, for a server that is started again under an open page.
const TOKEN: &str = "LANCHESTER_STUDIO_TOKEN";

pub fn run(arguments: &StudioArguments) -> Result<u8, Failure> {
    match arguments.describe {
        Some(Description::Openapi) => print(&json(&openapi())?).map(|()| DONE),
        Some(Description::Typescript) => print(&typescript()).map(|()| DONE),
        None => {
            let token = std::env::var(TOKEN).ok().filter(|token| !token.is_empty());
            let (path, port) = (arguments.path.clone(), arguments.port);
            let options = Options { path, port, token, program: PROGRAM.to_owned() };
            let announce = |address: &str| {
                // Without a reader of this line the address is lost, and with it the studio: it stands on both.
                if print(&format!("{address}\n")).is_err() {
                    eprintln!("{address}");
                }
                eprintln!("The studio answers at this address until Ctrl-C.");
                if !arguments.no_open {
                    open(address);
                }
            };
            serve(&options, announce).map_err(Failure::refused)?;
            Ok(DONE)
        }
    }
}

/// Opens the address with what the system has for that; where it has nothing, the printed address is enough.
fn open(address: &str) {
    let programs: &[(&str, &[&str])] = match std::env::consts::OS {
        "macos" => &[("open", &[])],
        "windows" => &[("explorer", &[])],
        _ => &[("xdg-open", &[])],
    };
    for (program, arguments) in programs {
        let silent = || Stdio::null();
        let _ = Command::new(program)
            .args(*arguments)
            .arg(address)
            .stdin(silent())
            .stdout(silent())
            .stderr(silent())
            .spawn();
    }
}
