//! The workshop about an engine: balance factors, the unbalance of its crank with bobweights, weights outside, which part into which cylinder.

use crate::answer::{Data, Shown};
use crate::failure::Failure;
use crate::native_sheet::{NativeSheet, ReadSheet};
use crate::options::{Options, PlaneGiven};
use crate::question::{How, Question, Run};
use lanchester::model::{Cylinder, Engine};
use lanchester::report::workshop::{
    crank_figure, crank_tables, crank_text, external_tables, external_text, factor_tables, factor_text,
    primary_ellipse_figure,
};
use lanchester::report::{Table, assignment_table, assignment_text};
use lanchester::study::scatter::{Assignment, AssignmentRequest, WeighedRod, assign, standard_lever};
use lanchester::task::workshop::Rotor;
use lanchester::workshop::{
    CrankBody, CrankUnbalance, ExternalBalance, FactorAnswer, FactorGiven, FactorRequest, Plane,
    balance_factors, bobweight_answer, crank_unbalance, end_planes, external_balance, factor_answer,
};
use serde::{Serialize, Serializer};
use std::f64::consts::PI;
use std::sync::Arc;

pub(super) const QUESTIONS: [Question; 4] = [
    Question::of::<FactorAnswer>("balance_factor", How::Short, read_factor),
    Question::of::<CrankUnbalance>("crank_unbalance", How::Short, read_unbalance),
    Question::of::<ExternalBalance>("external_balance", How::Short, read_external),
    Question::of::<Assignment>("assign_parts", How::Long, read_assign),
];

/// The factor by one of its definitions; [`FactorGiven::AsBuilt`] where none is given.
fn given_factor(options: &Options<'_>) -> Result<FactorGiven, Failure> {
    let least_peak = options.flag("least_peak")?.unwrap_or(false).then_some(FactorGiven::LeastPeak);
    let given = [
        ("reciprocating_share", options.share("reciprocating_share")?.map(FactorGiven::ReciprocatingShare)),
        ("wet_share", options.share("wet_share")?.map(FactorGiven::WetReciprocatingShare)),
        ("total_share", options.share("total_share")?.map(FactorGiven::TotalShare)),
        ("bobweight", options.mass("bobweight")?.map(FactorGiven::Bobweight)),
        ("bobweight_share", options.share("bobweight_share")?.map(FactorGiven::BobweightShare)),
        ("counterweight", options.unbalance("counterweight")?.map(FactorGiven::Counterweight)),
        ("axis_ratio", options.number("axis_ratio")?.map(FactorGiven::AxisRatio)),
        ("least_peak", least_peak),
    ];
    let given: Vec<(&str, FactorGiven)> =
        given.into_iter().filter_map(|(name, own)| Some((name, own?))).collect();
    match given.as_slice() {
        [] => Ok(FactorGiven::AsBuilt),
        [("wet_share", _)] if options.mass("oil")?.is_none() => Err(Failure::option(
            "`wet_share` counts the oil of the throws as rotating, and `oil` is not given",
            "add oil=\"12 g\", or use `reciprocating_share`",
        )),
        [(_, own)] => Ok(*own),
        [(first, _), (second, _), ..] => Err(Failure::option(
            format_args!("`{first}` and `{second}` both give the balance factor"),
            "give one of them",
        )),
    }
}

fn read_factor(options: &Options<'_>) -> Result<Run, Failure> {
    let request = FactorRequest {
        given: given_factor(options)?,
        oil: options.mass("oil")?.unwrap_or(0.0),
        angle: options.angle("angle")?,
    };
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let found = factor_answer(own.engine(), &request).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| factor_text(found),
                tables: |found, _| factor_tables(found),
                figures: |found, _| primary_ellipse_figure(found).into_iter().collect(),
                ..Shown::default()
            },
        ))
    }))
}

/// A crank as it is asked for: which, and what its bobweights stand for.
struct AskedCrank {
    crankshaft: usize,
    given: FactorGiven,
    oil: Option<f64>,
    sheet: Option<Arc<ReadSheet>>,
}

impl AskedCrank {
    fn read(options: &Options<'_>) -> Result<AskedCrank, Failure> {
        let sheet = options.object::<NativeSheet>("sheet", "a WorkshopSheet")?;
        Ok(AskedCrank {
            crankshaft: options.whole("crankshaft", 0, 100)?.unwrap_or(0) as usize,
            given: given_factor(options)?,
            oil: options.mass("oil")?,
            sheet: sheet.map(|sheet| sheet.get().read.clone()),
        })
    }

    /// The index of the crankshaft, and a bobweight for each throw of the engine [kg].
    fn of(&self, engine: &Engine) -> Result<(usize, Vec<f64>), Failure> {
        let count = engine.crankshafts.len();
        if self.crankshaft >= count {
            return Err(Failure::option(
                format_args!(
                    "`crankshaft` needs an index from 0 to {}, got {}",
                    count.saturating_sub(1),
                    self.crankshaft
                ),
                "indices count from 0",
            ));
        }
        let of_sheet = self.sheet.as_ref().map(|own| &own.sheet);
        let of_sheet = of_sheet.filter(|own| own.bobweight.is_some() && self.given == FactorGiven::AsBuilt);
        let bobweights = match of_sheet {
            Some(_) if self.oil.is_some() => {
                return Err(Failure::option(
                    "`oil` has no effect: the pins of the sheet have their own oil",
                    "leave it out",
                ));
            }
            Some(sheet) => {
                // The pins of a sheet stand for the throws of this engine, one after the other where it names none.
                let mut sheet = sheet.clone();
                for (index, pin) in sheet.bobweight.iter_mut().flat_map(|own| &mut own.pins).enumerate() {
                    pin.throw = pin.throw.or(Some(index + 1));
                }
                let answer = bobweight_answer(&sheet, Some(engine)).map_err(Failure::refused)?;
                let of = |throw: usize| answer.bobweights.iter().find(|own| own.throw == Some(throw + 1));
                (0..engine.throws.len()).map(|throw| of(throw).map_or(0.0, |own| own.mass)).collect()
            }
            None => {
                // Counterweights as built would be in balance with their own bobweights.
                let given = match self.given {
                    FactorGiven::AsBuilt => FactorGiven::ReciprocatingShare(0.5),
                    given => given,
                };
                let request = FactorRequest { given, oil: self.oil.unwrap_or(0.0), angle: Some(PI) };
                let factors = balance_factors(engine, &request).map_err(Failure::refused)?;
                factors.iter().map(|factor| factor.bobweight).collect()
            }
        };
        Ok((self.crankshaft, bobweights))
    }

    /// The crank as a body, where the sheet knows all of it.
    fn body(&self) -> Result<Option<CrankBody>, Failure> {
        match self.sheet.as_ref().map(|own| &own.sheet.rotor) {
            Some(Rotor {
                mass: Some(mass),
                centre: Some(mass_centre),
                transverse_inertia: Some(transverse_inertia),
                polar_inertia: Some(polar_inertia),
                ..
            }) => Ok(Some(CrankBody {
                mass: *mass,
                mass_centre: *mass_centre,
                transverse_inertia: *transverse_inertia,
                polar_inertia: *polar_inertia,
            })),
            None | Some(Rotor { transverse_inertia: None, polar_inertia: None, .. }) => Ok(None),
            Some(_) => Err(Failure::option(
                "the tilt of the principal axis needs mass, centre, transverse_inertia and polar_inertia in [rotor] of the sheet, got some of them",
                "give all four, with bobweights on, or leave both inertias out",
            )),
        }
    }
}

/// Two planes, each with the radius of its weight where it is given.
fn two(planes: Vec<PlaneGiven>) -> Result<([Plane; 2], [Option<f64>; 2]), Failure> {
    let (found, radii): (Vec<Plane>, Vec<Option<f64>>) =
        planes.into_iter().map(|own| (Plane { name: own.name, z: own.z }, own.radius)).unzip();
    let count = found.len();
    let wrong = || {
        Failure::option(
            format_args!("`planes` needs two planes, got {count}"),
            "write planes={\"front\": \"-180 mm\", \"rear\": \"200 mm\"}",
        )
    };
    Ok((found.try_into().map_err(|_| wrong())?, radii.try_into().map_err(|_| wrong())?))
}

fn read_unbalance(options: &Options<'_>) -> Result<Run, Failure> {
    let crank = AskedCrank::read(options)?;
    let body = crank.body()?;
    let given = match options.planes("planes")?.map(two).transpose()? {
        Some((_, [None, None])) | None => options.planes("planes")?.map(two).transpose()?.map(|(own, _)| own),
        Some(_) => {
            return Err(Failure::option(
                "`planes` has no radii here: an unbalance is mass times radius",
                "give z alone, as in planes={\"front\": \"-180 mm\", \"rear\": \"200 mm\"}",
            ));
        }
    };
    let of_sheet: Vec<PlaneGiven> = match &crank.sheet {
        Some(own) => {
            let planes = own.sheet.planes.iter();
            planes
                .filter_map(|plane| Some(PlaneGiven { name: plane.name.clone(), z: plane.z?, radius: None }))
                .collect()
        }
        None => Vec::new(),
    };
    let planes = match (given, of_sheet.is_empty()) {
        (None, false) => Some(two(of_sheet)?.0),
        (given, _) => given,
    };
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let engine = own.engine();
        let (crankshaft, bobweights) = crank.of(engine)?;
        let planes = match &planes {
            Some(planes) => planes.clone(),
            None => {
                let ends = end_planes(engine, crankshaft).into_iter();
                let ends = ends.map(|own| PlaneGiven { name: own.name, z: own.z, radius: None });
                two(ends.collect())?.0
            }
        };
        let found =
            crank_unbalance(engine, crankshaft, &bobweights, &planes, body).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| crank_text(found),
                tables: |found, _| crank_tables(found),
                figures: |found, _| vec![crank_figure(found)],
                ..Shown::default()
            },
        ))
    }))
}

fn read_external(options: &Options<'_>) -> Result<Run, Failure> {
    let crank = AskedCrank::read(options)?;
    let (planes, radii) = two(options.planes("planes")?.unwrap_or_default())?;
    let keep = options.share("keep")?.unwrap_or(1.0);
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let (crankshaft, bobweights) = crank.of(own.engine())?;
        let found = external_balance(own.engine(), crankshaft, &bobweights, &planes, radii, keep)
            .map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| external_text(found),
                tables: |found, _| external_tables(found),
                ..Shown::default()
            },
        ))
    }))
}

/// Where the parts go, with what they were.
struct Assigned {
    request: AssignmentRequest,
    found: Assignment,
}

impl Serialize for Assigned {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.found.serialize(serializer)
    }
}

impl Assigned {
    fn table(&self) -> Table {
        assignment_table(&self.request, &self.found)
    }
}

fn read_assign(options: &Options<'_>) -> Result<Run, Failure> {
    let masses = |name: &'static str| {
        let masses = options.masses(name)?;
        match masses.iter().find(|mass| **mass <= 0.0) {
            Some(mass) => Err(Failure::option(
                format_args!("`{name}` needs masses above 0, got {mass} kg"),
                "give what the scales show",
            )),
            None => Ok((name, masses)),
        }
    };
    let [pistons, big_ends, small_ends] = [masses("pistons")?, masses("big_ends")?, masses("small_ends")?];
    let (lever, speed) = (options.length("lever")?, options.speed("speed")?);
    if [&pistons, &big_ends, &small_ends].into_iter().all(|(_, masses)| masses.is_empty()) {
        return Err(Failure::option(
            "nothing is weighed",
            "give `pistons`, `big_ends` or `small_ends`, one mass for each cylinder in the order of the parts",
        ));
    }
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let engine = own.engine();
        let of = |(name, weighed): &(&str, Vec<f64>), mass: fn(&Cylinder) -> f64| {
            let (got, needed) = (weighed.len(), engine.cylinders.len());
            match got {
                0 => Ok(engine.cylinders.iter().map(mass).collect()),
                got if got == needed => Ok(weighed.clone()),
                _ => Err(Failure::option(
                    format_args!("`{name}` needs {needed} masses, one for each cylinder, got {got}"),
                    "weigh every part",
                )),
            }
        };
        let pistons: Vec<f64> = of(&pistons, |cylinder| cylinder.piston_mass)?;
        let big_ends: Vec<f64> = of(&big_ends, |cylinder| cylinder.rod.big_end_mass)?;
        let small_ends: Vec<f64> = of(&small_ends, |cylinder| cylinder.rod.small_end_mass)?;
        let rods = big_ends.into_iter().zip(small_ends);
        let rods = rods.map(|(big_end_mass, small_end_mass)| WeighedRod { big_end_mass, small_end_mass });
        let request = AssignmentRequest {
            speed,
            pistons,
            rods: rods.collect(),
            lever: lever.unwrap_or_else(|| standard_lever(engine)),
            engine: engine.clone(),
        };
        let found = assign(&request).map_err(Failure::refused)?;
        Ok(Data::new(
            Assigned { request, found },
            own,
            Shown {
                text: |own, _| assignment_text(&own.request, &own.found),
                tables: |own, _| vec![own.table()],
                ..Shown::default()
            },
        ))
    }))
}
