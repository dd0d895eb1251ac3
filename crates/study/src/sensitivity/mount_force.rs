//! Forces of the block on its mounts, with the derivative by one input (book, eq. 32.9).
//!
//! ```text
//! ( SUM k_j b_j b_j^T - w^2 M ) Q = F        k_j = k (1 + i eta) + i w c along a direction a of a mount
//! force on a mount = SUM k_j (b_j.Q) a       b_j = ( a, rho x a ),  rho: mount from the centre
//! ```

use super::over_time::known;
use super::quantity::{Axis, Direction, Quantity};
use super::slope::Grown;
use super::stretch::Stretch;
use super::train::Train;
use super::wave::Load;
use lanchester_model::{Block, Mount, MountPoint, MountSpring, MovingParts};
use lanchester_task::Varied;
use num_complex::Complex;
use num_dual::{Dual64, DualNum};
use std::f64::consts::TAU;

/// Highest order of mount forces.
pub(super) const MOUNT_ORDERS: u32 = 8;
/// Angles of a revolution over which places of pistons and rods are averaged.
const ANGLES: usize = 360;

type DualComplex = Complex<Dual64>;
type Triple = [Dual64; 3];

/// Forces on all mounts by order, as complex amplitudes.
pub(super) struct MountForces {
    orders: Vec<(f64, Vec<[DualComplex; 3]>)>,
}

/// The block with what is added to it.
struct Body {
    mass: Dual64,
    centre: Triple,
    inertia: [Triple; 3],
}

/// A direction of a mount.
struct Spring {
    axis: Triple,
    /// Displacement along it by a motion of the block.
    along: [Dual64; 6],
    /// Stiffness at the frequency.
    stiffness: DualComplex,
    mount: usize,
}

impl MountForces {
    /// Those of `orders`.
    pub fn of(train: &Train<'_>, stretches: &[Stretch], orders: &[f64]) -> MountForces {
        let Some(block) = &train.engine.block else { return MountForces { orders: Vec::new() } };
        let body = Body::of(train, block);
        let loads = sampled(train, stretches);
        let orders = orders.iter().map(|&order| {
            let load = about(&amplitudes(&loads, order, train.prepared.period), &body.centre);
            (order, forces(train, &body, order, &load))
        });
        MountForces { orders: orders.collect() }
    }

    /// Force on a mount at one angle [N].
    pub fn at(&self, mount: usize, theta: Dual64) -> Load {
        let mut sum = [known(0.0); 3];
        for (order, forces) in &self.orders {
            let (sin, cos) = ((theta * *order).sin(), (theta * *order).cos());
            sum = [0, 1, 2].map(|k| sum[k] + forces[mount][k].re * cos - forces[mount][k].im * sin);
        }
        sum
    }

    /// Largest size over the cycle of the only order: the major half axis of its ellipse (book, eq. 27.11).
    pub fn order(&self, mount: usize, nothing: f64) -> (f64, Grown) {
        let Some((_, forces)) = self.orders.first() else { return (0.0, Grown::NONE) };
        let force = &forces[mount];
        let square = force.iter().map(|f| f.re * f.re + f.im * f.im).sum::<Dual64>();
        let round: [Dual64; 2] = [
            force.iter().map(|f| f.re * f.re - f.im * f.im).sum(),
            force.iter().map(|f| f.re * f.im * 2.0).sum(),
        ];
        let value = (0.5 * (square.re + round[0].re.hypot(round[1].re))).sqrt();
        if value <= nothing {
            let growth = force.iter().map(|f| f.re.eps.powi(2) + f.im.eps.powi(2)).sum::<f64>();
            let other = force.iter().fold(Complex::new(0.0, 0.0), |sum: Complex<f64>, f| {
                let own = Complex::new(f.re.eps, f.im.eps);
                sum + own * own
            });
            let grown = (0.5 * (growth + other.norm())).sqrt();
            return (value, Grown::of_size(&[Dual64::new(0.0, grown)], 0.0));
        }
        let grown = Grown::of_number(square).plus(Grown::of_size(&round, 1e-12 * square.re));
        (value, grown.times(0.25 / value))
    }
}

/// Orders that mount forces consist of, up to the highest: those that have whole cycles in the period.
pub(super) fn mount_orders(period: f64) -> Vec<f64> {
    let revolutions = (period / TAU).round();
    (1..=MOUNT_ORDERS * revolutions as u32).map(|k| f64::from(k) / revolutions).collect()
}

/// Loads on the block at all points of a quadrature: angle, weight, and force along x and y, couple about x and y, roll moment.
fn sampled(train: &Train<'_>, stretches: &[Stretch]) -> Vec<(Dual64, Dual64, [Dual64; 5])> {
    let mut all = Vec::new();
    for stretch in stretches {
        for (theta, weight) in stretch.cuts.windows(2).flat_map(|pair| stretch.points(pair[0], pair[1])) {
            let rods = train.rods(theta);
            let loads = train.loads_of(theta, &rods);
            let roll = loads.roll - train.gas_torque_of(&rods, theta, &stretch.windows);
            let [[fx, fy], [mx, my]] = [loads.force, loads.couple];
            all.push((theta, weight, [fx, fy, mx, my, roll]));
        }
    }
    all
}

/// Complex amplitudes of an order of the loads about the origin: force, moment.
fn amplitudes(all: &[(Dual64, Dual64, [Dual64; 5])], order: f64, period: f64) -> [DualComplex; 6] {
    let zero = Complex::new(known(0.0), known(0.0));
    let mut sum = [zero; 5];
    for (theta, weight, loads) in all {
        let wave = [(*theta * order).cos() * *weight, (*theta * order).sin() * *weight];
        for (sum, load) in sum.iter_mut().zip(loads) {
            sum.re += *load * wave[0];
            sum.im -= *load * wave[1];
        }
    }
    let [fx, fy, mx, my, mz] = sum.map(|c| Complex::new(c.re * (2.0 / period), c.im * (2.0 / period)));
    [fx, fy, zero, mx, my, mz]
}

/// The same about the centre of the block: `M - c x F`.
fn about(load: &[DualComplex; 6], centre: &Triple) -> [DualComplex; 6] {
    let [fx, fy, fz, mx, my, mz] = *load;
    let [x, y, z] = centre.map(|c| Complex::new(c, known(0.0)));
    [fx, fy, fz, mx - (y * fz - z * fy), my - (z * fx - x * fz), mz - (x * fy - y * fx)]
}

impl Body {
    fn of(train: &Train<'_>, block: &Block) -> Body {
        let axis = |of: fn(Axis) -> Quantity, values: [f64; 3]| {
            Axis::ALL.map(|axis| train.of(of(axis), 0, values[axis.index()]))
        };
        let own = axis(Quantity::BlockCentre, block.centre);
        let [xx, yy, zz] = axis(Quantity::BlockInertia, block.inertia);
        let [xy, yz, zx] = axis(Quantity::BlockProduct, block.products);
        let mass = train.of(Quantity::BlockMass, 0, block.mass);
        let half = (xx + yy + zz) * 0.5;
        // Second moments SUM r r^T dm about the origin.
        let about_own = [[half - xx, xy, zx], [xy, half - yy, yz], [zx, yz, half - zz]];
        let mut first = own.map(|c| c * mass);
        let mut second = [0, 1, 2].map(|i| [0, 1, 2].map(|j| about_own[i][j] + own[i] * own[j] * mass));
        let mut total = mass;
        if block.moving_parts == MovingParts::Added {
            for (mass, place) in moving_parts(train) {
                total += mass;
                first = [0, 1, 2].map(|i| first[i] + place[i] * mass);
                second = [0, 1, 2].map(|i| [0, 1, 2].map(|j| second[i][j] + place[i] * place[j] * mass));
            }
        }
        let centre = first.map(|c| c / total);
        let about = [0, 1, 2].map(|i| [0, 1, 2].map(|j| second[i][j] - centre[i] * centre[j] * total));
        let trace = about[0][0] + about[1][1] + about[2][2];
        let inertia =
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { trace - about[i][j] } else { -about[i][j] }));
        Body { mass: total, centre, inertia }
    }

    /// Element of its mass matrix.
    fn mass_at(&self, i: usize, j: usize) -> Dual64 {
        match (i < 3, j < 3) {
            (true, true) if i == j => self.mass,
            (false, false) => self.inertia[i - 3][j - 3],
            _ => known(0.0),
        }
    }
}

/// Pistons and rods as point masses at all angles of a revolution of their crankshaft, each with its share.
fn moving_parts(train: &Train<'_>) -> Vec<(Dual64, Triple)> {
    let mut all = Vec::new();
    for (index, cylinder) in train.engine.cylinders.iter().enumerate() {
        let crank = &train.engine.crankshafts[train.engine.throws[cylinder.throw].crankshaft];
        let [big, small, _] = train.rod_masses(index);
        let upper = small + train.part(Varied::PistonMass, index, cylinder.piston_mass);
        let turn = TAU / crank.ratio.value().abs();
        for k in 0..ANGLES {
            let rod = train.rod(known(turn * k as f64 / ANGLES as f64), index);
            for (mass, [x, y]) in [(upper, rod.pin), (big, rod.big_end)] {
                all.push((mass / ANGLES as f64, [x.re, y.re, rod.z]));
            }
        }
    }
    all
}

/// The directions of all mounts, stiff as they are at an angular frequency.
fn springs(train: &Train<'_>, centre: &Triple, frequency: Dual64) -> Vec<Spring> {
    let of_mount = |(mount, own): (usize, &Mount)| -> Vec<Spring> {
        let Some(spring) = &own.spring else { return Vec::new() };
        let places = [own.x, own.y, own.z];
        let place = Axis::ALL.map(|axis| train.of(Quantity::MountPlace(axis), mount, places[axis.index()]));
        let [x, y, z] = [0, 1, 2].map(|k| place[k] - centre[k]);
        let stiffer = train.of(Quantity::MountStiffness, mount, 1.0);
        let lossy = train.of(Quantity::MountLossFactor, mount, 1.0);
        let damped = train.of(Quantity::MountDamping, mount, 1.0);
        let values = dynamic(spring, frequency, train.side.sign());
        let direction = |own: Direction| {
            let k = own.index();
            let axis = turned(train, mount, spring.axes[k]);
            let [a, b, c] = axis;
            let [storage, lost] = values[k];
            let stiffer = stiffer * train.of(Quantity::MountStiffnessAlong(own), mount, 1.0);
            Spring {
                axis,
                along: [a, b, c, y * c - z * b, z * a - x * c, x * b - y * a],
                stiffness: Complex::new(
                    storage * stiffer,
                    lost * stiffer * lossy + frequency * damped * spring.damping[k],
                ),
                mount,
            }
        };
        Direction::ALL.map(direction).into()
    };
    train.engine.mounts.iter().enumerate().flat_map(of_mount).collect()
}

/// A direction of a mount, with its derivative where the mount is turned about an axis of the frame.
fn turned(train: &Train<'_>, mount: usize, [a, b, c]: [f64; 3]) -> Triple {
    let [x, y, z] = Axis::ALL.map(|axis| train.of(Quantity::MountTurn(axis), mount, 0.0));
    [y * c - z * b + a, z * a - x * c + b, x * b - y * a + c]
}

/// Storage and loss stiffness along the directions of a mount; at a point of its table those of the line on the side that is looked at.
fn dynamic(spring: &MountSpring, frequency: Dual64, sign: f64) -> [[Dual64; 2]; 3] {
    let of = |point: &MountPoint, k: usize| [point.stiffness[k], point.stiffness[k] * point.loss_factor[k]];
    let table = &spring.table;
    let Some(last) = table.len().checked_sub(1) else {
        return [0, 1, 2].map(|k| {
            let stiffness = spring.stiffness[k];
            [known(stiffness), known(stiffness * spring.loss_factor[k])]
        });
    };
    let is_passed = |point: &&MountPoint| {
        let apart = frequency - point.angular_frequency;
        if apart.re.abs() > 1e-12 * frequency.re { apart.re > 0.0 } else { sign * apart.eps > 0.0 }
    };
    let after = table.iter().take_while(is_passed).count();
    if after == 0 || after > last {
        return [0, 1, 2].map(|k| of(&table[after.min(last)], k).map(known));
    }
    let [low, high] = [&table[after - 1], &table[after]];
    let share = (frequency - low.angular_frequency) / (high.angular_frequency - low.angular_frequency);
    [0, 1, 2].map(|k| {
        let [from, to] = [of(low, k), of(high, k)];
        [0, 1].map(|part| share * (to[part] - from[part]) + from[part])
    })
}

/// Forces on all mounts under a load of one order.
fn forces(train: &Train<'_>, body: &Body, order: f64, load: &[DualComplex; 6]) -> Vec<[DualComplex; 3]> {
    let zero = Complex::new(known(0.0), known(0.0));
    let frequency = train.speed * order;
    let springs = springs(train, &body.centre, frequency);
    let real = |value: Dual64| Complex::new(value, known(0.0));
    let mut rows = [[zero; 7]; 6];
    for (i, row) in rows.iter_mut().enumerate() {
        for (j, element) in row.iter_mut().take(6).enumerate() {
            let held = springs.iter().map(|s| s.stiffness * real(s.along[i] * s.along[j]));
            *element = held.fold(zero, |a, b| a + b) - real(frequency * frequency * body.mass_at(i, j));
        }
        row[6] = load[i];
    }
    let motion = solved(rows);
    let mut forces = vec![[zero; 3]; train.engine.mounts.len()];
    for spring in &springs {
        let yielding = (0..6).map(|i| motion[i] * real(spring.along[i])).fold(zero, |a, b| a + b);
        let force = spring.stiffness * yielding;
        for (sum, axis) in forces[spring.mount].iter_mut().zip(spring.axis) {
            *sum += force * real(axis);
        }
    }
    forces
}

/// Solution of six linear equations, their right sides last, by elimination with the largest pivot of each column.
fn solved(mut rows: [[DualComplex; 7]; 6]) -> [DualComplex; 6] {
    let size = |c: &DualComplex| c.re.re.hypot(c.im.re);
    for k in 0..6 {
        let larger = |best: usize, i: usize| if size(&rows[i][k]) > size(&rows[best][k]) { i } else { best };
        let pivot = (k + 1..6).fold(k, larger);
        rows.swap(pivot, k);
        let above = rows[k];
        for row in rows.iter_mut().skip(k + 1) {
            let factor = row[k] / above[k];
            for (value, above) in row.iter_mut().zip(above).skip(k) {
                *value -= factor * above;
            }
        }
    }
    let mut motion = [Complex::new(known(0.0), known(0.0)); 6];
    for k in (0..6).rev() {
        let others = (k + 1..6).map(|j| rows[k][j] * motion[j]);
        motion[k] = others.fold(rows[k][6], |sum, other| sum - other) / rows[k][k];
    }
    motion
}
