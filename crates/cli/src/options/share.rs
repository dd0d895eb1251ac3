//! The option `--share`: how much of a reference.

use crate::failure::Failure;
use lanchester::task::option;

/// A share above 0: `50 %`, `0.5` or `1/2`.
pub fn share(text: &str) -> Result<f64, Failure> {
    let fraction = text.split_once('/').and_then(|(upper, lower)| {
        let [upper, lower] = [upper, lower].map(|part| part.trim().parse::<f64>());
        Some(upper.ok()? / lower.ok()?)
    });
    let share = match fraction {
        Some(share) => share,
        None => option::share(text, "--share").map_err(Failure::from)?,
    };
    if share.is_finite() && share > 0.0 {
        return Ok(share);
    }
    Err(Failure::input(
        format_args!("--share needs a share above 0, got {}", text.trim()),
        "1/2 compares a twin with half a four",
    ))
}
