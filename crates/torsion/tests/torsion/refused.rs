//! Bad chains and requests.

use crate::forced::unit;
use lanchester_torsion::{
    Chain, Shaft, Station, StationKind, TorsionError, TuneAim, TuneFree, TuneRequest, sweep, tune,
};

fn text(refused: Result<Chain, TorsionError>) -> String {
    refused.unwrap_err().to_string()
}

#[test]
fn all_faults_of_a_chain_at_once() {
    let stations = vec![
        Station::new("hub", StationKind::Other, 0.0),
        Station::new("throw 1", StationKind::Other, -1.0),
        Station::new("flywheel", StationKind::Other, f64::NAN),
    ];
    let shafts =
        vec![Shaft::new("front", 0, 1, 0.0), Shaft { damping: -1.0, ..Shaft::new("rear", 1, 7, 5.0) }];
    let said = text(Chain::new(stations, shafts));
    for part in
        ["station 1 (hub)", "got -1", "got NaN", "shaft 1 (front)", "damping", "station 8, of 3", "hint:"]
    {
        assert!(said.contains(part), "{part} is missing in {said}");
    }
}

#[test]
fn more_masses_than_shafts_and_loops() {
    let said = text(Chain::plain(&[1.0, 1.0, 1.0, 1.0], &[5.0, 5.0]));
    assert!(said.contains("nothing joins it to the rest: 4 stations need 3 shafts, got 2"), "{said}");
    let stations = (0..3).map(|_| Station::new("s", StationKind::Other, 1.0)).collect();
    let shafts = vec![Shaft::new("a", 0, 1, 1.0), Shaft::new("b", 1, 2, 1.0), Shaft::new("c", 2, 0, 1.0)];
    assert!(text(Chain::new(stations, shafts)).contains("closes a loop"));
    assert!(text(Chain::plain(&[1.0], &[])).contains("two stations"));
}

#[test]
fn speeds_and_torques_that_do_not_fit() {
    let chain = Chain::plain(&[1.0, 2.0], &[50.0]).unwrap();
    let mut excitation = unit(&chain, 0, 0, 2);
    assert!(
        sweep(&chain, &excitation, &[0.0])
            .unwrap_err()
            .to_string()
            .contains("speed [rad/s] must be more than 0")
    );
    excitation.sources[0].station = 5;
    assert!(sweep(&chain, &excitation, &[1.0]).unwrap_err().to_string().contains("station of a torque"));
    excitation.sources[0].station = 0;
    excitation.sources[0].inertia.pop();
    assert!(
        sweep(&chain, &excitation, &[1.0])
            .unwrap_err()
            .to_string()
            .contains("orders of a torque must be 2, got 1")
    );
    let request = TuneRequest {
        aim: TuneAim::Twist,
        free: TuneFree::Damping,
        speeds: vec![1.0],
        damping: None,
        stiffness: None,
        points: 9,
    };
    assert!(matches!(tune(&chain, &unit(&chain, 0, 0, 1), &request), Err(TorsionError::NoDamper)));
}
