//! The crankshaft as elements along its axis: nose, journals, webs, pins, flange, each with its own sizes.
//!
//! Every consumer sees these; the short form of the file ([`crate::CrankBody`] with [`crate::CrankDetails`]) expands to them by
//! [`crate::EngineParts::crank_elements`].
//!
//! Frame: z along the crank from the free end to the flywheel, from the origin of the engine; x and y those of the crankshaft at angle zero,
//! from its own axis, so that throws stand at their angles. Lengths in m.

use lanchester_shape::{Contour, Corner, GeometryError, Outline, Point};
use serde::Serialize;

/// Discs whose centres are apart by a smaller share of the larger radius have one centre.
const ONE_CENTRE: f64 = 1e-9;

/// One element of a crankshaft: a prism across its axis between two planes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankElement {
    /// Where it begins and ends [m].
    pub faces: [f64; 2],
    /// Its density [kg/m^3].
    pub density: f64,
    /// What it is.
    #[serde(flatten)]
    pub form: CrankElementForm,
}

/// What an element of a crankshaft is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum CrankElementForm {
    /// A step of the nose, before the first journal.
    Nose {
        /// Its index, from the free end.
        step: usize,
        /// Its sizes.
        bar: RoundBar,
    },
    /// A main journal.
    Journal {
        /// Its index along the crankshaft, from the free end.
        journal: usize,
        /// Its sizes.
        bar: RoundBar,
    },
    /// A crankpin.
    Pin {
        /// Index of its throw.
        throw: usize,
        /// Its sizes.
        bar: RoundBar,
        /// Its oil hole, if the file gives one. It takes no mass.
        oil_hole: Option<OilHole>,
    },
    /// A plain web, without counterweights.
    Web {
        /// Its index through all throws: `2 throw` in front of the pin, `2 throw + 1` behind it.
        web: usize,
        /// The web whose other half it is, where one web joins two pins ([`crate::SharedWeb`]).
        shared_with: Option<usize>,
        /// The two discs whose convex hull it is: about the crank axis and about its pin, or about both pins of a shared web.
        discs: [Disc; 2],
    },
    /// A step of the flange, behind the last journal.
    Flange {
        /// Its index, from the last journal on.
        step: usize,
        /// Its sizes.
        bar: RoundBar,
    },
}

/// A round bar with a bore along its middle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RoundBar {
    /// Its middle, in the frame of the crankshaft.
    pub centre: Point,
    /// Outer diameter [m].
    pub diameter: f64,
    /// Diameter of the bore [m]; 0 for none.
    pub bore: f64,
    /// Fillets at its front and rear face; `None` where no web is at that face.
    pub fillets: [Option<Fillet>; 2],
}

/// A fillet between a journal or pin and a web. It adds no mass to the body.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Fillet {
    /// Its radius [m]; 0 is a sharp corner, `None` says that the file gives none.
    pub radius: Option<f64>,
    /// How deep it is cut into the face of the web (undercut, recess) [m]: `T_H` at a pin, `T_G` at a journal in IACS UR M53.
    pub recess: f64,
}

impl Fillet {
    /// What it takes of the length of the bar [m].
    pub fn length(self) -> f64 {
        self.radius.map_or(0.0, |radius| (radius - self.recess).max(0.0))
    }
}

/// An oil hole across a pin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct OilHole {
    /// Its diameter [m].
    pub diameter: f64,
    /// Direction of its mouth about the middle of the pin [rad], from the direction of the throw, positive in the sense from +x to +y.
    pub angle: f64,
}

/// A disc across the crank.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Disc {
    /// Its middle, in the frame of the crankshaft.
    pub centre: Point,
    /// Its radius [m].
    pub radius: f64,
}

impl CrankElement {
    /// Length along the crank [m].
    pub fn length(&self) -> f64 {
        self.faces[1] - self.faces[0]
    }

    /// "journal 1", "pin 2", "web 3", "nose", "flange 2": numbers count from 1.
    pub fn name(&self) -> String {
        match self.form {
            CrankElementForm::Nose { step, .. } => format!("nose {}", step + 1),
            CrankElementForm::Journal { journal, .. } => format!("journal {}", journal + 1),
            CrankElementForm::Pin { throw, .. } => format!("pin {}", throw + 1),
            CrankElementForm::Web { web, .. } => format!("web {}", web + 1),
            CrankElementForm::Flange { step, .. } => format!("flange {}", step + 1),
        }
    }

    /// The round bar that it is; `None` for a web.
    pub fn bar(&self) -> Option<&RoundBar> {
        match &self.form {
            CrankElementForm::Nose { bar, .. }
            | CrankElementForm::Journal { bar, .. }
            | CrankElementForm::Pin { bar, .. }
            | CrankElementForm::Flange { bar, .. } => Some(bar),
            CrankElementForm::Web { .. } => None,
        }
    }

    /// Index of the throw to which a pin or web belongs.
    pub fn throw(&self) -> Option<usize> {
        match self.form {
            CrankElementForm::Pin { throw, .. } => Some(throw),
            CrankElementForm::Web { web, .. } => Some(web / 2),
            _ => None,
        }
    }

    /// Its outline in the frame of the crankshaft.
    ///
    /// # Errors
    /// Where a bore does not fit, or one disc of a web lies within the other.
    pub fn outline(&self) -> Result<Outline, GeometryError> {
        match &self.form {
            CrankElementForm::Web { discs, .. } => hull(*discs),
            CrankElementForm::Nose { bar, .. }
            | CrankElementForm::Journal { bar, .. }
            | CrankElementForm::Pin { bar, .. }
            | CrankElementForm::Flange { bar, .. } => bar.outline(),
        }
    }
}

impl RoundBar {
    /// Its outline: a disc with the bore as a hole.
    ///
    /// # Errors
    /// Where the bore does not fit.
    pub fn outline(&self) -> Result<Outline, GeometryError> {
        let circle = |diameter: f64| Contour::circle(self.centre, diameter / 2.0);
        let hole = if self.bore > 0.0 { vec![circle(self.bore)?] } else { Vec::new() };
        Outline::new(circle(self.diameter)?, hole)
    }
}

/// The convex hull of two discs; of discs about one centre the larger.
///
/// ```text
/// c = (R_1 - R_2)/|d|      d from the first centre to the second      n = c d/|d| +- sqrt(1 - c^2) d_perp/|d|
/// ```
/// `n` are the normals of the two tangents that touch both discs.
///
/// # Errors
/// Where one lies within the other.
pub(crate) fn hull([one, two]: [Disc; 2]) -> Result<Outline, GeometryError> {
    let apart = two.centre - one.centre;
    let distance = apart.norm();
    if distance <= ONE_CENTRE * one.radius.max(two.radius) {
        let middle = (one.centre + two.centre) * 0.5;
        return Outline::new(Contour::circle(middle, one.radius.max(two.radius))?, Vec::new());
    }
    let along = (one.radius - two.radius) / distance;
    if along.abs() >= 1.0 {
        return Err(GeometryError::Number {
            quantity: "radius of the web's end about the crankpin [m]",
            needed: "such that neither of the two discs of a web lies within the other",
            got: two.radius,
            hint: "it differs from the radius of the web's disc by less than the crank radius",
        });
    }
    let across = ((1.0 - along) * (1.0 + along)).sqrt();
    // Divided, not multiplied by the reciprocal: along an axis it is exact.
    let direction = Point::new(apart.x / distance, apart.y / distance);
    let aside = Point::new(-direction.y, direction.x);
    let normal = |side: f64| direction * along + aside * (side * across);
    // Included angles: of the arc about the second disc 2 acos(along), of the one about the first the rest of the turn.
    let bulge = if along == 0.0 { 1.0 } else { (along.acos() / 2.0).tan() };
    let corners = [
        Corner { at: one.centre + normal(-1.0) * one.radius, bulge: 0.0 },
        Corner { at: two.centre + normal(-1.0) * two.radius, bulge },
        Corner { at: two.centre + normal(1.0) * two.radius, bulge: 0.0 },
        Corner { at: one.centre + normal(1.0) * one.radius, bulge: bulge.recip() },
    ];
    Outline::new(Contour::new(&corners)?, Vec::new())
}
