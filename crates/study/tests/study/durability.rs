//! Limits on films: told for few layouts, as though they were told for all.

use crate::support::{explorer, space, two};
use lanchester_model::Engine;
use lanchester_study::explore::*;
use lanchester_task::{AtLeast, DurabilityCriterion, DurabilityMeter, Measured};
use std::sync::Arc;

const OBJECTIVES: [Objective; 2] = [Objective::Force { order: 1 }, Objective::Couple { order: 1 }];

/// A film that throws across the first one make thick: that of a flat crank, which the loads on the block prefer, is none.
struct ByAngle;

fn film(engine: &Engine) -> f64 {
    engine.throws.iter().map(|throw| throw.angle.sin().abs()).sum::<f64>() * 1e-6
}

impl DurabilityMeter for ByAngle {
    fn measure(&self, engine: &Engine, criteria: &[DurabilityCriterion]) -> Vec<Measured> {
        let known = Measured::Known {
            value: film(engine),
            place: String::new(),
            speed: engine.speed.highest,
            left_out: String::new(),
        };
        vec![known; criteria.len()]
    }
}

fn limited(least: f64, most: u64, firing: bool) -> Explorer {
    let plain = explorer(space(4, 8, two(&[90.0], &[0.0], &[0.0]), firing), &OBJECTIVES, &[]);
    let plain = if firing { plain } else { explorer(space(4, 8, Banks::InLine, false), &OBJECTIVES, &[]) };
    let at_least = vec![AtLeast { criterion: DurabilityCriterion::LeastFilm, least }];
    let request = ExploreRequest { at_least, ..plain.request().clone() };
    Explorer::new(request).expect("a search").with_meter(LayoutMeter::new(Arc::new(ByAngle), most))
}

#[test]
fn the_front_is_that_of_all_layouts_that_hold_the_limit() {
    for firing in [false, true] {
        let search = limited(0.9e-6, u64::MAX, firing);
        let found = search.explore().expect("it runs");
        assert!(
            search.measured_layouts() < search.size() as u64,
            "{} of {}",
            search.measured_layouts(),
            search.size()
        );
        // By brute force: every judged case, its film, and nothing that covers it.
        let free = explorer(search.request().space.clone(), &OBJECTIVES, &[]);
        let mut cases: Vec<(u128, Vec<i64>)> = Vec::new();
        free.look(Run { from: 0, to: free.size() }, &mut |case, values| {
            let engine = free.layout(case).unwrap().engine(&free.request().space.parts).unwrap();
            if film(&engine) >= 0.9e-6 {
                cases.push((case, free.steps(values)));
            }
        })
        .expect("it runs");
        let covered = |steps: &Vec<i64>| {
            cases.iter().any(|(_, other)| other != steps && other.iter().zip(steps).all(|(a, b)| a <= b))
        };
        let mut front: Vec<(u128, u128)> = Vec::new();
        for (case, steps) in cases.iter().filter(|(_, steps)| !covered(steps)) {
            let kind: Vec<&(u128, Vec<i64>)> = cases.iter().filter(|(_, other)| other == steps).collect();
            if kind[0].0 == *case {
                front.push((*case, kind.len() as u128));
            }
        }
        let mut own: Vec<(u128, u128)> = found.front.iter().map(|one| (one.case, one.alike)).collect();
        own.sort_unstable();
        front.sort_unstable();
        assert_eq!(own, front, "firing {firing}");
        assert!(!own.is_empty());
        let free_front = free.explore().expect("it runs").front;
        assert_ne!(
            free_front.iter().map(|one| one.case).collect::<Vec<_>>(),
            found.front.iter().map(|one| one.case).collect::<Vec<_>>()
        );
    }
}

#[test]
fn it_does_not_matter_how_the_cases_are_cut() {
    let whole = limited(0.9e-6, u64::MAX, true).explore().expect("it runs");
    let search = limited(0.9e-6, u64::MAX, true);
    let third = search.size() / 3;
    let look = |from: u128, to: u128| search.look(Run { from, to }, &mut |_, _| ()).expect("it runs");
    let parts = [look(0, third), look(third, 2 * third + 1), look(2 * third + 1, search.size())];
    let joined = parts.into_iter().reduce(|one, other| search.merge(one, other).expect("they fit")).unwrap();
    assert_eq!(joined.front, whole.front);
    assert_eq!(joined.ranking, whole.ranking);
    assert_eq!(joined.counts, whole.counts);
}

#[test]
fn too_many_and_nobody_are_refused() {
    let search = limited(0.9e-6, 3, false);
    assert_eq!(search.explore(), Err(ExploreError::TooManyMeasured { most: 3 }));
    let request = limited(1e-6, 3, false).request().clone();
    assert_eq!(Explorer::new(request).expect("a search").explore(), Err(ExploreError::NoMeter));
}

#[test]
fn found_layouts_tell_what_is_asked_for() {
    let search = limited(0.9e-6, u64::MAX, false);
    let found = search.explore().expect("it runs");
    let mut answer = search.answer(&found, "four", Vec::new()).expect("it is its own");
    assert_eq!(answer.at_least, ["least film at least 0.9 um"]);
    search.tell_durability(&mut answer, &[DurabilityCriterion::LeastFilm], 1).expect("somebody tells");
    assert!(answer.front[0].durability[0].value().is_some_and(|film| film >= 0.9e-6));
    assert!(answer.front.iter().skip(1).all(|found| found.durability.is_empty()));
}
