//! A small exact SVG writer: elements, paths, text, arrows.
//!
//! Everything is styled by class (`figure.css`), so that one drawing works light and dark. Coordinates carry at most
//! two decimals and are always finite; arrows are polygons and nothing has an id, so that any number of drawings
//! can stand in one page.

/// A drawing under way.
#[derive(Debug, Clone)]
pub struct Svg {
    body: String,
    /// Width [px] at natural size.
    pub width: f64,
    /// Height [px] at natural size.
    pub height: f64,
    depth: usize,
}

/// Where a text stands relative to its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// Ends there.
    End,
}

impl Svg {
    /// An empty drawing of this natural size [px].
    pub fn new(width: f64, height: f64) -> Svg {
        Svg { body: String::with_capacity(4096), width, height, depth: 0 }
    }

    /// The elements drawn, without the outer `<svg>`.
    pub fn into_body(mut self) -> String {
        while self.depth > 0 {
            self.end();
        }
        self.body
    }

    fn open(&mut self, element: &str, class: &str) {
        self.body.push('<');
        self.body.push_str(element);
        if !class.is_empty() {
            self.body.push_str(" class=\"");
            self.body.push_str(class);
            self.body.push('"');
        }
    }

    fn attribute(&mut self, name: &str, value: f64) {
        self.body.push(' ');
        self.body.push_str(name);
        self.body.push_str("=\"");
        push_number(&mut self.body, value, 2);
        self.body.push('"');
    }

    fn close(&mut self) {
        self.body.push_str("/>\n");
    }

    /// Opens a group.
    pub fn group(&mut self, class: &str) {
        self.open("g", class);
        self.body.push_str(">\n");
        self.depth += 1;
    }

    /// Closes the innermost group.
    pub fn end(&mut self) {
        self.body.push_str("</g>\n");
        self.depth = self.depth.saturating_sub(1);
    }

    /// A straight line.
    pub fn line(&mut self, class: &str, from: (f64, f64), to: (f64, f64)) {
        self.open("line", class);
        self.attribute("x1", from.0);
        self.attribute("y1", from.1);
        self.attribute("x2", to.0);
        self.attribute("y2", to.1);
        self.close();
    }

    /// A rectangle; a negative width or height is drawn to the other side.
    pub fn rect(&mut self, class: &str, x: f64, y: f64, width: f64, height: f64) {
        self.open("rect", class);
        self.attribute("x", x.min(x + width));
        self.attribute("y", y.min(y + height));
        self.attribute("width", width.abs());
        self.attribute("height", height.abs());
        self.close();
    }

    /// A circle.
    pub fn circle(&mut self, class: &str, centre: (f64, f64), radius: f64) {
        self.open("circle", class);
        self.attribute("cx", centre.0);
        self.attribute("cy", centre.1);
        self.attribute("r", radius.abs());
        self.close();
    }

    /// A path.
    pub fn path(&mut self, class: &str, path: &Path) {
        if path.data.is_empty() {
            return;
        }
        self.open("path", class);
        self.body.push_str(" d=\"");
        self.body.push_str(&path.data);
        self.body.push('"');
        self.close();
    }

    /// A path filled with a colour of a scale, "#1a2b3c", with a hair of it around, so that neighbours leave no gap.
    pub fn fill(&mut self, colour: &str, path: &Path) {
        if path.data.is_empty() {
            return;
        }
        self.open("path", "");
        self.body.push_str(&format!(
            " style=\"fill:{colour};stroke:{colour};stroke-width:0.5\" d=\"{}\"",
            path.data
        ));
        self.close();
    }

    /// A text; `F_x` sets the x as a subscript.
    pub fn text(&mut self, class: &str, at: (f64, f64), anchor: Anchor, text: &str) {
        self.open_text(class, at, anchor);
        push_subscripts(&mut self.body, text);
        self.body.push_str("</text>\n");
    }

    /// A text that someone else chose: no subscripts.
    pub fn name(&mut self, class: &str, at: (f64, f64), anchor: Anchor, text: &str) {
        self.open_text(class, at, anchor);
        escape_into(&mut self.body, text);
        self.body.push_str("</text>\n");
    }

    fn open_text(&mut self, class: &str, at: (f64, f64), anchor: Anchor) {
        self.open("text", class);
        self.attribute("x", at.0);
        self.attribute("y", at.1);
        match anchor {
            Anchor::Start => {}
            Anchor::Middle => self.body.push_str(" text-anchor=\"middle\""),
            Anchor::End => self.body.push_str(" text-anchor=\"end\""),
        }
        self.body.push('>');
    }

    /// An arrow: its shaft a line, its head a filled triangle; `head` is the length of the head [px], made smaller
    /// on short arrows. Nothing is drawn below half a pixel.
    pub fn arrow(&mut self, class: &str, from: (f64, f64), to: (f64, f64), head: f64) {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = dx.hypot(dy);
        if !length.is_finite() || length < 0.5 {
            return;
        }
        let (ux, uy) = (dx / length, dy / length);
        let head = head.min(0.7 * length);
        let neck = (to.0 - ux * head, to.1 - uy * head);
        let half = 0.42 * head;
        self.group(class);
        // The shaft ends inside the head, so that no line cap sticks out of the tip.
        self.line("shaft", from, (neck.0 + 0.3 * ux * head, neck.1 + 0.3 * uy * head));
        let path = Path::new()
            .move_to(to)
            .line_to((neck.0 - uy * half, neck.1 + ux * half))
            .line_to((neck.0 + uy * half, neck.1 - ux * half))
            .close();
        self.path("head", &path);
        self.end();
    }

    /// An arrow along an arc about `centre` from angle `from` to angle `to` [rad, screen: x right, y down].
    pub fn arc_arrow(&mut self, class: &str, centre: (f64, f64), radius: f64, from: f64, to: f64, head: f64) {
        let at = |angle: f64| (centre.0 + radius * angle.cos(), centre.1 + radius * angle.sin());
        let sign = if to >= from { 1.0 } else { -1.0 };
        let neck = to - sign * head / radius.max(1.0);
        self.group(class);
        let arc = Path::new().move_to(at(from)).arc_to(
            radius,
            (neck - from).abs() > std::f64::consts::PI,
            sign > 0.0,
            at(neck),
        );
        self.path("shaft", &arc);
        let tip = at(to);
        let base = at(neck);
        let normal = (neck.cos(), neck.sin());
        let half = 0.42 * head;
        let path = Path::new()
            .move_to(tip)
            .line_to((base.0 + normal.0 * half, base.1 + normal.1 * half))
            .line_to((base.0 - normal.0 * half, base.1 - normal.1 * half))
            .close();
        self.path("head", &path);
        self.end();
    }
}

/// The data of a path.
#[derive(Debug, Clone, Default)]
pub struct Path {
    data: String,
}

impl Path {
    /// An empty path.
    pub fn new() -> Path {
        Path::default()
    }

    /// A curve through points, to a tenth of a pixel; points that are not finite break it.
    pub fn through(points: impl IntoIterator<Item = (f64, f64)>) -> Path {
        let mut data = String::with_capacity(2048);
        let mut broken = true;
        for (x, y) in points {
            if !(x.is_finite() && y.is_finite()) {
                broken = true;
                continue;
            }
            data.push(if broken { 'M' } else { 'L' });
            broken = false;
            push_number(&mut data, x, 1);
            data.push(' ');
            push_number(&mut data, y, 1);
        }
        Path { data }
    }

    fn command(mut self, letter: char, at: (f64, f64)) -> Path {
        self.data.push(letter);
        push_number(&mut self.data, at.0, 2);
        self.data.push(' ');
        push_number(&mut self.data, at.1, 2);
        self
    }

    /// Starts anew at a point.
    pub fn move_to(self, at: (f64, f64)) -> Path {
        self.command('M', at)
    }

    /// A straight piece.
    pub fn line_to(self, at: (f64, f64)) -> Path {
        self.command('L', at)
    }

    /// A piece of a circle; `clockwise` as seen on the screen.
    pub fn arc_to(mut self, radius: f64, large: bool, clockwise: bool, at: (f64, f64)) -> Path {
        self.data.push('A');
        push_number(&mut self.data, radius, 2);
        self.data.push(' ');
        push_number(&mut self.data, radius, 2);
        self.data.push_str(if large { " 0 1 " } else { " 0 0 " });
        self.data.push_str(if clockwise { "1 " } else { "0 " });
        push_number(&mut self.data, at.0, 2);
        self.data.push(' ');
        push_number(&mut self.data, at.1, 2);
        self
    }

    /// Back to the start of the piece.
    pub fn close(mut self) -> Path {
        self.data.push('Z');
        self
    }
}

/// Width [px] of a text at this font size: that of a wide sans-serif face, so that no reader's face needs more.
pub fn text_width(text: &str, size: f64) -> f64 {
    let units: f64 = text
        .chars()
        .map(|c| match c {
            'i' | 'j' | 'l' | '\'' | '|' | '.' | ',' | ':' | ';' | '!' | '_' => 0.31,
            'f' | 't' | 'r' | '(' | ')' | '[' | ']' | ' ' | '/' | '-' => 0.39,
            '\u{202f}' => 0.2,
            'm' | 'w' | 'M' | 'W' | '%' | '@' => 0.93,
            'A'..='Z' => 0.7,
            _ => 0.62,
        })
        .sum();
    units * size
}

/// Breaks a text into lines not wider than `width` [px].
pub fn wrap(text: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if text_width(line, size) + text_width(word, size) + 0.39 * size <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Text with the five characters of markup escaped and control characters dropped.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 8);
    escape_into(&mut out, text);
    out
}

fn escape_into(out: &mut String, text: &str) {
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\n' | '\t' => out.push(' '),
            // Not allowed in XML 1.0, not even escaped.
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => {}
            c => out.push(c),
        }
    }
}

fn push_subscripts(out: &mut String, text: &str) {
    let mut rest = text;
    while let Some(at) = rest.find('_') {
        let index = rest[at + 1..].chars().next().filter(|c| c.is_alphanumeric());
        let Some(index) = index else { break };
        escape_into(out, &rest[..at]);
        out.push_str("<tspan class=\"sub\" dy=\"2.5\">");
        escape_into(out, index.encode_utf8(&mut [0; 4]));
        out.push_str("</tspan>");
        rest = &rest[at + 1 + index.len_utf8()..];
        if !rest.is_empty() {
            // What follows goes back to the line; the shift must hang on a character.
            let first = rest.chars().next().map_or(0, char::len_utf8);
            out.push_str("<tspan dy=\"-2.5\">");
            escape_into(out, &rest[..first]);
            out.push_str("</tspan>");
            rest = &rest[first..];
        }
    }
    escape_into(out, rest);
}

/// Writes a number with at most `decimals` decimals (1 or 2), without trailing zeros; what is not finite becomes 0.
fn push_number(out: &mut String, value: f64, decimals: u32) {
    let factor = 10i64.pow(decimals);
    let value = if value.is_finite() { value.clamp(-1e6, 1e6) } else { 0.0 };
    let scaled = (value * factor as f64).round() as i64;
    if scaled < 0 {
        out.push('-');
    }
    let magnitude = scaled.abs();
    push_integer(out, magnitude / factor);
    let mut fraction = magnitude % factor;
    if fraction == 0 {
        return;
    }
    out.push('.');
    let mut place = factor / 10;
    while fraction > 0 {
        let digit = fraction / place;
        out.push(char::from(b'0' + digit as u8));
        fraction -= digit * place;
        place /= 10;
    }
}

fn push_integer(out: &mut String, value: i64) {
    if value >= 10 {
        push_integer(out, value / 10);
    }
    out.push(char::from(b'0' + (value % 10) as u8));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(value: f64) -> String {
        let mut out = String::new();
        push_number(&mut out, value, 2);
        out
    }

    #[test]
    fn numbers_are_short_and_finite() {
        assert_eq!(number(1.0), "1");
        assert_eq!(number(-0.001), "0");
        assert_eq!(number(-12.345), "-12.35");
        assert_eq!(number(0.05), "0.05");
        assert_eq!(number(1030.5), "1030.5");
        assert_eq!(number(f64::NAN), "0");
        assert_eq!(number(1e300), "1000000");
    }

    #[test]
    fn markup_is_escaped() {
        assert_eq!(escape("a<b>&\"c\"'\u{7}\n"), "a&lt;b&gt;&amp;&quot;c&quot;&#39; ");
        let mut svg = Svg::new(10.0, 10.0);
        svg.text("t", (0.0, 0.0), Anchor::Start, "F_x & <M_y>");
        let body = svg.into_body();
        assert!(
            body.contains(
                "F<tspan class=\"sub\" dy=\"2.5\">x</tspan><tspan dy=\"-2.5\"> </tspan>&amp; &lt;M"
            )
        );
        assert!(body.contains("&gt;</tspan></text>"), "{body}");
    }

    #[test]
    fn a_curve_breaks_where_it_is_not_finite() {
        let path = Path::through([(0.0, 0.0), (1.0, f64::NAN), (2.0, 1.0), (3.0, 1.0)]);
        assert_eq!(path.data, "M0 0M2 1L3 1");
    }

    #[test]
    fn lines_wrap_at_spaces() {
        let lines = wrap("the forces cancel at every angle", 12.0, 90.0);
        assert!(lines.len() > 1 && lines.iter().all(|l| text_width(l, 12.0) <= 90.0), "{lines:?}");
        assert_eq!(lines.join(" "), "the forces cancel at every angle");
    }
}
