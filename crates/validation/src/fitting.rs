//! Changes of an engine that no line of its file can say: the arrangements of the twin-cylinder thesis, and the other
//! published methods ([`MethodFit`]); the shape of a counterweight ([`ShapeFit`]); and a case of static stress ([`StressFit`]).
//!
//! | place in a change | value |
//! |---|---|
//! | `arrangement` | number of the thesis's arrangement, "1" to "9" |
//! | `power.step` | step of the speeds among which the largest power is looked for, "100 rpm" |
//! | `arrangement.crank`, `arrangement.first order`, `arrangement.second order` | an amount of it, "0.04116 kg m", in place of the found one |

use crate::method::MethodFit;
use crate::shape::ShapeFit;
use crate::source::NewValue;
use crate::stress::StressFit;
use lanchester::literature::{ArrangementOptions, GivenAmounts, SweepOptions, TwinArrangement, arranged};
use lanchester::mechanism::{LoadRequest, PeakMode};
use lanchester::model::Engine;

/// What is fitted to an engine after it was read.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Fitting {
    arrangement: Option<TwinArrangement>,
    given: GivenAmounts,
    method: MethodFit,
    pub shape: ShapeFit,
    pub stress: StressFit,
    /// Step of the speeds among which the largest power is looked for [rpm].
    pub power_step: Option<f64>,
}

impl Fitting {
    /// Takes a change that is its own; `false`: it is one of the file.
    pub fn take(&mut self, place: &str, value: &NewValue) -> Result<bool, String> {
        if self.method.take(place, value)?
            || self.shape.take(place, value)?
            || self.stress.take(place, value)?
        {
            return Ok(true);
        }
        if place == "power.step" {
            let NewValue::Text(text) = value else { return Err(format!("{place:?} needs a text")) };
            let step = text.strip_suffix(" rpm").and_then(|number| number.parse().ok());
            self.power_step =
                Some(step.ok_or_else(|| format!("{place:?} needs a speed in rpm, got {text:?}"))?);
            return Ok(true);
        }
        let slot = match place {
            "arrangement" => None,
            "arrangement.crank" => Some(&mut self.given.crank),
            "arrangement.first order" => Some(&mut self.given.first_order),
            "arrangement.second order" => Some(&mut self.given.second_order),
            _ => return Ok(false),
        };
        let NewValue::Text(text) = value else { return Err(format!("{place:?} needs a text")) };
        match slot {
            None => {
                let number = text.parse().ok().and_then(TwinArrangement::from_number);
                self.arrangement = Some(number.ok_or_else(|| format!("no arrangement is called {text:?}"))?);
            }
            Some(slot) => {
                let amount = text.strip_suffix(" kg m").and_then(|number| number.parse().ok());
                *slot =
                    Some(amount.ok_or_else(|| format!("{place:?} needs an amount in kg m, got {text:?}"))?);
            }
        }
        Ok(true)
    }

    /// The engine with it, found with the motion and the grid of the request.
    pub fn fitted(&self, engine: Engine, request: &LoadRequest) -> Result<Engine, String> {
        let Some(arrangement) = self.arrangement else {
            return if self.given == GivenAmounts::default() {
                self.method.fitted(engine)
            } else {
                Err("amounts of an arrangement need an arrangement".to_string())
            };
        };
        if self.method != MethodFit::default() {
            return Err("an engine takes an arrangement or a method, not both".to_string());
        }
        let mut sweep = SweepOptions::default();
        if let PeakMode::Grid(angles) = request.peaks {
            sweep.angles = angles;
        }
        let options = ArrangementOptions {
            kinematics: request.kinematics,
            sweep,
            given: self.given,
            ..ArrangementOptions::default()
        };
        arranged(&engine, arrangement, &options).map_err(|error| error.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrangements_and_their_amounts_are_taken() {
        let text = |text: &str| NewValue::Text(text.to_string());
        let mut fitting = Fitting::default();
        assert_eq!(fitting.take("crank.stroke", &text("1 mm")), Ok(false));
        assert_eq!(fitting.take("arrangement", &text("4")), Ok(true));
        assert_eq!(fitting.take("arrangement.crank", &text("0.04116 kg m")), Ok(true));
        assert_eq!(fitting.arrangement, Some(TwinArrangement::OneFirst));
        assert_eq!(fitting.given.crank, Some(0.04116));
        assert!(fitting.take("arrangement", &text("10")).is_err());
        assert!(fitting.take("arrangement.crank", &text("41 g")).is_err());
        assert!(fitting.take("arrangement.first order", &NewValue::Gone(())).is_err());
    }

    #[test]
    fn amounts_without_an_arrangement_are_refused() {
        let template = lanchester::file::template("single").unwrap();
        let engine = lanchester::file::read(template.text).engine().unwrap();
        let mut fitting = Fitting::default();
        assert_eq!(fitting.fitted(engine.clone(), &LoadRequest::default()), Ok(engine.clone()));
        fitting.take("arrangement.crank", &NewValue::Text("1 kg m".into())).unwrap();
        assert!(fitting.fitted(engine, &LoadRequest::default()).is_err());
    }
}
