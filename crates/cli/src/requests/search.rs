//! From the options of `balance --search` to its request.

use crate::arguments::{BalanceArguments, CrankWeights};
use crate::commands::open;
use crate::failure::Failure;
use crate::options::search::Drive;
use crate::options::share::share;
use lanchester::balance::{
    self, ArrangementRequest, DriveRule, Judged, MountPlaces, PartSizes, Positions, Target, searched_engine,
};
use lanchester::model::Engine;
use lanchester::task::option;
use lanchester::task::{Criterion, Limit, criterion};

/// The request behind the options; a reference engine is read on the way.
pub fn arrangement_request(
    engine: &Engine,
    arguments: &BalanceArguments,
    colour: bool,
) -> Result<ArrangementRequest, Failure> {
    let search = &arguments.search;
    let mut request = ArrangementRequest::default();
    if let Some(text) = &search.mount_spacing {
        request.mounts = MountPlaces::Spacing(positive(text, "--mount-spacing")?);
    }
    let engine = &searched_engine(engine, &request, 1.0).map_err(Failure::refused)?;
    request.criterion = judged(engine, arguments)?;
    for text in &arguments.limit {
        add_limit(engine, &mut request, text)?;
    }
    add_reference(&mut request, arguments, colour)?;
    if let Some(text) = &search.spacing {
        let spacing = |text: &str| {
            let length = length(text, "--spacing")?;
            if length >= 0.0 {
                return Ok(length);
            }
            Err(Failure::input(
                format_args!("--spacing needs lengths of 0 or more, got {}", text.trim()),
                "0 mm puts all cylinders into one plane",
            ))
        };
        request.spacings = text.split(',').map(spacing).collect::<Result<_, _>>()?;
    }
    if let Some(most) = search.most_shafts {
        if most > 4 {
            return Err(Failure::input(
                format_args!("--max-shafts needs 0 to 4, got {most}"),
                "more than one for each order and sense is no use: two of them act as one",
            ));
        }
        request.most_shafts = most;
    }
    if let Some(text) = &search.shaft_orders {
        request.shaft_orders = orders(text)?;
    }
    request.crank = match arguments.counterweights {
        None => request.crank,
        Some(CrankWeights::None) => balance::CrankWeights::None,
        Some(CrankWeights::Throws) => balance::CrankWeights::Throws,
        Some(CrankWeights::File | CrankWeights::Webs) => {
            return Err(Failure::input(
                "--search adds weights to those of the file: --counterweights file and webs have no meaning with it",
                "leave --counterweights out for weights at the outermost throws, or give throws or none",
            ));
        }
    };
    request.positions = positions(&search.place, search.place_step.as_deref())?;
    if let Some(text) = &search.shaft_planes {
        let planes: Vec<f64> =
            text.split(',').map(|z| length(z, "--shaft-planes")).collect::<Result<_, _>>()?;
        match planes[..] {
            [front, rear] if front < rear => request.shaft_planes = Some([front, rear]),
            _ => {
                return Err(Failure::input(
                    format_args!("--shaft-planes needs two planes z1, z2 with z1 below z2, got {text}"),
                    "for example --shaft-planes '-44 mm, 44 mm'",
                ));
            }
        }
    }
    if search.drive == Some(Drive::Chain) {
        request.drive = DriveRule::ChainOrBelt;
    }
    for text in &search.size {
        set_size(&mut request.parts, text)?;
    }
    Ok(request)
}

fn length(text: &str, option: &str) -> Result<f64, Failure> {
    option::length(text.trim(), option).map_err(Failure::from)
}

fn positive(text: &str, option: &str) -> Result<f64, Failure> {
    let length = length(text, option)?;
    if length > 0.0 {
        return Ok(length);
    }
    Err(Failure::input(
        format_args!("{option} needs a length above 0, got {}", text.trim()),
        format_args!("for example {option} '80 mm'"),
    ))
}

/// The one criterion, for an engine with the mounts that count; without one the mount force where mounts are given with an
/// option, else the force.
fn judged(engine: &Engine, arguments: &BalanceArguments) -> Result<Judged, Failure> {
    let text = match &arguments.minimise[..] {
        [] if arguments.search.mount_spacing.is_some() => return Ok(Judged::MountForce),
        [] => return Ok(Judged::Force),
        [one] => one,
        several => {
            return Err(Failure::input(
                format_args!("--search judges by one criterion, got {}", several.len()),
                "give --minimise once; what else must hold is a --limit",
            ));
        }
    };
    needs_mounts(engine, text)?;
    let known = criterion(text, engine).map_err(Failure::from)?;
    [Judged::Force, Judged::Couple, Judged::MountForce]
        .into_iter()
        .find(|judged| judged.criterion() == known)
        .ok_or_else(|| {
            Failure::input(
                format_args!("--search judges by force, couple or mount force, got `{}`", text.trim()),
                "what else must hold is a --limit, e.g. --limit 'roll moment = 400 N m'",
            )
        })
}

/// A force at mounts needs mounts: the file's, or two by option.
fn needs_mounts(engine: &Engine, text: &str) -> Result<(), Failure> {
    if engine.mounts.is_empty() && text.trim().starts_with("mount force") {
        return Err(Failure::input(
            "`mount force` needs the places of the mounts, and the engine file has none",
            "give --mount-spacing, or tables [[mount]] in the engine file",
        ));
    }
    Ok(())
}

/// A limit on the criterion is what is good enough, any other must hold for every arrangement.
fn add_limit(engine: &Engine, request: &mut ArrangementRequest, text: &str) -> Result<(), Failure> {
    needs_mounts(engine, text)?;
    let limit = option::limit(text, engine, "--limit").map_err(Failure::from)?;
    if let Criterion::AddedMass = limit.criterion {
        return Err(Failure::input(
            "--search has no limit on the added mass",
            "the table lists the mass of every arrangement; `added unbalance` can be limited",
        ));
    }
    if limit.criterion == request.criterion.criterion() {
        if limit.most <= 0.0 {
            return Err(Failure::input(
                format_args!(
                    "the limit of `{}` must be above 0, got {}",
                    request.criterion.name(),
                    text.trim()
                ),
                "without a limit the table shows which arrangement leaves least",
            ));
        }
        request.target = Target::Limit { most: limit.most };
        return Ok(());
    }
    let same = |known: &Limit| known.criterion == limit.criterion;
    request.limits.retain(|known| !same(known));
    request.limits.push(limit);
    Ok(())
}

fn add_reference(
    request: &mut ArrangementRequest,
    arguments: &BalanceArguments,
    colour: bool,
) -> Result<(), Failure> {
    let Some(path) = &arguments.search.reference else { return Ok(()) };
    if request.target != Target::None {
        return Err(Failure::input(
            format_args!(
                "what is good enough is told twice: by --reference and by a --limit on {}",
                request.criterion.name()
            ),
            "leave one of them out",
        ));
    }
    let share = match &arguments.search.share {
        None => 1.0,
        Some(text) => share(text)?,
    };
    let engine = Box::new(open(path, colour)?.file.engine);
    if request.criterion == Judged::MountForce
        && request.mounts == MountPlaces::Engine
        && engine.mounts.is_empty()
    {
        return Err(Failure::input(
            format_args!("`mount force` needs the mounts of {}, and its file has none", engine.name),
            "give --mount-spacing for both engines, or tables [[mount]] in the file of the reference",
        ));
    }
    request.target = Target::Reference { engine, share };
    Ok(())
}

fn orders(text: &str) -> Result<Vec<u32>, Failure> {
    let mut orders = Vec::new();
    for part in text.split(',').map(str::trim) {
        match part.parse::<u32>() {
            Ok(order @ (1 | 2)) if !orders.contains(&order) => orders.push(order),
            Ok(1 | 2) => {}
            _ => {
                return Err(Failure::input(
                    format_args!("--shaft-orders needs 1, 2 or both, got `{text}`"),
                    "for example --shaft-orders '1, 2'; without shafts: --max-shafts 0",
                ));
            }
        }
    }
    orders.sort_unstable();
    Ok(orders)
}

/// Points, one box, or the ring around the crank.
fn positions(places: &[String], step: Option<&str>) -> Result<Positions, Failure> {
    const EXAMPLES: &str =
        "for example --place '-120 mm, 0 mm' or --place '-200 mm .. -90 mm, -150 mm .. 150 mm'";
    let wrong = |text: &str| {
        Failure::input(
            format_args!("--place needs a point x, y or a box of two ranges, got `{text}`"),
            EXAMPLES,
        )
    };
    let boxed = places.iter().any(|place| place.contains(".."));
    if step.is_some() && !boxed {
        return Err(Failure::input("--place-step needs a box in --place", EXAMPLES));
    }
    match places {
        [] => Ok(ArrangementRequest::default().positions),
        [text] if boxed => {
            let Some((x, y)) = text.split_once(',') else { return Err(wrong(text)) };
            let range = |text: &str| {
                let (from, to) = text.split_once("..").unwrap_or((text, text));
                let range = [length(from, "--place")?, length(to, "--place")?];
                if range[0] <= range[1] {
                    return Ok(range);
                }
                Err(Failure::input(
                    format_args!(
                        "a range of --place runs from the smaller to the larger, got {}",
                        text.trim()
                    ),
                    EXAMPLES,
                ))
            };
            let (x, y) = (range(x)?, range(y)?);
            let step = step.map_or(Ok(0.01), |text| positive(text, "--place-step"))?;
            let count: f64 = [x, y].map(|[from, to]| ((to - from) / step + 1.0).floor()).iter().product();
            if count > 400.0 {
                return Err(Failure::input(
                    format_args!("the box of --place has {count} points, and at most 400 are tried"),
                    "make --place-step larger or the box smaller",
                ));
            }
            Ok(Positions::Box { x, y, step })
        }
        several if boxed => Err(Failure::input(
            format_args!("--place takes one box or several points, got {} of both", several.len()),
            EXAMPLES,
        )),
        points => {
            let point = |text: &String| {
                let Some((x, y)) = text.split_once(',') else { return Err(wrong(text)) };
                Ok([length(x, "--place")?, length(y, "--place")?])
            };
            Ok(Positions::Points { points: points.iter().map(point).collect::<Result<_, _>>()? })
        }
    }
}

/// `crank sweep = 80 mm`
fn set_size(parts: &mut PartSizes, text: &str) -> Result<(), Failure> {
    const NAMES: &str = "big end, clearance, crank sweep, crank weight radius, cylinder wall, gear width, journal radius, module, \
                         rod width, shaft radius, weight sweep";
    let Some((name, value)) = text.split_once('=') else {
        return Err(Failure::input(
            format_args!("--size needs a part and its size, got `{text}`"),
            "for example --size 'crank sweep = 80 mm'",
        ));
    };
    let name = name.trim();
    let size = length(value, "--size")?;
    let may_be_nothing = ["clearance", "cylinder wall"].contains(&name);
    if size < 0.0 || (size == 0.0 && !may_be_nothing) {
        let least = if may_be_nothing { "of 0 or more" } else { "above 0" };
        return Err(Failure::input(
            format_args!("--size needs a length {least} for `{name}`, got {}", value.trim()),
            "leave it out for the usual size, which the answer states",
        ));
    }
    match name {
        "big end" => parts.big_end_radius = Some(size),
        "clearance" => parts.clearance = size,
        "crank sweep" => parts.crank_sweep = Some(size),
        "crank weight radius" => parts.crank_weight_radius = Some(size),
        "cylinder wall" => parts.cylinder_wall = size,
        "gear width" => parts.gear_width = size,
        "journal radius" => parts.crank_journal_radius = Some(size),
        "module" => parts.gear_module = size,
        "rod width" => parts.rod_width = Some(size),
        "shaft radius" => parts.shaft_radius = size,
        "weight sweep" => parts.weight_sweep = Some(size),
        _ => {
            return Err(Failure::input(
                format_args!("--size has no part `{name}`"),
                format_args!("its parts are {NAMES}"),
            ));
        }
    }
    Ok(())
}
