//! Places of the trajectory that are to be evaluated, side by side in one buffer.

/// Why a place of the trajectory is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Place {
    /// It is a sample.
    Sample,
    /// For the largest values alone.
    Look,
    /// The same where something has jumped: what stands behind the jump counts.
    Behind,
}

/// Times with their states, the crank angle first.
#[derive(Debug, Clone)]
pub(crate) struct Kept {
    dimension: usize,
    /// Time and state, one after the other.
    values: Vec<f64>,
    places: Vec<Place>,
}

impl Kept {
    /// None of states of that many components.
    pub fn new(dimension: usize) -> Kept {
        Kept { dimension, values: Vec::new(), places: Vec::new() }
    }

    /// Room for so many in all.
    pub fn reserve(&mut self, count: usize) {
        self.values.reserve((count * (self.dimension + 1)).saturating_sub(self.values.len()));
        self.places.reserve(count.saturating_sub(self.places.len()));
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Time of the last one [s].
    pub fn last_time(&self) -> Option<f64> {
        (self.len() > 0).then(|| self.values[self.values.len() - self.dimension - 1])
    }

    /// A new sample at a time [s]; its state is to be filled in.
    pub fn push(&mut self, time: f64) -> &mut [f64] {
        self.push_as(Place::Sample, time)
    }

    /// A new one of any kind.
    pub fn push_as(&mut self, place: Place, time: f64) -> &mut [f64] {
        self.places.push(place);
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
    pub fn iter(&self) -> impl Iterator<Item = (Place, f64, &[f64])> {
        let states = self.values.chunks_exact(self.dimension + 1);
        states.zip(&self.places).map(|(one, place)| (*place, one[0], &one[1..]))
    }

    /// Forgets them.
    pub fn clear(&mut self) {
        self.values.clear();
        self.places.clear();
    }
}
