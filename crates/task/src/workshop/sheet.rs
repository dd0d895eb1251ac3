//! What a workshop sheet says, in SI units and radians.
//!
//! # Angles
//! Two full circles of degrees are thought of, seen from one end of the rotor: one painted on the rotor, one on the
//! housing. Both count in the sense `marks`; sensors and the keyphasor stand on the circle of the housing, trial
//! weights, corrections and displays on that of the rotor. The rotor turns in the sense `rotation`, seen from the
//! same end. At the pulse of the keyphasor the rotor's zero stands at the keyphasor.

use super::{BobweightSheet, External, SlugRoom};
use serde::Serialize;

/// A workshop sheet. Tables that it leaves out are `None` or empty.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Sheet {
    /// What is balanced.
    pub name: String,
    /// Where the data come from.
    pub note: Option<String>,
    /// The rotor and how it is looked at.
    pub rotor: Rotor,
    /// Where weight may be added or removed.
    pub planes: Vec<Plane>,
    /// What measures the vibration.
    pub sensors: Vec<Sensor>,
    /// The measured runs, in their order.
    pub runs: Vec<Run>,
    /// What a balancing machine shows.
    pub displays: Vec<Display>,
    /// Engine file, from the sheet's own folder.
    pub engine: Option<String>,
    /// Bobweights and the parts that they stand for.
    pub bobweight: Option<BobweightSheet>,
    /// Weights outside the crankcase that are to come off.
    pub externals: Vec<External>,
    /// Slugs that may be set into the counterweights.
    pub slug: Option<SlugRoom>,
}

/// The rotor and how it is looked at.
#[derive(Debug, Clone, PartialEq, Serialize, Default, schemars::JsonSchema)]
pub struct Rotor {
    /// Mass [kg].
    pub mass: Option<f64>,
    /// Its centre of mass along the shaft, z [m].
    pub centre: Option<f64>,
    /// Inertia about an axis across the shaft through the centre of mass [kg m^2].
    pub transverse_inertia: Option<f64>,
    /// Inertia about the shaft [kg m^2].
    pub polar_inertia: Option<f64>,
    /// Its two bearings or supports along the shaft, z [m], rising.
    pub supports: Option<[f64; 2]>,
    /// Highest service speed [rad/s].
    pub speed: Option<f64>,
    /// Balance quality grade: permissible speed of the centre of mass [m/s]; G 6.3 is 0.0063 m/s.
    pub grade: Option<f64>,
    /// Sense in which both circles of degrees count.
    pub marks: Option<Sense>,
    /// Sense in which the rotor turns, seen from the same end.
    pub rotation: Option<Sense>,
    /// What a positive phase means.
    pub phase: Option<PhaseConvention>,
    /// Angle of the keyphasor on the housing [rad].
    pub keyphasor: f64,
}

/// A sense of rotation seen from the end from which angles are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// As the hands of a clock.
    Clockwise,
    /// Against them.
    Anticlockwise,
}

/// What a positive phase means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PhaseConvention {
    /// From the pulse of the keyphasor to the next positive peak of the vibration: the peak lags the pulse.
    Lag,
    /// From the positive peak to the next pulse: the peak leads the pulse.
    Lead,
}

/// A plane where weight may be added or removed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Plane {
    /// Its name.
    pub name: String,
    /// Where along the shaft, z [m].
    pub z: Option<f64>,
    /// Radius at which weights sit, of the drilled surface (radial holes), or of the circle of holes (axial) [m].
    pub radius: Option<f64>,
    /// Angles on the rotor at which weight may be added or removed.
    pub allowed: Allowed,
    /// What is done there.
    pub action: Action,
    /// How it is drilled.
    pub drill: Option<Drill>,
}

/// Angles on the rotor that may be used.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Allowed {
    /// Every angle.
    Any,
    /// These angles and ranges.
    Some {
        /// Single angles [rad], within [0, 2 pi).
        angles: Vec<f64>,
        /// Ranges [rad]: from the first angle on, in the sense in which angles count, to the second.
        sectors: Vec<[f64; 2]>,
    },
}

/// Whether weight is put on or taken off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Action {
    /// Put on.
    Add,
    /// Taken off.
    Remove,
}

/// How holes are drilled in a plane.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Drill {
    /// Along which line.
    pub direction: DrillDirection,
    /// Shape of the surface where a radial hole begins; an axial hole begins on a flat face.
    pub surface: Surface,
    /// Diameters of the drills [m].
    pub diameters: Vec<f64>,
    /// Depth from the surface that the tip of the drill may reach [m].
    pub max_depth: f64,
    /// Depths are multiples of this [m], counted to the end of the full diameter; `None` for any depth.
    pub depth_step: Option<f64>,
    /// Angle of the drill point [rad]; pi is a flat bottom.
    pub point: f64,
    /// Density of the material [kg/m^3].
    pub density: f64,
    /// Least wall between neighbouring holes, and to the edges of the surface where its width is given [m].
    pub land: f64,
    /// Least distance between the centres of neighbouring holes on the surface or circle [m].
    pub spacing: f64,
    /// Most holes of one correction.
    pub most_holes: usize,
    /// Where every angle of a range is allowed: step of the angles that are tried for more than one hole [rad].
    pub angle_step: f64,
}

/// Along which line a hole is drilled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DrillDirection {
    /// From the outside towards the axis.
    Radial,
    /// Parallel to the axis.
    Axial,
}

/// Surface where a radial hole begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[schemars(rename = "DrilledSurface")]
#[serde(rename_all = "kebab-case")]
pub enum Surface {
    /// A cylinder about the axis; depth counts from its crown.
    Round,
    /// A flat across the hole.
    Flat,
}

/// A vibration sensor.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Sensor {
    /// Its name.
    pub name: String,
    /// Its angle on the housing [rad]: it shows positive when the housing moves towards it.
    pub angle: f64,
    /// How its amplitudes are given.
    pub detector: Detector,
    /// Largest amplitude that is accepted, given like its readings.
    pub limit: Option<Vibration>,
}

/// How an amplitude is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Detector {
    /// The peak.
    Peak,
    /// From the lowest to the highest value: twice the peak.
    PeakToPeak,
    /// Root mean square: the peak over the root of 2.
    Rms,
}

/// An amplitude, as the sensor's detector gives it [SI unit].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Vibration {
    /// What is measured.
    pub quantity: VibrationQuantity,
    /// How much [m, m/s or m/s^2].
    pub amplitude: f64,
}

/// What a sensor measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum VibrationQuantity {
    /// Displacement [m].
    Displacement,
    /// Velocity [m/s].
    Velocity,
    /// Acceleration [m/s^2].
    Acceleration,
}

/// A measured run.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Run {
    /// Its name.
    pub name: String,
    /// Speed [rad/s].
    pub speed: f64,
    /// What the sensors showed, in the order of the file.
    pub readings: Vec<Reading>,
    /// What was put on or taken off for this run, on top of what earlier runs left.
    pub weights: Vec<PlacedWeight>,
}

/// What a sensor showed in a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Reading {
    /// Place of the sensor in [`Sheet::sensors`].
    pub sensor: usize,
    /// Its vibration at the speed of the run.
    pub vibration: Vibration,
    /// Phase as the instrument showed it [rad]; [`Rotor::phase`] says what it means.
    pub phase: f64,
}

/// A weight that was put on or taken off for a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PlacedWeight {
    /// Place of the plane in [`Sheet::planes`].
    pub plane: usize,
    /// Mass times radius [kg m], not negative.
    pub unbalance: f64,
    /// Angle on the rotor [rad].
    pub angle: f64,
    /// Put on or taken off.
    pub action: Action,
    /// Whether it stays so after the run; if not, it is undone.
    pub kept: bool,
}

/// Unbalance that a balancing machine shows, at its place on the rotor (the heavy spot).
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Display {
    /// What it stands for.
    pub kind: DisplayKind,
    /// Amount [kg m], not negative.
    pub unbalance: f64,
    /// Angle on the rotor of the heavy spot [rad].
    pub angle: f64,
}

/// What a displayed unbalance stands for. A sheet's displays add up.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum DisplayKind {
    /// One unbalance in one plane: a static unbalance, or one plane's part of a dynamic one.
    Plane {
        /// Where along the shaft [m].
        z: f64,
    },
    /// Two equal and opposed unbalances: at `angle` in the first plane, opposite in the second.
    Couple {
        /// Where along the shaft [m].
        z: [f64; 2],
    },
}
