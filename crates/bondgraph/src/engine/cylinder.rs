//! Cylinders: the loop of crank, rod and piston in closed form, their bodies, gas and friction.

use super::Builder;
use super::body::Arm;
use super::changes::motored;
use super::joints::EngineJoints;
use super::request::EngineBlock;
use super::words::{combination, direction, number, quantity};
use lanchester_model::RodJoint;

impl Builder<'_> {
    pub(crate) fn cylinders(&mut self) {
        let engine = self.engine;
        let plain =
            |index: &usize| !matches!(engine.cylinders[*index].rod.joint, RodJoint::Articulated { .. });
        let (masters, others): (Vec<usize>, Vec<usize>) = (0..engine.cylinders.len()).partition(plain);
        for index in masters.into_iter().chain(others) {
            if let EngineJoints::Compliant(joints) = &self.request.joints {
                self.free_bodies(index, joints);
            } else {
                self.loop_of(index);
                self.bodies(index);
                self.slide(index);
            }
            self.stroke(index);
        }
    }

    /// Signals of the loop, from the crankshaft's axis, with their rates by the crank angle.
    ///
    /// ```text
    /// across = e - P.v     along = sqrt(l^2 - across^2)     s = P.u + along     d = along u + across v
    /// s' = d.P'/along      d' = s' u - P'                   sigma' = (d x d')/l^2
    /// ```
    fn loop_of(&mut self, index: usize) {
        let engine = self.engine;
        let cylinder = &engine.cylinders[index];
        let k = index + 1;
        let name = |what: &str| format!("{what}{k}");
        match cylinder.rod.joint {
            RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
                let m = master + 1;
                let share = knuckle_radius / engine.cylinders[master].rod.length;
                let [cos, sin] = direction(knuckle_angle);
                let (re, im) = (share * cos, share * sin);
                for (out, pin, parts) in [
                    ("px", "px", [(re, "dx"), (-im, "dy")]),
                    ("py", "py", [(re, "dy"), (im, "dx")]),
                    ("px_rate", "px_rate", [(re, "dx_rate"), (-im, "dy_rate")]),
                    ("py_rate", "py_rate", [(re, "dy_rate"), (im, "dx_rate")]),
                ] {
                    let parts = parts.map(|(factor, what)| (factor, format!("{what}{m}")));
                    let value = combination(&[
                        (1.0, &format!("{pin}{m}")),
                        (parts[0].0, &parts[0].1),
                        (parts[1].0, &parts[1].1),
                    ]);
                    self.signal(&name(out), &value);
                }
            }
            _ => self.crankpin_of(index),
        }
        let [cos, sin] = direction(cylinder.angle);
        let (px, py) = (name("px"), name("py"));
        let offset = cylinder.net_offset();
        let offset = if offset == 0.0 { "0".into() } else { quantity(offset, "m") };
        let across = combination(&[(1.0, &offset), (sin, &px), (-cos, &py)]);
        self.signal(&name("across"), &across);
        let l = self.own("l", index);
        self.signal(&name("along"), &format!("sqrt({l}^2 - across{k}^2)"));
        let travel = combination(&[(cos, &px), (sin, &py), (1.0, &name("along"))]);
        self.signal(&name("s"), &travel);
        self.signal(&name("dx"), &combination(&[(cos, &name("along")), (-sin, &name("across"))]));
        self.signal(&name("dy"), &combination(&[(sin, &name("along")), (cos, &name("across"))]));
        self.signal(&name("s_rate"), &format!("(dx{k}*px_rate{k} + dy{k}*py_rate{k})/along{k}"));
        let rates = [(cos, "px_rate"), (sin, "py_rate")];
        for ((factor, pin), out) in rates.into_iter().zip(["dx_rate", "dy_rate"]) {
            self.signal(&name(out), &combination(&[(factor, &name("s_rate")), (-1.0, &name(pin))]));
        }
    }

    /// Signals of a crankpin, from the crankshaft's axis, with their rates by the crank angle.
    pub(crate) fn crankpin_of(&mut self, index: usize) {
        let engine = self.engine;
        let k = index + 1;
        let name = |what: &str| format!("{what}{k}");
        let throw = &engine.throws[engine.cylinders[index].throw];
        let shaft = &engine.crankshafts[throw.crankshaft];
        let ratio = shaft.ratio.value();
        let angle = combination(&[(ratio, "theta"), (1.0, &angle_text(shaft.phase + throw.angle))]);
        self.signal(&name("phi"), &angle);
        let r = self.own("r", index);
        self.signal(&name("px"), &format!("{r}*cos(phi{k})"));
        self.signal(&name("py"), &format!("{r}*sin(phi{k})"));
        self.signal(&name("px_rate"), &combination(&[(-ratio, &name("py"))]));
        self.signal(&name("py_rate"), &combination(&[(ratio, &name("px"))]));
    }

    /// Piston and rod as followers.
    fn bodies(&mut self, index: usize) {
        let engine = self.engine;
        let cylinder = &engine.cylinders[index];
        let shaft = &engine.crankshafts[engine.throws[cylinder.throw].crankshaft];
        let numbers = self.numbers.cylinders[index];
        let k = index + 1;
        let [cos, sin] = direction(cylinder.angle);
        let s = format!("s{k}");
        let z = self.seen_from_centre(2, cylinder.z);
        let place = |value: f64| if value == 0.0 { "0".to_owned() } else { quantity(value, "m") };
        if cylinder.piston_mass > 0.0 {
            let fixed = [
                self.seen_from_centre(0, shaft.x - cylinder.offset * sin),
                self.seen_from_centre(1, shaft.y + cylinder.offset * cos),
            ];
            let at = [
                combination(&[(cos, &s), (1.0, &place(fixed[0]))]),
                combination(&[(sin, &s), (1.0, &place(fixed[1]))]),
                place(z),
            ];
            let rate = [cos, sin].map(|part| combination(&[(part, &format!("s_rate{k}"))]));
            let mass = self.own("piston_mass", index);
            self.point(&format!("piston{k}"), &mass, &Arm { at, rate });
        }
        if cylinder.rod.mass() > 0.0 {
            let share = numbers.rod_centre;
            let fixed = [self.seen_from_centre(0, shaft.x), self.seen_from_centre(1, shaft.y)];
            for (axis, own) in [("x", fixed[0]), ("y", fixed[1])] {
                let at = combination(&[
                    (1.0, &format!("p{axis}{k}")),
                    (share, &format!("d{axis}{k}")),
                    (1.0, &place(own)),
                ]);
                self.signal(&format!("rod_{axis}{k}"), &at);
                let rate =
                    combination(&[(1.0, &format!("p{axis}_rate{k}")), (share, &format!("d{axis}_rate{k}"))]);
                self.signal(&format!("rod_{axis}_rate{k}"), &rate);
            }
            let at = [format!("rod_x{k}"), format!("rod_y{k}"), place(z)];
            let rate = [format!("rod_x_rate{k}"), format!("rod_y_rate{k}")];
            let mass = self.own("rod_mass", index);
            self.point(&format!("rod{k}"), &mass, &Arm { at, rate });
        }
        if numbers.rod_inertia > 0.0 {
            self.turn_of_rod(index);
        }
    }

    /// The rod's turn: about z in a plane; in space the velocity of its upper eye relative to the lower, with inertia over length squared.
    fn turn_of_rod(&mut self, index: usize) {
        let k = index + 1;
        let name = format!("rod_turn{k}");
        let (inertia, l) = (self.own("rod_inertia", index), self.own("l", index));
        if self.frame.block.is_spatial() {
            let arm = Arm {
                at: [format!("dx{k}"), format!("dy{k}"), "0".into()],
                rate: [format!("dx_rate{k}"), format!("dy_rate{k}")],
            };
            let rows = self.frame.rows(&arm, false);
            let first = self.follower(&format!("{name}_motion"), &rows);
            for (port, axis) in ["x", "y", "z"].into_iter().enumerate() {
                let store = format!("{name}_{axis}");
                let inertia = format!("{inertia}/{l}^2");
                self.element(&store, "I", &[("inertia", &inertia), ("domain", "translation")]);
                self.bond(&format!("{name}_motion.{}", first + port), &store);
            }
            self.axial_turn(index);
            return;
        }
        let rate = format!("(dx{k}*dy_rate{k} - dy{k}*dx_rate{k})/{l}^2");
        let row = match self.frame.block {
            EngineBlock::Fixed => vec![rate],
            _ => vec!["0".into(), "0".into(), "1".into(), rate],
        };
        let first = self.follower(&format!("{name}_motion"), &[row]);
        self.element(&name, "I", &[("inertia", &inertia), ("domain", "rotation")]);
        self.bond(&format!("{name}_motion.{first}"), &name);
    }

    /// In space: the turn of a rod about its own line. That line turns with the rod, which Euler's gyrator accounts for.
    ///
    /// ```text
    /// moment on the rod = p' d + p (omega x d) = p' d + p (omega_z n - omega_n z)       p = I (omega . d), n = z x d
    /// ```
    fn axial_turn(&mut self, index: usize) {
        let axial = self.engine.cylinders[index].rod.axial_inertia;
        if axial == 0.0 {
            return;
        }
        let k = index + 1;
        let l = self.own("l", index);
        let (along, across) = (format!("dx{k}/{l}"), format!("dy{k}/{l}"));
        let rate = format!("(dx{k}*dy_rate{k} - dy{k}*dx_rate{k})/{l}^2");
        let row = |[x, y, z, crank]: [&str; 4]| ["0", "0", "0", x, y, z, crank].map(str::to_owned).to_vec();
        let rows = [
            row([&along, &across, "0", "0"]),
            row([&format!("-{across}"), &along, "0", "0"]),
            row(["0", "0", "1", &rate]),
        ];
        let [motion, store, normal, about, gyro] =
            ["rod_axis_motion", "rod_axis", "rod_normal", "rod_about", "rod_gyro"]
                .map(|name| format!("{name}{k}"));
        let first = self.follower(&motion, &rows);
        let inertia = quantity(axial, "kg m2");
        self.element(&store, "I", &[("inertia", &inertia), ("domain", "rotation")]);
        self.element(&normal, "1", &[("domain", "rotation")]);
        self.element(&about, "1", &[("domain", "rotation")]);
        self.element(&gyro, "MGY", &[("ratio", &format!("{store}.momentum"))]);
        for (port, to) in [&store, &normal, &about].into_iter().enumerate() {
            self.bond(&format!("{motion}.{}", first + port), to);
        }
        self.bond(&normal, &format!("{gyro}.1"));
        self.bond(&format!("{gyro}.2"), &about);
    }

    /// Whether something acts along the cylinder.
    fn has_stroke(&self) -> bool {
        let request = self.request;
        request.gas_states.is_some() || !request.pressures.is_empty() || request.piston_damping != 0.0
    }

    /// The piston's motion along its cylinder by that of the crank.
    fn slide(&mut self, index: usize) {
        if !self.has_stroke() {
            return;
        }
        let k = index + 1;
        let (slide, stroke) = (format!("slide{k}"), format!("stroke{k}"));
        self.element(&slide, "MTF", &[("ratio", &format!("s_rate{k}"))]);
        self.element(&stroke, "1", &[("domain", "translation")]);
        self.bond("crank", &format!("{slide}.1"));
        self.bond(&format!("{slide}.2"), &stroke);
    }

    /// What acts between piston and block along the cylinder: gas and viscous friction.
    fn stroke(&mut self, index: usize) {
        let k = index + 1;
        let states = self.request.gas_states.clone();
        let gas = self.request.pressures.get(index).filter(|_| states.is_none()).cloned();
        let damping = self.request.piston_damping;
        let stroke = format!("stroke{k}");
        if gas.is_some() || states.is_some() {
            let cylinder = &self.engine.cylinders[index];
            let shaft = &self.engine.crankshafts[self.engine.throws[cylinder.throw].crankshaft];
            let ratio = shaft.ratio.value().abs();
            let firing = self.numbers.cylinders[index].firing.unwrap_or(0.0);
            let phase = -ratio * firing;
            // Below the last digit of an angle of two revolutions a phase is rounding.
            let phase = if phase.abs() < 2.0 * std::f64::consts::TAU * f64::EPSILON { 0.0 } else { phase };
            let angle = combination(&[(ratio, "theta"), (1.0, &angle_text(phase))]);
            self.signal(&format!("psi{k}"), &angle);
        }
        if let Some(states) = states {
            self.gas_states(index, &states);
        }
        if let Some(curve) = gas {
            let table = format!("gauge_pressure{k}");
            let fired = self.fired(index);
            let without = fired.as_ref().and_then(|_| motored(&curve));
            self.graph.tables.push((table.as_str().into(), curve));
            let pressure = match (fired, without) {
                (Some(fired), Some(without)) => {
                    let other = format!("motored_pressure{k}");
                    self.graph.tables.push((other.as_str().into(), without));
                    self.signal(&format!("motored{k}"), &format!("table({other}, psi{k})"));
                    format!("motored{k} + {fired}*(table({table}, psi{k}) - motored{k})")
                }
                _ => format!("table({table}, psi{k})"),
            };
            self.signal(&format!("p{k}"), &pressure);
            let force = format!("-{}*p{k}", self.own("area", index));
            let name = format!("gas{k}");
            self.element(&name, "MSe", &[("effort", &force)]);
            self.bond(&name, &stroke);
        }
        if damping != 0.0 {
            let name = format!("skirt{k}");
            self.element(&name, "R", &[("resistance", &format!("{} N s/m", number(damping)))]);
            self.bond(&stroke, &name);
        }
    }
}

/// An angle as a text; nothing where it is 0.
pub(crate) fn angle_text(angle: f64) -> String {
    if angle == 0.0 { "0".into() } else { quantity(angle, "rad") }
}
