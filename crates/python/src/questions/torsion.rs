//! Torsional vibration of the crankshaft.

use crate::answer::{Data, Shown};
use crate::failure::Failure;
use crate::options::Options;
use crate::question::{How, Question, Run};
use lanchester::flex::crank_mesh::CrankMeshOptions;
use lanchester::flex::statics::SolveOptions;
use lanchester::report::{
    Table, TorsionResult, chain_table, critical_table, damped_mode_table, damper_table, holzer_table,
    meshed_throws_table, mode_table, shaft_order_table, shaft_table, star_table, time_table, torsion_figures,
    torsion_inertia_table, torsion_speed_table, torsion_text, tuning_table, twist_order_table,
};
use lanchester::torsion::{TuneAim, TuneFree};
use lanchester::{TorsionRequest, meshed_throws, torsion};

pub(super) const QUESTIONS: [Question; 1] =
    [Question::of::<TorsionResult>("torsion", How::Long, read_torsion)];

fn read_torsion(options: &Options<'_>) -> Result<Run, Failure> {
    let tune = [
        ("damper", None),
        ("damping", Some(TuneFree::Damping)),
        ("stiffness", Some(TuneFree::Stiffness)),
        ("both", Some(TuneFree::Both)),
    ];
    let aims = [("twist", TuneAim::Twist), ("stress", TuneAim::Stress)];
    let throws = [("ker-wilson", None), ("free", Some(false)), ("held", Some(true))];
    let held = options.word("throws", &throws)?.flatten();
    let size = options.length("size")?;
    if held.is_none() && size.is_some() {
        return Err(Failure::option(
            "`size` is that of the elements of `throws=\"free\"` and `throws=\"held\"`",
            "add throws=\"held\", or leave `size` out",
        ));
    }
    let mesh =
        CrankMeshOptions { size: size.unwrap_or(10e-3), fillet_elements: 2, ..CrankMeshOptions::default() };
    let request = TorsionRequest {
        speeds: options.speeds("speeds")?,
        highest_order: options.number("highest_order")?,
        without_gas: !options.flag("gas")?.unwrap_or(true),
        tune: options.word("tune", &tune)?,
        aim: options.word("aim", &aims)?,
        time: options.speed("check")?,
        meshed: Vec::new(),
    };
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let mut request = request.clone();
        if let Some(held) = held {
            request.meshed = meshed_throws(own.engine(), mesh, SolveOptions::default(), held, &|_| ())
                .map_err(Failure::refused)?;
        }
        let traces = if request.without_gas { &[] } else { own.traces()? };
        let found = torsion(&own.file, traces, &request).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| torsion_text(found),
                tables: |found, _| tables(found),
                figures: |found, _| torsion_figures(found),
                ..Shown::default()
            },
        ))
    }))
}

/// All that the command line can print of it.
fn tables(found: &TorsionResult) -> Vec<Table> {
    let mut tables = vec![
        torsion_inertia_table(found),
        chain_table(found),
        mode_table(found),
        damped_mode_table(found),
        critical_table(found),
        star_table(found),
        shaft_table(found),
        shaft_order_table(found),
        torsion_speed_table(found),
        twist_order_table(found),
    ];
    if !found.meshed.is_empty() {
        tables.push(meshed_throws_table(found));
    }
    tables.extend(found.holzer.iter().map(|own| holzer_table(found, own)));
    tables.extend([damper_table(found), tuning_table(found), time_table(found)].into_iter().flatten());
    tables
}
