//! Oil films that belong to no engine: `film S RULE L/D X eps E` is the Sommerfeld number `mu N (R/c)^2/p` of a steady finite film and `film attitude RULE L/D X
//! eps E` its attitude angle [deg], with RULE `reynolds` (fed without pressure on the line of its largest thickness) or `gumbel`; `short bearing eps at N rpm`,
//! `short bearing K across` [N/m] and `short bearing C across` [N s/m] are those of the half film of Friswell's example: 525 N, 100 mm diameter, 30 mm, c 0.1 mm,
//! 0.1 Pa s.

use lanchester::film::{
    Cavitation, Feed, FilmGrid, FilmProblem, FilmSolver, JournalBearing, JournalMotion, attitude,
    short_bearing_force,
};
use std::f64::consts::{PI, TAU};

/// Cells around and along half the length of the coarser of two grids, between which a number is extrapolated: of Sommerfeld numbers, which have one digit
/// more, and of attitude angles.
const FINE: [usize; 2] = [300, 34];
const COARSE: [usize; 2] = [180, 20];
/// The bearing and its load [N].
const EXAMPLE: JournalBearing = JournalBearing { radius: 0.05, length: 0.03, clearance: 1e-4 };
const VISCOSITY: f64 = 0.1;
const LOAD: f64 = 525.0;
/// Speed at which its stiffness and damping are given [rad/s].
const SPEED: f64 = 1500.0 * TAU / 60.0;

/// A number of a film.
pub(crate) enum FilmKey {
    Sommerfeld { rule: Cavitation, slenderness: f64, ratio: f64 },
    Attitude { rule: Cavitation, slenderness: f64, ratio: f64 },
    Eccentricity { speed: f64 },
    StiffnessAcross,
    DampingAcross,
}

impl FilmKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<FilmKey> {
        if let Some(rest) = text.strip_prefix("short bearing ") {
            return match rest {
                "K across" => Some(FilmKey::StiffnessAcross),
                "C across" => Some(FilmKey::DampingAcross),
                _ => {
                    let rpm: f64 = rest.strip_prefix("eps at ")?.strip_suffix(" rpm")?.parse().ok()?;
                    (rpm > 0.0).then_some(FilmKey::Eccentricity { speed: rpm * TAU / 60.0 })
                }
            };
        }
        let words: Vec<&str> = text.strip_prefix("film ")?.split(' ').collect();
        let [what, rule, "L/D", slenderness, "eps", ratio] = words[..] else { return None };
        let rule = match rule {
            "reynolds" => Cavitation::Reynolds,
            "gumbel" => Cavitation::Gumbel,
            _ => return None,
        };
        let slenderness = slenderness.parse().ok().filter(|own| (0.02..=20.0).contains(own))?;
        let ratio = ratio.parse().ok().filter(|own| *own > 0.0 && *own < 1.0)?;
        match what {
            "S" => Some(FilmKey::Sommerfeld { rule, slenderness, ratio }),
            "attitude" => Some(FilmKey::Attitude { rule, slenderness, ratio }),
            _ => None,
        }
    }

    /// Its value.
    pub fn of(&self) -> Result<f64, String> {
        match *self {
            FilmKey::Sommerfeld { rule, slenderness, ratio } => {
                extrapolated(rule, slenderness, ratio, FINE).map(|found| found[0])
            }
            FilmKey::Attitude { rule, slenderness, ratio } => {
                extrapolated(rule, slenderness, ratio, COARSE).map(|found| found[1])
            }
            FilmKey::Eccentricity { speed } => eccentricity(speed).map(|e| e / EXAMPLE.clearance),
            FilmKey::StiffnessAcross => {
                across(|e, step, sense| (add(e, sense * step), [0.0, 0.0]), 1e-4 * EXAMPLE.clearance)
            }
            FilmKey::DampingAcross => across(|e, step, sense| (e, add([0.0, 0.0], sense * step)), 1e-6),
        }
    }
}

/// A vector moved across the load, which acts along -x.
fn add([x, y]: [f64; 2], by: f64) -> [f64; 2] {
    [x, y + by]
}

/// Sommerfeld number and attitude angle [deg], extrapolated with second order.
fn extrapolated(
    rule: Cavitation,
    slenderness: f64,
    ratio: f64,
    cells: [usize; 2],
) -> Result<[f64; 2], String> {
    let coarse = steady(rule, slenderness, ratio, cells)?;
    let fine = steady(rule, slenderness, ratio, cells.map(|count| 2 * count))?;
    Ok([0, 1].map(|k| fine[k] + (fine[k] - coarse[k]) / 3.0))
}

fn steady(
    rule: Cavitation,
    slenderness: f64,
    ratio: f64,
    [around, axial]: [usize; 2],
) -> Result<[f64; 2], String> {
    let (speed, viscosity, radius) = (100.0, 0.01, 0.05);
    let bearing = JournalBearing { radius, length: 2.0 * radius * slenderness, clearance: 1e-3 * radius };
    let mut film = FilmProblem {
        bearing,
        viscosity,
        motion: JournalMotion {
            eccentricity: [ratio * bearing.clearance, 0.0],
            entrainment: 0.5 * speed,
            sliding: speed,
            ..JournalMotion::default()
        },
        tilt: [0.0, 0.0],
        cavitation: rule,
        feeds: Vec::new(),
    };
    if rule == Cavitation::Reynolds {
        film.feeds.push(Feed::Line { angle: PI, pressure: 0.0 });
    }
    let half = film.is_symmetric();
    // A column lies on the line of the largest film.
    let grid = FilmGrid::uniform(around, if half { axial } else { 2 * axial }, half, PI / around as f64);
    let grid = grid.map_err(|error| error.to_string())?;
    let solution = FilmSolver::new(grid)
        .and_then(|mut solver| solver.solve(&film))
        .map_err(|error| error.to_string())?;
    let load = solution.force[0].hypot(solution.force[1]);
    let pressure = load / (2.0 * radius * bearing.length);
    let number = viscosity * speed / TAU * (radius / bearing.clearance).powi(2) / pressure;
    Ok([number, attitude(solution.force, film.motion.eccentricity).to_degrees()])
}

fn force(e: [f64; 2], velocity: [f64; 2], speed: f64) -> Result<[f64; 2], String> {
    let motion = JournalMotion { eccentricity: e, velocity, entrainment: 0.5 * speed, sliding: speed };
    short_bearing_force(&EXAMPLE, VISCOSITY, &motion, true).map_err(|error| error.to_string())
}

/// Eccentricity at which the half film carries the load [m]: the force grows with it.
fn eccentricity(speed: f64) -> Result<f64, String> {
    let (mut low, mut high) = (0.0, (1.0 - 1e-9) * EXAMPLE.clearance);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        let found = force([middle, 0.0], [0.0, 0.0], speed)?;
        if found[0].hypot(found[1]) < LOAD {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(0.5 * (low + high))
}

/// Slope of the film's force across the load, against what `moved` changes.
fn across(moved: impl Fn([f64; 2], f64, f64) -> ([f64; 2], [f64; 2]), step: f64) -> Result<f64, String> {
    let size = eccentricity(SPEED)?;
    let found = force([size, 0.0], [0.0, 0.0], SPEED)?;
    // Turned so that the film's force is along +x and the load along -x.
    let turn = -found[1].atan2(found[0]);
    let e = [size * turn.cos(), size * turn.sin()];
    let at = |sense: f64| {
        let (e, velocity) = moved(e, step, sense);
        force(e, velocity, SPEED)
    };
    Ok(-(at(1.0)?[1] - at(-1.0)?[1]) / (2.0 * step))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        assert!(matches!(FilmKey::parse("film S gumbel L/D 0.5 eps 0.6"), Some(FilmKey::Sommerfeld { .. })));
        assert!(matches!(
            FilmKey::parse("film attitude reynolds L/D 1 eps 0.2"),
            Some(FilmKey::Attitude { .. })
        ));
        assert!(matches!(FilmKey::parse("short bearing K across"), Some(FilmKey::StiffnessAcross)));
        for text in [
            "film",
            "film S gumbel L/D 0.5 eps 1",
            "film S full L/D 1 eps 0.2",
            "short bearing",
            "short bearing eps at 0 rpm",
        ] {
            assert!(FilmKey::parse(text).is_none(), "{text}");
        }
    }

    #[test]
    fn the_half_film_carries_its_load() {
        let e = eccentricity(SPEED).unwrap();
        let found = force([e, 0.0], [0.0, 0.0], SPEED).unwrap();
        assert!((found[0].hypot(found[1]) / LOAD - 1.0).abs() < 1e-9);
    }
}
