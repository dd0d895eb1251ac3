//! A mount in time: springs and dampers along fixed directions at a point of the block that moves; with loss factors or tables over frequency Maxwell chains.
//!
//! ```text
//! F = preload a_1 - SUM over directions k of ( K_k (a_k . delta) + C_k (a_k . delta') ) a_k         on the block
//! ```
//! `delta`: displacement of the mount's point from the position that the file describes; the directions `a_k` stand still.

use crate::maxwell::MaxwellChain;
use lanchester_model::{Mount, MountSpring};
use nalgebra::{Matrix3, Vector3};
use num_complex::Complex64;

/// A mount with its spring.
#[derive(Debug, Clone, PartialEq)]
pub struct MountPlace {
    /// Name for tables.
    pub name: String,
    /// Its point on the block [m].
    pub at: Vector3<f64>,
    /// Stiffness in the axes of the frame [N/m].
    pub stiffness: Matrix3<f64>,
    /// Viscous damping in the axes of the frame [N s/m], with that of its chains.
    pub damping: Matrix3<f64>,
    /// Force on the block in the position of the file [N].
    pub preload: Vector3<f64>,
    /// Its directions.
    pub axes: [Vector3<f64>; 3],
    /// Whether the file gives it a loss factor or a table over frequency, which has no exact form in time.
    pub frequency_dependent: bool,
    /// Maxwell chains along its directions in place of those, where they were fitted; `stiffness` is theirs at rest.
    pub chains: Option<[MaxwellChain; 3]>,
    spring: MountSpring,
}

impl MountPlace {
    /// The mount, where the file gives its spring.
    pub(crate) fn new(mount: &Mount) -> Option<MountPlace> {
        let spring = mount.spring.as_ref()?;
        let axes = spring.axes.map(Vector3::from);
        let along = |values: [f64; 3]| -> Matrix3<f64> {
            (0..3).map(|k| values[k] * axes[k] * axes[k].transpose()).sum()
        };
        Some(MountPlace {
            name: mount.name.clone(),
            at: Vector3::new(mount.x, mount.y, mount.z),
            stiffness: along(spring.stiffness),
            damping: along(spring.damping),
            preload: spring.preload * axes[0],
            axes,
            chains: None,
            spring: spring.clone(),
            frequency_dependent: !spring.table.is_empty()
                || spring.loss_factor.iter().any(|loss| *loss != 0.0),
        })
    }

    /// Whether a run in time knows its stiffness.
    pub fn has_form_in_time(&self) -> bool {
        !self.frequency_dependent || self.chains.is_some()
    }

    /// Fits Maxwell chains over `band` [rad/s] where its stiffness depends on frequency or is complex; the largest error of any direction. At rest they are as stiff as
    /// the file says.
    pub fn fit(&mut self, band: [f64; 2]) -> f64 {
        if !self.frequency_dependent {
            return 0.0;
        }
        let chains = [0, 1, 2].map(|k| {
            let spring = &self.spring;
            MaxwellChain::fit(|w| complex_stiffness(spring, w)[k], spring.stiffness[k], band)
        });
        let own = |k: usize| self.spring.damping[k] + chains[k].damping;
        self.damping = (0..3).map(|k| own(k) * self.axes[k] * self.axes[k].transpose()).sum();
        let error = chains.iter().map(|chain| chain.error).fold(0.0, f64::max);
        self.chains = Some(chains);
        error
    }

    /// Number of its branches.
    pub(crate) fn branches(&self) -> usize {
        self.chains.iter().flatten().map(|chain| chain.branches.len()).sum()
    }

    /// Force of its branches on the block [N] with what they store and lose [J, W], their dashpots standing at `relaxed` [m]; the rates of those into `rates`.
    pub(crate) fn relax(
        &self,
        displacement: Vector3<f64>,
        relaxed: &[f64],
        rates: &mut [f64],
    ) -> (Vector3<f64>, f64, f64) {
        let (mut force, mut stored, mut lost) = (Vector3::zeros(), 0.0, 0.0);
        let mut index = 0;
        for (axis, chain) in self.axes.iter().zip(self.chains.iter().flatten()) {
            let along = axis.dot(&displacement);
            for [stiffness, rate] in &chain.branches {
                let stretched = along - relaxed[index];
                if let Some(own) = rates.get_mut(index) {
                    *own = rate * stretched;
                }
                force -= stiffness * stretched * axis;
                stored += 0.5 * stiffness * stretched * stretched;
                lost += rate * stiffness * stretched * stretched;
                index += 1;
            }
        }
        (force, stored, lost)
    }

    /// Where the dashpots of its branches stand at rest in a displacement [m], into `relaxed`.
    pub(crate) fn settle(&self, displacement: Vector3<f64>, relaxed: &mut [f64]) {
        let axes = self.axes.iter().zip(self.chains.iter().flatten());
        let places =
            axes.flat_map(|(axis, chain)| chain.branches.iter().map(move |_| axis.dot(&displacement)));
        relaxed.iter_mut().zip(places).for_each(|(own, place)| *own = place);
    }

    /// Energy stored for a displacement [J], 0 in the position of the file.
    pub fn energy(&self, displacement: Vector3<f64>) -> f64 {
        0.5 * displacement.dot(&(self.stiffness * displacement)) - self.preload.dot(&displacement)
    }
}

/// Complex stiffness along the directions of a spring at an angular frequency [rad/s]: between the points of its table on straight lines, constant beyond.
fn complex_stiffness(spring: &MountSpring, frequency: f64) -> [Complex64; 3] {
    let of = |stiffness: f64, loss: f64| stiffness * Complex64::new(1.0, loss);
    let Some(last) = spring.table.last() else {
        return [0, 1, 2].map(|k| of(spring.stiffness[k], spring.loss_factor[k]));
    };
    let after = spring.table.partition_point(|point| point.angular_frequency <= frequency);
    let (before, next) = (spring.table.get(after.wrapping_sub(1)), spring.table.get(after).unwrap_or(last));
    let before = before.unwrap_or(next);
    let width = next.angular_frequency - before.angular_frequency;
    let share = if width > 0.0 { (frequency - before.angular_frequency) / width } else { 0.0 };
    let between = |a: f64, b: f64| a + share * (b - a);
    [0, 1, 2].map(|k| {
        of(
            between(before.stiffness[k], next.stiffness[k]),
            between(before.loss_factor[k], next.loss_factor[k]),
        )
    })
}
