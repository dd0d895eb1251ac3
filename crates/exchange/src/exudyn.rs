//! A rigid crank train as a script of Exudyn, with our loads to compare with.

use num_complex::Complex64;
use serde::Serialize;

/// A crankshaft or balance shaft that turns at a fixed ratio.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RigidRotor {
    /// Name.
    pub name: String,
    /// Speed over that of crankshaft 1, signed.
    pub ratio: f64,
    /// Where its axis is [m].
    pub axis: [f64; 2],
    /// Sum of its unbalances where crankshaft 1 stands at 0 [kg m].
    pub first_moment: [f64; 2],
    /// Sum of its unbalances times their planes [kg m^2].
    pub product: [f64; 2],
}

/// A cylinder with piston and rod.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RigidCylinder {
    /// Index of its crankshaft.
    pub rotor: usize,
    /// Crankpin from the axis of its crankshaft where crankshaft 1 stands at 0 [m].
    pub crankpin: [f64; 2],
    /// Angle of the cylinder axis [rad].
    pub axis: f64,
    /// Net offset of the piston pin [m].
    pub offset: f64,
    /// Plane [m].
    pub z: f64,
    /// Mass of the piston [kg].
    pub piston_mass: f64,
    /// Distance of the rod's eyes [m].
    pub rod_length: f64,
    /// Mass of the rod [kg].
    pub rod_mass: f64,
    /// From the big end to its centre of mass [m].
    pub rod_centre: f64,
    /// Moment of inertia of the rod about its centre of mass [kg m^2].
    pub rod_inertia: f64,
}

/// Our loads: of all moving parts on the block.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RigidReference {
    /// Crank angles, equally far apart over whole revolutions from 0 [rad].
    pub theta: Vec<f64>,
    /// Force x, force y [N], couple x, couple y [N m] about the origin.
    pub loads: Vec<[f64; 4]>,
}

/// A crank train at constant speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RigidTrain {
    /// Name of the engine.
    pub name: String,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Revolutions after which everything stands as before.
    pub revolutions: u32,
    /// Crankshafts and balance shafts.
    pub rotors: Vec<RigidRotor>,
    /// Cylinders.
    pub cylinders: Vec<RigidCylinder>,
    /// Our loads.
    pub reference: RigidReference,
}

impl RigidRotor {
    /// A rotor from its complex moments.
    pub fn new(
        name: &str,
        ratio: f64,
        axis: Complex64,
        first_moment: Complex64,
        product: Complex64,
    ) -> RigidRotor {
        let two = |z: Complex64| [z.re, z.im];
        let (axis, first_moment, product) = (two(axis), two(first_moment), two(product));
        RigidRotor { name: name.to_owned(), ratio, axis, first_moment, product }
    }
}

impl RigidTrain {
    /// Largest force [N] and couple [N m] that a single part makes: a piston or a rod at the crankpin, or the unbalance of a shaft. The loads of all
    /// parts may cancel, those of one do not; where every part is in the plane of the origin, the couple has the throw as its arm.
    pub fn scales(&self) -> [f64; 2] {
        let size = |pair: [f64; 2]| pair[0].hypot(pair[1]);
        let (mut force, mut couple, mut arm) = (0.0_f64, 0.0_f64, 0.0_f64);
        for rotor in &self.rotors {
            let square = (self.speed * rotor.ratio).powi(2);
            force = force.max(size(rotor.first_moment) * square);
            couple = couple.max(size(rotor.product) * square);
        }
        for cylinder in &self.cylinders {
            let throw = size(cylinder.crankpin);
            let square = (self.speed * self.rotors[cylinder.rotor].ratio).powi(2);
            force = force.max(cylinder.piston_mass.max(cylinder.rod_mass) * throw * square);
            arm = arm.max(cylinder.z.abs().max(throw));
        }
        [force, couple.max(force * arm)]
    }
}

/// What the script holds: the train with the loads that differences are measured by.
#[derive(Serialize)]
struct Written<'a> {
    #[serde(flatten)]
    train: &'a RigidTrain,
    force_scale: f64,
    couple_scale: f64,
}

/// The script: it builds the train of rigid bodies and joints, turns it, and says how far its loads are from ours; exit status 1 where they are
/// further than 1e-6 of [`RigidTrain::scales`].
///
/// # Errors
/// Where a number is not finite, so that it cannot be written.
pub fn exudyn(train: &RigidTrain) -> Result<String, serde_json::Error> {
    let [force_scale, couple_scale] = train.scales();
    let data = serde_json::to_string(&Written { train, force_scale, couple_scale })?;
    // A text of Python in one line: JSON has no quotes of this kind but escaped ones.
    let data = data.replace('\\', "\\\\").replace('\'', "\\'");
    Ok(include_str!("exudyn.py").replace("{TRAIN}", &data))
}
