//! What other weights do to an engine, with the masses of counterweights where they are known.

use crate::inertias::with_known_rotors;
use lanchester_balance::{BalanceError, Consequences, consequences as of_masses};
use lanchester_geometry::counterweight_properties;
use lanchester_model::{Counterweight, Engine};
use lanchester_task::{BalanceTask, Seat};

/// What the weights of `after` do, which is the engine `before` with other counterweights and balance shafts.
///
/// The mass of a counterweight is that of its part beyond the plain web; without a part, its unbalance over the radius that `task` gives
/// the weight of its name.
///
/// # Errors
/// As [`lanchester_balance::consequences`].
///
/// # Example
/// ```
/// use lanchester::balance::Affected;
/// use lanchester::file::{read, template};
///
/// let four = read(template("in-line-4").expect("it is in the gallery").text).engine().expect("no mistakes");
/// let bare = four.without_counterweights();
/// let found = lanchester::consequences(&four, &bare, None)?;
/// // Force and couple do not see the counterweights of a four; its middle main bearing does.
/// assert!(found.worse().all(|row| row.quantity != Affected::Force && row.quantity != Affected::Couple));
/// assert!(found.worse().any(|row| row.quantity == Affected::MainLoadPeak));
/// assert_eq!(found.dropped.len(), 8);
/// # Ok::<(), lanchester::balance::BalanceError>(())
/// ```
pub fn consequences(
    before: &Engine,
    after: &Engine,
    task: Option<&BalanceTask>,
) -> Result<Consequences, BalanceError> {
    let (before, after) = (with_known_rotors(before), with_known_rotors(after));
    of_masses(&before, &after, |engine, weight| mass(engine, weight, task))
}

fn mass(engine: &Engine, weight: &Counterweight, task: Option<&BalanceTask>) -> Option<f64> {
    if let Some(part) = &weight.part {
        return counterweight_properties(engine, part).ok().map(|properties| properties.mass);
    }
    let mut free = task?.weights.iter();
    let own =
        free.find(|free| free.seat == Seat::Crankshaft(weight.crankshaft) && free.name == weight.name)?;
    own.radius.map(|radius| weight.unbalance / radius)
}
