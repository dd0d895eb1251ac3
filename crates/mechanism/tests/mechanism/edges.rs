//! Engines at the edge of what a file can say.
use crate::support::{assert_close, crankshaft, engine, in_line};
use lanchester_mechanism::{Kinematics, LoadError, LoadRequest, loads};
use lanchester_model::{BalanceShaft, Crankshaft, Ratio, ShaftWeight};

fn shaft(numerator: i32, denominator: u32) -> BalanceShaft {
    let weights = vec![ShaftWeight::new(0.1, 0.01, 0.3)];
    BalanceShaft {
        name: "shaft".into(),
        ratio: Ratio::new(numerator, denominator).expect("not 0"),
        x: 0.0,
        y: 0.1,
        weights,
        inertia: None,
    }
}

#[test]
fn an_engine_without_masses_has_no_loads() {
    let loads = loads(&engine("empty", Vec::new(), Vec::new()), &LoadRequest::default()).unwrap();
    assert!(loads.total.peaks.force.max.value == 0.0 && loads.parts.is_empty() && loads.motion.is_empty());
    assert_eq!(loads.diagnosis.findings.len(), 0);
}

#[test]
fn fast_shafts_are_followed_to_their_peaks() {
    let mut engine = engine("shaft", Vec::new(), Vec::new());
    engine = engine
        .with(|engine| {
            engine.shafts.push(shaft(-1001, 1));
        })
        .unwrap();
    let loads = loads(&engine, &LoadRequest::default()).unwrap();
    let force = 0.01 * (1001.0f64 * 300.0).powi(2);
    let peaks = &loads.total.peaks;
    assert_close("force along x", peaks.force_x.max.value, force, 0.0, 1e-12, "a turning vector");
    assert_close("force", peaks.force.min.value, force, 0.0, 1e-12, "a turning vector");
    assert_close("roll moment", peaks.roll_moment.max.value, 0.1 * force, 0.0, 1e-12, "force times lever");
}

#[test]
fn ratios_beyond_reason_do_not_panic() {
    for (numerator, denominator) in [(i32::MIN, 1), (i32::MAX, 1), (1, 120), (-119, 120)] {
        let mut engine = in_line(&[0.0, 180.0]);
        engine = engine
            .with(|engine| {
                engine.shafts.push(shaft(numerator, denominator));
            })
            .unwrap();
        let request = LoadRequest { samples: 8, ..LoadRequest::default() };
        let loads = loads(&engine, &request).unwrap();
        assert!(loads.total.peaks.force.max.value.is_finite());
    }
    let mut engine = in_line(&[0.0]);
    engine = engine
        .with(|engine| {
            engine.shafts.push(shaft(1, 121));
        })
        .unwrap();
    assert_eq!(loads(&engine, &LoadRequest::default()), Err(LoadError::PeriodTooLong { limit: 120 }));
}

#[test]
fn a_slow_crankshaft_brings_fractional_orders() {
    let mut engine = in_line(&[0.0, 90.0]);
    engine = engine
        .with(|engine| {
            engine.crankshafts.push(Crankshaft {
                name: "slow".into(),
                ratio: Ratio::new(-1, 2).unwrap(),
                phase: 0.4,
                y: 0.3,
                ..crankshaft()
            });

            engine.throws[1].crankshaft = 1;
        })
        .unwrap();
    let loads = loads(&engine, &LoadRequest::default()).unwrap();
    let half = loads.total.orders.iter().find(|o| o.order == 0.5).unwrap();
    assert!(half.force_backward.norm() > half.force_forward.norm() && half.force_forward.norm() > 1.0);
    assert_close("period", loads.period, 2.0 * std::f64::consts::TAU, 0.0, 1e-15, "two revolutions");
}

#[test]
fn the_power_series_refuses_offsets() {
    let mut engine = in_line(&[0.0]);
    engine = engine
        .with(|engine| {
            engine.cylinders[0].offset = 0.01;
        })
        .unwrap();
    let kinematics = Kinematics::PowerSeries { max_order: 4, max_power: 5 };
    let error = loads(&engine, &LoadRequest { kinematics, ..LoadRequest::default() }).unwrap_err();
    assert!(error.to_string().starts_with("the power series needs a centred plain rod"), "{error}");
}

#[test]
fn requests_out_of_range_are_errors() {
    let engine = in_line(&[0.0]);
    let default = LoadRequest::default();
    for request in [
        LoadRequest { speed: Some(0.0), ..default.clone() },
        LoadRequest { speed: Some(f64::NAN), ..default.clone() },
        LoadRequest { samples: 0, ..default.clone() },
        LoadRequest { max_order: 0, ..default.clone() },
        LoadRequest { reference: [f64::INFINITY, 0.0, 0.0], ..default.clone() },
        LoadRequest { kinematics: Kinematics::Orders(0), ..default.clone() },
    ] {
        assert!(matches!(loads(&engine, &request), Err(LoadError::Request { .. })), "{request:?}");
    }
}
