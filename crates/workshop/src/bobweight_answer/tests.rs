use super::*;
use lanchester_file::workshop::read_sheet;
use lanchester_file::{read, template};
use std::f64::consts::TAU;

const PARTS: &str = "[parts]\nbig_end = \"410 g\"\nbearing = \"45 g\"\nsmall_end = \"180 g\"\npiston = \"430 g\"\n\
                     piston_pin = \"140 g\"\nrings = \"46 g\"\nlocks = \"4 g\"\n";

fn sheet(head: &str) -> Sheet {
    let reading = read_sheet(&format!("name = \"sheet\"\n{head}\n{PARTS}"));
    reading.sheet.unwrap_or_else(|| panic!("{:?}", reading.diagnostics))
}

fn gallery(name: &str) -> Engine {
    read(template(name).unwrap().text).engine().unwrap()
}

/// V8: 2 (410 + 45) + 4 = 914 g, and half of 2 * 800 g: 1714 g on each of four pins; the share is derived, and the
/// crank in balance with it has no first order left, as little as the optimum.
#[test]
fn crossplane_v8() {
    let sheet = sheet("engine = \"v8.toml\"\n[bobweight]\npins = 4\nrods = 2\noil = \"4 g\"");
    let answer = bobweight_answer(&sheet, Some(&gallery("v8-crossplane"))).unwrap();
    assert_eq!(answer.bobweights.len(), 4);
    assert!(answer.bobweights.iter().all(|b| (b.mass - 1.714).abs() < 1e-12));
    assert!(!answer.share_given && (answer.reciprocating_share - 0.5).abs() < 1e-12);
    assert_eq!(answer.judged_by, Some("first-order couple of the engine"));
    let ways = &answer.comparison.as_ref().unwrap().ways;
    let (ours, best) = (&ways[1], &ways[ways.len() - 1]);
    assert!((ours.couple - best.couple).abs() < 1e-6 * ways[0].couple.max(1.0), "{ways:?}");
    // What no weight takes is the fourth order: 4 sqrt(2) m r w^2 A4, A4 = k^3/4 + 3 k^5/16 + 35 k^7/256 with k = r/l.
    let (k, square) = (38.1f64 / 129.0, (TAU * 100.0).powi(2));
    let fourth = k.powi(3) / 4.0 + 3.0 * k.powi(5) / 16.0 + 35.0 * k.powi(7) / 256.0;
    let by_hand = 32f64.sqrt() * 0.8 * 0.0381 * square * fourth;
    // Higher orders are a thousandth of it.
    assert!((best.force / by_hand - 1.0).abs() < 2e-3, "{} {by_hand}", best.force);
    // The file's own weights were made for other parts.
    assert!(ways[0].couple > 10.0 * best.couple.max(1.0));
}

/// Odd-firing 90-degree V6 with 36.6 %: 13.4 % of the forward couple is left that 50 % takes.
#[test]
fn odd_firing_v6_with_the_share_of_the_even_firing_one() {
    let sheet =
        sheet("engine = \"v6.toml\"\n[bobweight]\npins = 3\nrods = 2\nreciprocating_share = \"36.6 %\"");
    let answer = bobweight_answer(&sheet, Some(&gallery("v6-90-odd"))).unwrap();
    let [own, best] = answer.choices.as_slice() else { panic!("{:?}", answer.choices) };
    assert!((own.forward - 0.134).abs() < 1e-6 && own.backward < 1e-9, "{own:?}");
    assert!((best.share - 0.5).abs() < 1e-12 && best.forward == 0.0);
    let ways = &answer.comparison.as_ref().unwrap().ways;
    assert_eq!(ways.len(), 4);
    assert!(ways[1].couple > 1.1 * ways[2].couple, "{ways:?}");
    assert!(ways[3].couple <= ways[2].couple * (1.0 + 1e-9), "the optimum is never worse: {ways:?}");
    // At 50 % the second order is left: each pair's is sqrt(2) m r w^2 A2 across the V, three at 120 deg make a couple
    // of sqrt(3) times the spacing. At 36.6 % the first order comes on top: 13.4 % of sqrt(3) * 2 m r w^2 * spacing.
    let (k, square) = (43.2f64 / 151.0, (TAU * 80.0).powi(2));
    let couple = 3f64.sqrt() * 0.107 * 0.8 * 0.0432 * square;
    let second = 2f64.sqrt() * couple * (k + k.powi(3) / 4.0 + 15.0 * k.powi(5) / 128.0);
    let first = 0.134 * 2.0 * couple;
    // The stagger of the banks and higher orders are left out by hand.
    assert!((ways[2].couple / second - 1.0).abs() < 5e-3, "{} {second}", ways[2].couple);
    assert!((ways[1].couple / (first + second) - 1.0).abs() < 1e-2, "{} {}", ways[1].couple, first + second);
    // The bound of the proof is the optimum itself.
    let proved = answer.comparison.as_ref().unwrap();
    assert!((proved.couple_bound / ways[3].couple - 1.0).abs() < 1e-6, "{proved:?}");
}

/// One light piston must not turn the eye from the couple of the whole engine to the scatter of its parts.
#[test]
fn scatter_of_the_parts_does_not_change_what_decides() {
    let pins = "engine = \"v6.toml\"\n[bobweight]\nrods = 2\n[[pin]]\n[[pin]]\n[[pin]]\n\
                cylinder = [{ piston = \"427 g\" }, {}]";
    let answer = bobweight_answer(&sheet(pins), Some(&gallery("v6-90-odd"))).unwrap();
    assert_eq!(answer.judged_by, Some("first-order couple of the engine"));
    let four = sheet("engine = \"four.toml\"\n[bobweight]\npins = 4");
    let answer = bobweight_answer(&four, Some(&gallery("in-line-4"))).unwrap();
    assert_eq!((answer.judged_by, answer.reciprocating_share), (None, 0.5));
}

/// Without an engine the bank angle and the split tell the share; without both it is 50 %.
#[test]
fn share_of_a_layout_without_an_engine() {
    let even = sheet("[bobweight]\nrods = 2\nbank_angle = \"90 deg\"\nsplit_angle = \"-30 deg\"");
    let answer = bobweight_answer(&even, None).unwrap();
    assert!((answer.reciprocating_share - 0.5).abs() < 1e-12 && answer.comparison.is_none());
    let planes: Vec<f64> = answer.choices[1..].iter().map(|c| c.share).collect();
    assert!((planes[0] - 0.366_025_4).abs() < 1e-6 && (planes[1] - 0.633_974_6).abs() < 1e-6, "{planes:?}");
    assert!(answer.choices[1].why.ends_with("along y"));
    assert!(bobweight_answer(&sheet(""), None).unwrap().choices.is_empty());
}

#[test]
fn a_sheet_that_does_not_fit_the_engine() {
    let v8 = gallery("v8-crossplane");
    let said = |head: &str| bobweight_answer(&sheet(head), Some(&v8)).unwrap_err().to_string();
    assert!(
        said("engine = \"v8\"\n[bobweight]\nrods = 2\npins = 3")
            .contains("throw 4 of the engine needs a pin")
    );
    assert!(
        said("engine = \"v8\"\n[bobweight]\nrods = 1\npins = 4")
            .contains("as many rods as throw 1 of the engine, 2, got 1")
    );
    assert!(said("engine = \"v8\"\n[bobweight]\nrods = 2\npins = 5").contains("the engine has 4"));
    let empty = read_sheet("name = \"x\"").sheet.unwrap();
    assert!(bobweight_answer(&empty, None).unwrap_err().to_string().contains("[parts]"));
}
