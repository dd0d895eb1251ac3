//! Force, couple, roll moment and torque over the crank angle, with their parts and orders overlaid.

use crate::kit::figure::{Figure, Panel};
use crate::kit::magnitude::Magnitude;
use crate::kit::number;
use crate::kit::plot::{AnglePlot, Series};
use crate::loads::component::Component;
use lanchester_mechanism::{Loads, Part};
use lanchester_results::LoadSet;
use num_complex::Complex64;

/// The components that matter, each split by kind of part and by order, then the resultants.
///
/// Components that vanish with all their parts have no figure; [`vanishing`] names them.
pub fn over_angle(loads: &Loads) -> Vec<Figure> {
    let magnitude = Magnitude::of(loads);
    let mut figures = Vec::new();
    for component in Component::ALL {
        if matters(loads, component, &magnitude) {
            figures.push(by_part(loads, component, &magnitude));
            figures.extend(by_order(loads, component, &magnitude));
        }
    }
    figures.extend(resultants(loads, &magnitude));
    figures
}

/// Forces, couples and roll moment that matter, each split by kind of part, then the resultants, as drawings alone.
pub(crate) fn part_panels(loads: &Loads) -> Vec<Panel> {
    let magnitude = Magnitude::of(loads);
    let shown = |c: &Component| *c != Component::Torque && matters(loads, *c, &magnitude);
    let parts = Component::ALL.into_iter().filter(shown).map(|c| by_part(loads, c, &magnitude));
    parts.chain(resultants(loads, &magnitude)).flat_map(|figure| figure.panels).collect()
}

/// Names of the components that vanish with all their parts.
pub fn vanishing(loads: &Loads) -> Vec<&'static str> {
    let magnitude = Magnitude::of(loads);
    let gone = |c: &Component| !matters(loads, *c, &magnitude);
    Component::ALL.into_iter().filter(gone).map(Component::name).collect()
}

fn matters(loads: &Loads, component: Component, magnitude: &Magnitude) -> bool {
    let noise = component.noise(magnitude);
    std::iter::once(&loads.total)
        .chain(loads.parts.iter().map(|p| &p.loads))
        .any(|set| component.extremes(&set.peaks).max_abs() > noise)
}

fn by_part(loads: &Loads, component: Component, magnitude: &Magnitude) -> Figure {
    let noise = component.noise(magnitude);
    let mut series = vec![whole(&loads.total, component)];
    let present = |set: &LoadSet| component.extremes(&set.peaks).max_abs() > noise;
    let parts: Vec<_> = loads.parts.iter().filter(|p| present(&p.loads)).collect();
    // A lone part is the whole, unless the total vanishes all the same.
    if parts.len() > 1 {
        series.extend(parts.iter().map(|p| Series {
            name: p.part.name().to_owned(),
            style: part_style(p.part),
            values: component.trace(&p.loads.trace),
        }));
    }
    let caption = match parts.as_slice() {
        [only] => format!("All of it comes from the {} parts.", only.part.name().trim_end_matches(" parts")),
        _ if !present(&loads.total) => "The parts cancel one another: nothing is left.".to_owned(),
        _ => "The whole and what each kind of moving part adds to it.".to_owned(),
    };
    Figure {
        id: format!("{}-by-part", component.id()),
        title: format!("{} by part", component.name()),
        caption,
        panels: vec![plot(loads, component, series).panel()],
        columns: 1,
    }
}

fn by_order(loads: &Loads, component: Component, magnitude: &Magnitude) -> Option<Figure> {
    let noise = component.noise(magnitude);
    let mut orders: Vec<(f64, Complex64)> = loads
        .total
        .orders
        .iter()
        .filter(|o| o.order > 0.0)
        .map(|o| (o.order, component.amplitude(o)))
        .filter(|(_, amplitude)| amplitude.norm() > noise)
        .collect();
    let largest = orders.iter().fold(0.0f64, |m, (_, a)| m.max(a.norm()));
    orders.retain(|(_, amplitude)| amplitude.norm() >= 2e-3 * largest);
    orders.sort_by(|a, b| b.1.norm().total_cmp(&a.1.norm()));
    orders.truncate(4);
    orders.sort_by(|a, b| a.0.total_cmp(&b.0));
    if orders.len() < 2 {
        return None;
    }
    let theta = &loads.total.trace.theta;
    let curves: Vec<Vec<f64>> = orders
        .iter()
        .map(|&(n, c)| theta.iter().map(|t| (c * Complex64::from_polar(1.0, n * t)).re).collect())
        .collect();
    let mut series = vec![whole(&loads.total, component)];
    for (index, ((order, _), values)) in orders.iter().zip(&curves).enumerate() {
        series.push(Series { name: number::order_word(*order), style: index + 1, values });
    }
    Some(Figure {
        id: format!("{}-by-order", component.id()),
        title: format!("{} by order", component.name()),
        caption: "The whole and its largest orders.".to_owned(),
        panels: vec![plot(loads, component, series).panel()],
        columns: 1,
    })
}

fn resultants(loads: &Loads, magnitude: &Magnitude) -> Vec<Figure> {
    let trace = &loads.total.trace;
    let modulus = |x: &[f64], y: &[f64]| -> Vec<f64> { x.iter().zip(y).map(|(x, y)| x.hypot(*y)).collect() };
    let kinds = [
        (
            "force-resultant",
            "Resultant force |F|",
            "N",
            modulus(&trace.force_x, &trace.force_y),
            magnitude.force_noise(),
        ),
        (
            "couple-resultant",
            "Resultant couple |M|",
            "N m",
            modulus(&trace.couple_x, &trace.couple_y),
            magnitude.couple_noise(),
        ),
    ];
    let mut figures = Vec::new();
    for (id, name, unit, values, noise) in kinds {
        if !values.iter().any(|v| *v > noise) {
            continue;
        }
        let series = vec![Series { name: "resultant".to_owned(), style: 0, values: &values }];
        let plot = AnglePlot { quantity: name, unit, theta: &trace.theta, period: loads.period, series };
        figures.push(Figure {
            id: id.to_owned(),
            title: name.to_owned(),
            caption: "Its size at every crank angle, whatever its direction.".to_owned(),
            panels: vec![plot.panel()],
            columns: 1,
        });
    }
    figures
}

fn whole(set: &LoadSet, component: Component) -> Series<'_> {
    Series { name: "total".to_owned(), style: 0, values: component.trace(&set.trace) }
}

fn plot<'a>(loads: &'a Loads, component: Component, series: Vec<Series<'a>>) -> AnglePlot<'a> {
    AnglePlot {
        quantity: component.name(),
        unit: component.unit(),
        theta: &loads.total.trace.theta,
        period: loads.period,
        series,
    }
}

fn part_style(part: Part) -> usize {
    match part {
        Part::Reciprocating => 1,
        Part::Rotating => 2,
        Part::Counterweights => 3,
        Part::Shafts => 4,
        Part::RodInertia => 5,
    }
}
