//! How fine a crankshaft is meshed.

use crate::FlexError;
use serde::Serialize;

/// How fine a crankshaft is meshed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankMeshOptions {
    /// Edge of the elements away from fillets [m].
    pub size: f64,
    /// Elements across the 90 degrees of a fillet: an even number, at least 2.
    pub fillet_elements: usize,
    /// Whether fillets are meshed; without them their corners are sharp, which is enough for stiffness.
    pub fillets: bool,
}

impl Default for CrankMeshOptions {
    fn default() -> CrankMeshOptions {
        CrankMeshOptions { size: 8e-3, fillet_elements: 6, fillets: true }
    }
}

/// Refuses sizes that are none.
pub(super) fn check_options(options: CrankMeshOptions) -> Result<(), FlexError> {
    let refuse = |quantity: &str, needed: &str, got| {
        let hint = "8 mm and 6 elements are usual";
        Err(FlexError::Number { quantity: quantity.to_owned(), needed: needed.to_owned(), got, hint })
    };
    if !(1e-4..=1.0).contains(&options.size) {
        return refuse("size of the elements [m]", "between 0.0001 and 1", options.size);
    }
    let count = options.fillet_elements;
    if !(2..=40).contains(&count) || count % 2 == 1 {
        return refuse("elements across a fillet", "an even number from 2 to 40", count as f64);
    }
    Ok(())
}
