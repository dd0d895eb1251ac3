//! Forces at points by order and speed.

use num_complex::Complex64;

/// A point that is loaded.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedPoint {
    /// Number of its node or grid point, from 1.
    pub id: u32,
    /// Name in comments.
    pub name: String,
    /// Where it is [m].
    pub position: [f64; 3],
}

/// Forces of one order.
#[derive(Debug, Clone, PartialEq)]
pub struct OrderForces {
    /// Order: periods in one revolution of crankshaft 1.
    pub order: f64,
    /// Force [N] by point and speed.
    ///
    /// ```text
    /// f(t) = Re( F e^{i n w t} )      n: order, w: speed of crankshaft 1 [rad/s], t = 0 where its angle is 0
    /// ```
    pub forces: Vec<Vec<[Complex64; 3]>>,
}

/// Forces at points by order and speed, each order apart: the mean force is in none of them.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceTable {
    /// Title, one line.
    pub title: String,
    /// What the reader should know, a line each.
    pub notes: Vec<String>,
    /// Speeds of crankshaft 1 [rad/s], rising.
    pub speeds: Vec<f64>,
    /// The points.
    pub points: Vec<LoadedPoint>,
    /// Orders, rising.
    pub orders: Vec<OrderForces>,
}

/// A text in one line of plain characters, as files of columns hold it.
pub(crate) fn plain(text: &str, longest: usize) -> String {
    let plain = |c: char| if c.is_ascii_graphic() || c == ' ' { c } else { '?' };
    text.chars().map(plain).take(longest).collect()
}
