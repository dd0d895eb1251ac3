//! Meshing and solving.

use crate::pressure::measured::TraceFile;
use crate::stress::loads::named_loads;
use crate::stress::mesh::{MeshFile, StressMesh};
use crate::stress::named_load::NamedLoads;
use crate::stress::oil::{add_films, check_films};
use crate::stress::own_mesh::own_mesh_plan;
use crate::stress::request::{
    ModesRequest, StaticRequest, StressError, StressLoad, StressStage, support_words,
};
use crate::stress::submodel::{meshed_bay, submodel};
use lanchester_flex::Material;
use lanchester_flex::case::StaticCase;
use lanchester_flex::crank_case::{BearingSurfaces, CrankLoad, CrankSupport, PinPressure, crank_support};
use lanchester_flex::crank_solve::solve_crank_watched;
use lanchester_flex::modes::{ModeKind, modes_watched};
use lanchester_flex::own_mesh::own_mesh;
use lanchester_model::{Engine, Origin};
use lanchester_report::{
    CrankModes, CrankSheet, MODES_VERSION, STATIC_STRESS_VERSION, StaticStress, StressCase, StressMaterial,
};

/// Static stress of a crankshaft; `watch` sees how far it is. `traces` holds the files that [`crate::trace_names`] names.
///
/// # Errors
/// [`StressError`] where the file says too little, the shape is not covered, or the factor needs more memory than allowed.
pub fn static_stress(
    engine: &Engine,
    traces: &[TraceFile],
    request: &StaticRequest,
    watch: &dyn Fn(StressStage),
) -> Result<StaticStress, StressError> {
    check_crankshaft(engine, &request.mesh)?;
    check_films(request)?;
    let NamedLoads { mut loads, gas, notes: of_loads } = named_loads(engine, traces, request)?;
    let of_films = add_films(engine, traces, request, &mut loads)?;
    loads.iter_mut().for_each(|own| own.load.pressure = request.pressure);
    if let Some(name) = &request.name {
        loads.iter_mut().for_each(|load| load.name = format!("{name}: {}", load.name));
    }
    let sheet = sheet(engine, &request.mesh, watch)?;
    if sheet.crank.corners.iter().all(|corner| corner.nodes.is_empty()) {
        return Err(StressError::NoFillet { crankshaft: request.mesh.crankshaft + 1 });
    }
    // Before the whole is solved, so that a bay that cannot be meshed costs nothing.
    let bay = request.submodel.map(|asked| meshed_bay(engine, request, asked, &sheet)).transpose()?;
    let cases: Vec<CrankLoad> = loads.iter().map(|own| own.load.clone()).collect();
    let estimate = |estimate: &_| watch(StressStage::Factoring(*estimate));
    let solved = solve_crank_watched(&sheet.crank, &request.support, &cases, request.solve, &estimate)?;
    let Some(solve) = solved.first().map(|case| case.solution.report) else {
        return Err(StressError::Missing { what: "load case", number: 1, there: "none".to_owned() });
    };
    let submodel = bay.map(|bay| submodel(&bay, request, &sheet, &cases, &solved, watch)).transpose()?;
    let cases = loads.into_iter().zip(solved).map(|(own, result)| StressCase {
        name: own.name,
        theta: own.theta,
        speed: own.speed,
        forces: own.forces,
        energy: result.solution.energy,
        load: result.solution.load,
        reaction: result.solution.reaction,
        loading: own.load,
        result,
    });
    let pressure = match request.pressure {
        PinPressure::Cosine => "a pressure p0 cos(a)",
        PinPressure::Uniform => "an even pressure",
        PinPressure::Film => "the pressure of its films",
    };
    let mut notes = vec![match request.support {
        _ if request.pressure == PinPressure::Film => {
            "Loads on a pin act as the pressure of its oil films; small displacements, linear elastic."
                .to_owned()
        }
        CrankSupport::Rings { .. } => format!(
            "Loads on a pin act on the outside of its ring as {pressure} over 180 deg and its whole width between the fillets; no clearance at rest; small displacements, linear \
             elastic but for the contact."
        ),
        _ => format!(
            "Loads on a pin act as {pressure} over 180 deg and its whole width between the fillets; small displacements, linear elastic."
        ),
    }];
    notes.extend(of_loads);
    notes.extend(of_films);
    if request.support == CrankSupport::Free && !matches!(request.load, StressLoad::Given { .. }) {
        notes.push(
            "Without supports the bearings carry nothing: the loads accelerate the crankshaft as a whole."
                .to_owned(),
        );
    }
    Ok(StaticStress {
        version: STATIC_STRESS_VERSION,
        sheet,
        support: support_words(&request.support),
        gas,
        solve,
        cases: cases.collect(),
        convergence: None,
        submodel,
        notes,
    })
}

/// Natural modes of a crankshaft; `watch` sees how far it is.
///
/// # Errors
/// As [`static_stress`].
pub fn crank_modes(
    engine: &Engine,
    request: &ModesRequest,
    watch: &dyn Fn(StressStage),
) -> Result<CrankModes, StressError> {
    check_crankshaft(engine, &request.mesh)?;
    let sheet = sheet(engine, &request.mesh, watch)?;
    let (case, rigid) = match &request.support {
        CrankSupport::Free => (StaticCase::default(), 6),
        support => (crank_support(&sheet.crank, &BearingSurfaces::new(&sheet.crank), support, 0.0)?, 0),
    };
    let estimate = |estimate: &_| watch(StressStage::Factoring(*estimate));
    let mut modes = modes_watched(&sheet.crank.mesh, &case, request.count + rigid, request.solve, &estimate)?;
    // Rigid motions are told in a sentence, not in rows.
    modes.modes.retain(|mode| mode.kind != ModeKind::Rigid);
    let support = match &request.support {
        CrankSupport::Free => "none; its six rigid motions are left out".to_owned(),
        support => support_words(support),
    };
    Ok(CrankModes { version: MODES_VERSION, sheet, support, modes, convergence: None })
}

/// Refuses a crankshaft that is not there.
pub(crate) fn check_crankshaft(engine: &Engine, mesh: &StressMesh) -> Result<(), StressError> {
    let count = engine.crankshafts.len();
    if mesh.crankshaft < count {
        return Ok(());
    }
    let there = if count == 1 { "one crankshaft".to_owned() } else { format!("{count} crankshafts") };
    Err(StressError::Missing { what: "crankshaft", number: mesh.crankshaft + 1, there })
}

/// The mesh with what there is to say of it.
pub(crate) fn sheet(
    engine: &Engine,
    mesh: &StressMesh,
    watch: &dyn Fn(StressStage),
) -> Result<CrankSheet, StressError> {
    let (crank, mesh) = match &mesh.own {
        None => mesh.meshed(engine)?,
        Some(MeshFile { name, text: None }) => return Err(StressError::MeshNotRead { name: name.clone() }),
        Some(MeshFile { name, text: Some(text) }) => {
            let found = own_mesh(text, &own_mesh_plan(engine, mesh.crankshaft))
                .map_err(|error| StressError::MeshFile { name: name.clone(), error: Box::new(error) })?;
            (found, mesh.clone())
        }
    };
    watch(StressStage::Meshed(crank.mesh.nodes.len(), crank.mesh.elements.len()));
    let elastic = crank.mesh.materials.first().cloned().unwrap_or_else(Material::steel);
    let given = engine.crank_material.as_ref();
    let modulus = given.and_then(|own| own.youngs_modulus());
    Ok(CrankSheet {
        engine: engine.name.clone(),
        crankshaft: mesh.crankshaft + 1,
        fillet_mass: elastic.density * crank.corners.iter().map(|corner| corner.volume()).sum::<f64>(),
        exact_mass: crank.body_mass,
        material: StressMaterial {
            elastic,
            origin: modulus.map_or(Origin::Assumed, |modulus| modulus.origin),
            yield_strength: given.and_then(|own| own.yield_strength()),
        },
        own_file: mesh.own.as_ref().map(|own| own.name.clone()),
        options: mesh.options,
        origins: mesh.origins,
        crank,
    })
}
