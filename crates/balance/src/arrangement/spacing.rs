//! The engine at another cylinder spacing.

use lanchester_model::Engine;

/// Cylinder spacing [m]: the smallest distance between neighbouring throw planes, or, where all throws stand in one
/// plane, between neighbouring cylinder planes. `None` if all of both stand in one plane.
pub(crate) fn spacing_of(engine: &Engine) -> Option<f64> {
    let nearest = |mut planes: Vec<f64>| {
        planes.sort_by(f64::total_cmp);
        let reach = planes.iter().fold(0.0f64, |m, z| m.max(z.abs()));
        let steps = planes.windows(2).map(|w| w[1] - w[0]);
        steps.filter(|step| *step > 1e-9 * reach).min_by(f64::total_cmp)
    };
    nearest(engine.throws.iter().map(|t| t.z).collect())
        .or_else(|| nearest(engine.cylinders.iter().map(|c| c.z).collect()))
}

/// The engine with every z of throws, webs, main bearings, cylinders and counterweights times `factor`, about the origin. Its crankshaft
/// is no body any more and its counterweights are no parts.
pub(crate) fn scaled_along(engine: &Engine, factor: f64) -> Engine {
    let mut scaled = engine.clone();
    for throw in &mut scaled.throws {
        throw.z *= factor;
        if let Some(webs) = &mut throw.webs {
            webs.iter_mut().for_each(|z| *z *= factor);
        }
    }
    scaled.cylinders.iter_mut().for_each(|c| c.z *= factor);
    for weight in &mut scaled.counterweights {
        weight.z *= factor;
        weight.part = None;
    }
    scaled.crank_body = None;
    for mains in scaled.crankshafts.iter_mut().filter_map(|c| c.mains.as_mut()) {
        mains.iter_mut().for_each(|z| *z *= factor);
    }
    scaled
}

/// Lowest and highest of `planes` [m]; 0, 0 if there are none.
pub(crate) fn extent(planes: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] =
        planes.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)]);
    if low.is_finite() { [low, high] } else { [0.0, 0.0] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arrangement::sample::in_line;

    #[test]
    fn spacing_is_that_of_throws_else_of_cylinders() {
        let mut engine = in_line(&[0.0, 120.0, 240.0]);
        assert!((spacing_of(&engine).unwrap() - 0.088).abs() < 1e-12);
        let wide = scaled_along(&engine, 1.5);
        assert!(
            (spacing_of(&wide).unwrap() - 0.132).abs() < 1e-12 && wide.cylinders[0].z == wide.throws[0].z
        );
        engine.throws.iter_mut().for_each(|t| t.z = 0.0);
        assert!((spacing_of(&engine).unwrap() - 0.088).abs() < 1e-12);
        assert_eq!(spacing_of(&scaled_along(&engine, 0.0)), None);
    }
}
