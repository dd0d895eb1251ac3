//! The example with choices, as it is shipped.

use crate::optimum::support::*;
use lanchester_balance::{Method, optimise};
use lanchester_file::{EngineFile, read};
use lanchester_task::*;

const EXAMPLE: &str = include_str!("../../../../../examples/twin-270-choices.toml");

#[test]
fn one_of_two_shafts_and_a_plane() {
    let EngineFile { engine, tasks } = read(EXAMPLE).file.expect("the example is valid");
    let task = tasks.balance.expect("it has a section [balance]");
    let answer = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &answer);
    assert!(matches!(answer.method, Method::BranchAndBound { .. }));
    assert_eq!(answer.shafts.iter().filter(|s| s.used).count(), 1);
    // Either shaft alone, on a grid of planes.
    let value = |shaft: usize, z: f64| {
        let mut task = task.clone();
        task.stages.truncate(1);
        task.most_optional = None;
        task.weights.retain(|w| w.seat != Seat::Shaft(1 - shaft));
        task.shafts.remove(1 - shaft);
        task.shafts[0].optional = false;
        for weight in &mut task.weights {
            weight.seat = match weight.seat {
                Seat::Shaft(_) => Seat::Shaft(0),
                crank => {
                    (weight.z, weight.least) = (Place::At(z), 0.0);
                    crank
                }
            };
        }
        optimise(&engine, &task).unwrap().stages[0].value
    };
    let planes = (0..=56).map(|k| -0.07 + 0.0025 * f64::from(k));
    let grid = planes.flat_map(|z| [value(0, z), value(1, z)]).fold(f64::INFINITY, f64::min);
    let found = answer.stages[0].value;
    // The least amount is far below the best, so that only the coarseness of the grid is between them.
    assert!(found <= grid * (1.0 + 1e-8) && found > 0.99 * grid, "{found} {grid}");
}
