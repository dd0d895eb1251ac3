//! `lanchester studio`: the tool in a browser.

use crate::commands::json;
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::options::studio::{Description, StudioArguments};
use crate::program::PROGRAM;
use lanchester_files::SecretFile;
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
            let options = Options {
                path: arguments.path.clone(),
                port: arguments.port,
                all_interfaces: arguments.all_interfaces,
                token,
                program: PROGRAM.to_owned(),
            };
            let mut way_in = None;
            let announce = |address: &str| {
                // Without a reader of this line the address is lost, and with it the studio: it stands on both.
                if print(&format!("{address}\n")).is_err() {
                    eprintln!("{address}");
                }
                eprintln!("The studio answers at this address until Ctrl-C.");
                if arguments.all_interfaces {
                    eprintln!(
                        "It listens at all network interfaces: whoever knows the address and reaches the port reads and writes the folder."
                    );
                }
                if !arguments.no_open {
                    way_in = open(address);
                }
            };
            let ended = serve(&options, announce).map_err(Failure::refused);
            drop(way_in);
            ended?;
            Ok(DONE)
        }
    }
}

/// Opens the address with what the system has for that; where it has nothing, the printed address is enough. Every user of the machine
/// sees the arguments of a program: the browser gets the name of a page that only its user can read, which leads to the address.
fn open(address: &str) -> Option<SecretFile> {
    let page = SecretFile::new("html", &leading_to(address)).ok()?;
    let program = match std::env::consts::OS {
        "macos" => "open",
        "windows" => "explorer",
        _ => "xdg-open",
    };
    let silent = || Stdio::null();
    let command =
        Command::new(program).arg(page.path()).stdin(silent()).stdout(silent()).stderr(silent()).spawn();
    command.ok().map(|_| page)
}

/// A page that leads to an address at once.
fn leading_to(address: &str) -> String {
    let mut escaped = String::new();
    for letter in address.chars() {
        match letter {
            '&' | '<' | '>' | '"' | '\'' => escaped += &format!("&#{};", u32::from(letter)),
            _ => escaped.push(letter),
        }
    }
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Lanchester studio</title>\n\
         <meta name=\"referrer\" content=\"no-referrer\">\n<meta http-equiv=\"refresh\" content=\"0; url={escaped}\">\n\
         <p><a href=\"{escaped}\">Lanchester studio</a></p>\n</html>\n"
    )
}
