//! Laws of the bearings from the engine file.

use super::housed_law::HousedLaw;
use super::train::Bearing;
use crate::bearing_films::{
    ASSUMED_CLEARANCE, BearingFilms, BearingFilmsError, FilmMethod, bearing_films, model_of,
};
use crate::stress::request::StressError;
use lanchester_film::{BearingFilm, Cavitation, FilmTable, JournalBearing};
use lanchester_flex::train::TrainLaw;
use lanchester_mechanism::BearingLoads;
use lanchester_model::{BearingLaw, Engine, Housing};
use lanchester_report::CycleLaw;
use std::sync::Arc;

/// Stiffness [N/m] and damping [N s/m] of contacts and bushings where none are given.
const CONTACT: f64 = 5e8;
const BUSHING: f64 = 2e9;
const DAMPING: f64 = 2e4;

/// Laws of all bearings, for every law asked for.
pub(crate) struct BearingLaws {
    laws: Vec<(CycleLaw, Vec<HousedLaw>)>,
    /// Of each bearing the quasi-static film of the rigid crankshaft.
    films: Vec<Option<BearingFilm>>,
}

impl BearingLaws {
    pub fn new(
        engine: &Engine,
        loads: &BearingLoads,
        places: &[Bearing],
        wanted: &[CycleLaw],
        tilt: bool,
        notes: &mut Vec<String>,
    ) -> Result<BearingLaws, StressError> {
        let has =
            |law: BearingLaw| wanted.iter().any(|own| places.iter().any(|place| law_of(*own, place) == law));
        let (mut films, mut tables) = (vec![None; places.len()], Vec::new());
        let design = engine.bearing_design.as_ref();
        let mut cavitation = design.and_then(|own| own.oil.cavitation).map_or(Cavitation::Gumbel, model_of);
        if cavitation == Cavitation::MassConserving {
            cavitation = Cavitation::Reynolds;
        }
        if tilt && !has(BearingLaw::Film) {
            let (reason, hint) =
                ("no bearing that is run has one", "tilt belongs to films: ask for those, or leave it out");
            return Err(StressError::NoFilms { reason, hint });
        }
        if tilt && cavitation != Cavitation::Gumbel {
            let (reason, hint) = (
                "those of tilted journals are Guembel's, the file asks for another cavitation",
                "give cavitation = \"gumbel\" in [bearings.film], or leave the tilt out",
            );
            return Err(StressError::NoFilms { reason, hint });
        }
        if has(BearingLaw::Film) {
            let BearingFilms { films: found, assumptions, .. } =
                bearing_films(engine, loads, &[cavitation], FilmMethod::Tables)?;
            for (place, film) in places.iter().zip(&mut films) {
                let is_same = |own: &&BearingFilm| {
                    (own.kind, own.crankshaft, own.number) == (place.kind, place.crankshaft, place.number)
                };
                *film = found.iter().find(is_same).cloned();
            }
            // What holds for quasi-static films alone is left out.
            let kept = assumptions.into_iter().filter(|own| !own.contains("quasi-static"));
            notes.extend(kept.map(|own| format!("Films: {own}.")));
            if design.is_none_or(|own| own.oil.viscosity.is_none()) {
                notes.push(
                    "Viscosity of each film: that of its heat balance as a quasi-static film of the rigid crankshaft."
                        .to_owned(),
                );
            }
        }
        let lacks = |of: fn(&Bearing) -> bool| places.iter().any(of);
        if has(BearingLaw::Contact) && lacks(|own| own.data.stiffness.is_none()) {
            notes.push(format!(
                "Contacts to which the file gives no stiffness or damping: {CONTACT:.0e} N/m, {DAMPING:.0e} N s/m."
            ));
        }
        if has(BearingLaw::Bushing) && lacks(|own| own.data.stiffness.is_none()) {
            notes.push(format!(
                "Bushings to which the file gives no stiffness or damping: {BUSHING:.0e} N/m, {DAMPING:.0e} N s/m."
            ));
        }
        if has(BearingLaw::Contact)
            && !has(BearingLaw::Film)
            && lacks(|own| own.data.diametral_clearance.is_none())
        {
            notes.push(format!(
                "Diametral clearance where none is given: {ASSUMED_CLEARANCE} of the diameter."
            ));
        }
        let mut own = BearingLaws { laws: Vec::new(), films };
        for law in wanted {
            let laws = places
                .iter()
                .zip(&own.films)
                .map(|(place, film)| {
                    let (cavitation, film) = ((!tilt).then_some(cavitation), film.as_ref());
                    let law = build(engine, *law, place, film, cavitation, &mut tables)?;
                    let housing = stiffness_of_housing(place).filter(|_| law.film().is_some());
                    Ok(HousedLaw { law, housing })
                })
                .collect::<Result<Vec<HousedLaw>, StressError>>()?;
            own.laws.push((*law, laws));
        }
        Ok(own)
    }

    /// One law a bearing.
    pub fn of(&self, law: CycleLaw) -> &[HousedLaw] {
        self.laws.iter().find(|(own, _)| *own == law).map_or(&[], |(_, laws)| laws)
    }

    /// Least film of a bearing of the rigid crankshaft, quasi-static [m].
    pub fn quasi_static(&self, bearing: usize) -> Option<f64> {
        Some(self.films.get(bearing)?.as_ref()?.orbit.least_film)
    }
}

fn law_of(law: CycleLaw, place: &Bearing) -> BearingLaw {
    match law {
        CycleLaw::Rigid => BearingLaw::Rigid,
        CycleLaw::Contact => BearingLaw::Contact,
        CycleLaw::Bushing => BearingLaw::Bushing,
        CycleLaw::Film => BearingLaw::Film,
        CycleLaw::File => place.data.model.unwrap_or(BearingLaw::Film),
    }
}

/// Of a housing that yields [N/m].
fn stiffness_of_housing(place: &Bearing) -> Option<f64> {
    match place.data.housing {
        Some(Housing::Stiffness(stiffness)) => Some(stiffness),
        Some(Housing::Rigid) | None => None,
    }
}

/// A law; films of tilted journals where no `cavitation` is given.
fn build(
    engine: &Engine,
    law: CycleLaw,
    place: &Bearing,
    film: Option<&BearingFilm>,
    cavitation: Option<Cavitation>,
    tables: &mut Vec<Arc<FilmTable>>,
) -> Result<TrainLaw, StressError> {
    let clearance = 0.5 * place.data.diametral_clearance.unwrap_or(ASSUMED_CLEARANCE * place.diameter);
    // A housing that yields stands behind the bearing's own stiffness.
    let stiffness = |usual: f64| {
        let own = place.data.stiffness.unwrap_or(usual);
        stiffness_of_housing(place).map_or(own, |housing| 1.0 / (1.0 / own + 1.0 / housing))
    };
    let damping = place.data.damping.unwrap_or(DAMPING);
    let refused = |error| StressError::Bearing { bearing: place.name(), error };
    Ok(match law_of(law, place) {
        BearingLaw::Rigid => TrainLaw::Rigid,
        BearingLaw::Contact => TrainLaw::Contact { clearance, stiffness: stiffness(CONTACT), damping },
        BearingLaw::Bushing => TrainLaw::bushing(stiffness(BUSHING), damping),
        BearingLaw::Film => {
            let bearing =
                JournalBearing::new(0.5 * place.diameter, place.surface.width, clearance).map_err(refused)?;
            let oil = engine.bearing_design.as_ref().map(|design| &design.oil);
            let viscosity = film.map(|film| film.viscosity).or(oil.and_then(|oil| oil.viscosity));
            let viscosity = viscosity.ok_or(StressError::Films(BearingFilmsError::NoSizes))?;
            let roughness = oil.and_then(|oil| oil.roughness).unwrap_or(0.0);
            let Some(cavitation) = cavitation else {
                return Ok(TrainLaw::TiltedFilm { bearing, viscosity, roughness });
            };
            let slenderness = bearing.slenderness();
            let known = |table: &&Arc<FilmTable>| (table.slenderness() / slenderness - 1.0).abs() < 1e-9;
            let table = match tables.iter().find(known) {
                Some(table) => Arc::clone(table),
                None => {
                    let table = Arc::new(FilmTable::new(slenderness, cavitation).map_err(refused)?);
                    tables.push(Arc::clone(&table));
                    table
                }
            };
            TrainLaw::Film { bearing, table, viscosity, roughness }
        }
    })
}

/// A law with its numbers, in words.
pub(crate) fn law_words(law: &TrainLaw, housing: Option<f64>) -> String {
    let short = |value: f64| format!("{value:.3e}");
    let own = match law {
        TrainLaw::Rigid => "rigid".to_owned(),
        TrainLaw::Contact { clearance, stiffness, damping } => format!(
            "contact, {:.2} um radial clearance, {} N/m, {} N s/m",
            1e6 * clearance,
            short(*stiffness),
            short(*damping)
        ),
        TrainLaw::Bushing { stiffness, damping } => {
            format!("bushing, {} N/m, {} N s/m", short(stiffness[0][0]), short(damping[0][0]))
        }
        TrainLaw::Film { bearing, table, viscosity, .. } => format!(
            "film ({}), {:.2} um radial clearance, {:.3} mPa s",
            table.cavitation().name(),
            1e6 * bearing.clearance,
            1e3 * viscosity
        ),
        TrainLaw::TiltedFilm { bearing, viscosity, .. } => format!(
            "film ({}, journal tilted), {:.2} um radial clearance, {:.3} mPa s",
            Cavitation::Gumbel.name(),
            1e6 * bearing.clearance,
            1e3 * viscosity
        ),
    };
    match housing {
        Some(stiffness) => format!("{own}, housing {} N/m", short(stiffness)),
        None => own,
    }
}
