//! Where the energy goes: works and what is stored, over the run and over its last period, and the heat of the gas beside them.

use crate::kit::figure::Figure;
use crate::kit::flow::energy_flow;
use crate::kit::number;
use crate::kit::table::{Cell, Table};
use crate::simulated::columns::{table, words};
use crate::simulated::figure::figure;
use crate::simulated::result::SimulationResult;
use lanchester_multibody::EnergyLedger;

/// A work, positive where it puts energy in, or what a store gained.
#[derive(Clone, Copy)]
struct Part {
    /// In pictures and in tables.
    names: [&'static str; 2],
    /// [J].
    energy: f64,
    is_stored: bool,
}

impl Part {
    /// What it puts into the run [J].
    fn given(&self) -> f64 {
        if self.is_stored { -self.energy } else { self.energy }
    }
}

fn parts(e: &EnergyLedger) -> [Part; 13] {
    let work = |short, long, energy| Part { names: [short, long], energy, is_stored: false };
    let store = |short, long, [start, end]: [f64; 2]| Part {
        names: [short, long],
        energy: end - start,
        is_stored: true,
    };
    [
        work("gas", "work of gas", e.gas),
        work("load", "work of load", e.load),
        work("starter", "work of starter", e.starter),
        work("friction", "work of friction", e.friction),
        work("pistons' friction", "work of friction of the pistons", e.piston_friction),
        work("drive and others", "work of drive and other torques from the ground", e.outside),
        work("mounts' dampers", "work of dampers of the mounts", e.mount_damping),
        work("driveline's dampers", "work of dampers of the driveline", e.driveline_damping),
        work("opening clutch", "twist that the opening clutch lets go", e.clutch),
        store("kinetic energy", "stored: kinetic energy", e.kinetic),
        store("mounts' springs", "stored: springs of the mounts", e.mounts),
        store("gravity", "stored: gravity", e.gravity),
        store("driveline's springs", "stored: springs of the driveline", e.driveline),
    ]
}

fn flows(e: &EnergyLedger) -> Vec<(&'static str, f64)> {
    parts(e).iter().map(|part| (part.names[0], part.given())).collect()
}

/// What put energy into a run, positive, and what took or stores it, negative, by name [J].
pub fn run_flows(result: &SimulationResult) -> Vec<(&'static str, f64)> {
    flows(&result.run.energy)
}

/// The same of the last period, from the fuel on where its heat is known: walls and exhaust then stand beside what the gas drives, in place of the gas
/// itself. `None` without a whole last period.
pub fn period_flows(result: &SimulationResult) -> Option<Vec<(&'static str, f64)>> {
    let mut works = flows(result.run.last_period.as_ref()?);
    if let Some(heat) = &result.heat {
        works.retain(|(name, _)| *name != "gas");
        works.insert(0, ("fuel", heat.fuel));
        works.extend(heat.losses().map(|(name, energy)| (name, -energy)));
    }
    Some(works)
}

fn side(flows: &[(&str, f64)], sign: f64) -> Vec<(String, f64)> {
    let of = flows.iter().filter(|(_, work)| sign * work > 0.0);
    of.map(|(name, work)| ((*name).to_owned(), work.abs())).collect()
}

/// Pictures of the run and of its last period.
pub(crate) fn energy_figures(result: &SimulationResult) -> Vec<Figure> {
    let mut figures = Vec::new();
    let works = run_flows(result);
    let closes = format!("They close to {:.1e} of the throughput.", result.run.audit.energy);
    if let Some(panel) = energy_flow(&side(&works, 1.0), &side(&works, -1.0), &[]) {
        let caption = format!("Works and stored energies over the run, widths in proportion. {closes}");
        figures.push(figure("simulated-energy", "Where the energy goes", &caption, vec![panel]));
    }
    let (Some(period), Some(works)) = (&result.run.last_period, period_flows(result)) else {
        return figures;
    };
    let mut within = Vec::new();
    let caption = match &result.heat {
        Some(heat) => format!(
            "Energy of the fuel in the last period and where it goes, widths in proportion; the gas does {} J of work on the pistons. Heat is that of cycles at the mean speed, \
             whose work is {} J: by this difference both sides differ.",
            number::short(period.gas, 5),
            number::short(heat.indicated, 5),
        ),
        None => "Works and stored energies of the last period, widths in proportion.".to_owned(),
    };
    let (given, taken) = (side(&works, 1.0), side(&works, -1.0));
    if let Some(heat) = &result.heat {
        let lost: f64 = heat.losses().iter().map(|(_, energy)| energy).sum();
        let whole: f64 = given.iter().map(|(_, energy)| energy).sum();
        within = vec![("work".to_owned(), whole - lost), ("heat".to_owned(), lost)];
    }
    if let Some(panel) = energy_flow(&given, &taken, &within) {
        let title = "Where the energy of a period goes";
        figures.push(figure("simulated-period-energy", title, &caption, vec![panel]));
    }
    figures
}

/// Name, energy over the run and over its last period [J]; NaN where there is none. Parts that the run has not are left out.
pub(super) fn energy_rows(result: &SimulationResult) -> Vec<(&'static str, f64, f64)> {
    let period = result.run.last_period.as_ref().map(parts);
    let whole = parts(&result.run.energy).into_iter().enumerate();
    let rows =
        whole.map(|(k, part)| (part.names[1], part.energy, period.map_or(f64::NAN, |own| own[k].energy)));
    let mut rows: Vec<_> =
        rows.filter(|(_, energy, period)| *energy != 0.0 || (period.is_finite() && *period != 0.0)).collect();
    if let Some(heat) = &result.heat {
        let parts = [
            ("heat: fuel", heat.fuel),
            ("heat: not burned", heat.unburned),
            ("heat: walls", heat.walls),
            ("heat: exhaust less intake", heat.exhaust),
        ];
        rows.extend(
            parts
                .into_iter()
                .filter(|(_, energy)| *energy != 0.0)
                .map(|(name, energy)| (name, f64::NAN, energy)),
        );
    }
    rows
}

/// The energy ledger.
pub(super) fn energy_table(result: &SimulationResult) -> Table {
    let number = |energy: f64| if energy.is_finite() { Cell::number(energy, 6) } else { Cell::text("-") };
    let mut columns = vec![words("part", ""), words("whole run", "J")];
    let with_period = result.run.last_period.is_some();
    if with_period {
        columns.push(words("last period", "J"));
    }
    let row = |(name, whole, period): (&str, f64, f64)| {
        let both = [Cell::text(name), number(whole)];
        both.into_iter().chain(with_period.then(|| number(period))).collect()
    };
    let rows = energy_rows(result).into_iter().map(row).collect();
    let heat = match result.heat {
        Some(_) => " Heat is that of the computed cycles at the mean speed of the last period.",
        None => "",
    };
    let note = format!("Works put in, and what is stored of them: both sums are equal.{heat}");
    table("simulated-energy", "Energy", &note, columns, rows)
}
