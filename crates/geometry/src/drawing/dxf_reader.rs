//! An outline from the text of a DXF file.

use super::bore::{BORES_LAYER, Bore, CENTRE_LINES_LAYER};
use super::dxf_entities::{Edges, arc, circle, light_polyline, line, polyline};
use super::dxf_tags::{Record, Tag, tags, text};
use super::dxf_writer::UNIT_COMMENT;
use super::nesting::drawing;
use super::strand::Strand;
use super::{Drawing, DrawingError, DrawingOptions, Ignored};
use lanchester_shape::Edge;

/// Lengths of the units of `$INSUNITS` [m], by their code.
const UNITS: [(i64, f64); 18] = [
    (1, 0.0254),
    (2, 0.3048),
    (3, 1609.344),
    (4, 1e-3),
    (5, 1e-2),
    (6, 1.0),
    (7, 1e3),
    (8, 0.0254e-6),
    (9, 0.0254e-3),
    (10, 0.9144),
    (11, 1e-10),
    (12, 1e-9),
    (13, 1e-6),
    (14, 0.1),
    (15, 10.0),
    (16, 100.0),
    (21, 1200.0 / 3937.0),
    (22, 100.0 / 3937.0),
];

/// What draws no contour.
const ANNOTATIONS: [&str; 13] = [
    "TEXT",
    "MTEXT",
    "ATTDEF",
    "DIMENSION",
    "ARC_DIMENSION",
    "LARGE_RADIAL_DIMENSION",
    "LEADER",
    "MULTILEADER",
    "MLEADER",
    "TOLERANCE",
    "POINT",
    "HATCH",
    "VIEWPORT",
];

/// The outline in the bytes of an ASCII DXF file of any release.
///
/// Units, gaps and layers to leave out are those of the options; what is read, joined, left out and refused stands at [`super`].
///
/// # Errors
/// Where the text is damaged, says no unit, holds anything but lines and arcs, or does not make one outline: [`DrawingError`]
/// names the entity and its line.
pub fn read_dxf(bytes: &[u8], options: &DrawingOptions) -> Result<Drawing, DrawingError> {
    options.checked()?;
    let text = text(bytes)?;
    let (tags, comments) = tags(&text)?;
    let is_own = comments.contains(&UNIT_COMMENT);
    let mut reader = Reader {
        options,
        is_own,
        hidden: Vec::new(),
        strands: Vec::new(),
        bores: Vec::new(),
        ignored: Vec::new(),
    };
    let mut unit = is_own.then_some(1e-3);
    let mut has_entities = false;
    let mut rest = &tags[..];
    while let Some((first, after)) = rest.split_first() {
        let (0, "SECTION") = (first.code, first.value) else {
            return Err(first.wrong("SECTION"));
        };
        let end = after.iter().position(|tag| tag.code == 0 && tag.value == "ENDSEC");
        let Some(end) = end else {
            let line = rest[rest.len() - 1].line + 2;
            return Err(DrawingError::Syntax {
                line,
                needed: "ENDSEC",
                got: "the end of the file".to_string(),
            });
        };
        let body = &after[..end];
        match body.first().filter(|tag| tag.code == 2).map(|tag| tag.value) {
            Some("HEADER") => unit = header_unit(body)?.or(unit),
            Some("TABLES") => reader.hidden = hidden_layers(body)?,
            Some("ENTITIES") => {
                has_entities = true;
                let unit =
                    options.unit.or(unit).ok_or(DrawingError::NoUnit { why: "it has no $INSUNITS" })?;
                let records: Vec<Record> = Record::all(body).collect();
                reader.entities(&records, unit)?;
            }
            _ => {}
        }
        rest = &after[end + 1..];
    }
    if !has_entities {
        return Err(DrawingError::NotText {
            format: "DXF",
            why: "it has no section ENTITIES",
            hint: "save the drawing as ASCII DXF",
        });
    }
    let unit = options.unit.or(unit).ok_or(DrawingError::NoUnit { why: "it has no $INSUNITS" })?;
    let outline = drawing(reader.strands, options.gap, unit, reader.ignored)?;
    Ok(Drawing { bores: reader.bores, ..outline })
}

/// The unit that the header says, none where it says that there is none.
fn header_unit(header: &[Tag]) -> Result<Option<f64>, DrawingError> {
    let Some(at) = header.iter().position(|tag| tag.code == 9 && tag.value == "$INSUNITS") else {
        return Ok(None);
    };
    let Some(value) = header.get(at + 1).filter(|tag| tag.code == 70) else {
        return Err(header[at].wrong("a value (70) after $INSUNITS"));
    };
    let code = value.integer()?;
    if code == 0 {
        return Ok(None);
    }
    let known = UNITS.iter().find(|(known, _)| *known == code);
    let unknown = || DrawingError::UnknownUnit { line: value.line + 1, got: code.to_string() };
    known.map(|(_, unit)| Some(*unit)).ok_or_else(unknown)
}

/// Layers that are off or frozen.
fn hidden_layers<'a>(tables: &'a [Tag<'a>]) -> Result<Vec<&'a str>, DrawingError> {
    let mut hidden = Vec::new();
    for layer in Record::all(tables).filter(|record| record.name == "LAYER") {
        let Some(name) = layer.tag(2) else { continue };
        if layer.integer(70)? & 1 != 0 || layer.integer(62)? < 0 {
            hidden.push(name.value);
        }
    }
    Ok(hidden)
}

struct Reader<'a> {
    options: &'a DrawingOptions,
    /// Whether the file was written here: then the layers of bores mean what they are called.
    is_own: bool,
    hidden: Vec<&'a str>,
    strands: Vec<Strand>,
    bores: Vec<Bore>,
    ignored: Vec<Ignored>,
}

impl<'a> Reader<'a> {
    fn entities(&mut self, records: &[Record<'a>], unit: f64) -> Result<(), DrawingError> {
        let mut at = 0;
        while let Some(entity) = records.get(at) {
            at += 1;
            let mut vertices: &[Record] = &[];
            if entity.name == "POLYLINE" {
                let count = records[at..].iter().take_while(|record| record.name == "VERTEX").count();
                vertices = &records[at..at + count];
                at += count;
                if records.get(at).is_none_or(|record| record.name != "SEQEND") {
                    return Err(DrawingError::Missing { entity: entity.place(), missing: "SEQEND" });
                }
                at += 1;
            }
            if entity.name == "INSERT" {
                // The texts that belong to a block.
                let texts = |record: &&Record| matches!(record.name, "ATTRIB" | "SEQEND");
                at += records[at..].iter().take_while(texts).count();
            }
            if let Some(why) = self.harmless(entity)? {
                self.ignored.push(Ignored { entity: entity.place(), why });
                continue;
            }
            self.visible(entity)?;
            let (edges, closed) = edges(entity, vertices)?;
            let scaled = |edge: Edge| Edge { from: edge.from * unit, to: edge.to * unit, ..edge };
            let edges = edges.into_iter().map(scaled).collect();
            let strand = Strand::new(edges, closed, entity.place())?;
            match self.is_own && entity.layer() == BORES_LAYER {
                true => self.bores.push(Bore::of(&strand)?),
                false => self.strands.push(strand),
            }
        }
        Ok(())
    }

    /// Why the entity can be left out, if it can.
    fn harmless(&self, entity: &Record) -> Result<Option<&'static str>, DrawingError> {
        Ok(if self.options.leave_out.iter().any(|layer| layer.eq_ignore_ascii_case(entity.layer())) {
            Some("its layer is left out")
        } else if entity.integer(67)? != 0 {
            Some("it is in the paper space")
        } else if self.is_own && entity.layer() == CENTRE_LINES_LAYER {
            Some("it is a centre line")
        } else if ANNOTATIONS.contains(&entity.name) {
            Some("it draws no contour")
        } else {
            None
        })
    }

    fn visible(&self, entity: &Record) -> Result<(), DrawingError> {
        let layer = entity.layer();
        let off = self.hidden.iter().any(|hidden| hidden.eq_ignore_ascii_case(layer));
        if off || entity.integer(60)? != 0 {
            return Err(DrawingError::Hidden { entity: entity.place(), layer: layer.to_string() });
        }
        Ok(())
    }
}

/// The edges of an entity, in units of the drawing.
fn edges(entity: &Record, vertices: &[Record]) -> Result<Edges, DrawingError> {
    let unknown = |why, hint| Err(entity.unsupported(why, hint));
    match entity.name {
        "LINE" => line(entity),
        "ARC" => arc(entity),
        "CIRCLE" => circle(entity),
        "LWPOLYLINE" => light_polyline(entity),
        "POLYLINE" => polyline(entity, vertices),
        "SPLINE" | "HELIX" => unknown("is no line and no arc", "replace the spline by arcs, or export arcs"),
        "ELLIPSE" => unknown("is no line and no arc", "replace the ellipse by arcs, or export arcs"),
        "INSERT" => unknown("is a block, which is not read", "explode it into lines and arcs"),
        "3DFACE" | "SOLID" | "TRACE" | "REGION" | "3DSOLID" | "BODY" | "SURFACE" | "MESH" => {
            unknown("is a surface or a solid", "draw its border with lines and arcs")
        }
        _ => {
            unknown("is not known here", "turn it into lines and arcs, or name its layer as one to leave out")
        }
    }
}
