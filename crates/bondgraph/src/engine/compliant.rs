//! Compliant joints: crankshaft, rods and pistons move freely in their planes, springs and dampers hold them together.
//!
//! Every body has flows of its own relative to the block and, on their junctions, its inertia as a state. In a block that moves, what
//! else it carries is a field that follows:
//!
//! ```text
//! 1/2 m |V + R c'|^2 = 1/2 m |c'|^2 + m (1/2 |V|^2 + V . R c')         V = v + R (Omega x c)
//! lower joint     d/dt (G - share d - K)                  K: crankpin, or knuckle pin on the master rod
//! piston pin      d/dt (G + (1 - share) d - Q)            Q: pin on the piston
//! skirt           d/dt (across + b sin(tilt))             b = middle of its contacts from the pin, +-1/2 of their distance
//! ```
//! | symbol | name                                                   | unit |
//! |--------|--------------------------------------------------------|------|
//! | c      | centre of the body from the block's centre, its axes   | m    |
//! | G, d   | centre of the rod, vector from its lower to its upper eye | m |
//!
//! The pistons' own inertia about z counts in their tilt alone; the block's numbers hold it as long as they do not tilt. The contacts press
//! across the cylinder at any tilt, so that force equals reaction. Source: Singh, ME thesis 2017, eqs. 3.23 to 3.31.

use super::Builder;
use super::body::Arm;
use super::joints::{CompliantJoints, EngineJoints};
use super::numbers::travel;
use super::request::EngineBlock;
use super::words::{combination, direction, number, quantity};
use lanchester_model::RodJoint;

/// A direction of a body's own motion: its junction and the unit vector in block axes.
type Own = (String, [String; 2]);

impl Builder<'_> {
    /// Junctions of the motion of a crankshaft's axis, where its main bearings are compliant.
    pub(crate) fn bearing(&self, shaft: usize) -> Option<[String; 2]> {
        let EngineJoints::Compliant(joints) = &self.request.joints else { return None };
        joints.crankshafts.get(shaft).copied().flatten()?;
        Some(["x", "y"].map(|axis| format!("bearing{}_v{axis}", shaft + 1)))
    }

    /// Travel of the piston's centre at the start [m].
    pub(crate) fn start_travel(&self, index: usize) -> f64 {
        match self.start.cylinders.get(index) {
            Some(start) => start.travel[0],
            None => travel(self.engine, index, self.request.start_angle),
        }
    }

    /// Crankshafts in compliant main bearings.
    pub(crate) fn bearings(&mut self) {
        let EngineJoints::Compliant(joints) = &self.request.joints else { return };
        for (index, shaft) in self.engine.crankshafts.iter().enumerate() {
            let (Some(junctions), Some(Some([mass, z]))) =
                (self.bearing(index), joints.crankshafts.get(index).copied())
            else {
                continue;
            };
            let name = format!("bearing{}", index + 1);
            let damping = joints.damping(joints.stiffness, mass);
            let mass = quantity(mass, "kg");
            let start = self.start.crankshafts[index];
            let mut own: Vec<Own> = Vec::new();
            for (k, axis) in ["x", "y"].into_iter().enumerate() {
                self.mass(&junctions[k], &format!("{name}_mass_{axis}"), &mass, 0.0);
                let unit = [0, 1].map(|i| if i == k { "1".to_owned() } else { "0".to_owned() });
                own.push((junctions[k].clone(), unit));
                let (spring, damper) = (format!("{name}_{axis}_spring"), format!("{name}_{axis}_damper"));
                self.spring(&junctions[k], [&spring, &damper], joints.stiffness, damping, start[k]);
            }
            // In a block that moves its weight and inertia are those of the block, but for its own motion.
            let at = [0, 1, 2].map(|k| self.seen_from_centre(k, [shaft.x, shaft.y, z][k]));
            self.carried(&name, &mass, at.map(place), &own, false);
        }
    }

    /// A junction with an inertia of its own.
    fn mass(&mut self, junction: &str, store: &str, mass: &str, flow: f64) {
        self.element(junction, "1", &[("domain", "translation")]);
        let flow = quantity(flow, "m/s");
        self.element(store, "I", &[("inertia", mass), ("flow", &flow)]);
        self.bond(junction, store);
    }

    /// A spring with its damper on a junction.
    fn spring(&mut self, junction: &str, names: [&str; 2], stiffness: f64, damping: f64, start: f64) {
        let keys = [("stiffness", quantity(stiffness, "N/m")), ("displacement", quantity(start, "m"))];
        self.element(names[0], "C", &[(keys[0].0, &keys[0].1), (keys[1].0, &keys[1].1)]);
        self.bond(junction, names[0]);
        if damping > 0.0 {
            self.element(names[1], "R", &[("resistance", &quantity(damping, "N s/m"))]);
            self.bond(junction, names[1]);
        }
    }

    /// A joint between two bodies: a port of a transformer, its spring and damper.
    fn joint(&mut self, port: &str, name: &str, stiffness: f64, damping: f64, start: f64) {
        self.element(name, "1", &[("domain", "translation")]);
        self.bond(port, name);
        let names = [format!("{name}_spring"), format!("{name}_damper")];
        self.spring(name, [&names[0], &names[1]], stiffness, damping, start);
    }

    /// A transformer from some junctions; gives the number of its first port out.
    fn motion(&mut self, name: &str, junctions: &[String], rows: &[Vec<String>]) -> usize {
        self.element(name, "MTF", &[("matrix", &super::words::matrix(rows))]);
        for (port, junction) in junctions.iter().enumerate() {
            self.bond(junction, &format!("{name}.{}", port + 1));
        }
        junctions.len() + 1
    }

    /// Rod and piston of a cylinder with their joints.
    pub(crate) fn free_bodies(&mut self, index: usize, joints: &CompliantJoints) {
        let k = index + 1;
        let l = self.own("l", index);
        let start = self.start.cylinders[index];
        let is_crankpin = !matches!(self.engine.cylinders[index].rod.joint, RodJoint::Articulated { .. });
        if is_crankpin {
            self.crankpin_of(index);
        }
        self.integral(
            &format!("rod_angle{k}"),
            &format!("rod{k}_spin.flow"),
            &quantity(start.turn[0], "rad"),
        );
        self.signal(&format!("dx{k}"), &format!("{l}*cos(rod_angle{k})"));
        self.signal(&format!("dy{k}"), &format!("{l}*sin(rod_angle{k})"));
        self.integral(&format!("tilt_angle{k}"), &format!("tilt{k}.flow"), &quantity(start.tilt, "rad"));
        for (name, of, place) in [
            ("rod_x", format!("rod{k}_vx.flow"), start.rod[0][0]),
            ("rod_y", format!("rod{k}_vy.flow"), start.rod[0][1]),
            ("s", format!("stroke{k}.flow"), start.travel[0]),
            ("side", format!("lateral{k}.flow"), start.across),
        ] {
            self.integral(&format!("{name}{k}"), &of, &quantity(place, "m"));
        }
        self.free_rod(index);
        self.free_piston(index, joints);
        self.lower_joint(index, joints);
        self.piston_pin(index, joints);
        self.skirt(index, joints);
    }

    fn free_rod(&mut self, index: usize) {
        let engine = self.engine;
        let k = index + 1;
        let cylinder = &engine.cylinders[index];
        let start = self.start.cylinders[index];
        let mass = self.own("rod_mass", index);
        let [vx, vy, spin] = rod_junctions(k);
        self.mass(&vx, &format!("rod{k}_x"), &mass, start.rod[1][0]);
        self.mass(&vy, &format!("rod{k}_y"), &mass, start.rod[1][1]);
        let inertia = self.own("rod_inertia", index);
        self.turning(&spin, &format!("rod_turn{k}"), &inertia, start.turn[1]);
        let shaft = &engine.crankshafts[engine.throws[cylinder.throw].crankshaft];
        let fixed = [self.seen_from_centre(0, shaft.x), self.seen_from_centre(1, shaft.y)];
        let at = [
            combination(&[(1.0, &format!("rod_x{k}")), (1.0, &place(fixed[0]))]),
            combination(&[(1.0, &format!("rod_y{k}")), (1.0, &place(fixed[1]))]),
            place(self.seen_from_centre(2, cylinder.z)),
        ];
        let own = [(vx, ["1".into(), "0".into()]), (vy, ["0".into(), "1".into()])];
        self.carried(&format!("rod{k}"), &mass, at, &own, true);
        match self.frame.block {
            EngineBlock::Fixed => {}
            EngineBlock::Plane => {
                let coenergy = format!("{inertia}*(f1^2/2 + f1*f2)");
                self.turning_field(&format!("rod_turn{k}_carried"), &coenergy, &spin);
            }
            EngineBlock::Space | EngineBlock::Held => {
                let l = self.own("l", index);
                let arm = Arm {
                    at: [format!("dx{k}"), format!("dy{k}"), "0".into()],
                    rate: ["0".into(), "0".into()],
                };
                let along = [combination(&[(-1.0, &format!("dy{k}"))]), format!("dx{k}")];
                let share = format!("{inertia}/{l}^2");
                self.field(&format!("rod_turn{k}"), &share, &arm, &[(spin, along)], false);
            }
        }
    }

    fn free_piston(&mut self, index: usize, joints: &CompliantJoints) {
        let engine = self.engine;
        let k = index + 1;
        let cylinder = &engine.cylinders[index];
        let start = self.start.cylinders[index];
        let mass = self.own("piston_mass", index);
        let [along, across, tilt] = piston_junctions(k);
        self.mass(&along, &format!("piston{k}_along"), &mass, start.travel[1]);
        self.mass(&across, &format!("piston{k}_across"), &mass, 0.0);
        let inertia = quantity(joints.tilt_inertia(engine, index), "kg m2");
        self.turning(&tilt, &format!("piston_turn{k}"), &inertia, 0.0);
        let [cos, sin] = direction(cylinder.angle);
        let shaft = &engine.crankshafts[engine.throws[cylinder.throw].crankshaft];
        let (s, side) = (format!("s{k}"), format!("side{k}"));
        let at = [
            combination(&[(cos, &s), (-sin, &side), (1.0, &place(self.seen_from_centre(0, shaft.x)))]),
            combination(&[(sin, &s), (cos, &side), (1.0, &place(self.seen_from_centre(1, shaft.y)))]),
            place(self.seen_from_centre(2, cylinder.z)),
        ];
        let own = [(along, [plain(cos), plain(sin)]), (across, [plain(-sin), plain(cos)])];
        self.carried(&format!("piston{k}"), &mass, at, &own, true);
        if self.moves() {
            self.turning_field(&format!("piston_turn{k}_carried"), &format!("{inertia}*f1*f2"), &tilt);
        }
    }

    fn turning(&mut self, junction: &str, store: &str, inertia: &str, flow: f64) {
        self.element(junction, "1", &[("domain", "rotation")]);
        let flow = quantity(flow, "rad/s");
        self.element(store, "I", &[("inertia", inertia), ("flow", &flow)]);
        self.bond(junction, store);
    }

    /// What turns with the block's roll beside its own turn.
    fn turning_field(&mut self, name: &str, coenergy: &str, spin: &str) {
        self.element(name, "I", &[("coenergy", coenergy), ("domain", "rotation")]);
        self.bond("wz", &format!("{name}.1"));
        self.bond(spin, &format!("{name}.2"));
    }

    /// Weight of a body, and in a block that moves the field of what it carries beside its own motion.
    ///
    /// `whole`: whether its inertia is no part of the block's numbers.
    fn carried(&mut self, name: &str, mass: &str, at: [String; 3], own: &[Own], whole: bool) {
        if self.moves() {
            let arm = Arm { at, rate: ["0".into(), "0".into()] };
            self.field(name, mass, &arm, own, whole);
            return;
        }
        let [x, y, _] = self.numbers.gravity;
        for (way, (junction, unit)) in own.iter().enumerate() {
            let unit = [0, 1].map(|k| unit[k].parse::<f64>().unwrap_or(0.0));
            let part = if self.request.gravity == 0.0 { 0.0 } else { unit[0] * x + unit[1] * y };
            if part != 0.0 {
                let weight = format!("{name}_weight_{}", way + 1);
                self.element(&weight, "Se", &[("effort", &combination(&[(part, &format!("{mass}*g"))]))]);
                self.bond(&weight, junction);
            }
        }
    }

    /// The field `m (1/2 |V|^2 + V . R c')`, or its second part, with weights on both velocities.
    fn field(&mut self, name: &str, mass: &str, arm: &Arm, own: &[Own], whole: bool) {
        let is_turn = name.starts_with("rod_turn");
        let mut rows = self.frame.rows(arm, !is_turn);
        let count = rows.len();
        let block = self.frame.junctions.len() - 1;
        for row in &mut rows {
            row.truncate(block);
            row.extend(own.iter().map(|_| "0".to_owned()));
        }
        for axis in 0..count {
            let mut row = vec!["0".to_owned(); block];
            row.extend(own.iter().map(|(_, [x, y])| self.frame.turned(axis, [x.as_str(), y.as_str(), "0"])));
            rows.push(row);
        }
        let mut junctions: Vec<String> =
            self.frame.junctions[..block].iter().map(|junction| (*junction).to_owned()).collect();
        junctions.extend(own.iter().map(|(junction, _)| junction.clone()));
        let first = self.motion(&format!("{name}_carried_motion"), &junctions, &rows);
        let mut terms: Vec<String> = (1..=count).map(|port| format!("f{port}*f{}", port + count)).collect();
        if whole || is_turn {
            terms.extend((1..=count).map(|port| format!("f{port}^2/2")));
        }
        let carried = format!("{name}_carried");
        let coenergy = format!("{mass}*({})", terms.join(" + "));
        self.element(&carried, "I", &[("coenergy", &coenergy), ("domain", "translation")]);
        let axes = self.frame.axes.clone();
        for (k, axis) in axes.into_iter().enumerate() {
            for (part, word) in ["carried", "own"].into_iter().enumerate() {
                let port = format!("{name}_carried_motion.{}", first + part * count + k);
                let store = format!("{carried}.{}", 1 + part * count + k);
                // The block's numbers hold the weight of what is a part of it.
                if is_turn || (part == 0 && !whole) {
                    self.bond(&port, &store);
                } else {
                    self.out(&port, &store, &format!("{name}_{word}"), axis, k, mass);
                }
            }
        }
    }

    /// Crankpin or knuckle pin.
    fn lower_joint(&mut self, index: usize, joints: &CompliantJoints) {
        let engine = self.engine;
        let k = index + 1;
        let cylinder = &engine.cylinders[index];
        let share = self.numbers.cylinders[index].rod_centre;
        let mut junctions = rod_junctions(k).to_vec();
        let mut rows = [vec!["1".to_owned(), "0".to_owned()], vec!["0".to_owned(), "1".to_owned()]];
        rows[0].push(combination(&[(share, &format!("dy{k}"))]));
        rows[1].push(combination(&[(-share, &format!("dx{k}"))]));
        if let RodJoint::Articulated { master, knuckle_radius, knuckle_angle } = cylinder.rod.joint {
            let m = master + 1;
            let ratio = knuckle_radius / engine.cylinders[master].rod.length;
            let [cos, sin] = direction(knuckle_angle);
            let (re, im) = (ratio * cos - self.numbers.cylinders[master].rod_centre, ratio * sin);
            // The knuckle pin from the master's centre: (re + i im) d.
            let (dx, dy) = (format!("dx{m}"), format!("dy{m}"));
            junctions.extend(rod_junctions(m));
            rows[0].extend(["-1".into(), "0".into(), combination(&[(re, &dy), (im, &dx)])]);
            rows[1].extend(["0".into(), "-1".into(), combination(&[(-re, &dx), (im, &dy)])]);
        } else {
            junctions.push("crank".into());
            for (row, axis) in rows.iter_mut().zip(["x", "y"]) {
                row.push(combination(&[(-1.0, &format!("p{axis}_rate{k}"))]));
            }
            if let Some(bearing) = self.bearing(engine.throws[cylinder.throw].crankshaft) {
                junctions.extend(bearing);
                rows[0].extend(["-1".into(), "0".into()]);
                rows[1].extend(["0".into(), "-1".into()]);
            }
        }
        let name = format!("crankpin{k}");
        let first = self.motion(&format!("{name}_motion"), &junctions, &rows);
        let damping = joints.damping(joints.stiffness, cylinder.rod.mass());
        let start = self.start.cylinders[index].lower;
        for (way, axis) in ["x", "y"].into_iter().enumerate() {
            let port = format!("{name}_motion.{}", first + way);
            self.joint(&port, &format!("{name}_{axis}"), joints.stiffness, damping, start[way]);
        }
    }

    /// Piston pin, along and across the cylinder.
    fn piston_pin(&mut self, index: usize, joints: &CompliantJoints) {
        let k = index + 1;
        let cylinder = &self.engine.cylinders[index];
        let rest = 1.0 - self.numbers.cylinders[index].rod_centre;
        let [cos, sin] = direction(cylinder.angle);
        let offset = cylinder.net_offset() - cylinder.offset;
        let (dx, dy) = (format!("dx{k}"), format!("dy{k}"));
        let lever = |wave: &str| match offset {
            0.0 => "0".to_owned(),
            offset => format!("{}*{wave}(tilt_angle{k})", quantity(offset, "m")),
        };
        // Rates of the upper eye along u and v, less those of the pin on the piston.
        let rows = [
            vec![
                plain(cos),
                plain(sin),
                combination(&[(-rest * cos, &dy), (rest * sin, &dx)]),
                "-1".into(),
                "0".into(),
                lever("cos"),
            ],
            vec![
                plain(-sin),
                plain(cos),
                combination(&[(rest * sin, &dy), (rest * cos, &dx)]),
                "0".into(),
                "-1".into(),
                lever("sin"),
            ],
        ];
        let junctions: Vec<String> = rod_junctions(k).into_iter().chain(piston_junctions(k)).collect();
        let name = format!("pin{k}");
        let first = self.motion(&format!("{name}_motion"), &junctions, &rows);
        let (piston, rod) = (cylinder.piston_mass, cylinder.rod.mass());
        let damping = joints.damping(joints.stiffness, piston * rod / (piston + rod));
        let start = self.start.cylinders[index].pin;
        for (way, axis) in ["along", "across"].into_iter().enumerate() {
            let port = format!("{name}_motion.{}", first + way);
            self.joint(&port, &format!("{name}_{axis}"), joints.stiffness, damping, start[way]);
        }
    }

    /// Both contacts of the skirt, above and below the piston's centre.
    fn skirt(&mut self, index: usize, joints: &CompliantJoints) {
        let k = index + 1;
        let half = 0.5 * joints.contact_distance(self.engine, index);
        let lever = |place: f64| {
            let size = format!("{}*cos(tilt_angle{k})", quantity(place.abs(), "m"));
            if place == 0.0 { "0".to_owned() } else { combination(&[(place.signum(), &size)]) }
        };
        let rows = [1.0, -1.0].map(|side| vec!["1".to_owned(), lever(joints.skirt_offset + side * half)]);
        let [_, across, tilt] = piston_junctions(k);
        let name = format!("contact{k}");
        let first = self.motion(&format!("{name}_motion"), &[across, tilt], &rows);
        let damping = joints.damping(joints.skirt_stiffness, 0.5 * self.engine.cylinders[index].piston_mass);
        let start = self.start.cylinders[index].contacts;
        for (way, start) in start.into_iter().enumerate() {
            let port = format!("{name}_motion.{}", first + way);
            self.joint(&port, &format!("{name}_{}", way + 1), joints.skirt_stiffness, damping, start);
        }
    }
}

fn rod_junctions(k: usize) -> [String; 3] {
    ["vx", "vy", "spin"].map(|what| format!("rod{k}_{what}"))
}

fn piston_junctions(k: usize) -> [String; 3] {
    ["stroke", "lateral", "tilt"].map(|what| format!("{what}{k}"))
}

/// A length as a text; a plain nought where there is none.
fn place(value: f64) -> String {
    if value == 0.0 { "0".into() } else { quantity(value, "m") }
}

/// A number as a text; a plain nought or one where it is that.
fn plain(value: f64) -> String {
    match value {
        0.0 => "0".into(),
        1.0 => "1".into(),
        value => number(value),
    }
}
