//! A free balance shaft from the option `--shaft`.

use crate::failure::Failure;
use lanchester::model::option;
use lanchester::model::{BalanceTask, FreeShaft, FreeWeight, Place, Ratio, Seat};

/// What may be said of a shaft beyond its places.
#[derive(Debug, Default)]
struct Terms {
    optional: bool,
    least: Option<f64>,
    most: Option<f64>,
}

/// `RATIO @ x, y @ z1, z2`, then `@ optional, least .., most ..` if asked for; a coordinate may be a stretch `a .. b`.
pub fn add_shaft(task: &mut BalanceTask, text: &str) -> Result<(), Failure> {
    let parts: Vec<&str> = text.split('@').map(str::trim).collect();
    let (ratio, axis, planes, terms) = match parts[..] {
        [ratio, axis, planes] => (ratio, axis, planes, Terms::default()),
        [ratio, axis, planes, terms] => (ratio, axis, planes, self::terms(terms)?),
        _ => return Err(wrong(format!("--shaft needs ratio @ x, y @ planes, got `{text}`"))),
    };
    let ratio = ratio_of(ratio)
        .ok_or_else(|| wrong(format!("--shaft needs a ratio such as -1 or 1/2, got `{ratio}`")))?;
    let axis: Vec<Place> = axis.split(',').map(place).collect::<Result<_, _>>()?;
    let [x, y] = axis[..] else {
        return Err(wrong(format!("--shaft needs the two coordinates x, y of its axis, got {}", axis.len())));
    };
    let planes: Vec<Place> = planes.split(',').map(place).collect::<Result<_, _>>()?;
    let is_found = |place: &Place| matches!(place, Place::Between(..));
    if terms.most.is_none() && (terms.optional || [x, y].iter().chain(&planes).any(is_found)) {
        return Err(Failure::input(
            "a shaft that is optional or whose place is to be found needs the largest unbalance of its weights",
            "write it like --shaft \"-1 @ 0 mm, 50 mm .. 100 mm @ 0 mm @ optional, most 0.02 kg m\"",
        ));
    }
    let taken = |name: &str| task.shafts.iter().any(|s| s.name == name);
    let name =
        (1..).map(|n| format!("shaft {n}")).find(|name| !taken(name)).expect("invariant: numbers do not end");
    let seat = Seat::Shaft(task.shafts.len());
    for (k, z) in planes.iter().enumerate() {
        task.weights.push(FreeWeight {
            least: terms.least.unwrap_or(0.0),
            most: terms.most,
            ..FreeWeight::new(format!("{name} {}", k + 1), seat, *z)
        });
    }
    task.shafts.push(FreeShaft { name, ratio, x, y, optional: terms.optional });
    Ok(())
}

fn wrong(what: String) -> Failure {
    Failure::input(what, "write it like --shaft \"-1 @ 0 mm, 100 mm @ -40 mm, 40 mm\"")
}

/// A coordinate, or a stretch of it.
fn place(text: &str) -> Result<Place, Failure> {
    let length = |text: &str| option::length(text.trim(), "--shaft").map_err(Failure::from);
    let Some((low, high)) = text.split_once("..") else { return Ok(Place::At(length(text)?)) };
    let (from, to) = (length(low)?, length(high)?);
    if from < to {
        Ok(Place::Between(from, to))
    } else {
        Err(wrong(format!("--shaft needs a stretch from the smaller to the larger, got `{}`", text.trim())))
    }
}

fn terms(text: &str) -> Result<Terms, Failure> {
    let mut terms = Terms::default();
    let amount = |text: &str| option::unbalance(text.trim(), "--shaft").map_err(Failure::from);
    for term in text.split(',').map(str::trim) {
        if term == "optional" {
            terms.optional = true;
        } else if let Some(most) = term.strip_prefix("most ") {
            terms.most = Some(amount(most)?);
        } else if let Some(least) = term.strip_prefix("least ") {
            terms.least = Some(amount(least)?);
        } else {
            return Err(wrong(format!("--shaft knows optional, least and most, got `{term}`")));
        }
    }
    Ok(terms)
}

fn ratio_of(text: &str) -> Option<Ratio> {
    match text.split_once('/') {
        Some((numerator, denominator)) => {
            Ratio::new(numerator.trim().parse().ok()?, denominator.trim().parse().ok()?)
        }
        None => Ratio::whole(text.trim_start_matches('+').parse().ok()?),
    }
}
