//! Oil films of the bearings over the cycle, in numbers.

use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::table::{Table, numbers, words};
use lanchester_film::{BearingFilm, BearingKind, OrbitOutcome};
use std::f64::consts::PI;

/// Least film, pressure, friction, flow and temperature of every bearing.
pub fn films_table(films: &[BearingFilm]) -> Table {
    let state = |film: &BearingFilm| match film.orbit.outcome {
        OrbitOutcome::Overloaded => "overloaded",
        _ if film.orbit.contact_time > 0.0 => "contact",
        OrbitOutcome::NotPeriodic => "not periodic",
        OrbitOutcome::Periodic if film.orbit.least_film < film.roughness => "below roughness",
        OrbitOutcome::Periodic if !film.heat_balanced => "no heat balance",
        OrbitOutcome::Periodic => "",
    };
    let column = |header, unit, digits, value: fn(&BearingFilm) -> f64| {
        numbers(header, unit, films.iter().map(value), digits)
    };
    Table::of_columns(
        "bearing-films",
        "Oil films",
        "Least film over the cycle with its crank angle and its direction in the shell (main: frame of the engine; big end: from the rod's line).",
        vec![
            words("bearing", films.iter().map(bearing_name)),
            words("cavitation", films.iter().map(|film| film.cavitation.name().to_owned())),
            column("clearance", "um", 3, |film| 2e6 * film.bearing.clearance),
            column("least film", "um", 4, |film| 1e6 * film.orbit.least_film),
            column("at", "deg", 4, |film| film.least_film_angle * 180.0 / PI),
            column("in shell", "deg", 4, |film| film.least_film_in_shell * 180.0 / PI),
            column("largest pressure", "MPa", 4, |film| 1e-6 * film.orbit.largest_pressure),
            column("at", "deg", 4, |film| film.largest_pressure_angle * 180.0 / PI),
            column("friction", "W", 4, |film| film.orbit.friction_power),
            column("flow", "ml/s", 3, |film| 1e6 * film.orbit.side_flow),
            column("rise", "K", 3, |film| film.temperature_rise),
            column("viscosity", "mPa s", 3, |film| 1e3 * film.viscosity),
            words("remark", films.iter().map(|film| state(film).to_owned())),
        ],
    )
}

fn bearing_name(film: &BearingFilm) -> String {
    match (film.kind, film.crankshaft) {
        (BearingKind::Main, 1) => format!("main {}", film.number),
        (BearingKind::Main, crankshaft) => format!("main {} of crankshaft {crankshaft}", film.number),
        (BearingKind::Crankpin, _) => format!("big end {}", film.number),
    }
}

/// Least film of every bearing over speed [um]: by speed [rad/s] the same bearings in the same order.
pub fn films_over_speed_table(speeds: &[(f64, &[BearingFilm])]) -> Table {
    let mut columns = vec![numbers("speed", "1/min", speeds.iter().map(|(speed, _)| number::rpm(*speed)), 4)];
    let first = speeds.first().map_or(&[][..], |(_, films)| *films);
    let several = first.iter().any(|film| film.cavitation != first[0].cavitation);
    for (k, film) in first.iter().enumerate() {
        let name = bearing_name(film);
        let name = if several { format!("{name}, {}", film.cavitation.name()) } else { name };
        let least =
            speeds.iter().map(|(_, films)| films.get(k).map_or(f64::NAN, |film| 1e6 * film.orbit.least_film));
        columns.push(numbers(&name, "um", least, 4));
    }
    Table::of_columns("films-over-speed", "Least film over speed", "Over the cycle at each speed.", columns)
}

/// The table with what was assumed.
pub fn films_text(engine: &str, speed: f64, films: &[BearingFilm], assumptions: &[String]) -> String {
    let rpm = number::terminal(number::rpm(speed), 0);
    let mut out = format!("{engine} at {rpm} rpm: oil films\n\n{}", films_table(films).text());
    for assumption in assumptions {
        out.push('\n');
        push_wrapped(&mut out, "", assumption);
    }
    out
}

/// The orbit of every bearing over the crank angle, as CSV.
pub fn films_csv(period: f64, films: &[BearingFilm]) -> String {
    let mut out = String::from(
        "bearing,number,crankshaft,cavitation,crank_angle_deg,eccentricity_x_um,eccentricity_y_um,film_um\n",
    );
    for film in films {
        let kind = match film.kind {
            BearingKind::Main => "main",
            BearingKind::Crankpin => "big-end",
        };
        let n = film.orbit.eccentricity.len();
        for (i, e) in film.orbit.eccentricity.iter().enumerate() {
            let angle = period * 180.0 / PI * i as f64 / n as f64;
            let thickness = film.bearing.clearance - e[0].hypot(e[1]);
            out.push_str(&format!(
                "{kind},{},{},{},{angle:.4},{:.6},{:.6},{:.6}\n",
                film.number,
                film.crankshaft,
                film.cavitation.name(),
                1e6 * e[0],
                1e6 * e[1],
                1e6 * thickness
            ));
        }
    }
    out
}
