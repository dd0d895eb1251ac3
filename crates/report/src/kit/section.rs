//! A section: what one topic has to say, in the order in which it is read, for every front end.

use crate::kit::figure::Figure;
use crate::kit::paragraph::push_wrapped;
use crate::kit::svg::escape;
use crate::kit::table::{Table, push_rich};

/// What one topic has to say of an engine: words, figures and tables in the order in which they are read.
///
/// A page shows it with [`Section::html`], a terminal with [`Section::text`], a table program with [`Section::csv`]; figures as
/// files of their own come from [`Section::figures`].
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Name for links: lower case, digits and hyphens; unique within a report.
    pub id: &'static str,
    /// What a list of contents calls it.
    pub short: &'static str,
    /// Title.
    pub title: &'static str,
    /// What stands in it.
    pub parts: Vec<Part>,
}

/// A part of a section. Words are plain text.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    /// What matters most, in a sentence or two.
    Lead(String),
    /// A paragraph.
    Words(String),
    /// A paragraph on symbols: `F_x` means an index.
    Symbols(String),
    /// Figures side by side.
    Figures(Vec<Figure>),
    /// Figures that need a row each.
    Rows(Vec<Figure>),
    /// Tables.
    Tables(Vec<Table>),
}

impl Section {
    /// A section without parts.
    pub fn new(id: &'static str, short: &'static str, title: &'static str) -> Section {
        Section { id, short, title, parts: Vec::new() }
    }

    /// The same with a lead behind it, where it has words.
    pub fn lead(mut self, words: impl Into<String>) -> Section {
        let words = words.into();
        if !words.is_empty() {
            self.parts.push(Part::Lead(words));
        }
        self
    }

    /// The same with a paragraph behind it, where it has words.
    pub fn words(mut self, words: impl Into<String>) -> Section {
        let words = words.into();
        if !words.is_empty() {
            self.parts.push(Part::Words(words));
        }
        self
    }

    /// The same with a paragraph on symbols behind it, where it has words.
    pub fn symbols(mut self, words: impl Into<String>) -> Section {
        let words = words.into();
        if !words.is_empty() {
            self.parts.push(Part::Symbols(words));
        }
        self
    }

    /// The same with paragraphs behind it.
    pub fn paragraphs(self, paragraphs: impl IntoIterator<Item = String>) -> Section {
        paragraphs.into_iter().fold(self, Section::words)
    }

    /// The same with figures side by side.
    pub fn side_by_side(mut self, figures: impl IntoIterator<Item = Figure>) -> Section {
        let figures: Vec<Figure> = figures.into_iter().collect();
        if !figures.is_empty() {
            self.parts.push(Part::Figures(figures));
        }
        self
    }

    /// The same with figures, each in a row of its own.
    pub fn rows(mut self, figures: impl IntoIterator<Item = Figure>) -> Section {
        let figures: Vec<Figure> = figures.into_iter().collect();
        if !figures.is_empty() {
            self.parts.push(Part::Rows(figures));
        }
        self
    }

    /// The same with figures of up to two panels side by side, and the others below, each in a row of its own.
    pub fn by_width(self, figures: impl IntoIterator<Item = Figure>) -> Section {
        let (slim, broad): (Vec<Figure>, Vec<Figure>) =
            figures.into_iter().partition(|figure| figure.panels.len() <= 2);
        self.side_by_side(slim).rows(broad)
    }

    /// The same with tables.
    pub fn tables(mut self, tables: impl IntoIterator<Item = Table>) -> Section {
        let tables: Vec<Table> = tables.into_iter().collect();
        if !tables.is_empty() {
            self.parts.push(Part::Tables(tables));
        }
        self
    }

    /// Whether it says anything.
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// Whether it has words or tables.
    pub fn has_text(&self) -> bool {
        self.parts.iter().any(|part| !matches!(part, Part::Figures(_) | Part::Rows(_)))
    }

    /// All figures, in order.
    pub fn figures(&self) -> impl Iterator<Item = &Figure> {
        self.parts.iter().flat_map(|part| match part {
            Part::Figures(figures) | Part::Rows(figures) => figures.as_slice(),
            Part::Lead(_) | Part::Words(_) | Part::Symbols(_) | Part::Tables(_) => &[],
        })
    }

    /// All tables, in order.
    pub fn all_tables(&self) -> impl Iterator<Item = &Table> {
        self.parts.iter().flat_map(|part| match part {
            Part::Tables(tables) => tables.as_slice(),
            _ => &[],
        })
    }

    /// Words and tables as plain text, without the title; tables parted by empty lines.
    pub fn text(&self) -> String {
        let mut out = String::new();
        let mut after_table = false;
        for part in &self.parts {
            match part {
                Part::Lead(words) | Part::Words(words) | Part::Symbols(words) => {
                    if after_table {
                        out.push('\n');
                    }
                    push_wrapped(&mut out, "", words);
                    after_table = false;
                }
                Part::Tables(tables) => {
                    for table in tables {
                        if !out.is_empty() {
                            out.push('\n');
                        }
                        out.push_str(&table.text());
                    }
                    after_table = true;
                }
                Part::Figures(_) | Part::Rows(_) => {}
            }
        }
        out
    }

    /// All tables as CSV, each under a line with its name, parted by empty lines.
    pub fn csv(&self) -> String {
        let tables = self.all_tables().map(|table| format!("# {}\n{}", table.id, table.csv()));
        tables.collect::<Vec<_>>().join("\n")
    }

    /// The section of a page.
    pub fn html(&self) -> String {
        let mut out = format!("<section id=\"{}\">\n<h2>{}</h2>\n", self.id, escape(self.title));
        for part in &self.parts {
            match part {
                Part::Lead(words) => push_paragraph(&mut out, "<p class=\"lead\">", words, push_plain),
                Part::Words(words) => push_paragraph(&mut out, "<p>", words, push_plain),
                Part::Symbols(words) => push_paragraph(&mut out, "<p>", words, push_rich),
                Part::Figures(figures) => {
                    out.push_str("<div class=\"figures\">\n");
                    push_figures(&mut out, figures);
                    out.push_str("</div>\n");
                }
                Part::Rows(figures) => push_figures(&mut out, figures),
                Part::Tables(tables) => {
                    out.push_str("<div class=\"tables\">\n");
                    for table in tables {
                        out.push_str(&table.html());
                    }
                    out.push_str("</div>\n");
                }
            }
        }
        out.push_str("</section>\n");
        out
    }
}

fn push_plain(out: &mut String, text: &str) {
    out.push_str(&escape(text));
}

fn push_paragraph(out: &mut String, tag: &str, words: &str, push: fn(&mut String, &str)) {
    out.push_str(tag);
    push(out, &unbroken(words));
    out.push_str("</p>\n");
}

/// The text with its units kept beside their numbers.
fn unbroken(text: &str) -> String {
    [" kN", " N", " m ", " rpm"]
        .iter()
        .fold(text.to_owned(), |text, unit| text.replace(unit, &unit.replacen(' ', "\u{a0}", 1)))
}

/// Figures of a page.
pub(crate) fn push_figures(out: &mut String, figures: &[Figure]) {
    for figure in figures {
        let class = match (figure.panels.len(), figure.columns) {
            (0..=2, _) => "plot",
            (_, 2) => "plot many two",
            (_, 3) => "plot many three",
            _ => "plot many",
        };
        out.push_str("<figure class=\"");
        out.push_str(class);
        out.push_str("\" id=\"");
        out.push_str(&escape(&figure.id));
        out.push_str("\">\n<h3>");
        push_rich(out, &figure.title);
        out.push_str("</h3>\n<div class=\"panels\">\n");
        for panel in &figure.panels {
            panel.write_inline(out);
        }
        out.push_str("</div>\n<figcaption>");
        push_rich(out, &figure.caption);
        out.push_str("</figcaption>\n</figure>\n");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kit::table::{numbers, words};

    fn table(id: &'static str) -> Table {
        let columns = vec![
            words("mount", ["left", "a, b"].into_iter().map(str::to_owned)),
            numbers("F_x", "N", [1234.5, -2.0].into_iter(), 5),
        ];
        Table::of_columns(id, "Forces", "", columns)
    }

    fn section() -> Section {
        Section::new("mounts", "Mounts", "On the mounts <here>")
            .lead("The force is 3 kN.")
            .words("")
            .words("A & b.")
            .tables([table("one"), table("two")])
            .words("After.")
    }

    #[test]
    fn words_and_tables_are_read_in_their_order() {
        let text = section().text();
        let at = |what: &str| text.find(what).unwrap_or_else(|| panic!("{what} is missing in\n{text}"));
        assert!(at("The force is 3 kN.") < at("A & b.") && at("A & b.") < at("Forces"));
        assert!(at("Forces") < at("After."));
        assert!(text.contains("\n\nAfter.\n"), "{text}");
        assert_eq!(text.matches("Forces").count(), 2);
    }

    #[test]
    fn a_page_escapes_words_and_keeps_units_at_their_numbers() {
        let html = section().html();
        assert!(html.starts_with("<section id=\"mounts\">\n<h2>On the mounts &lt;here&gt;</h2>\n"), "{html}");
        assert!(html.contains("<p class=\"lead\">The force is 3\u{a0}kN.</p>"), "{html}");
        assert!(html.contains("<p>A &amp; b.</p>"), "{html}");
    }

    #[test]
    fn csv_names_each_table_and_guards_its_cells() {
        let csv = section().csv();
        let names: Vec<&str> = csv.lines().filter(|line| line.starts_with('#')).collect();
        assert_eq!(names, ["# one", "# two"]);
        assert!(csv.contains("\"a, b\",-2"), "{csv}");
    }

    #[test]
    fn what_has_nothing_to_say_leaves_no_part() {
        let nothing = Section::new("a", "A", "A").lead("").tables([]).rows([]).side_by_side([]);
        assert!(nothing.is_empty());
    }
}
