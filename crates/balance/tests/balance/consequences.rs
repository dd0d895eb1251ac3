//! What other weights do to an engine: closed forms, marks, what is dropped.

use lanchester_balance::{Affected, AffectedPart, Change, Consequences, balance_rates, consequences};
use lanchester_file::{read, templates};
use lanchester_mechanism::{BearingPart, BearingRequest, bearing_loads, main_inertia_loads};
use lanchester_model::Engine;
use lanchester_testkit::gallery::gallery;

/// Only its crank turns: one unbalance in the plane of every throw, nothing else has mass.
fn crank_alone(name: &str) -> (Engine, f64) {
    let mut engine = gallery(name);
    engine = engine
        .with(|engine| {
            for throw in &mut engine.throws {
                (throw.unbalance, throw.unbalance_offset) = (0.02, 0.0);
            }

            for cylinder in &mut engine.cylinders {
                cylinder.piston_mass = 0.0;
                (cylinder.rod.big_end_mass, cylinder.rod.small_end_mass, cylinder.rod.inertia) =
                    (0.0, 0.0, None);
            }
        })
        .unwrap();
    let force = 0.02 * engine.speed.highest.powi(2);
    (engine, force)
}

fn bare(engine: &Engine) -> Engine {
    engine.without_counterweights()
}

fn of(before: &Engine, after: &Engine) -> Consequences {
    consequences(before, after, |_, _| None).unwrap()
}

fn after(found: &Consequences, quantity: Affected) -> Vec<f64> {
    found.of(quantity).map(|row| row.after).collect()
}

/// The table of the book, "Inside the crankshaft": loads of the mains in F and the largest bending moment in F a.
#[test]
fn bare_cranks_load_their_mains_as_by_pencil() {
    let half = 0.5;
    let diagonal = half * 2f64.sqrt();
    let cases = [
        ("in-line-4", vec![half, 0.0, 1.0, 0.0, half], 1.0),
        ("in-line-6", vec![half, half, half, 1.0, half, half, half], 3f64.sqrt()),
        ("v8-crossplane", vec![half, diagonal, 0.0, diagonal, half], 10f64.sqrt() / 8.0),
    ];
    for (name, mains, bending) in cases {
        let (engine, force) = crank_alone(name);
        let spacing = engine.throws[1].z - engine.throws[0].z;
        let found = of(&engine, &bare(&engine));
        for quantity in [Affected::MainLoadRms, Affected::MainLoadPeak] {
            let loads = after(&found, quantity);
            assert_eq!(loads.len(), mains.len(), "{name}");
            for (load, expected) in loads.iter().zip(&mains) {
                // Rounding of a few products, and 0 for what is rounding.
                assert!((load - expected * force).abs() <= 1e-9 * force, "{name} {quantity:?}: {loads:?}");
            }
        }
        let [moment] = after(&found, Affected::BendingMoment)[..] else { panic!("{name}: one crankshaft") };
        assert!((moment - bending * force * spacing).abs() <= 1e-9 * force * spacing, "{name}: {moment}");
    }
}

#[test]
fn what_counterweights_are_for_is_seen_where_force_and_couple_see_nothing() {
    let engine = gallery("in-line-4");
    let found = of(&engine, &bare(&engine));
    let change = |quantity| found.of(quantity).map(|row| row.change).collect::<Vec<_>>();
    for blind in [Affected::Force, Affected::Couple, Affected::RollMoment] {
        assert_eq!(change(blind), [Change::Unchanged], "{blind:?}");
    }
    assert_eq!(change(Affected::BendingMoment), [Change::Worse]);
    assert_eq!(change(Affected::BalanceRate), [Change::Worse; 4]);
    assert_eq!(change(Affected::CounterweightUnbalance), [Change::Better]);
    let middle = found.of(Affected::MainLoadPeak).nth(2).unwrap();
    assert!(middle.change == Change::Worse && middle.after > 1.9 * middle.before, "{middle:?}");
    assert!(matches!(middle.part, AffectedPart::Main { crankshaft: 1, main: 3, .. }));
    let names: Vec<String> = (1..=8).map(|web| format!("web {web}")).collect();
    assert_eq!(found.dropped, names);
    assert_eq!((found.added.len(), found.counterweights), (0, [8, 0]));
}

#[test]
fn the_other_way_round_every_mark_turns() {
    let engine = gallery("in-line-6");
    let (there, back) = (of(&engine, &bare(&engine)), of(&bare(&engine), &engine));
    assert_eq!(there.rows.len(), back.rows.len());
    for (one, other) in there.rows.iter().zip(&back.rows) {
        assert_eq!((one.quantity, one.before, one.after), (other.quantity, other.after, other.before));
        let turned = match one.change {
            Change::Better => Change::Worse,
            Change::Unchanged => Change::Unchanged,
            Change::Worse => Change::Better,
        };
        assert_eq!(turned, other.change, "{one:?}");
    }
    assert_eq!(there.dropped, back.added);
}

#[test]
fn a_millionth_is_no_change_and_a_thousandth_is_one() {
    let engine = gallery("in-line-4");
    let with = |factor: f64| {
        let mut other = engine.clone();
        other = other
            .with(|other| {
                other.counterweights.iter_mut().for_each(|weight| weight.unbalance *= factor);
            })
            .unwrap();
        of(&engine, &other)
    };
    assert!(with(1.0 + 1e-8).rows.iter().all(|row| row.change == Change::Unchanged));
    let lighter = with(0.999);
    assert!(lighter.of(Affected::BalanceRate).all(|row| row.change == Change::Worse));
    assert!(lighter.of(Affected::CounterweightUnbalance).all(|row| row.change == Change::Better));
    assert!(lighter.dropped.is_empty());
}

#[test]
fn too_much_of_a_counterweight_is_marked_too() {
    let engine = gallery("in-line-4");
    let mut heavier = engine.clone();
    heavier = heavier
        .with(|heavier| {
            heavier.counterweights.iter_mut().for_each(|weight| weight.unbalance *= 2.0);
        })
        .unwrap();
    let found = of(&engine, &heavier);
    for row in found.of(Affected::BalanceRate) {
        // 80 % to 160 %: three fifths too much are farther from all than one fifth too little.
        assert!((row.after - 1.6).abs() < 1e-12 && row.change == Change::Worse, "{row:?}");
    }
}

#[test]
fn the_mass_is_a_row_where_that_of_every_weight_is_known() {
    let engine = gallery("in-line-4");
    let radius = 0.05;
    let found = consequences(&engine, &bare(&engine), |_, weight| Some(weight.unbalance / radius)).unwrap();
    let [row] = found.of(Affected::CounterweightMass).collect::<Vec<_>>()[..] else { panic!("one row") };
    let sum: f64 = engine.counterweights.iter().map(|weight| weight.unbalance).sum();
    assert!((row.before - sum / radius).abs() < 1e-12 && row.after == 0.0, "{row:?}");
    assert!(of(&engine, &engine).of(Affected::CounterweightMass).next().is_none());
}

/// Two kernels: the loads in two numbers, and the traces with their peaks.
#[test]
fn main_loads_are_those_of_the_bearings() {
    for template in templates() {
        let engine = read(template.text).engine().unwrap();
        let request = BearingRequest { part: BearingPart::Inertia, ..BearingRequest::default() };
        let traces = bearing_loads(&engine, None, &request).unwrap();
        let loads = main_inertia_loads(&engine, None).unwrap();
        assert_eq!(loads.len(), traces.mains.len(), "{}", template.name);
        for (load, trace) in loads.iter().zip(&traces.mains) {
            assert_eq!((load.crankshaft, load.main, load.z), (trace.crankshaft, trace.main, trace.z));
            assert_eq!(load.peak, trace.load.peak, "{}", template.name);
            let squares: f64 = trace.load.load.iter().map(|force| force.norm_sqr()).sum();
            let rms = (squares / trace.load.load.len() as f64).sqrt();
            assert!((load.rms - rms).abs() <= 1e-12 * load.peak.value, "{}: {load:?}", template.name);
        }
    }
}

#[test]
fn every_engine_of_the_gallery_has_consequences() {
    for template in templates() {
        let engine = read(template.text).engine().unwrap();
        let found = of(&engine, &bare(&engine));
        assert!(
            found.rows.iter().all(|row| row.before.is_finite() && row.after.is_finite()),
            "{}",
            template.name
        );
        assert!(found.bending.iter().all(|along| along.z.is_sorted()), "{}", template.name);
        let same = of(&engine, &engine);
        assert!(same.rows.iter().all(|row| row.change == Change::Unchanged), "{}", template.name);
        // No counterweights answer nothing.
        assert!(balance_rates(&bare(&engine)).iter().all(|bay| bay.rate.abs() < 1e-12), "{}", template.name);
    }
}
