//! A production as a long run: the same table and the same statistics whatever happens on the way.

use crate::long_runs::runs::{bytes, kill_twice};
use crate::program::{example, folder, lanchester, message, number, output, output_json};
use lanchester::table::{TableReader, Values};
use serde_json::Value;
use std::fs::{self, File};
use std::path::Path;

/// A production of so many engines into a table.
fn production<'a>(file: &'a str, samples: &'a str, table: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["scatter", file, "--samples", samples, "--save", table][..], more].concat()
}

/// An example with tolerances, in the folder.
fn tolerant(folder: &Path, name: &str, tolerances: &str) -> String {
    let text = fs::read_to_string(example(name)).unwrap();
    let file = format!("{name}.toml");
    fs::write(folder.join(&file), format!("{text}\n[tolerances]\n{tolerances}\n")).unwrap();
    file
}

/// Few samples, whose percentiles are those of the samples, and many, whose percentiles come from counts; in parts of which some are few.
#[test]
fn threads_and_parts_give_the_same_bytes_and_statistics() {
    let folder = folder("scatter-runs-same");
    let four = example("in-line-4-production");
    let cases = [("36000", "parquet", &[][..]), ("70000", "csv", &["--orders-only"][..])];
    for (samples, ending, more) in cases {
        let limit = ["--limit", "force order 1 = 2 kN"];
        let run = |what: &str, options: &[&str]| {
            let table = format!("{what}-{samples}.{ending}");
            let said =
                output(&folder, 0, &production(&four, samples, &table, &[more, &limit, options].concat()));
            (said, bytes(&folder, &table))
        };
        let (said, whole) = run("whole", &[]);
        for threads in ["1", "3"] {
            assert!(
                run(threads, &["--threads", threads]) == (said.clone(), whole.clone()),
                "{threads} threads"
            );
        }
        let mut merge = vec!["merge".to_owned()];
        for part in ["2/3", "3/3", "1/3"] {
            let table = format!("part-{}-{samples}.parquet", &part[..1]);
            output(
                &folder,
                0,
                &production(&four, samples, &table, &[more, &limit, &["--part", part]].concat()),
            );
            merge.push(table);
        }
        let merged = format!("merged-{samples}.{ending}");
        merge.extend(["--output".to_owned(), merged.clone()]);
        let merge: Vec<&str> = merge.iter().map(String::as_str).collect();
        assert_eq!(output(&folder, 0, &merge), said, "the answer is that of the whole run");
        assert!(bytes(&folder, &merged) == whole, "merged parts are another table");
        // The table adds nothing to what is said without one, and takes nothing from it.
        let alone = [&["scatter", four.as_str(), "--samples", samples][..], more, &limit].concat();
        assert_eq!(output(&folder, 0, &alone), said);
    }
}

/// Every row is an engine: built from its deviations, it has the loads of its row; and what is told is told of the rows.
#[test]
fn the_table_holds_every_engine_with_its_deviations() {
    let folder = folder("scatter-runs-content");
    let file = tolerant(
        &folder,
        "in-line-4-long-stroke",
        "piston_mass = { plus_minus = \"5 g\" }\ncommon = { rod_length = { plus_minus = \"1 mm\", distribution = \"uniform\" } }",
    );
    let arguments = production(&file, "70000", "engines.parquet", &["--format", "json"]);
    let answer = output_json(&folder, 0, &arguments);
    let mut reader = TableReader::open(File::open(folder.join("engines.parquet")).unwrap()).unwrap();
    let columns = reader.columns().unwrap();
    let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
    assert_eq!(
        names.join(" "),
        "sample piston_mass_1_g piston_mass_2_g piston_mass_3_g piston_mass_4_g rod_length_all_mm force_order_1_N \
         couple_order_1_Nm force_order_2_N couple_order_2_Nm peak_force_N peak_couple_Nm"
    );
    let text = fs::read_to_string(folder.join(&file)).unwrap();
    assert_eq!(reader.metadata("lanchester.engine"), Some(text.as_str()));
    let mut table: Vec<Vec<f64>> = vec![Vec::new(); columns.len()];
    while let Some(rows) = reader.next(&columns).unwrap() {
        for (column, values) in table.iter_mut().zip(rows.columns()) {
            match values {
                Values::Whole(values) => column.extend(values.iter().map(|value| *value as f64)),
                Values::Real(values) => column.extend(values),
                Values::Text(_) => panic!("numbers alone"),
            }
        }
    }
    assert!(table[0].iter().enumerate().all(|(k, sample)| *sample == k as f64) && table[0].len() == 70_000);
    assert!(table[1..5].iter().flatten().all(|grams| grams.abs() <= 5.0));
    assert!(table[5].iter().any(|millimetres| millimetres.abs() > 0.99));
    for place in 0..6 {
        let own = &table[6 + place];
        let told = |name: &str| number(&answer, &format!("/scatter/outputs/{place}/{name}"));
        let most = own.iter().copied().fold(0.0f64, f64::max);
        assert_eq!(told("most"), most, "{}", names[6 + place]);
        let mut rising = own.clone();
        rising.sort_by(f64::total_cmp);
        let median = answer["scatter"]["outputs"][place]["percentiles"].as_array().unwrap();
        let median = median.iter().find(|percentile| percentile["share"] == 0.5).unwrap();
        assert_eq!(number(median, "/value"), rising[34_999], "{}", names[6 + place]);
        let mean = own.iter().sum::<f64>() / 70_000.0;
        // Sums are in whole steps of 2^-40 of all inertia forces, here 61 kN: 6e-8 N and, at 0.13 m, less in N m.
        assert!((told("mean") - mean).abs() < 6e-8, "{}: {} {mean}", names[6 + place], told("mean"));
    }
    // The engine of some row, built.
    let row = 54_321;
    let plain = output_json(&folder, 0, &["show", &file, "--format", "json"]);
    let nominal = number(&plain, "/cylinders/0/piston_mass");
    let length = number(&plain, "/cylinders/0/rod/length");
    let mut built = String::from("\n");
    for cylinder in 0..4 {
        built += &format!(
            "[[cylinder]]\nnumber = {}\npiston = {{ mass = \"{} kg\" }}\nrod = {{ length = \"{} m\" }}\n",
            cylinder + 1,
            nominal + 1e-3 * table[1 + cylinder][row],
            length + 1e-3 * table[5][row],
        );
    }
    fs::write(folder.join("built.toml"), text + &built).unwrap();
    let loads = output_json(&folder, 0, &["loads", "built.toml", "--format", "json"]);
    let size = |order: usize, load: &str| {
        let at = |sense: &str, k: usize| number(&loads, &format!("/total/orders/{order}/{load}_{sense}/{k}"));
        ["forward", "backward"].map(|sense| at(sense, 0).hypot(at(sense, 1))).iter().sum::<f64>()
    };
    let scale = number(&loads, "/total/peaks/force/max/value");
    let wanted = [size(1, "force"), size(1, "couple"), size(2, "force"), size(2, "couple"), scale];
    for (place, wanted) in wanted.into_iter().enumerate() {
        // Rounding of the masses and lengths in the file, whose last digits the loads of all cylinders have.
        let got = table[6 + place][row];
        assert!((got - wanted).abs() < 1e-9 * scale, "{}: {got} {wanted}", names[6 + place]);
    }
    let again = lanchester(&folder, &arguments);
    assert!(String::from_utf8_lossy(&again.stderr).contains("holds this already"), "{again:?}");
    assert_eq!(serde_json::from_slice::<Value>(&again.stdout).unwrap(), answer);
    let other = message(&folder, 2, &production(&file, "70001", "engines.parquet", &[]));
    assert!(other.contains("engines.parquet holds something else and is not overwritten"), "{other}");
}

#[test]
fn a_killed_production_goes_on_to_the_same_bytes() {
    let folder = folder("scatter-runs-killed");
    let file = tolerant(&folder, "v6-60", "common = { rod_length = { plus_minus = \"0.1 mm\" } }");
    let killed = kill_twice(&folder, "killed.parquet", |times| {
        let samples = (600_000 * times).to_string();
        let run = production(&file, &samples, "killed.parquet", &["--threads", "1"]);
        run.iter().map(ToString::to_string).collect()
    });
    let arguments: Vec<&str> = killed.iter().map(String::as_str).collect();
    let samples = arguments[3];
    let went_on = lanchester(&folder, &arguments);
    assert!(String::from_utf8_lossy(&went_on.stderr).contains("going on after"), "{went_on:?}");
    let whole = production(&file, samples, "whole.parquet", &[]);
    assert_eq!(output(&folder, 0, &whole).into_bytes(), went_on.stdout);
    assert!(bytes(&folder, "killed.parquet") == bytes(&folder, "whole.parquet"), "another table");
}

#[test]
fn mistakes_of_such_runs_are_told() {
    let folder = folder("scatter-runs-mistakes");
    let four = example("in-line-4-production");
    let refused = |arguments: &[&str], said: &str| {
        let told = message(&folder, 2, arguments);
        assert!(told.contains(said), "{told}");
    };
    refused(&production(&four, "100", "engines.txt", &[]), "a table is written as .parquet or .csv");
    refused(&production(&four, "100", "engines.csv", &["--part", "1/2"]), "a part must be a Parquet file");
    refused(&["scatter", &four, "--part", "1/2"], "--save");
    // Fewer blocks than parts: a part without a sample is one all the same.
    let empty = lanchester(&folder, &production(&four, "100", "1.parquet", &["--part", "1/2"]));
    let told = String::from_utf8_lossy(&empty.stderr);
    assert!(empty.status.success() && told.contains("no sample falls into this part"), "{empty:?}");
    output(&folder, 0, &production(&four, "100", "2.parquet", &["--part", "2/2"]));
    refused(&["merge", "1.parquet", "--output", "x.parquet"], "a part is missing: blocks 0 to 1 of 1");
    output(&folder, 0, &["merge", "1.parquet", "2.parquet", "--output", "x.parquet"]);
    output(&folder, 0, &production(&four, "100", "whole.parquet", &[]));
    assert!(bytes(&folder, "x.parquet") == bytes(&folder, "whole.parquet"));
    // A part that alone would not hold the limit is no failure; the merged production is.
    let strict = ["--limit", "force order 1 = 1 N"];
    for (part, table) in [("1/2", "s1.parquet"), ("2/2", "s2.parquet")] {
        output(&folder, 0, &production(&four, "40000", table, &[&strict[..], &["--part", part]].concat()));
    }
    output(&folder, 1, &["merge", "s1.parquet", "s2.parquet", "--output", "s.parquet"]);
    refused(&["merge", "s1.parquet", "2.parquet", "--output", "y.parquet"], "are not parts of one run");
}
