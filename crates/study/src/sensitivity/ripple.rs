//! Fluctuation of the speed over the cycle, with the derivative by one input (book, eq. 32.11).
//!
//! ```text
//! w^2 = 2 (C + W)/J        W(theta) = INTEGRAL of (T_gas - T_mean)        J = 2 E_kin/W_1^2 of all that moves at the speed W_1
//! 0 = G(C, p) = INTEGRAL of dtheta/w - P/w_mean        dC/dp = -(dG/dp)/(dG/dC)        C_s = (w_max - w_min)/w_mean
//! ```

use super::gas_force::Window;
use super::quantity::Quantity;
use super::slope::Grown;
use super::stretch::Stretch;
use super::train::Train;
use super::wave::{SAME_HEIGHT, crossing};
use lanchester_numerics::{GAUSS_4, unit_points};
use num_dual::{Dual64, DualNum};

/// Share of the range of the squares of the speed that hills may fall short of the highest.
const HILL: f64 = 0.02;

/// A part of a stretch, and what the gas has done before it.
struct Part {
    /// Number of its stretch among all, and its ends as shares of it.
    stretch: usize,
    ends: [f64; 2],
    work: Dual64,
}

/// A point of a quadrature.
struct Point {
    weight: Dual64,
    /// Twice what the gas has done beyond its mean [J].
    rise: Dual64,
    inertia: Dual64,
}

/// A place where the speed is highest or lowest.
#[derive(Debug, Clone, Copy)]
struct RippleSpot {
    part: usize,
    share: f64,
}

/// Where the speed is highest and where it is lowest.
pub(super) struct RippleSpots {
    highest: Vec<RippleSpot>,
    lowest: Vec<RippleSpot>,
}

/// The periodic speed of a train.
pub(super) struct Ripple<'a> {
    train: &'a Train<'a>,
    stretches: &'a [Stretch],
    parts: Vec<Part>,
    start: Dual64,
    mean: Dual64,
    /// Twice `C` [J].
    constant: Dual64,
}

impl Train<'_> {
    /// Inertia of all that moves, seen at crankshaft 1 [kg m^2].
    fn inertia(&self, theta: Dual64) -> Dual64 {
        let turning = self.prepared.point.turning.known();
        let given = self.of(Quantity::FlywheelInertia, 0, turning.flywheel)
            + self.of(Quantity::CrankshaftInertia, 0, turning.crankshaft);
        let energy = |index: usize| {
            let rod = self.rod(theta, index);
            let [big, small, inertia, piston] = rod.masses;
            let square = |[x, y]: [super::over_time::OverTime; 2]| x.v1 * x.v1 + y.v1 * y.v1;
            big * square(rod.big_end)
                + small * square(rod.pin)
                + piston * square(rod.piston)
                + inertia * rod.spin[0] * rod.spin[0]
        };
        let twice = (0..self.engine.cylinders.len()).map(energy).sum::<Dual64>();
        given + Dual64::from(self.engine.geared_inertia()) + twice / (self.speed * self.speed)
    }
}

/// Weights of integrals from 0 to each of the points of the rule, exact for cubics.
fn running() -> [[f64; 4]; 4] {
    let points: Vec<(f64, f64)> = unit_points(&GAUSS_4).collect();
    let lagrange = |j: usize, x: f64| {
        let others = (0..4).filter(|k| *k != j);
        others.map(|k| (x - points[k].0) / (points[j].0 - points[k].0)).product::<f64>()
    };
    std::array::from_fn(|i| {
        let end = points[i].0;
        std::array::from_fn(|j| points.iter().map(|(x, w)| end * w * lagrange(j, end * x)).sum())
    })
}

impl<'a> Ripple<'a> {
    pub fn of(train: &'a Train<'a>, stretches: &'a [Stretch]) -> Ripple<'a> {
        let start = stretches.first().map_or(Dual64::new(0.0, 0.0), |stretch| stretch.from);
        let running = running();
        let mut work = Dual64::new(0.0, 0.0);
        let mut parts = Vec::new();
        let mut points: Vec<(Dual64, Dual64, Dual64, Dual64)> = Vec::new();
        for (number, stretch) in stretches.iter().enumerate() {
            for pair in stretch.cuts.windows(2) {
                parts.push(Part { stretch: number, ends: [pair[0], pair[1]], work });
                let width = (stretch.to - stretch.from) * (pair[1] - pair[0]);
                let own: Vec<(Dual64, Dual64)> = stretch.points(pair[0], pair[1]).collect();
                let torque: Vec<Dual64> =
                    own.iter().map(|(theta, _)| train.gas_torque(*theta, &stretch.windows)).collect();
                for ((theta, weight), row) in own.iter().zip(&running) {
                    let within = torque.iter().zip(row).map(|(t, w)| *t * *w).sum::<Dual64>() * width;
                    points.push((*theta, *weight, work + within, train.inertia(*theta)));
                }
                work += own.iter().zip(&torque).map(|((_, weight), t)| *t * *weight).sum::<Dual64>();
            }
        }
        let mean = work / train.prepared.period;
        let points: Vec<Point> = points
            .into_iter()
            .map(|(theta, weight, work, inertia)| Point {
                weight,
                rise: (work - mean * (theta - start)) * 2.0,
                inertia,
            })
            .collect();
        let constant = constant(&points, train.prepared.period, train.speed);
        Ripple { train, stretches, parts, start, mean, constant }
    }

    /// Square of the speed at a place of a part.
    fn square(&self, spot: RippleSpot) -> Dual64 {
        let part = &self.parts[spot.part];
        let stretch = &self.stretches[part.stretch];
        let theta = stretch.theta(spot.share);
        (self.constant + self.rise(part, stretch, spot.share)) / self.train.inertia(theta)
    }

    fn rise(&self, part: &Part, stretch: &Stretch, share: f64) -> Dual64 {
        let torque = |theta: Dual64| self.train.gas_torque(theta, &stretch.windows);
        let points = stretch.points(part.ends[0], share);
        let work = points.map(|(theta, weight)| torque(theta) * weight).sum::<Dual64>();
        (part.work + work - self.mean * (stretch.theta(share) - self.start)) * 2.0
    }

    /// What the square of the speed rises with at a place, times the square of the inertia; no input may move anything.
    fn slope_by_angle(&self, part: &Part, share: f64) -> f64 {
        let stretch = &self.stretches[part.stretch];
        let windows: &[Window] = &stretch.windows;
        let theta = stretch.theta(share).re;
        let torque = self.train.gas_torque(Dual64::new(theta, 0.0), windows).re - self.mean.re;
        let inertia = self.train.inertia(Dual64::new(theta, 1.0));
        let level = self.constant.re + self.rise(part, stretch, share).re;
        2.0 * torque * inertia.re - level * inertia.eps
    }

    /// Where the speed is highest and lowest; no input may move anything.
    pub fn spots(&self) -> RippleSpots {
        let is_wide = |part: &Part| self.stretches[part.stretch].is_wide();
        let ends: Vec<RippleSpot> = (0..self.parts.len())
            .filter(|place| is_wide(&self.parts[*place]))
            .flat_map(|part| self.parts[part].ends.map(|share| RippleSpot { part, share }))
            .collect();
        let squares: Vec<f64> = ends.iter().map(|spot| self.square(*spot).re).collect();
        let most = squares.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = squares.iter().copied().fold(f64::INFINITY, f64::min);
        let close = HILL * (most - least);
        let near = |level: f64, sign: f64| {
            let mut found: Vec<(f64, RippleSpot)> = Vec::new();
            for (pair, squares) in ends.chunks(2).zip(squares.chunks(2)) {
                if squares.iter().all(|square| (square - level).abs() > close) {
                    continue;
                }
                let part = &self.parts[pair[0].part];
                let slope = |share: f64| self.slope_by_angle(part, share);
                let top = crossing(&slope, part.ends[0], part.ends[1]);
                let tops = top.map(|share| RippleSpot { share, ..pair[0] });
                let spots = tops.into_iter().chain([pair[0], pair[1]]);
                found.extend(spots.map(|spot| (sign * self.square(spot).re, spot)));
            }
            let best = found.iter().map(|(height, _)| *height).fold(f64::NEG_INFINITY, f64::max);
            found.retain(|(height, _)| best - height <= SAME_HEIGHT * (most - least));
            found.into_iter().map(|(_, spot)| spot).collect()
        };
        RippleSpots { highest: near(most, 1.0), lowest: near(least, -1.0) }
    }

    /// Slope of the fluctuation between these spots.
    pub fn slope(&self, spots: &RippleSpots) -> Grown {
        let speed = |spot: &RippleSpot| self.square(*spot).sqrt();
        let first = |spots: &[RippleSpot]| spots.first().map_or(0.0, |spot| speed(spot).re);
        let range = first(&spots.highest) - first(&spots.lowest);
        let highest = Grown::of_largest(spots.highest.iter().map(|spot| Grown::of_number(speed(spot))));
        let lowest = spots.lowest.iter().map(|spot| Grown::of_number(speed(spot)).negative());
        let both = highest.plus(Grown::of_largest(lowest));
        let by_mean = Grown::of_number(self.train.speed.recip() * range);
        both.times(1.0 / self.train.speed.re).plus(by_mean)
    }
}

/// Twice `C`, with which the speed has its mean: by halving, then its derivative through the equation.
fn constant(points: &[Point], period: f64, speed: Dual64) -> Dual64 {
    let lowest = points.iter().map(|point| point.rise.re).fold(f64::INFINITY, f64::min);
    let most = points.iter().map(|point| point.rise.re).fold(f64::NEG_INFINITY, f64::max);
    let heaviest = points.iter().map(|point| point.inertia.re).fold(0.0, f64::max);
    let beyond = |x: Dual64| {
        let time = |point: &Point| point.weight * (point.inertia / (point.rise + x)).sqrt();
        points.iter().map(time).sum::<Dual64>() - speed.recip() * period
    };
    let (mut low, mut high) = (-lowest, heaviest * speed.re * speed.re - lowest + (most - lowest));
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if beyond(Dual64::new(middle, 0.0)).re > 0.0 { low = middle } else { high = middle }
    }
    let here = beyond(Dual64::new(high, 0.0)).eps;
    let by_constant = beyond(Dual64::new(high, 1.0)).eps - here;
    Dual64::new(high, -here / by_constant)
}
