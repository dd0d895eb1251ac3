//! Curves over the crank angle, by the names that the lists of figures use.
//!
//! | name | what it is |
//! |---|---|
//! | `Fx`, `Fy`, `Fres` | force along x and y, and its amount |
//! | `Mx`, `My`, `Mz`, `Mres` | couples; `M_z` of shafts and weights alone, and `M_res` with it, as in [`crate::quantity`] |
//! | `... order n`, `... of reciprocating`, `... of cylinder 1` | of one order of a force or couple, and of these parts alone |
//! | `position`, `velocity`, `acceleration`, `travel` | of the piston of cylinder 1; travel from its top dead centre |
//! | `torque`, `gas torque`, `inertia torque`, `mean torque` | on the crankshaft, with the lever `r sin(theta)` |
//! | `pressure` | absolute, in cylinder 1 |
//! | `gas force`, `total force` | of the gas on all pistons along x, away from the crank; with the inertia force |
//! | `radial rod force`, `tangential rod force` | on the crankpin of cylinder 1, towards the crank axis and in the sense of rotation |
//! | `simulated ...` | of the motion or a rod force: of the crank train as rigid bodies, simulated at this speed in a block that stands |

use crate::case::Run;
use crate::gas_run::GasRun;
use crate::quantity::{Selection, thesis_moment};
use crate::rigid_run::RigidQuantity;
use lanchester::model::Cylinder;
use lanchester::results::{LoadSet, OrderLoads, Trace};
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_4, TAU};

/// Values over a whole number of revolutions, evenly spaced from 0, the end excluded.
pub(crate) struct Samples {
    pub revolutions: usize,
    pub values: Vec<f64>,
}

impl Samples {
    fn of(period: f64, values: Vec<f64>) -> Samples {
        Samples { revolutions: (period / TAU).round().max(1.0) as usize, values }
    }

    /// The same over more revolutions, with as many values in each: those of a coarser grid where both grids meet.
    pub fn over(&self, revolutions: usize, each: usize) -> Result<Vec<f64>, String> {
        let own = self.values.len() / self.revolutions;
        if each == 0 || !own.is_multiple_of(each) || !revolutions.is_multiple_of(self.revolutions) {
            return Err(format!("{own} values a revolution do not hold {each}"));
        }
        let count = self.values.len();
        Ok((0..revolutions * each).map(|k| self.values[k * (own / each) % count]).collect())
    }
}

/// A curve over the crank angle.
pub(crate) enum CurveKey {
    Load { component: Component, order: Option<f64>, selection: Selection },
    Motion(Motion),
    Torque(Torque),
    Pressure,
    GasForce { with_inertia: bool },
    RodForce { radial: bool },
    Simulated(RigidQuantity),
}

/// Of force and couple.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Component {
    ForceX,
    ForceY,
    Force,
    CoupleX,
    CoupleY,
    RollOfShafts,
    Moment,
}

const COMPONENTS: [(&str, Component); 7] = [
    ("Fx", Component::ForceX),
    ("Fy", Component::ForceY),
    ("Fres", Component::Force),
    ("Mx", Component::CoupleX),
    ("My", Component::CoupleY),
    ("Mz", Component::RollOfShafts),
    ("Mres", Component::Moment),
];

/// Of a piston.
#[derive(Clone, Copy)]
pub(crate) enum Motion {
    Position,
    Travel,
    Velocity,
    Acceleration,
}

/// On the crankshaft.
#[derive(Clone, Copy)]
pub(crate) enum Torque {
    Total,
    Gas,
    Inertia,
    Mean,
}

impl CurveKey {
    /// The curve of this name.
    pub fn parse(text: &str) -> Result<CurveKey, String> {
        Ok(match text {
            "position" => CurveKey::Motion(Motion::Position),
            "travel" => CurveKey::Motion(Motion::Travel),
            "velocity" => CurveKey::Motion(Motion::Velocity),
            "acceleration" => CurveKey::Motion(Motion::Acceleration),
            "torque" => CurveKey::Torque(Torque::Total),
            "gas torque" => CurveKey::Torque(Torque::Gas),
            "inertia torque" => CurveKey::Torque(Torque::Inertia),
            "mean torque" => CurveKey::Torque(Torque::Mean),
            "pressure" => CurveKey::Pressure,
            "gas force" => CurveKey::GasForce { with_inertia: false },
            "total force" => CurveKey::GasForce { with_inertia: true },
            "radial rod force" => CurveKey::RodForce { radial: true },
            "tangential rod force" => CurveKey::RodForce { radial: false },
            "simulated position" => CurveKey::Simulated(RigidQuantity::Travel(0)),
            "simulated velocity" => CurveKey::Simulated(RigidQuantity::Travel(1)),
            "simulated acceleration" => CurveKey::Simulated(RigidQuantity::Travel(2)),
            "simulated radial rod force" => CurveKey::Simulated(RigidQuantity::RodForce { radial: true }),
            "simulated tangential rod force" => {
                CurveKey::Simulated(RigidQuantity::RodForce { radial: false })
            }
            _ => return CurveKey::load(text),
        })
    }

    fn load(text: &str) -> Result<CurveKey, String> {
        let (name, selection) = match text.split_once(" of ") {
            Some((name, whose)) => (name, Selection::parse(whose)?),
            None => (text, Selection::Total),
        };
        let (name, order) = match name.split_once(" order ") {
            Some((name, order)) => (name, Some(order)),
            None => (name, None),
        };
        let unknown = || format!("no curve is called {text:?}");
        let order = order.map(|order| order.parse().map_err(|_| unknown())).transpose()?;
        let (_, component) = COMPONENTS.iter().find(|(own, _)| *own == name).ok_or_else(unknown)?;
        let whole_engine = matches!(component, Component::RollOfShafts | Component::Moment);
        if whole_engine && (order.is_some() || !matches!(selection, Selection::Total)) {
            return Err(unknown());
        }
        Ok(CurveKey::Load { component: *component, order, selection })
    }

    /// Its values.
    pub fn of(&self, run: &Run) -> Result<Samples, String> {
        match self {
            CurveKey::Load { component, order, selection } => {
                let values = loads(run, *component, *order, selection)?;
                Ok(Samples::of(run.loads.period, values))
            }
            CurveKey::Motion(motion) => {
                let first = run.loads.motion.first().ok_or("the engine has no cylinder")?;
                let trace = &first.trace;
                Ok(Samples::of(
                    run.loads.period,
                    match motion {
                        Motion::Position => trace.position.clone(),
                        Motion::Travel => trace.position.iter().map(|place| first.top - place).collect(),
                        Motion::Velocity => trace.velocity.clone(),
                        Motion::Acceleration => trace.acceleration.clone(),
                    },
                ))
            }
            CurveKey::Simulated(quantity) => {
                let (revolutions, values) = quantity.of(run)?;
                Ok(Samples { revolutions, values })
            }
            CurveKey::Torque(_)
            | CurveKey::Pressure
            | CurveKey::GasForce { .. }
            | CurveKey::RodForce { .. } => self.of_gas(run, run.with_gas()?),
        }
    }

    fn of_gas(&self, run: &Run, gas: &GasRun) -> Result<Samples, String> {
        let torque = &gas.torque;
        let first = torque.cylinders.first().ok_or("the engine has no cylinder")?;
        let both = || torque.gas.iter().zip(&torque.inertia).map(|(a, b)| a + b).collect();
        Ok(match self {
            CurveKey::Torque(Torque::Total) => Samples::of(torque.period, both()),
            CurveKey::Torque(Torque::Gas) => Samples::of(torque.period, torque.gas.clone()),
            CurveKey::Torque(Torque::Inertia) => Samples::of(torque.period, torque.inertia.clone()),
            CurveKey::Torque(Torque::Mean) => {
                Samples::of(torque.period, vec![torque.indicated.torque; torque.theta.len()])
            }
            CurveKey::Pressure => Samples::of(torque.period, first.pressure.clone()),
            CurveKey::GasForce { with_inertia } => {
                let mut force = gas_force(run, gas)?;
                if *with_inertia {
                    let own = loads(run, Component::ForceX, None, &Selection::Total)?;
                    let inertia = Samples::of(run.loads.period, own);
                    let each = force.values.len() / force.revolutions;
                    let inertia = inertia.over(force.revolutions, each)?;
                    force.values.iter_mut().zip(inertia).for_each(|(sum, more)| *sum += more);
                }
                force
            }
            CurveKey::RodForce { radial } => {
                let pin = gas.bearings.cylinders.first().ok_or("the engine has no cylinder")?;
                // Against the outward direction of the results.
                let inward = || pin.radial.iter().map(|force| -force).collect();
                Samples::of(gas.bearings.period, if *radial { inward() } else { pin.tangential.clone() })
            }
            CurveKey::Load { .. } | CurveKey::Motion(_) | CurveKey::Simulated(_) => {
                return Err("it needs no gas".to_string());
            }
        })
    }
}

/// Of all pistons along x, of cylinders that stand along x or against it.
fn gas_force(run: &Run, gas: &GasRun) -> Result<Samples, String> {
    let mut force = vec![0.0; gas.torque.theta.len()];
    for (cylinder, own) in run.engine.cylinders.iter().zip(&gas.torque.cylinders) {
        let bore = cylinder.bore.ok_or("the engine has no bore")?;
        let along = -cylinder.angle.cos() * FRAC_PI_4 * bore * bore;
        let pressures = own.pressure.iter().zip(&own.crankcase);
        force.iter_mut().zip(pressures).for_each(|(sum, (above, below))| *sum += along * (above - below));
    }
    Ok(Samples::of(gas.torque.period, force))
}

fn loads(
    run: &Run,
    component: Component,
    order: Option<f64>,
    selection: &Selection,
) -> Result<Vec<f64>, String> {
    match component {
        Component::RollOfShafts => return Ok(run.roll_of_shafts()),
        Component::Moment => return Ok(thesis_moment(run)),
        _ => {}
    }
    let theta = &run.loads.total.trace.theta;
    let mut sums = vec![Complex64::default(); theta.len()];
    let is_couple = matches!(component, Component::CoupleX | Component::CoupleY);
    for set in selection.sets(run)? {
        match order {
            None => add_trace(&mut sums, &set.trace, is_couple),
            Some(order) => add_order(&mut sums, set, theta, order, is_couple),
        }
    }
    let of = |vector: &Complex64| match component {
        Component::ForceX | Component::CoupleX => vector.re,
        Component::ForceY | Component::CoupleY => vector.im,
        Component::Force | Component::Moment | Component::RollOfShafts => vector.norm(),
    };
    let values: Vec<f64> = sums.iter().map(of).collect();
    let is_rounding = values.iter().all(|value| value.abs() < 1e-9 * unit_of(run, is_couple));
    Ok(if is_rounding { vec![0.0; values.len()] } else { values })
}

/// Force or couple that the reciprocating masses of the engine could have: what is far below is rounding.
fn unit_of(run: &Run, is_couple: bool) -> f64 {
    let of = |cylinder: &Cylinder| {
        let lever = if is_couple { cylinder.z.abs() + cylinder.rod.length } else { 1.0 };
        let radius = run.engine.throws.get(cylinder.throw).map_or(0.0, |throw| throw.radius);
        cylinder.reciprocating_mass() * radius * run.loads.speed.powi(2) * lever
    };
    run.engine.cylinders.iter().map(of).sum()
}

fn add_trace(sums: &mut [Complex64], trace: &Trace, is_couple: bool) {
    let [x, y] =
        if is_couple { [&trace.couple_x, &trace.couple_y] } else { [&trace.force_x, &trace.force_y] };
    sums.iter_mut().zip(x.iter().zip(y)).for_each(|(sum, (x, y))| *sum += Complex64::new(*x, *y));
}

fn add_order(sums: &mut [Complex64], set: &LoadSet, theta: &[f64], order: f64, is_couple: bool) {
    let (forward, backward) = halves(set, order, is_couple);
    for (sum, theta) in sums.iter_mut().zip(theta) {
        let turned = Complex64::from_polar(1.0, order * theta);
        *sum += forward * turned + backward * turned.conj();
    }
}

/// What turns with the crank and against it, of one order.
pub(crate) fn halves(set: &LoadSet, order: f64, is_couple: bool) -> (Complex64, Complex64) {
    let of_order = set.orders.iter().find(|own: &&OrderLoads| own.order == order);
    of_order.map_or_else(Default::default, |own| {
        if is_couple {
            (own.couple_forward, own.couple_backward)
        } else {
            (own.force_forward, own.force_backward)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        for name in [
            "Fx",
            "simulated velocity",
            "My order 2",
            "Fx order 1 of rotating + counterweights",
            "Mres",
            "gas torque",
        ] {
            assert!(CurveKey::parse(name).is_ok(), "{name}");
        }
        for name in
            ["Fz", "simulated Fx", "Mres order 1", "Mz of shafts", "Fx order one", "Fx of lid", "power"]
        {
            assert!(CurveKey::parse(name).is_err(), "{name}");
        }
    }

    #[test]
    fn curves_go_on_over_more_revolutions() {
        let samples = Samples { revolutions: 1, values: vec![0.0, 1.0, 2.0, 3.0] };
        assert_eq!(samples.over(2, 2), Ok(vec![0.0, 2.0, 0.0, 2.0]));
        assert!(samples.over(1, 3).is_err() && samples.over(1, 0).is_err());
    }
}
