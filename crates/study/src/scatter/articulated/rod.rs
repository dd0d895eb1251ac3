//! An articulated rod with its piston: its dimensions, and how far they may be off.

use crate::scatter::articulated::motion::{Dimensions, KnucklePin, VARIED};
use crate::scatter::articulated::quadrature::LaneDimensions;
use crate::scatter::moving_parts::MovingParts;
use crate::scatter::plain_rod::PlainRod;
use crate::scatter::value::Value;
use lanchester_numerics::{ComplexLanes, LANES, Lanes};

/// An articulated rod with its piston.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ArticulatedRod {
    pub parts: MovingParts,
    pub pin: KnucklePin,
    /// The reach over the rod's length is nowhere less than this.
    pub least_reach: f64,
}

impl ArticulatedRod {
    /// Its dimensions: nominal value and how far it may be off, in the order of [`Dimensions::from_array`].
    pub fn dimensions(&self, master: &PlainRod) -> [[f64; 2]; VARIED] {
        let of = |value: &Value| [value.nominal, value.half];
        let (own, driver) = (&self.parts, &master.parts);
        let turn = [driver.axis.nominal - own.axis.nominal, driver.axis.half + own.axis.half];
        [of(&master.radius), of(&driver.length), of(&driver.offset), turn, of(&own.length), of(&own.offset)]
    }

    /// All corners of the tolerances of its dimensions, eight at a time.
    pub fn corners(&self, master: &PlainRod) -> Vec<LaneDimensions> {
        let dimensions = self.dimensions(master);
        let varied: Vec<usize> = (0..VARIED).filter(|&k| dimensions[k][1] > 0.0).collect();
        let corner = |number: usize| {
            let mut values = dimensions.map(|[nominal, _]| nominal);
            for (bit, &k) in varied.iter().enumerate() {
                let side = if number >> bit & 1 == 1 { 1.0 } else { -1.0 };
                values[k] += side * dimensions[k][1];
            }
            Dimensions::from_array(values)
        };
        let corners: Vec<Dimensions<f64>> = (0..1 << varied.len()).map(corner).collect();
        corners
            .chunks(LANES)
            .map(|some| {
                let lane = |i: usize| some[i.min(some.len() - 1)];
                let direction = |angle: &dyn Fn(usize) -> f64| ComplexLanes {
                    re: Lanes::each(|i| angle(i).cos()),
                    im: Lanes::each(|i| angle(i).sin()),
                };
                let arm = direction(&|i| self.pin.angle + lane(i).turn);
                let arm_length = Lanes::each(|i| self.pin.radius / lane(i).master_length);
                LaneDimensions {
                    radius: Lanes::each(|i| lane(i).radius),
                    master_length: Lanes::each(|i| lane(i).master_length),
                    master_offset: Lanes::each(|i| lane(i).master_offset),
                    turn: direction(&|i| lane(i).turn),
                    arm: ComplexLanes { re: arm.re * arm_length, im: arm.im * arm_length },
                    length: Lanes::each(|i| lane(i).length),
                    offset: Lanes::each(|i| lane(i).offset),
                }
            })
            .collect()
    }
}
