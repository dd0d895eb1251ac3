//! Largest excess energy of the torque, with the derivative by one input (book, eq. 32.8).
//!
//! ```text
//! E(theta) = INTEGRAL of (T - T_mean)        d(max E - min E)/dp = dE/dp at the highest - dE/dp at the lowest
//! ```

use super::slope::Grown;
use super::stretch::Stretch;
use super::train::Train;
use super::wave::{SAME_HEIGHT, Spot, SpotAt, crossing, wide};
use num_dual::Dual64;

/// Parts of a cut in which the torque crosses its mean at most once.
const PARTS: usize = 4;

/// Where the accumulated energy is highest and where it is lowest.
pub(super) struct EnergySpots {
    highest: Vec<Spot>,
    lowest: Vec<Spot>,
}

/// The torque of a train with its mean and the energy at the beginning of each wide stretch.
pub(super) struct Energy<'a> {
    train: &'a Train<'a>,
    stretches: &'a [Stretch],
    mean: Dual64,
    before: Vec<Dual64>,
}

impl<'a> Energy<'a> {
    pub fn of(train: &'a Train<'a>, stretches: &'a [Stretch]) -> Energy<'a> {
        let work: Vec<Dual64> = stretches
            .iter()
            .map(|stretch| stretch.integral(|theta| train.torque(theta, &stretch.windows)))
            .collect();
        let mean = work.iter().copied().sum::<Dual64>() / train.prepared.period;
        let mut energy = Dual64::new(0.0, 0.0);
        let mut before = Vec::new();
        for (stretch, work) in stretches.iter().zip(&work) {
            if stretch.is_wide() {
                before.push(energy);
            }
            energy += *work - mean * (stretch.to - stretch.from);
        }
        Energy { train, stretches, mean, before }
    }

    /// Torque beyond its mean.
    fn beyond(&self, stretch: &Stretch, theta: Dual64) -> Dual64 {
        self.train.torque(theta, &stretch.windows) - self.mean
    }

    /// Energy at a spot.
    fn at(&self, spot: Spot) -> Dual64 {
        let Some(stretch) = wide(self.stretches).nth(spot.stretch) else { return Dual64::new(0.0, 0.0) };
        let share = match spot.at {
            SpotAt::From => 0.0,
            SpotAt::To => 1.0,
            SpotAt::Within(theta) => (theta - stretch.from.re) / (stretch.to.re - stretch.from.re),
        };
        let cuts = stretch.cuts.iter().copied().filter(|cut| *cut < share).chain([share]);
        let cuts: Vec<f64> = cuts.collect();
        let points = cuts.windows(2).flat_map(|pair| stretch.points(pair[0], pair[1]));
        let work = points.map(|(theta, weight)| self.beyond(stretch, theta) * weight).sum::<Dual64>();
        self.before[spot.stretch] + work
    }

    /// Where it is highest and lowest, and by how much these differ; every place where that is rounding.
    pub fn spots(&self, nothing: f64) -> (f64, EnergySpots) {
        let all: Vec<(f64, Spot)> = self.candidates().map(|spot| (self.at(spot).re, spot)).collect();
        let most = all.iter().map(|(energy, _)| *energy).fold(f64::NEG_INFINITY, f64::max);
        let least = all.iter().map(|(energy, _)| *energy).fold(f64::INFINITY, f64::min);
        let excess = most - least;
        let close = if excess <= nothing { excess } else { SAME_HEIGHT * excess };
        let near = |level: f64| {
            let close = all.iter().filter(|(energy, _)| (energy - level).abs() <= close);
            close.map(|(_, spot)| *spot).collect()
        };
        (excess, EnergySpots { highest: near(most), lowest: near(least) })
    }

    /// The ends of stretches, and where the torque crosses its mean.
    fn candidates(&self) -> impl Iterator<Item = Spot> {
        wide(self.stretches).enumerate().flat_map(move |(number, stretch)| {
            let beyond = |share: f64| self.beyond(stretch, Dual64::new(stretch.theta(share).re, 0.0)).re;
            let parts = stretch.cuts.windows(2).flat_map(|pair| {
                let width = (pair[1] - pair[0]) / PARTS as f64;
                (0..PARTS).map(move |k| [pair[0] + width * k as f64, pair[0] + width * (k + 1) as f64])
            });
            let crossings = parts.filter_map(|[from, to]| crossing(&beyond, from, to));
            let within = crossings.map(|share| SpotAt::Within(stretch.theta(share).re));
            let spots: Vec<SpotAt> = within.chain([SpotAt::From, SpotAt::To]).collect();
            spots.into_iter().map(move |at| Spot { stretch: number, at })
        })
    }

    /// Slope of the excess energy between these spots.
    pub fn slope(&self, spots: &EnergySpots) -> Grown {
        let at = |spot: &Spot| Grown::of_number(self.at(*spot));
        let highest = Grown::of_largest(spots.highest.iter().map(at));
        let lowest = Grown::of_largest(spots.lowest.iter().map(|spot| at(spot).negative()));
        highest.plus(lowest)
    }
}
