//! A layout as an engine with its balance shafts.

use crate::explore::kernel::Block;
use crate::explore::layout::Layout;
use crate::explore::parts::Parts;
use crate::explore::shaft_set::ShaftSet;
use lanchester_model::{BalanceShaft, Engine};

impl Layout {
    /// The layout as an engine. Its loads are those of the search to rounding.
    pub fn engine(&self, parts: &Parts) -> Result<Engine, lanchester_mechanism::LoadError> {
        let shafts = self.shafts(parts)?;
        let engine = self.bare_engine(parts).with(|engine| engine.shafts = shafts);
        Ok(engine.expect("invariant: shafts that are found have finite weights and names of their own"))
    }

    /// Its balance shafts.
    fn shafts(&self, parts: &Parts) -> Result<Vec<BalanceShaft>, lanchester_mechanism::LoadError> {
        if self.shafts.shafts.is_empty() {
            return Ok(Vec::new());
        }
        let bare = Layout { shafts: ShaftSet::default(), ..self.clone() };
        let mut orders = Block::of_layout(parts, &bare)?;
        let shafts = self.shafts.shafts.iter().enumerate().map(|(index, design)| {
            let shaft = design.shaft(&orders, parts.speed, format!("shaft {}", index + 1));
            design.add_to(&mut orders);
            shaft
        });
        Ok(shafts.collect())
    }
}
