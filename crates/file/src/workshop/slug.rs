//! Weights outside that are to come off, and slugs that may take their place.

use crate::document::Section;
use crate::read::Reader;
use lanchester_task::workshop::{External, SlugRoom};

/// Density of steel [kg/m^3], as forged cranks are (EN 10083 steels: 7.85).
const STEEL: f64 = 7850.0;
/// Least land [m] and sector [rad] where the sheet says nothing.
const LAND: f64 = 0.003;
const SECTOR: f64 = std::f64::consts::FRAC_PI_2;

impl<'a> Reader<'a> {
    pub(super) fn externals(&mut self) -> Option<Vec<External>> {
        let sections = self.root.tables("external").or(&[])?;
        let externals: Vec<Option<External>> =
            sections.iter().map(|section| self.external(section)).collect();
        externals.into_iter().collect()
    }

    fn external(&mut self, section: &'a Section) -> Option<External> {
        let name = self.required(section, "name", section.text("name"));
        let [z, angle] = ["z", "angle"].map(|key| self.required(section, key, section.number(key)));
        let unbalance = self.weight_unbalance(section);
        Some(External { name: name?, z: z?, unbalance: unbalance?, angle: angle? })
    }

    /// The slugs; the inner `None` where the file has none.
    pub(super) fn slug_room(&mut self) -> Option<Option<SlugRoom>> {
        let (section, broken) = self.section("slug");
        let Some(section) = section else { return (!broken).then_some(None) };
        let [diameter, longest, density, rim] = ["diameter", "longest", "density", "rim"]
            .map(|key| self.required(section, key, section.number(key)));
        let crank_density = section.number("crank_density").or(STEEL);
        let land = section.number("land").or(LAND);
        let sector = section.number("sector").or(SECTOR);
        Some(Some(SlugRoom {
            diameter: diameter?,
            longest: longest?,
            density: density?,
            crank_density: crank_density?,
            land: land?,
            rim: rim?,
            sector: sector?,
        }))
    }
}
