//! Algebraic loops: variables that need one another without a store between them.
//!
//! Every variable is set by one element from others. Sets of variables that reach one another are loops; cutting one variable of each,
//! and of what is left of it, leaves none. Source: van Dijk, Breedveld, Journal of the Franklin Institute 328 (1991), 747-764, causal
//! paths of order zero; strongly connected components: Tarjan, SIAM Journal on Computing 1 (1972), 146-160.

use crate::expression::{Id, Node, Var};
use crate::graph::{Graph, Kind, Law};
use serde::Serialize;
use std::collections::HashSet;

/// An algebraic loop.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct AlgebraicLoop {
    /// Elements, junctions and signals on it, in the order of the graph.
    pub elements: Vec<String>,
    /// Variables that cut it: solved for before all others.
    pub cut_at: Vec<String>,
}

/// All algebraic loops, and the variables that cut them.
///
/// `free`: bonds whose causality was free; their variables cut first.
pub(crate) fn loops(
    graph: &Graph,
    strokes: &[bool],
    following: &[usize],
    free: &[usize],
) -> (Vec<AlgebraicLoop>, Vec<Var>) {
    let bonds = graph.bonds.len();
    let variables = Variables { graph, strokes, following };
    let needs: Vec<Vec<usize>> =
        (0..2 * bonds + graph.signals.len()).map(|variable| variables.needs(variable)).collect();
    let mut is_cut = vec![false; needs.len()];
    let mut found: Vec<(Vec<usize>, Vec<usize>)> =
        circles(&needs, &is_cut).into_iter().map(|circle| (circle, Vec::new())).collect();
    let on_loop: HashSet<usize> = found.iter().flat_map(|(circle, _)| circle.iter().copied()).collect();
    let first: Vec<usize> = free.iter().map(|bond| variables.given_back(*bond)).collect();
    let mut cuts: Vec<usize> = Vec::new();
    let mut cut = |variable: usize, is_cut: &mut Vec<bool>| {
        is_cut[variable] = true;
        cuts.push(variable);
        if let Some((_, own)) = found.iter_mut().find(|(circle, _)| circle.contains(&variable)) {
            own.push(variable);
        }
    };
    for variable in first {
        // What is free may stand beside all loops.
        if on_loop.contains(&variable) {
            cut(variable, &mut is_cut);
        }
    }
    loop {
        let left = circles(&needs, &is_cut);
        if left.is_empty() {
            break;
        }
        for circle in left {
            cut(circle[0], &mut is_cut);
        }
    }
    let listed = found.into_iter().map(|(circle, own)| AlgebraicLoop {
        elements: variables.elements(&circle),
        cut_at: own.into_iter().map(|variable| variables.name(variable)).collect(),
    });
    (listed.collect(), cuts.into_iter().map(|variable| variables.var(variable)).collect())
}

/// Variables by number: efforts of all bonds, their flows, signals.
struct Variables<'a> {
    graph: &'a Graph,
    strokes: &'a [bool],
    following: &'a [usize],
}

impl Variables<'_> {
    fn var(&self, variable: usize) -> Var {
        let bonds = self.graph.bonds.len();
        match variable {
            effort if effort < bonds => Var::Effort(effort as u32),
            flow if flow < 2 * bonds => Var::Flow((flow - bonds) as u32),
            signal => Var::Signal((signal - 2 * bonds) as u32),
        }
    }

    fn name(&self, variable: usize) -> String {
        let bonds = self.graph.bonds.len();
        match variable {
            effort if effort < bonds => format!("{}.effort", self.graph.bond_name(effort)),
            flow if flow < 2 * bonds => format!("{}.flow", self.graph.bond_name(flow - bonds)),
            signal => self.graph.signals[signal - 2 * bonds].name.clone(),
        }
    }

    /// The element that sets a variable of a bond: the stroke stands where the effort arrives.
    fn setter(&self, bond: usize, is_effort: bool) -> usize {
        let ends = &self.graph.bonds[bond];
        if is_effort == self.strokes[bond] { ends.from } else { ends.to }
    }

    /// Of a bond that was free: the variable that its resistor gives, or the effort.
    fn given_back(&self, bond: usize) -> usize {
        let resistor = [self.graph.bonds[bond].from, self.graph.bonds[bond].to]
            .into_iter()
            .find(|end| self.graph.elements[*end].kind == Kind::R);
        match resistor {
            Some(resistor) if self.setter(bond, false) == resistor => bond + self.graph.bonds.len(),
            _ => bond,
        }
    }

    /// Elements and signals of a loop, in the order of the graph.
    fn elements(&self, circle: &[usize]) -> Vec<String> {
        let bonds = self.graph.bonds.len();
        let mut elements: Vec<usize> = Vec::new();
        let mut signals = Vec::new();
        for variable in circle {
            match *variable {
                effort if effort < bonds => elements.push(self.setter(effort, true)),
                flow if flow < 2 * bonds => elements.push(self.setter(flow - bonds, false)),
                signal => signals.push(self.name(signal)),
            }
        }
        elements.sort_unstable();
        elements.dedup();
        elements.into_iter().map(|element| self.graph.elements[element].name.clone()).chain(signals).collect()
    }

    /// What the law that sets a variable takes.
    fn needs(&self, variable: usize) -> Vec<usize> {
        let (graph, bonds) = (self.graph, self.graph.bonds.len());
        let mut needs = Vec::new();
        if variable >= 2 * bonds {
            let signal = &graph.signals[variable - 2 * bonds];
            if signal.start.is_none() {
                self.take(signal.value, &mut needs);
            }
            return needs;
        }
        let is_effort = variable < bonds;
        let bond = variable % bonds;
        let setter = self.setter(bond, is_effort);
        let element = &graph.elements[setter];
        let port = element.ports.iter().position(|own| *own == bond).unwrap_or(0);
        let of = |bond: usize, is_effort: bool| if is_effort { bond } else { bond + bonds };
        match &element.law {
            Law::Source(value) => self.take(*value, &mut needs),
            Law::Resistor { effort, flow } => {
                if let Some(law) = if is_effort { effort } else { flow } {
                    self.take(*law, &mut needs);
                }
            }
            Law::Resistors { laws, .. } => self.take(laws[port], &mut needs),
            // The rate of a store that follows is found by differentiating, not by its law.
            Law::Store(_) if self.following.contains(&bond) => {}
            Law::Store(ports) => {
                if let Some(law) = if is_effort { ports[port].effort } else { ports[port].flow } {
                    self.take(law, &mut needs);
                }
            }
            Law::Ratio(ratio) => {
                self.take(*ratio, &mut needs);
                let keeps = element.kind == Kind::TF;
                needs.push(of(element.ports[1 - port], is_effort == keeps));
            }
            Law::Matrix(rows) => {
                let columns = rows[0].len();
                let entries: Vec<(Id, usize)> = if is_effort {
                    rows.iter()
                        .enumerate()
                        .map(|(row, entries)| (entries[port], element.ports[columns + row]))
                        .collect()
                } else {
                    rows[port - columns].iter().copied().zip(element.ports.iter().copied()).collect()
                };
                for (entry, there) in entries {
                    if !graph.pool.is_zero(entry) {
                        self.take(entry, &mut needs);
                        needs.push(of(there, is_effort));
                    }
                }
            }
            Law::Junction => {
                let common_is_effort = element.kind == Kind::Zero;
                let decides = |other: &usize| {
                    (self.strokes[*other] == (graph.bonds[*other].to == setter)) == common_is_effort
                };
                let others = element.ports.iter().copied().filter(|other| *other != bond);
                if is_effort == common_is_effort {
                    needs.extend(others.filter(decides).map(|other| of(other, is_effort)));
                } else {
                    needs.extend(others.map(|other| of(other, is_effort)));
                }
            }
        }
        needs
    }

    /// Variables of an expression; what a store that follows holds hangs on its bond.
    fn take(&self, expression: Id, needs: &mut Vec<usize>) {
        let bonds = self.graph.bonds.len();
        // Laws are small and many: what is seen is no list as long as the pool.
        let (mut waiting, mut seen) = (vec![expression], HashSet::new());
        while let Some(id) = waiting.pop() {
            if !seen.insert(id) {
                continue;
            }
            match self.graph.pool.node(id) {
                Node::Var(Var::Effort(bond)) => needs.push(bond as usize),
                Node::Var(Var::Flow(bond)) => needs.push(bonds + bond as usize),
                Node::Var(Var::Signal(signal)) => needs.push(2 * bonds + signal as usize),
                Node::Var(Var::Displacement(bond) | Var::Momentum(bond))
                    if self.following.contains(&(bond as usize)) =>
                {
                    let bond = bond as usize;
                    let store = self.graph.bonds[bond].to;
                    let by_flow = self.graph.elements[store].kind != Kind::C;
                    needs.push(if by_flow { bonds + bond } else { bond });
                }
                _ => waiting.extend(self.graph.pool.operands(id)),
            }
        }
    }
}

/// Sets of variables that reach one another, each in rising order, without those that are cut.
fn circles(needs: &[Vec<usize>], is_cut: &[bool]) -> Vec<Vec<usize>> {
    const UNSEEN: usize = usize::MAX;
    let count = needs.len();
    let (mut number, mut lowest, mut is_open) = (vec![UNSEEN; count], vec![0; count], vec![false; count]);
    let (mut open, mut next) = (Vec::new(), 0);
    let mut found = Vec::new();
    for start in 0..count {
        if number[start] != UNSEEN || is_cut[start] {
            continue;
        }
        // Variable and how many of its needs have been looked at.
        let mut path = vec![(start, 0)];
        while let Some((at, seen)) = path.last_mut() {
            let at = *at;
            if *seen == 0 {
                (number[at], lowest[at], is_open[at]) = (next, next, true);
                next += 1;
                open.push(at);
            }
            if let Some(&to) = needs[at].get(*seen) {
                *seen += 1;
                if is_cut[to] {
                    // Seen as a constant.
                } else if number[to] == UNSEEN {
                    path.push((to, 0));
                    continue;
                } else if is_open[to] {
                    lowest[at] = lowest[at].min(number[to]);
                }
                if *seen < needs[at].len() {
                    continue;
                }
            }
            path.pop();
            if let Some((before, _)) = path.last() {
                lowest[*before] = lowest[*before].min(lowest[at]);
            }
            if lowest[at] == number[at] {
                let mut circle = Vec::new();
                while let Some(top) = open.pop() {
                    is_open[top] = false;
                    circle.push(top);
                    if top == at {
                        break;
                    }
                }
                if circle.len() > 1 || needs[at].contains(&at) {
                    circle.sort_unstable();
                    found.push(circle);
                }
            }
        }
    }
    found.sort();
    found
}

#[cfg(test)]
mod tests {
    use super::circles;

    #[test]
    fn circles_are_what_reaches_itself() {
        // 0 > 1 > 2 > 0, 3 > 2, 4 > 4, 5 > 6 > 5, 7 alone.
        let needs = vec![vec![1], vec![2], vec![0], vec![2], vec![4], vec![6, 0], vec![5], vec![]];
        assert_eq!(circles(&needs, &[false; 8]), [vec![0, 1, 2], vec![4], vec![5, 6]]);
        let mut is_cut = [false; 8];
        (is_cut[1], is_cut[4]) = (true, true);
        assert_eq!(circles(&needs, &is_cut), [vec![5, 6]]);
    }
}
