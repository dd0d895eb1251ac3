//! Oil films that hold a crankshaft at rest or press on its pins.

use super::cycle::complete;
use super::{engine, words};
use crate::program::{message, number, output, output_json};

const AT: [&str; 4] = ["--angle", "380 deg", "--speed", "3000 rpm"];

#[test]
fn journals_rest_in_films_and_films_press_on_the_pin() {
    let folder = engine("stress-films", complete);
    let film = ["--support", "film", "--pin-pressure", "film"];
    let text = output(&folder, 0, &words(&[&["static"], &AT[..], &film].concat()));
    for words in [
        "in equilibrium with the oil films",
        "The films carry the loads to",
        "as if it stayed",
        "Journals in their oil films",
        "main bearing 2",
    ] {
        assert!(text.replace('\n', " ").contains(words), "{words}: {text}");
    }
    let json = |more: &[&str]| {
        let rest = [&["static", "--format", "json"], &AT[..], more].concat();
        output_json(&folder, 0, &words(&rest))
    };
    let [held, film] = [json(&[]), json(&film)];
    for axis in 0..2 {
        let at = |json: &serde_json::Value, key: &str| number(json, &format!("/cases/0/{key}/{axis}"));
        assert!((at(&held, "load") - at(&film, "load")).abs() < 1e-3);
        assert!((at(&film, "load") + at(&film, "reaction")).abs() < 1e-4);
        // The only crank throw is midway between its mains.
        let [one, other] =
            [0, 1].map(|main| number(&film, &format!("/cases/0/result/films/{main}/force/{axis}")));
        assert!((one - other).abs() < 1e-3 * at(&film, "load").abs().max(100.0), "{one} {other}");
    }
    assert!(held.pointer("/cases/0/result/films").is_none());
    let edges = [0, 1].map(|main| number(&film, &format!("/cases/0/result/films/{main}/least_edge_film")));
    let touches = edges.iter().any(|edge| *edge < 0.0);
    assert_eq!(text.replace('\n', " ").contains("would touch at an end"), touches, "{edges:?}");
    assert!(number(&film, "/cases/0/result/films/0/least_film") > 0.0);
    assert_eq!(film.pointer("/cases/0/loading/pressure").unwrap(), "film");
    // The same from the file.
    std::fs::write(
        folder.join("engine.toml"),
        std::fs::read_to_string(folder.join("engine.toml")).unwrap()
            + "[[stress.case]]\nname = \"rest\"\nangle = \"380 deg\"\nspeed = \"3000 rpm\"\nsupport = \"film\"\n",
    )
    .unwrap();
    let rest = ["static", "--case", "rest", "--pin-pressure", "film", "--format", "json"];
    let named = output_json(&folder, 0, &words(&rest));
    let key = "/cases/0/result/films/0/least_film";
    assert_eq!(number(&named, key), number(&film, key));
}

#[test]
fn films_without_motion_are_refused() {
    let folder = engine("stress-films-refused", complete);
    let film = ["--pin-pressure", "film"];
    for (rest, wanted) in [
        ([&["static", "--force", "1: -20 kN"], &film[..]].concat(), "given forces have none"),
        ([&["static", "--support", "rings"], &film[..]].concat(), "at their outside"),
        ([&["static", "--loads", "simulation"], &film[..]].concat(), "these are those of a run"),
        (vec!["static", "--force", "1: -20 kN", "--support", "film"], "at standstill"),
        (vec!["modes", "--support", "film"], "a support that is linear"),
        (vec!["fatigue", "--support", "film"], "a support that is linear"),
        (
            [&["export", "--support", "film", "--output", "case.inp"], &AT[..]].concat(),
            "a support that is linear",
        ),
    ] {
        let said = message(&folder, 2, &words(&rest)).replace('\n', " ");
        assert!(said.contains(wanted), "{rest:?}: {said}");
    }
}
