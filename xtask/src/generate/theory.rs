//! Pictures of the theory pages that the program writes.

use super::written::Written;

/// Where a picture of the theory stands.
macro_rules! picture {
    ($name:literal) => {
        concat!("docs/src/images/theory/", $name, ".svg")
    };
}

/// All of them.
pub const THEORY: [Written; 30] = [
    shown(picture!("piston-motion"), &REPORT_THREE, "piston-motion.svg", &[0, 2]),
    shown(picture!("couple-stars"), &REPORT_THREE, "couple-stars.svg", &[0, 1]),
    shown(picture!("force-spectrum"), &REPORT_TWIN, "force-spectrum.svg", &[0]),
    shown(picture!("roll-moment"), &REPORT_SHAFTS, "roll-moment-by-part.svg", &[0]),
    shown(picture!("radial"), &REPORT_RADIAL, "front-view.svg", &[0]),
    shown(picture!("strokes"), &TORQUE_THREE, "strokes.svg", &[0]),
    shown(picture!("firing-star"), &TORQUE_THREE, "firing-star.svg", &[0]),
    shown(picture!("torque"), &TORQUE_SINGLE, "torque.svg", &[0]),
    shown(picture!("pressure"), &TORQUE_SINGLE, "pressure-volume.svg", &[1]),
    shown(picture!("pressure-volume"), &TORQUE_SET, "cycle-diagrams.svg", &[0, 1]),
    shown(picture!("gas-temperature"), &TORQUE_SET, "cycle-temperature.svg", &[0]),
    shown(picture!("gas-mass"), &TORQUE_SET, "cycle-mass.svg", &[1]),
    shown(picture!("torque-of-three"), &TORQUE_SET, "torque.svg", &[0]),
    shown(picture!("speed-fluctuation"), &TORQUE_SET, "speed-ripple.svg", &[1]),
    shown(picture!("crankpin"), &BEARINGS_SINGLE, "crankpin-1.svg", &[0]),
    shown(picture!("film-orbit"), &FILM, "film-orbits.svg", &[1]),
    shown(picture!("film-thickness"), &FILM, "film-thickness.svg", &[0]),
    shown(picture!("films-over-speed"), &FILM_SPEEDS, "films-over-speed.svg", &[0, 1]),
    shown(picture!("mount-force"), &MOUNTS, "mount-forces.svg", &[0]),
    shown(picture!("mount-mode"), &MOUNTS, "mount-modes.svg", &[3]),
    shown(picture!("campbell"), &TORSION, "torsion-campbell.svg", &[0]),
    shown(picture!("torsion-twist"), &TORSION, "torsion-twist.svg", &[0]),
    shown(picture!("torsion-shapes"), &TORSION, "torsion-modes.svg", &[0]),
    shown(picture!("damper-tuning"), &TUNING, "torsion-tuning.svg", &[0]),
    shown(picture!("bending-free-beam"), &REPORT_FOUR, "bending-moment-free-beam.svg", &[0]),
    shown(picture!("bending-throw-by-throw"), &REPORT_FOUR, "bending-moment-throw-by-throw.svg", &[0]),
    shown(picture!("sensitivity"), &SENSITIVITY, "sensitivity.svg", &[0]),
    shown(picture!("crank-sweep"), &SWEEP, "crank-sweep.svg", &[0, 1]),
    shown(picture!("cancelled"), &CANCELLED, "optimum.svg", &[0]),
    Written { one_figure: true, ..shown(picture!("primary-ellipse"), &FACTOR, "primary-ellipse.svg", &[0]) },
];

/// Some drawings of a figure.
const fn shown(
    file: &'static str,
    arguments: &'static [&'static str],
    figure: &'static str,
    panels: &'static [usize],
) -> Written {
    Written { panels, ..Written::figure(file, arguments, figure) }
}

const REPORT_THREE: [&str; 4] = ["report", "examples/in-line-3.toml", "--output", "-"];
const REPORT_TWIN: [&str; 4] = ["report", "examples/twin-in-line-in-phase.toml", "--output", "-"];
const REPORT_SHAFTS: [&str; 4] = ["report", "examples/real/twin-270.toml", "--output", "-"];
const REPORT_RADIAL: [&str; 4] = ["report", "examples/real/radial-9.toml", "--output", "-"];
const REPORT_FOUR: [&str; 4] = ["report", "examples/in-line-4.toml", "--output", "-"];
const TORQUE_THREE: [&str; 2] = ["torque", "examples/in-line-3.toml"];
const TORQUE_SINGLE: [&str; 2] = ["torque", "examples/single-gas.toml"];
const TORQUE_SET: [&str; 2] = ["torque", "examples/generator-set-3.toml"];
const BEARINGS_SINGLE: [&str; 2] = ["bearings", "examples/single-gas.toml"];
const FILM: [&str; 3] = ["bearings", "examples/in-line-4-crank-by-elements.toml", "--film"];
const FILM_SPEEDS: [&str; 5] = [
    "bearings",
    "examples/in-line-4-crank-by-elements.toml",
    "--film",
    "--speeds",
    "1000 rpm .. 6000 rpm by 500 rpm",
];
const MOUNTS: [&str; 2] = ["mounts", "examples/in-line-4-mounts.toml"];
const TORSION: [&str; 2] = ["torsion", "examples/in-line-6-torsion.toml"];
const TUNING: [&str; 4] = ["torsion", "examples/in-line-6-torsion.toml", "--tune", "damping"];
const SENSITIVITY: [&str; 2] = ["sensitivity", "examples/in-line-3.toml"];
const SWEEP: [&str; 4] = ["balance", "examples/twin-in-line-in-phase.toml", "--method", "sweep"];
const CANCELLED: [&str; 6] = [
    "balance",
    "examples/in-line-3.toml",
    "--shaft",
    "-1 @ 0 mm, 120 mm @ -100 mm, 100 mm",
    "--cancel",
    "couple order 1",
];
const FACTOR: [&str; 4] = ["workshop", "factor", "examples/v6-60.toml", "--least-peak"];
