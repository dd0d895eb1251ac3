//! The formulas and the sheet.

use lanchester_strength::{
    ADDITIONAL, OilFactors, RuleFactors, RuleMaterial, RuleThrow, SectionRatios, StrengthError, ThrowLoad,
    WebSection, fatigue_strength, rule_sheet, rule_throws,
};
use lanchester_testkit::gallery::{engine, gallery};
use lanchester_testkit::{Within, assert_close};
use std::f64::consts::PI;

const ROUNDED: &str = "the number is rounded to the digits that stand here";

/// The throw of the typing check.
fn section() -> WebSection {
    WebSection {
        pin_diameter: 0.048,
        journal_diameter: 0.055,
        crank_radius: 0.04775,
        web_thickness: 0.02,
        web_width: 0.08,
        pin_fillet: 0.003,
        journal_fillet: 0.003,
        ..WebSection::default()
    }
}

fn ratios(s: f64, w: f64, b: f64, [r_pin, r_journal]: [f64; 2]) -> SectionRatios {
    SectionRatios { s, w, b, r_pin, r_journal, ..SectionRatios::default() }
}

fn values(ratios: &SectionRatios) -> [f64; 5] {
    let own = RuleFactors::new(ratios);
    [own.alpha_b, own.alpha_t, own.beta_b, own.beta_q, own.beta_t].map(|factor| factor.value)
}

#[test]
fn ratios_and_factors_of_the_typing_check() {
    let ratios = section().ratios();
    for (what, got, wanted) in
        [("s", ratios.s, 0.078_125), ("w", ratios.w, 0.416_667), ("b", ratios.b, 1.666_667)]
    {
        assert_close(what, got, wanted, Within::absolute(5e-7, ROUNDED));
    }
    let wanted = [2.7196, 1.7579, 3.0776, 3.4213, 1.7579];
    for (k, (got, wanted)) in values(&ratios).into_iter().zip(wanted).enumerate() {
        assert_close(&format!("factor {k}"), got, wanted, Within::absolute(5e-5, ROUNDED));
    }
    assert!(ratios.breaches().is_empty());
}

/// The same formulas, typed and evaluated by another program.
#[test]
fn bores_recesses_and_different_fillets_enter_as_in_formulas_typed_a_second_time() {
    let one = SectionRatios {
        d_journal: 0.4,
        d_pin: 0.25,
        t_pin: 0.01,
        t_journal: 0.02,
        ..ratios(0.31, 0.55, 1.35, [0.05, 0.09])
    };
    let two =
        SectionRatios { d_journal: 0.1, d_pin: 0.6, t_journal: 0.03, ..ratios(-0.2, 0.3, 1.9, [0.11, 0.04]) };
    let wanted = [
        [2.969_578_636_1, 2.136_409_579_6, 2.045_888_570_3, 2.223_090_932_9, 1.842_318_783_2],
        [2.547_204_788_2, 1.603_035_267_5, 3.327_480_026_6, 2.963_456_196_8, 1.962_896_869_7],
    ];
    for (ratios, wanted) in [one, two].iter().zip(wanted) {
        for (k, (got, wanted)) in values(ratios).into_iter().zip(wanted).enumerate() {
            assert_close(&format!("factor {k}"), got, wanted, Within::absolute(1e-10, ROUNDED));
        }
    }
}

#[test]
fn parts_multiply_to_their_factor() {
    let own = RuleFactors::new(&section().ratios());
    for factor in [own.alpha_b, own.alpha_t, own.beta_b, own.beta_q, own.beta_t] {
        let product: f64 = factor.parts.iter().map(|part| part.value).product();
        assert_close("product", product, factor.value, Within::share(1e-14, "rounding"));
        assert!(factor.parts.len() >= 4);
    }
}

#[test]
fn far_below_overlap_the_overlap_stays_at_minus_a_half_in_two_functions() {
    let [at, below] = [-0.5, -0.9].map(|s| RuleFactors::new(&ratios(s, 0.4, 1.5, [0.06, 0.06])));
    assert_eq!(at.alpha_b, below.alpha_b);
    assert_eq!(at.beta_b, below.beta_b);
    assert_eq!(at.alpha_t, below.alpha_t);
    assert_ne!(at.beta_q.value, below.beta_q.value);
    // A recess never lowers a factor.
    let deep = SectionRatios { t_pin: 0.05, ..ratios(-0.9, 0.4, 1.5, [0.06, 0.06]) };
    assert_eq!(RuleFactors::new(&deep).alpha_b.value, below.alpha_b.value);
}

#[test]
fn fatigue_strength_of_the_typing_check_and_its_least_radius() {
    let of = |forging, tensile: f64, d: f64, r: f64| {
        1e-6 * fatigue_strength(forging, 1e6 * tensile, 1e-3 * d, 1e-3 * r)
    };
    let within = Within::absolute(5e-3, ROUNDED);
    assert_close("K 1.05, 800 MPa", of(1.05, 800.0, 48.0, 3.0), 353.52, within);
    assert_close("K 1.0, 700 MPa", of(1.0, 700.0, 48.0, 3.0), 312.54, within);
    assert_close("K 0.93, 650 MPa", of(0.93, 650.0, 120.0, 2.0), 266.229, within);
    assert_eq!(of(1.0, 700.0, 48.0, 1.0), of(1.0, 700.0, 48.0, 2.0));
}

#[test]
fn breaches_name_the_ratio_and_the_amount() {
    let wide = ratios(0.55, 0.15, 2.3, [0.14, 0.02]);
    let words: Vec<String> = wide.breaches().iter().map(ToString::to_string).collect();
    assert_eq!(words.len(), 5, "{words:?}");
    assert_eq!(words[0], "s = S/D = 0.5500 is above the range 0 to 0.5 by 0.0500");
    assert_eq!(words[4], "r = R_G/D = 0.0200 is below the range 0.03 to 0.13 by 0.0100");
    let apart = ratios(-0.01, 0.4, 1.5, [0.06, 0.06]).breaches();
    assert!(apart[0].to_string().contains("do not overlap"), "{}", apart[0]);
    let bored = SectionRatios { d_oil: Some(0.25), ..ratios(0.1, 0.4, 1.5, [0.06, 0.06]) };
    assert!(bored.breaches().is_empty() && bored.oil_breach().is_some());
}

/// A throw of 0.1 m between its mains, pin off the middle.
fn throw() -> RuleThrow {
    let own = WebSection { oil_bore: Some(0.005), pin_bore: 0.012, ..section() };
    RuleThrow {
        throw: 0,
        mains: [0.0, 0.1],
        pin: 0.06,
        radius: own.crank_radius,
        webs: [0.02, 0.085],
        web_numbers: [1, 2],
        journals: [1, 2],
        sections: [own, WebSection { web_thickness: 0.024, ..own }],
        oil_hole: Some(lanchester_model::OilHole { diameter: 0.005, angle: 0.7 }),
        sense: 1.0,
    }
}

/// Everything once more in N and mm, from the drawings of the rule.
#[test]
fn a_sheet_equals_the_same_sums_by_hand() {
    let (radial, tangential) = (vec![-50e3, 4e3, 10e3, -3e3], vec![0.0, 9e3, -6e3, 2e3]);
    let load = ThrowLoad { radial: radial.clone(), tangential: tangential.clone(), vibration: 80.0 };
    let sheets =
        rule_sheet(&[throw()], &[load], RuleMaterial { tensile_strength: 800e6, forging: 1.05 }).unwrap();
    let sheet = &sheets[0];
    let within = Within::share(1e-12, "rounding");
    assert_close("radial", sheet.radial, 30e3, within);
    assert_close("torque behind", sheet.torques[1], 7.5e3 * 0.047_75, within);
    assert_eq!(sheet.torques[0], 0.0);
    // Rear web: 60 % of the force, 15 mm from its main, 24 mm thick.
    let web = &sheet.webs[1];
    let sigma_b = 0.6 * 30e3 * 15.0 / (80.0 * 24.0 * 24.0 / 6.0);
    let sigma_q = 0.6 * 30e3 / (80.0 * 24.0);
    let torque = 7.5e3 * 47.75 + 80e3;
    let tau_pin = torque / (PI / 16.0 * (48f64.powi(4) - 12f64.powi(4)) / 48.0);
    let tau_journal = torque / (PI / 16.0 * 55f64.powi(3));
    assert_close("sigma_B", 1e-6 * web.nominal.sigma_b, sigma_b, within);
    assert_close("sigma_Q", 1e-6 * web.nominal.sigma_q, sigma_q, within);
    assert_close("tau pin", 1e-6 * web.nominal.pin_tau, tau_pin, within);
    let factors = web.factors.as_ref().unwrap();
    let pin = ((factors.alpha_b.value * sigma_b + 10.0).powi(2)
        + 3.0 * (factors.alpha_t.value * tau_pin).powi(2))
    .sqrt();
    assert_close("pin fillet", 1e-6 * web.pin_fillet.unwrap().equivalent, pin, within);
    let bending = factors.beta_b.value * sigma_b + factors.beta_q.value * sigma_q + 10.0;
    let journal = (bending.powi(2) + 3.0 * (factors.beta_t.value * tau_journal).powi(2)).sqrt();
    assert_close("journal fillet", 1e-6 * web.journal_fillet.unwrap().equivalent, journal, within);
    assert_close(
        "strength",
        1e-6 * web.pin_fillet.unwrap().strength,
        353.515_903,
        Within::share(1e-8, ROUNDED),
    );
    // The front journal sees torsional vibration alone.
    assert_close("front journal", sheet.webs[0].nominal.journal_torque, 80.0, within);
    assert_close("front pin", sheet.webs[0].nominal.pin_torque, 1e-3 * torque, within);
    // Oil bore, 24 mm lever of the force at its mouth.
    let along: Vec<f64> =
        radial.iter().zip(&tangential).map(|(r, t)| r * 0.7f64.cos() + t * 0.7f64.sin()).collect();
    let (low, high) = along.iter().fold((f64::MAX, f64::MIN), |(l, h), f| (l.min(*f), h.max(*f)));
    let modulus = PI / 32.0 * (48f64.powi(4) - 12f64.powi(4)) / 48.0;
    let nominal = 24.0 * 0.5 * (high - low) / modulus;
    let bore = sheet.bore.as_ref().unwrap();
    assert_close("bore", 1e-6 * bore.nominal.sigma, nominal, within);
    let d = 5.0 / 48.0;
    let (sbo, sto) = ((3.0 - 5.88 * d + 34.6 * d * d) * nominal, (4.0 - 6.0 * d + 30.0 * d * d) * tau_pin);
    let equivalent = sbo / 3.0 * (1.0 + 2.0 * (1.0 + 2.25 * (sto / sbo).powi(2)).sqrt());
    let stress = bore.stress.unwrap();
    assert_close("bore equivalent", 1e-6 * stress.equivalent, equivalent, within);
    // K counts at fillets alone where it is above 1.
    assert_close("bore strength", stress.strength, fatigue_strength(1.0, 800e6, 0.048, 0.0025), within);
    assert_eq!(sheet.safeties().count(), 5);
}

#[test]
fn a_bore_in_torsion_alone_has_the_stress_of_torsion() {
    let load = ThrowLoad { radial: vec![0.0, 0.0], tangential: vec![0.0, 0.0], vibration: 300.0 };
    let sheet =
        rule_sheet(&[throw()], &[load], RuleMaterial { tensile_strength: 800e6, forging: 1.0 }).unwrap();
    let bore = sheet[0].bore.as_ref().unwrap();
    let gamma = OilFactors::new(5.0 / 48.0).gamma_t;
    assert_close(
        "equivalent",
        bore.stress.unwrap().equivalent,
        gamma * bore.nominal.tau,
        Within::share(1e-14, "rounding"),
    );
    assert_close(
        "additional",
        sheet[0].webs[0].pin_fillet.unwrap().bending,
        ADDITIONAL,
        Within::share(1e-14, "rounding"),
    );
}

#[test]
fn constant_forces_leave_the_sheet_as_it_is() {
    let wave = |shift: f64| ThrowLoad {
        radial: (0..72).map(|k| shift + 9e3 * (f64::from(k) * PI / 36.0).cos()).collect(),
        tangential: (0..72).map(|k| 5e3 * (f64::from(k) * PI / 18.0).sin()).collect(),
        vibration: 0.0,
    };
    let material = RuleMaterial { tensile_strength: 800e6, forging: 1.0 };
    let [one, two] = [0.0, -33e3].map(|shift| rule_sheet(&[throw()], &[wave(shift)], material).unwrap());
    for ((place, a), (_, b)) in one[0].safeties().zip(two[0].safeties()) {
        assert_close(&place, a, b, Within::share(1e-12, "rounding of forces four times as large"));
    }
}

#[test]
fn out_of_range_a_web_has_no_safety_and_its_neighbour_has() {
    let mut throw = throw();
    throw.sections[0].web_thickness = 0.005;
    let load = ThrowLoad { radial: vec![-1e3, 1e3], tangential: vec![0.0, 1e3], vibration: 0.0 };
    let sheet =
        rule_sheet(&[throw], &[load], RuleMaterial { tensile_strength: 800e6, forging: 1.0 }).unwrap();
    assert_eq!(sheet[0].safeties().count(), 3);
    let breaches: Vec<String> =
        sheet[0].breaches().map(|(place, breach)| format!("{place}: {breach}")).collect();
    assert_eq!(breaches, ["web 1: w = W/D = 0.1042 is below the range 0.2 to 0.8 by 0.0958"]);
}

#[test]
fn loads_that_do_not_fit_are_refused() {
    let material = RuleMaterial { tensile_strength: 800e6, forging: 1.0 };
    for loads in
        [vec![], vec![ThrowLoad::default()], vec![ThrowLoad { radial: vec![1.0], ..ThrowLoad::default() }]]
    {
        assert!(matches!(
            rule_sheet(&[throw()], &loads, material),
            Err(StrengthError::Loads { needed: 1, .. })
        ));
    }
}

/// A crankshaft by elements.
fn file(change: impl Fn(&str) -> String) -> lanchester_model::Engine {
    engine(&change(include_str!("../../../../examples/in-line-4-crank-by-elements.toml")))
}

#[test]
fn throws_of_a_crankshaft_by_elements() {
    let throws = rule_throws(&file(str::to_owned), 0).unwrap();
    assert_eq!(throws.len(), 4);
    let first = &throws[0];
    assert_eq!((first.web_numbers, first.journals), ([1, 2], [1, 2]));
    let [front, rear] = &first.sections;
    let within = Within::absolute(1e-12, "rounding");
    assert_close("W of web 1", front.web_thickness, 0.024, within);
    assert_close("W of web 2", rear.web_thickness, 0.020, within);
    assert_close("bore", front.pin_bore, 0.018, within);
    assert_close("fillet", front.pin_fillet, 0.0025, within);
    assert_close("recess", front.pin_recess, 0.0003, within);
    assert_close("front share", first.front_share(), 0.5, within);
    assert_close("centre main", throws[1].sections[1].journal_diameter, 0.062, within);
    assert_close("overlap", front.overlap(), 0.009, within);
    // Width of the hull of 38 mm and 34 mm at x = 24.5 mm: the tangents lie y = (38 - x c)/sqrt(1 - c^2) from the middle, c = 4/44.
    let c: f64 = 4.0 / 44.0;
    assert_close(
        "B",
        1e3 * front.web_width,
        2.0 * (38.0 - 24.5 * c) / (1.0 - c * c).sqrt(),
        Within::absolute(1e-9, "rounding"),
    );
}

#[test]
fn what_is_missing_comes_all_at_once() {
    let sharp = file(|text| {
        text.replace("journal_fillet = \"3 mm\"", "")
            .replace("\npin_fillet = \"3 mm\"", "\npin_fillet = \"0 mm\"")
    });
    let words = rule_throws(&sharp, 0).unwrap_err().to_string();
    for part in [
        "pin 2: a fillet radius above 0 is needed, it is 0 (sharp); give pin_fillet",
        "journal 1: a fillet radius above 0 is needed, it is not given; give journal_fillet",
        "journal 5",
    ] {
        assert!(words.contains(part), "{part} is missing in\n{words}");
    }
    assert!(!words.contains("pin 1:"), "pin 1 has its own fillet:\n{words}");
    assert_eq!(words.matches("journal 2:").count(), 1, "{words}");
    assert!(matches!(rule_throws(&gallery("in-line-4"), 0), Err(StrengthError::NoBody(_))));
}

#[test]
fn a_journal_without_a_main_bearing_is_refused_with_its_place() {
    let mut parts: lanchester_model::EngineParts = (*file(str::to_owned)).clone();
    parts.crankshafts[0].mains = Some(vec![-0.182, 0.182]);
    let words = rule_throws(&parts, 0).unwrap_err().to_string();
    assert!(words.contains("journal 2: a main bearing between"), "{words}");
}

#[test]
fn throws_that_share_a_web_are_refused() {
    let mut parts: lanchester_model::EngineParts = (*file(str::to_owned)).clone();
    // Throws 1 and 2 so close that their facing webs touch: no journal is left between them.
    parts.crank_details.as_mut().unwrap().webs.clear();
    let near = parts.throws[1].z - parts.throws[0].z - 0.065;
    parts.throws[0].z += near;
    parts.throws[0].webs = parts.throws[0].webs.map(|webs| webs.map(|z| z + near));
    let words = rule_throws(&parts, 0).unwrap_err().to_string();
    assert!(words.contains("throw 1: a main bearing on either side of it is needed"), "{words}");
    assert!(words.contains("throw 2: a main bearing on either side of it is needed"), "{words}");
}
