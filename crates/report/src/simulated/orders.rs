//! Orders and reactions of a simulated run: the last whole period by order, two-sided as everywhere, and the largest load of every joint.

use crate::kit::figure::Figure;
use crate::kit::number;
use crate::kit::table::{Cell, Column, Table};
use crate::simulated::beside::ClosedFormBeside;
use crate::simulated::figure::{curve, figure, panel};
use crate::simulated::period::SimulatedOrder;
use crate::simulated::result::SimulationResult;
use lanchester_multibody::MainRule;
use std::f64::consts::TAU;

/// Highest order of the table.
const SHOWN: f64 = 6.0;

/// Orders below this share of the largest of every kind are left out of the table: not rounding in print (`kit::rounding`)
/// but what the integrator's tolerances leave open.
const NOTHING: f64 = 1e-6;

/// Sizes of one order in the order of the columns.
fn sizes(one: &SimulatedOrder) -> [f64; 9] {
    [
        one.loads.force_forward.norm(),
        one.loads.force_backward.norm(),
        one.loads.couple_forward.norm(),
        one.loads.couple_backward.norm(),
        one.loads.roll_moment.norm(),
        one.loads.shaft_torque.norm(),
        number::rpm(one.speed.norm()),
        1e3 * one.motion[0].norm(),
        1e3 * one.motion[1].norm(),
    ]
}

const COLUMNS: [(&str, &str); 9] = [
    ("force forward", "N"),
    ("force backward", "N"),
    ("couple forward", "N m"),
    ("couple backward", "N m"),
    ("roll moment", "N m"),
    ("shaft torque", "N m"),
    ("speed", "rpm"),
    ("origin forward", "mm"),
    ("origin backward", "mm"),
];

/// The orders as a table; all-zero rows omitted.
pub(crate) fn orders_table(result: &SimulationResult) -> Option<Table> {
    let orders = result.orders();
    let mut largest = [0.0f64; 9];
    for one in orders.iter().filter(|one| one.loads.order > 0.0) {
        largest.iter_mut().zip(sizes(one)).for_each(|(most, size)| *most = most.max(size));
    }
    let moves = !result.run.samples.position.is_empty();
    let kept = if moves { 9 } else { 7 };
    let rows: Vec<Vec<Cell>> = orders
        .iter()
        .filter(|one| one.loads.order <= SHOWN)
        .filter(|one| {
            sizes(one)[..kept].iter().zip(largest).any(|(size, most)| *size > NOTHING * most && most > 0.0)
        })
        .map(|one| {
            let mut row = vec![Cell::number(one.loads.order, 3)];
            row.extend(sizes(one)[..kept].iter().zip(largest).map(|(size, most)| {
                Cell::number(if *size > NOTHING * most || one.loads.order == 0.0 { *size } else { 0.0 }, 4)
            }));
            row
        })
        .collect();
    if rows.is_empty() {
        return None;
    }
    let mut columns = vec![Column::numbers("order", "1")];
    columns.extend(COLUMNS[..kept].iter().map(|&(name, unit)| Column::numbers(name, unit)));
    Some(Table {
        id: "simulated-orders",
        title: "Loads on the block, torque and speed by order of the last period".into(),
        note: "Of forces and couples the parts that turn with the crank (forward) and against it (backward); of the others the amplitude. All-zero rows omitted.".into(),
        remark: String::new(),
        columns,
        rows,
    })
}

/// All orders, real and imaginary parts.
pub(super) fn order_series(result: &SimulationResult) -> Vec<(String, Vec<f64>)> {
    let names = [
        "force_forward [N]",
        "force_backward [N]",
        "couple_forward [N m]",
        "couple_backward [N m]",
        "roll_moment [N m]",
        "shaft_torque [N m]",
        "speed [rad/s]",
        "origin_forward [m]",
        "origin_backward [m]",
    ];
    let heads = names.iter().flat_map(|name| [format!("re {name}"), format!("im {name}")]);
    let heads = std::iter::once("order".to_owned()).chain(heads);
    let mut columns: Vec<(String, Vec<f64>)> = heads.map(|head| (head, Vec::new())).collect();
    for one in result.orders() {
        let loads = &one.loads;
        let all = [
            loads.force_forward,
            loads.force_backward,
            loads.couple_forward,
            loads.couple_backward,
            loads.roll_moment,
            loads.shaft_torque,
            one.speed,
            one.motion[0],
            one.motion[1],
        ];
        let values = all.iter().flat_map(|value| [value.re, value.im]);
        for (column, value) in columns.iter_mut().zip(std::iter::once(loads.order).chain(values)) {
            column.1.push(value);
        }
    }
    columns
}

/// Largest load of every joint of the cylinders over the last period.
pub(crate) fn joints_table(result: &SimulationResult) -> Option<Table> {
    let cylinders = &result.period.extremes.cylinders;
    let rows = cylinders.iter().enumerate().map(|(index, own)| {
        vec![
            Cell::text(format!("{}", index + 1)),
            Cell::number(own.side_thrust.value, 5),
            Cell::number(own.piston_pin.value, 5),
            Cell::number(own.lower_pin.value, 5),
            Cell::number(-own.along_throw.least.value, 5),
            Cell::number(own.along_throw.most.value, 5),
            Cell::number(own.across_throw.most.value, 5),
            Cell::number(own.across_throw.least.value, 5),
        ]
    });
    let names = ["side thrust", "piston pin", "lower pin", "inwards", "outwards", "driving", "braking"];
    let mut columns = vec![Column::words("cylinder")];
    columns.extend(names.map(|name| Column::numbers(name, "N")));
    (!cylinders.is_empty()).then(|| Table {
        id: "simulated-joints",
        title: "Joints: largest loads in the last period".into(),
        note: "Lower pin: crankpin or knuckle pin. The last four: extremes of the force of the rod on the crankpin, along its throw and across it, 0 for a knuckle pin.".into(),
        remark: String::new(),
        columns,
        rows: rows.collect(),
    })
}

/// Longest run that is shown as a whole over the angle [revolutions]; of a longer one its last period is.
const WHOLE: f64 = 4.0;

/// Motion of every piston, and force of every rod on its crankpin, over the crank angle.
fn over_angle(result: &SimulationResult) -> Vec<Figure> {
    let samples = &result.run.samples;
    let turns =
        samples.theta.last().zip(samples.theta.first()).map_or(0.0, |(end, start)| (end - start) / TAU);
    let range = if turns <= WHOLE { 0..samples.reactions.len() } else { result.last_period() };
    let Some(reactions) = samples.reactions.get(range.clone()) else { return Vec::new() };
    let Some(first) = reactions.first() else { return Vec::new() };
    let (abscissa, unit_of, axis) = result.abscissa(range);
    let count = first.cylinders.len();
    let of =
        |pick: &dyn Fn(&lanchester_multibody::CylinderReactions) -> f64, index: usize| -> Vec<(f64, f64)> {
            let values = reactions.iter().map(|all| pick(&all.cylinders[index]));
            axis.iter().copied().zip(values).collect()
        };
    let each = |pick: &dyn Fn(&lanchester_multibody::CylinderReactions) -> f64| -> Vec<_> {
        (0..count).map(|index| curve(&format!("cylinder {}", index + 1), index, of(pick, index))).collect()
    };
    let motion = [("position", "m"), ("speed", "m/s"), ("acceleration", "m/s²")].into_iter().enumerate();
    let motion = motion
        .map(|(k, (name, unit))| panel([abscissa, name], [unit_of, unit], None, each(&|c| c.travel[k])));
    let pistons = figure(
        "simulated-pistons",
        "Motion of the pistons",
        "Position of the piston pins along their cylinders from the crank axis, its speed and its acceleration, relative to the block.",
        motion.collect(),
    );
    let forces = [("outwards along the throw", 0), ("across the throw", 1)];
    let panels =
        forces.map(|(name, k)| panel([abscissa, name], [unit_of, "N"], None, each(&|c| c.throw_frame[k])));
    let rods = figure(
        "simulated-rod-forces",
        "Forces of the rods on their crankpins",
        "Along the throw (positive away from the crank axis) and across it (positive where it drives the crank).",
        Vec::from(panels),
    );
    vec![pistons, rods]
}

/// Polar diagrams of the main bearings by the rule of the run, and of the crankpins about their throws; those of the closed form beside them.
pub(crate) fn reaction_figures(result: &SimulationResult, closed: Option<&ClosedFormBeside>) -> Vec<Figure> {
    let Some(reactions) = result.run.samples.reactions.get(result.last_period()).filter(|all| all.len() > 2)
    else {
        return Vec::new();
    };
    let rule = MainRule::ALL.iter().position(|rule| *rule == result.main_rule).unwrap_or(0);
    // The closed form cuts the shaft at every main.
    let closed_mains = closed.filter(|closed| result.main_rule == MainRule::Cut && !closed.mains.is_empty());
    let mut panels = Vec::new();
    for (shaft, planes) in result.mains.iter().enumerate() {
        let of = |main: usize| -> Vec<(f64, f64)> {
            let loads = reactions.iter().filter_map(|all| all.rotors.get(shaft)?.mains[rule].get(main));
            loads.map(|[x, y]| (*y, *x)).collect()
        };
        let name = |main: usize| format!("{}.{}", shaft + 1, main + 1);
        if planes.len() < 2 {
            continue;
        }
        let Some(theirs) = closed_mains.and_then(|closed| closed.mains.get(shaft)) else {
            let curves = (0..planes.len()).map(|main| curve(&name(main), main, of(main)));
            panels.push(panel(["y", "x"], ["N", "N"], Some(0.0), curves.collect()));
            continue;
        };
        let reach = (0..planes.len()).flat_map(of).flat_map(|(x, y)| [x.abs(), y.abs()]).fold(0.0, f64::max);
        for main in 0..planes.len() {
            let mut curves = vec![curve("simulated", 0, of(main))];
            if let Some(own) = theirs.get(main) {
                curves.push(curve("closed form", 2, closed_path(own)));
            }
            let axes = [format!("{}, y", name(main)), format!("{}, x", name(main))];
            panels.push(panel([&axes[0], &axes[1]], ["N", "N"], Some(reach), curves));
        }
    }
    let beside = match closed {
        Some(closed) => format!(
            " Closed form: `bearings` at {} rpm, at a constant speed, without weight, in a block that stands still.",
            number::short(number::rpm(closed.speed), 5)
        ),
        None => String::new(),
    };
    let mut figures = over_angle(result);
    if !panels.is_empty() {
        let caption = format!(
            "Force of the journals on their bearings in the last period, axes of the block, by the rule `{}`.{}",
            result.main_rule.name(),
            if closed_mains.is_some() { &beside } else { "" }
        );
        figures.push(figure("simulated-main-bearings", "Main bearings", &caption, panels));
    }
    let pins = |index: usize| -> Vec<(f64, f64)> {
        reactions
            .iter()
            .map(|all| all.cylinders[index].throw_frame)
            .map(|[along, across]| (across, along))
            .collect()
    };
    let turns = |path: &[(f64, f64)]| path.iter().any(|point| *point != (0.0, 0.0));
    let drawn: Vec<usize> = (0..reactions[0].cylinders.len()).filter(|index| turns(&pins(*index))).collect();
    if drawn.is_empty() {
        return figures;
    }
    let theirs =
        |index: usize| closed.and_then(|closed| closed.crankpins.get(index)).filter(|own| !own.is_empty());
    let heads = ["across the throw", "along the throw"];
    let caption = "Force of the rods on their crankpins in the last period, seen from the throw: upwards away from the crank axis, to the right where it drives the crank.";
    let has_closed = drawn.iter().any(|index| theirs(*index).is_some());
    let panels = if has_closed {
        let reach = drawn
            .iter()
            .flat_map(|index| pins(*index))
            .flat_map(|(x, y)| [x.abs(), y.abs()])
            .fold(0.0, f64::max);
        let of = |index: usize| {
            let mut curves = vec![curve("simulated", 0, pins(index))];
            curves.extend(theirs(index).map(|own| curve("closed form", 2, closed_path(own))));
            let axes = heads.map(|head| format!("cylinder {}, {head}", index + 1));
            panel([&axes[0], &axes[1]], ["N", "N"], Some(reach), curves)
        };
        drawn.into_iter().map(of).collect()
    } else {
        let curves =
            drawn.iter().map(|index| curve(&format!("cylinder {}", index + 1), *index, pins(*index)));
        vec![panel(heads, ["N", "N"], Some(0.0), curves.collect())]
    };
    let caption = if has_closed { format!("{caption}{beside}") } else { caption.to_owned() };
    figures.push(figure("simulated-crankpins", "Crankpins", &caption, panels));
    figures
}

/// A path of the closed form as it is drawn: the first part upwards, and back to its start.
fn closed_path(path: &[[f64; 2]]) -> Vec<(f64, f64)> {
    path.iter().chain(path.first()).map(|[up, right]| (*right, *up)).collect()
}
