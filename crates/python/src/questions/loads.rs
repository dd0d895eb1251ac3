//! What shakes the block: loads, shear and bending, the block on its mounts, the inertias of what turns.

use crate::answer::{Data, Shown};
use crate::failure::Failure;
use crate::options::Options;
use crate::prepared::Prepared;
use crate::question::{How, Question, Run};
use lanchester::mechanism::{
    InternalMoments, InternalRequest, Kinematics, LoadRequest, Loads, MountStudy, PeakMode, RotorEffects,
    internal_cases, loads,
};
use lanchester::report::{
    articulation_table, couple_orders_table, cylinders_table, findings_table, force_orders_table,
    internal_figures, internal_table, internal_text, loads_sections, loads_text, mains_table, motion_table,
    mount_figures, mount_tables, mounts_text, parts_table, peaks_table, rod_inertia_table, roll_orders_table,
};
use lanchester::{Inertias, MountSpeeds, inertias, mounts_with_rotors};
use schemars::JsonSchema;
use serde::ser::Error as _;
use serde::{Serialize, Serializer};
use std::sync::{Arc, OnceLock};

pub(super) const QUESTIONS: [Question; 4] = [
    Question::of::<AllLoads>("loads", How::Short, read_loads),
    Question::of::<Bending>("bending", How::Short, read_bending),
    Question::of::<MountStudy>("mounts", How::Long, read_mounts),
    Question::of::<Inertias>("inertias", How::Short, read_inertias),
];

/// Most angles of a curve in one revolution.
const MOST_SAMPLES: u64 = 100_000;

/// The request that `loads` and `bending` share.
pub(super) fn load_request(options: &Options<'_>) -> Result<LoadRequest, Failure> {
    let usual = LoadRequest::default();
    Ok(LoadRequest {
        speed: options.speed("speed")?,
        reference: options.point("about")?.unwrap_or(usual.reference),
        kinematics: options.text("series")?.map_or(Ok(usual.kinematics), |text| series(&text))?,
        max_order: options.whole("orders", 1, 1000)?.map_or(usual.max_order, |orders| orders as u32),
        samples: options.whole("samples", 1, MOST_SAMPLES)?.map_or(usual.samples, |count| count as usize),
        peaks: options
            .whole("grid", 4, MOST_SAMPLES)?
            .map_or(usual.peaks, |angles| PeakMode::Grid(angles as usize)),
    })
}

/// `exact`, `orders:N` or `power:N:P`.
fn series(text: &str) -> Result<Kinematics, Failure> {
    let parts: Vec<&str> = text.split(':').collect();
    let number = |part: &str| part.trim().parse::<u32>().ok();
    let kinematics = match parts[..] {
        ["exact"] => Some(Kinematics::Exact),
        ["orders", max] => number(max).map(Kinematics::Orders),
        ["power", max_order, max_power] => number(max_order)
            .zip(number(max_power))
            .map(|(max_order, max_power)| Kinematics::PowerSeries { max_order, max_power }),
        _ => None,
    };
    kinematics.ok_or_else(|| {
        Failure::option(
            format_args!("`series` must be exact, orders:N or power:N:P, got \"{text}\""),
            "power:4:5 is the series of most textbooks: orders 1, 2, 4 with powers of the rod ratio up to 5",
        )
    })
}

/// Angles a revolution of the shear forces and bending moments beside the loads, as the command line has them.
const INTERNAL_ANGLES: usize = 72;

/// Loads with what they do inside the crankshafts.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Loads")]
struct AllLoads {
    #[serde(flatten)]
    loads: Loads,
    /// Shear forces and bending moments inside the crankshafts: the case asked for, then those to compare it with. Computed when they
    /// are looked at.
    #[schemars(with = "Vec<InternalMoments>")]
    internal: Internal,
}

/// What is computed when somebody looks at it.
struct Internal {
    engine: Arc<Prepared>,
    request: InternalRequest,
    cases: OnceLock<Result<Vec<InternalMoments>, String>>,
}

impl Internal {
    fn cases(&self) -> &Result<Vec<InternalMoments>, String> {
        let find = || internal_cases(self.engine.engine(), &self.request).map_err(|error| error.to_string());
        self.cases.get_or_init(find)
    }
}

impl Serialize for Internal {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.cases().as_ref().map_err(S::Error::custom)?.serialize(serializer)
    }
}

/// Share of the reciprocating forces that counts in shear and bending, from 0 to 1.
fn bending_share(options: &Options<'_>, name: &str) -> Result<f64, Failure> {
    match options.share(name)? {
        None => Ok(InternalRequest::default().reciprocating_share),
        Some(share) if (0.0..=1.0).contains(&share) => Ok(share),
        Some(share) => Err(Failure::option(
            format_args!("`{name}` needs a share from 0 to 1, got {share}"),
            "write it like 0.5 or \"50 %\"",
        )),
    }
}

fn read_loads(options: &Options<'_>) -> Result<Run, Failure> {
    let request = load_request(options)?;
    let usual = InternalRequest::default();
    let internal = InternalRequest {
        speed: request.speed,
        kinematics: request.kinematics,
        reciprocating_share: bending_share(options, "bending_share")?,
        samples: request.samples.min(INTERNAL_ANGLES),
        ..usual
    };
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let found = loads(own.engine(), &request).map_err(Failure::refused)?;
        let internal = Internal { engine: own.clone(), request: internal.clone(), cases: OnceLock::new() };
        Ok(Data::new(
            AllLoads { loads: found, internal },
            own,
            Shown {
                text: |found, engine| {
                    let internal = found.internal.cases();
                    let cases = internal.as_ref().map_or(String::new(), |cases| internal_text(engine, cases));
                    loads_text(&found.loads) + &cases
                },
                tables: |found, _| {
                    let found = &found.loads;
                    let tables = [
                        findings_table(found),
                        peaks_table(found),
                        force_orders_table(found),
                        couple_orders_table(found),
                        roll_orders_table(found),
                        parts_table(found),
                        cylinders_table(found),
                        motion_table(found),
                    ];
                    let others = [articulation_table(found), rod_inertia_table(found)];
                    tables.into_iter().chain(others.into_iter().flatten()).collect()
                },
                figures: |found, engine| {
                    loads_sections(engine, &found.loads)
                        .iter()
                        .flat_map(|section| section.figures())
                        .cloned()
                        .collect()
                },
                ..Shown::default()
            },
        ))
    }))
}

/// Shear forces and bending moments inside the crankshafts, and what the main bearings carry of them.
#[derive(Debug, Serialize, JsonSchema)]
struct Bending {
    /// With the counterweights of the engine and without, as far as they differ.
    cases: Vec<InternalMoments>,
}

fn read_bending(options: &Options<'_>) -> Result<Run, Failure> {
    let LoadRequest { speed, kinematics, .. } = load_request(options)?;
    let usual = InternalRequest::default();
    let request = InternalRequest {
        speed,
        kinematics,
        reciprocating_share: bending_share(options, "reciprocating_share")?,
        samples: options.whole("samples", 8, MOST_SAMPLES)?.map_or(usual.samples, |count| count as usize),
        ..usual
    };
    Ok(Box::new(move |engines, _| {
        let cases = internal_cases(engines[0].engine(), &request).map_err(Failure::refused)?;
        Ok(Data::new(
            Bending { cases },
            &engines[0],
            Shown {
                text: |found, engine| internal_text(engine, &found.cases),
                tables: |found, engine| {
                    let cases = &found.cases;
                    vec![internal_table(engine, cases), mains_table(engine, cases)]
                },
                figures: |found, engine| internal_figures(engine, &found.cases),
                ..Shown::default()
            },
        ))
    }))
}

fn read_mounts(options: &Options<'_>) -> Result<Run, Failure> {
    let speeds = match options.speeds("speeds")? {
        list if list.is_empty() => {
            MountSpeeds::Range(options.whole("steps", 2, 10_000)?.map_or(61, |steps| steps as usize))
        }
        list => MountSpeeds::List(list),
    };
    let orders = options.whole("orders", 1, 100)?.map_or(8, |orders| orders as u32);
    let gas = options.flag("gas")?.unwrap_or(true);
    let points = options.points("points")?;
    let words = [
        ("both", RotorEffects::BOTH),
        ("couple", RotorEffects::COUPLE),
        ("roll", RotorEffects::ROLL),
        ("none", RotorEffects::NONE),
    ];
    let effects = options.word("rotors", &words)?.unwrap_or_default();
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let traces = if gas { Some(own.traces()?) } else { None };
        let found = mounts_with_rotors(own.engine(), &speeds, orders, traces, &points, effects)
            .map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| mounts_text(found),
                tables: |found, _| mount_tables(found),
                figures: |found, engine| mount_figures(engine, found),
                ..Shown::default()
            },
        ))
    }))
}

fn read_inertias(_: &Options<'_>) -> Result<Run, Failure> {
    Ok(Box::new(|engines, _| {
        let own = &engines[0];
        let found = inertias(own.engine(), &own.file.tasks);
        Ok(Data::new(
            found,
            own,
            Shown {
                tables: |found, _| {
                    let throws: Vec<_> = found
                        .throws
                        .iter()
                        .map(|own| (own.crankshaft, own.throw, own.mass, own.inertia))
                        .collect();
                    let driveline: Vec<_> =
                        found.driveline.iter().map(|own| (own.ratio, own.inertia.value)).collect();
                    vec![lanchester::report::inertia_table(&found.bodies, &throws, &driveline, &found.sum)]
                },
                ..Shown::default()
            },
        ))
    }))
}
