//! What the file says of a run in time.

use super::text::{File, quantity, quoted};
use lanchester_model::{
    Action, BlockKind, Event, Governor, ImposedAgainst, LoadCurve, LoadLaw, MainSharing, ReactsOn,
    RodGuidance, RunLength, RunLoad, SimulationInput, SpeedKind, StartOfBlock, Starter, When,
};
use lanchester_task::Tasks;
use lanchester_units::{Dimension, exact_text};

fn side(reacts_on: ReactsOn) -> &'static str {
    if reacts_on == ReactsOn::Block { "\"block\"" } else { "\"ground\"" }
}

impl File {
    pub(super) fn simulation(&mut self, tasks: &Tasks) {
        let Some(input) = &tasks.simulation else { return };
        let own = SimulationInput {
            load: None,
            starter: None,
            governor: None,
            driveline: Vec::new(),
            piston_damping: None,
            ..SimulationInput::clone(input)
        };
        let others = input.load.is_some()
            || input.starter.is_some()
            || input.governor.is_some()
            || !input.driveline.is_empty()
            || input.piston_damping.is_some();
        if own != SimulationInput::default() || !others {
            self.simulation_keys(&own);
        }
        if let Some(load) = &input.load {
            self.load(load);
        }
        if let Some(starter) = &input.starter {
            self.starter(starter);
        }
        if let Some(governor) = &input.governor {
            self.governor(governor);
        }
        for link in &input.driveline {
            self.header("[[driveline]]", "");
            self.entry("inertia", &quantity(link.inertia, Dimension::Inertia));
            self.entry("stiffness", &quantity(link.stiffness, Dimension::AngularStiffness));
            self.entry_unless_zero("damping", link.damping, Dimension::AngularDamping);
            self.entry("ratio", &format!("{:?}", link.ratio));
        }
    }

    fn simulation_keys(&mut self, input: &SimulationInput) {
        self.header("[simulation]", "");
        if let Some(speed) = input.speed {
            self.entry("speed", if speed == SpeedKind::Imposed { "\"imposed\"" } else { "\"free\"" });
        }
        if let Some(against) = input.imposed_against {
            let word = if against == ImposedAgainst::Ground { "\"ground\"" } else { "\"block\"" };
            self.entry("imposed_against", word);
        }
        if !input.imposed.is_empty() {
            let point = |[at, speed]: &[f64; 2]| {
                let (at, speed) = (quantity(*at, Dimension::Time), quantity(*speed, Dimension::Speed));
                format!("  {{ at = {at}, speed = {speed} }},\n")
            };
            let list: String = input.imposed.iter().map(point).collect();
            self.entry("imposed", &format!("[\n{list}]"));
        }
        let start_speed = input.start_speed.map(|s| format!("speed = {}", quantity(s, Dimension::Speed)));
        let start_angle = input.start_angle.map(|a| format!("angle = {}", quantity(a, Dimension::Angle)));
        let start_block = input.start_block.map(|block| match block {
            StartOfBlock::Equilibrium => "block = \"equilibrium\"".to_string(),
            StartOfBlock::AsDrawn => "block = \"as drawn\"".to_string(),
        });
        let start: Vec<String> = [start_speed, start_angle, start_block].into_iter().flatten().collect();
        if !start.is_empty() {
            self.entry("start", &format!("{{ {} }}", start.join(", ")));
        }
        match input.duration {
            Some(RunLength::Revolutions(turns)) => {
                self.entry("duration", &format!("\"{turns:?} revolutions\""))
            }
            Some(RunLength::Time(time)) => self.entry("duration", &quantity(time, Dimension::Time)),
            Some(RunLength::Periodic) => self.entry("duration", "\"periodic\""),
            None => {}
        }
        if let Some(block) = input.block {
            self.entry("block", if block == BlockKind::Mounts { "\"mounts\"" } else { "\"fixed\"" });
        }
        match input.gravity {
            Some(0.0) => self.entry("gravity", "\"off\""),
            Some(gravity) => self.entry("gravity", &quantity(gravity, Dimension::Acceleration)),
            None => {}
        }
        if let Some(gas) = input.gas {
            let word = match (gas, input.gas_states) {
                (true, true) => "\"states\"",
                (true, false) => "\"given\"",
                (false, _) => "\"off\"",
            };
            self.entry("gas", word);
        }
        if let Some(step) = input.step {
            self.entry("step", &quantity(step, Dimension::Angle));
        }
        if let Some(tolerance) = input.tolerance {
            self.entry("tolerance", &format!("{tolerance:?}"));
        }
        self.simulation_extras(input);
        if let Some(guidance) = input.guidance {
            let word = if guidance == RodGuidance::Piston { "\"piston\"" } else { "\"crankpin\"" };
            self.entry("guidance", word);
        }
        if let Some(mains) = input.mains {
            let word = match mains {
                MainSharing::Cut => "\"cut\"",
                MainSharing::Springs => "\"springs\"",
                MainSharing::Beam => "\"beam\"",
            };
            self.entry("mains", word);
        }
        if !input.main_stiffness.is_empty() {
            let list: Vec<String> =
                input.main_stiffness.iter().map(|&k| quantity(k, Dimension::Stiffness)).collect();
            self.entry("main_stiffness", &format!("[{}]", list.join(", ")));
        }
        if !(input.torque.is_empty() && input.torque_files.is_empty()) {
            let order = |one: &lanchester_model::TorqueOrder| {
                let [sin, cos] = [one.sin, one.cos].map(|torque| quantity(torque, Dimension::Torque));
                format!("  {{ order = {:?}, sin = {sin}, cos = {cos} }},\n", one.order)
            };
            let named = |one: &lanchester_model::TorqueFile| {
                let period = one.period.map(|p| format!(", period = {}", quantity(p, Dimension::Angle)));
                format!("  {{ file = {}{} }},\n", quoted(&one.file), period.unwrap_or_default())
            };
            let files = input.torque_files.iter().map(named);
            let list: String = input.torque.iter().map(order).chain(files).collect();
            self.entry("torque", &format!("[\n{list}]"));
        }
        for event in &input.events {
            self.event(event);
        }
    }

    /// Tolerances by kind of state, the crankshaft as a body, points of the block, teeth.
    fn simulation_extras(&mut self, input: &SimulationInput) {
        let own = &input.tolerances;
        let given: Vec<String> = [
            ("angle", own.angle, Dimension::Angle),
            ("speed", own.speed, Dimension::Speed),
            ("displacement", own.displacement, Dimension::Length),
            ("turn", own.turn, Dimension::Angle),
            ("velocity", own.velocity, Dimension::Velocity),
            ("spin", own.spin, Dimension::Speed),
            ("energy", own.energy, Dimension::Energy),
        ]
        .into_iter()
        .filter_map(|(key, value, dimension)| Some(format!("{key} = {}", quantity(value?, dimension))))
        .collect();
        if !given.is_empty() {
            self.entry("tolerances", &format!("{{ {} }}", given.join(", ")));
        }
        if let Some(as_body) = input.crank_as_body {
            self.entry("crankshaft", if as_body { "\"body\"" } else { "\"unbalances\"" });
        }
        if !input.points.is_empty() {
            let point = |one: &lanchester_model::NamedPoint| {
                let [x, y, z] = one.at.map(|place| quantity(place, Dimension::Length));
                format!("  {{ name = {}, x = {x}, y = {y}, z = {z} }},\n", quoted(&one.name))
            };
            let list: String = input.points.iter().map(point).collect();
            self.entry("point", &format!("[\n{list}]"));
        }
        if !input.meshes.is_empty() {
            let mesh = |one: &lanchester_model::GearMesh| {
                let angle = quantity(one.pressure_angle, Dimension::Angle);
                let z = quantity(one.z, Dimension::Length);
                format!("  {{ shaft = {}, pressure_angle = {angle}, z = {z} }},\n", quoted(&one.shaft))
            };
            let list: String = input.meshes.iter().map(mesh).collect();
            self.entry("mesh", &format!("[\n{list}]"));
        }
    }

    fn event(&mut self, event: &Event) {
        self.header("[[simulation.event]]", "");
        let when = match event.when {
            When::Time(time) => exact_text(time, Dimension::Time),
            When::Angle(angle) => exact_text(angle, Dimension::Angle),
            When::SpeedRises(speed) => format!("speed rises to {}", exact_text(speed, Dimension::Speed)),
            When::SpeedFalls(speed) => format!("speed falls to {}", exact_text(speed, Dimension::Speed)),
        };
        self.entry("when", &format!("\"{when}\""));
        let action = match &event.action {
            Action::Misfire(cylinder) => format!("misfire {}", cylinder + 1),
            Action::Fuel(share) => format!("fuel {share:?}"),
            Action::Load(LoadLaw::Constant(torque)) => {
                format!("load {}", exact_text(*torque, Dimension::Torque))
            }
            Action::Load(_) => "load none".to_string(),
            Action::ClutchOpen => "clutch open".to_string(),
            Action::Stop => "stop".to_string(),
        };
        self.entry("do", &format!("\"{action}\""));
    }

    fn load(&mut self, load: &RunLoad) {
        self.header("[load]", "");
        let word = match &load.law {
            LoadLaw::None => "none",
            LoadLaw::Constant(_) => "constant",
            LoadLaw::Viscous { .. } => "viscous",
            LoadLaw::Quadratic { .. } => "quadratic",
            LoadLaw::Power { .. } => "power",
            LoadLaw::Table(_) | LoadLaw::Angle { .. } | LoadLaw::Map { .. } => "table",
        };
        self.entry("type", &format!("\"{word}\""));
        match &load.law {
            LoadLaw::None => {}
            LoadLaw::Constant(torque) => self.entry("torque", &quantity(*torque, Dimension::Torque)),
            LoadLaw::Viscous { torque, at } | LoadLaw::Quadratic { torque, at } => {
                self.entry("torque", &quantity(*torque, Dimension::Torque));
                self.entry("at", &quantity(*at, Dimension::Speed));
            }
            LoadLaw::Power { power, least_speed } => {
                self.entry("power", &quantity(*power, Dimension::Power));
                self.entry("least_speed", &quantity(*least_speed, Dimension::Speed));
            }
            LoadLaw::Table(points) => self.load_points(points, "speed", Dimension::Speed),
            LoadLaw::Angle { period, points } => {
                self.entry("period", &quantity(*period, Dimension::Angle));
                self.load_points(points, "angle", Dimension::Angle);
            }
            LoadLaw::Map { period, curves } => {
                self.entry("period", &quantity(*period, Dimension::Angle));
                let point = |curve: &LoadCurve, [angle, torque]: [f64; 2]| {
                    let [speed, angle, torque] = [
                        (curve.speed, Dimension::Speed),
                        (angle, Dimension::Angle),
                        (torque, Dimension::Torque),
                    ]
                    .map(|(value, dimension)| quantity(value, dimension));
                    format!("  {{ speed = {speed}, angle = {angle}, torque = {torque} }},\n")
                };
                let list: String = (curves.iter())
                    .flat_map(|curve| curve.points.iter().map(move |own| point(curve, *own)))
                    .collect();
                self.entry("table", &format!("[\n{list}]"));
            }
        }
        self.entry("reacts_on", side(load.reacts_on));
    }

    fn load_points(&mut self, points: &[[f64; 2]], key: &str, dimension: Dimension) {
        let point = |[at, torque]: &[f64; 2]| {
            let (at, torque) = (quantity(*at, dimension), quantity(*torque, Dimension::Torque));
            format!("  {{ {key} = {at}, torque = {torque} }},\n")
        };
        let list: String = points.iter().map(point).collect();
        self.entry("table", &format!("[\n{list}]"));
    }

    fn starter(&mut self, starter: &Starter) {
        self.header("[starter]", "");
        self.entry("stall_torque", &quantity(starter.stall_torque, Dimension::Torque));
        self.entry("free_speed", &quantity(starter.free_speed, Dimension::Speed));
        self.entry("ratio", &format!("{:?}", starter.ratio));
        self.entry("until", &quantity(starter.until, Dimension::Speed));
        self.entry("reacts_on", side(starter.reacts_on));
    }

    fn governor(&mut self, governor: &Governor) {
        self.header("[governor]", "");
        self.entry("speed", &quantity(governor.speed, Dimension::Speed));
        self.entry("gain", &quantity(governor.gain, Dimension::PerSpeed));
        self.entry_unless_zero("integral", governor.integral, Dimension::Rate);
        self.entry("droop", &format!("{:?}", governor.droop));
        self.entry_unless_zero("delay", governor.delay, Dimension::Time);
        self.entry_unless_zero("lag", governor.lag, Dimension::Time);
        self.entry("start", &format!("{:?}", governor.start));
    }
}
