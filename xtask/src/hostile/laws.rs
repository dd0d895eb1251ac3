//! Laws that hold for every engine, whatever its numbers: similarity, and what a turn of the crank or of the engine changes.

use super::ground::Ground;
use super::random::Random;
use anyhow::{Context, Result, ensure};
use serde_json::Value;

/// Rounding of some thousand operations, of units written in decimal and read back; a law that fails does so by far more.
const TOLERANCE: f64 = 1e-9;

/// An in-line engine.
#[derive(Clone)]
struct Engine {
    /// [rpm]
    speed: f64,
    /// [mm]
    spacing: f64,
    stroke: f64,
    rod: f64,
    /// [kg]
    piston: f64,
    rod_mass: f64,
    /// Of the throws [deg].
    angles: Vec<f64>,
}

impl Engine {
    fn random(random: &mut Random) -> Engine {
        let stroke = random.between(40.0, 160.0);
        let cylinders = 1 + random.below(6);
        Engine {
            speed: random.between(500.0, 9000.0),
            spacing: random.between(60.0, 200.0),
            stroke,
            rod: stroke * random.between(1.2, 2.5),
            piston: random.between(0.1, 3.0),
            rod_mass: random.between(0.1, 3.0),
            // The first throw stands at 0.
            angles: (0..cylinders).map(|k| if k == 0 { 0.0 } else { random.between(0.0, 360.0) }).collect(),
        }
    }

    fn text(&self) -> String {
        let cylinders = self.angles.len();
        let angles: Vec<String> = self.angles.iter().map(|angle| format!("\"{angle} deg\"")).collect();
        format!(
            "name = \"random\"\nstrokes = 4\nspeed = \"{} rpm\"\n[layout]\ntype = \"in-line\"\n\
             cylinders = {cylinders}\nspacing = \"{} mm\"\ncrank_angles = [{}]\n[crank]\nstroke = \"{} mm\"\n[piston]\n\
             mass = \"{} kg\"\nbore = \"{} mm\"\n[rod]\nlength = \"{} mm\"\nmass = \"{} kg\"\n",
            self.speed,
            self.spacing,
            angles.join(", "),
            self.stroke,
            self.piston,
            0.8 * self.spacing,
            self.rod,
            self.rod_mass
        )
    }
}

/// Amplitudes of the whole by order: force and couple of both senses [N, N m].
fn amplitudes(ground: &Ground, engine: &Engine) -> Result<[Vec<f64>; 2]> {
    std::fs::write(ground.folder.join("law.toml"), engine.text())?;
    let said = ground.run(&["loads", "law.toml", "--format", "json"])?;
    ensure!(said.status == Some(0), "loads refuses\n{}\n{}", engine.text(), said.err);
    let loads: Value = serde_json::from_str(&said.out)?;
    let orders = loads["total"]["orders"].as_array().context("the loads have no orders")?;
    let norm = |value: &Value| {
        let part = |k: usize| value[k].as_f64().unwrap_or(f64::NAN);
        part(0).hypot(part(1))
    };
    let of = |keys: [&str; 2]| orders.iter().flat_map(|order| keys.map(|key| norm(&order[key]))).collect();
    Ok([of(["force_forward", "force_backward"]), of(["couple_forward", "couple_backward"])])
}

pub fn run(ground: &mut Ground) -> Result<u64> {
    let mut count = 0;
    while ground.goes_on(count) {
        let engine = Engine::random(&mut ground.random);
        let [force, couple] = amplitudes(ground, &engine)?;
        let factor = ground.random.between(0.3, 3.0);
        let law = ground.random.below(5);
        let mut other = engine.clone();
        // What it is called, the factors of force and couple.
        let (name, forces, couples) = match law {
            0 => {
                (other.piston, other.rod_mass) = (factor * engine.piston, factor * engine.rod_mass);
                ("loads grow with the masses", factor, Some(factor))
            }
            1 => {
                other.speed = factor * engine.speed;
                ("loads grow with the square of speed", factor * factor, Some(factor * factor))
            }
            2 => {
                (other.stroke, other.rod, other.spacing) =
                    (factor * engine.stroke, factor * engine.rod, factor * engine.spacing);
                ("forces grow with the lengths, couples with their square", factor, Some(factor * factor))
            }
            // A throw at -a instead of a: every sum over throws `m e^{ina}` becomes its conjugate, of the same size.
            3 => {
                other.angles.iter_mut().for_each(|angle| *angle = (360.0 - *angle) % 360.0);
                ("a mirrored crank turns every order about, in its own sense", 1.0, Some(1.0))
            }
            // Couples are about the origin, which is another place then, as seen from the engine.
            _ => {
                other.angles.reverse();
                let first = other.angles[0];
                other.angles.iter_mut().for_each(|angle| *angle = (*angle - first + 360.0) % 360.0);
                ("an engine turned end for end has the same forces", 1.0, None)
            }
        };
        let [force_then, couple_then] = amplitudes(ground, &other)?;
        let same = |a: &[f64], b: &[f64], factor: f64| {
            let scale = a.iter().copied().fold(f64::MIN_POSITIVE, f64::max) * factor;
            let close = a.iter().zip(b).all(|(a, b)| (a * factor - b).abs() <= TOLERANCE * scale);
            close && a.len() == b.len() && scale.is_finite()
        };
        // What is rounding of the largest force stands for nothing, and so does its couple.
        let negligible = |load: &[f64], scale: f64| load.iter().all(|value| *value <= 1e-9 * scale);
        let reach = force.iter().copied().fold(0.0, f64::max);
        let inertia =
            engine.piston * engine.stroke * 1e-3 * (engine.speed * std::f64::consts::TAU / 60.0).powi(2);
        let forces_hold = same(&force, &force_then, forces) || negligible(&force, inertia.max(reach));
        let couples_hold =
            couples.is_none_or(|factor| same(&couple, &couple_then, factor) || negligible(&couple, inertia));
        ensure!(
            forces_hold && couples_hold,
            "{name}: broken by\n{}\nbefore {force:?}\n{couple:?}\nafter {force_then:?}\n{couple_then:?}",
            engine.text()
        );
        count += 1;
    }
    Ok(count)
}
