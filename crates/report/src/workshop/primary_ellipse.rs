//! The primary ellipse for several balance factors.

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number::{self, Scale};
use crate::kit::plot::Legend;
use crate::kit::svg::{Anchor, Path, Svg, text_width};
use crate::kit::view::View;
use lanchester_workshop::{FactorAnswer, PrimaryEllipse, Sense, ThrowFactor};
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, TAU};

const WIDTH: f64 = 440.0;
const RADIUS: f64 = 150.0;

/// Shares of the reciprocating mass that are drawn beside the one in question.
const SHARES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// A throw, the square of its speed [rad²/s²], and its ellipse for each share.
type Drawn<'a> = (&'a ThrowFactor, f64, Vec<(f64, PrimaryEllipse)>);

/// First-order force of each throw for several balance factors; throws that look alike are drawn once. `None` where
/// nothing reciprocates.
pub fn primary_ellipse_figure(answer: &FactorAnswer) -> Option<Figure> {
    let drawn: Vec<Drawn<'_>> = answer
        .throws
        .iter()
        .enumerate()
        .filter_map(|(index, throw)| {
            let shares =
                SHARES.iter().map(|s| throw.ellipse_at(*s).map(|e| (*s, e))).collect::<Option<Vec<_>>>()?;
            Some((throw, answer.square(index), shares))
        })
        .collect();
    let mut groups: Vec<(Vec<usize>, usize)> = Vec::new();
    for (index, (throw, square, _)) in drawn.iter().enumerate() {
        let alike = |(_, first): &&mut (Vec<usize>, usize)| {
            let (other, their_square, _) = &drawn[*first];
            let size = throw.masses.reciprocating_unbalance() * square;
            let apart = (throw.ellipse.forward * *square - other.ellipse.forward * *their_square).norm()
                + (throw.ellipse.backward * *square - other.ellipse.backward * *their_square).norm();
            apart < 1e-6 * size && (throw.masses.axis - other.masses.axis).abs() < 1e-9
        };
        match groups.iter_mut().find(alike) {
            Some((numbers, _)) => numbers.push(throw.throw),
            None => groups.push((vec![throw.throw], index)),
        }
    }
    let panels: Vec<Panel> = groups
        .iter()
        .map(|(numbers, index)| {
            let (throw, square, shares) = &drawn[*index];
            panel(answer, numbers, throw, *square, shares)
        })
        .collect();
    if panels.is_empty() {
        return None;
    }
    Some(Figure {
        id: "primary-ellipse".to_owned(),
        title: "The primary ellipse".to_owned(),
        caption: "Path of the first-order force of a throw for several shares of its reciprocating mass, seen from the free end. The full line \
                  is the engine in question; the arrow on it shows where it stands with the throw along x and which way it runs, thin lines are \
                  its axes, the dash-dotted line is the direction of the cylinders."
            .to_owned(),
        columns: panels.len().min(2),
        panels,
    })
}

fn panel(
    answer: &FactorAnswer,
    numbers: &[usize],
    throw: &ThrowFactor,
    square: f64,
    shares: &[(f64, PrimaryEllipse)],
) -> Panel {
    let own = match throw.reciprocating_share {
        Some(share) => format!("{} %", number::trimmed(100.0 * share, 3)),
        None => "as built".to_owned(),
    };
    let mut names = vec![(own.clone(), 0)];
    // The one in question is drawn once.
    let others: Vec<(usize, &(f64, PrimaryEllipse))> = shares
        .iter()
        .enumerate()
        .filter(|(_, (share, _))| throw.reciprocating_share.is_none_or(|own| (own - share).abs() > 1e-6))
        .collect();
    names.extend(others.iter().map(|(k, (s, _))| (format!("{} %", number::trimmed(100.0 * s, 3)), k + 1)));
    let legend = Legend::of(&names, 8.0, WIDTH);
    let reach = shares.iter().fold(throw.ellipse.major, |m, (_, e)| m.max(e.major)) * square;
    let scale = Scale::of(reach, "N");
    let rings = Axis::of(0.0, reach / scale.divisor, 4);
    let outer = RADIUS / rings.high;
    let centre = (WIDTH / 2.0, 52.0 + legend.height + RADIUS + 22.0);
    let view = View::new(answer.rotation, centre, outer / scale.divisor * square);
    let mut svg = Svg::new(WIDTH, centre.1 + RADIUS + 30.0);
    legend.draw(&mut svg);
    let plural = if numbers.len() > 1 { "Throws" } else { "Throw" };
    let heading = format!("{plural} {}", number::list(numbers));
    svg.text("strong", (8.0, 40.0 + legend.height), Anchor::Start, &heading);
    grid(&mut svg, &view, &rings, outer, &scale, throw.masses.axis);
    for (k, (_, ellipse)) in others {
        svg.path(&format!("s{}", k + 1), &path(&view, ellipse));
    }
    svg.path("s0", &path(&view, &throw.ellipse));
    ring_labels(&mut svg, &view, &rings, outer);
    axes(&mut svg, &view, &throw.ellipse);
    let description = format!(
        "{heading}: at {own} the half axes are {} and {} {}, the longer one at {} degrees; {}.",
        number::short(throw.ellipse.major * square / scale.divisor, 4),
        number::short(throw.ellipse.minor * square / scale.divisor, 4),
        scale.unit,
        number::trimmed(throw.ellipse.tilt.to_degrees(), 3),
        throw.ellipse.sense.name(),
    );
    Panel::new(svg, description)
}

fn path(view: &View, ellipse: &PrimaryEllipse) -> Path {
    const STEPS: usize = 180;
    Path::through((0..=STEPS).map(|k| view.at(ellipse.at(TAU * k as f64 / STEPS as f64))))
}

/// Rings with their labels, and the direction of the cylinders.
fn grid(svg: &mut Svg, view: &View, rings: &Axis, outer: f64, scale: &Scale, axis: f64) {
    let (x, y) = view.centre;
    let reach = rings.high * outer;
    svg.line("zero", (x - reach, y), (x + reach, y));
    svg.line("zero", (x, y - reach), (x, y + reach));
    for &ring in rings.ticks.iter().filter(|r| **r > 0.0) {
        svg.circle("grid", view.centre, ring * outer);
    }
    let unit = View { scale: reach + 10.0, ..*view };
    svg.line("axis-line", unit.at(-Complex64::cis(axis)), unit.at(Complex64::cis(axis)));
    svg.text("muted small halo", (x + 8.0, y - reach - 8.0), Anchor::Start, &format!("F_x [{}]", scale.unit));
    let (right, anchor) = match view.side > 0.0 {
        true => (reach + 8.0, Anchor::Start),
        false => (-reach - 8.0, Anchor::End),
    };
    svg.text("muted small", (x + right, y + 4.0), anchor, "F_y");
}

fn ring_labels(svg: &mut Svg, view: &View, rings: &Axis, outer: f64) {
    // Away from the axes of most ellipses.
    let direction = Complex64::cis(-1.9);
    for &ring in rings.ticks.iter().filter(|r| **r > 0.0) {
        let at = View { scale: ring * outer, ..*view }.at(direction);
        svg.text(
            "muted small halo",
            (at.0, at.1 + 4.0),
            Anchor::Middle,
            &number::fixed(ring, rings.decimals),
        );
    }
}

/// Both axes of the ellipse, the tilt of the longer one, and where and which way it runs.
fn axes(svg: &mut Svg, view: &View, ellipse: &PrimaryEllipse) {
    if ellipse.sense == Sense::None {
        svg.circle("dot", view.centre, 4.0);
        svg.text(
            "small strong halo",
            (view.centre.0, view.centre.1 + 22.0),
            Anchor::Middle,
            "no first order",
        );
        return;
    }
    let major = Complex64::from_polar(ellipse.major, ellipse.tilt);
    let minor = Complex64::from_polar(ellipse.minor, ellipse.tilt + FRAC_PI_2);
    for half in [major, minor] {
        svg.line("thin", view.at(-half), view.at(half));
    }
    // A circle has no tilt; an upright or level ellipse shows it without words.
    let degrees = ellipse.tilt.to_degrees();
    let plain = [0.0, 90.0, -90.0].iter().any(|d: &f64| (degrees - d).abs() < 0.05);
    if ellipse.minor < 0.999 * ellipse.major && !plain {
        let label = format!("{}\u{b0}", number::trimmed(degrees, 3));
        let at = view.at(major);
        let half = 0.5 * text_width(&label, 12.5) + 8.0;
        let (dx, dy) = (at.0 - view.centre.0, at.1 - view.centre.1);
        let length = dx.hypot(dy).max(1.0);
        let place = (at.0 + half * dx / length, at.1 + 14.0 * dy / length + 4.0);
        svg.text("small strong halo", place, Anchor::Middle, &label);
    }
    let (start, ahead) = (view.at(ellipse.at(0.0)), view.at(ellipse.at(0.1)));
    let (dx, dy) = (ahead.0 - start.0, ahead.1 - start.1);
    let length = dx.hypot(dy);
    if length > 0.5 && ellipse.sense != Sense::Line {
        svg.arrow("arrow a0", start, (start.0 + 26.0 * dx / length, start.1 + 26.0 * dy / length), 11.0);
    }
    svg.circle("pin", start, 4.0);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;
    use lanchester_workshop::{FactorGiven, FactorRequest, factor_answer};

    fn figure(engine: &lanchester_model::Engine, given: FactorGiven, angle: Option<f64>) -> Figure {
        let request = FactorRequest { given, oil: 0.0, angle };
        primary_ellipse_figure(&factor_answer(engine, &request).unwrap()).unwrap()
    }

    #[test]
    fn alike_throws_share_a_panel() {
        let twin = figure(&sample::twin(), FactorGiven::ReciprocatingShare(0.6), None);
        assert_eq!(twin.panels.len(), 1);
        assert!(
            twin.panels[0].description.starts_with("Throws 1, 2: at 60 %"),
            "{}",
            twin.panels[0].description
        );
        let uneven = sample::engine(&[(0.0, 0.0), (90.0, 30.0)]);
        assert_eq!(figure(&uneven, FactorGiven::AsBuilt, None).panels.len(), 2);
    }

    #[test]
    fn a_tilted_ellipse_names_its_tilt() {
        let engine = sample::engine(&[(0.0, 0.0)]);
        let tilted = figure(&engine, FactorGiven::ReciprocatingShare(0.6), Some(2.6));
        assert!(tilted.svg().contains('\u{b0}'));
        let upright = figure(&engine, FactorGiven::ReciprocatingShare(0.3), None);
        assert!(!upright.svg().contains('\u{b0}') && upright.svg().contains("F<tspan"));
    }
}
