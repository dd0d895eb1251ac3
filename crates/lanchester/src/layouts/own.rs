//! An engine taken apart as one layout: banks, groups, spacing, throws.

use lanchester_model::{Cylinder, Engine};
use lanchester_numerics::within_period;
use lanchester_study::explore::BankPair;
use std::f64::consts::{PI, TAU};

/// Angles [rad] and places [m] closer than this are one.
const SAME: f64 = 1e-7;

/// An engine of one or two banks of equal groups on one crankshaft.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct OwnLayout {
    pub banks: Option<BankPair>,
    /// Distance of neighbouring groups [m]; 0 where there is one.
    pub spacing: f64,
    /// Angle of each group's throw (of bank 1) from the first [rad].
    pub throw_angles: Vec<f64>,
    /// Cylinders of the engine by bank, then group.
    pub cylinders: Vec<usize>,
    /// From the front web of a group to its rear one [m], where the file has webs.
    pub web_distance: Option<f64>,
}

/// The angle in [0, 2 pi); one that misses the turn by rounding is 0.
fn turned(angle: f64) -> f64 {
    within_period(angle, TAU, SAME)
}

/// An angle in (-pi, pi].
fn folded(angle: f64) -> f64 {
    let turned = turned(angle);
    if turned > PI + SAME { turned - TAU } else { turned }
}

/// The one value of all; `None` where they differ.
fn common(mut values: impl Iterator<Item = f64>) -> Option<f64> {
    let first = values.next()?;
    values.all(|value| (value - first).abs() < SAME).then_some(first)
}

impl OwnLayout {
    /// Takes the engine apart.
    ///
    /// # Errors
    /// Why it is no engine of one or two banks of equal groups, in words.
    pub fn of(engine: &Engine) -> Result<OwnLayout, String> {
        if engine.crankshafts.len() != 1 {
            return Err(format!("it has {} crankshafts", engine.crankshafts.len()));
        }
        let banks = banks(engine)?;
        let groups = banks[0].len();
        if banks.iter().any(|bank| bank.len() != groups) {
            return Err("its banks have unequal numbers of cylinders".to_owned());
        }
        let at = |bank: usize, group: usize| &engine.cylinders[banks[bank][group]];
        let pin = |cylinder: &Cylinder| engine.throws[cylinder.throw].angle;
        let spacing = match groups {
            1 => 0.0,
            _ => common((1..groups).map(|g| at(0, g).z - at(0, g - 1).z))
                .ok_or("its cylinders do not stand at equal distances")?,
        };
        let pair = match banks.len() {
            1 => None,
            _ => {
                let stagger = common((0..groups).map(|g| at(1, g).z - at(0, g).z))
                    .ok_or("its banks do not stand at one distance along the crank")?;
                let split = |g: usize| folded(pin(at(1, g)) - pin(at(0, g)));
                let split_angle = common((0..groups).map(split))
                    .ok_or("the pins of its banks do not stand at one angle from each other")?;
                let bank_angle = turned(at(1, 0).angle - at(0, 0).angle);
                Some(BankPair { bank_angle, split_angle, stagger })
            }
        };
        let web_distance = (0..groups)
            .map(|g| {
                let webs = (0..banks.len()).map(|bank| engine.throws[at(bank, g).throw].webs);
                let webs = webs.collect::<Option<Vec<[f64; 2]>>>()?;
                let front = webs.iter().map(|web| web[0]).fold(f64::INFINITY, f64::min);
                Some(webs.iter().map(|web| web[1]).fold(f64::NEG_INFINITY, f64::max) - front)
            })
            .collect::<Option<Vec<f64>>>()
            .map(|distances| distances.into_iter().fold(0.0, f64::max));
        Ok(OwnLayout {
            banks: pair,
            spacing,
            throw_angles: (0..groups).map(|g| turned(pin(at(0, g)) - pin(at(0, 0)))).collect(),
            cylinders: banks.concat(),
            web_distance,
        })
    }

    /// Groups along the crank.
    pub fn groups(&self) -> usize {
        self.throw_angles.len()
    }
}

/// Cylinders by bank, each from the free end; bank 2 stands at an angle up to half a turn from bank 1.
fn banks(engine: &Engine) -> Result<Vec<Vec<usize>>, String> {
    let mut banks: Vec<(f64, Vec<usize>)> = Vec::new();
    for (index, cylinder) in engine.cylinders.iter().enumerate() {
        match banks.iter_mut().find(|(axis, _)| folded(cylinder.angle - axis).abs() < SAME) {
            Some((_, bank)) => bank.push(index),
            None => banks.push((cylinder.angle, vec![index])),
        }
    }
    if banks.len() > 2 {
        return Err(format!("it has {} banks", banks.len()));
    }
    if banks.len() == 2 && turned(banks[1].0 - banks[0].0) > PI + SAME {
        banks.swap(0, 1);
    }
    for (_, bank) in &mut banks {
        bank.sort_by(|&a, &b| engine.cylinders[a].z.total_cmp(&engine.cylinders[b].z));
    }
    Ok(banks.into_iter().map(|(_, bank)| bank).collect())
}
