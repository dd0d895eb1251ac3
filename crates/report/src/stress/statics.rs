//! Static stress of a crankshaft: its tables.

use super::body::CrankSheet;
use super::convergence::Convergence;
use super::submodel::StressSubmodel;
use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::section::Section;
use crate::kit::table::{Cell, Column, Table, csv_number, numbers, push_csv_line, words};
use lanchester_flex::bytes_words;
use lanchester_flex::crank_case::{CrankCase, CrankLoad, SurfacePeak};
use lanchester_flex::journal_in_film::JournalInFilm;
use lanchester_flex::sparse::SolveReport;
use serde::Serialize;
use std::collections::BTreeSet;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const STATIC_STRESS_VERSION: u32 = 2;

/// Static stress of a crankshaft under several loads.
///
/// Linear, elastic, small displacements; loads as pressure over 180 degrees of the pins; constant speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StaticStress {
    /// [`STATIC_STRESS_VERSION`].
    pub version: u32,
    /// What was meshed.
    pub sheet: CrankSheet,
    /// What holds it, in words.
    pub support: String,
    /// Where the pressures come from, in words; `None`: no gas acts.
    pub gas: Option<String>,
    /// How the equations were solved.
    pub solve: SolveReport,
    /// The load cases.
    pub cases: Vec<StressCase>,
    /// With three meshes: what the numbers tend to; the cases are those of the finest.
    pub convergence: Option<Convergence>,
    /// One bay again, on a finer mesh.
    pub submodel: Option<StressSubmodel>,
    /// What was assumed and left out.
    pub notes: Vec<String>,
}

/// Force on a pin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PinForces {
    /// Number of the pin, from 1.
    pub pin: usize,
    /// Along the throw, positive away from the crank axis [N].
    pub radial: f64,
    /// Across it, positive where it drives the crankshaft [N].
    pub tangential: f64,
}

/// One load case.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StressCase {
    /// Its name.
    pub name: String,
    /// Crank angle [rad]; `None`: forces were given.
    pub theta: Option<f64>,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Forces on the pins.
    pub forces: Vec<PinForces>,
    /// Elastic energy of crankshaft and supports [J].
    pub energy: f64,
    /// Sum of all loads, in the frame that turns with the crankshaft [N].
    pub load: [f64; 3],
    /// Sum of what the supports exert on it [N].
    pub reaction: [f64; 3],
    /// What loads the crankshaft, in the frame that turns with it.
    pub loading: CrankLoad,
    /// Displacements and peaks; the fields themselves are not serialised.
    pub result: CrankCase,
}

impl StressCase {
    /// The fillet with the largest von Mises stress.
    pub fn worst(&self) -> Option<&SurfacePeak> {
        let value = |peak: &SurfacePeak| peak.stress.map_or(f64::NEG_INFINITY, |stress| stress.von_mises);
        let sharpless = self.result.peaks.iter().filter(|peak| peak.stress.is_some());
        sharpless.max_by(|a, b| value(a).total_cmp(&value(b)))
    }
}

impl StaticStress {
    /// The case with the largest stress in a fillet.
    pub fn worst(&self) -> Option<&StressCase> {
        let value = |case: &StressCase| {
            case.worst().and_then(|peak| peak.stress).map_or(0.0, |stress| stress.von_mises)
        };
        self.cases.iter().max_by(|a, b| value(a).total_cmp(&value(b)))
    }

    /// Yield strength over a stress.
    pub fn safety(&self, von_mises: f64) -> Option<f64> {
        self.sheet.material.yield_strength.map(|strength| strength.value / von_mises)
    }

    /// Yield strength over the largest stress of any fillet and case, of the whole and of the submodel; `None` where either is not known.
    pub fn least_safety(&self) -> Option<f64> {
        let of_whole = self.worst()?.worst()?.stress?.von_mises;
        let of_bay =
            self.submodel.as_ref().and_then(|own| own.worst()).map_or(0.0, |own| own.stress.von_mises);
        self.safety(of_whole.max(of_bay))
    }

    /// The sentences that matter most.
    pub(crate) fn lead(&self) -> String {
        let submodel = self.submodel.as_ref().and_then(|own| own.lead(|stress| self.safety_words(stress)));
        match submodel {
            Some(words) => format!("{} {words}", self.whole_lead()),
            None => self.whole_lead(),
        }
    }

    /// ", 1.4 times below yield"; nothing where the strength is not known.
    fn safety_words(&self, von_mises: f64) -> String {
        let safety = self.safety(von_mises);
        match safety {
            Some(safety) if safety < 1.0 => {
                let over = number::short(1.0 / safety, 3);
                format!(", {over} times the yield strength, beyond which a linear result no longer holds")
            }
            Some(safety) => format!(", {} times below yield", number::short(safety, 3)),
            None => String::new(),
        }
    }

    fn whole_lead(&self) -> String {
        let Some((case, peak, stress)) =
            self.worst().and_then(|case| case.worst().and_then(|peak| Some((case, peak, peak.stress?))))
        else {
            return "No fillet has a stress.".to_owned();
        };
        let safety = self.safety_words(stress.von_mises);
        let force = |own: &PinForces| {
            let [radial, tangential] = [own.radial, own.tangential].map(|f| number::short(1e-3 * f, 4));
            format!("pin {} {radial} and {tangential} kN", own.pin)
        };
        let forces: Vec<String> = case.forces.iter().map(force).collect();
        // With three meshes: what the peak tends to, and its band.
        let studied = self.convergence.as_ref().and_then(|study| {
            let own = study.numbers.iter().find(|own| own.name.starts_with(&format!("{}:", peak.name)))?;
            Some(format!(
                "{} ± {}",
                number::short(1e-6 * own.found.value, 4),
                number::short(1e-6 * own.found.band, 2)
            ))
        });
        let what = if self.sheet.own_file.is_some() { "Largest stress" } else { "Largest fillet stress" };
        format!(
            "{what} {} MPa (von Mises) at {}{safety}: {} (radial and tangential: {}).",
            studied.unwrap_or_else(|| number::short(1e-6 * stress.von_mises, 4)),
            peak.name,
            case.name,
            forces.join(", "),
        ) + &coarse_words(stress.jump, self.convergence.is_some())
    }

    /// The load cases.
    pub(crate) fn cases_table(&self) -> Table {
        let cases = &self.cases;
        let von_mises = |case: &StressCase| case.worst().and_then(|peak| peak.stress).map(|s| s.von_mises);
        let mut columns = vec![
            (
                Column::numbers("case", ""),
                (1..=cases.len()).map(|k| Cell::Number { value: k as f64, decimals: 0 }).collect(),
            ),
            words("loads", cases.iter().map(|case| case.name.clone())),
            (
                Column::numbers("angle", "deg"),
                cases
                    .iter()
                    .map(|case| {
                        case.theta.map_or(Cell::Empty, |theta| Cell::Number {
                            value: theta.to_degrees(),
                            decimals: 1,
                        })
                    })
                    .collect(),
            ),
            numbers("displacement", "mm", cases.iter().map(|c| 1e3 * c.result.largest_displacement), 4),
            numbers("energy", "J", cases.iter().map(|case| case.energy), 5),
            numbers(
                "fillet stress",
                "MPa",
                cases.iter().map(|case| von_mises(case).map_or(f64::NAN, |s| 1e-6 * s)),
                4,
            ),
            words(
                "at",
                cases.iter().map(|case| case.worst().map_or(String::new(), |peak| peak.name.clone())),
            ),
        ];
        if self.sheet.material.yield_strength.is_some() {
            let safety = |case: &StressCase| von_mises(case).and_then(|s| self.safety(s)).unwrap_or(f64::NAN);
            columns.push(numbers("safety", "1", cases.iter().map(safety), 3));
        }
        Table::of_columns(
            "stress-cases",
            "Load cases",
            "Largest displacement of the crankshaft and largest von Mises stress of all fillets; safety: yield strength over it.",
            columns,
        )
    }

    /// Each fillet under the case that stresses it most.
    pub(crate) fn fillets_table(&self) -> Table {
        let count = self.cases.first().map_or(0, |case| case.result.peaks.len());
        let most = |k: usize| {
            let of = |case: &StressCase| case.result.peaks[k].stress.map_or(-1.0, |stress| stress.von_mises);
            self.cases.iter().enumerate().max_by(|a, b| of(a.1).total_cmp(&of(b.1)))
        };
        let rows = (0..count).map(|k| {
            let corner = &self.sheet.crank.corners[k];
            let name = Cell::text(corner.name.clone());
            // Sets of a mesh from elsewhere have no radius of their own.
            let radius = match &self.sheet.own_file {
                Some(_) => Cell::Empty,
                None => Cell::number(1e3 * corner.radius, 3),
            };
            let found = most(k).and_then(|(index, case)| Some((index, case.result.peaks[k].stress?)));
            let Some((index, stress)) = found else {
                let name = Cell::text(format!("{} (sharp: stress unbounded)", corner.name));
                return vec![name, radius, Cell::Empty, Cell::Empty, Cell::Empty, Cell::Empty, Cell::Empty];
            };
            vec![
                name,
                radius,
                Cell::Number { value: 1e-6 * stress.von_mises, decimals: 1 },
                Cell::Number { value: 1e-6 * stress.principal, decimals: 1 },
                Cell::Number { value: 100.0 * stress.jump, decimals: 1 },
                Cell::Number { value: stress.angle.to_degrees(), decimals: 0 },
                Cell::Number { value: (index + 1) as f64, decimals: 0 },
            ]
        });
        Table {
            id: "stress-fillets",
            title: "Fillets".into(),
            note: "Largest stress of each fillet over all cases. Principal: the principal stress of the largest size there, tension \
                   positive. Jump: how far elements that meet at a node of the fillet differ, at most in the elements about that place, over its \
                   stress: a sign of the error. Angle about the middle of the pin or journal, from throw 1."
                .into(),
            remark: String::new(),
            columns: vec![
                Column::words("fillet"),
                Column::numbers("radius", "mm"),
                Column::numbers("von Mises", "MPa"),
                Column::numbers("principal", "MPa"),
                Column::numbers("jump", "%"),
                Column::numbers("angle", "deg"),
                Column::numbers("case", ""),
            ],
            rows: rows.collect(),
        }
    }

    /// Surfaces of pins and journals between their fillets, and webs.
    pub(crate) fn surfaces_table(&self) -> Table {
        let of = |case: &StressCase| -> Vec<SurfacePeak> {
            case.result.surfaces.iter().chain(&case.result.webs).cloned().collect()
        };
        let each: Vec<Vec<SurfacePeak>> = self.cases.iter().map(of).collect();
        let count = each.first().map_or(0, Vec::len);
        let most = |k: usize| {
            let of = |peaks: &Vec<SurfacePeak>| peaks[k].stress.map_or(-1.0, |stress| stress.von_mises);
            each.iter().enumerate().max_by(|a, b| of(a.1).total_cmp(&of(b.1)))
        };
        let found: Vec<(String, f64, usize)> = (0..count)
            .filter_map(|k| {
                let (index, peaks) = most(k)?;
                let peak = &peaks[k];
                let name = peak.name.replace("PIN_", "pin ").replace("MAIN_", "journal ");
                Some((name, 1e-6 * peak.stress?.von_mises, index + 1))
            })
            .collect();
        Table::of_columns(
            "stress-surfaces",
            "Surfaces of pins and journals, webs",
            "Largest von Mises stress: of pins and journals between the fillets, the pressure of the load included; of webs farther from each face than the \
             radius of its fillets.",
            vec![
                words("place", found.iter().map(|row| row.0.clone())),
                numbers("von Mises", "MPa", found.iter().map(|row| row.1), 4),
                (
                    Column::numbers("case", ""),
                    found.iter().map(|row| Cell::Number { value: row.2 as f64, decimals: 0 }).collect(),
                ),
            ],
        )
    }

    pub(crate) fn solve_words(&self) -> String {
        let solve = &self.solve;
        let imbalance = self.cases.iter().map(|case| {
            let size = case.load.iter().chain(&case.reaction).fold(0.0f64, |most, f| most.max(f.abs()));
            let rest = (0..3).map(|k| (case.load[k] + case.reaction[k]).abs()).fold(0.0f64, f64::max);
            if size > 0.0 && case.reaction.iter().any(|f| *f != 0.0) { rest / size } else { 0.0 }
        });
        format!(
            "Solution: {} unknowns, factor of {} entries ({}), {} iterations, residual {:.1e}; loads and reactions balance to {:.1e}.",
            number::whole(solve.unknowns as u128),
            number::whole(solve.factor_entries as u128),
            bytes_words(solve.bytes),
            solve.iterations,
            solve.residual,
            imbalance.fold(0.0, f64::max),
        )
    }

    /// How rings touch, over all cases.
    fn contact_words(&self) -> Option<String> {
        let all: Vec<_> = self.cases.iter().filter_map(|case| case.result.contact).collect();
        let most = |of: &dyn Fn(&lanchester_flex::contact::ContactReport) -> f64| {
            all.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
        };
        let least = all.iter().map(|own| own.closed).fold(f64::INFINITY, f64::min);
        (!all.is_empty()).then(|| {
            format!(
                "Contact: {:.0} to {:.0} % of the rings' area touches; largest pressure {} MPa, where the faces go {} um into each other; at most {} factors for a case.",
                100.0 * least,
                100.0 * most(&|own| own.closed),
                number::short(1e-6 * most(&|own| own.largest_pressure), 4),
                number::short(1e6 * most(&|own| own.penetration), 2),
                most(&|own| own.steps as f64),
            )
        })
    }

    /// How journals rest in their films, case by case; `None` where they do not.
    pub(crate) fn films_table(&self) -> Option<Table> {
        let rows: Vec<(usize, &JournalInFilm)> = self
            .cases
            .iter()
            .enumerate()
            .flat_map(|(k, case)| case.result.films.iter().map(move |film| (k + 1, film)))
            .collect();
        if rows.is_empty() {
            return None;
        }
        let of = |value: &dyn Fn(&JournalInFilm) -> f64| {
            let values: Vec<f64> = rows.iter().map(|(_, film)| value(film)).collect();
            values.into_iter()
        };
        let whole = |value: usize| Cell::Number { value: value as f64, decimals: 0 };
        let size = |[x, y]: [f64; 2]| x.hypot(y);
        let mut columns = vec![
            (Column::numbers("case", ""), rows.iter().map(|(k, _)| whole(*k)).collect()),
            words("bearing", rows.iter().map(|(_, film)| film.bearing.clone())),
            numbers("force", "kN", of(&|film| 1e-3 * size(film.force)), 4),
            numbers("eccentricity", "", of(&|film| film.eccentricity_ratio), 4),
            numbers("least film", "um", of(&|film| 1e6 * film.least_film), 3),
            numbers("at an end", "um", of(&|film| 1e6 * film.least_edge_film), 3),
            numbers("pressure", "MPa", of(&|film| 1e-6 * film.largest_pressure), 4),
            numbers("by roughness", "%", of(&|film| 100.0 * film.contact_share), 3),
        ];
        if rows.iter().any(|(_, film)| film.shell != [0.0; 2]) {
            columns.push(numbers("shell", "um", of(&|film| 1e6 * size(film.shell)), 3));
        }
        Some(Table::of_columns(
            "stress-films",
            "Journals in their oil films",
            "Each load rests: force of the film on the journal, the journal's distance from the middle of its bearing over the radial clearance, least film at the middle \
             and, with the slope of the journal, at an end of the bearing, where less than 0 is contact; largest pressure of the film; share of the force that touching \
             roughness carries; where housings yield, how far the shell gives way.",
            columns,
        ))
    }

    /// The chapter of a report: pictures first.
    pub fn section(&self) -> Section {
        Section::new("crankshaft-stress", "Stress", "Crankshaft stress")
            .lead(self.lead())
            .rows(self.figures())
            .paragraphs(self.words())
            .tables(self.convergence.as_ref().map(Convergence::table))
            .tables([self.cases_table(), self.fillets_table()])
            .tables(self.submodel.as_ref().map(StressSubmodel::table))
            .tables([self.surfaces_table()])
            .tables(self.films_table())
    }

    /// Words before the tables.
    pub(crate) fn words(&self) -> Vec<String> {
        let mut words = vec![format!("Support: {}.", self.support)];
        words.push(match &self.gas {
            Some(gas) => format!("Gas: {gas}."),
            None => "Gas: none.".to_owned(),
        });
        words.extend(self.sheet.words());
        words.push(self.solve_words());
        words.extend(self.contact_words());
        words.extend(self.touching_words());
        words.extend(self.notes.iter().cloned());
        words
    }

    /// Which bent journals touch at an end of their bearings; `None` where none does.
    fn touching_words(&self) -> Option<String> {
        let films = self.cases.iter().flat_map(|case| &case.result.films);
        let touching: BTreeSet<&str> =
            films.filter(|film| film.least_edge_film < 0.0).map(|film| film.bearing.as_str()).collect();
        (!touching.is_empty()).then(|| {
            format!(
                "By the slope of its journal {} would touch at an end: forces and films there are those of a journal parallel to its shell, and hold no more than the sharing of the load.",
                touching.into_iter().collect::<Vec<_>>().join(", ")
            )
        })
    }
}

/// Everything as plain text.
pub fn static_stress_text(stress: &StaticStress) -> String {
    let mut out =
        format!("{}, static stress of crankshaft {}\n\n", stress.sheet.engine, stress.sheet.crankshaft);
    push_wrapped(&mut out, "", &stress.lead());
    out.push('\n');
    for words in stress.words() {
        push_wrapped(&mut out, "", &words);
    }
    let convergence = stress.convergence.as_ref().map(Convergence::table);
    let submodel = stress.submodel.as_ref().map(StressSubmodel::table);
    let tables = [stress.cases_table(), stress.fillets_table()];
    let tables =
        tables.into_iter().chain(submodel).chain([stress.surfaces_table()]).chain(stress.films_table());
    for table in convergence.into_iter().chain(tables) {
        out.push('\n');
        out.push_str(&table.noted_text());
    }
    out
}

/// Every fillet and surface under every case as CSV, unrounded; fillets of a submodel under the case that stresses each most.
pub fn static_stress_csv(stress: &StaticStress) -> String {
    let mut out = String::new();
    let head = [
        "case",
        "angle [deg]",
        "speed [rpm]",
        "place",
        "radius [mm]",
        "von Mises [MPa]",
        "principal [MPa]",
        "jump",
        "x [mm]",
        "y [mm]",
        "z [mm]",
        "displacement [mm]",
        "energy [J]",
    ];
    push_csv_line(&mut out, head.map(str::to_owned));
    for case in &stress.cases {
        let plain = case.result.surfaces.iter().chain(&case.result.webs);
        let corners = case.result.peaks.iter().zip(stress.sheet.crank.corners.iter().map(|c| Some(c.radius)));
        let surfaces = plain.map(|surface| (surface, None));
        for (peak, radius) in corners.chain(surfaces) {
            let of = |value: &dyn Fn(&lanchester_flex::crank_case::PeakStress) -> f64| {
                peak.stress.as_ref().map_or(String::new(), |stress| csv_number(value(stress)))
            };
            let line = [
                case.name.clone(),
                case.theta.map_or(String::new(), |theta| csv_number(theta.to_degrees())),
                csv_number(number::rpm(case.speed)),
                peak.name.clone(),
                radius.map_or(String::new(), |radius| csv_number(1e3 * radius)),
                of(&|s| 1e-6 * s.von_mises),
                of(&|s| 1e-6 * s.principal),
                of(&|s| s.jump),
                of(&|s| 1e3 * s.at[0]),
                of(&|s| 1e3 * s.at[1]),
                of(&|s| 1e3 * s.at[2]),
                csv_number(1e3 * case.result.largest_displacement),
                csv_number(case.energy),
            ];
            push_csv_line(&mut out, line);
        }
    }
    for fillet in stress.submodel.iter().flat_map(|own| &own.fillets) {
        let (case, own) = (stress.cases.get(fillet.case), fillet.stress);
        let line = [
            case.map_or(String::new(), |case| case.name.clone()),
            case.and_then(|case| case.theta).map_or(String::new(), |theta| csv_number(theta.to_degrees())),
            case.map_or(String::new(), |case| csv_number(number::rpm(case.speed))),
            format!("{} (submodel)", fillet.name),
            csv_number(1e3 * fillet.radius),
            csv_number(1e-6 * own.von_mises),
            csv_number(1e-6 * own.principal),
            csv_number(own.jump),
            csv_number(1e3 * own.at[0]),
            csv_number(1e3 * own.at[1]),
            csv_number(1e3 * own.at[2]),
            String::new(),
            String::new(),
        ];
        push_csv_line(&mut out, line);
    }
    out
}

/// Jump of the stress from element to element above which a fillet is too coarse to go by.
const COARSE: f64 = 0.2;

/// What is said where elements are too coarse; with three meshes the band says it.
fn coarse_words(jump: f64, is_studied: bool) -> String {
    if jump <= COARSE || is_studied {
        return String::new();
    }
    format!(
        " Elements are coarse there: the stress jumps by {:.0} % from one to the next, and may be as much too low. More of them across the fillet, a submodel or a study of three meshes tell it.",
        100.0 * jump
    )
}
