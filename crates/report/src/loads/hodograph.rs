//! Hodographs: the curve that the tip of the force (or couple) arrow draws in one cycle.

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::magnitude::Magnitude;
use crate::kit::number::{self, Scale};
use crate::kit::plot::Legend;
use crate::kit::svg::{Anchor, Path, Svg, text_width};
use crate::kit::view::View;
use lanchester_mechanism::Loads;
use lanchester_model::Rotation;
use lanchester_results::OrderLoads;
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, TAU};

const WIDTH: f64 = 420.0;
const RADIUS: f64 = 158.0;

/// Hodograph of the force.
pub fn force_hodograph(loads: &Loads, rotation: Rotation) -> Figure {
    let trace = &loads.total.trace;
    let curve = Curve {
        symbol: "F",
        unit: "N",
        theta: &trace.theta,
        values: trace.force_x.iter().zip(&trace.force_y).map(|(x, y)| Complex64::new(*x, *y)).collect(),
        period: loads.period,
        noise: Magnitude::of(loads).force_noise(),
        rotation,
    };
    let nothing = curve.largest() <= curve.noise;
    let panel = curve.panel(&loads.total.orders, |o| (o.force_forward, o.force_backward));
    Figure {
        id: "force-hodograph".to_owned(),
        title: "The force arrow over one cycle".to_owned(),
        caption: match nothing {
            true => "There is no path to draw.".to_owned(),
            false => format!("Path of the tip of the shaking force, seen from the free end. {READING}"),
        },
        panels: vec![panel],
        columns: 1,
    }
}

/// Hodograph of the couple.
pub fn couple_hodograph(loads: &Loads, rotation: Rotation) -> Figure {
    let trace = &loads.total.trace;
    let curve = Curve {
        symbol: "M",
        unit: "N m",
        theta: &trace.theta,
        values: trace.couple_x.iter().zip(&trace.couple_y).map(|(x, y)| Complex64::new(*x, *y)).collect(),
        period: loads.period,
        noise: Magnitude::of(loads).couple_noise(),
        rotation,
    };
    let nothing = curve.largest() <= curve.noise;
    let panel = curve.panel(&loads.total.orders, |o| (o.couple_forward, o.couple_backward));
    Figure {
        id: "couple-hodograph".to_owned(),
        title: "The couple arrow over one cycle".to_owned(),
        caption: match nothing {
            true => "There is no path to draw.".to_owned(),
            false => {
                format!(
                    "Path of the tip of the rocking couple M_x + i M_y about the reference point. {READING}"
                )
            }
        },
        panels: vec![panel],
        columns: 1,
    }
}

const READING: &str = "Dots every 30 degrees of the crank; the arrow shows where it starts and which way it runs. A circle turns evenly, \
                       a line is a planar load.";

/// What a label must not cover: the curve and other labels.
struct Room {
    curve: Vec<(f64, f64)>,
    labels: Vec<((f64, f64), f64)>,
}

impl Room {
    fn of(curve: Vec<(f64, f64)>) -> Room {
        Room { curve, labels: Vec::new() }
    }

    /// How much a label of this width, middle of its base line here, would cover.
    fn cost(&self, (x, y): (f64, f64), width: f64) -> f64 {
        let half = 0.5 * width + 2.0;
        let curve = self
            .curve
            .iter()
            .filter(|(cx, cy)| (cx - x).abs() < half && (cy - (y - 4.0)).abs() < 8.0)
            .count();
        let clash = |((lx, ly), other): &&((f64, f64), f64)| {
            (lx - x).abs() < half + 0.5 * other && (ly - y).abs() < 14.0
        };
        curve as f64 + 100.0 * self.labels.iter().filter(clash).count() as f64
    }

    fn take(&mut self, at: (f64, f64), width: f64) {
        self.labels.push((at, width));
    }

    /// The best place for a label of a point: outwards if that is free, else around it.
    fn place(&mut self, point: (f64, f64), centre: (f64, f64), width: f64) -> (f64, f64) {
        let out = (point.1 - centre.1).atan2(point.0 - centre.0);
        let half = 0.5 * width;
        let (mut best, mut least) = (point, f64::INFINITY);
        for (rank, turn) in
            [0.0, 0.8, -0.8, FRAC_PI_2, -FRAC_PI_2, 2.4, -2.4, std::f64::consts::PI].into_iter().enumerate()
        {
            let (sine, cosine) = (out + turn).sin_cos();
            let x = (point.0 + cosine * (half + 9.0)).clamp(half + 2.0, WIDTH - half - 2.0);
            let at = (x, point.1 + sine * 14.0 + 4.0);
            let cost = self.cost(at, width) + 0.5 * rank as f64;
            if cost < least {
                (best, least) = (at, cost);
            }
        }
        self.take(best, width);
        best
    }
}

struct Curve<'a> {
    symbol: &'static str,
    unit: &'static str,
    theta: &'a [f64],
    values: Vec<Complex64>,
    period: f64,
    noise: f64,
    rotation: Rotation,
}

impl Curve<'_> {
    fn panel(&self, orders: &[OrderLoads], of: impl Fn(&OrderLoads) -> (Complex64, Complex64)) -> Panel {
        let largest = self.largest();
        if largest <= self.noise {
            return self.nothing();
        }
        let mut ellipses: Vec<(f64, Complex64, Complex64)> =
            orders.iter().filter(|o| o.order > 0.0).map(|o| (o.order, of(o).0, of(o).1)).collect();
        ellipses.retain(|(_, f, b)| f.norm() + b.norm() > 0.02 * largest);
        ellipses.sort_by(|a, b| (b.1.norm() + b.2.norm()).total_cmp(&(a.1.norm() + a.2.norm())));
        ellipses.truncate(2);
        ellipses.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut names = vec![("total".to_owned(), 0)];
        // One order alone is the whole: an overlay would say nothing.
        if ellipses.len() > 1 {
            names.extend(ellipses.iter().enumerate().map(|(k, e)| (number::order_word(e.0), k + 1)));
        }
        let legend = Legend::of(&names, 8.0, WIDTH);
        let reach = ellipses.iter().fold(largest, |m, e| m.max(e.1.norm() + e.2.norm()));
        let scale = Scale::of(reach, self.unit);
        let rings = Axis::of(0.0, reach / scale.divisor, 3);
        let outer = RADIUS / rings.high;
        let centre = (WIDTH / 2.0, 26.0 + legend.height + RADIUS + 22.0);
        let view = View::new(self.rotation, centre, outer / scale.divisor);
        let mut svg = Svg::new(WIDTH, centre.1 + RADIUS + 26.0);
        legend.draw(&mut svg);
        let mut room = Room::of(
            self.values.iter().step_by((self.values.len() / 120).max(1)).map(|v| view.at(*v)).collect(),
        );
        self.grid(&mut svg, &view, &rings, outer, &scale, &mut room);
        if ellipses.len() > 1 {
            for (k, &(n, f, b)) in ellipses.iter().enumerate() {
                let turn = |t: f64| Complex64::from_polar(1.0, n * t);
                let count = 180;
                let points = (0..=count).map(|j| {
                    let theta = TAU * j as f64 / count as f64 / n.min(1.0);
                    view.at(f * turn(theta) + b * turn(theta).conj())
                });
                svg.path(&format!("s{}", k + 1), &Path::through(points));
            }
        }
        let stride = self.values.len().div_ceil(360).max(1);
        let points = self.values.iter().step_by(stride).chain(self.values.first()).map(|v| view.at(*v));
        svg.path("s0", &Path::through(points));
        self.marks(&mut svg, &view, room);
        let description = format!(
            "Path of the arrow {} over the cycle: largest {} {}.",
            self.symbol,
            number::short(largest / scale.divisor, 4),
            scale.unit
        );
        Panel::new(svg, description)
    }

    fn largest(&self) -> f64 {
        self.values.iter().map(|v| v.norm()).filter(|v| v.is_finite()).fold(0.0, f64::max)
    }

    fn nothing(&self) -> Panel {
        let mut svg = Svg::new(WIDTH, 90.0);
        svg.circle("dot", (WIDTH / 2.0, 34.0), 4.0);
        svg.text(
            "muted",
            (WIDTH / 2.0, 66.0),
            Anchor::Middle,
            &format!("{} = 0 at every crank angle", self.symbol),
        );
        Panel::new(svg, format!("{} is zero at every crank angle.", self.symbol))
    }

    fn grid(&self, svg: &mut Svg, view: &View, rings: &Axis, outer: f64, scale: &Scale, room: &mut Room) {
        let (x, y) = view.centre;
        for spoke in 0..6 {
            let (sine, cosine) = (f64::from(spoke) * TAU / 12.0).sin_cos();
            let class = if spoke % 3 == 0 { "zero" } else { "grid" };
            let reach = rings.high * outer;
            svg.line(class, (x - reach * sine, y + reach * cosine), (x + reach * sine, y - reach * cosine));
        }
        for &ring in rings.ticks.iter().filter(|r| **r > 0.0) {
            svg.circle("grid", view.centre, ring * outer);
        }
        // Ring labels run along the diagonal that the curve meets least.
        let labels = |(right, down): (f64, f64)| {
            rings.ticks.iter().filter(|r| **r > 0.0).map(move |ring| {
                let at = ring * outer * std::f64::consts::FRAC_1_SQRT_2;
                (*ring, (x + right * at, y + down * at + 4.0))
            })
        };
        let cost = |diagonal: (f64, f64)| labels(diagonal).map(|(_, at)| room.cost(at, 20.0)).sum::<f64>();
        let diagonals = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
        let best = diagonals.into_iter().min_by(|a, b| cost(*a).total_cmp(&cost(*b))).unwrap_or((-1.0, 1.0));
        for (ring, at) in labels(best).collect::<Vec<_>>() {
            let label = number::fixed(ring, rings.decimals);
            room.take(at, text_width(&label, 13.0));
            svg.text("muted small halo", at, Anchor::Middle, &label);
        }
        let reach = rings.high * outer;
        let up = format!("{}_x [{}]", self.symbol, scale.unit);
        // Beside the axis: the marks of the path may stand on it.
        svg.text("muted small", (x + 44.0, y - reach - 8.0), Anchor::Start, &up);
        let (right, anchor) =
            if view.side > 0.0 { (reach + 6.0, Anchor::Start) } else { (-reach - 6.0, Anchor::End) };
        svg.text("muted small", (x + right, y + 4.0), anchor, &format!("{}_y", self.symbol));
    }

    /// Dots every 30 degrees, labels every 90, those that share a place in one label; an arrow where it starts.
    fn marks(&self, svg: &mut Svg, view: &View, mut room: Room) {
        let turns = (self.period / TAU).round().max(1.0);
        let count = (12.0 * turns) as usize;
        let mut labels: Vec<((f64, f64), Vec<String>)> = Vec::new();
        for k in 0..count {
            let at = view.at(self.value(TAU * k as f64 / 12.0));
            svg.circle("dot", at, 2.2);
            if k % 3 != 0 {
                continue;
            }
            let text = format!("{}\u{b0}", 30 * k);
            match labels.iter_mut().find(|(other, _)| (other.0 - at.0).hypot(other.1 - at.1) < 15.0) {
                Some((_, list)) => list.push(text),
                None => labels.push((at, vec![text])),
            }
        }
        let start = view.at(self.value(0.0));
        let ahead = view.at(self.value(TAU / 24.0));
        let (dx, dy) = (ahead.0 - start.0, ahead.1 - start.1);
        let length = dx.hypot(dy).max(1e-9);
        if length > 1.0 {
            svg.arrow("arrow a2", start, (start.0 + 26.0 * dx / length, start.1 + 26.0 * dy / length), 10.0);
        }
        svg.circle("pin", start, 4.0);
        for (at, list) in labels {
            let text =
                if list.len() > 4 { format!("{}, …", list[..3].join(", ")) } else { list.join(", ") };
            let place = room.place(at, view.centre, text_width(&text, 13.0));
            svg.text("small strong halo", place, Anchor::Middle, &text);
        }
    }

    /// The arrow at a crank angle, between two samples.
    fn value(&self, theta: f64) -> Complex64 {
        let count = self.values.len().min(self.theta.len());
        if count == 0 {
            return Complex64::default();
        }
        let place = theta.rem_euclid(self.period) / self.period * count as f64;
        let (index, share) = (place.floor() as usize % count, place.fract());
        self.values[index] * (1.0 - share) + self.values[(index + 1) % count] * share
    }
}
