//! A load over the cycle as a vector: where its peaks stand, and how fast peaks, means and orders change.

use super::gas_force::Window;
use super::slope::Grown;
use super::stretch::Stretch;
use num_dual::{Dual64, DualNum};
use std::f64::consts::TAU;

/// Peaks that differ by less than this share are one height.
pub(super) const SAME_HEIGHT: f64 = 1e-9;
/// Samples below this share of the highest are no hills of interest.
const HILL: f64 = 0.95;
/// Halvings of an interval in which a root lies.
const STEPS: usize = 60;

/// Jumps that part by no more than this are at one angle still [rad].
const PARTED: f64 = 1e-9;

/// Valleys below this share of the highest size are narrow.
const VALLEY: f64 = 0.2;
/// How close cuts draw to a valley [rad], and in how many steps they widen by four.
const NEAREST: f64 = 1e-6;
const FINER: i32 = 8;

/// A load at one angle: up to three components, the rest zero.
pub(super) type Load = [Dual64; 3];

/// A load at an angle, its pressures read in these windows.
pub(super) type LoadAt<'a> = Box<dyn Fn(Dual64, &[Window]) -> Load + 'a>;

/// A load over the cycle.
pub(super) struct Wave<'a> {
    pub stretches: &'a [Stretch],
    pub at: LoadAt<'a>,
    /// Whether it is one number with its sign.
    pub is_number: bool,
    /// Sizes up to this are rounding.
    pub nothing: f64,
}

/// An angle of interest in the wide stretches, counted in order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spot {
    pub stretch: usize,
    pub at: SpotAt,
}

/// Where in a stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum SpotAt {
    /// At its beginning, with which it moves.
    From,
    /// At its end.
    To,
    /// At this angle within [rad].
    Within(f64),
}

impl Spot {
    /// Its angle.
    pub fn theta(self, stretch: &Stretch) -> Dual64 {
        match self.at {
            SpotAt::From => stretch.from,
            SpotAt::To => stretch.to,
            SpotAt::Within(theta) => Dual64::new(theta, 0.0),
        }
    }
}

fn size_of(load: &Load) -> f64 {
    load.iter().map(|part| part.re * part.re).sum::<f64>().sqrt()
}

/// The stretches in which an angle can be of interest.
pub(super) fn wide(stretches: &[Stretch]) -> impl Iterator<Item = &Stretch> {
    stretches.iter().filter(|stretch| stretch.is_wide())
}

impl Wave<'_> {
    fn size(&self, theta: f64, windows: &[Window]) -> f64 {
        size_of(&(self.at)(Dual64::new(theta, 0.0), windows))
    }

    /// Largest size, and all places that have it; no place where it vanishes.
    pub fn peaks(&self) -> (f64, Vec<Spot>) {
        let samples: Vec<Vec<f64>> = wide(self.stretches)
            .map(|stretch| {
                let parts = stretch.scanned();
                let at = |k: usize| stretch.theta(k as f64 / parts as f64).re;
                (0..=parts).map(|k| self.size(at(k), &stretch.windows)).collect()
            })
            .collect();
        let highest = samples.iter().flatten().copied().fold(0.0f64, f64::max);
        if highest <= self.nothing {
            return (highest, Vec::new());
        }
        let mut found: Vec<(f64, Spot)> = Vec::new();
        for (number, (stretch, sizes)) in wide(self.stretches).zip(&samples).enumerate() {
            let last = sizes.len() - 1;
            for (k, size) in sizes.iter().enumerate() {
                let beside = [sizes[k.saturating_sub(1)], sizes[(k + 1).min(last)]];
                if *size >= HILL * highest && beside.iter().all(|other| other <= size) {
                    let (height, at) = self.top(stretch, k, last);
                    found.push((height, Spot { stretch: number, at }));
                }
            }
        }
        let best = found.iter().map(|(height, _)| *height).fold(0.0f64, f64::max);
        found.retain(|(height, _)| *height >= best * (1.0 - SAME_HEIGHT));
        (best, found.into_iter().map(|(_, spot)| spot).collect())
    }

    /// Half the rate by angle of the square of the size; no input may move the load.
    fn rise(&self, theta: f64, windows: &[Window]) -> f64 {
        let load = (self.at)(Dual64::new(theta, 1.0), windows);
        load.iter().map(|part| part.re * part.eps).sum()
    }

    /// Height and place of the hill about part `k` of a stretch in `parts`: where the size has no rate, or at an end.
    fn top(&self, stretch: &Stretch, k: usize, parts: usize) -> (f64, SpotAt) {
        let theta = |k: usize| stretch.theta(k as f64 / parts as f64).re;
        let rise = |theta: f64| self.rise(theta, &stretch.windows);
        let (before, after) = (theta(k.saturating_sub(1)), theta((k + 1).min(parts)));
        let within = match crossing(&rise, before, after) {
            Some(top) if rise(before) > 0.0 => top,
            _ => theta(k),
        };
        let size = |theta: f64| self.size(theta, &stretch.windows);
        let ends = [(0, stretch.from.re, SpotAt::From), (parts, stretch.to.re, SpotAt::To)];
        let end = ends.into_iter().filter(|(place, ..)| *place == k).map(|(_, theta, at)| (size(theta), at));
        let within = (size(within), SpotAt::Within(within));
        end.fold(within, |best, end| if end.0 >= best.0 { end } else { best })
    }

    /// Places where its size has a narrow valley, such as one that touches zero: it bends there. No input may move the load.
    pub fn valleys(&self) -> Vec<Spot> {
        let mut valleys = Vec::new();
        let mut depths = Vec::new();
        let mut highest = 0.0f64;
        for (number, stretch) in wide(self.stretches).enumerate() {
            let angle = |share: f64| stretch.theta(share).re;
            for pair in stretch.cuts.windows(2) {
                let [from, to] = [angle(pair[0]), angle(pair[1])];
                highest = highest.max(self.size(from, &stretch.windows));
                let rise = |theta: f64| self.rise(theta, &stretch.windows);
                if let Some(lowest) = crossing(&rise, from, to).filter(|_| rise(to) > 0.0) {
                    valleys.push(Spot { stretch: number, at: SpotAt::Within(lowest) });
                    depths.push(self.size(lowest, &stretch.windows));
                }
            }
        }
        let deep = |(spot, depth): (Spot, f64)| (depth < VALLEY * highest).then_some(spot);
        valleys.into_iter().zip(depths).filter_map(deep).collect()
    }

    /// Mean over the period with its slope: of a number with its sign where `signed`, else of the size, which has these narrow valleys.
    pub fn mean(&self, period: f64, signed: bool, valleys: &[Spot]) -> (f64, Grown) {
        let (mut value, mut grown) = (0.0, Grown::NONE);
        let mut number = 0;
        for stretch in self.stretches {
            let own = valleys.iter().filter(|spot| stretch.is_wide() && spot.stretch == number);
            let cuts = cut_about(stretch, own.map(|spot| spot.theta(stretch).re));
            number += usize::from(stretch.is_wide());
            for (theta, weight) in cuts.windows(2).flat_map(|pair| stretch.points(pair[0], pair[1])) {
                let load = (self.at)(theta, &stretch.windows);
                let (height, own) = match signed {
                    true => (load[0].re, Grown::of_number(load[0])),
                    false => (size_of(&load), Grown::of_size(&load, self.nothing)),
                };
                value += height * weight.re;
                grown = grown.plus(own.times(weight.re)).plus(Grown::of_number(weight * height));
            }
        }
        (value / period, grown.times(1.0 / period))
    }

    /// Slope of its size at places of one height; where it vanishes everywhere, of its largest growth.
    pub fn at_peaks(&self, spots: &[Spot]) -> Grown {
        let wide: Vec<&Stretch> = wide(self.stretches).collect();
        let grown =
            |theta: Dual64, windows: &[Window]| Grown::of_size(&(self.at)(theta, windows), self.nothing);
        if spots.is_empty() {
            let points = wide.iter().flat_map(|stretch| {
                let parts = stretch.scanned();
                (0..parts).map(move |k| (*stretch, stretch.theta(k as f64 / parts as f64)))
            });
            return Grown::of_largest(points.map(|(stretch, theta)| grown(theta, &stretch.windows)));
        }
        Grown::of_largest(spots.iter().map(|spot| {
            let stretch = wide[spot.stretch];
            grown(spot.theta(stretch), &stretch.windows)
        }))
    }

    /// Whether more than `best` stands between jumps at one angle that part when the input goes by `range`.
    pub fn leaps(&self, best: f64, range: f64) -> bool {
        let is_parted = |stretch: &&Stretch| range * (stretch.to.eps - stretch.from.eps) > PARTED;
        let mut parted = self.stretches.iter().filter(|stretch| !stretch.is_wide()).filter(is_parted);
        parted.any(|stretch| {
            self.size(stretch.from.re, &stretch.windows) > best * (1.0 + SAME_HEIGHT) + self.nothing
        })
    }

    /// Coefficients of `e^{i order theta}` of its components, as cosine and sine parts: `(1/T) INTEGRAL of f e^{-i order theta}`.
    pub fn coefficients(&self, order: f64, period: f64) -> [[Dual64; 2]; 3] {
        let zero = Dual64::new(0.0, 0.0);
        let mut sum = [[zero; 2]; 3];
        // The highest order has as many parts as a revolution needs.
        let finer = (order / 16.0).ceil().max(1.0) as usize;
        for stretch in self.stretches {
            for pair in stretch.cuts.windows(2) {
                let width = (pair[1] - pair[0]) / finer as f64;
                for part in 0..finer {
                    let from = pair[0] + width * part as f64;
                    for (theta, weight) in stretch.points(from, from + width) {
                        let load = (self.at)(theta, &stretch.windows);
                        let (sin, cos) = ((theta * order).sin(), (theta * order).cos());
                        for (sum, value) in sum.iter_mut().zip(load) {
                            sum[0] += value * cos * weight;
                            sum[1] -= value * sin * weight;
                        }
                    }
                }
            }
        }
        sum.map(|parts| parts.map(|part| part / period))
    }

    /// Size of an order: of a number its amplitude, of a vector in a plane the sum of the parts that turn with the crank and against it.
    pub fn order(&self, order: f64, period: f64) -> (f64, Grown) {
        let cycles = order * period / TAU;
        if (cycles - cycles.round()).abs() > 1e-6 {
            return (0.0, Grown::NONE);
        }
        let [[xr, xi], [yr, yi], _] = self.coefficients(order, period);
        let parts = match self.is_number {
            true => vec![[xr * 2.0, xi * 2.0]],
            // x + i y: c_n = x_n + i y_n, c_-n = conj(x_n) + i conj(y_n).
            false => vec![[xr - yi, xi + yr], [xr + yi, yr - xi]],
        };
        let value = parts.iter().map(|[re, im]| re.re.hypot(im.re)).sum();
        let grown = parts.iter().map(|part| Grown::of_size(part, self.nothing));
        (value, grown.fold(Grown::NONE, Grown::plus))
    }
}

/// The cuts of a stretch, and others that draw closer and closer to the angles of narrow valleys.
fn cut_about(stretch: &Stretch, valleys: impl Iterator<Item = f64>) -> Vec<f64> {
    let width = stretch.to.re - stretch.from.re;
    let mut cuts = stretch.cuts.clone();
    for theta in valleys {
        let share = (theta - stretch.from.re) / width;
        let beside = (0..FINER).map(|k| NEAREST * 4f64.powi(k) / width);
        cuts.extend(beside.flat_map(|by| [share - by, share + by]).filter(|cut| *cut > 0.0 && *cut < 1.0));
        cuts.push(share);
    }
    cuts.sort_by(f64::total_cmp);
    cuts
}

/// A root of a number between two places where it has different signs.
pub(super) fn crossing(number: &impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> Option<f64> {
    let starts_above = number(from) > 0.0;
    if starts_above == (number(to) > 0.0) {
        return None;
    }
    for _ in 0..STEPS {
        let middle = 0.5 * (from + to);
        if (number(middle) > 0.0) == starts_above { from = middle } else { to = middle }
    }
    Some(0.5 * (from + to))
}
