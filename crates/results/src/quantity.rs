//! The quantities that an output can be of, with their names, units and parts.

use serde::{Deserialize, Serialize};

/// What is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Shaking force on the block [N].
    Force,
    /// Shaking couple on the block about the origin [N m].
    Couple,
    /// Roll moment on the block [N m].
    RollMoment,
    /// Torque at crankshaft 1 [N m].
    Torque,
    /// Largest excess energy of the torque over its mean [J].
    ExcessEnergy,
    /// Excess energy over the work of a period [1].
    UnevenTorque,
    /// Fluctuation of the speed within the cycle, `(w_max - w_min)/w_mean` [1].
    SpeedFluctuation,
    /// Force of the journal on a main bearing [N].
    MainBearingLoad,
    /// Force of a rod on its crankpin, or on the knuckle pin of an articulated rod [N].
    CrankpinLoad,
    /// Force of a rod on its piston pin [N].
    PistonPinLoad,
    /// Force of a piston on its cylinder wall [N].
    SideThrust,
    /// Force of the block on a mount [N].
    MountForce,
    /// Largest bending moment along a crankshaft [N m].
    BendingMoment,
    /// Largest difference of a firing interval from the even one [rad].
    UnevenFiring,
    /// Harmonic of the firing pulses over that of pulses that all come together [1].
    FiringHarmonic,
    /// Successive firings of cylinders that stand side by side in one bank.
    NeighbourFirings,
    /// Length of the engine [m].
    Length,
    /// Height of the engine [m].
    Height,
    /// Unbalance of the counterweights [kg m].
    Counterweights,
    /// Number of balance shafts.
    BalanceShafts,
    /// Mass of weights that balancing adds [kg].
    AddedMass,
    /// Unbalance of weights that balancing adds [kg m].
    AddedUnbalance,
    /// Cost of weights and shafts that are used, in the unit of the file.
    Cost,
    /// Inertia of the flywheel that a fluctuation needs [kg m2].
    Flywheel,
    /// Smallest oil film of all main and big-end bearings over the cycle [m].
    LeastFilm,
    /// Smallest oil film of a main bearing over the cycle [m].
    MainFilm,
    /// Smallest oil film of the big-end bearing of a cylinder over the cycle [m].
    CrankpinFilm,
    /// Smallest safety of the fillets and oil bore of a throw by the formulas after IACS UR M53 [1].
    RuleSafety,
    /// Smallest safety against fatigue of the crankshaft's fillets by finite elements [1].
    FilletSafety,
}

/// Of what a quantity can be asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Parts {
    /// Of the engine alone.
    Engine,
    /// Of the engine, along an axis or as a resultant.
    Axes,
    /// Of parts that go by their number.
    Numbered,
    /// Of mounts, which go by name.
    Mounts,
}

/// Name, name as it was or is said too, unit, of what it can be asked, whether it is a load over the cycle.
struct Entry(Quantity, &'static str, &'static [&'static str], &'static str, Parts, bool);

/// Every quantity. Where one name begins another the longer stands first.
const ENTRIES: [Entry; 29] = [
    Entry(Quantity::Force, "force", &[], "N", Parts::Axes, true),
    Entry(Quantity::Couple, "couple", &[], "N m", Parts::Axes, true),
    Entry(Quantity::RollMoment, "roll moment", &[], "N m", Parts::Engine, true),
    Entry(Quantity::Torque, "torque", &[], "N m", Parts::Engine, true),
    Entry(Quantity::ExcessEnergy, "excess energy", &[], "J", Parts::Engine, false),
    Entry(Quantity::UnevenTorque, "uneven torque", &["unevenness of torque"], "", Parts::Engine, false),
    Entry(Quantity::SpeedFluctuation, "speed fluctuation", &[], "", Parts::Engine, false),
    Entry(
        Quantity::MainBearingLoad,
        "main-bearing load",
        &["main bearing load", "main bearing", "main load"],
        "N",
        Parts::Numbered,
        true,
    ),
    Entry(Quantity::CrankpinLoad, "crankpin load", &["crankpin"], "N", Parts::Numbered, true),
    Entry(
        Quantity::PistonPinLoad,
        "piston-pin load",
        &["piston pin load", "piston pin"],
        "N",
        Parts::Numbered,
        true,
    ),
    Entry(Quantity::SideThrust, "side thrust", &[], "N", Parts::Numbered, true),
    Entry(Quantity::MountForce, "mount force", &[], "N", Parts::Mounts, true),
    Entry(Quantity::BendingMoment, "bending moment", &[], "N m", Parts::Numbered, true),
    Entry(Quantity::UnevenFiring, "uneven firing", &["unevenness of firing"], "rad", Parts::Engine, false),
    Entry(Quantity::FiringHarmonic, "firing", &["firing harmonic"], "", Parts::Engine, true),
    Entry(
        Quantity::NeighbourFirings,
        "neighbours",
        &["successive firings of neighbours"],
        "",
        Parts::Engine,
        false,
    ),
    Entry(Quantity::Length, "length", &[], "m", Parts::Engine, false),
    Entry(Quantity::Height, "height", &[], "m", Parts::Engine, false),
    Entry(Quantity::Counterweights, "counterweights", &[], "kg m", Parts::Engine, false),
    Entry(Quantity::BalanceShafts, "shafts", &["balance shafts"], "", Parts::Engine, false),
    Entry(Quantity::AddedMass, "added mass", &[], "kg", Parts::Engine, false),
    Entry(Quantity::AddedUnbalance, "added unbalance", &[], "kg m", Parts::Engine, false),
    Entry(Quantity::Cost, "cost", &[], "unit", Parts::Engine, false),
    Entry(Quantity::Flywheel, "flywheel", &[], "kg m2", Parts::Engine, false),
    Entry(Quantity::LeastFilm, "least film", &["least oil film"], "m", Parts::Engine, false),
    Entry(
        Quantity::MainFilm,
        "main-bearing film",
        &["main bearing film", "main film", "least main-bearing film"],
        "m",
        Parts::Numbered,
        false,
    ),
    Entry(
        Quantity::CrankpinFilm,
        "crankpin film",
        &["big-end film", "least crankpin film"],
        "m",
        Parts::Numbered,
        false,
    ),
    Entry(Quantity::RuleSafety, "rule safety", &["sheet safety"], "", Parts::Numbered, false),
    Entry(Quantity::FilletSafety, "fillet safety", &[], "", Parts::Engine, false),
];

impl Quantity {
    fn entry(self) -> &'static Entry {
        ENTRIES.iter().find(|entry| entry.0 == self).unwrap_or(&ENTRIES[0])
    }

    /// All of them.
    pub fn all() -> impl Iterator<Item = Quantity> {
        ENTRIES.iter().map(|entry| entry.0)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        self.entry().1
    }

    /// Its name for tables, where that is another one.
    pub fn title(self) -> &'static str {
        match self {
            Quantity::UnevenTorque => "unevenness of torque",
            Quantity::UnevenFiring => "unevenness of firing",
            Quantity::FiringHarmonic => "firing harmonic",
            Quantity::NeighbourFirings => "successive firings of neighbours",
            Quantity::BalanceShafts => "balance shafts",
            Quantity::RuleSafety => "safety after UR M53",
            other => other.name(),
        }
    }

    /// Its SI unit; empty for a plain number.
    pub fn unit(self) -> &'static str {
        self.entry().3
    }

    pub(crate) fn parts(self) -> Parts {
        self.entry().4
    }

    /// Whether it runs over the cycle: it has orders, a peak and a mean.
    pub fn is_over_cycle(self) -> bool {
        self.entry().5
    }

    /// Whether more of it is better. Of several parts the one with the smallest then counts; of all others less is better, and the part with
    /// the largest counts.
    pub fn more_is_better(self) -> bool {
        matches!(
            self,
            Quantity::LeastFilm
                | Quantity::MainFilm
                | Quantity::CrankpinFilm
                | Quantity::RuleSafety
                | Quantity::FilletSafety
        )
    }

    /// Whether it turns, so that an order has a part with the crank and one against it.
    pub fn turns(self) -> bool {
        self.parts() == Parts::Axes
    }

    /// The quantity with whose name a text begins, and the rest of the text.
    pub(crate) fn starting(text: &str) -> Option<(Quantity, &str)> {
        let names = ENTRIES
            .iter()
            .flat_map(|entry| std::iter::once(&entry.1).chain(entry.2).map(move |name| (entry.0, *name)));
        let rest = |name: &str| match text.strip_prefix(name)? {
            rest if rest.is_empty() || rest.starts_with(' ') => Some(rest.trim_start()),
            _ => None,
        };
        // The longest name counts: "main bearing load 2" is no "main bearing" called "load 2".
        names
            .filter_map(|(quantity, name)| Some((name.len(), quantity, rest(name)?)))
            .max_by_key(|found| found.0)
            .map(|(_, quantity, rest)| (quantity, rest))
    }
}
