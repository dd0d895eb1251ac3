//! The engine at another cylinder spacing.

use crate::engine::Engine;

impl Engine {
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

    /// The engine with every z of throws, webs, main bearings, cylinders and counterweights times `factor`, about the origin. Its crankshaft
    /// is no body any more and its counterweights are no parts.
    pub fn stretched(&self, factor: f64) -> Engine {
        let mut stretched = self.clone();
        for throw in &mut stretched.throws {
            throw.z *= factor;
            if let Some(webs) = &mut throw.webs {
                webs.iter_mut().for_each(|z| *z *= factor);
            }
        }
        stretched.cylinders.iter_mut().for_each(|c| c.z *= factor);
        for weight in &mut stretched.counterweights {
            weight.z *= factor;
            weight.part = None;
        }
        stretched.crank_body = None;
        for mains in stretched.crankshafts.iter_mut().filter_map(|c| c.mains.as_mut()) {
            mains.iter_mut().for_each(|z| *z *= factor);
        }
        stretched
    }
}
