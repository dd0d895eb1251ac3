//! Rule on folders: what stands side by side can be seen at one glance.

use super::known::FOLDERS;
use std::collections::BTreeMap;

/// Most source files side by side in one folder.
const MOST: usize = 25;
/// What is written by hand and read by a compiler.
const SOURCES: [&str; 4] = [".rs", ".ts", ".js", ".svelte"];
/// What is built from other sources.
const BUILT: &str = "crates/studio/dist/";

/// Folders that hold too many files, and exceptions that are needed no more.
pub fn check(files: &[String]) -> Vec<String> {
    check_with(files, &FOLDERS)
}

fn check_with(files: &[String], known: &[(&str, usize)]) -> Vec<String> {
    let mut folders: BTreeMap<&str, usize> = BTreeMap::new();
    let sources = files.iter().filter(|file| SOURCES.iter().any(|ending| file.ends_with(ending)));
    for file in sources.filter(|file| !file.starts_with(BUILT)) {
        let folder = file.rsplit_once('/').map_or("", |(folder, _)| folder);
        *folders.entry(folder).or_default() += 1;
    }
    let mut breaches = Vec::new();
    for (folder, &count) in &folders {
        let most = known.iter().find(|(name, _)| name == folder).map_or(MOST, |(_, count)| *count);
        if count > most {
            breaches.push(format!(
                "{folder}: {count} source files side by side, more than {most}: put those of one noun into a folder"
            ));
        }
    }
    for (folder, _) in known {
        let count = folders.get(folder).copied().unwrap_or_default();
        if count <= MOST {
            breaches.push(format!(
                "{folder}: {count} source files side by side need no exception; take its line out of xtask/src/tidy/known.rs"
            ));
        }
    }
    breaches
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files(folder: &str, count: usize) -> Vec<String> {
        (0..count).map(|k| format!("{folder}/f{k}.rs")).collect()
    }

    #[test]
    fn more_files_than_can_be_seen_at_a_glance_are_a_breach() {
        assert!(check_with(&files("crates/a/src", MOST), &[]).is_empty());
        let breaches = check_with(&files("crates/a/src", MOST + 1), &[]);
        assert_eq!(
            breaches,
            ["crates/a/src: 26 source files side by side, more than 25: put those of one noun into a folder"]
        );
        // Files below are another folder's; what is built and what is no source do not count.
        let mut apart = files("crates/a/src", MOST);
        apart.extend(files("crates/a/src/b", 1));
        apart.push("crates/a/src/notes.md".to_owned());
        apart.extend(files("crates/studio/dist/assets", 0));
        apart.extend((0..40).map(|k| format!("crates/studio/dist/assets/f{k}.js")));
        assert!(check_with(&apart, &[]).is_empty());
    }

    #[test]
    fn an_exception_holds_to_its_number_and_goes_when_it_is_not_needed() {
        let known = [("crates/a/src", 30)];
        assert!(check_with(&files("crates/a/src", 30), &known).is_empty());
        assert!(check_with(&files("crates/a/src", 28), &known).is_empty());
        assert_eq!(check_with(&files("crates/a/src", 31), &known).len(), 1);
        let breaches = check_with(&files("crates/a/src", MOST), &known);
        assert!(breaches.len() == 1 && breaches[0].contains("need no exception"), "{breaches:?}");
        assert_eq!(check_with(&[], &known).len(), 1);
    }
}
