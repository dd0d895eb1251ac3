//! Condition B: how the loads on the block change with the speed of an engine that turns freely, and the first-order estimate of it.
//!
//! ```text
//! F = -d/dt (w P(theta))        P: momentum of all moving parts over the speed;   w = w_0 (1 + e(theta))
//! F - F_0 = 2 e F_0 + e' G,     G' = F_0 with zero mean                              to the first order in e
//! ```
//! `F_0` and `e` are those of the closed form: the loads at constant speed, and the energy integral. The rocking couple goes the same way. The roll moment has the
//! torque of the flywheel in it as well: it has no estimate.

use crate::crosscheck::pair::{CrossCheckError, Pair};
use lanchester_mechanism::{LoadRequest, Mechanism, SpeedRipple};
use lanchester_multibody::Run;
use lanchester_report::{CrossRow, CrossVerdict};
use num_complex::Complex64;

/// Rows for force, couple and roll moment of a run over one period that starts at angle 0.
pub(crate) fn load_rows(
    pair: &Pair<'_>,
    ripple: &SpeedRipple,
    run: &Run,
) -> Result<Vec<CrossRow>, CrossCheckError> {
    let count = ripple.theta.len();
    let step = ripple.period / count as f64;
    let request = LoadRequest { speed: Some(pair.speed), ..LoadRequest::default() };
    let closed = Mechanism::new(pair.engine, &request)?;
    let share: Vec<f64> = ripple.speed.iter().map(|speed| speed / pair.speed - 1.0).collect();
    let slope = |k: usize| (share[(k + 1) % count] - share[(k + count - 1) % count]) / (2.0 * step);
    let constant: Vec<[Complex64; 2]> = ripple
        .theta
        .iter()
        .map(|theta| {
            let loads = closed.components(*theta);
            [Complex64::new(loads.force_x, loads.force_y), Complex64::new(loads.couple_x, loads.couple_y)]
        })
        .collect();
    // Largest at constant speed, at free speed, of their difference, of its estimate, and of what that leaves.
    let mut found = [[0.0f64; 5]; 3];
    for kind in 0..2 {
        let mut integral = vec![Complex64::ZERO; count];
        for k in 1..count {
            integral[k] = integral[k - 1] + 0.5 * step * (constant[k - 1][kind] + constant[k][kind]);
        }
        let mean = integral.iter().sum::<Complex64>() / count as f64;
        for k in 0..count {
            let Some(free) = run.samples.reactions.get(k).map(|reactions| &reactions.on_block) else { break };
            let free = match kind {
                0 => Complex64::new(free.force[0], free.force[1]),
                _ => Complex64::new(free.moment[0], free.moment[1]),
            };
            let same = constant[k][kind];
            let estimate = 2.0 * share[k] * same + slope(k) * (integral[k] - mean);
            let values = [
                same.norm(),
                free.norm(),
                (free - same).norm(),
                estimate.norm(),
                (free - same - estimate).norm(),
            ];
            for (most, value) in found[kind].iter_mut().zip(values) {
                *most = most.max(value);
            }
        }
    }
    for (theta, free) in run.samples.theta.iter().zip(&run.samples.reactions) {
        let constant = pair.reactions(*theta, &[]).on_block.moment[2];
        let free = free.on_block.moment[2];
        let [closed, multibody, off, ..] = &mut found[2];
        *closed = closed.max(constant.abs());
        *multibody = multibody.max(free.abs());
        *off = off.max((free - constant).abs());
    }
    let fluctuation = 100.0 * ripple.fluctuation;
    let kinds = [("force", "N"), ("couple", "N m"), ("roll moment", "N m")];
    let row =
        |((name, unit), [closed_form, multibody, difference, estimate, left]): ((&str, &str), [f64; 5])| {
            let why = match name {
                "roll moment" => "the flywheel takes torque".to_owned(),
                _ => format!("to the first order {estimate:.4e}, which leaves {left:.1e}"),
            };
            CrossRow {
                quantity: format!("{name}, change by the free speed"),
                unit: unit.into(),
                order: None,
                closed_form: Some(closed_form),
                bond_graph: None,
                multibody,
                difference,
                scale: closed_form.max(multibody).max(f64::MIN_POSITIVE),
                bar: None,
                verdict: CrossVerdict::DiffersAsItMust,
                reason: Some(format!("the speed fluctuates by {fluctuation:.2} %: {why}")),
            }
        };
    Ok(kinds.into_iter().zip(found).map(row).collect())
}
