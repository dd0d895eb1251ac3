//! A counterweight while its dimensions are dragged: what the shape weighs, reaches and leaves clear.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::design_choice::shape_task;
use crate::questions::reading::engine_file;
use lanchester::file::{EngineFile, write_back};
use lanchester::geometry::clearance::Clearances;
use lanchester::geometry::{
    CounterweightShape, Edge, Outline, Part, Range, ShapeTask, Shoulder, counterweight_properties, plain_web,
};
use lanchester::model::{Counterweight, CounterweightForm, Engine};
use lanchester::{clearances, with_outline};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt::Write;

/// Density of a weight for which the file says none: steel [kg/m^3].
const STEEL: f64 = 7850.0;

/// A shape to look at.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ShapeQuestion {
    /// The engine file.
    text: String,
    /// Name of the counterweight.
    weight: String,
    /// The dimensions; `null`: those of the file, or some to start from.
    dimensions: Option<Dimensions>,
    /// Whether clearances are told too: they take longer than all the rest.
    #[serde(default = "yes")]
    clearances: bool,
}

fn yes() -> bool {
    true
}

/// Dimensions of a shape of the family [m], [rad].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Dimensions {
    /// Radius of the web's disc, and half width of the rectangle [m].
    web_radius: f64,
    /// Height of the rectangle, from the crank axis [m].
    rectangle_height: f64,
    /// Height of the trapezoid [m].
    shoulder_height: f64,
    /// Radius of the arc [m].
    arc_radius: f64,
    /// Included angle of the arc [rad].
    arc_angle: f64,
    /// Thickness along the crank [m].
    thickness: f64,
}

impl Dimensions {
    fn of(shape: CounterweightShape, thickness: f64) -> Dimensions {
        let CounterweightShape { web_radius, rectangle_height, shoulder_height, arc_radius, arc_angle } =
            shape;
        Dimensions { web_radius, rectangle_height, shoulder_height, arc_radius, arc_angle, thickness }
    }

    fn shape(self) -> CounterweightShape {
        let Dimensions { web_radius, rectangle_height, shoulder_height, arc_radius, arc_angle, .. } = self;
        CounterweightShape { web_radius, rectangle_height, shoulder_height, arc_radius, arc_angle }
    }
}

/// Least and largest value of each dimension, of the file's `[counterweight_design]`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
struct DimensionRanges {
    web_radius: [f64; 2],
    rectangle_height: [f64; 2],
    /// Where the file gives the height, not the angle, of the shoulder.
    shoulder_height: Option<[f64; 2]>,
    arc_radius: [f64; 2],
    arc_angle: [f64; 2],
    thickness: [f64; 2],
}

/// A shape as a part, SI units.
#[derive(Debug, Serialize, JsonSchema)]
struct ShapePreview {
    /// Whether the file has a shape for this weight, or the question gave one; otherwise it is one to start from.
    drawn: bool,
    /// The outline with the disc of its web as the path of an SVG: metres, y up towards the weight.
    outline: String,
    /// Its bounds: least x and y, largest x and y [m].
    bounds: [f64; 4],
    /// The plain web in the same frame.
    plain_web: Option<String>,
    /// Thickness of the plain web [m].
    web_thickness: Option<f64>,
    dimensions: Dimensions,
    /// Whether the part is a shape of the family whose dimensions these are; an outline of the user's own has none.
    has_dimensions: bool,
    /// What it has beyond its plain web [kg].
    mass: f64,
    /// What it adds to the unbalance of the crankshaft [kg m].
    unbalance: f64,
    /// What the weight should be [kg m].
    wanted_unbalance: Option<f64>,
    /// Farthest point from the crank axis [m].
    swept_radius: f64,
    /// Of what it has beyond its plain web, about the crank axis [kg m^2].
    inertia: f64,
    /// Half the chord of the arc [m].
    half_width: f64,
    /// Angle of the flank [rad].
    shoulder_angle: f64,
    /// All clearances of the crankshaft with this shape; none where the file names nothing to stay clear of, or nobody asked.
    clearances: Option<Clearances>,
    ranges: Option<DimensionRanges>,
    /// The engine file with this shape.
    text: String,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post(
        "/api/counterweight/shape",
        "A counterweight of given dimensions as a part, and the file with it.",
        preview,
    )
}

fn preview(_: &Asker, question: ShapeQuestion) -> Result<ShapePreview, Problem> {
    let EngineFile { engine, tasks } = engine_file(&question.text)?;
    let weight = named(&engine, &question.weight)?;
    let of_file = weight.part.as_deref();
    let drawn = question.dimensions.is_some() || of_file.is_some();
    let task = tasks.shape_task;
    let start = || match task {
        Some(task) => Ok(start_within(&task)),
        None => shape_task(&tasks, None).map(|task| start_within(&task)),
    };
    let family = of_file.and_then(|part| match part.form {
        CounterweightForm::Family(shape) => Some(Dimensions::of(shape, part.part.thickness())),
        _ => None,
    });
    let has_dimensions = question.dimensions.is_some() || of_file.is_none() || family.is_some();
    let dimensions = match (question.dimensions, family) {
        (Some(given), _) => given,
        (None, Some(of_file)) => of_file,
        (None, None) => start()?,
    };
    let after = if question.dimensions.is_none() && of_file.is_some() {
        engine.clone()
    } else {
        let shape = dimensions.shape().checked().map_err(Problem::refused)?;
        let density = of_file.map(|part| part.part.density()).or(task.map(|task| task.density));
        let density = density.or(engine.crank_body.map(|body| body.density)).unwrap_or(STEEL);
        let part = Part::new(Outline::from(shape.outline()), dimensions.thickness, density)
            .map_err(Problem::refused)?;
        with_outline(&engine, &weight.name, CounterweightForm::Family(shape), part)
            .map_err(Problem::refused)?
    };
    let fitted = named(&after, &question.weight)?;
    let part = fitted
        .part
        .as_deref()
        .ok_or_else(|| Problem::refused("the weight is no part\nhint: give it dimensions"))?;
    let properties = counterweight_properties(&after, part).map_err(Problem::refused)?;
    let [low, high] = part.part.outline().bounds();
    Ok(ShapePreview {
        drawn,
        outline: path(part.part.outline()),
        // The frame of a part has its weight along x; it is drawn upwards.
        bounds: [-high.y, low.x, -low.y, high.x],
        plain_web: plain_web(&after, part).map_err(Problem::refused)?.as_ref().map(path),
        web_thickness: after.crank_body.map(|body| body.web_thickness),
        dimensions,
        has_dimensions,
        mass: properties.mass,
        unbalance: fitted.unbalance,
        wanted_unbalance: part.wanted,
        swept_radius: part.part.outline().swept_radius(),
        inertia: properties.polar_inertia(),
        half_width: dimensions.shape().half_width(),
        shoulder_angle: dimensions.shape().shoulder_angle(),
        clearances: match after.envelope {
            Some(_) if question.clearances => Some(clearances(&after).map_err(Problem::refused)?),
            _ => None,
        },
        ranges: task.as_ref().map(ranges),
        text: write_back(&question.text, &after).map_err(Problem::refused)?,
    })
}

fn named<'a>(engine: &'a Engine, name: &str) -> Result<&'a Counterweight, Problem> {
    engine.counterweights.iter().find(|weight| weight.name == name).ok_or_else(|| {
        let known: Vec<&str> = engine.counterweights.iter().map(|weight| weight.name.as_str()).collect();
        Problem::refused(format!(
            "no counterweight is called \"{name}\"\nhint: the names are {}",
            known.join(", ")
        ))
    })
}

/// A shape in the lower half of the ranges.
fn start_within(task: &ShapeTask) -> Dimensions {
    let low = |range: Range| range.least + 0.3 * (range.most - range.least);
    let (arc_radius, arc_angle, web_radius) =
        (low(task.arc_radius), low(task.arc_angle), low(task.web_radius));
    let shoulder_height = match task.shoulder {
        Shoulder::Height(range) => low(range),
        Shoulder::Angle(range) => ((arc_radius * (arc_angle / 2.0).sin() - web_radius).abs()
            * low(range).tan())
        .clamp(0.0, arc_radius),
    };
    let rectangle_height = low(task.rectangle_height);
    let shape = CounterweightShape { web_radius, rectangle_height, shoulder_height, arc_radius, arc_angle };
    Dimensions::of(shape, low(task.thickness))
}

fn ranges(task: &ShapeTask) -> DimensionRanges {
    let ends = |range: Range| [range.least, range.most];
    DimensionRanges {
        web_radius: ends(task.web_radius),
        rectangle_height: ends(task.rectangle_height),
        shoulder_height: match task.shoulder {
            Shoulder::Height(range) => Some(ends(range)),
            Shoulder::Angle(_) => None,
        },
        arc_radius: ends(task.arc_radius),
        arc_angle: ends(task.arc_angle),
        thickness: ends(task.thickness),
    }
}

/// The path of an outline, the x axis of its part drawn upwards.
fn path(outline: &Outline) -> String {
    let mut out = String::new();
    for contour in outline.contours() {
        let start = contour.edges()[0].from;
        let _ = write!(out, "M {} {}", -start.y, start.x);
        contour.edges().iter().for_each(|edge| add(&mut out, edge));
        out.push('Z');
    }
    out
}

fn add(out: &mut String, edge: &Edge) {
    if edge.bulge.abs() > 0.4 {
        edge.halves().iter().for_each(|half| add(out, half));
        return;
    }
    let (x, y) = (-edge.to.y, edge.to.x);
    let _ = if edge.bulge == 0.0 {
        write!(out, "L {x} {y}")
    } else {
        let radius = edge.radius();
        write!(out, "A {radius} {radius} 0 0 {} {x} {y}", u8::from(edge.bulge > 0.0))
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_has_the_weight_upwards_and_turns_as_its_arcs() {
        let shape = CounterweightShape {
            web_radius: 0.04,
            rectangle_height: 0.01,
            shoulder_height: 0.02,
            arc_radius: 0.08,
            arc_angle: 2.0,
        };
        let outline = Outline::from(shape.outline());
        let [low, high] = outline.bounds();
        assert!(high.x > -low.x, "the weight lies along x");
        let path = path(&outline);
        let ends: Vec<f64> = path
            .split(['M', 'L', 'A', 'Z'])
            .filter(|piece| !piece.is_empty())
            .map(|piece| piece.split(' ').next_back().unwrap().parse().unwrap())
            .collect();
        let top = ends.iter().copied().fold(f64::MIN, f64::max);
        assert!((top - high.x).abs() < 1e-12, "{top} {}", high.x);
        assert!(path.ends_with('Z') && path.contains("A 0.08 0.08 0 0 1 "), "{path}");
    }
}
