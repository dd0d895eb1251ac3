//! Where a crankshaft rests in its oil films.
//!
//! With `x_0` the displacements of the journals under the loads on springs `k`, `C` their compliance on these springs and `f` the forces of the films:
//!
//! ```text
//! x = x_0 + C (f(x, 0) + k x)                                                                                                (book, eq. 43.20)
//! ```

use crate::FlexError;
use crate::crank_case::FilmBearing;
use crate::train::{Plane, TrainLaw};
use lanchester_film::FilmTable;
use lanchester_numerics::Lu;

/// First step of time over the turn of a radian, and the factor from step to step.
const FIRST: f64 = 1e-3;
const GROWTH: f64 = 4.0;
/// First eccentricity ratio.
const OFF: f64 = 0.1;
/// Steps of time, and Newton's steps in each.
const MOST_STEPS: usize = 400;
const MOST_NEWTON: usize = 25;
/// Turns after which nothing moves any more [rad].
const AT_REST: f64 = 1e9;
/// Miss over the clearance that counts as none.
const MET: f64 = 1e-10;
/// Share of what is left of a film by which one of Newton's steps may thin it.
const THINNED: f64 = 0.7;

/// What the journals do without films, and what forces on them add.
pub(crate) struct Compliance {
    /// Stiffness of the springs [N/m].
    pub stiffness: f64,
    /// Displacements along x and y of each journal by a force along each of them [m/N], row by row.
    pub matrix: Vec<f64>,
}

/// Places of the journals' centres [m] where films, loads and the elastic crankshaft are in equilibrium and stay. `free`: the places under the loads
/// without films; `speed` of the crankshaft [rad/s].
///
/// # Errors
/// [`FlexError::Overloaded`] where a film has no thickness left; [`FlexError::NoConvergence`].
pub(crate) fn film_equilibrium(
    films: &[FilmBearing],
    speed: f64,
    free: &[f64],
    compliance: &Compliance,
) -> Result<Vec<Plane>, FlexError> {
    let largest = films.iter().filter_map(|own| own.law.clearance()).fold(0.0, f64::max);
    let mut x = start(films, free);
    let mut turn = FIRST;
    let mut miss = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let is_last = turn >= AT_REST;
        let per_time = if is_last { 0.0 } else { speed.abs() / turn };
        match step(films, speed, free, compliance, &x, per_time, MET * largest) {
            Ok(next) => {
                x = next;
                if is_last {
                    let found: Vec<Plane> = x.chunks_exact(2).map(|own| [own[0], own[1]]).collect();
                    return within_tables(films, &found).map(|()| found);
                }
                turn *= GROWTH;
            }
            Err(left) => {
                miss = left;
                // What does not come to rest in one step goes on in time.
                turn = if is_last { 1.0 } else { turn / (GROWTH * GROWTH) };
            }
        }
        if turn < 1e-9 {
            break;
        }
    }
    Err(FlexError::NoConvergence {
        what: "equilibrium of the journals in their oil films",
        iterations: MOST_STEPS,
        residual: miss,
        needed: MET * largest,
        hint: "a load or a speed at which the films have more thickness left",
    })
}

/// Off the middle, where a film at rest has no stiffness, to the side of the load.
fn start(films: &[FilmBearing], free: &[f64]) -> Vec<f64> {
    let of = |(own, free): (&FilmBearing, &[f64])| {
        let length = free[0].hypot(free[1]);
        let along = if length > 0.0 { [free[0] / length, free[1] / length] } else { [1.0, 0.0] };
        along.map(|part| OFF * own.law.clearance().unwrap_or(0.0) * part)
    };
    films.iter().zip(free.chunks_exact(2)).flat_map(of).collect()
}

/// One implicit step of time, by Newton's method; the miss [m] that is left where it fails.
fn step(
    films: &[FilmBearing],
    speed: f64,
    free: &[f64],
    compliance: &Compliance,
    from: &[f64],
    per_time: f64,
    met: f64,
) -> Result<Vec<f64>, f64> {
    let size = free.len();
    let mut x = from.to_vec();
    let mut miss = f64::INFINITY;
    for _ in 0..MOST_NEWTON {
        // Forces on the journals and their derivatives, two by two.
        let mut force = vec![0.0; size];
        let mut slope = vec![[[0.0; 2]; 2]; films.len()];
        for (k, own) in films.iter().enumerate() {
            let e = [x[2 * k], x[2 * k + 1]];
            let rate = [0, 1].map(|axis| per_time * (e[axis] - from[2 * k + axis]));
            let Some(law) = own.law.force(e, rate, 0.5 * speed) else { return Err(miss) };
            for i in 0..2 {
                force[2 * k + i] = law.force[i] + compliance.stiffness * e[i];
                for j in 0..2 {
                    slope[k][i][j] = law.by_place[i][j] + per_time * law.by_velocity[i][j];
                }
                slope[k][i][i] += compliance.stiffness;
            }
        }
        let mut residual = vec![0.0; size];
        let mut jacobian = vec![0.0; size * size];
        for row in 0..size {
            let own = &compliance.matrix[row * size..(row + 1) * size];
            let pushed: f64 = own.iter().zip(&force).map(|(c, f)| c * f).sum();
            residual[row] = free[row] + pushed - x[row];
            for (k, slope) in slope.iter().enumerate() {
                for j in 0..2 {
                    let by = own[2 * k] * slope[0][j] + own[2 * k + 1] * slope[1][j];
                    jacobian[row * size + 2 * k + j] = -by;
                }
            }
            jacobian[row * size + row] += 1.0;
        }
        miss = residual.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
        if miss <= met {
            return Ok(x);
        }
        let Ok(factors) = Lu::new(size, jacobian) else { return Err(miss) };
        factors.solve(&mut residual);
        let share = allowed(films, &x, &residual);
        if !share.is_finite() || share < 1e-6 {
            return Err(miss);
        }
        x.iter_mut().zip(&residual).for_each(|(x, d)| *x += share * d);
    }
    Err(miss)
}

/// The share of a step after which every film still has some of its thickness.
fn allowed(films: &[FilmBearing], x: &[f64], change: &[f64]) -> f64 {
    let mut share: f64 = 1.0;
    for (k, own) in films.iter().enumerate() {
        let Some(clearance) = own.law.clearance() else { continue };
        let of = |values: &[f64]| values[2 * k].hypot(values[2 * k + 1]) / clearance;
        let limit = of(x) + THINNED * (1.0 - of(x));
        let at = |share: f64| {
            let e: Vec<f64> = (0..2).map(|i| x[2 * k + i] + share * change[2 * k + i]).collect();
            e[0].hypot(e[1]) / clearance
        };
        while share > 1e-7 && (at(share) > limit || at(share).is_nan()) {
            share *= 0.5;
        }
    }
    share
}

/// Refuses films thinner than their tables know.
fn within_tables(films: &[FilmBearing], places: &[Plane]) -> Result<(), FlexError> {
    for (own, e) in films.iter().zip(places) {
        let TrainLaw::Film { bearing, .. } = &own.law else { continue };
        let ratio = e[0].hypot(e[1]) / bearing.clearance;
        if ratio > FilmTable::last_ratio() {
            return Err(FlexError::Overloaded {
                bearing: own.place.name.clone(),
                least_film: bearing.clearance * (1.0 - ratio),
                needed: bearing.clearance * (1.0 - FilmTable::last_ratio()),
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oil_pressure::OilPressure;
    use crate::train::{BearingPlace, FilmInstant};
    use lanchester_film::{Cavitation, JournalBearing, attitude, contact_force};
    use std::sync::Arc;

    fn bearing(roughness: f64) -> FilmBearing {
        let bearing = JournalBearing::new(0.025, 0.02, 2.5e-5).unwrap();
        let table = Arc::new(FilmTable::new(bearing.slenderness(), Cavitation::Gumbel).unwrap());
        FilmBearing {
            place: BearingPlace { name: "main bearing 1".into(), set: "MAIN_1".into(), z: 0.0, width: 0.02 },
            law: TrainLaw::Film { bearing, table, viscosity: 6e-3, roughness },
        }
    }

    /// A journal by itself, on springs alone without its film.
    fn by_itself(own: &FilmBearing, load: Plane, speed: f64) -> Result<Plane, FlexError> {
        let stiffness = 1e9;
        let compliance = Compliance { stiffness, matrix: vec![1.0 / stiffness, 0.0, 0.0, 1.0 / stiffness] };
        let free = load.map(|f| f / stiffness);
        let found = film_equilibrium(std::slice::from_ref(own), speed, &free, &compliance)?;
        let force = own.law.force(found[0], [0.0; 2], 0.5 * speed).unwrap().force;
        let size = load[0].hypot(load[1]);
        assert!((force[0] + load[0]).hypot(force[1] + load[1]) <= 1e-6 * size, "{force:?} {load:?}");
        Ok(found[0])
    }

    #[test]
    fn a_journal_rests_where_its_film_solved_directly_carries_the_load() {
        let own = bearing(0.0);
        let speed = 314.0;
        let mut last = 0.0;
        for load in [1.0, 30.0, 300.0, 3e3, 1e4, 3e4] {
            let found = [0.3f64, 2.5].map(|direction| {
                let load = [load * direction.cos(), load * direction.sin()];
                let e = by_itself(&own, load, speed).unwrap();
                let instant = FilmInstant { eccentricity: e, rate: [0.0; 2], entrainment: 0.5 * speed };
                let film = OilPressure::of_film(&own.place, &own.law, &instant).unwrap().unwrap();
                let miss = (film.force[0] + load[0]).hypot(film.force[1] + load[1]);
                assert!(miss <= 5e-3 * load[0].hypot(load[1]), "{load:?} {:?}", film.force);
                (e[0].hypot(e[1]), attitude(film.force, e))
            });
            // Round bearings know no direction.
            let [(size, angle), (other, same)] = found;
            assert!((size / other - 1.0).abs() < 1e-6 && (angle - same).abs() < 1e-4, "{found:?}");
            assert!(size > last && size < 2.5e-5);
            last = size;
        }
    }

    #[test]
    fn a_load_that_leaves_no_film_is_refused_unless_roughness_carries_it() {
        let refused = by_itself(&bearing(0.0), [-4e5, 1e5], 1.0).unwrap_err();
        assert!(matches!(refused, FlexError::Overloaded { .. }), "{refused}");
        let load = [-1e4, 2e3];
        let e = by_itself(&bearing(0.8e-6), load, 1.0).unwrap();
        let ratio = e[0].hypot(e[1]) / 2.5e-5;
        let touching = contact_force(&JournalBearing::new(0.025, 0.02, 2.5e-5).unwrap(), 0.8e-6, ratio);
        assert!(touching > 0.5 * load[0].hypot(load[1]), "{touching}");
    }
}
