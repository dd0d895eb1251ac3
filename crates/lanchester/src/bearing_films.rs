//! Oil films of every main and big end of an engine: loads of the closed form, films of `film`.

use crate::torque_report::bearing_sizes;
use lanchester_film::{
    BearingFilm, BearingFilmRequest, BearingKind, Cavitation, DENSITY, FilmError, FilmOil, FilmTable,
    JournalBearing, JournalCycle, OilCurve, bearing_film, check_density, check_viscosity, oil_grades,
};
use lanchester_mechanism::{BearingLoads, BearingSize};
use lanchester_model::{BearingData, Cavitation as FileCavitation, Engine};
use lanchester_report::{FilmsInput, Section, films_section};
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::TAU;

/// Version of the form of [`BearingFilms`].
pub const BEARING_FILMS_VERSION: u32 = 1;
/// Diametral clearance over diameter where none is given.
pub(crate) const ASSUMED_CLEARANCE: f64 = 1e-3;
/// Oil and supply temperature [K] where none are given.
const ASSUMED_OIL: &str = "SAE 5W-30";
const ASSUMED_SUPPLY: f64 = 373.15;

/// Oil films of an engine at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BearingFilms {
    /// [`BEARING_FILMS_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Period of crankshaft 1 [rad].
    pub period: f64,
    /// By bearing and model of cavitation.
    pub films: Vec<BearingFilm>,
    /// What the file does not say and was assumed, and what was left out.
    pub assumptions: Vec<String>,
}

impl BearingFilms {
    /// Their chapter of a report; `None` without a film.
    pub fn section(&self) -> Option<Section> {
        films_section(&self.input())
    }

    /// As the report takes them.
    pub fn input(&self) -> FilmsInput<'_> {
        FilmsInput {
            speed: self.speed,
            period: self.period,
            films: &self.films,
            assumptions: &self.assumptions,
        }
    }
}

/// Why there are no films.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BearingFilmsError {
    /// Neither kind of bearing has a known size.
    #[error(
        "oil films need the diameter and width of the bearings: give [bearings.main] and [bearings.crankpin] with diameter and width, or the crank's \
         body in [crank.body]"
    )]
    NoSizes,
    /// The name of the oil says nothing.
    #[error("unknown value \"{name}\" for the oil: known are SAE {known}; or give its viscosity at work")]
    UnknownOil {
        /// As given.
        name: String,
        /// The grades.
        known: String,
    },
    /// One bearing is refused.
    #[error("{bearing}: {error}")]
    Bearing {
        /// Which one.
        bearing: String,
        /// Why.
        error: FilmError,
    },
}

/// Films under these loads, quasi-static, by the models of cavitation given, without any by that of the file (else Guembel's).
///
/// # Errors
/// [`BearingFilmsError`] where sizes or oil are not known, or a number lies outside what a film can have.
pub fn bearing_films(
    engine: &Engine,
    loads: &BearingLoads,
    models: &[Cavitation],
) -> Result<BearingFilms, BearingFilmsError> {
    films_at(engine, loads, models, &mut Vec::new())
}

/// The same at several speeds, in their order.
///
/// # Errors
/// As [`bearing_films`].
pub fn bearing_films_over_speed(
    engine: &Engine,
    loads: &[BearingLoads],
    models: &[Cavitation],
) -> Result<Vec<BearingFilms>, BearingFilmsError> {
    let mut tables = Vec::new();
    loads.iter().map(|loads| films_at(engine, loads, models, &mut tables)).collect()
}

/// Films at one speed; tables that are there already are used again.
fn films_at(
    engine: &Engine,
    loads: &BearingLoads,
    models: &[Cavitation],
    tables: &mut Vec<FilmTable>,
) -> Result<BearingFilms, BearingFilmsError> {
    let sizes = bearing_sizes(engine);
    if sizes.main.is_none() && sizes.crankpin.is_none() {
        return Err(BearingFilmsError::NoSizes);
    }
    let mut assumptions = Vec::new();
    let oil = oil_of(engine, &mut assumptions)?;
    let roughness = engine.bearing_design.as_ref().and_then(|design| design.oil.roughness).unwrap_or(0.0);
    let mut wanted = models.to_vec();
    if wanted.is_empty() {
        wanted.push(
            engine
                .bearing_design
                .as_ref()
                .and_then(|design| design.oil.cavitation)
                .map_or(Cavitation::Gumbel, model_of),
        );
    }
    if wanted.contains(&Cavitation::MassConserving) {
        wanted.retain(|model| *model != Cavitation::MassConserving);
        if !wanted.contains(&Cavitation::Reynolds) {
            wanted.push(Cavitation::Reynolds);
        }
        assumptions.push(
            "orbits use tables, which mass-conserving films do not have: Reynolds' condition, their limit in a flooded bearing, is used".into(),
        );
    }
    let mut places = Vec::new();
    match sizes.main {
        Some(size) => places.extend(mains(engine, loads, size)),
        None => assumptions.push("main bearings are left out: their diameter and width are not known".into()),
    }
    match sizes.crankpin {
        Some(size) => places.extend(big_ends(engine, loads, size)),
        None => assumptions.push("big ends are left out: their diameter and width are not known".into()),
    }
    if places.iter().any(|place| place.data.diametral_clearance.is_none()) {
        assumptions
            .push(format!("diametral clearance where none is given: {ASSUMED_CLEARANCE} of the diameter"));
    }
    if places.iter().any(|place| place.data.grooves.as_ref().is_some_and(|grooves| !grooves.is_empty())) {
        assumptions.push("grooves and supply pressure are left out: they lower the load that a film carries and raise its flow".into());
    }
    assumptions.push(
        "crank and shells rigid, journals parallel to them, without mass (quasi-static); indeterminate mains as in the table of loads".into(),
    );
    let mut films = Vec::new();
    for place in &places {
        for &cavitation in &wanted {
            let refused = |error| BearingFilmsError::Bearing { bearing: place.name(), error };
            let bearing = place.bearing().map_err(refused)?;
            let slenderness = bearing.slenderness();
            let known = |table: &FilmTable| {
                table.cavitation() == cavitation && (table.slenderness() / slenderness - 1.0).abs() < 1e-9
            };
            let index = match tables.iter().position(known) {
                Some(index) => index,
                None => {
                    tables.push(FilmTable::new(slenderness, cavitation).map_err(refused)?);
                    tables.len() - 1
                }
            };
            let request = BearingFilmRequest {
                kind: place.kind,
                crankshaft: place.crankshaft,
                number: place.number,
                bearing,
                table: &tables[index],
                cycle: &place.cycle,
                shell: &place.shell,
                period: loads.period,
                roughness,
                oil,
            };
            films.push(bearing_film(&request).map_err(refused)?);
        }
    }
    Ok(BearingFilms {
        version: BEARING_FILMS_VERSION,
        engine: loads.engine.clone(),
        speed: loads.speed,
        period: loads.period,
        films,
        assumptions,
    })
}

/// A bearing with its load.
pub(crate) struct Place {
    pub kind: BearingKind,
    pub crankshaft: usize,
    pub number: usize,
    pub size: BearingSize,
    pub data: BearingData,
    pub cycle: JournalCycle,
    pub shell: Vec<f64>,
}

impl Place {
    pub(crate) fn name(&self) -> String {
        match self.kind {
            BearingKind::Main => format!("main bearing {} of crankshaft {}", self.number, self.crankshaft),
            BearingKind::Crankpin => format!("big end of cylinder {}", self.number),
        }
    }

    pub(crate) fn bearing(&self) -> Result<JournalBearing, FilmError> {
        let diameter = self.size.diameter;
        let clearance = self.data.diametral_clearance.unwrap_or(ASSUMED_CLEARANCE * diameter);
        JournalBearing::new(0.5 * diameter, self.data.width.unwrap_or(self.size.width), 0.5 * clearance)
    }
}

pub(crate) fn mains(engine: &Engine, loads: &BearingLoads, size: BearingSize) -> Vec<Place> {
    let all = engine.main_bearings();
    let duration = loads.period / loads.speed;
    let place = |main: &lanchester_mechanism::MainBearing| {
        // Counted as in the file: over all crankshafts, from the free end on.
        let before = all.iter().filter(|(crankshaft, _)| crankshaft + 1 < main.crankshaft).count();
        let speed =
            loads.speed * engine.crankshafts.get(main.crankshaft - 1).map_or(1.0, |own| own.ratio.value());
        let load: Vec<[f64; 2]> = main.load.load.iter().map(|force| [force.re, force.im]).collect();
        let n = load.len();
        let cycle =
            JournalCycle { duration, load, entrainment: vec![0.5 * speed; n], sliding: vec![speed; n] };
        Place {
            kind: BearingKind::Main,
            crankshaft: main.crankshaft,
            number: main.main,
            size,
            data: engine.main_bearing_data(before + main.main - 1),
            cycle,
            shell: Vec::new(),
        }
    };
    loads.mains.iter().map(place).collect()
}

pub(crate) fn big_ends(engine: &Engine, loads: &BearingLoads, size: BearingSize) -> Vec<Place> {
    let duration = loads.period / loads.speed;
    let mut places = Vec::new();
    for own in loads.cylinders.iter().filter(|own| !own.radial.is_empty()) {
        let index = own.cylinder - 1;
        let crankshaft = engine
            .cylinders
            .get(index)
            .and_then(|c| engine.throws.get(c.throw))
            .map_or(0, |throw| throw.crankshaft);
        let speed = loads.speed * engine.crankshafts.get(crankshaft).map_or(1.0, |own| own.ratio.value());
        let rod = rod_angles(&own.lower_pin.load, &own.rod_frame);
        let n = rod.len();
        let step = duration / n as f64;
        let turning: Vec<f64> = (0..n)
            .map(|i| {
                let swing = rod[(i + 1) % n] - rod[(i + n - 1) % n];
                (swing - TAU * (swing / TAU).round()) / (2.0 * step)
            })
            .collect();
        let cycle = JournalCycle {
            duration,
            // The rod's force on the pin is the film's: the load on the pin is against it.
            load: own.lower_pin.load.iter().map(|force| [-force.re, -force.im]).collect(),
            entrainment: turning.iter().map(|rod| 0.5 * (speed + rod)).collect(),
            sliding: turning.iter().map(|rod| speed - rod).collect(),
        };
        places.push(Place {
            kind: BearingKind::Crankpin,
            crankshaft: crankshaft + 1,
            number: own.cylinder,
            size,
            data: engine.crankpin_bearing_data(index),
            cycle,
            shell: rod,
        });
    }
    places
}

/// Angle of the rod at every instant [rad], from the same load in the block's frame (rod on pin) and in the rod's (pin on rod). Where the
/// load is next to nothing, that of the instant before.
fn rod_angles(block: &[Complex64], rod: &[Complex64]) -> Vec<f64> {
    let largest = block.iter().map(|force| force.norm()).fold(0.0, f64::max);
    let mut last = 0.0;
    let angle = |(a, b): (&Complex64, &Complex64)| {
        if a.norm() > 1e-9 * largest {
            last = (-a * b.conj()).arg();
        }
        last
    };
    block.iter().zip(rod).map(angle).collect()
}

pub(crate) fn oil_of(engine: &Engine, assumptions: &mut Vec<String>) -> Result<FilmOil, BearingFilmsError> {
    let given = engine.bearing_design.as_ref().map(|design| design.oil.clone()).unwrap_or_default();
    let density = given.density.unwrap_or(DENSITY);
    check_density(density).map_err(|error| BearingFilmsError::Bearing { bearing: "oil".into(), error })?;
    if let Some(viscosity) = given.viscosity {
        check_viscosity(viscosity)
            .map_err(|error| BearingFilmsError::Bearing { bearing: "oil".into(), error })?;
        return Ok(FilmOil::Fixed { viscosity, density });
    }
    let name = given.name.clone().unwrap_or_else(|| ASSUMED_OIL.to_owned());
    let oil = OilCurve::of_grade(&name, density).ok_or_else(|| BearingFilmsError::UnknownOil {
        name: name.clone(),
        known: oil_grades().collect::<Vec<_>>().join(", "),
    })?;
    let supply = given.temperature.unwrap_or(ASSUMED_SUPPLY);
    let assumed = if given.name.is_none() || given.temperature.is_none() { ", assumed" } else { "" };
    assumptions.push(format!(
        "oil {name} with typical viscosities of its grade, supplied at {:.0} degC{assumed}; the film's temperature by heat balance, 80 % of the friction \
         carried by the oil that leaves at the ends",
        supply - 273.15
    ));
    Ok(FilmOil::Curve { oil, supply })
}

pub(crate) fn model_of(model: FileCavitation) -> Cavitation {
    match model {
        FileCavitation::Full => Cavitation::Full,
        FileCavitation::Gumbel => Cavitation::Gumbel,
        FileCavitation::Reynolds => Cavitation::Reynolds,
        FileCavitation::MassConserving => Cavitation::MassConserving,
    }
}
