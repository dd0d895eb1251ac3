//! One bay of a crankshaft again, with more elements across its fillets than the whole can have.

use crate::stress::mesh::MOST_NODES;
use crate::stress::request::{StaticRequest, StressError, StressStage, SubmodelRequest};
use lanchester_flex::FlexError;
use lanchester_flex::crank_case::{CrankCase, CrankLoad};
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh_of_bay};
use lanchester_flex::submodel::{SolvedCrank, check_cut, solve_submodel};
use lanchester_model::Engine;
use lanchester_report::{CrankSheet, StressSubmodel, SubmodelFillet};

/// Elements across a fillet where nobody says how many and the whole has fewer; fewer than these where they are too many nodes.
const USUAL: usize = 6;

/// A bay that is meshed.
pub(crate) struct Bay {
    throw: usize,
    options: CrankMeshOptions,
    crank: CrankMesh,
}

/// Solves a bay with the displacements of the whole, under each of its loads.
pub(crate) fn submodel(
    bay: &Bay,
    request: &StaticRequest,
    sheet: &CrankSheet,
    loads: &[CrankLoad],
    cases: &[CrankCase],
    watch: &dyn Fn(StressStage),
) -> Result<StressSubmodel, StressError> {
    let Bay { throw, options, crank: bay } = bay;
    watch(StressStage::Meshed(bay.mesh.nodes.len(), bay.mesh.elements.len()));
    let whole = SolvedCrank { crank: &sheet.crank, support: &request.support, loads, cases };
    let estimate = |estimate: &_| watch(StressStage::Factoring(*estimate));
    let found = solve_submodel(whole, bay, request.solve, &estimate)?;
    let Some(solve) = found.first().map(|case| case.result.solution.report) else {
        return Err(StressError::Missing { what: "load case", number: 1, there: "none".to_owned() });
    };
    let fillets = bay.corners.iter().enumerate().filter_map(|(k, corner)| {
        let peaks = found.iter().enumerate();
        let of = peaks.filter_map(|(case, own)| Some((case, own.result.peaks.get(k)?.stress?)));
        let (case, stress) = of.max_by(|a, b| a.1.von_mises.total_cmp(&b.1.von_mises))?;
        let before = sheet.crank.corners.iter().position(|own| own.name == corner.name)?;
        let peaks = cases.iter().filter_map(|case| case.peaks.get(before)?.stress);
        let whole = peaks.max_by(|a, b| a.von_mises.total_cmp(&b.von_mises))?;
        Some(SubmodelFillet { name: corner.name.clone(), radius: corner.radius, whole, stress, case })
    });
    Ok(StressSubmodel {
        throw: *throw,
        cuts: bay.cut_planes()?,
        size: options.size,
        fillet_elements: options.fillet_elements,
        quality: bay.quality.clone(),
        solve,
        cut_difference: found.iter().map(|case| case.cut_difference).fold(0.0, f64::max),
        fillets: fillets.collect(),
    })
}

/// Meshes the bay of a throw.
pub(crate) fn meshed_bay(
    engine: &Engine,
    request: &StaticRequest,
    asked: SubmodelRequest,
    sheet: &CrankSheet,
) -> Result<Bay, StressError> {
    if let Some(own) = &request.mesh.own {
        return Err(StressError::SubmodelOfOwn { name: own.name.clone() });
    }
    check_cut(&request.support)?;
    let whole = sheet.options.fillet_elements;
    let of = |fillet_elements: usize| {
        let options = CrankMeshOptions { fillet_elements, ..sheet.options };
        let found = crank_mesh_of_bay(engine, request.mesh.crankshaft, options, asked.throw);
        found.map(|crank| Bay { throw: asked.throw, options, crank })
    };
    if let Some(count) = asked.fillet_elements {
        if count <= whole {
            return Err(StressError::CoarseSubmodel { whole, asked: count });
        }
        return Ok(of(count)?);
    }
    let most = USUAL.max(whole + 2);
    for count in (whole + 2..=most).rev().step_by(2) {
        match of(count) {
            Ok(bay) if bay.crank.mesh.nodes.len() <= MOST_NODES => return Ok(bay),
            Ok(_) | Err(FlexError::Crowded { .. }) => {}
            Err(error) => return Err(error.into()),
        }
    }
    Err(StressError::NoSubmodel { least: whole + 2, most, nodes: MOST_NODES })
}
