//! The bond graph of an engine: from a validated engine to the description of a graph.
//!
//! Flows of the block are those of its centre of mass in the axes of the ground and its angular velocity in its own axes; the crank has
//! its speed relative to the block. Every other body is a store that follows them through a transformer whose matrix is its Jacobian:
//!
//! ```text
//! body at c (block axes, from the block's centre)     V = v + R (Omega x c) + R c' w
//! rotor                                               spin about z: Omega_z + rho w
//! unbalance U e at the axis' point A                  co-energy U V_A . d(R e)/dt
//! block                                               H' + Omega x H = moment,  H: block and rotors together
//! gas                                                 force -(p - p_0) A on s' w
//! ```
//! | symbol | name                                          | unit |
//! |--------|-----------------------------------------------|------|
//! | v      | velocity of the block's centre, ground axes   | m/s  |
//! | Omega  | angular velocity of the block, block axes     | rad/s |
//! | w      | speed of crankshaft 1 relative to the block   | rad/s |
//! | R      | from block axes to the ground's               | 1    |
//! | rho    | speed of a rotor over that of crankshaft 1    | 1    |
//!
//! Primes of c, e and s are derivatives by the crank angle. Nothing of the kinematics of other crates is used. Source: Karnopp, Margolis,
//! Rosenberg, *System Dynamics*, 5th edition, chapter 9.

mod body;
mod changes;
mod changing;
mod compliant;
mod cylinder;
mod gas;
mod gas_file;
mod gas_walls;
mod joint_start;
mod joints;
mod numbers;
mod request;
mod rest;
mod rotor;
mod torques;
mod words;

pub use joints::{CompliantJoints, EngineJoints};
pub use request::{
    EngineBlock, EngineDrive, EngineGraphError, EngineLink, EngineLoad, EngineRequest, EngineStart,
    EngineStarter, GasStates, GasValve, GasWalls, LoadLaw, WallCoefficient, WallLaw,
};

use crate::description::Description;
use crate::equations::equations;
use crate::graph::Graph;
use body::Frame;
use changing::Changing;
use joint_start::JointStart;
use lanchester_model::Engine;
use numbers::Numbers;
use std::collections::HashMap;
use std::f64::consts::TAU;
use words::{number, quantity};

/// The graph of an engine.
///
/// # Errors
/// [`EngineGraphError`] where the engine lacks what the graph needs.
pub fn engine_graph(engine: &Engine, request: &EngineRequest) -> Result<Description, EngineGraphError> {
    let still = EngineRequest { start: EngineStart::default(), equilibrium: false, ..request.clone() };
    let request = if request.block == EngineBlock::Held { &still } else { request };
    let mut builder = Builder {
        engine,
        request,
        numbers: Numbers::new(engine, request)?,
        frame: Frame::new(request.block),
        start: JointStart::default(),
        changing: Changing::default(),
        graph: Description::new(&engine.name),
    };
    builder.check_mounts()?;
    if request.equilibrium {
        let start = builder.at_rest();
        return engine_graph(engine, &EngineRequest { start, equilibrium: false, ..request.clone() });
    }
    if let EngineJoints::Compliant(joints) = &request.joints {
        builder.check_joints(joints)?;
        let ideal = EngineRequest { joints: EngineJoints::Ideal, ..request.clone() };
        builder.start = builder.joint_start(joints, &efforts_at_start(&engine_graph(engine, &ideal)?));
    }
    builder.parameters();
    builder.block();
    builder.bearings();
    builder.rotors();
    builder.changes();
    builder.surroundings();
    builder.cylinders();
    builder.mounts();
    builder.torques();
    builder.simulation();
    Ok(builder.graph)
}

/// Efforts of the bonds of a graph at its start, by their names; none where it has no equations.
fn efforts_at_start(description: &Description) -> HashMap<String, f64> {
    let found = Graph::new(description).ok().and_then(|graph| equations(&graph).ok());
    found.map(|found| found.efforts_at_start()).unwrap_or_default()
}

/// The graph as far as it is built.
pub(crate) struct Builder<'a> {
    engine: &'a Engine,
    request: &'a EngineRequest,
    numbers: Numbers,
    frame: Frame,
    /// Where free bodies start.
    start: JointStart,
    /// What events set.
    changing: Changing,
    graph: Description,
}

impl Builder<'_> {
    fn parameter(&mut self, name: &str, value: f64, unit: &str) {
        self.graph.parameters.push((name.into(), quantity(value, unit).as_str().into()));
    }

    fn element(&mut self, name: &str, kind: &str, keys: &[(&str, &str)]) {
        let graph = std::mem::take(&mut self.graph);
        self.graph = graph.element(name, kind, keys);
    }

    fn signal(&mut self, name: &str, value: &str) {
        let graph = std::mem::take(&mut self.graph);
        self.graph = graph.signal(name, &[("value", value)]);
    }

    fn integral(&mut self, name: &str, of: &str, start: &str) {
        let graph = std::mem::take(&mut self.graph);
        self.graph = graph.signal(name, &[("integral_of", of), ("start", start)]);
    }

    fn bond(&mut self, from: &str, to: &str) {
        self.graph.bonds.push(format!("{from} > {to}").as_str().into());
    }

    /// Whether the block moves.
    fn moves(&self) -> bool {
        self.request.block != EngineBlock::Fixed
    }

    fn parameters(&mut self) {
        let engine = self.engine;
        for index in 0..engine.cylinders.len() {
            let cylinder = &engine.cylinders[index];
            let radius = engine.throws[cylinder.throw].radius;
            let rod = &cylinder.rod;
            for (what, value, unit) in [
                ("r", radius, "m"),
                ("l", rod.length, "m"),
                ("piston_mass", cylinder.piston_mass, "kg"),
                ("rod_mass", rod.mass(), "kg"),
                ("rod_inertia", self.numbers.cylinders[index].rod_inertia, "kg m2"),
                ("area", self.numbers.cylinders[index].area, "m2"),
            ] {
                let name = self.own(what, index);
                let used = value != 0.0 || what == "r";
                if used && !self.graph.parameters.iter().any(|(known, _)| known.text == name) {
                    self.parameter(&name, value, unit);
                }
            }
        }
        if self.request.gravity != 0.0 {
            self.parameter("g", self.request.gravity, "m/s2");
        }
    }

    /// Name of a parameter of a cylinder: without number where all cylinders share it.
    fn own(&self, what: &str, index: usize) -> String {
        let engine = self.engine;
        let value = |index: usize| {
            let cylinder = &engine.cylinders[index];
            match what {
                "r" => engine.throws[cylinder.throw].radius,
                "l" => cylinder.rod.length,
                "piston_mass" => cylinder.piston_mass,
                "rod_mass" => cylinder.rod.mass(),
                "rod_inertia" => self.numbers.cylinders[index].rod_inertia,
                _ => self.numbers.cylinders[index].area,
            }
        };
        let same = (0..engine.cylinders.len()).all(|other| value(other) == value(0));
        if same { what.to_owned() } else { format!("{what}{}", index + 1) }
    }

    /// The block: its flows, stores, Euler's junction structure, pose and weight.
    fn block(&mut self) {
        let start = self.request.start;
        match self.request.block {
            EngineBlock::Fixed => {}
            EngineBlock::Plane => {
                for (axis, k) in [("x", 0), ("y", 1)] {
                    self.translation(axis, k);
                }
                self.element("wz", "1", &[("domain", "rotation")]);
                let inertia = self.numbers.block_inertia[2][2];
                self.plain_turn("z", inertia, start.spin[2]);
                let angle = 2.0 * start.orientation[3].atan2(start.orientation[0]);
                self.integral("roll", "wz.flow", &quantity(angle, "rad"));
                self.signal("cos_roll", "cos(roll)");
                self.signal("sin_roll", "sin(roll)");
            }
            EngineBlock::Held => self.held(),
            EngineBlock::Space => {
                for (axis, k) in [("x", 0), ("y", 1), ("z", 2)] {
                    self.translation(axis, k);
                }
                for axis in ["wx", "wy", "wz"] {
                    self.element(axis, "1", &[("domain", "rotation")]);
                }
                self.spatial_turn(start.spin);
                self.pose(start.orientation);
            }
        }
        self.element("crank", "1", &[("domain", "rotation")]);
        self.integral("theta", "crank.flow", &quantity(self.request.start_angle, "rad"));
    }

    /// Six flows that are nought, about the origin.
    fn held(&mut self) {
        for (letter, domain, unit) in [("v", "translation", "m/s"), ("w", "rotation", "rad/s")] {
            for axis in ["x", "y", "z"] {
                let (junction, source) = (format!("{letter}{axis}"), format!("hold_{letter}{axis}"));
                self.element(&junction, "1", &[("domain", domain)]);
                self.element(&source, "Sf", &[("flow", &quantity(0.0, unit))]);
                self.bond(&source, &junction);
            }
        }
        for row in 1..=3 {
            for column in 1..=3 {
                self.signal(&format!("r{row}{column}"), if row == column { "1" } else { "0" });
            }
        }
    }

    /// One direction of the block's translation.
    fn translation(&mut self, axis: &str, k: usize) {
        let junction = format!("v{axis}");
        let store = format!("block_{axis}");
        self.element(&junction, "1", &[("domain", "translation")]);
        let mass = quantity(self.numbers.block_mass, "kg");
        let flow = quantity(self.numbers.block_velocity[k], "m/s");
        self.element(&store, "I", &[("inertia", &mass), ("flow", &flow)]);
        self.bond(&junction, &store);
        let weight = self.request.gravity * self.numbers.gravity[k];
        if weight != 0.0 {
            let name = format!("weight_{axis}");
            let force = format!("{}*{mass}*g", number(self.numbers.gravity[k]));
            self.element(&name, "Se", &[("effort", &force)]);
            self.bond(&name, &junction);
        }
        let place = format!("{axis}_block");
        self.integral(&place, &format!("{junction}.flow"), &quantity(self.numbers.block_place[k], "m"));
    }

    fn plain_turn(&mut self, axis: &str, inertia: f64, spin: f64) {
        let store = format!("block_turn_{axis}");
        let keys = [("inertia", quantity(inertia, "kg m2")), ("flow", quantity(spin, "rad/s"))];
        self.element(&store, "I", &[(keys[0].0, &keys[0].1), (keys[1].0, &keys[1].1)]);
        self.bond(&format!("w{axis}"), &store);
    }

    /// Turn of the block in space with Euler's junction structure: gyrators with the angular momentum of block and rotors.
    fn spatial_turn(&mut self, spin: [f64; 3]) {
        let tensor = self.numbers.block_inertia;
        let diagonal = tensor[0][1] == 0.0 && tensor[1][2] == 0.0 && tensor[0][2] == 0.0;
        let momenta = if diagonal {
            for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
                self.plain_turn(axis, tensor[k][k], spin[k]);
            }
            ["x", "y", "z"].map(|axis| format!("block_turn_{axis}.momentum"))
        } else {
            let inverse = numbers::inverse(tensor);
            let mut terms = Vec::new();
            for i in 0..3 {
                for j in i..3 {
                    if inverse[i][j] != 0.0 {
                        let share = if i == j { 2.0 } else { 1.0 } / inverse[i][j];
                        terms.push(format!("p{}*p{}/({})", i + 1, j + 1, quantity(share, "kg m2")));
                    }
                }
            }
            let momentum: Vec<String> =
                (0..3).map(|i| quantity((0..3).map(|j| tensor[i][j] * spin[j]).sum(), "N m s")).collect();
            let keys = [("energy", terms.join(" + ")), ("momentum", momentum.join(" ; "))];
            self.element("block_turn", "I", &[(keys[0].0, &keys[0].1), (keys[1].0, &keys[1].1)]);
            for (port, axis) in ["wx", "wy", "wz"].into_iter().enumerate() {
                self.bond(axis, &format!("block_turn.{}", port + 1));
            }
            [1, 2, 3].map(|port| format!("block_turn.{port}.momentum"))
        };
        let rotors: String = self.turning_names().iter().map(|name| format!(" + {name}.momentum")).collect();
        for (name, value) in [
            ("h_x", momenta[0].clone()),
            ("h_y", momenta[1].clone()),
            ("h_z", format!("{}{rotors}", momenta[2])),
        ] {
            self.signal(name, &value);
        }
        for (name, modulus, from, to) in [
            ("euler_xy", "h_z", "wx", "wy"),
            ("euler_yz", "h_x", "wy", "wz"),
            ("euler_zx", "h_y", "wz", "wx"),
        ] {
            self.element(name, "MGY", &[("ratio", modulus)]);
            self.bond(from, &format!("{name}.1"));
            self.bond(&format!("{name}.2"), to);
        }
    }

    /// The block's turn as a unit quaternion, and the matrix R that follows.
    fn pose(&mut self, start: [f64; 4]) {
        for (name, rate, start) in [
            ("turn_w", "-0.5*(turn_x*wx.flow + turn_y*wy.flow + turn_z*wz.flow)", start[0]),
            ("turn_x", "0.5*(turn_w*wx.flow + turn_y*wz.flow - turn_z*wy.flow)", start[1]),
            ("turn_y", "0.5*(turn_w*wy.flow + turn_z*wx.flow - turn_x*wz.flow)", start[2]),
            ("turn_z", "0.5*(turn_w*wz.flow + turn_x*wy.flow - turn_y*wx.flow)", start[3]),
        ] {
            self.integral(name, rate, &quantity(start, "rad"));
        }
        for (name, value) in [
            ("r11", "1 - 2*(turn_y^2 + turn_z^2)"),
            ("r12", "2*(turn_x*turn_y - turn_w*turn_z)"),
            ("r13", "2*(turn_x*turn_z + turn_w*turn_y)"),
            ("r21", "2*(turn_x*turn_y + turn_w*turn_z)"),
            ("r22", "1 - 2*(turn_x^2 + turn_z^2)"),
            ("r23", "2*(turn_y*turn_z - turn_w*turn_x)"),
            ("r31", "2*(turn_x*turn_z - turn_w*turn_y)"),
            ("r32", "2*(turn_y*turn_z + turn_w*turn_x)"),
            ("r33", "1 - 2*(turn_x^2 + turn_y^2)"),
        ] {
            self.signal(name, value);
        }
    }

    fn simulation(&mut self) {
        if self.request.periodic {
            let turned = TAU * numbers::period(self.engine, &self.request.torque) as f64;
            let period = format!("{} of theta", quantity(turned, "rad"));
            self.graph.simulation.push(("duration".into(), "periodic".into()));
            self.graph.simulation.push(("period".into(), period.as_str().into()));
        } else {
            let duration = quantity(self.request.duration, "s");
            self.graph.simulation.push(("duration".into(), duration.as_str().into()));
        }
        for (key, value) in
            [("samples", self.request.samples.to_string()), ("tolerance", number(self.request.tolerance))]
        {
            self.graph.simulation.push((key.into(), value.as_str().into()));
        }
    }
}
