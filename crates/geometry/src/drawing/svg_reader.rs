//! An outline from the text of an SVG file.

use super::bore::Bore;
use super::nesting::drawing;
use super::strand::Strand;
use super::svg_scanner::Scanner;
use super::svg_shapes::{Element, Lines};
use super::svg_transform::Transform;
use super::svg_writer::{BORES_GROUP, MARKS_GROUP};
use super::{Drawing, DrawingError, DrawingOptions, Ignored};
use lanchester_shape::Edge;
use roxmltree::{Document, ParsingOptions};

/// Elements that draw no contour where they stand.
const HARMLESS: [&str; 14] = [
    "title",
    "desc",
    "metadata",
    "text",
    "defs",
    "style",
    "symbol",
    "clipPath",
    "mask",
    "pattern",
    "marker",
    "filter",
    "linearGradient",
    "radialGradient",
];

/// Properties of a style that would change the geometry.
const GEOMETRY: [&str; 15] = [
    "transform",
    "transform-origin",
    "translate",
    "rotate",
    "scale",
    "offset-path",
    "d",
    "cx",
    "cy",
    "r",
    "rx",
    "ry",
    "x",
    "y",
    "zoom",
];

/// Lengths of the units of `width` and `height` [m].
const UNITS: [(&str, f64); 6] =
    [("mm", 1e-3), ("cm", 1e-2), ("Q", 0.25e-3), ("in", 0.0254), ("pt", 0.0254 / 72.0), ("pc", 0.0254 / 6.0)];

/// The outline in the bytes of an SVG file.
///
/// The origin of its user coordinates, whatever the `viewBox` shows, becomes the crank axis, and y, which points down there, is turned.
/// Units, gaps and what to leave out are those of the options; what is read, joined, left out and refused stands at [`super`].
///
/// # Errors
/// Where the text is damaged, says no unit, holds anything but lines and arcs of circles, or does not make one outline:
/// [`DrawingError`] names the element and its line.
pub fn read_svg(bytes: &[u8], options: &DrawingOptions) -> Result<Drawing, DrawingError> {
    options.checked()?;
    let not_svg =
        |why| DrawingError::NotText { format: "SVG", why, hint: "export the drawing again as plain SVG" };
    let text = std::str::from_utf8(bytes).map_err(|_| not_svg("it is not UTF-8"))?;
    let parsing = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, parsing)
        .map_err(|error| DrawingError::Xml { line: error.pos().row as usize, message: error.to_string() })?;
    let lines = Lines::of(text);
    let root = document.root_element();
    let element = |node| Element { node, lines: &lines };
    if root.tag_name().name() != "svg" {
        return Err(not_svg("its outermost element is not svg"));
    }
    if let Some(sheet) =
        document.root().children().find(|node| node.pi().is_some_and(|pi| pi.target == "xml-stylesheet"))
    {
        return Err(element(sheet).unsupported(
            "refers to a style sheet elsewhere, which may hide or move lines",
            "export the drawing again as plain SVG",
        ));
    }
    let unit = match options.unit {
        Some(unit) => unit,
        None => unit_of(&element(root))?,
    };
    let mut reader = Reader { options, strands: Vec::new(), bores: Vec::new(), ignored: Vec::new() };
    let mut rest = vec![(root, Transform::scale(unit, -unit))];
    while let Some((node, outer)) = rest.pop() {
        if !node.is_element() {
            continue;
        }
        let at = element(node);
        let foreign = node.tag_name().namespace() != root.tag_name().namespace();
        if let Some(why) = if foreign { Some("it is no element of SVG") } else { reader.harmless(&at)? } {
            reader.ignored.push(Ignored { entity: at.place(), why });
            continue;
        }
        visible_as_it_stands(&at)?;
        let own = Transform::parse(node.attribute("transform").unwrap_or_default())
            .map_err(|got| at.wrong("transform", 0, "a transform of SVG", got))?;
        let transform = outer.after(own);
        reader.element(&at, transform, node == root)?;
        rest.extend(node.children().rev().map(|child| (child, transform)));
    }
    let outline = drawing(reader.strands, options.gap, unit, reader.ignored)?;
    Ok(Drawing { bores: reader.bores, ..outline })
}

/// Length of a user unit by width, height and view box of the root [m].
fn unit_of(root: &Element) -> Result<f64, DrawingError> {
    let no_unit = |why| DrawingError::NoUnit { why };
    let length = |attribute: &str| -> Option<f64> {
        let mut scanner = Scanner::new(root.node.attribute(attribute)?.trim());
        let number = scanner.number().filter(|number| *number > 0.0)?;
        let unit = scanner.word();
        let (_, unit) = UNITS.iter().find(|(name, _)| *name == unit)?;
        scanner.is_done().then_some(number * unit)
    };
    let why = "width and height are not both in mm, cm, Q, in, pt or pc";
    let size = [length("width"), length("height")];
    let [Some(width), Some(height)] = size else { return Err(no_unit(why)) };
    let view = root.numbers("viewBox")?;
    let &[_, _, across, down] = &view[..] else {
        return Err(no_unit("it has no viewBox of four numbers"));
    };
    if !(across > 0.0 && down > 0.0) {
        return Err(no_unit("its viewBox has no size"));
    }
    let (x, y) = (width / across, height / down);
    // Sizes are often rounded to a few digits; the scale shown is the smaller one.
    if (x / y - 1.0).abs() > 1e-3 {
        return Err(no_unit("its viewBox has another shape than width and height"));
    }
    let unit = x.min(y);
    if (1e-12..=1e6).contains(&unit) { Ok(unit) } else { Err(DrawingError::Unit { got: unit }) }
}

/// Name and value of the declarations of a style.
fn declarations(style: &str) -> impl Iterator<Item = (&str, &str)> {
    style
        .split([';', '{', '}'])
        .filter_map(|part| part.split_once(':'))
        .map(|(name, value)| (name.trim(), value.trim()))
}

/// Whether a property hides what has it.
fn hides(name: &str, value: &str) -> bool {
    matches!(
        (name, value.trim_end_matches("!important").trim_end()),
        ("display", "none") | ("visibility", "hidden" | "collapse")
    )
}

fn cuts(name: &str, value: &str) -> bool {
    matches!(name, "clip-path" | "mask") && value != "none"
}

/// That neither attributes nor style hide, cut or move the element otherwise than by its transform.
fn visible_as_it_stands(element: &Element) -> Result<(), DrawingError> {
    let style = element.node.attribute("style").unwrap_or_default();
    let attributes = element.node.attributes().filter(|attribute| attribute.namespace().is_none());
    let named = attributes.map(|attribute| (attribute.name(), attribute.value().trim()));
    for (name, value) in named.clone().chain(declarations(style)) {
        if hides(name, value) {
            let layer = element.node.attribute("id").unwrap_or(name);
            return Err(DrawingError::Hidden { entity: element.place(), layer: layer.to_string() });
        }
        if cuts(name, value) {
            return Err(element.unsupported("is cut by a clip path or a mask", "cut the lines themselves"));
        }
    }
    let moved = declarations(style).any(|(name, _)| GEOMETRY.contains(&name));
    if moved || named.into_iter().any(|(name, _)| name == "transform-origin") {
        return Err(element.unsupported("is placed by its style", "export the drawing again as plain SVG"));
    }
    Ok(())
}

struct Reader<'a> {
    options: &'a DrawingOptions,
    strands: Vec<Strand>,
    bores: Vec<Bore>,
    ignored: Vec<Ignored>,
}

impl Reader<'_> {
    /// Why the element can be left out, if it can.
    fn harmless(&self, element: &Element) -> Result<Option<&'static str>, DrawingError> {
        let names = element.node.attributes().filter(|attribute| matches!(attribute.name(), "id" | "label"));
        let mut names = names.map(|attribute| attribute.value());
        if names.any(|name| self.options.leave_out.iter().any(|layer| layer == name)) {
            return Ok(Some("its layer is left out"));
        }
        let name = element.name();
        if element.node.attribute("id") == Some(MARKS_GROUP) {
            return Ok(Some("it holds centre lines and notes"));
        }
        if name == "style" {
            let sheet: String = element.node.children().filter_map(|node| node.text()).collect();
            let acts = |(name, value): (&str, &str)| {
                hides(name, value) || cuts(name, value) || GEOMETRY.contains(&name)
            };
            if sheet.contains("@import") || declarations(&sheet).any(acts) {
                return Err(element
                    .unsupported("hides, cuts or moves lines", "export the drawing again as plain SVG"));
            }
        }
        Ok(HARMLESS.contains(&name).then_some("it draws no contour"))
    }

    fn element(
        &mut self,
        element: &Element,
        transform: Transform,
        is_root: bool,
    ) -> Result<(), DrawingError> {
        let size = transform.size();
        if !(size > 0.0 && size.is_finite()) {
            return Err(
                element.unsupported("is scaled to nothing, or beyond all numbers", "scale it otherwise")
            );
        }
        let Some(strands) = element.strands(self.options.gap / size)? else {
            let hint = "turn it into paths of lines and arcs, or name its id as one to leave out";
            return match element.name() {
                "g" | "a" => Ok(()),
                "svg" if is_root => Ok(()),
                "use" => Err(element.unsupported("repeats another element, which is not read", hint)),
                "image" => Err(element.unsupported("is a picture, not a line", hint)),
                _ => Err(element.unsupported("is not known here", hint)),
            };
        };
        for (part, place) in strands {
            let edges: Option<Vec<Edge>> = part.edges.iter().map(|edge| transform.edge(edge)).collect();
            let edges = edges.ok_or_else(|| {
                element.unsupported(
                    "has arcs that a transform turns into ellipses",
                    "scale evenly, without skew",
                )
            })?;
            let strand = Strand::new(edges, part.closed, place)?;
            match element.node.parent().and_then(|group| group.attribute("id")) == Some(BORES_GROUP) {
                true => self.bores.push(Bore::of(&strand)?),
                false => self.strands.push(strand),
            }
        }
        Ok(())
    }
}
