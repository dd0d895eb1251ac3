//! The block on its mounts: closed forms, limits and refusals.
use crate::support::mounted::{block, mount, table};
use crate::support::{assert_close, in_line, vee};
use lanchester_mechanism::{
    Excitation, LoadRequest, MountError, MountSystem, inertia_excitations, loads, vector_amplitude,
};
use lanchester_model::{Block, Engine, EngineParts, MAX_LOSS_FACTOR, Mount, MountPoint, MovingParts};
use nalgebra::{Matrix3, Vector3};
use num_complex::Complex64;

/// A single cylinder on these mounts.
fn on(block: Block, mounts: Vec<Mount>) -> Engine {
    in_line(&[0.0]).with(|parts| (parts.block, parts.mounts) = (Some(block), mounts)).unwrap()
}

fn system(engine: &Engine) -> MountSystem {
    MountSystem::new(engine).expect("the mounts hold the block")
}

fn spring(mount: &mut Mount) -> &mut lanchester_model::MountSpring {
    mount.spring.as_mut().expect("the mount has a spring")
}

#[test]
fn a_symmetric_block_moves_along_its_axes_with_known_frequencies() {
    let (m, inertia, [kx, ky, kz], b, c) = (120.0, [6.0, 5.0, 3.0], [3e5, 1e5, 2e5], 0.2, 0.3);
    let engine = on(block(m, inertia), table(b, c, [kx, ky, kz]));
    let found = system(&engine).modes().expect("it has modes");
    // About x the mounts yield across and along the crank, about y and z in x alone: all of them lie in x = 0.
    let wanted = [
        4.0 * kx / m,
        4.0 * ky / m,
        4.0 * kz / m,
        4.0 * (ky * c * c + kz * b * b) / inertia[0],
        4.0 * kx * c * c / inertia[1],
        4.0 * kx * b * b / inertia[2],
    ];
    let mut seen = [false; 6];
    for (k, mode) in found.modes.iter().enumerate() {
        let main = mode.main;
        seen[main] = true;
        assert_close("frequency", mode.angular_frequency, wanted[main].sqrt(), 0.0, 1e-12, "closed form");
        assert_close("share", mode.energy[main], 1.0, 1e-12, 0.0, "the axes do not couple");
        assert!(mode.coupling.abs() < 1e-12);
        assert!(mode.mount_energy.iter().all(|e| (e - 0.25).abs() < 1e-9), "four equal mounts: {mode:?}");
        assert!(k == 0 || found.modes[k - 1].angular_frequency <= mode.angular_frequency);
    }
    assert_eq!(seen, [true; 6]);
    assert!(found.stiffness_centre.coupling < 1e-12);
    assert!(found.stiffness_centre.point.iter().all(|p| p.abs() < 1e-12));
    assert_eq!(found.torque_roll_axis.direction, [0.0, 0.0, 1.0]);
}

#[test]
fn viscous_damping_along_one_axis_has_the_textbook_ratio() {
    let (m, k, c): (f64, f64, f64) = (100.0, 2.5e5, 900.0);
    let mut mounts = table(0.2, 0.3, [k, 3.0 * k, 7.0 * k]);
    mounts.iter_mut().for_each(|mount| spring(mount).damping = [c, 0.0, 0.0]);
    let found = system(&on(block(m, [6.0, 5.0, 4.0]), mounts)).modes().expect("it has modes");
    let ratio = c / (2.0 * (k * m / 4.0).sqrt());
    // Along x: four springs and four dampers on the mass.
    let own = (4.0 * k / m).sqrt();
    let wanted = Complex64::new(-ratio * own, own * (1.0 - ratio * ratio).sqrt());
    let nearest =
        found.damped.iter().min_by(|a, b| (a.root - wanted).norm().total_cmp(&(b.root - wanted).norm()));
    let nearest = nearest.expect("there are roots");
    assert!((nearest.root - wanted).norm() < 1e-9 * own, "{nearest:?} {wanted}");
    assert_close("damping ratio", nearest.damping_ratio, ratio, 1e-12, 0.0, "closed form");
    assert_eq!(found.damped.len(), 6);
}

#[test]
fn an_overdamped_motion_has_two_roots_that_do_not_oscillate() {
    let (m, k): (f64, f64) = (100.0, 2.5e5);
    let c = 3.0 * (k * m / 4.0).sqrt() * 2.0;
    let mut mounts = table(0.2, 0.3, [k, 3.0 * k, 7.0 * k]);
    mounts.iter_mut().for_each(|mount| spring(mount).damping = [0.0, c, 0.0]);
    let found = system(&on(block(m, [6.0, 5.0, 4.0]), mounts)).modes().expect("it has modes");
    let still: Vec<_> = found.damped.iter().filter(|d| d.root.im.abs() < 1e-6 * d.root.norm()).collect();
    // Along y, and about x, which moves the mounts along y too.
    assert!(still.len() >= 2 && found.damped.len() > 6, "{:?}", found.damped);
    assert!(still.iter().all(|d| d.root.re < 0.0 && (d.damping_ratio - 1.0).abs() < 1e-9));
    let own = (12.0 * k / m).sqrt();
    let zeta = 4.0 * c / (2.0 * m * own);
    for sign in [-1.0, 1.0] {
        let wanted = own * (-zeta + sign * (zeta * zeta - 1.0).sqrt());
        assert!(still.iter().any(|d| (d.root.re - wanted).abs() < 1e-6 * own), "{wanted}: {still:?}");
    }
}

#[test]
fn the_torque_roll_axis_is_the_line_that_stays() {
    let mut body = block(90.0, [5.0, 4.0, 3.0]);
    body.products = [0.1, -0.4, 0.6];
    body.centre = [0.08, -0.02, 0.05];
    let engine = on(body.clone(), table(0.2, 0.3, [1e5; 3]));
    let axis = system(&engine).torque_roll_axis();
    assert_eq!(axis.point, body.centre);
    // Euler: I alpha = e_z.
    let tensor = Matrix3::from_fn(|i, j| body.tensor()[i][j]);
    let moment = tensor * Vector3::from(axis.direction);
    assert!(moment.x.abs() < 1e-14 * moment.z && moment.y.abs() < 1e-14 * moment.z, "{moment}");
}

#[test]
fn mounts_off_the_centre_have_their_centre_of_stiffness_where_a_force_does_not_turn() {
    // A shear building: four mounts 0.15 below the centre and 0.1 towards the flywheel.
    let mounts: Vec<Mount> =
        table(0.2, 0.3, [3e5, 1e5, 2e5]).into_iter().map(|m| Mount { x: -0.15, z: m.z + 0.1, ..m }).collect();
    let found = system(&on(block(100.0, [6.0, 5.0, 4.0]), mounts)).stiffness_centre();
    for (got, wanted) in found.point.iter().zip([-0.15, 0.0, 0.1]) {
        assert_close("place [m]", *got, wanted, 1e-12, 0.0, "rounding");
    }
    assert!(found.coupling < 1e-12);
    for (got, wanted) in found.stiffness.iter().zip([4e5, 8e5, 12e5]) {
        assert_close("stiffness [N/m]", *got, wanted, 0.0, 1e-12, "four in parallel");
    }
}

#[test]
fn weight_and_torque_are_shared_as_levers_say() {
    // Two mounts left and right and one below the flywheel; statically determinate along x.
    let stiff = [2e5, 1e5, 1e5];
    let mounts = vec![
        mount("left", [0.0, -0.2, -0.1], stiff),
        mount("right", [0.0, 0.3, -0.1], stiff),
        mount("rear", [0.0, 0.0, 0.5], stiff),
    ];
    let mut body = block(150.0, [8.0, 7.0, 4.0]);
    body.centre = [0.0, 0.02, 0.06];
    body.driveline_torque = [0.0, 0.0, 90.0];
    let rest = system(&on(body, mounts)).at_rest();
    let weight = 150.0 * 9.80665;
    // Moments about y: rear; about z: right against left. The weight acts along -x on the mounts.
    let rear = weight * 0.16 / 0.6;
    let right = (weight * 0.02 + 0.2 * (weight - rear)) / 0.5;
    let wanted = [-(weight - rear - right), -right, -rear];
    for (mount, wanted) in rest.mounts.iter().zip(wanted) {
        assert_close("weight share [N]", mount.gravity[0], wanted, 1e-9, 0.0, "lever rule");
        assert_close("deflection [m]", mount.deflection[0], mount.force[0] / 2e5, 1e-15, 0.0, "the spring");
    }
    // The crank turns from +x to +y and drives; the block leans the other way: -T about z, M_z = -SUM y f_x.
    let about_z: f64 = [-0.2, 0.3, 0.0].iter().zip(&rest.mounts).map(|(y, m)| -y * m.torque[0]).sum();
    assert_close("moment of the torque shares [N m]", about_z, -90.0, 1e-9, 0.0, "equilibrium");
    assert!(rest.mounts[1].torque[0] > 0.0 && rest.mounts[0].torque[0] < 0.0);
}

#[test]
fn a_preload_of_its_share_of_weight_leaves_a_mount_where_it_is() {
    let mut mounts = table(0.2, 0.3, [2e5, 1e5, 1e5]);
    let share = 100.0 * 9.80665 / 4.0;
    mounts.iter_mut().for_each(|m| spring(m).preload = share);
    let rest = system(&on(block(100.0, [6.0, 5.0, 4.0]), mounts.clone())).at_rest();
    assert!(rest.motion.iter().all(|q| q.abs() < 1e-15), "{rest:?}");
    assert!(rest.mounts.iter().all(|m| (m.force[0] + share).abs() < 1e-10));
    // Two mounts that push against each other carry that force and move nothing.
    mounts.iter_mut().for_each(|m| spring(m).preload = 0.0);
    for (k, side) in [(0, 1.0), (1, -1.0)] {
        spring(&mut mounts[k]).axes = [[0.0, side, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -side]];
        spring(&mut mounts[k]).stiffness = [1e5, 2e5, 1e5];
        spring(&mut mounts[k]).preload = 700.0;
    }
    let pushed = system(&on(block(100.0, [6.0, 5.0, 4.0]), mounts)).at_rest();
    assert_close(
        "force along y [N]",
        pushed.mounts[0].force[1],
        -700.0,
        1e-9,
        0.0,
        "it pushes the block to +y",
    );
    assert_close("force along y [N]", pushed.mounts[1].force[1], 700.0, 1e-9, 0.0, "and back");
    assert_close("own force [N]", pushed.mounts[1].own_force[0], -700.0, 1e-9, 0.0, "against its own push");
}

#[test]
fn very_stiff_mounts_pass_on_the_loads_as_they_are() {
    // Every crank angle: the sum of the orders' forces is the load of the trace, signs and phases included.
    let engine = vee(60.0, &[0.0, 240.0, 120.0]);
    let mut body = block(150.0, [8.0, 7.0, 4.0]);
    body.centre = [0.1, 0.02, 0.05];
    let engine = engine
        .with(|parts| (parts.block, parts.mounts) = (Some(body.clone()), table(0.2, 0.3, [1e15; 3])))
        .unwrap();
    let excitations = inertia_excitations(&engine, &[300.0], 24).expect("the engine is valid");
    let found = system(&engine).response(&excitations).expect("there is a response");
    let request = LoadRequest { speed: Some(300.0), reference: body.centre, ..LoadRequest::default() };
    let trace = loads(&engine, &request).expect("the engine is valid").total.trace;
    for j in [0, 37, 290, 511, 719] {
        let theta = trace.theta[j];
        let sum = |c: usize| -> f64 {
            found.speeds[0]
                .orders
                .iter()
                .map(|o| (o.transmitted[c] * Complex64::cis(o.order * theta)).re)
                .sum()
        };
        let scale = 1e4;
        for (c, wanted) in [
            (0, trace.force_x[j]),
            (1, trace.force_y[j]),
            (2, 0.0),
            (3, trace.couple_x[j]),
            (4, trace.couple_y[j]),
            (5, trace.roll_moment[j]),
        ] {
            assert_close(
                "load",
                sum(c),
                wanted,
                1e-7 * scale,
                0.0,
                "stiffness 1e15 N/m leaves 1e-8 of motion",
            );
        }
    }
}

#[test]
fn very_soft_mounts_leave_the_block_to_its_inertia() {
    let engine = in_line(&[0.0, 180.0]);
    let body = block(80.0, [5.0, 4.0, 3.0]);
    let engine = engine
        .with(|parts| (parts.block, parts.mounts) = (Some(body.clone()), table(0.2, 0.3, [1e-3; 3])))
        .unwrap();
    let excitations = inertia_excitations(&engine, &[400.0], 4).expect("the engine is valid");
    let found = system(&engine).response(&excitations).expect("there is a response");
    for order in &found.speeds[0].orders {
        let w2 = (order.order * 400.0).powi(2);
        for (c, inertia) in [80.0, 80.0, 80.0, 5.0, 4.0, 3.0].into_iter().enumerate() {
            let wanted = -order.load[c] / (inertia * w2);
            assert!((order.motion[c] - wanted).norm() <= 1e-8 * wanted.norm(), "{c} {order:?}");
        }
        assert!(order.force_transmissibility().is_none_or(|t| t < 1e-6));
    }
}

#[test]
fn a_point_of_the_block_moves_with_it() {
    let engine = in_line(&[0.0, 180.0]);
    let mut body = block(80.0, [5.0, 4.0, 3.0]);
    body.centre = [0.1, -0.03, 0.04];
    let engine = engine
        .with(|parts| (parts.block, parts.mounts) = (Some(body), table(0.2, 0.3, [2e5, 1e5, 3e5])))
        .unwrap();
    let excitations = inertia_excitations(&engine, &[200.0], 4).expect("the engine is valid");
    let found = system(&engine).response(&excitations).expect("there is a response");
    let order = &found.speeds[0].orders[1];
    // An undamped spring's force is its stiffness times the motion of its place.
    for (mount, force) in engine.mounts.iter().zip(&order.forces) {
        let motion = order.motion_at(found.centre, [mount.x, mount.y, mount.z]);
        for (j, k) in [2e5, 1e5, 3e5].into_iter().enumerate() {
            let size = vector_amplitude(force);
            assert!((force[j] - k * motion[j]).norm() < 1e-12 * size);
        }
    }
}

#[test]
fn transmissibility_is_that_of_one_mass_on_a_spring() {
    let (m, k, eta): (f64, f64, f64) = (100.0, 2e5, 0.1);
    let mut mounts = table(0.2, 0.3, [k; 3]);
    mounts.iter_mut().for_each(|mount| spring(mount).loss_factor = [eta; 3]);
    let system = system(&on(block(m, [6.0, 5.0, 4.0]), mounts));
    let own = (4.0 * k / m).sqrt();
    let ratios = [1e-4, 0.5, 1.0, 2.0f64.sqrt(), 5.0];
    let frequencies: Vec<f64> = ratios.iter().map(|r| r * own).collect();
    let found = system.transmissibility(&frequencies).expect("it is damped");
    for (got, r) in found.iter().zip(ratios) {
        let wanted = ((1.0 + eta * eta) / ((1.0 - r * r).powi(2) + eta * eta)).sqrt();
        (0..3).for_each(|c| assert_close("transmissibility", got[c], wanted, 0.0, 1e-12, "closed form"));
    }
}

#[test]
fn a_table_of_one_value_is_that_value_and_its_ends_are_told() {
    let mut plain = table(0.2, 0.25, [2e5, 1e5, 3e5]);
    plain.iter_mut().for_each(|m| spring(m).loss_factor = [0.1, 0.2, 0.3]);
    let mut tabled = plain.clone();
    for mount in &mut tabled {
        let own = spring(mount);
        let point =
            |f| MountPoint { angular_frequency: f, stiffness: own.stiffness, loss_factor: own.loss_factor };
        own.table = vec![point(10.0), point(200.0), point(700.0)];
        own.loss_factor = [0.0; 3];
    }
    let body = Block { centre: [0.05, 0.01, 0.02], ..block(100.0, [6.0, 5.0, 4.0]) };
    let [plain, tabled] = [plain, tabled].map(|mounts| system(&on(body.clone(), mounts)));
    let excitations = inertia_excitations(&in_line(&[0.0, 180.0]), &[100.0, 300.0], 4).expect("valid");
    let [one, two] = [&plain, &tabled].map(|s| s.response(&excitations).expect("it is damped"));
    for (a, b) in one.speeds.iter().zip(&two.speeds) {
        for (a, b) in a.orders.iter().zip(&b.orders) {
            let gap = (0..6).map(|c| (a.motion[c] - b.motion[c]).norm()).fold(0.0, f64::max);
            assert!(gap < 1e-12 * a.motion.iter().map(|c| c.norm()).fold(0.0, f64::max));
        }
    }
    assert!(one.beyond_table.is_empty());
    assert_eq!(two.beyond_table.len(), 4);
    assert_eq!(two.beyond_table[0].table, [10.0, 700.0]);
    assert_eq!(two.beyond_table[0].excitation, [100.0, 1200.0]);
    let [one, two] = [&plain, &tabled].map(|s| s.modes().expect("it has modes"));
    for (a, b) in one.modes.iter().zip(&two.modes) {
        let gap = (a.angular_frequency - b.angular_frequency).abs();
        assert!(gap < 1e-9 * a.angular_frequency, "{a:?} {b:?}");
    }
    for (a, b) in one.damped.iter().zip(&two.damped) {
        assert!((a.root - b.root).norm() < 1e-8 * a.root.norm(), "{a:?} {b:?}");
    }
}

#[test]
fn a_mode_takes_the_stiffness_of_its_own_frequency() {
    let (m, soft, hard): (f64, f64, f64) = (100.0, 1e5, 4e5);
    let mut mounts = table(0.2, 0.3, [soft, 5e5, 5e5]);
    for mount in &mut mounts {
        let own = spring(mount);
        let point =
            |f, k| MountPoint { angular_frequency: f, stiffness: [k, 5e5, 5e5], loss_factor: [0.1; 3] };
        own.table = vec![point(0.0, soft), point(200.0, hard)];
    }
    let found = system(&on(block(m, [6.0, 5.0, 4.0]), mounts)).modes().expect("it has modes");
    let along_x = found.modes.iter().find(|mode| mode.main == 0).expect("one mode is along x");
    // m w^2 = 4 ( soft + (hard - soft) w / 200 ), a quadratic in w.
    let (a, b, c) = (m, -4.0 * (hard - soft) / 200.0, -4.0 * soft);
    let wanted = (-b + (b * b - 4.0 * a * c).sqrt()) / (2.0 * a);
    assert_close("frequency [rad/s]", along_x.angular_frequency, wanted, 0.0, 1e-12, "root of the quadratic");
    assert!(
        found.damped.iter().any(|d| (d.root.im - wanted).abs() < 0.01 * wanted && d.damping_ratio > 0.04)
    );
}

#[test]
fn pistons_and_rods_are_added_where_they_are_on_average() {
    let plain = in_line(&[0.0, 180.0])
        .with(|parts| {
            parts.block = Some(Block { centre: [0.05, 0.0, 0.0], ..block(100.0, [6.0, 5.0, 4.0]) });
            parts.mounts = table(0.2, 0.3, [1e5; 3]);
        })
        .unwrap();
    let moved = |parts: &mut EngineParts| {
        parts.block.as_mut().expect("it has a block").moving_parts = MovingParts::Added;
    };
    let added = plain.with(moved).unwrap();
    let [plain, added] = [&plain, &added].map(|engine| (system(engine), engine));
    let (upper, lower): (f64, f64) = added.1.cylinders.iter().fold((0.0, 0.0), |sum, c| {
        (sum.0 + c.piston_mass + c.rod.small_end_mass, sum.1 + c.rod.big_end_mass)
    });
    let body = added.0.body();
    assert_close("added mass [kg]", body.added_mass, upper + lower, 0.0, 1e-14, "sum of the parts");
    assert_close("mass [kg]", body.mass, 100.0 + upper + lower, 0.0, 1e-14, "sum of the parts");
    assert_eq!(plain.0.body().mass, 100.0);
    // Places of both pistons, averaged on another grid.
    let motion =
        loads(added.1, &LoadRequest { samples: 500, ..LoadRequest::default() }).expect("valid").motion;
    let mean = |f: &dyn Fn(f64) -> f64| {
        motion
            .iter()
            .map(|c| c.trace.position.iter().map(|&s| f(s)).sum::<f64>() / c.trace.position.len() as f64)
            .sum::<f64>()
            / motion.len() as f64
    };
    let centre = (100.0 * 0.05 + upper * mean(&|s| s)) / body.mass;
    assert_close("centre [m]", body.centre[0], centre, 1e-14, 0.0, "centre of all parts");
    let r = added.1.throws[0].radius;
    let z = added.1.cylinders[0].z;
    // About y: the block, pistons at x = s, big ends at x = r cos; all at z = +-z.
    let about_y =
        5.0 + 100.0 * 0.05f64.powi(2) + upper * (mean(&|s| s * s) + z * z) + lower * (0.5 * r * r + z * z)
            - body.mass * centre * centre;
    assert_close("inertia about y [kg m^2]", body.inertia[1][1], about_y, 1e-12, 0.0, "sum over the parts");
    assert!(body.inertia[0][1].abs() < 1e-12);
}

#[test]
fn a_block_that_is_not_held_is_told_how_it_moves() {
    let told = |mounts: Vec<Mount>| match MountSystem::new(&on(block(100.0, [6.0, 5.0, 4.0]), mounts)) {
        Err(MountError::Free { motion }) => motion,
        other => panic!("not free: {other:?}"),
    };
    let k = [1e5, 2e5, 3e5];
    let [front, rear] = [mount("front", [-0.1, 0.05, -0.3], k), mount("rear", [0.1, -0.05, 0.4], k)];
    assert_eq!(
        told(vec![front.clone(), rear.clone()]),
        "it can turn about the line through mounts `front` and `rear`"
    );
    let middle = mount("middle", [0.0, 0.0, 0.05], k);
    assert_eq!(
        told(vec![front.clone(), middle, rear.clone()]),
        "it can turn about the line through mounts `front`, `middle` and `rear`"
    );
    assert_eq!(told(vec![front.clone()]), "it can turn about mount `front` in every direction");
    let sliding = table(0.2, 0.3, [1e5, 0.0, 1e5]);
    assert_eq!(told(sliding), "it can slide along y");
    // Pendulum rods: held along x alone.
    let only_x = table(0.2, 0.3, [1e5, 0.0, 0.0]);
    assert!(told(only_x).starts_with("it can slide along"));
    // Rods to a line: all forces pass it.
    let towards = |name: &str, y: f64, z: f64| {
        let mut rod = mount(name, [-0.3, y, z], [0.0; 3]);
        let length = (0.09 + y * y).sqrt();
        let along = [0.3 / length, -y / length, 0.0];
        spring(&mut rod).axes = [along, [-along[1], along[0], 0.0], [0.0, 0.0, 1.0]];
        spring(&mut rod).stiffness = [1e5, 0.0, 1e4];
        rod
    };
    let aimed = vec![
        towards("a", -0.3, -0.2),
        towards("b", 0.3, -0.2),
        towards("c", -0.3, 0.2),
        towards("d", 0.2, 0.2),
    ];
    let said = told(aimed);
    assert!(said.starts_with("it can "), "{said}");
    // A third mount off the line holds it.
    let third = mount("third", [0.0, 0.3, 0.0], k);
    assert!(MountSystem::new(&on(block(100.0, [6.0, 5.0, 4.0]), vec![front, rear, third])).is_ok());
}

#[test]
fn impossible_numbers_are_refused_by_name() {
    let good = || (block(100.0, [6.0, 5.0, 4.0]), table(0.2, 0.3, [1e5; 3]));
    let refused = |change: &dyn Fn(&mut Block, &mut Vec<Mount>)| {
        let (mut block, mut mounts) = good();
        change(&mut block, &mut mounts);
        match in_line(&[0.0]).with(|parts| (parts.block, parts.mounts) = (Some(block), mounts)) {
            Ok(engine) => MountSystem::new(&engine).expect_err("it is refused").to_string(),
            Err(faults) => faults[0].to_string(),
        }
    };
    let says = |text: String, words: &str| assert!(text.contains(words), "{text:?} lacks {words:?}");
    says(refused(&|b, _| b.mass = 0.0), "block: mass [kg] must be more than 0");
    says(refused(&|b, _| b.inertia[0] = 9.5), "block: inertia [kg m^2] must be that of some body");
    says(refused(&|b, _| b.products[1] = 4.0), "inertia [kg m^2] must be that of some body");
    says(refused(&|b, _| b.inertia[2] = -4.0), "inertia [kg m^2] must be that of some body");
    says(refused(&|b, _| b.centre[1] = f64::NAN), "block: centre [m] must be a finite number");
    says(refused(&|b, _| b.gravity = [0.0; 3]), "direction of gravity must be 1, got 0");
    says(
        refused(&|_, m| spring(&mut m[2]).stiffness = [0.0; 3]),
        "stiffness [N/m] of mount `mount 3` must be positive",
    );
    says(
        refused(&|_, m| spring(&mut m[1]).stiffness[0] = -1.0),
        "mounts[1]: spring.stiffness [N/m] must be 0 or more, got -1",
    );
    says(
        refused(&|_, m| spring(&mut m[1]).loss_factor[2] = 1.1 * MAX_LOSS_FACTOR),
        "loss factor of mount `mount 2`",
    );
    says(refused(&|_, m| spring(&mut m[1]).damping[2] = f64::INFINITY), "mounts[1]: spring.damping [N s/m]");
    says(refused(&|_, m| spring(&mut m[0]).axes[0] = [1.0, 1.0, 0.0]), "right angle");
    says(refused(&|_, m| m[3].spring = None), "mount `mount 4` needs a stiffness");
    says(refused(&|_, m| m.clear()), "needs mounts, got none");
    let unsorted = refused(&|_, m| {
        let point = |f| MountPoint { angular_frequency: f, stiffness: [1e5; 3], loss_factor: [0.1; 3] };
        spring(&mut m[0]).table = vec![point(50.0), point(20.0)];
    });
    says(unsorted, "mounts[0]: spring.table must be rising in frequency");
    let (_, mounts) = good();
    let bare = in_line(&[0.0]).with(|parts| parts.mounts = mounts).unwrap();
    assert_eq!(MountSystem::new(&bare).expect_err("no block"), MountError::NoBlock);
    let (block, mounts) = good();
    let system = system(&on(block, mounts));
    let still = Excitation { speed: 0.0, orders: Vec::new() };
    says(system.response(&[still]).expect_err("no speed").to_string(), "speed [rad/s] must be positive");
    says(
        inertia_excitations(&bare, &[-1.0], 4).expect_err("no speed").to_string(),
        "speed [rad/s] must be positive",
    );
}

#[test]
fn an_undamped_block_at_its_natural_frequency_has_no_steady_motion() {
    // w^2 = 4 k / m = 4 exactly, so that the matrix is singular to the last bit.
    let engine = on(block(64.0, [64.0; 3]), table(1.0, 1.0, [64.0; 3]));
    let system = system(&engine);
    let mut excitation = inertia_excitations(&engine, &[2.0], 1).expect("valid").remove(0);
    excitation.orders.retain(|o| o.order == 1.0);
    let error = system.response(&[excitation]).expect_err("it grows without end");
    assert_eq!(error, MountError::Resonance { order: 1.0, speed: 2.0 });
}
