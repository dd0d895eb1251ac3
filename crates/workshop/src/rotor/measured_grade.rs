//! The balance quality grade of a sheet, against what its own measurements tell.

use crate::error::WorkshopError;
use crate::rotor::correction::correction;
use crate::rotor::displayed::displayed;
use crate::rotor::grade::{Grade, of_unbalances};
use lanchester_task::workshop::Sheet;

/// What the grade of the sheet allows, and whether the measured unbalance keeps it: the displayed one, or that which the
/// runs show in the planes with trial weights. Runs that do not tell it yet leave it unmeasured; [`correction`]
/// says why.
///
/// # Errors
/// [`WorkshopError::Missing`] if the sheet gives no mass, service speed or grade.
/// # Source
/// `[Iso21940]` part 11; book, "Balance quality grades".
pub fn grade(sheet: &Sheet) -> Result<Grade, WorkshopError> {
    if !sheet.runs.is_empty() {
        let from_runs = correction(sheet).ok().and_then(|found| found.grade_now);
        return from_runs.map_or_else(|| of_unbalances(sheet, None), Ok);
    }
    let measured = displayed(&sheet.displays);
    of_unbalances(sheet, (!measured.is_empty()).then_some(measured.as_slice()))
}

#[cfg(test)]
mod tests;
