//! Stress of the crankshaft over the cycle and its natural modes, on its surface.

use crate::api::Api;
use crate::asker::Asker;
use crate::base64::base64;
use crate::problem::Problem;
use crate::questions::reading::engine_file;
use crate::questions::results::positive;
use crate::state::superseded;
use lanchester::file::EngineFile;
use lanchester::flex::crank_case::{CrankSupport, PeakStress};
use lanchester::flex::crank_mesh::CrankMeshOptions;
use lanchester::flex::modes::ModeKind;
use lanchester::flex::picture::{Skin, shown_factor, skin};
use lanchester::flex::sparse::{SolveReport, make_product};
use lanchester::model::Engine;
use lanchester::{
    FilletCycle, ModesRequest, StressError, StressMesh, SurfaceRequest, SurfaceStress, crank_modes,
    surface_plan, surface_stress,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Natural modes that are found.
const MODES: usize = 10;

/// Elements across a fillet for modes where nobody says: the shape of fillets changes no frequency much.
const MODE_FILLET_ELEMENTS: usize = 2;

/// Share of the length of the crankshaft as which the largest displacement of a mode is shown at first.
const SHOWN: f64 = 0.08;

/// Time of a load case, with the stress of all nodes, over the entries of the factor [ns], as measured: it reads the factor some times.
const NANOSECONDS_OF_ENTRY: f64 = 6.0;

/// A crankshaft, how fine it is meshed, what holds it, and its speed.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct StressQuestion {
    /// The engine file.
    pub(super) text: String,
    /// Number of the crankshaft, from 1; none: 1.
    #[serde(default)]
    crankshaft: Option<usize>,
    /// Size of the elements away from fillets [m], as `--size`; none: that of the file, else 8 mm.
    #[serde(default)]
    size: Option<f64>,
    /// Elements across the 90 degrees of a fillet, as `--fillet-elements`.
    #[serde(default)]
    fillet_elements: Option<usize>,
    /// What holds it; none: its journals, for modes nothing.
    #[serde(default)]
    support: Option<Support>,
    /// With springs: stiffness at each journal in both directions [N/m].
    #[serde(default)]
    stiffness: Option<f64>,
    /// Speed of crankshaft 1 [rad/s]; none: the highest of the engine.
    #[serde(default)]
    speed: Option<f64>,
    /// Whether the gas of the file is left out.
    #[serde(default)]
    inertia_only: bool,
}

/// Supports whose solutions can be added up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Support {
    ClampedEnds,
    Journals,
    Springs,
    Free,
}

/// What an answer will cost.
#[derive(Debug, Serialize, JsonSchema)]
struct StressPlan {
    nodes: usize,
    unknowns: usize,
    /// Load cases.
    cases: usize,
    /// Bytes of matrix and factor.
    bytes: u64,
    /// Some time that it takes here [s].
    seconds: f64,
}

/// Stress of the surface of a crankshaft over the cycle. Displacement and stress at a crank angle are the sum of all fields, each with its weight there.
#[derive(Debug, Serialize, JsonSchema)]
struct StressAnswer {
    /// Speed of crankshaft 1 [rad/s].
    speed: f64,
    /// Where the pressures come from, in words; `null` where no gas acts.
    gas: Option<String>,
    /// What holds it, in words.
    support: String,
    surface: SurfaceShape,
    /// For each node of the surface the number of its fillet from 1, or 0: unsigned 16-bit numbers.
    fillet_of: String,
    /// Displacement x, y, z [m] and stress xx, yy, zz, xy, yz, zx [Pa] under unit loads.
    fields: Vec<PackedField>,
    /// Crank angles over the cycle [rad].
    theta: Vec<f64>,
    /// By crank angle the weight of each field.
    weights: Vec<Vec<f64>>,
    fillets: Vec<FilletAnswer>,
    /// Yield strength [Pa], where the material has one.
    yield_strength: Option<f64>,
    /// Crank angle at which a fillet is stressed most of all [rad].
    worst_theta: f64,
    /// Largest displacement there [m].
    displacement: f64,
    /// Elastic energy there [J].
    energy: f64,
    /// A round factor by which displacements become visible.
    factor: f64,
    solve: SolveReport,
    /// Mesh, material, loads, superposition, in words.
    notes: Vec<String>,
}

/// A fillet over the cycle.
#[derive(Debug, Serialize, JsonSchema)]
struct FilletAnswer {
    name: String,
    /// Radius [m]; 0 of a sharp corner.
    radius: f64,
    /// Largest von Mises stress at each crank angle [Pa]; empty of a sharp corner, whose stress is no number.
    curve: Vec<f64>,
    /// Crank angle of the largest [rad].
    theta: Option<f64>,
    /// The largest, solved directly.
    stress: Option<PeakStress>,
}

/// Natural modes on the surface of a crankshaft.
#[derive(Debug, Serialize, JsonSchema)]
struct ModesAnswer {
    /// What holds it, in words.
    support: String,
    surface: SurfaceShape,
    modes: Vec<ModeAnswer>,
    unknowns: usize,
    /// Mesh and material, in words.
    notes: Vec<String>,
}

/// A natural mode.
#[derive(Debug, Serialize, JsonSchema)]
struct ModeAnswer {
    /// [Hz].
    frequency: f64,
    kind: ModeKind,
    /// Shares of the kinetic energy: in the plane of throw 1, across it, turning, along the axis.
    shares: [f64; 4],
    /// `|K x - l M x|/|K x|`.
    residual: f64,
    /// Displacement x, y, z, of modal mass 1 kg.
    shape: PackedField,
    /// A round factor by which it becomes visible.
    factor: f64,
}

/// A surface of triangles, in the frame of the crankshaft.
#[derive(Debug, Serialize, JsonSchema)]
struct SurfaceShape {
    /// x, y, z of each node [m]: 32-bit floats.
    nodes: String,
    /// Three nodes of each triangle, seen from outside against the clock: unsigned 32-bit numbers.
    triangles: String,
}

/// Values at all nodes of a surface, component after component: signed 16-bit numbers, each times the scale of its component.
#[derive(Debug, Serialize, JsonSchema)]
struct PackedField {
    scales: Vec<f64>,
    values: String,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post("/api/stress/plan", "What the stress over the cycle will cost.", plan)
        .post("/api/stress", "Stress of the crankshaft's surface over the cycle.", stress)
        .post("/api/stress/modes", "Natural modes of the crankshaft: `lanchester stress modes`.", modes)
}

/// Within a browser there is neither the memory nor the time for it.
pub(super) fn refuse_in_browser() -> Result<(), Problem> {
    match cfg!(target_arch = "wasm32") {
        true => Err(Problem::refused(
            "the stress of the crankshaft by finite elements needs the program\nhint: install Lanchester and start `lanchester studio`",
        )),
        false => Ok(()),
    }
}

fn plan(asker: &Asker, question: StressQuestion) -> Result<StressPlan, Problem> {
    refuse_in_browser()?;
    let file = engine_file(&question.text)?;
    let plan = surface_plan(&file.engine, &request(asker, &file, &question)?).map_err(problem)?;
    let began = (asker.studio.clock)();
    let operations = make_product(plan.estimate.precision);
    let took = (asker.studio.clock)().saturating_sub(began).as_secs_f64();
    let factor = plan.estimate.seconds(operations / took.max(f64::MIN_POSITIVE));
    let each = NANOSECONDS_OF_ENTRY / 1e9 * plan.estimate.factor_entries as f64;
    Ok(StressPlan {
        nodes: plan.nodes,
        unknowns: plan.estimate.unknowns,
        cases: plan.cases,
        bytes: plan.estimate.bytes,
        seconds: factor + each * plan.cases as f64,
    })
}

fn stress(asker: &Asker, question: StressQuestion) -> Result<StressAnswer, Problem> {
    refuse_in_browser()?;
    let file = engine_file(&question.text)?;
    let request = request(asker, &file, &question)?;
    let traces = if request.gas { asker.studio.traces(&file.engine)? } else { Vec::new() };
    let found = surface_stress(&file.engine, &traces, &request, &|_| {}, &|| asker.waits());
    Ok(answer(found.map_err(problem)?))
}

fn modes(asker: &Asker, question: StressQuestion) -> Result<ModesAnswer, Problem> {
    refuse_in_browser()?;
    let file = engine_file(&question.text)?;
    if question.speed.is_some() || question.inertia_only {
        return Err(Problem::refused(
            "natural modes are those of the crankshaft at rest without loads\nhint: leave out speed and gas",
        ));
    }
    let usual = CrankMeshOptions { fillet_elements: MODE_FILLET_ELEMENTS, ..CrankMeshOptions::default() };
    let request = ModesRequest {
        mesh: mesh(asker, &file, &question, usual)?,
        support: support(&question, CrankSupport::Free)?,
        count: MODES,
        ..ModesRequest::default()
    };
    let found = crank_modes(&file.engine, &request, &|_| {}).map_err(problem)?;
    let mesh = &found.sheet.crank.mesh;
    let skin = skin(mesh);
    let mode = |own: &lanchester::flex::modes::Mode| {
        let at: Vec<[f32; 3]> =
            skin.nodes.iter().map(|node| own.shape[*node as usize].map(|u| u as f32)).collect();
        ModeAnswer {
            frequency: own.frequency,
            kind: own.kind,
            shares: own.shares,
            residual: own.residual,
            shape: packed(&at),
            factor: shown_factor(mesh, &own.shape, SHOWN),
        }
    };
    Ok(ModesAnswer {
        surface: shape(&skin, &mesh.nodes),
        modes: found.modes.modes.iter().map(mode).collect(),
        unknowns: found.modes.unknowns,
        notes: found.sheet.words(),
        support: found.support,
    })
}

pub(super) fn problem(error: StressError) -> Problem {
    match error {
        StressError::Cancelled => superseded(),
        error => Problem::refused(error),
    }
}

pub(super) fn request(
    asker: &Asker,
    file: &EngineFile,
    question: &StressQuestion,
) -> Result<SurfaceRequest, Problem> {
    Ok(SurfaceRequest {
        mesh: mesh(asker, file, question, CrankMeshOptions::default())?,
        support: support(question, CrankSupport::Journals)?,
        speed: positive(question.speed)?,
        gas: !question.inertia_only,
        ..SurfaceRequest::default()
    })
}

fn mesh(
    asker: &Asker,
    file: &EngineFile,
    question: &StressQuestion,
    usual: CrankMeshOptions,
) -> Result<StressMesh, Problem> {
    let number = question.crankshaft.unwrap_or(1);
    let crankshaft = number.checked_sub(1).ok_or_else(|| missing_crankshaft(&file.engine, number))?;
    let task = file.tasks.stress.as_ref();
    let mut mesh = StressMesh::of(task, crankshaft, question.size, question.fillet_elements, usual);
    if let Some(own) = &mut mesh.own {
        own.text = Some(asker.studio.files.named(&own.name, "[crank.mesh]")?.into());
    }
    Ok(mesh)
}

fn missing_crankshaft(engine: &Engine, number: usize) -> Problem {
    let there = engine.crankshafts.len();
    Problem::refused(format!(
        "crankshafts are numbered from 1 to {there}, got {number}\nhint: leave the number out for the first"
    ))
}

fn support(question: &StressQuestion, usual: CrankSupport) -> Result<CrankSupport, Problem> {
    if question.support != Some(Support::Springs) && question.stiffness.is_some() {
        return Err(Problem::refused(
            "a stiffness belongs to springs\nhint: leave it out, or hold the crankshaft by springs",
        ));
    }
    match (question.support, question.stiffness) {
        (Some(Support::Springs), Some(stiffness)) if stiffness > 0.0 && stiffness.is_finite() => {
            Ok(CrankSupport::even_springs(stiffness))
        }
        (Some(Support::Springs), got) => Err(Problem::refused(format!(
            "springs need a stiffness above 0, got {}\nhint: a main bearing in its block has some 500 kN/mm",
            got.map_or("none".to_owned(), |got| format!("{got} N/m"))
        ))),
        (Some(Support::ClampedEnds), _) => Ok(CrankSupport::ClampedEnds),
        (Some(Support::Journals), _) => Ok(CrankSupport::Journals),
        (Some(Support::Free), _) => Ok(CrankSupport::Free),
        (None, _) => Ok(usual),
    }
}

fn answer(found: SurfaceStress) -> StressAnswer {
    let mut fillet_of = vec![0u16; found.skin.nodes.len()];
    for (number, fillet) in found.fillets.iter().enumerate() {
        fillet.nodes.iter().for_each(|node| fillet_of[*node as usize] = number as u16 + 1);
    }
    let fillet = |own: FilletCycle| FilletAnswer {
        name: own.name,
        radius: own.radius,
        theta: own.peak.map(|peak| found.theta[peak.instant]),
        stress: own.peak.map(|peak| peak.stress),
        curve: own.curve,
    };
    let [instant, displacement, energy, factor] = match found.worst {
        Some(worst) => [found.theta[worst.instant], worst.displacement, worst.energy, worst.factor],
        None => [0.0, 0.0, 0.0, 1.0],
    };
    StressAnswer {
        speed: found.speed,
        gas: found.gas,
        support: found.support,
        surface: shape(&found.skin, &found.sheet.crank.mesh.nodes),
        fillet_of: base64(fillet_of.into_iter().flat_map(u16::to_le_bytes)),
        fields: found.fields.iter().map(|field| packed(field)).collect(),
        weights: found.weights,
        fillets: found.fillets.into_iter().map(fillet).collect(),
        theta: found.theta,
        yield_strength: found.sheet.material.yield_strength.map(|strength| strength.value),
        worst_theta: instant,
        displacement,
        energy,
        factor,
        solve: found.solve,
        notes: found.notes.into_iter().chain(found.sheet.words()).collect(),
    }
}

fn shape(skin: &Skin, nodes: &[[f64; 3]]) -> SurfaceShape {
    let places = skin.nodes.iter().flat_map(|node| nodes[*node as usize]);
    SurfaceShape {
        nodes: base64(places.flat_map(|x| (x as f32).to_le_bytes())),
        triangles: base64(skin.triangles.iter().flatten().flat_map(|node| node.to_le_bytes())),
    }
}

fn packed<const N: usize>(field: &[[f32; N]]) -> PackedField {
    let largest = |k: usize| field.iter().map(|values| f64::from(values[k]).abs()).fold(0.0, f64::max);
    let scales: Vec<f64> = (0..N).map(|k| largest(k) / f64::from(i16::MAX)).collect();
    let value = |k: usize, values: &[f32; N]| match scales[k] > 0.0 {
        true => (f64::from(values[k]) / scales[k]).round() as i16,
        false => 0,
    };
    let values = (0..N).flat_map(|k| field.iter().map(move |values| (k, values)));
    let bytes = values.flat_map(|(k, values)| value(k, values).to_le_bytes());
    PackedField { values: base64(bytes), scales }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::{FileState, Files};
    use crate::state::Studio;
    use lanchester::file::{complete, template};
    use lanchester::flex::crank_mesh::CrankMeshOptions;
    use lanchester::{StaticRequest, StressLoad, static_stress};
    use std::time::Duration;

    /// No files at all.
    struct NoFiles;

    impl Files for NoFiles {
        fn place(&self) -> String {
            "nowhere".to_owned()
        }

        fn names(&self) -> Vec<String> {
            Vec::new()
        }

        fn open(&self, name: &str) -> Result<FileState, Problem> {
            Err(Problem::refused(format!("no file {name}")))
        }

        fn save(&self, name: &str, _: &str, _: Option<&str>) -> Result<FileState, Problem> {
            self.open(name)
        }

        fn named(&self, name: &str, _: &str) -> Result<String, Problem> {
            Err(Problem::refused(format!("no file {name}")))
        }
    }

    fn studio() -> Studio {
        Studio::new("test".to_owned(), Box::new(NoFiles), || Duration::ZERO)
    }

    fn question() -> StressQuestion {
        let single = template("single").expect("it is in the gallery");
        let text = complete(single.text, &[], None).expect("it is completed").text;
        StressQuestion {
            text,
            crankshaft: None,
            size: Some(0.03),
            fillet_elements: Some(2),
            support: None,
            stiffness: None,
            speed: Some(400.0),
            inertia_only: false,
        }
    }

    /// Equivalent stress of the nodes of a fillet at an instant, from the numbers as they are packed.
    fn largest(found: &SurfaceStress, fillet: usize, instant: usize) -> f64 {
        let of = |node: &u32| {
            let sum =
                found.fields.iter().zip(&found.weights[instant]).fold([0.0; 6], |sum, (field, weight)| {
                    std::array::from_fn(|k| sum[k] + weight * f64::from(field[*node as usize][3 + k]))
                });
            lanchester::flex::element::Stress(sum).von_mises()
        };
        found.fillets[fillet].nodes.iter().map(of).fold(0.0, f64::max)
    }

    #[test]
    fn fillets_over_the_cycle_have_the_stress_of_the_static_case_at_their_angle() {
        let (studio, question) = (studio(), question());
        let asker = Asker::new(&studio, &|| true);
        let file = engine_file(&question.text).expect("it is an engine");
        let asked = request(&asker, &file, &question).expect("it can be asked");
        let found = surface_stress(&file.engine, &[], &asked, &|_| {}, &|| true).expect("it is solved");
        assert!(found.difference < 0.01, "{}", found.difference);
        let options = CrankMeshOptions { size: 0.03, fillet_elements: 2, ..CrankMeshOptions::default() };
        // Two angles of each fillet: that of the peak, which is solved directly, and another one, which is a sum.
        let mut instants = Vec::new();
        for (index, fillet) in found.fillets.iter().enumerate() {
            let peak = fillet.peak.expect("every corner of a typical crankshaft has a radius");
            instants.extend([(index, peak.instant), (index, (peak.instant + 250) % found.theta.len())]);
        }
        let case = StaticRequest {
            mesh: StressMesh { options, ..asked.mesh.clone() },
            load: StressLoad::Angles(instants.iter().map(|(_, instant)| found.theta[*instant]).collect()),
            speeds: vec![400.0],
            ..StaticRequest::default()
        };
        let alone = static_stress(&file.engine, &[], &case, &|_| {}).expect("it is solved");
        for ((index, instant), own) in instants.into_iter().zip(&alone.cases) {
            let fillet = &found.fillets[index];
            let wanted = own.result.peaks[index].stress.expect("it has a radius").von_mises;
            let peak = fillet.peak.expect("looked at above");
            if instant == peak.instant {
                assert!((peak.stress.von_mises / wanted - 1.0).abs() < 1e-6, "{}", fillet.name);
            }
            let sum = fillet.curve[instant];
            assert!((sum / wanted - 1.0).abs() < 0.02, "{}: {sum} {wanted}", fillet.name);
            assert!((largest(&found, index, instant) / sum - 1.0).abs() < 1e-3, "{}", fillet.name);
        }
        let answer = answer(found.clone());
        assert_eq!(answer.fields.len(), 8);
        assert_eq!(answer.weights.len(), 720);
        let worst = answer.fillets.iter().filter_map(|own| own.stress).map(|own| own.von_mises);
        assert!(worst.fold(0.0, f64::max) > 1e6 && answer.energy > 0.0);
    }

    #[test]
    fn what_nobody_waits_for_ends_and_a_spring_needs_its_stiffness() {
        let studio = studio();
        let gone = stress(&Asker::new(&studio, &|| false), question()).expect_err("nobody waits");
        assert_eq!(gone, superseded());
        let refused = |asked| plan(&Asker::new(&studio, &|| true), asked).expect_err("refused").message;
        let springs = refused(StressQuestion { support: Some(Support::Springs), ..question() });
        assert!(springs.contains("springs need a stiffness above 0"), "{springs}");
        let journals = refused(StressQuestion { stiffness: Some(5e8), ..question() });
        assert!(journals.contains("belongs to springs"), "{journals}");
        let turning = modes(&Asker::new(&studio, &|| true), question()).expect_err("it has a speed");
        assert!(turning.message.contains("at rest without loads"), "{}", turning.message);
    }

    #[test]
    fn packed_numbers_keep_four_digits() {
        let field = [[1.0f32, -2e-6], [-0.25, 1.5e-6]];
        let packed = packed(&field);
        assert_eq!(packed.scales.len(), 2);
        assert_eq!(
            packed.values,
            base64([32767i16, -8192, -32767, 24575].into_iter().flat_map(i16::to_le_bytes))
        );
    }
}
