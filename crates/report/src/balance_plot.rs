//! What an optimum does over the crank angle, and how the crank's unbalance was chosen.

use crate::axis::Axis;
use crate::figure::{Figure, Panel};
use crate::number::{self, Scale};
use crate::plot::{AnglePlot, Series};
use crate::svg::{Anchor, Path, Svg};
use lanchester_balance::{Answer, CrankLoad, CrankSweep, FoundStage};
use lanchester_mechanism::{Loads, Trace};
use lanchester_model::{Criterion, Engine, Load, criterion_name};

/// Every stage's load over the crank angle, as the file stands and with the answer, with dots where it stands at its
/// peak and holds the optimum up. Criteria that are no force, couple or roll moment of the block are left out.
pub fn optimum_plots(engine: &Engine, answer: &Answer, before: &Loads, after: &Loads) -> Option<Figure> {
    let mut drawn: Vec<Criterion> = Vec::new();
    let mut panels = Vec::new();
    for stage in &answer.stages {
        for (criterion, _) in &stage.terms {
            let Criterion::Peak(load) = criterion else { continue };
            if drawn.contains(criterion) {
                continue;
            }
            if let (Some(old), Some(new)) =
                (amount(*load, &before.total.trace), amount(*load, &after.total.trace))
            {
                drawn.push(*criterion);
                panels.push(panel(engine, stage, *criterion, (before, &old), (after, &new)));
            }
        }
    }
    (!panels.is_empty()).then(|| Figure {
        id: "optimum".to_owned(),
        title: "The optimum over the cycle".to_owned(),
        caption:
            "Amount of the load as the file stands and with the answer. Dots: the crank angles that hold the \
                  optimum up; lowering the load at one of them raises it at another."
                .to_owned(),
        columns: panels.len().min(2),
        panels,
    })
}

fn panel(
    engine: &Engine,
    stage: &FoundStage,
    criterion: Criterion,
    (before, old): (&Loads, &[f64]),
    (after, new): (&Loads, &[f64]),
) -> Panel {
    // A device of another speed ratio may lengthen the period: the shorter curve repeats.
    let theta = &after.total.trace.theta;
    let repeated: Vec<f64> = (0..theta.len()).map(|k| old[k % old.len().max(1)]).collect();
    let unit = lanchester_model::criterion_unit(&criterion);
    let active = stage.active.iter().filter(|a| a.criterion == criterion && a.multiplier > 0.0);
    let step = after.period / theta.len() as f64;
    let marks: Vec<(f64, f64)> = active
        .map(|a| {
            let angle = a.theta.rem_euclid(after.period);
            (angle, new[((angle / step).round() as usize) % new.len()])
        })
        .collect();
    debug_assert!(before.period <= after.period);
    AnglePlot {
        quantity: &criterion_name(&criterion, engine),
        unit,
        theta,
        period: after.period,
        series: vec![
            Series { name: "with the answer".to_owned(), style: 0, values: new },
            Series { name: "as the file stands".to_owned(), style: 2, values: &repeated },
        ],
    }
    .panel_with_marks(&marks)
}

/// The amount that a criterion judges, over the trace.
fn amount(load: Load, trace: &Trace) -> Option<Vec<f64>> {
    let resultant = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x.hypot(*y)).collect();
    let absolute = |values: &[f64]| values.iter().map(|v| v.abs()).collect();
    match load {
        Load::Force => Some(resultant(&trace.force_x, &trace.force_y)),
        Load::Couple => Some(resultant(&trace.couple_x, &trace.couple_y)),
        Load::ForceX => Some(absolute(&trace.force_x)),
        Load::ForceY => Some(absolute(&trace.force_y)),
        Load::CoupleX => Some(absolute(&trace.couple_x)),
        Load::CoupleY => Some(absolute(&trace.couple_y)),
        Load::RollMoment => Some(absolute(&trace.roll_moment)),
        Load::MountForce(_) | Load::LargestMountForce | Load::BendingMoment => None,
    }
}

const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 330.0;
const LEFT: f64 = 64.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 44.0;
const BOTTOM: f64 = 48.0;

/// The largest load over the unbalance of the crank: the sweep's curve, its best step, and the true optimum
/// `(unbalance of throw 1 [kg m], peak [N] or [N m])` of the same weights.
pub fn sweep_plot(sweep: &CrankSweep, optimum: Option<(f64, f64)>) -> Figure {
    let (quantity, unit) = match sweep.load {
        CrankLoad::Force => ("Largest force", "N"),
        CrankLoad::Couple => ("Largest couple", "N m"),
    };
    let highest = sweep.steps.iter().fold(0.0f64, |m, s| m.max(s.criterion));
    let scale = Scale::of(highest, unit);
    let most = sweep.steps.last().map_or(0.0, |s| s.unbalance);
    let x_scale = if most >= 0.1 { (1e3, "kg mm") } else { (1e6, "g mm") };
    let values = Axis::of(0.0, highest / scale.divisor, 6);
    let amounts = Axis::of(0.0, most * x_scale.0, 7);

    let mut svg = Svg::new(WIDTH, HEIGHT);
    let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
    let place = |(unbalance, value): (f64, f64)| {
        (amounts.place(unbalance * x_scale.0, LEFT, right), values.place(value / scale.divisor, bottom, TOP))
    };
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("{quantity} [{}]", scale.unit));
    for &tick in &values.ticks {
        let y = values.place(tick, bottom, TOP);
        svg.line(if tick == 0.0 { "zero" } else { "grid" }, (LEFT, y), (right, y));
        svg.text("small", (LEFT - 6.0, y + 4.0), Anchor::End, &number::fixed(tick, values.decimals));
    }
    for &tick in &amounts.ticks {
        let x = amounts.place(tick, LEFT, right);
        svg.line("grid", (x, TOP), (x, bottom));
        svg.text("small", (x, bottom + 17.0), Anchor::Middle, &number::fixed(tick, amounts.decimals));
    }
    let below = format!("counterweight of throw 1 [{}]", x_scale.1);
    svg.text("muted small", ((LEFT + right) / 2.0, bottom + 38.0), Anchor::Middle, &below);
    let stride = sweep.steps.len().div_ceil(600).max(1);
    let curve = sweep.steps.iter().step_by(stride).chain(sweep.steps.last());
    svg.path("s0", &Path::through(curve.map(|s| place((s.unbalance, s.criterion)))));

    let best = sweep.best();
    let value = |v: f64| format!("{} {}", number::short(v / scale.divisor, 6), scale.unit);
    let mut marks = vec![
        (sweep.basic, "rotating masses only".to_owned(), "dot"),
        (best, format!("best step of the sweep {}", value(best.criterion)), "dot"),
    ];
    if let Some((unbalance, criterion)) = optimum {
        let swept = lanchester_balance::SweptCrank { unbalance, criterion };
        marks.push((swept, format!("true optimum {}", value(criterion)), "pin"));
    }
    for (row, (swept, label, class)) in marks.iter().enumerate() {
        let at = place((swept.unbalance, swept.criterion));
        svg.circle(class, at, if *class == "pin" { 6.0 } else { 3.6 });
        // Labels stand in a column over the curve's valley, each joined to its dot.
        let beside = if at.0 > 0.55 * WIDTH { Anchor::End } else { Anchor::Start };
        let label_at = match row {
            0 => (at.0 + if beside == Anchor::End { -9.0 } else { 9.0 }, at.1 - 8.0),
            row => (at.0, (at.1 - 16.0 - 20.0 * row as f64).max(TOP + 14.0 * row as f64)),
        };
        let anchor = if row == 0 { beside } else { Anchor::Middle };
        if row > 0 {
            svg.line("dimension", (at.0, at.1 - 6.0), (label_at.0, label_at.1 + 4.0));
        }
        svg.text("small halo", label_at, anchor, label);
    }
    let description = format!(
        "{quantity} over the counterweight of throw 1: smallest {} at {} {}.",
        value(best.criterion),
        number::short(best.unbalance * x_scale.0, 5),
        x_scale.1
    );
    Figure {
        id: "crank-sweep".to_owned(),
        title: "Choosing the crank's counterweights".to_owned(),
        caption: format!(
            "{quantity} over the cycle against the unbalance of equal counterweights opposite every throw. The sweep \
             takes steps of {} g mm and whole degrees of the crank; the true optimum knows neither.",
            number::trimmed(1e6 * sweep.step, 3)
        ),
        panels: vec![Panel::new(svg, description)],
        columns: 1,
    }
}
