//! A figure: one or more panels with a title and a caption.

use crate::kit::svg::{Anchor, Svg, escape, wrap};
use std::fmt::Write;

/// The styles of all figures, light and dark.
pub(crate) const STYLE: &str = include_str!("../../templates/figure.css");

/// One drawing of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What a reader who cannot see it is told; plain text.
    pub description: String,
    /// Natural width in px.
    pub width: f64,
    /// Natural height in px.
    pub height: f64,
    body: String,
}

impl Panel {
    /// A finished drawing.
    pub fn new(svg: Svg, description: impl Into<String>) -> Panel {
        Panel { description: description.into(), width: svg.width, height: svg.height, body: svg.into_body() }
    }

    /// The panel as an `<svg>` inside an HTML page.
    pub(crate) fn write_inline(&self, out: &mut String) {
        let (width, height) = (self.width, self.height);
        let label = escape(&self.description);
        // A broad drawing shrinks most on a phone: its words are set larger there.
        let broad = if width > 400.0 { " broad" } else { "" };
        let _ = write!(
            out,
            "<svg class=\"figure{broad}\" viewBox=\"0 0 {width:.0} {height:.0}\" \
             style=\"--natural:{width:.0}px\" role=\"img\" aria-label=\"{label}\">\n{}</svg>\n",
            self.body
        );
    }
}

/// A figure of the report; [`Figure::svg`] makes it a file of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Name for files and links: lower case, digits and hyphens.
    pub id: String,
    /// Title; plain text, `F_x` meaning an index.
    pub title: String,
    /// What the figure shows and how to read it; plain text, `F_x` meaning an index.
    pub caption: String,
    /// Its drawings.
    pub panels: Vec<Panel>,
    /// Drawings side by side in a file of its own.
    pub columns: usize,
}

const MARGIN: f64 = 20.0;
const GAP: f64 = 18.0;

impl Figure {
    /// The figure as an SVG document with its own styles (light, and dark where the reader prefers it), title and
    /// description.
    pub fn svg(&self) -> String {
        let columns = self.columns.clamp(1, self.panels.len().max(1));
        let cell = self.panels.iter().fold(120.0, |w: f64, p| w.max(p.width));
        let inner = columns as f64 * (cell + GAP) - GAP;
        let width = inner + 2.0 * MARGIN;
        let caption = wrap(&self.caption, 12.5, inner);
        let mut places = Vec::with_capacity(self.panels.len());
        let mut top = 48.0;
        for row in self.panels.chunks(columns) {
            for (index, panel) in row.iter().enumerate() {
                places.push((panel, MARGIN + index as f64 * (cell + GAP), top));
            }
            top += row.iter().fold(0.0, |h: f64, p| h.max(p.height)) + GAP;
        }
        let mut words = Svg::new(width, top + 17.0 * caption.len() as f64 + 8.0);
        words.text("heading", (MARGIN, 30.0), Anchor::Start, &self.title);
        for (index, line) in caption.iter().enumerate() {
            words.text("muted", (MARGIN, top + 8.0 + 17.0 * index as f64), Anchor::Start, line);
        }
        let (height, id, title) = (words.height, escape(&self.id), escape(&self.title));
        let description = escape(&self.description());
        let mut out =
            String::with_capacity(4096 + self.panels.iter().map(|p| p.body.len() + 128).sum::<usize>());
        let _ = write!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"figure\" width=\"{width:.0}\" height=\"{height:.0}\" \
             viewBox=\"0 0 {width:.0} {height:.0}\" role=\"img\" aria-labelledby=\"{id}-title {id}-desc\">\n\
             <title id=\"{id}-title\">{title}</title>\n<desc id=\"{id}-desc\">{description}</desc>\n\
             <style>\n{STYLE}</style>\n<rect class=\"sheet\" width=\"100%\" height=\"100%\"/>\n"
        );
        out.push_str(&words.into_body());
        for (panel, x, y) in places {
            let (w, h) = (panel.width, panel.height);
            let _ = write!(
                out,
                "<svg class=\"panel\" x=\"{x:.0}\" y=\"{y:.0}\" width=\"{w:.0}\" height=\"{h:.0}\" \
                 viewBox=\"0 0 {w:.0} {h:.0}\">\n{}</svg>\n",
                panel.body
            );
        }
        out.push_str("</svg>\n");
        out
    }

    /// Caption and panels in words.
    fn description(&self) -> String {
        let mut out = self.caption.clone();
        for panel in self.panels.iter().filter(|p| !p.description.is_empty()) {
            out.push(' ');
            out.push_str(&panel.description);
        }
        out
    }
}
