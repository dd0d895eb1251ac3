//! A published method with the true optimum of the same devices beside it, as tables.

use crate::kit::magnitude::Magnitude;
use crate::kit::number;
use crate::kit::rounding::{among, below, clean};
use crate::kit::table::{Cell, Column, Table, column_cells, own_cells};
use crate::optimum::effect_noise::effect_noise;
use lanchester_balance::Effect;
use lanchester_literature::{
    BalancerPhase, Basis, Equilibrium, MatrixBalance, MethodAnswer, MethodFound, MethodWeight as Weight,
    OrderLeft, PrintedV, ShaftOrder, ThreeCylinderBalance,
};
use lanchester_model::Engine;
use lanchester_task::{criterion_name, criterion_unit};
use num_complex::Complex64;

/// Every weight of the method, and what the optimum has in its place.
pub fn method_weights_table(answer: &MethodAnswer) -> Table {
    let weights = &answer.weights;
    let noise = among(weights.iter().flat_map(|w| [w.unbalance.norm(), w.optimum.norm()]));
    let amounts = |of: fn(&Weight) -> Complex64| {
        column_cells(weights.iter().map(|w| 1e6 * of(w).norm()), 6, 1e6 * noise)
    };
    let directions = |of: fn(&Weight) -> Complex64| -> Vec<Cell> {
        let direction = |w: &Weight| match of(w).norm() > noise {
            true => Cell::Number { value: number::phase_degrees(of(w).arg()), decimals: 2 },
            false => Cell::Empty,
        };
        weights.iter().map(direction).collect()
    };
    let seat = |w: &Weight| match &w.shaft {
        None => Cell::text("crankshaft"),
        Some(_) => Cell::text(format!("shaft, {}\u{202f}×", w.ratio.replace('-', "\u{2212}"))),
    };
    let mut columns = vec![
        (Column::words("weight"), weights.iter().map(|w| Cell::text(&w.name)).collect()),
        (Column::words("on"), weights.iter().map(seat).collect()),
        (Column::numbers("z", "mm"), own_cells(weights.iter().map(|w| 1e3 * w.z), 5)),
    ];
    if weights.iter().any(|w| w.mass.is_some()) {
        let mass = |w: &Weight| w.mass.map_or(Cell::Empty, |m| Cell::Number { value: 1e3 * m, decimals: 1 });
        columns.push((Column::numbers("mass", "g"), weights.iter().map(mass).collect()));
    }
    columns.extend([
        (Column::numbers("unbalance", "g mm"), amounts(|w| w.unbalance)),
        (Column::numbers("direction", "deg"), directions(|w| w.unbalance)),
        (Column::numbers("optimum", "g mm"), amounts(|w| w.optimum)),
        (Column::numbers("direction", "deg"), directions(|w| w.optimum)),
    ]);
    Table::of_columns(
        "method-weights",
        "The weights",
        "Directions at θ = 0 in the engine's frame, from +x towards +y.",
        columns,
    )
}

/// What is left of every order, in both senses, with the method and with the optimum.
pub fn method_orders_table(answer: &MethodAnswer) -> Table {
    let orders = &answer.orders;
    let kinds = [("force", "N", 0), ("couple", "N m", 2)];
    let rows: Vec<(usize, usize, &str, &str)> = kinds
        .iter()
        .flat_map(|(name, unit, first)| {
            (0..orders.len()).flat_map(move |k| (0..2).map(move |sense| (k, first + sense, *name, *unit)))
        })
        .collect();
    let masses = Magnitude::of_masses(&answer.fitted);
    let noise = |at: usize| if at < 2 { masses.force_noise() } else { masses.couple_noise() };
    let cells = |of: fn(&OrderLeft) -> [f64; 4]| -> Vec<Cell> {
        rows.iter()
            .map(|&(k, at, ..)| {
                let o = &orders[k];
                let largest = o.without[at].max(o.method[at]).max(o.optimum[at]);
                let value = clean(of(o)[at], noise(at));
                Cell::Number { value, decimals: number::decimals(largest, 6).min(3) }
            })
            .collect()
    };
    let nothing: Vec<usize> = (0..rows.len())
        .filter(|&r| {
            let (k, at, ..) = rows[r];
            let o = &orders[k];
            [o.without[at], o.method[at], o.optimum[at]].iter().all(|v| *v <= noise(at))
        })
        .collect();
    let remark = match nothing.is_empty() {
        true => String::new(),
        false => "Rows of nothing at all are left out.".to_owned(),
    };
    Table::of_columns(
        "method-orders",
        "What is left, order by order",
        "Amounts of the parts that turn with and against the crank, about the origin.",
        vec![
            (Column::words("load"), rows.iter().map(|r| Cell::text(r.2)).collect()),
            (Column::words("unit"), rows.iter().map(|r| Cell::text(r.3)).collect()),
            (
                Column::numbers("order", ""),
                rows.iter().map(|r| Cell::text(number::order(orders[r.0].order))).collect(),
            ),
            (
                Column::words("turns"),
                rows.iter().map(|r| Cell::text(if r.1 % 2 == 0 { "with" } else { "against" })).collect(),
            ),
            (Column::numbers("without", ""), cells(|o| o.without)),
            (Column::numbers("method", ""), cells(|o| o.method)),
            (Column::numbers("optimum", ""), cells(|o| o.optimum)),
        ],
    )
    .without(&nothing, remark)
}

/// Peaks over the cycle without the devices, with the method, with the optimum, and what the method leaves over it.
pub fn method_effects_table(engine: &Engine, answer: &MethodAnswer) -> Table {
    let effects = &answer.optimum.effects;
    let cleaned = |e: &Effect, value: f64| clean(value, effect_noise(engine, effects, &e.criterion));
    let cells = |of: fn(&Effect) -> f64| -> Vec<Cell> {
        let cell = |e: &Effect| {
            let largest = e.without.abs().max(e.before.abs()).max(e.after.abs());
            Cell::Number { value: cleaned(e, of(e)), decimals: number::decimals(largest, 6) }
        };
        effects.iter().map(cell).collect()
    };
    let excess = |e: &Effect| {
        let excess = cleaned(e, e.before) - cleaned(e, e.after);
        let largest = e.without.abs().max(e.before.abs()).max(e.after.abs());
        Cell::Number { value: excess, decimals: number::decimals(largest, 6) }
    };
    Table::of_columns(
        "method-effects",
        "Peaks over the cycle",
        "The optimum has the same devices, every amount and direction free.",
        vec![
            (
                Column::words("load"),
                effects.iter().map(|e| Cell::text(criterion_name(&e.criterion, engine))).collect(),
            ),
            (
                Column::words("unit"),
                effects.iter().map(|e| Cell::text(criterion_unit(&e.criterion))).collect(),
            ),
            (Column::numbers("without", ""), cells(|e| e.without)),
            (Column::numbers("method", ""), cells(|e| e.before)),
            (Column::numbers("optimum", ""), cells(|e| e.after)),
            (Column::numbers("method \u{2212} optimum", ""), effects.iter().map(excess).collect()),
        ],
    )
}

/// The method's own numbers: those of its tables and equations.
pub fn method_numbers_table(answer: &MethodAnswer) -> Table {
    let mut numbers = Numbers::default();
    let (note, other) = match &answer.found {
        MethodFound::Matrix { balance, printed, printed_used } => {
            matrix_numbers(&mut numbers, balance, printed.as_deref());
            (
                format!(
                    "Sized for {}. Equations as corrected in the book, \"Published methods\".{}",
                    basis(balance.basis),
                    if *printed_used { " The shafts above are those of the last column." } else { "" }
                ),
                "as printed",
            )
        }
        MethodFound::ThreeCylinder { balance, phase, other } => {
            let (right, printed) = match phase {
                BalancerPhase::CouplePeak => (balance, other),
                BalancerPhase::OppositeFirstThrow => (other, balance),
            };
            three_numbers(&mut numbers, right, printed);
            let used = match phase {
                BalancerPhase::CouplePeak => "",
                BalancerPhase::OppositeFirstThrow => " The shaft above is that of the last column.",
            };
            (
                format!(
                    "Section 3.6.1 of the source sets the balancer's front weight opposite crank 1; the couple peaks \
                     elsewhere.{used}"
                ),
                "as printed",
            )
        }
        MethodFound::FourCylinder { balance } => {
            numbers.add("second-order force over ω²", "kg mm", 1e3 * balance.second_force, None);
            numbers.add("second-order couple over ω²", "kg mm m", 1e3 * balance.second_moment, None);
            numbers.add("unbalance of each shaft, m_B r_B", "kg mm", 1e3 * balance.shaft_unbalance, None);
            numbers.add(
                "the same with the exact second order",
                "kg mm",
                1e3 * balance.exact_shaft_unbalance,
                None,
            );
            ("Eq 4.8 takes r/l for the coefficient of the second order.".to_owned(), "")
        }
        MethodFound::Factor { share, residual } => {
            numbers.add("share of the reciprocating masses", "%", 100.0 * share, None);
            let (force, couple) = residual.first.peak();
            numbers.add("first-order force left over ω²", "kg mm", 1e3 * force, None);
            numbers.add("first-order couple left over ω²", "kg mm m", 1e3 * couple, None);
            ("Eq 1.10 with its radius.".to_owned(), "")
        }
    };
    numbers.table(note, other)
}

fn matrix_numbers(numbers: &mut Numbers, balance: &MatrixBalance, printed: Option<&PrintedV>) {
    numbers.add("counterweight offset angle, α", "deg", balance.alpha.to_degrees(), None);
    numbers.add("mass of each counterweight, m_c", "kg", balance.counterweight_mass, None);
    if balance.counterweight_extra != 0.0 {
        let name = "besides, in place of a first-order shaft, m_c1,cs";
        numbers.add(name, "kg", balance.counterweight_extra, None);
    }
    let mut order = |order: &Option<ShaftOrder>, symbol: &str, printed: Option<f64>| {
        let Some(shafts) = order else { return };
        let name = |sense: &str| format!("mass on the shaft {sense} the crank, {symbol}");
        numbers.add(name("with"), "kg", shafts.forward_mass, printed);
        numbers.add(name("against"), "kg", shafts.backward_mass, printed);
    };
    order(&balance.first, "m_c1", printed.map(|p| p.first_mass));
    order(&balance.second, "m_c2", printed.map(|p| p.second_mass));
    if let Some(printed) = printed {
        let share = Some(100.0 * printed.vertical_share);
        numbers.add_printed("vertical first-order couple that the shafts take", "%", share);
        let left = Some(1e3 * printed.horizontal_left);
        numbers.add_printed("horizontal first-order couple that they leave, over ω²", "kg mm m", left);
    }
}

fn three_numbers(numbers: &mut Numbers, right: &ThreeCylinderBalance, printed: &ThreeCylinderBalance) {
    numbers.add("couple of the rotating masses over ω²", "kg mm m", 1e3 * right.rotating_moment, None);
    numbers.add("first-order couple over ω²", "kg mm m", 1e3 * right.first_moment, None);
    numbers.add(
        "it peaks from top dead centre of cylinder 1 by",
        "deg",
        right.first_peak_angle.to_degrees(),
        None,
    );
    numbers.add("second-order couple over ω², not balanced", "kg mm m", 1e3 * right.second_moment, None);
    numbers.add("unbalance of each balance weight, B_U", "kg mm", 1e3 * right.balancer_unbalance, None);
    numbers.add("unbalance of each counterweight, CW_U", "kg mm", 1e3 * right.counterweight_unbalance, None);
    let front = |balance: &ThreeCylinderBalance| {
        let weight = balance.engine.shafts.last().and_then(|s| s.weights.first());
        weight.map_or(0.0, |w| number::phase_degrees(w.phase))
    };
    numbers.add("front balance weight stands at, θ = 0", "deg", front(right), Some(front(printed)));
    let left = |balance: &ThreeCylinderBalance| 100.0 * balance.share_left;
    numbers.add("left of what the shaft is for", "%", left(right), Some(left(printed)));
}

fn basis(basis: Basis) -> &'static str {
    match basis {
        Basis::Force => "the force of the rotating masses of the whole crank",
        Basis::Couple => "the couple of the rotating masses of the whole crank",
        Basis::HalfForce => "the force of the rotating masses of the front half of the crank",
        Basis::HalfCouple => "the moment of the rotating masses of the front half of the crank",
        Basis::Nothing => "nothing: the rotating masses leave neither force nor couple",
    }
}

/// Rows of numbers, some with a printed variant.
#[derive(Default)]
struct Numbers {
    rows: Vec<(String, &'static str, Option<f64>, Option<f64>)>,
}

impl Numbers {
    fn add(&mut self, name: impl Into<String>, unit: &'static str, value: f64, printed: Option<f64>) {
        self.rows.push((name.into(), unit, Some(value), printed));
    }

    fn add_printed(&mut self, name: &str, unit: &'static str, printed: Option<f64>) {
        self.rows.push((name.to_owned(), unit, None, printed));
    }

    fn table(self, note: String, other: &'static str) -> Table {
        let cell = |value: Option<f64>| {
            value.map_or(Cell::Empty, |v| Cell::Number { value: v, decimals: number::decimals(v, 5).min(5) })
        };
        let mut columns = vec![
            (Column::words("quantity"), self.rows.iter().map(|r| Cell::text(&r.0)).collect()),
            (Column::words("unit"), self.rows.iter().map(|r| Cell::text(r.1)).collect()),
            (Column::numbers("value", ""), self.rows.iter().map(|r| cell(r.2)).collect()),
        ];
        if self.rows.iter().any(|r| r.3.is_some()) {
            columns.push((Column::numbers(other, ""), self.rows.iter().map(|r| cell(r.3)).collect()));
        }
        Table::of_columns("method-numbers", "The method's own numbers", note, columns)
    }
}

/// The four equations of equilibrium of the matrix method, none of which it checks; `None` for another method.
pub fn equilibrium_table(answer: &MethodAnswer) -> Option<Table> {
    let MethodFound::Matrix { balance, .. } = &answer.found else { return None };
    let equations = &balance.equations;
    let unit = |k: usize| if k < 2 { "kg mm" } else { "kg mm m" };
    let largest = |k: usize| {
        let pair = &equations[if k < 2 { 0..2 } else { 2..4 }];
        pair.iter().fold(0.0f64, |m, e| m.max(e.throws.abs()).max(e.left.abs()))
    };
    let cells = |of: fn(&Equilibrium) -> f64| -> Vec<Cell> {
        let cell = |k: usize| {
            let value = of(&equations[k]);
            let value = 1e3 * clean(value, below(largest(k)));
            Cell::Number { value, decimals: number::decimals(1e3 * largest(k), 5) }
        };
        (0..4).map(cell).collect()
    };
    let alone =
        |e: &Equilibrium| e.mass_alone.map_or(Cell::Empty, |mass| Cell::Number { value: mass, decimals: 4 });
    Some(Table::of_columns(
        "equilibrium",
        "Equilibrium of the whole crank, without pistons",
        "The method takes its mass from one resultant; each equation alone would ask for the mass in the fourth column.",
        vec![
            (Column::words("equation"), equations.iter().map(|e| Cell::text(e.name)).collect()),
            (Column::words("unit"), (0..4).map(|k| Cell::text(unit(k))).collect()),
            (Column::numbers("throws", ""), cells(|e| e.throws)),
            (Column::numbers("mass alone", "kg"), equations.iter().map(alone).collect()),
            (Column::numbers("left", ""), cells(|e| e.left)),
        ],
    ))
}
