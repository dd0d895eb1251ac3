//! Exact derivatives against differences of the mechanism's loads; shares of the variance of a sum.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_mechanism::{LoadRequest, total_loads};
use lanchester_model::Engine;
use lanchester_study::sensitivity::*;
use lanchester_testkit::gallery::gallery as engine;

/// Peaks, and orders 1 and 2, of all loads.
fn outputs() -> Vec<Output> {
    let loads = [Target::Force, Target::Couple, Target::RollMoment];
    let sizes = [Size::Peak, Size::Order(1.0), Size::Order(2.0)];
    sizes.into_iter().flat_map(|size| loads.map(|load| Output::of_inertia(load, size))).collect()
}

/// Their values by the mechanism.
fn loads(point: &OperatingPoint) -> Vec<f64> {
    let request =
        LoadRequest { speed: Some(point.speed), samples: 1, max_order: 2, ..LoadRequest::default() };
    let loads = total_loads(&point.engine, &request).unwrap();
    let order = |n: f64| *loads.orders.iter().find(|own| own.order == n).unwrap();
    let peaks = [
        loads.peaks.force.max.value,
        loads.peaks.couple.max.value,
        loads.peaks.roll_moment.max.value.abs().max(loads.peaks.roll_moment.min.value.abs()),
    ];
    let orders = [1.0, 2.0].map(|n| {
        let own = order(n);
        [own.force_peak(), own.couple_peak(), own.roll_moment.norm()]
    });
    peaks.into_iter().chain(orders.into_iter().flatten()).collect()
}

fn off(point: &OperatingPoint, input: Input, by: f64) -> Vec<f64> {
    let mut own = point.clone();
    input.deviate(&mut own, by).unwrap();
    loads(&own)
}

/// An engine of the gallery at its highest speed.
fn at_highest(name: &str) -> OperatingPoint {
    let engine = engine(name);
    let speed = engine.speed.highest;
    OperatingPoint::of_inertia(engine, speed)
}

/// A step that changes an output by about a millionth.
fn step(input: Input) -> f64 {
    match input.quantity.measure() {
        Measure::Mass | Measure::BodyMass => 1e-6,
        Measure::Length | Measure::Place => 1e-7,
        Measure::Angle => 1e-6,
        Measure::Unbalance => 1e-8,
        Measure::Inertia | Measure::BodyInertia => 1e-9,
        Measure::Speed => 1e-3,
        Measure::Factor => 1e-6,
    }
}

#[test]
fn derivatives_are_the_differences_of_the_loads() {
    // Plain and offset rods, articulated rods, balance shafts, two crankshafts, split pins; all of them off their symmetry.
    let names = [
        "single",
        "in-line-3",
        "in-line-4-lanchester",
        "v2-45",
        "v6-60",
        "boxer-2",
        "radial-7",
        "square-4",
        "vr6-15",
    ];
    let mut compared = 0;
    for (number, name) in names.into_iter().enumerate() {
        let mut point = at_highest(name);
        // Every other engine has counterweights that follow their throws.
        point.weights = if number % 2 == 0 { Weights::Fixed } else { Weights::Follow };
        // Without symmetry no peak has a twin.
        for (place, input) in Input::single(&point).into_iter().enumerate() {
            let by = 1500.0 * f64::from(1 + (place as u32 * 7) % 5) * step(input);
            if input.quantity != Quantity::Speed {
                input.deviate(&mut point, by).unwrap();
            }
        }
        let scale = loads(&point);
        let (engine, speed) = (&point.engine, point.speed);
        let pistons = engine.cylinders.iter().map(|c| c.reciprocating_mass() * engine.throws[c.throw].radius);
        let inertia = pistons.sum::<f64>() * speed * speed;
        let inputs: Vec<Input> = Input::common(&point).into_iter().chain(Input::single(&point)).collect();
        let slopes = derivatives(&point, &outputs(), &inputs).unwrap();
        for (place, input) in inputs.iter().enumerate() {
            let h = step(*input);
            let [far_back, back, front, far_front] =
                [-2.0, -1.0, 1.0, 2.0].map(|steps| off(&point, *input, steps * h));
            for (output, value) in scale.iter().enumerate() {
                let [near, far] = [front[output] - back[output], far_front[output] - far_back[output]];
                let difference = (8.0 * near - far) / (12.0 * h);
                let Slope { up, down } = slopes[output][place];
                let largest = if output % 3 == 0 { inertia } else { 0.1 * inertia };
                // Sizes near zero bend within the step.
                if up != down || *value < 1e-3 * largest {
                    continue;
                }
                let rounding = 1e-9 * largest / h;
                assert!(
                    (up - difference).abs() <= 1e-5 * up.abs() + rounding,
                    "{name} {input:?} output {output}: {up} {difference} of {value}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 2000, "{compared}");
}

/// The share of a throw's rotating unbalance that its counterweights take stays; of those that do not follow it changes.
#[test]
fn counterweights_that_follow_keep_their_share() {
    use lanchester_task::Varied;
    let share = |engine: &Engine| {
        let rotating: f64 =
            engine.throws[0].unbalance + engine.throws[0].radius * engine.cylinders[0].rod.big_end_mass;
        engine.counterweights.iter().map(|weight| weight.unbalance).sum::<f64>() / rotating
    };
    let fixed = at_highest("single");
    for weights in [Weights::Fixed, Weights::Follow] {
        for varied in [Varied::BigEndMass, Varied::CrankRadius, Varied::ThrowUnbalance, Varied::RodCentre] {
            let mut point = OperatingPoint { weights, ..fixed.clone() };
            let input = Input { quantity: Quantity::Part(varied), part: None };
            input.deviate(&mut point, 1e-3).unwrap();
            let stays = (share(&point.engine) / share(&fixed.engine) - 1.0).abs() < 1e-14;
            assert_eq!(stays, weights == Weights::Follow, "{varied:?}");
        }
        let mut point = OperatingPoint { weights, ..fixed.clone() };
        Input { quantity: Quantity::Part(Varied::ThrowAngle), part: None }.deviate(&mut point, 0.1).unwrap();
        let turned = point.engine.counterweights[0].angle - fixed.engine.counterweights[0].angle;
        assert!((turned - if weights == Weights::Follow { 0.1 } else { 0.0 }).abs() < 1e-14, "{turned}");
    }
}

#[test]
fn a_size_that_vanishes_grows_either_way() {
    let point = at_highest("in-line-4");
    let heavier = Input { quantity: Quantity::Part(lanchester_task::Varied::PistonMass), part: Some(1) };
    let output = [Output::of_inertia(Target::Force, Size::Order(1.0))];
    let slope = derivatives(&point, &output, &[heavier]).unwrap()[0][0];
    let [back, front] = [-1e-4, 1e-4].map(|by| off(&point, heavier, by)[3]);
    assert!(
        (slope.up * 1e-4 - front).abs() < 1e-8 * front && (slope.down * -1e-4 - back).abs() < 1e-8 * back
    );
    assert_eq!(slope.up, -slope.down);
}

/// Of a product `m w^2` of few percent the shares are those of its linear part: 1 to 4 for equal ranges.
#[test]
fn shares_of_the_variance_are_those_of_the_linear_part() {
    let point = at_highest("single");
    let quantities = [Quantity::Speed, Quantity::Part(lanchester_task::Varied::PistonMass)];
    let request = SensitivityRequest {
        outputs: vec![Output::of_inertia(Target::Force, Size::Order(2.0))],
        amounts: quantities.map(|quantity| (quantity, Amount::Share(0.01))).to_vec(),
        only: true,
        sobol: Some([4000, 7]),
        ..SensitivityRequest::default()
    };
    let found = sensitivity(&point, &request).unwrap();
    let effects = &found.outputs[0].effects;
    let parts: Vec<f64> = found
        .inputs
        .iter()
        .zip(effects)
        .map(|(input, effect)| (effect.slope.up * input.half_width).powi(2))
        .collect();
    let shares = found.sobol.unwrap();
    assert_eq!((shares.impossible, found.inputs.len()), (0, 2));
    for (index, part) in shares.indices[0].iter().zip(&parts) {
        let share = part / parts.iter().sum::<f64>();
        assert!((index.first - share).abs() < 4.0 * index.first_error + 1e-3, "{index:?} {share}");
        assert!((index.total - share).abs() < 4.0 * index.total_error + 1e-3, "{index:?} {share}");
    }
    // The same whatever the number of threads.
    let again = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let alone = again.install(|| sensitivity(&point, &request)).unwrap();
    assert_eq!(alone.sobol.unwrap(), shares);
}

#[test]
fn main_bearings_stay_in_their_order() {
    let point = at_highest("in-line-3");
    let apart = point.engine.main_planes(0)[1] - point.engine.main_planes(0)[0];
    let end = |share: f64| {
        let request = SensitivityRequest {
            outputs: vec![Output::of_inertia(Target::MainBearing(Some(0)), Size::Peak)],
            amounts: vec![(Quantity::MainPlane, Amount::Absolute(share * apart))],
            only: true,
            each: true,
            sobol: None,
        };
        sensitivity(&point, &request).unwrap().outputs[0].effects[0].above
    };
    assert!(end(0.9).is_some());
    assert_eq!(end(1.1), None);
}

#[test]
fn impossible_requests_are_told() {
    let point = at_highest("single");
    let refused = |request: SensitivityRequest, said: &str| {
        let told = sensitivity(&point, &request).unwrap_err().to_string();
        assert!(told.contains(said), "{told}");
    };
    let only = |quantity, amount| SensitivityRequest {
        amounts: vec![(quantity, amount)],
        only: true,
        ..SensitivityRequest::default()
    };
    refused(only(Quantity::ShaftX, Amount::Absolute(1e-3)), "the engine has no balance-shaft x");
    refused(only(Quantity::PinOffset, Amount::Share(0.1)), "no size of which a share could be taken");
    refused(only(Quantity::Speed, Amount::Share(-0.1)), "above 0, got -0.1");
    refused(
        SensitivityRequest { sobol: Some([3, 1]), ..SensitivityRequest::default() },
        "from 16 to 10 000 000",
    );
    refused(
        SensitivityRequest { outputs: Vec::new(), ..SensitivityRequest::default() },
        "at least one output",
    );
}
