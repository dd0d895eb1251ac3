//! Figures of the block on its mounts: forces against speed, the waterfall of orders, transmissibility.

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::plot::{BOTTOM, HEIGHT, LEFT, Legend, RIGHT, WIDTH, value_axis};
use crate::kit::svg::{Anchor, Path, Svg};
use crate::mounts::shapes::mount_shapes;
use lanchester_mechanism::{COORDINATES, MountStudy, vector_amplitude};
use lanchester_model::Engine;
use std::f64::consts::TAU;

/// Orders drawn one by one beside the largest force.
const DRAWN: usize = 5;

/// Orders that stay below this share of the largest force are left out of the waterfall.
const FLAT: f64 = 1e-3;

/// All figures, as far as the study has what they show.
pub fn mount_figures(engine: &Engine, study: &MountStudy) -> Vec<Figure> {
    let mut figures = Vec::new();
    if study.response.speeds.len() > 1 {
        figures.push(forces(study));
        figures.extend(waterfall(study));
    }
    figures.push(transmissibility(study));
    figures.push(mount_shapes(engine, study));
    figures
}

/// Amplitudes at one mount of one order against speed.
fn of_order(study: &MountStudy, mount: usize, order: f64) -> Vec<f64> {
    let at = |s: &lanchester_mechanism::SpeedResponse| {
        let found = s.orders.iter().find(|o| o.order == order);
        found.map_or(0.0, |o| vector_amplitude(&o.forces[mount]))
    };
    study.response.speeds.iter().map(at).collect()
}

/// All orders that occur, rising.
fn orders(study: &MountStudy) -> Vec<f64> {
    let mut all: Vec<f64> =
        study.response.speeds.iter().flat_map(|s| s.orders.iter().map(|o| o.order)).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

/// Speeds along the foot of a plot, with the grid above.
fn speed_axis(svg: &mut Svg, study: &MountStudy, top: f64, bottom: f64) -> Axis {
    let speeds = study.response.speeds.iter().map(|s| number::rpm(s.speed));
    let (low, high) = speeds.fold((f64::INFINITY, 0.0f64), |(low, high), v| (low.min(v), high.max(v)));
    let axis = Axis::of(low, high, 6);
    let right = svg.width - RIGHT;
    for &tick in &axis.ticks {
        let x = axis.place(tick, LEFT, right);
        svg.line("grid", (x, top), (x, bottom));
        svg.text("small", (x, bottom + 17.0), Anchor::Middle, &number::fixed(tick, axis.decimals));
    }
    svg.text("muted small", ((LEFT + right) / 2.0, bottom + 37.0), Anchor::Middle, "speed [rpm]");
    axis
}

/// Largest force at each mount and its largest orders against speed, one panel a mount, all to one scale.
fn forces(study: &MountStudy) -> Figure {
    let all = orders(study);
    let peaks =
        |mount: usize| study.response.speeds.iter().map(|s| s.peaks[mount].value).collect::<Vec<f64>>();
    let count = study.response.mounts.len();
    let high = (0..count).map(|mount| largest(&peaks(mount))).fold(0.0, f64::max);
    let panels = (0..count).map(|mount| {
        let mut curves: Vec<(f64, Vec<f64>)> =
            all.iter().map(|&order| (order, of_order(study, mount, order))).collect();
        curves.retain(|(_, values)| largest(values) > FLAT * high);
        curves.sort_by(|a, b| largest(&b.1).total_cmp(&largest(&a.1)));
        curves.truncate(DRAWN);
        curves.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut series = vec![("largest over the cycle".to_owned(), peaks(mount))];
        series.extend(
            curves.into_iter().map(|(order, values)| (format!("order {}", number::order(order)), values)),
        );
        force_panel(study, &study.response.mounts[mount], &series, high)
    });
    Figure {
        id: "mount-forces".to_owned(),
        title: "Forces at the mounts against speed".to_owned(),
        caption: "Largest force at each mount over the cycle, and the amplitudes of its largest orders."
            .to_owned(),
        panels: panels.collect(),
        columns: 2,
    }
}

fn force_panel(study: &MountStudy, name: &str, series: &[(String, Vec<f64>)], high: f64) -> Panel {
    let scale = number::Scale::of(high, "N");
    let axis = Axis::of(0.0, high / scale.divisor, 6);
    let names: Vec<(String, usize)> = series.iter().enumerate().map(|(k, s)| (s.0.clone(), k)).collect();
    let legend = Legend::of(&names, 4.0, WIDTH + 10.0);
    let top = 26.0 + legend.height;
    let mut svg = Svg::new(WIDTH, HEIGHT + legend.height);
    let bottom = svg.height - BOTTOM;
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("{name}: force [{}]", scale.unit));
    legend.draw(&mut svg);
    value_axis(&mut svg, &axis, top, bottom);
    let speeds = speed_axis(&mut svg, study, top, bottom);
    for (style, (_, values)) in series.iter().enumerate().rev() {
        let points = study.response.speeds.iter().zip(values).map(|(s, value)| {
            let x = speeds.place(number::rpm(s.speed), LEFT, WIDTH - RIGHT);
            (x, axis.place(value / scale.divisor, bottom, top))
        });
        svg.path(&format!("s{style}"), &Path::through(points));
    }
    let most = largest(&series[0].1) / scale.divisor;
    Panel::new(
        svg,
        format!("Force at {name} against speed, at most {} {}.", number::short(most, 4), scale.unit),
    )
}

/// One line an order against speed, each on its own foot, with dots where the order meets a natural frequency.
fn waterfall(study: &MountStudy) -> Option<Figure> {
    let all = orders(study);
    let count = study.response.mounts.len();
    let table: Vec<Vec<Vec<f64>>> =
        (0..count).map(|mount| all.iter().map(|&order| of_order(study, mount, order)).collect()).collect();
    let high = table.iter().flatten().map(|values| largest(values)).fold(0.0, f64::max);
    let drawn: Vec<usize> =
        (0..all.len()).filter(|&k| table.iter().any(|mount| largest(&mount[k]) > FLAT * high)).collect();
    if drawn.is_empty() {
        return None;
    }
    let panels = (0..count).map(|mount| {
        let rows: Vec<(f64, &[f64])> = drawn.iter().map(|&k| (all[k], table[mount][k].as_slice())).collect();
        waterfall_panel(study, &study.response.mounts[mount], &rows, high)
    });
    Some(Figure {
        id: "mount-waterfall".to_owned(),
        title: "Waterfall: speed and order".to_owned(),
        caption: "Amplitude of every order at each mount against speed, all to one scale; a dot is where an order meets a \
                  natural frequency of the block."
            .to_owned(),
        panels: panels.collect(),
        columns: 2,
    })
}

fn waterfall_panel(study: &MountStudy, name: &str, rows: &[(f64, &[f64])], high: f64) -> Panel {
    let (foot, summit) = (30.0, 84.0);
    let mut svg = Svg::new(WIDTH, 30.0 + summit + foot * rows.len() as f64 + BOTTOM);
    let bottom = svg.height - BOTTOM;
    let scale = number::Scale::of(high, "N");
    let most = rows.iter().map(|(_, values)| largest(values)).fold(0.0, f64::max);
    let head = format!("{name}: up to {} {}", number::short(most / scale.divisor, 4), scale.unit);
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &head);
    let speeds = speed_axis(&mut svg, study, 24.0, bottom);
    let right = WIDTH - RIGHT;
    let (first, last) =
        (speeds.ticks.first().copied().unwrap_or(0.0), speeds.ticks.last().copied().unwrap_or(0.0));
    for (index, (order, values)) in rows.iter().enumerate().rev() {
        let level = bottom - foot * index as f64;
        svg.line("grid", (LEFT, level), (right, level));
        svg.text("small", (LEFT - 6.0, level + 4.0), Anchor::End, &number::order(*order));
        let points = study.response.speeds.iter().zip(*values).map(|(s, value)| {
            (speeds.place(number::rpm(s.speed), LEFT, right), level - summit * value / high)
        });
        svg.path(&format!("s{}", 1 + index % 5), &Path::through(points));
        for mode in &study.modes.modes {
            let meets = number::rpm(mode.angular_frequency / order);
            if meets >= first && meets <= last {
                svg.circle("dot", (speeds.place(meets, LEFT, right), level), 2.2);
            }
        }
    }
    svg.text("muted small", (4.0, 30.0), Anchor::Start, "order");
    Panel::new(svg, format!("Orders at {name} against speed: {} orders.", rows.len()))
}

/// Transmissibility in the six coordinates against frequency, both logarithmic.
fn transmissibility(study: &MountStudy) -> Figure {
    let data = &study.transmissibility;
    let hertz: Vec<f64> = data.angular_frequency.iter().map(|w| w / TAU).collect();
    let (low, high) =
        (hertz.first().copied().unwrap_or(1.0).log10(), hertz.last().copied().unwrap_or(10.0).log10());
    let ratios = data.ratio.iter().flatten().copied().filter(|r| *r > 0.0);
    let (least, most) = ratios.fold((1.0f64, 1.0f64), |(a, b), r| (a.min(r), b.max(r)));
    let (least, most) = (least.max(1e-4).log10().floor(), most.min(1e4).log10().ceil());
    let names: Vec<(String, usize)> =
        COORDINATES.iter().enumerate().map(|(k, n)| ((*n).to_owned(), k)).collect();
    let width = 620.0;
    let legend = Legend::of(&names, 4.0, width);
    let top = 26.0 + legend.height;
    let mut svg = Svg::new(width, 330.0 + legend.height);
    let (right, bottom) = (width - RIGHT, svg.height - BOTTOM);
    let x = |hertz: f64| LEFT + (hertz.log10() - low) / (high - low) * (right - LEFT);
    let y = |ratio: f64| {
        let value = ratio.log10().clamp(least, most);
        bottom - (value - least) / (most - least) * (bottom - top)
    };
    svg.text("muted small", (4.0, 13.0), Anchor::Start, "passed on over exciting");
    legend.draw(&mut svg);
    for decade in least as i32..=most as i32 {
        let level = y(10f64.powi(decade));
        svg.line(if decade == 0 { "zero" } else { "grid" }, (LEFT, level), (right, level));
        svg.text("small", (LEFT - 6.0, level + 4.0), Anchor::End, &number::trimmed(10f64.powi(decade), 3));
    }
    for decade in low.floor() as i32..=high.ceil() as i32 {
        for step in [1.0, 2.0, 5.0] {
            let hertz = step * 10f64.powi(decade);
            if hertz.log10() >= low && hertz.log10() <= high {
                svg.line("grid", (x(hertz), top), (x(hertz), bottom));
                svg.text("small", (x(hertz), bottom + 17.0), Anchor::Middle, &number::trimmed(hertz, 3));
            }
        }
    }
    svg.text("muted small", ((LEFT + right) / 2.0, bottom + 37.0), Anchor::Middle, "frequency [Hz]");
    for c in (0..6).rev() {
        let points = hertz.iter().zip(&data.ratio).map(|(&f, ratio)| (x(f), y(ratio[c].max(1e-300))));
        svg.path(&format!("s{c}"), &Path::through(points));
    }
    for mode in &study.modes.modes {
        let at = x(mode.angular_frequency / TAU);
        svg.line("thin", (at, bottom), (at, bottom - 8.0));
    }
    let description = "Transmissibility of the mounts in six coordinates, logarithmic.".to_owned();
    Figure {
        id: "mount-transmissibility".to_owned(),
        title: "Transmissibility of the mounts".to_owned(),
        caption: "A unit load in one coordinate at the block's centre, and what all mounts together pass on in the same one. \
                  Marks at the foot are the natural frequencies."
            .to_owned(),
        panels: vec![Panel::new(svg, description)],
        columns: 1,
    }
}
