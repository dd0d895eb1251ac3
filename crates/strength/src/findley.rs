//! Fatigue at a point after Findley: the worst plane of a stress history.
//!
//! ```text
//! f = max over planes of  tau_a + k max over time of sigma_n                                                      (book, eq. 49.13)
//! tau_a: radius of the smallest circle about the path of the shear stress in the plane
//! 2/(1 + k/sqrt(1 + k^2)) = sigma_W/tau_W      allowed f = tau_W sqrt(1 + k^2)                                    (49.14)
//! ```
//! so that alternating bending with sigma_W and alternating torsion with tau_W reach the allowed value exactly.

use crate::circle::smallest_circle;
use serde::Serialize;
use std::f64::consts::{FRAC_PI_2, PI};

/// Step of the planes that are tried first [rad].
const STEP: f64 = PI / 18.0;

/// Steps at which the search about the best planes ends [rad]: its error in the value is the square of it.
const LEAST_STEP: f64 = 1e-6;

/// How many of the planes tried first, apart from one another, are searched about.
const CANDIDATES: usize = 3;

/// Stress at an instant: xx, yy, zz, xy, yz, zx [Pa].
pub type StressState = [f64; 6];

/// What a polished specimen endures for ever, at a mean stress of zero.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FatigueLimits {
    /// Amplitude of bending stress [Pa].
    pub bending: f64,
    /// Amplitude of torsional stress [Pa].
    pub torsion: f64,
}

/// Limits that the criterion cannot hold both.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "the fatigue limit in bending over that in torsion is {ratio:.4}, Findley's criterion needs more than 1 and up to 2\nhint: check fatigue_bending and fatigue_torsion in [crank.material]; without fatigue_torsion the ratio is the square root of 3"
)]
pub struct LimitsError {
    /// Bending over torsion [1].
    pub ratio: f64,
}

/// Findley's criterion for a material.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Findley {
    /// Weight k of the normal stress [1].
    pub weight: f64,
    /// Allowed value of tau_a + k sigma_n [Pa].
    pub allowed: f64,
}

/// A plane with what acts on it over the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CriticalPlane {
    /// Its normal.
    pub normal: [f64; 3],
    /// Amplitude of the shear stress tau_a [Pa].
    pub shear: f64,
    /// Largest normal stress [Pa], tension positive.
    pub normal_stress: f64,
    /// Index of the instant of that normal stress.
    pub instant: usize,
    /// tau_a + k sigma_n [Pa].
    pub value: f64,
}

/// Safety at a point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PointFatigue {
    /// The worst plane under the stress as it is.
    pub plane: CriticalPlane,
    /// How many times larger all stress may become [1]; `None`: nothing here can fail by fatigue.
    pub safety_of_all: Option<f64>,
    /// How many times larger the difference from the mean over the cycle may become while the mean stays [1]; 0 where the mean alone is too much, `None` where
    /// nothing varies.
    pub safety_of_amplitude: Option<f64>,
}

impl Findley {
    /// From the two limits of a material, the allowed value lowered by `factor` [1] (surface, size, gradient; 1 for none).
    ///
    /// # Errors
    /// [`LimitsError`] where bending over torsion is not above 1 and up to 2.
    pub fn new(limits: FatigueLimits, factor: f64) -> Result<Findley, LimitsError> {
        let ratio = limits.bending / limits.torsion;
        let share = 2.0 / ratio - 1.0;
        if !(0.0..1.0).contains(&share) || limits.torsion <= 0.0 {
            return Err(LimitsError { ratio });
        }
        let weight = share / ((1.0 - share) * (1.0 + share)).sqrt();
        Ok(Findley { weight, allowed: factor * limits.torsion * weight.hypot(1.0) })
    }

    /// What acts on the plane with the normal `n` of length 1.
    pub fn on_plane(&self, history: &[StressState], n: [f64; 3]) -> CriticalPlane {
        let [t1, t2] = tangents(n);
        let (mut most, mut instant) = (f64::NEG_INFINITY, 0);
        let mut path = Vec::with_capacity(history.len());
        for (k, s) in history.iter().enumerate() {
            let t = traction(s, n);
            let normal = dot(t, n);
            if normal > most {
                (most, instant) = (normal, k);
            }
            path.push([dot(t, t1), dot(t, t2)]);
        }
        let shear = smallest_circle(&path).radius;
        CriticalPlane { normal: n, shear, normal_stress: most, instant, value: shear + self.weight * most }
    }

    /// The worst plane: of planes every 10 degrees the best, and the search about them until the normal moves by less than 1e-6 rad. `None` without a history.
    pub fn critical_plane(&self, history: &[StressState]) -> Option<CriticalPlane> {
        if history.is_empty() {
            return None;
        }
        let mut tried: Vec<CriticalPlane> =
            first_planes().into_iter().map(|n| self.on_plane(history, n)).collect();
        tried.sort_by(|a, b| b.value.total_cmp(&a.value));
        let mut starts: Vec<CriticalPlane> = Vec::with_capacity(CANDIDATES);
        for plane in tried {
            let is_apart = |own: &CriticalPlane| dot(own.normal, plane.normal).abs() < (1.6 * STEP).cos();
            if starts.iter().all(is_apart) {
                starts.push(plane);
            }
            if starts.len() == CANDIDATES {
                break;
            }
        }
        let found = starts.into_iter().map(|start| self.climb(history, start));
        found.max_by(|a, b| a.value.total_cmp(&b.value))
    }

    /// Uphill over the normals about a plane, by steps in eight directions that are halved where none goes up. The value is a largest one of smooth functions, so
    /// its summits are smooth.
    fn climb(&self, history: &[StressState], start: CriticalPlane) -> CriticalPlane {
        let (mut best, mut step) = (start, 0.5 * STEP);
        while step > LEAST_STEP {
            let [t1, t2] = tangents(best.normal);
            let around = (0..8).map(|k| {
                let (sin, cos) = (f64::from(k) * PI / 4.0).sin_cos();
                let moved: [f64; 3] = std::array::from_fn(|i| {
                    best.normal[i] * step.cos() + (cos * t1[i] + sin * t2[i]) * step.sin()
                });
                self.on_plane(history, unit(moved))
            });
            match around.max_by(|a, b| a.value.total_cmp(&b.value)) {
                Some(next) if next.value > best.value => best = next,
                _ => step *= 0.5,
            }
        }
        best
    }

    /// Safety at a point under a history of equal steps over a cycle. `None` without a history.
    ///
    /// ```text
    /// scaled amplitude:  sigma(t) = m + S (sigma(t) - m),  m the mean over the cycle;  S where the worst plane reaches the allowed value
    /// ```
    /// On one plane S is the least of (allowed - k m_n)/(tau_a + k (sigma_n - m_n)) over time; the plane that is worst at that S is next, until it stays. S falls
    /// towards the answer, because the worst value is convex in S.
    pub fn safety(&self, history: &[StressState]) -> Option<PointFatigue> {
        let plane = self.critical_plane(history)?;
        let safety_of_all = (plane.value > 0.0).then(|| self.allowed / plane.value);
        let count = history.len() as f64;
        let mean: StressState = std::array::from_fn(|i| history.iter().map(|s| s[i]).sum::<f64>() / count);
        let scaled = |by: f64| -> Vec<StressState> {
            history.iter().map(|s| std::array::from_fn(|i| mean[i] + by * (s[i] - mean[i]))).collect()
        };
        let at_rest = self.critical_plane(&[mean])?;
        if at_rest.value >= self.allowed {
            return Some(PointFatigue { plane, safety_of_all, safety_of_amplitude: Some(0.0) });
        }
        let mut safety: Option<f64> = None;
        let mut worst = plane;
        for _ in 0..40 {
            let next = self.reach(history, mean, worst.normal);
            let Some(next) = next else { break };
            if safety.is_some_and(|own: f64| next >= own * (1.0 - 1e-12)) {
                break;
            }
            safety = Some(next);
            worst = self.critical_plane(&scaled(next))?;
        }
        Some(PointFatigue { plane, safety_of_all, safety_of_amplitude: safety })
    }

    /// S on one plane; `None` where nothing varies on it.
    fn reach(&self, history: &[StressState], mean: StressState, n: [f64; 3]) -> Option<f64> {
        let shear = self.on_plane(history, n).shear;
        let at_rest = dot(traction(&mean, n), n);
        let left = self.allowed - self.weight * at_rest;
        let growth = |s: &StressState| shear + self.weight * (dot(traction(s, n), n) - at_rest);
        let most = history.iter().map(growth).fold(0.0, f64::max);
        (most > 1e-12 * self.allowed).then(|| left / most)
    }
}

/// Yield strength over the largest von Mises stress of a history; `None` without stress.
pub fn static_safety(history: &[StressState], yield_strength: f64) -> Option<f64> {
    let most = history.iter().map(von_mises).fold(0.0, f64::max);
    (most > 0.0).then(|| yield_strength / most)
}

/// Von Mises stress [Pa].
pub fn von_mises([x, y, z, xy, yz, zx]: &StressState) -> f64 {
    let direct = 0.5 * ((x - y).powi(2) + (y - z).powi(2) + (z - x).powi(2));
    (direct + 3.0 * (xy * xy + yz * yz + zx * zx)).sqrt()
}

/// Normals every 10 degrees over half the sphere.
fn first_planes() -> Vec<[f64; 3]> {
    let rings = (FRAC_PI_2 / STEP).round() as usize;
    let around = (2.0 * PI / STEP).round() as usize;
    let mut normals = vec![[0.0, 0.0, 1.0]];
    for ring in 1..=rings {
        let (sin, cos) = (ring as f64 * STEP).sin_cos();
        // Of the normals on the rim opposite ones are the same plane.
        let count = if ring == rings { around / 2 } else { around };
        normals.extend((0..count).map(|k| {
            let (y, x) = (k as f64 * STEP).sin_cos();
            [sin * x, sin * y, cos]
        }));
    }
    normals
}

fn traction([x, y, z, xy, yz, zx]: &StressState, n: [f64; 3]) -> [f64; 3] {
    [x * n[0] + xy * n[1] + zx * n[2], xy * n[0] + y * n[1] + yz * n[2], zx * n[0] + yz * n[1] + z * n[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

/// Two directions across `n` and each other.
fn tangents(n: [f64; 3]) -> [[f64; 3]; 2] {
    // The axis that is farthest from the normal.
    let axis = (0..3).fold(0, |best, k| if n[k].abs() < n[best].abs() { k } else { best });
    let mut along = [0.0; 3];
    along[axis] = 1.0;
    let by = dot(along, n);
    let first = unit(std::array::from_fn(|k| along[k] - by * n[k]));
    let second = [
        n[1] * first[2] - n[2] * first[1],
        n[2] * first[0] - n[0] * first[2],
        n[0] * first[1] - n[1] * first[0],
    ];
    [first, second]
}
