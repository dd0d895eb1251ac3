//! What turns in the block, against the angular momentum in space of a block with a spinning rotor.

use crate::support::in_line;
use crate::support::mounted::{block, mount};
use lanchester_mechanism::{
    MountSystem, RotorEffects, TurningInertia, inertia_excitations, rotor_inertia_about_z, train_inertia,
};
use lanchester_model::{Block, Engine, Flywheel, Mount, MountSpring, ShapedCrankshaft};
use nalgebra::{Matrix3, Rotation3, Vector3};
use num_complex::Complex64;
use std::f64::consts::TAU;

const SPEED: f64 = 140.0;

/// Flywheel [kg m^2]: a large one, so that what it does shows.
const J: f64 = 0.8;

/// A three-cylinder engine, whose couples pitch and yaw it, with a flywheel, on four soft mounts.
fn engine() -> Engine {
    let spring = MountSpring { damping: [500.0; 3], ..MountSpring::along_frame([2e5, 1.3e5, 1e5]) };
    let place = |name: &str, at| Mount { spring: Some(spring.clone()), ..mount(name, at, [0.0; 3]) };
    in_line(&[0.0, TAU / 3.0, 2.0 * TAU / 3.0])
        .with(|parts| {
            parts.block = Some(Block { centre: [0.05, 0.01, 0.02], ..block(150.0, [9.0, 8.0, 4.0]) });
            parts.mounts = vec![
                place("a", [-0.1, 0.25, 0.3]),
                place("b", [-0.1, -0.25, 0.28]),
                place("c", [-0.1, 0.22, -0.25]),
                place("d", [-0.1, -0.25, -0.27]),
            ];
            parts.flywheel = Some(Flywheel {
                inertia: Some(J),
                crankshaft_inertia: None,
                fluctuation: None,
                speeds: Vec::new(),
            });
        })
        .unwrap()
}

/// The motion of each order is put into a block that turns in space with its rotor: angular momentum, from rotation matrices alone, changes as load, mounts and
/// the torque of the drive say. Small enough that what the linear response leaves out is a thousandth of the tolerance.
#[test]
fn the_response_obeys_the_angular_momentum_in_space() {
    let engine = engine();
    let system = MountSystem::new(&engine).expect("it is held");
    assert_eq!(system.rotors(), J);
    let excitations = inertia_excitations(&engine, &[SPEED], 4).expect("it turns");
    let response = system.response(&excitations).expect("it is damped").speeds.remove(0);
    let tensor = engine.block.as_ref().expect("it has one").tensor();
    let inertia = Matrix3::from_fn(|i, j| tensor[i][j]);
    let small = 0.03;
    let mut checked = 0;
    for order in &response.orders {
        let w = order.order * SPEED;
        let at = |values: &[Complex64], t: f64| {
            Vector3::from_fn(|k, _| small * (values[k] * Complex64::cis(w * t)).re)
        };
        let step = 0.01 / w;
        let turned = |t: f64| Rotation3::from_scaled_axis(at(&order.motion[3..], t)).into_inner();
        let momentum = |t: f64| {
            let rate = (turned(t + step) - turned(t - step)) / (2.0 * step);
            let here = turned(t);
            let spin = here.transpose() * rate;
            let spin = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
            here * (inertia * spin + Vector3::new(0.0, 0.0, J * SPEED))
        };
        let moments: Vec<Complex64> = (3..6).map(|k| order.load[k] - order.transmitted[k]).collect();
        let scale = small * moments.iter().map(|m| m.norm()).fold(0.0, f64::max);
        if scale == 0.0 {
            continue;
        }
        for k in 0..8 {
            let t = TAU / w * f64::from(k) / 8.0;
            let change = (momentum(t + step) - momentum(t - step)) / (2.0 * step);
            // The drive from the ground turns the rotor on as the block rolls.
            let roll = |t: f64| at(&order.motion[3..], t).z;
            let drive = J * (roll(t + step) - 2.0 * roll(t) + roll(t - step)) / (step * step);
            let given = at(&moments, t) + Vector3::new(0.0, 0.0, drive);
            // Differences of second order in 0.01 rad, and the square of a turn of some 1e-5 rad.
            let off = (change - given).norm() / scale;
            assert!(off < 5e-4, "order {}: {off:e}", order.order);
        }
        checked += 1;
    }
    assert!(checked >= 2);
}

/// Each of the two causes matters, and without them the response is that of an engine without a flywheel.
#[test]
fn the_rotors_matter_and_can_be_left_out() {
    let engine = engine();
    let bare = engine.with(|parts| parts.flywheel = None).unwrap();
    let excitations = inertia_excitations(&engine, &[SPEED], 4).expect("it turns");
    let [with, left_out, without] = [
        MountSystem::new(&engine).expect("it is held"),
        MountSystem::new(&engine).expect("it is held").with_rotors(0.0),
        MountSystem::new(&bare).expect("it is held"),
    ]
    .map(|system| system.response(&excitations).expect("it is damped"));
    assert_eq!(left_out, without);
    // Each cause by itself.
    let alone = [RotorEffects::COUPLE, RotorEffects::ROLL, RotorEffects::NONE].map(|effects| {
        let system = MountSystem::new(&engine).expect("it is held").with_effects(effects);
        system.response(&excitations).expect("it is damped")
    });
    assert_eq!(alone[2], without);
    assert!(alone[0] != with && alone[1] != with && alone[0] != alone[1]);
    let turn = |response: &lanchester_mechanism::MountResponse| response.speeds[0].orders[0].motion;
    let (with, without) = (turn(&with), turn(&without));
    let changed = (3..6).map(|k| (with[k] - without[k]).norm()).fold(0.0, f64::max);
    let largest = (3..6).map(|k| without[k].norm()).fold(0.0, f64::max);
    assert!(changed > 0.02 * largest, "{changed:e} of {largest:e}");
}

/// `SUM rho J` of crankshafts that turn against each other and of balance shafts, where their inertia is known.
#[test]
fn every_rotor_counts_with_its_sense() {
    let mut engine = engine();
    let shape = ShapedCrankshaft { mass: 12.0, centre: [0.0; 3], inertia: 0.02 };
    assert_eq!(rotor_inertia_about_z(&engine.rotating_bodies(&[Some(shape)])), J + 0.02);
    engine = engine
        .with(|engine| {
            if let Some(flywheel) = &mut engine.flywheel {
                flywheel.crankshaft_inertia = Some(0.03);
            }
        })
        .unwrap();
    assert_eq!(rotor_inertia_about_z(&engine.rotating_bodies(&[])), J + 0.03);
    let mut shaft = lanchester_model::BalanceShaft {
        name: "shaft".into(),
        ratio: lanchester_model::Ratio::new(-2, 1).expect("not 0"),
        x: 0.0,
        y: 0.1,
        weights: Vec::new(),
        inertia: Some(0.001),
    };
    engine = engine
        .with(|engine| {
            engine.shafts.push(shaft.clone());
        })
        .unwrap();
    assert!((rotor_inertia_about_z(&engine.rotating_bodies(&[])) - (J + 0.03 - 0.002)).abs() < 1e-15);
    shaft.inertia = None;
    shaft.name = "another".into();
    engine = engine
        .with(|engine| {
            engine.shafts.push(shaft);
        })
        .unwrap();
    assert!((rotor_inertia_about_z(&engine.rotating_bodies(&[])) - (J + 0.03 - 0.002)).abs() < 1e-15);
}

/// A gear counts in the roll by its momentum, and in the inertia of the train by its energy.
#[test]
fn a_gear_counts_in_roll_and_in_the_train() {
    let gear = lanchester_model::Gear {
        name: "camshaft gear".into(),
        ratio: lanchester_model::Ratio::new(-1, 2).expect("not 0"),
        x: 0.08,
        y: 0.0,
        inertia: Some(0.004),
        disc: None,
    };
    let (plain, geared) = (engine(), engine().with(|engine| engine.gears.push(gear)).unwrap());
    assert_eq!(
        rotor_inertia_about_z(&geared.rotating_bodies(&[])),
        rotor_inertia_about_z(&plain.rotating_bodies(&[])) - 0.002
    );
    let given = TurningInertia { flywheel: J, crankshaft: 0.01 };
    let theta = [0.0, 1.0, 2.0];
    let [plain, geared] = [plain, geared].map(|engine| train_inertia(&engine, given, &theta).unwrap());
    assert_eq!((plain.geared, geared.geared), (0.0, 0.001));
    for (with, without) in geared.total.iter().zip(&plain.total) {
        assert!((with - without - 0.001).abs() < 1e-15);
    }
}
