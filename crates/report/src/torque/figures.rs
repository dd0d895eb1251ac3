//! Torque, pressure, firing and speed as drawings.

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::plot::{AnglePlot, Bar, BarPlot, LEFT, RIGHT, Series, WIDTH};
use crate::kit::rounding::below;
use crate::kit::svg::{Anchor, Svg};
use crate::kit::xy_plot::{XyCurve, XyPlot};
use lanchester_mechanism::{FiringChart, PowerCurve, RippleOutcome, SpeedRipple, Torque};
use std::f64::consts::TAU;

fn figure(id: &str, title: &str, caption: &str, panels: Vec<Panel>) -> Figure {
    Figure { id: id.to_owned(), title: title.to_owned(), caption: caption.to_owned(), panels, columns: 1 }
}

/// Torque over the cycle, by cylinder, p-V diagrams, orders, strokes and the firing star.
pub fn torque_figures(torque: &Torque) -> Vec<Figure> {
    let mut figures = vec![whole(torque)];
    if torque.with_gas {
        figures.extend([by_cylinder(torque), pressure_volume(torque)]);
    }
    figures.push(orders(torque));
    if !torque.firing.firings.is_empty() {
        figures.extend([strokes(&torque.firing), firing_star(&torque.firing)]);
    }
    figures
}

fn plot<'a>(torque: &'a Torque, quantity: &'a str, series: Vec<Series<'a>>) -> Panel {
    AnglePlot { quantity, unit: "N m", theta: &torque.theta, period: torque.period, series }.panel()
}

fn whole(torque: &Torque) -> Figure {
    let total: Vec<f64> = torque.gas.iter().zip(&torque.inertia).map(|(a, b)| a + b).collect();
    let mean = vec![torque.energy.mean; torque.theta.len()];
    let series = |name: &str, style, values| Series { name: name.to_owned(), style, values };
    let (shown, caption) = match torque.with_gas {
        true => (
            vec![
                series("gas and inertia", 0, &total),
                series("gas", 1, &torque.gas),
                series("inertia", 2, &torque.inertia),
                series("mean", 3, &mean),
            ],
            "Gas, inertia at constant speed, and both; the load takes the mean.",
        ),
        false => (vec![series("inertia", 0, &torque.inertia)], "Inertia at constant speed; there is no gas."),
    };
    let panel = plot(torque, "Torque", shown);
    figure("torque", "Torque over the cycle", caption, vec![panel])
}

fn by_cylinder(torque: &Torque) -> Figure {
    let series = torque.cylinders.iter().enumerate().map(|(k, cylinder)| Series {
        name: format!("cylinder {}", cylinder.cylinder),
        style: 1 + k % 5,
        values: &cylinder.gas,
    });
    let panel = plot(torque, "Gas torque", series.collect());
    figure("torque-by-cylinder", "Gas torque of the cylinders", "Each at its firing angle.", vec![panel])
}

fn pressure_volume(torque: &Torque) -> Figure {
    let curves = torque.cylinders.iter().enumerate().map(|(k, cylinder)| {
        let clearance = cylinder.clearance.unwrap_or(0.0);
        let points = cylinder.volume.iter().zip(&cylinder.pressure);
        let points = points.map(|(v, p)| ((clearance + v) * 1e6, *p));
        // One working cycle closes on itself.
        let points: Vec<(f64, f64)> = points.collect();
        let closing = points.first().copied();
        XyCurve {
            name: format!("cylinder {}", cylinder.cylinder),
            style: if k == 0 { 0 } else { 1 + (k - 1) % 5 },
            points: points.into_iter().chain(closing).collect(),
            dots: false,
        }
    });
    let has_clearance = torque.cylinders.iter().all(|cylinder| cylinder.clearance.is_some());
    let plot = XyPlot {
        abscissa: if has_clearance { "Volume" } else { "Volume above that at top dead centre" },
        ordinate: "Pressure, absolute",
        units: ["cm\u{b3}", "Pa"],
        polar: None,
        curves: curves.collect(),
    };
    let series = torque.cylinders.iter().enumerate().map(|(k, cylinder)| Series {
        name: format!("cylinder {}", cylinder.cylinder),
        style: if k == 0 { 0 } else { 1 + (k - 1) % 5 },
        values: &cylinder.pressure,
    });
    let over_angle = AnglePlot {
        quantity: "Pressure, absolute",
        unit: "Pa",
        theta: &torque.theta,
        period: torque.period,
        series: series.collect(),
    };
    figure(
        "pressure-volume",
        "Pressure over volume and crank angle",
        if has_clearance {
            "The area within is the work of a cycle."
        } else {
            "The area within is the work of a cycle. The file gives no compression ratio: the volume counts from top dead centre."
        },
        vec![plot.panel(), over_angle.panel()],
    )
}

fn orders(torque: &Torque) -> Figure {
    let noise = below(torque.total_extremes.max_abs());
    let bars = |quantity, of: fn(&lanchester_mechanism::TorqueHarmonic) -> f64| {
        let listed = torque.harmonics.iter().filter(|h| h.order > 0.0);
        let bars = listed.map(|h| Bar { at: h.order, value: of(h) }).collect();
        BarPlot { quantity, unit: "N m", bars, noise, two_sided: false }.panel()
    };
    if !torque.with_gas {
        let panels = vec![bars("Torque of inertia", |h| h.inertia.norm())];
        return figure("torque-orders", "Torque by order", "Amplitudes.", panels);
    }
    let panels = vec![
        bars("Torque of gas and inertia", |h| h.total().norm()),
        bars("Torque of gas", |h| h.gas.norm()),
        bars("Torque of inertia", |h| h.inertia.norm()),
    ];
    let caption = "Amplitudes. Four strokes bring half orders.";
    Figure { columns: 3, ..figure("torque-orders", "Torque by order", caption, panels) }
}

/// Strokes of every cylinder over the period, in firing order.
fn strokes(firing: &FiringChart) -> Figure {
    const ROW: f64 = 26.0;
    let order = firing.order();
    let turns = (firing.period / TAU).round().max(1.0);
    let axis = Axis::stepped(0.0, 360.0 * turns, 90.0 * (turns / 2.0).ceil());
    let (top, right) = (26.0, WIDTH - RIGHT);
    let bottom = top + ROW * order.len() as f64;
    let mut svg = Svg::new(WIDTH, bottom + 44.0);
    svg.text("muted small", (4.0, 13.0), Anchor::Start, "Cylinder");
    let place = |theta: f64| axis.place(theta.to_degrees(), LEFT, right);
    for (row, number) in order.iter().enumerate() {
        let y = top + ROW * row as f64;
        svg.text("small", (LEFT - 8.0, y + 17.0), Anchor::End, &number.to_string());
        for span in &firing.cylinders[number - 1].strokes {
            // A stroke that runs over the end of the period goes on at its start.
            for shift in [0.0, -firing.period] {
                let from = (span.from + shift).max(0.0);
                let to = (span.to + shift).min(firing.period);
                if to - from <= 1e-9 * firing.period {
                    continue;
                }
                let class = if span.stroke.letter() == 'P' { "bar1" } else { "metal" };
                svg.rect(class, place(from), y + 3.0, place(to) - place(from), ROW - 6.0);
                let middle = (0.5 * (place(from) + place(to)), y + 17.0);
                svg.text("small halo", middle, Anchor::Middle, &span.stroke.letter().to_string());
            }
        }
    }
    for &tick in &axis.ticks {
        let x = axis.place(tick, LEFT, right);
        svg.line("zero", (x, bottom), (x, bottom + 4.0));
        svg.text("small", (x, bottom + 17.0), Anchor::Middle, &format!("{tick:.0}"));
    }
    svg.text(
        "muted small",
        ((LEFT + right) / 2.0, bottom + 37.0),
        Anchor::Middle,
        "crank angle \u{3b8} [deg]",
    );
    let said: Vec<String> = firing.firings.iter().map(|f| f.cylinder.to_string()).collect();
    let panel = Panel::new(svg, format!("Cylinders fire in the order {}.", said.join("-")));
    figure(
        "strokes",
        "Strokes",
        "P power, E exhaust, I intake, C compression, from dead centre to dead centre.",
        vec![panel],
    )
}

/// Throws as arrows with the sequence in which their cylinders fire.
fn firing_star(firing: &FiringChart) -> Figure {
    const SIZE: f64 = 300.0;
    let centre = (SIZE / 2.0, SIZE / 2.0);
    let mut svg = Svg::new(SIZE, SIZE);
    let radius = 92.0;
    svg.circle("zero", centre, radius);
    let at = |angle: f64, size: f64| (centre.0 + size * angle.sin(), centre.1 - size * angle.cos());
    let mut directions: Vec<(f64, Vec<String>)> = Vec::new();
    let mut said = Vec::new();
    for (k, fired) in firing.firings.iter().enumerate() {
        let label = format!("{}: cyl. {}", k + 1, fired.cylinder);
        said.push(label.clone());
        let angle = fired.throw_angle.rem_euclid(TAU);
        match directions.iter_mut().find(|(other, _)| (other - angle).abs() < 1e-6) {
            Some((_, labels)) => labels.push(label),
            None => directions.push((angle, vec![label])),
        }
    }
    for (angle, labels) in &directions {
        svg.arrow("arrow a1", centre, at(*angle, radius), 10.0);
        let (x, y) = at(*angle, radius + 26.0);
        for (row, label) in labels.iter().enumerate() {
            let y = y + 14.0 * (row as f64 - 0.5 * (labels.len() as f64 - 1.0)) + 4.0;
            svg.text("small halo", (x, y), Anchor::Middle, label);
        }
    }
    let panel = Panel::new(svg, format!("Sequence of firing: {}.", said.join(", ")));
    let caption = "Throws as they stand at theta = 0, x up, seen so that the crank turns clockwise; numbers count the firings.";
    let stars: Vec<Bar> = firing.stars.iter().map(|s| Bar { at: s.order, value: s.share }).collect();
    let bars =
        BarPlot { quantity: "Share", unit: "1", bars: stars, noise: below(1.0), two_sided: false }.panel();
    Figure {
        columns: 2,
        ..figure(
            "firing-star",
            "Crank star of firing",
            &format!(
                "{caption} Bars: how far equal cylinders add up in each order of the torque; 1 is all of them."
            ),
            vec![panel, bars],
        )
    }
}

/// Speed over the cycle at each of the mean speeds at which it is periodic; `None` if it is at none.
pub fn ripple_figure(ripples: &[RippleOutcome]) -> Option<Figure> {
    let panels: Vec<Panel> = ripples
        .iter()
        .filter_map(RippleOutcome::periodic)
        .map(|ripple: &SpeedRipple| {
            let rpm: Vec<f64> = ripple.speed.iter().map(|w| 100.0 * (w / ripple.mean_speed - 1.0)).collect();
            let speed = number::terminal(number::rpm(ripple.mean_speed), 0);
            AnglePlot {
                quantity: &format!("Speed over its mean of {speed} rpm, less 1"),
                unit: "%",
                theta: &ripple.theta,
                period: ripple.period,
                series: vec![Series { name: "speed".to_owned(), style: 0, values: &rpm }],
            }
            .panel()
        })
        .collect();
    let caption = "With the inertia of the crank train over the angle.";
    (!panels.is_empty()).then(|| figure("speed-ripple", "Cyclic speed fluctuation", caption, panels))
}

/// Power and torque over speed with the cubic through the origin.
pub fn power_figure(curve: &PowerCurve) -> Figure {
    let highest = curve.points.iter().map(|p| p.0).fold(0.0, f64::max);
    let speeds = || (0..=120).map(|k| highest * f64::from(k) / 120.0);
    let panel = |ordinate, unit, cubic: Vec<(f64, f64)>, points: Vec<(f64, f64)>| {
        let curves = vec![
            XyCurve { name: "cubic".to_owned(), style: 0, points: cubic, dots: false },
            XyCurve { name: "points".to_owned(), style: 1, points, dots: true },
        ];
        XyPlot { abscissa: "Speed", ordinate, units: ["rpm", unit], polar: None, curves }.panel()
    };
    let of_power = speeds().map(|w| (number::rpm(w), curve.power(w))).collect();
    let of_torque = speeds().map(|w| (number::rpm(w), curve.torque(w))).collect();
    let points =
        |of: fn(&(f64, f64)) -> f64| curve.points.iter().map(|p| (number::rpm(p.0), of(p))).collect();
    figure(
        "power",
        "Power and torque over speed",
        "The cubic of the power through the origin that fits the points with the least squares, and the torque that follows from it.",
        vec![
            panel("Power", "W", of_power, points(|p| p.1)),
            panel("Torque", "N m", of_torque, points(|p| p.1 / p.0)),
        ],
    )
}

/// A closed curve for polar diagrams.
pub(crate) fn closed(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = points.collect();
    points.extend(points.first().copied());
    points
}
