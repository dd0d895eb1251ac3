//! The short form of a layout (`[layout]`) expanded to throws and cylinders.
//!
//! SI units and radians; z is counted along the crank from the middle of the arrangement. Nothing here reads text: the
//! reader fills a [`LayoutSpec`], and every [`Problem`] names the key that it is about, so that the reader finds the
//! place in the file.

mod banks;
mod crank;
mod keys;
mod radial;
mod row;

use lanchester_model::{RodJoint, Strokes};

/// Most cylinders that a short form expands to. Above the largest piston engines built (56), and small enough
/// that a slip of the keyboard does not fill the memory.
const MOST_CYLINDERS: usize = 240;

/// `layout.type`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LayoutKind {
    InLine,
    V,
    Boxer,
    Flat,
    Vr,
    W,
    Radial,
}

impl LayoutKind {
    /// As the file writes it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            LayoutKind::InLine => "in-line",
            LayoutKind::V => "v",
            LayoutKind::Boxer => "boxer",
            LayoutKind::Flat => "flat",
            LayoutKind::Vr => "vr",
            LayoutKind::W => "w",
            LayoutKind::Radial => "radial",
        }
    }
}

/// `layout.numbering`: which cylinders form a bank.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Numbering {
    /// Bank 1 first, then bank 2.
    ByBank,
    /// In turn along the crank: 1, 3, 5.. on bank 1 of two.
    Alternating,
}

/// `layout.pins`: how the cylinders that face each other share crankpins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pins {
    /// One crankpin for all.
    Shared,
    /// Two crankpins a fixed angle apart.
    Split,
    /// A throw for each cylinder.
    Separate,
}

/// `layout.rods`: how the rods of one crankpin sit on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rods {
    SideBySide,
    ForkAndBlade,
    Articulated,
}

/// One entry of `layout.banks`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bank {
    /// Direction of the cylinder axes [rad].
    pub(crate) angle: f64,
    /// Cylinder offset along +v [m].
    pub(crate) offset: Option<f64>,
}

/// What the file says about the layout. `None`: the key is not there.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LayoutSpec {
    /// `layout.type`.
    pub(crate) kind: LayoutKind,
    /// `layout.cylinders`: of the engine, of one row for a radial.
    pub(crate) cylinders: usize,
    /// `strokes` of the file.
    pub(crate) strokes: Strokes,
    /// `firing.order`, numbers from 1 as in the file.
    pub(crate) order: Option<Vec<usize>>,
    /// Crank radius plus rod length [m] of `[crank]` and `[rod]`, where the file gives both: cylinders whose axes pass
    /// the crank's axis reach top dead centre at `asin(offset / reach)`.
    pub(crate) reach: Option<f64>,
    /// `layout.spacing` [m].
    pub(crate) spacing: Option<f64>,
    /// `layout.positions` [m].
    pub(crate) positions: Option<Vec<f64>>,
    /// `layout.crank_angles` [rad].
    pub(crate) crank_angles: Option<Vec<f64>>,
    /// `layout.crank_phase` [rad].
    pub(crate) crank_phase: Option<f64>,
    /// `layout.numbering`.
    pub(crate) numbering: Option<Numbering>,
    /// `layout.bank_stagger` [m].
    pub(crate) bank_stagger: Option<f64>,
    /// `layout.bank_angle` [rad].
    pub(crate) bank_angle: Option<f64>,
    /// `layout.pins`.
    pub(crate) pins: Option<Pins>,
    /// `layout.split_angle` [rad].
    pub(crate) split_angle: Option<f64>,
    /// `layout.rods`.
    pub(crate) rods: Option<Rods>,
    /// `layout.bank_offset` [m].
    pub(crate) bank_offset: Option<f64>,
    /// `layout.banks`.
    pub(crate) banks: Option<Vec<Bank>>,
    /// `layout.rows`.
    pub(crate) rows: Option<usize>,
    /// `layout.row_spacing` [m].
    pub(crate) row_spacing: Option<f64>,
    /// `layout.row_angles` [rad].
    pub(crate) row_angles: Option<Vec<f64>>,
    /// `layout.master`, number within a row from 1.
    pub(crate) master: Option<usize>,
    /// `layout.knuckle_radius` [m] (radial).
    pub(crate) knuckle_radius: Option<f64>,
    /// `layout.knuckle_angles` [rad] (radial): one for each articulated rod of a row, by rising number.
    pub(crate) knuckle_angles: Option<Vec<f64>>,
    /// `articulated_rod.knuckle_radius` [m] (v, flat).
    pub(crate) rod_knuckle_radius: Option<f64>,
    /// `articulated_rod.knuckle_angle` [rad] (v, flat).
    pub(crate) rod_knuckle_angle: Option<f64>,
}

impl LayoutSpec {
    /// A layout of which the file says no more than this.
    pub(crate) fn new(kind: LayoutKind, cylinders: usize, strokes: Strokes) -> LayoutSpec {
        LayoutSpec {
            kind,
            cylinders,
            strokes,
            order: None,
            reach: None,
            spacing: None,
            positions: None,
            crank_angles: None,
            crank_phase: None,
            numbering: None,
            bank_stagger: None,
            bank_angle: None,
            pins: None,
            split_angle: None,
            rods: None,
            bank_offset: None,
            banks: None,
            rows: None,
            row_spacing: None,
            row_angles: None,
            master: None,
            knuckle_radius: None,
            knuckle_angles: None,
            rod_knuckle_radius: None,
            rod_knuckle_angle: None,
        }
    }
}

/// The layout in the general form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Arrangement {
    /// Throws from the free end to the flywheel, the first at 0.
    pub(crate) throws: Vec<ThrowPlace>,
    /// Cylinders by number.
    pub(crate) cylinders: Vec<CylinderPlace>,
}

/// Place of a throw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ThrowPlace {
    /// Direction on the crankshaft [rad], in [0, 2 pi).
    pub(crate) angle: f64,
    /// Plane [m].
    pub(crate) z: f64,
}

/// Place of a cylinder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CylinderPlace {
    /// Index of its throw.
    pub(crate) throw: usize,
    /// Direction of its axis [rad].
    pub(crate) angle: f64,
    /// Plane [m].
    pub(crate) z: f64,
    /// Offset of its axis along +v [m] that the layout itself brings (`bank_offset`, `banks`), `None` where it says nothing.
    pub(crate) offset: Option<f64>,
    /// What its rod's big end sits on.
    pub(crate) joint: RodJoint,
}

/// Something wrong in the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Problem {
    /// Key that it is about, dotted: "layout.bank_angle", "firing.order". The key may be missing from the file.
    pub(crate) key: &'static str,
    /// What was needed and what was got.
    pub(crate) message: String,
    /// What to do.
    pub(crate) hint: Option<String>,
}

impl Problem {
    /// A problem without a hint.
    pub(crate) fn new(key: &'static str, message: impl Into<String>) -> Problem {
        Problem { key, message: message.into(), hint: None }
    }

    /// The problem with a hint.
    pub(crate) fn hint(mut self, hint: impl Into<String>) -> Problem {
        self.hint = Some(hint.into());
        self
    }
}

/// The throws and cylinders of a layout before the crank has its angles.
struct Skeleton {
    throws: Vec<ThrowFrame>,
    cylinders: Vec<CylinderPlace>,
    /// What one entry of `crank_angles` stands for: "throw", "cylinder", "pair", "row".
    entry: &'static str,
}

/// A throw whose angle is that of its entry of `crank_angles` plus `lead`.
struct ThrowFrame {
    entry: usize,
    lead: f64,
    z: f64,
}

/// Throws and cylinders of the layout, or everything that is wrong with it.
pub(crate) fn arrange(spec: &LayoutSpec) -> Result<Arrangement, Vec<Problem>> {
    let mut problems = Vec::new();
    keys::check(spec, &mut problems);
    let rows = if spec.kind == LayoutKind::Radial { spec.rows.unwrap_or(1) } else { 1 };
    let count = spec.cylinders.saturating_mul(rows);
    if count == 0 || count > MOST_CYLINDERS {
        let key = if spec.cylinders == 0 || rows == 1 { "layout.cylinders" } else { "layout.rows" };
        problems
            .push(Problem::new(key, format!("needs 1 to {MOST_CYLINDERS} cylinders in all, got {count}")));
        return Err(problems);
    }
    let skeleton = match spec.kind {
        LayoutKind::InLine | LayoutKind::Vr => row::skeleton(spec, &mut problems),
        LayoutKind::V | LayoutKind::Boxer | LayoutKind::Flat | LayoutKind::W => {
            banks::skeleton(spec, &mut problems)
        }
        LayoutKind::Radial => radial::skeleton(spec, &mut problems),
    };
    let Some(skeleton) = skeleton else { return Err(problems) };
    let angles = crank::angles(spec, &skeleton, &mut problems);
    let (Some(angles), true) = (angles, problems.is_empty()) else { return Err(problems) };
    let throws =
        skeleton.throws.iter().zip(angles).map(|(throw, angle)| ThrowPlace { angle, z: throw.z }).collect();
    Ok(Arrangement { throws, cylinders: skeleton.cylinders })
}

/// Planes of `count` throws or cylinders along the crank, symmetric about z = 0 if they are given by `spacing`.
fn planes(spec: &LayoutSpec, count: usize, what: &str, problems: &mut Vec<Problem>) -> Option<Vec<f64>> {
    if let Some(positions) = &spec.positions {
        if positions.len() != count {
            let got = positions.len();
            problems.push(Problem::new(
                "layout.positions",
                format!("needs {count} positions, one a {what}, got {got}"),
            ));
            return None;
        }
        if positions.windows(2).any(|pair| pair[1] <= pair[0]) {
            problems.push(
                Problem::new("layout.positions", "positions must rise from the free end to the flywheel")
                    .hint("z grows from cylinder 1 at the free end towards the flywheel"),
            );
            return None;
        }
        return Some(positions.clone());
    }
    if count == 1 {
        return Some(vec![0.0]);
    }
    match spec.spacing {
        Some(spacing) if spacing > 0.0 => Some(evenly_spaced(count, spacing)),
        Some(_) => {
            problems.push(Problem::new("layout.spacing", "spacing must be more than 0"));
            None
        }
        None => {
            problems.push(
                Problem::new(
                    "layout.spacing",
                    format!("spacing is missing: the distance from one {what} to the next"),
                )
                .hint("add spacing = \"88 mm\", or positions = [..] if they are not evenly spaced"),
            );
            None
        }
    }
}

/// `count` planes `spacing` apart, symmetric about z = 0.
fn evenly_spaced(count: usize, spacing: f64) -> Vec<f64> {
    let middle = (count as f64 - 1.0) / 2.0;
    (0..count).map(|plane| (plane as f64 - middle) * spacing).collect()
}

/// An angle in degrees for a message: "22.5 deg".
fn degrees(angle: f64) -> String {
    let rounded = (angle.to_degrees() * 1e3).round() / 1e3;
    format!("{} deg", rounded + 0.0)
}

#[cfg(test)]
mod tests;
