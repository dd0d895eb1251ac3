//! A flat part: an outline with a thickness and a density, inserts of another density, chamfers.

use crate::area_moments::AreaMoments;
use crate::chamfer::{Chamfer, Cut, Face};
use crate::error::GeometryError;
use crate::mass_properties::{MassMoments, MassProperties};
use crate::outline::Outline;
use crate::point::Point;
use serde::Serialize;

/// Densities that a material of a crankshaft can have [kg/m^3]: from light alloys (magnesium 1740) and below to heavy metals
/// (tungsten 19300) and above.
pub const PLAUSIBLE_DENSITY: [f64; 2] = [1000.0, 23_000.0];

/// A bore along the crank axis that is filled with another material: a heavy-metal slug, or a hole where the density is 0.
///
/// It makes its own bore: the outline has no hole there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Insert {
    /// Centre of the bore [m].
    pub centre: Point,
    /// Radius of the bore [m].
    pub radius: f64,
    /// Where it begins, from the front face [m].
    pub from: f64,
    /// Where it ends, from the front face [m].
    pub to: f64,
    /// Density of what is in it [kg/m^3]; 0 for a hole.
    pub density: f64,
}

/// A flat part on the crankshaft.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Part {
    outline: Outline,
    front: f64,
    thickness: f64,
    density: f64,
    inserts: Vec<Insert>,
    chamfers: Vec<Chamfer>,
}

impl Part {
    /// A plate of this `thickness` [m] and `density` [kg/m^3], whose middle plane is at z = 0.
    ///
    /// # Errors
    /// Where the thickness is not positive or the density is not one of a material ([`PLAUSIBLE_DENSITY`]).
    pub fn new(outline: Outline, thickness: f64, density: f64) -> Result<Part, GeometryError> {
        positive("thickness [m]", thickness)?;
        plausible_density(density)?;
        Ok(Part {
            outline,
            front: -thickness / 2.0,
            thickness,
            density,
            inserts: Vec::new(),
            chamfers: Vec::new(),
        })
    }

    /// The same part with its middle plane at `z` [m].
    pub fn at(mut self, z: f64) -> Part {
        self.front = z - self.thickness / 2.0;
        self
    }

    /// With an insert or a hole more.
    ///
    /// # Errors
    /// Where a number is not possible, or the insert is not wholly in the material.
    pub fn with_insert(mut self, insert: Insert) -> Result<Part, GeometryError> {
        positive("radius of an insert [m]", insert.radius)?;
        positive("length of an insert [m]", insert.to - insert.from)?;
        if insert.density != 0.0 {
            plausible_density(insert.density)?;
        }
        let Insert { centre, radius, from, to, .. } = insert;
        let slack = 1e-12 * self.thickness;
        let outside = |what: &'static str| GeometryError::InsertOutside { at: centre, radius, what };
        if from < -slack || to > self.thickness + slack {
            return Err(outside("reaches out of the faces of the part"));
        }
        if !self.outline.contains(centre) || self.outline.nearest(centre).0 < radius {
            return Err(outside("reaches over the outline of the part or of a hole"));
        }
        let overlaps = |other: &Insert| {
            (other.centre - centre).norm() < other.radius + radius && other.from < to && from < other.to
        };
        if self.inserts.iter().any(overlaps) {
            return Err(outside("overlaps another insert"));
        }
        if self.chamfers.iter().any(|chamfer| self.is_cut(&insert, chamfer)) {
            return Err(outside("is cut by a chamfer"));
        }
        self.inserts.push(insert);
        Ok(self)
    }

    /// With a chamfer more.
    ///
    /// # Errors
    /// Where its angle or radius is not possible, it cuts through the part, or meets another chamfer or an insert.
    pub fn with_chamfer(mut self, chamfer: Chamfer) -> Result<Part, GeometryError> {
        if !(chamfer.angle > 0.0 && chamfer.angle < std::f64::consts::FRAC_PI_2) {
            return Err(GeometryError::Number {
                quantity: "angle of a chamfer [rad]",
                needed: "between 0 and a quarter turn",
                got: chamfer.angle,
                hint: "it is the angle between the chamfer and the face",
            });
        }
        match chamfer.cut {
            Cut::Turned { radius } => positive("radius of a chamfer on the face [m]", radius)?,
            Cut::Milled { distance, .. } => positive("distance of a chamfer on the face [m]", distance)?,
        }
        let deepest = chamfer.deepest(&self.outline);
        let opposite = self.chamfers.iter().filter(|other| other.face != chamfer.face);
        let deepest_opposite = opposite.map(|other| other.deepest(&self.outline)).fold(0.0, f64::max);
        if deepest + deepest_opposite > self.thickness {
            let left = self.thickness - deepest_opposite;
            return Err(GeometryError::ChamferTooDeep { deepest, left });
        }
        let mut same = self.chamfers.iter().filter(|other| other.face == chamfer.face);
        if let Some(at) = same.find_map(|other| chamfer.overlap(other, &self.outline)) {
            return Err(GeometryError::ChamfersMeet { at });
        }
        if let Some(insert) = self.inserts.iter().find(|insert| self.is_cut(insert, &chamfer)) {
            let what = "is cut by a chamfer";
            return Err(GeometryError::InsertOutside { at: insert.centre, radius: insert.radius, what });
        }
        self.chamfers.push(chamfer);
        Ok(self)
    }

    fn is_cut(&self, insert: &Insert, chamfer: &Chamfer) -> bool {
        let depth = chamfer.depth_over_circle(insert.centre, insert.radius);
        match chamfer.face {
            Face::Front => insert.from < depth,
            Face::Rear => self.thickness - insert.to < depth,
        }
    }

    /// Its outline.
    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// Its thickness [m].
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// Its front and its rear face [m].
    pub fn faces(&self) -> [f64; 2] {
        [self.front, self.front + self.thickness]
    }

    /// Its density [kg/m^3].
    pub fn density(&self) -> f64 {
        self.density
    }

    /// Its inserts.
    pub fn inserts(&self) -> &[Insert] {
        &self.inserts
    }

    /// Its chamfers.
    pub fn chamfers(&self) -> &[Chamfer] {
        &self.chamfers
    }

    /// Mass, first and second moments about the crank axis at z = 0.
    pub fn moments(&self) -> MassMoments {
        let [front, rear] = self.faces();
        let mut sum = MassMoments::prism(&self.outline.moments(), [front, rear]) * self.density;
        for insert in &self.inserts {
            let disc = AreaMoments::disc(insert.centre, insert.radius);
            let bore = MassMoments::prism(&disc, [front + insert.from, front + insert.to]);
            sum = sum + bore * (insert.density - self.density);
        }
        for chamfer in &self.chamfers {
            let cut = chamfer.cut_off(&self.outline) * self.density;
            let cut = match chamfer.face {
                Face::Front => cut.moved([0.0, 0.0, front]),
                Face::Rear => reflected(cut).moved([0.0, 0.0, rear]),
            };
            sum = sum - cut;
        }
        sum
    }

    /// Mass, centre, unbalance, inertia.
    pub fn mass_properties(&self) -> MassProperties {
        self.moments().properties()
    }
}

/// The mirror image in the plane z = 0.
fn reflected(moments: MassMoments) -> MassMoments {
    let ([x, y, z], [xx, yy, zz, yz, zx, xy]) = (moments.first, moments.second);
    MassMoments { first: [x, y, -z], second: [xx, yy, zz, -yz, -zx, xy], ..moments }
}

fn positive(quantity: &'static str, got: f64) -> Result<(), GeometryError> {
    if got > 0.0 && got.is_finite() {
        return Ok(());
    }
    Err(GeometryError::Number { quantity, needed: "positive", got, hint: "give a length" })
}

/// Whether a material of a crankshaft can have this density ([`PLAUSIBLE_DENSITY`]) [kg/m^3].
///
/// # Errors
/// If it cannot: the range, and the usual slips of the unit.
pub fn plausible_density(density: f64) -> Result<(), GeometryError> {
    let [least, most] = PLAUSIBLE_DENSITY;
    if density >= least && density <= most {
        return Ok(());
    }
    Err(GeometryError::Number {
        quantity: "density [kg/m3]",
        needed: "between 1000 and 23000, as materials of crankshafts are",
        got: density,
        hint: "steel is 7850 kg/m3, which is 7.85 g/cm3; tungsten alloys are 17000 to 18500 kg/m3",
    })
}
