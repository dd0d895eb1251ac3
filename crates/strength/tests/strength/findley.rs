//! Findley's criterion and the smallest circle.

use lanchester_strength::{FatigueLimits, Findley, StressState, smallest_circle, static_safety, von_mises};
use lanchester_testkit::{Within, assert_close};
use std::f64::consts::{PI, TAU};

const LIMITS: FatigueLimits = FatigueLimits { bending: 430e6, torsion: 250e6 };

/// A generator of numbers in -1..1 (splitmix64), the same ones every time.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as f64 / u64::MAX as f64 * 2.0 - 1.0
    }
}

fn findley() -> Findley {
    Findley::new(LIMITS, 1.0).unwrap()
}

fn alternating(state: StressState, amplitude: f64) -> Vec<StressState> {
    (0..72).map(|k| state.map(|s| s * amplitude * (TAU * f64::from(k) / 72.0).cos())).collect()
}

/// Stress turned by a rotation matrix.
fn turned([x, y, z, xy, yz, zx]: StressState, r: [[f64; 3]; 3]) -> StressState {
    let s = [[x, xy, zx], [xy, y, yz], [zx, yz, z]];
    let of = |i: usize, j: usize| -> f64 {
        (0..3).map(|a| (0..3).map(|b| r[i][a] * s[a][b] * r[j][b]).sum::<f64>()).sum()
    };
    [of(0, 0), of(1, 1), of(2, 2), of(0, 1), of(1, 2), of(2, 0)]
}

/// About x by a, then about z by b, then about y by c.
fn rotation(a: f64, b: f64, c: f64) -> [[f64; 3]; 3] {
    let product = |p: [[f64; 3]; 3], q: [[f64; 3]; 3]| {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| p[i][k] * q[k][j]).sum()))
    };
    let x = [[1.0, 0.0, 0.0], [0.0, a.cos(), -a.sin()], [0.0, a.sin(), a.cos()]];
    let z = [[b.cos(), -b.sin(), 0.0], [b.sin(), b.cos(), 0.0], [0.0, 0.0, 1.0]];
    let y = [[c.cos(), 0.0, c.sin()], [0.0, 1.0, 0.0], [-c.sin(), 0.0, c.cos()]];
    product(y, product(z, x))
}

fn random_history(numbers: &mut Numbers) -> Vec<StressState> {
    let mut state = || -> StressState { std::array::from_fn(|_| 2e8 * numbers.next()) };
    let [mean, one, two, three] = [state(), state(), state(), state()];
    (0..48)
        .map(|k| {
            let angle = TAU * f64::from(k) / 48.0;
            std::array::from_fn(|i| {
                0.3 * mean[i]
                    + one[i] * angle.cos()
                    + two[i] * angle.sin()
                    + 0.5 * three[i] * (2.0 * angle).sin()
            })
        })
        .collect()
}

#[test]
fn bending_and_torsion_give_back_both_limits() {
    let within = Within::share(1e-9, "planes are searched to 1e-6 rad, and the value is flat there");
    for turn in [rotation(0.0, 0.0, 0.0), rotation(0.3, 1.1, -0.7)] {
        for (state, limit) in [
            ([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], LIMITS.bending),
            ([0.0, 0.0, 0.0, 1.0, 0.0, 0.0], LIMITS.torsion),
        ] {
            let found = findley().safety(&alternating(turned(state, turn), limit)).unwrap();
            assert_close("safety of all", found.safety_of_all.unwrap(), 1.0, within);
            assert_close("safety of the amplitude", found.safety_of_amplitude.unwrap(), 1.0, within);
            let half = findley().safety(&alternating(turned(state, turn), 0.5 * limit)).unwrap();
            assert_close("at half the stress", half.safety_of_all.unwrap(), 2.0, within);
        }
    }
}

#[test]
fn the_weight_follows_from_the_ratio_of_the_limits() {
    let Findley { weight: k, allowed } = findley();
    assert_close("ratio", 2.0 / (1.0 + k / k.hypot(1.0)), 430.0 / 250.0, Within::share(1e-14, "rounding"));
    assert_close("allowed", allowed, 0.5 * 430e6 * (k + k.hypot(1.0)), Within::share(1e-14, "rounding"));
    assert_eq!(Findley::new(FatigueLimits { bending: 2.0, torsion: 1.0 }, 1.0).unwrap().weight, 0.0);
    for bending in [0.9, 1.0, 2.1, f64::NAN] {
        let error = Findley::new(FatigueLimits { bending, torsion: 1.0 }, 1.0).unwrap_err();
        assert!(error.to_string().contains("needs more than 1 and up to 2"), "{error}");
    }
}

/// Planes every degree, without any search about them.
#[test]
fn random_histories_against_a_fine_search() {
    let mut numbers = Numbers(1);
    for case in 0..6 {
        let history = random_history(&mut numbers);
        let found = findley().critical_plane(&history).unwrap();
        let mut best = f64::NEG_INFINITY;
        for polar in 0..=90 {
            let (sin, cos) = f64::from(polar).to_radians().sin_cos();
            for around in 0..360 {
                let (y, x) = f64::from(around).to_radians().sin_cos();
                best = best.max(findley().on_plane(&history, [sin * x, sin * y, cos]).value);
            }
        }
        assert!(found.value >= best * (1.0 - 1e-12), "case {case}: {} below {best}", found.value);
        assert_close(
            "value",
            found.value,
            best,
            Within::share(5e-4, "planes of the fine search stand 1 degree apart"),
        );
    }
}

#[test]
fn a_turned_history_has_the_same_safety() {
    let mut numbers = Numbers(7);
    for _ in 0..4 {
        let history = random_history(&mut numbers);
        let turn = rotation(3.0 * numbers.next(), 3.0 * numbers.next(), 3.0 * numbers.next());
        let other: Vec<StressState> = history.iter().map(|state| turned(*state, turn)).collect();
        let [one, two] = [&history, &other].map(|history| findley().safety(history).unwrap());
        let within = Within::share(1e-9, "planes are searched to 1e-6 rad");
        assert_close("value", one.plane.value, two.plane.value, within);
        assert_close("amplitude", one.safety_of_amplitude.unwrap(), two.safety_of_amplitude.unwrap(), within);
        // The normal turns with it.
        let along: f64 = (0..3)
            .map(|i| two.plane.normal[i] * (0..3).map(|j| turn[i][j] * one.plane.normal[j]).sum::<f64>())
            .sum();
        assert_close("normal", along.abs(), 1.0, Within::absolute(1e-8, "planes are searched to 1e-6 rad"));
    }
}

/// The amplitude scaled by its safety reaches the allowed value.
#[test]
fn the_safety_of_the_amplitude_is_where_the_allowed_value_is_reached() {
    let mut numbers = Numbers(3);
    for _ in 0..4 {
        let history = random_history(&mut numbers);
        let safety = findley().safety(&history).unwrap().safety_of_amplitude.unwrap();
        let count = history.len() as f64;
        let mean: StressState = std::array::from_fn(|i| history.iter().map(|s| s[i]).sum::<f64>() / count);
        let scaled: Vec<StressState> =
            history.iter().map(|s| std::array::from_fn(|i| mean[i] + safety * (s[i] - mean[i]))).collect();
        let value = findley().critical_plane(&scaled).unwrap().value;
        assert_close(
            "value",
            value,
            findley().allowed,
            Within::share(1e-9, "planes are searched to 1e-6 rad"),
        );
    }
    let steady = vec![[1e8, 0.0, 0.0, 0.0, 0.0, 0.0]; 3];
    assert_eq!(findley().safety(&steady).unwrap().safety_of_amplitude, None);
    let much = vec![[1e11, 0.0, 0.0, 0.0, 0.0, 0.0]; 3];
    assert_eq!(findley().safety(&much).unwrap().safety_of_amplitude, Some(0.0));
    assert_eq!(findley().safety(&[]), None);
}

/// A mean torsion does not count in shear, a mean tension does.
#[test]
fn mean_tension_lowers_and_mean_compression_raises_safety() {
    let with = |mean: f64| {
        let history: Vec<StressState> = alternating([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], 2e8)
            .into_iter()
            .map(|mut s| {
                s[0] += mean;
                s
            })
            .collect();
        findley().safety(&history).unwrap().safety_of_amplitude.unwrap()
    };
    assert!(with(1e8) < with(0.0) && with(0.0) < with(-1e8));
}

#[test]
fn the_smallest_circle_equals_trial_of_all_pairs_and_triples() {
    let mut numbers = Numbers(11);
    for count in [1, 2, 3, 5, 12, 40] {
        let points: Vec<[f64; 2]> = (0..count).map(|_| [numbers.next(), 0.3 * numbers.next()]).collect();
        let found = smallest_circle(&points);
        let reach = |centre: [f64; 2]| {
            points.iter().map(|p| (p[0] - centre[0]).hypot(p[1] - centre[1])).fold(0.0, f64::max)
        };
        assert_close("it holds all", reach(found.centre), found.radius, Within::absolute(1e-12, "rounding"));
        let mut best = if count == 1 { 0.0 } else { f64::INFINITY };
        for i in 0..count {
            for j in 0..i {
                let (a, b) = (points[i], points[j]);
                best = best.min(reach([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]));
                for c in &points[..j] {
                    // Centre of the circle through three points, by Cramer's rule.
                    let (p, q) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
                    let (pp, qq) = (0.5 * (p[0] * p[0] + p[1] * p[1]), 0.5 * (q[0] * q[0] + q[1] * q[1]));
                    let area = p[0] * q[1] - p[1] * q[0];
                    best = best.min(reach([
                        a[0] + (pp * q[1] - qq * p[1]) / area,
                        a[1] + (p[0] * qq - q[0] * pp) / area,
                    ]));
                }
            }
        }
        assert_close("radius", found.radius, best, Within::absolute(1e-12, "rounding"));
    }
    // In line, in one place, on a circle.
    let line: Vec<[f64; 2]> = (0..9).map(|k| [f64::from(k), 2.0 * f64::from(k)]).collect();
    assert_close(
        "line",
        smallest_circle(&line).radius,
        0.5 * 8.0 * 5f64.sqrt(),
        Within::share(1e-14, "rounding"),
    );
    assert_eq!(smallest_circle(&[[3.0, 4.0]; 5]).radius, 0.0);
    let ring: Vec<[f64; 2]> = (0..360).map(|k| (PI * f64::from(k) / 180.0).sin_cos().into()).collect();
    assert_close("ring", smallest_circle(&ring).radius, 1.0, Within::absolute(1e-12, "rounding"));
    assert_eq!(smallest_circle(&[]).radius, 0.0);
}

#[test]
fn static_safety_is_yield_over_von_mises() {
    let history = [[0.0, 0.0, 0.0, 1e8, 0.0, 0.0], [1e8, 0.0, 0.0, 0.0, 0.0, 0.0]];
    assert_close("shear", von_mises(&history[0]), 3f64.sqrt() * 1e8, Within::share(1e-14, "rounding"));
    assert_close(
        "safety",
        static_safety(&history, 6.5e8).unwrap(),
        6.5 / 3f64.sqrt(),
        Within::share(1e-14, "rounding"),
    );
    assert_eq!(static_safety(&[[0.0; 6]], 6.5e8), None);
}
