//! The search itself: numbers and cases, cutting and merging, counts, fronts, refusals.
use crate::support;
use crate::support::{bare, explorer, full, space, two};
use lanchester_study::explore::*;
use proptest::prelude::*;

const LOADS: [Objective; 4] = [
    Objective::Force { order: 1 },
    Objective::Couple { order: 1 },
    Objective::Force { order: 2 },
    Objective::BendingMoment,
];

/// A space in which every choice has several values, some of them no engine.
fn rich() -> Space {
    let mut space = space(6, 6, two(&[60.0, 90.0], &[0.0, -30.0], &[0.02]), true);
    space.spacings = vec![0.1, 0.06, 0.07, 0.11];
    space.rod_ratios = vec![0.3, 1.2];
    space.counterweights = vec![bare(), full()];
    space
}

#[test]
fn number_and_case_determine_each_other() {
    let explorer = explorer(rich(), &LOADS, &[]);
    assert_eq!(explorer.size(), 4 * 2 * 2 * 2 * 2 * 36 * 32);
    for case in (0..explorer.size()).step_by(61) {
        let layout = explorer.layout(case).expect("a case");
        assert_eq!(explorer.case_of(&layout), Some(case), "{layout:?}");
    }
    assert!(matches!(explorer.layout(explorer.size()), Err(ExploreError::NoSuchCase { .. })));
}

#[test]
fn every_case_is_accounted_for() {
    let constraints = [
        Constraint::EvenFiring { tolerance: 0.0 },
        Constraint::BearingRoom { least: 0.04 },
        Constraint::AtMost { objective: Objective::Couple { order: 1 }, limit: 1200.0 },
    ];
    let explorer = explorer(rich(), &LOADS, &constraints);
    let counts = explorer.explore().expect("it runs").counts;
    let broken: u128 = counts.broken.iter().map(|b| b.cases).sum();
    let invalid: u128 = counts.invalid.iter().map(|i| i.cases).sum();
    assert_eq!(counts.cases, explorer.size());
    assert_eq!(counts.cases, counts.judged + counts.duplicates + broken + invalid);
    // Half of all by the rod; of the rest one spacing for the webs and one for the bores; then one for the bearings.
    let eighth = explorer.size() / 8;
    let reasons: Vec<_> = counts.invalid.iter().map(|i| (i.reason, i.cases)).collect();
    assert_eq!(
        reasons,
        [(Invalid::RodTooShort, 4 * eighth), (Invalid::WebsOverlap, eighth), (Invalid::BoresOverlap, eighth)]
    );
    assert_eq!(counts.broken[1].cases, eighth);
    assert!(counts.judged > 0 && counts.broken[0].cases > 0 && counts.broken[2].cases > 0, "{counts:?}");
}

/// The front and ranking by their definitions.
fn brute(explorer: &Explorer) -> (Vec<Vec<i64>>, Vec<Vec<i64>>) {
    let mut all: Vec<Vec<i64>> = Vec::new();
    for case in 0..explorer.size() {
        let mut one = explorer.start();
        explorer.run(&mut one, Run { from: case, to: case + 1 }).expect("it runs");
        all.extend(one.front.into_iter().map(|candidate| candidate.steps));
    }
    all.sort();
    all.dedup();
    let beaten = |a: &Vec<i64>| all.iter().any(|b| b != a && b.iter().zip(a).all(|(b, a)| b <= a));
    let front = all.iter().filter(|a| !beaten(a)).cloned().collect();
    all.truncate(explorer.request().most_listed);
    (front, all)
}

#[test]
fn front_and_ranking_are_what_their_names_say() {
    let mut space = space(5, 8, Banks::InLine, false);
    space.counterweights = vec![bare(), full()];
    let objectives = [&LOADS[1..], &[Objective::CounterweightUnbalance]].concat();
    let explorer = explorer(space, &objectives, &[]);
    let found = explorer.explore().expect("it runs");
    let (front, ranking) = brute(&explorer);
    let steps = |list: &[Candidate]| list.iter().map(|c| c.steps.clone()).collect::<Vec<_>>();
    assert_eq!(steps(&found.front), front);
    assert_eq!(steps(&found.ranking), ranking);
    assert!(front.len() > 3, "{front:?}");
}

#[test]
fn any_number_of_threads_finds_the_same() {
    let explorer = explorer(rich(), &LOADS, &[]);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| explorer.explore()).expect("it runs")
    };
    let one = with(1);
    for threads in [2, 3, 7] {
        assert_eq!(with(threads), one);
    }
}

#[test]
fn parts_cover_all_and_merge_to_the_whole() {
    let explorer = explorer(rich(), &LOADS, &[Constraint::EvenFiring { tolerance: 0.01 }]);
    let whole = explorer.explore().expect("it runs");
    let parts: Vec<Exploration> = (1..=7)
        .map(|k| {
            let mut part = explorer.start();
            explorer.run(&mut part, explorer.part(k, 7).expect("a part")).expect("it runs");
            part
        })
        .collect();
    let merged =
        parts.iter().rev().cloned().reduce(|a, b| explorer.merge(a, b).expect("parts")).expect("seven");
    assert_eq!(merged, whole);
    assert_eq!(
        explorer.merge(whole.clone(), parts[0].clone()),
        Err(ExploreError::Merge { reason: "both have looked at the same cases" })
    );
    assert!(matches!(explorer.part(8, 7), Err(ExploreError::Part { .. })));
}

#[test]
fn a_run_that_was_stopped_goes_on_from_its_text() {
    let explorer = explorer(rich(), &LOADS, &[]);
    let mut run = explorer.start();
    while let Some(next) = run.next() {
        explorer.run(&mut run, Run { to: next.to.min(next.from + 7001), ..next }).expect("it runs");
        let text = serde_json::to_string(&run).expect("plain data");
        run = serde_json::from_str(&text).expect("plain data");
    }
    assert_eq!(run, explorer.explore().expect("it runs"));
}

#[test]
fn a_space_that_is_too_large_says_why() {
    let space = space(32, 360, Banks::InLine, true);
    let error = space.size(1_000_000).expect_err("too large");
    // 360^31 * 2^31.
    assert_eq!(
        error.to_string(),
        "the search space has about 10^88.6 cases, more than the 1000000 that may be looked at: the list of throw \
         angles alone makes about 10^79.2 of them\nhint: give that choice fewer values, or allow more cases"
    );
    let space = support::space(4, 360, Banks::InLine, true);
    assert_eq!(space.size(u128::MAX).expect("countable"), 360u128.pow(3) * 8);
    let error = space.size(1000).expect_err("too large").to_string();
    assert!(error.contains("has 373248000 cases") && error.contains("makes 46656000 of them"), "{error}");
}

#[test]
fn an_empty_space_says_which_choice_or_constraint_empties_it() {
    let mut empty = space(4, 4, Banks::InLine, true);
    empty.rod_ratios.clear();
    assert_eq!(empty.size(1000), Err(ExploreError::EmptyChoice { choice: Choice::RodRatio }));
    // An in-line four with throws at 120 degrees cannot fire evenly.
    let uneven =
        explorer(space(4, 3, Banks::InLine, true), &LOADS, &[Constraint::EvenFiring { tolerance: 0.0 }]);
    let counts = uneven.explore().expect("it runs").counts;
    assert_eq!(counts.judged, 0);
    let words = counts.emptied_by().expect("nothing is left");
    assert!(words.contains("`even firing within 0 deg`"), "{words}");
    let mut short = space(4, 4, Banks::InLine, true);
    short.rod_ratios = vec![1.0, 1.5];
    let words = explorer(short, &LOADS, &[])
        .explore()
        .expect("it runs")
        .counts
        .emptied_by()
        .expect("nothing is left");
    assert_eq!(words, "none of the 1024 cases is an engine: the rod is not longer than the crank radius");
}

#[test]
fn bad_requests_are_refused_with_what_was_needed() {
    let size = |change: &dyn Fn(&mut Space)| {
        let mut bad = space(4, 4, two(&[90.0], &[0.0], &[0.02]), false);
        change(&mut bad);
        bad.size(1_000_000)
    };
    assert!(matches!(size(&|s| s.cylinders = 5), Err(ExploreError::Cylinders { banks: 2, .. })));
    assert!(matches!(size(&|s| s.cylinders = 0), Err(ExploreError::Cylinders { .. })));
    assert!(matches!(
        size(&|s| s.spacings = vec![0.1, 0.1]),
        Err(ExploreError::RepeatedValue { place: 2, .. })
    ));
    assert!(matches!(
        size(&|s| s.throw_angles.push(std::f64::consts::TAU)),
        Err(ExploreError::RepeatedValue { .. })
    ));
    assert!(matches!(size(&|s| s.rod_ratios = vec![f64::NAN]), Err(ExploreError::Number { .. })));
    assert!(matches!(size(&|s| s.banks = two(&[190.0], &[0.0], &[0.0])), Err(ExploreError::Number { .. })));
    assert!(matches!(size(&|s| s.parts.crank_radius = 0.0), Err(ExploreError::Number { .. })));
    assert!(matches!(
        size(&|s| s.counterweights[0].webs = Some(vec![true])),
        Err(ExploreError::Webs { needed: 4, .. })
    ));
    let new = |objectives: Vec<Objective>, constraints: Vec<Constraint>| {
        Explorer::new(ExploreRequest::new(space(4, 4, Banks::InLine, false), objectives, constraints))
            .map(|_| ())
    };
    assert_eq!(new(vec![], vec![]), Err(ExploreError::NoObjective));
    assert!(matches!(
        new(vec![Objective::FiringUnevenness], vec![]),
        Err(ExploreError::FiringLeftOut { .. })
    ));
    assert!(matches!(new(vec![Objective::Force { order: 3 }], vec![]), Err(ExploreError::Number { .. })));
    let even = Constraint::EvenFiring { tolerance: 0.0 };
    assert!(matches!(new(vec![Objective::Shafts], vec![even]), Err(ExploreError::FiringLeftOut { .. })));
    let mut request = ExploreRequest::new(space(6, 12, Banks::InLine, false), LOADS.to_vec(), vec![]);
    request.most_on_front = 2;
    let explorer = Explorer::new(request).expect("a search");
    let mut run = explorer.start();
    assert_eq!(
        explorer.run(&mut run, Run { from: 0, to: explorer.size() }),
        Err(ExploreError::FrontTooLarge { most: 2 })
    );
    assert_eq!(run, explorer.start(), "a run that fails leaves what was known");
}

#[test]
fn shafts_remove_what_they_are_for() {
    let both = |order, sense| ShaftDesign {
        order,
        sense,
        x: 0.0,
        y: 0.0,
        removes: Removes::Both { z: [-0.1, 0.1] },
    };
    let mut space = space(3, 36, Banks::InLine, false);
    space.shafts = vec![
        ShaftSet::default(),
        ShaftSet { name: "first".into(), shafts: vec![both(1, Sense::Backward), both(1, Sense::Forward)] },
    ];
    let explorer = explorer(
        space,
        &[Objective::Shafts, Objective::Force { order: 1 }, Objective::Couple { order: 1 }],
        &[],
    );
    let found = explorer.explore().expect("it runs");
    let with = found.front.iter().find(|c| c.values[0] == 2.0).expect("shafts pay");
    assert_eq!(with.steps[1..], [0, 0]);
    let without = found.front.iter().find(|c| c.values[0] == 0.0).expect("none is cheaper");
    assert!(without.values[2] > 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Cut anywhere, in any order: always the same.
    #[test]
    fn prop_cuts_do_not_matter(cuts in prop::collection::vec(0.0..1.0f64, 0..6), backwards in any::<bool>()) {
        let explorer = explorer(rich(), &LOADS, &[Constraint::EvenFiring { tolerance: 0.6 }]);
        let mut at: Vec<u128> = cuts.iter().map(|cut| (cut * explorer.size() as f64) as u128).collect();
        at.extend([0, explorer.size()]);
        at.sort_unstable();
        let mut runs: Vec<Run> = at.windows(2).map(|pair| Run { from: pair[0], to: pair[1] }).collect();
        if backwards {
            runs.reverse();
        }
        let mut found = explorer.start();
        for run in runs {
            explorer.run(&mut found, run).expect("it runs");
        }
        prop_assert_eq!(found, explorer.explore().expect("it runs"));
    }
}
