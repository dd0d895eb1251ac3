//! The outline of a counterweight from a drawing.

use crate::parts::design::with_outline;
use crate::parts::error::CounterweightError;
use lanchester_geometry::drawing::{Drawing, DrawingError, DrawingOptions, read_dxf, read_svg};
use lanchester_geometry::{GeometryError, MassProperties, Part, counterweight_properties};
use lanchester_model::{CounterweightForm, Engine};
use serde::Serialize;
use thiserror::Error;

/// In which form a drawing stands in its file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DrawingKind {
    /// DXF, as text.
    Dxf,
    /// SVG.
    Svg,
}

impl DrawingKind {
    /// By the ending of a file's name, in capitals or not.
    pub fn of_name(name: &str) -> Option<DrawingKind> {
        match name.rsplit_once('.')?.1.to_ascii_lowercase().as_str() {
            "dxf" => Some(DrawingKind::Dxf),
            "svg" => Some(DrawingKind::Svg),
            _ => None,
        }
    }
}

/// What is made of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlineImport {
    /// Name of the counterweight that gets the outline.
    pub weight: String,
    /// In which form the drawing stands in its file.
    pub kind: DrawingKind,
    /// Whether the outline encloses the counterweight alone or the whole web.
    pub form: CounterweightForm,
    /// Thickness [m]; `None`: that of its present shape, else of the webs of the crankshaft's body.
    pub thickness: Option<f64>,
    /// Density [kg/m^3]; `None`: that of its present shape, else of the crankshaft's body.
    pub density: Option<f64>,
    /// How the drawing is read.
    pub options: DrawingOptions,
}

/// An outline that was read, and what it makes of its counterweight.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ImportedOutline {
    /// Name of the counterweight.
    pub weight: String,
    /// Its part.
    pub part: Part,
    /// Mass, unbalance and inertia.
    pub properties: MassProperties,
    /// What of the drawing was left out, and why.
    pub left_out: Vec<String>,
}

/// Why there is no outline.
#[derive(Debug, Error)]
pub enum OutlineImportError {
    /// The drawing.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// What it encloses.
    #[error(transparent)]
    Part(#[from] GeometryError),
    /// The counterweight.
    #[error(transparent)]
    Counterweight(#[from] CounterweightError),
    /// Nothing says how thick and how dense it is.
    #[error(
        "an outline needs a thickness and a density, and neither the weight nor [crank.body] has them\nhint: give both, such as 20 mm and 7850 kg/m3"
    )]
    NoPlate,
}

/// The engine with the outline of a drawing in the place of a counterweight, and what the drawing gave.
///
/// # Errors
/// [`OutlineImportError`] where the drawing has no single closed outline, where thickness or density are not known, or as [`with_outline`].
pub fn import_outline(
    engine: &Engine,
    drawing: &[u8],
    import: &OutlineImport,
) -> Result<(Engine, ImportedOutline), OutlineImportError> {
    let Drawing { outline, bores, ignored, .. } = match import.kind {
        DrawingKind::Dxf => read_dxf(drawing, &import.options)?,
        DrawingKind::Svg => read_svg(drawing, &import.options)?,
    };
    let mut left_out: Vec<String> =
        ignored.iter().map(|ignored| format!("{}: {}", ignored.entity, ignored.why)).collect();
    left_out.extend(bores.iter().map(|bore| {
        format!(
            "bore of {:.3} mm at x {:.3}, y {:.3} mm: its depth and material are no part of an outline; add it to `inserts` of the shape",
            2e3 * bore.radius,
            1e3 * bore.centre.x,
            1e3 * bore.centre.y
        )
    }));
    let now = engine.counterweights.iter().find(|weight| weight.name == import.weight);
    let now = now.and_then(|weight| weight.part.as_ref()).map(|part| &part.part);
    let body = engine.crank_body;
    let thickness = import.thickness.or(now.map(Part::thickness)).or(body.map(|body| body.web_thickness));
    let density = import.density.or(now.map(Part::density)).or(body.map(|body| body.density));
    let (Some(thickness), Some(density)) = (thickness, density) else {
        return Err(OutlineImportError::NoPlate);
    };
    let part = Part::new(outline, thickness, density)?;
    let after = with_outline(engine, &import.weight, import.form, part)?;
    let fitted = after.counterweights.iter().find(|weight| weight.name == import.weight);
    let part = fitted.and_then(|weight| weight.part.as_ref()).expect("invariant: the weight has its outline");
    let properties = counterweight_properties(&after, part)?;
    let imported =
        ImportedOutline { weight: import.weight.clone(), part: part.part.clone(), properties, left_out };
    Ok((after, imported))
}
