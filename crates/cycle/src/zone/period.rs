//! A cycle that repeats itself.

use super::flow::FlowGas;
use super::opening::{Area, piston_gap};
use super::release::Wiebe;
use super::result::{Balance, SinceClosing, ZoneCycle, ZoneOutcome};
use super::state::{Chamber, Contents, Scale, State, Zone};
use super::walls::{Phase, Reference, WallLosses};
use crate::error::CycleError;
use crate::ideal::released;
use crate::volume::CylinderVolume;
use lanchester_model::{GasCycle, SingleZone, WallModel};
use lanchester_results::{End, PeriodicCurve};
use std::f64::consts::PI;

/// How exactly a cycle is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ZoneSettings {
    /// Relative and absolute error of a step, over the sizes of the state.
    pub step_tolerance: f64,
    /// Largest change from cycle to cycle of one that repeats itself.
    pub cycle_tolerance: f64,
    /// Cycles, at most.
    pub most_cycles: usize,
    /// Widest piece of the resulting curves [rad].
    pub piece: f64,
}

impl Default for ZoneSettings {
    /// Steps to 1e-11, cycles to 1e-7, at most 200, pieces of half a degree.
    fn default() -> ZoneSettings {
        ZoneSettings { step_tolerance: 1e-11, cycle_tolerance: 1e-7, most_cycles: 200, piece: PI / 360.0 }
    }
}

/// Intervals shorter than this share of a cycle are left out.
const SHORTEST: f64 = 1e-12;

/// The cycle of a cylinder at a speed of its crankshaft [rad/s], run until it repeats itself.
///
/// # Errors
/// Valves that meet the piston; a solver that gives up.
pub fn single_zone(
    cycle: &GasCycle,
    zone: &SingleZone,
    volume: &CylinderVolume,
    speed: f64,
    settings: &ZoneSettings,
) -> Result<ZoneCycle, CycleError> {
    if let Some(met) = piston_gap(zone, volume).into_iter().find(|gap| gap.gap <= 0.0) {
        return Err(CycleError::ValveMeetsPiston {
            valve: if met.is_intake { "intake" } else { "exhaust" },
            overlap: -met.gap * 1e3,
            angle: met.angle.to_degrees(),
        });
    }
    Run::new(cycle, zone, volume, speed, settings).periodic()
}

/// An interval without kinks inside.
#[derive(Debug, Clone)]
struct Interval {
    from: f64,
    to: f64,
    phase: Phase,
    open: [bool; 2],
    burning: Vec<usize>,
}

struct Run<'a> {
    cycle: &'a GasCycle,
    zone: &'a SingleZone,
    volume: &'a CylinderVolume,
    settings: &'a ZoneSettings,
    speed: f64,
    areas: [Area<'a>; 2],
    stages: Vec<Wiebe>,
    intervals: Vec<Interval>,
    /// Angle at which the cylinder closes, before firing.
    start: f64,
    gas: FlowGas,
    scale: Scale,
}

impl<'a> Run<'a> {
    fn new(
        cycle: &'a GasCycle,
        zone: &'a SingleZone,
        volume: &'a CylinderVolume,
        speed: f64,
        settings: &'a ZoneSettings,
    ) -> Run<'a> {
        let period = volume.cycle();
        let areas = [Area::new(zone.intake, volume, true), Area::new(zone.exhaust, volume, false)];
        let stages: Vec<Wiebe> =
            zone.combustion.iter().flat_map(|combustion| &combustion.stages).map(Wiebe::new).collect();
        let start = areas[0].closes().max(areas[1].closes()) - period;
        let mut events: Vec<f64> = areas.iter().flat_map(Area::kinks).collect();
        events.extend(stages.iter().flat_map(|stage| [stage.start, stage.end]));
        // A table of heat transfer coefficients has a kink at each of its angles.
        if let Some(WallModel::Table { angles, .. }) = zone.walls.as_ref().map(|walls| &walls.model) {
            events.extend(angles);
        }
        let mut events: Vec<f64> =
            events.into_iter().map(|angle| start + (angle - start).rem_euclid(period)).collect();
        events.extend([start, start + period]);
        events.sort_by(f64::total_cmp);
        let ignition = stages.iter().map(|stage| stage.start).fold(f64::INFINITY, f64::min);
        let intervals = events
            .windows(2)
            .filter(|pair| pair[1] - pair[0] > SHORTEST * period)
            .map(|pair| {
                let middle = pair[0] + (pair[1] - pair[0]) / 2.0;
                let open = [areas[0].is_open(middle), areas[1].is_open(middle)];
                let burning = (0..stages.len())
                    .filter(|stage| middle > stages[*stage].start && middle < stages[*stage].end)
                    .collect();
                let phase = match open {
                    [false, false] if middle > ignition => Phase::Burning,
                    [false, false] => Phase::Compression,
                    _ => Phase::Exchange,
                };
                Interval { from: pair[0], to: pair[1], phase, open, burning }
            })
            .collect();
        let pressure = cycle.intake.pressure;
        let largest = volume.at(volume.bottom_angle())[0];
        let scale = Scale {
            pressure,
            mass: pressure * largest / (cycle.gas_constant * cycle.intake.temperature),
            energy: pressure * largest / (cycle.heat_capacity_ratio - 1.0),
        };
        let gas = FlowGas::new(cycle.heat_capacity_ratio, cycle.gas_constant);
        Run { cycle, zone, volume, settings, speed, areas, stages, intervals, start, gas, scale }
    }

    /// Runs one cycle from the closing of the cylinder; `sample` takes what it holds at the knots.
    fn once(&self, from: Contents, mut sample: Option<&mut Vec<Sample>>) -> Result<State, CycleError> {
        let heat = self.zone.combustion.as_ref().map_or(0.0, |burning| released(&burning.fuel, from.fresh));
        let closed = self.volume.at(self.start)[0];
        let losses = self.zone.walls.as_ref().map(|walls| WallLosses {
            walls,
            volume: self.volume,
            mean_piston_speed: self.volume.stroke() * self.speed / PI,
            gamma: self.gas.gamma,
            reference: Reference {
                pressure: from.pressure,
                volume: closed,
                temperature: from.pressure * closed / (from.mass * self.gas.gas_constant),
            },
        });
        let mut state = self.scale.state(from);
        for interval in &self.intervals {
            let chamber = |psi: f64, Contents { pressure, mass, .. }: Contents| {
                let volume = self.volume.at(psi);
                let temperature = pressure * volume[0] / (mass * self.gas.gas_constant);
                let rate: f64 = interval.burning.iter().map(|stage| self.stages[*stage].rate(psi)).sum();
                let area = |side: usize| if interval.open[side] { self.areas[side].at(psi) } else { 0.0 };
                let wall_heat = losses.as_ref().map_or(0.0, |losses| {
                    losses.flow([pressure, temperature], volume[0], psi, interval.phase) / self.speed
                });
                Chamber {
                    volume,
                    areas: [area(0), area(1)],
                    release: heat * rate,
                    burning: from.fresh * rate,
                    wall_heat,
                }
            };
            let zone = Zone {
                gas: self.gas,
                reservoirs: [self.cycle.intake, self.cycle.exhaust],
                time: self.speed.recip(),
                scale: self.scale,
                chamber,
            };
            let range = [interval.from, interval.to];
            let Some(samples) = sample.as_deref_mut() else {
                (state, _) = zone.run(range, state, &[], self.settings.step_tolerance)?;
                continue;
            };
            let count = ((range[1] - range[0]) / self.settings.piece).ceil().max(1.0);
            let step = (range[1] - range[0]) / count;
            let points: Vec<f64> = (1..count as u32).map(|k| range[0] + step * f64::from(k)).collect();
            let (end, between) = zone.run(range, state, &points, self.settings.step_tolerance)?;
            let states = std::iter::once(state).chain(between).chain([end]);
            let angles = std::iter::once(range[0]).chain(points.iter().copied()).chain([range[1]]);
            let taken: Vec<Sample> =
                angles.zip(states).map(|(psi, state)| self.sample(&zone, psi, &state)).collect();
            samples.extend(taken.windows(2).map(|pair| Sample {
                angle: pair[0].angle,
                ends: std::array::from_fn(|k| [pair[0].ends[k][0], pair[1].ends[k][0]]),
            }));
            state = end;
        }
        Ok(state)
    }

    /// What a cycle returns over the angle, with its slopes.
    fn sample<F: Fn(f64, Contents) -> Chamber>(&self, zone: &Zone<F>, psi: f64, state: &State) -> Sample {
        let rates = zone.rates(psi, state);
        let Contents { pressure, mass, .. } = self.scale.contents(state);
        let slope = rates[0] * self.scale.pressure;
        let [volume, volume_rate] = self.volume.at(psi);
        let temperature = pressure * volume / (mass * self.gas.gas_constant);
        let relative = slope / pressure + volume_rate / volume - rates[1] * self.scale.mass / mass;
        let Scale { mass: m, energy: e, .. } = self.scale;
        let of = |k: usize, scale: f64| End { value: state[k] * scale, slope: rates[k] * scale };
        let ends = [
            End { value: pressure, slope },
            End { value: temperature, slope: temperature * relative },
            of(1, m),
            of(3, e),
            of(4, e),
            of(5, e),
            of(6, m),
            of(7, m),
            of(8, e),
            of(9, e),
        ];
        Sample { angle: psi, ends: ends.map(|end| [end; 2]) }
    }

    fn periodic(&self) -> Result<ZoneCycle, CycleError> {
        let volume = self.volume.at(self.start)[0];
        let intake = self.cycle.intake;
        let mass = intake.pressure * volume / (self.gas.gas_constant * intake.temperature);
        let mut contents = Contents { pressure: intake.pressure, mass, fresh: 0.9 * mass };
        let mut outcome = ZoneOutcome { converged: false, cycles: 0, change: f64::INFINITY };
        while !outcome.converged && outcome.cycles < self.settings.most_cycles {
            let next = self.scale.contents(&self.once(contents, None)?);
            outcome = self.compared(contents, next, outcome.cycles + 1);
            contents = next;
        }
        let mut samples = Vec::new();
        let end = self.once(contents, Some(&mut samples))?;
        outcome = self.compared(contents, self.scale.contents(&end), outcome.cycles + 1);
        self.result(contents, &end, outcome, &samples)
    }

    fn compared(&self, before: Contents, after: Contents, cycles: usize) -> ZoneOutcome {
        let change = [
            (after.pressure - before.pressure) / before.pressure,
            (after.mass - before.mass) / before.mass,
            (after.fresh - before.fresh) / before.mass,
        ];
        let change = change.into_iter().fold(0.0, |most: f64, part| most.max(part.abs()));
        ZoneOutcome { converged: change <= self.settings.cycle_tolerance, cycles, change }
    }

    fn result(
        &self,
        trapped: Contents,
        end: &State,
        outcome: ZoneOutcome,
        samples: &[Sample],
    ) -> Result<ZoneCycle, CycleError> {
        let curve = |place: usize| {
            let knots = samples.iter().map(|sample| sample.angle).collect();
            let ends: Vec<[End; 2]> = samples.iter().map(|sample| sample.ends[place]).collect();
            PeriodicCurve::from_ends(self.volume.cycle(), knots, &ends)
        };
        let passed = self.scale.passed(end);
        let after = self.scale.contents(end);
        let volume = self.volume.at(self.start)[0];
        let stored = (after.pressure - trapped.pressure) * volume / (self.gas.gamma - 1.0);
        let energy =
            stored - (passed.released - passed.wall_heat - passed.work + passed.enthalpy.iter().sum::<f64>());
        let size = [passed.released, passed.wall_heat, passed.work, passed.enthalpy[0], passed.enthalpy[1]]
            .into_iter()
            .fold(trapped.pressure * volume / (self.gas.gamma - 1.0), |most: f64, part| most.max(part.abs()));
        let mass = after.mass - trapped.mass - passed.mass[0] - passed.mass[1];
        let intake = self.cycle.intake;
        let displaced =
            intake.pressure * self.volume.displaced() / (self.gas.gas_constant * intake.temperature);
        Ok(ZoneCycle {
            pressure: curve(0)?,
            temperature: curve(1)?,
            mass: curve(2)?,
            since_closing: SinceClosing {
                work: curve(3)?,
                wall_heat: curve(4)?,
                released: curve(5)?,
                mass: [curve(6)?, curve(7)?],
                enthalpy: [curve(8)?, curve(9)?],
            },
            outcome,
            closing_angle: self.start,
            trapped,
            residual_share: 1.0 - trapped.fresh / trapped.mass,
            volumetric_efficiency: passed.mass[0] / displaced,
            trapping_efficiency: trapped.fresh / passed.fresh,
            heat: passed.released,
            passed,
            balance: Balance {
                energy,
                energy_share: energy.abs() / size,
                mass,
                mass_share: mass.abs() / trapped.mass,
            },
            indicated_efficiency: (passed.released > 0.0).then(|| passed.work / passed.released),
            fuel_efficiency: self
                .zone
                .combustion
                .as_ref()
                .filter(|_| passed.released > 0.0)
                .map(|burning| burning.fuel.efficiency * passed.work / passed.released),
        })
    }
}

/// A piece: its angle; at both ends pressure [Pa], temperature [K], mass [kg], and since closing work, heat to the walls and heat released
/// [J], mass in from both sides [kg], enthalpy in from both sides [J].
struct Sample {
    angle: f64,
    ends: [[End; 2]; 10],
}
