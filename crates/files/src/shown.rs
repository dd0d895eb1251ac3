//! Names as a terminal may show them.

use std::path::Path;

/// A path with its control characters, and those that reverse the direction of text, written out: `\u{1b}`. A name may hold sequences
/// that colour, move or erase what a terminal shows.
pub fn shown(path: impl AsRef<Path>) -> String {
    let mut clean = String::new();
    for letter in path.as_ref().to_string_lossy().chars() {
        match letter {
            _ if letter.is_control() => clean.extend(letter.escape_unicode()),
            '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => {
                clean.extend(letter.escape_unicode());
            }
            _ => clean.push(letter),
        }
    }
    clean
}

#[cfg(test)]
mod tests {
    use super::shown;

    #[test]
    fn nothing_that_acts_on_a_terminal_is_left() {
        assert_eq!(shown("engines/Zweizylinder ü.toml"), "engines/Zweizylinder ü.toml");
        assert_eq!(shown("\u{1b}[31mred\u{7}\n.toml"), "\\u{1b}[31mred\\u{7}\\u{a}.toml");
        assert_eq!(shown("\u{9b}2J\u{7f}"), "\\u{9b}2J\\u{7f}");
        assert_eq!(shown("lmot\u{202e}.exe"), "lmot\\u{202e}.exe");
        for letter in (0..0x20).chain(0x7f..0xa0).filter_map(char::from_u32) {
            assert!(!shown(format!("a{letter}b")).contains(letter));
        }
    }
}
