//! Orbits of all journals of a rigid shaft that floats in their films.
//!
//! ```text
//! m x'' = F_x      I a'' + I_p w b' = M_x        e_j = (x + a z_j, y + b z_j)        F, M = SUM (1, z_j) (load_j + film_j + contact_j)
//! m y'' = F_y      I b'' - I_p w a' = M_y        z_j: from the centre of mass; a, b: slopes of the shaft's axis       (book, eq. 45.7)
//! ```
//! So the films share the loads among as many bearings as there are. By Radau IIA, in time over the period.

use crate::balance::{FilmEnergy, Powers, Sums};
use crate::bearing::{JournalBearing, check_viscosity};
use crate::contact::contact_force;
use crate::error::{FilmError, require};
use crate::orbit::{
    Along, FilmOrbit, JournalCycle, OrbitOutcome, OrbitRequest, Repeated, check_cycle, cubic, films_along,
    repeated,
};
use crate::plane::{Plane, add, direction, dot, length, quarter};
use crate::table::FilmTable;
use lanchester_numerics::{Step, System};

/// Most periods until the orbits repeat.
const MOST_PERIODS: usize = 40;

/// A journal of the shaft.
#[derive(Debug, Clone, Copy)]
pub struct ShaftJournal<'a> {
    /// Its middle along the shaft, from the centre of mass [m].
    pub z: f64,
    /// The bearing.
    pub bearing: JournalBearing,
    /// Its table: same length over diameter.
    pub table: &'a FilmTable,
    /// Speeds, and a load that stands for what loads the shaft: the sum of the loads of all journals and of their moments counts alone [N].
    pub cycle: &'a JournalCycle,
}

/// A rigid shaft in films.
#[derive(Debug, Clone, Copy)]
pub struct ShaftRequest<'a> {
    /// Its journals, two at least.
    pub journals: &'a [ShaftJournal<'a>],
    /// Its mass [kg].
    pub mass: f64,
    /// Its moment of inertia across its axis, about its centre of mass [kg m2]: the mean of both.
    pub inertia: f64,
    /// About its axis, where it turns with `speed` [kg m2]; 0: no gyroscopic moments.
    pub polar: f64,
    /// Its speed [rad/s], positive from x to y.
    pub speed: f64,
    /// Composite roughness [m], 0: no contact.
    pub roughness: f64,
}

/// Orbits of a shaft's journals over one period.
#[derive(Debug, Clone, PartialEq)]
pub struct ShaftOrbits {
    /// How they ended.
    pub outcome: OrbitOutcome,
    /// Orbit and film of each journal, tilted as the shaft is.
    pub orbits: Vec<FilmOrbit>,
    /// What each bearing carries: the force of film and contact on the journal, against it, at every instant [N].
    pub loads: Vec<Vec<Plane>>,
    /// Slopes of the shaft's axis at every instant [rad].
    pub slopes: Vec<Plane>,
    /// Work and energy over the last period; `None` where it ended early.
    pub energy: Option<FilmEnergy>,
}

/// The shaft as it moves.
struct Shaft<'a> {
    request: &'a ShaftRequest<'a>,
    /// Force of a film over the table's.
    scales: Vec<f64>,
    /// Sums of the loads and of their moments at every instant [N, N m].
    loads: Vec<[f64; 4]>,
    duration: f64,
    /// Lengths of the state: a clearance, and the slope that it is at the farthest journal.
    units: [f64; 4],
}

/// Place and rate of a journal [m, m/s], from the state in its units.
fn place_and_rate(u: [f64; 4], duration: f64, z: f64, y: &[f64]) -> (Plane, Plane) {
    let place = [u[0] * y[0] + z * u[2] * y[2], u[1] * y[1] + z * u[3] * y[3]];
    let rate = [u[0] * y[4] + z * u[2] * y[6], u[1] * y[5] + z * u[3] * y[7]];
    (place, rate.map(|part| part / duration))
}

impl Shaft<'_> {
    /// Place and rate of a journal [m, m/s], from the state.
    fn journal(&self, z: f64, y: &[f64]) -> (Plane, Plane) {
        place_and_rate(self.units, self.duration, z, y)
    }

    /// Film and contact on a journal [N]; `None` where the film has no thickness.
    fn force(&self, index: usize, s: f64, place: Plane, rate: Plane) -> Option<Plane> {
        let closing = self.closing(index, s, place, rate);
        Some(add(self.film(index, place, closing)?, 1.0, self.contact(index, place)))
    }

    /// Motion as the film sees it [m/s].
    fn closing(&self, index: usize, s: f64, place: Plane, rate: Plane) -> Plane {
        add(rate, -self.request.journals[index].cycle.entrainment_at(s), quarter(place))
    }

    fn film(&self, index: usize, place: Plane, closing: Plane) -> Option<Plane> {
        let ShaftJournal { bearing, table, .. } = self.request.journals[index];
        let film = table.impedance(place.map(|part| part / bearing.clearance), closing).ok()?.force;
        Some(film.map(|part| self.scales[index] * part))
    }

    fn contact(&self, index: usize, place: Plane) -> Plane {
        let bearing = &self.request.journals[index].bearing;
        let (along, size) = direction(place.map(|part| part / bearing.clearance));
        let contact = contact_force(bearing, self.request.roughness, size);
        along.map(|part| -contact * part)
    }

    /// Rates of place and slope [m/s, rad/s].
    fn rates(&self, y: &[f64]) -> [f64; 4] {
        [0, 1, 2, 3].map(|k| self.units[k] * y[4 + k] / self.duration)
    }

    /// Powers at a place over the period; `None` where a film has no thickness.
    fn powers(&self, s: f64, y: &[f64]) -> Option<Powers> {
        let loads = self.load(s).iter().zip(self.rates(y)).map(|(load, rate)| load * rate).sum();
        let mut found = Powers { loads, ..Powers::default() };
        for (index, journal) in self.request.journals.iter().enumerate() {
            let (place, rate) = self.journal(journal.z, y);
            let closing = self.closing(index, s, place, rate);
            let film = self.film(index, place, closing)?;
            found.turning += journal.cycle.entrainment_at(s) * dot(film, quarter(place));
            found.films -= dot(film, closing);
            found.contact -= dot(self.contact(index, place), rate);
        }
        Some(found)
    }

    /// Kinetic energy without that of the turning [J].
    fn kinetic(&self, y: &[f64]) -> f64 {
        let [x, y, a, b] = self.rates(y).map(|rate| 0.5 * rate * rate);
        self.request.mass * (x + y) + self.request.inertia * (a + b)
    }

    /// Periodic cubic through the loads.
    fn load(&self, s: f64) -> [f64; 4] {
        let mut sum = [0.0; 4];
        for (i, weight) in cubic(s, self.loads.len()) {
            (0..4).for_each(|part| sum[part] += weight * self.loads[i][part]);
        }
        sum
    }
}

impl System for &Shaft<'_> {
    fn dimension(&self) -> usize {
        8
    }

    fn derivative(&mut self, s: f64, y: &[f64], derivative: &mut [f64]) {
        derivative.fill(f64::NAN);
        // Forces along x and y, then their moments.
        let mut sum = self.load(s);
        for (index, journal) in self.request.journals.iter().enumerate() {
            let (place, rate) = self.journal(journal.z, y);
            let Some(force) = self.force(index, s, place, rate) else { return };
            for k in 0..2 {
                sum[k] += force[k];
                sum[2 + k] += journal.z * force[k];
            }
        }
        let ShaftRequest { mass, inertia, polar, speed, .. } = *self.request;
        let spin = polar * speed / self.duration;
        sum[2] -= spin * self.units[3] * y[7];
        sum[3] += spin * self.units[2] * y[6];
        let square = self.duration * self.duration;
        for k in 0..4 {
            derivative[k] = y[4 + k];
            let over = if k < 2 { mass } else { inertia };
            derivative[4 + k] = sum[k] / over * square / self.units[k];
        }
    }
}

/// A shaft that moves, and where it is: another run, with other viscosities, goes on from there.
pub struct FloatingShaft<'a> {
    system: Shaft<'a>,
    state: Vec<f64>,
}

impl<'a> FloatingShaft<'a> {
    /// A shaft at rest in the middle of its bearings.
    ///
    /// # Errors
    /// [`FilmError`] for less than two journals, those that stand in one plane, masses that are none, and what [`crate::journal_orbit`] refuses.
    pub fn new(request: &'a ShaftRequest<'a>) -> Result<FloatingShaft<'a>, FilmError> {
        let journals = request.journals;
        let count = journals.len() as f64;
        require(journals.len() >= 2, "journals of a shaft in films", "2 or more", count)?;
        require(
            request.mass > 0.0 && request.mass.is_finite(),
            "mass of the shaft [kg]",
            "above 0",
            request.mass,
        )?;
        let inertia = request.inertia;
        require(
            inertia > 0.0 && inertia.is_finite(),
            "moment of inertia of the shaft across its axis [kg m2]",
            "above 0",
            inertia,
        )?;
        let polar = request.polar;
        require(polar >= 0.0 && polar.is_finite(), "polar moment of inertia [kg m2]", "0 or above", polar)?;
        let n = journals[0].cycle.load.len();
        let mut loads = vec![[0.0; 4]; n];
        for journal in journals {
            check_cycle(&journal.bearing, journal.cycle, request.roughness)?;
            let own = journal.cycle.load.len();
            if own != n {
                return Err(FilmError::Samples { needed: n, got: own });
            }
            for (sum, load) in loads.iter_mut().zip(&journal.cycle.load) {
                for k in 0..2 {
                    sum[k] += load[k];
                    sum[2 + k] += journal.z * load[k];
                }
            }
        }
        let clearance = journals.iter().map(|own| own.bearing.clearance).sum::<f64>() / count;
        let farthest = journals.iter().map(|own| own.z.abs()).fold(0.0, f64::max);
        let [low, high] = journals
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], own| [low.min(own.z), high.max(own.z)]);
        require(high - low > 1e-6, "distance of the journals of a shaft [m]", "above 0", high - low)?;
        let slope = clearance / farthest;
        let duration = journals[0].cycle.duration;
        let units = [clearance, clearance, slope, slope];
        let system = Shaft { request, scales: Vec::new(), loads, duration, units };
        Ok(FloatingShaft { system, state: vec![0.0; 8] })
    }

    /// Runs until the orbits repeat, with a viscosity [Pa s] for each bearing. `is_tilted`: whether the films along the orbits, of which pressure, friction
    /// and flow are taken, have the tilt of the shaft, which takes seconds.
    ///
    /// # Errors
    /// [`FilmError`] for a viscosity out of range, and films that cannot be solved along the orbits.
    pub fn run(&mut self, viscosities: &[f64], is_tilted: bool) -> Result<ShaftOrbits, FilmError> {
        let journals = self.system.request.journals;
        for viscosity in viscosities {
            check_viscosity(*viscosity)?;
        }
        self.system.scales =
            journals.iter().zip(viscosities).map(|(own, mu)| own.bearing.force_scale(*mu)).collect();
        let n = self.system.loads.len();
        let (units, duration) = (self.system.units, self.system.duration);
        let apart = |a: &[f64; 8], b: &[f64; 8]| {
            let apart = |own: &ShaftJournal| {
                let place = |y: &[f64; 8]| place_and_rate(units, duration, own.z, y).0;
                length(add(place(a), -1.0, place(b))) / own.bearing.clearance
            };
            journals.iter().map(apart).fold(0.0, f64::max)
        };
        let (mut sums, shaft) = (Sums::default(), &self.system);
        let watch = |step: &Step| {
            sums.add(step, duration, n, |s, y| shaft.powers(s, y), |y| shaft.kinetic(y));
        };
        let found = repeated(&mut &self.system, &mut self.state, n, MOST_PERIODS, apart, watch);
        let Repeated { mut states, outcome, periods, change, steps, reached } = found;
        if outcome == OrbitOutcome::Overloaded {
            // What was not reached stays where the last instant was.
            let last = states[..reached].last().copied().unwrap_or_default();
            states[reached..].fill(last);
            self.state.fill(0.0);
        }
        let reached = reached.max(1);
        let slopes: Vec<Plane> =
            states.iter().map(|y| [self.system.units[2] * y[2], self.system.units[3] * y[3]]).collect();
        let (mut orbits, mut loads) = (Vec::new(), Vec::new());
        // The bearing whose film gave way is the one that is thinnest where the run ended.
        let thickness = |own: &ShaftJournal, y: &[f64; 8]| {
            length(self.system.journal(own.z, y).0) / own.bearing.clearance
        };
        let gave_way = (0..journals.len()).max_by(|a, b| {
            let at = |index: &usize| thickness(&journals[*index], &states[reached - 1]);
            at(a).total_cmp(&at(b))
        });
        for (index, (journal, viscosity)) in journals.iter().zip(viscosities).enumerate() {
            let moved: Vec<(Plane, Plane)> =
                states.iter().map(|y| self.system.journal(journal.z, y)).collect();
            let carried = moved.iter().enumerate().map(|(i, (place, rate))| {
                let force = self.system.force(index, i as f64 / n as f64, *place, *rate);
                force.unwrap_or_default().map(|part| -part)
            });
            let carried: Vec<Plane> = carried.collect();
            let cycle = JournalCycle { load: carried.clone(), ..journal.cycle.clone() };
            let own = OrbitRequest {
                bearing: journal.bearing,
                table: journal.table,
                viscosity: *viscosity,
                cycle: &cycle,
                roughness: self.system.request.roughness,
                mass: Some(self.system.request.mass),
            };
            let c = journal.bearing.clearance;
            let ratios: Vec<Plane> = moved.iter().map(|(place, _)| place.map(|part| part / c)).collect();
            let rates: Vec<Plane> = moved.iter().map(|(_, rate)| *rate).collect();
            let mut found = films_along(
                &own,
                &ratios,
                Along { velocities: &rates, slopes: is_tilted.then_some(slopes.as_slice()), reached },
            )?;
            found.outcome = match outcome {
                OrbitOutcome::Overloaded if gave_way != Some(index) => OrbitOutcome::NotPeriodic,
                outcome => outcome,
            };
            (found.periods, found.change, found.steps) = (periods, change, steps);
            orbits.push(found);
            loads.push(carried);
        }
        let energy = sums.balance().filter(|_| outcome != OrbitOutcome::Overloaded);
        Ok(ShaftOrbits { outcome, orbits, loads, slopes, energy })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cavitation::Cavitation;
    use crate::orbit::journal_orbit;
    use std::f64::consts::TAU;

    const VISCOSITY: f64 = 0.01;

    fn cycle(size: f64, phase: f64) -> JournalCycle {
        let n = 180;
        let load = (0..n).map(|i| TAU * f64::from(i) / f64::from(n)).map(|a| {
            [size * (1.0 + 0.8 * (a + phase).cos() + 0.3 * (2.0 * a).sin()), size * 0.6 * (a + phase).sin()]
        });
        JournalCycle {
            duration: 0.02,
            load: load.collect(),
            entrainment: vec![157.0; n as usize],
            sliding: vec![314.0; n as usize],
        }
    }

    fn bearing() -> JournalBearing {
        JournalBearing::new(0.025, 0.02, 2.5e-5).expect("plausible")
    }

    fn run(journals: &[ShaftJournal], mass: f64, inertia: f64, polar: f64) -> ShaftOrbits {
        let request = ShaftRequest { journals, mass, inertia, polar, speed: 314.0, roughness: 0.0 };
        let mut shaft = FloatingShaft::new(&request).expect("a shaft");
        shaft.run(&vec![VISCOSITY; journals.len()], true).expect("orbits")
    }

    #[test]
    fn a_shaft_that_stays_parallel_is_a_journal_with_its_share_of_the_mass() {
        let (table, cycle) = (FilmTable::new(0.4, Cavitation::Gumbel).expect("a table"), cycle(3000.0, 0.0));
        let journals =
            [-0.05, 0.05].map(|z| ShaftJournal { z, bearing: bearing(), table: &table, cycle: &cycle });
        let found = run(&journals, 12.0, 0.03, 0.01);
        let request = OrbitRequest {
            bearing: bearing(),
            table: &table,
            viscosity: VISCOSITY,
            cycle: &cycle,
            roughness: 0.0,
            mass: Some(6.0),
        };
        let alone = journal_orbit(&request).expect("an orbit");
        assert_eq!(found.outcome, OrbitOutcome::Periodic);
        for orbit in &found.orbits {
            for (a, b) in orbit.eccentricity.iter().zip(&alone.eccentricity) {
                assert!(length(add(*a, -1.0, *b)) < 2e-3 * 2.5e-5, "{a:?} {b:?}");
            }
            assert!((orbit.friction_power / alone.friction_power - 1.0).abs() < 0.02);
        }
        assert!(found.slopes.iter().all(|slope| length(*slope) < 1e-9));
        // The mass counts: without it the orbit is another one.
        let still = journal_orbit(&OrbitRequest { mass: None, ..request }).expect("an orbit");
        let apart = |(a, b): (&Plane, &Plane)| length(add(*a, -1.0, *b));
        let moved = still.eccentricity.iter().zip(&alone.eccentricity).map(apart).fold(0.0, f64::max);
        assert!(moved > 0.01 * 2.5e-5, "{moved}");
    }

    #[test]
    fn energies_balance_while_orbits_settle_and_when_they_repeat() {
        let (table, cycle) = (FilmTable::new(0.4, Cavitation::Gumbel).expect("a table"), cycle(3000.0, 0.0));
        // Bearings at unequal distances: the shaft tilts, and turns about its own axis while it does.
        let journals =
            [-0.05, 0.03].map(|z| ShaftJournal { z, bearing: bearing(), table: &table, cycle: &cycle });
        let request = ShaftRequest {
            journals: &journals,
            mass: 100.0,
            inertia: 0.3,
            polar: 0.2,
            speed: 314.0,
            roughness: 0.0,
        };
        let mut floating = FloatingShaft::new(&request).expect("a shaft");
        let found = floating.run(&[VISCOSITY; 2], false).expect("orbits");
        let energy = found.energy.expect("it repeats");
        assert!(energy.error() < 1e-5, "{energy:?}");
        assert!(energy.films > 0.0 && energy.loads > 0.0 && energy.turning > 0.0, "{energy:?}");
        assert!(energy.change.abs() < 1e-6 * energy.turnover, "what repeats has changed nothing: {energy:?}");
        // From a start that moves, over one period.
        let shaft = &floating.system;
        let start = [0.3, -0.2, 0.1, 0.2, 20.0, -10.0, 15.0, 10.0];
        let balance = |mass: f64| {
            let (mut sums, mut state) = (Sums::default(), start);
            let kinetic = |y: &[f64]| {
                let [x, y, a, b] = shaft.rates(y).map(|rate| 0.5 * rate * rate);
                mass * (x + y) + request.inertia * (a + b)
            };
            let watch = |step: &Step| sums.add(step, 0.02, 180, |s, y| shaft.powers(s, y), kinetic);
            let apart = |_: &[f64; 8], _: &[f64; 8]| 1.0;
            let found = repeated(&mut &*shaft, &mut state, 180, 1, apart, watch);
            assert_eq!((found.outcome, found.reached), (OrbitOutcome::NotPeriodic, 180));
            sums.balance().expect("a film all the way")
        };
        let settling = balance(request.mass);
        assert!(settling.error() < 1e-4 && settling.change < -1e-3 * settling.turnover, "{settling:?}");
        // Another mass has another energy, which the motion does not balance.
        assert!(balance(1.5 * request.mass).error() > 1e-4);
    }

    #[test]
    fn two_bearings_of_a_light_shaft_carry_their_own_loads_and_three_the_sum() {
        let table = FilmTable::new(0.4, Cavitation::Gumbel).expect("a table");
        let cycles = [cycle(2500.0, 0.0), cycle(3500.0, 2.0), cycle(3000.0, 4.0)];
        let places = [-0.08, 0.0, 0.09];
        let journals: Vec<ShaftJournal> = places
            .iter()
            .zip(&cycles)
            .map(|(z, cycle)| ShaftJournal { z: *z, bearing: bearing(), table: &table, cycle })
            .collect();
        let two = run(&[journals[0], journals[2]], 1e-3, 1e-5, 0.0);
        for (carried, own) in two.loads.iter().zip([&cycles[0], &cycles[2]]) {
            let off = carried.iter().zip(&own.load).map(|(a, b)| length(add(*a, -1.0, *b)));
            assert!(off.fold(0.0, f64::max) < 40.0);
        }
        let three = run(&journals, 1e-3, 1e-5, 0.0);
        assert_eq!(three.outcome, OrbitOutcome::Periodic);
        let mut shares = 0.0f64;
        for i in 0..180 {
            let (mut force, mut moment) = ([0.0; 2], [0.0; 2]);
            for ((z, carried), own) in places.iter().zip(&three.loads).zip(&cycles) {
                for k in 0..2 {
                    force[k] += carried[i][k] - own.load[i][k];
                    moment[k] += z * (carried[i][k] - own.load[i][k]);
                }
                shares = shares.max(length(add(carried[i], -1.0, own.load[i])));
            }
            assert!(length(force) < 60.0 && length(moment) < 5.0, "{force:?} {moment:?}");
        }
        // What each carries is another matter.
        assert!(shares > 500.0, "{shares}");
    }

    #[test]
    fn gyroscopic_moments_couple_the_two_tilts() {
        let (table, cycle) = (FilmTable::new(0.4, Cavitation::Gumbel).expect("a table"), cycle(3000.0, 0.0));
        let journals =
            [-0.05, 0.05].map(|z| ShaftJournal { z, bearing: bearing(), table: &table, cycle: &cycle });
        let derivative = |polar: f64| {
            let request = ShaftRequest {
                journals: &journals,
                mass: 12.0,
                inertia: 0.03,
                polar,
                speed: 314.0,
                roughness: 0.0,
            };
            let mut shaft = FloatingShaft::new(&request).expect("a shaft");
            shaft.system.scales = vec![bearing().force_scale(VISCOSITY); 2];
            let mut derivative = [0.0; 8];
            // The slope a grows, b does not.
            (&shaft.system).derivative(0.1, &[0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0], &mut derivative);
            (derivative, shaft.system.units[2])
        };
        let ((without, _), (with, unit)) = (derivative(0.0), derivative(0.02));
        // I b'' = I_p w a', whose rate is that of the state over the period.
        let wanted = 0.02 * 314.0 * (2.0 * unit / 0.02) / 0.03 * 0.02 * 0.02 / unit;
        assert!(((with[7] - without[7]) / wanted - 1.0).abs() < 1e-9, "{} {wanted}", with[7] - without[7]);
        assert!((with[6] - without[6]).abs() < 1e-9 * wanted);
    }

    #[test]
    fn a_shaft_of_one_bearing_or_without_mass_is_refused() {
        let (table, cycle) = (FilmTable::new(0.4, Cavitation::Gumbel).expect("a table"), cycle(3000.0, 0.0));
        let journal = ShaftJournal { z: 0.0, bearing: bearing(), table: &table, cycle: &cycle };
        let refused = |journals: &[ShaftJournal], mass: f64| {
            let request =
                ShaftRequest { journals, mass, inertia: 0.03, polar: 0.0, speed: 1.0, roughness: 0.0 };
            FloatingShaft::new(&request).err().map(|error| error.to_string()).expect("refused")
        };
        assert!(refused(&[journal], 1.0).contains("2 or more"));
        assert!(refused(&[journal, journal], 1.0).contains("distance of the journals"));
        assert!(
            refused(&[journal, ShaftJournal { z: 0.1, ..journal }], f64::NAN).contains("mass of the shaft")
        );
    }
}
