//! Outputs by name, in the words of all studies.

use super::error::SensitivityError;
use super::output::{Output, Size, Target};
use lanchester_mechanism::BearingPart;
use lanchester_model::Engine;
use lanchester_results::{self as results, Counted, OutputError, Place, Quantity};
use lanchester_task::{Criterion, Load, criterion};

impl Output {
    /// The output of this name: a load such as `force`, `torque`, `main-bearing load 2`, `mount force front`; before it `gas` or `inertia`
    /// where these alone count, behind it `mean` or `order 2` ([`lanchester_results::Output`]).
    ///
    /// # Errors
    /// [`SensitivityError::NoSuchOutput`] and its like where there is none of that name, with what to write.
    pub fn named(text: &str, engine: &Engine) -> Result<Output, SensitivityError> {
        let output = text.parse::<results::Output>().map_err(|error| refused(text, error))?;
        let unknown = || SensitivityError::NoSuchOutput { got: text.chars().take(60).collect() };
        let load = || output.quantity.name().to_owned();
        if output.axis.is_some() || output.sense.is_some() {
            return Err(unknown());
        }
        let number = match output.place {
            Place::Number(number) => Some(number - 1),
            Place::Any | Place::Largest | Place::Named(_) => None,
        };
        let target = match output.quantity {
            Quantity::Force => Target::Force,
            Quantity::Couple => Target::Couple,
            Quantity::RollMoment => Target::RollMoment,
            Quantity::Torque => Target::Torque,
            Quantity::ExcessEnergy => Target::ExcessEnergy,
            Quantity::SpeedFluctuation => Target::SpeedFluctuation,
            Quantity::MainBearingLoad => Target::MainBearing(number),
            Quantity::CrankpinLoad => Target::Crankpin(number),
            Quantity::PistonPinLoad => Target::PistonPin(number),
            Quantity::SideThrust => Target::SideThrust(number),
            Quantity::BendingMoment => Target::BendingMoment(number),
            Quantity::MountForce => mount(&output.place, engine)?,
            _ => return Err(unknown()),
        };
        let size = match output.size {
            results::Size::Peak => Size::Peak,
            results::Size::Mean => Size::Mean,
            results::Size::Order(order) => Size::Order(order),
            results::Size::Rms => return Err(SensitivityError::NoSuchSize { load: load() }),
        };
        let is_of_inertia =
            matches!(target, Target::Force | Target::Couple | Target::RollMoment | Target::BendingMoment(_));
        let part = match (target, output.counted) {
            (Target::BendingMoment(_), Counted::Gas | Counted::All)
            | (Target::SpeedFluctuation, Counted::Gas) => {
                return Err(SensitivityError::NoSuchPartOf { load: load() });
            }
            (_, Counted::Gas | Counted::All) if is_of_inertia => {
                return Err(SensitivityError::NoGasForce { load: load() });
            }
            _ if is_of_inertia => BearingPart::Inertia,
            (_, Counted::Usual | Counted::All) => BearingPart::All,
            (_, Counted::Gas) => BearingPart::Gas,
            (_, Counted::Inertia) => BearingPart::Inertia,
        };
        let output = Output { target, part, size };
        let has_mean =
            !matches!(target, Target::Force | Target::Couple | Target::RollMoment | Target::MountForce(_));
        if size != Size::Peak && output.has_no_angle() || size == Size::Mean && !has_mean {
            return Err(SensitivityError::NoSuchSize { load: load() });
        }
        Ok(output)
    }
}

/// Why a text names no output.
fn refused(text: &str, error: OutputError) -> SensitivityError {
    match error {
        OutputError::Order { .. } => SensitivityError::Wording {
            message: error.to_string(),
            hint: "write for example force order 2".to_owned(),
        },
        OutputError::Number { of, got } => SensitivityError::Number { of, got },
        OutputError::Size { of } => SensitivityError::NoSuchSize { load: of.to_owned() },
        _ => SensitivityError::NoSuchOutput { got: text.chars().take(60).collect() },
    }
}

/// A mount by its name, as criteria have it.
fn mount(place: &Place, engine: &Engine) -> Result<Target, SensitivityError> {
    let name = match place {
        Place::Named(name) => format!("{} {name}", Quantity::MountForce.name()),
        Place::Number(number) => format!("{} {number}", Quantity::MountForce.name()),
        Place::Any | Place::Largest => Quantity::MountForce.name().to_owned(),
    };
    match criterion(&name, engine) {
        Ok(Criterion::Peak(Load::MountForce(index))) => Ok(Target::MountForce(Some(index))),
        Ok(Criterion::Peak(Load::LargestMountForce)) => Ok(Target::MountForce(None)),
        Ok(_) => Err(SensitivityError::NoSuchOutput { got: name }),
        Err(bad) => Err(SensitivityError::Wording { message: bad.message, hint: bad.hint }),
    }
}
