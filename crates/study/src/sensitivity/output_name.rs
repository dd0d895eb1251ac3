//! Outputs by name, as command lines call them.

use super::error::SensitivityError;
use super::output::{Output, Size, Target};
use lanchester_mechanism::BearingPart;
use lanchester_model::Engine;
use lanchester_task::{Criterion, criterion};

/// What stands behind a load for one order of it, and for its mean.
const ORDER: &str = " order ";
const MEAN: &str = " mean";

/// Loads without a number.
const PLAIN: [(&str, Target); 6] = [
    ("force", Target::Force),
    ("couple", Target::Couple),
    ("roll moment", Target::RollMoment),
    ("torque", Target::Torque),
    ("excess energy", Target::ExcessEnergy),
    ("speed fluctuation", Target::SpeedFluctuation),
];

/// A load of the part of an index, or of the largest of all.
type OfPart = fn(Option<usize>) -> Target;

/// Loads with the number of their part behind them, or that of the largest.
const NUMBERED: [(&str, OfPart); 5] = [
    ("main bearing", Target::MainBearing),
    ("crankpin", Target::Crankpin),
    ("piston pin", Target::PistonPin),
    ("side thrust", Target::SideThrust),
    ("bending moment", Target::BendingMoment),
];

const MOUNT: &str = "mount force";

/// Which loads count, before the load.
const PARTS: [(&str, BearingPart); 2] = [("gas ", BearingPart::Gas), ("inertia ", BearingPart::Inertia)];

impl Output {
    /// The output of this name: a load such as `force`, `torque`, `main bearing 2`, `mount force front`; before it `gas` or `inertia` where
    /// these alone count, behind it `mean` or `order 2`.
    ///
    /// # Errors
    /// [`SensitivityError::NoSuchOutput`] and its like where there is none of that name, with what to write.
    pub fn named(text: &str, engine: &Engine) -> Result<Output, SensitivityError> {
        let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let unknown = || SensitivityError::NoSuchOutput { got: words.chars().take(60).collect() };
        let (rest, size) = match (words.rsplit_once(ORDER), words.strip_suffix(MEAN)) {
            (Some((rest, number)), _) => (rest, Size::Order(order(number, engine)?)),
            (None, Some(rest)) => (rest, Size::Mean),
            (None, None) => (words.as_str(), Size::Peak),
        };
        let prefix = PARTS.iter().find_map(|(word, part)| Some((rest.strip_prefix(word)?, Some(*part))));
        let (load, part) = prefix.unwrap_or((rest, None));
        let target = target(load, engine)?.ok_or_else(unknown)?;
        let is_of_inertia =
            matches!(target, Target::Force | Target::Couple | Target::RollMoment | Target::BendingMoment(_));
        let part = match (target, part) {
            (Target::BendingMoment(_) | Target::SpeedFluctuation, Some(BearingPart::Gas)) => {
                return Err(SensitivityError::NoSuchPartOf { load: load.to_owned() });
            }
            (_, Some(BearingPart::Gas)) if is_of_inertia => {
                return Err(SensitivityError::NoGasForce { load: load.to_owned() });
            }
            _ if is_of_inertia => BearingPart::Inertia,
            (_, part) => part.unwrap_or(BearingPart::All),
        };
        let output = Output { target, part, size };
        let has_mean =
            !matches!(target, Target::Force | Target::Couple | Target::RollMoment | Target::MountForce(_));
        if size != Size::Peak && output.has_no_angle() || size == Size::Mean && !has_mean {
            return Err(SensitivityError::NoSuchSize { load: load.to_owned() });
        }
        Ok(output)
    }
}

/// `2`, `0.5` or `1/2`, as criteria have it.
fn order(text: &str, engine: &Engine) -> Result<f64, SensitivityError> {
    match criterion(&format!("force{ORDER}{text}"), engine) {
        Ok(Criterion::Order(_, order)) => Ok(order),
        Ok(_) => Err(SensitivityError::NoSuchOutput { got: text.to_owned() }),
        Err(bad) => Err(SensitivityError::Wording { message: bad.message, hint: bad.hint }),
    }
}

fn target(load: &str, engine: &Engine) -> Result<Option<Target>, SensitivityError> {
    if let Some((_, target)) = PLAIN.iter().find(|(name, _)| *name == load) {
        return Ok(Some(*target));
    }
    if load.starts_with(MOUNT) {
        return mount(load, engine).map(Some);
    }
    let numbered = NUMBERED.iter().find_map(|(name, target)| Some((*name, load.strip_prefix(name)?, target)));
    let Some((name, number, target)) = numbered else { return Ok(None) };
    match number.strip_prefix(' ').map(str::parse::<usize>) {
        None if number.is_empty() => Ok(Some(target(None))),
        Some(Ok(number)) if number > 0 => Ok(Some(target(Some(number - 1)))),
        _ => Err(SensitivityError::Number { of: name, got: number.trim().chars().take(60).collect() }),
    }
}

/// A mount by its name, as criteria have it.
fn mount(load: &str, engine: &Engine) -> Result<Target, SensitivityError> {
    use lanchester_task::Load;
    match criterion(load, engine) {
        Ok(Criterion::Peak(Load::MountForce(index))) => Ok(Target::MountForce(Some(index))),
        Ok(Criterion::Peak(Load::LargestMountForce)) => Ok(Target::MountForce(None)),
        Ok(_) => Err(SensitivityError::NoSuchOutput { got: load.to_owned() }),
        Err(bad) => Err(SensitivityError::Wording { message: bad.message, hint: bad.hint }),
    }
}
