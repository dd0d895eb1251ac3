//! Levels along z.

/// Growth from layer to layer.
const GROWTH: f64 = 1.5;

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
}
