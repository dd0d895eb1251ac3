use super::*;
use crate::Sense;
use lanchester_file::read;
use proptest::prelude::*;

/// A single: stroke 80 mm, piston 0.4 kg, rod ends 0.3 and 0.1 kg, crank 0.01 kg m along the throw.
fn single(more: &str) -> Engine {
    let text = format!(
        "name = \"single\"\nspeed = \"6000 rpm\"\n[layout]\ntype = \"in-line\"\ncylinders = 1\n\
         [crank]\nstroke = \"80 mm\"\nunbalance = \"0.01 kg m\"\nweb_distance = \"44 mm\"\n[piston]\nmass = \"0.4 kg\"\n\
         [rod]\nlength = \"140 mm\"\nbig_end_mass = \"0.3 kg\"\nsmall_end_mass = \"0.1 kg\"\n{more}"
    );
    let reading = read(&text);
    reading.engine().unwrap_or_else(|| panic!("{:?}", reading.diagnostics))
}

fn vee(bank: f64) -> Engine {
    let text = format!(
        "name = \"vee\"\nspeed = \"6000 rpm\"\n[layout]\ntype = \"v\"\ncylinders = 2\nbank_angle = \"{bank} deg\"\n\
         spacing = \"100 mm\"\nbank_stagger = \"20 mm\"\ncrank_angles = [\"0 deg\"]\n\
         [crank]\nstroke = \"80 mm\"\nunbalance = \"0.01 kg m\"\n[piston]\nmass = \"0.4 kg\"\n\
         [rod]\nlength = \"140 mm\"\nbig_end_mass = \"0.3 kg\"\nsmall_end_mass = \"0.1 kg\"\n"
    );
    let reading = read(&text);
    reading.engine().unwrap_or_else(|| panic!("{:?}", reading.diagnostics))
}

fn one(engine: &Engine, given: FactorGiven) -> ThrowFactor {
    balance_factors(engine, &FactorRequest { given, ..FactorRequest::default() }).unwrap().remove(0)
}

fn near(got: f64, wanted: f64, what: &str) {
    assert!((got - wanted).abs() <= 1e-12 * wanted.abs().max(1e-2), "{what}: {got}, wanted {wanted}");
}

/// By hand: R = 0.01 + 0.3 * 0.04 = 0.022 kg m, P = 0.5 * 0.04 = 0.02 kg m.
#[test]
fn single_at_0_50_and_100_percent() {
    for (share, along, across, major, minor, tilt) in [
        (0.0, 0.02, 0.0, 0.02, 0.0, 0.0),
        (0.5, 0.01, 0.01, 0.01, 0.01, 0.0),
        (1.0, 0.0, 0.02, 0.02, 0.0, 0.5 * PI),
        (0.25, 0.015, 0.005, 0.015, 0.005, 0.0),
        (0.7, 0.006, 0.014, 0.014, 0.006, 0.5 * PI),
    ] {
        let factor = one(&single(""), FactorGiven::ReciprocatingShare(share));
        near(factor.opposite, 0.022 + share * 0.02, "counterweight");
        near(factor.along, along, "along");
        near(factor.across, across, "across");
        near(factor.ellipse.major, major, "major");
        near(factor.ellipse.minor, minor, "minor");
        near(factor.ellipse.tilt, tilt, "tilt");
        near(factor.total_share.unwrap(), (0.022 + share * 0.02) / 0.042, "share of total");
        near(factor.bobweight, 0.3 + share * 0.5, "bobweight");
        near(factor.bobweight_share.unwrap(), (0.3 + share * 0.5) / 0.8, "bobweight share");
        near(factor.least_peak_share.unwrap(), 0.5, "least peak");
    }
}

#[test]
fn the_sense_turns_where_the_factor_passes_half_and_lines_are_lines() {
    let engine = single("");
    let sense = |share| one(&engine, FactorGiven::ReciprocatingShare(share)).ellipse.sense;
    // Below 0 the weight is too light even for the rotating part: the force turns with the crank.
    assert_eq!(sense(-0.2), Sense::With);
    assert_eq!(sense(0.0), Sense::Line);
    assert_eq!(sense(0.3), Sense::Against);
    assert_eq!(sense(0.5), Sense::Against);
    assert_eq!(sense(0.8), Sense::Against);
    assert_eq!(sense(1.0), Sense::Line);
    assert_eq!(sense(1.2), Sense::With);
}

#[test]
fn the_file_is_read_back_as_it_was_written() {
    for at in ["throws", "webs"] {
        let engine = single(&format!(
            "[counterweights]\nrotating_share = \"100 %\"\nreciprocating_share = \"37 %\"\nat = \"{at}\"\n"
        ));
        let factor = one(&engine, FactorGiven::AsBuilt);
        near(factor.reciprocating_share.unwrap(), 0.37, at);
    }
}

/// A weight 30 degrees away from opposite tilts the ellipse: forward -w e^{i 30}, checked against the path itself.
#[test]
fn a_counterweight_at_an_angle_tilts_the_ellipse() {
    let engine = single("[[counterweight]]\nthrow = 1\nunbalance = \"0.032 kg m\"\nangle = \"210 deg\"\n");
    let factor = one(&engine, FactorGiven::AsBuilt);
    let w = Complex64::from_polar(0.032, 210f64.to_radians());
    let forward = Complex64::from(0.032) + w;
    near(factor.ellipse.forward.re, forward.re, "forward");
    near(factor.ellipse.forward.im, forward.im, "forward");
    near(factor.ellipse.tilt, 0.5 * forward.arg(), "tilt");
    let (mut longest, mut direction) = (0.0f64, 0.0);
    for step in 0..72_000 {
        let force = factor.ellipse.at(f64::from(step) * PI / 36_000.0);
        if force.norm() > longest {
            (longest, direction) = (force.norm(), force.arg());
        }
    }
    assert!((longest - factor.ellipse.major).abs() < 1e-9, "{longest}");
    let off = (direction - factor.ellipse.tilt).rem_euclid(PI);
    assert!(off.min(PI - off) < 1e-3, "{direction} {}", factor.ellipse.tilt);
    // Turned back to opposite, the same weight is a plain factor again.
    let request = FactorRequest { angle: Some(PI), ..FactorRequest::default() };
    let straight = balance_factors(&engine, &request).unwrap().remove(0);
    near(straight.reciprocating_share.unwrap(), 0.5, "straight");
}

/// V: along the bisector (1 + cos g)/2 of both reciprocating masses at the factor 0; 50 % of both leaves
/// cos g of one, 90 degrees nothing.
#[test]
fn a_vee_leaves_what_its_bank_angle_says() {
    for bank in [45.0, 60.0, 90.0, 120.0] {
        let cosine = f64::to_radians(bank).cos();
        let none = one(&vee(bank), FactorGiven::ReciprocatingShare(0.0));
        near(none.along, 0.02 * (1.0 + cosine), "along");
        near(none.across, 0.02 * (1.0 - cosine), "across");
        let half = one(&vee(bank), FactorGiven::LeastPeak);
        near(half.reciprocating_share.unwrap(), 0.5, "least peak");
        near(half.ellipse.major, 0.02 * cosine.abs(), "what no factor removes");
    }
    assert_eq!(one(&vee(90.0), FactorGiven::LeastPeak).ellipse.sense, Sense::None);
}

/// 20 g of oil on 0.5 kg of reciprocating mass are 4 %.
#[test]
fn oil_parts_wet_from_dry() {
    let engine = single("");
    let request = FactorRequest { given: FactorGiven::ReciprocatingShare(0.52), oil: 0.020, angle: None };
    let factor = balance_factors(&engine, &request).unwrap().remove(0);
    near(factor.reciprocating_share.unwrap(), 0.52, "dry");
    near(factor.wet_reciprocating_share.unwrap(), 0.48, "wet");
    near(factor.along, 0.02 * 0.52, "the running engine has its oil");
    near(factor.least_peak_share.unwrap(), 0.54, "oil wants more weight");
}

/// The path of the exact first order agrees with the loads of the mechanism, pin offset and geared crank included.
#[test]
fn the_ellipse_is_the_first_order_of_the_loads() {
    let text = "name = \"offset\"\nspeed = \"3000 rpm\"\n[[throw]]\nangle = \"0 deg\"\nz = \"0 mm\"\nradius = \"40 mm\"\n\
                unbalance = \"0.01 kg m\"\n[[cylinder]]\nthrow = 1\nangle = \"20 deg\"\noffset = \"9 mm\"\n\
                piston = { mass = \"0.4 kg\" }\nrod = { length = \"120 mm\", mass = \"0.45 kg\" }\n\
                [[counterweight]]\nthrow = 1\nunbalance = \"0.028 kg m\"\nangle = \"170 deg\"\n";
    let reading = read(text);
    let engine = reading.engine().unwrap_or_else(|| panic!("{:?}", reading.diagnostics));
    let factor = one(&engine, FactorGiven::AsBuilt);
    let loads = lanchester_mechanism::loads(&engine, &Default::default()).unwrap();
    let square = engine.speed.highest.powi(2);
    let first = &loads.total.orders[1];
    let psi = engine.pin_angle(0, 0.0);
    let off = (factor.ellipse.forward * Complex64::cis(psi) - first.force_forward / square).norm()
        + (factor.ellipse.backward * Complex64::cis(-psi) - first.force_backward / square).norm();
    assert!(off < 1e-14, "{off}");
    assert!(factor.ellipse.backward.im.abs() > 1e-4, "the offset must show");
}

#[test]
fn impossible_factors_are_refused_with_their_reason() {
    let engine = single("");
    let refused = |given, oil, angle| {
        balance_factors(&engine, &FactorRequest { given, oil, angle }).unwrap_err().to_string()
    };
    let share = FactorGiven::ReciprocatingShare(0.5);
    assert!(refused(share, -0.1, None).contains("oil [kg]"));
    assert!(refused(share, 0.0, Some(0.2)).contains("on the side away from the throw"));
    assert!(refused(FactorGiven::AxisRatio(-1.0), 0.0, None).contains("not negative"));
    assert!(refused(FactorGiven::TotalShare(f64::NAN), 0.0, None).contains("finite"));
}

proptest! {
    /// From any definition to the counterweight and back to every other.
    #[test]
    fn prop_definitions_round_trip(
        share in 0.02f64..1.6, bank in 1.0f64..170.0, angle in 95f64..265.0, oil in 0.0f64..0.03,
    ) {
        let engine = vee(bank);
        let angle = Some(angle.to_radians());
        let of = |given| {
            balance_factors(&engine, &FactorRequest { given, oil, angle }).unwrap().remove(0)
        };
        let first = of(FactorGiven::ReciprocatingShare(share));
        for given in [
            FactorGiven::ReciprocatingShare(first.reciprocating_share.unwrap()),
            FactorGiven::WetReciprocatingShare(first.wet_reciprocating_share.unwrap()),
            FactorGiven::TotalShare(first.total_share.unwrap()),
            FactorGiven::Bobweight(first.bobweight),
            FactorGiven::BobweightShare(first.bobweight_share.unwrap()),
            FactorGiven::Counterweight(first.opposite),
        ] {
            let again = of(given);
            prop_assert!((again.counterweight - first.counterweight).norm() < 1e-13, "{given:?}");
            prop_assert!((again.ellipse.major - first.ellipse.major).abs() < 1e-13);
        }
    }

    /// The axis ratio gives back the weight opposite the throw that it came from.
    #[test]
    fn prop_axis_ratio_round_trips(share in 0.0f64..1.0, bank in 1.0f64..170.0) {
        let engine = vee(bank);
        let cosine = bank.to_radians().cos();
        // Between the two factors at which the ellipse is a line the ratio is unique.
        let (low, high) = (0.5 * (1.0 - cosine.abs()), 0.5 * (1.0 + cosine.abs()));
        prop_assume!(cosine > 0.01);
        let share = low + (0.02 + 0.96 * share) * (high - low);
        let first = one(&engine, FactorGiven::ReciprocatingShare(share));
        let again = one(&engine, FactorGiven::AxisRatio(first.along / first.across));
        prop_assert!((again.opposite - first.opposite).abs() < 1e-12);
    }
}
