//! Finite volumes of the film: thickness, conductances and sources of every cell.
//!
//! With H = h/c, place s = 2z/L and pressure p = (12 mu R^2/c^3) P:
//! ```text
//! d/da(H^3 dP/da) + k d/ds(H^3 dP/ds) = -v.n,   k = (D/L)^2          n integrated over each cell exactly
//! ```
//! so that the work of force and torque is the dissipation to rounding.

use crate::grid::FilmGrid;
use crate::plane::{Plane, add, cross, dot, quarter};
use crate::problem::{Feed, FilmProblem};
use lanchester_numerics::about_zero;
use std::f64::consts::TAU;

/// Cells at one instant, index i m + j. Buffers are kept.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cells {
    pub around: usize,
    pub axial: usize,
    /// INT n da of each column.
    pub normal: Vec<Plane>,
    /// Direction at the middle of each column, at its face towards the next, and its width.
    pub middle: Vec<Plane>,
    pub edge: Vec<Plane>,
    pub width: Vec<f64>,
    /// H in the middle of the cell.
    pub thickness: Vec<f64>,
    /// H at the face towards the next column.
    pub face: Vec<f64>,
    /// Conductance towards the next column, towards the next cell along the axis (0 for the last), towards the ends, and the sum of all of a cell.
    pub east: Vec<f64>,
    pub north: Vec<f64>,
    pub end: Vec<f64>,
    pub diagonal: Vec<f64>,
    /// INT v.n da.
    pub source: Vec<f64>,
    /// Known pressure, in the unit of P.
    pub fixed: Vec<Option<f64>>,
    pub any_fixed: bool,
}

impl Cells {
    /// Directions of a grid.
    pub fn place(&mut self, grid: &FilmGrid) {
        (self.around, self.axial) = (grid.around(), grid.axial);
        self.normal.clear();
        self.middle.clear();
        self.edge.clear();
        self.width.clear();
        let direction = |angle: f64| [angle.cos(), angle.sin()];
        let mut before = direction(grid.faces[0]);
        for i in 0..self.around {
            let (from, to) = (grid.faces[i], grid.faces[i + 1]);
            let edge = direction(to);
            self.normal.push([edge[1] - before[1], before[0] - edge[0]]);
            self.edge.push(edge);
            before = edge;
            self.middle.push(direction(grid.angle(i)));
            self.width.push(to - from);
        }
    }

    /// Everything of an instant.
    pub fn fill(&mut self, grid: &FilmGrid, problem: &FilmProblem) {
        let (n, m) = (self.around, self.axial);
        let bearing = &problem.bearing;
        let ratio = problem.motion.eccentricity.map(|e| e / bearing.clearance);
        let tilt = problem.tilt.map(|e| e / bearing.clearance);
        let shape = bearing.slenderness().powi(-2);
        let height = grid.height();
        let closing = problem.motion.closing();
        let swing = quarter(problem.tilt).map(|part| -problem.motion.entrainment * part);
        for buffer in [
            &mut self.thickness,
            &mut self.face,
            &mut self.east,
            &mut self.north,
            &mut self.end,
            &mut self.diagonal,
            &mut self.source,
        ] {
            buffer.clear();
            buffer.resize(n * m, 0.0);
        }
        for i in 0..n {
            let distance = 0.5 * (self.width[i] + self.width[(i + 1) % n]);
            if tilt == [0.0, 0.0] {
                // Every cell of the column is the same but the last, whose end is half a cell away.
                let h = 1.0 - dot(ratio, self.middle[i]);
                let face = 1.0 - dot(ratio, self.edge[i]);
                let along = shape * h.powi(3) * self.width[i] / (height * height);
                let column = i * m..(i + 1) * m;
                self.thickness[column.clone()].fill(h);
                self.face[column.clone()].fill(face);
                self.east[column.clone()].fill(face.powi(3) / distance);
                self.north[column.clone()].fill(along);
                self.north[column.end - 1] = 0.0;
                self.end[column.end - 1] = 2.0 * along;
                self.end[column.start] = if grid.half { 0.0 } else { 2.0 * along };
                self.source[column].fill(dot(closing, self.normal[i]));
                continue;
            }
            for j in 0..m {
                let cell = i * m + j;
                let at = add(ratio, grid.place(j), tilt);
                let h = 1.0 - dot(at, self.middle[i]);
                let face = 1.0 - dot(at, self.edge[i]);
                self.thickness[cell] = h;
                self.face[cell] = face;
                self.east[cell] = face.powi(3) / distance;
                let shape = shape * self.width[i] / (height * height);
                if j + 1 < m {
                    let between = add(ratio, 0.5 * (grid.place(j) + grid.place(j + 1)), tilt);
                    self.north[cell] = shape * (1.0 - dot(between, self.middle[i])).powi(3);
                }
                if j + 1 == m || (j == 0 && !grid.half) {
                    self.end[cell] = 2.0 * shape * h.powi(3);
                }
                self.source[cell] = dot(add(closing, grid.place(j), swing), self.normal[i]);
            }
        }
        self.sum();
        self.fix(grid, problem);
    }

    /// The diagonal.
    fn sum(&mut self) {
        let (m, count) = (self.axial, self.around * self.axial);
        for cell in 0..count {
            self.diagonal[cell] = self.east[cell] + self.north[cell] + self.end[cell];
        }
        for cell in 0..count - m {
            self.diagonal[cell + m] += self.east[cell];
        }
        for cell in 0..m {
            self.diagonal[cell] += self.east[count - m + cell];
        }
        for cell in 1..count {
            self.diagonal[cell] += self.north[cell - 1];
        }
    }

    fn fix(&mut self, grid: &FilmGrid, problem: &FilmProblem) {
        let (n, m) = (self.around, self.axial);
        self.fixed.clear();
        self.fixed.resize(n * m, None);
        self.any_fixed = !problem.feeds.is_empty();
        let (radius, half) = (problem.bearing.radius, 0.5 * problem.bearing.length);
        let unit = problem.bearing.pressure_scale(problem.viscosity);
        let turn = |from: f64, to: f64| about_zero(to - from, TAU);
        let column = |angle: f64| {
            (0..n)
                .find(|&i| (angle - grid.faces[i]).rem_euclid(TAU) < grid.faces[i + 1] - grid.faces[i])
                .unwrap_or(0)
        };
        let row = |place: f64| {
            let s = (place / half).clamp(-1.0, 1.0);
            let share = if grid.half { s.abs() } else { 0.5 * (s + 1.0) };
            ((share * m as f64) as usize).min(m - 1)
        };
        for feed in &problem.feeds {
            let (value, nearest) = match *feed {
                Feed::Groove { from, to, middle, pressure, .. } => {
                    (pressure / unit, (column(0.5 * (from + to)), row(middle)))
                }
                Feed::Hole { angle, place, pressure, .. } => (pressure / unit, (column(angle), row(place))),
                Feed::Line { angle, pressure } => (pressure / unit, (column(angle), 0)),
            };
            let inside = |i: usize, j: usize| {
                let (angle, z) = (grid.angle(i), grid.place(j) * half);
                match *feed {
                    Feed::Groove { from, to, middle, width, .. } => {
                        let at_angle = (angle - from).rem_euclid(TAU) <= to - from
                            || (to - from < self.width[i] && i == nearest.0);
                        let across = (z - middle).abs() <= 0.5 * width
                            || (width < grid.height() * half && j == nearest.1);
                        at_angle && across
                    }
                    Feed::Hole { angle: centre, place, diameter, .. } => {
                        let distance = (radius * turn(centre, angle)).hypot(z - place);
                        distance <= 0.5 * diameter || (i, j) == nearest
                    }
                    Feed::Line { .. } => i == nearest.0,
                }
            };
            for i in 0..n {
                for j in 0..m {
                    if inside(i, j) {
                        self.fixed[i * m + j] = Some(value);
                    }
                }
            }
        }
    }

    /// The cell of the next column.
    pub fn next(&self, cell: usize) -> usize {
        let next = cell + self.axial;
        if next < self.thickness.len() { next } else { next - self.thickness.len() }
    }

    /// The cell of the column before.
    pub fn before(&self, cell: usize) -> usize {
        cell.checked_sub(self.axial).unwrap_or(self.thickness.len() + cell - self.axial)
    }

    /// The cells that share a face with one, and the conductances over it.
    pub fn neighbours(&self, cell: usize) -> impl Iterator<Item = (usize, f64)> {
        let j = cell % self.axial;
        let before = self.before(cell);
        let around = [(self.next(cell), self.east[cell]), (before, self.east[before])];
        let above = (j + 1 < self.axial).then(|| (cell + 1, self.north[cell]));
        let below = (j > 0).then(|| (cell - 1, self.north[cell - 1]));
        around.into_iter().chain(above).chain(below)
    }

    /// The cell from which surfaces that turn with this mean speed carry oil into a cell, and the one whose face towards its next is between both.
    pub fn upstream(&self, entrainment: f64, cell: usize) -> (usize, usize) {
        let before = self.before(cell);
        if entrainment >= 0.0 { (before, before) } else { (self.next(cell), cell) }
    }

    /// What leaves each cell by pressure: the matrix times P.
    pub fn outflow(&self, p: &[f64], out: &mut Vec<f64>) {
        let (m, count) = (self.axial, self.around * self.axial);
        out.clear();
        out.extend(self.diagonal.iter().zip(p).map(|(diagonal, p)| diagonal * p));
        for (out, (north, p)) in out.iter_mut().zip(self.north.iter().zip(&p[1..])) {
            *out -= north * p;
        }
        for (out, (north, p)) in out[1..].iter_mut().zip(self.north.iter().zip(p)) {
            *out -= north * p;
        }
        for (out, (east, p)) in out.iter_mut().zip(self.east.iter().zip(&p[m..])) {
            *out -= east * p;
        }
        for (out, (east, p)) in out[m..].iter_mut().zip(self.east.iter().zip(p)) {
            *out -= east * p;
        }
        // Over the face where the columns close.
        for j in 0..m {
            let (first, last) = (j, count - m + j);
            out[last] -= self.east[last] * p[first];
            out[first] -= self.east[last] * p[last];
        }
    }

    /// Order of the columns in which neighbours are near one another: from a column where all pressure is known onwards, else folded.
    pub fn order(&self, cut: Option<usize>) -> Vec<usize> {
        let n = self.around;
        match cut {
            Some(first) => (0..n).map(|i| (first + i) % n).collect(),
            None => (0..n).map(|i| if i % 2 == 0 { i / 2 } else { n - 1 - i / 2 }).collect(),
        }
    }

    /// Squeeze of a cell by the journal's own velocity, H' times its width [m/s].
    pub fn opening(&self, velocity: Plane, i: usize) -> f64 {
        -dot(velocity, self.normal[i])
    }

    /// z component of e x n, integrated over a column.
    pub fn lever(&self, eccentricity: Plane, i: usize) -> f64 {
        cross(eccentricity, self.normal[i])
    }
}
