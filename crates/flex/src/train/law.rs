//! Laws of bearings: force on the journal from its eccentricity and velocity, with derivatives.
//!
//! ```text
//! contact    d = |e| - c    F = -max(0, k d + s(d) b d') n    d > 0                          (book, eq. 51.8)
//! bushing    F = -(k e + b e')                                                               (book, eq. 51.9)
//! film       F = 12 mu (R/c)^3 L f(e/c, v) - F_c n    v = e' - w_m e_z x e                   (book, eq. 51.10)
//! ```
//! The damping of a contact fades in over its first depth, `s` from 0 to 1, so that the force has no jump; `F_c` is that of the roughness. The film of a tilted journal
//! depends on how far its end lies from its middle too, and acts on that. Where an end would come closer to the shell than a share of the clearance, the film is that of a tilt that leaves
//! it there: what more of tilt there is, roughness carries, or nothing.

use super::plane::{ONE, Plane, QUARTER, Square, dot, length, plus, product, sum, times};
use super::spot::{Four, Spot, corner, flat, through_blocks};
use lanchester_film::{
    FilmTable, JournalBearing, TiltedMotion, contact_with_slope, tilted_contact, tilted_impedance,
};
use std::sync::Arc;

/// Depth over which a contact's damping fades in, over the clearance.
const FADE: f64 = 0.01;

/// Share of the clearance that a film keeps at the ends of its bearing however the journal tilts.
const LEAST_AT_ENDS: f64 = 0.02;

/// What ties a journal to its bearing.
#[derive(Debug, Clone, PartialEq)]
pub enum TrainLaw {
    /// No clearance and no yield: the centres are one point.
    Rigid,
    /// Clearance, then a spring with a damper.
    Contact {
        /// Radial clearance [m].
        clearance: f64,
        /// Stiffness [N/m].
        stiffness: f64,
        /// Damping [N s/m].
        damping: f64,
    },
    /// Springs with dampers about the middle.
    Bushing {
        /// Stiffness in the block's frame [N/m].
        stiffness: Square,
        /// Damping [N s/m].
        damping: Square,
    },
    /// An oil film by its table.
    Film {
        /// The bearing.
        bearing: JournalBearing,
        /// Table of the same length over diameter.
        table: Arc<FilmTable>,
        /// Viscosity [Pa s].
        viscosity: f64,
        /// Composite roughness [m], 0: no contact.
        roughness: f64,
    },
    /// Guembel's film of a journal that tilts in its bearing, solved at every instant.
    TiltedFilm {
        /// The bearing.
        bearing: JournalBearing,
        /// Viscosity [Pa s].
        viscosity: f64,
        /// Composite roughness [m], 0: no contact.
        roughness: f64,
    },
}

/// Force on the journal with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LawForce {
    pub force: Plane,
    pub by_place: Square,
    pub by_velocity: Square,
}

/// Force on middle and end of the journal with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpotForce {
    pub force: Spot,
    pub by_place: Four,
    pub by_velocity: Four,
}

const NONE: LawForce = LawForce { force: [0.0; 2], by_place: [[0.0; 2]; 2], by_velocity: [[0.0; 2]; 2] };

impl TrainLaw {
    /// A bushing alike in all directions: stiffness [N/m], damping [N s/m].
    pub fn bushing(stiffness: f64, damping: f64) -> TrainLaw {
        let of = |value: f64| sum(value, &ONE, 0.0, &ONE);
        TrainLaw::Bushing { stiffness: of(stiffness), damping: of(damping) }
    }

    /// Whether the centres are one point.
    pub fn is_rigid(&self) -> bool {
        matches!(self, TrainLaw::Rigid)
    }

    /// Radial clearance, where there is one [m].
    pub fn clearance(&self) -> Option<f64> {
        match self {
            TrainLaw::Contact { clearance, .. } => Some(*clearance),
            TrainLaw::Film { .. } | TrainLaw::TiltedFilm { .. } => self.film().map(|own| own.clearance),
            TrainLaw::Rigid | TrainLaw::Bushing { .. } => None,
        }
    }

    /// The bearing of a film.
    pub fn film(&self) -> Option<&JournalBearing> {
        match self {
            TrainLaw::Film { bearing, .. } | TrainLaw::TiltedFilm { bearing, .. } => Some(bearing),
            TrainLaw::Rigid | TrainLaw::Contact { .. } | TrainLaw::Bushing { .. } => None,
        }
    }

    /// Whether the force depends on how the journal tilts.
    pub(crate) fn is_tilted(&self) -> bool {
        matches!(self, TrainLaw::TiltedFilm { .. })
    }

    /// Force where middle and end of the journal are at `e`, with the rate `rate`: none where the film has no thickness left.
    pub(crate) fn spot_force(&self, e: &Spot, rate: &Spot, entrainment: f64) -> Option<SpotForce> {
        let TrainLaw::TiltedFilm { bearing, viscosity, roughness } = self else {
            let own = self.force([e[0], e[1]], [rate[0], rate[1]], entrainment)?;
            let [by_place, by_velocity] = [own.by_place, own.by_velocity].map(|own| flat(&own));
            return Some(SpotForce { force: [own.force[0], own.force[1], 0.0, 0.0], by_place, by_velocity });
        };
        let c = bearing.clearance;
        let [(middle, closing), (end, closing_by_tilt)] = [0, 2].map(|at| {
            let own = [e[at], e[at + 1]];
            let v = plus([rate[at], rate[at + 1]], -entrainment, times(&QUARTER, own));
            (own.map(|part| part / c), v)
        });
        let kept = KeptTilt::new(middle, end)?;
        let motion = TiltedMotion { eccentricity: middle, tilt: kept.tilt, closing, closing_by_tilt };
        let mut film = tilted_impedance(bearing.slenderness(), &motion).ok()?;
        film.by_place = kept.chained(&film.by_place);
        let scale = bearing.force_scale(*viscosity);
        let turning = through_blocks(&film.by_velocity, &QUARTER);
        let (floor, floor_by) = tilted_contact(bearing, *roughness, middle, end);
        let pairs = |of: &dyn Fn(usize, usize) -> f64| [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| of(i, j)));
        Some(SpotForce {
            force: [0, 1, 2, 3].map(|i| scale * film.force[i] + floor[i]),
            by_place: pairs(&|i, j| {
                scale * (film.by_place[i][j] / c - entrainment * turning[i][j]) + floor_by[i][j] / c
            }),
            by_velocity: pairs(&|i, j| scale * film.by_velocity[i][j]),
        })
    }

    /// Force at eccentricity `e` [m] and its rate [m/s], with the mean angular speed `entrainment` of both surfaces [rad/s]; none where the film has no
    /// thickness left.
    pub(crate) fn force(&self, e: Plane, rate: Plane, entrainment: f64) -> Option<LawForce> {
        match self {
            TrainLaw::Rigid => Some(NONE),
            TrainLaw::Bushing { stiffness, damping } => {
                let force = plus(times(stiffness, e), 1.0, times(damping, rate));
                Some(LawForce {
                    force: force.map(|f| -f),
                    by_place: sum(-1.0, stiffness, 0.0, &ONE),
                    by_velocity: sum(-1.0, damping, 0.0, &ONE),
                })
            }
            TrainLaw::Contact { clearance, stiffness, damping } => {
                Some(contact(*clearance, *stiffness, *damping, e, rate))
            }
            TrainLaw::Film { bearing, table, viscosity, roughness } => {
                let scale = bearing.force_scale(*viscosity);
                let c = bearing.clearance;
                let ratio = e.map(|part| part / c);
                let v = plus(rate, -entrainment, times(&QUARTER, e));
                let film = table.impedance(ratio, v).ok()?;
                let by_velocity = sum(scale, &film.by_velocity, 0.0, &ONE);
                let turning = product(&by_velocity, &QUARTER);
                let mut own = LawForce {
                    force: film.force.map(|f| scale * f),
                    by_place: sum(scale / c, &film.by_eccentricity, -entrainment, &turning),
                    by_velocity,
                };
                let size = length(ratio);
                let (floor, slope) = contact_with_slope(bearing, *roughness, size);
                if floor > 0.0 {
                    let n = ratio.map(|part| part / size);
                    own.force = plus(own.force, -floor, n);
                    for i in 0..2 {
                        for j in 0..2 {
                            let across = ONE[i][j] - n[i] * n[j];
                            own.by_place[i][j] -= (slope * n[i] * n[j] + floor / size * across) / c;
                        }
                    }
                }
                Some(own)
            }
            TrainLaw::TiltedFilm { .. } => {
                let upright = |[x, y]: Plane| [x, y, 0.0, 0.0];
                let own = self.spot_force(&upright(e), &upright(rate), entrainment)?;
                Some(LawForce {
                    force: [own.force[0], own.force[1]],
                    by_place: corner(&own.by_place),
                    by_velocity: corner(&own.by_velocity),
                })
            }
        }
    }
}

/// The tilt that a film has: the journal's, or as much of it as leaves the ends their share of the clearance.
pub(super) struct KeptTilt {
    /// Over the clearance.
    pub tilt: Plane,
    share: f64,
    /// Derivatives of the share by eccentricity and tilt.
    by: Spot,
}

impl KeptTilt {
    /// Of eccentricity and tilt over the clearance; none where the middle of the journal reaches the shell.
    pub fn new(x: Plane, tilt: Plane) -> Option<KeptTilt> {
        let most = 1.0 - LEAST_AT_ENDS;
        let mut kept = KeptTilt { tilt, share: 1.0, by: [0.0; 4] };
        if length(x) >= 1.0 {
            return None;
        }
        if length(x) >= most {
            return Some(KeptTilt { tilt: [0.0; 2], share: 0.0, ..kept });
        }
        for sign in [1.0, -1.0] {
            let t = tilt.map(|part| sign * part);
            if length(plus(x, kept.share, t)) <= most {
                continue;
            }
            // |x + s t| = most.
            let [a, b, c] = [dot(t, t), dot(x, t), dot(x, x) - most * most];
            kept.share = ((b * b - a * c).sqrt() - b) / a;
            let u = plus(x, kept.share, t);
            let slope = -1.0 / dot(u, t);
            let by_tilt = u.map(|part| slope * kept.share * sign * part);
            kept.by = [slope * u[0], slope * u[1], by_tilt[0], by_tilt[1]];
        }
        kept.tilt = tilt.map(|part| kept.share * part);
        Some(kept)
    }

    /// Derivatives by the journal's place from those by the kept one.
    fn chained(&self, own: &Four) -> Four {
        own.map(|[a, b, c, d]| {
            // d(s t) = s dt + t ds; the tilt itself is the kept one over its share.
            let along =
                if self.share > 0.0 { (c * self.tilt[0] + d * self.tilt[1]) / self.share } else { 0.0 };
            let by = self.by.map(|part| along * part);
            [a + by[0], b + by[1], self.share * c + by[2], self.share * d + by[3]]
        })
    }
}

fn contact(clearance: f64, stiffness: f64, damping: f64, e: Plane, rate: Plane) -> LawForce {
    let size = length(e);
    let depth = size - clearance;
    if depth <= 0.0 || size == 0.0 {
        return NONE;
    }
    let n = e.map(|part| part / size);
    let closing = dot(n, rate);
    let over = (depth / (FADE * clearance).max(1e-9)).min(1.0);
    let fade = over * over * (3.0 - 2.0 * over);
    let fade_slope = if over < 1.0 { 6.0 * over * (1.0 - over) / (FADE * clearance).max(1e-9) } else { 0.0 };
    let push = stiffness * depth + damping * fade * closing;
    if push <= 0.0 {
        return NONE;
    }
    let mut own = LawForce { force: n.map(|part| -push * part), ..NONE };
    for i in 0..2 {
        for j in 0..2 {
            let along = (stiffness + damping * fade_slope * closing) * n[j]
                + damping * fade * (rate[j] - closing * n[j]) / size;
            own.by_place[i][j] = -n[i] * along - push * (ONE[i][j] - n[i] * n[j]) / size;
            own.by_velocity[i][j] = -damping * fade * n[i] * n[j];
        }
    }
    own
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_film::Cavitation;

    #[test]
    fn derivatives_of_every_law_are_those_of_its_force() {
        let bearing = JournalBearing::new(0.0275, 0.025, 30e-6).unwrap();
        let table = Arc::new(FilmTable::new(bearing.slenderness(), Cavitation::Gumbel).unwrap());
        let laws = [
            TrainLaw::bushing(2e9, 2e4),
            TrainLaw::Bushing { stiffness: [[2e8, 1e8], [-3e8, 5e8]], damping: [[1e4, 2e3], [1e3, 4e4]] },
            TrainLaw::Contact { clearance: 20e-6, stiffness: 5e8, damping: 2e4 },
            TrainLaw::Contact { clearance: 22.3e-6, stiffness: 5e8, damping: 2e4 },
            TrainLaw::Film { bearing, table: table.clone(), viscosity: 0.01, roughness: 0.0 },
            TrainLaw::Film { bearing, table, viscosity: 0.01, roughness: 3e-6 },
        ];
        let (e, rate, speed) = ([18e-6, 13.5e-6], [0.02, 0.03], 210.0);
        for law in laws {
            let own = law.force(e, rate, speed).unwrap();
            for k in 0..2 {
                for (step, wanted, is_place) in
                    [(1e-11, &own.by_place, true), (1e-7, &own.by_velocity, false)]
                {
                    let shifted = |sign: f64| {
                        let (mut e, mut rate) = (e, rate);
                        let moved = if is_place { &mut e } else { &mut rate };
                        moved[k] += sign * step;
                        law.force(e, rate, speed).unwrap().force
                    };
                    let (low, high) = (shifted(-1.0), shifted(1.0));
                    for row in 0..2 {
                        let slope = (high[row] - low[row]) / (2.0 * step);
                        let largest = wanted.iter().flatten().fold(0.0f64, |most, v| most.max(v.abs()));
                        assert!(
                            (slope - wanted[row][k]).abs() < 2e-5 * largest,
                            "{law:?} {row} {k} {is_place}: {slope} {}",
                            wanted[row][k]
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn derivatives_of_a_tilted_film_are_those_of_its_force_wherever_its_end_is() {
        let bearing = JournalBearing::new(0.0275, 0.025, 30e-6).unwrap();
        // An end within its film, and one beyond the shell, with roughness and without.
        for (tilt, roughness) in [([4e-6, -6e-6], 0.0), ([12e-6, 9e-6], 0.0), ([12e-6, 9e-6], 1e-6)] {
            let law = TrainLaw::TiltedFilm { bearing, viscosity: 0.01, roughness };
            let e: Spot = [18e-6, 13.5e-6, tilt[0], tilt[1]];
            let (rate, speed) = ([0.02, 0.03, -0.01, 0.004], 210.0);
            let own = law.spot_force(&e, &rate, speed).unwrap();
            for k in 0..8 {
                let step = if k < 4 { 1e-11 } else { 1e-7 };
                let shifted = |sign: f64| {
                    let (mut e, mut rate) = (e, rate);
                    let moved = if k < 4 { &mut e[k] } else { &mut rate[k - 4] };
                    *moved += sign * step;
                    law.spot_force(&e, &rate, speed).unwrap().force
                };
                let (low, high) = (shifted(-1.0), shifted(1.0));
                let wanted = |row: usize| {
                    if k < 4 { own.by_place[row][k] } else { own.by_velocity[row][k - 4] }
                };
                let largest = (0..4).map(|row| wanted(row).abs()).fold(0.0, f64::max);
                for row in 0..4 {
                    let slope = (high[row] - low[row]) / (2.0 * step);
                    // The columns of the film follow the journal, which derivatives by its place leave out.
                    let bar = if k < 4 { 1e-2 } else { 1e-6 };
                    assert!((slope - wanted(row)).abs() < bar * largest, "{tilt:?} {k} {row}: {slope}");
                }
            }
        }
    }
}
