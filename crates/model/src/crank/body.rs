//! The crankshaft as a body: its journals, pins and webs, counterweights as parts, and what they must stay clear of.

use crate::crank::elements::{Disc, hull};
use lanchester_shape::{CounterweightShape, GeometryError, Outline, Part, Point};
use serde::Serialize;

/// Journals, pins and webs, the same for all throws: the file's `[crank.body]`. What differs is in [`crate::CrankDetails`]; the elements one
/// by one are [`crate::EngineParts::crank_elements`].
///
/// A web is the convex hull of a disc about the crank axis and a disc about the crankpin; pins and journals fill what is
/// between the webs, and the first and the last journal stand out by their own lengths.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankBody {
    /// Density of all of it [kg/m^3].
    pub density: f64,
    /// Diameter of the main journals [m].
    pub journal_diameter: f64,
    /// Diameter of a bore along the journals [m]; 0 for none.
    pub journal_bore: f64,
    /// Diameter of the crankpins [m].
    pub pin_diameter: f64,
    /// Diameter of a bore along the pins, in their middle [m]; 0 for none.
    pub pin_bore: f64,
    /// Thickness of the webs along the crank [m].
    pub web_thickness: f64,
    /// Radius of a web's disc about the crank axis [m].
    pub web_radius: f64,
    /// Radius of a web's round end about the crankpin [m].
    pub pin_end_radius: f64,
    /// Lengths of the first journal (free end) and the last one (flywheel), from the face of the web [m].
    pub end_journals: [f64; 2],
}

impl CrankBody {
    /// Outline of a plain web whose crankpin stands at the distance `throw` [m]. As for every part, `x` points away
    /// from the crankpin.
    ///
    /// # Errors
    /// Where one of the discs lies within the other.
    pub fn web(&self, throw: f64) -> Result<Outline, GeometryError> {
        hull([
            Disc { centre: Point::ORIGIN, radius: self.web_radius },
            Disc { centre: Point::new(-throw, 0.0), radius: self.pin_end_radius },
        ])
    }

    /// Outline of a web between two crankpins that stand at these points: the convex hull of two discs about them, as round as the
    /// ends of the other webs. Pins in line have a disc between them.
    ///
    /// # Errors
    /// Where the numbers are beyond any crankshaft.
    pub fn shared_web(&self, front: Point, rear: Point) -> Result<Outline, GeometryError> {
        hull([front, rear].map(|centre| Disc { centre, radius: self.pin_end_radius }))
    }
}

/// A counterweight as a part.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CounterweightPart {
    /// How its outline was given, and what it encloses.
    pub form: CounterweightForm,
    /// The plate in its own frame: its middle plane at z = 0, `x` along `angle`. Of a shape of the family it encloses the
    /// disc of the web too, which is no part of the counterweight.
    pub part: Part,
    /// Index of the web on which it sits, counted through all throws, if it sits on one.
    pub web: Option<usize>,
    /// Plane of its middle [m], from the origin.
    pub z: f64,
    /// Direction of its `x` on the crankshaft [rad].
    pub angle: f64,
    /// The unbalance that it should have [kg m], if the file says so.
    pub wanted: Option<f64>,
}

/// What the outline of a counterweight encloses.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CounterweightForm {
    /// The counterweight and the disc of its web: a shape of the tool paper's family.
    Family(CounterweightShape),
    /// The counterweight alone.
    Counterweight,
    /// The whole web with its counterweight. The weight is what it has more than the plain web, which the throw's own unbalance
    /// counts.
    Web,
}

/// What the crankshaft must stay clear of: the file's `[clearance]`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Envelope {
    /// Least clearance that is wanted to everything [m].
    pub least: Option<f64>,
    /// Inner radius of the crankcase about the crank axis [m].
    pub crankcase_radius: Option<f64>,
    /// The pistons.
    pub skirt: Option<Skirt>,
    /// The cylinder liners.
    pub liner: Option<Liner>,
    /// The connecting rods.
    pub rod: Option<RodEnvelope>,
}

/// Lower end of a piston: what of its cylinder, of the bore's diameter, reaches below the piston pin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Skirt {
    /// From the axis of the piston pin to the lower edge of the skirt, towards the crank [m].
    pub length: f64,
    /// Width of the piston's lower end along the crank [m]; the bore where the file gives none.
    pub width: Option<f64>,
}

/// Lower end of a cylinder liner: a tube about the cylinder axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Liner {
    /// Distance of its lower end from the crank axis, along the cylinder axis [m].
    pub end: f64,
    /// Thickness of its wall [m].
    pub wall: f64,
}

/// Envelope of a connecting rod: a disc about the crankpin, and a bar along the rod.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RodEnvelope {
    /// Radius of the big end with its bolts about the crankpin [m].
    pub big_end_radius: f64,
    /// Width of the big end along the crank [m].
    pub big_end_width: f64,
    /// Width of the shank across rod and crank [m].
    pub shank_width: f64,
    /// Thickness of the shank along the crank [m].
    pub shank_thickness: f64,
}
