//! Tornado charts: what each input does to an output at both ends of its range, the strongest on top.

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number::{self, Scale};
use crate::kit::svg::{Anchor, Svg};
use crate::study::sensitivity_tables::{input_name, strongest};
use lanchester_study::sensitivity::{OutputSensitivity, Sensitivity};

/// Inputs that are drawn.
const MOST: usize = 12;
/// Width of the names beside the bars, and of the bars [px].
const NAMES: f64 = 190.0;
const BARS: f64 = 370.0;
const HEAD: f64 = 42.0;
const ROW: f64 = 24.0;

/// One chart for each output that any input changes.
pub fn tornado_figure(found: &Sensitivity) -> Figure {
    let outputs = found.outputs.iter().filter(|own| !strongest(own).is_empty());
    Figure {
        id: "sensitivity".to_owned(),
        title: "Sensitivities".to_owned(),
        caption: format!(
            "What each input does to an output at {} rpm at the lower end of its range (above) and at the upper end (below), one at a time.",
            number::short(number::rpm(found.speed), 4)
        ),
        panels: outputs.map(|own| chart(found, own)).collect(),
        columns: 2,
    }
}

fn chart(found: &Sensitivity, own: &OutputSensitivity) -> Panel {
    let order: Vec<usize> = strongest(own).into_iter().take(MOST).collect();
    let ends = |k: usize| [own.effects[k].below, own.effects[k].above];
    let all = order.iter().flat_map(|&k| ends(k)).flatten().chain([own.nominal]);
    let (low, high) =
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    let scale = Scale::of(low.abs().max(high.abs()), own.unit);
    let axis = Axis::of(low / scale.divisor, high / scale.divisor, 4);
    let bottom = HEAD + ROW * order.len() as f64;
    let mut svg = Svg::new(NAMES + BARS + 30.0, bottom + 26.0);
    let at = |value: f64| axis.place(value / scale.divisor, NAMES, NAMES + BARS);
    let title = format!("{} [{}]", number::capital(&own.name), scale.unit);
    svg.text("strong", (4.0, 15.0), Anchor::Start, &title);
    for &tick in &axis.ticks {
        let x = axis.place(tick, NAMES, NAMES + BARS);
        svg.line("grid", (x, HEAD - 8.0), (x, bottom));
        svg.text("muted small", (x, bottom + 17.0), Anchor::Middle, &number::fixed(tick, axis.decimals));
    }
    let mut said = Vec::with_capacity(order.len());
    for (row, &k) in order.iter().enumerate() {
        let middle = HEAD + ROW * (row as f64 + 0.5) - 4.0;
        let name = input_name(&found.inputs[k]);
        svg.name("small", (NAMES - 8.0, middle + 4.0), Anchor::End, &name);
        for (end, class, half) in [(own.effects[k].below, "bar3", 0.0), (own.effects[k].above, "bar1", 1.0)] {
            let Some(value) = end else { continue };
            let (from, to) = (at(own.nominal.min(value)), at(own.nominal.max(value)));
            svg.rect(class, from, middle - 8.0 + 8.0 * half, (to - from).max(0.5), 8.0);
        }
        let shown =
            ends(k).map(|end| end.map_or("none".to_owned(), |value| number::short(value / scale.divisor, 4)));
        said.push(format!("{name} {} and {}", shown[0], shown[1]));
    }
    svg.line("limit", (at(own.nominal), HEAD - 8.0), (at(own.nominal), bottom));
    Panel::new(svg, format!("{title} at both ends: {}.", said.join("; ")))
}
