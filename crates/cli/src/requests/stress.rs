//! Options of `stress` as requests.

use crate::failure::Failure;
use crate::options::stress::{
    CycleArguments, FactorArguments, FatigueArguments, LawOption, LoadArguments, LoadsOption, MeshArguments,
    PinPressureOption, ReductionOption, RuleArguments, SupportArguments, SupportOption,
};
use crate::trace_files::read_mesh;
use lanchester::file::EngineFile;
use lanchester::flex::crank_case::{CrankSupport, PinPressure};
use lanchester::flex::crank_mesh::CrankMeshOptions;
use lanchester::flex::sparse::Precision;
use lanchester::flex::statics::SolveOptions;
use lanchester::flex::train::{BasisKind, BasisOptions};
use lanchester::report::{CycleLaw, CycleSpeed, FatigueFactors};
use lanchester::task::option;
use lanchester::units::{Bound, Dimension};
use lanchester::value_list;
use lanchester::{
    CycleRequest, FatigueRequest, GivenForce, LoadSource, RuleRequest, SimulateRequest, StaticRequest,
    StressLoad, StressMesh, stress_case,
};

/// Which crankshaft, how fine.
///
/// `usual`: elements across a fillet where neither the option nor the file says how many.
pub fn mesh(own: &MeshArguments, file: &EngineFile, usual: usize) -> Result<StressMesh, Failure> {
    let size = own.size.as_deref().map(|text| option::length(text, "--size")).transpose()?;
    let crankshaft = crankshaft(own.crankshaft)?;
    let usual = CrankMeshOptions { fillet_elements: usual, ..CrankMeshOptions::default() };
    let mesh = StressMesh::of(file.tasks.stress.as_ref(), crankshaft, size, own.fillet_elements, usual);
    read_mesh(mesh, &own.file)
}

/// Index of a crankshaft.
fn crankshaft(number: usize) -> Result<usize, Failure> {
    number.checked_sub(1).ok_or_else(|| {
        Failure::input("--crankshaft counts from 1, got 0", "leave it out for the first crankshaft")
    })
}

fn above_zero(value: f64, name: &str) -> Result<f64, Failure> {
    if value > 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(Failure::input(
        format_args!("{name} needs a number above 0, got {value}"),
        "1 leaves things as they are",
    ))
}

fn factors(own: &FactorArguments) -> Result<FatigueFactors, Failure> {
    Ok(FatigueFactors {
        surface: above_zero(own.surface_factor, "--surface-factor")?,
        size: above_zero(own.size_factor, "--size-factor")?,
        gradient: above_zero(own.gradient_factor, "--gradient-factor")?,
    })
}

/// What is asked of fatigue.
pub fn fatigue_request(own: &FatigueArguments, file: &EngineFile) -> Result<FatigueRequest, Failure> {
    let speed = |text: &String| option::speed(text, "--speed").map_err(Failure::from);
    above_zero(own.safety, "--safety")?;
    Ok(FatigueRequest {
        mesh: mesh(&own.mesh, file, 6)?,
        support: support(&own.support, CrankSupport::Journals)?,
        speeds: own.speed.iter().map(speed).collect::<Result<_, _>>()?,
        gas: !own.inertia_only,
        factors: factors(&own.factors)?,
        instants: own.instants as usize,
        solve: solve_options(&own.mesh)?,
    })
}

/// What is asked of a crankshaft over the cycle.
pub fn cycle_request(own: &CycleArguments, file: &EngineFile) -> Result<CycleRequest, Failure> {
    let law = |law: &LawOption| match law {
        LawOption::Rigid => CycleLaw::Rigid,
        LawOption::Contact => CycleLaw::Contact,
        LawOption::Bushing => CycleLaw::Bushing,
        LawOption::Film => CycleLaw::Film,
        LawOption::File => CycleLaw::File,
    };
    let mut laws: Vec<CycleLaw> = Vec::new();
    for wanted in own.bearings.iter().map(law) {
        if !laws.contains(&wanted) {
            laws.push(wanted);
        }
    }
    if !own.instants.is_multiple_of(8) {
        return Err(Failure::input(
            format_args!("--instants needs a multiple of 8, got {}", own.instants),
            "360 are one a degree",
        ));
    }
    if let Some(damping) = own.damping.filter(|damping| !(0.0..1.0).contains(damping)) {
        return Err(Failure::input(
            format_args!("--damping needs a share from 0 to below 1, got {damping}"),
            "crankshafts of steel have 0.005 to 0.02",
        ));
    }
    own.fatigue_safety.map(|safety| above_zero(safety, "--fatigue-safety")).transpose()?;
    Ok(CycleRequest {
        mesh: mesh(&own.mesh, file, 6)?,
        laws,
        rigid_crank: own.rigid_crankshaft,
        tilt: own.tilt,
        speed: own.speed.as_ref().map(|text| option::speed(text, "--speed")).transpose()?,
        motion: if own.free { CycleSpeed::Free } else { CycleSpeed::Constant },
        gas: !own.inertia_only,
        basis: BasisOptions {
            kind: match own.reduction {
                ReductionOption::FreeInterface => BasisKind::FreeInterface,
                ReductionOption::CraigBampton => BasisKind::CraigBampton,
            },
            modes: own.modes as usize,
            memory: memory(&own.mesh.memory)?,
            ..BasisOptions::default()
        },
        damping: own.damping,
        instants: own.instants as usize,
        most_cycles: own.cycles as usize,
        factors: factors(&own.factors)?,
    })
}

/// What is asked of the formulas of strength.
pub fn rule_request(own: &RuleArguments) -> Result<RuleRequest, Failure> {
    let speed = |text: &String| option::speed(text, "--speed").map_err(Failure::from);
    let torque = |text: &str| {
        let name = "--torsional-vibration";
        option::of_dimension(text, Dimension::Torque, Bound::NotNegative, name).map_err(Failure::from)
    };
    let vibration = own.torsional_vibration.as_deref();
    let vibration = vibration.map(|text| value_list(text, "--torsional-vibration", torque)).transpose()?;
    Ok(RuleRequest {
        crankshaft: crankshaft(own.crankshaft)?,
        speeds: own.speed.iter().map(speed).collect::<Result<_, _>>()?,
        gas: !own.inertia_only,
        vibration: vibration.unwrap_or_default(),
    })
}

/// How fine the throws are meshed for factors by finite elements.
pub fn rule_mesh(own: &RuleArguments, file: &EngineFile) -> Result<StressMesh, Failure> {
    let size = own.size.as_deref().map(|text| option::length(text, "--size")).transpose()?;
    let usual = CrankMeshOptions::default();
    let asked = own.fillet_elements;
    Ok(StressMesh::of(file.tasks.stress.as_ref(), crankshaft(own.crankshaft)?, size, asked, usual))
}

/// How to solve.
pub fn solve_options(own: &MeshArguments) -> Result<SolveOptions, Failure> {
    let precision = if own.double { Precision::Double } else { Precision::Single };
    Ok(SolveOptions { precision, memory: memory(&own.memory)?, ..SolveOptions::default() })
}

/// `4 GiB`, `800 MB`.
pub fn memory(text: &str) -> Result<u64, Failure> {
    let units = [("GiB", 1u64 << 30), ("MiB", 1 << 20), ("GB", 1_000_000_000), ("MB", 1_000_000)];
    let text = text.trim();
    let found = units.iter().find_map(|(unit, bytes)| {
        let number = text.strip_suffix(unit)?.trim().parse::<f64>().ok()?;
        (number > 0.0 && number.is_finite()).then_some((number * *bytes as f64) as u64)
    });
    found.ok_or_else(|| {
        Failure::input(
            format_args!("--memory needs a size above 0 in GiB, MiB, GB or MB, got \"{text}\""),
            "write it like --memory '4 GiB'",
        )
    })
}

/// What holds the crankshaft.
pub fn support(own: &SupportArguments, default: CrankSupport) -> Result<CrankSupport, Failure> {
    if own.stiffness.is_some() && own.support != Some(SupportOption::Springs) {
        return Err(Failure::input(
            "--stiffness is that of --support springs",
            "add --support springs, or leave out --stiffness",
        ));
    }
    let rings = [("--ring-thickness", &own.ring_thickness), ("--ring-modulus", &own.ring_modulus)];
    if let Some((name, _)) = rings.iter().find(|(_, given)| given.is_some())
        && own.support != Some(SupportOption::Rings)
    {
        return Err(Failure::input(
            format_args!("{name} is that of --support rings"),
            format_args!("add --support rings, or leave out {name}"),
        ));
    }
    Ok(match own.support {
        None => default,
        Some(SupportOption::Rings) => {
            let given = |text: &Option<String>, dimension: Dimension, name: &str, usual: f64| match text {
                Some(text) => option::of_dimension(text, dimension, Bound::Positive, name),
                None => Ok(usual),
            };
            CrankSupport::Rings {
                thickness: given(&own.ring_thickness, Dimension::Length, "--ring-thickness", 5e-3)?,
                modulus: given(&own.ring_modulus, Dimension::Pressure, "--ring-modulus", 210e9)?,
            }
        }
        Some(SupportOption::ClampedEnds) => CrankSupport::ClampedEnds,
        Some(SupportOption::Journals) => CrankSupport::Journals,
        Some(SupportOption::Film) => CrankSupport::Films,
        Some(SupportOption::Free) => CrankSupport::Free,
        Some(SupportOption::Springs) => {
            let text = own.stiffness.as_deref().unwrap_or_default();
            CrankSupport::Springs { stiffness: text.split(',').map(stiffness).collect::<Result<_, _>>()? }
        }
    })
}

/// `500 kN/mm`, or `500 kN/mm : 300 kN/mm`: along x and y of the block.
fn stiffness(text: &str) -> Result<[f64; 2], Failure> {
    let of = |text: &str| {
        let text = text.trim();
        option::of_dimension(text, Dimension::Stiffness, Bound::NotNegative, "--stiffness")
            .map_err(Failure::from)
    };
    let (x, y) = text.split_once(':').unwrap_or((text, text));
    Ok([of(x)?, of(y)?])
}

/// A static case: one of the file, or what the options say.
pub fn static_request(
    file: &EngineFile,
    own: &MeshArguments,
    load: &LoadArguments,
    held: &SupportArguments,
) -> Result<StaticRequest, Failure> {
    let mesh = mesh(own, file, 6)?;
    let plain = match &load.case {
        Some(name) => StaticRequest::of_case(stress_case(&file.tasks, name).map_err(Failure::refused)?, mesh),
        None => {
            let support = support(held, CrankSupport::Journals)?;
            if load.inertia_only && !load.force.is_empty() {
                return Err(Failure::input(
                    "--inertia-only beside --force has no effect: forces of your own know no gas",
                    "leave out one of the two",
                ));
            }
            let (load, speeds) = loads(load, &support)?;
            StaticRequest { mesh, support, load, speeds, ..StaticRequest::default() }
        }
    };
    let source = match load.loads {
        LoadsOption::ClosedForm => LoadSource::ClosedForm,
        LoadsOption::Simulation if matches!(plain.load, StressLoad::Given { .. }) => {
            return Err(Failure::input(
                "--loads simulation has no effect on a case with forces of its own",
                "leave out --loads, or choose a case with an angle",
            ));
        }
        LoadsOption::Simulation => LoadSource::of_run(&file.tasks, SimulateRequest::default()),
    };
    let pressure = match load.pin_pressure {
        PinPressureOption::Cosine => PinPressure::Cosine,
        PinPressureOption::Uniform => PinPressure::Uniform,
        PinPressureOption::Film => PinPressure::Film,
    };
    Ok(StaticRequest { gas: !load.inertia_only, source, pressure, solve: solve_options(own)?, ..plain })
}

/// Loads and speeds. `held`: what holds the crankshaft.
fn loads(own: &LoadArguments, held: &CrankSupport) -> Result<(StressLoad, Vec<f64>), Failure> {
    let speed = |text: &String| option::speed(text, "--speed").map_err(Failure::from);
    let speeds = own.speed.iter().map(speed).collect::<Result<Vec<f64>, Failure>>()?;
    let load = match (&own.angle, own.force.is_empty()) {
        (Some(text), true) => {
            let one = |one: &str| option::angle(one, "--angle").map_err(Failure::from);
            StressLoad::Angles(value_list(text, "--angle", one)?)
        }
        (None, true) => StressLoad::Extremes,
        (Some(_), false) if !held.depends_on_angle() => {
            return Err(Failure::input(
                "--angle beside --force has no effect: forces along and across a throw and this support turn with the crankshaft",
                "leave out one of the two; springs with another stiffness along y than along x need both",
            ));
        }
        (angle, false) => {
            let angle = angle.as_deref().map(|text| option::angle(text, "--angle")).transpose()?;
            let forces = own.force.iter().map(|text| force(text)).collect::<Result<_, Failure>>()?;
            StressLoad::Given { forces, angle }
        }
    };
    Ok((load, speeds))
}

/// `1: -65 kN, 10.7 kN`: pin, radial and tangential force; the second one may be left out.
fn force(text: &str) -> Result<GivenForce, Failure> {
    let refuse = || {
        Failure::input(
            format_args!("--force needs a pin and its forces, got \"{text}\""),
            "write it like --force '1: -65 kN, 10.7 kN': number of the pin, radial and tangential force",
        )
    };
    let (pin, forces) = text.split_once(':').ok_or_else(refuse)?;
    let pin = pin.trim().parse::<usize>().map_err(|_| refuse())?;
    let of = |text: &str| {
        option::of_dimension(text.trim(), Dimension::Force, Bound::Any, "--force").map_err(Failure::from)
    };
    let mut parts = forces.split(',');
    let radial = of(parts.next().unwrap_or_default())?;
    let tangential = parts.next().map(of).transpose()?.unwrap_or(0.0);
    if parts.next().is_some() {
        return Err(refuse());
    }
    Ok(GivenForce { pin, radial, tangential })
}
