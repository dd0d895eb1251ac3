//! The only place that touches the file system: engine files in, results out.

use crate::failure::Failure;
use lanchester_files::{NewFile, Over, PutError, shown};
use std::fmt::Display;
use std::fs::{self, File};
use std::io::{self, IsTerminal, Read, Write};
use std::path::Path;

/// An engine file may be this long; a longer one is some other file.
const LONGEST_INPUT: u64 = 4 << 20;

/// A drawing may be this long.
const LONGEST_DRAWING: u64 = 64 << 20;

/// A text and the name that messages call it by.
pub struct Source {
    /// File name as a terminal may show it, or `<stdin>`.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// Read a file that is not the engine's, such as a drawing; `hint` says what is due.
pub fn read_bytes(path: &Path, hint: &str) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(LONGEST_DRAWING + 1).read_to_end(&mut bytes));
    checked_bytes(read, &shown(path), hint, LONGEST_DRAWING)?;
    Ok(bytes)
}

/// The same; `-` is standard input.
pub fn read_bytes_or_input(path: &Path, hint: &str) -> Result<Vec<u8>, Failure> {
    if path != Path::new("-") {
        return read_bytes(path, hint);
    }
    let mut bytes = Vec::new();
    let read = io::stdin().lock().take(LONGEST_DRAWING + 1).read_to_end(&mut bytes);
    checked_bytes(read, "<stdin>", hint, LONGEST_DRAWING)?;
    Ok(bytes)
}

/// Refuses what could not be read, or is too long.
fn checked_bytes(read: io::Result<usize>, name: &str, hint: &str, most: u64) -> Result<(), Failure> {
    match read {
        Err(error) => Err(Failure::input(format_args!("cannot read {name}: {error}"), hint)),
        Ok(length) if length as u64 > most => {
            Err(Failure::input(format_args!("{name} is longer than {} MiB", most >> 20), hint))
        }
        Ok(_) => Ok(()),
    }
}

/// Read an engine file; `-` is standard input.
pub fn read_source(path: &Path) -> Result<Source, Failure> {
    let mut bytes = Vec::new();
    let name = if path == Path::new("-") { "<stdin>".to_string() } else { shown(path) };
    let outcome = if path == Path::new("-") {
        io::stdin().lock().take(LONGEST_INPUT + 1).read_to_end(&mut bytes)
    } else {
        File::open(path).and_then(|file| file.take(LONGEST_INPUT + 1).read_to_end(&mut bytes))
    };
    if let Err(error) = outcome {
        let hint = match error.kind() {
            io::ErrorKind::NotFound => "`lanchester new --list` shows layouts to start from",
            _ => "give the path of an engine file, or - for standard input",
        };
        return Err(Failure::input(format_args!("cannot read {name}: {error}"), hint));
    }
    if bytes.len() as u64 > LONGEST_INPUT {
        return Err(Failure::input(
            format_args!("{name} is longer than {} MiB", LONGEST_INPUT >> 20),
            "an engine file is a short TOML text: is this the right file?",
        ));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        Failure::input(
            format_args!("{name} is not UTF-8 text (byte {})", error.utf8_error().valid_up_to()),
            "save the engine file as UTF-8",
        )
    })?;
    Ok(Source { name, text })
}

/// Write `text` to standard output. A closed pipe (`| head`) is no fault.
pub fn print(text: &str) -> Result<(), Failure> {
    to_stdout(text.as_bytes())
}

/// Write a result that is no text to standard output, which must be no terminal.
pub fn print_bytes(bytes: &[u8]) -> Result<(), Failure> {
    if io::stdout().is_terminal() {
        return Err(Failure::input(
            "this is no text for a terminal",
            "redirect it into a file, such as `> run.parquet`",
        ));
    }
    to_stdout(bytes)
}

fn to_stdout(bytes: &[u8]) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(bytes).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::input(format_args!("cannot write to standard output: {error}"), "is the disk full?"))
        }
        _ => Ok(()),
    }
}

/// Say something on standard error. What it quotes, of an engine file for example, acts on no terminal.
pub fn tell(words: impl Display) {
    let words = words.to_string();
    let lines: Vec<String> = words.split('\n').map(shown).collect();
    eprintln!("{}", lines.join("\n"));
}

/// Write a result, making its folder; an earlier result is written over, an engine file never.
pub fn write_result(
    path: &Path,
    engine_file: &Path,
    content: &(impl AsRef<[u8]> + ?Sized),
) -> Result<(), Failure> {
    let same =
        fs::canonicalize(path).is_ok_and(|path| fs::canonicalize(engine_file).is_ok_and(|file| file == path));
    if same || path.extension().is_some_and(|extension| extension == "toml") {
        return Err(Failure::input(
            format_args!("{} looks like an engine file and is not overwritten", shown(path)),
            "choose another name for the result",
        ));
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let outcome = folder.map_or(Ok(()), fs::create_dir_all).map_err(PutError::from).and_then(|()| {
        // A pipe or a device takes what comes.
        if fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
            return Ok(fs::write(path, content)?);
        }
        put(path, Over::Anything, content.as_ref())
    });
    outcome.map_err(|error| {
        Failure::input(format_args!("cannot write {}: {error}", shown(path)), "choose another place")
    })
}

/// Refuses a file that exists; a pipe or a device takes what comes.
pub fn not_there(path: &Path) -> Result<(), Failure> {
    match fs::metadata(path) {
        Ok(there) if there.is_file() => Err(Failure::input(
            format_args!("{} exists and is not overwritten", shown(path)),
            "choose another name with --output, or remove it first",
        )),
        _ => Ok(()),
    }
}

/// Write a file that does not exist yet: a user's file is never overwritten.
pub fn write_new(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Failure> {
    put(path, Over::Nothing, content.as_ref()).map_err(|error| match error {
        PutError::Exists => Failure::input(
            format_args!("{} exists and is not overwritten", shown(path)),
            "choose another name with --output, or remove it first",
        ),
        _ => Failure::input(
            format_args!("cannot write {}: {error}", shown(path)),
            "choose another place with --output",
        ),
    })
}

/// Write a file that is the program's own: made where there is none, made anew where it holds `mark`, else left alone. Whether it is there
/// as it should be.
pub fn write_own(path: &Path, mark: &str, content: &str) -> Result<bool, Failure> {
    let held = fs::read_to_string(path);
    let over = match &held {
        Ok(held) if held == content => return Ok(true),
        Ok(held) if held.contains(mark) => Over::Anything,
        Err(error) if error.kind() == io::ErrorKind::NotFound => Over::Nothing,
        _ => return Ok(false),
    };
    put(path, over, content.as_bytes()).map(|()| true).map_err(|error| {
        Failure::input(
            format_args!("cannot write {}: {error}", shown(path)),
            "choose another place with --output",
        )
    })
}

/// Put `text` in the place of an engine file that still reads `before`: whole or not at all, links, owner and permissions
/// kept.
pub fn rewrite(path: &Path, before: &str, text: &str) -> Result<(), Failure> {
    let name = shown(path);
    put(path, Over::Text(before.as_bytes()), text.as_bytes()).map_err(|error| match error {
        PutError::Changed => Failure::input(
            format_args!("{name} has changed since it was read, and is left alone"),
            "save it elsewhere or run the command again",
        ),
        PutError::Removed => Failure::input(
            format_args!("{name} has been removed since it was read"),
            "run the command again with a file that exists",
        ),
        PutError::ReadOnly => {
            Failure::input(format_args!("{name} may not be written to"), "change its permissions")
        }
        _ => Failure::input(
            format_args!("cannot write {name}: {error}"),
            "the file is as it was; --dry-run shows the change",
        ),
    })
}

fn put(path: &Path, over: Over, content: &[u8]) -> Result<(), PutError> {
    let file = NewFile::beside(path, over)?;
    file.file().write_all(content)?;
    file.put()
}
