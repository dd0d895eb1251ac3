//! Fatigue of a crankshaft: superposition of unit loads against loads solved one by one.

use lanchester::flex::crank_mesh::{CrankMeshOptions, crank_mesh_of_bay};
use lanchester::flex::statics::SolveOptions;
use lanchester::flex::throw_stress::{ThrowSupports, throw_stress};
use lanchester::model::Engine;
use lanchester::report::rule_text;
use lanchester::strength::{RangeBreach, RuleFactors, RuleMaterial, rule_throws};
use lanchester::{
    FatigueRequest, RuleRequest, StaticRequest, StressError, StressLoad, StressMesh, crank_fatigue,
    crank_rule, crank_rule_with_torsion, static_stress, throw_factors, with_element_factors,
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
pin_fillet = "6 mm"
journal_fillet = "6 mm"
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
        assert!((safety * fillet.point.plane.value / found.measure.findley.allowed - 1.0).abs() < 1e-12);
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

#[test]
fn factors_by_elements_stand_near_those_of_the_formulas() {
    let engine = engine();
    let options = CrankMeshOptions { size: 14e-3, fillet_elements: 4, ..CrankMeshOptions::default() };
    let bay = crank_mesh_of_bay(&engine, 0, options, 1).unwrap();
    let throws = rule_throws(&engine, 0).unwrap();
    let supports = ThrowSupports { pin: 1, mains: throws[0].mains };
    let found = throw_stress(&bay, supports, SolveOptions::default(), &|_| ()).unwrap();
    assert!((found.front_share - 0.5).abs() < 1e-6, "the throw is symmetric: {}", found.front_share);
    let names: Vec<&str> = found.fillets.iter().map(|own| own.name.as_str()).collect();
    assert_eq!(names, ["journal 1 at web 1", "pin 1 at web 1", "pin 1 at web 2", "journal 2 at web 2"]);
    let [journal, pin, ..] = found.fillets.as_slice() else { panic!("four fillets") };
    // A symmetric throw has the same stress at both webs but for its mesh, which is none.
    for (front, rear) in [(pin, &found.fillets[2]), (journal, &found.fillets[3])] {
        for (a, b) in
            [(front.bending, rear.bending), (front.force, rear.force), (front.torsion, rear.torsion)]
        {
            assert!((a / b - 1.0).abs() < 0.02, "{front:?} {rear:?}");
        }
    }
    let [own, _] = throw_factors(&throws[0], &found).unwrap();
    let rule = RuleFactors::new(&throws[0].sections[0].ratios()).values();
    // Solid pins: of such throws the formulas for the pin are near; how far those for the journal are off is what this crankshaft gives.
    let off = |own: f64, rule: f64| own / rule - 1.0;
    assert!(off(own.alpha_b, rule.alpha_b).abs() < 0.08, "{own:?} {rule:?}");
    assert!(off(own.alpha_t, rule.alpha_t).abs() < 0.08, "{own:?} {rule:?}");
    assert!((-0.25..0.0).contains(&off(own.beta_b, rule.beta_b)), "{own:?} {rule:?}");
    assert!((0.0..0.3).contains(&off(own.beta_t, rule.beta_t)), "{own:?} {rule:?}");
    assert!(own.beta_q > 0.0 && own.beta_q < rule.beta_q, "{own:?} {rule:?}");
}

#[test]
fn a_web_outside_the_range_is_judged_by_its_factors_by_elements() {
    let engine = engine();
    let mut rule = crank_rule(&engine, &[], &RuleRequest::default()).unwrap();
    let material =
        RuleMaterial { tensile_strength: rule.tensile_strength.value, forging: rule.forging.value };
    let own = rule.speeds[0].throws[0].clone();
    let factors = own.webs.each_ref().map(|web| web.factors.as_ref().unwrap().values());
    // The factors of the formulas, taken as those by elements, give the safeties of the formulas.
    let both = own.with_elements(factors, material);
    let by_formulas: Vec<_> = both.safeties().collect();
    assert_eq!(both.safeties_by_elements().collect::<Vec<_>>(), by_formulas);
    // Without formulas they alone judge, and nothing is left without a verdict.
    let mut outside = both.clone();
    let breach = RangeBreach { ratio: "b = B/D", value: 3.0, range: [1.1, 2.2] };
    for web in &mut outside.webs {
        (web.factors, web.pin_fillet, web.journal_fillet) = (None, None, None);
        web.breaches = vec![breach];
    }
    assert_eq!(outside.safeties().collect::<Vec<_>>(), by_formulas);
    assert_eq!((outside.breaches().count(), outside.unjudged().count()), (2, 0));
    outside.webs[1].by_elements = None;
    assert_eq!(outside.unjudged().map(|(place, _)| place).collect::<Vec<_>>(), ["web 2"]);
    rule.speeds[0].throws[0] = outside;
    assert!(!rule.is_accepted());
    assert!(rule_text(&rule).contains("Web 1: "), "{}", rule_text(&rule));
}

#[test]
fn factors_on_too_few_elements_are_refused() {
    let engine = engine();
    let rule = crank_rule(&engine, &[], &RuleRequest::default()).unwrap();
    let mesh = StressMesh::of(None, 0, None, Some(4), CrankMeshOptions::default());
    let refused = with_element_factors(&engine, rule, &mesh, SolveOptions::default(), &|_| ()).unwrap_err();
    assert_eq!(refused, StressError::CoarseFactors { needed: 6, got: 4 });
}

/// Between its lowest and its highest speed a crankshaft meets its resonance: the sheet judges it there unless asked for speeds.
#[test]
fn the_sheet_finds_the_speed_at_which_torsional_vibration_is_worst() {
    let text = lanchester::file::template("v8-flat-plane").unwrap().text;
    let mut file = lanchester::file::complete(text, &[], None).unwrap().text;
    let end = file.find("[damper]").unwrap();
    let section = &file[end..];
    let next = section[1..].find("\n\n").map_or(section.len(), |at| at + 1);
    file.replace_range(end..end + next, "");
    let file = lanchester::file::read(&file).file.unwrap();
    let least = |sheet: &lanchester::report::CrankRule| sheet.decisive().unwrap().least().unwrap().1;
    let found = crank_rule_with_torsion(&file, &[], &RuleRequest::default()).unwrap();
    assert_eq!(found.speeds.len(), 3);
    let range = file.engine.speed;
    assert_eq!([found.speeds[0].speed, found.speeds[2].speed], [range.lowest, range.highest]);
    let speeds: Vec<f64> =
        (0..=60).map(|k| range.lowest + (range.highest - range.lowest) * f64::from(k) / 60.0).collect();
    let all = crank_rule_with_torsion(&file, &[], &RuleRequest { speeds, ..RuleRequest::default() }).unwrap();
    let ends = RuleRequest { speeds: vec![range.lowest, range.highest], ..RuleRequest::default() };
    let ends = crank_rule_with_torsion(&file, &[], &ends).unwrap();
    assert!(
        least(&found) < 1.02 * least(&all) && least(&found) < 0.8 * least(&ends),
        "{} {} {}",
        least(&found),
        least(&all),
        least(&ends)
    );
    assert!(found.notes.iter().any(|note| note.contains("rpm lies between")));
}
