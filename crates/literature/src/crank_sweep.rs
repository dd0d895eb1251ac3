//! The swept crank optimum of the twin-cylinder thesis: a named method, kept for comparison with the true optimum.
//!
//! All counterweights stand opposite their throws and have the same amount `U` (throws with unlike rotating masses: the
//! same amount beyond them). In the frame that turns with the crank the load is `G_j + U T` at angle `theta_j`, with one
//! constant `T`, so that
//!
//! ```text
//! |G_j + U T|^2 = U^2 |T|^2 + ( |G_j|^2 + 2 U Re(G_j conj T) )
//! ```
//! and the largest of it over all angles is a parabola plus the upper envelope of straight lines. The envelope is
//! built once; each step of the sweep then takes the one angle that its line belongs to, and gives exactly what trying
//! all angles at every step would give.
//!
//! # Source
//! Louvigny, Preliminary design of twin-cylinder engines (2008), section 4.2.2 and figures 22, 36, 46; step and grid
//! are not printed there, and follow from its tables.

use lanchester_balance::BalanceError;
use lanchester_mechanism::{Kinematics, LoadRequest, Mechanism};
use lanchester_model::Engine;
use lanchester_task::Load;
use num_complex::Complex64;
use serde::Serialize;

/// Most steps of a sweep.
const MAX_STEPS: f64 = 1e6;

/// The load whose largest amount a crank is chosen for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CrankLoad {
    /// Resultant force `|F_x + i F_y|` [N].
    Force,
    /// Resultant couple `|M_x + i M_y|` about the origin [N m].
    Couple,
}

impl CrankLoad {
    /// The same load as a balance task names it.
    pub fn load(self) -> Load {
        match self {
            CrankLoad::Force => Load::Force,
            CrankLoad::Couple => Load::Couple,
        }
    }
}

/// Step and grid of a sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepOptions {
    /// Step of the unbalance [kg m]; amounts are whole multiples of it.
    pub step: f64,
    /// Angles of a revolution at which the load is looked at, from `theta = 0`.
    pub angles: usize,
}

impl Default for SweepOptions {
    /// 1e-5 kg m, every degree: those of the thesis.
    fn default() -> Self {
        SweepOptions { step: 1e-5, angles: 360 }
    }
}

impl SweepOptions {
    /// Every degree, in steps of the thesis or, for an engine much larger than its own, of a power of ten that gives
    /// at most 100 000 of them.
    pub fn fitting(engine: &Engine) -> SweepOptions {
        let mut options = SweepOptions::default();
        let most = largest_amount(engine);
        if most / options.step > 1e5 && most.is_finite() {
            options.step = 10f64.powf((most / 1e5).log10().ceil());
        }
        options
    }
}

/// A crank's unbalance with its criterion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SweptCrank {
    /// Counterweight of throw 1 [kg m].
    pub unbalance: f64,
    /// Largest load over the grid of angles [N] or [N m].
    pub criterion: f64,
}

/// The criterion over the unbalance of the crank.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankSweep {
    /// What was judged.
    pub load: CrankLoad,
    /// Step of the unbalance [kg m].
    pub step: f64,
    /// Every step, from no counterweight to one that balances the rotating and all of the reciprocating masses.
    pub steps: Vec<SweptCrank>,
    /// Place of the smallest criterion in `steps`.
    best: usize,
    /// With the basic crank, which balances the rotating masses alone; no step of the sweep.
    pub basic: SweptCrank,
}

impl CrankSweep {
    /// The step with the smallest criterion; the lightest of several.
    pub fn best(&self) -> SweptCrank {
        self.steps[self.best]
    }
}

/// Unbalance of throw 1 with its big ends [kg m]; nothing without throws.
fn first_throw(engine: &Engine) -> f64 {
    if engine.throws.is_empty() { 0.0 } else { engine.rotating_unbalance(0) }
}

/// Counterweight of throw 1 that balances all of its rotating and the largest reciprocating masses of any throw.
fn largest_amount(engine: &Engine) -> f64 {
    let reciprocating = (0..engine.throws.len()).map(|k| {
        let mass: f64 =
            engine.cylinders.iter().filter(|c| c.throw == k).map(|c| c.reciprocating_mass()).sum();
        mass * engine.throws[k].radius
    });
    first_throw(engine).max(0.0) + reciprocating.fold(0.0, f64::max)
}

/// Sweeps the crank of `engine`, whose counterweights are left out and whose shafts are kept, for the smallest largest
/// `load` at the highest speed.
///
/// | argument     | what                                          |
/// |--------------|-----------------------------------------------|
/// | `engine`     | one crankshaft                                |
/// | `kinematics` | motion of the pistons; the thesis: `PowerSeries { max_order: 4, max_power: 5 }` |
/// | `options`    | step [kg m] and grid                          |
///
/// # Errors
/// [`BalanceError::Loads`] where the engine's loads cannot be computed; [`BalanceError::Number`] for a step that is not
/// positive or gives more than a million of them; [`BalanceError::Missing`] where equal counterweights on all throws
/// leave the load as it is.
pub fn sweep(
    engine: &Engine,
    load: CrankLoad,
    kinematics: Kinematics,
    options: &SweepOptions,
) -> Result<CrankSweep, BalanceError> {
    let most = largest_amount(engine);
    let count = (most / options.step).ceil();
    if !(options.step > 0.0 && count <= MAX_STEPS) {
        return Err(BalanceError::Number {
            quantity: "step [kg m]",
            device: "the crank's sweep".to_string(),
            needed: "positive, with at most a million steps to the full reciprocating mass",
            got: options.step,
        });
    }
    let turning = Turning::of(engine, load, kinematics, options.angles)?;
    let envelope = turning.envelope();
    let mut line = 0;
    let steps: Vec<SweptCrank> = (0..=count as usize)
        .map(|k| {
            let unbalance = k as f64 * options.step;
            while line + 1 < envelope.len() && envelope[line].1 <= unbalance {
                line += 1;
            }
            SweptCrank { unbalance, criterion: turning.at(envelope[line].0, unbalance) }
        })
        .collect();
    let best =
        (0..steps.len()).fold(0, |best, k| if steps[k].criterion < steps[best].criterion { k } else { best });
    let unbalance = first_throw(engine);
    let basic = SweptCrank { unbalance, criterion: turning.largest(unbalance) };
    Ok(CrankSweep { load, step: options.step, steps, best, basic })
}

/// A load in the frame that turns with the crank.
struct Turning {
    /// Load without the common amount at every angle [N], [N m].
    rest: Vec<Complex64>,
    /// What a common amount of 1 kg m on every throw adds.
    unit: Complex64,
}

impl Turning {
    fn of(
        engine: &Engine,
        load: CrankLoad,
        kinematics: Kinematics,
        angles: usize,
    ) -> Result<Turning, BalanceError> {
        let request = LoadRequest { kinematics, samples: angles, ..LoadRequest::default() };
        let bare = engine.without_counterweights();
        let trace = Mechanism::new(&bare, &request)?.trace(angles);
        let square = engine.speed.highest * engine.speed.highest;
        let weight = |k: usize| {
            let throw = &engine.throws[k];
            let lever = match load {
                CrankLoad::Force => Complex64::ONE,
                CrankLoad::Couple => Complex64::new(0.0, throw.z),
            };
            -square * lever * Complex64::cis(throw.angle + engine.crankshafts[throw.crankshaft].phase)
        };
        let unit: Complex64 = (0..engine.throws.len()).map(weight).sum();
        let size: f64 = (0..engine.throws.len()).map(|k| weight(k).norm()).sum();
        if unit.norm() <= 1e-9 * size {
            return Err(BalanceError::Missing {
                criterion: "a swept crank".to_string(),
                needed: "throws whose equal counterweights change the load that is judged",
                hint: "sweep the other load, or free the weights one by one",
            });
        }
        let first = first_throw(engine);
        let unlike: Complex64 =
            (0..engine.throws.len()).map(|k| (engine.rotating_unbalance(k) - first) * weight(k)).sum();
        let (x, y) = match load {
            CrankLoad::Force => (&trace.force_x, &trace.force_y),
            CrankLoad::Couple => (&trace.couple_x, &trace.couple_y),
        };
        let rest = trace
            .theta
            .iter()
            .zip(x.iter().zip(y))
            .map(|(theta, (x, y))| Complex64::new(*x, *y) * Complex64::cis(-theta) + unlike)
            .collect();
        Ok(Turning { rest, unit })
    }

    /// Load at one angle.
    fn at(&self, angle: usize, unbalance: f64) -> f64 {
        (self.rest[angle] + unbalance * self.unit).norm()
    }

    /// Largest load over all angles.
    fn largest(&self, unbalance: f64) -> f64 {
        (0..self.rest.len()).map(|j| self.at(j, unbalance)).fold(0.0, f64::max)
    }

    /// Angles whose load is the largest one, by rising unbalance, each with the unbalance up to which it is.
    fn envelope(&self) -> Vec<(usize, f64)> {
        // Lines height + unbalance * slope.
        let lines: Vec<(f64, f64)> =
            self.rest.iter().map(|g| (g.norm_sqr(), 2.0 * (g * self.unit.conj()).re)).collect();
        let mut order: Vec<usize> = (0..lines.len()).collect();
        order.sort_by(|&a, &b| lines[a].1.total_cmp(&lines[b].1).then(lines[a].0.total_cmp(&lines[b].0)));
        // Angles that mirror each other have the same line but for rounding, and no crossing worth the name: the
        // higher one stands for both.
        let steepest = lines.iter().fold(0.0f64, |most, line| most.max(line.1.abs()));
        order.dedup_by(|next, kept| {
            let same = lines[*next].1 - lines[*kept].1 <= 1e-12 * steepest;
            if same && lines[*next].0 > lines[*kept].0 {
                *kept = *next;
            }
            same
        });
        let crossing = |a: usize, b: usize| (lines[a].0 - lines[b].0) / (lines[b].1 - lines[a].1);
        let mut hull: Vec<usize> = Vec::new();
        for line in order {
            while let Some(&last) = hull.last() {
                let hidden = match hull[..] {
                    [.., before, _] => crossing(before, line) <= crossing(before, last),
                    _ => false,
                };
                if !hidden {
                    break;
                }
                hull.pop();
            }
            hull.push(line);
        }
        let ends: Vec<f64> = hull
            .windows(2)
            .map(|pair| crossing(pair[0], pair[1]))
            .chain(std::iter::once(f64::INFINITY))
            .collect();
        hull.into_iter().zip(ends).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_file::{read, template};

    fn engine(name: &str) -> Engine {
        read(template(name).unwrap().text).engine().unwrap()
    }

    /// The thesis's motion and the exact one, over strokes and rods of many sizes.
    #[test]
    fn the_envelope_gives_what_trying_every_angle_gives() {
        let thesis = Kinematics::PowerSeries { max_order: 4, max_power: 5 };
        let layouts = [
            ("twin-360", CrankLoad::Force),
            ("twin-180", CrankLoad::Couple),
            ("single", CrankLoad::Force),
            ("in-line-3", CrankLoad::Couple),
            ("v2-90", CrankLoad::Force),
        ];
        for ((name, load), stretch) in layouts.into_iter().flat_map(|l| (0..6).map(move |k| (l, k))) {
            let mut engine = engine(name);
            let stretch = 1.0 + 0.037 * f64::from(stretch);
            engine = engine
                .with(|engine| {
                    engine.throws.iter_mut().for_each(|throw| throw.radius *= stretch);
                })
                .expect("an engine");
            for kinematics in [thesis, Kinematics::Exact] {
                let swept = sweep(&engine, load, kinematics, &SweepOptions::default()).unwrap();
                let turning = Turning::of(&engine, load, kinematics, 360).unwrap();
                for step in swept.steps.iter().step_by(13) {
                    let all = turning.largest(step.unbalance);
                    let scale = turning.rest.iter().map(|g| g.norm()).fold(0.0, f64::max);
                    assert!((step.criterion - all).abs() <= 1e-11 * scale, "{name} {step:?} {all}");
                }
                let least = swept.steps.iter().map(|s| s.criterion).fold(f64::INFINITY, f64::min);
                assert_eq!(swept.best().criterion, least);
            }
        }
    }

    #[test]
    fn a_step_below_or_above_the_best_is_no_better() {
        let swept =
            sweep(&engine("single"), CrankLoad::Force, Kinematics::Exact, &SweepOptions::default()).unwrap();
        let best = swept.best();
        let turning = Turning::of(&engine("single"), CrankLoad::Force, Kinematics::Exact, 360).unwrap();
        for off in [-1e-5, 1e-5] {
            assert!(turning.largest(best.unbalance + off) >= best.criterion);
        }
        assert!(best.criterion < 0.6 * swept.basic.criterion);
    }

    #[test]
    fn what_the_crank_cannot_change_is_refused() {
        let twin = engine("twin-180");
        let refused = sweep(&twin, CrankLoad::Force, Kinematics::Exact, &SweepOptions::default());
        assert!(matches!(refused, Err(BalanceError::Missing { .. })));
        for step in [0.0, -1e-5, 1e-12, f64::NAN] {
            let options = SweepOptions { step, ..SweepOptions::default() };
            let refused = sweep(&twin, CrankLoad::Couple, Kinematics::Exact, &options);
            assert!(matches!(refused, Err(BalanceError::Number { .. })), "{step}");
        }
    }

    #[test]
    fn a_large_engine_gets_a_coarser_step() {
        let mut ship = engine("single");
        ship = ship
            .with(|ship| {
                ship.cylinders[0].piston_mass = 5000.0;

                ship.throws[0].radius = 1.2;

                ship.cylinders[0].rod.length = 3.0;
            })
            .expect("an engine");
        let options = SweepOptions::fitting(&ship);
        let swept = sweep(&ship, CrankLoad::Force, Kinematics::Exact, &options).unwrap();
        assert!(swept.steps.len() <= 100_002 && options.step > 1e-2);
        assert_eq!(SweepOptions::fitting(&engine("single")), SweepOptions::default());
    }
}
