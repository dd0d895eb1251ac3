//! Motions that the mounts do not hold, in words.

use crate::mounts::spring::Spring;
use crate::mounts::symmetric::symmetric_eigen;
use lanchester_model::Mount;
use nalgebra::{DMatrix, Matrix6, Vector3};

/// Stiffness below this share of the largest counts as none, with rotations measured at the mounts.
const NOT_HELD: f64 = 1e-9;

/// Distances and directions below this share of the mounts' spread count as none.
const NEAR: f64 = 1e-4;

/// A motion of the block that moves no mount where it is stiff, named; `None` if there is none.
pub(crate) fn free_motion(places: &[Mount], mounts: &[Spring], centre: [f64; 3]) -> Option<String> {
    let at: Vec<Vector3<f64>> = places.iter().map(|m| Vector3::new(m.x, m.y, m.z)).collect();
    let middle = at.iter().sum::<Vector3<f64>>() / at.len() as f64;
    let spread = at.iter().map(|p| (p - middle).norm()).fold(0.0, f64::max);
    let unit = if spread > 0.0 { spread } else { 1.0 };
    // Stiffness about the middle of the mounts, rotations times their spread.
    let from_centre = middle - Vector3::from(centre);
    let mut to_centre = Matrix6::identity();
    to_centre.fixed_view_mut::<3, 3>(0, 3).copy_from(&(from_centre.cross_matrix() / unit));
    for k in 3..6 {
        to_centre[(k, k)] = 1.0 / unit;
    }
    let mut stiffness = Matrix6::zeros();
    for mount in mounts {
        stiffness += to_centre.transpose() * mount.on_block(mount.spring.stiffness) * to_centre;
    }
    let pairs = symmetric_eigen(&stiffness);
    let largest = pairs.iter().map(|(value, _)| value.abs()).fold(0.0, f64::max);
    let twists: Vec<_> = pairs
        .iter()
        .filter(|(value, _)| *value <= NOT_HELD * largest)
        .map(|(_, twist)| (twist.fixed_rows::<3>(0).into_owned(), twist.fixed_rows::<3>(3) / unit))
        .collect();
    if twists.is_empty() {
        return None;
    }
    Some(name(places, &at, middle, unit, &twists))
}

/// The twists (displacement of `middle`, rotation) in words.
fn name(
    places: &[Mount],
    at: &[Vector3<f64>],
    middle: Vector3<f64>,
    unit: f64,
    twists: &[(Vector3<f64>, Vector3<f64>)],
) -> String {
    // Rotations among the free motions: those that are left are slides.
    let rotations = DMatrix::from_fn(3, twists.len(), |i, k| twists[k].1[i] * unit);
    let svd = rotations.svd(true, true);
    let turns = svd.singular_values.iter().filter(|&&s| s > NEAR).count();
    let mixed = svd.v_t.as_ref().expect("invariant: asked for");
    if twists.len() > turns {
        // A combination without rotation.
        let weights = null_combination(mixed, turns, twists.len());
        let slide: Vector3<f64> = twists.iter().zip(&weights).map(|(t, w)| t.0 * *w).sum();
        return format!("it can slide along {}", direction(slide));
    }
    if turns == 3 && at.iter().all(|p| (p - at[0]).norm() <= NEAR * unit) {
        return format!("it can turn about mount `{}` in every direction", places[0].name);
    }
    let (shift, rotation) = twists
        .iter()
        .zip(mixed.row(0).iter())
        .map(|(t, w)| (t.0 * *w, t.1 * *w))
        .fold((Vector3::zeros(), Vector3::zeros()), |a: (Vector3<f64>, Vector3<f64>), b| {
            (a.0 + b.0, a.1 + b.1)
        });
    let along = rotation.normalize();
    let pitch = shift.dot(&along) / rotation.norm();
    let point = middle + rotation.cross(&shift) / rotation.norm_squared();
    let off = |p: &Vector3<f64>| (p - point).cross(&along).norm();
    let through: Vec<String> = places
        .iter()
        .zip(at)
        .filter(|(_, p)| off(p) <= NEAR * unit)
        .map(|(m, _)| format!("`{}`", m.name))
        .collect();
    let line = match through.split_last() {
        Some((last, others)) if !others.is_empty() => {
            format!("the line through mounts {} and {last}", others.join(", "))
        }
        Some((only, _)) => format!("the line along {} through mount {only}", direction(along)),
        None => {
            let [x, y, z] = [point.x, point.y, point.z].map(|p| 1e3 * p);
            format!("the line along {} through ({x:.1}, {y:.1}, {z:.1}) mm", direction(along))
        }
    };
    if pitch.abs() > NEAR * unit {
        return format!("it can move like a screw about {line}");
    }
    format!("it can turn about {line}")
}

/// Weights of the twists whose rotations cancel: orthogonal to the rows of `mixed` that carry rotation.
fn null_combination(mixed: &DMatrix<f64>, turns: usize, count: usize) -> Vec<f64> {
    let mut best = vec![0.0; count];
    let mut size = 0.0;
    for start in 0..count {
        let mut weights: Vec<f64> = (0..count).map(|k| if k == start { 1.0 } else { 0.0 }).collect();
        for row in 0..turns {
            let along: f64 = (0..count).map(|k| mixed[(row, k)] * weights[k]).sum();
            (0..count).for_each(|k| weights[k] -= along * mixed[(row, k)]);
        }
        let norm = weights.iter().map(|w| w * w).sum::<f64>().sqrt();
        if norm > size {
            (best, size) = (weights, norm);
        }
    }
    best
}

/// A direction for people: an axis of the frame, or its components.
fn direction(vector: Vector3<f64>) -> String {
    let unit = vector.normalize();
    let largest = unit.iamax();
    if (unit[largest].abs() - 1.0).abs() < NEAR * NEAR {
        return ["x", "y", "z"][largest].to_owned();
    }
    let sign = unit[largest].signum();
    let [x, y, z] = [unit.x, unit.y, unit.z].map(|c| sign * c + 0.0);
    format!("({x:.3}, {y:.3}, {z:.3})")
}
