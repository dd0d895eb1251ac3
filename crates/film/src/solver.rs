//! The finite film: pressure by cavitation model, with buffers that are kept from call to call.

use crate::banded::{Band, SymmetricBand};
use crate::cavitation::Cavitation;
use crate::cells::Cells;
use crate::error::{FilmError, require};
use crate::grid::FilmGrid;
use crate::problem::FilmProblem;
use crate::separable::Separable;
use crate::solution::FilmSolution;

/// Most changes of the set of cells under pressure.
const MOST_ITERATIONS: usize = 200;
/// A cell has no number among the unknowns.
const NONE: usize = usize::MAX;

/// Solves films on one grid. The last solution's set of cells under pressure is the first guess of the next.
#[derive(Debug, Clone)]
pub struct FilmSolver {
    grid: FilmGrid,
    cells: Cells,
    separable: Separable,
    symmetric: SymmetricBand,
    general: Band,
    pressure: Vec<f64>,
    empty: Vec<f64>,
    under_pressure: Vec<bool>,
    warm: bool,
    number: Vec<usize>,
    right: Vec<f64>,
    memory: Option<Memory>,
}

/// What a film that keeps its oil remembers: `d(H r)/dt = rate H r - past`.
#[derive(Debug, Clone, Default)]
struct Memory {
    /// [1/s].
    rate: f64,
    /// Of every cell [1/s].
    past: Vec<f64>,
}

impl FilmSolver {
    /// A solver on these cells.
    ///
    /// # Errors
    /// [`FilmError::Number`] where the grid has fewer than 8 columns or its angles do not rise over one turn.
    pub fn new(grid: FilmGrid) -> Result<FilmSolver, FilmError> {
        require(grid.faces.len() > 8, "cells around the film", "8 or more", grid.faces.len() as f64 - 1.0)?;
        require(grid.axial >= 2, "cells along the film", "2 or more", grid.axial as f64)?;
        for pair in grid.faces.windows(2) {
            require(pair[1] > pair[0], "width of a column of cells [rad]", "above 0", pair[1] - pair[0])?;
        }
        let turn = grid.faces[grid.faces.len() - 1] - grid.faces[0];
        require(
            (turn - std::f64::consts::TAU).abs() < 1e-9,
            "angle that the cells cover [rad]",
            "one turn",
            turn,
        )?;
        let count = grid.around() * grid.axial;
        let mut solver = FilmSolver {
            cells: Cells::default(),
            separable: Separable::default(),
            symmetric: SymmetricBand::default(),
            general: Band::default(),
            pressure: vec![0.0; count],
            empty: vec![0.0; count],
            under_pressure: vec![true; count],
            warm: false,
            number: vec![NONE; count],
            right: Vec::with_capacity(count),
            memory: None,
            grid,
        };
        solver.cells.place(&solver.grid);
        if solver.grid.half {
            solver.separable.place(&solver.grid);
        }
        Ok(solver)
    }

    /// The cells.
    pub fn grid(&self) -> &FilmGrid {
        &self.grid
    }

    /// Pressure of the last film, of column i and cell j at i m + j, over [`crate::JournalBearing::pressure_scale`] [m/s].
    pub fn pressure(&self) -> &[f64] {
        &self.pressure
    }

    /// Empty share of each cell of the last film; zero but with [`Cavitation::MassConserving`].
    pub fn emptiness(&self) -> &[f64] {
        &self.empty
    }

    /// From here on a mass-conserving film keeps its oil: the emptiness r of a cell of thickness H = h/c changes by `rate H r - past` [1/s]. Without this it
    /// is that of a state that lasts.
    pub(crate) fn remember(&mut self, rate: f64, past: impl Iterator<Item = f64>) {
        let memory = self.memory.get_or_insert_default();
        memory.rate = rate;
        memory.past.clear();
        memory.past.extend(past);
    }

    /// The film at one instant.
    ///
    /// # Errors
    /// As [`FilmProblem::check`]; [`FilmError::Number`] for a film that is not symmetric on cells of half the length.
    pub fn solve(&mut self, problem: &FilmProblem) -> Result<FilmSolution, FilmError> {
        problem.check()?;
        if self.grid.half && !problem.is_symmetric() {
            return Err(FilmError::Number {
                quantity: "cells over the length (0: half, 1: all)",
                needed: "all, where the film has tilt or grooves off its middle",
                got: 0.0,
            });
        }
        self.cells.fill(&self.grid, problem);
        if self.cells.fixed.iter().all(Option::is_some) {
            return Err(FilmError::NoLand);
        }
        self.empty.fill(0.0);
        let iterations = match problem.cavitation {
            Cavitation::Full | Cavitation::Gumbel => {
                self.full_film(problem);
                if problem.cavitation == Cavitation::Gumbel {
                    self.pressure.iter_mut().for_each(|p| *p = p.max(0.0));
                }
                Some(1)
            }
            Cavitation::Reynolds => self.complementary(),
            // With a memory the last set is near enough.
            Cavitation::MassConserving if self.memory.is_some() && self.warm => self.conserving(problem),
            Cavitation::MassConserving => {
                let first = self.complementary();
                first.and_then(|first| Some(first + self.conserving(problem)?))
            }
        };
        let mut solution =
            FilmSolution::gather(&self.grid, &self.cells, problem, &self.pressure, &self.empty);
        solution.converged = iterations.is_some();
        solution.iterations = iterations.unwrap_or(MOST_ITERATIONS);
        Ok(solution)
    }

    fn full_film(&mut self, problem: &FilmProblem) {
        if self.grid.half && !self.cells.any_fixed {
            self.separable.solve(&self.cells, problem.bearing.slenderness(), &mut self.pressure);
        } else {
            self.under_pressure.fill(true);
            self.solve_set();
        }
        self.warm = false;
    }

    /// P >= 0, outflow >= source, one of them equal: sets change until none must.
    fn complementary(&mut self) -> Option<usize> {
        let m = self.cells.axial;
        if !self.warm {
            // Cells of a positive source first: the set grows and shrinks from there.
            for (set, source) in self.under_pressure.iter_mut().zip(&self.cells.source) {
                *set = *source > 0.0;
            }
        }
        self.warm = false;
        for iteration in 1..=MOST_ITERATIONS {
            self.solve_set();
            let mut changed = false;
            for i in 0..self.cells.around {
                for j in 0..m {
                    let cell = i * m + j;
                    if self.cells.fixed[cell].is_some() {
                        continue;
                    }
                    let wanted = if self.under_pressure[cell] {
                        self.pressure[cell] > 0.0
                    } else {
                        self.cells.outflow(&self.pressure, i, j) < self.cells.source[cell]
                    };
                    changed |= wanted != self.under_pressure[cell];
                    self.under_pressure[cell] = wanted;
                }
            }
            if !changed {
                self.warm = true;
                return Some(iteration);
            }
        }
        self.pressure.iter_mut().for_each(|p| *p = p.max(0.0));
        None
    }

    /// Pressure in the cells of the set, zero in the others, as known in the fixed.
    fn solve_set(&mut self) {
        let (n, m) = (self.cells.around, self.cells.axial);
        let free = |i: usize, cell: usize, solver: &FilmSolver| {
            solver.under_pressure[i * m + cell] && solver.cells.fixed[i * m + cell].is_none()
        };
        let cut = (0..n).find(|&i| (0..m).all(|j| !free(i, j, self)));
        let order = self.cells.order(cut);
        self.number.fill(NONE);
        let mut count = 0;
        for &i in &order {
            for j in 0..m {
                if free(i, j, self) {
                    self.number[i * m + j] = count;
                    count += 1;
                }
            }
        }
        let mut width = 1;
        for i in 0..n {
            for j in 0..m {
                let (own, next) = (self.number[i * m + j], self.number[(i + 1) % n * m + j]);
                if own != NONE && next != NONE {
                    width = width.max(own.abs_diff(next));
                }
            }
        }
        self.symmetric.reset(count, width);
        self.right.clear();
        self.right.resize(count, 0.0);
        for i in 0..n {
            for j in 0..m {
                let cell = i * m + j;
                let own = self.number[cell];
                if own != NONE {
                    self.symmetric.add(own, own, self.cells.diagonal(i, j));
                    self.right[own] += self.cells.source[cell];
                }
                self.link(cell, (i + 1) % n * m + j, self.cells.east[cell]);
                if j + 1 < m {
                    self.link(cell, cell + 1, self.cells.north[cell]);
                }
            }
        }
        self.symmetric.solve(&mut self.right);
        for cell in 0..n * m {
            self.pressure[cell] = match (self.cells.fixed[cell], self.number[cell]) {
                (Some(known), _) => known,
                (None, NONE) => 0.0,
                (None, own) => self.right[own],
            };
        }
    }

    fn link(&mut self, a: usize, b: usize, conductance: f64) {
        let (first, second) = (self.number[a], self.number[b]);
        if first != NONE && second != NONE {
            self.symmetric.add(first, second, -conductance);
        }
        for (own, other) in [(first, b), (second, a)] {
            if let (true, Some(known)) = (own != NONE, self.cells.fixed[other]) {
                self.right[own] += conductance * known;
            }
        }
    }

    /// Mass-conserving: a cell is full (unknown P) or at zero pressure (unknown emptiness r).
    ///
    /// ```text
    /// outflow(P) - source - w_m c [H r]_upwind, around - r (-e'.INT n da) = 0
    /// ```
    /// With a memory the last term is the whole change of what is empty, `c INT d(H r)/dt da`.
    fn conserving(&mut self, problem: &FilmProblem) -> Option<usize> {
        let (n, m) = (self.cells.around, self.cells.axial);
        let carry = problem.motion.entrainment * problem.bearing.clearance;
        let cut = (0..n).find(|&i| (0..m).all(|j| self.cells.fixed[i * m + j].is_some()));
        self.number.fill(NONE);
        let mut count = 0;
        for i in self.cells.order(cut) {
            for j in 0..m {
                if self.cells.fixed[i * m + j].is_none() {
                    self.number[i * m + j] = count;
                    count += 1;
                }
            }
        }
        let width = if cut.is_some() { m } else { 2 * m };
        for iteration in 1..=MOST_ITERATIONS {
            self.general.reset(count, width);
            self.right.clear();
            self.right.resize(count, 0.0);
            for i in 0..n {
                for j in 0..m {
                    self.conserving_row(problem, carry, i, j);
                }
            }
            self.general.solve(&mut self.right);
            let mut changed = false;
            for cell in 0..n * m {
                let own = self.number[cell];
                if own == NONE {
                    self.pressure[cell] = self.cells.fixed[cell].unwrap_or(0.0);
                    continue;
                }
                let value = self.right[own];
                let full = self.under_pressure[cell];
                (self.pressure[cell], self.empty[cell]) = if full { (value, 0.0) } else { (0.0, value) };
                if value < 0.0 {
                    self.under_pressure[cell] = !full;
                    changed = true;
                }
            }
            if !changed {
                return Some(iteration);
            }
        }
        for (p, r) in self.pressure.iter_mut().zip(&mut self.empty) {
            (*p, *r) = (p.max(0.0), r.clamp(0.0, 1.0));
        }
        None
    }

    fn conserving_row(&mut self, problem: &FilmProblem, carry: f64, i: usize, j: usize) {
        let (n, m) = (self.cells.around, self.cells.axial);
        let cell = i * m + j;
        let own = self.number[cell];
        if own == NONE {
            return;
        }
        let (next, west) = ((i + 1) % n * m + j, (i + n - 1) % n * m + j);
        self.right[own] += self.cells.source[cell];
        // Volume of the cell's column for H = 1.
        let volume = problem.bearing.clearance * self.cells.width[i];
        let change = match &self.memory {
            Some(memory) => {
                self.right[own] -= volume * memory.past[cell];
                volume * memory.rate * self.cells.thickness[cell]
            }
            None => self.cells.opening(problem.motion.velocity, i),
        };
        let mut neighbours =
            [(next, self.cells.east[cell]), (west, self.cells.east[west]), (NONE, 0.0), (NONE, 0.0)];
        if j + 1 < m {
            neighbours[2] = (cell + 1, self.cells.north[cell]);
        }
        if j > 0 {
            neighbours[3] = (cell - 1, self.cells.north[cell - 1]);
        }
        if self.under_pressure[cell] {
            self.general.add(own, own, self.cells.diagonal(i, j));
        } else {
            // Its own emptiness leaves over the face downstream and with the film's opening.
            let downstream = if carry >= 0.0 { self.cells.face[cell] } else { self.cells.face[west] };
            self.general.add(own, own, -(carry.abs() * downstream + change));
        }
        for (other, conductance) in neighbours {
            if other == NONE {
                continue;
            }
            if let Some(known) = self.cells.fixed[other] {
                self.right[own] += conductance * known;
            } else if self.under_pressure[other] {
                self.general.add(own, self.number[other], -conductance);
            }
        }
        let (upstream, face) = self.cells.upstream(carry, i, j);
        if self.number[upstream] != NONE && !self.under_pressure[upstream] {
            self.general.add(own, self.number[upstream], carry.abs() * self.cells.face[face]);
        }
    }
}
