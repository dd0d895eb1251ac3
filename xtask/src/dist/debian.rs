//! The package for Debian and its kin.

use super::release::{VERSION, commit_time};
use crate::command::quiet;
use crate::workspace::scratch;
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const DESCRIPTION: &str = "balancing of piston engines and the dynamics of their crank train
 From one engine file: shaking forces and couples, torque, bearing loads, torsional
 vibration, mounts and stress of the crankshaft; the counterweights and balance
 shafts that leave the least, with the proof; reports, and a studio in the browser.";

const COPYRIGHT: &str = "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: lanchester
Comment: What the program contains by others, and under which licences, stands in third-party.txt.

Files: *
Copyright: 2026 The Lanchester contributors
License: MIT or Apache-2.0

License: MIT
 The text stands in /usr/share/doc/lanchester/LICENSE-MIT.

License: Apache-2.0
 The text stands in /usr/share/common-licenses/Apache-2.0 and in /usr/share/doc/lanchester/LICENSE-APACHE.
";

/// Makes it from a tree of files in the folder `into`.
pub fn package(into: &Path, tree: &Path) -> Result<PathBuf> {
    let above = scratch("debian")?;
    let (inside, documents) = (above.join("inside"), above.join("inside/usr/share/doc/lanchester"));
    fs::create_dir_all(&inside)?;
    quiet(Command::new("cp").arg("--recursive").arg(tree).arg(inside.join("usr")))?;
    fs::write(documents.join("copyright"), COPYRIGHT)?;
    // Pages and changelog are packed: policy, sections 12.1 and 12.7.
    fs::rename(documents.join("CHANGELOG.md"), documents.join("changelog"))?;
    let mut packed = vec![documents.join("changelog")];
    for page in fs::read_dir(inside.join("usr/share/man/man1"))? {
        packed.push(page?.path());
    }
    quiet(Command::new("gzip").args(["-9", "--no-name"]).args(&packed))?;
    quiet(Command::new("chmod").args(["--recursive", "u=rwX,go=rX"]).arg(&inside))?;
    let architecture = quiet(Command::new("dpkg").arg("--print-architecture"))?.trim().to_owned();
    let control = format!(
        "Package: lanchester\nVersion: {VERSION}\nArchitecture: {architecture}\nMaintainer: The Lanchester contributors\n\
         Depends: {}\nInstalled-Size: {}\nSection: science\nPriority: optional\nDescription: {DESCRIPTION}\n",
        needs(&above, &inside)?,
        kibibytes(&inside)?,
    );
    let meta = inside.join("DEBIAN");
    fs::create_dir_all(&meta)?;
    fs::write(meta.join("control"), control)?;
    fs::write(meta.join("md5sums"), sums(&inside)?)?;
    let package = into.join(format!("lanchester_{VERSION}_{architecture}.deb"));
    let mut deb = Command::new("dpkg-deb");
    deb.args(["--root-owner-group", "-Zxz", "--build"]).arg(&inside).arg(&package);
    quiet(deb.env("SOURCE_DATE_EPOCH", commit_time()?))?;
    Ok(package)
}

/// Libraries that program and binary of units are linked with, and since which version of their packages.
fn needs(above: &Path, inside: &Path) -> Result<String> {
    // It reads the name of the source from there.
    fs::create_dir_all(above.join("debian"))?;
    fs::write(
        above.join("debian/control"),
        "Source: lanchester\n\nPackage: lanchester\nArchitecture: any\n",
    )?;
    let mut reads = Command::new("dpkg-shlibdeps");
    reads.args(["-O", "--ignore-missing-info"]).arg(inside.join("usr/bin/lanchester"));
    let said = quiet(reads.arg(inside.join("usr/lib/lanchester/liblanchester_fmu.so")).current_dir(above))
        .context("the package's dependencies are found with dpkg-shlibdeps: install dpkg-dev")?;
    let line = said.lines().find_map(|line| line.strip_prefix("shlibs:Depends="));
    Ok(line.context("dpkg-shlibdeps names no dependencies")?.to_owned())
}

fn kibibytes(folder: &Path) -> Result<String> {
    let said = quiet(Command::new("du").args(["--summarize", "--apparent-size", "-k"]).arg(folder))?;
    Ok(said.split_whitespace().next().context("du names no size")?.to_owned())
}

fn sums(inside: &Path) -> Result<String> {
    let line = "find usr -type f -print0 | LC_ALL=C sort -z | xargs -0 md5sum";
    quiet(Command::new("sh").args(["-c", line]).current_dir(inside))
}
