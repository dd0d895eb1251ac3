//! The largest load over the unbalance of the crank: the published sweep with its optimum and the true one.

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number::{self, Scale};
use crate::kit::plot::{Legend, WIDTH, tick_below};
use crate::kit::svg::{Anchor, Path, Svg};
use lanchester_literature::{CrankLoad, CrankSweep, SweptCrank};

const HEIGHT: f64 = 300.0;
const LEFT: f64 = 60.0;
const RIGHT: f64 = 14.0;
const BOTTOM: f64 = 44.0;

/// The criterion of a sweep over the counterweight of throw 1, with the basic crank, the sweep's optimum and, where it
/// is known, the optimum over the continuous angle.
pub fn crank_curve(sweep: &CrankSweep, optimum: Option<SweptCrank>) -> Figure {
    let best = sweep.best();
    let load = load_name(sweep.load);
    let unit = load_unit(sweep.load);
    let mut caption = format!(
        "The largest {load} against the counterweight of throw 1. The sweep looks at every {} kg m and finds {} kg m.",
        number::trimmed(sweep.step, 3),
        number::fixed(best.unbalance, 5)
    );
    if let Some(true_one) = optimum {
        caption += &format!(
            " Over the continuous angle the optimum is {} kg m with {} {unit}.",
            number::fixed(true_one.unbalance, 7),
            number::short(true_one.criterion, 6)
        );
    }
    Figure {
        id: "crank-sweep".to_owned(),
        title: format!("Largest {load} over the unbalance of the crank"),
        caption,
        panels: std::iter::once(panel(sweep, optimum)).chain(close_up(sweep, optimum)).collect(),
        columns: 2,
    }
}

pub(crate) fn load_name(load: CrankLoad) -> &'static str {
    match load {
        CrankLoad::Force => "resultant force |F|",
        CrankLoad::Couple => "resultant couple |M|",
    }
}

pub(crate) fn load_unit(load: CrankLoad) -> &'static str {
    match load {
        CrankLoad::Force => "N",
        CrankLoad::Couple => "N m",
    }
}

/// The whole curve, as a drawing.
pub(crate) fn panel(sweep: &CrankSweep, optimum: Option<SweptCrank>) -> Panel {
    let mut marks = vec![("basic crank", sweep.basic, 2), ("sweep", sweep.best(), 1)];
    marks.extend(optimum.map(|o| ("true optimum", o, 3)));
    // More points than pixels would not be seen; the corner at the optimum always is.
    let stride = (sweep.steps.len() / 400).max(1);
    let mut points: Vec<SweptCrank> = sweep.steps.iter().step_by(stride).copied().collect();
    points.extend(sweep.steps.last());
    points.push(sweep.best());
    points.sort_by(|a, b| a.unbalance.total_cmp(&b.unbalance));
    let most = points.iter().map(|s| s.criterion).fold(sweep.basic.criterion, f64::max);
    let widest = points.last().map_or(0.0, |s| s.unbalance).max(sweep.basic.unbalance);
    draw(sweep.load, &points, &marks, [0.0, widest], [0.0, most], false)
}

/// Steps on each side of the best one in the close-up.
const BESIDE: usize = 8;
/// Furthest that the close-up reaches for the true optimum.
const FURTHEST: usize = 60;

/// The curve around its lowest point, step by step; `None` where the whole curve shows that already, or the true optimum
/// stands too far off.
pub(crate) fn close_up(sweep: &CrankSweep, optimum: Option<SweptCrank>) -> Option<Panel> {
    let best = sweep.best();
    let middle = (best.unbalance / sweep.step).round() as usize;
    let apart = optimum.map_or(0, |o| ((o.unbalance - best.unbalance).abs() / sweep.step).ceil() as usize);
    let reach = BESIDE.max(apart + apart / 4 + 1);
    if apart > FURTHEST || sweep.steps.len() < 4 * reach {
        return None;
    }
    let end = (middle + reach).min(sweep.steps.len() - 1);
    let points = &sweep.steps[middle.saturating_sub(reach)..=end];
    let mut marks = vec![("sweep", best, 1)];
    marks.extend(optimum.map(|o| ("true optimum", o, 3)));
    let criteria = || points.iter().chain(&optimum).map(|s| s.criterion);
    let low = criteria().fold(f64::INFINITY, f64::min);
    let high = criteria().fold(f64::NEG_INFINITY, f64::max);
    let ends = [points.first()?.unbalance, points.last()?.unbalance];
    Some(draw(sweep.load, points, &marks, ends, [low, high], true))
}

/// Points of the curve with marked cranks: name, place and line style.
fn draw(
    load: CrankLoad,
    points: &[SweptCrank],
    marks: &[(&str, SweptCrank, usize)],
    [narrowest, widest]: [f64; 2],
    [least, most]: [f64; 2],
    dots: bool,
) -> Panel {
    let scale = Scale::of(most, load_unit(load));
    let values = Axis::of(least / scale.divisor, most / scale.divisor, 6);
    let amounts = if dots { Axis::of(narrowest, widest, 4) } else { Axis::of(narrowest, widest, 5) };
    let curve = if dots { "every step" } else { "every crank" };
    let mut names = vec![(curve.to_owned(), 0)];
    names.extend(marks.iter().map(|(name, _, style)| ((*name).to_owned(), *style)));
    let legend = Legend::of(&names, 4.0, WIDTH + 10.0);
    let top = 26.0 + legend.height;
    let mut svg = Svg::new(WIDTH, HEIGHT + legend.height);
    let (right, bottom) = (WIDTH - RIGHT, svg.height - BOTTOM);
    let quantity = match (load, dots) {
        (CrankLoad::Force, false) => "Largest |F|",
        (CrankLoad::Couple, false) => "Largest |M|",
        (CrankLoad::Force, true) => "Largest |F| near the optimum",
        (CrankLoad::Couple, true) => "Largest |M| near the optimum",
    };
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("{quantity} [{}]", scale.unit));
    legend.draw(&mut svg);
    for &tick in &values.ticks {
        let y = values.place(tick, bottom, top);
        svg.line(if tick == 0.0 { "zero" } else { "grid" }, (LEFT, y), (right, y));
        svg.text("small", (LEFT - 6.0, y + 4.0), Anchor::End, &number::fixed(tick, values.decimals));
    }
    for &tick in &amounts.ticks {
        let x = amounts.place(tick, LEFT, right);
        svg.line("grid", (x, top), (x, bottom));
        tick_below(&mut svg, (x, bottom), &number::fixed(tick, amounts.decimals));
    }
    let middle = (LEFT + right) / 2.0;
    svg.text("muted small", (middle, bottom + 37.0), Anchor::Middle, "counterweight of throw 1 [kg m]");
    let place = |crank: &SweptCrank| {
        (
            amounts.place(crank.unbalance, LEFT, right),
            values.place(crank.criterion / scale.divisor, bottom, top),
        )
    };
    svg.path("s0", &Path::through(points.iter().map(place)));
    if dots {
        points.iter().for_each(|step| svg.circle("dot", place(step), 1.8));
    }
    for (_, crank, style) in marks {
        let (x, y) = place(crank);
        svg.line(&format!("s{style}"), (x, y), (x, bottom));
        svg.circle("dot", (x, y), 3.4);
    }
    let said: Vec<String> = marks
        .iter()
        .map(|(name, crank, _)| {
            format!(
                "{name} {} kg m with {} {}",
                number::fixed(crank.unbalance, 5),
                number::short(crank.criterion / scale.divisor, 5),
                scale.unit
            )
        })
        .collect();
    let description = format!("{quantity}, over the counterweight of throw 1: {}.", said.join("; "));
    Panel::new(svg, description)
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_file::{read, template};
    use lanchester_literature::{SweepOptions, sweep};
    use lanchester_mechanism::Kinematics;

    #[test]
    fn both_optima_are_drawn_and_told() {
        let text = template("single").expect("it is in the gallery").text;
        let engine = read(text).engine().expect("it is valid");
        let swept = sweep(&engine, CrankLoad::Force, Kinematics::Exact, &SweepOptions::default());
        let swept = swept.expect("a single can be swept");
        let alone = crank_curve(&swept, None);
        assert!(
            !alone.caption.contains("continuous") && !alone.panels[0].description.contains("true optimum")
        );
        let both = crank_curve(&swept, Some(swept.best()));
        assert!(both.caption.contains("continuous") && both.panels[0].description.contains("true optimum"));
        assert!(both.panels.len() == 2 && both.panels[1].description.contains("near the optimum"));
        // An optimum half the axis away is no matter for a close-up.
        let far = SweptCrank { unbalance: 0.0, ..swept.best() };
        assert_eq!(crank_curve(&swept, Some(far)).panels.len(), 1);
    }
}
