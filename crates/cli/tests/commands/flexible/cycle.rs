//! `stress cycle`, and what other commands take from a mesh: condition E, stiffness of throws, torque of the torsional chain.

use super::{COARSE, engine};
use crate::program::{lanchester, message, number, output, output_json};
use std::fs;

/// Gas, flywheel and bearings for the engine of the other tests.
pub(super) fn complete(text: &str) -> String {
    text.replace("[piston]\n", "[piston]\nbore = \"86 mm\"\n")
        .replace("[layout]\n", "[firing]\norder = [1]\n[layout]\n")
        + r#"
[gas]
compression_ratio = 10
cycle = { type = "otto" }
fuel = { energy = "800 J" }
[flywheel]
inertia = "0.2 kg m2"
[bearings.main]
width = "20 mm"
diametral_clearance = "0.06 mm"
model = "film"
[bearings.crankpin]
width = "20 mm"
diametral_clearance = "0.05 mm"
model = "bushing"
stiffness = "1e9 N/m"
[bearings.film]
viscosity = "10 mPa s"
"#
}

fn words<'a>(rest: &[&'a str]) -> Vec<&'a str> {
    [&["stress", "cycle", "engine.toml", "--modes", "6", "--instants", "48"], rest, &COARSE].concat()
}

#[test]
fn laws_stand_side_by_side_with_every_number() {
    let folder = engine("cycle", complete);
    let rest = ["--bearings", "rigid,film,file", "--figures", "pictures", "--save", "curves.parquet"];
    let text = output(&folder, 0, &words(&rest));
    for part in [
        "crankshaft 1 in its bearings over the cycle",
        "Largest fillet stress over the cycle",
        "Bearings side by side at 4000 rpm",
        "as the file says",
        "rule: cut",
        "Oil films",
        "quasi-static",
        "How the cycles ended",
        "repeats",
        "pin 1 at web 2",
        "bushing, 1.000e9 N/m",
        "film (gumbel), 30.00 um radial clearance, 10.000 mPa s",
        "The pressure of an ideal cycle jumps",
    ] {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
    for picture in ["stress", "orbits", "films", "mains"] {
        let text = fs::read_to_string(folder.join(format!("pictures/cycle-{picture}.svg"))).unwrap();
        assert!(text.contains("<path"), "{picture}");
    }
    assert!(fs::read(folder.join("curves.parquet")).unwrap().starts_with(b"PAR1"));
    let refused = message(&folder, 2, &words(&["--bearings", "rigid", "--save", "curves.parquet"]));
    assert!(refused.contains("not overwritten"), "{refused}");
}

#[test]
fn energies_balance_and_limits_end_with_status_1() {
    let folder = engine("cycle-limits", complete);
    let rest =
        ["--bearings", "film", "--free", "--rigid-crankshaft", "--least-film", "1 mm", "--format", "json"];
    let json = output_json(&folder, 1, &words(&rest));
    for run in [0, 1] {
        assert!(number(&json, &format!("/runs/{run}/energy_error")) <= 1e-4);
        let speeds = json.pointer(&format!("/runs/{run}/speed")).unwrap().as_array().unwrap();
        let of = |k: usize| speeds[k].as_f64().unwrap();
        assert!((0..speeds.len()).any(|k| (of(k) / of(0) - 1.0).abs() > 1e-3), "it swings");
    }
    assert_eq!(json.pointer("/motion").unwrap(), "free");
    let csv = output(&folder, 1, &words(&["--bearings", "rigid", "--safety", "1000", "--format", "csv"]));
    // Four fillets with their stress, Findley's value and two safeties, three quantities of three bearings, energy.
    assert_eq!(csv.lines().count(), 1 + 4 + 12 + 9 + 1, "{csv}");
    // A rough surface leaves half the limit.
    let rough =
        ["--bearings", "rigid", "--surface-factor", "0.5", "--fatigue-safety", "2", "--format", "json"];
    let run = lanchester(&folder, &words(&rough));
    assert_eq!(run.status.code(), Some(1));
    let said = String::from_utf8(run.stderr).unwrap();
    assert!(said.contains("safety against fatigue") && said.contains("(bearings: rigid)"), "{said}");
    assert!(said.contains("at pin 1 at web") && said.contains("wanted is 2"), "{said}");
    let rough: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    let polished = |row: &str| row.split(',').nth(3).unwrap().parse::<f64>().unwrap();
    let polished =
        csv.lines().find(|row| row.contains("pin 1 at web 1,safety of all")).map(polished).unwrap();
    let safety = number(&rough, "/runs/0/fatigue/1/point/safety_of_all");
    assert!((2.0 * safety / polished - 1.0).abs() < 1e-9, "{safety} {polished}");
}

#[test]
fn what_a_cycle_cannot_have_is_refused() {
    let folder = engine("cycle-refused", str::to_owned);
    for (rest, wanted) in [
        (&["--instants", "50"][..], "a multiple of 8"),
        (&["--damping", "2"], "--damping needs a share"),
        (&["--safety", "0"], "--safety needs a number"),
        (&["--fatigue-safety", "0"], "--fatigue-safety needs a number"),
        (&["--gradient-factor", "-1"], "--gradient-factor"),
        (&["--least-film", "1 kg"], "--least-film"),
        (&["--save", "curves.txt"], ".parquet or .csv"),
        (&["--crankshaft", "2"], "crankshaft 2 is needed"),
        (&["--memory", "1 MB"], "allow more memory"),
        (&["--bearings", "rigid", "--free"], "[flywheel]"),
    ] {
        let all = [&["stress", "cycle", "engine.toml"], rest, &COARSE].concat();
        let said = message(&folder, 2, &all);
        assert!(said.contains(wanted) && said.contains("hint:"), "{rest:?}: {said}");
    }
    let bare = engine("cycle-no-film", complete);
    let said = message(&bare, 2, &[&words(&["--bearings", "film"])[..], &["--speed", "0 rpm"]].concat());
    assert!(said.contains("--speed"), "{said}");
}

#[test]
fn the_last_rung_of_the_cross_check() {
    let folder = engine("cycle-crosscheck", complete);
    let text = output(&folder, 0, &["crosscheck", "engine.toml", "--condition", "e"]);
    for part in
        ["Condition E", "flexible crankshaft", "stiffened", "differs as it must", "deflects and vibrates"]
    {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
}

#[test]
fn a_mesh_gives_the_stiffness_of_throws_and_the_chain_the_torque_of_the_rule() {
    let folder = engine("cycle-torsion", complete);
    let json = output_json(
        &folder,
        0,
        &[
            "torsion",
            "engine.toml",
            "--throws",
            "held",
            "--size",
            "20 mm",
            "--speeds",
            "2000 rpm, 4000 rpm",
            "--format",
            "json",
        ],
    );
    let [free, held] = ["free", "held"].map(|kind| number(&json, &format!("/meshed/0/{kind}")));
    // Held journals stiffen; both lie beside Ker Wilson's.
    assert!(held >= free && held < 2.0 * free && free > 1e5, "{free} {held}");
    assert_eq!(json.pointer("/meshed/0/is_held"), Some(&serde_json::Value::Bool(true)));
    let rule = |more: &[&str]| {
        let arguments = ["stress", "rule", "engine.toml", "--format", "json"];
        output_json(&folder, 0, &[&arguments[..], more].concat())
    };
    let (still, moving) = (rule(&["--without-torsion"]), rule(&["--with-torsion"]));
    // What the engine's chain gives counts unless it is left out.
    assert_eq!(rule(&[]).pointer("/speeds"), moving.pointer("/speeds"));
    let of = |json: &serde_json::Value, key: &str| number(json, &format!("/speeds/1/throws/0/{key}"));
    assert_eq!(of(&still, "vibration"), 0.0);
    assert!(of(&moving, "vibration") > 0.0);
    let safety = |json| of(json, "webs/0/journal_fillet/safety");
    assert!(safety(&moving) < safety(&still), "{} {}", safety(&moving), safety(&still));
}
