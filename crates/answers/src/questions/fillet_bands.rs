//! The error band of the stress of every fillet, from three meshes, mesh by mesh.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::engine_file;
use crate::questions::stress::{StressQuestion, problem, refuse_in_browser, request};
use crate::questions::studies::turn::{SoFar, Turn, torn};
use lanchester::flex::richardson::Extrapolated;
use lanchester::{FilletStudy, SurfacePlan};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The stress over the cycle, and how far its study has come.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct BandsQuestion {
    /// What is computed on each of the three meshes; its own mesh is the coarse one.
    stress: StressQuestion,
    /// Where the turn before ended; nothing for the first one.
    #[serde(default)]
    so_far: Option<SoFar>,
}

/// A turn of the study: the first one says what it costs, each of the others solves a mesh.
#[derive(Debug, Serialize, JsonSchema)]
struct BandsTurn {
    #[serde(flatten)]
    turn: Turn,
    /// What was found, with the last mesh.
    found: Option<BandsFound>,
}

/// What the stresses of the fillets tend to, with their error bands.
#[derive(Debug, Serialize, JsonSchema)]
struct BandsFound {
    /// The meshes, the coarse one first.
    meshes: [BandsMesh; 3],
    /// Fillet by fillet, along z: the largest von Mises stress over the cycle [Pa]; `null` of a sharp corner, and where the meshes have the same elements
    /// across the fillets.
    bands: Vec<Option<Extrapolated>>,
    /// Why the meshes are as fine as they are, where nobody says it.
    note: Option<String>,
}

/// One of the meshes.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
struct BandsMesh {
    /// Edge of the elements away from fillets [m].
    size: f64,
    /// Elements across the 90 degrees of a fillet.
    fillet_elements: usize,
    nodes: usize,
    unknowns: usize,
    /// Operations of its solution, which say how large its share of the study is.
    operations: f64,
}

/// What is kept from turn to turn.
#[derive(Debug, Serialize, Deserialize)]
struct Kept {
    meshes: [BandsMesh; 3],
    /// Largest stress of each fillet on the meshes that are solved [Pa].
    peaks: Vec<Vec<Option<f64>>>,
}

pub(super) fn questions(api: Api) -> Api {
    api.post(
        "/api/stress/bands",
        "A turn of the error bands of the fillets: `lanchester stress static --converge` over the cycle.",
        bands,
    )
}

fn bands(asker: &Asker, question: BandsQuestion) -> Result<BandsTurn, Problem> {
    refuse_in_browser()?;
    let BandsQuestion { stress, so_far } = question;
    let file = engine_file(&stress.text)?;
    let request = request(asker, &file, &stress)?;
    let study = FilletStudy::new(&file.engine, &request).map_err(problem)?;
    let kept = match so_far {
        None => {
            let plans = study.plans(&file.engine, &request).map_err(problem)?;
            let mesh = |k: usize| mesh_of(&study, &plans, k);
            Kept { meshes: [mesh(0), mesh(1), mesh(2)], peaks: Vec::new() }
        }
        Some(SoFar { kept, .. }) => {
            let mut kept: Kept = serde_json::from_str(&kept).map_err(|_| torn())?;
            if kept.peaks.len() > 2 {
                return Err(torn());
            }
            let traces = if request.gas { asker.studio.traces(&file.engine)? } else { Vec::new() };
            let mesh = kept.peaks.len();
            let peaks = study.peaks(mesh, &file.engine, &traces, &request, &|_| {}, &|| asker.waits());
            kept.peaks.push(peaks.map_err(problem)?);
            kept
        }
    };
    let found = match <&[_; 3]>::try_from(kept.peaks.as_slice()) {
        Ok(peaks) => {
            Some(BandsFound { meshes: kept.meshes, bands: study.bands(peaks), note: study.note.clone() })
        }
        Err(_) => None,
    };
    let all: f64 = kept.meshes.iter().map(|mesh| mesh.operations).sum();
    let own: f64 = kept.meshes.iter().take(kept.peaks.len()).map(|mesh| mesh.operations).sum();
    let text = serde_json::to_string(&kept).map_err(|_| torn())?;
    let turn = Turn { so_far: SoFar { blocks: kept.peaks.len() as u64, kept: text }, done: own / all };
    Ok(BandsTurn { turn, found })
}

fn mesh_of(study: &FilletStudy, plans: &[SurfacePlan; 3], k: usize) -> BandsMesh {
    let (options, plan) = (study.meshes[k].options, plans[k]);
    // The solution of each case reads the factor some times.
    const OF_A_CASE: f64 = 12.0;
    let cases = OF_A_CASE * plan.cases as f64 * plan.estimate.factor_entries as f64;
    BandsMesh {
        size: options.size,
        fillet_elements: options.fillet_elements,
        nodes: plan.nodes,
        unknowns: plan.estimate.unknowns,
        operations: plan.estimate.operations + cases,
    }
}
