//! Which weighed piston and rod belongs into which cylinder.
//!
//! The first-order residual is linear in the masses, and each piston and each rod sits in one cylinder:
//!
//! ```text
//! R(p, q) = c + SUM over j of ( P_j piston[p(j)] + P_j small[q(j)] + B_j big[q(j)] )
//! J = |R|^2        R: force forward and backward, couple forward and backward over a lever, as eight numbers
//! ```
//! Rods of one kind and length take each other's places: a master rod and an articulated rod, or a fork and a blade, do not. The big end of
//! an articulated rod counts where it moves, at its knuckle pin.
//!
//! Pistons add one of n! vectors, rods one of n! where all are of one kind: the least `|R|` is the closest pair of two sets of points. Up to eight
//! cylinders both sets are gone through: rods sorted by the number that spreads most, and for each order of the
//! pistons only rods that lie within the best distance so far in this number. Nothing else is left out, so that the answer
//! is proved. Beyond eight cylinders, exchanges of two parts are repeated until none helps; the bound then comes from
//! the smallest and largest sums that each number can have (largest masses on largest factors).

use crate::scatter::error::ScatterError;
use lanchester_mechanism::{LoadRequest, Mechanism, Part, Selection};
use lanchester_model::{Cylinder, Engine, EngineParts, Fault, RodJoint};
use num_complex::Complex64;
use serde::Serialize;

/// Cylinders up to which all orders are gone through.
const MOST_PROVED: usize = 8;

/// Two forces and two couples as real numbers.
const WIDTH: usize = 8;
type Vector = [f64; WIDTH];

/// A rod on the scales.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct WeighedRod {
    /// Mass at its big end [kg].
    pub big_end_mass: f64,
    /// Mass at its small end [kg].
    pub small_end_mass: f64,
}

/// Parts on the bench, and the engine that they go into.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct AssignmentRequest {
    /// The engine; the masses of its own pistons and rods play no part.
    pub engine: Engine,
    /// Speed of crankshaft 1 [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// Masses of the pistons [kg], one a cylinder.
    pub pistons: Vec<f64>,
    /// Rods, one a cylinder.
    pub rods: Vec<WeighedRod>,
    /// A couple of 1 N m counts as much as a force of 1 N over this lever [m]; see [`standard_lever`].
    pub lever: f64,
}

/// Where the parts go.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Assignment {
    /// Number of the piston (from 1) of each cylinder.
    pub pistons: Vec<usize>,
    /// Number of the rod (from 1) of each cylinder.
    pub rods: Vec<usize>,
    /// Root of the sum of squares of first-order force, forward and backward, and of couple over the lever [N].
    pub residual: f64,
    /// Largest resultant of the first-order force [N].
    pub force: f64,
    /// Largest resultant of the first-order couple [N m].
    pub couple: f64,
    /// The residual with the parts as they were numbered [N].
    pub as_numbered: f64,
    /// No assignment leaves less than this [N]: equal to `residual` where `proved`.
    pub bound: f64,
    /// Whether all assignments are known to leave no less.
    pub proved: bool,
}

/// What a kilogram of each part adds to the residual, by cylinder, and what is there without them.
struct Task {
    constant: Vector,
    reciprocating: Vec<Vector>,
    big_end: Vec<Vector>,
    pistons: Vec<f64>,
    rods: Vec<WeighedRod>,
    /// By cylinder: the first one whose rod is of the same kind and length.
    kinds: Vec<usize>,
}

/// For each cylinder the first one whose rod could be put into it.
fn rod_kinds(engine: &Engine) -> Vec<usize> {
    let kind = |cylinder: &Cylinder| {
        let joint = match cylinder.rod.joint {
            RodJoint::Crankpin => 0,
            RodJoint::Fork => 1,
            RodJoint::Blade => 2,
            RodJoint::Articulated { .. } => 3,
        };
        // A master has eyes for the knuckle pins.
        let index = engine.cylinders.iter().position(|own| std::ptr::eq(own, cylinder));
        let riders = |own: &&Cylinder| matches!(own.rod.joint, RodJoint::Articulated { master, .. } if Some(master) == index);
        (joint, engine.cylinders.iter().filter(riders).count(), cylinder.rod.length)
    };
    let kinds: Vec<_> = engine.cylinders.iter().map(kind).collect();
    kinds.iter().map(|own| kinds.iter().position(|first| first == own).unwrap_or(0)).collect()
}

/// The lever where nobody gives one [m]: distance of the outer mounts along the crank; without them of the outer cylinders, or the stroke of
/// a single one.
pub fn standard_lever(engine: &Engine) -> f64 {
    let spread = |planes: &mut dyn Iterator<Item = f64>| {
        let (low, high) =
            planes.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
        if high > low { high - low } else { 0.0 }
    };
    let mounts = spread(&mut engine.mounts.iter().map(|mount| mount.z));
    let cylinders = spread(&mut engine.cylinders.iter().map(|cylinder| cylinder.z));
    let stroke = engine.throws.iter().map(|throw| 2.0 * throw.radius).fold(0.0, f64::max);
    [mounts, cylinders, stroke].into_iter().find(|lever| *lever > 0.0).unwrap_or(1.0)
}

/// The assignment with the least first-order residual.
///
/// # Errors
/// [`ScatterError`] where the numbers of parts do not fit, a mass is impossible, or the engine is not valid.
pub fn assign(request: &AssignmentRequest) -> Result<Assignment, ScatterError> {
    let task = Task::new(request)?;
    let count = task.pistons.len();
    let straight: Vec<usize> = (0..count).collect();
    let as_numbered = task.square(&straight, &straight).sqrt();
    let found = task.exchanged(straight.clone(), straight);
    let (pistons, rods) = if count <= MOST_PROVED { task.closest_pair(found) } else { found };
    let residual = task.residual(&pistons, &rods);
    let size = square(&residual).sqrt();
    let part = |k: usize| Complex64::new(residual[2 * k], residual[2 * k + 1]).norm();
    let proved = count <= MOST_PROVED;
    Ok(Assignment {
        residual: size,
        force: part(0) + part(1),
        couple: (part(2) + part(3)) * request.lever,
        as_numbered,
        bound: if proved { size } else { task.bound() },
        proved,
        pistons: pistons.iter().map(|p| p + 1).collect(),
        rods: rods.iter().map(|r| r + 1).collect(),
    })
}

fn square(v: &Vector) -> f64 {
    v.iter().map(|x| x * x).sum()
}

fn plus(sum: &mut Vector, mass: f64, v: &Vector) {
    for k in 0..WIDTH {
        sum[k] += mass * v[k];
    }
}

impl Task {
    fn new(request: &AssignmentRequest) -> Result<Task, ScatterError> {
        let cylinders = request.engine.cylinders.len();
        let fits = |part, got| match got == cylinders && got > 0 {
            true => Ok(()),
            false => Err(ScatterError::Parts { cylinders, part, got }),
        };
        fits("piston", request.pistons.len())?;
        fits("rod", request.rods.len())?;
        let ends = request.rods.iter().flat_map(|rod| [rod.big_end_mass, rod.small_end_mass]);
        if let Some(got) = request.pistons.iter().copied().chain(ends).find(|m| !(*m >= 0.0 && m.is_finite()))
        {
            return Err(ScatterError::Number {
                quantity: "mass [kg]",
                needed: "finite and not negative",
                got,
            });
        }
        if !(request.lever > 0.0 && request.lever.is_finite()) {
            let got = request.lever;
            return Err(ScatterError::Number { quantity: "lever [m]", needed: "positive and finite", got });
        }
        let load_request =
            LoadRequest { speed: request.speed, max_order: 1, samples: 1, ..LoadRequest::default() };
        let residual = |engine: &Engine, selection: Selection| -> Result<Vector, ScatterError> {
            let orders = Mechanism::of(engine, &load_request, selection)?.orders();
            let zero = Complex64::ZERO;
            let mut all = [zero; 4];
            // Geared crankshafts bring fractions: order 1 is looked for.
            if let Some(first) = orders.iter().find(|o| o.order == 1.0) {
                let lever = request.lever;
                all = [
                    first.force_forward,
                    first.force_backward,
                    first.couple_forward / lever,
                    first.couple_backward / lever,
                ];
            }
            Ok(std::array::from_fn(|k| if k % 2 == 0 { all[k / 2].re } else { all[k / 2].im }))
        };
        let massless = |parts: &mut EngineParts| {
            for cylinder in &mut parts.cylinders {
                cylinder.piston_mass = 0.0;
                cylinder.rod.big_end_mass = 0.0;
                cylinder.rod.small_end_mass = 0.0;
                cylinder.rod.inertia = None;
            }
        };
        let valid = |engine: Result<Engine, Vec<Fault>>| engine.expect("invariant: 0 and 1 kg are masses");
        let bare = valid(request.engine.with(massless));
        let constant = residual(&bare, Selection::All)?;
        let mut task = Task {
            constant,
            reciprocating: Vec::new(),
            big_end: Vec::new(),
            pistons: request.pistons.clone(),
            rods: request.rods.clone(),
            kinds: rod_kinds(&request.engine),
        };
        // The throws' own unbalance is among the rotating parts: what a kilogram adds is the difference.
        let without = residual(&bare, Selection::Part(Part::Rotating))?;
        for index in 0..cylinders {
            let piston = valid(bare.with(|parts| parts.cylinders[index].piston_mass = 1.0));
            task.reciprocating.push(residual(&piston, Selection::Part(Part::Reciprocating))?);
            let big_end = valid(bare.with(|parts| parts.cylinders[index].rod.big_end_mass = 1.0));
            let with = residual(&big_end, Selection::Part(Part::Rotating))?;
            // What a knuckle pin moves beside the crankpin is among the reciprocating parts; of other rods nothing is.
            let beside = residual(&big_end, Selection::Part(Part::Reciprocating))?;
            task.big_end.push(std::array::from_fn(|k| with[k] - without[k] + beside[k]));
        }
        Ok(task)
    }

    fn of_pistons(&self, order: &[usize]) -> Vector {
        let mut sum = [0.0; WIDTH];
        for (cylinder, &piston) in order.iter().enumerate() {
            plus(&mut sum, self.pistons[piston], &self.reciprocating[cylinder]);
        }
        sum
    }

    fn of_rods(&self, order: &[usize]) -> Vector {
        let mut sum = [0.0; WIDTH];
        for (cylinder, &rod) in order.iter().enumerate() {
            plus(&mut sum, self.rods[rod].small_end_mass, &self.reciprocating[cylinder]);
            plus(&mut sum, self.rods[rod].big_end_mass, &self.big_end[cylinder]);
        }
        sum
    }

    fn residual(&self, pistons: &[usize], rods: &[usize]) -> Vector {
        let mut sum = self.constant;
        plus(&mut sum, 1.0, &self.of_pistons(pistons));
        plus(&mut sum, 1.0, &self.of_rods(rods));
        sum
    }

    fn square(&self, pistons: &[usize], rods: &[usize]) -> f64 {
        square(&self.residual(pistons, rods))
    }

    /// Exchanges two pistons or two rods, the best exchange first, until none helps.
    fn exchanged(&self, mut pistons: Vec<usize>, mut rods: Vec<usize>) -> (Vec<usize>, Vec<usize>) {
        let count = pistons.len();
        let mut least = self.square(&pistons, &rods);
        loop {
            let mut best = None;
            for a in 0..count {
                for b in a + 1..count {
                    for of_rods in [false, true] {
                        if of_rods && self.kinds[a] != self.kinds[b] {
                            continue;
                        }
                        let order = if of_rods { &mut rods } else { &mut pistons };
                        order.swap(a, b);
                        let trial = self.square(&pistons, &rods);
                        let order = if of_rods { &mut rods } else { &mut pistons };
                        order.swap(a, b);
                        if trial < least {
                            (least, best) = (trial, Some((a, b, of_rods)));
                        }
                    }
                }
            }
            match best {
                Some((a, b, true)) => rods.swap(a, b),
                Some((a, b, false)) => pistons.swap(a, b),
                None => return (pistons, rods),
            }
        }
    }

    /// The closest pair of all orders of the pistons and all orders of the rods; `found` where no other is closer.
    fn closest_pair(&self, found: (Vec<usize>, Vec<usize>)) -> (Vec<usize>, Vec<usize>) {
        let orders = permutations(self.pistons.len());
        let mut least = self.square(&found.0, &found.1);
        let mut best = found;
        let fits = |order: &[usize]| order.iter().enumerate().all(|(a, &b)| self.kinds[a] == self.kinds[b]);
        let fitting = orders.iter().zip(0..).filter(|(order, _)| fits(order));
        let mut rods: Vec<(Vector, usize)> =
            fitting.map(|(order, place)| (self.of_rods(order), place)).collect();
        let spread = |k: usize| {
            let values = rods.iter().map(|r| r.0[k]);
            let (low, high) =
                values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
            high - low
        };
        let widest = (0..WIDTH).max_by(|&a, &b| spread(a).total_cmp(&spread(b))).unwrap_or(0);
        rods.sort_by(|a, b| a.0[widest].total_cmp(&b.0[widest]).then(a.1.cmp(&b.1)));
        for order in &orders {
            let mut rest = self.of_pistons(order);
            plus(&mut rest, 1.0, &self.constant);
            // Only rods within the best distance so far in this number can be closer.
            let reach = least.sqrt();
            let start = rods.partition_point(|rod| rod.0[widest] < -rest[widest] - reach);
            for (rod, place) in &rods[start..] {
                if rod[widest] > -rest[widest] + reach {
                    break;
                }
                let mut sum = rest;
                plus(&mut sum, 1.0, rod);
                let trial = square(&sum);
                if trial < least {
                    least = trial;
                    best = (order.clone(), orders[*place].clone());
                }
            }
        }
        best
    }

    /// What no assignment can go below: each of the eight numbers by itself, over all orders.
    fn bound(&self) -> f64 {
        let mut sum = 0.0;
        for k in 0..WIDTH {
            let factors = |v: &[Vector]| v.iter().map(|v| v[k]).collect::<Vec<_>>();
            let small: Vec<f64> = self.rods.iter().map(|rod| rod.small_end_mass).collect();
            let big: Vec<f64> = self.rods.iter().map(|rod| rod.big_end_mass).collect();
            let (reciprocating, big_end) = (factors(&self.reciprocating), factors(&self.big_end));
            let ranges = [
                extremes(&reciprocating, &self.pistons),
                extremes(&reciprocating, &small),
                extremes(&big_end, &big),
            ];
            let low = self.constant[k] + ranges.iter().map(|r| r[0]).sum::<f64>();
            let high = self.constant[k] + ranges.iter().map(|r| r[1]).sum::<f64>();
            let least = if low > 0.0 {
                low
            } else if high < 0.0 {
                high
            } else {
                0.0
            };
            sum += least * least;
        }
        sum.sqrt()
    }
}

/// Smallest and largest `SUM factor mass` over all orders of the masses: the rearrangement inequality.
fn extremes(factors: &[f64], masses: &[f64]) -> [f64; 2] {
    let (mut factors, mut masses) = (factors.to_vec(), masses.to_vec());
    factors.sort_by(f64::total_cmp);
    masses.sort_by(f64::total_cmp);
    let most = factors.iter().zip(&masses).map(|(f, m)| f * m).sum();
    let least = factors.iter().zip(masses.iter().rev()).map(|(f, m)| f * m).sum();
    [least, most]
}

/// All orders of `count` things, in the order of words.
fn permutations(count: usize) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new()];
    for _ in 0..count {
        all = all
            .into_iter()
            .flat_map(|start: Vec<usize>| {
                (0..count)
                    .filter(|k| !start.contains(k))
                    .map(|k| [&start[..], &[k]].concat())
                    .collect::<Vec<_>>()
            })
            .collect();
    }
    all
}
