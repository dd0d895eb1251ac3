//! Expressions as a textbook writes them: plain text, LaTeX, Modelica.

use super::{Function, Id, Node, Pool, Var};

/// How an expression is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Style {
    Text,
    Latex,
    Modelica,
}

/// An expression to be shown with the names of its variables.
pub(crate) struct Printed<'a, N> {
    pub(crate) pool: &'a Pool,
    pub(crate) style: Style,
    pub(crate) name: N,
    /// Most characters; longer expressions end in dots.
    pub(crate) longest: usize,
}

/// A number to twelve digits, as short as it can be written: what is beyond them is the rounding of sums.
fn number(value: f64) -> String {
    let value = format!("{value:.11e}").parse().unwrap_or(value);
    let size = value.abs();
    if value == value.trunc() && size < 1e6 {
        format!("{value:.0}")
    } else if (1e-3..1e6).contains(&size) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// A name as an operator of LaTeX.
fn operator(name: &str) -> String {
    format!("\\operatorname{{{}}}", name.replace('_', "\\_"))
}

/// How strongly an operation binds.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Power,
    Atom,
}

impl<N: Fn(Var) -> String> Printed<'_, N> {
    /// The text of an expression.
    pub(crate) fn text(&self, id: Id) -> String {
        let mut out = String::new();
        self.write(id, Binding::Sum, &mut out);
        out
    }

    /// The text of an expression before a factor.
    pub(crate) fn factor(&self, id: Id) -> String {
        let mut out = String::new();
        self.write(id, Binding::Product, &mut out);
        out
    }

    /// An expression times something that is named: `-x` for -1, and a sign in front of the product.
    pub(crate) fn times(&self, id: Id, named: &str) -> String {
        let (minus, factor) = match self.pool.node(id) {
            Node::Negative(inner) => ("-", self.factor(inner)),
            Node::Constant(bits) if f64::from_bits(bits) < 0.0 => ("-", self.number(-f64::from_bits(bits))),
            Node::Product(a, b) if self.is_negative(a) => {
                let mut out = String::new();
                self.product(a, b, &mut out);
                ("-", out)
            }
            _ => ("", self.factor(id)),
        };
        let sign = if self.style == Style::Latex { " \\, " } else { "*" };
        if factor == "1" { format!("{minus}{named}") } else { format!("{minus}{factor}{sign}{named}") }
    }

    /// Whether nothing more is written; then dots stand where the first part is left out.
    fn is_full(&self, out: &mut String) -> bool {
        let full = out.len() >= self.longest;
        let dots = if self.style == Style::Latex { "\\ldots" } else { "..." };
        if full && !out.ends_with(dots) {
            out.push(' ');
            *out += dots;
        }
        full
    }

    fn binding(&self, id: Id) -> Binding {
        match self.pool.node(id) {
            Node::Constant(bits) if f64::from_bits(bits) < 0.0 => Binding::Sum,
            // A mantissa with a power of ten.
            Node::Constant(bits)
                if self.style == Style::Latex && number(f64::from_bits(bits)).contains('e') =>
            {
                Binding::Product
            }
            Node::Negative(_) | Node::Sum(..) => Binding::Sum,
            Node::Product(a, _) if self.is_negative(a) => Binding::Sum,
            Node::Quotient(..) if self.style == Style::Latex => Binding::Atom,
            Node::Product(..) | Node::Quotient(..) => Binding::Product,
            Node::Power(..) => Binding::Power,
            _ => Binding::Atom,
        }
    }

    fn write(&self, id: Id, at_least: Binding, out: &mut String) {
        if self.is_full(out) {
            return;
        }
        let latex = self.style == Style::Latex;
        if self.binding(id) < at_least {
            *out += if latex { "\\left(" } else { "(" };
            self.write(id, Binding::Sum, out);
            *out += if latex { "\\right)" } else { ")" };
            return;
        }
        match self.pool.node(id) {
            Node::Constant(bits) => *out += &self.number(f64::from_bits(bits)),
            Node::Var(var) => *out += &(self.name)(var),
            Node::Negative(a) => match self.pool.node(a) {
                // Both signs go.
                Node::Product(c, d) if self.is_negative(a) => self.product(c, d, out),
                _ => {
                    out.push('-');
                    self.write(a, Binding::Product, out);
                }
            },
            Node::Sum(a, b) => {
                self.write(a, Binding::Sum, out);
                if self.is_full(out) {
                    return;
                }
                match self.pool.node(b) {
                    Node::Negative(b) => match self.pool.node(b) {
                        Node::Product(c, d) if self.is_negative(c) => {
                            *out += " + ";
                            self.product(c, d, out);
                        }
                        _ => {
                            *out += " - ";
                            self.write(b, Binding::Product, out);
                        }
                    },
                    Node::Constant(bits) if f64::from_bits(bits) < 0.0 => {
                        *out += " - ";
                        *out += &self.number(-f64::from_bits(bits));
                    }
                    Node::Product(c, d) if self.is_negative(c) => {
                        *out += " - ";
                        self.product(c, d, out);
                    }
                    Node::Sum(..) => {
                        *out += " + ";
                        self.write(b, Binding::Sum, out);
                    }
                    _ => {
                        *out += " + ";
                        self.write(b, Binding::Product, out);
                    }
                }
            }
            Node::Product(a, b) => {
                *out += if self.is_negative(a) { "-" } else { "" };
                self.product(a, b, out);
            }
            Node::Quotient(a, b) if latex => {
                *out += "\\frac{";
                self.write(a, Binding::Sum, out);
                *out += "}{";
                self.write(b, Binding::Sum, out);
                *out += "}";
            }
            Node::Quotient(a, b) => {
                self.write(a, Binding::Product, out);
                if self.is_full(out) {
                    return;
                }
                out.push('/');
                self.write(b, Binding::Power, out);
            }
            Node::Power(a, b) => {
                // A fraction is an atom but where an exponent stands at it.
                let in_brackets = latex && matches!(self.pool.node(a), Node::Quotient(..));
                *out += if in_brackets { "\\left(" } else { "" };
                self.write(a, Binding::Atom, out);
                *out += if in_brackets { "\\right)" } else { "" };
                *out += if latex { "^{" } else { "^" };
                self.write(b, if latex { Binding::Sum } else { Binding::Atom }, out);
                if latex {
                    out.push('}');
                }
            }
            Node::Call(function, a) => self.call(self.function(function), &[a], out),
            Node::Atan2(a, b) => {
                self.call(if latex { "\\operatorname{atan2}" } else { "atan2" }, &[a, b], out)
            }
            Node::Min(a, b) => self.call(if latex { "\\min" } else { "min" }, &[a, b], out),
            Node::Max(a, b) => self.call(if latex { "\\max" } else { "max" }, &[a, b], out),
            Node::Table(curve, order, a) => {
                let name = identifier(&self.pool.curves[curve as usize].0);
                let name = match self.style {
                    Style::Text => format!("{name}{}", "'".repeat(usize::from(order))),
                    Style::Latex if order > 0 => format!("{}^{{({order})}}", operator(&name)),
                    Style::Latex => operator(&name),
                    Style::Modelica if order > 0 => format!("{name}_{order}"),
                    Style::Modelica => name,
                };
                self.call(&name, &[a], out);
            }
            Node::If(g, a, b) => match self.style {
                Style::Modelica => {
                    *out += "(if ";
                    self.write(g, Binding::Sum, out);
                    *out += " > 0 then ";
                    self.write(a, Binding::Sum, out);
                    *out += " else ";
                    self.write(b, Binding::Sum, out);
                    out.push(')');
                }
                Style::Text => {
                    *out += "if(";
                    self.write(g, Binding::Sum, out);
                    *out += " > 0, ";
                    self.write(a, Binding::Sum, out);
                    *out += ", ";
                    self.write(b, Binding::Sum, out);
                    out.push(')');
                }
                Style::Latex => self.call("\\operatorname{if}", &[g, a, b], out),
            },
        }
    }

    /// Whether a negative number leads an expression.
    fn is_negative(&self, id: Id) -> bool {
        match self.pool.node(id) {
            Node::Constant(bits) => f64::from_bits(bits) < 0.0,
            Node::Product(a, _) => self.is_negative(a),
            _ => false,
        }
    }

    /// A product; of a negative number that leads it without its sign.
    fn product(&self, a: Id, b: Id, out: &mut String) {
        let latex = self.style == Style::Latex;
        match self.pool.node(a) {
            Node::Constant(bits) if f64::from_bits(bits) < 0.0 => *out += &self.number(-f64::from_bits(bits)),
            Node::Product(c, d) if self.is_negative(a) => self.product(c, d, out),
            _ => self.write(a, Binding::Product, out),
        }
        if self.is_full(out) {
            return;
        }
        let at = out.len();
        *out += if latex { " \\, " } else { "*" };
        let factor = out.len();
        self.write(b, Binding::Product, out);
        // Two numbers side by side would read as one.
        if latex && out[factor..].starts_with(|sign: char| sign.is_ascii_digit()) {
            out.replace_range(at..factor, " \\cdot ");
        }
    }

    /// A number.
    pub(crate) fn number(&self, value: f64) -> String {
        match self.style {
            Style::Modelica => format!("{value:?}"),
            Style::Text => number(value),
            Style::Latex => match number(value).split_once('e') {
                Some(("1", exponent)) => format!("10^{{{exponent}}}"),
                Some((mantissa, exponent)) => format!("{mantissa} \\cdot 10^{{{exponent}}}"),
                None => number(value),
            },
        }
    }

    fn function(&self, function: Function) -> &'static str {
        match (self.style, function) {
            (Style::Modelica, Function::Ln) => "log",
            (Style::Latex, Function::Sin) => "\\sin",
            (Style::Latex, Function::Cos) => "\\cos",
            (Style::Latex, Function::Tan) => "\\tan",
            (Style::Latex, Function::Asin) => "\\arcsin",
            (Style::Latex, Function::Acos) => "\\arccos",
            (Style::Latex, Function::Sqrt) => "\\sqrt",
            (Style::Latex, Function::Exp) => "\\exp",
            (Style::Latex, Function::Ln) => "\\ln",
            (Style::Latex, Function::Tanh) => "\\tanh",
            (Style::Latex, Function::Abs) => "\\operatorname{abs}",
            (Style::Latex, Function::Sign) => "\\operatorname{sign}",
            _ => function.name(),
        }
    }

    fn call(&self, name: &str, arguments: &[Id], out: &mut String) {
        let (open, close) = match (self.style, name) {
            (Style::Latex, "\\sqrt") => ("{", "}"),
            (Style::Latex, _) => ("\\left(", "\\right)"),
            _ => ("(", ")"),
        };
        *out += name;
        *out += open;
        for (index, argument) in arguments.iter().enumerate() {
            if index > 0 {
                *out += ", ";
            }
            self.write(*argument, Binding::Sum, out);
        }
        *out += close;
    }
}

/// A name that a programming language takes.
pub(crate) fn identifier(name: &str) -> String {
    name.chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
        .collect::<String>()
        .replace("___", "_")
}
