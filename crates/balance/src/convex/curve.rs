//! A load over the cycle as a vector that is a trigonometric polynomial of the angle and affine in the variables:
//!
//! ```text
//! g(phi; x) = SUM over keys k of  (c_k + C_k x) cos(k phi) + (s_k + S_k x) sin(k phi)      phi = theta / revolutions
//! ```
//! Its largest amount over the continuous angle is found from a grid that resolves it, every candidate refined by
//! Newton's method on the exact derivative of `|g|^2`.

use super::dense::{Matrix, dot, norm};
use std::f64::consts::TAU;
use std::rc::Rc;

/// Most components of a curve; a vector that does not depend on the angle may have any number.
pub(crate) const WIDTH: usize = 3;

/// A slope below this share of the amount, per radian, is none.
const FLAT: f64 = 1e-14;

/// A step of Newton's method below this [rad] is the last one.
const CLOSE: f64 = 1e-9;

/// Rounding of a sum of harmonics, as a share of the sum of their amounts.
const GRAIN: f64 = 4.0 * f64::EPSILON;

/// A vector of a curve; components beyond its own are 0.
pub(crate) type Vector = [f64; WIDTH];

fn length(v: &Vector) -> f64 {
    square(v).sqrt()
}

fn square(v: &Vector) -> f64 {
    inner(v, v)
}

fn inner(a: &Vector, b: &Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Equally spaced angles of one period.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Grid {
    /// Revolutions of crankshaft 1 in a period.
    pub revolutions: u32,
    cos: Vec<f64>,
    sin: Vec<f64>,
}

impl Grid {
    /// `count` angles of a period of so many revolutions.
    pub fn new(revolutions: u32, count: usize) -> Grid {
        let turn = |j: usize| (TAU * j as f64 / count as f64).sin_cos();
        Grid {
            revolutions,
            cos: (0..count).map(|j| turn(j).1).collect(),
            sin: (0..count).map(|j| turn(j).0).collect(),
        }
    }

    pub fn len(&self) -> usize {
        self.cos.len()
    }

    fn step(&self) -> f64 {
        TAU / self.len() as f64
    }

    /// Adds a harmonic to values on the grid.
    fn add(&self, harmonic: &Harmonic, values: &mut [Vector]) {
        let count = self.len();
        let stride = harmonic.key as usize % count;
        let mut place = 0;
        for value in values {
            let (cos, sin) = (self.cos[place], self.sin[place]);
            for m in 0..WIDTH {
                value[m] += harmonic.cos[m] * cos + harmonic.sin[m] * sin;
            }
            place += stride;
            if place >= count {
                place -= count;
            }
        }
    }
}

/// One harmonic of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Harmonic {
    /// Order times revolutions.
    pub key: u32,
    pub cos: Vector,
    pub sin: Vector,
}

/// A curve, what no variable touches of it also on the grid.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve {
    /// Components.
    pub dimension: usize,
    base: Vec<Harmonic>,
    /// Places in `base` of the harmonics that depend on the variables, rising.
    touched: Vec<usize>,
    /// For each touched harmonic the rows of `C_k`, then those of `S_k`.
    pub columns: Matrix,
    /// Sum of the untouched harmonics at every angle of the grid.
    on_grid: Rc<Vec<Vector>>,
    /// What rounding may have made of an amount, of the sums behind `base` too.
    grain: f64,
}

/// A curve at one choice of the variables.
pub(crate) struct Fixed<'a> {
    curve: &'a Curve,
    harmonics: Vec<Harmonic>,
    /// What rounding may make of an amount.
    grain: f64,
}

/// A local maximum of the amount of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Summit {
    /// Angle `phi`.
    pub angle: f64,
    /// Amount.
    pub amount: f64,
}

/// Value and derivatives by `phi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Jet {
    pub value: Vector,
    pub slope: Vector,
    pub bend: Vector,
}

impl Jet {
    /// Square of the amount.
    pub fn square(&self) -> f64 {
        square(&self.value)
    }

    /// Half the first and second derivative of the square of the amount.
    pub fn square_slope(&self) -> (f64, f64) {
        let first = inner(&self.value, &self.slope);
        (first, square(&self.slope) + inner(&self.value, &self.bend))
    }
}

impl Harmonic {
    pub fn empty(key: u32) -> Harmonic {
        Harmonic { key, cos: [0.0; WIDTH], sin: [0.0; WIDTH] }
    }

    /// No less than its amount at any angle.
    fn most(&self) -> f64 {
        length(&self.cos) + length(&self.sin)
    }

    /// Sets to 0 what is rounding of a sum of `own` and of `parts`, these in amount.
    fn clear(&mut self, own: &Harmonic, parts: &Harmonic) {
        let rounding = CANCELLED * (own.most() + parts.most());
        self.cos
            .iter_mut()
            .chain(&mut self.sin)
            .filter(|sum| sum.abs() <= rounding)
            .for_each(|sum| *sum = 0.0);
    }

    fn add(&mut self, other: &Harmonic) {
        for m in 0..WIDTH {
            self.cos[m] += other.cos[m];
            self.sin[m] += other.sin[m];
        }
    }
}

/// What is left of a harmonic when parts of it cancel is rounding below this share of the parts' amounts.
const CANCELLED: f64 = 16.0 * f64::EPSILON;

/// Cosine and sine of rising multiples of an angle, each from the one before.
struct Turns {
    angle: f64,
    key: u32,
    gap: u32,
    /// Of `gap` and of `key` times the angle.
    step: (f64, f64),
    turn: (f64, f64),
}

impl Turns {
    fn of(angle: f64) -> Turns {
        Turns { angle, key: 0, gap: 0, step: (1.0, 0.0), turn: (1.0, 0.0) }
    }

    /// Of `key` times the angle; `key` is no less than the one before.
    fn at(&mut self, key: u32) -> (f64, f64) {
        let gap = key - self.key;
        if gap != self.gap {
            let (sin, cos) = (f64::from(gap) * self.angle).sin_cos();
            (self.gap, self.step) = (gap, (cos, sin));
        }
        let ((c, s), (cos, sin)) = (self.turn, self.step);
        self.turn = (c * cos - s * sin, c * sin + s * cos);
        self.key = key;
        self.turn
    }
}

impl Curve {
    /// A curve of `base` harmonics (keys rising, each once) of which those at `touched` (rising) depend on the variables.
    pub fn new(
        dimension: usize,
        base: Vec<Harmonic>,
        touched: Vec<usize>,
        columns: Matrix,
        grid: &Grid,
    ) -> Curve {
        assert_eq!(columns.rows, touched.len() * 2 * dimension, "invariant: a row for each coefficient");
        let mut on_grid = vec![[0.0; WIDTH]; grid.len()];
        for (_, harmonic) in base.iter().enumerate().filter(|(place, _)| !touched.contains(place)) {
            grid.add(harmonic, &mut on_grid);
        }
        let grain = GRAIN * base.iter().map(Harmonic::most).sum::<f64>();
        Curve { dimension, base, touched, columns, on_grid: Rc::new(on_grid), grain }
    }

    /// The same curve with `x = origin + directions z` put in.
    pub fn restricted(&self, origin: &[f64], directions: &Matrix) -> Curve {
        let Fixed { harmonics, grain, .. } = self.at(origin);
        Curve {
            base: harmonics,
            touched: self.touched.clone(),
            columns: self.columns.product(directions),
            on_grid: Rc::clone(&self.on_grid),
            grain,
            ..*self
        }
    }

    /// The same curve in a unit so many times as large.
    pub fn in_unit(&self, unit: f64) -> Curve {
        let divided = |v: &Vector| v.map(|value| value / unit);
        let base = self.base.iter();
        Curve {
            base: base.map(|h| Harmonic { key: h.key, cos: divided(&h.cos), sin: divided(&h.sin) }).collect(),
            touched: self.touched.clone(),
            columns: self.columns.scaled(1.0 / unit),
            on_grid: Rc::new(self.on_grid.iter().map(divided).collect()),
            grain: self.grain / unit,
            ..*self
        }
    }

    /// The harmonics that coefficients of the touched ones add, with their places.
    fn changes<'a>(&'a self, coefficients: &'a [f64]) -> impl Iterator<Item = (usize, Harmonic)> + 'a {
        let d = self.dimension;
        self.touched.iter().enumerate().map(move |(k, &place)| {
            let mut harmonic = Harmonic::empty(self.base[place].key);
            harmonic.cos[..d].copy_from_slice(&coefficients[2 * k * d..(2 * k + 1) * d]);
            harmonic.sin[..d].copy_from_slice(&coefficients[(2 * k + 1) * d..(2 * k + 2) * d]);
            (place, harmonic)
        })
    }

    /// The curve at `x`.
    pub fn at(&self, x: &[f64]) -> Fixed<'_> {
        let mut harmonics = self.base.clone();
        let mut grain = self.grain;
        let shift = self.columns.times(x);
        let parts = self.columns.amounts(x);
        for ((place, change), (_, parts)) in self.changes(&shift).zip(self.changes(&parts)) {
            let harmonic = &mut harmonics[place];
            let own = *harmonic;
            harmonic.add(&change);
            harmonic.clear(&own, &parts);
            grain += GRAIN * change.most();
        }
        Fixed { curve: self, harmonics, grain }
    }

    /// `G(phi)` as `dimension` rows, and its derivative by `phi`.
    pub fn directions(&self, angle: f64) -> (Matrix, Matrix) {
        let (d, n) = (self.dimension, self.columns.columns);
        let (mut value, mut slope) = (Matrix::zeros(d, n), Matrix::zeros(d, n));
        let mut turns = Turns::of(angle);
        for (k, &place) in self.touched.iter().enumerate() {
            let key = self.base[place].key;
            let (cos, sin) = turns.at(key);
            let key = f64::from(key);
            for m in 0..d {
                for (row, of_value, of_slope) in
                    [(2 * k * d + m, cos, -key * sin), ((2 * k + 1) * d + m, sin, key * cos)]
                {
                    super::dense::add_scaled(value.row_mut(m), of_value, self.columns.row(row));
                    super::dense::add_scaled(slope.row_mut(m), of_slope, self.columns.row(row));
                }
            }
        }
        (value, slope)
    }

    /// Coefficients of the touched harmonics at `x = 0`, in the order of the rows of [`Curve::columns`].
    pub fn touched_coefficients(&self) -> Vec<f64> {
        let d = self.dimension;
        self.touched
            .iter()
            .flat_map(|&p| [self.base[p].cos, self.base[p].sin])
            .flat_map(move |v| v[..d].to_vec())
            .collect()
    }

    /// Sum of the amounts of the harmonics that no variable touches.
    pub fn untouched(&self) -> f64 {
        let outside = self.base.iter().enumerate().filter(|(place, _)| !self.touched.contains(place));
        outside.map(|(_, h)| h.most()).sum()
    }
}

impl Fixed<'_> {
    pub fn jet(&self, angle: f64) -> Jet {
        jet(&self.harmonics, angle)
    }

    /// The components at an angle.
    pub fn value(&self, angle: f64) -> Vec<f64> {
        self.jet(angle).value[..self.curve.dimension].to_vec()
    }

    /// All local maxima of the amount that reach `floor`, the largest first; at least the largest of all.
    ///
    /// Where the amount is the same over a stretch (to rounding) the grid's own angles stand for it.
    pub fn summits(&self, grid: &Grid, floor: f64) -> Vec<Summit> {
        let mut values = (*self.curve.on_grid).clone();
        for &place in &self.curve.touched {
            grid.add(&self.harmonics[place], &mut values);
        }
        let squares: Vec<f64> = values.iter().map(square).collect();
        let (count, step) = (squares.len(), grid.step());
        let highest = squares.iter().copied().fold(0.0, f64::max);
        let threshold = (floor.max(0.0).powi(2)).min(highest);
        let mut summits = Vec::new();
        let mut before = squares[count - 1];
        for (j, &here) in squares.iter().enumerate() {
            let after = squares[if j + 1 == count { 0 } else { j + 1 }];
            let left = std::mem::replace(&mut before, here);
            // A parabola rises by an eighth of the second difference between grid angles; half of it is ample where
            // the grid resolves the curve.
            let bend = 2.0 * here - left - after;
            if here < left || here <= after || here + 0.5 * bend < threshold {
                continue;
            }
            let (mut angle, mut amount) = (step * j as f64, here.sqrt());
            if bend > self.grain * (4.0 * amount + self.grain) {
                let top = 0.5 * (after - left) / bend;
                angle = self.top(angle - step, angle + step, angle + top * step);
                amount = amount.max(length(&self.jet(angle).value));
            }
            summits.push(Summit { angle: angle.rem_euclid(TAU), amount });
        }
        if summits.is_empty() {
            let place = (0..count).find(|&j| squares[j] == highest).unwrap_or(0);
            summits.push(Summit { angle: step * place as f64, amount: highest.sqrt() });
        }
        summits.sort_by(|a, b| b.amount.total_cmp(&a.amount).then(a.angle.total_cmp(&b.angle)));
        summits
    }

    /// The top of the hill that `angle` stands on: uphill in steps of `step` until the slope turns. Where it is flat to
    /// rounding the angle stays.
    pub fn climb(&self, angle: f64, step: f64) -> f64 {
        let here = self.jet(angle);
        let first = here.square_slope().0;
        if first.abs() <= FLAT * here.square() {
            return angle;
        }
        let rises = |at: f64| self.jet(at).square_slope().0 > 0.0;
        let onward = if first > 0.0 { step } else { -step };
        let (mut near, mut far) = (angle, angle + onward);
        let mut left = (TAU / step) as usize;
        while rises(far) == (first > 0.0) {
            (near, far) = (far, far + onward);
            left -= 1;
            if left == 0 {
                return angle;
            }
        }
        if near < far { self.top(near, far, near) } else { self.top(far, near, near) }
    }

    /// The top between two angles: Newton's method on the derivative from `at`, kept in the bracket.
    fn top(&self, mut low: f64, mut high: f64, mut at: f64) -> f64 {
        for _ in 0..60 {
            let (first, second) = self.jet(at).square_slope();
            if first == 0.0 {
                break;
            }
            if first > 0.0 {
                low = at;
            } else {
                high = at;
            }
            let trial = if second < 0.0 { at - first / second } else { f64::NAN };
            let inside = trial > low && trial < high;
            let next = if inside { trial } else { 0.5 * (low + high) };
            let moved = (next - at).abs();
            at = next;
            // The error of a step of Newton's method is of the order of its square.
            if moved <= if inside { CLOSE } else { 1e-15 * (1.0 + at.abs()) } {
                break;
            }
        }
        at
    }
}

fn jet(harmonics: &[Harmonic], angle: f64) -> Jet {
    let mut jet = Jet { value: [0.0; WIDTH], slope: [0.0; WIDTH], bend: [0.0; WIDTH] };
    let mut turns = Turns::of(angle);
    for harmonic in harmonics {
        let (cos, sin) = turns.at(harmonic.key);
        let key = f64::from(harmonic.key);
        for m in 0..WIDTH {
            let value = harmonic.cos[m] * cos + harmonic.sin[m] * sin;
            jet.value[m] += value;
            jet.slope[m] += key * (harmonic.sin[m] * cos - harmonic.cos[m] * sin);
            jet.bend[m] -= key * key * value;
        }
    }
    jet
}

/// Something affine in the variables whose amount is judged: a curve, or a vector that does not depend on the angle.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Member {
    Curve(Curve),
    /// `base + columns x`, as many rows as the vector has components.
    Vector {
        base: Vec<f64>,
        columns: Matrix,
    },
}

/// A member at one choice of the variables.
pub(crate) enum FixedMember<'a> {
    Curve(Fixed<'a>),
    Vector(Vec<f64>),
}

impl FixedMember<'_> {
    /// Value at an angle.
    pub fn value(&self, angle: f64) -> Vec<f64> {
        match self {
            FixedMember::Curve(curve) => curve.value(angle),
            FixedMember::Vector(value) => value.clone(),
        }
    }

    /// Amount at an angle.
    pub fn amount(&self, angle: f64) -> f64 {
        match self {
            FixedMember::Curve(curve) => length(&curve.jet(angle).value),
            FixedMember::Vector(value) => norm(value),
        }
    }

    /// Local maxima that reach `floor`, at least the largest.
    pub fn summits(&self, grid: &Grid, floor: f64) -> Vec<Summit> {
        match self {
            FixedMember::Curve(curve) => curve.summits(grid, floor),
            FixedMember::Vector(value) => vec![Summit { angle: 0.0, amount: norm(value) }],
        }
    }
}

impl Member {
    /// The vector `columns x`.
    pub fn vector(columns: Matrix) -> Member {
        Member::Vector { base: vec![0.0; columns.rows], columns }
    }

    /// The same, divided by `unit`.
    pub fn in_unit(&self, unit: f64) -> Member {
        match self {
            Member::Curve(curve) => Member::Curve(curve.in_unit(unit)),
            Member::Vector { base, columns } => Member::Vector {
                base: base.iter().map(|value| value / unit).collect(),
                columns: columns.scaled(1.0 / unit),
            },
        }
    }

    pub fn dimension(&self) -> usize {
        match self {
            Member::Curve(curve) => curve.dimension,
            Member::Vector { columns, .. } => columns.rows,
        }
    }

    pub fn restricted(&self, origin: &[f64], directions: &Matrix) -> Member {
        match self {
            Member::Curve(curve) => Member::Curve(curve.restricted(origin, directions)),
            Member::Vector { columns, .. } => {
                Member::Vector { base: self.value(0.0, origin), columns: columns.product(directions) }
            }
        }
    }

    /// All its coefficients: rows that depend on the variables.
    pub fn columns(&self) -> &Matrix {
        match self {
            Member::Curve(curve) => &curve.columns,
            Member::Vector { columns, .. } => columns,
        }
    }

    pub fn at(&self, x: &[f64]) -> FixedMember<'_> {
        match self {
            Member::Curve(curve) => FixedMember::Curve(curve.at(x)),
            Member::Vector { base, columns } => {
                let affine = |(m, base): (usize, &f64)| base + dot(columns.row(m), x);
                FixedMember::Vector(base.iter().enumerate().map(affine).collect())
            }
        }
    }

    /// Value at an angle.
    pub fn value(&self, angle: f64, x: &[f64]) -> Vec<f64> {
        self.at(x).value(angle)
    }

    /// Value at an angle where all variables are 0.
    pub fn constant(&self, angle: f64) -> Vec<f64> {
        match self {
            Member::Curve(curve) => jet(&curve.base, angle).value[..curve.dimension].to_vec(),
            Member::Vector { base, .. } => base.clone(),
        }
    }

    /// How the value depends on the variables at an angle: rows, one a component.
    pub fn directions(&self, angle: f64) -> Matrix {
        match self {
            Member::Curve(curve) => curve.directions(angle).0,
            Member::Vector { columns, .. } => columns.clone(),
        }
    }

    /// Local maxima that reach `floor`, at least the largest.
    pub fn summits(&self, grid: &Grid, x: &[f64], floor: f64) -> Vec<Summit> {
        self.at(x).summits(grid, floor)
    }
}

/// Distance of two angles on the circle.
pub(crate) fn apart(a: f64, b: f64) -> f64 {
    let d = (a - b).rem_euclid(TAU);
    d.min(TAU - d)
}
