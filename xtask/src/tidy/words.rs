//! Words that engineers do not use, where they have one of their own: in code, page and book alike.

use crate::workspace;
use anyhow::Result;

/// What is not said, in small letters, and what the field says.
const WORDS: [(&str, &str); 27] = [
    ("a way to mend", "a suggested fix"),
    ("our own fault", "internal error"),
    ("that nothing beats", "Pareto-optimal"),
    ("are no engine:", "invalid geometry"),
    ("both ways round", "forward and backward"),
    ("speed ripple", "cyclic speed fluctuation"),
    ("was broken off", "was cancelled, or stopped before its end"),
    ("coupling left", "residual coupling"),
    ("energy that swings", "energy fluctuation"),
    ("what the mounts pass on", "transmitted forces"),
    ("beyond any engine", "outside the accepted range"),
    ("within reason", "outside the accepted range"),
    ("stands twice", "duplicate"),
    ("the engine stands, but", "accepted, but"),
    ("comes near anything", "no pairs within range"),
    ("a stretch to find", "a range to be optimised over"),
    ("longer half axis", "semi-major axis"),
    ("turn of the counterweights", "counterweight offset angle"),
    ("passes force", "force transmissibility"),
    ("held up at", "active at"),
    ("boxes of choices", "branch-and-bound nodes"),
    ("it would do to change", "relaxing any one of these is sufficient"),
    ("natural motions of the block", "rigid-body modes"),
    ("what the firings excite", "firing excitation by order"),
    ("the first first,", "in order of priority"),
    ("seen from another side", "equivalent by symmetry"),
    ("giving up any", "without degrading the previous ones"),
];

/// Where words are those of the past or of others: changes, decisions, this list.
const APART: [&str; 3] = ["CHANGELOG.md", "docs/decisions/", "xtask/src/tidy/words.rs"];

/// Every place where a word of the list stands.
pub fn check(files: &[String]) -> Result<Vec<String>> {
    let mut breaches = Vec::new();
    for file in files.iter().filter(|file| is_ours(file)) {
        let Some(text) = workspace::text(file)? else { continue };
        breaches.extend(found(&text).map(|(line, words, standard)| {
            format!("{file}:{line}: \"{words}\": the field says \"{standard}\"")
        }));
    }
    Ok(breaches)
}

fn is_ours(file: &str) -> bool {
    let ending = file.rsplit('.').next().unwrap_or_default();
    ["rs", "ts", "svelte", "md", "py", "html"].contains(&ending)
        && !APART.iter().any(|apart| file.starts_with(apart))
}

/// Line, from 1, with what stands there and what the field says.
fn found(text: &str) -> impl Iterator<Item = (usize, &'static str, &'static str)> {
    text.lines().enumerate().flat_map(|(line, text)| {
        let text = text.to_lowercase();
        let hits = WORDS.into_iter().filter(move |(words, _)| text.contains(words));
        hits.map(move |(words, standard)| (line + 1, words, standard))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_found_with_its_line_and_what_the_field_says() {
        let text = "Cyclic speed fluctuation.\nThe Speed ripple of the engine, both ways round";
        let hits: Vec<_> = found(text).collect();
        assert_eq!(
            hits,
            [(2, "both ways round", "forward and backward"), (2, "speed ripple", "cyclic speed fluctuation")]
        );
        assert!(!is_ours("CHANGELOG.md") && !is_ours("docs/decisions/0001-x.md") && is_ours("docs/src/a.md"));
    }
}
