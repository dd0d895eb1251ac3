//! The general form of an engine: what every short form of the file expands to.
//!
//! SI units and radians throughout; [`crate::Engine::new`] checks them.
//!
//! Frame (book, "Conventions"): z is the crank axis from the free end to the flywheel, the crank turns from +x to
//! +y, the origin lies on the axis of crankshaft 1 at the reference plane (default: midway between the first and the
//! last throw plane). `theta` is the angle of crankshaft 1; `theta = 0` where throw 1 of the file points along +x.

use crate::crank::body::{CounterweightPart, CrankBody, Envelope};
use crate::crank::details::CrankDetails;
use crate::crank::material::CrankMaterial;
use crate::gear::Gear;
use crate::ratio::Ratio;
use crate::running::bearing_design::BearingDesign;
use crate::running::bearings::Bearings;
use crate::running::block::Block;
use crate::running::flywheel::Flywheel;
use crate::running::friction::Friction;
use crate::running::gas::Gas;
use crate::running::mount::Mount;
use crate::running::torsion::TorsionDesign;
use crate::shaft_part::ShaftWeightPart;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// The parts of an engine as plain data, valid or not.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
#[schemars(rename = "Engine")]
pub struct EngineParts {
    /// What the user calls it.
    pub name: String,
    /// Free text: where the data come from.
    pub note: Option<String>,
    /// Strokes in a working cycle.
    pub strokes: Strokes,
    /// Sense of rotation seen from the free end towards the flywheel.
    pub rotation: Rotation,
    /// Speeds of crankshaft 1 [rad/s] at which the engine is judged.
    pub speed: SpeedRange,
    /// Crankshafts; the first is the reference of all angles, orders and speeds.
    pub crankshafts: Vec<Crankshaft>,
    /// Throws of all crankshafts, numbered as in the file.
    pub throws: Vec<Throw>,
    /// Cylinders, numbered as in the file.
    pub cylinders: Vec<Cylinder>,
    /// Weights fixed to a crankshaft (or its flywheel, pulley).
    pub counterweights: Vec<Counterweight>,
    /// Balance shafts.
    pub shafts: Vec<BalanceShaft>,
    /// Gears, pulleys and other wheels that turn with the crank at a fixed ratio.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub gears: Vec<Gear>,
    /// Engine mounts.
    pub mounts: Vec<Mount>,
    /// The body that stands on them, if the file gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub block: Option<Block>,
    /// Journals, pins and webs, if the file gives them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crank_body: Option<CrankBody>,
    /// Elements of it that differ, fillets and oil holes, if the file gives some.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crank_details: Option<CrankDetails>,
    /// What the crankshafts are made of, if the file says so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crank_material: Option<CrankMaterial>,
    /// What the crankshaft must stay clear of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub envelope: Option<Envelope>,
    /// Gas in the cylinders, if the file says something of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gas: Option<Gas>,
    /// Its friction, if the file says something of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<Friction>,
    /// Its flywheel, if the file says something of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flywheel: Option<Flywheel>,
    /// Sizes of its bearings, if the file gives some.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bearings: Option<Bearings>,
    /// What its main and crankpin bearings are like beyond their sizes, if the file says so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bearing_design: Option<BearingDesign>,
    /// Stiffness, damping, dampers and absorbers of its torsional vibration, if the file says something of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torsion: Option<TorsionDesign>,
}

/// Strokes in a working cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Strokes {
    /// One revolution a cycle.
    Two,
    /// Two revolutions a cycle.
    #[default]
    Four,
}

impl Strokes {
    /// Revolutions of crankshaft 1 in one working cycle: 1 or 2.
    pub fn revolutions(self) -> u32 {
        match self {
            Strokes::Two => 1,
            Strokes::Four => 2,
        }
    }
}

/// Sense of rotation seen from the free end towards the flywheel.
///
/// `Reverse` mirrors the y axis, so that the crank still turns from +x to +y: every number stays, the picture is
/// mirrored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Rotation {
    /// Clockwise with x up (+y to the right).
    #[default]
    Clockwise,
    /// Anticlockwise with x up (+y to the left).
    Reverse,
}

/// Speeds of crankshaft 1 [rad/s], `lowest <= highest`; one speed has both equal.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct SpeedRange {
    /// Lowest speed [rad/s].
    pub lowest: f64,
    /// Highest speed [rad/s]: loads are reported here unless another speed is asked for.
    pub highest: f64,
}

impl SpeedRange {
    /// Whether a speed [rad/s] lies in it, to rounding.
    pub fn holds(&self, speed: f64) -> bool {
        /// Share of a speed that counts as rounding.
        const SAME: f64 = 1e-9;
        speed >= self.lowest * (1.0 - SAME) && speed <= self.highest * (1.0 + SAME)
    }
}

/// A crankshaft. Its angle is `ratio * theta + phase`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Crankshaft {
    /// Name for tables and pictures.
    pub name: String,
    /// Speed over that of crankshaft 1, signed: negative turns the other way. 1 for the first.
    pub ratio: Ratio,
    /// Angle at `theta = 0` [rad]. 0 for the first.
    pub phase: f64,
    /// Position of its axis [m]. 0, 0 for the first.
    pub x: f64,
    /// Position of its axis [m].
    pub y: f64,
    /// Planes of its main bearings [m], from the origin, rising; `None` if the file gives none:
    /// [`EngineParts::main_planes`] has the usual ones then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mains: Option<Vec<f64>>,
}

/// A throw: a crankpin (one pin of a split pair is a throw of its own).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Throw {
    /// Index of its crankshaft.
    pub crankshaft: usize,
    /// Direction on the crankshaft [rad]: the pin stands at `ratio * theta + phase + angle`.
    pub angle: f64,
    /// Plane of the throw [m], from the origin.
    pub z: f64,
    /// Crank radius [m].
    pub radius: f64,
    /// Unbalance of the crank itself along the throw [kg m] (pin and plain webs, no rod, no counterweight); may be negative.
    pub unbalance: f64,
    /// How far behind its plane that unbalance acts [m]: 0 but for a throw that shares a web with its neighbour
    /// ([`crate::SharedWeb`]).
    pub unbalance_offset: f64,
    /// Planes of its two webs [m], front then rear, from the origin; `None` if the file gives no web distance.
    pub webs: Option<[f64; 2]>,
}

impl Default for Crankshaft {
    /// The first one: on the axis of the frame, at the speed that all speeds count by.
    fn default() -> Crankshaft {
        Crankshaft { name: "crankshaft".into(), ratio: Ratio::ONE, phase: 0.0, x: 0.0, y: 0.0, mains: None }
    }
}

impl Throw {
    /// Plane of the unbalance of the crank itself [m], from the origin.
    pub fn unbalance_plane(&self) -> f64 {
        self.z + self.unbalance_offset
    }
}

/// A cylinder with its piston and rod.
///
/// Cylinder frame: `u = e^{i angle}` along the axis away from the crankshaft, `v = i u`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Cylinder {
    /// Index of the throw whose pin drives it (for an articulated rod: the throw of its master).
    pub throw: usize,
    /// Direction `b` of the axis [rad] from +x towards +y.
    pub angle: f64,
    /// Plane of the cylinder axis [m], from the origin.
    pub z: f64,
    /// Offset of the cylinder axis from the crankshaft's axis along +v [m].
    pub offset: f64,
    /// Offset of the piston pin from the cylinder axis along +v [m].
    pub pin_offset: f64,
    /// Bore [m].
    pub bore: Option<f64>,
    /// Mass of the piston with pin, rings and clips [kg]; its centre lies on the cylinder axis.
    pub piston_mass: f64,
    /// Its connecting rod.
    pub rod: Rod,
    /// `theta` [rad] at which it fires, at or near its own TDC, in the first working cycle of its own crankshaft
    /// ([`EngineParts::working_cycle`]); `None` if the file gives no firing.
    pub firing_angle: Option<f64>,
    /// Index of the first piston of the combustion chamber that it shares (opposed pistons), a lower one; `None`: its chamber is its own,
    /// or it is the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub chamber: Option<usize>,
}

impl Cylinder {
    /// Net offset `e` of the piston pin's line along +v [m]: cylinder offset plus piston-pin offset.
    pub fn net_offset(&self) -> f64 {
        self.offset + self.pin_offset
    }

    /// Reciprocating mass [kg]: piston and the rod's small-end mass.
    pub fn reciprocating_mass(&self) -> f64 {
        self.piston_mass + self.rod.small_end_mass
    }
}

/// A connecting rod as two end masses and what they miss of its inertia.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Rod {
    /// Distance between eye centres [m].
    pub length: f64,
    /// Mass concentrated at the big end (crankpin, or knuckle pin of an articulated rod) [kg].
    pub big_end_mass: f64,
    /// Mass concentrated at the small end (piston pin) [kg].
    pub small_end_mass: f64,
    /// Moment of inertia about the rod's own centre of gravity [kg m^2], where the file gives it.
    pub inertia: Option<f64>,
    /// Moment of inertia along the line of its eyes [kg m^2], for a block that turns in a run in time; 0: slender.
    pub axial_inertia: f64,
    /// How the file gave its mass.
    pub mass_rule: RodMassRule,
    /// What its big end sits on.
    pub joint: RodJoint,
}

impl Default for Rod {
    /// A rod on the crankpin without length and mass: give it both.
    fn default() -> Rod {
        Rod::by_thirds(0.0, 0.0)
    }
}

impl Rod {
    /// A rod of this length [m] and mass [kg] on the crankpin, two thirds of the mass at the big end, as point masses.
    pub fn by_thirds(length: f64, mass: f64) -> Rod {
        Rod {
            length,
            big_end_mass: mass * 2.0 / 3.0,
            small_end_mass: mass / 3.0,
            inertia: None,
            axial_inertia: 0.0,
            mass_rule: RodMassRule::Thirds,
            joint: RodJoint::Crankpin,
        }
    }

    /// Mass of the whole rod [kg].
    pub fn mass(&self) -> f64 {
        self.big_end_mass + self.small_end_mass
    }

    /// Distance `a` of the centre of gravity from the big-end eye [m] (0 for a massless rod).
    pub fn centre_of_gravity(&self) -> f64 {
        if self.mass() > 0.0 { self.length * self.small_end_mass / self.mass() } else { 0.0 }
    }

    /// What the two end masses have too much of the rod's inertia [kg m^2]: `m_A a^2 + m_B b^2 - I`, 0 where `I` is
    /// not given. It acts on torque and roll moment only.
    pub fn residual_inertia(&self) -> f64 {
        let Some(inertia) = self.inertia else { return 0.0 };
        let a = self.centre_of_gravity();
        let b = self.length - a;
        self.big_end_mass * a * a + self.small_end_mass * b * b - inertia
    }
}

/// How the file gave the rod's mass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RodMassRule {
    /// Two thirds of the mass at the big end, one third at the small end.
    Thirds,
    /// Both ends weighed.
    WeighedEnds,
    /// Mass and centre of gravity.
    CentreOfGravity,
}

/// What a rod's big end sits on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum RodJoint {
    /// The crankpin, alone or side by side with other rods.
    Crankpin,
    /// The crankpin, as the fork of a fork-and-blade pair (same plane as its blade).
    Fork,
    /// The crankpin, as the blade of a fork-and-blade pair.
    Blade,
    /// A knuckle pin on the master rod of another cylinder.
    Articulated {
        /// Index of the master's cylinder.
        master: usize,
        /// Distance of the knuckle pin from the crankpin [m].
        knuckle_radius: f64,
        /// Direction of the knuckle pin from the crankpin [rad], from the master rod's line (crankpin to piston pin)
        /// towards the same sense as angles in the frame (+x to +y).
        knuckle_angle: f64,
    },
}

/// A weight fixed to a crankshaft.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Counterweight {
    /// Name for tables: "web 1", "throw 2", "flywheel", or the user's.
    pub name: String,
    /// Index of its crankshaft.
    pub crankshaft: usize,
    /// Plane [m], from the origin.
    pub z: f64,
    /// Unbalance: mass times radius [kg m], not negative.
    pub unbalance: f64,
    /// Direction on the crankshaft [rad]: it stands at `ratio * theta + phase + angle`.
    pub angle: f64,
    /// The part that it is, where the file gives its shape: plane, unbalance and direction are those of the part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<Box<CounterweightPart>>,
}

/// A balance shaft: weights on an axis parallel to the crankshaft.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BalanceShaft {
    /// Name for tables and pictures.
    pub name: String,
    /// Speed over that of crankshaft 1, signed; never 0.
    pub ratio: Ratio,
    /// Position of its axis [m].
    pub x: f64,
    /// Position of its axis [m].
    pub y: f64,
    /// Its weights.
    pub weights: Vec<ShaftWeight>,
    /// Its polar moment of inertia about its axis [kg m^2], where the file gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inertia: Option<f64>,
}

impl BalanceShaft {
    /// Name of its weight `index`: "left weight 1", or that of the shaft where it has one weight.
    pub fn weight_name(&self, index: usize) -> String {
        if self.weights.len() == 1 {
            self.name.clone()
        } else {
            format!("{} weight {}", self.name, index + 1)
        }
    }
}

/// A weight on a balance shaft.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ShaftWeight {
    /// Plane [m], from the origin.
    pub z: f64,
    /// Unbalance: mass times radius [kg m], not negative.
    pub unbalance: f64,
    /// Direction at `theta = 0` [rad]: it stands at `ratio * theta + phase`.
    pub phase: f64,
    /// The part that it is, where the file gives its shape: the unbalance is that of the part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<ShaftWeightPart>,
}

impl ShaftWeight {
    /// A weight in the plane `z` [m] with this unbalance [kg m] and direction at `theta = 0` [rad], of no particular shape.
    pub fn new(z: f64, unbalance: f64, phase: f64) -> ShaftWeight {
        ShaftWeight { z, unbalance, phase, part: None }
    }
}

/// Angle of crankshaft 1 [rad] in which a cylinder on a crankshaft of this ratio fires once: a working cycle of its own crankshaft.
pub fn working_cycle(strokes: Strokes, ratio: Ratio) -> f64 {
    TAU * f64::from(strokes.revolutions()) / ratio.value().abs()
}

impl EngineParts {
    /// Turns weights of less than nothing, on crankshafts and shafts, into amounts on the other side.
    pub fn turn_negative_weights(&mut self) {
        let of_shafts = self.shafts.iter_mut().flat_map(|shaft| &mut shaft.weights);
        let of_shafts = of_shafts.map(|weight| (&mut weight.unbalance, &mut weight.phase));
        let of_crank =
            self.counterweights.iter_mut().map(|weight| (&mut weight.unbalance, &mut weight.angle));
        for (amount, direction) in of_shafts.chain(of_crank).filter(|(amount, _)| **amount < 0.0) {
            (*amount, *direction) = (-*amount, *direction + PI);
        }
    }

    /// Indices of the pistons of the chamber of cylinder `index`, rising: one but where pistons share it.
    pub fn chamber_pistons(&self, index: usize) -> Vec<usize> {
        let first = |index: usize| self.cylinders[index].chamber.unwrap_or(index);
        (0..self.cylinders.len()).filter(|other| first(*other) == first(index)).collect()
    }

    /// Angle of crankshaft 1 [rad] in which cylinder `index` fires once: a working cycle of its own crankshaft.
    pub fn working_cycle(&self, index: usize) -> f64 {
        let crankshaft = self.throws[self.cylinders[index].throw].crankshaft;
        working_cycle(self.strokes, self.crankshafts[crankshaft].ratio)
    }

    /// Angle of the pin of throw `throw` [rad] at crank angle `theta` [rad].
    pub fn pin_angle(&self, throw: usize, theta: f64) -> f64 {
        let throw = &self.throws[throw];
        let crankshaft = &self.crankshafts[throw.crankshaft];
        crankshaft.ratio.value() * theta + crankshaft.phase + throw.angle
    }

    /// Whether the file says how the block stands on its mounts: its body, and the spring of every mount.
    pub fn is_on_springs(&self) -> bool {
        self.block.is_some() && self.mounts.iter().all(|mount| mount.spring.is_some())
    }

    /// Rotating mass at the pin of throw `throw` times its radius [kg m]: big ends of its rods, masters carrying the
    /// big ends of their articulated rods, without the crank itself and without counterweights.
    pub fn rod_unbalance(&self, throw: usize) -> f64 {
        let mass: f64 = self.cylinders.iter().filter(|c| c.throw == throw).map(|c| c.rod.big_end_mass).sum();
        mass * self.throws[throw].radius
    }

    /// Unbalance along throw `throw` [kg m] that the crank's own counterweights must answer: webs, pin and big ends.
    pub fn rotating_unbalance(&self, throw: usize) -> f64 {
        self.throws[throw].unbalance + self.rod_unbalance(throw)
    }

    /// All that is geared to the crank: balance shafts, then gears as shafts without weights.
    pub fn geared_shafts(&self) -> Vec<BalanceShaft> {
        let of = |gear: &Gear| BalanceShaft {
            name: gear.name.clone(),
            ratio: gear.ratio,
            x: gear.x,
            y: gear.y,
            weights: Vec::new(),
            inertia: gear.inertia().map(|inertia| inertia.value),
        };
        self.shafts.iter().cloned().chain(self.gears.iter().map(of)).collect()
    }
}
