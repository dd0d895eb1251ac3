//! Places of the trajectory that are to be evaluated, side by side in one buffer.

/// Times with their states, the crank angle first.
#[derive(Debug, Clone)]
pub(crate) struct Kept {
    dimension: usize,
    /// Time and state, one after the other.
    values: Vec<f64>,
}

impl Kept {
    /// None of states of that many components.
    pub fn new(dimension: usize) -> Kept {
        Kept { dimension, values: Vec::new() }
    }

    /// Room for so many in all.
    pub fn reserve(&mut self, count: usize) {
        self.values.reserve((count * (self.dimension + 1)).saturating_sub(self.values.len()));
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.values.len() / (self.dimension + 1)
    }

    /// A new one at a time [s]; its state is to be filled in.
    pub fn push(&mut self, time: f64) -> &mut [f64] {
        self.values.push(time);
        let at = self.values.len();
        self.values.resize(at + self.dimension, 0.0);
        &mut self.values[at..]
    }

    /// The last one is at another time [s].
    pub fn is_at(&mut self, time: f64) {
        let last = self.values.len() - self.dimension - 1;
        self.values[last] = time;
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = (f64, &[f64])> {
        self.values.chunks_exact(self.dimension + 1).map(|one| (one[0], &one[1..]))
    }

    /// Forgets them.
    pub fn clear(&mut self) {
        self.values.clear();
    }
}
