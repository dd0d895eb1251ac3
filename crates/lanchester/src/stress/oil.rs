//! Oil films that hold a crankshaft at rest or press on its pins, at the speed and the instant of each load.

use crate::bearing_films::{BearingFilmsError, big_ends};
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::measured::TraceFile;
use crate::stress::cycle::laws::BearingLaws;
use crate::stress::cycle::train::{Bearing, bearing_places, main_places};
use crate::stress::named_load::{NamedLoad, turn};
use crate::stress::request::{LoadSource, StaticRequest, StressError, StressLoad};
use crate::torque_report::bearing_sizes;
use lanchester_film::{JournalCycle, OrbitOutcome, OrbitRequest, contact_force, journal_orbit};
use lanchester_flex::crank_case::{CrankSupport, FilmBearing, PinLoad, PinPressure};
use lanchester_flex::oil_pressure::OilPressure;
use lanchester_flex::train::{FilmInstant, Plane, TrainLaw};
use lanchester_mechanism::{BearingLoads, BearingPart, BearingRequest, bearing_loads};
use lanchester_model::Engine;
use lanchester_report::CycleLaw;

/// Change of the speed within a run for which the oil is warmed anew.
const SAME_SPEED: f64 = 0.05;

/// Films of one speed.
struct AtSpeed {
    speed: f64,
    mains: Vec<FilmBearing>,
    /// By the number of its pin: a big end with its orbit.
    pins: Vec<(usize, BigEnd)>,
}

/// A big end over the cycle, in the frame of the block.
struct BigEnd {
    bearing: FilmBearing,
    period: f64,
    cycle: JournalCycle,
    /// Centre of the pin from that of the big end [m].
    eccentricity: Vec<Plane>,
}

/// Refuses films for loads that say too little of the motion they need.
pub(crate) fn check_films(request: &StaticRequest) -> Result<(), StressError> {
    let refused = |reason, hint| Err(StressError::NoFilms { reason, hint });
    if request.pressure == PinPressure::Film {
        if matches!(request.support, CrankSupport::Rings { .. }) {
            return refused(
                "rings take the loads of the pins at their outside",
                "choose another support, or another pressure on the pins",
            );
        }
        if matches!(request.load, StressLoad::Given { .. }) {
            return refused(
                "the pressure of oil films on pins follows the motion of pin and rod over the cycle, and given forces have none",
                "ask for the built-in cases or for crank angles, or spread given forces with the cosine or evenly",
            );
        }
        if request.source != LoadSource::ClosedForm {
            return refused(
                "the pressure of oil films on pins is that of the loads of the closed form, and these are those of a run",
                "take the loads of the closed form, or spread those of the run with the cosine or evenly",
            );
        }
    }
    Ok(())
}

/// Gives each load the films that its request, which [`check_films`] has let pass, asks for; what is to be said of them.
pub(crate) fn add_films(
    engine: &Engine,
    traces: &[TraceFile],
    request: &StaticRequest,
    loads: &mut [NamedLoad],
) -> Result<Vec<String>, StressError> {
    let on_pins = request.pressure == PinPressure::Film;
    let mut notes = Vec::new();
    if !on_pins && request.support != CrankSupport::Films {
        return Ok(notes);
    }
    let mut known: Vec<AtSpeed> = Vec::new();
    let is_run = request.source != LoadSource::ClosedForm;
    let (mut missing, mut largest) = (0.0f64, 0.0f64);
    for own in loads {
        if own.speed == 0.0 {
            return Err(StressError::NoFilms {
                reason: "at standstill an oil film carries nothing",
                hint: "give a speed",
            });
        }
        let apart = if is_run { SAME_SPEED } else { 0.0 };
        let is_near = |known: &AtSpeed| (known.speed / own.speed - 1.0).abs() <= apart;
        let at = match known.iter().position(is_near) {
            Some(at) => at,
            None => {
                known.push(at_speed(engine, traces, request, own.speed, &mut notes)?);
                known.len() - 1
            }
        };
        let films = &known[at];
        own.load.films.clone_from(&films.mains);
        let Some(theta) = own.theta.filter(|_| on_pins) else { continue };
        let turn = turn(engine, request.mesh.crankshaft, theta);
        let oil = films.pins.iter().map(|(_, big_end)| big_end.pressure(theta, turn));
        own.load.oil = oil.collect::<Result<_, _>>()?;
        for PinLoad { pin, force } in &own.load.pins {
            let carried = films.pins.iter().zip(&own.load.oil).filter(|((number, _), _)| number == pin);
            let carried = carried.fold([0.0; 2], |sum: Plane, (_, oil)| {
                [0, 1].map(|k| sum[k] + oil.force[k] + oil.contact[k])
            });
            missing = missing.max((carried[0] - force[0]).hypot(carried[1] - force[1]));
            largest = largest.max(force[0].hypot(force[1]));
        }
    }
    if on_pins {
        notes.push(format!(
            "Pressure on pins: that of the oil films of the big ends on their quasi-static orbits at the instant of the load, solved directly. The films carry the \
             loads to {:.2} % of the largest and are stretched to them exactly.",
            100.0 * missing / largest.max(f64::MIN_POSITIVE)
        ));
    }
    if is_run {
        notes.push(format!(
            "Oil of loads whose speeds differ by less than {:.0} % is as warm as at the first of them.",
            100.0 * SAME_SPEED
        ));
    }
    if request.support == CrankSupport::Films {
        let yields = known.iter().flat_map(|own| &own.mains).any(|own| own.housing.is_some());
        let housings = if yields {
            "housings give way by their stiffness, shells are round and in line without load"
        } else {
            "shells and block are rigid and in line"
        };
        notes.push(format!(
            "Each load rests in the films of the main bearings as if it stayed: nothing is squeezed, so that films are thinner than over the cycle. Films are those of \
             journals parallel to their shells; {housings}."
        ));
    }
    Ok(notes)
}

/// Films of one speed, with the oil as warm as quasi-static films make it there.
fn at_speed(
    engine: &Engine,
    traces: &[TraceFile],
    request: &StaticRequest,
    speed: f64,
    notes: &mut Vec<String>,
) -> Result<AtSpeed, StressError> {
    let gas = match &engine.gas {
        Some(_) if request.gas => Some(cylinder_gas(engine, traces, speed)?),
        _ => None,
    };
    let part = if gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
    let asked = BearingRequest { speed: Some(speed), part, ..BearingRequest::default() };
    let cylinders = gas.as_ref().map(|gas| gas.cylinders.as_slice());
    let loads = bearing_loads(engine, cylinders, &asked)?;
    let crankshaft = request.mesh.crankshaft;
    let on_pins = request.pressure == PinPressure::Film;
    let places = if on_pins { bearing_places(engine, crankshaft)? } else { main_places(engine, crankshaft)? };
    let mut said = Vec::new();
    let laws = BearingLaws::new(engine, &loads, &places, &[CycleLaw::Film], false, &mut said)?;
    said.retain(|note| !notes.contains(note));
    notes.extend(said);
    let films = places.iter().zip(laws.of(CycleLaw::Film));
    let films: Vec<(&Bearing, FilmBearing)> = films
        .map(|(place, law)| {
            (place, FilmBearing { place: place.surface.clone(), law: law.law.clone(), housing: law.housing })
        })
        .collect();
    let mains = films.iter().filter(|(place, _)| place.is_main() && request.support == CrankSupport::Films);
    let mains = mains.map(|(_, film)| film.clone()).collect();
    let big_ends = films.iter().filter(|(place, _)| !place.is_main());
    let pins = big_ends
        .map(|(place, film)| {
            let pin = engine.cylinders[place.number - 1].throw + 1;
            Ok((pin, BigEnd::new(engine, &loads, place, film.clone())?))
        })
        .collect::<Result<_, StressError>>()?;
    Ok(AtSpeed { speed, mains, pins })
}

impl BigEnd {
    fn new(
        engine: &Engine,
        loads: &BearingLoads,
        place: &Bearing,
        bearing: FilmBearing,
    ) -> Result<BigEnd, StressError> {
        let size = bearing_sizes(engine).crankpin.ok_or(BearingFilmsError::NoSizes)?;
        let own = big_ends(engine, loads, size).into_iter().find(|own| own.number == place.number);
        let cycle = own.ok_or(BearingFilmsError::NoSizes)?.cycle;
        let TrainLaw::Film { bearing: journal, table, viscosity, roughness } = &bearing.law else {
            return Err(BearingFilmsError::NoSizes.into());
        };
        let request = OrbitRequest {
            bearing: *journal,
            table,
            viscosity: *viscosity,
            cycle: &cycle,
            roughness: *roughness,
            mass: None,
        };
        let refused = |error| StressError::Bearing { bearing: place.name(), error };
        let orbit = journal_orbit(&request).map_err(refused)?;
        if orbit.outcome == OrbitOutcome::Overloaded {
            return Err(StressError::NoFilms {
                reason: "a big end's oil film has no thickness left within the cycle",
                hint: "the films over the cycle tell which and when; spread the loads with the cosine or evenly",
            });
        }
        Ok(BigEnd { period: loads.period, eccentricity: orbit.eccentricity, cycle, bearing })
    }

    /// Pressure on the pin at a crank angle of crankshaft 1, in the frame of the crankshaft that has turned by `turn`.
    fn pressure(&self, theta: f64, turn: f64) -> Result<OilPressure, StressError> {
        let count = self.cycle.load.len();
        let at = (theta / self.period).rem_euclid(1.0) * count as f64;
        let (first, t) = ((at as usize) % count, at - at.floor());
        let next = (first + 1) % count;
        let mixed = |values: &[Plane]| [0, 1].map(|k| (1.0 - t) * values[first][k] + t * values[next][k]);
        let e = mixed(&self.eccentricity);
        let load = mixed(&self.cycle.load);
        let spin = |values: &[f64]| (1.0 - t) * values[first] + t * values[next];
        let entrainment = spin(&self.cycle.entrainment);
        let (sin, cos) = turn.sin_cos();
        let turned = |[x, y]: Plane| [cos * x + sin * y, cos * y - sin * x];
        let TrainLaw::Film { bearing, table, viscosity, roughness } = &self.bearing.law else {
            return Err(BearingFilmsError::NoSizes.into());
        };
        let refused = |error| StressError::Bearing { bearing: self.bearing.place.name.clone(), error };
        let ratio = e.map(|part| part / bearing.clearance);
        let size = ratio[0].hypot(ratio[1]);
        let touching = contact_force(bearing, *roughness, size);
        let scale = bearing.force_scale(*viscosity);
        // What the film exerts, and the velocity at which it does.
        let force =
            [0, 1].map(|k| (if size > 0.0 { touching * ratio[k] / size } else { 0.0 } - load[k]) / scale);
        let v = table.velocity(ratio, force).map_err(refused)?;
        let rate = [v[0] - entrainment * e[1], v[1] + entrainment * e[0]];
        let instant =
            FilmInstant { eccentricity: turned(e), rate: turned(rate), entrainment, tilt: [[0.0; 2]; 2] };
        let found = OilPressure::of_film(&self.bearing.place, &self.bearing.law, &instant)?;
        found.ok_or_else(|| BearingFilmsError::NoSizes.into())
    }
}
