//! A value as sources print it.

/// What a quantity is: a number in SI units (degrees for angles), or Yes and No.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Value {
    Number(f64),
    Word(&'static str),
}

impl Value {
    pub fn number(self) -> Option<f64> {
        match self {
            Value::Number(number) => Some(number),
            Value::Word(_) => None,
        }
    }
}
