//! Tolerances by kind of state, points of the block and teeth of `[simulation]`.

use super::optional;
use crate::document::{Field, Section};
use crate::read::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::{GearMesh, NamedPoint, StateTolerances};

/// Largest pressure angle [rad].
const STEEPEST: f64 = std::f64::consts::FRAC_PI_4;

impl<'a> Reader<'a> {
    pub(in crate::read) fn state_tolerances(&mut self, section: &'a Section) -> Option<StateTolerances> {
        let table = match section.table("tolerances") {
            Field::Given(spot) => spot.value,
            Field::Absent => return Some(StateTolerances::default()),
            Field::Bad => return None,
        };
        let [angle, speed, displacement, turn, velocity, spin, energy] =
            ["angle", "speed", "displacement", "turn", "velocity", "spin", "energy"]
                .map(|key| optional(table.number(key)));
        Some(StateTolerances {
            angle: angle?,
            speed: speed?,
            displacement: displacement?,
            turn: turn?,
            velocity: velocity?,
            spin: spin?,
            energy: energy?,
        })
    }

    pub(in crate::read) fn named_points(&mut self, section: &'a Section) -> Option<Vec<NamedPoint>> {
        let tables = section.tables("point").or(&[])?;
        let mut points: Vec<NamedPoint> = Vec::new();
        let mut is_good = true;
        for table in tables {
            let name = self.required(table, "name", table.text("name"));
            let place = ["x", "y", "z"].map(|key| table.number(key).or(0.0));
            let (Some(name), [Some(x), Some(y), Some(z)]) = (name, place) else {
                is_good = false;
                continue;
            };
            if points.iter().any(|point| point.name == name) {
                let message = format!("two points of the block are called \"{name}\"");
                self.mistakes.push(
                    Mistake::error("E1803", table.value_span("name"), message)
                        .hint("give each point a name of its own"),
                );
                is_good = false;
            }
            points.push(NamedPoint { name, at: [x, y, z] });
        }
        is_good.then_some(points)
    }

    pub(in crate::read) fn meshes(&mut self, section: &'a Section) -> Option<Vec<GearMesh>> {
        let tables = section.tables("mesh").or(&[])?;
        let mut meshes: Vec<GearMesh> = Vec::new();
        let mut is_good = true;
        for table in tables {
            let shaft = self.required(table, "shaft", table.text("shaft"));
            let angle = self.required(table, "pressure_angle", table.number("pressure_angle"));
            let z = self.required(table, "z", table.number("z"));
            let (Some(shaft), Some(pressure_angle), Some(z)) = (shaft, angle, z) else {
                is_good = false;
                continue;
            };
            if pressure_angle > STEEPEST {
                let message = format!(
                    "`pressure_angle` must lie between 0 and 45 deg, got {} deg",
                    pressure_angle.to_degrees()
                );
                self.mistakes.push(
                    Mistake::error("E0108", table.value_span("pressure_angle"), message)
                        .label("out of range")
                        .hint("spur gears have 20 deg, old ones 14.5 deg"),
                );
                is_good = false;
            }
            if meshes.iter().any(|mesh| mesh.shaft == shaft) {
                let message = format!("the shaft \"{shaft}\" has two gears with crankshaft 1");
                self.mistakes.push(
                    Mistake::error("E1803", table.value_span("shaft"), message)
                        .hint("give the teeth of each shaft once"),
                );
                is_good = false;
            }
            meshes.push(GearMesh { shaft, pressure_angle, z });
        }
        is_good.then_some(meshes)
    }
}
