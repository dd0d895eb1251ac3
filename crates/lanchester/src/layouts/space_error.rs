//! Why an engine gives no space of layouts.

use lanchester_study::explore::ExploreError;
use std::fmt;

/// Why an engine gives no space of layouts.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LayoutSpaceError {
    /// The engine is not one bank, or two alike, on one crankshaft, and its throws cannot be permuted as they are either.
    #[error(
        "a search permutes layouts of one bank, or of two alike, on one crankshaft, or the throws of other engines; {engine} has none \
         of them: {reason}"
    )]
    Banks {
        /// Name of the engine.
        engine: String,
        /// What it is instead.
        reason: String,
    },
    /// A choice of sizes that the layouts of this engine share.
    #[error(
        "layouts of {engine} keep its cylinders, rods and pins, since {reason}: {choice} cannot be chosen"
    )]
    Kept {
        /// Name of the engine.
        engine: String,
        /// Why they keep them.
        reason: String,
        /// The choice.
        choice: &'static str,
    },
    /// Nothing changes the loads of an engine whose throws turn as one.
    #[error("{throws}: nothing to permute; {engine} has the same loads in every firing order")]
    OneThrow {
        /// "one throw", or how several are one.
        throws: &'static str,
        /// Name of the engine.
        engine: String,
    },
    /// A size that the file does not give.
    #[error("{size} is not known from {engine}")]
    Missing {
        /// Which size.
        size: LayoutSize,
        /// Name of the engine.
        engine: String,
    },
    /// One bank is asked for, and with it what only two banks have.
    #[error("an in-line engine has no bank angle, split pins or stagger")]
    InLineWithBanks,
    /// Split pins or a stagger of an engine with one bank.
    #[error("split pins and stagger need two banks, and the engine has one")]
    OneBank,
    /// The search is refused.
    #[error(transparent)]
    Explore(#[from] ExploreError),
}

/// A size without which a search cannot begin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LayoutSize {
    /// Distance of neighbouring cylinders along the crank.
    Spacing,
    /// Distance of the outer web planes of a group.
    WebDistance,
    /// Thickness of a web.
    WebThickness,
    /// Diameter of a crankpin.
    PinDiameter,
}

impl fmt::Display for LayoutSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            LayoutSize::Spacing => "the distance of neighbouring cylinders",
            LayoutSize::WebDistance => "the distance of the webs",
            LayoutSize::WebThickness => "the thickness of the webs",
            LayoutSize::PinDiameter => "the diameter of the crankpins",
        })
    }
}
