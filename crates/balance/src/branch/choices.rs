//! Branch-and-bound nodes: which devices are used, in what stretch each stands, in what sector its phase lies.

use lanchester_numerics::about_zero;
use lanchester_task::{BalanceTask, Phase, Place, Seat};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

/// Stretches shorter than this are one place [m].
pub(super) const ONE_PLACE: f64 = 1e-12;

/// Amounts that differ by less than this share are one.
const ONE_AMOUNT: f64 = 1e-12;

/// A sector is split at its middle or, where the phase looked for is this close to it (as a share of the sector), beside
/// it: what is looked for then lies inside one half and not on the edge of both.
const CLOSE: f64 = 0.1;

/// A narrow part of a sector has this share of what is looked for.
const INSIDE: f64 = 0.25;

/// Directions that are closer than this are one [rad].
const ONE_DIRECTION: f64 = 1e-9;

/// Whether a device that may be left out is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    Yes,
    No,
    /// Not decided.
    Open,
}

/// Directions that an unbalance may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Heading {
    /// Every direction.
    Any,
    /// From `start` on through `width`, at most half a turn [rad].
    Sector { start: f64, width: f64 },
    /// Along this direction or opposite.
    Line(f64),
    /// Along this direction.
    Ray(f64),
    /// Beyond the tangent of the circle of the least amount at this direction: a convex part of what is allowed.
    Tangent(f64),
}

/// What is chosen for a weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct WeightChoice {
    pub usage: Use,
    /// Its plane lies from the first to the second [m].
    pub z: [f64; 2],
    pub heading: Heading,
    /// Numbers of the least and of the largest amount of its catalogue, if it has one.
    pub amount: [usize; 2],
}

/// What is chosen for a shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ShaftChoice {
    pub usage: Use,
    /// Its axis lies from the first to the second [m].
    pub x: [f64; 2],
    pub y: [f64; 2],
    /// Direction of the sum of its weights.
    pub heading: Heading,
}

/// A box of choices.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Choices {
    pub weights: Vec<WeightChoice>,
    pub shafts: Vec<ShaftChoice>,
    /// The inertia that may be used, by index.
    pub inertia: Option<usize>,
}

/// How a box is divided.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Split {
    UseWeight(usize),
    UseShaft(usize),
    /// Weight, number of the amount of its catalogue that ends the lower part.
    Amount(usize, usize),
    Plane(usize, f64),
    /// Weight, the plane where its stretch ends and another begins.
    PlaneAt(usize, f64),
    /// Weight, directions looked for.
    Heading(usize, Looked),
    AxisX(usize, f64),
    AxisY(usize, f64),
    ShaftHeading(usize, Looked),
}

/// Directions that the point of a box has at the ends of a stretch or area, about the one that they add up to.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Looked {
    /// Direction of the sum [rad].
    pub angle: f64,
    /// How far the directions reach before it and after it [rad], neither negative.
    pub reach: [f64; 2],
}

pub(super) fn stretch(place: Place) -> [f64; 2] {
    match place {
        Place::At(value) => [value; 2],
        Place::Between(low, high) => [low, high],
    }
}

/// Whether a stretch is more than one place.
pub(super) fn open(stretch: [f64; 2]) -> bool {
    stretch[1] - stretch[0] > ONE_PLACE
}

/// Whether a weight may be left out: it is optional, or its use costs something and nothing asks for a least amount of it.
fn may_leave(task: &BalanceTask, weight: usize) -> bool {
    let own = &task.weights[weight];
    own.optional || own.least == 0.0 && task.pays_for_weight(weight)
}

/// Whether a shaft may be left out: it is optional, or its use costs something and nothing on it must be there.
fn may_leave_shaft(task: &BalanceTask, shaft: usize) -> bool {
    let needed = |weight: usize| task.weights[weight].least > 0.0 && !task.weights[weight].optional;
    task.shafts[shaft].optional || task.pays_for_shaft(shaft) && !on_shaft(task, shaft).any(needed)
}

/// Numbers of the amounts of a catalogue that a weight may have if it is used.
fn amounts(task: &BalanceTask, weight: usize) -> [usize; 2] {
    let may_go = may_leave(task, weight);
    let weight = &task.weights[weight];
    let Some(catalogue) = &weight.catalogue else { return [0, usize::MAX] };
    let below = catalogue.below(weight.least);
    // Left out is a choice of its own.
    let first = match weight.least > 0.0 {
        true if catalogue.amount(below) >= weight.least * (1.0 - ONE_AMOUNT) => below,
        true => below + 1,
        false => usize::from(may_go),
    };
    [first, weight.most.map_or(catalogue.last(), |most| catalogue.below(most))]
}

/// Weights on a shaft.
pub(super) fn on_shaft(task: &BalanceTask, shaft: usize) -> impl Iterator<Item = usize> + '_ {
    (0..task.weights.len()).filter(move |&w| task.weights[w].seat == Seat::Shaft(shaft))
}

impl Choices {
    /// All choices of a task, one box for each inertia that may be used.
    pub fn of(task: &BalanceTask) -> Vec<Choices> {
        let usage = |optional: bool| if optional { Use::Open } else { Use::Yes };
        let weights = task
            .weights
            .iter()
            .enumerate()
            .map(|(index, weight)| WeightChoice {
                usage: usage(may_leave(task, index)),
                z: stretch(weight.z),
                heading: match weight.phase {
                    Phase::Free => Heading::Any,
                    Phase::Line(angle) => Heading::Line(angle),
                    Phase::Direction(angle) => Heading::Ray(angle),
                },
                amount: amounts(task, index),
            })
            .collect();
        let shafts = task
            .shafts
            .iter()
            .enumerate()
            .map(|(index, shaft)| ShaftChoice {
                usage: usage(may_leave_shaft(task, index)),
                x: stretch(shaft.x),
                y: stretch(shaft.y),
                heading: Heading::Any,
            })
            .collect();
        let all = Choices { weights, shafts, inertia: None };
        let needed = task.inertias.iter().position(|inertia| !inertia.optional);
        let inertias: Vec<Option<usize>> = match needed {
            Some(index) => vec![Some(index)],
            // None at all is the same as one of nothing, unless it counts.
            None if task.inertias.is_empty() => vec![None],
            None => {
                let none = task.most_optional.map(|_| None);
                none.into_iter().chain((0..task.inertias.len()).map(Some)).collect()
            }
        };
        let with = |inertia| Choices { inertia, ..all.clone() };
        inertias.into_iter().map(with).filter_map(|choices| choices.settled(task)).collect()
    }

    /// Least amount of a weight that is used [kg m].
    pub fn least(&self, task: &BalanceTask, weight: usize) -> f64 {
        let own = &task.weights[weight];
        own.catalogue.as_ref().map_or(own.least, |own| own.amount(self.weights[weight].amount[0]))
    }

    /// Largest amount of a weight [kg m].
    pub fn most(&self, task: &BalanceTask, weight: usize) -> Option<f64> {
        let own = &task.weights[weight];
        match &own.catalogue {
            Some(catalogue) => {
                Some(catalogue.amount(self.weights[weight].amount[1])).filter(|most| most.is_finite())
            }
            None => own.most,
        }
    }

    /// Whether the least amount of a weight is its largest.
    pub fn given(&self, task: &BalanceTask, weight: usize) -> bool {
        let least = self.least(task, weight);
        self.most(task, weight).is_some_and(|most| most - least <= ONE_AMOUNT * most && most > 0.0)
    }

    /// Whether more than one amount of the catalogue of a weight is left.
    pub fn has_amounts(&self, task: &BalanceTask, weight: usize) -> bool {
        let [first, last] = self.weights[weight].amount;
        task.weights[weight].catalogue.is_some() && first < last
    }

    /// The next larger or smaller amount of the catalogue for a weight with one amount, and for the parts that are equal to it.
    pub fn stepped(&self, task: &BalanceTask, weight: usize, up: bool) -> Option<Choices> {
        let free = &task.weights[weight];
        let [now, last] = self.weights[weight].amount;
        let [least, most] = amounts(task, weight);
        // A weight that is not used has no direction, unless one is given.
        let has_direction = matches!(self.weights[weight].heading, Heading::Ray(_));
        if free.catalogue.is_none() || now != last || !has_direction || may_leave(task, weight) {
            return None;
        }
        let next = if up { now + 1 } else { now.checked_sub(1)? };
        if next < least || next > most {
            return None;
        }
        let mut stepped = self.clone();
        for (choice, other) in stepped.weights.iter_mut().zip(&task.weights) {
            let equal = free.equal_parts.is_some() && other.equal_parts == free.equal_parts;
            if (equal || std::ptr::eq(free, other)) && !(other.optional && choice.usage == Use::No) {
                choice.amount = [next; 2];
                choice.usage = if next == 0 { Use::No } else { Use::Yes };
            }
        }
        stepped.settled(task)
    }

    /// Gives equal parts the amounts that all of them may have; what may have none is not used. `None` where none is left.
    fn with_amounts(mut self, task: &BalanceTask) -> Option<Choices> {
        for (weight, free) in task.weights.iter().enumerate().filter(|(_, free)| free.catalogue.is_some()) {
            let equals = |other: &usize| {
                *other == weight
                    || free.equal_parts.is_some() && task.weights[*other].equal_parts == free.equal_parts
            };
            if self.weights[weight].usage == Use::No {
                continue;
            }
            let parts = (0..task.weights.len()).filter(equals);
            let used = parts.filter(|&part| self.weights[part].usage != Use::No);
            let [first, last] = used.fold([0, usize::MAX], |[first, last], part| {
                let own = self.weights[part].amount;
                [first.max(own[0]), last.min(own[1])]
            });
            if first > last {
                // A part that may be left out is.
                match self.weights[weight].usage {
                    Use::Open => self.weights[weight].usage = Use::No,
                    _ => return None,
                }
                continue;
            }
            self.weights[weight].amount = [first, last];
            if last == 0 {
                self.weights[weight].usage = Use::No;
            }
        }
        Some(self)
    }

    /// Whether a weight is used, its shaft's use considered.
    pub fn usage(&self, task: &BalanceTask, weight: usize) -> Use {
        let shaft = match task.weights[weight].seat {
            Seat::Shaft(shaft) => self.shafts[shaft].usage,
            Seat::Crankshaft(_) => Use::Yes,
        };
        match (self.weights[weight].usage, shaft) {
            (Use::No, _) | (_, Use::No) => Use::No,
            (Use::Open, _) | (_, Use::Open) => Use::Open,
            (Use::Yes, Use::Yes) => Use::Yes,
        }
    }

    /// How many of the optional devices are used for certain.
    pub fn used(&self, task: &BalanceTask) -> usize {
        let weights = task.weights.iter().zip(&self.weights).map(|(w, c)| (w.optional, c.usage));
        let shafts = task.shafts.iter().zip(&self.shafts).map(|(s, c)| (s.optional, c.usage));
        let inertia = self.inertia.is_some_and(|index| task.inertias[index].optional);
        weights.chain(shafts).filter(|&(optional, usage)| optional && usage == Use::Yes).count()
            + usize::from(inertia)
    }

    /// How many of the devices that count as optional are not decided.
    fn optional_left(&self, task: &BalanceTask) -> usize {
        let weights = task.weights.iter().zip(&self.weights).map(|(w, c)| (w.optional, c.usage));
        let shafts = task.shafts.iter().zip(&self.shafts).map(|(s, c)| (s.optional, c.usage));
        weights.chain(shafts).filter(|&(optional, usage)| optional && usage == Use::Open).count()
    }

    /// How many of the devices that may be left out are not decided.
    pub fn undecided(&self) -> usize {
        let usages = self.weights.iter().map(|w| w.usage).chain(self.shafts.iter().map(|s| s.usage));
        usages.filter(|usage| *usage == Use::Open).count()
    }

    /// The box with what follows from its choices; `None` where they contradict one another.
    ///
    /// A device without a least amount is never worse used than not, if it does not count.
    pub fn settled(self, task: &BalanceTask) -> Option<Choices> {
        let mut this = self.with_amounts(task)?;
        let left = match task.most_optional {
            Some(most) => most.checked_sub(this.used(task))?,
            None => usize::MAX,
        };
        for shaft in 0..this.shafts.len() {
            if this.shafts[shaft].usage == Use::No {
                // What stands on a shaft that is left out need not be decided.
                for weight in on_shaft(task, shaft).filter(|&w| task.weights[w].optional) {
                    this.weights[weight].usage = Use::No;
                }
            }
        }
        let undecided = this.undecided();
        if left == 0 {
            let weights =
                this.weights.iter_mut().map(|w| &mut w.usage).zip(task.weights.iter().map(|w| w.optional));
            let shafts =
                this.shafts.iter_mut().map(|s| &mut s.usage).zip(task.shafts.iter().map(|s| s.optional));
            let open = weights.chain(shafts).filter(|(usage, optional)| *optional && **usage == Use::Open);
            open.for_each(|(usage, _)| *usage = Use::No);
        }
        if this.optional_left(task) <= left {
            for weight in 0..this.weights.len() {
                let harmless = this.least(task, weight) == 0.0 && !task.pays_for_weight(weight);
                if this.weights[weight].usage == Use::Open && harmless {
                    this.weights[weight].usage = Use::Yes;
                }
            }
            for shaft in 0..this.shafts.len() {
                let harmless = !task.pays_for_shaft(shaft)
                    && on_shaft(task, shaft).all(|w| this.least(task, w) == 0.0 || task.weights[w].optional);
                if this.shafts[shaft].usage == Use::Open && harmless {
                    this.shafts[shaft].usage = Use::Yes;
                }
            }
            return this.settled_if_changed(task, undecided);
        }
        Some(this)
    }

    fn settled_if_changed(self, task: &BalanceTask, undecided: usize) -> Option<Choices> {
        if self.undecided() < undecided { self.settled(task) } else { Some(self) }
    }

    /// The one weight on a shaft: its direction is that of the shaft.
    pub fn only_weight(&self, task: &BalanceTask, shaft: usize) -> Option<usize> {
        let mut own = on_shaft(task, shaft).filter(|&w| self.usage(task, w) != Use::No);
        own.next().filter(|_| own.next().is_none())
    }

    /// Where a box can be divided about which nothing is known.
    pub fn widest(&self, task: &BalanceTask) -> Option<Split> {
        if let Some(shaft) = self.shafts.iter().position(|s| s.usage == Use::Open) {
            return Some(Split::UseShaft(shaft));
        }
        if let Some(weight) = self.weights.iter().position(|w| w.usage == Use::Open) {
            return Some(Split::UseWeight(weight));
        }
        let share = |part: [f64; 2], whole: [f64; 2]| {
            if open(whole) && open(part) { (part[1] - part[0]) / (whole[1] - whole[0]) } else { 0.0 }
        };
        let middle = |[low, high]: [f64; 2]| 0.5 * (low + high);
        let mut all = Vec::new();
        let divisible = |heading: Heading| {
            let share = heading.width() / (2.0 * PI);
            if matches!(heading, Heading::Ray(_) | Heading::Tangent(_)) { 0.0 } else { share }
        };
        for (index, (choice, weight)) in self.weights.iter().zip(&task.weights).enumerate() {
            let usage = self.usage(task, index);
            if usage == Use::No {
                continue;
            }
            all.push((share(choice.z, stretch(weight.z)), Split::Plane(index, middle(choice.z))));
            if self.has_amounts(task, index) {
                let [first, last] = choice.amount;
                // Half of what is left; of a catalogue without an end twice what is known.
                let half = if last == usize::MAX { 2 * first + 1 } else { first + (last - first) / 2 };
                all.push((1.0, Split::Amount(index, half)));
            }
            if open(choice.z) || self.least(task, index) > 0.0 && usage == Use::Yes {
                all.push((divisible(choice.heading), Split::Heading(index, Looked::default())));
            }
        }
        for (index, (choice, shaft)) in self.shafts.iter().zip(&task.shafts).enumerate() {
            if choice.usage == Use::No || !(open(choice.x) || open(choice.y)) {
                continue;
            }
            all.push((share(choice.x, stretch(shaft.x)), Split::AxisX(index, middle(choice.x))));
            all.push((share(choice.y, stretch(shaft.y)), Split::AxisY(index, middle(choice.y))));
            all.push(match self.only_weight(task, index) {
                Some(only) => {
                    (divisible(self.weights[only].heading), Split::Heading(only, Looked::default()))
                }
                None => (divisible(choice.heading), Split::ShaftHeading(index, Looked::default())),
            });
        }
        let widest = all.into_iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
        (widest.0 > 1e-9).then_some(widest.1)
    }

    /// The parts of the box.
    pub fn divided(&self, task: &BalanceTask, split: Split) -> Vec<Choices> {
        let with = |change: &dyn Fn(&mut Choices)| {
            let mut part = self.clone();
            change(&mut part);
            part.settled(task)
        };
        let halves = |[low, high]: [f64; 2], at: f64| {
            let width = high - low;
            let middle = 0.5 * (low + high);
            let beside = (at - middle).abs() < CLOSE * width;
            let at = if beside { middle + 2.0 * CLOSE * width } else { middle };
            [[low, at], [at, high]]
        };
        let parts: Vec<Option<Choices>> = match split {
            Split::UseWeight(weight) => {
                [Use::Yes, Use::No].map(|usage| with(&|c| c.weights[weight].usage = usage)).into()
            }
            Split::UseShaft(shaft) => {
                [Use::Yes, Use::No].map(|usage| with(&|c| c.shafts[shaft].usage = usage)).into()
            }
            Split::Amount(weight, at) => {
                let [first, last] = self.weights[weight].amount;
                [[first, at], [at + 1, last]].map(|part| with(&|c| c.weights[weight].amount = part)).into()
            }
            Split::Plane(weight, at) => {
                halves(self.weights[weight].z, at).map(|part| with(&|c| c.weights[weight].z = part)).into()
            }
            Split::PlaneAt(weight, at) => {
                let [low, high] = self.weights[weight].z;
                [[low, at], [at, high]].map(|part| with(&|c| c.weights[weight].z = part)).into()
            }
            Split::AxisX(shaft, at) => {
                halves(self.shafts[shaft].x, at).map(|part| with(&|c| c.shafts[shaft].x = part)).into()
            }
            Split::AxisY(shaft, at) => {
                halves(self.shafts[shaft].y, at).map(|part| with(&|c| c.shafts[shaft].y = part)).into()
            }
            Split::Heading(weight, at) => self.weights[weight]
                .heading
                .parts(at)
                .into_iter()
                .map(|part| with(&|c| c.weights[weight].heading = part))
                .collect(),
            Split::ShaftHeading(shaft, at) => self.shafts[shaft]
                .heading
                .parts(at)
                .into_iter()
                .map(|part| with(&|c| c.shafts[shaft].heading = part))
                .collect(),
        };
        parts.into_iter().flatten().collect()
    }
}

impl Heading {
    /// Width of the directions [rad].
    pub fn width(self) -> f64 {
        match self {
            Heading::Any | Heading::Tangent(_) => 2.0 * PI,
            Heading::Sector { width, .. } => width,
            Heading::Line(_) => PI,
            Heading::Ray(_) => 0.0,
        }
    }

    /// Parts that cover it. Where what is looked for needs a small share of the sector alone, one part is so narrow that
    /// it leaves out what lies at the ends of it; else the parts are halves.
    fn parts(self, looked: Looked) -> Vec<Heading> {
        let [before, after] = looked.reach.map(|reach| INSIDE * reach);
        let narrow = |width: f64| before + after > ONE_DIRECTION && before + after < 0.5 * width;
        let sector = |start: f64, width: f64| Heading::Sector { start, width };
        match self {
            Heading::Any if narrow(2.0 * PI) => {
                let rest = (2.0 * PI - before - after) / 3.0;
                let around = |k: i32| sector(looked.angle + after + f64::from(k) * rest, rest);
                vec![sector(looked.angle - before, before + after), around(0), around(1), around(2)]
            }
            // The middles of the quarters, not their edges, lie where symmetric engines have their optima.
            Heading::Any => (0..4).map(|k| sector(f64::from(k) * FRAC_PI_2 - FRAC_PI_4, FRAC_PI_2)).collect(),
            Heading::Sector { start, width } => {
                let middle = start + 0.5 * width;
                let past = about_zero(looked.angle - middle, TAU);
                let at = 0.5 * width + past;
                if narrow(width) && at > -after && at < width + before {
                    let ends = [at - before, at + after].map(|end| end.clamp(0.0, width));
                    let [low, high] = ends;
                    return [[0.0, low], [low, high], [high, width]]
                        .into_iter()
                        .filter(|part| part[1] > part[0])
                        .map(|part| sector(start + part[0], part[1] - part[0]))
                        .collect();
                }
                let beside = past.abs() < CLOSE * width;
                let first = if beside { (0.5 + 2.0 * CLOSE) * width } else { 0.5 * width };
                vec![sector(start, first), sector(start + first, width - first)]
            }
            Heading::Line(angle) => vec![Heading::Ray(angle), Heading::Ray(angle + PI)],
            Heading::Ray(_) | Heading::Tangent(_) => Vec::new(),
        }
    }

    /// The direction of it that is nearest to `angle`.
    pub fn nearest(self, angle: f64) -> f64 {
        match self {
            Heading::Any | Heading::Tangent(_) => angle,
            Heading::Ray(own) => own,
            Heading::Line(own) => {
                if (angle - own).cos() >= 0.0 {
                    own
                } else {
                    own + PI
                }
            }
            Heading::Sector { start, width } => {
                let past = about_zero(angle - start - 0.5 * width, TAU);
                start + 0.5 * width + past.clamp(-0.5 * width, 0.5 * width)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_cover_the_circle_and_every_sector() {
        let width = |parts: &[Heading]| parts.iter().map(|p| p.width()).sum::<f64>();
        let quarters = Heading::Any.parts(Looked::default());
        assert!((width(&quarters) - 2.0 * PI).abs() < 1e-15);
        for at in [0.0, 0.3, -0.7, 2.0] {
            let halves = quarters[0].parts(Looked { angle: at, reach: [0.0; 2] });
            assert!((width(&halves) - FRAC_PI_2).abs() < 1e-15);
            // What is looked for lies well inside one of them.
            let inside = |h: &Heading| match *h {
                Heading::Sector { start, width } => {
                    let past = (at - start).rem_euclid(2.0 * PI);
                    past > 0.05 * width && past < 0.95 * width
                }
                _ => false,
            };
            assert!(at.abs() > FRAC_PI_4 || halves.iter().any(inside), "{at}: {halves:?}");
        }
    }

    #[test]
    fn a_narrow_part_leaves_out_the_ends_of_what_is_looked_for() {
        let looked = Looked { angle: 0.3, reach: [0.05, 0.1] };
        for whole in [Heading::Any, Heading::Any.parts(Looked::default())[0]] {
            let parts = whole.parts(looked);
            let sum = parts.iter().map(|part| part.width()).sum::<f64>();
            assert!((sum - whole.width()).abs() < 1e-14, "{whole:?}: {parts:?}");
            let holds = |part: &Heading, angle: f64| {
                let Heading::Sector { start, width } = *part else { panic!("{part:?}") };
                (angle - start).rem_euclid(2.0 * PI) < width
            };
            let around: Vec<&Heading> = parts.iter().filter(|part| holds(part, 0.3)).collect();
            assert_eq!(around.len(), 1, "{parts:?}");
            assert!(!holds(around[0], 0.25) && !holds(around[0], 0.4), "{around:?}");
            assert!(parts.iter().all(|part| part.width() <= PI), "{parts:?}");
        }
        // At the edge of a sector, and where the ends are as wide as the sector.
        let edge = Heading::Sector { start: 0.3, width: 1.0 };
        assert_eq!(edge.parts(Looked { angle: 0.3, ..looked }).len(), 2);
        assert_eq!(edge.parts(Looked { angle: 0.8, reach: [0.3 / INSIDE; 2] }).len(), 2);
        assert_eq!(edge.parts(Looked { angle: 0.8, reach: [0.1 / INSIDE; 2] }).len(), 3);
    }

    #[test]
    fn nearest_direction_of_a_sector() {
        let sector = Heading::Sector { start: -FRAC_PI_4, width: FRAC_PI_2 };
        for (angle, want) in [(0.1, 0.1), (1.0, FRAC_PI_4), (-1.0, -FRAC_PI_4), (2.0 * PI + 0.2, 0.2)] {
            assert!((sector.nearest(angle) - want).abs() < 1e-12, "{angle}");
        }
        assert_eq!(Heading::Line(0.0).nearest(3.0), PI);
    }
}
