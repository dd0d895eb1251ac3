//! Static stress of a crankshaft under a force on its first pin, in a change of an engine, and what comes of it as quantities.
//!
//! | place in a change | value |
//! |---|---|
//! | `stress.radial`, `stress.tangential` | force on pin 1, away from the axis and across the throw, "-65 kN" |
//! | `stress.ring thickness`, `stress.ring modulus` | "5 mm", "210 GPa": rings with contact; the journals' surfaces held without them |
//! | `stress.size` | elements away from fillets, "14 mm" |
//! | `stress.fillet elements` | elements across a fillet, "4"; corners are sharp without it, which is enough for displacements and webs |
//!
//! | quantity | what it is |
//! |---|---|
//! | `stress displacement` | largest of the crankshaft [m] |
//! | `stress pin fillet` | largest von Mises stress of the fillets of pin 1 [Pa] |
//! | `stress pin` | largest of the surface of pin 1 between them [Pa] |
//! | `stress web` | largest of the web behind pin 1 away from its fillets: the central one of a twin [Pa] |

use crate::source::NewValue;
use lanchester::flex::crank_case::{CrankLoad, CrankSupport, PinLoad, SurfacePeak};
use lanchester::flex::crank_mesh::{CrankMeshOptions, crank_mesh};
use lanchester::flex::crank_solve::solve_crank;
use lanchester::flex::statics::SolveOptions;
use lanchester::model::Engine;
use std::collections::BTreeMap;

/// Places, with the unit of their values and its SI value.
const PLACES: [(&str, &str, f64); 6] = [
    ("radial", "kN", 1e3),
    ("tangential", "kN", 1e3),
    ("ring thickness", "mm", 1e-3),
    ("ring modulus", "GPa", 1e9),
    ("size", "mm", 1e-3),
    ("fillet elements", "", 1.0),
];

/// The case that a change gives.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct StressFit {
    given: BTreeMap<&'static str, f64>,
}

impl StressFit {
    /// Takes a change that is its own; `false`: it is not.
    pub fn take(&mut self, place: &str, value: &NewValue) -> Result<bool, String> {
        let Some(name) = place.strip_prefix("stress.") else { return Ok(false) };
        let known = PLACES.iter().find(|(known, ..)| *known == name);
        let (name, unit, factor) = known.ok_or_else(|| format!("a stress case has no {place:?}"))?;
        let NewValue::Text(text) = value else { return Err(format!("{place:?} needs a text")) };
        let number: Option<f64> = text.strip_suffix(unit).and_then(|t| t.trim().parse().ok());
        let number = number.ok_or_else(|| format!("{place:?} needs a number in {unit}, got {text:?}"))?;
        self.given.insert(name, number * factor);
        Ok(true)
    }

    fn of(&self, name: &str) -> Option<f64> {
        self.given.get(name).copied()
    }

    /// The mesh that is asked for.
    pub fn mesh(&self) -> CrankMeshOptions {
        let usual = CrankMeshOptions::default();
        CrankMeshOptions {
            size: self.of("size").unwrap_or(usual.size),
            fillet_elements: self.of("fillet elements").map_or(usual.fillet_elements, |count| count as usize),
            fillets: self.of("fillet elements").is_some(),
        }
    }
}

/// What a case gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StressRun {
    displacement: f64,
    pin_fillet: f64,
    pin: f64,
    web: f64,
}

impl StressRun {
    /// Of an engine and a case.
    pub fn of(engine: &Engine, fit: &StressFit) -> Result<StressRun, String> {
        let radial = fit.of("radial").ok_or("a stress case needs the change stress.radial")?;
        let options = fit.mesh();
        let support = match (fit.of("ring thickness"), fit.of("ring modulus")) {
            (Some(thickness), Some(modulus)) => CrankSupport::Rings { thickness, modulus },
            (None, None) => CrankSupport::Journals,
            _ => return Err("rings need a thickness and a modulus".to_string()),
        };
        // Throw 1 points along x, and the crankshaft turns from x to y.
        if engine.throws[0].angle != 0.0 {
            return Err("a stress case needs throw 1 at 0 deg".to_string());
        }
        let force = [radial, fit.of("tangential").unwrap_or(0.0)];
        let load = CrankLoad { pins: vec![PinLoad { pin: 1, force }], ..CrankLoad::default() };
        let crank = crank_mesh(engine, 0, options).map_err(|error| error.to_string())?;
        let solved = solve_crank(&crank, &support, &[load], SolveOptions::default());
        let solved = solved.map_err(|error| error.to_string())?;
        let result = solved.first().ok_or("the case has no solution")?;
        let largest = |peaks: &[SurfacePeak], is_own: &dyn Fn(&str) -> bool| {
            let own = peaks.iter().filter(|peak| is_own(&peak.name)).filter_map(|peak| peak.stress);
            own.map(|stress| stress.von_mises).fold(f64::NAN, f64::max)
        };
        Ok(StressRun {
            displacement: result.largest_displacement,
            pin_fillet: largest(&result.peaks, &|name| name.starts_with("pin 1 at")),
            pin: largest(&result.surfaces, &|name| name == "PIN_1"),
            web: largest(&result.webs, &|name| name == "web 2"),
        })
    }
}

/// A quantity of a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum StressKey {
    Displacement,
    PinFillet,
    Pin,
    Web,
}

impl StressKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<StressKey> {
        Some(match text.strip_prefix("stress ")? {
            "displacement" => StressKey::Displacement,
            "pin fillet" => StressKey::PinFillet,
            "pin" => StressKey::Pin,
            "web" => StressKey::Web,
            _ => return None,
        })
    }

    /// Its value [m or Pa].
    pub fn of(self, run: &StressRun) -> f64 {
        match self {
            StressKey::Displacement => run.displacement,
            StressKey::PinFillet => run.pin_fillet,
            StressKey::Pin => run.pin,
            StressKey::Web => run.web,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_names_are_read() {
        let text = |text: &str| NewValue::Text(text.to_string());
        let mut fit = StressFit::default();
        assert_eq!(fit.take("stress.radial", &text("-65 kN")), Ok(true));
        assert_eq!(fit.take("stress.fillet elements", &text("4")), Ok(true));
        assert_eq!(fit.take("crank.stroke", &text("1 mm")), Ok(false));
        assert!(
            fit.take("stress.radial", &text("-65 N m")).is_err()
                && fit.take("stress.of", &text("1")).is_err()
        );
        assert_eq!((fit.of("radial"), fit.of("fillet elements")), (Some(-65e3), Some(4.0)));
        assert_eq!(StressKey::parse("stress web"), Some(StressKey::Web));
        assert!(StressKey::parse("stress").is_none() && StressKey::parse("stress of").is_none());
    }
}
