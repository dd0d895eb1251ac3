//! Places of an engine's graph: a tile for the block and one for every cylinder, rotor and mount.
//!
//! A body follows up to seven flows of block and crank, so that lines to all of them would hide everything. Within a tile bonds are drawn;
//! a bond to another tile is a short one with the name of what stands at its other end. Tiles of cylinders are alike.

use crate::graph::Graph;
use std::collections::BTreeMap;

/// Distances within a tile: columns, rows, short bonds to other tiles.
const COLUMN: f64 = 118.0;
const ROW: f64 = 58.0;
const STUB: f64 = 66.0;
const STUBS: f64 = 14.0;
/// Space around tiles, and the width from which the next shelf begins.
const GAP: f64 = 24.0;
const WIDEST: f64 = 2300.0;
/// Room for the names at short bonds.
const LABEL: f64 = 72.0;
/// Height of a tile's title.
const TITLE: f64 = 34.0;

/// A rectangle with the title of what is in it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tile {
    pub(crate) title: String,
    pub(crate) corner: [f64; 2],
    pub(crate) size: [f64; 2],
}

/// Elements in tiles, and bonds that lead out of theirs.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tiled {
    pub(crate) places: Vec<[f64; 2]>,
    pub(crate) tiles: Vec<Tile>,
    /// Of each bond that leads to another tile: the element at which it is drawn, where its far end is, and the name that stands there.
    pub(crate) stubs: BTreeMap<usize, (usize, [f64; 2], String)>,
}

/// What a tile holds; the order is that of the drawing.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Group {
    Block,
    Cylinder(usize),
    Rotor(String),
    Driveline,
    Mount(usize),
    Surroundings,
}

impl Group {
    /// By the names that [`crate::engine_graph`] gives.
    fn of(name: &str) -> Group {
        let digits = |text: &str| -> Option<usize> {
            let end = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
            (text[end..].is_empty() || text[end..].starts_with('_')).then(|| text[..end].parse().ok())?
        };
        let numbered = |stem: &str| name.strip_prefix(stem).and_then(digits);
        const OF_CYLINDERS: [&str; 26] = [
            "piston",
            "piston_turn",
            "crankpin",
            "pin",
            "contact",
            "lateral",
            "tilt",
            "rod_turn",
            "rod_axis_motion",
            "rod_axis",
            "rod_normal",
            "rod_about",
            "rod_gyro",
            "rod",
            "slide",
            "stroke",
            "gas",
            "skirt",
            "bore",
            "mass",
            "heat",
            "intake",
            "exhaust",
            "combustion",
            "wall",
            "cooling",
        ];
        if let Some(number) = OF_CYLINDERS.iter().chain(&["crankcase"]).find_map(|stem| numbered(stem)) {
            return Group::Cylinder(number);
        }
        if let Some(number) = numbered("mount") {
            return Group::Mount(number);
        }
        if numbered("link").or(numbered("driveline")).is_some() || name == "clutch" {
            return Group::Driveline;
        }
        let rotor = name.split('_').next().unwrap_or(name);
        if (rotor.starts_with("shaft") || rotor.starts_with("crankshaft")) && name != "crankshaft" {
            return Group::Rotor(rotor.to_owned());
        }
        let around = ["intake_", "exhaust_", "crown_", "head_", "liner_", "ambient", "body", "loss"];
        if around.iter().any(|stem| name.starts_with(stem)) {
            return Group::Surroundings;
        }
        Group::Block
    }

    fn title(&self) -> String {
        match self {
            Group::Block => "Block and crank".into(),
            Group::Cylinder(number) => format!("Cylinder {number}"),
            Group::Rotor(name) if name.starts_with("shaft") => {
                format!("Balance {}", name.replace("shaft", "shaft "))
            }
            Group::Rotor(_) => "Unbalance of the crankshaft".into(),
            Group::Driveline => "Driveline".into(),
            Group::Mount(number) => format!("Mount {number}"),
            Group::Surroundings => "Surroundings of the gas".into(),
        }
    }
}

/// Tiles of a graph that has the crank and the cylinders of an engine; none for any other.
pub(crate) fn tiled(graph: &Graph) -> Option<Tiled> {
    let groups: Vec<Group> = graph.elements.iter().map(|element| Group::of(&element.name)).collect();
    let has_crank = graph.elements.iter().any(|element| element.name == "crank" && element.is_junction());
    if !has_crank || !groups.iter().any(|group| matches!(group, Group::Cylinder(_))) {
        return None;
    }
    let mut tiled = Tiled { places: vec![[0.0; 2]; graph.elements.len()], ..Tiled::default() };
    let mut members: BTreeMap<Group, Vec<usize>> = BTreeMap::new();
    for (element, group) in groups.iter().enumerate() {
        members.entry(group.clone()).or_default().push(element);
    }
    // Where each bond to another tile is drawn: at the part, not at the junction that many share.
    let mut stubs: Vec<Vec<usize>> = vec![Vec::new(); graph.elements.len()];
    for (index, bond) in graph.bonds.iter().enumerate() {
        let (from, to) = (&groups[bond.from], &groups[bond.to]);
        if from != to {
            let shared = |group: &Group| matches!(group, Group::Block | Group::Surroundings);
            stubs[if shared(to) && !shared(from) { bond.from } else { bond.to }].push(index);
        }
    }
    let (mut corner, mut shelf) = ([GAP, 60.0], 0.0f64);
    for (group, elements) in &members {
        let size = tree(graph, &groups, elements, &stubs, &mut tiled.places);
        if corner[0] > GAP && corner[0] + size[0] > WIDEST {
            corner = [GAP, corner[1] + shelf + GAP];
            shelf = 0.0;
        }
        for element in elements {
            let place = &mut tiled.places[*element];
            *place = [place[0] + corner[0], place[1] + corner[1]];
        }
        tiled.tiles.push(Tile { title: group.title(), corner, size });
        shelf = shelf.max(size[1]);
        corner[0] += size[0] + GAP;
    }
    for (element, own) in stubs.iter().enumerate() {
        let [x, y] = tiled.places[element];
        for (place, bond) in own.iter().enumerate() {
            let ends = &graph.bonds[*bond];
            let far = if ends.from == element { ends.to } else { ends.from };
            let down = STUBS * (place as f64 - (own.len() as f64 - 1.0) / 2.0);
            let name = graph.elements[far].name.clone();
            tiled.stubs.insert(*bond, (element, [x - STUB, y + down], name));
        }
    }
    Some(tiled)
}

/// Places the elements of one tile from its corner: what leads to other tiles at the left, what hangs on it to the right. Gives the size.
fn tree(
    graph: &Graph,
    groups: &[Group],
    elements: &[usize],
    stubs: &[Vec<usize>],
    places: &mut [[f64; 2]],
) -> [f64; 2] {
    let mut seen = vec![false; graph.elements.len()];
    let mut roots: Vec<usize> =
        elements.iter().copied().filter(|element| !stubs[*element].is_empty()).collect();
    roots.extend(elements.iter().copied().filter(|element| graph.elements[*element].is_junction()));
    roots.extend(elements);
    let (mut row, mut deepest) = (0.0f64, 0usize);
    for root in roots {
        if seen[root] {
            continue;
        }
        let first = row;
        seen[root] = true;
        let mut waiting = vec![(root, 0usize)];
        let mut last = None;
        while let Some((element, depth)) = waiting.pop() {
            // A first branch goes straight on; every other takes a row of its own.
            if last.is_some_and(|last| depth <= last) {
                row += 1.0;
            }
            last = Some(depth);
            deepest = deepest.max(depth);
            places[element] = [STUB + LABEL + COLUMN * depth as f64, TITLE + ROW * (row + 0.5)];
            for bond in graph.elements[element].ports.iter().rev() {
                let ends = &graph.bonds[*bond];
                let other = if ends.from == element { ends.to } else { ends.from };
                if !seen[other] && groups[other] == groups[element] && stubs[other].is_empty() {
                    seen[other] = true;
                    waiting.push((other, depth + 1));
                }
            }
        }
        let needed = (STUBS * (stubs[root].len() as f64 + 1.0) / ROW).ceil();
        row = (row + 1.0).max(first + needed);
        if needed > 1.0 {
            // A body with many short bonds stands in the middle of them.
            places[root][1] = TITLE + ROW * first + ROW * needed / 2.0;
        }
    }
    [STUB + LABEL + COLUMN * (deepest as f64 + 0.6), TITLE + ROW * row + 12.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_where_an_element_belongs() {
        for (name, group) in [
            ("piston12_x", Group::Cylinder(12)),
            ("rod_turn2_motion", Group::Cylinder(2)),
            ("gas1", Group::Cylinder(1)),
            ("intake_mass", Group::Surroundings),
            ("intake3", Group::Cylinder(3)),
            ("mount2_1_spring", Group::Mount(2)),
            ("crankshaft", Group::Block),
            ("crankshaft_unbalance1", Group::Rotor("crankshaft".into())),
            ("shaft1_drive", Group::Rotor("shaft1".into())),
            ("wx", Group::Block),
            ("link1_gear", Group::Driveline),
        ] {
            assert_eq!(Group::of(name), group, "{name}");
        }
    }
}
