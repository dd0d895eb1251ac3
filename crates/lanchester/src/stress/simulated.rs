//! Loads of a crankshaft from a simulated run: its pin forces at single instants, with the speed and the angular acceleration there.
//!
//! ```text
//! b = rho (W^2 (x, y, 0) - W' (-y, x, 0))        W, W': speed and angular acceleration of the crankshaft at that instant       (book, eq. 43.19)
//! ```

use crate::pressure::measured::TraceFile;
use crate::simulation::{SimulateRequest, simulate};
use crate::stress::named_load::{Extremes, MOST_ANGLES, NamedLoad, NamedLoads, SIZES, given};
use crate::stress::request::{SimulatedSource, StaticRequest, StressError, StressLoad};
use lanchester_file::EngineFile;
use lanchester_mechanism::ThrowForce;
use lanchester_model::Engine;
use lanchester_multibody::{Reactions, RunOutcome, Samples};
use lanchester_report::{PinForces, SimulationResult};
use lanchester_task::Tasks;
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Points through which forces between samples are interpolated.
const POINTS: usize = 4;

/// Loads of all runs that a request asks for.
pub(crate) fn simulated_loads(
    engine: &Engine,
    traces: &[TraceFile],
    request: &StaticRequest,
    source: &SimulatedSource,
) -> Result<NamedLoads, StressError> {
    let tasks = Tasks { simulation: source.input.clone().map(Box::new), ..Tasks::default() };
    let file = EngineFile { engine: engine.clone(), tasks };
    let speeds: Vec<Option<f64>> = match request.speeds.as_slice() {
        [] => vec![source.request.speed],
        speeds => speeds.iter().copied().map(Some).collect(),
    };
    let (mut loads, mut gas, mut notes) = (Vec::new(), None, Vec::new());
    for speed in speeds {
        let asked = SimulateRequest {
            speed,
            gas: if request.gas { source.request.gas } else { Some(false) },
            ..source.request.clone()
        };
        let found =
            simulate(&file, traces, &asked).map_err(|error| StressError::Simulation(Box::new(error)))?;
        let run = PinRun::of(engine, request.mesh.crankshaft, &found)?;
        loads.extend(match &request.load {
            StressLoad::Angles(angles) => run.at_angles(engine, angles)?,
            _ => run.extremes(engine)?,
        });
        notes.push(words(&found));
        if matches!(
            found.run.outcome,
            RunOutcome::Cancelled | RunOutcome::TooManyEvaluations | RunOutcome::Failed { .. }
        ) {
            notes.push("That run is incomplete: loads are those of the samples before its end.".to_owned());
        }
        notes.extend(found.notes.iter().filter(|note| !notes.contains(note)).cloned().collect::<Vec<_>>());
        gas = found.gas.or(gas);
    }
    Ok(NamedLoads { loads, gas, notes })
}

/// What ran.
fn words(found: &SimulationResult) -> String {
    let [time, theta, speed] = found.run.end;
    format!(
        "Forces of a simulated run of {:.4} s, {:.2} revolutions, to {:.0} rpm, among its samples; the crankshaft's own centrifugal field and its angular acceleration of that \
         instant act. Its own weight does not.",
        time,
        theta / TAU,
        speed * 30.0 / PI
    )
}

/// Forces on the pins of one crankshaft over a run.
struct PinRun<'a> {
    samples: &'a Samples,
    crankshaft: usize,
    /// Indices of its throws.
    throws: Vec<usize>,
    /// Cylinders of each throw.
    cylinders: Vec<Vec<usize>>,
    /// Crank angle after which all stands as before [rad].
    period: f64,
}

/// The state of a run at a place between its samples.
struct Instant {
    time: f64,
    theta: f64,
    speed: f64,
    acceleration: f64,
    forces: Vec<PinForces>,
}

impl<'a> PinRun<'a> {
    fn of(
        engine: &Engine,
        crankshaft: usize,
        found: &'a SimulationResult,
    ) -> Result<PinRun<'a>, StressError> {
        let samples = &found.run.samples;
        if samples.reactions.is_empty() {
            return Err(StressError::Missing {
                what: "sample",
                number: 1,
                there: "none, as the run has no samples".to_owned(),
            });
        }
        let throws: Vec<usize> =
            (0..engine.throws.len()).filter(|throw| engine.throws[*throw].crankshaft == crankshaft).collect();
        let on = |throw: &usize| {
            (0..engine.cylinders.len()).filter(|index| engine.cylinders[*index].throw == *throw).collect()
        };
        let cylinders = throws.iter().map(on).collect();
        let period = TAU * f64::from(engine.strokes.revolutions());
        Ok(PinRun { samples, crankshaft, throws, cylinders, period })
    }

    /// Force on the pin of throw number `k` of the crankshaft, in the throw's own frame: master rods carry what hangs on them.
    fn force(&self, k: usize, reactions: &Reactions) -> ThrowForce {
        let own = self.cylinders[k].iter().map(|cylinder| reactions.cylinders[*cylinder].throw_frame);
        let [radial, tangential] = own.fold([0.0; 2], |sum, force| [sum[0] + force[0], sum[1] + force[1]]);
        ThrowForce { throw: self.throws[k], radial, tangential, force: Complex64::new(radial, tangential) }
    }

    fn sample(&self, index: usize) -> Instant {
        let own = self.samples;
        let force = |k: usize| {
            let ThrowForce { throw, radial, tangential, .. } = self.force(k, &own.reactions[index]);
            PinForces { pin: throw + 1, radial, tangential }
        };
        Instant {
            time: own.time[index],
            theta: own.theta[index],
            speed: own.speed[index],
            acceleration: own.acceleration[index],
            forces: (0..self.throws.len()).map(force).collect(),
        }
    }

    /// The last instant at which the crank stands at an angle of the period.
    fn at(&self, angle: f64) -> Option<Instant> {
        let theta = &self.samples.theta;
        let end = *theta.last()?;
        let wanted = end - (end - angle).rem_euclid(self.period);
        let after = (1..theta.len()).rev().find(|k| theta[*k - 1] <= wanted && wanted <= theta[*k]);
        let Some(after) = after else {
            let near = theta.iter().position(|theta| (theta - wanted).abs() < 1e-9)?;
            return Some(self.sample(near));
        };
        let count = POINTS.min(theta.len());
        let first = after.saturating_sub(POINTS / 2).min(theta.len() - count);
        let near: Vec<Instant> = (first..first + count).map(|k| self.sample(k)).collect();
        // Lagrange's weights; a crank that turns back between these samples has no such weights.
        if near.windows(2).any(|pair| pair[1].theta <= pair[0].theta) {
            return Some(self.sample(after));
        }
        let weight = |k: usize| {
            let others = near.iter().enumerate().filter(|(other, _)| *other != k);
            others.fold(1.0, |product, (_, other)| {
                product * (wanted - other.theta) / (near[k].theta - other.theta)
            })
        };
        let weights: Vec<f64> = (0..count).map(weight).collect();
        let mean = |of: &dyn Fn(&Instant) -> f64| {
            near.iter().zip(&weights).map(|(own, weight)| weight * of(own)).sum::<f64>()
        };
        let force = |k: usize| PinForces {
            pin: self.throws[k] + 1,
            radial: mean(&|own| own.forces[k].radial),
            tangential: mean(&|own| own.forces[k].tangential),
        };
        Some(Instant {
            time: mean(&|own| own.time),
            theta: wanted,
            speed: mean(&|own| own.speed),
            acceleration: mean(&|own| own.acceleration),
            forces: (0..self.throws.len()).map(force).collect(),
        })
    }

    fn named(&self, engine: &Engine, instant: &Instant, what: &str) -> Result<NamedLoad, StressError> {
        let own = given(engine, self.crankshaft, instant.speed, &instant.forces, Some(instant.theta))?;
        let (angle, rpm) = (instant.theta.rem_euclid(self.period).to_degrees(), instant.speed * 30.0 / PI);
        let name = format!("{what}crank angle {angle:.1} deg, {:.4} s, {rpm:.0} rpm", instant.time);
        let mut load = own.load;
        load.acceleration = engine.crankshafts[self.crankshaft].ratio.value() * instant.acceleration;
        Ok(NamedLoad { name, load, ..own })
    }

    fn at_angles(&self, engine: &Engine, angles: &[f64]) -> Result<Vec<NamedLoad>, StressError> {
        if angles.len() > MOST_ANGLES {
            return Err(StressError::Angles { got: angles.len(), most: MOST_ANGLES });
        }
        let one = |angle: &f64| {
            let instant = self.at(*angle).ok_or_else(|| StressError::NotReached {
                angle: angle.to_degrees(),
                turned: self.samples.theta.last().zip(self.samples.theta.first()).map_or(0.0, |(b, a)| b - a)
                    / TAU,
            })?;
            self.named(engine, &instant, "")
        };
        angles.iter().map(one).collect()
    }

    /// Instants of the largest radial, tangential and resultant force on each pin over the whole run.
    fn extremes(&self, engine: &Engine) -> Result<Vec<NamedLoad>, StressError> {
        let mut wanted: Vec<(usize, Extremes)> = Vec::new();
        for k in 0..self.throws.len() {
            for (name, size) in SIZES {
                let of = |index: &usize| size(&self.force(k, &self.samples.reactions[*index]));
                let best = (0..self.samples.reactions.len()).max_by(|a, b| of(a).total_cmp(&of(b)));
                let Some(best) = best else { continue };
                let place = wanted.iter().position(|(index, _)| *index == best).unwrap_or_else(|| {
                    wanted.push((best, Extremes::default()));
                    wanted.len() - 1
                });
                wanted[place].1.add(self.throws[k] + 1, name);
            }
        }
        let one = |(index, extremes): &(usize, Extremes)| {
            self.named(engine, &self.sample(*index), &format!("{}, ", extremes.words().join(", ")))
        };
        wanted.iter().map(one).collect()
    }
}
