//! Files that the program writes: whole or not there, an editor's version kept, names that act on no terminal.

use crate::program::{example, folder, lanchester, message, output, twin};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::atomic::{AtomicBool, Ordering};

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap().flatten();
    let mut names: Vec<String> = entries.map(|entry| entry.file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// A run that can write no byte into any file, as on a full disk.
#[cfg(target_os = "linux")]
fn on_a_full_disk(folder: &Path, arguments: &[&str]) -> Output {
    Command::new("sh")
        .args(["-c", "trap '' XFSZ; ulimit -f 0; exec \"$0\" \"$@\"", env!("CARGO_BIN_EXE_lanchester")])
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap()
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_leaves_no_piece_of_a_file() {
    let folder = folder("files-full");
    let before = fs::read_to_string(twin()).unwrap();
    fs::write(folder.join("twin.toml"), &before).unwrap();
    for arguments in [
        &["new", "in-line-4", "--output", "four.toml"][..],
        &["report", "twin.toml", "--output", "twin.html"],
        &["show", "twin.toml", "--drawing", "twin.svg"],
        &["balance", "twin.toml", "--write"],
    ] {
        let full = on_a_full_disk(&folder, arguments);
        let told = String::from_utf8_lossy(&full.stderr).into_owned();
        assert_eq!(full.status.code(), Some(2), "{arguments:?} {full:?}");
        assert!(told.contains("cannot write") && told.contains("hint: "), "{told}");
        assert_eq!(names(&folder), ["twin.toml"], "{arguments:?}");
        assert_eq!(fs::read_to_string(folder.join("twin.toml")).unwrap(), before);
    }
    // An earlier result stays, too.
    fs::write(folder.join("twin.html"), "earlier").unwrap();
    on_a_full_disk(&folder, &["report", "twin.toml", "--output", "twin.html"]);
    assert_eq!(fs::read_to_string(folder.join("twin.html")).unwrap(), "earlier");
    // There is room again: nothing that failed is in the way.
    output(&folder, 0, &["new", "in-line-4", "--output", "four.toml"]);
    output(&folder, 0, &["report", "twin.toml", "--output", "twin.html"]);
}

/// An editor that saves as soon as the new text is being written beside the file: its version stands in the end.
#[cfg(target_os = "linux")]
#[test]
fn an_editor_that_saves_while_weights_are_written_loses_nothing() {
    let folder = folder("files-window");
    let before = fs::read_to_string(twin()).unwrap();
    let file = folder.join("twin.toml");
    let mut met = 0;
    for round in 0..12 {
        fs::write(&file, &before).unwrap();
        let over = AtomicBool::new(false);
        let saved = std::thread::scope(|scope| {
            let editor = scope.spawn(|| {
                while !over.load(Ordering::Relaxed) {
                    if names(&folder).len() > 1 {
                        fs::write(&file, "# edited\n").unwrap();
                        return true;
                    }
                }
                false
            });
            lanchester(&folder, &["balance", "twin.toml", "--write"]);
            over.store(true, Ordering::Relaxed);
            editor.join().unwrap()
        });
        if saved {
            met += 1;
            assert_eq!(fs::read_to_string(&file).unwrap(), "# edited\n", "round {round}");
        }
        // Nothing is left beside it but what two programs at the very same moment leave.
        assert!(names(&folder).iter().all(|name| name == "twin.toml" || name.ends_with(".new")));
        names(&folder).iter().filter(|name| name.ends_with(".new")).for_each(|name| {
            fs::remove_file(folder.join(name)).unwrap();
        });
    }
    assert!(met > 0, "the editor never met the window");
}

#[cfg(unix)]
#[test]
fn weights_are_written_through_a_link_with_permissions_kept() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = folder("files-link");
    let (file, link) = (folder.join("real.toml"), folder.join("link.toml"));
    fs::copy(twin(), &file).unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o600)).unwrap();
    symlink("real.toml", &link).unwrap();
    output(&folder, 0, &["balance", "link.toml", "--write"]);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o600);
    assert_ne!(fs::read(&file).unwrap(), fs::read(twin()).unwrap());
    assert_eq!(names(&folder), ["link.toml", "real.toml"]);
    fs::set_permissions(&file, fs::Permissions::from_mode(0o400)).unwrap();
    fs::copy(twin(), folder.join("copy.toml")).unwrap();
    fs::set_permissions(folder.join("copy.toml"), fs::Permissions::from_mode(0o400)).unwrap();
    assert!(message_of(&folder, &["balance", "copy.toml", "--write"]).contains("may not be written to"));
}

fn message_of(folder: &Path, arguments: &[&str]) -> String {
    let run = lanchester(folder, arguments);
    assert_eq!(run.status.code(), Some(2), "{run:?}");
    String::from_utf8(run.stderr).unwrap()
}

/// Nothing that a name holds colours, moves or erases what a terminal shows.
#[cfg(unix)]
#[test]
fn names_of_files_act_on_no_terminal() {
    let folder = folder("files-names");
    let evil = "\u{1b}[2J\u{1b}]0;title\u{7}a.toml";
    let missing = message(&folder, 2, &["loads", evil]);
    assert!(missing.contains("\\u{1b}[2J"), "{missing}");
    fs::write(folder.join(evil), "name = 3\n").unwrap();
    let text = fs::read_to_string(example("in-line-4-production")).unwrap();
    fs::write(folder.join("good\u{9b}31m.toml"), text).unwrap();
    let gas = "\n[gas]\n[[gas.trace]]\nfile = \"\\u001b[31mred.csv\"\nspeed = \"1000 rpm\"\n";
    fs::write(folder.join("gas.toml"), fs::read_to_string(twin()).unwrap() + gas).unwrap();
    let sheet = format!("{evil}.csv");
    for arguments in [
        &["check", evil][..],
        &["check", evil, "--format", "csv"],
        &["loads", evil],
        &["check", "good\u{9b}31m.toml"],
        &["new", "in-line-4", "--output", evil],
        &["explore", "good\u{9b}31m.toml", "--save", evil],
        &["merge", evil, "--output", &sheet],
        &["check", "gas.toml"],
        &["torque", "gas.toml"],
        &["counterweight", "export", evil, "--output", evil],
        &["studio", &sheet, "--no-open"],
    ] {
        let run = lanchester(&folder, arguments);
        let acts = |letter: &char| letter.is_control() && !matches!(letter, '\n' | '\r');
        for said in [run.stdout, run.stderr] {
            let said = String::from_utf8(said).unwrap();
            assert!(!said.chars().any(|letter| acts(&letter)), "{arguments:?}: {said:?}");
        }
    }
}
