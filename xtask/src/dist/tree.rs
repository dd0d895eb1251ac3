//! The files of an installation, below one folder as below `/usr`.

use crate::command::quiet;
use crate::workspace::{files, root, target};
use anyhow::{Context, Result};
use std::env::consts::{DLL_PREFIX, DLL_SUFFIX, EXE_SUFFIX};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Completions: the word of the program for the shell, and the place where the shell looks.
const COMPLETIONS: [(&str, &str); 4] = [
    ("bash", "share/bash-completion/completions/lanchester"),
    ("zsh", "share/zsh/vendor-completions/_lanchester"),
    ("fish", "share/fish/vendor_completions.d/lanchester.fish"),
    ("powershell", "share/doc/lanchester/lanchester.ps1"),
];

/// Texts that go along.
const TEXTS: [(&str, &str); 5] = [
    ("README.md", "README.md"),
    ("CHANGELOG.md", "CHANGELOG.md"),
    ("LICENSE-APACHE", "LICENSE-APACHE"),
    ("LICENSE-MIT", "LICENSE-MIT"),
    ("crates/studio/third-party.txt", "third-party.txt"),
];

/// Writes them.
pub fn write(tree: &Path) -> Result<()> {
    let built = target()?.join("release");
    let program = format!("lanchester{EXE_SUFFIX}");
    let unit = format!("{DLL_PREFIX}lanchester_fmu{DLL_SUFFIX}");
    copy(&built.join(&program), &tree.join("bin").join(&program))?;
    // Where `export fmu` looks.
    copy(&built.join(&unit), &tree.join("lib/lanchester").join(&unit))?;
    let program = built.join(&program);
    let says = |arguments: &[&str]| quiet(Command::new(&program).args(arguments));
    for (shell, place) in COMPLETIONS {
        put(&tree.join(place), &says(&["completions", shell])?)?;
    }
    for name in says(&["manual", "--list"])?.lines() {
        let words: Vec<&str> = name.split(' ').collect();
        let page = says(&[&["manual"], &words[1..]].concat())?;
        put(&tree.join(format!("share/man/man1/{}.1", words.join("-"))), &page)?;
    }
    let documents = tree.join("share/doc/lanchester");
    for (from, to) in TEXTS {
        copy(&root().join(from), &documents.join(to))?;
    }
    // Pressures that examples name lie in `validation/traces`, beside `examples` as in the repository.
    for file in
        files()?.iter().filter(|file| file.starts_with("examples/") || file.starts_with("validation/traces/"))
    {
        copy(&root().join(file), &documents.join(file))?;
    }
    copy_folder(&root().join("docs/book"), &documents.join("book"))
}

fn put(to: &Path, text: &str) -> Result<()> {
    fs::create_dir_all(to.parent().context("a file lies in a folder")?)?;
    fs::write(to, text).with_context(|| format!("cannot write {}", to.display()))
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to.parent().context("a file lies in a folder")?)?;
    fs::copy(from, to).with_context(|| format!("cannot copy {}", from.display())).map(drop)
}

fn copy_folder(from: &Path, to: &Path) -> Result<()> {
    for entry in fs::read_dir(from).with_context(|| format!("cannot read {}", from.display()))? {
        let entry = entry?;
        let (from, to) = (entry.path(), to.join(entry.file_name()));
        if from.is_dir() { copy_folder(&from, &to)? } else { copy(&from, &to)? }
    }
    Ok(())
}
