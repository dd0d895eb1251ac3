//! Places of an engine's graph: a tile for the block and one for every cylinder, rotor and mount.
//!
//! A body follows up to seven flows of block and crank, so that lines to all of them would hide everything. What hangs together within a
//! tile is a branch, whose bonds are drawn; a bond to another tile or branch is a short one with the name of what stands at its other end.
//! Tiles of cylinders are alike.

use crate::graph::{Graph, Kind};
use crate::output::label::Label;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// Distances within a tile: columns, rows, short bonds to other tiles.
const COLUMN: f64 = 140.0;
const ROW: f64 = 72.0;
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
    /// Elements whose bonds to other tiles are drawn at their right.
    pub(crate) to_the_right: BTreeSet<usize>,
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
pub(crate) fn tiled(graph: &Graph, labels: &[Label]) -> Option<Tiled> {
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
        let size = tree(graph, &groups, elements, &mut stubs, labels, &mut tiled);
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
            let along = if tiled.to_the_right.contains(&element) { STUB } else { -STUB };
            tiled.stubs.insert(*bond, (element, [x + along, y + down], name));
        }
    }
    Some(tiled)
}

/// A place in the grid of a tile: column and row.
type Cell = [usize; 2];

/// Places the elements of one tile from its corner: what leads to other tiles at the left, what hangs on it to the right, so that bonds
/// lead from a column to the next, where nothing stands between. Gives the size.
fn tree(
    graph: &Graph,
    groups: &[Group],
    elements: &[usize],
    stubs: &mut [Vec<usize>],
    labels: &[Label],
    tiled: &mut Tiled,
) -> [f64; 2] {
    let branches = branches(graph, groups, elements, stubs);
    shorten(graph, elements, &branches, stubs);
    let mut cells: BTreeMap<usize, Cell> = BTreeMap::new();
    let mut tops: BTreeMap<usize, f64> = BTreeMap::new();
    let mut rows = 0.0f64;
    for branch in &branches {
        let placed = branch.cells(stubs);
        // A body stands in the middle of its short bonds.
        let above = ((STUBS * stubs[branch.root].len() as f64 / ROW - 1.0) / 2.0).max(0.0);
        let height = placed.values().map(|cell| cell[1] + 1).max().unwrap_or(1) as f64;
        for (element, cell) in placed {
            tops.insert(element, rows + above);
            cells.insert(element, cell);
        }
        rows += (above + height).max(2.0 * above + 1.0 + GAP / ROW);
    }
    let across = columns(&cells, labels);
    for (element, [column, row]) in &cells {
        // Whole pixels, so that tiles that are alike are so to the last digit.
        let y = TITLE + ROW * (tops[element] + *row as f64 + 0.5);
        tiled.places[*element] = [across[*column], y.round()];
        let is_leaf = |bond: &usize| {
            let ends = &graph.bonds[*bond];
            let other = if ends.from == *element { ends.to } else { ends.from };
            cells.get(&other).is_none_or(|cell| cell[0] <= *column)
        };
        if *column > 0 && graph.elements[*element].ports.iter().all(is_leaf) {
            tiled.to_the_right.insert(*element);
        }
    }
    let end = |element: &usize| {
        let short = if stubs[*element].is_empty() || !tiled.to_the_right.contains(element) {
            0.0
        } else {
            STUB + LABEL
        };
        tiled.places[*element][0] + labels[*element].right.max(short)
    };
    let width = elements.iter().map(end).fold(0.0, f64::max) + 14.0;
    [width.ceil(), (TITLE + ROW * rows + 12.0).ceil()]
}

/// What hangs together in a tile: first what leads to other tiles, but for valves and walls, then what is left.
fn branches(graph: &Graph, groups: &[Group], elements: &[usize], stubs: &[Vec<usize>]) -> Vec<Branch> {
    let mut roots: Vec<usize> =
        elements.iter().copied().filter(|element| !stubs[*element].is_empty()).collect();
    roots.sort_by_key(|element| graph.elements[*element].kind == Kind::R);
    roots.extend(elements.iter().copied().filter(|element| graph.elements[*element].is_junction()));
    roots.extend(elements);
    let mut found: Vec<Branch> = Vec::new();
    for root in roots {
        if !found.iter().any(|branch| branch.depth.contains_key(&root)) {
            let branch = Branch::from(graph, groups, stubs, &found, root);
            found.push(branch);
        }
    }
    found
}

/// Has bonds from branch to branch drawn as short ones, at the root of one.
fn shorten(graph: &Graph, elements: &[usize], branches: &[Branch], stubs: &mut [Vec<usize>]) {
    let branch = |element: usize| branches.iter().position(|branch| branch.depth.contains_key(&element));
    let is_root = |element: usize| branches.iter().any(|branch| branch.root == element);
    for (index, bond) in graph.bonds.iter().enumerate() {
        let is_within = elements.contains(&bond.from) && elements.contains(&bond.to);
        if is_within && branch(bond.from) != branch(bond.to) {
            stubs[if is_root(bond.from) { bond.from } else { bond.to }].push(index);
        }
    }
}

/// Where each column of a tile stands, so that names have space.
fn columns(cells: &BTreeMap<usize, Cell>, labels: &[Label]) -> Vec<f64> {
    let count = cells.values().map(|cell| cell[0] + 1).max().unwrap_or(0);
    let (mut left, mut right) = (vec![0.0f64; count], vec![0.0f64; count]);
    for (element, [column, _]) in cells {
        left[*column] = left[*column].max(labels[*element].left);
        right[*column] = right[*column].max(labels[*element].right);
    }
    let mut across = vec![STUB + LABEL; count];
    for column in 1..count {
        across[column] = across[column - 1] + COLUMN.max(right[column - 1] + left[column] + 8.0).ceil();
    }
    across
}

/// What hangs together within a tile, as a tree from its root by the fewest bonds.
struct Branch {
    root: usize,
    depth: BTreeMap<usize, usize>,
    /// Whether an element has more bonds than one.
    is_through: BTreeMap<usize, bool>,
    children: BTreeMap<usize, Vec<usize>>,
}

impl Branch {
    /// Valves and walls, which lead to other tiles too, end it; other elements that lead there begin branches of their own.
    fn from(graph: &Graph, groups: &[Group], stubs: &[Vec<usize>], others: &[Branch], root: usize) -> Branch {
        let mut depth = BTreeMap::from([(root, 0)]);
        let mut children: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        let mut waiting = VecDeque::from([root]);
        while let Some(element) = waiting.pop_front() {
            for bond in &graph.elements[element].ports {
                let ends = &graph.bonds[*bond];
                let other = if ends.from == element { ends.to } else { ends.from };
                let goes_on = stubs[other].is_empty() || graph.elements[other].kind == Kind::R;
                let is_new = !depth.contains_key(&other)
                    && !others.iter().any(|branch| branch.depth.contains_key(&other));
                if groups[other] == groups[root] && goes_on && is_new {
                    depth.insert(other, depth[&element] + 1);
                    children.entry(element).or_default().push(other);
                    waiting.push_back(other);
                }
            }
        }
        let is_through =
            depth.keys().map(|element| (*element, graph.elements[*element].ports.len() > 1)).collect();
        Branch { root, depth, is_through, children }
    }

    fn of(&self, element: usize) -> &[usize] {
        self.children.get(&element).map_or(&[], Vec::as_slice)
    }

    /// How far it goes on from an element.
    fn reach(&self, element: usize) -> usize {
        self.of(element).iter().map(|child| self.reach(*child) + 1).max().unwrap_or(0)
    }

    /// Column and row of each element: what goes on farthest straight ahead, the rest in the next free row of its column. Short bonds at
    /// an end take the columns behind it.
    fn cells(&self, stubs: &[Vec<usize>]) -> BTreeMap<usize, Cell> {
        let mut cells = BTreeMap::new();
        let mut free = vec![0usize; self.depth.len() + 3];
        let mut waiting = vec![(self.root, 0)];
        while let Some((element, parent_row)) = waiting.pop() {
            let column = self.depth[&element];
            let needs_end = column > 0 && !stubs[element].is_empty() && self.of(element).is_empty();
            let last = if needs_end { column + 2 } else { column };
            // In line with the first of what hangs on it.
            let ahead = if self.of(element).is_empty() { last } else { column + 1 };
            let row = free[column..=ahead].iter().copied().fold(parent_row, usize::max);
            free[column..=last].fill(row + 1);
            cells.insert(element, [column, row]);
            let mut children = self.of(element).to_vec();
            children.reverse();
            children.sort_by_key(|child| (self.reach(*child), self.of(*child).len(), self.is_through[child]));
            waiting.extend(children.into_iter().map(|child| (child, row)));
        }
        cells
    }
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
