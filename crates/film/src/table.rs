//! Table of the impedance: dimensionless force of a film by eccentricity and direction of motion, with derivatives.
//!
//! ```text
//! F = 12 mu (R^3 L/c^3) f(e/c, v)      f of degree one in v
//! w = (v_r, d v_t) = |w| (cos g, sin g),  d = sqrt(1 - eps^2)        f_r = |w| d^-3 G_r(x, g),  f_t = |w| d^-2 G_t(x, g),  x = -ln(1 - eps)
//! ```
//! At high eccentricity the pressure lies within an angle of about d, so that motion across counts d times as much as motion along: in these
//! variables G stays of order one and smooth up to contact. Between the nodes G is bicubic (Hermite, slopes of order 4), so f and
//! its derivatives come from the same polynomial. At eps = 0 the film knows no direction: there G = -k (cos g, sin g) exactly.

use crate::bearing::{JournalBearing, JournalMotion, check_slenderness};
use crate::cavitation::Cavitation;
use crate::error::{FilmError, require, require_film};
use crate::grid::FilmGrid;
use crate::plane::{Plane, direction, dot, length, quarter};
use crate::problem::FilmProblem;
use crate::solver::FilmSolver;
use lanchester_numerics::illinois;
use std::f64::consts::{PI, TAU};

/// Nodes of x and of g, and the largest tabulated eccentricity: 1 - exp(-LAST).
const ROWS: usize = 57;
const COLUMNS: usize = 96;
const LAST: f64 = 7.0;
/// Miss of an angle [rad], or of a dimensionless force, that counts as none.
const SETTLED: f64 = 1e-13;
/// Cells of the films behind a table.
const AROUND: usize = 120;
const AXIAL: usize = 12;

/// Force with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Impedance {
    /// f [m/s].
    pub force: Plane,
    /// df/dv, by rows.
    pub by_velocity: [Plane; 2],
    /// df/d(e/c), by rows [m/s].
    pub by_eccentricity: [Plane; 2],
}

/// Impedance of one model of cavitation and one length over diameter.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmTable {
    slenderness: f64,
    cavitation: Cavitation,
    /// k at eps = 0.
    centred: f64,
    /// G + k (cos, sin), with d/dx, d/dg and d2/dxdg times the widths of a cell: two components each.
    nodes: Vec<[[f64; 4]; 2]>,
}

impl FilmTable {
    /// Computes the table: some thousand finite films.
    ///
    /// # Errors
    /// [`FilmError::Number`] for a length over diameter outside 0.02 to 20, or the mass-conserving film, whose force depends on its feeds.
    pub fn new(slenderness: f64, cavitation: Cavitation) -> Result<FilmTable, FilmError> {
        check_slenderness(slenderness)?;
        require(
            cavitation != Cavitation::MassConserving,
            "models of cavitation in a table (mass-conserving films are solved directly)",
            "full, gumbel or reynolds",
            4.0,
        )?;
        let bearing = JournalBearing { radius: 1.0, length: 2.0 * slenderness, clearance: 1e-3 };
        let mut values = vec![[0.0; 2]; ROWS * COLUMNS];
        let mut centred = 0.0;
        for row in 0..ROWS {
            let ratio = -(-step_x() * row as f64).exp_m1();
            let d = (1.0 - ratio * ratio).sqrt();
            let mut solver = FilmSolver::new(FilmGrid::graded(AROUND, AXIAL, true, [ratio, 0.0])?)?;
            for column in 0..=COLUMNS / 2 {
                let (sin, cos) = (step_g() * column as f64).sin_cos();
                let problem = FilmProblem {
                    bearing,
                    viscosity: 1.0,
                    motion: JournalMotion {
                        eccentricity: [ratio * bearing.clearance, 0.0],
                        velocity: [cos, sin / d],
                        ..JournalMotion::default()
                    },
                    tilt: [0.0, 0.0],
                    cavitation,
                    feeds: Vec::new(),
                };
                let force = solver.solve(&problem)?.force.map(|part| part / bearing.force_scale(1.0));
                if row == 0 && column == 0 {
                    centred = -force[0];
                }
                let rest = if row == 0 {
                    [0.0, 0.0]
                } else {
                    [force[0] * d.powi(3) + centred * cos, force[1] * d * d + centred * sin]
                };
                values[row * COLUMNS + column] = rest;
                // Mirrored in the line of centres.
                values[row * COLUMNS + (COLUMNS - column) % COLUMNS] =
                    [rest[0], if column % (COLUMNS / 2) == 0 { 0.0 } else { -rest[1] }];
                if column % (COLUMNS / 2) == 0 {
                    values[row * COLUMNS + column][1] = 0.0;
                }
            }
        }
        Ok(FilmTable { slenderness, cavitation, centred, nodes: with_slopes(&values) })
    }

    /// Length over diameter.
    pub fn slenderness(&self) -> f64 {
        self.slenderness
    }

    /// Model of cavitation.
    pub fn cavitation(&self) -> Cavitation {
        self.cavitation
    }

    /// Largest tabulated eccentricity ratio; beyond it the last row is continued with the powers of d above.
    pub fn last_ratio() -> f64 {
        -(-LAST).exp_m1()
    }

    /// G and its derivatives by x and g.
    fn lookup(&self, x: f64, g: f64) -> [[f64; 3]; 2] {
        let beyond = x >= LAST;
        let at = (x / step_x()).clamp(0.0, (ROWS - 1) as f64);
        let row = (at as usize).min(ROWS - 2);
        let turn = (g / step_g()).rem_euclid(COLUMNS as f64);
        let column = (turn as usize).min(COLUMNS - 1);
        let (s, t) = (at - row as f64, turn - column as f64);
        let (bs, ds, bt, dt) = (hermite(s), hermite_slope(s), hermite(t), hermite_slope(t));
        let next = (column + 1) % COLUMNS;
        let corners = [
            (&self.nodes[row * COLUMNS + column], 0, 0),
            (&self.nodes[(row + 1) * COLUMNS + column], 1, 0),
            (&self.nodes[row * COLUMNS + next], 0, 1),
            (&self.nodes[(row + 1) * COLUMNS + next], 1, 1),
        ];
        let mut found = [[0.0; 3]; 2];
        for (node, a, b) in corners {
            for component in 0..2 {
                let [value, by_x, by_g, by_xg] = node[component];
                let along_t = |weights: &[f64; 4]| {
                    (
                        value * weights[2 * b] + by_g * weights[2 * b + 1],
                        by_x * weights[2 * b] + by_xg * weights[2 * b + 1],
                    )
                };
                let (plain, slope) = along_t(&bt);
                let (plain_t, slope_t) = along_t(&dt);
                found[component][0] += plain * bs[2 * a] + slope * bs[2 * a + 1];
                found[component][1] += plain * ds[2 * a] + slope * ds[2 * a + 1];
                found[component][2] += plain_t * bs[2 * a] + slope_t * bs[2 * a + 1];
            }
        }
        let (sin, cos) = g.sin_cos();
        let by_x = if beyond { 0.0 } else { 1.0 / step_x() };
        [
            [
                found[0][0] - self.centred * cos,
                found[0][1] * by_x,
                found[0][2] / step_g() + self.centred * sin,
            ],
            [
                found[1][0] - self.centred * sin,
                found[1][1] * by_x,
                found[1][2] / step_g() - self.centred * cos,
            ],
        ]
    }

    /// Force over [`JournalBearing::force_scale`] with its derivatives, for the eccentricity over the radial clearance and the closing velocity.
    ///
    /// # Errors
    /// [`FilmError::Eccentricity`] at 1 and above.
    pub fn impedance(&self, eccentricity_ratio: Plane, v: Plane) -> Result<Impedance, FilmError> {
        let (along, size) = direction(eccentricity_ratio);
        require_film(size)?;
        let across = quarter(along);
        let ratio = size.max(1e-7);
        let d = (1.0 - ratio * ratio).sqrt();
        let (vr, vt) = (dot(v, along), dot(v, across));
        let speed = vr.hypot(d * vt);
        if speed == 0.0 {
            return Ok(Impedance::default());
        }
        let (cos, sin) = (vr / speed, d * vt / speed);
        let [[r, rx, rg], [t, tx, tg]] = self.lookup(-(-ratio).ln_1p(), sin.atan2(cos));
        let (pr, pt) = (d.powi(-3), d.powi(-2));
        let by_x = 1.0 / (1.0 - ratio);
        let by_d = -ratio / d;
        // Of a component speed * power * G: by v_r, by v_t, by eps.
        let partial = |power: f64, exponent: f64, value: f64, x: f64, g: f64| {
            [
                power * (cos * value - sin * g),
                power * d * (sin * value + cos * g),
                speed * power * x * by_x
                    + by_d * power * (exponent * speed / d * value + sin * vt * value + cos * vt * g),
            ]
        };
        let (fr, ft) = (speed * pr * r, speed * pt * t);
        let dr = partial(pr, -3.0, r, rx, rg);
        let dt = partial(pt, -2.0, t, tx, tg);
        // Turning e at a constant v: dv_r = v_t, dv_t = -v_r.
        let turn = [dr[0] * vt - dr[1] * vr - ft, dt[0] * vt - dt[1] * vr + fr].map(|part| part / ratio);
        let outer = |rows: [Plane; 2]| {
            // rows: of (f_r, f_t) along (along, across) -> Cartesian.
            let entry = |i: usize, j: usize| {
                along[i] * (rows[0][0] * along[j] + rows[0][1] * across[j])
                    + across[i] * (rows[1][0] * along[j] + rows[1][1] * across[j])
            };
            [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
        };
        Ok(Impedance {
            force: [0, 1].map(|k| fr * along[k] + ft * across[k]),
            by_velocity: outer([[dr[0], dr[1]], [dt[0], dt[1]]]),
            by_eccentricity: outer([[dr[2], turn[0]], [dt[2], turn[1]]]),
        })
    }

    /// Closing velocity at which the film exerts this force, in the units of [`FilmTable::impedance`]: the mobility map, times the force.
    ///
    /// # Errors
    /// [`FilmError::Eccentricity`] at 1 and above.
    pub fn velocity(&self, eccentricity_ratio: Plane, force: Plane) -> Result<Plane, FilmError> {
        let (along, size) = direction(eccentricity_ratio);
        require_film(size)?;
        let across = quarter(along);
        let d = (1.0 - size * size).sqrt();
        let wanted = [dot(force, along) * d.powi(3), dot(force, across) * d * d];
        let amount = length(wanted);
        if amount == 0.0 {
            return Ok([0.0, 0.0]);
        }
        let x = -(-size).ln_1p();
        let angle_left = |g: f64| {
            let [[r, ..], [t, ..]] = self.lookup(x, g);
            (wanted[0] * t - wanted[1] * r).atan2(wanted[0] * r + wanted[1] * t)
        };
        // Motion is against the force: near there the force's direction passes the wanted one, turning with the motion's.
        let guess = (-wanted[1]).atan2(-wanted[0]);
        let first = angle_left(guess);
        let (mut low, mut high, mut at_low, mut at_high) = (guess, guess, first, first);
        let mut reach = 0.05;
        while at_low * at_high > 0.0 {
            if reach > PI {
                return self.scan(x, wanted, amount, d, along, across);
            }
            if first > 0.0 {
                (high, at_high, low) = (low, at_low, low - reach);
                at_low = angle_left(low);
            } else {
                (low, at_low, high) = (high, at_high, high + reach);
                at_high = angle_left(high);
            }
            reach *= 2.0;
            if (at_low - at_high).abs() > PI {
                return self.scan(x, wanted, amount, d, along, across);
            }
        }
        let g = illinois(low, at_low, high, at_high, SETTLED, angle_left);
        Ok(self.velocity_at(x, g, amount, d, along, across))
    }

    fn scan(
        &self,
        x: f64,
        wanted: Plane,
        amount: f64,
        d: f64,
        along: Plane,
        across: Plane,
    ) -> Result<Plane, FilmError> {
        let left = |g: f64| {
            let [[r, ..], [t, ..]] = self.lookup(x, g);
            (wanted[0] * t - wanted[1] * r).atan2(wanted[0] * r + wanted[1] * t)
        };
        let steps = 4 * COLUMNS;
        let mut best = (f64::INFINITY, 0.0);
        let mut before = left(0.0);
        for k in 0..steps {
            let (low, high) = (TAU * k as f64 / steps as f64, TAU * (k + 1) as f64 / steps as f64);
            let now = left(high);
            if before * now <= 0.0 && (before - now).abs() < PI {
                let g = illinois(low, before, high, now, SETTLED, left);
                return Ok(self.velocity_at(x, g, amount, d, along, across));
            }
            if now.abs() < best.0 {
                best = (now.abs(), high);
            }
            before = now;
        }
        Ok(self.velocity_at(x, best.1, amount, d, along, across))
    }

    fn velocity_at(&self, x: f64, g: f64, amount: f64, d: f64, along: Plane, across: Plane) -> Plane {
        let [[r, ..], [t, ..]] = self.lookup(x, g);
        let speed = amount / r.hypot(t);
        let (vr, vt) = (speed * g.cos(), speed * g.sin() / d);
        [0, 1].map(|k| vr * along[k] + vt * across[k])
    }
}

fn step_x() -> f64 {
    LAST / (ROWS - 1) as f64
}

fn step_g() -> f64 {
    TAU / COLUMNS as f64
}

/// Value at 0, slope at 0, value at 1, slope at 1.
fn hermite(s: f64) -> [f64; 4] {
    let r = 1.0 - s;
    [r * r * (1.0 + 2.0 * s), s * r * r, s * s * (3.0 - 2.0 * s), -s * s * r]
}

fn hermite_slope(s: f64) -> [f64; 4] {
    [6.0 * s * (s - 1.0), (1.0 - s) * (1.0 - 3.0 * s), 6.0 * s * (1.0 - s), s * (3.0 * s - 2.0)]
}

/// Slopes of order 4 in both directions, one-sided at the ends of x.
fn with_slopes(values: &[Plane]) -> Vec<[[f64; 4]; 2]> {
    let along_g = |source: &dyn Fn(usize, usize) -> f64, row: usize, column: usize| {
        let at = |k: usize| source(row, (column + COLUMNS + k - 2) % COLUMNS);
        (at(0) - 8.0 * at(1) + 8.0 * at(3) - at(4)) / 12.0
    };
    let along_x = |source: &dyn Fn(usize, usize) -> f64, row: usize, column: usize| {
        let at = |k: usize| source(k, column);
        let n = ROWS - 1;
        match row {
            0 => (-25.0 * at(0) + 48.0 * at(1) - 36.0 * at(2) + 16.0 * at(3) - 3.0 * at(4)) / 12.0,
            1 => (-3.0 * at(0) - 10.0 * at(1) + 18.0 * at(2) - 6.0 * at(3) + at(4)) / 12.0,
            _ if row == n => {
                -(-25.0 * at(n) + 48.0 * at(n - 1) - 36.0 * at(n - 2) + 16.0 * at(n - 3) - 3.0 * at(n - 4))
                    / 12.0
            }
            _ if row == n - 1 => {
                -(-3.0 * at(n) - 10.0 * at(n - 1) + 18.0 * at(n - 2) - 6.0 * at(n - 3) + at(n - 4)) / 12.0
            }
            _ => (at(row - 2) - 8.0 * at(row - 1) + 8.0 * at(row + 1) - at(row + 2)) / 12.0,
        }
    };
    let mut nodes = vec![[[0.0; 4]; 2]; ROWS * COLUMNS];
    for component in 0..2 {
        let value = |row: usize, column: usize| values[row * COLUMNS + column][component];
        for row in 0..ROWS {
            for column in 0..COLUMNS {
                let slope_g = |row: usize, column: usize| along_g(&value, row, column);
                nodes[row * COLUMNS + column][component] = [
                    value(row, column),
                    along_x(&value, row, column),
                    slope_g(row, column),
                    along_x(&slope_g, row, column),
                ];
            }
        }
    }
    nodes
}
