//! Oil films of every main and big end of an engine: loads of the closed form, films of `film`.

use crate::torque_report::bearing_sizes;
use lanchester_film::{
    BearingFilm, BearingFilmRequest, BearingKind, Cavitation, DENSITY, Feed, FilmError, FilmOil, FilmSource,
    FilmTable, JournalBearing, JournalCycle, OilCurve, ShaftBody, ShaftRun, bearing_film, check_density,
    check_viscosity, oil_grades, shaft_films,
};
use lanchester_geometry::crankshaft::crankshaft;
use lanchester_mechanism::{BearingLoads, BearingSize};
use lanchester_model::{BearingData, Cavitation as FileCavitation, Engine, Housing, Oil, OilGroove};
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
    /// How each crankshaft that floats in its films ran, with its energy balance, by crankshaft and model of cavitation; none where journals have no mass.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub shafts: Vec<ShaftRun>,
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
            shafts: &self.shafts,
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
    /// A crankshaft that is no body.
    #[error("{crankshaft} needs its mass and inertia to float in its films: {reason}")]
    NoShaft {
        /// Its name.
        crankshaft: String,
        /// Why there is none.
        reason: String,
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

/// How journals and films are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FilmMethod {
    /// Each journal by itself under its load, without mass, by tables of films without grooves: milliseconds. A film that keeps its oil is taken by
    /// Reynolds' condition.
    #[default]
    Tables,
    /// The same with the grooves of the file and their supply pressure: the films of bearings with grooves are solved at every instant, which takes
    /// seconds each.
    Grooved,
    /// All main journals of a crankshaft together: a rigid body with its mass that floats in their films, which share its loads. Tables, without grooves.
    RigidShaft,
}

/// Films under these loads, by the models of cavitation given, without any by that of the file (else Guembel's).
///
/// # Errors
/// [`BearingFilmsError`] where sizes or oil are not known, or a number lies outside what a film can have.
pub fn bearing_films(
    engine: &Engine,
    loads: &BearingLoads,
    models: &[Cavitation],
    method: FilmMethod,
) -> Result<BearingFilms, BearingFilmsError> {
    films_at(engine, loads, models, method, &mut Vec::new())
}

/// The same at several speeds, in their order.
///
/// # Errors
/// As [`bearing_films`].
pub fn bearing_films_over_speed(
    engine: &Engine,
    loads: &[BearingLoads],
    models: &[Cavitation],
    method: FilmMethod,
) -> Result<Vec<BearingFilms>, BearingFilmsError> {
    let mut tables = Vec::new();
    loads.iter().map(|loads| films_at(engine, loads, models, method, &mut tables)).collect()
}

/// A bearing that is asked for: its place, grooves, sizes, model of cavitation and the index of its table.
type Asked<'a> = (&'a Place, &'a [Feed], JournalBearing, Cavitation, Option<usize>);

/// Films at one speed; tables that are there already are used again.
fn films_at(
    engine: &Engine,
    loads: &BearingLoads,
    models: &[Cavitation],
    method: FilmMethod,
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
    if places.iter().any(|place| matches!(place.data.housing, Some(Housing::Stiffness(_)))) {
        assumptions.push(
            match method {
                FilmMethod::RigidShaft => "`housing_stiffness` is not used: housings and shells are rigid",
                FilmMethod::Tables | FilmMethod::Grooved => {
                    "`housing_stiffness` changes none of these quasi-static films: under a given load a shell only goes along"
                }
            }
            .into(),
        );
    }
    let supply = engine.bearing_design.as_ref().and_then(|design| design.oil.supply_pressure);
    let own: Vec<Vec<Feed>> = places.iter().map(|place| place.feeds(supply.unwrap_or(0.0))).collect();
    assumptions.extend(words_of_feeds(&own, supply, method, wanted.contains(&Cavitation::MassConserving)));
    let feeds = match method {
        FilmMethod::Grooved => own,
        FilmMethod::Tables | FilmMethod::RigidShaft => vec![Vec::new(); places.len()],
    };
    let shafts = match method {
        FilmMethod::RigidShaft => floating_shafts(engine, loads, &places, &mut assumptions)?,
        FilmMethod::Tables | FilmMethod::Grooved => {
            assumptions.push(
                "crank and shells rigid, journals parallel to them, without mass (quasi-static); indeterminate mains as in the table of loads".into(),
            );
            Vec::new()
        }
    };
    let mut asked: Vec<Asked<'_>> = Vec::new();
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
            asked.push((place, feeds.as_slice(), bearing, cavitation, table));
        }
    }
    let request = |index: usize| {
        let (place, feeds, bearing, cavitation, table) = asked[index];
        let source = match table.and_then(|index: usize| tables.get(index)) {
            Some(table) => FilmSource::Table(table),
            None => FilmSource::Direct { cavitation, feeds },
        };
        BearingFilmRequest {
            kind: place.kind,
            crankshaft: place.crankshaft,
            number: place.number,
            bearing,
            source,
            cycle: &place.cycle,
            shell: &place.shell,
            period: loads.period,
            roughness,
            oil,
        }
    };
    // What is computed together: a journal by itself, or all of a shaft with one model.
    let shaft_of = |place: &Place| {
        let is_own = |shaft: &&FloatingShaft| shaft.crankshaft == place.crankshaft;
        shafts.iter().find(is_own).filter(|_| place.kind == BearingKind::Main)
    };
    let mut groups: Vec<(Option<&FloatingShaft>, Vec<usize>)> = Vec::new();
    for (index, (place, _, _, cavitation, _)) in asked.iter().enumerate() {
        let Some(shaft) = shaft_of(place) else {
            groups.push((None, vec![index]));
            continue;
        };
        let is_own = |(other, members): &&mut (Option<&FloatingShaft>, Vec<usize>)| {
            other.is_some_and(|other| other.crankshaft == shaft.crankshaft)
                && asked[members[0]].3 == *cavitation
        };
        match groups.iter_mut().find(is_own) {
            Some((_, members)) => members.push(index),
            None => groups.push((Some(shaft), vec![index])),
        }
    }
    let film = |(shaft, members): &(Option<&FloatingShaft>, Vec<usize>)| {
        let requests: Vec<BearingFilmRequest> = members.iter().map(|index| request(*index)).collect();
        let found = match shaft {
            None => {
                requests.iter().map(bearing_film).collect::<Result<Vec<_>, _>>().map(|films| (films, None))
            }
            Some(shaft) => {
                let place = |index: &usize| shaft.places[asked[*index].0.number - 1];
                let places: Vec<f64> = members.iter().map(place).collect();
                shaft_films(&requests, &places, shaft.body).map(|(films, run)| (films, Some(run)))
            }
        };
        let name = match shaft {
            None => asked[members[0]].0.name(),
            Some(shaft) => format!("main bearings of crankshaft {}", shaft.crankshaft),
        };
        let refused = |error| BearingFilmsError::Bearing { bearing: name, error };
        let (films, run) = found.map_err(refused)?;
        Ok((members.iter().copied().zip(films).collect::<Vec<_>>(), run))
    };
    let found = groups.par_iter().map(film).collect::<Result<Vec<_>, BearingFilmsError>>()?;
    let (films, runs): (Vec<_>, Vec<Option<ShaftRun>>) = found.into_iter().unzip();
    let mut films: Vec<(usize, BearingFilm)> = films.into_iter().flatten().collect();
    films.sort_by_key(|(index, _)| *index);
    let films = films.into_iter().map(|(_, film)| film).collect();
    Ok(BearingFilms {
        version: BEARING_FILMS_VERSION,
        engine: loads.engine.clone(),
        speed: loads.speed,
        period: loads.period,
        films,
        shafts: runs.into_iter().flatten().collect(),
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

/// A crankshaft that floats in the films of its main bearings.
struct FloatingShaft {
    /// Its number, from 1.
    crankshaft: usize,
    /// Planes of its mains from its centre of mass [m].
    places: Vec<f64>,
    body: ShaftBody,
}

/// Crankshafts with two main bearings or more, as bodies.
fn floating_shafts(
    engine: &Engine,
    loads: &BearingLoads,
    places: &[Place],
    assumptions: &mut Vec<String>,
) -> Result<Vec<FloatingShaft>, BearingFilmsError> {
    let mut shafts = Vec::new();
    for (index, own) in engine.crankshafts.iter().enumerate() {
        let number = index + 1;
        let mains = |place: &&Place| place.kind == BearingKind::Main && place.crankshaft == number;
        if places.iter().filter(mains).count() < 2 {
            continue;
        }
        let body = crankshaft(engine, index).map_err(|error| BearingFilmsError::NoShaft {
            crankshaft: own.name.clone(),
            reason: error.to_string(),
        })?;
        let [_, _, middle] = body.mass.centre;
        let [[xx, ..], [_, yy, _], _] = body.mass.inertia_about_centre;
        assumptions.push(format!(
            "{}: a rigid body of {:.3} kg, {:.3e} kg m2 across its axis (mean of both) and {:.3e} kg m2 about it, that floats in the films of its mains, which share its loads; \
             flywheel, pulley and what the rods add to its mass are left out, and its play moves neither rods nor webs",
            own.name,
            body.mass.mass,
            0.5 * (xx + yy),
            body.polar_inertia,
        ));
        let of_shaft = loads.mains.iter().filter(|main| main.crankshaft == number);
        shafts.push(FloatingShaft {
            crankshaft: number,
            places: of_shaft.map(|main| main.z - middle).collect(),
            body: ShaftBody {
                mass: body.mass.mass,
                inertia: 0.5 * (xx + yy),
                polar: body.polar_inertia,
                speed: loads.speed * own.ratio.value(),
            },
        });
    }
    assumptions.push(match shafts.is_empty() {
        true => {
            "no crankshaft has two main bearings: each journal by itself, without mass (quasi-static)".into()
        }
        false => "big ends and single mains: each journal by itself, without mass (quasi-static)".into(),
    });
    assumptions.push("shells rigid; films with parallel axes move the shaft and balance its heat, contact is that of the middle of a bearing; pressure, friction and flow are of films with its tilt, but where an end touches".into());
    Ok(shafts)
}

/// What is said of grooves and the pressure that feeds them.
fn words_of_feeds(
    feeds: &[Vec<Feed>],
    supply: Option<f64>,
    method: FilmMethod,
    is_conserving: bool,
) -> Vec<String> {
    let with_grooves = feeds.iter().filter(|own| !own.is_empty()).count();
    let mut words = Vec::new();
    match (with_grooves, method, supply) {
        (0, _, None) => {}
        (0, _, Some(_)) => {
            words.push("the supply pressure acts in grooves, and the file gives none: it is left out".into());
        }
        (_, FilmMethod::Tables | FilmMethod::RigidShaft, _) => words.push(
            "grooves and supply pressure are left out: they lower the load that a film carries and raise its flow".into(),
        ),
        (_, FilmMethod::Grooved, Some(pressure)) => {
            words.push(format!("grooves are fed with {:.4} bar above the surroundings", pressure / 1e5));
        }
        (_, FilmMethod::Grooved, None) => words.push(
            "grooves are fed with the pressure of the surroundings: no supply_pressure is given".into(),
        ),
    }
    match method {
        FilmMethod::Grooved if is_conserving && with_grooves < feeds.len() => words.push(
            "a film that keeps its oil needs a groove that feeds it: without one Reynolds' condition is used, its limit in a flooded bearing".into(),
        ),
        FilmMethod::Tables | FilmMethod::RigidShaft if is_conserving => words.push(
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
