//! Loads of every joint at one instant, by Newton and Euler from the piston inwards.
//!
//! ```text
//! piston   X + N + m g - (f + c s' w) u = m a                                X: rod on the piston pin, N: wall on the piston
//! rod      B - X + SUM F_k + m g = m a                                       B: lower pin on the rod, F_k: articulated rods on it
//!          C + (c - P) x m (g - a) - d x X + SUM (K - P) x F_k + C_k = I alpha + spin x I spin         about the lower pin P
//! rotor    journals, gear and torque from outside + rods - U (a of its unbalances) = its polar inertia's share
//! ```
//! The component of the rod's balance of moments along z gives X across the cylinder; the other two are carried by the crankpin, or by the piston pin
//! where [`Guidance::Piston`] says so. A rotor is as in [`crate::Rotor`]: its weight and its mass are with the block, so that the loads of main bearings
//! lack them.

use crate::block_body::in_plane;
use crate::main_loads::MainLoads;
use crate::motion::Motion;
use crate::place::Place;
use crate::rotor_shares::{RotorShares, ShaftLoad};
use crate::train::{LowerPin, Train};
use nalgebra::Vector3;
use num_complex::Complex64;
use serde::{Deserialize, Serialize};

/// Which pin guides a rod along the crank axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Guidance {
    /// The lower pin: it takes what acts on the rod out of its plane.
    #[default]
    Crankpin,
    /// The piston pin.
    Piston,
}

/// A force and a moment, block axes.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Wrench {
    /// Force [N].
    pub force: [f64; 3],
    /// Moment about the point that the field's text names [N m].
    pub moment: [f64; 3],
}

impl Wrench {
    fn of(force: Vector3<f64>, moment: Vector3<f64>) -> Wrench {
        Wrench { force: force.into(), moment: moment.into() }
    }
}

/// Loads of piston, pins and wall of one cylinder.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct CylinderReactions {
    /// Piston on the cylinder wall, about the piston pin.
    pub wall: Wrench,
    /// Side thrust: its force along `v` of the cylinder [N].
    pub side_thrust: f64,
    /// Rod on the piston pin, about the piston pin.
    pub piston_pin: Wrench,
    /// Rod on its lower pin (crankpin, or knuckle pin), about that pin.
    pub lower_pin: Wrench,
    /// Force on the lower pin along the rod towards the piston, and a quarter turn on, as the pin bears on the rod [N].
    pub rod_frame: [f64; 2],
    /// Travel of the piston pin along the cylinder axis relative to the block: position [m], speed [m/s], acceleration [m/s^2].
    pub travel: [f64; 3],
    /// Force on the crankpin along its throw, and across it where it drives the crankshaft [N]; 0 for a knuckle pin.
    pub throw_frame: [f64; 2],
}

/// Loads of one crankshaft or balance shaft.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct RotorReactions {
    /// Shaft on its bearings, about its axis in the plane of the origin; no moment about the axis.
    pub bearings: Wrench,
    /// Torque of its gear or chain on it [N m]; for crankshaft 1 that of all gears together.
    pub gear_torque: f64,
    /// Force of its teeth on it at the pitch point, along the line of action, where the pressure angle is given, else 0 [N]; for crankshaft 1 the sum of all. The
    /// bearings carry it.
    pub gear_force: [f64; 3],
    /// Journals on the main bearings by rule ([`crate::MainRule::ALL`]), then by main: `x`, `y` [N]; empty without two mains.
    #[schemars(with = "[Vec<[f64; 2]>; 3]")]
    pub mains: MainLoads,
}

/// Loads of all joints at one instant.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Reactions {
    /// By cylinder.
    pub cylinders: Vec<CylinderReactions>,
    /// Crankshafts, then balance shafts.
    pub rotors: Vec<RotorReactions>,
    /// All that pistons, rods and rotors do to the block, with gas on the heads and gears, about the origin. What acts from outside
    /// on crankshaft 1 without passing the block is in it, as the reaction to the torque that leaves.
    pub on_block: Wrench,
    /// Torque that the crank train delivers at crankshaft 1 [N m]: to load, starter, friction and driveline.
    pub shaft_torque: f64,
}

/// Accelerations of the seven speeds, and what acts besides inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant<'a> {
    /// Pose and speeds.
    pub motion: &'a Motion,
    /// Where pistons and rods are.
    pub places: &'a [Place],
    /// Rates of the seven speeds of [`Motion::speeds`].
    pub rates: [f64; 7],
    /// Gas force on every piston towards the crank [N].
    pub gas: &'a [f64],
    /// Acceleration of gravity in block axes [m/s^2].
    pub gravity: Vector3<f64>,
    /// Viscous friction of a piston along its cylinder [N s/m].
    pub piston_damping: f64,
    /// Which pin guides the rods.
    pub guidance: Guidance,
}

/// The motion of a point that moves in the block.
struct Carrier {
    /// Acceleration of the block's origin.
    linear: Vector3<f64>,
    angular: Vector3<f64>,
    spin: Vector3<f64>,
    speed: f64,
    rate: f64,
    /// Whether the block moves.
    moves: bool,
}

impl Carrier {
    fn new(motion: &Motion, rates: &[f64; 7]) -> Carrier {
        let [x, y, z, about_x, about_y, about_z, rate] = *rates;
        let at_rest = rates[..6] == [0.0; 6];
        Carrier {
            moves: !at_rest || motion.spin != Vector3::zeros() || motion.velocity != Vector3::zeros(),
            linear: Vector3::new(x, y, z) + motion.spin.cross(&motion.velocity),
            angular: Vector3::new(about_x, about_y, about_z),
            spin: motion.spin,
            speed: motion.speed,
            rate,
        }
    }

    /// What the acceleration of a point has in proportion to its place.
    #[inline]
    fn turned(&self, [at, rate, bend]: [Vector3<f64>; 3]) -> Vector3<f64> {
        let w = self.speed;
        if !self.moves {
            return w * w * bend + self.rate * rate;
        }
        self.angular.cross(&at)
            + self.spin.cross(&(self.spin.cross(&at) + 2.0 * w * rate))
            + w * w * bend
            + self.rate * rate
    }

    #[inline]
    fn point(&self, c: [Vector3<f64>; 3]) -> Vector3<f64> {
        self.linear + self.turned(c)
    }

    /// What the acceleration of a point that stands still in the block gains for each metre along the crank axis.
    fn along_axis(&self) -> Vector3<f64> {
        let z = Vector3::z();
        self.angular.cross(&z) + self.spin.cross(&self.spin.cross(&z))
    }

    /// Acceleration of a point that stands still in the block.
    #[inline]
    fn still(&self, at: Vector3<f64>) -> Vector3<f64> {
        self.linear + self.angular.cross(&at) + self.spin.cross(&self.spin.cross(&at))
    }
}

/// Room for the loads of one instant, kept from instant to instant.
#[derive(Default)]
pub(crate) struct Scratch {
    handed: Vec<Option<Handed>>,
    loads: Vec<ShaftLoad>,
    /// Forces on crankshaft 1 by teeth, with their planes.
    teeth: Vec<(Vector3<f64>, f64)>,
}

/// What a rod hands on.
#[derive(Clone, Copy)]
struct Handed {
    /// On the lower pin.
    force: Vector3<f64>,
    couple: Vector3<f64>,
}

/// Inertia moment of a rotor by what its inertias across its axis differ: `-(I alpha + spin x I spin)` with `I z = 0`.
fn unequal_moment(unequal: Complex64, carrier: &Carrier, ratio: f64) -> Vector3<f64> {
    if unequal == Complex64::ZERO {
        return Vector3::zeros();
    }
    let half = 0.5 * unequal;
    let tensor =
        |x: &Vector3<f64>| Vector3::new(-half.re * x.x - half.im * x.y, -half.im * x.x + half.re * x.y, 0.0);
    let turning = ratio * carrier.speed * Vector3::z();
    let alpha = carrier.angular + carrier.spin.cross(&turning);
    -(tensor(&alpha) + (carrier.spin + turning).cross(&tensor(&carrier.spin)))
}

impl Train {
    /// Loads of all joints at one instant; `shares` as [`Train::main_shares`] gives them.
    pub fn reactions(&self, instant: &Instant<'_>, shares: &[RotorShares]) -> Reactions {
        self.reactions_with(instant, shares, &mut Scratch::default())
    }

    /// The same with room from before.
    pub(crate) fn reactions_with(
        &self,
        instant: &Instant<'_>,
        shares: &[RotorShares],
        scratch: &mut Scratch,
    ) -> Reactions {
        let carrier = Carrier::new(instant.motion, &instant.rates);
        let mut cylinders = vec![CylinderReactions::default(); self.cylinders.len()];
        scratch.handed.clear();
        scratch.handed.resize(self.cylinders.len(), None);
        // Articulated rods first: their masters carry them.
        let is_slave = |index: &usize| self.cylinders[*index].lower_pin != LowerPin::Crankpin;
        let articulated = self.order.last().is_some_and(is_slave);
        for &index in self.order.iter().rev() {
            let carried = if articulated { &scratch.handed[..] } else { &[] };
            let (own, on_pin) = self.rod(instant, &carrier, index, carried);
            cylinders[index] = own;
            scratch.handed[index] = Some(on_pin);
        }
        let mut on_block = [Vector3::zeros(); 2];
        for (index, own) in cylinders.iter().enumerate() {
            let cylinder = &self.cylinders[index];
            let shaft = self.rotors[cylinder.rotor].axis;
            let place = &instant.places[index];
            let pin = in_plane(
                shaft + cylinder.axis * Complex64::new(place.travel[0], cylinder.net_offset),
                cylinder.z,
            );
            let head = in_plane(shaft + cylinder.axis * Complex64::new(0.0, cylinder.offset), cylinder.z);
            let (wall, moment) = (Vector3::from(own.wall.force), Vector3::from(own.wall.moment));
            let gas = instant.gas[index] * in_plane(cylinder.axis, 0.0);
            on_block[0] += wall + gas;
            on_block[1] += moment + pin.cross(&wall) + head.cross(&gas);
        }
        let mut rotors: Vec<RotorReactions> = Vec::with_capacity(self.rotors.len());
        let (mut reflected, mut beside) = (0.0, 0.0);
        scratch.teeth.clear();
        for index in (0..self.rotors.len()).rev() {
            let (mut own, torque) = self.rotor(instant, &carrier, index, shares.get(index), scratch);
            let axis = in_plane(self.rotors[index].axis, 0.0);
            let force = Vector3::from(own.bearings.force);
            on_block[0] += force;
            on_block[1] += Vector3::from(own.bearings.moment) + axis.cross(&force);
            // Of crankshaft 1 the torque that is missing comes from outside, of the others from their gear.
            if index == 0 {
                own.gear_torque = -reflected;
                let outside = torque - own.gear_torque;
                rotors.push(own);
                rotors.reverse();
                on_block[1].z -= beside;
                let on_block = Wrench::of(on_block[0], on_block[1]);
                return Reactions { cylinders, rotors, on_block, shaft_torque: -outside };
            }
            own.gear_torque = torque;
            reflected += self.rotors[index].ratio * torque;
            // Where the teeth are known, the bearings carry what the axes' distance makes of their force.
            if self.rotors[index].mesh.is_none() {
                beside += torque - self.rotors[index].ratio * torque;
            }
            rotors.push(own);
        }
        Reactions { cylinders, on_block: Wrench::of(on_block[0], on_block[1]), ..Reactions::default() }
    }

    fn rod(
        &self,
        instant: &Instant<'_>,
        carrier: &Carrier,
        index: usize,
        handed: &[Option<Handed>],
    ) -> (CylinderReactions, Handed) {
        let (cylinder, place) = (&self.cylinders[index], &instant.places[index]);
        let shaft = self.rotors[cylinder.rotor].axis;
        let u = in_plane(cylinder.axis, 0.0);
        let v = in_plane(cylinder.axis * Complex64::I, 0.0);
        let z = Vector3::z();
        let [s, s1, s2] = place.travel;
        let w = carrier.speed;
        // Without the pin and the wall the piston would need this more.
        let drive = (instant.gas[index] + instant.piston_damping * s1 * w) * u;
        let at = in_plane(shaft + cylinder.axis * Complex64::new(s, cylinder.offset), cylinder.z);
        let piston_rate = carrier.point([at, s1 * u, s2 * u]) - instant.gravity;
        let piston_needs = cylinder.piston_mass * piston_rate + drive;
        let centre = place.on_rod(cylinder.rod.centre);
        let [rate, bend] = [in_plane(centre[1], 0.0), in_plane(centre[2], 0.0)];
        let at = in_plane(shaft + centre[0], cylinder.z);
        let mut rod_needs = cylinder.rod.mass * (carrier.point([at, rate, bend]) - instant.gravity);
        let [sigma1, sigma2] = place.swing;
        let spin = Vector3::new(carrier.spin.x, carrier.spin.y, carrier.spin.z + sigma1 * w);
        // sigma' w Omega x z besides the block's and the rod's own.
        let alpha = Vector3::new(
            carrier.angular.x + sigma1 * w * carrier.spin.y,
            carrier.angular.y - sigma1 * w * carrier.spin.x,
            carrier.angular.z + sigma1 * carrier.rate + sigma2 * w * w,
        );
        let d = in_plane(place.rod[0], 0.0);
        let slender =
            (cylinder.rod.inertia - cylinder.rod.axial_inertia) / (cylinder.rod.length * cylinder.rod.length);
        // J x less what the rod lacks along itself.
        let tensor = |x: &Vector3<f64>| cylinder.rod.inertia * x - slender * d.dot(x) * d;
        let from_pin = cylinder.rod.centre * d;
        let mut moment = from_pin.cross(&rod_needs) + tensor(&alpha) + spin.cross(&tensor(&spin));
        for (other, on_pin) in handed.iter().enumerate() {
            let LowerPin::Knuckle { master, place: knuckle } = self.cylinders[other].lower_pin else {
                continue;
            };
            let Some(on_pin) = on_pin.filter(|_| master == index) else { continue };
            let lift = self.cylinders[other].z - cylinder.z;
            let at = in_plane(knuckle * place.rod[0], lift);
            rod_needs -= on_pin.force;
            moment -= at.cross(&on_pin.force) + on_pin.couple;
        }
        // What the rod needs about its lower pin is C - d x X: along z it is the pin force across the cylinder.
        let along = piston_needs.dot(&u);
        let across = (-moment.z - along * d.cross(&u).z) / d.dot(&u);
        let mut pin = along * u + across * v;
        let mut pin_couple = Vector3::zeros();
        if instant.guidance == Guidance::Piston {
            pin -= rod_needs.z * z;
            pin_couple = -(moment + d.cross(&pin));
            pin_couple.z = 0.0;
        }
        let lower = rod_needs + pin;
        let mut lower_couple = moment + d.cross(&pin) + pin_couple;
        lower_couple.z = 0.0;
        let wall = piston_needs - pin;
        let wall = wall - wall.dot(&u) * u;
        // The piston's centre lies on the cylinder axis, beside its pin.
        let beside = (cylinder.offset - cylinder.net_offset) * v;
        let wall_moment = beside.cross(&piston_needs) - pin_couple;
        let on_pin = Handed { force: -lower, couple: -lower_couple };
        let bearing = Complex64::new(lower.x, lower.y) * place.rod[0].conj() / cylinder.rod.length;
        let throw_frame = match cylinder.lower_pin {
            LowerPin::Crankpin => {
                let pin = place.lower_pin[0];
                let along =
                    Complex64::new(on_pin.force.x, on_pin.force.y) * pin.conj() / pin.norm_sqr().sqrt();
                [along.re, along.im * self.rotors[cylinder.rotor].ratio.signum()]
            }
            LowerPin::Knuckle { .. } => [0.0; 2],
        };
        let own = CylinderReactions {
            wall: Wrench::of(-wall, -wall_moment),
            side_thrust: -wall.dot(&v),
            piston_pin: Wrench::of(pin, pin_couple),
            lower_pin: Wrench::of(on_pin.force, on_pin.couple),
            rod_frame: [bearing.re, bearing.im],
            travel: [s, s1 * w, s1 * carrier.rate + s2 * w * w],
            throw_frame,
        };
        // The wall takes the friction of the piston too.
        let rubbing = instant.piston_damping * s1 * w * u;
        let wrench = Wrench::of(rubbing - wall, -wall_moment + beside.cross(&rubbing));
        (CylinderReactions { wall: wrench, ..own }, on_pin)
    }

    /// Reactions of a rotor, and the torque that it needs from its gear or from outside.
    fn rotor(
        &self,
        instant: &Instant<'_>,
        carrier: &Carrier,
        index: usize,
        shares: Option<&RotorShares>,
        scratch: &mut Scratch,
    ) -> (RotorReactions, f64) {
        let rotor = &self.rotors[index];
        let (z, w) = (Vector3::z(), carrier.speed);
        let turn = Complex64::cis(rotor.ratio * instant.motion.theta);
        let Scratch { handed, loads, teeth } = scratch;
        loads.clear();
        // Unbalances a + i b turn together: what they exert is linear in a and b, and in the planes that they are in.
        let directions = [turn, turn * Complex64::I].map(|unit| in_plane(unit, 0.0));
        let [force_a, force_b] = [turn, turn * Complex64::I].map(|unit| {
            let rates = [unit, unit * Complex64::new(0.0, rotor.ratio), -rotor.ratio * rotor.ratio * unit];
            -carrier.turned(rates.map(|across| in_plane(across, 0.0)))
        });
        let at_axis = instant.gravity - carrier.still(in_plane(rotor.axis, 0.0));
        let [couple_a, couple_b] = directions.map(|unit| unit.cross(&at_axis));
        let along = carrier.along_axis();
        let [by_plane_a, by_plane_b] = directions.map(|unit| -unit.cross(&along));
        let spin = carrier.spin.z + rotor.ratio * w;
        let gyroscopic = -spin * Vector3::new(carrier.spin.y, -carrier.spin.x, 0.0);
        let zero = Vector3::zeros();
        loads.push(ShaftLoad { force: force_a, couple: couple_a });
        loads.push(ShaftLoad { force: force_b, couple: couple_b });
        loads.push(ShaftLoad { force: zero, couple: by_plane_a });
        loads.push(ShaftLoad { force: zero, couple: by_plane_b });
        loads.push(ShaftLoad { force: zero, couple: gyroscopic });
        let unequal = unequal_moment(rotor.unequal * turn * turn, carrier, rotor.ratio);
        loads.push(ShaftLoad { force: zero, couple: unequal });
        let (first, product) = (rotor.first_moment, rotor.product);
        let mut force = first.re * force_a + first.im * force_b;
        let mut moment = first.re * couple_a
            + first.im * couple_b
            + product.re * (by_plane_a + z.cross(&force_a))
            + product.im * (by_plane_b + z.cross(&force_b))
            + rotor.inertia * gyroscopic
            + unequal;
        for (cylinder, on_pin) in self.cylinders.iter().zip(handed.iter()) {
            let on_crankpin = cylinder.rotor == index && cylinder.lower_pin == LowerPin::Crankpin;
            if let Some(on_pin) = on_pin.filter(|_| on_crankpin) {
                let pin = in_plane(cylinder.crankpin * turn, 0.0);
                let couple = on_pin.couple + pin.cross(&on_pin.force);
                force += on_pin.force;
                moment += couple + cylinder.z * z.cross(&on_pin.force);
                loads.push(ShaftLoad { force: on_pin.force, couple });
            }
        }
        let needs = rotor.inertia * (carrier.angular.z + rotor.ratio * carrier.rate);
        let torque = needs - moment.z;
        moment.z = 0.0;
        let mut gear_force = Vector3::zeros();
        if let (Some(mesh), true) = (rotor.mesh, index > 0) {
            let own = self.mesh_force(index, mesh, torque);
            teeth.push((-own, mesh.z));
            (gear_force, force, moment) = (own, force + own, moment + mesh.z * z.cross(&own));
            loads.push(ShaftLoad { force: own, couple: zero });
        } else if index == 0 {
            for (own, plane) in teeth.iter() {
                gear_force += own;
                force += own;
                moment += *plane * z.cross(own);
                loads.push(ShaftLoad { force: *own, couple: zero });
            }
        }
        let mains = shares.map_or_else(Default::default, |shares| shares.carried(loads));
        let bearings = Wrench::of(force, moment);
        (RotorReactions { bearings, gear_torque: 0.0, gear_force: gear_force.into(), mains }, torque)
    }
}
