//! Fatigue of a crankshaft: superposition of unit loads against loads solved one by one.

use lanchester::flex::crank_mesh::CrankMeshOptions;
use lanchester::model::Engine;
use lanchester::{
    FatigueRequest, RuleRequest, StaticRequest, StressLoad, StressMesh, crank_fatigue, crank_rule,
    static_stress,
};

const FILE: &str = r#"
name = "single"
speed = ["4000 rpm"]
[layout]
type = "in-line"
cylinders = 1
spacing = "90 mm"
[crank]
stroke = "95.5 mm"
web_distance = "48 mm"
[crank.body]
density = "7850 kg/m3"
journal_diameter = "55 mm"
pin_diameter = "48 mm"
web_thickness = "20 mm"
web_radius = "40 mm"
pin_end_radius = "36 mm"
end_journals = ["25 mm", "25 mm"]
pin_fillet = "4 mm"
journal_fillet = "4 mm"
[crank.material]
preset = "42CrMo4 quenched and tempered"
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"
"#;

fn engine() -> Engine {
    lanchester::file::read(FILE).engine().unwrap()
}

fn mesh() -> StressMesh {
    let options = CrankMeshOptions { size: 0.02, fillet_elements: 2, ..CrankMeshOptions::default() };
    StressMesh { options, ..StressMesh::default() }
}

/// The largest von Mises stress over the cycle by superposition is that of the instants solved one by one.
#[test]
fn superposed_stress_is_that_of_loads_solved_one_by_one() {
    let engine = engine();
    let instants = 4;
    let request = FatigueRequest { mesh: mesh(), instants, ..FatigueRequest::default() };
    let found = crank_fatigue(&engine, &[], &request, &|_| {}).unwrap();
    let fillets = &found.speeds[0].fillets;
    assert_eq!(fillets.len(), 4);
    let mut largest = vec![0.0f64; fillets.len()];
    for k in 0..instants {
        let load = StressLoad::Angles(vec![std::f64::consts::TAU * k as f64 / instants as f64]);
        let request = StaticRequest { mesh: mesh(), load, ..StaticRequest::default() };
        let own = static_stress(&engine, &[], &request, &|_| {}).unwrap();
        let peaks = own.cases[0].result.peaks.iter().filter_map(|peak| peak.stress);
        for (most, peak) in largest.iter_mut().zip(peaks) {
            *most = most.max(peak.von_mises);
        }
    }
    for (fillet, direct) in fillets.iter().zip(largest) {
        // Between two of 24 directions the pressure is spread a little wider than that of the force itself.
        let off = fillet.von_mises / direct - 1.0;
        assert!(off.abs() < 0.02, "{}: {} against {direct} Pa", fillet.name, fillet.von_mises);
        let safety = fillet.point.safety_of_all.unwrap();
        assert!((safety * fillet.point.plane.value / found.findley.allowed - 1.0).abs() < 1e-12);
    }
}

/// A chapter of the report where the file gives fillets and material, and the same numbers as the command.
#[test]
fn the_sheet_follows_speed_squared_under_inertia_alone() {
    let engine = engine();
    let speeds = vec![200.0, 400.0];
    let found = crank_rule(&engine, &[], &RuleRequest { speeds, ..RuleRequest::default() }).unwrap();
    let [slow, fast] = [0, 1].map(|k| found.speeds[k].throws[0].webs[0].nominal);
    for (slow, fast) in
        [(slow.sigma_b, fast.sigma_b), (slow.sigma_q, fast.sigma_q), (slow.pin_tau, fast.pin_tau)]
    {
        assert!((fast / slow - 4.0).abs() < 1e-9, "{slow} {fast}");
    }
    assert!(found.gas.is_none() && found.is_accepted());
}
