//! The engine at another cylinder spacing.

use crate::engine::Engine;
use crate::engine_parts::EngineParts;
use crate::fault::Fault;

impl EngineParts {
    /// Cylinder spacing [m]: the smallest distance between neighbouring throw planes, or, where all throws stand in one
    /// plane, between neighbouring cylinder planes. `None` if all of both stand in one plane.
    pub fn spacing(&self) -> Option<f64> {
        let nearest = |mut planes: Vec<f64>| {
            planes.sort_by(f64::total_cmp);
            let reach = planes.iter().fold(0.0f64, |m, z| m.max(z.abs()));
            let steps = planes.windows(2).map(|w| w[1] - w[0]);
            steps.filter(|step| *step > 1e-9 * reach).min_by(f64::total_cmp)
        };
        nearest(self.throws.iter().map(|t| t.z).collect())
            .or_else(|| nearest(self.cylinders.iter().map(|c| c.z).collect()))
    }

    /// Every z of throws, webs, main bearings, cylinders and counterweights times `factor`, about the origin. The crankshaft is no body any
    /// more and counterweights are no parts.
    pub fn stretch(&mut self, factor: f64) {
        for throw in &mut self.throws {
            throw.z *= factor;
            throw.webs.iter_mut().flatten().for_each(|z| *z *= factor);
        }
        self.cylinders.iter_mut().for_each(|c| c.z *= factor);
        for weight in &mut self.counterweights {
            weight.z *= factor;
            weight.part = None;
        }
        self.crank_body = None;
        self.crank_details = None;
        for mains in self.crankshafts.iter_mut().filter_map(|c| c.mains.as_mut()) {
            mains.iter_mut().for_each(|z| *z *= factor);
        }
    }
}

impl Engine {
    /// A copy that is stretched ([`EngineParts::stretch`]).
    ///
    /// # Errors
    /// As [`Engine::new`], where the factor is not finite, or not positive and the engine names its main bearings.
    pub fn stretched(&self, factor: f64) -> Result<Engine, Vec<Fault>> {
        self.with(|parts| parts.stretch(factor))
    }
}
