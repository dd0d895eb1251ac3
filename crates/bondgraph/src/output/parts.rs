//! All equations of a graph in the order in which they are written: one list for text, LaTeX and MathML.

use crate::output::shown::{Equation, Notation, ShownEquations};

/// Equations under one title.
#[derive(Debug, Clone, PartialEq)]
pub struct EquationPart {
    /// What they are.
    pub title: &'static str,
    /// One after the other.
    pub lines: Vec<PartLine>,
}

/// One equation, or what an event sets.
#[derive(Debug, Clone, PartialEq)]
pub struct PartLine {
    /// The equation.
    pub equation: Equation,
    /// What rises through 0 where the left side becomes the right one; none of an equation that holds always.
    pub when: Option<String>,
    /// Why it is there, in words.
    pub why: Option<String>,
}

impl PartLine {
    fn always(equation: Equation) -> PartLine {
        PartLine { equation, when: None, why: None }
    }

    /// The equation on one line, without its unit.
    pub fn formula(&self, notation: Notation) -> String {
        let Equation { left, right, .. } = &self.equation;
        match (&self.when, notation) {
            (None, _) => format!("{left} = {right}"),
            (Some(when), Notation::Text) => format!("{when} rises through 0: {left} becomes {right}"),
            (Some(when), Notation::Latex) => {
                format!("{when} \\text{{ rises through 0: }} {left} \\leftarrow {right}")
            }
        }
    }
}

impl ShownEquations {
    /// All equations under their titles, in causal order; titles without an equation are left out.
    pub fn parts(&self) -> Vec<EquationPart> {
        let always = |list: &[Equation]| list.iter().cloned().map(PartLine::always).collect::<Vec<_>>();
        [
            ("Parameters", always(&self.parameters)),
            ("Laws of the elements", always(&self.elements)),
            ("Laws of the junctions", always(&self.junctions)),
            ("Signals", always(&self.signals)),
            ("Events", self.event_lines()),
            ("States at the start", self.starts()),
            ("State equations, M x' = f", self.mass_lines()),
            ("Common parts", always(&self.common)),
            ("Unknowns", self.unknown_lines()),
            ("State equations", always(&self.rates)),
        ]
        .into_iter()
        .filter(|(_, lines)| !lines.is_empty())
        .map(|(title, lines)| EquationPart { title, lines })
        .collect()
    }

    fn event_lines(&self) -> Vec<PartLine> {
        let line = |event: &Equation| PartLine {
            equation: Equation { of: String::new(), ..event.clone() },
            when: Some(event.of.clone()),
            why: None,
        };
        self.events.iter().map(line).collect()
    }

    fn starts(&self) -> Vec<PartLine> {
        let line = |state: &crate::output::shown::ShownState| {
            PartLine::always(Equation {
                of: String::new(),
                left: format!("{}(0)", state.symbol),
                right: state.written.clone(),
                unit: state.unit.clone(),
            })
        };
        self.states.iter().map(line).collect()
    }

    fn unknown_lines(&self) -> Vec<PartLine> {
        let line = |unknown: &crate::output::shown::ShownUnknown| PartLine {
            equation: Equation {
                of: String::new(),
                left: unknown.symbol.clone(),
                right: unknown.value.clone(),
                unit: unknown.unit.clone(),
            },
            when: None,
            why: Some(unknown.why.clone()),
        };
        self.unknowns.iter().map(line).collect()
    }

    /// M x' = f, row by row.
    fn mass_lines(&self) -> Vec<PartLine> {
        let (Some(mass), Some(right)) = (&self.mass, &self.right) else { return Vec::new() };
        let term = |entry: &str, rate: &str| match (entry, self.notation) {
            ("1", _) => rate.to_owned(),
            (entry, Notation::Text) => format!("({entry})*{rate}"),
            (entry, Notation::Latex) => format!("\\left({entry}\\right) \\, {rate}"),
        };
        (mass.iter().zip(right))
            .map(|(row, right)| {
                let terms: Vec<String> = (row.iter().zip(&self.rates))
                    .filter(|(entry, _)| *entry != "0")
                    .map(|(entry, rate)| term(entry, &rate.left))
                    .collect();
                PartLine::always(Equation {
                    of: String::new(),
                    left: terms.join(" + "),
                    right: right.clone(),
                    unit: String::new(),
                })
            })
            .collect()
    }
}
