use super::*;
use proptest::prelude::*;

fn tops(degrees: &[f64]) -> Vec<f64> {
    degrees.iter().map(|angle| angle.to_radians()).collect()
}

fn fired(strokes: Strokes, degrees: &[f64], order: &[usize]) -> Vec<f64> {
    let angles = assign(strokes, &tops(degrees), order).unwrap();
    angles.iter().map(|angle| (angle.to_degrees() * 1e3).round() / 1e3).collect()
}

#[test]
fn in_line_four_in_both_its_orders() {
    let crank = [0.0, 180.0, 180.0, 0.0];
    assert_eq!(fired(Strokes::Four, &crank, &[1, 3, 4, 2]), [0.0, 540.0, 180.0, 360.0]);
    assert_eq!(fired(Strokes::Four, &crank, &[1, 2, 4, 3]), [0.0, 180.0, 540.0, 360.0]);
    // The same cycle written from another cylinder on.
    assert_eq!(fired(Strokes::Four, &crank, &[2, 1, 3, 4]), [360.0, 180.0, 540.0, 0.0]);
}

#[test]
fn impossible_order_names_the_cylinder_and_lists_the_others() {
    let problem = assign(Strokes::Four, &tops(&[0.0, 180.0, 180.0, 0.0]), &[1, 4, 3, 2]).unwrap_err();
    assert_eq!(problem.key, "firing.order");
    assert_eq!(
        problem.message,
        "cylinder 2 cannot fire after cylinder 3: it comes to top dead centre no more in this cycle"
    );
    assert_eq!(problem.hint.as_deref(), Some("this crank can fire, most evenly first, 1-2-4-3, 1-3-4-2"));
}

#[test]
fn crossplane_v8_has_eight_orders() {
    let crank = tops(&[0.0, 270.0, 90.0, 180.0, 90.0, 0.0, 180.0, 270.0]);
    let orders = orders::orders(Strokes::Four, &crank, 1).unwrap();
    assert_eq!(orders.len(), 8);
    assert!(orders.contains(&vec![1, 5, 4, 2, 6, 3, 7, 8]), "{orders:?}");
    for order in &orders {
        assert!(assign(Strokes::Four, &crank, order).is_ok(), "{order:?}");
    }
}

#[test]
fn two_strokes_cannot_fire_two_at_once() {
    let problem = assign(Strokes::Two, &tops(&[0.0, 0.0]), &[1, 2]).unwrap_err();
    assert_eq!(
        problem.hint.as_deref(),
        Some(
            "no order fits this crank: cylinders 1 and 2 come to top dead centre together; firing.angles can say so"
        )
    );
}

#[test]
fn permutation_faults_are_named() {
    let problem = assign(Strokes::Four, &tops(&[0.0; 3]), &[1, 1, 0]).unwrap_err();
    assert_eq!(
        problem.message,
        "the firing order needs each cylinder once: there is no cylinder 0, cylinder 1 fires 2 times, \
         cylinder 2 is missing, cylinder 3 is missing"
    );
}

#[test]
fn dead_centre_with_offset_and_turning_backwards() {
    // Crank and rod in one line: the pin at (r + l) e^{i phi} must lie on the line at distance e from the axis.
    let (offset, reach) = (0.02, 0.2);
    let theta = nominal_top(1.0, 0.3, 0.5, offset, Some(reach));
    let phi = theta + 0.3 - 0.5;
    assert!((reach * phi.sin() - offset).abs() < 1e-15);
    let theta = nominal_top(-1.0, 0.3, 0.5, 0.0, None);
    assert!((-theta + 0.3 - 0.5).rem_euclid(TAU) < 1e-12, "{theta}");
    assert_eq!(nominal_top(1.0, 0.5, 0.5 - 1e-16, 0.0, None), 0.0);
}

#[test]
fn forty_eight_cylinders_come_to_an_end() {
    // Trying all 2^48 choices of a turn would not.
    let count = 48;
    let degrees: Vec<f64> = (0..count).map(|k| f64::from(k) * 7.5 + 0.01 * f64::from(k * k % 7)).collect();
    let order: Vec<usize> = (0..48).map(|k| (k * 5) % 48 + 1).collect();
    let problem = assign(Strokes::Four, &tops(&degrees), &order).unwrap_err();
    assert_eq!(problem.hint.unwrap().matches(", ").count(), MOST_LISTED + 1);
}

/// Sum of squared intervals of the cylinders of `order`, or `None` if the angles do not rise within the cycle.
fn unevenness(angles: &[f64], cycle: f64) -> Option<f64> {
    let mut cost = 0.0;
    for (k, &angle) in angles.iter().enumerate() {
        let next = angles.get(k + 1).copied().unwrap_or(angles[0] + cycle);
        if next - angle < SAME {
            return None;
        }
        cost += (next - angle).powi(2);
    }
    Some(cost)
}

/// Every way to spread the dead centres over two revolutions, by trying all of them.
fn by_exhaustion(tops: &[f64]) -> Vec<(f64, Vec<usize>)> {
    let relative: Vec<f64> = tops.iter().map(|top| whole(top - tops[0])).collect();
    let mut found = Vec::new();
    for choice in 0..1_usize << (tops.len() - 1) {
        let mut firings: Vec<(f64, usize)> = relative
            .iter()
            .enumerate()
            .map(|(k, top)| (top + TAU * f64::from(u8::from(k > 0 && choice >> (k - 1) & 1 == 1)), k + 1))
            .collect();
        firings.sort_by(|a, b| a.0.total_cmp(&b.0));
        let angles: Vec<f64> = firings.iter().map(|&(angle, _)| angle).collect();
        if firings[0].1 == 1
            && let Some(cost) = unevenness(&angles, 2.0 * TAU)
        {
            found.push((cost, firings.iter().map(|&(_, number)| number).collect()));
        }
    }
    // One order may come of several spreads: the most even counts.
    found.sort_by(|a: &(f64, Vec<usize>), b| a.1.cmp(&b.1).then(a.0.total_cmp(&b.0)));
    found.dedup_by(|later, earlier| later.1 == earlier.1);
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}

/// Dead centres on a grid of 30 degrees (so that pairs occur), one to eight cylinders.
fn any_tops() -> impl Strategy<Value = Vec<f64>> {
    proptest::collection::vec((0..12_u32).prop_map(|k| f64::from(k) * TAU / 12.0), 1..9)
}

proptest! {
    #[test]
    fn prop_listed_orders_are_the_most_even_of_all(tops in any_tops()) {
        let all = by_exhaustion(&tops);
        match orders::orders(Strokes::Four, &tops, 1) {
            Err(together) => {
                prop_assert!(together.len() > 2);
                prop_assert!(all.is_empty());
            }
            Ok(listed) => {
                // A spread with pairs may expand to some of its orders only: never fewer than fit in the list.
                prop_assert_eq!(listed.len(), all.len().min(MOST_LISTED));
                for (place, order) in listed.iter().enumerate() {
                    let cost = all.iter().find(|(_, other)| other == order).map(|(cost, _)| *cost);
                    // Equal costs may come in any order; 1e-9 covers the rounding of different sums.
                    prop_assert!(cost.is_some_and(|cost| (cost - all[place].0).abs() < 1e-9), "{:?}", order);
                    prop_assert!(assign(Strokes::Four, &tops, order).is_ok());
                }
            }
        }
    }

    #[test]
    fn prop_assign_takes_the_most_even_choice(tops in any_tops(), pick in 0..256_usize) {
        let all = by_exhaustion(&tops);
        prop_assume!(!all.is_empty());
        let order = &all[pick % all.len()].1;
        let best = all.iter().find(|(_, other)| other == order).map(|(cost, _)| *cost).unwrap();
        let fired = assign(Strokes::Four, &tops, order).unwrap();
        let start = fired[order[0] - 1];
        let angles: Vec<f64> =
            order.iter().map(|&number| (fired[number - 1] - start).rem_euclid(2.0 * TAU)).collect();
        let cost = unevenness(&angles, 2.0 * TAU).unwrap();
        prop_assert!((cost - best).abs() < 1e-9, "{} {}", cost, best);
        for (fired, top) in fired.iter().zip(&tops) {
            prop_assert!(whole(fired - top) < 1e-9);
        }
    }
}
