//! The crank train as it enters the loads: an engine boiled down to rotors and pistons at one speed.
//!
//! Every moving mass acts on the block with `F = -m a`. What turns at a constant rate is summed into one *rotor* a
//! speed ratio; every piston with its rod keeps its own *piston* entry:
//!
//! ```text
//! rotor:  F = P e^{i n theta},  M_x + i M_y = Q e^{i n theta},  M_z = Im( Y e^{i n theta} )      n: its speed ratio
//!         P = SUM U w^2 e^{i angle},  Q = SUM i (z - z0) P,  Y = SUM conj(axis - axis0) P
//! piston: F = -G s'',  M_x + i M_y = -H s'',  T = -n (m W^2 s' s'' + J W^2 beta' beta'')
//!         M_z = -T - R s'' + J W^2 beta''
//!         G = m W^2 e^{ib},  H = i (z - z0) G,  R = W^2 SUM m_j ( Im(conj(axis - axis0) e^{ib}) - v_j )
//! ```
//! | symbol     | name                                                                     | unit   |
//! |------------|--------------------------------------------------------------------------|--------|
//! | w, W       | speed of crankshaft 1, of the piston's own crankshaft: `W = n w`         | rad/s  |
//! | U          | unbalance: mass times radius                                             | kg m   |
//! | m          | reciprocating mass; `m_j`, `v_j`: piston and small end and their offsets | kg, m  |
//! | J          | what the two-mass rod misses of the rod's inertia, `-residual_inertia`   | kg m^2 |
//! | axis, z    | axis of the crankshaft and plane; index 0: the reference point           | m      |
//! | s, beta    | travel and rod angle ([`crate::linkage`]), derivatives by the own angle  | m, rad |
//!
//! Roll moment: `M_z = -T - dL/dt` with the angular momentum `L` of all moving parts about the reference axis and the
//! inertia torque `T = -(dE/dt) / w` at crankshaft 1: the driveline takes `T` without reacting on the block, the gears
//! of a geared crankshaft react on it. Shafts and crankshafts turn at a constant rate, so that their own spin is
//! constant.
//!
//! Articulated rods: the big-end mass at the knuckle pin `K` counts at the crankpin `A` with the rotating parts (as
//! [`Engine::rod_unbalance`] does); what its true motion adds, `-m (K'' - A'')`, counts with the reciprocating parts.

use crate::inertia::order_axis::OrderAxis;
use crate::inertia::part::Part;
use crate::inertia::request::{LoadError, LoadRequest, MAX_REVOLUTIONS};
use crate::train::drive::{Drive, Linkage};
use crate::train::linkage::{Articulated, Slider};
use lanchester_model::{Cylinder, Engine, Ratio, RodJoint, greatest_common_divisor};
use num_complex::Complex64;

/// Which masses of the engine count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Selection {
    /// All of them.
    All,
    /// One kind of part.
    Part(Part),
    /// One cylinder, by index: piston, rod and its share of the throw's own unbalance.
    Cylinder(usize),
}

impl Selection {
    /// Share (0 or 1) of `part` of cylinder `cylinder`.
    fn share(self, part: Part, cylinder: usize) -> f64 {
        let counts = match self {
            Selection::All => true,
            Selection::Part(one) => one == part,
            Selection::Cylinder(one) => one == cylinder,
        };
        f64::from(u8::from(counts))
    }

    /// Whether `part`, which belongs to no cylinder, counts.
    fn has_device(self, part: Part) -> bool {
        self == Selection::All || self == Selection::Part(part)
    }
}

/// Masses that turn at one constant speed ratio.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Rotor {
    /// Speed over that of crankshaft 1.
    pub ratio: Ratio,
    /// `P` [N].
    pub force: Complex64,
    /// `Q` [N m].
    pub couple: Complex64,
    /// `Y` [N m].
    pub roll: Complex64,
}

/// The big-end mass of an articulated rod: what its motion about the crankpin adds.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct KnuckleMass {
    /// `m W^2` turned from the master's frame into the engine's [N/m].
    pub force: Complex64,
    /// `i (z - z0)` times `force` [N].
    pub couple: Complex64,
    /// `conj(axis - axis0)` times `force` [N].
    pub roll: Complex64,
    /// `m W^2` [N/m].
    pub mass: f64,
}

/// A piston with its rod.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Piston {
    /// Speed ratio of its crankshaft.
    pub ratio: Ratio,
    /// Angle of the crank from the (master's) cylinder axis at `theta = 0` [rad].
    pub phase: f64,
    /// Its motion.
    pub drive: Drive,
    /// `G` [N/m].
    pub force: Complex64,
    /// `H` [N].
    pub couple: Complex64,
    /// `R` [N].
    pub roll: f64,
    /// `m W^2` [N/m].
    pub mass: f64,
    /// `J W^2` [N m].
    pub inertia: f64,
    /// Big-end mass on a knuckle pin.
    pub knuckle: Option<KnuckleMass>,
    /// Crank radius [m].
    pub crank_radius: f64,
    /// Distance of the motion's nearest singularity from the real crank angle [rad].
    pub analytic_margin: f64,
}

/// An engine, or some of its masses, prepared for one speed, reference point and kind of motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Mechanism {
    pub(crate) speed: f64,
    pub(crate) revolutions: u32,
    pub(crate) axis: OrderAxis,
    pub(crate) rotors: Vec<Rotor>,
    pub(crate) pistons: Vec<Piston>,
}

impl Mechanism {
    /// The whole engine, prepared.
    ///
    /// # Errors
    /// [`LoadError`] where the request is impossible or the engine is not valid.
    pub fn new(engine: &Engine, request: &LoadRequest) -> Result<Mechanism, LoadError> {
        Mechanism::of(engine, request, Selection::All)
    }

    /// Some of the engine's masses, prepared.
    ///
    /// # Errors
    /// As [`Mechanism::new`].
    pub fn of(engine: &Engine, request: &LoadRequest, selection: Selection) -> Result<Mechanism, LoadError> {
        request.check(engine)?;
        let speed = request.speed_of(engine);
        let revolutions = period(engine)?;
        request.check_angles(revolutions)?;
        let mut mechanism = Mechanism {
            speed,
            revolutions,
            axis: OrderAxis::of(engine, revolutions, request.max_order),
            rotors: Vec::new(),
            pistons: Vec::new(),
        };
        mechanism.add_rotating(engine, request, selection);
        for index in 0..engine.cylinders.len() {
            mechanism.add_piston(engine, request, selection, index)?;
        }
        mechanism.check_finite()?;
        Ok(mechanism)
    }

    /// Period of the loads [rad] of crankshaft 1.
    pub fn period(&self) -> f64 {
        std::f64::consts::TAU * f64::from(self.revolutions)
    }

    /// Throws, big ends, counterweights and shafts: everything that turns at a constant rate.
    fn add_rotating(&mut self, engine: &Engine, request: &LoadRequest, selection: Selection) {
        for (index, throw) in engine.throws.iter().enumerate() {
            let riders: Vec<usize> =
                (0..engine.cylinders.len()).filter(|&c| engine.cylinders[c].throw == index).collect();
            let share = match selection {
                Selection::Cylinder(one) if riders.contains(&one) => 1.0 / riders.len() as f64,
                Selection::Cylinder(_) => 0.0,
                _ => selection.share(Part::Rotating, index),
            };
            let masses = riders.iter().map(|&c| {
                let cylinder = &engine.cylinders[c];
                let share = selection.share(Part::Rotating, c);
                (cylinder.z, share * cylinder.rod.big_end_mass * throw.radius)
            });
            let masses: Vec<_> =
                std::iter::once((throw.unbalance_plane(), share * throw.unbalance)).chain(masses).collect();
            let crankshaft = &engine.crankshafts[throw.crankshaft];
            let angle = crankshaft.phase + throw.angle;
            for (z, unbalance) in masses {
                let at = [crankshaft.x, crankshaft.y, z];
                self.add_unbalance(request, crankshaft.ratio, at, unbalance, angle);
            }
        }
        if selection.has_device(Part::Counterweights) {
            for weight in &engine.counterweights {
                let crankshaft = &engine.crankshafts[weight.crankshaft];
                let at = [crankshaft.x, crankshaft.y, weight.z];
                let angle = crankshaft.phase + weight.angle;
                self.add_unbalance(request, crankshaft.ratio, at, weight.unbalance, angle);
            }
        }
        if selection.has_device(Part::Shafts) {
            for shaft in &engine.shafts {
                for weight in &shaft.weights {
                    let at = [shaft.x, shaft.y, weight.z];
                    self.add_unbalance(request, shaft.ratio, at, weight.unbalance, weight.phase);
                }
            }
        }
    }

    /// One unbalance [kg m] turning at `ratio` about an axis at `at` (x, y, z).
    fn add_unbalance(
        &mut self,
        request: &LoadRequest,
        ratio: Ratio,
        at: [f64; 3],
        unbalance: f64,
        angle: f64,
    ) {
        if unbalance == 0.0 {
            return;
        }
        let own_speed = ratio.value() * self.speed;
        let force = Complex64::from_polar(unbalance * own_speed * own_speed, angle);
        let [x, y, z] = std::array::from_fn(|j| at[j] - request.reference[j]);
        let place = self.rotors.iter().position(|r| r.ratio == ratio).unwrap_or_else(|| {
            let zero = Complex64::ZERO;
            self.rotors.push(Rotor { ratio, force: zero, couple: zero, roll: zero });
            self.rotors.len() - 1
        });
        let rotor = &mut self.rotors[place];
        rotor.force += force;
        rotor.couple += Complex64::new(0.0, z) * force;
        rotor.roll += Complex64::new(x, -y) * force;
    }

    /// The piston of cylinder `index`, unless nothing of it counts.
    fn add_piston(
        &mut self,
        engine: &Engine,
        request: &LoadRequest,
        selection: Selection,
        index: usize,
    ) -> Result<(), LoadError> {
        let cylinder = &engine.cylinders[index];
        let linkage = linkage(engine, index)?;
        let reciprocating = selection.share(Part::Reciprocating, index);
        let inertia = -selection.share(Part::RodInertia, index) * cylinder.rod.residual_inertia();
        if reciprocating == 0.0 && inertia == 0.0 {
            return Ok(());
        }
        let crankshaft = &engine.crankshafts[engine.throws[cylinder.throw].crankshaft];
        let ratio = crankshaft.ratio;
        let square = (ratio.value() * self.speed).powi(2);
        let [x0, y0, z0] = request.reference;
        let axis = Complex64::new(crankshaft.x - x0, crankshaft.y - y0);
        let lift = Complex64::new(0.0, cylinder.z - z0);
        let along = Complex64::cis(cylinder.angle);
        let lever = (axis.conj() * along).im;
        let pin_mass = reciprocating * cylinder.rod.small_end_mass;
        let piston_mass = reciprocating * cylinder.piston_mass;
        let mass = (pin_mass + piston_mass) * square;
        let roll =
            square * (pin_mass * (lever - cylinder.net_offset()) + piston_mass * (lever - cylinder.offset));
        let master_angle = engine.cylinders[master_of(cylinder).unwrap_or(index)].angle;
        let knuckle = master_of(cylinder).map(|_| {
            let mass = reciprocating * cylinder.rod.big_end_mass * square;
            let force = Complex64::from_polar(mass, master_angle);
            KnuckleMass { force, couple: lift * force, roll: axis.conj() * force, mass }
        });
        self.pistons.push(Piston {
            ratio,
            phase: engine.pin_angle(cylinder.throw, 0.0) - master_angle,
            drive: Drive::of(linkage, request.kinematics, index + 1)?,
            force: mass * along,
            couple: lift * mass * along,
            roll,
            mass,
            inertia: inertia * square,
            knuckle,
            crank_radius: engine.throws[cylinder.throw].radius,
            analytic_margin: linkage.analytic_margin(),
        });
        Ok(())
    }

    /// Refuses masses or speeds so large that no load is a number.
    fn check_finite(&self) -> Result<(), LoadError> {
        let rotors = self.rotors.iter().map(|r| r.force.norm() + r.couple.norm() + r.roll.norm());
        let pistons = self.pistons.iter().map(|p| {
            let knuckle = p.knuckle.as_ref().map_or(0.0, |k| k.couple.norm() + k.roll.norm() + k.mass);
            p.force.norm() + p.couple.norm() + p.roll.abs() + p.mass + p.inertia.abs() + knuckle
        });
        // Products of such numbers with travel and rates must stay finite too.
        match rotors.chain(pistons).find(|size| size.is_nan() || *size > 1e140) {
            Some(got) => Err(LoadError::NotFinite { quantity: "mass times speed squared", got }),
            None => Ok(()),
        }
    }
}

/// Index of the master's cylinder, for an articulated rod.
pub(crate) fn master_of(cylinder: &Cylinder) -> Option<usize> {
    match cylinder.rod.joint {
        RodJoint::Articulated { master, .. } => Some(master),
        RodJoint::Crankpin | RodJoint::Fork | RodJoint::Blade => None,
    }
}

/// The linkage of cylinder `index`.
pub(crate) fn linkage(engine: &Engine, index: usize) -> Result<Linkage, LoadError> {
    let cylinder = &engine.cylinders[index];
    let slider = |cylinder: &Cylinder| Slider {
        radius: engine.throws[cylinder.throw].radius,
        length: cylinder.rod.length,
        offset: cylinder.net_offset(),
    };
    let RodJoint::Articulated { master, knuckle_radius, knuckle_angle } = cylinder.rod.joint else {
        let slider = slider(cylinder);
        slider.check(index + 1)?;
        return Ok(Linkage::Plain(slider));
    };
    let driver = &engine.cylinders[master];
    if master_of(driver).is_some() || driver.throw != cylinder.throw {
        return Err(LoadError::MasterNotPlain { cylinder: index + 1, master: master + 1 });
    }
    let slider = slider(driver);
    slider.check(master + 1)?;
    let articulated = Articulated {
        master: slider,
        knuckle: Complex64::from_polar(knuckle_radius / slider.length, knuckle_angle),
        turn: Complex64::cis(driver.angle - cylinder.angle),
        length: cylinder.rod.length,
        offset: cylinder.net_offset(),
    };
    articulated.check(index + 1)?;
    Ok(Linkage::Articulated(articulated))
}

/// Revolutions of crankshaft 1 after which all shafts stand as before and all working cycles start anew.
///
/// # Errors
/// [`LoadError::PeriodTooLong`] where the ratios have no common period within reach.
pub fn firing_period(engine: &Engine) -> Result<u32, LoadError> {
    let strokes = engine.strokes.revolutions();
    let used = engine.cylinders.iter().map(|c| engine.crankshafts[engine.throws[c.throw].crankshaft].ratio);
    let revolutions = used.into_iter().try_fold(period(engine)?, |all, ratio| {
        // The fewest revolutions R for which R n / d is a whole number of working cycles.
        let own = strokes * ratio.denominator();
        let own = own / greatest_common_divisor(ratio.numerator().unsigned_abs(), own);
        Some(all / greatest_common_divisor(all, own) * own).filter(|all| *all <= MAX_REVOLUTIONS)
    });
    revolutions.ok_or(LoadError::PeriodTooLong { limit: MAX_REVOLUTIONS })
}

/// Revolutions of crankshaft 1 after which all shafts stand as before.
pub(crate) fn period(engine: &Engine) -> Result<u32, LoadError> {
    let crankshafts = engine.crankshafts.iter().map(|c| c.ratio);
    let denominators: Vec<u32> =
        crankshafts.chain(engine.shafts.iter().map(|s| s.ratio)).map(Ratio::denominator).collect();
    (1..=MAX_REVOLUTIONS)
        .find(|revolutions| denominators.iter().all(|d| revolutions % d == 0))
        .ok_or(LoadError::PeriodTooLong { limit: MAX_REVOLUTIONS })
}
