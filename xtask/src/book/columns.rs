//! What stands below one another in the lines of a block: columns like tab stops.

use super::tokens::is_accent;
use std::collections::BTreeMap;

const RELATIONS: &str = "=<>≤≥∈∋→";

/// What a line says up to a gap of two spaces or more.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Where it begins, in characters.
    pub column: usize,
    /// What it says.
    pub text: String,
}

/// A line between its gaps; within brackets spaces are no gap.
pub fn pieces(line: &str) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let (mut depth, mut spaces, mut column) = (0_usize, 2, 0);
    for c in line.chars() {
        if c == ' ' {
            spaces += 1;
        } else {
            if spaces >= 2 && depth == 0 {
                pieces.push(Piece { column, text: String::new() });
            } else if let (Some(piece), true) = (pieces.last_mut(), spaces > 0) {
                piece.text.push(' ');
            }
            match c {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth = depth.saturating_sub(1),
                _ => {}
            }
            if let Some(piece) = pieces.last_mut() {
                piece.text.push(c);
            }
            spaces = 0;
        }
        column += usize::from(!is_accent(c));
    }
    pieces
}

/// A column at which pieces of several lines begin.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Stop {
    /// The column, in characters.
    pub column: usize,
    /// Whether they begin with a relation.
    relation: bool,
}

/// Columns at which pieces of at least two lines begin, or a relation that begins a piece of one and follows a space in another; the first
/// is 0.
pub fn stops(lines: &[&[Piece]]) -> Vec<Stop> {
    let mut stops = BTreeMap::from([(0, false)]);
    let begins = |line: &[Piece], column: usize| line.iter().any(|piece| piece.column == column);
    let relates = |line: &[Piece], column: usize| {
        line.iter().any(|piece| split(piece, column).is_some_and(|(_, behind)| is_relation(&behind.text)))
    };
    for (index, line) in lines.iter().enumerate() {
        for piece in *line {
            let mut others =
                lines.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, line)| *line);
            let relation = is_relation(&piece.text);
            if others.any(|other| begins(other, piece.column) || relation && relates(other, piece.column)) {
                *stops.entry(piece.column).or_default() |= relation;
            }
        }
    }
    stops.into_iter().map(|(column, relation)| Stop { column, relation }).collect()
}

/// Whether a relation such as = begins it.
pub fn is_relation(text: &str) -> bool {
    text.starts_with(|c| RELATIONS.contains(c)) || text.starts_with("+=") || text.starts_with("−=")
}

/// A piece in front of and from this column on, where a space outside brackets stands before it.
fn split(piece: &Piece, column: usize) -> Option<(Piece, Piece)> {
    let (mut at, mut depth) = (piece.column, 0_i32);
    for (byte, c) in piece.text.char_indices() {
        if at == column && depth == 0 && piece.text[..byte].ends_with(' ') && !is_accent(c) {
            let front = Piece { column: piece.column, text: piece.text[..byte].trim_end().to_owned() };
            return Some((front, Piece { column, text: piece.text[byte..].to_owned() }));
        }
        depth += i32::from(matches!(c, '(' | '[' | '{')) - i32::from(matches!(c, ')' | ']' | '}'));
        at += usize::from(!is_accent(c));
    }
    None
}

/// Pieces with those joined that say one thing: a relation stands at the end of one or at the beginning of the next.
pub fn joined(pieces: &[Piece], stops: &[Stop]) -> Vec<Piece> {
    let mut done: Vec<Piece> = Vec::new();
    let mut todo: Vec<Piece> = pieces.iter().rev().cloned().collect();
    while let Some(mut piece) = todo.pop() {
        let mut relations = stops.iter().filter(|stop| stop.relation);
        let parted = relations
            .find_map(|stop| split(&piece, stop.column).filter(|(_, behind)| is_relation(&behind.text)));
        if let Some((front, behind)) = parted {
            todo.push(behind);
            piece = front;
        }
        let at_stop = stops.iter().any(|stop| stop.column == piece.column);
        match done.last_mut() {
            Some(last) if goes_on(&last.text) || !at_stop && is_relation(&piece.text) => {
                last.text = format!("{} {}", last.text, piece.text);
            }
            _ => done.push(piece),
        }
    }
    done
}

/// Whether the piece is not complete at its end.
fn goes_on(text: &str) -> bool {
    text.ends_with(|c| RELATIONS.contains(c) || "+−-·".contains(c)) || text.ends_with(" of")
}
