//! A piece of a line as words with formulas between them.

use super::equation::equation_number;
use super::expression::{Bracket, Item, Node, expression};
use super::mathml::{escape, math};
use anyhow::{Context, Result};

/// A piece with more words than this, or with nothing but words, is text, which may break.
const TEXT: usize = 3;

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
}
