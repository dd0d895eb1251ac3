//! Exact derivatives of outputs.

use super::bending::{BendingSpot, bending_slope, bending_spots};
use super::energy::{Energy, EnergySpots};
use super::error::SensitivityError;
use super::input::{Amount, Input};
use super::mains::Mains;
use super::mount_force::{MountForces, mount_orders};
use super::operating_point::OperatingPoint;
use super::output::{Output, Size, Target};
use super::over_time::known;
use super::prepared::Prepared;
use super::ripple::{Ripple, RippleSpots};
use super::slope::{Grown, Slope};
use super::stretch::{Stretch, stretches};
use super::train::{Side, Train};
use super::value::{nothing, values};
use super::wave::{Load, LoadAt, SAME_HEIGHT, Spot, Wave};
use num_dual::Dual64;
use rayon::prelude::*;

/// Derivatives of `outputs` at an operating point by `inputs`: by output, then by input.
///
/// A peak is differentiated where it stands (book, eq. 32.2), a mean and an order through their integrals (eq. 32.3), all of them with the
/// jumps of the pressures that move (eq. 32.6).
///
/// # Errors
/// [`SensitivityError`] where an output cannot be computed.
pub fn derivatives(
    point: &OperatingPoint,
    outputs: &[Output],
    inputs: &[Input],
) -> Result<Vec<Vec<Slope>>, SensitivityError> {
    outputs.iter().try_for_each(|output| output.check(point))?;
    values(point, outputs)?;
    outputs.iter().map(|output| slopes(point, *output, inputs)).collect()
}

fn slopes(point: &OperatingPoint, output: Output, inputs: &[Input]) -> Result<Vec<Slope>, SensitivityError> {
    let prepared = Prepared::new(point, output)?;
    let nothing = nothing(point, output);
    let spots = {
        let train = Train::new(&prepared, Input::idle(), Side::Up);
        let stretches = stretches(&train);
        Sample { train: &train, stretches: &stretches, output, nothing }.spots()
    };
    let one = |input: &Input| {
        // Over a usual range what is less than nothing of the output is rounding.
        let usual = Amount::standard(input.quantity.measure()).half_width(input.nominal(point));
        let [up, down] = [Side::Up, Side::Down].map(|side| {
            let train = Train::new(&prepared, *input, side);
            let stretches = stretches(&train);
            Sample { train: &train, stretches: &stretches, output, nothing }.slope(&spots, usual)
        });
        Slope { up: up.slope.up, down: down.slope.down }.joined(up.growth.max(down.growth), nothing / usual)
    };
    Ok(inputs.par_iter().map(one).collect())
}

/// What of an output is differentiated: where it stands at the operating point.
enum Spots {
    /// The largest height, and of the waves of these numbers, which have it, the peaks; for a mean of sizes their narrow valleys.
    Waves(f64, Vec<(usize, Vec<Spot>)>),
    /// Of the accumulated energy.
    Energy(EnergySpots),
    /// Of the speed.
    Ripple(RippleSpots),
    /// Of the bending moment along crankshafts.
    Bending(Vec<BendingSpot>),
}

/// An output of a train.
struct Sample<'a> {
    train: &'a Train<'a>,
    stretches: &'a [Stretch],
    output: Output,
    nothing: f64,
}

impl<'a> Sample<'a> {
    fn spots(&self) -> Spots {
        match self.output.target {
            Target::ExcessEnergy => {
                return Spots::Energy(Energy::of(self.train, self.stretches).spots(self.nothing).1);
            }
            Target::SpeedFluctuation => {
                return Spots::Ripple(Ripple::of(self.train, self.stretches).spots());
            }
            Target::BendingMoment(_) => {
                return Spots::Bending(bending_spots(self.train, &self.numbers()).1);
            }
            _ => {}
        }
        let all: Vec<(usize, f64, Vec<Spot>)> = match self.mount_order() {
            Some(forces) => self
                .numbers()
                .into_iter()
                .map(|mount| (mount, forces.order(mount, self.nothing).0, Vec::new()))
                .collect(),
            None => {
                let waves = self.waves();
                let of = |(number, wave): (usize, &Wave<'_>)| {
                    let (height, spots) = match self.output.size {
                        Size::Peak => wave.peaks(),
                        Size::Mean if !self.is_signed() => {
                            let valleys = wave.valleys();
                            (self.integral(wave, &valleys).0, valleys)
                        }
                        Size::Mean | Size::Order(_) => (self.integral(wave, &[]).0.abs(), Vec::new()),
                    };
                    (number, height, spots)
                };
                self.numbers().into_iter().zip(&waves).map(of).collect()
            }
        };
        let best = all.iter().map(|(_, height, _)| *height).fold(0.0, f64::max);
        let largest = all.into_iter().filter(|(_, height, _)| *height >= best * (1.0 - SAME_HEIGHT));
        Spots::Waves(best, largest.map(|(number, _, spots)| (number, spots)).collect())
    }

    /// Its slope, where the input goes as far as `usual`.
    fn slope(&self, spots: &Spots, usual: f64) -> Grown {
        let (best, places) = match spots {
            Spots::Energy(spots) => return Energy::of(self.train, self.stretches).slope(spots),
            Spots::Ripple(spots) => return Ripple::of(self.train, self.stretches).slope(spots),
            Spots::Bending(spots) => return bending_slope(self.train, spots, self.nothing),
            Spots::Waves(best, places) => (*best, places),
        };
        if let Some(forces) = self.mount_order() {
            let own = places.iter().map(|(mount, _)| forces.order(*mount, self.nothing).1);
            return Grown::of_largest(own);
        }
        let (numbers, waves) = (self.numbers(), self.waves());
        let range = self.train.side.sign() * usual;
        if self.output.size == Size::Peak && waves.iter().any(|wave| wave.leaps(best, range)) {
            return Grown::LEAP;
        }
        let of = |(number, spots): &(usize, Vec<Spot>)| {
            let place = numbers.iter().position(|own| own == number).unwrap_or(0);
            match self.output.size {
                Size::Peak => waves[place].at_peaks(spots),
                _ => self.integral(&waves[place], spots).1,
            }
        };
        Grown::of_largest(places.iter().map(of))
    }

    /// Whether a mean is one with its sign.
    fn is_signed(&self) -> bool {
        self.output.target == Target::Torque
    }

    /// Mean or order of a wave, whose size has these narrow valleys.
    fn integral(&self, wave: &Wave<'_>, valleys: &[Spot]) -> (f64, Grown) {
        let period = self.train.prepared.period;
        match self.output.size {
            Size::Order(order) => wave.order(order, period),
            Size::Peak | Size::Mean => wave.mean(period, self.is_signed(), valleys),
        }
    }

    /// Forces on mounts where one order of them is asked for.
    fn mount_order(&self) -> Option<MountForces> {
        match (self.output.target, self.output.size) {
            (Target::MountForce(_), Size::Order(order)) => {
                Some(MountForces::of(self.train, self.stretches, &[order]))
            }
            _ => None,
        }
    }

    /// Numbers of the bearings, cylinders or mounts that are looked at.
    fn numbers(&self) -> Vec<usize> {
        let engine = self.train.engine;
        let (one, count) = match self.output.target {
            Target::MainBearing(one) => (one, Mains::of(self.train).count()),
            Target::Crankpin(one) | Target::PistonPin(one) | Target::SideThrust(one) => {
                (one, engine.cylinders.len())
            }
            Target::MountForce(one) => (one, engine.mounts.len()),
            Target::BendingMoment(one) => (one, engine.crankshafts.len()),
            _ => (Some(0), 1),
        };
        one.map_or_else(|| (0..count).collect(), |one| vec![one])
    }

    /// The load over the cycle, of each of [`Sample::numbers`].
    fn waves(&self) -> Vec<Wave<'a>> {
        let train = self.train;
        let wave = |is_number: bool, at: LoadAt<'a>| Wave {
            stretches: self.stretches,
            at,
            is_number,
            nothing: self.nothing,
        };
        let numbers = self.numbers().into_iter();
        match self.output.target {
            Target::Force => vec![wave(false, Box::new(|theta, _| plane(train.loads(theta).force)))],
            Target::Couple => vec![wave(false, Box::new(|theta, _| plane(train.loads(theta).couple)))],
            Target::RollMoment => vec![wave(true, Box::new(|theta, _| number(train.loads(theta).roll)))],
            Target::Torque | Target::ExcessEnergy | Target::SpeedFluctuation | Target::BendingMoment(_) => {
                vec![wave(true, Box::new(|theta, windows| number(train.torque(theta, windows))))]
            }
            Target::MainBearing(_) => numbers
                .map(|main| {
                    let mains = Mains::of(train);
                    wave(
                        false,
                        Box::new(move |theta, windows| plane(mains.force(main, train, theta, windows))),
                    )
                })
                .collect(),
            Target::Crankpin(_) => numbers
                .map(|rod| {
                    wave(
                        false,
                        Box::new(move |theta, windows| plane(train.pin_force(rod, theta, windows).lower_pin)),
                    )
                })
                .collect(),
            Target::PistonPin(_) => numbers
                .map(|rod| {
                    wave(
                        false,
                        Box::new(move |theta, windows| {
                            plane(train.pin_force(rod, theta, windows).piston_pin)
                        }),
                    )
                })
                .collect(),
            Target::SideThrust(_) => numbers
                .map(|rod| {
                    wave(
                        true,
                        Box::new(move |theta, windows| number(train.pin_force(rod, theta, windows).thrust)),
                    )
                })
                .collect(),
            Target::MountForce(_) => {
                let orders = mount_orders(train.prepared.period);
                let forces = std::sync::Arc::new(MountForces::of(train, self.stretches, &orders));
                numbers
                    .map(|mount| {
                        let forces = forces.clone();
                        wave(false, Box::new(move |theta, _| forces.at(mount, theta)))
                    })
                    .collect()
            }
        }
    }
}

fn plane([x, y]: [Dual64; 2]) -> Load {
    [x, y, known(0.0)]
}

fn number(value: Dual64) -> Load {
    [value, known(0.0), known(0.0)]
}
