//! Where a run takes the pressures from.

use std::f64::consts::{PI, TAU};

/// Pressure on every piston as a function of its own angle and the speed.
///
/// The own angle counts from the firing of the cylinder (a top dead centre of its chamber) in the sense of rotation of its crankshaft
/// ([`crate::Train::own_angle`]); pressures repeat after a working cycle.
pub trait GasPressure {
    /// Pressure in the cylinder less that under the piston [Pa]; `cylinder` is an index, `speed` that of crankshaft 1 [rad/s].
    fn pressure(&self, cylinder: usize, own_angle: f64, speed: f64) -> f64;

    /// The same without combustion. By default the expansion mirrors the compression: what the pressure was as far before the dead centre.
    fn motored(&self, cylinder: usize, own_angle: f64, speed: f64) -> f64 {
        let cycle = self.cycle();
        let own = own_angle.rem_euclid(cycle);
        self.pressure(cylinder, if own < PI { -own } else { own_angle }, speed)
    }

    /// Length of the working cycle [rad]: one or two turns.
    fn cycle(&self) -> f64 {
        2.0 * TAU
    }

    /// Own angles within a cycle at which the pressure or one of its first derivatives jumps.
    fn kinks(&self, _cylinder: usize) -> Vec<f64> {
        Vec::new()
    }

    /// Own angles within a cycle at which any derivative jumps, those of [`GasPressure::kinks`] among them: a pressure through points bends at every point. A step
    /// across one of them has an error that its estimate does not see; a periodic motion whose search stays short of its bound for that ends its steps there.
    fn bends(&self, cylinder: usize) -> Vec<f64> {
        self.kinks(cylinder)
    }
}
