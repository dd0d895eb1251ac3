//! Changes of a text: what is not changed stays as it is, byte for byte.

use std::ops::Range;

/// Changes of one text.
pub(super) struct Splices<'t> {
    pub(super) text: &'t str,
    /// What ends a line of this text.
    pub(super) line_end: &'static str,
    changes: Vec<(Range<usize>, String)>,
}

impl<'t> Splices<'t> {
    pub(super) fn new(text: &'t str) -> Splices<'t> {
        let first_line = text.split_inclusive('\n').next().unwrap_or("");
        let line_end = if first_line.ends_with("\r\n") { "\r\n" } else { "\n" };
        Splices { text, line_end, changes: Vec::new() }
    }

    pub(super) fn replace(&mut self, range: Range<usize>, new: impl Into<String>) {
        self.changes.push((range, new.into()));
    }

    pub(super) fn insert(&mut self, at: usize, new: impl Into<String>) {
        self.replace(at..at, new);
    }

    /// A block of lines of its own at the end of the file.
    pub(super) fn append_block(&mut self, block: &str) {
        let (end, line_end) = (self.text.trim_end().len(), self.line_end);
        let parted = if self.text[..end].trim_start_matches('\u{feff}').is_empty() { "" } else { "\n\n" };
        let tail = if end == self.text.len() { "\n" } else { "" };
        let [parted, tail] = [parted, tail].map(|ends| ends.replace('\n', line_end));
        self.insert(end, format!("{parted}{block}{tail}"));
    }

    /// The changed text. Insertions at one place keep their order; one inside a replaced piece goes behind what replaces
    /// it, before the line ends that the piece has left there.
    pub(super) fn apply(mut self) -> String {
        self.changes.sort_by_key(|(range, _)| range.start);
        let mut out = String::with_capacity(self.text.len());
        let mut done = 0;
        for (range, new) in &self.changes {
            debug_assert!(range.start >= done || range.is_empty(), "two changes of one piece");
            if range.start > done {
                out.push_str(&self.text[done..range.start]);
            }
            out.push_str(new);
            let is_tail = range.is_empty() && range.start < done;
            if is_tail && self.text[range.start..done].trim().is_empty() {
                done = range.start;
            }
            done = done.max(range.end);
        }
        out.push_str(&self.text[done..]);
        out
    }

    /// Where the line of `at` begins.
    pub(super) fn line_start(&self, at: usize) -> usize {
        let bom = if self.text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        self.text[..at].rfind('\n').map_or(bom, |newline| newline + 1)
    }

    /// Where the line of `at` ends, before its line end.
    pub(super) fn line_stop(&self, at: usize) -> usize {
        let rest = &self.text[at..];
        let line = &rest[..rest.find('\n').unwrap_or(rest.len())];
        at + line.trim_end_matches('\r').len()
    }

    /// Where the next line begins.
    pub(super) fn next_line(&self, at: usize) -> usize {
        self.text[at..].find('\n').map_or(self.text.len(), |newline| at + newline + 1)
    }

    /// Blanks at the beginning of the line of `at`.
    pub(super) fn indentation(&self, at: usize) -> &'t str {
        let start = self.line_start(at);
        let line = &self.text[start..self.line_stop(start)];
        &line[..line.len() - line.trim_start().len()]
    }

    /// Takes a block out for others to stand there: its comments stay, in lines of their own. Gives the place of the
    /// others.
    pub(super) fn make_way(&mut self, range: Range<usize>) -> usize {
        let stop = self.line_stop(range.end);
        let kept = comments(&self.text[range.start..stop]);
        let text: String =
            kept.iter().map(|comment| format!("{}{}", comment.trim_end(), self.line_end)).collect();
        self.replace(range.start..stop, text);
        stop
    }

    /// Removes whole keys, elements or blocks; their comments stay, each in a line of its own. Lines that hold nothing
    /// else go with them.
    pub(super) fn remove(&mut self, range: Range<usize>) {
        let start = self.line_start(range.start);
        let stop = self.line_stop(range.end);
        let before = &self.text[start..range.start];
        let behind = self.text[range.end..stop].trim_start();
        let takes_lines = before.trim().is_empty() && (behind.is_empty() || behind.starts_with('#'));
        let kept: Vec<&str> = comments(&self.text[range.clone()]);
        if !takes_lines {
            // Comments run to the end of a line: behind the last of them the rest needs a line of its own.
            let text: String = kept.iter().map(|comment| format!("{comment}{}", self.line_end)).collect();
            self.replace(range, text);
            return;
        }
        let kept: Vec<&str> =
            kept.into_iter().chain((!behind.is_empty()).then_some(behind)).map(str::trim_end).collect();
        if kept.is_empty() {
            let mut end = self.next_line(range.end);
            // The empty line that parted it from the next goes too, if there is another one before.
            let above = &self.text[..start];
            let is_parted = above.ends_with("\n\n") || above.ends_with("\n\r\n") || above.is_empty();
            if is_parted && self.text[end..self.line_stop(end)].trim().is_empty() {
                end = self.next_line(end);
            }
            self.replace(start..end, "");
        } else {
            let indentation = before.to_string();
            let text = kept.join(&format!("{}{indentation}", self.line_end));
            self.replace(range.start..stop, text);
        }
    }
}

/// The comments of a piece of TOML that begins outside a text.
fn comments(piece: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = piece;
    while let Some(at) = rest.find(['#', '"', '\'']) {
        rest = &rest[at..];
        if rest.starts_with('#') {
            let end = rest.find('\n').unwrap_or(rest.len());
            found.push(rest[..end].trim_end_matches('\r'));
            rest = &rest[end..];
        } else {
            rest = &rest[text_length(rest)..];
        }
    }
    found
}

/// Bytes of the text, in its quotes, at the start of the piece.
fn text_length(piece: &str) -> usize {
    let quote = &piece[..1];
    let triple = quote.repeat(3);
    let (open, close) = if piece.starts_with(&triple) { (3, triple.as_str()) } else { (1, quote) };
    let is_basic = quote == "\"";
    let mut at = open;
    while at < piece.len() {
        if is_basic && piece[at..].starts_with('\\') {
            at += 1 + piece[at + 1..].chars().next().map_or(0, char::len_utf8);
        } else if piece[at..].starts_with(close) {
            at += close.len();
            // Up to two quotes more may stand before the closing three.
            while open == 3 && piece[at..].starts_with(quote) {
                at += 1;
            }
            return at;
        } else {
            at += piece[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    piece.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn without(text: &str, piece: &str) -> String {
        let mut splices = Splices::new(text);
        let at = text.find(piece).expect("the piece is there");
        splices.remove(at..at + piece.len());
        splices.apply()
    }

    #[test]
    fn what_is_removed_leaves_its_comments() {
        assert_eq!(without("a = 1\nb = 2\nc = 3\n", "b = 2"), "a = 1\nc = 3\n");
        assert_eq!(without("a = 1\n  b = 2 # two\nc = 3\n", "b = 2"), "a = 1\n  # two\nc = 3\n");
        assert_eq!(
            without("a = 1\r\n[t] # t\r\n# own\r\nb = '#' # x\r\nc = 3", "[t] # t\r\n# own\r\nb = '#'"),
            "a = 1\r\n# t\r\n# own\r\n# x\r\nc = 3"
        );
        assert_eq!(without("a = 1\n\n[t]\nb = 1\n\n[u]\n", "[t]\nb = 1"), "a = 1\n\n[u]\n");
        assert_eq!(without("a = 1\n\n[t]\nb = 1", "[t]\nb = 1"), "a = 1\n\n");
        assert_eq!(without("x = [1, 2, 3]", " 2,"), "x = [1, 3]");
        assert_eq!(without("x = [1, # one\n 2]", "1, # one\n "), "x = [# one\n2]");
    }

    #[test]
    fn texts_hide_what_looks_like_a_comment() {
        let piece = r####"a = "# \" #" # one
b = '#\' # two
c = """ # " "" \""" # """"" # three
d = ''' # ' ''' # four"####;
        assert_eq!(comments(piece), ["# one", "# two", "# three", "# four"]);
        assert_eq!(comments("a = \"# never closed"), Vec::<&str>::new());
    }

    #[test]
    fn changes_keep_the_rest() {
        let mut splices = Splices::new("abc");
        splices.insert(3, "!");
        splices.replace(1..2, "B");
        splices.insert(0, ">");
        splices.insert(0, ">");
        assert_eq!(splices.apply(), ">>aBc!");
        let mut splices = Splices::new("a\n\nb\n\nc\n");
        splices.remove(3..4);
        splices.insert(4, "\nnew");
        assert_eq!(splices.apply(), "a\n\n\nnew\n\nc\n");
    }
}
