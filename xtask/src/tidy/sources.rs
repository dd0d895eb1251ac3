//! Rules on source text: purity below the front ends, file length, no orphaned reminders, no traces of one machine.

use crate::workspace;
use anyhow::Result;

/// Longest source file [lines].
const MAX_LINES: usize = 700;

/// The front ends and what they share; every other crate knows no file, network, clock or printing.
const FRONT_ENDS: [&str; 6] =
    ["crates/cli/", "crates/files/", "crates/fmu/", "crates/python/", "crates/studio/", "crates/web/"];
/// Where a file name would reach a terminal as it is: `shown` writes out what acts on it.
const SHOWN: &str = "crates/cli/src/";
const RAW_NAME: &str = ".display()";
/// What writes files: one module does, for all front ends.
const WRITES: [&str; 3] = ["File::create", "OpenOptions", "fs::write"];
/// Pipes, devices and the lock of a run are no files that somebody's text could be lost in.
const WRITERS: [&str; 3] = ["crates/files/src/", "crates/cli/src/run/", "crates/cli/src/files.rs"];
const IMPURE: [&str; 12] = [
    "std::fs",
    "std::net",
    "std::env",
    "std::process",
    "SystemTime",
    "Instant::now",
    "println!",
    "eprintln!",
    "print!(",
    "eprint!(",
    "static mut",
    "io::stdout",
];

/// They say which command answers the same: a page that its command prints, the questions of the studio.
const NAME_COMMANDS: [&str; 2] = ["crates/validation/", "crates/answers/"];

/// This file names what it forbids.
const EXEMPT: &str = "xtask/src/tidy/sources.rs";
const REMINDERS: [&str; 3] = ["TODO", "FIXME", "XXX"];
const MACHINE: [&str; 9] = [
    "/work/",
    "/root/",
    "/home/",
    "/Users/",
    "C:\\Users",
    "index.crates.io",
    "static.crates.io",
    "sparse+http",
    "://localhost",
];

/// Breaches in the files given.
pub fn check(files: &[String]) -> Result<Vec<String>> {
    let mut breaches = Vec::new();
    for file in files.iter().filter(|file| *file != EXEMPT) {
        // Data of the sources and fuzz seeds are not ours to word.
        if file.starts_with("validation/") || file.starts_with("fuzz/seeds/") {
            continue;
        }
        if let Some(text) = workspace::text(file)? {
            breaches.extend(check_text(file, &text));
        }
    }
    Ok(breaches)
}

fn check_text(file: &str, text: &str) -> Vec<String> {
    let mut breaches = Vec::new();
    let lines = text.lines().count();
    if file.ends_with(".rs") && lines > MAX_LINES {
        breaches.push(format!("{file}: {lines} lines, more than {MAX_LINES}: one noun a file reads better"));
    }
    let below = file.starts_with("crates/") && !FRONT_ENDS.iter().any(|folder| file.starts_with(folder));
    let pure = below && file.ends_with(".rs") && !is_test(file);
    let front = FRONT_ENDS.iter().any(|folder| file.starts_with(folder)) && file.contains("/src/");
    let writes = front && !WRITERS.iter().any(|place| file.starts_with(place));
    let mut in_tests = false;
    let mut after_cfg_test = false;
    for (index, line) in text.lines().enumerate() {
        let place = format!("{file}:{}", index + 1);
        // A test module within the file is its last item; one in a file of its own only has its name here.
        in_tests |= after_cfg_test && line.contains('{');
        after_cfg_test = line.trim_start().starts_with("#[cfg(test)]");
        let code = line.split("//").next().unwrap_or_default();
        if pure && !in_tests {
            for word in IMPURE.iter().filter(|word| holds(code, word)) {
                breaches.push(format!("{place}: `{word}` below the front ends"));
            }
            let may_name = NAME_COMMANDS.iter().any(|folder| file.starts_with(folder));
            if let Some(name) = command_line_name(code).filter(|_| !may_name) {
                breaches.push(format!(
                    "{place}: `{name}` is for the command line to name, which words the remedy"
                ));
            }
        }
        if file.starts_with(SHOWN) && code.contains(RAW_NAME) {
            breaches.push(format!("{place}: `{RAW_NAME}` shows a name as it is; `shown` cleans it"));
        }
        if writes && !in_tests {
            for word in WRITES.iter().filter(|word| holds(code, word)) {
                breaches.push(format!("{place}: `{word}`; `lanchester_files::NewFile` is the one writer"));
            }
        }
        for word in REMINDERS.iter().filter(|word| holds(line, word)) {
            if !line.contains('#') {
                breaches.push(format!("{place}: {word} without the number of an issue"));
            }
        }
        for word in MACHINE.iter().filter(|word| line.contains(*word)) {
            breaches.push(format!("{place}: `{word}` belongs to one machine"));
        }
    }
    breaches
}

/// A command or an option of the command line that a text names.
fn command_line_name(code: &str) -> Option<&str> {
    if let Some((_, after)) = code.split_once("`lanchester ") {
        return Some(after.split('`').next().unwrap_or(after));
    }
    code.match_indices("--").find_map(|(start, _)| {
        let is_name = |c: char| c.is_ascii_lowercase() || c == '-';
        let name = &code[start + 2..];
        let length = name.find(|c| !is_name(c)).unwrap_or(name.len());
        let begins = code[..start].ends_with(['"', '`', '\'', ' ', '(']) && !code[..start].ends_with("var(");
        // `--width:` is a style's.
        let is_style = name[length..].starts_with(':');
        (begins && !is_style && name.starts_with(|c: char| c.is_ascii_lowercase()))
            .then_some(&code[start..start + 2 + length])
    })
}

/// `word` in `text`, not as the tail of a longer word (`print!(` is not in `eprint!(`).
fn holds(text: &str, word: &str) -> bool {
    text.match_indices(word).any(|(start, _)| {
        !text[..start].chars().next_back().is_some_and(|before| before.is_alphanumeric() || before == '_')
    })
}

fn is_test(file: &str) -> bool {
    file.ends_with("/tests.rs") || file.contains("/tests/") || file.contains("/benches/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_and_options_are_named_by_the_command_line_alone() {
        let text = "const HINT: &str = \"give --angle, or `lanchester show` it\";\nlet style = \"--size:3px; width: var(--size)\"";
        let breaches = check_text("crates/model/src/a.rs", text);
        assert!(breaches.len() == 1 && breaches[0].contains("`show`"), "{breaches:?}");
        let breaches = check_text("crates/model/src/a.rs", "const HINT: &str = \"give --angle\";");
        assert!(breaches.len() == 1 && breaches[0].contains("`--angle`"), "{breaches:?}");
        assert!(check_text("crates/cli/src/a.rs", text).is_empty());
    }

    #[test]
    fn printing_is_a_breach_below_the_front_ends_alone() {
        let text = "fn f() {\n    println!(\"x\");\n}\n";
        assert_eq!(
            check_text("crates/model/src/a.rs", text),
            ["crates/model/src/a.rs:2: `println!` below the front ends"]
        );
        assert!(check_text("crates/cli/src/a.rs", text).is_empty());
        assert!(check_text("crates/model/src/a.rs", "#[cfg(test)]\nmod tests {\nprintln!()\n}").is_empty());
        assert!(check_text("crates/model/src/a.rs", "// println! is not for us\n").is_empty());
    }

    #[test]
    fn front_ends_have_one_writer_and_show_no_raw_name() {
        let write = "fn f() {\n    std::fs::write(path, text);\n}\n";
        assert_eq!(check_text("crates/cli/src/a.rs", write).len(), 1);
        assert_eq!(check_text("crates/studio/src/a.rs", write).len(), 1);
        assert!(check_text("crates/files/src/a.rs", write).is_empty());
        assert!(check_text("crates/cli/tests/a.rs", write).is_empty());
        assert_eq!(check_text("crates/cli/src/a.rs", "let x = path.display();").len(), 1);
    }

    #[test]
    fn long_files_reminders_and_machine_paths() {
        assert_eq!(check_text("a.rs", &"\n".repeat(MAX_LINES + 1)).len(), 1);
        assert!(check_text("a.rs", &"\n".repeat(MAX_LINES)).is_empty());
        assert_eq!(check_text("a.md", "TODO: later").len(), 1);
        assert!(check_text("a.md", "TODO(#12): later").is_empty());
        assert_eq!(check_text("a.md", "see /home/someone/x").len(), 1);
    }
}
