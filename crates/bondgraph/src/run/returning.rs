//! What of the state of a graph must return after a period, and how a start is moved.
//!
//! Displacements, angles and places are tied to one another: four mounts hold one block. They are therefore never set one by one but moved along
//! a motion that the graph allows, which keeps every tie exact:
//!
//! ```text
//! q' = f_q(q, p) - f_q(q, 0),   0 <= tau <= 1,   p held      moves q;  every other state is set by itself
//! ```
//! | symbol | name                                                                                      |
//! |--------|-------------------------------------------------------------------------------------------|
//! | q      | states whose rates are linear in momenta: places                                           |
//! | p      | momenta that leave the state still whose advance ends the period                           |
//! | f_q    | rates of q                                                                                 |
//!
//! States that hang on that state alone (the volume of a cylinder on the crank angle), or on the time alone, return of themselves or never:
//! they are left out. Which state is of which kind is measured at a few places near the start.

use crate::equations::Equations;
use crate::run::compiled::Compiled;
use lanchester_numerics::{Dop853, Function, Outcome, Settings, System};
use nalgebra::{DMatrix, DVector};
use std::ops::ControlFlow;

/// Differences below this share count as none.
const SAME: f64 = 1e-9;

/// Momenta move places by so much of what they would in one period.
const SHARE_OF_PERIOD: f64 = 0.1;

/// Directions of places with a smaller singular value, over the largest, are combinations of the others.
const COMBINATION: f64 = 1e-9;

/// Tolerance of a move of places.
const MOVE: f64 = 1e-13;

/// Components of a state that must return, each a share of its size.
#[derive(Debug)]
pub(crate) struct Returning {
    /// States that are set by themselves.
    pub(crate) own: Vec<usize>,
    /// States that move together.
    places: Vec<usize>,
    momenta: Vec<usize>,
    sizes: Vec<f64>,
    /// Momenta that move places, one column a direction.
    directions: DMatrix<f64>,
    /// From changes of places to the share of each direction.
    shares: DMatrix<f64>,
}

/// A state near the start by which kinds are told apart: what is changed is drawn the same way every time.
struct Places<'a> {
    compiled: &'a mut Compiled,
    start: &'a [f64],
    sizes: &'a [f64],
    seed: u64,
}

impl Places<'_> {
    /// From -1 to 1.
    fn draw(&mut self) -> f64 {
        self.seed = self.seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn rates(&mut self, t: f64, y: &[f64]) -> Vec<f64> {
        let mut rates = vec![0.0; y.len()];
        self.compiled.settle(t, y);
        self.compiled.derivative(t, y, &mut rates);
        rates
    }

    /// The start with the states that `moves` changed by a share of their sizes.
    fn beside(&mut self, share: f64, moves: &dyn Fn(usize) -> bool) -> Vec<f64> {
        let mut y = self.start.to_vec();
        for (index, value) in y.iter_mut().enumerate() {
            let drawn = self.draw();
            if moves(index) {
                *value += share * drawn * self.sizes[index];
            }
        }
        y
    }
}

impl Returning {
    /// Tells the states apart. `section`: the state whose advance by `by` ends the period, `None`: the time does; `kept`: states without rate that
    /// nothing set in a period.
    pub(crate) fn new(
        equations: &Equations,
        compiled: &mut Compiled,
        start: &[f64],
        sizes: &[f64],
        (section, by): (Option<usize>, f64),
        period: f64,
        kept: &[usize],
    ) -> Returning {
        let count = equations.states.len();
        let is_momentum =
            |index: usize| equations.states[index].symbol.ends_with(".momentum") && section != Some(index);
        let momenta: Vec<usize> = (0..count).filter(|index| is_momentum(*index)).collect();
        let mut near = Places { compiled, start, sizes, seed: 20 };
        let mut left_out: Vec<bool> =
            (0..count).map(|index| section == Some(index) || kept.contains(&index)).collect();
        let hangs_alone = near.hang_alone(section, by, period);
        for (index, alone) in hangs_alone.into_iter().enumerate() {
            // What has no rate is set by events alone.
            let is_set = equations.graph.pool.is_zero(equations.states[index].rate);
            left_out[index] |= alone && !is_momentum(index) && !is_set;
        }
        let candidates: Vec<usize> =
            (0..count).filter(|index| !left_out[*index] && !is_momentum(*index)).collect();
        let places = near.places(&candidates, &momenta, section);
        let own = (0..count).filter(|index| !left_out[*index] && !places.contains(index)).collect();
        let mut found = Returning {
            own,
            places,
            momenta,
            sizes: sizes.to_vec(),
            directions: DMatrix::zeros(0, 0),
            shares: DMatrix::zeros(0, 0),
        };
        found.directions(&mut near, section, period);
        found
    }

    /// Momenta that move the places each in its own way and leave the section still.
    fn directions(&mut self, near: &mut Places<'_>, section: Option<usize>, period: f64) {
        let (rows, columns) = (self.places.len(), self.momenta.len());
        self.directions = DMatrix::zeros(columns, 0);
        self.shares = DMatrix::zeros(0, rows);
        if rows == 0 || columns == 0 {
            return;
        }
        let mut still = near.start.to_vec();
        self.momenta.iter().for_each(|index| still[*index] = 0.0);
        let base = near.rates(0.0, &still);
        let scale: Vec<f64> =
            self.momenta.iter().map(|index| SHARE_OF_PERIOD * period * near.sizes[*index]).collect();
        let mut of_places = DMatrix::zeros(rows, columns);
        let mut of_section = DVector::zeros(columns);
        for (column, index) in self.momenta.iter().enumerate() {
            let mut moving = still.clone();
            moving[*index] = near.sizes[*index];
            let rates = near.rates(0.0, &moving);
            let time = SHARE_OF_PERIOD * period;
            for (row, place) in self.places.iter().enumerate() {
                of_places[(row, column)] = time * (rates[*place] - base[*place]);
            }
            of_section[column] = section.map_or(0.0, |section| time * (rates[section] - base[section]));
        }
        // Off the section: without the part along its own row.
        let norm = of_section.norm();
        if norm > 0.0 {
            let along = of_section / norm;
            let project = DMatrix::identity(columns, columns) - &along * along.transpose();
            of_places *= &project;
        }
        let weights: Vec<f64> = (0..rows)
            .map(|row| {
                let most = of_places.row(row).amax();
                if most > 0.0 { 1.0 / most } else { 1.0 }
            })
            .collect();
        let weighted = DMatrix::from_fn(rows, columns, |i, j| weights[i] * of_places[(i, j)]);
        let Some(parts) = weighted.try_svd(true, true, f64::EPSILON, 10_000) else { return };
        let (Some(u), Some(v)) = (parts.u, parts.v_t) else { return };
        let largest = parts.singular_values.max();
        let kept: Vec<usize> = (0..parts.singular_values.len())
            .filter(|k| parts.singular_values[*k] > COMBINATION * largest)
            .collect();
        self.directions = DMatrix::from_fn(columns, kept.len(), |i, k| scale[i] * v[(kept[k], i)]);
        self.shares = DMatrix::from_fn(kept.len(), rows, |k, i| {
            u[(i, kept[k])] * weights[i] / parts.singular_values[kept[k]]
        });
    }

    /// How many components there are.
    pub(crate) fn count(&self) -> usize {
        self.directions.ncols() + self.own.len()
    }

    /// Components of the change from one state to another.
    pub(crate) fn change(&self, from: &[f64], to: &[f64]) -> DVector<f64> {
        let moved = DVector::from_iterator(self.places.len(), self.places.iter().map(|i| to[*i] - from[*i]));
        let moved = &self.shares * moved;
        let own = self.own.iter().map(|index| (to[*index] - from[*index]) / self.sizes[*index]);
        DVector::from_iterator(self.count(), moved.iter().copied().chain(own))
    }

    /// A state moved by components; `None` where the places cannot be moved.
    pub(crate) fn moved(
        &self,
        compiled: &mut Compiled,
        state: &[f64],
        by: &DVector<f64>,
    ) -> Option<Vec<f64>> {
        let mut moved = state.to_vec();
        let directions = self.directions.ncols();
        if directions > 0 && by.rows(0, directions).amax() > 0.0 {
            let momenta = &self.directions * by.rows(0, directions);
            let mut with = state.to_vec();
            let mut without = state.to_vec();
            for (index, momentum) in self.momenta.iter().zip(momenta.iter()) {
                (with[*index], without[*index]) = (*momentum, 0.0);
            }
            compiled.settle(0.0, state);
            let (mut rates, mut base) = (vec![0.0; state.len()], vec![0.0; state.len()]);
            let mut system = Function::new(self.places.len(), |_t: f64, q: &[f64], dq: &mut [f64]| {
                for (index, place) in self.places.iter().zip(q) {
                    (with[*index], without[*index]) = (*place, *place);
                }
                compiled.derivative(0.0, &with, &mut rates);
                compiled.derivative(0.0, &without, &mut base);
                for (index, rate) in self.places.iter().zip(dq) {
                    *rate = rates[*index] - base[*index];
                }
            });
            let mut q: Vec<f64> = self.places.iter().map(|index| state[*index]).collect();
            let mut settings = Settings::uniform(q.len(), MOVE);
            settings.absolute =
                self.places.iter().map(|index| (MOVE * self.sizes[*index]).max(1e-200)).collect();
            settings.dense = false;
            let mut t = 0.0;
            let outcome =
                Dop853::new(settings).run(&mut system, &mut t, &mut q, 1.0, |_| ControlFlow::Continue(()));
            if outcome != Outcome::Reached {
                return None;
            }
            self.places.iter().zip(q).for_each(|(index, place)| moved[*index] = place);
        }
        for (k, index) in self.own.iter().enumerate() {
            moved[*index] += by[directions + k] * self.sizes[*index];
        }
        Some(moved)
    }

    /// The state that a component sets or moves most, for words about it.
    pub(crate) fn state_of(&self, component: usize) -> usize {
        match component.checked_sub(self.directions.ncols()) {
            Some(own) => self.own[own],
            None => {
                let column = self.directions.column(component);
                self.momenta[column.iamax()]
            }
        }
    }
}

impl Places<'_> {
    /// Which states hang on the section alone, or on the time alone where there is none.
    fn hang_alone(&mut self, section: Option<usize>, by: f64, period: f64) -> Vec<bool> {
        let count = self.start.len();
        let mut alone = vec![true; count];
        for share in [0.0, 0.03, 0.31] {
            let (mut reference, t) = (self.start.to_vec(), share * period);
            if let Some(section) = section {
                reference[section] += share * by;
            }
            let at = if section.is_some() { 0.0 } else { t };
            let slopes = |own: &mut Places<'_>, y: &[f64]| -> Vec<f64> {
                let rates = own.rates(at, y);
                let unit = section.map_or(1.0, |section| rates[section]);
                rates.into_iter().map(|rate| rate / unit).collect()
            };
            let first = slopes(self, &reference);
            for _ in 0..3 {
                let mut y = self.beside(0.05, &|index| Some(index) != section);
                if let Some(section) = section {
                    y[section] = reference[section];
                }
                let other = slopes(self, &y);
                for index in 0..count {
                    let size = first[index].abs().max(other[index].abs());
                    alone[index] &= (first[index] - other[index]).abs() <= SAME * size;
                }
            }
        }
        alone
    }

    /// Which candidates move with momenta, linearly, and with them alone but for the section.
    fn places(&mut self, candidates: &[usize], momenta: &[usize], section: Option<usize>) -> Vec<usize> {
        let is_momentum = |index: usize| momenta.contains(&index);
        let mut is_place = vec![true; candidates.len()];
        let mut moves = vec![false; candidates.len()];
        for _ in 0..3 {
            let q = self.beside(0.05, &|index| !is_momentum(index) && Some(index) != section);
            let drawn: Vec<Vec<f64>> = (0..2)
                .map(|_| momenta.iter().map(|index| self.draw() * self.sizes[*index]).collect())
                .collect();
            let with = |shares: [f64; 2]| -> Vec<f64> {
                let mut y = q.clone();
                for (k, index) in momenta.iter().enumerate() {
                    y[*index] = shares[0] * drawn[0][k] + shares[1] * drawn[1][k];
                }
                y
            };
            let [none, one, two, both] =
                [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|shares| self.rates(0.0, &with(shares)));
            let mut other = self.beside(0.05, &|index| !is_momentum(index) && Some(index) != section);
            momenta.iter().for_each(|index| other[*index] = 0.0);
            let elsewhere = self.rates(0.0, &other);
            for (k, index) in candidates.iter().copied().enumerate() {
                let size =
                    one[index].abs().max(two[index].abs()).max(both[index].abs()).max(none[index].abs());
                let same = |a: f64, b: f64| (a - b).abs() <= SAME * size;
                moves[k] |= !same(one[index], none[index]);
                is_place[k] &= same(one[index] + two[index], both[index] + none[index])
                    && same(none[index], elsewhere[index]);
            }
        }
        (candidates.iter().zip(is_place.iter().zip(&moves)))
            .filter_map(|(index, (place, moves))| (*place && *moves).then_some(*index))
            .collect()
    }
}
