//! The largest stress of every fillet over the cycle on three meshes: what it tends to, and its error band.

use crate::pressure::measured::TraceFile;
use crate::stress::converge::Study;
use crate::stress::mesh::StressMesh;
use crate::stress::request::{StressError, StressStage};
use crate::stress::surface::{SurfacePlan, SurfaceRequest, surface_plan, surface_stress};
use lanchester_flex::FlexError;
use lanchester_flex::richardson::{Extrapolated, richardson};
use lanchester_model::Engine;

/// Three meshes of a crankshaft, the coarse one first.
#[derive(Debug, Clone, PartialEq)]
pub struct FilletStudy {
    /// The meshes.
    pub meshes: [StressMesh; 3],
    /// Why they are as fine as they are, where nobody says it.
    pub note: Option<String>,
}

impl FilletStudy {
    /// The meshes that `lanchester stress static --converge` takes.
    ///
    /// # Errors
    /// As [`surface_stress`].
    pub fn new(engine: &Engine, request: &SurfaceRequest) -> Result<FilletStudy, StressError> {
        let Study { meshes, note } = Study::of(engine, &request.mesh)?;
        Ok(FilletStudy { meshes, note })
    }

    /// What the stress over the cycle costs on each mesh.
    ///
    /// # Errors
    /// As [`surface_stress`], also where the finest mesh needs more memory than allowed: before any is solved.
    pub fn plans(&self, engine: &Engine, request: &SurfaceRequest) -> Result<[SurfacePlan; 3], StressError> {
        let [a, b, c] = &self.meshes;
        let plan = |mesh: &StressMesh| {
            surface_plan(engine, &SurfaceRequest { mesh: mesh.clone(), ..request.clone() })
        };
        let plans = [plan(a)?, plan(b)?, plan(c)?];
        let finest = plans[2].estimate;
        if finest.bytes > request.solve.memory {
            let (unknowns, entries) = (finest.unknowns, finest.factor_entries);
            let (needed, allowed) = (finest.bytes, request.solve.memory);
            return Err(FlexError::Memory { unknowns, entries, needed, allowed }.into());
        }
        Ok(plans)
    }

    /// Whether the meshes differ across the fillets: else stresses there have no band.
    pub fn refines_fillets(&self) -> bool {
        let [coarse, _, fine] = self.meshes.each_ref().map(|mesh| mesh.options.fillet_elements);
        coarse < fine
    }

    /// Largest von Mises stress of every fillet over the cycle on one of the meshes [Pa], along z; none of a sharp corner.
    ///
    /// # Errors
    /// As [`surface_stress`].
    pub fn peaks(
        &self,
        mesh: usize,
        engine: &Engine,
        traces: &[TraceFile],
        request: &SurfaceRequest,
        watch: &dyn Fn(StressStage),
        waits: &dyn Fn() -> bool,
    ) -> Result<Vec<Option<f64>>, StressError> {
        let request = SurfaceRequest { mesh: self.meshes[mesh].clone(), ..request.clone() };
        let found = surface_stress(engine, traces, &request, watch, waits)?;
        let peak = |own: &crate::stress::surface::FilletCycle| own.peak.map(|peak| peak.stress.von_mises);
        Ok(found.fillets.iter().map(peak).collect())
    }

    /// What the stresses of the three meshes tend to, fillet by fillet; none where one of them has no number, or where the meshes do not differ there.
    pub fn bands(&self, peaks: &[Vec<Option<f64>>; 3]) -> Vec<Option<Extrapolated>> {
        let sizes = self.meshes.each_ref().map(|mesh| 1.0 / mesh.options.fillet_elements as f64);
        let [coarse, middle, fine] = peaks;
        let of = |k: usize| -> Option<Extrapolated> {
            let values = [coarse, middle, fine].map(|own| own.get(k).copied().flatten());
            let [Some(a), Some(b), Some(c)] = values else { return None };
            self.refines_fillets().then(|| richardson(sizes, [a, b, c]))
        };
        (0..fine.len()).map(of).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_flex::crank_mesh::CrankMeshOptions;
    use lanchester_flex::statics::SolveOptions;

    fn single() -> Engine {
        let single = lanchester_file::template("single").expect("it is in the gallery");
        let text = lanchester_file::complete(single.text, &[], None).expect("it is completed").text;
        lanchester_file::read(&text).engine().expect("it has no mistakes")
    }

    fn request() -> SurfaceRequest {
        let mesh = StressMesh::of(None, 0, Some(0.03), Some(2), CrankMeshOptions::default());
        SurfaceRequest { mesh, speed: Some(400.0), ..SurfaceRequest::default() }
    }

    #[test]
    fn a_study_says_what_its_meshes_cost_and_refuses_what_has_no_memory() {
        let (engine, request) = (single(), request());
        let study = FilletStudy::new(&engine, &request).expect("it is meshed");
        let plans = study.plans(&engine, &request).expect("there is memory");
        assert!(plans[0].estimate.unknowns < plans[1].estimate.unknowns);
        assert!(plans[1].estimate.unknowns < plans[2].estimate.unknowns);
        let solve = SolveOptions { memory: plans[2].estimate.bytes - 1, ..request.solve };
        let refused = study.plans(&engine, &SurfaceRequest { solve, ..request });
        assert!(matches!(refused, Err(StressError::Flex(FlexError::Memory { .. }))), "{refused:?}");
    }

    #[test]
    fn stresses_that_follow_a_power_of_the_size_across_a_fillet_tend_to_its_limit() {
        let study = FilletStudy::new(&single(), &request()).expect("it is meshed");
        let on = |mesh: usize, limit: f64, order: f64| {
            let size = 1.0 / study.meshes[mesh].options.fillet_elements as f64;
            Some(limit - 3e7 * size.powf(order))
        };
        // The second one has no number on the coarse mesh.
        let peaks = [0, 1, 2].map(|k| vec![on(k, 2e8, 2.0), on(k, 1e8, 1.0).filter(|_| k > 0)]);
        let bands = study.bands(&peaks);
        let first = bands[0].expect("it has three numbers");
        assert!((first.value / 2e8 - 1.0).abs() < 1e-9, "{first:?}");
        let far = 1.25 * (first.value - first.values[2]).abs();
        assert!((first.band / far - 1.0).abs() < 1e-9, "{first:?}");
        assert_eq!(bands[1], None);
        // Meshes that do not differ across the fillets say nothing of them.
        let same = [(); 3].map(|()| study.meshes[0].clone());
        assert_eq!(FilletStudy { meshes: same, ..study }.bands(&peaks), vec![None; 2]);
    }

    #[test]
    fn a_mesh_is_solved_only_while_somebody_waits() {
        let (engine, request) = (single(), request());
        let study = FilletStudy::new(&engine, &request).expect("it is meshed");
        let gone = study.peaks(0, &engine, &[], &request, &|_| {}, &|| false);
        assert_eq!(gone, Err(StressError::Cancelled));
    }
}
