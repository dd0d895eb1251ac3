//! Shear force and bending moment along a crankshaft, with the crank above as orientation.

use crate::bearings::internal_noise::Noise;
use crate::engine::crank_strip;
use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number::{self, Scale};
use crate::kit::plot::{Legend, WIDTH, value_axis};
use crate::kit::svg::{Anchor, Path, Svg};
use lanchester_mechanism::{BeamLoads, BeamModel, InternalMoments};
use lanchester_model::Engine;
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, TAU};

const PLOT: f64 = 216.0;
const LEFT: f64 = 60.0;
const RIGHT: f64 = 14.0;
const BOTTOM: f64 = 44.0;

/// Points of a curve between two neighbouring stations.
const FINENESS: usize = 8;

/// What is plotted along the shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Quantity {
    Moment,
    Shear,
}

impl Quantity {
    /// Name for files.
    fn id(self) -> &'static str {
        match self {
            Quantity::Moment => "bending-moment",
            Quantity::Shear => "shear-force",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Quantity::Moment => "Bending moment",
            Quantity::Shear => "Shear force",
        }
    }

    fn unit(self) -> &'static str {
        match self {
            Quantity::Moment => "N m",
            Quantity::Shear => "N",
        }
    }
}

/// A curve along z in SI.
struct Curve {
    name: String,
    style: usize,
    points: Vec<(f64, f64)>,
    /// Drawn a second time below the axis: a size has no sign.
    mirrored: bool,
}

/// Shear force and bending moment along every crankshaft in both models.
///
/// Where only what turns counts in the first of `cases`, its envelope stands beside those of all others; else what it does at
/// two instants, and its envelope without counterweights.
pub fn internal_figures(engine: &Engine, cases: &[InternalMoments]) -> Vec<Figure> {
    let Some(first) = cases.first() else { return Vec::new() };
    let turns_only = first.reciprocating_share == 0.0;
    let compared: Vec<&InternalMoments> = cases
        .iter()
        .skip(1)
        .filter(|case| turns_only || case.reciprocating_share == first.reciprocating_share)
        .collect();
    let noise = Noise::of(cases);
    let mut figures = Vec::with_capacity(4 * first.crankshafts.len());
    for (place, shaft) in first.crankshafts.iter().enumerate() {
        let several = engine.crankshafts.len() > 1;
        let name = &engine.crankshafts[shaft.crankshaft - 1].name;
        for quantity in [Quantity::Moment, Quantity::Shear] {
            for model in BeamModel::ALL {
                let beam = shaft.of(model);
                let mut curves = vec![envelope(first, first, beam, quantity)];
                if !turns_only {
                    curves.extend(instants(first, beam, quantity, &noise));
                }
                curves.extend(
                    compared
                        .iter()
                        .map(|case| envelope(case, first, case.crankshafts[place].of(model), quantity)),
                );
                let id = format!("{}-{}", quantity.id(), model.name().replace(' ', "-"));
                let title = format!("{}, {}", quantity.name(), model.name());
                figures.push(Figure {
                    id: if several { format!("{id}-{}", shaft.crankshaft) } else { id },
                    title: if several { format!("{title}: {name}") } else { title },
                    caption: caption(first, model),
                    panels: vec![panel(engine, shaft.crankshaft - 1, beam, model, quantity, &curves, &noise)],
                    columns: 1,
                });
            }
        }
    }
    figures
}

fn caption(first: &InternalMoments, model: BeamModel) -> String {
    let held = match model {
        BeamModel::FreeBeam => {
            "The crankshaft as a free beam: only what its loads do not hold in balance by themselves is carried, by the end \
             mains."
        }
        BeamModel::ThrowByThrow => {
            "Every throw held by the main bearings beside it, as if the shaft were cut through there."
        }
    };
    let shown = match first.reciprocating_share {
        0.0 => "The largest over the cycle, whatever its direction: of what rotates alone, and with all of the reciprocating \
                forces."
            .to_owned(),
        _ => format!(
            "Loads: {}. The largest over the cycle, whatever its direction; and what acts at two instants in the plane of the \
             bending peak.",
            loads_in_words(first)
        ),
    };
    format!("{held} {shown} Above, the crank at θ = 0 with the numbers of its main bearings.")
}

/// "rotating parts and counterweights, with 50 % of the reciprocating forces".
fn loads_in_words(case: &InternalMoments) -> String {
    let weights = if case.counterweights { " and counterweights" } else { "" };
    let percent = number::trimmed(100.0 * case.reciprocating_share, 3);
    format!("rotating parts{weights}, with {percent} % of the reciprocating forces")
}

/// The largest over the cycle of one case, named by what makes it differ from the `first`.
fn envelope(case: &InternalMoments, first: &InternalMoments, beam: &BeamLoads, quantity: Quantity) -> Curve {
    let bare = case.counterweights != first.counterweights;
    let turns_only = first.reciprocating_share == 0.0;
    let (name, style) = match (turns_only, case.reciprocating_share > 0.0, bare) {
        (true, false, false) => ("rotating", 0),
        (true, false, true) => ("rotating, no counterweights", 2),
        (true, true, false) => ("and reciprocating", 1),
        (true, true, true) => ("and reciprocating, no counterweights", 3),
        (false, _, false) => ("largest", 0),
        (false, _, true) => ("largest without counterweights", 2),
    };
    Curve {
        name: name.to_owned(),
        style,
        points: along(beam, quantity, |values| values.iter().map(|v| v.norm()).fold(0.0, f64::max)),
        mirrored: true,
    }
}

/// What acts when the bending moment peaks and a quarter turn later, in the plane of that peak; none where nothing bends.
fn instants(case: &InternalMoments, beam: &BeamLoads, quantity: Quantity, noise: &Noise) -> Vec<Curve> {
    let peak = beam.peak_moment;
    if peak.value <= noise.moment {
        return Vec::new();
    }
    let instants = [peak.theta, (peak.theta + FRAC_PI_2) % case.period].map(|t| nearest(case, t));
    let worst =
        beam.stations.iter().find(|s| s.z == peak.z).map_or(Complex64::ONE, |s| s.moment[instants[0]]);
    // Forces along d bend by -i d times a lever: d spans the plane in which the peak acts.
    let direction = Complex64::I * worst / worst.norm().max(f64::MIN_POSITIVE);
    let curve = |(style, at): (usize, usize)| {
        let points = along(beam, quantity, |values| {
            let turned = if quantity == Quantity::Moment { Complex64::I * values[at] } else { values[at] };
            (direction.conj() * turned).re
        });
        let name = format!("at θ = {}°", number::trimmed(case.theta[at].to_degrees(), 4));
        Curve { name, style, points, mirrored: false }
    };
    [1, 3].into_iter().zip(instants).map(curve).collect()
}

/// Index of the crank angle nearest to `theta` [rad].
fn nearest(case: &InternalMoments, theta: f64) -> usize {
    let count = case.theta.len();
    ((theta / case.period * count as f64).round() as usize) % count.max(1)
}

/// Points (z, value) along the shaft, `value` of the quantity at all crank angles.
fn along(beam: &BeamLoads, quantity: Quantity, value: impl Fn(&[Complex64]) -> f64) -> Vec<(f64, f64)> {
    let mut points = Vec::with_capacity(beam.stations.len() * (FINENESS + 1));
    let mut before = 0.0;
    for (k, station) in beam.stations.iter().enumerate() {
        if quantity == Quantity::Shear {
            let behind = value(&station.shear);
            points.extend([(station.z, before), (station.z, behind)]);
            before = behind;
            continue;
        }
        points.push((station.z, value(&station.moment)));
        let Some(next) = beam.stations.get(k + 1) else { continue };
        // dM/dz = -i Q: straight at each instant, but its size is not.
        for part in 1..FINENESS {
            let share = part as f64 / FINENESS as f64;
            let lever = Complex64::new(0.0, -(next.z - station.z) * share);
            let between: Vec<Complex64> =
                station.moment.iter().zip(&station.shear).map(|(m, q)| m + lever * q).collect();
            points.push((station.z + share * (next.z - station.z), value(&between)));
        }
    }
    points
}

fn panel(
    engine: &Engine,
    index: usize,
    beam: &BeamLoads,
    model: BeamModel,
    quantity: Quantity,
    curves: &[Curve],
    noise: &Noise,
) -> Panel {
    let largest = curves.iter().flat_map(|c| &c.points).fold(0.0f64, |m, p| m.max(p.1.abs()));
    let floor = if quantity == Quantity::Moment { noise.moment } else { noise.force };
    let largest = if largest > floor { largest } else { 0.0 };
    let scale = Scale::of(largest, quantity.unit());
    let reach = largest / scale.divisor;
    let axis = Axis::of(-reach, reach, 6);
    let ends = [&beam.stations[0], &beam.stations[beam.stations.len() - 1]].map(|s| 1e3 * s.z);
    let margin = 0.03 * (ends[1] - ends[0]);
    let along = Axis::stepped(ends[0] - margin, ends[1] + margin, Axis::of(ends[0], ends[1], 6).step());

    let names: Vec<(String, usize)> = curves.iter().map(|c| (c.name.clone(), c.style)).collect();
    let legend = Legend::of(&names, 4.0, WIDTH + 10.0);
    let strip = 26.0 + legend.height;
    let top = strip + crank_strip::HEIGHT;
    let bottom = top + PLOT;
    let right = WIDTH - RIGHT;
    let mut svg = Svg::new(WIDTH, bottom + BOTTOM);
    let title = format!("{}, {} [{}]", quantity.name(), model.name(), scale.unit);
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &title);
    legend.draw(&mut svg);
    value_axis(&mut svg, &axis, top, bottom);
    let place = |z: f64| along.place(1e3 * z, LEFT, right);
    let mains: Vec<f64> = beam.mains.iter().map(|m| m.z).collect();
    for &main in &mains {
        svg.line("grid dashed", (place(main), strip + 52.0), (place(main), bottom));
    }
    crank_strip::draw(&mut svg, engine, index, &mains, strip, place);
    for &tick in &along.ticks {
        let x = along.place(tick, LEFT, right);
        svg.line("zero", (x, bottom), (x, bottom + 4.0));
        svg.text("small", (x, bottom + 17.0), Anchor::Middle, &number::fixed(tick, along.decimals));
    }
    svg.text("muted small", ((LEFT + right) / 2.0, bottom + 37.0), Anchor::Middle, "z [mm]");
    if largest == 0.0 {
        let middle = ((LEFT + right) / 2.0, 0.5 * (top + bottom) - 12.0);
        svg.text("muted halo", middle, Anchor::Middle, "zero along the whole shaft");
    } else {
        for curve in curves.iter().rev() {
            let signs: &[f64] = if curve.mirrored { &[1.0, -1.0] } else { &[1.0] };
            for sign in signs {
                let on_screen =
                    |&(z, v): &(f64, f64)| (place(z), axis.place(sign * v / scale.divisor, bottom, top));
                let path = Path::through(curve.points.iter().map(on_screen));
                svg.path(&format!("s{}", curve.style), &path);
            }
        }
    }
    Panel::new(svg, description(beam, model, quantity, &scale, floor))
}

fn description(beam: &BeamLoads, model: BeamModel, quantity: Quantity, scale: &Scale, floor: f64) -> String {
    let (name, model) = (quantity.name(), model.name());
    let peak = if quantity == Quantity::Moment { beam.peak_moment } else { beam.peak_shear };
    if peak.value <= floor {
        return format!("{name} along the crankshaft, {model}: zero everywhere.");
    }
    format!(
        "{name} along the crankshaft, {model}: at most {} {}, at z = {} mm and θ = {} degrees.",
        number::short(peak.value / scale.divisor, 4),
        scale.unit,
        number::short(1e3 * peak.z, 4),
        number::trimmed((peak.theta % (2.0 * TAU)).to_degrees(), 4)
    )
}
