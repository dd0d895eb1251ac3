//! Pictures of the oil films: orbits in their clearances, film over the crank angle, least film over speed.

use crate::bearings::film_map::film_maps;
use crate::bearings::film_name::bearing_name;
use crate::kit::figure::{Figure, Panel};
use crate::kit::plot::{AnglePlot, Series};
use crate::kit::xy_plot::{XyCurve, XyPlot};
use crate::torque::figures::closed;
use lanchester_film::{BearingFilm, BearingKind};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Points of a drawn circle.
const CIRCLE: usize = 120;
/// Line styles of a plot, the first for the sum or the only curve.
const STYLES: usize = 6;

/// Change of an orbit over the clearance that counts as none, as in the crate `film`.
const REPEATS: f64 = 1e-3;
/// What that makes of pressure, friction and the direction of the thinnest film.
const ALIKE: f64 = 0.01;

/// Films of one bearing by its models of cavitation.
type OneBearing<'a> = Vec<&'a BearingFilm>;

/// Orbits of all journals, their films unrolled, and over the crank angle; `period` of the crank angle [rad].
pub fn film_figures(period: f64, films: &[BearingFilm]) -> Vec<Figure> {
    let bearings = by_bearing(films);
    if bearings.is_empty() {
        return Vec::new();
    }
    let alike = alike(&bearings);
    // One model of cavitation says where the film is thin.
    let first: Vec<(String, &BearingFilm)> =
        alike.iter().map(|(names, films)| (names.clone(), films[0])).collect();
    vec![orbits(&alike), film_maps(period, &first), thickness(period, &bearings)]
}

/// Least film of every bearing over speed: by speed [rad/s] the same films in the same order. None for a single speed.
pub fn films_over_speed_figure(speeds: &[(f64, &[BearingFilm])]) -> Option<Figure> {
    let (_, first) = speeds.first().filter(|_| speeds.len() > 1)?;
    let several = first.iter().any(|film| film.cavitation != first[0].cavitation);
    let curve = |k: usize, film: &BearingFilm| {
        let name = bearing_name(film);
        let least = speeds.iter().filter_map(|(speed, films)| {
            let film = films.get(k)?;
            Some((crate::kit::number::rpm(*speed), film.orbit.least_anywhere()))
        });
        XyCurve {
            name: if several { format!("{name}, {}", film.cavitation.name()) } else { name },
            style: 0,
            points: least.collect(),
            dots: false,
        }
    };
    let panel = |kind: BearingKind, ordinate: &str| {
        let own = first.iter().enumerate().filter(|(_, film)| film.kind == kind);
        let mut curves: Vec<XyCurve> = own.map(|(k, film)| curve(k, film)).collect();
        for (style, curve) in curves.iter_mut().enumerate() {
            curve.style = style % STYLES;
        }
        let plot = XyPlot { abscissa: "Speed", ordinate, units: ["rpm", "m"], polar: None, curves };
        (!plot.curves.is_empty()).then(|| plot.panel())
    };
    let panels: Vec<Panel> = [
        panel(BearingKind::Main, "Least film, main bearings"),
        panel(BearingKind::Crankpin, "Least film, big ends"),
    ]
    .into_iter()
    .flatten()
    .collect();
    Some(Figure {
        id: "films-over-speed".to_owned(),
        title: "Least film over speed".to_owned(),
        caption: "The thinnest place of each bearing's film over the cycle at each speed.".to_owned(),
        columns: panels.len(),
        panels,
    })
}

/// Films in the order of their bearings, those of one bearing together.
fn by_bearing(films: &[BearingFilm]) -> Vec<OneBearing<'_>> {
    let mut bearings: Vec<OneBearing> = Vec::new();
    for film in films {
        let key = (film.kind, film.crankshaft, film.number);
        match bearings.iter_mut().find(|known| {
            known.first().is_some_and(|first| (first.kind, first.crankshaft, first.number) == key)
        }) {
            Some(known) => known.push(film),
            None => bearings.push(vec![film]),
        }
    }
    bearings
}

/// Bearings whose films do the same at other angles, as cylinders of one kind have them: drawn once, with the names of all.
fn alike<'a>(bearings: &[OneBearing<'a>]) -> Vec<(String, OneBearing<'a>)> {
    let mut groups: Vec<(Vec<String>, &OneBearing)> = Vec::new();
    for films in bearings {
        let same = |known: &OneBearing| {
            known.len() == films.len() && known.iter().zip(films).all(|(a, b)| does_the_same(a, b))
        };
        let name = bearing_name(films[0]);
        match groups.iter_mut().find(|(_, known)| same(known)) {
            Some((names, _)) => names.push(name),
            None => groups.push((vec![name], films)),
        }
    }
    groups.into_iter().map(|(names, films)| (names.join(", "), films.clone())).collect()
}

/// Whether two films differ by no more than orbits repeat to.
fn does_the_same(a: &BearingFilm, b: &BearingFilm) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= ALIKE * a.abs().max(b.abs());
    let same_bearing = (a.kind, a.bearing) == (b.kind, b.bearing);
    let apart = (a.orbit.least_film - b.orbit.least_film).abs();
    same_bearing
        && apart <= REPEATS * a.bearing.clearance
        && near(a.orbit.largest_pressure, b.orbit.largest_pressure)
        && near(a.orbit.friction_power, b.orbit.friction_power)
        && (a.least_film_in_shell - b.least_film_in_shell).sin().abs() < ALIKE
}

/// The journal's centre in its shell's frame, inside the circle in which journal and shell would touch.
fn orbits(bearings: &[(String, OneBearing<'_>)]) -> Figure {
    let panel = |(name, films): &(String, OneBearing)| {
        let first = films[0];
        let clearance = first.bearing.clearance;
        let mut curves: Vec<XyCurve> = films
            .iter()
            .enumerate()
            .map(|(style, film)| XyCurve {
                name: film.cavitation.name().to_owned(),
                style: style % (STYLES - 1),
                points: closed(in_shell(film).into_iter()),
                dots: false,
            })
            .collect();
        let circle = (0..CIRCLE).map(|k| {
            let (sin, cos) = (TAU * k as f64 / CIRCLE as f64).sin_cos();
            (clearance * sin, clearance * cos)
        });
        curves.push(XyCurve {
            name: "journal touches shell".to_owned(),
            style: STYLES - 1,
            points: closed(circle),
            dots: false,
        });
        curves.push(XyCurve {
            name: "thinnest film".to_owned(),
            style: 0,
            points: films.iter().map(|film| thinnest(film)).collect(),
            dots: true,
        });
        let name = crate::kit::number::capital(name);
        let (up, across) = match first.kind {
            BearingKind::Main => (format!("{name}: centre along x"), "centre along y"),
            BearingKind::Crankpin => (format!("{name}: centre towards the piston"), "centre across the rod"),
        };
        let plot =
            XyPlot { abscissa: across, ordinate: &up, units: ["m", "m"], polar: Some(clearance), curves };
        plot.panel()
    };
    Figure {
        id: "film-orbits".to_owned(),
        title: "Orbits of the journals".to_owned(),
        caption: "Centre of the journal in its shell over the cycle: of a main bearing in the frame of the engine, of a big end in that of the rod. \
                  What is left to the outer circle is the film; the dot is where it is thinnest."
            .to_owned(),
        panels: bearings.iter().map(panel).collect(),
        columns: bearings.len().min(3),
    }
}

/// Places of the journal's centre as abscissa and ordinate: across and along the shell's axis [m].
fn in_shell(film: &BearingFilm) -> Vec<(f64, f64)> {
    let place = |(i, e): (usize, &[f64; 2])| {
        let turned = Complex64::new(e[0], e[1])
            * Complex64::from_polar(1.0, -film.shell_angle.get(i).copied().unwrap_or(0.0));
        (turned.im, turned.re)
    };
    film.orbit.eccentricity.iter().enumerate().map(place).collect()
}

/// Where the journal's centre is when its film is thinnest.
fn thinnest(film: &BearingFilm) -> (f64, f64) {
    let size = film.bearing.clearance - film.orbit.least_film;
    let (sin, cos) = film.least_film_in_shell.sin_cos();
    (size * sin, size * cos)
}

/// The thinnest place of every film over the crank angle.
fn thickness(period: f64, bearings: &[OneBearing<'_>]) -> Figure {
    let count = bearings[0][0].orbit.eccentricity.len();
    let theta: Vec<f64> = (0..count).map(|i| period * i as f64 / count as f64).collect();
    let panels = [BearingKind::Main, BearingKind::Crankpin].into_iter().filter_map(|kind| {
        let films: Vec<&BearingFilm> =
            bearings.iter().flatten().copied().filter(|film| film.kind == kind).collect();
        let several = films.iter().any(|film| film.cavitation != films[0].cavitation);
        let values: Vec<Vec<f64>> = films
            .iter()
            .map(|film| {
                let thin = |e: &[f64; 2]| film.bearing.clearance - e[0].hypot(e[1]);
                film.orbit.eccentricity.iter().map(thin).collect()
            })
            .collect();
        let series = films.iter().zip(&values).enumerate().map(|(k, (film, values))| Series {
            name: match several {
                true => format!("{}, {}", bearing_name(film), film.cavitation.name()),
                false => bearing_name(film),
            },
            style: k % STYLES,
            values,
        });
        let quantity = match kind {
            BearingKind::Main => "Thinnest film, main bearings",
            BearingKind::Crankpin => "Thinnest film, big ends",
        };
        let plot = AnglePlot { quantity, unit: "m", theta: &theta, period, series: series.collect() };
        (!films.is_empty()).then(|| plot.panel())
    });
    let panels: Vec<Panel> = panels.collect();
    Figure {
        id: "film-thickness".to_owned(),
        title: "Films over the crank angle".to_owned(),
        caption: "Thickness at the thinnest place of each bearing; 0 is the shell.".to_owned(),
        columns: panels.len(),
        panels,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_film::{BearingFilmRequest, FilmSource, bearing_film};
    use lanchester_film::{Cavitation, FilmOil, FilmTable, JournalBearing, JournalCycle, OrbitOutcome};

    /// A big end whose rod swings: the load turns with the rod, so that the orbit stands still in the shell.
    fn swinging() -> BearingFilm {
        let n = 180;
        let bearing = JournalBearing::new(0.024, 0.02, 2.4e-5).expect("plausible");
        let table = FilmTable::new(bearing.slenderness(), Cavitation::Gumbel).expect("a table");
        let rod: Vec<f64> = (0..n).map(|i| 0.3 * (TAU * i as f64 / n as f64).sin()).collect();
        let rate: Vec<f64> = (0..n).map(|i| 0.3 * TAU / 0.02 * (TAU * i as f64 / n as f64).cos()).collect();
        let cycle = JournalCycle {
            duration: 0.02,
            load: rod.iter().map(|angle| [5000.0 * angle.cos(), 5000.0 * angle.sin()]).collect(),
            entrainment: rate.iter().map(|rate| 300.0 + rate).collect(),
            sliding: vec![600.0; n],
        };
        let request = BearingFilmRequest {
            kind: BearingKind::Crankpin,
            crankshaft: 1,
            number: 1,
            bearing,
            source: FilmSource::Table(&table),
            cycle: &cycle,
            shell: &rod,
            period: TAU,
            roughness: 0.0,
            oil: FilmOil::Fixed { viscosity: 0.01, density: 850.0 },
        };
        bearing_film(&request).expect("a film")
    }

    #[test]
    fn an_orbit_that_follows_its_shell_is_drawn_as_a_point() {
        let film = swinging();
        assert_eq!(film.orbit.outcome, OrbitOutcome::Periodic);
        let places = in_shell(&film);
        let (x, y) = places[0];
        let far = places.iter().map(|p| (p.0 - x).hypot(p.1 - y)).fold(0.0, f64::max);
        let swept = film.orbit.eccentricity.iter().map(|e| e[1]).fold(0.0, f64::max);
        // The orbit repeats within a thousandth of the clearance; in the block's frame it sweeps far more.
        assert!(far < 2e-3 * film.bearing.clearance, "{far}");
        assert!(swept > 0.2 * film.bearing.clearance, "{swept}");
        let (dot, size) = (thinnest(&film), film.bearing.clearance - film.orbit.least_film);
        assert!(
            (dot.0 - x).hypot(dot.1 - y) < 4e-3 * film.bearing.clearance && size > 0.0,
            "{dot:?} {x} {y}"
        );
    }

    #[test]
    fn models_of_one_bearing_share_a_drawing() {
        let film = swinging();
        let other = BearingFilm { cavitation: Cavitation::Reynolds, ..film.clone() };
        let second = BearingFilm { number: 2, ..film.clone() };
        let figures = film_figures(TAU, &[film.clone(), other, second.clone()]);
        assert_eq!(figures[0].panels.len(), 2);
        let figures = film_figures(TAU, &[film.clone(), second.clone()]);
        assert_eq!(figures[0].panels.len(), 1, "both do the same");
        let wide = JournalBearing::new(0.024, 0.02, 3e-5).expect("plausible");
        let other = BearingFilm { number: 2, bearing: wide, ..film.clone() };
        assert_eq!(film_figures(TAU, &[film.clone(), other])[0].panels.len(), 2);
        assert_eq!((figures[1].panels.len(), figures[2].panels.len()), (1, 1));
        crate::bearings::film_map::tests::check(&film);
        assert!(film_figures(TAU, &[]).is_empty());
        assert!(films_over_speed_figure(&[(1.0, std::slice::from_ref(&film))]).is_none());
        let over = films_over_speed_figure(&[(1.0, std::slice::from_ref(&film)), (2.0, &[second])])
            .expect("two speeds");
        assert_eq!(over.panels.len(), 1);
    }
}
