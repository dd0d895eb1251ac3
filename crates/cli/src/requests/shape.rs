//! From the options of `counterweight` to a request: the file's section `[counterweight_design]`, changed by the options.

use crate::failure::Failure;
use crate::options::counterweight::ShapeArguments;
use lanchester::CounterweightRequest;
use lanchester::file::EngineFile;
use lanchester::geometry::{DesignLimits, DesignSettings, Objective, Range, ShapeTask, Shoulder};
use lanchester::task::option::{self, BadQuantity};

/// A dimension of a shape, and how its values are read.
type Read = fn(&str, &str) -> Result<f64, BadQuantity>;

/// The dimensions that a task must have, and how each is read.
const DIMENSIONS: [(&str, Read); 7] = [
    ("web radius", option::length),
    ("rectangle height", option::length),
    ("shoulder height", option::length),
    ("shoulder angle", option::angle),
    ("arc radius", option::length),
    ("arc angle", option::angle),
    ("thickness", option::length),
];

/// The request behind the options.
pub fn shape_request(file: &EngineFile, arguments: &ShapeArguments) -> Result<CounterweightRequest, Failure> {
    let unbalance = arguments.unbalance.as_ref().map(|text| option::unbalance(text, "--unbalance"));
    Ok(CounterweightRequest {
        weights: arguments.weight.clone(),
        unbalance: unbalance.transpose().map_err(Failure::from)?,
        task: shape_task(file, arguments)?,
        evolution: None,
    })
}

fn shape_task(file: &EngineFile, arguments: &ShapeArguments) -> Result<ShapeTask, Failure> {
    let of_file = file.tasks.shape_task;
    let mut ranges: [Option<Range>; 7] = match of_file {
        None => [None; 7],
        Some(task) => {
            let (height, angle) = match task.shoulder {
                Shoulder::Height(range) => (Some(range), None),
                Shoulder::Angle(range) => (None, Some(range)),
            };
            let [r, h] = [task.web_radius, task.rectangle_height].map(Some);
            [r, h, height, angle, Some(task.arc_radius), Some(task.arc_angle), Some(task.thickness)]
        }
    };
    for text in &arguments.dimension {
        let (name, value) = named(text, "--dimension")?;
        let Some(index) = DIMENSIONS.iter().position(|(known, _)| *known == name) else {
            let known = DIMENSIONS.map(|(known, _)| known).join("`, `");
            return Err(Failure::input(
                format_args!("unknown dimension `{name}` for --dimension"),
                format_args!("dimensions are `{known}`"),
            ));
        };
        // The flank is given once: the later one counts.
        match index {
            2 => ranges[3] = None,
            3 => ranges[2] = None,
            _ => {}
        }
        ranges[index] = Some(range(value, DIMENSIONS[index].1, "--dimension")?);
    }
    let [web_radius, rectangle_height, shoulder_height, shoulder_angle, arc_radius, arc_angle, thickness] =
        ranges;
    let shoulder = shoulder_height.map(Shoulder::Height).or(shoulder_angle.map(Shoulder::Angle));
    let density = match &arguments.density {
        Some(text) => Some(option::density(text, "--density").map_err(Failure::from)?),
        None => of_file.map(|task| task.density).or(file.engine.crank_body.map(|body| body.density)),
    };
    let thickness = thickness.or(file.engine.crank_body.map(|body| Range::fixed(body.web_thickness)));
    let web_radius = web_radius.or(file.engine.crank_body.map(|body| Range::fixed(body.web_radius)));
    let missing: Vec<&str> = [
        ("density", density.is_none()),
        ("web_radius", web_radius.is_none()),
        ("rectangle_height", rectangle_height.is_none()),
        ("shoulder_height", shoulder.is_none()),
        ("arc_radius", arc_radius.is_none()),
        ("arc_angle", arc_angle.is_none()),
        ("thickness", thickness.is_none()),
    ]
    .into_iter()
    .filter_map(|(name, is_missing)| is_missing.then_some(name))
    .collect();
    let (Some(density), Some(web_radius), Some(rectangle_height), Some(shoulder)) =
        (density, web_radius, rectangle_height, shoulder)
    else {
        return Err(incomplete(&missing));
    };
    let (Some(arc_radius), Some(arc_angle), Some(thickness)) = (arc_radius, arc_angle, thickness) else {
        return Err(incomplete(&missing));
    };
    let mut task = ShapeTask {
        minimise: arguments
            .minimise
            .map(Objective::from)
            .or(of_file.map(|task| task.minimise))
            .unwrap_or(Objective::Mass),
        least_balance: of_file.map_or(1.0, |task| task.least_balance),
        most_balance: of_file.and_then(|task| task.most_balance),
        density,
        web_radius,
        rectangle_height,
        shoulder,
        arc_radius,
        arc_angle,
        thickness,
        limits: of_file.map(|task| task.limits).unwrap_or_default(),
        settings: settings(arguments)?,
    };
    if let Some(text) = &arguments.balance {
        let Range { least, most } = range(text, option::share, "--balance")?;
        task.least_balance = least;
        task.most_balance = text.contains("..").then_some(most);
    }
    for text in &arguments.limit {
        let (name, value) = named(text, "--limit")?;
        limit(&mut task.limits, name, value)?;
    }
    Ok(task)
}

/// How far the proof goes.
fn settings(arguments: &ShapeArguments) -> Result<DesignSettings, Failure> {
    let usual = DesignSettings::default();
    let gap = arguments.gap.as_ref().map(|text| option::share(text, "--gap")).transpose()?;
    let settings = DesignSettings {
        gap: gap.unwrap_or(usual.gap),
        max_boxes: arguments.max_boxes.unwrap_or(usual.max_boxes),
    };
    settings.check().map_err(Failure::refused)?;
    Ok(settings)
}

fn incomplete(missing: &[&str]) -> Failure {
    Failure::input(
        format_args!("the shapes to search are not all given: {} missing", missing.join(", ")),
        "add a section like\n\n  [counterweight_design]\n  density = \"7850 kg/m3\"\n  web_radius = \"45 mm\"\n  \
         rectangle_height = [\"0 mm\", \"30 mm\"]\n  shoulder_height = [\"0 mm\", \"30 mm\"]\n  \
         arc_radius = [\"60 mm\", \"100 mm\"]\n  arc_angle = [\"60 deg\", \"180 deg\"]\n  thickness = \"20 mm\"\n\n\
         to the engine file, or give --dimension 'arc radius = 60 mm .. 100 mm' for each",
    )
}

fn limit(limits: &mut DesignLimits, name: &str, value: &str) -> Result<(), Failure> {
    let one = |read: Read| read(value, "--limit").map(Some).map_err(Failure::from);
    let two = |read: Read| range(value, read, "--limit").map(Some);
    match name {
        "mass" => limits.mass = one(option::mass)?,
        "swept radius" => limits.swept_radius = one(option::length)?,
        "inertia" => limits.inertia = one(option::inertia)?,
        "half width" => limits.half_width = one(option::length)?,
        "shoulder angle" => limits.shoulder_angle = two(option::angle)?,
        "shoulder height" => limits.shoulder_height = two(option::length)?,
        _ => {
            return Err(Failure::input(
                format_args!("unknown limit `{name}` for --limit"),
                "limits are `mass`, `swept radius`, `inertia`, `half width`, `shoulder angle` and `shoulder height`; \
                 a dimension has its range from --dimension",
            ));
        }
    }
    Ok(())
}

/// `name = value`.
fn named<'a>(text: &'a str, option: &str) -> Result<(&'a str, &'a str), Failure> {
    let (name, value) = text.split_once('=').ok_or_else(|| {
        Failure::input(
            format_args!("{option} needs a name and a value, got `{text}`"),
            format_args!(
                "write it like {option} '{}'",
                match option {
                    "--limit" => "mass = 2 kg",
                    _ => "arc radius = 60 mm .. 100 mm",
                }
            ),
        )
    })?;
    Ok((name.trim(), value.trim()))
}

/// One value, or `a .. b`.
fn range(text: &str, read: Read, option: &str) -> Result<Range, Failure> {
    let value = |text: &str| read(text.trim(), option).map_err(Failure::from);
    match text.split_once("..") {
        None => value(text).map(Range::fixed),
        Some((least, most)) => Ok(Range::new(value(least)?, value(most)?)),
    }
}
