//! Numbers of an engine that its graph needs before it runs: mean places of its moving parts, the block without them, dead centres.

use super::request::{EngineBlock, EngineDrive, EngineGraphError, EngineRequest};
use lanchester_model::{Engine, MovingParts, RodJoint};
use std::f64::consts::{PI, TAU};

/// Places of a revolution over which moments are averaged: exact to rounding for a smooth periodic function.
const PLACES: usize = 256;
/// Moments below this share of what they are summed from are rounding.
const ROUNDING: f64 = 1e-14;
/// Places of a turn that are looked at for the dead centre.
const LOOKS: usize = 500;

/// What is known of a cylinder.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct CylinderNumbers {
    /// Inertia of the rod about its centre [kg m^2].
    pub(crate) rod_inertia: f64,
    /// Place of that centre over the length, from the lower eye.
    pub(crate) rod_centre: f64,
    /// Area of the bore [m^2]; 0 where it is not known.
    pub(crate) area: f64,
    /// Crank angle from which its gas counts [rad].
    pub(crate) firing: Option<f64>,
}

/// Numbers of an engine.
#[derive(Debug, Clone, Default)]
pub(crate) struct Numbers {
    pub(crate) cylinders: Vec<CylinderNumbers>,
    /// Polar inertia of every crankshaft, then of every balance shaft [kg m^2].
    pub(crate) rotor_inertia: Vec<f64>,
    /// Mass of the block without what moves in it [kg].
    pub(crate) block_mass: f64,
    /// Its centre from the origin [m].
    pub(crate) block_centre: [f64; 3],
    /// Its inertia about that centre, without the polar inertia of the rotors [kg m^2].
    pub(crate) block_inertia: [[f64; 3]; 3],
    /// Displacement of that centre at the start, ground axes [m].
    pub(crate) block_place: [f64; 3],
    /// Velocity of that centre at the start, ground axes [m/s].
    pub(crate) block_velocity: [f64; 3],
    /// Direction of gravity.
    pub(crate) gravity: [f64; 3],
}

/// Place of piston and rod at one crank angle, from the axis of the crankshaft: `[x, y]` [m].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Linkage {
    pub(crate) lower_pin: [f64; 2],
    pub(crate) piston_pin: [f64; 2],
    pub(crate) travel: f64,
}

impl Numbers {
    pub(crate) fn new(engine: &Engine, request: &EngineRequest) -> Result<Numbers, EngineGraphError> {
        let mut numbers = Numbers {
            gravity: engine.block.as_ref().map_or([-1.0, 0.0, 0.0], |block| block.gravity),
            ..Numbers::default()
        };
        let given = |list: &[f64], index: usize| list.get(index).copied().unwrap_or(0.0);
        let crankshafts =
            (0..engine.crankshafts.len()).map(|index| given(&request.crankshaft_inertia, index));
        let shafts = (0..engine.geared_shafts().len()).map(|index| given(&request.shaft_inertia, index));
        numbers.rotor_inertia = crankshafts.chain(shafts).collect();
        let crank = numbers.rotor_inertia.first().copied().unwrap_or(0.0);
        let drives = request.drive == EngineDrive::Imposed;
        if crank < 0.0 || !crank.is_finite() || (crank == 0.0 && !drives) {
            return Err(EngineGraphError::NoInertia);
        }
        let count = engine.cylinders.len();
        if !request.pressures.is_empty() && request.pressures.len() != count {
            return Err(EngineGraphError::Pressures { needed: count, got: request.pressures.len() });
        }
        for index in 0..count {
            let cylinder = numbers.cylinder(engine, index);
            let has_gas = !request.pressures.is_empty() || request.gas_states.is_some();
            if has_gas && (cylinder.area == 0.0 || cylinder.firing.is_none()) {
                return Err(EngineGraphError::Chamber { cylinder: index + 1 });
            }
            numbers.cylinders.push(cylinder);
        }
        if !matches!(request.block, EngineBlock::Fixed | EngineBlock::Held) {
            numbers.block(engine, request)?;
        }
        Ok(numbers)
    }

    fn cylinder(&self, engine: &Engine, index: usize) -> CylinderNumbers {
        let cylinder = &engine.cylinders[index];
        let rod = &cylinder.rod;
        let centre = rod.centre_of_gravity();
        let two_masses =
            rod.big_end_mass * centre * centre + rod.small_end_mass * (rod.length - centre).powi(2);
        CylinderNumbers {
            rod_inertia: rod.inertia.unwrap_or(two_masses),
            rod_centre: centre / rod.length,
            area: cylinder.bore.map_or(0.0, |bore| PI * bore * bore / 4.0),
            firing: firing(engine, index),
        }
    }

    /// The block without pistons, rods and the polar inertia of its rotors, and how it starts.
    fn block(&mut self, engine: &Engine, request: &EngineRequest) -> Result<(), EngineGraphError> {
        let block = engine.block.as_ref().ok_or(EngineGraphError::NoBlock)?;
        let mut moments = Moments::default();
        let tensor = block.tensor();
        moments.add(block.mass, block.centre, tensor, 1.0);
        if block.moving_parts == MovingParts::Included {
            let turns = revolutions(engine);
            let places = PLACES * turns;
            for place in 0..places {
                let theta = TAU * turns as f64 * place as f64 / places as f64;
                for index in 0..engine.cylinders.len() {
                    self.take_out(engine, index, theta, -1.0 / places as f64, &mut moments);
                }
            }
        }
        let mass = moments.mass;
        // What rounding leaves of moments that cancel over the revolutions is none.
        let first = moments.first.iter().zip(moments.size);
        let first: Vec<f64> =
            first.map(|(own, size)| if own.abs() < ROUNDING * size { 0.0 } else { *own }).collect();
        let centre = [0, 1, 2].map(|k| first[k] / mass);
        let mut inertia = moments.second;
        let square: f64 = centre.iter().map(|c| c * c).sum();
        for i in 0..3 {
            for j in 0..3 {
                inertia[i][j] -= mass * (if i == j { square } else { 0.0 } - centre[i] * centre[j]);
            }
        }
        inertia[2][2] -= self.rotor_inertia.iter().sum::<f64>();
        // Products that rounding leaves are none.
        let size = inertia[0][0].abs() + inertia[1][1].abs() + inertia[2][2].abs();
        for i in 0..3 {
            for j in 0..3 {
                if i != j && inertia[i][j].abs() < ROUNDING * size {
                    inertia[i][j] = 0.0;
                }
            }
        }
        let least = minors(inertia).into_iter().fold(f64::INFINITY, f64::min);
        let good = mass > 0.0 && least > 0.0;
        if !good {
            return Err(EngineGraphError::BlockTooSmall { mass, inertia: least });
        }
        self.block_mass = mass;
        self.block_centre = centre;
        self.block_inertia = inertia;
        let turn = rotation(request.start.orientation);
        let start = &request.start;
        let turned = apply(turn, centre);
        let around = cross(start.spin, centre);
        let velocity = apply(turn, [0, 1, 2].map(|k| start.velocity[k] + around[k]));
        self.block_place = [0, 1, 2].map(|k| start.position[k] + turned[k] - centre[k]);
        self.block_velocity = velocity;
        Ok(())
    }

    /// Adds piston and rod of a cylinder at a crank angle with a weight.
    fn take_out(&self, engine: &Engine, index: usize, theta: f64, weight: f64, moments: &mut Moments) {
        let cylinder = &engine.cylinders[index];
        let shaft = &engine.crankshafts[engine.throws[cylinder.throw].crankshaft];
        let linkage = linkage(engine, index, theta);
        let (sin, cos) = cylinder.angle.sin_cos();
        let piston = [
            shaft.x + linkage.travel * cos - cylinder.offset * sin,
            shaft.y + linkage.travel * sin + cylinder.offset * cos,
            cylinder.z,
        ];
        moments.add(cylinder.piston_mass, piston, [[0.0; 3]; 3], weight);
        let own = &self.cylinders[index];
        let share = own.rod_centre;
        let rod = [0, 1].map(|k| linkage.piston_pin[k] - linkage.lower_pin[k]);
        let at = [0, 1].map(|k| linkage.lower_pin[k] + share * rod[k]);
        let along = rod.map(|component| component / cylinder.rod.length);
        let inertia = own.rod_inertia;
        let less = inertia - cylinder.rod.axial_inertia;
        let tensor = [
            [inertia - less * along[0] * along[0], -less * along[0] * along[1], 0.0],
            [-less * along[0] * along[1], inertia - less * along[1] * along[1], 0.0],
            [0.0, 0.0, inertia],
        ];
        moments.add(cylinder.rod.mass(), [shaft.x + at[0], shaft.y + at[1], cylinder.z], tensor, weight);
    }
}

/// Mass, first and second moments about the origin.
#[derive(Default)]
struct Moments {
    mass: f64,
    first: [f64; 3],
    /// What the first moments are summed from, without their signs.
    size: [f64; 3],
    second: [[f64; 3]; 3],
}

impl Moments {
    fn add(&mut self, mass: f64, at: [f64; 3], own: [[f64; 3]; 3], weight: f64) {
        let square: f64 = at.iter().map(|x| x * x).sum();
        self.mass += weight * mass;
        for i in 0..3 {
            self.first[i] += weight * mass * at[i];
            self.size[i] += (weight * mass * at[i]).abs();
            for j in 0..3 {
                let point = if i == j { square } else { 0.0 } - at[i] * at[j];
                self.second[i][j] += weight * (own[i][j] + mass * point);
            }
        }
    }
}

/// Piston and rod of a cylinder at a crank angle, closed by the cosine rule.
pub(crate) fn linkage(engine: &Engine, index: usize, theta: f64) -> Linkage {
    let cylinder = &engine.cylinders[index];
    let lower_pin = match cylinder.rod.joint {
        RodJoint::Crankpin | RodJoint::Fork | RodJoint::Blade => {
            let radius = engine.throws[cylinder.throw].radius;
            let (sin, cos) = engine.pin_angle(cylinder.throw, theta).sin_cos();
            [radius * cos, radius * sin]
        }
        RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
            let driver = linkage(engine, master, theta);
            let rod = [0, 1].map(|k| driver.piston_pin[k] - driver.lower_pin[k]);
            let turned = rod[1].atan2(rod[0]) + knuckle_angle;
            [
                driver.lower_pin[0] + knuckle_radius * turned.cos(),
                driver.lower_pin[1] + knuckle_radius * turned.sin(),
            ]
        }
    };
    let (sin, cos) = cylinder.angle.sin_cos();
    let offset = cylinder.net_offset();
    let forward = lower_pin[0] * cos + lower_pin[1] * sin;
    let across = offset - (lower_pin[1] * cos - lower_pin[0] * sin);
    let travel = forward + (cylinder.rod.length.powi(2) - across * across).sqrt();
    let piston_pin = [travel * cos - offset * sin, travel * sin + offset * cos];
    Linkage { lower_pin, piston_pin, travel }
}

/// Crank angle of the dead centre of its chamber next to the firing that the file gives; a lone chamber fires at 0.
fn firing(engine: &Engine, index: usize) -> Option<f64> {
    let pistons = engine.chamber_pistons(index);
    let lone = (pistons.len() == engine.cylinders.len()).then_some(0.0);
    let nominal = engine.cylinders[*pistons.first()?].firing_angle.or(lone)?;
    let first = &engine.cylinders[*pistons.first()?];
    let turn = TAU / engine.crankshafts[engine.throws[first.throw].crankshaft].ratio.value().abs();
    let filled = |theta: f64| -> f64 {
        pistons
            .iter()
            .map(|piston| {
                engine.cylinders[*piston].bore.map_or(1.0, |bore| bore * bore)
                    * linkage(engine, *piston, theta).travel
            })
            .sum()
    };
    // The dead centre is where chords of the filled volume are level: their slope changes sign there.
    let step = turn / LOOKS as f64;
    let best = (0..LOOKS).max_by(|a, b| filled(step * *a as f64).total_cmp(&filled(step * *b as f64)))?;
    let centre = step * best as f64;
    let rises = |theta: f64| slope(engine, &pistons, theta) > 0.0;
    let (mut low, mut high) = (centre - step, centre + step);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if rises(middle) { low = middle } else { high = middle }
    }
    let top = 0.5 * (low + high);
    Some(top + turn * ((nominal - top) / turn).round())
}

/// Travel of the piston pin of a cylinder at a crank angle [m].
pub(crate) fn travel(engine: &Engine, index: usize, theta: f64) -> f64 {
    linkage(engine, index, theta).travel
}

/// Travel of the piston pin at its top and bottom dead centre [m].
pub(crate) fn dead_centres(engine: &Engine, index: usize) -> [f64; 2] {
    let ratio = engine.crankshafts[engine.throws[engine.cylinders[index].throw].crankshaft].ratio.value();
    let step = TAU / ratio.abs() / LOOKS as f64;
    let extreme = |sign: f64| {
        let at = |theta: f64| sign * travel(engine, index, theta);
        let best =
            (0..LOOKS).max_by(|a, b| at(step * *a as f64).total_cmp(&at(step * *b as f64))).unwrap_or(0);
        let (mut low, mut high) = (step * (best as f64 - 1.0), step * (best as f64 + 1.0));
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if sign * rate(engine, index, middle).1 > 0.0 { low = middle } else { high = middle }
        }
        travel(engine, index, 0.5 * (low + high))
    };
    [extreme(1.0), extreme(-1.0)]
}

/// Slope of the volume that the pistons of a chamber fill, by the crank angle, times 4/pi.
fn slope(engine: &Engine, pistons: &[usize], theta: f64) -> f64 {
    pistons
        .iter()
        .map(|piston| {
            let cylinder = &engine.cylinders[*piston];
            cylinder.bore.map_or(1.0, |bore| bore * bore) * rate(engine, *piston, theta).1
        })
        .sum()
}

/// Rates by the crank angle of the lower pin and of the travel: the rod's velocity has no part along the rod.
pub(crate) fn rate(engine: &Engine, index: usize, theta: f64) -> ([f64; 2], f64) {
    let cylinder = &engine.cylinders[index];
    let linkage = linkage(engine, index, theta);
    let pin = match cylinder.rod.joint {
        RodJoint::Articulated { master, .. } => {
            let driver = self::linkage(engine, master, theta);
            let (lower, travel) = rate(engine, master, theta);
            let (sin, cos) = engine.cylinders[master].angle.sin_cos();
            let rod = [0, 1].map(|k| driver.piston_pin[k] - driver.lower_pin[k]);
            let moved = [travel * cos - lower[0], travel * sin - lower[1]];
            let square = rod[0] * rod[0] + rod[1] * rod[1];
            let turning = (rod[0] * moved[1] - rod[1] * moved[0]) / square;
            let knuckle = [0, 1].map(|k| linkage.lower_pin[k] - driver.lower_pin[k]);
            [lower[0] - turning * knuckle[1], lower[1] + turning * knuckle[0]]
        }
        _ => {
            let ratio = engine.crankshafts[engine.throws[cylinder.throw].crankshaft].ratio.value();
            [-ratio * linkage.lower_pin[1], ratio * linkage.lower_pin[0]]
        }
    };
    let rod = [0, 1].map(|k| linkage.piston_pin[k] - linkage.lower_pin[k]);
    let (sin, cos) = cylinder.angle.sin_cos();
    (pin, (rod[0] * pin[0] + rod[1] * pin[1]) / (rod[0] * cos + rod[1] * sin))
}

/// Revolutions after which all crankshafts stand as before; at most 64.
fn revolutions(engine: &Engine) -> usize {
    let whole = |turns: usize| {
        engine.crankshafts.iter().all(|shaft| {
            let turned = shaft.ratio.value() * turns as f64;
            (turned - turned.round()).abs() < 1e-9
        })
    };
    (1..=64).find(|turns| whole(*turns)).unwrap_or(64)
}

/// Revolutions of crankshaft 1 after which rotors, firings and these orders of a torque stand as before; at most 64.
pub(crate) fn period(engine: &Engine, torque: &[[f64; 3]]) -> usize {
    let is_whole = |turned: f64| (turned - turned.round()).abs() < 1e-9;
    let working = f64::from(engine.strokes.revolutions());
    let stands = |turns: usize| {
        let turns = turns as f64;
        engine.crankshafts.iter().all(|shaft| is_whole(shaft.ratio.value() * turns / working))
            && engine.geared_shafts().iter().all(|shaft| is_whole(shaft.ratio.value() * turns))
            && torque.iter().all(|[order, _, _]| is_whole(order * turns))
    };
    (1..=64).find(|turns| stands(*turns)).unwrap_or(64)
}

/// The leading principal minors, each by the one before: positive where the matrix is positive definite.
fn minors(m: [[f64; 3]; 3]) -> [f64; 3] {
    let second = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    [m[0][0], second / m[0][0], determinant(m) / second]
}

fn determinant(m: [[f64; 3]; 3]) -> f64 {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

/// Inverse of a symmetric matrix by its cofactors.
pub(crate) fn inverse(m: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let whole = determinant(m);
    let minor = |i: usize, j: usize| {
        let [a, b] = [(i + 1) % 3, (i + 2) % 3];
        let [c, d] = [(j + 1) % 3, (j + 2) % 3];
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| minor(j, i) / whole))
}

/// Matrix of a unit quaternion, real part first.
pub(crate) fn rotation([w, x, y, z]: [f64; 4]) -> [[f64; 3]; 3] {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

pub(crate) fn apply(m: [[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
