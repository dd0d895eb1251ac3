//! What a counterweight adds to its web.

use lanchester_model::{CounterweightForm, CounterweightPart, Engine};
use lanchester_shape::{AreaMoments, GeometryError, MassMoments, MassProperties, Outline, Point};

/// Outline of the plain web on which a part sits, in the frame of the part; none without a web or `[crank.body]`.
///
/// # Errors
/// Where the body's web cannot be.
pub fn plain_web(engine: &Engine, part: &CounterweightPart) -> Result<Option<Outline>, GeometryError> {
    let Some(web) = part.web else { return Ok(None) };
    Ok(engine.plain_web(web)?.map(|plain| plain.outline.turned(-part.angle)))
}

/// Mass properties of what a counterweight has beyond its plain web, in the frame of its part: of a shape of the family beyond
/// the disc where the engine has no body; of an outline of the counterweight alone all of it.
///
/// # Errors
/// Where the plain web cannot be, or has no common outline with the part.
pub fn counterweight_properties(
    engine: &Engine,
    part: &CounterweightPart,
) -> Result<MassProperties, GeometryError> {
    let whole = part.part.moments();
    let prism = |figure: &AreaMoments, thickness: f64, density: f64| {
        MassMoments::prism(figure, [-thickness / 2.0, thickness / 2.0]) * density
    };
    let (own_thickness, own_density) = (part.part.thickness(), part.part.density());
    let web = plain_web(engine, part)?;
    let less = match (&part.form, web, part.web.and_then(|web| engine.body_at_web(web))) {
        (CounterweightForm::Family(_), Some(web), Some(body)) => {
            let outline = part.part.outline();
            let shared = outline.moments() + web.moments() - outline.union(&web)?.moments();
            prism(&shared, own_thickness.min(body.web_thickness), own_density)
        }
        (CounterweightForm::Family(shape), ..) => {
            prism(&AreaMoments::disc(Point::ORIGIN, shape.web_radius), own_thickness, own_density)
        }
        (CounterweightForm::Web, Some(web), Some(body)) => {
            prism(&web.moments(), body.web_thickness, body.density)
        }
        (CounterweightForm::Counterweight | CounterweightForm::Web, ..) => MassMoments::default(),
    };
    Ok((whole - less).properties())
}
