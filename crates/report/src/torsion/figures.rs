//! Torsional vibration in pictures.

use super::result::TorsionResult;
use super::tables::aim_unit;
use crate::kit::figure::Figure;
use crate::kit::number;
use crate::kit::xy_plot::{XyCurve, XyPlot};
use lanchester_torsion::{StationKind, TuneFree, peak};

const DEGREES: f64 = 180.0 / std::f64::consts::PI;
/// Orders, modes and shafts drawn one by one.
const DRAWN: usize = 4;

/// All figures: Campbell diagram, twist and stress over speed, mode shapes, the damper.
pub fn torsion_figures(result: &TorsionResult) -> Vec<Figure> {
    let mut figures = vec![campbell(result)];
    if result.sweep.speeds.len() > 1 {
        figures.push(twist(result));
        figures.extend(stress(result));
    }
    figures.push(shapes(result));
    figures.extend(damper(result));
    figures.extend(tuning(result));
    figures
}

fn one(id: &str, title: &str, caption: &str, plot: &XyPlot<'_>) -> Figure {
    Figure {
        id: id.to_owned(),
        title: title.to_owned(),
        caption: caption.to_owned(),
        panels: vec![plot.panel()],
        columns: 1,
    }
}

fn campbell(result: &TorsionResult) -> Figure {
    let data = &result.campbell;
    let rpm: Vec<f64> = data.speeds.iter().map(|speed| number::rpm(*speed)).collect();
    let last = data.speeds.last().copied().unwrap_or(0.0);
    // Modes that an order reaches, at least one.
    let reach = data.orders.last().copied().unwrap_or(1.0) * last;
    let lowest = |curve: &Vec<f64>| curve.iter().copied().fold(f64::INFINITY, f64::min);
    let modes: Vec<&Vec<f64>> = data
        .frequencies
        .iter()
        .enumerate()
        .filter(|(index, curve)| *index == 0 || lowest(curve) < reach)
        .map(|(_, curve)| curve)
        .take(DRAWN)
        .collect();
    let highest = modes.iter().flat_map(|curve| curve.iter().copied()).fold(0.0, f64::max) * 1.05;
    let mut curves = Vec::new();
    let met: Vec<_> = data.criticals.iter().filter(|own| own.mode <= modes.len()).take(2 * DRAWN).collect();
    for (index, curve) in modes.iter().enumerate() {
        let points = rpm.iter().zip(curve.iter()).map(|(x, w)| (*x, w / std::f64::consts::TAU)).collect();
        curves.push(XyCurve {
            name: format!("mode {}", index + 1),
            style: index.min(DRAWN),
            points,
            dots: false,
        });
    }
    let mut orders: Vec<f64> = met.iter().map(|own| own.order).collect();
    orders.sort_by(f64::total_cmp);
    orders.dedup();
    let ray = |order: &f64| {
        let end = (highest / order).min(last);
        (number::order(*order), (number::rpm(end), order * end / std::f64::consts::TAU))
    };
    let rays: Vec<(String, (f64, f64))> = orders.iter().map(ray).collect();
    let points =
        met.iter().map(|own| (number::rpm(own.speed), own.frequency / std::f64::consts::TAU)).collect();
    curves.push(XyCurve { name: "strongest critical speeds".into(), style: 0, points, dots: true });
    let plot = XyPlot { abscissa: "speed", ordinate: "Frequency", units: ["rpm", "Hz"], polar: None, curves };
    Figure {
        id: "torsion-campbell".to_owned(),
        title: "Campbell diagram".to_owned(),
        caption: "Natural frequencies and orders over the speed, each order with its number; dots where the strongest orders meet a natural frequency.".to_owned(),
        panels: vec![plot.panel_with_rays("orders", &rays)],
        columns: 1,
    }
}

/// Curves of the strongest orders over speed, with the total before them.
fn with_orders(result: &TorsionResult, total: &[f64], by_order: &[Vec<f64>], scale: f64) -> Vec<XyCurve> {
    let rpm: Vec<f64> = result.sweep.speeds.iter().map(|speed| number::rpm(*speed)).collect();
    let through =
        |values: &[f64]| rpm.iter().zip(values).map(|(x, value)| (*x, scale * value)).collect::<Vec<_>>();
    let mut strongest: Vec<usize> = (0..by_order.len()).collect();
    strongest.sort_by(|a, b| peak(&by_order[*b]).1.total_cmp(&peak(&by_order[*a]).1));
    strongest.truncate(DRAWN);
    strongest.sort_unstable();
    let mut curves =
        vec![XyCurve { name: "all orders".into(), style: 0, points: through(total), dots: false }];
    for (style, order) in strongest.into_iter().enumerate() {
        let name = format!("order {}", number::order(result.sweep.orders[order]));
        curves.push(XyCurve { name, style: style + 1, points: through(&by_order[order]), dots: false });
    }
    curves
}

fn twist(result: &TorsionResult) -> Figure {
    let sweep = &result.sweep;
    let curves = with_orders(result, &sweep.twist.total, &sweep.twist.by_order, DEGREES);
    let plot = XyPlot {
        abscissa: "speed",
        ordinate: "Twist, amplitude",
        units: ["rpm", "deg"],
        polar: None,
        curves,
    };
    one(
        "torsion-twist",
        "Twist between nose and flywheel over speed",
        "Amplitude of all orders in true phase, and of the strongest orders alone.",
        &plot,
    )
}

fn stress(result: &TorsionResult) -> Option<Figure> {
    let rpm: Vec<f64> = result.sweep.speeds.iter().map(|speed| number::rpm(*speed)).collect();
    let mut known: Vec<(&lanchester_torsion::ShaftSweep, f64)> =
        result.sweep.shafts.iter().filter_map(|shaft| Some((shaft, shaft.stress_rate?))).collect();
    known.sort_by(|a, b| (b.0.peak().1 * b.1).total_cmp(&(a.0.peak().1 * a.1)));
    known.truncate(DRAWN + 1);
    if known.is_empty() {
        return None;
    }
    let curves = known
        .iter()
        .enumerate()
        .map(|(style, (shaft, rate))| XyCurve {
            name: result.crank.chain.shafts()[shaft.shaft].name.clone(),
            style,
            points: rpm.iter().zip(&shaft.total).map(|(x, torque)| (*x, torque * rate)).collect(),
            dots: false,
        })
        .collect();
    let plot = XyPlot {
        abscissa: "speed",
        ordinate: "Shear stress, amplitude",
        units: ["rpm", "Pa"],
        polar: None,
        curves,
    };
    Some(one(
        "torsion-stress",
        "Vibratory shear stress over speed",
        "Nominal, at the surface of the weakest journal or pin, all orders in true phase; the most stressed pieces.",
        &plot,
    ))
}

fn shapes(result: &TorsionResult) -> Figure {
    let chain = &result.crank.chain;
    let stations: Vec<usize> = (0..chain.stations().len())
        .filter(|index| {
            matches!(
                chain.stations()[*index].kind,
                StationKind::Ring
                    | StationKind::Nose
                    | StationKind::Throw(_)
                    | StationKind::Flywheel
                    | StationKind::Driven
            )
        })
        .collect();
    let curves = result
        .modes
        .iter()
        .take(3)
        .enumerate()
        .map(|(style, mode)| XyCurve {
            name: format!("{} Hz", number::short(mode.hertz(), 4)),
            style,
            points: stations
                .iter()
                .enumerate()
                .map(|(place, index)| (place as f64 + 1.0, mode.shape[*index]))
                .collect(),
            dots: false,
        })
        .collect();
    let names: Vec<String> = stations
        .iter()
        .enumerate()
        .map(|(place, index)| format!("{} {}", place + 1, chain.stations()[*index].name))
        .collect();
    let plot = XyPlot {
        abscissa: "station",
        ordinate: "Angle over the largest",
        units: ["1", "1"],
        polar: None,
        curves,
    };
    one(
        "torsion-modes",
        "Shapes of the first modes",
        &format!("Without damping. Stations: {}.", names.join(", ")),
        &plot,
    )
}

fn damper(result: &TorsionResult) -> Option<Figure> {
    let damper = result.sweep.damper.as_ref().filter(|_| result.sweep.speeds.len() > 1)?;
    let rpm: Vec<f64> = result.sweep.speeds.iter().map(|speed| number::rpm(*speed)).collect();
    let points = rpm.iter().zip(&damper.power).map(|(x, power)| (*x, *power)).collect();
    let curves = vec![XyCurve { name: "heat".into(), style: 0, points, dots: false }];
    let power = XyPlot {
        abscissa: "speed",
        ordinate: "Heat in the damper",
        units: ["rpm", "W"],
        polar: None,
        curves,
    };
    let curves = with_orders(result, &damper.ring, &damper.by_order, DEGREES);
    let ring = XyPlot {
        abscissa: "speed",
        ordinate: "Ring against hub",
        units: ["rpm", "deg"],
        polar: None,
        curves,
    };
    Some(Figure {
        id: "torsion-damper".into(),
        title: "The damper over speed".into(),
        caption: "Heat, and motion of the ring against its hub, amplitude in true phase and by the strongest orders.".into(),
        panels: vec![power.panel(), ring.panel()],
        columns: 2,
    })
}

fn tuning(result: &TorsionResult) -> Option<Figure> {
    let tuned = result.tuned.as_ref()?;
    let (scale, unit) = aim_unit(tuned.aim);
    let (name, own, best) = match tuned.free {
        TuneFree::Stiffness => ("stiffness", "N m/rad", tuned.stiffness),
        TuneFree::Damping | TuneFree::Both => ("damping", "N m s/rad", tuned.damping),
    };
    // What lies far above the best setting or the best peak tells nothing.
    let near = tuned.curve.iter().filter(|point| point.value < 4.0 * best && point.peak < 6.0 * tuned.peak);
    let points = near.map(|point| (point.value, scale * point.peak)).collect();
    let curves = vec![
        XyCurve { name: "peak over the speed range".into(), style: 0, points, dots: false },
        XyCurve { name: "best".into(), style: 0, points: vec![(best, scale * tuned.peak)], dots: true },
    ];
    let plot = XyPlot { abscissa: name, ordinate: "Peak", units: [own, unit], polar: None, curves };
    Some(one(
        "torsion-tuning",
        "Setting of the damper",
        "Peak over the speed range, all orders in true phase, against the setting; the dot is the best one.",
        &plot,
    ))
}
