//! Studies in the studio have the numbers of the facade, in however many turns they come.

use lanchester::file::workshop::read_sheet;
use lanchester::file::{EngineFile, expanded, read, template};
use lanchester::literature::{MatrixMethod, PublishedMethod, SHAFT_DISTANCE};
use lanchester::report::workshop::bobweight_text;
use lanchester::run::{Study, stretch};
use lanchester::study::explore::{ExploreAnswer, ExploreRequest, Explorer, Objective, even_angles};
use lanchester::study::scatter::{ScatterOptions, scatter_study};
use lanchester::workshop::bobweight_answer;
use lanchester::{LayoutChoices, LayoutRows, LayoutStudy, adopted_layout, layout_space};
use lanchester_answers::{Asker, FileState, Files, Problem, Question, Status, Studio, answers};
use serde_json::{Value, json};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

/// No files at all.
struct Nowhere;

impl Files for Nowhere {
    fn place(&self) -> String {
        "nowhere".to_string()
    }

    fn names(&self) -> Vec<String> {
        Vec::new()
    }

    fn open(&self, name: &str) -> Result<FileState, Problem> {
        Err(Problem::new(Status::Refused, format!("no file {name}"), "there are none"))
    }

    fn save(&self, name: &str, _: &str, _: Option<&str>) -> Result<FileState, Problem> {
        self.open(name)
    }

    fn named(&self, name: &str, _: &str) -> Result<String, Problem> {
        Err(Problem::new(Status::Refused, format!("no file {name}"), "there are none"))
    }
}

/// A second between two looks: every turn is as short as a turn can be.
fn clock() -> Duration {
    static SECONDS: AtomicU64 = AtomicU64::new(0);
    Duration::from_secs(SECONDS.fetch_add(1, Ordering::Relaxed))
}

fn ask(path: &str, body: Value) -> (u16, Value) {
    let studio = Studio::new("test".to_string(), Box::new(Nowhere), clock);
    let body = body.to_string();
    let question = Question { method: "POST", path, body: body.as_bytes() };
    let reply = answers().answer(&Asker::new(&studio, &|| true), question);
    (reply.status, serde_json::from_slice(&reply.bytes).expect("replies are JSON"))
}

/// All turns of a study: how many there were, and what was found.
fn turns(path: &str, body: impl Fn(Value) -> Value) -> (usize, Value) {
    let (mut so_far, mut done) = (Value::Null, 0.0);
    for count in 1.. {
        let (status, turn) = ask(path, body(so_far));
        assert_eq!(status, 200, "{turn}");
        let now = turn["done"].as_f64().expect("a share");
        assert!(now > done && now <= 1.0, "{now} after {done}");
        if !turn["found"].is_null() {
            assert_eq!(now, 1.0);
            return (count, turn["found"].clone());
        }
        (so_far, done) = (turn["so_far"].clone(), now);
    }
    unreachable!("every turn goes on")
}

fn gallery(name: &str) -> (String, EngineFile) {
    let text = template(name).expect("it is in the gallery").text.to_string();
    let file = read(&text).file.expect("the gallery has no mistakes");
    (text, file)
}

/// A V6 at two bank angles, its throws every 15 degrees.
fn layouts(file: &EngineFile) -> (Explorer, ExploreAnswer) {
    let choices = LayoutChoices {
        bank_angles: Some(vec![1.0, 1.5]),
        split_angles: Some(vec![0.0, 0.5]),
        throw_angles: Some(even_angles(60)),
        ..LayoutChoices::default()
    };
    let space = layout_space(&file.engine, &choices, &[]).expect("it has cases");
    let objectives = vec![Objective::Force { order: 1 }, Objective::Couple { order: 2 }];
    let request = ExploreRequest::new(space.space, objectives, Vec::new());
    let explorer = Explorer::new(request).expect("it can be searched");
    let study = LayoutStudy { explorer: explorer.clone(), rows: LayoutRows::Nothing };
    let (kept, _) = stretch(&study, 0..study.blocks()).expect("it can be judged");
    let answer = explorer.answer(&kept, &file.engine.name, space.notes).expect("it is of this search");
    (explorer, answer)
}

#[test]
fn a_search_in_turns_finds_the_layouts_of_the_whole_and_one_is_adopted() {
    let (text, file) = gallery("v6-60");
    let (explorer, answer) = layouts(&file);
    let search = json!({
        "text": text, "bank_angles": [1.0, 1.5], "split_angles": [0.0, 0.5], "throw_parts": 60,
        "minimise": ["force order 1", "couple order 2"],
    });
    let (status, size) = ask("/api/explore/size", search.clone());
    assert_eq!((status, size["cases"].as_u64().map(u128::from)), (200, Some(explorer.size())), "{size}");
    assert!(size["seconds"].as_f64().is_some_and(|seconds| seconds > 0.0));
    let (count, found) = turns("/api/explore", |so_far| json!({ "search": search, "so_far": so_far }));
    assert!(count > 1, "one turn has all of it");
    assert_eq!(found["on_front"].as_u64(), Some(answer.front.len() as u64));
    for (own, expected) in found["front"].as_array().expect("a list").iter().zip(&answer.front) {
        assert_eq!(own["case"].as_u64().map(u128::from), Some(expected.layout.case));
        let steps = explorer.steps(&expected.values);
        for ((value, expected), step) in
            own["values"].as_array().expect("a list").iter().zip(&expected.values).zip(steps)
        {
            assert_eq!(value.as_f64(), Some(if step == 0 { 0.0 } else { *expected }));
        }
    }
    let case = answer.front[0].layout.case;
    let (status, adopted) = ask(
        "/api/explore/adopt",
        json!({ "search": search, "case": u64::try_from(case).expect("few cases") }),
    );
    let expected = adopted_layout(&file.engine, &explorer, case).expect("it is an engine");
    assert_eq!((status, adopted["text"].as_str()), (200, Some(expanded(&expected.into()).as_str())));
    // What was kept of another study is not gone on from.
    let torn = json!({ "search": search, "so_far": { "blocks": 4, "kept": "{}" } });
    assert_eq!(ask("/api/explore", torn).0, 400);
}

#[test]
fn a_scatter_in_turns_draws_the_engines_of_the_seed() {
    let (text, _) = gallery("in-line-4");
    let text = format!("{text}\n[tolerances]\nthrow_angle = {{ plus_minus = \"0.25 deg\" }}\n");
    let file = read(&text).file.expect("it has no mistakes");
    let options = ScatterOptions { samples: 100_000, seed: 7, ..ScatterOptions::default() };
    let study = scatter_study(&file.engine, &file.tasks.tolerances, &options).expect("it can be drawn");
    let question = |so_far: Value| json!({ "text": text, "samples": 100_000, "seed": 7, "so_far": so_far });
    let (count, found) = turns("/api/scatter", question);
    assert!(count > 1, "one turn has all of it");
    let expected = serde_json::to_value(&study).expect("it is data");
    assert_eq!(found["study"], expected);
    let (status, none) =
        ask("/api/scatter", json!({ "text": gallery("in-line-4").0, "samples": 10, "seed": 1 }));
    assert_eq!(status, 422);
    assert!(none["hint"].as_str().is_some_and(|hint| hint.contains("[tolerances]")), "{none}");
}

#[test]
fn published_methods_leave_what_they_leave_by_themselves() {
    let (text, file) = gallery("in-line-3");
    let (status, answer) = ask("/api/published", json!({ "text": text }));
    assert_eq!(status, 200, "{answer}");
    let methods = answer["methods"].as_array().expect("a list");
    // Matrix, half rule with its shaft, the share alone, the sweep, and nine arrangements.
    assert_eq!(methods.len(), 13);
    let matrix = PublishedMethod::Matrix(MatrixMethod::usual(&file.engine, SHAFT_DISTANCE));
    let fitted = matrix.fit(&file.engine, &[]).expect("it suits the engine");
    for (load, effect) in ["force", "couple"].into_iter().zip(&fitted.optimum.effects) {
        let own = &methods[0]["left"][load];
        for (key, expected) in [("method", effect.before), ("optimum", effect.after)] {
            let got = own[key].as_f64().expect("a number");
            // Two ways to the same peak: of the loads, and of the optimum's programme.
            assert!(
                (got - expected).abs() <= 1e-6 * expected.max(1.0),
                "{load} {key}: {got}, not {expected}"
            );
        }
    }
}

#[test]
fn a_workshop_sheet_is_answered_as_its_command_prints_it() {
    let (text, file) = gallery("v8-crossplane");
    let sheet = "name = \"V8\"\nengine = \"open\"\n\n[bobweight]\npins = 4\nrods = 2\noil = \"4 g\"\n\n[parts]\nbig_end = \"370 g\"\nsmall_end = \"180 g\"\npiston = \"430 g\"\n";
    let (status, answer) = ask("/api/workshop", json!({ "sheet": sheet, "text": text }));
    assert_eq!(status, 200, "{answer}");
    let read = read_sheet(sheet).sheet.expect("it has no mistakes");
    let expected = bobweight_answer(&read, Some(&file.engine)).expect("it can be worked out");
    assert_eq!(answer["printed"][0]["text"], bobweight_text(&expected));
    assert_eq!(answer["bobweights"]["pins"][3]["mass"].as_f64(), Some(expected.bobweights[3].mass));
    // Without its engine the pins stand for its throws too.
    let nameless = sheet.replace("engine = \"open\"\n", "");
    let (_, same) = ask("/api/workshop", json!({ "sheet": nameless, "text": text }));
    assert_eq!(same["bobweights"], answer["bobweights"]);
    let (status, problem) = ask("/api/workshop", json!({ "sheet": "name = \"x\"\n" }));
    assert_eq!((status, problem["message"].as_str()), (422, Some("the sheet has nothing to work out")));
    assert_eq!(ask("/api/workshop", json!({ "sheet": "[parts]\nbig_end = 3\n" })).0, 422);
}

/// Weights of a three: the file counts from throws, wherever these stand; without `[simulation]` a run starts at the highest speed.
#[test]
fn directions_count_as_the_file_counts_them_and_a_run_starts_where_it_says() {
    let three = template("in-line-3").expect("it is in the gallery").text;
    let (status, read) = ask("/api/engine", json!({ "text": three, "edits": [] }));
    assert_eq!(status, 200, "{read}");
    let weights = read["engine"]["counterweights"].as_array().expect("weights");
    for (index, weight) in weights.iter().enumerate() {
        assert_eq!(weight["from_throw"], json!(index + 1));
        let (direction, half) = (weight["direction"].as_f64().expect("an angle"), std::f64::consts::PI);
        assert!(((direction - half) / (2.0 * half)).fract().abs() < 1e-12, "opposite its throw: {direction}");
    }
    let start = &read["engine"]["run_start"];
    assert_eq!(start["given"]["speed"], read["engine"]["highest_speed"]);
    let told = format!("{three}\n[simulation]\nstart = {{ speed = \"3700 rpm\", angle = \"90 deg\" }}\n");
    let (_, read) = ask("/api/engine", json!({ "text": told, "edits": [] }));
    let given = &read["engine"]["run_start"]["given"];
    let rpm = given["speed"].as_f64().expect("a speed") * 30.0 / std::f64::consts::PI;
    assert!((rpm - 3700.0).abs() < 1e-9, "rounding of the unit: {rpm}");
    let angle = given["angle"].as_f64().expect("an angle");
    assert!((angle - std::f64::consts::FRAC_PI_2).abs() < 1e-12, "rounding of the unit: {angle}");
}

/// Mean piston speed = 2 stroke n: each engine at the speed of its own stroke.
#[test]
fn engines_are_compared_at_one_mean_piston_speed() {
    let text = |stroke: f64| {
        format!(
            "name = \"single\"\nstrokes = 4\nspeed = \"6000 rpm\"\n[layout]\ntype = \"in-line\"\ncylinders = 1\n[crank]\nstroke = \"{stroke} mm\"\n[piston]\nmass = \"0.4 kg\"\n[rod]\nlength = \"150 mm\"\nmass = \"0.5 kg\"\n"
        )
    };
    let engines = json!([{ "name": "short", "text": text(60.0) }, { "name": "long", "text": text(90.0) }]);
    let (status, found) = ask("/api/compare", json!({ "engines": engines, "piston_speed": 15.0 }));
    assert_eq!(status, 200, "{found}");
    for (place, stroke) in [(0, 0.06), (1, 0.09)] {
        let speed = found["engines"][place]["speed"].as_f64().expect("a speed");
        let piston_speed = stroke * speed / std::f64::consts::PI;
        assert!((piston_speed - 15.0).abs() < 1e-9, "rounding: {piston_speed} m/s");
    }
    let (_, found) = ask("/api/compare", json!({ "engines": engines, "speed": 300.0 }));
    for engine in found["engines"].as_array().expect("engines") {
        assert_eq!(engine["speed"], json!(300.0));
    }
    let (status, refused) = ask("/api/compare", json!({ "engines": engines, "piston_speed": 0.0 }));
    assert_eq!(status, 422, "{refused}");
}
