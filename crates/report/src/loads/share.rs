//! What each throw and each device adds to one order: the curves of a balance plot.

use lanchester_mechanism::Loads;
use lanchester_model::{Engine, Ratio};
use num_complex::Complex64;

/// What a share comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Source {
    Throw,
    Counterweight,
    Shaft,
}

/// Force [N] and couple [N m] of one order, each as its part that turns with the crank and its part against it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Turning {
    pub force: [Complex64; 2],
    pub couple: [Complex64; 2],
}

impl Turning {
    fn add(&mut self, other: &Turning) {
        for sense in 0..2 {
            self.force[sense] += other.force[sense];
            self.couple[sense] += other.couple[sense];
        }
    }

    /// An unbalance [kg m] on a shaft of this ratio, in the plane z [m] from the reference point; nothing if the shaft
    /// turns at another order.
    fn weight(unbalance: Complex64, z: f64, ratio: Ratio, order: i32, speed: f64) -> Turning {
        let mut turning = Turning::default();
        if ratio.denominator() == 1 && ratio.numerator().abs() == order {
            let sense = usize::from(ratio.numerator() < 0);
            turning.force[sense] = unbalance * (f64::from(order) * speed).powi(2);
            turning.couple[sense] = Complex64::new(0.0, z) * turning.force[sense];
        }
        turning
    }
}

/// The share of one throw or device.
#[derive(Debug, Clone)]
pub(crate) struct Share {
    pub source: Source,
    /// Number from 1: of the throw, of the counterweight, of the shaft.
    pub number: usize,
    pub turning: Turning,
}

/// Crank and big ends of each throw and the weights on the crankshafts, first order.
pub(crate) fn turning_masses(engine: &Engine, loads: &Loads) -> Vec<Share> {
    let place = |z: f64| z - loads.reference[2];
    let mut shares: Vec<Share> = (0..engine.throws.len())
        .map(|index| {
            let throw = &engine.throws[index];
            let ratio = engine.crankshafts[throw.crankshaft].ratio;
            let direction = Complex64::cis(engine.pin_angle(index, 0.0));
            let at = |unbalance: f64, z: f64| {
                Turning::weight(unbalance * direction, place(z), ratio, 1, loads.speed)
            };
            let mut turning = at(throw.unbalance, throw.z);
            for cylinder in engine.cylinders.iter().filter(|c| c.throw == index) {
                turning.add(&at(cylinder.rod.big_end_mass * throw.radius, cylinder.z));
            }
            Share { source: Source::Throw, number: index + 1, turning }
        })
        .collect();
    shares.extend(counterweights(engine, loads, 1));
    shares
}

/// One order of everything on each throw, pistons included, of the counterweights and of the balance shafts.
pub(crate) fn whole_order(engine: &Engine, loads: &Loads, order: i32) -> Vec<Share> {
    let mut shares: Vec<Share> = (0..engine.throws.len())
        .map(|index| {
            let mut turning = Turning::default();
            let riders = loads.cylinders.iter().filter(|c| engine.cylinders[c.cylinder - 1].throw == index);
            let orders = riders.flat_map(|c| &c.loads.orders).filter(|o| o.order == f64::from(order));
            for o in orders {
                turning.add(&Turning {
                    force: [o.force_forward, o.force_backward],
                    couple: [o.couple_forward, o.couple_backward],
                });
            }
            Share { source: Source::Throw, number: index + 1, turning }
        })
        .collect();
    shares.extend(counterweights(engine, loads, order));
    shares.extend(engine.shafts.iter().enumerate().map(|(index, shaft)| {
        let mut turning = Turning::default();
        for weight in &shaft.weights {
            let unbalance = Complex64::from_polar(weight.unbalance, weight.phase);
            let z = weight.z - loads.reference[2];
            turning.add(&Turning::weight(unbalance, z, shaft.ratio, order, loads.speed));
        }
        Share { source: Source::Shaft, number: index + 1, turning }
    }));
    shares
}

fn counterweights(engine: &Engine, loads: &Loads, order: i32) -> Vec<Share> {
    let turning = |weight: &lanchester_model::Counterweight| {
        let shaft = &engine.crankshafts[weight.crankshaft];
        let unbalance = Complex64::from_polar(weight.unbalance, shaft.phase + weight.angle);
        Turning::weight(unbalance, weight.z - loads.reference[2], shaft.ratio, order, loads.speed)
    };
    let number = |(index, weight)| Share {
        source: Source::Counterweight,
        number: index + 1,
        turning: turning(weight),
    };
    engine.counterweights.iter().enumerate().map(number).collect()
}

/// Sum of all shares.
pub(crate) fn resultant(shares: &[Share]) -> Turning {
    let mut sum = Turning::default();
    for share in shares {
        sum.add(&share.turning);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_file::{read, templates};
    use lanchester_mechanism::{LoadRequest, loads};

    /// Shares add up to the loads of the whole engine, for every engine of the gallery whose throws all carry rods.
    #[test]
    fn shares_add_up_to_the_whole() {
        let mut compared = 0;
        for template in templates() {
            let engine = read(template.text).engine().expect("the gallery is valid");
            let loads =
                loads(&engine, &LoadRequest { samples: 8, ..LoadRequest::default() }).expect("it turns");
            for order in [1, 2] {
                let sum = resultant(&whole_order(&engine, &loads, order));
                let whole = loads.total.orders.iter().find(|o| o.order == f64::from(order)).expect("listed");
                let pairs = [
                    (sum.force, [whole.force_forward, whole.force_backward], 1e-4),
                    (sum.couple, [whole.couple_forward, whole.couple_backward], 1e-4),
                ];
                for (ours, theirs, rounding) in pairs {
                    for sense in 0..2 {
                        let left = (ours[sense] - theirs[sense]).norm();
                        assert!(left < rounding, "{} order {order}: {left}", engine.name);
                    }
                }
                compared += 1;
            }
        }
        assert!(compared >= 80, "{compared}");
    }
}
