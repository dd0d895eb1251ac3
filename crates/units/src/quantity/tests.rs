use super::*;
use proptest::prelude::*;
use std::f64::consts::PI;

fn length(text: &str) -> Result<f64, Refusal> {
    parse(text, Dimension::Length, "bore")
}

#[test]
fn powers_of_ten_are_exact() {
    assert_eq!(length("79.5 mm"), Ok(0.0795));
    assert_eq!(length("144mm"), Ok(0.144));
    assert_eq!(length("1.44e2 mm"), Ok(0.144));
    assert_eq!(length("-.5 cm"), Ok(-0.005));
    assert_eq!(length(" +3 µm "), Ok(3e-6));
    assert_eq!(length("1 in"), Ok(0.0254));
    assert_eq!(length("1 thou"), Ok(0.0000254));
    assert_eq!(parse("12.5 %", Dimension::Share, "share"), Ok(0.125));
    assert_eq!(parse("180 bar", Dimension::Pressure, "p"), Ok(18e6));
}

#[test]
fn compound_units_in_every_spelling() {
    for text in ["0.02 kg m", "0.02 kg*m", "0.02 kg·m", "0.02 kgm", "0.02kg m"] {
        assert_eq!(parse(text, Dimension::Unbalance, "u"), Ok(0.02), "{text}");
    }
    for text in ["2000 kg mm2", "2000 kg mm^2", "2000 kg mm²", "2000 kgmm2"] {
        assert_eq!(parse(text, Dimension::Inertia, "i"), Ok(2000e-6), "{text}");
    }
    assert!(length("5 m m").is_err());
    // 1 oz in = 28.349523125 g * 2.54 cm (international ounce and inch).
    let unbalance = parse("1 oz in", Dimension::Unbalance, "u").unwrap();
    assert!((unbalance - 7.200_778_873_75e-4).abs() < 1e-18, "{unbalance}");
    // 1 psi = 6894.757 Pa, 1 lbf ft = 1.355818 N m (NIST SP 811, appendix B.8).
    let pressure = parse("1 psi", Dimension::Pressure, "p").unwrap();
    assert!((pressure - 6894.757).abs() < 5e-4, "{pressure}");
    let torque = parse("1 lbf ft", Dimension::Torque, "t").unwrap();
    assert!((torque - 1.355_818).abs() < 5e-7, "{torque}");
}

#[test]
fn speeds_and_angles() {
    assert!((parse("60 rpm", Dimension::Speed, "s").unwrap() - 2.0 * PI).abs() < 1e-15);
    assert!((parse("1 Hz", Dimension::Speed, "s").unwrap() - 2.0 * PI).abs() < 1e-15);
    assert_eq!(parse("180 deg", Dimension::Angle, "a"), Ok(PI));
    assert_eq!(parse("90 deg", Dimension::Angle, "a"), Ok(PI / 2.0));
}

#[track_caller]
fn refused(text: &str, code: &str, hint: &str) {
    let refusal = length(text).expect_err(text);
    assert_eq!((refusal.code, refusal.hint.as_str()), (code, hint), "{text}");
}

#[test]
fn mistakes_say_how_to_mend_them() {
    refused("79,5 mm", "E0104", "write \"79.5 mm\"");
    refused("4,000 mm", "E0104", "write \"4.000 mm\", or \"4000 mm\" if the comma parts thousands");
    refused("4 000 mm", "E0105", "write \"4000 mm\"");
    refused("1,234.5 mm", "E0105", "write \"1234.5 mm\"");
    refused("79.5", "E0101", "write \"79.5 mm\", or another of mm, m, cm, um, in, ft or thou");
    refused("79.5 MM", "E0102", "write \"79.5 mm\"");
    refused("79.5 inch", "E0102", "write \"79.5 in\"");
    refused("5'", "E0102", "write \"5 ft\"");
    refused("79.5 furlong", "E0102", "a length is written in mm, m, cm, um, in, ft or thou");
    refused("79.5 kg", "E0103", "write it in mm, m, cm, um, in, ft or thou");
    refused("−5 mm", "E0105", "write the minus sign as \"-\"");
    refused("1.2.3 mm", "E0105", "write a plain decimal number such as \"12.5 mm\"");
    refused("inf mm", "E0106", "give the value itself");
    refused("1e999 mm", "E0106", "give the value itself");
    refused("1e99999999999 mm", "E0106", "give the value itself");
    refused("", "E0105", "write a number and a unit, such as \"1.5 mm\"");
    refused("mm", "E0105", "write a number and a unit, such as \"1.5 mm\"");
}

#[test]
fn names_of_one_unit_are_read_alike() {
    let rpm = parse("5500 rpm", Dimension::Speed, "speed");
    for text in [
        "5500 1/min",
        "5500/min",
        "5500 min^-1",
        "5500 min-1",
        "5500 min⁻¹",
        "5500 r/min",
        "5500 rev/min",
        "5.5 krpm",
    ] {
        assert_eq!(parse(text, Dimension::Speed, "speed"), rpm, "{text}");
    }
    assert_eq!(parse("1/min", Dimension::Speed, "speed"), parse("1 rpm", Dimension::Speed, "speed"));
    assert_eq!(parse("544000 mg", Dimension::Mass, "mass"), Ok(0.544));
}

#[test]
fn fractions_are_read() {
    let inches = |value: f64| Ok(value * 0.0254);
    assert_eq!(length("4 1/2 in"), inches(4.5));
    assert_eq!(length("-4 1/2 in"), inches(-4.5));
    assert_eq!(length("3/8in"), inches(0.375));
    assert_eq!(length("5/4 in"), inches(1.25));
    assert_eq!(parse("1/2 kg mm", Dimension::Unbalance, "u"), Ok(0.0005));
    let fraction = "write a fraction like \"1/2 in\" or \"4 1/2 in\"";
    for text in ["4 3/2 in", "1/0 in", "1.5/2 in", "4 1 1/2 in", "99999999999999999999/3 in"] {
        refused(text, "E0105", fraction);
    }
    refused("4-1/2 in", "E0105", "write \"4 1/2 in\"");
}

/// Quantities as people write them, each with what it says in SI: a suggestion must say the same.
#[test]
fn a_suggestion_keeps_what_the_number_says() {
    use Dimension::*;
    let cases = [
        ("1013 hPa", Pressure, 101_300.0),
        ("12 Mg", Mass, 12_000.0),
        ("3 dm2", Area, 0.03),
        ("2 km2", Area, 2e6),
        ("80 dm", Length, 8.0),
        ("5 mN", Force, 0.005),
        ("1.5 MN m", Torque, 1.5e6),
        ("20 mbar", Pressure, 2000.0),
        ("1.234,5 mm", Length, 1.2345),
        ("12 345,5 mm", Length, 12.3455),
        ("1,234,567 mm", Length, 1234.567),
        ("79.5 Inches", Length, 2.0193),
        ("5500 rmp", Speed, 5500.0 * PI / 30.0),
        ("3 KG", Mass, 3.0),
        ("7 MPA", Pressure, 7e6),
    ];
    for (text, dimension, value) in cases {
        let hint = parse(text, dimension, "key").expect_err(text).hint;
        let written = hint.split('"').nth(1).unwrap_or_else(|| panic!("{text}: no suggestion in {hint}"));
        let read = parse(written, dimension, "key").unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
        assert!((read - value).abs() <= 1e-12 * value, "{text}: {hint}");
    }
    // Where two readings are possible none is proposed.
    for (text, dimension) in [
        ("7 mpa", Pressure),
        ("90 grad", Angle),
        ("4 1 mm", Length),
        ("12,34,567 mm", Length),
        ("4½ in", Length),
        ("3 n", Length),
    ] {
        let hint = parse(text, dimension, "key").expect_err(text).hint;
        let of_the_text = hint.contains(|c: char| c.is_ascii_digit()) && !hint.contains("12.5");
        assert!(!of_the_text, "{text}: {hint}");
    }
}

#[test]
fn temperatures_have_a_range() {
    let within = |text: &str| {
        let value = parse(text, Dimension::Temperature, "temperature").expect(text);
        within(value, Dimension::Temperature, Bound::Any, "temperature", text, None)
    };
    assert_eq!(within("25 degC"), Ok(298.15));
    for text in ["-300 degC", "0 K", "20000 K"] {
        let refusal = within(text).expect_err(text);
        assert_eq!(refusal.code, "E0108");
        assert!(refusal.message.contains("[77 K, 5000 K]") && !refusal.hint.is_empty(), "{refusal:?}");
    }
}

#[test]
fn exact_text_prefers_units_that_read_well() {
    assert_eq!(exact_text(0.0795, Dimension::Length), "79.5 mm");
    assert_eq!(exact_text(0.0, Dimension::Length), "0 mm");
    assert_eq!(exact_text(2.0 * PI / 3.0, Dimension::Angle), "120 deg");
    assert_eq!(exact_text(4000.0 * (PI / 30.0), Dimension::Speed), "4000 rpm");
    assert_eq!(exact_text(0.0021, Dimension::Inertia), "2100 kg mm2");
    assert_eq!(readable(0.123_456, Dimension::Length), "123.5 mm");
}

proptest! {
    #[test]
    fn prop_exact_text_reads_back(value in proptest::num::f64::NORMAL | proptest::num::f64::ZERO) {
        for dimension in [
            Dimension::Length,
            Dimension::Mass,
            Dimension::Angle,
            Dimension::Speed,
            Dimension::Unbalance,
            Dimension::Inertia,
        ] {
            let text = exact_text(value, dimension);
            prop_assert_eq!(parse(&text, dimension, ""), Ok(value), "{}", text);
        }
    }

    #[test]
    fn prop_never_panics(text in any::<String>(), dimension in 0..Dimension::ALL.len()) {
        let _ = parse(&text, Dimension::ALL[dimension], "key");
    }
}
