//! The known word that a misspelled one was meant to be.

/// The candidate with the fewest edits from `word`, if that is few enough to be a slip.
pub fn nearest<'a>(word: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    // Beyond this length no slip is near a key or unit, and the distance would be costly.
    if word.chars().count() > 40 {
        return None;
    }
    let word = simplified(word);
    candidates
        .map(|candidate| (distance(&word, &simplified(candidate)), candidate))
        .filter(|(distance, candidate)| {
            *distance <= candidate.chars().count().max(word.len()) / 3 || (*distance == 1 && word.len() == 2)
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// Lower case, `-` and blanks as `_`: differences that count as no edit.
fn simplified(word: &str) -> Vec<char> {
    word.to_lowercase().chars().map(|c| if c == '-' || c == ' ' { '_' } else { c }).collect()
}

/// Edits between two words: insertions, deletions, replacements and swaps of neighbours (optimal string alignment).
fn distance(a: &[char], b: &[char]) -> usize {
    let mut before: Vec<usize> = vec![0; b.len() + 1];
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let replaced = last[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            row[j] = replaced.min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        before = std::mem::replace(&mut last, row);
    }
    last[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_found_and_strangers_are_not() {
        let keys = ["length", "mass", "big_end_mass", "small_end_mass", "inertia"];
        let near = |word| nearest(word, keys.into_iter());
        assert_eq!(near("lenght"), Some("length"));
        assert_eq!(near("big-end-mass"), Some("big_end_mass"));
        assert_eq!(near("smal_end_mas"), Some("small_end_mass"));
        assert_eq!(near("Mass"), Some("mass"));
        assert_eq!(near("colour"), None);
        assert_eq!(near(&"x".repeat(100_000)), None);
    }
}
