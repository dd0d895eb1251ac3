//! Quantities outside an engine file: the options of a command line.

use crate::criterion::{self, criterion};
use crate::engine::Engine;
use crate::give_up;
use crate::quantity::{Bound, Dimension, Refusal, parse, within};
use crate::task::{GiveUp, Limit, Load, Stage};

/// Why a text is no quantity of the kind that is due.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct BadQuantity {
    /// What was needed and what was got.
    pub message: String,
    /// What to do.
    pub hint: String,
}

impl From<Refusal> for BadQuantity {
    fn from(refusal: Refusal) -> BadQuantity {
        BadQuantity { message: refusal.message, hint: refusal.hint }
    }
}

/// A speed with its unit, such as "4000 rpm" [rad/s]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of speed, or outside the accepted range, more than 0.
pub fn speed(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Speed, Bound::Positive, option)
}

/// A length with its unit, such as "-120 mm" [m]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of length.
pub fn length(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Length, Bound::Any, option)
}

/// A mass with its unit, such as "412 g" [kg]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of mass, or outside the accepted range, 0 or more.
pub fn mass(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Mass, Bound::NotNegative, option)
}

/// An angle with its unit, such as "180 deg" [rad]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of angle.
pub fn angle(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Angle, Bound::Any, option)
}

/// An inertia with its unit, such as "0.02 kg m2" [kg m^2]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of inertia, or outside the accepted range, 0 or more.
pub fn inertia(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Inertia, Bound::NotNegative, option)
}

/// A pressure with its unit, such as "1.2 bar" [Pa]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of pressure, or outside the accepted range, 0 or more.
pub fn pressure(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Pressure, Bound::NotNegative, option)
}

/// A torque with its unit, such as "95 N m" [N m]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of torque, or outside the accepted range, 0 or more.
pub fn torque(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Torque, Bound::NotNegative, option)
}

/// A time with its unit, such as "30 s" or "5 min" [s]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number above 0 with a unit of time.
pub fn time(text: &str, option: &str) -> Result<f64, BadQuantity> {
    const UNITS: [(&str, f64); 4] = [("ms", 1e-3), ("s", 1.0), ("min", 60.0), ("h", 3600.0)];
    let text = text.trim();
    let (number, unit) = text.split_at(text.trim_end_matches(|c: char| c.is_ascii_alphabetic()).len());
    let factor = UNITS.iter().find(|(name, _)| *name == unit).map(|(_, factor)| factor);
    let time = number.trim().parse::<f64>().ok().zip(factor).map(|(number, factor)| number * factor);
    time.filter(|time| time.is_finite() && *time > 0.0).ok_or_else(|| BadQuantity {
        message: format!("`{option}` needs a time above 0 with its unit, got \"{text}\""),
        hint: "write a number with ms, s, min or h, such as \"30 s\"".into(),
    })
}

/// A density with its unit, such as "7850 kg/m3" [kg/m^3]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of density, or if no material of a crankshaft has it.
pub fn density(text: &str, option: &str) -> Result<f64, BadQuantity> {
    let density = of_dimension(text, Dimension::Density, Bound::Positive, option)?;
    match lanchester_shape::plausible_density(density) {
        Ok(()) => Ok(density),
        Err(error) => {
            let error = error.to_string();
            let (message, hint) = error.split_once("\nhint: ").unwrap_or((&error, ""));
            Err(BadQuantity { message: format!("`{option}`: {message}"), hint: hint.into() })
        }
    }
}

/// A share such as "50%", "50 %" or "0.5"; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number, or a bare number beyond 2, which is meant in percent.
pub fn share(text: &str, option: &str) -> Result<f64, BadQuantity> {
    match text.trim().parse::<f64>() {
        Ok(bare) if (0.0..=2.0).contains(&bare) => Ok(bare),
        Ok(bare) if bare > 2.0 && bare.is_finite() => Err(BadQuantity {
            message: format!("`{option}` needs a share, got the bare number {bare}"),
            hint: format!("write {bare}% or {}", bare / 100.0),
        }),
        Ok(bare) if bare < 0.0 => {
            within(bare, Dimension::Share, Bound::NotNegative, option, text, None).map_err(BadQuantity::from)
        }
        _ => of_dimension(text, Dimension::Share, Bound::NotNegative, option),
    }
}

/// An unbalance with its unit, such as "0.03 kg m" [kg m]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number of 0 or more with a unit of unbalance.
pub fn unbalance(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Unbalance, Bound::NotNegative, option)
}

/// An unbalance [kg m], given as itself or as a mass at `radius`; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if it is neither, not above 0, or a mass without a radius.
pub fn mass_or_unbalance(text: &str, radius: Option<f64>, option: &str) -> Result<f64, BadQuantity> {
    let example = "write a mass such as \"5 g\", which counts at the radius of the weight, or an unbalance such as \"200 g mm\"";
    let hinted = |refusal: Refusal| BadQuantity { message: refusal.message, hint: example.into() };
    let mass = parse(text, Dimension::Mass, option);
    let own = if mass.is_ok() { Dimension::Mass } else { Dimension::Unbalance };
    let is_mass = mass.is_ok();
    let value = mass.or_else(|_| parse(text, Dimension::Unbalance, option)).map_err(hinted)?;
    let value = within(value, own, Bound::Positive, option, text, None).map_err(hinted)?;
    match (is_mass, radius) {
        (false, _) => Ok(value),
        (true, Some(radius)) => Ok(value * radius),
        (true, None) => Err(BadQuantity {
            message: format!("a mass in `{option}` needs the radius of every weight"),
            hint: "give an unbalance such as \"200 g mm\", or radius in [balance]".into(),
        }),
    }
}

/// A limit such as "couple = 5 N m" or "force order 1=200 N"; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if it is not a criterion, an equals sign and a quantity of 0 or more in a unit of the criterion.
pub fn limit(text: &str, engine: &Engine, option: &str) -> Result<Limit, BadQuantity> {
    let Some((name, value)) = text.rsplit_once('=') else {
        return Err(BadQuantity {
            message: format!("`{option}` needs a criterion and its largest value, got \"{text}\""),
            hint: format!("for example {option} \"couple = 5 N m\""),
        });
    };
    let criterion = criterion(name, engine)?;
    let most = amount(value, &criterion, name.trim())?;
    if most < 0.0 {
        return Err(BadQuantity {
            message: format!("the limit of `{}` must not be negative, got {}", name.trim(), value.trim()),
            hint: "give the largest amount that it may have".into(),
        });
    }
    Ok(Limit { criterion, most })
}

/// What is minimised at once: a criterion such as "force", or several with the value of each that counts as much as
/// those of the others, such as "force = 200 N, couple = 10 N m"; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if it is neither.
pub fn stage(text: &str, engine: &Engine, option: &str) -> Result<Stage, BadQuantity> {
    if !text.contains('=') {
        return Ok(Stage { terms: vec![(1.0, criterion(text, engine)?)] });
    }
    let term = |part: &str| {
        let limit = limit(part, engine, option)?;
        let weight = 1.0 / limit.most;
        if weight.is_finite() {
            Ok((weight, limit.criterion))
        } else {
            Err(BadQuantity {
                message: format!("the value of {} must be more than 0", part.trim()),
                hint: "a criterion counts by its share of the value given for it".into(),
            })
        }
    };
    Ok(Stage::of(text.split(',').map(term).collect::<Result<_, _>>()?))
}

/// What a stage gives up for those after it: "force = 1 %", "force 1 %", "force = 5 N", or "1 %" for the stage at `place` of
/// `stages`; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if it names no stage, or no share or amount of 0 or more.
pub fn give_up(
    text: &str,
    place: usize,
    stages: &[Stage],
    engine: &Engine,
    option: &str,
) -> Result<(usize, GiveUp), BadQuantity> {
    let of_stage = |name: &str, value: &str| {
        let found = criterion(name, engine)?;
        let stage = give_up::stage_of(&found, stages).ok_or_else(|| {
            let names = stages.iter().flat_map(|stage| &stage.terms);
            let names: Vec<String> = names.map(|term| criterion::criterion_name(&term.1, engine)).collect();
            BadQuantity::from(give_up::no_stage(name.trim(), &names))
        })?;
        give_up::amount(value, &stages[stage], name.trim())
            .map(|given| (stage, given))
            .map_err(BadQuantity::from)
    };
    if let Some((name, value)) = text.rsplit_once('=') {
        return of_stage(name, value);
    }
    // The longest beginning that is a criterion: names of orders end in a number too.
    let text = text.trim();
    let ends = text.char_indices().filter(|(_, c)| c.is_whitespace()).map(|(place, _)| place);
    let names: Vec<usize> = ends.filter(|&end| criterion(&text[..end], engine).is_ok()).collect();
    if let Some(&end) = names.last() {
        return of_stage(&text[..end], &text[end..]);
    }
    if !text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) {
        return Err(BadQuantity {
            message: format!("`{option}` needs a stage and what it gives up, got \"{text}\""),
            hint: format!("for example {option} 'force = 1 %', or {option} '1 %' for the first stage"),
        });
    }
    let Some(stage) = stages.get(place) else {
        return Err(BadQuantity {
            message: format!(
                "`{option} '{text}'` is for stage {}, and there are {}",
                place + 1,
                stages.len()
            ),
            hint: "give one for each stage at most, or name the stage".into(),
        });
    };
    let name = stage.terms.first().map_or(String::new(), |term| criterion::criterion_name(&term.1, engine));
    give_up::amount(text, stage, &name).map(|given| (place, given)).map_err(BadQuantity::from)
}

/// Orders that must vanish: one, such as "force order 1", or several with commas between them; `option` names what asks
/// for them in the message.
///
/// # Errors
/// [`BadQuantity`] if one of them is not one order of a load on the engine's block.
pub fn cancel(text: &str, engine: &Engine, option: &str) -> Result<Vec<(Load, f64)>, BadQuantity> {
    let one = |part: &str| {
        let found = criterion(part, engine)?;
        criterion::cancelled(&found).ok_or_else(|| BadQuantity {
            message: format!("`{option}` {}, got \"{}\"", criterion::CANCEL_NEEDS, part.trim()),
            hint: criterion::cancel_hint(part.trim()),
        })
    };
    text.split(',').map(one).collect()
}

fn amount(text: &str, criterion: &crate::task::Criterion, name: &str) -> Result<f64, BadQuantity> {
    parse(text, criterion::dimension(criterion), name).map_err(BadQuantity::from)
}

/// A quantity within the range that a key of the engine file has too.
fn of_dimension(text: &str, dimension: Dimension, bound: Bound, option: &str) -> Result<f64, BadQuantity> {
    let value = parse(text, dimension, option).map_err(BadQuantity::from)?;
    within(value, dimension, bound, option, text, None).map_err(BadQuantity::from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::task::{Criterion, Load};

    fn four() -> Engine {
        crate::read(crate::template("in-line-4").unwrap().text).engine.unwrap()
    }

    #[test]
    fn limits_and_stages_of_a_command_line() {
        let engine = four();
        let limit = |text| limit(text, &engine, "--limit");
        assert_eq!(limit("couple=5 N m"), Ok(Limit { criterion: Criterion::Peak(Load::Couple), most: 5.0 }));
        assert_eq!(
            limit("force order 1/2 = 0.2 kN"),
            Ok(Limit { criterion: Criterion::Order(Load::Force, 0.5), most: 200.0 })
        );
        for (text, says) in [
            ("couple", "--limit"),
            ("couple = 5 N", "`couple` needs a torque"),
            ("couple = -5 N m", "negative"),
            ("coupel = 5 N m", "no criterion"),
            ("couple = 5", "unit"),
        ] {
            let refused = limit(text).unwrap_err();
            assert!(refused.message.contains(says), "{refused:?}");
        }
        let engine = four();
        let stage = |text| stage(text, &engine, "--minimise");
        assert_eq!(stage("force"), Ok(Stage { terms: vec![(1.0, Criterion::Peak(Load::Force))] }));
        let both = vec![(1.0 / 200.0, Criterion::Peak(Load::Force)), (0.1, Criterion::Peak(Load::Couple))];
        assert_eq!(stage("force = 200 N, couple = 10 N m"), Ok(Stage { terms: both }));
        assert_eq!(stage("force = 200 N"), stage("force"), "one alone is no share of anything");
        assert!(stage("force = 0 N").is_err() && stage("force, couple").is_err());
    }

    #[test]
    fn orders_to_cancel_of_a_command_line() {
        let engine = four();
        let cancel = |text| cancel(text, &engine, "--cancel");
        assert_eq!(cancel("force order 1"), Ok(vec![(Load::Force, 1.0)]));
        assert_eq!(
            cancel("couple order 2,roll moment order 1/2"),
            Ok(vec![(Load::Couple, 2.0), (Load::RollMoment, 0.5)])
        );
        for (text, part) in [
            ("force", "force order 1"),
            ("added mass", "one order of a load"),
            ("bending moment order 1", "one order of a load"),
            ("forse order 1", "did you mean"),
            ("", "criterion"),
            ("force order 1,", "criterion"),
        ] {
            let refused = cancel(text).unwrap_err();
            assert!(format!("{} {}", refused.message, refused.hint).contains(part), "{text}: {refused:?}");
        }
    }

    #[test]
    fn a_speed_and_what_is_none() {
        assert_eq!(speed("60 rpm", "--speed"), Ok(std::f64::consts::TAU));
        assert_eq!(length("-12 mm", "--about"), Ok(-0.012));
        assert_eq!(mass("412 g", "--bobweight"), Ok(0.412));
        assert_eq!((time("1.5 min", "--time-limit"), time("20ms", "--time-limit")), (Ok(90.0), Ok(0.02)));
        for text in ["5", "0 s", "-1 s", "5 kg", "inf s", "s", ""] {
            assert!(time(text, "--time-limit").is_err_and(|bad| bad.hint.contains("30 s")), "{text}");
        }
        assert_eq!(angle("180 deg", "--angle"), Ok(std::f64::consts::PI));
        assert_eq!(inertia("2 kg m2", "--inertia"), Ok(2.0));
        assert_eq!((share("50%", "--share"), share("0.5", "--share")), (Ok(0.5), Ok(0.5)));
        assert!(share("50", "--share").unwrap_err().hint.starts_with("write 50%"));
        // What a key of the engine file does not take, no option takes.
        for text in ["-500 rpm", "0 rpm", "1e20 rpm"] {
            let refused = speed(text, "--speed").unwrap_err();
            assert!(refused.message.contains("--speed") && !refused.hint.is_empty(), "{refused:?}");
        }
        assert!(mass("-1 kg", "--oil").is_err() && share("-0.5", "--share").is_err());
        assert!(inertia("-1 kg m2", "--inertia").is_err() && length("1e20 m", "--about").is_err());
        let refused = speed("60 mm", "--speed").unwrap_err();
        assert!(refused.message.contains("--speed") && refused.hint.contains("rpm"), "{refused:?}");
    }
}
