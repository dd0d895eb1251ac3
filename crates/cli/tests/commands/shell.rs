//! What shells and `man` are given.

use crate::program::{folder, message, output};
use std::process::Command;

#[test]
fn every_command_has_a_manual_page_with_its_options() {
    let folder = folder("manual");
    let list = output(&folder, 0, &["manual", "--list"]);
    for name in ["lanchester", "lanchester loads", "lanchester counterweight design", "lanchester manual"] {
        assert!(list.lines().any(|line| line == name), "{name}: {list}");
    }
    for name in list.lines() {
        let words: Vec<&str> = name.split(' ').skip(1).collect();
        let page = output(&folder, 0, &[&["manual"], &words[..]].concat());
        let title = format!(".TH {} 1 ", name.to_uppercase().replace(' ', "-"));
        assert!(page.lines().any(|line| line.starts_with(&title)), "{name}: {page}");
        // Options as the help tells them, without what roff writes in its own way.
        let plain = page.replace("\\-", "-");
        let help = output(&folder, 0, &[&words[..], &["--help"]].concat());
        let options = help.lines().filter_map(|line| line.trim_start().strip_prefix("--"));
        for option in options.filter_map(|line| line.split([' ', '=', '[']).next()) {
            assert!(plain.contains(&format!("--{option}")), "{name} --{option}");
        }
    }
    let refused = message(&folder, 2, &["manual", "counterweight", "grow"]);
    assert!(refused.contains("`lanchester counterweight` has no command `grow`"), "{refused}");
    assert!(refused.contains("hint: `lanchester manual --list`"), "{refused}");
}

#[test]
fn bash_completes_commands_options_and_values() {
    let folder = folder("completions");
    std::fs::write(folder.join("lanchester.bash"), output(&folder, 0, &["completions", "bash"])).unwrap();
    let completed = |words: &str, place: usize, word: &str| {
        let line = format!(
            "source ./lanchester.bash; COMP_WORDS=({words}); COMP_CWORD={place}; _lanchester lanchester '{word}' ''; \
             echo \"${{COMPREPLY[@]}}\""
        );
        let bash = Command::new("bash").args(["--norc", "-c", &line]).current_dir(&folder).output().unwrap();
        String::from_utf8(bash.stdout).unwrap().trim().to_owned()
    };
    assert_eq!(completed("lanchester tors", 1, "tors"), "torsion");
    assert_eq!(completed("lanchester counterweight des", 2, "des"), "design");
    assert_eq!(completed("lanchester loads --bend", 2, "--bend"), "--bending-share");
    for shell in ["zsh", "fish", "powershell", "elvish"] {
        let script = output(&folder, 0, &["completions", shell]);
        assert!(script.contains("bending-share"), "{shell}");
    }
    assert!(message(&folder, 2, &["completions", "cmd"]).contains("[possible values: bash"));
}
