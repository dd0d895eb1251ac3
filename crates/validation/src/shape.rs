//! A counterweight's shape in a change of an engine, and what it amounts to as quantities.
//!
//! | place in a change | value |
//! |---|---|
//! | `shape.arc radius`, `shape.rectangle height`, `shape.web radius`, `shape.thickness` | "50 mm" |
//! | `shape.shoulder angle`, `shape.arc angle` | "1.46 rad" |
//! | `shape.density` | "8000 kg/m3" |
//! | `shape.duty` | unbalance that is full balance, "8 kg mm" |
//!
//! | quantity | what it is |
//! |---|---|
//! | `shape mass`, `shape swept radius`, `shape shoulder` | of the counterweight, integrated along its outline; `l_c` |
//! | `shape balance` | its unbalance over full balance [%] |
//! | `shape balance, printed centroid` | the same with eq. 30 of the tool paper as printed: `r^3/3` more in the first moment |
//! | `shape height` | `h + H + R`, which the tool paper calls `R_min` |

use crate::source::NewValue;
use lanchester::geometry::CounterweightShape;
use std::collections::BTreeMap;

/// Places of a shape, with the unit of their values and its SI value.
const PLACES: [(&str, &str, f64); 8] = [
    ("arc radius", "mm", 1e-3),
    ("rectangle height", "mm", 1e-3),
    ("web radius", "mm", 1e-3),
    ("thickness", "mm", 1e-3),
    ("shoulder angle", "rad", 1.0),
    ("arc angle", "rad", 1.0),
    ("density", "kg/m3", 1.0),
    ("duty", "kg mm", 1e-3),
];

/// The shape that a change gives.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct ShapeFit {
    given: BTreeMap<&'static str, f64>,
}

/// A quantity of a shape.
pub(crate) enum ShapeKey {
    Mass,
    SweptRadius,
    Shoulder,
    Balance { printed_centroid: bool },
    Height,
}

impl ShapeFit {
    /// Takes a change that is its own; `false`: it is not.
    pub fn take(&mut self, place: &str, value: &NewValue) -> Result<bool, String> {
        let Some(name) = place.strip_prefix("shape.") else { return Ok(false) };
        let known = PLACES.iter().find(|(known, ..)| *known == name);
        let (name, unit, factor) = known.ok_or_else(|| format!("a shape has no {place:?}"))?;
        let NewValue::Text(text) = value else { return Err(format!("{place:?} needs a text")) };
        let number: Option<f64> = text.strip_suffix(unit).and_then(|t| t.trim().parse().ok());
        let number = number.ok_or_else(|| format!("{place:?} needs a number in {unit}, got {text:?}"))?;
        self.given.insert(name, number * factor);
        Ok(true)
    }

    fn get(&self, name: &str) -> Result<f64, String> {
        self.given.get(name).copied().ok_or_else(|| format!("the shape needs its {name}"))
    }

    fn shape(&self) -> Result<CounterweightShape, String> {
        let shape = CounterweightShape {
            web_radius: self.get("web radius")?,
            rectangle_height: self.get("rectangle height")?,
            shoulder_height: 0.0,
            arc_radius: self.get("arc radius")?,
            arc_angle: self.get("arc angle")?,
        };
        let shoulder_height = shape.shoulder() * self.get("shoulder angle")?.tan();
        CounterweightShape { shoulder_height, ..shape }.checked().map_err(|error| error.to_string())
    }
}

impl ShapeKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<ShapeKey> {
        Some(match text.strip_prefix("shape ")? {
            "mass" => ShapeKey::Mass,
            "swept radius" => ShapeKey::SweptRadius,
            "shoulder" => ShapeKey::Shoulder,
            "balance" => ShapeKey::Balance { printed_centroid: false },
            "balance, printed centroid" => ShapeKey::Balance { printed_centroid: true },
            "height" => ShapeKey::Height,
            _ => return None,
        })
    }

    /// Its value.
    pub fn of(&self, fit: &ShapeFit) -> Result<f64, String> {
        let shape = fit.shape()?;
        let plate = || Ok::<f64, String>(fit.get("density")? * fit.get("thickness")?);
        Ok(match self {
            ShapeKey::Mass => plate()? * shape.moments().area,
            ShapeKey::SweptRadius => shape.swept_radius(),
            ShapeKey::Shoulder => shape.shoulder(),
            ShapeKey::Balance { printed_centroid } => {
                let more = if *printed_centroid { shape.web_radius.powi(3) / 3.0 } else { 0.0 };
                100.0 * plate()? * (shape.moments().first.x + more) / fit.get("duty")?
            }
            ShapeKey::Height => shape.chord_distance() + shape.arc_radius,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fit() -> ShapeFit {
        let mut fit = ShapeFit::default();
        for (place, value) in [
            ("shape.arc radius", "50 mm"),
            ("shape.rectangle height", "20 mm"),
            ("shape.web radius", "20 mm"),
            ("shape.thickness", "6 mm"),
            ("shape.shoulder angle", "0 rad"),
            ("shape.arc angle", "3.141592653589793 rad"),
            ("shape.density", "8000 kg/m3"),
            ("shape.duty", "8 kg mm"),
        ] {
            assert_eq!(fit.take(place, &NewValue::Text(value.to_string())), Ok(true));
        }
        fit
    }

    #[test]
    fn half_disc_on_a_bar_is_added_up_by_hand() {
        let of = |name: &str| ShapeKey::parse(name).unwrap().of(&fit()).unwrap();
        let half_disc = std::f64::consts::PI * 0.05f64.powi(2) / 2.0;
        let web = std::f64::consts::PI * 0.02f64.powi(2) / 2.0;
        let mass = 48.0 * (half_disc + 0.04 * 0.02 - web);
        assert!((of("shape mass") - mass).abs() < 1e-14);
        let first = half_disc * 0.02 + 2.0 / 3.0 * 0.05f64.powi(3) + 0.02 * 0.02f64.powi(2)
            - 2.0 / 3.0 * 0.02f64.powi(3);
        assert!((of("shape balance") - 100.0 * 48.0 * first / 8e-3).abs() < 1e-10);
        assert!((of("shape swept radius") - 0.07).abs() < 1e-15 && (of("shape height") - 0.07).abs() < 1e-15);
        assert!(of("shape balance, printed centroid") > of("shape balance"));
    }

    #[test]
    fn places_and_names_that_are_none_are_refused() {
        let mut fit = ShapeFit::default();
        let text = |text: &str| NewValue::Text(text.to_string());
        assert_eq!(fit.take("crank.stroke", &text("1 mm")), Ok(false));
        assert!(fit.take("shape.colour", &text("red")).is_err());
        assert!(fit.take("shape.thickness", &text("1 kg")).is_err());
        assert!(fit.take("shape.thickness", &NewValue::Gone(())).is_err());
        assert!(ShapeKey::parse("shape thickness").is_none() && ShapeKey::parse("mass").is_none());
        assert!(ShapeKey::Mass.of(&fit).is_err());
    }
}
