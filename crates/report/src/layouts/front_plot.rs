//! The front of a search over layouts: the first objective against each of the others.

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number::{self, Scale};
use crate::kit::plot::{BOTTOM, HEIGHT, LEFT, RIGHT, WIDTH, value_axis};
use crate::kit::svg::{Anchor, Path, Svg};
use crate::layouts::front::printed;
use lanchester_study::explore::{ExploreAnswer, Objective};

/// Most layouts that are drawn.
const MOST: usize = 2000;

/// Numbers stand at so many layouts of a panel at most.
const NUMBERED: usize = 6;

const TOP: f64 = 30.0;

/// Axes reach so many times as far as the front, where cases behind it do.
const BEHIND: f64 = 2.5;

/// A sample of all judged cases as dots, every layout of the front as a point, by pairs of objectives; what is Pareto-optimal in the two of a panel alone is filled and
/// joined by the line that no layout crosses.
pub fn layout_front_figure(answer: &ExploreAnswer) -> Figure {
    let spread = |place: usize| {
        let values = answer.front.iter().map(|layout| layout.values[place]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        high - low > 1e-9 * high.abs()
    };
    // What all have alike tells nothing.
    let varied: Vec<usize> = (0..answer.objectives.len()).filter(|place| spread(*place)).collect();
    let pairs: Vec<(usize, usize)> = match varied.as_slice() {
        [] => Vec::new(),
        [one] => vec![(*one, *one)],
        [first, others @ ..] => others.iter().map(|other| (*first, *other)).collect(),
    };
    let panels: Vec<Panel> = pairs.iter().map(|&(y, x)| panel(answer, x, y)).collect();
    let alike: Vec<String> = (0..answer.objectives.len())
        .filter(|place| !varied.contains(place) && !answer.front.is_empty())
        .map(|place| answer.objectives[place].name.clone())
        .collect();
    let same = match alike.as_slice() {
        [] => String::new(),
        names => format!(" All have the same {}.", names.join(", ")),
    };
    let given = if answer.given.is_some() { " The ring is the engine of the file." } else { "" };
    Figure {
        id: "layout-front".to_owned(),
        title: format!("Pareto-optimal layouts of {} cylinders", answer.cylinders),
        caption: format!(
            "Dots are {}. Every point is a layout of the front. Filled points are Pareto-optimal in the two objectives of their panel \
             alone: nothing lies below and to the left of the line through them. Numbers are those of the table.{given}{same}",
            dots_words(answer)
        ),
        columns: panels.len().clamp(1, 2),
        panels,
    }
}

/// What the dots are.
fn dots_words(answer: &ExploreAnswer) -> String {
    let (shown, judged) = (answer.sample.len() as f64, answer.counts.judged as f64);
    let number = |value: f64| number::terminal(value, 0);
    match answer.counts.judged > answer.sample.len() as u128 {
        true => format!(
            "{} of the {} judged cases, drawn evenly, as far as the axes reach",
            number(shown),
            number(judged)
        ),
        false => "all judged cases, as far as the axes reach".to_owned(),
    }
}

/// Scale of an objective in print.
fn scale(objective: Objective, largest: f64) -> Scale {
    let (_, unit, factor) = printed(objective);
    match unit {
        "N" | "N m" => Scale::of(largest, unit),
        _ => Scale { divisor: 1.0 / factor, unit: unit.to_owned() },
    }
}

fn panel(answer: &ExploreAnswer, x: usize, y: usize) -> Panel {
    let layouts = &answer.front[..answer.front.len().min(MOST)];
    let given = answer.given.as_ref().and_then(|given| Some((given.values[x]?, given.values[y]?)));
    let points: Vec<(f64, f64)> = layouts.iter().map(|layout| (layout.values[x], layout.values[y])).collect();
    let behind: Vec<(f64, f64)> = answer.sample.iter().map(|case| (case.values[x], case.values[y])).collect();
    let all = || points.iter().copied().chain(given);
    let largest = |of: fn((f64, f64)) -> f64| {
        let front = all().map(of).fold(0.0, f64::max);
        let cases = behind.iter().copied().map(of).fold(0.0, f64::max);
        // A front that is nothing leaves the axis to the cases.
        if front > 0.0 { front.max(cases.min(BEHIND * front)) } else { cases }
    };
    let [x_scale, y_scale] = [(x, largest(|p| p.0)), (y, largest(|p| p.1))]
        .map(|(place, largest)| scale(answer.objectives[place].objective, largest));
    let lowest = |of: fn((f64, f64)) -> f64| {
        let low = all().map(of).fold(f64::INFINITY, f64::min);
        // A front near zero is shown from zero.
        if low < 0.6 * all().map(of).fold(0.0, f64::max) { 0.0 } else { low }
    };
    let x_axis = Axis::of(lowest(|p| p.0) / x_scale.divisor, largest(|p| p.0) / x_scale.divisor, 6);
    let y_axis = Axis::of(lowest(|p| p.1) / y_scale.divisor, largest(|p| p.1) / y_scale.divisor, 6);
    let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM + 20.0);
    let mut svg = Svg::new(WIDTH, HEIGHT + 20.0);
    let head = |place: usize, scale: &Scale| {
        let name = &answer.objectives[place].name;
        let unit = if scale.unit.is_empty() { String::new() } else { format!(" [{}]", scale.unit) };
        let mut letters = name.chars();
        let first = letters.next().map_or(String::new(), |first| first.to_uppercase().collect());
        format!("{first}{}{unit}", letters.as_str())
    };
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &head(y, &y_scale));
    value_axis(&mut svg, &y_axis, TOP, bottom);
    for &tick in &x_axis.ticks {
        let at = x_axis.place(tick, LEFT, right);
        let class = if tick.abs() < 1e-9 * x_axis.step() { "zero" } else { "grid" };
        svg.line(class, (at, TOP), (at, bottom));
        svg.text("small", (at, bottom + 17.0), Anchor::Middle, &number::fixed(tick, x_axis.decimals));
    }
    let middle = ((LEFT + right) / 2.0, bottom + 37.0);
    svg.text("muted small", middle, Anchor::Middle, &head(x, &x_scale));
    let place = |(a, b): (f64, f64)| {
        (x_axis.place(a / x_scale.divisor, LEFT, right), y_axis.place(b / y_scale.divisor, bottom, TOP))
    };
    for &(a, b) in &behind {
        let at = place((a, b));
        if (LEFT..=right).contains(&at.0) && (TOP..=bottom).contains(&at.1) {
            svg.circle("muted", at, 1.3);
        }
    }
    let edge = edge(&points);
    let mut line = Vec::with_capacity(2 * edge.len());
    for (k, &index) in edge.iter().enumerate() {
        let at = place(points[index]);
        if k > 0 {
            line.push((at.0, place(points[edge[k - 1]]).1));
        }
        line.push(at);
    }
    svg.path("thin", &Path::through(line));
    for (index, &point) in points.iter().enumerate() {
        if !edge.contains(&index) {
            svg.circle("thin", place(point), 2.8);
        }
    }
    for &index in &edge {
        svg.circle("bar1", place(points[index]), 4.0);
    }
    if let Some(given) = given {
        svg.circle("ring", place(given), 8.0);
    }
    for &index in numbered(&edge).iter() {
        let at = place(points[index]);
        // Inwards, so that no number leaves the plot.
        let (anchor, shift) = if at.0 > 0.7 * right { (Anchor::End, -9.0) } else { (Anchor::Start, 9.0) };
        svg.text("small halo", (at.0 + shift, at.1 - 7.0), anchor, &layouts[index].number.to_string());
    }
    let description = format!(
        "{} over {}: {} layouts, {} of them unbeaten in the two alone.",
        head(y, &y_scale),
        head(x, &x_scale),
        points.len(),
        edge.len()
    );
    Panel::new(svg, description)
}

/// Pareto-optimal points in both coordinates, from left to right; of equal ones the first.
fn edge(points: &[(f64, f64)]) -> Vec<usize> {
    let largest = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).fold(0.0, f64::max);
    let step = [1e-9 * largest(|p| p.0), 1e-9 * largest(|p| p.1)];
    let steps = |value: f64, step: f64| if step > 0.0 { (value / step).round() as i64 } else { 0 };
    let mut order: Vec<(i64, i64, usize)> = points
        .iter()
        .enumerate()
        .map(|(index, point)| (steps(point.0, step[0]), steps(point.1, step[1]), index))
        .collect();
    order.sort_unstable();
    let mut lowest = i64::MAX;
    let mut edge = Vec::new();
    for (_, b, index) in order {
        if b < lowest {
            lowest = b;
            edge.push(index);
        }
    }
    edge
}

/// Some of the points, both ends among them.
fn numbered(edge: &[usize]) -> Vec<usize> {
    let count = edge.len().min(NUMBERED);
    let at = |k: usize| if count > 1 { k * (edge.len() - 1) / (count - 1) } else { 0 };
    (0..count).map(|k| edge[at(k)]).collect()
}

#[cfg(test)]
mod tests {
    use super::{edge, numbered};

    #[test]
    fn the_edge_holds_what_nothing_beats_in_two_objectives() {
        let points =
            [(3.0, 1.0), (1.0, 3.0), (2.0, 2.0), (2.0, 2.0), (3.0, 3.0), (1.0, 4.0), (0.5, 3.0 + 1e-12)];
        // Equal to a billionth is equal, and the first of equal ones stands for them.
        assert_eq!(edge(&points), [6, 2, 0]);
        assert_eq!(edge(&[(0.0, 0.0); 3]), [0]);
    }

    #[test]
    fn both_ends_are_numbered() {
        let edge: Vec<usize> = (0..40).collect();
        assert_eq!(numbered(&edge), [0, 7, 15, 23, 31, 39]);
        assert_eq!(numbered(&[5]), [5]);
        assert!(numbered(&[]).is_empty());
    }
}
