//! Parts as one file, in the format that is asked for.

use super::{ExportError, PlacedPart, StepHeader, glb, solids, step, stl};
use crate::drawing::{part_dxf, part_svg};

/// Formats of parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartFormat {
    /// Solids with exact faces, millimetres.
    Step,
    /// Facets, millimetres.
    Stl,
    /// Facets (binary glTF), metres.
    Glb,
    /// The outline of one part.
    Dxf,
    /// The outline of one part.
    Svg,
}

impl PartFormat {
    /// Largest distance between an arc and its facets where none is asked for [m].
    pub const FACET: f64 = 1e-5;

    /// The format of files whose name has this ending, small or capital letters.
    pub fn of_ending(ending: &str) -> Option<PartFormat> {
        Some(match ending.to_ascii_lowercase().as_str() {
            "step" | "stp" => PartFormat::Step,
            "stl" => PartFormat::Stl,
            "glb" => PartFormat::Glb,
            "dxf" => PartFormat::Dxf,
            "svg" => PartFormat::Svg,
            _ => return None,
        })
    }

    /// Whether it has facets.
    pub fn has_facets(self) -> bool {
        matches!(self, PartFormat::Stl | PartFormat::Glb)
    }

    /// Whether it holds the outline of one part, and no solids.
    pub fn is_outline(self) -> bool {
        matches!(self, PartFormat::Dxf | PartFormat::Svg)
    }
}

/// The file that holds `parts`, called `title` where a format has room for it; `facet` is the largest distance between an arc and its facets [m].
///
/// # Errors
/// [`ExportError`]: as [`solids`], [`stl`] and [`glb`], and for an outline of none or several parts, or of one that cannot be drawn.
pub fn part_file(
    format: PartFormat,
    title: &str,
    parts: &[PlacedPart],
    facet: f64,
) -> Result<Vec<u8>, ExportError> {
    let one = || match parts {
        [part] => Ok(&part.part),
        _ => Err(ExportError::OneOutline { got: parts.len() }),
    };
    Ok(match format {
        PartFormat::Step => {
            let header = StepHeader { title: title.to_owned(), ..StepHeader::default() };
            step(&solids(parts)?, &header).into_bytes()
        }
        PartFormat::Stl => stl(&solids(parts)?, facet)?,
        PartFormat::Glb => glb(&solids(parts)?, facet)?,
        PartFormat::Dxf => part_dxf(one()?)?.into_bytes(),
        PartFormat::Svg => part_svg(one()?)?.into_bytes(),
    })
}
