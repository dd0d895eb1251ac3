//! Text and LaTeX hold the same equations, and derivatives of what is imposed are written out.

use lanchester_bondgraph::{
    Description, Equations, Graph, Notation, equations, equations_latex, equations_text, mathml,
};

macro_rules! shipped {
    ($($name:literal),*) => {
        [$(include_str!(concat!("../../../../examples/bond-graphs/", $name, ".toml"))),*]
    };
}

const SHIPPED: [&str; 13] = shipped!(
    "dc-motor",
    "double-pendulum",
    "double-pendulum-stiff",
    "gear-train",
    "hydraulic-press",
    "mass-spring-damper",
    "prismatic-pair-printed",
    "single-cylinder",
    "slider-crank",
    "slider-crank-elastic",
    "stick-slip",
    "torsion-chain",
    "two-tanks-turbulent"
);

fn of(description: &Description) -> Equations {
    let graph = Graph::new(description).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    equations(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"))
}

/// Whether brackets of LaTeX close in the order in which they open, and no fraction lacks its second part.
fn is_closed(text: &str) -> bool {
    let mut open = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        let (token, length) = match rest {
            _ if rest.starts_with("\\left(") => (Some('('), 6),
            _ if rest.starts_with("\\right)") => (Some(')'), 7),
            _ if rest.starts_with("\\frac{") => (Some('f'), 6),
            _ if rest.starts_with(['{', '}']) => (rest.chars().next(), 1),
            _ => (None, rest.chars().next().map_or(1, char::len_utf8)),
        };
        at += length;
        match token {
            Some(')') if open.pop() != Some('(') => return false,
            Some('}') => match open.pop() {
                Some('f') if !text[at..].starts_with('{') => return false,
                Some('f' | '{') => {}
                _ => return false,
            },
            Some(opened @ ('(' | '{' | 'f')) => open.push(opened),
            _ => {}
        }
    }
    open.is_empty()
}

#[test]
fn latex_holds_what_the_text_holds() {
    for text in SHIPPED {
        let graph = Graph::read(text).expect("shipped graphs have no mistake");
        let found = equations(&graph).expect("nor a conflict");
        let [plain, latex] = [Notation::Text, Notation::Latex].map(|notation| found.shown(notation));
        let (plain_parts, latex_parts) = (plain.parts(), latex.parts());
        let document = equations_latex(&latex);
        assert!(is_closed(&document), "{document}");
        for (own, other) in plain_parts.iter().zip(&latex_parts) {
            assert_eq!(own.title, other.title);
            assert_eq!(own.lines.len(), other.lines.len(), "{}", own.title);
            assert!(document.contains(&format!("\\subsection*{{{}}}", own.title)), "{}", own.title);
            assert!(equations_text(&plain).contains(&format!("\n{}\n", own.title)), "{}", own.title);
            for line in &other.lines {
                assert!(
                    line.equation.left.len() > 60 || document.contains(&line.equation.left),
                    "{} {:?}",
                    own.title,
                    line
                );
                let drawn = mathml(&line.formula(Notation::Latex));
                assert!(!drawn.contains('\\') && !drawn.contains('{'), "{drawn}");
            }
        }
        assert_eq!(plain_parts.len(), latex_parts.len());
        assert!(plain_parts.iter().any(|part| part.title == "Laws of the junctions"), "{}", plain.graph);
    }
}

/// A ratio that is a sum stands in brackets before the flow that it multiplies, numbers apart from one another.
#[test]
fn factors_are_told_from_one_another() {
    let graph = Graph::read(SHIPPED[8]).expect("it is good");
    let shown = equations(&graph).expect("no conflict").shown(Notation::Latex);
    let law = shown.elements.iter().find(|law| law.of == "slider").expect("it is a transformer");
    assert!(law.right.starts_with("\\left(-r"), "{}", law.right);
    let product = Description::new("numbers")
        .element("push", "Se", &[("domain", "translation"), ("effort", "2 N * sin(t*1/(1 s)) * 3")])
        .element("mass", "I", &[("inertia", "2e6 kg")])
        .bonds(&["push > mass"]);
    let shown = of(&product).shown(Notation::Latex);
    assert_eq!(shown.elements[1].right, "\\frac{p_{\\mathrm{mass}}}{2 \\cdot 10^{6}}");
    assert!(!shown.elements[0].right.contains("2 \\, 3"), "{}", shown.elements[0].right);
}

/// An imposed flow on an inertia, an imposed effort on a spring: no state is left, and both sources are differentiated.
#[test]
fn what_is_imposed_on_a_store_is_differentiated() {
    let imposed = Description::new("imposed")
        .parameter("w", "20 rad/s")
        .element("drive", "Sf", &[("domain", "translation"), ("flow", "0.5 m/s * sin(w*t)")])
        .element("mass", "I", &[("inertia", "3 kg")])
        .element("push", "Se", &[("domain", "translation"), ("effort", "100 N * w*t")])
        .element("spring", "C", &[("stiffness", "50 N/m")])
        .bonds(&["drive > mass", "push > spring"]);
    let found = of(&imposed);
    let shown = found.shown(Notation::Text);
    assert!(shown.states.is_empty() && shown.rates.is_empty());
    let laws: Vec<String> =
        shown.elements.iter().map(|law| format!("{} = {}", law.left, law.right)).collect();
    assert!(laws.contains(&"mass.effort = d(mass.momentum)/dt".to_owned()), "{laws:?}");
    assert!(laws.contains(&"spring.flow = d(spring.displacement)/dt".to_owned()), "{laws:?}");
    let equations: Vec<&str> = shown.unknowns.iter().map(|unknown| unknown.equation.as_str()).collect();
    assert_eq!(
        equations,
        ["mass.effort = d/dt(1.5*sin(w*t)) = 1.5*cos(w*t)*w", "spring.flow = d/dt(100*w*t/50) = 100*w/50"]
    );
    assert_eq!(shown.unknowns.iter().map(|unknown| unknown.unit.as_str()).collect::<Vec<_>>(), ["N", "m/s"]);
    let latex = equations_latex(&found.shown(Notation::Latex));
    assert!(latex.contains("\\frac{d}{dt}\\left("), "{latex}");
}

/// What is too long to be written out ends in dots, with every bracket closed.
#[test]
fn a_cut_equation_is_closed() {
    let part = |from: usize| {
        let term = |n: usize| format!("sin({n}*t/(1 s))/(2 + sqrt({n} + (t/(1 s))^2))");
        (from..from + 20).map(term).collect::<Vec<_>>().join(" + ")
    };
    let mut long = Description::new("long")
        .element("push", "Se", &[("domain", "translation"), ("effort", "exp(-(a + b + c + d + e5)/2) * 1 N")])
        .element("mass", "I", &[("inertia", "2 kg")])
        .bonds(&["push > mass"]);
    for (index, name) in ["a", "b", "c", "d", "e5"].into_iter().enumerate() {
        long = long.signal(name, &[("value", &part(20 * index + 1))]);
    }
    let found = of(&long);
    let shown = found.shown(Notation::Latex);
    let law = &shown.rates[0].right;
    assert!(law.contains("\\ldots") && law.len() < 3300, "{}", law.len());
    assert!(is_closed(law), "{law}");
    let shown = found.shown(Notation::Text);
    let law = &shown.rates[0].right;
    assert!(law.contains("...") && law.matches('(').count() == law.matches(')').count(), "{law}");
}

/// Names with Greek letters and subscripts, signs and units as a textbook prints them; numbers of pure rounding are 0.
#[test]
fn symbols_signs_and_units_are_those_of_a_textbook() {
    let text = r#"
name = "signs"
[parameters]
mu_3 = "2"
m_c = "1.5 kg"
A1 = "3 N s/m"
rho_g = "9810 N/m^3"
km = "0.08 N m/A"
b_2 = "0.3 m - 0.1 m - 0.2 m"
stiff = "200 N/mm"
[elements]
a = { kind = "1", domain = "translation" }
b = { kind = "1", domain = "translation" }
c = { kind = "1", domain = "translation" }
mass_a = { kind = "I", inertia = "m_c", flow = "1 m/s" }
mass_b = { kind = "I", inertia = "m_c" }
push = { kind = "Se", effort = "-2.5*m_c*9.81 m/s2" }
arm = { kind = "MTF", matrix = "1; -0.1*sin(phi_1)" }
damper = { kind = "R", resistance = "A1" }
lever = { kind = "TF", ratio = "-1" }
d = { kind = "1", domain = "translation" }
spring = { kind = "C", stiffness = "stiff" }
dash = { kind = "R", resistance = "A1" }
[signals]
phi_1 = { integral_of = "a.flow/(1 m)", start = "0.1 rad" }
[bonds]
list = ["push > a", "a > mass_a", "b > mass_b", "a > arm.1", "b > arm.2", "arm.3 > c", "c > damper", "b > lever.1", "lever.2 > d", "d > spring", "d > dash"]
"#;
    let found = equations(&Graph::read(text).expect("good")).expect("no conflict");
    let (plain, latex) = (found.shown(Notation::Text), found.shown(Notation::Latex));
    let line = |list: &[lanchester_bondgraph::Equation], left: &str| -> String {
        let own =
            list.iter().find(|own| own.left == left).unwrap_or_else(|| panic!("no {left} in {list:#?}"));
        format!("{} [{}]", own.right, own.unit)
    };
    assert_eq!(line(&plain.elements, "arm.3.flow"), "arm.1.flow - 0.1*sin(phi_1)*arm.2.flow [m/s]");
    assert_eq!(line(&plain.elements, "push.effort"), "-24.525*m_c [N]");
    assert_eq!(line(&plain.elements, "lever.2.flow"), "-lever.1.flow [m/s]");
    assert_eq!(line(&plain.parameters, "km"), "0.08 [N m/A]");
    assert_eq!(line(&plain.parameters, "rho_g"), "9810 [N/m^3]");
    assert_eq!(line(&plain.parameters, "stiff"), "200000 [N/m]");
    assert_eq!(line(&plain.parameters, "b_2"), "0 [m]");
    let lefts: Vec<&str> = latex.parameters.iter().map(|own| own.left.as_str()).collect();
    assert_eq!(
        lefts,
        ["\\mu_{3}", "m_{c}", "A_{1}", "\\rho_{g}", "\\mathrm{km}", "b_{2}", "\\mathrm{stiff}"]
    );
    // d(mass_b)/dt has a sum that is taken off as a whole: no sign stands before a bracket that begins with one.
    let rates: Vec<String> = plain.rates.iter().map(|own| own.right.clone()).collect();
    assert!(rates.iter().all(|rate| !rate.contains("(-")), "{rates:#?}");
    let set = mathml("\\dot \\phi_{1} = \\mu_{3} \\, m_{c}");
    assert!(set.contains("μ") && set.contains("<msub>"), "{set}");
}
