//! What `counterweight design` found for the weights of balance shafts, as text and CSV.

use super::words::list;
use lanchester::geometry::{ShaftWeightAim, ShaftWeightOutcome};
use lanchester::model::Engine;
use lanchester::report::{
    DesignedShaftShape, designed_shaft_weights_table, nearest_shaft_limits_table, shaft_aim_words,
};
use lanchester::{DesignedShaftWeight, ShaftWeightDesigns};

/// Weights of one duty, and what was found for them.
struct Group<'a> {
    names: String,
    duty: f64,
    outcome: &'a ShaftWeightOutcome,
}

fn groups<'a>(designs: &'a ShaftWeightDesigns, engine: &Engine) -> Vec<Group<'a>> {
    let mut groups: Vec<Group> = Vec::new();
    for weight in &designs.weights {
        if groups.iter().any(|known| known.duty == weight.duty) {
            continue;
        }
        let alike: Vec<_> = designs.weights.iter().filter(|other| other.duty == weight.duty).collect();
        groups.push(Group { names: names(&alike, engine), duty: weight.duty, outcome: &weight.outcome });
    }
    groups
}

/// Names of weights in a list; that of the shaft where all of its weights are there.
fn names(weights: &[&DesignedShaftWeight], engine: &Engine) -> String {
    let mut names: Vec<&str> = Vec::new();
    for weight in weights {
        let shaft = &engine.shafts[weight.place.0];
        let count = weights.iter().filter(|other| other.place.0 == weight.place.0).count();
        let is_whole = count == shaft.weights.len();
        if !is_whole || weight.place.1 == 0 {
            names.push(if is_whole { &shaft.name } else { &weight.name });
        }
    }
    list(names.into_iter())
}

fn shapes<'a>(groups: &'a [Group<'a>]) -> Vec<DesignedShaftShape<'a>> {
    let found = groups.iter().filter_map(|group| match group.outcome {
        ShaftWeightOutcome::Best(design) => {
            Some(DesignedShaftShape { names: &group.names, duty: group.duty, design })
        }
        ShaftWeightOutcome::Infeasible { .. } => None,
    });
    found.collect()
}

/// What was found, as text.
pub fn text(designs: &ShaftWeightDesigns, engine: &Engine) -> String {
    let groups = groups(designs, engine);
    let shapes = shapes(&groups);
    let aim = designs.task.minimise;
    // Ends of ranges and roots of monotonous functions; the least inertia is searched.
    let proof = match aim {
        ShaftWeightAim::Inertia => "proved to one part in a million",
        ShaftWeightAim::Mass | ShaftWeightAim::Length | ShaftWeightAim::Radius => "in closed form",
    };
    let mut out = String::new();
    for shape in &shapes {
        let (name, value) = shaft_aim_words(aim, shape.design);
        out += &format!(
            "{}: the least {name} of all weights within the ranges is {value}, {proof}.\n",
            shape.names
        );
    }
    if !shapes.is_empty() {
        out += &format!("\n{}", designed_shaft_weights_table(&shapes).text());
    }
    for group in &groups {
        if let ShaftWeightOutcome::Infeasible { least, most, nearest } = group.outcome {
            let table = nearest_shaft_limits_table(&group.names, group.duty, [*least, *most], nearest);
            let gap = if out.is_empty() { "" } else { "\n" };
            out += &format!("{gap}{}", table.text());
        }
    }
    out
}

/// Properties and dimensions of what was found, as CSV.
pub fn csv(designs: &ShaftWeightDesigns, engine: &Engine) -> String {
    designed_shaft_weights_table(&shapes(&groups(designs, engine))).csv()
}
