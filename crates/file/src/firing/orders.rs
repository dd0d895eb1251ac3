//! The orders that a crank can fire, the most even first.

use super::angle::{SAME, whole};
use lanchester_model::Strokes;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Orders that a message lists at most.
pub(super) const MOST_LISTED: usize = 8;

/// More dead centres than this are not worth a list (the search grows with their square).
const MOST_DEAD_CENTRES: usize = 48;

/// Cylinders that come to top dead centre at one angle.
struct Together {
    angle: f64,
    cylinders: Vec<usize>,
}

/// How the dead centres passed so far are spread over the two revolutions of a four-stroke cycle.
#[derive(Clone)]
struct Spread {
    /// Sum of squared intervals within each revolution.
    cost: f64,
    /// For each dead centre, whether its lone cylinder fires in the second revolution.
    second: Vec<bool>,
}

/// Place of the last firing in revolution 1, and of the first and the last in revolution 2.
type Ends = (usize, Option<(usize, usize)>);

/// Orders that start with cylinder `first`, by evenness, at most [`MOST_LISTED`]; if more cylinders come to top dead
/// centre together than the cycle has revolutions, these cylinders. None are listed above [`MOST_DEAD_CENTRES`].
pub(super) fn orders(strokes: Strokes, tops: &[f64], first: usize) -> Result<Vec<Vec<usize>>, Vec<usize>> {
    let revolutions = strokes.revolutions() as usize;
    let groups = dead_centres(tops, first);
    if let Some(group) = groups.iter().find(|group| group.cylinders.len() > revolutions) {
        return Err(group.cylinders.clone());
    }
    if revolutions == 1 {
        return Ok(vec![groups.iter().map(|group| group.cylinders[0]).collect()]);
    }
    let mut orders = Vec::new();
    if groups.len() > MOST_DEAD_CENTRES {
        return Ok(orders);
    }
    for spread in most_even_spreads(&groups) {
        expand(&groups, &spread, &mut orders);
        if orders.len() >= MOST_LISTED {
            break;
        }
    }
    Ok(orders)
}

/// Dead centres by angle after that of cylinder `first`, which leads its group; the others by number.
fn dead_centres(tops: &[f64], first: usize) -> Vec<Together> {
    let mut angles: Vec<(f64, usize)> =
        tops.iter().enumerate().map(|(index, top)| (whole(top - tops[first - 1]), index + 1)).collect();
    angles.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1 != first).cmp(&(b.1 != first))).then(a.1.cmp(&b.1)));
    let mut groups: Vec<Together> = Vec::new();
    for (angle, number) in angles {
        match groups.last_mut() {
            Some(group) if angle - group.angle < SAME => group.cylinders.push(number),
            _ => groups.push(Together { angle, cylinders: vec![number] }),
        }
    }
    groups
}

/// The spreads with the least sums of squared intervals.
///
/// Dead centre by dead centre, keeping the best few for each way in which the revolutions may end: what comes later
/// depends on nothing else, so none of the best is lost.
fn most_even_spreads(groups: &[Together]) -> Vec<Spread> {
    let interval = |from: usize, to: usize| (groups[to].angle - groups[from].angle).powi(2);
    let start: Ends = (0, (groups[0].cylinders.len() == 2).then_some((0, 0)));
    let mut states: BTreeMap<Ends, Vec<Spread>> = BTreeMap::new();
    states.insert(start, vec![Spread { cost: 0.0, second: vec![false] }]);
    for place in 1..groups.len() {
        let mut next: BTreeMap<Ends, Vec<Spread>> = BTreeMap::new();
        let pair = groups[place].cylinders.len() == 2;
        for (&(one, two), spreads) in &states {
            for second in [false, true] {
                if pair && second {
                    continue;
                }
                let (in_one, in_two) = (pair || !second, pair || second);
                let mut added = 0.0;
                let mut ends = (one, two);
                if in_one {
                    added += interval(one, place);
                    ends.0 = place;
                }
                if in_two {
                    added += two.map_or(0.0, |(_, last)| interval(last, place));
                    ends.1 = Some((two.map_or(place, |(from, _)| from), place));
                }
                let grown = spreads.iter().map(|spread| {
                    let mut spread = spread.clone();
                    spread.cost += added;
                    spread.second.push(second);
                    spread
                });
                next.entry(ends).or_default().extend(grown);
            }
        }
        for spreads in next.values_mut() {
            keep_best(spreads);
        }
        states = next;
    }
    let mut complete: Vec<Spread> = Vec::new();
    // Where all of revolution 2 lies after all of revolution 1, the order is that of the dead centres, wherever the
    // revolutions part: one order, of which the most even spread stands for all.
    let mut rising: Vec<Spread> = Vec::new();
    for ((one, two), spreads) in states {
        let left_in_one = TAU - groups[one].angle;
        let closing = match two {
            Some((from, last)) => {
                (left_in_one + groups[from].angle).powi(2) + (TAU - groups[last].angle).powi(2)
            }
            None => (left_in_one + TAU).powi(2),
        };
        let kept = if two.is_none_or(|(from, _)| one < from) { &mut rising } else { &mut complete };
        kept.extend(spreads.into_iter().map(|spread| Spread { cost: spread.cost + closing, ..spread }));
    }
    keep_best(&mut rising);
    complete.extend(rising.into_iter().next());
    keep_best(&mut complete);
    complete
}

fn keep_best(spreads: &mut Vec<Spread>) {
    spreads.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    spreads.truncate(MOST_LISTED);
}

/// The orders of one spread: each pair but the first cylinder's may fire either way round.
fn expand(groups: &[Together], spread: &Spread, orders: &mut Vec<Vec<usize>>) {
    let pairs: Vec<usize> = (1..groups.len()).filter(|&place| groups[place].cylinders.len() == 2).collect();
    let room = MOST_LISTED.saturating_sub(orders.len());
    let ways =
        u32::try_from(pairs.len()).ok().and_then(|count| 2_usize.checked_pow(count)).unwrap_or(usize::MAX);
    for way in 0..ways.min(room) {
        let swapped = |place: usize| {
            pairs.iter().rev().position(|&pair| pair == place).is_some_and(|bit| way >> bit & 1 == 1)
        };
        let mut revolutions = [Vec::new(), Vec::new()];
        for (place, group) in groups.iter().enumerate() {
            match group.cylinders[..] {
                [one, two] => {
                    let (one, two) = if swapped(place) { (two, one) } else { (one, two) };
                    revolutions[0].push(one);
                    revolutions[1].push(two);
                }
                _ => revolutions[usize::from(spread.second[place])].extend(&group.cylinders),
            }
        }
        orders.push(revolutions.concat());
    }
}
