//! Engines side by side on the command line.

use crate::program::{example, folder, message, number, output, output_json};
use serde_json::Value;

/// The nine arrangements of the thesis stand as in its Table 38, and the optimum is not worse than any crank.
#[test]
fn arrangements_and_optimum_stand_side_by_side() {
    let folder = folder("compare-arrangements");
    let twin = example("twin-in-line-in-phase");
    let all = ["compare", &twin, "--arrangements", "all", "--optimum"];
    let json = output_json(&folder, 0, &[&all[..], &["--format", "json"]].concat());
    let force = |k: usize| number(&json, &format!("/engines/{k}/force"));
    assert_eq!(json["engines"].as_array().map(Vec::len), Some(10));
    assert!(force(9) <= force(1) && force(1) < 0.55 * force(0) && force(8) < 0.01 * force(0));
    assert_eq!(json.pointer("/rankings/0/places/9/engine"), Some(&Value::from(0)));
    let text = output(&folder, 0, &[&all[..], &["--figures", "figures"]].concat());
    assert!(
        text.contains(
            "10. 21\u{a0}977 N: above all order 1, the same with and against the crank (no. 1, basic crank)"
        ),
        "{text}"
    );
    assert!(folder.join("figures/comparison.svg").exists());
}

/// A similar engine made by hand, every length times 1.2 and every mass times 1.2^3, has the loads that the comparison says.
#[test]
fn a_similar_engine_is_the_engine_built_in_that_size() {
    let folder = folder("compare-similar");
    let text = |k: f64| {
        let (mass, length) = (k.powi(3), |mm: f64| k * mm);
        format!(
            "name = \"four {k}\"\nspeed = [\"1000 rpm\", \"5000 rpm\"]\n[firing]\norder = [1, 3, 4, 2]\n[layout]\ntype = \"in-line\"\n\
             cylinders = 4\nspacing = \"{} mm\"\n[crank]\nstroke = \"{} mm\"\n[piston]\nmass = \"{} kg\"\nbore = \"{} mm\"\n[rod]\n\
             length = \"{} mm\"\nmass = \"{} kg\"\n[gas]\ncompression_ratio = 10\n[gas.cycle]\ntype = \"otto\"\n[gas.fuel]\nenergy = \"{} kJ\"\n",
            length(90.0),
            length(86.0),
            0.4 * mass,
            length(80.0),
            length(144.0),
            0.5 * mass,
            1.2 * mass
        )
    };
    for (name, k) in [("small.toml", 1.0), ("large.toml", 1.2)] {
        std::fs::write(folder.join(name), text(k)).expect("the folder is ours");
    }
    for hold in ["speed", "piston-speed"] {
        let arguments = ["compare", "large.toml", "small.toml", "--equal", "displacement", "--hold", hold];
        let json = output_json(&folder, 0, &[&arguments[..], &["--format", "json"]].concat());
        assert!((number(&json, "/engines/1/similar/length") - 1.2).abs() < 1e-12);
        let speed = if hold == "speed" { "5000 rpm" } else { "4166.6666666666667 rpm" };
        let alone = output_json(
            &folder,
            0,
            &["compare", "large.toml", "large.toml", "--speed", speed, "--format", "json"],
        );
        let same = |pointer: &str| {
            let (scaled, built) = (
                number(&json, &format!("/engines/1{pointer}")),
                number(&alone, &format!("/engines/0{pointer}")),
            );
            assert!((scaled - built).abs() < 1e-9 * built.abs(), "{hold} {pointer}: {scaled} {built}");
        };
        for pointer in [
            "/speed",
            "/displacement",
            "/force",
            "/roll_moment",
            "/torque/mean",
            "/torque/most",
            "/torque/excess",
        ] {
            same(pointer);
        }
        if hold == "speed" {
            same("/torque/flywheel");
        }
    }
    // With equal power at equal speed the two are one.
    let json = output_json(
        &folder,
        0,
        &["compare", "large.toml", "small.toml", "--equal", "power", "--format", "json"],
    );
    assert!(
        (number(&json, "/engines/1/torque/power") / number(&json, "/engines/0/torque/power") - 1.0).abs()
            < 1e-9
    );
}

/// Twins beside half a four on two mounts 176 mm apart: the thesis's questions of section 6.1, its numbers of Tables 36 to 39 and of its text.
#[test]
fn lit_twin_thesis_2008_mounts_beside_half_a_four() {
    let folder = folder("compare-mounts");
    let [four, twin, boxer] =
        ["in-line-4-long-stroke", "twin-in-line-in-phase", "twin-boxer-in-phase"].map(example);
    let with = |more: &[&str]| {
        let base =
            ["compare", &twin, &boxer, "--reference", &four, "--share", "1/2", "--arrangements", "1,3"];
        [&base[..], &["--mount-spacing", "176 mm"], more].concat().join("|")
    };
    let run = |more: &[&str]| {
        let line = with(more);
        output_json(&folder, 0, &[&line.split('|').collect::<Vec<_>>()[..], &["--format", "json"]].concat())
    };
    let json = run(&[]);
    assert_eq!(json["engines"].as_array().map(Vec::len), Some(5), "the four stands once");
    let of = |engine: usize, what: &str| number(&json, &format!("/engines/{engine}/{what}"));
    // A force is shared by the mounts; two shafts leave what half a four has (6.1.2.2, Table 37: half of 5793,89 N, truncated series).
    assert!((of(0, "mount_force") - 0.5 * of(0, "force")).abs() < 1e-6 * of(0, "force"));
    assert!((of(2, "force") - 0.5 * of(0, "force")).abs() < 1e-3 * of(0, "force"));
    // A couple becomes two opposite forces over the distance: 726 N m of first order alone were 4126 N.
    assert!((of(3, "mount_force") - of(3, "couple") / 0.176).abs() < 1e-6 * of(3, "mount_force"));
    let line = with(&[]);
    let text = output(&folder, 0, &line.split('|').collect::<Vec<_>>());
    assert!(text.contains("In percent of half of no. 1, in-line four, long stroke"), "{text}");
    // Mounts of a given distance stay there when engines change their size.
    let equal = run(&["--equal", "displacement"]);
    let boxer = |what: &str| number(&equal, &format!("/engines/3/{what}"));
    assert!((boxer("mount_force") - boxer("couple") / 0.176).abs() < 1e-6 * boxer("mount_force"));
}

#[test]
fn mistakes_of_a_comparison_are_told() {
    let folder = folder("compare-mistakes");
    let twin = example("twin-in-line-in-phase");
    let refused = |arguments: &[&str], said: &str| {
        let told = message(&folder, 2, arguments);
        assert!(told.contains(said), "{told}");
    };
    refused(&["compare", &twin], "two or more engines or arrangements, got 1");
    refused(&["compare", &twin, &twin, "--reference", "3"], "the reference is number 3 of 2 engines");
    refused(&["compare", &twin, &twin, "--reference", "0"], "counts the engines from 1");
    refused(&["compare", &twin, "--reference", "nothing.toml"], "nothing.toml");
    refused(&["compare", &twin, &twin, "--share", "0"], "--share needs a share above 0, got 0");
    refused(&["compare", &twin, &twin, "--mount-spacing=0 mm"], "mount spacing must be finite and above 0");
    refused(&["compare", &twin, "--arrangements", "1,10"], "numbers from 1 to 9, got `10`");
    refused(&["compare", &twin, &twin, "--hold", "speed"], "--equal");
    let four = example("in-line-4");
    refused(&["compare", &four, &four, "--fluctuation", "3 %"], "needs an engine with gas");
    let text = std::fs::read_to_string(&twin).expect("it is shipped");
    let bore = text.lines().filter(|line| !line.starts_with("bore")).collect::<Vec<_>>().join("\n");
    std::fs::write(folder.join("bare.toml"), bore).expect("the folder is ours");
    refused(&["compare", &twin, "bare.toml", "--equal", "power"], "needs the bore of every cylinder");
}
