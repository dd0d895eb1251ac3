//! Weights that the file gives by number alone, as sectors whose size goes with their unbalance.

use lanchester_geometry::{Contour, Corner, Outline, Point};
use lanchester_model::{CrankBody, Engine};

/// Density for which the sectors are as large as they are [kg/m^3]: steel.
const STEEL: f64 = 7850.0;
/// Half of the angle of a sector [rad].
const HALF: f64 = 1.25;

/// Where a weight in the plane `z` is drawn [m]: on the web that is there; half of it on each web of a throw whose pin is
/// there, which is the same to the loads; else in its plane.
pub(super) fn planes(engine: &Engine, crankshaft: usize, z: f64, web_thickness: f64) -> Vec<f64> {
    let webs =
        engine.throws.iter().filter(|throw| throw.crankshaft == crankshaft).filter_map(|throw| throw.webs);
    let webs: Vec<[f64; 2]> = webs.collect();
    let is_on = |plane: &f64| (plane - z).abs() < web_thickness / 2.0;
    if webs.iter().flatten().any(is_on) {
        return vec![z];
    }
    match webs.iter().find(|[front, rear]| *front < z && z < *rear) {
        Some([front, rear]) => vec![*front, *rear],
        None => vec![z],
    }
}

/// Sectors beyond the disc of a web, as thick as the webs.
///
/// ```text
/// U = (2/3) rho t sin(h) (R^3 - r^3)         h half of the angle, r the disc's radius
/// ```
pub(super) struct Sectors {
    /// Radius of the disc [m].
    disc: f64,
    /// `R^3 - r^3` for each unbalance [m^3 per kg m].
    cube: f64,
}

impl Sectors {
    /// Of steel; denser where the largest unbalance [kg m] would else be larger than `room` [m].
    pub fn new(body: &CrankBody, room: f64, largest: f64) -> Sectors {
        let disc = body.web_radius;
        let steel = 1.5 / (STEEL * body.web_thickness * HALF.sin());
        let most = room.max(1.25 * disc).powi(3) - disc.powi(3);
        Sectors { disc, cube: steel.min(most / largest) }
    }

    /// The sector of an unbalance [kg m], along x.
    pub fn outline(&self, unbalance: f64) -> Option<Outline> {
        let radius = (self.cube * unbalance + self.disc.powi(3)).cbrt().max(1.02 * self.disc);
        // Within the disc its inner end is not seen.
        let inner = 0.8 * self.disc;
        let bulge = (HALF / 2.0).tan();
        let corners = [
            Corner { at: Point::polar(radius, -HALF), bulge },
            Corner { at: Point::polar(radius, HALF), bulge: 0.0 },
            Corner { at: Point::polar(inner, HALF), bulge: -bulge },
            Corner { at: Point::polar(inner, -HALF), bulge: 0.0 },
        ];
        Outline::new(Contour::new(&corners).ok()?, Vec::new()).ok()
    }
}
