//! Tables of a crankshaft over the cycle.

use super::result::{BearingCycle, CrankCycle, CrankKind, CycleRun, CycleSpeed};
use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::table::{Cell, Column, Table, csv_number, numbers, push_csv_line, words};
use crate::stress::fatigue::{FatigueMeasure, FilletFatigue};
use lanchester_film::BearingKind;
use lanchester_flex::train::CycleOutcome;

/// Largest number or nothing.
fn optional(value: Option<f64>, digits: i32) -> Cell {
    value.filter(|own| own.is_finite()).map_or(Cell::Empty, |own| Cell::number(own, digits))
}

fn power(value: Option<f64>) -> Cell {
    match value.filter(|own| own.is_finite()) {
        Some(value) => Cell::text(format!("{value:.1e}")),
        None => Cell::Empty,
    }
}

impl CrankCycle {
    fn column(&self, head: &str, unit: &'static str, of: impl Fn(&CycleRun) -> Cell) -> (Column, Vec<Cell>) {
        (Column::numbers(head, unit), self.runs.iter().map(of).collect())
    }

    fn runs_table(&self) -> Table {
        let film = |kind| {
            move |run: &CycleRun| optional(run.least_film(kind).map(|(_, film)| 1e6 * film.thickness), 3)
        };
        let load = |kind| {
            move |run: &CycleRun| optional(run.most_loaded(kind).map(|own| 1e-3 * own.largest_load), 4)
        };
        Table::of_columns(
            "cycle-runs",
            format!("Bearings side by side at {} rpm", number::terminal(number::rpm(self.speed), 0)),
            "Largest von Mises stress of all fillets and its crank angle; least film and largest load of all mains and of all big ends.",
            vec![
                words("bearings", self.runs.iter().map(CycleRun::name)),
                self.column("stress", "MPa", |run| optional(run.worst().map(|own| 1e-6 * own.peak), 4)),
                (
                    Column::words("fillet"),
                    self.runs
                        .iter()
                        .map(|run| Cell::text(run.worst().map_or(String::new(), |own| own.name.clone())))
                        .collect(),
                ),
                self.column("at", "deg", |run| {
                    optional(run.worst().map(|own| run.critical_angle(own).to_degrees()), 4)
                }),
                self.column("film, mains", "um", film(BearingKind::Main)),
                self.column("film, big ends", "um", film(BearingKind::Crankpin)),
                self.column("load, mains", "kN", load(BearingKind::Main)),
                self.column("load, big ends", "kN", load(BearingKind::Crankpin)),
            ],
        )
    }

    fn checks_table(&self) -> Table {
        Table::of_columns(
            "cycle-checks",
            "How the cycles ended",
            "Changes: of orbits over the clearance, of loads and deformation over their largest, from the last cycle but one. Energy: what is missing of work of gas and flywheel less \
             losses in material and bearings less change of kinetic and elastic energy, over the sum of the sizes of all powers.",
            vec![
                words("bearings", self.runs.iter().map(CycleRun::name)),
                words("cycles", self.runs.iter().map(CycleRun::outcome_words)),
                self.column("run", "", |run| Cell::Number { value: run.cycles as f64, decimals: 0 }),
                self.column("orbits change", "", |run| power(run.orbit_change)),
                self.column("loads change", "", |run| power(run.stress_change)),
                self.column("gas", "J", |run| Cell::number(run.energy.gas, 5)),
                self.column("flywheel", "J", |run| Cell::number(run.energy.drive, 5)),
                self.column("material", "J", |run| Cell::number(run.energy.damping, 3)),
                self.column("in bearings", "J", |run| Cell::number(run.energy.bearings, 3)),
                self.column("energy missing", "", |run| power(Some(run.energy_error))),
                self.column("steps", "", |run| Cell::Number { value: run.steps as f64, decimals: 0 }),
            ],
        )
    }

    /// Runs with stress.
    fn stressed(&self) -> Vec<&CycleRun> {
        self.runs.iter().filter(|run| !run.fillets.is_empty()).collect()
    }

    fn fillets_table(&self) -> Option<Table> {
        let runs = self.stressed();
        let first = runs.first()?;
        let mut columns = vec![words("fillet", first.fillets.iter().map(|own| own.name.clone()))];
        for run in &runs {
            let peaks = run.fillets.iter().map(|own| 1e-6 * own.peak);
            columns.push(numbers(&run.name(), "MPa", peaks, 4));
            let angles = run.fillets.iter().map(|own| run.critical_angle(own).to_degrees());
            columns.push(numbers("at", "deg", angles, 4));
        }
        Some(Table::of_columns(
            "cycle-fillets",
            "Largest stress of every fillet over the cycle",
            "Von Mises stress and the crank angle at which it is largest, by law of the bearings.",
            columns,
        ))
    }

    fn fatigue_table(&self) -> Option<Table> {
        let runs: Vec<&CycleRun> = self.runs.iter().filter(|run| !run.fatigue.is_empty()).collect();
        let rows = || runs.iter().flat_map(|run| run.fatigue.iter().map(move |own| (*run, own)));
        rows().next()?;
        let column = |head: &str, unit, digits, of: fn(&FilletFatigue) -> f64| {
            numbers(head, unit, rows().map(|(_, own)| of(own)), digits)
        };
        let safety = |head: &str, of: fn(&FilletFatigue) -> Option<f64>| {
            let cells = rows().map(|(_, own)| of(own).map_or(Cell::Empty, |own| Cell::number(own, 3)));
            (Column::numbers(head, "1"), cells.collect::<Vec<_>>())
        };
        Some(Table::of_columns(
            "cycle-fatigue",
            "Safety of every fillet against fatigue over the cycle",
            "Findley's criterion at the worst node of each fillet; shear amplitude and largest normal stress on its worst plane, crank angle of the latter. Safety of all: all stress \
             scaled; of amplitude: its mean over the cycle stays.",
            vec![
                words("bearings", rows().map(|(run, _)| run.name())),
                words("fillet", rows().map(|(_, own)| own.name.clone())),
                safety("safety of all", |own| own.point.safety_of_all),
                safety("of amplitude", |own| own.point.safety_of_amplitude),
                column("shear", "MPa", 4, |own| 1e-6 * own.point.plane.shear),
                column("normal", "MPa", 4, |own| 1e-6 * own.point.plane.normal_stress),
                column("Findley", "MPa", 4, |own| 1e-6 * own.point.plane.value),
                column("crank angle", "deg", 4, |own| own.critical_angle.to_degrees()),
            ],
        ))
    }

    fn mains_table(&self) -> Option<Table> {
        let first = self.runs.iter().find(|run| !run.bearings.is_empty())?;
        let mains: Vec<&BearingCycle> =
            first.bearings.iter().filter(|own| own.kind == BearingKind::Main).collect();
        let mut columns = vec![
            words("bearing", mains.iter().map(|own| own.name())),
            numbers("z", "mm", mains.iter().map(|own| 1e3 * own.z), 4),
        ];
        for run in self.runs.iter().filter(|run| run.bearings.len() == first.bearings.len()) {
            let loads = run.bearings.iter().take(mains.len()).map(|own| 1e-3 * own.largest_load);
            columns.push(numbers(&run.name(), "kN", loads, 4));
        }
        if let Some(rules) = &self.rules {
            for (rule, name) in rules.names.iter().enumerate() {
                let loads = (0..mains.len()).map(|main| 1e-3 * rules.peak(main, rule));
                columns.push(numbers(&format!("rule: {name}"), "kN", loads, 4));
            }
        }
        Some(Table::of_columns(
            "cycle-mains",
            "Largest loads of the main bearings",
            "By law of the bearings, shared out by stiffness; behind them a rigid crankshaft at constant speed by the three rules of the simulation: cut at every main, on equal springs, \
             uniform beam.",
            columns,
        ))
    }

    fn films_table(&self) -> Option<Table> {
        let rows: Vec<(&CycleRun, &BearingCycle)> = self
            .runs
            .iter()
            .flat_map(|run| run.bearings.iter().map(move |own| (run, own)))
            .filter(|(_, own)| own.film.is_some())
            .collect();
        if rows.is_empty() {
            return None;
        }
        let film = |head: &str, unit, digits, of: fn(&super::result::LeastFilm) -> Option<f64>| {
            let cells = rows.iter().map(|(_, own)| optional(own.film.as_ref().and_then(of), digits));
            (Column::numbers(head, unit), cells.collect::<Vec<_>>())
        };
        Some(Table::of_columns(
            "cycle-films",
            "Oil films",
            "Least thickness in the middle of each bearing (of films that feel the tilt, at its ends), its crank angle, least thickness at its ends with the slope of the journal (below 0: \
             the slope is more than a parallel film can tell of, and in films that feel the tilt the surfaces touch), share of the cycle with less than three times the roughness, largest pressure by the film solved directly, and the least film of a rigid crankshaft cut at every \
             main, quasi-static.",
            vec![
                words("crankshaft", rows.iter().map(|(run, _)| run.name())),
                words("bearing", rows.iter().map(|(_, own)| own.name())),
                film("least film", "um", 3, |own| Some(1e6 * own.thickness)),
                film("at", "deg", 4, |own| Some(own.theta.to_degrees())),
                film("at its ends", "um", 3, |own| Some(1e6 * own.at_ends)),
                film("rough", "%", 2, |own| Some(100.0 * own.below_roughness)),
                film("pressure", "MPa", 3, |own| own.largest_pressure.map(|[p, _]| 1e-6 * p)),
                film("quasi-static", "um", 3, |own| own.quasi_static.map(|film| 1e6 * film)),
                film("viscosity", "mPa s", 3, |own| Some(1e3 * own.viscosity)),
            ],
        ))
    }

    fn bearings_table(&self) -> Option<Table> {
        let rows: Vec<(&CycleRun, &BearingCycle)> =
            self.runs.iter().flat_map(|run| run.bearings.iter().map(move |own| (run, own))).collect();
        if rows.is_empty() {
            return None;
        }
        let bearings = || rows.iter().map(|(_, own)| own);
        Some(Table::of_columns(
            "cycle-bearings",
            "Loads and orbits of all bearings",
            "Load of journal or pin on its bearing; eccentricity: largest distance of the centres.",
            vec![
                words("bearings", rows.iter().map(|(run, _)| run.name())),
                words("bearing", bearings().map(|own| own.name())),
                numbers("largest load", "kN", bearings().map(|own| 1e-3 * own.largest_load), 4),
                numbers("at", "deg", bearings().map(|own| own.largest_load_angle.to_degrees()), 4),
                numbers("mean", "kN", bearings().map(|own| 1e-3 * own.mean_load), 4),
                numbers("eccentricity", "um", bearings().map(|own| 1e6 * own.largest_eccentricity), 3),
                words("law", bearings().map(|own| own.law.clone())),
            ],
        ))
    }

    /// All tables.
    pub fn tables(&self) -> Vec<Table> {
        let mut tables = vec![self.runs_table()];
        tables.extend(self.fillets_table());
        tables.extend(self.fatigue_table());
        tables.extend(self.mains_table());
        tables.extend(self.films_table());
        tables.extend(self.bearings_table());
        tables.push(self.checks_table());
        tables
    }

    pub(crate) fn lead(&self) -> String {
        let unsound: Vec<String> = self
            .runs
            .iter()
            .filter(|run| !run.is_sound())
            .map(|run| {
                let why = match run.outcome {
                    CycleOutcome::Periodic | CycleOutcome::NotPeriodic => match run.unsettled_speed() {
                        None => "leaves energies unbalanced".to_owned(),
                        Some(change) => format!(
                            "has not found its speed in {} cycles (last change {:.2} % of its swing)",
                            run.cycles,
                            100.0 * change
                        ),
                    },
                    _ => run.outcome_words(),
                };
                format!("{} bearings: the run {why}", run.name())
            })
            .collect();
        let unsound = match &unsound[..] {
            [] => String::new(),
            all => format!(" Not counted here: {}.", all.join("; ")),
        };
        let counted = self.counted();
        if counted.is_empty() {
            return format!("No run has a sound end.{unsound}");
        }
        let worst = counted.into_iter().filter_map(|run| Some((run, run.worst()?)));
        let Some((run, fillet)) = worst.max_by(|a, b| a.1.peak.total_cmp(&b.1.peak)) else {
            return format!("No fillet has a stress: loads and orbits alone.{unsound}");
        };
        let mut out = format!(
            "Largest fillet stress over the cycle {} MPa (von Mises) at {}, crank angle {} deg, with {} bearings.",
            number::short(1e-6 * fillet.peak, 4),
            fillet.name,
            number::short(run.critical_angle(fillet).to_degrees(), 4),
            run.name()
        );
        if let Some(safety) = self.static_safety() {
            out.push_str(&format!(" Yield strength over it: {}.", number::short(safety, 3)));
        }
        if let Some((run, fillet)) = self.most_fatigued() {
            let safety = |own: Option<f64>| own.map_or("unlimited".to_owned(), |own| number::short(own, 3));
            out.push_str(&format!(
                " Least safety against fatigue {} (of the amplitude alone {}) at {}, with {} bearings.",
                safety(fillet.point.safety_of_all),
                safety(fillet.point.safety_of_amplitude),
                fillet.name,
                run.name()
            ));
        }
        if let Some(film) = self.least_film() {
            out.push_str(&format!(" Least film {} um.", number::short(1e6 * film, 3)));
        }
        if let Some((name, film)) = self.touching_ends() {
            let at_ends = number::short(1e6 * film.at_ends, 3);
            out.push_str(&match film.is_tilted {
                true => format!(
                    " At the ends of {name} the journal touches its shell ({at_ends} um), which roughness alone carries: film and load of that bearing are rough there."
                ),
                false => format!(
                    " At the ends of {name} the journal leans through it: {at_ends} um, so that the least film is not one to go by; films that feel the tilt tell one."
                ),
            });
        }
        out.push_str(&unsound);
        // The headline is what is read: what it is worth belongs to it.
        out.extend(self.ringing.iter().map(|words| format!(" {words}")));
        out
    }

    fn words(&self) -> Vec<String> {
        let mut words = vec![format!("Gas: {}.", self.gas.as_deref().unwrap_or("none"))];
        if let Some([first, second, ..]) = self.runs.first().map(|run| run.theta.as_slice()) {
            let step = number::short((second - first).to_degrees(), 3);
            words.push(format!(
                "Largest loads and stresses are those at steps of {step} deg: beside a jump of the pressure they depend on where the steps lie."
            ));
        }
        words.push(match self.motion {
            CycleSpeed::Constant => "The flywheel turns at constant speed.".to_owned(),
            CycleSpeed::Free => {
                "The flywheel turns as gas, inertia and a constant load make it: its speed fluctuates."
                    .to_owned()
            }
        });
        words.extend(self.sheet.words());
        let highest = self
            .frequencies
            .last()
            .map_or(String::new(), |last| format!(", up to {} Hz", number::short(*last, 4)));
        words.push(format!(
            "{} coordinates of the crankshaft: its motions as a rigid body, {} natural modes{highest}, and the static shapes of all bearings; stress at {} nodes of fillets.",
            self.coordinates,
            self.frequencies.len(),
            number::whole(self.stress_nodes as u128),
        ));
        for run in self.runs.iter().filter(|run| run.crank == CrankKind::Flexible) {
            if let Some(free) = run.free_speed {
                words.push(format!(
                    "Free speed, {} bearings: {} to {} rpm under a constant load of {} N m; the last cycle changed it by {:.1e} of its swing.",
                    run.name(),
                    number::terminal(number::rpm(run.speed.iter().copied().fold(f64::INFINITY, f64::min)), 1),
                    number::terminal(number::rpm(run.speed.iter().copied().fold(0.0, f64::max)), 1),
                    number::short(-free.load, 4),
                    free.change
                ));
            }
        }
        words.extend(self.fatigue.iter().map(FatigueMeasure::words));
        words.extend(self.notes.iter().cloned());
        words
    }
}

impl CrankCycle {
    /// All curves over the crank angle as rows: heads with units, then law and numbers of every instant.
    pub fn traces(&self) -> (Vec<String>, Vec<(String, Vec<f64>)>) {
        traces(self)
    }
}

/// Everything as plain text.
pub fn cycle_text(found: &CrankCycle) -> String {
    let mut out = format!(
        "{}, crankshaft {} in its bearings over the cycle\n\n",
        found.sheet.engine, found.sheet.crankshaft
    );
    push_wrapped(&mut out, "", &found.lead());
    for table in found.tables() {
        out.push('\n');
        out.push_str(&table.noted_text());
    }
    out.push('\n');
    for words in found.words() {
        push_wrapped(&mut out, "", &words);
    }
    out
}

/// Peaks of every fillet and bearing by law as CSV, unrounded.
pub fn cycle_csv(found: &CrankCycle) -> String {
    let mut out = String::new();
    let head = ["bearings", "place", "quantity", "value", "unit", "crank angle [deg]"];
    push_csv_line(&mut out, head.map(str::to_owned));
    let mut line =
        |run: &CycleRun, place: &str, quantity: &str, value: f64, unit: &str, angle: Option<f64>| {
            push_csv_line(
                &mut out,
                [
                    run.name(),
                    place.to_owned(),
                    quantity.to_owned(),
                    csv_number(value),
                    unit.to_owned(),
                    angle.map_or(String::new(), |own| csv_number(own.to_degrees())),
                ],
            );
        };
    for run in &found.runs {
        for fillet in &run.fillets {
            let angle = run.critical_angle(fillet);
            line(run, &fillet.name, "von Mises", 1e-6 * fillet.peak, "MPa", Some(angle));
        }
        for fillet in &run.fatigue {
            let (angle, point) = (Some(fillet.critical_angle), &fillet.point);
            line(run, &fillet.name, "Findley", 1e-6 * point.plane.value, "MPa", angle);
            let safeties =
                [("safety of all", point.safety_of_all), ("safety of amplitude", point.safety_of_amplitude)];
            for (quantity, safety) in safeties {
                if let Some(safety) = safety {
                    line(run, &fillet.name, quantity, safety, "1", None);
                }
            }
        }
        for own in &run.bearings {
            let name = own.name();
            line(run, &name, "largest load", own.largest_load, "N", Some(own.largest_load_angle));
            line(run, &name, "mean load", own.mean_load, "N", None);
            line(run, &name, "largest eccentricity", 1e6 * own.largest_eccentricity, "um", None);
            if let Some(film) = &own.film {
                line(run, &name, "least film", 1e6 * film.thickness, "um", Some(film.theta));
                line(run, &name, "least film at its ends", 1e6 * film.at_ends, "um", None);
                if let Some([pressure, theta]) = film.largest_pressure {
                    line(run, &name, "largest pressure", 1e-6 * pressure, "MPa", Some(theta));
                }
            }
        }
        line(run, "all", "energy missing", run.energy_error, "1", None);
    }
    out
}

/// Heads and columns of the curves over the crank angle: law, angle, speed, torque, loads, orbits, stress of every fillet. Words of the first column, then numbers.
fn traces(found: &CrankCycle) -> (Vec<String>, Vec<(String, Vec<f64>)>) {
    let Some(first) = found.runs.iter().find(|run| !run.bearings.is_empty()) else {
        return (vec!["bearings".to_owned()], Vec::new());
    };
    let mut heads: Vec<String> =
        ["bearings", "crank angle [deg]", "speed [rpm]", "torque of the flywheel [N m]"]
            .map(str::to_owned)
            .into();
    for own in &first.bearings {
        let name = own.name();
        heads.extend([
            format!("{name} load x [N]"),
            format!("{name} load y [N]"),
            format!("{name} orbit x [um]"),
            format!("{name} orbit y [um]"),
        ]);
    }
    let fillets: Vec<String> = found
        .stressed()
        .first()
        .map_or(Vec::new(), |run| run.fillets.iter().map(|own| own.name.clone()).collect());
    heads.extend(fillets.iter().map(|name| format!("{name} von Mises [MPa]")));
    let mut rows = Vec::new();
    for run in &found.runs {
        for (k, theta) in run.theta.iter().enumerate() {
            let mut row = vec![theta.to_degrees(), number::rpm(run.speed[k]), run.torque[k]];
            for own in &run.bearings {
                // The last recorded cycle.
                let orbit = own.orbit[own.orbit.len() - run.theta.len() + k];
                row.extend([own.load[k][0], own.load[k][1], 1e6 * orbit[0], 1e6 * orbit[1]]);
            }
            match run.fillets.is_empty() {
                true => row.extend(fillets.iter().map(|_| f64::NAN)),
                false => row.extend(run.fillets.iter().map(|own| 1e-6 * own.over_cycle[k])),
            }
            rows.push((run.name(), row));
        }
    }
    (heads, rows)
}
