//! Engines of the gallery, tasks for them, and what an answer must hold.

use lanchester_balance::*;
use lanchester_mechanism::{LoadRequest, Mechanism};
use lanchester_model::*;
use lanchester_task::*;
use lanchester_testkit::gallery::gallery;
use lanchester_testkit::{Within, assert_close};
use num_complex::Complex64;

/// The engine of the gallery without counterweights and shafts.
pub fn stripped(name: &str) -> Engine {
    let mut engine = gallery(name);
    engine = engine
        .with(|engine| {
            engine.counterweights.clear();

            engine.shafts.clear();
        })
        .expect("an engine");
    engine
}

pub fn weight(name: &str, seat: Seat, z: f64) -> FreeWeight {
    FreeWeight::new(name, seat, Place::At(z))
}

/// Weights on crankshaft 1 in these planes.
pub fn on_crank(planes: &[f64]) -> Vec<FreeWeight> {
    let one = |(k, &z): (usize, &f64)| weight(&format!("crank {}", k + 1), Seat::Crankshaft(0), z);
    planes.iter().enumerate().map(one).collect()
}

/// Adds a shaft with weights in these planes.
pub fn add_shaft(task: &mut BalanceTask, ratio: i32, x: f64, y: f64, planes: &[f64]) {
    let index = task.shafts.len();
    let name = format!("shaft {}", index + 1);
    for (k, &z) in planes.iter().enumerate() {
        task.weights.push(weight(&format!("{name} {}", k + 1), Seat::Shaft(index), z));
    }
    task.shafts.push(FreeShaft {
        name,
        ratio: Ratio::whole(ratio).expect("not 0"),
        x: Place::At(x),
        y: Place::At(y),
        optional: false,
    });
}

/// Weights in these planes that turn with the crank on a shaft of their own in its axis: force and couple feel them like weights
/// on the crank, its bearings do not, so that the lightest are left to decide.
pub fn beside_crank(planes: &[f64], cancel: &[(Load, f64)]) -> BalanceTask {
    let mut beside = task(Vec::new(), cancel);
    add_shaft(&mut beside, 1, 0.0, 0.0, planes);
    beside
}

pub fn task(weights: Vec<FreeWeight>, cancel: &[(Load, f64)]) -> BalanceTask {
    BalanceTask { weights, cancel: cancel.to_vec(), ..BalanceTask::default() }
}

/// Reciprocating and rotating unbalance of one cylinder's parts [kg m].
pub fn masses(engine: &Engine) -> (f64, f64) {
    let cylinder = &engine.cylinders[0];
    let throw = &engine.throws[cylinder.throw];
    (cylinder.reciprocating_mass() * throw.radius, cylinder.rod.big_end_mass * throw.radius)
}

/// Coefficient of order 2 of a centred piston's acceleration over `r w^2`, by the trapezoidal rule on the exact motion
/// `s = r cos + sqrt(l^2 - r^2 sin^2)`.
pub fn second_order(engine: &Engine) -> f64 {
    let ratio = engine.throws[0].radius / engine.cylinders[0].rod.length;
    let count = 4096;
    let position = |theta: f64| theta.cos() + (1.0 / (ratio * ratio) - theta.sin().powi(2)).sqrt();
    let angle = |j: usize| std::f64::consts::TAU * j as f64 / count as f64;
    // The shaking force is -m s''; its order 2 is 4 times the order 2 of the position.
    4.0 * 2.0 / count as f64 * (0..count).map(|j| position(angle(j)) * (2.0 * angle(j)).cos()).sum::<f64>()
}

pub fn cancellation(answer: &Answer) -> &Cancellation {
    answer.cancellation.as_ref().expect("a task with orders to cancel")
}

/// What the loads' own kernel leaves of an order of the force (0) or couple (1), forward and backward.
pub fn order_of(engine: &Engine, which: usize, order: f64) -> [f64; 2] {
    let mechanism = Mechanism::new(engine, &LoadRequest::default()).expect("a valid engine");
    let orders = mechanism.orders();
    match (orders.iter().find(|o| o.order == order), which) {
        (None, _) => [0.0; 2],
        (Some(found), 0) => [found.force_forward.norm(), found.force_backward.norm()],
        (Some(found), _) => [found.couple_forward.norm(), found.couple_backward.norm()],
    }
}

/// What all moving masses would do if none cancelled another [N].
pub fn all_masses(engine: &Engine) -> f64 {
    let one = |c: &Cylinder| (c.piston_mass + c.rod.mass()) * engine.throws[c.throw].radius;
    let moving: f64 = engine.cylinders.iter().map(one).sum();
    let turning = engine.throws.iter().map(|throw| throw.unbalance);
    let turning: f64 = turning.chain(engine.counterweights.iter().map(|weight| weight.unbalance)).sum();
    (moving + turning) * engine.speed.highest.powi(2)
}

/// Longest lever of the engine [m].
pub fn lever(engine: &Engine) -> f64 {
    engine.throws.iter().map(|t| t.z.abs().max(t.radius)).fold(0.0, f64::max)
}

/// What a unit of weight `index` adds to a part of an order, from first principles.
fn column(engine: &Engine, task: &BalanceTask, index: usize, term: &FunctionalTerm) -> [Complex64; 2] {
    let free = &task.weights[index];
    let (ratio, axis) = match free.seat {
        Seat::Crankshaft(k) => {
            let shaft = &engine.crankshafts[k];
            (shaft.ratio.value(), Complex64::new(shaft.x, shaft.y))
        }
        Seat::Shaft(k) => {
            let at = |place: Place| match place {
                Place::At(value) => value,
                Place::Between(..) => panic!("given places only"),
            };
            let shaft = &task.shafts[k];
            (shaft.ratio.value(), Complex64::new(at(shaft.x), at(shaft.y)))
        }
    };
    let Place::At(z) = free.z else { panic!("given planes only") };
    let Criterion::Order(load, order) = term.criterion else { panic!("one order") };
    let square = (ratio * engine.speed.highest).powi(2);
    let zero = [Complex64::ZERO; 2];
    if (ratio.abs() - order).abs() > 1e-9 {
        return zero;
    }
    // Effect of U = 1 and of U = i.
    let of = |factor: Complex64| [factor, factor * Complex64::I];
    let turns = match term.sense {
        OrderSense::Forward => ratio > 0.0,
        OrderSense::Backward => ratio < 0.0,
        OrderSense::Alternating => true,
    };
    match (load, turns) {
        (Load::Force, true) => of(Complex64::from(square)),
        (Load::Couple, true) => of(Complex64::new(0.0, z * square)),
        (Load::RollMoment, true) => {
            // M_z = Im( conj(axis) F ), as Re( m e^{i n theta} ).
            let units = [Complex64::ONE, Complex64::I];
            units.map(|unit| {
                let y = axis.conj() * square * unit;
                if ratio > 0.0 { -Complex64::I * y } else { (-Complex64::I * y).conj() }
            })
        }
        (Load::Force | Load::Couple | Load::RollMoment, false) => zero,
        _ => panic!("force, couple and roll moment only"),
    }
}

/// Recomputes a functional against the devices of a task without bounds and ties: its value, and the largest pull of a
/// weight over `cost`.
pub fn recomputed(
    engine: &Engine,
    task: &BalanceTask,
    functional: &Functional,
    cost: impl Fn(&FreeWeight) -> f64,
) -> (f64, f64) {
    let value = functional.terms.iter().map(|t| -(t.factor.conj() * t.amount).re).sum();
    let mut largest = 0.0f64;
    for (index, weight) in task.weights.iter().enumerate() {
        let mut pull = [0.0; 2];
        for term in &functional.terms {
            let columns = column(engine, task, index, term);
            for m in 0..2 {
                pull[m] += (term.factor.conj() * columns[m]).re;
            }
        }
        let pull = match weight.phase {
            Phase::Free => pull[0].hypot(pull[1]),
            Phase::Line(angle) => (pull[0] * angle.cos() + pull[1] * angle.sin()).abs(),
            Phase::Direction(angle) => (pull[0] * angle.cos() + pull[1] * angle.sin()).max(0.0),
        };
        largest = largest.max(pull / cost(weight));
    }
    (value, largest)
}

/// Refuses an answer whose orders do not vanish, or whose proof does not hold when recomputed; the total of the lightest.
pub fn assert_vanishes(engine: &Engine, answer: &Answer) -> f64 {
    // What only decides among the weights that cancel may be left open by rounding, no further than in other random tasks.
    if let Outcome::Stopped { cause, .. } = &answer.outcome {
        let open = answer.stages.iter().all(|stage| stage.gap <= 1e-6 * stage.value.max(1.0));
        assert!(*cause == StopCause::Rounding && open, "{answer:#?}");
    } else {
        assert_eq!(answer.outcome, Outcome::Optimal, "{answer:#?}");
    }
    let found = cancellation(answer);
    let CancellationVerdict::Vanish { total, least, is_mass, lightest } = &found.verdict else {
        panic!("the orders vanish, got {:#?}", found.verdict);
    };
    for order in &found.orders {
        let lever = if criterion_unit(&order.criterion) == "N" { 1.0 } else { lever(engine) };
        let allowed = 1e-10 * all_masses(engine) * lever;
        assert!(order.left <= allowed, "{order:?} above {allowed:.3e}");
    }
    let fitted = fitted(engine, answer);
    for &(load, order) in &answer.task.cancel {
        let which = match load {
            Load::Force => 0,
            Load::Couple => 1,
            _ => continue,
        };
        let lever = if which == 0 { 1.0 } else { lever(engine) };
        let left = order_of(&fitted, which, order);
        assert!(left[0].max(left[1]) <= 1e-10 * all_masses(engine) * lever, "{load:?} {order}: {left:?}");
    }
    let sum: f64 =
        answer.weights.iter().map(|w| w.mass.filter(|_| *is_mass).unwrap_or(w.unbalance.norm())).sum();
    assert!((sum - total).abs() <= 1e-12 * total, "total {total} of {sum}");
    let gap = least - lightest.value;
    assert!(gap <= 1e-8 * least && gap >= -1e-10 * least, "gap {gap:.3e} of {least:.3e}");
    assert!(*total >= least * (1.0 - 1e-9), "{total} below the least {least}");
    let plain = answer.task.ties.is_empty() && answer.task.inertias.is_empty();
    if plain && answer.task.weights.iter().all(|w| w.most.is_none()) {
        let cost = |w: &FreeWeight| if *is_mass { 1.0 / w.radius.expect("a radius") } else { 1.0 };
        let (value, pull) = recomputed(engine, &answer.task, lightest, cost);
        assert!((value - lightest.value).abs() <= 1e-9 * total.max(1e-12), "{value} of {lightest:?}");
        assert!(pull <= 1.0 + 1e-9, "pull {pull}");
    }
    *least
}

/// Refuses an answer that does not prove that its orders cannot vanish; the proofs.
pub fn assert_cannot<'a>(engine: &Engine, answer: &'a Answer) -> &'a [Obstruction] {
    assert!(matches!(answer.outcome, Outcome::CannotVanish { .. }), "{answer:#?}");
    let CancellationVerdict::CannotVanish { obstructions } = &cancellation(answer).verdict else {
        panic!("the orders cannot vanish");
    };
    assert!(!obstructions.is_empty());
    let plain = answer.task.ties.is_empty() && answer.task.inertias.is_empty();
    for one in obstructions {
        assert!((one.functional.value - 1.0).abs() < 1e-9, "{one:#?}");
        assert!(one.functional.largest_pull <= 1e-9, "{one:#?}");
        if plain && answer.task.weights.iter().all(|w| w.most.is_none()) {
            let (value, pull) = recomputed(engine, &answer.task, &one.functional, |_| 1.0);
            assert!((value - 1.0).abs() < 1e-9, "{value} of {one:#?}");
            // A natural amount pulls this much.
            let natural = all_masses(engine) / engine.speed.highest.powi(2);
            assert!(pull * natural < 1e-6, "pull {pull:.3e} of {one:#?}");
        }
    }
    obstructions
}

#[track_caller]
pub fn close(got: f64, want: f64, relative: f64, what: &str) {
    assert_close(what, got, want, Within::share(relative, "what the solver's gap leaves"));
}
