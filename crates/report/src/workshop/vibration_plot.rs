//! Vibration vectors of every sensor, before, with trial weights and after; and where on the rotor to add or remove.

use super::correction::unit;
use super::grade::plain;
use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::svg::{Anchor, Path, Svg, text_width, wrap};
use lanchester_task::workshop::{Action, Allowed, Plane, Sense, Sheet};
use lanchester_workshop::{Correction, PlaneCorrection, RunFindings, SAME_SPEED, SensorPrediction};
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const WIDTH: f64 = 300.0;
const HEIGHT: f64 = 338.0;
const RADIUS: f64 = 104.0;
const CENTRE: (f64, f64) = (WIDTH / 2.0, 172.0);

/// One drawing for every sensor at every speed, and one for every plane of the correction where the sheet states the
/// sense of its marks. `None` where there is nothing to draw.
pub fn vibration_figure(sheet: &Sheet, correction: &Correction) -> Option<Figure> {
    let mut panels = Vec::new();
    let mut legend = String::new();
    if let Some(runs) = &correction.runs {
        panels.extend(runs.sensors.iter().map(|sensor| sensor_panel(runs, sensor)));
        let names: Vec<String> =
            runs.log.iter().enumerate().map(|(k, run)| format!("{} {}", k + 1, run.name)).collect();
        legend = format!(
            "Vibration as the instruments show it: {}. Thin lines: what the weights of a run changed against the first run at its \
             speed. Green, or a ring where nothing is left: as predicted with the corrections. Dashed circle: the limit. ",
            names.join("; ")
        );
    }
    if let Some(marks) = sheet.rotor.marks {
        for correction in &correction.planes {
            if let Some(plane) = sheet.planes.iter().find(|plane| plane.name == correction.plane) {
                panels.push(plane_panel(plane, correction, marks, sheet.rotor.rotation));
            }
        }
        if !correction.planes.is_empty() {
            legend += "Rotor: where to add or remove, in the sense in which its marks count; dots and thick arcs are the angles \
                       that may be used.";
        }
    }
    let columns = if panels.len() == 4 { 2 } else { panels.len().min(3) };
    (!panels.is_empty()).then(|| Figure {
        id: "vibration".to_owned(),
        title: correction.name.clone(),
        caption: legend.trim().to_owned(),
        panels,
        columns,
    })
}

/// A circle of degrees: where a vector stands on the screen.
struct Dial {
    /// Pixels for one unit.
    scale: f64,
    /// Screen angle (x right, y up) of 0 degrees, and sense in which degrees count: 1 anticlockwise.
    zero: f64,
    sense: f64,
}

impl Dial {
    fn at(&self, vector: Complex64) -> (f64, f64) {
        let turned = Complex64::from_polar(vector.norm() * self.scale, self.zero + self.sense * vector.arg());
        (CENTRE.0 + turned.re, CENTRE.1 - turned.im)
    }

    /// A point at an angle and a distance in pixels.
    fn rim(&self, angle: f64, distance: f64) -> (f64, f64) {
        self.at(Complex64::from_polar(distance / self.scale, angle))
    }

    fn degrees(&self, svg: &mut Svg) {
        for quarter in 0..4 {
            let angle = f64::from(quarter) * FRAC_PI_2;
            svg.line("grid", CENTRE, self.rim(angle, RADIUS));
            let (x, y) = self.rim(angle, RADIUS + 16.0);
            svg.text("muted small", (x, y + 4.0), Anchor::Middle, &format!("{}°", quarter * 90));
        }
    }

    /// A label beyond the tip of a vector, moved out until it covers no other.
    fn label(&self, svg: &mut Svg, placed: &mut Vec<(f64, f64)>, vector: Complex64, text: &str) {
        let direction = if vector.norm() > 0.0 { vector / vector.norm() } else { Complex64::from(1.0) };
        // Clear of the ring at the centre.
        let mut distance = (vector.norm() * self.scale + 11.0).max(17.0);
        let half = 0.5 * text_width(text, 12.0);
        let mut at = self.at(direction * (distance / self.scale));
        for _ in 0..8 {
            if !placed.iter().any(|(x, y)| (x - at.0).abs() < 7.0 + half && (y - at.1).abs() < 13.0) {
                break;
            }
            distance += 6.0;
            at = self.at(direction * (distance / self.scale));
        }
        placed.push(at);
        svg.name("small strong halo", (at.0, at.1 + 4.0), Anchor::Middle, text);
    }
}

fn sensor_panel(runs: &RunFindings, sensor: &SensorPrediction) -> Panel {
    let (unit, factor) = unit(sensor.now.quantity);
    let measured: Vec<(usize, Complex64)> = runs
        .log
        .iter()
        .enumerate()
        .filter(|(_, run)| (run.speed - sensor.speed).abs() <= SAME_SPEED * sensor.speed)
        .filter_map(|(index, run)| {
            let entry = run.sensors.iter().find(|entry| entry.sensor == sensor.sensor)?;
            Some((index + 1, factor * entry.measured.vector()))
        })
        .collect();
    let after = sensor.after.map(|after| factor * after.vector());
    let limit = sensor.limit.map(|limit| factor * limit);
    let largest = measured
        .iter()
        .map(|(_, v)| v.norm())
        .chain(after.map(|v| v.norm()))
        .chain(limit)
        .fold(0.0, f64::max);
    let axis = Axis::of(0.0, largest, 4);
    let dial = Dial { scale: RADIUS / axis.high, zero: 0.0, sense: 1.0 };

    let mut svg = Svg::new(WIDTH, HEIGHT);
    svg.name("strong", (WIDTH / 2.0, 16.0), Anchor::Middle, &sensor.sensor);
    let rpm = number::fixed(number::rpm(sensor.speed), 0);
    svg.text("muted small", (WIDTH / 2.0, 33.0), Anchor::Middle, &format!("{rpm} rpm, {unit}"));
    dial.degrees(&mut svg);
    for tick in axis.ticks.iter().filter(|tick| **tick > 0.0) {
        svg.circle("grid", CENTRE, tick * dial.scale);
    }
    if let Some(limit) = limit {
        svg.circle("thin dashed", CENTRE, limit * dial.scale);
    }
    let mut placed = Vec::new();
    for (_, vector) in measured.iter().skip(1) {
        svg.line("thin", dial.at(measured[0].1), dial.at(*vector));
    }
    for (order, (number, vector)) in measured.iter().enumerate() {
        svg.arrow(if order == 0 { "arrow a0" } else { "arrow a1" }, CENTRE, dial.at(*vector), 11.0);
        dial.label(&mut svg, &mut placed, *vector, &number.to_string());
    }
    if let Some(after) = after {
        if after.norm() * dial.scale < 4.0 {
            svg.circle("ring", CENTRE, 6.0);
        } else {
            svg.arrow("arrow a3", CENTRE, dial.at(after), 11.0);
            dial.label(&mut svg, &mut placed, after, "after");
        }
    }
    let ray = free_ray(measured.iter().map(|(_, vector)| *vector).chain(after));
    for tick in axis.ticks.iter().filter(|tick| **tick > 0.0) {
        let at = dial.rim(ray, tick * dial.scale);
        svg.text("muted small halo", at, Anchor::Middle, &number::fixed(*tick, axis.decimals));
    }
    let now = format!("{} {unit}", plain(factor * sensor.now.amplitude, 3));
    let then = after.map_or(String::new(), |after| format!(", after {} {unit}", plain(after.norm(), 3)));
    foot(&mut svg, &format!("now {now}{then}"));
    Panel::new(svg, format!("Sensor {} at {rpm} rpm: now {now}{then}.", sensor.sensor))
}

/// What a drawing says, in at most two lines below it.
fn foot(svg: &mut Svg, text: &str) {
    for (index, line) in wrap(text, 13.5, WIDTH).iter().take(2).enumerate() {
        svg.text("strong", (WIDTH / 2.0, 315.0 + 16.0 * index as f64), Anchor::Middle, line);
    }
}

/// The direction between the quarters that is farthest from every vector, for the labels of the circles.
fn free_ray(vectors: impl Iterator<Item = Complex64>) -> f64 {
    let directions: Vec<f64> = vectors.filter(|vector| vector.norm() > 0.0).map(Complex64::arg).collect();
    let room = |ray: f64| {
        directions
            .iter()
            .map(|direction| {
                let turn = (ray - direction).rem_euclid(TAU);
                turn.min(TAU - turn)
            })
            .fold(PI, f64::min)
    };
    (0..8)
        .map(|k| (f64::from(k) + 0.5) * PI / 4.0)
        .max_by(|a, b| room(*a).total_cmp(&room(*b)))
        .unwrap_or(0.0)
}

fn plane_panel(plane: &Plane, correction: &PlaneCorrection, marks: Sense, rotation: Option<Sense>) -> Panel {
    let largest = correction.placements.iter().map(|at| at.unbalance).fold(0.0, f64::max);
    let disc = 0.86 * RADIUS;
    let sense = if marks == Sense::Anticlockwise { 1.0 } else { -1.0 };
    let dial = Dial { scale: 0.8 * disc / largest.max(f64::MIN_POSITIVE), zero: FRAC_PI_2, sense };
    let mut svg = Svg::new(WIDTH, HEIGHT);
    svg.name("strong", (WIDTH / 2.0, 16.0), Anchor::Middle, &plane.name);
    svg.text("muted small", (WIDTH / 2.0, 33.0), Anchor::Middle, "rotor");
    dial.degrees(&mut svg);
    svg.circle("outline", CENTRE, disc);
    if let Allowed::Some { angles, sectors } = &plane.allowed {
        for angle in angles {
            svg.circle("dot", dial.rim(*angle, disc), 2.5);
        }
        for [from, to] in sectors {
            let span = (to - from).rem_euclid(TAU);
            let arc = Path::new().move_to(dial.rim(*from, disc)).arc_to(
                disc,
                span > PI,
                sense < 0.0,
                dial.rim(from + span, disc),
            );
            svg.path("shaft-line", &arc);
        }
    }
    if let Some(rotation) = rotation {
        // A short arc above the centre, in the sense of rotation on the screen (y down).
        let (from, to) = (-FRAC_PI_2 - 0.6, -FRAC_PI_2 + 0.6);
        let (from, to) = if rotation == Sense::Clockwise { (from, to) } else { (to, from) };
        svg.arc_arrow("arrow turn", CENTRE, RADIUS + 4.0, from, to, 8.0);
    }
    let mut placed = Vec::new();
    let verb = if correction.action == Action::Add { "add" } else { "remove" };
    let mut words = Vec::new();
    for placement in &correction.placements {
        let vector = Complex64::from_polar(placement.unbalance, placement.angle);
        svg.arrow("arrow a2", CENTRE, dial.at(vector), 11.0);
        let amount = match placement.mass {
            Some(mass) => format!("{} g", plain(1e3 * mass, 3)),
            None => format!("{} g mm", plain(1e6 * placement.unbalance, 3)),
        };
        dial.label(&mut svg, &mut placed, vector, &amount);
        words.push(format!("{amount} at {}°", plain(placement.angle.to_degrees(), 4)));
    }
    svg.circle("dot", CENTRE, 2.5);
    let told =
        if words.is_empty() { "nothing to do".to_owned() } else { format!("{verb} {}", words.join(", ")) };
    foot(&mut svg, &told);
    Panel::new(svg, format!("Plane {}: {told}.", plane.name))
}
