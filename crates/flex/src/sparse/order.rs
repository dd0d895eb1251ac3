//! Order of elimination: nested dissection of the elements.
//!
//! The elements are cut in two by the best of several planes across the axes; the nodes that both halves share are the separator and
//! come last, each half is cut again. The cut is refined by moving single elements over it as long as the separator becomes smaller
//! (Fiduccia and Mattheyses 1982, without their tentative moves).

use rayon::join;

/// Parts with no more elements are ordered as they come.
const LEAF: usize = 10;
/// Where the planes are tried, as shares of the elements.
const SHARES: [f64; 5] = [0.4, 0.45, 0.5, 0.55, 0.6];
/// The smaller part has at least this share of the elements.
const BALANCE: f64 = 0.38;
/// Parts with fewer elements are cut one after the other.
const PARALLEL: usize = 2000;
const PASSES: usize = 4;

/// Elements with their nodes in numbers of their own.
struct Part {
    /// First node of each element, and the number of all.
    starts: Vec<u32>,
    nodes: Vec<u32>,
    middles: Vec<[f64; 3]>,
    /// What each node is called outside.
    names: Vec<u32>,
}

impl Part {
    fn elements(&self) -> usize {
        self.middles.len()
    }

    fn nodes_of(&self, element: usize) -> &[u32] {
        &self.nodes[self.starts[element] as usize..self.starts[element + 1] as usize]
    }

    /// The elements of one side without the separator's nodes.
    fn half(&self, side: &[bool], which: bool, is_separator: &[bool]) -> Part {
        let mut number = vec![u32::MAX; self.names.len()];
        let mut part = Part { starts: vec![0], nodes: Vec::new(), middles: Vec::new(), names: Vec::new() };
        for element in (0..self.elements()).filter(|element| side[*element] == which) {
            for node in self.nodes_of(element).iter().filter(|node| !is_separator[**node as usize]) {
                let number = &mut number[*node as usize];
                if *number == u32::MAX {
                    *number = part.names.len() as u32;
                    part.names.push(self.names[*node as usize]);
                }
                part.nodes.push(*number);
            }
            // An element whose nodes are all in separators is done.
            if part.nodes.len() as u32 > part.starts[part.starts.len() - 1] {
                part.starts.push(part.nodes.len() as u32);
                part.middles.push(self.middles[element]);
            }
        }
        part
    }
}

/// Nodes in the order of their elimination, from the nodes of each element and the places of the nodes [m].
/// Every node must belong to an element.
pub fn nested_dissection(places: &[[f64; 3]], elements: &[&[u32]]) -> Vec<u32> {
    let mut part = Part {
        starts: vec![0],
        nodes: Vec::new(),
        middles: Vec::with_capacity(elements.len()),
        names: (0..places.len() as u32).collect(),
    };
    for nodes in elements {
        part.nodes.extend_from_slice(nodes);
        part.starts.push(part.nodes.len() as u32);
        let count = nodes.len() as f64;
        part.middles.push(std::array::from_fn(|k| {
            nodes.iter().map(|node| places[*node as usize][k]).sum::<f64>() / count
        }));
    }
    dissect(part)
}

fn dissect(part: Part) -> Vec<u32> {
    if part.elements() <= LEAF {
        return part.names;
    }
    let mut side = best_cut(&part);
    refine(&part, &mut side);
    let is_separator = shared(&part, &side);
    let halves = [false, true].map(|which| part.half(&side, which, &is_separator));
    if halves.iter().any(|half| half.elements() == part.elements()) {
        return part.names;
    }
    let separator = (0..part.names.len()).filter(|node| is_separator[*node]).map(|node| part.names[node]);
    let separator: Vec<u32> = separator.collect();
    let [a, b] = halves;
    let large = part.elements() > PARALLEL;
    drop(part);
    let (mut order, rest) = if large { join(|| dissect(a), || dissect(b)) } else { (dissect(a), dissect(b)) };
    order.extend(rest);
    order.extend(separator);
    order
}

/// For each element whether it is beyond the plane that leaves the smallest separator.
fn best_cut(part: &Part) -> Vec<bool> {
    let count = part.elements();
    let mut best: Option<(usize, Vec<bool>)> = None;
    for axis in 0..3 {
        let mut along: Vec<u32> = (0..count as u32).collect();
        along.sort_by(|a, b| {
            part.middles[*a as usize][axis].total_cmp(&part.middles[*b as usize][axis]).then(a.cmp(b))
        });
        // Element after element over the cut: a node is shared from its first element to its last.
        let mut left = vec![0u32; part.names.len()];
        for node in &part.nodes {
            left[*node as usize] += 1;
        }
        let all = left.clone();
        let (mut open, mut next) = (0usize, 0);
        for share in SHARES {
            let end = (share * count as f64) as usize;
            for element in &along[next..end] {
                for node in part.nodes_of(*element as usize) {
                    let node = *node as usize;
                    if left[node] == all[node] {
                        open += 1;
                    }
                    left[node] -= 1;
                    if left[node] == 0 {
                        open -= 1;
                    }
                }
            }
            next = end;
            if best.as_ref().is_none_or(|(least, _)| open < *least) {
                let mut side = vec![true; count];
                for element in &along[..end] {
                    side[*element as usize] = false;
                }
                best = Some((open, side));
            }
        }
    }
    best.map(|(_, side)| side).unwrap_or_default()
}

/// Counts of each node's elements on both sides.
fn counts(part: &Part, side: &[bool]) -> Vec<[u32; 2]> {
    let mut counts = vec![[0; 2]; part.names.len()];
    for element in 0..part.elements() {
        for node in part.nodes_of(element) {
            counts[*node as usize][usize::from(side[element])] += 1;
        }
    }
    counts
}

fn shared(part: &Part, side: &[bool]) -> Vec<bool> {
    counts(part, side).iter().map(|[a, b]| *a > 0 && *b > 0).collect()
}

/// Moves elements over the cut while that makes the separator smaller, or as large with better balance.
fn refine(part: &Part, side: &mut [bool]) {
    let mut counts = counts(part, side);
    let mut sizes = [0usize; 2];
    for side in side.iter() {
        sizes[usize::from(*side)] += 1;
    }
    let least = (BALANCE * part.elements() as f64) as usize;
    for _ in 0..PASSES {
        let mut moved = false;
        for element in 0..part.elements() {
            let (from, to) = (usize::from(side[element]), usize::from(!side[element]));
            if sizes[from] <= least {
                continue;
            }
            let mut gain = 0i64;
            for node in part.nodes_of(element) {
                let count = counts[*node as usize];
                // Shared, and this is its last element on this side; or not shared, and others stay on this side.
                if count[to] > 0 && count[from] == 1 {
                    gain += 1;
                } else if count[to] == 0 && count[from] > 1 {
                    gain -= 1;
                }
            }
            if gain > 0 || (gain == 0 && sizes[from] > sizes[to] + 1 && touches(part, &counts, element, to)) {
                for node in part.nodes_of(element) {
                    counts[*node as usize][from] -= 1;
                    counts[*node as usize][to] += 1;
                }
                sizes[from] -= 1;
                sizes[to] += 1;
                side[element] = !side[element];
                moved = true;
            }
        }
        if !moved {
            break;
        }
    }
}

fn touches(part: &Part, counts: &[[u32; 2]], element: usize, to: usize) -> bool {
    part.nodes_of(element).iter().any(|node| counts[*node as usize][to] > 0)
}

/// The order with the nodes of each branch of the elimination tree next to each other: the same factor with larger dense blocks.
/// `neighbours` gives the nodes next to a node.
pub fn postorder<'a>(order: &[u32], neighbours: impl Fn(u32) -> &'a [u32]) -> Vec<u32> {
    const NONE: u32 = u32::MAX;
    let count = order.len();
    let mut place = vec![0u32; count];
    for (at, node) in order.iter().enumerate() {
        place[*node as usize] = at as u32;
    }
    // Liu's algorithm with path compression.
    let (mut parent, mut ancestor) = (vec![NONE; count], vec![NONE; count]);
    for (at, node) in order.iter().enumerate() {
        for neighbour in neighbours(*node) {
            let mut below = place[*neighbour as usize];
            while (below as usize) < at {
                let next = ancestor[below as usize];
                ancestor[below as usize] = at as u32;
                if next == NONE {
                    parent[below as usize] = at as u32;
                    break;
                }
                below = next;
            }
        }
    }
    let (mut first, mut next) = (vec![NONE; count], vec![NONE; count]);
    let mut roots = Vec::new();
    for at in (0..count).rev() {
        match parent[at] {
            NONE => roots.push(at as u32),
            parent => {
                next[at] = first[parent as usize];
                first[parent as usize] = at as u32;
            }
        }
    }
    let mut result = Vec::with_capacity(count);
    let mut stack = Vec::new();
    for root in roots.into_iter().rev() {
        stack.push(root);
        while let Some(top) = stack.last().copied() {
            match first[top as usize] {
                NONE => {
                    result.push(order[top as usize]);
                    stack.pop();
                }
                child => {
                    first[top as usize] = next[child as usize];
                    stack.push(child);
                }
            }
        }
    }
    result
}
