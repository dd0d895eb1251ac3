//! What a computation on a mesh says before it is done.

use crate::files::tell;
use lanchester::StressStage;
/// Says on standard error what will be solved, before it is.
pub(crate) fn say(stage: StressStage) {
    match stage {
        StressStage::Meshed(nodes, elements) => {
            tell(format_args!("meshed: {nodes} nodes, {elements} elements"))
        }
        StressStage::Factoring(estimate) => tell(format_args!(
            "factoring: {} unknowns, {} entries in the matrix, {} in the factor, {:.2} GiB, {:.1e} operations (some {:.0} s)",
            estimate.unknowns,
            estimate.nonzeros,
            estimate.factor_entries,
            estimate.bytes as f64 / 1_073_741_824.0,
            estimate.operations,
            estimate.seconds().ceil(),
        )),
    }
}
