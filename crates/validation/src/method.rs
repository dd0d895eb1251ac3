//! Published balancing methods in a change of an engine, and the devices that they fit as quantities.
//!
//! | place in a change | value |
//! |---|---|
//! | `method` | which, see [`Kind`]; it replaces all counterweights and shafts of the engine |
//! | `method.webs` | webs with a counterweight, "110011"; all of them without it |
//! | `method.alpha` | counterweight offset angle, "30 deg"; the best one without it |
//! | `method.counterweight radius`, `method.shaft radius`, `method.shaft length` | "30 mm" |
//!
//! | quantity | what it is |
//! |---|---|
//! | `counterweight n unbalance` | of the n-th counterweight |
//! | `counterweight n turn` | its angle from opposite its throw [deg], without sign |
//! | `weight of shaft NAME` | unbalance of the first weight of the shaft of this name; 0 if there is none |

use crate::source::NewValue;
use lanchester::literature::{
    Alpha, AngleRule, BalancerPhase, FourCylinderRule, MatrixMethod, ShaftPair, ThreeCylinderRule,
};
use lanchester::model::Engine;

/// Which method, by its name in a change.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// "matrix method".
    Matrix,
    /// "matrix method, first order on the crank": without the shaft that turns with it.
    MatrixOnCrank,
    /// "matrix method, printed V": the tool paper's unprojected sum over both banks.
    PrintedV,
    /// "matrix method, printed V at whole radians": with the maximum among 0, 1, .., 6 rad.
    PrintedVAtWholeRadians,
    /// "three cylinders".
    Three,
    /// "three cylinders, printed phase": front weight opposite crank 1.
    ThreePrintedPhase,
    /// "four cylinders".
    Four,
}

const KINDS: [(&str, Kind); 7] = [
    ("matrix method", Kind::Matrix),
    ("matrix method, first order on the crank", Kind::MatrixOnCrank),
    ("matrix method, printed V", Kind::PrintedV),
    ("matrix method, printed V at whole radians", Kind::PrintedVAtWholeRadians),
    ("three cylinders", Kind::Three),
    ("three cylinders, printed phase", Kind::ThreePrintedPhase),
    ("four cylinders", Kind::Four),
];

/// A published method and what its user chooses.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct MethodFit {
    kind: Option<Kind>,
    webs: Vec<bool>,
    alpha: Option<f64>,
    counterweight_radius: Option<f64>,
    shaft_radius: Option<f64>,
    shaft_length: Option<f64>,
}

impl MethodFit {
    /// Takes a change that is its own; `false`: it is not.
    pub fn take(&mut self, place: &str, value: &NewValue) -> Result<bool, String> {
        if place.split('.').next() != Some("method") {
            return Ok(false);
        }
        let NewValue::Text(text) = value else { return Err(format!("{place:?} needs a text")) };
        let number = |unit: &str, factor: f64| {
            let number: Option<f64> = text.strip_suffix(unit).and_then(|t| t.trim().parse().ok());
            number
                .map(|n| n * factor)
                .ok_or_else(|| format!("{place:?} needs a number in {unit}, got {text:?}"))
        };
        match place {
            "method" => {
                let kind = KINDS.iter().find(|(name, _)| name == text).map(|(_, kind)| *kind);
                self.kind = Some(kind.ok_or_else(|| format!("no method is called {text:?}"))?);
            }
            "method.webs" => {
                let web = |c: char| match c {
                    '0' => Ok(false),
                    '1' => Ok(true),
                    _ => Err(format!("{place:?} needs 0 and 1, got {text:?}")),
                };
                self.webs = text.chars().map(web).collect::<Result<_, _>>()?;
            }
            "method.alpha" => self.alpha = Some(number("deg", 1f64.to_radians())?),
            "method.counterweight radius" => self.counterweight_radius = Some(number("mm", 1e-3)?),
            "method.shaft radius" => self.shaft_radius = Some(number("mm", 1e-3)?),
            "method.shaft length" => self.shaft_length = Some(number("mm", 1e-3)?),
            _ => return Err(format!("a method has no {place:?}")),
        }
        Ok(true)
    }

    /// The engine with the devices of the method; itself if no method was asked for.
    pub fn fitted(&self, engine: Engine) -> Result<Engine, String> {
        let Some(kind) = self.kind else {
            return if *self == MethodFit::default() {
                Ok(engine)
            } else {
                Err("choices of a method need a method".to_string())
            };
        };
        let fitted = match kind {
            Kind::Matrix => self.matrix(false)?.fit(&engine).map(|b| b.engine),
            Kind::MatrixOnCrank => self.matrix(true)?.fit(&engine).map(|b| b.engine),
            Kind::PrintedV => self.matrix(false)?.printed_v(&engine, AngleRule::Continuous).map(|b| b.engine),
            Kind::PrintedVAtWholeRadians => {
                self.matrix(false)?.printed_v(&engine, AngleRule::WholeRadians).map(|b| b.engine)
            }
            Kind::Three => self.three(BalancerPhase::CouplePeak)?.fit(&engine).map(|b| b.engine),
            Kind::ThreePrintedPhase => {
                self.three(BalancerPhase::OppositeFirstThrow)?.fit(&engine).map(|b| b.engine)
            }
            Kind::Four => {
                let rule = FourCylinderRule { forward_at: [0.0, 0.1], backward_at: [0.0, -0.1] };
                rule.fit(&engine).map(|b| b.engine)
            }
        };
        fitted.map_err(|error| error.to_string())
    }

    /// The shafts stand where Table 1 of the tool paper has them, at 100 and 200 mm either side.
    fn matrix(&self, first_on_crank: bool) -> Result<MatrixMethod, String> {
        let radius = given(self.shaft_radius, "shaft radius")?;
        let length = given(self.shaft_length, "shaft length")?;
        let pair = |y: f64| Some(ShaftPair { radius, length, forward_y: y, backward_y: -y });
        Ok(MatrixMethod {
            web_pattern: self.webs.clone(),
            alpha: self.alpha.map_or(Alpha::Fitted, Alpha::Given),
            counterweight_radius: given(self.counterweight_radius, "counterweight radius")?,
            first: pair(0.1),
            second: pair(0.2),
            first_on_crank,
        })
    }

    fn three(&self, phase: BalancerPhase) -> Result<ThreeCylinderRule, String> {
        let shaft_length = given(self.shaft_length, "shaft length")?;
        Ok(ThreeCylinderRule { shaft_length, shaft_at: [0.0, 0.0], phase })
    }
}

fn given(value: Option<f64>, name: &str) -> Result<f64, String> {
    value.ok_or_else(|| format!("the method needs its {name}"))
}

/// A device of an engine as a quantity.
pub(crate) enum DeviceKey {
    /// Unbalance of a counterweight, by index.
    CounterweightUnbalance(usize),
    /// Its turn out of the line of the nearest throw, by index.
    CounterweightTurn(usize),
    /// First weight of the shaft of this name.
    ShaftWeight(String),
}

impl DeviceKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<DeviceKey> {
        if let Some(name) = text.strip_prefix("weight of shaft ") {
            return Some(DeviceKey::ShaftWeight(name.to_string()));
        }
        let (number, what) = text.strip_prefix("counterweight ")?.split_once(' ')?;
        let index = number.parse::<usize>().ok()?.checked_sub(1)?;
        match what {
            "unbalance" => Some(DeviceKey::CounterweightUnbalance(index)),
            "turn" => Some(DeviceKey::CounterweightTurn(index)),
            _ => None,
        }
    }

    /// Its value.
    pub fn of(&self, engine: &Engine) -> Result<f64, String> {
        let weight = |index: usize| {
            engine.counterweights.get(index).ok_or_else(|| "the engine has no such counterweight".to_string())
        };
        match self {
            DeviceKey::CounterweightUnbalance(index) => Ok(weight(*index)?.unbalance),
            DeviceKey::CounterweightTurn(index) => {
                let weight = weight(*index)?;
                let distance = |z: f64| (z - weight.z).abs();
                let nearest = engine.throws.iter().min_by(|a, b| distance(a.z).total_cmp(&distance(b.z)));
                let throw = nearest.ok_or_else(|| "the engine has no throw".to_string())?;
                let turn = weight.angle - throw.angle - std::f64::consts::PI;
                Ok(turn.sin().atan2(turn.cos()).abs().to_degrees())
            }
            DeviceKey::ShaftWeight(name) => {
                let shaft = engine.shafts.iter().find(|s| s.name == *name);
                Ok(shaft.and_then(|s| s.weights.first()).map_or(0.0, |w| w.unbalance))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_are_read() {
        let text = |text: &str| NewValue::Text(text.to_string());
        let mut fit = MethodFit::default();
        assert_eq!(fit.take("crank.stroke", &text("1 mm")), Ok(false));
        assert_eq!(fit.take("method", &text("three cylinders")), Ok(true));
        assert_eq!(fit.take("method.webs", &text("101")), Ok(true));
        assert_eq!(fit.take("method.shaft length", &text("400 mm")), Ok(true));
        assert_eq!((fit.kind, fit.webs.as_slice()), (Some(Kind::Three), [true, false, true].as_slice()));
        assert_eq!(fit.shaft_length, Some(0.4));
        assert!(fit.take("method", &text("guess")).is_err());
        assert!(fit.take("method.webs", &text("12")).is_err());
        assert!(fit.take("method.alpha", &text("30 mm")).is_err());
        assert!(fit.take("method.colour", &text("red")).is_err());
        assert!(fit.take("method.alpha", &NewValue::Gone(())).is_err());
    }

    #[test]
    fn choices_without_a_method_or_a_method_without_choices_are_refused() {
        let engine =
            lanchester::file::read(lanchester::file::template("in-line-3").unwrap().text).engine().unwrap();
        let fit = MethodFit { shaft_length: Some(0.4), ..MethodFit::default() };
        assert!(fit.fitted(engine.clone()).is_err());
        let fit = MethodFit { kind: Some(Kind::Three), ..MethodFit::default() };
        assert!(fit.fitted(engine.clone()).is_err());
        assert_eq!(MethodFit::default().fitted(engine.clone()), Ok(engine));
    }

    #[test]
    fn devices_are_read_by_name() {
        for name in ["counterweight 1 unbalance", "counterweight 12 turn", "weight of shaft balancer"] {
            assert!(DeviceKey::parse(name).is_some(), "{name}");
        }
        for name in ["counterweight 0 turn", "counterweight one turn", "counterweight 1 colour", "weight"] {
            assert!(DeviceKey::parse(name).is_none(), "{name}");
        }
    }
}
