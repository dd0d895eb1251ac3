//! The layouts that everybody builds come first where the search is asked for what they are built for.
use crate::support;
use crate::support::{degrees, explorer, full, space, two};
use lanchester_study::explore::*;

const EVEN: Constraint = Constraint::EvenFiring { tolerance: 0.0 };
const FORCE_1: Objective = Objective::Force { order: 1 };
const FORCE_2: Objective = Objective::Force { order: 2 };
const COUPLE_1: Objective = Objective::Couple { order: 1 };
const COUPLE_2: Objective = Objective::Couple { order: 2 };

/// The first of the ranking, which must be the only kind of its rank.
fn first(explorer: &Explorer) -> (Layout, Candidate) {
    let found = explorer.explore().expect("it runs");
    assert!(found.is_complete());
    let candidate = found.ranking[0].clone();
    (explorer.layout(candidate.case).expect("a case"), candidate)
}

/// Rank of a layout among the kinds that the ranking lists, from 1.
fn rank(explorer: &Explorer, throws: &[i64]) -> Option<usize> {
    let found = explorer.explore().expect("it runs");
    found
        .ranking
        .iter()
        .position(|candidate| {
            let layout = explorer.layout(candidate.case).expect("a case");
            degrees(&layout.throw_angles) == throws
        })
        .map(|place| place + 1)
}

#[test]
fn in_line_three_has_throws_at_120_degrees() {
    // No constraint: throws in steps of 10 degrees, least free force.
    let explorer = explorer(space(3, 36, Banks::InLine, false), &[FORCE_1, FORCE_2], &[]);
    let (layout, candidate) = first(&explorer);
    assert_eq!(degrees(&layout.throw_angles), [0, 120, 240]);
    assert_eq!((candidate.alike, candidate.steps), (1, vec![0, 0]));
}

#[test]
fn in_line_four_is_flat_and_symmetric() {
    // Even firing leaves three cranks; the least couple and then the least bending moment decide.
    let explorer = explorer(
        space(4, 12, Banks::InLine, true),
        &[FORCE_1, COUPLE_1, COUPLE_2, Objective::BendingMoment],
        &[EVEN],
    );
    let found = explorer.explore().expect("it runs");
    let layout = explorer.layout(found.ranking[0].case).expect("a case");
    assert_eq!(degrees(&layout.throw_angles), [0, 180, 180, 0]);
    // 1-3-4-2 is 1-2-4-3 from the other side: one case.
    assert_eq!(found.ranking[0].alike, 1);
    let order = layout.firing_order().expect("it fires");
    assert!(order == [1, 3, 4, 2] || order == [1, 2, 4, 3], "{order:?}");
    assert_eq!(found.ranking.len(), 3, "even firing leaves three cranks: {:?}", found.ranking);
}

#[test]
fn in_line_five_fires_1_2_4_5_3_for_the_least_primary_couple() {
    let space = space(5, 5, Banks::InLine, true);
    let primary = explorer(space.clone(), &[COUPLE_1, COUPLE_2], &[EVEN]);
    let (layout, candidate) = first(&primary);
    let order = layout.firing_order().expect("it fires");
    assert!(order == [1, 2, 4, 5, 3] || order == [1, 3, 5, 4, 2], "{order:?}");
    // Primary couple 0.449 and secondary couple 4.980 times force and spacing (any handbook).
    let parts = support::parts();
    let force = parts.reciprocating_mass() * parts.crank_radius * parts.speed.powi(2);
    let rotating =
        (parts.throw_unbalance + parts.rod_big_end_mass * parts.crank_radius) * parts.speed.powi(2);
    let primary_couple = candidate.values[0] / (0.1 * (force + rotating));
    assert!((primary_couple - 0.449).abs() < 5e-4, "{primary_couple}");
    let a2 = lanchester_mechanism::exact_coefficients(0.045, 0.15, 0.0, 2).expect("it turns")[2].re;
    let secondary_couple = candidate.values[1] / (0.1 * force * a2);
    assert!((secondary_couple - 4.980).abs() < 5e-4, "{secondary_couple}");
    // The least secondary couple is another crank.
    let (other, _) = first(&explorer(space, &[COUPLE_2, COUPLE_1], &[EVEN]));
    assert_ne!(degrees(&other.throw_angles), degrees(&layout.throw_angles));
}

#[test]
fn in_line_six_is_symmetric_about_its_middle() {
    let explorer =
        explorer(space(6, 12, Banks::InLine, true), &[FORCE_1, COUPLE_1, FORCE_2, COUPLE_2], &[EVEN]);
    let (layout, candidate) = first(&explorer);
    assert_eq!(degrees(&layout.throw_angles), [0, 120, 240, 240, 120, 0]);
    assert_eq!(candidate.steps, [0; 4]);
    // Four firings that are not one another from another side: 1-5-3-6-2-4 and three more.
    assert_eq!(candidate.alike, 4);
}

#[test]
fn v6_of_90_degrees_needs_30_degrees_between_its_pins() {
    let splits: Vec<f64> = (-6..=6).map(|k| 10.0 * f64::from(k)).collect();
    let mut space = space(6, 12, two(&[90.0], &splits, &[0.02]), true);
    space.counterweights = vec![full()];
    let overlap = Constraint::PinOverlap { least: 0.0 };
    let explorer = explorer(space, &[FORCE_1, FORCE_2, COUPLE_1], &[EVEN, overlap]);
    let (layout, _) = first(&explorer);
    let pair = layout.banks.expect("two banks");
    assert_eq!(pair.split_angle.to_degrees().round(), -30.0);
    let mut throws = degrees(&layout.throw_angles);
    throws.sort_unstable();
    assert_eq!(throws, [0, 120, 240]);
    // No other split fires evenly at all.
    let found = explorer.explore().expect("it runs");
    for candidate in &found.ranking {
        let split = explorer.layout(candidate.case).expect("a case").banks.expect("two banks").split_angle;
        assert_eq!(split.to_degrees().round(), -30.0);
    }
}

#[test]
fn v8_of_90_degrees_has_a_crossplane_crank() {
    // What crank weights cannot remove: second order, and the first-order couple against the crank.
    let backward = Objective::CoupleSense { order: 1, sense: Sense::Backward };
    let objectives = [FORCE_2, backward, COUPLE_2, FORCE_1, COUPLE_1];
    let explorer = explorer(space(8, 8, two(&[90.0], &[0.0], &[0.0]), true), &objectives, &[EVEN]);
    let found = explorer.explore().expect("it runs");
    let layout = explorer.layout(found.ranking[0].case).expect("a case");
    assert_eq!(degrees(&layout.throw_angles), [0, 90, 270, 180]);
    let candidate = &found.ranking[0];
    assert_eq!(candidate.steps[..4], [0; 4], "{candidate:?}");
    assert!(candidate.values[4] > 0.0);
    // The flat-plane crank keeps its second-order force; it leads where the first-order couple counts most.
    assert_eq!(rank(&explorer, &[0, 180, 180, 0]).map(|rank| rank > 1), Some(true));
    let flat =
        support::explorer(space(8, 8, two(&[90.0], &[0.0], &[0.0]), true), &[COUPLE_1, FORCE_2], &[EVEN]);
    assert_eq!(degrees(&first(&flat).0.throw_angles), [0, 180, 180, 0]);
}

#[test]
fn a_boxer_four_has_opposite_pins() {
    let banks = two(&[180.0], &[0.0, 60.0, 120.0, 180.0, 240.0, 300.0], &[0.04]);
    let explorer = explorer(space(4, 12, banks, true), &[FORCE_1, FORCE_2, COUPLE_1], &[EVEN]);
    let (layout, candidate) = first(&explorer);
    assert_eq!(layout.banks.expect("two banks").split_angle.to_degrees().round(), 180.0);
    assert_eq!(degrees(&layout.throw_angles), [0, 180]);
    assert_eq!(candidate.steps[..2], [0, 0]);
}
