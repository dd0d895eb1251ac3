//! Loads over one period: the kernel that runs over all angles.
//!
//! Eight angles at a time, all pistons one after another, six sums kept in registers. The angle enters through a table
//! of `cos` and `sin`; the phase of each piston is a rotation of the table. A plain rod costs one square root and one
//! division an angle, an articulated rod two of each:
//!
//! ```text
//! C + i S = r e^{i phi}                 q = S - e           1/W = 1 / sqrt(l^2 - q^2)
//! k  = C / W                            k' = (q k^2 - S) / W
//! s' = -S - q k                         s'' = -C - C k - q k'
//! ```
//! (Symbols as in [`crate::linkage`] and [`crate::train`].)

use crate::train::drive::{Drive, Linkage};
use crate::train::linkage::Slider;
use crate::train::mechanism::{KnuckleMass, Mechanism, Piston, Rotor};
use lanchester_model::Ratio;
use lanchester_numerics::{Kernel, LANES, Lanes, Vectors, dispatch};
use lanchester_results::Trace;
use num_complex::Complex64;

/// Equally spaced angles of one period, with the tables of `cos` and `sin` that the kernel needs.
#[derive(Debug, Clone, PartialEq)]
pub struct AngleGrid {
    /// Angles of crankshaft 1 [rad].
    theta: Vec<f64>,
    tables: Vec<TurnTable>,
}

/// `cos` and `sin` of a speed ratio without sign times all angles, padded to whole [`Lanes`].
#[derive(Debug, Clone, PartialEq)]
struct TurnTable {
    ratio: Ratio,
    cos: Vec<Lanes>,
    sin: Vec<Lanes>,
}

impl AngleGrid {
    /// `samples` equally spaced angles of each of the `revolutions`, for shafts of these ratios.
    pub(crate) fn of(wanted: impl Iterator<Item = Ratio>, revolutions: u32, samples: usize) -> AngleGrid {
        let count = samples * revolutions as usize;
        let period = std::f64::consts::TAU * f64::from(revolutions);
        let theta = (0..count).map(|j| period * j as f64 / count as f64).collect();
        let mut ratios: Vec<Ratio> = Vec::new();
        for ratio in wanted {
            if !ratios.contains(&magnitude(ratio)) {
                ratios.push(magnitude(ratio));
            }
        }
        let tables = ratios
            .into_iter()
            .map(|ratio| {
                let mut cos = vec![Lanes::all(1.0); count.div_ceil(LANES)];
                let mut sin = vec![Lanes::ZERO; count.div_ceil(LANES)];
                for j in 0..count {
                    let entry = table_entry(ratio, revolutions, j, count);
                    (cos[j / LANES].0[j % LANES], sin[j / LANES].0[j % LANES]) = entry;
                }
                TurnTable { ratio, cos, sin }
            })
            .collect();
        AngleGrid { theta, tables }
    }

    /// Angles of crankshaft 1 [rad].
    pub(crate) fn theta(&self) -> &[f64] {
        &self.theta
    }

    /// `cos` and `sin` of table `place` at the angles of one block.
    #[inline(always)]
    pub(crate) fn turn(&self, place: usize, block: usize) -> (Lanes, Lanes) {
        let table = &self.tables[place];
        (table.cos[block], table.sin[block])
    }

    /// Number of angles.
    pub fn len(&self) -> usize {
        self.theta.len()
    }

    /// Whether it has no angles: never.
    pub fn is_empty(&self) -> bool {
        self.theta.is_empty()
    }

    /// Place of the table of a speed ratio.
    pub(crate) fn place(&self, ratio: Ratio) -> usize {
        let size = magnitude(ratio);
        self.tables
            .iter()
            .position(|t| t.ratio == size)
            .expect("invariant: the grid was made for this mechanism")
    }
}

/// The ratio without its sign.
fn magnitude(ratio: Ratio) -> Ratio {
    let numerator = ratio.numerator().saturating_abs();
    Ratio::new(numerator, ratio.denominator()).expect("invariant: a ratio is not 0")
}

/// `cos` and `sin` of `ratio * theta` at angle `j` of `count` in `revolutions`, the angle reduced exactly.
fn table_entry(ratio: Ratio, revolutions: u32, j: usize, count: usize) -> (f64, f64) {
    let per_period =
        u128::from(ratio.numerator().unsigned_abs()) * u128::from(revolutions / ratio.denominator());
    let part = (per_period * j as u128 % count as u128) as f64 / count as f64;
    // The nearest eighth first: symmetric angles get exactly symmetric values.
    let eighth = (part * 8.0).round();
    let (sin, cos) = (std::f64::consts::TAU * (part - eighth / 8.0)).sin_cos();
    const HALF: f64 = std::f64::consts::FRAC_1_SQRT_2;
    match eighth as u32 % 8 {
        0 => (cos, sin),
        1 => (HALF * (cos - sin), HALF * (cos + sin)),
        2 => (-sin, cos),
        3 => (-HALF * (cos + sin), HALF * (cos - sin)),
        4 => (-cos, -sin),
        5 => (HALF * (sin - cos), -HALF * (cos + sin)),
        6 => (sin, -cos),
        _ => (HALF * (cos + sin), HALF * (sin - cos)),
    }
}

/// A rotor as coefficients of `cos` and `sin` of its table, in the order of the six sums.
#[derive(Debug, Clone, PartialEq)]
struct RotorRow {
    table: usize,
    cos: [f64; 6],
    sin: [f64; 6],
}

impl RotorRow {
    fn of(rotor: &Rotor, grid: &AngleGrid) -> RotorRow {
        let [f, m, y] = [rotor.force, rotor.couple, rotor.roll];
        let sign = f64::from(rotor.ratio.numerator().signum());
        RotorRow {
            table: grid.place(rotor.ratio),
            cos: [f.re, f.im, m.re, m.im, y.im, 0.0],
            sin: [-f.im, f.re, -m.im, m.re, y.re, 0.0].map(|c| sign * c),
        }
    }
}

/// A crankpin from its table: `C = r cos phi`, `S = r sin phi`, and the plain rod on it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CrankRow {
    pub table: usize,
    /// `C = cos_cos * cos + cos_sin * sin`.
    cos_cos: f64,
    cos_sin: f64,
    sin_cos: f64,
    sin_sin: f64,
    pub offset: f64,
    length_squared: f64,
}

impl CrankRow {
    pub fn of(piston: &Piston, slider: &Slider, grid: &AngleGrid) -> CrankRow {
        let sign = f64::from(piston.ratio.numerator().signum());
        let (sin, cos) = piston.phase.sin_cos();
        let (sin, cos) = (slider.radius * sin, slider.radius * cos);
        CrankRow {
            table: grid.place(piston.ratio),
            cos_cos: cos,
            cos_sin: -sign * sin,
            sin_cos: sin,
            sin_sin: sign * cos,
            offset: slider.offset,
            length_squared: slider.length * slider.length,
        }
    }
}

/// What a piston's motion does: factors of `s''`, of products of rates, of the rod's spin.
#[derive(Debug, Clone, PartialEq)]
struct MassRow {
    /// `-G`, `-H`, `-R`: five sums from `s''`.
    along: [f64; 5],
    /// `-rate m W^2`, `-rate J W^2`, `J W^2`.
    power: f64,
    spin_power: f64,
    spin: f64,
}

impl MassRow {
    fn of(piston: &Piston) -> MassRow {
        let rate = piston.ratio.value();
        let (f, m) = (piston.force, piston.couple);
        MassRow {
            along: [-f.re, -f.im, -m.re, -m.im, -piston.roll],
            power: -rate * piston.mass,
            spin_power: -rate * piston.inertia,
            spin: piston.inertia,
        }
    }
}

/// An articulated rod.
#[derive(Debug, Clone, PartialEq)]
struct SlaveRow {
    crank: CrankRow,
    mass: MassRow,
    knuckle: Complex64,
    turn: Complex64,
    master_offset: f64,
    offset: f64,
    length_squared: f64,
    /// Force, couple and roll of the knuckle pin's mass a unit of `A'' - B''`.
    excess: [Complex64; 3],
    own: f64,
    own_power: f64,
}

/// A mechanism as the rows that the kernel reads.
#[derive(Debug, Clone, PartialEq)]
pub struct TracePlan {
    grid: AngleGrid,
    rotors: Vec<RotorRow>,
    plain: Vec<(CrankRow, MassRow)>,
    slaves: Vec<SlaveRow>,
    /// Pistons with a truncated motion, which has no such kernel.
    truncated: Option<Mechanism>,
}

impl Mechanism {
    /// `samples` equally spaced angles of every revolution, over one period from `theta = 0`.
    pub fn angle_grid(&self, samples: usize) -> AngleGrid {
        let ratios = self.rotors.iter().map(|r| r.ratio).chain(self.pistons.iter().map(|p| p.ratio));
        AngleGrid::of(ratios, self.revolutions, samples)
    }

    /// Prepares the trace of this mechanism over `grid`.
    pub fn trace_plan(&self, grid: AngleGrid) -> TracePlan {
        let mut plan = TracePlan {
            rotors: self.rotors.iter().map(|r| RotorRow::of(r, &grid)).collect(),
            plain: Vec::new(),
            slaves: Vec::new(),
            truncated: None,
            grid,
        };
        let mut truncated = Vec::new();
        for piston in &self.pistons {
            match &piston.drive {
                Drive::Exact(Linkage::Plain(slider)) => {
                    plan.plain.push((CrankRow::of(piston, slider, &plan.grid), MassRow::of(piston)));
                }
                Drive::Exact(Linkage::Articulated(linkage)) => {
                    let zero = Complex64::ZERO;
                    let none = KnuckleMass { force: zero, couple: zero, roll: zero, mass: 0.0 };
                    let mass = piston.knuckle.as_ref().unwrap_or(&none);
                    plan.slaves.push(SlaveRow {
                        crank: CrankRow::of(piston, &linkage.master, &plan.grid),
                        mass: MassRow::of(piston),
                        knuckle: linkage.knuckle,
                        turn: linkage.turn,
                        master_offset: linkage.master.offset,
                        offset: linkage.offset,
                        length_squared: linkage.length * linkage.length,
                        excess: [mass.force, mass.couple, mass.roll].map(|m| m * linkage.knuckle),
                        own: -mass.mass,
                        own_power: -piston.ratio.value() * mass.mass,
                    });
                }
                Drive::Series { .. } => truncated.push(piston.clone()),
            }
        }
        if !truncated.is_empty() {
            plan.truncated = Some(Mechanism { rotors: Vec::new(), pistons: truncated, ..self.clone() });
        }
        plan
    }

    /// Loads at `samples` equally spaced angles of every revolution, over one period from `theta = 0`.
    pub fn trace(&self, samples: usize) -> Trace {
        let mut trace = Trace::default();
        self.trace_plan(self.angle_grid(samples)).trace_into(&mut trace);
        trace
    }
}

impl TracePlan {
    /// Writes the loads at all angles of the grid; allocates only where `trace` is too small.
    pub fn trace_into(&self, trace: &mut Trace) {
        self.make_room(trace);
        dispatch(TraceKernel { plan: self, trace });
        self.add_truncated(trace);
    }

    /// As [`TracePlan::trace_into`], with the instructions that the program was compiled for alone.
    pub fn trace_into_portable(&self, trace: &mut Trace) {
        self.make_room(trace);
        Vectors::Portable.run(TraceKernel { plan: self, trace });
        self.add_truncated(trace);
    }

    fn make_room(&self, trace: &mut Trace) {
        let count = self.grid.len();
        // Angles are equally spaced from 0: their number and the last one tell them all.
        if trace.theta.len() != count || trace.theta.last() != self.grid.theta.last() {
            trace.theta.clone_from(&self.grid.theta);
        }
        for component in components_mut(trace) {
            component.resize(count, 0.0);
        }
    }

    fn add_truncated(&self, trace: &mut Trace) {
        let Some(mechanism) = &self.truncated else { return };
        for (j, &theta) in self.grid.theta.iter().enumerate() {
            let point = mechanism.components(theta);
            trace.force_x[j] += point.force_x;
            trace.force_y[j] += point.force_y;
            trace.couple_x[j] += point.couple_x;
            trace.couple_y[j] += point.couple_y;
            trace.roll_moment[j] += point.roll_moment;
            trace.shaft_torque[j] += point.shaft_torque;
        }
    }
}

/// The six components in the order of the kernel's sums.
fn components_mut(trace: &mut Trace) -> [&mut Vec<f64>; 6] {
    [
        &mut trace.force_x,
        &mut trace.force_y,
        &mut trace.couple_x,
        &mut trace.couple_y,
        &mut trace.roll_moment,
        &mut trace.shaft_torque,
    ]
}

/// The kernel with its data.
struct TraceKernel<'a> {
    plan: &'a TracePlan,
    trace: &'a mut Trace,
}

/// A crankpin and the plain rod on it at eight angles.
pub(crate) struct RodLanes {
    pub c: Lanes,
    pub s: Lanes,
    pub root: Lanes,
    pub inverse: Lanes,
    pub k: Lanes,
    pub k1: Lanes,
    pub s1: Lanes,
    pub s2: Lanes,
}

impl CrankRow {
    #[inline(always)]
    pub fn rod<const FMA: bool>(&self, cos: Lanes, sin: Lanes) -> RodLanes {
        let c = cos.times_plus::<FMA>(Lanes::all(self.cos_cos), sin * Lanes::all(self.cos_sin));
        let s = cos.times_plus::<FMA>(Lanes::all(self.sin_cos), sin * Lanes::all(self.sin_sin));
        let q = s - Lanes::all(self.offset);
        let square = q.taken_from::<FMA>(q, Lanes::all(self.length_squared));
        let inverse = square.inverse_root();
        let k = c * inverse;
        let k1 = (q * k).times_plus::<FMA>(k, -s) * inverse;
        let s1 = q.taken_from::<FMA>(k, -s);
        let s2 = q.taken_from::<FMA>(k1, c.taken_from::<FMA>(k, -c));
        RodLanes { c, s, root: square * inverse, inverse, k, k1, s1, s2 }
    }
}

impl MassRow {
    #[inline(always)]
    fn add_to<const FMA: bool>(&self, sums: &mut [Lanes; 6], s1: Lanes, s2: Lanes, k: Lanes, k1: Lanes) {
        for (sum, factor) in sums.iter_mut().zip(self.along) {
            *sum = s2.times_plus::<FMA>(Lanes::all(factor), *sum);
        }
        sums[4] = k1.times_plus::<FMA>(Lanes::all(self.spin), sums[4]);
        sums[5] = (s1 * s2).times_plus::<FMA>(Lanes::all(self.power), sums[5]);
        sums[5] = (k * k1).times_plus::<FMA>(Lanes::all(self.spin_power), sums[5]);
    }
}

impl SlaveRow {
    #[inline(always)]
    fn add_to<const FMA: bool>(&self, sums: &mut [Lanes; 6], cos: Lanes, sin: Lanes) {
        let master = self.crank.rod::<FMA>(cos, sin);
        let (c, s) = (master.c, master.s);
        let (kr, ki) = (Lanes::all(self.knuckle.re), Lanes::all(self.knuckle.im));
        let (ar, ai) = (Lanes::all(1.0 - self.knuckle.re), Lanes::all(-self.knuckle.im));
        // (1 - k) e^{i phi} r, of which the pin's part of K, K', K'' are +1, +i and -1 times.
        let pin_re = s.taken_from::<FMA>(ai, c * ar);
        let pin_im = c.times_plus::<FMA>(ai, s * ar);
        let travel = c + master.root;
        let beside = Lanes::all(self.master_offset);
        let k0 = [
            beside.taken_from::<FMA>(ki, travel.times_plus::<FMA>(kr, pin_re)),
            beside.times_plus::<FMA>(kr, travel.times_plus::<FMA>(ki, pin_im)),
        ];
        let k1 = [master.s1.times_plus::<FMA>(kr, -pin_im), master.s1.times_plus::<FMA>(ki, pin_re)];
        let k2 = [master.s2.times_plus::<FMA>(kr, -pin_re), master.s2.times_plus::<FMA>(ki, -pin_im)];
        let (tr, ti) = (Lanes::all(self.turn.re), Lanes::all(self.turn.im));
        let along = |k: [Lanes; 2]| k[1].taken_from::<FMA>(ti, k[0] * tr);
        let beside = |k: [Lanes; 2]| k[1].times_plus::<FMA>(tr, k[0] * ti);
        let q = beside(k0) - Lanes::all(self.offset);
        let (q1, q2) = (beside(k1), beside(k2));
        let inverse = q.taken_from::<FMA>(q, Lanes::all(self.length_squared)).inverse_root();
        let k = q1 * inverse;
        let rate = (q * k).times_plus::<FMA>(k, q2) * inverse;
        let s1 = q.taken_from::<FMA>(k, along(k1));
        let s2 = q.taken_from::<FMA>(rate, q1.taken_from::<FMA>(k, along(k2)));
        self.mass.add_to::<FMA>(sums, s1, s2, k, rate);

        // A'' - B'' in the master's frame.
        let (excess_re, excess_im) = (-(c + master.s2), -s);
        let [force, couple, roll] = self.excess;
        for (at, mass) in [(0, force), (2, couple)] {
            let (re, im) = (Lanes::all(mass.re), Lanes::all(mass.im));
            sums[at] = excess_im.taken_from::<FMA>(im, excess_re.times_plus::<FMA>(re, sums[at]));
            sums[at + 1] = excess_im.times_plus::<FMA>(re, excess_re.times_plus::<FMA>(im, sums[at + 1]));
        }
        let (re, im) = (Lanes::all(roll.re), Lanes::all(roll.im));
        sums[4] = excess_im.times_plus::<FMA>(re, excess_re.times_plus::<FMA>(im, sums[4]));
        let moment = k0[1].taken_from::<FMA>(k2[0], k0[0] * k2[1]);
        sums[4] = moment.times_plus::<FMA>(Lanes::all(self.own), sums[4]);
        let power = k1[1].times_plus::<FMA>(k2[1], k1[0] * k2[0]);
        sums[5] = power.times_plus::<FMA>(Lanes::all(self.own_power), sums[5]);
    }
}

impl Kernel for TraceKernel<'_> {
    #[inline(always)]
    fn run<const FMA: bool>(self) {
        let TraceKernel { plan, trace } = self;
        let count = plan.grid.len();
        let [fx, fy, mx, my, roll, torque] = components_mut(trace);
        let out: [&mut [f64]; 6] = [fx, fy, mx, my, roll, torque];
        for component in &out {
            assert_eq!(component.len(), count, "invariant: room was made for every angle");
        }
        let tail = count % LANES;
        for block in 0..count.div_ceil(LANES) {
            let sums = plan.sums::<FMA>(block);
            let from = block * LANES;
            for n in 0..6 {
                if let Some(room) = out[n].get_mut(from..from + LANES) {
                    room.copy_from_slice(&sums[n].0);
                } else {
                    out[n][from..].copy_from_slice(&sums[n].0[..tail]);
                }
            }
        }
    }
}

impl TracePlan {
    /// The six sums at the angles of one block.
    #[inline(always)]
    fn sums<const FMA: bool>(&self, block: usize) -> [Lanes; 6] {
        let mut sums = [Lanes::ZERO; 6];
        let at = |table: usize| self.grid.turn(table, block);
        for row in &self.rotors {
            let (cos, sin) = at(row.table);
            for (n, sum) in sums.iter_mut().enumerate() {
                let turned = sin.times_plus::<FMA>(Lanes::all(row.sin[n]), *sum);
                *sum = cos.times_plus::<FMA>(Lanes::all(row.cos[n]), turned);
            }
        }
        for (crank, mass) in &self.plain {
            let (cos, sin) = at(crank.table);
            let rod = crank.rod::<FMA>(cos, sin);
            mass.add_to::<FMA>(&mut sums, rod.s1, rod.s2, rod.k, rod.k1);
        }
        for row in &self.slaves {
            let (cos, sin) = at(row.crank.table);
            row.add_to::<FMA>(&mut sums, cos, sin);
        }
        sums[4] = sums[4] - sums[5];
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LoadRequest;
    use lanchester_file::{read, template};

    /// Every variant by itself: `dispatch` would only ever run the best that the machine has.
    #[test]
    fn every_instruction_set_gives_the_same_trace() {
        for name in ["v6-60", "radial-9", "opposed-piston-3"] {
            let engine =
                read(template(name).expect("it is in the gallery").text).engine().expect("it is valid");
            let mechanism = Mechanism::new(&engine, &LoadRequest::default()).expect("it is valid");
            let plan = mechanism.trace_plan(mechanism.angle_grid(90));
            let mut portable = Trace::default();
            plan.trace_into_portable(&mut portable);
            let mut traces = Vec::new();
            for vectors in Vectors::available() {
                let mut trace = Trace::default();
                plan.make_room(&mut trace);
                vectors.run(TraceKernel { plan: &plan, trace: &mut trace });
                traces.push(trace);
            }
            for mut trace in traces {
                for (component, expected) in
                    components_mut(&mut trace).into_iter().zip(components_mut(&mut portable))
                {
                    // What cancels in the sum is no larger than one cylinder's loads, some 1e5 N or N m here.
                    let largest =
                        component.iter().zip(expected.iter()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    assert!(largest <= 1e-13 * 1e6, "{name}: {largest}");
                }
            }
        }
    }
}
