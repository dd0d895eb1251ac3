//! Forces at the engine's mounts, were these stiff: the loads shared as the block at rest shares them.
//!
//! | quantity | what it is |
//! |---|---|
//! | `mount N Fx order n` | amplitude along x of one order at mount N |
//! | `mount N Fres max` | largest force over the angle, with the twin thesis's own `M_z`: of shafts and weights alone |

use crate::case::Run;
use lanchester::mechanism::{Excitation, MountError, MountSystem};

/// A quantity of a mount.
pub(crate) struct MountKey {
    /// Counted from 1.
    number: usize,
    /// `None`: all orders together, over the angle.
    order: Option<u32>,
}

impl MountKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<MountKey> {
        let words: Vec<&str> = text.split(' ').collect();
        let (number, order) = match words[..] {
            ["mount", number, "Fres", "max"] => (number, None),
            ["mount", number, "Fx", "order", order] => (number, Some(order.parse().ok()?)),
            _ => return None,
        };
        Some(MountKey { number: number.parse().ok()?, order })
    }

    /// Its value [N].
    pub fn of(&self, run: &Run) -> Result<f64, String> {
        let told = |error: MountError| error.to_string();
        let system = MountSystem::new(&run.engine).map_err(told)?;
        let mount = self.number.checked_sub(1).filter(|m| *m < run.engine.mounts.len()).ok_or_else(|| {
            format!("the engine has {} mounts and no mount {}", run.engine.mounts.len(), self.number)
        })?;
        if run.loads.reference != [0.0; 3] {
            return Err("forces at mounts need couples about the origin".to_string());
        }
        let Some(order) = self.order else { return Ok(self.largest(run, &system, mount)) };
        let orders = &run.loads.total.orders;
        let orders = orders.iter().filter(|o| o.order == f64::from(order)).copied().collect();
        let excitation = Excitation { speed: run.loads.speed, orders };
        let found = system.response(&[excitation]).map_err(told)?;
        let found = found.speeds.first().and_then(|s| s.orders.first());
        Ok(found.map_or(0.0, |o| o.stiff_forces[mount][0].norm()))
    }

    fn largest(&self, run: &Run, system: &MountSystem, mount: usize) -> f64 {
        let trace = &run.loads.total.trace;
        let [x, y, z] = system.body().centre;
        let rolls = run.roll_of_shafts();
        let force = |j: usize| {
            let (fx, fy) = (trace.force_x[j], trace.force_y[j]);
            let couple = [trace.couple_x[j] + z * fy, trace.couple_y[j] - z * fx];
            let roll = rolls[j] - (x * fy - y * fx);
            let [x, y, z] = system.rigid_share([fx, fy, 0.0, couple[0], couple[1], roll])[mount];
            x.hypot(y).hypot(z)
        };
        (0..trace.theta.len()).map(force).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        let key = MountKey::parse("mount 2 Fx order 3").unwrap();
        assert_eq!((key.number, key.order), (2, Some(3)));
        assert_eq!(MountKey::parse("mount 1 Fres max").unwrap().order, None);
        for name in
            ["mount Fres max", "mount 1 Fx max", "mount 1 Fx order", "mount 1 Fx order half", "Fres max"]
        {
            assert!(MountKey::parse(name).is_none(), "{name}");
        }
    }
}
