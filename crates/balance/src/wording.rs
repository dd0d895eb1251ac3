//! Names and units of criteria, for tables and reasons.

use lanchester_model::{Criterion, Load};

/// How a criterion is called, and its unit.
pub trait Wording {
    /// Name for tables: "peak force", "order 2 of the couple".
    fn name(&self) -> String;
    /// SI unit.
    fn unit(&self) -> &'static str;
}

impl Wording for Load {
    fn name(&self) -> String {
        match self {
            Load::Force => "force".into(),
            Load::ForceX => "force along x".into(),
            Load::ForceY => "force along y".into(),
            Load::Couple => "couple".into(),
            Load::CoupleX => "couple about x".into(),
            Load::CoupleY => "couple about y".into(),
            Load::RollMoment => "roll moment".into(),
            Load::MountForce(index) => format!("force at mount {}", index + 1),
            Load::LargestMountForce => "largest mount force".into(),
            Load::BendingMoment => "bending moment".into(),
        }
    }

    fn unit(&self) -> &'static str {
        match self {
            Load::Force | Load::ForceX | Load::ForceY | Load::MountForce(_) | Load::LargestMountForce => "N",
            Load::Couple | Load::CoupleX | Load::CoupleY | Load::RollMoment | Load::BendingMoment => "N m",
        }
    }
}

impl Wording for Criterion {
    fn name(&self) -> String {
        match self {
            Criterion::Peak(load) => format!("peak {}", load.name()),
            Criterion::Order(load, order) => format!("order {order} of the {}", load.name()),
            Criterion::AddedMass => "added mass".into(),
            Criterion::AddedUnbalance => "added unbalance".into(),
        }
    }

    fn unit(&self) -> &'static str {
        match self {
            Criterion::Peak(load) | Criterion::Order(load, _) => load.unit(),
            Criterion::AddedMass => "kg",
            Criterion::AddedUnbalance => "kg m",
        }
    }
}
