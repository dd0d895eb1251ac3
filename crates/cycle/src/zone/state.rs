//! The gas in a chamber and how it changes.

use super::flow::FlowGas;
use crate::error::CycleError;
use lanchester_model::Reservoir;
use lanchester_numerics::{Dop853, Function, Outcome, Settings};
use serde::Serialize;
use std::ops::ControlFlow;

/// What is integrated, each over its scale: pressure, mass, fresh mass; then since the start: work, heat to the walls, heat released, mass in from the
/// intake and from the exhaust, enthalpy in from each, fresh mass in through the intake.
pub(crate) type State = [f64; 11];

/// The gas in a chamber.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Contents {
    /// Pressure [Pa].
    pub pressure: f64,
    /// Mass [kg].
    pub mass: f64,
    /// Mass that came through the intake and has not burned [kg].
    pub fresh: f64,
}

/// What has passed since the start.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct ThroughFlow {
    /// Work of the gas on the piston [J].
    pub work: f64,
    /// Heat to the walls [J].
    pub wall_heat: f64,
    /// Heat released [J].
    pub released: f64,
    /// Mass in from the intake and from the exhaust (negative: out) [kg].
    pub mass: [f64; 2],
    /// Enthalpy in with these masses [J].
    pub enthalpy: [f64; 2],
    /// Fresh mass in through the intake, less what of it flows back [kg].
    pub fresh: f64,
}

/// What happens in a chamber at an angle, apart from its gas.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Chamber {
    /// Volume [m^3] and its rate [m^3/rad].
    pub(crate) volume: [f64; 2],
    /// Effective areas to the two reservoirs [m^2].
    pub(crate) areas: [f64; 2],
    /// Heat released [J/rad].
    pub(crate) release: f64,
    /// Fresh mass that burns [kg/rad].
    pub(crate) burning: f64,
    /// Heat to the walls [J/rad].
    pub(crate) wall_heat: f64,
}

/// Sizes by which the state is divided.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scale {
    pub(crate) pressure: f64,
    pub(crate) mass: f64,
    pub(crate) energy: f64,
}

impl Scale {
    pub(crate) fn state(&self, contents: Contents) -> State {
        let mut state = [0.0; 11];
        state[0] = contents.pressure / self.pressure;
        state[1] = contents.mass / self.mass;
        state[2] = contents.fresh / self.mass;
        state
    }

    pub(crate) fn contents(&self, state: &State) -> Contents {
        Contents {
            pressure: state[0] * self.pressure,
            mass: state[1] * self.mass,
            fresh: state[2] * self.mass,
        }
    }

    pub(crate) fn passed(&self, state: &State) -> ThroughFlow {
        let [work, wall_heat, released] = [3, 4, 5].map(|k| state[k] * self.energy);
        ThroughFlow {
            work,
            wall_heat,
            released,
            mass: [state[6] * self.mass, state[7] * self.mass],
            enthalpy: [state[8] * self.energy, state[9] * self.energy],
            fresh: state[10] * self.mass,
        }
    }
}

/// A chamber with its reservoirs; `chamber` gives what happens at an angle to what is in it.
pub(crate) struct Zone<F> {
    pub(crate) gas: FlowGas,
    pub(crate) reservoirs: [Reservoir; 2],
    /// Seconds for a radian.
    pub(crate) time: f64,
    pub(crate) scale: Scale,
    pub(crate) chamber: F,
}

impl<F: Fn(f64, Contents) -> Chamber> Zone<F> {
    /// Rates per radian of the scaled state.
    ///
    /// ```text
    /// dp/dpsi = ((gamma - 1) (Q' - Q_w' + SUM c_p T_up m') - gamma p V')/V,   dm/dpsi = SUM m'                (28.9)
    /// ```
    pub(crate) fn rates(&self, psi: f64, state: &State) -> State {
        let Contents { pressure, mass, fresh } = self.scale.contents(state);
        let FlowGas { gamma, gas_constant, .. } = self.gas;
        let specific = gamma * gas_constant / (gamma - 1.0);
        let chamber = (self.chamber)(psi, Contents { pressure, mass, fresh });
        let [volume, volume_rate] = chamber.volume;
        let temperature = pressure * volume / (mass * gas_constant);
        let mut masses = [0.0; 2];
        let mut enthalpies = [0.0; 2];
        let mut fresh_rate = -chamber.burning;
        let mut fresh_in = 0.0;
        for side in 0..2 {
            let Reservoir { pressure: outside, temperature: reservoir } = self.reservoirs[side];
            let area = chamber.areas[side];
            if area <= 0.0 {
                continue;
            }
            let (flow, upstream, share) = if outside > pressure {
                let fresh_share = if side == 0 { 1.0 } else { 0.0 };
                (self.gas.flow(area, [outside, reservoir], pressure), reservoir, fresh_share)
            } else {
                (-self.gas.flow(area, [pressure, temperature], outside), temperature, fresh / mass)
            };
            masses[side] = flow * self.time;
            enthalpies[side] = masses[side] * specific * upstream;
            fresh_rate += masses[side] * share;
            if side == 0 {
                fresh_in = masses[side] * share;
            }
        }
        let heat = chamber.release - chamber.wall_heat + enthalpies[0] + enthalpies[1];
        let pressure_rate = ((gamma - 1.0) * heat - gamma * pressure * volume_rate) / volume;
        let Scale { pressure: p, mass: m, energy: e } = self.scale;
        [
            pressure_rate / p,
            (masses[0] + masses[1]) / m,
            fresh_rate / m,
            pressure * volume_rate / e,
            chamber.wall_heat / e,
            chamber.release / e,
            masses[0] / m,
            masses[1] / m,
            enthalpies[0] / e,
            enthalpies[1] / e,
            fresh_in / m,
        ]
    }

    /// From one angle to another, within which nothing has a kink; states at `points` among them, rising.
    pub(crate) fn run(
        &self,
        [from, to]: [f64; 2],
        mut state: State,
        points: &[f64],
        tolerance: f64,
    ) -> Result<(State, Vec<State>), CycleError> {
        let mut system = Function::new(state.len(), |psi, state: &[f64], rates: &mut [f64]| {
            rates.copy_from_slice(&self.rates(psi, &std::array::from_fn(|k| state[k])));
        });
        let settings = Settings {
            dense: !points.is_empty(),
            most_evaluations: MOST_EVALUATIONS,
            ..Settings::uniform(state.len(), tolerance)
        };
        let mut wanted = points.iter().peekable();
        let mut states = Vec::with_capacity(points.len());
        let mut place = from;
        let outcome = Dop853::new(settings).run(&mut system, &mut place, &mut state, to, |step| {
            while let Some(psi) = wanted.next_if(|psi| **psi <= step.to) {
                let mut between = [0.0; 11];
                step.at(*psi, &mut between);
                states.push(between);
            }
            ControlFlow::Continue(())
        });
        if outcome == Outcome::Reached && states.len() == points.len() {
            Ok((state, states))
        } else {
            Err(CycleError::Integration { angle: place.to_degrees(), reason: reason(outcome) })
        }
    }
}

/// Why the integration ended early, in words.
fn reason(outcome: Outcome) -> String {
    match outcome {
        Outcome::TooManyEvaluations { limit } => format!("it takes more than {limit} evaluations"),
        Outcome::StepTooSmall { .. } => "its steps become too small to be told from none".to_owned(),
        Outcome::NotFinite { .. } => "a rate of change is no number".to_owned(),
        other => format!("{other:?}"),
    }
}

/// Evaluations of one interval, at most.
const MOST_EVALUATIONS: u64 = 2_400_000;

/// Fills a chamber of constant volume [m^3] through an effective area [m^2] from a reservoir for a time [s]; gives what is in it then.
///
/// The textbook's case behind the enthalpy in eq. 28.9: an evacuated chamber fills to `gamma` times the temperature of the reservoir.
///
/// # Errors
/// [`CycleError::Integration`] where the solver gives up.
pub fn fill(
    from: Contents,
    volume: f64,
    reservoir: Reservoir,
    area: f64,
    seconds: f64,
    [gamma, gas_constant]: [f64; 2],
) -> Result<Contents, CycleError> {
    let scale = Scale {
        pressure: reservoir.pressure,
        mass: reservoir.pressure * volume / (gas_constant * reservoir.temperature),
        energy: reservoir.pressure * volume,
    };
    let chamber = move |_: f64, _: Contents| Chamber {
        volume: [volume, 0.0],
        areas: [area, 0.0],
        release: 0.0,
        burning: 0.0,
        wall_heat: 0.0,
    };
    let gas = FlowGas::new(gamma, gas_constant);
    let zone = Zone { gas, reservoirs: [reservoir; 2], time: seconds, scale, chamber };
    let (end, _) = zone.run([0.0, 1.0], scale.state(from), &[], 1e-12)?;
    Ok(scale.contents(&end))
}
