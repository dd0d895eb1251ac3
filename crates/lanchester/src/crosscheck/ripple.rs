//! Condition B: how the loads on the block change with the speed of an engine that turns freely, and the first-order estimate of it.
//!
//! ```text
//! F = -d/dt (w P(theta))        P: momentum of all moving parts over the speed;   w = w_0 (1 + e(theta))
//! F - F_0 = 2 e F_0 + e' G,     G' = F_0 with zero mean                              to the first order in e
//! M - M_0 = 2 e M_i + e' w_0^2 (I - Q)                                               roll moment
//! ```
//! `F_0`, `M_0` and `e` are those of the closed form: the loads at constant speed, `M_i` the part of inertia, and the energy integral. The rocking couple goes as the force. The roll
//! moment has the angular momentum `w Q` about the crank axis and the torque that leaves, which the speed changes by `w_0^2 (I e' + I' e)` with the moment of inertia `I` of the crank train
//! as seen from the crank: a flywheel is in both alike and drops out.

use crate::crosscheck::pair::{CrossCheckError, Pair};
use lanchester_mechanism::{LoadRequest, Mechanism, SpeedRipple};
use lanchester_multibody::{Motion, Run};
use lanchester_report::{CrossRow, CrossVerdict, cross_amount};
use lanchester_results::TwoSided;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Orders that change by less than this share of the largest load of their kind are not listed.
const LISTED: f64 = 1e-6;

/// One kind of load over the angle: at constant speed, at free speed, and the estimate of the change.
type Courses = [Vec<Complex64>; 3];

/// Rows for force, couple and roll moment of a run over one period that starts at angle 0, over the cycle and by order.
pub(crate) fn load_rows(
    pair: &Pair<'_>,
    ripple: &SpeedRipple,
    run: &Run,
) -> Result<Vec<CrossRow>, CrossCheckError> {
    let kinds = [("force", "N"), ("couple", "N m"), ("roll moment", "N m")];
    let turns = ripple.period / TAU;
    let most = (f64::from(pair.request.max_order) * turns).round() as u32;
    let mut rows = Vec::new();
    for (named, courses) in kinds.into_iter().zip(courses(pair, ripple, run)?) {
        let over =
            |of: &dyn Fn(usize) -> Complex64| (0..courses[1].len()).map(|k| of(k).norm()).fold(0.0, f64::max);
        let [constant, free, estimate] = &courses;
        let cycle = [
            over(&|k| constant[k]),
            over(&|k| free[k]),
            over(&|k| free[k] - constant[k]),
            over(&|k| estimate[k]),
            over(&|k| free[k] - constant[k] - estimate[k]),
        ];
        let scale = cycle[0].max(cycle[1]).max(f64::MIN_POSITIVE);
        let because = format!("the speed fluctuates by {:.2} %", 100.0 * ripple.fluctuation);
        rows.push(row(named, None, cycle, scale, &format!("{because}: ")));
        for order in (0..=most).map(|k| f64::from(k) / turns) {
            let [constant, free, estimate] =
                [0, 1, 2].map(|which| TwoSided::of_samples(&courses[which], 0.0, turns, order));
            let change = free - constant;
            let sizes =
                [constant.peak(), free.peak(), change.peak(), estimate.peak(), (change - estimate).peak()];
            if sizes[2].max(sizes[3]) > LISTED * scale {
                rows.push(row(named, Some(order), sizes, scale, ""));
            }
        }
    }
    Ok(rows)
}

/// A row from sizes: at constant speed, at free speed, of their difference, of its estimate, and of what that leaves.
fn row(
    (name, unit): (&str, &str),
    order: Option<f64>,
    [closed_form, multibody, difference, estimate, left]: [f64; 5],
    scale: f64,
    because: &str,
) -> CrossRow {
    CrossRow {
        quantity: format!("{name}, change by the free speed"),
        unit: unit.into(),
        order,
        closed_form: Some(closed_form),
        bond_graph: None,
        multibody,
        difference,
        scale,
        bar: None,
        verdict: CrossVerdict::DiffersAsItMust,
        reason: Some(format!(
            "{because}change {}, to the first order {}, which leaves {}",
            cross_amount(difference, unit),
            cross_amount(estimate, unit),
            cross_amount(left, unit)
        )),
    }
}

/// Force, couple and roll moment at the angles of `ripple`.
fn courses(pair: &Pair<'_>, ripple: &SpeedRipple, run: &Run) -> Result<[Courses; 3], CrossCheckError> {
    let count = ripple.theta.len();
    let step = ripple.period / count as f64;
    let request = LoadRequest { speed: Some(pair.speed), ..LoadRequest::default() };
    let closed = Mechanism::new(pair.engine, &request)?;
    let share: Vec<f64> = ripple.speed.iter().map(|speed| speed / pair.speed - 1.0).collect();
    let slope = |k: usize| (share[(k + 1) % count] - share[(k + count - 1) % count]) / (2.0 * step);
    let components: Vec<_> = ripple.theta.iter().map(|theta| closed.components(*theta)).collect();
    let free: Vec<_> = run.samples.reactions.iter().take(count).map(|reactions| reactions.on_block).collect();
    let across = |kind: usize| -> Courses {
        let constant: Vec<Complex64> = components
            .iter()
            .map(|own| match kind {
                0 => Complex64::new(own.force_x, own.force_y),
                _ => Complex64::new(own.couple_x, own.couple_y),
            })
            .collect();
        let mut integral = vec![Complex64::ZERO; count];
        for k in 1..count {
            integral[k] = integral[k - 1] + 0.5 * step * (constant[k - 1] + constant[k]);
        }
        let mean = integral.iter().sum::<Complex64>() / count as f64;
        let estimate =
            (0..count).map(|k| 2.0 * share[k] * constant[k] + slope(k) * (integral[k] - mean)).collect();
        let free = free.iter().map(|on_block| match kind {
            0 => Complex64::new(on_block.force[0], on_block.force[1]),
            _ => Complex64::new(on_block.moment[0], on_block.moment[1]),
        });
        [constant, free.collect(), estimate]
    };
    let real = |value: f64| Complex64::new(value, 0.0);
    let mut places = Vec::new();
    let roll: Vec<[Complex64; 2]> = (0..count)
        .map(|k| {
            let theta = ripple.theta[k];
            pair.train.places_into(theta, &mut places);
            let mass = pair.train.equations(&Motion::fixed(theta, pair.speed), &places).mass;
            let reacting = pair.speed * pair.speed * (mass[6][6] - mass[5][6]);
            let estimate = 2.0 * share[k] * components[k].roll_moment + slope(k) * reacting;
            [real(pair.reactions(theta, &[]).on_block.moment[2]), real(estimate)]
        })
        .collect();
    let of = |which: usize| roll.iter().map(|own| own[which]).collect::<Vec<_>>();
    let free_roll = free.iter().map(|on_block| real(on_block.moment[2])).collect();
    Ok([across(0), across(1), [of(0), free_roll, of(1)]])
}
