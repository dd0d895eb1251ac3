//! What the film of one bearing of an engine does over the cycle, with its oil's temperature.

use crate::balance::{BALANCED, FilmEnergy};
use crate::bearing::JournalBearing;
use crate::cavitation::Cavitation;
use crate::direct::{DirectOrbit, DirectRequest};
use crate::error::FilmError;
use crate::oil::{OilCurve, temperature_rise};
use crate::orbit::{FilmOrbit, JournalCycle, OrbitOutcome, OrbitRequest, journal_orbit};
use crate::plane::Plane;
use crate::problem::Feed;
use crate::shaft::{FloatingShaft, ShaftJournal, ShaftRequest};
use crate::table::FilmTable;
use serde::{Deserialize, Serialize};

/// Repeats of the heat balance, and the change of temperature that ends it [K].
const MOST_REPEATS: usize = 25;
const SAME_TEMPERATURE: f64 = 0.1;
/// Largest rise that is told [K].
const HIGHEST_RISE: f64 = 1000.0;
/// Hottest film that the balance follows [K]: oil is destroyed well below.
const HOTTEST: f64 = 573.15;

/// Which bearing of the engine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BearingKind {
    /// A main bearing.
    Main,
    /// A big-end bearing.
    Crankpin,
}

/// The oil of a bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FilmOil {
    /// The same viscosity whatever the temperature [Pa s], and the density [kg/m3].
    Fixed {
        /// Dynamic viscosity [Pa s].
        viscosity: f64,
        /// Density [kg/m3].
        density: f64,
    },
    /// Viscosity by temperature; supplied at this temperature [K].
    Curve {
        /// The oil.
        oil: OilCurve,
        /// Temperature of supply [K].
        supply: f64,
    },
}

/// A bearing of an engine and its film over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct BearingFilm {
    /// Main or big end.
    pub kind: BearingKind,
    /// Number of its crankshaft, from 1.
    pub crankshaft: usize,
    /// Number of the main bearing on its crankshaft, or of the cylinder.
    pub number: usize,
    /// The bearing.
    pub bearing: JournalBearing,
    /// Model of cavitation.
    pub cavitation: Cavitation,
    /// Viscosity of the film [Pa s].
    pub viscosity: f64,
    /// Rise of temperature through the film [K]; `None` where no flow takes the heat away, as in full films, or the rise is more than 1000 K.
    pub temperature_rise: Option<f64>,
    /// Temperature of the film [K], where that of supply is known: the balance was repeated until it changed by 0.1 K.
    pub temperature: Option<f64>,
    /// Whether that balance was found.
    pub heat_balanced: bool,
    /// Largest load [N].
    pub largest_load: f64,
    /// Largest and mean load over diameter times length [Pa].
    pub projected_pressure: [f64; 2],
    /// Direction of the least film in the shell's frame [rad]: of a main that of the engine, of a big end from the rod's line towards the piston.
    pub least_film_in_shell: f64,
    /// Crank angle of the least film [rad].
    pub least_film_angle: f64,
    /// Crank angle of the largest pressure [rad].
    pub largest_pressure_angle: f64,
    /// Composite roughness [m].
    pub roughness: f64,
    /// Turns of the journal for one of crankshaft 1, below 0 against it.
    #[serde(default)]
    pub journal_turns: f64,
    /// Angle of the shell's frame at the instants of the orbit [rad]: of a big end the rod's line towards the piston. Empty: it does not turn.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub shell_angle: Vec<f64>,
    /// Of a journal of a shaft that floats in its films: what film and contact carry at every instant [N], and the slope of its axis [rad].
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub carried: Vec<Carried>,
    /// Orbit and film.
    pub orbit: FilmOrbit,
}

/// A journal of a floating shaft at an instant.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Carried {
    /// Force of the journal on its bearing [N].
    pub load: Plane,
    /// Slope of its axis along x and y [rad].
    pub slope: Plane,
}

/// How a shaft that floats in its films ran.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ShaftRun {
    /// Number of the crankshaft, from 1.
    pub crankshaft: usize,
    /// Model of cavitation.
    pub cavitation: Cavitation,
    /// How the orbits ended.
    pub outcome: OrbitOutcome,
    /// Periods that were run.
    pub periods: usize,
    /// Largest change of an orbit from the last period but one, over the clearance.
    pub change: f64,
    /// Energies of the last period; `None` where it ended early.
    pub energy: Option<FilmEnergy>,
    /// Missing energy over the turnover.
    pub energy_error: Option<f64>,
    /// Steps of all periods.
    pub steps: u64,
}

impl ShaftRun {
    /// Whether its energies balance to 1e-4.
    pub fn is_balanced(&self) -> bool {
        self.energy_error.is_some_and(|error| error <= BALANCED)
    }
}

/// Where the force of a film comes from.
#[derive(Debug, Clone, Copy)]
pub enum FilmSource<'a> {
    /// A table.
    Table(&'a FilmTable),
    /// The film, solved at every instant of the load.
    Direct {
        /// Cavitation.
        cavitation: Cavitation,
        /// Grooves and holes, in the shell's frame.
        feeds: &'a [Feed],
    },
}

/// What a film of the engine is computed of.
#[derive(Debug, Clone, Copy)]
pub struct BearingFilmRequest<'a> {
    /// Main or big end.
    pub kind: BearingKind,
    /// Number of its crankshaft, from 1.
    pub crankshaft: usize,
    /// Number of the main bearing or cylinder.
    pub number: usize,
    /// The bearing.
    pub bearing: JournalBearing,
    /// Where the film's force comes from.
    pub source: FilmSource<'a>,
    /// Load and speeds.
    pub cycle: &'a JournalCycle,
    /// Angle of the shell's frame at every instant [rad].
    pub shell: &'a [f64],
    /// Period of the crank angle [rad].
    pub period: f64,
    /// Composite roughness [m].
    pub roughness: f64,
    /// Oil.
    pub oil: FilmOil,
}

/// The film of one bearing, with the heat balance where the oil's viscosity depends on temperature.
///
/// # Errors
/// As [`journal_orbit`].
pub fn bearing_film(request: &BearingFilmRequest) -> Result<BearingFilm, FilmError> {
    // A film that is solved goes on from where the last viscosity left the journal.
    let mut direct = match request.source {
        FilmSource::Table(_) => None,
        FilmSource::Direct { cavitation, feeds } => Some(DirectOrbit::new(&DirectRequest {
            bearing: request.bearing,
            cavitation,
            cycle: request.cycle,
            shell: request.shell,
            feeds,
            roughness: request.roughness,
        })?),
    };
    let is_direct = direct.is_some();
    let mut orbit_at = |viscosity: f64| match (&mut direct, request.source) {
        (Some(direct), _) => direct.run(viscosity),
        (None, FilmSource::Table(table)) => journal_orbit(&OrbitRequest {
            bearing: request.bearing,
            table,
            viscosity,
            cycle: request.cycle,
            roughness: request.roughness,
            mass: None,
        }),
        (None, FilmSource::Direct { .. }) => Err(FilmError::NoLand),
    };
    let (mut viscosity, mut temperature) = (request.oil.viscosity(None), request.oil.supply());
    let mut balanced = temperature.is_none();
    let density = request.oil.density();
    let mut orbit = orbit_at(viscosity)?;
    let rise_of = |orbit: &FilmOrbit| {
        Some(temperature_rise(orbit.friction_power, orbit.side_flow, density))
            .filter(|rise| (0.0..=HIGHEST_RISE).contains(rise))
    };
    let mut rise = rise_of(&orbit);
    if let FilmOil::Curve { oil, supply } = request.oil {
        let mut film = supply;
        let mut last: Option<[f64; 2]> = None;
        for _ in 0..MOST_REPEATS {
            // Half the step: friction falls as the film warms, so that the whole one may swing.
            let missing = supply + rise.unwrap_or(HIGHEST_RISE) - film;
            if missing.abs() < SAME_TEMPERATURE {
                balanced = true;
                break;
            }
            // What costs a solution an instant is found by secants, which need fewer.
            let slope =
                last.filter(|_| is_direct).map(|[before, lacked]| (missing - lacked) / (film - before));
            let step = slope.filter(|slope| *slope < -0.5).map_or(0.5 * missing, |slope| -missing / slope);
            last = Some([film, missing]);
            film = (film + step).min(HOTTEST);
            viscosity = oil.viscosity(film);
            orbit = orbit_at(viscosity)?;
            rise = rise_of(&orbit);
        }
        temperature = Some(film);
    }
    Ok(told(request, request.cycle, Found { orbit, viscosity, temperature, rise, balanced }))
}

/// An orbit with the oil that it was computed with.
struct Found {
    orbit: FilmOrbit,
    viscosity: f64,
    temperature: Option<f64>,
    rise: Option<f64>,
    balanced: bool,
}

/// What is told of an orbit under the loads of `cycle`.
fn told(request: &BearingFilmRequest, cycle: &JournalCycle, found: Found) -> BearingFilm {
    let Found { orbit, viscosity, temperature, rise, balanced } = found;
    let sizes = cycle.load.iter().map(|load| load[0].hypot(load[1]));
    let largest_load = sizes.clone().fold(0.0, f64::max);
    let area = 2.0 * request.bearing.radius * request.bearing.length;
    let n = cycle.load.len();
    let least = ((orbit.least_film_at * n as f64).round() as usize).min(n - 1);
    let frame = request.shell.get(least).copied().unwrap_or(0.0);
    BearingFilm {
        kind: request.kind,
        crankshaft: request.crankshaft,
        number: request.number,
        bearing: request.bearing,
        cavitation: request.source.cavitation(),
        viscosity,
        temperature_rise: rise,
        temperature,
        heat_balanced: balanced,
        largest_load,
        projected_pressure: [largest_load / area, sizes.sum::<f64>() / n as f64 / area],
        least_film_in_shell: (orbit.least_film_angle - frame)
            .sin()
            .atan2((orbit.least_film_angle - frame).cos()),
        least_film_angle: orbit.least_film_at * request.period,
        largest_pressure_angle: orbit.largest_pressure_at * request.period,
        roughness: request.roughness,
        journal_turns: journal_speed(cycle) * cycle.duration / request.period,
        shell_angle: request.shell.to_vec(),
        carried: Vec::new(),
        orbit,
    }
}

/// Mean angular speed of the journal [rad/s].
fn journal_speed(cycle: &JournalCycle) -> f64 {
    let speeds = cycle.entrainment.iter().zip(&cycle.sliding).map(|(mean, sliding)| mean + 0.5 * sliding);
    speeds.sum::<f64>() / cycle.entrainment.len() as f64
}

/// A rigid shaft whose bearings share its loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftBody {
    /// Its mass [kg].
    pub mass: f64,
    /// Its moment of inertia across its axis, about its centre of mass [kg m2].
    pub inertia: f64,
    /// About its axis [kg m2].
    pub polar: f64,
    /// Its speed [rad/s], positive from x to y.
    pub speed: f64,
}

/// The films of all bearings of a rigid shaft that floats in them, each with its heat balance; `requests` with tables, `places` along the shaft from its
/// centre of mass [m]. The sums of the loads of the requests and of their moments load the shaft, and each film tells the load that it carries. With them how
/// the run ended.
///
/// # Errors
/// As [`FloatingShaft::new`] and [`FloatingShaft::run`]; [`FilmError::NoLand`] for a film that is not one of a table.
pub fn shaft_films(
    requests: &[BearingFilmRequest],
    places: &[f64],
    body: ShaftBody,
) -> Result<(Vec<BearingFilm>, ShaftRun), FilmError> {
    let mut journals = Vec::with_capacity(requests.len());
    for (own, z) in requests.iter().zip(places) {
        let FilmSource::Table(table) = own.source else { return Err(FilmError::NoLand) };
        journals.push(ShaftJournal { z: *z, bearing: own.bearing, table, cycle: own.cycle });
    }
    let ShaftBody { mass, inertia, polar, speed } = body;
    let roughness = requests.first().map_or(0.0, |own| own.roughness);
    let request = ShaftRequest { journals: &journals, mass, inertia, polar, speed, roughness };
    let mut shaft = FloatingShaft::new(&request)?;
    let mut films: Vec<Option<f64>> = requests.iter().map(|own| own.oil.supply()).collect();
    let viscosities = |films: &[Option<f64>]| -> Vec<f64> {
        requests.iter().zip(films).map(|(own, film)| own.oil.viscosity(*film)).collect()
    };
    let rise_of = |own: &BearingFilmRequest, orbit: &FilmOrbit| {
        Some(temperature_rise(orbit.friction_power, orbit.side_flow, own.oil.density()))
            .filter(|rise| (0.0..=HIGHEST_RISE).contains(rise))
    };
    let mut is_balanced = films.iter().all(Option::is_none);
    for _ in 0..MOST_REPEATS {
        if is_balanced {
            break;
        }
        let found = shaft.run(&viscosities(&films), false)?;
        if found.outcome == OrbitOutcome::Overloaded {
            break;
        }
        is_balanced = true;
        for ((own, orbit), film) in requests.iter().zip(&found.orbits).zip(&mut films) {
            let (Some(film), Some(supply)) = (film, own.oil.supply()) else { continue };
            let missing = supply + rise_of(own, orbit).unwrap_or(HIGHEST_RISE) - *film;
            if missing.abs() >= SAME_TEMPERATURE {
                is_balanced = false;
                *film = (*film + 0.5 * missing).min(HOTTEST);
            }
        }
    }
    let at = viscosities(&films);
    let found = shaft.run(&at, true)?;
    let run = match (requests.first(), found.orbits.first()) {
        (Some(own), Some(orbit)) => ShaftRun {
            crankshaft: own.crankshaft,
            cavitation: own.source.cavitation(),
            outcome: found.outcome,
            periods: orbit.periods,
            change: orbit.change,
            energy: found.energy,
            energy_error: found.energy.map(|energy| energy.error()),
            steps: orbit.steps,
        },
        _ => return Err(FilmError::NoLand),
    };
    let each = requests.iter().zip(found.orbits).zip(found.loads).zip(films).zip(at);
    let films = each
        .map(|((((own, orbit), load), temperature), viscosity)| {
            let rise = rise_of(own, &orbit);
            let carried =
                load.iter().zip(&found.slopes).map(|(load, slope)| Carried { load: *load, slope: *slope });
            let carried = carried.collect();
            let cycle = JournalCycle { load, ..own.cycle.clone() };
            let balanced = is_balanced;
            BearingFilm {
                carried,
                ..told(own, &cycle, Found { orbit, viscosity, temperature, rise, balanced })
            }
        })
        .collect();
    Ok((films, run))
}

impl FilmSource<'_> {
    /// Its model of cavitation.
    fn cavitation(&self) -> Cavitation {
        match self {
            FilmSource::Table(table) => table.cavitation(),
            FilmSource::Direct { cavitation, .. } => *cavitation,
        }
    }
}

impl FilmOil {
    /// Temperature at which oil with a curve is supplied [K].
    fn supply(&self) -> Option<f64> {
        match self {
            FilmOil::Fixed { .. } => None,
            FilmOil::Curve { supply, .. } => Some(*supply),
        }
    }

    /// Its viscosity [Pa s] at the film's temperature [K], if that counts.
    fn viscosity(&self, film: Option<f64>) -> f64 {
        match self {
            FilmOil::Fixed { viscosity, .. } => *viscosity,
            FilmOil::Curve { oil, supply } => oil.viscosity(film.unwrap_or(*supply)),
        }
    }

    fn density(&self) -> f64 {
        match self {
            FilmOil::Fixed { density, .. } => *density,
            FilmOil::Curve { oil, .. } => oil.density,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn heat_balance_closes_on_its_own_numbers() {
        let bearing = JournalBearing::new(0.025, 0.02, 2.5e-5).expect("plausible");
        let table = FilmTable::new(0.4, Cavitation::Gumbel).expect("a table");
        let n = 120;
        let load = (0..n)
            .map(|i| TAU * f64::from(i) / f64::from(n))
            .map(|a| [3000.0 + 2000.0 * a.cos(), 1500.0 * a.sin()]);
        let cycle = JournalCycle {
            duration: 0.02,
            load: load.collect(),
            entrainment: vec![157.0; n as usize],
            sliding: vec![314.0; n as usize],
        };
        let oil = OilCurve::of_grade("5W-30", 850.0).expect("known");
        let request = BearingFilmRequest {
            kind: BearingKind::Main,
            crankshaft: 1,
            number: 1,
            bearing,
            source: FilmSource::Table(&table),
            cycle: &cycle,
            shell: &[],
            period: TAU,
            roughness: 0.0,
            oil: FilmOil::Curve { oil, supply: 363.15 },
        };
        let found = bearing_film(&request).expect("a film");
        let film = found.temperature.expect("known");
        let rise = found.temperature_rise.expect("its flow takes the heat");
        assert!(found.heat_balanced && (film - 363.15 - rise).abs() < 0.1, "{film} {rise}");
        assert!((found.viscosity / oil.viscosity(film) - 1.0).abs() < 1e-12 && rise > 0.5);
        // Half of the shell and less is under pressure, where films are thin.
        let share = found.orbit.friction_power_of_pressure_part / found.orbit.friction_power;
        assert!(share > 0.4 && share < 0.95, "{share}");
        assert!((found.journal_turns - 314.0 * 0.02 / TAU).abs() < 1e-12);
        let fixed = bearing_film(&BearingFilmRequest {
            oil: FilmOil::Fixed { viscosity: found.viscosity, density: 850.0 },
            ..request
        })
        .expect("a film");
        assert_eq!(fixed.orbit.least_film, found.orbit.least_film);
    }
}
