//! One component of a load as a trigonometric polynomial of the crank angle, affine in the variables.

use crate::convex::curve::{Curve, Grid, Harmonic, WIDTH};
use crate::convex::dense::Matrix;
use std::collections::BTreeMap;

/// `SUM over keys of (a + SUM of parts) cos(key phi) + (b + ..) sin(key phi)`, with `phi = theta / revolutions` and
/// `key = order * revolutions`.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Wave {
    /// What acts without the free devices: cosine and sine by key.
    pub base: BTreeMap<u32, [f64; 2]>,
    /// What a unit of a variable adds: variable, key, cosine and sine.
    pub parts: Vec<(usize, u32, [f64; 2])>,
}

impl Wave {
    pub fn add_base(&mut self, key: u32, cos: f64, sin: f64) {
        if cos != 0.0 || sin != 0.0 {
            let entry = self.base.entry(key).or_insert([0.0; 2]);
            entry[0] += cos;
            entry[1] += sin;
        }
    }

    pub fn add_part(&mut self, variable: usize, key: u32, cos: f64, sin: f64) {
        if cos != 0.0 || sin != 0.0 {
            self.parts.push((variable, key, [cos, sin]));
        }
    }

    /// `SUM of factor times wave`.
    pub fn sum<'a>(terms: impl IntoIterator<Item = (f64, &'a Wave)>) -> Wave {
        let mut sum = Wave::default();
        for (factor, wave) in terms.into_iter().filter(|t| t.0 != 0.0) {
            for (&key, [cos, sin]) in &wave.base {
                sum.add_base(key, factor * cos, factor * sin);
            }
            for &(variable, key, [cos, sin]) in &wave.parts {
                sum.add_part(variable, key, factor * cos, factor * sin);
            }
        }
        sum
    }

    /// What it is where the variables are `x`.
    pub fn at(&self, x: &[f64]) -> Wave {
        let mut wave = Wave { base: self.base.clone(), parts: Vec::new() };
        for &(variable, key, [cos, sin]) in &self.parts {
            wave.add_base(key, x[variable] * cos, x[variable] * sin);
        }
        wave
    }

    /// One key alone.
    pub fn only(&self, key: u32) -> Wave {
        Wave {
            base: self.base.iter().filter(|(k, _)| **k == key).map(|(k, v)| (*k, *v)).collect(),
            parts: self.parts.iter().filter(|p| p.1 == key).copied().collect(),
        }
    }
}

/// The vector with these components, divided by `scale`, as a curve of `variables` variables.
pub(crate) fn curve(waves: &[Wave], scale: f64, variables: usize, grid: &Grid) -> Curve {
    let d = waves.len();
    assert!((1..=WIDTH).contains(&d), "invariant: a load has one to three components");
    let mut base: BTreeMap<u32, Harmonic> = BTreeMap::new();
    for (m, wave) in waves.iter().enumerate() {
        for (&key, [cos, sin]) in &wave.base {
            let harmonic = base.entry(key).or_insert_with(|| Harmonic::empty(key));
            harmonic.cos[m] = cos / scale;
            harmonic.sin[m] = sin / scale;
        }
    }
    let largest = base.values().flat_map(|h| h.cos.iter().chain(&h.sin)).fold(0.0f64, |a, b| a.max(b.abs()));
    base.retain(|_, h| h.cos.iter().chain(&h.sin).any(|v| v.abs() > 1e-18 * largest));
    let mut keys: Vec<u32> = waves.iter().flat_map(|w| w.parts.iter().map(|p| p.1)).collect();
    keys.sort_unstable();
    keys.dedup();
    for &key in &keys {
        base.entry(key).or_insert_with(|| Harmonic::empty(key));
    }
    let mut columns = Matrix::zeros(keys.len() * 2 * d, variables);
    for (m, wave) in waves.iter().enumerate() {
        for &(variable, key, [cos, sin]) in &wave.parts {
            let k = keys.binary_search(&key).expect("invariant: every key of a part is listed");
            columns[(2 * k * d + m, variable)] += cos / scale;
            columns[((2 * k + 1) * d + m, variable)] += sin / scale;
        }
    }
    let base: Vec<Harmonic> = base.into_values().collect();
    let touched = keys
        .iter()
        .map(|key| {
            base.binary_search_by_key(key, |h| h.key).expect("invariant: touched keys are in the base")
        })
        .collect();
    Curve::new(d, base, touched, columns, grid)
}
