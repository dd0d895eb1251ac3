//! How far a quantity of a sensitivity goes, as users write it.

use lanchester_study::sensitivity::{Amount, Measure, Quantity};
use lanchester_task::option::{self, BadQuantity};

/// Reads `rod length = 10 %`: a quantity, and how far it goes either way. `name` is what the front end calls the option.
///
/// # Errors
/// Where there is no such quantity, or the amount is not of its dimension.
///
/// ```
/// use lanchester::study::sensitivity::Amount;
/// let (quantity, amount) = lanchester::sensitivity_amount("rod  length = 10 %", "vary")?;
/// assert_eq!((quantity.name(), amount), ("rod length", Amount::Share(0.1)));
/// assert!(lanchester::sensitivity_amount("rod length = 2 kg", "vary").is_err());
/// # Ok::<(), lanchester::task::option::BadQuantity>(())
/// ```
pub fn sensitivity_amount(text: &str, name: &str) -> Result<(Quantity, Amount), BadQuantity> {
    let Some((quantity, value)) = text.split_once('=') else {
        return Err(BadQuantity {
            message: format!("`{name}` needs a quantity and how far it goes, got \"{text}\""),
            hint: "write it like \"rod length = 10 %\" or \"throw angle = 0.5 deg\"".to_owned(),
        });
    };
    let words = quantity.split_whitespace().collect::<Vec<_>>().join(" ");
    let Some(quantity) = Quantity::all().find(|quantity| quantity.name() == words) else {
        let names: Vec<&str> = Quantity::all().map(Quantity::name).collect();
        return Err(BadQuantity {
            message: format!("`{name}` knows no quantity \"{words}\""),
            hint: format!("it knows {}", names.join(", ")),
        });
    };
    if value.trim_end().ends_with('%') {
        return Ok((quantity, Amount::Share(option::share(value, &words)?)));
    }
    let read = match quantity.measure() {
        Measure::Mass | Measure::BodyMass => option::mass,
        Measure::Length | Measure::Place => option::length,
        Measure::Angle => option::angle,
        Measure::Unbalance => option::unbalance,
        Measure::Inertia | Measure::BodyInertia => option::inertia,
        Measure::Speed => option::speed,
        Measure::Factor => option::share,
    };
    Ok((quantity, Amount::Absolute(read(value, &words)?)))
}
