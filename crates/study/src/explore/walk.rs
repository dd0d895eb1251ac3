//! Through a stretch of cases: block by block, crank by crank, firing by firing.

use crate::explore::candidate::Candidate;
use crate::explore::constraint::Constraint;
use crate::explore::counts::Counts;
use crate::explore::error::ExploreError;
use crate::explore::explorer::Explorer;
use crate::explore::firing::{Firing, FiringUnit};
use crate::explore::front::{Front, Ranking};
use crate::explore::kernel::Block;
use crate::explore::layout::Layout;
use crate::explore::layout_orders::LayoutOrders;
use crate::explore::objective::{Level, Objective, Sense};
use crate::explore::sample::{JudgedCase, Sample};
use crate::explore::symmetry::{Renumbering, View, seen_shafts};

/// What is known of a stretch of cases.
pub(crate) struct Found {
    pub counts: Counts,
    pub front: Vec<Candidate>,
    pub ranking: Vec<Candidate>,
    pub sample: Vec<JudgedCase>,
}

/// A view whose sizes lie in the space, at or below the number of the block itself.
struct Seen {
    renumbering: Renumbering,
    sizes: [usize; 7],
}

/// The walk with what it keeps between cases.
pub(crate) struct Walk<'a> {
    explorer: &'a Explorer,
    counts: Counts,
    front: Front,
    ranking: Ranking,
    sample: Sample,
    /// Places of the throws in the list of angles.
    throws: Vec<u16>,
    image: Vec<u16>,
    /// Whether each view leaves the crank as it is: it may still tell firings alike.
    still: Vec<bool>,
    firing: Firing,
    values: Vec<f64>,
    steps: Vec<i64>,
    /// Gets every case that is judged, with its objectives.
    judged: &'a mut dyn FnMut(u128, &[f64]),
}

/// Cases that share all sizes.
struct Sizes {
    layout: Layout,
    block: Block,
    digits: [usize; 7],
    seen: Vec<Seen>,
    units: Vec<FiringUnit>,
}

impl<'a> Walk<'a> {
    pub fn new(explorer: &'a Explorer, judged: &'a mut dyn FnMut(u128, &[f64])) -> Walk<'a> {
        let space = &explorer.request.space;
        Walk {
            explorer,
            counts: explorer.no_counts(),
            front: Front::default(),
            ranking: Ranking::of(Vec::new(), explorer.request.most_listed),
            sample: Sample::default(),
            throws: vec![0; space.groups()],
            image: vec![0; space.groups()],
            still: Vec::new(),
            firing: Firing::new(
                space.parts.strokes.revolutions(),
                explorer.sizes(&explorer.size_digits(0)).neighbours(),
            ),
            values: vec![0.0; explorer.request.objectives.len()],
            steps: vec![0; explorer.request.objectives.len()],
            judged,
        }
    }

    /// Looks at cases `from` to `to`, end excluded.
    pub fn run(mut self, from: u128, to: u128) -> Result<Found, ExploreError> {
        let cranks = self.explorer.per_block / self.explorer.per_crank;
        let mut case = from;
        while case < to {
            let rank = case / self.explorer.per_block;
            let start = rank * self.explorer.per_block;
            let end = to.min(start + self.explorer.per_block);
            let digits = self.explorer.size_digits(rank);
            let layout = self.explorer.sizes(&digits);
            if let Some(reason) = self.explorer.invalid(&digits, &layout) {
                self.counts.add_invalid(reason, end - case);
            } else if let Some(broken) = self.broken_by_sizes(&layout) {
                self.counts.cases += end - case;
                self.counts.broken[broken].cases += end - case;
            } else {
                let sizes = self.prepare(digits, layout);
                let mut crank = (case - start) / self.explorer.per_crank;
                while crank < cranks && start + crank * self.explorer.per_crank < end {
                    let first = start + crank * self.explorer.per_crank;
                    let codes = [case.max(first) - first, end.min(first + self.explorer.per_crank) - first];
                    self.explorer.set_throws(crank, &mut self.throws);
                    self.crank(&sizes, first, codes)?;
                    crank += 1;
                }
            }
            case = end;
        }
        Ok(Found {
            counts: self.counts,
            front: self.front.sorted(),
            ranking: self.ranking.into_candidates(),
            sample: self.sample.into_cases(),
        })
    }

    fn prepare(&self, digits: [usize; 7], layout: Layout) -> Sizes {
        let space = &self.explorer.request.space;
        // A block of higher number has no say.
        let seen = match &layout.arrangement {
            None => View::OTHERS
                .into_iter()
                .filter_map(|view| Some((view, view.sizes(space, &digits)?)))
                .filter(|(_, sizes)| *sizes <= digits)
                .map(|(view, sizes)| Seen {
                    renumbering: view.renumbering(space.groups(), space.bank_count()),
                    sizes,
                })
                .collect(),
            Some(_) => self
                .explorer
                .arranged_views
                .iter()
                .filter_map(|view| {
                    let mut sizes = digits;
                    sizes[5] = view.pattern(&space.counterweights, digits[5])?;
                    sizes[6] = seen_shafts(&space.shafts, digits[6], view.ends, |x, y| view.place(x, y))?;
                    (sizes <= digits).then(|| Seen { renumbering: view.renumbering.clone(), sizes })
                })
                .collect(),
        };
        let units = layout.firing_units();
        Sizes { block: self.explorer.block(&digits, &layout), layout, digits, seen, units }
    }

    /// The first constraint on sizes that the layout breaks.
    fn broken_by_sizes(&self, layout: &Layout) -> Option<usize> {
        let parts = &self.explorer.request.space.parts;
        self.explorer.request.constraints.iter().position(|constraint| match *constraint {
            Constraint::BearingRoom { least } => {
                layout.groups() > 1 && layout.spacing - parts.web_distance - parts.web_thickness < least
            }
            Constraint::PinOverlap { least } => layout.banks.is_some_and(|pair| {
                let apart = 2.0 * parts.crank_radius * (0.5 * pair.split_angle).sin().abs();
                layout.has_split_pins() && parts.pin_diameter - apart < least
            }),
            Constraint::AtMost { objective, limit } if objective.level() == Level::Block => {
                self.explorer.size_value(objective, layout) > limit
            }
            Constraint::AtMost { .. } | Constraint::EvenFiring { .. } => false,
        })
    }

    /// One crank with its firings of codes `codes[0]` to `codes[1]`, end excluded; `first`: its first case.
    fn crank(&mut self, sizes: &Sizes, first: u128, codes: [u128; 2]) -> Result<(), ExploreError> {
        let count = codes[1] - codes[0];
        self.counts.cases += count;
        self.still.clear();
        self.still.resize(sizes.seen.len(), false);
        for (place, seen) in sizes.seen.iter().enumerate() {
            if !seen.renumbering.throws(&self.throws, &self.explorer.differences, &mut self.image) {
                continue;
            }
            let Some(order) = self.explorer.compare(&self.image, &self.throws) else { continue };
            match seen.sizes.cmp(&sizes.digits).then(order) {
                std::cmp::Ordering::Less => {
                    self.counts.duplicates += count;
                    return Ok(());
                }
                std::cmp::Ordering::Equal => self.still[place] = true,
                std::cmp::Ordering::Greater => {}
            }
        }
        let orders = self.explorer.with_shafts(sizes.block.orders(&self.throws), &sizes.layout);
        let (explorer, constraints) = (self.explorer, &self.explorer.request.constraints);
        let fires = explorer.fires;
        if fires {
            let (angles, throws) = (&explorer.angles, &self.throws);
            let pin = |unit: &FiringUnit| angles[throws[unit.group] as usize] + unit.lead;
            self.firing.set_crank(sizes.units.iter().map(|unit| (pin(unit), unit.axis)));
        }
        let single = explorer.per_crank == 1;
        if !single {
            // A firing that is a duplicate must not be counted as broken.
            let broken = self.broken_by_crank(sizes, &orders).or_else(|| {
                constraints.iter().position(|constraint| match constraint {
                    Constraint::EvenFiring { tolerance } => !self.firing.may_be_even(*tolerance),
                    _ => false,
                })
            });
            if let Some(broken) = broken {
                let alike = (codes[0]..codes[1]).filter(|&code| self.is_duplicate(code as u64, sizes)).count()
                    as u128;
                self.counts.duplicates += alike;
                self.counts.broken[broken].cases += count - alike;
                return Ok(());
            }
        } else if let Some(broken) = self.broken_by_crank(sizes, &orders) {
            self.counts.broken[broken].cases += count;
            return Ok(());
        }
        for (place, objective) in explorer.request.objectives.iter().enumerate() {
            self.values[place] = match objective.level() {
                Level::Block => explorer.size_value(*objective, &sizes.layout),
                Level::Crank => self.crank_value(*objective, sizes, &orders),
                Level::Firing => 0.0,
            };
        }
        for code in codes[0]..codes[1] {
            if !single && self.is_duplicate(code as u64, sizes) {
                self.counts.duplicates += 1;
                continue;
            }
            if fires {
                self.firing.set_code(code as u64);
                if let Some(broken) = self.broken_by_firing() {
                    self.counts.broken[broken].cases += 1;
                    continue;
                }
                for (place, objective) in explorer.request.objectives.iter().enumerate() {
                    if objective.level() == Level::Firing {
                        self.values[place] = self.firing_value(*objective);
                    }
                }
            }
            self.judge(first + code)?;
        }
        Ok(())
    }

    /// Whether a view that leaves the crank as it is turns the firing into one of lower code.
    fn is_duplicate(&self, code: u64, sizes: &Sizes) -> bool {
        sizes.seen.iter().zip(&self.still).filter(|(_, still)| **still).any(|(seen, _)| {
            let own = &seen.renumbering;
            self.firing.code_seen(code, |index| own.cylinders[index], own.mirror) < code
        })
    }

    fn broken_by_crank(&self, sizes: &Sizes, orders: &LayoutOrders) -> Option<usize> {
        self.explorer.request.constraints.iter().position(|constraint| match *constraint {
            Constraint::AtMost { objective, limit } if objective.level() == Level::Crank => {
                self.crank_value(objective, sizes, orders) > limit
            }
            _ => false,
        })
    }

    fn broken_by_firing(&self) -> Option<usize> {
        self.explorer.request.constraints.iter().position(|constraint| match *constraint {
            // A tolerance of 0 means even but for rounding.
            Constraint::EvenFiring { tolerance } => self.firing.unevenness() > tolerance + 1e-9,
            Constraint::AtMost { objective, limit } if objective.level() == Level::Firing => {
                self.firing_value(objective) > limit
            }
            _ => false,
        })
    }

    fn crank_value(&self, objective: Objective, sizes: &Sizes, orders: &LayoutOrders) -> f64 {
        use Sense::{Backward, Forward};
        match objective {
            Objective::Force { order } => {
                orders.force_of(order, Forward).norm() + orders.force_of(order, Backward).norm()
            }
            Objective::Couple { order } => {
                orders.couple_of(order, Forward).norm() + orders.couple_of(order, Backward).norm()
            }
            Objective::ForceSense { order, sense } => orders.force_of(order, sense).norm(),
            Objective::CoupleSense { order, sense } => orders.couple_of(order, sense).norm(),
            Objective::RollMoment { order } => orders.roll_moment[order as usize - 1].norm(),
            Objective::InertiaTorque { order } => orders.shaft_torque[order as usize - 1].norm(),
            Objective::BendingMoment => sizes.block.bending_moment(&self.throws),
            Objective::MainLoad => sizes.block.main_load(&self.throws),
            Objective::CounterweightUnbalance => self.explorer.counterweights(&sizes.digits, &sizes.layout),
            _ => 0.0,
        }
    }

    fn firing_value(&self, objective: Objective) -> f64 {
        match objective {
            Objective::FiringUnevenness => self.firing.unevenness(),
            Objective::FiringHarmonic { half_orders } => self.firing.harmonic(half_orders),
            Objective::NeighbourFirings => self.firing.neighbours() as f64,
            _ => 0.0,
        }
    }

    /// Takes the case into sample, front and ranking.
    fn judge(&mut self, case: u128) -> Result<(), ExploreError> {
        self.counts.judged += 1;
        (self.judged)(case, &self.values);
        self.sample.offer(case, &self.values);
        for (place, value) in self.values.iter().enumerate() {
            self.steps[place] = (value / self.explorer.resolutions[place]).round() as i64;
        }
        let limits = &self.explorer.request.at_least;
        if !limits.is_empty() {
            let is_covered = self.front.covers(&self.steps) && !self.ranking.takes(&self.steps);
            if is_covered || !self.explorer.is_durable(case, limits)? {
                return Ok(());
            }
        }
        self.ranking.offer(case, &self.steps, &self.values, 1);
        self.front.offer(case, &self.steps, &self.values, 1, self.explorer.request.most_on_front)
    }
}
