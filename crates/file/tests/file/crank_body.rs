//! The outline of a plain web: the convex hull of its two discs.

use lanchester_file::read;
use lanchester_model::CrankBody;
use proptest::prelude::*;
use std::f64::consts::PI;

fn body(web_radius: f64, pin_end_radius: f64) -> CrankBody {
    CrankBody {
        density: 7850.0,
        journal_diameter: 0.05,
        journal_bore: 0.0,
        pin_diameter: 0.045,
        pin_bore: 0.0,
        web_thickness: 0.018,
        web_radius,
        pin_end_radius,
        end_journals: [0.02, 0.03],
    }
}

#[test]
fn equal_discs_make_a_slot() {
    let web = body(0.04, 0.04).web(0.045).unwrap();
    let moments = web.moments();
    let area = PI * 0.04 * 0.04 + 0.08 * 0.045;
    assert!((moments.area - area).abs() < 1e-15);
    assert!((moments.first.x + area * 0.0225).abs() < 1e-16);
    assert!(moments.first.y.abs() < 1e-18);
}

#[test]
fn a_disc_within_the_other_is_refused() {
    let error = body(0.09, 0.03).web(0.045).unwrap_err().to_string();
    assert!(error.contains("neither of the two discs"), "{error}");
}

proptest! {
    /// Two discs, and the trapezoids between their tangents and radii.
    #[test]
    fn prop_area_and_centre_are_those_of_the_pieces(
        disc in 0.02..0.08f64, end in 0.02..0.08f64, slack in 0.01..1.0f64,
    ) {
        let throw = (disc - end).abs() * (1.0 + slack) + 1e-3;
        let outline = body(disc, end).web(throw).unwrap();
        // Half the hull by slices across the line of both axes.
        let half_width = |x: f64| {
            let circle = |centre: f64, radius: f64| (radius * radius - (x - centre).powi(2)).max(0.0).sqrt();
            let sine = (disc - end) / throw;
            let cosine = (1.0 - sine * sine).sqrt();
            let (from, to) = (-disc * sine, -throw - end * sine);
            if x <= from && x >= to {
                (disc + sine * x) / cosine
            } else if x > from {
                circle(0.0, disc)
            } else {
                circle(-throw, end)
            }
        };
        let (low, high) = (-throw - end, disc);
        let steps = 200_000;
        let step = (high - low) / f64::from(steps);
        let (mut area, mut first) = (0.0, 0.0);
        for k in 0..steps {
            let x = low + (f64::from(k) + 0.5) * step;
            area += 2.0 * half_width(x) * step;
            first += 2.0 * half_width(x) * x * step;
        }
        let moments = outline.moments();
        prop_assert!((moments.area - area).abs() < 1e-6 * area, "{} {area}", moments.area);
        prop_assert!((moments.first.x - first).abs() < 1e-6 * area * (throw + end));
        prop_assert!(moments.first.y.abs() < 1e-15);
        prop_assert!((outline.swept_radius() - disc.max(throw + end)).abs() < 1e-15);
    }
}

/// nu rho: 12 mm²/s at 850 kg/m³ are 10.2 mPa s.
#[test]
fn a_kinematic_viscosity_with_a_density_is_a_dynamic_one() {
    for unit in ["12 cSt", "12 mm2/s", "12e-6 m2/s"] {
        let text = format!(
            "name = \"x\"\nspeed = \"1000 rpm\"\n[layout]\ntype = \"in-line\"\ncylinders = 1\n[piston]\nmass = \"0.3 kg\"\n\
             [rod]\nlength = \"110 mm\"\nmass = \"0.3 kg\"\n[crank]\nstroke = \"60 mm\"\n\
             [bearings.film]\nkinematic_viscosity = \"{unit}\"\ndensity = \"850 kg/m3\"\n"
        );
        let engine = read(&text).engine().unwrap();
        let viscosity = engine.bearing_design.as_ref().unwrap().oil.viscosity.unwrap();
        assert!((viscosity - 10.2e-3).abs() < 1e-12, "{unit}: {viscosity}");
    }
}

/// Numbers that no bearing has are told, each with its place; a bearing at the end of the crankshaft may be wider than the room between two throws.
#[test]
fn bearings_that_nobody_builds_are_told() {
    const FOUR: &str = include_str!("../../../../examples/in-line-4-crank-by-elements.toml");
    let told = |from: &str, to: &str| -> Vec<String> {
        assert!(FOUR.contains(from), "{from}");
        let reading = read(&FOUR.replacen(from, to, 1));
        assert!(reading.file.is_some(), "{:?}", reading.diagnostics);
        let own = reading.diagnostics.iter().filter(|own| ["W1301", "W0801"].contains(&own.code));
        own.map(|own| own.message.clone()).collect()
    };
    let wide = |number: u32| {
        format!("[[bearings.main.each]]\nnumber = {number}\nwidth = \"30 mm\"\n\n[bearings.film]")
    };
    for (from, to, words) in [
        ("width = \"22 mm\"", "width = \"220 mm\"", "a width of 220 mm is more than the 26 mm between webs"),
        ("[bearings.film]", &wide(2), "a width of 30 mm is more than the 26 mm between webs"),
        ("supply_pressure = \"4 bar\"", "supply_pressure = \"4000 bar\"", "a supply pressure of 4000 bar"),
        ("[bearings.film]", "[bearings.film]\nroughness = \"0.5 mm\"", "a roughness of 0.5 mm"),
        (
            "viscosity = \"10 mPa s\"",
            "oil = \"SAE 5W-30\"\ntemperature = \"900 degC\"",
            "no bearing of an engine has a temperature of 900 degC",
        ),
        ("[crank.material]", "[crank.material]\nloss_factor = 3", "no crankshaft has a loss factor of 3"),
        (
            "diametral_clearance = \"0.06 mm\"",
            "diametral_clearance = \"0.006 mm\"",
            "goes ill with a diameter",
        ),
    ] {
        let told = told(from, to);
        assert!(told.len() == 1 && told[0].contains(words), "{to}: {told:?}");
    }
    for (from, to) in [
        ("[bearings.film]", "[bearings.film]"),
        ("[bearings.film]", &*wide(1)),
        ("[bearings.film]", &*wide(5)),
    ] {
        assert_eq!(told(from, to), [""; 0], "{to}");
    }
}
