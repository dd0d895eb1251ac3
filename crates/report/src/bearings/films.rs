//! Oil films of the bearings over the cycle, in numbers.

use crate::bearings::film_figures::film_figures;
use crate::bearings::film_name::bearing_name;
use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::section::Section;
use crate::kit::table::{Cell, Column, Table, numbers, words};
use lanchester_film::{BearingFilm, BearingKind, Cavitation, OrbitOutcome, ShaftRun};
use std::f64::consts::PI;

/// Rise of temperature that no oil survives [K].
const HOT: f64 = 200.0;

/// Composite roughness of well run-in bearings [m]: a film below it, where the file gives none, is no film.
const ROUGH: f64 = 0.3e-6;

/// Least film, pressure, friction, flow and temperature of every bearing.
pub fn films_table(films: &[BearingFilm]) -> Table {
    let column = |header: &str, unit, digits, value: fn(&BearingFilm) -> f64| {
        numbers(header, unit, films.iter().map(value), digits)
    };
    let mut columns = vec![
        words("bearing", films.iter().map(bearing_name)),
        words("cavitation", films.iter().map(|film| film.cavitation.name().to_owned())),
        column("clearance", "um", 3, |film| 2e6 * film.bearing.clearance),
        column("least film", "um", 4, |film| 1e6 * film.orbit.least_film),
        column("at", "deg", 4, |film| film.least_film_angle * 180.0 / PI),
        column("in shell", "deg", 4, |film| film.least_film_in_shell * 180.0 / PI),
        column("largest pressure", "MPa", 4, |film| 1e-6 * film.orbit.largest_pressure),
        column("at", "deg", 4, |film| film.largest_pressure_angle * 180.0 / PI),
        column("friction", "W", 4, |film| film.orbit.friction_power),
        column("under pressure", "W", 4, |film| film.orbit.friction_power_of_pressure_part),
        column("flow", "ml/s", 3, |film| 1e6 * film.orbit.side_flow),
        column("rise", "K", 3, |film| film.temperature_rise.unwrap_or(f64::NAN)),
        column("viscosity", "mPa s", 3, |film| 1e3 * film.viscosity),
    ];
    let is_tilted = films.iter().any(|film| film.orbit.least_edge_film.is_some());
    if is_tilted {
        let edge = |film: &BearingFilm| film.orbit.least_edge_film.map_or(f64::NAN, |film| 1e6 * film);
        columns.insert(4, column("at an end", "um", 4, edge));
        columns.insert(2, column("largest load", "kN", 4, |film| 1e-3 * film.largest_load));
    }
    columns.push(words("remark", films.iter().map(remarks)));
    let mut note =
        "Least film over the cycle with its crank angle and its direction in the shell (main: frame of the engine; big end: from the rod's line). Friction: of a shell full of oil, and with shear only where there is pressure."
            .to_owned();
    if is_tilted {
        note += " At an end: least film there, of a journal that tilts with its shaft. Load: what film and contact carry.";
    }
    Table::of_columns("bearing-films", "Oil films", note, columns)
}

/// All that makes a film one not to go by.
fn remarks(film: &BearingFilm) -> String {
    let orbit = &film.orbit;
    if orbit.outcome == OrbitOutcome::Overloaded {
        return "overloaded".to_owned();
    }
    let mut out: Vec<String> = Vec::new();
    if orbit.least_edge_film.is_some_and(|film| film <= 0.0) {
        out.push("an end touches".to_owned());
    }
    if orbit.contact_time > 0.0 {
        out.push(format!(
            "contact {:.0} % of the time, with up to {:.0} % of the load; its friction is not counted",
            100.0 * orbit.contact_time,
            100.0 * orbit.contact_share
        ));
    }
    if orbit.outcome == OrbitOutcome::NotPeriodic {
        out.push(format!(
            "not periodic: after {} periods its orbit still changes by {:.2} % of the clearance",
            orbit.periods,
            100.0 * orbit.change
        ));
    }
    if orbit.least_anywhere() < film.roughness {
        out.push("below roughness".to_owned());
    } else if film.roughness == 0.0 && orbit.least_anywhere() < ROUGH {
        out.push("thinner than surfaces are rough".to_owned());
    }
    match film.temperature_rise {
        _ if !film.heat_balanced => out.push("no heat balance".to_owned()),
        None if film.cavitation == Cavitation::Full => out.push("no flow takes the heat".to_owned()),
        Some(rise) if rise <= HOT => {}
        _ => out.push("rise beyond any oil".to_owned()),
    }
    out.join("; ")
}

/// How the run of every floating crankshaft ended, with its energies; `None` without one.
pub fn shaft_runs_table(shafts: &[ShaftRun]) -> Option<Table> {
    if shafts.is_empty() {
        return None;
    }
    let energy = |header: &str, digits, of: fn(&lanchester_film::FilmEnergy) -> f64| {
        let cells = shafts.iter().map(|run| match &run.energy {
            Some(energy) => Cell::number(of(energy), digits),
            None => Cell::Empty,
        });
        (Column::numbers(header, "J"), cells.collect())
    };
    let count = |header: &str, of: fn(&ShaftRun) -> f64| {
        let cells = shafts.iter().map(|run| Cell::Number { value: of(run), decimals: 0 });
        (Column::numbers(header, ""), cells.collect())
    };
    let outcome = |run: &ShaftRun| match run.outcome {
        OrbitOutcome::Periodic => "repeat".to_owned(),
        OrbitOutcome::NotPeriodic => "do not repeat".to_owned(),
        OrbitOutcome::Overloaded => "overloaded".to_owned(),
    };
    Some(Table::of_columns(
        "film-runs",
        "How the orbits ended",
        "Change: of orbits over the clearance, from the last period but one. Energies over the last period: work of the loads and of the turning journals, losses in the films by \
         the flow that their pressure drives, contact. Energy missing: work less losses, contact and change of kinetic energy, over the sum of the sizes of all powers. Shear in the \
         films is not in the balance, since its torque does not move the shaft aside.",
        vec![
            words("crankshaft", shafts.iter().map(|run| run.crankshaft.to_string())),
            words("cavitation", shafts.iter().map(|run| run.cavitation.name().to_owned())),
            words("orbits", shafts.iter().map(outcome)),
            count("periods", |run| run.periods as f64),
            words("orbits change", shafts.iter().map(|run| format!("{:.1e}", run.change))),
            energy("loads", 5, |energy| energy.loads),
            energy("turning", 5, |energy| energy.turning),
            energy("films", 5, |energy| energy.films),
            energy("contact", 3, |energy| energy.contact),
            energy("change", 3, |energy| energy.change),
            words("energy missing", shafts.iter().map(|run| missing_words(run.energy_error))),
            count("steps", |run| run.steps as f64),
        ],
    ))
}

/// Missing energy over the turnover.
fn missing_words(error: Option<f64>) -> String {
    error.map_or_else(String::new, |error| format!("{error:.1e}"))
}

/// Least film of every bearing over speed [um]: at each speed the same bearings in the same order. With crankshafts that float in their films the largest missing
/// energy of their runs.
pub fn films_over_speed_table(speeds: &[FilmsInput<'_>]) -> Table {
    let mut columns = vec![numbers("speed", "1/min", speeds.iter().map(|own| number::rpm(own.speed)), 4)];
    let first = speeds.first().map_or(&[][..], |own| own.films);
    let several = first.iter().any(|film| film.cavitation != first[0].cavitation);
    for (k, film) in first.iter().enumerate() {
        let name = bearing_name(film);
        let name = if several { format!("{name}, {}", film.cavitation.name()) } else { name };
        let least = speeds
            .iter()
            .map(|own| own.films.get(k).map_or(f64::NAN, |film| 1e6 * film.orbit.least_anywhere()));
        columns.push(numbers(&name, "um", least, 4));
    }
    if speeds.iter().any(|own| !own.shafts.is_empty()) {
        let largest = |own: &FilmsInput<'_>| {
            let errors = || own.shafts.iter().map(|run| run.energy_error);
            // A run that ended early has none, and then there is no largest.
            errors().all(|error| error.is_some()).then(|| errors().flatten().fold(0.0, f64::max))
        };
        columns.push(words("energy missing", speeds.iter().map(|own| missing_words(largest(own)))));
    }
    Table::of_columns("films-over-speed", "Least film over speed", "Over the cycle at each speed.", columns)
}

/// Films of an engine at one speed, for the chapter of a report.
#[derive(Debug, Clone, Copy)]
pub struct FilmsInput<'a> {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Period of the crank angle [rad].
    pub period: f64,
    /// By bearing and model of cavitation.
    pub films: &'a [BearingFilm],
    /// Runs of crankshafts that float in their films.
    pub shafts: &'a [ShaftRun],
    /// What was assumed and left out.
    pub assumptions: &'a [String],
}

/// The chapter on oil films; `None` without a film.
pub fn films_section(input: &FilmsInput<'_>) -> Option<Section> {
    let least =
        input.films.iter().min_by(|a, b| a.orbit.least_anywhere().total_cmp(&b.orbit.least_anywhere()))?;
    Some(
        Section::new("oil-films", "Oil films", "Oil films of the bearings")
            .lead(least_words(input.speed, least))
            .rows(film_figures(input.period, input.films))
            .tables(std::iter::once(films_table(input.films)).chain(shaft_runs_table(input.shafts)))
            .paragraphs(input.assumptions.iter().map(|words| format!("{}.", number::capital(words)))),
    )
}

/// The sentence that matters most: the thinnest film, where, when, against what.
fn least_words(speed: f64, film: &BearingFilm) -> String {
    let rpm = number::terminal(number::rpm(speed), 0);
    let least = 1e6 * film.orbit.least_anywhere();
    let against = match film.roughness > 0.0 {
        true => format!(
            "; the roughness of both surfaces together is {} um",
            number::short(1e6 * film.roughness, 3)
        ),
        false => String::new(),
    };
    match film.orbit.outcome {
        OrbitOutcome::Overloaded => {
            format!("At {rpm} rpm the load of {} is more than its film carries.", bearing_name(film))
        }
        _ if film.orbit.least_anywhere() < film.orbit.least_film => format!(
            "At {rpm} rpm the thinnest film is {} um, at an end of {}, whose journal is tilted{against}.",
            number::short(least, 3),
            bearing_name(film),
        ),
        _ => format!(
            "At {rpm} rpm the thinnest film is {} um, in {} at {} deg of crank angle{against}.",
            number::short(least, 3),
            bearing_name(film),
            number::terminal(film.least_film_angle * 180.0 / PI, 0),
        ),
    }
}

/// The thinnest film of every model, then the table with what was assumed.
pub fn films_text(engine: &str, input: &FilmsInput<'_>) -> String {
    let FilmsInput { speed, films, shafts, assumptions, .. } = *input;
    let rpm = number::terminal(number::rpm(speed), 0);
    let mut out = format!("{engine} at {rpm} rpm: oil films\n\n");
    let mut models: Vec<Cavitation> = Vec::new();
    for film in films {
        if !models.contains(&film.cavitation) {
            models.push(film.cavitation);
        }
    }
    for model in models {
        let own = films.iter().filter(|film| film.cavitation == model);
        for film in own.clone().filter(|film| film.orbit.outcome == OrbitOutcome::Overloaded) {
            push_wrapped(&mut out, "", &format!("{}: {}", model.name(), least_words(speed, film)));
        }
        // Where one gives way, the others of its shaft have no whole orbit.
        let gives_way = own.clone().any(|film| film.orbit.outcome == OrbitOutcome::Overloaded);
        let own = own.filter(|film| !gives_way || film.orbit.outcome == OrbitOutcome::Periodic);
        if let Some(least) = own.min_by(|a, b| a.orbit.least_anywhere().total_cmp(&b.orbit.least_anywhere()))
        {
            push_wrapped(&mut out, "", &format!("{}: {}", model.name(), least_words(speed, least)));
        }
    }
    out.push('\n');
    out.push_str(&films_table(films).text());
    if let Some(table) = shaft_runs_table(shafts) {
        out.push('\n');
        out.push_str(&table.noted_text());
    }
    for assumption in assumptions {
        out.push('\n');
        push_wrapped(&mut out, "", assumption);
    }
    out
}

/// The orbit of every bearing over the crank angle, in the engine's frame and in that of the journal, whose x axis points along +x at crank angle 0, as CSV.
pub fn films_csv(period: f64, films: &[BearingFilm]) -> String {
    let mut out = String::from(
        "bearing,number,crankshaft,cavitation,crank_angle_deg,eccentricity_x_um,eccentricity_y_um,film_um,in_journal_x_um,in_journal_y_um\n",
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
            let (sin, cos) = (film.journal_turns * angle.to_radians()).sin_cos();
            let in_journal = [cos * e[0] + sin * e[1], cos * e[1] - sin * e[0]];
            out.push_str(&format!(
                "{kind},{},{},{},{angle:.4},{:.6},{:.6},{:.6},{:.6},{:.6}\n",
                film.number,
                film.crankshaft,
                film.cavitation.name(),
                1e6 * e[0],
                1e6 * e[1],
                1e6 * thickness,
                1e6 * in_journal[0],
                1e6 * in_journal[1]
            ));
        }
    }
    out
}
