//! Stretches of the cycle without a jump: their ends move with the input where a pressure jumps (book, eq. 32.6).

use super::gas_force::Window;
use super::over_time::known;
use super::train::Train;
use lanchester_numerics::{GAUSS_4, unit_points};
use num_dual::Dual64;
use std::f64::consts::TAU;

/// Jumps closer than this are at one angle [rad].
const SAME: f64 = 1e-9;
/// How far beside jumps at one angle those that are passed and those that are not are told apart [rad].
const APART: f64 = 1e-7;
/// Widest part of a quadrature [rad].
const WIDEST: f64 = 0.05;
/// A stretch of the cycle in which all loads are smooth.
pub(super) struct Stretch {
    pub from: Dual64,
    pub to: Dual64,
    /// By cylinder: where its pressures are read.
    pub windows: Vec<Window>,
    /// Shares of the stretch at which parts of a quadrature end, from 0 to 1.
    pub cuts: Vec<f64>,
}

/// A jump of the pressure of one cylinder.
struct Break {
    theta: Dual64,
    cylinder: usize,
}

impl Stretch {
    /// The angle at a share of the stretch.
    pub fn theta(&self, share: f64) -> Dual64 {
        self.from + (self.to - self.from) * share
    }

    /// Whether it is more than a jump among jumps at one angle.
    pub fn is_wide(&self) -> bool {
        self.to.re > self.from.re
    }

    /// Angles and weights of a quadrature from the share `from` of the stretch to the share `to`.
    pub fn points(&self, from: f64, to: f64) -> impl Iterator<Item = (Dual64, Dual64)> {
        let whole = self.to - self.from;
        unit_points(&GAUSS_4)
            .map(move |(x, weight)| (self.theta(from + (to - from) * x), whole * ((to - from) * weight)))
    }

    /// Integral over the stretch.
    pub fn integral(&self, function: impl Fn(Dual64) -> Dual64) -> Dual64 {
        let parts = self.cuts.windows(2).flat_map(|pair| self.points(pair[0], pair[1]));
        parts.map(|(theta, weight)| function(theta) * weight).sum()
    }
}

/// The stretches of a period of `train`, in order.
pub(super) fn stretches(train: &Train<'_>) -> Vec<Stretch> {
    let period = train.prepared.period;
    let breaks = breaks(train, period);
    let knots = knots(train, period);
    let Some(first) = breaks.first() else {
        let free = vec![[f64::NEG_INFINITY, f64::INFINITY]; train.prepared.gas.len()];
        return vec![stretch(known(0.0), known(period), free, &knots, period)];
    };
    let end = first.theta + period;
    (0..breaks.len())
        .map(|place| {
            let from = breaks[place].theta;
            let to = breaks.get(place + 1).map_or(end, |next| next.theta);
            let windows = (0..train.prepared.gas.len())
                .map(|cylinder| {
                    let middle = 0.5 * (from.re + to.re);
                    let aside = if to.re > from.re { 0.0 } else { side_of(&breaks, place, cylinder) };
                    window(train, cylinder, train.own_angle(cylinder, known(middle)).re + aside)
                })
                .collect();
            stretch(from, to, windows, &knots, period)
        })
        .collect()
}

fn stretch(from: Dual64, to: Dual64, windows: Vec<Window>, knots: &[f64], period: f64) -> Stretch {
    let width = to.re - from.re;
    let mut cuts = vec![0.0, 1.0];
    if width > 0.0 {
        let parts = (width / WIDEST).ceil();
        cuts.extend((1..parts as usize).map(|k| k as f64 / parts));
        let turned = knots.iter().flat_map(|knot| [*knot, knot + period]);
        cuts.extend(turned.map(|knot| (knot - from.re) / width).filter(|share| *share > 0.0 && *share < 1.0));
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|next, cut| *next - *cut <= 1e-9);
        if let Some(last) = cuts.last_mut() {
            *last = 1.0;
        }
    }
    Stretch { from, to, windows, cuts }
}

/// Whether `cylinder` has passed its jump at an angle where several jump, `place` being the last that has: as a small angle.
fn side_of(breaks: &[Break], place: usize, cylinder: usize) -> f64 {
    let at = breaks[place].theta.re;
    let own = breaks.iter().position(|b| b.cylinder == cylinder && b.theta.re == at);
    match own {
        None => 0.0,
        Some(own) if own <= place => APART,
        Some(_) => -APART,
    }
}

/// Where the pressures of a cylinder are smooth about the angle `own` since firing [rad].
fn window(train: &Train<'_>, cylinder: usize, own: f64) -> Window {
    let gas = &train.prepared.gas[cylinder];
    let Some(&first) = gas.breaks.first() else { return [f64::NEG_INFINITY, f64::INFINITY] };
    let cycle = gas.pressures.cylinder.period();
    let turns = ((own - first) / cycle).floor() * cycle;
    let within = own - turns;
    let next = gas.breaks.partition_point(|knot| *knot <= within);
    let from = gas.breaks[next.max(1) - 1];
    let to = gas.breaks.get(next).copied().unwrap_or(first + cycle);
    [from + turns, to + turns]
}

/// Angles of `theta` [rad] in a period at which the pressures of a cylinder stand at `own` since firing.
fn angles(train: &Train<'_>, cylinder: usize, own: f64, period: f64) -> impl Iterator<Item = Dual64> {
    let gas = &train.prepared.gas[cylinder];
    let (cycle, rate, firing) = (gas.pressures.cylinder.period(), gas.rate, train.firing[cylinder]);
    let cycles = (period * rate / cycle).round() as usize;
    (0..cycles).map(move |k| {
        let theta = firing + (own + cycle * k as f64) / rate;
        let turned = theta.re.rem_euclid(period);
        Dual64::new(if turned > period - SAME { 0.0 } else { turned }, theta.eps)
    })
}

/// All jumps of a period, rising; of those at one angle the ones that come first on the side that is looked at.
fn breaks(train: &Train<'_>, period: f64) -> Vec<Break> {
    let gas = train.prepared.gas.iter().enumerate();
    let mut breaks: Vec<Break> = gas
        .flat_map(|(cylinder, gas)| gas.breaks.iter().map(move |own| (cylinder, *own)))
        .flat_map(|(cylinder, own)| {
            angles(train, cylinder, own, period).map(move |theta| Break { theta, cylinder })
        })
        .collect();
    breaks.sort_by(|a, b| a.theta.re.total_cmp(&b.theta.re));
    for place in 1..breaks.len() {
        let before = breaks[place - 1].theta.re;
        if breaks[place].theta.re - before <= SAME {
            breaks[place].theta.re = before;
        }
    }
    let sign = train.side.sign();
    breaks.sort_by(|a, b| {
        a.theta.re.total_cmp(&b.theta.re).then((sign * a.theta.eps).total_cmp(&(sign * b.theta.eps)))
    });
    breaks
}

/// All knots of a period [rad], at which pressures have no jump but another cubic.
fn knots(train: &Train<'_>, period: f64) -> Vec<f64> {
    let gas = train.prepared.gas.iter().enumerate();
    let mut knots: Vec<f64> = gas
        .flat_map(|(cylinder, gas)| gas.knots.iter().map(move |own| (cylinder, *own)))
        .flat_map(|(cylinder, own)| angles(train, cylinder, own, period).map(|theta| theta.re))
        .collect();
    knots.sort_by(f64::total_cmp);
    knots.dedup_by(|next, knot| *next - *knot <= SAME);
    knots
}

/// Parts of a revolution in which a hill is looked for.
const SCAN: f64 = 720.0;

impl Stretch {
    /// Into how many parts it is cut to look for hills.
    pub fn scanned(&self) -> usize {
        ((self.to.re - self.from.re) * SCAN / TAU).ceil().max(1.0) as usize
    }
}
