//! A Sankey picture: energy that comes in on the left and where it goes on the right, widths in proportion.

use crate::kit::figure::Panel;
use crate::kit::number;
use crate::kit::svg::{Anchor, Path, Svg};

/// Sizes of the picture [px]: width, height of the trunk, of the gap between two flows, reach of the words beside it.
const WIDTH: f64 = 640.0;
const TRUNK: f64 = 170.0;
const GAP: f64 = 14.0;
const WORDS: f64 = 200.0;

/// Height of a line of words within the trunk [px].
const LINE: f64 = 16.0;

/// Points of a curve from the trunk to a flow.
const POINTS: usize = 24;

/// Flows below this share of the largest side are left out.
const THIN: f64 = 1e-3;

/// Draws it; `None` where nothing flows. Names and energies [J], all positive; `within`: what the trunk between both sides is divided into, from above.
pub(crate) fn energy_flow(
    given: &[(String, f64)],
    taken: &[(String, f64)],
    within: &[(String, f64)],
) -> Option<Panel> {
    let sum = |flows: &[(String, f64)]| flows.iter().map(|(_, energy)| energy).sum::<f64>();
    let whole = sum(given).max(sum(taken));
    if !(whole > 0.0 && whole.is_finite()) {
        return None;
    }
    let shown = |flows: &[(String, f64)]| -> Vec<(String, f64)> {
        flows.iter().filter(|(_, energy)| *energy > THIN * whole).cloned().collect()
    };
    let (given, taken) = (shown(given), shown(taken));
    let most = given.len().max(taken.len());
    let height = TRUNK + GAP * most as f64 + 40.0;
    let mut svg = Svg::new(WIDTH, height);
    let (left, right) = (WORDS, WIDTH - WORDS);
    let middle = height / 2.0;
    for (flows, from, to, anchor) in
        [(&given, left, left + 70.0, Anchor::End), (&taken, right, right - 70.0, Anchor::Start)]
    {
        let total: f64 = flows.iter().map(|(_, energy)| energy).sum();
        let tall = TRUNK * total / whole + GAP * flows.len().saturating_sub(1) as f64;
        let mut outer = middle - tall / 2.0;
        let mut inner = middle - TRUNK * total / whole / 2.0;
        for (index, (name, energy)) in flows.iter().enumerate() {
            let wide = TRUNK * energy / whole;
            svg.path(
                if index % 2 == 0 { "weight" } else { "metal" },
                &band([from, to], [outer, inner], wide),
            );
            let words = format!("{name} {} J", number::short(*energy, 4));
            let beside = if from < to { from - 6.0 } else { from + 6.0 };
            svg.text("small", (beside, outer + wide / 2.0 + 4.0), anchor, &words);
            outer += wide + GAP;
            inner += wide;
        }
    }
    svg.rect("weight", left + 70.0, middle - TRUNK / 2.0, right - left - 140.0, TRUNK);
    let mut top = middle - TRUNK / 2.0;
    for (name, energy) in within {
        let tall = TRUNK * energy / whole;
        svg.rect("weight", left + 70.0, top, right - left - 140.0, tall);
        if tall > LINE {
            let words = format!("{name} {} J", number::short(*energy, 4));
            svg.text("small", (0.5 * (left + right), top + tall / 2.0 + 4.0), Anchor::Middle, &words);
        }
        top += tall;
    }
    let list = |flows: &[(String, f64)]| -> String {
        let each: Vec<String> =
            flows.iter().map(|(name, energy)| format!("{name} {} J", number::short(*energy, 4))).collect();
        each.join(", ")
    };
    let between = match within {
        [] => String::new(),
        parts => format!(" By way of: {}.", list(parts)),
    };
    let description = format!("Comes in: {}.{between} Goes: {}.", list(&given), list(&taken));
    Some(Panel::new(svg, description))
}

/// A band of constant width from the outer to the inner height.
fn band([from, to]: [f64; 2], [outer, inner]: [f64; 2], wide: f64) -> Path {
    let at = |k: usize| {
        let share = k as f64 / POINTS as f64;
        let smooth = share * share * (3.0 - 2.0 * share);
        (from + share * (to - from), outer + smooth * (inner - outer))
    };
    let above = (0..=POINTS).map(at);
    let below = (0..=POINTS).rev().map(|k| (at(k).0, at(k).1 + wide));
    Path::through(above.chain(below)).close()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_sides_are_told_and_nothing_is_no_picture() {
        let flows = |list: &[(&str, f64)]| -> Vec<(String, f64)> {
            list.iter().map(|(name, energy)| ((*name).to_owned(), *energy)).collect()
        };
        let panel = energy_flow(
            &flows(&[("gas", 100.0)]),
            &flows(&[("load", 70.0), ("friction", 29.99), ("dampers", 0.01)]),
            &[],
        )
        .expect("energy flows");
        assert_eq!(panel.description, "Comes in: gas 100.0 J. Goes: load 70.00 J, friction 29.99 J.");
        assert!(energy_flow(&[], &flows(&[("load", 0.0)]), &[]).is_none());
        let parts = flows(&[("work", 40.0), ("heat", 60.0)]);
        let panel =
            energy_flow(&flows(&[("fuel", 100.0)]), &flows(&[("load", 40.0), ("walls", 60.0)]), &parts);
        let told = panel.expect("energy flows").description;
        assert_eq!(
            told,
            "Comes in: fuel 100.0 J. By way of: work 40.00 J, heat 60.00 J. Goes: load 40.00 J, walls 60.00 J."
        );
    }
}
