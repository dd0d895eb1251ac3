//! The choices that make a layout.

use serde::Serialize;

/// One of the choices that make a layout, in the order of the digits of a case number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Choice {
    /// Distance of neighbouring groups.
    Spacing,
    /// Angle between the banks.
    BankAngle,
    /// Split (offset) pins.
    SplitAngle,
    /// Bank 2 behind bank 1.
    Stagger,
    /// Crank radius over rod length.
    RodRatio,
    /// Weights on the webs.
    Counterweights,
    /// Balance shafts.
    Shafts,
    /// Angles of the throws.
    ThrowAngles,
    /// Firing orders.
    Firing,
}

impl Choice {
    /// All choices, the slowest digit first.
    pub const ALL: [Choice; 9] = [
        Choice::Spacing,
        Choice::BankAngle,
        Choice::SplitAngle,
        Choice::Stagger,
        Choice::RodRatio,
        Choice::Counterweights,
        Choice::Shafts,
        Choice::ThrowAngles,
        Choice::Firing,
    ];

    /// Name for messages and tables.
    pub fn name(self) -> &'static str {
        match self {
            Choice::Spacing => "the list of spacings",
            Choice::BankAngle => "the list of bank angles",
            Choice::SplitAngle => "the list of split angles",
            Choice::Stagger => "the list of bank staggers",
            Choice::RodRatio => "the list of rod ratios",
            Choice::Counterweights => "the list of counterweight patterns",
            Choice::Shafts => "the list of shaft sets",
            Choice::ThrowAngles => "the list of throw angles",
            Choice::Firing => "the choice of firing orders",
        }
    }
}
