//! What the file says about a layout.

use lanchester_model::Strokes;

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
