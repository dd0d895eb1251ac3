//! Scatter: every sample is an engine, and what is told of them is what they have.
use lanchester_mechanism::{LoadRequest, total_loads};
use lanchester_model::Engine;
use lanchester_study::explore::Sense;
use lanchester_study::scatter::*;
use lanchester_task::{Distribution, Extent, Tolerance, Varied};
use lanchester_testkit::gallery::gallery as engine;
use proptest::prelude::*;

pub(crate) fn tolerance(quantity: Varied, half_width: f64, extent: Extent) -> Tolerance {
    Tolerance { quantity, half_width, distribution: Distribution::Normal { sigmas: 3.0 }, extent }
}

pub(crate) fn all_outputs() -> Vec<Output> {
    let mut outputs = vec![Output::PeakForce, Output::PeakCouple];
    for order in [1, 2] {
        outputs.extend([Output::Force { order }, Output::Couple { order }]);
        for sense in [Sense::Forward, Sense::Backward] {
            outputs.extend([Output::ForceSense { order, sense }, Output::CoupleSense { order, sense }]);
        }
    }
    outputs
}

pub(crate) fn request(engine: Engine, tolerances: Vec<Tolerance>, samples: u64) -> ScatterRequest {
    ScatterRequest {
        engine,
        speed: None,
        tolerances,
        outputs: all_outputs(),
        limits: Vec::new(),
        percentiles: vec![0.0, 0.05, 0.5, 0.95, 1.0],
        samples,
        seed: 3,
    }
}

/// Half widths of everything, larger than any workshop's.
pub(crate) fn everything(engine: &Engine) -> Vec<Tolerance> {
    let mut list = vec![
        tolerance(Varied::PistonMass, 0.02, Extent::PerPart),
        tolerance(Varied::BigEndMass, 0.02, Extent::PerPart),
        tolerance(Varied::SmallEndMass, 0.01, Extent::Common),
        tolerance(Varied::RodCentre, 0.002, Extent::PerPart),
        tolerance(Varied::RodLength, 0.001, Extent::PerPart),
        tolerance(Varied::CrankRadius, 0.0005, Extent::Common),
        tolerance(Varied::CrankRadius, 0.0002, Extent::PerPart),
        tolerance(Varied::ThrowAngle, 0.03, Extent::PerPart),
        tolerance(Varied::ThrowUnbalance, 0.002, Extent::PerPart),
        tolerance(Varied::Offset, 0.001, Extent::PerPart),
        tolerance(Varied::CylinderPlane, 0.001, Extent::PerPart),
        tolerance(Varied::CylinderAngle, 0.01, Extent::PerPart),
    ];
    if !engine.counterweights.is_empty() {
        list.push(tolerance(Varied::CounterweightUnbalance, 0.001, Extent::PerPart));
        list.push(tolerance(Varied::CounterweightAngle, 0.02, Extent::PerPart));
    }
    if !engine.shafts.is_empty() {
        list.push(tolerance(Varied::ShaftUnbalance, 0.001, Extent::PerPart));
        list.push(tolerance(Varied::ShaftPhase, 0.05, Extent::PerPart));
    }
    list
}

/// The engine with deviations, tolerance by tolerance and part by part.
pub(crate) fn deviated(engine: &Engine, tolerances: &[Tolerance], deviations: &[f64]) -> Engine {
    let mut moved = engine.clone().into_parts();
    let mut next = deviations.iter();
    for tolerance in tolerances {
        let weights: Vec<(usize, usize)> = engine
            .shafts
            .iter()
            .enumerate()
            .flat_map(|(s, shaft)| (0..shaft.weights.len()).map(move |w| (s, w)))
            .collect();
        let parts = match tolerance.quantity {
            Varied::CrankRadius | Varied::ThrowAngle | Varied::ThrowUnbalance => engine.throws.len(),
            Varied::CounterweightUnbalance | Varied::CounterweightAngle => engine.counterweights.len(),
            Varied::ShaftUnbalance => weights.len(),
            Varied::ShaftPhase => engine.shafts.len(),
            _ => engine.cylinders.len(),
        };
        let common = (tolerance.extent == Extent::Common).then(|| *next.next().expect("a deviation"));
        for part in 0..parts {
            let by = common.unwrap_or_else(|| *next.next().expect("a deviation"));
            match tolerance.quantity {
                Varied::PistonMass => moved.cylinders[part].piston_mass += by,
                Varied::BigEndMass => moved.cylinders[part].rod.big_end_mass += by,
                Varied::SmallEndMass => moved.cylinders[part].rod.small_end_mass += by,
                Varied::RodCentre => {
                    let rod = &engine.cylinders[part].rod;
                    let shift = by * rod.mass() / rod.length;
                    moved.cylinders[part].rod.small_end_mass += shift;
                    moved.cylinders[part].rod.big_end_mass -= shift;
                }
                Varied::RodLength => moved.cylinders[part].rod.length += by,
                Varied::CrankRadius => moved.throws[part].radius += by,
                Varied::ThrowAngle => moved.throws[part].angle += by,
                Varied::ThrowUnbalance => moved.throws[part].unbalance += by,
                Varied::Offset => moved.cylinders[part].offset += by,
                Varied::CylinderPlane => moved.cylinders[part].z += by,
                Varied::CylinderAngle => moved.cylinders[part].angle += by,
                Varied::CounterweightUnbalance => moved.counterweights[part].unbalance += by,
                Varied::CounterweightAngle => moved.counterweights[part].angle += by,
                Varied::ShaftUnbalance => {
                    let (shaft, weight) = weights[part];
                    moved.shafts[shaft].weights[weight].unbalance += by;
                }
                Varied::ShaftPhase => moved.shafts[part].weights.iter_mut().for_each(|w| w.phase += by),
            }
        }
    }
    assert!(next.next().is_none(), "every deviation is used");
    Engine::new(moved).unwrap()
}

/// An output of an engine, from the mechanism.
pub(crate) fn wanted(engine: &Engine, output: Output) -> f64 {
    let loads = total_loads(engine, &LoadRequest::default()).expect("loads");
    let order = |n: u32| loads.orders.iter().find(|o| o.order == f64::from(n)).expect("listed");
    match output {
        Output::Force { order: n } => order(n).force_peak(),
        Output::Couple { order: n } => order(n).couple_peak(),
        Output::ForceSense { order: n, sense: Sense::Forward } => order(n).force_forward.norm(),
        Output::ForceSense { order: n, sense: Sense::Backward } => order(n).force_backward.norm(),
        Output::CoupleSense { order: n, sense: Sense::Forward } => order(n).couple_forward.norm(),
        Output::CoupleSense { order: n, sense: Sense::Backward } => order(n).couple_backward.norm(),
        Output::PeakForce => loads.peaks.force.max.value,
        Output::PeakCouple => loads.peaks.couple.max.value,
    }
}

const ENGINES: [&str; 8] = [
    "v6-60",
    "in-line-4-lanchester",
    "in-line-3-shaft",
    "boxer-4",
    "single-two-shafts",
    "radial-5",
    "square-4",
    "opposed-piston-3",
];

/// The worst case's corner is an engine with its deviations: what it attains must be what the mechanism says, peaks over
/// the continuous angle included, and no random engine within the tolerances may lie beyond the bound.
#[test]
fn outputs_of_a_corner_are_those_of_the_engine() {
    for name in ENGINES {
        let engine = engine(name);
        let tolerances = everything(&engine);
        let request = request(engine.clone(), tolerances.clone(), 8);
        for case in worst_cases(&request).expect("worst cases") {
            let corner = deviated(&engine, &tolerances, &case.deviations);
            let got = wanted(&corner, case.output);
            let scale = wanted(&engine, Output::PeakForce).max(1e4);
            // Orders beyond the last that matters are 1e-13 of the first each; the rest is rounding.
            assert!(
                (got - case.attained).abs() < 1e-11 * scale,
                "{name} {:?}: {got} {}",
                case.output,
                case.attained
            );
            let nominal = wanted(&engine, case.output);
            assert!(
                (nominal - case.nominal).abs() < 1e-11 * scale,
                "{name} {:?}: {nominal} {}",
                case.output,
                case.nominal
            );
            assert!(case.nominal <= case.attained && case.attained <= case.bound, "{name} {case:?}");
        }
    }
}

#[test]
fn no_sample_lies_beyond_the_worst_case() {
    for name in ENGINES {
        let engine = engine(name);
        let mut tolerances = everything(&engine);
        for tolerance in &mut tolerances {
            tolerance.distribution = Distribution::Uniform;
        }
        let request = request(engine, tolerances, 20_000);
        let worst = worst_cases(&request).expect("worst cases");
        let found = scatter(&request).expect("a scatter");
        for (case, output) in worst.iter().zip(&found.outputs) {
            assert!(output.most <= case.bound, "{name} {:?}", case.output);
            assert!(
                output.most <= case.attained,
                "{name} {:?}: {} {}",
                case.output,
                output.most,
                case.attained
            );
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same_scatter() {
    let engine = engine("v6-60");
    for samples in [50_000, 150_003] {
        let mut request = request(engine.clone(), everything(&engine), samples);
        request.outputs = vec![Output::Force { order: 1 }, Output::Couple { order: 2 }];
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| scatter(&request)).expect("a scatter")
        };
        let one = with(1);
        assert_eq!(with(2), one);
        assert_eq!(with(5), one);
    }
}

/// Many samples: percentiles come from cells, which err by no more than they say.
#[test]
fn percentiles_of_many_samples_are_those_of_all() {
    let engine = engine("in-line-4");
    let mut few = request(engine.clone(), everything(&engine), 100_000);
    few.outputs = vec![Output::Force { order: 1 }, Output::Force { order: 2 }];
    let many = ScatterRequest { samples: 100_001, ..few.clone() };
    let (few, many) = (scatter(&few).expect("a scatter"), scatter(&many).expect("a scatter"));
    for (exact, cells) in few.outputs.iter().zip(&many.outputs) {
        assert_eq!(exact.percentile_error, 0.0);
        for (a, b) in exact.percentiles.iter().zip(&cells.percentiles) {
            // One more sample moves a percentile by far less than a cell is wide.
            assert!((a.value - b.value).abs() <= 1.1 * cells.percentile_error * a.value, "{a:?} {b:?}");
        }
        assert!((exact.mean - cells.mean).abs() < 1e-4 * exact.mean);
    }
}

/// Two piston masses on one throw star: mean square of the residual by hand.
#[test]
fn mean_square_is_the_sum_of_the_variances() {
    // A balanced in-line four: order 1 forward is 1/2 r w^2 SUM dm e^{ia}; its mean square is 1/4 r^2 w^4 n var(dm).
    let engine = engine("in-line-4");
    let (half, speed, radius) = (0.003, engine.speed.highest, engine.throws[0].radius);
    let mut request = request(engine, vec![tolerance(Varied::PistonMass, half, Extent::PerPart)], 200_000);
    request.outputs = vec![Output::ForceSense { order: 1, sense: Sense::Backward }];
    request.tolerances[0].distribution = Distribution::Uniform;
    let found = scatter(&request).expect("a scatter");
    let output = &found.outputs[0];
    let mean_square = output.mean * output.mean + output.deviation * output.deviation;
    let wanted = 0.25 * (radius * speed * speed).powi(2) * 4.0 * half * half / 3.0;
    // Five standard errors of a mean square of 200 000 samples.
    assert!(
        (mean_square / wanted - 1.0).abs() < 5.0 * (2.0f64 / 200_000.0).sqrt(),
        "{}",
        mean_square / wanted
    );
}

#[test]
fn shares_tell_which_tolerance_to_tighten() {
    // The second-order force of an in-line four is far from 0: it is linear in small deviations, and shares are those of
    // the variances: masses 4 times as loose have 16 times the share.
    let engine = engine("in-line-4");
    let tolerances = vec![
        tolerance(Varied::PistonMass, 0.004, Extent::PerPart),
        tolerance(Varied::SmallEndMass, 0.001, Extent::PerPart),
        tolerance(Varied::BigEndMass, 0.001, Extent::PerPart),
    ];
    let mut request = request(engine, tolerances, 70_000);
    request.outputs = vec![Output::Force { order: 2 }];
    let found = scatter(&request).expect("a scatter");
    let output = &found.outputs[0];
    let share = |k: usize| output.contributions[k].share;
    let error = |k: usize| 5.0 * output.contributions[k].error;
    // What varies within a cell is lost: less than half a percent.
    assert!((share(0) - 16.0 / 17.0).abs() < error(0) + 0.005, "{output:?}");
    assert!((share(1) - 1.0 / 17.0).abs() < error(1), "{output:?}");
    assert!(share(2).abs() < error(2), "{output:?}");
}

#[test]
fn capability_counts_what_is_beyond() {
    let engine = engine("in-line-4");
    let mut request = request(engine, vec![tolerance(Varied::PistonMass, 0.004, Extent::PerPart)], 20_000);
    request.outputs = vec![Output::Force { order: 2 }];
    let all = scatter(&request).expect("a scatter").outputs[0].clone();
    let limit = all.percentiles[3].value;
    request.limits = vec![Limit { output: Output::Force { order: 2 }, value: limit }];
    let output = scatter(&request).expect("a scatter").outputs[0].clone();
    let capability = output.capabilities[0];
    assert_eq!(capability.beyond, 1000, "5 % lie beyond the 95 % percentile");
    // 95 % is 1.645 standard deviations of a normal distribution: a third of it is Cpk. Cut off at 3 it is nearly that.
    assert!((capability.cpk - 1.645 / 3.0).abs() < 0.02, "{capability:?}");
}

#[test]
fn bad_requests_are_refused() {
    let good = request(engine("in-line-4"), everything(&engine("in-line-4")), 100);
    let with = |change: &dyn Fn(&mut ScatterRequest)| {
        let mut bad = good.clone();
        change(&mut bad);
        scatter(&bad).map(|_| ())
    };
    assert_eq!(with(&|_| ()), Ok(()));
    assert_eq!(with(&|r| r.tolerances.clear()), Err(ScatterError::NoTolerance));
    assert_eq!(with(&|r| r.outputs.clear()), Err(ScatterError::NoOutput));
    assert!(matches!(with(&|r| r.samples = 0), Err(ScatterError::Number { .. })));
    assert!(matches!(with(&|r| r.tolerances[0].half_width = -1.0), Err(ScatterError::Number { .. })));
    assert!(matches!(
        with(&|r| r.tolerances[0].half_width = 10.0),
        Err(ScatterError::Impossible { cylinder: 1, .. })
    ));
    assert!(matches!(with(&|r| r.tolerances[4].half_width = 0.2), Err(ScatterError::Impossible { .. })));
    assert!(matches!(
        with(&|r| r.tolerances[0].quantity = Varied::ShaftPhase),
        Err(ScatterError::NoSuchPart { place: 1, .. })
    ));
    let limit = Limit { output: Output::PeakForce, value: 1.0 };
    assert!(matches!(
        with(&|r| {
            r.outputs = vec![Output::Force { order: 1 }];
            r.limits = vec![limit];
        }),
        Err(ScatterError::LimitWithoutOutput { place: 1, .. })
    ));
}

/// Parts that differ by a few grams.
fn weighed(count: usize) -> impl Strategy<Value = (Vec<f64>, Vec<WeighedRod>)> {
    let rod = (0.38..0.42f64, 0.18..0.21f64)
        .prop_map(|(big_end_mass, small_end_mass)| WeighedRod { big_end_mass, small_end_mass });
    (prop::collection::vec(0.45..0.5f64, count), prop::collection::vec(rod, count))
}

pub(crate) fn with_parts(
    engine: &Engine,
    parts: &AssignmentRequest,
    pistons: &[usize],
    rods: &[usize],
) -> f64 {
    let mut built = engine.clone();
    built = built
        .with(|built| {
            for (index, cylinder) in built.cylinders.iter_mut().enumerate() {
                cylinder.piston_mass = parts.pistons[pistons[index] - 1];
                let rod = parts.rods[rods[index] - 1];
                (cylinder.rod.big_end_mass, cylinder.rod.small_end_mass) =
                    (rod.big_end_mass, rod.small_end_mass);
            }
        })
        .unwrap();
    let loads = total_loads(&built, &LoadRequest { samples: 1, ..LoadRequest::default() }).expect("loads");
    let first = loads.orders.iter().find(|o| o.order == 1.0).expect("listed");
    let force = first.force_forward.norm_sqr() + first.force_backward.norm_sqr();
    let couple = first.couple_forward.norm_sqr() + first.couple_backward.norm_sqr();
    (force + couple / parts.lever.powi(2)).sqrt()
}

pub(crate) fn orders(count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let shorter = orders(count - 1);
    shorter
        .iter()
        .flat_map(|order| {
            (0..count).map(move |at| {
                let mut longer = order.clone();
                longer.insert(at, count);
                longer
            })
        })
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    /// All 36 or 576 assignments built as engines: none leaves less.
    #[test]
    fn prop_no_assignment_leaves_less(four in any::<bool>(), parts in weighed(4), lever in 0.05..0.5f64) {
        let engine = engine(if four { "in-line-4" } else { "in-line-3" });
        let count = engine.cylinders.len();
        let request = AssignmentRequest {
            engine: engine.clone(),
            speed: None,
            pistons: parts.0[..count].to_vec(),
            rods: parts.1[..count].to_vec(),
            lever,
        };
        let found = assign(&request).expect("an assignment");
        let own = with_parts(&engine, &request, &found.pistons, &found.rods);
        prop_assert!(found.proved && (own - found.residual).abs() < 1e-9 * own.max(1.0), "{} {}", own, found.residual);
        for pistons in orders(count) {
            for rods in orders(count) {
                let other = with_parts(&engine, &request, &pistons, &rods);
                prop_assert!(other >= found.residual * (1.0 - 1e-9) - 1e-9, "{:?} {:?}: {}", pistons, rods, other);
            }
        }
    }
}

#[test]
fn many_cylinders_have_a_bound_and_no_proof() {
    let engine = engine("v12-60");
    let count = engine.cylinders.len();
    let pistons = (0..count).map(|k| 0.5 + 0.001 * ((k * 7) % 12) as f64).collect();
    let rod =
        |k: usize| WeighedRod { big_end_mass: 0.4 + 0.001 * ((k * 5) % 12) as f64, small_end_mass: 0.2 };
    let request =
        AssignmentRequest { engine, speed: None, pistons, rods: (0..count).map(rod).collect(), lever: 0.2 };
    let found = assign(&request).expect("an assignment");
    assert!(
        !found.proved && found.bound <= found.residual && found.residual < found.as_numbered,
        "{found:?}"
    );
}
