//! The section `[balance]` of an engine file.

use lanchester_file::{EngineFile, Severity, expanded, json_schema, read, render, templates};
use lanchester_model::{Engine, Ratio};
use lanchester_task::{
    BalanceTask, Catalogue, Cost, Criterion, GiveUp, Load, Phase, Place, Seat, Stage, default_task, option,
};
use proptest::prelude::*;
use std::f64::consts::PI;

fn template(name: &str) -> &'static str {
    templates().iter().find(|template| template.name == name).unwrap_or_else(|| panic!("no {name}")).text
}

fn file(text: &str) -> EngineFile {
    let reading = read(text);
    let shown = render(&reading.diagnostics, "engine.toml", text, false);
    let file = reading.file.unwrap_or_else(|| panic!("{shown}"));
    assert!(!reading.diagnostics.iter().any(|d| d.severity == Severity::Error), "{shown}");
    file
}

fn engine(text: &str) -> Engine {
    file(text).engine
}

fn task(base: &str, section: &str) -> BalanceTask {
    let file = file(&format!("{}\n{section}", template(base)));
    let printed = expanded(&file);
    assert_eq!(self::file(&printed), file, "{printed}");
    file.tasks.balance.expect("a task")
}

#[test]
fn an_empty_section_is_the_default_task() {
    for template in templates() {
        let read = file(&format!("{}\n[balance]\n", template.text));
        let plain = file(template.text);
        assert!(plain.tasks.balance.is_none());
        assert_eq!(read.tasks.balance, Some(default_task(&plain.engine)), "{}", template.name);
        assert_eq!(file(&expanded(&read)), read, "{}", template.name);
    }
}

#[test]
fn criteria_with_their_units() {
    let mounts = "[[mount]]\nname = \"front\"\nx = \"0 mm\"\ny = \"0 mm\"\nz = \"-80 mm\"\n";
    let task = task(
        "in-line-3",
        &format!(
            "{mounts}[balance]\nminimise = [\"force\", {{ couple = \"10 N m\", \"roll moment order 1/2\" = \"0.04 kN m\" }}]\n\
             limits = {{ \"mount force front order 2\" = \"0.2 kN\", \"added unbalance\" = \"500 g mm\" }}\n"
        ),
    );
    assert_eq!(task.stages[0].terms, [(1.0, Criterion::Peak(Load::Force))]);
    assert_eq!(
        task.stages[1].terms,
        [(0.1, Criterion::Peak(Load::Couple)), (1.0 / 40.0, Criterion::Order(Load::RollMoment, 0.5))]
    );
    let limits: Vec<_> = task.limits.iter().map(|limit| (limit.criterion, limit.most)).collect();
    assert_eq!(
        limits,
        [(Criterion::Order(Load::MountForce(0), 2.0), 200.0), (Criterion::AddedUnbalance, 5e-4)]
    );
}

#[test]
fn stages_give_up_shares_and_amounts() {
    let of = |section: &str| task("in-line-3", &format!("[balance]\n{section}\n")).give_up;
    // Of the default stages, force and couple.
    assert_eq!(of("give_up = { couple = \"2 N m\" }"), [GiveUp::Nothing, GiveUp::Amount(2.0)]);
    let stages =
        "minimise = [\"couple\", { force = \"1 kN\", \"roll moment\" = \"40 N m\" }, \"bending moment\"]";
    assert_eq!(
        of(&format!("{stages}\ngive_up = {{ \"roll moment\" = \"0.5 %\", couple = \"1 %\" }}")),
        [GiveUp::Share(0.01), GiveUp::Share(0.005)]
    );
    assert_eq!(of(stages), []);
}

#[test]
fn what_stages_give_up_on_a_command_line() {
    let engine = engine(template("in-line-3"));
    let stages = BalanceTask::default().stages_or_default();
    let of = |text: &str, place: usize| option::give_up(text, place, &stages, &engine, "--give-up");
    for (text, place, want) in [
        ("force = 1 %", 1, (0, GiveUp::Share(0.01))),
        ("couple 2 N m", 0, (1, GiveUp::Amount(2.0))),
        ("1 %", 1, (1, GiveUp::Share(0.01))),
        ("5 N", 0, (0, GiveUp::Amount(5.0))),
    ] {
        assert_eq!(of(text, place), Ok(want), "{text}");
    }
    let order = [Stage { terms: vec![(1.0, Criterion::Order(Load::Force, 2.0))] }];
    assert_eq!(
        option::give_up("force order 2 1 %", 0, &order, &engine, "--give-up"),
        Ok((0, GiveUp::Share(0.01)))
    );
    for (text, says) in [
        ("-1 %", "must not be negative"),
        ("force =", "gives up nothing"),
        ("", "needs a stage"),
        ("force = 1", "needs its unit"),
        ("force = 1 kg", "needs a force"),
        ("bending moment = 1 %", "no stage minimises"),
        ("forse = 1 %", "no criterion"),
        ("nan %", "needs"),
    ] {
        let refused = of(text, 0).expect_err(text);
        assert!(refused.message.contains(says) && !refused.hint.is_empty(), "{text}: {refused:?}");
    }
    let third = of("1 %", 2).expect_err("there are two stages");
    assert!(third.message.contains("stage 3, and there are 2"), "{third:?}");
}

#[test]
fn amounts_in_steps_from_lists_and_of_equal_parts() {
    let task = task(
        "in-line-3",
        "[balance]\n\
         [[balance.counterweight]]\nthrow = 1\nradius = \"50 mm\"\nstep = \"5 g\"\nequal_parts = \"end\"\n\
         [[balance.counterweight]]\nthrow = 2\ncatalogue = [\"3000 g mm\", \"0.002 kg m\", \"3 kg mm\"]\n\
         [[balance.counterweight]]\nthrow = 3\nradius = \"50 mm\"\nstep = \"250 g mm\"\nequal_parts = \"end\"\nmost = \"0.02 kg m\"\n",
    );
    let [first, second, third] = &task.weights[..] else { panic!("{task:?}") };
    let Some(Catalogue::Steps(step)) = first.catalogue else { panic!("{first:?}") };
    assert!((step - 0.25e-3).abs() < 1e-18 && first.most.is_none());
    // Sorted, each once; its end is the largest amount.
    assert_eq!(second.catalogue, Some(Catalogue::Amounts(vec![0.002, 0.003])));
    assert_eq!(second.most, Some(0.003));
    assert_eq!((first.equal_parts.as_deref(), third.equal_parts.as_deref()), (Some("end"), Some("end")));
    assert_eq!(third.most, Some(0.02));
    // Numbers of amounts, with rounding and ends.
    let steps = Catalogue::Steps(0.1);
    assert_eq!(
        [steps.below(0.3), steps.below(0.299_999), steps.nearest(0.26), steps.nearest(0.24)],
        [3, 2, 3, 2]
    );
    let list = Catalogue::Amounts(vec![1.0, 4.0]);
    assert_eq!(
        [list.below(0.5), list.below(1e9), list.nearest(0.6), list.nearest(9.0), list.last()],
        [0, 2, 1, 2, 2]
    );
    assert_eq!((list.largest(), steps.largest(), list.amount(0)), (Some(4.0), None, 0.0));
}

#[test]
fn costs_and_a_budget() {
    let task = task(
        "in-line-3",
        "[balance]\nminimise = [\"couple\", \"cost\"]\nbudget = 12.5\nlimits = { force = \"10 N\" }\n\
         [[balance.counterweight]]\nthrow = 1\nradius = \"50 mm\"\nfixed_cost = 2\ncost_per_kg = 10\nmost = \"0.02 kg m\"\n\
         [[balance.shaft]]\nratio = -1\ny = \"100 mm\"\nfixed_cost = 7\nweights = [{ z = \"0 mm\", cost_per_kg_m = 30, most = \"0.02 kg m\" }]\n",
    );
    assert_eq!(task.weights[0].cost, Cost { fixed: 2.0, per_amount: 10.0 / 0.05 });
    assert_eq!(task.weights[1].cost, Cost { fixed: 0.0, per_amount: 30.0 });
    assert_eq!((task.shaft_cost(0), task.shaft_cost(1)), (7.0, 0.0));
    assert!(
        task.asks_for_cost() && task.pays_for_weight(0) && !task.pays_for_weight(1) && task.pays_for_shaft(0)
    );
    assert_eq!(
        task.limits.iter().filter(|l| l.criterion == Criterion::Cost).map(|l| l.most).sum::<f64>(),
        12.5
    );
    assert_eq!(task.stages[1].terms, [(1.0, Criterion::Cost)]);
    let refused = |text: &str| option::budget(text, "--budget").expect_err(text);
    for text in ["-1", "nan", "3 N", "", "inf"] {
        assert!(refused(text).message.contains("--budget"), "{text}");
    }
    assert_eq!(option::budget(" 40 ", "--budget").map(|limit| limit.most), Ok(40.0));
    let engine = engine(template("in-line-3"));
    assert!(
        option::limit("cost = 40", &engine, "--limit")
            .expect_err("it has no unit")
            .hint
            .contains("budget = 40")
    );
}

#[test]
fn orders_that_must_vanish() {
    let mounts = "[[mount]]\nname = \"front\"\nx = \"0 mm\"\ny = \"0 mm\"\nz = \"-80 mm\"\n";
    let section =
        "[balance]\ncancel = [\"force order 1\", \"roll moment order 1/2\", \"mount force front order 2\"]\n";
    let task = task("in-line-3", &format!("{mounts}{section}"));
    assert_eq!(task.cancel, [(Load::Force, 1.0), (Load::RollMoment, 0.5), (Load::MountForce(0), 2.0)]);
    assert!(task.stages.is_empty() && task.limits.is_empty());
}

#[test]
fn weights_on_throws_webs_and_anywhere() {
    let base = engine(template("in-line-3"));
    let task = task(
        "in-line-3",
        r#"
[balance]
most_optional = 1
[[balance.counterweight]]
throw = 2
angle = "180 deg"
most = "0.02 kg m"
radius = "60 mm"
[[balance.counterweight]]
web = 6
line = "10 deg"
[[balance.counterweight]]
z = ["-150 mm", "-100 mm"]
least = "1e4 g mm"
most = "0.05 kg m"
optional = true
[[balance.counterweight]]
name = "flywheel"
z = "120 mm"
angle = "30 deg"
unbalance = "12 g cm"
"#,
    );
    let names: Vec<&str> = task.weights.iter().map(|weight| weight.name.as_str()).collect();
    assert_eq!(names, ["throw 2", "web 6", "free weight 3", "flywheel"]);
    assert!(task.weights.iter().all(|weight| weight.seat == Seat::Crankshaft(0)));
    let [throw, web, between, flywheel] = task.weights.as_slice() else { panic!("four weights") };
    let Phase::Direction(phase) = throw.phase else { panic!("a direction") };
    assert!((phase - (base.throws[1].angle + PI).rem_euclid(2.0 * PI)).abs() < 1e-12);
    assert_eq!((throw.z, throw.most, throw.radius), (Place::At(base.throws[1].z), Some(0.02), Some(0.06)));
    assert_eq!(web.z, Place::At(base.throws[2].webs.expect("webs")[1]));
    assert!(matches!(web.phase, Phase::Line(_)));
    assert_eq!((between.least, between.most, between.optional), (0.01, Some(0.05), true));
    assert!(matches!(between.z, Place::Between(first, last) if first < last));
    assert_eq!((flywheel.least, flywheel.most), (0.00012, Some(0.00012)));
    assert_eq!(flywheel.phase, Phase::Direction(30_f64.to_radians()));
    assert_eq!(task.most_optional, Some(1));
}

#[test]
fn one_entry_for_every_throw_or_web() {
    let webs =
        task("in-line-3", "[balance]\n[[balance.counterweight]]\nwebs = \"all\"\nmost = \"0.1 kg m\"\n");
    assert_eq!(webs.weights.len(), 6);
    assert_eq!((webs.weights[5].name.as_str(), webs.weights[5].most), ("web 6", Some(0.1)));
    let throws = task(
        "in-line-3",
        "[balance]\n[[balance.counterweight]]\nname = \"cheek\"\nthrows = \"all\"\nangle = \"180 deg\"\n",
    );
    let names: Vec<&str> = throws.weights.iter().map(|weight| weight.name.as_str()).collect();
    assert_eq!(names, ["cheek 1", "cheek 2", "cheek 3"]);
    let base = engine(template("in-line-3"));
    for (weight, throw) in throws.weights.iter().zip(&base.throws) {
        let Phase::Direction(phase) = weight.phase else { panic!("a direction") };
        assert!(((phase - throw.angle - PI).sin()).abs() < 1e-12, "each counts from its own throw");
    }
}

#[test]
fn shafts_inertias_and_ties() {
    let task = task(
        "in-line-4",
        r#"
[balance]
[[balance.shaft]]
name = "lower"
ratio = 2
x = ["-80 mm", "80 mm"]
y = "100 mm"
optional = true
weights = [
    { z = "-20 mm", most = "0.02 kg m", phase = "90 deg" },
    { z = "20 mm", equal_to = "lower 1", factor = 0.5 },
]
[[balance.shaft]]
ratio = "-2"
y = "-100 mm"
[[balance.shaft.weights]]
name = "upper"
z = "0 mm"
mirrored_to = "lower 1"
factor = -1.0
[[balance.shaft.weights]]
z = "10 mm"
opposed_to = "lower 1"
[[balance.inertia]]
ratio = 2.5
crank_inertia = "0.2 kg m2"
most = "20000 kg mm2"
optional = true
"#,
    );
    assert_eq!(task.shafts[0].x, Place::Between(-0.08, 0.08));
    assert!(task.shafts[0].optional && !task.shafts[1].optional);
    assert_eq!(
        (task.shafts[1].name.as_str(), task.shafts[1].ratio),
        ("free shaft 2", Ratio::whole(-2).expect("no 0"))
    );
    let names: Vec<&str> = task.weights.iter().map(|weight| weight.name.as_str()).collect();
    assert_eq!(names, ["lower 1", "lower 2", "upper", "free shaft 2 2"]);
    let ties: Vec<_> =
        task.ties.iter().map(|tie| (tie.first, tie.second, tie.factor, tie.mirrored)).collect();
    assert_eq!(ties, [(0, 1, 0.5, false), (0, 2, -1.0, true), (0, 3, -1.0, false)]);
    let most: Vec<_> = task.weights.iter().map(|weight| weight.most).collect();
    assert_eq!(most, [Some(0.02), Some(0.01), Some(0.02), Some(0.02)]);
    assert_eq!((task.inertias[0].ratio, task.inertias[0].crank_inertia), (2.5, 0.2));
}

#[test]
fn on_a_geared_crankshaft_angles_count_from_its_own_zero() {
    let task = task(
        "opposed-piston-3",
        r#"
[balance]
[[balance.counterweight]]
z = "0 mm"
crankshaft = 2
angle = "100 deg"
[[balance.counterweight]]
throw = 4
line = "7.123456789 deg"
"#,
    );
    let base = engine(template("opposed-piston-3"));
    let second = &base.crankshafts[1];
    assert!(second.phase != 0.0, "the second crankshaft of this engine is turned");
    assert_eq!(task.weights[0].seat, Seat::Crankshaft(1));
    let Phase::Direction(phase) = task.weights[0].phase else { panic!("a direction") };
    assert!((phase - second.phase - 100_f64.to_radians()).sin().abs() < 1e-12);
    let throw = &base.throws[3];
    assert_eq!(task.weights[1].seat, Seat::Crankshaft(throw.crankshaft));
    let Phase::Line(phase) = task.weights[1].phase else { panic!("a line") };
    let zero = base.crankshafts[throw.crankshaft].phase + throw.angle;
    assert!((phase - zero - 7.123456789_f64.to_radians()).sin().abs() < 1e-12);
}

#[test]
fn places_count_from_the_origin_of_the_file() {
    let text = template("in-line-3").replacen("strokes = 4", "strokes = 4\norigin = \"25 mm\"", 1);
    assert!(text.contains("origin"));
    let section = "[balance]\n[[balance.counterweight]]\nz = \"25 mm\"\n[[balance.shaft]]\nratio = -1\ny = \"200 mm\"\n\
                   weights = [{ z = [\"0 mm\", \"50 mm\"], most = \"1 kg m\" }]\n";
    let task = file(&format!("{text}\n{section}")).tasks.balance.expect("a task");
    assert_eq!((task.weights[0].z, task.weights[1].z), (Place::At(0.0), Place::Between(-0.025, 0.025)));
}

#[test]
fn the_schema_knows_the_section() {
    let schema = jsonschema::draft202012::new(&json_schema()).expect("the schema is a schema");
    let file =
        |balance: serde_json::Value| serde_json::json!({ "name": "x", "speed": "1 rpm", "balance": balance });
    let good = serde_json::json!({
        "minimise": ["force", { "couple": "10 N m" }],
        "limits": { "force order 1": "200 N", "added mass": "2 kg" },
        "cancel": ["force order 1"],
        "counterweight": [{ "webs": "all", "z": ["0 mm", "1 mm"], "optional": true, "factor": -0.5 }],
        "inertia": [{ "ratio": 2.5, "crank_inertia": "0.2 kg m2" }],
    });
    assert!(schema.is_valid(&file(good)));
    for bad in [
        serde_json::json!({ "minimise": [] }),
        serde_json::json!({ "minimise": [1] }),
        serde_json::json!({ "cancel": [] }),
        serde_json::json!({ "cancel": [{ "force order 1": "1 N" }] }),
        serde_json::json!({ "limits": { "couple": 5 } }),
        serde_json::json!({ "limits": { "couple": "5 mm" } }),
        serde_json::json!({ "counterweight": [{ "webs": 1 }] }),
        serde_json::json!({ "counterweight": [{ "web": 1, "optional": "yes" }] }),
        serde_json::json!({ "inertia": [{ "ratio": 0, "crank_inertia": "0.2 kg m2" }] }),
    ] {
        assert!(!schema.is_valid(&file(bad.clone())), "{bad}");
    }
}

/// Every key of the section once, on an engine with mounts and two crankshafts.
const EVERYTHING: &str = r#"
[[mount]]
name = "front"
x = "0 mm"
y = "0 mm"
z = "-88 mm"
[balance]
minimise = ["force", { couple = "10 N m", "mount force front order 1/2" = "40 N" }, "mount force"]
limits = { "roll moment" = "5 N m", "added mass" = "2 kg" }
most_optional = 2
[[balance.counterweight]]
name = "front"
throw = 4
angle = "181 deg"
least = "0.01 kg m"
most = "0.1 kg m"
radius = "60 mm"
[[balance.counterweight]]
z = ["-50 mm", "40 mm"]
crankshaft = 2
line = "17 deg"
most = "0.1 lb in"
optional = true
radius = "6 cm"
[[balance.counterweight]]
z = "55 mm"
crankshaft = 2
mirrored_to = "front"
factor = -0.75
radius = "6 cm"
[[balance.shaft]]
name = "lower"
ratio = "-1/2"
x = ["180 mm", "190 mm"]
y = "1000 mm"
optional = true
[[balance.shaft.weights]]
z = "0 mm"
phase = "10 deg"
unbalance = "100 g mm"
radius = "10 mm"
[[balance.shaft.weights]]
z = "20 mm"
opposed_to = "lower 1"
radius = "10 mm"
[[balance.inertia]]
ratio = 2.5
crank_inertia = "0.2 kg m2"
most = "0.1 kg m2"
"#;

#[test]
fn everything_at_once() {
    let task = task("opposed-piston-3", EVERYTHING);
    assert_eq!((task.weights.len(), task.ties.len(), task.limits.len()), (5, 2, 2));
}

proptest! {
    #[test]
    fn prop_mutated_sections_are_survived(
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>(), 0..6, "[ -~é]{0,8}"), 1..4),
    ) {
        let mut lines: Vec<String> = EVERYTHING.lines().map(str::to_string).collect();
        for (one, other, kind, rubbish) in edits {
            let (one, other) = (one.index(lines.len()), other.index(lines.len()));
            match kind {
                0 => lines.swap(one, other),
                1 => drop(lines.remove(one)),
                2 => lines.insert(one, lines[other].clone()),
                3 => lines[one] = rubbish,
                _ => {
                    let value = lines[other].split_once('=').map_or(String::new(), |(_, value)| value.to_string());
                    if let Some((key, _)) = lines[one].clone().split_once('=') {
                        lines[one] = format!("{key}={value}");
                    }
                }
            }
        }
        let text = format!("{}{}", template("opposed-piston-3"), lines.join("\n"));
        let reading = read(&text);
        let has_error = reading.diagnostics.iter().any(|d| d.severity == Severity::Error);
        prop_assert_eq!(reading.file.is_none(), has_error);
        render(&reading.diagnostics, "e.toml", &text, true);
        if let Some(file) = reading.file {
            let printed = expanded(&file);
            prop_assert_eq!(read(&printed).file, Some(file), "{}", printed);
        }
    }
}

const DRILLED: &str = "[balance]\n\
     [[balance.counterweight]]\nthrow = 1\nangle = \"0 deg\"\n\
     drill = { direction = \"radial\", radius = \"70 mm\", diameters = [\"12 mm\", \"10 mm\"], max_depth = \"30 mm\", density = \"7.85 g/cm3\" }\n\
     [[balance.counterweight]]\nthrow = 2\nangle = \"180 deg\"\nradius = \"60 mm\"\n\
     drill = { direction = \"axial\", radius = \"60 mm\", max_depth = \"20 mm\", depth_step = \"5 mm\", density = \"7.85 g/cm3\", slug_density = \"18 g/cm3\" }\n";

#[test]
fn holes_and_slugs_are_catalogues() {
    let task = task("in-line-3", DRILLED);
    let [hole, slug] = &task.weights[..] else { panic!("{task:?}") };
    let drill = hole.drill.as_ref().expect("drills");
    assert_eq!(drill.diameters, [0.01, 0.012]);
    // By hand: 12 mm drill of 118 deg, 20 mm deep at 70 mm; point a/tan(59 deg).
    let (a, h, r) = (0.006f64, 0.02, 0.07);
    let c = a / 59f64.to_radians().tan();
    let lever = r * h - h * h / 2.0 - a * a / 8.0 + c / 3.0 * (r - h - c / 4.0);
    let want = 7850.0 * PI * a * a * lever;
    let found = drill.hole(want).expect("it is among them");
    assert!((found.diameter - 0.012).abs() < 1e-15 && (found.depth - h).abs() < 1e-12, "{found:?}");
    assert!((found.unbalance / want - 1.0).abs() < 1e-12 && (found.tip - h - c).abs() < 1e-12);
    // What an empty hole on the throw's side takes away is a weight opposite to the throw; a slug is one where it sits.
    assert!(matches!(hole.phase, Phase::Direction(angle) if (angle - PI).abs() < 1e-12));
    let (Phase::Direction(slugs), Some(slug_drill)) = (slug.phase, &slug.drill) else { panic!("{slug:?}") };
    let throw = engine(template("in-line-3")).throws[1].angle;
    assert!((slugs - throw - PI).sin().abs() < 1e-12 && (slugs - throw).cos() < 0.0, "{slugs}");
    assert_eq!((slug_drill.diameters.len(), slug_drill.slug_density), (39, Some(18_000.0)));
    let (a, h) = (0.01f64, 0.015);
    let c = a / 59f64.to_radians().tan();
    assert!(h + c > 0.02, "the tip of the largest drill would pass the depth");
    for drill in [drill, slug_drill] {
        assert!(drill.holes().iter().all(|hole| hole.tip <= drill.max_depth + 1e-12));
    }
    for weight in [hole, slug] {
        let holes = weight.drill.as_ref().expect("drills").holes();
        let amounts = holes.iter().map(|hole| hole.unbalance).collect();
        assert_eq!(weight.catalogue, Some(Catalogue::Amounts(amounts)));
        assert_eq!(weight.most, holes.last().map(|hole| hole.unbalance));
    }
}

#[test]
fn holes_that_cannot_be_are_refused() {
    let all = "direction = \"radial\", radius = \"70 mm\", max_depth = \"30 mm\", density = \"7.85 g/cm3\"";
    for (more, drill, code) in [
        ("step = \"5 g\"", all.to_owned(), "E0203"),
        ("radius = \"60 mm\"", all.to_owned(), "E0204"),
        ("", all.replace("30 mm", "0.1 mm"), "E0305"),
        ("", format!("{all}, slug_density = \"2.7 g/cm3\""), "E0305"),
        ("", format!("{all}, point = \"200 deg\""), "E0108"),
        ("", format!("{all}, diameters = []"), "E0206"),
        ("", format!("{all}, depth_step = \"1 um\""), "E0004"),
        ("", all.replace("direction = \"radial\", ", ""), "E0202"),
        ("least = \"1 kg m\"", all.to_owned(), "E0305"),
    ] {
        let section =
            format!("[balance]\n[[balance.counterweight]]\nthrow = 1\n{more}\ndrill = {{ {drill} }}\n");
        let told = read(&format!("{}\n{section}", template("in-line-3"))).diagnostics;
        let own = told.iter().find(|one| one.code == code);
        let own = own.unwrap_or_else(|| panic!("{more} {drill}: {told:?}"));
        assert!(own.hint.as_ref().is_some_and(|hint| !hint.is_empty()), "{own:?}");
    }
}
