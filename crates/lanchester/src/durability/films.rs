//! The least films of the bearings of an engine, each load computed once.

use super::memory::locked;
use super::meter::EngineDurability;
use super::words::split_hint;
use crate::bearing_films::{Place, big_ends, mains, model_of, oil_of};
use crate::torque_report::bearing_sizes;
use lanchester_film::{
    BearingFilmRequest, BearingKind, Cavitation, FilmError, FilmOil, FilmSource, FilmTable, JournalBearing,
    OrbitOutcome, OrbitRequest, bearing_film, orbit_least_film,
};
use lanchester_mechanism::{BearingPart, BearingRequest, bearing_loads};
use lanchester_model::Engine;
use lanchester_task::{DurabilityCriterion, Measured, Unmeasured};
use rayon::prelude::*;
use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// Angles of a revolution at which loads on journals are taken.
const SAMPLES: usize = 360;
/// Films that are remembered at most.
const MOST_FILMS: usize = 100_000;

/// Least films by bearing, the smallest over the speeds.
pub(super) struct Films {
    mains: Vec<Measured>,
    crankpins: Vec<Measured>,
}

impl Films {
    /// One criterion of them.
    pub fn of(&self, criterion: DurabilityCriterion) -> Measured {
        let smallest = |all: &[Measured], what: &str| {
            // An articulated rod sits on no crankpin: it is not there to be asked.
            let there = all.iter().filter(|one| **one != Measured::Unknown(not_asked())).cloned();
            there.reduce(Measured::smaller).unwrap_or_else(|| {
                Measured::Unknown(Unmeasured {
                    reason: format!("the engine has no {what}"),
                    remedy: "judge it by something else".into(),
                })
            })
        };
        let one = |all: &[Measured], index: usize, what: &str| {
            all.get(index).cloned().unwrap_or_else(|| smallest(&[], what))
        };
        match criterion {
            DurabilityCriterion::MainFilm(Some(index)) => one(&self.mains, index, "such main bearing"),
            DurabilityCriterion::CrankpinFilm(Some(index)) => one(&self.crankpins, index, "such big end"),
            DurabilityCriterion::MainFilm(None) => smallest(&self.mains, "main bearing"),
            DurabilityCriterion::CrankpinFilm(None) => smallest(&self.crankpins, "big end"),
            _ => smallest(&self.mains, "main bearing").smaller(smallest(&self.crankpins, "big end")),
        }
    }
}

/// Which bearings a criterion looks at: mains, then big ends; an index alone where it is one.
fn looks_at(criterion: DurabilityCriterion, is_main: bool, index: usize) -> bool {
    match criterion {
        DurabilityCriterion::LeastFilm => true,
        DurabilityCriterion::MainFilm(own) => is_main && own.is_none_or(|own| own == index),
        DurabilityCriterion::CrankpinFilm(own) => !is_main && own.is_none_or(|own| own == index),
        _ => false,
    }
}

impl EngineDurability<'_> {
    /// The least films that `criteria` look at.
    pub(super) fn films_of(&self, engine: &Engine, criteria: &[DurabilityCriterion]) -> Films {
        let counts = [engine.main_bearings().len(), engine.cylinders.len()];
        let all = |why: &Unmeasured| Films {
            mains: vec![Measured::Unknown(why.clone()); counts[0]],
            crankpins: vec![Measured::Unknown(why.clone()); counts[1]],
        };
        if !criteria.iter().any(|criterion| criterion.is_film()) {
            return all(&not_asked());
        }
        let mut whole =
            Films { mains: vec![Measured::Unknown(not_asked()); counts[0]], crankpins: Vec::new() };
        whole.crankpins = vec![Measured::Unknown(not_asked()); counts[1]];
        for (round, speed) in self.speeds(engine).into_iter().enumerate() {
            let found = match self.films_at(engine, criteria, speed) {
                Ok(found) => found,
                Err(why) => return all(&why),
            };
            let join = |all: &mut Vec<Measured>, index: usize, measured: Measured| {
                let Some(own) = all.get_mut(index) else { return };
                let before = std::mem::replace(own, Measured::Unknown(not_asked()));
                *own = if round == 0 { measured } else { before.smaller(measured) };
            };
            for (kind, index, measured) in found {
                match kind {
                    BearingKind::Main => join(&mut whole.mains, index, measured),
                    BearingKind::Crankpin => join(&mut whole.crankpins, index, measured),
                }
            }
        }
        whole
    }

    /// At one speed of the measured engine: kind, index and film of every bearing that is looked at.
    fn films_at(
        &self,
        engine: &Engine,
        criteria: &[DurabilityCriterion],
        speed: f64,
    ) -> Result<Vec<(BearingKind, usize, Measured)>, Unmeasured> {
        let sizes = bearing_sizes(engine);
        check_oil(engine)?;
        let oil = oil_of(engine, &mut Vec::new())
            .map_err(|error| split_hint(&error.to_string(), "correct [bearings.film]"))?;
        // Pressures over the angle are those of the engine at its own speed.
        let own_speed = speed / self.request.speed_of_original;
        let gas = self.pressures(engine, own_speed)?;
        let part = if gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
        let asked = BearingRequest { speed: Some(speed), part, samples: SAMPLES, counterweights: true };
        let loads = bearing_loads(engine, gas.as_deref(), &asked)
            .map_err(|error| split_hint(&error.to_string(), "complete the engine file"))?;
        let mut places: Vec<(usize, Place)> = Vec::new();
        let mut found = Vec::new();
        let mut take = |kind: BearingKind, own: Option<Vec<Place>>, count: usize, section: &str| {
            let is_main = kind == BearingKind::Main;
            let wanted = |index: usize| criteria.iter().any(|own| looks_at(*own, is_main, index));
            match own {
                Some(own) => {
                    for (index, place) in own.into_iter().enumerate() {
                        let index = if is_main { index } else { place.number - 1 };
                        if wanted(index) {
                            places.push((index, place));
                        }
                    }
                }
                None => {
                    let why = Unmeasured {
                        reason: format!("diameter and width of the {section} bearings are not known"),
                        remedy: format!(
                            "give diameter and width in [bearings.{section}], or the crankshaft as a body in [crank.body]"
                        ),
                    };
                    let missing = (0..count).filter(|index| wanted(*index));
                    found.extend(missing.map(|index| (kind, index, Measured::Unknown(why.clone()))));
                }
            }
        };
        let of_mains = sizes.main.map(|size| mains(engine, &loads, size));
        take(BearingKind::Main, of_mains, engine.main_bearings().len(), "main");
        let of_pins = sizes.crankpin.map(|size| big_ends(engine, &loads, size));
        take(BearingKind::Crankpin, of_pins, engine.cylinders.len(), "crankpin");
        let roughness = engine.bearing_design.as_ref().and_then(|design| design.oil.roughness).unwrap_or(0.0);
        let cavitation = engine
            .bearing_design
            .as_ref()
            .and_then(|design| design.oil.cavitation)
            .map_or(Cavitation::Gumbel, model_of);
        // Orbits go by table: in a flooded bearing Reynolds' condition is what the mass-conserving film tends to.
        let cavitation =
            if cavitation == Cavitation::MassConserving { Cavitation::Reynolds } else { cavitation };
        let measured: Vec<(BearingKind, usize, Measured)> = places
            .into_par_iter()
            .map(|(index, place)| {
                let film = self.film(
                    place.scaled(self.request.length),
                    oil,
                    cavitation,
                    roughness,
                    loads.period,
                    own_speed,
                );
                let (kind, measured) = film;
                (kind, index, measured)
            })
            .collect();
        found.extend(measured);
        Ok(found)
    }

    fn film(
        &self,
        place: Place,
        oil: FilmOil,
        cavitation: Cavitation,
        roughness: f64,
        period: f64,
        speed: f64,
    ) -> (BearingKind, Measured) {
        let kind = place.kind;
        let section = if kind == BearingKind::Main { "main" } else { "crankpin" };
        let refused = |error: FilmError| {
            let Unmeasured { reason, remedy } =
                split_hint(&error.to_string(), &format!("correct [bearings.{section}]"));
            Measured::Unknown(Unmeasured { reason: format!("{}: {reason}", place.name()), remedy })
        };
        if place.data.diametral_clearance.is_none() {
            let why = Unmeasured {
                reason: format!("the clearance of the {section} bearings is not given"),
                remedy: format!("give diametral_clearance in [bearings.{section}]"),
            };
            return (kind, Measured::Unknown(why));
        }
        let measured = place.bearing().and_then(|bearing| {
            let table = self.table(bearing.slenderness(), cavitation)?;
            self.least(&place, bearing, &table, oil, roughness, period, speed)
        });
        let (thickness, outcome) = match measured {
            Ok(found) => found,
            Err(error) => return (kind, refused(error)),
        };
        let words = match outcome {
            OrbitOutcome::Overloaded => ", overloaded: thinner than this",
            OrbitOutcome::NotPeriodic => ", orbit not periodic",
            OrbitOutcome::Periodic => "",
        };
        (
            kind,
            Measured::Known { value: thickness, place: place.name() + words, speed, left_out: String::new() },
        )
    }

    fn table(&self, slenderness: f64, cavitation: Cavitation) -> Result<Arc<FilmTable>, FilmError> {
        let mut tables = locked(&self.films.tables);
        let known = |table: &&Arc<FilmTable>| {
            table.cavitation() == cavitation && (table.slenderness() / slenderness - 1.0).abs() < 1e-9
        };
        if let Some(table) = tables.iter().find(known) {
            return Ok(table.clone());
        }
        let table = Arc::new(FilmTable::new(slenderness, cavitation)?);
        tables.push(table.clone());
        Ok(table)
    }

    /// Least film and how its orbit ended.
    #[allow(clippy::too_many_arguments)]
    fn least(
        &self,
        place: &Place,
        bearing: JournalBearing,
        table: &FilmTable,
        oil: FilmOil,
        roughness: f64,
        period: f64,
        speed: f64,
    ) -> Result<(f64, OrbitOutcome), FilmError> {
        let bearing_key = (place.kind == BearingKind::Main, place.crankshaft, place.number, speed.to_bits());
        let held = match oil {
            FilmOil::Fixed { viscosity, .. } => Some(viscosity),
            FilmOil::Curve { .. } => {
                let known = locked(&self.films.viscosities);
                known.get(&bearing_key).copied().filter(|_| self.request.weights_alone)
            }
        };
        let mut hasher = DefaultHasher::new();
        let numbers =
            place.cycle.load.iter().flatten().chain(&place.cycle.entrainment).chain(&place.cycle.sliding);
        numbers.chain(&place.shell).for_each(|number| number.to_bits().hash(&mut hasher));
        let own = [bearing.radius, bearing.length, bearing.clearance, place.cycle.duration, roughness];
        own.iter().chain(&held).for_each(|number| number.to_bits().hash(&mut hasher));
        (table.cavitation() as u8, format!("{oil:?}")).hash(&mut hasher);
        let key = hasher.finish();
        if let Some((thickness, _, outcome)) = locked(&self.films.films).get(&key) {
            return Ok((*thickness, *outcome));
        }
        let (thickness, viscosity, outcome) = match held {
            Some(viscosity) => {
                let found = orbit_least_film(&OrbitRequest {
                    bearing,
                    table,
                    viscosity,
                    cycle: &place.cycle,
                    roughness,
                    mass: None,
                })?;
                (found.thickness, viscosity, found.outcome)
            }
            None => {
                let found = bearing_film(&BearingFilmRequest {
                    kind: place.kind,
                    crankshaft: place.crankshaft,
                    number: place.number,
                    bearing,
                    source: FilmSource::Table(table),
                    cycle: &place.cycle,
                    shell: &place.shell,
                    period,
                    roughness,
                    oil,
                })?;
                (found.orbit.least_film, found.viscosity, found.orbit.outcome)
            }
        };
        if self.request.weights_alone {
            locked(&self.films.viscosities).insert(bearing_key, viscosity);
        }
        let mut films = locked(&self.films.films);
        if films.len() >= MOST_FILMS {
            films.clear();
        }
        films.insert(key, (thickness, viscosity, outcome));
        Ok((thickness, outcome))
    }
}

/// What a bearing is that no criterion looks at.
fn not_asked() -> Unmeasured {
    Unmeasured { reason: "it is not asked for".into(), remedy: "ask for it".into() }
}

/// Refuses oil of which nothing is said: a typical one would make a number of what nobody gave.
fn check_oil(engine: &Engine) -> Result<(), Unmeasured> {
    let oil = engine.bearing_design.as_ref().map(|design| &design.oil);
    match oil {
        Some(oil) if oil.viscosity.is_some() || oil.name.is_some() => Ok(()),
        _ => Err(Unmeasured {
            reason: "the oil of the bearings is not given".into(),
            remedy: "give viscosity, or oil and temperature, in [bearings.film]".into(),
        }),
    }
}

impl Place {
    /// The same of a similar engine at equal piston speed and pressures: lengths times `length`, forces times its square, time as long.
    fn scaled(mut self, length: f64) -> Place {
        if length != 1.0 {
            self.size.diameter *= length;
            self.size.width *= length;
            self.data.width = self.data.width.map(|width| width * length);
            self.data.diametral_clearance = self.data.diametral_clearance.map(|own| own * length);
            self.cycle.duration *= length;
            self.cycle.load.iter_mut().flatten().for_each(|force| *force *= length * length);
            self.cycle.entrainment.iter_mut().for_each(|speed| *speed /= length);
            self.cycle.sliding.iter_mut().for_each(|speed| *speed /= length);
        }
        self
    }
}
