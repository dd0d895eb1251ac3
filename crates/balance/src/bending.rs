//! The bending moment along crankshaft 1 as a group of a convex programme.
//!
//! What is judged is the crankshaft as a free beam under all that turns with it ([`BeamModel::FreeBeam`]): throws, rods'
//! big ends, counterweights fixed and free. Turning with the shaft, its bending moment does not change over the cycle, and
//! it is straight between planes, so that its largest amount is that at one of finitely many planes:
//!
//! ```text
//! |M(z_s)| = | i SUM over loads of g(z_s, z_k) w^2 U_k |        g: influence of a load at z_k ([`Beam::moment_influence`])
//! ```
//!
//! `g` is straight in `z_k` but for a kink at `z_s`. A weight somewhere in a stretch acts on every plane outside it as its
//! two shares at the ends do; planes inside are not judged, so that what is left is a lower bound for the stretch. Once
//! its place is given all planes count.

use crate::convex::curve::Member;
use crate::convex::dense::{Matrix, norm};
use crate::convex::programme::Group;
use crate::error::{BalanceError, missing};
use crate::fitted::bare;
use crate::judged::Judged;
use crate::operator::Operator;
use lanchester_mechanism::{Beam, BeamModel, turning_loads};
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Seat};
use num_complex::Complex64;

/// Planes closer than this are one [m].
const SAME_PLACE: f64 = 1e-9;

/// Scaled moments up to this are rounding.
const NOTHING: f64 = 1e-14;

/// Adds the group of the bending moments at all planes of crankshaft 1, and says how to read it. Of its orders only the
/// first is there: for any other `present` is false, and nothing is judged.
pub(crate) fn judge(
    engine: &Engine,
    task: &BalanceTask,
    operator: &Operator,
    criterion: Criterion,
    present: bool,
    groups: &mut Vec<Group>,
) -> Result<Judged, BalanceError> {
    let bare = bare(engine, task);
    let mains = bare.main_planes(0);
    let Some(beam) = Beam::new(&mains, BeamModel::FreeBeam) else {
        return Err(missing("bending moment", "a throw on crankshaft 1", "judge something else"));
    };
    let loads = turning_loads(&bare, 0, operator.speed);
    let mut weights = Vec::new();
    let mut stretches = Vec::new();
    for (columns, weight) in operator.weights.iter().zip(&task.weights) {
        if weight.seat == Seat::Crankshaft(0) {
            weights.extend(&columns.corners);
            if let [first, .., last] = &columns.corners[..] {
                stretches.push((first.z, last.z));
            }
        }
    }
    let mut planes: Vec<f64> =
        loads.iter().map(|l| l.0).chain(weights.iter().map(|w| w.z)).chain(mains.iter().copied()).collect();
    planes.sort_by(f64::total_cmp);
    planes.dedup_by(|later, kept| *later - *kept < SAME_PLACE);
    planes.retain(|plane| stretches.iter().all(|(low, high)| plane <= low || plane >= high));

    let natural = operator.natural_moment;
    let member = |plane: f64, scale: f64| {
        let moment =
            |z: f64, force: Complex64| Complex64::I * beam.moment_influence(plane, z) * force / scale;
        let constant: Complex64 = loads.iter().map(|&(z, force)| moment(z, force)).sum();
        let base = vec![constant.re, constant.im];
        let mut columns = Matrix::zeros(2, operator.variables);
        for corner in &weights {
            for (variable, unbalance) in &corner.terms {
                let part = moment(corner.z, operator.speed * operator.speed * unbalance);
                columns[(0, *variable)] += part.re;
                columns[(1, *variable)] += part.im;
            }
        }
        Member::Vector { base, columns }
    };
    let nothing = vec![0.0; operator.variables];
    let amount = |scale: f64| move |m: &Member| scale * norm(&m.value(0.0, &nothing));
    let members: Vec<Member> = planes.iter().map(|&plane| member(plane, natural)).collect();
    let unbalanced = members.iter().map(amount(natural)).fold(0.0, f64::max);
    let scale = if unbalanced > 1e-4 * natural { unbalanced } else { natural };
    let mut members: Vec<Member> = planes.iter().map(|&plane| member(plane, scale)).collect();
    // Free ends bend under nothing: they only cost time.
    members.retain(|member| present && bends(member));
    if members.is_empty() {
        members.push(Member::vector(Matrix::zeros(2, operator.variables)));
    }
    let unbalanced = if present { unbalanced } else { 0.0 };
    groups.push(Group::new(members));
    Ok(Judged { criterion, groups: vec![(groups.len() - 1, 1.0)], largest: None, scale, unbalanced })
}

fn bends(member: &Member) -> bool {
    let columns = member.columns();
    let seen = |row: usize| columns.row(row).iter().any(|c| c.abs() > NOTHING);
    (0..columns.rows).any(seen) || norm(&member.constant(0.0)) > NOTHING
}
