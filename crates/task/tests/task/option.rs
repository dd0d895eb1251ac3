//! What is asked, in a line of text.

use lanchester_file::{read, template};
use lanchester_model::Engine;
use lanchester_task::option::{cancel, limit, stage};
use lanchester_task::{Criterion, Limit, Load, Stage};

fn four() -> Engine {
    read(template("in-line-4").unwrap().text).engine().unwrap()
}

#[test]
fn limits_and_stages_of_a_command_line() {
    let engine = four();
    let limit = |text| limit(text, &engine, "--limit");
    assert_eq!(limit("couple=5 N m"), Ok(Limit { criterion: Criterion::Peak(Load::Couple), most: 5.0 }));
    assert_eq!(
        limit("force order 1/2 = 0.2 kN"),
        Ok(Limit { criterion: Criterion::Order(Load::Force, 0.5), most: 200.0 })
    );
    for (text, says) in [
        ("couple", "--limit"),
        ("couple = 5 N", "`couple` needs a torque"),
        ("couple = -5 N m", "negative"),
        ("coupel = 5 N m", "no criterion"),
        ("couple = 5", "unit"),
    ] {
        let refused = limit(text).unwrap_err();
        assert!(refused.message.contains(says), "{refused:?}");
    }
    let engine = four();
    let stage = |text| stage(text, &engine, "--minimise");
    assert_eq!(stage("force"), Ok(Stage { terms: vec![(1.0, Criterion::Peak(Load::Force))] }));
    let both = vec![(1.0 / 200.0, Criterion::Peak(Load::Force)), (0.1, Criterion::Peak(Load::Couple))];
    assert_eq!(stage("force = 200 N, couple = 10 N m"), Ok(Stage { terms: both }));
    assert_eq!(stage("force = 200 N"), stage("force"), "one alone is no share of anything");
    assert!(stage("force = 0 N").is_err() && stage("force, couple").is_err());
}

#[test]
fn orders_to_cancel_of_a_command_line() {
    let engine = four();
    let cancel = |text| cancel(text, &engine, "--cancel");
    assert_eq!(cancel("force order 1"), Ok(vec![(Load::Force, 1.0)]));
    assert_eq!(
        cancel("couple order 2,roll moment order 1/2"),
        Ok(vec![(Load::Couple, 2.0), (Load::RollMoment, 0.5)])
    );
    for (text, part) in [
        ("force", "force order 1"),
        ("added mass", "one order of a load"),
        ("bending moment order 1", "one order of a load"),
        ("forse order 1", "did you mean"),
        ("", "criterion"),
        ("force order 1,", "criterion"),
    ] {
        let refused = cancel(text).unwrap_err();
        assert!(format!("{} {}", refused.message, refused.hint).contains(part), "{text}: {refused:?}");
    }
}
