//! From the cycles of a train to what is told of them.

use super::free::LawCycles;
use super::laws::{BearingLaws, law_words};
use super::train::Bearing;
use crate::stress::request::StressError;
use crate::stress::worst_point::WorstPoint;
use lanchester_flex::train::{
    CycleInstant, FilletCycle, FilletNodes, FilmInstant, StressBasis, StressInstant, TrainLaw,
    largest_film_pressure,
};
use lanchester_report::{BearingCycle, CrankKind, CycleLaw, CycleRun, FilletFatigue, LeastFilm};
use lanchester_strength::Findley;

/// Instants at which the pressure of a film is solved.
const PRESSURES: usize = 72;
/// Films below so many roughnesses count as rough.
const ROUGH: f64 = 3.0;

type Plane = [f64; 2];

fn turned([x, y]: Plane, angle: f64) -> Plane {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

fn size([x, y]: Plane) -> f64 {
    x.hypot(y)
}

/// What a run gave.
pub(crate) fn cycle_run(
    law: CycleLaw,
    crank: CrankKind,
    found: &LawCycles,
    places: &[Bearing],
    laws: &BearingLaws,
    stress: Option<FilletStress<'_>>,
) -> Result<CycleRun, StressError> {
    let LawCycles { train, cycles } = found;
    let recorded: Vec<&CycleInstant> = cycles.recorded.iter().flat_map(|own| &own.instants).collect();
    let last = cycles.recorded.last().map_or(&[][..], |own| own.instants.as_slice());
    let worst = cycles.recorded.iter().map(|own| own.energy).max_by(|a, b| a.error().total_cmp(&b.error()));
    let energy = worst.unwrap_or_default();
    let mut bearings = Vec::new();
    for (surface, place) in places.iter().enumerate() {
        if last.is_empty() {
            break;
        }
        let main = train.mains.iter().position(|own| own.surface == surface);
        let pin = train.cylinders.iter().position(|own| own.surface == surface);
        let (law, housing) = match (main, pin) {
            (Some(main), _) => (&train.mains[main].law, train.mains[main].housing),
            (None, Some(pin)) => (&train.cylinders[pin].law, train.cylinders[pin].housing),
            (None, None) => continue,
        };
        let seen: Vec<Seen> = recorded.iter().map(|own| Seen::of(own, train, surface, main, pin)).collect();
        let law = (law, housing);
        bearings.push(bearing(place, law, &seen, last.len(), laws.quasi_static(surface))?);
    }
    let mut fatigue = Vec::new();
    let fillets = match stress {
        Some(stress) if !recorded.is_empty() => {
            let instants: Vec<StressInstant> =
                recorded.iter().map(|own| stress_instant(own, train, places.len())).collect();
            let theta: Vec<f64> = recorded.iter().map(|own| own.theta).collect();
            let judged = stress.basis.each_fillet(&instants, |nodes| stress.judge(nodes, &theta));
            let (mut fillets, safeties): (Vec<FilletCycle>, Vec<_>) = judged.into_iter().unzip();
            fatigue = safeties.into_iter().flatten().collect();
            for fillet in &mut fillets {
                // Of several cycles the envelope.
                let envelope = |k: usize| {
                    fillet.over_cycle.iter().skip(k).step_by(last.len()).copied().fold(0.0, f64::max)
                };
                fillet.over_cycle = (0..last.len()).map(envelope).collect();
            }
            fillets
        }
        _ => Vec::new(),
    };
    let finite = |value: f64| value.is_finite().then_some(value);
    Ok(CycleRun {
        law,
        crank,
        outcome: cycles.outcome,
        cycles: cycles.cycles,
        orbit_change: finite(cycles.orbit_change),
        stress_change: finite(cycles.stress_change),
        recorded: cycles.recorded.len(),
        energy,
        energy_error: energy.error(),
        steps: cycles.steps,
        rejected: cycles.rejected,
        iterations: cycles.iterations,
        free_speed: cycles.free,
        theta: last.iter().map(|own| own.theta).collect(),
        speed: last.iter().map(|own| own.speed).collect(),
        torque: last.iter().map(|own| own.torque).collect(),
        bearings,
        fillets,
        fatigue,
    })
}

/// What is asked of the stress of fillets.
pub(crate) struct FilletStress<'a> {
    pub basis: &'a StressBasis,
    /// None: fatigue is not judged.
    pub findley: Option<&'a Findley>,
    /// Yield strength [Pa].
    pub yielding: Option<f64>,
}

impl FilletStress<'_> {
    /// Peaks and safety of a fillet over the recorded instants at these crank angles.
    fn judge(&self, nodes: &FilletNodes<'_>, theta: &[f64]) -> (FilletCycle, Option<FilletFatigue>) {
        let Some(findley) = self.findley else { return (nodes.cycle(|_, _| {}), None) };
        let mut worst = WorstPoint::new(findley);
        let peak = nodes.cycle(|node, history| worst.see(node, history));
        let fatigue = worst.found(|node| nodes.history(node)).map(|found| {
            let (at, angle) = nodes.place(found.node);
            FilletFatigue {
                name: peak.name.clone(),
                radius: peak.radius,
                at,
                angle,
                critical_angle: theta.get(found.point.plane.instant).copied().unwrap_or(f64::NAN),
                point: found.point,
                von_mises: found.von_mises,
                static_safety: self.yielding.map(|strength| strength / found.von_mises),
            }
        });
        (peak, fatigue)
    }
}

/// A bearing at one instant.
struct Seen {
    theta: f64,
    /// Journal or pin on the bearing.
    load: Plane,
    eccentricity: Plane,
    rate: Plane,
    entrainment: f64,
    /// Slope of journal or pin along the crank, in the block's frame.
    slope: Plane,
    /// How much further the end of a tilted journal lies than its middle, and the rate of that.
    tilt: [Plane; 2],
    /// Direction of the bearing's frame.
    shell: f64,
}

impl Seen {
    fn of(
        own: &CycleInstant,
        train: &lanchester_flex::train::CrankTrain,
        surface: usize,
        main: Option<usize>,
        pin: Option<usize>,
    ) -> Seen {
        let mains = train.mains.len();
        let slope = turned(train.body.slope(surface, &own.coordinates), own.own_angle);
        let (force, eccentricity, rate, entrainment, shell) = match (main, pin) {
            (Some(k), _) => {
                (own.main_forces[k], own.main_places[k], own.rates[k], 0.5 * train.ratio * own.speed, 0.0)
            }
            (None, Some(k)) => {
                (own.pin_forces[k], own.pin_places[k], own.rates[mains + k], own.entrainment[k], own.rods[k])
            }
            (None, None) => ([0.0; 2], [0.0; 2], [0.0; 2], 0.0, 0.0),
        };
        Seen {
            theta: own.theta,
            load: force.map(|part| -part),
            eccentricity,
            rate,
            entrainment,
            slope,
            tilt: own.tilts[main.or(pin.map(|k| mains + k)).unwrap_or_default()],
            shell,
        }
    }
}

fn bearing(
    place: &Bearing,
    (law, housing): (&TrainLaw, Option<f64>),
    seen: &[Seen],
    count: usize,
    quasi_static: Option<f64>,
) -> Result<BearingCycle, StressError> {
    let most = |of: &dyn Fn(&Seen) -> f64| {
        seen.iter().map(|own| (of(own), own.theta)).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default()
    };
    let (largest_load, largest_load_angle) = most(&|own| size(own.load));
    let largest_eccentricity = most(&|own| size(own.eccentricity)).0;
    let film = match law {
        TrainLaw::Film { bearing, viscosity, roughness, .. }
        | TrainLaw::TiltedFilm { bearing, viscosity, roughness } => {
            let instants: Vec<FilmInstant> = seen
                .iter()
                .map(|own| FilmInstant {
                    eccentricity: own.eccentricity,
                    rate: own.rate,
                    entrainment: own.entrainment,
                    tilt: own.tilt,
                })
                .collect();
            let refused = |error| StressError::Bearing { bearing: place.name(), error };
            let pressure = largest_film_pressure(law, &instants, PRESSURES).map_err(refused)?;
            let clearance = bearing.clearance;
            let end = |own: &Seen, sign: f64| {
                let half = 0.5 * sign * bearing.length;
                size([own.eccentricity[0] + half * own.slope[0], own.eccentricity[1] + half * own.slope[1]])
            };
            let at_ends = |own: &Seen| end(own, 1.0).max(end(own, -1.0));
            let is_tilted = matches!(law, TrainLaw::TiltedFilm { .. });
            let reach = |own: &Seen| if is_tilted { at_ends(own) } else { size(own.eccentricity) };
            let (furthest, theta) = most(&reach);
            let rough = |own: &&Seen| clearance - reach(own) < ROUGH * roughness;
            Some(LeastFilm {
                thickness: clearance - furthest,
                theta,
                is_tilted,
                at_ends: clearance - most(&at_ends).0,
                below_roughness: seen.iter().filter(rough).count() as f64 / seen.len().max(1) as f64,
                largest_pressure: pressure.map(|(pressure, k)| [pressure, seen[k].theta]),
                quasi_static,
                viscosity: *viscosity,
            })
        }
        TrainLaw::Rigid | TrainLaw::Contact { .. } | TrainLaw::Bushing { .. } => None,
    };
    let last = &seen[seen.len() - count..];
    Ok(BearingCycle {
        kind: place.kind,
        number: place.number,
        z: place.surface.z,
        law: law_words(law, housing),
        clearance: law.clearance(),
        load: last.iter().map(|own| own.load).collect(),
        largest_load,
        largest_load_angle,
        mean_load: seen.iter().map(|own| size(own.load)).sum::<f64>() / seen.len().max(1) as f64,
        orbit: seen.iter().map(|own| turned(own.eccentricity, -own.shell)).collect(),
        largest_eccentricity,
        film,
    })
}

/// Coordinates and forces on the surfaces in the frame that turns with the crankshaft.
fn stress_instant(
    own: &CycleInstant,
    train: &lanchester_flex::train::CrankTrain,
    surfaces: usize,
) -> StressInstant {
    let mut forces = vec![[0.0; 2]; surfaces];
    for (main, force) in train.mains.iter().zip(&own.main_forces) {
        forces[main.surface] = turned(*force, -own.own_angle);
    }
    for (cylinder, force) in train.cylinders.iter().zip(&own.pin_forces) {
        forces[cylinder.surface] = turned(*force, -own.own_angle);
    }
    StressInstant { coordinates: own.coordinates.clone(), forces }
}
