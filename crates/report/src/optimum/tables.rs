//! The answer of a balancing question as tables.

use crate::kit::number;
use crate::kit::rounding::{among, clean};
use crate::kit::table::{Cell, Column, Table, column_cells, numbers, own_cells, words};
use crate::optimum::effect_noise::effect_noise;
use lanchester_balance::{Answer, Effect, FoundLimit, FoundStage, FoundWeight, LimitSide, Method, WebBound};
use lanchester_model::Engine;
use lanchester_task::{CatalogueHole, Criterion, Limit, Seat, criterion_name, criterion_unit};

/// What fits on the webs whose weights it bounds; none where no weight is bounded so.
pub fn web_bounds_table(answer: &Answer) -> Option<Table> {
    let bounds = &answer.web_bounds;
    let used = |bound: &WebBound| {
        let found = answer.weights.iter().find(|weight| weight.name == bound.name);
        let found = found.map_or(0.0, |weight| weight.unbalance.norm());
        if bound.bound > 0.0 { 100.0 * found / bound.bound } else { 0.0 }
    };
    (!bounds.is_empty()).then(|| {
        Table::of_columns(
            "web-bounds",
            "What fits on the webs",
            "The largest unbalance that shapes and clearance allow there: the optimum is the best within these bounds.",
            vec![
                words("weight", bounds.iter().map(|bound| bound.name.clone())),
                words("web", bounds.iter().map(|bound| bound.web.to_string())),
                numbers("largest", "g mm", bounds.iter().map(|bound| 1e6 * bound.bound), 5),
                numbers("used", "%", bounds.iter().map(used), 4),
                words("by", bounds.iter().map(|bound| bound.by.clone())),
            ],
        )
    })
}

/// A hole in words: "12 mm, 18.0 mm deep".
fn named(hole: &CatalogueHole) -> String {
    let slug = if hole.slug_density.is_some() { ", with a slug" } else { "" };
    let drill = format!("{:.2}", 1e3 * hole.diameter);
    let drill = drill.trim_end_matches('0').trim_end_matches('.');
    format!("{drill} mm, {:.1} mm deep{slug}", 1e3 * hole.depth)
}

/// Every free weight: where it stands, how much it is, in which direction.
pub fn found_weights_table(answer: &Answer) -> Table {
    let weights = &answer.weights;
    let seat = |k: usize| match answer.task.weights[k].seat {
        Seat::Crankshaft(_) => "crankshaft".to_owned(),
        Seat::Shaft(shaft) => {
            let shaft = &answer.task.shafts[shaft];
            format!("{} ({}\u{202f}×)", shaft.name, shaft.ratio.to_string().replace('-', "\u{2212}"))
        }
    };
    let noise = among(weights.iter().map(|w| w.unbalance.norm()));
    let direction = |w: &FoundWeight| match w.used && w.unbalance.norm() > noise {
        true => Cell::Number { value: number::phase_degrees(w.unbalance.arg()), decimals: 2 },
        false => Cell::Empty,
    };
    let mut columns = vec![
        (Column::words("weight"), weights.iter().map(|w| Cell::text(&w.name)).collect()),
        (Column::words("on"), (0..weights.len()).map(|k| Cell::text(seat(k))).collect()),
        (Column::numbers("z", "mm"), own_cells(weights.iter().map(|w| 1e3 * w.z), 5)),
        (
            Column::numbers("unbalance", "g mm"),
            column_cells(weights.iter().map(|w| 1e6 * w.unbalance.norm()), 6, 1e6 * noise),
        ),
        (Column::numbers("direction", "deg"), weights.iter().map(direction).collect()),
    ];
    if weights.iter().any(|w| w.mass.is_some()) {
        let mass = |w: &FoundWeight| {
            w.mass.map_or(Cell::Empty, |mass| Cell::Number { value: 1e3 * mass, decimals: 1 })
        };
        columns.push((Column::numbers("mass", "g"), weights.iter().map(mass).collect()));
    }
    if weights.iter().any(|w| w.hole.is_some()) {
        let hole = |w: &FoundWeight| w.hole.as_ref().map_or(Cell::Empty, |hole| Cell::text(named(hole)));
        columns.push((Column::words("hole"), weights.iter().map(hole).collect()));
        // An empty hole lies opposite to the weight that it is as good as.
        let at = |w: &FoundWeight| match &w.hole {
            Some(hole) if hole.slug_density.is_none() => {
                Cell::Number { value: number::phase_degrees((-w.unbalance).arg()), decimals: 2 }
            }
            Some(_) => direction(w),
            None => Cell::Empty,
        };
        columns.push((Column::numbers("hole at", "deg"), weights.iter().map(at).collect()));
    }
    let mut table = Table::of_columns(
        "found-weights",
        "The weights",
        "Directions at θ = 0 in the engine's frame, from +x towards +y.",
        columns,
    );
    if weights.iter().any(|w| !w.used) {
        table.remark = left_out(answer);
    }
    table
}

/// Which weights are left out, and why: those that may be, where no more devices may be used, because of that; any other
/// because it is better without.
fn left_out(answer: &Answer) -> String {
    let task = &answer.task;
    let may_be = |weight: usize| {
        let weight = &task.weights[weight];
        weight.optional || matches!(weight.seat, Seat::Shaft(shaft) if task.shafts[shaft].optional)
    };
    let weights = task.weights.iter().zip(&answer.weights).filter(|(free, w)| free.optional && w.used);
    let shafts = task.shafts.iter().zip(&answer.shafts).filter(|(free, s)| free.optional && s.used);
    let inertias =
        task.inertias.iter().zip(&answer.inertias).filter(|(free, i)| free.optional && i.inertia > 0.0);
    let used = weights.count() + shafts.count() + inertias.count();
    let full = task.most_optional.filter(|most| used >= *most);
    let unused = (0..answer.weights.len()).filter(|&k| !answer.weights[k].used);
    let (crowded, better): (Vec<usize>, Vec<usize>) = unused.partition(|&k| full.is_some() && may_be(k));
    let names = |list: &[usize]| {
        let names: Vec<&str> = list.iter().map(|&k| answer.weights[k].name.as_str()).collect();
        names.join(", ")
    };
    let mut words = Vec::new();
    if let (Some(most), false) = (full, crowded.is_empty()) {
        let devices = if most == 1 { "device" } else { "devices" };
        words.push(format!(
            "Not used, because at most {most} optional {devices} may be used: {}.",
            names(&crowded)
        ));
    }
    if !better.is_empty() {
        words.push(format!("Not used in the optimum: {}.", names(&better)));
    }
    words.join(" ")
}

/// Where the free shafts stand; `None` without any.
pub fn found_shafts_table(answer: &Answer) -> Option<Table> {
    if answer.shafts.is_empty() {
        return None;
    }
    let ratio = |k: usize| Cell::text(answer.task.shafts[k].ratio.to_string().replace('-', "\u{2212}"));
    Some(Table::of_columns(
        "found-shafts",
        "The shafts",
        "Speed over that of the crank, negative against it.",
        vec![
            (Column::words("shaft"), answer.shafts.iter().map(|s| Cell::text(&s.name)).collect()),
            (Column::numbers("speed ratio", ""), (0..answer.shafts.len()).map(ratio).collect()),
            (Column::numbers("x", "mm"), own_cells(answer.shafts.iter().map(|s| 1e3 * s.x), 4)),
            (Column::numbers("y", "mm"), own_cells(answer.shafts.iter().map(|s| 1e3 * s.y), 4)),
            (
                Column::words("used"),
                answer.shafts.iter().map(|s| Cell::text(if s.used { "yes" } else { "no" })).collect(),
            ),
        ],
    ))
}

/// The free inertias; `None` without any.
pub fn found_inertias_table(answer: &Answer) -> Option<Table> {
    if answer.inertias.is_empty() {
        return None;
    }
    let inertias = &answer.inertias;
    Some(Table::of_columns(
        "found-inertias",
        "Counter-rotating inertias",
        "What each leaves of the crank train's roll moment.",
        vec![
            (Column::words("inertia"), inertias.iter().map(|i| Cell::text(&i.name)).collect()),
            (Column::numbers("inertia", "kg cm²"), own_cells(inertias.iter().map(|i| 1e4 * i.inertia), 5)),
            (
                Column::numbers("roll moment left", "%"),
                inertias.iter().map(|i| Cell::Number { value: 100.0 * i.roll_share, decimals: 1 }).collect(),
            ),
        ],
    ))
}

/// Every criterion without the free weights, as the file stands, and with the answer.
pub fn effects_table(engine: &Engine, answer: &Answer) -> Table {
    let effects = &answer.effects;
    // The three numbers of a row share its decimals.
    let cleaned = |e: &Effect, value: f64| clean(value, effect_noise(engine, effects, &e.criterion));
    let cells = |of: fn(&Effect) -> f64| -> Vec<Cell> {
        let cell = |e: &Effect| {
            let largest = e.without.abs().max(e.before.abs()).max(e.after.abs()) * factor(&e.criterion);
            let value = cleaned(e, of(e)) * factor(&e.criterion);
            Cell::Number { value, decimals: number::decimals(largest, 5) }
        };
        effects.iter().map(cell).collect()
    };
    let change = |e: &Effect| match (cleaned(e, e.before), cleaned(e, e.after)) {
        (0.0, _) => Cell::Empty,
        (before, after) => Cell::Number { value: 100.0 * (after / before - 1.0), decimals: 1 },
    };
    Table::of_columns(
        "effects",
        "What it does",
        "Peaks over the continuous cycle.",
        vec![
            (
                Column::words("criterion"),
                effects.iter().map(|e| Cell::text(criterion_name(&e.criterion, engine))).collect(),
            ),
            (Column::words("unit"), effects.iter().map(|e| Cell::text(shown_unit(&e.criterion))).collect()),
            (Column::numbers("without", ""), cells(|e| e.without)),
            (Column::numbers("file", ""), cells(|e| e.before)),
            (Column::numbers("optimum", ""), cells(|e| e.after)),
            (Column::numbers("change", "%"), effects.iter().map(change).collect()),
        ],
    )
}

/// What each limit is, what was reached, and its shadow price; `None` without any.
pub fn limits_table(engine: &Engine, answer: &Answer) -> Option<Table> {
    if answer.limits.is_empty() {
        return None;
    }
    let mut note =
        "The shadow price is how much the objective beside it would fall if the limit were relaxed by one unit"
            .to_owned();
    note += match answer.method {
        Method::Convex { .. } => ".",
        Method::BranchAndBound { .. } => {
            ", with the choices kept: devices used, places, directions of given and least amounts."
        }
    };
    if answer.limits.iter().any(|l| l.side == LimitSide::Given && l.price < 0.0) {
        note += " Of a given amount it is that of a smaller one; negative where a larger one helps.";
    }
    if answer.limits.iter().any(|l| l.stage.is_some_and(|k| answer.stages[k].is_weighted_sum())) {
        note += " A weighted sum has no unit: its terms are shares of the values given for them.";
    }
    let name = |l: &FoundLimit| match l.criterion {
        Some(criterion) => criterion_name(&criterion, engine),
        None => l.what.clone(),
    };
    let objective = |l: &FoundLimit| match l.stage {
        Some(stage) if answer.stages[stage].is_weighted_sum() => Cell::text("weighted sum"),
        Some(stage) => Cell::text(stage_name(engine, &answer.stages[stage])),
        None => Cell::text("not active"),
    };
    let price_unit = |l: &FoundLimit| l.price_unit.strip_prefix("1 ").unwrap_or(&l.price_unit).to_owned();
    let limits = &answer.limits;
    Some(Table::of_columns(
        "limits",
        "Shadow prices of the limits",
        note,
        vec![
            (Column::words("limit"), limits.iter().map(|l| Cell::text(name(l))).collect()),
            (
                Column::words("side"),
                limits
                    .iter()
                    .map(|l| {
                        Cell::text(match l.side {
                            LimitSide::AtMost => "at most",
                            LimitSide::AtLeast => "at least",
                            LimitSide::Given => "given",
                        })
                    })
                    .collect(),
            ),
            (Column::numbers("value", ""), limits.iter().map(|l| Cell::number(l.most, 5)).collect()),
            (Column::numbers("reached", ""), limits.iter().map(|l| Cell::number(l.value, 5)).collect()),
            (Column::words("unit"), limits.iter().map(|l| Cell::text(shown_power(&l.unit))).collect()),
            (Column::numbers("shadow price", ""), limits.iter().map(|l| price_cell(l.price)).collect()),
            (
                Column::words("unit of price"),
                limits.iter().map(|l| Cell::text(shown_power(&price_unit(l)))).collect(),
            ),
            (Column::words("of"), limits.iter().map(objective).collect()),
        ],
    ))
}

/// Four digits of a shadow price, however small: a weighted sum has no unit and small prices.
fn price_cell(price: f64) -> Cell {
    let leading = if price == 0.0 { 0 } else { price.abs().log10().floor() as i32 };
    Cell::Number { value: price, decimals: (3 - leading).clamp(0, 12) as usize }
}

fn shown_power(unit: &str) -> String {
    unit.replace("m^2", "m²")
}

/// How close each limit of a task without an answer can be reached if the others are dropped.
pub fn closest_table(engine: &Engine, answer: &Answer, closest: &[f64]) -> Table {
    let limits = &answer.task.limits;
    let name = |l: &Limit| Cell::text(criterion_name(&l.criterion, engine));
    let unit = |l: &Limit| Cell::text(criterion_unit(&l.criterion));
    Table::of_columns(
        "closest",
        "How close each limit can be reached alone",
        "The smallest value of each with the other limits dropped.",
        vec![
            (Column::words("limit"), limits.iter().map(name).collect()),
            (Column::words("unit"), limits.iter().map(unit).collect()),
            (Column::numbers("at most", ""), limits.iter().map(|l| Cell::number(l.most, 5)).collect()),
            (Column::numbers("closest", ""), closest.iter().map(|&v| Cell::number(v, 5)).collect()),
        ],
    )
}

/// Every stage with its bound, and the crank angles that hold it up.
pub fn stages_table(engine: &Engine, answer: &Answer) -> Table {
    let stages = &answer.stages;
    let angles = |k: usize| {
        let mut degrees: Vec<(f64, Option<f64>)> = stages[k]
            .active
            .iter()
            .filter(|a| a.multiplier > 0.0)
            .map(|a| (a.theta.to_degrees().rem_euclid(720.0), a.speed))
            .collect();
        degrees.sort_by(|a, b| a.0.total_cmp(&b.0));
        degrees.dedup_by(|a, b| (a.0 - b.0).abs() < 0.05 && a.1 == b.1);
        let shown = degrees.iter().take(8).map(|(angle, speed)| {
            let at = speed.map_or(String::new(), |speed| format!(" at {:.0} rpm", number::rpm(speed)));
            format!("{}°{at}", number::trimmed(*angle, 4))
        });
        let shown: Vec<String> = shown.collect();
        let more = if degrees.len() > 8 { ", …" } else { "" };
        format!("{}{more}", shown.join(", "))
    };
    let rows = 0..stages.len();
    let given = |stage: &FoundStage| stage.give_up.map_or(Cell::Empty, |given| Cell::number(given.used, 5));
    let mut columns = vec![
        (Column::words("minimised"), stages.iter().map(|s| Cell::text(stage_name(engine, s))).collect()),
        (Column::words("unit"), stages.iter().map(|s| Cell::text(&s.unit)).collect()),
        (Column::numbers("reached", ""), stages.iter().map(|s| Cell::number(s.value, 7)).collect()),
        (Column::numbers("bound", ""), stages.iter().map(|s| Cell::number(s.lower_bound, 7)).collect()),
        (Column::words("gap"), stages.iter().map(|s| Cell::text(gap(answer, s))).collect()),
        (Column::words("active at θ ="), rows.map(|k| Cell::text(angles(k))).collect()),
    ];
    if stages.iter().any(|stage| stage.give_up.is_some()) {
        columns.insert(4, (Column::numbers("given up", ""), stages.iter().map(given).collect()));
    }
    Table::of_columns(
        "stages",
        "The proof",
        "No choice of these devices goes below the bound; a gap is closed where it is less than 1e-8 of the value; the angles are where the load stands at its peak and cannot give way.",
        columns,
    )
}

/// The gap of a stage; below 1e-8 of what matters it is rounding, and its digits tell nothing.
fn gap(answer: &Answer, stage: &FoundStage) -> String {
    let without = |criterion: &Criterion| {
        answer.effects.iter().find(|e| e.criterion == *criterion).map_or(0.0, |e| e.without.abs())
    };
    let terms = stage.terms.iter().zip(&stage.term_weights);
    let unbalanced: f64 = terms.map(|((criterion, _), weight)| weight * without(criterion)).sum();
    // A gap belongs to the solver's promise and not to the rule of rounding in print; where there is nothing to balance,
    // 1e-9 N or N m closes it.
    match stage.gap <= (1e-8 * stage.value.max(1e-6 * unbalanced)).max(1e-9) {
        true => "closed".to_owned(),
        false => format!("{:.1e}", stage.gap),
    }
}

/// What a stage minimises: `force`, or `force / 200 N + couple / 10 N m`, each criterion as a share of the value given for it.
pub(crate) fn stage_name(engine: &Engine, stage: &FoundStage) -> String {
    let terms = stage.terms.iter().zip(&stage.term_weights);
    let terms = terms.map(|((criterion, _), &weight)| {
        let name = criterion_name(criterion, engine);
        if !stage.is_weighted_sum() {
            return name;
        }
        format!("{name} / {} {}", number::trimmed(1.0 / weight, 6), criterion_unit(criterion))
    });
    terms.collect::<Vec<_>>().join(" + ")
}

/// Small SI units are shown in those of the trade.
pub(crate) fn factor(criterion: &Criterion) -> f64 {
    match criterion {
        Criterion::AddedUnbalance => 1e6,
        _ => 1.0,
    }
}

pub(crate) fn shown_unit(criterion: &Criterion) -> &'static str {
    match criterion {
        Criterion::AddedUnbalance => "g mm",
        _ => criterion_unit(criterion),
    }
}
