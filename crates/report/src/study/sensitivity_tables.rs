//! Sensitivities: derivatives, one input at a time, and shares of the variance, output by output.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, push_csv_line, words};
use lanchester_study::sensitivity::{
    Effect, Measure, OutputSensitivity, Quantity, Sensitivity, Slope, VariedInput, Weights,
};
use lanchester_task::Varied;

/// Effects below this share of the largest one of an output are none: not rounding in print (`kit::rounding`) but what is
/// worth a row.
const NOTHING: f64 = 1e-6;

/// Slopes that make less than this share of a change are none.
const FLAT: f64 = 1e-4;

/// What an input is called: its quantity, and the part where every part varies by itself.
pub fn input_name(varied: &VariedInput) -> String {
    match varied.input.part {
        None => varied.input.quantity.name().to_owned(),
        Some(part) => format!("{} {}", varied.input.quantity.name(), part + 1),
    }
}

/// Unit in which what is so measured is shown, behind what its SI value is multiplied by.
pub fn measure_unit(measure: Measure) -> (f64, &'static str) {
    match measure {
        Measure::Mass => (1e3, "g"),
        Measure::Length | Measure::Place => (1e3, "mm"),
        Measure::Angle => (1f64.to_degrees(), "deg"),
        Measure::Unbalance => (1e6, "g mm"),
        Measure::Inertia => (1e6, "kg mm2"),
        Measure::BodyMass => (1.0, "kg"),
        Measure::BodyInertia => (1.0, "kg m2"),
        Measure::Speed => (number::rpm(1.0), "rpm"),
        Measure::Factor => (100.0, "%"),
    }
}

fn shown(varied: &VariedInput, value: f64) -> String {
    let (factor, unit) = measure_unit(varied.input.quantity.measure());
    format!("{} {unit}", number::trimmed(factor * value, 4))
}

/// Nominal value of an input, where it has one, and how far it goes either way: "46.4 mm ± 0.464 mm".
pub fn input_range(varied: &VariedInput) -> String {
    let range = format!("± {}", shown(varied, varied.half_width));
    match varied.nominal {
        Some(nominal) => format!("{} {range}", shown(varied, nominal)),
        None => range,
    }
}

/// Largest change of an output by an input.
fn change(own: &OutputSensitivity, effect: &Effect) -> f64 {
    let ends = [effect.below, effect.above].into_iter().flatten();
    ends.map(|value| (value - own.nominal).abs()).fold(0.0, f64::max)
}

/// Places of the inputs, the strongest first, without those that do nothing.
pub(crate) fn strongest(own: &OutputSensitivity) -> Vec<usize> {
    let changes: Vec<f64> = own.effects.iter().map(|effect| change(own, effect)).collect();
    let largest = changes.iter().copied().fold(0.0f64, f64::max);
    let mut places: Vec<usize> =
        (0..changes.len()).filter(|&k| changes[k] > NOTHING * largest.max(own.nominal.abs())).collect();
    places.sort_by(|&a, &b| changes[b].total_cmp(&changes[a]));
    places
}

/// Whether an output grows alike whichever way the input goes.
fn is_either_way(slope: Slope) -> bool {
    slope.up == -slope.down || (slope.up + slope.down).abs() <= FLAT * slope.up.abs().min(f64::MAX)
}

/// One table for each output that any input changes.
pub fn sensitivity_tables(found: &Sensitivity) -> Vec<Table> {
    let outputs = found.outputs.iter().enumerate();
    outputs
        .filter(|(_, own)| !strongest(own).is_empty())
        .map(|(place, own)| table(found, place, own))
        .collect()
}

fn table(found: &Sensitivity, place: usize, own: &OutputSensitivity) -> Table {
    let order = strongest(own);
    let input = |k: &usize| &found.inputs[*k];
    let effect = |k: &usize| &own.effects[*k];
    let numbers = |header: &str, unit: &'static str, digits: i32, value: &dyn Fn(&usize) -> Option<f64>| {
        let cell = |value: f64| match value.is_finite() {
            true => Cell::number(value, digits),
            false => Cell::Text("leaps".to_owned()),
        };
        let cells = order.iter().map(|k| value(k).map_or(Cell::Empty, cell));
        (Column::numbers(header, unit), cells.collect::<Vec<_>>())
    };
    let per = |k: &usize| {
        let (_, unit) = measure_unit(input(k).input.quantity.measure());
        let slope = effect(k).slope;
        let sides = match () {
            () if slope.up == slope.down => "",
            () if is_either_way(slope) => ", either way",
            () => ", upwards",
        };
        format!("per {unit}{sides}")
    };
    let output = own.unit;
    let percent = |value: f64| Some(100.0 * value / own.nominal.abs()).filter(|share| share.is_finite());
    let mut columns = vec![
        words("input", order.iter().map(|k| input_name(input(k)))),
        words(
            "nominal",
            order.iter().map(|k| input(k).nominal.map_or(String::new(), |value| shown(input(k), value))),
        ),
        words("plus or minus", order.iter().map(|k| shown(input(k), input(k).half_width))),
        numbers("derivative", output, 4, &|k| {
            let slope = effect(k).slope.up;
            // A peak that grows either way by what bends alone: its slope is the rounding of its place.
            let is_flat = slope.abs() * input(k).half_width <= FLAT * change(own, effect(k));
            Some(if is_flat { 0.0 } else { slope / measure_unit(input(k).input.quantity.measure()).0 })
        }),
        words("", order.iter().map(per)),
    ];
    let parts = |k: &usize| effect(k).slope.up != effect(k).slope.down && !is_either_way(effect(k).slope);
    if order.iter().any(parts) {
        columns.push(numbers("downwards", output, 4, &|k| {
            let factor = measure_unit(input(k).input.quantity.measure()).0;
            parts(k).then(|| effect(k).slope.down / factor)
        }));
    }
    columns.extend([
        numbers("at the lower end", output, 5, &|k| effect(k).below),
        numbers("at the upper end", output, 5, &|k| effect(k).above),
    ]);
    let worth_it = own.nominal.abs() > 1e-3 * order.first().map_or(0.0, |k| change(own, effect(k)));
    if worth_it {
        columns.push(numbers("change", "%", 3, &|k| percent(change(own, effect(k)))));
    }
    if let Some(sobol) = &found.sobol {
        columns.push(numbers("alone", "%", 3, &|k| Some(100.0 * sobol.indices[place][*k].first.max(0.0))));
        columns.push(numbers("std. error", "%", 2, &|k| Some(100.0 * sobol.indices[place][*k].first_error)));
        columns.push(numbers("with others", "%", 3, &|k| Some(100.0 * sobol.indices[place][*k].total)));
        columns.push(numbers("its error", "%", 2, &|k| Some(100.0 * sobol.indices[place][*k].total_error)));
    }
    let title = format!(
        "{}: {}{} at {} rpm",
        number::capital(&own.name),
        number::terminal(own.nominal, number::decimals(own.nominal.abs(), 5)),
        if output.is_empty() { String::new() } else { format!(" {output}") },
        number::terminal(number::rpm(found.speed), 0)
    );
    Table::of_columns("sensitivity", title, idle_words(found, own), columns)
}

/// What changes nothing, and what the shares mean.
fn idle_words(found: &Sensitivity, own: &OutputSensitivity) -> String {
    let order = strongest(own);
    let idle: Vec<String> = (0..found.inputs.len())
        .filter(|k| !order.contains(k))
        .map(|k| input_name(&found.inputs[k]))
        .collect();
    let mut note = match idle.len() {
        0 => String::new(),
        _ => format!("Without effect: {}.", idle.join(", ")),
    };
    if let Some(sobol) = &found.sobol {
        let others = if note.is_empty() { "" } else { " " };
        note += &format!(
            "{others}Shares of the variance with all inputs anywhere within their ranges, from {} draws: what would vanish if one were known, and what would be left if all others were.",
            number::terminal((sobol.samples - sobol.impossible) as f64, 0)
        );
    }
    note
}

/// What the counterweights do, where something varies that they could follow.
fn weights_words(found: &Sensitivity) -> Option<&'static str> {
    let moves = |quantity: Quantity| {
        use Varied::{BigEndMass, CrankRadius, RodCentre, ThrowAngle, ThrowUnbalance};
        let Quantity::Part(varied) = quantity else { return false };
        matches!(varied, BigEndMass | CrankRadius | RodCentre | ThrowAngle | ThrowUnbalance)
    };
    let has_weights = found.counterweights > 0;
    (has_weights && found.inputs.iter().any(|varied| moves(varied.input.quantity))).then_some(match found.weights {
        Weights::Fixed => "Counterweights stay as they are while throws and masses vary.",
        Weights::Follow => "Counterweights keep their share of the rotating unbalance of their throw, and their direction from it.",
    })
}

/// The sensitivities for a terminal.
pub fn sensitivity_text(found: &Sensitivity) -> String {
    let mut out = format!("{}\n", found.engine);
    if let Some(words) = weights_words(found) {
        out += &format!("{words}\n");
    }
    for table in sensitivity_tables(found) {
        out += &format!("\n{}", table.noted_text());
    }
    let still: Vec<String> =
        found.outputs.iter().filter(|own| strongest(own).is_empty()).map(|own| own.name.clone()).collect();
    if !still.is_empty() {
        out += &format!("\nNo input changes: {}.\n", still.join(", "));
    }
    if let Some(sobol) = found.sobol.as_ref().filter(|sobol| sobol.impossible > 0) {
        out += &format!(
            "\n{} of {} draws have an invalid geometry and were left out.\n",
            sobol.impossible, sobol.samples
        );
    }
    out
}

/// Every number: one row for each output and input.
pub fn sensitivity_csv(found: &Sensitivity) -> String {
    let mut out = String::from(
        "output,unit,output nominal,input,input nominal [SI],plus or minus [SI],derivative up [SI],derivative down [SI],at the lower end,at the upper end,first-order share,standard error of the first-order share,total share,standard error of the total share\n",
    );
    let optional = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:e}"));
    for (place, own) in found.outputs.iter().enumerate() {
        for (k, effect) in own.effects.iter().enumerate() {
            let index = found.sobol.as_ref().map(|sobol| sobol.indices[place][k]);
            let input = &found.inputs[k];
            let cells = [
                own.name.clone(),
                own.unit.to_owned(),
                format!("{:e}", own.nominal),
                input_name(input),
                optional(input.nominal),
                format!("{:e}", input.half_width),
                format!("{:e}", effect.slope.up),
                format!("{:e}", effect.slope.down),
                optional(effect.below),
                optional(effect.above),
                optional(index.map(|index| index.first)),
                optional(index.map(|index| index.first_error)),
                optional(index.map(|index| index.total)),
                optional(index.map(|index| index.total_error)),
            ];
            push_csv_line(&mut out, cells);
        }
    }
    out
}
