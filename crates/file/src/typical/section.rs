//! The sections that can be completed.

use serde::{Deserialize, Serialize};

macro_rules! sections {
    ($($variant:ident $word:literal $doc:literal,)*) => {
        /// A section of the engine file, or a key without which a section says nothing, for which there are typical values.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
        pub enum TypicalSection {
            $(#[doc = $doc] #[serde(rename = $word)] $variant,)*
        }

        impl TypicalSection {
            /// All of them, each behind those that it is scaled from.
            pub const ALL: [TypicalSection; 19] = [$(TypicalSection::$variant,)*];

            /// What the file calls it.
            pub fn word(self) -> &'static str {
                match self { $(TypicalSection::$variant => $word,)* }
            }
        }
    };
}

sections! {
    Bore "piston.bore" "Bores of the cylinders.",
    WebDistance "crank.web_distance" "Distance of the webs of a throw.",
    CounterweightPlanes "counterweights.at" "Half of each weight of the short form on each of its webs.",
    CrankBody "crank.body" "The crankshaft as a body.",
    CrankMaterial "crank.material" "Its material.",
    Gas "gas" "An ideal cycle.",
    Friction "friction" "Chen and Flynn's form.",
    Flywheel "flywheel" "The flywheel.",
    Bearings "bearings" "Sizes, clearances and oil of the bearings.",
    Block "block" "Mass and inertia of the engine.",
    Mounts "mount" "Four mounts under it, or the stiffness of those that are there.",
    Tolerances "tolerances" "What the parts of a production may be off.",
    Balance "balance" "Weights that are free.",
    CounterweightDesign "counterweight_design" "Ranges of the shapes of counterweights.",
    Clearance "clearance" "What the crankshaft must stay clear of.",
    ShaftWeightDesign "shaft_weight_design" "Ranges of the shapes of weights on balance shafts.",
    Torsion "torsion" "Damping of torsional vibration.",
    Damper "damper" "A damper of torsional vibration.",
    Simulation "simulation" "A run in time.",
}

impl TypicalSection {
    /// The section of this word.
    pub fn of_word(word: &str) -> Option<TypicalSection> {
        TypicalSection::ALL.into_iter().find(|section| section.word() == word)
    }
}

impl std::fmt::Display for TypicalSection {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.word())
    }
}
