//! Oil films of every main and big end of an engine: loads of the closed form, films of `film`.

use crate::torque_report::bearing_sizes;
use lanchester_film::{
    BearingFilm, BearingFilmRequest, BearingKind, Cavitation, DENSITY, Feed, FilmError, FilmOil, FilmSource,
    FilmTable, JournalBearing, JournalCycle, OilCurve, bearing_film, check_density, check_viscosity,
    oil_grades,
};
use lanchester_mechanism::{BearingLoads, BearingSize};
use lanchester_model::{BearingData, Cavitation as FileCavitation, Engine, Oil, OilGroove};
use lanchester_report::{FilmsInput, Section, films_section};
use num_complex::Complex64;
use rayon::prelude::*;
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

/// Whether films have the grooves of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Grooves {
    /// No: orbits go by tables of films without grooves, in milliseconds. A film that keeps its oil is taken by Reynolds' condition.
    #[default]
    LeftOut,
    /// Yes, with their supply pressure: the films of bearings with grooves are solved at every instant, which takes seconds each.
    Solved,
}

/// Films under these loads, quasi-static, by the models of cavitation given, without any by that of the file (else Guembel's).
///
/// # Errors
/// [`BearingFilmsError`] where sizes or oil are not known, or a number lies outside what a film can have.
pub fn bearing_films(
    engine: &Engine,
    loads: &BearingLoads,
    models: &[Cavitation],
    grooves: Grooves,
) -> Result<BearingFilms, BearingFilmsError> {
    films_at(engine, loads, models, grooves, &mut Vec::new())
}

/// The same at several speeds, in their order.
///
/// # Errors
/// As [`bearing_films`].
pub fn bearing_films_over_speed(
    engine: &Engine,
    loads: &[BearingLoads],
    models: &[Cavitation],
    grooves: Grooves,
) -> Result<Vec<BearingFilms>, BearingFilmsError> {
    let mut tables = Vec::new();
    loads.iter().map(|loads| films_at(engine, loads, models, grooves, &mut tables)).collect()
}

/// Films at one speed; tables that are there already are used again.
fn films_at(
    engine: &Engine,
    loads: &BearingLoads,
    models: &[Cavitation],
    grooves: Grooves,
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
    let supply = engine.bearing_design.as_ref().and_then(|design| design.oil.supply_pressure);
    let own: Vec<Vec<Feed>> = places.iter().map(|place| place.feeds(supply.unwrap_or(0.0))).collect();
    assumptions.extend(words_of_feeds(&own, supply, grooves, wanted.contains(&Cavitation::MassConserving)));
    let feeds = match grooves {
        Grooves::Solved => own,
        Grooves::LeftOut => vec![Vec::new(); places.len()],
    };
    assumptions.push(
        "crank and shells rigid, journals parallel to them, without mass (quasi-static); indeterminate mains as in the table of loads".into(),
    );
    let mut asked = Vec::new();
    for (place, feeds) in places.iter().zip(&feeds) {
        let refused = |error| BearingFilmsError::Bearing { bearing: place.name(), error };
        let bearing = place.bearing().map_err(refused)?;
        let mut models: Vec<Cavitation> = Vec::new();
        for &model in &wanted {
            // A film without a groove runs dry where its oil is kept.
            let is_dry = model == Cavitation::MassConserving && feeds.is_empty();
            let cavitation = if is_dry { Cavitation::Reynolds } else { model };
            if models.contains(&cavitation) {
                continue;
            }
            models.push(cavitation);
            let slenderness = bearing.slenderness();
            let known = |table: &FilmTable| {
                table.cavitation() == cavitation && (table.slenderness() / slenderness - 1.0).abs() < 1e-9
            };
            let table = match tables.iter().position(known) {
                _ if !feeds.is_empty() => None,
                Some(index) => Some(index),
                None => {
                    tables.push(FilmTable::new(slenderness, cavitation).map_err(refused)?);
                    Some(tables.len() - 1)
                }
            };
            asked.push((place, feeds, bearing, cavitation, table));
        }
    }
    let film = |&(place, feeds, bearing, cavitation, table): &(&Place, &Vec<Feed>, _, _, Option<usize>)| {
        let request = BearingFilmRequest {
            kind: place.kind,
            crankshaft: place.crankshaft,
            number: place.number,
            bearing,
            source: match table.and_then(|index| tables.get(index)) {
                Some(table) => FilmSource::Table(table),
                None => FilmSource::Direct { cavitation, feeds },
            },
            cycle: &place.cycle,
            shell: &place.shell,
            period: loads.period,
            roughness,
            oil,
        };
        bearing_film(&request).map_err(|error| BearingFilmsError::Bearing { bearing: place.name(), error })
    };
    let films = asked.par_iter().map(film).collect::<Result<Vec<_>, _>>()?;
    Ok(BearingFilms {
        version: BEARING_FILMS_VERSION,
        engine: loads.engine.clone(),
        speed: loads.speed,
        period: loads.period,
        films,
        assumptions,
    })
}

/// What of the file's clearances and oil no film can have: all of it at once, each with its bearing and what to do. A file that says nothing of films has none.
pub fn film_faults(engine: &Engine) -> Vec<String> {
    let Some(design) = &engine.bearing_design else { return Vec::new() };
    let mut faults: Vec<String> = Vec::new();
    let mut add = |error: BearingFilmsError| {
        let words = error.to_string();
        if !faults.contains(&words) {
            faults.push(words);
        }
    };
    if design.oil != Oil::default()
        && let Err(error) = oil_of(engine, &mut Vec::new())
    {
        add(error);
    }
    let sizes = bearing_sizes(engine);
    let mut check = |bearing: String, size: Option<BearingSize>, data: &BearingData| {
        if let (Some(size), Some(_)) = (size, data.diametral_clearance)
            && let Err(error) = bearing_of(size, data)
        {
            add(BearingFilmsError::Bearing { bearing, error });
        }
    };
    // Bearings that are like all others are told once.
    check("main bearings".into(), sizes.main, &design.main);
    check("crankpin bearings".into(), sizes.crankpin, &design.crankpin);
    for (index, own) in &design.main_each {
        if own.diametral_clearance.is_some() || own.width.is_some() {
            check(format!("main bearing {}", index + 1), sizes.main, &own.over(&design.main));
        }
    }
    for (index, own) in &design.crankpin_each {
        if own.diametral_clearance.is_some() || own.width.is_some() {
            check(format!("big end of cylinder {}", index + 1), sizes.crankpin, &own.over(&design.crankpin));
        }
    }
    faults
}

fn bearing_of(size: BearingSize, data: &BearingData) -> Result<JournalBearing, FilmError> {
    let clearance = data.diametral_clearance.unwrap_or(ASSUMED_CLEARANCE * size.diameter);
    JournalBearing::new(0.5 * size.diameter, data.width.unwrap_or(size.width), 0.5 * clearance)
}

/// What is said of grooves and the pressure that feeds them.
fn words_of_feeds(
    feeds: &[Vec<Feed>],
    supply: Option<f64>,
    grooves: Grooves,
    is_conserving: bool,
) -> Vec<String> {
    let with_grooves = feeds.iter().filter(|own| !own.is_empty()).count();
    let mut words = Vec::new();
    match (with_grooves, grooves, supply) {
        (0, _, None) => {}
        (0, _, Some(_)) => {
            words.push("the supply pressure acts in grooves, and the file gives none: it is left out".into());
        }
        (_, Grooves::LeftOut, _) => words.push(
            "grooves and supply pressure are left out: they lower the load that a film carries and raise its flow".into(),
        ),
        (_, Grooves::Solved, Some(pressure)) => {
            words.push(format!("grooves are fed with {:.4} bar above the surroundings", pressure / 1e5));
        }
        (_, Grooves::Solved, None) => words.push(
            "grooves are fed with the pressure of the surroundings: no supply_pressure is given".into(),
        ),
    }
    match grooves {
        Grooves::Solved if is_conserving && with_grooves < feeds.len() => words.push(
            "a film that keeps its oil needs a groove that feeds it: without one Reynolds' condition is used, its limit in a flooded bearing".into(),
        ),
        Grooves::LeftOut if is_conserving => words.push(
            "orbits use tables, which mass-conserving films do not have: Reynolds' condition, their limit in a flooded bearing, is used".into(),
        ),
        _ => {}
    }
    words
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

    /// Its grooves, at this pressure [Pa].
    fn feeds(&self, pressure: f64) -> Vec<Feed> {
        let grooves = self.data.grooves.iter().flatten();
        let feed = |own: &OilGroove| Feed::Groove {
            from: own.from,
            to: own.to,
            middle: 0.0,
            width: own.width,
            pressure,
        };
        grooves.map(feed).collect()
    }

    pub(crate) fn bearing(&self) -> Result<JournalBearing, FilmError> {
        bearing_of(self.size, &self.data)
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
