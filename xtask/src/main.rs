//! Tasks of the workspace: `cargo xtask <task>`.

mod advisories;
mod book;
mod browser;
mod ci;
mod claims;
mod command;
mod dist;
mod documents;
mod engines;
mod fuzz;
mod generate;
mod hostile;
mod licence;
mod lint;
mod notices;
mod packages;
mod page;
mod python;
mod steps;
mod stress;
mod supply;
mod test_programs;
mod tidy;
mod tolerances;
mod workspace;

use anyhow::{Result, bail};
use std::process::ExitCode;
use steps::Steps;
use workspace::Profile;

const HELP: &str = "\
tasks of the workspace

  cargo xtask ci                                all that CI runs; installs what it needs; --to-the-end tells all failures, --only TEXT runs
                                                the steps whose names hold it
  cargo xtask quick                             before the next change: format, rules, lints, tests but the slow ones
  cargo xtask test [--release]                  all tests with the cases of CI; lists the slowest; --release in the profile of CI
  cargo xtask tidy                              rules of the house: crate arrows, pages, links, file length, ...;
                                                --sources for those that need nothing built
  cargo xtask generate                          write the generated pages and pictures of the book anew; --release with the program of CI,
                                                --theory the pictures of the theory alone, with that program
  cargo xtask documents [--release]             run what the README's and the book's pages show and quote
  cargo xtask page                              build the studio's page into the repository
  cargo xtask web [--try]                       build the studio that needs no server into target/web: a folder for any file server, and in it
                                                lanchester.html, one file that opens from a disk; --try walks through it in a browser
  cargo xtask python [--dev] [--write]          the Python package: wheel, types, tests, doctests, notebooks, in an environment below the target
                                                folder; --dev without optimisation, --write writes its generated types
  cargo xtask wheel                             build the wheel of the Python package into target/wheels
  cargo xtask dist                              build the release archive, and with dpkg-deb the Debian package, into target/dist: program, binary of units,
                                                completions, manual pages, examples, book
  cargo xtask package [--compile]               every published crate as a package of a registry, which must be whole; --compile compiles the program
                                                from the packages alone
  cargo xtask reports                           open the reports of all examples in a browser
  cargo xtask pictures                          draw the pictures of the studio's guide anew, in a browser
  cargo xtask notices                           write the notices of third parties anew
  cargo xtask supply                            licences, sources and advisories of what comes from others
  cargo xtask advisories CLONE                  take the advisories of our crates from a clone of the RustSec database
  cargo xtask book                              build the book into docs/book
  cargo xtask stress [--seconds N] [--only T]   draw new cases for the properties over random engines
  cargo xtask hostile [--seconds N] [--seed N]  mutated files, kills, laws over random engines, attacks on the studio; --short for a quick round
  cargo xtask fuzz [--seconds N] [--target T]   fuzz reader, loads, workshop and optimum (nightly, cargo-fuzz)
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match task(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn task(arguments: &[String]) -> Result<()> {
    let rest = arguments.get(1..).unwrap_or_default();
    match arguments.first().map(String::as_str) {
        Some("ci") if rest.is_empty() => ci::run(Steps::default()),
        Some("ci") if rest == ["--to-the-end"] => ci::run(Steps::to_the_end()),
        Some("ci") if matches!(rest, [option, _] if option == "--only") => ci::run(Steps::only(&rest[1])),
        Some("quick") if rest.is_empty() => ci::quick(),
        Some("test") if rest.is_empty() || rest == ["--release"] => {
            let profile = if rest.is_empty() { Profile::Dev } else { Profile::Release };
            println!("{}", test_programs::all(profile)?);
            Ok(())
        }
        Some("tidy") if rest.is_empty() => tidy::run(),
        Some("tidy") if rest == ["--sources"] => {
            println!("{}", tidy::sources()?);
            Ok(())
        }
        Some("generate") if rest.is_empty() => generate::write(Profile::Dev),
        Some("generate") if rest == ["--theory"] => generate::write_theory(),
        Some("generate") if rest == ["--release"] => generate::write(Profile::Release),
        Some("documents") if rest.is_empty() || rest == ["--release"] => {
            let profile = if rest.is_empty() { Profile::Dev } else { Profile::Release };
            let program = workspace::program(profile)?;
            println!("{}\n{}", documents::engines(&program)?, claims::check(&program)?);
            Ok(())
        }
        Some("page") if rest.is_empty() => page::build(),
        Some("web") if rest == ["--try"] => {
            println!("{}", page::web::try_in_browser(&workspace::program(Profile::Release)?)?);
            Ok(())
        }
        Some("web") if rest.is_empty() => {
            println!("{}", page::web::build()?.display());
            Ok(())
        }
        Some("python") => {
            println!("{}", python::run(rest)?);
            Ok(())
        }
        Some("wheel") if rest.is_empty() => {
            println!("{}", python::wheel()?.display());
            Ok(())
        }
        Some("dist") if rest.is_empty() => {
            println!("{}", dist::build()?);
            Ok(())
        }
        Some("package") if rest.is_empty() => {
            println!("{}", dist::crates::check()?);
            Ok(())
        }
        Some("package") if rest == ["--compile"] => {
            println!("{}", dist::crates::compile()?);
            Ok(())
        }
        Some("reports") if rest.is_empty() => {
            println!("{}", browser::check_reports(&workspace::program(Profile::Dev)?)?);
            Ok(())
        }
        Some("pictures") if rest.is_empty() => page::draw(&workspace::program(Profile::Dev)?),
        Some("book") if rest.is_empty() => book::build(),
        Some("notices") if rest.is_empty() => {
            page::install()?;
            println!("{}", notices::write()?);
            Ok(())
        }
        Some("supply") if rest.is_empty() => {
            println!("{}", supply::check(false)?);
            Ok(())
        }
        Some("advisories") => {
            let [clone] = rest else {
                bail!("`advisories` needs the folder of a clone of the RustSec database")
            };
            println!("{}", advisories::write(clone.as_ref())?);
            Ok(())
        }
        Some("stress") => stress::run(rest),
        Some("hostile") => hostile::run(rest),
        Some("fuzz") => fuzz::run(rest),
        None | Some("help" | "--help" | "-h") => {
            print!("{HELP}");
            Ok(())
        }
        Some(_) => bail!("unknown task or option `{}`\n\n{HELP}", arguments.join(" ")),
    }
}
