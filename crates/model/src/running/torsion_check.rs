//! What numbers of torsional vibration have to keep.

use crate::fault::{Fault, Part};
use crate::running::torsion::{BranchPlace, TorsionDesign};

/// Faults of what the file says of torsional vibration.
pub(crate) fn of_torsion(design: &TorsionDesign, throws: usize, faults: &mut Vec<Fault>) {
    let part = &mut Part { faults, name: &|| "torsion".into() };
    design.stiffness.iter().for_each(|one| part.positive("stiffness [N m/rad]", *one));
    design.absolute_damping.iter().for_each(|one| part.not_negative("absolute_damping [N m s/rad]", *one));
    design.relative_damping.iter().for_each(|one| part.not_negative("relative_damping [N m s/rad]", *one));
    design.loss_factor.iter().for_each(|one| part.not_negative("loss_factor", *one));
    design.nose_inertia.iter().for_each(|one| part.not_negative("nose_inertia [kg m^2]", *one));
    design.highest_order.iter().for_each(|one| part.positive("highest_order", *one));
    design.twist_limit.iter().for_each(|one| part.positive("twist_limit [rad]", *one));
    design.stress_limit.iter().for_each(|one| part.positive("stress_limit [Pa]", *one));
    if let Some(damper) = &design.damper {
        let part = &mut Part { faults, name: &|| "torsion.damper".into() };
        part.positive("ring_inertia [kg m^2]", damper.ring_inertia);
        part.not_negative("hub_inertia [kg m^2]", damper.hub_inertia);
        part.not_negative("damping [N m s/rad]", damper.damping);
        part.not_negative("stiffness [N m/rad]", damper.stiffness);
        part.not_negative("loss_factor", damper.loss_factor);
        if damper.stiffness == 0.0 && damper.damping == 0.0 {
            part.add(
                "damping [N m s/rad]",
                "more than 0 without a stiffness",
                0.0,
                "nothing joins the ring to its hub",
            );
        }
    }
    for (index, pendulum) in design.pendulums.iter().enumerate() {
        let part = &mut Part { faults, name: &|| format!("torsion.pendulums[{index}]") };
        part.index("throw", pendulum.throw, throws);
        part.positive("mass [kg]", pendulum.mass);
        part.positive("pivot_radius [m]", pendulum.pivot_radius);
        part.positive("length [m]", pendulum.length);
        part.positive("number", pendulum.number as f64);
        part.not_negative("damping [N m s/rad]", pendulum.damping);
    }
    for (index, branch) in design.branches.iter().enumerate() {
        let part = &mut Part { faults, name: &|| format!("torsion.branches[{index}]") };
        part.positive("inertia [kg m^2]", branch.inertia);
        part.positive("stiffness [N m/rad]", branch.stiffness);
        part.not_negative("damping [N m s/rad]", branch.damping);
        part.finite("ratio", branch.ratio);
        if branch.ratio == 0.0 {
            part.add("ratio", "other than 0", 0.0, "give its speed over that of what drives it");
        }
        match branch.at {
            BranchPlace::Throw(throw) => {
                part.index("at", throw, throws);
            }
            BranchPlace::Branch(other) => {
                part.index("at", other, index);
            }
            BranchPlace::Nose | BranchPlace::Flywheel => {}
        }
    }
}
