//! Levels along z.

/// Growth from layer to layer.
pub(super) const GROWTH: f64 = 1.5;
/// A plane takes the place of a level that is nearer than this [m].
const NEAR: f64 = 0.4e-3;
/// Levels nearer than this are one [m].
const SAME: f64 = 1e-7;

/// Levels from 0 to `length`, both included: `layers` within the fillet radius at an end that has one, growing after to `size`.
pub(super) fn levels(length: f64, fillets: [f64; 2], layers: usize, size: f64) -> Vec<f64> {
    let mut ends: [Vec<f64>; 2] = [vec![0.0], vec![0.0]];
    for (end, fillet) in ends.iter_mut().zip(fillets) {
        if fillet > 0.0 {
            end.extend((1..=layers).map(|k| fillet * k as f64 / layers as f64));
        }
    }
    let last = |end: &[f64]| end[end.len() - 1];
    let mut step = fillets.map(|fillet| if fillet > 0.0 { GROWTH * fillet / layers as f64 } else { size });
    loop {
        let rest = length - last(&ends[0]) - last(&ends[1]);
        // The finer side grows first.
        let side = usize::from(step[1] < step[0]);
        if step[side] >= size || rest < 2.5 * step[side] {
            let count = ((rest / step[side].min(size)).round() as usize).max(usize::from(rest > 1e-9));
            let from = last(&ends[0]);
            let mut all = ends[0].clone();
            all.extend((1..count).map(|k| from + rest * k as f64 / count as f64));
            let rear = ends[1].iter().rev().map(|depth| length - depth);
            all.extend(rear.skip(usize::from(count == 0)));
            return all;
        }
        let next = last(&ends[side]) + step[side];
        ends[side].push(next);
        step[side] = (GROWTH * step[side]).min(size);
    }
}

/// Levels with one at each of these planes that lies between the ends: it takes the place of a level nearby, but none within a fillet.
pub(super) fn with_planes(mut along: Vec<f64>, planes: Vec<f64>, fillets: [f64; 2]) -> Vec<f64> {
    let length = along[along.len() - 1];
    let within = |level: f64| {
        level < fillets[0] + SAME
            || level > length - fillets[1] - SAME
            || level < SAME
            || level > length - SAME
    };
    let mut kept: Vec<f64> = Vec::new();
    for plane in planes.into_iter().filter(|plane| *plane > SAME && *plane < length - SAME) {
        if along.iter().any(|level| (level - plane).abs() < SAME) {
            continue;
        }
        let is_free = |level: &f64| {
            !within(*level)
                && (level - plane).abs() < NEAR
                && kept.iter().all(|kept| (kept - level).abs() > SAME)
        };
        match along.iter().position(is_free) {
            Some(near) => along[near] = plane,
            None => along.push(plane),
        }
        kept.push(plane);
    }
    along.sort_by(f64::total_cmp);
    along
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_rise_from_end_to_end_and_hold_the_fillets() {
        for (length, fillets) in
            [(0.02, [0.003, 0.003]), (0.028, [0.003, 0.0]), (0.006, [0.003, 0.003]), (0.05, [0.0, 0.0])]
        {
            let levels = levels(length, fillets, 3, 0.008);
            assert_eq!(levels[0], 0.0);
            assert!((levels[levels.len() - 1] - length).abs() < 1e-15);
            assert!(
                levels.windows(2).all(|pair| pair[1] - pair[0] > 1e-4 && pair[1] - pair[0] < 0.0125),
                "{levels:?}"
            );
            for at in [fillets[0], length - fillets[1]] {
                assert!(levels.iter().any(|level| (level - at).abs() < 1e-12), "{at} in {levels:?}");
            }
        }
    }

    #[test]
    fn planes_become_levels_and_fillets_keep_theirs() {
        let plain = levels(0.03, [0.003, 0.003], 3, 0.008);
        let found = with_planes(plain.clone(), vec![0.0, 0.0022, 0.0119, 0.03, 0.04], [0.003, 0.003]);
        for level in [0.001, 0.002, 0.0022, 0.003, 0.0119, 0.027] {
            assert!(found.iter().any(|own| (own - level).abs() < 1e-12), "{level} in {found:?}");
        }
        assert!(found.windows(2).all(|pair| pair[1] > pair[0]) && found[found.len() - 1] == 0.03);
        assert!(found.len() <= plain.len() + 2);
    }
}
