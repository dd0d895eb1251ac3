//! Counterweights that are designed and fitted.

use super::*;
use lanchester_geometry::{DesignLimits, DesignSettings, Range, Shoulder};

const SINGLE: &str = r#"
name = "single"
speed = "3000 rpm"
[layout]
type = "in-line"
cylinders = 1
[crank]
stroke = "90 mm"
web_distance = "50 mm"
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"
[[counterweight]]
web = 1
unbalance = "30 kg mm"
[[counterweight]]
web = 2
unbalance = "30 kg mm"
[[counterweight]]
name = "flywheel"
z = "100 mm"
unbalance = "1 kg mm"
"#;

fn engine() -> Engine {
    lanchester_file::read(SINGLE).engine().expect("the file has no mistakes")
}

fn task() -> ShapeTask {
    ShapeTask {
        minimise: Objective::Mass,
        least_balance: 1.0,
        most_balance: None,
        density: 7850.0,
        web_radius: Range::fixed(0.045),
        rectangle_height: Range::new(0.0, 0.03),
        shoulder: Shoulder::Height(Range::new(0.0, 0.03)),
        arc_radius: Range::new(0.05, 0.1),
        arc_angle: Range::new(1.0, 3.1),
        thickness: Range::new(0.01, 0.025),
        limits: DesignLimits::default(),
        settings: DesignSettings::default(),
    }
}

fn request(weights: &[&str]) -> CounterweightRequest {
    let weights = weights.iter().map(|name| (*name).to_owned()).collect();
    CounterweightRequest { weights, unbalance: None, task: task(), evolution: None }
}

#[test]
fn weights_on_webs_are_designed_and_fitted() {
    let engine = engine();
    let designs = design_counterweights(&engine, &request(&[])).unwrap();
    let names: Vec<&str> = designs.weights.iter().map(|weight| weight.name.as_str()).collect();
    assert_eq!(names, ["web 1", "web 2"]);
    assert_eq!(designs.weights[0].outcome, designs.weights[1].outcome);
    assert!(designs.weights[0].evolution.is_none());
    let DesignOutcome::Found(best) = &designs.weights[0].outcome else { panic!("it can be met") };
    assert!(best.proved);
    let fitted = with_counterweights(&engine, &[(0, best.design)], 7850.0).unwrap();
    let weight = &fitted.counterweights[0];
    assert!((weight.unbalance - 0.03).abs() < 1e-10);
    assert_eq!(weight.angle, engine.counterweights[0].angle);
    let part = weight.part.as_ref().unwrap();
    assert_eq!((part.web, part.wanted), (Some(0), Some(0.03)));
    assert!(fitted.counterweights[1].part.is_none());
}

#[test]
fn evolution_stands_beside_the_optimum() {
    let search = EvolutionRequest { seed: 7, evaluations: 2000 };
    let request = CounterweightRequest { evolution: Some(search), ..request(&[]) };
    let designs = design_counterweights(&engine(), &request).unwrap();
    let DesignOutcome::Found(best) = &designs.weights[1].outcome else { panic!("it can be met") };
    let evolved = designs.weights[1].evolution.as_ref().unwrap().best.unwrap();
    assert!(evolved.value >= best.bound);
}

#[test]
fn what_cannot_be_designed_is_told() {
    let engine = engine();
    let error = design_counterweights(&engine, &request(&["web 3"])).unwrap_err().to_string();
    assert!(error.contains("\"web 3\"") && error.contains("\"web 1\", \"web 2\", \"flywheel\""), "{error}");
    let bare = engine.without_counterweights();
    let error = design_counterweights(&bare, &request(&[])).unwrap_err().to_string();
    assert!(error.contains("hint: find the best ones on the webs first"), "{error}");
    let both = request(&["web 1", "flywheel"]);
    let error = counterweight_front(&engine, &both, Objective::SweptRadius, 5).unwrap_err().to_string();
    assert!(error.contains("web 1 0.030000 kg m, flywheel 0.001000 kg m"), "{error}");
}

#[test]
fn the_front_goes_from_one_end_to_the_other() {
    let found = counterweight_front(&engine(), &request(&[]), Objective::SweptRadius, 5).unwrap();
    assert_eq!((found.weights, found.room), (vec![0, 1], None));
    let front = found.front;
    assert!(front.proved && front.designs.len() >= 4);
    let ends = [&front.designs[0], front.designs.last().unwrap()];
    assert!(ends[0].mass < ends[1].mass && ends[0].swept_radius > ends[1].swept_radius);
}
