//! Computed cycles in numbers and drawings.

use crate::gas::result::{CycleResult, ExchangeResult};
use crate::kit::figure::{Figure, Panel};
use crate::kit::plot::{AnglePlot, Series};
use crate::kit::table::{Cell, Column, Table, numbers};
use crate::kit::xy_plot::{XyCurve, XyPlot};
use std::f64::consts::PI;

/// A column of a cycle over its angles.
type OverAngle = fn(&CycleResult) -> &Vec<f64>;

/// The cylinders that have a cycle: "cylinders 1, 2, 3, 4".
fn cylinders(cycle: &CycleResult) -> String {
    let numbers = cycle.cylinders.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
    let noun = if cycle.cylinders.len() == 1 { "cylinder" } else { "cylinders" };
    format!("{noun} {numbers}")
}

/// Trapped mass, residual gas, efficiencies, heat to the walls and residuals of every cycle: a row a quantity, a column a cycle.
pub fn cycle_table(cycles: &[CycleResult]) -> Table {
    let mut columns = vec![Column::words("quantity"), Column::words("unit")];
    columns.extend(cycles.iter().map(|cycle| Column::numbers(cylinders(cycle), "")));
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    let mut row = |name: &str, unit: &str, digits: i32, value: &dyn Fn(&CycleResult) -> Option<f64>| {
        let values: Vec<Option<f64>> = cycles.iter().map(value).collect();
        if values.iter().any(Option::is_some) {
            let cells =
                values.into_iter().map(|value| value.map_or(Cell::Empty, |v| Cell::number(v, digits)));
            rows.push([Cell::text(name), Cell::text(unit)].into_iter().chain(cells).collect());
        }
    };
    let of =
        |value: fn(&ExchangeResult) -> f64| move |cycle: &CycleResult| cycle.exchange.as_ref().map(value);
    row("indicated work, net", "J", 5, &|c| Some(c.work));
    row("work of compression and expansion, gross", "J", 5, &|c| Some(c.gross_work));
    row("work of the gas exchange", "J", 4, &|c| Some(c.exchange_work));
    row("mean effective pressure (IMEP), net", "bar", 4, &|c| Some(c.mean_effective_pressure / 1e5));
    row("heat released", "J", 5, &|c| Some(c.heat));
    row("heat to the walls", "J", 4, &of(|e| e.wall_heat));
    row("heat to the walls, of the heat released", "%", 3, &|c| {
        c.exchange.and_then(|e| e.wall_heat_share).map(|share| 100.0 * share)
    });
    row("temperature of the body", "K", 5, &|c| c.exchange.and_then(|e| e.body_temperature));
    row("indicated efficiency, of the energy of the fuel", "%", 4, &|c| {
        c.indicated_efficiency.map(|e| 100.0 * e)
    });
    row("thermal efficiency, of the heat released", "%", 4, &|c| c.thermal_efficiency.map(|e| 100.0 * e));
    row("volumetric efficiency", "%", 4, &of(|e| 100.0 * e.volumetric_efficiency));
    row("trapping efficiency", "%", 4, &of(|e| 100.0 * e.trapping_efficiency));
    row("trapped mass", "mg", 5, &|c| Some(1e6 * c.trapped_mass));
    row("fresh mass trapped", "mg", 5, &of(|e| 1e6 * e.fresh_mass));
    row("residual gas, of the trapped mass", "%", 4, &of(|e| 100.0 * e.residual_share));
    row("temperature at closing", "K", 4, &of(|e| e.trapped_temperature));
    row("closes, after firing top dead centre", "deg", 4, &of(|e| e.closing_angle.to_degrees()));
    row("highest temperature", "K", 4, &|c| Some(c.peak_temperature));
    row("angle of the highest temperature", "deg", 3, &|c| Some(c.peak_temperature_angle.to_degrees()));
    row("highest pressure", "bar", 4, &|c| Some(c.peak_pressure / 1e5));
    row("angle of the highest pressure", "deg", 3, &|c| Some(c.peak_pressure_angle.to_degrees()));
    row("residual of the energy", "J", 2, &of(|e| e.energy_residual));
    row("residual of the energy, of the largest term", "1", 2, &of(|e| e.energy_residual_share));
    row("residual of the mass", "mg", 2, &of(|e| 1e6 * e.mass_residual));
    row("residual of the mass, of the trapped mass", "1", 2, &of(|e| e.mass_residual_share));
    row("cycles until it repeats itself", "1", 1, &of(|e| e.cycles as f64));
    let process = cycles.first().map_or(String::new(), |cycle| cycle.process.clone());
    Table {
        id: "gas-cycle",
        title: "Cycle of the gas".to_owned(),
        note: format!(
            "Process: {process}. Residuals: what is missing from the balances of energy and mass over the last cycle."
        ),
        remark: String::new(),
        columns,
        rows,
    }
}

/// Volume, pressure, temperature, mass, heat and flows over the angle; of several cycles one after another.
pub fn cycle_angle_table(cycles: &[CycleResult]) -> Table {
    let rows: Vec<(usize, usize)> = cycles
        .iter()
        .enumerate()
        .flat_map(|(place, cycle)| (0..cycle.trace.angle.len()).map(move |k| (place, k)))
        .collect();
    let known = |list: fn(&CycleResult) -> &Vec<f64>| cycles.iter().any(|cycle| !list(cycle).is_empty());
    let column =
        |head: &str, unit: &'static str, digits: i32, scale: f64, list: fn(&CycleResult) -> &Vec<f64>| {
            known(list).then(|| {
                let value = |(place, k): &(usize, usize)| {
                    list(&cycles[*place]).get(*k).map_or(f64::NAN, |v| scale * v)
                };
                numbers(head, unit, rows.iter().map(value).collect::<Vec<_>>().into_iter(), digits)
            })
        };
    // A rate a radian is one a degree times 180/pi.
    let degree = PI / 180.0;
    let first = |(place, _): &(usize, usize)| cycles[*place].cylinders.first().copied().unwrap_or(0);
    let columns = [
        Some(numbers(
            "cylinder",
            "",
            rows.iter().map(|row| first(row) as f64).collect::<Vec<_>>().into_iter(),
            3,
        )),
        column("angle", "deg", 5, 180.0 / PI, |c| &c.trace.angle),
        column("volume", "cm^3", 6, 1e6, |c| &c.trace.volume),
        column("pressure", "bar", 6, 1e-5, |c| &c.trace.pressure),
        column("temperature", "K", 6, 1.0, |c| &c.trace.temperature),
        column("mass", "mg", 6, 1e6, |c| &c.trace.mass),
        column("heat release", "J/deg", 5, degree, |c| &c.trace.heat_release),
        column("heat to the walls", "J/deg", 5, degree, |c| &c.trace.wall_heat),
        column("intake", "mg/deg", 5, 1e6 * degree, |c| &c.trace.intake),
        column("exhaust", "mg/deg", 5, 1e6 * degree, |c| &c.trace.exhaust),
    ];
    Table::of_columns(
        "cycle-angle",
        "Cycle of the gas over the angle",
        "Angle of the own crankshaft since firing top dead centre; of cylinders that have one cycle the first is named.",
        columns.into_iter().flatten().collect(),
    )
}

/// p-V diagram in logarithms, temperature, mass and heat over the angle.
pub fn cycle_figures(cycles: &[CycleResult]) -> Vec<Figure> {
    let name = cylinders;
    let style = |k: usize| if k == 0 { 0 } else { 1 + (k - 1) % 5 };
    let figure = |id: &str, title: &str, caption: &str, panels: Vec<Panel>| Figure {
        id: id.to_owned(),
        title: title.to_owned(),
        caption: caption.to_owned(),
        panels,
        columns: 1,
    };
    let diagram = |scale: fn(f64) -> f64, units: [&'static str; 2], heads: [&'static str; 2]| {
        let curves = cycles.iter().enumerate().map(|(k, cycle)| {
            let points = cycle.trace.volume.iter().zip(&cycle.trace.pressure);
            let points: Vec<(f64, f64)> = points.map(|(v, p)| (scale(1e6 * v), scale(p / 1e5))).collect();
            let closing = points.first().copied();
            XyCurve {
                name: name(cycle),
                style: style(k),
                points: points.into_iter().chain(closing).collect(),
                dots: false,
            }
        });
        XyPlot { abscissa: heads[0], ordinate: heads[1], units, polar: None, curves: curves.collect() }
            .panel()
    };
    let over_angle = |quantity: &str, unit: &'static str, lists: &[(&str, OverAngle)], scale: f64| {
        let scaled: Vec<(String, usize, Vec<f64>)> = cycles
            .iter()
            .flat_map(|cycle| {
                lists.iter().filter(|(_, list)| !list(cycle).is_empty()).map(move |(what, list)| {
                    let name = if what.is_empty() { name(cycle) } else { format!("{what}, {}", name(cycle)) };
                    (name, 0, list(cycle).iter().map(|value| scale * value).collect())
                })
            })
            .enumerate()
            .map(|(k, (name, _, values))| (name, style(k), values))
            .collect();
        let first = cycles.first().map(|cycle| &cycle.trace.angle).filter(|_| !scaled.is_empty())?;
        let step = first.get(1).copied().unwrap_or(0.0);
        let series = scaled
            .iter()
            .map(|(name, style, values)| Series { name: name.clone(), style: *style, values })
            .collect();
        Some(AnglePlot { quantity, unit, theta: first, period: step * first.len() as f64, series }.panel())
    };
    let mut figures = vec![figure(
        "cycle-diagrams",
        "Cycle: pressure over volume",
        "Of the chamber, clearance included. In logarithms polytropes are straight lines, whose slope is the exponent.",
        vec![
            diagram(|value| value, ["cm\u{b3}", "bar"], ["Volume", "Pressure, absolute"]),
            diagram(
                f64::log10,
                ["log\u{2081}\u{2080} cm\u{b3}", "log\u{2081}\u{2080} bar"],
                ["Volume, logarithm", "Pressure, logarithm"],
            ),
        ],
    )];
    let temperature = over_angle("Temperature", "K", &[("", |c| &c.trace.temperature)], 1.0);
    figures.extend(temperature.map(|panel| {
        let caption = "Of the gas, after firing top dead centre of the cylinder.";
        figure("cycle-temperature", "Cycle: temperature", caption, vec![panel])
    }));
    let mass = over_angle("Mass in the cylinder", "kg", &[("", |c| &c.trace.mass)], 1.0);
    let flows = over_angle(
        "Mass flow",
        "kg/rad",
        &[("in through the intake", |c| &c.trace.intake), ("out through the exhaust", |c| &c.trace.exhaust)],
        1.0,
    );
    let panels: Vec<Panel> = mass.into_iter().chain(flows).collect();
    if !panels.is_empty() {
        let caption = "Mass of the gas, and what flows through intake and exhaust; negative flows go back.";
        figures.push(figure("cycle-mass", "Cycle: mass", caption, panels));
    }
    let heat = over_angle(
        "Heat",
        "J/rad",
        &[("released", |c| &c.trace.heat_release), ("to the walls", |c| &c.trace.wall_heat)],
        1.0,
    );
    figures.extend(heat.map(|panel| {
        let caption = "Heat released, and heat to piston, head and liner.";
        figure("cycle-heat", "Cycle: heat", caption, vec![panel])
    }));
    figures
}
