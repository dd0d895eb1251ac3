//! Derivatives of torque, energy, bearings and mounts against fourth-order differences of the closed forms that `torque`, `bearings` and
//! `mounts` use.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_file::{read, template};
use lanchester_mechanism::{
    BearingLoads, BearingPart, BearingRequest, CylinderBearings, CylinderGas, GasTrain, InternalRequest,
    KnownInertia, Lever, MountSystem, OuterTorque, PinLoad, SpeedResponse, Torque, TorqueRequest,
    TurningInertia, bearing_loads, inertia_excitations, internal_moments, merged_orders, speed_ripple,
    torque, vector_amplitude,
};
use lanchester_model::{Engine, EngineParts, MovingParts, Strokes};
use lanchester_results::{End, PeriodicCurve};
use lanchester_study::sensitivity::*;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Highest order of mount forces, as the derivatives have it.
const MOUNT_ORDERS: u32 = 8;

/// Engine files of the repository and of the gallery.
fn engine(name: &str) -> Engine {
    let text = match name {
        "in-line-4-mounts" => include_str!("../../../../examples/in-line-4-mounts.toml"),
        "single-gas" => include_str!("../../../../examples/single-gas.toml"),
        "in-line-4-production" => include_str!("../../../../examples/in-line-4-production.toml"),
        "twin-270-choices" => include_str!("../../../../examples/twin-270-choices.toml"),
        "v6-60" => include_str!("../../../../examples/v6-60.toml"),
        _ => template(name).unwrap().text,
    };
    let mut engine = read(text).engine().unwrap_or_else(|| panic!("{name}"));
    let count = engine.cylinders.len();
    let cycle = TAU * f64::from(engine.strokes.revolutions());
    engine = engine
        .with(|engine| {
            for (index, cylinder) in engine.cylinders.iter_mut().enumerate() {
                cylinder.bore.get_or_insert(0.08);
                cylinder.firing_angle.get_or_insert(cycle * index as f64 / count as f64);
            }
        })
        .unwrap();
    engine
}

/// A pressure that rises and falls smoothly about firing.
fn smooth(cycle: f64) -> PeriodicCurve {
    let knots: Vec<f64> = (0..240).map(|k| cycle * f64::from(k) / 240.0).collect();
    let pressure = |angle: f64| {
        let from_firing = (angle + cycle / 2.0).rem_euclid(cycle) - cycle / 2.0;
        2e5 + 50e5 * (-((from_firing - 0.25) / 0.6).powi(2)).exp() + 0.4e5 * (TAU * angle / cycle + 0.4).cos()
    };
    let values: Vec<f64> = knots.iter().map(|knot| pressure(*knot)).collect();
    PeriodicCurve::through(cycle, knots, &values).unwrap()
}

/// A pressure that jumps at firing and where the exhaust opens, and bends where the heat ends.
fn jumping(cycle: f64) -> PeriodicCurve {
    let end = |value: f64, slope: f64| End { value: value * 1e5, slope: slope * 1e5 };
    let ends = [
        [end(45.0, 3.0), end(40.0, -45.0)],
        [end(40.0, -30.0), end(5.0, -3.0)],
        [end(1.5, -0.2), end(1.2, 0.1)],
        [end(1.2, 0.1), end(20.0, 25.0)],
    ];
    PeriodicCurve::from_ends(cycle, vec![0.0, 0.4, 2.6, cycle - 3.0], &ends).unwrap()
}

fn gas(engine: &Engine, curve: fn(f64) -> PeriodicCurve) -> Vec<CylinderGas> {
    let cycle = TAU * f64::from(engine.strokes.revolutions());
    let crankcase = PeriodicCurve::constant(cycle, 1.05e5).unwrap();
    engine
        .cylinders
        .iter()
        .map(|_| CylinderGas { cylinder: curve(cycle), crankcase: crankcase.clone() })
        .collect()
}

/// A step that changes an output by about a ten-thousandth.
fn step(input: Input) -> f64 {
    match input.quantity.measure() {
        Measure::BodyMass => 1e-2,
        Measure::Mass => 5e-5,
        Measure::Length | Measure::Place => 2e-6,
        Measure::Angle => 5e-5,
        Measure::Unbalance => 5e-7,
        Measure::Inertia => 5e-8,
        Measure::BodyInertia => 1e-3,
        Measure::Speed => 1e-2,
        Measure::Factor => 5e-5,
    }
}

/// An engine without symmetry, so that no peak has a twin.
fn point(name: &str, curve: fn(f64) -> PeriodicCurve) -> OperatingPoint {
    let engine = engine(name);
    let gas = Some(gas(&engine, curve));
    let speed = 0.7 * engine.speed.highest;
    let turning = KnownInertia::default();
    let mut point = OperatingPoint {
        engine,
        speed,
        gas,
        turning,
        outer: OuterTorque::default(),
        weights: Weights::Fixed,
    };
    for (place, input) in Input::single(&point).into_iter().enumerate() {
        let by = 500.0 * (1.0 + 4.0 * (0.618_034 * place as f64).fract()) * step(input);
        let is_of_engine = input.quantity.is_of_engine() || input.quantity.measure() == Measure::Factor;
        // Main bearings stay the usual ones, which move with throws and radii.
        if !is_of_engine && input.quantity != Quantity::MainPlane {
            input.deviate(&mut point, by).unwrap();
        }
    }
    point
}

fn off(point: &OperatingPoint, input: Input, by: f64) -> OperatingPoint {
    let mut own = point.clone();
    input.deviate(&mut own, by).unwrap();
    own
}

fn coefficient(samples: &[Complex64], order: f64, period: f64) -> f64 {
    let step = period / samples.len() as f64;
    let turn = Complex64::cis(-order * step);
    let terms = samples.chunks(48).enumerate().map(|(place, chunk)| {
        // From 48 products of unit length no more than 48 roundings.
        let start = Complex64::cis(-order * step * (48 * place) as f64);
        chunk
            .iter()
            .scan(start, |phasor, value| {
                let term = value * *phasor;
                *phasor *= turn;
                Some(term)
            })
            .sum::<Complex64>()
    });
    terms.sum::<Complex64>().norm() / samples.len() as f64
}

/// Mean of the size of what runs straight between samples.
fn mean_size(samples: &[f64]) -> f64 {
    let pair = |k: usize| [samples[k], samples[(k + 1) % samples.len()]];
    let part = |[from, to]: [f64; 2]| match from * to < 0.0 {
        true => (from * from + to * to) / (2.0 * (from - to).abs()),
        false => (from + to).abs() / 2.0,
    };
    (0..samples.len()).map(|k| part(pair(k))).sum::<f64>() / samples.len() as f64
}

/// Results of the closed forms, each computed once.
struct Ordinary {
    fluctuation: f64,
    bending: f64,
    torque: Option<Torque>,
    /// Excess energy of inertia alone.
    idle_energy: f64,
    bearings: Vec<BearingLoads>,
    mounts: Vec<(BearingPart, SpeedResponse)>,
}

impl Ordinary {
    /// All that `outputs` need.
    fn of(point: &OperatingPoint, outputs: &[Output]) -> Ordinary {
        let (engine, gas) = (&point.engine, point.gas.as_deref().unwrap());
        let speed = Some(point.speed);
        let is_torque = |output: &&Output| {
            let target = output.target;
            matches!(target, Target::Torque | Target::ExcessEnergy | Target::SpeedFluctuation)
                || matches!(target, Target::BendingMoment(_))
        };
        let has_bending = outputs.iter().any(|output| matches!(output.target, Target::BendingMoment(_)));
        let bending = || {
            let request = InternalRequest { speed, samples: 1, ..InternalRequest::default() };
            let found = internal_moments(engine, &request).unwrap().crankshafts;
            found.iter().map(|own| own.free_beam.peak_moment.value).fold(0.0, f64::max)
        };
        let bending = if has_bending { bending() } else { 0.0 };
        let is_ripple = outputs.iter().any(|output| output.target == Target::SpeedFluctuation);
        let gas_of_ripple = outputs.iter().any(|output| output.needs().gas).then_some(gas);
        let ripple = || {
            let found =
                speed_ripple(engine, gas_of_ripple, point.speed, &Default::default(), point.turning).unwrap();
            found.periodic().unwrap().fluctuation
        };
        let fluctuation = if is_ripple { ripple() } else { 0.0 };
        let is_mount = |output: &&Output| matches!(output.target, Target::MountForce(_));
        let parts = |of: &dyn Fn(&&Output) -> bool| {
            PARTS.into_iter().filter(|part| outputs.iter().filter(of).any(|own| own.part == *part)).collect()
        };
        let of_bearings: Vec<BearingPart> = parts(&|output| !is_torque(output) && !is_mount(output));
        let of_mounts: Vec<BearingPart> = parts(&|output| is_mount(output));
        let has_torque =
            outputs.iter().any(|output| matches!(output.target, Target::Torque | Target::ExcessEnergy));
        let torque = has_torque.then(|| {
            torque(engine, gas, &TorqueRequest { speed, samples: 1, ..TorqueRequest::default() }).unwrap()
        });
        // One pressure on both sides of the pistons is none.
        let is_idle =
            |output: &Output| output.target == Target::ExcessEnergy && output.part == BearingPart::Inertia;
        let idle_energy = outputs.iter().any(is_idle).then(|| {
            let even = gas.iter().map(|own| own.crankcase.clone());
            let even: Vec<CylinderGas> =
                even.map(|curve| CylinderGas { cylinder: curve.clone(), crankcase: curve }).collect();
            let request = TorqueRequest { speed, samples: 1, ..TorqueRequest::default() };
            lanchester_mechanism::torque(engine, &even, &request).unwrap().energy.excess
        });
        let idle_energy = idle_energy.unwrap_or(0.0);
        let bearings = of_bearings.into_iter().map(|part| {
            let is_mean = outputs.iter().any(|output| output.size == Size::Mean);
            // Sizes that touch zero bend between samples, unless gas and inertia together keep them away from it.
            let samples = match part {
                _ if !is_mean => 720,
                BearingPart::All => 9216,
                BearingPart::Gas | BearingPart::Inertia => 92_160,
            };
            let request = BearingRequest { speed, part, counterweights: true, samples };
            bearing_loads(engine, Some(gas), &request).unwrap()
        });
        let mounts = of_mounts.into_iter().map(|part| {
            let mut excitation = inertia_excitations(engine, &[point.speed], MOUNT_ORDERS).unwrap().remove(0);
            let gas = GasTrain::new(engine, gas, Lever::Exact).unwrap().orders(MOUNT_ORDERS);
            excitation.orders = match part {
                BearingPart::All => merged_orders(&excitation.orders, &gas),
                BearingPart::Gas => gas,
                BearingPart::Inertia => excitation.orders,
            };
            (part, MountSystem::new(engine).unwrap().response(&[excitation]).unwrap().speeds.remove(0))
        });
        Ordinary {
            fluctuation,
            bending,
            torque,
            idle_energy,
            bearings: bearings.collect(),
            mounts: mounts.collect(),
        }
    }

    fn value(&self, output: Output) -> f64 {
        match output.target {
            Target::Torque | Target::ExcessEnergy => self.of_torque(output),
            Target::SpeedFluctuation => self.fluctuation,
            Target::BendingMoment(_) => self.bending,
            Target::MountForce(mount) => {
                let own = &self.mounts.iter().find(|(part, _)| *part == output.part).unwrap().1;
                let forces = |order: f64| &own.orders.iter().find(|own| own.order == order).unwrap().forces;
                let one = |mount: usize| match output.size {
                    Size::Order(order) => vector_amplitude(&forces(order)[mount]),
                    _ => own.peaks[mount].value,
                };
                mount.map_or_else(|| (0..own.peaks.len()).map(one).fold(0.0, f64::max), one)
            }
            _ => self.of_bearings(output),
        }
    }

    fn of_torque(&self, output: Output) -> f64 {
        let found = self.torque.as_ref().unwrap();
        let (extremes, energy) = match output.part {
            BearingPart::All => (found.total_extremes, found.energy),
            BearingPart::Gas => (found.gas_extremes, found.gas_energy),
            BearingPart::Inertia => (found.inertia_extremes, found.energy),
        };
        let harmonic = |order: f64| {
            let own = found.harmonics.iter().find(|own| own.order == order).unwrap();
            match output.part {
                BearingPart::All => own.total(),
                BearingPart::Gas => own.gas,
                BearingPart::Inertia => own.inertia,
            }
        };
        match output.size {
            _ if output.target == Target::ExcessEnergy && output.part == BearingPart::Inertia => {
                self.idle_energy
            }
            _ if output.target == Target::ExcessEnergy => energy.excess,
            Size::Peak => extremes.max_abs(),
            Size::Mean => harmonic(0.0).re,
            Size::Order(order) => harmonic(order).norm(),
        }
    }

    fn of_bearings(&self, output: Output) -> f64 {
        let loads = self.bearings.iter().find(|loads| loads.part == output.part).unwrap();
        let pin = |pin: &PinLoad| match output.size {
            Size::Peak => pin.peak.value,
            Size::Mean => pin.mean,
            Size::Order(n) => [n, -n].map(|n| coefficient(&pin.load, n, loads.period)).iter().sum(),
        };
        let thrust = |own: &CylinderBearings| {
            let thrust: Vec<Complex64> = own.side_thrust.iter().map(|t| (*t).into()).collect();
            match output.size {
                Size::Peak => own.largest_thrust.value.abs(),
                Size::Mean => mean_size(&own.side_thrust),
                Size::Order(n) => 2.0 * coefficient(&thrust, n, loads.period),
            }
        };
        let mains: Vec<f64> = loads.mains.iter().map(|main| pin(&main.load)).collect();
        let of_rods = |of: &dyn Fn(&CylinderBearings) -> f64| loads.cylinders.iter().map(of).collect();
        let (all, one): (Vec<f64>, Option<usize>) = match output.target {
            Target::MainBearing(one) => (mains, one),
            Target::Crankpin(one) => (of_rods(&|own| pin(&own.lower_pin)), one),
            Target::PistonPin(one) => (of_rods(&|own| pin(&own.piston_pin)), one),
            Target::SideThrust(one) => (of_rods(&thrust), one),
            other => panic!("{other:?}"),
        };
        one.map_or_else(|| all.iter().copied().fold(0.0, f64::max), |one| all[one])
    }
}

/// Derivatives of `outputs` by all inputs against differences, to a share of the derivative.
fn compare(name: &str, point: &OperatingPoint, outputs: &[Output], tolerance: f64) {
    compare_resolved(name, point, outputs, [tolerance, 1e-11]);
}

/// The same for closed forms that are known to a share of themselves.
fn compare_resolved(
    name: &str,
    point: &OperatingPoint,
    outputs: &[Output],
    [tolerance, resolution]: [f64; 2],
) {
    let mut compared = vec![0; outputs.len()];
    // All quantities that count, of all parts together, and of the first or the third.
    let has_mounts = outputs.iter().any(|output| matches!(output.target, Target::MountForce(_)));
    let is_of_block = |input: &Input| {
        let name = input.quantity.name();
        name.contains("mount") || name.starts_with("block")
    };
    let common = Input::common(point).into_iter().enumerate().flat_map(|(place, all)| {
        let parts = all.quantity.parts(point);
        let one = parts[if place % 2 == 0 { 0 } else { 2.min(parts.len() - 1) }];
        let single = (!all.quantity.is_of_engine()).then_some(Input { part: Some(one), ..all });
        std::iter::once(all).chain(single)
    });
    let inputs: Vec<Input> = common.filter(|input| has_mounts || !is_of_block(input)).collect();
    let slopes = derivatives(point, outputs, &inputs).unwrap();
    let nominal = Ordinary::of(point, outputs);
    for (place, input) in inputs.iter().enumerate() {
        let h = step(*input);
        let off = [-2.0, -1.0, 1.0, 2.0].map(|steps| Ordinary::of(&off(point, *input, steps * h), outputs));
        for ((output, slopes), compared) in outputs.iter().zip(&slopes).zip(&mut compared) {
            let value = nominal.value(*output);
            let [far_back, back, front, far_front] = off.each_ref().map(|own| own.value(*output));
            let difference = (8.0 * (front - back) - (far_front - far_back)) / (12.0 * h);
            let Slope { up, down } = slopes[place];
            let what = format!("{name} {} {input:?} of {value}", output.name(&point.engine));
            assert_eq!(up, down, "{what}");
            // Sizes near zero bend within the step.
            if up.abs() * h > 1e-3 * value.abs() {
                continue;
            }
            *compared += 1;
            // Rounding of the closed forms.
            let rounding = resolution * value.abs() / h;
            let error = (up - difference).abs();
            assert!(error <= tolerance * up.abs() + rounding, "{what}: {up} {difference}, off by {error}");
        }
    }
    for (output, compared) in outputs.iter().zip(compared) {
        assert!(2 * compared > inputs.len(), "{name} {}: {compared}", output.name(&point.engine));
    }
}

const PARTS: [BearingPart; 3] = [BearingPart::All, BearingPart::Gas, BearingPart::Inertia];

fn of_all_parts(targets: &[Target], sizes: &[Size]) -> Vec<Output> {
    of_parts(&PARTS, targets, sizes)
}

fn of_parts(parts: &[BearingPart], targets: &[Target], sizes: &[Size]) -> Vec<Output> {
    let of = |target: Target, size: Size| parts.iter().map(move |part| Output { target, part: *part, size });
    targets.iter().flat_map(|target| sizes.iter().flat_map(move |size| of(*target, *size))).collect()
}

/// Gas and inertia apart where that costs little: of engines of many cylinders their sum alone.
fn parts_of(name: &str) -> &'static [BearingPart] {
    if ["single-gas", "twin-270-choices", "opposed-piston-3"].contains(&name) { &PARTS } else { &PARTS[..1] }
}

type Gas = fn(f64) -> PeriodicCurve;

fn whole(target: Target, size: Size, part: BearingPart) -> Output {
    Output { target, part, size }
}

#[test]
fn torque_and_energy() {
    // Pistons that share a chamber: its dead centre moves with both linkages, both bores and the phase of the crankshafts.
    let cases: [(&str, Gas); 6] = [
        ("opposed-piston-3", smooth),
        ("single-gas", jumping),
        ("in-line-4-mounts", jumping),
        ("twin-270-choices", smooth),
        ("v6-60", jumping),
        ("radial-3", smooth),
    ];
    for (name, curve) in cases {
        let point = point(name, curve);
        let sizes = [Size::Peak, Size::Order(1.0), Size::Order(2.0)];
        let mut outputs = of_parts(parts_of(name), &[Target::Torque], &sizes);
        outputs.push(whole(Target::Torque, Size::Mean, BearingPart::All));
        if point.engine.strokes == Strokes::Four {
            outputs.push(whole(Target::Torque, Size::Order(0.5), BearingPart::Gas));
        }
        outputs.extend(parts_of(name).iter().map(|part| whole(Target::ExcessEnergy, Size::Peak, *part)));
        compare(name, &point, &outputs, 1e-6);
    }
}

#[test]
fn fluctuations_of_the_speed() {
    for (name, curve) in [("single-gas", smooth as Gas), ("in-line-4-mounts", smooth), ("radial-7", smooth)] {
        let mut point = point(name, curve);
        point.turning = KnownInertia::of(TurningInertia { flywheel: 0.11, crankshaft: 0.03 });
        // Without gas the inertia of the pistons alone makes the speed swing.
        for part in [BearingPart::All, BearingPart::Inertia] {
            let output = whole(Target::SpeedFluctuation, Size::Peak, part);
            // Extremes of the closed form are those of cubics between samples of half a degree.
            compare_resolved(name, &point, &[output], [1e-6, 1e-10]);
        }
    }
}

#[test]
fn bending_moments_of_crankshafts() {
    for name in ["in-line-4-production", "v6-60", "square-4", "radial-7"] {
        let output = whole(Target::BendingMoment(None), Size::Peak, BearingPart::Inertia);
        compare(name, &point(name, smooth), &[output], 1e-6);
    }
}

/// Pins, walls and main bearings: their numbers and the largest of all.
fn bearings() -> [Target; 8] {
    [
        Target::MainBearing(Some(0)),
        Target::MainBearing(Some(1)),
        Target::MainBearing(None),
        Target::Crankpin(Some(0)),
        Target::Crankpin(None),
        Target::PistonPin(Some(0)),
        Target::SideThrust(Some(0)),
        Target::SideThrust(None),
    ]
}

#[test]
fn peaks_of_bearings() {
    let cases: [(&str, Gas); 5] = [
        ("single-gas", jumping),
        ("in-line-4-production", jumping),
        ("v6-60", smooth),
        ("radial-7", jumping),
        ("square-4", smooth),
    ];
    for (name, curve) in cases {
        compare(name, &point(name, curve), &of_all_parts(&bearings(), &[Size::Peak]), 1e-6);
    }
}

/// Inertia has no half orders.
fn without_nothing(outputs: Vec<Output>) -> Vec<Output> {
    let is_something =
        |output: &Output| output.part != BearingPart::Inertia || output.size != Size::Order(0.5);
    outputs.into_iter().filter(is_something).collect()
}

#[test]
fn orders_of_bearings() {
    for name in ["single-gas", "v6-60", "radial-3"] {
        let outputs = of_parts(parts_of(name), &bearings(), &[Size::Order(0.5), Size::Order(2.0)]);
        // Orders of samples of a pressure in cubic pieces.
        compare_resolved(name, &point(name, smooth), &without_nothing(outputs), [1e-5, 1e-9]);
    }
}

#[test]
fn means_of_bearings() {
    let outputs = of_all_parts(&bearings(), &[Size::Mean]);
    compare_resolved("single-gas", &point("single-gas", smooth), &outputs, [1e-4, 1e-9]);
    let outputs = bearings().map(|target| whole(target, Size::Mean, BearingPart::All));
    compare_resolved("twin-270-choices", &point("twin-270-choices", smooth), &outputs, [1e-4, 1e-9]);
}

#[test]
fn forces_on_mounts() {
    for moving_parts in [MovingParts::Included, MovingParts::Added] {
        let mut point = point("in-line-4-mounts", jumping);
        point.engine = point
            .engine
            .with(|parts| {
                parts.block.as_mut().unwrap().moving_parts = moving_parts;
            })
            .unwrap();
        let targets = [Target::MountForce(Some(0)), Target::MountForce(Some(2)), Target::MountForce(None)];
        let sizes = [Size::Peak, Size::Order(0.5), Size::Order(2.0)];
        let outputs = of_all_parts(&targets, &sizes);
        compare("in-line-4-mounts", &point, &without_nothing(outputs), 1e-6);
    }
}

/// Differences to either side, of second order: downwards, upwards.
fn either_side(point: &OperatingPoint, input: Input, output: Output, h: f64) -> [f64; 2] {
    let value = |by: f64| Ordinary::of(&off(point, input, by), &[output]).value(output);
    let here = value(0.0);
    let side = |h: f64| (4.0 * value(h) - value(2.0 * h) - 3.0 * here) / (2.0 * h);
    [side(-h), side(h)]
}

/// An engine of four equal cylinders.
fn even_four() -> OperatingPoint {
    let engine = engine("in-line-4-mounts");
    let gas = Some(gas(&engine, jumping));
    let speed = 0.7 * engine.speed.highest;
    OperatingPoint {
        engine,
        speed,
        gas,
        turning: KnownInertia::default(),
        outer: OuterTorque::default(),
        weights: Weights::Fixed,
    }
}

#[test]
fn where_sides_differ_both_are_told() {
    use lanchester_task::Varied;
    let even = even_four();
    let part = |varied, index| Input { quantity: Quantity::Part(varied), part: Some(index) };
    // A counterweight in the plane of an inner main bearing leaves for one neighbour or for the other.
    let mut in_plane = even.clone();
    in_plane.engine = in_plane
        .engine
        .with(|parts| {
            parts.counterweights[2].z = parts.main_planes(0)[1];
        })
        .unwrap();
    let mut unlike = even.clone();
    let one = |parts: &mut EngineParts| {
        parts.counterweights.truncate(1);
        let weight = &mut parts.counterweights[0];
        (weight.z, weight.unbalance) = (even.engine.cylinders[1].z, 2e-3);
        weight.angle = even.engine.throws[1].angle;
    };
    unlike.engine = unlike.engine.with(one).unwrap();
    let bent = Input { quantity: Quantity::CounterweightPlane, part: Some(0) };
    let all = |target, size| whole(target, size, BearingPart::All);
    let plane = Input { quantity: Quantity::CounterweightPlane, part: Some(2) };
    let cases = [
        // Four equal peaks, of which one moves.
        (&even, part(Varied::PistonMass, 0), all(Target::Crankpin(None), Size::Peak)),
        (&even, part(Varied::RodLength, 1), all(Target::SideThrust(None), Size::Peak)),
        (&even, part(Varied::PistonMass, 2), all(Target::ExcessEnergy, Size::Peak)),
        (
            &even,
            Input { quantity: Quantity::GasPressure, part: Some(3) },
            all(Target::ExcessEnergy, Size::Peak),
        ),
        // A vanishing order grows either way.
        (&even, part(Varied::CrankRadius, 3), all(Target::Torque, Size::Order(1.0))),
        (&in_plane, plane, all(Target::MainBearing(Some(0)), Size::Peak)),
        // A weight in the plane of a rod where the moment is largest.
        (&unlike, bent, whole(Target::BendingMoment(None), Size::Peak, BearingPart::Inertia)),
        (&in_plane, plane, all(Target::MainBearing(Some(2)), Size::Mean)),
    ];
    for (point, input, output) in cases {
        let Slope { up, down } = derivatives(point, &[output], &[input]).unwrap()[0][0];
        let [below, above] = either_side(point, input, output, step(input));
        let what = format!("{} {input:?}: {down} {up} {below} {above}", output.name(&point.engine));
        let scale = up.abs().max(down.abs());
        assert!((up - down).abs() > 1e-3 * scale, "{what}");
        assert!((up - above).abs() < 1e-3 * scale && (down - below).abs() < 1e-3 * scale, "{what}");
    }
}

/// Where cylinder 1 burns before the exhaust of its neighbour opens, both press on the bearing between them, for however short a time.
#[test]
fn a_peak_between_jumps_that_part_leaps() {
    let even = even_four();
    let output = whole(Target::MainBearing(Some(1)), Size::Peak, BearingPart::Gas);
    let point = OperatingPoint {
        gas: even.gas.map(|gas| {
            // The third piece begins half a turn after firing: at the jump of the neighbour.
            let cycle = gas[0].cylinder.period();
            let end = |value: f64| End { value: value * 1e5, slope: 0.0 };
            let ends = [[end(40.0), end(30.0)], [end(1.0), end(1.0)]];
            let cylinder = PeriodicCurve::from_ends(cycle, vec![0.0, TAU / 2.0], &ends).unwrap();
            gas.into_iter().map(|gas| CylinderGas { cylinder: cylinder.clone(), ..gas }).collect()
        }),
        ..even
    };
    let delay = |part| Input { quantity: Quantity::PressureDelay, part };
    // All together part no jumps.
    let inputs = [delay(Some(0)), delay(Some(1)), delay(Some(2)), delay(None)];
    let slopes = derivatives(&point, &[output], &inputs).unwrap().swap_remove(0);
    let here = Ordinary::of(&point, &[output]).value(output);
    assert_eq!(slopes.iter().filter(|slope| slope.up.is_infinite() != slope.down.is_infinite()).count(), 2);
    for (input, slope) in inputs.into_iter().zip(slopes) {
        let [below, above] =
            [-1e-6, 1e-6].map(|by| Ordinary::of(&off(&point, input, by), &[output]).value(output));
        let leaps = [below, above].map(|value| value > 1.05 * here);
        let what = format!("{input:?}: {below} {here} {above} {slope:?}");
        assert_eq!([slope.down, slope.up].map(f64::is_infinite), leaps, "{what}");
    }
}

#[test]
fn names_and_what_is_not_there() {
    let point = even_four();
    let engine = &point.engine;
    let named = |text: &str| Output::named(text, engine);
    let whole = |target, size, part| Ok(Output { target, part, size });
    let (all, gas, inertia) = (BearingPart::All, BearingPart::Gas, BearingPart::Inertia);
    assert_eq!(named("gas torque order 1/2"), whole(Target::Torque, Size::Order(0.5), gas));
    assert_eq!(named(" main  bearing 2 mean"), whole(Target::MainBearing(Some(1)), Size::Mean, all));
    assert_eq!(named("inertia side thrust"), whole(Target::SideThrust(None), Size::Peak, inertia));
    let rod = whole(Target::MountForce(Some(2)), Size::Order(2.0), all);
    assert_eq!(named("mount force torque rod order 2"), rod);
    assert_eq!(named("roll moment order 2"), whole(Target::RollMoment, Size::Order(2.0), inertia));
    let told = |text: &str, said: &str| {
        let error = named(text).unwrap_err().to_string();
        assert!(error.contains(said) && error.contains("hint: "), "{text}: {error}");
    };
    told("torsion", "there is no output \"torsion\"");
    told("main bearing two", "whole number from 1 on, got \"two\"");
    told("crankpin 0", "whole number from 1 on, got \"0\"");
    told("mount force back", "there is no mount \"back\"");
    told("torque order 0", "above 0");
    told("gas couple", "gas gives the block no couple");
    told("mount force mean", "no such size");
    told("excess energy order 2", "no such size");
    let refused = |point: &OperatingPoint, name: &str, said: &str| {
        let request = SensitivityRequest { outputs: vec![named(name).unwrap()], ..Default::default() };
        let error = sensitivity(point, &request).unwrap_err().to_string();
        assert!(error.contains(said) && error.contains("hint: "), "{name}: {error}");
    };
    refused(&point, "main bearing 9", "no main bearing 9, the last one is main bearing 5");
    refused(&point, "piston pin 5", "no piston pin 5");
    let bare = OperatingPoint { gas: None, ..point.clone() };
    refused(&bare, "torque", "needs the gas");
    let mut free = point.clone();
    free.engine = free
        .engine
        .with(|parts| {
            parts.mounts.clear();
        })
        .unwrap();
    refused(&free, "mount force engine side", "no mount force 1");
    free.engine = free
        .engine
        .with(|parts| {
            parts.mounts.clone_from(&point.engine.mounts);
        })
        .unwrap();
    free.engine = free
        .engine
        .with(|parts| {
            parts.block = None;
        })
        .unwrap();
    refused(&free, "mount force", "add a [block] section");
    let mut boreless = point.clone();
    boreless.engine = boreless
        .engine
        .with(|parts| {
            parts.cylinders[1].bore = None;
        })
        .unwrap();
    refused(&boreless, "torque", "bore of cylinder 2");
}
