//! A flywheel that turns freely: the energy integral of a rigid train, its equation of motion, the same motion imposed.

use super::*;
use lanchester_flex::train::{CycleInstant, FreeFlywheel, run_free};

/// Samples of the gas force.
const FINE: usize = 960;

fn gas(theta: f64) -> f64 {
    let beside = (theta - 0.9 + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
    3000.0 * (-(beside / 0.4).powi(2)).exp()
}

/// The single-cylinder train at a speed [rad/s].
fn single(body: CrankBody, law: TrainLaw, speed: f64) -> CrankTrain {
    let mut cylinder = cylinder(law.clone());
    let samples = (0..FINE).map(|k| gas(TAU * k as f64 / FINE as f64)).collect();
    cylinder.gas = PeriodicForce { period: PERIOD, samples };
    let mut own = train(body, law, cylinder);
    own.motion = ImposedMotion::constant(speed, PERIOD);
    own
}

fn freely(train: &CrankTrain, inertia: f64) -> TrainCycles {
    let flywheel = FreeFlywheel { inertia, train: 5e-4, change: 1e-4 };
    let options = CycleOptions { most_cycles: 60, ..options() };
    let found = run_free(train, flywheel, options, &|_| true).unwrap();
    assert_eq!(
        found.outcome,
        CycleOutcome::Periodic,
        "{:?} {} {}",
        found.free,
        found.orbit_change,
        found.stress_change
    );
    assert!(found.free.unwrap().change < 1e-4, "{:?}", found.free);
    let energy = found.recorded[0].energy;
    assert!(energy.error() <= 1e-4, "{energy:?}");
    found
}

fn instants(found: &TrainCycles) -> &[CycleInstant] {
    &found.recorded[0].instants
}

/// Inertia of all about the axis and travel of the piston, from places by differences.
fn rigid_train(train: &CrankTrain, theta: f64) -> (f64, f64) {
    let own = &train.cylinders[0];
    let pin = |theta: f64| {
        let (sin, cos) = theta.sin_cos();
        [cos * own.pin[0] - sin * own.pin[1], sin * own.pin[0] + cos * own.pin[1]]
    };
    let slider = &own.slider;
    let h = 1e-5;
    let rate = |of: &dyn Fn([f64; 2]) -> f64| (of(pin(theta + h)) - of(pin(theta - h))) / (2.0 * h);
    let piston = rate(&|at| slider.travel(at));
    let x = rate(&|at| at[0] + slider.centre * slider.direction(at).cos());
    let y = rate(&|at| at[1] + slider.centre * slider.direction(at).sin());
    let swing = rate(&|at| slider.direction(at));
    let rod = slider.rod * (x * x + y * y) + slider.inertia * swing * swing;
    (train.body.polar + slider.piston * piston * piston + rod, slider.travel(pin(theta)))
}

/// Squares of the speed over two at equal angles, from `J w^2/2 = C + W`, so that the mean over time is that of the train; the load.
fn energy_integral(train: &CrankTrain, inertia: f64, count: usize) -> (Vec<f64>, f64) {
    let of: Vec<(f64, f64)> =
        (0..=count).map(|k| rigid_train(train, TAU * k as f64 / count as f64)).collect();
    let mut work = vec![0.0];
    for k in 0..count {
        let middle = gas(TAU * (k as f64 + 0.5) / count as f64);
        work.push(work[k] - middle * (of[k + 1].1 - of[k].1));
    }
    let load = work[count] / TAU;
    let excess: Vec<f64> = (0..count).map(|k| work[k] - load * TAU * k as f64 / count as f64).collect();
    let speeds = |constant: f64| -> Vec<f64> {
        (0..count).map(|k| (2.0 * (constant + excess[k]) / (inertia + of[k].0)).sqrt()).collect()
    };
    let lowest = excess.iter().copied().fold(f64::INFINITY, f64::min);
    let (mut low, mut high) = (-lowest, -lowest + 10.0 * (inertia + 0.01) * train.motion.speed.powi(2));
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        let slowness = speeds(middle).iter().map(|w| 1.0 / w).sum::<f64>() / count as f64;
        if slowness * train.motion.speed > 1.0 { low = middle } else { high = middle }
    }
    (speeds(high), load)
}

#[test]
fn a_rigid_train_has_the_speed_of_the_energy_integral() {
    let (body, _) = body();
    // Inertia of rod and piston is 3e-4 to 9e-4 kg m^2: the light flywheel has less than the train.
    for inertia in [1e-4, 1e-3, 1e-2] {
        let own = single(body.rigid(), TrainLaw::Rigid, 1200.0);
        let found = freely(&own, inertia);
        let count = 7200;
        let (speeds, load) = energy_integral(&own, inertia, count);
        let most = speeds.iter().copied().fold(0.0, f64::max);
        let swing = most - speeds.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(swing > 1.0, "{inertia}: it swings by {swing}");
        for at in instants(&found) {
            let place = (at.theta / TAU).rem_euclid(1.0) * count as f64;
            let (k, share) = (place as usize % count, place.fract());
            let wanted = (1.0 - share) * speeds[k] + share * speeds[(k + 1) % count];
            // The speed is found to 1e-4 of its swing.
            assert!((at.speed - wanted).abs() < 3e-4 * swing, "{inertia}: {} {wanted} of {swing}", at.speed);
        }
        // A load that is wrong changes the speed over a cycle, by 1e-4 of the swing at most.
        let got = found.free.unwrap().load;
        let bar = 1e-4 * swing * (inertia + 9e-4) / own.motion.duration();
        assert!((got + load).abs() < bar && bar < 0.02 * load, "{inertia}: {got} {load} {bar}");
        // A rigid train of varying inertia needs few cycles.
        assert!(found.cycles <= 12, "{inertia}: {}", found.cycles);
    }
}

/// Inertia about the axis of web and pin, and of the flange [kg m^2].
const WEB: f64 = 4e-4;
const FLANGE: f64 = 1e-4;

/// A throw that twists against its flange, stiff in bending: x, y, two tilts, rotation, twist of this stiffness [N m/rad].
fn throw(stiffness: f64) -> CrankBody {
    let (mass, tilting, reach) = (3.0f64, 0.02f64, 0.1);
    let all = WEB + FLANGE;
    let square = stiffness * (1.0 / WEB + 1.0 / FLANGE);
    let n = 6;
    let (shift, tilt) = (1.0 / mass.sqrt(), reach / tilting.sqrt());
    let main = |sign: f64| {
        [vec![shift, 0.0, sign * tilt, 0.0, 0.0, 0.0], vec![0.0, shift, 0.0, sign * tilt, 0.0, 0.0]]
    };
    let [web, flange] = [
        [1.0 / all.sqrt(), (FLANGE / (WEB * all)).sqrt()],
        [1.0 / all.sqrt(), -(WEB / (FLANGE * all)).sqrt()],
    ];
    let pin = [vec![shift, 0.0, 0.0, 0.0, 0.0, 0.0], vec![0.0, shift, 0.0, 0.0, 0.0, 0.0]];
    let entry = |k: usize, of: &[(usize, usize, f64)]| {
        of.iter().find(|(i, j, _)| (k / n, k % n) == (*i, *j)).map_or(0.0, |own| own.2)
    };
    let turned = [(0, 1, -1.0), (1, 0, 1.0), (2, 3, -1.0), (3, 2, 1.0)];
    let still = [vec![0.0; n], vec![0.0; n]];
    CrankBody {
        stiffness: vec![0.0, 0.0, 0.0, 0.0, 0.0, square],
        damping: (0..n * n).map(|k| entry(k, &[(5, 5, 0.02 * square.sqrt())])).collect(),
        gyroscopic: (0..n * n).map(|k| entry(k, &turned)).collect(),
        // What turns about the axis keeps its distance from it.
        centrifugal: (0..n * n).map(|k| f64::from(u8::from(k / n == k % n && k % n < 4))).collect(),
        centrifugal_load: vec![0.0; n],
        euler_load: vec![0.0, 0.0, 0.0, 0.0, all.sqrt(), 0.0],
        polar: all,
        rows: vec![main(-1.0), main(1.0), pin],
        turns: vec![vec![0.0; n], vec![0.0; n], [vec![0.0; 4], web.to_vec()].concat()],
        slopes: vec![still.clone(), still.clone(), still],
        turning: [vec![0.0; 4], flange.to_vec()].concat(),
    }
}

/// Frequency of the twist with the flywheel held, with the mean inertia of rod and piston of 5e-4 kg m^2 [rad/s].
const HELD: f64 = 3600.0;

fn twisting() -> CrankBody {
    throw(HELD * HELD * (WEB + 5e-4))
}

#[test]
fn a_light_flywheel_on_a_shaft_whose_twist_is_excited_obeys_its_equation() {
    for order in [2.0, 3.0, 4.0, 6.0] {
        let own = single(twisting(), TrainLaw::Rigid, HELD / order);
        let inertia = 5e-4;
        let found = freely(&own, inertia);
        let all = instants(&found);
        let load = found.free.unwrap().load;
        let largest = all.iter().map(|at| at.torque.abs()).fold(0.0, f64::max);
        let n = all.len();
        let step = own.motion.duration() / n as f64;
        for k in 0..n {
            let left = inertia * all[k].acceleration + own.ratio * all[k].torque - load;
            assert!(left.abs() < 1e-5 * largest, "{order} {k}: {left} of {largest}");
            // The acceleration is the rate of the speed: differences of order 6 over steps of 3.75 deg.
            let at = |by: usize| all[(k + n + by - 3) % n].speed;
            let rate = (45.0 * (at(4) - at(2)) - 9.0 * (at(5) - at(1)) + at(6) - at(0)) / (60.0 * step);
            assert!(
                (inertia * (rate - all[k].acceleration)).abs() < 1e-2 * largest,
                "{order} {k}: {rate} {}",
                all[k].acceleration
            );
        }
        // Work of the load over the period is what the crankshaft gives its flywheel.
        let energy = found.recorded[0].energy;
        assert!((energy.drive - load * PERIOD).abs() < 1e-4 * energy.turnover, "{energy:?} {load}");
    }
}

#[test]
fn the_motion_found_asks_for_the_same_torque_where_it_is_imposed() {
    for law in [TrainLaw::Rigid, film(20e-6)] {
        let own = single(twisting(), law.clone(), 400.0);
        let found = freely(&own, 0.01);
        let all = instants(&found);
        let n = all.len();
        let mut imposed = own.clone();
        let beyond: Vec<f64> = (0..n).map(|k| all[k].theta - TAU * k as f64 / n as f64).collect();
        imposed.motion.offset = beyond.iter().sum::<f64>() / n as f64;
        imposed.motion.swing = (1..n / 3)
            .map(|order| {
                let of = |wave: fn(f64) -> f64| {
                    let terms = beyond.iter().enumerate();
                    terms.map(|(k, own)| own * wave(TAU * (order * k) as f64 / n as f64)).sum::<f64>() * 2.0
                        / n as f64
                };
                [of(f64::cos), of(f64::sin)]
            })
            .collect();
        let again = periodic(&imposed);
        let speeds = || all.iter().map(|at| at.speed);
        let swing = speeds().fold(0.0, f64::max) - speeds().fold(f64::INFINITY, f64::min);
        let largest = all.iter().map(|at| at.torque.abs()).fold(0.0, f64::max);
        for (at, wanted) in instants(&again).iter().zip(all) {
            // Orders from the 32nd on are cut.
            assert!(
                (at.speed - wanted.speed).abs() < 1e-3 * swing,
                "{law:?}: {} {} of {swing}",
                at.speed,
                wanted.speed
            );
            // Both repeat to 5e-3 of their loads at most.
            assert!(
                (at.torque - wanted.torque).abs() < 5e-3 * largest,
                "{law:?}: {} {} of {largest}",
                at.torque,
                wanted.torque
            );
        }
    }
}

#[test]
fn the_frequency_of_a_twist_does_not_depend_on_the_speed() {
    // A rod whose mass sits in its big end, so long that the gas force F cos(theta) has a torque F r/2 sin(2 theta).
    let (mass, arm, force) = (0.3, 0.03, 300.0);
    let inertia = WEB + mass * arm * arm;
    for order_of_twist in [2.2, 1.9, 4.0] {
        let stiffness = HELD * HELD * inertia;
        let mut body = throw(stiffness);
        body.damping.iter_mut().for_each(|d| *d *= 5.0);
        let mut own = single(body, TrainLaw::Rigid, HELD / order_of_twist);
        let cylinder = &mut own.cylinders[0];
        cylinder.slider = Slider {
            angle: 0.0,
            offset: 0.0,
            length: 30.0,
            piston: 0.0,
            rod: mass,
            centre: 0.0,
            inertia: 0.0,
        };
        let samples = (0..FINE).map(|k| force * (TAU * k as f64 / FINE as f64).cos());
        cylinder.gas = PeriodicForce { period: PERIOD, samples: samples.collect() };
        let found = run_cycles(&own, CycleOptions { most_cycles: 60, tolerance: 1e-6, ..options() }).unwrap();
        assert_eq!(found.outcome, CycleOutcome::Periodic, "{order_of_twist}: {}", found.stress_change);
        let all = instants(&found);
        let second: Complex64 = all.iter().map(|at| at.torque * Complex64::cis(-2.0 * at.theta)).sum();
        let got = second.norm() * 2.0 / all.len() as f64;
        // Half the gas force presses on the pin towards the axis, whatever the angle: its moment about the web grows with the twist.
        let held = stiffness - 0.5 * force * arm;
        let loss = Complex64::I * stiffness * 2.0 * own.motion.speed * 0.1
            / (stiffness * (1.0 / WEB + 1.0 / FLANGE)).sqrt();
        let inert = inertia * (2.0 * own.motion.speed).powi(2);
        let wanted = 0.5 * force * arm * ((stiffness + loss) / (held + loss - inert)).norm();
        assert!((got / wanted - 1.0).abs() < 2e-3, "{order_of_twist}: {got} {wanted}");
    }
}

#[test]
fn a_flywheel_without_inertia_is_refused() {
    let own = single(twisting(), TrainLaw::Rigid, 400.0);
    let flywheel = FreeFlywheel { inertia: 0.0, train: 5e-4, change: 1e-3 };
    assert!(matches!(run_free(&own, flywheel, options(), &|_| true), Err(FlexError::Number { .. })));
}
