//! The writer: what another program writes meanwhile is kept, what fails leaves nothing behind.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_files::{NewFile, Over, PutError};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// A folder of its own for one test.
fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn begun<'a>(path: &Path, over: Over<'a>, text: &str) -> Result<NewFile<'a>, PutError> {
    let file = NewFile::beside(path, over)?;
    file.file().write_all(text.as_bytes())?;
    Ok(file)
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap().flatten();
    let mut names: Vec<String> = entries.map(|entry| entry.file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn an_editor_that_writes_meanwhile_keeps_its_version() {
    let folder = folder("files-editor");
    let file = folder.join("engine.toml");
    let in_place = || fs::write(&file, "editor").unwrap();
    let by_rename = || {
        fs::write(folder.join("other"), "editor").unwrap();
        fs::rename(folder.join("other"), &file).unwrap();
    };
    let saves: [&dyn Fn(); 2] = [&in_place, &by_rename];
    for save in saves {
        fs::write(&file, "one").unwrap();
        // Before it is begun, and after it is written.
        save();
        assert!(matches!(begun(&file, Over::Text(b"one"), "two"), Err(PutError::Changed)));
        fs::write(&file, "one").unwrap();
        let new = begun(&file, Over::Text(b"one"), "two").unwrap();
        save();
        assert!(matches!(new.put(), Err(PutError::Changed)));
        assert_eq!(fs::read_to_string(&file).unwrap(), "editor");
        assert_eq!(names(&folder), ["engine.toml"]);
    }
    fs::write(&file, "one").unwrap();
    let new = begun(&file, Over::Text(b"one"), "two").unwrap();
    fs::remove_file(&file).unwrap();
    assert!(matches!(new.put(), Err(PutError::Removed)));
    assert_eq!(names(&folder), Vec::<String>::new());
    let new = begun(&file, Over::Nothing, "two").unwrap();
    in_place();
    assert!(matches!(new.put(), Err(PutError::Exists)));
    assert_eq!(fs::read_to_string(&file).unwrap(), "editor");
    assert_eq!(names(&folder), ["engine.toml"]);
}

/// No moment is left in which a save of an editor is lost: whatever the order, its text stands in the end.
#[cfg(target_os = "linux")]
#[test]
fn a_save_at_any_moment_is_kept() {
    let folder = folder("files-race");
    let file = folder.join("engine.toml");
    let (mut kept, mut written) = (0, 0);
    for round in 0..400_u32 {
        fs::write(&file, "before").unwrap();
        let theirs = format!("editor {round}");
        fs::write(folder.join("editor"), &theirs).unwrap();
        let new = begun(&file, Over::Text(b"before"), "ours").unwrap();
        let put = std::thread::scope(|scope| {
            let editor = scope.spawn(|| {
                for _ in 0..round * 40 {
                    std::hint::spin_loop();
                }
                fs::rename(folder.join("editor"), &file).unwrap();
            });
            let put = new.put();
            editor.join().unwrap();
            put
        });
        assert_eq!(fs::read_to_string(&file).unwrap(), theirs, "round {round}: {put:?}");
        assert_eq!(names(&folder), ["engine.toml"], "round {round}: {put:?}");
        match put {
            Ok(()) => written += 1,
            Err(PutError::Changed) => kept += 1,
            Err(error) => panic!("round {round}: {error}"),
        }
    }
    assert_eq!(kept + written, 400);
}

#[test]
fn what_is_not_put_in_place_is_removed() {
    let folder = folder("files-dropped");
    let file = folder.join("engine.toml");
    drop(begun(&file, Over::Nothing, "half").unwrap());
    assert_eq!(names(&folder), Vec::<String>::new());
    begun(&file, Over::Nothing, "one").unwrap().put().unwrap();
    assert!(matches!(NewFile::beside(&file, Over::Nothing), Err(PutError::Exists)));
    drop(begun(&file, Over::Anything, "half").unwrap());
    assert_eq!((names(&folder), fs::read(&file).unwrap()), (vec!["engine.toml".into()], b"one".to_vec()));
    // Two at a time do not collide.
    let (a, b) = (begun(&file, Over::Anything, "a").unwrap(), begun(&file, Over::Anything, "b").unwrap());
    a.put().unwrap();
    b.put().unwrap();
    assert_eq!((names(&folder), fs::read(&file).unwrap()), (vec!["engine.toml".into()], b"b".to_vec()));
    // A folder is no file, nor is there one below a file.
    assert!(matches!(NewFile::beside(&folder, Over::Anything), Err(PutError::NotAFile)));
    assert!(NewFile::beside(&file.join("x.toml"), Over::Nothing).is_err());
    assert!(matches!(NewFile::beside(&folder.join("no.toml"), Over::Text(b"")), Err(PutError::Removed)));
}

#[cfg(unix)]
#[test]
fn permissions_owner_and_links_stay() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, chown, symlink};
    let folder = folder("files-modes");
    let (file, link) = (folder.join("engine.toml"), folder.join("link.toml"));
    fs::write(&file, "one").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    symlink("engine.toml", &link).unwrap();
    // Only root can give a file to somebody else.
    let given = chown(&file, Some(12_345), Some(23_456)).is_ok();
    for (over, text) in [(Over::Text(b"one"), "two"), (Over::Anything, "three")] {
        begun(&link, over, text).unwrap().put().unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        let now = fs::metadata(&file).unwrap();
        assert_eq!(now.mode() & 0o7777, 0o640);
        assert!(!given || (now.uid(), now.gid()) == (12_345, 23_456));
        assert_eq!(fs::read_to_string(&file).unwrap(), text);
    }
    // Nobody else reads a secret while it is written.
    let new = begun(&file, Over::Anything, "four").unwrap();
    assert_eq!(new.file().metadata().unwrap().mode() & 0o077, 0);
    drop(new);
    fs::set_permissions(&file, fs::Permissions::from_mode(0o440)).unwrap();
    assert!(matches!(NewFile::beside(&file, Over::Anything), Err(PutError::ReadOnly)));
    assert!(matches!(NewFile::beside(&link, Over::Text(b"three")), Err(PutError::ReadOnly)));
    assert_eq!(names(&folder), ["engine.toml", "link.toml"]);
}

/// A folder that takes no file: said, and nothing changed.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_takes_no_file_is_an_error() {
    let refused = NewFile::beside(Path::new("/proc/lanchester.toml"), Over::Nothing);
    assert!(matches!(refused, Err(PutError::System(_))), "{refused:?}");
}
