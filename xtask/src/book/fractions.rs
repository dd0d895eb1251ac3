//! Which slashes are stacked as fractions: those whose two sides the plain text leaves in no doubt. All others stay slashes.
//!
//! A slash without spaces binds closer than a product with spaces: `a b/c d` is a (b/c) d. Factors before it may stand in the numerator, as
//! a (b/c) = (a b)/c; factors behind it never in the denominator. A slash with spaces takes all of the product before it.

use super::expression::{Bracket, Item, Node};

/// The items with their fractions.
pub fn stack(items: &[Item]) -> Vec<Item> {
    let mut done: Vec<Item> = Vec::new();
    let mut index = 0;
    while index < items.len() {
        let item = &items[index];
        if item.node == Node::Slash
            && let Some((start, end)) = bounds(&done, &items[index + 1..], item.spaced)
        {
            let numerator: Vec<Item> = done.drain(start..).collect();
            let denominator = &items[index + 1..index + 1 + end];
            let at = numerator[0].at.start..denominator[end - 1].at.end;
            let spaced = numerator[0].spaced;
            let node = Node::Fraction(without_brackets(numerator), without_brackets(denominator.to_vec()));
            done.push(Item { node, spaced, at });
            index += 1 + end;
        } else {
            done.push(item.clone());
            index += 1;
        }
    }
    done
}

/// Where the numerator begins in what stands before the slash, and how many items the denominator has behind it.
fn bounds(before: &[Item], behind: &[Item], spaced: bool) -> Option<(usize, usize)> {
    let end = denominator(behind, spaced)?;
    let is_derivative = is_differential(&behind[0].node);
    let start = numerator(before, &behind[..end], spaced, is_derivative)?;
    let words = |item: Option<&Item>| item.is_some_and(|item| matches!(item.node, Node::Word(_)));
    let text = |side: &[Item], beyond: Option<&Item>| {
        side.iter().any(|item| matches!(item.node, Node::Word(_))) && words(beyond)
    };
    let beyond = start.checked_sub(1).and_then(|index| before.get(index));
    (!text(&before[start..], beyond) && !text(&behind[..end], behind.get(end))).then_some((start, end))
}

/// How many of these items are the denominator; none where that is in doubt.
fn denominator(items: &[Item], spaced: bool) -> Option<usize> {
    let mut end = 1;
    if items.first()?.node.is_function() {
        end = 2;
    }
    if !items.get(end - 1)?.node.is_operand() {
        return None;
    }
    while let Some(next) = items.get(end).filter(|next| !next.spaced && next.node.is_operand()) {
        if is_group(&next.node) {
            // The bracket behind `∂/∂a` is what is differentiated; another may belong to the denominator or not.
            if !is_differential(&items[0].node) {
                return None;
            }
            break;
        }
        end += 1;
    }
    match items.get(end) {
        Some(next) if next.node == Node::Slash => None,
        Some(next) if next.node == Node::Operator("·".to_owned()) && !next.spaced => None,
        Some(next) if spaced && !matches!(next.node, Node::Operator(_) | Node::Punctuation(_)) => None,
        _ => Some(end),
    }
}

/// Where the numerator begins; none where that is in doubt.
fn numerator(items: &[Item], below: &[Item], spaced: bool, is_derivative: bool) -> Option<usize> {
    let mut start = items.len().checked_sub(1)?;
    if !items[start].node.is_operand() || matches!(items[start].node, Node::Fraction(..)) {
        return None;
    }
    let before = |start: usize| start.checked_sub(1).map(|index| &items[index]);
    // `r·z/w`: a dot without spaces binds as close as none.
    let dotted = |start: usize, spaced: bool| {
        let dot = before(start).is_some_and(|item| {
            item.node == Node::Operator("·".to_owned()) && (spaced || !item.spaced && !items[start].spaced)
        });
        dot && start >= 2 && items[start - 2].node.is_operand()
    };
    loop {
        if !items[start].spaced && before(start).is_some_and(|item| item.node.is_operand()) {
            start -= 1;
        } else if dotted(start, false) {
            start -= 2;
        } else {
            break;
        }
    }
    if is_derivative || matches!(items[start].node, Node::Differential(..)) {
        // `d f_n/dp`: the d stands apart from a name of more than one letter.
        let apart = before(start).is_some_and(|item| item.node == Node::Upright("d".to_owned()));
        return Some(if is_derivative && apart { start - 1 } else { start });
    }
    // `1/2`, `π/4`
    let number = |items: &[Item]| matches!(items, [Item { node: Node::Number(_), .. }]);
    let pi = matches!(&items[start..], [Item { node: Node::Letter(letter), .. }] if letter == "π");
    if (number(&items[start..]) || pi) && number(below) || matches!(items[start].node, Node::Word(_)) {
        return Some(start);
    }
    let near = start;
    if before(near).is_some_and(|item| item.node == Node::Slash) {
        return None;
    }
    while let Some(item) = before(start) {
        let plain = item.node.is_operand()
            && !matches!(
                item.node,
                Node::Word(_) | Node::Code(_) | Node::Fraction(..) | Node::Differential(..)
            );
        if item.node.is_function() && !spaced {
            // `sin a/2`: of the angle or of the sine?
            return None;
        }
        if plain || item.node.is_function() {
            start -= 1;
        } else if dotted(start, spaced) {
            start -= 2;
        } else {
            break;
        }
    }
    // A slash behind a fraction's neighbour, `π/4 d/e`, takes its neighbour alone.
    let fraction = before(start).is_some_and(|item| matches!(item.node, Node::Fraction(..) | Node::Slash));
    Some(if fraction { near } else { start })
}

fn is_differential(node: &Node) -> bool {
    match node {
        Node::Differential(..) => true,
        Node::Scripts(base, _) => is_differential(base),
        _ => false,
    }
}

fn is_group(node: &Node) -> bool {
    match node {
        Node::Group(..) => true,
        Node::Scripts(base, _) => is_group(base),
        _ => false,
    }
}

/// The content of a bracket that holds all of it: the line of the fraction brackets as well.
fn without_brackets(items: Vec<Item>) -> Vec<Item> {
    match items.as_slice() {
        [Item { node: Node::Group(Bracket::Round, inner), .. }] => inner.clone(),
        _ => items,
    }
}

#[cfg(test)]
mod tests {
    use super::super::expression::expression;
    use super::*;

    /// The formula with `{numerator|denominator}` for what is stacked.
    fn stacked(formula: &str) -> String {
        let mut text = String::new();
        for item in stack(&expression(formula).unwrap()) {
            let piece = |items: &[Item]| formula[items[0].at.start..items[items.len() - 1].at.end].to_owned();
            let space = if item.spaced { " " } else { "" };
            text += space;
            text += &match &item.node {
                Node::Fraction(above, below) => format!("{{{}|{}}}", piece(above), piece(below)),
                _ => formula[item.at].to_owned(),
            };
        }
        text
    }

    #[test]
    fn a_slash_without_spaces_takes_its_neighbour_and_the_factors_before_it() {
        assert_eq!(stacked("x + a b/c d"), "x + {a b|c} d");
        assert_eq!(stacked("2γ/(γ − 1)"), "{2γ|γ − 1}");
        assert_eq!(stacked("sqrt(λ)/2π"), "{sqrt(λ)|2π}");
        assert_eq!(stacked("−(a + b)/c²"), "−{a + b|c²}");
        assert_eq!(stacked("w (1 + b²)/(2 |b|)"), "{w (1 + b²)|2 |b|}");
        assert_eq!(stacked("Σ a x/b"), "Σ {a x|b}");
        assert_eq!(stacked("a − 1/2 m"), "a − {1|2} m");
        assert_eq!(stacked("y 1/2 b"), "y {1|2} b");
        assert_eq!(stacked("p π/4 B²"), "p {π|4} B²");
        assert_eq!(stacked("π/4 d² R/L"), "{π|4} d² {R|L}");
        assert_eq!(stacked("β = r·z/(r·z)_before"), "β = {r·z|(r·z)_before}");
        assert_eq!(stacked("w/2 · tan β"), "{w|2} · tan β");
    }

    #[test]
    fn a_slash_with_spaces_takes_the_product_before_it() {
        assert_eq!(stacked("a = m b / l"), "a = {m b|l}");
        assert_eq!(stacked("U sin δ / sin(α + δ)"), "{U sin δ|sin(α + δ)}");
        assert_eq!(stacked("(a + b) / c = 1"), "{a + b|c} = 1");
        assert_eq!(stacked("s = d·P / (d·u)"), "s = {d·P|d·u}");
        assert_eq!(stacked("T = f · V / P"), "T = {f · V|P}");
    }

    #[test]
    fn what_is_in_doubt_keeps_its_slash() {
        for formula in [
            "a / b c",
            "sin a/2",
            "a/b/c",
            "a/(b + c)(d + e)",
            "a/b·c",
            "number of firings / two",
            "1 / number of firings",
        ] {
            assert_eq!(stacked(formula), formula);
        }
    }

    #[test]
    fn derivatives_stand_for_themselves() {
        assert_eq!(stacked("c ∂A/∂c"), "c {∂A|∂c}");
        assert_eq!(stacked("p dV/dψ dψ"), "p {dV|dψ} dψ");
        assert_eq!(stacked("x d f_n/dp"), "x {d f_n|dp}");
        assert_eq!(stacked("∂/∂a(h³ p)"), "{∂|∂a}(h³ p)");
        assert_eq!(stacked("d/dt (a + b)"), "{d|dt} (a + b)");
        assert_eq!(stacked("d(V·W)/dp"), "{d(V·W)|dp}");
        assert_eq!(stacked("max|d²F/dθ²| x"), "max|d²F/dθ²| x");
    }

    #[test]
    fn functions_take_their_arguments_along() {
        assert_eq!(stacked("R a/sin a"), "{R a|sin a}");
        assert_eq!(stacked("e = a/sin² a − cot a"), "e = {a|sin² a} − cot a");
        assert_eq!(stacked("J(a, b)/S(c, b)"), "{J(a, b)|S(c, b)}");
        assert_eq!(stacked("max|F|/k"), "{max|F||k}");
    }
}
