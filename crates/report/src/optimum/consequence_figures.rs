//! What other weights do to the main bearings and to the bending of the crankshaft, as pictures.

use crate::engine::crank_strip;
use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number::{self, Scale};
use crate::kit::plot::{BOTTOM, HEIGHT, LEFT, Legend, RIGHT, WIDTH, value_axis};
use crate::kit::rounding::{below, clean};
use crate::kit::svg::{Anchor, Path, Svg};
use lanchester_balance::{Affected, AffectedPart, BendingAlong, Consequences};
use lanchester_model::Engine;
use num_complex::Complex64;

/// Points of a curve between two neighbouring planes.
const FINENESS: usize = 8;

/// Height of the bending plot below the crank [px].
const PLOT: f64 = 190.0;

/// Main-bearing loads and bending moments before and after, by crankshaft; `after` is the engine with the new weights.
pub fn consequence_figures(after: &Engine, consequences: &Consequences) -> Vec<Figure> {
    let several = consequences.bending.len() > 1;
    let figure = |along: &BendingAlong| {
        let of = if several { format!(" of crankshaft {}", along.crankshaft) } else { String::new() };
        let rpm = number::short(number::rpm(consequences.speed), 4);
        Figure {
            id: match several {
                true => format!("consequences-{}", along.crankshaft),
                false => "consequences".to_owned(),
            },
            title: format!("Block, main bearings and bending{of}, before and after"),
            caption: format!(
                "Inertia at {rpm} rpm: what the block feels; the load on every main bearing, throw by throw; the share of the \
                 rotating unbalance between two mains that the counterweights there answer; the bending moment of the \
                 crankshaft as a free beam under what turns with it, whatever its direction, with the new weights above it."
            ),
            panels: vec![
                on_the_block(consequences),
                main_bars(consequences, along.crankshaft),
                rate_bars(consequences, along.crankshaft),
                bending(after, along),
            ],
            columns: 2,
        }
    };
    consequences.bending.iter().map(figure).collect()
}

/// Height of a row of the loads on the block [px].
const ROW: f64 = 46.0;

/// Peaks of the loads on the block, each row to its own scale.
fn on_the_block(consequences: &Consequences) -> Panel {
    const LOADS: [(Affected, &str); 4] = [
        (Affected::Force, "Force"),
        (Affected::Couple, "Couple"),
        (Affected::RollMoment, "Roll moment"),
        (Affected::MountForce, "Mount force"),
    ];
    let mut svg = Svg::new(WIDTH, HEIGHT);
    svg.text(
        "muted small",
        (4.0, 13.0),
        Anchor::Start,
        "On the block and at the mounts, largest over the cycle",
    );
    key(&mut svg);
    let (left, longest) = (100.0, WIDTH - 100.0 - 90.0);
    let mut said = Vec::with_capacity(LOADS.len());
    let rows = LOADS
        .iter()
        .filter_map(|(quantity, name)| Some((*quantity, *name, consequences.largest(*quantity)?)));
    for (place, (quantity, name, pair)) in rows.enumerate() {
        let top = 50.0 + ROW * place as f64;
        let largest = pair[0].max(pair[1]);
        let scale = Scale::of(largest, quantity.unit());
        svg.text("small", (4.0, top + 18.0), Anchor::Start, name);
        for ((class, value), y) in ["bar2", "bar1"].into_iter().zip(pair).zip([top, top + 17.0]) {
            let length = if largest > 0.0 { longest * value / largest } else { 0.0 };
            if length > 0.5 {
                svg.rect(class, left, y, length, 12.0);
            }
            let words = format!("{} {}", number::short(value / scale.divisor, 3), scale.unit);
            svg.text("small", (left + length + 6.0, y + 10.0), Anchor::Start, &words);
        }
        svg.line("zero", (left, top - 3.0), (left, top + 32.0));
        let [before, after] = pair.map(|value| number::short(value / scale.divisor, 3));
        said.push(format!("{name} {before} {unit} before, {after} {unit} after", unit = scale.unit));
    }
    Panel::new(svg, format!("Largest loads on the block: {}.", said.join("; ")))
}

/// Which bar is which.
fn key(svg: &mut Svg) {
    for (class, name, x) in [("bar2", "before", 4.0), ("bar1", "after", 90.0)] {
        svg.rect(class, x + 2.0, 23.0, 14.0, 9.0);
        svg.text("small", (x + 22.0, 32.0), Anchor::Start, name);
    }
}

/// Pairs of bars, one a part.
struct Pairs<'a> {
    quantity: &'a str,
    unit: &'a str,
    /// What the parts are.
    parts: &'a str,
    pairs: Vec<(String, [f64; 2])>,
}

/// Peak loads of the mains of one crankshaft.
fn main_bars(consequences: &Consequences, number: usize) -> Panel {
    let main = |part| match part {
        AffectedPart::Main { crankshaft, main, .. } if crankshaft == number => Some(main.to_string()),
        _ => None,
    };
    let rows = consequences.of(Affected::MainLoadPeak);
    let pairs = rows.filter_map(|row| Some((main(row.part)?, [row.before, row.after]))).collect();
    Pairs { quantity: "Main-bearing load, peak", unit: "N", parts: "main bearing", pairs }.panel()
}

/// Balance rates of the bays of one crankshaft.
fn rate_bars(consequences: &Consequences, number: usize) -> Panel {
    let bay = |part| match part {
        AffectedPart::Bay { crankshaft, bay, .. } if crankshaft == number => {
            Some(format!("{bay}\u{2013}{}", bay + 1))
        }
        _ => None,
    };
    let rows = consequences.of(Affected::BalanceRate);
    let pairs =
        rows.filter_map(|row| Some((bay(row.part)?, [100.0 * row.before, 100.0 * row.after]))).collect();
    Pairs { quantity: "Balance rate", unit: "%", parts: "between the main bearings", pairs }.panel()
}

impl Pairs<'_> {
    fn panel(&self) -> Panel {
        let values = || self.pairs.iter().flat_map(|(_, pair)| pair.iter().copied());
        let (least, most) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
        let largest = most.max(-least);
        let scale = match self.unit {
            "%" => Scale { divisor: 1.0, unit: "%".to_owned() },
            unit => Scale::of(largest, unit),
        };
        let reach = |value: f64| 1.08 * value / scale.divisor;
        let axis = Axis::of(reach(least), if largest > 0.0 { reach(most) } else { 1.0 }, 5);
        let mut svg = Svg::new(WIDTH, HEIGHT);
        let (right, top, bottom) = (WIDTH - RIGHT, 50.0, HEIGHT - BOTTOM);
        svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("{} [{}]", self.quantity, scale.unit));
        key(&mut svg);
        value_axis(&mut svg, &axis, top, bottom);
        let zero = axis.place(0.0, bottom, top);
        let width = (right - LEFT) / self.pairs.len().max(1) as f64;
        let bar = (0.34 * width).min(22.0);
        let mut said = Vec::with_capacity(self.pairs.len());
        for (place, (part, pair)) in self.pairs.iter().enumerate() {
            let middle = LEFT + (place as f64 + 0.5) * width;
            for (class, value, x) in [("bar2", pair[0], middle - bar - 1.0), ("bar1", pair[1], middle + 1.0)]
            {
                if value.abs() > below(largest) {
                    let y = axis.place(value / scale.divisor, bottom, top);
                    svg.rect(class, x, y.min(zero), bar, (zero - y).abs());
                }
            }
            svg.text("small", (middle, bottom + 17.0), Anchor::Middle, part);
            let [before, after] = pair.map(|value| number::short(value / scale.divisor, 3));
            said.push(format!("{part}: {before} before, {after} after"));
        }
        svg.text("muted small", ((LEFT + right) / 2.0, bottom + 37.0), Anchor::Middle, self.parts);
        Panel::new(svg, format!("{} [{}] by {}: {}.", self.quantity, scale.unit, self.parts, said.join("; ")))
    }
}

/// Size of the bending moment along the crank.
fn bending(engine: &Engine, along: &BendingAlong) -> Panel {
    let largest_of = |moments: &[Complex64]| moments.iter().map(|m| m.norm()).fold(0.0, f64::max);
    let (was, is) = (largest_of(&along.before), largest_of(&along.after));
    let largest = was.max(is);
    let scale = Scale::of(largest, "N m");
    let axis = Axis::of(0.0, if largest > 0.0 { 1.06 * largest / scale.divisor } else { 1.0 }, 5);
    let (first, last) = (along.z.first().copied().unwrap_or(0.0), along.z.last().copied().unwrap_or(0.0));
    let margin = 0.03 * 1e3 * (last - first);
    let places =
        Axis::stepped(1e3 * first - margin, 1e3 * last + margin, Axis::of(1e3 * first, 1e3 * last, 6).step());
    let legend = Legend::of(&[("after".to_owned(), 0), ("before".to_owned(), 2)], 4.0, WIDTH + 10.0);
    let strip = 26.0 + legend.height;
    let top = strip + crank_strip::HEIGHT;
    let (right, bottom) = (WIDTH - RIGHT, top + PLOT);
    let mut svg = Svg::new(WIDTH, bottom + BOTTOM);
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("Bending moment [{}]", scale.unit));
    legend.draw(&mut svg);
    value_axis(&mut svg, &axis, top, bottom);
    let place = |z: f64| places.place(1e3 * z, LEFT, right);
    let index = along.crankshaft - 1;
    let mains = engine.main_planes(index);
    for &main in &mains {
        svg.line("grid dashed", (place(main), strip + 52.0), (place(main), bottom));
    }
    crank_strip::draw(&mut svg, engine, index, &mains, strip, place);
    for &tick in &places.ticks {
        let x = places.place(tick, LEFT, right);
        svg.line("zero", (x, bottom), (x, bottom + 4.0));
        svg.text("small", (x, bottom + 17.0), Anchor::Middle, &number::fixed(tick, places.decimals));
    }
    svg.text("muted small", ((LEFT + right) / 2.0, bottom + 37.0), Anchor::Middle, "z [mm]");
    for (moments, style) in [(&along.before, 2), (&along.after, 0)] {
        let points = sizes(&along.z, moments).into_iter().map(|(z, size)| {
            let size = clean(size, below(largest));
            (place(z), axis.place(size / scale.divisor, bottom, top))
        });
        svg.path(&format!("s{style}"), &Path::through(points));
    }
    let [was, is] = [was, is].map(|value| number::short(value / scale.divisor, 4));
    let unit = &scale.unit;
    Panel::new(
        svg,
        format!("Bending moment along the crankshaft: at most {was} {unit} before, {is} {unit} after."),
    )
}

/// Plane and size: the moment runs straight between planes, its size does not.
fn sizes(planes: &[f64], moments: &[Complex64]) -> Vec<(f64, f64)> {
    let mut points = Vec::with_capacity(planes.len() * FINENESS);
    for (z, moment) in planes.windows(2).zip(moments.windows(2)) {
        for part in 0..FINENESS {
            let share = part as f64 / FINENESS as f64;
            points.push((z[0] + share * (z[1] - z[0]), (moment[0] + share * (moment[1] - moment[0])).norm()));
        }
    }
    points.extend(planes.last().zip(moments.last()).map(|(z, moment)| (*z, moment.norm())));
    points
}
