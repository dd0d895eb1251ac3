//! The force at real mounts as the objective: stiffness, damping, the block's own inertia.

use crate::optimum::support::{assert_proved, on_crank, shaft, stage, stripped, weight};
use lanchester_balance::{Answer, BalanceError, fitted, optimise};
use lanchester_mechanism::{MountError, MountSystem, inertia_excitations, vector_amplitude};
use lanchester_model::{Block, Engine, Mount, MountPoint, MountSpring, MovingParts};
use lanchester_task::{BalanceTask, Criterion, Load, Seat, Stage};

/// An in-line three on three mounts, of which one has a table and one stands askew.
pub fn engine(stiffness: f64, mass: f64) -> Engine {
    let mount = |name: &str, [x, y, z]: [f64; 3], spring: MountSpring| Mount {
        name: name.into(),
        x,
        y,
        z,
        spring: Some(MountSpring { damping: [80.0; 3], ..spring }),
    };
    let spring = |factor: f64| MountSpring {
        loss_factor: [0.1; 3],
        ..MountSpring::along_frame([factor * stiffness, 0.6 * stiffness, 0.7 * stiffness])
    };
    let point = |angular_frequency: f64, factor: f64| MountPoint {
        angular_frequency,
        stiffness: [factor * stiffness, 0.6 * factor * stiffness, 0.7 * factor * stiffness],
        loss_factor: [0.2; 3],
    };
    let (sin, cos) = 0.5f64.sin_cos();
    let askew = MountSpring { axes: [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]], ..spring(1.3) };
    let tabled = MountSpring {
        table: vec![point(10.0, 1.0), point(300.0, 1.4), point(1500.0, 1.8)],
        loss_factor: [0.0; 3],
        ..spring(1.0)
    };
    let block = Block {
        mass,
        centre: [0.05, 0.01, 0.08],
        inertia: [0.05 * mass, 0.045 * mass, 0.03 * mass],
        products: [0.001 * mass, -0.002 * mass, 0.004 * mass],
        moving_parts: MovingParts::Included,
        gravity: [-1.0, 0.0, 0.0],
        driveline_torque: [0.0; 3],
    };
    stripped("in-line-3")
        .with(|parts| {
            parts.block = Some(block);
            parts.mounts = vec![
                mount("left", [-0.08, -0.24, -0.15], spring(1.0)),
                mount("right", [-0.08, 0.24, -0.15], tabled),
                mount("rear", [-0.06, 0.0, 0.62], askew),
            ];
        })
        .expect("an engine")
}

pub fn task(load: Load) -> BalanceTask {
    let (across, along) = (shaft("counter", -1, 0.0, 0.1), Seat::Shaft(0));
    BalanceTask {
        shafts: vec![across],
        weights: vec![
            on_crank("front", -0.1),
            on_crank("rear", 0.1),
            weight("shaft front", along, -0.1),
            weight("shaft rear", along, 0.1),
        ],
        stages: vec![stage(load)],
        ..Default::default()
    }
}

/// Peak of the force at each mount with the weights that were found, by the kernel of the response.
fn response(engine: &Engine, answer: &Answer) -> Vec<f64> {
    let fitted = fitted(engine, answer);
    let excitations = inertia_excitations(&fitted, &[engine.speed.highest], 24).expect("the engine is valid");
    let system = MountSystem::new(&fitted).expect("the mounts hold the block");
    let found = system.response(&excitations).expect("the mounts are damped");
    found.speeds[0].peaks.iter().map(|p| p.value).collect()
}

#[test]
fn the_optimum_on_real_mounts_is_proved_and_is_what_the_response_says() {
    for (stiffness, mass) in [(2e5, 90.0), (2e6, 90.0), (1e7, 150.0)] {
        let engine = engine(stiffness, mass);
        // At the highest speed alone.
        let task = |load| BalanceTask { speeds: vec![engine.speed.highest], ..task(load) };
        let answer = optimise(&engine, &task(Load::LargestMountForce)).unwrap();
        assert_proved(&engine, &answer);
        let value = answer.stages[0].value;
        let peaks = response(&engine, &answer);
        let largest = peaks.iter().copied().fold(0.0, f64::max);
        assert!((largest - value).abs() < 1e-8 * value, "{stiffness}: {peaks:?} {value}");
        for mount in 0..3 {
            let one = optimise(&engine, &task(Load::MountForce(mount))).unwrap();
            assert_proved(&engine, &one);
            let own = response(&engine, &one)[mount];
            assert!(
                (own - one.stages[0].value).abs() < 1e-8 * value,
                "{mount}: {own} {}",
                one.stages[0].value
            );
            assert!(one.stages[0].value <= value * (1.0 + 1e-9));
        }
    }
}

#[test]
fn one_order_at_a_mount_vanishes_where_the_weights_suffice() {
    // Six numbers of first order at a mount, eight free ones.
    let engine = engine(4e5, 110.0);
    let first = Criterion::Order(Load::MountForce(1), 1.0);
    let asked = BalanceTask { stages: vec![Stage { terms: vec![(1.0, first)] }], ..task(Load::Force) };
    let answer = optimise(&engine, &asked).unwrap();
    let fitted = fitted(&engine, &answer);
    let at = |engine: &Engine| {
        let excitations = inertia_excitations(engine, &[engine.speed.highest], 2).unwrap();
        let found = MountSystem::new(engine).unwrap().response(&excitations).unwrap();
        let order = found.speeds[0].orders.iter().find(|o| o.order == 1.0).cloned().unwrap();
        vector_amplitude(&order.forces[1])
    };
    assert!(at(&fitted) < 1e-6 * at(&engine), "{} {}", at(&fitted), at(&engine));
}

#[test]
fn very_stiff_equal_springs_are_the_rigid_share() {
    let mut elastic = engine(1e15, 90.0);
    elastic = elastic
        .with(|elastic| {
            for spring in elastic.mounts.iter_mut().filter_map(|m| m.spring.as_mut()) {
                *spring = MountSpring::along_frame([1e15; 3]);
            }
        })
        .unwrap();
    let mut rigid = elastic.clone();
    rigid = rigid
        .with(|rigid| {
            rigid.block = None;

            rigid.mounts.iter_mut().for_each(|m| m.spring = None);
        })
        .unwrap();
    let [elastic, rigid] = [&elastic, &rigid]
        .map(|engine| optimise(engine, &task(Load::LargestMountForce)).unwrap().stages[0].value);
    // What is left of the block's motion is (order times speed)^2 m / k, 1e-7.
    assert!((elastic - rigid).abs() < 1e-6 * rigid, "{elastic} {rigid}");
}

#[test]
fn mounts_that_do_not_hold_the_block_are_told() {
    let mut engine = engine(2e5, 90.0);
    engine = engine
        .with(|engine| {
            engine.mounts.truncate(2);
        })
        .unwrap();
    let told = optimise(&engine, &task(Load::LargestMountForce));
    assert!(matches!(told, Err(BalanceError::Mounts(MountError::Free { .. }))), "{told:?}");
}
