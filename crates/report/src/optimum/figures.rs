//! What an optimum does over the crank angle.

use crate::engine::crank_view::crank_view;
use crate::kit::figure::{Figure, Panel};
use crate::kit::magnitude::Magnitude;
use crate::kit::plot::{AnglePlot, Series};
use crate::loads::share_plot::share_plots;
use lanchester_balance::{Active, Answer};
use lanchester_mechanism::Loads;
use lanchester_model::Engine;
use lanchester_results::Trace;
use lanchester_task::{Criterion, Load, criterion_name, criterion_unit};

/// All pictures of an answer: its loads over the crank angle, the crank with the weights that were found, and what each
/// throw and each device adds. `before`: loads as the file stands, `after`: those of `fitted`, the engine with the answer.
pub fn optimum_figures(
    engine: &Engine,
    answer: &Answer,
    before: &Loads,
    fitted: &Engine,
    after: &Loads,
) -> Vec<Figure> {
    let of_devices = crank_view(fitted).into_iter().chain(share_plots(fitted, after)).map(|figure| Figure {
        id: format!("optimum-{}", figure.id),
        title: format!("{}, at the optimum", figure.title),
        ..figure
    });
    optimum_plots(engine, answer, before, after).into_iter().chain(of_devices).collect()
}

/// Every stage's load over the crank angle, as the file stands and with the answer, with dots where it stands at its
/// peak and holds the optimum up; where orders had to vanish, the loads that they are part of. Criteria that are no force,
/// couple or roll moment of the block are left out.
fn optimum_plots(engine: &Engine, answer: &Answer, before: &Loads, after: &Loads) -> Option<Figure> {
    let of_stages = answer.stages.iter().flat_map(|s| s.terms.iter().map(move |t| (t.0, &s.active[..])));
    let of_orders = answer.cancellation.iter().flat_map(|c| &c.orders).filter_map(|o| match o.criterion {
        Criterion::Order(load, _) => Some((Criterion::Peak(load), &[][..])),
        _ => None,
    });
    let mut drawn: Vec<Criterion> = Vec::new();
    let mut panels = Vec::new();
    for (criterion, active) in of_stages.chain(of_orders) {
        let Criterion::Peak(load) = criterion else { continue };
        if drawn.contains(&criterion) {
            continue;
        }
        if let (Some(old), Some(new)) = (amount(load, &before.total.trace), amount(load, &after.total.trace))
        {
            drawn.push(criterion);
            let highest = old.iter().chain(&new).fold(0.0f64, |most, value| most.max(*value));
            let magnitude = Magnitude::of(before);
            if highest <= magnitude.noise_of_unit(criterion_unit(&criterion)) {
                continue;
            }
            panels.push(panel(engine, active, criterion, (before, &old), (after, &new)));
        }
    }
    (!panels.is_empty()).then(|| Figure {
        id: "optimum".to_owned(),
        title: "The optimum over the cycle".to_owned(),
        caption: match answer.cancellation {
            None => {
                "Amount of the load as given and with the answer. Dots: the crank angles that hold the \
                 optimum up; lowering the load at one of them raises it at another."
            }
            Some(_) => {
                "Amount of the load as given and with the answer, all orders together: those that were not \
                 to vanish stay."
            }
        }
        .to_owned(),
        columns: panels.len().min(2),
        panels,
    })
}

fn panel(
    engine: &Engine,
    active: &[Active],
    criterion: Criterion,
    (before, old): (&Loads, &[f64]),
    (after, new): (&Loads, &[f64]),
) -> Panel {
    // Shafts of another speed ratio change the period: the shorter curve repeats.
    let longer = if before.period > after.period { before } else { after };
    let theta = &longer.total.trace.theta;
    let repeated =
        |curve: &[f64]| -> Vec<f64> { (0..theta.len()).map(|k| curve[k % curve.len().max(1)]).collect() };
    let (old, new) = (repeated(old), repeated(new));
    let unit = criterion_unit(&criterion);
    let active = active.iter().filter(|a| a.criterion == criterion && a.multiplier > 0.0);
    let step = longer.period / theta.len() as f64;
    let marks: Vec<(f64, f64)> = active
        .map(|a| {
            let angle = a.theta.rem_euclid(longer.period);
            (angle, new[((angle / step).round() as usize) % new.len()])
        })
        .collect();
    AnglePlot {
        quantity: &criterion_name(&criterion, engine),
        unit,
        theta,
        period: longer.period,
        series: vec![
            Series { name: "with the answer".to_owned(), style: 0, values: &new },
            Series { name: "as given".to_owned(), style: 2, values: &old },
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
        Load::MountForce(_)
        | Load::LargestMountForce
        | Load::MountForceWithGas(_)
        | Load::LargestMountForceWithGas
        | Load::MainLoad(_)
        | Load::LargestMainLoad
        | Load::BendingMoment => None,
    }
}
