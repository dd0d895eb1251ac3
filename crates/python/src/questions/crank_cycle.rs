//! The crankshaft as an elastic body that moves: turning in its bearings over the cycle, and its reduced model.

use super::crankshaft::AskedMesh;
use super::crankshaft::{factors, memory};
use crate::answer::{Data, Shown};
use crate::failure::Failure;
use crate::options::Options;
use crate::question::{How, Question, Run};
use lanchester::flex::reduction::ReductionOptions;
use lanchester::flex::train::{BasisKind, BasisOptions};
use lanchester::report::{
    CrankCycle, CycleLaw, CycleSpeed, ReducedCrank, crank_cycle_figures, cycle_text, reduced_text,
};
use lanchester::{CycleRequest, crank_cycle, reduced_crank};

pub(super) const QUESTIONS: [Question; 2] = [
    Question::of::<CrankCycle>("stress_cycle", How::Long, read_cycle),
    Question::of::<ReducedCrank>("stress_reduce", How::Long, read_reduced),
];

fn read_cycle(options: &Options<'_>) -> Result<Run, Failure> {
    let mesh = AskedMesh::read(options)?;
    let words = [
        ("rigid", CycleLaw::Rigid),
        ("contact", CycleLaw::Contact),
        ("bushing", CycleLaw::Bushing),
        ("film", CycleLaw::Film),
        ("file", CycleLaw::File),
    ];
    let mut laws: Vec<CycleLaw> = Vec::new();
    for law in options.words("bearings", &words)? {
        if !laws.contains(&law) {
            laws.push(law);
        }
    }
    let instants = options.whole("instants", 32, 3600)?.unwrap_or(360);
    if !instants.is_multiple_of(8) {
        return Err(Failure::option(
            format_args!("`instants` needs a multiple of 8, got {instants}"),
            "360 are one a degree",
        ));
    }
    let damping = options.share("damping")?;
    if let Some(damping) = damping.filter(|damping| !(0.0..1.0).contains(damping)) {
        return Err(Failure::option(
            format_args!("`damping` needs a share from 0 to below 1, got {damping}"),
            "crankshafts of steel have 0.005 to 0.02",
        ));
    }
    let reductions =
        [("free-interface", BasisKind::FreeInterface), ("craig-bampton", BasisKind::CraigBampton)];
    let usual = CycleRequest::default();
    let modes = options.whole("modes", 1, 200)?;
    let request = CycleRequest {
        laws: if laws.is_empty() { usual.laws.clone() } else { laws },
        rigid_crank: options.flag("rigid_crankshaft")?.unwrap_or(false),
        tilt: options.flag("tilt")?.unwrap_or(false),
        speed: options.speed("speed")?,
        motion: match options.flag("free")?.unwrap_or(false) {
            true => CycleSpeed::Free,
            false => CycleSpeed::Constant,
        },
        gas: options.flag("gas")?.unwrap_or(true),
        basis: BasisOptions {
            kind: options.word("reduction", &reductions)?.unwrap_or_default(),
            modes: modes.map_or(usual.basis.modes, |count| count as usize),
            memory: memory(options)?,
            ..BasisOptions::default()
        },
        damping,
        instants: instants as usize,
        most_cycles: options.whole("cycles", 2, 1000)?.map_or(usual.most_cycles, |count| count as usize),
        factors: factors(options)?,
        ..usual
    };
    Ok(Box::new(move |engines, watch| {
        let own = &engines[0];
        let request = CycleRequest { mesh: mesh.of(own, 6)?, ..request.clone() };
        let traces = if request.gas { own.traces()? } else { &[] };
        let found =
            crank_cycle(own.engine(), traces, &request, &|_| watch.goes_on()).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| cycle_text(found),
                tables: |found, _| found.tables(),
                figures: |found, _| crank_cycle_figures(found),
                ..Shown::default()
            },
        ))
    }))
}

fn read_reduced(options: &Options<'_>) -> Result<Run, Failure> {
    let mesh = AskedMesh::read(options)?;
    let usual = ReductionOptions::default();
    let modes = options.whole("modes", 0, 500)?;
    let asked = ReductionOptions {
        modes: modes.map_or(usual.modes, |count| count as usize),
        memory: memory(options)?,
    };
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let found =
            reduced_crank(own.engine(), &mesh.of(own, 2)?, asked, &|_| ()).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| reduced_text(found),
                tables: |found, _| found.tables(),
                ..Shown::default()
            },
        ))
    }))
}
