//! Position, velocity and acceleration of the pistons over the crank angle.

use crate::kit::figure::Figure;
use crate::kit::number;
use crate::kit::plot::{AnglePlot, Series};
use lanchester_mechanism::{CylinderMotion, Loads, MotionTrace};

/// A column of the motion.
type Curve = fn(&MotionTrace) -> &[f64];

/// Kinds of motion that one plot can hold apart.
const MOST_CURVES: usize = 6;

/// One curve for each kind of motion: cylinders of one stroke and the same extremes are drawn once.
pub fn motion_plot(loads: &Loads) -> Option<Figure> {
    let kinds = kinds(&loads.motion);
    let angles = loads.motion.first()?.trace.theta.len();
    if angles < 2 {
        return None;
    }
    let quantities: [(&str, &str, f64, Curve); 3] = [
        ("Piston pin from the crank axis s", "mm", 1e3, |trace| &trace.position),
        ("Piston velocity", "m/s", 1.0, |trace| &trace.velocity),
        ("Piston acceleration", "m/s²", 1.0, |trace| &trace.acceleration),
    ];
    let shown = &kinds[..kinds.len().min(MOST_CURVES)];
    let panel = |(quantity, unit, factor, of): (&str, &str, f64, Curve)| {
        let scaled =
            |motion: &CylinderMotion| of(&motion.trace).iter().map(|v| factor * v).collect::<Vec<_>>();
        let columns: Vec<Vec<f64>> = shown.iter().map(|(motion, _)| scaled(motion)).collect();
        let curves = shown.iter().zip(&columns).enumerate();
        let series = curves
            .map(|(style, ((motion, _), values))| Series {
                name: format!("cylinder {}", motion.cylinder),
                style,
                values,
            })
            .collect();
        AnglePlot { quantity, unit, theta: &loads.motion[0].trace.theta, period: loads.period, series }
            .panel()
    };
    Some(Figure {
        id: "piston-motion".to_owned(),
        title: "Position, velocity and acceleration".to_owned(),
        caption: caption(&kinds),
        panels: quantities.into_iter().map(panel).collect(),
        columns: 3,
    })
}

/// Cylinders by kind of motion: the first of each kind, and the numbers of the others that move like it.
fn kinds(motions: &[CylinderMotion]) -> Vec<(&CylinderMotion, Vec<usize>)> {
    let mut kinds: Vec<(&CylinderMotion, Vec<usize>)> = Vec::new();
    for motion in motions {
        let alike = |other: &CylinderMotion| {
            let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(b.abs());
            close(motion.stroke, other.stroke)
                && close(motion.top, other.top)
                && close(motion.max_speed, other.max_speed)
                && close(motion.max_acceleration, other.max_acceleration)
                && close(motion.max_deceleration, other.max_deceleration)
        };
        match kinds.iter_mut().find(|(first, _)| alike(first)) {
            Some((_, others)) => others.push(motion.cylinder),
            None => kinds.push((motion, Vec::new())),
        }
    }
    kinds
}

fn caption(kinds: &[(&CylinderMotion, Vec<usize>)]) -> String {
    let mut out = "Positive away from the crank.".to_owned();
    for (first, others) in kinds.iter().take(MOST_CURVES).filter(|(_, others)| !others.is_empty()) {
        let verb = if others.len() == 1 { "moves" } else { "move" };
        out += &format!(
            " {} {verb} like {}, each at its own crank angle.",
            number::list(others),
            first.cylinder
        );
    }
    if kinds.len() > MOST_CURVES {
        out += " Further cylinders move in their own ways and are left out.";
    }
    out
}
