//! The nine arrangements of the twin-cylinder thesis for one engine: a page of comparison, then one page each with
//! every load over the angle and its parts, like the thesis's appendix.

use crate::engine::tables as engine_tables;
use crate::kit::figure::{Panel, STYLE};
use crate::kit::magnitude::Magnitude;
use crate::kit::number;
use crate::kit::plot::{Bar, CaseBars};
use crate::kit::rounding;
use crate::kit::svg::escape;
use crate::kit::table::{Cell, Column, Table, own_cells, push_rich};
use crate::loads::component::Component;
use crate::loads::over_angle::{self, part_panels};
use crate::page::Provenance;
use crate::published::crank_curve::{self, load_name, load_unit};
use askama::Template;
use lanchester_balance::{Answer, Outcome};
use lanchester_literature::{CrankLoad, CrankSweep, SweptCrank, TwinArrangement};
use lanchester_mechanism::{Loads, Part};
use lanchester_model::Engine;
use lanchester_task::Criterion;

/// An engine in one arrangement.
#[derive(Debug, Clone)]
pub struct ArrangementResult {
    /// Which.
    pub arrangement: TwinArrangement,
    /// The engine with its devices.
    pub engine: Engine,
    /// Its loads.
    pub loads: Loads,
    /// Which load the arrangement is judged by; `None` where the engine has no first order.
    pub judged: Option<CrankLoad>,
    /// The sweep behind its crank.
    pub sweep: Option<CrankSweep>,
    /// The true optimum of the crank alone, which the sweep looks for.
    pub crank_optimum: Option<Answer>,
    /// The true optimum with the amounts of all its devices free; `None` where it has none.
    pub optimum: Option<Answer>,
}

impl ArrangementResult {
    /// Largest load with the arrangement's own sizes.
    pub fn sized(&self, load: CrankLoad) -> f64 {
        let peaks = &self.loads.total.peaks;
        match load {
            CrankLoad::Force => peaks.force.max.value,
            CrankLoad::Couple => peaks.couple.max.value,
        }
    }

    /// Smallest largest load that the same devices can reach, for the first stage proved, for the second without giving
    /// up any of the first.
    pub fn optimal(&self, load: CrankLoad) -> Option<f64> {
        proved(self.optimum.as_ref()?, load)
    }

    /// The true optimum of the crank alone.
    pub fn optimal_crank(&self) -> Option<SweptCrank> {
        let answer = self.crank_optimum.as_ref()?;
        let criterion = proved(answer, self.judged?)?;
        Some(SweptCrank { unbalance: answer.weights.first()?.unbalance.norm(), criterion })
    }
}

fn proved(answer: &Answer, load: CrankLoad) -> Option<f64> {
    let wanted = Criterion::Peak(load.load());
    let stages = answer.stages.iter().filter(|_| answer.outcome == Outcome::Optimal);
    stages.filter(|s| s.terms.first().is_some_and(|t| t.0 == wanted)).map(|s| s.value).next()
}

/// Everything that the page of the arrangements shows.
#[derive(Debug, Clone, Copy)]
pub struct ArrangementsInput<'a> {
    /// The engine as its file gives it.
    pub engine: &'a Engine,
    /// Its arrangements in the order of the page.
    pub arrangements: &'a [ArrangementResult],
    /// What made the page.
    pub provenance: &'a Provenance,
    /// Warnings of the engine file, as plain text.
    pub warnings: &'a [String],
}

#[derive(Template)]
#[template(path = "arrangements.html")]
struct Page<'a> {
    figure_style: &'static str,
    engine: &'a Engine,
    provenance: &'a Provenance,
    warnings: &'a [String],
    speed: String,
    kinematics: String,
    main_data: Vec<(&'static str, String)>,
    judged: String,
    comparison: String,
    tables: String,
    sections: Vec<Section>,
}

struct Section {
    number: usize,
    title: String,
    devices: String,
    vanishing: String,
    panels: String,
    curve: String,
}

/// The arrangements as one self-contained HTML page; every arrangement begins a new sheet in print.
pub fn arrangements_report(input: &ArrangementsInput<'_>) -> String {
    let ArrangementsInput { engine, arrangements, provenance, warnings } = *input;
    let speed = arrangements.first().map_or(engine.speed.highest, |a| a.loads.speed);
    let page = Page {
        figure_style: STYLE,
        engine,
        provenance,
        warnings,
        speed: number::short(number::rpm(speed), 4),
        kinematics: arrangements.first().map_or_else(String::new, |a| a.loads.kinematics.clone()),
        main_data: engine_tables::main_data(engine, speed),
        judged: judged(arrangements),
        comparison: inline(&comparison(arrangements)),
        tables: [
            Some(maxima_table(arrangements)),
            cranks_table(arrangements),
            optima_table(arrangements, CrankLoad::Force),
            optima_table(arrangements, CrankLoad::Couple),
        ]
        .into_iter()
        .flatten()
        .map(|table| table.html())
        .collect(),
        sections: arrangements.iter().enumerate().map(|(k, _)| section(arrangements, k)).collect(),
    };
    page.render().expect("invariant: writing a page to a string cannot fail")
}

/// What the arrangements are judged by, in a sentence.
fn judged(arrangements: &[ArrangementResult]) -> String {
    match arrangements.iter().find_map(|a| a.judged) {
        Some(load) => format!("The crank is chosen for the smallest largest {}.", load_name(load)),
        None => "The reciprocating parts have no first order: the crank only balances its rotating masses."
            .to_owned(),
    }
}

fn inline(panels: &[Panel]) -> String {
    let mut out = String::with_capacity(32 * 1024);
    for panel in panels {
        panel.write_inline(&mut out);
    }
    out
}

fn section(arrangements: &[ArrangementResult], index: usize) -> Section {
    let result = &arrangements[index];
    let twin = arrangements[..index].iter().find(|other| {
        (&other.engine.counterweights, &other.engine.shafts)
            == (&result.engine.counterweights, &result.engine.shafts)
    });
    let devices = match twin {
        Some(other) => format!(
            "The orders that its further devices would balance vanish in this engine: the same as arrangement {}.",
            other.arrangement.number()
        ),
        None => devices(&result.engine),
    };
    let mut curve = Vec::new();
    if let Some(sweep) = &result.sweep {
        curve.push(crank_curve::panel(sweep, result.optimal_crank()));
        curve.extend(crank_curve::close_up(sweep, result.optimal_crank()));
    }
    let names = over_angle::vanishing(&result.loads);
    let mut vanishing = String::new();
    let names: Vec<&str> = names.into_iter().filter(|name| *name != Component::Torque.name()).collect();
    if !names.is_empty() {
        push_rich(&mut vanishing, &format!("Zero at every angle: {}.", names.join(", ")));
    }
    Section {
        number: result.arrangement.number(),
        title: result.arrangement.name().to_owned(),
        devices: escape(&devices),
        vanishing,
        panels: inline(&part_panels(&result.loads)),
        curve: inline(&curve),
    }
}

/// The devices in words: "throw 1 0.0412 kg m, ...; first order against the crank 0.0206 kg m at y = 100 mm".
fn devices(engine: &Engine) -> String {
    let amount = |u: f64| format!("{} kg m", number::short(u, 4));
    let weights: Vec<String> =
        engine.counterweights.iter().map(|w| format!("{} {}", w.name, amount(w.unbalance))).collect();
    let mut words = format!("Counterweights: {}.", weights.join(", "));
    for shaft in &engine.shafts {
        let weights: Vec<String> = match &shaft.weights[..] {
            [one] if one.z == 0.0 => vec![amount(one.unbalance)],
            many => many
                .iter()
                .map(|w| format!("{} at z = {} mm", amount(w.unbalance), number::trimmed(1e3 * w.z, 3)))
                .collect(),
        };
        let axis = number::trimmed(1e3 * shaft.y, 3);
        words += &format!(" Shaft of {}, y = {axis} mm: {}.", shaft.name, weights.join(" and "));
    }
    words
}

/// Largest loads of all arrangements, side by side.
fn maxima_table(arrangements: &[ArrangementResult]) -> Table {
    let noise: Vec<Magnitude> = arrangements.iter().map(|a| Magnitude::of(&a.loads)).collect();
    let column =
        |value: &dyn Fn(&ArrangementResult) -> f64, noise: &dyn Fn(&Magnitude) -> f64, of: &[Magnitude]| {
            let values = arrangements.iter().zip(of).map(|(a, m)| {
                let value = value(a);
                if value <= noise(m) { 0.0 } else { value }
            });
            own_cells(values, 4)
        };
    let component = |c: Component| {
        column(&move |a| c.extremes(&a.loads.total.peaks).max_abs(), &move |m| c.noise(m), &noise)
    };
    let weight = |amount: &dyn Fn(&Engine) -> Option<f64>| {
        let largest = arrangements.iter().filter_map(|a| amount(&a.engine)).fold(0.0, f64::max);
        let decimals = number::decimals(largest, 4);
        arrangements
            .iter()
            .map(|a| amount(&a.engine).map_or(Cell::Empty, |value| Cell::Number { value, decimals }))
            .collect()
    };
    let of_order = |order: i32| {
        move |engine: &Engine| {
            let shaft = engine.shafts.iter().find(|s| s.ratio.numerator().abs() == order)?;
            shaft.weights.first().map(|w| w.unbalance)
        }
    };
    Table::of_columns(
        "maxima",
        "Largest loads",
        "Largest amounts over the cycle; shaft roll: the moment M_z of the shafts alone, which is the thesis's. \
         Crank: counterweight of throw 1; shafts: one weight of each.",
        vec![
            (Column::words("arrangement"), titles(arrangements)),
            (Column::numbers("crank", "kg m"), weight(&|e| e.counterweights.first().map(|w| w.unbalance))),
            (Column::numbers("first order", "kg m"), weight(&of_order(1))),
            (Column::numbers("second order", "kg m"), weight(&of_order(2))),
            (Column::numbers("F_x", "N"), component(Component::ForceX)),
            (Column::numbers("F_y", "N"), component(Component::ForceY)),
            (
                Column::numbers("|F|", "N"),
                column(&|a| a.loads.total.peaks.force.max.value, &Magnitude::force_noise, &noise),
            ),
            (Column::numbers("M_x", "N m"), component(Component::CoupleX)),
            (Column::numbers("M_y", "N m"), component(Component::CoupleY)),
            (
                Column::numbers("|M|", "N m"),
                column(&|a| a.loads.total.peaks.couple.max.value, &Magnitude::couple_noise, &noise),
            ),
            (Column::numbers("shaft roll", "N m"), column(&roll_of_shafts, &Magnitude::roll_noise, &noise)),
            (Column::numbers("M_z", "N m"), component(Component::Roll)),
        ],
    )
}

fn roll_of_shafts(result: &ArrangementResult) -> f64 {
    let shafts = result.loads.parts.iter().find(|p| p.part == Part::Shafts);
    shafts.map_or(0.0, |p| p.loads.peaks.roll_moment.max_abs())
}

fn title(result: &ArrangementResult) -> String {
    format!("{} {}", result.arrangement.number(), result.arrangement.name())
}

fn titles(arrangements: &[ArrangementResult]) -> Vec<Cell> {
    arrangements.iter().map(|a| Cell::text(title(a))).collect()
}

/// The published sweep of the crank against the true optimum; `None` where no crank is swept.
fn cranks_table(arrangements: &[ArrangementResult]) -> Option<Table> {
    let load = arrangements.iter().find_map(|a| a.judged)?;
    let swept: Vec<&ArrangementResult> = arrangements.iter().filter(|a| a.sweep.is_some()).collect();
    let best: Vec<SweptCrank> = swept.iter().filter_map(|a| Some(a.sweep.as_ref()?.best())).collect();
    let largest = best.iter().map(|b| b.criterion).fold(0.0, f64::max);
    let decimals = number::decimals(largest, 7);
    let number =
        |value: Option<f64>, decimals| value.map_or(Cell::Empty, |value| Cell::Number { value, decimals });
    let of = |cells: &dyn Fn(&ArrangementResult, &SweptCrank) -> Cell| -> Vec<Cell> {
        swept.iter().zip(&best).map(|(a, b)| cells(a, b)).collect()
    };
    let unit = load_unit(load);
    let titles = swept.iter().map(|a| Cell::text(title(a))).collect();
    Some(Table::of_columns(
        "cranks",
        format!("The crank for the smallest {}", load_name(load)),
        "Swept: steps of the unbalance on a grid of angles, the published way. True: proved over the continuous angle.",
        vec![
            (Column::words("arrangement"), titles),
            (Column::numbers("swept crank", "kg m"), of(&|_, b| number(Some(b.unbalance), 5))),
            (Column::numbers("its load", unit), of(&|_, b| number(Some(b.criterion), decimals))),
            (
                Column::numbers("true crank", "kg m"),
                of(&|a, _| number(a.optimal_crank().map(|c| c.unbalance), 8)),
            ),
            (
                Column::numbers("its load", unit),
                of(&|a, _| number(a.optimal_crank().map(|c| c.criterion), decimals)),
            ),
            (
                Column::numbers("difference", unit),
                of(&|a, _| number(a.optimal_crank().map(|c| a.sized(load) - c.criterion), 3)),
            ),
        ],
    ))
    .filter(|_| !swept.is_empty())
}

/// The published sizes against the true optimum of one load; `None` where no arrangement can do anything about it.
fn optima_table(arrangements: &[ArrangementResult], load: CrankLoad) -> Option<Table> {
    arrangements.iter().find_map(|a| a.optimal(load))?;
    let unit = load_unit(load);
    let largest = arrangements.iter().map(|a| a.sized(load)).fold(0.0, f64::max);
    let decimals = number::decimals(largest, 5);
    let cell = |value: Option<f64>| {
        value.map_or(Cell::Empty, |value| Cell::Number {
            value: rounding::clean(value, rounding::below(largest)),
            decimals,
        })
    };
    let cells = |value: &dyn Fn(&ArrangementResult) -> Option<f64>| -> Vec<Cell> {
        arrangements.iter().map(|a| cell(value(a))).collect()
    };
    let (id, name) = match load {
        CrankLoad::Force => ("optimal-force", load_name(load)),
        CrankLoad::Couple => ("optimal-couple", load_name(load)),
    };
    Some(Table::of_columns(
        id,
        format!("Largest {name}: published sizes and the true optimum"),
        "As sized: every device cancels its order. True optimum: the amounts of the same devices are free.",
        vec![
            (Column::words("arrangement"), titles(arrangements)),
            (Column::numbers("as sized", unit), cells(&|a| Some(a.sized(load)))),
            (Column::numbers("true optimum", unit), cells(&|a| a.optimal(load))),
            (Column::numbers("lower by", unit), cells(&|a| Some(a.sized(load) - a.optimal(load)?))),
        ],
    ))
}

/// The largest amount of a load.
type LargestOf = fn(&Loads) -> f64;
/// What of it is rounding.
type NoiseOf = fn(&Magnitude) -> f64;

/// Largest force, couple and roll moment as bars.
fn comparison(arrangements: &[ArrangementResult]) -> Vec<Panel> {
    let noise: Vec<Magnitude> = arrangements.iter().map(|a| Magnitude::of(&a.loads)).collect();
    let kinds: [(&str, &str, LargestOf, NoiseOf); 3] = [
        ("largest |F|", "N", |l| l.total.peaks.force.max.value, Magnitude::force_noise),
        ("largest |M|", "N m", |l| l.total.peaks.couple.max.value, Magnitude::couple_noise),
        ("largest M_z", "N m", |l| l.total.peaks.roll_moment.max_abs(), Magnitude::roll_noise),
    ];
    kinds
        .into_iter()
        .filter_map(|(quantity, unit, value, least)| {
            let bars: Vec<Bar> = arrangements
                .iter()
                .zip(&noise)
                .map(|(a, m)| {
                    let value = value(&a.loads);
                    Bar {
                        at: a.arrangement.number() as f64,
                        value: if value <= least(m) { 0.0 } else { value },
                    }
                })
                .collect();
            let any = bars.iter().any(|b| b.value > 0.0);
            any.then(|| CaseBars { quantity, unit, case: "arrangement", bars, level: None }.panel())
        })
        .collect()
}

#[cfg(test)]
mod tests;
