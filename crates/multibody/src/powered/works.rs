//! Works of everything that gives or takes energy, and which of them a run can have.

use crate::simulation::{Action, BlockMotion, Drive, LoadLaw, Simulation};
use crate::train::Train;

/// Number of works.
pub(crate) const WORKS: usize = 8;

/// Names of the works: what puts energy in counts positive.
pub(crate) const GAS: usize = 0;
pub(crate) const LOAD: usize = 1;
pub(crate) const STARTER: usize = 2;
pub(crate) const FRICTION: usize = 3;
pub(crate) const PISTON_FRICTION: usize = 4;
pub(crate) const OUTSIDE: usize = 5;
pub(crate) const MOUNT_DAMPING: usize = 6;
pub(crate) const DRIVELINE_DAMPING: usize = 7;

/// Which works can be other than 0; `is_stepped`: a torque of the load may come from outside.
pub(crate) fn counted(
    train: &Train,
    simulation: &Simulation,
    with_gas: bool,
    is_stepped: bool,
) -> [bool; WORKS] {
    let mut all = [false; WORKS];
    let loads = |action: &Action| matches!(action, Action::Load(_));
    all[GAS] = with_gas;
    all[LOAD] = is_stepped
        || simulation.load.law != LoadLaw::None
        || simulation.events.iter().any(|event| loads(&event.action));
    all[STARTER] = simulation.starter.is_some();
    all[FRICTION] = simulation.friction_torque != 0.0 || simulation.friction_growth != [0.0; 2];
    all[PISTON_FRICTION] = simulation.piston_damping != 0.0;
    all[OUTSIDE] = !simulation.torque.is_empty() || !matches!(simulation.drive, Drive::Free);
    all[MOUNT_DAMPING] = simulation.block == BlockMotion::Mounts
        && train.mounts.iter().any(|mount| mount.damping.iter().any(|c| *c != 0.0) || mount.branches() > 0);
    all[DRIVELINE_DAMPING] = simulation.driveline.iter().any(|link| link.damping != 0.0);
    all
}
