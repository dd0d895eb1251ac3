//! Text to expression, with the unit of every part.

use super::{Function, Id, Pool};
use crate::description::Text;
use crate::mistake::Mistakes;
use crate::unit::{Unit, leading_unit};

/// Brackets deeper than this, or longer texts, are refused.
const DEEPEST: usize = 60;
const LONGEST: usize = 4000;

/// An expression and its unit; none for a zero, which has every unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Parsed {
    pub(crate) id: Id,
    pub(crate) unit: Option<Unit>,
}

/// Where names are looked up.
pub(crate) trait Scope {
    fn pool(&mut self) -> &mut Pool;
    /// What a name stands for; the error says what is wrong with it and what helps.
    fn name(&mut self, name: &str) -> Result<Parsed, Option<(String, String)>>;
    fn mistakes(&mut self) -> &mut Mistakes;
    /// Place of a table among the curves, with the units of argument and value.
    fn table(&mut self, name: &str) -> Option<(u32, [Unit; 2])>;
}

/// Reads a text; mistakes are noted and give `None`.
pub(crate) fn parse(text: &Text, scope: &mut impl Scope) -> Option<Parsed> {
    if text.text.len() > LONGEST {
        scope.mistakes().push("E1715", &text.span, "the expression is too long", "name its parts as signals");
        return None;
    }
    let mut reader = Reader { text, at: 0, depth: 0, scope };
    let parsed = reader.sum()?;
    reader.blanks();
    if reader.at < text.text.len() {
        let rest: String = text.text[reader.at..].chars().take(20).collect();
        reader.refuse(
            format!("`{}` cannot be read from `{rest}` on", text.text),
            "an operator is missing, or a unit is unknown: products need *, for example \"2*r\" or \"5 N m\"",
        );
        return None;
    }
    Some(parsed)
}

struct Reader<'a, S> {
    text: &'a Text,
    at: usize,
    depth: usize,
    scope: &'a mut S,
}

impl<S: Scope> Reader<'_, S> {
    fn rest(&self) -> &str {
        &self.text.text[self.at..]
    }

    fn blanks(&mut self) {
        self.at += self.rest().len() - self.rest().trim_start().len();
    }

    fn take(&mut self, sign: char) -> bool {
        self.blanks();
        let found = self.rest().starts_with(sign);
        if found {
            self.at += sign.len_utf8();
        }
        found
    }

    fn refuse(&mut self, message: impl Into<String>, hint: impl Into<String>) {
        let span = self.text.span.clone();
        self.scope.mistakes().push("E1704", &span, message, hint);
    }

    fn wrong_unit(&mut self, message: String) {
        let span = self.text.span.clone();
        let message = format!("in `{}` {message}", self.text.text);
        self.scope.mistakes().push("E1705", &span, message, "check the units of the parts");
    }

    fn sum(&mut self) -> Option<Parsed> {
        self.depth += 1;
        if self.depth > DEEPEST {
            self.refuse("the brackets are too deep", "name parts of the expression as signals");
            return None;
        }
        let mut left = self.product()?;
        loop {
            let minus = if self.take('+') {
                false
            } else if self.take('-') {
                true
            } else {
                break;
            };
            let right = self.product()?;
            let unit = self.same(left.unit, right.unit, if minus { "less" } else { "plus" });
            let pool = self.scope.pool();
            let id = if minus { pool.difference(left.id, right.id) } else { pool.sum(left.id, right.id) };
            left = Parsed { id, unit };
        }
        self.depth -= 1;
        Some(left)
    }

    /// The unit of two parts that need the same one.
    fn same(&mut self, a: Option<Unit>, b: Option<Unit>, word: &str) -> Option<Unit> {
        if let (Some(a), Some(b)) = (a, b)
            && a != b
        {
            self.wrong_unit(format!("{a} {word} {b} has no meaning"));
        }
        a.or(b)
    }

    fn product(&mut self) -> Option<Parsed> {
        let mut left = self.signed()?;
        loop {
            let over = if self.take('*') {
                false
            } else if self.take('/') {
                true
            } else {
                return Some(left);
            };
            let right = self.signed()?;
            let unit = match (left.unit, right.unit) {
                (Some(a), Some(b)) => Some(if over { a.over(b) } else { a.times(b) }),
                _ => None,
            };
            let pool = self.scope.pool();
            let id = if over { pool.quotient(left.id, right.id) } else { pool.product(left.id, right.id) };
            left = Parsed { id, unit };
        }
    }

    fn signed(&mut self) -> Option<Parsed> {
        let mut minus = false;
        loop {
            if self.take('-') {
                minus = !minus;
            } else if !self.take('+') {
                break;
            }
        }
        let mut parsed = self.power()?;
        if minus {
            parsed.id = self.scope.pool().negative(parsed.id);
        }
        Some(parsed)
    }

    fn power(&mut self) -> Option<Parsed> {
        let base = self.atom()?;
        if !self.take('^') {
            return Some(base);
        }
        self.depth += 1;
        if self.depth > DEEPEST {
            self.refuse("the powers are too deep", "name parts of the expression as signals");
            return None;
        }
        let exponent = self.signed()?;
        self.depth -= 1;
        if exponent.unit.is_some_and(|unit| unit != Unit::NONE) {
            self.wrong_unit("an exponent has a unit".into());
        }
        let value = self.scope.pool().value(exponent.id);
        let unit = match (base.unit, value) {
            (Some(unit), Some(value)) => match unit.power(value) {
                Some(unit) => Some(unit),
                None => {
                    self.wrong_unit(format!("{unit} to the power {value} is no unit"));
                    Some(unit)
                }
            },
            (Some(unit), None) if unit != Unit::NONE => {
                self.wrong_unit(format!("{unit} has an exponent that is no plain number"));
                Some(unit)
            }
            (unit, _) => unit,
        };
        Some(Parsed { id: self.scope.pool().power(base.id, exponent.id), unit })
    }

    fn atom(&mut self) -> Option<Parsed> {
        self.blanks();
        if self.take('(') {
            let inner = self.sum()?;
            if !self.take(')') {
                self.refuse(format!("`{}` lacks a closing bracket", self.text.text), "add )");
                return None;
            }
            return Some(inner);
        }
        let rest = self.rest();
        match rest.chars().next() {
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => self.named(),
            Some(c) => {
                let message = format!("`{}` has no value at `{c}`", self.text.text);
                self.refuse(message, "a number, a name or a bracket is needed there");
                None
            }
            None => {
                let message = format!("`{}` ends where a value is needed", self.text.text);
                self.refuse(message, "a number, a name or a bracket is needed there");
                None
            }
        }
    }

    fn number(&mut self) -> Option<Parsed> {
        let bytes = self.rest().as_bytes();
        let mut end = bytes.iter().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let digits = bytes[end + 1 + sign..].iter().take_while(|b| b.is_ascii_digit()).count();
            if digits > 0 {
                end += 1 + sign + digits;
            }
        }
        let written = self.rest()[..end].to_owned();
        let Some(value) = written.parse::<f64>().ok().filter(|value| value.is_finite()) else {
            self.refuse(format!("{written} is no number"), "write it like 12.5 or 3e-4");
            return None;
        };
        self.at += end;
        let (factor, unit, named) = match leading_unit(self.rest()) {
            Some((length, factor, unit)) => {
                self.at += length;
                (factor, unit, true)
            }
            None => (1.0, Unit::NONE, false),
        };
        let unit = (value != 0.0 || named).then_some(unit);
        // Division by a whole number rounds once: "144 mm" is the double of 0.144.
        let whole = (1.0 / factor).round();
        let exact = factor < 1.0 && (1.0 / whole - factor).abs() <= f64::EPSILON * factor;
        let value = if exact { value / whole } else { value * factor };
        Some(Parsed { id: self.scope.pool().constant(value), unit })
    }

    fn named(&mut self) -> Option<Parsed> {
        let length = self
            .rest()
            .char_indices()
            .find(|(_, c)| !(c.is_alphanumeric() || *c == '_' || *c == '.'))
            .map_or(self.rest().len(), |(at, _)| at);
        let name = self.rest()[..length].to_owned();
        self.at += length;
        if self.take('(') {
            return self.function(&name);
        }
        match self.scope.name(&name) {
            Ok(parsed) => Some(parsed),
            Err(what) => {
                if let Some((message, hint)) = what {
                    let span = self.text.span.clone();
                    self.scope.mistakes().push("E1706", &span, message, hint);
                }
                None
            }
        }
    }

    /// `table(pressure, phi)` or `table("pressure.csv", phi)` behind its first bracket.
    fn table(&mut self) -> Option<Parsed> {
        self.blanks();
        let rest = self.rest().to_owned();
        let quoted = rest.strip_prefix('"').and_then(|rest| rest.split_once('"')).map(|(name, _)| name);
        let (name, used) = match quoted {
            Some(name) => (name, name.len() + 2),
            None => {
                let name = rest.split([',', ')']).next().unwrap_or("").trim_end();
                (name, name.len())
            }
        };
        self.at += used;
        if !self.take(',') {
            self.refuse(format!("`{}` has a table without argument", self.text.text), "write table(name, x)");
            return None;
        }
        let argument = self.sum()?;
        if !self.take(')') {
            self.refuse("`table` lacks a closing bracket", "write table(name, x)");
            return None;
        }
        let Some((curve, [x, y])) = self.scope.table(name) else {
            let span = self.text.span.clone();
            let message = format!("there is no table `{name}`");
            self.scope.mistakes().push("E1706", &span, message, "add it to [tables]");
            return None;
        };
        if let Some(unit) = argument.unit.filter(|unit| *unit != x) {
            self.wrong_unit(format!("table `{name}` is read at a value in {unit}, it needs {x}"));
        }
        Some(Parsed { id: self.scope.pool().table(curve, 0, argument.id), unit: Some(y) })
    }

    fn function(&mut self, name: &str) -> Option<Parsed> {
        if name == "table" {
            return self.table();
        }
        let mut arguments = Vec::new();
        loop {
            arguments.push(if name == "if" && arguments.is_empty() {
                self.condition()?
            } else {
                self.sum()?
            });
            if self.take(')') {
                break;
            }
            if !self.take(',') {
                self.refuse(format!("`{name}` lacks a closing bracket"), "add )");
                return None;
            }
        }
        let needed = match name {
            "if" => 3,
            "min" | "max" | "atan2" | "regroot" => 2,
            _ => 1,
        };
        let plain = Function::ALL.iter().find(|(known, _)| *known == name).map(|(_, function)| *function);
        if plain.is_none() && needed == 1 {
            let known: Vec<&str> = Function::ALL.iter().map(|(name, _)| *name).collect();
            self.refuse(
                format!("`{name}` is no function"),
                format!("there are {}, atan2, min, max, regroot, if, table", known.join(", ")),
            );
            return None;
        }
        if arguments.len() != needed {
            self.refuse(
                format!("`{name}` has {} arguments, it needs {needed}", arguments.len()),
                "arguments stand between commas",
            );
            return None;
        }
        if let Some(function) = plain {
            return Some(self.plain(function, arguments[0]));
        }
        let (a, b) = (arguments[0], arguments[1]);
        Some(match name {
            "if" => {
                let unit = self.same(b.unit, arguments[2].unit, "or");
                Parsed { id: self.scope.pool().choice(a.id, b.id, arguments[2].id), unit }
            }
            "regroot" => {
                self.same(a.unit, b.unit, "beside");
                if let Some(width) =
                    self.scope.pool().value(b.id).filter(|width| width.is_nan() || *width <= 0.0)
                {
                    self.refuse(
                        format!(
                            "`{}` has a root with the width {width}, it must be positive",
                            self.text.text
                        ),
                        "give a width far below the values that matter, for example regroot(e, 1 Pa)",
                    );
                }
                let unit = a.unit.or(b.unit).and_then(|unit| unit.power(0.5));
                Parsed { id: self.scope.pool().regular_root(a.id, b.id), unit }
            }
            "atan2" => {
                self.same(a.unit, b.unit, "beside");
                Parsed { id: self.scope.pool().atan2(a.id, b.id), unit: Some(Unit::NONE) }
            }
            _ => {
                let unit = self.same(a.unit, b.unit, "beside");
                let pool = self.scope.pool();
                let id = if name == "min" { pool.least(a.id, b.id) } else { pool.largest(a.id, b.id) };
                Parsed { id, unit }
            }
        })
    }

    fn plain(&mut self, function: Function, argument: Parsed) -> Parsed {
        let unit = match function {
            Function::Abs => argument.unit,
            Function::Sign => Some(Unit::NONE),
            Function::Sqrt => argument.unit.and_then(|unit| unit.power(0.5)),
            _ => {
                if let Some(unit) = argument.unit.filter(|unit| *unit != Unit::NONE) {
                    self.wrong_unit(format!("{} of {unit} has no meaning", function.name()));
                }
                Some(Unit::NONE)
            }
        };
        Parsed { id: self.scope.pool().call(function, argument.id), unit }
    }

    /// `a > b` or `a < b`, or a value that counts as true where it is positive.
    fn condition(&mut self) -> Option<Parsed> {
        let left = self.sum()?;
        let less = if self.take('>') {
            false
        } else if self.take('<') {
            true
        } else {
            return Some(left);
        };
        self.take('=');
        let right = self.sum()?;
        let unit = self.same(left.unit, right.unit, "beside");
        let pool = self.scope.pool();
        let id = if less { pool.difference(right.id, left.id) } else { pool.difference(left.id, right.id) };
        Some(Parsed { id, unit })
    }
}
