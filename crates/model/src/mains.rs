//! Where the main bearings of a crankshaft stand.

use crate::engine::{Engine, Throw};

/// Without webs in the file: throws closer than this many crank radii leave no room for two webs and a main bearing
/// between them.
const CLOSEST: f64 = 1.25;

/// Where the file gives webs: facing webs of two throws closer than this share of the web distance are one web, or
/// leave no room for a main bearing, which is about as long as a pin.
const NARROWEST: f64 = 0.5;

impl Engine {
    /// Planes of the main bearings of crankshaft `crankshaft` [m], rising, at least two; empty for a crankshaft without
    /// throws.
    ///
    /// Those that the file gives, or else the usual ones: one midway between neighbouring throws, and one at each end,
    /// as far beyond the last throw as the next main is before it. Throws with no room for a main between them (pins
    /// of a split pair, of a boxer with one web between two pins) count as one: their facing webs are closer than half a
    /// web distance or, where the file gives no webs, the throws are closer than 1.25 crank radii. The mains beside a lone throw stand one web distance
    /// from it, or 1.25 crank radii where the file gives no webs.
    pub fn main_planes(&self, crankshaft: usize) -> Vec<f64> {
        if let Some(mains) = self.crankshafts.get(crankshaft).and_then(|c| c.mains.as_ref()) {
            return mains.clone();
        }
        let mut throws: Vec<&Throw> = self.throws.iter().filter(|t| t.crankshaft == crankshaft).collect();
        throws.sort_by(|a, b| a.z.total_cmp(&b.z));
        let (Some(first), Some(last)) = (throws.first(), throws.last()) else { return Vec::new() };
        let gaps: Vec<[&Throw; 2]> =
            throws.windows(2).map(|pair| [pair[0], pair[1]]).filter(|[a, b]| has_room(a, b)).collect();
        let inner: Vec<f64> = gaps.iter().map(|[a, b]| 0.5 * (a.z + b.z)).collect();
        let [front, rear] = match (gaps.first(), gaps.last()) {
            (Some([front, _]), Some([_, rear])) => {
                // The end throws stand in the middle between their mains.
                [first.z + front.z - inner[0], rear.z + last.z - inner[inner.len() - 1]]
            }
            _ => [first.z - reach(first), last.z + reach(last)],
        };
        std::iter::once(front).chain(inner).chain([rear]).collect()
    }

    /// Crankshaft (from 0) and plane [m] of every main bearing: those of crankshaft 1 first, each from the free end on.
    pub fn main_bearings(&self) -> Vec<(usize, f64)> {
        let of = |crankshaft: usize| self.main_planes(crankshaft).into_iter().map(move |z| (crankshaft, z));
        (0..self.crankshafts.len()).flat_map(of).collect()
    }
}

/// Distance of the mains from a throw that has no neighbours [m].
fn reach(throw: &Throw) -> f64 {
    throw.webs.map_or(CLOSEST * throw.radius, |[front, rear]| rear - front)
}

/// Whether a main bearing may stand between two neighbouring throws.
fn has_room(front: &Throw, rear: &Throw) -> bool {
    match (front.webs, rear.webs) {
        (Some([start, end]), Some([next, next_end])) => {
            next - end >= NARROWEST * (end - start).max(next_end - next)
        }
        _ => rear.z - front.z > CLOSEST * front.radius.max(rear.radius),
    }
}

#[cfg(test)]
mod tests {
    use crate::{expanded, read};

    /// Mains of the first crankshaft [mm], to the micrometre.
    fn mains(crank: &str) -> Vec<f64> {
        let text = format!(
            "name = \"x\"\nspeed = \"3000 rpm\"\n[piston]\nmass = \"0.5 kg\"\n[rod]\nlength = \"150 mm\"\nmass = \
             \"0.6 kg\"\n{crank}"
        );
        let reading = read(&text);
        let engine = reading.engine.unwrap_or_else(|| panic!("{:?}", reading.diagnostics));
        assert_eq!(read(&expanded(&engine)).engine.as_ref(), Some(&engine), "written out and read again");
        engine.main_planes(0).into_iter().map(|z| (1e6 * z).round() / 1e3).collect()
    }

    fn four(crank: &str) -> Vec<f64> {
        mains(&format!(
            "[firing]\norder = [1, 3, 4, 2]\n[layout]\ntype = \"in-line\"\ncylinders = 4\nspacing = \"90 mm\"\n\
             [crank]\nstroke = \"80 mm\"\n{crank}"
        ))
    }

    #[test]
    fn a_main_stands_between_any_two_throws_and_at_the_ends() {
        assert_eq!(four(""), [-180.0, -90.0, 0.0, 90.0, 180.0]);
        assert_eq!(four("web_distance = \"45 mm\""), [-180.0, -90.0, 0.0, 90.0, 180.0]);
    }

    #[test]
    fn the_file_may_place_them() {
        assert_eq!(four("main_positions = [\"-180 mm\", \"5 mm\", \"170 mm\"]"), [-180.0, 5.0, 170.0]);
    }

    #[test]
    fn a_lone_throw_stands_between_two() {
        let single = "[layout]\ntype = \"in-line\"\ncylinders = 1\ncrank_angles = [\"0 deg\"]\n[crank]\nstroke = \"80 mm\"\n";
        assert_eq!(mains(single), [-50.0, 50.0]);
        assert_eq!(mains(&format!("{single}web_distance = \"36 mm\"")), [-36.0, 36.0]);
    }

    #[test]
    fn split_pins_share_their_mains() {
        let six = "[layout]\ncrank_angles = [\"0 deg\", \"240 deg\", \"120 deg\"]\ntype = \"v\"\ncylinders = 6\nspacing = \"100 mm\"\n\
                   bank_angle = \"60 deg\"\nbank_stagger = \"0 mm\"\npins = \"split\"\nsplit_angle = \"60 deg\"\n[crank]\nstroke = \"80 mm\"\n";
        assert_eq!(mains(six), [-150.0, -50.0, 50.0, 150.0]);
        let staggered = six.replace("stagger = \"0 mm\"", "stagger = \"20 mm\"");
        assert_eq!(mains(&staggered), [-150.0, -50.0, 50.0, 150.0]);
    }

    #[test]
    fn a_boxer_has_a_main_in_a_pair_only_where_there_is_room() {
        let boxer = |stagger: &str, crank: &str| {
            mains(&format!(
                "[layout]\ntype = \"boxer\"\ncylinders = 4\nspacing = \"110 mm\"\n\
                 bank_stagger = \"{stagger} mm\"\ncrank_angles = [\"0 deg\", \"180 deg\"]\n[crank]\nstroke = \"76 mm\"\n{crank}"
            ))
        };
        assert_eq!(boxer("40", ""), [-110.0, 0.0, 110.0]);
        assert_eq!(boxer("55", ""), [-110.0, -55.0, 0.0, 55.0, 110.0]);
        // Webs 26 mm apart leave room at 40 mm; webs as far apart as the pins are one web between them.
        assert_eq!(boxer("40", "web_distance = \"26 mm\""), [-95.0, -55.0, 0.0, 55.0, 95.0]);
        assert_eq!(boxer("40", "web_distance = \"28 mm\""), [-110.0, 0.0, 110.0]);
        assert_eq!(boxer("40", "web_distance = \"40 mm\""), [-110.0, 0.0, 110.0]);
    }
}
