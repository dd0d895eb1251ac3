//! What is wanted of films and safeties, as numbers that a search compares.

use lanchester_model::Engine;
use lanchester_task::{DurabilityCriterion, DurabilityWish, Measured, Unmeasured};

/// What a search makes large.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Aim {
    /// The smallest share of a limit that is reached, up to all of it.
    Limits,
    /// What is wanted at this place of the list.
    Maximise(usize),
}

/// Criteria with the parts of the engine that they are the smallest of.
pub(super) struct Wanted {
    parts: Vec<DurabilityCriterion>,
    /// Smallest value allowed, and the parts that count.
    limits: Vec<(f64, Vec<usize>)>,
    maximise: Vec<Vec<usize>>,
}

impl Wanted {
    pub fn new(engine: &Engine, wish: &DurabilityWish) -> Wanted {
        let mut wanted = Wanted { parts: Vec::new(), limits: Vec::new(), maximise: Vec::new() };
        let mains = engine.main_bearings().len();
        // What unbalances do not change is judged, not searched.
        let searched = |criterion: DurabilityCriterion| criterion.depends_on_unbalances();
        for one in wish.at_least.iter().filter(|one| searched(one.criterion)) {
            let places = wanted.places(one.criterion, mains);
            wanted.limits.push((one.least, places));
        }
        for one in wish.maximise.iter().filter(|one| searched(**one)) {
            let places = wanted.places(*one, mains);
            wanted.maximise.push(places);
        }
        wanted
    }

    /// Places of the parts of a criterion, which are added where they are new.
    fn places(&mut self, criterion: DurabilityCriterion, mains: usize) -> Vec<usize> {
        let of_mains = (0..mains).map(|index| DurabilityCriterion::MainFilm(Some(index)));
        let parts: Vec<DurabilityCriterion> = match criterion {
            DurabilityCriterion::MainFilm(None) => of_mains.collect(),
            DurabilityCriterion::LeastFilm => {
                of_mains.chain([DurabilityCriterion::CrankpinFilm(None)]).collect()
            }
            other => vec![other],
        };
        let mut place = |part: &DurabilityCriterion| {
            self.parts.iter().position(|known| known == part).unwrap_or_else(|| {
                self.parts.push(*part);
                self.parts.len() - 1
            })
        };
        parts.iter().map(&mut place).collect()
    }

    /// What is to be measured.
    pub fn parts(&self) -> &[DurabilityCriterion] {
        &self.parts
    }

    /// How many criteria are to be large.
    pub fn maximised(&self) -> usize {
        self.maximise.len()
    }

    pub fn has_limits(&self) -> bool {
        !self.limits.is_empty()
    }

    /// The first that is not known.
    pub fn missing(&self, measured: &[Measured]) -> Option<Unmeasured> {
        measured.iter().find_map(|one| match one {
            Measured::Unknown(missing) => Some(missing.clone()),
            Measured::Known { .. } => None,
        })
    }

    /// Numbers of which the smallest is to be large.
    pub fn numbers(&self, aim: Aim, values: &[f64]) -> Vec<f64> {
        match aim {
            Aim::Limits => {
                let shares = self.limits.iter().map(|(least, places)| smallest(values, places) / least);
                shares.map(|share| share.min(1.0)).collect()
            }
            Aim::Maximise(place) => self.maximise[place].iter().map(|part| values[*part]).collect(),
        }
    }

    /// The smallest of them: what is to be large.
    pub fn merit(&self, aim: Aim, values: &[f64]) -> f64 {
        self.numbers(aim, values).into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Aims that come before one.
    pub fn before(&self, aim: Aim) -> Vec<Aim> {
        let limits = self.has_limits().then_some(Aim::Limits);
        match aim {
            Aim::Limits => Vec::new(),
            Aim::Maximise(place) => limits.into_iter().chain((0..place).map(Aim::Maximise)).collect(),
        }
    }
}

fn smallest(values: &[f64], places: &[usize]) -> f64 {
    places.iter().map(|place| values[*place]).fold(f64::INFINITY, f64::min)
}

/// A smooth number a little below the smallest of several, and never above it: `-(1/p) ln SUM e^{-p v}` of their shares of the smallest.
pub(super) fn soft_smallest(numbers: &[f64], unit: f64) -> f64 {
    /// How sharply the smallest counts.
    const SHARPNESS: f64 = 25.0;
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let sum: f64 = numbers.iter().map(|number| (-SHARPNESS * (number - least) / unit).exp()).sum();
    least - unit / SHARPNESS * sum.ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_soft_smallest_lies_just_below_the_smallest() {
        let soft = soft_smallest(&[1.0, 1.0, 4.0], 1.0);
        assert!(soft < 1.0 && soft > 1.0 - 2f64.ln() / 25.0 - 1e-9, "{soft}");
        assert_eq!(soft_smallest(&[2.0], 1.0), 2.0);
    }
}
