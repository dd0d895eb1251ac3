//! A crankshaft that rests in the oil films of its main bearings.
//!
//! The equations are factored with springs at the journals; forces on the journals take the springs out again and put the films in. Their pressure acts on the
//! surfaces as the film has it, so that the solution is that of the crankshaft in its films alone.

use crate::FlexError;
use crate::case::{Spring, StaticCase};
use crate::crank_case::{
    BearingSurfaces, CrankCase, CrankLoad, FilmBearing, evaluate, hold_flywheel, load_pins, press_films,
};
use crate::crank_mesh::CrankMesh;
use crate::film_equilibrium::{Compliance, Rest, film_equilibrium};
use crate::journal_in_film::JournalInFilm;
use crate::oil_pressure::OilPressure;
use crate::sparse::SolveEstimate;
use crate::statics::{SolveOptions, StaticSolution, StaticSystem};
use crate::train::{Coupling, FilmInstant, Plane};

/// Stiffness of the springs that only make the matrix positive definite [N/m]: that of a crankshaft between its mains.
const SPRING: f64 = 1e9;
/// Solutions until the motion of the surface under the film's own pressure is the one that the film was computed of.
const MOST_PASSES: usize = 12;
/// Difference of the two over the thickness of the film that counts as none.
const SAME: f64 = 1e-4;
/// Of unit forces [N].
const UNIT: f64 = 1e3;

/// Solves loads, each with the films of its main bearings.
///
/// # Errors
/// [`FlexError::Missing`] where a load has no films, [`FlexError::Number`] for a crankshaft at standstill, in whose bearings no film carries anything;
/// [`FlexError::Overloaded`], [`FlexError::NoConvergence`]; as for other supports.
pub(crate) fn solve_in_films(
    crank: &CrankMesh,
    loads: &[CrankLoad],
    options: SolveOptions,
    watch: &dyn Fn(&SolveEstimate),
) -> Result<Vec<CrankCase>, FlexError> {
    let Some(first) = loads.first() else { return Ok(Vec::new()) };
    check(loads)?;
    let surfaces = BearingSurfaces::new(crank);
    let couplings = first
        .films
        .iter()
        .map(|own| Coupling::new(&crank.mesh, surfaces.areas(&own.place.set)?, &own.place))
        .collect::<Result<Vec<Coupling>, FlexError>>()?;
    let mut support = StaticCase { name: "films".to_owned(), ..StaticCase::default() };
    for (own, coupling) in first.films.iter().zip(&couplings) {
        for (axis, nodes) in ["x", "y"].into_iter().zip(coupling.translation()) {
            let name = format!("{} {axis}", own.place.set);
            support.springs.push(Spring { name, stiffness: SPRING, nodes });
        }
    }
    hold_flywheel(crank, &mut support, &surfaces)?;
    let loaded = |load: &CrankLoad| {
        let own = StaticCase { speed: load.speed, acceleration: load.acceleration, ..support.clone() };
        load_pins(&crank.mesh, &surfaces, own, load)
    };
    let cases = loads.iter().map(loaded).collect::<Result<Vec<StaticCase>, FlexError>>()?;
    let units = couplings
        .iter()
        .flat_map(|own| [[UNIT, 0.0], [0.0, UNIT]].map(|force| own.push(support.clone(), force)));
    let units: Vec<StaticCase> = units.collect();
    let Some(base) = cases.iter().max_by_key(|case| case.turns()) else { return Ok(Vec::new()) };
    let mut system = StaticSystem::new_watched(&crank.mesh, base, options, watch)?;
    let motion = |solution: &StaticSolution| -> Vec<f64> {
        couplings.iter().flat_map(|own| own.motion(&solution.displacements)[0]).collect()
    };
    let columns: Vec<Vec<f64>> =
        system.solve(&units.iter().collect::<Vec<_>>())?.iter().map(&motion).collect();
    let size = columns.len();
    let compliance = Compliance {
        stiffness: SPRING,
        matrix: (0..size * size).map(|at| columns[at % size][at / size] / UNIT).collect(),
    };
    let mut free: Vec<Vec<f64>> =
        system.solve(&cases.iter().collect::<Vec<_>>())?.iter().map(&motion).collect();
    let mut found: Vec<Option<CrankCase>> = loads.iter().map(|_| None).collect();
    let mut waiting: Vec<usize> = (0..loads.len()).collect();
    let mut left = f64::INFINITY;
    for _ in 0..MOST_PASSES {
        let mut rests = Vec::new();
        for k in &waiting {
            let load = &loads[*k];
            let places = film_equilibrium(&load.films, load.speed, &free[*k], &compliance)?;
            let mut case = cases[*k].clone();
            let mut films = Vec::new();
            for ((own, rest), coupling) in load.films.iter().zip(&places).zip(&couplings) {
                let (pressed, oil, force) =
                    press(crank, &surfaces, case, own, rest.eccentricity, load.speed)?;
                case = coupling.push(pressed, rest.place.map(|part| SPRING * part));
                films.push((oil, force));
            }
            rests.push((case, places, films));
        }
        let solved = system.solve(&rests.iter().map(|(case, ..)| case).collect::<Vec<_>>())?;
        let mut still = Vec::new();
        for ((k, solution), (_, places, films)) in waiting.into_iter().zip(solved).zip(rests) {
            let moved = motion(&solution);
            let load = &loads[k];
            let thinnest =
                load.films.iter().zip(&places).map(|(own, rest)| thickness(own, rest.eccentricity));
            let thinnest = thinnest.fold(f64::INFINITY, f64::min);
            let flat = places.iter().flat_map(|rest| rest.place);
            let miss: Vec<f64> = moved.iter().zip(flat).map(|(moved, place)| moved - place).collect();
            let largest = miss.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
            if largest <= SAME * thinnest {
                let states = load.films.iter().zip(&places).zip(&films).zip(&couplings);
                let states = states.map(|(((own, rest), (oil, force)), coupling)| {
                    state(own, *rest, oil, *force, coupling, &solution)
                });
                let states: Vec<JournalInFilm> = states.collect();
                let solution = without_springs(solution, &moved, &places, &states);
                found[k] = Some(CrankCase { films: states, ..evaluate(crank, solution) });
                continue;
            }
            left = largest / thinnest;
            free[k].iter_mut().zip(miss).for_each(|(free, miss)| *free += miss);
            still.push(k);
        }
        waiting = still;
        if waiting.is_empty() {
            return Ok(found.into_iter().flatten().collect());
        }
    }
    Err(FlexError::NoConvergence {
        what: "motion of the journals under the pressure of their oil films",
        iterations: MOST_PASSES,
        residual: left,
        needed: SAME,
        hint: "a load or a speed at which the films have more thickness left",
    })
}

fn check(loads: &[CrankLoad]) -> Result<(), FlexError> {
    for load in loads {
        let is_alike = |(a, b): (&FilmBearing, &FilmBearing)| a.place == b.place;
        let count = load.films.len();
        if count == 0
            || count != loads[0].films.len()
            || !load.films.iter().zip(&loads[0].films).all(is_alike)
        {
            return Err(FlexError::Missing {
                what: "oil film of each main bearing in every load",
                name: format!("{count} films"),
                hint: "give the films of all main bearings with each load",
            });
        }
        if load.speed == 0.0 || !load.speed.is_finite() {
            return Err(FlexError::Number {
                quantity: "speed of a crankshaft that rests in oil films [rad/s]".to_owned(),
                needed: "other than 0".to_owned(),
                got: load.speed,
                hint: "give a speed: at standstill a film carries nothing",
            });
        }
    }
    Ok(())
}

/// The case with the pressure of a film that rests; that pressure, and the force of the film on the journal [N].
fn press(
    crank: &CrankMesh,
    surfaces: &BearingSurfaces,
    case: StaticCase,
    own: &FilmBearing,
    e: Plane,
    speed: f64,
) -> Result<(StaticCase, OilPressure, Plane), FlexError> {
    let entrainment = 0.5 * speed;
    let instant = FilmInstant { eccentricity: e, rate: [0.0; 2], entrainment, tilt: [[0.0; 2]; 2] };
    let missing = || FlexError::Missing {
        what: "oil film",
        name: own.place.name.clone(),
        hint: "a crankshaft in films needs that law for each main bearing",
    };
    let oil = OilPressure::of_film(&own.place, &own.law, &instant)?.ok_or_else(missing)?;
    let force = own.law.force(e, [0.0; 2], entrainment).ok_or_else(missing)?.force;
    let case = press_films(&crank.mesh, surfaces, case, &[&oil], force)?;
    Ok((case, oil, force))
}

/// Least film at the middle [m].
fn thickness(own: &FilmBearing, e: Plane) -> f64 {
    own.law.clearance().map_or(f64::INFINITY, |clearance| clearance - e[0].hypot(e[1]))
}

fn state(
    own: &FilmBearing,
    Rest { eccentricity: e, place }: Rest,
    oil: &OilPressure,
    force: Plane,
    coupling: &Coupling,
    solution: &StaticSolution,
) -> JournalInFilm {
    let clearance = own.law.clearance().unwrap_or(f64::INFINITY);
    let [_, slope] = coupling.motion(&solution.displacements);
    let at = |side: f64| {
        let end = [0, 1].map(|k| e[k] + side * 0.5 * own.place.width * slope[k]);
        clearance - end[0].hypot(end[1])
    };
    let size = force[0].hypot(force[1]);
    JournalInFilm {
        bearing: own.place.name.clone(),
        force,
        eccentricity: e,
        eccentricity_ratio: e[0].hypot(e[1]) / clearance,
        least_film: thickness(own, e),
        least_edge_film: at(-1.0).min(at(1.0)),
        largest_pressure: oil.largest,
        shell: [0, 1].map(|k| place[k] - e[k]),
        contact_share: if size > 0.0 { oil.contact[0].hypot(oil.contact[1]) / size } else { 0.0 },
    }
}

/// Films in the place of the springs: loads are those of the pins and of turning again, reactions those of films and flywheel, energy that of the body.
fn without_springs(
    mut solution: StaticSolution,
    moved: &[f64],
    places: &[Rest],
    films: &[JournalInFilm],
) -> StaticSolution {
    for (k, (rest, film)) in places.iter().zip(films).enumerate() {
        for axis in 0..2 {
            solution.energy -= 0.5 * SPRING * moved[2 * k + axis].powi(2);
            solution.load[axis] -= film.force[axis] + SPRING * rest.place[axis];
            solution.reaction[axis] += film.force[axis] + SPRING * rest.place[axis];
            solution.spring_forces[2 * k + axis] = film.force[axis];
        }
    }
    solution
}
