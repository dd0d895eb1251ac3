//! The finite film: pressure by cavitation model, with buffers that are kept from call to call.

use crate::banded::Band;
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
    band: Band,
    pressure: Vec<f64>,
    empty: Vec<f64>,
    under_pressure: Vec<bool>,
    warm: bool,
    number: Vec<usize>,
    /// Solution of the band.
    unknown: Vec<f64>,
    /// What leaves each cell by pressure.
    outflow: Vec<f64>,
    /// Pressure of the film before the last.
    earlier: Vec<f64>,
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
            band: Band::default(),
            pressure: vec![0.0; count],
            empty: vec![0.0; count],
            under_pressure: vec![true; count],
            warm: false,
            number: vec![NONE; count],
            unknown: Vec::with_capacity(count),
            outflow: Vec::with_capacity(count),
            earlier: vec![0.0; count],
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
        self.cells.outflow(&self.pressure, &mut self.outflow);
        let mut solution = FilmSolution::gather(
            &self.grid,
            &self.cells,
            problem,
            &self.pressure,
            &self.empty,
            &self.outflow,
        );
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

    /// First guess of the cells under pressure.
    fn guess_set(&mut self) {
        if !self.warm {
            // Cells of a positive source first: the set grows and shrinks from there.
            for (set, source) in self.under_pressure.iter_mut().zip(&self.cells.source) {
                *set = *source > 0.0;
            }
            return;
        }
        // The pressure as it went on from the film before the last to the last, relaxed once in this one, tells most of the cells that change.
        for (earlier, last) in self.earlier.iter_mut().zip(&self.pressure) {
            *earlier = 2.0 * last - *earlier;
        }
        self.cells.outflow(&self.earlier, &mut self.outflow);
        for (cell, set) in self.under_pressure.iter_mut().enumerate() {
            let others = self.outflow[cell] - self.cells.diagonal[cell] * self.earlier[cell];
            *set = others < self.cells.source[cell];
        }
        self.earlier.clone_from(&self.pressure);
    }

    /// P >= 0, outflow >= source, one of them equal: sets change until none must.
    fn complementary(&mut self) -> Option<usize> {
        let is_first = !self.warm;
        self.guess_set();
        self.warm = false;
        for iteration in 1..=MOST_ITERATIONS {
            self.solve_set();
            self.cells.outflow(&self.pressure, &mut self.outflow);
            let mut changed = false;
            for cell in 0..self.pressure.len() {
                if self.cells.fixed[cell].is_some() {
                    continue;
                }
                let wanted = if self.under_pressure[cell] {
                    self.pressure[cell] > 0.0
                } else {
                    self.outflow[cell] < self.cells.source[cell]
                };
                changed |= wanted != self.under_pressure[cell];
                self.under_pressure[cell] = wanted;
            }
            if !changed {
                self.warm = true;
                if is_first {
                    self.earlier.clone_from(&self.pressure);
                }
                return Some(iteration);
            }
        }
        self.pressure.iter_mut().for_each(|p| *p = p.max(0.0));
        None
    }

    /// Pressure in the cells of the set, zero in the others, as known in the fixed.
    fn solve_set(&mut self) {
        let cells = &self.cells;
        let (n, m) = (cells.around, cells.axial);
        for (number, (set, fixed)) in self.number.iter_mut().zip(self.under_pressure.iter().zip(&cells.fixed))
        {
            *number = if *set && fixed.is_none() { 0 } else { NONE };
        }
        let cut = self.number.chunks_exact(m).position(|column| column.iter().all(|own| *own == NONE));
        let mut count = 0;
        for i in cells.order(cut) {
            for own in self.number[i * m..(i + 1) * m].iter_mut().filter(|own| **own != NONE) {
                *own = count;
                count += 1;
            }
        }
        let mut width = 1;
        for cell in 0..n * m {
            let (own, next) = (self.number[cell], self.number[cells.next(cell)]);
            if own != NONE && next != NONE {
                width = width.max(own.abs_diff(next));
            }
        }
        self.band.reset(count, width);
        for cell in 0..n * m {
            let own = self.number[cell];
            if own == NONE {
                continue;
            }
            self.band.add(own, own, cells.diagonal[cell]);
            self.band.add_right(own, cells.source[cell]);
            if cells.north[cell] != 0.0 && self.number[cell + 1] != NONE {
                self.band.add(own, own + 1, -cells.north[cell]);
                self.band.add(own + 1, own, -cells.north[cell]);
            }
            let next = self.number[cells.next(cell)];
            if next != NONE {
                self.band.add(own, next, -cells.east[cell]);
                self.band.add(next, own, -cells.east[cell]);
            }
        }
        if cells.any_fixed {
            for cell in 0..n * m {
                if let Some(known) = cells.fixed[cell] {
                    for (other, conductance) in cells.neighbours(cell) {
                        if self.number[other] != NONE {
                            self.band.add_right(self.number[other], conductance * known);
                        }
                    }
                }
            }
        }
        self.band.solve(&mut self.unknown);
        for cell in 0..n * m {
            self.pressure[cell] = match self.number[cell] {
                NONE => cells.fixed[cell].unwrap_or(0.0),
                own => self.unknown[own],
            };
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
            self.band.reset(count, width);
            for i in 0..n {
                for j in 0..m {
                    self.conserving_row(problem, carry, i, j);
                }
            }
            self.band.solve(&mut self.unknown);
            let mut changed = false;
            for cell in 0..n * m {
                let own = self.number[cell];
                if own == NONE {
                    self.pressure[cell] = self.cells.fixed[cell].unwrap_or(0.0);
                    continue;
                }
                let value = self.unknown[own];
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
        let cell = i * self.cells.axial + j;
        let own = self.number[cell];
        if own == NONE {
            return;
        }
        self.band.add_right(own, self.cells.source[cell]);
        // Volume of the cell's column for H = 1.
        let volume = problem.bearing.clearance * self.cells.width[i];
        let change = match &self.memory {
            Some(memory) => {
                self.band.add_right(own, -volume * memory.past[cell]);
                volume * memory.rate * self.cells.thickness[cell]
            }
            None => self.cells.opening(problem.motion.velocity, i),
        };
        if self.under_pressure[cell] {
            self.band.add(own, own, self.cells.diagonal[cell]);
        } else {
            // Its own emptiness leaves over the face downstream and with the film's opening.
            let downstream =
                if carry >= 0.0 { self.cells.face[cell] } else { self.cells.face[self.cells.before(cell)] };
            self.band.add(own, own, -(carry.abs() * downstream + change));
        }
        for (other, conductance) in self.cells.neighbours(cell) {
            if let Some(known) = self.cells.fixed[other] {
                self.band.add_right(own, conductance * known);
            } else if self.under_pressure[other] {
                self.band.add(own, self.number[other], -conductance);
            }
        }
        let (upstream, face) = self.cells.upstream(carry, cell);
        if self.number[upstream] != NONE && !self.under_pressure[upstream] {
            self.band.add(own, self.number[upstream], carry.abs() * self.cells.face[face]);
        }
    }
}
