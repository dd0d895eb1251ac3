//! `cargo xtask tidy`: the rules that no compiler checks. Every breach is reported, not the first alone.

mod arrows;
mod circles;
mod folders;
mod known;
mod pages;
mod sources;
mod words;

use crate::{generate, tolerances, workspace};
use anyhow::{Result, bail};

/// All rules, generated pages included.
pub fn run() -> Result<()> {
    println!("{}", sources()?);
    println!("{}", generate::check(&workspace::program(workspace::Profile::Dev)?)?);
    Ok(())
}

/// The rules that need nothing built.
pub fn sources() -> Result<String> {
    let files = workspace::files()?;
    let mut breaches = arrows::check(&workspace::metadata()?);
    breaches.extend(sources::check(&files)?);
    breaches.extend(folders::check(&files));
    breaches.extend(circles::check(&files)?);
    breaches.extend(pages::check(&files)?);
    breaches.extend(words::check(&files)?);
    breaches.extend(tolerances::check().err().map(|error| error.to_string()));
    if !breaches.is_empty() {
        bail!("{} breaches of the rules\n{}", breaches.len(), breaches.join("\n"));
    }
    Ok(format!("{} files", files.len()))
}
