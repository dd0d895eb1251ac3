//! Searches over layouts on the command line.

use crate::program::{folder, lanchester, message, number, output, output_json};
use serde_json::Value;
use std::path::Path;

/// An engine of the gallery in the folder.
pub fn gallery(folder: &Path, name: &str) -> String {
    let file = format!("{name}.toml");
    output(folder, 0, &["new", name, "--output", &file]);
    file
}

/// Size of an order of a load: both senses.
fn size(loads: &Value, load: &str, order: usize) -> f64 {
    let part = |sense: &str| {
        let at = |k: usize| number(loads, &format!("/total/orders/{order}/{load}_{sense}/{k}"));
        at(0).hypot(at(1))
    };
    part("forward") + part("backward")
}

#[test]
fn the_flat_crank_leads_the_in_line_fours_and_the_engine_is_told_to_be_it() {
    let folder = folder("explore-four");
    let four = gallery(&folder, "in-line-4");
    let text = output(&folder, 0, &["explore", &four, "--even-firing", "--figures", "figures"]);
    assert!(
        text.contains(
            "The space has 13\u{a0}824 cases: 1728 from the list of throw angles, times 8 from the choice"
        ),
        "{text}"
    );
    assert!(text.contains("1  0 180 180 0  1-3-4-2"), "{text}");
    assert!(text.contains("It is as good as no. 1."), "{text}");
    let svg = std::fs::read_to_string(folder.join("figures/layout-front.svg")).unwrap();
    assert!(svg.starts_with("<svg") && !svg.contains("NaN"));
    // The counts are of all cases, and the CSV of the front is that of the text.
    let json = output_json(&folder, 0, &["explore", &four, "--format", "json"]);
    let count = |pointer: &str| number(&json, pointer);
    assert_eq!(count("/counts/cases"), count("/counts/duplicates") + count("/counts/judged"));
    let csv = output(&folder, 0, &["explore", &four, "--format", "csv"]);
    assert_eq!(csv.lines().count() - 1, json["front"].as_array().unwrap().len());
    assert_eq!(json["given"]["equals"], Value::from(1));
}

/// A layout of the front as an engine file: read without a warning, with the loads that the front says.
#[test]
fn an_adopted_layout_has_the_loads_of_its_row() {
    let folder = folder("explore-adopt");
    let searches: [(&str, &str, Vec<&str>); 9] = [
        (
            "vr6-15",
            "vr6",
            vec!["--throw-angles", "0 deg, 120 deg, 240 deg, 30 deg", "--minimise", "couple order 2"],
        ),
        ("w12-broad-arrow", "w12", vec!["--even-firing"]),
        ("radial-14", "radial-14", vec!["--counterweights", "none, own, full", "--even-firing=10 deg"]),
        ("square-4", "square", vec!["--shafts", "2 @ 0 mm, 0 mm @ both -50 mm, 50 mm"]),
        ("opposed-piston-3", "opposed", vec![]),
        ("in-line-4", "in-line", vec![]),
        (
            "in-line-3",
            "three",
            vec![
                "--shafts",
                "none",
                "--shafts",
                "-1 @ 0 mm, 100 mm @ couple -80 mm, 80 mm",
                "--minimise",
                "shafts",
                "--minimise",
                "couple order 1",
                "--minimise",
                "counterweights",
                "--counterweights",
                "none, full, 100 % + 50 % on 101101",
            ],
        ),
        (
            "v6-60",
            "v",
            vec!["--bank-angle", "60 deg, 90 deg, 180 deg", "--split-angle", "-60 deg .. 60 deg by 30 deg"],
        ),
        (
            "in-line-2-two-stroke",
            "two-stroke",
            vec!["--cylinders", "4", "--minimise", "length", "--minimise", "force order 2"],
        ),
    ];
    for (engine, name, options) in searches {
        let file = gallery(&folder, engine);
        let json = output_json(&folder, 0, &[&["explore", &file, "--format", "json"][..], &options].concat());
        let front = json["front"].as_array().unwrap();
        for number_of in std::collections::BTreeSet::from([1, front.len()]) {
            let adopted = format!("{name}-{number_of}.toml");
            let wanted = number_of.to_string();
            let adopt = ["explore", &file, "--adopt", &wanted, "--output", &adopted];
            output(&folder, 0, &[&adopt[..], &options].concat());
            let checked = lanchester(&folder, &["check", &adopted]);
            assert!(checked.status.success() && checked.stderr.is_empty(), "{checked:?}");
            let loads = output_json(&folder, 0, &["loads", &adopted, "--format", "json"]);
            let row = &front[number_of - 1];
            for load in ["force", "couple"] {
                for order in [1usize, 2] {
                    let part = |sense: usize| {
                        let at = |k: usize| number(row, &format!("/orders/{load}/{}/{sense}/{k}", order - 1));
                        at(0).hypot(at(1))
                    };
                    let (said, is) = (part(0) + part(1), size(&loads, load, order));
                    // Loads are of the order of 1e5 N and 1e4 N m before they cancel; files hold 12 digits and more.
                    assert!((said - is).abs() < 1e-6 + 1e-9 * is, "{adopted} {load} {order}: {said} {is}");
                }
            }
            // Searched itself, the adopted engine stands where it came from.
            if !["three", "vr6", "radial-14"].contains(&name) {
                let again = output_json(
                    &folder,
                    0,
                    &["explore", &adopted, "--format", "json", "--throw-angles", "every 30 deg"],
                );
                assert!(again["given"]["outside"].is_null(), "{}", again["given"]);
            }
        }
    }
    // A file is never overwritten.
    let told =
        message(&folder, 2, &["explore", "in-line-4.toml", "--adopt", "1", "--output", "in-line-4.toml"]);
    assert!(told.contains("exists and is not overwritten"), "{told}");
}

#[test]
fn mistakes_of_a_search_are_told() {
    let folder = folder("explore-mistakes");
    let four = gallery(&folder, "in-line-4");
    let twelve = gallery(&folder, "w12-broad-arrow");
    let refused = |arguments: &[&str], said: &str| {
        let told = message(&folder, 2, &[&["explore"], arguments].concat());
        assert!(told.contains(said), "{told}");
    };
    refused(
        &[&four, "--cylinders", "24", "--throw-angles", "every 1 deg"],
        "the search space has about 10^65.7 cases, more than the 1000000000000 that may be looked at: the list of throw angles alone \
         makes about 10^58.8 of them",
    );
    refused(&[&four, "--max-cases", "1000"], "the search space has 13824 cases, more than the 1000");
    // The name that the option had before.
    refused(&[&four, "--most-cases", "1000"], "the search space has 13824 cases, more than the 1000");
    refused(&[&four, "--cylinders", "0"], "need a multiple of 1 cylinders, from 1 to 32, got 0");
    refused(&[&four, "--bank-angle", "90 deg", "--cylinders", "5"], "2 banks need a multiple of 2 cylinders");
    refused(&[&four, "--split-angle", "30 deg"], "split pins and stagger need two banks");
    refused(&[&four, "--in-line", "--bank-angle", "90 deg"], "an in-line engine has no bank angle");
    refused(
        &[&twelve, "--spacing", "180 mm"],
        "layouts of W12, broad arrow keep its cylinders, rods and pins, since it has 3 banks: the spacing cannot be chosen",
    );
    refused(&[&twelve, "--bearing-room", "20 mm"], "needs pins and planes that are searched");
    refused(
        &[&twelve, "--counterweights", "full on 1001"],
        "for each of the 8 webs whether it has a weight, got 4",
    );
    let nine = gallery(&folder, "radial-9");
    refused(&[&nine], "one throw: nothing to permute; radial 9 has the same loads in every firing order");
    refused(&[&nine], "give several --counterweights or --shafts");
    refused(&[&four, "--minimise", "noise"], "there is no quantity \"noise\"");
    refused(&[&four, "--minimise", "force order 3"], "layouts are not judged by `force order 3`");
    refused(&[&four, "--limit", "length = 5"], "needs a length with its unit");
    refused(&[&four, "--limit", "force order 1 = 5 kg"], "needs N or kN, got `5 kg`");
    refused(&[&four, "--limit", "length"], "needs an objective and its largest value");
    refused(&[&four, "--spacing", "100 mm, 100 mm"], "the list of spacings has the value at place 2 twice");
    refused(&[&four, "--spacing", "100 mm .. 50 mm by 5 mm"], "from the smaller to the larger");
    refused(&[&four, "--throw-angles", "every 7 deg"], "a step that divides the turn");
    refused(
        &[&four, "--counterweights", "full on 1001"],
        "for each of the 8 webs whether it has a weight, got 4",
    );
    refused(&[&four, "--shafts", "3 @ 0 mm, 0 mm @ force 0 mm"], "ORDER @ x, y @ force z");
    refused(&[&four, "--bearing-room", "20 mm"], "the thickness of the webs is not known from in-line 4");
    refused(&[&four, "--pin-overlap", "5 mm"], "give --pin-diameter");
    refused(&[&four, "--without-firing", "--even-firing"], "needs the firing orders in the search space");
    refused(&[&four, "--max-on-front", "3"], "more than 3 layouts are on the front");
    refused(&[&four, "--adopt", "1000", "--output", "x.toml"], "the number of a layout, 1 to 44, got 1000");
    // What is no engine is counted, and an answer without a layout says why.
    let text = output(
        &folder,
        0,
        &["explore", &four, "--rod-ratio", "0.3, 1.5", "--spacing", "30 mm, 60 mm, 100 mm"],
    );
    assert!(text.contains("have an invalid geometry: the rod is not longer than the crank radius"), "{text}");
    assert!(text.contains("have an invalid geometry: the webs of neighbouring throws overlap"), "{text}");
    assert!(text.contains("have an invalid geometry: neighbouring bores overlap"), "{text}");
    let text = output(&folder, 1, &["explore", &four, "--throw-angles", "every 120 deg", "--even-firing"]);
    assert!(text.contains("break the constraint `even firing within 0 deg`"), "{text}");
    let text = output(&folder, 0, &["explore", &four, "--limit", "force order 2 = 10 kN", "--ranking"]);
    let told = text.contains("break: force of order 2 at most 10000 N")
        && text.contains("It breaks: force of order 2");
    assert!(told && text.contains("The ranking"), "{text}");
}
