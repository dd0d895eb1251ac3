//! Keys that have no effect for this layout, or beside another key.

use super::spec::{LayoutKind, LayoutSpec, Pins, Rods};
use crate::problem::Problem;

const ALL: [LayoutKind; 7] = [
    LayoutKind::InLine,
    LayoutKind::V,
    LayoutKind::Boxer,
    LayoutKind::Flat,
    LayoutKind::Vr,
    LayoutKind::W,
    LayoutKind::Radial,
];

/// Adds a problem for every key that would be read and ignored.
pub(super) fn check(spec: &LayoutSpec, problems: &mut Vec<Problem>) {
    use LayoutKind::{Boxer, Flat, InLine, Radial, V, Vr, W};
    let along: &[LayoutKind] = &[InLine, V, Boxer, Flat, Vr, W];
    let banked: &[LayoutKind] = &[V, Boxer, Flat, W];
    let keys: [(&'static str, bool, &[LayoutKind]); 16] = [
        ("layout.spacing", spec.spacing.is_some(), along),
        ("layout.positions", spec.positions.is_some(), along),
        ("layout.numbering", spec.numbering.is_some(), banked),
        ("layout.bank_stagger", spec.bank_stagger.is_some(), banked),
        ("layout.bank_angle", spec.bank_angle.is_some(), &[V, Vr]),
        ("layout.pins", spec.pins.is_some(), &[V, Flat, W]),
        ("layout.split_angle", spec.split_angle.is_some(), &[V]),
        ("layout.rods", spec.rods.is_some(), &[V, Flat, Radial]),
        ("layout.bank_offset", spec.bank_offset.is_some(), &[Vr]),
        ("layout.banks", spec.banks.is_some(), &[W]),
        ("layout.rows", spec.rows.is_some(), &[Radial]),
        ("layout.row_spacing", spec.row_spacing.is_some(), &[Radial]),
        ("layout.row_angles", spec.row_angles.is_some(), &[Radial]),
        ("layout.master", spec.master.is_some(), &[Radial]),
        ("layout.knuckle_radius", spec.knuckle_radius.is_some(), &[Radial]),
        ("layout.knuckle_angles", spec.knuckle_angles.is_some(), &[Radial]),
    ];
    for (key, present, kinds) in keys {
        if present && !kinds.contains(&spec.kind) {
            problems.push(
                without_effect(key, &format!("with type = \"{}\"", spec.kind.name()))
                    .hint(format!("it belongs to {}", list(kinds))),
            );
        }
    }
    check_beside(spec, problems);
}

/// Keys that another key makes meaningless.
fn check_beside(spec: &LayoutSpec, problems: &mut Vec<Problem>) {
    let mut report = |present: bool, key: &'static str, beside: &str, hint: &str| {
        if present {
            problems.push(without_effect(key, beside).hint(hint));
        }
    };
    report(
        spec.spacing.is_some() && spec.positions.is_some(),
        "layout.spacing",
        "beside positions",
        "keep one of the two",
    );
    report(
        spec.crank_phase.is_some() && spec.crank_angles.is_some(),
        "layout.crank_phase",
        "beside crank_angles",
        "keep one of the two",
    );
    let pins = spec.pins.unwrap_or(Pins::Shared);
    report(
        spec.kind == LayoutKind::V && spec.split_angle.is_some() && pins != Pins::Split,
        "layout.split_angle",
        if pins == Pins::Shared { "with pins = \"shared\"" } else { "with pins = \"separate\"" },
        "add pins = \"split\", or leave split_angle out",
    );
    let banked = matches!(spec.kind, LayoutKind::V | LayoutKind::Flat);
    report(
        banked && spec.rods.is_some() && pins != Pins::Shared,
        "layout.rods",
        "where every rod has a crankpin of its own",
        "rods is for pins = \"shared\"",
    );
    let articulated = match spec.kind {
        LayoutKind::Radial => spec.rods.unwrap_or(Rods::Articulated) == Rods::Articulated,
        _ => spec.rods == Some(Rods::Articulated),
    };
    if spec.kind == LayoutKind::Radial {
        let beside = "without articulated rods";
        let hint = "leave it out, or write rods = \"articulated\"";
        report(spec.master.is_some() && !articulated, "layout.master", beside, hint);
        report(spec.knuckle_radius.is_some() && !articulated, "layout.knuckle_radius", beside, hint);
        report(spec.knuckle_angles.is_some() && !articulated, "layout.knuckle_angles", beside, hint);
        let one_row = spec.rows.unwrap_or(1) == 1;
        report(
            spec.row_spacing.is_some() && one_row,
            "layout.row_spacing",
            "with a single row",
            "say how many rows there are: rows = 2",
        );
        let (in_layout, one) = ("a radial engine has it in [layout]", "with type = \"radial\"");
        report(spec.rod_knuckle_radius.is_some(), "articulated_rod.knuckle_radius", one, in_layout);
        report(spec.rod_knuckle_angle.is_some(), "articulated_rod.knuckle_angle", one, in_layout);
    } else {
        let beside = "without articulated rods in the layout";
        let hint = "it belongs to rods = \"articulated\" of [layout]";
        report(
            spec.rod_knuckle_radius.is_some() && !articulated,
            "articulated_rod.knuckle_radius",
            beside,
            hint,
        );
        report(
            spec.rod_knuckle_angle.is_some() && !articulated,
            "articulated_rod.knuckle_angle",
            beside,
            hint,
        );
    }
}

fn without_effect(key: &'static str, beside: &str) -> Problem {
    let name = key.rsplit('.').next().unwrap_or(key);
    Problem::new(key, format!("{name} has no effect {beside}"))
}

/// The kinds as the file writes them: `"v", "flat" and "w"`.
fn list(kinds: &[LayoutKind]) -> String {
    let names: Vec<String> =
        ALL.iter().filter(|kind| kinds.contains(kind)).map(|kind| format!("\"{}\"", kind.name())).collect();
    match names.split_last() {
        Some((last, [])) => format!("type = {last}"),
        Some((last, rest)) => format!("type = {} and {last}", rest.join(", ")),
        None => String::new(),
    }
}
