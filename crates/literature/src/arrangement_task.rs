//! An arrangement of the twin-cylinder thesis as a balance task: its devices freed, so that the true optimum over the
//! continuous cycle can stand beside the thesis's sizes.

use crate::crank_sweep::CrankLoad;
use crate::twin_arrangement::{ArrangementOptions, CrankRule, TwinArrangement, arranged, crank_load};
use lanchester_balance::BalanceError;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, FreeShaft, FreeWeight, Load, Phase, Place, Seat, Stage, Tie};
use std::f64::consts::{PI, TAU};

/// Share of an amount below which two weights count as equal, or their sum as nothing.
const EQUAL: f64 = 1e-9;

/// What may be done with the devices of `arrangement`: the amounts of its shafts are free, those of its crank too unless
/// it is the basic one; planes, axes and lines of phase stay. Weights that the arrangement makes equal stay tied: the
/// halves of a double shaft, and the counterweights of throws that stand in line.
///
/// The first stage is the thesis's criterion, the second the other load where a device acts on it. Weights and shafts
/// have the names that [`arranged`] gives them, so that the task takes their places. An arrangement without a free device
/// is a task without weights.
///
/// # Errors
/// As [`arranged`].
pub fn arrangement_task(
    engine: &Engine,
    arrangement: TwinArrangement,
    options: &ArrangementOptions,
) -> Result<BalanceTask, BalanceError> {
    let fitted = arranged(engine, arrangement, options)?;
    let mut task = BalanceTask::default();
    let mut free = Free::default();
    if arrangement.crank() != CrankRule::Basic && crank_load(engine, options)?.is_some() {
        for (k, weight) in fitted.counterweights.iter().enumerate() {
            let angle = fitted.crankshafts[weight.crankshaft].phase + weight.angle;
            free.add(
                &mut task,
                &weight.name,
                Seat::Crankshaft(weight.crankshaft),
                weight.z,
                weight.unbalance,
                angle,
            );
            free.tie_to(&mut task, k);
        }
        free.close();
    }
    for (index, shaft) in fitted.shafts.iter().enumerate() {
        task.shafts.push(FreeShaft {
            name: shaft.name.clone(),
            ratio: shaft.ratio,
            x: Place::At(shaft.x),
            y: Place::At(shaft.y),
            optional: false,
        });
        for (k, weight) in shaft.weights.iter().enumerate() {
            let name = match shaft.weights.len() {
                1 => shaft.name.clone(),
                _ => format!("{}, weight {}", shaft.name, k + 1),
            };
            free.add(&mut task, &name, Seat::Shaft(index), weight.z, weight.unbalance, weight.phase);
            free.tie_to(&mut task, k);
        }
        free.close();
    }
    let judged = crank_load(engine, options)?.unwrap_or(CrankLoad::Force);
    let loads = match judged {
        CrankLoad::Force => [(Load::Force, free.on_force), (Load::Couple, free.on_couple)],
        CrankLoad::Couple => [(Load::Couple, free.on_couple), (Load::Force, free.on_force)],
    };
    task.stages = loads
        .into_iter()
        .filter(|(_, acts)| *acts)
        .map(|(load, _)| Stage { terms: vec![(1.0, Criterion::Peak(load))] })
        .collect();
    Ok(task)
}

/// As [`arrangement_task`] with the amounts of the shafts kept: what a sweep of the crank looks for, over the continuous
/// cycle. No weights where the arrangement has no crank to choose.
///
/// # Errors
/// As [`arranged`].
pub fn crank_task(
    engine: &Engine,
    arrangement: TwinArrangement,
    options: &ArrangementOptions,
) -> Result<BalanceTask, BalanceError> {
    let Some(judged) = crank_load(engine, options)?.filter(|_| arrangement.crank() == CrankRule::Optimised)
    else {
        return Ok(BalanceTask::default());
    };
    let mut task = arrangement_task(engine, arrangement, options)?;
    // The crank's weights come first, so that their ties stay right.
    task.weights.retain(|weight| matches!(weight.seat, Seat::Crankshaft(_)));
    task.ties.retain(|tie| tie.second < task.weights.len());
    task.shafts.clear();
    task.stages = vec![Stage { terms: vec![(1.0, Criterion::Peak(judged.load()))] }];
    Ok(task)
}

/// What a sweep of the crank of `engine` for `load` looks for, over the continuous cycle: one amount, opposite every
/// throw. Throws that do not stand in line, or have unlike rotating masses, are free of one another, for a tie holds
/// amounts of one line: then the optimum may lie below that of the sweep's one amount.
pub fn swept_task(engine: &Engine, load: CrankLoad) -> BalanceTask {
    let mut task = BalanceTask {
        stages: vec![Stage { terms: vec![(1.0, Criterion::Peak(load.load()))] }],
        ..BalanceTask::default()
    };
    let mut free = Free::default();
    for (k, throw) in engine.throws.iter().enumerate() {
        let own = engine.rotating_unbalance(k);
        let angle = engine.crankshafts[throw.crankshaft].phase + throw.angle + PI;
        let name = format!("throw {}", k + 1);
        free.add(&mut task, &name, Seat::Crankshaft(throw.crankshaft), throw.z, own, angle);
        free.tie_to(&mut task, k);
    }
    task
}

/// The weights of one crank or shaft, and what all of them act on.
#[derive(Default)]
struct Free {
    /// Plane, amount and direction of those of the seat at hand.
    seat: Vec<(f64, f64, f64)>,
    /// Place of its first weight in the task.
    first: usize,
    /// Whether any of them has lost its tie to the first.
    loose: bool,
    on_force: bool,
    on_couple: bool,
}

impl Free {
    fn add(&mut self, task: &mut BalanceTask, name: &str, seat: Seat, z: f64, amount: f64, angle: f64) {
        if self.seat.is_empty() {
            self.first = task.weights.len();
        }
        self.seat.push((z, amount, angle));
        task.weights.push(FreeWeight {
            phase: Phase::Line(angle.rem_euclid(TAU)),
            ..FreeWeight::new(name, seat, Place::At(z))
        });
    }

    /// Ties weight `k` of the seat to its first where both are equal and stand in line.
    fn tie_to(&mut self, task: &mut BalanceTask, k: usize) {
        if k == 0 {
            return;
        }
        let ((_, amount, angle), (_, own, direction)) = (self.seat[0], self.seat[k]);
        let turn = (direction - angle).cos();
        let in_line = turn.abs() >= 1.0 - EQUAL;
        if in_line && (own - amount).abs() <= EQUAL * amount {
            let second = self.first + k;
            task.ties.push(Tie { first: self.first, second, factor: turn.signum(), mirrored: false });
        } else {
            self.loose = true;
        }
    }

    /// Notes what the weights of the seat act on: tied ones together, loose ones each by itself.
    fn close(&mut self) {
        let seat = std::mem::take(&mut self.seat);
        let size: f64 = seat.iter().map(|s| s.1).sum();
        let reach = seat.iter().map(|s| s.0.abs()).fold(0.0, f64::max);
        let sum = |lever: &dyn Fn(f64) -> f64| {
            let along: f64 = seat.iter().map(|&(z, u, a)| lever(z) * u * a.cos()).sum();
            let across: f64 = seat.iter().map(|&(z, u, a)| lever(z) * u * a.sin()).sum();
            along.hypot(across)
        };
        let loose = std::mem::take(&mut self.loose);
        self.on_force |= size > 0.0 && (loose || sum(&|_| 1.0) > EQUAL * size);
        self.on_couple |= size > 0.0 && (loose && reach > 0.0 || sum(&|z| z) > EQUAL * size * reach);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_file::{read, template};

    fn task(name: &str, arrangement: TwinArrangement) -> BalanceTask {
        let engine = read(template(name).unwrap().text).engine().unwrap();
        arrangement_task(&engine, arrangement, &ArrangementOptions::default()).unwrap()
    }

    fn stages(task: &BalanceTask) -> Vec<Criterion> {
        task.stages.iter().map(|s| s.terms[0].1).collect()
    }

    #[test]
    fn the_crank_of_an_in_phase_twin_is_one_variable_and_acts_on_the_force_alone() {
        let task = task("twin-360", TwinArrangement::OptimisedCrank);
        assert_eq!((task.weights.len(), task.ties.len(), task.shafts.len()), (2, 1, 0));
        assert_eq!(task.ties[0].factor, 1.0);
        assert_eq!(stages(&task), [Criterion::Peak(Load::Force)]);
    }

    #[test]
    fn the_crank_of_an_out_of_phase_twin_acts_on_the_couple_its_second_order_shafts_on_the_force() {
        let crank = task("twin-180", TwinArrangement::OptimisedCrank);
        assert_eq!(crank.ties[0].factor, -1.0);
        assert_eq!(stages(&crank), [Criterion::Peak(Load::Couple)]);
        let both = task("twin-180", TwinArrangement::OptimisedCrankTwoSecond);
        assert_eq!((both.weights.len(), both.shafts.len()), (4, 2));
        assert_eq!(stages(&both), [Criterion::Peak(Load::Couple), Criterion::Peak(Load::Force)]);
    }

    #[test]
    fn the_crank_alone_leaves_the_shafts_as_they_are() {
        let engine = read(template("twin-360").unwrap().text).engine().unwrap();
        let options = ArrangementOptions::default();
        let task = crank_task(&engine, TwinArrangement::OptimisedCrankTwoSecond, &options).unwrap();
        assert_eq!((task.weights.len(), task.ties.len(), task.shafts.len()), (2, 1, 0));
        assert_eq!(stages(&task), [Criterion::Peak(Load::Force)]);
        assert_eq!(crank_task(&engine, TwinArrangement::OneFirst, &options), Ok(BalanceTask::default()));
    }

    #[test]
    fn the_halves_of_a_double_shaft_stay_opposed() {
        let task = task("twin-180", TwinArrangement::TwoFirst);
        assert_eq!((task.weights.len(), task.shafts.len()), (4, 2));
        assert!(task.ties.iter().all(|tie| tie.factor == -1.0));
        assert_eq!(stages(&task), [Criterion::Peak(Load::Couple)]);
    }

    #[test]
    fn throws_out_of_line_are_not_tied_and_the_basic_crank_is_not_free() {
        let three = task("in-line-3", TwinArrangement::OptimisedCrank);
        assert_eq!((three.weights.len(), three.ties.len()), (3, 0));
        assert_eq!(stages(&three), [Criterion::Peak(Load::Couple), Criterion::Peak(Load::Force)]);
        assert_eq!(task("twin-360", TwinArrangement::Basic), BalanceTask::default());
    }
}
