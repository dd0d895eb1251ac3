//! A search over layouts as a study in blocks, with the judged cases, or the front, as rows.

use crate::run::Study;
use lanchester_study::explore::{
    Banks, Candidate, Exploration, ExploreError, ExploreRequest, Explorer, Layout, Objective, Run,
};
use lanchester_table::{Column, Rows, Values};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Cases of a block.
const BLOCK: u128 = 1 << 15;

/// Which cases are the rows of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LayoutRows {
    /// All that are judged.
    Judged,
    /// Those on the front.
    Front,
    /// None.
    Nothing,
}

/// The request of a search as its table keeps it.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct SavedSearch {
    /// The request.
    pub request: ExploreRequest,
    /// Which cases are rows.
    pub rows: LayoutRows,
    /// What the user should know of it.
    pub notes: Vec<String>,
}

/// A search over layouts, cut into blocks of cases.
#[derive(Debug, Clone, PartialEq)]
pub struct LayoutStudy {
    /// The search.
    pub explorer: Explorer,
    /// Which cases are rows.
    pub rows: LayoutRows,
}

impl LayoutStudy {
    fn run(&self, blocks: Range<u64>) -> Run {
        let at = |block: u64| (u128::from(block) * BLOCK).min(self.explorer.size());
        Run { from: at(blocks.start), to: at(blocks.end) }
    }

    /// Rows of cases and their objectives, in SI; `alike` where they are kinds of cases.
    fn table(&self, cases: &[u128], values: &[f64], alike: Option<Vec<i64>>) -> Result<Rows, ExploreError> {
        let layouts = cases.iter().map(|case| self.explorer.layout(*case)).collect::<Result<Vec<_>, _>>()?;
        let request = self.explorer.request();
        let real = |of: &dyn Fn(&Layout) -> f64| Values::Real(layouts.iter().map(of).collect());
        let text = |of: &dyn Fn(&Layout) -> String| Values::Text(layouts.iter().map(of).collect());
        // Sizes are below 2^63: the search refuses larger ones.
        let mut columns = vec![Values::Whole(cases.iter().map(|case| *case as i64).collect())];
        if let Banks::Two { .. } = request.space.banks {
            let pair = |of: &dyn Fn(&lanchester_study::explore::BankPair) -> f64| {
                real(&|layout| layout.banks.as_ref().map_or(f64::NAN, of))
            };
            columns.push(pair(&|pair| degrees(pair.bank_angle)));
            columns.push(pair(&|pair| degrees(pair.split_angle)));
            columns.push(pair(&|pair| millimetres(pair.stagger)));
        }
        // Where cylinders and rods stay what they are there is no one spacing.
        if request.space.arrangement().is_none() {
            columns.push(real(&|layout| millimetres(layout.spacing)));
            columns.push(real(&|layout| layout.rod_ratio));
        }
        columns.push(text(&|layout| layout.counterweights.name.clone()));
        columns.push(text(&|layout| layout.shafts.name.clone()));
        for group in 0..request.space.groups() {
            columns.push(real(&|layout| degrees(layout.throw_angles[group])));
        }
        if request.space.firing {
            columns.push(text(&|layout| {
                let order: Vec<String> =
                    layout.firing_order().iter().flatten().map(|cylinder| cylinder.to_string()).collect();
                order.join("-")
            }));
        }
        let width = request.objectives.len();
        for (place, objective) in request.objectives.iter().enumerate() {
            let (_, factor) = unit(*objective);
            let own = values.chunks_exact(width).map(|values| values[place] * factor);
            columns.push(Values::Real(own.collect()));
        }
        columns.extend(alike.map(Values::Whole));
        Ok(Rows::of(columns))
    }
}

impl Study for LayoutStudy {
    type Kept = Exploration;
    type Error = ExploreError;

    fn blocks(&self) -> u64 {
        u64::try_from(self.explorer.size().div_ceil(BLOCK)).unwrap_or(u64::MAX)
    }

    fn cases(&self, blocks: Range<u64>) -> u128 {
        let run = self.run(blocks);
        run.to - run.from
    }

    fn columns(&self) -> Vec<Column> {
        let request = self.explorer.request();
        let mut columns = vec![Column::whole("case")];
        if let Banks::Two { .. } = request.space.banks {
            columns.extend(["bank_angle_deg", "split_angle_deg", "stagger_mm"].map(Column::real));
        }
        if request.space.arrangement().is_none() {
            columns.extend(["spacing_mm", "rod_ratio"].map(Column::real));
        }
        columns.extend(["counterweights", "balance_shafts"].map(Column::text));
        columns.extend((1..=request.space.groups()).map(|throw| Column::real(format!("throw_{throw}_deg"))));
        if request.space.firing {
            columns.push(Column::text("firing_order"));
        }
        columns.extend(request.objectives.iter().map(|objective| Column::real(column_name(*objective))));
        if self.rows == LayoutRows::Front {
            columns.push(Column::whole("alike"));
        }
        columns
    }

    fn nothing(&self) -> Exploration {
        self.explorer.start()
    }

    fn block(&self, number: u64) -> Result<(Exploration, Rows), ExploreError> {
        let (mut cases, mut values) = (Vec::new(), Vec::new());
        let keep = self.rows == LayoutRows::Judged;
        let found = self.explorer.look(self.run(number..number + 1), &mut |case, own| {
            if keep {
                cases.push(case);
                values.extend_from_slice(own);
            }
        })?;
        let rows = match keep {
            true => self.table(&cases, &values, None)?,
            false => Rows::empty(&self.columns()),
        };
        Ok((found, rows))
    }

    fn join(&self, one: Exploration, next: Exploration) -> Result<Exploration, ExploreError> {
        self.explorer.merge(one, next)
    }

    fn last_rows(&self, kept: &Exploration) -> Result<Option<Rows>, ExploreError> {
        if self.rows != LayoutRows::Front {
            return Ok(None);
        }
        let cases: Vec<u128> = kept.front.iter().map(|candidate| candidate.case).collect();
        let values: Vec<f64> = kept.front.iter().flat_map(|candidate| candidate.values.clone()).collect();
        let alike = |candidate: &Candidate| candidate.alike as i64;
        self.table(&cases, &values, Some(kept.front.iter().map(alike).collect())).map(Some)
    }
}

/// Degrees to a billionth: what was asked for in degrees is written as it was.
fn degrees(angle: f64) -> f64 {
    (1e9 * angle.to_degrees()).round() / 1e9 + 0.0
}

/// Millimetres to the picometre.
fn millimetres(length: f64) -> f64 {
    (1e12 * length).round() / 1e9 + 0.0
}

/// Unit of an objective in a table, as the end of its column's name, and what SI is multiplied by.
fn unit(objective: Objective) -> (&'static str, f64) {
    match objective.unit() {
        "N" => ("_N", 1.0),
        "N m" => ("_Nm", 1.0),
        "rad" => ("_deg", 1f64.to_degrees()),
        "m" => ("_mm", 1e3),
        "kg m" => ("_kgmm", 1e3),
        _ => ("", 1.0),
    }
}

/// Name of the column of an objective: letters, digits and underscores.
fn column_name(objective: Objective) -> String {
    let name = match objective {
        Objective::Force { order } => format!("force_order_{order}"),
        Objective::Couple { order } => format!("couple_order_{order}"),
        Objective::ForceSense { order, sense } => format!("{}_force_order_{order}", sense.name()),
        Objective::CoupleSense { order, sense } => format!("{}_couple_order_{order}", sense.name()),
        Objective::RollMoment { order } => format!("roll_moment_order_{order}"),
        Objective::InertiaTorque { order } => format!("inertia_torque_order_{order}"),
        Objective::BendingMoment => "bending_moment".to_owned(),
        Objective::MainLoad => "main_load".to_owned(),
        Objective::FiringUnevenness => "uneven_firing".to_owned(),
        Objective::FiringHarmonic { half_orders } => {
            format!("firing_order_{}", 0.5 * f64::from(half_orders)).replace('.', "_")
        }
        Objective::NeighbourFirings => "neighbour_firings".to_owned(),
        Objective::Length => "length".to_owned(),
        Objective::Height => "height".to_owned(),
        Objective::CounterweightUnbalance => "counterweight_unbalance".to_owned(),
        Objective::Shafts => "shafts".to_owned(),
    };
    name + unit(objective).0
}
