//! The search space: a product of lists, its exact size, and the bijection between case numbers and cases.
//!
//! A case number is a number in mixed radix; its digits are, from the slowest to the fastest: spacing, bank angle, split
//! angle, bank stagger, rod ratio, counterweights, shafts, the angle of each throw but the first, the firing order.

use crate::explore::as_given::Arrangement;
use crate::explore::choice::Choice;
use crate::explore::counterweight_pattern::CounterweightPattern;
use crate::explore::error::ExploreError;
use crate::explore::parts::Parts;
use crate::explore::shaft_set::ShaftSet;
use lanchester_model::Strokes;
use lanchester_numerics::about_zero;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// Most cylinders of a layout.
pub(crate) const MOST_CYLINDERS: usize = 32;

/// Most angles that a throw may take.
const MOST_ANGLES: usize = 4096;

/// Angles closer than this [rad] are one.
pub(crate) const SAME_ANGLE: f64 = 1e-9;

/// All layouts that are looked at: every combination of one value of each choice.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Space {
    /// What all of them are made of.
    pub parts: Parts,
    /// Number of cylinders, at most 32.
    pub cylinders: usize,
    /// One bank, two, or the cylinders of an engine as they are.
    pub banks: Banks,
    /// Angles that each throw may have, from the first throw in the sense of rotation [rad]; the first stands at 0. Of a
    /// pair on split pins it is the pin of bank 1.
    pub throw_angles: Vec<f64>,
    /// Distance of neighbouring groups along the crank [m].
    pub spacings: Vec<f64>,
    /// Crank radius over rod length.
    pub rod_ratios: Vec<f64>,
    /// Weights on the crank webs.
    pub counterweights: Vec<CounterweightPattern>,
    /// Balance shafts; an empty set is none.
    pub shafts: Vec<ShaftSet>,
    /// Whether the firing orders are part of the search: every way of firing each cylinder at one of its top dead
    /// centres in the cycle, that of cylinder 1 in the first revolution.
    pub firing: bool,
}

/// Banks of cylinders.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Banks {
    /// One bank.
    InLine,
    /// Two banks. A bank angle of 180 deg is a flat engine, with a split angle of 180 deg a boxer.
    Two {
        /// Angle between the banks [rad].
        bank_angles: Vec<f64>,
        /// How far the pin of bank 2 stands ahead of that of bank 1 [rad]; 0: one pin for both rods.
        split_angles: Vec<f64>,
        /// How far bank 2 stands behind bank 1 along the crank [m].
        staggers: Vec<f64>,
    },
    /// Cylinders, rods, pins and crankshafts of an engine as they are: throw angles, firing, weights and shafts are chosen.
    AsGiven(Box<Arrangement>),
}

/// A choice and how many values it has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct ChoiceCount {
    /// The choice.
    pub choice: Choice,
    /// Its values: of throw angles all cranks, of firing all ways of firing.
    pub values: u128,
}

/// `count` equal parts of a turn [rad], from 0.
pub fn even_angles(count: u32) -> Vec<f64> {
    (0..count).map(|k| TAU * f64::from(k) / f64::from(count)).collect()
}

/// A whole number `base^exponent`, or its logarithm where it is too large.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Size {
    Exact(u128),
    PowerOfTen(f64),
}

impl Size {
    fn power(base: u128, exponent: u32) -> Size {
        base.checked_pow(exponent)
            .map_or(Size::PowerOfTen(f64::from(exponent) * (base as f64).log10()), Size::Exact)
    }

    fn times(self, other: Size) -> Size {
        if let (Size::Exact(a), Size::Exact(b)) = (self, other)
            && let Some(product) = a.checked_mul(b)
        {
            return Size::Exact(product);
        }
        Size::PowerOfTen(self.log() + other.log())
    }

    fn log(self) -> f64 {
        match self {
            Size::Exact(size) => (size as f64).log10(),
            Size::PowerOfTen(power) => power,
        }
    }

    fn text(self) -> String {
        match self {
            Size::Exact(size) => size.to_string(),
            Size::PowerOfTen(power) => format!("about 10^{power:.1}"),
        }
    }
}

impl Space {
    /// Cylinders of a group along the crank: 1 or 2; of engines as they are, where groups differ, 1.
    pub fn bank_count(&self) -> usize {
        match self.banks {
            Banks::InLine | Banks::AsGiven(_) => 1,
            Banks::Two { .. } => 2,
        }
    }

    /// Groups along the crank, each with an angle of its own: cylinders of one bank, or those of [`Arrangement`].
    pub fn groups(&self) -> usize {
        match &self.banks {
            Banks::AsGiven(arrangement) => arrangement.groups(),
            Banks::InLine | Banks::Two { .. } => self.cylinders / self.bank_count(),
        }
    }

    /// The arrangement of an engine as it is.
    pub fn arrangement(&self) -> Option<&Arrangement> {
        match &self.banks {
            Banks::AsGiven(arrangement) => Some(arrangement),
            Banks::InLine | Banks::Two { .. } => None,
        }
    }

    /// What fires once a cycle: cylinders, or the chambers that they share.
    pub(crate) fn chambers(&self) -> usize {
        self.arrangement().map_or(self.cylinders, |arrangement| arrangement.chambers().len())
    }

    /// Webs that may have a weight.
    fn webs(&self) -> usize {
        2 * self.arrangement().map_or(self.groups(), |arrangement| arrangement.throws.len())
    }

    /// Values of a choice; throw angles and firing as powers.
    fn values(&self, choice: Choice) -> (u128, u32) {
        let (bank_angles, split_angles, staggers) = match &self.banks {
            Banks::InLine | Banks::AsGiven(_) => (1, 1, 1),
            Banks::Two { bank_angles, split_angles, staggers } => {
                (bank_angles.len(), split_angles.len(), staggers.len())
            }
        };
        let list = |length: usize| (length as u128, 1);
        match choice {
            Choice::Spacing => list(self.spacings.len()),
            Choice::BankAngle => list(bank_angles),
            Choice::SplitAngle => list(split_angles),
            Choice::Stagger => list(staggers),
            Choice::RodRatio => list(self.rod_ratios.len()),
            Choice::Counterweights => list(self.counterweights.len()),
            Choice::Shafts => list(self.shafts.len()),
            Choice::ThrowAngles => (self.throw_angles.len() as u128, self.groups() as u32 - 1),
            Choice::Firing if self.firing && self.parts.strokes == Strokes::Four => {
                (2, self.chambers() as u32 - 1)
            }
            Choice::Firing => list(1),
        }
    }

    /// How many values each choice has, those with one left out: their product is the size.
    pub fn choices(&self) -> Vec<ChoiceCount> {
        let counts = Choice::ALL.into_iter().zip(self.radices());
        counts
            .filter(|(_, values)| *values > 1)
            .map(|(choice, values)| ChoiceCount { choice, values })
            .collect()
    }

    /// Number of values of each choice, in the order of [`Choice::ALL`], where they are small enough to count.
    pub(crate) fn radices(&self) -> [u128; 9] {
        Choice::ALL.map(|choice| {
            let (base, exponent) = self.values(choice);
            base.saturating_pow(exponent)
        })
    }

    /// Exact number of cases, before anything is looked at.
    ///
    /// # Errors
    /// [`ExploreError`] where a number is impossible, a choice has no value or one twice, or there are more than
    /// `most` cases: it says how many, and which choice makes it so.
    pub fn size(&self, most: u128) -> Result<u128, ExploreError> {
        self.check()?;
        let sizes = Choice::ALL.map(|choice| {
            let (base, exponent) = self.values(choice);
            (choice, Size::power(base, exponent))
        });
        let size = sizes.iter().fold(Size::Exact(1), |size, (_, one)| size.times(*one));
        if let Size::Exact(size) = size
            && size <= most
        {
            return Ok(size);
        }
        let (choice, count) =
            sizes.iter().fold(sizes[0], |most, one| if one.1.log() > most.1.log() { *one } else { most });
        Err(ExploreError::TooLarge { size: size.text(), most, choice, count: count.text() })
    }

    /// Refuses what is no space.
    fn check(&self) -> Result<(), ExploreError> {
        self.parts.check()?;
        let banks = self.bank_count();
        if self.cylinders == 0 || self.cylinders > MOST_CYLINDERS || !self.cylinders.is_multiple_of(banks) {
            return Err(ExploreError::Cylinders { banks, most: MOST_CYLINDERS, got: self.cylinders });
        }
        for choice in Choice::ALL {
            if self.values(choice) == (0, 1)
                || (choice == Choice::ThrowAngles && self.throw_angles.is_empty())
            {
                return Err(ExploreError::EmptyChoice { choice });
            }
        }
        if self.throw_angles.len() > MOST_ANGLES {
            let (needed, got) = ("at most 4096", self.throw_angles.len() as f64);
            return Err(ExploreError::Number { quantity: "number of throw angles", needed, got });
        }
        distinct_angles(Choice::ThrowAngles, &self.throw_angles)?;
        distinct(Choice::Spacing, &self.spacings, "spacing [m]", "positive and finite", |v| v > 0.0)?;
        distinct(Choice::RodRatio, &self.rod_ratios, "rod ratio", "positive and finite", |v| v > 0.0)?;
        if let Banks::Two { bank_angles, split_angles, staggers } = &self.banks {
            let inside = |v: f64| v > 0.0 && v <= PI + SAME_ANGLE;
            distinct(Choice::BankAngle, bank_angles, "bank angle [rad]", "above 0 and at most pi", inside)?;
            distinct_angles(Choice::SplitAngle, split_angles)?;
            distinct(Choice::Stagger, staggers, "bank stagger [m]", "finite", |_| true)?;
        }
        for (place, pattern) in self.counterweights.iter().enumerate() {
            let needed = self.webs();
            if let Some(webs) = pattern.webs.as_ref().filter(|webs| webs.len() != needed) {
                return Err(ExploreError::Webs { place: place + 1, needed, got: webs.len() });
            }
            if let Some(&got) = [pattern.rotating, pattern.reciprocating].iter().find(|v| !v.is_finite()) {
                return Err(ExploreError::Number {
                    quantity: "share of a counterweight",
                    needed: "finite",
                    got,
                });
            }
        }
        self.shafts.iter().flat_map(|set| &set.shafts).try_for_each(|shaft| shaft.check())
    }
}

/// Refuses a list of angles of which two are equal.
fn distinct_angles(choice: Choice, angles: &[f64]) -> Result<(), ExploreError> {
    for (place, &angle) in angles.iter().enumerate() {
        if !angle.is_finite() {
            return Err(ExploreError::Number { quantity: "angle [rad]", needed: "finite", got: angle });
        }
        if angles[..place].iter().any(|other| same_angle(*other, angle)) {
            return Err(ExploreError::RepeatedValue { choice, place: place + 1 });
        }
    }
    Ok(())
}

/// Refuses a list with a number that cannot be, or one twice.
fn distinct(
    choice: Choice,
    list: &[f64],
    quantity: &'static str,
    needed: &'static str,
    allowed: impl Fn(f64) -> bool,
) -> Result<(), ExploreError> {
    for (place, &got) in list.iter().enumerate() {
        if !got.is_finite() || !allowed(got) {
            return Err(ExploreError::Number { quantity, needed, got });
        }
        if list[..place].contains(&got) {
            return Err(ExploreError::RepeatedValue { choice, place: place + 1 });
        }
    }
    Ok(())
}

/// The angle in [-pi, pi).
pub(crate) fn centred(angle: f64) -> f64 {
    about_zero(angle, TAU)
}

/// Whether two angles are one direction.
pub(crate) fn same_angle(a: f64, b: f64) -> bool {
    centred(a - b).abs() < SAME_ANGLE
}
