//! Fatigue of a crankshaft: its tables.

use super::body::CrankSheet;
use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::table::{Cell, Column, Table, csv_number, numbers, push_csv_line, words};
use lanchester_flex::sparse::SolveReport;
use lanchester_model::{Origin, Sourced};
use lanchester_strength::{Findley, PointFatigue};
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const CRANK_FATIGUE_VERSION: u32 = 1;

/// What lowers the fatigue limits of polished specimens [1]; 1 leaves them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FatigueFactors {
    /// Finish of the surface.
    pub surface: f64,
    /// Size of the body.
    pub size: f64,
    /// Gradient of the stress; above 1 where it supports.
    pub gradient: f64,
}

impl Default for FatigueFactors {
    /// None.
    fn default() -> FatigueFactors {
        FatigueFactors { surface: 1.0, size: 1.0, gradient: 1.0 }
    }
}

impl FatigueFactors {
    /// All of them together [1].
    pub fn product(&self) -> f64 {
        self.surface * self.size * self.gradient
    }
}

/// Findley's criterion for a material, with what it was made of.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FatigueMeasure {
    /// Fatigue limit in alternating bending [Pa].
    pub bending_limit: Sourced,
    /// Fatigue limit in alternating torsion [Pa].
    pub torsion_limit: Sourced,
    /// The criterion with these limits and factors.
    pub findley: Findley,
    /// Factors on the limits.
    pub factors: FatigueFactors,
}

impl FatigueMeasure {
    /// What is said where the limits are estimates.
    pub fn estimated(&self) -> Option<String> {
        (self.bending_limit.origin != Origin::Given).then(|| {
            "Fatigue limits are estimates from the tensile strength; give fatigue_bending and fatigue_torsion in [crank.material].".to_owned()
        })
    }

    pub(crate) fn words(&self) -> String {
        let FatigueFactors { surface, size, gradient } = self.factors;
        let factor = |name: &str, value: f64| match value {
            1.0 => format!("{name} off"),
            value => format!("{name} {}", number::trimmed(value, 4)),
        };
        format!(
            "Fatigue limits: bending {} MPa ({}), torsion {} MPa ({}). Factors: {}, {}, {}. Findley: k = {}, allowed {} MPa.",
            number::trimmed(1e-6 * self.bending_limit.value, 4),
            self.bending_limit.origin,
            number::trimmed(1e-6 * self.torsion_limit.value, 4),
            self.torsion_limit.origin,
            factor("surface", surface),
            factor("size", size),
            factor("gradient", gradient),
            number::short(self.findley.weight, 4),
            number::short(1e-6 * self.findley.allowed, 4),
        )
    }
}

/// Safety against fatigue of every fillet of a crankshaft.
///
/// Linear, elastic; loads of the closed form at constant speed, superposed from unit loads; Findley's criterion.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankFatigue {
    /// [`CRANK_FATIGUE_VERSION`].
    pub version: u32,
    /// What was meshed.
    pub sheet: CrankSheet,
    /// What holds it, in words.
    pub support: String,
    /// Where the pressures come from, in words; `None`: no gas acts.
    pub gas: Option<String>,
    /// How the equations were solved.
    pub solve: SolveReport,
    /// The criterion.
    #[serde(flatten)]
    pub measure: FatigueMeasure,
    /// Instants of a revolution.
    pub instants: usize,
    /// At each speed.
    pub speeds: Vec<FatigueAtSpeed>,
    /// What was assumed and left out.
    pub notes: Vec<String>,
}

/// All fillets at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FatigueAtSpeed {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Along z.
    pub fillets: Vec<FilletFatigue>,
}

/// The node of a fillet where Findley's value is largest.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FilletFatigue {
    /// "pin 1 at web 2".
    pub name: String,
    /// Its radius [m].
    pub radius: f64,
    /// Place of the node [m].
    pub at: [f64; 3],
    /// Its angle about the bar's middle, from the x axis of the crankshaft's frame [rad].
    pub angle: f64,
    /// Crank angle at which the normal stress on the worst plane is largest [rad].
    pub critical_angle: f64,
    /// Worst plane and safeties.
    pub point: PointFatigue,
    /// Largest von Mises stress of the fillet over the cycle [Pa].
    pub von_mises: f64,
    /// Yield strength over it, where the strength is known [1].
    pub static_safety: Option<f64>,
}

impl FilletFatigue {
    /// Whether both safeties, of all stress and of its amplitude, reach `wanted`.
    pub fn is_safe(&self, wanted: f64) -> bool {
        self.least_safety() >= wanted
    }

    /// The lesser of both safeties; infinite where no cycle of stress loads it.
    pub fn least_safety(&self) -> f64 {
        let or_infinite = |safety: Option<f64>| safety.unwrap_or(f64::INFINITY);
        or_infinite(self.point.safety_of_all).min(or_infinite(self.point.safety_of_amplitude))
    }
}

impl CrankFatigue {
    /// Speed and fillet of the least safety when all stress is scaled.
    pub fn worst(&self) -> Option<(f64, &FilletFatigue)> {
        let all = self.speeds.iter().flat_map(|own| own.fillets.iter().map(|fillet| (own.speed, fillet)));
        all.max_by(|a, b| a.1.point.plane.value.total_cmp(&b.1.point.plane.value))
    }

    /// Speed [rad/s] and fillet of the least safety, of all stress or of its amplitude.
    pub fn weakest(&self) -> Option<(f64, &FilletFatigue)> {
        let all = self.speeds.iter().flat_map(|own| own.fillets.iter().map(|fillet| (own.speed, fillet)));
        all.min_by(|a, b| a.1.least_safety().total_cmp(&b.1.least_safety()))
    }

    pub(crate) fn lead(&self) -> String {
        let Some((speed, fillet)) = self.worst() else { return "No fillet has a stress.".to_owned() };
        let safety = |own: Option<f64>| own.map_or("unlimited".to_owned(), |own| number::short(own, 3));
        let at = fillet.at.map(|x| number::short(1e3 * x, 4)).join(", ");
        let normal = fillet.point.plane.normal.map(|x| number::short(x, 3)).join(", ");
        format!(
            "Least safety against fatigue {} (of the amplitude alone {}) at {}, {} rpm: at the point ({at}) mm, most loaded at crank angle {} deg, on the plane with the \
             normal ({normal}).",
            safety(fillet.point.safety_of_all),
            safety(fillet.point.safety_of_amplitude),
            fillet.name,
            number::terminal(number::rpm(speed), 0),
            number::short(fillet.critical_angle.to_degrees(), 4),
        )
    }

    fn words(&self) -> Vec<String> {
        let mut words = vec![
            self.measure.words(),
            format!("Support: {}.", self.support),
            format!("Gas: {}.", self.gas.as_deref().unwrap_or("none")),
        ];
        words.extend(self.sheet.words());
        words.push(format!(
            "Solution: {} unknowns, residual {:.1e}; {} instants of a revolution by superposition.",
            number::whole(self.solve.unknowns as u128),
            self.solve.residual,
            self.instants
        ));
        words.extend(self.notes.iter().cloned());
        words
    }

    /// The fillets at one speed.
    pub fn table(&self, own: &FatigueAtSpeed) -> Table {
        let fillets = &own.fillets;
        let column = |head: &str, unit, digits, of: fn(&FilletFatigue) -> f64| {
            numbers(head, unit, fillets.iter().map(of), digits)
        };
        let safety = |head: &str, of: fn(&FilletFatigue) -> Option<f64>| {
            let cell = |fillet: &FilletFatigue| of(fillet).map_or(Cell::Empty, |own| Cell::number(own, 3));
            (Column::numbers(head, "1"), fillets.iter().map(cell).collect::<Vec<_>>())
        };
        Table::of_columns(
            "fatigue-fillets",
            format!("Fatigue of fillets at {} rpm", number::terminal(number::rpm(own.speed), 0)),
            "At the worst node of each fillet. Shear amplitude and largest normal stress on its worst plane; crank angle of the latter. Safety of all: all stress scaled; of \
             amplitude: its mean over the cycle stays. Angle about the middle of the pin or journal, from throw 1.",
            vec![
                words("fillet", fillets.iter().map(|fillet| fillet.name.clone())),
                column("shear", "MPa", 4, |fillet| 1e-6 * fillet.point.plane.shear),
                column("normal", "MPa", 4, |fillet| 1e-6 * fillet.point.plane.normal_stress),
                column("Findley", "MPa", 4, |fillet| 1e-6 * fillet.point.plane.value),
                safety("safety of all", |fillet| fillet.point.safety_of_all),
                safety("of amplitude", |fillet| fillet.point.safety_of_amplitude),
                column("crank angle", "deg", 4, |fillet| fillet.critical_angle.to_degrees()),
                column("angle", "deg", 3, |fillet| fillet.angle.to_degrees()),
                column("z", "mm", 5, |fillet| 1e3 * fillet.at[2]),
                column("von Mises", "MPa", 4, |fillet| 1e-6 * fillet.von_mises),
                safety("static safety", |fillet| fillet.static_safety),
            ],
        )
    }
}

/// Everything as plain text.
pub fn fatigue_text(found: &CrankFatigue) -> String {
    let mut out = format!("{}, fatigue of crankshaft {}\n\n", found.sheet.engine, found.sheet.crankshaft);
    push_wrapped(&mut out, "", &found.lead());
    out.push('\n');
    for words in found.words() {
        push_wrapped(&mut out, "", &words);
    }
    for own in &found.speeds {
        out.push('\n');
        out.push_str(&found.table(own).noted_text());
    }
    out
}

/// Every fillet at every speed as CSV, unrounded.
pub fn fatigue_csv(found: &CrankFatigue) -> String {
    let mut out = String::new();
    let head = [
        "speed [rpm]",
        "fillet",
        "radius [mm]",
        "x [mm]",
        "y [mm]",
        "z [mm]",
        "shear amplitude [MPa]",
        "largest normal stress [MPa]",
        "Findley [MPa]",
        "safety of all",
        "safety of amplitude",
        "crank angle [deg]",
        "normal x",
        "normal y",
        "normal z",
        "von Mises [MPa]",
        "static safety",
    ];
    push_csv_line(&mut out, head.map(str::to_owned));
    let optional = |value: Option<f64>| value.map_or(String::new(), csv_number);
    for own in &found.speeds {
        for fillet in &own.fillets {
            let plane = &fillet.point.plane;
            let line = [
                csv_number(number::rpm(own.speed)),
                fillet.name.clone(),
                csv_number(1e3 * fillet.radius),
                csv_number(1e3 * fillet.at[0]),
                csv_number(1e3 * fillet.at[1]),
                csv_number(1e3 * fillet.at[2]),
                csv_number(1e-6 * plane.shear),
                csv_number(1e-6 * plane.normal_stress),
                csv_number(1e-6 * plane.value),
                optional(fillet.point.safety_of_all),
                optional(fillet.point.safety_of_amplitude),
                csv_number(fillet.critical_angle.to_degrees()),
                csv_number(plane.normal[0]),
                csv_number(plane.normal[1]),
                csv_number(plane.normal[2]),
                csv_number(1e-6 * fillet.von_mises),
                optional(fillet.static_safety),
            ];
            push_csv_line(&mut out, line);
        }
    }
    out
}
