//! What gas and inertia do to the crank: torque, bearings, oil films.

use crate::answer::{Data, Shown};
use crate::failure::Failure;
use crate::options::Options;
use crate::prepared::Prepared;
use crate::question::{How, Question, Run};
use lanchester::film::Cavitation;
use lanchester::mechanism::{BearingLoads, BearingPart, BearingRequest, Lever, TorqueRequest};
use lanchester::model::Friction;
use lanchester::report::{
    Figure, Table, bearing_figures, bearing_parts_table, bearings_text, cycle_angle_table, cycle_figures,
    cycle_table, cylinder_work_table, film_figures, films_table, films_text, firing_table, flywheel_table,
    main_bearings_table, power_figure, power_table, ripple_figure, ripple_table, rod_bearings_tables,
    shaft_runs_table, stroke_table, torque_extremes_table, torque_figures, torque_orders_table,
    torque_speeds_table, torque_table, torque_text,
};
use lanchester::{
    BearingFilms, FilmMethod, TorqueReport, TorqueReportRequest, bearing_films, bearing_report,
    bearing_sizes, torque_report,
};
use schemars::JsonSchema;
use serde::Serialize;

pub(super) const QUESTIONS: [Question; 3] = [
    Question::of::<TorqueReport>("torque", How::Long, read_torque),
    Question::of::<Bearings>("bearings", How::Long, read_bearings),
    Question::of::<BearingFilms>("films", How::Long, read_films),
];

fn read_torque(options: &Options<'_>) -> Result<Run, Failure> {
    let usual = TorqueRequest::default();
    let lever = options.word("lever", &[("exact", Lever::Exact), ("sine", Lever::Sine)])?;
    let request = TorqueReportRequest {
        simulation: None,
        torque: TorqueRequest {
            speed: options.speed("speed")?,
            lever: lever.unwrap_or(usual.lever),
            max_order: options.whole("orders", 1, 1000)?.map_or(usual.max_order, |orders| orders as u32),
            samples: options.whole("samples", 8, 100_000)?.map_or(usual.samples, |count| count as usize),
            ..usual
        },
        speeds: options.speeds("speeds")?,
        friction: options.pressure("fmep")?.map(|fmep| Friction::Given { fmep }),
        flywheel: options.inertia("flywheel")?,
        crankshaft: options.inertia("crankshaft_inertia")?,
        fluctuation: options.share("fluctuation")?,
    };
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let request =
            TorqueReportRequest { simulation: own.file.tasks.simulation.clone(), ..request.clone() };
        let found = torque_report(own.engine(), own.traces()?, &request).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| text(found),
                tables: |found, _| tables(found),
                figures: |found, _| figures(found),
                ..Shown::default()
            },
        ))
    }))
}

fn text(found: &TorqueReport) -> String {
    let mut out = torque_text(&found.torque, found.brake.as_ref());
    for table in further_tables(found) {
        out.push('\n');
        out.push_str(&table.text());
    }
    if found.torque.with_gas { out + &format!("\nPressures: {}.\n", found.source) } else { out }
}

fn further_tables(found: &TorqueReport) -> Vec<Table> {
    let tables = [
        (!found.cycles.is_empty()).then(|| cycle_table(&found.cycles)),
        Some(ripple_table(&found.ripples)),
        found.flywheel.as_ref().map(flywheel_table),
        (!found.speeds.is_empty()).then(|| torque_speeds_table(&found.speeds)),
        found.power.as_ref().map(power_table),
    ];
    tables.into_iter().flatten().collect()
}

fn tables(found: &TorqueReport) -> Vec<Table> {
    let torque = &found.torque;
    let mut tables = vec![
        torque_table(torque, found.brake.as_ref()),
        torque_extremes_table(torque),
        torque_orders_table(torque),
        cylinder_work_table(torque),
    ];
    tables.extend([firing_table(&torque.firing), stroke_table(&torque.firing)]);
    tables.extend(further_tables(found));
    if !found.cycles.is_empty() {
        tables.push(cycle_angle_table(&found.cycles));
    }
    tables
}

fn figures(found: &TorqueReport) -> Vec<Figure> {
    let mut figures = torque_figures(&found.torque);
    if !found.cycles.is_empty() {
        figures.extend(cycle_figures(&found.cycles));
    }
    figures.extend(ripple_figure(&found.ripples));
    figures.extend(found.power.as_ref().map(power_figure));
    figures
}

/// Loads of the bearings with counterweights, and without where the engine has some.
#[derive(Debug, Serialize, JsonSchema)]
struct Bearings {
    #[serde(flatten)]
    loads: BearingLoads,
    /// The same without counterweights.
    without_counterweights: Option<BearingLoads>,
}

/// Which loads count: those that are asked for, else all that the engine has.
fn part(options: &Options<'_>) -> Result<Option<BearingPart>, Failure> {
    let words = [("all", BearingPart::All), ("gas", BearingPart::Gas), ("inertia", BearingPart::Inertia)];
    options.word("part", &words)
}

fn part_of(own: &Prepared, asked: Option<BearingPart>) -> Result<BearingPart, Failure> {
    match (own.engine().gas.is_some(), asked) {
        (false, Some(BearingPart::Gas)) => Err(Failure::option(
            "the engine file says nothing of the gas",
            "add [gas] with [[gas.trace]] or [gas.cycle]",
        )),
        (false, _) => Ok(BearingPart::Inertia),
        (true, part) => Ok(part.unwrap_or(BearingPart::All)),
    }
}

fn bearing_samples(options: &Options<'_>) -> Result<usize, Failure> {
    Ok(options.whole("samples", 8, 100_000)?.map_or(360, |count| count as usize))
}

fn read_bearings(options: &Options<'_>) -> Result<Run, Failure> {
    let (speed, asked, samples) = (options.speed("speed")?, part(options)?, bearing_samples(options)?);
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let part = part_of(own, asked)?;
        let traces = own.traces()?;
        let loads = |counterweights| {
            let request = BearingRequest { speed, part, counterweights, samples };
            bearing_report(own.engine(), traces, &request).map_err(Failure::refused)
        };
        let heavy = own.engine().counterweights.iter().any(|weight| weight.unbalance > 0.0);
        let bare = if heavy && part != BearingPart::Gas { Some(loads(false)?) } else { None };
        let found = Bearings { loads: loads(true)?, without_counterweights: bare };
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, engine| {
                    let bare = found.without_counterweights.as_ref();
                    bearings_text(
                        &found.loads,
                        std::slice::from_ref(&found.loads),
                        bare,
                        bearing_sizes(engine),
                    )
                },
                tables: |found, engine| {
                    let sizes = bearing_sizes(engine);
                    let bare = found.without_counterweights.as_ref();
                    let mut tables = rod_bearings_tables(&found.loads, sizes);
                    tables.push(main_bearings_table(&found.loads, bare, sizes));
                    tables.push(bearing_parts_table(std::slice::from_ref(&found.loads)));
                    tables
                },
                figures: |found, _| bearing_figures(std::slice::from_ref(&found.loads)),
                ..Shown::default()
            },
        ))
    }))
}

fn read_films(options: &Options<'_>) -> Result<Run, Failure> {
    let (speed, asked, samples) = (options.speed("speed")?, part(options)?, bearing_samples(options)?);
    let words = Cavitation::ALL.map(|model| (model.name(), model));
    let models = options.words("cavitation", &words)?;
    let asked_for = options.flag("grooves")?.unwrap_or(models.contains(&Cavitation::MassConserving));
    let method = match (options.flag("dynamic")?.unwrap_or(false), asked_for) {
        (true, true) => {
            return Err(Failure::option(
                "`dynamic` moves the crankshaft by tables of films, which have no grooves and are not mass-conserving",
                "leave out one of them",
            ));
        }
        (true, false) => FilmMethod::RigidShaft,
        (false, true) => FilmMethod::Grooved,
        (false, false) => FilmMethod::Tables,
    };
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let request = BearingRequest { speed, part: part_of(own, asked)?, counterweights: true, samples };
        let loads = bearing_report(own.engine(), own.traces()?, &request).map_err(Failure::refused)?;
        let found = bearing_films(own.engine(), &loads, &models, method).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| films_text(&found.engine, &found.input()),
                tables: |found, _| {
                    std::iter::once(films_table(&found.films))
                        .chain(shaft_runs_table(&found.shafts))
                        .collect()
                },
                figures: |found, _| film_figures(found.period, &found.films),
                ..Shown::default()
            },
        ))
    }))
}
