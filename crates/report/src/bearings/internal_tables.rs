//! Bending moments and main-bearing loads in numbers.

use crate::bearings::internal_noise::Noise;
use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, column_cells, csv_number, own_cells, push_csv_line};
use lanchester_mechanism::{BeamModel, InternalMoments, MainLoad, Peak};
use lanchester_model::Engine;

/// Planes closer than this [m] are one.
const SAME_PLANE: f64 = 1e-6;

/// What stands at plane `z` of crankshaft `index` (from 0): "throw 2", "main 3", the name of a weight.
fn what_stands_at(engine: &Engine, index: usize, z: f64, mains: &[MainLoad]) -> String {
    let here = |other: f64| (other - z).abs() < SAME_PLANE;
    let throws: Vec<usize> = (0..engine.throws.len())
        .filter(|&t| engine.throws[t].crankshaft == index && here(engine.throws[t].z))
        .map(|t| t + 1)
        .collect();
    if !throws.is_empty() {
        let word = if throws.len() == 1 { "throw" } else { "throws" };
        return format!("{word} {}", number::list(&throws));
    }
    if let Some(main) = mains.iter().find(|m| here(m.z)) {
        return format!("main {}", main.main);
    }
    if let Some(weight) = engine.counterweights.iter().find(|w| w.crankshaft == index && here(w.z)) {
        return weight.name.clone();
    }
    let rods: Vec<usize> = (0..engine.cylinders.len())
        .filter(|&c| {
            engine.throws[engine.cylinders[c].throw].crankshaft == index && here(engine.cylinders[c].z)
        })
        .map(|c| c + 1)
        .collect();
    match rods.as_slice() {
        [] => String::new(),
        [one] => format!("rod {one}"),
        more => format!("rods {}", number::list(more)),
    }
}

fn percent(case: &InternalMoments) -> String {
    format!("{} %", number::trimmed(100.0 * case.reciprocating_share, 3))
}

fn weights(case: &InternalMoments) -> &'static str {
    if case.counterweights { "with" } else { "without" }
}

/// Whether any case leaves the counterweights out: only then is their column worth its place.
fn compares_weights(cases: &[InternalMoments]) -> bool {
    cases.iter().any(|c| c.counterweights != cases[0].counterweights)
}

/// The largest bending moment and main-bearing load of every case in both models.
pub fn internal_table(engine: &Engine, cases: &[InternalMoments]) -> Table {
    let noise = Noise::of(cases);
    let several = engine.crankshafts.len() > 1;
    let mut names: [Vec<Cell>; 4] = std::array::from_fn(|_| Vec::new());
    let (mut moments, mut shears, mut mains) = (Vec::new(), Vec::new(), Vec::new());
    let (mut places, mut stands, mut pressed) = (Vec::new(), Vec::new(), Vec::new());
    for model in BeamModel::ALL {
        for case in cases {
            for shaft in &case.crankshafts {
                let beam = shaft.of(model);
                names[0].push(Cell::text(engine.crankshafts[shaft.crankshaft - 1].name.clone()));
                names[1].push(Cell::text(model.name()));
                names[2].push(Cell::text(weights(case)));
                names[3].push(Cell::text(percent(case)));
                let [moment, shear, main] = [beam.peak_moment, beam.peak_shear, beam.peak_main];
                moments.push(moment.value);
                shears.push(shear.value);
                mains.push(main.value);
                let bends = moment.value > noise.moment;
                places.push(if bends { Cell::number(1e3 * moment.z, 4) } else { Cell::Empty });
                stands.push(match bends {
                    true => Cell::text(what_stands_at(engine, shaft.crankshaft - 1, moment.z, &beam.mains)),
                    false => Cell::Empty,
                });
                pressed.push(match main.value > noise.force {
                    true => Cell::text(main_at(&beam.mains, main)),
                    false => Cell::Empty,
                });
            }
        }
    }
    let [shafts, models, with, shares] = names;
    let mut columns = Vec::with_capacity(10);
    if several {
        columns.push((Column::words("crankshaft"), shafts));
    }
    columns.push((Column::words("model"), models));
    if compares_weights(cases) {
        columns.push((Column::words("weights"), with));
    }
    columns.extend([
        (Column::words("recip."), shares),
        (Column::numbers("bending", "N m"), column_cells(moments, 5, noise.moment)),
        (Column::numbers("at z", "mm"), places),
        (Column::words("where"), stands),
        (Column::numbers("shear", "N"), column_cells(shears, 5, noise.force)),
        (Column::numbers("main load", "N"), column_cells(mains, 5, noise.force)),
        (Column::words("main"), pressed),
    ]);
    Table::of_columns(
        "internal-moments",
        "Bending of the crankshaft",
        "Largest bending moment, shear force and main-bearing load along the shaft and over the cycle, without gas; \
         recip.: share of the reciprocating forces that counts, side thrust included.",
        columns,
    )
}

fn main_at(mains: &[MainLoad], peak: Peak) -> String {
    mains.iter().find(|m| m.z == peak.z).map_or(String::new(), |m| m.main.to_string())
}

/// The largest inertia load on every main bearing, case by case.
pub fn mains_table(engine: &Engine, cases: &[InternalMoments]) -> Table {
    let noise = Noise::of(cases);
    let several = engine.crankshafts.len() > 1;
    let mut columns: Vec<(Column, Vec<Cell>)> = Vec::new();
    let shafts = || cases.first().into_iter().flat_map(|c| &c.crankshafts);
    let rows = || shafts().flat_map(|s| s.throw_by_throw.mains.iter().map(move |m| (s, m)));
    if several {
        let names = rows().map(|(s, _)| Cell::text(engine.crankshafts[s.crankshaft - 1].name.clone()));
        columns.push((Column::words("crankshaft"), names.collect()));
    }
    columns.push((Column::words("main"), rows().map(|(_, m)| Cell::text(m.main.to_string())).collect()));
    columns.push((Column::numbers("z", "mm"), own_cells(rows().map(|(_, m)| 1e3 * m.z), 4)));
    let compares = compares_weights(cases);
    for case in cases {
        let loads = case.crankshafts.iter().flat_map(|s| &s.throw_by_throw.mains).map(|m| m.largest.value);
        let head = match compares {
            true => format!("{}, {}", weights(case), percent(case)),
            false => percent(case),
        };
        columns.push((Column::numbers(head, "N"), column_cells(loads, 5, noise.force)));
    }
    Table::of_columns(
        "main-bearings",
        "Inertia loads on the main bearings",
        match compares {
            true => {
                "The largest over the cycle, throw by throw, without gas; with and without counterweights, with a share of the \
                 reciprocating forces."
            }
            false => {
                "The largest over the cycle, throw by throw, without gas; the share is that of the reciprocating forces."
            }
        },
        columns,
    )
}

/// Both tables as text.
pub fn internal_text(engine: &Engine, cases: &[InternalMoments]) -> String {
    if cases.first().is_none_or(|c| c.crankshafts.is_empty()) {
        return String::new();
    }
    format!("\n{}\n{}", internal_table(engine, cases).text(), mains_table(engine, cases).text())
}

/// Every plane along every crankshaft with the largest shear force and bending moment, unrounded, in SI units and degrees;
/// at main bearings their largest load.
pub fn internal_csv(engine: &Engine, cases: &[InternalMoments]) -> String {
    let mut out = String::with_capacity(16_384);
    let head = [
        "crankshaft",
        "model",
        "counterweights",
        "reciprocating_share",
        "z [m]",
        "at",
        "shear_behind [N]",
        "shear_theta [deg]",
        "bending_moment [N m]",
        "bending_theta [deg]",
        "main_load [N]",
        "main_theta [deg]",
    ];
    push_csv_line(&mut out, head.map(str::to_owned));
    for case in cases {
        for shaft in &case.crankshafts {
            for model in BeamModel::ALL {
                let beam = shaft.of(model);
                for station in &beam.stations {
                    let main = beam.mains.iter().find(|m| (m.z - station.z).abs() < SAME_PLANE);
                    let (shear, moment) = (station.largest_shear, station.largest_moment);
                    let mut line = vec![
                        shaft.crankshaft.to_string(),
                        model.name().to_owned(),
                        weights(case).to_owned(),
                        csv_number(case.reciprocating_share),
                        csv_number(station.z),
                        what_stands_at(engine, shaft.crankshaft - 1, station.z, &beam.mains),
                    ];
                    line.extend(
                        [shear, moment]
                            .into_iter()
                            .flat_map(|e| [e.value, e.theta.to_degrees()])
                            .map(csv_number),
                    );
                    let load = main.map(|m| [m.largest.value, m.largest.theta.to_degrees()].map(csv_number));
                    line.extend(load.unwrap_or_default());
                    push_csv_line(&mut out, line);
                }
            }
        }
    }
    out
}
