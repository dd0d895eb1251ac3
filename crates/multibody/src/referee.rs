//! Referee: any rigid bodies with any joints in maximal coordinates, solved as one large system. Slow, small, and as far from the equations of
//! the crank train as can be.
//!
//! Every body has six speeds, velocity of its reference point and angular velocity, in the axes of the frame; a joint is a few rows of constraints:
//!
//! ```text
//! | M  J^T | | a       |   | Q - h |            point row:  g = n . (x_b - x_a)         n fixed in body a
//! | J  0   | | -lambda | = | gamma |            turn row:   g = n . m                   m fixed in body b
//!                                               spin row:   g' = SUM factor n . (omega_i - omega_a)  (gears, drives)
//! ```
//! `h`: what inertia takes at zero accelerations, `gamma = - J' nu`. Velocities follow from the same rows, `J nu = 0` with as many given speeds as there
//! are freedoms; places are corrected by Newton on `g`.

pub(crate) mod engine;
pub mod squeezer;

use nalgebra::{DMatrix, DVector, Matrix3, Rotation3, UnitQuaternion, Vector3};

/// A rigid body by its moments about a reference point, in its own axes. The reference may lie anywhere, so that also what is no body by itself, like an
/// unbalance on a massless axis, can be one.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidBody {
    /// Name for messages.
    pub name: String,
    /// Mass [kg].
    pub mass: f64,
    /// Mass times place of the centre from the reference [kg m].
    pub first_moment: Vector3<f64>,
    /// Inertia tensor about the reference [kg m^2].
    pub inertia: Matrix3<f64>,
}

impl RigidBody {
    /// A body with its reference in its centre.
    pub fn central(name: &str, mass: f64, inertia: Matrix3<f64>) -> RigidBody {
        RigidBody { name: name.to_owned(), mass, first_moment: Vector3::zeros(), inertia }
    }
}

/// Pose and speeds of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Its reference point [m].
    pub position: Vector3<f64>,
    /// From its axes to those of the frame.
    pub rotation: Matrix3<f64>,
    /// Velocity of the reference point [m/s].
    pub velocity: Vector3<f64>,
    /// Angular velocity [rad/s].
    pub spin: Vector3<f64>,
}

impl Pose {
    /// At rest.
    pub fn at(position: Vector3<f64>, rotation: Matrix3<f64>) -> Pose {
        Pose { position, rotation, velocity: Vector3::zeros(), spin: Vector3::zeros() }
    }
}

/// Index of a body; the ground is [`GROUND`].
pub type BodyIndex = usize;

/// The ground: a body that never moves.
pub const GROUND: BodyIndex = usize::MAX;

/// One row of constraints.
#[derive(Debug, Clone, PartialEq)]
pub enum Row {
    /// A point of b stays where it is along a direction of a, seen from a point of a.
    Point {
        /// Direction in a.
        along: Vector3<f64>,
        /// Point in a.
        on_a: Vector3<f64>,
        /// Point in b.
        on_b: Vector3<f64>,
    },
    /// A direction of b stays at a right angle to one of a.
    Turn {
        /// Direction in a.
        of_a: Vector3<f64>,
        /// Direction in b.
        of_b: Vector3<f64>,
    },
    /// Angular velocities about an axis of a, seen from a, add up to zero: of b, and of one more body with a factor.
    Spin {
        /// Axis in a.
        about: Vector3<f64>,
        /// Another body with its factor.
        other: Option<(BodyIndex, f64)>,
        /// Rate of the sum [rad/s^2], as of a drive.
        rate: f64,
    },
}

/// A joint between two bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Name for messages.
    pub name: String,
    /// Its first body.
    pub a: BodyIndex,
    /// Its second body.
    pub b: BodyIndex,
    /// Its rows.
    pub rows: Vec<Row>,
}

/// Two directions at right angles to `axis` and to each other.
fn across(axis: Vector3<f64>) -> [Vector3<f64>; 2] {
    let smallest = axis.iamin();
    let first = axis.cross(&Vector3::ith(smallest, 1.0)).normalize();
    [first, axis.cross(&first).normalize()]
}

impl Joint {
    fn new(name: &str, a: BodyIndex, b: BodyIndex, rows: Vec<Row>) -> Joint {
        Joint { name: name.to_owned(), a, b, rows }
    }

    /// A hinge: the points coincide, the axes, given in each body, stay parallel.
    pub fn revolute(
        name: &str,
        a: BodyIndex,
        b: BodyIndex,
        points: [Vector3<f64>; 2],
        axes: [Vector3<f64>; 2],
    ) -> Joint {
        let mut joint = Joint::spherical(name, a, b, points);
        joint.rows.extend(across(axes[0]).map(|of_a| Row::Turn { of_a, of_b: axes[1] }));
        joint
    }

    /// A ball: the points coincide.
    pub fn spherical(name: &str, a: BodyIndex, b: BodyIndex, [on_a, on_b]: [Vector3<f64>; 2]) -> Joint {
        let along = [Vector3::x(), Vector3::y(), Vector3::z()];
        Joint::new(name, a, b, along.map(|along| Row::Point { along, on_a, on_b }).to_vec())
    }

    /// A slide along `axis` of a: b does not turn in a, whose axes it has, and its point stays on the line.
    pub fn prismatic(
        name: &str,
        a: BodyIndex,
        b: BodyIndex,
        points: [Vector3<f64>; 2],
        axis: Vector3<f64>,
    ) -> Joint {
        let mut joint = Joint::point_in_line(name, a, b, points, axis);
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        joint.rows.extend([(x, y), (y, z), (z, x)].map(|(of_a, of_b)| Row::Turn { of_a, of_b }));
        joint
    }

    /// A point of b on a line of a.
    pub fn point_in_line(
        name: &str,
        a: BodyIndex,
        b: BodyIndex,
        [on_a, on_b]: [Vector3<f64>; 2],
        line: Vector3<f64>,
    ) -> Joint {
        Joint::new(name, a, b, across(line).map(|along| Row::Point { along, on_a, on_b }).to_vec())
    }

    /// A point of b in a plane of a.
    pub fn point_in_plane(
        name: &str,
        a: BodyIndex,
        b: BodyIndex,
        [on_a, on_b]: [Vector3<f64>; 2],
        normal: Vector3<f64>,
    ) -> Joint {
        Joint::new(name, a, b, vec![Row::Point { along: normal, on_a, on_b }])
    }

    /// A gear in the housing a: b turns `ratio` times as fast about `axis` of a as `driver`.
    pub fn gear(
        name: &str,
        a: BodyIndex,
        b: BodyIndex,
        driver: BodyIndex,
        axis: Vector3<f64>,
        ratio: f64,
    ) -> Joint {
        Joint::new(name, a, b, vec![Row::Spin { about: axis, other: Some((driver, -ratio)), rate: 0.0 }])
    }

    /// A drive: the angular acceleration of b in a about `axis` of a is given.
    pub fn drive(name: &str, a: BodyIndex, b: BodyIndex, axis: Vector3<f64>, rate: f64) -> Joint {
        Joint::new(name, a, b, vec![Row::Spin { about: axis, other: None, rate }])
    }
}

/// A force and a moment on a body, axes of the frame, moment about the body's reference point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyLoad {
    /// On which body.
    pub body: BodyIndex,
    /// Force [N].
    pub force: Vector3<f64>,
    /// Moment [N m].
    pub moment: Vector3<f64>,
}

/// A spring between points of two bodies along the line that joins them.
#[derive(Debug, Clone, PartialEq)]
pub struct LineSpring {
    /// Its bodies.
    pub bodies: [BodyIndex; 2],
    /// Its points in them [m].
    pub points: [Vector3<f64>; 2],
    /// Stiffness [N/m].
    pub stiffness: f64,
    /// Length without load [m].
    pub length: f64,
}

/// Bodies and what joins them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Assembly {
    /// Its bodies.
    pub bodies: Vec<RigidBody>,
    /// Its joints.
    pub joints: Vec<Joint>,
    /// Its springs.
    pub springs: Vec<LineSpring>,
    /// Acceleration of gravity [m/s^2].
    pub gravity: Vector3<f64>,
}

/// Accelerations and reactions.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Of every body: of its reference point [m/s^2], angular [rad/s^2].
    pub accelerations: Vec<[Vector3<f64>; 2]>,
    /// Of every joint on its body b: force [N] and moment about the reference point of b [N m]. On body a acts the opposite, at the same points.
    pub on_b: Vec<[Vector3<f64>; 2]>,
    /// Of every joint on its body a, about the reference point of a.
    pub on_a: Vec<[Vector3<f64>; 2]>,
}

/// What one row says of two or three bodies.
struct RowTerms {
    /// Body, factors of its velocity and of its angular velocity.
    terms: Vec<(BodyIndex, Vector3<f64>, Vector3<f64>)>,
    /// `- J' nu`.
    gamma: f64,
    /// `g`; 0 for a spin row.
    gap: f64,
}

const REST: Pose = Pose {
    position: Vector3::new(0.0, 0.0, 0.0),
    rotation: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
    velocity: Vector3::new(0.0, 0.0, 0.0),
    spin: Vector3::new(0.0, 0.0, 0.0),
};

fn pose(poses: &[Pose], body: BodyIndex) -> Pose {
    poses.get(body).copied().unwrap_or(REST)
}

fn terms(joint: &Joint, row: &Row, poses: &[Pose]) -> RowTerms {
    let (a, b) = (pose(poses, joint.a), pose(poses, joint.b));
    let zero = Vector3::zeros();
    match row {
        Row::Point { along, on_a, on_b } => {
            let n = a.rotation * along;
            let [ra, rb] = [a.rotation * on_a, b.rotation * on_b];
            let apart = b.position + rb - a.position - ra;
            let rate = b.velocity + b.spin.cross(&rb) - a.velocity - a.spin.cross(&ra);
            let turned = a.spin.cross(&n);
            let centripetal = b.spin.cross(&b.spin.cross(&rb)) - a.spin.cross(&a.spin.cross(&ra));
            let gamma = -n.dot(&centripetal) - 2.0 * turned.dot(&rate) - a.spin.cross(&turned).dot(&apart);
            // n . (omega_a x r_a) and (omega_a x n) . apart together: - omega_a . ((r_a + apart) x n).
            let terms = vec![(joint.a, -n, -(ra + apart).cross(&n)), (joint.b, n, rb.cross(&n))];
            RowTerms { terms, gamma, gap: n.dot(&apart) }
        }
        Row::Turn { of_a, of_b } => {
            let (n, m) = (a.rotation * of_a, b.rotation * of_b);
            let c = m.cross(&n);
            let bend = n.dot(&b.spin.cross(&b.spin.cross(&m)))
                + 2.0 * a.spin.cross(&n).dot(&b.spin.cross(&m))
                + a.spin.cross(&a.spin.cross(&n)).dot(&m);
            RowTerms { terms: vec![(joint.a, zero, -c), (joint.b, zero, c)], gamma: -bend, gap: n.dot(&m) }
        }
        Row::Spin { about, other, rate } => {
            let n = a.rotation * about;
            let turned = a.spin.cross(&n);
            let mut terms = vec![(joint.b, zero, n)];
            let mut of_a = -1.0;
            let mut seen = b.spin - a.spin;
            if let Some((other, factor)) = *other {
                terms.push((other, zero, factor * n));
                of_a -= factor;
                seen += factor * (pose(poses, other).spin - a.spin);
            }
            terms.push((joint.a, zero, of_a * n));
            RowTerms { terms, gamma: rate - turned.dot(&seen), gap: 0.0 }
        }
    }
}

impl Assembly {
    /// Adds a body and returns its index.
    pub fn add(&mut self, body: RigidBody) -> BodyIndex {
        self.bodies.push(body);
        self.bodies.len() - 1
    }

    fn rows(&self, poses: &[Pose]) -> Vec<RowTerms> {
        let of = |joint: &Joint| joint.rows.iter().map(|row| terms(joint, row, poses)).collect::<Vec<_>>();
        self.joints.iter().flat_map(of).collect()
    }

    /// `J`.
    fn jacobian(&self, rows: &[RowTerms]) -> DMatrix<f64> {
        let mut jacobian = DMatrix::zeros(rows.len(), 6 * self.bodies.len());
        for (r, row) in rows.iter().enumerate() {
            for (body, linear, angular) in row.terms.iter().filter(|term| term.0 != GROUND) {
                for k in 0..3 {
                    jacobian[(r, 6 * body + k)] += linear[k];
                    jacobian[(r, 6 * body + 3 + k)] += angular[k];
                }
            }
        }
        jacobian
    }

    /// Largest `g` of all rows: lengths [m] and cosines alike.
    pub fn largest_gap(&self, poses: &[Pose]) -> f64 {
        self.rows(poses).iter().map(|row| row.gap.abs()).fold(0.0, f64::max)
    }

    /// Mass matrix, and loads less what inertia takes by itself.
    fn dynamics(&self, poses: &[Pose], loads: &[BodyLoad]) -> (DMatrix<f64>, DVector<f64>) {
        let size = 6 * self.bodies.len();
        let (mut mass, mut rhs) = (DMatrix::zeros(size, size), DVector::zeros(size));
        for (index, (body, pose)) in self.bodies.iter().zip(poses).enumerate() {
            let at = 6 * index;
            let first = pose.rotation * body.first_moment;
            let inertia = pose.rotation * body.inertia * pose.rotation.transpose();
            let cross = first.cross_matrix();
            for i in 0..3 {
                mass[(at + i, at + i)] = body.mass;
                for j in 0..3 {
                    mass[(at + i, at + 3 + j)] = -cross[(i, j)];
                    mass[(at + 3 + i, at + j)] = cross[(i, j)];
                    mass[(at + 3 + i, at + 3 + j)] = inertia[(i, j)];
                }
            }
            let force = body.mass * self.gravity - pose.spin.cross(&pose.spin.cross(&first));
            let moment = first.cross(&self.gravity) - pose.spin.cross(&(inertia * pose.spin));
            for k in 0..3 {
                rhs[at + k] += force[k];
                rhs[at + 3 + k] += moment[k];
            }
        }
        let springs = self.springs.iter().flat_map(|spring| spring.loads(poses));
        for load in loads.iter().copied().chain(springs).filter(|load| load.body != GROUND) {
            for k in 0..3 {
                rhs[6 * load.body + k] += load.force[k];
                rhs[6 * load.body + 3 + k] += load.moment[k];
            }
        }
        (mass, rhs)
    }

    /// Accelerations and reactions at these poses under `loads`; `None` where joints contradict or repeat one another.
    pub fn solve(&self, poses: &[Pose], loads: &[BodyLoad]) -> Option<Answer> {
        let rows = self.rows(poses);
        let jacobian = self.jacobian(&rows);
        let (mass, rhs) = self.dynamics(poses, loads);
        let (size, count) = (mass.nrows(), rows.len());
        let mut system = DMatrix::zeros(size + count, size + count);
        system.view_mut((0, 0), (size, size)).copy_from(&mass);
        system.view_mut((size, 0), (count, size)).copy_from(&jacobian);
        system.view_mut((0, size), (size, count)).copy_from(&jacobian.transpose());
        let mut right = DVector::zeros(size + count);
        right.rows_mut(0, size).copy_from(&rhs);
        for (r, row) in rows.iter().enumerate() {
            right[size + r] = row.gamma;
        }
        let factors = system.clone().lu();
        let mut answer = factors.solve(&right)?;
        // One step of refinement: the system mixes metres with radians.
        let residual = right - system * &answer;
        answer += factors.solve(&residual)?;
        if answer.iter().any(|value| !value.is_finite()) {
            return None;
        }
        let three = |at: usize| Vector3::new(answer[at], answer[at + 1], answer[at + 2]);
        let accelerations =
            (0..self.bodies.len()).map(|body| [three(6 * body), three(6 * body + 3)]).collect();
        let mut next = 0;
        let (mut on_a, mut on_b) = (Vec::new(), Vec::new());
        for joint in &self.joints {
            let mut sums = [[Vector3::zeros(); 2]; 2];
            for (k, row) in rows[next..next + joint.rows.len()].iter().enumerate() {
                let size = -answer[6 * self.bodies.len() + next + k];
                for (body, linear, angular) in &row.terms {
                    let side = if *body == joint.a { 0 } else { usize::from(*body == joint.b) };
                    if *body == joint.a || *body == joint.b {
                        sums[side][0] += size * linear;
                        sums[side][1] += size * angular;
                    }
                }
            }
            next += joint.rows.len();
            on_a.push(sums[0]);
            on_b.push(sums[1]);
        }
        Some(Answer { accelerations, on_b, on_a })
    }

    /// Sets the velocities that the joints leave no choice about: `given` says as many speeds (body, 0 to 5: velocity and spin) as there are freedoms.
    /// `None` where that does not determine them. Drives count as free here.
    pub fn set_velocities(&self, poses: &mut [Pose], given: &[(BodyIndex, usize, f64)]) -> Option<()> {
        let joints = self
            .joints
            .iter()
            .filter(|joint| !joint.rows.iter().any(|row| matches!(row, Row::Spin { other: None, .. })));
        let held = Assembly { joints: joints.cloned().collect(), ..self.clone() };
        let rows = held.rows(poses);
        let jacobian = held.jacobian(&rows);
        let size = 6 * self.bodies.len();
        if rows.len() + given.len() != size {
            return None;
        }
        let mut system = DMatrix::zeros(size, size);
        system.view_mut((0, 0), (rows.len(), size)).copy_from(&jacobian);
        let mut right = DVector::zeros(size);
        for (k, (body, component, value)) in given.iter().enumerate() {
            system[(rows.len() + k, 6 * body + component)] = 1.0;
            right[rows.len() + k] = *value;
        }
        let factors = system.clone().lu();
        let mut speeds = factors.solve(&right)?;
        let residual = right - system * &speeds;
        speeds += factors.solve(&residual)?;
        for (index, pose) in poses.iter_mut().enumerate() {
            pose.velocity = Vector3::new(speeds[6 * index], speeds[6 * index + 1], speeds[6 * index + 2]);
            pose.spin = Vector3::new(speeds[6 * index + 3], speeds[6 * index + 4], speeds[6 * index + 5]);
        }
        Some(())
    }

    /// Moves bodies by the least amount (in metres and radians) until all rows hold, then takes from the velocities what the rows forbid. `None` where
    /// that does not converge.
    pub fn project(&self, poses: &mut [Pose]) -> Option<()> {
        for _ in 0..12 {
            let rows = self.rows(poses);
            let gaps = DVector::from_iterator(rows.len(), rows.iter().map(|row| -row.gap));
            if gaps.amax() < 1e-15 {
                break;
            }
            let step = least_change(&self.jacobian(&rows), &gaps)?;
            for (index, pose) in poses.iter_mut().enumerate() {
                pose.position += Vector3::new(step[6 * index], step[6 * index + 1], step[6 * index + 2]);
                let turn = Vector3::new(step[6 * index + 3], step[6 * index + 4], step[6 * index + 5]);
                pose.rotation = Rotation3::new(turn).into_inner() * pose.rotation;
            }
        }
        let rows = self.rows(poses);
        let jacobian = self.jacobian(&rows);
        let speeds =
            poses.iter().flat_map(|p| p.velocity.iter().chain(p.spin.iter()).copied().collect::<Vec<_>>());
        let speeds = DVector::from_iterator(6 * poses.len(), speeds);
        let step = least_change(&jacobian, &(-&jacobian * speeds))?;
        for (index, pose) in poses.iter_mut().enumerate() {
            pose.velocity += Vector3::new(step[6 * index], step[6 * index + 1], step[6 * index + 2]);
            pose.spin += Vector3::new(step[6 * index + 3], step[6 * index + 4], step[6 * index + 5]);
        }
        (self.largest_gap(poses) < 1e-9).then_some(())
    }

    /// Number of components of [`Assembly::pack`].
    pub fn dimension(&self) -> usize {
        13 * self.bodies.len()
    }

    /// Poses as one state: position, quaternion `(w, x, y, z)`, velocity, spin of every body.
    pub fn pack(&self, poses: &[Pose]) -> Vec<f64> {
        let one = |pose: &Pose| {
            let q = UnitQuaternion::from_matrix(&pose.rotation);
            let (p, v, o) = (pose.position, pose.velocity, pose.spin);
            [p.x, p.y, p.z, q.w, q.i, q.j, q.k, v.x, v.y, v.z, o.x, o.y, o.z]
        };
        poses.iter().flat_map(one).collect()
    }

    /// The poses of a state.
    pub fn unpack(&self, state: &[f64]) -> Vec<Pose> {
        let one = |s: &[f64]| {
            let q = nalgebra::Quaternion::new(s[3], s[4], s[5], s[6]);
            Pose {
                position: Vector3::new(s[0], s[1], s[2]),
                rotation: UnitQuaternion::from_quaternion(q).to_rotation_matrix().into_inner(),
                velocity: Vector3::new(s[7], s[8], s[9]),
                spin: Vector3::new(s[10], s[11], s[12]),
            }
        };
        state.chunks_exact(13).map(one).collect()
    }

    /// Rate of a state under `loads`, no number where the joints are singular.
    pub fn rate(&self, state: &[f64], loads: &[BodyLoad], rate: &mut [f64]) {
        let poses = self.unpack(state);
        let Some(answer) = self.solve(&poses, loads) else {
            rate.fill(f64::NAN);
            return;
        };
        for (index, (pose, [linear, angular])) in poses.iter().zip(answer.accelerations).enumerate() {
            let own = &mut rate[13 * index..13 * index + 13];
            let q = &state[13 * index + 3..13 * index + 7];
            let q = nalgebra::Quaternion::new(q[0], q[1], q[2], q[3]);
            // The spin is in the axes of the frame: q' = (0, omega) q / 2.
            let turn = nalgebra::Quaternion::from_imag(pose.spin) * q * 0.5;
            own[..3].copy_from_slice(pose.velocity.as_slice());
            own[3..7].copy_from_slice(&[turn.w, turn.i, turn.j, turn.k]);
            own[7..10].copy_from_slice(linear.as_slice());
            own[10..].copy_from_slice(angular.as_slice());
        }
    }
}

impl LineSpring {
    fn loads(&self, poses: &[Pose]) -> [BodyLoad; 2] {
        let [a, b] = self.bodies.map(|body| pose(poses, body));
        let [ra, rb] = [a.rotation * self.points[0], b.rotation * self.points[1]];
        let line = b.position + rb - a.position - ra;
        let length = line.norm();
        // Pulls a towards b where it is longer than without load.
        let force = self.stiffness * (1.0 - self.length / length) * line;
        [
            BodyLoad { body: self.bodies[0], force, moment: ra.cross(&force) },
            BodyLoad { body: self.bodies[1], force: -force, moment: rb.cross(&-force) },
        ]
    }
}

/// The smallest `x` with `jacobian x = right`.
fn least_change(jacobian: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    let normal = jacobian * jacobian.transpose();
    Some(jacobian.transpose() * normal.lu().solve(right)?)
}
