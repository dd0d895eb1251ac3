//! `simulate`: state at the start, events and points of the command, Parquet, teeth, crankshafts as bodies, tolerances by kind of state, dead time.

use crate::program::{changed_example, lanchester, message, number, output, output_json, same};
use lanchester::table::{Bytes, Column, TableReader, Values};

/// A column of a CSV text by its head.
fn column(csv: &str, head: &str) -> Vec<f64> {
    let mut lines = csv.lines();
    let heads: Vec<&str> = lines.next().unwrap().split(',').collect();
    let place =
        heads.iter().position(|own| *own == head).unwrap_or_else(|| panic!("{head} is none of {heads:?}"));
    lines.map(|line| line.split(',').nth(place).unwrap().parse().unwrap()).collect()
}

#[test]
fn a_run_starts_where_the_command_says() {
    let folder = changed_example("simulate-from", "generator-set-3.toml", same);
    let of = |more: &[&str]| {
        let run = ["simulate", "engine.toml", "--imposed", "--inertia-only", "--for", "0.5 revolutions"];
        output(&folder, 0, &[&run[..], &["--step", "10 deg", "--format", "csv"], more].concat())
    };
    let csv = of(&["--start", "90 deg, 1200 rpm, as drawn"]);
    assert_eq!(column(&csv, "theta [deg]")[0], 90.0);
    assert!((column(&csv, "speed [rad/s]")[0] / (1200.0 * std::f64::consts::PI / 30.0) - 1.0).abs() < 1e-12);
    assert_eq!(column(&csv, "position_x [m]")[0], 0.0);
    let settled = of(&["--start", "1200 rpm, equilibrium"]);
    assert!(column(&settled, "position_x [m]")[0].abs() > 1e-5);
    for (start, words) in [("soon", "crank angle"), ("90 deg, 45 deg", "twice"), ("-5 rpm", "0 or more")] {
        let told = message(&folder, 2, &["simulate", "engine.toml", "--start", start]);
        assert!(told.contains(words) && told.contains("hint"), "{start}: {told}");
    }
    // From rest, cranked by the starter.
    for rest in [["--start", "0 rpm"], ["--speed", "0 rpm"]] {
        let run = ["simulate", "engine.toml", "--for", "0.3 s", "--format", "csv"];
        let speeds = column(&output(&folder, 0, &[&run[..], &rest[..]].concat()), "speed [rad/s]");
        assert!(speeds[0] == 0.0 && *speeds.last().unwrap() > 5.0, "{rest:?}");
    }
    let told = message(&folder, 2, &["simulate", "engine.toml", "--start", "800 rpm", "--speed", "900 rpm"]);
    assert!(told.contains("both"), "{told}");
}

#[test]
fn events_of_the_command_come_besides_those_of_the_file() {
    let folder = changed_example("simulate-events", "in-line-4.toml", |text| {
        format!("{text}\n[flywheel]\ninertia = \"0.2 kg m2\"\n")
    });
    let events = ["--event", "1 revolutions: load 3 N m", "--event", "540 deg: stop"];
    let csv = output(
        &folder,
        0,
        &[&["simulate", "engine.toml", "--format", "csv", "--table", "events"], &events[..]].concat(),
    );
    assert_eq!(
        column(&csv, "crank angle [deg]").iter().map(|angle| angle.round()).collect::<Vec<_>>(),
        [360.0, 540.0]
    );
    for (event, words) in [
        ("stop", "a moment and what happens"),
        ("soon: stop", "no moment"),
        ("1 s: explode", "nothing that can happen"),
        ("1 s: misfire 9", "no cylinder 9"),
    ] {
        let told = message(&folder, 2, &["simulate", "engine.toml", "--event", event]);
        assert!(told.contains(words) && told.contains("hint"), "{event}: {told}");
    }
}

/// The displacement of a point is that of the origin and the turn, from the columns of the same file.
#[test]
fn points_of_the_block_move_with_it() {
    let point = "[simulation]\npoint = [{ name = \"head\", x = \"350 mm\", y = \"20 mm\" }]";
    let folder = changed_example("simulate-points", "generator-set-3.toml", |text| {
        text.replace("[simulation]", point)
    });
    let run = ["simulate", "engine.toml", "--imposed", "--inertia-only", "--speed", "1500 rpm", "--for"];
    let run = [&run[..], &["2 revolutions", "--step", "10 deg", "--point", "0 mm, 100 mm, -200 mm"]].concat();
    let text = output(&folder, 0, &run);
    assert!(text.contains("Points of the block in the last period") && text.contains("head"), "{text}");
    let csv = output(&folder, 0, &[&run[..], &["--format", "csv"]].concat());
    let origin: Vec<Vec<f64>> =
        ["x", "y", "z"].map(|axis| column(&csv, &format!("position_{axis} [m]"))).into();
    let turn: Vec<Vec<f64>> =
        ["w", "x", "y", "z"].map(|part| column(&csv, &format!("quaternion_{part}"))).into();
    let head: Vec<Vec<f64>> =
        ["x", "y", "z"].map(|axis| column(&csv, &format!("head displacement_{axis} [m]"))).into();
    let at = [0.35, 0.02, 0.0];
    let mut largest = 0.0f64;
    for k in 0..origin[0].len() {
        let [w, x, y, z] = [0, 1, 2, 3].map(|part| turn[part][k]);
        // p' = p + 2 w (q x p) + 2 q x (q x p)
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let once = cross([x, y, z], at);
        let again = cross([x, y, z], once);
        for axis in 0..3 {
            let wanted = origin[axis][k] + 2.0 * w * once[axis] + 2.0 * again[axis];
            assert!((head[axis][k] - wanted).abs() < 1e-12, "{} {wanted}", head[axis][k]);
            largest = largest.max((head[axis][k] - origin[axis][k]).abs());
        }
    }
    assert!(largest > 1e-6, "the turn counts: {largest}");
}

#[test]
fn parquet_holds_what_csv_holds() {
    let folder = changed_example("simulate-parquet", "in-line-4.toml", same);
    let run = ["simulate", "engine.toml", "--imposed", "--for", "4 revolutions", "--step", "10 deg"];
    for table in ["trace", "reactions", "orders", "energy"] {
        let csv = output(&folder, 0, &[&run[..], &["--format", "csv", "--table", table]].concat());
        let bytes =
            lanchester(&folder, &[&run[..], &["--format", "parquet", "--table", table]].concat()).stdout;
        let heads: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
        let columns: Vec<Column> = heads
            .iter()
            .map(|head| {
                let name = head.split(|one: char| !one.is_alphanumeric()).filter(|part| !part.is_empty());
                let name = name.collect::<Vec<_>>().join("_");
                if *head == "part" { Column::text(name) } else { Column::real(name) }
            })
            .collect();
        let mut reader = TableReader::open(Bytes::from(bytes)).expect("it is a table");
        let rows = reader.next(&columns).expect("it has these columns").expect("it has rows");
        assert_eq!(rows.len(), csv.lines().count() - 1, "{table}");
        for (head, values) in heads.iter().zip(rows.columns()) {
            if let Values::Real(values) = values {
                assert_eq!(values, &column(&csv, head), "{table}: {head}");
            }
        }
    }
}

/// Teeth of a shaft against the crank: their force is in the table, and it loads the bearings.
#[test]
fn teeth_load_the_bearings() {
    let mesh = |words: &str| {
        let words = words.to_owned();
        move |text: String| format!("{text}\n[simulation]\nmesh = [{{ {words} }}]\n")
    };
    let good = "shaft = \"against the crank\", pressure_angle = \"20 deg\", z = \"-170 mm\"";
    let folder = changed_example("simulate-teeth", "in-line-4-shafts.toml", mesh(good));
    let run = ["simulate", "engine.toml", "--imposed", "--for", "1 revolutions", "--step", "10 deg"];
    let text = output(&folder, 0, &run);
    assert!(text.contains("Gears and shafts in the last period"), "{text}");
    let csv = output(&folder, 0, &[&run[..], &["--format", "csv", "--table", "reactions"]].concat());
    let of = |what: &str| column(&csv, &format!("against the crank {what}"));
    let (torque, x, y) = (of("gear_torque [N m]"), of("gear_force_x [N]"), of("gear_force_y [N]"));
    // The axes are 87.46 mm apart, and the shaft turns twice as fast: a third of that is its pitch radius.
    let pitch = 0.075f64.hypot(0.045) / 3.0;
    for k in 0..torque.len() {
        let wanted = torque[k].abs() / (pitch * 20.0f64.to_radians().cos());
        assert!((x[k].hypot(y[k]) - wanted).abs() < 1e-9 * wanted.max(1.0), "{} {wanted}", x[k].hypot(y[k]));
    }
    for (words, told) in [
        ("shaft = \"nobody\", pressure_angle = \"20 deg\", z = \"0 mm\"", "no driven shaft has this name"),
        ("shaft = \"with the crank\", pressure_angle = \"20 deg\", z = \"0 mm\"", "opposite senses"),
    ] {
        let folder = changed_example("simulate-no-teeth", "in-line-4-shafts.toml", mesh(words));
        let said = message(&folder, 2, &run);
        assert!(said.contains(told), "{said}");
    }
}

/// A crankshaft that is a body: what it says beside its unbalances is told, and taken where asked for.
#[test]
fn a_crankshaft_turns_as_a_body() {
    let run = ["simulate", "engine.toml", "--imposed", "--for", "1 revolutions", "--step", "10 deg"];
    let plain = changed_example("simulate-unbalances", "in-line-3-counterweights.toml", same);
    let asked = |text: String| format!("{text}\n[simulation]\ncrankshaft = \"body\"\n");
    let body = changed_example("simulate-body", "in-line-3-counterweights.toml", asked);
    let [without, with] = [&plain, &body].map(|folder| output(folder, 0, &run));
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words(&without).contains("The run takes unbalances and polar inertia"), "{without}");
    assert!(words(&with).contains("The run takes those of the body."), "{with}");
    let none = changed_example("simulate-no-body", "in-line-4.toml", asked);
    assert!(message(&none, 2, &run).contains("cannot turn as a body"));
}

#[test]
fn tolerances_and_dead_time_reach_the_run() {
    let folder = changed_example("simulate-dead-time", "generator-set-3.toml", |text| {
        text.replace("lag = \"30 ms\"", "delay = \"30 ms\"\nlag = \"10 ms\"")
            .replace("duration = \"24 s\"", "duration = \"0.5 s\"\ntolerances = { velocity = \"0.01 mm/s\" }")
            .replace("speed = \"0 rpm\"", "speed = \"1490 rpm\"")
    });
    let found = output_json(&folder, 0, &["simulate", "engine.toml", "--format", "json"]);
    assert_eq!(found["run"]["tolerances"]["velocity"], 1e-5);
    let factors = found["run"]["samples"]["governor"].as_array().unwrap();
    assert_eq!(factors.len(), found["run"]["samples"]["time"].as_array().unwrap().len());
}

/// The largest values are those of the whole run: after a start they are not those of its last period, and text, JSON and trace agree on them.
#[test]
fn the_start_has_the_largest_values() {
    let folder = changed_example("simulate-extremes", "generator-set-3.toml", same);
    let arguments = ["simulate", "engine.toml", "--for", "3 s"];
    let json = output_json(&folder, 0, &[&arguments[..], &["--format", "json"]].concat());
    let csv = output(&folder, 0, &[&arguments[..], &["--format", "csv"]].concat());
    let [time, x, y, z] =
        ["time [s]", "front left force_x [N]", "front left force_y [N]", "front left force_z [N]"]
            .map(|head| column(&csv, head));
    let sizes = (0..time.len()).map(|k| (x[k] * x[k] + y[k] * y[k] + z[k] * z[k]).sqrt());
    let (at, sampled) = sizes.enumerate().fold((0, 0.0), |best, own| if own.1 > best.1 { own } else { best });
    let of = |pointer: &str| number(&json, pointer);
    let largest = of("/run/extremes/mounts/0/value");
    // Samples four degrees apart come within a thousandth of it, and never above.
    assert!(largest >= sampled && largest < 1.001 * sampled, "{largest} {sampled}");
    assert!((of("/run/extremes/mounts/0/time") - time[at]).abs() < 2e-3 && (0.3..0.5).contains(&time[at]));
    assert!(largest > 1.3 * of("/period/extremes/mounts/0/value"));
    assert!(json["period"]["is_whole"].as_bool().unwrap());
    let names: Vec<&str> = json["period"]["statistics"]
        .as_array()
        .unwrap()
        .iter()
        .filter_map(|own| own["name"].as_str())
        .collect();
    assert!(names.contains(&"speed") && names.contains(&"force of mount front left"), "{names:?}");
    let text = output(&folder, 0, &arguments);
    let line = text.lines().find(|line| line.contains("force of mount front left")).expect("it is listed");
    assert!(line.contains("1067"), "{line}");
}

/// What the driveline does stands in the text, in the trace and in a figure.
#[test]
fn the_driveline_is_told() {
    let folder = changed_example("simulate-driveline", "generator-set-3.toml", |text| {
        let own = "\n[[driveline]]\ninertia = \"0.3 kg m2\"\nstiffness = \"4000 N m/rad\"\ndamping = \"2 N m s/rad\"\n";
        text.replace("speed = \"0 rpm\"", "speed = \"1500 rpm\"") + own
    });
    let arguments = [
        "simulate",
        "engine.toml",
        "--for",
        "0.5 s",
        "--event",
        "0.3 s: clutch open",
        "--figures",
        "figures",
    ];
    let text = output(&folder, 0, &arguments);
    for words in [
        "Driveline in the last period",
        "twist that the opening clutch lets go",
        "torque of driveline spring 1",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(folder.join("figures/simulated-driveline.svg").exists());
    let csv = output(&folder, 0, &[&arguments[..6], &["--format", "csv"]].concat());
    let [twist, torque, speed] = ["twist [rad]", "torque [N m]", "speed [rad/s]"]
        .map(|head| column(&csv, &format!("driveline 1 {head}")));
    assert!(twist.iter().any(|own| own.abs() > 1e-4) && torque.iter().any(|own| own.abs() > 1.0));
    assert_eq!((*twist.last().unwrap(), *torque.last().unwrap()), (0.0, 0.0), "the clutch is open");
    assert!(speed.iter().all(|own| *own > 100.0));
}
