//! What a change would do to a file, for a look before it is written.

use similar::TextDiff;

/// A unified difference of two texts, three lines around every change; empty if they are the same.
///
/// `file_name` is what their author calls the file.
pub fn difference(before: &str, after: &str, file_name: &str) -> String {
    if before == after {
        return String::new();
    }
    TextDiff::from_lines(before, after)
        .unified_diff()
        .context_radius(3)
        .header(file_name, &format!("{file_name} (balanced)"))
        .to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_changes_is_shown() {
        assert_eq!(difference("a\n", "a\n", "e.toml"), "");
        let before = "1\n2\n3\n4\n5\n6\n7\n8\n";
        let after = before.replace('6', "six");
        assert_eq!(
            difference(before, &after, "e.toml"),
            "--- e.toml\n+++ e.toml (balanced)\n@@ -3,6 +3,6 @@\n 3\n 4\n 5\n-6\n+six\n 7\n 8\n"
        );
    }
}
