//! The report in a headless Chromium: it loads, nothing is logged, nothing sticks out sideways, it prints sheets that tell whose they are.

use crate::command::{exists, quiet};
use crate::workspace::{root, scratch};
use anyhow::{Context, Result, bail, ensure};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Widths of a phone and of a desk [CSS pixels].
const WIDTHS: [u32; 2] = [360, 1280];
const NAMES: [&str; 5] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];

/// Browsers beside one another: most of the time each waits.
const BROWSERS: usize = 3;

/// Opens the reports of all examples.
pub fn check_reports(program: &Path) -> Result<String> {
    let (chromium, pdftotext) = (chromium()?, installed(&["pdftotext"], "poppler-utils")?);
    let examples = crate::engines::examples()?;
    let lanes: Vec<Result<()>> = std::thread::scope(|scope| {
        let lanes: Vec<_> = (0..BROWSERS)
            .map(|lane| {
                let own = examples.iter().skip(lane).step_by(BROWSERS);
                let programs = Programs { lanchester: program, chromium: &chromium, pdftotext: &pdftotext };
                scope.spawn(move || -> Result<()> {
                    let folder = scratch(&format!("browser-{lane}"))?;
                    own.into_iter().try_for_each(|example| check_report(&programs, &folder, example))
                })
            })
            .collect();
        let joined = lanes.into_iter().map(std::thread::ScopedJoinHandle::join);
        joined
            .map(|lane| lane.unwrap_or_else(|_| Err(anyhow::anyhow!("a browser's thread panicked"))))
            .collect()
    });
    lanes.into_iter().collect::<Result<()>>()?;
    Ok(format!("{} reports at {WIDTHS:?} px and as PDF", examples.len()))
}

/// What a report is made and looked at with.
struct Programs<'a> {
    lanchester: &'a Path,
    chromium: &'a Path,
    pdftotext: &'a Path,
}

fn check_report(programs: &Programs<'_>, folder: &Path, example: &Path) -> Result<()> {
    let name = example.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let report = folder.join(format!("{name}.html"));
    quiet(
        Command::new(programs.lanchester)
            .arg("report")
            .arg(example)
            .arg("--output")
            .arg(&report)
            .current_dir(root()),
    )?;
    for width in WIDTHS {
        check_width(programs.chromium, folder, &report, width)
            .with_context(|| format!("{name} at {width} px"))?;
    }
    let file = example.file_name().unwrap_or_default().to_string_lossy();
    check_print(programs, folder, &report, &file).with_context(|| format!("{name} on paper"))
}

/// Loads the report in a frame of the given width, where a probe at its end tells its parent what it measures.
fn check_width(chromium: &Path, folder: &Path, report: &Path, width: u32) -> Result<()> {
    let text = std::fs::read_to_string(report)?;
    let (head, tail) = text.rsplit_once("</body>").context("the report has no </body>")?;
    let probe = "<script>addEventListener('load', () => setTimeout(() => { \
        const page = document.documentElement; \
        parent.postMessage(`wide=${page.scrollWidth} view=${page.clientWidth} figures=${document.querySelectorAll('svg').length}`, '*'); \
        }, 100));</script>";
    std::fs::write(folder.join("probed.html"), format!("{head}{probe}</body>{tail}"))?;
    let frame = format!(
        "<!doctype html><body style='margin:0'><iframe src='probed.html' style='border:0' width='{width}' height='900'></iframe>\
         <pre id='said'></pre><script>addEventListener('message', e => said.textContent = e.data)</script></body>"
    );
    let page = folder.join("frame.html");
    std::fs::write(&page, frame)?;

    let mut command = headless(chromium, folder);
    command.args([
        "--enable-logging=stderr",
        "--virtual-time-budget=5000",
        "--window-size=1400,1000",
        "--dump-dom",
    ]);
    let finished = crate::command::output(command.arg(address(&page)))?;
    if let Some(line) = finished.stderr.lines().find(|line| line.contains(":CONSOLE")) {
        bail!("the page logs: {line}");
    }
    let said = finished.stdout.split("<pre id=\"said\">").nth(1).and_then(|rest| rest.split("</pre>").next());
    let said = said.filter(|text| !text.is_empty()).context("the page did not load")?;
    let number = |key: &str| -> Result<u32> {
        let word = said.split(' ').find_map(|word| word.strip_prefix(key));
        Ok(word.context("the probe said too little")?.parse()?)
    };
    let (wide, view) = (number("wide=")?, number("view=")?);
    ensure!(wide <= view, "the page is {wide} px wide in a window of {view} px");
    ensure!(number("figures=")? > 0, "the page shows no figure");
    Ok(())
}

fn check_print(programs: &Programs<'_>, folder: &Path, report: &Path, file: &str) -> Result<()> {
    let pdf = folder.join("report.pdf");
    let mut command = headless(programs.chromium, folder);
    // Sheets have margins of their own, with their numbers.
    command.arg("--no-pdf-header-footer");
    quiet(command.arg(format!("--print-to-pdf={}", pdf.display())).arg(address(report)))?;
    let bytes = std::fs::read(&pdf).context("nothing was printed")?;
    ensure!(bytes.starts_with(b"%PDF") && bytes.len() > 10_000, "the printed file is no PDF or empty");
    let text = quiet(Command::new(programs.pdftotext).arg("-layout").arg(&pdf).arg("-"))?;
    check_sheets(&text, file)?;
    std::fs::remove_file(&pdf)?;
    Ok(())
}

/// Every sheet names the engine file and its own number among all, and none holds its margins alone.
fn check_sheets(text: &str, file: &str) -> Result<()> {
    let sheets: Vec<&str> = text.trim_end_matches('\u{c}').split('\u{c}').collect();
    for (place, sheet) in sheets.iter().enumerate() {
        let number = format!("{} of {}", place + 1, sheets.len());
        ensure!(sheet.contains(&number), "a sheet does not say that it is {number}");
        ensure!(sheet.contains(file), "sheet {number} does not name {file}");
        let lines = sheet.lines().filter(|line| !line.trim().is_empty()).count();
        ensure!(lines > 4, "sheet {number} is empty but for its margins");
    }
    Ok(())
}

fn headless(chromium: &Path, folder: &Path) -> Command {
    let mut command = Command::new(chromium);
    command.args([
        "--headless",
        "--disable-gpu",
        "--hide-scrollbars",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--disable-dev-shm-usage",
    ]);
    command.arg(format!("--user-data-dir={}", folder.join("profile").display()));
    if is_root() {
        // Chromium refuses its sandbox to root; the page is our own and opens nothing else.
        command.arg("--no-sandbox");
    }
    command
}

fn address(page: &Path) -> String {
    format!("file://{}", page.display())
}

/// A Chromium on the path, installed from the distribution where it is missing and we may.
pub fn chromium() -> Result<PathBuf> {
    installed(&NAMES, "chromium")
}

/// The first of these programs on the path, installed with its package of the distribution where all are missing and we may.
fn installed(names: &[&str], package: &str) -> Result<PathBuf> {
    if let Some(name) = names.iter().find(|name| exists(name)) {
        return Ok(name.into());
    }
    if !(is_root() && exists("apt-get")) {
        bail!(
            "no {package} found ({}): install it, for example `sudo apt-get install {package}`, and run again",
            names.join(", ")
        );
    }
    println!("   {package} is missing: installing it");
    quiet(Command::new("apt-get").arg("update"))?;
    let mut install = Command::new("apt-get");
    quiet(install.args(["install", "--yes", package]).env("DEBIAN_FRONTEND", "noninteractive"))?;
    names.iter().find(|name| exists(name)).map(PathBuf::from).with_context(|| {
        format!("the package {package} is installed and brings none of {}", names.join(", "))
    })
}

fn is_root() -> bool {
    quiet(Command::new("id").arg("--user")).is_ok_and(|user| user.trim() == "0")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sheets_without_name_number_or_content_are_found() {
        let sheet = |number: &str| format!("four   lanchester\na\nb\nc\nfour.toml   {number}\n\u{c}");
        let whole = [sheet("1 of 2"), sheet("2 of 2")].concat();
        assert!(check_sheets(&whole, "four.toml").is_ok());
        assert!(check_sheets(&whole, "five.toml").is_err());
        assert!(check_sheets(&sheet("1 of 2"), "four.toml").is_err());
        let empty = "four   lanchester\nfour.toml   2 of 2\n\u{c}";
        assert!(check_sheets(&(sheet("1 of 2") + empty), "four.toml").is_err());
    }
}
