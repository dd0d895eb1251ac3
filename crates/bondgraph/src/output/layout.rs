//! Places of a graph that is no engine: junctions and two-ports in columns by their distance from the first source; one-ports above and
//! below their junction, or, where a column would be tall, beside it in two wings.

use crate::graph::{Graph, Kind};
use crate::output::label::Label;
use std::collections::{BTreeMap, VecDeque};

/// Distance of columns, of rows, and of one-ports from their junction.
const COLUMN: f64 = 150.0;
const ROW: f64 = 290.0;
const LIMB: f64 = 95.0;
const SPREAD: f64 = 84.0;
/// Around all.
pub(crate) const MARGIN: f64 = 70.0;
/// Rows of a column from which one-ports stand beside their junctions.
const TALL: usize = 3;
/// Of wings: distance of columns, of one-ports, of rows, and of two one-ports at one junction.
const WING_COLUMN: f64 = 190.0;
const WING_LIMB: f64 = 118.0;
const WING_ROW: f64 = 92.0;
const WING_SPREAD: f64 = 58.0;

/// Where each element stands, and of one-ports beside their junction on which side: left -1, right 1.
#[derive(Debug, Clone, Default)]
pub(crate) struct Places {
    pub(crate) at: Vec<[f64; 2]>,
    pub(crate) beside: BTreeMap<usize, f64>,
}

/// Columns and rows of junctions and two-ports, and their one-ports.
struct Columns {
    core: Vec<bool>,
    depth: Vec<Option<usize>>,
    row: Vec<usize>,
    rows: usize,
}

fn neighbours(graph: &Graph, element: usize) -> impl Iterator<Item = usize> + '_ {
    graph.elements[element].ports.iter().map(move |bond| {
        let bond = &graph.bonds[*bond];
        if bond.from == element { bond.to } else { bond.from }
    })
}

fn is_source(graph: &Graph, element: usize) -> bool {
    matches!(graph.elements[element].kind, Kind::Se | Kind::Sf)
}

/// Places of all elements.
pub(crate) fn places(graph: &Graph, labels: &[Label]) -> Places {
    let columns = Columns::of(graph);
    let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
    for depth in columns.depth.iter().flatten() {
        *counts.entry(*depth).or_default() += 1;
    }
    if counts.len() > 2 && counts.values().any(|count| *count >= TALL) {
        return Wings::of(graph, &columns).places(graph, labels);
    }
    Places { at: in_rows(graph, &columns), beside: BTreeMap::new() }.with_margin(labels)
}

impl Columns {
    fn of(graph: &Graph) -> Columns {
        let count = graph.elements.len();
        let core: Vec<bool> = graph.elements.iter().map(|e| e.is_junction() || e.ports.len() > 1).collect();
        let mut depth: Vec<Option<usize>> = vec![None; count];
        let mut row = vec![0usize; count];
        let mut next_row = 0;
        let mut starts: Vec<usize> =
            (0..count).filter(|e| core[*e] && neighbours(graph, *e).any(|n| is_source(graph, n))).collect();
        starts.extend((0..count).filter(|e| core[*e]));
        for start in starts {
            if depth[start].is_some() {
                continue;
            }
            let first_row = next_row;
            depth[start] = Some(0);
            row[start] = next_row;
            let mut waiting = VecDeque::from([start]);
            // Rows that are taken in each column, so that branches stand below one another.
            let mut taken: Vec<(usize, usize)> = vec![(0, next_row)];
            while let Some(at) = waiting.pop_front() {
                let column = depth[at].unwrap_or(0) + 1;
                // What goes on stands straight ahead, what ends there below.
                let mut ahead: Vec<usize> = neighbours(graph, at).filter(|other| core[*other]).collect();
                ahead.sort_by_key(|other| {
                    std::cmp::Reverse(neighbours(graph, *other).filter(|n| core[*n]).count())
                });
                for other in ahead {
                    if depth[other].is_none() {
                        let mut wanted = row[at];
                        while taken.contains(&(column, wanted)) {
                            wanted += 1;
                        }
                        depth[other] = Some(column);
                        row[other] = wanted;
                        taken.push((column, wanted));
                        waiting.push_back(other);
                    }
                }
            }
            let used = (0..count).filter(|e| depth[*e].is_some()).map(|e| row[e]).max().unwrap_or(first_row);
            next_row = used + 1;
        }
        Columns { core, depth, row, rows: next_row }
    }
}

/// One-ports above and below their junctions.
fn in_rows(graph: &Graph, Columns { core, depth, row, rows }: &Columns) -> Vec<[f64; 2]> {
    let count = graph.elements.len();
    let mut limbs: Vec<[Vec<usize>; 2]> = vec![[Vec::new(), Vec::new()]; count];
    for element in 0..count {
        if core[element] {
            for other in neighbours(graph, element).filter(|other| !core[*other]).collect::<Vec<_>>() {
                let [up, down] = &mut limbs[element];
                if is_source(graph, other) && up.len() <= down.len() || up.len() < down.len() {
                    up.push(other);
                } else {
                    down.push(other);
                }
            }
        }
    }
    // Columns as wide as the limbs within them need.
    let columns = depth.iter().flatten().max().map_or(1, |most| most + 1);
    let mut widest = vec![1usize; columns];
    for element in 0..count {
        if let Some(column) = depth[element] {
            let most = limbs[element].iter().map(Vec::len).max().unwrap_or(0);
            widest[column] = widest[column].max(most);
        }
    }
    let mut across = Vec::new();
    let mut at = MARGIN;
    for column in 0..columns {
        let half = SPREAD * (widest[column] - 1) as f64 / 2.0;
        at += half;
        across.push(at);
        at += half.max(0.0) + COLUMN - 30.0 * f64::from(u8::from(widest[column] > 1));
    }
    let mut places = vec![[MARGIN, MARGIN]; count];
    for element in 0..count {
        let Some(column) = depth[element] else { continue };
        let (x, y) = (across[column], MARGIN + LIMB + 20.0 + ROW * row[element] as f64);
        places[element] = [x, y];
        for (side, limb) in limbs[element].iter().enumerate() {
            for (index, other) in limb.iter().enumerate() {
                let shift = SPREAD * (index as f64 - (limb.len() - 1) as f64 / 2.0);
                let down = if side == 0 { -LIMB } else { LIMB };
                places[*other] = [x + shift, y + down];
            }
        }
    }
    // One-ports bonded to one another, without a junction.
    let mut y = MARGIN + LIMB + 20.0 + ROW * *rows as f64;
    for bond in &graph.bonds {
        if !core[bond.from] && !core[bond.to] {
            places[bond.from] = [MARGIN, y];
            places[bond.to] = [MARGIN + COLUMN, y];
            y += ROW / 2.0;
        }
    }
    places
}

/// Columns of junctions and two-ports with all others of the first and last column beside them.
struct Wings {
    columns: Vec<Vec<usize>>,
    core: Vec<bool>,
}

impl Wings {
    /// What hangs on the second column alone is shared between the first and the third.
    fn of(graph: &Graph, from: &Columns) -> Wings {
        let count = from.depth.iter().flatten().max().map_or(1, |most| most + 1);
        let mut columns = vec![Vec::new(); count];
        for (element, depth) in from.depth.iter().enumerate() {
            if let Some(depth) = depth {
                columns[*depth].push(element);
            }
        }
        let is_end =
            |element: &usize| neighbours(graph, *element).filter(|other| from.core[*other]).count() == 1;
        // Columns between two others keep but what joins them.
        while columns.len() > 3 || columns[2].len() > columns[0].len() + 1 {
            let Some(place) = columns[2].iter().rposition(is_end) else { break };
            let element = columns[2].remove(place);
            columns[0].insert(1, element);
        }
        Wings { columns, core: from.core.clone() }
    }

    fn places(&self, graph: &Graph, labels: &[Label]) -> Places {
        let mut found = Places { at: vec![[0.0; 2]; graph.elements.len()], beside: BTreeMap::new() };
        let last = self.columns.len() - 1;
        for (column, elements) in self.columns.iter().enumerate() {
            let side = if column == 0 { -1.0 } else { f64::from(u8::from(column == last)) };
            let limbs = |element: usize| -> Vec<usize> {
                neighbours(graph, element).filter(|other| !self.core[*other]).collect()
            };
            let height = |element: &usize| match limbs(*element).len() as f64 {
                count if side != 0.0 => WING_ROW.max(WING_SPREAD * count + 34.0),
                count if count > 0.0 && elements.len() >= TALL => 2.0 * LIMB + 60.0,
                _ => 1.3 * WING_ROW,
            };
            let mut y = -0.5 * elements.iter().map(height).sum::<f64>();
            for element in elements {
                y += 0.5 * height(element);
                let x = WING_COLUMN * column as f64;
                found.at[*element] = [x, y];
                let limbs = limbs(*element);
                for (index, limb) in limbs.iter().enumerate() {
                    let shift = index as f64 - (limbs.len() - 1) as f64 / 2.0;
                    found.at[*limb] = if side != 0.0 {
                        found.beside.insert(*limb, side);
                        [x + side * WING_LIMB, y + WING_SPREAD * shift]
                    } else {
                        let (up, share) = match elements.len() {
                            1 => (index % 2 == 0, (index / 2) as f64),
                            _ => (y < 0.0, shift),
                        };
                        [x + SPREAD * share, y + if up { -LIMB } else { LIMB }]
                    };
                }
                y += 0.5 * height(element);
            }
        }
        found.with_margin(labels)
    }
}

impl Places {
    /// Moved so that all names are within the picture.
    fn with_margin(mut self, labels: &[Label]) -> Places {
        let wide = |element: usize, label: &Label| match self.beside.get(&element) {
            Some(side) if *side < 0.0 => label.left + label.right + 16.0,
            _ => label.left,
        };
        let left = (self.at.iter().zip(labels).enumerate())
            .map(|(element, ([x, _], label))| x - wide(element, label))
            .fold(f64::INFINITY, f64::min);
        let top = self.at.iter().map(|[_, y]| *y).fold(f64::INFINITY, f64::min);
        for [x, y] in &mut self.at {
            (*x, *y) = (*x - left + 20.0, *y - top + MARGIN + 20.0);
        }
        self
    }
}
