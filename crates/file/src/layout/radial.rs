//! Radial: rows of cylinders around a throw each.

use super::planes::evenly_spaced;
use super::skeleton::{CylinderPlace, Skeleton, ThrowFrame};
use super::spec::{LayoutSpec, Rods};
use crate::problem::Problem;
use lanchester_model::RodJoint;
use std::f64::consts::TAU;

pub(super) fn skeleton(spec: &LayoutSpec, problems: &mut Vec<Problem>) -> Option<Skeleton> {
    let before = problems.len();
    let rows = spec.rows.unwrap_or(1);
    let planes = row_planes(spec, rows, problems);
    let turns = row_turns(spec, rows, problems);
    let joints = joints(spec, problems);
    if problems.len() > before {
        return None;
    }
    let mut cylinders = Vec::new();
    for row in 0..rows {
        let first = cylinders.len();
        for place in 0..spec.cylinders {
            let joint = match joints[place] {
                RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
                    RodJoint::Articulated { master: first + master, knuckle_radius, knuckle_angle }
                }
                joint => joint,
            };
            let angle = direction(spec, place) + turns[row];
            cylinders.push(CylinderPlace { throw: row, angle, z: planes[row], offset: None, joint });
        }
    }
    let throws = planes.iter().enumerate().map(|(entry, &z)| ThrowFrame { entry, lead: 0.0, z }).collect();
    Some(Skeleton { throws, cylinders, entry: "row" })
}

/// Direction of the cylinder at `place` of a row that is not turned [rad].
fn direction(spec: &LayoutSpec, place: usize) -> f64 {
    TAU * place as f64 / spec.cylinders as f64
}

fn row_planes(spec: &LayoutSpec, rows: usize, problems: &mut Vec<Problem>) -> Vec<f64> {
    if rows > 1 && !spec.row_spacing.is_some_and(|spacing| spacing > 0.0) {
        let problem = match spec.row_spacing {
            Some(_) => Problem::new("layout.row_spacing", "row_spacing must be more than 0"),
            None => {
                Problem::new("layout.row_spacing", "row_spacing is missing: the distance from row to row")
                    .hint("add row_spacing = \"150 mm\"")
            }
        };
        problems.push(problem);
    }
    evenly_spaced(rows, spec.row_spacing.unwrap_or(0.0))
}

fn row_turns(spec: &LayoutSpec, rows: usize, problems: &mut Vec<Problem>) -> Vec<f64> {
    match &spec.row_angles {
        None => vec![0.0; rows],
        Some(turns) => {
            if turns.len() != rows {
                problems.push(Problem::new(
                    "layout.row_angles",
                    format!("needs {rows} row angles, one a row, got {}", turns.len()),
                ));
            }
            turns.clone()
        }
    }
}

/// Joints of one row, the master given by its place in the row.
fn joints(spec: &LayoutSpec, problems: &mut Vec<Problem>) -> Vec<RodJoint> {
    let count = spec.cylinders;
    let mut joints = vec![RodJoint::Crankpin; count];
    match spec.rods.unwrap_or(Rods::Articulated) {
        Rods::SideBySide => return joints,
        Rods::ForkAndBlade => {
            problems.push(
                Problem::new(
                    "layout.rods",
                    "a fork and a blade make a pair: a radial engine cannot have them",
                )
                .hint("rods = \"articulated\" or \"side-by-side\""),
            );
            return joints;
        }
        Rods::Articulated => {}
    }
    let number = spec.master.unwrap_or(1);
    if number == 0 || number > count {
        problems.push(Problem::new(
            "layout.master",
            format!("master is a number within a row, 1 to {count}, got {number}"),
        ));
        return joints;
    }
    let master = number - 1;
    if count == 1 {
        return joints;
    }
    let Some(knuckle_radius) = spec.knuckle_radius else {
        problems.push(
            Problem::new("layout.knuckle_radius", "knuckle_radius is missing: from the crankpin to a knuckle pin")
                .hint("add knuckle_radius = \"60 mm\", or rods = \"side-by-side\" for rods that all sit on the crankpin"),
        );
        return joints;
    };
    if knuckle_radius <= 0.0 {
        problems.push(Problem::new("layout.knuckle_radius", "knuckle_radius must be more than 0"));
    }
    let slaves: Vec<usize> = (0..count).filter(|&place| place != master).collect();
    if let Some(angles) = &spec.knuckle_angles
        && angles.len() != slaves.len()
    {
        let (needed, got) = (slaves.len(), angles.len());
        problems.push(Problem::new(
            "layout.knuckle_angles",
            format!("needs {needed} knuckle angles, one for each articulated rod of a row, got {got}"),
        ));
        return joints;
    }
    for (index, &place) in slaves.iter().enumerate() {
        let knuckle_angle = match &spec.knuckle_angles {
            Some(angles) => angles[index],
            None => direction(spec, place) - direction(spec, master),
        };
        joints[place] = RodJoint::Articulated { master, knuckle_radius, knuckle_angle };
    }
    joints
}
