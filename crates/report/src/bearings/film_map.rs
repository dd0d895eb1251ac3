//! The film of a bearing unrolled: its thickness over the direction in the shell and the crank angle.
//!
//! ```text
//! h(a, theta) = c - e(theta) . n(a)        e in the shell's frame, a from -180 to 180 deg
//! ```

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::svg::{Anchor, Path, Svg};
use lanchester_film::{BearingFilm, BearingKind};
use lanchester_flex::picture::colour;
use std::f64::consts::PI;

/// Columns over the crank angle and rows over the direction.
const COLUMNS: usize = 90;
const ROWS: usize = 60;
/// Limits of the bands, as shares of the radial clearance: fine where the film is thin.
const LIMITS: [f64; 9] = [0.0, 0.05, 0.1, 0.2, 0.35, 0.6, 1.0, 1.5, 2.0];
/// Room beside the map [px], its size, and that of the scale below.
const LEFT: f64 = 58.0;
const TOP: f64 = 26.0;
const WIDTH: f64 = 360.0;
const HEIGHT: f64 = 190.0;
const SCALE: f64 = 52.0;

/// Maps of films, each with the name of its bearing: the films of one model of cavitation; `period` of the crank angle [rad].
pub(crate) fn film_maps(period: f64, films: &[(String, &BearingFilm)]) -> Figure {
    Figure {
        id: "film-maps".to_owned(),
        title: "Films unrolled".to_owned(),
        caption: "Thickness of the film over the crank angle and the direction in the shell, as a share of the radial clearance: of a main bearing from \
                  the x axis of the engine, of a big end from the rod's line towards the piston. Dark red is where journal and shell are nearest: \
                  where wear is to be expected. The white dot is the thinnest place of all."
            .to_owned(),
        columns: films.len().min(2),
        panels: films.iter().map(|(name, film)| map(period, name, film)).collect(),
    }
}

/// Eccentricity over the clearance in the shell's frame at a share of the period.
fn eccentricity(film: &BearingFilm, share: f64) -> [f64; 2] {
    let count = film.orbit.eccentricity.len();
    let index = ((share * count as f64) as usize).min(count.saturating_sub(1));
    let e = film.orbit.eccentricity.get(index).copied().unwrap_or_default();
    let (sin, cos) = film.shell_angle.get(index).copied().unwrap_or(0.0).sin_cos();
    let c = film.bearing.clearance;
    [(e[0] * cos + e[1] * sin) / c, (e[1] * cos - e[0] * sin) / c]
}

/// Thickness over the clearance in a direction of the shell [rad].
fn thickness(film: &BearingFilm, share: f64, direction: f64) -> f64 {
    let e = eccentricity(film, share);
    1.0 - e[0] * direction.cos() - e[1] * direction.sin()
}

fn band(thickness: f64) -> usize {
    LIMITS.iter().skip(1).position(|limit| thickness < *limit).unwrap_or(LIMITS.len() - 2)
}

/// Thin is red.
fn hexadecimal(band: usize) -> String {
    let last = (LIMITS.len() - 2) as f64;
    let [r, g, b] = colour(1.0 - band as f64 / last).map(|x| (255.0 * x).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn map(period: f64, name: &str, film: &BearingFilm) -> Panel {
    let mut svg = Svg::new(LEFT + WIDTH + 16.0, TOP + HEIGHT + 40.0 + SCALE);
    svg.text("strong", (LEFT, 15.0), Anchor::Start, &number::capital(name));
    let (x, y) = (|share: f64| LEFT + WIDTH * share, |share: f64| TOP + HEIGHT * (1.0 - share));
    let mut bands: Vec<Path> = vec![Path::default(); LIMITS.len() - 1];
    for column in 0..COLUMNS {
        let (left, right) = (x(column as f64 / COLUMNS as f64), x((column + 1) as f64 / COLUMNS as f64));
        let at = (column as f64 + 0.5) / COLUMNS as f64;
        let of = |row: usize| band(thickness(film, at, PI * (2.0 * (row as f64 + 0.5) / ROWS as f64 - 1.0)));
        let mut row = 0;
        while row < ROWS {
            let (first, own) = (row, of(row));
            while row < ROWS && of(row) == own {
                row += 1;
            }
            let (low, high) = (y(first as f64 / ROWS as f64), y(row as f64 / ROWS as f64));
            let path = std::mem::take(&mut bands[own]);
            bands[own] = path
                .move_to((left, low))
                .line_to((right, low))
                .line_to((right, high))
                .line_to((left, high))
                .close();
        }
    }
    for (index, path) in bands.iter().enumerate() {
        svg.fill(&hexadecimal(index), path);
    }
    let degrees = period.to_degrees();
    let abscissa = Axis::stepped(0.0, degrees, if degrees > 400.0 { 180.0 } else { 90.0 });
    for tick in &abscissa.ticks {
        let at = x(tick / degrees);
        svg.line("zero", (at, TOP + HEIGHT), (at, TOP + HEIGHT + 4.0));
        svg.text("muted small", (at, TOP + HEIGHT + 16.0), Anchor::Middle, &number::fixed(*tick, 0));
    }
    for tick in [-180.0, -90.0, 0.0, 90.0, 180.0] {
        let at = y((tick + 180.0) / 360.0);
        svg.line("zero", (LEFT - 4.0, at), (LEFT, at));
        svg.text("muted small", (LEFT - 7.0, at + 4.0), Anchor::End, &number::fixed(tick, 0));
    }
    svg.text("muted small", (LEFT + 0.5 * WIDTH, TOP + HEIGHT + 31.0), Anchor::Middle, "Crank angle [deg]");
    svg.text("muted small", (4.0, 15.0), Anchor::Start, "deg");
    let turned = film.least_film_in_shell.sin().atan2(film.least_film_in_shell.cos());
    let place = (x(film.least_film_angle / period), y((turned / PI + 1.0) / 2.0));
    svg.circle("pin", place, 4.5);
    let (top, step) = (TOP + HEIGHT + 42.0, WIDTH / (LIMITS.len() - 1) as f64);
    for index in 0..LIMITS.len() - 1 {
        let (left, right) = (LEFT + step * index as f64, LEFT + step * (index + 1) as f64);
        let corners = [(left, top), (right, top), (right, top + 12.0), (left, top + 12.0)];
        svg.fill(&hexadecimal(index), &Path::through(corners).close());
    }
    for (index, limit) in LIMITS.iter().enumerate() {
        let text = if index + 1 == LIMITS.len() { format!("{limit} c") } else { limit.to_string() };
        svg.text("muted small", (LEFT + step * index as f64, top + 26.0), Anchor::Middle, &text);
    }
    let at = match film.kind {
        BearingKind::Main => "from the x axis",
        BearingKind::Crankpin => "from the rod's line",
    };
    let said = format!(
        "{}: thinnest film {} um at {} deg crank angle, {} deg {at}.",
        number::capital(name),
        number::short(1e6 * film.orbit.least_film, 3),
        number::short(film.least_film_angle.to_degrees(), 3),
        number::short(turned.to_degrees(), 3)
    );
    Panel::new(svg, said)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// The film of a map is nowhere thinner than the least film, and has it at the ring.
    pub(crate) fn check(film: &BearingFilm) {
        let c = film.bearing.clearance;
        let share = film.orbit.least_film_at;
        let at_ring = c * thickness(film, share + 1e-9, film.least_film_in_shell);
        assert!((at_ring - film.orbit.least_film).abs() < 1e-6 * c, "{at_ring} {}", film.orbit.least_film);
        for column in 0..COLUMNS {
            for row in 0..ROWS {
                let direction = PI * (2.0 * (row as f64 + 0.5) / ROWS as f64 - 1.0);
                let here = c * thickness(film, (column as f64 + 0.5) / COLUMNS as f64, direction);
                assert!(here >= film.orbit.least_film * (1.0 - 1e-9) && here <= 2.0 * c, "{here}");
            }
        }
    }

    #[test]
    fn bands_hold_their_limits() {
        assert_eq!((band(0.0), band(0.049), band(0.05), band(1.99), band(2.5)), (0, 0, 1, 7, 7));
        assert_ne!(hexadecimal(0), hexadecimal(7));
    }
}
