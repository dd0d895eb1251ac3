//! The start of a run in words, as a request gives it beside the file.

use lanchester_model::StartOfBlock;
use lanchester_task::option;

/// Where a run starts; what is `None` is as the file says.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StartOfRun {
    /// Crank angle [rad].
    pub angle: Option<f64>,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: Option<f64>,
    /// Place of the block.
    pub block: Option<StartOfBlock>,
}

/// A start from words such as `90 deg, 800 rpm, as drawn`: each part at most once.
///
/// # Errors
/// What is wrong, and what to write instead.
///
/// # Example
/// ```
/// let start = lanchester_file::start_from_words("90 deg, 800 rpm").unwrap();
/// assert!((start.angle.unwrap() - std::f64::consts::FRAC_PI_2).abs() < 1e-15 && start.block.is_none());
/// assert_eq!(lanchester_file::start_from_words("0 rpm").unwrap().speed, Some(0.0));
/// assert!(lanchester_file::start_from_words("90 deg, 45 deg").is_err());
/// ```
pub fn start_from_words(text: &str) -> Result<StartOfRun, (String, String)> {
    let mut start = StartOfRun::default();
    for part in text.split([',', '/']).map(str::trim) {
        let twice = match part {
            "equilibrium" => start.block.replace(StartOfBlock::Equilibrium).is_some(),
            "as drawn" => start.block.replace(StartOfBlock::AsDrawn).is_some(),
            _ => match (option::start_speed(part, "start"), option::angle(part, "start")) {
                (Ok(speed), _) => start.speed.replace(speed).is_some(),
                (_, Ok(angle)) => start.angle.replace(angle).is_some(),
                _ => {
                    return Err((
                        format!(
                            "a start is a crank angle, a speed of 0 or more, `equilibrium` or `as drawn`, got `{part}`"
                        ),
                        "write it like \"90 deg, 800 rpm\"".into(),
                    ));
                }
            },
        };
        if twice {
            return Err((
                format!("a start says one thing twice: `{text}`"),
                "give one angle, one speed and one place of the block".into(),
            ));
        }
    }
    Ok(start)
}
