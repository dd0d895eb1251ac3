//! What the optimum of a box's programme says: where it goes beyond the task, and which choice lies nearest to it.

use super::choices::{Choices, Heading, Looked, ONE_PLACE, Split, Use, on_shaft, open};
use super::relaxed::corners;
use crate::problem::Problem;
use lanchester_task::BalanceTask;
use num_complex::Complex64;
use std::f64::consts::PI;

/// A device whose amount is below this share of its largest is not used.
const UNUSED: f64 = 1e-9;

/// Beyond the task by less than this share of all moving masses' loads is not beyond it.
const HOLDS: f64 = 1e-13;

/// Sums below this share of their unit have no direction.
const NOTHING: f64 = 1e-12;

/// A weight of the programme.
struct Seen {
    /// `U` [kg m].
    unbalance: Complex64,
    /// `z U` [kg m^2].
    moment: Complex64,
    looked: Looked,
    /// Plane and unbalance of each of its corners.
    corners: Vec<(f64, Complex64)>,
    /// Natural amount [kg m].
    unit: f64,
    /// Force of 1 kg m [N].
    square: f64,
}

/// A shaft of the programme.
struct SeenShaft {
    /// `S` [kg m].
    sum: Complex64,
    /// `conj(axis) S` [kg m^2].
    moment: Complex64,
    unit: f64,
    square: f64,
}

impl Seen {
    /// How far the corners are from those of a weight in one plane [kg m], and the inner corner that is nearest to it.
    fn amiss(&self, plane: f64) -> (f64, Option<f64>) {
        let count = self.corners.len();
        if count <= 2 {
            return (0.0, None);
        }
        let z = |corner: usize| self.corners[corner].0;
        let share = |corner: usize| {
            let before = if corner > 0 { (plane - z(corner - 1)) / (z(corner) - z(corner - 1)) } else { 1.0 };
            let behind =
                if corner + 1 < count { (z(corner + 1) - plane) / (z(corner + 1) - z(corner)) } else { 1.0 };
            before.min(behind).clamp(0.0, 1.0)
        };
        let amiss = |corner: usize| (self.corners[corner].1 - share(corner) * self.unbalance).norm();
        let nearest = (1..count - 1).map(z).min_by(|a, b| (a - plane).abs().total_cmp(&(b - plane).abs()));
        ((0..count).map(amiss).fold(0.0, f64::max), nearest)
    }
}

/// The directions of the parts of a sum, those that are more than rounding of `unit`.
fn looked(parts: impl Iterator<Item = Complex64>, sum: Complex64, unit: f64) -> Looked {
    let mut reach = [0.0f64; 2];
    for turn in parts.filter(|part| part.norm() > NOTHING * unit).map(|part| (part * sum.conj()).arg()) {
        reach = [reach[0].max(-turn), reach[1].max(turn)];
    }
    Looked { angle: sum.arg(), reach }
}

/// A point of a box's programme.
pub(super) struct Reading<'a> {
    task: &'a BalanceTask,
    choices: &'a Choices,
    weights: Vec<Seen>,
    shafts: Vec<SeenShaft>,
    natural_force: f64,
    natural_moment: f64,
}

impl<'a> Reading<'a> {
    pub fn of(task: &'a BalanceTask, choices: &'a Choices, problem: &Problem, x: &[f64]) -> Reading<'a> {
        let operator = &problem.operator;
        let weights: Vec<Seen> = operator
            .weights
            .iter()
            .map(|columns| {
                let parts = || columns.corners.iter().map(|c| c.unbalance(x));
                let unbalance = parts().sum();
                Seen {
                    unbalance,
                    moment: columns.corners.iter().map(|c| c.z * c.unbalance(x)).sum(),
                    looked: looked(parts(), unbalance, columns.unit),
                    corners: columns.corners.iter().map(|c| (c.z, c.unbalance(x))).collect(),
                    unit: columns.unit,
                    square: (columns.ratio.value() * operator.speed).powi(2),
                }
            })
            .collect();
        let shafts = (0..task.shafts.len())
            .map(|shaft| {
                let sum: Complex64 = on_shaft(task, shaft).map(|w| weights[w].unbalance).sum();
                let first = corners(choices, shaft)[0];
                let beyond = operator.axes.get(shaft).into_iter().flatten();
                let moment = first.conj() * sum
                    + beyond.map(|c| (c.axis - first).conj() * c.unbalance(x)).sum::<Complex64>();
                SeenShaft {
                    sum,
                    moment,
                    unit: on_shaft(task, shaft).map(|w| weights[w].unit).fold(0.0, f64::max),
                    square: (task.shafts[shaft].ratio.value() * operator.speed).powi(2),
                }
            })
            .collect();
        Reading {
            task,
            choices,
            weights,
            shafts,
            natural_force: operator.natural_force,
            natural_moment: operator.natural_moment,
        }
    }

    /// The plane that comes nearest to what a weight does.
    fn plane(&self, weight: usize) -> f64 {
        let seen = &self.weights[weight];
        let [low, high] = self.choices.weights[weight].z;
        if seen.unbalance.norm() <= NOTHING * seen.unit {
            return 0.5 * (low + high);
        }
        rounded((seen.unbalance.conj() * seen.moment).re / seen.unbalance.norm_sqr()).clamp(low, high)
    }

    /// The axis that comes nearest to what a shaft does.
    fn axis(&self, shaft: usize) -> Complex64 {
        let seen = &self.shafts[shaft];
        let choice = &self.choices.shafts[shaft];
        let axis = if seen.sum.norm() <= NOTHING * seen.unit {
            Complex64::new(0.5 * (choice.x[0] + choice.x[1]), 0.5 * (choice.y[0] + choice.y[1]))
        } else {
            (seen.moment / seen.sum).conj()
        };
        let (x, y) = (rounded(axis.re), rounded(axis.im));
        Complex64::new(x.clamp(choice.x[0], choice.x[1]), y.clamp(choice.y[0], choice.y[1]))
    }

    /// Amount of a weight as a share of its largest, of its natural one where that is not bounded.
    fn share(&self, weight: usize) -> f64 {
        let most = self.task.weights[weight].most.filter(|most| *most > 0.0);
        self.weights[weight].unbalance.norm() / most.unwrap_or(self.weights[weight].unit)
    }

    fn shaft_share(&self, shaft: usize) -> f64 {
        on_shaft(self.task, shaft).map(|w| self.share(w)).fold(0.0, f64::max)
    }

    /// How much of the optional devices that are not decided each does [share of all moving masses], the largest first.
    fn undecided(&self) -> Vec<(f64, Split)> {
        let force = |w: usize| self.weights[w].square * self.weights[w].unbalance.norm() / self.natural_force;
        let weights = self.choices.weights.iter().enumerate();
        let weights = weights
            .filter(|(w, c)| c.usage == Use::Open && self.choices.usage(self.task, *w) != Use::No)
            .map(|(w, _)| (force(w), Split::UseWeight(w)));
        let shafts = self.choices.shafts.iter().enumerate().filter(|(_, c)| c.usage == Use::Open);
        let shafts =
            shafts.map(|(s, _)| (on_shaft(self.task, s).map(force).sum::<f64>(), Split::UseShaft(s)));
        let mut all: Vec<(f64, Split)> = weights.chain(shafts).collect();
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        all
    }

    /// Whether a device counts among the optional ones.
    fn is_optional(&self, split: Split) -> bool {
        match split {
            Split::UseWeight(weight) => self.task.weights[weight].optional,
            Split::UseShaft(shaft) => self.task.shafts[shaft].optional,
            _ => false,
        }
    }

    fn is_used(&self, split: Split) -> bool {
        match split {
            Split::UseWeight(weight) => self.share(weight) > UNUSED,
            Split::UseShaft(shaft) => self.shaft_share(shaft) > UNUSED,
            _ => false,
        }
    }

    /// Whether an undecided device is used less than it may be if it is used at all.
    fn is_between(&self, split: Split) -> bool {
        let below = |weight: usize| {
            self.weights[weight].unbalance.norm() < self.choices.least(self.task, weight) * (1.0 - UNUSED)
        };
        // A fixed cost counts by the share of the largest amount until its use is decided.
        let paid_in_part = |share: f64| share < 1.0 - UNUSED;
        match split {
            Split::UseWeight(weight) => {
                below(weight) || self.task.pays_for_weight(weight) && paid_in_part(self.share(weight))
            }
            Split::UseShaft(shaft)
                if self.task.pays_for_shaft(shaft) && paid_in_part(self.shaft_share(shaft)) =>
            {
                true
            }
            Split::UseShaft(shaft) => {
                on_shaft(self.task, shaft).filter(|&w| self.choices.weights[w].usage == Use::Yes).any(below)
            }
            _ => false,
        }
    }

    /// Where the box can be divided: at the choice that the point goes farthest beyond, the widest part of it first;
    /// none where the point keeps to the task.
    pub fn splits(&self) -> Vec<Split> {
        let undecided = self.undecided();
        let used = undecided.iter().filter(|one| self.is_used(one.1));
        let optional = used.clone().filter(|one| self.is_optional(one.1));
        let left = self.task.most_optional.map(|most| most.saturating_sub(self.choices.used(self.task)));
        if left.is_some_and(|left| optional.clone().count() > left)
            && let Some(&(_, split)) = optional.clone().next()
        {
            return vec![split];
        }
        if let Some(&(_, split)) = used.clone().find(|one| self.is_between(one.1)) {
            return vec![split];
        }
        let mut worst: (f64, Vec<Split>) = (HOLDS, Vec::new());
        let mut consider = |beyond: f64, splits: Vec<Split>| {
            if beyond > worst.0 {
                worst = (beyond, splits);
            }
        };
        for weight in 0..self.weights.len() {
            if self.choices.usage(self.task, weight) == Use::No {
                continue;
            }
            let (seen, choice) = (&self.weights[weight], &self.choices.weights[weight]);
            let turn = seen.square / self.natural_force;
            let short = self.choices.least(self.task, weight) - seen.unbalance.norm();
            if let Some((beyond, at)) = self.between_amounts(weight) {
                consider(turn * beyond, vec![Split::Amount(weight, at)]);
            }
            let divisible = !matches!(choice.heading, Heading::Ray(_) | Heading::Tangent(_));
            if self.choices.usage(self.task, weight) == Use::Yes && divisible {
                consider(
                    turn * short,
                    vec![Split::Heading(weight, Looked { angle: seen.unbalance.arg(), reach: [0.0; 2] })],
                );
            }
            if open(choice.z) {
                let plane = self.plane(weight);
                let beyond =
                    (seen.moment - plane * seen.unbalance).norm() * seen.square / self.natural_moment;
                let whole = super::choices::stretch(self.task.weights[weight].z);
                let stretch = (choice.z[1] - choice.z[0]) / (whole[1] - whole[0]);
                // Corners at mains have what a weight at the plane has there, or the stretch ends at such a main.
                let (amiss, main) = seen.amiss(plane);
                let beyond = beyond.max(amiss * turn);
                let divided = main.map_or(Split::Plane(weight, plane), |main| Split::PlaneAt(weight, main));
                let mut splits = vec![divided];
                if divisible {
                    let wide = choice.heading.width() / (2.0 * PI) > 0.5 * stretch;
                    splits.insert(usize::from(!wide), Split::Heading(weight, seen.looked));
                }
                consider(beyond, splits);
            }
        }
        for shaft in 0..self.shafts.len() {
            let (seen, choice) = (&self.shafts[shaft], &self.choices.shafts[shaft]);
            if choice.usage == Use::No || !(open(choice.x) || open(choice.y)) {
                continue;
            }
            let axis = self.axis(shaft);
            let beyond = (seen.moment - axis.conj() * seen.sum).norm() * seen.square / self.natural_moment;
            consider(beyond, vec![self.axis_split(shaft, axis)]);
        }
        worst.1
    }

    /// How far the amount of a weight is from the nearest of its catalogue [kg m], and the number of the one below it; none
    /// where it is one of them, or where the box leaves one only.
    fn between_amounts(&self, weight: usize) -> Option<(f64, usize)> {
        let catalogue = self.task.weights[weight].catalogue.as_ref()?;
        let [first, last] = self.choices.weights[weight].amount;
        if first >= last {
            return None;
        }
        let amount = self.weights[weight].unbalance.norm();
        let below = catalogue.below(amount).clamp(first, last - 1);
        let next = catalogue.amount(below + 1);
        let beyond = (amount - catalogue.amount(below)).abs().min((next - amount).abs());
        Some((beyond, below))
    }

    /// Gives every weight with a catalogue the nearest amount of it, equal parts the one nearest to their mean.
    fn round_amounts(&self, chosen: &mut Choices) {
        for (weight, free) in self.task.weights.iter().enumerate() {
            let Some(catalogue) = &free.catalogue else { continue };
            let parts: Vec<usize> = (0..self.weights.len())
                .filter(|&other| {
                    let equal = free.equal_parts.is_some()
                        && self.task.weights[other].equal_parts == free.equal_parts;
                    (other == weight || equal) && chosen.weights[other].usage == Use::Yes
                })
                .collect();
            if !parts.contains(&weight) {
                continue;
            }
            let sum: f64 = parts.iter().map(|&part| self.weights[part].unbalance.norm()).sum();
            let [first, last] = chosen.weights[weight].amount;
            let nearest = catalogue.nearest(sum / parts.len() as f64).clamp(first, last);
            chosen.weights[weight].amount = [nearest; 2];
        }
        for (choice, free) in chosen.weights.iter_mut().zip(&self.task.weights) {
            if free.catalogue.is_some() && choice.amount[1] == 0 {
                choice.usage = Use::No;
            }
        }
    }

    /// The larger of stretch and sector, both as shares of all of them.
    fn axis_split(&self, shaft: usize, axis: Complex64) -> Split {
        let choice = &self.choices.shafts[shaft];
        let free = &self.task.shafts[shaft];
        let share = |part: [f64; 2], whole: [f64; 2]| {
            if open(whole) { (part[1] - part[0]) / (whole[1] - whole[0]) } else { 0.0 }
        };
        let x = share(choice.x, super::choices::stretch(free.x));
        let y = share(choice.y, super::choices::stretch(free.y));
        let looked = Looked { angle: self.shafts[shaft].sum.arg(), reach: [0.0; 2] };
        // The sector of a single weight is that of the shaft.
        let (heading, split) = match self.choices.only_weight(self.task, shaft) {
            Some(only) => (self.choices.weights[only].heading, Split::Heading(only, looked)),
            None => (choice.heading, Split::ShaftHeading(shaft, looked)),
        };
        let divisible = !matches!(heading, Heading::Ray(_) | Heading::Tangent(_));
        if divisible && heading.width() / (2.0 * PI) > 0.5 * x.max(y) {
            split
        } else if x >= y {
            Split::AxisX(shaft, axis.re)
        } else {
            Split::AxisY(shaft, axis.im)
        }
    }

    /// The choice nearest to the point: every use decided, every place one, least amounts in a convex part.
    pub fn nearest(&self) -> Choices {
        let mut chosen = self.choices.clone();
        let left = self.task.most_optional.map(|most| most.saturating_sub(chosen.used(self.task)));
        let undecided = self.undecided();
        let mut rank = 0;
        for &(_, split) in &undecided {
            let mut far = false;
            if let Split::UseWeight(weight) = split {
                far = self.weights[weight].unbalance.norm() < 0.5 * self.choices.least(self.task, weight);
            }
            let counts = self.is_optional(split);
            let fits = !counts || left.is_none_or(|left| rank < left);
            rank += usize::from(counts);
            let wanted = fits && self.is_used(split) && !far;
            let usage = if wanted { Use::Yes } else { Use::No };
            match split {
                Split::UseShaft(shaft) => chosen.shafts[shaft].usage = usage,
                Split::UseWeight(weight) => chosen.weights[weight].usage = usage,
                _ => {}
            }
        }
        for choice in &mut chosen.weights {
            if choice.usage == Use::Open {
                choice.usage = Use::No;
            }
        }
        self.round_amounts(&mut chosen);
        for shaft in 0..chosen.shafts.len() {
            let axis = self.axis(shaft);
            chosen.shafts[shaft].x = [axis.re; 2];
            chosen.shafts[shaft].y = [axis.im; 2];
        }
        for weight in 0..chosen.weights.len() {
            chosen.weights[weight].z = [self.plane(weight); 2];
            let unbalance = self.weights[weight].unbalance;
            let heading = self.choices.weights[weight].heading;
            let bound = chosen.least(self.task, weight) > 0.0 && chosen.usage(self.task, weight) == Use::Yes;
            let angle = heading.nearest(unbalance.arg());
            chosen.weights[weight].heading = match heading {
                Heading::Ray(_) | Heading::Tangent(_) => heading,
                Heading::Line(_) if bound => Heading::Ray(angle),
                Heading::Line(_) => heading,
                Heading::Any | Heading::Sector { .. } if !bound => Heading::Any,
                Heading::Any | Heading::Sector { .. } if chosen.given(self.task, weight) => {
                    Heading::Ray(angle)
                }
                Heading::Any | Heading::Sector { .. } => Heading::Tangent(angle),
            };
        }
        for choice in &mut chosen.shafts {
            choice.heading = Heading::Any;
        }
        chosen
    }

    /// The places of `moved` with the phases as free as they are; tangents touch where the weights stand.
    pub fn freed(&self, mut moved: Choices) -> Choices {
        let own = self.choices.weights.iter().zip(&self.weights);
        for (choice, (own, seen)) in moved.weights.iter_mut().zip(own) {
            choice.heading = match own.heading {
                Heading::Tangent(_) => Heading::Tangent(seen.unbalance.arg()),
                heading => heading,
            };
        }
        moved
    }

    /// All places open again as far as the task allows, all phases as they are: a box whose programme is exact.
    pub fn along(&self, everywhere: &Choices) -> Choices {
        let mut chosen = self.choices.clone();
        for (choice, whole) in chosen.shafts.iter_mut().zip(&everywhere.shafts) {
            (choice.x, choice.y) = (whole.x, whole.y);
        }
        for (index, (choice, whole)) in chosen.weights.iter_mut().zip(&everywhere.weights).enumerate() {
            choice.z = whole.z;
            let seen = &self.weights[index];
            if seen.unbalance.norm() > NOTHING * seen.unit {
                choice.heading = Heading::Ray(seen.unbalance.arg());
            }
        }
        chosen
    }
}

/// A place without the digits that are rounding.
fn rounded(place: f64) -> f64 {
    (place / ONE_PLACE).round() * ONE_PLACE
}
