//! The weights that a search may move, and the directions in which it moves them.

use crate::answer::Answer;
use lanchester_model::Engine;
use lanchester_numerics::SymmetricEigen;
use lanchester_task::{Phase, Place, Seat, Tie};
use num_complex::Complex64;

/// Share of the largest eigenvalue below which a direction leaves the loads on the block as they are.
const NEUTRAL: f64 = 1e-12;

/// Share of an amount by which it may pass its bounds: rounding.
const ROUNDING: f64 = 1e-9;

/// A real number that moves a weight.
#[derive(Debug, Clone, Copy)]
struct Part {
    weight: usize,
    direction: Complex64,
}

/// Bounds of a weight.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    least: f64,
    most: f64,
    /// In this direction alone.
    direction: Option<Complex64>,
}

/// Unbalances `U = U_0 + B y`.
pub(super) struct Space {
    base: Vec<Complex64>,
    parts: Vec<Part>,
    followers: Vec<Tie>,
    bounds: Vec<Option<Bounds>>,
    /// Orthonormal directions over the parts, those that leave the block alone first.
    directions: Vec<Vec<f64>>,
    neutral: usize,
    unit: f64,
}

impl Space {
    /// That of an answer: weights of any amount in planes that are given, on crankshafts. `None` where there is none.
    pub fn new(engine: &Engine, answer: &Answer) -> Option<Space> {
        let task = &answer.task;
        let base: Vec<Complex64> = answer.weights.iter().map(|weight| weight.unbalance).collect();
        let follows = |weight: usize| task.ties.iter().any(|tie| tie.second == weight);
        let mut parts = Vec::new();
        let mut bounds = vec![None; base.len()];
        for (index, (free, found)) in task.weights.iter().zip(&answer.weights).enumerate() {
            let fits =
                answer.web_bounds.iter().find(|bound| bound.name == free.name).map(|bound| bound.bound);
            let most = free.most.unwrap_or(f64::INFINITY).min(fits.unwrap_or(f64::INFINITY));
            let direction = match free.phase {
                Phase::Direction(angle) => Some(Complex64::cis(angle)),
                Phase::Free | Phase::Line(_) => None,
            };
            let is_movable = matches!(free.seat, Seat::Crankshaft(_))
                && matches!(free.z, Place::At(_))
                && free.catalogue.is_none()
                && (found.used || !free.optional)
                && free.most != Some(free.least);
            if !is_movable {
                continue;
            }
            bounds[index] = Some(Bounds { least: free.least, most, direction });
            if follows(index) {
                continue;
            }
            match free.phase {
                Phase::Free => {
                    parts.push(Part { weight: index, direction: Complex64::ONE });
                    parts.push(Part { weight: index, direction: Complex64::I });
                }
                Phase::Line(angle) | Phase::Direction(angle) => {
                    parts.push(Part { weight: index, direction: Complex64::cis(angle) });
                }
            }
        }
        if parts.is_empty() {
            return None;
        }
        let unit = (0..engine.throws.len()).map(|throw| engine.rotating_unbalance(throw).abs());
        let unit = unit.chain(base.iter().map(|own| own.norm())).fold(0.0, f64::max);
        let mut space = Space {
            base,
            parts,
            followers: task.ties.clone(),
            bounds,
            directions: Vec::new(),
            neutral: 0,
            unit: if unit > 0.0 { unit } else { 1e-3 },
        };
        space.set_directions(answer)?;
        Some(space)
    }

    /// Eigenvectors of the map from parts to the sums of unbalance and of its moment on every crankshaft.
    fn set_directions(&mut self, answer: &Answer) -> Option<()> {
        let weights = &answer.task.weights;
        let length = answer.weights.iter().map(|weight| weight.z.abs()).fold(0.0, f64::max).max(1e-3);
        let mut crankshafts: Vec<usize> = weights
            .iter()
            .filter_map(|weight| match weight.seat {
                Seat::Crankshaft(crankshaft) => Some(crankshaft),
                Seat::Shaft(_) => None,
            })
            .collect();
        crankshafts.sort_unstable();
        crankshafts.dedup();
        let columns: Vec<Vec<f64>> = (0..self.parts.len())
            .map(|part| {
                let moves = self.moves(part);
                let mut column = Vec::with_capacity(4 * crankshafts.len());
                for crankshaft in &crankshafts {
                    let (mut sum, mut moment) = (Complex64::ZERO, Complex64::ZERO);
                    for (weight, own) in moves.iter().enumerate() {
                        if weights[weight].seat == Seat::Crankshaft(*crankshaft) {
                            sum += own;
                            moment += own * (answer.weights[weight].z / length);
                        }
                    }
                    column.extend([sum.re, sum.im, moment.re, moment.im]);
                }
                column
            })
            .collect();
        let n = columns.len();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let gram: Vec<f64> = (0..n * n).map(|entry| dot(&columns[entry / n], &columns[entry % n])).collect();
        let eigen = SymmetricEigen::new(n, gram)?;
        let largest = eigen.values.iter().copied().fold(0.0, f64::max);
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|a, b| eigen.values[*a].total_cmp(&eigen.values[*b]));
        self.neutral = order.iter().filter(|k| eigen.values[**k] <= NEUTRAL * largest).count();
        self.directions = order.iter().map(|k| eigen.vectors[k * n..(k + 1) * n].to_vec()).collect();
        Some(())
    }

    /// What one of one part does to all weights.
    fn moves(&self, part: usize) -> Vec<Complex64> {
        let Part { weight, direction } = self.parts[part];
        let mut moves = vec![Complex64::ZERO; self.base.len()];
        moves[weight] = direction;
        for tie in self.followers.iter().filter(|tie| tie.first == weight) {
            let leader = if tie.mirrored { direction.conj() } else { direction };
            moves[tie.second] = tie.factor * leader;
        }
        moves
    }

    /// The unbalances of the answer.
    pub fn base(&self) -> Vec<Complex64> {
        self.base.clone()
    }

    /// Directions, and how many of them leave the loads on the block as they are.
    pub fn directions(&self) -> [usize; 2] {
        [self.directions.len(), self.neutral]
    }

    /// The movable weights of another answer to a task with the same weights, the others as they are.
    pub fn adopt(&self, other: &Answer) -> Vec<Complex64> {
        let own = self.base.iter().zip(&self.bounds).zip(&other.weights);
        own.map(|((own, bounds), other)| if bounds.is_some() { other.unbalance } else { *own }).collect()
    }

    /// Unbalances moved by so many units along a combination of directions; `None` where a weight passes its bounds.
    pub fn moved(&self, from: &[Complex64], along: &[(usize, f64)]) -> Option<Vec<Complex64>> {
        let mut parts = vec![0.0; self.parts.len()];
        for (direction, amount) in along {
            for (part, share) in parts.iter_mut().zip(&self.directions[*direction]) {
                *part += amount * self.unit * share;
            }
        }
        let mut moved = from.to_vec();
        for (part, amount) in parts.into_iter().enumerate() {
            if amount != 0.0 {
                moved.iter_mut().zip(self.moves(part)).for_each(|(own, by)| *own += amount * by);
            }
        }
        let holds = |(own, bounds): (&Complex64, &Option<Bounds>)| {
            let Some(bounds) = bounds else { return true };
            let amount = own.norm();
            let room = ROUNDING * self.unit;
            amount <= bounds.most + room
                && amount + room >= bounds.least
                && bounds.direction.is_none_or(|direction| (own * direction.conj()).re >= -room)
        };
        moved.iter().zip(&self.bounds).all(holds).then_some(moved)
    }
}
