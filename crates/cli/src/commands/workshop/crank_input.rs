//! A crank with its bobweights, planes and body, from options and a sheet.

use super::given_factor::{bad, given_factor};
use super::sheet::open as open_sheet;
use crate::commands::open;
use crate::failure::Failure;
use crate::options::workshop::CrankInput;
use lanchester::model::Engine;
use lanchester::task::option;
use lanchester::task::workshop::{Rotor, Sheet};
use lanchester::workshop::{
    CrankBody, FactorGiven, FactorRequest, Plane, balance_factors, bobweight_answer, end_planes,
};
use lanchester_files::shown;
use std::path::Path;

/// What the commands about a crank work on.
pub struct Crank {
    pub engine: Engine,
    pub sheet: Option<Sheet>,
    /// Index of the crankshaft.
    pub crankshaft: usize,
    /// One for each throw of the engine [kg].
    pub bobweights: Vec<f64>,
}

pub fn crank(input: &CrankInput, colour: bool) -> Result<Crank, Failure> {
    let given = given_factor(&input.given)?;
    let oil = match &input.oil {
        Some(text) => option::mass(text, "--oil").map_err(bad)?,
        None => 0.0,
    };
    let engine = open(&input.engine, colour)?.file.engine;
    let crankshaft = match input.crankshaft.checked_sub(1) {
        Some(index) if index < engine.crankshafts.len() => index,
        _ => {
            return Err(Failure::input(
                format_args!(
                    "there is no crankshaft {}, the engine has {}",
                    input.crankshaft,
                    engine.crankshafts.len()
                ),
                "count crankshafts from 1",
            ));
        }
    };
    let sheet = match &input.sheet {
        Some(path) => Some(open_sheet(path, colour)?),
        None => None,
    };
    if let (Some(path), Some(sheet)) = (&input.sheet, &sheet) {
        warn_of_another_engine(path, sheet, &input.engine);
    }
    let of_sheet = sheet.as_ref().filter(|sheet| sheet.bobweight.is_some() && given == FactorGiven::AsBuilt);
    let bobweights = match of_sheet {
        Some(_) if input.oil.is_some() => {
            return Err(Failure::input(
                "--oil has no effect: the sheet's pins have their own oil",
                "leave it out",
            ));
        }
        Some(sheet) => {
            // The pins of a sheet stand for the throws of the engine given here, one after the other where it names none.
            let mut sheet = sheet.clone();
            for (index, pin) in sheet.bobweight.iter_mut().flat_map(|b| &mut b.pins).enumerate() {
                pin.throw = pin.throw.or(Some(index + 1));
            }
            let answer = bobweight_answer(&sheet, Some(&engine)).map_err(Failure::refused)?;
            let bob = |throw: usize| answer.bobweights.iter().find(|b| b.throw == Some(throw + 1));
            (0..engine.throws.len()).map(|throw| bob(throw).map_or(0.0, |b| b.mass)).collect()
        }
        None => {
            // Counterweights as built would be in balance with their own bobweights.
            let given =
                if given == FactorGiven::AsBuilt { FactorGiven::ReciprocatingShare(0.5) } else { given };
            let request = FactorRequest { given, oil, angle: Some(std::f64::consts::PI) };
            let factors = balance_factors(&engine, &request).map_err(Failure::refused)?;
            factors.iter().map(|factor| factor.bobweight).collect()
        }
    };
    Ok(Crank { engine, sheet, crankshaft, bobweights })
}

/// A sheet may name its engine; the one given here is used, and the user told where they differ.
fn warn_of_another_engine(path: &Path, sheet: &Sheet, given: &Path) {
    let Some(named) = sheet.engine.as_ref().map(|name| path.with_file_name(name)) else { return };
    let whole = |path: &Path| path.canonicalize().ok();
    if whole(&named) != whole(given) {
        eprintln!(
            "warning: the sheet {} is about {}, and the engine given is {}\nhint: the engine given is used",
            shown(path),
            shown(named),
            shown(given)
        );
    }
}

/// `front=-180 mm, rear=200 mm`
pub fn planes(text: &str) -> Result<[Plane; 2], Failure> {
    match weights_in_planes(text)? {
        ([first, second], [None, None]) => Ok([first, second]),
        _ => Err(Failure::input(
            format_args!("--planes of this command has no radii, got `{text}`"),
            "leave out the `@` and what follows it",
        )),
    }
}

/// `damper=-290 mm @ 70 mm, flywheel=330 mm @ 110 mm`: two planes, and the radius of the weight in each where it is given [m].
pub fn weights_in_planes(text: &str) -> Result<([Plane; 2], [Option<f64>; 2]), Failure> {
    let wrong = || {
        Failure::input(
            format_args!("--planes needs two planes with names, got `{text}`"),
            "write them like --planes 'front=-180 mm, rear=200 mm'",
        )
    };
    let plane = |part: &str| {
        let (name, place) = part.split_once('=').ok_or_else(wrong)?;
        let (z, radius) = place.split_once('@').map_or((place, None), |(z, radius)| (z, Some(radius)));
        let length = |text: &str| option::length(text.trim(), name.trim()).map_err(bad);
        let plane = Plane { name: name.trim().to_owned(), z: length(z)? };
        Ok::<_, Failure>((plane, radius.map(length).transpose()?))
    };
    match text.split(',').collect::<Vec<_>>()[..] {
        [first, second] => {
            let ((first, one), (second, two)) = (plane(first)?, plane(second)?);
            Ok(([first, second], [one, two]))
        }
        _ => Err(wrong()),
    }
}

impl Crank {
    /// The planes of the option, of the sheet, or the outermost of the crank.
    pub fn planes(&self, option: Option<&str>) -> Result<[Plane; 2], Failure> {
        if let Some(text) = option {
            return planes(text);
        }
        let of_sheet: Vec<Plane> = self
            .sheet
            .iter()
            .flat_map(|sheet| &sheet.planes)
            .filter_map(|plane| Some(Plane { name: plane.name.clone(), z: plane.z? }))
            .collect();
        let found = if of_sheet.is_empty() { end_planes(&self.engine, self.crankshaft) } else { of_sheet };
        found.try_into().map_err(|found: Vec<Plane>| {
            Failure::input(
                format_args!("two planes are needed, got {}", found.len()),
                "give them with --planes 'front=-180 mm, rear=200 mm', or as two [[plane]] with z in the sheet",
            )
        })
    }

    /// The crank as a body, where the sheet knows all of it.
    pub fn body(&self) -> Result<Option<CrankBody>, Failure> {
        let Some(Sheet { rotor, .. }) = &self.sheet else { return Ok(None) };
        match rotor {
            Rotor {
                mass: Some(mass),
                centre: Some(mass_centre),
                transverse_inertia: Some(transverse_inertia),
                polar_inertia: Some(polar_inertia),
                ..
            } => Ok(Some(CrankBody {
                mass: *mass,
                mass_centre: *mass_centre,
                transverse_inertia: *transverse_inertia,
                polar_inertia: *polar_inertia,
            })),
            Rotor { transverse_inertia: None, polar_inertia: None, .. } => Ok(None),
            _ => Err(Failure::input(
                "the tilt of the principal axis needs mass, centre, transverse_inertia and polar_inertia in [rotor], got some of them",
                "give all four, with bobweights on, or leave both inertias out",
            )),
        }
    }
}
