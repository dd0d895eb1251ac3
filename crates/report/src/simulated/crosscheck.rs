//! How far closed form, bond graph and multibody simulation agree: the table of `crosscheck`.

use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::section::Section;
use crate::kit::table::{Cell, Column, Table, csv_number, push_csv_line};
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const CROSSCHECK_VERSION: u32 = 1;

/// Comparison of two independent computations of the same engine.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrossCheck {
    /// [`CROSSCHECK_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Where the pressures come from, in words; `None`: inertia alone.
    pub gas: Option<String>,
    /// Conditions, in order.
    pub conditions: Vec<ConditionCheck>,
    /// What of the file acts in some conditions alone.
    pub notes: Vec<String>,
}

/// Under what both are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Condition {
    /// Imposed speed, fixed block, no gravity, the same pressures.
    LikeForLike,
    /// Free speed, fixed block, constant load torque.
    FreeSpeed,
    /// Imposed speed, block on its mounts.
    MovingBlock,
    /// Free speed, block on its mounts where the file gives them: bond graph against multibody simulation, and by order the linear response with
    /// its causes.
    AllFree,
    /// Imposed speed, fixed block, rigid bearings: a crankshaft by finite elements, stiffened until it is rigid and as it is, against the closed form.
    FlexibleCrank,
}

impl Condition {
    /// All of them.
    pub const ALL: [Condition; 5] = [
        Condition::LikeForLike,
        Condition::FreeSpeed,
        Condition::MovingBlock,
        Condition::AllFree,
        Condition::FlexibleCrank,
    ];

    /// Whether it is checked unless others are asked for: E meshes the crankshaft, which takes minutes.
    pub fn is_usual(self) -> bool {
        self != Condition::FlexibleCrank
    }

    /// What is held against the closed form, or the bond graph.
    pub fn other(self) -> &'static str {
        match self {
            Condition::FlexibleCrank => "flexible crankshaft",
            _ => "multibody",
        }
    }

    /// Its letter.
    pub fn letter(self) -> &'static str {
        match self {
            Condition::LikeForLike => "A",
            Condition::FreeSpeed => "B",
            Condition::MovingBlock => "C",
            Condition::AllFree => "D",
            Condition::FlexibleCrank => "E",
        }
    }

    /// What it is, in words.
    pub fn name(self) -> &'static str {
        match self {
            Condition::LikeForLike => "imposed speed, fixed block, no gravity",
            Condition::FreeSpeed => "free speed, fixed block, constant load torque",
            Condition::MovingBlock => "imposed speed, block on its mounts",
            Condition::AllFree => "free speed, block on its mounts where it has them",
            Condition::FlexibleCrank => "crankshaft by finite elements in rigid bearings, imposed speed",
        }
    }

    /// At which angles it is compared, where the largest value of one load is told by several rows.
    fn sampling(self) -> &'static str {
        match self {
            Condition::LikeForLike => {
                " Both sides of a row are taken at the same angles: 180 a revolution, those of bond graphs at 72 beside the dead centres, so that the largest value over the cycle may differ a little between rows of one load."
            }
            Condition::FreeSpeed => " Taken at 720 angles a revolution, where condition A has 180.",
            _ => "",
        }
    }

    /// What the multibody simulation, or the flexible crankshaft, is held against.
    pub fn held_against(self) -> &'static str {
        match self {
            Condition::LikeForLike | Condition::AllFree => "closed form or bond graph",
            Condition::FreeSpeed | Condition::MovingBlock | Condition::FlexibleCrank => "closed form",
        }
    }
}

/// One condition.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ConditionCheck {
    /// Which.
    pub condition: Condition,
    /// Why it does not apply to this engine; `None`: it does.
    pub not_applicable: Option<String>,
    /// Its rows.
    pub rows: Vec<CrossRow>,
}

/// One quantity.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrossRow {
    /// What is compared.
    pub quantity: String,
    /// Its unit.
    pub unit: String,
    /// Order; `None`: over the whole cycle.
    pub order: Option<f64>,
    /// Largest value of the closed form over the cycle, or amplitude of the order; `None`: the bond graph is compared.
    pub closed_form: Option<f64>,
    /// Largest value of the bond graph over the run; `None`: the closed form is compared.
    pub bond_graph: Option<f64>,
    /// The same of the multibody simulation; under condition E of the flexible crankshaft.
    pub multibody: f64,
    /// Largest difference.
    pub difference: f64,
    /// What it is held against: the largest amplitude of its kind, at least a thousandth of what single parts exert.
    pub scale: f64,
    /// Largest share of `scale` that the difference may be; `None`: no bar.
    pub bar: Option<f64>,
    /// Verdict.
    pub verdict: CrossVerdict,
    /// Why they differ, where they must.
    pub reason: Option<String>,
}

/// Verdict on one row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CrossVerdict {
    /// Within the bar.
    Agrees,
    /// They compute different things: the reason says which.
    DiffersAsItMust,
    /// Beyond the bar.
    Disagrees,
}

impl CrossVerdict {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            CrossVerdict::Agrees => "agrees",
            CrossVerdict::DiffersAsItMust => "differs as it must",
            CrossVerdict::Disagrees => "disagrees",
        }
    }
}

/// Below this size a number is printed with a power of ten.
const SMALL: f64 = 1e-3;

/// `value` with so many significant digits, however small it is.
fn digits(value: f64, significant: i32) -> String {
    match value == 0.0 || !value.is_finite() || value.abs() >= SMALL {
        true => number::short(value, significant),
        false => format!("{value:.*e}", significant as usize - 1),
    }
}

/// An amount with its unit, for the reason of a row.
pub fn cross_amount(value: f64, unit: &str) -> String {
    format!("{} {unit}", digits(value, if value.abs() < SMALL { 2 } else { 4 }))
}

impl CrossRow {
    /// Difference over scale.
    pub fn share(&self) -> f64 {
        if self.difference == 0.0 { 0.0 } else { self.difference / self.scale }
    }

    /// A row that must keep `bar`.
    pub fn held(quantity: &str, unit: &str, order: Option<f64>, values: [f64; 4], bar: f64) -> CrossRow {
        let [closed_form, multibody, difference, scale] = values;
        let mut row = CrossRow {
            quantity: quantity.to_owned(),
            unit: unit.to_owned(),
            order,
            closed_form: Some(closed_form),
            bond_graph: None,
            multibody,
            difference,
            scale,
            bar: Some(bar),
            verdict: CrossVerdict::Disagrees,
            reason: None,
        };
        // What is not a number disagrees.
        if row.share() <= bar {
            row.verdict = CrossVerdict::Agrees;
        }
        row
    }
}

impl CrossCheck {
    /// Whether no row disagrees.
    pub fn agrees(&self) -> bool {
        let mut rows = self.conditions.iter().flat_map(|condition| &condition.rows);
        rows.all(|row| row.verdict != CrossVerdict::Disagrees)
    }
}

impl ConditionCheck {
    /// Its table.
    pub fn table(&self) -> Table {
        let power =
            |value: f64| Cell::text(if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") });
        let rows = self.rows.iter().map(|row| {
            vec![
                Cell::text(format!("{} [{}]", row.quantity, row.unit)),
                Cell::text(row.order.map_or("cycle".to_owned(), number::order)),
                Cell::text(row.closed_form.or(row.bond_graph).map_or(String::new(), |own| digits(own, 6))),
                Cell::text(digits(row.multibody, 6)),
                power(row.share()),
                row.bar.map_or(Cell::text("none"), power),
                Cell::text(row.verdict.name()),
                Cell::text(row.reason.clone().unwrap_or_default()),
            ]
        });
        let other = self.condition.held_against();
        let head =
            ["quantity", "order", other, self.condition.other(), "difference", "bar", "verdict", "reason"];
        Table {
            id: match self.condition {
                Condition::LikeForLike => "crosscheck-a",
                Condition::FreeSpeed => "crosscheck-b",
                Condition::MovingBlock => "crosscheck-c",
                Condition::AllFree => "crosscheck-d",
                Condition::FlexibleCrank => "crosscheck-e",
            },
            title: format!("Condition {}: {}", self.condition.letter(), self.condition.name()),
            note: format!(
                "Largest values over the cycle or amplitudes of an order; differences over the largest amplitude of their kind.{}",
                self.condition.sampling()
            ),
            remark: String::new(),
            columns: head.into_iter().map(Column::words).collect(),
            rows: rows.collect(),
        }
    }
}

impl ConditionCheck {
    /// Why it does not apply, as a sentence.
    fn missing(&self) -> Option<String> {
        let reason = self.not_applicable.as_ref()?;
        Some(format!(
            "Condition {}, {}: not applicable, {reason}.",
            self.condition.letter(),
            self.condition.name()
        ))
    }
}

/// The comparison as a section of a report.
pub fn crosscheck_section(check: &CrossCheck) -> Section {
    let speed = number::short(number::rpm(check.speed), 6);
    let rows = || check.conditions.iter().flat_map(|condition| &condition.rows);
    let of = |verdict: CrossVerdict| rows().filter(|row| row.verdict == verdict).count();
    let verdicts = [CrossVerdict::Agrees, CrossVerdict::DiffersAsItMust, CrossVerdict::Disagrees]
        .map(|verdict| format!("{} of them: {}", verdict.name(), of(verdict)));
    let all = format!("{} quantities are compared; {}.", rows().count(), verdicts.join(", "));
    Section::new("crosscheck", "Two opinions", "Two opinions on every load")
        .words(format!(
            "Closed form and bond graph at {speed} rpm, held against the simulation of the same engine as rigid bodies, with which they share no physics."
        ))
        .words(all)
        .paragraphs(check.notes.iter().cloned().chain(check.conditions.iter().filter_map(ConditionCheck::missing)))
        .tables(check.conditions.iter().filter(|condition| !condition.rows.is_empty()).map(ConditionCheck::table))
}

/// All conditions as plain text.
pub fn crosscheck_text(check: &CrossCheck) -> String {
    let speed = number::short(number::rpm(check.speed), 6);
    let gas = check.gas.as_ref().map_or("inertia alone".to_owned(), |gas| format!("gas: {gas}"));
    let mut out = format!(
        "{} at {speed} rpm, closed form and bond graph against multibody simulation, {gas}\n",
        check.engine
    );
    for note in &check.notes {
        push_wrapped(&mut out, "", note);
    }
    for condition in &check.conditions {
        out.push('\n');
        match condition.missing() {
            Some(words) => push_wrapped(&mut out, "", &words),
            None => out.push_str(&condition.table().text()),
        }
    }
    out
}

/// All rows as CSV, unrounded.
pub fn crosscheck_csv(check: &CrossCheck) -> String {
    let mut out = String::new();
    let head = [
        "condition",
        "quantity",
        "unit",
        "order",
        "closed_form",
        "bond_graph",
        "multibody",
        "difference",
        "scale",
        "bar",
        "verdict",
        "reason",
    ];
    push_csv_line(&mut out, head.map(str::to_owned));
    for condition in &check.conditions {
        for row in &condition.rows {
            let line = [
                condition.condition.letter().to_owned(),
                row.quantity.clone(),
                row.unit.clone(),
                row.order.map_or(String::new(), csv_number),
                row.closed_form.map_or(String::new(), csv_number),
                row.bond_graph.map_or(String::new(), csv_number),
                csv_number(row.multibody),
                csv_number(row.difference),
                csv_number(row.scale),
                row.bar.map_or(String::new(), csv_number),
                row.verdict.name().to_owned(),
                row.reason.clone().unwrap_or_default(),
            ];
            push_csv_line(&mut out, line);
        }
    }
    out
}
