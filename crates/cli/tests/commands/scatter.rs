//! Production scatter and the assignment of weighed parts on the command line.

use crate::program::{example, folder, message, number, output, output_json};
use serde_json::Value;

/// Limits decide the exit status; halving the worst tolerance in the file does what the study said it would.
#[test]
fn a_production_is_drawn_judged_and_tightened() {
    let folder = folder("scatter");
    let four = example("in-line-4-production");
    let base = ["scatter", &four, "--samples", "20000", "--format", "json"];
    let json = output_json(&folder, 0, &[&base[..], &["--limit", "force order 1 = 2 kN"]].concat());
    assert_eq!(json["limits"][0]["is_met"], Value::Bool(true));
    let strict = output_json(&folder, 1, &[&base[..], &["--limit", "force order 1 = 200 N"]].concat());
    assert_eq!(strict["limits"][0]["is_met"], Value::Bool(false));
    assert_eq!(json["scatter"], output_json(&folder, 0, &base)["scatter"].clone().with_limit(&json));
    for (place, worst) in json["worst_cases"].as_array().into_iter().flatten().enumerate() {
        let most = number(&json, &format!("/scatter/outputs/{place}/most"));
        let (attained, bound) = (number(worst, "/attained"), number(worst, "/bound"));
        assert!(most <= bound && attained <= bound && attained > 0.0);
    }
    // The throw angle is the fifth tolerance of the file.
    let gain = number(&json, "/tightened/4/gains/0");
    assert!(gain > 0.3, "{gain}");
    let text = std::fs::read_to_string(&four).expect("it is shipped").replace("0.25 deg", "0.125 deg");
    std::fs::write(folder.join("tight.toml"), text).expect("the folder is ours");
    let tight = output_json(&folder, 0, &["scatter", "tight.toml", "--samples", "20000", "--format", "json"]);
    let rare = |json: &Value| {
        let all = json.pointer("/scatter/outputs/0/percentiles").and_then(Value::as_array).cloned();
        let found = all.into_iter().flatten().find(|p| p["share"] == 0.9973);
        number(&found.unwrap_or(Value::Null), "/value")
    };
    assert!((rare(&tight) / rare(&json) - (1.0 - gain)).abs() < 1e-12);
    let text = output(&folder, 0, &["scatter", &four, "--samples", "5000", "--figures", "figures"]);
    assert!(text.contains("Tighten first\n  Force of order 1: throw angle (half of it: "), "{text}");
    assert!(folder.join("figures/scatter.svg").exists());
}

trait WithLimit {
    fn with_limit(self, other: &Value) -> Value;
}

impl WithLimit for Value {
    /// The scatter of a run without limits as one with the capabilities of `other`, which alone differ.
    fn with_limit(mut self, other: &Value) -> Value {
        for (place, own) in self["outputs"].as_array_mut().into_iter().flatten().enumerate() {
            own["capabilities"] = other["scatter"]["outputs"][place]["capabilities"].clone();
        }
        self
    }
}

#[test]
fn mistakes_of_a_scatter_are_told() {
    let folder = folder("scatter-mistakes");
    let four = example("in-line-4-production");
    let refused = |arguments: &[&str], said: &str| {
        let told = message(&folder, 2, arguments);
        assert!(told.contains(said), "{told}");
    };
    refused(&["scatter", &example("in-line-4")], "add [tolerances] to the engine file");
    refused(&["scatter", &four, "--limit", "roll moment = 3 N m"], "got a limit on `roll moment`");
    refused(&["scatter", &four, "--orders-only", "--limit", "force = 3 N"], "peaks are left out");
    refused(&["scatter", &four, "--samples", "0"], "number of samples must be from 1");
    refused(&["scatter", &four, "--capability", "1.67"], "--limit");
    refused(&["scatter", &four, "--limit", "force = 3 N", "--capability=-1"], "wanted capability must be");
    refused(&["workshop", "assign", &four], "nothing is weighed");
    refused(
        &["workshop", "assign", &four, "--pistons", "1 g, 2 g"],
        "needs 4 masses, one for each cylinder, got 2",
    );
    refused(&["workshop", "assign", &four, "--pistons", "0 g, 2 g, 1 g, 3 g"], "masses above 0");
}

/// The parts as they are told to go, built into the engine file, leave what was said.
#[test]
fn weighed_parts_go_where_they_leave_least() {
    let folder = folder("assign");
    let four = example("in-line-4-production");
    let pistons = [0.4031, 0.3987, 0.4002, 0.4013];
    let list = pistons.map(|mass| format!("{mass} kg")).join(", ");
    let json =
        output_json(&folder, 0, &["workshop", "assign", &four, "--pistons", &list, "--format", "json"]);
    let mut text = std::fs::read_to_string(&four).expect("it is shipped");
    for (index, number) in json["pistons"].as_array().into_iter().flatten().enumerate() {
        let piston = number.as_u64().expect("a number") as usize - 1;
        text += &format!(
            "[[cylinder]]\nnumber = {}\npiston = {{ mass = \"{} kg\" }}\n",
            index + 1,
            pistons[piston]
        );
    }
    std::fs::write(folder.join("built.toml"), text).expect("the folder is ours");
    let loads = output_json(&folder, 0, &["loads", "built.toml", "--format", "json"]);
    let order = &loads["total"]["orders"][1];
    let size = |name: &str| {
        let part = |k: usize| order[name][k].as_f64().expect("a number");
        part(0).hypot(part(1))
    };
    let force = size("force_forward") + size("force_backward");
    assert!((force - number(&json, "/force")).abs() < 1e-6 * force.max(1.0), "{force} {json}");
    assert!(number(&json, "/residual") <= number(&json, "/as_numbered"));
}
