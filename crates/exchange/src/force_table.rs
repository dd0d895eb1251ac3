//! Forces at points by order and speed.

use num_complex::Complex64;

/// A point that is loaded.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedPoint {
    /// Number of its node or grid point, from 1.
    pub id: u32,
    /// Name in comments.
    pub name: String,
    /// Where it is [m].
    pub position: [f64; 3],
    /// What its forces are, one line.
    pub words: String,
}

/// Forces of one order.
#[derive(Debug, Clone, PartialEq)]
pub struct OrderForces {
    /// Order: periods in one revolution of crankshaft 1.
    pub order: f64,
    /// Force [N] by point and speed.
    ///
    /// ```text
    /// f(t) = Re( F e^{i n w t} )      n: order, w: speed of crankshaft 1 [rad/s], t = 0 where its angle is 0
    /// ```
    pub forces: Vec<Vec<[Complex64; 3]>>,
}

/// Forces at points by order and speed, each order apart: the mean force is in none of them.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceTable {
    /// Title, one line.
    pub title: String,
    /// What the reader should know, a line each.
    pub notes: Vec<String>,
    /// Speeds of crankshaft 1 [rad/s], rising.
    pub speeds: Vec<f64>,
    /// The points.
    pub points: Vec<LoadedPoint>,
    /// Orders, rising.
    pub orders: Vec<OrderForces>,
}

/// A text in lines of plain characters, broken between words where it is longer.
pub(crate) fn wrap(text: &str, longest: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in plain(text, usize::MAX).split_whitespace() {
        let mut rest = word;
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= longest => {
                line.push(' ');
                line.push_str(word);
                continue;
            }
            _ => {}
        }
        // A word without end.
        while rest.len() > longest {
            lines.push(rest[..longest].to_owned());
            rest = &rest[longest..];
        }
        lines.push(rest.to_owned());
    }
    lines
}

/// A text in so many lines of plain characters at most; what is left out of the last one is said by dots.
pub(crate) fn fit<const LINES: usize>(text: &str, longest: usize) -> [String; LINES] {
    let all = wrap(text, longest);
    let mut lines = all.iter().cloned();
    let mut found: [String; LINES] = std::array::from_fn(|_| lines.next().unwrap_or_default());
    if let Some(last) = found.last_mut().filter(|_| all.len() > LINES) {
        let kept = wrap(last, longest - 4);
        *last = format!("{} ...", kept.first().map_or("", String::as_str));
    }
    found
}

/// A text in one line of plain characters, as files of columns hold it.
pub(crate) fn plain(text: &str, longest: usize) -> String {
    let plain = |c: char| if c.is_ascii_graphic() || c == ' ' { c } else { '?' };
    text.chars().map(plain).take(longest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_between_words_and_lose_none() {
        let text = "forces of the block, from inertia loads and gas (ideal cycle: four-stroke, \u{b0}C)";
        let lines = wrap(text, 20);
        assert!(lines.iter().all(|line| line.len() <= 20), "{lines:?}");
        assert_eq!(lines.join(" "), text.replace('\u{b0}', "?"));
        assert_eq!(wrap(&"a".repeat(45), 20).concat(), "a".repeat(45));
        assert_eq!(fit::<2>("one two", 20), ["one two", ""]);
        let [first, last] = fit::<2>(text, 20);
        assert_eq!([first.as_str(), last.as_str()], ["forces of the block,", "from inertia ..."]);
    }
}
