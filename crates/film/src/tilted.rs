//! Force and moment of the film of a tilted journal, with derivatives by everything that it depends on.
//!
//! ```text
//! x = e/c, t: how much further the journal's axis lies at the end z = 1 than in the middle, over c; z over half the length
//! H = 1 - (x + z t).n      v = v_0 + z v_1       v_0 = e' - w_m z x e,   v_1 = c (t' - w_m z x t)
//! d/da(H^3 dP/da) + (D/L)^2 d/dz(H^3 dP/dz) = -v.n       P = SUM p_k(a) f_k(z)  with the polynomials of `axial`
//! f = -1/2 INT P+ n da dz      q = -1/2 INT P+ z n da dz
//! F = 12 mu (R^3 L/c^3) f      Q = 12 mu (R^3 L/c^3) q:  what works with the displacement of the end by tilt; the moment is z x Q L/2
//! ```
//! H is linear in z, so that the polynomials' integrals with H^3 are sums of constant ones: Galerkin's method along the axis, finite volumes around. The pressure of
//! a full film is smooth along the axis, so that six polynomials do what a grid of dozens of cells does. Guembel's film is this full film where it presses. Derivatives are those of
//! the discrete force, by the adjoint pressures of f and q.

use crate::axial::{Axial, Block, Line, SHAPES, axial};
use crate::bearing::check_slenderness;
use crate::block_ring::{BlockRing, plus, times};
use crate::error::{FilmError, require_film};
use crate::grid::FilmGrid;
use crate::plane::{Plane, add, dot, length};

/// Columns around.
const AROUND: usize = 72;

/// Place and motion of a tilted journal as its film sees them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TiltedMotion {
    /// Eccentricity over the radial clearance, x.
    pub eccentricity: Plane,
    /// How much further the axis lies at the end z = +L/2 than in the middle, over the radial clearance, t.
    pub tilt: Plane,
    /// Closing velocity in the middle, v_0 [m/s].
    pub closing: Plane,
    /// How much more it closes at the end z = +L/2, v_1 [m/s].
    pub closing_by_tilt: Plane,
}

/// Dimensionless force and moment of a tilted film, with derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TiltedImpedance {
    /// f_x, f_y, q_x, q_y [m/s].
    pub force: [f64; 4],
    /// By x and t, in this order [m/s]: rows f_x, f_y, q_x, q_y.
    pub by_place: [[f64; 4]; 4],
    /// By v_0 and v_1.
    pub by_velocity: [[f64; 4]; 4],
}

/// A column of cells: how its thickness runs along the axis, its angle and width.
struct Column {
    normal: Plane,
    /// INT n da over its width.
    facing: Plane,
    width: f64,
}

/// H = h[0] + h[1] z, cubed, as a polynomial in z, and its derivatives by both.
fn cube([a, b]: [f64; 2]) -> [[f64; 4]; 3] {
    let [square, mixed, other] = [3.0 * a * a, 6.0 * a * b, 3.0 * b * b];
    [[a * a * a, square * b, a * other, b * b * b], [square, mixed, other, 0.0], [0.0, square, mixed, other]]
}

fn combined(parts: &[Block; 4], shares: &[f64; 4], factor: f64) -> Block {
    let mut sum = [[0.0; SHAPES]; SHAPES];
    for (part, share) in parts.iter().zip(shares) {
        plus(&mut sum, factor * share, part);
    }
    sum
}

fn scalar(a: &Line, b: &Line) -> f64 {
    (0..SHAPES).map(|k| a[k] * b[k]).sum()
}

fn minus(a: &Line, b: &Line) -> Line {
    std::array::from_fn(|k| a[k] - b[k])
}

/// Guembel's film of a tilted journal.
///
/// # Errors
/// [`FilmError::Eccentricity`] where the journal reaches the shell at an end; [`FilmError::Number`] for a length over diameter outside 0.02 to 20.
///
/// ```
/// use lanchester_film::{FilmError, TiltedMotion, tilted_impedance};
/// // A journal that turns in its bearing, its axis leaning sideways.
/// let x = [0.5, 0.0];
/// let motion = TiltedMotion { eccentricity: x, tilt: [0.0, 0.3], closing: [0.0, -0.5], closing_by_tilt: [0.3, 0.0] };
/// let film = tilted_impedance(0.5, &motion)?;
/// // It is turned back.
/// assert!(film.force[3] < 0.0);
/// # Ok::<(), FilmError>(())
/// ```
pub fn tilted_impedance(slenderness: f64, motion: &TiltedMotion) -> Result<TiltedImpedance, FilmError> {
    Ok(Discrete::new(slenderness, motion)?.impedance(motion))
}

/// Largest pressure of the same film over [`crate::JournalBearing::pressure_scale`] [m/s], as far as columns and points along the axis see it.
///
/// # Errors
/// As [`tilted_impedance`].
pub fn tilted_pressure(slenderness: f64, motion: &TiltedMotion) -> Result<f64, FilmError> {
    let film = Discrete::new(slenderness, motion)?;
    let pressure = film.pressure(motion);
    let along = |p: &Line| film.axial.values.iter().map(|values| scalar(values, p)).fold(0.0, f64::max);
    Ok(pressure.iter().map(along).fold(0.0, f64::max))
}

/// Largest distance of the journal's axis from the bearing's at both ends, over the clearance.
fn furthest(x: Plane, t: Plane) -> f64 {
    length(add(x, 1.0, t)).max(length(add(x, -1.0, t)))
}

struct Discrete {
    axial: &'static Axial,
    columns: Vec<Column>,
    /// 1 over the distance from the middle of the column before [1/rad], and the angle of the face between them.
    faces: Vec<(f64, Plane)>,
    /// (D/L)^2.
    kappa: f64,
    x: Plane,
    t: Plane,
    ring: BlockRing,
}

impl Discrete {
    fn new(slenderness: f64, motion: &TiltedMotion) -> Result<Discrete, FilmError> {
        check_slenderness(slenderness)?;
        let (x, t) = (motion.eccentricity, motion.tilt);
        require_film(furthest(x, t))?;
        let axial = axial();
        // Graded towards the thinnest film where the eccentricity has a direction.
        let [size, lean] = [length(x), length(t)];
        let dense = if size > 0.0 { 1.0 + lean / (size + lean) } else { 0.0 };
        let grid = FilmGrid::graded(AROUND, 2, true, x.map(|part| (dense * part).clamp(-0.999, 0.999)))?;
        let normal = |angle: f64| -> Plane { [angle.cos(), angle.sin()] };
        let edges: Vec<Plane> = grid.faces.iter().map(|face| normal(*face)).collect();
        let columns: Vec<Column> = (0..AROUND)
            .map(|i| {
                let ([c0, s0], [c1, s1]) = (edges[i], edges[i + 1]);
                let width = grid.faces[i + 1] - grid.faces[i];
                Column { normal: normal(grid.angle(i)), facing: [s1 - s0, c0 - c1], width }
            })
            .collect();
        let faces = (0..AROUND)
            .map(|i| {
                let before = columns[(i + AROUND - 1) % AROUND].width;
                (2.0 / (before + columns[i].width), edges[i])
            })
            .collect();
        let mut own =
            Discrete { axial, columns, faces, kappa: slenderness.powi(-2), x, t, ring: BlockRing::default() };
        let couplings: Vec<Block> = own
            .faces
            .iter()
            .map(|(inverse, normal)| combined(&axial.around, &cube(own.thickness(*normal))[0], *inverse))
            .collect();
        let diagonal: Vec<Block> = (0..AROUND)
            .map(|i| {
                let column = &own.columns[i];
                let cubed = cube(own.thickness(column.normal))[0];
                let mut block = combined(&axial.along, &cubed, own.kappa * column.width);
                plus(&mut block, 1.0, &couplings[i]);
                plus(&mut block, 1.0, &couplings[(i + 1) % AROUND]);
                block
            })
            .collect();
        own.ring = BlockRing::new(&diagonal, couplings);
        Ok(own)
    }

    /// H in the middle, and how much more at the end.
    fn thickness(&self, n: Plane) -> [f64; 2] {
        [1.0 - self.x[0] * n[0] - self.x[1] * n[1], -self.t[0] * n[0] - self.t[1] * n[1]]
    }

    /// P by columns and functions.
    fn pressure(&self, motion: &TiltedMotion) -> Vec<Line> {
        let [mean, lever] = self.axial.means;
        let source = |own: &Column| {
            let closing = [motion.closing, motion.closing_by_tilt].map(|v| dot(v, own.facing));
            std::array::from_fn(|k| closing[0] * mean[k] + closing[1] * lever[k])
        };
        let mut pressure: Vec<Line> = self.columns.iter().map(source).collect();
        self.ring.solve(&mut pressure);
        pressure
    }

    fn impedance(&self, motion: &TiltedMotion) -> TiltedImpedance {
        let mut found = TiltedImpedance::default();
        let [mean, lever] = self.axial.means;
        let pressure = self.pressure(motion);
        // Where it presses: integrals of the functions there, without and with z.
        let mut adjoint: [Vec<Line>; 4] = std::array::from_fn(|_| Vec::with_capacity(AROUND));
        for (own, p) in self.columns.iter().zip(&pressure) {
            let mut pressed = [[0.0; SHAPES]; 2];
            for (values, (z, weight)) in self.axial.values.iter().zip(self.axial.points) {
                if scalar(values, p) > 0.0 {
                    for k in 0..SHAPES {
                        pressed[0][k] += weight * values[k];
                        pressed[1][k] += weight * z * values[k];
                    }
                }
            }
            for (output, adjoint) in adjoint.iter_mut().enumerate() {
                let share = -0.5 * own.facing[output % 2];
                let line = pressed[output / 2].map(|value| share * value);
                found.force[output] += scalar(&line, p);
                adjoint.push(line);
            }
        }
        adjoint.iter_mut().for_each(|own| self.ring.solve(own));
        for (i, own) in self.columns.iter().enumerate() {
            for (output, adjoint) in adjoint.iter().enumerate() {
                for (part, shape) in [mean, lever].iter().enumerate() {
                    let share = scalar(&adjoint[i], shape);
                    for axis in 0..2 {
                        found.by_velocity[output][2 * part + axis] += own.facing[axis] * share;
                    }
                }
            }
        }
        // By the thickness: of the flow around at every face, of that along in every column.
        let mut change =
            |parts: &[Block; 4], factor: f64, n: Plane, step: Line, other: &dyn Fn(&[Line]) -> Line| {
                let [_, by_middle, by_end] = cube(self.thickness(n));
                for (part, by) in [by_middle, by_end].iter().enumerate() {
                    let flow = times(&combined(parts, by, factor), &step);
                    for (output, adjoint) in adjoint.iter().enumerate() {
                        let share = scalar(&other(adjoint), &flow);
                        for axis in 0..2 {
                            // H falls with x.n and t.n.
                            found.by_place[output][2 * part + axis] += n[axis] * share;
                        }
                    }
                }
            };
        for i in 0..AROUND {
            let before = (i + AROUND - 1) % AROUND;
            let (inverse, normal) = self.faces[i];
            let across = |field: &[Line]| minus(&field[i], &field[before]);
            change(&self.axial.around, inverse, normal, across(&pressure), &across);
            let own = &self.columns[i];
            let here = |field: &[Line]| field[i];
            change(&self.axial.along, self.kappa * own.width, own.normal, pressure[i], &here);
        }
        found
    }
}
