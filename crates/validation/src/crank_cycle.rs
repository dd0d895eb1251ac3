//! The flexible crankshaft of an engine over the cycle in four models of its bearings, and what comes of it as quantities.
//!
//! | quantity | what it is |
//! |---|---|
//! | `cycle stress LAW` | largest von Mises stress of all fillets over the cycle [Pa] |
//! | `cycle angle LAW` | crank angle at which it is [rad] |
//! | `cycle play LAW` | largest distance of the pin of cylinder 1 from the middle of its big end [m] |
//! | `cycle stiffness LAW` | largest load of that big end over its distance [N/m] |
//! | `cycle radial LAW`, `cycle tangential LAW` | largest force of rod 1 on its pin, towards the crank axis and in the sense of rotation [N] |
//! | `cycle radial angle LAW`, `cycle tangential angle LAW` | crank angle at which it is, of those of the run [rad] |
//! | `cycle radial at firing LAW`, `cycle tangential at firing LAW` | the same at the firing top dead centre [N] |
//!
//! LAW is one of `rigid`, `contact`, `bushing` and `film`; the crankshaft yields. The mesh is that of `stress.size` and `stress.fillet elements`; the highest speed of the engine, constant.

use crate::gas_run::traces;
use crate::stress::StressFit;
use lanchester::film::BearingKind;
use lanchester::flex::train::BasisOptions;
use lanchester::model::Engine;
use lanchester::report::{BearingCycle, CrankCycle, CycleLaw};
use lanchester::{CycleRequest, StressMesh, crank_cycle};

/// Instants of a revolution, and modes of the crankshaft.
const INSTANTS: usize = 360;
const MODES: usize = 16;

/// A quantity of a crankshaft over the cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CycleKey {
    what: What,
    law: CycleLaw,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum What {
    Stress,
    Angle,
    Play,
    Stiffness,
    Rod { radial: bool, take: Take },
}

/// What is taken of a force over the cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Take {
    Largest,
    Angle,
    AtFiring,
}

impl CycleKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<CycleKey> {
        let (what, law) = text.strip_prefix("cycle ")?.rsplit_once(' ')?;
        let rod = |name: &str| match name {
            "radial" => Some(true),
            "tangential" => Some(false),
            _ => None,
        };
        let what = match what {
            "stress" => What::Stress,
            "angle" => What::Angle,
            "play" => What::Play,
            "stiffness" => What::Stiffness,
            other => {
                let (name, take) = match other.split_once(' ') {
                    None => (other, Take::Largest),
                    Some((name, "angle")) => (name, Take::Angle),
                    Some((name, "at firing")) => (name, Take::AtFiring),
                    Some(_) => return None,
                };
                What::Rod { radial: rod(name)?, take }
            }
        };
        let law = CycleLaw::FOUR.into_iter().find(|own| own.name() == law)?;
        Some(CycleKey { what, law })
    }

    /// Its value.
    pub fn of(self, found: &CrankCycle) -> Result<f64, String> {
        let run = found.runs.iter().find(|run| run.law == self.law).ok_or("the law was not run")?;
        let worst = run.worst().ok_or_else(|| run.outcome_words())?;
        let big_end = || {
            let is_own = |own: &&BearingCycle| own.kind == BearingKind::Crankpin && own.number == 1;
            run.bearings.iter().find(is_own).ok_or("cylinder 1 has no big end")
        };
        Ok(match self.what {
            What::Stress => worst.peak,
            What::Angle => run.critical_angle(worst),
            What::Play => big_end()?.largest_eccentricity,
            What::Stiffness => {
                let own = big_end()?;
                own.largest_load / own.largest_eccentricity
            }
            What::Rod { radial, take } => {
                let forces = rod_forces(&run.theta, big_end()?, radial);
                let largest = (0..forces.len()).max_by(|a, b| forces[*a].total_cmp(&forces[*b]));
                let largest = largest.ok_or("the run has no instants")?;
                match take {
                    Take::Largest => forces[largest],
                    Take::Angle => run.theta[largest],
                    Take::AtFiring => forces[0],
                }
            }
        })
    }
}

/// Force of a rod on a pin whose throw stands at the crank angle, towards the crank axis or in the sense of rotation: against that of the pin on the rod [N].
fn rod_forces(theta: &[f64], big_end: &BearingCycle, radial: bool) -> Vec<f64> {
    let along = |(theta, [x, y]): (&f64, &[f64; 2])| {
        let (sin, cos) = theta.sin_cos();
        if radial { x * cos + y * sin } else { x * sin - y * cos }
    };
    theta.iter().zip(&big_end.load).map(along).collect()
}

/// Runs an engine, whose cylinder 1 must stand over throw 1 and fire at 0.
pub(crate) fn cycle_of(engine: &Engine, fit: &StressFit) -> Result<CrankCycle, String> {
    let first = engine.cylinders.first().ok_or("the engine has no cylinder")?;
    let place = [first.angle, engine.throws[first.throw].angle, first.firing_angle.unwrap_or(f64::NAN)];
    if place != [0.0; 3] {
        return Err(format!(
            "cylinder 1, its throw and its firing must be at 0 deg, they are at {place:?} rad"
        ));
    }
    let request = CycleRequest {
        mesh: StressMesh { options: fit.mesh(), ..StressMesh::default() },
        basis: BasisOptions { modes: MODES, ..BasisOptions::default() },
        laws: CycleLaw::FOUR.to_vec(),
        instants: INSTANTS,
        ..CycleRequest::default()
    };
    crank_cycle(engine, &traces(), &request, &|_| true).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        assert_eq!(
            CycleKey::parse("cycle angle film"),
            Some(CycleKey { what: What::Angle, law: CycleLaw::Film })
        );
        assert_eq!(
            CycleKey::parse("cycle tangential at firing contact"),
            Some(CycleKey {
                what: What::Rod { radial: false, take: Take::AtFiring },
                law: CycleLaw::Contact
            })
        );
        for name in ["cycle angle", "cycle stress oil", "cycle radial speed film", "cycle axial film"] {
            assert!(CycleKey::parse(name).is_none(), "{name}");
        }
    }

    #[test]
    fn forces_of_the_rod_are_against_those_of_the_pin() {
        let big_end = BearingCycle {
            kind: BearingKind::Crankpin,
            number: 1,
            z: 0.0,
            law: String::new(),
            clearance: None,
            load: vec![[3.0, 0.0], [3.0, 0.0]],
            largest_load: 3.0,
            largest_load_angle: 0.0,
            mean_load: 3.0,
            orbit: Vec::new(),
            largest_eccentricity: 0.0,
            film: None,
        };
        // A pin that pushes its rod up the cylinder is pushed down: towards the axis at top dead centre, onwards a quarter turn later.
        let theta = [0.0, std::f64::consts::FRAC_PI_2];
        let near = |found: Vec<f64>, wanted: [f64; 2]| {
            assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
        };
        near(rod_forces(&theta, &big_end, true), [3.0, 0.0]);
        near(rod_forces(&theta, &big_end, false), [0.0, 3.0]);
    }
}
