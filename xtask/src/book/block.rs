//! A block of formulas as a table: what stands below one another in the text does so on the page, numbers at the right.

use super::columns::{Piece, Stop, is_relation, joined, pieces, stops};
use super::equation::{anchor, equation_number};
use super::flow::flow;
use super::mathml::escape;
use anyhow::Result;

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
    let stops = stops(&lines.iter().map(|(line, _)| line.pieces.as_slice()).collect::<Vec<_>>());
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
