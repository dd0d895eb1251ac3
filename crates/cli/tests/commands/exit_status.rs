//! The help names every cause of exit status 1 that commands give.

use crate::program::{example, folder, message, output};

/// Causes as the help of the program words them, each with commands that give status 1 for it.
#[test]
fn the_help_names_the_causes_of_status_1() {
    let folder = folder("exit-status");
    let help = output(&folder, 0, &["--help"]).split_whitespace().collect::<Vec<_>>().join(" ");
    let (three, four) = (example("in-line-3"), example("in-line-4"));
    let production = example("in-line-4-production");
    let causes: [(&str, &[&str]); 4] = [
        (
            "a limit is not met",
            &["scatter", &production, "--limit", "force order 1 = 1 N", "--samples", "100"],
        ),
        ("or cannot be met", &["balance", &three, "--limit", "couple = 0.001 N m"]),
        ("an order cannot vanish", &["balance", &three, "--cancel", "couple order 4"]),
        (
            "nothing was left to judge",
            &["explore", &four, "--throw-angles", "every 120 deg", "--even-firing"],
        ),
    ];
    for (cause, command) in causes {
        assert!(help.contains(cause), "{cause}: {help}");
        output(&folder, 1, command);
    }
    // A run that is stopped ends with status 1 too: see `runs.rs`.
    assert!(help.contains("a search or a run was stopped before its end"));
    assert!(help.contains("a verdict of `validate` is not the expected one"));
}

#[test]
fn a_path_that_does_not_exist_is_named_whole() {
    let folder = folder("studio-no-path");
    let told = message(&folder, 2, &["studio", "/no-such-engine", "--no-open"]);
    assert!(told.contains("there is no file or folder /no-such-engine"), "{told}");
    assert!(!told.contains("the folder is /"), "{told}");
}
