//! Balance plots: each throw's share, each device's share and what is left, by axis, over the crank angle.
//!
//! As in the matrix-based crankshaft balancing tool, Applied Sciences 2021, 11, 8997, Figures 12, 13, 15 and 16.

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::magnitude::Magnitude;
use crate::kit::number::{self, Scale};
use crate::kit::plot::{BOTTOM, HEIGHT, LEFT, Legend, RIGHT, WIDTH, value_axis};
use crate::kit::svg::{Anchor, Path, Svg, text_width};
use crate::loads::component::Component;
use crate::loads::share::{Share, Source, Turning, resultant, turning_masses, whole_order};
use lanchester_mechanism::Loads;
use lanchester_model::Engine;
use num_complex::Complex64;

/// Points of a curve over one revolution.
const POINTS: usize = 120;

/// The balance plots of an engine with counterweights or balance shafts.
pub fn share_plots(engine: &Engine, loads: &Loads) -> Vec<Figure> {
    let noise = Magnitude::of(loads);
    let mut figures = Vec::new();
    let turns_at = |order: i32| {
        let on = |r: lanchester_model::Ratio| r.denominator() == 1 && r.numerator().abs() == order;
        let weights = engine.counterweights.iter().map(|w| engine.crankshafts[w.crankshaft].ratio);
        (weights.filter(|r| on(*r)).count() > 0, engine.shafts.iter().any(|s| on(s.ratio)))
    };
    let (weighted, first_shafts) = turns_at(1);
    if weighted {
        figures.extend(figure(
            "balance-turning-masses",
            "Turning masses: throws against counterweights",
            "The crank and the big ends of its rods, without pistons.",
            &turning_masses(engine, loads),
            1,
            &noise,
        ));
    }
    if weighted || first_shafts {
        figures.extend(figure(
            "balance-order-1",
            "First order: throws against all devices",
            "With the first order of the pistons.",
            &whole_order(engine, loads, 1),
            1,
            &noise,
        ));
    }
    let (geared, second_shafts) = turns_at(2);
    if geared || second_shafts {
        figures.extend(figure(
            "balance-order-2",
            "Second order: throws against all devices",
            "The second order of the pistons.",
            &whole_order(engine, loads, 2),
            2,
            &noise,
        ));
    }
    figures
}

/// One curve or several that coincide.
struct Curve {
    source: Source,
    numbers: Vec<usize>,
    /// The component is `Re(amplitude e^{i n theta})`.
    amplitude: Complex64,
}

fn figure(
    id: &str,
    title: &str,
    what: &str,
    shares: &[Share],
    order: i32,
    noise: &Magnitude,
) -> Option<Figure> {
    let left = resultant(shares);
    let components = [Component::ForceX, Component::ForceY, Component::CoupleX, Component::CoupleY];
    let panels: Vec<Panel> = components
        .into_iter()
        .filter_map(|component| {
            let limit = 1e3 * component.noise(noise);
            let curves = curves(shares, component, limit);
            let left = amplitude(component, &left);
            let left = if left.norm() > limit { left } else { Complex64::ZERO };
            (!curves.is_empty()).then(|| panel(component, &curves, left, order))
        })
        .collect();
    if panels.is_empty() {
        return None;
    }
    let caption = format!(
        "{what} Numbers at the curves are those of the throws, w and s those of the counterweights and balance shafts in \
         the order of their table. The thick line is their sum: flat at zero where the devices take all of it."
    );
    Some(Figure { id: id.to_owned(), title: title.to_owned(), caption, panels, columns: 2 })
}

/// Amplitude of one component: see [`Component::amplitude`].
fn amplitude(component: Component, turning: &Turning) -> Complex64 {
    let [f, b] = match component {
        Component::ForceX | Component::ForceY => turning.force,
        _ => turning.couple,
    };
    match component {
        Component::ForceX | Component::CoupleX => f + b.conj(),
        _ => Complex64::new(0.0, -1.0) * (f - b.conj()),
    }
}

fn curves(shares: &[Share], component: Component, noise: f64) -> Vec<Curve> {
    let mut curves: Vec<Curve> = Vec::new();
    let largest = shares.iter().fold(0.0f64, |m, s| m.max(amplitude(component, &s.turning).norm()));
    for share in shares {
        let amplitude = amplitude(component, &share.turning);
        if amplitude.norm() <= noise {
            continue;
        }
        let same =
            |c: &&mut Curve| c.source == share.source && (c.amplitude - amplitude).norm() < 1e-3 * largest;
        match curves.iter_mut().find(same) {
            Some(curve) => curve.numbers.push(share.number),
            None => curves.push(Curve { source: share.source, numbers: vec![share.number], amplitude }),
        }
    }
    curves
}

impl Curve {
    fn label(&self) -> String {
        let numbers = number::list(&self.numbers);
        match self.source {
            Source::Throw => numbers,
            Source::Counterweight => format!("w {numbers}"),
            Source::Shaft => format!("s {numbers}"),
        }
    }
}

/// Line style of a source; 0 is the sum.
fn style(source: Source) -> usize {
    match source {
        Source::Throw => 1,
        Source::Counterweight => 2,
        Source::Shaft => 3,
    }
}

fn panel(component: Component, curves: &[Curve], left: Complex64, order: i32) -> Panel {
    let largest = curves.iter().fold(left.norm(), |m, c| m.max(c.amplitude.norm()));
    let scale = Scale::of(largest, component.unit());
    let axis = Axis::of(-largest / scale.divisor, largest / scale.divisor, 6);
    let angles = Axis::stepped(0.0, 360.0, 90.0);
    let mut names = vec![("left".to_owned(), 0)];
    for (source, name) in [
        (Source::Throw, "each throw"),
        (Source::Counterweight, "each counterweight"),
        (Source::Shaft, "each balance shaft"),
    ] {
        if curves.iter().any(|c| c.source == source) {
            names.push((name.to_owned(), style(source)));
        }
    }
    let legend = Legend::of(&names, 4.0, WIDTH + 10.0);
    let top = 26.0 + legend.height;
    let mut svg = Svg::new(WIDTH, HEIGHT + legend.height);
    let (right, bottom) = (WIDTH - RIGHT, svg.height - BOTTOM);
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("{} [{}]", component.name(), scale.unit));
    legend.draw(&mut svg);
    value_axis(&mut svg, &axis, top, bottom);
    for &tick in &angles.ticks {
        let x = angles.place(tick, LEFT, right);
        svg.line("grid", (x, top), (x, bottom));
        svg.text("small", (x, bottom + 17.0), Anchor::Middle, &format!("{tick:.0}"));
    }
    svg.text("muted small", ((LEFT + right) / 2.0, bottom + 37.0), Anchor::Middle, "crank angle θ [deg]");
    let at = |amplitude: Complex64, degrees: f64| {
        let value = (amplitude * Complex64::cis(f64::from(order) * degrees.to_radians())).re;
        (angles.place(degrees, LEFT, right), axis.place(value / scale.divisor, bottom, top))
    };
    let through = |amplitude: Complex64| {
        Path::through((0..=POINTS).map(|k| at(amplitude, 360.0 * k as f64 / POINTS as f64)))
    };
    for curve in curves.iter().rev() {
        svg.path(&format!("s{}", style(curve.source)), &through(curve.amplitude));
    }
    svg.path("s0", &through(left));
    draw_labels(&mut svg, curves, order, (LEFT, right), at);
    let list: Vec<String> = curves
        .iter()
        .map(|c| {
            let kind = match c.source {
                Source::Throw => "throw",
                Source::Counterweight => "counterweight",
                Source::Shaft => "balance shaft",
            };
            let amount = number::short(c.amplitude.norm() / scale.divisor, 3);
            format!("{kind} {} {amount} {}", number::list(&c.numbers), scale.unit)
        })
        .collect();
    let rest = number::short(left.norm() / scale.divisor, 3);
    let description = format!(
        "{} over the crank angle, amplitudes: {}; left {rest} {}.",
        component.name(),
        list.join(", "),
        scale.unit
    );
    Panel::new(svg, description)
}

/// A label at a peak or trough of every curve, where there is room.
fn draw_labels(
    svg: &mut Svg,
    curves: &[Curve],
    order: i32,
    (left, right): (f64, f64),
    at: impl Fn(Complex64, f64) -> (f64, f64),
) {
    let mut taken: Vec<(f64, f64, f64)> = Vec::new();
    for curve in curves {
        let label = curve.label();
        let half = 0.5 * text_width(&label, 14.5) + 2.0;
        let peak = -curve.amplitude.arg().to_degrees() / f64::from(order);
        let step = 180.0 / f64::from(order);
        // Peaks and troughs first, then the slopes beside them.
        let places = [0.0, 1.0, 2.0, 3.0, 0.2, 1.2, -0.2, 0.8, 0.35, 1.35];
        let spot = places.iter().find_map(|k| {
            let degrees = (peak + k * step).rem_euclid(360.0);
            let (x, y) = at(curve.amplitude, degrees);
            let x = x.clamp(left + half, right - half);
            let clash = taken
                .iter()
                .any(|&(other, level, width)| (other - x).abs() < half + width && (level - y).abs() < 15.0);
            (!clash).then_some((x, y))
        });
        if let Some((x, y)) = spot {
            taken.push((x, y, half));
            svg.text("small halo", (x, y + 4.0), Anchor::Middle, &label);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::crank_view::crank_view;
    use lanchester_file::{read, template};
    use lanchester_mechanism::{LoadRequest, loads};

    fn engine(name: &str) -> Engine {
        read(template(name).expect("it is in the gallery").text).engine().expect("it is valid")
    }

    fn plots(engine: &Engine) -> Vec<Figure> {
        let request = LoadRequest { samples: 8, ..LoadRequest::default() };
        share_plots(engine, &loads(engine, &request).expect("it turns"))
    }

    fn ids(figures: &[Figure]) -> Vec<&str> {
        figures.iter().map(|f| f.id.as_str()).collect()
    }

    #[test]
    fn the_balanced_three_leaves_a_flat_line_and_a_lighter_shaft_does_not() {
        let mut three = engine("in-line-3-shaft");
        let figures = plots(&three);
        assert_eq!(ids(&figures), ["balance-turning-masses", "balance-order-1"]);
        assert_eq!(figures[1].panels.len(), 4);
        for panel in &figures[1].panels {
            assert!(panel.description.contains("; left 0 "), "{}", panel.description);
        }
        three = three
            .with(|three| {
                for weight in &mut three.shafts[0].weights {
                    weight.unbalance *= 0.9;
                }
            })
            .expect("an engine");
        let couple = &plots(&three)[1].panels[2].description;
        assert!(!couple.contains("; left 0 ") && couple.contains("balance shaft 1"), "{couple}");
    }

    #[test]
    fn second_order_shafts_have_a_plot_and_an_engine_without_devices_has_none() {
        let four = plots(&engine("in-line-4-lanchester"));
        assert!(ids(&four).contains(&"balance-order-2"), "{:?}", ids(&four));
        let bare = engine("in-line-4").without_counterweights().without_shafts();
        assert!(plots(&bare).is_empty() && crank_view(&bare).is_none());
    }
}
