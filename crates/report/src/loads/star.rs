//! Star diagrams: the force (or couple) arrows of all cylinders for one order and one sense, and their sum.

use crate::kit::figure::{Figure, Panel};
use crate::kit::magnitude::Magnitude;
use crate::kit::number::{self, Scale};
use crate::kit::svg::{Anchor, Svg, text_width};
use crate::kit::view::View;
use lanchester_mechanism::Loads;
use lanchester_model::Rotation;
use lanchester_results::OrderLoads;
use num_complex::Complex64;

const WIDTH: f64 = 240.0;
const RADIUS: f64 = 84.0;
const CENTRE: (f64, f64) = (WIDTH / 2.0, 148.0);

/// Stars of the force, for the orders that matter.
pub fn force_stars(loads: &Loads, rotation: Rotation) -> Figure {
    let stars = Stars { unit: "N", noise: Magnitude::of(loads).force_noise(), rotation };
    let panels = stars.panels(loads, |o| (o.force_forward, o.force_backward));
    Figure {
        id: "force-stars".to_owned(),
        title: "Force stars".to_owned(),
        caption: format!(
            "One arrow a cylinder for every order and sense, at θ = 0, seen from the free end; the broad grey arrow is their sum. {TURNING}"
        ),
        panels,
        columns: 4,
    }
}

/// Stars of the couple, for the orders that matter.
pub fn couple_stars(loads: &Loads, rotation: Rotation) -> Figure {
    let stars = Stars { unit: "N m", noise: Magnitude::of(loads).couple_noise(), rotation };
    let panels = stars.panels(loads, |o| (o.couple_forward, o.couple_backward));
    Figure {
        id: "couple-stars".to_owned(),
        title: "Couple stars".to_owned(),
        caption: format!("The couples of the same arrows about the reference point. {TURNING}"),
        panels,
        columns: 4,
    }
}

const TURNING: &str = "The whole star turns at its order's multiple of the crank's speed, so what cancels here cancels always. Arrows that nearly coincide are drawn once. \
                       Counterweights and balance shafts are left out.";

/// Cylinders whose arrows nearly coincide.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Bundle {
    /// Cylinder numbers.
    pub numbers: Vec<usize>,
    /// The arrow of the first of them.
    pub arrow: Complex64,
}

/// Tips nearer than this [px] are not told apart in a drawing.
const NEAR: f64 = 7.0;

/// Bundles arrows whose tips nearly coincide on the screen.
pub(crate) fn bundles(arrows: impl IntoIterator<Item = (usize, Complex64)>, view: &View) -> Vec<Bundle> {
    let arrows: Vec<(usize, Complex64)> = arrows.into_iter().filter(|(_, a)| a.is_finite()).collect();
    let mut out: Vec<Bundle> = Vec::new();
    for (number, arrow) in arrows {
        match out.iter_mut().find(|b| (b.arrow - arrow).norm() * view.scale < NEAR) {
            Some(bundle) => bundle.numbers.push(number),
            None => out.push(Bundle { numbers: vec![number], arrow }),
        }
    }
    out
}

/// Orders of the cylinders' forces that matter, rising; the largest four at most.
pub(crate) fn told_orders(loads: &Loads) -> Vec<f64> {
    let mut orders = orders_that_matter(loads, OrderLoads::force_peak, Magnitude::of(loads).force_noise());
    orders.truncate(4);
    orders.sort_by(|a, b| a.0.total_cmp(&b.0));
    orders.into_iter().map(|o| o.0).collect()
}

/// Orders with the largest size that any cylinder has there, the largest first.
fn orders_that_matter(loads: &Loads, size: impl Fn(&OrderLoads) -> f64, noise: f64) -> Vec<(f64, f64)> {
    let mut orders: Vec<(f64, f64)> = Vec::new();
    for order in loads.cylinders.iter().flat_map(|c| &c.loads.orders).filter(|o| o.order > 0.0) {
        let size = size(order);
        match orders.iter_mut().find(|(n, _)| (*n - order.order).abs() < 1e-9) {
            Some(entry) => entry.1 = entry.1.max(size),
            None => orders.push((order.order, size)),
        }
    }
    let largest = orders.iter().fold(0.0f64, |m, o| m.max(o.1));
    orders.retain(|o| o.1 > noise && o.1 >= 3e-3 * largest);
    orders.sort_by(|a, b| b.1.total_cmp(&a.1));
    orders
}

struct Stars {
    unit: &'static str,
    noise: f64,
    rotation: Rotation,
}

impl Stars {
    fn panels(&self, loads: &Loads, of: impl Fn(&OrderLoads) -> (Complex64, Complex64)) -> Vec<Panel> {
        let size = |o: &OrderLoads| of(o).0.norm() + of(o).1.norm();
        let mut orders = orders_that_matter(loads, size, self.noise);
        let largest = orders.iter().fold(0.0f64, |m, o| m.max(o.1));
        orders.truncate(4);
        orders.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut panels = Vec::with_capacity(2 * orders.len());
        for (order, _) in orders {
            for forward in [true, false] {
                let arrows = loads.cylinders.iter().filter_map(|c| {
                    let entry = c.loads.orders.iter().find(|o| (o.order - order).abs() < 1e-9)?;
                    Some((c.cylinder, if forward { of(entry).0 } else { of(entry).1 }))
                });
                panels.push(self.panel(order, forward, &arrows.collect::<Vec<_>>(), largest));
            }
        }
        panels
    }

    fn panel(&self, order: f64, forward: bool, arrows: &[(usize, Complex64)], largest: f64) -> Panel {
        let present: Vec<(usize, Complex64)> =
            arrows.iter().copied().filter(|(_, a)| a.norm() > self.noise.max(1e-6 * largest)).collect();
        let sum: Complex64 = present.iter().map(|(_, a)| a).sum();
        let longest = present.iter().fold(0.0f64, |m, (_, a)| m.max(a.norm()));
        let cancels = sum.norm() <= self.noise.max(1e-6 * longest);
        // Small arrows under a long sum would be dots: the sum has its own scale then, and the picture says so.
        let own_scale = sum.norm() > 6.0 * longest;
        let reach = if own_scale { 2.0 * longest } else { longest.max(sum.norm()) };
        let mut svg = Svg::new(WIDTH, if own_scale { 290.0 } else { 276.0 });
        let sense = if forward { "with the crank" } else { "against the crank" };
        let mut title = number::order_word(order);
        title[..1].make_ascii_uppercase();
        svg.text("strong", (CENTRE.0, 16.0), Anchor::Middle, &title);
        svg.text("muted small", (CENTRE.0, 33.0), Anchor::Middle, sense);
        svg.circle("grid", CENTRE, RADIUS);
        svg.line("grid", (CENTRE.0 - RADIUS, CENTRE.1), (CENTRE.0 + RADIUS, CENTRE.1));
        svg.line("grid", (CENTRE.0, CENTRE.1 - RADIUS), (CENTRE.0, CENTRE.1 + RADIUS));

        let view = View::new(self.rotation, CENTRE, RADIUS / reach.max(f64::MIN_POSITIVE));
        if !cancels && longest > 0.0 {
            let scale = if own_scale { RADIUS / sum.norm() } else { view.scale };
            svg.arrow("arrow sum", CENTRE, View { scale, ..view }.at(sum), 17.0);
        }
        draw_fan(
            &mut svg,
            &view,
            &bundles(present.iter().copied(), &view),
            CENTRE.0,
            if cancels { Complex64::default() } else { sum },
        );
        svg.circle("dot", CENTRE, 2.5);

        let scale = Scale::of(sum.norm(), self.unit);
        let (words, description) = if present.is_empty() {
            ("none".to_owned(), format!("{title} {sense}: no arrows."))
        } else if cancels {
            ("sum 0".to_owned(), format!("{title} {sense}: the arrows of all cylinders cancel."))
        } else {
            let value = format!("{} {}", number::short(sum.norm() / scale.divisor, 4), scale.unit);
            (format!("sum {value}"), format!("{title} {sense}: the arrows add up to {value}."))
        };
        svg.text("strong", (CENTRE.0, 268.0), Anchor::Middle, &words);
        if own_scale {
            svg.text("muted small", (CENTRE.0, 284.0), Anchor::Middle, "sum drawn shorter");
        }
        Panel::new(svg, description)
    }
}

/// Draws bundled arrows from the centre, those of one direction side by side, each with its numbers at the tip,
/// not farther than `room` [px] from the centre. Labels keep off the broad arrow of `sum`.
pub(crate) fn draw_fan(svg: &mut Svg, view: &View, bundles: &[Bundle], room: f64, sum: Complex64) {
    let mut drawn: Vec<Complex64> = Vec::new();
    let mut labels: Vec<(f64, f64, f64)> = Vec::new();
    for bundle in bundles {
        let unit = bundle.arrow / bundle.arrow.norm().max(f64::MIN_POSITIVE);
        let beside = drawn.iter().filter(|d| (**d - unit).norm() < 0.05).count();
        drawn.push(unit);
        // 0, +1, -1, +2, ... steps to the side.
        let step = if beside % 2 == 1 { beside.div_ceil(2) as f64 } else { -((beside / 2) as f64) };
        let (ux, uy) = View { scale: 1.0, ..*view }.span(unit);
        let shift = (-uy * 5.0 * step, ux * 5.0 * step);
        let tip = view.at(bundle.arrow);
        let from = (view.centre.0 + shift.0, view.centre.1 + shift.1);
        let to = (tip.0 + shift.0, tip.1 + shift.1);
        svg.arrow("arrow a1", from, to, 10.0);
        let label = number::list(&bundle.numbers);
        let half = 0.5 * text_width(&label, 12.0);
        let gap = 8.0 + ux.abs() * half;
        let side = 9.0 * step.signum() * f64::from(u8::from(step != 0.0));
        // A label at the tip would lie on the broad arrow of a longer sum: it goes beside.
        if step == 0.0 && (sum * unit.conj()).re > 0.95 * sum.norm() && sum.norm() > 1.3 * bundle.arrow.norm()
        {
            let out = 10.0 + uy.abs() * half;
            svg.text("small strong halo", (to.0 - uy * out, to.1 + ux * out + 4.0), Anchor::Middle, &label);
            continue;
        }
        let (left, right) = (view.centre.0 - room + half, view.centre.0 + room - half);
        let mut at = (to.0 + ux * gap - uy * side, to.1 + uy * (gap + 2.0) + ux * side + 4.0);
        // Outwards until it covers no other label; a dozen steps reach past any of them.
        for _ in 0..12 {
            at.0 = at.0.min(right).max(left);
            if !labels.iter().any(|(x, y, other)| (x - at.0).abs() < half + other && (y - at.1).abs() < 12.0)
            {
                break;
            }
            at = (at.0 + 4.0 * ux, at.1 + if uy.abs() < 0.3 { 4.0 } else { 4.0 * uy });
        }
        labels.push((at.0, at.1, half));
        svg.text("small strong halo", at, Anchor::Middle, &label);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_arrows_are_bundled() {
        let arrow = |degrees: f64| Complex64::from_polar(10.0, degrees.to_radians());
        let view = View::new(Rotation::Clockwise, CENTRE, 8.0);
        let bundles =
            bundles([(1, arrow(0.0)), (2, arrow(120.0)), (5, arrow(120.01)), (6, arrow(0.0))], &view);
        assert_eq!(bundles.iter().map(|b| number::list(&b.numbers)).collect::<Vec<_>>(), ["1, 6", "2, 5"]);
    }
}
