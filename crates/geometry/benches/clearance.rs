//! How long the clearances of an in-line four with eight counterweights take, on one thread: crankcase, pistons, liners, rods.
#![allow(clippy::unwrap_used, reason = "a bench fails by panicking")]

#[allow(dead_code, reason = "what the tests use of it, and the bench does not")]
#[path = "../tests/geometry/support/hand_made.rs"]
mod hand_made;

use criterion::{Criterion, criterion_group, criterion_main};
use hand_made::{Slider, counterweight, cylinder, engine, liner, rod_envelope, skirt, throw};
use lanchester_geometry::CounterweightShape;
use lanchester_geometry::clearance::{ClearanceModel, Obstacle};
use lanchester_model::{CounterweightForm, CrankBody, Engine, Envelope};
use std::f64::consts::PI;
use std::hint::black_box;

/// Eight equal counterweights and webs of an in-line four; `skirt_length` decides whether the pistons strike them.
fn four(skirt_length: f64) -> Engine {
    let shape = CounterweightShape {
        web_radius: 0.03,
        rectangle_height: 0.02,
        shoulder_height: 0.01,
        arc_radius: 0.06,
        arc_angle: 2.0,
    };
    let mut weights = Vec::new();
    let angles = [0.0, PI, PI, 0.0];
    for (throw, angle) in angles.iter().enumerate() {
        let z = 0.088 * throw as f64;
        for (side, from) in [-0.03, 0.014].into_iter().enumerate() {
            let mut weight = counterweight(shape.outline().into(), [z + from, z + from + 0.016], None);
            let part = weight.part.as_mut().unwrap();
            part.angle = PI + angle;
            part.web = Some(2 * throw + side);
            part.form = CounterweightForm::Family(shape);
            weights.push(weight);
        }
    }
    let cylinders = (0..4).map(|at| cylinder(at, 0.0, 0.088 * at as f64)).collect();
    let mut engine = engine(cylinders, weights);
    engine = engine
        .with(|engine| {
            engine.throws =
                angles.iter().enumerate().map(|(at, a)| throw(0, *a, 0.088 * at as f64)).collect();

            engine.crank_body = Some(CrankBody {
                density: 7850.0,
                journal_diameter: 0.05,
                journal_bore: 0.0,
                pin_diameter: 0.045,
                pin_bore: 0.0,
                web_thickness: 0.014,
                web_radius: 0.03,
                pin_end_radius: 0.03,
                end_journals: [0.02; 2],
            });

            engine.envelope = Some(Envelope {
                least: Some(0.001),
                crankcase_radius: Some(0.08),
                skirt: skirt(skirt_length, Some(0.06)),
                liner: liner(0.072, 0.004),
                rod: rod_envelope(),
            });
        })
        .unwrap();
    engine
}

fn bench(criterion: &mut Criterion) {
    for (name, length) in [("clear", 0.03), ("struck by the skirts", 0.048)] {
        let engine = four(length);
        criterion.bench_function(&format!("in-line four, eight counterweights, {name}"), |b| {
            b.iter(|| ClearanceModel::new(black_box(&engine), Slider::all(&engine)).unwrap().clearances())
        });
    }
    let engine = four(0.03);
    let model = ClearanceModel::new(&engine, Slider::all(&engine)).unwrap();
    criterion.bench_function("piston over 720 angles", |b| {
        b.iter(|| model.curve(0, black_box(Obstacle::Piston { cylinder: 1 }), 720))
    });
    criterion.bench_function("largest swept radius", |b| {
        b.iter(|| model.largest_swept_radius(0, black_box([0.014, 0.03])))
    });
}

criterion_group!(benches, bench);
criterion_main!(benches);
