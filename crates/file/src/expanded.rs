//! The general form of an engine as an engine file.

mod balance;
mod bearings;
mod crank_details;
mod gas;
mod mount;
mod part;
mod running;
mod shaft_part;
mod simulation;
mod stress;
mod text;
mod torsion;

pub(crate) use part::shape_entries;
pub(crate) use shaft_part::shaft_shape;
pub(crate) use text::{quantity, quoted, ratio};

use crate::engine_file::EngineFile;
use crate::firing::turn;
use crate::read::fired_after;
use lanchester_model::{Cylinder, Engine, Rod, RodJoint, RodMassRule, Rotation, Strokes, Throw};
use lanchester_units::{Dimension, neighbours, text_that};
use std::fmt::Write;
use text::File;

/// The general form of the engine as an engine file: every throw, cylinder, weight and firing angle written out.
///
/// [`read`](crate::read) makes the same engine of it, to the last bit.
pub fn expanded(file: &EngineFile) -> String {
    let EngineFile { engine, tasks } = file;
    let mut text = File::default();
    text.comment("The general form of this engine, written by Lanchester.");
    text.entry("name", &quoted(&engine.name));
    if let Some(note) = &engine.note {
        text.entry("note", &quoted(note));
    }
    text.entry("strokes", if engine.strokes == Strokes::Two { "2" } else { "4" });
    text.entry(
        "rotation",
        if engine.rotation == Rotation::Reverse { "\"reverse\"" } else { "\"clockwise\"" },
    );
    let [lowest, highest] =
        [engine.speed.lowest, engine.speed.highest].map(|speed| quantity(speed, Dimension::Speed));
    if engine.speed.lowest == engine.speed.highest {
        text.entry("speed", &highest);
    } else {
        text.entry("speed", &format!("[{lowest}, {highest}]"));
    }
    text.entry_with_comment("origin", "\"0 mm\"", "every z counts from the reference plane");
    text.firing(engine);
    text.crankshafts(engine);
    text.crank_body(engine);
    text.crank_material(engine);
    text.crank_mesh(tasks);
    let weighed = weighed(engine);
    for (index, throw) in engine.throws.iter().enumerate() {
        text.throw(index, throw, weighed[index]);
    }
    for (index, cylinder) in engine.cylinders.iter().enumerate() {
        text.cylinder(index, cylinder, engine);
    }
    text.weights(engine);
    text.mounts(engine);
    text.shape_task(tasks);
    text.shaft_weight_task(tasks);
    text.clearance(engine);
    text.gas(engine);
    text.friction(engine, tasks);
    text.flywheel(engine);
    text.bearings(engine);
    text.simulation(tasks);
    text.torsion(engine);
    text.stress_cases(tasks);
    text.tolerances(tasks);
    text.balance(tasks, engine);
    text.text
}

impl File {
    fn firing(&mut self, engine: &Engine) {
        let angles: Option<Vec<f64>> =
            engine.cylinders.iter().map(|cylinder| cylinder.firing_angle).collect();
        let Some(angles) = angles else { return };
        let Some(&start) = angles.first() else { return };
        let list: Vec<String> = angles
            .iter()
            .enumerate()
            .map(|(index, &fired)| {
                let cycle = engine.working_cycle(index);
                let after = if fired == start { 0.0 } else { turn(fired - start, cycle) };
                format!(
                    "\"{}\"",
                    text_that(after, Dimension::Angle, |after| fired_after(start, after, cycle) == fired)
                )
            })
            .collect();
        self.header("[firing]", "after cylinder 1");
        self.entry("angles", &format!("[{}]", list.join(", ")));
    }

    fn crankshafts(&mut self, engine: &Engine) {
        for (index, crankshaft) in engine.crankshafts.iter().enumerate() {
            self.header("[[crankshaft]]", &format!("{}", index + 1));
            self.entry("name", &quoted(&crankshaft.name));
            if index > 0 {
                self.entry("ratio", &ratio(crankshaft.ratio));
            }
            self.entry_unless_zero("phase", crankshaft.phase, Dimension::Angle);
            self.entry_unless_zero("x", crankshaft.x, Dimension::Length);
            self.entry_unless_zero("y", crankshaft.y, Dimension::Length);
            if let Some(mains) = &crankshaft.mains {
                let list: Vec<String> = mains.iter().map(|&z| quantity(z, Dimension::Length)).collect();
                self.entry("main_positions", &format!("[{}]", list.join(", ")));
            }
        }
    }

    fn throw(&mut self, index: usize, throw: &Throw, weighed: bool) {
        self.header("[[throw]]", &format!("{}", index + 1));
        if throw.crankshaft > 0 {
            self.entry("crankshaft", &(throw.crankshaft + 1).to_string());
        }
        self.entry("angle", &quantity(throw.angle, Dimension::Angle));
        self.entry("z", &quantity(throw.z, Dimension::Length));
        self.entry("radius", &quantity(throw.radius, Dimension::Length));
        if weighed {
            self.entry_unless_zero("unbalance", throw.unbalance, Dimension::Unbalance);
        }
        if let Some([front, rear]) = throw.webs {
            let text = web_distance(throw)
                .unwrap_or_else(|| text_that(rear - front, Dimension::Length, |read| read == rear - front));
            self.entry("web_distance", &format!("\"{text}\""));
        }
    }

    fn cylinder(&mut self, index: usize, cylinder: &Cylinder, engine: &Engine) {
        self.header("[[cylinder]]", "");
        self.entry("number", &(index + 1).to_string());
        self.entry("throw", &(cylinder.throw + 1).to_string());
        self.entry("angle", &quantity(cylinder.angle, Dimension::Angle));
        self.entry("z", &quantity(cylinder.z, Dimension::Length));
        self.entry_unless_zero("offset", cylinder.offset, Dimension::Length);
        self.entry_unless_zero("pin_offset", cylinder.pin_offset, Dimension::Length);
        if let Some(bore) = cylinder.bore {
            self.entry("bore", &quantity(bore, Dimension::Length));
        }
        if let Some(first) = cylinder.chamber {
            self.entry("chamber", &(first + 1).to_string());
        }
        self.entry("piston", &format!("{{ mass = {} }}", quantity(cylinder.piston_mass, Dimension::Mass)));
        let sharing = engine
            .cylinders
            .iter()
            .filter(|other| other.throw == cylinder.throw)
            .filter(|other| !matches!(other.rod.joint, RodJoint::Articulated { .. }))
            .count();
        let rod = &cylinder.rod;
        let joint = match rod.joint {
            RodJoint::Crankpin if sharing > 1 => "type = \"side-by-side\", ".to_string(),
            RodJoint::Crankpin => String::new(),
            RodJoint::Fork => "type = \"fork\", ".to_string(),
            RodJoint::Blade => "type = \"blade\", ".to_string(),
            RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => format!(
                "type = \"articulated\", master = {}, knuckle_radius = {}, knuckle_angle = {}, ",
                master + 1,
                quantity(knuckle_radius, Dimension::Length),
                quantity(knuckle_angle, Dimension::Angle)
            ),
        };
        let length = quantity(rod.length, Dimension::Length);
        self.entry("rod", &format!("{{ {joint}length = {length}, {} }}", rod_masses(rod)));
    }

    fn weights(&mut self, engine: &Engine) {
        for weight in &engine.counterweights {
            self.header("[[counterweight]]", "");
            self.entry("name", &quoted(&weight.name));
            if let Some(part) = &weight.part {
                self.part(weight, part, engine);
                continue;
            }
            if weight.crankshaft > 0 {
                self.entry("crankshaft", &(weight.crankshaft + 1).to_string());
            }
            self.entry("z", &quantity(weight.z, Dimension::Length));
            self.entry("unbalance", &quantity(weight.unbalance, Dimension::Unbalance));
            self.entry("angle", &quantity(weight.angle, Dimension::Angle));
        }
        for shaft in &engine.shafts {
            self.header("[[shaft]]", "");
            self.entry("name", &quoted(&shaft.name));
            self.entry("ratio", &ratio(shaft.ratio));
            self.entry("x", &quantity(shaft.x, Dimension::Length));
            self.entry("y", &quantity(shaft.y, Dimension::Length));
            if let Some(inertia) = shaft.inertia {
                self.entry("inertia", &quantity(inertia, Dimension::Inertia));
            }
            let list: String = shaft.weights.iter().map(shaft_part::weight_line).collect();
            self.entry("weights", &format!("[\n{list}]"));
        }
        for gear in &engine.gears {
            self.header("[[gear]]", "");
            self.entry("name", &quoted(&gear.name));
            self.entry("ratio", &ratio(gear.ratio));
            self.entry_unless_zero("x", gear.x, Dimension::Length);
            self.entry_unless_zero("y", gear.y, Dimension::Length);
            if let Some(inertia) = gear.inertia {
                self.entry("inertia", &quantity(inertia, Dimension::Inertia));
            }
            if let Some(disc) = gear.disc {
                self.entry("diameter", &quantity(disc.diameter, Dimension::Length));
                self.entry("width", &quantity(disc.width, Dimension::Length));
                self.entry("density", &quantity(disc.density, Dimension::Density));
                self.entry_unless_zero("bore", disc.bore, Dimension::Length);
            }
        }
    }
}

/// The distance of webs that stand at half of it from the plane of their throw; `None` for others.
fn web_distance(throw: &Throw) -> Option<String> {
    let ([front, rear], z) = (throw.webs?, throw.z);
    let fits = |distance: f64| z - distance / 2.0 == front && z + distance / 2.0 == rear;
    // Rounding has lost some of the distance: each of these may be the one that was given.
    let guesses = [rear - front, 2.0 * (z - front), 2.0 * (rear - z), (z - front) + (rear - z)];
    let mut near = guesses.into_iter();
    let distance = near.find(|guess| neighbours(*guess).into_iter().any(fits))?;
    Some(text_that(distance, Dimension::Length, fits))
}

/// The masses of a rod by the rule by which they were given.
fn rod_masses(rod: &Rod) -> String {
    let (big, small) = (rod.big_end_mass, rod.small_end_mass);
    let mut text = match rod.mass_rule {
        RodMassRule::Thirds => {
            let mass = text_that(big + small, Dimension::Mass, |mass| {
                mass * 2.0 / 3.0 == big && mass / 3.0 == small
            });
            format!("mass = \"{mass}\"")
        }
        RodMassRule::WeighedEnds => format!(
            "big_end_mass = {}, small_end_mass = {}",
            quantity(big, Dimension::Mass),
            quantity(small, Dimension::Mass)
        ),
        RodMassRule::CentreOfGravity => {
            let (mass, centre) = mass_and_centre(rod);
            format!(
                "mass = {}, centre_of_gravity = {}",
                quantity(mass, Dimension::Mass),
                quantity(centre, Dimension::Length)
            )
        }
    };
    if let Some(inertia) = rod.inertia {
        let _ = write!(text, ", inertia = {}", quantity(inertia, Dimension::Inertia));
    }
    if rod.axial_inertia > 0.0 {
        let _ = write!(text, ", axial_inertia = {}", quantity(rod.axial_inertia, Dimension::Inertia));
    }
    text
}

/// Mass and centre of gravity from which the reader computes the same two end masses.
fn mass_and_centre(rod: &Rod) -> (f64, f64) {
    let (big, small, length) = (rod.big_end_mass, rod.small_end_mass, rod.length);
    let (mass, centre) = (rod.mass(), rod.centre_of_gravity());
    let fits = |mass: f64, centre: f64| {
        let read = mass * (centre / length);
        read == small && mass - read == big && (0.0..=length).contains(&centre)
    };
    neighbours(mass)
        .into_iter()
        .flat_map(|mass| neighbours(centre).into_iter().map(move |centre| (mass, centre)))
        .find(|(mass, centre)| fits(*mass, *centre))
        .unwrap_or((mass, centre))
}

/// Of each throw, whether its unbalance is given, and not that of its body.
fn weighed(engine: &Engine) -> Vec<bool> {
    let of_body = engine.crank_body.as_ref().and_then(|body| {
        let details = engine.crank_details.clone().unwrap_or_default();
        lanchester_model::throw_unbalances(body, &details, &engine.throws).ok()
    });
    let Some(of_body) = of_body else { return vec![true; engine.throws.len()] };
    let is_body = |(throw, found): (&Throw, &lanchester_model::ThrowUnbalance)| {
        throw.unbalance == found.unbalance && throw.unbalance_offset == found.offset
    };
    engine.throws.iter().zip(&of_body).map(|pair| !is_body(pair)).collect()
}
