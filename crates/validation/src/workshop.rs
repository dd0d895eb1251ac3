//! Workshop sheets: what bobweights, balance quality grades and two-plane corrections come to.
//!
//! | quantity | what it is |
//! |---|---|
//! | `workshop rotating mass` | of the rods on the first pin, without oil |
//! | `workshop permissible unbalance`, `workshop permissible eccentricity` | of the whole rotor, by its grade |
//! | `workshop influence of PLANE on SENSOR` | change of the reading for each kilogram at the radius of the plane |
//! | `workshop correction mass of PLANE`, `workshop correction angle of PLANE` | to add at the radius of the plane; its angle on the rotor, within a turn [deg] |

use lanchester::task::workshop::Sheet;
use lanchester::workshop::{Correction, bobweights, correction, grade};

/// A quantity of a workshop sheet.
pub(crate) enum WorkshopKey {
    RotatingMass,
    PermissibleUnbalance,
    PermissibleEccentricity,
    Influence { plane: String, sensor: String },
    CorrectionMass(String),
    CorrectionAngle(String),
}

impl WorkshopKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<WorkshopKey> {
        let name = text.strip_prefix("workshop ")?;
        if let Some(plane) = name.strip_prefix("correction mass of ") {
            return Some(WorkshopKey::CorrectionMass(plane.to_string()));
        }
        if let Some(plane) = name.strip_prefix("correction angle of ") {
            return Some(WorkshopKey::CorrectionAngle(plane.to_string()));
        }
        if let Some((plane, sensor)) =
            name.strip_prefix("influence of ").and_then(|rest| rest.split_once(" on "))
        {
            return Some(WorkshopKey::Influence { plane: plane.to_string(), sensor: sensor.to_string() });
        }
        match name {
            "rotating mass" => Some(WorkshopKey::RotatingMass),
            "permissible unbalance" => Some(WorkshopKey::PermissibleUnbalance),
            "permissible eccentricity" => Some(WorkshopKey::PermissibleEccentricity),
            _ => None,
        }
    }

    /// Its value, in SI units; angles in degrees.
    pub fn of(&self, sheet: &Sheet) -> Result<f64, String> {
        let grade = || grade(sheet).map_err(|error| error.to_string());
        let correction = || correction(sheet).map_err(|error| error.to_string());
        match self {
            WorkshopKey::RotatingMass => {
                let parts = sheet.bobweight.as_ref().ok_or("the sheet has no bobweight")?;
                let share = parts.reciprocating_share.unwrap_or(0.5);
                let found = bobweights(parts, share).map_err(|error| error.to_string())?;
                found.first().map(|pin| pin.rotating).ok_or_else(|| "the sheet has no pin".to_string())
            }
            WorkshopKey::PermissibleUnbalance => Ok(grade()?.permissible),
            WorkshopKey::PermissibleEccentricity => Ok(grade()?.eccentricity),
            WorkshopKey::Influence { plane, sensor } => {
                let correction = correction()?;
                let influence = correction.runs.iter().flat_map(|runs| &runs.influence);
                let found = influence.into_iter().find(|i| i.plane == *plane && i.sensor == *sensor);
                let found = found.ok_or_else(|| format!("no influence of {plane:?} on {sensor:?}"))?;
                Ok(found.shown * radius(sheet, plane)?)
            }
            WorkshopKey::CorrectionMass(plane) => {
                Ok(unbalance(&correction()?, plane)?.norm() / radius(sheet, plane)?)
            }
            WorkshopKey::CorrectionAngle(plane) => {
                Ok(unbalance(&correction()?, plane)?.arg().to_degrees().rem_euclid(360.0))
            }
        }
    }
}

fn unbalance(correction: &Correction, plane: &str) -> Result<num_complex::Complex64, String> {
    let found = correction.planes.iter().find(|found| found.plane == plane);
    found.map(|found| found.unbalance).ok_or_else(|| format!("no correction in {plane:?}"))
}

fn radius(sheet: &Sheet, plane: &str) -> Result<f64, String> {
    let found = sheet.planes.iter().find(|found| found.name == plane).and_then(|plane| plane.radius);
    found.ok_or_else(|| format!("the sheet gives no radius of {plane:?}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        for name in [
            "rotating mass",
            "permissible unbalance",
            "influence of plane 1 on sensor 2",
            "correction angle of plane 2",
        ] {
            assert!(WorkshopKey::parse(&format!("workshop {name}")).is_some(), "{name}");
            assert!(WorkshopKey::parse(name).is_none(), "{name}");
        }
        assert!(WorkshopKey::parse("workshop influence of plane 1").is_none());
        assert!(WorkshopKey::parse("workshop colour").is_none());
    }
}
