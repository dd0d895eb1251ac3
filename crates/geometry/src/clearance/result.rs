//! Clearances as plain data.

use serde::Serialize;

/// Version of [`Clearances`]: it grows when a field changes its meaning or goes.
pub const CLEARANCE_VERSION: u32 = 1;

/// What a counterweight or web must stay clear of. Cylinders count from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Obstacle {
    /// The circle of the crankcase about the axis of the crankshaft.
    Crankcase,
    /// The piston: a cylinder of the bore's diameter from its lower edge upwards.
    Piston {
        /// Its cylinder.
        cylinder: usize,
    },
    /// The liner: a tube from its lower end upwards.
    Liner {
        /// Its cylinder.
        cylinder: usize,
    },
    /// The connecting rod: big end and shank; of the throw whose web is looked at, the shank alone.
    Rod {
        /// Its cylinder.
        cylinder: usize,
    },
    /// The side of a big end that turns between this web and its neighbour: its play along the crank. It is not held
    /// against the wanted clearance.
    BigEndSide {
        /// Its cylinder.
        cylinder: usize,
    },
}

/// Direction in which the depth of an overlap is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DepthAlong {
    /// The cylinder axis: piston or liner moved this far up, at all angles, just clears what turns.
    Cylinder,
    /// The crank: moved apart this far along z, the two just clear each other, whatever the angle.
    Crank,
    /// The radius: what the crankcase is too narrow.
    Radius,
}

/// Two bodies that overlap.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Overlap {
    /// Ranges of the angle of crankshaft 1 [rad] at which they do, first and last; one that runs over the end of the period
    /// ends beyond it.
    pub angles: Vec<[f64; 2]>,
    /// How deep [m].
    pub depth: f64,
    /// It is nowhere deeper than this [m].
    pub depth_bound: f64,
    /// In which direction.
    pub along: DepthAlong,
}

/// The smallest distance of a counterweight or web from an obstacle over all angles.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Clearance {
    /// The obstacle.
    pub obstacle: Obstacle,
    /// Smallest distance in space [m], zero where they overlap.
    pub distance: f64,
    /// Proved bound: it is nowhere smaller than this [m].
    pub bound: f64,
    /// Angle of crankshaft 1 [rad] at which it is that small (where they overlap: deepest); none where it is the same at
    /// all angles.
    pub theta: Option<f64>,
    /// The point on the counterweight or web then (at `theta` zero where it is the same at all angles): x, y, z [m].
    pub on_body: [f64; 3],
    /// The point on the obstacle then [m].
    pub on_obstacle: [f64; 3],
    /// How they overlap, if they do.
    pub overlap: Option<Overlap>,
    /// Whether they stay clear of each other by what is wanted, proved.
    pub is_kept: bool,
}

impl Clearance {
    /// What orders clearances from the worst to the best [m]: the distance, or the depth of an overlap as a negative number.
    pub fn signed(&self) -> f64 {
        self.overlap.as_ref().map_or(self.distance, |overlap| -overlap.depth)
    }
}

/// The clearances of a counterweight with its web, or of a web without counterweight.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BodyClearances {
    /// Name of the counterweight, or "web 3".
    pub name: String,
    /// Index of its crankshaft.
    pub crankshaft: usize,
    /// Its first and its last plane [m].
    pub faces: [f64; 2],
    /// Swept radius [m].
    pub swept_radius: f64,
    /// Whether it has chamfers, which count as not cut: every distance is a lower bound then.
    pub chamfers_ignored: bool,
    /// Its clearance to every obstacle that is there, but those that lie farther away along the crank than another one
    /// of their kind is at its nearest.
    pub clearances: Vec<Clearance>,
}

/// A big end within the crankcase.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BigEndClearance {
    /// Cylinder of the rod, from 1.
    pub cylinder: usize,
    /// Largest distance of the big end from the axis of the crankshaft [m].
    pub swept_radius: f64,
    /// Its clearance; `on_body` is on the big end.
    pub clearance: Clearance,
}

/// The smallest clearance of all.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Smallest {
    /// Name of the counterweight or web, or "big end 2".
    pub body: String,
    /// The clearance.
    pub clearance: Clearance,
}

/// All clearances of an engine's crankshafts.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Clearances {
    /// [`CLEARANCE_VERSION`].
    pub version: u32,
    /// The clearance that is wanted to everything [m].
    pub least: Option<f64>,
    /// Counterweights in the engine's order, then the webs that carry none.
    pub bodies: Vec<BodyClearances>,
    /// Big ends against the crankcase.
    pub big_ends: Vec<BigEndClearance>,
    /// The smallest of all; the sides of big ends count only where they overlap.
    pub smallest: Option<Smallest>,
    /// Whether nothing overlaps and all stay clear by what is wanted, proved.
    pub is_kept: bool,
}

/// The distance of a counterweight or web from an obstacle over the angle.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ClearanceCurve {
    /// Angles of crankshaft 1 [rad], evenly over a period, its end left out.
    pub theta: Vec<f64>,
    /// Smallest distance at that angle [m], zero where they overlap, to the gap of the search.
    pub distance: Vec<f64>,
    /// The period [rad].
    pub period: f64,
}

/// The largest swept radius that keeps the wanted clearance whatever the shape.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SweptRoom {
    /// Largest swept radius [m]; zero where there is no room at all.
    pub radius: f64,
    /// The clearance that it keeps [m].
    pub least: f64,
    /// What limits it.
    pub limit: Obstacle,
    /// Angle of crankshaft 1 [rad] at which it does, for a piston.
    pub theta: Option<f64>,
}
