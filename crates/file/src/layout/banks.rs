//! V, boxer, flat and W: banks of cylinders that face one another along the crank.

use super::planes::planes;
use super::skeleton::{CylinderPlace, Skeleton, ThrowFrame};
use super::spec::{Bank, LayoutKind, LayoutSpec, Numbering, Pins, Rods};
use crate::problem::{Problem, degrees};
use lanchester_model::RodJoint;
use std::f64::consts::PI;

/// Widest V: beyond it the bisector is no natural x axis.
const WIDEST_V: f64 = 170.0 * PI / 180.0;

pub(super) fn skeleton(spec: &LayoutSpec, problems: &mut Vec<Problem>) -> Option<Skeleton> {
    let before = problems.len();
    let banks = banks(spec, problems)?;
    let pins = pins(spec, problems);
    let leads = leads(spec, pins, problems);
    let joints = joints(spec, pins, &banks, problems);
    if !spec.cylinders.is_multiple_of(banks.len()) {
        problems.push(Problem::new(
            "layout.cylinders",
            format!(
                "{} banks need a multiple of {} cylinders, got {}",
                banks.len(),
                banks.len(),
                spec.cylinders
            ),
        ));
        return None;
    }
    let groups = spec.cylinders / banks.len();
    let group = if banks.len() == 2 { "pair" } else { "group" };
    if pins != Pins::Shared && spec.bank_stagger.is_none() {
        // Without it the couples of the pair would silently vanish.
        problems.push(
            Problem::new(
                "layout.bank_stagger",
                format!("bank_stagger is missing: the pins of a {group} cannot stand in one plane"),
            )
            .hint(format!(
                "add bank_stagger = \"20 mm\", the distance along the crank between the cylinders of a {group}; \
                 \"0 mm\" leaves it out on purpose"
            )),
        );
    }
    let planes = planes(spec, groups, group, problems)?;
    if problems.len() > before {
        return None;
    }
    Some(assemble(spec, pins, &banks, &leads, &joints, &planes))
}

/// Throws group by group along the crank, and the cylinders on them by number.
fn assemble(
    spec: &LayoutSpec,
    pins: Pins,
    banks: &[Bank],
    leads: &[f64],
    joints: &[RodJoint],
    planes: &[f64],
) -> Skeleton {
    let stagger = spec.bank_stagger.unwrap_or(0.0);
    let middle = (banks.len() as f64 - 1.0) / 2.0;
    let number = |group: usize, bank: usize| match spec.numbering.unwrap_or(Numbering::ByBank) {
        Numbering::ByBank => bank * planes.len() + group,
        Numbering::Alternating => group * banks.len() + bank,
    };
    let mut throws = Vec::new();
    let mut places = Vec::new();
    for (group, &plane) in planes.iter().enumerate() {
        if pins == Pins::Shared {
            throws.push(ThrowFrame { entry: group, lead: 0.0, z: plane });
        }
        for (bank, &Bank { angle, offset }) in banks.iter().enumerate() {
            let z = plane + (bank as f64 - middle) * stagger;
            let index = number(group, bank);
            if pins != Pins::Shared {
                let entry = if pins == Pins::Split { group } else { index };
                throws.push(ThrowFrame { entry, lead: leads[bank], z });
            }
            let joint = match joints[bank] {
                RodJoint::Articulated { knuckle_radius, knuckle_angle, .. } => {
                    RodJoint::Articulated { master: number(group, 0), knuckle_radius, knuckle_angle }
                }
                joint => joint,
            };
            places.push((index, CylinderPlace { throw: throws.len() - 1, angle, z, offset, joint }));
        }
    }
    places.sort_by_key(|&(index, _)| index);
    let entry = match pins {
        Pins::Shared => "throw",
        Pins::Split => "pair",
        Pins::Separate => "cylinder",
    };
    Skeleton { throws, cylinders: places.into_iter().map(|(_, place)| place).collect(), entry }
}

/// Direction and offset of every bank.
fn banks(spec: &LayoutSpec, problems: &mut Vec<Problem>) -> Option<Vec<Bank>> {
    let two = |first: f64, second: f64| {
        Some(vec![Bank { angle: first, offset: None }, Bank { angle: second, offset: None }])
    };
    match (spec.kind, spec.bank_angle) {
        (LayoutKind::W, _) => w_banks(spec, problems),
        (LayoutKind::V, Some(angle)) if angle > 0.0 && angle <= WIDEST_V => two(-angle / 2.0, angle / 2.0),
        (LayoutKind::V, Some(angle)) => {
            problems.push(
                Problem::new(
                    "layout.bank_angle",
                    format!("a V needs a bank angle above 0 and up to 170 deg, got {}", degrees(angle)),
                )
                .hint("180 deg is type = \"flat\" (shared pins) or type = \"boxer\" (opposite pins)"),
            );
            None
        }
        (LayoutKind::V, None) => {
            problems.push(
                Problem::new("layout.bank_angle", "bank_angle is missing")
                    .hint("add bank_angle = \"90 deg\""),
            );
            None
        }
        _ => two(0.0, PI),
    }
}

fn w_banks(spec: &LayoutSpec, problems: &mut Vec<Problem>) -> Option<Vec<Bank>> {
    let Some(banks) = spec.banks.as_ref().filter(|banks| banks.len() >= 2) else {
        let got = spec.banks.as_ref().map_or(0, Vec::len);
        problems.push(
            Problem::new("layout.banks", format!("a W engine needs two or more banks, got {got}"))
                .hint("add banks = [{ angle = \"-60 deg\" }, { angle = \"0 deg\" }, { angle = \"60 deg\" }]"),
        );
        return None;
    };
    for (place, bank) in banks.iter().enumerate() {
        if let Some(twin) = banks[..place].iter().position(|other| other.angle == bank.angle) {
            // Banks in one direction may stand beside each other, but not in one line.
            if banks[twin].offset.unwrap_or(0.0) == bank.offset.unwrap_or(0.0) {
                problems.push(Problem::new(
                    "layout.banks",
                    format!("banks {} and {} stand in one place", twin + 1, place + 1),
                ));
                return None;
            }
        }
    }
    Some(banks.clone())
}

fn pins(spec: &LayoutSpec, problems: &mut Vec<Problem>) -> Pins {
    if spec.kind == LayoutKind::Boxer {
        return Pins::Split;
    }
    let pins = spec.pins.unwrap_or(Pins::Shared);
    if pins == Pins::Split && matches!(spec.kind, LayoutKind::Flat | LayoutKind::W) {
        let hint = match spec.kind {
            LayoutKind::Flat => "opposite pins for every pair are type = \"boxer\"",
            _ => "separate pins take any crank_angles",
        };
        problems.push(
            Problem::new(
                "layout.pins",
                format!("type = \"{}\" has shared or separate pins, not split ones", spec.kind.name()),
            )
            .hint(hint),
        );
    }
    pins
}

/// How far the pin of each bank leads the first of its group.
fn leads(spec: &LayoutSpec, pins: Pins, problems: &mut Vec<Problem>) -> Vec<f64> {
    let banks = spec.banks.as_ref().map_or(2, Vec::len).max(2);
    let mut leads = vec![0.0; banks];
    if spec.kind == LayoutKind::Boxer {
        leads[1] = PI;
    } else if spec.kind == LayoutKind::V && pins == Pins::Split {
        match spec.split_angle {
            Some(angle) => leads[1] = angle,
            None => problems.push(
                Problem::new("layout.split_angle", "split_angle is missing")
                    .hint("how far bank 2's pin stands ahead of bank 1's, such as \"-30 deg\" in an even-firing V6 of 90 deg"),
            ),
        }
    }
    leads
}

/// What the rod of each bank sits on. The master of an articulated rod is filled in for each group.
fn joints(spec: &LayoutSpec, pins: Pins, banks: &[Bank], problems: &mut Vec<Problem>) -> Vec<RodJoint> {
    let plain = vec![RodJoint::Crankpin; banks.len()];
    let rods = match spec.rods {
        Some(rods) if pins == Pins::Shared && matches!(spec.kind, LayoutKind::V | LayoutKind::Flat) => rods,
        _ => return plain,
    };
    if rods != Rods::SideBySide && spec.bank_stagger.is_some_and(|stagger| stagger != 0.0) {
        let name = if rods == Rods::ForkAndBlade { "fork-and-blade" } else { "articulated" };
        problems.push(
            Problem::new(
                "layout.bank_stagger",
                format!("{name} rods run in one plane: bank_stagger must be 0"),
            )
            .hint("leave bank_stagger out, or write rods = \"side-by-side\""),
        );
    }
    match rods {
        Rods::SideBySide => plain,
        Rods::ForkAndBlade => vec![RodJoint::Fork, RodJoint::Blade],
        Rods::Articulated => {
            let radius = spec.rod_knuckle_radius.unwrap_or_else(|| {
                problems.push(
                    Problem::new("articulated_rod.knuckle_radius", "knuckle_radius is missing")
                        .hint("add [articulated_rod] with knuckle_radius, from crankpin to knuckle pin"),
                );
                1.0
            });
            if radius <= 0.0 {
                problems.push(Problem::new(
                    "articulated_rod.knuckle_radius",
                    "knuckle_radius must be more than 0",
                ));
            }
            let angle = spec.rod_knuckle_angle.unwrap_or(banks[1].angle - banks[0].angle);
            vec![
                RodJoint::Crankpin,
                RodJoint::Articulated { master: 0, knuckle_radius: radius, knuckle_angle: angle },
            ]
        }
    }
}
