//! Andrews' squeezer, problem `andrews` of the Test Set for IVP Solvers: seven bodies, hinges, three loops, a spring, a motor. A mechanism that is no engine,
//! by which the referee itself is judged.

use crate::referee::{Assembly, BodyLoad, GROUND, Joint, LineSpring, Pose, RigidBody};
use lanchester_numerics::{Dop853, Function, Outcome, Settings, about_zero};
use nalgebra::{Matrix3, Rotation3, Vector3};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// Pivots and the end of the spring on the ground [m], torque of the motor [N m].
const A: [f64; 2] = [-0.06934, -0.00227];
const B: [f64; 2] = [-0.03635, 0.03273];
const C: [f64; 2] = [0.014, 0.072];
const TORQUE: f64 = 0.033;

/// A place in the plane.
fn flat(x: f64, y: f64) -> Vector3<f64> {
    Vector3::new(x, y, 0.0)
}

/// The squeezer at its start, with every body at its angle; each body's axes are those of the frame where its angle is 0, its reference its centre.
#[expect(clippy::excessive_precision, reason = "as the test set prints them")]
pub fn squeezer() -> (Assembly, Vec<Pose>) {
    let [beta, theta, gamma, phi, delta, omega, epsilon]: [f64; 7] = [
        -0.0617138900142764496358948458001,
        0.0,
        0.455279819163070380255912382449,
        0.222668390165885884674473185609,
        0.487364979543842550225598953530,
        -0.222668390165885884674473185609,
        1.23054744454982119249735015568,
    ];
    let [d, da, e, ea, rr, ra, ss]: [f64; 7] = [28e-3, 115e-4, 2e-2, 1421e-5, 7e-3, 92e-5, 35e-3];
    let [sa, sb, sc, sd, zf, zt, fa] = [1874e-5, 1043e-5, 18e-3, 2e-2, 2e-2, 4e-2, 1421e-5];
    let [ta, tb, u, ua, ub] = [2308e-5, 916e-5, 4e-2, 1228e-5, 449e-5];
    // Mass, inertia, angle, pivot of the body and its centre from there, both along the body's axes.
    let o = [0.0, 0.0];
    let end_5 = [A[0] + zt * delta.cos(), A[1] + zt * delta.sin()];
    let end_7 = [A[0] + u * epsilon.sin(), A[1] - u * epsilon.cos()];
    let end_1 = [rr * beta.cos(), rr * beta.sin()];
    let bodies = [
        (0.04325, 2.194e-6, beta, o, [ra, 0.0]),
        (0.00365, 4.410e-7, beta + theta, end_1, [-da, 0.0]),
        (0.02373, 5.255e-6, gamma, B, [sa, sb]),
        (0.00706, 5.667e-7, phi + delta, end_5, [0.0, -(e - ea)]),
        (0.07050, 1.169e-5, delta, A, [ta, tb]),
        (0.00706, 5.667e-7, omega + epsilon, end_7, [zf - fa, 0.0]),
        (0.05498, 1.912e-5, epsilon, A, [ua, ub]),
    ];
    let mut assembly = Assembly::default();
    let mut poses = Vec::new();
    for (index, (mass, inertia, angle, pivot, centre)) in bodies.into_iter().enumerate() {
        // Thin plates: only the inertia about z enters the plane motion.
        let tensor = Matrix3::from_diagonal(&Vector3::new(0.5 * inertia, 0.5 * inertia, inertia));
        assembly.add(RigidBody::central(&format!("K{}", index + 1), mass, tensor));
        let rotation = Rotation3::from_axis_angle(&Vector3::z_axis(), angle).into_inner();
        poses.push(Pose::at(flat(pivot[0], pivot[1]) + rotation * flat(centre[0], centre[1]), rotation));
    }
    let z = Vector3::z();
    // A point of a body, from its pivot, seen from its centre.
    let seen = |index: usize, x: f64, y: f64| flat(x - bodies[index].4[0], y - bodies[index].4[1]);
    let at = |place: [f64; 2]| flat(place[0], place[1]);
    let hinge = |a, b, on_a, on_b| Joint::revolute("hinge", a, b, [on_a, on_b], [z, z]);
    assembly.joints = vec![
        hinge(GROUND, 0, at(o), seen(0, 0.0, 0.0)),
        hinge(0, 1, seen(0, rr, 0.0), seen(1, 0.0, 0.0)),
        hinge(GROUND, 2, at(B), seen(2, 0.0, 0.0)),
        hinge(GROUND, 4, at(A), seen(4, 0.0, 0.0)),
        hinge(4, 3, seen(4, zt, 0.0), seen(3, 0.0, 0.0)),
        hinge(GROUND, 6, at(A), seen(6, 0.0, 0.0)),
        hinge(6, 5, seen(6, 0.0, -u), seen(5, 0.0, 0.0)),
    ];
    // The far end of K2 is that of K3, K4 and K6: a line along z is enough in the plane.
    let meet = |b, on_b| Joint::point_in_line("meeting point", 1, b, [seen(1, -d, 0.0), on_b], z);
    assembly.joints.extend([
        meet(2, seen(2, 0.0, -ss)),
        meet(3, seen(3, 0.0, -e)),
        meet(5, seen(5, zf, 0.0)),
    ]);
    assembly.springs.push(LineSpring {
        bodies: [GROUND, 2],
        points: [at(C), seen(2, sd, -sc)],
        stiffness: 4530.0,
        length: 0.07785,
    });
    (assembly, poses)
}

/// Pieces of a run after each of which the bodies are put back onto their joints.
const PIECES: u32 = 300;

/// The squeezer's angles beta, Theta, gamma, Phi, delta [rad] after `time` [s] from its start; `None` where no step meets the tolerance or the loops cannot be closed.
pub fn squeezer_angles(time: f64) -> Option<[f64; 5]> {
    let (assembly, mut poses) = squeezer();
    let drive = [BodyLoad { body: 0, force: Vector3::zeros(), moment: TORQUE * Vector3::z() }];
    let angle = |pose: &Pose| pose.rotation[(1, 0)].atan2(pose.rotation[(0, 0)]);
    let mut turned: Vec<f64> = poses.iter().map(angle).collect();
    for piece in 0..PIECES {
        let mut state = assembly.pack(&poses);
        let mut system = Function::new(assembly.dimension(), |_, y: &[f64], rate: &mut [f64]| {
            assembly.rate(y, &drive, rate);
        });
        let mut settings = Settings::uniform(assembly.dimension(), 1e-12);
        settings.dense = false;
        settings.absolute.fill(1e-13);
        let [mut t, end] = [piece, piece + 1].map(|k| time * f64::from(k) / f64::from(PIECES));
        let outcome =
            Dop853::new(settings).run(&mut system, &mut t, &mut state, end, |_| ControlFlow::Continue(()));
        if outcome != Outcome::Reached {
            return None;
        }
        poses = assembly.unpack(&state);
        assembly.project(&mut poses)?;
        for (sum, pose) in turned.iter_mut().zip(&poses) {
            *sum += about_zero(angle(pose) - *sum, TAU);
        }
    }
    let [k1, k2, k3, k4, k5, ..] = turned[..] else { return None };
    Some([k1, k2 - k1, k3, k4 - k5, k5])
}
