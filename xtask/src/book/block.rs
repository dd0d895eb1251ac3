//! A block of formulas as a table: what stands below one another in the text does so on the page, numbers at the right.

use super::expression::{Bracket, Item, Node, expression};
use super::mathml::{escape, math};
use super::tokens::is_accent;
use anyhow::{Context, Result};
use std::collections::BTreeMap;

const RELATIONS: &str = "=<>≤≥∈∋→";

/// A piece with more words than this, or with nothing but words, is text, which may break.
const TEXT: usize = 3;

/// What a line says up to a gap of two spaces or more.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Piece {
    column: usize,
    text: String,
}

/// A line of the block.
struct Line {
    pieces: Vec<Piece>,
    number: Option<String>,
    /// Whether an empty line stands before it.
    apart: bool,
}

/// The HTML of a block, on one line; `link` makes a number in brackets a reference. The error names the line within the block, from 1.
pub fn html(text: &str, link: &dyn Fn(&str) -> Option<String>) -> Result<String, (usize, anyhow::Error)> {
    let lines = lines(text);
    let stops = stops(&lines);
    let mut rows = String::new();
    for (line, number) in &lines {
        rows += &row(line, &stops, link).map_err(|error| (*number, error))?;
    }
    let plain = escape(text.trim_end()).replace('\n', "&#10;");
    Ok(format!(
        "<div class=\"formula\"><table role=\"presentation\"><tbody style=\"--stops: {}\">{rows}</tbody></table>\
         <details><summary title=\"the formulas as plain text\">text</summary><pre>{plain}</pre></details></div>",
        stops.len()
    ))
}

/// `43.2`: chapter and number.
pub fn is_equation_number(text: &str) -> bool {
    text.split_once('.').is_some_and(|(chapter, number)| {
        let digits = |part: &str| (1..=2).contains(&part.len()) && part.bytes().all(|b| b.is_ascii_digit());
        digits(chapter) && digits(number)
    })
}

/// `43.2` of `(43.2)`.
pub fn equation_number(text: &str) -> Option<&str> {
    text.strip_prefix('(')?.strip_suffix(')').filter(|number| is_equation_number(number))
}

/// Where an equation stands within its page.
pub fn anchor(number: &str) -> String {
    format!("eq-{}", number.replace('.', "-"))
}

/// The lines with their numbers from 1.
fn lines(text: &str) -> Vec<(Line, usize)> {
    let mut lines = Vec::new();
    let mut apart = false;
    for (index, line) in text.lines().enumerate() {
        let mut pieces = pieces(line);
        let number = pieces.last().and_then(|piece| equation_number(&piece.text)).map(str::to_owned);
        if number.is_some() {
            pieces.pop();
        }
        if line.trim().is_empty() {
            apart = true;
        } else {
            lines.push((Line { pieces, number, apart: std::mem::take(&mut apart) }, index + 1));
        }
    }
    lines
}

/// A line between its gaps; within brackets spaces are no gap.
fn pieces(line: &str) -> Vec<Piece> {
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
struct Stop {
    column: usize,
    /// Whether they begin with a relation.
    relation: bool,
}

/// Columns at which pieces of at least two lines begin, or a relation that begins a piece of one and follows a space in another; the first
/// is 0.
fn stops(lines: &[(Line, usize)]) -> Vec<Stop> {
    let mut stops = BTreeMap::from([(0, false)]);
    let begins = |line: &Line, column: usize| line.pieces.iter().any(|piece| piece.column == column);
    let relates = |line: &Line, column: usize| {
        line.pieces
            .iter()
            .any(|piece| split(piece, column).is_some_and(|(_, behind)| is_relation(&behind.text)))
    };
    for (index, (line, _)) in lines.iter().enumerate() {
        for piece in &line.pieces {
            let mut others =
                lines.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, (line, _))| line);
            let relation = is_relation(&piece.text);
            if others.any(|other| begins(other, piece.column) || relation && relates(other, piece.column)) {
                *stops.entry(piece.column).or_default() |= relation;
            }
        }
    }
    stops.into_iter().map(|(column, relation)| Stop { column, relation }).collect()
}

fn is_relation(text: &str) -> bool {
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
fn joined(pieces: &[Piece], stops: &[Stop]) -> Vec<Piece> {
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

fn row(line: &Line, stops: &[Stop], link: &dyn Fn(&str) -> Option<String>) -> Result<String> {
    let pieces = joined(&line.pieces, stops);
    let cell_of = |piece: &Piece| stops.iter().rposition(|stop| stop.column <= piece.column).unwrap_or(0);
    let mut cells: Vec<(usize, Vec<&Piece>)> = Vec::new();
    for piece in &pieces {
        match cells.last_mut() {
            Some((cell, held)) if *cell == cell_of(piece) => held.push(piece),
            _ => cells.push((cell_of(piece), vec![piece])),
        }
    }
    let mut html = String::new();
    for (index, (cell, held)) in cells.iter().enumerate() {
        let mut classes = Vec::new();
        if held[0].column > stops[*cell].column {
            classes.push("indented");
        }
        if is_relation(&held[0].text) {
            classes.push("relation");
        }
        if line.apart {
            classes.push("apart");
        }
        let class =
            if classes.is_empty() { String::new() } else { format!(" class=\"{}\"", classes.join(" ")) };
        // The last one has all that is left before the number.
        let end = cells.get(index + 1).map_or("-2".to_owned(), |(next, _)| (next + 1).to_string());
        let content = held.iter().map(|piece| flow(&piece.text, link)).collect::<Result<Vec<_>>>()?;
        html += &format!("<td{class} style=\"grid-column: {} / {end}\">{}</td>", cell + 1, content.join(" "));
    }
    let number = line.number.as_deref().map_or(String::new(), |number| {
        let anchor = anchor(number);
        format!("<a id=\"{anchor}\" href=\"#{anchor}\">({number})</a>")
    });
    Ok(format!("<tr>{html}<td class=\"number\">{number}</td></tr>"))
}

/// A piece as words with formulas between them, so that long text breaks as text does.
pub fn flow(text: &str, link: &dyn Fn(&str) -> Option<String>) -> Result<String> {
    let items = expression(text).with_context(|| format!("cannot typeset {text:?}"))?;
    let mut html = String::new();
    let mut formula: Vec<Item> = Vec::new();
    let mut after_words = false;
    let mut count = 0;
    for (index, item) in items.iter().enumerate() {
        let behind = items.get(index + 1).map(|next| &next.node);
        let reference = equation_number(&text[item.at.clone()]);
        let words = match &item.node {
            Node::Word(word) if !is_quantity(&items, index) => Some(escape(word)),
            Node::Code(code) => Some(format!("<code>{}</code>", escape(code))),
            // A sign between words is one of the text; so is the colon that ends a label.
            Node::Punctuation(sign)
                if after_words && formula.is_empty()
                    || sign == ":"
                    || matches!(behind, Some(Node::Word(_))) =>
            {
                Some(sign.clone())
            }
            // "(four-stroke)", unless it is a factor.
            Node::Group(Bracket::Round, inner) if is_text(inner) && !behind.is_some_and(is_factor) => {
                let words = text[item.at.clone()].trim_matches(['(', ')']).trim();
                Some(escape(&format!("({words})")))
            }
            Node::Slash
                if after_words && formula.is_empty()
                    || item.spaced && matches!(behind, Some(Node::Word(_))) =>
            {
                Some("/".to_owned())
            }
            _ => reference.map(|number| {
                let label = format!("({number})");
                link(number).map_or(label.clone(), |to| format!("<a href=\"{to}\">{label}</a>"))
            }),
        };
        match words {
            Some(words) => {
                // Signs bring their own spaces.
                let sign = formula.last().is_some_and(|last| matches!(last.node, Node::Operator(_)));
                put(&mut html, &mut formula, text);
                html += if item.spaced && !html.is_empty() && !sign { " " } else { "" };
                html += &words;
                after_words = true;
                count += text[item.at.clone()].split_whitespace().count();
            }
            None => {
                if formula.is_empty() && item.spaced && !html.is_empty() && !is_infix(&items, index) {
                    html.push(' ');
                }
                formula.push(item.clone());
                after_words = false;
            }
        }
    }
    put(&mut html, &mut formula, text);
    let class = if count > TEXT || !html.contains("<math") { " class=\"text\"" } else { "" };
    Ok(format!("<span{class}>{html}</span>"))
}

/// Whether only words stand there.
fn is_text(items: &[Item]) -> bool {
    items.iter().all(|item| matches!(item.node, Node::Word(_) | Node::Punctuation(_)))
}

/// Whether it is multiplied with what stands before it.
fn is_factor(node: &Node) -> bool {
    node.is_operand() && !matches!(node, Node::Word(_) | Node::Code(_))
}

/// Whether this word alone is a quantity: a sign of the formula stands right beside it.
fn is_quantity(items: &[Item], index: usize) -> bool {
    let word = |item: Option<&Item>| item.is_some_and(|item| matches!(item.node, Node::Word(_)));
    let before = index.checked_sub(1);
    let behind = items.get(index + 1);
    before.is_some_and(|before| matches!(items[before].node, Node::Slash | Node::Operator(_)))
        && !word(behind)
        || is_infix(items, index + 1) && !word(before.and_then(|before| items.get(before)))
}

/// Whether a sign stands here that belongs to both its sides.
fn is_infix(items: &[Item], index: usize) -> bool {
    let touches = items.get(index + 1).is_some_and(|next| !next.spaced);
    items.get(index).is_some_and(|item| match item.node {
        Node::Slash => !item.spaced,
        Node::Operator(_) => !(item.spaced && touches),
        _ => false,
    })
}

/// Sets the formula that has been gathered.
fn put(html: &mut String, formula: &mut Vec<Item>, text: &str) {
    if let (Some(first), Some(last)) = (formula.first(), formula.last()) {
        *html += &math(formula, &text[first.at.start..last.at.end]);
        formula.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cells of every line, as their columns and their text without tags.
    fn cells(text: &str) -> Vec<Vec<(String, String)>> {
        let html = html(text, &|_| None).unwrap();
        let document = roxmltree::Document::parse(&html).unwrap();
        let rows = document.descendants().filter(|node| node.has_tag_name("tr"));
        let cell = |node: roxmltree::Node<'_, '_>| {
            let text =
                node.descendants().filter(|n| n.is_text()).filter_map(|n| n.text()).collect::<String>();
            (node.attribute("style").unwrap_or_default().replace("grid-column: ", ""), text)
        };
        rows.map(|row| row.children().map(cell).collect()).collect()
    }

    fn cell(columns: &str, text: &str) -> (String, String) {
        (columns.to_owned(), text.to_owned())
    }

    #[test]
    fn what_stands_in_one_column_stands_so_on_the_page() {
        let lines = cells("flat     U = a      (1.1)\nround    V = b\n         W = c      (1.2)\n");
        assert_eq!(lines[0], [cell("1 / 2", "flat"), cell("2 / -2", "U=a"), cell("", "(1.1)")]);
        assert_eq!(lines[1], [cell("1 / 2", "round"), cell("2 / -2", "V=b"), cell("", "")]);
        assert_eq!(lines[2], [cell("2 / -2", "W=c"), cell("", "(1.2)")]);
    }

    #[test]
    fn relations_below_one_another_share_a_column() {
        let lines = cells("A    = b + c\nI_yy = d\n       + e\n");
        assert_eq!(lines[0][..2], [cell("1 / 2", "A"), cell("2 / -2", "=b+c")]);
        assert_eq!(lines[1][..2], [cell("1 / 2", "Iyy"), cell("2 / -2", "=d")]);
        assert_eq!(lines[2][..1], [cell("2 / -2", "+e")]);
    }

    #[test]
    fn gaps_in_brackets_and_beside_relations_part_nothing() {
        let html = html("U = (a   + b)      V  ≤  c\n", &|_| None).unwrap();
        assert_eq!(html.matches("<span").count(), 2, "{html}");
        assert_eq!(html.matches("<math").count(), 2, "{html}");
    }

    #[test]
    fn words_are_text_and_names_of_quantities_are_in_the_formula() {
        let of = |formula| flow(formula, &|_| Some("to".to_owned())).unwrap();
        let texts = of("force on mount j = K q");
        assert!(
            texts.starts_with("<span>force on mount <math") && texts.contains("alttext=\"j = K q\""),
            "{texts}"
        );
        assert!(of("stroke = a − b").starts_with("<span><math"));
        assert_eq!(
            of("bending at the pin's fillet"),
            "<span class=\"text\">bending at the pin's fillet</span>"
        );
        assert!(of("k ( four-stroke )").ends_with("</math> (four-stroke)</span>"));
        assert!(of("Σ (its parts) z / U").contains("alttext=\"Σ (its parts) z / U\""));
        assert!(of("by M of (51.6)").ends_with("of <a href=\"to\">(51.6)</a></span>"));
        assert!(of("A = `head_area` · B").contains("<code>head_area</code>"));
        assert!(of("co-energy −(p − q)").contains("co-energy <math"));
    }

    #[test]
    fn the_plain_text_stays_beside_the_formula() {
        let html = html("a < b      (1.2)\nc = d\n", &|_| None).unwrap();
        assert!(html.contains("<pre>a &lt; b      (1.2)&#10;c = d</pre>"), "{html}");
        assert!(html.contains("alttext=\"a &lt; b\""), "{html}");
        assert!(html.contains("<a id=\"eq-1-2\" href=\"#eq-1-2\">(1.2)</a>"), "{html}");
        assert!(!html.contains('\n'), "a block of HTML in Markdown ends at an empty line");
    }

    #[test]
    fn a_mistake_names_its_line() {
        let (line, error) = html("a = b\nc = (d\n", &|_| None).unwrap_err();
        assert_eq!(line, 2);
        assert!(format!("{error:#}").contains("cannot typeset \"c = (d\": \"(\" is not closed"), "{error:#}");
    }
}
