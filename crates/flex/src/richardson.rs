//! What three meshes tend to, and how far off that may be.

use serde::Serialize;

/// Orders of convergence between which the meshes are held to be fine enough for an extrapolation.
const ORDERS: [f64; 2] = [0.5, 6.0];
/// Roache's factors of safety: of an extrapolation by an order that three meshes show, and of a difference alone.
const SAFETY: [f64; 2] = [1.25, 3.0];

/// A number computed on three meshes, extrapolated to elements of size zero.
///
/// ```text
/// f(h) = f* + C h^p      (f1 - f2)/(f2 - f3) = (h1^p - h2^p)/(h2^p - h3^p)      f* = f3 + (f3 - f2)/((h2/h3)^p - 1)
/// band = 1.25 |f* - f3|                                                                                     (book, eq. 43.15)
/// ```
/// Where no such order from 0.5 to 6 exists, because the numbers go to and fro or do not come closer, the value is that of the finest mesh
/// and the band three times the largest difference.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Extrapolated {
    /// Value on the coarse, the middle and the fine mesh.
    pub values: [f64; 3],
    /// What they tend to.
    pub value: f64,
    /// Half width of the band about it.
    pub band: f64,
    /// Order that the three show; none where they show none.
    pub order: Option<f64>,
}

/// Extrapolates values on elements of falling `sizes`.
pub fn richardson(sizes: [f64; 3], values: [f64; 3]) -> Extrapolated {
    let [first, second, third] = values;
    let [a, b] = [first - second, second - third];
    let plain = |band: f64| Extrapolated { values, value: third, band, order: None };
    let largest = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    if a.abs().max(b.abs()) <= 1e-12 * largest {
        return plain(a.abs().max(b.abs()));
    }
    let share = |order: f64| {
        let [h1, h2, h3] = sizes.map(|size| (size / sizes[2]).powf(order));
        (h1 - h2) / (h2 - h3)
    };
    let ratio = a / b;
    let [low, high] = ORDERS;
    if !(b != 0.0 && ratio >= share(low)) {
        return plain(SAFETY[1] * a.abs().max(b.abs()));
    }
    // The share rises with the order: above the highest one that one is taken, which widens the band.
    let (mut low, mut high) = (low, high);
    if ratio >= share(high) {
        low = high;
    }
    for _ in 0..100 {
        let middle = (low + high) / 2.0;
        if share(middle) < ratio { low = middle } else { high = middle }
    }
    let order = (low + high) / 2.0;
    let value = third - b / ((sizes[1] / sizes[2]).powf(order) - 1.0);
    Extrapolated { values, value, band: SAFETY[0] * (value - third).abs(), order: Some(order) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_gives_its_limit_and_order() {
        let sizes = [8.0, 5.7, 4.0];
        for order in [1.0, 2.0, 3.7] {
            let found = richardson(sizes, sizes.map(|h| 5.0 - 0.01 * f64::powf(h, order)));
            assert!((found.order.unwrap() - order).abs() < 1e-9, "{found:?}");
            assert!((found.value - 5.0).abs() < 1e-9, "{found:?}");
            assert!((found.band / (1.25 * (5.0 - found.values[2])) - 1.0).abs() < 1e-6, "{found:?}");
        }
    }

    #[test]
    fn numbers_that_go_to_and_fro_are_not_extrapolated() {
        for values in [[1.0, 1.2, 1.1], [1.0, 1.1, 1.3], [2.0, 1.0, 1.0]] {
            let found = richardson([2.0, 1.5, 1.0], values);
            if let Some(order) = found.order {
                assert!(order <= 6.0 && found.value.is_finite(), "{found:?}");
            } else {
                assert_eq!(found.value, values[2]);
                assert!(found.band >= 3.0 * (values[1] - values[2]).abs(), "{found:?}");
            }
        }
        let none = richardson([2.0, 1.5, 1.0], [1.0, 1.1, 1.3]);
        assert!(none.order.is_none() && (none.band - 0.6).abs() < 1e-12, "{none:?}");
        let equal = richardson([2.0, 1.5, 1.0], [3.0; 3]);
        assert_eq!((equal.value, equal.band), (3.0, 0.0));
    }
}
