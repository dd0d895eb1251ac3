//! Tables of a load calculation.

use crate::kit::magnitude::Magnitude;
use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, column_cells, own_cells};
use crate::loads::component::Component;
use lanchester_mechanism::{Loads, Part};
use lanchester_results::{Extremes, LoadSet, OrderLoads, Peaks};
use num_complex::Complex64;

/// Extremes of every component over the cycle.
pub fn peaks_table(loads: &Loads) -> Table {
    let magnitude = Magnitude::of(loads);
    let mut rows: Vec<(&str, &str, Extremes, f64)> = Vec::with_capacity(8);
    let peaks = &loads.total.peaks;
    for component in Component::ALL {
        rows.push((
            component.name(),
            component.unit(),
            component.extremes(peaks),
            component.noise(&magnitude),
        ));
    }
    rows.insert(2, ("Resultant force |F|", "N", peaks.force, magnitude.force_noise()));
    rows.insert(5, ("Resultant couple |M|", "N m", peaks.couple, magnitude.couple_noise()));
    let columns = vec![
        Column::words("quantity"),
        Column::numbers("largest", ""),
        Column::numbers("at θ", "deg"),
        Column::numbers("smallest", ""),
        Column::numbers("at θ", "deg"),
        Column::numbers("range", ""),
    ];
    let rows = rows
        .into_iter()
        .map(|(name, unit, extremes, noise)| {
            let decimals = number::decimals(extremes.max_abs().max(extremes.range()), 5);
            let vanishes = extremes.max_abs() <= noise;
            let value = |v: f64| match vanishes || v.abs() <= noise {
                true => Cell::Number { value: 0.0, decimals: 0 },
                false => Cell::Number { value: v, decimals },
            };
            let angle = |theta: f64| match vanishes {
                true => Cell::Empty,
                false => Cell::Number { value: theta.to_degrees(), decimals: 1 },
            };
            vec![
                Cell::text(format!("{name} [{unit}]")),
                value(extremes.max.value),
                angle(extremes.max.theta),
                value(extremes.min.value),
                angle(extremes.min.theta),
                value(extremes.range()),
            ]
        })
        .collect();
    Table {
        id: "peaks",
        title: "Peaks over the cycle".to_owned(),
        note: "Largest and smallest value and the first crank angle where each is reached.".to_owned(),
        columns,
        rows,
        remark: String::new(),
    }
}

/// The two senses and the amplitude of force or couple, order by order.
struct TwoSided {
    id: &'static str,
    title: &'static str,
    unit: &'static str,
    noise: f64,
    forward: fn(&OrderLoads) -> Complex64,
    backward: fn(&OrderLoads) -> Complex64,
}

impl TwoSided {
    fn table(&self, orders: &[OrderLoads]) -> Table {
        let forward: Vec<Complex64> = orders.iter().map(self.forward).collect();
        let backward: Vec<Complex64> = orders.iter().map(self.backward).collect();
        let peaks: Vec<f64> = forward.iter().zip(&backward).map(|(f, b)| f.norm() + b.norm()).collect();
        // One number of decimals for the three columns, so that the eye can compare across.
        let largest = peaks.iter().copied().filter(|v| v.is_finite()).fold(0.0, f64::max);
        let decimals = number::decimals(largest, 6);
        let noise = self.noise.max(half_digit(decimals));
        let sizes = |values: Vec<f64>| -> Vec<Cell> {
            let size =
                |value: f64| Cell::Number { value: if value <= noise { 0.0 } else { value }, decimals };
            values.into_iter().map(size).collect()
        };
        let phases = |values: &[Complex64]| values.iter().map(|v| phase(*v, noise)).collect::<Vec<_>>();
        let moduli = |values: &[Complex64]| values.iter().map(|v| v.norm()).collect::<Vec<_>>();
        let gone: Vec<usize> = (0..peaks.len()).filter(|k| peaks[*k] <= noise).collect();
        let remark = vanishing_orders(orders, &gone);
        Table::of_columns(
            self.id,
            self.title,
            ORDERS_NOTE,
            vec![
                (Column::numbers("order", ""), order_cells(orders)),
                (Column::numbers("with the crank", self.unit), sizes(moduli(&forward))),
                (Column::numbers("phase", "deg"), phases(&forward)),
                (Column::numbers("against it", self.unit), sizes(moduli(&backward))),
                (Column::numbers("phase", "deg"), phases(&backward)),
                (Column::numbers("peak", self.unit), sizes(peaks)),
            ],
        )
        .without(&gone, remark)
    }
}

/// Half of the last digit in print.
fn half_digit(decimals: usize) -> f64 {
    0.5 * 0.1f64.powi(decimals as i32)
}

/// "Orders 0, 1, 3 vanish."
fn vanishing_orders(orders: &[OrderLoads], gone: &[usize]) -> String {
    let names: Vec<String> = gone.iter().map(|k| number::order(orders[*k].order)).collect();
    match names.as_slice() {
        [] => String::new(),
        all if all.len() == orders.len() => "Zero at every order.".to_owned(),
        [one] => format!("Order {one} vanishes."),
        many => format!("Orders {} vanish.", many.join(", ")),
    }
}

const ORDERS_NOTE: &str = "Phases are the directions of the arrows at θ = 0, from +x towards +y; the peak of one order is the sum of both amplitudes.";

/// Resultants and roll moment alone, for a first page.
pub fn peaks_in_short(loads: &Loads) -> Table {
    let mut table = peaks_table(loads);
    table.id = "summary-peaks";
    table.rows.retain(|row| {
        let wanted = ["Resultant", "Roll moment"];
        matches!(&row[0], Cell::Text(name) if wanted.iter().any(|own| name.starts_with(own)))
    });
    table
}

/// Force by order.
pub fn force_orders_table(loads: &Loads) -> Table {
    TwoSided {
        id: "force-orders",
        title: "Force by order",
        unit: "N",
        noise: Magnitude::of(loads).force_noise(),
        forward: |o| o.force_forward,
        backward: |o| o.force_backward,
    }
    .table(&loads.total.orders)
}

/// Couple by order.
pub fn couple_orders_table(loads: &Loads) -> Table {
    TwoSided {
        id: "couple-orders",
        title: "Couple by order",
        unit: "N m",
        noise: Magnitude::of(loads).couple_noise(),
        forward: |o| o.couple_forward,
        backward: |o| o.couple_backward,
    }
    .table(&loads.total.orders)
}

/// Roll moment and shaft torque by order.
pub fn roll_orders_table(loads: &Loads) -> Table {
    let magnitude = Magnitude::of(loads);
    let orders = &loads.total.orders;
    // What would be printed as 0 has no phase to speak of.
    let visible = |f: fn(&OrderLoads) -> Complex64, noise: f64| {
        let largest = orders.iter().map(|o| f(o).norm()).filter(|v| v.is_finite()).fold(0.0, f64::max);
        noise.max(half_digit(number::decimals(largest, 6)))
    };
    let roll = visible(|o| o.roll_moment, magnitude.roll_noise());
    let torque = visible(|o| o.shaft_torque, magnitude.torque_noise());
    let gone: Vec<usize> = (0..orders.len())
        .filter(|k| orders[*k].roll_moment.norm() <= roll && orders[*k].shaft_torque.norm() <= torque)
        .collect();
    let amplitudes =
        |f: fn(&OrderLoads) -> Complex64, noise| column_cells(orders.iter().map(|o| f(o).norm()), 6, noise);
    let phases = |f: fn(&OrderLoads) -> Complex64, noise| {
        orders.iter().map(|o| phase(f(o), noise)).collect::<Vec<_>>()
    };
    Table::of_columns(
        "roll-orders",
        "Roll moment and shaft torque by order",
        "Each is amplitude · cos(order · θ + phase).",
        vec![
            (Column::numbers("order", ""), order_cells(orders)),
            (Column::numbers("roll moment", "N m"), amplitudes(|o| o.roll_moment, roll)),
            (Column::numbers("phase", "deg"), phases(|o| o.roll_moment, roll)),
            (Column::numbers("shaft torque", "N m"), amplitudes(|o| o.shaft_torque, torque)),
            (Column::numbers("phase", "deg"), phases(|o| o.shaft_torque, torque)),
        ],
    )
    .without(&gone, vanishing_orders(orders, &gone))
}

/// What each kind of moving part puts on the block at most.
pub fn parts_table(loads: &Loads) -> Table {
    let mut sets: Vec<(String, &LoadSet)> =
        loads.parts.iter().map(|p| (p.part.name().to_owned(), &p.loads)).collect();
    sets.push(("total".to_owned(), &loads.total));
    let note = "Largest resultants of each part alone; they do not add up, because they need not coincide.";
    extremes_of_sets(loads, "parts", "By kind of part", note, "part", &sets)
}

/// What each cylinder puts on the block at most.
pub fn cylinders_table(loads: &Loads) -> Table {
    let sets: Vec<(String, &LoadSet)> =
        loads.cylinders.iter().map(|c| (c.cylinder.to_string(), &c.loads)).collect();
    let note = "Piston, rod and the cylinder's share of its crank throw.";
    extremes_of_sets(loads, "cylinders", "By cylinder", note, "cylinder", &sets)
}

fn extremes_of_sets(
    loads: &Loads,
    id: &'static str,
    title: &str,
    note: &str,
    head: &str,
    sets: &[(String, &LoadSet)],
) -> Table {
    let magnitude = Magnitude::of(loads);
    let column = |f: fn(&Peaks) -> Extremes, noise| {
        column_cells(sets.iter().map(|s| f(&s.1.peaks).max_abs()), 4, noise)
    };
    Table::of_columns(
        id,
        title,
        note,
        vec![
            (Column::words(head), sets.iter().map(|s| Cell::text(&s.0)).collect()),
            (Column::numbers("|F_x|", "N"), column(|p| p.force_x, magnitude.force_noise())),
            (Column::numbers("|F_y|", "N"), column(|p| p.force_y, magnitude.force_noise())),
            (Column::numbers("|F|", "N"), column(|p| p.force, magnitude.force_noise())),
            (Column::numbers("|M|", "N m"), column(|p| p.couple, magnitude.couple_noise())),
            (Column::numbers("|M_z|", "N m"), column(|p| p.roll_moment, magnitude.roll_noise())),
            (Column::numbers("|T|", "N m"), column(|p| p.shaft_torque, magnitude.torque_noise())),
        ],
    )
}

/// Motion of every cylinder.
pub fn motion_table(loads: &Loads) -> Table {
    let motion = &loads.motion;
    let degrees = |values: Vec<f64>| -> Vec<Cell> {
        values.into_iter().map(|v| Cell::Number { value: v.to_degrees(), decimals: 2 }).collect()
    };
    let mut columns = vec![
        (Column::numbers("cylinder", ""), motion.iter().map(|m| whole(m.cylinder)).collect()),
        (Column::numbers("TDC", "deg"), degrees(motion.iter().map(|m| m.top_dead_centre).collect())),
        (Column::numbers("BDC", "deg"), degrees(motion.iter().map(|m| m.bottom_dead_centre).collect())),
        (Column::numbers("stroke", "mm"), own_cells(motion.iter().map(|m| 1e3 * m.stroke), 5)),
        (Column::numbers("max speed", "m/s"), own_cells(motion.iter().map(|m| m.max_speed), 4)),
        (Column::numbers("at TDC end", "m/s²"), own_cells(motion.iter().map(|m| m.max_deceleration), 5)),
        (Column::numbers("at BDC end", "m/s²"), own_cells(motion.iter().map(|m| m.max_acceleration), 5)),
        (Column::numbers("rod swing", "deg"), degrees(motion.iter().map(|m| m.max_rod_angle).collect())),
    ];
    if motion.iter().any(|m| m.firing_angle.is_some()) {
        let firing = |angle: Option<f64>| {
            angle.map_or(Cell::Empty, |a| Cell::Number { value: a.to_degrees(), decimals: 1 })
        };
        columns.push((
            Column::numbers("fires at", "deg"),
            motion.iter().map(|m| firing(m.firing_angle)).collect(),
        ));
    }
    let note = "Crank angles of the true dead centres; largest piston speed, and largest acceleration towards the crank (near TDC) \
                and away from it (near BDC).";
    Table::of_columns("motion", "Motion by cylinder", note, columns)
}

/// Articulated rods: reach, stroke and dead centres against the master's; `None` without such rods.
pub fn articulation_table(loads: &Loads) -> Option<Table> {
    let slaves: Vec<_> =
        loads.motion.iter().filter_map(|m| m.articulation.as_ref().map(|a| (m.cylinder, a))).collect();
    if slaves.is_empty() {
        return None;
    }
    let millimetres = |f: &dyn Fn(usize) -> f64| own_cells((0..slaves.len()).map(|k| 1e3 * f(k)), 5);
    let shift = |v: f64| Cell::Number { value: v.to_degrees(), decimals: 2 };
    Some(Table::of_columns(
        "articulation",
        "Articulated rods",
        "Reach is the distance from the crankpin to the slave's piston pin; the shift is of its TDC from where the crank points along the cylinder.",
        vec![
            (Column::numbers("cylinder", ""), slaves.iter().map(|s| whole(s.0)).collect()),
            (Column::numbers("master", ""), slaves.iter().map(|s| whole(s.1.master)).collect()),
            (Column::numbers("largest reach", "mm"), millimetres(&|k| slaves[k].1.max_reach)),
            (Column::numbers("smallest reach", "mm"), millimetres(&|k| slaves[k].1.min_reach)),
            (Column::numbers("stroke − master's", "mm"), millimetres(&|k| slaves[k].1.stroke_difference)),
            (
                Column::numbers("TDC shift", "deg"),
                slaves.iter().map(|s| shift(s.1.top_dead_centre_shift)).collect(),
            ),
        ],
    ))
}

/// Residual inertia of the rods and what it does; `None` where no rod has any.
pub fn rod_inertia_table(loads: &Loads) -> Option<Table> {
    let rods: Vec<_> = loads.motion.iter().filter(|m| m.residual_inertia != 0.0).collect();
    if rods.is_empty() {
        return None;
    }
    let effect = loads.parts.iter().find(|p| p.part == Part::RodInertia).map(|p| p.loads.peaks);
    let note = effect.map_or(String::new(), |peaks| {
        format!(
            "What the two end masses have too much of the rod's inertia. Over all cylinders it moves the shaft torque by up to {} N m \
             and the roll moment by up to {} N m.",
            number::short(peaks.shaft_torque.max_abs(), 3),
            number::short(peaks.roll_moment.max_abs(), 3)
        )
    });
    Some(Table::of_columns(
        "rod-inertia",
        "Residual rod inertia",
        note,
        vec![
            (Column::numbers("cylinder", ""), rods.iter().map(|m| whole(m.cylinder)).collect()),
            (
                Column::numbers("m_A a² + m_B b² − I", "kg mm²"),
                own_cells(rods.iter().map(|m| 1e6 * m.residual_inertia), 4),
            ),
        ],
    ))
}

fn whole(number: usize) -> Cell {
    Cell::Number { value: number as f64, decimals: 0 }
}

fn order_cells(orders: &[OrderLoads]) -> Vec<Cell> {
    let fractional = orders.iter().any(|o| (o.order - o.order.round()).abs() > 1e-6);
    orders.iter().map(|o| Cell::Number { value: o.order, decimals: if fractional { 2 } else { 0 } }).collect()
}

fn phase(value: Complex64, noise: f64) -> Cell {
    if value.norm() <= noise || !value.is_finite() {
        return Cell::Empty;
    }
    Cell::Number { value: number::phase_degrees(value.arg()), decimals: 1 }
}
