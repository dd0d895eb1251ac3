//! An engine as bodies and joints of the referee: block, rotors, pistons, rods; every joint with as many rows as leave nothing undetermined.

use crate::block::BlockBody;
use crate::block_body::in_plane;
use crate::motion::Motion;
use crate::place::Place;
use crate::reactions::Guidance;
use crate::referee::{Assembly, BodyIndex, GROUND, Joint, Pose, RigidBody};
use crate::train::{LowerPin, Train};
use nalgebra::{Matrix3, Rotation3, Vector3};
use num_complex::Complex64;

/// An engine in maximal coordinates, with the indices of its bodies and joints.
#[derive(Debug, Clone, PartialEq)]
pub struct RefereeEngine {
    /// Bodies and joints.
    pub assembly: Assembly,
    /// Where they are.
    pub poses: Vec<Pose>,
    /// The block.
    pub block: BodyIndex,
    /// Crankshafts, then balance shafts.
    pub rotors: Vec<BodyIndex>,
    /// Piston and rod of every cylinder.
    pub cylinders: Vec<[BodyIndex; 2]>,
    /// Joint of every rotor with the block.
    pub bearings: Vec<usize>,
    /// Gear of every rotor but the first.
    pub gears: Vec<usize>,
    /// Joints of every cylinder: piston in the block, rod on its lower pin, rod in the piston.
    pub joints: Vec<[usize; 3]>,
}

impl Train {
    /// The engine as the referee sees it, placed as `motion` and `places` say, with velocities from its own constraints; `None` where these do not determine
    /// them. Without a body of its own the block is welded to the ground.
    pub fn referee(&self, motion: &Motion, places: &[Place], guidance: Guidance) -> Option<RefereeEngine> {
        let rotation = motion.rotation();
        let at = |place: Vector3<f64>, turn: f64| {
            let own = Rotation3::from_axis_angle(&Vector3::z_axis(), turn).into_inner();
            Pose::at(motion.position + rotation * place, rotation * own)
        };
        let z = Vector3::z();
        let mut assembly = Assembly::default();
        let mut poses = vec![at(Vector3::zeros(), 0.0)];
        let alone = self.block.unwrap_or(BlockBody {
            mass: 1.0,
            first_moment: Vector3::zeros(),
            inertia: Matrix3::identity(),
        });
        let block = assembly.add(RigidBody {
            name: "block".into(),
            mass: alone.mass,
            first_moment: alone.first_moment,
            inertia: alone.inertia,
        });
        let (mut joints, mut rotors, mut bearings, mut gears) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (index, rotor) in self.rotors.iter().enumerate() {
            let product = rotor.product;
            let unequal = 0.5 * rotor.unequal;
            let inertia = Matrix3::new(
                -unequal.re,
                -unequal.im,
                -product.re, //
                -unequal.im,
                unequal.re,
                -product.im, //
                -product.re,
                -product.im,
                rotor.inertia,
            );
            let first_moment = in_plane(rotor.first_moment, 0.0);
            let body = assembly.add(RigidBody { name: rotor.name.clone(), mass: 0.0, first_moment, inertia });
            let axis = in_plane(rotor.axis, 0.0);
            poses.push(at(axis, rotor.ratio * motion.theta));
            bearings.push(joints.len());
            joints.push(Joint::revolute("bearings", block, body, [axis, Vector3::zeros()], [z, z]));
            if index > 0 {
                gears.push(joints.len());
                joints.push(Joint::gear("gear", block, body, rotors[0], z, rotor.ratio));
            }
            rotors.push(body);
        }
        let mut cylinders = vec![[GROUND; 2]; self.cylinders.len()];
        let mut of_cylinders = vec![[0; 3]; self.cylinders.len()];
        for &index in &self.order {
            let (cylinder, place) = (&self.cylinders[index], &places[index]);
            let shaft = self.rotors[cylinder.rotor].axis;
            let centre = in_plane(
                shaft + cylinder.axis * Complex64::new(place.travel[0], cylinder.offset),
                cylinder.z,
            );
            let piston = assembly.add(RigidBody::central("piston", cylinder.piston_mass, Matrix3::zeros()));
            poses.push(at(centre, 0.0));
            let rod_centre = in_plane(shaft + place.on_rod(cylinder.rod.centre)[0], cylinder.z);
            let (across, along) = (cylinder.rod.inertia, cylinder.rod.axial_inertia);
            let inertia = Matrix3::from_diagonal(&Vector3::new(along, across, across));
            let rod = assembly.add(RigidBody::central("rod", cylinder.rod.mass, inertia));
            poses.push(at(rod_centre, place.rod[0].arg()));
            let length = cylinder.rod.length;
            let [lower, upper] =
                [-cylinder.rod.centre, 1.0 - cylinder.rod.centre].map(|share| share * length * Vector3::x());
            let line = in_plane(cylinder.axis, 0.0);
            let wall =
                Joint::prismatic("piston in its cylinder", block, piston, [centre, Vector3::zeros()], line);
            let (holder, pin) = match cylinder.lower_pin {
                LowerPin::Crankpin => (rotors[cylinder.rotor], in_plane(cylinder.crankpin, cylinder.z)),
                LowerPin::Knuckle { master, place } => {
                    let own = &self.cylinders[master];
                    // From the master's centre, along its rod and across.
                    let from_pin = place * own.rod.length - own.rod.centre * own.rod.length;
                    (cylinders[master][1], in_plane(from_pin, cylinder.z - own.z))
                }
            };
            let beside = cylinder.net_offset - cylinder.offset;
            let gudgeon = in_plane(cylinder.axis * Complex64::I * beside, 0.0);
            let (on_pin, on_piston) = match guidance {
                Guidance::Crankpin => (
                    Joint::revolute("rod on its lower pin", holder, rod, [pin, lower], [z, z]),
                    Joint::point_in_line("rod in its piston", piston, rod, [gudgeon, upper], z),
                ),
                Guidance::Piston => (
                    Joint::point_in_line("rod on its lower pin", holder, rod, [pin, lower], z),
                    Joint::revolute("rod in its piston", piston, rod, [gudgeon, upper], [z, z]),
                ),
            };
            of_cylinders[index] = [joints.len(), joints.len() + 1, joints.len() + 2];
            joints.extend([wall, on_pin, on_piston]);
            cylinders[index] = [piston, rod];
        }
        assembly.joints = joints;
        let velocity = rotation * motion.velocity;
        let spin = rotation * motion.spin;
        let crank = rotation * (motion.spin + motion.speed * z);
        let mut given: Vec<(BodyIndex, usize, f64)> = Vec::new();
        for k in 0..3 {
            given.extend([(block, k, velocity[k]), (block, 3 + k, spin[k])]);
        }
        // The crank's freedom: the component of its spin that its axis has most of.
        let most = (rotation * z).iamax();
        given.push((rotors[0], 3 + most, crank[most]));
        assembly.set_velocities(&mut poses, &given)?;
        if self.block.is_none() {
            let origin = [motion.position, Vector3::zeros()];
            let mut weld = Joint::spherical("block on the ground", GROUND, block, origin);
            let across = [(0, 1), (1, 2), (2, 0)];
            weld.rows.extend(across.map(|(a, b)| crate::referee::Row::Turn {
                of_a: rotation * Vector3::ith(a, 1.0),
                of_b: Vector3::ith(b, 1.0),
            }));
            assembly.joints.push(weld);
        }
        Some(RefereeEngine {
            assembly,
            poses,
            block,
            rotors,
            cylinders,
            bearings,
            gears,
            joints: of_cylinders,
        })
    }
}
