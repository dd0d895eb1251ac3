//! What a computation on a mesh says before it is done.

use crate::files::tell;
use lanchester::StressStage;
use lanchester::flex::bytes_words;
use lanchester::flex::sparse::{Precision, make_product};
use std::time::Instant;

/// How many products are timed; the fastest counts.
const PRODUCTS: usize = 4;

/// Says on standard error what will be solved, before it is.
pub(crate) fn say(stage: StressStage) {
    match stage {
        StressStage::Meshed(nodes, elements) => {
            tell(format_args!("meshed: {nodes} nodes, {elements} elements"))
        }
        StressStage::Factoring(estimate) => tell(format_args!(
            "factoring: {} unknowns, {} entries in the matrix, {} in the factor, {}, {:.1e} operations (some {:.0} s)",
            estimate.unknowns,
            estimate.nonzeros,
            estimate.factor_entries,
            bytes_words(estimate.bytes),
            estimate.operations,
            estimate.seconds(product_rate(estimate.precision)).ceil(),
        )),
    }
}

/// Operations a second of a product of matrices on this machine.
fn product_rate(precision: Precision) -> f64 {
    let rate = |_| {
        let start = Instant::now();
        make_product(precision) / start.elapsed().as_secs_f64().max(f64::MIN_POSITIVE)
    };
    (0..PRODUCTS).map(rate).fold(f64::MIN_POSITIVE, f64::max)
}
