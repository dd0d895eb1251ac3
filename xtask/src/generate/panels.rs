//! Some drawings of a figure of the report, side by side where both fit, else one below the other: pages of the book are narrower than a sheet of panels.

use anyhow::{Context, Result, ensure};
use std::fmt::Write;

/// Between two drawings, and around them [px].
const GAP: f64 = 12.0;
/// A row is no wider [px].
const WIDEST: f64 = 500.0;
/// Words stay legible where the picture is as wide as a phone; numbers at the end of an axis may reach over the edge of their drawing.
const PHONE: &str = ".figure .panel { overflow: visible; }\n@media (max-width: 420px) { svg.figure { font-size: 15px; } .figure .small { font-size: 14.5px; } }\n";

/// The figure with these of its drawings alone, without the title and caption that the page has itself.
pub fn arranged(figure: &str, wanted: &[usize]) -> Result<String> {
    let (head, after) = figure.split_once("<style>").context("a figure without styles")?;
    let (styles, _) = after.split_once("</style>").context("styles without an end")?;
    let title = head.find("<title").context("a figure without a title")?;
    let label = head.split_once("aria-labelledby=\"").and_then(|(_, rest)| rest.split('"').next());
    let label = label.context("a figure without a name")?;
    let all: Vec<&str> =
        figure.match_indices("<svg class=\"panel\"").map(|(at, _)| panel(&figure[at..])).collect();
    let (mut width, mut bottom, mut body) = (0.0f64, GAP, String::new());
    // Where the next drawing stands.
    let (mut left, mut top) = (GAP, GAP);
    for &index in wanted {
        let drawing = all.get(index).with_context(|| format!("no drawing {index} among {}", all.len()))?;
        let size = |name: &str| number(drawing, name).with_context(|| format!("a drawing without {name}"));
        let (w, h) = (size("width")?, size("height")?);
        let (_, inside) = drawing.split_once('>').context("a drawing without an end")?;
        if left > GAP && left + w > WIDEST + GAP {
            (left, top) = (GAP, bottom);
        }
        let _ = write!(
            body,
            "<svg class=\"panel\" x=\"{left}\" y=\"{top}\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\">{inside}"
        );
        left += w + GAP;
        width = width.max(left);
        bottom = bottom.max(top + h + GAP);
    }
    ensure!(!body.is_empty(), "no drawing is wanted");
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"figure\" width=\"{width}\" height=\"{bottom}\" viewBox=\"0 0 {width} {bottom}\" \
         role=\"img\" aria-labelledby=\"{label}\">\n{}<style>{styles}{PHONE}</style>\n\
         <rect class=\"sheet\" width=\"100%\" height=\"100%\"/>\n{body}</svg>\n",
        &head[title..]
    ))
}

/// The element at the beginning of a text, with its end; drawings hold none of their kind.
fn panel(text: &str) -> &str {
    const END: &str = "</svg>\n";
    text.find(END).map_or(text, |end| &text[..end + END.len()])
}

fn number(element: &str, name: &str) -> Option<f64> {
    let (_, after) = element.split_once(&format!(" {name}=\""))?;
    after.split('"').next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    const FIGURE: &str = "<svg xmlns=\"x\" width=\"1000\" height=\"300\" aria-labelledby=\"a-title a-desc\">\n<title id=\"a-title\">T</title>\n\
         <style>\n.s {}</style>\n<text>Title</text>\n<svg class=\"panel\" x=\"20\" y=\"48\" width=\"480\" height=\"200\" viewBox=\"0 0 480 200\">\n\
         <g/></svg>\n<svg class=\"panel\" x=\"520\" y=\"48\" width=\"400\" height=\"100\" viewBox=\"0 0 400 100\">\n<b/></svg>\n</svg>\n";

    #[test]
    fn the_drawings_wanted_stand_below_one_another() {
        let both = arranged(FIGURE, &[1, 0]).expect("both");
        assert!(both.contains("width=\"504\" height=\"336\""), "{both}");
        assert!(both.find("<b/>") < both.find("<g/>") && !both.contains("<text>"));
        assert!(arranged(FIGURE, &[2]).is_err() && arranged(FIGURE, &[]).is_err());
    }
}
