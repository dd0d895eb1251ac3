//! Scatter of engines with articulated rods and of engines with geared crankshafts: every sample is an engine.
use crate::scatter::{all_outputs, deviated, everything, request, tolerance, wanted};
use lanchester_mechanism::{LoadRequest, total_loads};
use lanchester_model::{Engine, Ratio};
use lanchester_study::scatter::*;
use lanchester_task::{Distribution, Extent, Tolerance, Varied};
use lanchester_testkit::gallery::gallery as engine;

/// Masters with 2, 8 and twice 6 articulated rods; crankshafts that turn opposite and the same way.
const ENGINES: [&str; 6] = ["radial-3", "radial-9", "radial-14", "square-4", "opposed-piston-3", "v6-60"];

/// Everything off, for all parts together and part by part.
fn wide(engine: &Engine) -> Vec<Tolerance> {
    let mut tolerances = everything(engine);
    for (quantity, half_width) in [
        (Varied::RodLength, 0.002),
        (Varied::CylinderAngle, 0.01),
        (Varied::Offset, 0.001),
        (Varied::ThrowAngle, 0.02),
        (Varied::CylinderPlane, 0.001),
    ] {
        tolerances.push(tolerance(quantity, half_width, Extent::Common));
    }
    for tolerance in &mut tolerances {
        tolerance.distribution = Distribution::Uniform;
    }
    tolerances
}

/// What the moving masses exert if all point one way [N].
fn scale(engine: &Engine) -> f64 {
    let masses = engine
        .cylinders
        .iter()
        .map(|c| (c.piston_mass + c.rod.small_end_mass + c.rod.big_end_mass) * engine.throws[c.throw].radius);
    masses.sum::<f64>() * engine.speed.highest.powi(2)
}

/// Largest difference of samples from the loads of the engines that they are, over the scale; its output is told too.
fn farthest_sample(engine: &Engine, tolerances: &[Tolerance], samples: u64) -> (f64, String) {
    let scattering =
        Scattering::new(request(engine.clone(), tolerances.to_vec(), samples)).expect("a scatter");
    let mut drawn = Drawn::default();
    scattering.draw(0..samples, Some(&mut drawn));
    let mut worst = (0.0, String::new());
    for sample in 0..samples as usize {
        let deviations: Vec<f64> = drawn.deviations.iter().map(|all| all[sample]).collect();
        let built = deviated(engine, tolerances, &deviations);
        for (place, output) in all_outputs().into_iter().enumerate() {
            let (got, wanted) = (drawn.outputs[place][sample], wanted(&built, output));
            let off = (got - wanted).abs() / scale(engine);
            if !(off <= worst.0) {
                worst = (off, format!("{} {}, sample {sample}: {got} {wanted}", engine.name, output.name()));
            }
        }
    }
    worst
}

#[test]
fn samples_are_the_engines_that_they_draw() {
    for name in ENGINES {
        let engine = engine(name);
        let (off, which) = farthest_sample(&engine, &wide(&engine), 16);
        println!("{off:.2e} {which}");
        // Orders beyond the last that matters are 1e-13 of the first each; the rest is rounding.
        assert!(off < 1e-12, "{off:.2e} {which}");
    }
}
