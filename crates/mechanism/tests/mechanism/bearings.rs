//! Bearing loads: equilibrium of every body, the work through the rods, the reaction on the block, the kernel against the plain form.

use crate::support;
use crate::support::pressure::{any_gas, block, cycle, diesel_like, fired};
use crate::support::random::{ALL_SHAPES, any_engine};
use crate::support::{assert_close, cylinder, engine, in_line, throw, vee};
use lanchester_mechanism::*;
use lanchester_model::*;
use num_complex::Complex64;
use proptest::prelude::*;
use std::f64::consts::PI;

fn any_fired() -> impl Strategy<Value = (Engine, Vec<CylinderGas>)> {
    (any_engine(ALL_SHAPES), any::<bool>()).prop_flat_map(|(engine, two)| {
        let mut engine = fired(engine, 0.07, if two { Strokes::Two } else { Strokes::Four });
        // A crankshaft without throws has no bearings that could carry its weights.
        let used: Vec<usize> = engine.throws.iter().map(|throw| throw.crankshaft).collect();
        engine = engine
            .with(|engine| {
                engine.counterweights.retain(|weight| used.contains(&weight.crankshaft));
            })
            .unwrap();
        let gas = prop::collection::vec(any_gas(cycle(&engine)), engine.cylinders.len());
        (Just(engine), gas)
    })
}

/// Largest load of any bearing [N].
fn scale(loads: &BearingLoads) -> f64 {
    let rods = loads.cylinders.iter().flat_map(|c| [c.piston_pin.peak.value, c.lower_pin.peak.value]);
    rods.chain(loads.mains.iter().map(|m| m.load.peak.value)).fold(1.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// Side thrust, mains, gas on the heads and balance shafts are all that the block feels: their sum is the shaking force of
    /// inertia, their moments about x and y its couple, and that about z the roll moment of inertia less the gas torque.
    #[test]
    fn prop_the_block_feels_inertia_and_the_reaction_to_the_gas_torque((engine, gas) in any_fired()) {
        let request = BearingRequest { samples: 23, ..BearingRequest::default() };
        let bearings = bearing_loads(&engine, Some(&gas), &request).unwrap();
        let train = GasTrain::new(&engine, &gas, Lever::Exact).unwrap();
        let bare = engine.without_shafts();
        let inertia = Mechanism::new(&bare, &LoadRequest::default()).unwrap();
        let motion = motion(&engine, &LoadRequest { samples: 1, ..LoadRequest::default() }).unwrap();
        let scale = scale(&bearings);
        for (j, theta) in bearings.theta.iter().enumerate() {
            let mut force = Complex64::ZERO;
            // SUM z F: the couple is i times it.
            let mut lever = Complex64::ZERO;
            let mut reach = 0.0f64;
            let mut roll = 0.0;
            let mut torques = 0.0;
            for main in &bearings.mains {
                let shaft = &engine.crankshafts[main.crankshaft - 1];
                force += main.load.load[j];
                lever += main.z * main.load.load[j];
                reach = reach.max(main.z.abs());
                roll += shaft.x * main.load.load[j].im - shaft.y * main.load.load[j].re;
            }
            for (index, (cylinder, own)) in engine.cylinders.iter().zip(&bearings.cylinders).enumerate() {
                let shaft = &engine.crankshafts[engine.throws[cylinder.throw].crankshaft];
                let axis = Complex64::new(shaft.x, shaft.y);
                let u = Complex64::cis(cylinder.angle);
                let v = u * Complex64::I;
                let turned = shaft.ratio.value().abs() * (theta - motion[index].firing_angle.unwrap());
                let area = 0.25 * PI * cylinder.bore.unwrap().powi(2);
                let gas = area * (gas[index].cylinder.at(turned) - gas[index].crankcase.at(turned));
                let on_head = gas * u;
                let on_wall = own.side_thrust[j] * v;
                let moment = |at: Complex64, force: Complex64| (at.conj() * force).im;
                force += on_head + on_wall;
                lever += cylinder.z * (on_head + on_wall);
                reach = reach.max(cylinder.z.abs());
                let [_, pin, _] = support::brute::joints(&engine, index, *theta);
                let pin = Complex64::new(pin[0], pin[1]);
                roll += moment(axis + cylinder.offset * v, on_head) + moment(pin, on_wall);
                // Gas and the piston's inertia act on the bore's axis, beside its pin: the wall holds it upright.
                let h = 1e-3;
                let at = |shift: f64| {
                    let [_, _, centre] = support::brute::joints(&engine, index, theta + shift);
                    centre[0] * u.re + centre[1] * u.im
                };
                let second = (-at(2.0 * h) + 16.0 * at(h) - 30.0 * at(0.0) + 16.0 * at(-h) - at(-2.0 * h))
                    / (12.0 * h * h);
                let inertia = cylinder.piston_mass * second * bearings.speed.powi(2);
                roll -= (gas + inertia) * cylinder.pin_offset;
                torques += (own.tangential.get(j).copied().unwrap_or(0.0)) * engine.throws[cylinder.throw].radius
                    * shaft.ratio.value().abs();
            }
            let wanted = inertia.components(*theta);
            prop_assert!((force.re - wanted.force_x).abs() < 1e-9 * scale, "{} {}", force.re, wanted.force_x);
            prop_assert!((force.im - wanted.force_y).abs() < 1e-9 * scale);
            // Planes of articulated rods differ from those of their masters.
            let [about_x, about_y] = [-lever.im, lever.re];
            prop_assert!((about_x - wanted.couple_x).abs() < 1e-9 * scale * reach, "{about_x} {}", wanted.couple_x);
            prop_assert!((about_y - wanted.couple_y).abs() < 1e-9 * scale * reach, "{about_y} {}", wanted.couple_y);
            let torque = train.torque(*theta) + wanted.shaft_torque;
            prop_assert!((torques - torque).abs() < 1e-9 * scale, "{torques} {torque}");
            // The gears bear on the block with what crankshafts of other speeds and senses do not carry through.
            let through: f64 = engine.cylinders.iter().zip(&bearings.cylinders).map(|(cylinder, own)| {
                let ratio = engine.crankshafts[engine.throws[cylinder.throw].crankshaft].ratio.value();
                own.tangential.get(j).map_or(0.0, |t| t * engine.throws[cylinder.throw].radius * ratio.signum() * (1.0 - ratio))
            }).sum();
            let got = roll + through;
            // Second differences of the piston's place: rounding near 1e-16 / h^2 of the accelerations.
            let wanted = wanted.roll_moment - train.torque(*theta);
            prop_assert!((got - wanted).abs() < 1e-6 * scale, "{got} {wanted} {scale}");
        }
    }

    /// Gas and inertia add up to both; loads of the counterweights are their own alone.
    #[test]
    fn prop_parts_add_up((engine, gas) in any_fired()) {
        let of = |part, counterweights| {
            let request = BearingRequest { samples: 12, part, counterweights, ..BearingRequest::default() };
            bearing_loads(&engine, Some(&gas), &request).unwrap()
        };
        let [all, pressed, moved] = [BearingPart::All, BearingPart::Gas, BearingPart::Inertia].map(|p| of(p, true));
        let scale = scale(&all) + scale(&pressed);
        for (k, main) in all.mains.iter().enumerate() {
            for j in 0..all.theta.len() {
                let sum = pressed.mains[k].load.load[j] + moved.mains[k].load.load[j];
                prop_assert!((main.load.load[j] - sum).norm() < 1e-11 * scale);
            }
        }
        for (k, own) in all.cylinders.iter().enumerate() {
            for j in 0..all.theta.len() {
                let sum = pressed.cylinders[k].lower_pin.load[j] + moved.cylinders[k].lower_pin.load[j];
                prop_assert!((own.lower_pin.load[j] - sum).norm() < 1e-11 * scale);
                let sum = pressed.cylinders[k].side_thrust[j] + moved.cylinders[k].side_thrust[j];
                prop_assert!((own.side_thrust[j] - sum).abs() < 1e-11 * scale);
            }
        }
        let bare = of(BearingPart::All, false);
        for (with, without) in all.cylinders.iter().zip(&bare.cylinders) {
            prop_assert_eq!(&with.lower_pin.load, &without.lower_pin.load);
        }
    }
}

/// The kernel by lanes against plain statics, of an engine with offsets, shared pins and odd numbers of angles.
#[test]
fn the_rod_carries_the_piston() {
    let mut engine = fired(vee(90.0, &[0.0, 90.0, 270.0, 180.0]), 0.09, Strokes::Four);
    engine = engine
        .with(|engine| {
            for (k, cylinder) in engine.cylinders.iter_mut().enumerate() {
                cylinder.offset = 0.002 * k as f64 - 0.005;
                cylinder.rod.inertia = Some(0.001);
            }
        })
        .unwrap();
    let gas: Vec<CylinderGas> = (0..8).map(|k| diesel_like(&engine, 2.0 + 0.1 * f64::from(k))).collect();
    let loads =
        bearing_loads(&engine, Some(&gas), &BearingRequest { samples: 91, ..BearingRequest::default() })
            .unwrap();
    assert_eq!(loads.theta.len(), 182);
    assert_eq!(loads.mains.len(), 5);
    for (index, (cylinder, own)) in engine.cylinders.iter().zip(&loads.cylinders).enumerate() {
        let linkage = RodLinkage::new(&engine, index).unwrap();
        for (j, theta) in loads.theta.iter().enumerate() {
            // Moments about the crankpin: side thrust and pin load are one force at the pin but for inertia, which has its own test;
            // what the rod passes down is the pin load less its own inertia.
            assert_eq!(own.piston_pin.load[j].im, own.side_thrust[j]);
            let place = linkage.at(*theta);
            let along = Complex64::cis(place.direction[0]);
            let in_frame = -own.lower_pin.load[j] * along.conj();
            assert!((own.rod_frame[j] - in_frame).norm() < 1e-9, "cylinder {}", cylinder.throw);
        }
    }
}

/// Slow engine, one constant pressure: the forces of the textbook triangle.
#[test]
fn a_slow_engine_has_the_textbook_triangle() {
    let mut engine =
        fired(engine("single", vec![throw(0.0, 0.0)], vec![cylinder(0, 0.0, 0.0)]), 0.08, Strokes::Four);
    engine = engine
        .with(|engine| {
            engine.cylinders[0].firing_angle = Some(0.0);
        })
        .unwrap();
    let gas = [block(&engine, 2e6, PI)];
    let request = BearingRequest { part: BearingPart::Gas, samples: 360, ..BearingRequest::default() };
    let loads = bearing_loads(&engine, Some(&gas), &request).unwrap();
    let force = 2e6 * 0.25 * PI * 0.08f64.powi(2);
    let own = &loads.cylinders[0];
    for j in (1..180).step_by(7) {
        let phi = loads.theta[j];
        let beta = (0.045 * phi.sin() / 0.15).asin();
        let close = |quantity: &str, got: f64, wanted: f64| {
            assert_close(quantity, got, wanted, 1e-9 * force, 0.0, "closed form");
        };
        close("side thrust", own.side_thrust[j], -force * beta.tan());
        close("pin", own.piston_pin.load[j].norm(), force / beta.cos());
        close("tangential", own.tangential[j], force * (phi + beta).sin() / beta.cos());
        close("radial", own.radial[j], -force * (phi + beta).cos() / beta.cos());
        // The rod is pressed along itself; each of two mains takes half.
        close("across the rod", own.rod_frame[j].im, 0.0);
        close("along the rod", own.rod_frame[j].re, force / beta.cos());
        let main = loads.mains[0].load.load[j];
        close("main, x", main.re, -0.5 * force);
        close("main, y", main.im, 0.5 * force * beta.tan());
    }
    assert!(loads.cylinders[0].lower_pin.load[200].norm() == 0.0);
    let pressure = own.piston_pin.pressure(BearingSize { diameter: 0.02, width: 0.03 });
    assert_close(
        "peak pressure",
        pressure.peak,
        own.piston_pin.peak.value / 6e-4,
        0.0,
        1e-14,
        "projected area",
    );
}

/// The peaks of coarse and of fine traces are the same.
#[test]
fn peaks_do_not_depend_on_the_angles_of_the_traces() {
    let engine = fired(vee(90.0, &[0.0, 90.0, 270.0, 180.0]), 0.09, Strokes::Four);
    let gas = vec![diesel_like(&engine, 2.0); engine.cylinders.len()];
    let at = |samples| {
        bearing_loads(&engine, Some(&gas), &BearingRequest { samples, ..BearingRequest::default() })
    };
    let (coarse, fine) = (at(180).unwrap(), at(1440).unwrap());
    let peaks = |loads: &BearingLoads| -> Vec<f64> {
        let rods = loads.cylinders.iter();
        let rods =
            rods.flat_map(|c| [c.largest_thrust.value, c.piston_pin.peak.value, c.lower_pin.peak.value]);
        rods.chain(loads.mains.iter().map(|m| m.load.peak.value)).collect()
    };
    let on_grid = fine.mains[0].load.load.iter().map(|force| force.norm()).fold(0.0, f64::max);
    assert!(fine.mains[0].load.peak.value >= on_grid);
    for (coarse, fine) in peaks(&coarse).into_iter().zip(peaks(&fine)) {
        assert_close("peak", coarse, fine, 0.0, 1e-9, "both are maxima over the continuous angle");
    }
}

/// A counterweight that holds rotating masses and half of the reciprocating ones lowers the main bearings' load at speed.
#[test]
fn counterweights_unload_the_mains() {
    let mut engine = fired(in_line(&[0.0, 180.0, 180.0, 0.0]), 0.08, Strokes::Four);
    let forces = |engine: &Engine, counterweights| {
        let request =
            BearingRequest { part: BearingPart::Inertia, counterweights, ..BearingRequest::default() };
        let loads = bearing_loads(engine, None, &request).unwrap();
        loads.mains.iter().map(|m| m.load.mean).collect::<Vec<_>>()
    };
    engine = engine
        .with(|engine| {
            engine.counterweights = engine
                .throws
                .iter()
                .enumerate()
                .map(|(k, throw)| Counterweight {
                    name: format!("weight {k}"),
                    crankshaft: 0,
                    z: throw.z,
                    unbalance: engine.rotating_unbalance(k),
                    angle: throw.angle + PI,
                    part: None,
                })
                .collect();
        })
        .unwrap();
    let (with, without) = (forces(&engine, true), forces(&engine, false));
    for (with, without) in with.iter().zip(&without) {
        assert!(with <= without, "{with} {without}");
    }
    assert!(with[2] < 0.7 * without[2], "{with:?} {without:?}");
    // With only what turns: nothing is left.
    engine = engine
        .with(|engine| {
            for cylinder in &mut engine.cylinders {
                cylinder.piston_mass = 0.0;
                cylinder.rod.small_end_mass = 0.0;
            }
        })
        .unwrap();
    assert!(forces(&engine, true).iter().all(|force| *force < 1e-9), "{:?}", forces(&engine, true));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// The orders of every main's inertia load have the mean square of its trace (Parseval), and its value at every angle.
    #[test]
    fn prop_orders_of_main_bearings_are_those_of_their_traces(engine in any_engine(ALL_SHAPES)) {
        let request = BearingRequest { part: BearingPart::Inertia, samples: 720, ..BearingRequest::default() };
        let loads = bearing_loads(&engine, None, &request).unwrap();
        let orders = main_orders(&engine, &LoadRequest::default()).unwrap();
        prop_assert_eq!(orders.len(), loads.mains.len());
        let scale = scale(&loads);
        for (main, by_order) in loads.mains.iter().zip(&orders) {
            prop_assert_eq!((by_order.crankshaft + 1, by_order.z), (main.crankshaft, main.z));
            let ratio = engine.crankshafts[by_order.crankshaft].ratio.value().abs();
            let share = |harmonic: u32| if harmonic == 0 { 1.0 } else { 0.5 };
            let by_parseval: f64 =
                by_order.orders.iter().map(|o| share(o.harmonic) * (o.x.norm_sqr() + o.y.norm_sqr())).sum();
            let squares = main.load.load.iter().map(|force| force.norm_sqr());
            let by_quadrature = squares.sum::<f64>() / main.load.load.len() as f64;
            prop_assert!((by_parseval - by_quadrature).abs() <= 1e-10 * scale * scale, "{by_parseval} {by_quadrature}");
            for (theta, force) in loads.theta.iter().zip(&main.load.load).step_by(37) {
                let sum: Complex64 = by_order
                    .orders
                    .iter()
                    .map(|o| {
                        let turn = Complex64::cis(f64::from(o.harmonic) * ratio * theta);
                        Complex64::new((o.x * turn).re, (o.y * turn).re)
                    })
                    .sum();
                prop_assert!((sum - force).norm() <= 1e-10 * scale, "{sum} {force}");
            }
        }
    }
}
