//! Two halves of a factor that do not know each other: subtrees of its elimination tree, and the top that both end in.

/// Share of all work above which a subtree is taken apart.
const LARGE: f64 = 0.3;

/// Supernodes, rising, by who substitutes through them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Halves {
    /// Whole subtrees: no rows of one half are columns of the other.
    pub halves: [Vec<usize>; 2],
    /// What is above all of them.
    pub top: Vec<usize>,
}

impl Halves {
    /// `parents`: by supernode the one above it, which comes later; `work`: of each by itself.
    pub fn new(parents: &[Option<usize>], work: &[f64]) -> Halves {
        let count = parents.len();
        // Of whole subtrees.
        let mut subtrees = work.to_vec();
        for (node, parent) in parents.iter().enumerate() {
            if let Some(parent) = *parent {
                subtrees[parent] += subtrees[node];
            }
        }
        let most = LARGE * work.iter().sum::<f64>();
        let is_top = |node: usize| subtrees[node] > most;
        let mut roots: Vec<usize> =
            (0..count).filter(|node| !is_top(*node) && parents[*node].is_none_or(is_top)).collect();
        roots.sort_by(|a, b| subtrees[*b].total_cmp(&subtrees[*a]));
        let mut half_of = vec![None; count];
        let mut loads = [0.0; 2];
        for root in roots {
            let half = usize::from(loads[1] < loads[0]);
            loads[half] += subtrees[root];
            half_of[root] = Some(half);
        }
        for node in (0..count).rev().filter(|node| !is_top(*node)) {
            if let Some(parent) = parents[node].filter(|parent| !is_top(*parent)) {
                half_of[node] = half_of[parent];
            }
        }
        let of = |wanted: Option<usize>| (0..count).filter(|node| half_of[*node] == wanted).collect();
        Halves { halves: [of(Some(0)), of(Some(1))], top: of(None) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_branches_are_two_halves() {
        // Chains of two and three that end in a chain of two.
        let parents = [Some(1), Some(5), Some(3), Some(4), Some(5), Some(6), None];
        let split = Halves::new(&parents, &[1.0, 2.0, 1.0, 1.0, 1.0, 3.0, 2.0]);
        assert_eq!(split, Halves { halves: [vec![0, 1], vec![2, 3, 4]], top: vec![5, 6] });
    }

    #[test]
    fn a_small_tree_may_be_all_top() {
        let split = Halves::new(&[Some(1), None], &[1.0, 1.0]);
        assert_eq!(split, Halves { halves: [vec![], vec![]], top: vec![0, 1] });
    }
}
