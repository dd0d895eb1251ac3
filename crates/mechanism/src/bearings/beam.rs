//! A crankshaft as a straight beam on its main bearings: who carries a load, and what it does to every section.
//!
//! Loads act across the shaft at planes along z; each is a complex force `F = F_x + i F_y` *on* the shaft. Sections are
//! seen from the free end: what lies before the section acts on what lies behind it with the shear force and the bending
//! moment
//!
//! ```text
//! Q(z) = SUM over z_k < z of F_k                 M(z) = M_x + i M_y = i SUM over z_k < z of (z_k - z) F_k
//! dM/dz = -i Q
//! ```
//! where the bearings' forces on the shaft count among the loads. The signs are those of the couples of the frame
//! (`M = r x F`, book, "Conventions"); at both free ends `Q = M = 0`.
//!
//! Both models are statically determinate: a load is shared by two mains as by a lever,
//!
//! ```text
//! share of main a: (z_b - z) / (z_b - z_a)       share of main b: (z - z_a) / (z_b - z_a)
//! ```
//! and the carriers a, b are the two end mains (free beam) or the two neighbours of the load (throw by throw). Loads beyond
//! the end mains overhang.

use num_complex::Complex64;

/// How a crankshaft is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BeamModel {
    /// A free beam: only what its loads do not hold in balance by themselves is carried, by the end mains.
    FreeBeam,
    /// Every throw is held by the main bearings beside it, as if the shaft were cut through at each of them.
    ThrowByThrow,
}

impl BeamModel {
    /// Both models in the order of tables.
    pub const ALL: [BeamModel; 2] = [BeamModel::FreeBeam, BeamModel::ThrowByThrow];

    /// Name for tables and legends.
    pub fn name(self) -> &'static str {
        match self {
            BeamModel::FreeBeam => "free beam",
            BeamModel::ThrowByThrow => "throw by throw",
        }
    }
}

/// A crankshaft on its main bearings.
#[derive(Debug, Clone, PartialEq)]
pub struct Beam {
    mains: Vec<f64>,
    /// Indices of the mains that carry, rising.
    carriers: Vec<usize>,
}

impl Beam {
    /// The shaft on `mains` [m], rising; `None` for fewer than two, or where two stand in one plane.
    pub fn new(mains: &[f64], model: BeamModel) -> Option<Beam> {
        let rising = mains.windows(2).all(|pair| pair[1] > pair[0]);
        if mains.len() < 2 || !rising || mains.iter().any(|z| !z.is_finite()) {
            return None;
        }
        let carriers = match model {
            BeamModel::FreeBeam => vec![0, mains.len() - 1],
            BeamModel::ThrowByThrow => (0..mains.len()).collect(),
        };
        Some(Beam { mains: mains.to_vec(), carriers })
    }

    /// Planes of its mains [m], rising.
    pub fn mains(&self) -> &[f64] {
        &self.mains
    }

    /// The two mains that carry a load at plane `load` [m], with their shares; these sum to 1.
    pub fn shares(&self, load: f64) -> [(usize, f64); 2] {
        // The bay of the load; the end bays reach on without end.
        let inner = &self.carriers[1..self.carriers.len() - 1];
        let bay = inner.iter().filter(|&&main| self.mains[main] <= load).count();
        let [front, rear] = [self.carriers[bay], self.carriers[bay + 1]];
        let share = (load - self.mains[front]) / (self.mains[rear] - self.mains[front]);
        [(front, 1.0 - share), (rear, share)]
    }

    /// Influence of a load at plane `load` on the bending moment at `section` [m]: `M = i SUM influence F`, the mains'
    /// answer included.
    pub fn moment_influence(&self, section: f64, load: f64) -> f64 {
        let arm = |z: f64| (z - section).min(0.0);
        self.shares(load).iter().fold(arm(load), |sum, &(main, share)| sum - share * arm(self.mains[main]))
    }

    /// Influence of a load at plane `load` on the shear force just behind `section`: `Q = SUM influence F`.
    pub fn shear_influence(&self, section: f64, load: f64) -> f64 {
        let before = |z: f64| f64::from(u8::from(z <= section));
        let shares = self.shares(load);
        shares.iter().fold(before(load), |sum, &(main, share)| sum - share * before(self.mains[main]))
    }
}

/// Shear force just behind every plane and bending moment at every plane under `loads` at `planes` [m], rising, from the
/// free end on.
pub(crate) fn walk(planes: &[f64], loads: &[Complex64], shear: &mut [Complex64], moment: &mut [Complex64]) {
    let (mut q, mut m) = (Complex64::ZERO, Complex64::ZERO);
    for (k, load) in loads.iter().enumerate() {
        if k > 0 {
            m -= Complex64::new(0.0, planes[k] - planes[k - 1]) * q;
        }
        q += load;
        (shear[k], moment[k]) = (q, m);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MAINS: [f64; 4] = [-0.1, 0.0, 0.05, 0.2];

    #[test]
    fn a_load_is_shared_as_by_a_lever() {
        let free = Beam::new(&MAINS, BeamModel::FreeBeam).unwrap();
        let cut = Beam::new(&MAINS, BeamModel::ThrowByThrow).unwrap();
        for load in [-0.3, -0.1, -0.04, 0.0, 0.02, 0.05, 0.11, 0.2, 0.26] {
            for beam in [&free, &cut] {
                let shares = beam.shares(load);
                let sum: f64 = shares.iter().map(|s| s.1).sum();
                let moment: f64 = shares.iter().map(|s| s.1 * MAINS[s.0]).sum();
                assert!((sum - 1.0).abs() < 1e-15 && (moment - load).abs() < 1e-15, "{load}: {shares:?}");
            }
            assert_eq!(free.shares(load).map(|s| s.0), [0, 3]);
        }
        assert_eq!(cut.shares(0.02).map(|s| s.0), [1, 2]);
        assert_eq!(cut.shares(-0.3).map(|s| s.0), [0, 1]);
        assert_eq!(cut.shares(0.26).map(|s| s.0), [2, 3]);
    }

    #[test]
    fn a_load_in_the_middle_of_two_mains_bends_by_a_quarter_of_their_distance() {
        let beam = Beam::new(&[0.0, 0.2], BeamModel::FreeBeam).unwrap();
        // -N_a acts on the shaft at 0 with half the load: M = i (0 - z)(-F/2) = i z F / 2.
        assert!((beam.moment_influence(0.1, 0.1) - 0.05).abs() < 1e-17);
        assert_eq!(beam.moment_influence(0.0, 0.1), 0.0);
        assert!(beam.moment_influence(0.2, 0.1).abs() < 1e-17);
        assert_eq!(beam.shear_influence(0.05, 0.1), -0.5);
        assert_eq!(beam.shear_influence(0.15, 0.1), 0.5);
    }

    #[test]
    fn mains_that_hold_nothing_are_refused() {
        for mains in [&[][..], &[0.0], &[0.0, 0.0], &[0.1, 0.0], &[0.0, f64::NAN]] {
            assert_eq!(Beam::new(mains, BeamModel::FreeBeam), None, "{mains:?}");
        }
    }
}
