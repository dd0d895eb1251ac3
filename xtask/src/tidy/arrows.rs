//! Crate arrows: which crate may import which.

use serde_json::Value;

/// Each crate and the workspace crates that it may name as normal dependencies. A crate that is not here may not
/// exist: a new room needs a decision record and a line.
const ARROWS: [(&str, &[&str]); 37] = [
    ("lanchester-numerics", &[]),
    ("lanchester-shape", &["lanchester-numerics"]),
    ("lanchester-units", &[]),
    ("lanchester-diagnostic", &[]),
    ("lanchester-results", &["lanchester-numerics", "lanchester-units"]),
    ("lanchester-model", &["lanchester-shape"]),
    ("lanchester-task", &["lanchester-model", "lanchester-results", "lanchester-shape", "lanchester-units"]),
    (
        "lanchester-file",
        &[
            "lanchester-model",
            "lanchester-task",
            "lanchester-shape",
            "lanchester-units",
            "lanchester-diagnostic",
            "lanchester-numerics",
        ],
    ),
    ("lanchester-mechanism", &["lanchester-model", "lanchester-results", "lanchester-numerics"]),
    (
        "lanchester-bondgraph",
        &["lanchester-diagnostic", "lanchester-model", "lanchester-results", "lanchester-numerics"],
    ),
    (
        "lanchester-cycle",
        &[
            "lanchester-model",
            "lanchester-results",
            "lanchester-units",
            "lanchester-mechanism",
            "lanchester-numerics",
        ],
    ),
    (
        "lanchester-geometry",
        &["lanchester-model", "lanchester-task", "lanchester-shape", "lanchester-numerics"],
    ),
    (
        "lanchester-balance",
        &[
            "lanchester-model",
            "lanchester-results",
            "lanchester-task",
            "lanchester-mechanism",
            "lanchester-numerics",
        ],
    ),
    (
        "lanchester-literature",
        &[
            "lanchester-model",
            "lanchester-results",
            "lanchester-task",
            "lanchester-mechanism",
            "lanchester-balance",
        ],
    ),
    (
        "lanchester-workshop",
        &["lanchester-model", "lanchester-task", "lanchester-mechanism", "lanchester-balance"],
    ),
    (
        "lanchester-study",
        &[
            "lanchester-model",
            "lanchester-results",
            "lanchester-task",
            "lanchester-mechanism",
            "lanchester-numerics",
        ],
    ),
    ("lanchester-multibody", &["lanchester-model", "lanchester-results", "lanchester-numerics"]),
    ("lanchester-film", &["lanchester-numerics"]),
    ("lanchester-fmu", &["lanchester"]),
    (
        "lanchester-flex",
        &[
            "lanchester-model",
            "lanchester-geometry",
            "lanchester-shape",
            "lanchester-film",
            "lanchester-numerics",
        ],
    ),
    ("lanchester-strength", &["lanchester-model"]),
    ("lanchester-torsion", &["lanchester-model", "lanchester-numerics"]),
    ("lanchester-table", &[]),
    ("lanchester-exchange", &[]),
    ("lanchester-sheet", &[]),
    (
        "lanchester-report",
        &[
            "lanchester-model",
            "lanchester-results",
            "lanchester-task",
            "lanchester-mechanism",
            "lanchester-bondgraph",
            "lanchester-multibody",
            "lanchester-film",
            "lanchester-flex",
            "lanchester-strength",
            "lanchester-torsion",
            "lanchester-geometry",
            "lanchester-balance",
            "lanchester-literature",
            "lanchester-workshop",
            "lanchester-study",
        ],
    ),
    (
        "lanchester",
        &[
            "lanchester-model",
            "lanchester-numerics",
            "lanchester-task",
            "lanchester-file",
            "lanchester-units",
            "lanchester-mechanism",
            "lanchester-multibody",
            "lanchester-film",
            "lanchester-flex",
            "lanchester-strength",
            "lanchester-torsion",
            "lanchester-cycle",
            "lanchester-geometry",
            "lanchester-balance",
            "lanchester-literature",
            "lanchester-bondgraph",
            "lanchester-workshop",
            "lanchester-report",
            "lanchester-results",
            "lanchester-study",
            "lanchester-table",
            "lanchester-exchange",
        ],
    ),
    ("lanchester-data", &[]),
    ("lanchester-validation", &["lanchester", "lanchester-data"]),
    ("lanchester-files", &[]),
    ("lanchester-answers", &["lanchester", "lanchester-data"]),
    ("lanchester-studio", &["lanchester-answers", "lanchester-files"]),
    (
        "lanchester-cli",
        &["lanchester", "lanchester-files", "lanchester-sheet", "lanchester-studio", "lanchester-validation"],
    ),
    ("lanchester-python", &["lanchester", "lanchester-files"]),
    ("lanchester-web", &["lanchester-answers"]),
    (TESTKIT, &["lanchester-file", "lanchester-model"]),
    ("xtask", &[]),
];

/// What tests share: nobody imports it but for tests, and it stands in the table for what it imports itself.
const TESTKIT: &str = "lanchester-testkit";

/// Breaches of the table, from the output of `cargo metadata --no-deps`.
pub fn check(metadata: &Value) -> Vec<String> {
    let packages = metadata["packages"].as_array().map(Vec::as_slice).unwrap_or_default();
    let name = |package: &Value| package["name"].as_str().unwrap_or_default().to_owned();
    let members: Vec<String> = packages.iter().map(name).collect();
    let mut breaches = Vec::new();
    for package in packages {
        let from = name(package);
        let Some((_, allowed)) = ARROWS.iter().find(|(crate_name, _)| *crate_name == from) else {
            breaches
                .push(format!("crate {from} is not in the table of crate arrows (xtask/src/tidy/arrows.rs)"));
            continue;
        };
        for dependency in package["dependencies"].as_array().map(Vec::as_slice).unwrap_or_default() {
            let to = name(dependency);
            let normal = dependency["kind"].as_str() != Some("dev");
            if normal && members.contains(&to) && !allowed.contains(&to.as_str()) {
                breaches.push(format!("crate {from} may not import {to}"));
            }
        }
    }
    breaches
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn package(name: &str, dependencies: &[(&str, Option<&str>)]) -> Value {
        let dependencies: Vec<Value> =
            dependencies.iter().map(|(name, kind)| json!({ "name": name, "kind": kind })).collect();
        json!({ "name": name, "dependencies": dependencies })
    }

    #[test]
    fn arrow_up_the_table_is_a_breach_but_not_for_tests() {
        let mut packages = vec![
            package("lanchester-model", &[("serde", None), ("lanchester-mechanism", Some("dev"))]),
            package("lanchester-mechanism", &[("lanchester-model", None)]),
        ];
        assert!(check(&json!({ "packages": packages })).is_empty());
        packages[0] = package("lanchester-model", &[("lanchester-mechanism", None)]);
        assert_eq!(
            check(&json!({ "packages": packages })),
            ["crate lanchester-model may not import lanchester-mechanism"]
        );
        // What tests share is for tests.
        packages.push(package("lanchester-testkit", &[("lanchester-model", None)]));
        packages[0] = package("lanchester-model", &[("lanchester-testkit", Some("dev"))]);
        assert!(check(&json!({ "packages": packages })).is_empty());
        packages[0] = package("lanchester-model", &[("lanchester-testkit", None)]);
        assert_eq!(
            check(&json!({ "packages": packages })),
            ["crate lanchester-model may not import lanchester-testkit"]
        );
        packages[0] = package("lanchester-attic", &[]);
        assert_eq!(check(&json!({ "packages": packages })).len(), 1);
    }
}
