//! Holzer's table: the residual torque of a chain that is made to swing at a frequency.

use crate::chain::Chain;
use serde::Serialize;

/// One line of Holzer's table: a station and the shaft towards the root of the tree.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct HolzerRow {
    /// Index of the station.
    pub station: usize,
    /// Inertia at the reference [kg m^2].
    pub inertia: f64,
    /// `J w^2` [N m/rad].
    pub inertia_torque_rate: f64,
    /// Referred angle [rad].
    pub angle: f64,
    /// Inertia torque `J w^2 phi` [N m].
    pub inertia_torque: f64,
    /// Torque in the shaft behind it: the sum of all inertia torques before it [N m].
    pub shaft_torque: f64,
    /// Stiffness of that shaft at the reference [N m/rad]; `None` at the last station.
    pub stiffness: Option<f64>,
    /// Its referred twist [rad].
    pub twist: f64,
}

/// Holzer's table at one frequency.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct HolzerTable {
    /// Angular frequency [rad/s].
    pub frequency: f64,
    /// Lines, every station before that towards which its shaft leads.
    pub rows: Vec<HolzerRow>,
    /// Torque that is left at the last station [N m]: 0 at a natural frequency.
    pub residual: f64,
    /// The same over the sum of the sizes of all inertia torques.
    pub relative_residual: f64,
}

/// Holzer's table of the undamped chain at the angular frequency `w` [rad/s]; the first station that swings has 1 rad.
///
/// ```text
/// T_shaft = SUM J w^2 phi over all before it,   phi_next = phi - T_shaft / k,   residual = SUM of all                        (50.4)
/// ```
/// Branches are taken from their ends: where branches meet, their free amplitudes follow from the angle that they share. A branch whose own
/// frequency with its root held is `w` has no finite amplitude; its table is that of a frequency next to it.
pub fn holzer(chain: &Chain, w: f64, speed: f64) -> HolzerTable {
    let n = chain.stations().len();
    let order = chain.order();
    // g: torque that a station with all that hangs on it takes for one unit of its angle; share: angle of a child over that of its parent.
    let mut g: Vec<f64> = (0..n).map(|i| w * w * chain.referred_inertia(i)).collect();
    let mut share = vec![1.0; n];
    for &station in order.iter().skip(1).rev() {
        let (parent, shaft) = chain.parent(station);
        let k = chain.referred_stiffness(shaft, speed);
        let mut left = k - g[station];
        if left.abs() <= f64::EPSILON * k {
            left = f64::EPSILON * k.max(f64::MIN_POSITIVE);
        }
        share[station] = k / left;
        g[parent] += g[station] * share[station];
    }
    let mut angle = vec![0.0; n];
    angle[order[0]] = 1.0;
    for &station in order.iter().skip(1) {
        angle[station] = share[station] * angle[chain.parent(station).0];
    }
    // A ring without a spring stands still: the first station that swings has 1 rad.
    let largest = angle.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let lead = angle.iter().copied().find(|value| value.abs() > 1e-12 * largest).unwrap_or(1.0);
    let scale = if lead.is_finite() { 1.0 / lead } else { 1.0 };
    for value in &mut angle {
        *value *= scale;
    }
    let mut carried = vec![0.0; n];
    let mut rows = Vec::with_capacity(n);
    let mut size = 0.0;
    let mut residual = 0.0;
    for &station in order.iter().rev() {
        let inertia = chain.referred_inertia(station);
        let own = inertia * w * w * angle[station];
        size += own.abs();
        let torque = carried[station] + own;
        let is_root = station == order[0];
        let stiffness = (!is_root).then(|| chain.referred_stiffness(chain.parent(station).1, speed));
        if is_root {
            residual = torque;
        } else {
            carried[chain.parent(station).0] += torque;
        }
        rows.push(HolzerRow {
            station,
            inertia,
            inertia_torque_rate: inertia * w * w,
            angle: angle[station],
            inertia_torque: own,
            shaft_torque: torque,
            stiffness,
            twist: stiffness.map_or(0.0, |k| if k > 0.0 { torque / k } else { 0.0 }),
        });
    }
    // Along a plain chain the first station is the first line.
    let relative_residual = if size > 0.0 { residual / size } else { 0.0 };
    HolzerTable { frequency: w, rows, residual, relative_residual }
}
