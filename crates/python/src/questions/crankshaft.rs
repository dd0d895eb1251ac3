//! The crankshaft as a body: counterweights as parts, stress, modes, strength.

use crate::answer::{Data, Shown, figures_of, tables_of};
use crate::failure::Failure;
use crate::options::Options;
use crate::prepared::Prepared;
use crate::question::{How, Question, Run};
use lanchester::flex::crank_case::{CrankSupport, PinPressure};
use lanchester::flex::crank_mesh::CrankMeshOptions;
use lanchester::flex::sparse::Precision;
use lanchester::flex::statics::SolveOptions;
use lanchester::geometry::{Design, DesignOutcome};
use lanchester::report::{
    CrankFatigue, CrankModes, CrankRule, DesignedShape, FatigueFactors, StaticStress, clearances_table,
    counterweight_drawings, counterweight_parts_table, crank_sections_table, designed_dimensions_table,
    designed_properties_table, drawing, fatigue_text, modes_text, rule_section, rule_text,
    shaft_weight_parts_table, static_stress_text,
};
use lanchester::{
    CounterweightCheck, CounterweightDesigns, CounterweightRequest, FatigueRequest, GivenForce, LoadSource,
    ModesRequest, RuleRequest, SimulateRequest, StaticRequest, StressLoad, StressMesh, SubmodelRequest,
    check_counterweights, converged_modes, converged_stress, crank_fatigue, crank_modes, crank_rule,
    crank_rule_of_file, crank_rule_with_torsion, design_counterweights, static_stress, stress_case,
    with_counterweights, with_element_factors,
};
use std::sync::Arc;

pub(super) const QUESTIONS: [Question; 6] = [
    Question::of::<CounterweightDesigns>("counterweight_design", How::Long, read_design),
    Question::of::<CounterweightCheck>("counterweight_check", How::Long, read_check),
    Question::of::<StaticStress>("stress_static", How::Long, read_static),
    Question::of::<CrankModes>("stress_modes", How::Long, read_modes),
    Question::of::<CrankFatigue>("stress_fatigue", How::Long, read_fatigue),
    Question::of::<CrankRule>("stress_rule", How::Long, read_rule),
];

fn read_design(options: &Options<'_>) -> Result<Run, Failure> {
    let (weights, unbalance) = (options.texts("weight")?, options.unbalance("unbalance")?);
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let Some(task) = own.file.tasks.shape_task else {
            return Err(Failure::option(
                "the shapes to search are not given",
                "add a section [counterweight_design] with density, web_radius, rectangle_height, shoulder_height, arc_radius, \
                 arc_angle and thickness to the engine file",
            ));
        };
        let request = CounterweightRequest { weights: weights.clone(), unbalance, task, evolution: None };
        let found = design_counterweights(own.engine(), &request).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                tables: |found, _| {
                    let shapes = shapes(found);
                    match shapes.is_empty() {
                        true => Vec::new(),
                        false => vec![designed_properties_table(&shapes), designed_dimensions_table(&shapes)],
                    }
                },
                figures: |found, engine| {
                    let fitted = with_counterweights(engine, &designs(found), found.task.density);
                    fitted.map_or(Vec::new(), |fitted| counterweight_drawings(&fitted))
                },
                adopted: Some(adopted),
                ..Shown::default()
            },
        ))
    }))
}

/// The designs that were found, by the index of their weight.
fn designs(found: &CounterweightDesigns) -> Vec<(usize, Design)> {
    let designs = found.weights.iter().filter_map(|weight| match &weight.outcome {
        DesignOutcome::Found(best) => Some((weight.index, best.design)),
        DesignOutcome::Infeasible(_) => None,
    });
    designs.collect()
}

/// The same with the names of their weights.
fn shapes(found: &CounterweightDesigns) -> Vec<DesignedShape<'_>> {
    let shapes = found.weights.iter().filter_map(|weight| match &weight.outcome {
        DesignOutcome::Found(best) => {
            Some(DesignedShape { names: &weight.name, duty: weight.duty, design: &best.design })
        }
        DesignOutcome::Infeasible(_) => None,
    });
    shapes.collect()
}

fn adopted(found: &CounterweightDesigns, own: &Prepared, _: usize) -> Result<Arc<Prepared>, Failure> {
    let designs = designs(found);
    if designs.is_empty() {
        return Err(Failure::option(
            "no shape of these ranges has the unbalance",
            "`weights[0].outcome` tells what is in the way: widen a range or relax a limit",
        ));
    }
    let fitted = with_counterweights(own.engine(), &designs, found.task.density).map_err(Failure::refused)?;
    own.fitted(&fitted)
}

fn read_check(_: &Options<'_>) -> Result<Run, Failure> {
    Ok(Box::new(|engines, _| {
        let own = &engines[0];
        let found = check_counterweights(own.engine()).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |_, _| String::new(),
                tables: |found, engine| {
                    let mut tables = Vec::new();
                    tables.extend(counterweight_parts_table(engine));
                    tables.extend(shaft_weight_parts_table(engine));
                    tables.extend(found.crankshafts.iter().map(crank_sections_table));
                    tables.extend(found.clearances.as_ref().map(|found| clearances_table(found, true)));
                    tables
                },
                figures: |_, engine| vec![drawing(engine)],
                ..Shown::default()
            },
        ))
    }))
}

/// Which mesh is asked for; the engine file has a say in what is not.
#[derive(Clone, Copy)]
pub(super) struct AskedMesh {
    crankshaft: usize,
    size: Option<f64>,
    fillet_elements: Option<usize>,
}

impl AskedMesh {
    pub(super) fn read(options: &Options<'_>) -> Result<AskedMesh, Failure> {
        Ok(AskedMesh {
            crankshaft: options.whole("crankshaft", 0, 100)?.unwrap_or(0) as usize,
            size: options.length("size")?,
            fillet_elements: options.whole("fillet_elements", 2, 64)?.map(|count| count as usize),
        })
    }

    /// `usual`: elements across a fillet where nobody says how many.
    pub(super) fn of(self, own: &Prepared, usual: usize) -> Result<StressMesh, Failure> {
        crankshaft_of(own, self.crankshaft)?;
        let usual = CrankMeshOptions { fillet_elements: usual, ..CrankMeshOptions::default() };
        let task = own.file.tasks.stress.as_ref();
        own.mesh(StressMesh::of(task, self.crankshaft, self.size, self.fillet_elements, usual))
    }
}

/// Refuses a crankshaft that the engine has not, by its index.
fn crankshaft_of(own: &Prepared, index: usize) -> Result<(), Failure> {
    match own.engine().crankshafts.len() {
        count if index >= count => Err(Failure::option(
            format_args!("`crankshaft` needs an index from 0 to {}, got {index}", count.saturating_sub(1)),
            "indices count from 0",
        )),
        _ => Ok(()),
    }
}

fn solve(options: &Options<'_>) -> Result<SolveOptions, Failure> {
    let double = options.flag("double")?.unwrap_or(false);
    let precision = if double { Precision::Double } else { Precision::Single };
    Ok(SolveOptions { precision, memory: memory(options)?, ..SolveOptions::default() })
}

/// Bytes that matrix and factor may take.
pub(super) fn memory(options: &Options<'_>) -> Result<u64, Failure> {
    Ok(options.whole("memory", 1 << 20, 1 << 50)?.unwrap_or(8 << 30))
}

/// What lowers the fatigue limits of polished specimens.
pub(super) fn factors(options: &Options<'_>) -> Result<FatigueFactors, Failure> {
    let factor = |name: &str| match options.number(name)? {
        Some(value) if value <= 0.0 => Err(Failure::option(
            format_args!("`{name}` needs a number above 0, got {value}"),
            "1 leaves things as they are",
        )),
        value => Ok(value.unwrap_or(1.0)),
    };
    Ok(FatigueFactors {
        surface: factor("surface_factor")?,
        size: factor("size_factor")?,
        gradient: factor("gradient_factor")?,
    })
}

/// What may hold a crankshaft.
#[derive(Clone, Copy, PartialEq)]
enum Held {
    ClampedEnds,
    Journals,
    Free,
    Springs,
    Rings,
    Film,
}

fn support(options: &Options<'_>, usual: CrankSupport) -> Result<CrankSupport, Failure> {
    let words = [
        ("clamped-ends", Held::ClampedEnds),
        ("journals", Held::Journals),
        ("free", Held::Free),
        ("springs", Held::Springs),
        ("rings", Held::Rings),
        ("film", Held::Film),
    ];
    let held = options.word("support", &words)?;
    let stiffness = options.stiffness_pairs("stiffness")?;
    let (thickness, modulus) = (options.length("ring_thickness")?, options.pressure("ring_modulus")?);
    for (name, is_given, of) in [
        ("stiffness", !stiffness.is_empty(), Held::Springs),
        ("ring_thickness", thickness.is_some(), Held::Rings),
        ("ring_modulus", modulus.is_some(), Held::Rings),
    ] {
        let word = if of == Held::Springs { "springs" } else { "rings" };
        if is_given && held != Some(of) {
            return Err(Failure::option(
                format_args!("`{name}` is that of `support=\"{word}\"`"),
                format_args!("add support=\"{word}\", or leave `{name}` out"),
            ));
        }
    }
    if let Some(got) = [thickness, modulus].into_iter().flatten().find(|own| *own <= 0.0) {
        return Err(Failure::option(
            format_args!("rings need a thickness and a modulus above 0, got {got}"),
            "for example ring_thickness=\"5 mm\", ring_modulus=\"210 GPa\"",
        ));
    }
    Ok(match held {
        None => usual,
        Some(Held::ClampedEnds) => CrankSupport::ClampedEnds,
        Some(Held::Journals) => CrankSupport::Journals,
        Some(Held::Free) => CrankSupport::Free,
        Some(Held::Film) => CrankSupport::Films,
        Some(Held::Rings) => {
            CrankSupport::Rings { thickness: thickness.unwrap_or(5e-3), modulus: modulus.unwrap_or(210e9) }
        }
        Some(Held::Springs) if stiffness.is_empty() => {
            return Err(Failure::option(
                "`support=\"springs\"` needs the stiffness of each journal and direction",
                "give stiffness=\"500 kN/mm\"",
            ));
        }
        Some(Held::Springs) => CrankSupport::Springs { stiffness },
    })
}

/// Loads of a static case: forces of one's own, those of angles, or the largest ones.
fn static_load(options: &Options<'_>) -> Result<StressLoad, Failure> {
    let angles = options.angles("angle")?;
    let forces: Vec<GivenForce> = options
        .pin_forces("force")?
        .into_iter()
        .map(|(throw, radial, tangential)| GivenForce { pin: throw + 1, radial, tangential })
        .collect();
    match (forces.is_empty(), angles.as_slice()) {
        (true, []) => Ok(StressLoad::Extremes),
        (true, _) => Ok(StressLoad::Angles(angles)),
        (false, []) => Ok(StressLoad::Given { forces, angle: None }),
        (false, [angle]) => Ok(StressLoad::Given { forces, angle: Some(*angle) }),
        (false, _) => Err(Failure::option(
            "`force` beside several angles: forces of your own act at one",
            "give one angle, or leave `angle` out",
        )),
    }
}

fn read_static(options: &Options<'_>) -> Result<Run, Failure> {
    let mesh = AskedMesh::read(options)?;
    let elements = options.whole("submodel_elements", 2, 40)?.map(|count| count as usize);
    let submodel = match (options.whole("submodel", 0, 1000)?, elements) {
        (Some(throw), fillet_elements) => {
            Some(SubmodelRequest { throw: throw as usize + 1, fillet_elements })
        }
        (None, None) => None,
        (None, Some(_)) => {
            return Err(Failure::option(
                "`submodel_elements` are those of a submodel",
                "add submodel=0 for the first throw, or leave `submodel_elements` out",
            ));
        }
    };
    let request = StaticRequest {
        support: support(options, CrankSupport::Journals)?,
        load: static_load(options)?,
        speeds: options.speeds("speed")?,
        gas: options.flag("gas")?.unwrap_or(true),
        submodel,
        pressure: options
            .word(
                "pin_pressure",
                &[
                    ("cosine", PinPressure::Cosine),
                    ("uniform", PinPressure::Uniform),
                    ("film", PinPressure::Film),
                ],
            )?
            .unwrap_or_default(),
        solve: solve(options)?,
        ..StaticRequest::default()
    };
    let simulated = options.word("loads", &[("closed-form", false), ("simulation", true)])?.unwrap_or(false);
    if simulated && matches!(request.load, StressLoad::Given { .. }) {
        return Err(Failure::option(
            "`loads` has no effect on forces of your own",
            "leave out `loads`, or `force`",
        ));
    }
    let (case, converge) = (options.text("case")?, options.flag("converge")?.unwrap_or(false));
    if let Some(name) = &case {
        let others = ["force", "speed", "support", "crankshaft"];
        let angle = matches!(request.load, StressLoad::Angles(_)).then_some("angle");
        let other = angle.or_else(|| others.into_iter().find(|other| options.is_given(other)));
        if let Some(other) = other {
            return Err(Failure::option(
                format_args!("`{other}` beside `case`: the case \"{name}\" of the file has its own"),
                format_args!("leave out `{other}`, or `case`"),
            ));
        }
    }
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let tasks = &own.file.tasks;
        let mut request = StaticRequest { mesh: mesh.of(own, 6)?, ..request.clone() };
        if let Some(name) = &case {
            let found = stress_case(tasks, name).map_err(Failure::refused)?;
            let StaticRequest { gas, submodel, pressure, solve, mesh, .. } = request;
            request = StaticRequest { gas, submodel, pressure, solve, ..StaticRequest::of_case(found, mesh) };
        }
        if simulated {
            request.source = LoadSource::of_run(tasks, SimulateRequest::default());
        }
        let traces = if request.gas { own.traces()? } else { &[] };
        let found = match converge {
            true => converged_stress(own.engine(), traces, &request, &|_| ()),
            false => static_stress(own.engine(), traces, &request, &|_| ()),
        };
        let found = found.map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| static_stress_text(found),
                tables: |found, _| tables_of(found.section()),
                figures: |found, _| figures_of(found.section()),
                ..Shown::default()
            },
        ))
    }))
}

fn read_modes(options: &Options<'_>) -> Result<Run, Failure> {
    let mesh = AskedMesh::read(options)?;
    let count_modes = options.flag("check_count")?.unwrap_or(false);
    let request = ModesRequest {
        support: support(options, CrankSupport::Free)?,
        count: options.whole("count", 1, 500)?.unwrap_or(10) as usize,
        solve: SolveOptions { count_modes, ..solve(options)? },
        ..ModesRequest::default()
    };
    let converge = options.flag("converge")?.unwrap_or(false);
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let request = ModesRequest { mesh: mesh.of(own, 2)?, ..request.clone() };
        let found = match converge {
            true => converged_modes(own.engine(), &request, &|_| ()),
            false => crank_modes(own.engine(), &request, &|_| ()),
        };
        let found = found.map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| modes_text(found),
                tables: |found, _| tables_of(found.section()),
                figures: |found, _| figures_of(found.section()),
                ..Shown::default()
            },
        ))
    }))
}

fn read_fatigue(options: &Options<'_>) -> Result<Run, Failure> {
    let mesh = AskedMesh::read(options)?;
    let request = FatigueRequest {
        support: support(options, CrankSupport::Journals)?,
        speeds: options.speeds("speed")?,
        gas: options.flag("gas")?.unwrap_or(true),
        factors: factors(options)?,
        instants: options.whole("instants", 8, 3600)?.unwrap_or(72) as usize,
        solve: solve(options)?,
        ..FatigueRequest::default()
    };
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let request = FatigueRequest { mesh: mesh.of(own, 6)?, ..request.clone() };
        let traces = if request.gas { own.traces()? } else { &[] };
        let found = crank_fatigue(own.engine(), traces, &request, &|_| ()).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| fatigue_text(found),
                tables: |found, _| found.speeds.iter().map(|own| found.table(own)).collect(),
                ..Shown::default()
            },
        ))
    }))
}

fn read_rule(options: &Options<'_>) -> Result<Run, Failure> {
    let request = RuleRequest {
        crankshaft: options.whole("crankshaft", 0, 100)?.unwrap_or(0) as usize,
        speeds: options.speeds("speed")?,
        gas: options.flag("gas")?.unwrap_or(true),
        vibration: options.torques("torsional_vibration")?,
    };
    let by_elements = options.flag("finite_elements")?.unwrap_or(false);
    let torsion = options.flag("torsion")?;
    if torsion == Some(true) && !request.vibration.is_empty() {
        return Err(Failure::option(
            "`torsion=True` beside `torsional_vibration`: both give the torques of torsional vibration",
            "leave out one of the two",
        ));
    }
    let mesh = AskedMesh::read(options)?;
    let solve = SolveOptions { memory: memory(options)?, ..SolveOptions::default() };
    if !by_elements && (mesh.size.is_some() || mesh.fillet_elements.is_some() || options.is_given("memory")) {
        return Err(Failure::option(
            "`size`, `fillet_elements` and `memory` are those of finite elements",
            "add finite_elements=True, or leave them out",
        ));
    }
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        crankshaft_of(own, request.crankshaft)?;
        let traces = if request.gas { own.traces()? } else { &[] };
        let found = match torsion {
            Some(true) => crank_rule_with_torsion(&own.file, traces, &request).map_err(Failure::refused)?,
            Some(false) => crank_rule(own.engine(), traces, &request).map_err(Failure::refused)?,
            None => crank_rule_of_file(&own.file, traces, &request).map_err(Failure::refused)?,
        };
        let found = match by_elements {
            true => {
                let mesh = mesh.of(own, 6)?;
                with_element_factors(own.engine(), found, &mesh, solve, &|_| ()).map_err(Failure::refused)?
            }
            false => found,
        };
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| rule_text(found),
                tables: |found, _| {
                    rule_section(std::slice::from_ref(found)).map(tables_of).unwrap_or_default()
                },
                ..Shown::default()
            },
        ))
    }))
}
