//! Codes of diagnostics: each is in the book's list, and each can be met.

use lanchester_bondgraph::{Graph, diagnostic_codes, equations};
use std::collections::BTreeSet;

const PAGE: &str = include_str!("../../../../docs/src/guide/bond-graphs.md");

#[test]
fn the_book_lists_every_code_with_its_meaning() {
    let listed: Vec<&str> = PAGE.lines().filter(|line| line.starts_with("| E17")).collect();
    let ours: Vec<String> =
        diagnostic_codes().iter().map(|(code, meaning)| format!("| {code} | {meaning} |")).collect();
    assert_eq!(listed, ours);
}

/// One graph for each code.
#[test]
fn every_code_can_be_met() {
    let shaft = "s = { kind = \"1\", domain = \"rotation\" }\nw = { kind = \"I\", inertia = \"1 kg m2\" }\n";
    let bonds = "[bonds]\nlist = [\"s > w\", \"m > s\"]\n";
    let motor = |law: &str| format!("[elements]\n{shaft}m = {law}\n{bonds}");
    let se = |law: &str| motor(&format!("{{ kind = \"Se\", effort = \"{law}\" }}"));
    let long = "1 N m + ".repeat(600) + "1 N m";
    let second = "v = { kind = \"Sf\", flow = \"2 rad/s\" }\nw = {";
    let conflict = motor("{ kind = \"Sf\", flow = \"1 rad/s\" }").replace("w = {", second);
    let conflict = conflict.replace("\"m > s\"", "\"m > s\", \"v > s\"");
    let cases = [
        ("E1701", "[elements\n".to_owned()),
        ("E1702", motor("{ kind = \"Sx\" }")),
        ("E1703", format!("[parameters]\nw = 1\n{}", se("1 N m"))),
        ("E1704", se("1 N m *")),
        ("E1705", se("1 N")),
        ("E1706", se("torque")),
        ("E1707", se("1 N m").replace("m > s", "n > s")),
        ("E1708", se("1 N m").replace("s > w", "w > s")),
        ("E1709", motor("{ kind = \"Se\" }")),
        ("E1710", se("1 N m").replace(", domain = \"rotation\"", "")),
        ("E1711", format!("[parameters]\na = \"b\"\nb = \"a\"\n{}", se("1 N m"))),
        ("E1712", se("1 N m").replace("1 kg m2", "-1 kg m2")),
        ("E1713", conflict),
        (
            "E1714",
            "[elements]\na = { kind = \"1\", domain = \"rotation\" }\nb = { kind = \"1\", domain = \"rotation\" }\n\
             g = { kind = \"TF\", ratio = \"1\" }\nh = { kind = \"TF\", ratio = \"1\" }\nm = { kind = \"Se\", effort = \"1 N m\" }\n\
             r = { kind = \"R\", resistance = \"1 N m s\" }\n\
             [bonds]\nlist = [\"m > a\", \"a > g.1\", \"g.2 > b\", \"b > h.1\", \"h.2 > a\", \"b > r\"]\n"
                .to_owned(),
        ),
        ("E1715", se(&long)),
    ];
    let mut met = BTreeSet::new();
    for (code, text) in cases {
        let mistakes = match Graph::read(&text) {
            Err(mistakes) => mistakes,
            Ok(graph) => equations(&graph).expect_err(code),
        };
        for mistake in &mistakes {
            met.insert(mistake.code);
        }
        assert!(mistakes.iter().any(|mistake| mistake.code == code), "{code}: {mistakes:?}");
    }
    let all: BTreeSet<&str> = diagnostic_codes().iter().map(|(code, _)| *code).collect();
    assert!(met.is_subset(&all), "{met:?}");
}
