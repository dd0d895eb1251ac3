//! Torsional vibration of engines from their files.

use lanchester::file::EngineFile;
use lanchester::mechanism::{BearingPart, BearingRequest, throw_forces};
use lanchester::report::{MeshedThrow, meshed_throws_table, torsion_text};
use lanchester::torsion::{
    CrankChain, StationKind, orders_of, throw_stiffness, torque_orders, train_inertia,
};
use lanchester::{EngineTorsionError, TorsionRequest, engine_chain, torsion};
use std::f64::consts::TAU;

const SIX: &str = include_str!("../../../../examples/in-line-6-torsion.toml");

fn file(text: &str) -> EngineFile {
    let reading = lanchester::file::read(text);
    let said: Vec<&str> = reading.diagnostics.iter().map(|one| one.message.as_str()).collect();
    reading.file.unwrap_or_else(|| panic!("it has no mistakes: {said:?}"))
}

#[test]
fn the_example_has_a_full_chain_and_its_energy_balances() {
    let file = file(SIX);
    let speeds: Vec<f64> = (0..41).map(|k| 62.8 + 5.2 * f64::from(k)).collect();
    let found =
        torsion(&file, &[], &TorsionRequest { speeds, ..TorsionRequest::default() }).expect("a result");
    let chain = &found.crank.chain;
    // Ring, hub, six throws, flywheel, two of the driveline.
    assert_eq!(chain.stations().len(), 11);
    assert!(found.sweep.balance < 1e-9, "{}", found.sweep.balance);
    assert_eq!(found.sweep.orders.len(), 24);
    // All that turns is in it: the one list, rods and pistons, driveline, ring and hub.
    let bodies = lanchester::rotating_bodies(&file.engine);
    let listed: f64 = bodies.iter().filter_map(|body| body.referred()).map(|inertia| inertia.value).sum();
    let trains: f64 = found.crank.parts.iter().map(|parts| parts.train).sum();
    let sum = listed + trains + 0.06 + 8.0 + 0.006 + 0.11 + 0.05;
    assert!((chain.total_inertia() - sum).abs() < 1e-9 * sum, "{} instead of {sum}", chain.total_inertia());
    // Mean torque grows from throw to throw; none passes the damper.
    let last =
        found.sweep.shafts.iter().find(|own| chain.shafts()[own.shaft].name.contains("throw 6 to flywheel"));
    assert!(last.expect("a shaft to the flywheel").mean[0] > 100.0);
    assert!(found.sweep.shafts[0].mean[0].abs() < 1e-6);
    // An in-line six of this firing: order 3 sums all vectors, order 1 none, in a rigid crankshaft.
    let star = |order: f64| found.stars.iter().find(|star| star.order == order).expect("a star");
    assert!(
        (star(3.0).rigid_sum - 6.0).abs() < 1e-9 && star(1.0).rigid_sum < 1e-9 && star(2.5).rigid_sum < 1e-9
    );
    assert!(
        star(4.5).sums[2] > 1.5,
        "half orders excite the crankshaft's own mode, the third with a driveline"
    );
}

/// Two independent ways to the torque of rods and pistons: the varying inertia of this rung, the rod forces of the closed form.
#[test]
fn xcheck_inertia_torque_of_the_closed_form() {
    for name in ["in-line-4", "v6-60", "radial-9", "boxer-4"] {
        let Some(template) = lanchester::file::template(name) else { continue };
        let engine = file(template.text).engine;
        let speed = engine.speed.highest;
        let many = 720;
        let theta: Vec<f64> = (0..many).map(|k| TAU * f64::from(k) / f64::from(many)).collect();
        let request =
            BearingRequest { speed: Some(speed), part: BearingPart::Inertia, ..BearingRequest::default() };
        let forces = throw_forces(&engine, None, &request, 0, &theta).expect("forces");
        for throw in 0..engine.throws.len() {
            let samples: Vec<f64> = forces
                .iter()
                .map(|at| at.iter().find(|force| force.throw == throw).map_or(0.0, |force| force.tangential))
                .map(|force| force * engine.throws[throw].radius)
                .collect();
            let (mean, closed) = orders_of(&samples, 12);
            let own = torque_orders(&train_inertia(&engine, throw), 12);
            let size = closed.iter().map(|order| order.norm()).fold(0.0, f64::max);
            assert!(mean.abs() < 1e-9 * size, "{name}: inertia does no work over a cycle");
            for (k, (a, b)) in closed.iter().zip(&own).enumerate() {
                let b = b * (speed * speed);
                assert!((a - b).norm() < 1e-9 * size, "{name}, throw {throw}, order {}: {a} and {b}", k + 1);
            }
        }
    }
}

/// Stiffness of a throw in closed form, and pieces that add up to throws.
#[test]
fn ker_wilson_of_a_uniform_crankshaft() {
    let file = file(SIX);
    let (dj, dp, r) = (0.083_f64, 0.069_f64, 0.062);
    let (lj, lp, lw) = (0.128 - 0.066 - 0.024, 0.066 - 0.024, 0.024);
    let slope: f64 = (0.056 - 0.048) / r;
    let width = (0.056 + 0.048) / (1.0 - slope * slope).sqrt();
    let length = (lj + 0.4 * dj) / dj.powi(4)
        + (lp + 0.4 * dp) / dp.powi(4)
        + (r - 0.2 * (dj + dp)) / (lw * width.powi(3));
    let shear = 210e9 / 2.6;
    let exact = std::f64::consts::PI * shear / (32.0 * length);
    let found = throw_stiffness(&file.engine, 2, shear).expect("sizes");
    assert!((found / exact - 1.0).abs() < 1e-12, "{found} instead of {exact}");
    let crank = engine_chain(&file, &[]).expect("a chain");
    let inner =
        crank.chain.shafts().iter().find(|shaft| shaft.name == "throw 3 to throw 4").expect("a shaft");
    assert!((inner.stiffness / exact - 1.0).abs() < 1e-12, "from pin to pin as from journal to journal");
    // Another method that says the same changes nothing; one that says twice as stiff doubles what lies between.
    let all = |factor: f64| {
        (0..6)
            .map(|throw| (throw, factor * throw_stiffness(&file.engine, throw, shear).unwrap_or(0.0)))
            .collect::<Vec<_>>()
    };
    let twice = engine_chain(&file, &all(2.0)).expect("a chain");
    let stiff = |crank: &CrankChain| {
        crank.chain.shafts().iter().find(|s| s.name == "throw 3 to throw 4").map(|s| s.stiffness)
    };
    assert!((stiff(&twice).expect("a shaft") / exact - 2.0).abs() < 1e-9);
    // Both by finite elements stand in a table, and the one that is taken in the chain.
    let meshed = |is_held| {
        let throws = all(1.0).into_iter();
        let throws =
            throws.map(|(throw, k)| MeshedThrow { throw: throw + 1, free: 2.0 * k, held: 3.0 * k, is_held });
        let request = TorsionRequest {
            speeds: vec![100.0, 150.0],
            without_gas: true,
            meshed: throws.collect(),
            ..TorsionRequest::default()
        };
        torsion(&file, &[], &request).expect("a result")
    };
    let [free, held] = [false, true].map(meshed);
    assert!((stiff(&free.crank).expect("a shaft") / exact - 2.0).abs() < 1e-9);
    assert!((stiff(&held.crank).expect("a shaft") / exact - 3.0).abs() < 1e-9);
    let text = torsion_text(&held);
    assert!(text.contains("Throws by finite elements") && text.contains("held"), "{text}");
    assert_eq!(meshed_throws_table(&held).rows.len(), 6);
}

#[test]
fn given_stiffnesses_go_before_those_of_sizes_and_must_fit() {
    let list = "[torsion]\nstiffness = [\"1 MN m/rad\", \"2 MN m/rad\", \"3 MN m/rad\", \"4 MN m/rad\", \"5 MN m/rad\", \"6 MN m/rad\", \"7 MN m/rad\"]";
    let found = engine_chain(&file(&SIX.replace("[torsion]", list)), &[]).expect("a chain");
    let stiffnesses: Vec<f64> = found.chain.shafts().iter().map(|shaft| shaft.stiffness).collect();
    assert_eq!(stiffnesses[1..8], [1e6, 2e6, 3e6, 4e6, 5e6, 6e6, 7e6]);
    let short = list.replace(", \"7 MN m/rad\"", "");
    let reading = lanchester::file::read(&SIX.replace("[torsion]", &short));
    assert!(reading.file.is_none());
    let told = &reading.diagnostics[0];
    assert!(
        told.code == "E1901" && told.message.contains("6 entries") && told.message.contains("7 pieces"),
        "{told:?}"
    );
}

/// Two crankshafts: what holds of both was noted twice, and the studio's page ended there.
#[test]
fn regress_what_holds_of_several_crankshafts_is_noted_once() {
    for name in ["square-4", "opposed-piston-3"] {
        let template = lanchester::file::template(name).expect("it is in the gallery");
        let text = lanchester::file::complete(template.text, &[], None).expect("it can be completed").text;
        let notes = engine_chain(&file(&text), &[]).expect("it says enough").notes;
        let mut once = notes.clone();
        once.sort();
        once.dedup();
        assert!(notes.len() > 1, "{name}: {notes:?}");
        assert_eq!(once.len(), notes.len(), "{name}: {notes:?}");
    }
}

#[test]
fn all_that_is_lacking_is_said_at_once() {
    let bare = lanchester::file::template("in-line-4").expect("it is in the gallery").text;
    let refused = torsion(&file(bare), &[], &TorsionRequest::default()).expect_err("it says too little");
    let text = refused.to_string();
    for part in ["[torsion]", "[flywheel]", "crankshaft_inertia", "stiffness"] {
        assert!(text.contains(part), "{part} is missing in {text}");
    }
    let speeds = TorsionRequest { speeds: vec![100.0, 90.0], ..TorsionRequest::default() };
    assert!(matches!(torsion(&file(SIX), &[], &speeds), Err(EngineTorsionError::Speeds { .. })));
}

#[test]
fn tuned_damper_is_no_worse_than_the_given_one_and_time_agrees() {
    let speeds: Vec<f64> = (0..31).map(|k| 62.8 + 7.0 * f64::from(k)).collect();
    let request = TorsionRequest {
        speeds,
        tune: Some(None),
        time: Some(180.0),
        highest_order: Some(8.0),
        ..TorsionRequest::default()
    };
    let found = torsion(&file(SIX), &[], &request).expect("a result");
    let tuned = found.tuned.expect("tuned");
    assert!(
        tuned.peak <= tuned.given * (1.0 + 1e-9) && tuned.given <= tuned.locked,
        "{} {} {}",
        tuned.peak,
        tuned.given,
        tuned.locked
    );
    assert!(tuned.curve.iter().all(|point| point.peak >= tuned.peak * (1.0 - 1e-9)));
    let time = found.time.expect("checked");
    for (orders, linear) in time.orders.torques.iter().zip(&time.linear.torques) {
        assert!(
            (orders - linear).abs() < 2e-3 * orders,
            "{orders} by orders, {linear} in time: samples of a period"
        );
    }
    assert!(time.is_balanced() && time.orders.energy.is_none(), "{}", time.energy_error());
    for own in [&time.linear, &time.varying] {
        let energy = own.energy.expect("in time");
        assert!(own.energy_error == Some(energy.error()) && energy.damping > 0.0, "{energy:?}");
    }
    // Inertia that varies by some percent.
    assert!(
        (time.varying.twist / time.linear.twist - 1.0).abs() < 0.15,
        "{} {}",
        time.varying.twist,
        time.linear.twist
    );
}

#[test]
fn pendulums_and_branches_are_stations() {
    let more = "[[pendulum]]\nthrow = 6\nmass = \"0.5 kg\"\npivot_radius = \"81 mm\"\nlength = \"9 mm\"\nnumber = 2\n\n[[torsion.branch]]\nname = \"fan\"\nat = \"nose\"\n\
                inertia = \"0.05 kg m2\"\nstiffness = \"2 kN m/rad\"\nratio = 1.5\n\n[[torsion.branch]]\nat = \"fan\"\ninertia = \"0.01 kg m2\"\nstiffness = \"1 kN m/rad\"\n";
    let file = file(&format!("{SIX}\n{more}"));
    let found = torsion(
        &file,
        &[],
        &TorsionRequest { speeds: vec![100.0, 150.0, 200.0], ..TorsionRequest::default() },
    )
    .expect("a result");
    let chain = &found.crank.chain;
    assert_eq!(chain.stations().len(), 14);
    let fan = chain.stations().iter().find(|station| station.name == "fan").expect("a fan");
    assert!((fan.ratio - 1.5).abs() < 1e-12);
    let second = chain.stations().iter().find(|station| station.name == "branch 2").expect("a branch on it");
    assert!((second.ratio - 1.5).abs() < 1e-12);
    assert_eq!(chain.stations().iter().filter(|station| station.kind == StationKind::Pendulum).count(), 1);
    // Order 3 is taken away at throw 6: sqrt(81/9) = 3.
    let throw = found.crank.throws[5];
    let own = |result: &lanchester::report::TorsionResult| result.sweep.stations[throw].by_order[5][1];
    let without = torsion(
        &self::file(SIX),
        &[],
        &TorsionRequest { speeds: vec![100.0, 150.0, 200.0], ..TorsionRequest::default() },
    )
    .expect("a result");
    assert!(own(&found) < 1e-6 * own(&without), "{} instead of {}", own(&found), own(&without));
    // The expanded form is the same file.
    let text = lanchester::file::expanded(&file);
    assert_eq!(self::file(&text).engine.torsion, file.engine.torsion);
}
