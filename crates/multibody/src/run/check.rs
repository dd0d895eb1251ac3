//! What a run refuses before it starts.

use crate::block::point_inertia;
use crate::error::MultibodyError;
use crate::run::profile::course;
use crate::simulation::{Action, BlockMotion, Drive, Duration, ImposedAgainst, Simulation};
use crate::train::Train;
use nalgebra::{Matrix3, Matrix3x6, Matrix6, Vector3};
use std::f64::consts::TAU;

/// Most inertias of a driveline and events of a list.
const MOST_LINKS: usize = 8;
const MOST_EVENTS: usize = 64;

/// Evaluations that a revolution takes at the least: some 14 steps of an engine with one cylinder, 12 evaluations each.
const LEAST_EVALUATIONS: f64 = 160.0;

/// Roll of a block that a run of revolutions against the ground may need besides [rad].
const MOST_ROLL: f64 = 0.25;

/// Evaluations of one step.
const STEP_EVALUATIONS: f64 = 12.0;

/// Radians of the fastest oscillation, or times of the fastest decay, that one step goes: Dormand and Prince's eighth order is stable up to about 6.
const STEP_REACHES: f64 = 6.0;

/// Refuses what cannot be run.
pub(crate) fn check(train: &Train, simulation: &Simulation, with_gas: bool) -> Result<(), MultibodyError> {
    let positive = |quantity: &str, got: f64| number(quantity, "positive and finite", got, got > 0.0);
    let whole = |quantity: &str, got: f64| number(quantity, "0 or more", got, got >= 0.0);
    positive("sample step [rad]", simulation.step)?;
    number(
        "tolerance",
        "from 1e-13 to 1e-2",
        simulation.tolerance,
        (1e-13..=1e-2).contains(&simulation.tolerance),
    )?;
    let own = &simulation.tolerances;
    for (quantity, got) in [
        ("tolerance of angles [rad]", own.angle),
        ("tolerance of speeds [rad/s]", own.speed),
        ("tolerance of displacements [m]", own.displacement),
        ("tolerance of the block's turn [rad]", own.turn),
        ("tolerance of velocities [m/s]", own.velocity),
        ("tolerance of the block's angular velocity [rad/s]", own.spin),
        ("tolerance of energies [J]", own.energy),
    ] {
        got.map_or(Ok(()), |got| positive(quantity, got))?;
    }
    whole("start speed [rad/s]", simulation.start_speed)?;
    number("start angle [rad]", "finite", simulation.start_angle, true)?;
    whole("acceleration of gravity [m/s^2]", simulation.gravity)?;
    whole("friction torque [N m]", simulation.friction_torque)?;
    whole("growth of friction with the speed [N m s/rad]", simulation.friction_growth[0])?;
    whole("growth of friction with the square of the speed [N m s^2/rad^2]", simulation.friction_growth[1])?;
    whole("piston damping [N s/m]", simulation.piston_damping)?;
    match simulation.duration {
        Duration::Revolutions(turns) => positive("duration [revolutions]", turns)?,
        Duration::Time(time) => positive("duration [s]", time)?,
    }
    if simulation.driveline.len() > MOST_LINKS {
        return number(
            "number of inertias of the driveline",
            "at most 8",
            simulation.driveline.len() as f64,
            false,
        );
    }
    if simulation.events.len() > MOST_EVENTS {
        return number("number of events", "at most 64", simulation.events.len() as f64, false);
    }
    for link in &simulation.driveline {
        positive("inertia of the driveline [kg m^2]", link.inertia)?;
        whole("stiffness of the driveline [N m/rad]", link.stiffness)?;
        whole("damping of the driveline [N m s/rad]", link.damping)?;
        number("ratio of the driveline", "finite and not 0", link.ratio, link.ratio != 0.0)?;
    }
    for event in &simulation.events {
        if let Action::Misfire(index) = event.action
            && index >= train.cylinders.len()
        {
            return number(
                "number of the cylinder that misfires",
                "that of a cylinder",
                index as f64 + 1.0,
                false,
            );
        }
        if let Action::Fuel(share) = event.action {
            number("fuel as a share", "from 0 to 1", share, (0.0..=1.0).contains(&share))?;
        }
    }
    if let Some(governor) = &simulation.governor {
        whole("delay of the governor [s]", governor.delay)?;
        whole("lag of the governor [s]", governor.lag)?;
        number("droop of the governor", "from 0 to 1", governor.droop, (0.0..1.0).contains(&governor.droop))?;
    }
    if let Some(starter) = &simulation.starter {
        positive("free speed of the starter [rad/s]", starter.free_speed)?;
        positive("ratio of the starter", starter.ratio)?;
    }
    if let Drive::Imposed { profile, .. } = &simulation.drive {
        let rising = profile.windows(2).all(|pair| pair[1][0] > pair[0][0]);
        number(
            "profile of the speed: number of points",
            "1 or more, rising in time",
            profile.len() as f64,
            rising && !profile.is_empty(),
        )?;
        let fastest = profile.iter().fold(0.0f64, |most, point| most.max(point[1].abs()));
        number(
            "imposed speed of a run over revolutions [rad/s]",
            "above 0, or a run over a time",
            fastest,
            fastest > 0.0 || matches!(simulation.duration, Duration::Time(_)),
        )?;
    } else if let Some(rotor) = train.rotors.first().filter(|rotor| !rotor.known) {
        return Err(MultibodyError::NoInertia {
            part: rotor.name.clone(),
            keys: "`inertia` or `crankshaft_inertia` in [flywheel], or [crank.body]",
        });
    }
    if with_gas {
        for (index, cylinder) in train.cylinders.iter().enumerate() {
            let missing = match (cylinder.area, cylinder.firing_angle) {
                (None, _) => "bore",
                (_, None) => "firing angle",
                _ => continue,
            };
            return Err(MultibodyError::NoGasData { cylinder: index + 1, missing });
        }
    }
    match simulation.block {
        BlockMotion::Fixed => Ok(()),
        BlockMotion::Floating if train.block.is_some() => Ok(()),
        BlockMotion::Floating => Err(MultibodyError::NoMounts { missing: "the file has no [block]".into() }),
        BlockMotion::Mounts => match &train.fixed_because {
            Some(reason) => Err(MultibodyError::NoMounts { missing: reason.clone() }),
            None => match train.mounts.iter().find(|mount| !mount.has_form_in_time()) {
                Some(mount) => Err(MultibodyError::NoMounts {
                    missing: format!(
                        "mount `{}` has a loss factor or a table over frequency, which needs a fit over the frequencies of the run",
                        mount.name
                    ),
                }),
                None if leaves_free(train) => Err(MultibodyError::NoMounts {
                    missing:
                        "its mounts leave a motion of it free, so that stiffness in that direction is missing"
                            .into(),
                }),
                None => Ok(()),
            },
        },
    }
}

/// Refuses a run that would take longer than it may, before it starts.
pub(crate) fn check_length(train: &Train, simulation: &Simulation) -> Result<(), MultibodyError> {
    let fastest = simulation.start_speed.max(simulation.governor.map_or(0.0, |governor| governor.speed));
    let fastest = if fastest > 0.0 { fastest } else { train.highest_speed };
    let (turns, sampled) = match (&simulation.drive, simulation.duration) {
        (Drive::Imposed { profile, against }, duration) => {
            let rolls = simulation.block != BlockMotion::Fixed && *against == ImposedAgainst::Ground;
            let course = course(profile, duration, if rolls { MOST_ROLL } else { 0.0 })?;
            (course.turned / TAU, course.sampled)
        }
        (Drive::Free, Duration::Revolutions(turns)) => (turns, turns * TAU),
        (Drive::Free, Duration::Time(time)) => (time * fastest / TAU, time * fastest),
    };
    let mut evaluations = turns * LEAST_EVALUATIONS;
    if let Some(governor) = simulation.governor.filter(|governor| governor.delay > 0.0) {
        // No step is longer than the dead time.
        evaluations = evaluations.max(STEP_EVALUATIONS * turns * TAU / fastest / governor.delay);
    }
    // No step is much longer than the fastest motion of driveline and block allows.
    let time = match simulation.duration {
        Duration::Time(time) => time,
        Duration::Revolutions(_) => turns * TAU / fastest,
    };
    evaluations = evaluations.max(STEP_EVALUATIONS * time * fastest_rate(train, simulation) / STEP_REACHES);
    let samples = sampled / simulation.step;
    let (most_evaluations, most_samples) =
        (simulation.most_evaluations as f64, simulation.most_samples as f64);
    if evaluations <= most_evaluations && samples <= most_samples {
        return Ok(());
    }
    Err(MultibodyError::TooLong { evaluations, samples, most_evaluations, most_samples })
}

/// The fastest natural frequency [rad/s] or rate of decay [1/s] of driveline and block, from above.
///
/// Every diagonal entry of `M^-1 K` and `M^-1 C` of a chain, taken twice, is above its largest eigenvalue (Gershgorin); of the block the springs of all mounts
/// act on its mass, and at their distance on the least of its moments of inertia.
fn fastest_rate(train: &Train, simulation: &Simulation) -> f64 {
    let rate = |stiffness: f64, damping: f64, inertia: f64| {
        (2.0 * stiffness / inertia).sqrt().max(2.0 * damping / inertia)
    };
    let mut fastest: f64 = 0.0;
    for (index, link) in simulation.driveline.iter().enumerate() {
        let next = simulation.driveline.get(index + 1);
        let [stiffness, damping] = [
            link.stiffness + next.map_or(0.0, |next| next.ratio.powi(2) * next.stiffness),
            link.damping + next.map_or(0.0, |next| next.ratio.powi(2) * next.damping),
        ];
        fastest = fastest.max(rate(stiffness, damping, link.inertia));
    }
    if let (BlockMotion::Mounts, Some(block)) = (simulation.block, &train.block) {
        let centre = block.first_moment / block.mass;
        let mut sums = [0.0; 4];
        for mount in &train.mounts {
            let [stiffness, damping] = [mount.stiffness.norm(), mount.damping.norm()];
            let square = (mount.at - centre).norm_squared();
            sums[0] += stiffness;
            sums[1] += damping;
            sums[2] += stiffness * square;
            sums[3] += damping * square;
        }
        let own = (block.inertia - point_inertia(block.mass, centre)).symmetric_eigenvalues().min();
        fastest = fastest.max(rate(sums[0], sums[1], block.mass)).max(rate(sums[2], sums[3], own));
    }
    fastest
}

/// Stiffness below this share of the largest counts as none, with turns measured at the mounts.
const NOT_HELD: f64 = 1e-9;

/// Whether a small motion of the block moves no mount where it is stiff.
fn leaves_free(train: &Train) -> bool {
    let count = train.mounts.len() as f64;
    let middle = train.mounts.iter().map(|mount| mount.at).sum::<Vector3<f64>>() / count;
    let reach = train.mounts.iter().map(|mount| (mount.at - middle).norm()).fold(0.0, f64::max);
    let unit = if reach > 0.0 { reach } else { 1.0 };
    let mut stiffness = Matrix6::<f64>::zeros();
    for mount in &train.mounts {
        // Displacement of the mount's point for a shift of the middle and a turn about it.
        let mut moved = Matrix3x6::zeros();
        moved.fixed_view_mut::<3, 3>(0, 0).copy_from(&Matrix3::identity());
        moved.fixed_view_mut::<3, 3>(0, 3).copy_from(&(-(mount.at - middle).cross_matrix() / unit));
        stiffness += moved.transpose() * mount.stiffness * moved;
    }
    let values = stiffness.symmetric_eigenvalues();
    values.min() <= NOT_HELD * values.max()
}

fn number(quantity: &str, needed: &'static str, got: f64, fits: bool) -> Result<(), MultibodyError> {
    if fits && got.is_finite() {
        Ok(())
    } else {
        Err(MultibodyError::Number { quantity: quantity.to_owned(), needed, got })
    }
}
