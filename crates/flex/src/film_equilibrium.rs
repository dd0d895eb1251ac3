//! Where a crankshaft rests in its oil films.
//!
//! With `x_0` the displacements of the journals under the loads on springs `k`, `C` their compliance on these springs, `f` the forces of the films at the
//! eccentricities `e` and `k_h` the stiffness of the housings:
//!
//! ```text
//! x = x_0 + C (f(e, 0) + k x)      x = e - f(e, 0)/k_h                                                                       (book, eq. 43.20)
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

/// Where a journal rests.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rest {
    /// Its centre from that of the shell [m].
    pub eccentricity: Plane,
    /// Its centre from where that of the shell is without load [m].
    pub place: Plane,
}

/// Where the journals rest: where films, loads and the elastic crankshaft are in equilibrium and stay. `free`: the places under the loads
/// without films; `speed` of the crankshaft [rad/s].
///
/// # Errors
/// [`FlexError::Overloaded`] where a film has no thickness left; [`FlexError::NoConvergence`].
pub(crate) fn film_equilibrium(
    films: &[FilmBearing],
    speed: f64,
    free: &[f64],
    compliance: &Compliance,
) -> Result<Vec<Rest>, FlexError> {
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
                    return rests(films, speed, &x);
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
        let (mut force, mut place) = (vec![0.0; size], vec![0.0; size]);
        // Of the forces that act on the crankshaft on its springs, and of its journals' places.
        let mut slope = vec![[[[0.0; 2]; 2]; 2]; films.len()];
        for (k, own) in films.iter().enumerate() {
            let e = [x[2 * k], x[2 * k + 1]];
            let rate = [0, 1].map(|axis| per_time * (e[axis] - from[2 * k + axis]));
            let Some(law) = own.law.force(e, rate, 0.5 * speed) else { return Err(miss) };
            let yielding = own.housing.map_or(0.0, |stiffness| 1.0 / stiffness);
            for i in 0..2 {
                place[2 * k + i] = e[i] - yielding * law.force[i];
                force[2 * k + i] = law.force[i] + compliance.stiffness * place[2 * k + i];
                for j in 0..2 {
                    let by = law.by_place[i][j] + per_time * law.by_velocity[i][j];
                    let moved = if i == j { 1.0 } else { 0.0 } - yielding * by;
                    slope[k][0][i][j] = by + compliance.stiffness * moved;
                    slope[k][1][i][j] = moved;
                }
            }
        }
        let mut residual = vec![0.0; size];
        let mut jacobian = vec![0.0; size * size];
        for row in 0..size {
            let own = &compliance.matrix[row * size..(row + 1) * size];
            let pushed: f64 = own.iter().zip(&force).map(|(c, f)| c * f).sum();
            residual[row] = free[row] + pushed - place[row];
            for (k, [pushing, moved]) in slope.iter().enumerate() {
                for j in 0..2 {
                    let by = own[2 * k] * pushing[0][j] + own[2 * k + 1] * pushing[1][j];
                    let at = if row / 2 == k { moved[row % 2][j] } else { 0.0 };
                    jacobian[row * size + 2 * k + j] = at - by;
                }
            }
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

/// Where journals rest at these eccentricities; refuses films thinner than their tables know.
fn rests(films: &[FilmBearing], speed: f64, eccentricities: &[f64]) -> Result<Vec<Rest>, FlexError> {
    let mut found = Vec::new();
    for (own, e) in films.iter().zip(eccentricities.chunks_exact(2)) {
        let e = [e[0], e[1]];
        let force = own.law.force(e, [0.0; 2], 0.5 * speed).map_or([0.0; 2], |law| law.force);
        let yielding = own.housing.map_or(0.0, |stiffness| 1.0 / stiffness);
        found.push(Rest { eccentricity: e, place: [0, 1].map(|k| e[k] - yielding * force[k]) });
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
    Ok(found)
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
            housing: None,
        }
    }

    /// A journal by itself, on springs alone without its film.
    fn by_itself(own: &FilmBearing, load: Plane, speed: f64) -> Result<Plane, FlexError> {
        let stiffness = 1e9;
        let compliance = Compliance { stiffness, matrix: vec![1.0 / stiffness, 0.0, 0.0, 1.0 / stiffness] };
        let free = load.map(|f| f / stiffness);
        let found = film_equilibrium(std::slice::from_ref(own), speed, &free, &compliance)?;
        let Rest { eccentricity: e, place } = found[0];
        let force = own.law.force(e, [0.0; 2], 0.5 * speed).unwrap().force;
        let size = load[0].hypot(load[1]);
        assert!((force[0] + load[0]).hypot(force[1] + load[1]) <= 1e-6 * size, "{force:?} {load:?}");
        // The shell goes with the load, by the stiffness of its housing.
        let shell = [place[0] - e[0], place[1] - e[1]];
        let wanted = own.housing.map_or([0.0; 2], |stiffness| load.map(|f| f / stiffness));
        assert!((shell[0] - wanted[0]).hypot(shell[1] - wanted[1]) <= 1e-6 * 2.5e-5, "{shell:?} {wanted:?}");
        Ok(e)
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
                let instant = FilmInstant {
                    eccentricity: e,
                    rate: [0.0; 2],
                    entrainment: 0.5 * speed,
                    tilt: [[0.0; 2]; 2],
                };
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
    fn a_housing_that_yields_moves_the_journal_and_not_its_film() {
        let load = [-6e3, 2e3];
        let rigid = by_itself(&bearing(0.0), load, 314.0).unwrap();
        for stiffness in [1e7, 1e9] {
            let own = FilmBearing { housing: Some(stiffness), ..bearing(0.0) };
            let e = by_itself(&own, load, 314.0).unwrap();
            assert!((e[0] - rigid[0]).hypot(e[1] - rigid[1]) < 1e-6 * 2.5e-5, "{e:?} {rigid:?}");
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
