//! Loads of the main bearings of one rotor at one instant, by all rules, in one piece of memory: a run with every reaction keeps one at every sample.

use serde::ser::{Serialize, SerializeSeq, Serializer};
use std::ops::Index;

/// How many rules there are.
const RULES: usize = crate::main_rules::MainRule::ALL.len();

/// Journals on the main bearings: `x`, `y` [N], by rule ([`crate::MainRule::ALL`]) and main. Indexed by the rule, it is the mains of that rule.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MainLoads {
    /// Rule after rule.
    loads: Vec<[f64; 2]>,
}

impl MainLoads {
    /// From the loads of all mains by one rule after the other.
    pub(crate) fn new(loads: Vec<[f64; 2]>) -> MainLoads {
        debug_assert!(loads.len().is_multiple_of(RULES), "as many mains by every rule");
        MainLoads { loads }
    }

    /// Mains of one rule after the other.
    pub fn iter(&self) -> impl Iterator<Item = &[[f64; 2]]> {
        (0..RULES).map(|rule| &self[rule])
    }
}

impl Index<usize> for MainLoads {
    type Output = [[f64; 2]];

    fn index(&self, rule: usize) -> &[[f64; 2]] {
        let mains = self.loads.len() / RULES;
        &self.loads[rule * mains..(rule + 1) * mains]
    }
}

impl Serialize for MainLoads {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut all = serializer.serialize_seq(Some(RULES))?;
        for rule in self.iter() {
            all.serialize_element(rule)?;
        }
        all.end()
    }
}
