//! Crankshafts, balance shafts and mounts.

use super::Builder;
use super::body::Arm;
use super::cylinder::angle_text;
use super::joints::EngineJoints;
use super::numbers::{apply, cross, rotation};
use super::request::{EngineBlock, EngineGraphError};
use super::words::{combination, number, quantity};
use num_complex::Complex64;

/// Radius at which an unbalance is written as a mass [m]; only their product counts.
const LEVER: f64 = 0.05;

/// An unbalance of a rotor as a vector [kg m] at `theta = 0` in a plane [m].
type Unbalance = (f64, Complex64);

impl Builder<'_> {
    /// Names of the stores of all rotors that have an inertia, and of the driveline.
    pub(crate) fn rotor_names(&self) -> Vec<String> {
        let crankshafts = self.engine.crankshafts.len();
        (0..self.numbers.rotor_inertia.len())
            .filter(|rotor| self.numbers.rotor_inertia[*rotor] > 0.0)
            .map(|rotor| match rotor {
                0 => "crankshaft".to_owned(),
                _ if rotor < crankshafts => format!("crankshaft{}", rotor + 1),
                _ => format!("shaft{}", rotor + 1 - crankshafts),
            })
            .chain((1..=self.request.driveline.len()).map(|link| format!("driveline{link}")))
            .collect()
    }

    /// The same, and whatever else turns about z by itself: pistons that tilt.
    pub(crate) fn turning_names(&self) -> Vec<String> {
        let pistons = match self.request.joints {
            EngineJoints::Compliant(_) => self.engine.cylinders.len(),
            EngineJoints::Ideal => 0,
        };
        self.rotor_names().into_iter().chain((1..=pistons).map(|k| format!("piston_turn{k}"))).collect()
    }

    pub(crate) fn rotors(&mut self) {
        let engine = self.engine;
        let speed = self.request.speed + if self.moves() { self.request.start.spin[2] } else { 0.0 };
        let has_inertia = self.numbers.rotor_inertia[0] > 0.0;
        if has_inertia {
            let inertia = quantity(self.numbers.rotor_inertia[0], "kg m2");
            let keys = [("inertia", inertia), ("flow", quantity(speed, "rad/s"))];
            self.element("crankshaft", "I", &[(keys[0].0, &keys[0].1), (keys[1].0, &keys[1].1)]);
        }
        if self.moves() && (has_inertia || self.acts_from_ground()) {
            // The speed in space is that of the block's roll and that relative to it.
            self.element("together", "0", &[("domain", "rotation")]);
            self.element("spin", "1", &[("domain", "rotation")]);
            self.bond("wz", "together");
            self.bond("crank", "together");
            self.bond("together", "spin");
        }
        if has_inertia {
            self.bond(if self.moves() { "spin" } else { "crank" }, "crankshaft");
        }
        let crankshafts = engine.crankshafts.len();
        let geared = engine.geared_shafts();
        let ratios: Vec<f64> = (engine.crankshafts.iter().map(|shaft| shaft.ratio.value()))
            .chain(geared.iter().map(|shaft| shaft.ratio.value()))
            .collect();
        for (rotor, ratio) in ratios.iter().enumerate() {
            let name = match rotor {
                0 => "crankshaft".to_owned(),
                _ if rotor < crankshafts => format!("crankshaft{}", rotor + 1),
                _ => format!("shaft{}", rotor + 1 - crankshafts),
            };
            if rotor > 0 && self.numbers.rotor_inertia[rotor] > 0.0 {
                self.geared(&name, *ratio, self.numbers.rotor_inertia[rotor]);
            }
            let (axis, unbalances) = match rotor.checked_sub(crankshafts) {
                None => {
                    let shaft = &engine.crankshafts[rotor];
                    let throws =
                        engine.throws.iter().filter(|throw| throw.crankshaft == rotor).map(|throw| {
                            (
                                throw.unbalance_plane(),
                                Complex64::from_polar(1.0, shaft.phase + throw.angle) * throw.unbalance,
                            )
                        });
                    let weights = engine
                        .counterweights
                        .iter()
                        .filter(|weight| weight.crankshaft == rotor)
                        .map(|weight| {
                            (weight.z, Complex64::from_polar(weight.unbalance, shaft.phase + weight.angle))
                        });
                    ([shaft.x, shaft.y], throws.chain(weights).collect::<Vec<Unbalance>>())
                }
                Some(index) => {
                    let shaft = &geared[index];
                    let weights = shaft.weights.iter();
                    let unbalances = weights
                        .map(|weight| (weight.z, Complex64::from_polar(weight.unbalance, weight.phase)));
                    ([shaft.x, shaft.y], unbalances.collect())
                }
            };
            for (part, unbalance) in two_planes(&unbalances).into_iter().enumerate() {
                let bearing = (rotor < crankshafts).then(|| self.bearing(rotor)).flatten();
                self.unbalance(&format!("{name}_unbalance{}", part + 1), *ratio, axis, unbalance, bearing);
            }
        }
    }

    /// A rotor that turns with the crank by its ratio.
    fn geared(&mut self, name: &str, ratio: f64, inertia: f64) {
        self.element(name, "I", &[("inertia", &quantity(inertia, "kg m2")), ("domain", "rotation")]);
        let drive = format!("{name}_drive");
        let row = match self.frame.block {
            EngineBlock::Fixed => vec![number(ratio)],
            EngineBlock::Plane => vec!["0".into(), "0".into(), "1".into(), number(ratio)],
            EngineBlock::Space | EngineBlock::Held => {
                let mut row = vec!["0".to_owned(); 5];
                row.extend(["1".into(), number(ratio)]);
                row
            }
        };
        let first = self.follower(&drive, &[row]);
        self.bond(&format!("{drive}.{first}"), name);
    }

    /// An unbalance: a field that couples the velocity of its point of the axis with that of its mass about it.
    ///
    /// `bearing`: junctions of the motion of its axis in compliant main bearings.
    fn unbalance(
        &mut self,
        name: &str,
        ratio: f64,
        axis: [f64; 2],
        (z, vector): Unbalance,
        bearing: Option<[String; 2]>,
    ) {
        let weighs = self.request.gravity != 0.0;
        let swings = self.moves() || bearing.is_some();
        if vector == Complex64::ZERO || !(swings || weighs) {
            return;
        }
        let mass = quantity(vector.norm() / LEVER, "kg");
        let lever = quantity(LEVER, "m");
        let angle = combination(&[(ratio, "theta"), (1.0, &angle_text(vector.arg()))]);
        self.signal(&format!("{name}_x"), &format!("{lever}*cos({angle})"));
        self.signal(&format!("{name}_y"), &format!("{lever}*sin({angle})"));
        let own = Arm {
            at: [format!("{name}_x"), format!("{name}_y"), "0".into()],
            rate: [
                combination(&[(-ratio, &format!("{name}_y"))]),
                combination(&[(ratio, &format!("{name}_x"))]),
            ],
        };
        let mut rows = Vec::new();
        if swings {
            let place = |k: usize, value: f64| match self.seen_from_centre(k, value) {
                0.0 => "0".to_owned(),
                value => quantity(value, "m"),
            };
            let point = Arm {
                at: [place(0, axis[0]), place(1, axis[1]), place(2, z)],
                rate: ["0".into(), "0".into()],
            };
            rows = self.frame.rows(&point, true);
        }
        rows.extend(self.frame.rows(&own, false));
        let mut others = Vec::new();
        if let Some(bearing) = &bearing {
            let count = self.frame.axes.len();
            for (index, row) in rows.iter_mut().enumerate() {
                for direction in [["1", "0", "0"], ["0", "1", "0"]] {
                    let of_axis = index < count;
                    row.push(if of_axis { self.frame.turned(index, direction) } else { "0".into() });
                }
            }
            others = bearing.to_vec();
        }
        let motion = format!("{name}_motion");
        let axes = self.frame.axes.clone();
        if !swings {
            // Without a moving axis the weight alone is left of it; one that does not act has no port.
            rows = rows
                .into_iter()
                .zip(&self.numbers.gravity)
                .filter(|(_, part)| **part != 0.0)
                .map(|(row, _)| row)
                .collect();
            if rows.is_empty() {
                return;
            }
        }
        let first = self.follower_of(&motion, &rows, &others);
        if !swings {
            let parts: Vec<usize> = (0..2).filter(|k| self.numbers.gravity[*k] != 0.0).collect();
            for (port, k) in parts.into_iter().enumerate() {
                self.out(&format!("{motion}.{}", first + port), "", name, axes[k], k, &mass);
            }
            return;
        }
        let count = axes.len();
        let terms: Vec<String> = (1..=count).map(|port| format!("f{port}*f{}", port + count)).collect();
        let coenergy = format!("{mass}*({})", terms.join(" + "));
        self.element(name, "I", &[("coenergy", &coenergy), ("domain", "translation")]);
        for (k, axis) in axes.into_iter().enumerate() {
            self.bond(&format!("{motion}.{}", first + k), &format!("{name}.{}", k + 1));
            let port = format!("{name}.{}", k + 1 + count);
            self.out(&format!("{motion}.{}", first + count + k), &port, name, axis, k, &mass);
        }
    }

    /// Springs and dampers of the mounts, along directions that stand still.
    pub(crate) fn mounts(&mut self) {
        if !self.has_mounts() {
            return;
        }
        let engine = self.engine;
        let turn = rotation(self.request.start.orientation);
        for (index, mount) in engine.mounts.iter().enumerate() {
            let Some(spring) = &mount.spring else { continue };
            let at = [mount.x, mount.y, mount.z];
            let turned = apply(turn, at);
            let moved = [0, 1, 2].map(|k| self.request.start.position[k] + turned[k] - at[k]);
            let arm = [0, 1, 2].map(|k| self.seen_from_centre(k, at[k]));
            for (way, axis) in spring.axes.iter().enumerate() {
                let (stiffness, damping) = (spring.stiffness[way], spring.damping[way]);
                let preload = if way == 0 { spring.preload } else { 0.0 };
                let in_plane = self.request.block == EngineBlock::Space || axis[0] != 0.0 || axis[1] != 0.0;
                if !in_plane || (stiffness == 0.0 && damping == 0.0 && preload == 0.0) {
                    continue;
                }
                let name = format!("mount{}_{}", index + 1, way + 1);
                let row = self.mount_row(*axis, arm);
                let junction = format!("{name}_rate");
                let motion = format!("{name}_motion");
                self.element(&motion, "MTF", &[("matrix", &row.join("; "))]);
                let block = self.frame.junctions[..self.frame.junctions.len() - 1].to_vec();
                for (port, from) in block.iter().enumerate() {
                    self.bond(from, &format!("{motion}.{}", port + 1));
                }
                self.element(&junction, "1", &[("domain", "translation")]);
                self.bond(&format!("{motion}.{}", block.len() + 1), &junction);
                if stiffness != 0.0 {
                    let start = axis[0] * moved[0] + axis[1] * moved[1] + axis[2] * moved[2];
                    let store = format!("{name}_spring");
                    let keys =
                        [("stiffness", quantity(stiffness, "N/m")), ("displacement", quantity(start, "m"))];
                    self.element(&store, "C", &[(keys[0].0, &keys[0].1), (keys[1].0, &keys[1].1)]);
                    self.bond(&junction, &store);
                }
                if damping != 0.0 {
                    let damper = format!("{name}_damper");
                    self.element(&damper, "R", &[("resistance", &quantity(damping, "N s/m"))]);
                    self.bond(&junction, &damper);
                }
                if preload != 0.0 {
                    let source = format!("{name}_preload");
                    self.element(&source, "Se", &[("effort", &quantity(preload, "N"))]);
                    self.bond(&source, &junction);
                }
            }
        }
    }

    /// Velocity of a mount's point along one of its directions by the flows of the block.
    fn mount_row(&self, axis: [f64; 3], arm: [f64; 3]) -> Vec<String> {
        let plain = |value: f64| if value == 0.0 { "0".to_owned() } else { number(value) };
        if self.request.block == EngineBlock::Plane {
            // a . R (z x m) with R about z alone.
            let lever = |factor: f64, name: &str| {
                let size = quantity(factor.abs(), "m");
                if factor == 0.0 {
                    (0.0, "0".to_owned())
                } else {
                    (factor.signum(), format!("{size}*{name}"))
                }
            };
            let cos = lever(axis[1] * arm[0] - axis[0] * arm[1], "cos_roll");
            let sin = lever(-(axis[0] * arm[0] + axis[1] * arm[1]), "sin_roll");
            let turning = combination(&[(cos.0, &cos.1), (sin.0, &sin.1)]);
            return vec![plain(axis[0]), plain(axis[1]), turning];
        }
        let mut row: Vec<String> = axis.iter().map(|part| plain(*part)).collect();
        for k in 0..3 {
            let mut unit = [0.0; 3];
            unit[k] = 1.0;
            let moved = cross(unit, arm);
            let mut text = String::new();
            for i in 0..3 {
                for j in 0..3 {
                    let factor = axis[i] * moved[j];
                    if factor != 0.0 {
                        let sign = if factor < 0.0 { " - " } else { " + " };
                        let sign = if text.is_empty() { sign.trim() } else { sign };
                        text += &format!("{sign}{}*r{}{}", quantity(factor.abs(), "m"), i + 1, j + 1);
                    }
                }
            }
            row.push(if text.is_empty() { "0".into() } else { text });
        }
        row
    }

    /// Whether mounts act: not on a block that stands still anyhow.
    pub(crate) fn has_mounts(&self) -> bool {
        self.moves() && self.request.block != EngineBlock::Held && self.request.mounts
    }

    /// Refuses mounts that have no exact form in time.
    pub(crate) fn check_mounts(&self) -> Result<(), EngineGraphError> {
        if !self.has_mounts() {
            return Ok(());
        }
        let bad = self.engine.mounts.iter().find(|mount| {
            mount.spring.as_ref().is_none_or(|spring| {
                !spring.table.is_empty() || spring.loss_factor.iter().any(|loss| *loss != 0.0)
            })
        });
        bad.map_or(Ok(()), |mount| Err(EngineGraphError::Mount { mount: mount.name.clone() }))
    }
}

/// Unbalances on one axis as the two in the outermost planes that exert the same force and couple.
fn two_planes(unbalances: &[Unbalance]) -> Vec<Unbalance> {
    let planes = unbalances.iter().map(|(z, _)| *z);
    let (low, high) = planes.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)));
    let sum: Complex64 = unbalances.iter().map(|(_, vector)| vector).sum();
    let moment: Complex64 = unbalances.iter().map(|(z, vector)| z * vector).sum();
    if unbalances.is_empty() {
        return Vec::new();
    }
    if low == high {
        return vec![(low, sum)];
    }
    let upper = (moment - low * sum) / (high - low);
    let size: f64 = unbalances.iter().map(|(_, vector)| vector.norm()).sum();
    [(low, sum - upper), (high, upper)]
        .into_iter()
        .filter(|(_, vector)| vector.norm() > 1e-15 * size)
        .collect()
}
