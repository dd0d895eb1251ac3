//! The scaled problem against the shape's own integrals, derivatives and enclosures.

use super::curve::{self, Curve};
use super::problem::{Kind, Problem, SHAPE};
use super::task::DesignTask;
use lanchester_numerics::Interval;
use lanchester_numerics::{Jet, Ring};
use lanchester_shape::Point;
use lanchester_task::DesignSettings;
use lanchester_task::{DesignLimits, Range, Shoulder};

fn task() -> DesignTask {
    DesignTask {
        unbalance: 8e-3,
        least_balance: 0.9,
        most_balance: Some(1.4),
        density: 8000.0,
        web_radius: Range::new(0.01, 0.03),
        rectangle_height: Range::new(0.0, 0.03),
        shoulder: Shoulder::Height(Range::new(0.0, 0.03)),
        arc_radius: Range::new(0.03, 0.07),
        arc_angle: Range::new(0.8, 5.0),
        thickness: Range::new(0.002, 0.03),
        limits: DesignLimits {
            mass: Some(0.2),
            swept_radius: Some(0.08),
            inertia: Some(1e-3),
            half_width: Some(0.06),
            shoulder_angle: Some(Range::new(0.1, 1.2)),
            shoulder_height: None,
        },
        settings: DesignSettings::default(),
    }
}

/// Pseudo-random points of the ranges that belong to a shape of the family.
fn points(problem: &Problem, count: usize) -> Vec<[f64; SHAPE]> {
    let mut seed = 99u64;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut found = Vec::new();
    while found.len() < count {
        let x: [f64; SHAPE] =
            std::array::from_fn(|k| problem.low[k] + next() * (problem.high[k] - problem.low[k]));
        let radius = x[3] / x[4].sin() * problem.length;
        if x[3] >= x[0] && x[1] + x[2] + x[3] * (x[4] / 2.0).tan() >= x[0] && (0.03..=0.07).contains(&radius)
        {
            found.push(x);
        }
    }
    found
}

#[test]
fn scaled_quantities_are_those_of_the_outline() {
    let problem = Problem::new(&task());
    for x in points(&problem, 300) {
        let shape = problem.shape(&x);
        let (q, exact) = (problem.quantities(&x), shape.moments());
        let l = problem.length;
        // Rounding of the web's disc that both take away.
        assert!((q.area * l.powi(2) - exact.area).abs() < 1e-13 * l.powi(2));
        assert!((q.first * l.powi(3) - exact.first.x).abs() < 1e-13 * l.powi(3));
        assert!(
            (q.polar * l.powi(4) - exact.polar()).abs() < 1e-12 * l.powi(4),
            "{} {}",
            q.polar * l.powi(4),
            exact.polar()
        );
        let swept = problem.attained(&q, Kind::SweptRadius) * l;
        assert!((swept / shape.outline().farthest(Point::ORIGIN).0 - 1.0).abs() < 1e-13);
        let widest = problem.attained(&q, Kind::HalfWidth) * l;
        assert!((widest / shape.outline().bounds()[1].y - 1.0).abs() < 1e-13);
    }
}

#[test]
fn derivatives_are_finite_differences() {
    let problem = Problem::new(&task());
    let (mut jets, mut plus, mut minus) = (Vec::new(), Vec::new(), Vec::new());
    for x in points(&problem, 100) {
        let variables: [Jet<f64, SHAPE>; SHAPE] = std::array::from_fn(|k| Jet::variable(x[k], k));
        problem.terms(&problem.quantities(&variables), &problem.levels.mapped(Jet::of), None, &mut jets);
        for k in 0..SHAPE {
            let step = 1e-6;
            let moved = |by: f64| std::array::from_fn(|i| if i == k { x[i] + by } else { x[i] });
            problem.terms(&problem.quantities(&moved(step)), &problem.levels, None, &mut plus);
            problem.terms(&problem.quantities(&moved(-step)), &problem.levels, None, &mut minus);
            for ((jet, plus), minus) in jets.iter().zip(&plus).zip(&minus) {
                let difference = (plus.value - minus.value) / (2.0 * step);
                // Central differences err by step^2 and by rounding over the step.
                let scale = 1.0 + difference.abs();
                assert!(
                    (jet.value.by[k] - difference).abs() < 1e-7 * scale,
                    "{k}: {} {difference}",
                    jet.value.by[k]
                );
            }
        }
    }
}

#[test]
fn intervals_hold_values_and_derivatives() {
    let problem = Problem::new(&task());
    let (mut boxed, mut jets) = (Vec::new(), Vec::new());
    for pair in points(&problem, 200).windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let x: [Jet<Interval, SHAPE>; SHAPE] =
            std::array::from_fn(|k| Jet::variable(Interval::new(a[k].min(b[k]), a[k].max(b[k])), k));
        problem.terms(&problem.quantities(&x), &problem.levels.mapped(Jet::of), None, &mut boxed);
        for step in 0..=8u32 {
            let part = |k: usize| f64::from((step * (2 * k as u32 + 1)) % 9) / 8.0;
            let inside: [Jet<f64, SHAPE>; SHAPE] =
                std::array::from_fn(|k| Jet::variable(a[k] + part(k) * (b[k] - a[k]), k));
            problem.terms(&problem.quantities(&inside), &problem.levels.mapped(Jet::of), None, &mut jets);
            for (boxed, jet) in boxed.iter().zip(&jets) {
                let holds = |i: Interval, v: f64| v >= i.low - 1e-12 && v <= i.high + 1e-12;
                assert!(holds(boxed.value.value, jet.value.value));
                for k in 0..SHAPE {
                    assert!(holds(boxed.value.by[k], jet.value.by[k]), "derivative {k}");
                }
            }
        }
    }
}

#[test]
fn second_derivatives_hold_differences_of_the_first() {
    let problem = Problem::new(&task());
    let (mut boxed, mut here, mut there) = (Vec::new(), Vec::new(), Vec::new());
    for pair in points(&problem, 100).windows(2) {
        // A box from one point a tenth of the way to the next: the mean derivative between its corners lies within the enclosure.
        let (a, b): ([f64; SHAPE], [f64; SHAPE]) =
            (pair[0], std::array::from_fn(|k| pair[0][k] + 0.1 * (pair[1][k] - pair[0][k])));
        let x: [Curve<Interval>; SHAPE] =
            std::array::from_fn(|k| Curve::variable(Interval::new(a[k].min(b[k]), a[k].max(b[k])), k));
        problem.terms(&problem.quantities(&x), &problem.levels.mapped(Ring::of), None, &mut boxed);
        for k in 0..SHAPE {
            let at = |value: f64| -> [Jet<f64, SHAPE>; SHAPE] {
                std::array::from_fn(|i| Jet::variable(if i == k { value } else { a[i] }, i))
            };
            problem.terms(&problem.quantities(&at(a[k])), &problem.levels.mapped(Jet::of), None, &mut here);
            problem.terms(&problem.quantities(&at(b[k])), &problem.levels.mapped(Jet::of), None, &mut there);
            for ((boxed, here), there) in boxed.iter().zip(&here).zip(&there) {
                for j in 0..SHAPE {
                    let mean = (there.value.by[j] - here.value.by[j]) / (b[k] - a[k]);
                    let range = boxed.value.bend[curve::pair(j, k)];
                    assert!(mean > range.low - 1e-8 && mean < range.high + 1e-8, "{j} {k}: {mean} {range:?}");
                }
            }
        }
    }
}
