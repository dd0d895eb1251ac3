//! From the options of `explore` to a search.

use crate::failure::Failure;
use crate::options::explore::{ExploreArguments, SpaceArguments};
use lanchester::model::Engine;
use lanchester::results::Output;
use lanchester::study::explore::{
    Constraint, CounterweightPattern, ExploreRequest, Explorer, Objective, Removes, Sense, ShaftDesign,
    ShaftSet, even_angles,
};
use lanchester::task::{AtLeast, DurabilityCriterion, option};
use lanchester::value_list;
use lanchester::{LayoutChoices, LayoutSpace, layout_space, own_pattern};
use std::f64::consts::TAU;

/// A search with what the user should know of it.
pub struct LayoutSearch {
    pub explorer: Explorer,
    pub notes: Vec<String>,
    /// Films and safeties that are told of the layouts found.
    pub told: Vec<DurabilityCriterion>,
}

/// The search behind the options.
pub fn layout_search(engine: &Engine, arguments: &ExploreArguments) -> Result<LayoutSearch, Failure> {
    let constraints = constraints(arguments)?;
    let choices = choices(engine, &arguments.space)?;
    let LayoutSpace { space, notes } =
        layout_space(engine, &choices, &constraints).map_err(Failure::refused)?;
    let objectives = objectives(arguments)?;
    if let Some((place, twice)) =
        objectives.iter().enumerate().find(|(k, one)| objectives[..*k].contains(one))
    {
        return Err(Failure::input(
            format_args!("--minimise names {} twice, the second time as number {}", twice.name(), place + 1),
            "name it once",
        ));
    }
    // A layout has other numbers of bearings than the engine: what is named goes by the whole.
    let at_least: Vec<AtLeast> = arguments
        .at_least
        .iter()
        .map(|text| AtLeast::read(text, engine, "--at-least"))
        .collect::<Result<_, _>>()?;
    let mut told: Vec<DurabilityCriterion> = arguments
        .durability
        .iter()
        .map(|text| DurabilityCriterion::read(text, engine))
        .collect::<Result<_, _>>()?;
    told.extend(at_least.iter().map(|limit| limit.criterion));
    if told.contains(&DurabilityCriterion::FilletSafety) {
        return Err(Failure::input(
            "fillet safety takes finite elements for every layout, which this search does not compute",
            "name `rule safety`, and judge the layout that you adopt with `lanchester stress fatigue`",
        ));
    }
    let mut once: Vec<DurabilityCriterion> = Vec::new();
    for criterion in told {
        if !once.contains(&criterion) {
            once.push(criterion);
        }
    }
    let request = ExploreRequest {
        at_least,
        most_cases: arguments.most_cases.into(),
        most_on_front: arguments.most_on_front,
        resolution: arguments.resolution,
        ..ExploreRequest::new(space, objectives, constraints)
    };
    Ok(LayoutSearch { explorer: Explorer::new(request).map_err(Failure::refused)?, notes, told: once })
}

fn objectives(arguments: &ExploreArguments) -> Result<Vec<Objective>, Failure> {
    if !arguments.minimise.is_empty() {
        return arguments.minimise.iter().map(|text| objective(text, "--minimise")).collect();
    }
    let mut usual: Vec<Objective> = [1, 2]
        .into_iter()
        .flat_map(|order| [Objective::Force { order }, Objective::Couple { order }])
        .collect();
    if arguments.even_firing.is_none() && !arguments.space.without_firing {
        usual.push(Objective::FiringUnevenness);
    }
    Ok(usual)
}

fn constraints(arguments: &ExploreArguments) -> Result<Vec<Constraint>, Failure> {
    let mut constraints = Vec::new();
    if let Some(tolerance) = &arguments.even_firing {
        let tolerance = option::angle(tolerance, "--even-firing")?;
        constraints.push(Constraint::EvenFiring { tolerance });
    }
    if let Some(least) = &arguments.bearing_room {
        constraints.push(Constraint::BearingRoom { least: option::length(least, "--bearing-room")? });
    }
    if let Some(least) = &arguments.pin_overlap {
        constraints.push(Constraint::PinOverlap { least: option::length(least, "--pin-overlap")? });
    }
    for text in &arguments.limit {
        constraints.push(limit(text)?);
    }
    Ok(constraints)
}

/// "length = 500 mm".
fn limit(text: &str) -> Result<Constraint, Failure> {
    let wrong = |message: String| {
        Failure::input(
            message,
            "write it like --limit 'length = 500 mm' or --limit 'couple order 1 = 20 N m'",
        )
    };
    let Some((name, value)) = text.split_once('=') else {
        return Err(wrong(format!("--limit needs an objective and its largest value, got `{text}`")));
    };
    let objective = objective(name, "--limit")?;
    let value = value.trim();
    let limit = match objective.unit() {
        "m" => option::length(value, "--limit")?,
        "rad" => option::angle(value, "--limit")?,
        "kg m" => option::unbalance(value, "--limit")?,
        unit @ ("N" | "N m") => {
            let (number, factor) = match value.split_once(' ').map(|(number, unit)| (number, unit.trim())) {
                Some((number, given)) if given == unit => (number, 1.0),
                Some((number, given)) if given.strip_prefix('k') == Some(unit) => (number, 1e3),
                _ => {
                    return Err(wrong(format!(
                        "the limit of {} needs {unit} or k{unit}, got `{value}`",
                        name.trim()
                    )));
                }
            };
            let number: f64 =
                number.parse().map_err(|_| wrong(format!("`{number}` in --limit is no number")))?;
            number * factor
        }
        _ => value
            .parse()
            .map_err(|_| wrong(format!("the limit of {} is a plain number, got `{value}`", name.trim())))?,
    };
    Ok(Constraint::AtMost { objective, limit })
}

/// The names of all objectives.
const NAMES: &str = "force order 1, couple order 2, forward force order 1, backward couple order 1, roll moment order 2, inertia \
                     torque order 1, bending moment, main-bearing load, uneven firing, firing order 1.5, neighbours, length, \
                     height, counterweights, shafts";

fn objective(text: &str, option: &str) -> Result<Objective, Failure> {
    let hint = || format!("objectives are {NAMES}; loads have orders 1 and 2");
    let output: Output =
        text.parse().map_err(|error| Failure::input(format!("`{option}`: {error}"), hint()))?;
    let unknown = || Failure::input(format!("layouts are not judged by `{output}` ({option})"), hint());
    Objective::of(&output).ok_or_else(unknown)
}

fn choices(engine: &Engine, arguments: &SpaceArguments) -> Result<LayoutChoices, Failure> {
    let angles = |text: &Option<String>, name: &str| {
        let list = |text: &String| value_list(text, name, |one| option::angle(one, name));
        text.as_ref().map(list).transpose()
    };
    let lengths = |text: &Option<String>, name: &str| {
        let list = |text: &String| value_list(text, name, |one| option::length(one, name));
        text.as_ref().map(list).transpose()
    };
    let length = |text: &Option<String>, name: &str| {
        text.as_ref().map(|text| option::length(text, name)).transpose().map_err(Failure::from)
    };
    let ratio = |one: &str| {
        one.parse().map_err(|_| {
            Failure::input(
                format_args!("--rod-ratio needs plain numbers, got `{one}`"),
                "crank radius over rod length, for example 0.28 .. 0.34 by 0.02",
            )
        })
    };
    let ratios = |text: &String| value_list(text, "--rod-ratio", ratio);
    Ok(LayoutChoices {
        speed: arguments.speed.as_deref().map(|text| option::speed(text, "--speed")).transpose()?,
        cylinders: arguments.cylinders,
        in_line: arguments.in_line,
        bank_angles: angles(&arguments.bank_angle, "--bank-angle")?,
        split_angles: angles(&arguments.split_angle, "--split-angle")?,
        staggers: lengths(&arguments.stagger, "--stagger")?,
        spacings: lengths(&arguments.spacing, "--spacing")?,
        rod_ratios: arguments.rod_ratio.as_ref().map(ratios).transpose()?,
        throw_angles: arguments.throw_angles.as_deref().map(throw_angles).transpose()?,
        counterweights: arguments
            .counterweights
            .as_deref()
            .map(|text| text.split(',').map(|one| pattern(engine, one.trim())).collect())
            .transpose()?,
        shafts: match arguments.shafts.as_slice() {
            [] => None,
            sets => Some(sets.iter().map(|set| shaft_set(set)).collect::<Result<_, _>>()?),
        },
        without_firing: arguments.without_firing,
        web_distance: length(&arguments.web_distance, "--web-distance")?,
        web_thickness: length(&arguments.web_thickness, "--web-thickness")?,
        pin_diameter: length(&arguments.pin_diameter, "--pin-diameter")?,
        end_length: length(&arguments.ends, "--ends")?,
    })
}

/// A list, or "every 30 deg".
fn throw_angles(text: &str) -> Result<Vec<f64>, Failure> {
    let name = "--throw-angles";
    let Some(step) = text.trim().strip_prefix("every ") else {
        return Ok(value_list(text, name, |one| option::angle(one, name))?);
    };
    let step_angle = option::angle(step, name)?;
    let parts = TAU / step_angle;
    if !(step_angle > 0.0 && parts <= 4096.5 && (parts - parts.round()).abs() < 1e-6) {
        return Err(Failure::input(
            format_args!(
                "{name} needs a step that divides the turn, into at most 4096 parts, got `{}`",
                step.trim()
            ),
            "write every 30 deg, every 24 deg, every 22.5 deg, or a list",
        ));
    }
    Ok(even_angles(parts.round() as u32))
}

/// "full on 1001", "100 % + 50 %".
fn pattern(engine: &Engine, text: &str) -> Result<CounterweightPattern, Failure> {
    let (shares, webs) = match text.split_once(" on ") {
        Some((shares, webs)) => (shares.trim(), Some(webs.trim())),
        None => (text, None),
    };
    let share = |text: &str| option::share(text.trim(), "--counterweights").map_err(Failure::from);
    let plain = |rotating, reciprocating| CounterweightPattern {
        name: text.to_owned(),
        rotating,
        reciprocating,
        webs: None,
    };
    let pattern = match (shares, shares.split_once('+')) {
        ("none", _) => plain(0.0, 0.0),
        ("full", _) => plain(1.0, 0.0),
        ("own", _) => CounterweightPattern { name: text.to_owned(), ..own_pattern(engine) },
        (_, Some((rotating, reciprocating))) => plain(share(rotating)?, share(reciprocating)?),
        (only, None) => plain(share(only)?, 0.0),
    };
    let Some(webs) = webs else { return Ok(pattern) };
    if webs.is_empty() || !webs.chars().all(|digit| matches!(digit, '0' | '1')) {
        return Err(Failure::input(
            format_args!("--counterweights needs a 0 or a 1 for each web, from the free end, got `{webs}`"),
            "write it like `full on 100001`: two webs a throw, or pair",
        ));
    }
    Ok(CounterweightPattern { webs: Some(webs.chars().map(|digit| digit == '1').collect()), ..pattern })
}

/// "none", or shafts with semicolons between.
fn shaft_set(text: &str) -> Result<ShaftSet, Failure> {
    let name = text.trim().to_owned();
    if name == "none" {
        return Ok(ShaftSet { name, shafts: Vec::new() });
    }
    let shafts = name.split(';').map(|one| shaft(one.trim())).collect::<Result<_, _>>()?;
    Ok(ShaftSet { name, shafts })
}

/// "-1 @ 0 mm, 100 mm @ couple -80 mm, 80 mm".
fn shaft(text: &str) -> Result<ShaftDesign, Failure> {
    let wrong = || {
        Failure::input(
            format_args!(
                "--shafts needs ORDER @ x, y @ force z (or couple z1, z2, or both z1, z2), got `{text}`"
            ),
            "write it like --shafts '-1 @ 0 mm, 100 mm @ couple -80 mm, 80 mm'; several shafts of a set have semicolons between them",
        )
    };
    let parts: Vec<&str> = text.split('@').map(str::trim).collect();
    let [turns, axis, removes] = parts[..] else { return Err(wrong()) };
    let (order, sense) = match turns.trim_start_matches('+') {
        "1" => (1, Sense::Forward),
        "2" => (2, Sense::Forward),
        "-1" => (1, Sense::Backward),
        "-2" => (2, Sense::Backward),
        _ => return Err(wrong()),
    };
    let lengths = |text: &str| {
        let one = |text: &str| option::length(text.trim(), "--shafts").map_err(Failure::from);
        text.split(',').map(one).collect::<Result<Vec<f64>, Failure>>()
    };
    let axis = lengths(axis)?;
    let (what, planes) = removes.split_once(' ').ok_or_else(wrong)?;
    let planes = lengths(planes)?;
    let removes = match (what, planes.as_slice()) {
        ("force", &[z]) => Removes::Force { z },
        ("couple", &[front, rear]) => Removes::Couple { z: [front, rear] },
        ("both", &[front, rear]) => Removes::Both { z: [front, rear] },
        _ => return Err(wrong()),
    };
    let [x, y] = axis[..] else { return Err(wrong()) };
    Ok(ShaftDesign { order, sense, x, y, removes })
}
