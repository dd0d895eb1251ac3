//! A free balance shaft from a line of text, as the option `--shaft` takes it.

use crate::balance_task::{BalanceTask, FreeShaft, FreeWeight, Place, Seat};
use crate::option::{self, BadQuantity};
use lanchester_model::Ratio;

/// What may be said of a shaft beyond its places.
#[derive(Debug, Default)]
struct Terms {
    optional: bool,
    least: Option<f64>,
    most: Option<f64>,
}

impl BalanceTask {
    /// Adds a shaft: `RATIO @ x, y @ z1, z2`, then `@ optional, least .., most ..` if asked for; a coordinate may be a stretch
    /// `a .. b`. `option` names what asks for it in the message.
    ///
    /// # Errors
    /// [`BadQuantity`] if the text is not of that form, or if a shaft whose place is to be found has no largest unbalance.
    pub fn add_shaft(&mut self, text: &str, option: &str) -> Result<(), BadQuantity> {
        let parts: Vec<&str> = text.split('@').map(str::trim).collect();
        let (ratio, axis, planes, terms) = match parts[..] {
            [ratio, axis, planes] => (ratio, axis, planes, Terms::default()),
            [ratio, axis, planes, terms] => (ratio, axis, planes, self::terms(terms, option)?),
            _ => return Err(wrong(option, &format!("ratio @ x, y @ planes, got `{text}`"))),
        };
        let ratio = ratio_of(ratio)
            .ok_or_else(|| wrong(option, &format!("a ratio such as -1 or 1/2, got `{ratio}`")))?;
        let places =
            |text: &str| text.split(',').map(|part| place(part, option)).collect::<Result<Vec<_>, _>>();
        let axis = places(axis)?;
        let [x, y] = axis[..] else {
            return Err(wrong(option, &format!("the two coordinates x, y of its axis, got {}", axis.len())));
        };
        let planes = places(planes)?;
        let is_found = |place: &Place| matches!(place, Place::Between(..));
        if terms.most.is_none() && (terms.optional || [x, y].iter().chain(&planes).any(is_found)) {
            return Err(BadQuantity {
                message: "a shaft that is optional or whose place is to be found needs the largest unbalance of its weights".into(),
                hint: format!("write it like {option} \"-1 @ 0 mm, 50 mm .. 100 mm @ 0 mm @ optional, most 0.02 kg m\""),
            });
        }
        let taken = |name: &str| self.shafts.iter().any(|shaft| shaft.name == name);
        let name = (1..).map(|number| format!("shaft {number}")).find(|name| !taken(name));
        let name = name.expect("invariant: numbers do not end");
        let seat = Seat::Shaft(self.shafts.len());
        for (number, z) in planes.iter().enumerate() {
            self.weights.push(FreeWeight {
                least: terms.least.unwrap_or(0.0),
                most: terms.most,
                ..FreeWeight::new(format!("{name} {}", number + 1), seat, *z)
            });
        }
        self.shafts.push(FreeShaft { name, ratio, x, y, optional: terms.optional });
        Ok(())
    }
}

/// What a shaft needs, and how it is written.
fn wrong(option: &str, needed: &str) -> BadQuantity {
    BadQuantity {
        message: format!("{option} needs {needed}"),
        hint: format!("write it like {option} \"-1 @ 0 mm, 100 mm @ -40 mm, 40 mm\""),
    }
}

/// A coordinate, or a stretch of it.
fn place(text: &str, option: &str) -> Result<Place, BadQuantity> {
    let Some((low, high)) = text.split_once("..") else {
        return Ok(Place::At(option::length(text.trim(), option)?));
    };
    let (from, to) = (option::length(low.trim(), option)?, option::length(high.trim(), option)?);
    if from < to {
        Ok(Place::Between(from, to))
    } else {
        Err(wrong(option, &format!("a stretch from the smaller to the larger, got `{}`", text.trim())))
    }
}

fn terms(text: &str, option: &str) -> Result<Terms, BadQuantity> {
    let mut terms = Terms::default();
    let amount = |text: &str| option::unbalance(text.trim(), option);
    for term in text.split(',').map(str::trim) {
        if term == "optional" {
            terms.optional = true;
        } else if let Some(most) = term.strip_prefix("most ") {
            terms.most = Some(amount(most)?);
        } else if let Some(least) = term.strip_prefix("least ") {
            terms.least = Some(amount(least)?);
        } else {
            return Err(BadQuantity {
                message: format!("{option} knows optional, least and most, got `{term}`"),
                ..wrong(option, "")
            });
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
