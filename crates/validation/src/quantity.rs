//! Our quantities by the names that the data files use.
//!
//! | name | what it is |
//! |---|---|
//! | `Fx max`, `Fy max`, `Mx max`, `My max` | largest absolute value |
//! | `Fres max`, `dFres` | largest resultant force; largest minus smallest |
//! | `Mz max`, `Mres max`, `dMres` | the twin thesis's own: `M_z` of shafts and weights alone, `M_res = sqrt(M_x² + M_y² + M_z²)` |
//! | `Fx`, `Fx at 0 deg`, `Fx min`, `angle of Fx min` | over the angle; at theta = 0; amount and place of the smallest value |
//! | `F order n`, `M order n` | largest resultant of one order; with `forward` or `backward` before it, that part alone |
//! | `Fx order n` | amplitude along x |
//! | `U ... order n`, `UM ... order n` | force and couple over `(n ω)²`: unbalance, and unbalance times lever |
//! | `M angle order n`, `M last angle order n` | first and last crank angle in half a turn where the couple of one order is largest |
//! | `any F order n`, `any F above order n` | Yes if it is more than a millionth of one cylinder's first order |
//!
//! `... of rotating + reciprocating`, `... of cylinder 1` takes a name from these alone. The rest are data of the
//! engine, see [`EngineDatum`]; `a plus b` adds them. Devices that a method fits: [`DeviceKey`]. Shapes of counterweights:
//! [`ShapeKey`]. Where a piston is: [`PistonKey`]. Forces at mounts: [`MountKey`]. What the gas does: [`GasKey`]. The bond graph: [`GraphKey`]. Static stress: [`StressKey`].
//! The flexible crankshaft over the cycle: [`CycleKey`]. Torsion: [`TorsionKey`]. Runs in time: [`RunKey`]. Workshop sheets:
//! [`WorkshopKey`]. Mechanisms: [`MechanismKey`]. Oil films: [`FilmKey`]. Elastic bodies: [`ElasticKey`].

mod mount;
mod piston;
mod torsion;

use crate::case::Run;
use crate::crank_cycle::{CycleKey, cycle_of};
use crate::gas::GasKey;
use crate::graph::GraphKey;
use crate::method::DeviceKey;
use crate::rigid_run::RunKey;
use crate::shape::ShapeKey;
use crate::standalone::elastic::ElasticKey;
use crate::standalone::film::FilmKey;
use crate::standalone::mechanism::MechanismKey;
use crate::stress::{StressKey, StressRun};
use crate::value::Value;
use crate::workshop::WorkshopKey;
use lanchester::mechanism::Part;
use lanchester::model::Engine;
use lanchester::results::{Extremes, LoadSet};
use mount::MountKey;
use num_complex::Complex64;
use piston::PistonKey;
use torsion::TorsionKey;

/// A quantity of a run.
pub(crate) enum Key {
    /// Of the engine itself, the sum of these.
    Engine(Vec<EngineDatum>),
    /// Of the loads of some parts.
    Loads(LoadKey, Selection),
    /// Largest piston acceleration [m/s²].
    PistonAcceleration,
    /// Where a piston is.
    Piston(PistonKey),
    /// Of a device of the engine.
    Device(DeviceKey),
    /// Of a counterweight's shape.
    Shape(ShapeKey),
    /// Of a mount.
    Mount(MountKey),
    /// Of the gas.
    Gas(GasKey),
    /// Of the bond graph.
    Graph(GraphKey),
    /// In torsion.
    Torsion(TorsionKey),
    /// Of a flexible crankshaft over the cycle.
    Cycle(CycleKey),
    /// Of a case of static stress.
    Stress(StressKey),
    /// Of a run in time.
    Run(RunKey),
    /// Of a mechanism that is no engine.
    Mechanism(MechanismKey),
    /// Of an oil film that belongs to no engine.
    Film(FilmKey),
    /// Of an elastic body that belongs to no engine.
    Elastic(ElasticKey),
    /// Of a workshop sheet.
    Workshop(WorkshopKey),
}

/// A datum of the engine as it was read.
#[derive(Clone, Copy)]
pub(crate) enum EngineDatum {
    Speed,
    RodRatio,
    RodRatioToTheFifth,
    PistonMass,
    RodMass,
    RodLength,
    OscillatingMass,
    /// Crank and rod big ends of throw 1 over its radius.
    RotatingMass,
    /// Crank and rod big ends of throw 1.
    ThrowUnbalance,
    /// Counterweights less the crank's own unbalance, for each cylinder.
    HalfCrankUnbalance,
    /// Counterweights in the plane of throw 1.
    ThrowCounterweights,
    FrontShaftWeight,
    RearShaftWeight,
    CylinderDistance,
    /// Swept volume of all cylinders.
    Displacement,
}

/// A quantity of loads.
pub(crate) enum LoadKey {
    Peak(PeakKey),
    Trace,
    AtZero,
    LargestNegative,
    AngleOfLargestNegative,
    Order { vector: Vector, sense: Sense, unbalance: bool, order: u32 },
    CoupleAngle { order: u32, last: bool },
    Any { vector: Vector, order: u32, above: bool },
}

/// Extremes of the whole engine.
#[derive(Clone, Copy)]
pub(crate) enum PeakKey {
    ForceX,
    ForceY,
    Force,
    ForceRange,
    CoupleX,
    CoupleY,
    RollOfShafts,
    Moment,
    MomentRange,
}

/// Force, its component along x, or couple.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Vector {
    Force,
    ForceX,
    Couple,
}

/// Which half of the two-sided spectrum.
#[derive(Clone, Copy)]
pub(crate) enum Sense {
    Both,
    Forward,
    Backward,
}

/// Whose loads.
pub(crate) enum Selection {
    Total,
    Parts(Vec<Part>),
    Cylinder(usize),
}

const ENGINE_DATA: [(&str, EngineDatum); 15] = [
    ("speed", EngineDatum::Speed),
    ("rod ratio", EngineDatum::RodRatio),
    ("rod ratio^5", EngineDatum::RodRatioToTheFifth),
    ("piston mass", EngineDatum::PistonMass),
    ("rod mass", EngineDatum::RodMass),
    ("rod length", EngineDatum::RodLength),
    ("oscillating mass", EngineDatum::OscillatingMass),
    ("rotating mass", EngineDatum::RotatingMass),
    ("throw unbalance", EngineDatum::ThrowUnbalance),
    ("half crank unbalance", EngineDatum::HalfCrankUnbalance),
    ("throw counterweights", EngineDatum::ThrowCounterweights),
    ("front shaft weight", EngineDatum::FrontShaftWeight),
    ("rear shaft weight", EngineDatum::RearShaftWeight),
    ("cylinder distance", EngineDatum::CylinderDistance),
    ("displacement", EngineDatum::Displacement),
];

const PEAKS: [(&str, PeakKey); 9] = [
    ("Fx max", PeakKey::ForceX),
    ("Fy max", PeakKey::ForceY),
    ("Fres max", PeakKey::Force),
    ("dFres", PeakKey::ForceRange),
    ("Mx max", PeakKey::CoupleX),
    ("My max", PeakKey::CoupleY),
    ("Mz max", PeakKey::RollOfShafts),
    ("Mres max", PeakKey::Moment),
    ("dMres", PeakKey::MomentRange),
];

impl Key {
    /// The quantity of this name.
    pub fn parse(text: &str) -> Result<Key, String> {
        let unknown = || format!("no quantity is called {text:?}");
        if text == "piston acceleration" {
            return Ok(Key::PistonAcceleration);
        }
        if let Some(piston) = PistonKey::parse(text) {
            return Ok(Key::Piston(piston));
        }
        let datum = |text: &str| Some(ENGINE_DATA.iter().find(|(name, _)| *name == text)?.1);
        if let Some(data) = text.split(" plus ").map(datum).collect() {
            return Ok(Key::Engine(data));
        }
        if let Some(device) = DeviceKey::parse(text) {
            return Ok(Key::Device(device));
        }
        if let Some(shape) = ShapeKey::parse(text) {
            return Ok(Key::Shape(shape));
        }
        if let Some(mount) = MountKey::parse(text) {
            return Ok(Key::Mount(mount));
        }
        if let Some(film) = FilmKey::parse(text) {
            return Ok(Key::Film(film));
        }
        if let Some(elastic) = ElasticKey::parse(text) {
            return Ok(Key::Elastic(elastic));
        }
        if let Some(mechanism) = MechanismKey::parse(text) {
            return Ok(Key::Mechanism(mechanism));
        }
        if let Some(workshop) = WorkshopKey::parse(text) {
            return Ok(Key::Workshop(workshop));
        }
        if let Some(gas) = GasKey::parse(text) {
            return Ok(Key::Gas(gas));
        }
        if let Some(torsion) = TorsionKey::parse(text) {
            return Ok(Key::Torsion(torsion));
        }
        if let Some(cycle) = CycleKey::parse(text) {
            return Ok(Key::Cycle(cycle));
        }
        if let Some(stress) = StressKey::parse(text) {
            return Ok(Key::Stress(stress));
        }
        if let Some(graph) = GraphKey::parse(text) {
            return Ok(Key::Graph(graph));
        }
        if let Some(run) = RunKey::parse(text) {
            return Ok(Key::Run(run));
        }
        let (name, selection) = match text.split_once(" of ") {
            Some((name, whose)) if name != "angle" => (name, Selection::parse(whose)?),
            _ => (text, Selection::Total),
        };
        let key = LoadKey::parse(name).ok_or_else(unknown)?;
        Ok(Key::Loads(key, selection))
    }

    /// Its value.
    pub fn of(&self, run: &Run) -> Result<Value, String> {
        match self {
            Key::Engine(data) => {
                let values: Vec<f64> = data.iter().map(|d| d.of(&run.engine)).collect::<Result<_, _>>()?;
                Ok(Value::Number(values.iter().sum()))
            }
            Key::PistonAcceleration => {
                let amounts = run.loads.motion.iter().map(|m| m.max_acceleration.max(m.max_deceleration));
                Ok(Value::Number(amounts.fold(0.0, f64::max)))
            }
            Key::Loads(key, selection) => key.of(run, selection),
            Key::Piston(piston) => piston.of(run).map(Value::Number),
            Key::Device(device) => device.of(&run.engine).map(Value::Number),
            Key::Shape(shape) => shape.of(&run.shape).map(Value::Number),
            Key::Mount(mount) => mount.of(run).map(Value::Number),
            Key::Gas(gas) => gas.of(run).map(Value::Number),
            Key::Graph(graph) => graph.of(&run.engine).map(Value::Number),
            Key::Torsion(torsion) => torsion.of(&run.file).map(Value::Number),
            Key::Cycle(cycle) => {
                let found = run.cycle.get_or_init(|| cycle_of(&run.engine, &run.stress_fit));
                cycle.of(found.as_ref().map_err(Clone::clone)?).map(Value::Number)
            }
            Key::Stress(stress) => {
                let found = run.stress.get_or_init(|| StressRun::of(&run.engine, &run.stress_fit));
                found.as_ref().map(|found| Value::Number(stress.of(found))).map_err(Clone::clone)
            }
            Key::Run(key) => key.of(run).map(Value::Number),
            Key::Film(_) => Err("an engine is no film of its own".to_string()),
            Key::Elastic(_) => Err("an engine is no elastic body of its own".to_string()),
            Key::Mechanism(_) => Err("an engine is no mechanism of its own".to_string()),
            Key::Workshop(_) => Err("an engine is no workshop sheet".to_string()),
        }
    }

    /// Its value, which must be a number.
    pub fn number_of(&self, run: &Run) -> Result<f64, String> {
        self.of(run)?.number().ok_or_else(|| "only numbers can be compared".to_string())
    }

    /// Its values over the angle.
    pub fn trace_of(&self, run: &Run) -> Result<Vec<f64>, String> {
        match self {
            Key::Loads(LoadKey::Trace, selection) => Ok(force_x(&selection.sets(run)?)),
            _ => Err("a mean error needs a quantity over the angle".to_string()),
        }
    }
}

impl Selection {
    /// The selection of this name.
    pub fn parse(text: &str) -> Result<Selection, String> {
        if let Some(number) = text.strip_prefix("cylinder ") {
            return number.parse().map(Selection::Cylinder).map_err(|_| format!("{number:?} is no cylinder"));
        }
        let part = |name: &str| match name {
            "rotating" => Ok(Part::Rotating),
            "reciprocating" => Ok(Part::Reciprocating),
            "counterweights" => Ok(Part::Counterweights),
            "shafts" => Ok(Part::Shafts),
            _ => Err(format!("no part is called {name:?}")),
        };
        text.split(" + ").map(part).collect::<Result<_, _>>().map(Selection::Parts)
    }

    /// Their loads.
    pub fn sets<'a>(&self, run: &'a Run) -> Result<Vec<&'a LoadSet>, String> {
        match self {
            Selection::Total => Ok(vec![&run.loads.total]),
            Selection::Parts(parts) => {
                Ok(run.loads.parts.iter().filter(|p| parts.contains(&p.part)).map(|p| &p.loads).collect())
            }
            Selection::Cylinder(number) => {
                let of = run.loads.cylinders.iter().find(|c| c.cylinder == *number);
                Ok(vec![&of.ok_or_else(|| format!("the engine has no cylinder {number}"))?.loads])
            }
        }
    }
}

impl EngineDatum {
    fn of(self, engine: &Engine) -> Result<f64, String> {
        let missing = |what: &str| format!("the engine has no {what}");
        let throw = engine.throws.first().ok_or_else(|| missing("throw"))?;
        let cylinder = engine.cylinders.first().ok_or_else(|| missing("cylinder"))?;
        let shaft_weights =
            || engine.shafts.first().map(|s| &s.weights).ok_or_else(|| missing("balance shaft"));
        let throw_unbalance = throw.unbalance + engine.rod_unbalance(0);
        Ok(match self {
            EngineDatum::Speed => engine.speed.highest,
            EngineDatum::RodRatio => throw.radius / cylinder.rod.length,
            EngineDatum::RodRatioToTheFifth => (throw.radius / cylinder.rod.length).powi(5),
            EngineDatum::PistonMass => cylinder.piston_mass,
            EngineDatum::RodMass => cylinder.rod.mass(),
            EngineDatum::RodLength => cylinder.rod.length,
            EngineDatum::OscillatingMass => cylinder.reciprocating_mass(),
            EngineDatum::RotatingMass => throw_unbalance / throw.radius,
            EngineDatum::ThrowUnbalance => throw_unbalance,
            EngineDatum::HalfCrankUnbalance => {
                let weights: f64 = engine.counterweights.iter().map(|w| w.unbalance).sum();
                let throws: f64 = engine.throws.iter().map(|t| t.unbalance).sum();
                (weights - throws) / engine.cylinders.len() as f64
            }
            EngineDatum::ThrowCounterweights => {
                engine.counterweights.iter().filter(|w| w.z == throw.z).map(|w| w.unbalance).sum()
            }
            EngineDatum::FrontShaftWeight => {
                shaft_weights()?.first().ok_or_else(|| missing("weight"))?.unbalance
            }
            EngineDatum::RearShaftWeight => {
                shaft_weights()?.last().ok_or_else(|| missing("weight"))?.unbalance
            }
            EngineDatum::CylinderDistance => {
                (engine.cylinders.get(1).ok_or_else(|| missing("second cylinder"))?.z - cylinder.z).abs()
            }
            EngineDatum::Displacement => {
                let volume = |bore: f64| std::f64::consts::PI / 4.0 * bore * bore * 2.0 * throw.radius;
                volume(cylinder.bore.ok_or_else(|| missing("bore"))?) * engine.cylinders.len() as f64
            }
        })
    }
}

impl LoadKey {
    fn parse(name: &str) -> Option<LoadKey> {
        if let Some(&(_, peak)) = PEAKS.iter().find(|(peak, _)| *peak == name) {
            return Some(LoadKey::Peak(peak));
        }
        match name {
            "Fx" => return Some(LoadKey::Trace),
            "Fx at 0 deg" => return Some(LoadKey::AtZero),
            "Fx min" => return Some(LoadKey::LargestNegative),
            "angle of Fx min" => return Some(LoadKey::AngleOfLargestNegative),
            _ => {}
        }
        let (words, order) = name.rsplit_once(" order ")?;
        let order = order.parse().ok()?;
        let vector = |word: &str| match word {
            "F" | "U" => Some(Vector::Force),
            "Fx" => Some(Vector::ForceX),
            "M" | "UM" => Some(Vector::Couple),
            _ => None,
        };
        let words: Vec<&str> = words.split(' ').collect();
        Some(match words[..] {
            ["M", "angle"] => LoadKey::CoupleAngle { order, last: false },
            ["M", "last", "angle"] => LoadKey::CoupleAngle { order, last: true },
            ["any", v] => LoadKey::Any { vector: vector(v)?, order, above: false },
            ["any", v, "above"] => LoadKey::Any { vector: vector(v)?, order, above: true },
            [v, ref sense @ ..] => {
                let sense = match sense {
                    [] => Sense::Both,
                    ["forward"] => Sense::Forward,
                    ["backward"] => Sense::Backward,
                    _ => return None,
                };
                LoadKey::Order { vector: vector(v)?, sense, unbalance: v.starts_with('U'), order }
            }
            [] => return None,
        })
    }

    fn of(&self, run: &Run, selection: &Selection) -> Result<Value, String> {
        let sets = selection.sets(run)?;
        Ok(Value::Number(match self {
            LoadKey::Peak(peak) => {
                let Selection::Total = selection else {
                    return Err("peaks are of the whole engine".to_string());
                };
                peak.of(run)
            }
            LoadKey::Trace => return Err("a force over the angle can only be compared".to_string()),
            LoadKey::AtZero => force_x(&sets).first().copied().unwrap_or(0.0),
            LoadKey::LargestNegative => -run.loads.total.peaks.force_x.min.value,
            LoadKey::AngleOfLargestNegative => run.loads.total.peaks.force_x.min.theta.to_degrees(),
            LoadKey::Order { vector, sense, unbalance, order } => {
                let amplitude = amplitude(&halves(&sets, *vector, f64::from(*order)), *vector, *sense);
                if *unbalance { amplitude / (f64::from(*order) * run.loads.speed).powi(2) } else { amplitude }
            }
            LoadKey::CoupleAngle { order, last } => {
                let (forward, backward) = halves(&sets, Vector::Couple, f64::from(*order));
                let step = std::f64::consts::PI / f64::from(*order);
                let first = ((backward.arg() - forward.arg()) / (2.0 * f64::from(*order))).rem_euclid(step);
                (if *last { first + (f64::from(*order) - 1.0) * step } else { first }).to_degrees()
            }
            LoadKey::Any { vector, order, above } => {
                let bound = f64::from(*order);
                let counts = |n: &f64| if *above { *n > bound } else { *n == bound };
                let orders = run.loads.total.orders.iter().map(|o| o.order).filter(counts);
                let peaks = orders.map(|n| amplitude(&halves(&sets, *vector, n), *vector, Sense::Both));
                let largest = peaks.fold(0.0, f64::max);
                return Ok(Value::Word(if largest > negligible(run, *vector)? { "Yes" } else { "No" }));
            }
        }))
    }
}

/// A millionth of one cylinder's first-order force, for couples times the distance of the cylinders.
fn negligible(run: &Run, vector: Vector) -> Result<f64, String> {
    let engine = &run.engine;
    let lever = if vector == Vector::Couple { EngineDatum::CylinderDistance.of(engine)? } else { 1.0 };
    let mass = EngineDatum::OscillatingMass.of(engine)?;
    Ok(1e-6 * lever * mass * engine.throws[0].radius * run.loads.speed.powi(2))
}

fn force_x(sets: &[&LoadSet]) -> Vec<f64> {
    let angles = sets.iter().map(|s| s.trace.force_x.len()).max().unwrap_or(0);
    (0..angles).map(|i| sets.iter().map(|s| s.trace.force_x[i]).sum()).collect()
}

/// Forward and backward part of one order, summed over sets.
fn halves(sets: &[&LoadSet], vector: Vector, order: f64) -> (Complex64, Complex64) {
    let of_order = sets.iter().flat_map(|s| &s.orders).filter(|o| o.order == order);
    of_order.fold(Default::default(), |(forward, backward), o| match vector {
        Vector::Couple => (forward + o.couple_forward, backward + o.couple_backward),
        Vector::Force | Vector::ForceX => (forward + o.force_forward, backward + o.force_backward),
    })
}

fn amplitude((forward, backward): &(Complex64, Complex64), vector: Vector, sense: Sense) -> f64 {
    match (vector, sense) {
        (_, Sense::Forward) => forward.norm(),
        (_, Sense::Backward) => backward.norm(),
        // The x part of f e^{iθ} + b e^{-iθ} is Re((f + conj b) e^{iθ}).
        (Vector::ForceX, Sense::Both) => (forward + backward.conj()).norm(),
        (_, Sense::Both) => forward.norm() + backward.norm(),
    }
}

impl PeakKey {
    fn of(self, run: &Run) -> f64 {
        let peaks = &run.loads.total.peaks;
        let range = |e: &Extremes| e.range();
        match self {
            PeakKey::ForceX => peaks.force_x.max_abs(),
            PeakKey::ForceY => peaks.force_y.max_abs(),
            PeakKey::Force => peaks.force.max.value,
            PeakKey::ForceRange => range(&peaks.force),
            PeakKey::CoupleX => peaks.couple_x.max_abs(),
            PeakKey::CoupleY => peaks.couple_y.max_abs(),
            PeakKey::RollOfShafts => largest(run.roll_of_shafts().into_iter().map(f64::abs)),
            PeakKey::Moment => largest(thesis_moment(run)),
            PeakKey::MomentRange => {
                let smallest = thesis_moment(run).into_iter().fold(f64::INFINITY, f64::min);
                largest(thesis_moment(run)) - smallest
            }
        }
    }
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, f64::max)
}

/// The twin thesis's `M_res = sqrt(M_x² + M_y² + M_z²)` with its own `M_z`.
pub(crate) fn thesis_moment(run: &Run) -> Vec<f64> {
    let trace = &run.loads.total.trace;
    let roll = run.roll_of_shafts();
    trace.couple_x.iter().zip(&trace.couple_y).zip(roll).map(|((x, y), z)| x.hypot(*y).hypot(z)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        for name in
            ["Fx max", "Fx order 1", "UM backward order 2 of rotating + reciprocating", "any M above order 1"]
        {
            assert!(Key::parse(name).is_ok(), "{name}");
        }
        for name in
            ["", "Fz max", "F order", "F sideways order 1", "F order 1 of nothing", "any F beside order 1"]
        {
            assert!(Key::parse(name).is_err(), "{name}");
        }
    }

    #[test]
    fn amplitude_along_x_and_resultant() {
        // Turning with the crank: 3 along every direction. Against it as well: 5 along x, 1 along y.
        let halves = (Complex64::new(3.0, 0.0), Complex64::new(2.0, 0.0));
        let of = |vector, sense| amplitude(&halves, vector, sense);
        assert_eq!(of(Vector::Force, Sense::Both), 5.0);
        assert_eq!(of(Vector::ForceX, Sense::Both), 5.0);
        assert_eq!(of(Vector::Force, Sense::Backward), 2.0);
        let opposed = (Complex64::new(3.0, 0.0), Complex64::new(-2.0, 0.0));
        assert_eq!(amplitude(&opposed, Vector::ForceX, Sense::Both), 1.0);
    }
}
