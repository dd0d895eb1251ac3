//! The story that teachers draw: at a few crank positions, every cylinder's arrow and what they add up to.

use crate::engine::mechanism_sketch::{Bank, banks, bounds, draw_links, draw_piston_numbers, draw_walls};
use crate::kit::figure::{Figure, Panel};
use crate::kit::number::{self, Scale};
use crate::kit::svg::{Anchor, Svg, wrap};
use crate::kit::view::View;
use crate::loads::component::Component;
use crate::loads::star::{Bundle, bundles, draw_fan};
use lanchester_mechanism::{Loads, Part};
use lanchester_model::Engine;
use lanchester_results::{LoadSet, OrderLoads};
use num_complex::Complex64;
use std::f64::consts::TAU;

const WIDTH: f64 = 280.0;
const FRONT: (f64, f64, f64) = (78.0, 118.0, 172.0);
const STRIP: f64 = 98.0;
const DIAL: ((f64, f64), f64) = ((212.0, 100.0), 40.0);

/// Which part of the forces a story tells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Told {
    /// One order.
    Order(f64),
    /// All of it.
    Whole,
}

/// What pulls at one place at one crank angle.
struct Pull {
    /// Cylinder number; 0 for a counterweight or balance shaft.
    cylinder: usize,
    z: f64,
    force: Complex64,
    couple: Complex64,
}

/// A story in six or eight steps; `None` if there is nothing to tell.
pub fn story(engine: &Engine, loads: &Loads, told: Told) -> Option<Figure> {
    let steps = positions(engine);
    let pulls: Vec<Vec<Pull>> = steps.iter().map(|theta| pulls(engine, loads, told, *theta)).collect();
    let all = || pulls.iter().flatten();
    let longest = all().fold(0.0f64, |m, p| m.max(p.force.norm()));
    if longest <= 0.0 || !longest.is_finite() {
        return None;
    }
    let across = all().fold(0.0f64, |m, p| m.max(p.force.im.abs())) > 0.02 * longest;
    let along = all().any(|p| (p.z - loads.reference[2]).abs() > 1e-3);
    let banks = banks(engine);
    let mut scene =
        Scene { engine, banks: &banks, longest, across, along, reference: loads.reference[2], lines: 0 };
    scene.lines = pulls.iter().map(|p| scene.wrapped(p).len()).max().unwrap_or(0);
    let panels: Vec<Panel> =
        steps.iter().zip(&pulls).map(|(theta, pulls)| scene.panel(*theta, pulls)).collect();
    let (id, title) = match told {
        Told::Order(n) => {
            (format!("story-order-{}", number::order(n).replace('.', "-")), number::order_word(n))
        }
        Told::Whole => ("story-whole".to_owned(), "all orders".to_owned()),
    };
    let strips = match along {
        true => {
            " Below it where along the crank they act: free end left, flywheel right; the grey arrows are their sum and, \
                 at the ends, their couple as a pair of forces."
        }
        false => "",
    };
    Some(Figure {
        id,
        title: format!("Step by step: {title}"),
        caption: format!(
            "Crank train from the free end; beside it the arrows of the cylinders (blue, numbered), of counterweights \
             and balance shafts (green) and their sum (broad grey).{strips}"
        ),
        columns: if panels.len() == 6 { 3 } else { 4 },
        panels,
    })
}

/// Steps of 60 degrees where the crank has its throws so, else of 45.
fn positions(engine: &Engine) -> Vec<f64> {
    let whole = |value: f64| (value - value.round()).abs() < 1e-6;
    let sixty = engine.throws.iter().all(|t| whole(6.0 * t.angle / TAU));
    let straight = engine.throws.iter().all(|t| whole(2.0 * t.angle / TAU));
    let count = if sixty && !straight { 6 } else { 8 };
    (0..count).map(|k| TAU * f64::from(k) / f64::from(count)).collect()
}

fn pulls(engine: &Engine, loads: &Loads, told: Told, theta: f64) -> Vec<Pull> {
    let mut out: Vec<Pull> = Vec::with_capacity(loads.cylinders.len() + engine.counterweights.len());
    for cylinder in &loads.cylinders {
        let Some(place) = engine.cylinders.get(cylinder.cylinder.wrapping_sub(1)) else { continue };
        let (force, couple) = match told {
            Told::Whole => whole(&cylinder.loads, loads.period, theta),
            Told::Order(n) => order(&cylinder.loads.orders, n, theta),
        };
        out.push(Pull { cylinder: cylinder.cylinder, z: place.z, force, couple });
    }
    let has = |part: Part| loads.parts.iter().any(|p| p.part == part);
    let square = loads.speed * loads.speed;
    let mut weight = |ratio: f64, z: f64, unbalance: f64, angle: f64| {
        let told_here = match told {
            Told::Whole => true,
            Told::Order(n) => (ratio.abs() - n).abs() < 1e-9,
        };
        if told_here && unbalance > 0.0 {
            let force = Complex64::from_polar(unbalance * ratio * ratio * square, ratio * theta + angle);
            let couple = Complex64::new(0.0, z - loads.reference[2]) * force;
            out.push(Pull { cylinder: 0, z, force, couple });
        }
    };
    if has(Part::Counterweights) {
        for w in &engine.counterweights {
            let shaft = &engine.crankshafts[w.crankshaft];
            weight(shaft.ratio.value(), w.z, w.unbalance, shaft.phase + w.angle);
        }
    }
    if has(Part::Shafts) {
        for shaft in &engine.shafts {
            for w in &shaft.weights {
                weight(shaft.ratio.value(), w.z, w.unbalance, w.phase);
            }
        }
    }
    out.retain(|p| p.force.is_finite() && p.couple.is_finite());
    out
}

fn order(orders: &[OrderLoads], n: f64, theta: f64) -> (Complex64, Complex64) {
    let Some(order) = orders.iter().find(|o| (o.order - n).abs() < 1e-9) else { return Default::default() };
    let turn = Complex64::from_polar(1.0, n * theta);
    (
        order.force_forward * turn + order.force_backward * turn.conj(),
        order.couple_forward * turn + order.couple_backward * turn.conj(),
    )
}

fn whole(set: &LoadSet, period: f64, theta: f64) -> (Complex64, Complex64) {
    let at = |component: Component| {
        let values = component.trace(&set.trace);
        if values.is_empty() || period <= 0.0 {
            return 0.0;
        }
        let place = theta.rem_euclid(period) / period * values.len() as f64;
        let (index, share) = (place.floor() as usize % values.len(), place.fract());
        values[index] * (1.0 - share) + values[(index + 1) % values.len()] * share
    };
    (
        Complex64::new(at(Component::ForceX), at(Component::ForceY)),
        Complex64::new(at(Component::CoupleX), at(Component::CoupleY)),
    )
}

struct Scene<'a> {
    engine: &'a Engine,
    banks: &'a [Bank],
    longest: f64,
    across: bool,
    /// Something stands off the reference plane: without that, where along the crank says nothing.
    along: bool,
    reference: f64,
    /// Lines of the longest sentence, so that all panels are of one height.
    lines: usize,
}

impl Scene<'_> {
    fn panel(&self, theta: f64, pulls: &[Pull]) -> Panel {
        let strips = f64::from(u8::from(self.along)) + f64::from(u8::from(self.along && self.across));
        let strips_top = 214.0;
        let words_top = strips_top + STRIP * strips + 6.0;
        let sentence = self.sentence(pulls);
        let mut svg = Svg::new(WIDTH, words_top + 17.0 * self.lines as f64 + 6.0);
        svg.text("strong", (6.0, 16.0), Anchor::Start, &format!("θ = {:.0}°", theta.to_degrees()));
        self.front(&mut svg, theta);
        self.dial(&mut svg, pulls);
        if self.along {
            self.strip(&mut svg, pulls, strips_top, "F_x, from the side", |f| f.re);
        }
        if self.along && self.across {
            // From above, +y points down the page for a crank that turns clockwise.
            let down = -crate::kit::view::side(self.engine.rotation);
            self.strip(&mut svg, pulls, strips_top + STRIP, "F_y, from above", |f| down * f.im);
        }
        for (k, line) in self.wrapped(pulls).iter().enumerate() {
            svg.text("", (6.0, words_top + 12.0 + 17.0 * k as f64), Anchor::Start, line);
        }
        Panel::new(svg, format!("At {:.0} degrees: {sentence}", theta.to_degrees()))
    }

    fn front(&self, svg: &mut Svg, theta: f64) {
        let (x, y, size) = FRONT;
        let side = crate::kit::view::side(self.engine.rotation);
        let space = bounds(self.engine, self.banks, side);
        let scale = ((2.0 * x - 38.0) / space.width()).min(size / space.height());
        let centre =
            (x - 0.5 * (space.low.0 + space.high.0) * scale, y - 0.5 * (space.low.1 + space.high.1) * scale);
        let view = View::new(self.engine.rotation, centre, scale);
        draw_walls(svg, &view, self.banks);
        for shaft in &self.engine.crankshafts {
            let radius = self.engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius));
            svg.circle("grid", view.at(Complex64::new(shaft.x, shaft.y)), radius * scale);
        }
        draw_links(svg, &view, self.engine, theta);
        draw_piston_numbers(svg, &view, self.engine, self.banks, theta);
    }

    /// All arrows from one point, and their sum.
    fn dial(&self, svg: &mut Svg, pulls: &[Pull]) {
        let (centre, radius) = DIAL;
        svg.circle("grid", centre, radius);
        let sum: Complex64 = pulls.iter().map(|p| p.force).sum();
        let weights: Complex64 = pulls.iter().filter(|p| p.cylinder == 0).map(|p| p.force).sum();
        let reach = self.longest.max(sum.norm()).max(weights.norm());
        let view = View::new(self.engine.rotation, centre, radius / reach);
        let visible = |force: Complex64| force.norm() > 0.02 * self.longest;
        if visible(sum) {
            svg.arrow("arrow sum", centre, view.at(sum), 14.0);
        }
        if visible(weights) {
            svg.arrow("arrow a3", centre, view.at(weights), 9.0);
        }
        let cylinders =
            pulls.iter().filter(|p| p.cylinder > 0 && visible(p.force)).map(|p| (p.cylinder, p.force));
        let bundles: Vec<Bundle> = bundles(cylinders, &view);
        draw_fan(
            svg,
            &view,
            &bundles,
            WIDTH - centre.0,
            if visible(sum) { sum } else { Complex64::default() },
        );
        svg.circle("dot", centre, 2.5);
    }

    /// The arrows where they stand along the crank.
    fn strip(&self, svg: &mut Svg, pulls: &[Pull], top: f64, title: &str, part: impl Fn(Complex64) -> f64) {
        let planes = || self.engine.cylinders.iter().map(|c| c.z).chain(pulls.iter().map(|p| p.z));
        let (mut low, mut high) =
            planes().fold((self.reference, self.reference), |(low, high), z| (low.min(z), high.max(z)));
        if high - low < 1e-3 {
            (low, high) = (low - 0.05, high + 0.05);
        }
        let (left, right, middle) = (30.0, WIDTH - 30.0, top + 44.0);
        let place = |z: f64| left + (z - low) / (high - low) * (right - left);
        let reach = 28.0 / self.longest;
        svg.text("muted small", (6.0, top + 8.0), Anchor::Start, title);
        svg.line("thin", (6.0, middle), (WIDTH - 6.0, middle));
        let origin = place(self.reference);
        svg.line("zero", (origin, middle - 4.0), (origin, middle + 4.0));
        let force: Complex64 = pulls.iter().map(|p| p.force).sum();
        let couple: Complex64 = pulls.iter().map(|p| p.couple).sum();
        // The sum where it counts, at the reference, and the couple as its pair of forces at the ends.
        let pair = part(Complex64::new(0.0, -1.0) * couple / (high - low));
        for (x, value) in [(origin, part(force)), (8.0, -pair), (WIDTH - 8.0, pair)] {
            if value.abs() * reach > 5.0 {
                svg.arrow(
                    "arrow sum slim",
                    (x, middle),
                    (x, middle - (value * reach).clamp(-40.0, 40.0)),
                    12.0,
                );
            }
        }
        let mut taken: Vec<f64> = Vec::new();
        let mut numbered: Vec<(f64, Vec<usize>)> = Vec::new();
        for pull in pulls {
            let length = part(pull.force) * reach;
            let level = taken.iter().filter(|z| (place(**z) - place(pull.z)).abs() < 4.0).count();
            taken.push(pull.z);
            let step = if level % 2 == 1 { level.div_ceil(2) as f64 } else { -((level / 2) as f64) };
            let x = place(pull.z) + 6.0 * step;
            let class = if pull.cylinder > 0 { "arrow a1" } else { "arrow a3" };
            svg.circle("dot", (x, middle), 1.8);
            svg.arrow(class, (x, middle), (x, middle - length), 9.0);
            if pull.cylinder > 0 {
                match numbered.iter_mut().find(|(other, _)| (other - place(pull.z)).abs() < 14.0) {
                    Some((_, list)) => list.push(pull.cylinder),
                    None => numbered.push((place(pull.z), vec![pull.cylinder])),
                }
            }
        }
        for (x, list) in numbered {
            svg.text("small muted halo", (x, middle + 42.0), Anchor::Middle, &number::list(&list));
        }
    }

    fn wrapped(&self, pulls: &[Pull]) -> Vec<String> {
        wrap(&self.sentence(pulls), 12.5, WIDTH - 8.0)
    }

    fn sentence(&self, pulls: &[Pull]) -> String {
        let force: Complex64 = pulls.iter().map(|p| p.force).sum();
        let couple: Complex64 = pulls.iter().map(|p| p.couple).sum();
        let forces = pulls.iter().map(|p| p.force.norm()).sum::<f64>();
        let couples = pulls.iter().map(|p| p.couple.norm()).sum::<f64>();
        let quantity = |value: f64, unit: &str| {
            let scale = Scale::of(value, unit);
            // A number and its unit stay on one line.
            format!("{}\u{a0}{}", number::short(value / scale.divisor, 3), scale.unit.replace(' ', "\u{a0}"))
        };
        if forces <= 1e-6 * self.longest {
            return "No force at this moment.".to_owned();
        }
        let first = if force.norm() <= 1e-4 * forces {
            "The forces cancel".to_owned()
        } else {
            format!("The forces add up to {} {}", quantity(force.norm(), "N"), direction(force, self.engine))
        };
        // A lever of a thousandth of the engine's forces is nobody's couple.
        let second = if couple.norm() <= 1e-4 * couples.max(1e-3 * forces) {
            "no couple".to_owned()
        } else {
            // C = i z F: a force -i C at the flywheel's end and its opposite at the free end do the same.
            let push = Complex64::new(0.0, -1.0) * couple;
            format!(
                "a couple of {} pushes the flywheel end {}",
                quantity(couple.norm(), "N m"),
                direction(push, self.engine)
            )
        };
        format!("{first}; {second}.")
    }
}

/// In words, as the picture shows it.
fn direction(force: Complex64, engine: &Engine) -> &'static str {
    let right = crate::kit::view::side(engine.rotation) * force.im;
    let eighths = (right.atan2(force.re) * 8.0 / TAU).round().rem_euclid(8.0);
    const WORDS: [&str; 8] = [
        "up",
        "up and right",
        "to the right",
        "down and right",
        "down",
        "down and left",
        "to the left",
        "up and left",
    ];
    WORDS[eighths as usize % 8]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn the_arrows_of_a_story_add_up_to_the_loads_of_the_engine() {
        let mut engine = sample::engine(&[(0.0, -30.0), (120.0, 30.0), (240.0, -30.0)]);
        engine = engine
            .with(|engine| {
                engine.shafts.clone_from(&sample::twin().shafts);
            })
            .expect("an engine");
        let loads = sample::loads(&engine);
        for theta in positions(&engine) {
            let pulls = pulls(&engine, &loads, Told::Whole, theta);
            let force: Complex64 = pulls.iter().map(|p| p.force).sum();
            let couple: Complex64 = pulls.iter().map(|p| p.couple).sum();
            let (expected, expected_couple) = whole(&loads.total, loads.period, theta);
            assert!((force - expected).norm() < 1e-6 * 16e3, "{force} {expected}");
            assert!((couple - expected_couple).norm() < 1e-6 * 1.6e3, "{couple} {expected_couple}");
        }
    }

    #[test]
    fn steps_fit_the_crank() {
        assert_eq!(positions(&sample::engine(&[(0.0, 0.0), (120.0, 0.0), (240.0, 0.0)])).len(), 6);
        assert_eq!(positions(&sample::engine(&[(0.0, 0.0), (180.0, 0.0)])).len(), 8);
        assert_eq!(positions(&sample::engine(&[(0.0, 0.0)])).len(), 8);
        assert_eq!(positions(&sample::engine(&[(0.0, 0.0), (90.0, 0.0)])).len(), 8);
    }

    #[test]
    fn directions_follow_the_picture() {
        let mut engine = sample::twin();
        assert_eq!(direction(Complex64::new(1.0, 0.1), &engine), "up");
        assert_eq!(direction(Complex64::new(0.0, 1.0), &engine), "to the right");
        assert_eq!(direction(Complex64::new(-1.0, -1.0), &engine), "down and left");
        engine = engine
            .with(|engine| {
                engine.rotation = lanchester_model::Rotation::Reverse;
            })
            .expect("an engine");
        assert_eq!(direction(Complex64::new(0.0, 1.0), &engine), "to the left");
    }
}
